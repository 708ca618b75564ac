//! DH frames of all rows in the world frame.
//!
//! `out[i]` is the top three rows of the homogeneous matrix `T(0, i+1)`, m and one. Khalil and
//! Dombre, 3.2.
//!
//! 12 multiplications, 11 additions; 4 x 3 x 4, 30 of 48 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 30;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 4), (0, 5), (0, 10), (0, 11), (1, 0), (1, 1), (1, 3), (1, 4),
    (1, 5), (1, 7), (1, 10), (1, 11), (2, 0), (2, 1), (2, 3), (2, 4), (2, 5), (2, 7),
    (2, 10), (2, 11), (3, 0), (3, 1), (3, 3), (3, 4), (3, 5), (3, 7), (3, 10), (3, 11),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 12 + PATTERN[k].1
}

/// DH frames of all rows in the world frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[[S; 4]; 3]; 4]) {
    let flat = &mut out.as_flattened_mut().as_flattened_mut()[..];
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            1 => clear(&mut flat[2..4]),
            3 => clear(&mut flat[6..10]),
            7 => flat[14] = S::default(),
            10 => flat[18] = S::default(),
            11 => clear(&mut flat[20..22]),
            15 => flat[26] = S::default(),
            18 => flat[30] = S::default(),
            19 => clear(&mut flat[32..34]),
            23 => flat[38] = S::default(),
            26 => flat[42] = S::default(),
            27 => clear(&mut flat[44..46]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [[[S; 4]; 3]; 4]) {
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
    let [_, _, q3, ..] = trig.q;
    let [s1, s2, _, s4] = trig.sin;
    let [c1, c2, _, c4] = trig.cos;
    let k3 = S::constant(1.0);
    let k4 = S::constant(-1.0);
    let k_H = S::constant(constants::H);
    let k_L1 = S::constant(constants::L1);
    let k_L2 = S::constant(constants::L2);
    // frame 2
    let [t0, t1, t4, t7] = {
        let t0 = c1 * k_L1;
        let t1 = s1 * k_L1;
        let t4 = c1 * c2 - s1 * s2;
        let t7 = s1 * c2 + c1 * s2;
        let t8 = -t7;
        let t9 = -t4;
        put(0, c1); // [0][0][0]
        put(2, s1); // [0][1][0]
        put(3, c1); // [0][1][1]
        put(4, k3); // [0][2][2]
        put(5, k_H); // [0][2][3]
        put(6, t4); // [1][0][0]
        put(7, t8); // [1][0][1]
        put(8, t0); // [1][0][3]
        put(9, t7); // [1][1][0]
        put(10, t4); // [1][1][1]
        put(11, t1); // [1][1][3]
        put(12, k3); // [1][2][2]
        put(13, k_H); // [1][2][3]
        put(14, t4); // [2][0][0]
        put(15, t7); // [2][0][1]
        put(17, t7); // [2][1][0]
        put(18, t9); // [2][1][1]
        put(20, k4); // [2][2][2]
        put(28, k4); // [3][2][2]
        [t0, t1, t4, t7]
    };
    // frame 3
    {
        let t12 = t0 + k_L2 * t4;
        let t13 = t1 + k_L2 * t7;
        let t14 = k_H - q3;
        put(16, t12); // [2][0][3]
        put(19, t13); // [2][1][3]
        put(21, t14); // [2][2][3]
        put(24, t12); // [3][0][3]
        put(27, t13); // [3][1][3]
        put(29, t14); // [3][2][3]
    }
    // frame 4
    {
        let t17 = c4 * t4 + s4 * t7;
        let t20 = c4 * t7 - s4 * t4;
        let t21 = -s1;
        let t22 = -t17;
        put(1, t21); // [0][0][1]
        put(22, t17); // [3][0][0]
        put(23, t20); // [3][0][1]
        put(25, t20); // [3][1][0]
        put(26, t22); // [3][1][1]
    }
}
