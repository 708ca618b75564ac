//! Support of a cause found by the search from the unchanged file: twice its gain in
//! log-likelihood, in independent windows, less its cost.

use super::candidate::unknowns;
use super::forward::main_joint;
use super::judge::{Accepted, adopt, chosen_of};
use crate::diagnose::fit::likelihood::gain_in_blocks;
use crate::diagnose::fit::model::{Chosen, Fitted, Mode, ModelUnderTest};
use crate::diagnose::fit::white_errors::{cost_of_unknown, independent_windows, white_gain};

/// Uncertainty of the time at which a push begins or ends, s.
const BLOCK: f64 = 0.03;

/// Share of the gain of innovations that counts, because they have larger outliers than normal
/// errors. With all of it, an apparent push of an untouched recording of a KUKA LWR pays by 23 to 26,
/// and true ones by 50 and more.
const AT_ONCE: f64 = 0.6;

/// Twice the gain in log-likelihood by a cause, in independent windows, on joints that count
/// (`live`). What acts in a part of the logs begins and ends at once, which stands out of slow
/// errors.
fn gain(tested: &ModelUnderTest<'_>, cause: &Chosen, live: &[Vec<bool>], [before, after]: [&Fitted; 2]) -> f64 {
    let windows = independent_windows(&before.solution.counts, &after.memory);
    let counted = windows.zip(live).map(|(n, live)| if live.contains(&true) { n } else { 0.0 });
    let slow = white_gain(&before.solution.rss, &after.solution.rss, counted);
    let block = ((BLOCK / tested.scene.step).round() as usize).max(1);
    let at_once = || AT_ONCE * gain_in_blocks(&before.residual, &after.residual, live, block);
    if cause.cause.local() { slow.max(at_once()) } else { slow }
}

/// Cost of one unknown of a model.
fn cost([before, after]: [&Fitted; 2]) -> f64 {
    cost_of_unknown(independent_windows(&before.solution.counts, &after.memory).sum())
}

/// [`gain`] on all joints, less the cost of the cause's unknowns and of the choice among so many
/// candidates.
pub(in crate::diagnose) fn gained(
    tested: &ModelUnderTest<'_>,
    cause: &Chosen,
    candidates: usize,
    fits: [&Fitted; 2],
) -> f64 {
    let unknowns = unknowns(cause.cause, &cause.shape, cause.x.len());
    gain(tested, cause, &tested.scene.live, fits) - unknowns * cost(fits) - 2.0 * (candidates as f64).ln()
}

/// Whether the joints other than the one on which a cause gains most pay for its coefficients
/// beyond the first. An error of that joint alone with the same course has one.
pub(in crate::diagnose) fn shows_on_other_joints(
    tested: &ModelUnderTest<'_>,
    cause: &Chosen,
    fits: [&Fitted; 2],
) -> bool {
    let main = main_joint(fits[0], fits[1]);
    let mut live = tested.scene.live.clone();
    live[main].fill(false);
    gain(tested, cause, &live, fits) > (cause.x.len() as f64 - 1.0) * cost(fits)
}

/// Computes the support of causes that act in a part of a log again, beside all others, with the
/// file's links. When they were accepted, another cause may have absorbed a part of their error that
/// has left the model since. Returns the fit of the whole model, or `None` without such causes.
pub(in crate::diagnose) fn support_beside_all(
    tested: &mut ModelUnderTest<'_>,
    accepted: &mut [Accepted],
) -> Option<Fitted> {
    let local: Vec<usize> = (0..accepted.len()).filter(|&i| accepted[i].chosen.cause.local()).collect();
    if local.is_empty() || tested.mode != Mode::Trusted {
        return None;
    }
    let mut chosen = chosen_of(accepted);
    let after = tested.fit(&mut chosen);
    for index in local {
        let mut others = chosen.clone();
        let cause = others.remove(index);
        let before = tested.fit(&mut others);
        accepted[index].support = gained(tested, &cause, accepted[index].tried, [&before, &after]);
    }
    tested.update_model(&after);
    adopt(accepted, &chosen);
    Some(after)
}
