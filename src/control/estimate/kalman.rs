//! A disturbance observer as a Kalman filter over momentum and wrench (after Wahrburg, Boes,
//! Listmann, Dai, Matthias and Ding, IEEE T-ASE 15, 2018).
//!
//! State: momentum `p` (`N`) and the wrench `F` on the tool (6). The wrench is a random walk at a
//! given rate that decays slowly, so that it stays within the size of [`Scale`] (a Gauss-Markov
//! process). `p` grows by `tau - c - g - friction + J' F + M' dq` and is measured as `M dq`. The
//! wrench is estimated directly, so a singular Jacobian needs no special case: the variance of the
//! singular direction grows to that of the process and shrinks again afterwards.

use super::sample::{Estimate, EstimatorInput, ForceEstimator, Scale};
use super::stiction::least;
use super::wrench::observable;
use crate::control::estimate::random_walk_rate::RandomWalkRate;
use crate::control::estimate::small_matrix::{
    self, cholesky, dot, finite, forward, inverse, sandwich, times, transposed_times,
};

/// Kalman filter over momentum and wrench.
#[derive(Debug, Clone, PartialEq)]
pub struct Kalman<const N: usize> {
    /// Spectral density of each joint's torque noise, (N m)^2 s: variance times sampling time for
    /// white noise.
    pub density: [f64; N],
    /// Standard deviation of each joint's velocity, rad/s.
    pub velocity_noise: [f64; N],
    /// Prior size of wrenches.
    pub scale: Scale,
    /// Largest random-walk rate of the wrench: standard deviations after a second, N and N m. Each
    /// component's actual rate is found from the estimate (`random_walk_rate.rs`); the band is that
    /// of a wrench with this rate.
    pub wander: Scale,
    state: Option<State<N>>,
    /// Duration of unusable samples since the last usable one, s.
    hole: f64,
    last: Estimate,
}

#[derive(Debug, Clone, PartialEq)]
struct State<const N: usize> {
    before: EstimatorInput<N>,
    momentum: [f64; N],
    wrench: [f64; 6],
    /// Covariance of the momentum, of momentum with wrench, and of the wrench.
    pp: [[f64; N]; N],
    pf: [[f64; 6]; N],
    ff: [[f64; 6]; 6],
    /// Random-walk rate of each component.
    paces: [RandomWalkRate; 6],
    /// Breakaway levels of joints at rest, N m; they decay after the joint has broken away.
    held: [f64; N],
}

/// Steady-state quantities: see [`Kalman::steady`].
struct Steady<const N: usize> {
    /// Covariance of the filter plus that of the parameters.
    covariance: [[f64; 6]; 6],
    /// Noise density of each component.
    density: [f64; 6],
    /// Lag of each component per rate of each component, s times a ratio of units. The error of a
    /// filter of covariance `P` on torques of information `I` (per s) follows `e' = v - P I e`, so
    /// that rates `v` lead to a lag of `(P I)^-1 v`. The rates of other components also cause lag
    /// in a component.
    late: [[f64; 6]; 6],
    /// Map from torques to the wrench.
    map: [[f64; N]; 6],
}

impl<const N: usize> Kalman<N> {
    /// Creates the filter without a state; the first usable sample sets it.
    pub fn new(density: [f64; N], velocity_noise: [f64; N], scale: Scale, wander: Scale) -> Self {
        Self { density, velocity_noise, scale, wander, state: None, hole: 0.0, last: Estimate::unknown(&scale) }
    }

    /// Covariance of the measured momentum `M dq`.
    fn measurement(&self, sample: &EstimatorInput<N>) -> [[f64; N]; N] {
        let mut all = [[0.0; N]; N];
        for i in 0..N {
            for j in 0..N {
                all[i][j] = (0..N)
                    .map(|k| sample.mass[i][k] * self.velocity_noise[k] * self.velocity_noise[k] * sample.mass[j][k])
                    .sum();
            }
            // Keeps the matrix regular, whatever the mass matrix: an error of a microradian per
            // second of one kg m^2.
            all[i][i] += 1e-12;
        }
        all
    }

    fn begin(&self, sample: &EstimatorInput<N>) -> State<N> {
        State {
            before: *sample,
            momentum: times(&sample.mass, &sample.dq),
            wrench: [0.0; 6],
            pp: self.measurement(sample),
            pf: [[0.0; 6]; N],
            ff: Estimate::unknown(&self.scale).covariance,
            paces: self.wander.each().map(RandomWalkRate::new),
            held: sample.breakaway,
        }
    }

