//! `joint_spring`: `KS (q - QS)`, on the link.

use super::Given;

/// A spring between a link and the one before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointSpring {
    /// `KS`, N m/rad.
    pub stiffness: f64,
    /// `QS`, rad.
    pub rest: f64,
}

impl JointSpring {
    pub(crate) fn read(given: &Given<'_>) -> Self {
        Self { stiffness: given.get("KS"), rest: given.get("QS") }
    }

    /// Torque that holds it at this angle.
    pub fn torque(&self, q: f64) -> f64 {
        self.stiffness * (q - self.rest)
    }
}
