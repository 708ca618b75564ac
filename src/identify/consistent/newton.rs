//! Minimises least squares with bodies inside their cones by Newton's method along the central
//! path.
//!
//! ```text
//! F(v) = 1/2 |J v - z|^2 + sum_links w [tr Z / (1 - eps) - log det Z]        Z = Y - eps 1,  Y = sum_k v_k E_k
//!        + sum_scalars w or mu [v - log v] + mu/2 sum_free (v - v0)^2 - mu sum_walls log(a'v - b),   subject to e'v = s
//! ```
//!
//! The entropic distance to the prior is at the same time the barrier of the cone, so `F` is smooth
//! and strictly convex inside. Divided by `w` it is self-concordant. From a neighbourhood of its
//! unique minimum Newton's steps converge quadratically to all digits (Boyd and Vandenberghe,
//! *Convex Optimization*, section 9.6). That neighbourhood is reached by [`path`](super::path).
//! With `w -> 0` the minimum tends to the constrained least squares solution of least distance to
//! the prior; its remaining distance is about `w` per eigenvalue (section 11.2.2).

use nalgebra::{DMatrix, DVector, Matrix4};

use super::stacked::Stacked;
use crate::model::pseudo_inertia::{basis, coordinates, symmetric};

/// A variable that must be positive; 1 at the prior.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scalar {
    pub(super) index: usize,
    /// Whether its prior has the weight of a body's (`w`), or only keeps it positive (`mu`).
    pub(super) known: bool,
}

/// A body in its cone; its ten coordinates are 1, 1, 1, 1, 0, .. at the prior.
#[derive(Debug, Clone, Copy)]
pub(super) struct Link {
    /// Index of the first of its ten coordinates.
    pub(super) start: usize,
    /// Weight of its prior relative to `w`.
    pub(super) share: f64,
}

/// Linear constraint `a'v > b`, with the listed entries of `a`.
#[derive(Debug, Clone)]
pub(super) struct Wall {
    pub(super) a: Vec<(usize, f64)>,
    pub(super) b: f64,
}

impl Wall {
    pub(super) fn slack(&self, v: &[f64]) -> f64 {
        self.a.iter().map(|&(i, a)| a * v[i]).sum::<f64>() - self.b
    }
}

/// Objective function and constraints of a minimisation.
#[derive(Debug, Clone)]
pub(super) struct Problem {
    pub(super) j: DMatrix<f64>,
    pub(super) z: DVector<f64>,
    pub(super) links: Vec<Link>,
    pub(super) scalars: Vec<Scalar>,
    /// Unbounded variables, with the values to which they are weakly pulled.
    pub(super) free: Vec<(usize, f64)>,
    pub(super) walls: Vec<Wall>,
    /// Constraint `e'v = s`, satisfied by every step.
    pub(super) equal: Option<Wall>,
    /// Margin `eps`.
    pub(super) margin: f64,
}

/// Weights of the prior and of the barriers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Weights {
    pub(super) w: f64,
    pub(super) mu: f64,
}

/// Newton's method stalled away from a minimum.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("after {steps} steps at prior weight {w:.1e} the Newton decrement is still {decrement:.1e}")]
pub struct Stalled {
    /// Weight of the prior at this point of the path.
    pub w: f64,
    /// Number of steps taken there.
    pub steps: usize,
    /// Newton decrement `sqrt(-g'd)`, in units of the smaller weight.
    pub decrement: f64,
}

impl Problem {
    /// Misfit `1/2 |J v - z|^2`.
    pub(super) fn misfit(&self, v: &[f64]) -> f64 {
        0.5 * (&self.j * DVector::from_column_slice(v) - &self.z).norm_squared()
    }

    /// Matrix `Z` of a link.
    pub(super) fn inside(&self, v: &[f64], start: usize) -> Matrix4<f64> {
        symmetric(&v[start..start + 10]) - Matrix4::identity() * self.margin
    }

    /// Value `tr Z / (1 - eps) - log det Z` of a link, minus that at the prior; `None` outside the
    /// cone.
    pub(super) fn distance(&self, v: &[f64], start: usize) -> Option<f64> {
        let at_prior = 4.0 * (1.0 - (1.0 - self.margin).ln());
        let z = self.inside(v, start);
        let root = z.cholesky()?;
        let log_det = 2.0 * root.l().diagonal().iter().map(|d| d.ln()).sum::<f64>();
        Some(z.trace() / (1.0 - self.margin) - log_det - at_prior)
    }

    /// Objective `F`; `None` outside the cones and walls.
    pub(super) fn value(&self, v: &[f64], weights: Weights) -> Option<f64> {
        let Weights { w, mu } = weights;
        let mut value = self.misfit(v);
        for link in &self.links {
            value += w * link.share * self.distance(v, link.start)?;
        }
        for s in &self.scalars {
            let (x, weight) = (v[s.index], if s.known { w } else { mu });
            if x <= 0.0 {
                return None;
            }
            value += weight * (x - x.ln());
        }
        for &(i, v0) in &self.free {
            value += 0.5 * mu * (v[i] - v0).powi(2);
        }
        for wall in &self.walls {
            let slack = wall.slack(v);
            if slack <= 0.0 {
                return None;
            }
            value -= mu * slack.ln();
        }
        value.is_finite().then_some(value)
    }

