//! `load_dependent_friction`: `FL |tau_load| sign(v)`, with `tau_load` the torque that the gear
//! transmits to the bodies. `FLB` replaces `FL` where the load drives the motor.

use dh_codegen::robot::effects;

/// Friction proportional to the transmitted torque.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadDependentFriction {
    /// `FL`.
    pub factor: f64,
    /// `FLB`.
    pub driven: f64,
}

impl LoadDependentFriction {
    pub(crate) fn new(stated: &effects::LoadDependentFriction) -> Self {
        Self { factor: stated.factor(), driven: stated.driven() }
    }

    /// Coulomb level at this load (N m) and motor velocity, N m.
    pub fn level(&self, load: f64, v: f64) -> f64 {
        load.abs() * if load * v < 0.0 { self.driven } else { self.factor }
    }
}
