//! Second moments of columns per joint and part of the data, sufficient for least squares, trials
//! of further columns and cross-validation.

use std::ops::Range;
use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

use super::regulariser::Regulariser;
use crate::diagnose::windows::windowed_data::{BLOCKS, Column, WindowedData};
use crate::identify::{dot, dots_of};
use crate::numerics::eigen;
use crate::numerics::parallel::{parallel, threads, threads_for};

/// Products of a joint's columns with each other and with the torque, over one part of the data.
#[derive(Debug, Clone)]
struct Part {
    /// `A' A`.
    gram: DMatrix<f64>,
    /// `A' y`.
    with_y: DVector<f64>,
    /// `y' y`.
    yy: f64,
    /// Number of windows.
    count: f64,
}

/// Equations of one joint.
#[derive(Debug, Clone)]
struct Joint {
    /// Unknowns that act on it.
    columns: Vec<usize>,
    series: Vec<Arc<Vec<f64>>>,
    parts: Vec<Part>,
}

/// Equations of all joints in unknowns `0..unknowns`.
#[derive(Debug, Clone)]
pub struct Moments {
    joints: Vec<Joint>,
    /// Number of unknowns.
    pub unknowns: usize,
    y: Arc<Vec<Vec<f64>>>,
    /// Pieces of the data (ranges of windows), each with the index of its part.
    pieces: Arc<Vec<(Range<usize>, usize)>>,
    /// Sums over the whole data, per joint.
    whole: Vec<Part>,
    /// Prior of the first unknowns.
    regulariser: Regulariser,
}

/// A least-squares solution.
#[derive(Debug, Clone)]
pub struct Solution {
    /// The unknowns.
    pub x: DVector<f64>,
    /// Weight of each joint, `1 / sigma^2`.
    pub weights: Vec<f64>,
    /// Sum of squared residuals of each joint.
    pub rss: Vec<f64>,
    /// Number of windows of each joint.
    pub counts: Vec<f64>,
    /// `(sum_j w_j A_j' A_j + hold)^+`; zero for unknowns at a limit.
    pub inverse: DMatrix<f64>,
    /// The same matrix for all unknowns, if some are at a limit.
    pub unlimited: Option<DMatrix<f64>>,
}

/// Normal equations of a [`Trial`]'s columns, everything else refitted.
pub struct Reduced {
    /// Normal matrix.
    pub normal: DMatrix<f64>,
    /// Right-hand side.
    pub rhs: DVector<f64>,
    /// Decrease of the other unknowns per unit of each coefficient.
    solved: DMatrix<f64>,
}

/// Products of columns that are tried beside those of a [`Moments`].
pub struct Trial {
    terms: usize,
    /// Per joint that the trial acts on: the joint, its terms, and their products with the joint's
    /// columns, with each other and with y, over the whole data.
    joints: Vec<TrialJoint>,
}

struct TrialJoint {
    joint: usize,
    terms: Vec<usize>,
    cross: DMatrix<f64>,
    gram: DMatrix<f64>,
    with_y: DVector<f64>,
}

/// Result of a trial.
#[derive(Debug, Clone)]
pub struct Gain {
    /// Coefficients of the terms.
    pub x: Vec<f64>,
    /// Sum of squared residuals of each joint with them.
    pub rss: Vec<f64>,
}

impl Reduced {
    /// Unconstrained least-squares coefficients.
    pub fn solution(&self) -> DVector<f64> {
        pseudo_inverse(&self.normal) * &self.rhs
    }
}

impl Moments {
    /// Moments of these columns and the torque `y` (per joint, masked), in the parts `block` (one
    /// number below [`BLOCKS`] per window).
    pub fn new(scene: &WindowedData<'_>, block: &[usize], y: &[Vec<f64>], columns: &[&Column]) -> Self {
        let mut pieces: Vec<(Range<usize>, usize)> = Vec::new();
        for (w, &part) in block.iter().enumerate() {
            match pieces.last_mut() {
                Some((range, last)) if *last == part => range.end = w + 1,
                _ => pieces.push((w..w + 1, part)),
            }
        }
        let nothing = |j: usize| {
            let part = |part: usize| {
                let here = || pieces.iter().filter(move |p| p.1 == part).map(|p| p.0.clone());
                let live = |range: Range<usize>| scene.live[j][range].iter().filter(|l| **l).count() as f64;
                Part {
                    gram: DMatrix::zeros(0, 0),
                    with_y: DVector::zeros(0),
                    yy: here().map(|range| dot(&y[j][range.clone()], &y[j][range])).sum(),
                    count: here().map(live).sum(),
                }
            };
            Joint { columns: Vec::new(), series: Vec::new(), parts: (0..BLOCKS).map(part).collect() }
        };
        let joints = (0..scene.dof()).map(nothing).collect();
        let bare = Self {
            joints,
            unknowns: 0,
            y: Arc::new(y.to_vec()),
            pieces: Arc::new(pieces),
            whole: Vec::new(),
            regulariser: Regulariser::none(),
        };
        bare.with(columns)
    }

