//! `coulomb_friction`: `FC sign(v)`; also the plain viscous term and the offset that stand beside
//! it in a drive.

/// Friction that every drive may have.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct CoulombFriction {
    /// `FC`, N m.
    pub level: f64,
    /// `FV`, N m s/rad (`viscous_friction`).
    pub viscous: f64,
    /// `FO`, N m: torque that is needed at any speed.
    pub offset: f64,
}
