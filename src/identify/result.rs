//! Result of an identification: plain data.

use super::Accuracy;
use super::Dropped;
use super::ErrorBudget;
use super::Noise;
use crate::data::log::{Finding, Kind, Unexplained};
use crate::model::{BaseParameter, StandardParameter};

/// Status of a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Standing {
    /// Estimated, with a standard deviation.
    Identified,
    /// The data do not determine it, or not separately from others: see
    /// [`Identification::confused`].
    NotIdentifiable,
    /// Left out as not essential: zero.
    Dropped,
}

/// A base parameter with its estimate.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    /// The standard parameter whose column it keeps.
    pub leader: StandardParameter,
    /// Name: `ZZ1R`.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// `ZZ1R = ZZ1 + ...`.
    pub grouping: String,
    /// Value.
    pub value: f64,
    /// Standard deviation; infinite where the data do not determine the parameter.
    pub std: f64,
    /// Textbook's formula, `sigma^2 (W' W)^-1` with the residual of each sample independent of its
    /// neighbours: too small after a low-pass. For comparison with published figures.
    pub white_std: f64,
    /// Its status.
    pub standing: Standing,
    /// Value of the robot file, where it was given.
    pub prior: Option<f64>,
}

impl Estimate {
    /// Of this parameter: value, standard deviation, and that of the textbook's formula.
    pub(super) fn of(
        parameter: &BaseParameter,
        [value, std, white_std]: [f64; 3],
        standing: Standing,
        prior: Option<f64>,
    ) -> Self {
        let BaseParameter { leader, name, grouping, unit, .. } = parameter.clone();
        Self { leader, name, unit, grouping, value, std, white_std, standing, prior }
    }

    /// `100 std / |value|`.
    pub fn relative_std_percent(&self) -> f64 {
        100.0 * self.std / self.value.abs()
    }
}

/// Parameters that the data do not separate, or not determine at all.
#[derive(Debug, Clone, PartialEq)]
pub struct Confused {
    /// Names.
    pub parameters: Vec<String>,
    /// How many combinations of them are open. As many as parameters: none of them acts in this
    /// data.
    pub open: usize,
}

/// Ratios of the largest to the smallest singular value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Condition {
    /// Of the weighted stack.
    pub weighted: f64,
    /// Of the weighted stack with columns of unit norm: free of units.
    pub scaled: f64,
    /// Condition number of the unweighted stacked regressor, the paper's criterion.
    pub plain: f64,
}

/// One log in the form used.
#[derive(Debug, Clone, PartialEq)]
pub struct LogSummary {
    /// Name.
    pub name: String,
    /// Samples used, per joint.
    pub samples: Vec<usize>,
    /// Seconds of motion.
    pub seconds: f64,
    /// Whether it validates, not fits.
    pub validates: bool,
    /// Errors on this log.
    pub accuracy: Accuracy,
}

/// Error of the file, as a share of the torques, from which on another reading of the log is tried,
/// percent.
const MISSES: f64 = 70.0;

/// All that was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Identification {
    /// The robot's name.
    pub robot: String,
    /// One per base parameter, in the order of the regressor's columns.
    pub parameters: Vec<Estimate>,
    /// Correlation of the estimates, row-major, `B * B`; NaN where a parameter has no standard
    /// deviation.
    pub correlation: Vec<f64>,
    /// Noise of the joints and how independent its samples are.
    pub noise: Noise,
    /// Errors on all fitted logs.
    pub fit: Accuracy,
    /// Errors on all validating logs.
    pub validation: Option<Accuracy>,
    /// Errors of the unchanged robot file, on the fitted logs.
    pub fit_before: Option<Accuracy>,
    /// Errors of the unchanged robot file, on the validating logs.
    pub validation_before: Option<Accuracy>,
    /// Each log.
    pub logs: Vec<LogSummary>,
    /// Condition numbers.
    pub condition: Condition,
    /// Parameters that the data do not separate.
    pub confused: Vec<Confused>,
    /// Parameters that were left out, in the order of their going, and what it cost.
    pub dropped: Vec<Dropped>,
    /// Rounds until the weights settled.
    pub iterations: usize,
    /// Whether joints were weighted by their noise.
    pub weighted: bool,
    /// Composition of the residual on the fitted logs; `None` if not requested.
    pub budget: Option<ErrorBudget>,
    /// Suspicions that need a model: signs.
    pub findings: Vec<Finding>,
    /// Samples used in the fit, over all joints.
    pub samples: usize,
    /// Independent ones among them: at most as many as the band of the torque has room for, and as
    /// the residual shows.
    pub independent: f64,
    /// Unknowns that were solved for: parameters, less the combinations that are open.
    pub unknowns: usize,
}

/// Why data do not determine the parameters, as a whole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Underdetermined {
    /// Fewer independent equations than unknowns: the fit follows the noise, and no standard
    /// deviation shows it.
    Equations {
        /// Samples, over all joints.
        samples: usize,
        /// Independent ones among them.
        independent: f64,
        /// Unknowns.
        unknowns: usize,
    },
    /// Every parameter has a standard deviation larger than itself.
    Spread {
        /// Unknowns.
        unknowns: usize,
    },
}

impl Identification {
    /// The base parameters' values.
    pub fn values(&self) -> Vec<f64> {
        self.parameters.iter().map(|p| p.value).collect()
    }

    /// Whether the log's torques may be misread: a sign that contradicts the model, much that no
    /// parameters explain, or a file that misses nearly all.
    pub fn is_suspicious(&self) -> bool {
        let kind = |f: &Finding| matches!(f.kind, Kind::Sign { .. } | Kind::Unexplained { .. } | Kind::Disagree { .. });
        let misses = |a: &Accuracy| a.relative_error_percent() > MISSES;
        self.findings.iter().any(kind) || self.fit_before.iter().chain(&self.validation_before).any(misses)
    }

    /// Puts explanations, each of a log, in the place of the suspicions that they account for.
    pub fn take_explanations(&mut self, explained: Vec<(String, Finding)>) {
        if explained.is_empty() {
            return;
        }
        self.findings.retain(|f| !matches!(f.kind, Kind::Sign { .. } | Kind::Unexplained { .. }));
        for (log, mut finding) in explained {
            if let Kind::Misread { log: of, .. } = &mut finding.kind {
                *of = Some(log);
            }
            self.findings.insert(0, finding);
        }
    }

    /// Takes note that no other order or unit of the torque columns explains the logs.
    pub fn rule_out_columns(&mut self) {
        for finding in &mut self.findings {
            if let Kind::Unexplained { reason: reason @ Unexplained::Open, .. } = &mut finding.kind {
                *reason = Unexplained::Columns;
            }
        }
    }

    /// Whether the data determine nothing; some open parameters beside others that are known are no
    /// such case.
    pub fn underdetermined(&self) -> Option<Underdetermined> {
        let (samples, independent, unknowns) = (self.samples, self.independent, self.unknowns);
        if independent <= unknowns as f64 {
            return Some(Underdetermined::Equations { samples, independent, unknowns });
        }
        let known = |p: &Estimate| p.standing == Standing::Identified && p.relative_std_percent() < 100.0;
        (!self.parameters.iter().any(known)).then_some(Underdetermined::Spread { unknowns })
    }
}
