//! Selects the cutoff of the low-pass of a joint's positions that minimises the expected error of
//! its acceleration.
//!
//! A low-pass of gain `H` on a position `x + n` has two errors: the noise that it passes and the
//! motion that it removes. The error is `e^2 = sum_w w^4 [ (1 - H)^2 S + H^2 N ]`, `S` the spectrum
//! of the motion, `N` that of the encoder's noise. Only `P = S + N` is observed, and `N`, where it
//! is flat, at frequencies without motion; if the encoder's steps are visible, `N` is theirs
//! ([`encoder_steps`]). So `e^2 = sum_w w^4 [ (1 - H)^2 P + (2 H - 1) N ]` is estimated without
//! bias (C. L. Mallows, *Some comments on C_p*, Technometrics 15, 1973; it is Wiener's criterion
//! with the filter restricted to Butterworth's). The cutoff is the best of a grid.
//!
//! Why each joint may have its own cutoff: to first order the torque error of joint `i` is `sum_j
//! M_ij e_j`, with `e_j` the error of joint `j`'s acceleration, and encoder errors are independent.
//! Its variance is `sum_j M_ij^2 E[e_j^2]`. Every term has its own minimum, so one choice per joint
//! is the best for all rows at once, whatever the mass matrix. Rows stay comparable if the torque's
//! band is not below that of any joint. The part of the motion that a joint's own low-pass removes
//! is then a residual orthogonal to the rest (an error of Berkson's kind). It widens standard
//! deviations without bias, while noise in a column would bias its parameter towards zero.

use std::f64::consts::PI;

use super::Filter;
use super::encoder_steps::encoder_steps;
use super::low_pass;
use crate::numerics::fft::power_spectrum;

/// Ratio of neighbouring cutoffs of the grid.
const STEP: f64 = 0.85;
/// Number of cutoffs: down to a twelfth of the highest.
const CUTOFFS: usize = 16;
/// Lowest frequency at which a flat spectrum is searched, as a share of half the rate.
const FLAT_FROM: f64 = 0.25;
/// Most bands among which the flat ones are searched, and the fewest bins of each.
const FLAT_BANDS: usize = 8;
const FLAT_BINS: usize = 24;
/// Largest ratio between a band's power and the mean of the weaker flat bands.
const FLAT: f64 = 1.5;
/// Fewest samples for a useful spectrum.
const FEWEST: usize = 64;
/// Limit of motion, in multiples of the highest cutoff.
const BEYOND: f64 = 1.5;
/// Allowance for chance, in standard deviations of a spectrum, and for noise above its flat part,
/// as a share. Power within both is no motion.
const DEVIATIONS: f64 = 3.0;
const FLATNESS: f64 = 0.25;
/// Share of the samples at each end over which the spectrum's window rises. A motion is roughest
/// where it begins and ends.
const TAPER: f64 = 0.05;
/// Fewest periods of the cutoff in the recording, since a low-pass errs at the ends.
const PERIODS: f64 = 8.0;
/// Cutoff of the smooth motion, without the encoder's steps, as a share of the highest cutoff.
const SMOOTH: f64 = 0.25;
/// Half width, in independent bins, of the average over the power of an encoder's steps.
const STEPS_BINS: f64 = 12.0;
/// Errors that differ by less than this share of the passed noise count as equal; the widest band
/// of these is taken.
const ALIKE: f64 = 0.02;

/// Best cutoff for a joint's positions, and their remaining noise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Deserved {
    /// Cutoff, Hz.
    pub cutoff: f64,
    /// Standard deviation of the recorded positions' white noise, rad.
    pub noise: f64,
    /// Standard deviations of the errors of position, velocity and acceleration behind the
    /// low-pass, rad, rad/s, rad/s^2.
    pub error: [f64; 3],
}

