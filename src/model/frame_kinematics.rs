//! Frames and Jacobians in batches, for motion planning in space.

use super::arm::{Arm, States};

/// An arm with frames and Jacobian in batches, as planning a motion in space needs them.
pub trait FrameKinematics: Arm {
    /// Number of frames: the rows of the DH table and, if there is a tool, its frame.
    fn frame_count(&self) -> usize;

    /// Top three rows of each frame's homogeneous matrix in the world frame, lengths in m: entry
    /// `(frame, row, column)` at `((frame * 3 + row) * 4 + column) * len + s`.
    fn frames(&self, states: &States, out: &mut [f64]);

    /// Jacobian of the last DH frame's origin in world axes, linear part first: entry `(row,
    /// joint)` at `(row * n + joint) * len + s`.
    fn jacobian(&self, states: &States, out: &mut [f64]);
}
