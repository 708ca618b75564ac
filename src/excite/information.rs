//! Information of a motion on the columns: `G = sum of W' P W`, and functions of its spectrum.
//!
//! The products in `G` lose all digits below 1e-8 of the largest singular value of `W`. If the
//! pivots show that digits are at stake, the factor `R` of `W = Q R` is used instead, which has the
//! singular values themselves.

use nalgebra::{DMatrix, DVector};

use crate::identify::RFactor;
use crate::model::{Gradient, States};
use crate::numerics::eigen;

use super::columns::{Columns, Entry};
use super::criterion::{Criterion, Slope};

/// Weights of rows and columns, and prior information.
#[derive(Debug, Clone)]
pub(super) struct Scaling {
    /// Weight of each joint's equations: 1 / standard deviation of its torque noise.
    pub(super) row: Vec<f64>,
    /// Scale of each column: the size of its parameter.
    pub(super) column: Vec<f64>,
    /// Prior information, in scaled columns.
    pub(super) prior: Option<DMatrix<f64>>,
    /// Number of samples that each sample of the grid represents.
    pub(super) repeat: f64,
}

/// The weighted, scaled observation matrix of a motion and its information.
pub struct Information {
    /// Values, `values * len`, as written by [`Columns::evaluate`].
    values: Vec<f64>,
    len: usize,
    /// Information `G`, scaled, prior included.
    gram: DMatrix<f64>,
    /// Factor with `R' R = G`, if the products are too inaccurate.
    factor: Option<DMatrix<f64>>,
}

/// Condition numbers (ratio of the largest to the smallest singular value) and the two determinants
/// of the paper's equation (9).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conditions {
    /// Condition number of the observation matrix.
    pub condition: f64,
    /// `log det(W' W)`.
    pub log_det: f64,
    /// `log` of the product of the squared column norms.
    pub hadamard: f64,
}

impl Information {
    /// Evaluates the columns at the states.
    pub(super) fn new(columns: &Columns<'_>, states: &States, scaling: &Scaling) -> Self {
        let (len, count) = (states.len, columns.count());
        let mut values = vec![0.0; columns.values() * len];
        columns.evaluate(states, &mut values);
        let mut gram = DMatrix::zeros(count, count);
        for row in columns.entries().chunk_by(|a, b| a.row == b.row) {
            let weight = scaling.row[row[0].row].powi(2) * scaling.repeat;
            let sums = products(row, &values, len);
            for (i, a) in row.iter().enumerate() {
                for (k, b) in row.iter().enumerate().skip(i) {
                    let product = weight * sums[i * row.len() + k];
                    gram[(a.column, b.column)] += product * scaling.column[a.column] * scaling.column[b.column];
                }
            }
        }
        gram.fill_lower_triangle_with_upper_triangle();
        if let Some(prior) = &scaling.prior {
            gram += prior;
        }
        let factor = poor(&gram).then(|| factor(columns, &values, len, scaling));
        Self { values, len, gram, factor }
    }

    /// Computes the factor if eigenvalues of the products would lose more than some ten digits:
    /// `tr G tr G^-1` is at least the square of the condition number.
    pub(super) fn sharpen(&mut self, columns: &Columns<'_>, scaling: &Scaling) {
        if self.factor.is_some() {
            return;
        }
        let inverse = super::criterion::log_det(&self.gram).map(|(_, inverse)| inverse.trace());
        if inverse.is_none_or(|inverse| self.gram.trace() * inverse > 1e6) {
            self.factor = Some(factor(columns, &self.values, self.len, scaling));
        }
    }

    /// Information matrix `G`.
    pub fn gram(&self) -> &DMatrix<f64> {
        &self.gram
    }

