//! Decides whether a candidate is accepted. Its gain must exceed the cost of its unknowns and of
//! the number of candidates. Parts of the data that were not used to fit it must confirm it, and
//! its effect must be large enough beside the noise.

use super::SearchSettings;
use super::alone::{is_alone, is_an_error_of_a_push, is_an_error_of_contact};
use super::candidate::unknowns;
use super::driving_friction::friction_drives;
use crate::diagnose::fit::likelihood::gain as autoregressive_gain;
use crate::diagnose::fit::model::{Chosen, Fitted, ModelUnderTest};
use crate::diagnose::fit::moments::Solution;
use crate::diagnose::fit::white_errors::{cost_of_unknown, independent_windows, white_gain};
use crate::diagnose::hypotheses::{Hypothesis, Kind, Sign, at_edge};

/// An accepted cause with its evidence.
#[derive(Clone)]
pub struct Accepted {
    /// The cause, with place, shape and coefficients.
    pub chosen: Chosen,
    /// Twice the gain in log-likelihood, in independent windows, less the cost.
    pub support: f64,
    /// Number of candidates from which it was chosen.
    pub tried: usize,
    /// Share of the parts of the data that confirm it.
    pub confirmed: f64,
    /// Near alternatives: cause, place, difference of support.
    pub rivals: Vec<(&'static str, Vec<usize>, f64)>,
    /// Variance that it removes, summed over joints, (N m)^2.
    pub variance: f64,
}

#[cfg(test)]
impl Accepted {
    /// A cause with some evidence.
    pub(in crate::diagnose) fn of(chosen: Chosen) -> Self {
        Self { chosen, support: 1.0, tried: 1, confirmed: 1.0, rivals: Vec::new(), variance: 1.0 }
    }
}

/// The chosen causes, as a model takes them.
pub(in crate::diagnose) fn chosen_of(accepted: &[Accepted]) -> Vec<Chosen> {
    accepted.iter().map(|a| a.chosen.clone()).collect()
}

/// Copies the fitted shapes and coefficients back to the accepted causes.
pub(in crate::diagnose) fn adopt(accepted: &mut [Accepted], chosen: &[Chosen]) {
    accepted.iter_mut().zip(chosen).for_each(|(a, c)| a.chosen = c.clone());
}

/// Standard deviations from 0 from which a plain friction term is needed. Chance exceeds it once in
/// some 150,000 cases; the limit is high because many terms are tested.
pub(in crate::diagnose) const SURE: f64 = 4.5;

/// Share of a joint's squared error below which a cause removes nearly all of it.
const NEARLY: f64 = 0.1;

/// Share of a joint's squared error below which a friction law has the form of the error, even if
/// friction of this form would drive the joint.
const MOSTLY: f64 = 0.3;

/// Support assigned to a cause that holds in every stretch, where correlated windows cannot decide.
pub(super) const THROUGHOUT: f64 = 1.0;

/// Largest share of the logs in which local causes may act together.
const PART: f64 = 0.5;

/// Data, thresholds and accepted causes by which a candidate is judged.
pub(in crate::diagnose) struct Judge<'a> {
    pub(in crate::diagnose) tested: &'a ModelUnderTest<'a>,
    pub(in crate::diagnose) noise: &'a [f64],
    pub(in crate::diagnose) settings: &'a SearchSettings,
    /// Causes accepted before.
    pub(in crate::diagnose) accepted: &'a [Accepted],
    /// Number of candidates tried.
    pub(in crate::diagnose) tried: usize,
}

