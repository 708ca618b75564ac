//! Products with transposed Jacobians of an arm's quantities.

use super::arm::{Arm, States};

pub use dh_codegen::pullback::Gradient;

/// An [`Arm`] whose quantities can be differentiated, by products with the transposed Jacobian
/// ("vector-Jacobian products"). `seeds` has one weight per entry and sample, laid out like the
/// quantity itself, and `d(sum of seeds * entries)` by `q`, `dq` and `ddq` of each sample is
/// *added* to a [`Gradient`] whose parts have `dof * len` entries.
pub trait Differentiable: Arm {
    /// Of [`Arm::base_regressor`]; seed of entry `k` of the pattern at sample `s` at `k * len + s`.
    /// A sign has derivative zero.
    fn base_regressor_vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient);

    /// Entries of the base pattern that are the sign of a joint's velocity and nothing else
    /// (Coulomb friction), and the joint.
    fn coulomb_entries(&self) -> &[(usize, usize)];

    /// Rows and columns of the structural nonzeros of [`Differentiable::payload_regressor`].
    fn payload_pattern(&self) -> &[(usize, usize)];

    /// Ten columns `M MSX .. YZ` of a body in the tool frame, `n x 10`, laid out like the base
    /// regressor.
    fn payload_regressor(&self, states: &States, out: &mut [f64]);

    /// Of [`Differentiable::payload_regressor`].
    fn payload_regressor_vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient);

    /// Of [`Arm::inverse_dynamics`].
    fn inverse_dynamics_vjp(&self, states: &States, standard: &[f64], seeds: &[f64], to: &mut Gradient);

    /// Number of frames: the rows of the DH table and, where there is a tool, its frame.
    fn frame_count(&self) -> usize;

    /// Top three rows of each frame's homogeneous matrix in the world frame, lengths in m: entry
    /// `(frame, row, column)` at `((frame * 3 + row) * 4 + column) * len + s`.
    fn frames(&self, states: &States, out: &mut [f64]);

    /// Of [`Differentiable::frames`].
    fn frames_vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient);
}
