//! `gear_coupling`: motor m turns with `w = dq_m + KC dq_k`, as in the wrists of Staubli arms. Its
//! own terms are in the drive of joint m. The coupling adds `tau_k += KC (IAM ddq_m + FVM dq_m +
//! FCM sign(w))`, `tau_m += IAM KC ddq_k + FVM KC dq_k + FCM sign(w)`.

/// Coupling of a motor with another joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GearCoupling {
    /// Joint of the motor, m: degree of freedom, from 0.
    pub motor: usize,
    /// The other joint, k.
    pub other: usize,
    /// `KC`.
    pub ratio: f64,
    /// `IAM`, kg m^2.
    pub rotor: f64,
    /// `FVM`, N m s/rad.
    pub viscous: f64,
    /// `FCM`, N m.
    pub coulomb: f64,
    /// `CQ`: turns of joint m's link per turn of joint k's motor.
    pub carries: f64,
}

impl GearCoupling {
    /// Torques on k and m, N m, without the Coulomb part.
    pub fn torques(&self, [v_m, v_k]: [f64; 2], [a_m, a_k]: [f64; 2]) -> [f64; 2] {
        let on_k = self.ratio * (self.rotor * a_m + self.viscous * v_m);
        let on_m = self.ratio * (self.rotor * a_k + self.viscous * v_k);
        [on_k, on_m]
    }
}