    /// The same equations with further unknowns appended.
    pub fn with(&self, more: &[&Column]) -> Self {
        let mut all = Self { unknowns: self.unknowns + more.len(), ..self.clone() };
        for (c, column) in more.iter().enumerate() {
            for (j, series) in &column.rows {
                all.joints[*j].columns.push(self.unknowns + c);
                all.joints[*j].series.push(series.clone());
            }
        }
        let parts = parallel(self.threads(), all.joints.len(), |j| all.products_of(j, self.joints[j].columns.len()));
        for (joint, parts) in all.joints.iter_mut().zip(parts) {
            joint.parts = parts;
        }
        all.whole = all.sums(|_| true);
        all
    }

    /// Products of a joint's columns, the first `old` of which are known.
    fn products_of(&self, j: usize, old: usize) -> Vec<Part> {
        let joint = &self.joints[j];
        let n = joint.columns.len();
        if n == old {
            return joint.parts.clone();
        }
        let extended = |(number, part): (usize, &Part)| {
            let (mut gram, mut with_y) = (part.gram.clone().resize(n, n, 0.0), part.with_y.clone());
            with_y = with_y.resize_vertically(n, 0.0);
            for (range, _) in self.pieces.iter().filter(|p| p.1 == number) {
                let cut: Vec<&[f64]> = joint.series.iter().map(|s| &s[range.clone()]).collect();
                let y = &self.y[j][range.clone()];
                for i in old..n {
                    let found = products(cut[i], &cut[..=i]);
                    found.iter().enumerate().for_each(|(k, product)| gram[(i, k)] += product);
                    with_y[i] += dot(cut[i], y);
                }
            }
            gram.fill_upper_triangle_with_lower_triangle();
            Part { gram, with_y, ..*part }
        };
        joint.parts.iter().enumerate().map(extended).collect()
    }

    /// The same equations without the columns of some unknowns; the numbering is unchanged.
    pub fn without(&self, out: impl Fn(usize) -> bool) -> Self {
        let mut all = self.clone();
        for joint in &mut all.joints {
            let kept: Vec<usize> = (0..joint.columns.len()).filter(|i| !out(joint.columns[*i])).collect();
            if kept.len() == joint.columns.len() {
                continue;
            }
            joint.columns = kept.iter().map(|&i| joint.columns[i]).collect();
            joint.series = kept.iter().map(|&i| joint.series[i].clone()).collect();
            for part in &mut joint.parts {
                part.gram = part.gram.select_rows(&kept).select_columns(&kept);
                part.with_y = part.with_y.select_rows(&kept);
            }
        }
        all.whole = all.sums(|_| true);
        all
    }

    /// Number of parts of the data.
    pub fn parts(&self) -> usize {
        BLOCKS
    }

    fn sums(&self, keep: impl Fn(usize) -> bool) -> Vec<Part> {
        self.joints
            .iter()
            .map(|joint| {
                let n = joint.columns.len();
                let mut sum = Part { gram: DMatrix::zeros(n, n), with_y: DVector::zeros(n), yy: 0.0, count: 0.0 };
                for (_, part) in joint.parts.iter().enumerate().filter(|(b, _)| keep(*b)) {
                    sum.gram += &part.gram;
                    sum.with_y += &part.with_y;
                    sum.yy += part.yy;
                    sum.count += part.count;
                }
                sum
            })
            .collect()
    }

