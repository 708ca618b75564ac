//! Judges what arrives: is there a sample, is it new, can it be true, and do its stamps agree with
//! the count of steps?
//!
//! The count of steps is a clock of its own: a step is a period. A stamp only says whether a sample
//! is new, and how far in time it is from the one before, as far as the count bears it out.

use super::machine::Arrival;

/// Measurements of the robot at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample<const N: usize> {
    /// Time stamp, s. One that is not later than the one before marks a sample that did not arrive.
    pub t: f64,
    /// Measured positions, rad or m; not a number where one is missing.
    pub q: [f64; N],
    /// Force of the tool on what it presses, along the target's normal, N: estimated or measured;
    /// not a number where it is missing.
    pub force: f64,
    /// Force of the tool on its surroundings, world axes, N: estimated. Its part aside of the
    /// normal is read where [`Settings::aside`](super::Settings::aside) is not 0; not a number
    /// where it is missing.
    pub push: [f64; 3],
}

/// Share of the disagreement of stamps and steps that is forgotten in each step: clocks may differ
/// by this share of the tolerance in periods, 6.5 % with a patience of 5.
const FORGOTTEN: f64 = 0.01;

/// Counts whether too much of something is bad. What is bad weighs as much as two that are good: a
/// third may be bad for long.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Tally(u32);

impl Tally {
    /// Weight of one that is bad.
    const BAD: u32 = 2;
    /// Weight at which too many are bad: 20 in a row from none, as libfranka has it.
    const MOST: u32 = 40;

    /// Counts one more, and says whether too many are bad.
    pub(super) fn count(&mut self, bad: bool) -> bool {
        self.0 = if bad { (self.0 + Self::BAD).min(Self::MOST + Self::BAD) } else { self.0.saturating_sub(1) };
        self.0 > Self::MOST
    }
}

/// Keeps the last good position, its stamp, and how many steps it is old.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Watch<const N: usize> {
    period: f64,
    /// Speeds that can't be true, rad/s or m/s.
    fastest: [f64; N],
    patience: u32,
    last: Option<(f64, [f64; N])>,
    /// What arrived last, good or not.
    heard: Option<(f64, [f64; N])>,
    /// Steps since the last good sample.
    since: u32,
    /// By how much the stamps have run ahead of the steps of late, s.
    slip: f64,
    bad: Tally,
}

impl<const N: usize> Watch<N> {
    /// For samples each `period` (s), of which `patience` in a row may fail, of joints that can't
    /// be faster than this.
    pub fn new(period: f64, patience: u32, fastest: [f64; N]) -> Self {
        Self { period, fastest, patience, last: None, heard: None, since: 0, slip: 0.0, bad: Tally::default() }
    }

    /// The last good position.
    pub fn position(&self) -> Option<[f64; N]> {
        self.last.map(|(_, q)| q)
    }

    /// Resets the state: the next sample is the first.
    pub fn reset(&mut self) {
        *self = Self::new(self.period, self.patience, self.fastest);
    }

    /// Longest time by which a sample may be late, s.
    fn late(&self) -> f64 {
        (f64::from(self.patience) + 1.5) * self.period
    }

    /// Counts a step and judges its sample, with the time since the last good one, s. Whether the
    /// stamps are believed: after a fault the count of steps is the only clock.
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
        // Not `dt <= 0`: a difference that overflows is no time either.
        if !(dt > 0.0 && dt.is_finite()) {
            let runs = heard.is_some_and(|(t, _)| sample.t > t && sample.t - t <= self.late());
            return if runs && self.since > self.patience { self.jumped(sample) } else { self.bad(own) };
        }
        let slip = (1.0 - FORGOTTEN) * self.slip + dt - own;
        if dt > self.late() || slip.abs() > self.late() {
            return self.jumped(sample);
        }
        // A step of the encoder in a sample that came early is no leap.
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

    /// The position is taken, the time of it is not.
    fn jumped(&mut self, sample: &Sample<N>) -> (Arrival, f64) {
        let own = f64::from(self.since) * self.period;
        self.take(sample, own);
        (Arrival::Jumped, own)
    }

    /// A leap that lasts is a fault after some steps; from there on the arm is where it says.
    fn bad(&mut self, own: f64) -> (Arrival, f64) {
        (if self.bad.count(true) { Arrival::Gone } else { Arrival::Bad }, own)
    }
}
