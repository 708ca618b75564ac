//! `friction_drift`: friction times `1 + DA exp(-t / DT) + DK (temp - T0)`; the gear warms with the
//! same time constant.

use dh_codegen::robot::effects;

/// Temperature rise of a gear in operation, K.
const WARMING: f64 = 15.0;

/// Warm-up of the friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionDrift {
    /// `DA`.
    pub cold: f64,
    /// `DT`, s.
    pub time: f64,
    /// `DK`, 1/K.
    pub per_kelvin: f64,
    /// `T0`, degrees C.
    pub reference: f64,
}

impl FrictionDrift {
    pub(crate) fn new(stated: &effects::FrictionDrift) -> Self {
        Self {
            cold: stated.cold(),
            time: stated.time(),
            per_kelvin: stated.per_kelvin(),
            reference: stated.reference(),
        }
    }

    /// Factor of the joint's friction, `t` s after the start.
    pub fn factor(&self, t: f64) -> f64 {
        let rest = self.per_kelvin * (self.temperature(t) - self.reference);
        (1.0 + self.cold * libm::exp(-t / self.time) + rest).max(0.0)
    }

    /// Temperature, degrees C, `t` s after the start.
    pub fn temperature(&self, t: f64) -> f64 {
        self.reference + WARMING * (1.0 - libm::exp(-t / self.time))
    }
}
