//! Estimates the noise of a joint's torque without a model, and that of a residual.

use super::rest::usual_noise;
use super::white_noise;

/// Lowest rate, Hz, to which series are thinned: there, motion below 5 Hz vanishes in fourth
/// differences.
const SLOWEST: f64 = 50.0;

/// Largest relative change of the noise between strides at which it counts as level, and the same
/// for a growth far below the previous one.
const LEVEL: f64 = 0.1;
const NEAR_LEVEL: f64 = 0.2;

/// Ratio of the noise of most samples to that of all, below which it comes in bursts (impacts in a
/// gear) and is no noise.
const BURSTS: f64 = 0.7;

/// Fewest fourth differences for an estimate of the noise.
const FEWEST: usize = 200;

/// Sufficient number of samples; of longer series only one thinned series is examined.
const ENOUGH: usize = 50_000;

/// [`white_noise`] of torques at `rate`, Hz, between the reversals of their joint. `stretches`:
/// torque and joint speed. Friction steps at a reversal, so that a joint that reverses every second
/// appears one and a half times as noisy at 30 Hz. If the joint reverses most of the time, the
/// whole series is used.
///
/// Noise correlated over some samples is smaller in their differences. In series decimated by two,
/// repeatedly, it grows up to a constant level. Errors of the motion, ripple and friction continue
/// to grow, and impacts come in bursts. That level is returned if there is one, otherwise the noise
/// of all samples.
pub fn noise_between_reversals<'a>(stretches: impl Iterator<Item = (&'a [f64], &'a [f64])> + Clone, rate: f64) -> f64 {
    let mut runs: Vec<&[f64]> = stretches.clone().flat_map(|(torque, speed)| one_way(torque, speed)).collect();
    let all = differences(stretches.clone().map(|(torque, _)| torque));
    if 2 * differences(runs.iter().copied()) <= all {
        runs = stretches.map(|(torque, _)| torque).collect();
    }
    let white = white_noise(runs.iter().copied());
    let (mut fine, mut stride, mut grew) = (white, 2, 1.0);
    while rate / stride as f64 >= SLOWEST {
        let thinned = thinned(&runs, stride);
        if differences(thinned.iter().map(Vec::as_slice)) < FEWEST {
            break;
        }
        let coarse = white_noise(thinned.iter().map(Vec::as_slice));
        let growth = coarse / fine;
        let level = if growth < (1.0 - LEVEL) * grew { NEAR_LEVEL } else { LEVEL };
        match growth {
            growth if stride == 2 && growth <= 1.0 + LEVEL => break,
            growth if (1.0 - LEVEL..=1.0 + level).contains(&growth) => {
                let usual = usual_noise(thinned.iter().map(Vec::as_slice));
                return if usual < BURSTS * coarse { white } else { coarse };
            }
            _ => (fine, stride, grew) = (coarse, 2 * stride, growth),
        }
    }
    white
}

/// Lowest rate, Hz, to which residuals are thinned: there, model errors below 1.5 Hz vanish in
/// fourth differences.
const SLOWEST_OF_RESIDUALS: f64 = 12.0;

/// Longest correlation time of noise (decay to 1 / e), s; above it an error is as slow as motion.
const LONGEST_MEMORY: f64 = 0.06;

/// Fewest strides that distinguish an autoregression from a line or a drift, largest growth from
/// one stride to the next (the root of 2 belongs to a random walk), and largest growth at the last
/// stride.
const STRIDES: usize = 4;
const RANDOM_WALK: f64 = 1.5;
const LAST_GROWTH: f64 = 1.35;

/// Allowed relative misfit of one stride: due to the noise's form, and in standard deviations due
/// to chance, one of which is the root of 1 / number of independent differences.
const OF_FORM: f64 = 0.04;
const BY_CHANCE: f64 = 2.5;

/// Standard deviation of a residual sampled every `step` seconds, from its fourth differences, and
/// its relative tolerance.
#[derive(Clone, Copy)]
struct Thinned {
    step: f64,
    noise: f64,
    tolerance: f64,
}

