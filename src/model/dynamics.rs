//! The bodies of an arm, one state at a time: the requirements of a simulation.

/// The tool frame of an arm at one position.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ToolState {
    /// Top three rows of its homogeneous matrix in world axes, row-major.
    pub pose: [f64; 12],
    /// Jacobian of its origin in world axes, linear part first, `6 x n`, row-major.
    pub jacobian: Vec<f64>,
}

/// The bodies of an arm with given inertial parameters, one state at a time: what a simulation
/// needs. No drives: neither rotors nor friction.
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
