//! Standard deviations of the parameters under filtered, hence correlated, noise.
//!
//! With `A = sum_j w_j^2 W_j' W_j` the estimate's covariance is `A^-1 B A^-1`, `B` that of the
//! score `sum_j w_j^2 W_j' e_j`. For white noise `B = A`. A low-pass correlates neighbouring
//! samples, so that 10,000 of them have the information of a few hundred: `B` is larger. As in the
//! method of batch means (Chen and Seila 1987; Flegal and Jones 2010) and in cluster-robust
//! regression (Liang and Zeger 1986), the scores of batches that are long against the correlation
//! time are nearly independent. Their squares therefore show how much larger `B` is. The score of
//! batch `b` of joint `j`, `s_jb = w_j^2 W_jb' (tau_jb - W_jb beta)`, requires only that batch's
//! Gram matrix, so the log is read once.
//!
//! Some tens of batches do not determine a `57 * 57` matrix with useful precision, but they
//! determine one number per joint: `lambda_j = sum_b s_jb' A^-1 s_jb / sum_b tr(A^-1 (A_jb - A_jb
//! A^-1 A_jb))`. It is the ratio of the batches' variance to that of white noise; the second term
//! is the part that the fit itself removes (Bell and McCaffrey 2002 correct for the same). Then `B
//! = sum_j lambda_j w_j^2 W_j' W_j`, and joint `j` has `N_j / lambda_j` effective samples. Because
//! the scores carry the regressor's own spectrum, `lambda` applies to the frequencies that the
//! motion excites.
//!
//! One number per joint assumes that the error is distributed over the motion like the regressor.
//! This fails if friction is wrong for some hundredths of a second at each reversal, where
//! accelerations are largest: the errors of inertias are then larger, those of viscous friction
//! smaller. [`Directions`] compares, for each parameter, the variance of the batches with that
//! expected from `lambda`.

use nalgebra::{DMatrix, DVector};

use crate::identify::regression::wls::{JointSystem, Solution, positions};

/// Fewest degrees of freedom for a statement on a single parameter.
const LEAST: f64 = 4.0;

/// Noise of the joints' torques, estimated from the residual.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Noise {
    /// Standard deviation of each joint's residual, N m.
    pub sigma: Vec<f64>,
    /// Number of samples per independent sample, per joint, at least 1.
    pub inflation: Vec<f64>,
    /// Number of samples divided by the inflation, per joint.
    pub effective_samples: Vec<f64>,
    /// Number of batches from which the inflation was estimated, per joint.
    pub batches: Vec<usize>,
}

/// Noise with `lambda_j` for each joint, and the covariance of the active parameters.
pub(in crate::identify) fn covariance(
    joints: &[JointSystem],
    solution: &Solution,
    parameters: usize,
) -> (Noise, DMatrix<f64>) {
    let p = solution.active.len();
    let position = positions(&solution.active, parameters);
    let inverse = &solution.inverse_information;
    let mut covariance = DMatrix::zeros(p, p);
    let mut directions = Directions::new(p);
    let mut noise = Noise { sigma: solution.sigma.clone(), ..Noise::default() };
    for ((joint, &weight), &sigma) in joints.iter().zip(&solution.weights).zip(&solution.sigma) {
        let pairs = joint.active(&position);
        let local = DMatrix::from_fn(pairs.len(), pairs.len(), |i, k| inverse[(pairs[i].1, pairs[k].1)]);
        let lambda = inflation(joint, &pairs, &local, [weight, sigma], &solution.beta);
        noise.inflation.push(lambda);
        noise.effective_samples.push(joint.samples as f64 / lambda);
        noise.batches.push(joint.batches.len());
        directions.add(joint, &pairs, inverse, [weight, lambda * (weight * sigma).powi(2)], &solution.beta);
        if joint.samples > 0 {
            // Adds A^-1 w_j R_j' sqrt(lambda_j) w_j sigma_j, then its square; w_j sigma_j is 1
            // unless weighting is switched off.
            let r = DMatrix::from_fn(joint.columns.len(), pairs.len(), |i, k| {
                if i <= pairs[k].0 { joint.triangle.get(i, pairs[k].0) } else { 0.0 }
            });
            let rows = DMatrix::from_fn(p, pairs.len(), |i, k| inverse[(i, pairs[k].1)]);
            let part = rows * r.transpose() * (weight * lambda.sqrt() * weight * sigma);
            covariance.gemm(1.0, &part, &part.transpose(), 1.0);
        }
    }
    let wider = directions.ratios();
    for (mut column, &b) in covariance.column_iter_mut().zip(&wider) {
        column.iter_mut().zip(&wider).for_each(|(entry, a)| *entry *= (a * b).sqrt());
    }
    (noise, covariance)
}

/// Gram matrix and score of one batch over the active parameters, weighted.
fn weighted(
    joint: &JointSystem,
    gram: &[f64],
    pairs: &[(usize, usize)],
    w2: f64,
    beta: &[f64],
) -> (DMatrix<f64>, DVector<f64>) {
    let n = joint.columns.len() + 1;
    let a = DMatrix::from_fn(pairs.len(), pairs.len(), |i, k| w2 * gram[pairs[i].0 + pairs[k].0 * n]);
    let mut score = DVector::from_fn(pairs.len(), |i, _| w2 * gram[pairs[i].0 + (n - 1) * n]);
    for (i, score) in score.iter_mut().enumerate() {
        for (k, &column) in joint.columns.iter().enumerate() {
            *score -= w2 * gram[pairs[i].0 + k * n] * beta[column];
        }
    }
    (a, score)
}

