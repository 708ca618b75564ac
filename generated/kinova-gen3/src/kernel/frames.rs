//! DH frames of all rows in the base frame.
//!
//! `out[i]` is the top three rows of the homogeneous matrix `T(0, i+1)`, m and one. Khalil and Dombre, 3.2.
//!
//! 79 multiplications, 64 additions; 7 x 3 x 4, 77 of 84 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 77;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 4), (0, 5), (0, 10), (0, 11), (1, 0), (1, 1), (1, 2), (1, 3),
    (1, 4), (1, 5), (1, 6), (1, 7), (1, 8), (1, 9), (1, 11), (2, 0), (2, 1), (2, 2),
    (2, 3), (2, 4), (2, 5), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10), (2, 11), (3, 0),
    (3, 1), (3, 2), (3, 3), (3, 4), (3, 5), (3, 6), (3, 7), (3, 8), (3, 9), (3, 10),
    (3, 11), (4, 0), (4, 1), (4, 2), (4, 3), (4, 4), (4, 5), (4, 6), (4, 7), (4, 8),
    (4, 9), (4, 10), (4, 11), (5, 0), (5, 1), (5, 2), (5, 3), (5, 4), (5, 5), (5, 6),
    (5, 7), (5, 8), (5, 9), (5, 10), (5, 11), (6, 0), (6, 1), (6, 2), (6, 3), (6, 4),
    (6, 5), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11),
];

