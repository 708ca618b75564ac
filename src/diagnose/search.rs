//! Which causes: one after the other, each against all others, until nothing more is supported.
//!
//! A candidate is a cause in a place. Its gain is the logarithm of the ratio of the joints' residual sums of squares without and with it, all
//! other unknowns refitted; windows count by how long residuals remember themselves. A candidate is accepted if the gain pays for its
//! unknowns and for how many candidates were tried, if parts of the data that were not used to fit it confirm it, and if it is large
//! enough to matter beside the noise.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::causes::{CAUSES, Cause, Sign, UNIT};
use super::model::{Bench, Chosen, Fitted, Mode};
use super::moments::{Gain, Solution};
use super::noise::memory;

/// How strict the search is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SearchSettings {
    /// The most causes.
    pub most: usize,
    /// Least effect, as a share of the joint's raw torque noise.
    pub least_effect: f64,
    /// Least share of a joint's residual variance that a cause takes, in fit and in cross-validation.
    pub least_gain: f64,
    /// Least share of the variance that an earlier cause of the same kind on the same joint took: less is what that cause's law
    /// does not fit.
    pub least_share: f64,
}

impl Default for SearchSettings {
    fn default() -> Self {
        Self { most: 8, least_effect: 0.25, least_gain: 0.08, least_share: 0.03 }
    }
}

/// A cause in a place with its best shape.
#[derive(Clone)]
pub struct Candidate {
    /// What.
    pub cause: &'static dyn Cause,
    /// Where.
    pub place: Vec<usize>,
    /// Its shape.
    pub shape: Vec<f64>,
    /// What it gives.
    pub gain: Gain,
    /// Sum over joints of windows times the logarithm of the ratio of residuals, less what its unknowns cost.
    pub score: f64,
}

impl Candidate {
    /// As a part of a model.
    fn chosen(&self) -> Chosen {
        Chosen { cause: self.cause, place: self.place.clone(), shape: self.shape.clone(), x: self.gain.x.clone() }
    }
}

/// An accepted cause with the evidence.
#[derive(Clone)]
pub struct Accepted {
    /// The cause.
    pub chosen: Chosen,
    /// Twice the gain in log-likelihood, in independent windows, less the cost.
    pub support: f64,
    /// Share of the parts of the data that confirm it.
    pub confirmed: f64,
    /// What says nearly the same: cause, place, difference of support.
    pub rivals: Vec<(&'static str, Vec<usize>, f64)>,
    /// Variance that it takes, summed over joints, (N m)^2.
    pub variance: f64,
}

fn unknowns(cause: &dyn Cause, shape: &[f64], terms: usize) -> f64 {
    (terms + cause.free(shape)) as f64
}

/// Evaluates one shape.
fn evaluate(
    bench: &Bench<'_>,
    fitted: &Fitted,
    cause: &'static dyn Cause,
    place: &[usize],
    shape: &[f64],
) -> Option<Candidate> {
    if !cause.shows(&bench.scene, place, shape) {
        return None;
    }
    let terms = bench.family(cause, place, shape);
    if terms.is_empty() {
        return None;
    }
    let columns: Vec<_> = terms.iter().map(|t| &t.column).collect();
    let gain = fitted.moments.gain(&fitted.solution, &fitted.moments.trial(&columns))?;
    let signed = terms.iter().zip(&gain.x).all(|(t, x)| match t.sign {
        Sign::Any => true,
        Sign::Positive => *x > 0.0,
    });
    if !signed || !gain.x.iter().all(|x| x.is_finite()) || !cause.plausible(&bench.scene, place, shape, &gain.x) {
        return None;
    }
    let total: f64 = fitted.solution.counts.iter().sum();
    let raw: f64 = logs(&fitted.solution.rss, &gain.rss).zip(&fitted.solution.counts).map(|(l, n)| n * l).sum();
    let off = if cause.unit() { (gain.x[0] - 1.0) / UNIT } else { 0.0 };
    let score = raw - unknowns(cause, shape, terms.len()) * total.max(2.0).ln() - off * off;
    Some(Candidate { cause, place: place.to_vec(), shape: shape.to_vec(), gain, score })
}

fn logs<'a>(before: &'a [f64], after: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
    before.iter().zip(after).map(|(a, b)| if *a > 1e-290 && *b > 1e-290 { (a / b).ln() } else { 0.0 })
}

