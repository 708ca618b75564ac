//! Input and output of an estimator.

/// Normal deviate of a two-sided 95 % interval.
pub const NINETY_FIVE: f64 = 1.959_963_984_540_054;

/// One sample: what was measured, and what the identified model says of it. Torques are those of
/// the actuators on the links, N m, positive in the direction in which `q` grows; `N` joints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EstimatorInput<const N: usize> {
    /// Time since the sample before, s.
    pub dt: f64,
    /// Measured torques.
    pub tau: [f64; N],
    /// Joint velocities, rad/s.
    pub dq: [f64; N],
    /// The model's torques with the acceleration, `M ddq + c + g + friction`: read by
    /// [`Residual`](super::Residual) alone.
    pub model: [f64; N],
    /// The model's torques without it, `c + g + friction`: read by the observers.
    pub bias: [f64; N],
    /// `M(q)`, rotors included: read by the observers.
    pub mass: [[f64; N]; N],
    /// Jacobian of the tool's origin in the tool's axes, linear part first.
    pub jacobian: [[f64; N]; 6],
    /// Covariance of the model's torque as its parameters are uncertain, `W C W'`, (N m)^2; zero
    /// where nothing is known of it.
    pub covariance: [[f64; N]; N],
    /// Standard deviation of each joint's static friction, N m: its level where the joint is at
    /// rest, else 0. In the band.
    pub static_friction: [f64; N],
    /// Breakaway level of each joint that is at rest, N m, else 0: what static friction may hold is
    /// not called a contact.
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

/// The wrench that the surroundings exert on the tool, as estimated. It is `fx fy fz mx my mz`, N
/// and N m, about the origin of the tool's frame, in its axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// Mean.
    pub wrench: [f64; 6],
    /// Its covariance; in an unobservable direction it is that of [`Scale`].
    pub covariance: [[f64; 6]; 6],
    /// How improbable the sample is where nothing touches: chi-square with `freedom` degrees of
    /// freedom, for the static friction that explains most of it.
    pub surprise: f64,
    /// The same if static friction held nothing. What lies between the two may be friction or
    /// contact.
    pub without_friction: f64,
    /// Degrees of freedom of the surprise.
    pub freedom: usize,
    /// Part that no wrench on the tool explains: chi-square with `N - 6` degrees of freedom, touch
    /// or no touch. Zero for six joints and fewer.
    pub misfit: f64,
    /// Whether each component is observable. Near a singularity, and with fewer than six joints,
    /// some directions push no joint. There the covariance is that of [`Scale`], a prior, and the
    /// component is unobservable.
    pub observable: [bool; 6],
    /// Whether this sample was used. If not (a number that is not finite, a time that does not run,
    /// a mass matrix that is none) the wrench is that of the sample before.
    pub fresh: bool,
}

impl Estimate {
    /// Before any sample.
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

    /// Half of the interval that holds a component with a probability of 95 %: over runs
    /// (parameters identified again) and samples.
    pub fn half_width(&self, component: usize) -> f64 {
        NINETY_FIVE * self.std(component)
    }
}

/// Prior size of wrenches, standard deviations: the covariance of unobservable directions, and the
/// damping of the pseudo-inverse near singularities. Large against the band elsewhere, so that it
/// does nothing there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// N
    pub force: f64,
    /// N m
    pub moment: f64,
}

impl Default for Scale {
    /// More than what a light-weight arm can press with.
    fn default() -> Self {
        Self { force: 300.0, moment: 100.0 }
    }
}

impl Scale {
    /// Of the six components.
    pub fn each(&self) -> [f64; 6] {
        let Self { force: f, moment: m } = *self;
        [f, f, f, m, m, m]
    }
}

/// A way to a wrench, one sample at a time. Never allocates, never panics, needs no `std`.
pub trait ForceEstimator<const N: usize> {
    /// Takes in a sample.
    fn step(&mut self, sample: &EstimatorInput<N>) -> Estimate;

    /// Discards all samples.
    fn reset(&mut self);
}
