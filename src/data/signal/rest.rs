//! Detects rest: samples at which the sign of a joint's velocity does not determine its dry
//! friction.
//!
//! A joint at rest is held by friction of any value within its breakaway level, and the sign of its
//! recorded velocity is encoder noise. The definition of rest follows from the log. Rest is a speed
//! within three standard deviations of its noise behind the low-pass, and any faster stretch that
//! does not carry the joint beyond its position noise.

use crate::numerics::sums::sum;

/// Definition of rest.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum DeadZone {
    /// Three standard deviations of the speed's noise. If that is much of the joint's motion, the
    /// noise is taken from differences of neighbouring samples, which contain no motion.
    #[default]
    FromNoise,
    /// A fixed speed, rad/s or m/s.
    Fixed(f64),
    /// No sample counts as rest.
    Off,
}

/// Limit of rest in standard deviations of the speed's noise.
const DEVIATIONS: f64 = 3.0;
/// Share of a joint's largest speed below which a speed may be noise, if the low-pass removes more
/// than noise from the positions.
const SHARE: f64 = 0.02;
/// Least travel of a stretch of motion, in standard deviations of the position's noise.
const TRAVEL: f64 = 4.0;
/// Rounding error of the low-pass as a speed, rad/s or m/s: one turn takes 20 years.
const ROUNDING: f64 = 1e-8;

/// Noise of one joint, as standard deviations.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Noise {
    /// Error of the filtered speed, from what the low-pass removed from the positions (noise, and
    /// motion beyond the cutoff), rad/s.
    pub speed: f64,
    /// Error of the filtered speed, from differences of neighbouring samples, rad/s.
    pub white: f64,
    /// Error of the recorded positions, rad; 0 if speeds are not derived from them.
    pub position: f64,
}

/// Whether the joint is at rest, for each sample.
pub(super) fn rests(dq: &[f64], noise: Noise, period: f64, zone: DeadZone) -> Vec<bool> {
    let zone = match zone {
        DeadZone::Off => return vec![false; dq.len()],
        DeadZone::Fixed(speed) => return dq.iter().map(|v| v.abs() <= speed).collect(),
        DeadZone::FromNoise => {
            let largest = dq.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            let least = (SHARE * largest).max(DEVIATIONS * noise.white);
            (DEVIATIONS * noise.speed).min(least).max(ROUNDING)
        }
    };
    let mut rest: Vec<bool> = dq.iter().map(|v| v.abs() <= zone).collect();
    let mut k = 0;
    while k < dq.len() {
        let end = (k..dq.len()).find(|&i| rest[i] != rest[k]).unwrap_or(dq.len());
        let inner = k > 0 && end < dq.len();
        if !rest[k] && inner && (dq[k..end].iter().sum::<f64>() * period).abs() < TRAVEL * noise.position {
            rest[k..end].fill(true);
        }
        k = end;
    }
    rest
}

/// Standard deviation of the white noise of series, without a model: from fourth differences, in
/// which motion below a tenth of the sampling rate vanishes. Noise that was low-passed before
/// recording is not detected; see [`super::noise_between_reversals`]. 0 for series of fewer than
/// five samples.
pub fn white_noise<'a>(series: impl Iterator<Item = &'a [f64]>) -> f64 {
    // Steps (friction, contact) are rare and large: the largest hundredth is left out, and its
    // share under a Gaussian distribution is corrected for.
    noise_of_least(series, 100, 0.9245)
}

/// The same from the smallest four fifths of the differences, which contain few bursts such as
/// impacts in a gear.
pub(super) fn usual_noise<'a>(series: impl Iterator<Item = &'a [f64]>) -> f64 {
    noise_of_least(series, 5, 0.4377)
}

/// Standard deviation of white noise from fourth differences, without the largest one in `one_of`.
/// `mean`: mean square of the remaining ones for a Gaussian distribution of unit variance.
fn noise_of_least<'a>(series: impl Iterator<Item = &'a [f64]>, one_of: usize, mean: f64) -> f64 {
    // The variance of a fourth difference of white noise is 70 times its own (1 + 16 + 36 + 16 +
    // 1).
    let square = |w: &[f64]| (w[0] - 4.0 * w[1] + 6.0 * w[2] - 4.0 * w[3] + w[4]).powi(2);
    let squares: Vec<f64> = series.flat_map(|x| x.windows(5).map(square)).collect();
    let kept = squares.len() - squares.len() / one_of;
    (sum_of_least(squares, kept) / (70 * kept.max(1)) as f64 / mean).sqrt()
}

/// Stride of the values sampled to estimate a threshold, and the inverse of the share of these that
/// counts as large.
const LOOKED_AT: usize = 64;
const LARGE: usize = 32;

