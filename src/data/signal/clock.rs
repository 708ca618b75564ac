//! Estimates when rows were really sampled from a timing error common to the positions of all
//! joints.
//!
//! A recorder that stamps the newest message itself errs by up to the age of the message. Every
//! joint then shows `q_j(t_k + d_k) = q_j(t_k) + dq_j d_k`: an error along its own velocity, with
//! one `d_k` for all. Encoder errors are not common to the joints, and nothing mechanical moves a
//! whole arm to and fro along its path at a quarter of the sampling rate and above. The clock is
//! therefore tested in that band: `d_k` by least squares over the joints, each weighted by its
//! residual. It is corrected only if `d_k` explains several times the variance that any common
//! unknown would explain. The band is then extended downwards as long as only noise is left; where
//! motion begins, joints differ.
//!
//! Synchronised joints, as in a coordinated move from one pose to another, move along one line: `q
//! = q_0 + s(t) c`. A timing error is then indistinguishable from a motion along the line, and
//! stamps are not changed.

use nalgebra::DMatrix;

use super::central;
use super::even::Resampler;
use super::low_pass;

/// Required ratio between the mean square explained by the timing error and that explained by any
/// unknown common to all joints.
const EVIDENCE: f64 = 5.0;
/// Timing errors below this share of a period are not corrected.
const LEAST: f64 = 0.01;
/// Gauss-Newton steps for each band.
const STEPS: usize = 4;
/// Largest growth of the residual's spectral density above that of the highest band; beyond it the
/// residual is taken for motion.
const NOISE: f64 = 2.0;
/// Largest growth of the mean square shift above that of the highest band. The motion of
/// synchronised joints also looks like a shift in time, and a large one.
const SPREAD: f64 = 6.0;
/// Least share of the velocities' mean square that must lie off their main direction, each joint in
/// units of its noise.
const OFF_LINE: f64 = 0.1;
/// Cutoffs, as shares of the sampling rate, above which the clock is examined.
const BANDS: [f64; 6] = [0.25, 0.18, 0.13, 0.09, 0.065, 0.045];
/// Order of the low-pass that removes the motion.
const ORDER: usize = 4;
/// Fewest rows from which a clock is judged.
const FEWEST: usize = 128;
/// Speeds below this share of the fastest joint's do not count as motion.
const MOVES: f64 = 1e-3;
/// Shortest step of a corrected clock, in periods: rows keep their order.
const ORDERED: f64 = 0.02;

/// Corrected times of rows.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Times {
    /// Time of each row, s.
    pub at: Vec<f64>,
    /// Root mean square of the correction, s.
    pub rms: f64,
    /// Standard deviation of the remaining error of the times, s.
    pub left: f64,
    /// Standard deviation of the remaining white noise of each joint's positions, rad.
    pub noise: Vec<f64>,
}

/// Residual positions above a cutoff, and velocities below it (the effect of a shift in time), per
/// joint and row.
struct Above {
    residual: Vec<Vec<f64>>,
    velocity: Vec<Vec<f64>>,
}

/// Estimated shift of each row, and its statistics.
struct Shift {
    by: Vec<f64>,
    /// Variance of the shift's error due to noise, mean over rows, s^2.
    open: f64,
    /// Remaining variance of each joint, corrected for the estimated shift, rad^2.
    left: Vec<f64>,
    /// Mean square explained by the shift, in units of the residual per unknown.
    evidence: f64,
}

/// Corrected times of rows, from stamps or the count of rows, positions by joint, and the usual
/// spacing, s; `None` if no correction is justified.
pub(super) fn times(stamps: &[f64], q: &[&[f64]], period: f64) -> Option<Times> {
    if stamps.len() < FEWEST || q.len() < 2 {
        return None;
    }
    let mut at = stamps.to_vec();
    let start = above(&at, q, period, BANDS[0])?;
    let first = shift(&start)?;
    if off_line(&start.velocity, &first.left) < OFF_LINE {
        return None;
    }
    let square = first.by.iter().map(|d| d * d).sum::<f64>() / first.by.len() as f64;
    if first.evidence < EVIDENCE || square.sqrt() < LEAST * period {
        return None;
    }
    let mut size = None;
    let (mut kept, mut noise, mut open, mut highest) = (at.clone(), Vec::new(), 0.0, None);
    for band in BANDS {
        let (mut left, mut spread) = (Vec::new(), 0.0);
        for _ in 0..STEPS {
            let found = shift(&above(&at, q, period, band)?)?;
            move_rows(&mut at, &found.by, period);
            (left, spread) = (found.left, found.open);
        }
        let density: Vec<f64> = left.iter().map(|v| v / (1.0 - 2.0 * band)).collect();
        let reference = highest.get_or_insert_with(|| density.clone());
        let growth = |(d, r): (&f64, &f64)| if *r > 0.0 { d / r } else { 1.0 };
        let grown = density.iter().zip(reference.iter()).map(growth).sum::<f64>() / density.len() as f64;
        let squares = at.iter().zip(stamps).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
        let least = *size.get_or_insert(squares);
        if grown > NOISE || squares > SPREAD * least {
            break;
        }
        (kept, noise, open) = (at.clone(), density.iter().map(|d| d.sqrt()).collect(), spread);
    }
    let squares: f64 = kept.iter().zip(stamps).map(|(a, b)| (a - b) * (a - b)).sum();
    let rms = (squares / stamps.len() as f64).sqrt();
    (rms > LEAST * period).then_some(Times { at: kept, rms, left: open.sqrt(), noise })
}

