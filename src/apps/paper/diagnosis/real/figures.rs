//! Summary figures of the cases on real recordings.

use super::{RealCase, Untouched};
use crate::apps::paper::Tally;
use crate::apps::paper::diagnosis::Claim;
use crate::apps::paper::diagnosis::score::binned;
use crate::diagnose::{Cause, Diagnosis, Quantity};
use dh_codegen::robot::effects;

/// Largest deviation from 1 of the relative size found by an informed fit.
const RECOVERED: f64 = 0.2;

/// Figures for one size, over the cases that an informed fit recovers.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Figures {
    /// Size, in residuals.
    pub size: f64,
    /// Cases that an informed fit recovers within 20 %.
    pub recovered: Tally,
    /// Cases with the cause named at its place.
    pub named: Tally,
    /// Cases with the cause first among the new ones, at its place.
    pub first: Tally,
    /// Cases with the cause named at its place with a probability above one half.
    pub sure: Tally,
    /// Share at the right place, of cases with the right cause named anywhere.
    pub place: Tally,
    /// Parameters within three standard deviations, of causes named at their place.
    pub within_three: Tally,
    /// New causes that were not added, per case.
    pub false_new: f64,
    /// All new causes.
    pub claims: Vec<Claim>,
}

/// Causes named in unchanged logs, and their agreement with other excerpts.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Stability {
    /// Causes with a probability above 0.8 that both halves have, too.
    pub sure: Tally,
    /// For each cause: arm, cause, joints, probability, and the number of halves that have it.
    pub causes: Vec<(String, &'static str, Vec<usize>, f64, Tally)>,
}

/// Whether the relative size found by an informed fit is close enough to 1.
pub(super) fn is_recovered(size: f64) -> bool {
    (size - 1.0).abs() < RECOVERED
}

/// Indices of the causes of `found` that `plain` does not have; `unknown` does not count.
pub(super) fn new_causes(found: &Diagnosis, plain: &Diagnosis) -> Vec<usize> {
    let new = |c: &Cause| c.cause != "unknown" && !plain.causes.iter().any(|p| c.is(p));
    (0..found.causes.len()).filter(|&i| new(&found.causes[i])).collect()
}

impl RealCase {
    /// Whether an informed fit recovers the size within 20 %.
    pub fn recovered(&self) -> bool {
        is_recovered(self.informed)
    }

    /// Whether a cause is the added one, at its place.
    pub fn right(&self, cause: &Cause) -> bool {
        let here = |name: &str, joints: &[usize]| cause.cause == name && cause.joints == joints;
        here(self.added.cause, &self.added.joints) || self.added.same.iter().any(|(name, joints)| here(name, joints))
    }

    /// Causes that the unchanged logs do not have, in the order of the diagnosis.
    pub fn fresh(&self) -> impl Iterator<Item = &Cause> {
        self.new.iter().map(|&i| &self.found.causes[i])
    }

    /// Parameters of the correctly named cause: symbol, truth, value, standard deviation. Forces
    /// are added in base axes; one found in the tool's axes has other components and is left out.
    pub fn parameters(&self) -> Vec<(String, f64, f64, f64)> {
        let Some(cause) = self.fresh().find(|c| c.cause == self.added.cause && c.joints == self.added.joints) else {
            return Vec::new();
        };
        let in_base = |p: &Quantity| p.symbol == effects::ExternalContact::BASE.name() && p.value != 0.0;
        if cause.cause == effects::ExternalContact::NAME && !cause.parameters.iter().any(in_base) {
            return Vec::new();
        }
        let of = |(symbol, truth): &(String, f64)| {
            let p = cause.parameters.iter().find(|p| p.symbol == *symbol)?;
            let std = p.std.filter(|s| s.is_finite() && *s > 0.0)?;
            Some((symbol.clone(), *truth, p.value, std))
        };
        self.added.truth.iter().filter_map(of).collect()
    }
}

impl Figures {
    pub(super) fn of(size: f64, cases: &[RealCase]) -> Self {
        let mut figures = Self { size, ..Self::default() };
        let mut wrong = 0;
        for case in cases.iter().filter(|c| c.size == size) {
            figures.recovered.count(case.recovered());
            let right = case.fresh().find(|c| case.right(c));
            wrong += case.fresh().filter(|c| !case.right(c)).count();
            figures.claims.extend(case.fresh().map(|c| Claim { probability: c.probability, right: case.right(c) }));
            if !case.recovered() {
                continue;
            }
            figures.named.count(right.is_some());
            figures.first.count(case.fresh().next().is_some_and(|c| case.right(c)));
            figures.sure.count(right.is_some_and(|c| c.probability > 0.5));
            if case.fresh().any(|c| c.cause == case.added.cause) {
                figures.place.count(right.is_some());
            }
            for (_, truth, value, std) in case.parameters() {
                figures.within_three.count((value - truth).abs() <= 3.0 * std);
            }
        }
        figures.false_new = wrong as f64 / figures.recovered.all.max(1) as f64;
        figures
    }
}

impl Stability {
    pub(super) fn of(untouched: &[Untouched]) -> Self {
        let mut stability = Self::default();
        for arm in untouched {
            let halves: Vec<&Diagnosis> = arm.halves.iter().flatten().collect();
            if halves.is_empty() {
                continue;
            }
            for cause in arm.whole.causes.iter().filter(|c| c.cause != "unknown") {
                let mut there = Tally::default();
                halves.iter().for_each(|half| there.count(half.causes.iter().any(|c| c.is(cause))));
                if cause.probability > 0.8 {
                    stability.sure.count(there.good == there.all);
                }
                stability.causes.push((arm.arm.clone(), cause.cause, cause.joints.clone(), cause.probability, there));
            }
        }
        stability
    }
}

/// Claims binned by probability: lower and upper edge, mean probability, number that were right.
pub fn reliability(claims: &[Claim]) -> Vec<(f64, f64, f64, Tally)> {
    binned(claims, &[0.0, 0.2, 0.4, 0.6, 0.8, 0.9, 1.0])
}

/// Expected calibration error: mean difference of stated probability and share true, over the bins
/// of [`reliability`], weighted by their claims.
pub fn calibration_error(claims: &[Claim]) -> Option<f64> {
    let bins = reliability(claims);
    let all: usize = bins.iter().map(|b| b.3.all).sum();
    let off = |b: &(f64, f64, f64, Tally)| b.3.all as f64 * (b.2 - b.3.value().unwrap_or(0.0)).abs();
    (all > 0).then(|| bins.iter().map(off).sum::<f64>() / all as f64)
}
