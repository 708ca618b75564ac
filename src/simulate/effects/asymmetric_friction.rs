//! `asymmetric_friction`: `FCA |sign(v)| + FVA |v|`: forward the levels are `FC + FCA`, backward
//! `FC - FCA`.

use dh_codegen::robot::effects;

/// Friction that differs with direction.
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

    /// Torque at velocity `v`; `s` stands for its sign, in `[-1, 1]`.
    pub fn torque(&self, v: f64, s: f64) -> f64 {
        self.level * s.abs() + self.viscous * v.abs()
    }
}
