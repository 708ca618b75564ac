//! The diagnosis from end to end: recordings in, [`Diagnosis`] out.

use crate::arm::Plant;

use super::calibration;
use super::causes::{AsymmetricFriction, COULOMB, Cause as Hypothesis, Kind, Named, OFFSET, VISCOUS};
use super::evidence::{self, Shown};
use super::maps::View;
use super::model::{Bench, Chosen, Fitted, Mode, Uncertainty, given_friction, parameters};
use super::noise::floor;
use super::offer::LeftOut;
use super::record::{Recording, unexplained};
use super::result::{Cause, Curve, Diagnosis, Errors, NextExperiment, Offer, Offered, Verdict};
use super::search::{Accepted, Found, Plain, SearchSettings, reconsider, search};
use super::structure::{Structure, structure};

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

/// Errors per joint and sample at the logs' own rate.
struct Measured {
    rms: Vec<f64>,
    /// The same where the joint moves: at reversals the sign of a velocity inside its noise errs by twice the Coulomb level, whatever the cause.
    steady: Vec<f64>,
    error: Vec<Vec<f64>>,
    time: Vec<f64>,
    view: View,
    /// Whether this data can show each of the chosen causes.
    shown: Vec<bool>,
}

const RAW: f64 = 1e9;

/// Measures models on recordings, every sample counted.
struct Meter<'a> {
    fine: Bench<'a>,
}

impl<'a> Meter<'a> {
    /// For models with the mode and the delays of `bench`.
    fn new(plant: &'a dyn Plant, recordings: &'a [Recording], bench: &Bench<'_>) -> Self {
        Self { fine: Bench::new(plant, recordings, RAW, bench.mode, &bench.scene.delays, true) }
    }

    /// Errors of the file as it is.
    fn of_the_file(&self) -> Measured {
        let error = vec![vec![0.0; self.fine.scene.len]; self.fine.scene.dof()];
        self.errors(error)
    }

    /// Errors of a fitted model. `elsewhere`: not on the recordings that it was fitted to, so that what acted in a part of them does not act here.
    fn of(&mut self, bench: &Bench<'_>, fitted: &Fitted, chosen: &[Chosen], elsewhere: bool) -> Measured {
        self.fine.adopt(bench, fitted);
        let mut x = fitted.solution.x.clone();
        for (c, first) in chosen.iter().zip(&fitted.first).filter(|(c, _)| elsewhere && c.cause.local()) {
            (0..c.x.len()).for_each(|k| x[first + k] = 0.0);
        }
        let shown = chosen.iter().map(|c| c.cause.shows(&self.fine.scene, &c.place, &c.shape)).collect();
        Measured { shown, ..self.errors(self.fine.predict(&x, chosen)) }
    }

    fn errors(&self, predicted: Vec<Vec<f64>>) -> Measured {
        let mut error = predicted;
        for (e, y) in error.iter_mut().zip(self.fine.target()) {
            e.iter_mut().zip(y).for_each(|(e, y)| *e = y - *e);
        }
        // A joint whose sensor was off has no error.
        for (j, e) in error.iter_mut().enumerate() {
            if self.fine.recordings.iter().flat_map(|r| &r.stretches).all(|s| s.of(&s.tau, j).iter().all(|t| *t == 0.0))
            {
                e.iter_mut().for_each(|e| *e = 0.0);
            }
        }
        let rms = error.iter().map(|e| root_mean_square(e)).collect();
        let scene = &self.fine.scene;
        let steady = (0..error.len())
            .map(|j| {
                let v = scene.own[j].iter().flat_map(|own| own.v.iter().copied());
                let moving = error[j].iter().zip(v).filter(|(_, v)| v.abs() > scene.dead[j]);
                let moving: Vec<f64> = moving.map(|(e, _)| *e).collect();
                root_mean_square(if 2 * moving.len() < error[j].len() { &error[j] } else { &moving })
            })
            .collect();
        let (time, view) = (self.fine.scene.time.clone(), View::of(&self.fine.scene));
        Measured { rms, steady, error, time, view, shown: Vec::new() }
    }
}

fn root_mean_square(x: &[f64]) -> f64 {
    (x.iter().map(|x| x * x).sum::<f64>() / x.len().max(1) as f64).sqrt()
}

