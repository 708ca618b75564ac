//! `joint_elasticity`: motor and link are two inertias joined by a spring (M. W. Spong, *Modeling
//! and control of elastic joint robots*, J. Dyn. Sys. Meas. Control 109, 1987). Friction, rotor and
//! ripple act on the motor.

use dh_codegen::robot::effects;

/// The spring between motor and link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointElasticity {
    /// `KE`, N m/rad.
    pub stiffness: f64,
    /// `DE`, N m s/rad.
    pub damping: f64,
}

impl JointElasticity {
    pub(crate) fn new(stated: &effects::JointElasticity, rated: f64) -> Self {
        Self { stiffness: stated.stiffness(rated), damping: stated.damping() }
    }

    /// Contact stiffness of a gear with backlash for which the file gives no elasticity. It is ten
    /// times as stiff as a joint by default, with a tenth of critical damping against a rotor of
    /// `inertia` kg m^2.
    pub(crate) fn of_teeth(rated: f64, inertia: f64) -> Self {
        let stiffness = 600.0 * rated;
        Self { stiffness, damping: 0.2 * (stiffness * inertia).sqrt() }
    }
}
