//! Gain in log-likelihood with autoregressive errors.
//!
//! The residual of a joint is mostly slow: it correlates with nothing measured, and lasts for
//! hundreds of windows in a row. Counting such a run as one window is right for a cause that is as
//! slow, and wrong for a fast one. A step of friction stands out of a slow background at once.
//! Errors are therefore modelled as an autoregression (Yule-Walker equations by Levinson's
//! recursion). The gain is that of its innovations: the part of each window that the previous
//! windows do not predict.

/// Order of the autoregression: number of windows that predict the next.
const ORDER: usize = 12;

/// White part of an error that is never predicted, relative to its root mean square. Smaller
/// deviations of a model from window to window neither confirm nor refute it.
const WHITE: f64 = 0.1;

/// Largest relative difference between a size estimated from the innovations alone and that
/// estimated from the errors.
const APART: f64 = 0.5;

/// An autoregressive model of errors.
struct Autoregression {
    coefficients: Vec<f64>,
    /// Variance of the innovations.
    variance: f64,
}

/// Autocovariances of a series at lags `0..=ORDER`, over pairs of used windows.
fn autocovariances(series: &[f64], live: &[bool]) -> Vec<f64> {
    let count = live.iter().filter(|l| **l).count().max(1) as f64;
    let at = |lag: usize| {
        let pairs = series.iter().zip(&series[lag.min(series.len())..]);
        let live = live.iter().zip(&live[lag.min(live.len())..]);
        pairs.zip(live).filter(|(_, (a, b))| **a && **b).map(|((a, b), _)| a * b).sum::<f64>() / count
    };
    (0..=ORDER).map(at).collect()
}

/// The autoregression of a series, with a white part of variance `white` added.
fn autoregression(series: &[f64], live: &[bool], white: f64) -> Autoregression {
    let mut r = autocovariances(series, live);
    r[0] += white;
    let (mut a, mut variance) = (Vec::<f64>::new(), r[0]);
    for order in 0..ORDER {
        if variance <= 1e-12 * r[0] {
            break;
        }
        let predicted: f64 = a.iter().enumerate().map(|(k, a)| a * r[order - k]).sum();
        let reflection = (r[order + 1] - predicted) / variance;
        // Gaps in a series can make its autocovariances inconsistent.
        if reflection.abs() >= 1.0 {
            break;
        }
        let turned: Vec<f64> = a.iter().rev().copied().collect();
        a.iter_mut().zip(turned).for_each(|(a, b)| *a -= reflection * b);
        a.push(reflection);
        variance *= 1.0 - reflection * reflection;
    }
    Autoregression { coefficients: a, variance }
}

impl Autoregression {
    /// Sum over windows of the product of the innovations of two series.
    fn product(&self, x: &[f64], y: &[f64], live: &[bool]) -> f64 {
        let order = self.coefficients.len();
        let innovation = |s: &[f64], w: usize| {
            s[w] - self.coefficients.iter().enumerate().map(|(k, a)| a * s[w - 1 - k]).sum::<f64>()
        };
        let whole = |w: &usize| live[w - order..=*w].iter().all(|l| *l);
        (order..x.len()).filter(whole).map(|w| innovation(x, w) * innovation(y, w)).sum()
    }
}

/// Twice the gain in log-likelihood from residuals `before` to `after` with autoregressive errors;
/// per joint, zero where windows do not count. Returns 0 where the sizes estimated from slow and
/// from fast errors disagree.
pub(in crate::diagnose) fn gain(before: &[Vec<f64>], after: &[Vec<f64>], live: &[Vec<bool>]) -> f64 {
    let (mut gain, mut with, mut own) = (0.0, 0.0, 0.0);
    for ((before, after), live) in before.iter().zip(after).zip(live) {
        let count = live.iter().filter(|l| **l).count() as f64;
        let squares: f64 = after.iter().map(|e| e * e).sum();
        if count < 20.0 * ORDER as f64 || squares <= 0.0 || before == after {
            continue;
        }
        let white = WHITE * WHITE * squares / count;
        let [without, rest] = [before, after].map(|e| autoregression(e, live, white));
        gain += count * (without.variance / rest.variance).ln();
        let taken: Vec<f64> = before.iter().zip(after).map(|(b, a)| b - a).collect();
        with += rest.product(&taken, before, live) / rest.variance;
        own += rest.product(&taken, &taken, live) / rest.variance;
    }
    let apart = (with / own.max(f64::MIN_POSITIVE) - 1.0).abs();
    if apart < APART { gain } else { 0.0 }
}

