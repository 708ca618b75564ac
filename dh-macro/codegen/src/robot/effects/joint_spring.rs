//! `joint_spring`: `KS (q - QS)`.

use super::key::{Range, Scope, effect};

effect! {
    /// An elastic torque in q: a gravity spring, a cable, a hose.
    JointSpring = "joint_spring", Scope::Joint;
    law: "KS (q - QS)";
    source: "our choice: cables and hoses, some N m over the travel of an industrial wrist";
    stiffness = "KS" ["N m/rad"] always 0.05 * torque, Range::ANY, "stiffness";
    rest = "QS" ["rad"] always 0.0, Range::within(-1e3, 1e3), "angle without torque";
}
