//! Least squares over possible bodies and further unknowns, some with a lower bound, as used by the
//! diagnosis.

use nalgebra::{DMatrix, DVector};

use super::ConsistentError;
use super::ConsistentSettings;
use super::PriorBody;
use super::VANISHING;
use super::newton::Weights;
use super::setup::{Data, Layout, Setup, grouping};
use crate::model::{BaseParameter, StandardParameter};
use crate::numerics::eigen;

/// Relative size of an eigenvalue of the scaled normal matrix below which its direction is
/// undetermined.
const RANK: f64 = 1e-13;
/// Scale of an unknown that the data do not determine, in its own unit.
const SIZE: f64 = 0.1;

/// Constraints of a least-squares problem whose unknowns are base parameters followed by further
/// unknowns.
#[derive(Debug, Clone, Copy)]
pub struct BoundedLeastSquares<'a> {
    /// Standard parameters, including those of links and rotors.
    pub standard: &'a [StandardParameter],
    /// Base parameters (the first unknowns) as combinations of standard ones; empty if no link is
    /// unknown.
    pub base: &'a [BaseParameter],
    /// Lower bound of each further unknown; `None`: unbounded.
    pub least: &'a [Option<f64>],
    /// Prior body of each link ([`prior_bodies`](super::prior_bodies)), without the bodies fixed to
    /// it.
    pub prior: &'a [PriorBody],
    /// Standard parameters of the robot file, of which those of the rotors are used (kg m^2).
    pub drives: &'a [f64],
    /// Margin, weight of the prior, and bodies fixed to links.
    pub settings: &'a ConsistentSettings,
}

/// Least-squares solution that satisfies the constraints.
#[derive(Debug, Clone, PartialEq)]
pub struct Feasible {
    /// Standard parameters; empty if no link is unknown.
    pub standard: Vec<f64>,
    /// Unknowns: base parameters, then the further ones.
    pub x: DVector<f64>,
}

impl BoundedLeastSquares<'_> {
    /// Minimises `1/2 x'Ax - b'x`: `normal` (`A`, positive semidefinite) and `rhs` (`b`) in units
    /// of the noise of independent samples. A further unknown whose row of `A` is zero is 0, or at
    /// its bound if that is above 0.
    ///
    /// # Errors
    /// If numbers are infinite, or the solver stalls ([`ConsistentError::Stalled`]).
    pub fn solve(&self, normal: &DMatrix<f64>, rhs: &DVector<f64>) -> Result<Feasible, ConsistentError> {
        if normal.iter().chain(rhs.iter()).any(|v| !v.is_finite()) {
            return Err(ConsistentError::NotFinite);
        }
        let n = rhs.len();
        // Bounded unknowns are shifted by their bound.
        let first = self.base.len();
        let bound = DVector::from_fn(n, |i, _| i.checked_sub(first).and_then(|k| *self.least.get(k)?).unwrap_or(0.0));
        let rhs = rhs - normal * &bound;
        let links = if first > 0 { self.standard.len() } else { 0 };
        let layout = self.layout(links)?;
        let grouping = self.grouping(links);
        let mut drives = vec![0.0; layout.count];
        drives[..links].copy_from_slice(&self.drives[..links]);
        let settings = ConsistentSettings {
            carried: if first > 0 { self.settings.carried.clone() } else { Vec::new() },
            ..self.settings.clone()
        };
        // A bounded unknown is scaled by the value that the data would give it alone.
        for (k, slot) in drives[links..].iter_mut().enumerate().filter(|(k, _)| self.least[*k].is_some()) {
            let own = normal[(first + k, first + k)];
            let alone = if own > 0.0 { (rhs[first + k] / own).abs() } else { 0.0 };
            *slot = if alone > 0.0 && alone.is_finite() { alone } else { SIZE };
        }
        let prior = if first > 0 { self.prior } else { &[] };
        let setup = Setup::new(layout, &grouping, &root(normal, &rhs), prior, &drives, &settings)?;
        let weights = Weights { w: self.settings.prior_weight, mu: VANISHING };
        let (v, _) = setup.problem.follow(&setup.start, weights)?;
        let all = setup.standard(&v);
        if all.iter().any(|x| !x.is_finite()) {
            return Err(ConsistentError::NotFinite);
        }
        let grouped = |i: usize| match self.base.get(i) {
            Some(base) => base.coefficients.iter().map(|&(at, c)| c * all[at]).sum::<f64>(),
            None => all[links + i - first],
        };
        let silent = |i: usize| normal[(i, i)] == 0.0;
        let x = DVector::from_fn(n, |i, _| match i >= first && silent(i) {
            true => bound[i].max(0.0),
            false => grouped(i) + bound[i],
        });
        Ok(Feasible { standard: all[..links].to_vec(), x })
    }

    /// Layout of the first `links` standard parameters, followed by one parameter per further
    /// unknown.
    fn layout(&self, links: usize) -> Result<Layout, ConsistentError> {
        let mut layout = Layout::new(&self.standard[..links])?;
        for (k, least) in self.least.iter().enumerate() {
            let list = if least.is_some() { &mut layout.positive } else { &mut layout.free };
            list.push(links + k);
        }
        layout.count += self.least.len();
        Ok(layout)
    }

    /// Matrix from the parameters of [`Self::layout`] to the unknowns.
    fn grouping(&self, links: usize) -> DMatrix<f64> {
        let (base, further) = (self.base.len(), self.least.len());
        let mut k = DMatrix::zeros(base + further, links + further);
        k.view_mut((0, 0), (base, links)).copy_from(&grouping(self.base, links));
        (0..further).for_each(|i| k[(base + i, links + i)] = 1.0);
        k
    }
}

