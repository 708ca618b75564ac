//! Result of a diagnosis: plain data.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects::{self, Key};

use crate::diagnose::hypotheses::{Named, Quantity};
use crate::identify::ErrorBudget;

/// The whole in a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// The causes leave nothing but noise.
    Explained,
    /// The causes leave structure.
    PartlyExplained,
    /// There is structure, and no cause holds.
    Unexplained,
    /// There is nothing but noise.
    NothingWrong,
}

/// Data on which errors were measured, in words: `on` as a [`Cause`] has it.
pub fn measured_on(on: &str, own_validation: bool) -> &'static str {
    match (on, own_validation) {
        ("fit", true) => "the fitted logs",
        ("fit", false) => "the fitted part of the logs",
        (_, true) => "the validating logs",
        (_, false) => "the part of the logs that was kept out of the fit",
    }
}

impl Verdict {
    /// The word of the JSON.
    pub fn word(self) -> &'static str {
        match self {
            Self::Explained => "explained",
            Self::PartlyExplained => "partly_explained",
            Self::Unexplained => "unexplained",
            Self::NothingWrong => "nothing_wrong",
        }
    }
}

/// Root mean square errors of a model, per joint, N m.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Errors {
    /// On the logs that were used to find it.
    pub fit: Vec<f64>,
    /// On those that were not.
    pub validate: Vec<f64>,
    /// The same where the joint moves. While a joint sticks at a reversal, friction balances the
    /// other torques and is not a function of the velocity.
    pub moving: Vec<f64>,
}

/// A curve of the evidence: what the cause has to explain against what it says, over the quantity
/// that shows it best.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Evidence {
    /// Name of the abscissa, with its unit.
    pub over: String,
    /// Abscissa: middles of bins.
    pub x: Vec<f64>,
    /// Mean error without the cause in each bin, N m.
    pub measured: Vec<f64>,
    /// Mean of what the cause contributes, N m.
    pub explained: Vec<f64>,
}

/// A cause that was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Cause {
    /// Name of the effect, or `unknown`.
    pub cause: &'static str,
    /// Joints, from 1; empty for the whole robot.
    pub joints: Vec<usize>,
    /// How sure it is.
    pub probability: f64,
    /// Its parameters; symbols carry the joint's number.
    pub parameters: Vec<Quantity>,
    /// The same without the joint's number, for the robot file.
    pub keys: Vec<Named>,
    /// Twice the gain in log-likelihood over independent windows, less what its unknowns and the
    /// number of candidates cost.
    pub support: f64,
    /// By how much less the next best cause in its place has of that.
    pub margin: f64,
    /// Part of the squared error of its main joint, above the noise, that it takes.
    pub share: f64,
    /// How it recurs in disjoint stretches of the fitted logs, 0 to 1: 1 with the same size in
    /// each.
    pub recurrence: f64,
    /// A sentence with figures.
    pub evidence: String,
    /// Errors with all causes but this one, per joint, N m.
    pub rms_before: Vec<f64>,
    /// Errors with it.
    pub rms_after: Vec<f64>,
    /// 90 % interval of the part of the squared error that it takes on its main joint.
    pub interval: [f64; 2],
    /// `validate`, or `fit` for what acts in one log only.
    pub on: &'static str,
    /// Whether the extended model has it; otherwise it was found beside other links than that
    /// model's, or did not pay there.
    pub in_extended: bool,
    /// Causes that this data can't separate from it.
    pub not_distinguished_from: Vec<&'static str>,
    /// Experiment that would show it better, or separate it from those.
    pub shown_by: &'static str,
    /// What would tell it from those, where no motion does.
    pub decided_by: Option<&'static str>,
    /// The curve that shows it.
    pub curve: Option<Evidence>,
    /// The torque that the model lacks on its joint in closed form, for an error without a name: an
    /// expression in `q1.. dq1.. ddq1..`.
    pub law: Option<String>,
}

impl Cause {
    /// Whether another cause is the same one in the same place. A push is not another one, nor the
    /// wall that is met beside it: windows of one push overlap for half of the shorter.
    pub fn is(&self, other: &Self) -> bool {
        let overlap = |a: [f64; 2], b: [f64; 2]| a[1].min(b[1]) - a[0].max(b[0]);
        let shorter = |a: [f64; 2], b: [f64; 2]| (a[1] - a[0]).min(b[1] - b[0]);
        let together = match (self.window(), other.window()) {
            (Some(one), Some(other)) => 2.0 * overlap(one, other) >= shorter(one, other),
            (one, other) => one == other,
        };
        self.cause == other.cause && self.joints == other.joints && together
    }

    /// Begin and end of a push, s since its log began; `None` of what acts throughout.
    pub(in crate::diagnose) fn window(&self) -> Option<[f64; 2]> {
        let of = |key: Key| self.keys.iter().find(|named| named.symbol == key.into()).map(|named| named.value);
        Some([of(effects::ExternalContact::START)?, of(effects::ExternalContact::END)?])
    }