    fn assemble(&self, sums: &[Part], weights: &[f64]) -> (DMatrix<f64>, DVector<f64>) {
        let mut matrix = DMatrix::zeros(self.unknowns, self.unknowns);
        let mut rhs = DVector::zeros(self.unknowns);
        for ((joint, sum), weight) in self.joints.iter().zip(sums).zip(weights) {
            for (i, &p) in joint.columns.iter().enumerate() {
                rhs[p] += weight * sum.with_y[i];
                for (k, &q) in joint.columns.iter().enumerate() {
                    matrix[(p, q)] += weight * sum.gram[(i, k)];
                }
            }
        }
        let n = self.regulariser.mean.len();
        let mut corner = matrix.view_mut((0, 0), (n, n));
        corner += &self.regulariser.precision;
        let mut top = rhs.rows_mut(0, n);
        top += &self.regulariser.precision * &self.regulariser.mean;
        (matrix, rhs)
    }

    /// Prior mean of all unknowns; zero where there is no prior.
    fn held(&self) -> DVector<f64> {
        let mut x = DVector::zeros(self.unknowns);
        x.rows_mut(0, self.regulariser.mean.len()).copy_from(&self.regulariser.mean);
        x
    }

    /// Information of the whole data on the unknowns: `sum_j w_j A_j' A_j`, without the prior.
    pub fn information(&self, weights: &[f64]) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.unknowns, self.unknowns);
        for ((joint, sum), weight) in self.joints.iter().zip(&self.whole).zip(weights) {
            for (i, &p) in joint.columns.iter().enumerate() {
                for (k, &q) in joint.columns.iter().enumerate() {
                    matrix[(p, q)] += weight * sum.gram[(i, k)];
                }
            }
        }
        matrix
    }

    fn residuals(&self, sums: &[Part], x: &DVector<f64>) -> Vec<f64> {
        self.joints
            .iter()
            .zip(sums)
            .map(|(joint, sum)| {
                let local = DVector::from_iterator(joint.columns.len(), joint.columns.iter().map(|&c| x[c]));
                (sum.yy - 2.0 * local.dot(&sum.with_y) + local.dot(&(&sum.gram * &local)))
                    .max(1e-14 * sum.yy)
                    .max(1e-300)
            })
            .collect()
    }

    /// Weighted least squares. Each joint is weighted by its own residual, with weights iterated
    /// from `start`.
    pub fn solve(&self, start: Option<&[f64]>) -> Solution {
        let sums = &self.whole;
        let counts: Vec<f64> = sums.iter().map(|s| s.count).collect();
        let fresh = || sums.iter().map(|s| if s.yy > 0.0 { s.count / s.yy } else { 0.0 }).collect::<Vec<_>>();
        let mut weights = start.map_or_else(fresh, <[f64]>::to_vec);
        let mut round = 0;
        loop {
            let (matrix, rhs) = self.assemble(sums, &weights);
            let inverse = pseudo_inverse(&matrix);
            // Solve relative to the prior mean, so that undetermined directions stay there.
            let held = self.held();
            let x = &inverse * (&rhs - &matrix * &held) + held;
            let rss = self.residuals(sums, &x);
            round += 1;
            let next: Vec<f64> =
                rss.iter().zip(sums).map(|(r, s)| if s.yy > 0.0 { s.count / r } else { 0.0 }).collect();
            let change =
                weights.iter().zip(&next).map(|(a, b)| (a - b).abs() / (a + b).max(1e-300)).fold(0.0, f64::max);
            if round >= 8 || change < 1e-3 {
                return Solution { x, weights, rss, counts, inverse, unlimited: None };
            }
            weights = next;
        }
    }

    /// Normal matrix and right-hand side of the whole data with these weights and the regulariser.
    pub fn normal(&self, weights: &[f64]) -> (DMatrix<f64>, DVector<f64>) {
        self.assemble(&self.whole, weights)
    }

    /// Root mean square of each joint's torque, N m.
    pub fn torque(&self) -> Vec<f64> {
        self.whole.iter().map(|s| (s.yy / s.count.max(1.0)).sqrt()).collect()
    }

    /// The solution with the unknowns `own` fixed at `values`, all others refitted.
    pub fn limited(&self, solution: &Solution, own: &[usize], values: &DVector<f64>) -> Solution {
        let (x, inverse) = refitted_beside(&solution.x, &solution.inverse, own, values);
        let unlimited = Some(solution.inverse.clone());
        Solution { rss: self.residuals(&self.whole, &x), x, inverse, unlimited, ..solution.clone() }
    }

    /// The solution with other values of the unknowns.
    pub fn at(&self, solution: &Solution, x: DVector<f64>) -> Solution {
        Solution { rss: self.residuals(&self.whole, &x), x, ..solution.clone() }
    }

    /// Sums of squared residuals per part and joint, each part predicted from all others, with the
    /// weights of `whole`.
    pub fn cross_validated(&self, whole: &Solution) -> Vec<Vec<f64>> {
        self.cross_validated_without(whole, &[], &[])
    }

    /// The same with some unknowns at 0 (`out`), and others (`fixed`) at their values in `whole`,
    /// since no other part determines them.
    pub fn cross_validated_without(&self, whole: &Solution, out: &[usize], fixed: &[usize]) -> Vec<Vec<f64>> {
        let held = self.held();
        let plain = |matrix: &DMatrix<f64>, rhs: &DVector<f64>| {
            Ok::<_, std::convert::Infallible>(pseudo_inverse(matrix) * (rhs - matrix * &held) + &held)
        };
        match self.cross_validated_by(whole, &whole.weights, out, fixed, plain) {
            Ok(sums) => sums,
            Err(never) => match never {},
        }
    }

    /// The same with constrained unknowns. `limit` returns the unknowns at a limit with their
    /// values, from a solution and the inverse of its normal matrix.
    pub fn cross_validated_within(
        &self,
        whole: &Solution,
        fixed: &[usize],
        limit: impl Fn(&DVector<f64>, &DMatrix<f64>) -> Option<(Vec<usize>, DVector<f64>)> + Sync,
    ) -> Vec<Vec<f64>> {
        let held = self.held();
        let solve = |matrix: &DMatrix<f64>, rhs: &DVector<f64>| {
            let inverse = pseudo_inverse(matrix);
            let x = &inverse * (rhs - matrix * &held) + &held;
            Ok::<_, std::convert::Infallible>(match limit(&x, &inverse) {
                Some((own, values)) => refitted_beside(&x, &inverse, &own, &values).0,
                None => x,
            })
        };
        match self.cross_validated_by(whole, &whole.weights, &[], fixed, solve) {
            Ok(sums) => sums,
            Err(never) => match never {},
        }
    }

    /// The same with any solver of the normal equations and these weights.
    ///
    /// # Errors
    /// Errors of the solver.
    pub fn cross_validated_by<E: Send>(
        &self,
        whole: &Solution,
        weights: &[f64],
        out: &[usize],
        fixed: &[usize],
        solve: impl Fn(&DMatrix<f64>, &DVector<f64>) -> Result<DVector<f64>, E> + Sync,
    ) -> Result<Vec<Vec<f64>>, E> {
        let without = |part: usize| {
            let sums = self.sums(|b| b != part);
            let (mut matrix, mut rhs) = self.assemble(&sums, weights);
            for &k in fixed {
                rhs.axpy(-whole.x[k], &matrix.column(k), 1.0);
            }
            for &k in out.iter().chain(fixed) {
                matrix.row_mut(k).fill(0.0);
                matrix.column_mut(k).fill(0.0);
                rhs[k] = 0.0;
            }
            let mut x = solve(&matrix, &rhs)?;
            fixed.iter().for_each(|&k| x[k] = whole.x[k]);
            Ok(self.residuals(&self.sums(|b| b == part), &x))
        };
        parallel(threads(), self.parts(), without).into_iter().collect()
    }

    /// Residual series of each joint, zero where a window is not used.
    pub fn residual(&self, x: &DVector<f64>) -> Vec<Vec<f64>> {
        parallel(self.threads(), self.joints.len(), |j| {
            let (joint, mut e) = (&self.joints[j], self.y[j].clone());
            for (&c, series) in joint.columns.iter().zip(&joint.series) {
                e.iter_mut().zip(series.iter()).for_each(|(e, s)| *e -= x[c] * s);
            }
            e
        })
    }

    /// Number of threads for a pass over the series of all joints.
    fn threads(&self) -> usize {
        threads_for(self.y.iter().map(Vec::len).sum())
    }

    /// Replaces the regulariser.
    pub fn regularised_by(&mut self, regulariser: Regulariser) {
        self.regulariser = regulariser;
    }

    /// Number of windows per part and joint.
    pub fn counts(&self) -> Vec<Vec<f64>> {
        (0..self.parts()).map(|part| self.joints.iter().map(|j| j.parts[part].count).collect()).collect()
    }

    /// Products of further columns with the present ones.
    pub fn trial(&self, terms: &[&Column]) -> Trial {
        let mut touched: Vec<usize> = terms.iter().flat_map(|t| t.rows.iter().map(|r| r.0)).collect();
        touched.sort_unstable();
        touched.dedup();
        let joints = touched
            .into_iter()
            .map(|j| {
                let here: Vec<(usize, &[f64])> = terms
                    .iter()
                    .enumerate()
                    .filter_map(|(i, t)| t.rows.iter().find(|r| r.0 == j).map(|r| (i, &r.1[..])))
                    .collect();
                let joint = &self.joints[j];
                let others: Vec<&[f64]> = joint.series.iter().map(|s| &s[..]).collect();
                let own: Vec<&[f64]> = here.iter().map(|h| h.1).collect();
                let of = |with: &[&[f64]]| -> Vec<f64> { own.iter().flat_map(|o| products_of_part(o, with)).collect() };
                TrialJoint {
                    joint: j,
                    terms: here.iter().map(|h| h.0).collect(),
                    cross: DMatrix::from_vec(others.len(), own.len(), of(&others)),
                    gram: DMatrix::from_vec(own.len(), own.len(), of(&own)),
                    with_y: DVector::from_vec(of(&[&self.y[j][..]])),
                }
            })
            .collect();
        Trial { terms: terms.len(), joints }
    }

    /// Normal equations of the trial's columns with the others refitted; `None` where the others
    /// already explain the same.
    pub fn reduced(&self, at: &Solution, trial: &Trial) -> Option<Reduced> {
        let (n, k) = (self.unknowns, trial.terms);
        let (mut cross, mut gram, mut rhs) = (DMatrix::zeros(n, k), DMatrix::zeros(k, k), DVector::zeros(k));
        for part in &trial.joints {
            let (joint, weight) = (&self.joints[part.joint], at.weights[part.joint]);
            for (b, &t) in part.terms.iter().enumerate() {
                rhs[t] += weight * part.with_y[b];
                for (a, &c) in joint.columns.iter().enumerate() {
                    cross[(c, t)] += weight * part.cross[(a, b)];
                }
                for (a, &u) in part.terms.iter().enumerate() {
                    gram[(u, t)] += weight * part.gram[(a, b)];
                }
            }
        }
        let solved = &at.inverse * &cross;
        let normal = &gram - cross.transpose() * &solved;
        // The part of a column that is independent of the others must exceed rounding.
        if (0..k).all(|t| normal[(t, t)] <= 1e-7 * gram[(t, t)]) {
            return None;
        }
        let rhs = rhs - cross.transpose() * &at.x;
        Some(Reduced { normal, rhs, solved })
    }

    /// The gain with these coefficients of the trial's columns.
    pub fn gain_at(&self, at: &Solution, trial: &Trial, reduced: &Reduced, x: DVector<f64>) -> Gain {
        let others = &at.x - &reduced.solved * &x;
        let sum = |(j, sum): (usize, &Part)| {
            let columns = &self.joints[j].columns;
            let local = DVector::from_iterator(columns.len(), columns.iter().map(|&c| others[c]));
            let mut rss = sum.yy - 2.0 * local.dot(&sum.with_y) + local.dot(&(&sum.gram * &local));
            if let Some(part) = trial.joints.iter().find(|p| p.joint == j) {
                let own = DVector::from_iterator(part.terms.len(), part.terms.iter().map(|&t| x[t]));
                rss += own.dot(&(&part.gram * &own)) - 2.0 * own.dot(&part.with_y)
                    + 2.0 * local.dot(&(&part.cross * &own));
            }
            rss.max(1e-14 * sum.yy).max(1e-300)
        };
        let rss = self.whole.iter().enumerate().map(sum).collect();
        Gain { x: x.iter().copied().collect(), rss }
    }
}

