//! Refines and selects the causes found by a search, until all of them hold on unused data.

use super::beside::{Beside, Shares, Without};
use super::drive_terms;
use super::measure::{Measured, Meter, matters, taken_of, takes};
use super::model_choice::LeftOut;
use super::reduction::{backward_eliminate, drop_insignificant, fix_friction, free_friction, without};
use super::remark::Remark;
use super::suspects::beside_the_rest;
use crate::diagnose::findings::attribution::Attribution;
use crate::diagnose::findings::calibration;
use crate::diagnose::findings::reported_cause::{Item, items};
use crate::diagnose::findings::result::{Cause, Errors, Refutation};
use crate::diagnose::fit::model::{Fitted, Mode, ModelUnderTest};
use crate::diagnose::fit::uncertainty::Uncertainty;
use crate::diagnose::run::Settings;
use crate::diagnose::search::baseline_friction::{BaselineFriction, reconsider};
use crate::diagnose::search::forward::Evidence;
use crate::diagnose::search::judge::{Accepted, adopt, chosen_of};
use crate::diagnose::search::search;
use crate::diagnose::search::support::support_beside_all;
use crate::diagnose::windows::recording::Recording;
use crate::identify::ConsistentError;
use crate::model::PerturbableArm;

/// Data, noise levels and settings of a diagnosis.
#[derive(Clone, Copy)]
pub(in crate::diagnose) struct Session<'a> {
    pub(in crate::diagnose) plant: &'a dyn PerturbableArm,
    pub(in crate::diagnose) fit: &'a [Recording],
    pub(in crate::diagnose) validate: &'a [Recording],
    /// Whether the validating logs are separate from the fitted ones.
    pub(in crate::diagnose) own_validation: bool,
    /// Noise of the torques, per joint, N m.
    pub(in crate::diagnose) noise: &'a [f64],
    /// Torque errors due to errors of the recorded motion, per joint, N m.
    pub(in crate::diagnose) motion: &'a [f64],
    /// Error of the unchanged file on the validating logs where joints move, per joint, N m.
    pub(in crate::diagnose) file: &'a [f64],
    /// Errors of a plain refit.
    pub(in crate::diagnose) plain: &'a Errors,
    /// Error below which a better prediction does not count, per joint, N m.
    pub(in crate::diagnose) ground: &'a [f64],
    /// Unit of a gain, per joint, N m.
    pub(in crate::diagnose) scale: &'a [f64],
    pub(in crate::diagnose) settings: &'a Settings,
    pub(in crate::diagnose) progress: &'a (dyn Fn(&str) + Sync),
}

/// Least share of a joint's squared error that a local cause must remove where it acts: no other
/// stretch can confirm it.
const LOCAL_SHARE: f64 = 0.4;

/// Probability far below the one from which a cause is named.
pub(super) const FAR_BELOW: f64 = 0.2;

/// Ratio of a joint's errors on the validating logs, with the causes of the joint and by the
/// unchanged file, above which these logs refute the causes.
const WORSE_THAN_FILE: f64 = 1.3;

/// Maximum number of rounds in which causes that do not hold are removed.
const MOST_ROUNDS: usize = 16;

/// Causes that are not likely enough to be named: all of those far below the limit, or else the
/// least likely one, because without it another may become likelier.
fn unlikely(causes: &[Cause]) -> Vec<usize> {
    let below = |limit: f64| (0..causes.len()).filter(move |&i| causes[i].probability < limit);
    let far: Vec<usize> = below(FAR_BELOW).collect();
    if !far.is_empty() {
        return far;
    }
    let least = below(calibration::NAMED).min_by(|&a, &b| causes[a].probability.total_cmp(&causes[b].probability));
    least.into_iter().collect()
}

/// The causes to remove of those that do not hold. If a likely one among them acts throughout, those
/// that are unlikely go first, because they may spoil what it predicts.
fn unlikely_first(failed: Vec<usize>, causes: &[Cause]) -> Vec<usize> {
    let others = unlikely(causes);
    let likely = |c: &Cause| c.probability >= calibration::NAMED && c.window().is_none();
    if failed.iter().any(|&i| likely(&causes[i])) && !others.is_empty() { others } else { failed }
}

