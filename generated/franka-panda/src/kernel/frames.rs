//! DH frames of all rows in the world frame.
//!
//! `out[i]` is the top three rows of the homogeneous matrix `T(0, i+1)`, m and one. Khalil and
//! Dombre, 3.2.
//!
//! 77 multiplications, 56 additions; 7 x 3 x 4, 75 of 84 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 75;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 4), (0, 5), (0, 10), (0, 11), (1, 0), (1, 1), (1, 2), (1, 4),
    (1, 5), (1, 6), (1, 8), (1, 9), (1, 11), (2, 0), (2, 1), (2, 2), (2, 3), (2, 4),
    (2, 5), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10), (2, 11), (3, 0), (3, 1), (3, 2),
    (3, 3), (3, 4), (3, 5), (3, 6), (3, 7), (3, 8), (3, 9), (3, 10), (3, 11), (4, 0),
    (4, 1), (4, 2), (4, 3), (4, 4), (4, 5), (4, 6), (4, 7), (4, 8), (4, 9), (4, 10),
    (4, 11), (5, 0), (5, 1), (5, 2), (5, 3), (5, 4), (5, 5), (5, 6), (5, 7), (5, 8),
    (5, 9), (5, 10), (5, 11), (6, 0), (6, 1), (6, 2), (6, 3), (6, 4), (6, 5), (6, 6),
    (6, 7), (6, 8), (6, 9), (6, 10), (6, 11),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 12 + PATTERN[k].1
}

