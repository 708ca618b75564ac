//! Resamples unevenly timed values to an even grid by penalised least squares.
//!
//! Between its grid points a signal is the cubic through four of them (Lagrange). The grid values
//! minimise the squared distance to the samples, with a small penalty on third differences (E. T.
//! Whittaker, *On a new method of graduation*, Proc. Edinburgh Math. Soc. 41, 1923). Interpolation
//! through every sample would amplify the noise of two samples that are close in time. The
//! operation is linear and the same for every channel.

use crate::numerics::prng::Random;
use crate::numerics::sums::root_mean_square;

/// Weight of the penalty. The gain of a third difference is `(2 sin(w / 2))^6`, so half the
/// amplitude is left at 0.26 of the sampling rate, half of what even samples could show.
const PENALTY: f64 = 0.1;

/// Factorised normal equations, shared by all channels with the same times.
pub(super) struct Resampler {
    /// First grid point and the four weights of each sample.
    rows: Vec<(usize, [f64; 4])>,
    /// Factor `L` of `L D L'`, three entries below the diagonal, and `D`.
    lower: Vec<[f64; 3]>,
    diagonal: Vec<f64>,
}

impl Resampler {
    /// Prepares samples at `times`, s, for a grid of `count` points (at least 4) from `start`,
    /// `period` apart.
    pub fn new(times: &[f64], start: f64, period: f64, count: usize) -> Self {
        let last = count.saturating_sub(4);
        let rows: Vec<(usize, [f64; 4])> = times
            .iter()
            .map(|t| {
                let at = (t - start) / period;
                let first = (at.floor().max(1.0) as usize - 1).min(last);
                (first, lagrange(at - first as f64))
            })
            .collect();
        // Bands of the normal matrix: `band[i][k]` is its entry `(i, i - k)`.
        let mut band = vec![[0.0; 4]; count];
        for (first, weights) in &rows {
            for a in 0..4 {
                for b in 0..=a {
                    band[first + a][a - b] += weights[a] * weights[b];
                }
            }
        }
        const DIFFERENCE: [f64; 4] = [-1.0, 3.0, -3.0, 1.0];
        for first in 0..count.saturating_sub(3) {
            for a in 0..4 {
                for b in 0..=a {
                    band[first + a][a - b] += PENALTY * DIFFERENCE[a] * DIFFERENCE[b];
                }
            }
        }
        let (mut lower, mut diagonal) = (vec![[0.0; 3]; count], vec![0.0; count]);
        for i in 0..count {
            for k in (1..=3.min(i)).rev() {
                let mut sum = band[i][k];
                for m in k + 1..=3.min(i) {
                    sum -= lower[i][m - 1] * diagonal[i - m] * lower[i - k][m - k - 1];
                }
                lower[i][k - 1] = sum / diagonal[i - k];
            }
            let taken: f64 = (1..=3.min(i)).map(|k| lower[i][k - 1].powi(2) * diagonal[i - k]).sum();
            diagonal[i] = (band[i][0] - taken).max(f64::MIN_POSITIVE);
        }
        Self { rows, lower, diagonal }
    }

    /// Grid values of a channel.
    pub fn even(&self, x: &[f64]) -> Vec<f64> {
        let n = self.diagonal.len();
        let mut y = vec![0.0; n];
        for ((first, weights), x) in self.rows.iter().zip(x) {
            weights.iter().enumerate().for_each(|(a, w)| y[first + a] += w * x);
        }
        for i in 0..n {
            for k in 1..=3.min(i) {
                y[i] -= self.lower[i][k - 1] * y[i - k];
            }
        }
        y.iter_mut().zip(&self.diagonal).for_each(|(y, d)| *y /= d);
        for i in (0..n).rev() {
            for k in 1..=3.min(n - 1 - i) {
                y[i] -= self.lower[i + k][k - 1] * y[i + k];
            }
        }
        y
    }

    /// Ratio of the standard deviation of white noise on the grid, root mean square over its
    /// points, to that of the samples. The squared weights are summed by their action on random
    /// signs (M. F. Hutchinson, Commun. Stat. Simul. Comput. 19, 1990).
    pub fn noise_gain(&self) -> f64 {
        let mut random = Random::new(1);
        let signs: Vec<f64> = self.rows.iter().map(|_| if random.chance(0.5) { 1.0 } else { -1.0 }).collect();
        root_mean_square(&self.even(&signs))
    }

    /// Values of a series on the grid at the times of the samples.
    pub fn at_samples(&self, grid: &[f64]) -> Vec<f64> {
        self.rows.iter().map(|(first, w)| (0..4).map(|a| w[a] * grid[first + a]).sum()).collect()
    }
}

/// Lagrange weights of the points 0, 1, 2, 3 at `x`.
fn lagrange(x: f64) -> [f64; 4] {
    let (a, b, c) = (x - 1.0, x - 2.0, x - 3.0);
    [-a * b * c / 6.0, x * b * c / 2.0, -x * a * c / 2.0, x * a * b / 6.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The gain of white noise, by its definition.
    #[test]
    fn noise_is_smoothed() {
        let mut random = Random::new(3);
        let times: Vec<f64> = (0..20_000).map(|k| 0.1 * (f64::from(k) + random.uniform(-0.2, 0.2))).collect();
        let evener = Resampler::new(&times, 0.0, 0.1, 20_000);
        let noise: Vec<f64> = random.vector(times.len(), 1.0);
        let seen = root_mean_square(&evener.even(&noise)) / root_mean_square(&noise);
        assert!((0.6..0.9).contains(&seen) && (evener.noise_gain() / seen - 1.0).abs() < 0.03, "{seen}");
    }

    /// A parabola is reproduced for any times; noise of two samples at nearly the same time is
    /// averaged.
    #[test]
    fn uneven_samples_of_a_parabola() {
        let times: Vec<f64> = (0..200).map(|k| 0.1 * f64::from(k) + 0.08 * (1.7 * f64::from(k)).sin()).collect();
        let f = |t: f64| 1.0 - 0.3 * t + 0.02 * t * t;
        let x: Vec<f64> = times.iter().map(|t| f(*t)).collect();
        let evener = Resampler::new(&times, 0.0, 0.1, 200);
        let even = evener.even(&x);
        for (k, y) in even.iter().enumerate() {
            assert!((y - f(0.1 * k as f64)).abs() < 1e-8, "{k}: {y}");
        }
        for (y, x) in evener.at_samples(&even).iter().zip(&x) {
            assert!((y - x).abs() < 1e-8);
        }
        let (mut near, mut noisy) = (times.clone(), x.clone());
        near[101] = near[100] + 1e-5;
        noisy[100] += 1.0;
        noisy[101] -= 1.0;
        let most = Resampler::new(&near, 0.0, 0.1, 200)
            .even(&noisy)
            .iter()
            .zip(0..)
            .fold(0.0_f64, |m, (y, k)| m.max((y - f(0.1 * f64::from(k))).abs()));
        assert!(most < 0.1, "{most}");
    }
}
