//! Fourier series (Swevers et al., IEEE Transactions on Robotics and Automation 13(5), 1997):
//! periodic motions that can be repeated and averaged.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::error::CoefficientError;

/// `q = center + sum over l of sine_l sin(l w t) + cosine_l cos(l w t)`, `w = 2 pi / period`.
#[derive(Debug, Clone, PartialEq)]
pub struct Fourier {
    /// Length of a period, s.
    pub period: f64,
    /// Number of periods played.
    pub periods: usize,
    /// Constant part, rad or m, per joint.
    pub center: Vec<f64>,
    /// Amplitudes of the sines, rad or m, per joint.
    pub sine: Vec<Vec<f64>>,
    /// Amplitudes of the cosines, rad or m, per joint.
    pub cosine: Vec<Vec<f64>>,
}

impl Fourier {
    /// Checks that the shapes fit.
    ///
    /// # Errors
    /// If the shapes do not match.
    pub fn new(
        period: f64,
        periods: usize,
        center: Vec<f64>,
        sine: Vec<Vec<f64>>,
        cosine: Vec<Vec<f64>>,
    ) -> Result<Self, CoefficientError> {
        let harmonics = sine.first().map_or(0, Vec::len);
        if [&sine, &cosine].iter().any(|rows| rows.len() != center.len() || rows.iter().any(|r| r.len() != harmonics)) {
            return Err(CoefficientError::Amplitudes);
        }
        Ok(Self { period, periods, center, sine, cosine })
    }

    /// Derivative of order `order` of every joint at `t`, s.
    pub fn derivative(&self, t: f64, order: usize) -> Vec<f64> {
        let joint = |j: usize| {
            let sum: f64 = (0..self.sine[j].len())
                .map(|l| {
                    let (s, c) = harmonic(self.period, l + 1, t, order);
                    self.sine[j][l] * s + self.cosine[j][l] * c
                })
                .sum();
            if order == 0 { self.center[j] + sum } else { sum }
        };
        (0..self.center.len()).map(joint).collect()
    }
}

/// `sin(l w t)` and `cos(l w t)`, differentiated `order` times.
pub fn harmonic(period: f64, l: usize, t: f64, order: usize) -> (f64, f64) {
    let w = TAU * l as f64 / period;
    let phase = w * t + FRAC_PI_2 * (order % 4) as f64;
    let size = w.powi(order as i32);
    (size * phase.sin(), size * phase.cos())
}