    /// Singular values, right singular vectors and column scales, from the factor if there is one,
    /// else from `G`.
    fn singular(&self, equilibrate: bool) -> (Vec<f64>, DMatrix<f64>, Vec<f64>) {
        let n = self.gram.ncols();
        let unit = |norm: f64| if equilibrate && norm > 0.0 { 1.0 / norm } else { 1.0 };
        match &self.factor {
            Some(r) => {
                let scale: Vec<f64> = (0..n).map(|k| unit(r.column(k).norm())).collect();
                let scaled = DMatrix::from_fn(r.nrows(), n, |i, k| r[(i, k)] * scale[k]);
                let svd = scaled.svd(false, true);
                let v = svd.v_t.map_or_else(|| DMatrix::identity(n, n), |v| v.transpose());
                (svd.singular_values.iter().copied().collect(), v, scale)
            }
            None => {
                let scale: Vec<f64> = (0..n).map(|k| unit(self.gram[(k, k)].sqrt())).collect();
                let scaled = DMatrix::from_fn(n, n, |i, k| self.gram[(i, k)] * scale[i] * scale[k]);
                let eigen = eigen::symmetric(scaled);
                let floor = eigen.eigenvalues.max() * 1e-30;
                (eigen.eigenvalues.iter().map(|l| l.max(floor).sqrt()).collect(), eigen.eigenvectors, scale)
            }
        }
    }

    /// Condition number and determinants.
    pub fn conditions(&self) -> Conditions {
        let (sigma, _, _) = self.singular(false);
        let (least, most) = sigma.iter().fold((f64::INFINITY, 0.0_f64), |(l, h), s| (l.min(*s), h.max(*s)));
        let (unit, _, scale) = self.singular(true);
        let log_scale: f64 = scale.iter().map(|s| s.ln()).sum();
        Conditions {
            condition: if least > 0.0 { most / least } else { f64::INFINITY },
            log_det: 2.0 * (unit.iter().map(|s| s.ln()).sum::<f64>() - log_scale),
            hadamard: self.gram.diagonal().iter().map(|g| g.ln()).sum(),
        }
    }

    /// Columns that are undetermined, separately or in combination: those with a component in the
    /// null space.
    pub(super) fn undetermined(&self) -> Vec<usize> {
        let (sigma, v, _) = self.singular(true);
        let most = sigma.iter().fold(0.0_f64, |m, s| m.max(*s));
        let null: Vec<usize> = (0..sigma.len()).filter(|&k| sigma[k].is_nan() || sigma[k] <= 1e-10 * most).collect();
        (0..v.nrows()).filter(|&i| null.iter().any(|&k| v[(i, k)].abs() > 1e-4)).collect()
    }

    /// RMS over the motion of each column's contribution to a joint's torque, per unit of its
    /// parameter, in standard deviations of that torque's noise; for the joint where it is largest.
    pub(super) fn torque_shares(&self, columns: &Columns<'_>, scaling: &Scaling) -> Vec<f64> {
        let mut shares = vec![0.0_f64; columns.count()];
        for e in columns.entries() {
            let column = &self.values[e.place * self.len..(e.place + 1) * self.len];
            let rms = (dot(column, column) / self.len.max(1) as f64).sqrt() * scaling.row[e.row];
            shares[e.column] = shares[e.column].max(rms);
        }
        shares
    }

    /// Covariance `G^-1` in scaled columns; very large where there is no information.
    pub fn covariance(&self) -> DMatrix<f64> {
        let (sigma, v, scale) = self.singular(true);
        let most = sigma.iter().fold(0.0_f64, |m, s| m.max(*s));
        let n = sigma.len();
        let inverse =
            DVector::from_iterator(n, sigma.iter().map(|s| if *s > 1e-13 * most { 1.0 / (s * s) } else { 1e30 }));
        DMatrix::from_fn(n, n, |i, k| {
            (0..n).map(|l| v[(i, l)] * inverse[l] * v[(k, l)]).sum::<f64>() * scale[i] * scale[k]
        })
    }

    /// Value of a criterion with this power of its smooth form, and its derivative with respect to
    /// `G` in the form that preserves its digits.
    pub(super) fn judge(&self, criterion: &Criterion, power: f64) -> Option<(f64, Slope)> {
        if criterion.by_gram() && self.factor.is_none() {
            return criterion.of_gram(&self.gram);
        }
        let (sigma, v, scale) = self.singular(criterion.ignores_scale());
        criterion.of_spectrum(&sigma, &v, &scale, &self.gram, power)
    }

