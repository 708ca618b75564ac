//! Compares plain friction, which is always among the unknowns, with the other causes on equal
//! terms.

use super::candidate::{Candidate, candidates, price, rivals, unknowns};
use super::judge::{Accepted, Judge, adopt, chosen_of};
use super::{SearchSettings, makes_sense};
use crate::diagnose::fit::model::{Fitted, ModelUnderTest};
use crate::diagnose::fit::white_errors::white_gain;
use crate::diagnose::hypotheses::{Hypothesis, PLAIN};

/// Alternatives to the plain friction of one joint.
pub struct BaselineFriction {
    /// Joint, from 0.
    pub joint: usize,
    /// Near alternatives to it: cause, place, difference of support.
    pub rivals: Vec<(&'static str, Vec<usize>, f64)>,
}

/// Compares plain friction with the other causes on equal terms. If a joint has no cause of its own
/// but changed friction or an offset, that friction is taken out and every cause of the joint is
/// tried instead. A candidate that explains more for its unknowns replaces the friction; those that
/// explain nearly as much become rivals.
pub fn reconsider(
    tested: &mut ModelUnderTest<'_>,
    accepted: &mut Vec<Accepted>,
    mut fitted: Fitted,
    noise: &[f64],
    settings: &SearchSettings,
) -> (Fitted, Vec<BaselineFriction>) {
    let mut all = Vec::new();
    for j in 0..tested.scene.dof() {
        let free: Vec<usize> = (3 * j..3 * j + 3).filter(|k| !tested.frozen[*k]).collect();
        // Reconsider a joint whose friction returned to the file's values if it leaves more than
        // noise.
        let left = fitted.solution.rss[j] > fitted.solution.counts[j] * (0.7 * noise[j]).powi(2);
        if free.is_empty() && !left || accepted.iter().any(|a| a.chosen.place.contains(&j)) {
            continue;
        }
        let chosen = chosen_of(accepted);
        let delays = tested.scene.delays.clone();
        free.iter().for_each(|&k| tested.frozen[k] = true);
        let mut without = chosen.clone();
        let reduced = tested.fit(&mut without);
        let wanted = |cause: &'static dyn Hypothesis, place: &[usize]| place == [j] && makes_sense(tested, cause);
        let ranked = candidates(tested, &reduced, &wanted);
        let counts = reduced.solution.counts.iter().copied();
        let raw = white_gain(&reduced.solution.rss, &fitted.solution.rss, counts);
        let plain = raw - free.len() as f64 * price(&reduced);
        let memory = fitted.memory[j];
        let mut replaced = false;
        if let Some(best) = ranked.first().filter(|c| is_better(c, plain, free.len(), memory)) {
            let mut trial = without.clone();
            trial.push(best.chosen());
            let next = tested.fit(&mut trial);
            let judge = Judge { tested, noise, settings, accepted: accepted.as_slice(), tried: ranked.len() };
            if let Some(mut judged) = judge.judge(&reduced, &next, &trial) {
                judged.rivals = rivals(&ranked, 0, &next);
                let margin = (best.score - plain) / memory;
                let near = best.score - plain < (10.0 * memory).max(0.015 * best.score);
                let plain = free.iter().filter(|_| near).map(|k| PLAIN[k % 3].name());
                judged.rivals.extend(plain.map(|name| (name, vec![j], margin)));
                accepted.push(judged);
                adopt(accepted, &trial);
                fitted = next;
                replaced = true;
            }
        }
        if replaced {
            continue;
        }
        free.iter().for_each(|&k| tested.frozen[k] = false);
        tested.set_delays(&delays);
        let near = |c: &&Candidate| plain - c.score < (10.0 * memory).max(0.015 * plain);
        let rivals = ranked.iter().filter(near).take(4);
        let rivals = rivals.map(|c| (c.cause.name(), c.place.clone(), ((plain - c.score) / memory).max(0.0))).collect();
        all.push(BaselineFriction { joint: j, rivals });
    }
    let mut chosen = chosen_of(accepted);
    fitted = tested.fit(&mut chosen);
    adopt(accepted, &chosen);
    (fitted, all)
}

/// Whether a candidate explains more than plain friction with this score and number of terms. A
/// candidate with as many unknowns must explain clearly more to be preferred.
pub(in crate::diagnose) fn is_better(candidate: &Candidate, plain: f64, terms: usize, memory: f64) -> bool {
    let unknowns = unknowns(candidate.cause, &candidate.shape, candidate.gain.x.len());
    let margin = match terms > 0 && unknowns >= terms as f64 {
        true => (10.0 * memory).max(0.015 * candidate.score),
        false => 4.0 * memory,
    };
    candidate.score > plain + margin
}