    /// One of which nothing is known but its name and the experiment that would show it.
    pub(in crate::diagnose) fn blank(cause: &'static str, shown_by: &'static str) -> Self {
        Self {
            cause,
            shown_by,
            decided_by: None,
            joints: Vec::new(),
            probability: 0.0,
            parameters: Vec::new(),
            keys: Vec::new(),
            support: 0.0,
            margin: 0.0,
            share: 0.0,
            recurrence: 1.0,
            evidence: String::new(),
            rms_before: Vec::new(),
            rms_after: Vec::new(),
            interval: [f64::NAN; 2],
            on: "fit",
            not_distinguished_from: Vec::new(),
            law: None,
            in_extended: true,
            curve: None,
        }
    }

    /// Whether it is a torque in closed form that the offered model has.
    pub fn has_law(&self) -> bool {
        self.law.is_some() && self.in_extended
    }
}

/// Experiment that would resolve the open questions.
#[derive(Debug, Clone, PartialEq)]
pub struct NextExperiment {
    /// The causes to separate.
    pub between: Vec<&'static str>,
    /// Joints, from 1.
    pub joints: Vec<usize>,
    /// The motion, in words.
    pub motion: String,
}

/// Measured torque and errors over time, for drawing: of one joint, thinned.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Curve {
    /// Time, s; one log after the other.
    pub t: Vec<f64>,
    /// Measured torque, N m.
    pub measured: Vec<f64>,
    /// Error of the unchanged file, N m.
    pub before: Vec<f64>,
    /// Error of the extended model, N m.
    pub after: Vec<f64>,
}

/// Error against a quantity, before and after: of one joint, on the validating data.
#[derive(Debug, Clone, PartialEq)]
pub struct ErrorMap {
    /// Name of the abscissa, with its unit; against `frequency, Hz` the ordinates are amplitudes,
    /// otherwise means of bins.
    pub over: &'static str,
    /// Abscissa.
    pub x: Vec<f64>,
    /// Error of the unchanged file, N m.
    pub before: Vec<f64>,
    /// Error of the extended model, N m.
    pub after: Vec<f64>,
}

/// The nested model that is offered as the extended one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Offered {
    /// The unchanged file.
    File,
    /// All parameters refitted, without any further cause.
    Refitted,
    /// The model with all causes that hold.
    Extended,
}

impl Offered {
    /// The word of the JSON.
    pub fn word(self) -> &'static str {
        match self {
            Self::File => "file",
            Self::Refitted => "refitted",
            Self::Extended => "extended",
        }
    }
}

/// Why a model is offered: errors on stretches of the fitted logs that were left out in turn.
#[derive(Debug, Clone, PartialEq)]
pub struct Offer {
    /// The model.
    pub offered: Offered,
    /// Root mean square over joints of the file's, the refitted and the extended model's errors
    /// there, N m.
    pub left_out: [f64; 3],
    /// Why, and what left the model: sentences.
    pub why: Vec<String>,
}

/// All that was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagnosis {
    /// The robot's name.
    pub robot: String,
    /// The whole in a word.
    pub verdict: Verdict,
    /// Standard deviation of what sensors, the recorded motion and its clock make of each joint's
    /// torque error, N m.
    pub noise_floor: Vec<f64>,
    /// Composition of the extended model's error on the validating logs.
    pub budget: ErrorBudget,
    /// Root mean square of the measured torque of the validating logs, N m.
    pub torque_rms: Vec<f64>,
    /// Errors of the unchanged file.
    pub baseline: Errors,
    /// Errors after refitting all base parameters and friction, without any further cause.
    pub refitted: Errors,
    /// Errors with all causes.
    pub extended: Errors,
    /// The model called `extended`.
    pub offer: Offer,
    /// Whether the file has link parameters.
    pub has_links: bool,
    /// Whether the torques are what the gears take: the motors' less the joints'.
    pub transmission: bool,
    /// Whether the extended model refits all base parameters.
    pub links_refitted: bool,
    /// Standard parameters of the extended model.
    pub standard: Option<Vec<f64>>,
    /// Causes, in order of their gain times their odds.
    pub causes: Vec<Cause>,
    /// Plain friction that the extended model has refitted but that is no news: for the file alone.
    pub friction: Vec<Cause>,
    /// Effects of the file that the data contradict: removed, and estimated again. Identifier and
    /// joint (from 0), `None`: the whole robot.
    pub forgotten: Vec<(EffectKind, Option<usize>)>,
    /// Joints (from 1) that differ between the fitted and the validating logs: no one model of this
    /// kind predicts them on both.
    pub changed: Vec<usize>,
    /// The unchanged file predicts every validating log better than the model for which the fitted
    /// logs ask, so it is offered; `changes` are then those of the fitted logs alone.
    pub file_holds: bool,
    /// Causes that the validating logs show by themselves and the fitted ones do not; not in the
    /// model.
    pub changes: Vec<Cause>,
    /// Advice.
    pub next_experiment: Option<NextExperiment>,
    /// Whether the validating data are logs of their own, or the ends of the fitted ones.
    pub own_validation: bool,
    /// Seconds of motion: fitted, validating.
    pub seconds: [f64; 2],
    /// One per joint, of the validating data.
    pub curves: Vec<Curve>,
    /// Maps of the error, per joint, of the validating data.
    pub maps: Vec<Vec<ErrorMap>>,
}
