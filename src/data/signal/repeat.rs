//! Estimates how much the torque differs when a motion is repeated: an error that no model of the
//! motion can explain.

use crate::numerics::sums::{squared_differences, sum};

/// Sampling period for the search of a repetition, s, and the largest number of samples.
const COARSE: f64 = 0.05;
const MOST: usize = 3000;
/// Shortest period of a repetition, s.
const SHORTEST: f64 = 1.0;
/// Mean square difference of positions, relative to that of two unrelated instants: below the first
/// value the motion may be a repetition, below the second it is one.
const MAYBE: f64 = 0.02;
const SURE: f64 = 2e-4;
/// Number of samples from which a lag is judged.
const JUDGED: usize = 2000;

/// Standard deviation of each joint's torque about its mean over repetitions, N m, and the time
/// from which it is estimated, s. `None` if the positions (joint-major, `len` each) do not repeat.
pub fn repeatability(q: &[f64], tau: &[f64], len: usize, period: f64) -> Option<(Vec<f64>, f64)> {
    if len < 8 || period <= 0.0 {
        return None;
    }
    let moving: Vec<(&[f64], f64)> = q
        .chunks_exact(len)
        .filter_map(|row| {
            let mean = sum(row) / len as f64;
            let variance = row.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / len as f64;
            (variance > 1e-6).then_some((row, variance))
        })
        .collect();
    if moving.is_empty() {
        return None;
    }
    let coarse = ((COARSE / period) as usize).max(len / MOST).max(1);
    let judged = (len / JUDGED).max(1);
    let every = Lagged::new(&moving, coarse);
    // Short lags match trivially, so the search starts once the positions have moved apart.
    let mut left = false;
    let mut lag = coarse;
    while lag <= len / 2 {
        let here = every.difference(lag / coarse, 1);
        left |= here > 10.0 * MAYBE;
        if left && here < MAYBE && lag as f64 * period >= SHORTEST {
            let all = Lagged::new(&moving, 1);
            let fine = lag.saturating_sub(coarse).max(1)..=(lag + coarse).min(len / 2);
            let best = fine.map(|lag| (all.difference(lag, judged), lag)).min_by(|a, b| a.0.total_cmp(&b.0))?;
            if best.0 < SURE {
                let rms = tau.chunks_exact(len).map(|tau| {
                    let pairs = len - best.1;
                    (squared_differences(&tau[best.1..], &tau[..pairs]) / (2 * pairs) as f64).sqrt()
                });
                return Some((rms.collect(), (len - best.1) as f64 * period));
            }
        }
        lag += coarse;
    }
    None
}

/// Series scaled such that unrelated instants have a mean square difference of one.
struct Lagged(Vec<Vec<f64>>);

impl Lagged {
    /// Takes every `step`th sample of series with known variances.
    fn new(series: &[(&[f64], f64)], step: usize) -> Self {
        let scaled = |&(x, variance): &(&[f64], f64)| {
            let unit = (2.0 * variance).sqrt().recip();
            x.iter().step_by(step).map(|x| x * unit).collect()
        };
        Self(series.iter().map(scaled).collect())
    }

    /// Mean square difference of samples that are `lag` apart, over every `step`th of them.
    fn difference(&self, lag: usize, step: usize) -> f64 {
        let of = |x: &Vec<f64>| match step {
            1 => squared_differences(&x[lag..], &x[..x.len() - lag]),
            _ => x[lag..].iter().zip(x).step_by(step).map(|(later, x)| (later - x).powi(2)).sum(),
        };
        let pairs = self.0.first().map_or(0, |x| (x.len() - lag).div_ceil(step));
        self.0.iter().map(of).sum::<f64>() / (pairs * self.0.len()) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::prng::Random;

    /// Two joints on a motion of 4.3 s played three times, and a joint that never returns.
    #[test]
    fn a_motion_that_is_repeated_shows_the_noise() {
        let (period, len) = (0.004, 3400);
        let mut random = Random::new(4);
        let mut tau = Vec::new();
        let mut q = Vec::new();
        let phase = |k: usize| std::f64::consts::TAU * k as f64 * period / 4.3;
        for (f, noise) in [(1.0, 0.3), (2.0, 0.05)] {
            q.extend((0..len).map(|k| (f * phase(k)).sin() + 0.2 * (3.0 * phase(k)).cos()));
            tau.extend((0..len).map(|k| 5.0 * (f * phase(k)).cos() + noise * random.even(3.0_f64.sqrt())));
        }
        let (found, seconds) = repeatability(&q, &tau, len, period).unwrap();
        assert!((found[0] - 0.3).abs() < 0.03 && (found[1] - 0.05).abs() < 0.01, "{found:?}");
        assert!((seconds - (len as f64 * period - 4.3)).abs() < 0.02);
        let other: Vec<f64> = (0..len).map(|k| (phase(k) + 1e-5 * (k as f64).powi(2) * period).sin()).collect();
        assert_eq!(repeatability(&[&q[..len], &other].concat(), &tau, len, period), None);
        assert_eq!(repeatability(&vec![0.3; 2 * len], &tau, len, period), None);
    }
}
