//! Finds possible bodies with given base parameters: from a published table to links.

use nalgebra::{DMatrix, DVector};

use super::ConsistentError;
use super::ConsistentSettings;
use super::PriorBody;
use super::newton::Weights;
use super::setup::{Data, Setup};
use crate::identify::regression::recover::{base_of, implausible_links};
use crate::model::Arm;

/// Bodies with the given base parameters, or with the nearest ones.
#[derive(Debug, Clone, PartialEq)]
pub struct Reproduced {
    /// Standard parameters, in the arm's order.
    pub standard: Vec<f64>,
    /// Base parameters of the bodies minus the given ones.
    pub residual: Vec<f64>,
    /// Largest residual relative to the usual size of such a parameter: see [`possible_bodies`].
    pub worst: f64,
    /// Smallest eigenvalue of each link's body relative to its prior.
    pub margins: Vec<f64>,
    /// Whether the base parameters are met up to rounding, so that they belong to possible bodies.
    pub exact: bool,
}

/// Finds the possible bodies nearest to the prior that have exactly these base parameters. If there
/// are none, finds bodies whose base parameters are nearest, in the usual units of a robot: 1 kg,
/// 0.2 kg m, 0.04 kg m^2, and 1 in the drives' units.
///
/// Uses `margin`, `bounds` and `carried` of the settings.
pub fn possible_bodies(
    arm: &dyn Arm,
    base: &[f64],
    prior: &[PriorBody],
    drives: &[f64],
    settings: &ConsistentSettings,
) -> Result<Reproduced, ConsistentError> {
    let b = arm.base_parameters().len();
    if base.len() != b {
        return Err(ConsistentError::Length { what: "base parameters", found: base.len(), expected: b });
    }
    if base.iter().any(|x| !x.is_finite()) {
        return Err(ConsistentError::NotFinite);
    }
    // Typical sizes, from 1 kg and 0.2 m, as for parameters of a robot's link.
    let sizes: Vec<f64> = arm
        .base_parameters()
        .iter()
        .map(|p| match p.unit.as_str() {
            "kg" => 1.0,
            "kg m" => 0.2,
            "kg m^2" => 0.04,
            _ => 1.0,
        })
        .collect();
    // Known to two digits, with the prior's weight a thousandth: near enough for one projection to
    // give the last digits.
    let sharp = 1e2;
    let r = DMatrix::from_fn(b, b, |i, k| if i == k { sharp / sizes[i] } else { 0.0 });
    let z = DVector::from_fn(b, |i, _| sharp * base[i] / sizes[i]);
    let setup = Setup::of(arm.description(), &Data { r, z }, prior, drives, settings)?;
    let weights = Weights { w: 1e-3, mu: 1e-6 };
    // As in the fit: if nothing comes near, a rough answer has all meaningful digits.
    let rough = (1e-6 * setup.problem.misfit(&setup.start)).max(weights.w);
    let (mut v, _) = setup.problem.follow(&setup.start, Weights { w: rough, mu: rough.min(1e-3) })?;
    if setup.problem.misfit(&v) < 1e4 * rough {
        (v, _) = setup.problem.follow(&setup.start, weights)?;
    }
    // Projects to the last digits, by the shortest way in units of the prior; kept only if
    // everything stays inside.
    let (mut next, j) = (DVector::from_column_slice(&v), &setup.problem.j);
    if let Some(root) = (j * j.transpose()).cholesky() {
        for _ in 0..3 {
            let missing = &setup.problem.z - j * &next;
            next += j.tr_mul(&root.solve(&missing));
        }
        let moved = (&next - DVector::from_column_slice(&v)).amax();
        let inside = setup.problem.value(next.as_slice(), weights).is_some();
        let total = setup.problem.equal.as_ref().is_none_or(|e| e.slack(next.as_slice()).abs() < 1e-9);
        if inside && total && moved < 1e-2 {
            v = next.as_slice().to_vec();
        }
    }
    let standard = setup.standard(&v);
    let residual: Vec<f64> = base_of(arm, &standard).iter().zip(base).map(|(a, b)| a - b).collect();
    let worst = residual.iter().zip(&sizes).map(|(r, s)| (r / s).abs()).fold(0.0, f64::max);
    Ok(Reproduced { margins: setup.margins(&v), exact: worst < 1e-9, standard, residual, worst })
}

/// Relative residual below which base parameters count as met: torques of a robot of usual size
/// then agree to about 1e-5 N m.
const MET: f64 = 1e-6;

/// Replaces the links of `standard` by possible ones with the same base parameters; drives are
/// kept.
///
/// Returns `standard` unchanged if its own links, without the bodies fixed to them, are possible.
///
/// # Errors
/// Returns the links of `standard` (counted from 1) that are no possible bodies, if no other links
/// have the same base parameters.
pub fn buildable_links(
    arm: &dyn Arm,
    standard: &[f64],
    prior: &[PriorBody],
    settings: &ConsistentSettings,
) -> Result<Vec<f64>, Vec<usize>> {
    let parameters = arm.standard_parameters();
    let mut own = standard.to_vec();
    for (link, body) in &settings.carried {
        own.iter_mut().skip(10 * link).zip(body).for_each(|(own, carried)| *own -= carried);
    }
    let impossible = implausible_links(parameters, &own);
    if impossible.is_empty() {
        return Ok(standard.to_vec());
    }
    // Drives with a base parameter of their own are known. Their barrier would keep them off the
    // bound, so the bound is moved below them.
    let known = arm.base_parameters().iter().filter_map(|base| match base.coefficients[..] {
        [(i, _)] if parameters[i].is_level() => Some(i),
        _ => None,
    });
    let known: Vec<usize> = known.collect();
    let others = settings.floors.iter().filter(|(i, _)| !known.contains(i)).copied();
    let floors = others.chain(known.iter().map(|&i| (i, standard[i] - 1.0))).collect();
    let settings = ConsistentSettings { floors, ..settings.clone() };
    match possible_bodies(arm, &base_of(arm, standard), prior, standard, &settings) {
        Ok(met) if met.worst < MET => {
            let mut links = met.standard;
            known.iter().for_each(|&i| links[i] = standard[i]);
            Ok(links)
        }
        _ => Err(impossible),
    }
}
