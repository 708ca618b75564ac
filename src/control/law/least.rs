//! A small damped least-squares problem, solved without square roots.

/// Solves `(J W J' + d tr(J W J') / 6) y = r` for `W` diagonal, by `L D L'`; `None` where it is
/// singular or not finite.
///
/// `J' y` is the least-norm joint motion for a twist `r` (`W = 1`). With `r = J W tau`, `y` is the
/// wrench whose torques `J' y` are closest to `tau` in the metric `W`: `(J')^+ tau`.
pub fn damped<const N: usize>(
    jacobian: &[[f64; N]; 6],
    weights: &[f64; N],
    right: &[f64; 6],
    damping: f64,
) -> Option<[f64; 6]> {
    let mut a = [[0.0; 6]; 6];
    for i in 0..6 {
        for k in 0..=i {
            a[i][k] = (0..N).map(|j| jacobian[i][j] * weights[j] * jacobian[k][j]).sum();
        }
    }
    let trace: f64 = (0..6).map(|i| a[i][i]).sum();
    for i in 0..6 {
        a[i][i] += damping * trace / 6.0;
    }
    solve(&mut a, right, trace)
}

/// Solves by `L D L'` of the lower triangle; a pivot below the rounding error of the trace is
/// singular.
pub(super) fn solve<const M: usize>(a: &mut [[f64; M]; M], right: &[f64; M], trace: f64) -> Option<[f64; M]> {
    factor(a, trace)?;
    let y = substitute(a, right);
    y.iter().all(|x| x.is_finite()).then_some(y)
}

/// Factors the lower triangle in place as `L D L'`; `None` if it is singular.
pub(super) fn factor<const M: usize>(a: &mut [[f64; M]; M], trace: f64) -> Option<()> {
    for k in 0..M {
        for j in 0..k {
            a[k][k] -= a[k][j] * a[k][j] * a[j][j];
        }
        // NaN is rejected too.
        if a[k][k].is_nan() || a[k][k] <= 1e-13 * trace {
            return None;
        }
        for i in k + 1..M {
            for j in 0..k {
                a[i][k] -= a[i][j] * a[k][j] * a[j][j];
            }
            a[i][k] /= a[k][k];
        }
    }
    Some(())
}

/// Solves for one right-hand side, given the result of [`factor`].
pub(super) fn substitute<const M: usize>(a: &[[f64; M]; M], right: &[f64; M]) -> [f64; M] {
    let mut y = *right;
    for i in 0..M {
        for j in 0..i {
            y[i] -= a[i][j] * y[j];
        }
    }
    for i in 0..M {
        y[i] /= a[i][i];
    }
    for i in (0..M).rev() {
        for j in i + 1..M {
            y[i] -= a[j][i] * y[j];
        }
    }
    y
}
