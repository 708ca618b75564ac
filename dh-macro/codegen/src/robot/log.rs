//! Mapping of a log's channels to columns, with units.

use core::f64::consts::PI;

/// Units: name, value in SI (degrees Celsius for temperatures), and dimension.
const UNITS: &[(&str, f64, Dimension)] = &[
    ("s", 1.0, Dimension::Time),
    ("ms", 1e-3, Dimension::Time),
    ("us", 1e-6, Dimension::Time),
    ("ns", 1e-9, Dimension::Time),
    ("min", 60.0, Dimension::Time),
    ("rad", 1.0, Dimension::Position),
    ("deg", PI / 180.0, Dimension::Position),
    ("m", 1.0, Dimension::Position),
    ("mm", 1e-3, Dimension::Position),
    ("rad/s", 1.0, Dimension::Speed),
    ("deg/s", PI / 180.0, Dimension::Speed),
    ("rpm", PI / 30.0, Dimension::Speed),
    ("m/s", 1.0, Dimension::Speed),
    ("mm/s", 1e-3, Dimension::Speed),
    ("rad/s^2", 1.0, Dimension::Acceleration),
    ("deg/s^2", PI / 180.0, Dimension::Acceleration),
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

/// Prefixes of the columns that every joint has, and their dimensions.
const JOINT_COLUMNS: [(&str, Dimension); 9] = [
    ("q", Dimension::Position),
    ("dq", Dimension::Speed),
    ("ddq", Dimension::Acceleration),
    ("qm", Dimension::Position),
    ("qd", Dimension::Position),
    ("tau", Dimension::Torque),
    ("taum", Dimension::Torque),
    ("i", Dimension::Current),
    ("temp", Dimension::Temperature),
];

/// Physical dimension of a unit. Angle and length share one, and so do torque and force: the joint
/// decides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// s
    Time,
    /// rad or m
    Position,
    /// rad/s or m/s
    Speed,
    /// rad/s^2 or m/s^2
    Acceleration,
    /// N m or N
    Torque,
    /// A
    Current,
    /// degrees Celsius
    Temperature,
}

impl Dimension {
    /// Names of the units of this dimension.
    pub fn units(self) -> Vec<&'static str> {
        UNITS.iter().filter(|(.., d)| *d == self).map(|(name, ..)| *name).collect()
    }

    /// Value of one `unit` in SI; `None` if it is no unit of this dimension.
    pub fn scale(self, unit: &str) -> Option<f64> {
        let usual = usual(unit);
        UNITS.iter().find(|(name, _, d)| *name == usual && *d == self).map(|(_, scale, _)| *scale)
    }
}

/// Normalises a unit's spelling to that of the table: `Nm`, `N*m`, `°` and `degrees` are
/// alternatives.
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

/// A channel: its name in the log, and its conversion to SI: `(value * unit) * gain + offset`.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LogChannel {
    /// Name. `{joint}`, `{number}` and `{index}` are placeholders for the joint's name, its number
    /// from 1 and its number from 0.
    pub name: String,
    /// Unit in the log; `None`: SI.
    pub unit: Option<String>,
    /// Factor after the unit: one number, or one for each joint. Empty: 1.
    pub gain: Vec<f64>,
    /// Offset after the factor, in SI: one number, or one for each joint. Empty: 0.
    pub offset: Vec<f64>,
}

/// Mapping of the columns of a log to its channels.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LogMapping {
    /// Column (`t`, `q1`, or `q*` for all joints) and its channel.
    pub columns: Vec<(String, LogChannel)>,
    /// Whether rows are stamped with the time of reception by the recorder, instead of the stamp in
    /// the message.
    pub arrival: bool,
}

/// Error for a column outside the log format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct UnknownColumn;

impl core::fmt::Display for UnknownColumn {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(
            "the columns are t, seg, fx .. mz, and of joints q1.., dq1.., ddq1.., qm1.., qd1.., tau1.., taum1.., i1.., temp1.., \
             or q* and so on for all joints",
        )
    }
}

impl core::error::Error for UnknownColumn {}

/// Dimension of a column: `None` for the recording number `seg`.
///
/// # Errors
/// If there is no such column; the message lists the valid ones.
pub fn log_column(column: &str) -> Result<Option<Dimension>, UnknownColumn> {
    match column {
        "t" => return Ok(Some(Dimension::Time)),
        "seg" => return Ok(None),
        "fx" | "fy" | "fz" | "mx" | "my" | "mz" => return Ok(Some(Dimension::Torque)),
        _ => {}
    }
    let digits = column.find(|c: char| c.is_ascii_digit() || c == '*').unwrap_or(column.len());
    let (prefix, number) = column.split_at(digits);
    let counts = number.parse::<usize>().is_ok_and(|n| n > 0) && !number.starts_with('0');
    let found = JOINT_COLUMNS.iter().find(|(name, _)| *name == prefix && (number == "*" || counts));
    found.map(|(_, dimension)| Some(*dimension)).ok_or(UnknownColumn)
}
