//! Uncertainty of a model: the covariance of its parameters, and the noise of the torques.

use nalgebra::DMatrix;

use crate::identify::{Identification, Standing};

/// Source of the torque noise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoiseSource {
    /// The residual of an identification.
    Identification,
    /// Residual of the model where nothing touches, all of it counted as noise.
    Free,
    /// The torque's own noise from sample to sample: the model's errors are in no band.
    Log,
}

/// Errors of the model's torque come from the parameters (constant over a run, drawn again by each
/// identification) and from noise (drawn again at each sample, correlated among neighbours after a
/// low-pass).
#[derive(Debug, Clone, PartialEq)]
pub struct Uncertainty {
    /// Covariance of the base parameters, `B * B`, row-major; zero where nothing is known of it.
    pub covariance: Vec<f64>,
    /// Standard deviation of each joint's torque noise after the low-pass, N m.
    pub noise: Vec<f64>,
    /// Source of that.
    pub source: NoiseSource,
    /// Base parameters that the identification did not determine: their errors are in no band.
    pub open: Vec<String>,
}

impl Uncertainty {
    /// Of an identification, on torques with the low-pass of its logs. Its standard deviations
    /// count neighbouring samples as the dependent ones they are.
    pub fn of(found: &Identification) -> Self {
        let std: Vec<f64> = found.parameters.iter().map(|p| p.std).collect();
        let open = found.parameters.iter().filter(|p| p.standing == Standing::NotIdentifiable);
        Self {
            covariance: covariance(&std, &found.correlation),
            noise: found.noise.sigma.clone(),
            source: NoiseSource::Identification,
            open: open.map(|p| p.name.clone()).collect(),
        }
    }

    /// Of noise alone: the parameters (`B`) are taken to be exact.
    pub fn noise(noise: Vec<f64>, source: NoiseSource, parameters: usize) -> Self {
        Self { covariance: vec![0.0; parameters * parameters], noise, source, open: Vec::new() }
    }

    /// `L` with `L L' = C`, `B x rank`: the columns that matter.
    pub(super) fn root(&self) -> DMatrix<f64> {
        let b = self.covariance.len().isqrt();
        // Parameters have sizes from 1e-4 to 10: correlations are decomposed, not covariances.
        let std: Vec<f64> = (0..b).map(|i| self.covariance[i * b + i].max(0.0).sqrt()).collect();
        let scaled = DMatrix::from_fn(b, b, |i, j| {
            let size = std[i] * std[j];
            if size > 0.0 { 0.5 * (self.covariance[i * b + j] + self.covariance[j * b + i]) / size } else { 0.0 }
        });
        let eigen = scaled.symmetric_eigen();
        let kept: Vec<usize> = (0..b).filter(|&k| eigen.eigenvalues[k] > 1e-12).collect();
        DMatrix::from_fn(b, kept.len(), |i, k| {
            std[i] * eigen.eigenvectors[(i, kept[k])] * eigen.eigenvalues[kept[k]].sqrt()
        })
    }
}

/// From standard deviations and correlations (`B * B`); entries that are not finite are set to
/// zero.
pub fn covariance(std: &[f64], correlation: &[f64]) -> Vec<f64> {
    let b = std.len();
    let value = |i: usize, j: usize| {
        let r = if i == j { 1.0 } else { correlation.get(i * b + j).copied().unwrap_or(0.0) };
        let c = r * std[i] * std[j];
        if c.is_finite() { c } else { 0.0 }
    };
    (0..b * b).map(|k| value(k / b, k % b)).collect()
}
