//! The generalised-momentum observer (De Luca and Mattone, ICRA 2005; De Luca, Albu-Schaeffer,
//! Haddadin and Hirzinger, IROS 2006): no acceleration.
//!
//! The observer is `r' = K (J' F - r)`: the external torque through a low-pass of `K`. The momentum
//! `p = M dq` grows by `tau - c - g - friction + J' F + M' dq`. Between two samples the last term
//! is `(M1 - M0) (dq0 + dq1) / 2`, so that neither `C'` nor an acceleration is needed: the mass
//! matrix and the inverse dynamics at zero acceleration suffice.
//!
//! `r` minus `r` through the same low-pass again is the lag on a ramp, up to half a sample: torques
//! between two samples belong to the middle of the interval. The wrench is computed from `r` plus
//! this difference, scaled so that the half sample is included. Noise and band cover the sum, and
//! the band includes the remaining lag (the same difference, low-passed again).

use super::sample::{Estimate, EstimatorInput, ForceEstimator, Scale};
use super::stiction::{least, unit};
use super::wrench::{Weights, total, wrench};
use crate::control::estimate::small_matrix::{cholesky, finite, times};

/// Momentum observer, followed by `(J')^+` as in [`Residual`](super::Residual).
#[derive(Debug, Clone, PartialEq)]
pub struct Momentum<const N: usize> {
    /// Observer gain `K`, 1/s: the bandwidth, and the reciprocal of the lag on a ramp.
    pub gain: f64,
    /// Spectral density of each joint's torque noise, (N m)^2 s: variance times sampling time for
    /// white noise.
    pub density: [f64; N],
    /// Standard deviation of each joint's velocity, rad/s.
    pub velocity_noise: [f64; N],
    /// Prior size of wrenches.
    pub scale: Scale,
    before: Option<EstimatorInput<N>>,
    observed: [f64; N],
    /// Observed torques through the same low-pass again, N m: their difference from `observed`
    /// approximates the lag of `observed`.
    again: [f64; N],
    /// Lag of `observed` through the same low-pass, N m: the difference of the two is the remaining
    /// lag.
    lag: [f64; N],
    /// Breakaway levels of joints at rest, N m; after a breakaway the level decays with the
    /// low-pass.
    held: [f64; N],
    /// Share of the observer's initial value that is still in its state.
    start: f64,
    last: Estimate,
}

impl<const N: usize> Momentum<N> {
    /// Creates the observer with zero observed torques.
    pub fn new(gain: f64, density: [f64; N], velocity_noise: [f64; N], scale: Scale) -> Self {
        let last = Estimate::unknown(&scale);
        Self {
            gain,
            density,
            velocity_noise,
            scale,
            before: None,
            observed: [0.0; N],
            again: [0.0; N],
            lag: [0.0; N],
            held: [0.0; N],
            start: 1.0,
            last,
        }
    }

    /// Observed external torques, `J' F` through the low-pass, N m.
    pub fn torques(&self) -> &[f64; N] {
        &self.observed
    }

    fn advance(&mut self, now: &EstimatorInput<N>) -> Option<Estimate> {
        let before = self.before.as_ref()?;
        if !(now.dt > 0.0 && now.dt.is_finite()) {
            return None;
        }
        let rise: [f64; N] = core::array::from_fn(|j| now.dq[j] - before.dq[j]);
        // (M1 dq1 - M0 dq0) - (M1 - M0) (dq0 + dq1) / 2 = (M0 + M1) / 2 (dq1 - dq0)
        let (a, b) = (times(&before.mass, &rise), times(&now.mass, &rise));
        let keep = libm::exp(-self.gain * now.dt);
        let observed: [f64; N] = core::array::from_fn(|j| {
            let inertial = 0.5 * (a[j] + b[j]) / now.dt;
            let known = 0.5 * (before.bias[j] + now.bias[j] - before.tau[j] - now.tau[j]);
            keep * self.observed[j] + (1.0 - keep) * (inertial + known)
        });
        if !finite(&observed) {
            return None;
        }
        self.observed = observed;
        (0..N).for_each(|j| self.again[j] += (1.0 - keep) * (observed[j] - self.again[j]));
        let late: [f64; N] = core::array::from_fn(|j| observed[j] - self.again[j]);
        (0..N).for_each(|j| self.lag[j] += (1.0 - keep) * (late[j] - self.lag[j]));
        let left: [f64; N] = core::array::from_fn(|j| late[j] - self.lag[j]);
        let [lead, missing] = lead(keep);
        let ahead: [f64; N] = core::array::from_fn(|j| observed[j] + lead * late[j]);
        self.start *= keep;
        // Gains of white torque noise and of the velocity noise, which enters as differences.
        let [white, steps, rest] = gains(keep, lead);
        // An error of one velocity enters the torques of all coupled joints at the same time.
        let inertial: [[f64; N]; N] = core::array::from_fn(|j| {
            core::array::from_fn(|i| {
                let of = |k: usize| now.mass[j][k] * now.mass[i][k] * self.velocity_noise[k] * self.velocity_noise[k];
                (0..N).map(of).sum::<f64>() / (now.dt * now.dt)
            })
        });
        let noise: [f64; N] = core::array::from_fn(|j| self.density[j] / now.dt);
        let mut covariance = total(&noise.map(|n| white * n), &now.covariance);
        (0..N).for_each(|j| (0..N).for_each(|i| covariance[j][i] += steps * inertial[j][i]));
        // Remaining lag that noise does not explain. A short pulse (friction that reverses before
        // the model's) leaves `k^2 / (1 + k)` of its size in it.
        let first = keep * keep / (1.0 + keep);
        for j in 0..N {
            let seen = left[j] * left[j];
            let usual = rest * noise[j] + first * first * steps * inertial[j][j];
            if seen > 9.0 * usual {
                covariance[j][j] += PULSE * PULSE * seen;
            }
            covariance[j][j] += missing * missing * late[j] * late[j];
        }
        // The observer started at zero, whatever the wrench at that time.
        let sizes = self.scale.each();
        // At most `(1 + lead K t) exp(-K t)` of the initial error remains.
        let begun_share = self.start * (1.0 - lead * libm::log(self.start.max(1e-300)));
        if begun_share > 1e-6 {
            for j in 0..N {
                let begun: f64 = (0..6).map(|i| now.jacobian[i][j] * sizes[i] * begun_share).map(|x| x * x).sum();
                covariance[j][j] += begun;
            }
        }
        (0..N).for_each(|j| self.held[j] = now.breakaway[j].max(keep * self.held[j]));
        let [surprise, without_friction] = least(&cholesky(&covariance)?, &ahead, unit::<N>, &self.held);
        let covariance = total(&now.static_friction.map(|s| s * s), &covariance);
        let s = wrench(&now.jacobian, &ahead, &covariance, &self.scale, Weights::Uncertainty)?;
        let (wrench, covariance, observable, misfit) = (s.wrench, s.covariance, s.observable, s.misfit);
        Some(Estimate { wrench, covariance, surprise, without_friction, freedom: N, misfit, observable, fresh: true })
    }
}

