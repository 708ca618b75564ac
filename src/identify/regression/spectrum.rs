//! Dense linear algebra on the small triangular factor: singular values, null space, inverse.

use nalgebra::{DMatrix, DVector};

use crate::identify::regression::r_factor::RFactor;

/// Factor of a least-squares problem `min |R x - z|`, with the norms of its columns for scaling.
#[derive(Debug, Clone)]
pub(in crate::identify) struct Small {
    /// Matrix `R`, upper triangular, `p * p`.
    pub(in crate::identify) r: DMatrix<f64>,
    /// Right-hand side `z`.
    pub(in crate::identify) z: DVector<f64>,
    /// Norm of each column; 1 for a zero column.
    pub(in crate::identify) scale: Vec<f64>,
}

impl Small {
    /// Takes `R` and `z` from the factor of `[A b]`.
    pub(in crate::identify) fn new(triangle: &RFactor) -> Self {
        let p = triangle.columns() - 1;
        let r = DMatrix::from_fn(p, p, |i, k| triangle.get(i, k));
        let z = DVector::from_fn(p, |i, _| triangle.get(i, p));
        let scale = r.column_iter().map(|c| c.norm()).map(|s| if s > 0.0 { s } else { 1.0 }).collect();
        Self { r, z, scale }
    }

    fn scaled(&self) -> DMatrix<f64> {
        let mut r = self.r.clone();
        for (mut column, s) in r.column_iter_mut().zip(&self.scale) {
            column /= *s;
        }
        r
    }

    /// Ratio of the largest to the smallest singular value of `R`, with unscaled columns and with
    /// columns of unit norm.
    pub(in crate::identify) fn conditions(&self) -> [f64; 2] {
        [&self.r, &self.scaled()].map(|r| {
            let s = r.singular_values();
            if s.is_empty() { 1.0 } else { s.max() / s.min() }
        })
    }

    /// Orthonormal basis (columns) of the undetermined combinations of scaled parameters: singular
    /// values of the scaled factor below `tolerance` times the largest.
    pub(in crate::identify) fn null_space(&self, tolerance: f64) -> DMatrix<f64> {
        let p = self.scale.len();
        let svd = self.scaled().svd(false, true);
        let Some(v_t) = svd.v_t else { return DMatrix::zeros(p, 0) };
        let floor = tolerance * svd.singular_values.iter().fold(0.0_f64, |m, s| m.max(*s));
        let rows: Vec<usize> = (0..p).filter(|&i| svd.singular_values[i] <= floor).collect();
        DMatrix::from_fn(p, rows.len(), |i, k| v_t[(rows[k], i)])
    }

    /// Matrix `G` with `G G' = (R' R)^-1`: the inverse of `R`, or, if the directions `null` are
    /// undetermined, the pseudo-inverse in scaled parameters. `G R` is then the projection on the
    /// determined directions.
    pub(in crate::identify) fn inverse(&self, null: &DMatrix<f64>) -> DMatrix<f64> {
        let p = self.scale.len();
        if null.ncols() == 0 {
            let mut inverse = DMatrix::identity(p, p);
            if self.r.solve_upper_triangular_mut(&mut inverse) {
                return inverse;
            }
        }
        let svd = self.scaled().svd(true, true);
        let (Some(u), Some(v_t)) = (svd.u, svd.v_t) else { return DMatrix::zeros(p, p) };
        let mut order: Vec<usize> = (0..p).collect();
        order.sort_by(|&a, &b| svd.singular_values[b].total_cmp(&svd.singular_values[a]));
        let mut inverse = DMatrix::zeros(p, p);
        for &k in &order[..p - null.ncols().min(p)] {
            if svd.singular_values[k] > 0.0 {
                inverse += v_t.row(k).transpose() * (u.column(k).transpose() / svd.singular_values[k]);
            }
        }
        for (mut row, s) in inverse.row_iter_mut().zip(&self.scale) {
            row /= *s;
        }
        inverse
    }

    /// Solution nearest to `prior` (in scaled parameters, if some directions are undetermined).
    pub(in crate::identify) fn solve(
        &self,
        inverse: &DMatrix<f64>,
        null: &DMatrix<f64>,
        prior: &DVector<f64>,
    ) -> DVector<f64> {
        if null.ncols() == 0 { inverse * &self.z } else { prior + inverse * (&self.z - &self.r * prior) }
    }
}

/// Groups of parameters coupled by a null space: parameters `i` and `k` belong together if entry
/// `(i, k)` of the projector on it is nonzero.
pub(in crate::identify) fn coupled(null: &DMatrix<f64>) -> Vec<Vec<usize>> {
    let projector = null * null.transpose();
    let p = null.nrows();
    let mut seen = vec![false; p];
    let mut groups = Vec::new();
    for start in 0..p {
        if seen[start] || projector[(start, start)] < 1e-8 {
            continue;
        }
        let (mut group, mut todo) = (Vec::new(), vec![start]);
        seen[start] = true;
        while let Some(i) = todo.pop() {
            group.push(i);
            for k in 0..p {
                if !seen[k] && projector[(k, k)] >= 1e-8 && projector[(i, k)].abs() > 1e-6 {
                    seen[k] = true;
                    todo.push(k);
                }
            }
        }
        group.sort_unstable();
        groups.push(group);
    }
    groups
}
