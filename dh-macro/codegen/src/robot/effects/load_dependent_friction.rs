//! Effect `load_dependent_friction`: `FL |tau_load| sign(v)`, with `FLB` instead of `FL` if the
//! load drives.

use super::key::{Range, Scope, effect};

effect! {
    /// Friction that grows with the transmitted torque.
    LoadDependentFriction = "load_dependent_friction", Scope::Joint;
    law: "FL |tau_load| sign(v), tau_load the torque of the bodies that the gear transmits; FLB in place of FL where tau_load v < 0";
    source: "the law: Hamon, Gautier and Garrec, IROS 2010. Size: order of magnitude, our choice (a gear of 92 % efficiency)";
    factor = FL [] always 0.08, EFFICIENCY, "friction per transmitted torque";
    driven = FLB [] derived, EFFICIENCY, "the same where the load drives the joint; default: that of FL";
}

impl LoadDependentFriction {
    /// `FLB`, or its default.
    #[must_use]
    pub fn driven(&self) -> f64 {
        self.driven.unwrap_or(self.factor())
    }
}

/// Range of the friction factor. A gear dissipates energy, and locks if it loses as much as it
/// transmits. From data that hardly determine it an identification may give a small negative
/// factor.
const EFFICIENCY: Range =
    Range { with_most: false, identified: -1.0, beyond: "beyond, the gear locks", ..Range::within(0.0, 1.0) };
