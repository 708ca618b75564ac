//! The paper's equation (14): the residual torque of the identified inverse dynamics through
//! `(J')^+`.

use super::sample::{Estimate, EstimatorInput, ForceEstimator, Scale};
use super::stiction::{least, unit};
use super::wrench::{Weights, total, wrench};
use crate::control::estimate::small_matrix::{cholesky, finite};

/// Solves `J' F = M ddq + c + g + friction - tau` at each sample separately. Needs the
/// acceleration.
///
/// The paper writes `tau = .. + tau_ext` with the wrench of the tool on its surroundings. Here, as
/// in a log's `fx .. mz`, the wrench is that of the surroundings on the tool, with the opposite
/// sign.
#[derive(Debug, Clone, PartialEq)]
pub struct Residual<const N: usize> {
    /// Standard deviation of each joint's torque noise, N m, in the samples after their filter.
    pub noise: [f64; N],
    /// Prior size of wrenches.
    pub scale: Scale,
    /// Weighting of the joints.
    pub weights: Weights,
    last: Estimate,
}

impl<const N: usize> Residual<N> {
    /// Creates the estimator with joints weighted by their uncertainty.
    pub fn new(noise: [f64; N], scale: Scale) -> Self {
        Self { noise, scale, weights: Weights::Uncertainty, last: Estimate::unknown(&scale) }
    }
}

impl<const N: usize> ForceEstimator<N> for Residual<N> {
    fn step(&mut self, sample: &EstimatorInput<N>) -> Estimate {
        let external: [f64; N] = core::array::from_fn(|j| sample.model[j] - sample.tau[j]);
        let variance: [f64; N] = core::array::from_fn(|j| self.noise[j] * self.noise[j]);
        let moving = total(&variance, &sample.covariance);
        let covariance = total(&sample.static_friction.map(|s| s * s), &moving);
        let solved = wrench(&sample.jacobian, &external, &covariance, &self.scale, self.weights);
        let surprise = cholesky(&moving).map(|root| least(&root, &external, unit::<N>, &sample.breakaway));
        let found = solved.zip(surprise).filter(|(s, surprise)| finite(&s.wrench) && finite(surprise));
        self.last = match found {
            Some((s, [surprise, without_friction])) => Estimate {
                wrench: s.wrench,
                covariance: s.covariance,
                surprise,
                without_friction,
                freedom: N,
                misfit: s.misfit,
                observable: s.observable,
                fresh: true,
            },
            None => Estimate { fresh: false, ..self.last },
        };
        self.last
    }

    fn reset(&mut self) {
        self.last = Estimate::unknown(&self.scale);
    }
}
