//! Reasons why the channels of a file can't be mapped to the columns of the log format.

use super::UnitError;

/// Reason why the channels of a file can't be mapped to the columns of the log format.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MappingError {
    /// The entry's column does not exist in the log format.
    #[error("`{0}` is no column; columns are t, seg, q1.., dq1.., tau1.., i1.., fx .. mz, or q* for all joints")]
    NoColumn(String),
    /// The entry has a star, but its quantity is not a joint quantity.
    #[error("`{0}` is no column of the joints; they are q*, dq*, ddq*, qm*, qd*, tau*, taum*, i*, temp*")]
    NoJointColumn(String),
    /// The entry is for all joints but names a single channel.
    #[error("`{0}` is for all joints: its channel needs {{joint}}, {{number}} or {{index}} in its name")]
    OneChannel(String),
    /// The channel is given by joint name, and there is no robot file.
    #[error("{{joint}} needs the robot file: give --robot ROBOT")]
    NoRobot,
    /// Two entries map to the same column.
    #[error("the mapping gives `{0}` twice")]
    Twice(String),
    /// The number of values is neither one nor the number of joints.
    #[error("`{column}` has {count} values of `{what}`: give one, or one for each joint")]
    Values {
        /// Column of the entry.
        column: String,
        /// Number of values given.
        count: usize,
        /// Name of the setting: `gain` or `offset`.
        what: &'static str,
    },
    /// The log lacks the channel.
    #[error(
        "the mapping takes `{column}` from `{channel}`, which the log does not have; it has {}{}",
        .near.join(", "),
        if *.more { ", ..." } else { "" }
    )]
    Absent {
        /// Column of the entry.
        column: String,
        /// Missing channel.
        channel: String,
        /// Most similar names in the log.
        near: Vec<String>,
        /// Whether the log has other names besides.
        more: bool,
    },
    /// The unit does not fit the column.
    #[error(transparent)]
    Unit(#[from] UnitError),
    /// The recording names its joints, and there is no robot file.
    #[error(
        "the recording names its joints ({}); the robot file says which is which: give --robot ROBOT",
        .0.join(", ")
    )]
    NamedJoints(Vec<String>),
    /// No topic of the recording has all joints of the robot file.
    #[error(
        "no topic has the positions of all joints: the recording has {}, the robot file {}; {} Give the joints of the robot file these names, or a mapping \
         (--map; `denavit log inspect` proposes one)",
        .recorded.join(", "),
        .expected.join(", "),
        not_recorded(.recorded, .expected)
    )]
    OtherJoints {
        /// Joints of the recording, at most twenty.
        recorded: Vec<String>,
        /// Joints of the robot file.
        expected: Vec<String>,
    },
    /// Several topics of the recording have the positions of all joints.
    #[error(
        "positions of all joints are on {}; choose one in a mapping (--map), for example `q*: {{ channel: \"{}/position/{{joint}}\" }}`",
        .0.join(" and "),
        .0.first().map_or("", String::as_str)
    )]
    SeveralTopics(Vec<String>),
}

/// Lists, as a sentence, the joints that the recording lacks.
fn not_recorded(recorded: &[String], expected: &[String]) -> String {
    let missing: Vec<&str> = expected.iter().filter(|name| !recorded.contains(name)).map(String::as_str).collect();
    if missing.is_empty() { String::new() } else { format!("{} are not in the recording.", missing.join(", ")) }
}
