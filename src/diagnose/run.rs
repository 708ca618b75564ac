//! Runs the diagnosis: recordings in, [`Diagnosis`] out.

use super::excerpts::seek_again;
use super::findings::attribution::curve;
use super::findings::calibration;
use super::findings::deflection::deflections;
use super::findings::impacts::impacts;
use super::findings::nameless::unknown;
use super::findings::order::in_order;
use super::findings::pushes_at_rest::pushes_at_rest;
use super::findings::reported_cause::quiet;
use super::findings::result::{Cause, Diagnosis, Errors, NextExperiment, Offer, Offered, Verdict};
use super::findings::structure::Structure;
use super::fit::model::{Mode, ModelUnderTest};
use super::search::SearchSettings;
use super::search::position_band::position_band;
use super::select::contenders::{Refit, Searched};
use super::select::excess::{explained, here_and_there, with_excess};
use super::select::measure::{Measured, Meter};
use super::select::offer::{Choice, Rival};
use super::select::refine_and_select::{Selected, Session};
use super::select::remark::{Remark, said_beside};
use super::select::suspects::{likelier, name, not_explained};
use super::windows::low_passed::{PositionBand, in_band};
use super::windows::motion_error::budget;
use super::windows::recording::{Recording, unexplained};
use super::windows::torque_noise::torque_noise;
use crate::identify::ConsistentError;
use crate::model::PerturbableArm;
use crate::numerics::sums::root_mean_square;
use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects::FrictionDrift;

/// Settings of a diagnosis.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Settings {
    /// Windows per second. Default: 100. For more than half a minute of fitted motion fewer, down
    /// to 50, so that there are as many as in half a minute.
    pub rate: Option<f64>,
    /// Thresholds of the search.
    pub search: SearchSettings,
    /// Whether the positions keep the band of the recordings. Default false: where the torques
    /// follow them less far, they are low-passed further.
    pub keep_band: bool,
}

/// Windows per second of short logs, and the duration, s, above which logs are long. Time and
/// memory are proportional to the number of windows.
const RATE: f64 = 100.0;
const LONG: f64 = 30.0;

impl Settings {
    /// Largest number of windows per second, for logs of any length.
    pub fn most_windows_per_second(&self) -> f64 {
        self.rate.unwrap_or(RATE)
    }

    /// Windows per second of these logs. At twice the window length reversals are still resolved.
    pub(in crate::diagnose) fn rate_of(&self, recordings: &[Recording]) -> f64 {
        let seconds: f64 = recordings.iter().map(Recording::seconds).sum();
        self.rate.unwrap_or_else(|| (RATE * LONG / seconds.max(LONG)).max(0.5 * RATE))
    }
}

/// Reasons for which there is no diagnosis.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DiagnoseError {
    /// Too little data.
    #[error("{seconds:.1} s of usable motion are too little to separate causes; record at least 3 s")]
    TooShort {
        /// Seconds of usable motion.
        seconds: f64,
    },
    /// Torques that are zero throughout.
    #[error("the torques of all joints are zero throughout; take logs in which they were measured")]
    NoTorque,
    /// No physically possible model was found.
    #[error("no model of possible bodies was found: {0}")]
    Impossible(#[from] ConsistentError),
    /// Infinite numbers in the equations.
    #[error("the equations contain infinite numbers; look for absurd values in the logs or the robot file")]
    NotFinite,
}

/// Errors of a simulation of the unchanged robot file on logs, per joint: root mean square, N m, of
/// all samples and of those where the joint moves; behind the low-pass of a diagnosis.
pub fn misses(plant: &dyn PerturbableArm, recordings: &[Recording], settings: &Settings) -> [Vec<f64>; 2] {
    let band = narrower_band(plant, recordings, false, settings);
    let recordings = &in_band(recordings, band.as_ref())[..];
    let recordings = &unexplained(plant, recordings)[..];
    let tested =
        ModelUnderTest::new(plant, recordings, settings.rate_of(recordings), Mode::Trusted, &plant.delays(), false);
    let measured = Meter::new(plant, recordings, &tested).of_the_file();
    [measured.rms, measured.steady]
}

