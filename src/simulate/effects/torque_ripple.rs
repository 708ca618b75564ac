//! `torque_ripple`: `RC cos(RN q) + RS sin(RN q)`, and more of the kind with 2, 3, ... behind the
//! keys.

use super::Given;

/// Orders of a ripple where the robot file has no gear ratio: a compact planetary or a pole count.
const ORDER: f64 = 32.0;

/// Torque that is periodic in the motor's angle.
#[derive(Debug, Clone, PartialEq)]
pub struct TorqueRipple {
    /// Periods per joint turn, cosine and sine amplitude, N m.
    pub terms: Vec<[f64; 3]>,
}

impl TorqueRipple {
    pub(crate) fn read(given: &Given<'_>, gear_ratio: Option<f64>) -> Self {
        let order = given.stated("RN").unwrap_or(gear_ratio.map_or(ORDER, f64::abs));
        let mut terms = vec![[order, given.get("RC"), given.get("RS")]];
        for k in 2..=9 {
            let [n, c, s] = ["RN", "RC", "RS"].map(|key| given.stated(&format!("{key}{k}")));
            if c.is_some() || s.is_some() {
                terms.push([n.unwrap_or(f64::from(k) * order), c.unwrap_or(0.0), s.unwrap_or(0.0)]);
            }
        }
        Self { terms }
    }

    /// Torque at this angle, N m.
    pub fn torque(&self, q: f64) -> f64 {
        self.terms.iter().map(|[n, c, s]| c * libm::cos(n * q) + s * libm::sin(n * q)).sum()
    }

    /// Its derivative by the angle.
    pub fn slope(&self, q: f64) -> f64 {
        self.terms.iter().map(|[n, c, s]| n * (s * libm::cos(n * q) - c * libm::sin(n * q))).sum()
    }
}