    fn advance(&self, state: &State<N>, now: &EstimatorInput<N>) -> Option<(State<N>, Estimate)> {
        let dt = now.dt + self.hole;
        if !(dt > 0.0 && dt.is_finite()) {
            return None;
        }
        let before = &state.before;
        let sizes = self.scale.each();
        let paces: [f64; 6] = core::array::from_fn(|i| state.paces[i].now());
        // Stationary variance of the random walk: rate^2 / (2 decay rate) = size^2.
        let keep: [f64; 6] =
            core::array::from_fn(|i| libm::exp(-0.5 * dt * paces[i] * paces[i] / (sizes[i] * sizes[i])));
        // Prediction: p + dt (tau - bias) + (M1 - M0)(dq0 + dq1)/2 + B F, B = dt J'.
        let mean: [f64; N] = core::array::from_fn(|j| 0.5 * (before.dq[j] + now.dq[j]));
        let (a, b) = (times(&before.mass, &mean), times(&now.mass, &mean));
        let push: [[f64; N]; 6] =
            core::array::from_fn(|i| core::array::from_fn(|j| 0.5 * dt * (before.jacobian[i][j] + now.jacobian[i][j])));
        let pushed = transposed_times(&push, &state.wrench);
        let mut momentum: [f64; N] = core::array::from_fn(|j| {
            let actuated = 0.5 * (before.tau[j] + now.tau[j] - before.bias[j] - now.bias[j]);
            state.momentum[j] + dt * actuated + b[j] - a[j] + pushed[j]
        });
        let mut wrench: [f64; 6] = core::array::from_fn(|i| keep[i] * state.wrench[i]);
        // Rows of pf + B ff: covariance of the new momentum with the wrench before its decay.
        let joined: [[f64; 6]; N] = core::array::from_fn(|j| {
            core::array::from_fn(|i| state.pf[j][i] + (0..6).map(|k| push[k][j] * state.ff[k][i]).sum::<f64>())
        });
        let mut pp: [[f64; N]; N] = core::array::from_fn(|i| {
            core::array::from_fn(|j| {
                let mixed: f64 = (0..6).map(|k| state.pf[i][k] * push[k][j] + push[k][i] * joined[j][k]).sum();
                state.pp[i][j] + mixed + if i == j { self.density[i] * dt } else { 0.0 }
            })
        });
        let mut pf = joined.map(|row| core::array::from_fn(|i| keep[i] * row[i]));
        let mut ff: [[f64; 6]; 6] = core::array::from_fn(|i| {
            core::array::from_fn(|j| {
                let fresh = if i == j { (1.0 - keep[i] * keep[i]) * sizes[i] * sizes[i] } else { 0.0 };
                keep[i] * keep[j] * state.ff[i][j] + fresh
            })
        });
        // Correction by M dq in the measurement's whitened coordinates: covariances decrease by the
        // products of their whitened rows.
        let noise = self.measurement(now);
        let innovation: [[f64; N]; N] = core::array::from_fn(|i| core::array::from_fn(|j| pp[i][j] + noise[i][j]));
        let root = cholesky(&innovation)?;
        let measured = times(&now.mass, &now.dq);
        let mut white: [f64; N] = core::array::from_fn(|j| measured[j] - momentum[j]);
        forward(&root, &mut white);
        let of_momentum: [[f64; N]; N] = core::array::from_fn(|i| {
            let mut row = pp[i];
            forward(&root, &mut row);
            row
        });
        let of_wrench: [[f64; N]; 6] = core::array::from_fn(|i| {
            let mut row: [f64; N] = core::array::from_fn(|j| pf[j][i]);
            forward(&root, &mut row);
            row
        });
        for i in 0..N {
            momentum[i] += dot(&of_momentum[i], &white);
            (0..N).for_each(|j| pp[i][j] -= dot(&of_momentum[i], &of_momentum[j]));
            (0..6).for_each(|k| pf[i][k] -= dot(&of_momentum[i], &of_wrench[k]));
        }
        for i in 0..6 {
            wrench[i] += dot(&of_wrench[i], &white);
            (0..6).for_each(|j| ff[i][j] -= dot(&of_wrench[i], &of_wrench[j]));
        }
        if !(finite(&momentum) && finite(&wrench)) {
            return None;
        }
        let Steady { mut covariance, density, late, map } = self.steady(now, &ff)?;
        let mut found = state.paces;
        (0..6).for_each(|i| found[i].see(wrench[i], density[i], dt));
        for i in 0..6 {
            let of_others: f64 = (0..6).filter(|&j| j != i).map(|j| late[i][j] * late[i][j] * found[j].rate()).sum();
            covariance[i][i] += found[i].missing(ff[i][i], density[i]) + of_others;
        }
        let mut held = state.held;
        (0..N).for_each(|j| held[j] = now.breakaway[j].max(libm::exp(-20.0 * dt) * held[j]));
        let column = |j: usize| core::array::from_fn(|i| map[i][j]);
        let [surprise, without_friction] = least(&cholesky(&covariance)?, &wrench, column, &held);
        let friction: [[f64; 6]; 6] = core::array::from_fn(|i| {
            core::array::from_fn(|k| (0..N).map(|j| map[i][j] * map[k][j] * now.static_friction[j].powi(2)).sum())
        });
        (0..6).for_each(|i| (0..6).for_each(|k| covariance[i][k] += friction[i][k]));
        let (observable, misfit, freedom) = (observable(&covariance, &self.scale), dot(&white, &white), N.min(6));
        let estimate =
            Estimate { wrench, covariance, surprise, without_friction, freedom, misfit, observable, fresh: true };
        Some((State { before: *now, momentum, wrench, pp, pf, ff, paces: found, held }, estimate))
    }

