//! `joint_spring`: `KS (q - QS)`, on the link.

use dh_codegen::robot::effects;

/// A spring between a link and the one before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointSpring {
    /// `KS`, N m/rad.
    pub stiffness: f64,
    /// `QS`, rad.
    pub rest: f64,
}

impl JointSpring {
    pub(crate) fn new(stated: &effects::JointSpring, rated: f64) -> Self {
        Self { stiffness: stated.stiffness(rated), rest: stated.rest() }
    }

    /// Torque that holds it at this angle.
    pub fn torque(&self, q: f64) -> f64 {
        self.stiffness * (q - self.rest)
    }
}
