//! `stribeck_friction`: `(FS - FC) exp(-|v / VS|^DS) sign(v)`.

use super::Given;

/// Friction that falls from breakaway to Coulomb level.
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
    /// `coulomb`: the joint's `FC`.
    pub(crate) fn read(given: &Given<'_>, coulomb: f64) -> Self {
        Self {
            breakaway: given.stated("FS").unwrap_or(coulomb + 0.01 * given.rated),
            velocity: given.get("VS"),
            exponent: given.get("DS"),
        }
    }

    /// What the level is higher than `coulomb` at this velocity.
    pub fn excess(&self, v: f64, coulomb: f64) -> f64 {
        let ratio = (v / self.velocity).abs();
        let power = if self.exponent == 2.0 { ratio * ratio } else { libm::pow(ratio, self.exponent) };
        (self.breakaway - coulomb) * libm::exp(-power)
    }
}