/// A cause on its way into the result.
struct Item {
    hypothesis: &'static dyn Hypothesis,
    place: Vec<usize>,
    /// Among the accepted; `None`: a friction parameter.
    accepted: Option<usize>,
    /// Unknowns of friction that belong to it.
    friction: Vec<usize>,
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

fn chosen_of(accepted: &[Accepted]) -> Vec<Chosen> {
    accepted.iter().map(|a| a.chosen.clone()).collect()
}

/// The model without some of its accepted causes, fitted.
fn without(bench: &mut Bench<'_>, accepted: &mut Vec<Accepted>, out: &[usize]) -> Fitted {
    let given = bench.plant.delays();
    let mut late = vec![0.0; bench.scene.dof()];
    for c in out.iter().map(|&i| &accepted[i].chosen).filter(|c| c.cause.moves_time()) {
        let own: Vec<usize> = if c.place.is_empty() { (0..late.len()).collect() } else { c.place.clone() };
        own.iter().for_each(|&j| late[j] = given[j] - bench.scene.delays[j]);
    }
    bench.undo_delay(&late);
    let mut index = 0;
    accepted.retain(|_| {
        index += 1;
        !out.contains(&(index - 1))
    });
    let mut chosen = chosen_of(accepted);
    let fitted = bench.fit(&mut chosen);
    for (a, c) in accepted.iter_mut().zip(&chosen) {
        a.chosen = c.clone();
    }
    fitted
}

/// Where an item acts, in words.
fn place_of(place: &[usize]) -> String {
    match place {
        [] => "of the whole robot".into(),
        [j] => format!("of joint {}", j + 1),
        many => format!("of joints {}", many.iter().map(|j| (j + 1).to_string()).collect::<Vec<_>>().join(" and ")),
    }
}

/// Takes out, one after the other, what makes stretches of the fitted logs that are left out in turn worse.
fn withdraw(
    plant: &dyn Plant,
    fit: &[Recording],
    bench: &mut Bench<'_>,
    accepted: &mut Vec<Accepted>,
    mut fitted: Fitted,
    ground: &[f64],
    why: &mut Vec<String>,
) -> Fitted {
    for round in 0..12 {
        let chosen = chosen_of(accepted);
        let items = items(bench, accepted, &fitted);
        let stretches = bench.stretches(&chosen);
        let counts = stretches.counts();
        let with = LeftOut::new(&stretches.cross_validated(&fitted.solution), &counts);
        let mut worst = None;
        for item in items.iter().filter(|i| !i.hypothesis.local()) {
            let others = if item.hypothesis.moves_time() {
                if round > 0 {
                    continue;
                }
                let (reduced, others, fitted) = reduced(plant, fit, bench, &chosen, item);
                reduced.left_out(&others, &fitted)
            } else {
                let mut out: Vec<usize> = item.friction.iter().map(|k| fitted.friction + k).collect();
                out.extend(
                    item.accepted
                        .iter()
                        .flat_map(|&i| (0..fitted.terms[i].len()).map(move |t| (i, t)))
                        .map(|(i, t)| fitted.first[i] + t),
                );
                LeftOut::new(&stretches.cross_validated_without(&fitted.solution, &out), &counts)
            };
            let paired = with.less(&others, ground);
            if paired.gain < -1e-6
                && worst.as_ref().is_none_or(|(_, w): &(&Item, super::offer::Paired)| paired.gain < w.gain)
            {
                worst = Some((item, paired));
            }
        }
        let Some((item, paired)) = worst else { break };
        why.push(format!(
            "{} {} is not in the model: stretches of the fitted logs that were left out are predicted better without it ({:.1} +- {:.1} % of their squared error).",
            item.hypothesis.name(),
            place_of(&item.place),
            -200.0 * paired.gain,
            200.0 * paired.error
        ));
        item.friction.iter().for_each(|&k| bench.frozen[k] = true);
        let out: Vec<usize> = item.accepted.into_iter().collect();
        fitted = without(bench, accepted, &out);
    }
    fitted
}

/// Which of file, refitted file and extended model is offered, by what they predict of stretches that were left out; the bench and what was found become that.
#[allow(clippy::too_many_arguments)]
fn offer<'a>(
    plant: &'a dyn Plant,
    fit: &'a [Recording],
    bench: &mut Bench<'a>,
    found: &mut Found,
    mut fitted: Fitted,
    [file, refit, extended]: [&LeftOut; 3],
    noise: &[f64],
    ground: &[f64],
    why: &mut Vec<String>,
) -> (Offered, Fitted) {
    let zeros = plant.delays();
    let says = |what: &str, a: &LeftOut, b: &LeftOut| {
        let paired = a.less(b, ground);
        format!(
            "On stretches of the fitted logs that were left out in turn {what}: {} N m against {} N m ({:.0} +- {:.0} % less squared error, mean over joints).",
            evidence::short(a.rms()),
            evidence::short(b.rms()),
            200.0 * paired.gain / (1.0 + paired.gain),
            200.0 * paired.error / (1.0 + paired.gain),
        )
    };
    let mut offered =
        if found.accepted.is_empty() && bench.mode == Mode::Refitted { Offered::Refitted } else { Offered::Extended };
    let mut model = extended.clone();
    let beaten = match bench.mode {
        // Of two models that are as good the one with fewer unknowns.
        Mode::Trusted => refit.less(extended, ground).pays(),
        Mode::Refitted => !found.accepted.is_empty() && !extended.less(refit, ground).sure(),
    };
    if beaten {
        why.push(says("a plain refit predicts as well as the model with further causes, or better", refit, extended));
        found.accepted.clear();
        *bench = Bench::new(plant, fit, bench.rate, Mode::Refitted, &zeros, false);
        fitted = freeze(bench, found, noise);
        fitted = release(bench, &mut found.accepted, fitted);
        (offered, model) = (Offered::Refitted, refit.clone());
    }
    let changed = bench.mode == Mode::Refitted || !found.accepted.is_empty() || bench.frozen.iter().any(|f| !f);
    if !changed {
        return (Offered::File, fitted);
    }
    if !model.less(file, ground).sure() {
        why.push(says("nothing predicts surely better than the file as it is", &model, file));
        found.accepted.clear();
        *bench = Bench::new(plant, fit, bench.rate, Mode::Trusted, &zeros, false);
        bench.frozen.iter_mut().for_each(|f| *f = true);
        return (Offered::File, bench.fit(&mut []));
    }
    why.push(says(
        if offered == Offered::Extended {
            "the extended model predicts better than the file"
        } else {
            "the refitted file predicts better than the file as it is"
        },
        &model,
        file,
    ));
    (offered, fitted)
}

