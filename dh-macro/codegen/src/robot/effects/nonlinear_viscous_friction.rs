//! `nonlinear_viscous_friction`: `FN |v|^EN sign(v)`.

use super::key::{Range, Scope, effect};

effect! {
    /// A viscous part that is not in proportion to speed.
    NonlinearViscousFriction = "nonlinear_viscous_friction", Scope::Joint;
    law: "FN |v|^EN sign(v)";
    source: "size as viscous_friction, our choice. A column sign(v) sqrt|v| and one of v^3 take 21 % off the residual of the Staubli TX40's joints 1 and 2 (our fit of figaroh's log)";
    level = "FN" ["N m (s/rad)^EN"] always 0.015 * torque, Range::SIZE, "torque at 1 rad/s";
    exponent = "EN" [] always 0.5, Range::within(0.0, 20.0), "exponent";
}
