//! Findings of the quality check in a log: values with figures, location and advice.

use std::fmt;

/// Severity of a finding.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Information only; no action is needed.
    Note,
    /// A defect that was handled as the user allowed, or a possible error.
    Warning,
    /// The log is not used unless the user accepts the finding.
    Fatal,
}

/// Handling of times that are not evenly spaced.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Clock {
    /// Samples are taken as evenly spaced: the stamps jitter, the sampling does not.
    Even,
    /// Samples were interpolated (cubic, 4 points) from their stamps to an even clock.
    Resampled,
    /// Rows were not sampled at their stamps: their times were estimated from an error that is
    /// common to the positions of all joints.
    Found {
        /// Root mean square error of the stamps, s.
        rms: f64,
    },
}

/// Reading of a log's columns that explains its torques.
#[derive(Debug, Clone, PartialEq)]
pub enum Explanation {
    /// The torque columns are in another order.
    Order {
        /// For each joint, the number of the column that holds its torque, counted from 1.
        columns: Vec<usize>,
        /// For each joint, whether that column has the opposite sign.
        negated: Vec<bool>,
    },
    /// The position columns are in another order.
    Positions {
        /// For each joint, the number of the column that holds its position, counted from 1.
        columns: Vec<usize>,
    },
    /// The position columns or the torque columns are in another order.
    PositionsOrTorques {
        /// Affected joints, counted from 1.
        joints: Vec<usize>,
    },
    /// The positions are in degrees.
    Degrees,
    /// The torques are motor torques before the gears.
    MotorSide,
    /// The torques are in another unit.
    Unit {
        /// Factor by which the numbers exceed the torque in N m.
        times: f64,
    },
}

impl Explanation {
    /// Description as a sentence without a full stop.
    fn what(&self) -> String {
        match self {
            Self::Order { columns, negated } => {
                let of = |(joint, column): (usize, &usize)| {
                    let sign = if negated[joint] { ", with the other sign" } else { "" };
                    let moved = *column != joint + 1 || negated[joint];
                    moved.then(|| format!("the torque of joint {} stands in `tau{column}`{sign}", joint + 1))
                };
                let places: Vec<String> = columns.iter().enumerate().filter_map(of).collect();
                format!("torque columns stand in another order{}: {}", sorted_as_text(columns), places.join(", "))
            }
            Self::Positions { columns } => {
                let of = |(joint, column): (usize, &usize)| {
                    let moved = *column != joint + 1;
                    moved.then(|| format!("the position of joint {} stands in `q{column}`", joint + 1))
                };
                let places: Vec<String> = columns.iter().enumerate().filter_map(of).collect();
                format!("position columns stand in another order{}: {}", sorted_as_text(columns), places.join(", "))
            }
            Self::PositionsOrTorques { joints } => {
                let joints: Vec<String> = joints.iter().map(usize::to_string).collect();
                format!(
                    "the columns of joints {} stand in another order, those of the positions or those of the torques (this log does not say which)",
                    joints.join(", ")
                )
            }
            Self::Degrees => "positions are in degrees".into(),
            Self::MotorSide => "torques are those of the motors, before the gears".into(),
            Self::Unit { times } => {
                let near = |of: f64| (0.4..2.5).contains(&(times / of));
                let unit = match () {
                    () if near(1e3) => ": N mm, or a thousandth of another unit (mA)",
                    () if near(1e-3) => ": kN m",
                    () if near(57.3) || near(1.0 / 57.3) => ": a factor of 180/pi too many or too few",
                    () => ": currents, percent, or motor-side torques",
                };
                format!("torques are not in N m at the joint: they are {} times the model's{unit}", short(*times))
            }
        }
    }

    /// The description followed by the evidence for it.
    fn sentence(&self, log: Option<&str>, [recorded, read]: [f64; 2]) -> String {
        let log = log.map_or(String::new(), |log| format!("{log}: "));
        format!(
            "{log}{}. So read the model leaves {read:.0} % of the torques, as recorded {recorded:.0} %",
            self.what()
        )
    }

    /// Advice on how to fix the log.
    fn advice(&self) -> &'static str {
        match self {
            Self::Order { .. } | Self::Positions { .. } | Self::PositionsOrTorques { .. } => "rename the columns",
            Self::Degrees => "write radians",
            Self::MotorSide => {
                "multiply each by its gear ratio, or call the columns `taum` if they are on the joint side"
            }
            Self::Unit { .. } => {
                "write N m of the joint side of the gear; for currents name the columns `i1..` and give the joints a `torque_constant`"
            }
        }
    }
}