/// Takes out, the least sure first, causes whose coefficients do not stand out of their uncertainty, that of the shape included.
fn prune(bench: &mut Bench<'_>, found: &mut Found, mut fitted: Fitted, noise: &[f64]) -> Fitted {
    loop {
        let chosen: Vec<Chosen> = found.accepted.iter().map(|a| a.chosen.clone()).collect();
        let uncertainty = Uncertainty::of(bench, &fitted, &chosen);
        let least = (0..chosen.len())
            .map(|index| (index, uncertainty.stands_out(bench, &fitted, index, &chosen[index])))
            .min_by(|a, b| a.1.total_cmp(&b.1));
        let Some((index, _)) = least.filter(|l| l.1 < 0.0) else { return fitted };
        let gone = found.accepted.remove(index).chosen;
        // Plain friction may have given way to it.
        gone.place.iter().for_each(|j| bench.frozen[3 * j..3 * j + 3].fill(false));
        if gone.cause.moves_time() {
            let all: Vec<usize> = (0..bench.scene.dof()).collect();
            for &j in if gone.place.is_empty() { &all } else { &gone.place } {
                let given = bench.plant.delays()[j];
                bench.delay(&[j], given - bench.scene.delays[j]);
            }
        }
        fitted = freeze(bench, found, noise);
    }
}

