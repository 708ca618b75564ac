//! By how much the torque differs where a motion is repeated: an error that no model of the motion
//! takes.

use crate::numerics::sums::{squared_differences, sum};

/// Spacing of samples at which a period is looked for, s, and how many there are at most.
const COARSE: f64 = 0.05;
const MOST: usize = 3000;
/// Shortest period, s.
const SHORTEST: f64 = 1.0;
/// Mean square difference of positions, as a share of that of two unrelated instants, below which a
/// motion may be repeated, and is.
const MAYBE: f64 = 0.02;
const SURE: f64 = 2e-4;
/// Samples of which a shift is judged.
const JUDGED: usize = 2000;

/// Standard deviation of each joint's torque about its mean over repetitions, N m, and the seconds
/// that it is from; `None` where these positions (joint-major, `len` each) repeat nothing.
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
    // The start of a motion resembles itself for a while.
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

/// Series in units in which unrelated instants differ by a mean square of one.
struct Lagged(Vec<Vec<f64>>);

impl Lagged {
    /// Every `step`th sample of series of known variances.
    fn new(series: &[(&[f64], f64)], step: usize) -> Self {
        let scaled = |&(x, variance): &(&[f64], f64)| {
            let unit = (2.0 * variance).sqrt().recip();
            x.iter().step_by(step).map(|x| x * unit).collect()
        };
        Self(series.iter().map(scaled).collect())
    }

    /// Mean square difference of samples that are `lag` apart, of every `step`th of them.
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

    /// Two joints on a motion of 4.3 s, thrice, and one that never comes back.
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