/// [`products`] of a series that may be zero outside a part.
fn products_of_part(one: &[f64], others: &[&[f64]]) -> Vec<f64> {
    let begin = one.iter().position(|x| *x != 0.0).unwrap_or(0) / 8 * 8;
    let end = one.iter().rposition(|x| *x != 0.0).map_or(0, |last| (last + 1).next_multiple_of(8).min(one.len()));
    let part = begin..end.max(begin);
    let others: Vec<&[f64]> = others.iter().map(|other| &other[part.clone()]).collect();
    products(&one[part], &others)
}

/// Inner products of a series with others, in the widest registers of this processor, bitwise equal
/// to any other width.
#[multiversion::multiversion(targets("x86_64+avx2"))]
fn products(one: &[f64], others: &[&[f64]]) -> Vec<f64> {
    let (fours, rest) = others.as_chunks::<4>();
    let mut all = Vec::with_capacity(others.len());
    for four in fours {
        all.extend(dots_of(one, *four));
    }
    for other in rest {
        all.push(dot(one, other));
    }
    all
}

/// Normal matrix of some unknowns with all others refitted, from the inverse of the whole matrix.
pub fn reduced_normal(inverse: &DMatrix<f64>, own: &[usize]) -> DMatrix<f64> {
    pseudo_inverse(&inverse.select_rows(own).select_columns(own))
}

