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

/// The tool frame of an arm at one position.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ToolState {
    /// Top three rows of its homogeneous matrix in base axes, row-major.
    pub pose: [f64; 12],
    /// Jacobian of its origin in base axes, linear part first, `6 x n`, row-major.
    pub jacobian: Vec<f64>,
}

/// The bodies of an arm with given inertial parameters, one state at a time: what a simulation needs. No drives: neither rotors nor
/// friction.
pub trait Dynamics {
    /// Degrees of freedom, `n`.
    fn dof(&self) -> usize;

    /// `M(q)`, `n x n`, row-major.
    fn mass_matrix(&mut self, q: &[f64], mass: &mut [f64]);

    /// `c(q, dq) + g(q)`, `n`.
    fn bias(&mut self, q: &[f64], dq: &[f64], bias: &mut [f64]);

    /// Frame and Jacobian of the tool, of the last frame where there is none.
    fn tool(&mut self, q: &[f64], tool: &mut ToolState);
}