    /// Computes the filter's steady state. The model's parameters are the same at every sample and
    /// so are not noise. Their covariance is `A W C W' A'`, where `A` is the filter's steady map
    /// from torque to wrench: least squares weighted by the torques' densities.
    fn steady(&self, now: &EstimatorInput<N>, noise: &[[f64; 6]; 6]) -> Option<Steady<N>> {
        let variance: [f64; N] = core::array::from_fn(|j| self.density[j] + 1e-12);
        let sizes = self.scale.each();
        let information: [[f64; 6]; 6] = core::array::from_fn(|i| {
            core::array::from_fn(|j| {
                let prior = if i == j { 1.0 / (sizes[i] * sizes[i]) } else { 0.0 };
                (0..N).map(|k| now.jacobian[i][k] * now.jacobian[j][k] / variance[k]).sum::<f64>() + prior
            })
        });
        let inverse = inverse(&cholesky(&information)?);
        let map: [[f64; N]; 6] = core::array::from_fn(|i| {
            core::array::from_fn(|k| (0..6).map(|j| inverse[i][j] * now.jacobian[j][k]).sum::<f64>() / variance[k])
        });
        let model = sandwich(&map, &now.covariance);
        let late = cholesky(noise).map_or([[0.0; 6]; 6], |root| {
            let gain = small_matrix::inverse(&root);
            core::array::from_fn(|i| core::array::from_fn(|j| (0..6).map(|k| inverse[i][k] * gain[k][j]).sum()))
        });
        Some(Steady {
            covariance: core::array::from_fn(|i| core::array::from_fn(|j| noise[i][j] + model[i][j])),
            density: core::array::from_fn(|i| inverse[i][i]),
            late,
            map,
        })
    }
}

impl<const N: usize> ForceEstimator<N> for Kalman<N> {
    fn step(&mut self, sample: &EstimatorInput<N>) -> Estimate {
        let usable = finite(&sample.tau)
            && finite(&sample.dq)
            && finite(&sample.bias)
            && sample.mass.iter().all(|row| finite(row))
            && sample.jacobian.iter().all(|row| finite(row));
        self.last.fresh = false;
        if !usable {
            // The next usable sample bridges the gap; the wrench decays to its prior meanwhile.
            self.hole += if sample.dt.is_finite() { sample.dt.max(0.0) } else { 0.0 };
            return self.last;
        }
        match &self.state {
            None => self.state = Some(self.begin(sample)),
            Some(state) => {
                if let Some((state, estimate)) = self.advance(state, sample) {
                    self.state = Some(state);
                    self.last = estimate;
                }
            }
        }
        self.hole = 0.0;
        self.last
    }

    fn reset(&mut self) {
        *self = Self::new(self.density, self.velocity_noise, self.scale, self.wander);
    }
}
