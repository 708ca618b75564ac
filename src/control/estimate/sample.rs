//! Input and output of an estimator.

/// Normal deviate of a two-sided 95 % interval.
pub const NINETY_FIVE: f64 = 1.959_963_984_540_054;

/// One sample: measurements and the identified model's values. Torques are those of the actuators
/// on the links, N m, positive in the direction of increasing `q`; `N` joints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EstimatorInput<const N: usize> {
    /// Time since the previous sample, s.
    pub dt: f64,
    /// Measured torques.
    pub tau: [f64; N],
    /// Joint velocities, rad/s.
    pub dq: [f64; N],
    /// The model's torques with the acceleration, `M ddq + c + g + friction`: read only by
    /// [`Residual`](super::Residual).
    pub model: [f64; N],
    /// The model's torques without the acceleration, `c + g + friction`: read by the observers.
    pub bias: [f64; N],
    /// `M(q)`, rotors included: read by the observers.
    pub mass: [[f64; N]; N],
    /// Jacobian of the tool's origin in the tool's axes, linear part first.
    pub jacobian: [[f64; N]; 6],
    /// Covariance of the model's torque due to its parameters' uncertainty, `W C W'`, (N m)^2; zero
    /// where it is unknown.
    pub covariance: [[f64; N]; N],
    /// Standard deviation of each joint's static friction, N m: its level where the joint is at
    /// rest, else 0. Included in the band.
    pub static_friction: [f64; N],
    /// Breakaway level of each joint that is at rest, N m, else 0: a residual that static friction
    /// can explain is not reported as contact.
    pub breakaway: [f64; N],
}

impl<const N: usize> Default for EstimatorInput<N> {
    fn default() -> Self {
        Self {
            dt: 0.0,
            tau: [0.0; N],
            dq: [0.0; N],
            model: [0.0; N],
            bias: [0.0; N],
            mass: [[0.0; N]; N],
            jacobian: [[0.0; N]; 6],
            covariance: [[0.0; N]; N],
            static_friction: [0.0; N],
            breakaway: [0.0; N],
        }
    }
}

/// Estimated wrench that the surroundings exert on the tool: `fx fy fz mx my mz`, N and N m, about
/// the origin of the tool's frame, in its axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// Mean of the wrench.
    pub wrench: [f64; 6],
    /// Covariance of the wrench; in an unobservable direction it is that of [`Scale`].
    pub covariance: [[f64; 6]; 6],
    /// Improbability of the sample without contact: chi-square with `freedom` degrees of freedom,
    /// for the static friction that explains most of it.
    pub surprise: f64,
    /// Surprise without static friction. The range between the two may be friction or contact.
    pub without_friction: f64,
    /// Degrees of freedom of the surprise.
    pub freedom: usize,
    /// Part that no wrench on the tool explains: chi-square with `N - 6` degrees of freedom, with
    /// or without contact. Zero for six joints and fewer.
    pub misfit: f64,
    /// Whether each component is observable. Near a singularity, and with fewer than six joints,
    /// some directions load no joint. There the covariance is that of [`Scale`], a prior, and the
    /// component is unobservable.
    pub observable: [bool; 6],
    /// Whether this sample was used. It is not if a number is not finite, the time does not
    /// increase or the mass matrix is invalid; the wrench is then that of the previous sample.
    pub fresh: bool,
}

impl Estimate {
    /// Estimate before any sample: zero, with the prior's covariance.
    pub fn unknown(scale: &Scale) -> Self {
        let s = scale.each();
        let covariance = core::array::from_fn(|i| core::array::from_fn(|j| if i == j { s[i] * s[i] } else { 0.0 }));
        Self {
            wrench: [0.0; 6],
            covariance,
            surprise: 0.0,
            without_friction: 0.0,
            freedom: 0,
            misfit: 0.0,
            observable: [false; 6],
            fresh: false,
        }
    }

    /// Standard deviation of a component.
    pub fn std(&self, component: usize) -> f64 {
        libm::sqrt(self.covariance[component][component].max(0.0))
    }

    /// Half-width of the interval that contains a component with a probability of 95 %, over runs
    /// (parameters identified each time) and samples.
    pub fn half_width(&self, component: usize) -> f64 {
        NINETY_FIVE * self.std(component)
    }
}

/// Prior size of wrenches, standard deviations: the covariance of unobservable directions and the
/// damping of the pseudo-inverse near singularities. Large compared with the band elsewhere, where
/// it has no effect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// Force, N.
    pub force: f64,
    /// Moment, N m.
    pub moment: f64,
}

impl Default for Scale {
    /// Above the forces and moments that a light-weight arm can exert.
    fn default() -> Self {
        Self { force: 300.0, moment: 100.0 }
    }
}

impl Scale {
    /// Standard deviations of the six components, N and N m.
    pub fn each(&self) -> [f64; 6] {
        let Self { force: f, moment: m } = *self;
        [f, f, f, m, m, m]
    }
}

/// An estimator of the wrench, one sample at a time. Never allocates, never panics, needs no `std`.
pub trait ForceEstimator<const N: usize> {
    /// Processes a sample and returns the estimate.
    fn step(&mut self, sample: &EstimatorInput<N>) -> Estimate;

    /// Discards all samples.
    fn reset(&mut self);
}
