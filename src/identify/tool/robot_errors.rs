//! Propagates the errors of a previously identified robot to the parameters of its load.

use nalgebra::DMatrix;

use crate::identify::{Factors, Identification, Standing};

/// Singular value, among columns of unit norm, below which a direction counts as undetermined.
const OPEN: f64 = 1e-9;

/// Adds the covariance due to the known parameters.
///
/// With `x = A^-1 sum_j w_j^2 W_uj' (tau_j - W_kj beta_k)` an error of `beta_k` changes `x` by
/// `-A^-1 M` times it, `M = sum_j w_j^2 W_uj' W_kj`. Known parameters of covariance `C` therefore
/// add `A^-1 M C M' A^-1`: first-order propagation, exact here, as the model is linear.
///
/// `logs`: factors over all columns. `unknown`: whether each column was solved for, in the order of
/// the parameters of `solved`. `covariance`: of the first columns, row-major.
pub(super) fn add(solved: &mut Identification, logs: &[Factors], unknown: &[bool], covariance: &[f64]) {
    let n = (covariance.len() as f64).sqrt().round() as usize;
    let columns: Vec<usize> = (0..unknown.len()).filter(|&c| unknown[c]).collect();
    let known: Vec<usize> = (0..n).filter(|&c| !unknown[c]).collect();
    let normal = normal_matrix(logs, &solved.noise.sigma, unknown.len());
    let root = |c: usize| match normal[(c, c)].sqrt() {
        0.0 => 0.0,
        norm => norm.recip(),
    };
    let scaled = DMatrix::from_fn(columns.len(), columns.len(), |i, k| {
        normal[(columns[i], columns[k])] * root(columns[i]) * root(columns[k])
    });
    let Ok(inverse) = scaled.pseudo_inverse(OPEN) else { return };
    let mixed = DMatrix::from_fn(columns.len(), known.len(), |i, k| root(columns[i]) * normal[(columns[i], known[k])]);
    let scale = DMatrix::from_diagonal(&nalgebra::DVector::from_fn(columns.len(), |i, _| root(columns[i])));
    let gain = scale * inverse * mixed;
    let of_known = DMatrix::from_fn(known.len(), known.len(), |i, k| covariance[known[i] * n + known[k]]);
    widen(solved, &(&gain * of_known * gain.transpose()));
}

/// Normal matrix `sum_j w_j^2 W_j' W_j` over all columns, each joint weighted by its noise.
fn normal_matrix(logs: &[Factors], sigma: &[f64], columns: usize) -> DMatrix<f64> {
    let mut normal = DMatrix::zeros(columns, columns);
    for log in logs {
        for (joint, sigma) in log.joints.iter().zip(sigma).filter(|(joint, s)| joint.is_live() && **s > 0.0) {
            let (gram, size) = (joint.triangle.gram(), joint.columns.len() + 1);
            for (i, &row) in joint.columns.iter().enumerate() {
                for (k, &column) in joint.columns.iter().enumerate() {
                    normal[(row, column)] += gram[i + k * size] / (sigma * sigma);
                }
            }
        }
    }
    normal
}

/// Adds `more` to the covariance of the determined parameters.
fn widen(solved: &mut Identification, more: &DMatrix<f64>) {
    let count = solved.parameters.len();
    let determined: Vec<bool> = solved.parameters.iter().map(|p| p.standing == Standing::Identified).collect();
    let before: Vec<f64> = solved.parameters.iter().map(|p| p.std).collect();
    for (i, p) in solved.parameters.iter_mut().enumerate().filter(|(i, _)| determined[*i]) {
        p.std = (before[i] * before[i] + more[(i, i)].max(0.0)).sqrt();
    }
    for i in (0..count).filter(|&i| determined[i]) {
        for k in (0..count).filter(|&k| determined[k] && k != i) {
            let both = solved.correlation[i * count + k] * before[i] * before[k] + more[(i, k)];
            let scale = solved.parameters[i].std * solved.parameters[k].std;
            solved.correlation[i * count + k] = if scale > 0.0 { both / scale } else { 0.0 };
        }
    }
}
