//! Effect `joint_elasticity`: a spring between motor and link.

use super::key::{Range, Scope, effect};

effect! {
    /// A spring between the motor, whose angle is measured, and its link.
    JointElasticity = "joint_elasticity", Scope::Joint;
    law: "the angle that is measured is the motor's; the link's is less by tau_link / KE";
    source: "order of magnitude, our choice: 10 kN m/rad at 170 N m, as in the large joints of light-weight arms with harmonic drives";
    stiffness = KE ["N m/rad"] always 60.0 * torque, Range::POSITIVE, "stiffness";
    damping = DE ["N m s/rad"] always 0.0, Range::NOT_NEGATIVE, "damping";
}