/// DH frames of all rows in the world frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[[S; 4]; 3]; 7]) {
    let flat = &mut out.as_flattened_mut().as_flattened_mut()[..];
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            1 => clear(&mut flat[2..4]),
            3 => clear(&mut flat[6..10]),
            8 => flat[15] = S::default(),
            11 => flat[19] = S::default(),
            13 => flat[22] = S::default(),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [[[S; 4]; 3]; 7]) {
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
    let [s1, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [c1, c2, c3, c4, c5, c6, c7] = trig.cos;
    let k4 = S::constant(0.088);
    let k5 = S::constant(1.0);
    let k_A = S::constant(constants::A);
    let k_L1 = S::constant(constants::L1);
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
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
        put(4, k5); // [0][2][2]
        put(5, k_L1); // [0][2][3]
        put(6, t0); // [1][0][0]
        put(7, t4); // [1][0][1]
        put(9, t2); // [1][1][0]
        put(10, t5); // [1][1][1]
        put(11, c1); // [1][1][2]
        put(14, k_L1); // [1][2][3]
        put(17, t1); // [2][0][2]
        put(21, t3); // [2][1][2]
        put(25, c2); // [2][2][2]
        [t0, t1, t2, t3]
    };
    // frame 3
    let [
        t6, t7, t9, t12, t15, t18, t21, t22,
        t23,
    ] = {
        let t6 = k_L2 * t1;
        let t7 = k_L2 * t3;
        let t9 = k_L1 + c2 * k_L2;
        let t12 = c3 * t0 - s1 * s3;
        let t15 = s1 * c3 + s3 * t0;
        let t18 = c3 * t2 + c1 * s3;
        let t21 = c1 * c3 - s3 * t2;
        let t22 = s2 * c3;
        let t23 = s2 * s3;
        let t24 = -t15;
        let t25 = -t22;
        let t26 = -t21;
        let t27 = -t23;
        put(15, t12); // [2][0][0]
        put(16, t24); // [2][0][1]
        put(18, t6); // [2][0][3]
        put(19, t18); // [2][1][0]
        put(20, t21); // [2][1][1]
        put(22, t7); // [2][1][3]
        put(23, t25); // [2][2][0]
        put(24, t23); // [2][2][1]
        put(26, t9); // [2][2][3]
        put(29, t15); // [3][0][2]
        put(33, t26); // [3][1][2]
        put(37, t27); // [3][2][2]
        [
        t6, t7, t9, t12, t15, t18, t21, t22,
        t23,
    ]
    };
    // frame 4
    let [
        t31, t32, t33, t36, t39, t42, t45, t48,
        t51,
    ] = {
        let t31 = t6 + k_A * t12;
        let t32 = t7 + k_A * t18;
        let t33 = t9 - k_A * t22;
        let t36 = c4 * t12 + s4 * t1;
        let t39 = c4 * t1 - s4 * t12;
        let t42 = c4 * t18 + s4 * t3;
        let t45 = c4 * t3 - s4 * t18;
        let t48 = c2 * s4 - c4 * t22;
        let t51 = c2 * c4 + s4 * t22;
        put(27, t36); // [3][0][0]
        put(28, t39); // [3][0][1]
        put(30, t31); // [3][0][3]
        put(31, t42); // [3][1][0]
        put(32, t45); // [3][1][1]
        put(34, t32); // [3][1][3]
        put(35, t48); // [3][2][0]
        put(36, t51); // [3][2][1]
        put(38, t33); // [3][2][3]
        put(41, t39); // [4][0][2]
        put(45, t45); // [4][1][2]
        put(49, t51); // [4][2][2]
        [
        t31, t32, t33, t36, t39, t42, t45, t48,
        t51,
    ]
    };
    // frame 5
    let [
        t61, t62, t63, t66, t69, t72, t75, t78,
        t81,
    ] = {
        let t61 = t31 - (k_A * t36 - k_L3 * t39);
        let t62 = t32 + (k_L3 * t45 - k_A * t42);
        let t63 = t33 + (k_L3 * t51 - k_A * t48);
        let t66 = c5 * t36 - s5 * t15;
        let t69 = c5 * t15 + s5 * t36;
        let t72 = c5 * t42 + s5 * t21;
        let t75 = s5 * t42 - c5 * t21;
        let t78 = c5 * t48 + s5 * t23;
        let t81 = s5 * t48 - c5 * t23;
        let t82 = -t69;
        let t83 = -t75;
        let t84 = -t81;
        put(39, t66); // [4][0][0]
        put(40, t82); // [4][0][1]
        put(42, t61); // [4][0][3]
        put(43, t72); // [4][1][0]
        put(44, t83); // [4][1][1]
        put(46, t62); // [4][1][3]
        put(47, t78); // [4][2][0]
        put(48, t84); // [4][2][1]
        put(50, t63); // [4][2][3]
        put(53, t69); // [5][0][2]
        put(54, t61); // [5][0][3]
        put(57, t75); // [5][1][2]
        put(58, t62); // [5][1][3]
        put(61, t81); // [5][2][2]
        put(62, t63); // [5][2][3]
        [
        t61, t62, t63, t66, t69, t72, t75, t78,
        t81,
    ]
    };
    // frame 6
    let [t87, t93, t99] = {
        let t87 = c6 * t66 + s6 * t39;
        let t90 = c6 * t39 - s6 * t66;
        let t93 = c6 * t72 + s6 * t45;
        let t96 = s6 * t72 - c6 * t45;
        let t99 = c6 * t78 + s6 * t51;
        let t102 = s6 * t78 - c6 * t51;
        let t103 = -t96;
        let t104 = -t102;
        let t105 = -t90;
        put(51, t87); // [5][0][0]
        put(52, t90); // [5][0][1]
        put(55, t93); // [5][1][0]
        put(56, t103); // [5][1][1]
        put(59, t99); // [5][2][0]
        put(60, t104); // [5][2][1]
        put(65, t105); // [6][0][2]
        put(69, t96); // [6][1][2]
        put(73, t102); // [6][2][2]
        [t87, t93, t99]
    };
    // frame 7
    {
        let t109 = t61 + k4 * t87;
        let t110 = t62 + k4 * t93;
        let t111 = t63 + k4 * t99;
        let t114 = c7 * t87 + s7 * t69;
        let t117 = c7 * t69 - s7 * t87;
        let t120 = c7 * t93 + s7 * t75;
        let t123 = c7 * t75 - s7 * t93;
        let t126 = c7 * t99 + s7 * t81;
        let t129 = c7 * t81 - s7 * t99;
        let t130 = -s1;
        let t131 = -s2;
        let t132 = -c2;
        put(1, t130); // [0][0][1]
        put(8, t130); // [1][0][2]
        put(12, t131); // [1][2][0]
        put(13, t132); // [1][2][1]
        put(63, t114); // [6][0][0]
        put(64, t117); // [6][0][1]
        put(66, t109); // [6][0][3]
        put(67, t120); // [6][1][0]
        put(68, t123); // [6][1][1]
        put(70, t110); // [6][1][3]
        put(71, t126); // [6][2][0]
        put(72, t129); // [6][2][1]
        put(74, t111); // [6][2][3]
    }
}
