//! Candidates: every cause in every place with its best shape, ranked by gain with everything else
//! refitted.

use super::judge::SURE;
use crate::diagnose::fit::model::{Chosen, Fitted, ModelUnderTest, near};
use crate::diagnose::fit::moments::Gain;
use crate::diagnose::fit::white_errors::{cost_of_unknown, white_gain};
use crate::diagnose::hypotheses::{Hypothesis, PLAIN, Sign, UNIT, at_edge, causes};
use crate::numerics::parallel::{parallel, threads};
use dh_codegen::robot::EffectKind;

/// A cause in a place with its best shape and gain.
#[derive(Clone)]
pub struct Candidate {
    /// Cause of the vocabulary.
    pub cause: &'static dyn Hypothesis,
    /// Joints on which it acts, from 0; empty for the whole robot.
    pub place: Vec<usize>,
    /// Shape: the nonlinear parameters of the cause.
    pub shape: Vec<f64>,
    /// Gain of the fit, with the coefficients.
    pub gain: Gain,
    /// Sum over joints of windows times the logarithm of the ratio of residuals, less the cost of
    /// its unknowns.
    pub score: f64,
}

impl Candidate {
    /// The score without the cost of its unknowns.
    pub(in crate::diagnose) fn raw(&self, fitted: &Fitted) -> f64 {
        self.score + unknowns(self.cause, &self.shape, self.gain.x.len()) * price(fitted)
    }

    /// The candidate as a term of a model.
    pub(in crate::diagnose) fn chosen(&self) -> Chosen {
        Chosen { cause: self.cause, place: self.place.clone(), shape: self.shape.clone(), x: self.gain.x.clone() }
    }
}

/// Index among the friction unknowns, if the candidate is a term of plain friction.
pub(in crate::diagnose) fn plain(candidate: &Candidate) -> Option<usize> {
    let which = PLAIN.iter().position(|p| p.effect() == candidate.cause.effect())?;
    candidate.place.first().map(|j| 3 * j + which)
}

pub(in crate::diagnose) fn unknowns(cause: &dyn Hypothesis, shape: &[f64], terms: usize) -> f64 {
    (terms + cause.free(shape)) as f64
}

/// Cost of one unknown: the logarithm of the number of windows.
pub(super) fn price(fitted: &Fitted) -> f64 {
    cost_of_unknown(fitted.solution.counts.iter().sum())
}

/// Evaluates one shape of a cause; `None` if it is not observable or not plausible.
pub(in crate::diagnose) fn evaluate(
    tested: &ModelUnderTest<'_>,
    fitted: &Fitted,
    cause: &'static dyn Hypothesis,
    place: &[usize],
    shape: &[f64],
) -> Option<Candidate> {
    if !cause.shows(&tested.scene, place, shape) {
        return None;
    }
    let terms = tested.family(cause, place, shape);
    if terms.is_empty() {
        return None;
    }
    let columns: Vec<_> = terms.iter().map(|t| &t.column).collect();
    let trial = fitted.moments.trial(&columns);
    let gain = tested.limited_gain(fitted, cause, (place, shape), &terms, &trial)?;
    let signed = terms.iter().zip(&gain.x).all(|(t, x)| match t.sign {
        Sign::Any => true,
        Sign::Positive => *x > 0.0,
    });
    if !signed || !gain.x.iter().all(|x| x.is_finite()) || !cause.plausible(&tested.scene, place, shape, &gain.x) {
        return None;
    }
    let raw = white_gain(&fitted.solution.rss, &gain.rss, fitted.solution.counts.iter().copied());
    let off = if cause.unit() { (gain.x[0] - 1.0) / UNIT } else { 0.0 };
    let score = raw - unknowns(cause, shape, terms.len()) * price(fitted) - off * off;
    Some(Candidate { cause, place: place.to_vec(), shape: shape.to_vec(), gain, score })
}

