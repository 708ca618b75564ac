//! Selects, of several laws of one effect, the simplest that the data do not reject.
//!
//! A law with a further term never fits worse, and correlated windows exaggerate its gain. The
//! criterion is Schwarz's. The logarithm of the ratio of the residual sums of squares is compared
//! with the number of further unknowns times the logarithm of the number of independent windows.
//! Windows are counted in units of the autocorrelation time of the richer law's residual.

use super::candidate::{Candidate, evaluate, refine, unknowns};
use super::judge::{Accepted, adopt, chosen_of};
use crate::diagnose::fit::model::{Chosen, Fitted, ModelUnderTest};
use crate::diagnose::fit::white_errors::{cost_of_unknown, independent_windows, white_gain};
use crate::diagnose::hypotheses::at_edge;

/// Replaces each cause whose further terms do not pay by a simpler law of the same effect.
pub(in crate::diagnose) fn simplest_laws(
    tested: &mut ModelUnderTest<'_>,
    accepted: &mut [Accepted],
    fitted: &mut Fitted,
) {
    let mut changed = false;
    for index in 0..accepted.len() {
        let own = accepted[index].chosen.clone();
        let laws = own.cause.simpler(&tested.scene, &own.place, &own.shape);
        if laws.is_empty() {
            continue;
        }
        changed = true;
        let mut rest = chosen_of(accepted);
        rest.remove(index);
        let without = tested.fit(&mut rest);
        for (cause, shapes) in laws {
            let of = |shape: &Vec<f64>| evaluate(tested, &without, cause, &own.place, shape);
            let best = shapes.iter().filter_map(of).max_by(|a, b| a.score.total_cmp(&b.score));
            let Some(mut simpler) = best else { continue };
            refine(tested, &without, &mut simpler);
            let mut trial = chosen_of(accepted);
            trial[index] = simpler.chosen();
            let next = tested.fit(&mut trial);
            if !at_edge(cause, &simpler.shape) && suffices(&simpler, &next, &own, fitted) {
                adopt(accepted, &trial);
                *fitted = next;
                break;
            }
        }
    }
    if changed {
        let mut chosen = chosen_of(accepted);
        *fitted = tested.fit(&mut chosen);
        adopt(accepted, &chosen);
    }
}

/// Whether the better fit of the richer law `own` over `simpler` does not pay for its unknowns.
fn suffices(simpler: &Candidate, next: &Fitted, own: &Chosen, fitted: &Fitted) -> bool {
    let further =
        unknowns(own.cause, &own.shape, own.x.len()) - unknowns(simpler.cause, &simpler.shape, simpler.gain.x.len());
    further > 0.0 && costs_less(next, fitted, further)
}

/// Whether the loss against a richer fit is within the cost of the given number of further
/// unknowns.
pub(super) fn costs_less(simpler: &Fitted, richer: &Fitted, further: f64) -> bool {
    let windows = || independent_windows(&richer.solution.counts, &richer.memory);
    let lost = white_gain(&simpler.solution.rss, &richer.solution.rss, windows());
    lost <= further.max(0.0) * cost_of_unknown(windows().sum())
}
