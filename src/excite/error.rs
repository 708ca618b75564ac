//! Errors of planning, designing and checking motions.

/// Reason why a robot's limits do not bound a motion.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LimitsError {
    /// A joint has no speed limit.
    #[error("joint {0} has no `velocity` limit; a motion can't be planned without one: write it in the robot file")]
    Velocity(String),
    /// Several joints have no speed limit.
    #[error(
        "joints {} have no `velocity` limits; a motion can't be planned without them: write them in the robot file",
        .0.join(", ")
    )]
    Velocities(Vec<String>),
    /// A prismatic joint has no position limits.
    #[error("joint {0} slides and has no `position` limits; write them in the robot file")]
    Position(String),
    /// All joints are fixed.
    #[error("this robot has no joint that moves")]
    NoJoint,
}

/// Reason why no motion was designed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum DesignError {
    /// Every posture violates a constraint; description for the best one.
    #[error(
        "no posture keeps clear of everything: {0} at best; check `position` limits, `collision` and `torque` in the robot file"
    )]
    Blocked(String),
    /// There was no starting motion.
    #[error("no start was made")]
    NoStart,
    /// The variables do not define a motion.
    #[error("the variables are no motion")]
    NoMotion,
    /// The motion does not determine these columns.
    #[error(
        "the motion has no information on {}; make it longer, or leave the drives out with --links-only",
        .0.join(", ")
    )]
    Uninformative(Vec<String>),
    /// No motion of this arm determines these columns; `payload`: those of the payload.
    #[error(
        "no motion of this arm separates {}: its torques depend on fewer combinations of them{}",
        columns.join(", "),
        if *payload { "; identify the whole robot with the tool in its hand instead, without --tool" } else { "" }
    )]
    Inseparable {
        /// Names of the columns.
        columns: Vec<String>,
        /// Whether they are those of the payload.
        payload: bool,
    },
}

/// Reason why there is no shortest motion.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ShortestError {
    /// Fourier series have no way points.
    #[error("a target needs splines")]
    Splines,
    /// No motion was designed.
    #[error(transparent)]
    Design(#[from] DesignError),
    /// The longest motion misses the target.
    #[error(
        "{duration} s do not reach {target} %: {parameter} stays at {reached:.1} %; allow a longer --duration, or give what is known"
    )]
    Missed {
        /// Longest duration, s.
        duration: f64,
        /// Required relative standard deviation, percent.
        target: f64,
        /// Name of the worst parameter.
        parameter: String,
        /// Its relative standard deviation, percent.
        reached: f64,
    },
    /// The tool of the file has no inertial parameters.
    #[error(
        "a share of what? The robot file has no body in the hand; write the nominal `M`, `MS` and `I` under `tool`"
    )]
    NoBody,
    /// The links of the file have no inertial parameters.
    #[error(
        "a share of what? The robot file has no inertial parameters of all links; write nominal ones under `links`"
    )]
    NoLinks,
    /// No parameter is essential.
    #[error(
        "no parameter's share in a torque stands out of the noise, however long the motion: none is essential; give the noise that the low-pass leaves with --noise"
    )]
    NoEssential,
}

/// Reason why the rows of a file are no motion of a robot.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MotionError {
    /// Too few rows.
    #[error("{0} rows are no motion; at least three are needed")]
    Rows(usize),
    /// Times do not ascend.
    #[error("time does not ascend in row {row}: {time} after {before}")]
    Time {
        /// Row, from 1.
        row: usize,
        /// Time of the row, s.
        time: f64,
        /// Time of the row before, s.
        before: f64,
    },
    /// A row has the wrong width or a value that is not finite.
    #[error("every row needs {0} finite positions (and as many velocities and accelerations, if any)")]
    Width(usize),
}