/// Note for columns in the order of names that were sorted as text; otherwise empty.
fn sorted_as_text(columns: &[usize]) -> &'static str {
    let mut names: Vec<usize> = (1..=columns.len()).collect();
    names.sort_by_key(usize::to_string);
    let sorted = columns.iter().enumerate().all(|(joint, column)| names[column - 1] == joint + 1);
    if sorted { " (the order of names that are sorted as text: 1, 10, 11, 2)" } else { "" }
}

/// Formats a number with about three digits.
fn short(x: f64) -> String {
    if (0.01..1e4).contains(&x.abs()) {
        format!("{:.*}", usize::from(x.abs() < 10.0) * 2, x)
    } else {
        format!("{x:.1e}")
    }
}

impl Clock {
    fn what(&self) -> String {
        match self {
            Self::Even => "samples taken as evenly spaced (smoother so)".into(),
            Self::Resampled => "samples interpolated to an even clock (cubic)".into(),
            Self::Found { rms } => format!(
                "rows were not sampled at their stamps, which are wrong by {:.2} ms RMS: every joint errs along its own velocity by the same time; the times were found from that",
                1e3 * rms
            ),
        }
    }
}

/// Known reason why a fitted model leaves a large part of a torque unexplained.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unexplained {
    /// The robot file has no friction for the joint.
    NoFriction,
    /// Other column orders, units and signs were tried, and none explains the torque.
    Columns,
    /// Nothing was tried.
    Open,
}

impl Unexplained {
    fn advice(self) -> &'static str {
        match self {
            Self::NoFriction => {
                "the robot file has no friction of this joint: give its `drive` a `friction` with levels of 0, as `denavit new` writes it, and they are identified; if that is not it, `denavit diagnose` looks for what the model lacks"
            }
            Self::Columns => {
                "no other order or unit of the columns explains it; `denavit diagnose` looks for what the model lacks, and look whether the log is of this robot"
            }
            Self::Open => {
                "look for columns that were swapped, a wrong sign or unit, another robot's log; `denavit diagnose` looks for what the model lacks"
            }
        }
    }
}

/// Kind of a finding. Times in s, levels in the column's unit.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Kind {
    /// Columns with names outside the log format.
    UnknownColumns {
        /// Names of the columns.
        names: Vec<String>,
    },
    /// An empty cell, NaN or infinity.
    NotFinite,
    /// Text where a number should be.
    NotANumber {
        /// Text of the cell.
        text: String,
    },
    /// A row with another number of cells than the header.
    RowLength {
        /// Number of cells, as text.
        text: String,
    },
    /// A time that is less than that of the previous row.
    TimeRunsBack {
        /// Time of the previous row.
        from: f64,
        /// Time of this row.
        to: f64,
    },
    /// A time that equals that of the previous row.
    DuplicateTime {
        /// Time that is repeated.
        at: f64,
    },
    /// Rows are missing.
    Gap {
        /// Longest step.
        longest: f64,
        /// Usual step.
        period: f64,
    },
    /// Many steps differ far from the usual one.
    IrregularClock {
        /// Median step.
        period: f64,
        /// Share of steps off by more than half a period.
        share: f64,
    },
    /// Steps vary slightly, as is normal for a recorder.
    Jitter {
        /// Median step.
        period: f64,
        /// Rms deviation from the median step.
        rms: f64,
        /// Shortest step.
        shortest: f64,
        /// Longest step.
        longest: f64,
    },
    /// How an uneven clock was handled.
    Evened {
        /// Handling of the uneven times.
        clock: Clock,
    },
    /// A value that stayed constant and then jumped.
    Stuck {
        /// Constant value before the jump.
        value: f64,
        /// Longest time at a constant value, s.
        seconds: f64,
    },
    /// A value that saturates.
    Clipped {
        /// Saturation level.
        level: f64,
        /// Number of samples at that level.
        samples: usize,
    },
    /// A torque that is zero throughout.
    DeadTorque,
    /// Positions that look like degrees.
    Degrees {
        /// Largest magnitude of the positions.
        largest: f64,
    },
    /// The joint's torque fits the model better with the opposite sign.
    Sign {
        /// Correlation of measured and predicted torque, or that of the fit, with the sign as
        /// recorded.
        correlation: f64,
    },
    /// The model explains the log far better if the columns are read in another way.
    Misread {
        /// The better reading.
        explanation: Explanation,
        /// Name of the log, if several were read.
        log: Option<String>,
        /// Residual torques (root mean square, all joints weighted equally) as recorded and with
        /// this reading, percent.
        percent: [f64; 2],
    },
    /// A segment shorter than the filter needs; left out.
    ShortSegments {
        /// Number of samples that were left out.
        samples: usize,
    },
    /// A position or torque far beyond the limits of the joint in the robot file.
    BeyondLimit {
        /// Largest value of the log.
        reaches: f64,
        /// Limit of the robot file.
        limit: f64,
        /// Unit of both values.
        unit: &'static str,
    },
    /// Torques far beyond the limits of most joints.
    TorqueUnit {
        /// Largest torque, as a multiple of the joint's limit.
        times: f64,
        /// Whether all torques are within the limits if divided by a thousand.
        thousandth: bool,
    },
    /// A joint whose torque is largely unexplained by the fitted model.
    Unexplained {
        /// Unexplained part of the joint's torque (root mean square), percent.
        percent: f64,
        /// Reason, if known.
        reason: Unexplained,
    },
    /// Logs that contradict each other.
    Disagree {
        /// Residual of a common fit relative to that of separate fits (root mean square).
        times: f64,
        /// The log that disagrees most with the others, if it can be identified.
        worst: Option<String>,
    },
    /// Torques computed from motor currents and gains.
    FromCurrents {
        /// Gain of each joint, N m per A.
        gains: Vec<f64>,
    },
    /// A validation log that an earlier command used for fitting.
    FittedBefore {
        /// Name of the log in that command.
        path: String,
    },
    /// No joint moves beyond the noise of its encoder.
    Standstill,
    /// Too few samples for a fit.
    TooFew {
        /// Number of samples.
        samples: usize,
    },
    /// A very long log.
    VeryLong {
        /// Number of samples.
        samples: usize,
    },
}