/// Friction parameters that the data do not want changed go back to the file's values.
fn freeze(bench: &mut Bench<'_>, found: &mut Found, noise: &[f64]) -> Fitted {
    let mut chosen: Vec<Chosen> = found.accepted.iter().map(|a| a.chosen.clone()).collect();
    let mut fitted = bench.fit(&mut chosen);
    let given = given_friction(bench.plant);
    for _ in 0..4 {
        let covariance = fitted.covariance();
        let mut changed = false;
        for j in 0..bench.scene.dof() {
            // One at a time: of two that say nearly the same, neither seems to be wanted while the other is there.
            let mut least: Option<(usize, f64)> = None;
            for which in 0..3 {
                let k = 3 * j + which;
                if bench.frozen[k] {
                    continue;
                }
                let at = fitted.friction + k;
                let (value, std) = (fitted.solution.x[at], covariance[(at, at)].max(0.0).sqrt());
                // What this much of it does to the torque that the others can't: 1 / sqrt(inverse diagonal) is the column's own size.
                let own = fitted.solution.inverse[(at, at)];
                let weight = fitted.solution.weights[j] * fitted.solution.counts[j];
                let effect = if own > 0.0 && weight > 0.0 { value.abs() / (own * weight).sqrt() } else { 0.0 };
                let small = value.abs() < 0.04 * given[j][which].unwrap_or(0.0).abs();
                // Friction that drives the joint is none.
                let drives = which < 2 && given[j][which].unwrap_or(0.0) + value < 0.0;
                let sure = if std > 0.0 { value.abs() / std } else { 0.0 };
                if (sure < 4.5 || effect < 0.2 * noise[j] || small || drives) && least.is_none_or(|(_, s)| sure < s) {
                    least = Some((k, sure));
                }
            }
            if let Some((k, _)) = least {
                bench.frozen[k] = true;
                changed = true;
            }
        }
        if !changed {
            break;
        }
        fitted = bench.fit(&mut chosen);
    }
    for (a, c) in found.accepted.iter_mut().zip(&chosen) {
        a.chosen = c.clone();
    }
    fitted
}

/// Where all base parameters are unknown so is friction: what went back to the file's values because it is too little or too unsure to be named is part of the model
/// again, so that this is never less than a plain refit. Friction that would drive a joint stays out.
fn release(bench: &mut Bench<'_>, accepted: &mut [Accepted], fitted: Fitted) -> Fitted {
    if bench.mode != Mode::Refitted {
        return fitted;
    }
    let frozen = bench.frozen.clone();
    let mut chosen = chosen_of(accepted);
    bench.quiet.clone_from(&frozen);
    bench.frozen.iter_mut().for_each(|f| *f = false);
    let given = given_friction(bench.plant);
    let mut fitted = bench.fit(&mut chosen);
    for _ in 0..3 {
        let drives = |k: &usize| {
            let (j, which) = (k / 3, k % 3);
            which < 2
                && !bench.frozen[*k]
                && given[j][which].unwrap_or(0.0) + fitted.solution.x[fitted.friction + k] < 0.0
        };
        let out: Vec<usize> = (0..frozen.len()).filter(drives).collect();
        if out.is_empty() {
            break;
        }
        out.iter().for_each(|&k| (bench.frozen[k], bench.quiet[k]) = (true, false));
        fitted = bench.fit(&mut chosen);
    }
    for (a, c) in accepted.iter_mut().zip(&chosen) {
        a.chosen = c.clone();
    }
    fitted
}

/// The accepted causes, and the friction parameters that changed and belong to none of them.
fn items(bench: &Bench<'_>, accepted: &[Accepted], fitted: &Fitted) -> Vec<Item> {
    let mut items: Vec<Item> = accepted
        .iter()
        .enumerate()
        .map(|(index, a)| Item {
            hypothesis: a.chosen.cause,
            place: a.chosen.place.clone(),
            accepted: Some(index),
            friction: Vec::new(),
        })
        .collect();
    let given = given_friction(bench.plant);
    for j in 0..bench.scene.dof() {
        for (which, hypothesis) in [&VISCOUS, &COULOMB, &OFFSET].into_iter().enumerate() {
            let k = 3 * j + which;
            if bench.frozen[k] || bench.quiet[k] {
                continue;
            }
            // Where a friction law was found, the plain terms that the file already has are part of it.
            let owner = items.iter_mut().find(|i| {
                let friction = i.hypothesis.kind() == Kind::Friction && which < 2 && given[j][which].is_some();
                let shift = which == 2 && i.hypothesis.has_constant();
                i.accepted.is_some() && i.place == [j] && (friction || shift)
            });
            match owner {
                Some(owner) => owner.friction.push(k),
                None => items.push(Item { hypothesis, place: vec![j], accepted: None, friction: vec![k] }),
            }
        }
    }
    one_for_two(items, bench, fitted)
}

/// Of a level and an offset, neither next to nothing beside the other, the smaller is taken for half a difference of levels.
const BESIDE: f64 = 0.15;