    /// Adds the derivative of a criterion with respect to the states.
    pub(super) fn pull(
        &self,
        columns: &Columns<'_>,
        states: &States,
        scaling: &Scaling,
        slope: &Slope,
        to: &mut Gradient,
    ) {
        let len = self.len;
        let mut seeds = vec![0.0; self.values.len()];
        let dense = match slope {
            Slope::Dense(f) => Some(f.clone()),
            // If products keep enough digits, so does F = U diag(d) U'.
            Slope::Factored { u, d } => self
                .factor
                .is_none()
                .then(|| u * DMatrix::from_diagonal(&DVector::from_column_slice(d)) * u.transpose()),
        };
        for row in columns.entries().chunk_by(|a, b| a.row == b.row) {
            let weight = 2.0 * scaling.row[row[0].row].powi(2) * scaling.repeat;
            let column = |e: &Entry| scaling.column[e.column];
            match (&dense, slope) {
                (Some(f), _) => {
                    let factor = |a: &Entry, b: &Entry| weight * column(a) * column(b) * f[(a.column, b.column)];
                    combine(row, factor, &self.values, &mut seeds, len);
                }
                // W U first, which is of order one, so that nothing cancels.
                (None, Slope::Factored { u, d }) => {
                    for l in 0..d.len() {
                        let mut product = vec![0.0; len];
                        for b in row {
                            let values = &self.values[b.place * len..(b.place + 1) * len];
                            axpy(column(b) * u[(b.column, l)], values, &mut product);
                        }
                        for a in row {
                            let factor = weight * d[l] * u[(a.column, l)] * column(a);
                            axpy(factor, &product, &mut seeds[a.place * len..(a.place + 1) * len]);
                        }
                    }
                }
                (None, Slope::Dense(_)) => {}
            }
        }
        columns.vjp(states, &seeds, to);
    }
}

/// Whether the products are too inaccurate, judged by the pivots of scaled columns (unit norm) and
/// of unscaled ones. The ratio of the latter is at most the square of the condition number, by
/// which eigenvalues of products lose digits.
fn poor(gram: &DMatrix<f64>) -> bool {
    let plain = gram.clone().cholesky().map(|factor| {
        let pivots = factor.l_dirty().diagonal();
        pivots.min() < 1e-3 * pivots.max()
    });
    if plain.unwrap_or(true) {
        return true;
    }
    let scale: Vec<f64> = gram.diagonal().iter().map(|g| if *g > 0.0 { 1.0 / g.sqrt() } else { 1.0 }).collect();
    let unit = DMatrix::from_fn(gram.nrows(), gram.ncols(), |i, k| gram[(i, k)] * scale[i] * scale[k]);
    match unit.cholesky() {
        Some(factor) => factor.l_dirty().diagonal().iter().any(|pivot| *pivot < 1e-4),
        None => true,
    }
}

/// Triangular factor of the weighted rows, the prior's included.
fn factor(columns: &Columns<'_>, values: &[f64], len: usize, scaling: &Scaling) -> DMatrix<f64> {
    let count = columns.count();
    let mut triangle = RFactor::new(count);
    for row in columns.entries().chunk_by(|a, b| a.row == b.row) {
        let mut block = vec![0.0; len * count];
        for e in row {
            let factor = scaling.row[e.row] * scaling.repeat.sqrt() * scaling.column[e.column];
            axpy(factor, &values[e.place * len..(e.place + 1) * len], &mut block[e.column * len..(e.column + 1) * len]);
        }
        triangle.absorb(&mut block, len);
    }
    if let Some(prior) = &scaling.prior {
        let eigen = eigen::symmetric(prior.clone());
        let root =
            DMatrix::from_diagonal(&eigen.eigenvalues.map(|l| l.max(0.0).sqrt())) * eigen.eigenvectors.transpose();
        triangle.absorb(&mut root.as_slice().to_vec(), count);
    }
    DMatrix::from_fn(count, count, |i, k| triangle.get(i, k))
}

