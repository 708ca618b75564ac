//! Effect `coulomb_friction`: `FC sign(v)`.

use super::key::{Range, Scope, effect};

effect! {
    /// Friction of one level, against the direction of motion.
    CoulombFriction = "coulomb_friction", Scope::Joint;
    law: "FC sign(v)";
    source: COULOMB;
    level = FC ["N m"] always 0.01 * torque, Range::SIZE, "level";
}

const COULOMB: &str = "between the 0.05 to 0.5 % of the torque limit of a KUKA LWR (Katsumata et al., table II) or 0.2 to 2.3 % of a Panda (Gaz et al., RA-L 2019, table III) and the 1 to 7 % of a Staubli TX40 (figaroh)";