/// `R` and `z` with `R'R = A` and `R'z = b`, from the eigenvalues of the matrix scaled to unit
/// diagonal.
fn root(normal: &DMatrix<f64>, rhs: &DVector<f64>) -> Data {
    let n = rhs.len();
    let size: Vec<f64> = (0..n).map(|i| if normal[(i, i)] > 0.0 { normal[(i, i)].sqrt() } else { 1.0 }).collect();
    let scaled = DMatrix::from_fn(n, n, |i, k| 0.5 * (normal[(i, k)] + normal[(k, i)]) / (size[i] * size[k]));
    let eigen = eigen::symmetric(scaled);
    let most = eigen.eigenvalues.iter().fold(0.0_f64, |m, x| m.max(*x));
    let (mut r, mut z) = (DMatrix::zeros(n, n), DVector::zeros(n));
    for (k, (&value, axis)) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()).enumerate() {
        if value <= RANK * most {
            continue;
        }
        let along: f64 = (0..n).map(|i| axis[i] * rhs[i] / size[i]).sum();
        z[k] = along / value.sqrt();
        (0..n).for_each(|i| r[(k, i)] = value.sqrt() * axis[i] * size[i]);
    }
    Data { r, z }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solve(least: &[Option<f64>], normal: &DMatrix<f64>, rhs: &DVector<f64>) -> DVector<f64> {
        let settings = ConsistentSettings::default();
        let problem =
            BoundedLeastSquares { standard: &[], base: &[], least, prior: &[], drives: &[], settings: &settings };
        problem.solve(normal, rhs).unwrap().x
    }

    #[test]
    fn bounds_that_hold_change_nothing_and_others_are_met() {
        let a = DMatrix::from_row_slice(3, 3, &[4e6, 1e6, 0.0, 1e6, 9e6, 2e6, 0.0, 2e6, 5e6]);
        let truth = DVector::from_column_slice(&[0.5, -0.2, 1.0]);
        let b = &a * &truth;
        let x = solve(&[Some(0.0), Some(-0.3), None], &a, &b);
        assert!((&x - &truth).amax() < 1e-5, "{x}");
        // The second unknown is at its bound, and the others are fitted accordingly.
        let x = solve(&[Some(0.0), Some(0.0), None], &a, &b);
        let rest = DMatrix::from_row_slice(2, 2, &[4e6, 0.0, 0.0, 5e6]).try_inverse().unwrap()
            * DVector::from_column_slice(&[b[0], b[2]]);
        assert!(x[1].abs() < 1e-5 && (x[0] - rest[0]).abs() < 1e-4 && (x[2] - rest[1]).abs() < 1e-4, "{x}");
    }

    #[test]
    fn unknowns_without_equations_stay_where_they_are() {
        let a = DMatrix::from_row_slice(2, 2, &[1e6, 0.0, 0.0, 0.0]);
        let x = solve(&[Some(-2.0), Some(-2.0)], &a, &DVector::from_column_slice(&[1e6, 0.0]));
        assert!((x[0] - 1.0).abs() < 1e-5 && x[1] == 0.0, "{x}");
    }
}
