//! Result of a diagnosis: plain data.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects::{self, Key};

use crate::diagnose::hypotheses::{Named, Quantity, by_name, hypothesis};
use crate::diagnose::windows::low_passed::PositionBand;
use crate::identify::ErrorBudget;

/// Overall verdict.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// The causes explain everything but noise.
    Explained,
    /// The causes leave structure.
    PartlyExplained,
    /// Structure remains, and no cause holds.
    Unexplained,
    /// The error is noise only.
    NothingWrong,
}

/// Names the data on which errors were measured, from `on` of a [`Cause`].
pub fn measured_on(on: &str, own_validation: bool) -> &'static str {
    match (on, own_validation) {
        ("fit", true) => "the fitted logs",
        ("fit", false) => "the fitted part of the logs",
        (_, true) => "the validating logs",
        (_, false) => "the part of the logs that was kept out of the fit",
    }
}

impl Verdict {
    /// Name in the JSON.
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
    /// On the fitted logs.
    pub fit: Vec<f64>,
    /// On the validating logs.
    pub validate: Vec<f64>,
    /// On the validating logs where the joint moves. While a joint sticks at a reversal, friction
    /// balances the other torques and is not a function of the velocity.
    pub moving: Vec<f64>,
}

/// Evidence as a curve: the error to be explained and the cause's torque, over the quantity that
/// shows it best.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Evidence {
    /// Name of the abscissa, with its unit.
    pub over: String,
    /// Abscissa: means of bins.
    pub x: Vec<f64>,
    /// Mean error without the cause in each bin, N m.
    pub measured: Vec<f64>,
    /// Mean torque of the cause in each bin, N m.
    pub explained: Vec<f64>,
}

/// Why a cause that the fitted data support is not named.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refutation {
    /// Data that were not fitted are predicted worse with it, or worse than by the unchanged file.
    OtherData,
    /// Its own joints err as much without it.
    OwnJoints,
    /// Its size beside the other causes is implausible.
    Size,
}

/// A cause that a search found and that is neither in the offered model nor suspected beside it.
#[derive(Debug, Clone, PartialEq)]
pub struct Rejected {
    /// Name of the effect.
    pub cause: &'static str,
    /// Joints, from 1; empty for the whole robot.
    pub joints: Vec<usize>,
    /// Probability that it is present; `None` if it was not computed.
    pub probability: Option<f64>,
    /// The reason: a sentence without its subject, the cause.
    pub why: String,
}

/// A reported cause.
#[derive(Debug, Clone, PartialEq)]
pub struct Cause {
    /// Name of the effect, or `unknown`.
    pub cause: &'static str,
    /// Joints, from 1; empty for the whole robot.
    pub joints: Vec<usize>,
    /// Probability that the cause is present.
    pub probability: f64,
    /// Its nonlinear parameters, such as a ripple's order; empty without any.
    pub shape: Vec<f64>,
    /// What refutes it; the probability accounts for it.
    pub refuted: Option<Refutation>,
    /// Parameters; symbols carry the joint's number.
    pub parameters: Vec<Quantity>,
    /// The same without the joint's number, for the robot file.
    pub keys: Vec<Named>,
    /// Twice the gain in log-likelihood over independent windows, less the cost of its unknowns and
    /// of the number of candidates.
    pub support: f64,
    /// Difference of support to the next best cause in its place.
    pub margin: f64,
    /// Share of the squared error of its main joint, above the noise, that it removes.
    pub share: f64,
    /// Recurrence in disjoint stretches of the fitted logs, 0 to 1: 1 for the same size in each.
    pub recurrence: f64,
    /// In how many excerpts of the fitted logs it is found again, and how many were diagnosed; zero
    /// if it acts in a part of a log only, or excerpts are too short.
    pub found_again: [usize; 2],
    /// A sentence with figures.
    pub evidence: String,
    /// Errors with all causes but this one, per joint, N m.
    pub rms_before: Vec<f64>,
    /// Errors with it, per joint, N m.
    pub rms_after: Vec<f64>,
    /// 90 % interval of the share of the squared error that it removes on its main joint.
    pub interval: [f64; 2],
    /// Data on which it was measured: `validate`, or `fit` if these cannot show it.
    pub on: &'static str,
    /// Whether the extended model has it. Otherwise it was found with other links than that
    /// model's, did not pay there, or acts on the standing arm.
    pub in_extended: bool,
    /// Causes that these data cannot separate from it.
    pub not_distinguished_from: Vec<&'static str>,
    /// Experiment that would show it better, or separate it from those.
    pub shown_by: &'static str,
    /// Information that would separate it from those, where no motion does.
    pub decided_by: Option<&'static str>,
    /// Curve that shows it.
    pub curve: Option<Evidence>,
    /// Torque that the model lacks on its joint in closed form, for an error without a known cause:
    /// an expression in `q1.. dq1.. ddq1..`.
    pub law: Option<String>,
}

