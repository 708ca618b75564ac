//! Jacobian of the last DH frame's origin, in base axes.
//!
//! `(v, w) = J dq`: rows 0-2 linear, m/s, rows 3-5 angular, rad/s. Khalil and Dombre, 5.2.
//!
//! 89 multiplications, 65 additions; 6 x 7, 35 of 42 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 35;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (1, 0), (1, 1), (1, 2), (1, 3),
    (1, 4), (1, 5), (2, 1), (2, 2), (2, 3), (2, 4), (2, 5), (3, 1), (3, 2), (3, 3),
    (3, 4), (3, 5), (3, 6), (4, 1), (4, 2), (4, 3), (4, 4), (4, 5), (4, 6), (5, 0),
    (5, 2), (5, 3), (5, 4), (5, 5), (5, 6),
];

/// Jacobian of the last DH frame's origin, in base axes: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 7]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    flat[6] = S::default();
    flat[13..15].fill(S::default());
    flat[20..22].fill(S::default());
    flat[28] = S::default();
    flat[36] = S::default();
    nonzeros(trig, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 7]; 6]) {
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
fn entries<S: Scalar>(trig: &Trig<S>, mut put: impl FnMut(usize, S)) {
    let [s1, s2, s3, s4, s5, s6, ..] = trig.sin;
    let [c1, c2, c3, c4, c5, c6, ..] = trig.cos;
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
        put(17, s1); // [3][1]
        put(23, c1); // [4][1]
        put(24, t5); // [4][2]
        put(29, k7); // [5][0]
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
        let t14 = s1 * s3 - c3 * t2;
        let t17 = s1 * c3 + s3 * t2;
        let t20 = c3 * t4 + c1 * s3;
        let t23 = c1 * c3 - s3 * t4;
        let t24 = s2 * c3;
        let t25 = s2 * s3;
        put(19, t17); // [3][3]
        put(25, t23); // [4][3]
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
        let t29 = t17 * k3 - t9;
        let t30 = t10 + t23 * k3;
        let t31 = t11 + t25 * k3;
        let t34 = c4 * t14 + s4 * t3;
        let t37 = s4 * t14 - c4 * t3;
        let t40 = s4 * t5 - c4 * t20;
        let t43 = c4 * t5 + s4 * t20;
        let t46 = c4 * t24 + c2 * s4;
        let t49 = s4 * t24 - c2 * c4;
        put(20, t37); // [3][4]
        put(26, t43); // [4][4]
        put(32, t49); // [5][4]
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
        let t54 = t30 + t43 * k4;
        let t55 = t31 - t49 * k4;
        let t58 = c5 * t34 + s5 * t17;
        let t61 = c5 * t17 - s5 * t34;
        let t64 = c5 * t40 - s5 * t23;
        let t67 = c5 * t23 + s5 * t40;
        let t70 = c5 * t46 - s5 * t25;
        let t73 = c5 * t25 + s5 * t46;
        put(21, t61); // [3][5]
        put(27, t67); // [4][5]
        [
        t53, t54, t55, t58, t61, t64, t67, t70,
        t73,
    ]
    };
    // frame 6
    let [t77, t78, t79, t82, t85, t88] = {
        let t77 = t53 + t61 * k5;
        let t78 = t54 + t67 * k5;
        let t79 = t55 + t73 * k5;
        let t82 = c6 * t37 + s6 * t58;
        let t85 = s6 * t64 - c6 * t43;
        let t88 = c6 * t49 + s6 * t70;
        put(22, t82); // [3][6]
        put(34, t88); // [5][6]
        [t77, t78, t79, t82, t85, t88]
    };
    // frame 7
    let [t89, t90, t91, t92, t93, t94] = {
        let t89 = t82 * k6;
        let t90 = t85 * k6;
        let t91 = t88 * k6;
        let t92 = t77 + t89;
        let t93 = t90 - t78;
        let t94 = t79 - t91;
        put(0, t93); // [0][0]
        put(6, t92); // [1][0]
        [t89, t90, t91, t92, t93, t94]
    };
    // columns
    {
        let t95 = t94 - k2;
        let t98 = c1 * t95;
        let t102 = s1 * (t1 + t93) + c1 * (t92 - t0);
        let t103 = t9 + t92;
        let t104 = t10 + t93;
        let t105 = t94 - t11;
        let t108 = t5 * t105 + c2 * t104;
        let t111 = c2 * t103 + t3 * t105;
        let t114 = t5 * t103 - t3 * t104;
        let t115 = t92 - t29;
        let t116 = t30 + t93;
        let t117 = t94 - t31;
        let t120 = t23 * t117 + t25 * t116;
        let t123 = t25 * t115 - t17 * t117;
        let t126 = t17 * t116 + t23 * t115;
        let t127 = t53 - t92;
        let t128 = t54 + t93;
        let t129 = t94 - t55;
        let t132 = t43 * t129 - t49 * t128;
        let t135 = t49 * t127 - t37 * t129;
        let t138 = t37 * t128 - t43 * t127;
        let t141 = t73 * t90 - t67 * t91;
        let t144 = t73 * t89 + t61 * t91;
        let t147 = t61 * t90 + t67 * t89;
        let t148 = -(s1 * t95);
        let t149 = -t3;
        let t150 = -t85;
        let t151 = -c2;
        let t152 = -t25;
        let t153 = -t73;
        put(1, t98); // [0][1]
        put(2, t108); // [0][2]
        put(3, t120); // [0][3]
        put(4, t132); // [0][4]
        put(5, t141); // [0][5]
        put(7, t148); // [1][1]
        put(8, t111); // [1][2]
        put(9, t123); // [1][3]
        put(10, t135); // [1][4]
        put(11, t144); // [1][5]
        put(12, t102); // [2][1]
        put(13, t114); // [2][2]
        put(14, t126); // [2][3]
        put(15, t138); // [2][4]
        put(16, t147); // [2][5]
        put(18, t149); // [3][2]
        put(28, t150); // [4][6]
        put(30, t151); // [5][2]
        put(31, t152); // [5][3]
        put(33, t153); // [5][5]
    }
}
