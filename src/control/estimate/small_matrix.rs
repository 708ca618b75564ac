//! Linear algebra of fixed-size arrays for an estimator's step, without allocation and without
//! `std`.

/// Lower Cholesky factor of a symmetric matrix (its lower triangle is read); `None` where it is not
/// positive definite, or not finite.
pub(super) fn cholesky<const N: usize>(a: &[[f64; N]; N]) -> Option<[[f64; N]; N]> {
    let mut l = [[0.0; N]; N];
    for i in 0..N {
        for j in 0..=i {
            let mut sum = a[i][j];
            for k in 0..j {
                sum -= l[i][k] * l[j][k];
            }
            if i > j {
                l[i][j] = sum / l[j][j];
            } else if sum > 0.0 && sum < f64::INFINITY {
                l[i][i] = libm::sqrt(sum);
            } else {
                return None;
            }
        }
    }
    Some(l)
}

/// Solves `L x = b` in place.
pub(super) fn forward<const N: usize>(l: &[[f64; N]; N], b: &mut [f64; N]) {
    for i in 0..N {
        for k in 0..i {
            b[i] -= l[i][k] * b[k];
        }
        b[i] /= l[i][i];
    }
}

/// Solves `L' x = b` in place.
pub(super) fn backward<const N: usize>(l: &[[f64; N]; N], b: &mut [f64; N]) {
    for i in (0..N).rev() {
        for k in i + 1..N {
            b[i] -= l[k][i] * b[k];
        }
        b[i] /= l[i][i];
    }
}

/// `(L L')^-1`.
pub(super) fn inverse<const N: usize>(l: &[[f64; N]; N]) -> [[f64; N]; N] {
    let mut out = [[0.0; N]; N];
    for (k, row) in out.iter_mut().enumerate() {
        row[k] = 1.0;
        forward(l, row);
        backward(l, row);
    }
    out
}

/// `x . y`.
pub(super) fn dot<const N: usize>(x: &[f64; N], y: &[f64; N]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

/// `A x`.
pub(super) fn times<const R: usize, const C: usize>(a: &[[f64; C]; R], x: &[f64; C]) -> [f64; R] {
    core::array::from_fn(|i| dot(&a[i], x))
}

/// `A' x`.
pub(super) fn transposed_times<const R: usize, const C: usize>(a: &[[f64; C]; R], x: &[f64; R]) -> [f64; C] {
    core::array::from_fn(|j| (0..R).map(|i| a[i][j] * x[i]).sum())
}

/// `A S A'`.
pub(super) fn sandwich<const R: usize, const C: usize>(a: &[[f64; C]; R], s: &[[f64; C]; C]) -> [[f64; R]; R] {
    let half: [[f64; C]; R] = core::array::from_fn(|i| transposed_times(s, &a[i]));
    core::array::from_fn(|i| core::array::from_fn(|j| dot(&half[i], &a[j])))
}

/// Whether all numbers are finite.
pub(super) fn finite(values: &[f64]) -> bool {
    values.iter().all(|v| v.is_finite())
}
