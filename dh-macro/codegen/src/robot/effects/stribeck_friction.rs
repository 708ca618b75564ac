//! Effect `stribeck_friction`: `(FS - FC) exp(-|v / VS|^DS) sign(v)`.

use super::key::{Range, Scope, effect};

effect! {
    /// Friction that falls from the breakaway to the Coulomb level as speed rises.
    StribeckFriction = "stribeck_friction", Scope::Joint;
    law: "(FS - FC) exp(-|v / VS|^DS) sign(v), FC the joint's Coulomb level";
    source: "the law: Armstrong-Helouvry, Dupont and Canudas de Wit, Automatica 30 (1994). Size and velocity: order of magnitude, our choice";
    breakaway = FS ["N m"] derived, Range::SIZE, "breakaway level; default: the Coulomb level and 1 % of the torque limit";
    velocity = VS ["rad/s"] always 0.05, Range::POSITIVE, "Stribeck velocity";
    exponent = DS [] always 2.0, Range::above(0.0, 20.0), "exponent";
}

impl StribeckFriction {
    /// Default excess of the breakaway level over the Coulomb level, as a share of the torque
    /// limit.
    pub const EXCESS: f64 = 0.01;
}
