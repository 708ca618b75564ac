//! Computes how well parameters predict the torque of a log.

use crate::identify::regression::accumulator::Factors;

/// Errors per joint; NaN for a joint without torque.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Accuracy {
    /// Root mean square of measured minus predicted torque, N m.
    pub rms: Vec<f64>,
    /// RMS error divided by the range (largest minus smallest) of the measured torque.
    pub nrms: Vec<f64>,
    /// Root mean square of the measured torque, N m.
    pub torque_rms: Vec<f64>,
    /// Number of samples.
    pub samples: Vec<usize>,
}

impl Accuracy {
    /// Error `100 rms / torque_rms` of a joint, percent.
    pub fn percent_of_torque(&self, joint: usize) -> f64 {
        100.0 * self.rms[joint] / self.torque_rms[joint]
    }

    /// Error `100 |error| / |torque|` over all joints and samples, percent.
    pub fn relative_error_percent(&self) -> f64 {
        let norm = |rms: &[f64]| -> f64 {
            let square = |(r, n): (&f64, &usize)| if r.is_nan() { 0.0 } else { r * r * *n as f64 };
            rms.iter().zip(&self.samples).map(square).sum::<f64>().sqrt()
        };
        100.0 * norm(&self.rms) / norm(&self.torque_rms)
    }
}

/// Errors of base parameters `beta` over these logs together.
pub fn accuracy(logs: &[&Factors], beta: &[f64]) -> Accuracy {
    let dof = logs.first().map_or(0, |log| log.joints.len());
    let mut accuracy = Accuracy::default();
    for joint in 0..dof {
        let (mut error, mut torque, mut samples) = (0.0, 0.0, 0);
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        for factor in logs.iter().map(|log| &log.joints[joint]).filter(|f| f.is_live()) {
            error += factor.residual_norm(beta).powi(2);
            torque += factor.torque_rms().powi(2) * factor.samples as f64;
            samples += factor.samples;
            range = [range[0].min(factor.range[0]), range[1].max(factor.range[1])];
        }
        let root = |sum: f64| if samples > 0 { (sum / samples as f64).sqrt() } else { f64::NAN };
        accuracy.rms.push(root(error));
        accuracy.torque_rms.push(root(torque));
        accuracy.nrms.push(root(error) / (range[1] - range[0]));
        accuracy.samples.push(samples);
    }
    accuracy
}
