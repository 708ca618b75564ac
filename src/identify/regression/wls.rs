//! Weighted least squares on the joints' factors, each joint weighted by its own noise (Gautier
//! 1997; Khalil and Dombre, section 12.5).
//!
//! Solves `min sum_j w_j^2 |R_j beta_j - z_j|^2` with `w_j = 1 / sigma_j`, `sigma_j` from the
//! residual of the previous solution, until convergence.

use nalgebra::{DMatrix, DVector};

use crate::identify::regression::accumulator::{Factors, JointFactor};
use crate::identify::regression::r_factor::RFactor;
use crate::identify::regression::spectrum::Small;

/// Equations of one joint over all fitted logs.
#[derive(Debug, Clone)]
pub(in crate::identify) struct JointSystem {
    pub(in crate::identify) columns: Vec<usize>,
    pub(in crate::identify) triangle: RFactor,
    /// Gram matrix `R_j' R_j`, column-major, `(n + 1)^2`.
    pub(in crate::identify) gram: Vec<f64>,
    pub(in crate::identify) samples: usize,
    /// Independent samples, see [`JointFactor::independent`].
    pub(in crate::identify) independent: f64,
    pub(in crate::identify) torque_rms: f64,
    /// Largest range of its position in any log, rad or m.
    pub(in crate::identify) travel: f64,
    /// Gram matrices of batches.
    pub(in crate::identify) batches: Vec<Vec<f64>>,
}

impl JointSystem {
    /// Merges the factors of each joint over several logs. Logs in which its torque is zero
    /// throughout are left out.
    pub(in crate::identify) fn all(logs: &[Factors], parameters: usize) -> Vec<Self> {
        let dof = logs.first().map_or(0, |log| log.joints.len());
        debug_assert!(logs.iter().all(|log| log.parameters == parameters && log.joints.len() == dof));
        (0..dof)
            .map(|joint| {
                let columns = logs[0].joints[joint].columns.clone();
                let mut triangle = RFactor::new(columns.len() + 1);
                let (mut samples, mut independent, mut travel, mut batches) = (0, 0.0, 0.0_f64, Vec::new());
                for factor in logs.iter().map(|log| &log.joints[joint]).filter(|f| f.is_live()) {
                    triangle.merge(&factor.triangle);
                    samples += factor.samples;
                    independent += factor.independent;
                    travel = travel.max(factor.reach[1] - factor.reach[0]);
                    batches.extend(factor.batches.grams.iter().cloned());
                }
                let (range, reach) = ([f64::NAN; 2], [f64::NAN; 2]);
                let batch = crate::identify::regression::batches::Batches::new();
                let whole = JointFactor { columns, triangle, samples, independent, range, reach, batches: batch };
                Self {
                    gram: whole.triangle.gram(),
                    torque_rms: whole.torque_rms(),
                    columns: whole.columns,
                    triangle: whole.triangle,
                    samples,
                    independent,
                    travel,
                    batches,
                }
            })
            .collect()
    }

    /// Negates the torque.
    pub(in crate::identify) fn turn(&mut self) {
        self.triangle.negate_last();
    }

    pub(in crate::identify) fn residual_norm(&self, beta: &[f64]) -> f64 {
        let mut x: Vec<f64> = self.columns.iter().map(|&c| -beta[c]).collect();
        x.push(1.0);
        self.triangle.norm_of(&x)
    }

    /// Pairs of (position in the joint's columns, position among the active parameters).
    pub(in crate::identify) fn active(&self, position: &[Option<usize>]) -> Vec<(usize, usize)> {
        self.columns.iter().enumerate().filter_map(|(i, &c)| position[c].map(|p| (i, p))).collect()
    }
}

/// Position of each parameter among the active ones.
pub(in crate::identify) fn positions(active: &[usize], parameters: usize) -> Vec<Option<usize>> {
    let mut position = vec![None; parameters];
    active.iter().enumerate().for_each(|(p, &c)| position[c] = Some(p));
    position
}

/// Factor of the stacked, weighted problem `[w_j R_j w_j z_j]` over the active parameters.
pub(in crate::identify) fn stacked(
    joints: &[JointSystem],
    weights: &[f64],
    active: &[usize],
    parameters: usize,
) -> RFactor {
    let (p, position) = (active.len(), positions(active, parameters));
    let mut triangle = RFactor::new(p + 1);
    let mut block = Vec::new();
    for (joint, &weight) in joints.iter().zip(weights).filter(|(j, _)| j.samples > 0) {
        let rows = joint.columns.len() + 1;
        block.clear();
        block.resize(rows * (p + 1), 0.0);
        let torque = (joint.columns.len(), p);
        for (from, to) in joint.active(&position).into_iter().chain([torque]) {
            for (i, value) in joint.triangle.column(from).iter().enumerate() {
                block[i + to * rows] = weight * value;
            }
        }
        triangle.absorb(&mut block, rows);
    }
    triangle
}

