//! Validation of samples: whether one arrived, is new and plausible, and whether its time stamp
//! agrees with the step count.
//!
//! The step count is a clock of its own: a step is a period. A time stamp only shows whether a
//! sample is new, and the time since the previous one, as far as the step count confirms it.

use super::machine::Arrival;

/// Measurements of the robot at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample<const N: usize> {
    /// Time stamp, s. If it is not later than the previous one, the sample counts as missing.
    pub t: f64,
    /// Measured positions, rad or m; NaN where one is missing.
    pub q: [f64; N],
    /// Normal force of the tool on the surface, along the target's normal, N: estimated or
    /// measured; NaN where it is missing.
    pub force: f64,
    /// Estimated force of the tool on its surroundings, world axes, N; NaN where it is missing. Its
    /// tangential part is used where [`Settings::aside`](super::Settings::aside) is not 0.
    pub push: [f64; 3],
}

/// Share of the disagreement between time stamps and steps that decays in each step. Clocks may
/// differ by this share of the tolerance in periods, 6.5 % with a patience of 5.
const FORGOTTEN: f64 = 0.01;

/// Counts bad events against good ones. A bad one weighs as much as two good ones, so that a third
/// may be bad for long.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Tally(u32);

impl Tally {
    /// Weight of a bad event.
    const BAD: u32 = 2;
    /// Weight above which too many are bad: 20 in a row from zero, as in libfranka.
    const MOST: u32 = 40;

    /// Counts an event; returns whether too many are bad.
    pub(super) fn count(&mut self, bad: bool) -> bool {
        self.0 = if bad { (self.0 + Self::BAD).min(Self::MOST + Self::BAD) } else { self.0.saturating_sub(1) };
        self.0 > Self::MOST
    }
}

/// Last good position with its time stamp and age in steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Watch<const N: usize> {
    period: f64,
    /// Speeds above which a sample is implausible, rad/s or m/s.
    fastest: [f64; N],
    patience: u32,
    last: Option<(f64, [f64; N])>,
    /// Last sample received, good or not.
    heard: Option<(f64, [f64; N])>,
    /// Steps since the last good sample.
    since: u32,
    /// Recent lead of the time stamps over the steps, s.
    slip: f64,
    bad: Tally,
}

impl<const N: usize> Watch<N> {
    /// Creates a monitor for samples every `period`, s, of which `patience` in a row may fail. No
    /// joint can be faster than `fastest`, rad/s or m/s.
    pub fn new(period: f64, patience: u32, fastest: [f64; N]) -> Self {
        Self { period, fastest, patience, last: None, heard: None, since: 0, slip: 0.0, bad: Tally::default() }
    }

    /// Last good position, rad or m.
    pub fn position(&self) -> Option<[f64; N]> {
        self.last.map(|(_, q)| q)
    }

    /// Resets the state: the next sample is the first.
    pub fn reset(&mut self) {
        *self = Self::new(self.period, self.patience, self.fastest);
    }

    /// Longest delay of a sample, s.
    fn late(&self) -> f64 {
        (f64::from(self.patience) + 1.5) * self.period
    }

    /// Counts a step and validates its sample; returns the time since the last good one, s.
    /// `stamped` selects whether time stamps are used: after a fault the step count is the only
    /// clock.
    pub(super) fn judge(&mut self, sample: &Sample<N>, stamped: bool) -> (Arrival, f64) {
        self.since = self.since.saturating_add(1);
        let heard = self.heard.replace((sample.t, sample.q));
        let own = f64::from(self.since) * self.period;
        let numbers = sample.q.iter().all(|q| q.is_finite());
        if !stamped {
            let new = heard.is_none_or(|(t, q)| t.to_bits() != sample.t.to_bits() || q != sample.q);
            return if numbers && new { self.take(sample, own) } else { (Arrival::Bad, own) };
        }
        if !numbers || !sample.t.is_finite() {
            return self.bad(own);
        }
        let Some((t, q)) = self.last else { return self.take(sample, self.period) };
        let dt = sample.t - t;
        // Not `dt <= 0`: a difference that overflows is not a valid time either.
        if !(dt > 0.0 && dt.is_finite()) {
            let runs = heard.is_some_and(|(t, _)| sample.t > t && sample.t - t <= self.late());
            return if runs && self.since > self.patience { self.jumped(sample) } else { self.bad(own) };
        }
        let slip = (1.0 - FORGOTTEN) * self.slip + dt - own;
        if dt > self.late() || slip.abs() > self.late() {
            return self.jumped(sample);
        }
        // An encoder step in a sample that came early is not a discontinuity.
        let reach = dt.max(self.period);
        let follows = |j: usize| (sample.q[j] - q[j]).abs() <= self.fastest[j] * reach;
        if !(0..N).all(follows) {
            return self.bad(own);
        }
        self.slip = slip;
        self.bad.count(false);
        self.take(sample, dt.max(0.5 * self.period))
    }

    fn take(&mut self, sample: &Sample<N>, dt: f64) -> (Arrival, f64) {
        (self.last, self.since) = (Some((sample.t, sample.q)), 0);
        (Arrival::Good, dt)
    }

    /// Accepts the position but not its time stamp.
    fn jumped(&mut self, sample: &Sample<N>) -> (Arrival, f64) {
        let own = f64::from(self.since) * self.period;
        self.take(sample, own);
        (Arrival::Jumped, own)
    }

    /// Rejects a sample. A discontinuity that lasts becomes a fault after some steps; from then on
    /// the reported position is accepted.
    fn bad(&mut self, own: f64) -> (Arrival, f64) {
        (if self.bad.count(true) { Arrival::Gone } else { Arrival::Bad }, own)
    }
}