/// Power spectrum of positions.
struct Spectrum {
    /// Frequencies, Hz.
    frequency: Vec<f64>,
    /// Power: white noise of standard deviation `s` has `s^2` in each bin.
    power: Vec<f64>,
    /// Share of the variance in a bin.
    bin: f64,
    period: f64,
    /// Number of bins per independent bin, apart from the window's effect.
    dense: f64,
    /// Factor by which the window increases the variance of the power.
    leaks: f64,
}

/// Best cutoff not above that of `highest` for these positions (even samples, `period` apart),
/// whose noise is at least `floor`, rad. If not `free`, the cutoff is that of `highest`. `None` if
/// there are too few samples.
pub(super) fn deserved(q: &[f64], period: f64, highest: Filter, floor: f64, free: bool) -> Option<Deserved> {
    let spectrum = Spectrum::of(q, period)?;
    let flat = spectrum.flat().max(floor * floor);
    let noise = spectrum.noise(flat, steps(q, flat.sqrt(), highest, period).and_then(|e| Spectrum::of(&e, period)));
    let limit = BEYOND * highest.cutoff;
    let at = |cutoff: f64| spectrum.errors(Filter { cutoff, ..highest }, &noise, limit);
    let tries = if free { CUTOFFS } else { 1 };
    let least = PERIODS / (q.len() as f64 * period);
    let cutoffs = std::iter::successors(Some(highest.cutoff), |cutoff| Some(cutoff * STEP)).take(tries);
    let cutoffs = cutoffs.take_while(|cutoff| *cutoff >= least.min(highest.cutoff));
    let tried: Vec<(f64, Errors)> = cutoffs.filter_map(|cutoff| Some((cutoff, at(cutoff)?))).collect();
    let best = tried.iter().min_by(|a, b| a.1.all[2].total_cmp(&b.1.all[2]))?;
    let most = best.1.all[2] + ALIKE * best.1.noise[2];
    let (cutoff, errors) = tried.iter().find(|t| t.1.all[2] <= most)?;
    // The part that the widest low-pass removes is missing from torque and model alike.
    let lost = |k: usize| if *cutoff < highest.cutoff { errors.lost[k] } else { 0.0 };
    let error = std::array::from_fn(|k| (errors.noise[k] + lost(k)).sqrt());
    Some(Deserved { cutoff: *cutoff, noise: flat.sqrt(), error })
}

/// Errors of the encoder's steps, if visible, along a motion well below `highest`.
pub(super) fn steps(q: &[f64], noise: f64, highest: Filter, period: f64) -> Option<Vec<f64>> {
    encoder_steps(q, noise, SMOOTH * highest.cutoff, period)
}

/// Mean squares of the errors of position, velocity and acceleration behind a low-pass.
struct Errors {
    /// Unbiased estimate of the whole error, so that it may be negative.
    all: [f64; 3],
    /// Part of the error due to passed noise.
    noise: [f64; 3],
    /// Part of the error due to removed motion, as far as it exceeds possible noise.
    lost: [f64; 3],
}

impl Spectrum {
    /// Computes the spectrum from second differences, which are nearly white and therefore leak
    /// little, with cosine tapers (J. W. Tukey 1967).
    fn of(q: &[f64], period: f64) -> Option<Self> {
        let n = q.len().saturating_sub(2);
        if n < FEWEST {
            return None;
        }
        let taper = TAPER * n as f64;
        let window = |k: usize| {
            let inside = (k.min(n - 1 - k) as f64 + 0.5) / taper;
            if inside < 1.0 { 0.5 - 0.5 * (PI * inside).cos() } else { 1.0 }
        };
        let x: Vec<f64> = (0..n).map(|k| window(k) * (q[k + 2] - 2.0 * q[k + 1] + q[k])).collect();
        let (spectrum, padded) = power_spectrum(&x);
        let sum = |power: i32| (0..n).map(|k| window(k).powi(power)).sum::<f64>();
        let (whole, leaks) = (sum(2), n as f64 * sum(4) / sum(2).powi(2));
        let bins = 1..=padded / 2;
        let frequency: Vec<f64> = bins.clone().map(|k| k as f64 / (padded as f64 * period)).collect();
        let power =
            bins.zip(&frequency).map(|(k, f)| spectrum[k] / whole / (2.0 * (PI * f * period).sin()).powi(4)).collect();
        Some(Self { frequency, power, bin: 2.0 / padded as f64, period, dense: padded as f64 / n as f64, leaks })
    }