/// A changed Coulomb level and an offset on one joint are, with as many unknowns, one cause: levels that differ with the direction. It takes their place where
/// both levels are of friction.
fn one_for_two(mut items: Vec<Item>, bench: &Bench<'_>, fitted: &Fitted) -> Vec<Item> {
    let given = given_friction(bench.plant);
    for (j, given) in given.iter().enumerate() {
        let plain = |which: usize| {
            let here = |i: &Item| i.accepted.is_none() && i.friction == [3 * j + which];
            items.iter().position(here).map(|at| (at, fitted.solution.x[fitted.friction + 3 * j + which]))
        };
        let (Some((level_at, level)), Some((offset_at, offset))) = (plain(1), plain(2)) else { continue };
        let (small, large) = (level.abs().min(offset.abs()), level.abs().max(offset.abs()));
        if small < BESIDE * large || offset.abs() > given[1].unwrap_or(0.0) + level {
            continue;
        }
        items[level_at] = Item {
            hypothesis: &AsymmetricFriction,
            place: vec![j],
            accepted: None,
            friction: vec![3 * j + 1, 3 * j + 2],
        };
        items.remove(offset_at);
    }
    items
}

/// Values of the friction parameters that belong to an item.
fn friction_values(bench: &Bench<'_>, fitted: &Fitted, covariance: &nalgebra::DMatrix<f64>, item: &Item) -> Vec<Named> {
    let given = given_friction(bench.plant);
    item.friction
        .iter()
        .map(|&k| {
            let (j, which, at) = (k / 3, k % 3, fitted.friction + k);
            let base = if which == 2 && item.accepted.is_none() { 0.0 } else { given[j][which].unwrap_or(0.0) };
            Named {
                symbol: ["FV", "FC", "TO"][which].to_string(),
                value: base + fitted.solution.x[at],
                std: Some(covariance[(at, at)].max(0.0).sqrt()),
            }
        })
        .collect()
}

/// Friction that is in the model but no news, for the file.
fn quiet(bench: &Bench<'_>, fitted: &Fitted) -> Vec<Cause> {
    let covariance = fitted.covariance();
    (0..bench.quiet.len())
        .filter(|&k| bench.quiet[k] && !bench.frozen[k])
        .map(|k| {
            let hypothesis: &'static dyn Hypothesis = [&VISCOUS, &COULOMB, &OFFSET][k % 3];
            let item = Item { hypothesis, place: vec![k / 3], accepted: None, friction: vec![k] };
            Cause {
                cause: hypothesis.name(),
                joints: vec![k / 3 + 1],
                probability: 0.0,
                keys: friction_values(bench, fitted, &covariance, &item),
                parameters: Vec::new(),
                support: 0.0,
                margin: 0.0,
                share: 0.0,
                evidence: String::new(),
                rms_before: Vec::new(),
                rms_after: Vec::new(),
                interval: [f64::NAN; 2],
                on: "fit",
                not_distinguished_from: Vec::new(),
                shown_by: hypothesis.shown_by(),
                curve: None,
            }
        })
        .collect()
}

/// Whether a cause is measured on the fitted logs: it acts in a part of one of them, or the validating ones can't show it, and so can't refute it.
fn here(item: &Item, after: &Measured) -> bool {
    item.hypothesis.local() || item.accepted.is_some_and(|index| !after.shown[index])
}

/// Errors of the model that is fitted without one of its causes; the bench is left with that.
fn leave_out<'a>(
    plant: &'a dyn Plant,
    fit: &'a [Recording],
    meter: &mut Meter<'a>,
    bench: &mut Bench<'_>,
    chosen: &[Chosen],
    item: &Item,
    elsewhere: bool,
) -> Measured {
    if item.hypothesis.moves_time() {
        let (reduced, others, fitted) = reduced(plant, fit, bench, chosen, item);
        return Meter::new(plant, meter.fine.recordings, &reduced).of(&reduced, &fitted, &others, elsewhere);
    }
    let frozen = bench.frozen.clone();
    item.friction.iter().for_each(|&k| bench.frozen[k] = true);
    let mut others: Vec<Chosen> =
        chosen.iter().enumerate().filter(|(i, _)| item.accepted != Some(*i)).map(|(_, c)| c.clone()).collect();
    let fitted = bench.fit(&mut others);
    let measured = match bench.scene.delays == meter.fine.scene.delays {
        true => meter.of(bench, &fitted, &others, elsewhere),
        // Without this the delay is another.
        false => Meter::new(plant, meter.fine.recordings, bench).of(bench, &fitted, &others, elsewhere),
    };
    bench.frozen = frozen;
    measured
}

