//! Regressor of a body in the hand.

use super::arm::{Arm, States};

/// An arm that computes the torques of a body in its hand.
pub trait Payload: Arm {
    /// Rows and columns of the structural nonzeros of the payload regressor, sorted by row, then
    /// column. Columns are the body's ten parameters `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool
    /// frame, about its origin. Without a tool the frame is the last DH frame.
    fn payload_pattern(&self) -> &[(usize, usize)];

    /// The payload regressor at every sample: entry `k` of [`Payload::payload_pattern`] at sample
    /// `s` goes to `out[k * len + s]`. A body adds `W_L Phi_L` to the torques (the paper's equation
    /// 7).
    fn payload_regressor(&self, states: &States, out: &mut [f64]);
}
