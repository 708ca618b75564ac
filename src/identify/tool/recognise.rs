//! Finds the tool in the table, or rejects all of them.
//!
//! Computes two distances. The paper's is the norm of the difference in the space of [`Pca`], where
//! a kilogram counts as much as a kilogram square metre. The other is that of Mahalanobis, `d^2 =
//! (a - b)' (C + C_j)^-1 (a - b)`, with the covariance `C` of the identification and `C_j` of the
//! table: each difference is weighted by its uncertainty. The second decides, over all identified
//! parameters, because its distribution is known. For the right tool `d^2 / k` is distributed as
//! `F(k, nu)` (Hotelling 1931, for a covariance whose scale was estimated), so that a limit rejects
//! the right tool with a chosen probability.

use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, FisherSnedecor};

use super::identify::Carried;
use super::pca::Pca;
use super::table::Entry;

/// Settings of the recognition.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RecogniseSettings {
    /// Share of the table's sum of squares that the components of the paper's space retain. Default
    /// 0.99999.
    pub share: f64,
    /// Probability of rejecting a tool that is in the table. Default 0.01.
    pub level: f64,
}

impl Default for RecogniseSettings {
    fn default() -> Self {
        Self { share: 0.99999, level: 0.01 }
    }
}

/// A tool of the table compared with the identified body.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// Name of the tool.
    pub name: String,
    /// Index in the table.
    pub entry: usize,
    /// Mahalanobis distance over all determined parameters.
    pub distance: f64,
    /// Mahalanobis distance in the reduced space.
    pub distance_in_space: f64,
    /// Distance of the paper: Euclidean norm in the reduced space.
    pub plain_distance: f64,
    /// Posterior probability, assuming that the body is one of the table's tools, all equally
    /// likely a priori.
    pub probability: f64,
    /// Difference of each parameter (identified minus table) in standard deviations; NaN if
    /// undetermined.
    pub deviations: [f64; 10],
}

/// Result of the recognition.
#[derive(Debug, Clone, PartialEq)]
pub struct Recognition {
    /// All tools, nearest first.
    pub candidates: Vec<Candidate>,
    /// Mahalanobis distance beyond which a tool is rejected.
    pub limit: f64,
    /// Whether all tools are rejected.
    pub rejected: bool,
    /// Other tools that fit nearly as well: probability above 0.05 and within the limit.
    pub not_distinguished_from: Vec<String>,
    /// Nearest tool by the paper's distance, which has no rejection limit.
    pub by_plain_distance: String,
    /// Number of determined parameters, `k`.
    pub determined: usize,
    /// Degrees of freedom of the covariance's scale, `nu`.
    pub freedom: f64,
    /// Level for which the limit was chosen.
    pub level: f64,
    /// Reduced space.
    pub pca: Pca,
    /// Identified parameters in the reduced space.
    pub scores: DVector<f64>,
    /// Covariance of the scores.
    pub score_covariance: DMatrix<f64>,
    /// Coordinates of each tool in the reduced space, in the order of the table.
    pub table_scores: Vec<DVector<f64>>,
}

impl Recognition {
    /// Nearest tool.
    pub fn nearest(&self) -> &Candidate {
        &self.candidates[0]
    }
}

