//! Vector-Jacobian products of an arm's quantities.

use super::arm::{Arm, States};

pub use dh_codegen::pullback::Gradient;

/// An [`Arm`] whose quantities are differentiable by vector-Jacobian products. `seeds` has one
/// weight per entry and sample, laid out like the quantity itself. The derivative of `sum of seeds
/// * entries` by `q`, `dq` and `ddq` of each sample is *added* to a [`Gradient`] whose parts have
/// `dof * len` entries.
pub trait Differentiable: Arm {
    /// Product for [`Arm::base_regressor`]; the seed of entry `k` of the pattern at sample `s` is
    /// at `k * len + s`. A sign has derivative zero.
    fn base_regressor_vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient);

    /// Entries of the base pattern that are just the sign of a joint's velocity (Coulomb friction),
    /// with the joint.
    fn coulomb_entries(&self) -> &[(usize, usize)];

    /// Rows and columns of the structural nonzeros of [`Differentiable::payload_regressor`].
    fn payload_pattern(&self) -> &[(usize, usize)];

    /// Regressor of a body in the tool frame, ten columns `M MSX .. YZ`, `n x 10`, laid out like
    /// the base regressor.
    fn payload_regressor(&self, states: &States, out: &mut [f64]);

    /// Product for [`Differentiable::payload_regressor`].
    fn payload_regressor_vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient);

    /// Product for [`Arm::inverse_dynamics`].
    fn inverse_dynamics_vjp(&self, states: &States, standard: &[f64], seeds: &[f64], to: &mut Gradient);

    /// Number of frames: the rows of the DH table and, if there is a tool, its frame.
    fn frame_count(&self) -> usize;

    /// Top three rows of each frame's homogeneous matrix in the world frame, lengths in m: entry
    /// `(frame, row, column)` at `((frame * 3 + row) * 4 + column) * len + s`.
    fn frames(&self, states: &States, out: &mut [f64]);

    /// Product for [`Differentiable::frames`].
    fn frames_vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient);
}
