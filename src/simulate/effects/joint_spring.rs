//! `joint_spring`: `KS (q - QS) + KQ (q - QS)^3`, on the link; a cable is taut on one side of `QS`
//! only.

use dh_codegen::robot::effects;

/// A spring between a link and its predecessor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointSpring {
    /// `KS`, N m/rad.
    pub stiffness: f64,
    /// `QS`, rest angle, rad.
    pub rest: f64,
    /// `KQ`, N m/rad^3.
    pub hardening: f64,
    /// `SIDE`: sign of the stretch at which it is taut; 0: both.
    pub side: f64,
}

impl JointSpring {
    pub(crate) fn new(stated: &effects::JointSpring, rated: f64) -> Self {
        let (stiffness, rest) = (stated.stiffness(rated), stated.rest());
        Self { stiffness, rest, hardening: stated.cubic(), side: stated.side() }
    }

    /// Stretch, rad; 0 where a cable is slack.
    fn stretch(&self, q: f64) -> f64 {
        let x = q - self.rest;
        if self.side * x < 0.0 { 0.0 } else { x }
    }

    /// Torque that holds the joint at this angle, N m.
    pub fn torque(&self, q: f64) -> f64 {
        let x = self.stretch(q);
        self.stiffness * x + self.hardening * x.powi(3)
    }

    /// Derivative of the torque with respect to the angle, N m/rad.
    pub fn slope(&self, q: f64) -> f64 {
        match self.stretch(q) {
            0.0 if self.side != 0.0 => 0.0,
            x => self.stiffness + 3.0 * self.hardening * x * x,
        }
    }
}
