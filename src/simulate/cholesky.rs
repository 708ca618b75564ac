//! `A = L L'` for the few unknowns of an arm, in place and without allocation.

/// Factors the symmetric `n x n` matrix whose lower triangle stands in `a` (row-major) and leaves `L` there.
/// `Err` with the row where `A` is found not to be positive definite.
pub(super) fn factor(n: usize, a: &mut [f64]) -> Result<(), usize> {
    for j in 0..n {
        let mut pivot = a[j * n + j];
        for k in 0..j {
            pivot -= a[j * n + k] * a[j * n + k];
        }
        if pivot.is_nan() || pivot <= 0.0 {
            return Err(j);
        }
        let root = pivot.sqrt();
        a[j * n + j] = root;
        for i in j + 1..n {
            let mut entry = a[i * n + j];
            for k in 0..j {
                entry -= a[i * n + k] * a[j * n + k];
            }
            a[i * n + j] = entry / root;
        }
    }
    Ok(())
}

/// Solves `L L' x = b` in place.
pub(super) fn solve(n: usize, l: &[f64], x: &mut [f64]) {
    for i in 0..n {
        for k in 0..i {
            x[i] -= l[i * n + k] * x[k];
        }
        x[i] /= l[i * n + i];
    }
    for i in (0..n).rev() {
        for k in i + 1..n {
            x[i] -= l[k * n + i] * x[k];
        }
        x[i] /= l[i * n + i];
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
