//! DH frames of all rows in the world frame.
//!
//! `out[i]` is the top three rows of the homogeneous matrix `T(0, i+1)`, m and one. Khalil and
//! Dombre, 3.2.
//!
//! 46 multiplications, 33 additions; 6 x 3 x 4, 64 of 72 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 64;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 2), (0, 4), (0, 6), (0, 9), (0, 11), (1, 0), (1, 1), (1, 2), (1, 3),
    (1, 4), (1, 5), (1, 6), (1, 7), (1, 8), (1, 10), (1, 11), (2, 0), (2, 1), (2, 2),
    (2, 3), (2, 4), (2, 5), (2, 6), (2, 7), (2, 9), (2, 10), (2, 11), (3, 0), (3, 1),
    (3, 2), (3, 3), (3, 4), (3, 5), (3, 6), (3, 7), (3, 8), (3, 9), (3, 10), (3, 11),
    (4, 0), (4, 1), (4, 2), (4, 3), (4, 4), (4, 5), (4, 6), (4, 7), (4, 8), (4, 9),
    (4, 10), (4, 11), (5, 0), (5, 1), (5, 2), (5, 3), (5, 4), (5, 5), (5, 6), (5, 7),
    (5, 8), (5, 9), (5, 10), (5, 11),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 12 + PATTERN[k].1
}

/// DH frames of all rows in the world frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[[S; 4]; 3]; 6]) {
    let flat = &mut out.as_flattened_mut().as_flattened_mut()[..];
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => flat[1] = S::default(),
            1 => flat[3] = S::default(),
            2 => flat[5] = S::default(),
            3 => clear(&mut flat[7..9]),
            4 => flat[10] = S::default(),
            14 => flat[21] = S::default(),
            24 => flat[32] = S::default(),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [[[S; 4]; 3]; 6]) {
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
    let [s1, s2, _, s4, s5, s6] = trig.sin;
    let [c1, c2, _, c4, c5, c6] = trig.cos;
    let k3 = S::constant(-1.0);
    let k_D1 = S::constant(constants::D1);
    let k_D2 = S::constant(constants::D2);
    let k_D6 = S::constant(constants::D6);
    // frame 2
    let [t0, t1, t2, t3, t4, t5] = {
        let t0 = s1 * k_D2;
        let t1 = c1 * k_D2;
        let t2 = c1 * c2;
        let t3 = c1 * s2;
        let t4 = s1 * c2;
        let t5 = s1 * s2;
        let t6 = -t0;
        let t7 = -t3;
        let t8 = -t5;
        put(0, c1); // [0][0][0]
        put(2, s1); // [0][1][0]
        put(3, c1); // [0][1][2]
        put(4, k3); // [0][2][1]
        put(5, k_D1); // [0][2][3]
        put(6, t2); // [1][0][0]
        put(8, t3); // [1][0][2]
        put(9, t6); // [1][0][3]
        put(10, t4); // [1][1][0]
        put(11, c1); // [1][1][1]
        put(12, t5); // [1][1][2]
        put(13, t1); // [1][1][3]
        put(15, c2); // [1][2][2]
        put(16, k_D1); // [1][2][3]
        put(17, s1); // [2][0][0]
        put(18, t2); // [2][0][1]
        put(19, t3); // [2][0][2]
        put(22, t4); // [2][1][1]
        put(23, t5); // [2][1][2]
        put(26, c2); // [2][2][2]
        put(29, t7); // [3][0][1]
        put(33, t8); // [3][1][1]
        [t0, t1, t2, t3, t4, t5]
    };
    // frame 3
    let [t12, t13, t14] = {
        let t12 = q3 * t3 - t0;
        let t13 = t1 + q3 * t5;
        let t14 = k_D1 + c2 * q3;
        put(20, t12); // [2][0][3]
        put(24, t13); // [2][1][3]
        put(27, t14); // [2][2][3]
        put(31, t12); // [3][0][3]
        put(35, t13); // [3][1][3]
        put(39, t14); // [3][2][3]
        put(43, t12); // [4][0][3]
        put(47, t13); // [4][1][3]
        put(51, t14); // [4][2][3]
        [t12, t13, t14]
    };
    // frame 4
    let [t17, t20, t23, t26, t27, t28] = {
        let t17 = s1 * c4 + s4 * t2;
        let t20 = c4 * t2 - s1 * s4;
        let t23 = s4 * t4 - c1 * c4;
        let t26 = c4 * t4 + c1 * s4;
        let t27 = s2 * s4;
        let t28 = s2 * c4;
        let t29 = -t27;
        let t30 = -t28;
        put(28, t17); // [3][0][0]
        put(30, t20); // [3][0][2]
        put(32, t23); // [3][1][0]
        put(34, t26); // [3][1][2]
        put(36, t29); // [3][2][0]
        put(38, t30); // [3][2][2]
        put(41, t20); // [4][0][1]
        put(45, t26); // [4][1][1]
        put(49, t30); // [4][2][1]
        [t17, t20, t23, t26, t27, t28]
    };
    // frame 5
    let [t33, t36, t39, t42, t45, t48] = {
        let t33 = c5 * t17 - s5 * t3;
        let t36 = c5 * t3 + s5 * t17;
        let t39 = c5 * t23 - s5 * t5;
        let t42 = c5 * t5 + s5 * t23;
        let t45 = c5 * t27 + c2 * s5;
        let t48 = c2 * c5 - s5 * t27;
        let t49 = -t45;
        put(40, t33); // [4][0][0]
        put(42, t36); // [4][0][2]
        put(44, t39); // [4][1][0]
        put(46, t42); // [4][1][2]
        put(48, t49); // [4][2][0]
        put(50, t48); // [4][2][2]
        put(54, t36); // [5][0][2]
        put(58, t42); // [5][1][2]
        put(62, t48); // [5][2][2]
        [t33, t36, t39, t42, t45, t48]
    };
    // frame 6
    {
        let t53 = t12 + k_D6 * t36;
        let t54 = t13 + k_D6 * t42;
        let t55 = t14 + k_D6 * t48;
        let t58 = c6 * t33 + s6 * t20;
        let t61 = c6 * t20 - s6 * t33;
        let t64 = c6 * t39 + s6 * t26;
        let t67 = c6 * t26 - s6 * t39;
        let t73 = s6 * t45 - c6 * t28;
        let t74 = -s1;
        let t75 = -s2;
        let t76 = -c1;
        let t77 = -c2;
        let t78 = -(c6 * t45 + s6 * t28);
        put(1, t74); // [0][0][2]
        put(7, t74); // [1][0][1]
        put(14, t75); // [1][2][0]
        put(21, t76); // [2][1][0]
        put(25, t75); // [2][2][1]
        put(37, t77); // [3][2][1]
        put(52, t58); // [5][0][0]
        put(53, t61); // [5][0][1]
        put(55, t53); // [5][0][3]
        put(56, t64); // [5][1][0]
        put(57, t67); // [5][1][1]
        put(59, t54); // [5][1][3]
        put(60, t78); // [5][2][0]
        put(61, t73); // [5][2][1]
        put(63, t55); // [5][2][3]
    }
}