/// The model that is fitted without one of its causes.
fn reduced<'a>(
    plant: &'a dyn Plant,
    fit: &'a [Recording],
    bench: &Bench<'_>,
    chosen: &[Chosen],
    item: &Item,
) -> (Bench<'a>, Vec<Chosen>, Fitted) {
    let mut delays = bench.scene.delays.clone();
    if item.hypothesis.moves_time() {
        // The delay's own part of the shift goes.
        let own: Vec<usize> = if item.place.is_empty() { (0..delays.len()).collect() } else { item.place.clone() };
        let given = plant.delays();
        own.iter().for_each(|&j| delays[j] = given[j]);
    }
    let mut reduced = Bench::new(plant, fit, bench.rate, bench.mode, &delays, false);
    (reduced.frozen, reduced.quiet, reduced.hold) = (bench.frozen.clone(), bench.quiet.clone(), bench.hold.clone());
    item.friction.iter().for_each(|&k| reduced.frozen[k] = true);
    let mut others: Vec<Chosen> =
        chosen.iter().enumerate().filter(|(i, _)| item.accepted != Some(*i)).map(|(_, c)| c.clone()).collect();
    let fitted = reduced.fit(&mut others);
    (reduced, others, fitted)
}

/// An item as a cause of the result.
#[allow(clippy::too_many_arguments)]
fn weigh(
    bench: &Bench<'_>,
    fitted: &Fitted,
    uncertainty: &Uncertainty,
    all: &[Accepted],
    plain_rivals: &[Plain],
    item: &Item,
    [without, with]: [&[f64]; 2],
    steady: [&[f64]; 2],
    interval: [f64; 2],
    on: &'static str,
    noise: &[f64],
) -> Cause {
    let mut keys = match item.accepted {
        Some(index) => parameters(bench, fitted, uncertainty, index, &all[index].chosen),
        None => friction_values(bench, fitted, &uncertainty.covariance, item),
    };
    if item.accepted.is_some() {
        for named in friction_values(bench, fitted, &uncertainty.covariance, item) {
            if keys.iter().all(|k| k.symbol != named.symbol) {
                keys.push(named);
            }
        }
    }
    let suffix = item.place.first().map(|j| (j + 1).to_string()).unwrap_or_default();
    let parameters: Vec<Named> =
        keys.iter().map(|k| Named { symbol: format!("{}{suffix}", k.symbol), ..k.clone() }).collect();
    let accepted = item.accepted.map(|a| &all[a]);
    let margin = near(item, accepted, plain_rivals).iter().map(|r| r.2.max(0.0)).fold(MOST_MARGIN, f64::min);
    let part = share(steady[0], steady[1], noise, &item.place);
    let support = accepted.map_or_else(|| plain_support(fitted, &uncertainty.covariance, item), |a| a.support);
    Cause {
        cause: item.hypothesis.name(),
        joints: item.place.iter().map(|j| j + 1).collect(),
        probability: calibration::probability(item.accepted.is_none(), support, margin, part),
        support,
        margin,
        share: part,
        evidence: evidence::sentence(&Shown {
            cause: item.hypothesis,
            place: &item.place,
            parameters: &parameters,
            before: without,
            after: with,
            noise,
            on,
            confirmed: accepted.map(|a| a.confirmed),
        }),
        curve: item.accepted.and_then(|index| evidence::curve(bench, fitted, index, &all[index].chosen)),
        parameters,
        keys,
        interval,
        rms_before: without.to_vec(),
        rms_after: with.to_vec(),
        on,
        not_distinguished_from: confusable(bench, item, accepted, plain_rivals),
        shown_by: item.hypothesis.shown_by(),
    }
}

/// Whether a cause takes as much on some joint as a torque of half of the noise would.
fn matters(before: &[f64], after: &[f64], noise: &[f64]) -> bool {
    let joints = before.iter().zip(after).zip(noise);
    joints.map(|((a, b), s)| a * a - b * b - (0.5 * s).powi(2)).any(|x| x > 0.0)
}

