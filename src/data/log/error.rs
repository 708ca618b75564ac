//! Reasons why a log can't be used: what is wrong, where, and how to fix it.

use super::{Finding, Malformed, MappingError, UnitError};

/// Reason why a log can't be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LogError {
    /// The bytes can't be read or unpacked.
    #[error("{file}, near line {line}: the log can't be read: {source}")]
    Read {
        /// File name.
        file: String,
        /// Line, from 1.
        line: u64,
        /// Error of the operating system.
        source: std::io::Error,
    },
    /// The file has no header.
    #[error("{file}: the log is empty; its first line must name the columns: t, q1, .., tau1, ..")]
    Empty {
        /// File name.
        file: String,
    },
    /// The first line names no columns.
    #[error("{file}, line 1: {what}; the first line must name the columns, with commas between them: t,q1,..,tau1,..")]
    Header {
        /// File name.
        file: String,
        /// Description of the recognised format.
        what: String,
    },
    /// A required column is missing.
    #[error(
        "{file}: the column `{column}` is missing{}; columns understood: {known}; {}", rename(.lookalike), INSPECT
    )]
    MissingColumn {
        /// File name.
        file: String,
        /// Name of the missing column.
        column: String,
        /// Recognised columns of the log.
        known: String,
        /// A column that may be the missing one under another name.
        lookalike: Option<String>,
    },
    /// The log has neither torques nor currents.
    #[error(
        "{file}: the column `tau1` is missing{}; give torques (tau1..tau{dof}, N m), or motor currents (i1..i{dof}, A) together with \
         `torque_constant` (N m of the joint per A) in the `drive` of every joint of the robot file; columns understood: {known}; {}",
        rename(.lookalike),
        INSPECT
    )]
    NoTorque {
        /// File name.
        file: String,
        /// Number of joints.
        dof: usize,
        /// Recognised columns of the log.
        known: String,
        /// A column that may be the missing one under another name.
        lookalike: Option<String>,
    },
    /// The log has currents, but the robot file lacks torque constants.
    #[error(
        "{file}: torques would be motor currents times gains, and the robot file has no `torque_constant` (N m of the joint per A) for joint {}; write it into \
         the `drive` of that joint, or give torques (tau1, ..) in the log",
        .joints.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")
    )]
    NoTorqueConstant {
        /// File name.
        file: String,
        /// Joints without a torque constant, counted from 1.
        joints: Vec<usize>,
    },
    /// The unit of a column does not fit its quantity.
    #[error("{file}, line 1, column `{column}`: {source}")]
    Unit {
        /// File name.
        file: String,
        /// Name of the column.
        column: String,
        /// The unit and the allowed units.
        source: Box<UnitError>,
    },
    /// The channels of a file can't be mapped to the columns of the log format.
    #[error("{file}: {source}")]
    Mapping {
        /// File name.
        file: String,
        /// Missing or ambiguous entry of the mapping.
        source: Box<MappingError>,
    },
    /// The format is recognised but not supported.
    #[error("{file}: {what}")]
    Foreign {
        /// File name.
        file: String,
        /// Description of the problem and how to fix it.
        what: String,
    },
    /// A binary file other than Parquet can't be read.
    #[error("{file}: the {format} file can't be read: {source}")]
    Format {
        /// File name.
        file: String,
        /// Name of the format.
        format: &'static str,
        /// Where the bytes violate the format.
        source: Box<Malformed>,
    },
    /// Two columns have the same name.
    #[error("{file}, line 1: the column `{column}` stands there twice; rename or remove one")]
    DoubleColumn {
        /// File name.
        file: String,
        /// Name of the column.
        column: String,
    },
    /// The number of joints differs from the robot's.
    #[error(
        "{file}: the number of joints is {found} in the log (counted by its columns q1 ..) and {expected} in the robot file; take the log or the robot file that belongs to it"
    )]
    Joints {
        /// File name.
        file: String,
        /// Number of joints in the log.
        found: usize,
        /// Number of joints of the robot.
        expected: usize,
    },
    /// The file is not a Parquet file, or uses features that are not supported.
    #[error("{file}: the Parquet file can't be read: {what}")]
    Parquet {
        /// File name.
        file: String,
        /// Message of the reader.
        what: String,
    },
    /// The quality check found something that the user must accept explicitly.
    #[error("{file}: {}", list(.findings))]
    Rejected {
        /// File name.
        file: String,
        /// All findings, including those that alone would not have stopped the reading.
        findings: Vec<Finding>,
    },
}

impl LogError {
    /// Error for a file whose bytes violate its format.
    pub(super) fn malformed(file: &str, format: &'static str, source: impl Into<Malformed>) -> Self {
        Self::Format { file: file.into(), format, source: Box::new(source.into()) }
    }

    /// Error for a file whose channels can't be mapped to columns.
    pub(super) fn mapping(file: &str, source: MappingError) -> Self {
        Self::Mapping { file: file.into(), source: Box::new(source) }
    }
}

/// Hint at the command that maps columns of other names.
const INSPECT: &str = "where the log has them under other names, `denavit log inspect LOG --out map.yaml` proposes a mapping \
                       of its channels, which `--map map.yaml` applies";

fn rename(lookalike: &Option<String>) -> String {
    lookalike.as_ref().map_or(String::new(), |name| format!(" (is it `{name}`? rename it)"))
}

fn list(findings: &[Finding]) -> String {
    findings.iter().filter(|f| f.is_fatal()).map(|f| f.to_string()).collect::<Vec<_>>().join("; ")
}
