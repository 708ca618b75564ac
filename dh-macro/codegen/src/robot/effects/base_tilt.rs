//! Effect `base_tilt`: the true base is the given one rotated by `RotY(pitch) RotX(roll)`.

use super::key::{Range, Scope, effect};

effect! {
    /// The base is not where gravity says it is.
    BaseTilt = "base_tilt", Scope::Robot;
    law: "true base = given base turned by RotY(pitch) RotX(roll)";
    source: "our choice: a degree, as on a cart or an uneven floor";
    roll = ROLL as "roll" ["rad"] alone 0.02, Range::HALF_TURN, "about x";
    pitch = PITCH as "pitch" ["rad"] alone 0.02, Range::HALF_TURN, "about y";
}
