//! Effect `torque_offset`: the measured torque is the true one plus `TO`.

use super::key::{Range, Scope, effect};

effect! {
    /// A joint's torque is shifted.
    TorqueOffset = "torque_offset", Scope::Joint;
    law: "measured = true + TO";
    source: "rather more than the 0.5 % of the torque limit of a KUKA LWR (FloBaRoID), 0.2 % of an iiwa 14 (Drake's logs), 0.1 to 0.8 % of a Panda (Gaz et al. 2019)";
    offset = TO ["N m"] always 0.01 * torque, Range::ANY, "offset";
}