/// Number of samples processed together: columns of a block stay in the nearest cache.
const BLOCK: usize = 128;

/// Inner products of the entries of a row, `[i * row.len() + k]` for `k >= i`. Four columns are
/// processed at a time with four sums each, which vectorises and keeps the order of the sums fixed.
fn products(row: &[Entry], values: &[f64], len: usize) -> Vec<f64> {
    let count = row.len();
    let mut sums = vec![0.0; count * count];
    for start in (0..len).step_by(BLOCK) {
        let end = (start + BLOCK).min(len);
        let part = |e: &Entry| &values[e.place * len + start..e.place * len + end];
        for (i, a) in row.iter().enumerate() {
            let a = part(a);
            for (k, four) in row[i..].chunks(4).enumerate() {
                let sums = &mut sums[i * count + i + 4 * k..][..four.len()];
                if let [b0, b1, b2, b3] = four {
                    let more = dot_four(a, [part(b0), part(b1), part(b2), part(b3)]);
                    sums.iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
                } else {
                    sums.iter_mut().zip(four).for_each(|(sum, b)| *sum += dot(a, part(b)));
                }
            }
        }
    }
    sums
}

fn dot_four(a: &[f64], b: [&[f64]; 4]) -> [f64; 4] {
    let (mut sums, even) = ([[0.0; 4]; 4], a.len() / 4 * 4);
    let b = b.map(|b| &b[..a.len()]);
    for s in (0..even).step_by(4) {
        for k in 0..4 {
            for l in 0..4 {
                sums[k][l] += a[s + l] * b[k][s + l];
            }
        }
    }
    std::array::from_fn(|k| {
        let rest: f64 = (even..a.len()).map(|s| a[s] * b[k][s]).sum();
        (sums[k][0] + sums[k][1]) + (sums[k][2] + sums[k][3]) + rest
    })
}

/// Adds to each entry's samples the entries of its row, each times `factor(to, from)`.
fn combine(row: &[Entry], factor: impl Fn(&Entry, &Entry) -> f64, values: &[f64], to: &mut [f64], len: usize) {
    let factors: Vec<f64> = row.iter().flat_map(|a| row.iter().map(|b| factor(a, b)).collect::<Vec<_>>()).collect();
    for start in (0..len).step_by(BLOCK) {
        let end = (start + BLOCK).min(len);
        let part = |e: &Entry| &values[e.place * len + start..e.place * len + end];
        for (a, factors) in row.iter().zip(factors.chunks(row.len())) {
            let sum = &mut to[a.place * len + start..a.place * len + end];
            for (four, f) in row.chunks(4).zip(factors.chunks(4)) {
                if let ([b0, b1, b2, b3], &[f0, f1, f2, f3]) = (four, f) {
                    let others = part(b0).iter().zip(part(b1)).zip(part(b2).iter().zip(part(b3)));
                    for (sum, ((v0, v1), (v2, v3))) in sum.iter_mut().zip(others) {
                        *sum += (f0 * v0 + f1 * v1) + (f2 * v2 + f3 * v3);
                    }
                } else {
                    four.iter().zip(f).for_each(|(b, f)| axpy(*f, part(b), sum));
                }
            }
        }
    }
}

/// Inner product with four accumulators, which vectorises and keeps the order of the sum fixed.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (mut sums, even) = ([0.0; 4], a.len() / 4 * 4);
    for (x, y) in a[..even].chunks_exact(4).zip(b[..even].chunks_exact(4)) {
        for l in 0..4 {
            sums[l] += x[l] * y[l];
        }
    }
    let rest: f64 = a[even..].iter().zip(&b[even..]).map(|(x, y)| x * y).sum();
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

fn axpy(factor: f64, x: &[f64], to: &mut [f64]) {
    to.iter_mut().zip(x).for_each(|(y, x)| *y += factor * x);
}