/// Diagnoses `fit`, and evaluates on `validate`; if that is empty, on the last three tenths of each
/// stretch of `fit`.
pub fn diagnose(
    plant: &dyn PerturbableArm,
    fit: &[Recording],
    validate: &[Recording],
    settings: &Settings,
    progress: &(dyn Fn(&str) + Sync),
) -> Result<Diagnosis, DiagnoseError> {
    // Without rotor inertias to change, a refit assigns their effect to bodies and gears.
    let driven = plant.with_rotors();
    let plant = driven.as_deref().unwrap_or(plant);
    let band = narrower_band(plant, fit, validate.is_empty(), settings);
    let [fit, validate] = [fit, validate].map(|logs| in_band(logs, band.as_ref()));
    let (fit, validate) = (&fit[..], &validate[..]);
    let mut found = consistent_with_file(plant, fit, validate, settings, progress)?;
    progress("excerpts of the logs");
    let bare = plant.without(&found.forgotten);
    let trusted = bare.as_deref().unwrap_or(plant);
    seek_again(&mut found.causes, fit, |excerpt, rest| {
        let validate = if validate.is_empty() { rest } else { validate };
        once(trusted, excerpt, validate, settings, progress).ok().map(|found| found.causes)
    });
    if !found.changed.is_empty() {
        progress("what changed between the logs");
        // Diagnose the logs that deviate from the model by themselves, if they are long enough.
        let others = if found.file_holds { fit } else { validate };
        if let Ok(other) = once(plant, others, &[], settings, progress) {
            // A cause that no offered model has is one of the logs that differ.
            let known = |c: &Cause| found.causes.iter().any(|k| k.in_extended && k.is(c));
            found.changes = other.causes.into_iter().filter(|c| c.cause != "unknown" && !known(c)).collect();
            let changes = &found.changes;
            found.causes.retain(|c| c.in_extended || !changes.iter().any(|k| k.is(c)));
        }
        if found.file_holds && !found.changes.is_empty() {
            // The structure of the fitted logs now has a name.
            found.causes.retain(|c| c.cause != "unknown");
            found.causes.extend(faded(&found.changes));
        }
        if found.verdict == Verdict::NothingWrong {
            found.verdict = Verdict::Unexplained;
        }
    }
    found.band = band;
    Ok(found)
}

/// A low-pass of the positions below that of the recordings, if the torques follow the motion less
/// far and the settings allow it. `held_out`: whether the last part of each stretch is not fitted.
fn narrower_band(
    plant: &dyn PerturbableArm,
    fit: &[Recording],
    held_out: bool,
    settings: &Settings,
) -> Option<PositionBand> {
    if settings.keep_band {
        return None;
    }
    let [first, _] = if held_out { halves(fit) } else { Default::default() };
    let fit = if held_out { &first } else { fit };
    let rate = settings.rate_of(fit);
    usable(&ModelUnderTest::new(plant, fit, rate, Mode::Trusted, &plant.delays(), false)).ok()?;
    position_band(plant, fit, rate)
}

/// Causes of the fitted logs alone that the validating logs do not refute: fading friction has
/// vanished there if they began with warm gears.
fn faded(changes: &[Cause]) -> impl Iterator<Item = Cause> {
    let fades = |c: &&Cause| c.cause == FrictionDrift::NAME;
    let note = "; the validating logs do not show it, as with gears that were warm by then";
    let cause = move |c: &Cause| Cause { in_extended: false, evidence: format!("{}{note}", c.evidence), ..c.clone() };
    changes.iter().filter(fades).map(cause)
}

/// The diagnosis with the effects of the file, except those that the data contradict.
fn consistent_with_file(
    plant: &dyn PerturbableArm,
    fit: &[Recording],
    validate: &[Recording],
    settings: &Settings,
    progress: &(dyn Fn(&str) + Sync),
) -> Result<Diagnosis, DiagnoseError> {
    let mut found = once(plant, fit, validate, settings, progress)?;
    // A found effect that the file also has contradicts the file's. Two of a kind cannot be
    // written, so the file's is removed and the search repeated.
    let mut forgotten: Vec<(EffectKind, Option<usize>)> = Vec::new();
    let baseline = found.baseline.clone();
    for _ in 0..2 {
        let known = plant.effects();
        let again = |effect: EffectKind, joint: Option<usize>| {
            let same = |c: &&Cause| c.cause == effect.name() && c.joints.first().map(|j| j - 1) == joint;
            !ADDS_UP.contains(&effect) && found.causes.iter().any(|c| c.in_extended && same(&c))
        };
        let before = forgotten.len();
        for (effect, joint) in known {
            if again(effect, joint) && !forgotten.contains(&(effect, joint)) {
                forgotten.push((effect, joint));
            }
        }
        if forgotten.len() == before {
            break;
        }
        let Some(bare) = plant.without(&forgotten) else { break };
        progress("an effect of the file, estimated again");
        found = once(&*bare, fit, validate, settings, progress)?;
        found.forgotten.clone_from(&forgotten);
        found.baseline.clone_from(&baseline);
    }
    Ok(found)
}

