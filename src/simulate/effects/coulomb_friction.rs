//! `coulomb_friction`: `FC sign(v)`; also the viscous term and the offset that accompany it in a
//! drive.

/// Friction common to all drives.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct CoulombFriction {
    /// `FC`, N m.
    pub level: f64,
    /// `FV`, N m s/rad (`viscous_friction`).
    pub viscous: f64,
    /// `FO`, N m: offset of the torque, the same at any speed.
    pub offset: f64,
}
