//! `position_dependent_friction`: `sign(v) (PC cos(PN q) + PS sin(PN q))`.

use dh_codegen::robot::effects;

/// Friction that varies along the joint's travel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PositionDependentFriction {
    /// `PC`, `PS`, N m.
    pub amplitude: [f64; 2],
    /// `PN`, periods per turn.
    pub periods: f64,
}

impl PositionDependentFriction {
    pub(crate) fn new(stated: &effects::PositionDependentFriction, rated: f64) -> Self {
        Self { amplitude: [stated.cosine(rated), stated.sine(rated)], periods: stated.periods() }
    }

    /// Increase of the Coulomb level at this angle, N m.
    pub fn excess(&self, q: f64) -> f64 {
        let [cosine, sine] = self.amplitude;
        cosine * libm::cos(self.periods * q) + sine * libm::sin(self.periods * q)
    }
}
