//! Contact detection with a threshold that follows the predicted uncertainty.

use super::sample::Estimate;

/// Compares each sample's surprise with the quantile of its chi-square distribution: the threshold
/// is higher where the model is uncertain or the arm is near a singularity.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactDetector {
    /// Normal deviate above which a contact begins. Default 5: one false alarm in 3.5 million
    /// independent samples.
    pub on: f64,
    /// Normal deviate below which a contact ends. Default 3.
    pub off: f64,
    /// Time for which the surprise must stay beyond the threshold, s. Default 0.
    pub hold: f64,
    touching: bool,
    undecided: bool,
    since: f64,
}

impl Default for ContactDetector {
    fn default() -> Self {
        Self { on: 5.0, off: 3.0, hold: 0.0, touching: false, undecided: false, since: 0.0 }
    }
}

/// Contact state after a sample.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Contact {
    /// Whether something touches.
    pub touching: bool,
    /// Whether static friction and contact are indistinguishable: a joint is at rest, and friction
    /// within its breakaway level explains the residual.
    pub undecided: bool,
    /// Surprise as a normal deviate: below about 3 it is not significant.
    pub deviate: f64,
}

impl ContactDetector {
    /// Processes an estimate, `dt` s after the previous one. An estimate that is not fresh is
    /// ignored.
    pub fn step(&mut self, estimate: &Estimate, dt: f64) -> Contact {
        if !estimate.fresh {
            return Contact { touching: self.touching, undecided: self.undecided && !self.touching, deviate: 0.0 };
        }
        let [deviate, without] = [estimate.surprise, estimate.without_friction].map(|x| deviate(x, estimate.freedom));
        let beyond = if self.touching { deviate < self.off } else { deviate > self.on };
        self.since = if beyond { self.since + dt.max(0.0) } else { 0.0 };
        if beyond && self.since >= self.hold {
            (self.touching, self.since) = (!self.touching, 0.0);
        }
        let beyond = estimate.without_friction > estimate.surprise;
        self.undecided = beyond && without > if self.undecided { self.off } else { self.on };
        Contact { touching: self.touching, undecided: self.undecided && !self.touching, deviate }
    }

    /// Resets the state.
    pub fn reset(&mut self) {
        (self.touching, self.undecided, self.since) = (false, false, 0.0);
    }
}

/// Normal deviate with the same tail probability as this value of chi-square (Wilson and Hilferty,
/// PNAS 17, 1931: its cube root is nearly normal).
pub fn deviate(chi_square: f64, freedom: usize) -> f64 {
    if freedom == 0 {
        return 0.0;
    }
    let spread = 2.0 / (9.0 * freedom as f64);
    (libm::cbrt(chi_square.max(0.0) / freedom as f64) - (1.0 - spread)) / libm::sqrt(spread)
}