/// The best shape of every cause in every place, best first.
pub fn candidates(
    bench: &Bench<'_>,
    fitted: &Fitted,
    wanted: &(dyn Fn(&'static dyn Cause, &[usize]) -> bool + Sync),
) -> Vec<Candidate> {
    let mut tasks: Vec<(&'static dyn Cause, Vec<usize>)> = Vec::new();
    for cause in CAUSES {
        tasks.extend(cause.places(&bench.scene).into_iter().filter(|p| wanted(cause, p)).map(|p| (cause, p)));
    }
    let next = AtomicUsize::new(0);
    let work = || {
        let mut found: Vec<(usize, Candidate)> = Vec::new();
        loop {
            let at = next.fetch_add(1, Ordering::Relaxed);
            let Some((cause, place)) = tasks.get(at) else { return found };
            let best = cause
                .grid(&bench.scene, place, &fitted.residual)
                .iter()
                .filter_map(|shape| evaluate(bench, fitted, *cause, place, shape))
                .max_by(|a, b| a.score.total_cmp(&b.score));
            found.extend(best.map(|b| (at, b)));
        }
    };
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get()).min(4);
    let mut all: Vec<(usize, Candidate)> = std::thread::scope(|scope| {
        let handles: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        handles.into_iter().flat_map(|h| h.join().unwrap_or_default()).collect()
    });
    all.sort_by_key(|a| a.0);
    let mut all: Vec<Candidate> = all.into_iter().map(|a| a.1).collect();
    all.sort_by(|a, b| b.score.total_cmp(&a.score));
    let refined = all.len().min(10);
    for candidate in &mut all[..refined] {
        refine(bench, fitted, candidate);
    }
    all.sort_by(|a, b| b.score.total_cmp(&a.score));
    simplest_first(&mut all, fitted);
    all
}

/// What a candidate with more unknowns gains, in the logarithm, must be more than this share of it beyond one with fewer: errors that are not noise
/// (of derivatives, of a law's shape) give many unknowns something to fit that is not theirs.
const WORTH_UNKNOWNS: f64 = 0.03;

/// Puts a candidate with several unknowns fewer before the best one where it gains nearly as much in the same place or on the whole robot.
fn simplest_first(all: &mut [Candidate], fitted: &Fitted) {
    let Some(best) = all.first() else { return };
    let total: f64 = fitted.solution.counts.iter().sum();
    let count = |c: &Candidate| unknowns(c.cause, &c.shape, c.gain.x.len());
    let raw = |c: &Candidate| c.score + count(c) * total.max(2.0).ln();
    let (most, many) = (raw(best), count(best));
    let place = |c: &Candidate| c.place == best.place || c.place.is_empty() || best.place.is_empty();
    let simpler = |c: &Candidate| count(c) + 3.0 <= many && raw(c) > (1.0 - WORTH_UNKNOWNS) * most && place(c);
    if let Some(at) = all.iter().position(simpler) {
        all[..=at].rotate_right(1);
    }
}

/// Walks each number of the shape up and down with shrinking steps.
fn refine(bench: &Bench<'_>, fitted: &Fitted, candidate: &mut Candidate) {
    let shape = candidate.cause.shape();
    if candidate.cause.secant() && shape.first().is_some_and(|s| s.step.is_none()) {
        // The step follows the coefficient.
        for _ in 0..6 {
            let x = candidate.gain.x[0];
            let step = x.clamp(shape[0].range[0], shape[0].range[1]);
            if step == 0.0 {
                break;
            }
            let mut next = candidate.shape.clone();
            next[0] = step;
            match evaluate(bench, fitted, candidate.cause, &candidate.place, &next) {
                Some(better) => *candidate = better,
                None => break,
            }
        }
    }
    for (k, number) in shape.iter().enumerate() {
        let Some(first) = number.step else { continue };
        let mut step = first;
        for _ in 0..14 {
            if step.abs() < 0.05 * first.abs() {
                break;
            }
            let mut moved = false;
            for direction in [1.0, -1.0] {
                let mut next = candidate.shape.clone();
                next[k] = if step > 0.0 { next[k] * (1.0 + step).powf(direction) } else { next[k] - direction * step };
                if next[k] < number.range[0] || next[k] > number.range[1] {
                    continue;
                }
                if let Some(better) = evaluate(bench, fitted, candidate.cause, &candidate.place, &next)
                    && better.score > candidate.score
                {
                    *candidate = better;
                    moved = true;
                    break;
                }
            }
            if !moved {
                step *= 0.45;
            }
        }
    }
    if let Some(k) = candidate.cause.natural() {
        let mut next = candidate.shape.clone();
        next[k] = next[k].round().max(1.0);
        if let Some(better) = evaluate(bench, fitted, candidate.cause, &candidate.place, &next)
            && better.score > candidate.score
        {
            *candidate = better;
        }
    }
}

/// Searches until nothing more is supported.
pub fn search(
    bench: &mut Bench<'_>,
    noise: &[f64],
    settings: &SearchSettings,
    progress: &dyn Fn(&str),
) -> Vec<Accepted> {
    let mut chosen: Vec<Chosen> = Vec::new();
    let mut accepted: Vec<Accepted> = Vec::new();
    let mut fitted = bench.fit(&mut []);
    while accepted.len() < settings.most {
        progress(&format!("{} found, looking for more", accepted.len()));
        let free = |cause: &'static dyn Cause, place: &[usize]| {
            cause.repeats() && chosen.iter().filter(|c| c.cause.name() == cause.name() && c.place == place).count() < 2
                || chosen.iter().all(|c| c.cause.name() != cause.name() || c.place != place)
        };
        let wanted = |cause: &'static dyn Cause, place: &[usize]| free(cause, place) && makes_sense(bench, cause);
        let ranked = candidates(bench, &fitted, &wanted);
        let tried = ranked.len().max(1);
        let mut taken = None;
        for (rank, candidate) in ranked.iter().take(4).enumerate() {
            let mut trial = chosen.clone();
            trial.push(candidate.chosen());
            let delays = bench.scene.delays.clone();
            let next = bench.fit(&mut trial);
            let judge = Judge { bench, noise, settings, accepted: &accepted, tried };
            let judged = judge.judge(&fitted, &next, &trial);
            match judged {
                Some(mut judged) => {
                    judged.rivals = rivals(&ranked, rank, &next);
                    let terms = next.terms.last().map_or(&[][..], |t| t.as_slice());
                    if let Some(other) = rather(bench, &judged.chosen, terms)
                        && let Some(last) = trial.last_mut()
                    {
                        *last = other.clone();
                        judged.chosen = other;
                    }
                    taken = Some((judged, trial, next));
                    break;
                }
                None if delays != bench.scene.delays => {
                    // Undo a delay that was tried.
                    let by = bench.scene.delays.iter().zip(&delays).map(|(a, b)| b - a).collect::<Vec<_>>();
                    bench.undo_delay(&by);
                    fitted = bench.fit(&mut chosen);
                }
                None => {}
            }
        }
        let Some((judged, trial, next)) = taken else {
            let judge = Judge { bench: &*bench, noise, settings, accepted: &accepted, tried };
            if !judge.leaves_more_than_noise(&fitted) {
                break;
            }
            let Some((pair, trial, next)) = together(bench, &chosen, &ranked, noise, settings, &accepted) else {
                fitted = bench.fit(&mut chosen);
                break;
            };
            accepted.extend(pair);
            (chosen, fitted) = (trial, next);
            for (a, c) in accepted.iter_mut().zip(&chosen) {
                a.chosen = c.clone();
            }
            continue;
        };
        chosen = trial;
        accepted.push(judged);
        fitted = next;
        for (a, c) in accepted.iter_mut().zip(&chosen) {
            a.chosen = c.clone();
        }
    }
    progress("weighing the causes against each other");
    settle(bench, &mut accepted, &mut fitted, noise, settings);
    unite(bench, &mut accepted, &mut fitted);
    accepted
}

/// Two causes on one joint, neither of which is supported alone: what the other leaves remembers itself for so long that the windows count for few. Each must
/// be worth having beside the other.
fn together(
    bench: &mut Bench<'_>,
    chosen: &[Chosen],
    ranked: &[Candidate],
    noise: &[f64],
    settings: &SearchSettings,
    accepted: &[Accepted],
) -> Option<([Accepted; 2], Vec<Chosen>, Fitted)> {
    let with = |others: &[Chosen], one: &Chosen| others.iter().chain([one]).cloned().collect::<Vec<Chosen>>();
    let first = |c: &&Candidate| c.place.len() == 1 && !c.cause.moves_time() && !c.cause.local();
    for first in ranked.iter().filter(first).take(3) {
        let mut alone = with(chosen, &first.chosen());
        let one = bench.fit(&mut alone);
        let first = alone.last()?.clone();
        let wanted = |cause: &'static dyn Cause, place: &[usize]| {
            place == first.place.as_slice()
                && cause.name() != first.cause.name()
                && chosen.iter().all(|c| c.cause.name() != cause.name() || c.place != place)
                && !cause.moves_time()
                && !cause.local()
                && makes_sense(bench, cause)
        };
        let seconds = candidates(bench, &one, &wanted);
        let tried = ranked.len() * seconds.len().max(1);
        for (rank, second) in seconds.iter().take(2).enumerate() {
            let mut both = with(&alone, &second.chosen());
            let two = bench.fit(&mut both);
            let judge = Judge { bench: &*bench, noise, settings, accepted, tried };
            let Some(mut other) = judge.judge(&one, &two, &both) else { continue };
            let mut turned = with(chosen, &other.chosen);
            let without = bench.fit(&mut turned);
            turned.push(first.clone());
            let again = bench.fit(&mut turned);
            let judge = Judge { bench: &*bench, noise, settings, accepted, tried };
            let Some(own) = judge.judge(&without, &again, &turned) else { continue };
            other.rivals = rivals(&seconds, rank, &two);
            let two = bench.fit(&mut both);
            return Some(([own, other], both, two));
        }
    }
    None
}

