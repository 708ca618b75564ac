//! Merges several wrong bodies into one.

use super::equivalent_robot_cause;
use super::judge::{Accepted, adopt, chosen_of};
use crate::diagnose::fit::model::{Chosen, Fitted, ModelUnderTest};
use crate::diagnose::fit::white_errors::{cost_of_unknown, lost_by};
use crate::diagnose::hypotheses::{Hypothesis, hypothesis};
use dh_codegen::robot::EffectKind;

/// Share of the error removed by several bodies that one body must remove to replace them.
const NEARLY_ALL: f64 = 0.97;

/// Candidates for a single wrong body: each link of the arm with each of the given laws, not yet
/// fitted.
pub(in crate::diagnose) fn single_bodies(tested: &ModelUnderTest<'_>, laws: &[&'static dyn Hypothesis]) -> Vec<Chosen> {
    let mut all = Vec::new();
    for &cause in laws {
        for place in cause.places(&tested.scene) {
            let shape = cause.grid(&tested.scene, &place, &[]).into_iter().next();
            all.extend(shape.map(|shape| Chosen { cause, place, shape, x: Vec::new() }));
        }
    }
    all
}

/// Replaces several bodies by one that explains the same. The columns of neighbouring links are
/// alike, so a body may first be found as its neighbour, with a remainder that its own link takes.
/// One body replaces all if it loses less than the cost of the unknowns that it saves, or explains
/// nearly everything that they explain.
pub(in crate::diagnose) fn merge_bodies(
    tested: &mut ModelUnderTest<'_>,
    accepted: &mut Vec<Accepted>,
    fitted: &mut Fitted,
) {
    let is_body = |a: &Accepted| a.chosen.cause.within_links();
    let bodies: Vec<Accepted> = accepted.iter().filter(|a| is_body(a)).cloned().collect();
    if bodies.len() < 2 {
        return;
    }
    let mut kept: Vec<Accepted> = accepted.iter().filter(|a| !is_body(a)).cloned().collect();
    let others = chosen_of(&kept);
    let without = tested.fit(&mut others.clone());
    let misfit = |f: &Fitted| f.solution.rss.iter().zip(&fitted.solution.weights).map(|(r, w)| r * w).sum::<f64>();
    let mut best: Option<(f64, Vec<Chosen>, Fitted)> = None;
    for body in single_bodies(tested, &[hypothesis(EffectKind::LinkInertiaError)]) {
        let mut trial = others.clone();
        trial.push(body);
        let next = tested.fit(&mut trial);
        let left = misfit(&next);
        if best.as_ref().is_none_or(|b| left < b.0) {
            best = Some((left, trial, next));
        }
    }
    let unknowns = |c: &[Chosen]| c.iter().map(|c| c.x.len()).sum::<usize>() as f64;
    let one = best.filter(|(left, trial, next)| {
        let (lost, independent) = lost_by(fitted, next, fitted);
        let saved = (unknowns(&chosen_of(accepted)) - unknowns(trial)) * cost_of_unknown(independent);
        let [none, all] = [misfit(&without), misfit(fitted)];
        lost < saved || none - left > NEARLY_ALL * (none - all)
    });
    let Some((_, mut trial, mut next)) = one else {
        let mut chosen = chosen_of(accepted);
        *fitted = tested.fit(&mut chosen);
        adopt(accepted, &chosen);
        return;
    };
    let terms = next.terms.last().map_or(&[][..], |t| t.as_slice());
    if let Some(named) = trial.last().and_then(|body| equivalent_robot_cause(tested, body, terms))
        && let Some(last) = trial.last_mut()
    {
        *last = named;
    }
    let mut whole = bodies[0].clone();
    whole.support = bodies.iter().map(|b| b.support).fold(f64::NEG_INFINITY, f64::max);
    whole.variance = bodies.iter().map(|b| b.variance).sum();
    whole.rivals.clear();
    kept.push(whole);
    next = tested.fit(&mut trial);
    adopt(&mut kept, &trial);
    (*accepted, *fitted) = (kept, next);
}
