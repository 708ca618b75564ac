//! Which cause a change has, and how sure that is.
//!
//! Days differ without a cause: friction, offsets and loads wander. So the torque error of a day is
//! a linear mixed model, `e = B (m + u) + r`: `B` holds the torques of unit changes (channels),
//! `m` the robot's mean, `u` the day's own values with a variance per channel, and `r` the rest with
//! a variance per joint. The days before the change give the variances (restricted likelihood, by
//! the MM algorithm of Zhou, Hu, Zhou and Lange, Journal of Computational and Graphical Statistics
//! 28, 2019). After the change `m + c` replaces `m`, where only the channels of one cause are in `c`.
//! Generalised least squares then weighs what wanders anyway as little as it deserves.
//!
//! Causes are compared by their marginal likelihoods: Zellner's prior on `c`, of as many scatters as
//! the sequential test assumes, and one unknown factor on all variances, because those come from
//! some days. A change that no cause explains well thus leaves several probable.

use std::borrow::Cow;

use nalgebra::{DMatrix, DVector, SymmetricEigen};
use serde::{Deserialize, Serialize};

use crate::channel::{Channel, Kind};

/// A cause at least as probable is named alone; otherwise it can't be told from the next.
pub const CERTAIN: f64 = 0.9;

/// Rounds of the MM algorithm: variances need one digit.
const ROUNDS: usize = 30;

/// Least variance of a channel, in those of its noise on a day: smaller ones change no weight.
const LEAST: f64 = 1e-6;

/// Added to the diagonal, as a share of it, where channels show the same.
const RIDGE: f64 = 1e-6;

/// Days before a change that are used.
const MOST_DAYS: usize = 60;

/// What one joint shows of the channels on one day.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct JointEvidence {
    /// Indices of channels.
    pub channels: Vec<usize>,
    /// Inner products of their torques.
    pub gram: DMatrix<f64>,
    /// Inner products with the residual.
    pub score: DVector<f64>,
    /// Square of the residual.
    pub square: f64,
    /// Its length.
    pub rows: usize,
}

/// What a day shows of the channels, joint by joint, in units of the reference's noise.
#[derive(Debug, Clone, PartialEq)]
pub struct DayEvidence(pub(crate) Vec<JointEvidence>);

/// By how much a cause changes a parameter.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ParameterChange {
    /// `FC3`, `gain3`, `MSX7`.
    pub parameter: String,
    /// Change; the other parameters of the cause change with it.
    pub value: f64,
    /// Standard deviation, with the scatter from day to day in it.
    pub std: f64,
    /// Unit of both; empty for a gain.
    pub unit: Cow<'static, str>,
}

/// A cause that may explain a change: channels of one kind and place together.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Explanation {
    /// Kind.
    pub kind: Kind,
    /// Joint or link, from 1.
    pub joint: usize,
    /// Probability that it is this one, if it is one of the list.
    pub probability: f64,
    /// Share of the change that it explains alone, 0 to 1: squares in units of the scatter.
    pub share: f64,
    /// Changes of its parameters.
    pub changes: Vec<ParameterChange>,
}

/// The change of a cause that is largest in its standard deviations.
pub fn clearest(cause: &Explanation) -> Option<&ParameterChange> {
    let size = |by: &ParameterChange| if by.std > 0.0 { (by.value / by.std).abs() } else { 0.0 };
    cause.changes.iter().max_by(|a, b| size(a).total_cmp(&size(b)))
}

/// Assumptions on days and changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Assumptions {
    /// Variance of a change before it is seen, in scatters of a day squared.
    pub change: f64,
    /// Correlation of neighbouring days.
    pub correlation: f64,
}

/// Causes of what changed between days before and days after, most probable first. Empty where
/// there are too few days.
pub fn explanations(
    channels: &[Channel],
    before: &[DayEvidence],
    after: &[DayEvidence],
    assumptions: Assumptions,
) -> Vec<Explanation> {
    let before = &before[before.len().saturating_sub(MOST_DAYS)..];
    if before.len() < 3 || after.is_empty() {
        return Vec::new();
    }
    let mut variances = Variances::start(channels.len(), before);
    (0..ROUNDS).for_each(|_| variances.improve(before));
    // Means of days that follow each other scatter more than those of independent ones.
    let rho = assumptions.correlation.clamp(0.0, 0.9);
    variances.deviations *= ((1.0 + rho) / (1.0 - rho)).sqrt();
    let difference = variances.difference(before, after);
    let days = [before.len() as f64, after.len() as f64];
    let wide = 1.0 + assumptions.change * days[0] * days[1] / (days[0] + days[1]);
    let all: Vec<usize> = (0..channels.len()).collect();
    let whole = difference.fit(&all);
    let mut places: Vec<(Kind, usize)> = channels.iter().map(|c| (c.kind, c.joint)).collect();
    places.sort_unstable();
    places.dedup();
    let explain = |&(kind, joint): &(Kind, usize)| {
        let own: Vec<usize> =
            (0..channels.len()).filter(|&k| (channels[k].kind, channels[k].joint) == (kind, joint)).collect();
        let fit = difference.fit(&own);
        let (freedom, rank) = (days[0] - 1.0, fit.rank as f64);
        let left = (whole.square - (1.0 - 1.0 / wide) * fit.square).max(0.0);
        let log = -0.5 * rank * wide.ln() - 0.5 * (freedom + whole.rank as f64) * (freedom + left).ln();
        let explained = (fit.square - rank).max(0.0);
        let share = explained / (whole.square - whole.rank as f64).max(explained).max(f64::MIN_POSITIVE);
        let change = |(at, &k): (usize, &usize)| ParameterChange {
            parameter: channels[k].parameter.clone(),
            value: fit.values[at],
            std: fit.stds[at],
            unit: channels[k].unit.into(),
        };
        let changes = own.iter().enumerate().map(change).collect();
        Explanation { kind, joint, probability: log, share, changes }
    };
    let mut found: Vec<Explanation> = places.iter().map(explain).collect();
    let best = found.iter().map(|f| f.probability).fold(f64::NEG_INFINITY, f64::max);
    found.iter_mut().for_each(|f| f.probability = (f.probability - best).exp());
    let sum: f64 = found.iter().map(|f| f.probability).sum();
    found.iter_mut().for_each(|f| f.probability /= sum);
    found.sort_by(|a, b| b.probability.total_cmp(&a.probability).then(b.share.total_cmp(&a.share)));
    found
}