/// The same columns as a cause of the whole robot, where they rather are one.
fn rather(bench: &Bench<'_>, chosen: &Chosen, terms: &[super::causes::Term]) -> Option<Chosen> {
    let cause = chosen.cause.rather(&bench.scene, &chosen.place, terms, &chosen.x)?;
    Some(Chosen { cause, place: Vec::new(), ..chosen.clone() })
}

/// Wrong links can't be seen where all base parameters are unknown.
fn makes_sense(bench: &Bench<'_>, cause: &dyn Cause) -> bool {
    bench.mode == Mode::Trusted || !cause.within_links()
}

/// By what a cause is judged.
struct Judge<'a> {
    bench: &'a Bench<'a>,
    noise: &'a [f64],
    settings: &'a SearchSettings,
    /// Accepted before.
    accepted: &'a [Accepted],
    /// How many candidates there were.
    tried: usize,
}

impl Judge<'_> {
    /// Whether some joint's error is beyond the noise of its torque.
    fn leaves_more_than_noise(&self, fitted: &Fitted) -> bool {
        let Solution { rss, counts, .. } = &fitted.solution;
        rss.iter().zip(counts).zip(self.noise).any(|((rss, count), noise)| *rss > count * noise * noise)
    }

    /// Whether the last of `trial` is worth having.
    fn judge(&self, before: &Fitted, after: &Fitted, trial: &[Chosen]) -> Option<Accepted> {
        let Self { bench, noise, settings, accepted, tried } = *self;
        let last = trial.last()?;
        let terms = after.terms.last()?;
        if terms.is_empty() || !last.cause.plausible(&bench.scene, &last.place, &last.shape, &last.x) {
            return None;
        }
        if terms.iter().zip(&last.x).any(|(t, x)| t.sign == Sign::Positive && *x <= 0.0) {
            return None;
        }
        let counts = &before.solution.counts;
        let independent: f64 = counts.iter().zip(&after.memory).map(|(n, m)| n / m).sum();
        let gain: f64 = logs(&before.solution.rss, &after.solution.rss)
            .zip(counts.iter().zip(&after.memory))
            .map(|(l, (n, m))| l * n / m)
            .sum();
        let cost = unknowns(last.cause, &last.shape, terms.len()) * independent.max(2.0).ln()
            + 2.0 * (tried as f64).ln()
            + 6.0;
        let support = gain - cost;
        if support <= 0.0 {
            return None;
        }
        // Large enough beside the noise, on some joint?
        let taken: Vec<f64> = before
            .solution
            .rss
            .iter()
            .zip(&after.solution.rss)
            .zip(counts)
            .map(|((a, b), n)| if *n > 0.0 { (a - b) / n } else { 0.0 })
            .collect();
        let size = |j: usize| if counts[j] > 0.0 { before.solution.rss[j] / counts[j] } else { 0.0 };
        let matters = (0..taken.len())
            .any(|j| taken[j] > (settings.least_effect * noise[j]).powi(2).max(settings.least_gain * size(j)));
        if !matters {
            return None;
        }
        let variance: f64 = taken.iter().filter(|t| **t > 0.0).sum();
        // What an earlier law of the same kind does not fit is not another cause.
        let same = |a: &Accepted| {
            a.chosen.place == last.place && a.chosen.cause.kind() == last.cause.kind() && !last.place.is_empty()
        };
        let overshadowed = accepted.iter().any(|a| {
            let share = if same(a) { settings.least_share } else { 0.3 * settings.least_share };
            let joints = !a.chosen.place.is_empty() && a.chosen.place == last.place;
            (same(a) || joints) && variance < share * a.variance
        });
        if overshadowed {
            return None;
        }
        let stands: Vec<bool> = (0..counts.len()).map(|j| last.place.is_empty() && stands(bench, j)).collect();
        let Confirmation { confirmed, predicted, spoilt, stirred } = confirmation(before, after, &stands);
        if last.cause.local() {
            // No other part can vouch for it: it must stand out by itself.
            let stands_out = (0..taken.len()).any(|j| taken[j] > 0.25 * size(j));
            if !stands_out {
                return None;
            }
        } else if confirmed < 0.75
            || predicted < 0.6 * settings.least_gain
            || spoilt > bearable(predicted)
            || stirred > (0.5 * predicted).max(0.1)
        {
            return None;
        }
        Some(Accepted { chosen: last.clone(), support, confirmed, rivals: Vec::new(), variance })
    }
}