/// Standard deviation of the noise of a model's residual at `rate`, Hz, for a first-order
/// autoregression plus white noise. `stretches`: residual and joint speed. `None` if the residual
/// is something else: its differences over more and more samples do not grow like those of such
/// noise, or do not level off.
pub fn noise_with_memory<'a>(
    stretches: impl Iterator<Item = (&'a [f64], &'a [f64])> + Clone,
    rate: f64,
) -> Option<f64> {
    let runs: Vec<&[f64]> = stretches.flat_map(|(residual, speed)| one_way(residual, speed)).collect();
    let samples: usize = runs.iter().map(|run| run.len()).sum();
    let mut strides: Vec<Thinned> = Vec::new();
    let mut stride = 1;
    while rate / stride as f64 >= SLOWEST_OF_RESIDUALS {
        let thinned = thinned(&runs, stride);
        if differences(thinned.iter().map(Vec::as_slice)) < FEWEST {
            break;
        }
        let noise = white_noise(thinned.iter().map(Vec::as_slice));
        if usual_noise(thinned.iter().map(Vec::as_slice)) < BURSTS * noise {
            return None;
        }
        let tolerance = OF_FORM + BY_CHANCE * (stride as f64 / samples as f64).sqrt();
        strides.push(Thinned { step: stride as f64 / rate, noise, tolerance });
        stride *= 2;
    }
    let growths: Vec<f64> = strides.windows(2).map(|w| w[1].noise / w[0].noise).collect();
    if strides.len() < STRIDES || growths.iter().any(|g| *g > RANDOM_WALK) || growths.last()? > &LAST_GROWTH {
        return None;
    }
    let memories = (0..60).map(|k| LONGEST_MEMORY * 0.92_f64.powi(k));
    let (misfit, noise) = memories.map(|memory| autoregression(&strides, memory)).min_by(|a, b| a.0.total_cmp(&b.0))?;
    (misfit < 1.0).then_some(noise)
}

/// Largest misfit, relative to its tolerance, of an autoregression with correlation time `memory`,
/// s, plus white noise; and the standard deviation of their sum.
fn autoregression(strides: &[Thinned], memory: f64) -> (f64, f64) {
    // Variance of the fourth difference, 1 -4 6 -4 1, of noise of variance 1, over that of white.
    let share = |step: f64| {
        let r = (-step / memory).exp();
        (70.0 - 112.0 * r + 56.0 * r * r - 16.0 * r.powi(3) + 2.0 * r.powi(4)) / 70.0
    };
    // Least squares on the relative errors of the variances.
    let mut sums = [0.0; 5];
    for at in strides {
        let weight = at.noise.powi(-2);
        let (white, slow) = (weight / at.tolerance, weight * share(at.step) / at.tolerance);
        let one = at.tolerance.recip();
        [white * white, white * slow, slow * slow, white * one, slow * one]
            .iter()
            .zip(&mut sums)
            .for_each(|(x, sum)| *sum += x);
    }
    let [ww, ws, ss, w, s] = sums;
    let determinant = (ww * ss - ws * ws).max(f64::MIN_POSITIVE);
    let both = [(w * ss - s * ws) / determinant, (ww * s - ws * w) / determinant];
    let [white, slow] = match both {
        [white, slow] if white >= 0.0 && slow >= 0.0 => [white, slow],
        [white, _] if white < 0.0 => [0.0, s / ss],
        _ => [w / ww, 0.0],
    };
    let off = |at: &Thinned| ((white + slow * share(at.step)).sqrt() / at.noise - 1.0).abs() / at.tolerance;
    (strides.iter().map(off).fold(0.0, f64::max), (white + slow).sqrt())
}

/// Series of every `stride`-th sample, one for each starting sample.
fn thinned(runs: &[&[f64]], stride: usize) -> Vec<Vec<f64>> {
    let samples: usize = runs.iter().map(|run| run.len()).sum();
    let starts = if samples > ENOUGH * stride { 1 } else { stride };
    let from = |run: &&[f64], start: usize| run.iter().skip(start).step_by(stride).copied().collect();
    runs.iter().flat_map(|run| (0..starts).map(move |start| from(run, start))).collect()
}

/// Number of fourth differences of the series.
fn differences<'a>(series: impl Iterator<Item = &'a [f64]>) -> usize {
    series.map(|series| series.len().saturating_sub(4)).sum()
}