/// Variances of the mixed model.
struct Variances {
    /// Per channel: standard deviation of a day's own value.
    deviations: DVector<f64>,
    /// Least of them.
    least: DVector<f64>,
    /// Per joint: variance of the rest.
    rest: Vec<f64>,
}

/// A day with its own values integrated out, in units of the deviations.
struct Integrated {
    /// Information on the day's mean.
    information: DMatrix<f64>,
    /// Information times estimate.
    score: DVector<f64>,
    /// Covariance of the day's own values, given its data.
    posterior: DMatrix<f64>,
}

impl Variances {
    /// From each channel alone, which is too much: it has the scatter of the others in it.
    fn start(channels: usize, days: &[DayEvidence]) -> Self {
        let joints = days.iter().map(|day| day.0.len()).max().unwrap_or(0);
        let ones = vec![1.0; joints];
        let grams: Vec<(DMatrix<f64>, DVector<f64>)> = days.iter().map(|day| day.sums(channels, &ones)).collect();
        let count = days.len() as f64;
        let information =
            DVector::from_fn(channels, |k, _| grams.iter().map(|(gram, _)| gram[(k, k)]).sum::<f64>() / count);
        let noise = information.map(|i| if i > 0.0 { i.recip().sqrt() } else { 0.0 });
        let alone = |k: usize| -> f64 {
            let shown = grams.iter().filter(|(gram, _)| gram[(k, k)] > 0.0);
            let values: Vec<f64> = shown.map(|(gram, score)| score[k] / gram[(k, k)]).collect();
            let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
            (values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / values.len().max(1) as f64).sqrt()
        };
        let least = &noise * LEAST.sqrt();
        let deviations = DVector::from_fn(channels, |k, _| alone(k).max(noise[k]));
        Self { deviations, least, rest: ones }
    }

    /// One round.
    fn improve(&mut self, days: &[DayEvidence]) {
        let all: Vec<Integrated> = days.iter().map(|day| self.integrated(day)).collect();
        let [information, score] = sums(&all);
        let Some(covariance) = inverse(&information) else { return };
        let mean = &covariance * score;
        let channels = self.deviations.len();
        let (mut seen, mut expected) = (DVector::<f64>::zeros(channels), DVector::<f64>::zeros(channels));
        let mut rest = vec![[0.0_f64; 2]; self.rest.len()];
        for (day, one) in days.iter().zip(&all) {
            let own = &one.score - &one.information * &mean;
            let used = &covariance * &one.information;
            for k in 0..channels {
                seen[k] += own[k] * own[k];
                expected[k] += one.information[(k, k)] - one.information.column(k).dot(&used.column(k));
            }
            let values = (&mean + &own).component_mul(&self.deviations);
            for (j, joint) in day.0.iter().enumerate() {
                let own = DVector::from_fn(joint.channels.len(), |a, _| values[joint.channels[a]]);
                let left = joint.square - 2.0 * joint.score.dot(&own) + own.dot(&(&joint.gram * &own));
                let entry = |a: usize, b: usize| {
                    let (k, m) = (joint.channels[a], joint.channels[b]);
                    joint.gram[(a, b)] * self.deviations[k] * one.posterior[(k, m)] * self.deviations[m]
                };
                let size = joint.channels.len();
                let taken: f64 = (0..size).map(|a| (0..size).map(|b| entry(a, b)).sum::<f64>()).sum();
                rest[j][0] += left.max(0.0) / self.rest[j];
                rest[j][1] += joint.rows as f64 - taken / self.rest[j];
            }
        }
        for k in 0..channels {
            let ratio = if expected[k] > 0.0 { seen[k] / expected[k] } else { 0.0 };
            // The root of the root: these are deviations.
            self.deviations[k] = (self.deviations[k] * ratio.sqrt().sqrt()).max(self.least[k]);
        }
        for (variance, [seen, expected]) in self.rest.iter_mut().zip(rest) {
            if seen > 0.0 && expected > 0.0 {
                *variance *= (seen / expected).sqrt();
            }
        }
    }