/// Whether a joint stands most of the time: what the file has wrong of it the motion does not show, and a cause of the whole robot can make it seem larger.
fn stands(bench: &Bench<'_>, j: usize) -> bool {
    let (mut moving, mut all) = (0, 0);
    for sign in bench.scene.own[j].iter().flat_map(|own| &own.sign) {
        moving += usize::from(*sign != 0.0);
        all += 1;
    }
    2 * moving < all
}

/// By what share another joint's error may grow: what takes all but a tenth of one joint's error is not refuted by what earlier causes, found beside that error,
/// still have to give way.
fn bearable(predicted: f64) -> f64 {
    if predicted > 0.9 { 0.5 } else { 0.1 }
}

/// What parts of the data say that were left out of the fit in turn.
struct Confirmation {
    /// Share of the parts that the larger model predicts better, parts weighted by what they gain or lose.
    confirmed: f64,
    /// The largest share of a joint's error that it takes.
    predicted: f64,
    /// The largest share by which a joint's error grows.
    spoilt: f64,
    /// The same of joints that stand, where the cause is one of the whole robot.
    stirred: f64,
}

fn confirmation(before: &Fitted, after: &Fitted, stands: &[bool]) -> Confirmation {
    let (a, b) = (before.moments.cross_validated(&before.solution), after.moments.cross_validated(&after.solution));
    let weights = &after.solution.weights;
    let (mut won, mut lost) = (0.0, 0.0);
    let mut sums = vec![[0.0; 2]; weights.len()];
    for (a, b) in a.iter().zip(&b) {
        let change: f64 = a.iter().zip(b).zip(weights).map(|((a, b), w)| w * (a - b)).sum();
        if change > 0.0 {
            won += change
        } else {
            lost -= change
        }
        for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
            *sum = [sum[0] + a, sum[1] + b];
        }
    }
    let shares = || sums.iter().map(|[a, b]| if *a > 1e-200 { 1.0 - b / a } else { 0.0 });
    Confirmation {
        confirmed: if won + lost > 0.0 { won / (won + lost) } else { 0.0 },
        predicted: shares().fold(0.0, f64::max),
        spoilt: -shares().zip(stands).filter(|s| !s.1).map(|s| s.0).fold(0.0, f64::min),
        stirred: -shares().zip(stands).filter(|s| *s.1).map(|s| s.0).fold(0.0, f64::min),
    }
}