/// Number of threads of the search: the ten columns of a body on all joints may take 32 MB
/// together.
fn at_once(tested: &ModelUnderTest<'_>) -> usize {
    let body = 10 * tested.scene.dof() * tested.scene.len;
    threads().min((4 << 20) / body.max(1)).max(1)
}

/// The best shape of every cause in every place, sorted by score, best first.
pub fn candidates(
    tested: &ModelUnderTest<'_>,
    fitted: &Fitted,
    wanted: &(dyn Fn(&'static dyn Hypothesis, &[usize]) -> bool + Sync),
) -> Vec<Candidate> {
    let mut tasks: Vec<(&'static dyn Hypothesis, Vec<usize>)> = Vec::new();
    let bodies = tested.plant.has_bodies();
    for cause in causes().filter(|cause| bodies || cause.in_the_drive()) {
        tasks.extend(cause.places(&tested.scene).into_iter().filter(|p| wanted(cause, p)).map(|p| (cause, p)));
    }
    let best = |at: usize| {
        let (cause, place) = &tasks[at];
        let shapes = cause.grid(&tested.scene, place, &fitted.residual);
        let tried = shapes.iter().filter_map(|shape| evaluate(tested, fitted, *cause, place, shape));
        best_of(tested, fitted, tried)
    };
    let threads = at_once(tested);
    let mut all: Vec<Candidate> = parallel(threads, tasks.len(), best).into_iter().flatten().collect();
    all.sort_by(|a, b| b.score.total_cmp(&a.score));
    let refined = |at: usize| {
        let mut candidate = all[at].clone();
        refine(tested, fitted, &mut candidate);
        candidate
    };
    let first = parallel(threads, all.len().min(10), refined);
    all.splice(..first.len(), first);
    all.retain(|c| !at_edge(c.cause, &c.shape));
    all.sort_by(|a, b| b.score.total_cmp(&a.score));
    simplest_first(&mut all, fitted);
    least_change_first(&mut all, tested);
    payload_first(&mut all, mean(&fitted.memory));
    all
}

/// The best of the shapes of one cause. If they belong to several laws, the best of each law is
/// refined first, because a coarse grid cannot decide between laws.
fn best_of(tested: &ModelUnderTest<'_>, fitted: &Fitted, tried: impl Iterator<Item = Candidate>) -> Option<Candidate> {
    let mut best: Vec<Candidate> = Vec::new();
    for next in tried {
        let law = |c: &Candidate| c.cause.law(&c.shape);
        match best.iter_mut().find(|known| law(known) == law(&next)) {
            Some(known) if known.score > next.score => {}
            Some(known) => *known = next,
            None => best.push(next),
        }
    }
    if best.len() > 1 {
        best.iter_mut().for_each(|candidate| refine(tested, fitted, candidate));
    }
    // A local cause follows errors that last for several windows, so its further unknowns are
    // charged in independent windows.
    let more = (mean(&fitted.memory) - 1.0).max(0.0);
    let worth = |c: &Candidate| if c.cause.local() { c.score - more * (c.raw(fitted) - c.score) } else { c.score };
    best.into_iter().max_by(|a, b| worth(a).total_cmp(&worth(b)))
}

/// Difference of scores that separates two candidates: 10 times the residual's autocorrelation
/// time, or 1.5 % of the best score.
fn tolerance(best: &Candidate, memory: f64) -> f64 {
    (10.0 * memory).max(0.015 * best.score)
}

/// Share of the gain below which a difference between two links is not significant. Both have ten
/// columns, so no other criterion decides.
const SAME: f64 = 0.002;

/// Puts first, of wrong links that gain nearly the same, the one with the least change. A
/// neighbour's mass on the common axis is equivalent to the link's own.
fn least_change_first(all: &mut [Candidate], tested: &ModelUnderTest<'_>) {
    let change = |c: &Candidate| {
        let terms = tested.family(c.cause, &c.place, &c.shape);
        let std = c.cause.prior_std(&tested.scene, &c.place, &terms)?;
        Some(c.gain.x.iter().zip(std).map(|(x, s)| (x / s).powi(2)).sum::<f64>().sqrt())
    };
    // The last link is left out: errors there are a payload.
    let last = |c: &Candidate| c.place.first().is_none_or(|j| j + 1 == tested.scene.dof());
    let Some(best) = all.first().filter(|c| !last(c)) else { return };
    let Some(mut least) = change(best) else { return };
    let near = SAME * best.score;
    let (score, mut at) = (best.score, 0);
    for (i, c) in all.iter().enumerate().filter(|(_, c)| score - c.score < near && !last(c)) {
        if let Some(change) = change(c).filter(|c| *c < least) {
            (least, at) = (change, i);
        }
    }
    all[..=at].rotate_right(1);
}

/// Logarithm of the prior odds of a wrong payload to those of one wrong link. Tools change daily,
/// links have the mass with which they were built.
const PAYLOAD_ODDS: f64 = 4.0;

/// Puts a payload before the wrong link that gains most, unless the link is likelier by more than
/// [`PAYLOAD_ODDS`] in independent windows. `memory`: autocorrelation time, windows.
fn payload_first(all: &mut [Candidate], memory: f64) {
    let is = |c: &Candidate, effect: EffectKind| c.cause.effect() == effect;
    let Some(best) = all.first().filter(|c| is(c, EffectKind::LinkInertiaError)) else { return };
    let least = best.score - 2.0 * PAYLOAD_ODDS * memory.max(1.0);
    if let Some(at) = all.iter().position(|c| is(c, EffectKind::Payload) && c.score > least) {
        all[..=at].rotate_right(1);
    }
}

/// Puts first, of candidates on one joint that gain nearly the same, the one that needs the fewest
/// terms of plain friction beside it. Returns whether models were fitted for this, which leaves
/// another model in `tested`.
pub(in crate::diagnose) fn sparest_first(
    all: &mut [Candidate],
    tested: &mut ModelUnderTest<'_>,
    others: &[Chosen],
    fitted: &Fitted,
) -> bool {
    let Some(best) = all.first() else { return false };
    let [joint] = best.place[..] else { return false };
    let eligible = |c: &Candidate| c.place == [joint] && !c.cause.moves_time() && !c.cause.local();
    let least = best.score - tolerance(best, fitted.memory[joint]);
    let near: Vec<usize> = (0..all.len()).filter(|&i| eligible(&all[i]) && all[i].score > least).take(4).collect();
    if near.len() < 2 || near[0] != 0 {
        return false;
    }
    let mut needed = |c: &Candidate| {
        let mut trial = [others, &[c.chosen()]].concat();
        let fitted = tested.fit(&mut trial);
        let covariance = fitted.covariance();
        let sure = |k: &usize| {
            let at = fitted.friction + k;
            fitted.solution.x[at].powi(2) > SURE.powi(2) * covariance[(at, at)]
        };
        let friction = (3 * joint..3 * joint + 3).filter(|k| !tested.frozen[*k]).filter(sure).count();
        unknowns(c.cause, &c.shape, c.gain.x.len()) + friction as f64
    };
    let counts: Vec<f64> = near.iter().map(|&i| needed(&all[i])).collect();
    let fewest = counts.iter().copied().fold(f64::INFINITY, f64::min);
    if let Some(at) = counts.iter().position(|c| *c <= fewest) {
        all[..=near[at]].rotate_right(1);
    }
    true
}

fn mean(x: &[f64]) -> f64 {
    x.iter().sum::<f64>() / x.len().max(1) as f64
}

/// Share of the raw gain that a candidate with fewer unknowns may lack and still be preferred.
/// Errors that are not noise (of derivatives, of a law's shape) give many unknowns something
/// unrelated to fit.
const WORTH_UNKNOWNS: f64 = 0.03;

/// Puts a candidate with at least three fewer unknowns before the best one where it gains nearly as
/// much in the same place or on the whole robot.
fn simplest_first(all: &mut [Candidate], fitted: &Fitted) {
    let Some(best) = all.first() else { return };
    let count = |c: &Candidate| unknowns(c.cause, &c.shape, c.gain.x.len());
    let (most, many) = (best.raw(fitted), count(best));
    let place = |c: &Candidate| c.place == best.place || c.place.is_empty() || best.place.is_empty();
    let simpler = |c: &Candidate| count(c) + 3.0 <= many && c.raw(fitted) > (1.0 - WORTH_UNKNOWNS) * most && place(c);
    if let Some(at) = all.iter().position(simpler) {
        all[..=at].rotate_right(1);
    }
}

/// Iterates a shape that depends on the coefficients until both agree.
fn follow(tested: &ModelUnderTest<'_>, fitted: &Fitted, candidate: &mut Candidate) {
    for _ in 0..4 {
        let terms = tested.family(candidate.cause, &candidate.place, &candidate.shape);
        let Some(next) = candidate.cause.follows(&terms, &candidate.gain.x) else { break };
        if near(&next, &candidate.shape) {
            break;
        }
        match evaluate(tested, fitted, candidate.cause, &candidate.place, &next) {
            Some(better) => *candidate = better,
            None => break,
        }
    }
}

/// Number of passes over a shape of three or more numbers, and the factor of the steps from pass to
/// pass.
const PASSES: i32 = 6;
const FINER: f64 = 0.4;

/// Refines the numbers of a shape by a pattern search.
pub(in crate::diagnose) fn refine(tested: &ModelUnderTest<'_>, fitted: &Fitted, candidate: &mut Candidate) {
    let shape = candidate.cause.shape();
    if candidate.cause.finite_difference() && shape.first().is_some_and(|s| s.step.is_none()) {
        // Set the step of the finite difference to the coefficient.
        for _ in 0..6 {
            let x = candidate.gain.x[0];
            let step = x.clamp(shape[0].range[0], shape[0].range[1]);
            if step == 0.0 {
                break;
            }
            let mut next = candidate.shape.clone();
            next[0] = step;
            match evaluate(tested, fitted, candidate.cause, &candidate.place, &next) {
                Some(better) => *candidate = better,
                None => break,
            }
        }
    }
    follow(tested, fitted, candidate);
    // Many numbers depend on each other: repeat the search with smaller steps, and extrapolate
    // along the direction of the last pass (Hooke and Jeeves 1961).
    let many = shape.iter().filter(|number| number.step.is_some()).count() > 2;
    for pass in 0..if many { PASSES } else { 1 } {
        let before = candidate.clone();
        walk(tested, fitted, candidate, FINER.powi(pass));
        if candidate.score - before.score < 1.0 {
            break;
        }
        if many {
            stride(tested, fitted, candidate, &before.shape);
        }
    }
    if let Some(k) = candidate.cause.integer_shape() {
        let mut next = candidate.shape.clone();
        next[k] = next[k].round().max(1.0);
        if let Some(better) = evaluate(tested, fitted, candidate.cause, &candidate.place, &next)
            && better.score > candidate.score
        {
            *candidate = better;
        }
    }
}

/// Extrapolates in the direction from an earlier shape, with doubled steps while the score
/// improves.
fn stride(tested: &ModelUnderTest<'_>, fitted: &Fitted, candidate: &mut Candidate, from: &[f64]) {
    let way: Vec<f64> = candidate.shape.iter().zip(from).map(|(to, from)| to - from).collect();
    let mut length = 1.0;
    loop {
        let next: Vec<f64> = candidate.shape.iter().zip(&way).map(|(at, way)| at + length * way).collect();
        let inside = candidate.cause.shape().iter().zip(&next).all(|(n, x)| n.range[0] <= *x && *x <= n.range[1]);
        match evaluate(tested, fitted, candidate.cause, &candidate.place, &next).filter(|_| inside) {
            Some(better) if better.score > candidate.score => *candidate = better,
            _ => break,
        }
        length *= 2.0;
    }
}

/// Moves each number of the shape up and down with shrinking steps. The first steps are `part`
/// times those that the shape defines.
fn walk(tested: &ModelUnderTest<'_>, fitted: &Fitted, candidate: &mut Candidate, part: f64) {
    for (k, number) in candidate.cause.shape().iter().enumerate() {
        let Some(first) = number.step.map(|step| part * step) else { continue };
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
                if let Some(better) = evaluate(tested, fitted, candidate.cause, &candidate.place, &next)
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
}

/// Whether two candidates are the last link's parameters and a payload, which are equivalent. The
/// vocabulary's table states that equivalence, so the rivals need not.
fn same_body(a: &Candidate, b: &Candidate) -> bool {
    let body = |c: &Candidate| c.cause.within_links();
    body(a) && body(b) && (a.score - b.score).abs() < 1e-6 * a.score.abs().max(1.0)
}

/// Candidates that explain nearly as much as the one that was accepted.
pub(in crate::diagnose) fn rivals(
    ranked: &[Candidate],
    taken: usize,
    after: &Fitted,
) -> Vec<(&'static str, Vec<usize>, f64)> {
    let best = &ranked[taken];
    // A body acts on several joints.
    let own = best.place.first().filter(|_| !best.cause.within_links());
    let memory = own.map_or_else(|| mean(&after.memory), |j| after.memory[*j]);
    let neighbour = |c: &Candidate| c.cause.name() == best.cause.name() && c.cause.within_links();
    ranked
        .iter()
        .enumerate()
        .filter(|(i, c)| *i != taken && (c.cause.name() != best.cause.name() || neighbour(c)))
        .filter(|(_, c)| neighbour(c) || !same_body(c, best))
        .filter(|(_, c)| neighbour(c) || c.place == best.place || c.place.is_empty() || best.place.is_empty())
        .filter(|(_, c)| best.score - c.score < tolerance(best, memory))
        .map(|(_, c)| (c.cause.name(), c.place.clone(), (best.score - c.score) / memory))
        .take(4)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::hypotheses::hypothesis;

    /// A payload that gains somewhat less than a link is first; one that gains much less is not.
    #[test]
    fn a_payload_is_likelier_than_a_link_by_its_prior_odds() {
        let candidate = |effect: EffectKind, joint: usize, score: f64| Candidate {
            cause: hypothesis(effect),
            place: vec![joint],
            shape: Vec::new(),
            gain: Gain { x: vec![1.0; 10], rss: vec![1.0] },
            score,
        };
        // Twice the odds, in windows that are three times as many as the independent ones.
        for (short_by, first) in [(23.9, EffectKind::Payload), (24.1, EffectKind::LinkInertiaError)] {
            let [link, payload] = [EffectKind::LinkInertiaError, EffectKind::Payload];
            let mut all =
                vec![candidate(link, 3, 100.0), candidate(link, 4, 99.0), candidate(payload, 5, 100.0 - short_by)];
            payload_first(&mut all, 3.0);
            assert_eq!(all[0].cause.effect(), first);
            // The others keep their order.
            let rest: Vec<f64> = all.iter().map(|c| c.score).filter(|score| *score > 98.0).collect();
            assert_eq!(rest, [100.0, 99.0]);
        }
        // Where something else gains most, no link is to be doubted.
        let mut all = vec![candidate(EffectKind::JointSpring, 2, 100.0), candidate(EffectKind::Payload, 5, 99.0)];
        payload_first(&mut all, 3.0);
        assert_eq!(all[0].cause.effect(), EffectKind::JointSpring);
    }
}
