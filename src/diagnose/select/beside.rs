//! Compares a model with the same model without one of its causes.
//!
//! A cause is measured on the validating logs. A joint's error may be far larger there than on the
//! fitted logs, with the cause and without it. Then something else has changed between the logs (a
//! warmer gear, another tool). These logs can neither confirm nor refute the causes of that joint,
//! and the fitted logs decide.

use super::excess::{CHANGED, EXCESS};
use std::ops::Range;

use super::measure::{Figures, Measured, Meter, bootstrap, bootstrap_within, here, leave_out, share};
use super::refine_and_select::Session;
use crate::diagnose::findings::reported_cause::Item;
use crate::diagnose::fit::model::{Chosen, ModelUnderTest};
use crate::numerics::sums::root_mean_square;

/// Shares of its joint's error that a cause removes, where not measured on all validating logs.
#[derive(Clone, Copy)]
pub(in crate::diagnose) struct Shares {
    /// For a local cause: the share in the part of the log where it acts.
    pub(in crate::diagnose) within: Option<f64>,
    /// Share on the validating logs, where its joints differ and the fitted logs decide.
    pub(in crate::diagnose) far: Option<f64>,
    /// Not a share: ratio of the cause's size on the validating logs to that on the fitted logs,
    /// see [`Without::repeats`].
    pub(in crate::diagnose) repeats: Option<f64>,
    /// For a law of friction with changed plain levels: the share that it removes beside levels that
    /// are fitted without it.
    pub(in crate::diagnose) beside_levels: Option<f64>,
    /// Not a share: whether the validating logs are missed by more than with the unchanged file.
    pub(in crate::diagnose) worse: bool,
    /// Not a share: whether it removes next to nothing, see [`Without::is_nothing`].
    pub(in crate::diagnose) nothing: bool,
}

/// Range of the ratio of a cause's sizes in two recordings within which they agree.
const ALIKE: std::ops::RangeInclusive<f64> = 0.67..=1.5;

impl Shares {
    /// The share of its joint's error that counts, where it removes the share `part`. If that is
    /// measured on the fitted logs because its joints differ on the others, the share that it
    /// removes there counts half. A law of friction counts by what it removes beside levels.
    pub(in crate::diagnose) fn counted(&self, part: f64) -> f64 {
        let both = self.far.map_or(part, |far| 0.5 * (part + far));
        both.min(self.beside_levels.unwrap_or(1.0))
    }

    /// Whether validating logs whose joints differ otherwise still show the cause: estimated from
    /// them alone it has a similar size, and it reduces the error.
    pub(in crate::diagnose) fn recurs_far(&self) -> bool {
        self.far.is_some_and(|far| far > 0.0) && self.repeats.is_some_and(|ratio| ALIKE.contains(&ratio))
    }
}

/// Errors of a model without one of its causes.
pub(in crate::diagnose) struct Without {
    pub(in crate::diagnose) measured: Figures,
    /// 90 % interval of the share that the cause removes.
    pub(in crate::diagnose) interval: [f64; 2],
    /// For a local cause: the largest share of a joint's squared error that it removes there.
    pub(in crate::diagnose) within: Option<f64>,
    /// For a local cause: whether it makes a joint worse there.
    pub(in crate::diagnose) spoils: bool,
    /// Whether the errors are those on the fitted logs.
    pub(in crate::diagnose) near: bool,
    /// Joints that differ between fitted and validating logs, with the cause and without it.
    apart: Vec<bool>,
    /// Share that the cause removes on validating logs where its joints differ.
    pub(in crate::diagnose) far_share: Option<f64>,
    /// Size of the cause estimated from the validating logs alone, all else as fitted, divided by
    /// its size on the fitted logs; `None` where those logs cannot show it. An error of something
    /// else makes the share small and leaves this ratio at 1.
    pub(in crate::diagnose) repeats: Option<f64>,
    /// See [`Shares::beside_levels`].
    beside_levels: Option<f64>,
}

