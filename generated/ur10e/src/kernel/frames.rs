//! DH frames of all rows in the world frame.
//!
//! `out[i]` is the top three rows of the homogeneous matrix `T(0, i+1)`, m and one. Khalil and
//! Dombre, 3.2.
//!
//! 64 multiplications, 50 additions; 6 x 3 x 4, 61 of 72 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 61;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 4), (0, 5), (0, 10), (0, 11), (1, 0), (1, 1), (1, 2), (1, 4),
    (1, 5), (1, 6), (1, 8), (1, 9), (1, 11), (2, 0), (2, 1), (2, 2), (2, 3), (2, 4),
    (2, 5), (2, 6), (2, 7), (2, 8), (2, 9), (2, 11), (3, 0), (3, 1), (3, 2), (3, 3),
    (3, 4), (3, 5), (3, 6), (3, 7), (3, 8), (3, 9), (3, 11), (4, 0), (4, 1), (4, 2),
    (4, 3), (4, 4), (4, 5), (4, 6), (4, 7), (4, 8), (4, 9), (4, 10), (4, 11), (5, 0),
    (5, 1), (5, 2), (5, 3), (5, 4), (5, 5), (5, 6), (5, 7), (5, 8), (5, 9), (5, 10),
    (5, 11),
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
            1 => clear(&mut flat[2..4]),
            3 => clear(&mut flat[6..10]),
            8 => flat[15] = S::default(),
            11 => flat[19] = S::default(),
            13 => flat[22] = S::default(),
            24 => flat[34] = S::default(),
            35 => flat[46] = S::default(),
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
    let [s1, s2, s3, s4, s5, s6] = trig.sin;
    let [c1, c2, c3, c4, c5, c6] = trig.cos;
    let k0 = S::constant(-constants::A2);
    let k2 = S::constant(-constants::A3);
    let k6 = S::constant(1.0);
    let k_D1 = S::constant(constants::D1);
    let k_D4 = S::constant(constants::D4);
    let k_D5 = S::constant(constants::D5);
    let k_D6 = S::constant(constants::D6);
    // frame 2
    let [t0, t1, t2, t3] = {
        let t0 = c1 * c2;
        let t1 = c1 * s2;
        let t2 = s1 * c2;
        let t3 = s1 * s2;
        let t4 = -t1;
        let t5 = -t3;
        put(0, c1); // [0][0][0]
        put(2, s1); // [0][1][0]
        put(3, c1); // [0][1][1]
        put(4, k6); // [0][2][2]
        put(5, k_D1); // [0][2][3]
        put(6, t0); // [1][0][0]
        put(7, t4); // [1][0][1]
        put(8, s1); // [1][0][2]
        put(9, t2); // [1][1][0]
        put(10, t5); // [1][1][1]
        put(12, s2); // [1][2][0]
        put(13, c2); // [1][2][1]
        put(14, k_D1); // [1][2][3]
        put(17, s1); // [2][0][2]
        put(28, s1); // [3][0][2]
        [t0, t1, t2, t3]
    };
    // frame 3
    let [
        t6, t7, t9, t12, t15, t18, t21, t24,
        t27,
    ] = {
        let t6 = t0 * k0;
        let t7 = t2 * k0;
        let t9 = k_D1 - s2 * k0;
        let t12 = c3 * t0 - s3 * t1;
        let t15 = c3 * t1 + s3 * t0;
        let t18 = c3 * t2 - s3 * t3;
        let t21 = c3 * t3 + s3 * t2;
        let t24 = s2 * c3 + c2 * s3;
        let t27 = c2 * c3 - s2 * s3;
        let t28 = -t15;
        let t29 = -t6;
        let t30 = -t21;
        let t31 = -t7;
        put(15, t12); // [2][0][0]
        put(16, t28); // [2][0][1]
        put(18, t29); // [2][0][3]
        put(19, t18); // [2][1][0]
        put(20, t30); // [2][1][1]
        put(22, t31); // [2][1][3]
        put(23, t24); // [2][2][0]
        put(24, t27); // [2][2][1]
        put(25, t9); // [2][2][3]
        [
        t6, t7, t9, t12, t15, t18, t21, t24,
        t27,
    ]
    };
    // frame 4
    let [
        t39, t40, t41, t44, t47, t50, t53, t56,
        t59,
    ] = {
        let t39 = s1 * k_D4 - t12 * k2 - t6;
        let t40 = t7 + (t18 * k2 + c1 * k_D4);
        let t41 = t9 - t24 * k2;
        let t44 = c4 * t12 - s4 * t15;
        let t47 = c4 * t15 + s4 * t12;
        let t50 = c4 * t18 - s4 * t21;
        let t53 = c4 * t21 + s4 * t18;
        let t56 = c4 * t24 + s4 * t27;
        let t59 = c4 * t27 - s4 * t24;
        let t60 = -t47;
        let t61 = -t53;
        let t62 = -t40;
        let t63 = -t59;
        put(26, t44); // [3][0][0]
        put(27, t60); // [3][0][1]
        put(29, t39); // [3][0][3]
        put(30, t50); // [3][1][0]
        put(31, t61); // [3][1][1]
        put(33, t62); // [3][1][3]
        put(34, t56); // [3][2][0]
        put(35, t59); // [3][2][1]
        put(36, t41); // [3][2][3]
        put(39, t47); // [4][0][2]
        put(43, t53); // [4][1][2]
        put(47, t63); // [4][2][2]
        [
        t39, t40, t41, t44, t47, t50, t53, t56,
        t59,
    ]
    };
    // frame 5
    let [
        t67, t68, t69, t72, t75, t78, t81, t82,
        t83,
    ] = {
        let t67 = t39 + k_D5 * t47;
        let t68 = k_D5 * t53 - t40;
        let t69 = t41 - k_D5 * t59;
        let t72 = c5 * t44 + s1 * s5;
        let t75 = s1 * c5 - s5 * t44;
        let t78 = c5 * t50 - c1 * s5;
        let t81 = c1 * c5 + s5 * t50;
        let t82 = c5 * t56;
        let t83 = s5 * t56;
        let t84 = -t81;
        let t85 = -t83;
        put(37, t72); // [4][0][0]
        put(38, t75); // [4][0][1]
        put(40, t67); // [4][0][3]
        put(41, t78); // [4][1][0]
        put(42, t84); // [4][1][1]
        put(44, t68); // [4][1][3]
        put(45, t82); // [4][2][0]
        put(46, t85); // [4][2][1]
        put(48, t69); // [4][2][3]
        put(51, t75); // [5][0][2]
        put(55, t84); // [5][1][2]
        put(59, t85); // [5][2][2]
        [
        t67, t68, t69, t72, t75, t78, t81, t82,
        t83,
    ]
    };
    // frame 6
    {
        let t89 = t67 + k_D6 * t75;
        let t90 = t68 - k_D6 * t81;
        let t91 = t69 - k_D6 * t83;
        let t94 = c6 * t72 - s6 * t47;
        let t100 = c6 * t78 - s6 * t53;
        let t106 = c6 * t82 + s6 * t59;
        let t109 = c6 * t59 - s6 * t82;
        let t110 = -s1;
        let t111 = -c1;
        let t112 = -(c6 * t47 + s6 * t72);
        let t113 = -(c6 * t53 + s6 * t78);
        put(1, t110); // [0][0][1]
        put(11, t111); // [1][1][2]
        put(21, t111); // [2][1][2]
        put(32, t111); // [3][1][2]
        put(49, t94); // [5][0][0]
        put(50, t112); // [5][0][1]
        put(52, t89); // [5][0][3]
        put(53, t100); // [5][1][0]
        put(54, t113); // [5][1][1]
        put(56, t90); // [5][1][3]
        put(57, t106); // [5][2][0]
        put(58, t109); // [5][2][1]
        put(60, t91); // [5][2][3]
    }
}
