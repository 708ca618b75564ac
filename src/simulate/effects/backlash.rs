//! `backlash`: a dead zone between motor and link (M. Nordin and P. O. Gutman, *Controlling
//! mechanical systems with backlash: a survey*, Automatica 38, 2002). The teeth push and never
//! pull.

use dh_codegen::robot::effects;

use super::JointElasticity;

/// A dead zone; the spring of the teeth acts on both sides of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Backlash {
    /// `BL`, the full width, rad.
    pub width: f64,
}

impl Backlash {
    pub(crate) fn new(stated: &effects::Backlash) -> Self {
        Self { width: stated.width() }
    }

    /// Torque on the link, and its derivatives with respect to the angle and velocity of the motor
    /// relative to the link.
    pub fn torque(&self, spring: &JointElasticity, angle: f64, velocity: f64) -> [f64; 3] {
        let half = 0.5 * self.width;
        if angle.abs() <= half {
            return [0.0; 3];
        }
        let pressed = angle - half.copysign(angle);
        let torque = spring.stiffness * pressed + spring.damping * velocity;
        // Damping must not make the teeth pull.
        if torque * pressed <= 0.0 { [0.0; 3] } else { [torque, spring.stiffness, spring.damping] }
    }
}