impl Judge<'_> {
    /// Whether some joint's residual exceeds the noise of its torque.
    pub(in crate::diagnose) fn leaves_more_than_noise(&self, fitted: &Fitted) -> bool {
        let Solution { rss, counts, .. } = &fitted.solution;
        rss.iter().zip(counts).zip(self.noise).any(|((rss, count), noise)| *rss > count * noise * noise)
    }

    /// Least reduction of a joint's mean squared error by a cause, (N m)^2. It is a share of the
    /// noise, and for causes that resemble errors of derivatives at least what these can produce.
    fn least(&self, cause: &dyn Hypothesis, joint: usize) -> f64 {
        let motion = self.tested.motion_error.get(joint).filter(|_| cause.follows_acceleration());
        let motion = motion.copied().unwrap_or(0.0);
        (self.settings.least_effect * self.noise[joint]).max(motion).powi(2)
    }

    /// Whether the last of `trial` removes nearly all of a joint's error in every left-out stretch.
    /// Its residual may be autocorrelated for so long that hardly a window is independent. A slow
    /// remainder does not refute a cause that predicts everything else.
    fn throughout(&self, before: &Fitted, after: &Fitted, trial: &[Chosen]) -> bool {
        let Some((last, others)) = trial.split_last() else { return false };
        let nearly = |j: usize| after.solution.rss[j] < NEARLY * before.solution.rss[j];
        let large = |j: usize| before.solution.rss[j] > before.solution.counts[j] * self.noise[j].powi(2);
        let joints: Vec<usize> = (0..self.noise.len()).filter(|&j| nearly(j) && large(j)).collect();
        if joints.is_empty() || last.cause.local() || last.cause.moves_time() {
            return false;
        }
        let [a, b] = [(others, before), (trial, after)].map(|(chosen, fitted)| self.tested.left_out(chosen, fitted));
        joints.into_iter().any(|j| b.nearly_all(&a, j, NEARLY))
    }

    /// Twice the gain in log-likelihood, in independent windows, less the cost of the unknowns and
    /// of the choice; `None` where it is too small. [`THROUGHOUT`] where correlated windows count
    /// too little and the errors of left-out stretches, or innovations, decide.
    pub(in crate::diagnose) fn support(
        &self,
        before: &Fitted,
        after: &Fitted,
        trial: &[Chosen],
        unknowns: f64,
    ) -> Option<f64> {
        let windows = || independent_windows(&before.solution.counts, &after.memory);
        let gain = white_gain(&before.solution.rss, &after.solution.rss, windows());
        let cost = unknowns * cost_of_unknown(windows().sum()) + 2.0 * (self.tried as f64).ln() + 6.0;
        if gain > cost {
            return Some(gain - cost);
        }
        let stands_out = || autoregressive_gain(&before.residual, &after.residual, &self.tested.scene.live) > cost;
        (self.throughout(before, after, trial) || stands_out()).then_some(THROUGHOUT)
    }

    /// Whether a fitted cause has plausible parameters: within their ranges, with the signs that
    /// its name implies.
    pub(in crate::diagnose) fn stands(&self, last: &Chosen, after: &Fitted) -> bool {
        let Chosen { cause, place, shape, x } = last;
        let Some(terms) = after.terms.last().filter(|terms| !terms.is_empty()) else { return false };
        let signed = terms.iter().zip(x).all(|(t, x)| t.sign != Sign::Positive || *x > 0.0);
        let beside: Vec<Chosen> = self.accepted.iter().map(|a| &a.chosen).chain([last]).cloned().collect();
        signed
            && !self.tested.unresolved(&beside)
            && !at_edge(*cause, shape)
            && cause.plausible(&self.tested.scene, place, shape, x)
            && self.tested.is_possible(last, terms)
    }

    /// Whether the last of `trial` is a friction law with which a joint's friction does positive
    /// work, and that leaves too much of the joint's error to be nevertheless its form.
    pub(in crate::diagnose) fn drives(&self, trial: &[Chosen], [before, after]: [&Fitted; 2]) -> bool {
        let joint = |c: &Chosen| c.place.first().copied().filter(|_| c.cause.kind() == Kind::Friction);
        let mostly = |j: usize| after.solution.rss[j] < MOSTLY * before.solution.rss[j];
        let drives = |j: usize| !mostly(j) && friction_drives(self.tested, j, trial, after, self.noise[j]);
        trial.last().and_then(joint).is_some_and(drives)
    }

    /// Whether a cause removes enough of some joint's error beside the noise.
    pub(in crate::diagnose) fn matters(&self, cause: &dyn Hypothesis, before: &Fitted, after: &Fitted) -> bool {
        let taken = variance_taken(before, after);
        let enough = |j: usize| taken[j] > self.least(cause, j).max(self.settings.least_gain * mean_square(before, j));
        (0..taken.len()).any(enough)
    }

    /// Whether a cause is only the misfit of an earlier law of its kind in the same place. For a
    /// law of another kind this applies unless the cause removes half of the remaining error.
    pub(in crate::diagnose) fn overshadowed(
        &self,
        cause: &dyn Hypothesis,
        place: &[usize],
        before: &Fitted,
        after: &Fitted,
    ) -> bool {
        let taken = variance_taken(before, after);
        let variance: f64 = taken.iter().filter(|t| **t > 0.0).sum();
        let most = (0..taken.len()).any(|j| taken[j] > 0.5 * mean_square(before, j));
        let here = |a: &Accepted| !place.is_empty() && a.chosen.place == place;
        let same = |a: &Accepted| here(a) && a.chosen.cause.kind() == cause.kind();
        self.accepted.iter().any(|a| {
            let share = if same(a) { self.settings.least_share } else { 0.3 * self.settings.least_share };
            (same(a) || here(a) && !most) && variance < share * a.variance
        })
    }

    /// Largest share of a joint's squared error that a local cause removes while it acts. `None`
    /// where that is less than a quarter, or too small beside the noise.
    pub(in crate::diagnose) fn share_within(&self, last: &Chosen, before: &Fitted, after: &Fitted) -> Option<f64> {
        let span = last.span(self.tested.scene.step)?;
        let square = |f: &Fitted, j: usize| {
            let part = f.residual[j].get(span.clone()).unwrap_or(&[]);
            part.iter().map(|e| e * e).sum::<f64>() / part.len().max(1) as f64
        };
        let share = |j: usize| {
            let [a, b] = [before, after].map(|f| square(f, j));
            (a - b > (0.25 * a).max(self.least(last.cause, j))).then(|| 1.0 - b / a)
        };
        (0..self.noise.len()).filter_map(share).reduce(f64::max)
    }

    /// Whether a local cause is supported in its part of the log alone; see [`is_alone`]. Local
    /// causes that together cover half of the logs or more are not accepted, nor is one during a
    /// contact or a push.
    pub(super) fn is_alone(&self, last: &Chosen, before: &Fitted) -> bool {
        let scene = &self.tested.scene;
        let others = || self.accepted.iter().map(|a| &a.chosen);
        if is_an_error_of_contact(scene, last, others()) || is_an_error_of_a_push(scene, last, others()) {
            return false;
        }
        let duration = |c: &Chosen| c.cause.acts(&c.shape).map_or(0.0, |[start, end]| end - start);
        let acting: f64 = self.accepted.iter().map(|a| duration(&a.chosen)).sum::<f64>() + duration(last);
        acting < PART * scene.len as f64 * scene.step && is_alone(self.tested, before, last)
    }

    /// Accepts the last of `trial` with its evidence; `None` if it is rejected.
    pub(in crate::diagnose) fn judge(&self, before: &Fitted, after: &Fitted, trial: &[Chosen]) -> Option<Accepted> {
        let last = trial.last()?;
        let Chosen { cause, place, shape, x } = last;
        let counts = &before.solution.counts;
        if !self.stands(last, after) || self.drives(trial, [before, after]) {
            return None;
        }
        let support = self.support(before, after, trial, unknowns(*cause, shape, x.len()))?;
        if !self.matters(*cause, before, after) || self.overshadowed(*cause, place, before, after) {
            return None;
        }
        let taken = variance_taken(before, after);
        let variance: f64 = taken.iter().filter(|t| **t > 0.0).sum();
        let stands: Vec<bool> = (0..counts.len()).map(|j| place.is_empty() && stands(self.tested, j)).collect();
        let Confirmation { confirmed, predicted, spoilt, stirred } = confirmation(before, after, &stands);
        if cause.local() {
            // No other part can confirm it: it must stand out by itself.
            if !(0..taken.len()).any(|j| taken[j] > 0.25 * mean_square(before, j)) || !self.is_alone(last, before) {
                return None;
            }
        } else if confirmed < 0.75
            || predicted < 0.6 * self.settings.least_gain
            || spoilt > bearable(*cause, predicted)
            || stirred > (0.5 * predicted).max(0.1)
        {
            return None;
        }
        Some(Accepted { chosen: last.clone(), support, tried: self.tried, confirmed, rivals: Vec::new(), variance })
    }
}

