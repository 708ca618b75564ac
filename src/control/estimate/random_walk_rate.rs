//! Random-walk rate of a component of the wrench, found from its own estimate.
//!
//! In a steady state, a Kalman filter for a random walk of rate `w` (standard deviation after a
//! second) in noise of density `R` is a low-pass of time constant `T = sqrt(R) / w`. Its error has
//! two equal parts, `R / (2 T)` of noise and as much of lag. The lag is visible in the estimate as
//! the lead over its own low-pass of the same `T`. The lead is `v T` for a ramp of rate `v`; in the
//! mean square it is `w^2 T / 2` for a random walk and `R / (4 T)` for its remaining noise. The
//! rate at which the lag is half of the error is `w^3 = 2 v^2 sqrt(R)`: for a random walk, its own
//! rate. Rates vary with time: a sine's squared rate peaks at twice its mean square, and the peak
//! is used.

use super::sample::NINETY_FIVE;

/// Averaging time of the rate's mean square, s.
const MEMORY: f64 = 0.3;
/// Longest time constant at full rate, s. Beyond it the joints hardly determine the component, and
/// no rate is estimated.
const SLOWEST: f64 = 0.03;
/// Smallest random-walk rate, as a share of the largest.
const LEAST: f64 = 0.01;

/// Random-walk rate of one component.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RandomWalkRate {
    most: f64,
    pace: f64,
    /// Low-passed estimate.
    slow: Option<f64>,
    /// Mean square of the component's rate of change.
    rate: f64,
}

impl RandomWalkRate {
    /// Starts at the largest rate.
    pub fn new(most: f64) -> Self {
        Self { most, pace: most, slow: None, rate: 0.0 }
    }

    /// Current random-walk rate: standard deviation after a second.
    pub fn now(&self) -> f64 {
        self.pace
    }

    /// Peak of the squared rate of change, twice its recent mean square, squared unit per s^2. Zero
    /// where nothing can be found from the estimate.
    pub fn rate(&self) -> f64 {
        2.0 * self.rate.max(0.0)
    }

    /// Term missing in the filter's variance `variance` of this component, in noise of this
    /// density, because the rate is found only from the estimate:
    ///
    /// - A component that recently changed faster than the filter assumed already has the error of
    ///   that rate, in a steady state `sqrt(R) w`.
    /// - Lag, which at the chosen rate is a quarter of the variance on average (half of it where a
    ///   sine is steepest). It is as uncertain as the mean square of the rate, which comes from
    ///   `nu = 2 M / T + 1` independent values (an averaging time `M` over values correlated for
    ///   `T / 2`). Its 95 % quantile is therefore that of Student's distribution.
    pub fn missing(&self, variance: f64, density: f64) -> f64 {
        if self.rate == 0.0 || !(density > 0.0 && variance > 0.0) {
            return 0.0;
        }
        let root = libm::sqrt(density);
        let looks = 2.0 * MEMORY * self.pace / root + 1.0;
        // The normal deviate z = 1.96 in the Cornish-Fisher expansion: (z^3 + z) / 4 and (5 z^5 +
        // 16 z^3 + 3 z) / 96.
        let wider = (NINETY_FIVE + 2.37 / looks + 2.82 / (looks * looks)) / NINETY_FIVE;
        let all = variance.max(root * self.pace);
        all - variance + 0.25 * all * (wider * wider - 1.0)
    }

    /// Processes an estimate, `dt` s after the previous one, in noise of this density (squared unit
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
        // Values too large to be noise count at once, so that an impact is not delayed by the mean.
        let share =
            if ahead > 25.0 * (noise + self.rate.max(0.0) * lag * lag) { 1.0 } else { 1.0 - libm::exp(-dt / MEMORY) };
        self.rate += share * (seen - self.rate);
        let pace = libm::cbrt(4.0 * self.rate.max(0.0) * root);
        self.pace = pace.clamp(LEAST * self.most, self.most);
    }
}
