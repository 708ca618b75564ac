//! Small linear subspaces in echelon form: detects new vectors and linear combinations.

/// Magnitude that counts as zero, relative to the input vector. Calibrated arms differ from nominal
/// ones by 1e-4 and its square; rounding stays below 1e-14.
const NOTHING: f64 = 1e-10;
/// Rounding residue of an exact zero after elimination.
const ROUNDING: f64 = 1e-14;
/// Least size of a column's entry in its row, relative to the row's largest, for the column to be
/// bound: tried in this order. A twist of 1.5716 is nearly a right angle, and binding the nearly
/// vanishing column would give groupings with factors of 1e6.
const THRESHOLDS: [f64; 3] = [0.05, 1e-3, 0.0];

/// A subspace spanned by rows in reduced echelon form.
#[derive(Debug, Clone, Default)]
pub(super) struct Subspace {
    rows: Vec<Vec<f64>>,
    pivots: Vec<usize>,
}

impl Subspace {
    pub fn rows(&self) -> &[Vec<f64>] {
        &self.rows
    }

    /// Adds a vector; its largest remaining entry becomes the pivot.
    pub fn insert(&mut self, vector: &[f64]) {
        let largest = |v: &[f64]| {
            v.iter().enumerate().fold((0, 0.0f64), |best, (k, x)| if x.abs() > best.1 { (k, x.abs()) } else { best })
        };
        let (_, size) = largest(vector);
        if size == 0.0 {
            return;
        }
        let mut v: Vec<f64> = vector.iter().map(|x| x / size).collect();
        for (row, &pivot) in self.rows.iter().zip(&self.pivots) {
            eliminate(&mut v, row, pivot);
        }
        let (pivot, left) = largest(&v);
        if left <= NOTHING {
            return;
        }
        let lead = v[pivot];
        v.iter_mut().for_each(|x| *x = if x.abs() <= ROUNDING { 0.0 } else { *x / lead });
        for row in &mut self.rows {
            eliminate(row, &v, pivot);
        }
        self.rows.push(v);
        self.pivots.push(pivot);
    }

    /// Null space of these rows as constraints: columns are bound in the order `keep`, and those
    /// that can't be bound are free. For each free column: its index, and the vector with one there
    /// and zero in all other free columns.
    pub fn null_space(&self, keep: &[usize]) -> Vec<(usize, Vec<f64>)> {
        let mut rows = self.rows.clone();
        let mut bound: Vec<(usize, usize)> = Vec::new(); // (column, row)
        for threshold in THRESHOLDS {
            for &column in keep {
                if bound.iter().any(|&(c, _)| c == column) {
                    continue;
                }
                let used: Vec<usize> = bound.iter().map(|&(_, row)| row).collect();
                let candidate = (0..rows.len())
                    .filter(|r| !used.contains(r))
                    .max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()));
                let large = |r: &usize| {
                    let largest = rows[*r].iter().fold(0.0f64, |m, x| m.max(x.abs()));
                    rows[*r][column].abs() > (threshold * largest).max(NOTHING)
                };
                let Some(row) = candidate.filter(large) else { continue };
                let lead = rows[row][column];
                let scaled: Vec<f64> = rows[row].iter().map(|x| x / lead).collect();
                for (other, r) in rows.iter_mut().enumerate() {
                    if other != row {
                        eliminate(r, &scaled, column);
                    }
                }
                rows[row] = scaled;
                bound.push((column, row));
            }
        }
        let free = keep.iter().copied().filter(|c| bound.iter().all(|(b, _)| b != c));
        free.map(|column| {
            let mut vector = vec![0.0; keep.len()];
            vector[column] = 1.0;
            for &(b, row) in &bound {
                vector[b] = snapped(-rows[row][column]);
            }
            (column, vector)
        })
        .collect()
    }
}

fn eliminate(v: &mut [f64], row: &[f64], pivot: usize) {
    let factor = v[pivot];
    if factor != 0.0 {
        for (x, r) in v.iter_mut().zip(row) {
            *x -= factor * r;
        }
        v[pivot] = 0.0;
    }
}

/// Rounds to the nearest integer if the difference is a rounding error of elimination.
fn snapped(x: f64) -> f64 {
    let nearest = x.round();
    if (x - nearest).abs() < 1e-11 { nearest + 0.0 } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dependent_vectors_are_not_new() {
        let mut s = Subspace::default();
        for v in [[1.0, 2.0, 0.0], [0.0, 0.1, 0.3], [1.0, 2.1, 0.3]] {
            s.insert(&v);
        }
        assert_eq!(s.rows().len(), 2);
        let null = s.null_space(&[0, 1, 2]);
        assert_eq!(null.len(), 1);
        let (free, v) = &null[0];
        assert_eq!(*free, 2);
        assert!((v[0] - 6.0).abs() < 1e-12 && (v[1] + 3.0).abs() < 1e-12);
    }
}
