//! Effect `asymmetric_friction`: `FCA |sign(v)| + FVA |v|`, with levels of `FC + FCA` forward and
//! `FC - FCA` backward.

use super::key::{Range, Scope, effect};

effect! {
    /// Coulomb and viscous levels that differ with direction.
    AsymmetricFriction = "asymmetric_friction", Scope::Joint;
    law: "FCA |sign(v)| + FVA |v|";
    source: "two fifths of the default symmetric part: the upper end of what the PUMA 560 has, 5 to 45 % (Corke and Armstrong-Helouvry, ICRA 1994); its viscous part is our choice";
    level = FCA ["N m"] alone 0.004 * torque, Range::ANY, "half the difference of the Coulomb levels forward and backward";
    viscous = FVA ["N m s/rad"] alone 0.002 * torque, Range::ANY, "half the difference of the viscous parts";
}
