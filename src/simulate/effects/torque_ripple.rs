//! `torque_ripple`: `RC cos(RN q) + RS sin(RN q)`, and further terms whose keys end in 2, 3, ...

use dh_codegen::robot::effects;

/// Torque periodic in the motor's angle.
#[derive(Debug, Clone, PartialEq)]
pub struct TorqueRipple {
    /// Periods per joint turn, cosine and sine amplitude, N m.
    pub terms: Vec<[f64; 3]>,
}

impl TorqueRipple {
    pub(crate) fn new(stated: &effects::TorqueRipple, rated: f64, gear_ratio: Option<f64>) -> Self {
        Self { terms: stated.waves(rated, gear_ratio) }
    }

    /// Torque at this angle, N m.
    pub fn torque(&self, q: f64) -> f64 {
        self.terms.iter().map(|[n, c, s]| c * libm::cos(n * q) + s * libm::sin(n * q)).sum()
    }

    /// Derivative of the torque with respect to the angle, N m/rad.
    pub fn slope(&self, q: f64) -> f64 {
        self.terms.iter().map(|[n, c, s]| n * (s * libm::cos(n * q) - c * libm::sin(n * q))).sum()
    }
}