/// Sum of the `count` smallest values. Only values near the threshold are sorted.
fn sum_of_least(mut values: Vec<f64>, count: usize) -> f64 {
    let mut few: Vec<f64> = values.iter().step_by(LOOKED_AT).copied().collect();
    let place = few.len() - few.len() / LARGE;
    if count >= values.len() || place >= few.len() {
        if count < values.len() {
            values.select_nth_unstable_by(count, f64::total_cmp);
        }
        return sum(&values[..count.min(values.len())]);
    }
    let limit = *few.select_nth_unstable_by(place, f64::total_cmp).1;
    let mut large: Vec<f64> = values.iter().copied().filter(|x| *x > limit).collect();
    let others = values.len() - count;
    if large.len() <= others {
        values.select_nth_unstable_by(count, f64::total_cmp);
        return sum(&values[..count]);
    }
    let of_large = large.len() - others;
    large.select_nth_unstable_by(of_large, f64::total_cmp);
    values.iter_mut().for_each(|x| *x = if *x > limit { 0.0 } else { *x });
    sum(&values) + sum(&large[..of_large])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::prng::Random;

    const PERIOD: f64 = 0.01;

    /// Speed of positions behind the default low-pass, and its noise.
    fn seen(q: &[f64]) -> (Vec<f64>, Noise) {
        let mut y = q.to_vec();
        super::super::low_pass(5, 10.0, PERIOD.recip()).unwrap().forward_backward(&mut y, 100);
        let white = white_noise([q].into_iter());
        let of = |s: f64| std::f64::consts::TAU * s * (2.0 * 1e3 * PERIOD / 3.0).sqrt();
        let out = (q.iter().zip(&y).map(|(a, b)| (a - b).powi(2)).sum::<f64>() / q.len() as f64).sqrt();
        (super::super::central(&y, PERIOD), Noise { speed: of(out), white: of(white), position: white })
    }

    #[test]
    fn the_least_are_summed_whatever_their_order() {
        let mut random = Random::new(8);
        for n in [0, 1, 63, 3000, 20_000] {
            let plain: Vec<f64> = (0..n).map(|_| random.uniform(0.0, 1.0).powi(8)).collect();
            // Few large values, many, none among the sampled ones, and all values equal.
            let few = (0..n).map(|k| if k % 64 == 1 { 1e3 } else { plain[k] }).collect();
            let rising = (0..n).map(|k| k as f64).collect();
            for values in [plain.clone(), few, rising, vec![0.5; n]] {
                for count in [n, n - n / 100, n / 2] {
                    let mut sorted = values.clone();
                    sorted.sort_by(f64::total_cmp);
                    let (found, all) = (sum_of_least(values.clone(), count), sum(&sorted[..count]));
                    assert!((found - all).abs() <= 1e-12 * all, "{n} {count}: {found} {all}");
                }
            }
        }
    }

    /// A joint that stands, moves and stands again: at any noise level it rests where it stands,
    /// and elsewhere only where it reverses.
    #[test]
    fn noise_is_no_motion() {
        for (seed, std) in [(1, 1e-5), (2, 2e-5), (3, 3e-4)] {
            let mut random = Random::new(seed);
            let q: Vec<f64> = (0..3000)
                .map(|k| {
                    let t = f64::from(k) * PERIOD;
                    0.3 * (1.0 - (t.clamp(10.0, 20.0) * std::f64::consts::PI / 2.5).cos())
                        + std * random.even(3.0_f64.sqrt())
                })
                .collect();
            let (dq, noise) = seen(&q);
            let rest = rests(&dq, noise, PERIOD, DeadZone::FromNoise);
            let stands = |k: usize| !(950..2050).contains(&k);
            let wrong = (0..3000).filter(|&k| stands(k) && !rest[k]).count();
            assert!(wrong < 10, "{std}: {wrong} of 1900 samples at rest are said to move");
            let moving = (1050..1950).filter(|&k| dq[k].abs() > 0.05 && rest[k]).count();
            assert_eq!(moving, 0, "{std}");
            // Noise alone is rest throughout.
            let still: Vec<f64> = (0..1000).map(|_| 0.7 + std * random.even(3.0_f64.sqrt())).collect();
            let (dq, noise) = seen(&still);
            let rest = rests(&dq, noise, PERIOD, DeadZone::FromNoise);
            assert!(rest[20..980].iter().filter(|r| !**r).count() < 8, "{std}");
        }
    }

    /// An encoder without noise: the rounding error of the low-pass has a sign, but is no motion.
    #[test]
    fn rounding_is_no_motion() {
        let (dq, noise) = seen(&[1.234_567; 500]);
        assert!(rests(&dq, noise, PERIOD, DeadZone::FromNoise).iter().all(|r| *r));
        assert!(rests(&dq, noise, PERIOD, DeadZone::Off).iter().all(|r| !*r));
    }

    #[test]
    fn steps_and_motion_are_no_noise() {
        let mut random = Random::new(5);
        let x: Vec<f64> = (0..2000)
            .map(|k| {
                let step = f64::from(u8::from((700..1400).contains(&k)));
                20.0 * step + 5.0 * (0.05 * f64::from(k)).sin() + 0.1 * random.even(3.0_f64.sqrt())
            })
            .collect();
        assert!((white_noise([&x[..]].into_iter()) - 0.1).abs() < 0.01);
        assert_eq!(white_noise([&x[..3]].into_iter()), 0.0);
    }

    /// A given speed is the limit in both directions.
    #[test]
    fn a_fixed_zone_ends_where_it_says() {
        let rest = rests(&[0.0, 0.09, -0.09, 0.11, -0.11, 0.19], Noise::default(), PERIOD, DeadZone::Fixed(0.1));
        assert_eq!(rest, [true, true, true, false, false, false]);
    }

    /// The part removed by the low-pass counts as noise up to a fiftieth of the largest speed;
    /// above, only the noise of neighbouring samples counts.
    #[test]
    fn motion_beyond_the_cutoff_is_not_all_noise() {
        let dq = [1.0, 0.015, 0.025, 0.05, 0.07];
        let of = |white: f64| {
            let noise = Noise { speed: 0.5, white, position: 0.0 };
            rests(&dq, noise, PERIOD, DeadZone::FromNoise)
        };
        assert_eq!(of(0.0), [false, true, false, false, false]);
        assert_eq!(of(0.02), [false, true, true, true, false]);
        let quiet = Noise { speed: 0.004, white: 0.02, position: 0.0 };
        assert_eq!(rests(&dq, quiet, PERIOD, DeadZone::FromNoise), [false; 5]);
    }
}