/// A least-squares solution and the inverse of its normal matrix with some unknowns fixed at
/// `values`, all others refitted.
pub fn refitted_beside(
    x: &DVector<f64>,
    inverse: &DMatrix<f64>,
    own: &[usize],
    values: &DVector<f64>,
) -> (DVector<f64>, DMatrix<f64>) {
    let across = inverse.select_columns(own) * reduced_normal(inverse, own);
    let mut next = x + &across * (values - x.select_rows(own));
    let mut rest = inverse - &across * inverse.select_rows(own);
    for (i, &k) in own.iter().enumerate() {
        next[k] = values[i];
        rest.row_mut(k).fill(0.0);
        rest.column_mut(k).fill(0.0);
    }
    (next, rest)
}

/// Pseudo-inverse of a symmetric positive semidefinite matrix, scaled to a unit diagonal.
pub fn pseudo_inverse(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let n = matrix.nrows();
    let scale: Vec<f64> =
        (0..n).map(|i| if matrix[(i, i)] > 0.0 { matrix[(i, i)].sqrt().recip() } else { 0.0 }).collect();
    let scaled = DMatrix::from_fn(n, n, |i, k| matrix[(i, k)] * scale[i] * scale[k]);
    if n == 1 {
        return DMatrix::from_element(1, 1, if matrix[(0, 0)] > 0.0 { matrix[(0, 0)].recip() } else { 0.0 });
    }
    if let Some(root) = scaled.clone().cholesky() {
        let l = root.l_dirty();
        let least = (0..n).map(|i| l[(i, i)]).fold(f64::INFINITY, f64::min);
        if least > 1e-4 {
            let mut inverse = root.inverse();
            for i in 0..n {
                for k in 0..n {
                    inverse[(i, k)] *= scale[i] * scale[k];
                }
            }
            return inverse;
        }
    }
    let eigen = eigen::symmetric(scaled);
    let largest = eigen.eigenvalues.iter().fold(0.0_f64, |m, v| m.max(*v));
    let mut inverse = DMatrix::zeros(n, n);
    for (value, vector) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()) {
        if *value > 1e-9 * largest {
            inverse.ger(1.0 / value, &vector, &vector, 1.0);
        }
    }
    for i in 0..n {
        for k in 0..n {
            inverse[(i, k)] *= scale[i] * scale[k];
        }
    }
    inverse
}

