//! Whether a cause that acts in a part of a log is supported in that part alone.

use super::candidate::evaluate;
use crate::diagnose::fit::model::{Chosen, Fitted, ModelUnderTest};
use crate::diagnose::windows::windowed_data::WindowedData;

/// Factor by which the gain of a local cause must exceed its gain elsewhere in the log.
pub(in crate::diagnose) const ALONE: f64 = 3.0;

/// Duration, s, up to which a stretch must stand out from all others but one, because errors of the
/// recorded motion are as brief, and rare. A longer stretch must stand out from three quarters of
/// the others, since several causes may act.
const BRIEF: f64 = 0.5;

/// Maximum number of stretches compared on either side.
const MOST: usize = 400;

/// Whether a cause acts for so short a time that errors of the recorded motion last as long.
pub(in crate::diagnose) fn is_brief(chosen: &Chosen) -> bool {
    chosen.cause.acts(&chosen.shape).is_some_and(|[start, end]| end - start <= BRIEF)
}

/// Share of its windows with another contact above which a push has no evidence of its own.
const TOUCHED: f64 = 0.5;

/// Whether a local cause acts while another cause is in contact with the robot. It is then an error
/// of that contact's law, which models the force as a function of position alone.
pub(in crate::diagnose) fn is_an_error_of_contact<'c>(
    scene: &WindowedData<'_>,
    last: &Chosen,
    others: impl IntoIterator<Item = &'c Chosen>,
) -> bool {
    let Some(span) = last.span(scene.step) else { return false };
    let share = |other: &Chosen| {
        let touches = other.cause.touches(scene, &other.shape);
        let part = touches.get(span.start..span.end.min(touches.len())).unwrap_or(&[]);
        part.iter().filter(|touches| **touches).count() as f64 / part.len().max(1) as f64
    };
    others.into_iter().any(|other| share(other) > TOUCHED)
}

/// Length of another push, relative to its own, up to which a push within it has no evidence of its
/// own: it is an error of the other one's course.
const ALIKE: usize = 4;

/// Whether a push acts mostly during another one of similar length.
pub(in crate::diagnose) fn is_an_error_of_a_push<'c>(
    scene: &WindowedData<'_>,
    last: &Chosen,
    others: impl IntoIterator<Item = &'c Chosen>,
) -> bool {
    let Some(span) = last.span(scene.step) else { return false };
    let within = |other: &Chosen| {
        let Some(other) = other.span(scene.step) else { return false };
        let shared = span.end.min(other.end).saturating_sub(span.start.max(other.start));
        2 * shared > span.len() && other.len() <= ALIKE * span.len()
    };
    others.into_iter().any(within)
}

/// Least motion of a compared stretch, as a share of the motion in the part where the cause acts.
const AS_MUCH: f64 = 0.5;

/// Cumulative motion of the arm up to each window: the speeds of all joints, each divided by its
/// maximum, summed.
fn motion(scene: &WindowedData<'_>) -> Vec<f64> {
    let mut sums = vec![0.0; scene.len + 1];
    for j in 0..scene.dof() {
        let [_, speed, _] = scene.motion_of(j);
        let fastest = speed.iter().fold(f64::MIN_POSITIVE, |most, v| most.max(v.abs()));
        sums[1..].iter_mut().zip(speed).for_each(|(sum, v)| *sum += v.abs() / fastest);
    }
    for w in 0..scene.len {
        sums[w + 1] += sums[w];
    }
    sums
}

/// Whether a cause gains far more in its part of the log than it would anywhere else. A slow error
/// resembles a constant wrench in any short stretch, and a motion-related one in any stretch with
/// as much motion. The gain is therefore compared with all stretches, and with those in which the
/// arm moves as much. `before` is the model without the cause. Without any stretch to compare with,
/// the answer is unknown, and `false` is returned.
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
    let sums = motion(&tested.scene);
    let moved = |begin: f64| {
        let [first, last] =
            [begin, begin + length].map(|t| ((t / tested.scene.step).round() as usize).min(sums.len() - 1));
        sums[last] - sums[first]
    };
    let least = AS_MUCH * moved(start);
    let brief = is_brief(chosen);
    let step = length.max(1e-3);
    // Start at the ends of the stretch, so that a short log also has stretches to compare.
    let [room_before, room_after] = [start, all - end].map(|room| room - length + 1e-9);
    let steps = |room: f64| (0..MOST).map(move |k| k as f64 * step).take_while(move |by| *by <= room);
    let begins = steps(room_before).map(|by| start - length - by).chain(steps(room_after).map(|by| end + by));
    let begins = begins.map(|begin| begin.max(0.0));
    let others: Vec<(f64, bool)> = begins.filter_map(|begin| Some((at(begin)?, moved(begin) >= least))).collect();
    let usual = |mut gains: Vec<f64>| {
        gains.sort_by(f64::total_cmp);
        let last = gains.len().saturating_sub(1);
        let rank = if brief { last.saturating_sub(1) } else { (0.75 * last as f64).round() as usize };
        gains.get(rank).copied()
    };
    let of_all = usual(others.iter().map(|(gain, _)| *gain).collect());
    let of_moving = usual(others.iter().filter(|(_, moving)| *moving).map(|(gain, _)| *gain).collect());
    of_all.is_some_and(|usual| here > ALONE * of_moving.map_or(usual, |moving| usual.max(moving)))
}
