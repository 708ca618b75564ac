//! Effect `torque_gain_error`: the measured torque is `GT` times the true one.

use super::key::{Range, Scope, effect};

effect! {
    /// A joint's torque is scaled: torque constant or gain of the sensor.
    TorqueGainError = "torque_gain_error", Scope::EveryJoint;
    law: "measured = GT true";
    source: "our choice, rather large: ten percent";
    gain = GT [] always 0.9, Range::above(0.0, 1e3), "measured torque per true torque";
}
