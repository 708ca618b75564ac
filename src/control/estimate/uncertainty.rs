//! Uncertainty of a model: covariance of its parameters and noise of the torques.

use nalgebra::DMatrix;

use crate::identify::{Identification, Standing};

/// Source of the torque noise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoiseSource {
    /// The residual of an identification.
    Identification,
    /// Residual of the model without contact, all of it counted as noise.
    Free,
    /// Sample-to-sample noise of the torque: model errors are in no band.
    Log,
}

/// Uncertainty of the model's torque. Its errors come from the parameters (constant over a run,
/// different in each identification) and from noise (different at each sample, correlated among
/// neighbouring samples after a low-pass).
#[derive(Debug, Clone, PartialEq)]
pub struct Uncertainty {
    /// Covariance of the base parameters, `B x B`, row-major; zero where it is unknown.
    pub covariance: Vec<f64>,
    /// Standard deviation of each joint's torque noise after the low-pass, N m.
    pub noise: Vec<f64>,
    /// Source of the noise.
    pub source: NoiseSource,
    /// Base parameters that the identification did not determine; their errors are in no band.
    pub open: Vec<String>,
}

impl Uncertainty {
    /// Takes the uncertainty from an identification, on torques with the low-pass of its logs. Its
    /// standard deviations allow for the dependence of neighbouring samples.
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

    /// Takes noise alone; the `parameters` base parameters are assumed exact.
    pub fn noise(noise: Vec<f64>, source: NoiseSource, parameters: usize) -> Self {
        Self { covariance: vec![0.0; parameters * parameters], noise, source, open: Vec::new() }
    }

    /// Root `L` of the covariance, `L L' = C`, `B x rank`; null directions are dropped.
    pub(super) fn root(&self) -> DMatrix<f64> {
        let b = self.covariance.len().isqrt();
        // Decomposes correlations rather than covariances, as parameters range from 1e-4 to 10.
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

/// Covariance from standard deviations and correlations, both `B x B` row-major; entries that are
/// not finite are set to zero.
pub fn covariance(std: &[f64], correlation: &[f64]) -> Vec<f64> {
    let b = std.len();
    let value = |i: usize, j: usize| {
        let r = if i == j { 1.0 } else { correlation.get(i * b + j).copied().unwrap_or(0.0) };
        let c = r * std[i] * std[j];
        if c.is_finite() { c } else { 0.0 }
    };
    (0..b * b).map(|k| value(k / b, k % b)).collect()
}