    fn integrated(&self, day: &DayEvidence) -> Integrated {
        let (mut gram, mut score) = day.sums(self.deviations.len(), &self.rest);
        for k in 0..gram.nrows() {
            score[k] *= self.deviations[k];
            for m in 0..gram.ncols() {
                gram[(k, m)] *= self.deviations[k] * self.deviations[m];
            }
            gram[(k, k)] += 1.0;
        }
        let size = gram.nrows();
        let posterior = gram.cholesky().map_or_else(|| DMatrix::identity(size, size), |factored| factored.inverse());
        let information = DMatrix::identity(size, size) - &posterior;
        Integrated { information, score: &posterior * score, posterior }
    }

    /// What days before and after say of a change of the mean.
    fn difference(&self, before: &[DayEvidence], after: &[DayEvidence]) -> Difference {
        let all = |days: &[DayEvidence]| sums(&days.iter().map(|day| self.integrated(day)).collect::<Vec<_>>());
        let ([before, before_score], [after, after_score]) = (all(before), all(after));
        let (mut information, mut score) = (DMatrix::zeros(after.nrows(), after.ncols()), after_score.clone());
        if let Some(covariance) = inverse(&(&before + &after)) {
            let shared = &after * covariance;
            information = &after - &shared * &after;
            score = &after_score - shared * (before_score + &after_score);
        }
        Difference { information, score: score.column(0).into_owned(), units: self.deviations.clone() }
    }
}

/// Sums over days, the score as a matrix of one column.
fn sums(days: &[Integrated]) -> [DMatrix<f64>; 2] {
    let size = days.first().map_or(0, |day| day.score.len());
    let (mut information, mut score) = (DMatrix::zeros(size, size), DMatrix::zeros(size, 1));
    for day in days {
        information += &day.information;
        score += &day.score;
    }
    [information, score]
}

/// Inverse of a matrix without negative eigenvalues.
fn inverse(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let mut firm = matrix.clone();
    (0..firm.nrows()).for_each(|k| firm[(k, k)] = (firm[(k, k)] * (1.0 + RIDGE)).max(f64::MIN_POSITIVE.sqrt()));
    firm.cholesky().map(|factored| factored.inverse())
}

impl DayEvidence {
    /// Inner products over all joints, each divided by its variance.
    fn sums(&self, channels: usize, rest: &[f64]) -> (DMatrix<f64>, DVector<f64>) {
        let (mut gram, mut score) = (DMatrix::zeros(channels, channels), DVector::zeros(channels));
        for (joint, rest) in self.0.iter().zip(rest) {
            for (a, &k) in joint.channels.iter().enumerate() {
                score[k] += joint.score[a] / rest;
                for (b, &m) in joint.channels.iter().enumerate() {
                    gram[(k, m)] += joint.gram[(a, b)] / rest;
                }
            }
        }
        (gram, score)
    }
}

/// Information on a change of the mean, and information times estimate.
struct Difference {
    information: DMatrix<f64>,
    score: DVector<f64>,
    /// Of the channels.
    units: DVector<f64>,
}

/// A change of some channels.
struct Fit {
    /// By how much twice the log-likelihood grows.
    square: f64,
    /// Independent directions.
    rank: usize,
    values: Vec<f64>,
    stds: Vec<f64>,
}

impl Difference {
    fn fit(&self, own: &[usize]) -> Fit {
        let n = own.len();
        let scale: Vec<f64> = own
            .iter()
            .map(|&k| self.information[(k, k)])
            .map(|information| if information > 0.0 { information.sqrt().recip() } else { 0.0 })
            .collect();
        let correlation = DMatrix::from_fn(n, n, |a, b| scale[a] * self.information[(own[a], own[b])] * scale[b]);
        let score = DVector::from_fn(n, |a, _| scale[a] * self.score[own[a]]);
        let SymmetricEigen { eigenvectors, eigenvalues } = SymmetricEigen::new(correlation);
        let least = 1e-6 * eigenvalues.iter().fold(0.0, |most, x| x.max(most));
        let (mut square, mut rank) = (0.0, 0);
        let (mut values, mut variances) = (DVector::<f64>::zeros(n), DVector::<f64>::zeros(n));
        for (k, value) in eigenvalues.iter().enumerate().filter(|(_, value)| **value > least) {
            let vector = eigenvectors.column(k);
            let along = vector.dot(&score);
            square += along * along / value;
            rank += 1;
            values += vector * (along / value);
            variances += vector.component_mul(&vector) / *value;
        }
        let unit = |a: usize| self.units[own[a]] * scale[a];
        Fit {
            square,
            rank,
            values: (0..n).map(|a| values[a] * unit(a)).collect(),
            stds: (0..n).map(|a| variances[a].sqrt() * unit(a)).collect(),
        }
    }
}

#[cfg(test)]
mod tests;
