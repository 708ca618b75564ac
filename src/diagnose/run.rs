//! The diagnosis from end to end: recordings in, [`Diagnosis`] out.

use super::item::{items, quiet};
use super::measure::{Meter, bootstrap, here, leave_out, matters, root_mean_square, share, taken_of};
use super::model::{Bench, Mode, Uncertainty};
use super::noise::floor;
use super::record::{Recording, unexplained};
use super::result::{Cause, Diagnosis, Errors, NextExperiment, Offer, Verdict};
use super::search::{SearchSettings, reconsider, search};
use super::stay::{chosen_of, freeze, offer, prune, release, withdraw, without};
use super::structure::{Structure, structure};
use super::weigh::{MOST_MARGIN, curve, taken, unknown, values_last, weigh};
use super::{calibration, evidence};
use crate::arm::Plant;

/// How to diagnose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Windows per second. Default 100.
    pub rate: f64,
    /// How strict the search is.
    pub search: SearchSettings,
}

impl Default for Settings {
    fn default() -> Self {
        Self { rate: 100.0, search: SearchSettings::default() }
    }
}

/// Why there is no diagnosis.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DiagnoseError {
    /// Too little data.
    #[error("{seconds:.1} s of usable motion are too little to tell causes apart; record at least 3 s")]
    TooShort {
        /// Seconds.
        seconds: f64,
    },
    /// Torques that are zero throughout.
    #[error("the torques of all joints are zero throughout; take logs in which they were measured")]
    NoTorque,
    /// Infinite numbers.
    #[error("the equations contain infinite numbers; look for absurd values in the logs or the robot file")]
    NotFinite,
}

/// What a simulation of the robot file as it is misses of logs, per joint: root mean square, N m, every sample counted.
pub fn misses(plant: &dyn Plant, recordings: &[Recording], settings: &Settings) -> Vec<f64> {
    let recordings = &unexplained(plant, recordings)[..];
    let bench = Bench::new(plant, recordings, settings.rate, Mode::Trusted, &plant.delays(), false);
    Meter::new(plant, recordings, &bench).of_the_file().rms
}

/// Diagnoses `fit`, and measures on `validate`; where that is empty, on the last three tenths of each stretch of `fit`.
pub fn diagnose(
    plant: &dyn Plant,
    fit: &[Recording],
    validate: &[Recording],
    settings: &Settings,
    progress: &dyn Fn(&str),
) -> Result<Diagnosis, DiagnoseError> {
    let mut found = once(plant, fit, validate, settings, progress)?;
    // Where an effect is found that the file has already, the data contradict the file's; two of a kind are not written beside each other. So that one is taken
    // out and looked for anew.
    let mut forgotten: Vec<(String, Option<usize>)> = Vec::new();
    let baseline = found.baseline.clone();
    for _ in 0..2 {
        let known = plant.effects();
        let again = |name: &str, joint: Option<usize>| {
            let same = |c: &&Cause| c.cause == name && c.joints.first().map(|j| j - 1) == joint;
            !ADDS_UP.contains(&name) && found.causes.iter().any(|c| same(&c))
        };
        let before = forgotten.len();
        for (name, joint) in known {
            if again(&name, joint) && !forgotten.contains(&(name.clone(), joint)) {
                forgotten.push((name, joint));
            }
        }
        if forgotten.len() == before {
            break;
        }
        let Some(bare) = plant.without(&forgotten) else { break };
        progress("an effect of the file, anew");
        found = once(&*bare, fit, validate, settings, progress)?;
        found.forgotten.clone_from(&forgotten);
        found.baseline.clone_from(&baseline);
    }
    Ok(found)
}

/// Effects of which what is found can be written into the file beside what it has: totals, differences of bodies, further orders.
const ADDS_UP: [&str; 3] = ["time_delay", "link_inertia_error", "torque_ripple"];

