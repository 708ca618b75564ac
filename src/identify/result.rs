//! Result of an identification as plain data.

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
    /// Not determined by the data, or not separately from others: see [`Identification::confused`].
    NotIdentifiable,
    /// Left out as not essential: zero.
    Dropped,
}

/// A base parameter with its estimate.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    /// Standard parameter whose column is kept (leader of the group).
    pub leader: StandardParameter,
    /// Name: `ZZ1R`.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// Grouping formula: `ZZ1R = ZZ1 + ...`.
    pub grouping: String,
    /// Value.
    pub value: f64,
    /// Standard deviation; infinite if the data do not determine the parameter.
    pub std: f64,
    /// Textbook formula, `sigma^2 (W' W)^-1`, with the residual of each sample independent of its
    /// neighbours: too small after a low-pass. For comparison with published figures.
    pub white_std: f64,
    /// Status of the parameter.
    pub standing: Standing,
    /// Value of the robot file, if given.
    pub prior: Option<f64>,
}

impl Estimate {
    /// Creates an estimate from value, standard deviation, and standard deviation of the textbook
    /// formula.
    pub(super) fn of(
        parameter: &BaseParameter,
        [value, std, white_std]: [f64; 3],
        standing: Standing,
        prior: Option<f64>,
    ) -> Self {
        let BaseParameter { leader, name, grouping, unit, .. } = parameter.clone();
        Self { leader, name, unit, grouping, value, std, white_std, standing, prior }
    }

    /// Relative standard deviation `100 std / |value|`, percent.
    pub fn relative_std_percent(&self) -> f64 {
        100.0 * self.std / self.value.abs()
    }
}

/// Parameters that the data do not separate, or not determine at all.
#[derive(Debug, Clone, PartialEq)]
pub struct Confused {
    /// Names of the parameters.
    pub parameters: Vec<String>,
    /// Number of undetermined combinations. If it equals the number of parameters, none of them
    /// affects the data.
    pub open: usize,
}

/// Ratios of the largest to the smallest singular value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Condition {
    /// Condition number of the weighted stack.
    pub weighted: f64,
    /// Condition number of the weighted stack with columns of unit norm: free of units.
    pub scaled: f64,
    /// Condition number of the unweighted stacked regressor, the paper's criterion.
    pub plain: f64,
}

/// Summary of one log.
#[derive(Debug, Clone, PartialEq)]
pub struct LogSummary {
    /// Name of the log.
    pub name: String,
    /// Number of samples used, per joint.
    pub samples: Vec<usize>,
    /// Seconds of motion.
    pub seconds: f64,
    /// Whether the log is used for validation and not for the fit.
    pub validates: bool,
    /// Errors on this log.
    pub accuracy: Accuracy,
}

/// Error of the file, as a share of the torques, above which other readings of the log are tried,
/// percent.
const MISSES: f64 = 70.0;

/// Complete result of an identification.
#[derive(Debug, Clone, PartialEq)]
pub struct Identification {
    /// Name of the robot.
    pub robot: String,
    /// Estimates, one per base parameter, in the order of the regressor's columns.
    pub parameters: Vec<Estimate>,
    /// Correlation of the estimates, row-major, `B * B`; NaN if a parameter has no standard
    /// deviation.
    pub correlation: Vec<f64>,
    /// Noise of the joints, and the number of independent samples.
    pub noise: Noise,
    /// Errors on all fitted logs.
    pub fit: Accuracy,
    /// Errors on all validation logs.
    pub validation: Option<Accuracy>,
    /// Errors of the unchanged robot file, on the fitted logs.
    pub fit_before: Option<Accuracy>,
    /// Errors of the unchanged robot file, on the validation logs.
    pub validation_before: Option<Accuracy>,
    /// Summaries of the logs.
    pub logs: Vec<LogSummary>,
    /// Condition numbers.
    pub condition: Condition,
    /// Parameters that the data do not separate.
    pub confused: Vec<Confused>,
    /// Parameters that were left out, in that order, with the cost.
    pub dropped: Vec<Dropped>,
    /// Rounds until the weights converged.
    pub iterations: usize,
    /// Whether joints were weighted by their noise.
    pub weighted: bool,
    /// Composition of the residual on the fitted logs; `None` if not requested.
    pub budget: Option<ErrorBudget>,
    /// Findings that require a model, such as signs.
    pub findings: Vec<Finding>,
    /// Samples used in the fit, over all joints.
    pub samples: usize,
    /// Independent samples among them: at most as many as the torque's bandwidth allows, and as
    /// many as the residual shows.
    pub independent: f64,
    /// Number of unknowns solved for: parameters minus undetermined combinations.
    pub unknowns: usize,
}

/// Reason why the data do not determine the parameters as a whole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Underdetermined {
    /// There are no more independent equations than unknowns: the fit follows the noise, and no
    /// standard deviation shows this.
    Equations {
        /// Samples, over all joints.
        samples: usize,
        /// Independent samples among them.
        independent: f64,
        /// Number of unknowns.
        unknowns: usize,
    },
    /// Every parameter has a standard deviation larger than its value.
    Spread {
        /// Number of unknowns.
        unknowns: usize,
    },
}

impl Identification {
    /// Values of the base parameters.
    pub fn values(&self) -> Vec<f64> {
        self.parameters.iter().map(|p| p.value).collect()
    }

    /// Whether the log's torques may be misread: a sign contradicts the model, a large part remains
    /// unexplained, logs disagree, or the file misses nearly all.
    pub fn is_suspicious(&self) -> bool {
        let kind = |f: &Finding| matches!(f.kind, Kind::Sign { .. } | Kind::Unexplained { .. } | Kind::Disagree { .. });
        let misses = |a: &Accuracy| a.relative_error_percent() > MISSES;
        self.findings.iter().any(kind) || self.fit_before.iter().chain(&self.validation_before).any(misses)
    }

    /// Replaces findings by the explanations that account for them, one per log.
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

    /// Records that no other order or unit of the torque columns explains the logs.
    pub fn rule_out_columns(&mut self) {
        for finding in &mut self.findings {
            if let Kind::Unexplained { reason: reason @ Unexplained::Open, .. } = &mut finding.kind {
                *reason = Unexplained::Columns;
            }
        }
    }

    /// Reason if the data as a whole are insufficient; some undetermined parameters among
    /// determined ones do not count.
    pub fn underdetermined(&self) -> Option<Underdetermined> {
        let (samples, independent, unknowns) = (self.samples, self.independent, self.unknowns);
        if independent <= unknowns as f64 {
            return Some(Underdetermined::Equations { samples, independent, unknowns });
        }
        let known = |p: &Estimate| p.standing == Standing::Identified && p.relative_std_percent() < 100.0;
        (!self.parameters.iter().any(known)).then_some(Underdetermined::Spread { unknowns })
    }
}