/// Squared error that a cause removes, relative to that of a plain refit, below which it is next to
/// nothing. An error of a fifth of the refit's RMS has twice as much.
const NOTHING: f64 = 0.02;

impl Without {
    /// Shares of its joint's error that the cause removes by other measures: see [`Shares`].
    pub(in crate::diagnose) fn shares(&self) -> Shares {
        let Self { within, far_share: far, repeats, beside_levels, .. } = *self;
        Shares { within, far, repeats, beside_levels, worse: false, nothing: false }
    }

    /// Whether the model `with` the cause removes, where these joints move (all if empty), next to
    /// nothing of the error of a plain `refit`, and perhaps nothing at all.
    pub(in crate::diagnose) fn is_nothing(&self, with: &Figures, refit: &[f64], joints: &[usize]) -> bool {
        let small = |j: usize| {
            let gain = self.measured.steady[j].powi(2) - with.steady[j].powi(2);
            gain < NOTHING * refit[j].powi(2)
        };
        let own = |j: &usize| joints.is_empty() || joints.contains(j);
        self.may_be_chance() && (0..refit.len()).filter(own).all(small)
    }

    /// Errors where joints move. On joints that differ between the logs, those of the model `with`
    /// the cause, which neither confirm nor refute it.
    pub(in crate::diagnose) fn alike(&self, with: &Measured) -> Vec<f64> {
        let joints = self.measured.steady.iter().zip(&with.steady).zip(&self.apart);
        joints.map(|((without, with), apart)| if *apart { *with } else { *without }).collect()
    }

    /// Whether the interval of the share removed on its main joint includes 0.
    pub(in crate::diagnose) fn may_be_chance(&self) -> bool {
        self.interval[0] <= 0.0
    }

    /// Whether all joints of a place differ between the logs.
    pub(in crate::diagnose) fn differs(&self, place: &[usize]) -> bool {
        !place.is_empty() && place.iter().all(|&j| self.apart[j])
    }
}

/// The largest share of a joint's squared error that a cause removes within a span of samples,
/// where it exceeds half of the noise. `errors`: without and with the cause.
pub(in crate::diagnose) fn share_within(span: Range<usize>, errors: [&Measured; 2], noise: &[f64]) -> f64 {
    let joint = |(j, noise): (usize, &f64)| {
        let [a, b] = errors.map(|m| m.error[j].get(span.clone()).map_or(0.0, |e| root_mean_square(e).powi(2)));
        if a - b > (0.5 * noise).powi(2) { 1.0 - b / a } else { 0.0 }
    };
    noise.iter().enumerate().map(joint).fold(0.0, f64::max)
}

/// Size of a cause estimated from these logs alone, relative to the fitted one. It is the
/// regression of the errors without the cause on the change by the cause, where each joint moves,
/// weighted by its own error.
fn size(without: &Measured, with: &Measured) -> Option<f64> {
    let (mut pull, mut information) = (0.0, 0.0);
    for (joint, rms) in with.steady.iter().enumerate() {
        let [after, before] = with.where_it_moves(without, joint);
        if *rms <= 0.0 || before.len() != after.len() {
            continue;
        }
        for (b, a) in before.iter().zip(&after) {
            pull += (b - a) * b / (rms * rms);
            information += (b - a).powi(2) / (rms * rms);
        }
    }
    (information > 0.0).then(|| pull / information)
}

/// Measures a model against the same model without one of its causes.
pub(in crate::diagnose) struct Beside<'c, 'a> {
    pub(in crate::diagnose) session: &'c Session<'a>,
    pub(in crate::diagnose) far: Meter<'a>,
    pub(in crate::diagnose) near: Meter<'a>,
    pub(in crate::diagnose) after: &'c Measured,
    pub(in crate::diagnose) after_fit: &'c Measured,
}