impl Cause {
    /// Whether another cause is the same one in the same place. Two ripples of a joint differ in their
    /// order. Two pushes are the same if their windows overlap by at least half of the shorter one; a
    /// push and a wall never are.
    pub fn is(&self, other: &Self) -> bool {
        let overlap = |a: [f64; 2], b: [f64; 2]| a[1].min(b[1]) - a[0].max(b[0]);
        let shorter = |a: [f64; 2], b: [f64; 2]| (a[1] - a[0]).min(b[1] - b[0]);
        let together = match (self.window(), other.window()) {
            (Some(one), Some(other)) => 2.0 * overlap(one, other) >= shorter(one, other),
            (one, other) => one == other,
        };
        let same_law = by_name(self.cause).is_none_or(|cause| cause.same_law(&self.shape, &other.shape));
        self.cause == other.cause && self.joints == other.joints && together && same_law
    }

    /// Begin and end of a push, s since its log began; `None` for causes that act throughout.
    pub(in crate::diagnose) fn window(&self) -> Option<[f64; 2]> {
        let of = |key: Key| self.keys.iter().find(|named| named.symbol == key.into()).map(|named| named.value);
        Some([of(effects::ExternalContact::START)?, of(effects::ExternalContact::END)?])
    }

    /// A cause with only its name and the experiment that would show it.
    pub(in crate::diagnose) fn blank(cause: &'static str, shown_by: &'static str) -> Self {
        Self {
            cause,
            shown_by,
            decided_by: None,
            joints: Vec::new(),
            probability: 0.0,
            shape: Vec::new(),
            refuted: None,
            parameters: Vec::new(),
            keys: Vec::new(),
            support: 0.0,
            margin: 0.0,
            share: 0.0,
            recurrence: 1.0,
            found_again: [0; 2],
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

    /// An effect of the vocabulary, with the experiment that would show it.
    pub(in crate::diagnose) fn of_effect(effect: EffectKind) -> Self {
        Self::blank(effect.name(), hypothesis(effect).shown_by())
    }

    /// Whether it is a torque in closed form that the offered model has.
    pub fn has_law(&self) -> bool {
        self.law.is_some() && self.in_extended
    }
}

/// Experiment that would resolve the ambiguity between causes.
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

/// Error of one joint on the validating data over a quantity, before and after.
#[derive(Debug, Clone, PartialEq)]
pub struct ErrorMap {
    /// Name of the abscissa, with its unit. Over `frequency, Hz` the ordinates are amplitudes,
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
    /// Name in the JSON.
    pub fn word(self) -> &'static str {
        match self {
            Self::File => "file",
            Self::Refitted => "refitted",
            Self::Extended => "extended",
        }
    }
}

/// The offered model with the reasons, from errors on left-out stretches of the fitted logs.
#[derive(Debug, Clone, PartialEq)]
pub struct Offer {
    /// The offered model.
    pub offered: Offered,
    /// Root mean square over joints of the errors there, N m: of the file, the refit and the
    /// offered model.
    pub left_out: [f64; 3],
    /// Sentences on the reasons, and on causes that were removed.
    pub why: Vec<String>,
}

/// Complete result of a diagnosis.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagnosis {
    /// The robot's name.
    pub robot: String,
    /// Overall verdict.
    pub verdict: Verdict,
    /// Standard deviation of the contribution of sensors, the recorded motion and its clock to each
    /// joint's torque error, N m.
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
    /// Whether the torques are the losses of the gears: the motors' torques minus the joints'.
    pub transmission: bool,
    /// Whether the extended model refits all base parameters.
    pub links_refitted: bool,
    /// Standard parameters of the extended model.
    pub standard: Option<Vec<f64>>,
    /// Causes, in order of their gain times their odds.
    pub causes: Vec<Cause>,
    /// Causes that were found and rejected, the likeliest first.
    pub rejected: Vec<Rejected>,
    /// Plain friction refitted in the extended model but not reported as a change; for the file
    /// alone.
    pub friction: Vec<Cause>,
    /// Low-pass of the positions, if the torques follow the motion less far than the band that suits
    /// the encoders.
    pub band: Option<PositionBand>,
    /// Effects of the file that the data contradict: removed, and estimated again. Effect and joint
    /// (from 0); `None` for the whole robot.
    pub forgotten: Vec<(EffectKind, Option<usize>)>,
    /// Joints (from 1) that differ between the fitted and the validating logs: no single model of
    /// this kind predicts both.
    pub changed: Vec<usize>,
    /// Whether the unchanged file predicts every validating log better than the model that the
    /// fitted logs support. The file is then offered, and `changes` are those of the fitted logs
    /// alone.
    pub file_holds: bool,
    /// Causes that the validating logs show by themselves and the fitted ones do not; not in the
    /// model.
    pub changes: Vec<Cause>,
    /// Experiment that would separate ambiguous causes.
    pub next_experiment: Option<NextExperiment>,
    /// Whether the validating data are separate logs, or the ends of the fitted ones.
    pub own_validation: bool,
    /// Seconds of motion: fitted, validating.
    pub seconds: [f64; 2],
    /// Torque and error curves of the validating data, one per joint.
    pub curves: Vec<Curve>,
    /// Maps of the error, per joint, of the validating data.
    pub maps: Vec<Vec<ErrorMap>>,
}
