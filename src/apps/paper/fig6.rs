//! Fig. 6: torque errors on the validating motion for the models identified from the motions of
//! three criteria.

use super::ReproduceError;
use super::Watch;
use super::chain::{factors, fit};
use super::honesty::STRIDE;
use super::lwr::Lwr;
use super::many::many;
use super::motions::LINKS;
use super::verdict::Verdict;
use crate::identify::{Accuracy, Factors, Identification, accuracy};
use crate::simulate::Recording;

/// The paper's RMS difference averaged over the joints, N m (section III.E), for `J_c`, `J_d` and
/// `J_h`; last, `J_c` again, for the motion by the links' columns alone.
pub const PAPER: [(&str, f64); 4] = [("cond", 0.69), ("logdet", 0.42), ("hadamard", 0.45), (LINKS, 0.69)];

/// Share by which the held-out RMS may exceed the floor before a model counts as incomplete.
pub const ABOVE_FLOOR: f64 = 0.05;

/// Errors of one model on the validating motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Bars {
    /// Root mean square of measured minus estimated torque, N m, per joint.
    pub rms: Vec<f64>,
    /// The same relative to the range of the measured torque.
    pub nrms: Vec<f64>,
    /// Contribution of the parameters' own standard deviations, N m, per joint.
    pub uncertainty: Vec<f64>,
}

impl Bars {
    /// Takes the errors from an identification and the factors of its validation.
    pub fn new(found: &Identification, validate: &Factors) -> Self {
        let Accuracy { rms, nrms, .. } = found.validation.clone().unwrap_or_default();
        Self { rms, nrms, uncertainty: uncertainty(found, validate) }
    }

    /// Mean over the joints, N m.
    pub fn mean(&self) -> f64 {
        mean(&self.rms)
    }
}

/// Torque error to expect from parameters with their stated uncertainty: `sqrt(tr(W C W') / N)` of
/// each joint's equations `W`, with the covariance `C` of the parameters.
fn uncertainty(found: &Identification, validate: &Factors) -> Vec<f64> {
    let p = found.parameters.len();
    let covariance = |i: usize, k: usize| {
        let value = found.correlation[i * p + k] * found.parameters[i].std * found.parameters[k].std;
        if value.is_finite() { value } else { 0.0 }
    };
    let joint = |factor: &crate::identify::JointFactor| {
        let n = factor.columns.len();
        let gram = factor.triangle.gram();
        let mut sum = 0.0_f64;
        for (a, &i) in factor.columns.iter().enumerate() {
            for (b, &k) in factor.columns.iter().enumerate() {
                sum += gram[a + b * (n + 1)] * covariance(i, k);
            }
        }
        (sum.max(0.0) / factor.samples.max(1) as f64).sqrt()
    };
    validate.joints.iter().map(joint).collect()
}

/// Number of runs of [`again`].
pub const RUNS: usize = 12;

/// Errors of the noise-only case averaged over [`RUNS`] runs, each with other noise in the fitted
/// logs and in the validating one.
pub struct Again {
    /// RMS of the true parameters, N m, per joint: the noise plus the error of the processing
    /// chain.
    pub truth: Vec<f64>,
    /// RMS and NRMS for each motion, per joint.
    pub motions: Vec<[Vec<f64>; 2]>,
}

/// Repeats identification and validation with other noise; the last recording validates, the others
/// are fitted.
pub fn again(lwr: &Lwr, recordings: &[Recording], seed: u64, watch: Watch<'_>) -> Result<Again, ReproduceError> {
    let Some((validating, fitted)) = recordings.split_last() else {
        return Ok(Again { truth: Vec::new(), motions: Vec::new() });
    };
    let noisy =
        |recording: &Recording, seed: u64| factors("run", &lwr.arm, &recording.seen_by(&Lwr::sensors(), seed), STRIDE);
    let one = |run: usize| {
        let seed = seed.wrapping_add(100 * run as u64);
        let validate = noisy(validating, seed)?;
        let truth = accuracy(&[&validate], &lwr.truth);
        let mut all = vec![[truth.rms, truth.nrms]];
        for (k, recording) in (1..).zip(fitted) {
            let found = fit(lwr, &noisy(recording, seed.wrapping_add(k))?, &validate)?;
            let Accuracy { rms, nrms, .. } = found.validation.unwrap_or_default();
            all.push([rms, nrms]);
        }
        Ok(all)
    };
    let runs = many(RUNS, &one, watch)?;
    let over = |which: usize, what: usize| -> Vec<f64> {
        (0..lwr.robot.dof()).map(|j| runs.iter().map(|r| r[which][what][j]).sum::<f64>() / RUNS as f64).collect()
    };
    Ok(Again { truth: over(0, 0), motions: (1..=fitted.len()).map(|k| [over(k, 0), over(k, 1)]).collect() })
}

/// Results for one criterion.
#[derive(Debug, Clone, PartialEq)]
pub struct Fig6Row {
    /// `cond`, `logdet`, `hadamard` or [`LINKS`].
    pub criterion: &'static str,
    /// The paper's average over the joints, N m.
    pub paper: f64,
    /// Errors for the robot with noise alone.
    pub noise_only: Bars,
    /// Errors for the robot with effects that the model lacks.
    pub unmodelled: Bars,
    /// Known noise floor, N m, per joint.
    pub floor: Vec<f64>,
    /// RMS of the true parameters on the same logs, N m, per joint: the noise plus the error of the
    /// processing chain.
    pub true_parameters: Vec<f64>,
}

impl Fig6Row {
    /// Excess of the noise-only average over the floor, as a share of the floor.
    pub fn above_floor(&self) -> f64 {
        self.noise_only.mean() / mean(&self.floor) - 1.0
    }

    /// Part of that excess that the true parameters show as well, and part due to the parameters'
    /// uncertainty: shares of the floor.
    pub fn explained(&self) -> [f64; 2] {
        let floor = mean(&self.floor);
        let with = |k: usize| self.true_parameters[k].hypot(self.noise_only.uncertainty[k]);
        let both = mean(&(0..self.floor.len()).map(with).collect::<Vec<_>>());
        let chain = mean(&self.true_parameters);
        [chain / floor - 1.0, (both - chain) / floor]
    }

    /// Whether the noise-only case is at the floor.
    pub fn at_floor(&self) -> Verdict {
        Verdict::at_most(self.noise_only.mean(), (1.0 + ABOVE_FLOOR) * mean(&self.floor))
    }

    /// Comparison with the paper, with effects that the model lacks. Their sizes are the same for
    /// all three criteria, so the order of the criteria is more reliable than the values.
    pub fn verdict(&self) -> Verdict {
        Verdict::less(self.unmodelled.mean(), self.paper)
    }
}

/// Arithmetic mean.
pub fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

/// Criteria from best to worst, ours and the paper's. Criteria with equal figures in the paper keep
/// our order.
pub fn order(rows: &[Fig6Row]) -> [Vec<&'static str>; 2] {
    let mut all: Vec<&Fig6Row> = rows.iter().collect();
    all.sort_by(|a, b| a.unmodelled.mean().total_cmp(&b.unmodelled.mean()));
    let ours = all.iter().map(|r| r.criterion).collect();
    all.sort_by(|a, b| a.paper.total_cmp(&b.paper));
    [ours, all.iter().map(|r| r.criterion).collect()]
}
