//! `encoder_offset`: true angle is the measured one and `QO`.

use super::key::{Range, Scope, effect};

effect! {
    /// A joint's zero is wrong.
    EncoderOffset = "encoder_offset", Scope::EveryJoint;
    law: "true angle = measured + QO";
    source: "our choice: a degree, as after a homing by eye";
    offset = QO ["rad"] always 0.02, TURN, "offset";
}

/// A turn either way, rad: a counter may be off by one.
const TURN: Range = Range::within(-core::f64::consts::TAU, core::f64::consts::TAU);