/// [`gain`] of the means of blocks of windows: for a step whose time is known to a few windows.
pub(in crate::diagnose) fn gain_in_blocks(
    before: &[Vec<f64>],
    after: &[Vec<f64>],
    live: &[Vec<bool>],
    block: usize,
) -> f64 {
    let mean = |row: &Vec<f64>| row.chunks_exact(block).map(|b| b.iter().sum::<f64>() / block as f64).collect();
    let [before, after] = [before, after].map(|rows| rows.iter().map(mean).collect::<Vec<Vec<f64>>>());
    let all = |row: &Vec<bool>| row.chunks_exact(block).map(|b| b.iter().all(|l| *l)).collect();
    gain(&before, &after, &live.iter().map(all).collect::<Vec<Vec<bool>>>())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::prng::Random;

    /// An approximately normal random number.
    fn normal(random: &mut Random) -> f64 {
        (0..12).map(|_| random.uniform(-0.5, 0.5)).sum()
    }

    /// A slow error, and a column of steps that changes sign about once a second.
    fn slow(random: &mut Random, n: usize) -> [Vec<f64>; 2] {
        let mut x = 0.0;
        let error = (0..n).map(|_| {
            x = 0.99 * x + normal(random) * 0.02;
            x + 0.02 * normal(random)
        });
        let error: Vec<f64> = error.collect();
        [error, (0..n).map(|w| if (w / 97) % 2 == 0 { 1.0 } else { -1.0 }).collect()]
    }

    #[test]
    fn steps_stand_out_of_a_slow_error() {
        let mut random = Random::new(7);
        let [after, steps] = slow(&mut random, 3000);
        let live = vec![vec![true; 3000]];
        let before: Vec<f64> = after.iter().zip(&steps).map(|(e, s)| e + 0.1 * s).collect();
        let found = gain(&[before], std::slice::from_ref(&after), &live);
        assert!(found > 200.0, "{found}");
    }

    /// A push whose begin and end were found 20 ms too early stands out in blocks of 30 ms.
    #[test]
    fn a_step_stands_out_even_if_its_time_is_not_exact() {
        let mut random = Random::new(11);
        let [slow, _] = slow(&mut random, 3000);
        let live = vec![vec![true; 3000]];
        let push = |from: usize| move |w: usize| if (from..from + 300).contains(&w) { 0.4 } else { 0.0 };
        let plus = |x: &dyn Fn(usize) -> f64| slow.iter().enumerate().map(|(w, e)| e + x(w)).collect::<Vec<f64>>();
        let (before, after) = (plus(&push(1000)), plus(&|w| push(1000)(w) - push(998)(w)));
        let [before, after] = [before, after].map(|x| [x]);
        let found = gain_in_blocks(&before, &after, &live, 3);
        assert!(found > 30.0 && gain(&before, &after, &live) < 0.5 * found, "{found} {}", gain(&before, &after, &live));
        // Without a push nothing is gained by one.
        let none = [plus(&|w| -push(998)(w))];
        assert!(gain_in_blocks(std::slice::from_ref(&slow), &none, &live, 3) <= 0.0);
    }

    #[test]
    fn chance_gains_what_an_unknown_gains() {
        let mut random = Random::new(8);
        let (mut over, runs) = (0, 100);
        for _ in 0..runs {
            let [before, steps] = slow(&mut random, 2000);
            let x = before.iter().zip(&steps).map(|(e, s)| e * s).sum::<f64>() / 2000.0;
            let after: Vec<f64> = before.iter().zip(&steps).map(|(e, s)| e - x * s).collect();
            over += usize::from(gain(&[before], &[after], &[vec![true; 2000]]) > 6.6);
        }
        // One in a hundred exceeds 6.6 by chance.
        assert!(over <= 5, "{over}");
    }

    /// `x' = 0.9 x + e`: the innovation variance is that of `e`.
    #[test]
    fn an_autoregression_leaves_its_innovations() {
        let mut random = Random::new(10);
        let mut x = 0.0;
        let series: Vec<f64> = (0..20_000)
            .map(|_| {
                x = 0.9 * x + 0.3 * normal(&mut random);
                x
            })
            .collect();
        let found = autoregression(&series, &vec![true; series.len()], 0.0);
        assert!((found.coefficients[0] - 0.9).abs() < 0.03, "{:?}", found.coefficients);
        assert!((found.variance / 0.09 - 1.0).abs() < 0.05, "{}", found.variance);
    }

    #[test]
    fn a_white_error_gains_what_windows_do() {
        let mut random = Random::new(9);
        let after: Vec<f64> = (0..2000).map(|_| normal(&mut random)).collect();
        let before: Vec<f64> = after.iter().map(|e| e + 0.35 * normal(&mut random)).collect();
        let squares = |x: &[f64]| x.iter().map(|e| e * e).sum::<f64>();
        let windows = 2000.0 * (squares(&before) / squares(&after)).ln();
        let found = gain(&[before], &[after], &[vec![true; 2000]]);
        assert!((found / windows - 1.0).abs() < 0.25, "{found} {windows}");
    }
}
