//! The model that changes of a robot are measured against.

use denavit::identify::{Factors, JointFactor};
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// Rounds of weighting: weights need one digit.
const ROUNDS: usize = 3;

/// Directions count as undetermined whose eigenvalue (columns of unit norm) is below this times the
/// largest: far above the rounding of the squares.
const TOLERANCE: f64 = 1e-12;

/// Base parameters, weighted by the noise of each joint. `solve` says more of a model, such as its
/// conditions and suspicions, and takes fifty times as long; a fleet has thousands.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// Base parameters.
    pub beta: Vec<f64>,
    /// Per joint: one over the variance of its residual; zero without a torque.
    pub weights: Vec<f64>,
    /// Covariance of `beta`, row-major; zero where a parameter is not determined.
    covariance: Vec<f64>,
    /// Per parameter: whether it is not determined.
    open: Vec<bool>,
}

impl Reference {
    /// Of factors; `None` where no joint has a torque.
    pub fn of(factors: &Factors) -> Option<Self> {
        let n = factors.parameters;
        let live: Vec<(usize, &JointFactor)> = factors.joints.iter().enumerate().filter(|(_, j)| j.is_live()).collect();
        if live.is_empty() || n == 0 {
            return None;
        }
        let grams: Vec<Vec<f64>> = live.iter().map(|(_, joint)| joint.triangle.gram()).collect();
        let mut weights = vec![0.0; factors.joints.len()];
        live.iter().for_each(|(j, joint)| weights[*j] = 1.0 / joint.torque_rms().powi(2));
        let mut fit = None;
        for _ in 0..ROUNDS {
            let solved = Fit::new(n, &live, &grams, &weights)?;
            for (j, joint) in &live {
                let square = joint.residual_norm(&solved.beta).powi(2) / joint.samples.max(1) as f64;
                // A joint without any noise weighs a lot, and not everything.
                weights[*j] = 1.0 / square.max(1e-12 * joint.torque_rms().powi(2));
            }
            fit = Some(solved);
        }
        let slow = live.iter().map(|(_, j)| j.samples as f64 / j.independent.max(1.0)).fold(1.0, f64::max);
        let Fit { beta, covariance, open } = fit?;
        let covariance = covariance.iter().map(|c| c * slow).collect();
        Some(Self { beta, weights, covariance, open })
    }

    /// Variance of `c' beta`; infinite where it is not determined.
    pub(crate) fn variance(&self, c: &[f64]) -> f64 {
        let largest = c.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        if c.iter().zip(&self.open).any(|(c, open)| *open && c.abs() > 1e-9 * largest) {
            return f64::INFINITY;
        }
        let rows = c.iter().zip(self.covariance.chunks_exact(c.len()));
        let row = |(own, row): (&f64, &[f64])| own * row.iter().zip(c).map(|(a, b)| a * b).sum::<f64>();
        rows.filter(|(own, _)| **own != 0.0).map(row).sum::<f64>().max(0.0)
    }
}

/// Weighted least squares with these weights.
struct Fit {
    beta: Vec<f64>,
    covariance: Vec<f64>,
    open: Vec<bool>,
}

impl Fit {
    fn new(n: usize, live: &[(usize, &JointFactor)], grams: &[Vec<f64>], weights: &[f64]) -> Option<Self> {
        let (mut all, mut right) = (DMatrix::<f64>::zeros(n, n), DVector::<f64>::zeros(n));
        for ((j, JointFactor { columns, .. }), gram) in live.iter().zip(grams) {
            let size = columns.len() + 1;
            for (i, &row) in columns.iter().enumerate() {
                right[row] += weights[*j] * gram[i + columns.len() * size];
                for (k, &column) in columns.iter().enumerate() {
                    all[(row, column)] += weights[*j] * gram[i + k * size];
                }
            }
        }
        if all.iter().chain(right.iter()).any(|x: &f64| !x.is_finite()) {
            return None;
        }
        // Columns of unit norm; one without an entry stays without.
        let scale: Vec<f64> =
            (0..n).map(|i| all[(i, i)]).map(|square| if square > 0.0 { square.sqrt().recip() } else { 0.0 }).collect();
        let scaled = DMatrix::from_fn(n, n, |i, k| scale[i] * all[(i, k)] * scale[k]);
        let SymmetricEigen { eigenvectors, eigenvalues } = SymmetricEigen::new(scaled);
        let least = TOLERANCE * eigenvalues.max();
        let inverse = eigenvalues.map(|value| if value > least { value.recip() } else { 0.0 });
        let missing =
            |i: usize| (0..n).filter(|&m| inverse[m] == 0.0).map(|m| eigenvectors[(i, m)].powi(2)).sum::<f64>();
        let open: Vec<bool> = (0..n).map(|i| missing(i) > 1e-6).collect();
        let whole = &eigenvectors * DMatrix::from_diagonal(&inverse) * eigenvectors.transpose();
        let covariance = DMatrix::from_fn(n, n, |i, k| scale[i] * whole[(i, k)] * scale[k]);
        let beta = &covariance * right;
        let known = |i: usize, k: usize| if open[i] || open[k] { 0.0 } else { covariance[(i, k)] };
        let covariance = (0..n * n).map(|at| known(at / n, at % n)).collect();
        Some(Self { beta: beta.as_slice().to_vec(), covariance, open })
    }
}
