//! Noise of a joint's torque, without a model.

use super::white_noise;

/// Lowest rate, Hz, to which series are thinned: in fourth differences there, motion below 5 Hz leaves
/// nothing.
const SLOWEST: f64 = 50.0;

/// Part by which noise and that of every second sample differ at most where no more of it has a memory;
/// and where the growth is far less than the last one.
const LEVEL: f64 = 0.1;
const NEAR_LEVEL: f64 = 0.2;

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
/// friction go on growing. That level is taken, where there is one, and else the noise of all samples.
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
            growth if (1.0 - LEVEL..=1.0 + level).contains(&growth) => return coarse,
            _ => (fine, stride, grew) = (coarse, 2 * stride, growth),
        }
    }
    white
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

    #[test]
    fn a_series_is_cut_where_its_joint_turns_about() {
        let series = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        let parts = |speed: &[f64]| one_way(&series, speed).map(<[f64]>::to_vec).collect::<Vec<_>>();
        assert_eq!(parts(&[1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0]), [vec![1.0, 2.0], vec![5.0]]);
        assert_eq!(parts(&[1.0, -1.0, -1.0, 1.0, 1.0, 1.0, 1.0]), [vec![], vec![], vec![4.0, 5.0]]);
    }
}
