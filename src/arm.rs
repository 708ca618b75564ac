//! What the rooms that work on data see of a robot: a trait, never a file.

/// Joint motion of a block of samples, joint-major: sample `s` of joint `j` stands at `j * len + s`.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct States {
    /// Number of samples.
    pub len: usize,
    /// Positions, rad or m, `dof * len`.
    pub q: Vec<f64>,
    /// Velocities, rad/s or m/s, `dof * len`.
    pub dq: Vec<f64>,
    /// Accelerations, rad/s^2 or m/s^2, `dof * len`.
    pub ddq: Vec<f64>,
}

/// A base parameter: an identifiable combination of standard parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct BaseParameter {
    /// Name of its leader, with `R` where it groups others: `ZZ1R`, `MSY7`, `FC3`.
    pub name: String,
    /// `ZZ1R = ZZ1 + YY2 + ...`, in the constants of the robot file.
    pub grouping: String,
    /// Index into the standard parameters, and factor.
    pub coefficients: Vec<(usize, f64)>,
    /// Unit.
    pub unit: String,
}

/// An arm with `n` degrees of freedom, `P` standard and `B` base parameters.
///
/// Torques are those of the actuators on the links, N m (N for a prismatic joint), positive in the direction in which `q` grows.
pub trait Arm: Sync {
    /// The robot's name.
    fn name(&self) -> &str;

    /// Degrees of freedom, `n`.
    fn dof(&self) -> usize;

    /// Names of the standard parameters, `P`, in the order of contract section 2.
    fn standard_names(&self) -> &[String];

    /// The base parameters, `B`, in the order of the base regressor's columns.
    fn base_parameters(&self) -> &[BaseParameter];

    /// Rows and columns of the base regressor's structural nonzeros, sorted by row, then column.
    fn base_pattern(&self) -> &[(usize, usize)];

    /// The base regressor at every sample: entry `k` of [`Arm::base_pattern`] at sample `s` goes to `out[k * len + s]`.
    /// `tau = W_b beta` (Khalil and Dombre, equation 12.21).
    fn base_regressor(&self, states: &States, out: &mut [f64]);

    /// Torques from standard parameters (`P`), joint-major like the states.
    fn inverse_dynamics(&self, states: &States, standard: &[f64], out: &mut [f64]);
}

pub use dh_codegen::pullback::Gradient;

/// An [`Arm`] whose quantities can be differentiated, by products with the transposed Jacobian ("vector-Jacobian products"):
/// `seeds` has one weight per entry and sample, laid out like the quantity itself, and `d(sum of seeds * entries)` by `q`, `dq` and
/// `ddq` of each sample is *added* to a [`Gradient`] whose parts have `dof * len` entries.
pub trait Differentiable: Arm {
    /// Of [`Arm::base_regressor`]; seed of entry `k` of the pattern at sample `s` at `k * len + s`. A sign has derivative zero.
    fn base_regressor_vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient);

    /// Entries of the base pattern that are the sign of a joint's velocity and nothing else (Coulomb friction), and the joint.
    fn coulomb_entries(&self) -> &[(usize, usize)];

    /// Rows and columns of the structural nonzeros of [`Differentiable::payload_regressor`].
    fn payload_pattern(&self) -> &[(usize, usize)];

    /// Ten columns `M MSX .. YZ` of a body in the tool frame, `n x 10`, laid out like the base regressor.
    fn payload_regressor(&self, states: &States, out: &mut [f64]);

    /// Of [`Differentiable::payload_regressor`].
    fn payload_regressor_vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient);

    /// Of [`Arm::inverse_dynamics`].
    fn inverse_dynamics_vjp(&self, states: &States, standard: &[f64], seeds: &[f64], to: &mut Gradient);

    /// Number of frames: the rows of the DH table and, where there is a tool, its frame.
    fn frame_count(&self) -> usize;

    /// Top three rows of each frame's homogeneous matrix in the base frame, lengths in m: entry `(frame, row, column)` at
    /// `((frame * 3 + row) * 4 + column) * len + s`.
    fn frames(&self, states: &States, out: &mut [f64]);

    /// Of [`Differentiable::frames`].
    fn frames_vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient);
}
