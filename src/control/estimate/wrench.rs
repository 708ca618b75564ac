//! From the torques that the model does not explain to the wrench on the tool: `(J')^+`, weighted
//! and damped.
//!
//! `J' F = e` with an error of covariance `S` (torque noise and the model's), and `F` itself of the
//! size `D` ([`Scale`]), independent. `F = (J S^-1 J' + D^-1)^-1 J S^-1 e` is the mean of `F` given
//! `e`, and the bracket's inverse its covariance. For `S = s^2 I` it is the damped least squares of
//! Nakamura and Hanafusa (J. Dyn. Sys. Meas. Control 108, 1986) and Wampler (IEEE SMC 16, 1986),
//! with damping `s / D`.

use super::sample::{NINETY_FIVE, Scale};
use crate::control::estimate::small_matrix::{backward, cholesky, dot, forward, inverse, sandwich, times};

/// How joints are weighted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Weights {
    /// By the uncertainty of each sample's torque. The best there is.
    Uncertainty,
    /// All alike, as in the paper's equation (14); `F = (J J' + l^2)^-1 J e` with the damping `l`.
    Equal {
        /// `l`, in the Jacobian's units: small against 1.
        damping: f64,
    },
}

/// A wrench with what is known of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Solved {
    pub wrench: [f64; 6],
    pub covariance: [[f64; 6]; 6],
    pub misfit: f64,
    /// Whether each component is observable: see
    /// [`Estimate::observable`](super::Estimate::observable).
    pub observable: [bool; 6],
}

/// `torque = J' F + error`; `None` where `covariance` is none.
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
            // Bias of the damping, `(1 - A J') F`: `F` is unknown, and its best weighted estimate
            // from the same torques takes its place. The damped estimate's own variance is small.
            let lost: [[f64; 6]; 6] = core::array::from_fn(|i| {
                core::array::from_fn(|j| f64::from(u8::from(i == j)) - dot(&map[i], &jacobian[j]))
            });
            let (noise, doubt) = (sandwich(&map, covariance), sandwich(&lost, &spread));
            let bias = times(&lost, &likely);
            let mut all: [[f64; 6]; 6] = core::array::from_fn(|i| core::array::from_fn(|j| noise[i][j] + doubt[i][j]));
            // The band holds what is 95 % likely, shifted by the bias to either side.
            for i in 0..6 {
                let std = libm::sqrt(all[i][i].max(0.0)) + libm::fabs(bias[i]) / NINETY_FIVE;
                all[i][i] = std * std;
            }
            (times(&map, torque), all)
        }
    };
    Some(Solved { wrench, covariance, misfit, observable })
}

/// A standard deviation above a tenth of the prior size of wrenches comes from that prior, and not
/// from the joints.
pub(super) fn observable(covariance: &[[f64; 6]; 6], scale: &Scale) -> [bool; 6] {
    let sizes = scale.each();
    core::array::from_fn(|i| covariance[i][i] <= 0.01 * sizes[i] * sizes[i])
}

/// `(J J' + l^2)^-1 J`.
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

/// Noise on the diagonal, the model's uncertainty around it.
pub(super) fn total<const N: usize>(variance: &[f64; N], model: &[[f64; N]; N]) -> [[f64; N]; N] {
    let mut sum = *model;
    (0..N).for_each(|j| sum[j][j] += variance[j]);
    sum
}