impl<'a> Beside<'_, 'a> {
    /// Errors without a cause, on the validating logs, or on the fitted ones if the validating logs
    /// cannot refute it.
    pub(in crate::diagnose) fn without(
        &mut self,
        tested: &mut ModelUnderTest<'a>,
        chosen: &[Chosen],
        item: &Item,
    ) -> Without {
        let near = here(item, self.after);
        let found = self.on(near, tested, chosen, item);
        if near || !found.differs(&item.place) {
            return found;
        }
        let far = share(&found.measured.steady, &self.after.steady, self.session.noise, &item.place);
        let Without { apart, repeats, .. } = found;
        Without { apart, far_share: Some(far), repeats, ..self.on(true, tested, chosen, item) }
    }

    fn on(&mut self, near: bool, tested: &mut ModelUnderTest<'a>, chosen: &[Chosen], item: &Item) -> Without {
        let Session { plant, fit, noise, own_validation, .. } = *self.session;
        let (meter, with) = if near { (&mut self.near, self.after_fit) } else { (&mut self.far, self.after) };
        let measured = leave_out(plant, fit, meter, tested, chosen, item, !near);
        let beside_levels = item.law_alone().map(|law| {
            let levels = leave_out(plant, fit, meter, tested, chosen, &law, !near);
            share(&levels.steady, &with.steady, noise, &item.place)
        });
        let apart = |j: usize| {
            let both = self.after.steady[j].min(measured.steady[j]);
            own_validation && !near && both > CHANGED * self.after_fit.steady[j].max(EXCESS * noise[j])
        };
        let apart = (0..noise.len()).map(apart).collect();
        let span =
            item.accepted.filter(|_| item.hypothesis.local()).and_then(|i| chosen[i].span(self.near.fine.scene.step));
        let within = span.clone().map(|span| share_within(span, [&measured, with], noise));
        let spoils = span.clone().is_some_and(|span| with.is_worse_within(span, &measured, noise));
        let repeats = if near { None } else { size(&measured, with) };
        let interval = match span {
            Some(span) => bootstrap_within(span, &measured, with),
            None => bootstrap(&measured, with, &item.place),
        };
        let measured = measured.figures();
        Without { interval, measured, within, spoils, near, apart, far_share: None, repeats, beside_levels }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Errors of the model without a cause, and the ends of the interval of what it removes.
    fn without(steady: [f64; 2], interval: [f64; 2]) -> Without {
        let measured = Figures { rms: steady.to_vec(), steady: steady.to_vec() };
        let (within, far_share, repeats, beside_levels) = (None, None, None, None);
        let apart = vec![false; 2];
        Without { measured, interval, within, spoils: false, near: false, apart, far_share, repeats, beside_levels }
    }

    #[test]
    fn the_smallest_share_counts() {
        let of = |far: Option<f64>, beside_levels: Option<f64>| {
            let shares = Shares { within: None, far, repeats: None, beside_levels, worse: false, nothing: false };
            shares.counted(0.8)
        };
        assert_eq!(of(None, None), 0.8);
        assert_eq!(of(Some(0.2), None), 0.5);
        assert_eq!(of(None, Some(0.1)), 0.1);
        assert_eq!(of(Some(0.2), Some(0.6)), 0.5);
    }

    /// A joint's error falls from 0.030 to 0.025 N m where a plain refit misses it by 0.2: that is
    /// nothing, unless the data surely show it, or the refit predicts as well.
    #[test]
    fn what_may_be_chance_and_is_small_is_nothing() {
        let with = |second: f64| Figures { rms: vec![0.025, second], steady: vec![0.025, second] };
        let chance = without([0.030, 0.5], [-0.1, 0.6]);
        assert!(chance.is_nothing(&with(0.5), &[0.2, 1.0], &[0]));
        assert!(!without([0.030, 0.5], [0.1, 0.6]).is_nothing(&with(0.5), &[0.2, 1.0], &[0]));
        assert!(!chance.is_nothing(&with(0.5), &[0.1, 1.0], &[0]));
        // One of the robot's joints gains a quarter of the refit's squared error.
        assert!(!chance.is_nothing(&with(0.0), &[0.2, 1.0], &[]));
        assert!(chance.is_nothing(&with(0.0), &[0.2, 1.0], &[0]), "of its own joints");
    }
}
