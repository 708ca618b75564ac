//! Computes the space in which tools differ: the paper's equation (8).
//!
//! The table's parameters are the columns of `Phi = [Phi_1 ... Phi_NT]` (`10 * N_T`), and `Phi = U
//! S V'`. The first columns of `U` span the space; a tool has the coordinates `U_p' Phi_j` there.

use nalgebra::{DMatrix, DVector};

/// Principal components of a table of tools.
#[derive(Debug, Clone, PartialEq)]
pub struct Pca {
    /// Basis `U_p`, `10 * N`.
    pub basis: DMatrix<f64>,
    /// All singular values, descending.
    pub singular_values: Vec<f64>,
    /// Share of the sum of squares in the first `k + 1` components.
    pub explained: Vec<f64>,
}

impl Pca {
    /// Keeps as many components as are needed for this share of the sum of squares; at least one.
    /// As in the paper, the mean is not removed.
    pub fn new(table: &[[f64; 10]], share: f64) -> Self {
        if table.is_empty() {
            return Self { basis: DMatrix::zeros(10, 0), singular_values: Vec::new(), explained: Vec::new() };
        }
        let phi = DMatrix::from_fn(10, table.len(), |i, k| table[k][i]);
        let svd = phi.svd(true, false);
        let mut order: Vec<usize> = (0..svd.singular_values.len()).collect();
        order.sort_by(|&a, &b| svd.singular_values[b].total_cmp(&svd.singular_values[a]));
        let singular_values: Vec<f64> = order.iter().map(|&k| svd.singular_values[k]).collect();
        let total: f64 = singular_values.iter().map(|s| s * s).sum();
        let explained: Vec<f64> = singular_values
            .iter()
            .scan(0.0, |sum, s| {
                *sum += s * s;
                Some(if total > 0.0 { *sum / total } else { 1.0 })
            })
            .collect();
        let count = explained.iter().position(|e| *e >= share).map_or(order.len(), |k| k + 1);
        let u = svd.u.unwrap_or_else(|| DMatrix::zeros(10, order.len()));
        // The sign of a component is arbitrary: the largest entry is made positive.
        let columns: Vec<DVector<f64>> = order[..count]
            .iter()
            .map(|&k| {
                let column: DVector<f64> = u.column(k).into();
                if column[column.icamax()] < 0.0 { -column } else { column }
            })
            .collect();
        let basis = if columns.is_empty() { DMatrix::zeros(10, 0) } else { DMatrix::from_columns(&columns) };
        Self { basis, singular_values, explained }
    }

    /// Number of components, `N`.
    pub fn components(&self) -> usize {
        self.basis.ncols()
    }

    /// Coordinates `U_p' Phi`.
    pub fn scores(&self, values: &[f64; 10]) -> DVector<f64> {
        self.basis.transpose() * DVector::from_column_slice(values)
    }

    /// Distance `|U_p' (a - b)|` of the paper.
    pub fn distance(&self, a: &[f64; 10], b: &[f64; 10]) -> f64 {
        (self.scores(a) - self.scores(b)).norm()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_basis_is_orthonormal_and_holds_its_share() {
        let table: Vec<[f64; 10]> = super::super::catalogue::catalogue()
            .iter()
            .map(|t| t.inertia.unwrap().moved(&t.rotation(), &t.xyz).to_array())
            .collect();
        for share in [0.9, 0.999, 0.999999, 1.0] {
            let pca = Pca::new(&table, share);
            let n = pca.components();
            assert!((pca.basis.transpose() * &pca.basis - DMatrix::identity(n, n)).amax() < 1e-12);
            // Share of the table in the components, compared with `explained`.
            let all: f64 = table.iter().flatten().map(|v| v * v).sum();
            let held: f64 = table.iter().map(|t| pca.scores(t).norm_squared()).sum();
            assert!((held / all - pca.explained[n - 1]).abs() < 1e-12 && held / all >= share - 1e-9);
            assert!(n == 1 || pca.explained[n - 2] < share);
        }
        assert_eq!(Pca::new(&[], 0.9).components(), 0);
    }
}