    /// Quadratic model at `v` of everything but the misfit, as a least squares problem `1/2 |A d -
    /// b|^2` plus a constant: its normal matrix is the Hessian, `-A'b` the gradient. An orthogonal
    /// transformation ([`Stacked`]) loses half of the digits that the normal equations would lose,
    /// which matters for small `w`.
    fn model(&self, v: &DVector<f64>, weights: Weights) -> Option<(DMatrix<f64>, DVector<f64>)> {
        let Weights { w, mu } = weights;
        let n = self.j.ncols();
        let rows = 10 * self.links.len() + self.scalars.len() + self.free.len() + self.walls.len();
        let (mut a, mut b) = (DMatrix::zeros(rows, n), DVector::zeros(rows));
        let mut row = 0;
        for &Link { start, share } in &self.links {
            // With Z = L L' and D = L^-1 dZ L^-T: -log det Z changes by -tr D + |D|^2 / 2.
            let l = self.inside(v.as_slice(), start).cholesky()?.l();
            let inverse = l.try_inverse()?;
            let root = (w * share).sqrt();
            for k in 0..10 {
                let d = coordinates(&(inverse * basis(k) * inverse.transpose())) * root;
                a.view_mut((row, start + k), (10, 1)).copy_from(&d);
            }
            let slope = Matrix4::identity() - l.transpose() * l / (1.0 - self.margin);
            b.rows_mut(row, 10).copy_from(&(coordinates(&slope) * root));
            row += 10;
        }
        for s in &self.scalars {
            let (x, root) = (v[s.index], if s.known { w } else { mu }.sqrt());
            a[(row, s.index)] = root / x;
            b[row] = root * (1.0 - x);
            row += 1;
        }
        for &(i, v0) in &self.free {
            a[(row, i)] = mu.sqrt();
            b[row] = mu.sqrt() * (v0 - v[i]);
            row += 1;
        }
        for wall in &self.walls {
            let slack = wall.slack(v.as_slice());
            wall.a.iter().for_each(|&(i, c)| a[(row, i)] += mu.sqrt() * c / slack);
            b[row] = mu.sqrt();
            row += 1;
        }
        Some((a, b))
    }

    /// Moves `v` to the minimum at these weights and returns the number of steps.
    fn minimise(&self, stacked: &Stacked<'_>, v: &mut DVector<f64>, weights: Weights) -> Result<usize, Stalled> {
        const MOST: usize = 400;
        let share = self.links.iter().map(|l| l.share).fold(1.0, f64::min);
        let unit = (weights.w * share).min(weights.mu);
        let mut decrement = f64::INFINITY;
        for steps in 0..MOST {
            let halt = |decrement| Stalled { w: weights.w, steps, decrement };
            let (a, b) = self.model(v, weights).ok_or_else(|| halt(decrement))?;
            let (step, slope) = stacked.step(v, &a, &b).ok_or_else(|| halt(decrement))?;
            let before = decrement;
            decrement = ((-slope).max(0.0) / unit).sqrt();
            if decrement < 1e-7 || (decrement < 1e-3 && decrement > 0.5 * before) {
                return Ok(steps); // or as small as rounding lets it be
            }
            // Where the quadratic model holds, differences of function values are below rounding.
            let trusted = decrement < 0.25;
            let here = if trusted { 0.0 } else { self.value(v.as_slice(), weights).unwrap_or(f64::INFINITY) };
            let mut length = 1.0;
            loop {
                let next = &*v + &step * length;
                let good = match self.value(next.as_slice(), weights) {
                    Some(value) => trusted || value <= here + 1e-4 * length * slope,
                    None => false,
                };
                if good {
                    *v = next;
                    break;
                }
                length *= 0.5;
                if length < 1e-10 {
                    // Rounding of the function values hides a gain this small.
                    let lost = slope.abs() <= 1e-12 * (1.0 + here.abs());
                    return if lost { Ok(steps) } else { Err(halt(decrement)) };
                }
            }
        }
        Err(Stalled { w: weights.w, steps: MOST, decrement })
    }

    /// Goes from the prior to the minimum at `weights`; returns the coordinates and the number of
    /// steps.
    pub(super) fn follow(&self, start: &[f64], weights: Weights) -> Result<(Vec<f64>, usize), Stalled> {
        let stacked = Stacked::new(self);
        let (mut v, far) = super::path::near(self, &stacked, start, weights)?;
        let close = self.minimise(&stacked, &mut v, weights)?;
        Ok((v.as_slice().to_vec(), far + close))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `-A'b` is the gradient of everything but the misfit, checked by central differences: for a
    /// body, known and unknown scalars, a free variable and a wall.
    #[test]
    fn the_slope_of_the_function_is_the_models() {
        let n = 13;
        let problem = Problem {
            j: DMatrix::zeros(1, n),
            z: DVector::zeros(1),
            links: vec![Link { start: 0, share: 0.7 }],
            scalars: vec![Scalar { index: 10, known: true }, Scalar { index: 11, known: false }],
            free: vec![(12, 0.4)],
            walls: vec![Wall { a: vec![(0, 1.0), (10, -0.5)], b: 0.2 }],
            equal: None,
            margin: 0.05,
        };
        let mut v = DVector::zeros(n);
        [1.3, 0.9, 1.1, 1.2, 0.1, -0.05, 0.08, 0.02, 0.1, -0.1].iter().enumerate().for_each(|(k, x)| v[k] = *x);
        (v[10], v[11], v[12]) = (0.8, 1.7, -0.3);
        let weights = Weights { w: 0.6, mu: 0.3 };
        let (a, b) = problem.model(&v, weights).unwrap();
        let slope = -(a.transpose() * b);
        let h = 1e-5;
        for k in 0..n {
            let at = |by: f64| {
                let mut next = v.clone();
                next[k] += by;
                problem.value(next.as_slice(), weights).unwrap()
            };
            let wanted = (at(h) - at(-h)) / (2.0 * h);
            assert!((slope[k] - wanted).abs() < 1e-7, "{k}: {} {wanted}", slope[k]);
        }
    }
}