/// Part of the positions above a cutoff of `band` times the sampling rate.
fn above(at: &[f64], q: &[&[f64]], period: f64, band: f64) -> Option<Above> {
    let (start, end) = (*at.first()?, *at.last()?);
    let count = ((end - start) / period).ceil() as usize + 4;
    let evener = Resampler::new(at, start - period, period, count);
    let sos = low_pass(ORDER, band / period, period.recip()).ok()?;
    let pad = (2.0 / band).ceil() as usize;
    let mut above = Above { residual: Vec::new(), velocity: Vec::new() };
    for q in q {
        let mut smooth = evener.even(q);
        sos.forward_backward(&mut smooth, pad);
        let velocity = evener.at_samples(&central(&smooth, period));
        let there = evener.at_samples(&smooth);
        above.residual.push(q.iter().zip(&there).map(|(q, s)| q - s).collect());
        above.velocity.push(velocity);
    }
    Some(above)
}

/// Shift of each row that best explains the residuals of all moving joints.
fn shift(above: &Above) -> Option<Shift> {
    let square = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>() / x.len().max(1) as f64;
    let speeds: Vec<f64> = above.velocity.iter().map(|v| square(v)).collect();
    let fastest = speeds.iter().fold(0.0_f64, |m, v| m.max(*v));
    let moves: Vec<usize> = (0..speeds.len()).filter(|&j| speeds[j] > MOVES * MOVES * fastest).collect();
    let n = above.residual.first()?.len();
    let total: Vec<f64> = above.residual.iter().map(|r| square(r)).collect();
    if moves.len() < 2 || moves.iter().any(|&j| total[j] <= 0.0) {
        return None;
    }
    let mut weights: Vec<f64> = total.iter().map(|v| v.recip()).collect();
    let (mut by, mut left, mut taken) = (vec![0.0; n], total.clone(), 0.0);
    for _ in 0..6 {
        let (mut leverage, mut rest) = (vec![0.0; total.len()], vec![0.0; total.len()]);
        taken = 0.0;
        for k in 0..n {
            let sum = |of: &dyn Fn(usize) -> f64| moves.iter().map(|&j| weights[j] * of(j)).sum::<f64>();
            let curvature = sum(&|j| above.velocity[j][k].powi(2));
            let pull = sum(&|j| above.velocity[j][k] * above.residual[j][k]);
            by[k] = if curvature > 0.0 { pull / curvature } else { 0.0 };
            taken += pull * by[k];
            for &j in &moves {
                let v = above.velocity[j][k];
                rest[j] += (above.residual[j][k] - v * by[k]).powi(2);
                leverage[j] += if curvature > 0.0 { weights[j] * v * v / curvature } else { 0.0 };
            }
        }
        for &j in &moves {
            left[j] = rest[j] / (n as f64 - leverage[j]).max(0.05 * n as f64);
            weights[j] = left[j].max(1e-6 * total[j]).recip();
        }
    }
    let evidence = taken / n as f64;
    // Without motion a row has no information: its shift is shrunk towards zero.
    let spread = usual(&by, &above.velocity, &weights, &moves);
    let mut open = 0.0;
    for (k, d) in by.iter_mut().enumerate() {
        let information: f64 = moves.iter().map(|&j| weights[j] * above.velocity[j][k].powi(2)).sum();
        *d *= information / (information + spread.recip());
        open += (information + spread.recip()).recip() / n as f64;
    }
    Some(Shift { by, left, open, evidence })
}

/// Variance of the shifts, s^2, without the contribution of noise: by the method of moments, with
/// rows weighted by their information.
fn usual(by: &[f64], velocity: &[Vec<f64>], weights: &[f64], moves: &[usize]) -> f64 {
    let (mut squares, mut noise, mut all) = (0.0, 0.0, 0.0);
    for (k, d) in by.iter().enumerate() {
        let information: f64 = moves.iter().map(|&j| weights[j] * velocity[j][k].powi(2)).sum();
        squares += information * information * d * d;
        noise += information;
        all += information * information;
    }
    ((squares - noise) / all.max(f64::MIN_POSITIVE)).max(f64::MIN_POSITIVE.sqrt())
}

