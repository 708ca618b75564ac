//! Jacobian of the last DH frame's origin, in world axes.
//!
//! `(v, w) = J dq`: rows 0-2 linear, m/s, rows 3-5 angular, rad/s. Khalil and Dombre, 5.2.
//!
//! 2 multiplications, 1 additions; 6 x 2, 4 of 12 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 4;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (1, 0), (5, 0), (5, 1),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 2 + PATTERN[k].1
}

/// Jacobian of the last DH frame's origin, in world axes: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 2]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => flat[1] = S::default(),
            1 => clear(&mut flat[3..10]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 2]; 6]) {
    entries(trig, |k, x| {
        out[PATTERN[k].0][PATTERN[k].1] = x;
    });
}

/// The same, only the entries of [`PATTERN`].
#[inline]
pub fn packed<S: Scalar>(trig: &Trig<S>, out: &mut [S; NONZEROS]) {
    entries(trig, |k, x| out[k] = x);
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, mut put: impl FnMut(usize, S)) {
    let [s1, ..] = trig.sin;
    let [c1, ..] = trig.cos;
    let k1 = S::constant(1.0);
    let k_L1 = S::constant(constants::L1);
    // frame 2
    let t0 = c1 * k_L1;
    let t2 = -(s1 * k_L1);
    put(0, t2); // [0][0]
    put(1, t0); // [1][0]
    put(2, k1); // [5][0]
    put(3, k1); // [5][1]
}
