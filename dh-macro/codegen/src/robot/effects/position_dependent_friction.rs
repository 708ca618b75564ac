//! Effect `position_dependent_friction`: `sign(v) (PC cos(PN q) + PS sin(PN q))`.

use super::key::{Range, Scope, effect};

effect! {
    /// Friction that varies along the joint's travel.
    PositionDependentFriction = "position_dependent_friction", Scope::Joint;
    law: "sign(v) (PC cos(PN q) + PS sin(PN q))";
    source: "the law: Armstrong-Helouvry, Control of Machines with Friction (1991), on a PUMA. Size: half of the default Coulomb level, our choice";
    cosine = PC ["N m"] alone 0.004 * torque, Range::ANY, "amplitude of the cosine";
    sine = PS ["N m"] alone 0.003 * torque, Range::ANY, "amplitude of the sine";
    periods = PN [] always 1.0, Range::within(0.0, 1e5), "periods per turn of the joint";
}