/// How much error a cause takes: the logarithm of the ratio of root mean squares without and with it, noise added to both, summed over joints; so no
/// joint counts for more than another by the size of its torques.
fn taken(cause: &Cause, noise: &[f64]) -> f64 {
    taken_of(&cause.rms_before, &cause.rms_after, noise)
}

/// The same of errors without and with it.
fn taken_of(before: &[f64], after: &[f64], noise: &[f64]) -> f64 {
    let joints = before.iter().zip(after).zip(noise);
    joints.map(|((a, b), s)| 0.5 * ((a * a + s * s).max(1e-24) / (b * b + s * s).max(1e-24)).ln()).sum()
}

/// 90 % interval of the share of the squared error on the main joint that the cause takes: moving blocks of half a second (Kuensch 1989).
fn bootstrap(without: &Measured, with: &Measured, place: &[usize]) -> [f64; 2] {
    let main = place.first().copied().unwrap_or_else(|| {
        let gain = |j: &usize| without.rms[*j].powi(2) - with.rms[*j].powi(2);
        (0..with.rms.len()).max_by(|a, b| gain(a).total_cmp(&gain(b))).unwrap_or(0)
    });
    let (Some(a), Some(b)) = (without.error.get(main), with.error.get(main)) else { return [f64::NAN; 2] };
    let step = with.time.windows(2).map(|w| w[1] - w[0]).find(|d| *d > 0.0).unwrap_or(0.01);
    let length = ((0.5 / step) as usize).max(1);
    let n = a.len().min(b.len());
    let sums: Vec<[f64; 2]> = (0..n / length)
        .map(|i| {
            let span = i * length..(i + 1) * length;
            [a[span.clone()].iter().map(|e| e * e).sum(), b[span].iter().map(|e| e * e).sum()]
        })
        .collect();
    if sums.len() < 4 {
        return [f64::NAN; 2];
    }
    let mut random = crate::numeric::random::Random::new(1);
    let mut shares: Vec<f64> = (0..400)
        .map(|_| {
            let (mut before, mut after) = (0.0, 0.0);
            for _ in 0..sums.len() {
                let pick = sums[random.below(sums.len())];
                before += pick[0];
                after += pick[1];
            }
            if before > 0.0 { 1.0 - after / before } else { 0.0 }
        })
        .collect();
    shares.sort_by(f64::total_cmp);
    [shares[20], shares[379]]
}

/// A margin beyond which more of it says nothing.
const MOST_MARGIN: f64 = 1e4;

/// What no value of a link's parameter explains is named before those values, where it takes half of the squared error of a joint beside them, or a quarter of that of all:
/// what is wrong with a recording or an arm as a whole, whatever stands in the file; and every cause where all parameters were refitted as a matter of course.
fn values_last(causes: &mut Vec<Cause>, noise: &[f64]) {
    let Some(at) = causes.iter().position(|c| c.cause == "link_inertia_error") else { return };
    let refitted = causes[at].keys.is_empty();
    let structure = |c: &Cause| {
        let joints = c.rms_before.iter().zip(&c.rms_after).zip(noise);
        let shares: Vec<f64> = joints.map(|((b, a), s)| (b * b - a * a) / (b * b + s * s).max(1e-24)).collect();
        let most = shares.iter().copied().fold(0.0, f64::max);
        most > 0.5 || shares.iter().sum::<f64>() > 0.25 * shares.len() as f64
    };
    let value = |c: &Cause| ["link_inertia_error", "payload", "unknown"].contains(&c.cause);
    let tail = causes.split_off(at);
    let (first, rest): (Vec<Cause>, Vec<Cause>) =
        tail.into_iter().partition(|c| !value(c) && (refitted || c.joints.is_empty()) && structure(c));
    causes.extend(first);
    causes.extend(rest);
}

/// Part of the squared error above the noise that goes: of the main joint, or of the one with the most to gain.
fn share(before: &[f64], after: &[f64], noise: &[f64], place: &[usize]) -> f64 {
    let gain = |j: usize| before[j].powi(2) - after[j].powi(2);
    let joint = (0..before.len())
        .max_by(|a, b| (gain(*a) / noise[*a].powi(2).max(1e-12)).total_cmp(&(gain(*b) / noise[*b].powi(2).max(1e-12))));
    let joint = place.first().copied().or(joint).unwrap_or(0);
    let above = before[joint].powi(2) - noise[joint].powi(2);
    if above > 0.0 { (gain(joint) / above).clamp(-1.0, 1.0) } else { 0.0 }
}

