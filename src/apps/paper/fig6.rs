//! Fig. 6: torque errors on the motion that validates, for the models that three criteria's motions
//! gave.

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

/// Averages over the joints of the RMS difference, N m (section III.E): by `J_c`, `J_d`, `J_h`;
/// `J_c` again for the links' columns alone.
pub const PAPER: [(&str, f64); 4] = [("cond", 0.69), ("logdet", 0.42), ("hadamard", 0.45), (LINKS, 0.69)];

/// Held-out RMS above the floor by more than this share is said to miss something.
pub const ABOVE_FLOOR: f64 = 0.05;

/// One model on the motion that validates.
#[derive(Debug, Clone, PartialEq)]
pub struct Bars {
    /// Root mean square of measured less estimated torque, N m, per joint.
    pub rms: Vec<f64>,
    /// That by the range of the measured torque.
    pub nrms: Vec<f64>,
    /// Contribution of the parameters' own standard deviations, N m, per joint.
    pub uncertainty: Vec<f64>,
}

impl Bars {
    /// From an identification and the factors that it was validated on.
    pub fn new(found: &Identification, validate: &Factors) -> Self {
        let Accuracy { rms, nrms, .. } = found.validation.clone().unwrap_or_default();
        Self { rms, nrms, uncertainty: uncertainty(found, validate) }
    }

    /// Mean over the joints, N m.
    pub fn mean(&self) -> f64 {
        mean(&self.rms)
    }
}

/// `sqrt(tr(W C W') / N)` of each joint's equations `W`, `C` the covariance of the parameters: the
/// torque error to expect of parameters that are as uncertain as they say.
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

/// Runs of [`again`].
pub const RUNS: usize = 12;

/// Errors of the noise-only case without one log's luck: mean over [`RUNS`] runs with other noise
/// in the logs that are fitted and in the one that validates.
pub struct Again {
    /// RMS of the true parameters, N m, per joint: the noise, and what the chain adds.
    pub truth: Vec<f64>,
    /// Per motion: RMS and NRMS, per joint.
    pub motions: Vec<[Vec<f64>; 2]>,
}

/// The last recording validates, the others are fitted.
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

/// A criterion's row.
#[derive(Debug, Clone, PartialEq)]
pub struct Fig6Row {
    /// `cond`, `logdet`, `hadamard`.
    pub criterion: &'static str,
    /// The paper's average, N m.
    pub paper: f64,
    /// The robot with noise alone.
    pub noise_only: Bars,
    /// The robot with effects that the model has not.
    pub unmodelled: Bars,
    /// Known noise floor, N m, per joint.
    pub floor: Vec<f64>,
    /// RMS of the true parameters on the same logs, N m, per joint: the noise, and what the chain
    /// itself adds.
    pub true_parameters: Vec<f64>,
}

impl Fig6Row {
    /// Average of the noise-only case above the floor, as a share of it.
    pub fn above_floor(&self) -> f64 {
        self.noise_only.mean() / mean(&self.floor) - 1.0
    }

    /// The part of it that the true parameters show as well, and the part of the parameters'
    /// uncertainty: shares of the floor.
    pub fn explained(&self) -> [f64; 2] {
        let floor = mean(&self.floor);
        let with = |k: usize| self.true_parameters[k].hypot(self.noise_only.uncertainty[k]);
        let both = mean(&(0..self.floor.len()).map(with).collect::<Vec<_>>());
        let chain = mean(&self.true_parameters);
        [chain / floor - 1.0, (both - chain) / floor]
    }

    /// Of the noise-only case: is it at the floor?
    pub fn at_floor(&self) -> Verdict {
        Verdict::at_most(self.noise_only.mean(), (1.0 + ABOVE_FLOOR) * mean(&self.floor))
    }

    /// Against the paper, with effects that the model has not. Their sizes are the same for all
    /// three criteria, so the order of the criteria is more reliable than the size.
    pub fn verdict(&self) -> Verdict {
        Verdict::less(self.unmodelled.mean(), self.paper)
    }
}

/// Arithmetic mean.
pub fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

/// The criteria from best to worst, ours and the paper's; what the paper has one figure for stands
/// there as in ours.
pub fn order(rows: &[Fig6Row]) -> [Vec<&'static str>; 2] {
    let mut all: Vec<&Fig6Row> = rows.iter().collect();
    all.sort_by(|a, b| a.unmodelled.mean().total_cmp(&b.unmodelled.mean()));
    let ours = all.iter().map(|r| r.criterion).collect();
    all.sort_by(|a, b| a.paper.total_cmp(&b.paper));
    [ours, all.iter().map(|r| r.criterion).collect()]
}
