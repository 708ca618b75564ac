//! Why the channels of a file can't be given the roles of columns.

use super::UnitError;

/// Why the channels of a file can't be given the roles of columns.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MappingError {
    /// An entry for a column that a log does not have.
    #[error("`{0}` is no column; columns are t, seg, q1.., dq1.., tau1.., i1.., fx .. mz, or q* for all joints")]
    NoColumn(String),
    /// An entry with a star for a quantity that joints do not have.
    #[error("`{0}` is no column of the joints; they are q*, dq*, ddq*, qm*, qd*, tau*, taum*, i*, temp*")]
    NoJointColumn(String),
    /// An entry for all joints that names one channel.
    #[error("`{0}` is for all joints: its channel needs {{joint}}, {{number}} or {{index}} in its name")]
    OneChannel(String),
    /// A channel by a joint's name, and no robot file.
    #[error("{{joint}} needs the robot file: give --robot ROBOT")]
    NoRobot,
    /// Two entries for one column.
    #[error("the mapping gives `{0}` twice")]
    Twice(String),
    /// Neither one value nor as many as there are joints.
    #[error("`{column}` has {count} values of `{what}`: give one, or one for each joint")]
    Values {
        /// The column of the entry.
        column: String,
        /// Values that are given.
        count: usize,
        /// `gain` or `offset`.
        what: &'static str,
    },
    /// The log lacks a channel.
    #[error(
        "the mapping takes `{column}` from `{channel}`, which the log does not have; it has {}{}",
        .near.join(", "),
        if *.more { ", ..." } else { "" }
    )]
    Absent {
        /// The column of the entry.
        column: String,
        /// The channel.
        channel: String,
        /// The nearest names that are there.
        near: Vec<String>,
        /// Whether there are others.
        more: bool,
    },
    /// A unit that does not fit its column.
    #[error(transparent)]
    Unit(#[from] UnitError),
    /// A recording that names its joints, and no robot file.
    #[error(
        "the recording names its joints ({}); the robot file says which is which: give --robot ROBOT",
        .0.join(", ")
    )]
    NamedJoints(Vec<String>),
    /// No topic of a recording has the joints of the robot file.
    #[error(
        "no topic has the positions of all joints: the recording has {}, the robot file {}; {} Give the joints of the robot file these names, or a mapping \
         (--map; `denavit log inspect` proposes one)",
        .recorded.join(", "),
        .expected.join(", "),
        not_recorded(.recorded, .expected)
    )]
    OtherJoints {
        /// Joints of the recording, twenty at most.
        recorded: Vec<String>,
        /// Joints of the robot file.
        expected: Vec<String>,
    },
    /// Several topics of a recording have them.
    #[error(
        "positions of all joints are on {}; choose one in a mapping (--map), for example `q*: {{ channel: \"{}/position/{{joint}}\" }}`",
        .0.join(" and "),
        .0.first().map_or("", String::as_str)
    )]
    SeveralTopics(Vec<String>),
}

/// Joints that the recording lacks, as a sentence.
fn not_recorded(recorded: &[String], expected: &[String]) -> String {
    let missing: Vec<&str> = expected.iter().filter(|name| !recorded.contains(name)).map(String::as_str).collect();
    if missing.is_empty() { String::new() } else { format!("{} are not in the recording.", missing.join(", ")) }
}
