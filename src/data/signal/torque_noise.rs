//! Noise of a joint's torque, without a model.

use super::white_noise;

/// [`white_noise`] of torques, between the reversals of their joint: stretches of torque and of the
/// joint's speed. Friction steps where it turns about, so that a joint that reverses every second looks
/// half as noisy again at 30 Hz. Where the joint reverses most of the time, all of it is used.
pub fn noise_between_reversals<'a>(stretches: impl Iterator<Item = (&'a [f64], &'a [f64])> + Clone) -> f64 {
    let runs: Vec<&[f64]> = stretches.clone().flat_map(|(torque, speed)| one_way(torque, speed)).collect();
    let all = differences(stretches.clone().map(|(torque, _)| torque));
    if 2 * differences(runs.iter().copied()) > all {
        white_noise(runs.into_iter())
    } else {
        white_noise(stretches.map(|(torque, _)| torque))
    }
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
            let noise = noise_between_reversals([(&torque[..], &speed[..])].into_iter());
            assert!((noise / std - 1.0).abs() < 0.08, "{noise}");
        }
        let (torque, _) = of(2.4, 3.0);
        assert!(white_noise([&torque[..]].into_iter()) > 1.5 * std);
    }

    #[test]
    fn a_series_is_cut_where_its_joint_turns_about() {
        let series = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        let parts = |speed: &[f64]| one_way(&series, speed).map(<[f64]>::to_vec).collect::<Vec<_>>();
        assert_eq!(parts(&[1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0]), [vec![1.0, 2.0], vec![5.0]]);
        assert_eq!(parts(&[1.0, -1.0, -1.0, 1.0, 1.0, 1.0, 1.0]), [vec![], vec![], vec![4.0, 5.0]]);
    }
}
