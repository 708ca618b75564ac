//! `nonlinear_viscous_friction`: `FN |v|^EN sign(v)`, or `FN v / (|v| + VN)`.

use dh_codegen::robot::effects;

/// Speed, rad/s, below which a power less than 1 is rounded off to keep its slope finite.
const ROUNDED: f64 = 1e-3;

/// Friction as a power of speed, or saturating with speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NonlinearViscousFriction {
    /// `FN`, N m at 1 rad/s.
    pub level: f64,
    /// `EN`.
    pub exponent: f64,
    /// `VN`, rad/s, speed of half the level; 0: a power.
    pub half: f64,
}

impl NonlinearViscousFriction {
    /// One law per term.
    pub(crate) fn all(stated: &effects::NonlinearViscousFriction, rated: f64) -> Vec<Self> {
        let of = |[level, exponent, half]: [f64; 3]| Self { level, exponent, half };
        stated.terms(rated).into_iter().map(of).collect()
    }

    /// Torque divided by velocity: the law is this times `v`.
    pub fn slope(&self, v: f64) -> f64 {
        if self.half > 0.0 {
            return self.level / (v.abs() + self.half);
        }
        self.level * libm::pow(v * v + ROUNDED * ROUNDED, 0.5 * (self.exponent - 1.0))
    }

    /// Derivative of the law with respect to `v`.
    pub fn derivative(&self, v: f64) -> f64 {
        if self.half > 0.0 {
            return self.level * self.half / (v.abs() + self.half).powi(2);
        }
        let square = v * v + ROUNDED * ROUNDED;
        self.slope(v) * (self.exponent * v * v + ROUNDED * ROUNDED) / square
    }
}
