//! Regressor at rest.
//!
//! `g = W_g phi` of the links' parameters; columns as the first of `STANDARD_NAMES`, without the
//! drives'.
//!
//! 0 multiplications, 0 additions; 4 x 40, 2 of 160 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{GRAVITY, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 2;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (2, 20), (2, 30),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 40 + PATTERN[k].1
}

/// Regressor at rest: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 40]; 4]) {
    let flat = &mut out.as_flattened_mut()[..];
    clear(&mut flat[0..100]);
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[101..110]),
            1 => clear(&mut flat[111..160]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 40]; 4]) {
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
    let _ = trig;
    let k0 = S::constant(GRAVITY[2]);
    // link 3: motion
    put(0, k0); // row 3, M3
    put(1, k0); // row 3, M4
}