    /// Power of the flat part: mean of the weakest bands of similar power.
    fn flat(&self) -> f64 {
        let from = (FLAT_FROM * self.power.len() as f64) as usize;
        let high = &self.power[from..];
        let bands = ((high.len() as f64 / self.dense) as usize / FLAT_BINS).clamp(1, FLAT_BANDS);
        let mean = |x: &[f64]| x.iter().sum::<f64>() / x.len() as f64;
        let mut powers: Vec<f64> = high.chunks_exact(high.len() / bands).map(mean).collect();
        powers.sort_by(f64::total_cmp);
        let (mut sum, mut count) = (0.0, 0.0);
        for power in powers {
            if count > 0.0 && power > FLAT * sum / count {
                break;
            }
            (sum, count) = (sum + power, count + 1.0);
        }
        sum / count
    }

    /// Noise power in each bin: `flat`, or that of the encoder's steps where it is larger.
    fn noise(&self, flat: f64, steps: Option<Self>) -> Vec<f64> {
        let Some(steps) = steps else { return vec![flat; self.power.len()] };
        let half = (STEPS_BINS * self.dense).ceil() as usize;
        let mut sums = vec![0.0];
        sums.extend(steps.power.iter().scan(0.0, |sum, p| {
            *sum += p;
            Some(*sum)
        }));
        let mean = |k: usize| {
            let (from, to) = (k.saturating_sub(half), (k + half + 1).min(steps.power.len()));
            (sums[to] - sums[from]) / (to - from) as f64
        };
        (0..self.power.len()).map(|k| mean(k).max(flat)).collect()
    }