impl Moments {
    /// Covariance of the unknowns where the residuals of joint `j` are correlated over
    /// `inflation[j]` windows, `A^-1 (sum_j w_j lambda_j A_j' A_j) A^-1`. Each unknown's standard
    /// deviation is at least its scatter between the parts of the data: `A^-1 (sum_p g_p g_p') A^-1
    /// P / (P - 1)`, `g_p` the gradient of part `p` (P. J. Huber 1967; K.-Y. Liang and S. L. Zeger,
    /// Biometrika 73, 1986). The second estimate detects a wrong law: its residual correlates with
    /// the motion, unlike noise.
    pub fn covariance(&self, at: &Solution, inflation: &[f64]) -> DMatrix<f64> {
        let weights: Vec<f64> = at.weights.iter().zip(inflation).map(|(w, l)| w * l).collect();
        let mut middle = self.information(&weights);
        // The file may be wrong in the directions that the prior fixes.
        let n = self.regulariser.mean.len();
        let mut corner = middle.view_mut((0, 0), (n, n));
        corner += &self.regulariser.spread;
        let inverse = at.unlimited.as_ref().unwrap_or(&at.inverse);
        let mut covariance = inverse * middle * inverse;
        let seen = self.pulled_to_and_fro(at);
        let by: Vec<f64> = (0..self.unknowns)
            .map(|i| match covariance[(i, i)] {
                usual if usual > 0.0 => (seen[i] / usual).max(1.0).sqrt(),
                _ => 1.0,
            })
            .collect();
        for i in 0..self.unknowns {
            for k in 0..self.unknowns {
                covariance[(i, k)] *= by[i] * by[k];
            }
        }
        covariance
    }