/// Share of each stretch that is fitted where there is no validating log.
pub(super) const KEPT: f64 = 0.7;

/// Effects whose findings can be written into the file beside its own: totals, differences of
/// bodies, further orders.
const ADDS_UP: [EffectKind; 3] = [EffectKind::TimeDelay, EffectKind::LinkInertiaError, EffectKind::TorqueRipple];

/// Root mean square of each joint's torque, N m, without the first `share` of each stretch.
fn torque_rms(recordings: &[Recording], share: f64, dof: usize) -> Vec<f64> {
    let stretches = || recordings.iter().flat_map(|r| &r.stretches);
    let all = |j: usize| stretches().flat_map(|s| s.of(&s.tau, j)[s.at(share)..].iter().copied()).collect::<Vec<f64>>();
    (0..dof).map(|j| root_mean_square(&all(j))).collect()
}

fn errors_of(fit: &Measured, validate: &Measured) -> Errors {
    Errors { fit: fit.rms.clone(), validate: validate.rms.clone(), moving: validate.steady.clone() }
}

/// The smaller of two errors, per joint, N m.
fn least(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a.min(*b)).collect()
}

/// Causes that are not columns of the recorded motion (deflections, impacts, pushes at rest), and the
/// structure that they do not explain.
fn without_columns(session: &Session<'_>, model: &Selected<'_>, left: Vec<Structure>) -> (Vec<Structure>, Vec<Cause>) {
    let noise = session.noise;
    let mut causes = deflections(model, noise);
    let left = explained(left, &causes);
    let impacts = if left.is_empty() { None } else { impacts(model) };
    let left = impacts.iter().fold(left, |left, i| i.explain(left, &model.after_fit, noise));
    causes.extend(impacts.map(|i| i.cause(&model.after_fit, noise)));
    causes.extend(pushes_at_rest(model, session.fit, noise));
    // A cause that the model already has is not named twice.
    let known = |c: &Cause| model.causes.iter().any(|k| k.is(c));
    let least = |c: &Cause| if c.window().is_some() { calibration::NAMED } else { calibration::NAMED_BY_SIZE };
    causes.retain(|c| !known(c) && c.probability >= least(c));
    (left, causes)
}

/// The verdict, by whether the offered model has causes, and whether structure remains. `refitted`:
/// errors of the file and of a model with other links or rotors.
fn verdict(causes: &[Cause], left: &[Structure], refitted: Option<[&Errors; 2]>) -> Verdict {
    let wrong = refitted.is_some_and(|[file, offered]| {
        file.validate.iter().zip(&offered.validate).any(|(file, offered)| *file > WRONG * offered)
    });
    match (causes.iter().any(|c| c.in_extended), left.is_empty()) {
        (false, true) if !wrong => Verdict::NothingWrong,
        (false, true) => Verdict::Unexplained,
        (false, false) => Verdict::Unexplained,
        (true, true) => Verdict::Explained,
        (true, false) => Verdict::PartlyExplained,
    }
}

/// Ratio of the file's error to that of refitted links above which the file's links are wrong, even
/// if none of them stands out.
const WRONG: f64 = 1.3;

/// The experiment that would separate the first ambiguous cause from its alternatives.
fn next_experiment(causes: &[Cause]) -> Option<NextExperiment> {
    let separable = |c: &&Cause| !c.not_distinguished_from.is_empty() && c.decided_by.is_none();
    let open = causes.iter().filter(|c| c.cause != "unknown").find(separable)?;
    Some(NextExperiment {
        between: std::iter::once(open.cause).chain(open.not_distinguished_from.iter().copied()).collect(),
        joints: open.joints.clone(),
        motion: open.shown_by.to_string(),
    })
}

