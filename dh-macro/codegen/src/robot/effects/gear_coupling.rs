//! Effect `gear_coupling`: motor m turns with `w = dq_m + KC dq_k`, as in the wrists of Staubli
//! arms; or link m is at `q_m + CQ q_k`.

use super::key::{Range, Scope, effect};

effect! {
    /// A motor that turns with another joint's axis.
    GearCoupling = "gear_coupling", Scope::Joint;
    law: "motor m turns with w = dq_m + KC dq_k: on k KC (IAM ddq_m + FVM dq_m + FCM sign(w)), on m IAM KC ddq_k + FVM KC dq_k + FCM sign(w); with CQ, the link m stands at q_m + CQ q_k, and motor k bears CQ times its torque";
    source: "the wrist of the Staubli TX40 (figaroh): IAM 0.0077, FVM 0.62, FCM 1.96 at 30 N m";
    joint = JOINT as "joint" [] joint, Range::ANY, "the other joint, k; m is the one that this stands at";
    ratio = KC [] always 1.0, Range::within(-1e3, 1e3), "turns of the motor, on the joint's side, per turn of joint k";
    carried = CQ [] always 0.0, Range::within(-1e3, 1e3), "turns of the link m per turn of the motor of joint k";
    rotor = IAM ["kg m^2"] derived_alone, Range::ANY, "rotor; default: half of what leaves the mass matrix positive definite along the motion";
    viscous = FVM ["N m s/rad"] derived_alone, Range::ANY, "viscous; default: half the geometric mean of the two joints' FV";
    coulomb = FCM ["N m"] by_hand 0.01 * torque, Range::ANY, "Coulomb";
}

impl GearCoupling {
    /// Whether the size of the motor is stated: its rotor or its friction.
    #[must_use]
    pub fn has_motor(&self) -> bool {
        [self.rotor, self.viscous, self.coulomb].iter().any(Option::is_some)
    }

    /// Whether any size is stated; if none is, rotor and friction have their defaults.
    #[must_use]
    pub fn has_sizes(&self) -> bool {
        self.has_motor() || self.carried.is_some()
    }

    /// `FVM`, or its default for joints with these viscous coefficients, N m s/rad.
    #[must_use]
    pub fn viscous(&self, joints: [f64; 2]) -> f64 {
        let [m, k] = joints;
        self.viscous.unwrap_or(if self.has_sizes() { 0.0 } else { 0.5 * (m * k).max(0.0).sqrt() })
    }

    /// `FCM`, or its default at a joint with this torque limit, N m.
    #[must_use]
    pub fn coulomb(&self, rated: f64) -> f64 {
        self.coulomb.unwrap_or(if self.has_sizes() { 0.0 } else { 0.01 * rated })
    }
}
