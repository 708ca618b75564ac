//! Regressor at rest.
//!
//! `g = W_g phi` of the links' parameters; columns as the first of `STANDARD_NAMES`, without the
//! drives'.
//!
//! 10 multiplications, 5 additions; 2 x 20, 7 of 40 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 7;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 1), (0, 2), (0, 10), (0, 11), (0, 12), (1, 11), (1, 12),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 20 + PATTERN[k].1
}

/// Regressor at rest: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 20]; 2]) {
    let flat = &mut out.as_flattened_mut()[..];
    flat[0] = S::default();
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            1 => clear(&mut flat[3..10]),
            4 => clear(&mut flat[13..31]),
            6 => clear(&mut flat[33..40]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 20]; 2]) {
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
    let [s1, s2] = trig.sin;
    let [c1, c2] = trig.cos;
    let k0 = S::constant(-GRAVITY[1]);
    let k_L1 = S::constant(constants::L1);
    // link 1: motion
    let [a1_x, a1_y] = {
        let a1_x = s1 * k0;
        let a1_y = c1 * k0;
        let t2 = -a1_x;
        put(0, a1_y); // row 1, MSX1
        put(1, t2); // row 1, MSY1
        [a1_x, a1_y]
    };
    // link 2: motion
    let [a2_x, a2_y] = {
        let a2_x = c2 * a1_x + s2 * a1_y;
        let a2_y = c2 * a1_y - s2 * a1_x;
        let t9 = -a2_x;
        put(3, a2_y); // row 1, MSX2
        put(4, t9); // row 1, MSY2
        put(5, a2_y); // row 2, MSX2
        put(6, t9); // row 2, MSY2
        [a2_x, a2_y]
    };
    // joint axes in frame 2
    let [v1_2_x, v1_2_y] = {
        let v1_2_x = s2 * k_L1;
        let v1_2_y = c2 * k_L1;
        [v1_2_x, v1_2_y]
    };
    // M2: column
    {
        let t14 = a2_x * v1_2_x + a2_y * v1_2_y;
        put(2, t14); // row 1, M2
    }
}