    /// Expected errors behind `filter` for noise of power `noise`, up to `limit` Hz; `None` if the
    /// filter does not fit the sampling rate.
    fn errors(&self, filter: Filter, noise: &[f64], limit: f64) -> Option<Errors> {
        let rate = self.period.recip();
        let sos = low_pass(filter.order, filter.cutoff, rate).ok()?;
        let mut errors = Errors { all: [0.0; 3], noise: [0.0; 3], lost: [0.0; 3] };
        let (mut mean, mut square) = ([0.0; 3], [0.0; 3]);
        let bins = self.frequency.iter().zip(&self.power).zip(noise);
        for ((f, power), noise) in bins.take_while(|((f, _), _)| **f <= limit) {
            let gain = sos.gain(*f, rate).powi(2);
            let taken = (1.0 - gain).powi(2);
            let w = 2.0 * PI * f * self.period;
            let order = [1.0, (w.sin() * rate).powi(2), (2.0 * (0.5 * w).sin() * rate).powi(4)];
            for (k, order) in order.into_iter().enumerate() {
                let of = self.bin * order;
                errors.all[k] += of * (taken * power + (2.0 * gain - 1.0) * noise);
                errors.noise[k] += of * gain * gain * noise;
                errors.lost[k] += of * taken * (power - noise);
                mean[k] += of * taken * noise;
                square[k] += (of * taken * noise).powi(2);
            }
        }
        for k in 0..3 {
            let chance = DEVIATIONS * (self.dense * self.leaks * square[k]).sqrt() + FLATNESS * mean[k];
            errors.lost[k] = (errors.lost[k] - chance).max(0.0);
        }
        Some(errors)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{central_second, low_pass};
    use super::*;
    use std::f64::consts::TAU;

    use crate::numerics::prng::Random;

    const HIGHEST: Filter = Filter { order: 4, cutoff: 15.0 };

    /// Positions (with encoder steps of `step`) and true acceleration of a joint on a motion of
    /// some frequencies.
    fn motion(rate: f64, step: f64, seed: u64) -> (Vec<f64>, Vec<f64>) {
        let mut random = Random::new(seed);
        let parts: Vec<[f64; 3]> = (1..=5)
            .map(|k| {
                [0.23 * (f64::from(k) + random.uniform(-0.3, 0.3)), random.uniform(-0.4, 0.4), random.uniform(0.0, TAU)]
            })
            .collect();
        let n = (20.0 * rate) as usize;
        let sum = |k: usize, of: fn(f64, f64) -> f64| -> f64 {
            let t = k as f64 / rate;
            parts.iter().map(|[f, a, phase]| a * of(TAU * f, TAU * f * t + phase)).sum()
        };
        let read = |q: f64| if step > 0.0 { (q / step).round() * step } else { q };
        let q = (0..n).map(|k| read(sum(k, |_, p| p.sin()))).collect();
        (q, (0..n).map(|k| sum(k, |w, p| -w * w * p.sin())).collect())
    }

    fn behind(q: &[f64], rate: f64, cutoff: f64) -> Vec<f64> {
        let mut q = q.to_vec();
        low_pass(HIGHEST.order, cutoff, rate).unwrap().forward_backward(&mut q, (rate / cutoff) as usize);
        central_second(&q, rate.recip())
    }

    /// For any encoder and rate, the acceleration behind the chosen low-pass is nearly as good as
    /// behind the best, and its error is as estimated.
    #[test]
    fn the_band_is_nearly_the_best() {
        for (rate, step) in [(30.0, 1e-3), (100.0, 1e-3), (100.0, 1e-5), (250.0, 3e-4), (500.0, 1e-3), (1000.0, 2e-5)] {
            for seed in 1..4 {
                let (q, truth) = motion(rate, step, seed);
                let highest = Filter { cutoff: HIGHEST.cutoff.min(0.4 * rate), ..HIGHEST };
                let found = deserved(&q, rate.recip(), highest, 0.0, true).unwrap();
                let error = |cutoff: f64| {
                    let a = behind(&q, rate, cutoff);
                    let edge = rate as usize;
                    let squares: f64 = (edge..q.len() - edge).map(|k| (a[k] - truth[k]).powi(2)).sum();
                    (squares / (q.len() - 2 * edge) as f64).sqrt()
                };
                let best =
                    (0..CUTOFFS).map(|k| error(highest.cutoff * STEP.powi(k as i32))).fold(f64::INFINITY, f64::min);
                let own = error(found.cutoff);
                // Where the error is small, its minimum is hard to find and unimportant.
                let motion = (truth.iter().map(|a| a * a).sum::<f64>() / truth.len() as f64).sqrt();
                assert!(own < (1.6 * best).max(0.02 * motion), "{rate} {step}: {own} at {}, {best}", found.cutoff);
                assert!(
                    (0.5..2.0).contains(&(found.error[2] / own)),
                    "{rate} Hz, {step}: {own}, said {}",
                    found.error[2]
                );
                assert!(
                    (0.6..1.5).contains(&(found.noise / (step / 12.0_f64.sqrt()))),
                    "{rate} {step} {}",
                    found.noise
                );
            }
        }
    }

    /// Motion that fills the band keeps it; a cutoff given by the user is kept as well.
    #[test]
    fn the_band_is_not_narrowed_without_need() {
        let (q, _) = motion(500.0, 0.0, 3);
        assert_eq!(deserved(&q, 2e-3, HIGHEST, 0.0, true).unwrap().cutoff, 15.0);
        let (q, _) = motion(100.0, 1e-3, 3);
        assert!(deserved(&q, 1e-2, HIGHEST, 0.0, true).unwrap().cutoff < 8.0);
        assert_eq!(deserved(&q, 1e-2, HIGHEST, 0.0, false).unwrap().cutoff, 15.0);
        assert_eq!(deserved(&q[..40], 1e-2, HIGHEST, 0.0, true), None);
    }
}
