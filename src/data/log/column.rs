//! Role of a column of a log, read from its name in the header.

use super::LogError;

/// A quantity with one column per joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Quantity {
    /// `q1..`: position, rad or m.
    Q,
    /// `dq1..`: velocity, rad/s or m/s.
    Dq,
    /// `ddq1..`: acceleration, rad/s^2 or m/s^2.
    Ddq,
    /// `qm1..`: motor position referred to the joint side of the gear, rad.
    Qm,
    /// `qd1..`: desired position, rad or m.
    Qd,
    /// `tau1..`: torque or force at the joint, N m or N.
    Tau,
    /// `taum1..`: motor torque referred to the joint side of the gear, N m.
    Taum,
    /// `i1..`: motor current, A.
    Current,
    /// `temp1..`: temperature, deg C.
    Temperature,
}

impl Quantity {
    /// All quantities with the prefix of their columns.
    pub const ALL: [(Self, &str); 9] = [
        (Self::Q, "q"),
        (Self::Dq, "dq"),
        (Self::Ddq, "ddq"),
        (Self::Qm, "qm"),
        (Self::Qd, "qd"),
        (Self::Tau, "tau"),
        (Self::Taum, "taum"),
        (Self::Current, "i"),
        (Self::Temperature, "temp"),
    ];

    /// Prefix of the quantity's columns: `tau` in `tau3`.
    pub fn prefix(self) -> &'static str {
        Self::ALL.iter().find(|(q, _)| *q == self).map_or("", |(_, prefix)| prefix)
    }
}

/// Content of a column. Joints and wrench components are counted from 0 here and from 1 in names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Role {
    /// `t`: time, s.
    Time,
    /// `seg`: recording number.
    Segment,
    /// A joint quantity and the joint's index: `q1`, `tau1`, ...
    Joint(Quantity, usize),
    /// `fx fy fz mx my mz`: external wrench in the tool frame, N and N m.
    Wrench(usize),
}

impl Role {
    /// The role of a column name; `None` for a name outside the log format.
    pub fn of(name: &str) -> Option<Self> {
        match name {
            "t" => return Some(Self::Time),
            "seg" => return Some(Self::Segment),
            _ => {}
        }
        if let Some(axis) = ["fx", "fy", "fz", "mx", "my", "mz"].iter().position(|w| *w == name) {
            return Some(Self::Wrench(axis));
        }
        let digits = name.find(|c: char| c.is_ascii_digit())?;
        let (prefix, number) = name.split_at(digits);
        let joint: usize = number.parse().ok().filter(|&j| j > 0 && !number.starts_with('0'))?;
        let quantity = Quantity::ALL.iter().find(|(_, p)| *p == prefix)?.0;
        Some(Self::Joint(quantity, joint - 1))
    }

    /// Name of the column.
    pub fn name(self) -> String {
        match self {
            Self::Time => "t".into(),
            Self::Segment => "seg".into(),
            Self::Joint(quantity, joint) => format!("{}{}", quantity.prefix(), joint + 1),
            Self::Wrench(axis) => ["fx", "fy", "fz", "mx", "my", "mz"][axis % 6].into(),
        }
    }
}

/// Columns of a file that are used, with their roles.
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    /// File name, for messages.
    pub file: String,
    /// Number of joints: the largest number of a `q` column.
    pub dof: usize,
    /// Roles of the columns that are read, in the file's order.
    pub roles: Vec<Role>,
    /// Position of each of these columns in a row of the file.
    pub positions: Vec<usize>,
    /// Columns of the file whose names are outside the log format.
    pub ignored: Vec<String>,
    /// Number of cells in a full row of the file.
    pub width: usize,
}

impl Layout {
    /// Builds the layout from the header's names. `t`, and `q` of joints `1..dof`, are required. A
    /// quantity that is present for some joints but not for all is an error.
    pub fn new<S: AsRef<str>>(file: &str, header: &[S]) -> Result<Self, LogError> {
        let names: Vec<&str> = header
            .iter()
            .map(|n| n.as_ref().trim_matches(|c: char| c.is_whitespace() || c == '"' || c == '\u{feff}'))
            .collect();
        let columns = names.iter().enumerate().filter_map(|(i, name)| Some((Role::of(name)?, i))).collect();
        Self::of_columns(file, &names, columns)
    }