/// [`diagnose`] with the effects of the file as they are.
fn once(
    plant: &dyn Plant,
    fit: &[Recording],
    validate: &[Recording],
    settings: &Settings,
    progress: &dyn Fn(&str),
) -> Result<Diagnosis, DiagnoseError> {
    let own_validation = !validate.is_empty();
    let halves = |recordings: &[Recording]| -> [Vec<Recording>; 2] {
        let parts: Vec<[Recording; 2]> = recordings.iter().map(|r| r.split(0.7)).collect();
        [0, 1].map(|which| parts.iter().map(|p| p[which].clone()).collect())
    };
    let recorded = [fit, validate].concat();
    let measured = if own_validation { validate.to_vec() } else { halves(fit)[1].clone() };
    let (whole, other) = (unexplained(plant, fit), unexplained(plant, validate));
    let [first, rest] = if own_validation { [Vec::new(), Vec::new()] } else { halves(&whole) };
    let (fit, validate) = if own_validation { (&whole[..], &other[..]) } else { (&first[..], &rest[..]) };
    let seconds: f64 = fit.iter().map(Recording::seconds).sum();
    let dof = plant.dof();
    let zeros = plant.delays();
    let noise = floor(&recorded, dof);
    let start = Bench::new(plant, fit, settings.rate, Mode::Trusted, &zeros, false);
    if seconds < 2.0 || start.scene.len < 100 {
        return Err(DiagnoseError::TooShort { seconds });
    }
    if start.target().iter().flatten().any(|y| !y.is_finite()) {
        return Err(DiagnoseError::NotFinite);
    }
    if fit.iter().flat_map(|r| &r.stretches).all(|s| s.tau.iter().all(|t| *t == 0.0)) {
        return Err(DiagnoseError::NoTorque);
    }
    let before = Meter::new(plant, validate, &start).of_the_file();
    let baseline = Errors { fit: Meter::new(plant, fit, &start).of_the_file().rms, validate: before.rms.clone() };
    let before = before.error;
    let torque_rms: Vec<f64> = (0..dof)
        .map(|j| {
            let all: Vec<f64> =
                measured.iter().flat_map(|r| &r.stretches).flat_map(|s| s.of(&s.tau, j).to_vec()).collect();
            root_mean_square(&all)
        })
        .collect();

    // The same after refitting: what remains is structure.
    let mut refit = Bench::new(plant, fit, settings.rate, Mode::Refitted, &zeros, false);
    let plain = refit.fit(&mut []);
    let refitted = Errors {
        fit: Meter::new(plant, fit, &refit).of(&refit, &plain, &[], false).rms,
        validate: Meter::new(plant, validate, &refit).of(&refit, &plain, &[], true).rms,
    };
    let ground: Vec<f64> = noise.iter().zip(&torque_rms).map(|(s, t)| s.max(0.004 * t)).collect();
    let (file_out, refit_out) = (start.file_left_out(), refit.left_out(&[], &plain));
    drop(refit);

    let has_links = plant.given().is_some_and(|g| g.iter().any(|v| *v != 0.0));
    let attempt = |mode: Mode| {
        let mut bench = Bench::new(plant, fit, settings.rate, mode, &zeros, false);
        let found = search(&mut bench, &noise, &settings.search, progress);
        (bench, found)
    };
    let (mut bench, mut found) = if has_links {
        progress("the file's links as they are");
        let (trusted, explained) = attempt(Mode::Trusted);
        let left = structure(&trusted.scene, &explained.fitted.residual, &noise, &torque_rms);
        let few = trusted.left_out(&chosen_of(&explained.accepted), &explained.fitted);
        if left.is_empty() && !refit_out.less(&few, &ground).pays() {
            (trusted, explained)
        } else {
            progress("all base parameters anew");
            let (free, other) = attempt(Mode::Refitted);
            let all = free.left_out(&chosen_of(&other.accepted), &other.fitted);
            if all.less(&few, &ground).pays() { (free, other) } else { (trusted, explained) }
        }
    } else {
        attempt(Mode::Refitted)
    };
    let fitted = freeze(&mut bench, &mut found, &noise);
    progress("what else plain friction might be");
    let (fitted, plain_rivals) = reconsider(&mut bench, &mut found.accepted, fitted, &noise, &settings.search);
    let fitted = prune(&mut bench, &mut found, fitted, &noise);
    let fitted = release(&mut bench, &mut found.accepted, fitted);
    progress("what holds on stretches that were left out");
    let mut why = Vec::new();
    let fitted = withdraw(plant, fit, &mut bench, &mut found.accepted, fitted, &ground, &mut why);
    let extended_out = bench.left_out(&chosen_of(&found.accepted), &fitted);
    let (offered, mut fitted) = offer(
        plant,
        fit,
        &mut bench,
        &mut found,
        fitted,
        [&file_out, &refit_out, &extended_out],
        &noise,
        &ground,
        &mut why,
    );
    let mut left = structure(&bench.scene, &fitted.residual, &noise, &torque_rms);

    // What a gain is measured by: the noise, or a fiftieth of the torque where the noise is less.
    let scale: Vec<f64> = noise.iter().zip(&torque_rms).map(|(s, t)| (s * s + (0.02 * t).powi(2)).sqrt()).collect();
    let mut round = 0;
    let (after, after_fit, mut causes) = loop {
        progress("measuring on data that was not used");
        let chosen = chosen_of(&found.accepted);
        let items = items(&bench, &found.accepted, &fitted);
        let [mut far, mut near] = [validate, fit].map(|data| Meter::new(plant, data, &bench));
        let after = far.of(&bench, &fitted, &chosen, true);
        let after_fit = near.of(&bench, &fitted, &chosen, false);
        let others: Vec<(Vec<f64>, Vec<f64>, [f64; 2])> = items
            .iter()
            .map(|item| {
                let here = here(item, &after);
                let (meter, with) = if here { (&mut near, &after_fit) } else { (&mut far, &after) };
                let without = leave_out(plant, fit, meter, &mut bench, &chosen, item, !here);
                let interval = bootstrap(&without, with, &item.place);
                (without.rms, without.steady, interval)
            })
            .collect();
        // The bench as it was, with everything in it.
        fitted = without(&mut bench, &mut found.accepted, &[]);
        let uncertainty = Uncertainty::of(&bench, &fitted, &chosen_of(&found.accepted));
        let mut causes: Vec<Cause> = Vec::new();
        for (item, (without, steady, interval)) in items.iter().zip(&others) {
            let (on, with) = if here(item, &after) { ("fit", &after_fit) } else { ("validate", &after) };
            causes.push(weigh(
                &bench,
                &fitted,
                &uncertainty,
                &found.accepted,
                &plain_rivals,
                item,
                [without, &with.rms],
                [steady, &with.steady],
                *interval,
                on,
                &noise,
            ));
        }
        // A cause that loses on data that was not used is no cause, and not in the model; that there was something to explain stays true.
        let gains = |i: usize| taken_of(&others[i].1, &after.steady, &scale);
        let holds = |i: usize| gains(i) > 0.0 && matters(&others[i].1, &after.steady, &noise);
        // What acts in a part of a log must still stand out beside everything else.
        let stands = |i: usize| !items[i].hypothesis.local() || causes[i].share >= settings.search.least_gain;
        let failed: Vec<usize> =
            (0..causes.len()).filter(|&i| if causes[i].on == "fit" { !stands(i) } else { !holds(i) }).collect();
        round += 1;
        if failed.is_empty() || round > 3 {
            break (after, after_fit, causes);
        }
        for c in failed.iter().filter(|i| gains(**i) <= 0.0).map(|&i| &causes[i]).filter(|c| c.curve.is_some()) {
            left.push(Structure {
                joint: c.joints.first().map_or(0, |j| j - 1),
                rms: 0.0,
                description: format!(
                    "{} on joint(s) {:?} explains the fitted logs but not the validating ones",
                    c.cause, c.joints
                ),
            });
        }
        for &k in failed.iter().flat_map(|&i| &items[i].friction) {
            let which = if bench.mode == Mode::Refitted { &mut bench.quiet } else { &mut bench.frozen };
            which[k] = true;
        }
        let out: Vec<usize> = failed.iter().filter_map(|&i| items[i].accepted).collect();
        fitted = without(&mut bench, &mut found.accepted, &out);
    };
    if bench.mode == Mode::Refitted && has_links {
        let joints = evidence::changed_links(&bench, &fitted, &fitted.covariance());
        if !joints.is_empty() {
            // What the file's links would leave beside all other causes.
            let mut believed = Bench::new(plant, fit, settings.rate, Mode::Trusted, &bench.scene.delays, false);
            believed.frozen = bench.frozen.clone();
            let mut others = chosen_of(&found.accepted);
            let trusting = believed.fit(&mut others);
            let without = Meter::new(plant, validate, &believed).of(&believed, &trusting, &others, true);
            let part = share(&without.rms, &after.rms, &noise, &[]);
            let full = bench.left_out(&chosen_of(&found.accepted), &fitted);
            let told = full.less(&believed.left_out(&others, &trusting), &ground);
            let links = Cause {
                cause: "link_inertia_error",
                evidence: format!(
                    "the base parameters of joint(s) {joints:?} differ from the file's by more than five of their standard deviations; with the file's own and everything else that was found {} N m are missed on the validating logs (RMS over joints), with these {} N m",
                    evidence::short(root_mean_square(&without.rms)),
                    evidence::short(root_mean_square(&after.rms)),
                ),
                joints,
                probability: calibration::LINKS,
                support: MOST_MARGIN,
                margin: MOST_MARGIN,
                share: part,
                parameters: Vec::new(),
                keys: Vec::new(),
                interval: bootstrap(&without, &after, &[]),
                rms_before: without.rms.clone(),
                rms_after: after.rms.clone(),
                on: "validate",
                not_distinguished_from: Vec::new(),
                shown_by: "an exciting motion for the base parameters",
                curve: None,
            };
            // It has to pay like any other.
            let gains = taken_of(&without.steady, &after.steady, &scale) > 0.0;
            if told.pays() && gains && matters(&without.steady, &after.steady, &noise) {
                causes.push(links);
            }
        }
    }
    causes.sort_by(|a, b| taken(b, &scale).total_cmp(&taken(a, &scale)));
    values_last(&mut causes, &scale);
    let verdict = match (causes.is_empty(), left.is_empty()) {
        (true, true) => Verdict::NothingWrong,
        (true, false) => Verdict::Unexplained,
        (false, true) => Verdict::Explained,
        (false, false) => Verdict::PartlyExplained,
    };
    unknown(&mut causes, &left, [&baseline.validate, &after.rms], &scale);
    let next_experiment =
        causes.iter().find(|c| !c.not_distinguished_from.is_empty() && c.cause != "unknown").map(|c| NextExperiment {
            between: std::iter::once(c.cause).chain(c.not_distinguished_from.iter().copied()).collect(),
            joints: c.joints.clone(),
            motion: c.shown_by.to_string(),
        });
    let curves = (0..dof).map(|j| curve(j, &after, &before)).collect();
    let maps = (0..dof).map(|j| after.view.maps(j, &before[j], &after.error[j])).collect();
    let extended = Errors { fit: after_fit.rms, validate: after.rms };
    Ok(Diagnosis {
        robot: plant.name().to_string(),
        verdict,
        noise_floor: noise,
        torque_rms,
        baseline,
        refitted,
        extended,
        has_links,
        links_refitted: bench.mode == Mode::Refitted,
        standard: bench.scene.standard.clone(),
        offer: Offer {
            offered,
            left_out: [file_out.rms(), refit_out.rms(), bench.left_out(&chosen_of(&found.accepted), &fitted).rms()],
            why,
        },
        friction: quiet(&bench, &fitted),
        forgotten: Vec::new(),
        causes,
        next_experiment,
        own_validation,
        seconds: [seconds, validate.iter().map(Recording::seconds).sum()],
        curves,
        maps,
    })
}
