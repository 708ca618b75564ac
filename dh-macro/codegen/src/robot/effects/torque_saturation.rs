//! Effect `torque_saturation`: the applied torque is clipped to `+-TM`.

use super::key::{Range, Scope, effect};

effect! {
    /// The torque is clipped.
    TorqueSaturation = "torque_saturation", Scope::Joint;
    law: "the torque that is applied is clipped to +-TM";
    source: "a drive's current limit";
    limit = TM ["N m"] derived, Range::POSITIVE, "limit; default: 0.8 of the largest torque that the motion asks for";
}