/// The last link's parameters and a payload are one thing; the vocabulary's table says so, the rivals need not.
fn same_body(a: &Candidate, b: &Candidate) -> bool {
    let body = |c: &Candidate| c.cause.within_links();
    body(a) && body(b) && (a.score - b.score).abs() < 1e-6 * a.score.abs().max(1.0)
}

/// Candidates that explain nearly as much as the one that was taken.
fn rivals(ranked: &[Candidate], taken: usize, after: &Fitted) -> Vec<(&'static str, Vec<usize>, f64)> {
    let best = &ranked[taken];
    let memory = best
        .place
        .first()
        .map_or_else(|| after.memory.iter().sum::<f64>() / after.memory.len().max(1) as f64, |j| after.memory[*j]);
    ranked
        .iter()
        .enumerate()
        .filter(|(i, c)| *i != taken && (c.cause.name() != best.cause.name()))
        .filter(|(_, c)| !same_body(c, best))
        .filter(|(_, c)| c.place == best.place || c.place.is_empty() || best.place.is_empty())
        .filter(|(_, c)| best.score - c.score < (10.0 * memory).max(0.015 * best.score))
        .map(|(_, c)| (c.cause.name(), c.place.clone(), (best.score - c.score) / memory))
        .take(4)
        .collect()
}

