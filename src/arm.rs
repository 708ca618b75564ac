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

/// An arm that can tell what a body in its hand adds to the torques.
pub trait Payload: Arm {
    /// Rows and columns of the structural nonzeros of the payload regressor, sorted by row, then column. Columns are the body's ten
    /// parameters `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin; in the last DH frame where the robot has
    /// no tool.
    fn payload_pattern(&self) -> &[(usize, usize)];

    /// The payload regressor at every sample: entry `k` of [`Payload::payload_pattern`] at sample `s` goes to `out[k * len + s]`.
    /// A body adds `W_L Phi_L` to the torques (the paper's equation 7).
    fn payload_regressor(&self, states: &States, out: &mut [f64]);
}