/// Parts of a series in which a joint moves in one direction, without the first and the last sample
/// of each: the zero crossing of a filtered speed is accurate to one sample.
fn one_way<'a>(series: &'a [f64], speed: &'a [f64]) -> impl Iterator<Item = &'a [f64]> {
    let mut first = 0;
    speed.chunk_by(|a, b| (*a < 0.0) == (*b < 0.0)).map(move |run| {
        let inner = first + 1..(first + run.len()).saturating_sub(1).max(first + 1);
        first += run.len();
        &series[inner]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::prng::Random;

    /// At 30 Hz, a joint that reverses every 1.3 s, with friction 15 times the noise; and joints
    /// without friction that reverse in nearly every sample and in every sixth.
    #[test]
    fn friction_that_turns_about_is_no_noise() {
        let std = 0.2;
        let mut random = Random::new(3);
        let mut of = |rate: f64, friction: f64| -> (Vec<f64>, Vec<f64>) {
            let sample = |k: usize| {
                let t = k as f64 / 30.0;
                let speed = (rate * t).cos();
                let torque = friction * speed.signum() + 2.0 * (0.7 * t).sin();
                (torque + std * random.even(3.0_f64.sqrt()), speed)
            };
            (0..1200).map(sample).unzip()
        };
        for (torque, speed) in [of(2.4, 3.0), of(70.0, 0.0), of(std::f64::consts::PI * 30.0 / 6.0, 0.0)] {
            let noise = noise_between_reversals([(&torque[..], &speed[..])].into_iter(), 30.0);
            assert!((noise / std - 1.0).abs() < 0.08, "{noise}");
        }
        let (torque, _) = of(2.4, 3.0);
        assert!(white_noise([&torque[..]].into_iter()) > 1.5 * std);
    }

    /// First-order autoregressions plus a motion, at two rates; and a 30 Hz line, which is no
    /// noise.
    #[test]
    fn noise_with_a_memory_is_noise() {
        let mut random = Random::new(5);
        let mut of = |rate: f64, memory: f64, line: f64| {
            let mut x = 0.0;
            let mut sample = |k: usize| {
                let t = k as f64 / rate;
                x = memory * x + (1.0 - memory * memory).sqrt() * random.even(3.0_f64.sqrt());
                let motion = 30.0 * (2.0 * t).sin() + line * (std::f64::consts::TAU * 30.0 * t).sin();
                (motion + 0.2 * x, (2.0 * t).cos())
            };
            let (torque, speed): (Vec<f64>, Vec<f64>) = (0..12_000).map(&mut sample).unzip();
            noise_between_reversals([(&torque[..], &speed[..])].into_iter(), rate) / 0.2
        };
        for (rate, memory) in [(500.0, 0.0), (500.0, 0.3), (500.0, 0.6), (1000.0, 0.7)] {
            let found = of(rate, memory, 0.0);
            assert!((found - 1.0).abs() < 0.1, "{rate} {memory} {found}");
        }
        let line = of(500.0, 0.0, 0.6);
        assert!((line - 1.0).abs() < 0.1, "{line}");
    }

    /// Residuals at three rates: an autoregression of 0.2 N m with correlation time `memory`, s,
    /// plus white noise of 0.1 and a slow error as large. With a 6 Hz line, or a random walk that
    /// exceeds both within 10 ms, they are not noise.
    #[test]
    fn what_is_forgotten_in_some_hundredths_is_noise() {
        let mut random = Random::new(9);
        let mut of = |rate: f64, memory: f64, line: f64, walk: f64| {
            let kept = (-1.0 / (rate * memory)).exp();
            let (mut x, mut w) = (0.0, 0.0);
            let mut normal = || random.even(3.0_f64.sqrt());
            let sample = |k: usize| {
                let t = k as f64 / rate;
                x = kept * x + (1.0 - kept * kept).sqrt() * normal();
                w += walk * normal() / rate.sqrt();
                let slow = 0.2 * (3.0 * t).sin() + line * (std::f64::consts::TAU * 6.0 * t).sin();
                (slow + w + 0.2 * x + 0.1 * normal(), (2.0 * t).cos())
            };
            let (residual, speed): (Vec<f64>, Vec<f64>) = (0..(40.0 * rate) as usize).map(sample).unzip();
            noise_with_memory([(&residual[..], &speed[..])].into_iter(), rate)
        };
        let truth = 0.2_f64.hypot(0.1);
        for (rate, memory) in [(1000.0, 0.028), (1000.0, 0.003), (500.0, 0.02), (125.0, 0.014), (125.0, 1e-4)] {
            let found = of(rate, memory, 0.0, 0.0).unwrap_or(0.0);
            assert!((found / truth - 1.0).abs() < 0.12, "{rate} {memory} {found}");
        }
        assert_eq!([of(500.0, 0.02, 0.5, 0.0), of(500.0, 0.001, 0.0, 20.0)], [None, None]);
        // Too few strides to decide.
        assert_eq!(of(30.0, 0.02, 0.0, 0.0), None);
    }

    /// Bursts of 25 times the noise in a tenth of the samples, like impacts.
    #[test]
    fn bursts_are_in_few_of_the_differences() {
        let mut random = Random::new(4);
        let mut sample = |k: usize| if k % 500 < 50 { 5.0 } else { 0.2 } * random.even(3.0_f64.sqrt());
        let series: Vec<f64> = (0..20_000).map(&mut sample).collect();
        let [all, usual] = [white_noise([&series[..]].into_iter()), usual_noise([&series[..]].into_iter())];
        assert!(all > 1.0 && (0.16..0.26).contains(&usual), "{all} {usual}");
    }

    #[test]
    fn a_series_is_cut_where_its_joint_turns_about() {
        let series = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        let parts = |speed: &[f64]| one_way(&series, speed).map(<[f64]>::to_vec).collect::<Vec<_>>();
        assert_eq!(parts(&[1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0]), [vec![1.0, 2.0], vec![5.0]]);
        assert_eq!(parts(&[1.0, -1.0, -1.0, 1.0, 1.0, 1.0, 1.0]), [vec![], vec![], vec![4.0, 5.0]]);
    }
}