/// Looks the tool up; `None` for an empty table or without any determined parameter.
pub fn recognise(carried: &Carried, table: &[Entry], settings: &RecogniseSettings) -> Option<Recognition> {
    let which: Vec<usize> = (0..10).filter(|&k| carried.determined()[k]).collect();
    if table.is_empty() || which.is_empty() {
        return None;
    }
    let visible =
        |values: &[f64; 10]| -> [f64; 10] { std::array::from_fn(|k| if which.contains(&k) { values[k] } else { 0.0 }) };
    let rows: Vec<[f64; 10]> = table.iter().map(|e| visible(&e.values)).collect();
    let (pca, here) = (Pca::new(&rows, settings.share), visible(&carried.values));
    let freedom = scale_freedom(carried);
    let limit = limit(which.len(), freedom, settings.level);
    let mut candidates: Vec<Candidate> = Vec::new();
    let mut densities = Vec::new();
    for (entry, tool) in table.iter().enumerate() {
        let sum = |i: usize, k: usize| carried.covariance[10 * i + k] + tool.covariance[(i, k)];
        let difference: [f64; 10] = std::array::from_fn(|k| here[k] - rows[entry][k]);
        let n = which.len();
        let covariance = DMatrix::from_fn(n, n, |i, k| sum(which[i], which[k]));
        let delta = DVector::from_fn(n, |i, _| difference[which[i]]);
        let Some((squared, log_det)) = mahalanobis(&delta, &covariance) else { continue };
        let whole =
            DMatrix::from_fn(10, 10, |i, k| if which.contains(&i) && which.contains(&k) { sum(i, k) } else { 0.0 });
        let in_space = pca.basis.transpose() * whole * &pca.basis;
        let scores = pca.basis.transpose() * DVector::from_column_slice(&difference);
        densities.push(-0.5 * (squared + log_det));
        candidates.push(Candidate {
            name: tool.name.clone(),
            entry,
            distance: squared.sqrt(),
            distance_in_space: mahalanobis(&scores, &in_space).map_or(f64::NAN, |(d, _)| d.sqrt()),
            plain_distance: scores.norm(),
            probability: 0.0,
            deviations: std::array::from_fn(|k| {
                if which.contains(&k) { difference[k] / sum(k, k).sqrt() } else { f64::NAN }
            }),
        });
    }
    let most = densities.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let total: f64 = densities.iter().map(|d| (d - most).exp()).sum();
    candidates.iter_mut().zip(&densities).for_each(|(c, d)| c.probability = (d - most).exp() / total);
    let by_plain_distance =
        candidates.iter().min_by(|a, b| a.plain_distance.total_cmp(&b.plain_distance))?.name.clone();
    candidates.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    let rejected = candidates.first()?.distance > limit;
    let others = candidates[1..].iter().filter(|c| c.distance <= limit && c.probability > 0.05);
    let not_distinguished_from = if rejected { Vec::new() } else { others.map(|c| c.name.clone()).collect() };
    let own = DMatrix::from_fn(10, 10, |i, k| carried.covariance[10 * i + k]);
    Some(Recognition {
        limit,
        rejected,
        not_distinguished_from,
        by_plain_distance,
        determined: which.len(),
        freedom,
        level: settings.level,
        scores: pca.scores(&here),
        score_covariance: pca.basis.transpose() * own * &pca.basis,
        table_scores: rows.iter().map(|row| pca.scores(row)).collect(),
        candidates,
        pca,
    })
}

/// Degrees of freedom of the scale of the covariance. The scale is estimated from the batches of
/// the joints (see `identify::statistics`), each of which gives about one independent number.
pub(super) fn scale_freedom(carried: &Carried) -> f64 {
    (carried.noise.batches.iter().sum::<usize>() as f64).clamp(1.0, carried.freedom.max(1.0))
}

/// Distance that the right tool exceeds with this probability.
pub(super) fn limit(count: usize, freedom: f64, level: f64) -> f64 {
    let k = count as f64;
    FisherSnedecor::new(k, freedom).map_or(f64::INFINITY, |law| (k * law.inverse_cdf(1.0 - level)).sqrt())
}

/// Values `x' C^-1 x` and `log det C`; `None` if `C` is not positive definite.
pub(super) fn mahalanobis(x: &DVector<f64>, covariance: &DMatrix<f64>) -> Option<(f64, f64)> {
    let n = x.len();
    // In standard deviations, so that all numbers are of similar size.
    let scale = DVector::from_fn(n, |i, _| covariance[(i, i)].max(f64::MIN_POSITIVE).sqrt());
    let correlation =
        DMatrix::from_fn(n, n, |i, k| covariance[(i, k)] / (scale[i] * scale[k]) + if i == k { 1e-10 } else { 0.0 });
    let root = correlation.cholesky()?;
    let y = root.l().solve_lower_triangular(&x.component_div(&scale))?;
    let log_det = 2.0 * (0..n).map(|i| root.l()[(i, i)].ln() + scale[i].ln()).sum::<f64>();
    let squared = y.norm_squared();
    (squared.is_finite() && log_det.is_finite()).then_some((squared, log_det))
}

#[cfg(test)]
mod tests {
    /// For one number with many degrees of freedom: the normal distribution's two-sided limits.
    #[test]
    fn a_limit_is_exceeded_with_its_probability() {
        for (level, expected) in [(0.05, 1.960), (0.01, 2.576), (0.3173, 1.0)] {
            let limit = super::limit(1, 1e6, level);
            assert!((limit - expected).abs() < 1e-3, "{level}: {limit}");
        }
    }
}