/// DH frames of all rows in the base frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[[S; 4]; 3]; 7]) {
    let flat = &mut out.as_flattened_mut().as_flattened_mut()[..];
    flat[2..4].fill(S::default());
    flat[6..10].fill(S::default());
    flat[22] = S::default();
    nonzeros(trig, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
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
fn entries<S: Scalar>(trig: &Trig<S>, mut put: impl FnMut(usize, S)) {
    let [s1, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [c1, c2, c3, c4, c5, c6, c7] = trig.cos;
    let k0 = S::constant(0.01175);
    let k1 = S::constant(0.42076);
    let k2 = S::constant(0.28481);
    let k3 = S::constant(0.01275);
    let k4 = S::constant(0.31436);
    let k5 = S::constant(0.00035);
    let k6 = S::constant(0.167455);
    let k7 = S::constant(-1.0);
    // frame 2
    let [t0, t1, t2, t3, t4, t5] = {
        let t0 = s1 * k0;
        let t1 = c1 * k0;
        let t2 = c1 * c2;
        let t3 = c1 * s2;
        let t4 = s1 * c2;
        let t5 = s1 * s2;
        put(0, c1); // [0][0][0]
        put(4, k7); // [0][2][2]
        put(5, k2); // [0][2][3]
        put(6, t2); // [1][0][0]
        put(8, s1); // [1][0][2]
        put(11, t5); // [1][1][1]
        put(12, c1); // [1][1][2]
        put(16, k2); // [1][2][3]
        put(23, t5); // [2][1][2]
        [t0, t1, t2, t3, t4, t5]
    };
    // frame 3
    let [
        t9, t10, t11, t14, t17, t20, t23, t24,
        t25,
    ] = {
        let t9 = t3 * k1 - t0;
        let t10 = t1 + t5 * k1;
        let t11 = k2 + c2 * k1;
        let t14 = c3 * t2 - s1 * s3;
        let t17 = s1 * c3 + s3 * t2;
        let t20 = c3 * t4 + c1 * s3;
        let t23 = s3 * t4 - c1 * c3;
        let t24 = s2 * c3;
        let t25 = s2 * s3;
        put(17, t14); // [2][0][0]
        put(20, t9); // [2][0][3]
        put(22, t23); // [2][1][1]
        put(26, t25); // [2][2][1]
        put(28, t11); // [2][2][3]
        put(31, t17); // [3][0][2]
        [
        t9, t10, t11, t14, t17, t20, t23, t24,
        t25,
    ]
    };
    // frame 4
    let [
        t29, t30, t31, t34, t37, t40, t43, t46,
        t49,
    ] = {
        let t29 = t9 - t17 * k3;
        let t30 = t23 * k3 - t10;
        let t31 = t11 + t25 * k3;
        let t34 = c4 * t14 - s4 * t3;
        let t37 = c4 * t3 + s4 * t14;
        let t40 = s4 * t5 - c4 * t20;
        let t43 = c4 * t5 + s4 * t20;
        let t46 = c4 * t24 + c2 * s4;
        let t49 = s4 * t24 - c2 * c4;
        put(29, t34); // [3][0][0]
        put(32, t29); // [3][0][3]
        put(33, t40); // [3][1][0]
        put(34, t43); // [3][1][1]
        put(36, t30); // [3][1][3]
        put(38, t49); // [3][2][1]
        put(40, t31); // [3][2][3]
        put(47, t43); // [4][1][2]
        put(51, t49); // [4][2][2]
        [
        t29, t30, t31, t34, t37, t40, t43, t46,
        t49,
    ]
    };
    // frame 5
    let [
        t53, t54, t55, t58, t61, t64, t67, t70,
        t73,
    ] = {
        let t53 = t29 + t37 * k4;
        let t54 = t30 - t43 * k4;
        let t55 = t31 - t49 * k4;
        let t58 = c5 * t34 - s5 * t17;
        let t61 = c5 * t17 + s5 * t34;
        let t64 = c5 * t40 + s5 * t23;
        let t67 = c5 * t23 - s5 * t40;
        let t70 = s5 * t25 - c5 * t46;
        let t73 = c5 * t25 + s5 * t46;
        put(41, t58); // [4][0][0]
        put(44, t53); // [4][0][3]
        put(45, t64); // [4][1][0]
        put(46, t67); // [4][1][1]
        put(48, t54); // [4][1][3]
        put(49, t70); // [4][2][0]
        put(50, t73); // [4][2][1]
        put(52, t55); // [4][2][3]
        put(55, t61); // [5][0][2]
        [
        t53, t54, t55, t58, t61, t64, t67, t70,
        t73,
    ]
    };
    // frame 6
    let [
        t77, t78, t79, t82, t85, t88, t91, t94,
        t97,
    ] = {
        let t77 = t53 - t61 * k5;
        let t78 = t54 + t67 * k5;
        let t79 = t55 + t73 * k5;
        let t82 = c6 * t58 - s6 * t37;
        let t85 = c6 * t37 + s6 * t58;
        let t88 = c6 * t64 + s6 * t43;
        let t91 = c6 * t43 - s6 * t64;
        let t94 = c6 * t70 + s6 * t49;
        let t97 = c6 * t49 - s6 * t70;
        put(53, t82); // [5][0][0]
        put(56, t77); // [5][0][3]
        put(57, t88); // [5][1][0]
        put(58, t91); // [5][1][1]
        put(60, t78); // [5][1][3]
        put(61, t94); // [5][2][0]
        put(62, t97); // [5][2][1]
        put(64, t79); // [5][2][3]
        put(71, t91); // [6][1][2]
        put(75, t97); // [6][2][2]
        [
        t77, t78, t79, t82, t85, t88, t91, t94,
        t97,
    ]
    };
    // frame 7
    {
        let t101 = t77 + t85 * k6;
        let t102 = t78 - t91 * k6;
        let t103 = t79 - t97 * k6;
        let t106 = c7 * t82 - s7 * t61;
        let t112 = c7 * t88 + s7 * t67;
        let t115 = c7 * t67 - s7 * t88;
        let t118 = c7 * t94 + s7 * t73;
        let t121 = c7 * t73 - s7 * t94;
        let t122 = -s1;
        let t123 = -c1;
        let t124 = -t3;
        let t125 = -t0;
        let t126 = -t4;
        let t127 = -t1;
        let t128 = -s2;
        let t129 = -c2;
        let t130 = -t17;
        let t131 = -t20;
        let t132 = -t10;
        let t133 = -t24;
        let t134 = -t37;
        let t135 = -t23;
        let t136 = -t46;
        let t137 = -t25;
        let t138 = -t61;
        let t139 = -t85;
        let t140 = -t67;
        let t141 = -t73;
        let t142 = -(c7 * t61 + s7 * t82);
        put(1, t122); // [0][0][1]
        put(2, t122); // [0][1][0]
        put(3, t123); // [0][1][1]
        put(7, t124); // [1][0][1]
        put(9, t125); // [1][0][3]
        put(10, t126); // [1][1][0]
        put(13, t127); // [1][1][3]
        put(14, t128); // [1][2][0]
        put(15, t129); // [1][2][1]
        put(18, t130); // [2][0][1]
        put(19, t124); // [2][0][2]
        put(21, t131); // [2][1][0]
        put(24, t132); // [2][1][3]
        put(25, t133); // [2][2][0]
        put(27, t129); // [2][2][2]
        put(30, t134); // [3][0][1]
        put(35, t135); // [3][1][2]
        put(37, t136); // [3][2][0]
        put(39, t137); // [3][2][2]
        put(42, t138); // [4][0][1]
        put(43, t134); // [4][0][2]
        put(54, t139); // [5][0][1]
        put(59, t140); // [5][1][2]
        put(63, t141); // [5][2][2]
        put(65, t106); // [6][0][0]
        put(66, t142); // [6][0][1]
        put(67, t139); // [6][0][2]
        put(68, t101); // [6][0][3]
        put(69, t112); // [6][1][0]
        put(70, t115); // [6][1][1]
        put(72, t102); // [6][1][3]
        put(73, t118); // [6][2][0]
        put(74, t121); // [6][2][1]
        put(76, t103); // [6][2][3]
    }
}
