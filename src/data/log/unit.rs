//! Units that a column may be in, and what one of them is in SI.

use super::{Quantity, Role};

/// Unit, its value in the unit of the contract, and what it measures.
const UNITS: &[(&str, f64, Dimension)] = &[
    ("s", 1.0, Dimension::Time),
    ("ms", 1e-3, Dimension::Time),
    ("us", 1e-6, Dimension::Time),
    ("ns", 1e-9, Dimension::Time),
    ("min", 60.0, Dimension::Time),
    ("rad", 1.0, Dimension::Position),
    ("deg", std::f64::consts::PI / 180.0, Dimension::Position),
    ("m", 1.0, Dimension::Position),
    ("mm", 1e-3, Dimension::Position),
    ("rad/s", 1.0, Dimension::Speed),
    ("deg/s", std::f64::consts::PI / 180.0, Dimension::Speed),
    ("rpm", std::f64::consts::PI / 30.0, Dimension::Speed),
    ("m/s", 1.0, Dimension::Speed),
    ("mm/s", 1e-3, Dimension::Speed),
    ("rad/s^2", 1.0, Dimension::Acceleration),
    ("deg/s^2", std::f64::consts::PI / 180.0, Dimension::Acceleration),
    ("m/s^2", 1.0, Dimension::Acceleration),
    ("N m", 1.0, Dimension::Torque),
    ("N mm", 1e-3, Dimension::Torque),
    ("mN m", 1e-3, Dimension::Torque),
    ("kN m", 1e3, Dimension::Torque),
    ("N", 1.0, Dimension::Torque),
    ("kN", 1e3, Dimension::Torque),
    ("A", 1.0, Dimension::Current),
    ("mA", 1e-3, Dimension::Current),
    ("degC", 1.0, Dimension::Temperature),
    ("C", 1.0, Dimension::Temperature),
];

/// What a unit measures. Angle and length are one, force and torque are one: the joint decides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Dimension {
    Time,
    Position,
    Speed,
    Acceleration,
    Torque,
    Current,
    Temperature,
}

/// Spelled as in the table: `Nm`, `N*m`, `°`, `degrees` are other spellings.
fn usual(unit: &str) -> String {
    let unit = unit.trim().replace(['*', '·', '.'], " ").replace('²', "^2").replace("s2", "s^2");
    let unit = unit.replace("degrees", "deg").replace("radians", "rad").replace("seconds", "s");
    let unit = unit.replace("°C", "degC").replace('°', "deg").replace('µ', "u");
    match unit.as_str() {
        "Nm" => "N m".into(),
        "Nmm" => "N mm".into(),
        "mNm" => "mN m".into(),
        "kNm" => "kN m".into(),
        "sec" => "s".into(),
        _ => unit,
    }
}

fn dimension(role: Role) -> Option<Dimension> {
    Some(match role {
        Role::Time => Dimension::Time,
        Role::Segment => return None,
        Role::Wrench(_) => Dimension::Torque,
        Role::Joint(quantity, _) => match quantity {
            Quantity::Q | Quantity::Qm | Quantity::Qd => Dimension::Position,
            Quantity::Dq => Dimension::Speed,
            Quantity::Ddq => Dimension::Acceleration,
            Quantity::Tau | Quantity::Taum => Dimension::Torque,
            Quantity::Current => Dimension::Current,
            Quantity::Temperature => Dimension::Temperature,
        },
    })
}

/// What one `unit` is in the contract's unit for the role; `Err` says which units there are.
pub(crate) fn scale(unit: &str, role: Role) -> Result<f64, String> {
    let wanted = dimension(role);
    let fits = |d: &Dimension| Some(*d) == wanted;
    let usual = usual(unit);
    UNITS.iter().find(|(name, _, d)| *name == usual && fits(d)).map(|(_, scale, _)| *scale).ok_or_else(|| {
        let known: Vec<&str> = UNITS.iter().filter(|(_, _, d)| fits(d)).map(|(name, ..)| *name).collect();
        match known.as_slice() {
            [] => format!("`{}` has no unit, `{unit}` was given", role.name()),
            _ => format!("`{unit}` is no unit for `{}`; choose among {}", role.name(), known.join(", ")),
        }
    })
}

/// A column's name without the unit that stands behind it in brackets, and that unit:
/// `q1 [deg]`, `t (ms)`.
pub(crate) fn split(name: &str) -> (&str, Option<&str>) {
    let name = name.trim();
    for (open, close) in [('[', ']'), ('(', ')')] {
        if let Some(inner) = name.strip_suffix(close)
            && let Some(at) = inner.rfind(open)
            && at > 0
        {
            return (inner[..at].trim_end(), Some(inner[at + 1..].trim()));
        }
    }
    (name, None)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_have_scales_of_their_role() {
        let q = Role::Joint(Quantity::Q, 0);
        assert_eq!(scale("deg", q), Ok(std::f64::consts::PI / 180.0));
        assert_eq!(scale("°", q), Ok(std::f64::consts::PI / 180.0));
        assert_eq!(scale("ms", Role::Time), Ok(1e-3));
        assert_eq!(scale("Nmm", Role::Joint(Quantity::Tau, 2)), Ok(1e-3));
        assert!(scale("deg", Role::Time).unwrap_err().contains("ms"));
        assert!(scale("s", Role::Segment).unwrap_err().contains("no unit"));
    }

    #[test]
    fn names_and_units_are_split() {
        assert_eq!(split("q1 [deg]"), ("q1", Some("deg")));
        assert_eq!(split("t(ms)"), ("t", Some("ms")));
        assert_eq!(split("observation.state[0]"), ("observation.state", Some("0")));
        assert_eq!(split("q1"), ("q1", None));
    }
}
