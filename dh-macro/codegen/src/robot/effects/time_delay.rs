//! Effect `time_delay`: the torque sample at `t` belongs to the motion at `t - TD`.

use super::key::{Range, Scope, effect};

effect! {
    /// Torque and motion are not sampled at the same time.
    TimeDelay = "time_delay", Scope::EveryJoint;
    law: "the torque sample at t belongs to the motion at t - TD";
    source: "our choice: some cycles of a field bus. The torques of the iiwa 14 in Drake's logs are 40 ms late";
    delay = TD ["s"] always 0.005, Range::within(-10.0, 10.0), "how late the torque is";
}
