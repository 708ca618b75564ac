//! Units of columns, and their values in SI.

use dh_codegen::robot::Dimension;

use super::{Quantity, Role};

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

/// Mismatch between a unit and the quantity of its column.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum UnitError {
    /// The column's quantity has no unit.
    #[error("`{column}` has no unit, `{unit}` was given")]
    Unitless {
        /// Column of the log format.
        column: String,
        /// Unit that was given.
        unit: String,
    },
    /// The unit is unknown, or belongs to another quantity.
    #[error("`{unit}` is no unit for `{column}`; choose among {}", .known.join(", "))]
    Unknown {
        /// Column of the log format.
        column: String,
        /// Unit that was given.
        unit: String,
        /// Units allowed for the column.
        known: Vec<&'static str>,
    },
}

/// Value of one `unit` in the SI unit of the role.
pub(crate) fn scale(unit: &str, role: Role) -> Result<f64, UnitError> {
    let (column, given) = (role.name(), unit.to_string());
    let Some(dimension) = dimension(role) else {
        return Err(UnitError::Unitless { column, unit: given });
    };
    dimension.scale(unit).ok_or_else(|| UnitError::Unknown { column, unit: given, known: dimension.units() })
}

/// Splits a column name into the name and the unit in brackets behind it: `q1 [deg]`, `t (ms)`.
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
        assert!(scale("deg", Role::Time).unwrap_err().to_string().contains("ms"));
        assert!(scale("s", Role::Segment).unwrap_err().to_string().contains("no unit"));
    }

    #[test]
    fn robot_files_know_the_same_columns() {
        let joints = Quantity::ALL.map(|(quantity, _)| Role::Joint(quantity, 6));
        let roles = joints.into_iter().chain([Role::Time, Role::Segment]).chain((0..6).map(Role::Wrench));
        for role in roles {
            assert_eq!(dh_codegen::robot::log_column(&role.name()), Ok(dimension(role)), "{}", role.name());
        }
        assert!(dh_codegen::robot::log_column("q0").is_err() && dh_codegen::robot::log_column("x1").is_err());
    }

    #[test]
    fn names_and_units_are_split() {
        assert_eq!(split("q1 [deg]"), ("q1", Some("deg")));
        assert_eq!(split("t(ms)"), ("t", Some("ms")));
        assert_eq!(split("observation.state[0]"), ("observation.state", Some("0")));
        assert_eq!(split("q1"), ("q1", None));
    }
}