/// Share of the velocities' mean square that lies off their main direction; `left`: noise variance
/// of each joint.
fn off_line(velocity: &[Vec<f64>], left: &[f64]) -> f64 {
    let weighed: Vec<(&[f64], f64)> =
        velocity.iter().zip(left).filter(|(_, s)| **s > 0.0).map(|(v, s)| (v.as_slice(), s.sqrt())).collect();
    let product = |i: usize, j: usize| {
        let ((a, s), (b, t)) = (weighed[i], weighed[j]);
        a.iter().zip(b).map(|(a, b)| (a / s) * (b / t)).sum::<f64>()
    };
    let gram = DMatrix::from_fn(weighed.len(), weighed.len(), product);
    let all = gram.trace();
    if all > 0.0 { 1.0 - gram.symmetric_eigenvalues().max() / all } else { 0.0 }
}

/// Shifts the rows, keeping their order.
fn move_rows(at: &mut [f64], by: &[f64], period: f64) {
    let mut before = f64::NEG_INFINITY;
    for (t, by) in at.iter_mut().zip(by) {
        *t = (*t + by.clamp(-period, period)).max(before + ORDERED * period);
        before = *t;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::prng::Random;

    const PERIOD: f64 = 0.02;

    /// Positions of three joints at these times, with noise.
    fn positions(at: &[f64], noise: f64) -> Vec<Vec<f64>> {
        let mut random = Random::new(3);
        (0..3_u32)
            .map(|j| {
                let (f, phase) = (0.4 + 0.23 * f64::from(j), f64::from(j));
                at.iter()
                    .map(|t| {
                        let w = std::f64::consts::TAU * f;
                        (w * t + phase).sin() + 0.3 * (2.7 * w * t).cos() + noise * random.even(3.0_f64.sqrt())
                    })
                    .collect()
            })
            .collect()
    }

    fn found(true_times: &[f64], stamps: &[f64], noise: f64) -> Option<Times> {
        let q = positions(true_times, noise);
        let q: Vec<&[f64]> = q.iter().map(Vec::as_slice).collect();
        times(stamps, &q, PERIOD)
    }

    /// A recorder whose even stamps are up to half a period before or after the sampling.
    #[test]
    fn a_clock_that_errs_is_found() {
        let mut random = Random::new(7);
        let stamps: Vec<f64> = (0..1500).map(|k| f64::from(k) * PERIOD).collect();
        let truth: Vec<f64> = stamps.iter().map(|t| t + PERIOD * random.uniform(-0.4, 0.4)).collect();
        let times = found(&truth, &stamps, 1e-4).unwrap();
        let error = |at: &[f64]| {
            let squares: f64 = at.iter().zip(&truth).skip(50).take(1400).map(|(a, b)| (a - b).powi(2)).sum();
            (squares / 1400.0).sqrt()
        };
        // Jitter as slow as the joints' motion is unobservable.
        assert!(error(&times.at) < 0.6 * error(&stamps), "{} of {}", error(&times.at), error(&stamps));
        assert!((times.rms - error(&stamps)).abs() < 0.2 * error(&stamps), "{}", times.rms);
        assert!(times.noise.iter().all(|s| *s < 2e-3), "{:?}", times.noise);
    }

    /// Synchronised joints: a timing error may equally be motion along their line.
    #[test]
    fn joints_in_step_tell_no_time() {
        let mut random = Random::new(7);
        let stamps: Vec<f64> = (0..1500).map(|k| f64::from(k) * PERIOD).collect();
        let path: Vec<f64> = stamps.iter().map(|t| (t + PERIOD * random.uniform(-0.4, 0.4)).sin()).collect();
        let mut noisy =
            |share: f64| -> Vec<f64> { path.iter().map(|s| share * s + 1e-5 * random.even(3.0_f64.sqrt())).collect() };
        let q = [noisy(1.0), noisy(-0.7), noisy(0.4)];
        let q: Vec<&[f64]> = q.iter().map(Vec::as_slice).collect();
        assert_eq!(times(&stamps, &q, PERIOD), None);
    }

    /// A correct clock is not changed, whatever the encoders' noise.
    #[test]
    fn a_right_clock_is_left_alone() {
        let stamps: Vec<f64> = (0..1500).map(|k| f64::from(k) * PERIOD).collect();
        for noise in [0.0, 1e-6, 1e-4, 1e-3] {
            assert_eq!(found(&stamps, &stamps, noise), None, "{noise}");
        }
    }
}
