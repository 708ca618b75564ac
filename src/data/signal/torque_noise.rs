//! Noise of a joint's torque, without a model.

use super::rest::usual_noise;
use super::white_noise;

/// Lowest rate, Hz, to which series are thinned: in fourth differences there, motion below 5 Hz leaves
/// nothing.
const SLOWEST: f64 = 50.0;

/// Part by which noise and that of every second sample differ at most where no more of it has a memory;
/// and where the growth is far less than the last one.
const LEVEL: f64 = 0.1;
const NEAR_LEVEL: f64 = 0.2;

/// Noise of most samples by that of all, below which it comes in bursts: impacts in a gear, not noise.
const BURSTS: f64 = 0.7;

/// Fewest fourth differences that tell how large noise is.
const FEWEST: usize = 200;

/// As many samples tell enough: of longer series only one of the thinned ones is looked at.
const ENOUGH: usize = 50_000;

/// [`white_noise`] of torques at `rate`, Hz, between the reversals of their joint: stretches of torque
/// and of the joint's speed. Friction steps where it turns about, so that a joint that reverses every
/// second looks half as noisy again at 30 Hz. Where the joint reverses most of the time, all of it is used.
///
/// Noise with a memory of some samples has less in their differences. Of series that are thinned to a
/// half, again and again, it shows more, up to a level that stays; errors of the motion, ripple and
/// friction go on growing, and impacts come in bursts. That level is taken, where there is one, and else the
/// noise of all samples.
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

/// Lowest rate, Hz, to which residuals are thinned: in fourth differences there, what a model lacks below
/// 1.5 Hz leaves nothing.
const SLOWEST_OF_RESIDUALS: f64 = 12.0;

/// Longest time in which noise is forgotten to 1 / e, s: what lasts longer is as slow as motion.
const LONGEST_MEMORY: f64 = 0.06;

/// Fewest strides that tell an autoregression from a line or a drift, largest growth from one to the next
/// (the root of 2 belongs to a random walk), and the same of the last one.
const STRIDES: usize = 4;
const RANDOM_WALK: f64 = 1.5;
const LAST_GROWTH: f64 = 1.35;

/// Relative misfit of one stride that is allowed: of the form of the noise, and so many times the
/// root of one by the number of independent differences, their standard deviation.
const OF_FORM: f64 = 0.04;
const BY_CHANCE: f64 = 2.5;

/// Standard deviation of a residual of which every so many seconds a sample is looked at, by its fourth
/// differences, and its relative tolerance.
#[derive(Clone, Copy)]
struct Thinned {
    step: f64,
    noise: f64,
    tolerance: f64,
}

/// Standard deviation of the noise of a model's residual at `rate`, Hz, that is white in a part and
/// forgotten exponentially in another: a first-order autoregression beside white noise. `stretches`: of
/// residual and speed of the joint. `None` where the residual is something else: its differences over more
/// and more samples do not grow like those of such noise, or not up to a level.
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

/// Largest misfit, by its tolerance, of an autoregression of this memory, s, beside white noise;
/// and the standard deviation of both together.
fn autoregression(strides: &[Thinned], memory: f64) -> (f64, f64) {
    // Variance of the fourth difference, 1 -4 6 -4 1, of noise of variance 1, by that of white noise.
    let share = |step: f64| {
        let r = (-step / memory).exp();
        (70.0 - 112.0 * r + 56.0 * r * r - 16.0 * r.powi(3) + 2.0 * r.powi(4)) / 70.0
    };
    // Least squares of the relative errors of the variances.
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

/// Series of every `stride`-th sample, from each of the first ones.
fn thinned(runs: &[&[f64]], stride: usize) -> Vec<Vec<f64>> {
    let samples: usize = runs.iter().map(|run| run.len()).sum();
    let starts = if samples > ENOUGH * stride { 1 } else { stride };
    let from = |run: &&[f64], start: usize| run.iter().skip(start).step_by(stride).copied().collect();
    runs.iter().flat_map(|run| (0..starts).map(move |start| from(run, start))).collect()
}

/// How many fourth differences series have.
fn differences<'a>(series: impl Iterator<Item = &'a [f64]>) -> usize {
    series.map(|series| series.len().saturating_sub(4)).sum()
}

/// Parts of a series in which a joint moves one way, the first and the last sample of each left out:
/// where a filtered speed changes its sign is known to a sample.
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

    /// At 30 Hz, a joint that reverses every 1.3 s, with friction that is 15 times the noise; and
    /// joints without friction that reverse in nearly every sample and in every sixth.
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

    /// First-order autoregressions beside a motion, at two rates; and a line at 30 Hz, which is no noise.
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

    /// Residuals at three rates: an autoregression of 0.2 N m that is forgotten in `memory` s
    /// beside white noise of 0.1, and a slow error as large. With a line at 6 Hz, or a random walk
    /// that is larger than both within 10 ms, they are something else.
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
        // Too few rates to tell.
        assert_eq!(of(30.0, 0.02, 0.0, 0.0), None);
    }

    /// Bursts of 25 times the noise in a tenth of the samples, as of impacts.
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