/// Solution of the weighted problem.
#[derive(Debug, Clone)]
pub(in crate::identify) struct Solution {
    /// Values of all parameters; zero if not active.
    pub(in crate::identify) beta: Vec<f64>,
    pub(in crate::identify) active: Vec<usize>,
    /// Weights `1 / sigma_j`.
    pub(in crate::identify) weights: Vec<f64>,
    /// Residual standard deviations `sigma_j`, N m.
    pub(in crate::identify) sigma: Vec<f64>,
    /// Inverse information `(sum_j w_j^2 W_j' W_j)^-1` over the active parameters.
    pub(in crate::identify) inverse_information: DMatrix<f64>,
    pub(in crate::identify) small: Small,
    pub(in crate::identify) null: DMatrix<f64>,
    pub(in crate::identify) iterations: usize,
}

/// Weighted least-squares problem: data and settings.
#[derive(Debug, Clone)]
pub(in crate::identify) struct Problem<'a> {
    pub(in crate::identify) joints: &'a [JointSystem],
    pub(in crate::identify) parameters: usize,
    pub(in crate::identify) prior: &'a [f64],
    pub(in crate::identify) tolerance: f64,
    pub(in crate::identify) weighted: bool,
    pub(in crate::identify) most_iterations: usize,
}

impl Problem<'_> {
    /// Solves for the active parameters, with `weights` (default 1) as initial weights.
    pub(in crate::identify) fn solve(&self, active: &[usize], weights: Option<&[f64]>) -> Solution {
        let prior = DVector::from_fn(active.len(), |i, _| self.prior[active[i]]);
        let mut weights: Vec<f64> = weights.map_or_else(|| vec![1.0; self.joints.len()], <[f64]>::to_vec);
        let mut null: Option<DMatrix<f64>> = None;
        let mut iterations = 0;
        loop {
            iterations += 1;
            let small = Small::new(&stacked(self.joints, &weights, active, self.parameters));
            // The set of determined parameters does not depend on the weights.
            let null = null.get_or_insert_with(|| small.null_space(self.tolerance));
            let root = small.inverse(null);
            let solution = small.solve(&root, null, &prior);
            let inverse_information = &root * root.transpose();
            let mut beta = vec![0.0; self.parameters];
            active.iter().zip(solution.iter()).for_each(|(&c, v)| beta[c] = *v);
            let sigma = self.sigmas(&beta, active, &weights, &inverse_information);
            let next: Vec<f64> = if self.weighted {
                sigma.iter().map(|s| s.recip()).collect()
            } else {
                let samples: usize = self.joints.iter().map(|j| j.samples).sum();
                let squares: f64 = self.joints.iter().zip(&sigma).map(|(j, s)| s * s * j.samples as f64).sum();
                vec![(samples as f64 / squares).sqrt(); self.joints.len()]
            };
            let change = weights.iter().zip(&next).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max);
            let settled = iterations > 1 && (change < 1e-4 || !self.weighted);
            if settled || iterations >= self.most_iterations {
                let null = null.clone();
                let active = active.to_vec();
                return Solution { beta, active, weights, sigma, inverse_information, small, null, iterations };
            }
            weights = next;
        }
    }

    /// Standard deviation of each joint's residual, corrected for the degrees of freedom that the
    /// parameters take from that joint: `sigma_j^2 = |tau_j - W_j beta|^2 / (N_j - w_j^2 tr(A^-1
    /// W_j' W_j))`. It is at least 1e-9 of the torque, so that an exact fit does not get an
    /// infinite weight.
    fn sigmas(&self, beta: &[f64], active: &[usize], weights: &[f64], inverse: &DMatrix<f64>) -> Vec<f64> {
        let position = positions(active, self.parameters);
        self.joints
            .iter()
            .zip(weights)
            .map(|(joint, weight)| {
                let (pairs, n) = (joint.active(&position), joint.columns.len() + 1);
                let mut taken = 0.0;
                for &(i, p) in &pairs {
                    for &(k, q) in &pairs {
                        taken += inverse[(p, q)] * joint.gram[i + k * n];
                    }
                }
                let freedom = (joint.samples as f64 - weight * weight * taken).max(1.0);
                let sigma = joint.residual_norm(beta) / freedom.sqrt();
                sigma.max(1e-9 * joint.torque_rms).max(f64::MIN_POSITIVE.sqrt())
            })
            .collect()
    }
}