/// Of a plain term of friction: the square of its value by its standard deviation, of the surest one.
fn plain_support(fitted: &Fitted, covariance: &nalgebra::DMatrix<f64>, item: &Item) -> f64 {
    let squares = item.friction.iter().map(|k| {
        let at = fitted.friction + k;
        let variance = covariance[(at, at)];
        if variance > 0.0 { fitted.solution.x[at].powi(2) / variance } else { 0.0 }
    });
    squares.fold(0.0, f64::max)
}

/// What says nearly the same as an item: cause, place, difference of support.
fn near<'a>(item: &Item, accepted: Option<&'a Accepted>, plain: &'a [Plain]) -> &'a [(&'static str, Vec<usize>, f64)] {
    match accepted {
        Some(accepted) => accepted.rivals.as_slice(),
        None => plain.iter().find(|p| item.place == [p.joint]).map(|p| p.rivals.as_slice()).unwrap_or_default(),
    }
}

/// What this data, or any data, can't tell from a cause.
fn confusable(bench: &Bench<'_>, item: &Item, accepted: Option<&Accepted>, plain: &[Plain]) -> Vec<&'static str> {
    let mut names: Vec<&'static str> = near(item, accepted, plain).iter().map(|r| r.0).collect();
    names.extend(item.hypothesis.twins(&bench.scene, &item.place));
    // One cause in the place of several plain ones.
    if item.accepted.is_none() && item.friction.len() > 1 {
        names.extend(item.friction.iter().map(|k| [&VISCOUS, &COULOMB, &OFFSET][k % 3].name()));
    }
    names.sort_unstable();
    names.dedup();
    names.retain(|n| *n != item.hypothesis.name());
    names
}

/// What is left without a name.
fn unknown(causes: &mut Vec<Cause>, left: &[Structure], [baseline, rms]: [&[f64]; 2], noise: &[f64]) {
    if left.is_empty() {
        return;
    }
    let mut left = left.to_vec();
    left.sort_by(|a, b| (b.rms / noise[b.joint].max(1e-12)).total_cmp(&(a.rms / noise[a.joint].max(1e-12))));
    let mut joints: Vec<usize> = Vec::new();
    left.iter().map(|s| s.joint + 1).for_each(|j| {
        if !joints.contains(&j) {
            joints.push(j)
        }
    });
    let sentences: Vec<&str> = left.iter().map(|s| s.description.as_str()).collect();
    let mut after = rms.to_vec();
    for s in &left {
        after[s.joint] = (rms[s.joint].powi(2) - s.rms.powi(2)).max(0.0).sqrt();
    }
    let mut entry = Cause {
        cause: "unknown",
        support: MOST_MARGIN,
        margin: MOST_MARGIN,
        share: share(rms, &after, noise, &[]),
        joints,
        probability: calibration::UNKNOWN_FIRST,
        parameters: Vec::new(),
        keys: Vec::new(),
        evidence: format!("structure is left that no listed cause explains: {}", sentences.join("; ")),
        rms_before: rms.to_vec(),
        rms_after: after,
        interval: [f64::NAN; 2],
        on: "fit",
        not_distinguished_from: Vec::new(),
        shown_by: "a longer recording with slow and fast motion of the named joints",
        curve: None,
    };
    // First, where more is left than the causes explain; else last: it gains nothing.
    if taken(&entry, noise) > taken_of(baseline, rms, noise) {
        causes.insert(0, entry);
    } else {
        entry.probability = calibration::UNKNOWN_BESIDE;
        causes.push(entry);
    }
}

/// Torque and errors over time, at most 2,000 points.
fn curve(j: usize, after: &Measured, before: &[Vec<f64>]) -> Curve {
    let n = after.error[j].len().min(before[j].len());
    let every = n.div_ceil(2000).max(1);
    let fine = |x: &[f64]| -> Vec<f64> { x[..n].iter().step_by(every).copied().collect() };
    Curve {
        t: fine(&after.view.clock()),
        measured: fine(&after.view.torque[j]),
        before: fine(&before[j]),
        after: fine(&after.error[j]),
    }
}