    /// Recurrence of a set of unknowns over the parts of the data. It is 1 if each part by itself,
    /// all else as found, gives them the size of the whole. It tends to 0 if parts give them other
    /// sizes, or none. `1 / (1 + s^2)`, `s` the deviation of the parts' factors from 1, each part
    /// weighted by its information. `own`: each unknown with its size, which for a delay is larger
    /// than the remainder that is fitted.
    pub fn recurrence(&self, at: &Solution, own: &[(usize, f64)]) -> f64 {
        let (mut off, mut all) = (0.0, 0.0);
        for part in 0..self.parts() {
            let (mut information, mut pull) = (0.0, 0.0);
            for (joint, weight) in self.joints.iter().zip(&at.weights) {
                let sums = &joint.parts[part];
                let entries = |of: &dyn Fn(usize) -> f64| {
                    DVector::from_iterator(joint.columns.len(), joint.columns.iter().map(|&c| of(c)))
                };
                let fitted = entries(&|c| at.x[c]);
                let ours = entries(&|c| own.iter().find(|(k, _)| *k == c).map_or(0.0, |(_, size)| *size));
                information += weight * ours.dot(&(&sums.gram * &ours));
                pull += weight * ours.dot(&(&sums.with_y - &sums.gram * fitted));
            }
            if information > 0.0 {
                off += pull.powi(2) / information;
                all += information;
            }
        }
        if all > 0.0 { 1.0 / (1.0 + off / all) } else { 0.0 }
    }

    /// Variance of each unknown from the scatter of the parts' gradients about their mean.
    fn pulled_to_and_fro(&self, at: &Solution) -> DVector<f64> {
        let mut pulls = Vec::new();
        for part in 0..self.parts() {
            let mut gradient = DVector::zeros(self.unknowns);
            let mut count = 0.0;
            for (joint, weight) in self.joints.iter().zip(&at.weights) {
                let sums = &joint.parts[part];
                let local = DVector::from_iterator(joint.columns.len(), joint.columns.iter().map(|&c| at.x[c]));
                let left = &sums.with_y - &sums.gram * local;
                joint.columns.iter().zip(left.iter()).for_each(|(&c, g)| gradient[c] += weight * g);
                count += sums.count;
            }
            if count > 0.0 {
                pulls.push(at.unlimited.as_ref().unwrap_or(&at.inverse) * gradient);
            }
        }
        let parts = pulls.len() as f64;
        let mut spread = DVector::zeros(self.unknowns);
        if pulls.len() > 1 {
            let mean = pulls.iter().fold(DVector::zeros(self.unknowns), |sum, p| sum + p) / parts;
            for pull in pulls {
                let off = pull - &mean;
                spread += off.component_mul(&off) * (parts / (parts - 1.0));
            }
        }
        spread
    }

    /// The same equations and solution with further columns, whose unknowns are zero, which is
    /// their optimum.
    pub fn beside(&self, at: &Solution, more: &[Column]) -> (Self, Solution) {
        let moments = self.with(&more.iter().collect::<Vec<&Column>>());
        let (matrix, _) = moments.assemble(&moments.whole, &at.weights);
        let x = at.x.clone().resize_vertically(moments.unknowns, 0.0);
        let solution = Solution { x, inverse: pseudo_inverse(&matrix), unlimited: None, ..at.clone() };
        (moments, solution)
    }
}