    /// Builds the layout from columns of known role, each with its position in a row of the file,
    /// ascending.
    pub(crate) fn of_columns(file: &str, names: &[&str], columns: Vec<(Role, usize)>) -> Result<Self, LogError> {
        let mut layout = Self {
            file: file.into(),
            dof: 0,
            roles: Vec::new(),
            positions: Vec::new(),
            ignored: Vec::new(),
            width: names.len(),
        };
        for (position, name) in names.iter().enumerate() {
            match columns.iter().find(|(_, p)| *p == position).map(|(role, _)| *role) {
                // Above 64 joints the name is no joint column; a name such as `q4000000000` must
                // not make this search for as many columns.
                Some(Role::Joint(_, joint)) if joint >= 64 => layout.ignored.push((*name).into()),
                Some(role) if layout.roles.contains(&role) => {
                    return Err(LogError::DoubleColumn { file: file.into(), column: (*name).into() });
                }
                Some(role) => {
                    if let Role::Joint(Quantity::Q, joint) = role {
                        layout.dof = layout.dof.max(joint + 1);
                    }
                    layout.roles.push(role);
                    layout.positions.push(position);
                }
                None => layout.ignored.push((*name).into()),
            }
        }
        if layout.roles.is_empty()
            && let Some(what) = no_header(names)
        {
            return Err(LogError::Header { file: file.into(), what });
        }
        layout.require(Role::Time)?;
        layout.require(Role::Joint(Quantity::Q, 0))?;
        for (quantity, _) in Quantity::ALL {
            let some = layout.roles.iter().any(|r| matches!(r, Role::Joint(q, _) if *q == quantity));
            // Torques are required only when the log is used, since a log of currents has none at
            // this point.
            if some {
                for joint in 0..layout.dof {
                    layout.require(Role::Joint(quantity, joint))?;
                }
            }
        }
        Ok(layout)
    }

    /// Index of the column with this role; an error if the file has none.
    pub fn require(&self, role: Role) -> Result<usize, LogError> {
        self.find(role).ok_or_else(|| {
            let column = role.name();
            let lookalike = self.lookalike(&column);
            LogError::MissingColumn { file: self.file.clone(), column, known: self.known(), lookalike }
        })
    }

    /// Error for a log that has neither torques nor currents.
    pub(crate) fn without_torque(&self) -> LogError {
        let lookalike = self.lookalike("tau1");
        LogError::NoTorque { file: self.file.clone(), dof: self.dof, known: self.known(), lookalike }
    }

    fn lookalike(&self, column: &str) -> Option<String> {
        self.ignored.iter().find(|name| resembles(name, column)).cloned()
    }

    /// Recognised columns as text, for messages.
    fn known(&self) -> String {
        match self.roles.as_slice() {
            [] => {
                let shown = self.ignored.iter().take(4).map(String::as_str).collect::<Vec<_>>().join("`, `");
                let more = if self.ignored.len() > 4 { ", .." } else { "" };
                format!("none (the log has `{shown}`{more})")
            }
            roles => roles.iter().map(|r| r.name()).collect::<Vec<_>>().join(", "),
        }
    }

    /// Indices into a block's columns of this quantity for joints `0..dof`; an error if one is
    /// missing.
    pub fn require_all(&self, quantity: Quantity, dof: usize) -> Result<Vec<usize>, LogError> {
        (0..dof).map(|joint| self.require(Role::Joint(quantity, joint))).collect()
    }

    /// Index of the role into a block's columns.
    pub fn find(&self, role: Role) -> Option<usize> {
        self.roles.iter().position(|r| *r == role)
    }

    /// Whether every joint has a column of this quantity.
    pub fn has(&self, quantity: Quantity) -> bool {
        (0..self.dof).all(|joint| self.find(Role::Joint(quantity, joint)).is_some())
    }
}

