//! Why a log can't be used: what, where, how to mend it.

use super::{Finding, Malformed, MappingError, UnitError};

/// A log that can't be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LogError {
    /// The bytes can't be read or unpacked.
    #[error("{file}, near line {line}: the log can't be read: {source}")]
    Read {
        /// File.
        file: String,
        /// Line, from 1.
        line: u64,
        /// Message of the system.
        source: std::io::Error,
    },
    /// The file has no header.
    #[error("{file}: the log is empty; its first line must name the columns: t, q1, .., tau1, ..")]
    Empty {
        /// File.
        file: String,
    },
    /// The first line names no column at all.
    #[error("{file}, line 1: {what}; the first line must name the columns, with commas between them: t,q1,..,tau1,..")]
    Header {
        /// File.
        file: String,
        /// Format that it looks like instead.
        what: String,
    },
    /// A column that must be there is not.
    #[error(
        "{file}: the column `{column}` is missing{}; columns understood: {known}; {}", rename(.lookalike), INSPECT
    )]
    MissingColumn {
        /// File.
        file: String,
        /// The column.
        column: String,
        /// Columns that are there and understood.
        known: String,
        /// A column that may be it under another name.
        lookalike: Option<String>,
    },
    /// Neither torques nor currents.
    #[error(
        "{file}: the column `tau1` is missing{}; give torques (tau1..tau{dof}, N m), or motor currents (i1..i{dof}, A) together with \
         `torque_constant` (N m of the joint per A) in the `drive` of every joint of the robot file; columns understood: {known}; {}",
        rename(.lookalike),
        INSPECT
    )]
    NoTorque {
        /// File.
        file: String,
        /// Joints.
        dof: usize,
        /// Columns that are there and understood.
        known: String,
        /// A column that may be it under another name.
        lookalike: Option<String>,
    },
    /// Currents without gains.
    #[error(
        "{file}: torques would be motor currents times gains, and the robot file has no `torque_constant` (N m of the joint per A) for joint {}; write it into \
         the `drive` of that joint, or give torques (tau1, ..) in the log",
        .joints.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")
    )]
    NoTorqueConstant {
        /// File.
        file: String,
        /// Joints without one, from 1.
        joints: Vec<usize>,
    },
    /// A column's unit does not fit what it holds.
    #[error("{file}, line 1, column `{column}`: {source}")]
    Unit {
        /// File.
        file: String,
        /// The column.
        column: String,
        /// The unit, and which ones there are.
        source: Box<UnitError>,
    },
    /// The channels of a file can't be given the roles of columns.
    #[error("{file}: {source}")]
    Mapping {
        /// File.
        file: String,
        /// Missing or ambiguous entry.
        source: Box<MappingError>,
    },
    /// A format that is known and not read.
    #[error("{file}: {what}")]
    Foreign {
        /// File.
        file: String,
        /// Description of the mistake, and how to mend it.
        what: String,
    },
    /// A file of another kind can't be read.
    #[error("{file}: the {format} file can't be read: {source}")]
    Format {
        /// File.
        file: String,
        /// Kind of file.
        format: &'static str,
        /// Where the bytes are not those of the format.
        source: Box<Malformed>,
    },
    /// Two columns have one name.
    #[error("{file}, line 1: the column `{column}` stands there twice; rename or remove one")]
    DoubleColumn {
        /// File.
        file: String,
        /// The column.
        column: String,
    },
    /// Number of joints differs from the robot's.
    #[error(
        "{file}: the number of joints is {found} in the log (counted by its columns q1 ..) and {expected} in the robot file; take the log or the robot file that belongs to it"
    )]
    Joints {
        /// File.
        file: String,
        /// Of the log.
        found: usize,
        /// Of the robot.
        expected: usize,
    },
    /// Not a Parquet file, or one with something that is not read here.
    #[error("{file}: the Parquet file can't be read: {what}")]
    Parquet {
        /// File.
        file: String,
        /// Message of the reader.
        what: String,
    },
    /// The quality check found something that must not pass silently.
    #[error("{file}: {}", list(.findings))]
    Rejected {
        /// File.
        file: String,
        /// All findings, also those that would not have stopped it.
        findings: Vec<Finding>,
    },
}

impl LogError {
    /// Of a file whose bytes are not those of its format.
    pub(super) fn malformed(file: &str, format: &'static str, source: impl Into<Malformed>) -> Self {
        Self::Format { file: file.into(), format, source: Box::new(source.into()) }
    }

    /// Of a file whose channels are no columns.
    pub(super) fn mapping(file: &str, source: MappingError) -> Self {
        Self::Mapping { file: file.into(), source: Box::new(source) }
    }
}

/// The way to columns of other names.
const INSPECT: &str = "where the log has them under other names, `denavit log inspect LOG --out map.yaml` proposes a mapping \
                       of its channels, which `--map map.yaml` applies";

fn rename(lookalike: &Option<String>) -> String {
    lookalike.as_ref().map_or(String::new(), |name| format!(" (is it `{name}`? rename it)"))
}

fn list(findings: &[Finding]) -> String {
    findings.iter().filter(|f| f.is_fatal()).map(|f| f.to_string()).collect::<Vec<_>>().join("; ")
}
