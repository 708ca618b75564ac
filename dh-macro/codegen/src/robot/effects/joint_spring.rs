//! Effect `joint_spring`: `KS (q - QS) + KQ (q - QS)^3`, on both sides of `QS` or on one.

use super::key::{Range, Scope, effect};

effect! {
    /// An elastic torque in q: a gravity spring, a cable, a hose.
    JointSpring = "joint_spring", Scope::Joint;
    law: "KS (q - QS) + KQ (q - QS)^3, 0 on the slack side";
    source: "our choice: cables and hoses, some N m over the travel of an industrial wrist";
    stiffness = KS ["N m/rad"] always 0.05 * torque, Range::ANY, "stiffness";
    rest = QS ["rad"] always 0.0, Range::within(-1e3, 1e3), "angle without torque";
    cubic = KQ ["N m/rad^3"] always 0.0, Range::ANY, "stiffness that grows with the square of the angle";
    side = SIDE [] always 0.0, Range::within(-1.0, 1.0), "1: taut above QS only, -1: below it only, 0: on both sides";
}

impl JointSpring {
    /// Whether it acts on both sides and has no cubic part.
    #[must_use]
    pub fn is_linear(&self) -> bool {
        self.cubic() == 0.0 && self.side() == 0.0
    }
}
