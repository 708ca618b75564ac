//! `load_dependent_friction`: `FL |tau_load| sign(v)`, `tau_load` the torque of the bodies that the
//! gear transmits.

use dh_codegen::robot::effects;

/// Friction in proportion to the transmitted torque.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadDependentFriction {
    /// `FL`.
    pub factor: f64,
}

impl LoadDependentFriction {
    pub(crate) fn new(stated: &effects::LoadDependentFriction) -> Self {
        Self { factor: stated.factor() }
    }

    /// The level at this load, N m.
    pub fn level(&self, load: f64) -> f64 {
        self.factor * load.abs()
    }
}
