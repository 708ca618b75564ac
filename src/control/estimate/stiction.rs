//! Static friction in contact detection: at rest it is an interval, not a number.
//!
//! A joint at rest is held by friction of any value within its breakaway level. A residual torque
//! is then no contact as long as *some* friction within all intervals explains it. It is no proof
//! that there is no contact either.

use crate::control::estimate::small_matrix::{dot, forward};

/// Breakaway level above the Coulomb level, as a share of the torque limit: the default of
/// `stribeck_friction` in the table of effects.
const BREAKAWAY: f64 = 0.01;
/// Upper bound of a drive's static friction if the model has none, as a share of the torque limit:
/// a UR10e at rest shows up to 0.04.
const UNKNOWN: f64 = 0.05;

/// Largest static friction of a joint, N m, from its Coulomb level, N m, the breakaway level if one
/// is given, N m, and its torque limit (infinite if unknown), N m.
pub(crate) fn breakaway(coulomb: f64, stated: Option<f64>, limit: f64) -> f64 {
    let limit = if limit.is_finite() { limit } else { 0.0 };
    match stated {
        Some(level) => level.max(coulomb),
        None if coulomb > 0.0 => coulomb + BREAKAWAY * limit,
        None => UNKNOWN * limit,
    }
}

/// Number of sweeps over the joints: a few suffice where columns are nearly orthogonal, as whitened
/// torques of single joints are.
const SWEEPS: usize = 60;

/// Solves `error = B f + noise` for the friction `|f_j| <= breakaway_j` that explains most of the
/// error. `column(j)` is a column of `B`, and `root` the Cholesky factor of the noise covariance.
/// Returns the chi-square of the noise for this friction and for none. The method is coordinate
/// descent on a convex function within a box.
pub(super) fn least<const M: usize, const N: usize>(
    root: &[[f64; M]; M],
    error: &[f64; M],
    column: impl Fn(usize) -> [f64; M],
    breakaway: &[f64; N],
) -> [f64; 2] {
    let mut left = *error;
    forward(root, &mut left);
    let none = dot(&left, &left);
    let columns: [[f64; M]; N] = core::array::from_fn(|j| {
        let mut white = column(j);
        forward(root, &mut white);
        white
    });
    let sizes: [f64; N] = core::array::from_fn(|j| dot(&columns[j], &columns[j]));
    let mut friction = [0.0; N];
    for _ in 0..SWEEPS {
        let before = dot(&left, &left);
        for j in (0..N).filter(|&j| breakaway[j] > 0.0 && sizes[j] > 0.0) {
            let best = friction[j] + dot(&columns[j], &left) / sizes[j];
            let best = best.max(-breakaway[j]).min(breakaway[j]);
            let step = best - friction[j];
            (0..M).for_each(|i| left[i] -= step * columns[j][i]);
            friction[j] = best;
        }
        if before - dot(&left, &left) <= 1e-6 * before {
            break;
        }
    }
    [dot(&left, &left), none]
}

/// The `j`th column of the identity.
pub(super) fn unit<const N: usize>(j: usize) -> [f64; N] {
    core::array::from_fn(|i| f64::from(u8::from(i == j)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::estimate::small_matrix::cholesky;

    #[test]
    fn friction_explains_what_lies_within_its_level() {
        let root = cholesky(&[[0.04, 0.01], [0.01, 0.09]]).unwrap();
        let at = |error: [f64; 2], level: [f64; 2]| least(&root, &error, unit::<2>, &level);
        let [within, none] = at([3.0, -2.0], [4.0, 2.0]);
        assert!(within < 1e-9 && none > 200.0, "{within} {none}");
        // One joint is at rest, the other moves.
        let [half, none] = at([3.0, -2.0], [4.0, 0.0]);
        assert!(half > 40.0 && half < none, "{half} {none}");
        let [moving, none] = at([3.0, -2.0], [0.0; 2]);
        assert_eq!(moving, none);
    }

    /// Compares the minimum with a fine grid over the box.
    #[test]
    fn it_is_the_least() {
        let root = cholesky(&[[0.5, 0.3], [0.3, 0.4]]).unwrap();
        let (error, level) = ([2.0, -1.0], [1.2, 0.7]);
        let [found, _] = least(&root, &error, unit::<2>, &level);
        let mut best = f64::INFINITY;
        for a in -100..=100 {
            for b in -100..=100 {
                let mut left = [error[0] - level[0] * f64::from(a) / 100.0, error[1] - level[1] * f64::from(b) / 100.0];
                forward(&root, &mut left);
                best = best.min(dot(&left, &left));
            }
        }
        assert!((found - best).abs() < 1e-3 * best, "{found} {best}");
    }
}
