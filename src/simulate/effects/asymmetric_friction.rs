//! `asymmetric_friction`: `FCA |sign(v)| + FVA |v|`. The Coulomb level is `FC + FCA` forward and
//! `FC - FCA` backward.

use dh_codegen::robot::effects;

/// Friction that depends on the direction of motion.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct AsymmetricFriction {
    /// `FCA`, N m.
    pub level: f64,
    /// `FVA`, N m s/rad.
    pub viscous: f64,
}

impl AsymmetricFriction {
    pub(crate) fn new(stated: &effects::AsymmetricFriction, rated: f64) -> Self {
        Self { level: stated.level(rated), viscous: stated.viscous(rated) }
    }

    /// Torque at velocity `v`, N m; `s` replaces its sign, in `[-1, 1]`.
    pub fn torque(&self, v: f64, s: f64) -> f64 {
        self.level * s.abs() + self.viscous * v.abs()
    }
}
