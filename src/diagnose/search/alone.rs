//! Whether what acts in a part of a log shows there alone.

use super::candidate::evaluate;
use crate::diagnose::fit::model::{Chosen, Fitted, ModelUnderTest};

/// What acts in a part of a log gains at least so many times what it would gain elsewhere.
const ALONE: f64 = 3.0;

/// Duration, s, up to which a stretch must stand out from all others but one: errors of the motion
/// are as brief, and rare. A longer one stands out from three quarters of the others, since there
/// may be several.
const BRIEF: f64 = 0.5;

/// Stretches that are looked at on either side.
const MOST: usize = 400;

/// Whether a cause acts for so short a time that errors of the motion last as long.
pub(in crate::diagnose) fn is_brief(chosen: &Chosen) -> bool {
    chosen.cause.acts(&chosen.shape).is_some_and(|[start, end]| end - start <= BRIEF)
}

/// Whether a cause gains far more in its part of a log than it would anywhere else: a slow error
/// looks like a constant wrench in any short piece. `before` is the model without it. Where there is
/// nothing to compare with, that is unknown, and it is not taken for alone.
pub(in crate::diagnose) fn is_alone(tested: &ModelUnderTest<'_>, before: &Fitted, chosen: &Chosen) -> bool {
    let Chosen { cause, place, shape, .. } = chosen;
    let Some([start, end]) = cause.acts(shape) else { return true };
    let (length, all) = (end - start, tested.scene.len as f64 * tested.scene.step);
    let at = |begin: f64| {
        let mut shape = shape.clone();
        (shape[0], shape[1]) = (begin, begin + length);
        evaluate(tested, before, *cause, place, &shape).map(|c| c.raw(before))
    };
    let Some(here) = at(start) else { return false };
    let brief = is_brief(chosen);
    let step = length.max(1e-3);
    // From its ends onwards, so that a short log has some too.
    let [room_before, room_after] = [start, all - end].map(|room| room - length + 1e-9);
    let steps = |room: f64| (0..MOST).map(move |k| k as f64 * step).take_while(move |by| *by <= room);
    let begins = steps(room_before).map(|by| start - length - by).chain(steps(room_after).map(|by| end + by));
    let mut others: Vec<f64> = begins.filter_map(|begin| at(begin.max(0.0))).collect();
    others.sort_by(f64::total_cmp);
    let last = others.len().saturating_sub(1);
    let rank = if brief { last.saturating_sub(1) } else { (0.75 * last as f64).round() as usize };
    others.get(rank).is_some_and(|usual| here > ALONE * usual)
}
