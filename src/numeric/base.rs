//! Numeric rank of the regressor, by the singular values of many states stacked.

use nalgebra::DMatrix;

use super::{Numeric, Random};

/// Rank, with the singular values on either side of the cut (of columns with unit norm): the wider apart, the surer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rank {
    /// Number of independent columns.
    pub rank: usize,
    /// Smallest singular value that counts, relative to the largest.
    pub last: f64,
    /// Largest that does not.
    pub next: f64,
}

/// Of the regressor over random states; `at_rest`: without motion.
pub fn rank(arm: &Numeric, seed: u64, states: usize, at_rest: bool) -> Rank {
    let mut random = Random::new(seed);
    let (n, p) = (arm.dof(), arm.parameters().len());
    let mut stack = DMatrix::zeros(n * states, p);
    for k in 0..states {
        let q = random.vector(n, 3.0);
        let (dq, ddq) =
            if at_rest { (vec![0.0; n], vec![0.0; n]) } else { (random.vector(n, 2.0), random.vector(n, 4.0)) };
        stack.rows_mut(k * n, n).copy_from(&arm.regressor(&q, &dq, &ddq));
    }
    for mut column in stack.column_iter_mut() {
        let norm = column.norm();
        if norm > 1e-12 {
            column /= norm;
        }
    }
    let values = stack.singular_values();
    let mut sorted: Vec<f64> = values.iter().copied().collect();
    sorted.sort_by(|a, b| b.total_cmp(a));
    let largest = sorted.first().copied().unwrap_or(0.0).max(f64::MIN_POSITIVE);
    let rank = sorted.iter().filter(|v| **v > 1e-9 * largest).count();
    let relative = |k: usize| sorted.get(k).map_or(0.0, |v| v / largest);
    Rank { rank, last: if rank > 0 { relative(rank - 1) } else { 0.0 }, next: relative(rank) }
}