/// Size of a pulse relative to its remaining lag, in standard deviations: half of `(1 + k) / k^2`
/// for the usual time constants of a few samples.
const PULSE: f64 = 2.5;

/// Factor by which the remainder `1 - H` of the observed torques is added to them so that a ramp is
/// followed, and the part of it that is missing. `H` lags by `k / (1 - k)` samples, the mean of two
/// samples by half a sample. The factor is at most 2, as it amplifies noise.
fn lead(k: f64) -> [f64; 2] {
    let exact = 0.5 * (1.0 + k) / k.max(1e-3);
    [exact.min(2.0), (exact - 2.0).max(0.0)]
}

/// Standard deviation of the white velocity noise with the same effect on the estimate as the given
/// velocities. `speed` is their response to an error of 1 in one recorded position, one value per
/// sample, `dt` s apart. Low-passed velocities have nearly the same error at neighbouring samples,
/// so their differences have hardly any.
pub(super) fn white_speed(gain: f64, dt: f64, speed: &[f64]) -> f64 {
    let keep = libm::exp(-gain * dt);
    let [lead, _] = lead(keep);
    let (mut once, mut twice, mut before, mut energy) = (0.0, 0.0, 0.0, 0.0);
    // After the end of the response the observer's state decays.
    let settle = (20.0 / (1.0 - keep).max(1e-6)) as usize;
    for v in speed.iter().copied().chain(core::iter::repeat_n(0.0, settle)) {
        once += (1.0 - keep) * ((v - before) / dt - once);
        twice += (1.0 - keep) * (once - twice);
        before = v;
        let ahead = once + lead * (once - twice);
        energy += ahead * ahead;
    }
    let [_, steps, _] = gains(keep, lead);
    dt * libm::sqrt(energy / steps.max(1e-300))
}

/// Gains of white noise of variance 1 per sample in the ramp-following output
/// `G = H (1 + l (1 - H))`. `H` is `(1 - k) / (1 - k / z)` and `l` the [`lead`]. The first is for
/// noise that enters as the mean of two samples, the second for noise that enters as their
/// difference. The third is that of the mean in the remaining lag, `H (1 - H)^2` (for small steps).
///
/// The impulse response of `G` is `g_n = (1 - k) k^n (1 + l k - l (1 - k) n)`; the sums of
/// `g_n g_n` and `g_n g_{n+1}` are geometric series.
fn gains(k: f64, lead: f64) -> [f64; 3] {
    let (m, c, d) = (k * k, 1.0 + lead * k, lead * (k - 1.0));
    let (away, size) = ((1.0 - m).max(1e-12), (1.0 - k) * (1.0 - k));
    let sums = [1.0 / away, m / (away * away), m * (1.0 + m) / (away * away * away)];
    let same = size * (c * c * sums[0] + 2.0 * c * d * sums[1] + d * d * sums[2]);
    let next = size * k * (c * (c + d) * sums[0] + d * (2.0 * c + d) * sums[1] + d * d * sums[2]);
    let turn = -libm::log(k.clamp(1e-300, 1.0));
    [0.5 * (same + next), 2.0 * (same - next), 0.1875 * turn]
}

impl<const N: usize> ForceEstimator<N> for Momentum<N> {
    fn step(&mut self, sample: &EstimatorInput<N>) -> Estimate {
        let usable = finite(&sample.tau) && finite(&sample.dq) && finite(&sample.bias);
        match self.advance(sample).filter(|e| finite(&e.wrench)) {
            Some(estimate) => self.last = estimate,
            None => self.last.fresh = false,
        }
        if usable && sample.mass.iter().all(|row| finite(row)) {
            self.before = Some(*sample);
        } else {
            // The change over the gap is unknown: the next sample starts a new step, and the
            // observed torques are kept.
            self.before = None;
        }
        self.last
    }

    fn reset(&mut self) {
        *self = Self::new(self.gain, self.density, self.velocity_noise, self.scale);
    }
}