/// Whether a joint is at rest most of the time. The motion then hardly excites the file's errors of
/// that joint, and a cause of the whole robot can make them seem larger.
pub(in crate::diagnose) fn stands(tested: &ModelUnderTest<'_>, j: usize) -> bool {
    let (mut moving, mut all) = (0, 0);
    for sign in tested.scene.own[j].iter().flat_map(|own| own.sign.iter()) {
        moving += usize::from(sign != 0.0);
        all += 1;
    }
    2 * moving < all
}

/// Largest relative growth of another joint's error. A cause that explains most of one joint's
/// error is not refuted by earlier causes that still have to change. The limit is a tenth up to six
/// tenths of the error explained, and a half from nine tenths on. A body acts on many joints, each
/// with errors of its own: at least half of what it explains.
pub(in crate::diagnose) fn bearable(cause: &dyn Hypothesis, predicted: f64) -> f64 {
    let most = 0.1 + 0.4 * ((predicted - 0.6) / 0.3).clamp(0.0, 1.0);
    if cause.within_links() { most.max(0.5 * predicted) } else { most }
}

/// Result of leaving parts of the data out of the fit in turn.
pub(in crate::diagnose) struct Confirmation {
    /// Share of the parts that the larger model predicts better, weighted by their gain or loss.
    pub(in crate::diagnose) confirmed: f64,
    /// The largest share of a joint's error that the cause removes.
    predicted: f64,
    /// The largest share by which a joint's error grows.
    spoilt: f64,
    /// The same for joints at rest, if the cause is one of the whole robot.
    stirred: f64,
}

pub(in crate::diagnose) fn confirmation(before: &Fitted, after: &Fitted, stands: &[bool]) -> Confirmation {
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

/// Reduction of the variance of each joint's residual, (N m)^2.
fn variance_taken(before: &Fitted, after: &Fitted) -> Vec<f64> {
    let pairs = before.solution.rss.iter().zip(&after.solution.rss).zip(&before.solution.counts);
    pairs.map(|((a, b), n)| if *n > 0.0 { (a - b) / n } else { 0.0 }).collect()
}

/// Mean square of a joint's residual, (N m)^2.
fn mean_square(fitted: &Fitted, j: usize) -> f64 {
    let Solution { rss, counts, .. } = &fitted.solution;
    if counts[j] > 0.0 { rss[j] / counts[j] } else { 0.0 }
}