/// Description of a first line that names no column, if its kind is recognised.
fn no_header(names: &[&str]) -> Option<String> {
    let odd = |c: char| c == char::REPLACEMENT_CHARACTER || (c.is_control() && c != '\t');
    if names.iter().any(|name| name.chars().any(odd)) {
        return Some(
            "this is no text, and no format that is read (CSV, gzipped CSV, Parquet, MCAP, npz, MATLAB 5 to 7)".into(),
        );
    }
    let number = |name: &&str| name.parse::<f64>().is_ok();
    (names.len() > 1 && names.iter().all(number)).then(|| "numbers where names belong: the header is missing".into())
}

/// Whether a column of another name is probably the missing one: `Time`, `tau_1`, `effort1`,
/// `joint_position_1`.
fn resembles(name: &str, wanted: &str) -> bool {
    let name = super::unit::split(name).0;
    let plain: String = name.to_lowercase().chars().filter(char::is_ascii_alphanumeric).collect();
    let digits = wanted.find(|c: char| c.is_ascii_digit()).unwrap_or(wanted.len());
    let (prefix, number) = wanted.split_at(digits);
    let synonyms: &[&str] = match prefix {
        "t" => &["time", "timestamp", "secs", "seconds", "times", "ts"],
        "q" => &["q", "pos", "position", "angle", "jointposition", "qact", "actualq"],
        "dq" => &["qd", "vel", "velocity", "jointvelocity", "qdot"],
        "tau" => &["torque", "effort", "trq", "jointtorque", "tau"],
        _ => &[],
    };
    plain == wanted || synonyms.iter().any(|s| plain == format!("{s}{number}") || plain == format!("j{number}{s}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_roles_agree() {
        for name in ["t", "seg", "q1", "dq7", "ddq12", "tau3", "taum3", "temp2", "i4", "qm1", "qd1", "mx"] {
            assert_eq!(Role::of(name).unwrap().name(), name);
        }
        for name in ["q", "q0", "q01", "tau-1", "Q1", "q1.5", "", "time", "x1"] {
            assert_eq!(Role::of(name), None, "{name}");
        }
    }

    #[test]
    fn unknown_columns_are_kept_aside() {
        let layout = Layout::new("log.csv", &["t", "mode", "q1", "tau1"]).unwrap();
        assert_eq!(layout.ignored, ["mode"]);
        assert_eq!(layout.positions, [0, 2, 3]);
        assert_eq!(layout.dof, 1);
    }

    #[test]
    fn missing_torque_of_a_joint_is_named() {
        let error = Layout::new("log.csv", &["t", "q1", "q2", "tau1", "Torque_2"]).unwrap_err().to_string();
        assert!(error.contains("log.csv") && error.contains("`tau2`") && error.contains("`Torque_2`"), "{error}");
    }

    #[test]
    fn missing_time_names_the_lookalike() {
        for name in ["Time", "Time [ms]", "timestamp(ns)"] {
            let error = Layout::new("log.csv", &[name, "q1", "tau1"]).unwrap_err().to_string();
            assert!(error.contains("`t`") && error.contains(&format!("`{name}`")), "{error}");
        }
    }

    #[test]
    fn a_first_line_without_names_is_told_by_what_it_is() {
        for (header, word) in
            [(&["0.0", "1.5", "-2e3"][..], "the header is missing"), (&["PK\u{3}\u{4}", "x"], "no text")]
        {
            let error = Layout::new("log.csv", header).unwrap_err().to_string();
            assert!(error.contains(word) && error.contains("log.csv, line 1"), "{error}");
        }
        // Text names are listed even if none of them is recognised.
        let error = Layout::new("log.csv", &["stamp", "joint_position_1"]).unwrap_err().to_string();
        assert!(error.contains("`t` is missing") && error.contains("understood: none"), "{error}");
        assert!(error.contains("`stamp`, `joint_position_1`") && error.contains("denavit log inspect"), "{error}");
    }

    #[test]
    fn double_column() {
        assert!(matches!(Layout::new("a", &["t", "q1", "q1"]), Err(LogError::DoubleColumn { .. })));
    }
}
