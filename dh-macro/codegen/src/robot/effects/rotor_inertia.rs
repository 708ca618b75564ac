//! Effect `rotor_inertia`: `IA ddq`.

use super::key::{Range, Scope, effect};

effect! {
    /// Reflected inertia of the drive.
    RotorInertia = "rotor_inertia", Scope::Joint;
    law: "IA ddq";
    source: "three times the 0.0007 to 0.0011 kg m^2 per N m of torque limit of a Staubli TX40 (figaroh); high ratios have more";
    inertia = IA ["kg m^2"] always 0.003 * torque, Range::SIZE, "on the link side of the gear";
}
