//! The generalised-momentum observer (De Luca and Mattone, ICRA 2005; De Luca, Albu-Schaeffer, Haddadin and Hirzinger, IROS 2006): no
//! acceleration.
//!
//! `r' = K (J' F - r)`: the external torque through a low-pass of `K`. The momentum `p = M dq` grows by `tau - c - g - friction + J' F + M' dq`;
//! from one sample to the next the last term is `(M1 - M0) (dq0 + dq1) / 2`, so that neither `C'` nor an acceleration is needed: the mass
//! matrix and the inverse dynamics at zero acceleration will do. `r` less `r` through the low-pass once more is what a ramp is late by: the wrench is
//! that of the observed torques and this; noise and band are those of both, and what is left of the lag (the same difference once more) is in the band.

use super::sample::{Estimate, ForceEstimator, Sample, Scale};
use super::small::{finite, times};
use super::wrench::{Weights, total, wrench};

/// The observer, then `(J')^+` as in [`Residual`](super::Residual).
#[derive(Debug, Clone, PartialEq)]
pub struct Momentum<const N: usize> {
    /// `K`, 1/s: the bandwidth, and one over the time by which a ramp is late.
    pub gain: f64,
    /// Spectral density of each joint's torque noise, (N m)^2 s: variance times sampling time for white noise.
    pub density: [f64; N],
    /// Standard deviation of each joint's velocity, rad/s.
    pub velocity_noise: [f64; N],
    /// How large wrenches are.
    pub scale: Scale,
    before: Option<Sample<N>>,
    observed: [f64; N],
    /// The observed torques through the same low-pass once more: what is between the two is about what the first is late by.
    again: [f64; N],
    /// What the first is late by, through the same low-pass: what is between the two is what is left of the lag.
    lag: [f64; N],
    /// Share of the observer's start that is still in it.
    start: f64,
    last: Estimate,
}

impl<const N: usize> Momentum<N> {
    /// At rest.
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
            start: 1.0,
            last,
        }
    }

    /// The observed external torques, `J' F` through the low-pass, N m.
    pub fn torques(&self) -> &[f64; N] {
        &self.observed
    }

    fn advance(&mut self, now: &Sample<N>) -> Option<Estimate> {
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
        let ahead: [f64; N] = core::array::from_fn(|j| observed[j] + late[j]);
        self.start *= keep;
        // Of what follows a ramp, `H (2 - H)` with `H = K / (s + K)`: of white torque noise 5/4 K, of the momentum's noise, which comes as its
        // derivative, 4 K^2 (to half a sample).
        let moved: [f64; N] = core::array::from_fn(|j| {
            (0..N).map(|k| now.mass[j][k] * now.mass[j][k] * self.velocity_noise[k] * self.velocity_noise[k]).sum()
        });
        let variance: [f64; N] =
            core::array::from_fn(|j| 1.25 * self.gain * self.density[j] + 4.0 * self.gain * self.gain * moved[j]);
        let mut covariance = total(&variance, &now.covariance);
        (0..N).for_each(|j| covariance[j][j] += left[j] * left[j]);
        // The observer began at zero, whatever pressed then.
        let sizes = self.scale.each();
        // `(1 + K t) exp(-K t)` of it is left.
        let begun_share = self.start * (1.0 - libm::log(self.start.max(1e-300)));
        if begun_share > 1e-6 {
            for j in 0..N {
                let begun: f64 = (0..6).map(|i| now.jacobian[i][j] * sizes[i] * begun_share).map(|x| x * x).sum();
                covariance[j][j] += begun;
            }
        }
        let s = wrench(&now.jacobian, &ahead, &covariance, &self.scale, Weights::Uncertainty)?;
        let (surprise, misfit) = (s.surprise, s.misfit);
        let (wrench, covariance, told) = (s.wrench, s.covariance, s.told);
        Some(Estimate { wrench, covariance, surprise, freedom: N, misfit, told, fresh: true })
    }
}

impl<const N: usize> ForceEstimator<N> for Momentum<N> {
    fn step(&mut self, sample: &Sample<N>) -> Estimate {
        let usable = finite(&sample.tau) && finite(&sample.dq) && finite(&sample.bias);
        match self.advance(sample).filter(|e| finite(&e.wrench)) {
            Some(estimate) => self.last = estimate,
            None => self.last.fresh = false,
        }
        if usable && sample.mass.iter().all(|row| finite(row)) {
            self.before = Some(*sample);
        } else {
            // The step over the hole is not known: the next sample begins anew, the observer keeps what it has.
            self.before = None;
        }
        self.last
    }

    fn reset(&mut self) {
        *self = Self::new(self.gain, self.density, self.velocity_noise, self.scale);
    }
}
