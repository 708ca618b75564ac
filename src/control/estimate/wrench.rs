//! Wrench on the tool from the residual torque: weighted and damped `(J')^+`.
//!
//! The equation is `J' F = e`, with an error of covariance `S` (torque noise and model) and an
//! independent prior of covariance `D` on `F` ([`Scale`]). `F = (J S^-1 J' + D^-1)^-1 J S^-1 e` is
//! the mean of `F` given `e`, and the inverse of the bracket its covariance. For `S = s^2 I` and
//! `D = d^2 I` this is damped least squares (Nakamura and Hanafusa, J. Dyn. Sys. Meas. Control 108,
//! 1986; Wampler, IEEE SMC 16, 1986), with damping `s / d`.

use super::sample::{NINETY_FIVE, Scale};
use crate::control::estimate::small_matrix::{backward, cholesky, dot, forward, inverse, sandwich, times};

/// Weighting of the joints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Weights {
    /// Weighted by the uncertainty of each sample's torque; the minimum-variance choice.
    Uncertainty,
    /// Equal weights, as in the paper's equation (14): `F = (J J' + l^2)^-1 J e` with the damping
    /// `l`.
    Equal {
        /// Damping `l`, in the Jacobian's units: small compared with 1.
        damping: f64,
    },
}

/// A wrench with its covariance and what can be observed of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Solved {
    pub wrench: [f64; 6],
    pub covariance: [[f64; 6]; 6],
    pub misfit: f64,
    /// Whether each component is observable: see
    /// [`Estimate::observable`](super::Estimate::observable).
    pub observable: [bool; 6],
}

/// Solves `torque = J' F + error`; `None` if `covariance` is not positive definite.
pub(super) fn wrench<const N: usize>(
    jacobian: &[[f64; N]; 6],
    torque: &[f64; N],
    covariance: &[[f64; N]; N],
    scale: &Scale,
    weights: Weights,
) -> Option<Solved> {
    let root = cholesky(covariance)?;
    let mut white = *torque;
    forward(&root, &mut white);
    let whitened: [[f64; N]; 6] = core::array::from_fn(|i| {
        let mut row = jacobian[i];
        forward(&root, &mut row);
        row
    });
    let sizes = scale.each();
    let information: [[f64; 6]; 6] = core::array::from_fn(|i| {
        core::array::from_fn(|j| {
            let prior = if i == j { 1.0 / (sizes[i] * sizes[i]) } else { 0.0 };
            dot(&whitened[i], &whitened[j]) + prior
        })
    });
    let factor = cholesky(&information)?;
    let mut right = times(&whitened, &white);
    forward(&factor, &mut right);
    let misfit = if N > 6 { (dot(&white, &white) - dot(&right, &right)).max(0.0) } else { 0.0 };
    backward(&factor, &mut right);
    let (likely, spread) = (right, inverse(&factor));
    let observable = observable(&spread, scale);
    let (wrench, covariance) = match weights {
        Weights::Uncertainty => (likely, spread),
        Weights::Equal { damping } => {
            let map = equal(jacobian, damping)?;
            // Bias of the damping, `(1 - A J') F`. `F` is unknown and replaced by its weighted
            // estimate from the same torques. The damped estimate's own variance is small.
            let lost: [[f64; 6]; 6] = core::array::from_fn(|i| {
                core::array::from_fn(|j| f64::from(u8::from(i == j)) - dot(&map[i], &jacobian[j]))
            });
            let (noise, doubt) = (sandwich(&map, covariance), sandwich(&lost, &spread));
            let bias = times(&lost, &likely);
            let mut all: [[f64; 6]; 6] = core::array::from_fn(|i| core::array::from_fn(|j| noise[i][j] + doubt[i][j]));
            // The band is the 95 % interval, extended by the bias to either side.
            for i in 0..6 {
                let std = libm::sqrt(all[i][i].max(0.0)) + libm::fabs(bias[i]) / NINETY_FIVE;
                all[i][i] = std * std;
            }
            (times(&map, torque), all)
        }
    };
    Some(Solved { wrench, covariance, misfit, observable })
}

/// Whether each component is observable: a standard deviation above a tenth of the prior size comes
/// from the prior and not from the joints.
pub(super) fn observable(covariance: &[[f64; 6]; 6], scale: &Scale) -> [bool; 6] {
    let sizes = scale.each();
    core::array::from_fn(|i| covariance[i][i] <= 0.01 * sizes[i] * sizes[i])
}

/// Damped pseudo-inverse `(J J' + l^2)^-1 J`, `6 x N`.
fn equal<const N: usize>(jacobian: &[[f64; N]; 6], damping: f64) -> Option<[[f64; N]; 6]> {
    let square: [[f64; 6]; 6] = core::array::from_fn(|i| {
        core::array::from_fn(|j| dot(&jacobian[i], &jacobian[j]) + if i == j { damping * damping } else { 0.0 })
    });
    let factor = cholesky(&square)?;
    let mut map = [[0.0; N]; 6];
    for j in 0..N {
        let mut column: [f64; 6] = core::array::from_fn(|i| jacobian[i][j]);
        forward(&factor, &mut column);
        backward(&factor, &mut column);
        (0..6).for_each(|i| map[i][j] = column[i]);
    }
    Some(map)
}

/// Model covariance plus the noise variance on the diagonal.
pub(super) fn total<const N: usize>(variance: &[f64; N], model: &[[f64; N]; N]) -> [[f64; N]; N] {
    let mut sum = *model;
    (0..N).for_each(|j| sum[j][j] += variance[j]);
    sum
}