/// Takes each cause out in turn: goes without it where it is not missed, and puts another in its place that does better now that the
/// rest is known.
fn settle(
    bench: &mut Bench<'_>,
    accepted: &mut Vec<Accepted>,
    fitted: &mut Fitted,
    noise: &[f64],
    settings: &SearchSettings,
) {
    if accepted.len() < 2 {
        return;
    }
    let mut index = 0;
    while index < accepted.len() && accepted.len() > 1 {
        if accepted[index].chosen.cause.moves_time() {
            index += 1;
            continue;
        }
        let mut without: Vec<Chosen> = accepted.iter().map(|a| a.chosen.clone()).collect();
        let removed = without.remove(index);
        let reduced = bench.fit(&mut without);
        let others: Vec<Accepted> =
            accepted.iter().enumerate().filter(|(i, _)| *i != index).map(|(_, a)| a.clone()).collect();
        let wanted = |cause: &'static dyn Cause, place: &[usize]| {
            (place == removed.place.as_slice() || place.is_empty())
                && !cause.moves_time()
                && makes_sense(bench, cause)
                && (cause.repeats() || without.iter().all(|c| c.cause.name() != cause.name() || c.place != place))
        };
        let ranked = candidates(bench, &reduced, &wanted);
        let mut replaced = false;
        for (rank, candidate) in ranked.iter().take(2).enumerate() {
            let mut trial = without.clone();
            trial.push(candidate.chosen());
            let next = bench.fit(&mut trial);
            let judge = Judge { bench, noise, settings, accepted: &others, tried: ranked.len() };
            if let Some(mut judged) = judge.judge(&reduced, &next, &trial) {
                judged.rivals = rivals(&ranked, rank, &next);
                let (first, last) = (index, trial.len() - 1);
                let chosen = trial.remove(last);
                trial.insert(first, chosen);
                judged.chosen = trial[first].clone();
                accepted[index] = judged;
                for (a, c) in accepted.iter_mut().zip(&trial) {
                    a.chosen = c.clone();
                }
                replaced = true;
                break;
            }
        }
        if replaced {
            index += 1;
        } else {
            accepted.remove(index);
        }
    }
    let mut chosen: Vec<Chosen> = accepted.iter().map(|a| a.chosen.clone()).collect();
    *fitted = bench.fit(&mut chosen);
    for (a, c) in accepted.iter_mut().zip(&chosen) {
        a.chosen = c.clone();
    }
    fitted.memory = fitted.residual.iter().zip(&bench.scene.live).map(|(e, l)| memory(e, l)).collect();
}