/// For each active parameter, summed squares of the batches' contributions to its error: observed
/// and expected.
struct Directions {
    shown: Vec<f64>,
    expected: Vec<f64>,
    /// Sum over batches of the squared expected contribution.
    squares: Vec<f64>,
}

impl Directions {
    fn new(parameters: usize) -> Self {
        let zeros = || vec![0.0; parameters];
        Self { shown: zeros(), expected: zeros(), squares: zeros() }
    }

    /// Adds a joint's batches. `variance`: of a weighted row, including the inflation.
    fn add(
        &mut self,
        joint: &JointSystem,
        pairs: &[(usize, usize)],
        inverse: &DMatrix<f64>,
        [weight, variance]: [f64; 2],
        beta: &[f64],
    ) {
        let rows: Vec<usize> = pairs.iter().map(|pair| pair.1).collect();
        // Column k: contribution of a score of this joint to the error of parameter k.
        let gains = inverse.select_rows(&rows);
        let local = gains.select_columns(&rows);
        for gram in &joint.batches {
            let (a, score) = weighted(joint, gram, pairs, weight * weight, beta);
            let errors = gains.tr_mul(&score);
            let through = a * &gains;
            let removed = &local * &through;
            for k in 0..errors.len() {
                let (gain, own) = (gains.column(k), through.column(k));
                let expected = variance * (gain.dot(&own) - own.dot(&removed.column(k))).max(0.0);
                self.shown[k] += errors[k].powi(2);
                self.expected[k] += expected;
                self.squares[k] += expected.powi(2);
            }
        }
    }

    /// Factor of each parameter's variance: observed over expected, shrunk together as far as the
    /// parameters differ by chance alone. (Smyth 2004: with `d` degrees of freedom each, the
    /// logarithm has a variance of `2 / d`, and any excess is due to the parameters.)
    fn ratios(&self) -> Vec<f64> {
        let freedom = |k: usize| if self.squares[k] > 0.0 { self.expected[k].powi(2) / self.squares[k] } else { 0.0 };
        let known: Vec<usize> = (0..self.shown.len()).filter(|&k| freedom(k) >= LEAST && self.shown[k] > 0.0).collect();
        let ratio = |k: usize| self.shown[k] / self.expected[k];
        // E ln(chi2_d / d) = digamma(d / 2) - ln(d / 2), about -1 / d.
        let logs: Vec<f64> = known.iter().map(|&k| ratio(k).ln() + freedom(k).recip()).collect();
        let count = known.len().max(1) as f64;
        let mean = logs.iter().sum::<f64>() / count;
        let chance = known.iter().map(|&k| 2.0 / freedom(k)).sum::<f64>() / count;
        let scatter = logs.iter().map(|l| (l - mean).powi(2)).sum::<f64>() / (count - 1.0).max(1.0);
        let prior = 2.0 / (scatter - chance).max(1e-3);
        let center = mean.exp();
        let mut out = vec![1.0; self.shown.len()];
        for k in known {
            out[k] = (prior * center + freedom(k) * ratio(k)) / (prior + freedom(k));
        }
        out
    }
}

/// Inflation `lambda_j`, given the block of `A^-1` that belongs to the joint's parameters.
fn inflation(
    joint: &JointSystem,
    pairs: &[(usize, usize)],
    inverse: &DMatrix<f64>,
    [weight, sigma]: [f64; 2],
    beta: &[f64],
) -> f64 {
    let w2 = weight * weight;
    let (mut shown, mut white) = (0.0, 0.0);
    for gram in &joint.batches {
        let (a, score) = weighted(joint, gram, pairs, w2, beta);
        shown += score.dot(&(inverse * &score));
        let product = &a * inverse;
        white += product.trace() - product.dot(&product.transpose());
    }
    let lambda = shown / (white * w2 * sigma * sigma);
    let samples = joint.samples.max(1) as f64;
    // With too few batches, the bound by the bandwidth is used.
    let most = if joint.independent > 0.0 { samples / joint.independent } else { 1.0 };
    if white > 1e-6 && lambda.is_finite() { lambda.clamp(1.0, samples) } else { most }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::identify::RFactor;

    /// One parameter, with batches that differ only in these scores. The value is computed by hand.
    /// Each batch adds its squared score divided by the sum of squares. Its expectation is `1/4 -
    /// 1/16`.
    fn by_scores(scores: &[f64]) -> f64 {
        let joint = JointSystem {
            columns: vec![0],
            triangle: RFactor::new(2),
            gram: vec![0.0; 4],
            samples: 100,
            independent: 20.0,
            torque_rms: 1.0,
            travel: 1.0,
            batches: scores.iter().map(|s| vec![1.0, *s, *s, s * s]).collect(),
        };
        inflation(&joint, &[(0, 0)], &DMatrix::from_element(1, 1, 0.25), [1.0, 1.0], &[0.0])
    }

    #[test]
    fn scores_that_scatter_more_than_white_noise_widen() {
        let found = by_scores(&[3.0, -3.0, 3.0, -3.0]);
        assert!((found - 0.25 * 36.0 / 0.75).abs() < 1e-12, "{found}");
        // Never narrower than white noise, nor wider than that of a single sample; without batches,
        // the value given by the bandwidth.
        assert_eq!([by_scores(&[0.1; 4]), by_scores(&[60.0; 4]), by_scores(&[])], [1.0, 100.0, 5.0]);
    }
}