/// The fitted and the validating part of recordings without a validating log.
fn halves(recordings: &[Recording]) -> [Vec<Recording>; 2] {
    let (first, rest) = recordings.iter().map(|r| <(_, _)>::from(r.split(KEPT))).unzip();
    [first, rest]
}

/// The offered model without causes that a law replaces, its causes and those named beside it, and
/// the structure that none of them explains. `why`: sentences on the model.
fn named<'a>(
    session: &Session<'a>,
    mut model: Selected<'a>,
    rival: Option<&Rival>,
    suspects: [Vec<Cause>; 2],
    torque_rms: &[f64],
    why: &mut Vec<Remark>,
) -> Result<(Selected<'a>, Vec<Cause>, Vec<Structure>), ConsistentError> {
    let mut suspects = session.suspected(suspects, &mut model, rival, why);
    let model = session.law_instead(model, torque_rms, &mut suspects, why)?;
    let left = with_excess(session.left(&model, torque_rms), session.late(&model));
    let (left, unplayed) = without_columns(session, &model, left);
    let mut causes = model.causes.clone();
    if model.tested.mode == Mode::Refitted && has_values(session.plant) {
        causes.extend(likelier(session.links(&model, rival), &suspects));
    }
    causes.extend(unplayed);
    let left = match causes.is_empty() && left.is_empty() {
        true => here_and_there(&model.after_fit, session.noise),
        false => left,
    };
    let shown = |s: &Cause| rival.is_some_and(|rival| rival.suffices(s, &model.left_out));
    let suspects = if causes.is_empty() { suspects } else { not_explained(suspects, &model.after_fit, shown) };
    if !causes.is_empty() || !left.is_empty() {
        name(&mut causes, suspects);
    }
    Ok((model, causes, left))
}

/// Whether the file has non-zero link parameters.
fn has_links(plant: &dyn PerturbableArm) -> bool {
    plant.has_bodies() && plant.given().is_some_and(|given| given.iter().any(|v| *v != 0.0))
}

/// Whether a refit changes values of the file: those of links, or of drives that are diagnosed
/// alone.
fn has_values(plant: &dyn PerturbableArm) -> bool {
    has_links(plant) || !plant.has_bodies()
}

/// Checks that there is enough motion, that numbers are finite and that some torque was measured.
fn usable(start: &ModelUnderTest<'_>) -> Result<(), DiagnoseError> {
    let fit = start.recordings;
    let seconds: f64 = fit.iter().map(Recording::seconds).sum();
    if seconds < 2.0 || start.scene.len < 100 {
        return Err(DiagnoseError::TooShort { seconds });
    }
    if start.target().iter().flatten().any(|y| !y.is_finite()) {
        return Err(DiagnoseError::NotFinite);
    }
    if fit.iter().flat_map(|r| &r.stretches).all(|s| s.tau.iter().all(|t| *t == 0.0)) {
        return Err(DiagnoseError::NoTorque);
    }
    Ok(())
}

