//! Cholesky factorisation `A = L L'` for the few unknowns of an arm, in place and without
//! allocation.

/// Factors the symmetric `n x n` matrix whose lower triangle is in `a` (row-major), and replaces it
/// by `L`. Returns `Err` with the row at which `A` is found not to be positive definite.
pub(crate) fn factor(n: usize, a: &mut [f64]) -> Result<(), usize> {
    for j in 0..n {
        let (above, below) = a.split_at_mut((j + 1) * n);
        let row = &mut above[j * n..=j * n + j];
        let pivot = row[j] - row[..j].iter().map(|x| x * x).sum::<f64>();
        if pivot.is_nan() || pivot <= 0.0 {
            return Err(j);
        }
        let root = pivot.sqrt();
        row[j] = root;
        for other in below.chunks_exact_mut(n).take(n - j - 1) {
            let known: f64 = other[..j].iter().zip(&row[..j]).map(|(x, y)| x * y).sum();
            other[j] = (other[j] - known) / root;
        }
    }
    Ok(())
}

/// Solves `L L' x = b` in place.
pub(crate) fn solve(n: usize, l: &[f64], x: &mut [f64]) {
    for i in 0..n {
        let row = &l[i * n..=i * n + i];
        let (done, rest) = x.split_at_mut(i);
        let known: f64 = row.iter().zip(done.iter()).map(|(l, x)| l * x).sum();
        rest[0] = (rest[0] - known) / row[i];
    }
    // Row by row in memory order: subtract each solved unknown from the others.
    for i in (0..n).rev() {
        let row = &l[i * n..=i * n + i];
        let (others, rest) = x.split_at_mut(i);
        rest[0] /= row[i];
        others.iter_mut().zip(row).for_each(|(x, l)| *x -= l * rest[0]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_and_refuses() {
        let a = [4.0, 1.0, 0.5, 1.0, 3.0, -0.2, 0.5, -0.2, 2.0];
        let mut l = a;
        factor(3, &mut l).unwrap();
        let mut x = [1.0, -2.0, 0.5];
        solve(3, &l, &mut x);
        for (i, b) in [1.0, -2.0, 0.5].iter().enumerate() {
            assert!(((0..3).map(|k| a[3 * i + k] * x[k]).sum::<f64>() - b).abs() < 1e-14);
        }
        assert_eq!(factor(2, &mut [1.0, 2.0, 2.0, 1.0]), Err(1));
    }
}