/// Delays of several joints that are the same within what they are known to are one: that of a clock, or a bus. It takes their place where the data do not
/// speak against it: where it costs less than the unknowns that it saves.
fn unite(bench: &mut Bench<'_>, accepted: &mut Vec<Accepted>, fitted: &mut Fitted) {
    let late: Vec<usize> = (0..accepted.len())
        .filter(|&i| accepted[i].chosen.cause.moves_time() && accepted[i].chosen.place.len() == 1)
        .collect();
    let common = accepted.iter().any(|a| a.chosen.cause.moves_time() && a.chosen.place.is_empty());
    if late.len() < 2 || common {
        return;
    }
    let covariance = fitted.covariance();
    // Joint, delay, variance: at least that of half a sample.
    let of = |i: usize| {
        let (joint, at) = (accepted[i].chosen.place[0], fitted.first[i]);
        let sampled = (0.5 * bench.scene.period).powi(2) / 3.0;
        (joint, bench.scene.delays[joint], covariance[(at, at)].max(0.0) + sampled)
    };
    let alike = |i: usize, k: usize| {
        let ((_, a, va), (_, b, vb)) = (of(i), of(k));
        (a - b).abs() <= 3.0 * (va + vb).sqrt()
    };
    // The largest company about one of them.
    let company = |i: usize| late.iter().copied().filter(|&k| alike(i, k)).collect::<Vec<usize>>();
    let Some(group) = late.iter().map(|&i| company(i)).max_by_key(Vec::len).filter(|g| g.len() > 1) else { return };
    let weight: f64 = group.iter().map(|&i| 1.0 / of(i).2).sum();
    let mean = group.iter().map(|&i| of(i).1 / of(i).2).sum::<f64>() / weight;
    let own: Vec<usize> = late.iter().map(|&i| of(i).0).collect();
    let members: Vec<usize> = group.iter().map(|&i| of(i).0).collect();
    let before = bench.scene.delays.clone();
    for (j, was) in before.iter().enumerate() {
        let wanted = if own.contains(&j) && !members.contains(&j) { *was } else { mean };
        if wanted != *was {
            bench.delay(&[j], wanted - was);
        }
    }
    let mut kept: Vec<Accepted> =
        accepted.iter().enumerate().filter(|(i, _)| !group.contains(i)).map(|(_, a)| a.clone()).collect();
    let mut one = accepted[group[0]].clone();
    one.chosen.place = Vec::new();
    one.chosen.x = vec![0.0];
    one.support = group.iter().map(|&i| accepted[i].support).fold(f64::NEG_INFINITY, f64::max);
    one.variance = group.iter().map(|&i| accepted[i].variance).sum();
    kept.insert(group[0].min(kept.len()), one);
    let mut chosen: Vec<Chosen> = kept.iter().map(|a| a.chosen.clone()).collect();
    let next = bench.fit(&mut chosen);
    let counts = &next.solution.counts;
    let lost: f64 = logs(&fitted.solution.rss, &next.solution.rss)
        .zip(counts.iter().zip(&next.memory))
        .map(|(l, (n, m))| -l * n / m)
        .sum();
    let independent: f64 = counts.iter().zip(&next.memory).map(|(n, m)| n / m).sum();
    let saved = (group.len() - 1) as f64 * independent.max(2.0).ln();
    if lost < saved {
        for (a, c) in kept.iter_mut().zip(&chosen) {
            a.chosen = c.clone();
        }
        (*accepted, *fitted) = (kept, next);
        return;
    }
    for (j, was) in before.iter().enumerate() {
        let now = bench.scene.delays[j];
        if *was != now {
            bench.delay(&[j], was - now);
        }
    }
    let mut chosen: Vec<Chosen> = accepted.iter().map(|a| a.chosen.clone()).collect();
    *fitted = bench.fit(&mut chosen);
    for (a, c) in accepted.iter_mut().zip(&chosen) {
        a.chosen = c.clone();
    }
}

