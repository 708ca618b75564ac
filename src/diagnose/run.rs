//! The diagnosis from end to end: recordings in, [`Diagnosis`] out.

use crate::arm::Plant;

use super::calibration;
use super::causes::{AsymmetricFriction, COULOMB, Cause as Hypothesis, Kind, Named, OFFSET, VISCOUS};
use super::evidence::{self, Shown};
use super::maps::View;
use super::model::{Bench, Chosen, Fitted, Mode, Uncertainty, given_friction, parameters};
use super::noise::floor;
use super::record::Recording;
use super::result::{Cause, Curve, Diagnosis, Errors, NextExperiment, Verdict};
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
    let zeros = vec![0.0; plant.dof()];
    let bench = Bench::new(plant, recordings, settings.rate, Mode::Trusted, &zeros, false);
    measure(plant, recordings, &bench, None, &[], true).rms
}

/// Errors per joint and sample at the logs' own rate.
struct Measured {
    rms: Vec<f64>,
    error: Vec<Vec<f64>>,
    time: Vec<f64>,
    view: View,
    /// Whether this data can show each of the chosen causes.
    shown: Vec<bool>,
}

const RAW: f64 = 1e9;

/// Errors of a fitted model on recordings, every sample counted. `elsewhere`: not those that it was fitted to, so that what acted in a part of them
/// does not act here.
fn measure<'a>(
    plant: &'a dyn Plant,
    recordings: &'a [Recording],
    bench: &Bench<'_>,
    fitted: Option<&Fitted>,
    chosen: &[Chosen],
    elsewhere: bool,
) -> Measured {
    let mut fine = Bench::new(plant, recordings, RAW, bench.mode, &bench.scene.delays, true);
    let mut error = match fitted {
        Some(fitted) => {
            fine.adopt(bench, fitted);
            let mut x = fitted.solution.x.clone();
            for (c, first) in chosen.iter().zip(&fitted.first).filter(|(c, _)| elsewhere && c.cause.local()) {
                (0..c.x.len()).for_each(|k| x[first + k] = 0.0);
            }
            fine.predict(&x, chosen)
        }
        None => vec![vec![0.0; fine.scene.len]; fine.scene.dof()],
    };
    for (e, y) in error.iter_mut().zip(fine.target()) {
        e.iter_mut().zip(y).for_each(|(e, y)| *e = y - *e);
    }
    // A joint whose sensor was off has no error.
    for (j, e) in error.iter_mut().enumerate() {
        if recordings.iter().flat_map(|r| &r.stretches).all(|s| s.of(&s.tau, j).iter().all(|t| *t == 0.0)) {
            e.iter_mut().for_each(|e| *e = 0.0);
        }
    }
    let rms = error.iter().map(|e| root_mean_square(e)).collect();
    let shown = chosen.iter().map(|c| c.cause.shows(&fine.scene, &c.place, &c.shape)).collect();
    Measured { rms, error, time: fine.scene.time.clone(), view: View::of(&fine.scene), shown }
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
    let own_validation = !validate.is_empty();
    let parts: Vec<[Recording; 2]> =
        if own_validation { Vec::new() } else { fit.iter().map(|r| r.split(0.7)).collect() };
    let first: Vec<Recording> = parts.iter().map(|p| p[0].clone()).collect();
    let rest: Vec<Recording> = parts.iter().map(|p| p[1].clone()).collect();
    let (fit, validate) = if own_validation { (fit, validate) } else { (&first[..], &rest[..]) };
    let seconds: f64 = fit.iter().map(Recording::seconds).sum();
    let dof = plant.dof();
    let zeros = vec![0.0; dof];
    let noise = floor(&[fit, validate].concat(), dof);
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
    let baseline = Errors {
        fit: measure(plant, fit, &start, None, &[], false).rms,
        validate: measure(plant, validate, &start, None, &[], true).rms,
    };
    let before = measure(plant, validate, &start, None, &[], true).error;
    let torque_rms: Vec<f64> = (0..dof)
        .map(|j| {
            let all: Vec<f64> =
                validate.iter().flat_map(|r| &r.stretches).flat_map(|s| s.of(&s.tau, j).to_vec()).collect();
            root_mean_square(&all)
        })
        .collect();

    // The same after refitting: what remains is structure.
    let mut refit = Bench::new(plant, fit, settings.rate, Mode::Refitted, &zeros, false);
    let plain = refit.fit(&mut []);
    let refitted = Errors {
        fit: measure(plant, fit, &refit, Some(&plain), &[], false).rms,
        validate: measure(plant, validate, &refit, Some(&plain), &[], true).rms,
    };
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
        if left.is_empty() {
            (trusted, explained)
        } else {
            progress("all base parameters anew");
            let (free, other) = attempt(Mode::Refitted);
            if pays(&explained.fitted, &other.fitted) { (free, other) } else { (trusted, explained) }
        }
    } else {
        attempt(Mode::Refitted)
    };
    let fitted = freeze(&mut bench, &mut found, &noise);
    progress("what else plain friction might be");
    let (fitted, plain_rivals) = reconsider(&mut bench, &mut found.accepted, fitted, &noise, &settings.search);
    let fitted = prune(&mut bench, &mut found, fitted, &noise);
    let items = items(&bench, &found, &fitted);
    let chosen: Vec<Chosen> = found.accepted.iter().map(|a| a.chosen.clone()).collect();
    let mut left = structure(&bench.scene, &fitted.residual, &noise, &torque_rms);

    progress("measuring on data that was not used");
    let after = measure(plant, validate, &bench, Some(&fitted), &chosen, true);
    let after_fit = measure(plant, fit, &bench, Some(&fitted), &chosen, false);
    let uncertainty = Uncertainty::of(&bench, &fitted, &chosen);
    let covariance = &uncertainty.covariance;
    let mut causes: Vec<Cause> = Vec::new();
    for item in &items {
        // What the validating logs can't show, they can't refute.
        let local = item.hypothesis.local() || item.accepted.is_some_and(|index| !after.shown[index]);
        let (on, data, with) = if local { ("fit", fit, &after_fit) } else { ("validate", validate, &after) };
        let without = leave_out(plant, fit, data, &bench, &chosen, item);
        let keys = match item.accepted {
            Some(index) => parameters(&bench, &fitted, &uncertainty, index, &chosen[index]),
            None => friction_values(&bench, &fitted, covariance, item),
        };
        let extra = match item.accepted {
            Some(_) => friction_values(&bench, &fitted, covariance, item),
            None => Vec::new(),
        };
        let mut keys = keys;
        for named in extra {
            if keys.iter().all(|k| k.symbol != named.symbol) {
                keys.push(named);
            }
        }
        let suffix = item.place.first().map(|j| (j + 1).to_string()).unwrap_or_default();
        let parameters: Vec<Named> =
            keys.iter().map(|k| Named { symbol: format!("{}{suffix}", k.symbol), ..k.clone() }).collect();
        let accepted = item.accepted.map(|a| &found.accepted[a]);
        let interval = bootstrap(&without, with, &item.place);
        let rivals = confusable(&bench, item, accepted, &plain_rivals);
        let margin = near(item, accepted, &plain_rivals).iter().map(|r| r.2.max(0.0)).fold(MOST_MARGIN, f64::min);
        let part = share(&without.rms, &with.rms, &noise, &item.place);
        let support = accepted.map_or_else(|| plain_support(&fitted, covariance, item), |a| a.support);
        causes.push(Cause {
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
                before: &without.rms,
                after: &with.rms,
                noise: &noise,
                on,
                confirmed: accepted.map(|a| a.confirmed),
            }),
            curve: item.accepted.and_then(|index| evidence::curve(&bench, &fitted, index, &chosen[index])),
            parameters,
            keys,
            rms_before: without.rms,
            rms_after: with.rms.clone(),
            interval,
            on,
            not_distinguished_from: rivals,
            shown_by: item.hypothesis.shown_by(),
        });
    }
    if bench.mode == Mode::Refitted && has_links {
        let joints = evidence::changed_links(&bench, &fitted, covariance);
        if !joints.is_empty() {
            causes.push(Cause {
                cause: "link_inertia_error",
                evidence: format!("the base parameters of joint(s) {joints:?} differ from the file's by more than five of their standard deviations"),
                joints,
                probability: calibration::LINKS,
                support: MOST_MARGIN,
                margin: MOST_MARGIN,
                share: share(&baseline.validate, &refitted.validate, &noise, &[]),
                parameters: Vec::new(),
                keys: Vec::new(),
                rms_before: baseline.validate.clone(),
                rms_after: refitted.validate.clone(),
                interval: [f64::NAN; 2],
                on: "validate",
                not_distinguished_from: Vec::new(),
                shown_by: "an exciting motion for the base parameters",
                curve: None,
            });
        }
    }
    // What a gain is measured by: the noise, or a fiftieth of the torque where the noise is less.
    let scale: Vec<f64> = noise.iter().zip(&torque_rms).map(|(s, t)| (s * s + (0.02 * t).powi(2)).sqrt()).collect();
    causes.sort_by(|a, b| taken(b, &scale).total_cmp(&taken(a, &scale)));
    // A cause that loses on data that was not used is no cause; that there was something to explain stays true.
    let (causes_that_hold, failed): (Vec<Cause>, Vec<Cause>) =
        causes.into_iter().partition(|c| c.on == "fit" || (taken(c, &scale) > 0.0 && matters(c, &noise)));
    let mut causes = causes_that_hold;
    left.extend(failed.iter().filter(|c| c.curve.is_some() && taken(c, &scale) <= 0.0).map(|c| Structure {
        joint: c.joints.first().map_or(0, |j| j - 1),
        rms: 0.0,
        description: format!(
            "{} on joint(s) {:?} explains the fitted logs but not the validating ones",
            c.cause, c.joints
        ),
    }));
    let verdict = match (causes.is_empty(), left.is_empty()) {
        (true, true) => Verdict::NothingWrong,
        (true, false) => Verdict::Unexplained,
        (false, true) => Verdict::Explained,
        (false, false) => Verdict::PartlyExplained,
    };
    unknown(&mut causes, &left, &after.rms, &scale);
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
        causes,
        next_experiment,
        own_validation,
        seconds: [seconds, validate.iter().map(Recording::seconds).sum()],
        curves,
        maps,
    })
}