/// A finding in a log, with its location.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// Kind of the finding.
    pub kind: Kind,
    /// Severity, given the findings that the user accepted.
    pub severity: Severity,
    /// Line of the first occurrence.
    pub line: Option<u64>,
    /// Name of the column.
    pub column: Option<String>,
    /// Number of occurrences.
    pub count: usize,
}

impl Finding {
    /// Whether the log is rejected because of it.
    pub fn is_fatal(&self) -> bool {
        self.severity == Severity::Fatal
    }

    /// Name in [`super::Acceptance`] that accepts the finding, if there is one.
    pub fn allowed_by(&self) -> Option<&'static str> {
        Some(match self.kind {
            Kind::NotFinite | Kind::NotANumber { .. } | Kind::RowLength { .. } => "bad-rows",
            Kind::TimeRunsBack { .. } => "restarts",
            Kind::DuplicateTime { .. } => "duplicates",
            Kind::Gap { .. } => "gaps",
            Kind::IrregularClock { .. } => "irregular-clock",
            Kind::Stuck { .. } => "stuck",
            Kind::Clipped { .. } => "clipped",
            Kind::DeadTorque => "dead-torque",
            Kind::Degrees { .. } => "large-angles",
            Kind::TorqueUnit { .. } => "torque-unit",
            Kind::Misread { .. } => "misread",
            _ => return None,
        })
    }

    /// Description of the finding without its location.
    pub fn what(&self) -> String {
        let times = if self.count > 1 { format!(", {} times", self.count) } else { String::new() };
        match &self.kind {
            Kind::UnknownColumns { names } => format!("columns that are not used: {}", names.join(", ")),
            Kind::NotFinite => format!("an empty cell, NaN or infinity{times}"),
            Kind::NotANumber { text } => format!("`{text}` is not a number{times}"),
            Kind::RowLength { text } => format!("the row has {text}{times}"),
            Kind::TimeRunsBack { from, to } => format!("time runs back from {from} to {to} s{times}"),
            Kind::DuplicateTime { at } => format!("the time {at} s stands there again{times}"),
            Kind::Gap { longest, period } => {
                format!("a gap of {longest:.4} s in a clock of {period:.4} s{times}")
            }
            Kind::IrregularClock { period, share } => format!(
                "the clock is irregular: {:.1} % of the steps are off the median of {period:.5} s by more than half",
                100.0 * share
            ),
            Kind::Jitter { period, rms, shortest, longest } => format!(
                "steps of {:.3} to {:.3} ms, median {:.3} ms, rms deviation {:.2} %",
                1e3 * shortest,
                1e3 * longest,
                1e3 * period,
                100.0 * rms / period
            ),
            Kind::Evened { clock } => clock.what(),
            Kind::Stuck { value, seconds } => {
                format!("stands still at {} for up to {seconds:.3} s{times}", plain(*value))
            }
            Kind::Clipped { level, samples } => format!("is cut off at {} ({samples} samples)", plain(*level)),
            Kind::DeadTorque => "is zero throughout: the sensor was off".into(),
            Kind::Degrees { largest } => format!("reaches {largest:.1}, which looks like degrees"),
            Kind::Sign { correlation } => {
                format!("has probably the wrong sign (correlation with the model {correlation:.2})")
            }
            Kind::Misread { explanation, log, percent } => explanation.sentence(log.as_deref(), *percent),
            Kind::ShortSegments { samples } => {
                format!("segments too short to be filtered were left out: {samples} samples{times}")
            }
            Kind::BeyondLimit { reaches, limit, unit } => {
                format!("reaches {reaches:.4} {unit}, where the robot file's limit is {limit:.4} {unit}")
            }
            Kind::TorqueUnit { times, thousandth } => torque_unit(*times, *thousandth),
            Kind::Unexplained { percent, .. } => {
                format!("the fitted model leaves {percent:.0} % of the torque unexplained")
            }
            Kind::Disagree { times, worst } => disagree(*times, worst.as_deref()),
            Kind::FromCurrents { gains } => {
                let gains: Vec<String> = gains.iter().map(f64::to_string).collect();
                format!("torques are the motor currents times {} N m/A, joint by joint", gains.join(", "))
            }
            Kind::FittedBefore { path } => format!(
                "this log was fitted when the robot file was made (as {path}): the file's figures on it are no validation"
            ),
            Kind::Standstill => "no joint moves: only gravity in this posture can be determined".into(),
            Kind::TooFew { samples } => format!("only {samples} samples"),
            Kind::VeryLong { samples } => format!("{samples} samples"),
        }
    }

    /// Advice on what to do; empty if nothing needs to be done.
    pub fn advice(&self) -> String {
        let mend = match &self.kind {
            Kind::UnknownColumns { .. } => "rename them if they are meant",
            Kind::NotFinite | Kind::NotANumber { .. } | Kind::RowLength { .. } => "mend the cell or leave the row out",
            Kind::TimeRunsBack { .. } => "number the recordings in a column `seg`",
            Kind::DuplicateTime { .. } => "record time with more digits, or leave the rows out",
            Kind::Gap { .. } => "number the parts in a column `seg`, or let the log be split there",
            Kind::IrregularClock { .. } => "record at a fixed rate, or let the log be resampled",
            Kind::Stuck { .. } => "look at the sensor or the recorder; cut the stretch out",
            Kind::Clipped { .. } => "play a gentler motion, or cut those stretches out",
            Kind::DeadTorque => "take another torque column (`taum`) or another log",
            Kind::Degrees { .. } => "write radians",
            Kind::Sign { .. } => {
                "compare the joint's positive direction with the robot file; negate the column if it is so"
            }
            Kind::Misread { explanation, .. } => explanation.advice(),
            Kind::BeyondLimit { unit: "rad" | "m", .. } => {
                "look whether the columns are in the robot's order, in rad or m, and of this robot"
            }
            Kind::BeyondLimit { .. } => "look whether torques are in N m on the joint side, and of this robot",
            Kind::TorqueUnit { .. } => "write N m of the joint side of the gear",
            Kind::Unexplained { reason, .. } => reason.advice(),
            Kind::Disagree { .. } => {
                "look whether all are of this robot, with the same tool, and with columns and units alike; identify them apart to see which is wrong"
            }
            Kind::FittedBefore { .. } => "validate on a separate recording",
            Kind::Standstill => "record a motion of all joints: `denavit excite` designs one",
            Kind::ShortSegments { .. } => "",
            Kind::TooFew { .. } => "record some seconds with all joints moving",
            Kind::VeryLong { .. } => "decimate if it takes too long",
            Kind::Jitter { .. } | Kind::Evened { .. } | Kind::FromCurrents { .. } => "",
        };
        match self.allowed_by() {
            Some(name) if self.is_fatal() => format!("{mend}, or allow it: --keep {name}"),
            _ => mend.into(),
        }
    }
}

fn torque_unit(times: f64, thousandth: bool) -> String {
    let unit = match thousandth {
        true => "; a thousandth of them would be within the limits, so they are probably in N mm, or currents in mA",
        false => "",
    };
    format!("torques reach {times:.0} times the limits of the robot file: they are not in N m at its joints{unit}")
}

fn disagree(times: f64, worst: Option<&str>) -> String {
    let worst = worst.map_or(String::new(), |log| format!("; most at odds with the others is {log}"));
    format!(
        "the logs contradict each other: fitted together they leave {times:.1} times the error of each fitted alone{worst}"
    )
}

/// Formats a number with the fewest digits that represent it.
fn plain(x: f64) -> String {
    if x == 0.0 || (1e-4..1e6).contains(&x.abs()) { format!("{x}") } else { format!("{x:e}") }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(line) = self.line {
            write!(f, "line {line}: ")?;
        }
        if let Some(column) = &self.column {
            write!(f, "column `{column}`: ")?;
        }
        write!(f, "{}", self.what())?;
        match self.advice() {
            advice if advice.is_empty() => Ok(()),
            advice => write!(f, " ({advice})"),
        }
    }
}