/// A sentence on a cause that is too unlikely to be named; `None` if it is named.
fn not_named(cause: &Cause, item: &Item) -> Option<Remark> {
    // Rounded down: a probability below one half is not written as one half.
    let probability = (100.0 * cause.probability).floor() / 100.0;
    let why = match cause.refuted {
        None => "",
        Some(Refutation::OtherData) => ", because data that were not fitted are not predicted better with it",
        Some(Refutation::OwnJoints) => ", because its own joints err as much without it",
        Some(Refutation::Size) => ", because its size is implausible beside the other causes",
    };
    (cause.probability < calibration::NAMED).then(|| {
        let predicate = format!("is not named: its probability is {probability:.2}{why}.");
        Remark::on(cause.cause, &item.place, &predicate).with_probability(cause.probability)
    })
}

/// A sentence on a cause that fails beside the others, likely as it may be.
fn fails(cause: &Cause, item: &Item, other: &Without) -> Remark {
    let why = match item.hypothesis.local() {
        true if other.spoils => "another joint errs more with it while it acts",
        true if other.may_be_chance() => "what it removes while it acts may be chance",
        true => "it explains too little while it acts",
        false if other.near => "its joints hardly err less with it",
        false => "data that were not fitted are not predicted better with it",
    };
    Remark::on(cause.cause, &item.place, &format!("is not named: {why}."))
}

/// A sentence on a cause whose parameters are zero within their uncertainty.
fn unsure(cause: &Cause, item: &Item) -> Remark {
    let predicate = "is not named: its parameters do not stand out of their uncertainty.";
    Remark::on(cause.cause, &item.place, predicate).with_probability(cause.probability)
}

/// The fit with the numbers of all shapes refined together; `None` if no cause has any.
fn polish(tested: &mut ModelUnderTest<'_>, accepted: &mut [Accepted]) -> Option<Fitted> {
    let refined = |a: &Accepted| a.chosen.cause.shape().iter().any(|number| number.step.is_some());
    if !accepted.iter().any(refined) {
        return None;
    }
    let mut chosen = chosen_of(accepted);
    let fitted = tested.polish(&mut chosen);
    adopt(accepted, &chosen);
    Some(fitted)
}

/// The fit within physical limits. The accepted causes take its values.
pub(super) fn inside(
    tested: &mut ModelUnderTest<'_>,
    accepted: &mut [Accepted],
    fitted: &Fitted,
) -> Result<Fitted, ConsistentError> {
    let mut chosen = chosen_of(accepted);
    let fitted = tested.possible(&mut chosen, fitted)?;
    adopt(accepted, &chosen);
    Ok(fitted)
}

/// A model in which every cause holds.
pub(in crate::diagnose) struct Selected<'a> {
    pub(in crate::diagnose) tested: ModelUnderTest<'a>,
    pub(in crate::diagnose) accepted: Vec<Accepted>,
    pub(in crate::diagnose) fitted: Fitted,
    /// Errors on the validating data.
    pub(in crate::diagnose) after: Measured,
    /// Errors on the fitted data.
    pub(in crate::diagnose) after_fit: Measured,
    pub(in crate::diagnose) causes: Vec<Cause>,
    /// All causes of the model before any was removed, with their probability beside each other.
    pub(in crate::diagnose) suspects: Vec<Cause>,
    /// Errors on stretches of the fitted data that are left out in turn.
    pub(in crate::diagnose) left_out: LeftOut,
    /// Alternatives to plain friction.
    pub(in crate::diagnose) rivals: Vec<BaselineFriction>,
    /// Evidence of the search that started from the unchanged file.
    pub(in crate::diagnose) evidence: Vec<Evidence>,
    /// Sentences on the causes that were removed, and why.
    pub(in crate::diagnose) why: Vec<Remark>,
}

/// Results of a search and its reductions other than the causes of the model.
#[derive(Default)]
pub(super) struct Found {
    /// Alternatives to plain friction.
    pub(super) rivals: Vec<BaselineFriction>,
    /// Sentences on the causes that were removed, and why.
    pub(super) why: Vec<Remark>,
    /// Evidence of the search that started from the unchanged file.
    pub(super) evidence: Vec<Evidence>,
    /// Causes with their probability beside each other.
    pub(super) suspects: Vec<Cause>,
}