/// Whether all base parameters anew predict left-out parts of the data better than the few causes of the trusted file do, joint by joint
/// in the logarithm, beyond a twentieth.
fn pays(trusted: &Fitted, free: &Fitted) -> bool {
    let sums = |fitted: &Fitted| {
        let mut sums = vec![0.0; fitted.solution.rss.len()];
        for part in fitted.moments.cross_validated(&fitted.solution) {
            sums.iter_mut().zip(part).for_each(|(s, p)| *s += p);
        }
        sums
    };
    let (a, b) = (sums(trusted), sums(free));
    let live = trusted.solution.counts.iter().filter(|n| **n > 0.0).count().max(1) as f64;
    let logs: f64 = a.iter().zip(&b).filter(|(a, b)| **a > 1e-200 && **b > 1e-200).map(|(a, b)| (a / b).ln()).sum();
    logs / live > 0.05
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
                bench.delay(&[j], -bench.scene.delays[j]);
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

/// The accepted causes, and the friction parameters that changed and belong to none of them.
fn items(bench: &Bench<'_>, found: &Found, fitted: &Fitted) -> Vec<Item> {
    let mut items: Vec<Item> = found
        .accepted
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
            if bench.frozen[k] {
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

/// Errors on `data` of the model that is fitted without one of its causes.
fn leave_out<'a>(
    plant: &'a dyn Plant,
    fit: &'a [Recording],
    data: &'a [Recording],
    bench: &Bench<'_>,
    chosen: &[Chosen],
    item: &Item,
) -> Measured {
    let mut delays = bench.scene.delays.clone();
    if item.hypothesis.moves_time() {
        // The delay's own part of the shift goes.
        let own: Vec<usize> = if item.place.is_empty() { (0..delays.len()).collect() } else { item.place.clone() };
        own.iter().for_each(|&j| delays[j] = 0.0);
    }
    let mut reduced = Bench::new(plant, fit, bench.rate, bench.mode, &delays, false);
    reduced.frozen = bench.frozen.clone();
    item.friction.iter().for_each(|&k| reduced.frozen[k] = true);
    let mut others: Vec<Chosen> =
        chosen.iter().enumerate().filter(|(i, _)| item.accepted != Some(*i)).map(|(_, c)| c.clone()).collect();
    let fitted = reduced.fit(&mut others);
    measure(plant, data, &reduced, Some(&fitted), &others, !std::ptr::eq(fit, data))
}

/// Whether a cause takes as much on some joint as a torque of a fifth of the noise would.
fn matters(cause: &Cause, noise: &[f64]) -> bool {
    let joints = cause.rms_before.iter().zip(&cause.rms_after).zip(noise);
    joints.map(|((a, b), s)| a * a - b * b - (0.2 * s).powi(2)).any(|x| x > 0.0)
}

/// How much error a cause takes: the logarithm of the ratio of root mean squares without and with it, noise added to both, summed over joints; so no
/// joint counts for more than another by the size of its torques.
fn taken(cause: &Cause, noise: &[f64]) -> f64 {
    let joints = cause.rms_before.iter().zip(&cause.rms_after).zip(noise);
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
fn unknown(causes: &mut Vec<Cause>, left: &[Structure], rms: &[f64], noise: &[f64]) {
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
    let size = taken(&entry, noise);
    let at = causes.iter().position(|c| taken(c, noise) < size).unwrap_or(causes.len());
    if at > 0 {
        entry.probability = calibration::UNKNOWN_BESIDE;
    }
    causes.insert(at, entry);
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
