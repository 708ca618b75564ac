//! Judges what arrives: is there a sample, is it new, can it be true?

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

/// Outcome of a sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Judged {
    /// Can be used; seconds since the one before.
    Good(f64),
    /// Can't be used; so many in a row.
    Bad(u32),
    /// Good, but after a pause that was too long to have been in control.
    Late,
}

/// Keeps the last good position and its time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Watch<const N: usize> {
    period: f64,
    /// Speeds that can't be true, rad/s or m/s.
    fastest: [f64; N],
    patience: u32,
    last: Option<(f64, [f64; N])>,
    missed: u32,
}

impl<const N: usize> Watch<N> {
    /// For samples each `period` (s), of which `patience` in a row may fail, of joints that can't
    /// be faster than this.
    pub fn new(period: f64, patience: u32, fastest: [f64; N]) -> Self {
        Self { period, fastest, patience, last: None, missed: 0 }
    }

    /// The last good position.
    pub fn position(&self) -> Option<[f64; N]> {
        self.last.map(|(_, q)| q)
    }

    /// Resets the state: the next sample is the first.
    pub fn reset(&mut self) {
        (self.last, self.missed) = (None, 0);
    }

    pub(super) fn judge(&mut self, sample: &Sample<N>) -> Judged {
        if !sample.t.is_finite() || sample.q.iter().any(|q| !q.is_finite()) {
            return self.bad();
        }
        let Some((t, q)) = self.last else {
            self.take(sample);
            return Judged::Good(self.period);
        };
        let dt = sample.t - t;
        // Not `dt <= 0`: a difference that overflows is no time either.
        if !(dt > 0.0 && dt.is_finite()) {
            return self.bad();
        }
        if dt > (f64::from(self.patience) + 1.5) * self.period {
            self.take(sample);
            return Judged::Late;
        }
        // A step of the encoder in a sample that came early is no leap.
        let reach = dt.max(self.period);
        let follows = |j: usize| (sample.q[j] - q[j]).abs() <= self.fastest[j] * reach;
        if !(0..N).all(follows) {
            return self.bad();
        }
        self.take(sample);
        Judged::Good(dt)
    }

    fn take(&mut self, sample: &Sample<N>) {
        self.last = Some((sample.t, sample.q));
        self.missed = 0;
    }

    /// A leap that lasts makes the next sample late: there the arm is then.
    fn bad(&mut self) -> Judged {
        self.missed = self.missed.saturating_add(1);
        Judged::Bad(self.missed)
    }
}
