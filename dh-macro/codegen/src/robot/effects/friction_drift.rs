//! Effect `friction_drift`: friction times `1 + DA exp(-t / DT) + DK (temp - T0)`, a factor that is
//! not less than 0.

use super::key::{Range, Scope, effect};

effect! {
    /// Friction that changes with time and temperature.
    FrictionDrift = "friction_drift", Scope::EveryJoint;
    law: "the joint's friction times 1 + DA exp(-t / DT) + DK (temp - T0)";
    source: "order of magnitude, our choice. Gears take tens of minutes to warm; the default is shorter so that a log of half a minute shows it";
    cold = DA [] alone 0.5, Range::within(-1.0, 1e3), "what cold friction has more than warm friction, as a part of the latter";
    time = DT ["s"] always 30.0, Range::POSITIVE, "time constant of the warming";
    per_kelvin = DK ["1/K"] always 0.0, Range::ANY, "change per kelvin of the `temp` column";
    reference = T0 ["degC"] always 25.0, Range::within(-273.15, 1e3), "temperature at which DK does nothing";
}
