//! Stepwise exchange: tests each accepted cause again in the presence of all others.

use super::candidate::{candidates, evaluate, refine, rivals, sparest_first};
use super::judge::{Accepted, Judge, adopt, chosen_of};
use super::{SearchSettings, makes_sense};
use crate::diagnose::fit::model::{Chosen, Fitted, ModelUnderTest};
use crate::diagnose::hypotheses::Hypothesis;

/// Takes each cause out in turn. It is dropped if the fit does not need it, or replaced by a cause
/// that does better now that the others are known.
pub(in crate::diagnose) fn stepwise_exchange(
    tested: &mut ModelUnderTest<'_>,
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
        let mut without = chosen_of(accepted);
        let removed = without.remove(index);
        let turned = reshape(tested, &mut without, &removed.place);
        let reduced = tested.fit(&mut without);
        let others: Vec<Accepted> =
            accepted.iter().enumerate().filter(|(i, _)| *i != index).map(|(_, a)| a.clone()).collect();
        let wanted = |cause: &'static dyn Hypothesis, place: &[usize]| {
            (place == removed.place.as_slice() || place.is_empty())
                && !cause.moves_time()
                && makes_sense(tested, cause)
                && without.iter().filter(|c| c.cause.name() == cause.name() && c.place == place).count() < cause.most()
        };
        let mut ranked = candidates(tested, &reduced, &wanted);
        let moved = sparest_first(&mut ranked, tested, &without, &reduced);
        let reduced = if moved { tested.fit(&mut without) } else { reduced };
        let mut replaced = false;
        for (rank, candidate) in ranked.iter().take(2).enumerate() {
            let mut trial = without.clone();
            trial.push(candidate.chosen());
            let next = tested.fit(&mut trial);
            let judge = Judge { tested, noise, settings, accepted: &others, tried: ranked.len() };
            if let Some(mut judged) = judge.judge(&reduced, &next, &trial) {
                judged.rivals = rivals(&ranked, rank, &next);
                if turned && judged.chosen.cause.name() == removed.cause.name() {
                    // It is needed whatever the shapes of the others: all keep the shapes found
                    // beside it.
                    accepted[index] = Accepted { chosen: removed.clone(), ..judged };
                    replaced = true;
                    break;
                }
                let (first, last) = (index, trial.len() - 1);
                let chosen = trial.remove(last);
                trial.insert(first, chosen);
                judged.chosen = trial[first].clone();
                accepted[index] = judged;
                adopt(accepted, &trial);
                replaced = true;
                break;
            }
        }
        if replaced {
            index += 1;
        } else {
            accepted.remove(index);
            adopt(accepted, &without);
        }
    }
    let mut chosen = chosen_of(accepted);
    *fitted = tested.fit(&mut chosen);
    adopt(accepted, &chosen);
}

/// Refines the shapes of the causes on a joint again, each beside the others: their first shapes
/// may have absorbed another cause. Returns whether there are any.
fn reshape(tested: &mut ModelUnderTest<'_>, chosen: &mut [Chosen], place: &[usize]) -> bool {
    let shaped = |c: &Chosen| c.cause.shape().iter().any(|number| number.step.is_some());
    let peers: Vec<usize> = (0..chosen.len())
        .filter(|&k| {
            !place.is_empty() && chosen[k].place == place && shaped(&chosen[k]) && !chosen[k].cause.moves_time()
        })
        .collect();
    for &k in &peers {
        let mut rest = chosen.to_vec();
        let own = rest.remove(k);
        let reduced = tested.fit(&mut rest);
        if let Some(mut candidate) = evaluate(tested, &reduced, own.cause, &own.place, &own.shape) {
            refine(tested, &reduced, &mut candidate);
            chosen[k] = candidate.chosen();
        }
    }
    !peers.is_empty()
}
