//! Effect `presliding_hysteresis`: `HC z`, `dz/dt = (v / HX)(1 - z sign(v))`.

use super::key::{Range, Scope, effect};

effect! {
    /// Friction with memory near reversals.
    PreslidingHysteresis = "presliding_hysteresis", Scope::Joint;
    law: "HC z, dz/dt = (v / HX)(1 - z sign(v)); in the simulator LuGre's bristle, with its damping";
    source: "the law: Canudas de Wit et al., IEEE TAC 40 (1995). Level as coulomb_friction, travel: our choice; at rest a KUKA iiwa 14 shows 0.05 to 0.13 % of its torque limits (Drake's static poses, our fit)";
    level = HC ["N m"] always 0.01 * torque, Range::SIZE, "level";
    travel = HX ["rad"] always 2e-3, Range::POSITIVE, "travel in which it builds up to 1 - 1/e";
}
