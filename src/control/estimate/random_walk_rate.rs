//! How fast a component of the wrench wanders, from its own estimate.
//!
//! In a steady state a Kalman filter for a random walk of rate `w` (standard deviation after a
//! second) in noise of density `R` is a low-pass of time constant `T = sqrt(R) / w`. Its error has
//! two halves, `R / (2 T)` of noise and as much of lag. The lag is seen in the estimate, as the
//! lead over its own low-pass of the same `T`. This is `v T` for a ramp of rate `v`, `w^2 T / 2` in
//! the mean square for a random walk, and `R / (4 T)` for its remaining noise. The pace at which
//! the lag is half of the error is `w^3 = 2 v^2 sqrt(R)`: for a random walk its own. Rates come and
//! go: a sine's is twice its mean square at its height, and that is what is taken.

use super::sample::NINETY_FIVE;

/// Mean over so long, s.
const MEMORY: f64 = 0.3;
/// A time constant longer than this, at full rate, belongs to a component that the joints hardly
/// determine: nothing is estimated from it then.
const SLOWEST: f64 = 0.03;
/// The least pace, as a share of the largest.
const LEAST: f64 = 0.01;

/// The pace of one component.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RandomWalkRate {
    most: f64,
    pace: f64,
    /// The estimate, low-passed.
    slow: Option<f64>,
    /// Mean square of the rate.
    rate: f64,
}

impl RandomWalkRate {
    /// As fast as it may be.
    pub fn new(most: f64) -> Self {
        Self { most, pace: most, slow: None, rate: 0.0 }
    }

    /// After a second, standard deviation.
    pub fn now(&self) -> f64 {
        self.pace
    }

    /// Mean square of its rate of late, squared unit per s^2, at its height; zero where nothing is
    /// found out of the estimate.
    pub fn rate(&self) -> f64 {
        2.0 * self.rate.max(0.0)
    }

    /// Term missing in the filter's variance `variance` of this component, in noise of this
    /// density, because the rate is only found from the estimate:
    ///
    /// - found to wander faster than the filter took it to of late, it has the error of that pace,
    ///   in a steady state `sqrt(R) w`, already;
    /// - lag, which at the chosen rate is a quarter of the variance in the mean (half of it where a
    ///   sine is steepest). It is determined as well as the mean square of the rate: from `nu = 2 M
    ///   / T + 1` independent looks (an averaging time `M` over values correlated for `T / 2`), so
    ///   that its 95 % are those of Student's distribution.
    pub fn missing(&self, variance: f64, density: f64) -> f64 {
        if self.rate == 0.0 || !(density > 0.0 && variance > 0.0) {
            return 0.0;
        }
        let root = libm::sqrt(density);
        let looks = 2.0 * MEMORY * self.pace / root + 1.0;
        // The normal deviate z = 1.96 in Cornish and Fisher's expansion: (z^3 + z) / 4 and (5 z^5 +
        // 16 z^3 + 3 z) / 96.
        let wider = (NINETY_FIVE + 2.37 / looks + 2.82 / (looks * looks)) / NINETY_FIVE;
        let all = variance.max(root * self.pace);
        all - variance + 0.25 * all * (wider * wider - 1.0)
    }

    /// Takes in the estimate, `dt` s after the one before, in noise of this density (squared unit
    /// times s).
    pub fn see(&mut self, value: f64, density: f64, dt: f64) {
        let root = libm::sqrt(density.max(0.0));
        let slow = *self.slow.get_or_insert(value);
        if !(root > 0.0 && root < SLOWEST * self.most) {
            (self.pace, self.slow, self.rate) = (self.most, Some(value), 0.0);
            return;
        }
        let lag = (root / self.pace).max(dt);
        let slow = value + libm::exp(-dt / lag) * (slow - value);
        self.slow = Some(slow);
        let ahead = (value - slow) * (value - slow);
        let noise = density / (4.0 * lag);
        let seen = (ahead - noise) / (lag * lag);
        // Values that can't be noise count at once: a blow does not wait for a mean.
        let share =
            if ahead > 25.0 * (noise + self.rate.max(0.0) * lag * lag) { 1.0 } else { 1.0 - libm::exp(-dt / MEMORY) };
        self.rate += share * (seen - self.rate);
        let pace = libm::cbrt(4.0 * self.rate.max(0.0) * root);
        self.pace = pace.clamp(LEAST * self.most, self.most);
    }
}