/// What else the plain friction of a joint might be.
pub struct Plain {
    /// Joint, from 0.
    pub joint: usize,
    /// What says nearly the same in its stead: cause, place, difference of support.
    pub rivals: Vec<(&'static str, Vec<usize>, f64)>,
}

/// Puts plain friction, which is always among the unknowns, on a par with the other causes: where a joint has no cause of its own but changed
/// friction or an offset, that is taken out and every cause of the joint is tried in its stead. One that says more with its unknowns takes the
/// place; those that say nearly as much are rivals.
pub fn reconsider(
    bench: &mut Bench<'_>,
    accepted: &mut Vec<Accepted>,
    mut fitted: Fitted,
    noise: &[f64],
    settings: &SearchSettings,
) -> (Fitted, Vec<Plain>) {
    let mut all = Vec::new();
    for j in 0..bench.scene.dof() {
        let free: Vec<usize> = (3 * j..3 * j + 3).filter(|k| !bench.frozen[*k]).collect();
        // A joint whose friction went back to the file's, and left more than noise, is looked at once more.
        let left = fitted.solution.rss[j] > fitted.solution.counts[j] * (0.7 * noise[j]).powi(2);
        if free.is_empty() && !left || accepted.iter().any(|a| a.chosen.place.contains(&j)) {
            continue;
        }
        let chosen: Vec<Chosen> = accepted.iter().map(|a| a.chosen.clone()).collect();
        let delays = bench.scene.delays.clone();
        free.iter().for_each(|&k| bench.frozen[k] = true);
        let mut without = chosen.clone();
        let reduced = bench.fit(&mut without);
        let wanted =
            |cause: &'static dyn Cause, place: &[usize]| place.len() == 1 && place[0] == j && makes_sense(bench, cause);
        let ranked = candidates(bench, &reduced, &wanted);
        let total: f64 = reduced.solution.counts.iter().sum();
        let raw: f64 =
            logs(&reduced.solution.rss, &fitted.solution.rss).zip(&reduced.solution.counts).map(|(l, n)| n * l).sum();
        let plain = raw - free.len() as f64 * total.max(2.0).ln();
        let memory = fitted.memory[j];
        let mut replaced = false;
        if let Some(best) = ranked.first().filter(|c| c.score > plain + 4.0 * memory) {
            let mut trial = without.clone();
            trial.push(best.chosen());
            let next = bench.fit(&mut trial);
            let judge = Judge { bench, noise, settings, accepted: accepted.as_slice(), tried: ranked.len() };
            if let Some(mut judged) = judge.judge(&reduced, &next, &trial) {
                judged.rivals = rivals(&ranked, 0, &next);
                let names = [("viscous_friction", 0), ("coulomb_friction", 1), ("torque_offset", 2)];
                let margin = (best.score - plain) / memory;
                let near = best.score - plain < (10.0 * memory).max(0.015 * best.score);
                let plain = names.iter().filter(|(_, which)| near && free.contains(&(3 * j + which)));
                judged.rivals.extend(plain.map(|(name, _)| (*name, vec![j], margin)));
                accepted.push(judged);
                for (a, c) in accepted.iter_mut().zip(&trial) {
                    a.chosen = c.clone();
                }
                fitted = next;
                replaced = true;
            }
        }
        if replaced {
            continue;
        }
        free.iter().for_each(|&k| bench.frozen[k] = false);
        if delays != bench.scene.delays {
            let by = bench.scene.delays.iter().zip(&delays).map(|(a, b)| b - a).collect::<Vec<_>>();
            bench.undo_delay(&by);
        }
        let near = |c: &&Candidate| plain - c.score < (10.0 * memory).max(0.015 * plain);
        let rivals = ranked.iter().filter(near).take(4);
        let rivals = rivals.map(|c| (c.cause.name(), c.place.clone(), ((plain - c.score) / memory).max(0.0))).collect();
        all.push(Plain { joint: j, rivals });
    }
    let mut chosen: Vec<Chosen> = accepted.iter().map(|a| a.chosen.clone()).collect();
    fitted = bench.fit(&mut chosen);
    for (a, c) in accepted.iter_mut().zip(&chosen) {
        a.chosen = c.clone();
    }
    (fitted, all)
}
