//! Effect `encoder_offset`: the true angle is the measured one plus `QO`.

use super::key::{Range, Scope, effect};

effect! {
    /// A joint's zero is wrong.
    EncoderOffset = "encoder_offset", Scope::EveryJoint;
    law: "true angle = measured + QO";
    source: "our choice: a degree, as after a homing by eye";
    offset = QO ["rad"] always 0.02, TURN, "offset";
}

/// Range of one turn either way, rad: a counter may be off by one.
const TURN: Range = Range::within(-core::f64::consts::TAU, core::f64::consts::TAU);
