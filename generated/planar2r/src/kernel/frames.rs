//! DH frames of all rows in the world frame.
//!
//! `out[i]` is the top three rows of the homogeneous matrix `T(0, i+1)`, m and one. Khalil and
//! Dombre, 3.2.
//!
//! 6 multiplications, 4 additions; 2 x 3 x 4, 12 of 24 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 12;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 4), (0, 5), (0, 10), (1, 0), (1, 1), (1, 3), (1, 4), (1, 5),
    (1, 7), (1, 10),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 12 + PATTERN[k].1
}

/// DH frames of all rows in the world frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[[S; 4]; 3]; 2]) {
    let flat = &mut out.as_flattened_mut().as_flattened_mut()[..];
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            1 => clear(&mut flat[2..4]),
            3 => clear(&mut flat[6..10]),
            4 => flat[11] = S::default(),
            6 => flat[14] = S::default(),
            9 => flat[18] = S::default(),
            10 => clear(&mut flat[20..22]),
            11 => flat[23] = S::default(),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [[[S; 4]; 3]; 2]) {
    entries(trig, |k, x| {
        out[PATTERN[k].0][PATTERN[k].1 / 4][PATTERN[k].1 % 4] = x;
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
    let k1 = S::constant(1.0);
    let k_L1 = S::constant(constants::L1);
    // frame 2
    let t0 = c1 * k_L1;
    let t1 = s1 * k_L1;
    let t4 = c1 * c2 - s1 * s2;
    let t7 = s1 * c2 + c1 * s2;
    let t8 = -s1;
    let t9 = -t7;
    put(0, c1); // [0][0][0]
    put(1, t8); // [0][0][1]
    put(2, s1); // [0][1][0]
    put(3, c1); // [0][1][1]
    put(4, k1); // [0][2][2]
    put(5, t4); // [1][0][0]
    put(6, t9); // [1][0][1]
    put(7, t0); // [1][0][3]
    put(8, t7); // [1][1][0]
    put(9, t4); // [1][1][1]
    put(10, t1); // [1][1][3]
    put(11, k1); // [1][2][2]
}