/// A model with its errors, and each of its causes measured.
pub(super) struct Attributed {
    pub(super) items: Vec<Item>,
    others: Vec<Without>,
    /// Margin by which each cause exceeds the uncertainty of its parameters; below zero it may be
    /// absent.
    pub(super) stands_out: Vec<f64>,
    fitted: Fitted,
    after: Measured,
    after_fit: Measured,
    pub(super) causes: Vec<Cause>,
}

impl<'a> Session<'a> {
    /// Windows per second of the fitted logs.
    pub(in crate::diagnose) fn rate(&self) -> f64 {
        self.settings.rate_of(self.fit)
    }

    pub(super) fn tested(&self, mode: Mode) -> ModelUnderTest<'a> {
        let mut tested = ModelUnderTest::new(self.plant, self.fit, self.rate(), mode, &self.plant.delays(), false);
        tested.motion_error = self.motion.to_vec();
        tested
    }

    /// Searches with the links of this mode and returns the model with all causes that hold.
    pub(in crate::diagnose) fn searched(&self, mode: Mode) -> Result<Selected<'a>, ConsistentError> {
        if mode == Mode::Trusted {
            return self.searched_from_file();
        }
        let mut tested = self.tested(mode);
        let accepted = search(&mut tested, self.noise, &self.settings.search, self.progress);
        tested.forget();
        self.select(tested, accepted, None, Vec::new())
    }

    /// All parameters refitted, without further causes.
    pub(in crate::diagnose) fn plain(&self) -> Result<Selected<'a>, ConsistentError> {
        let mut tested = self.tested(Mode::Refitted);
        let fitted = fix_friction(&mut tested, &mut [], self.noise);
        let fitted = free_friction(&mut tested, &mut [], fitted);
        self.validated(tested, Vec::new(), fitted, Found::default())
    }

    /// The unchanged file.
    pub(in crate::diagnose) fn file(&self) -> Result<Selected<'a>, ConsistentError> {
        let mut tested = self.tested(Mode::Trusted);
        tested.frozen.iter_mut().for_each(|f| *f = true);
        let fitted = tested.fit(&mut []);
        self.validated(tested, Vec::new(), fitted, Found::default())
    }

    pub(super) fn select(
        &self,
        mut tested: ModelUnderTest<'a>,
        mut accepted: Vec<Accepted>,
        changes: Option<(Vec<BaselineFriction>, Vec<Evidence>)>,
        suspects: Vec<Cause>,
    ) -> Result<Selected<'a>, ConsistentError> {
        let (friction, evidence) = changes.unzip();
        polish(&mut tested, &mut accepted);
        let fitted = fix_friction(&mut tested, &mut accepted, self.noise);
        (self.progress)("what else plain friction might be");
        let (fitted, rivals) = match friction {
            Some(known) => (fitted, known),
            None => reconsider(&mut tested, &mut accepted, fitted, self.noise, &self.settings.search),
        };
        let fitted = drop_insignificant(&mut tested, &mut accepted, fitted, self.noise);
        let fitted = free_friction(&mut tested, &mut accepted, fitted);
        (self.progress)("what holds on stretches that were left out");
        let mut why = Vec::new();
        let fitted =
            backward_eliminate(self.plant, self.fit, &mut tested, &mut accepted, fitted, self.ground, &mut why);
        let fitted = polish(&mut tested, &mut accepted).unwrap_or(fitted);
        let evidence = match evidence {
            None if !self.plant.has_bodies() => drive_terms::evidence(&mut tested, &chosen_of(&accepted), &fitted),
            known => known.unwrap_or_default(),
        };
        let fitted = support_beside_all(&mut tested, &mut accepted).unwrap_or(fitted);
        let found = Found { rivals, why, evidence, suspects };
        self.validated(tested, accepted, fitted, found)
    }

    /// Indices of causes that do not hold on validating and fitted logs. `errors`: of the model
    /// there.
    fn failed(&self, items: &[Item], others: &[Without], causes: &[Cause], errors: [&Measured; 2]) -> Vec<usize> {
        let [after, after_fit] = errors;
        let still = vec![0.0; self.motion.len()];
        // A cause that increases the error on unused data is not in the model.
        let holds = |i: usize| {
            let (without, with) = (&others[i].alike(after), &after.steady);
            let motion = if items[i].hypothesis.follows_acceleration() { self.motion } else { &still };
            taken_of(without, with, self.scale) > 0.0 && matters(without, with, self.noise, motion)
        };
        // A local cause, or one on joints that differ between the logs, must still stand out beside
        // everything else.
        let out = |i: usize| takes(&others[i].measured.rms, &after_fit.rms, self.settings.search.least_gain);
        let stands = |i: usize| match items[i].hypothesis.local() {
            true => {
                let Without { within, spoils, .. } = others[i];
                within.is_some_and(|share| share >= LOCAL_SHARE) && !spoils && !others[i].may_be_chance()
            }
            false => !others[i].differs(&items[i].place) || out(i),
        };
        (0..causes.len()).filter(|&i| if causes[i].on == "fit" { !stands(i) } else { !holds(i) }).collect()
    }

    /// Whether an error of joint `j` on the validating logs, N m, is clearly larger than that of the
    /// unchanged file.
    fn worse_than_file(&self, j: usize, error: f64) -> bool {
        error.powi(2) > (WORSE_THAN_FILE * self.file[j]).powi(2) + self.noise[j].powi(2)
    }

    /// Measures a model, and each of its causes beside the others.
    pub(super) fn attributed(
        &self,
        tested: &mut ModelUnderTest<'a>,
        accepted: &mut Vec<Accepted>,
        fitted: Fitted,
        rivals: &[BaselineFriction],
        evidence: &[Evidence],
    ) -> Result<Attributed, ConsistentError> {
        (self.progress)("measuring on data that was not used");
        tested.forget();
        let chosen = chosen_of(accepted);
        let items = items(tested, accepted, &fitted);
        let [mut far, mut near] = [self.validate, self.fit].map(|data| Meter::new(self.plant, data, tested));
        let after = far.of(tested, &fitted, &chosen, true);
        let after_fit = near.of(tested, &fitted, &chosen, false);
        let mut beside = Beside { session: self, far, near, after: &after, after_fit: &after_fit };
        let others: Vec<Without> = items.iter().map(|item| beside.without(tested, &chosen, item)).collect();
        let fitted = without(tested, accepted, &[]);
        let fitted = inside(tested, accepted, &fitted)?;
        let chosen = chosen_of(accepted);
        let uncertainty = &Uncertainty::of(tested, &fitted, &chosen);
        let stands_out = |i: usize| uncertainty.exceeds_zero(tested, &fitted, i, &chosen[i]);
        let stands_out = items.iter().map(|item| item.accepted.map_or(f64::INFINITY, stands_out)).collect();
        let weighing = Attribution {
            tested,
            fitted: &fitted,
            uncertainty,
            accepted,
            rivals,
            noise: self.noise,
            own_validation: self.own_validation,
            stretches: &tested.stretches(&fitted),
            evidence,
        };
        let [here, there] = [&after_fit, &after].map(Measured::figures);
        let worse = |item: &Item| match item.place[..] {
            [j] => tested.mode == Mode::Trusted && self.worse_than_file(j, there.steady[j]),
            _ => false,
        };
        let causes = items
            .iter()
            .zip(&others)
            .map(|(item, other)| {
                let (with, on, refit) = match other.near {
                    true => (&here, "fit", &self.plain.fit),
                    false => (&there, "validate", &self.plain.moving),
                };
                // A body acts on all joints, whichever link it is.
                let joints = if item.hypothesis.within_links() { &[][..] } else { &item.place };
                let nothing = other.is_nothing(with, refit, joints);
                let shares = Shares { worse: worse(item), nothing, ..other.shares() };
                weighing.attribute(item, [&other.measured, with], shares, other.interval, on)
            })
            .collect();
        Ok(Attributed { items, others, stands_out, fitted, after, after_fit, causes })
    }

    /// Removes causes that do not hold on unused data, and measures the rest. All fits are within
    /// physical limits.
    pub(super) fn validated(
        &self,
        mut tested: ModelUnderTest<'a>,
        mut accepted: Vec<Accepted>,
        mut fitted: Fitted,
        found: Found,
    ) -> Result<Selected<'a>, ConsistentError> {
        let Found { rivals, mut why, evidence, mut suspects } = found;
        let mut round = 0;
        let (after, after_fit, causes) = loop {
            fitted = inside(&mut tested, &mut accepted, &fitted)?;
            let measured = self.attributed(&mut tested, &mut accepted, fitted, &rivals, &evidence)?;
            let Attributed { items, others, stands_out, after, after_fit, mut causes, .. } = measured;
            fitted = measured.fitted;
            let failed = self.failed(&items, &others, &causes, [&after, &after_fit]);
            let weak: Vec<usize> = (0..causes.len()).filter(|&i| stands_out[i] < 0.0).collect();
            // A push that does not hold where it acts is rejected for every model.
            let pushes = || failed.iter().filter(|&&i| items[i].hypothesis.local());
            suspects.retain(|suspect| !pushes().any(|&i| causes[i].is(suspect)));
            beside_the_rest(&mut suspects, &mut causes, &[&failed[..], &weak].concat());
            let weakest = weak.into_iter().min_by(|&a, &b| stands_out[a].total_cmp(&stands_out[b]));
            let weakest = weakest.filter(|_| failed.is_empty());
            let failed = match weakest {
                Some(weakest) => vec![weakest],
                None if failed.is_empty() => unlikely(&causes),
                None => unlikely_first(failed, &causes),
            };
            if failed.is_empty() || round >= MOST_ROUNDS {
                break (after, after_fit, causes);
            }
            why.extend(failed.iter().map(|&i| match weakest {
                Some(_) => unsure(&causes[i], &items[i]),
                None => not_named(&causes[i], &items[i]).unwrap_or_else(|| fails(&causes[i], &items[i], &others[i])),
            }));
            for &k in failed.iter().flat_map(|&i| &items[i].friction) {
                let which = if tested.mode == Mode::Refitted { &mut tested.quiet } else { &mut tested.frozen };
                which[k] = true;
            }
            let out: Vec<usize> = failed.iter().filter_map(|&i| items[i].accepted).collect();
            fitted = without(&mut tested, &mut accepted, &out);
            // The remaining causes may take over a part of a removed one.
            fitted = polish(&mut tested, &mut accepted).unwrap_or(fitted);
            round += 1;
        };
        let left_out = tested.possible_left_out(&chosen_of(&accepted), &fitted)?;
        Ok(Selected { tested, accepted, fitted, after, after_fit, causes, suspects, left_out, rivals, evidence, why })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::hypotheses::hypothesis;
    use crate::diagnose::select::remark::said_beside;
    use dh_codegen::robot::EffectKind;

    /// A likely cause that fails may do so because of an unlikely one.
    #[test]
    fn unlikely_causes_go_before_a_likely_one_that_fails() {
        let of = |probabilities: [f64; 3]| {
            let causes = probabilities.map(|probability| Cause { probability, ..Cause::blank("payload", "") });
            unlikely_first(vec![0], &causes)
        };
        assert_eq!(of([0.9, 0.1, 0.15]), [1, 2]);
        assert_eq!(of([0.9, 0.4, 0.3]), [2]);
        assert_eq!(of([0.9, 0.6, 0.7]), [0]);
        assert_eq!(of([0.4, 0.1, 0.7]), [0], "an unlikely one that fails");
    }

    #[test]
    fn a_cause_that_is_not_named_has_its_reason() {
        let hypothesis = hypothesis(EffectKind::JointElasticity);
        let item = Item { hypothesis, place: vec![3], accepted: Some(0), friction: Vec::new() };
        let says = |probability: f64, refuted: Option<Refutation>| {
            let cause = Cause { probability, refuted, ..Cause::blank(hypothesis.name(), "") };
            not_named(&cause, &item).and_then(|remark| said_beside(&[], &[remark]).0.pop())
        };
        let plain = "joint_elasticity of joint 4 is not named: its probability is 0.49.";
        assert_eq!(says(0.499, None).as_deref(), Some(plain));
        assert_eq!(says(0.5, None), None);
        let why = |refuted| says(0.3, Some(refuted)).unwrap();
        assert!(why(Refutation::OtherData).contains("0.30, because data that were not fitted"));
        assert!(why(Refutation::OwnJoints).contains("0.30, because its own joints err as much without it"));
        assert!(why(Refutation::Size).contains("0.30, because its size is implausible"));
    }
}
