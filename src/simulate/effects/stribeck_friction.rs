//! `stribeck_friction`: `(FS - FC) exp(-|v / VS|^DS) sign(v)`.

use dh_codegen::robot::effects;

/// Friction that falls from the breakaway to the Coulomb level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StribeckFriction {
    /// `FS`, N m, breakaway level.
    pub breakaway: f64,
    /// `VS`, rad/s.
    pub velocity: f64,
    /// `DS`.
    pub exponent: f64,
}

impl StribeckFriction {
    /// `rated`: the joint's torque limit, N m; `coulomb`: its `FC`, N m.
    pub(crate) fn new(stated: &effects::StribeckFriction, rated: f64, coulomb: f64) -> Self {
        Self {
            breakaway: stated.breakaway.unwrap_or(coulomb + effects::StribeckFriction::EXCESS * rated),
            velocity: stated.velocity(),
            exponent: stated.exponent(),
        }
    }

    /// Increase of the level over `coulomb` at this velocity, N m.
    pub fn excess(&self, v: f64, coulomb: f64) -> f64 {
        let ratio = (v / self.velocity).abs();
        let power = if self.exponent == 2.0 { ratio * ratio } else { libm::pow(ratio, self.exponent) };
        (self.breakaway - coulomb) * libm::exp(-power)
    }
}
