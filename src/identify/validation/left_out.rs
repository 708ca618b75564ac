//! Compares the plain fit and possible bodies on stretches of the fitted logs that are left out in
//! turn. Decides which of the two extrapolates better, without a further log.
//!
//! Fit and errors require only the Gram matrices of the batches, so no log is read again.

use nalgebra::DMatrix;

use crate::identify::consistent::{ConsistentError, ConsistentSettings, PriorBody, consistent};
use crate::identify::regression::accumulator::{Factors, JointFactor};
use crate::identify::regression::r_factor::RFactor;
use crate::identify::result::Identification;
use crate::identify::solve::{IdentifyError, IdentifySettings, solve};
use crate::identify::validation::preference::Errors;
use crate::identify::validation::preference::Preference;
use crate::identify::validation::preference::compare;
use crate::model::Arm;
use crate::numerics::eigen;

/// Number of parts that are left out in turn.
const PARTS: usize = 8;

/// Reason why there is no result.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LeftOutError {
    /// The logs are too short.
    #[error("the fitted logs are too short to leave parts out")]
    Short,
    /// The remaining data do not determine the parameters.
    #[error(transparent)]
    Identify(#[from] IdentifyError),
    /// The remaining data have no possible bodies.
    #[error(transparent)]
    Consistent(#[from] ConsistentError),
}

/// Compares bodies (with the prior) with the plain fit on parts of the fitted logs, each predicted
/// from the others: relative increase of the error. `found`: plain solution of all data; `file`:
/// standard parameters of the robot file, as for [`solve`]; the other arguments as for
/// [`consistent`].
pub fn left_out(
    arm: &dyn Arm,
    fit: &[Factors],
    found: &Identification,
    prior: &[PriorBody],
    drives: &[f64],
    settings: &ConsistentSettings,
    file: Option<&[f64]>,
) -> Result<Preference, LeftOutError> {
    let stretches = |log: &Factors| log.joints.iter().map(|j| j.batches.grams.len()).max().unwrap_or(0);
    let total: usize = fit.iter().map(stretches).sum();
    let parts = PARTS.min(total);
    if parts < 3 {
        return Err(LeftOutError::Short);
    }
    let solving =
        IdentifySettings { weighted: found.weighted, prior: file.map(<[f64]>::to_vec), ..IdentifySettings::default() };
    // The remaining data may contradict physics; this is to be detected.
    let settings = ConsistentSettings { most_cost_percent: f64::INFINITY, ..settings.clone() };
    let mut errors = Vec::new();
    for part in 0..parts {
        let out = part * total / parts..(part + 1) * total / parts;
        let (mut kept, mut gone) = (Vec::new(), Vec::new());
        let mut first = 0;
        for log in fit {
            let here = stretches(log);
            let of = out.start.clamp(first, first + here) - first..out.end.clamp(first, first + here) - first;
            first += here;
            kept.push(without(log, &of));
            if !of.is_empty() {
                gone.push((log, of));
            }
        }
        kept.retain(|log| log.joints.iter().any(|j| j.samples > 0));
        let plain = solve(arm, &kept, &[], &solving)?;
        let bodies = consistent(arm, &kept, &[], &plain, prior, drives, &settings)?;
        let (plain, bodies) = (plain.values(), bodies.base);
        errors.extend(gone.into_iter().map(|(log, of)| Errors::new(log, of, [&plain, &bodies])));
    }
    compare(&errors).ok_or(LeftOutError::Short)
}

/// Factors of the log without these batches.
fn without(log: &Factors, out: &std::ops::Range<usize>) -> Factors {
    if out.is_empty() {
        return log.clone();
    }
    let joint = |joint: &JointFactor| {
        let all = joint.batches.grams.len();
        let mut batches = joint.batches.clone();
        batches.grams.drain(out.start.min(all)..out.end.min(all));
        let n = joint.columns.len() + 1;
        let mut sum = vec![0.0; n * n];
        for gram in &batches.grams {
            sum.iter_mut().zip(gram).for_each(|(s, g)| *s += g);
        }
        let share = batches.grams.len() as f64 / all.max(1) as f64;
        JointFactor {
            triangle: factor(&sum, n),
            samples: (joint.samples as f64 * share).round() as usize,
            independent: joint.independent * share,
            batches,
            columns: joint.columns.clone(),
            range: joint.range,
            reach: joint.reach,
        }
    };
    Factors { joints: log.joints.iter().map(joint).collect(), ..log.clone() }
}

/// Factor `R` with `R' R = gram`, column-major, from the eigenvectors of the matrix scaled to unit
/// diagonal. Eigenvalues that are rounding errors (below 1e-13) are set to zero.
fn factor(gram: &[f64], n: usize) -> RFactor {
    let scale: Vec<f64> = (0..n).map(|k| gram[k + k * n].max(0.0).sqrt()).collect();
    let inverse = |k: usize| if scale[k] > 0.0 { scale[k].recip() } else { 0.0 };
    let unit = DMatrix::from_fn(n, n, |i, k| inverse(i) * gram[i + k * n] * inverse(k));
    let eigen = eigen::symmetric(unit);
    let least = 1e-13 * eigen.eigenvalues.max();
    let root = |i: usize| if eigen.eigenvalues[i] > least { eigen.eigenvalues[i].sqrt() } else { 0.0 };
    let rows = DMatrix::from_fn(n, n, |i, k| root(i) * eigen.eigenvectors[(k, i)] * scale[k]);
    let mut triangle = RFactor::new(n);
    triangle.absorb(&mut rows.as_slice().to_vec(), n);
    triangle
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_factor_from_its_gram_matrix() {
        let n = 4;
        // Columns of very different size, the third twice the first.
        let mut block: Vec<f64> = (0..40).map(|k| f64::from((k * 37 + 11) % 23) - 11.0).collect();
        (0..10).for_each(|r| block[20 + r] = 2.0 * block[r]);
        block[10..20].iter_mut().for_each(|v| *v *= 1e-4);
        let mut triangle = RFactor::new(n);
        triangle.absorb(&mut block, 10);
        let gram = triangle.gram();
        let again = factor(&gram, n).gram();
        let size = |k: usize| gram[k + k * n].sqrt();
        for k in 0..n {
            for i in 0..n {
                assert!((gram[i + k * n] - again[i + k * n]).abs() < 1e-12 * size(i) * size(k), "{i} {k}");
            }
        }
        // The column that is twice another one stays so.
        assert!(factor(&gram, n).norm_of(&[2.0, 0.0, -1.0, 0.0]) < 1e-7 * size(2));
    }
}