/// [`diagnose`] with all effects of the file kept.
fn once(
    plant: &dyn PerturbableArm,
    fit: &[Recording],
    validate: &[Recording],
    settings: &Settings,
    progress: &(dyn Fn(&str) + Sync),
) -> Result<Diagnosis, DiagnoseError> {
    let own_validation = !validate.is_empty();
    let recorded = fit.iter().chain(validate).flat_map(|r| &r.stretches);
    let dof = plant.dof();
    let torque_rms = if own_validation { torque_rms(validate, 0.0, dof) } else { torque_rms(fit, KEPT, dof) };
    let (whole, other) = (unexplained(plant, fit), unexplained(plant, validate));
    let [first, rest] = if own_validation { [Vec::new(), Vec::new()] } else { halves(&whole) };
    let (fit, validate) = if own_validation { (&whole[..], &other[..]) } else { (&first[..], &rest[..]) };
    let rate = settings.rate_of(fit);
    let start = ModelUnderTest::new(plant, fit, rate, Mode::Trusted, &plant.delays(), false);
    usable(&start)?;
    let before = Meter::new(plant, validate, &start).of_the_file();
    let (baseline, before) = (errors_of(&Meter::new(plant, fit, &start).of_the_file(), &before), before.error);

    let (refit, refitted) = Refit::new(plant, fit, validate, own_validation, rate)?;
    let noise = refit.with_noise_seen(torque_noise(recorded.clone(), dof));
    let has_links = has_links(plant);
    // The contribution of sensors, motion and clock to the error is no evidence.
    let scene = if has_links { &start.scene } else { &refitted.scene };
    let budget = budget(scene, recorded, &noise).within(&least(&baseline.fit, &refit.errors.fit));
    let (noise, motion) = (&budget.floor()[..], &budget.of_motion()[..]);
    let ground: &[f64] = &noise.iter().zip(&torque_rms).map(|(s, t)| s.max(0.004 * t)).collect::<Vec<f64>>();
    let file_out = start.file_left_out();
    // The searches have models of their own, and memory is limited.
    drop((start, refitted));

    // Unit of a gain: the noise, or a fiftieth of the torque where the noise is less.
    let scale: &[f64] = &noise.iter().zip(&torque_rms).map(|(s, t)| s.hypot(0.02 * t)).collect::<Vec<f64>>();
    let (file, plain) = (&baseline.moving.clone()[..], &refit.errors);
    let session =
        Session { plant, fit, validate, own_validation, noise, motion, file, plain, ground, scale, settings, progress };
    let Searched { models, said, suspects } = session.models(has_links.then_some(&file_out), &refit, &torque_rms)?;
    let Choice { offered, mut why, changed, file_holds, model, rival } = session.choose(models, &file_out, &refit)?;
    let (model, mut causes, left) = named(&session, model, rival.as_ref(), suspects, &torque_rms, &mut why)?;
    let Selected { tested, fitted, mut after, mut after_fit, left_out, .. } = model;
    in_order(&mut causes, scale);
    let other_values = tested.mode == Mode::Refitted && has_values(plant);
    let verdict = verdict(&causes, &left, other_values.then_some([&baseline, &errors_of(&after_fit, &after)]));
    let errors = [&mut after_fit, &mut after];
    let left = session.explained_by_formulas(&mut causes, left, (&tested, &fitted), errors, file_holds, &torque_rms);
    let extended = errors_of(&after_fit, &after);
    let offered = if causes.iter().any(Cause::has_law) { Offered::Extended } else { offered };
    unknown(&mut causes, &left, [&baseline, &extended], noise, scale);
    let (why, rejected) = said_beside(&causes, &[said, why].concat());
    let view = after.view(plant, validate);
    Ok(Diagnosis {
        robot: plant.name().to_string(),
        verdict,
        noise_floor: noise.to_vec(),
        budget: budget.of_errors(&extended.moving),
        torque_rms: torque_rms.clone(),
        baseline,
        refitted: refit.errors.clone(),
        extended,
        has_links: has_values(plant),
        transmission: !plant.has_bodies(),
        links_refitted: tested.mode == Mode::Refitted && plant.has_bodies(),
        standard: tested.scene.standard.clone(),
        offer: Offer { offered, left_out: [file_out.rms(), refit.left_out.rms(), left_out.rms()], why },
        friction: quiet(&tested, &fitted),
        forgotten: Vec::new(),
        band: None,
        changed: changed.into_iter().map(|j| j + 1).collect(),
        file_holds,
        changes: Vec::new(),
        next_experiment: next_experiment(&causes),
        rejected,
        causes,
        own_validation,
        seconds: [fit, validate].map(|part| part.iter().map(Recording::seconds).sum()),
        curves: (0..dof).map(|j| curve(j, &after, &view, &before)).collect(),
        maps: (0..dof).map(|j| view.maps(j, &before[j], &after.error[j])).collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Other links that predict much better than the file's are an error, whether or not one of
    /// them has a name.
    #[test]
    fn links_that_miss_are_not_nothing() {
        let errors = |validate: f64| Errors { validate: vec![0.05, validate], ..Errors::default() };
        let (file, near, far) = (errors(0.6), errors(0.5), errors(0.2));
        assert_eq!(verdict(&[], &[], None), Verdict::NothingWrong);
        assert_eq!(verdict(&[], &[], Some([&file, &near])), Verdict::NothingWrong);
        assert_eq!(verdict(&[], &[], Some([&file, &far])), Verdict::Unexplained);
        let cause = Cause::blank("payload", "");
        assert_eq!(verdict(&[cause], &[], Some([&file, &far])), Verdict::Explained);
    }
}
