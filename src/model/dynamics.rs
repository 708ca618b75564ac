//! Dynamics of an arm's bodies, one state at a time, as a simulation needs them.

/// The tool frame of an arm at one position.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ToolState {
    /// Top three rows of its homogeneous matrix in world axes, row-major.
    pub pose: [f64; 12],
    /// Jacobian of its origin in world axes, linear part first, `6 x n`, row-major.
    pub jacobian: Vec<f64>,
}

/// Dynamics of an arm's bodies with given inertial parameters, one state at a time. Without drives:
/// neither rotors nor friction.
pub trait Dynamics {
    /// Degrees of freedom, `n`.
    fn dof(&self) -> usize;

    /// `M(q)`, `n x n`, row-major.
    fn mass_matrix(&mut self, q: &[f64], mass: &mut [f64]);

    /// `c(q, dq) + g(q)`, `n`.
    fn bias(&mut self, q: &[f64], dq: &[f64], bias: &mut [f64]);

    /// Frame and Jacobian of the tool, or of the last frame without a tool.
    fn tool(&mut self, q: &[f64], tool: &mut ToolState);
}
