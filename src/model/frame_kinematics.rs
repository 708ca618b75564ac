//! Frames and Jacobians in batches: the requirements of planning in space.

use super::arm::{Arm, States};

/// An arm whose frames and Jacobian are asked for in batches: what it takes to plan a motion in
/// space.
pub trait FrameKinematics: Arm {
    /// Number of frames: the rows of the DH table and, where there is a tool, its frame.
    fn frame_count(&self) -> usize;

    /// Top three rows of each frame's homogeneous matrix in the world frame, lengths in m: entry
    /// `(frame, row, column)` at `((frame * 3 + row) * 4 + column) * len + s`.
    fn frames(&self, states: &States, out: &mut [f64]);

    /// Jacobian of the last DH frame's origin in world axes, linear part first: entry `(row,
    /// joint)` at `(row * n + joint) * len + s`.
    fn jacobian(&self, states: &States, out: &mut [f64]);
}
