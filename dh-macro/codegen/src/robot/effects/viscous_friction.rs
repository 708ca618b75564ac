//! Effect `viscous_friction`: `FV v`.

use super::key::{Range, Scope, effect};

effect! {
    /// Friction in proportion to speed.
    ViscousFriction = "viscous_friction", Scope::Joint;
    law: "FV v";
    source: VISCOUS;
    viscous = FV ["N m s/rad"] always 0.01 * torque, Range::SIZE, "torque per speed";
}

const VISCOUS: &str = "per rad/s between the 0.1 to 0.9 % of the torque limit of a KUKA LWR (FloBaRoID) or a Panda (Gaz et al. 2019) and the 2 to 6 % of a Staubli TX40 (figaroh) or a UR10 (Petrone et al., IEEE TII 2025)";
