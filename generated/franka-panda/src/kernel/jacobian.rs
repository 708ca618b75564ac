//! Jacobian of the last DH frame's origin, in world axes.
//!
//! `(v, w) = J dq`: rows 0-2 linear, m/s, rows 3-5 angular, rad/s. Khalil and Dombre, 5.2.
//!
//! 93 multiplications, 57 additions; 6 x 7, 35 of 42 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 35;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (1, 0), (1, 1), (1, 2), (1, 3),
    (1, 4), (1, 5), (2, 1), (2, 2), (2, 3), (2, 4), (2, 5), (3, 1), (3, 2), (3, 3),
    (3, 4), (3, 5), (3, 6), (4, 1), (4, 2), (4, 3), (4, 4), (4, 5), (4, 6), (5, 0),
    (5, 2), (5, 3), (5, 4), (5, 5), (5, 6),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 7 + PATTERN[k].1
}

/// Jacobian of the last DH frame's origin, in world axes: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 7]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            5 => flat[6] = S::default(),
            11 => clear(&mut flat[13..15]),
            16 => clear(&mut flat[20..22]),
            22 => flat[28] = S::default(),
            29 => flat[36] = S::default(),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
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
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, mut put: impl FnMut(usize, S)) {
    let [s1, s2, s3, s4, s5, s6, ..] = trig.sin;
    let [c1, c2, c3, c4, c5, c6, ..] = trig.cos;
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
        put(18, t1); // [3][2]
        put(23, c1); // [4][1]
        put(24, t3); // [4][2]
        put(29, k5); // [5][0]
        put(30, c2); // [5][2]
        [t0, t1, t2, t3]
    };
    // frame 3
    let [
        t4, t5, t7, t10, t13, t16, t19, t20,
        t21,
    ] = {
        let t4 = k_L2 * t1;
        let t5 = k_L2 * t3;
        let t7 = k_L1 + c2 * k_L2;
        let t10 = c3 * t0 - s1 * s3;
        let t13 = s1 * c3 + s3 * t0;
        let t16 = c3 * t2 + c1 * s3;
        let t19 = s3 * t2 - c1 * c3;
        let t20 = s2 * c3;
        let t21 = s2 * s3;
        let t22 = -t21;
        put(19, t13); // [3][3]
        put(25, t19); // [4][3]
        put(31, t22); // [5][3]
        [
        t4, t5, t7, t10, t13, t16, t19, t20,
        t21,
    ]
    };
    // frame 4
    let [
        t26, t27, t28, t31, t34, t37, t40, t43,
        t46,
    ] = {
        let t26 = t4 + k_A * t10;
        let t27 = t5 + k_A * t16;
        let t28 = t7 - k_A * t20;
        let t31 = c4 * t10 + s4 * t1;
        let t34 = c4 * t1 - s4 * t10;
        let t37 = c4 * t16 + s4 * t3;
        let t40 = c4 * t3 - s4 * t16;
        let t43 = c2 * s4 - c4 * t20;
        let t46 = c2 * c4 + s4 * t20;
        put(20, t34); // [3][4]
        put(26, t40); // [4][4]
        put(32, t46); // [5][4]
        [
        t26, t27, t28, t31, t34, t37, t40, t43,
        t46,
    ]
    };
    // frame 5
    let [
        t56, t57, t58, t61, t64, t67, t70, t73,
        t76,
    ] = {
        let t56 = t26 - (k_A * t31 - k_L3 * t34);
        let t57 = k_A * t37 - k_L3 * t40 - t27;
        let t58 = k_A * t43 - k_L3 * t46 - t28;
        let t61 = c5 * t31 - s5 * t13;
        let t64 = c5 * t13 + s5 * t31;
        let t67 = c5 * t37 - s5 * t19;
        let t70 = c5 * t19 + s5 * t37;
        let t73 = c5 * t43 + s5 * t21;
        let t76 = s5 * t43 - c5 * t21;
        put(21, t64); // [3][5]
        put(27, t70); // [4][5]
        put(33, t76); // [5][5]
        [
        t56, t57, t58, t61, t64, t67, t70, t73,
        t76,
    ]
    };
    // frame 6
    let [
        t79, t80, t81, t84, t85, t86, t89, t90,
        t91,
    ] = {
        let t79 = c6 * t61 + s6 * t34;
        let t80 = c6 * t34;
        let t81 = s6 * t61;
        let t84 = c6 * t67 + s6 * t40;
        let t85 = c6 * t40;
        let t86 = s6 * t67;
        let t89 = c6 * t73 + s6 * t46;
        let t90 = c6 * t46;
        let t91 = s6 * t73;
        [
        t79, t80, t81, t84, t85, t86, t89, t90,
        t91,
    ]
    };
    // frame 7
    let [t92, t93, t94, t95, t96, t97] = {
        let t92 = k4 * t79;
        let t93 = k4 * t84;
        let t94 = k4 * t89;
        let t95 = t56 + t92;
        let t96 = t57 - t93;
        let t97 = t94 - t58;
        let t98 = t81 - t80;
        let t99 = t86 - t85;
        let t100 = t91 - t90;
        put(0, t96); // [0][0]
        put(6, t95); // [1][0]
        put(22, t98); // [3][6]
        put(28, t99); // [4][6]
        put(34, t100); // [5][6]
        [t92, t93, t94, t95, t96, t97]
    };
    // columns
    {
        let t101 = t97 - k_L1;
        let t102 = c1 * t101;
        let t103 = s1 * t101;
        let t106 = s1 * t96 - c1 * t95;
        let t107 = t4 - t95;
        let t108 = t5 + t96;
        let t109 = t7 - t97;
        let t112 = c2 * t108 - t3 * t109;
        let t115 = t1 * t109 - c2 * t107;
        let t118 = t3 * t107 - t1 * t108;
        let t119 = t26 - t95;
        let t120 = t27 + t96;
        let t121 = t97 - t28;
        let t124 = t19 * t121 - t21 * t120;
        let t127 = t21 * t119 - t13 * t121;
        let t130 = t19 * t119 - t13 * t120;
        let t133 = t40 * t94 - t46 * t93;
        let t136 = t46 * t92 - t34 * t94;
        let t139 = t34 * t93 - t40 * t92;
        let t142 = t70 * t94 - t76 * t93;
        let t145 = t76 * t92 - t64 * t94;
        let t148 = t64 * t93 - t70 * t92;
        let t149 = -s1;
        put(1, t102); // [0][1]
        put(2, t112); // [0][2]
        put(3, t124); // [0][3]
        put(4, t133); // [0][4]
        put(5, t142); // [0][5]
        put(7, t103); // [1][1]
        put(8, t115); // [1][2]
        put(9, t127); // [1][3]
        put(10, t136); // [1][4]
        put(11, t145); // [1][5]
        put(12, t106); // [2][1]
        put(13, t118); // [2][2]
        put(14, t130); // [2][3]
        put(15, t139); // [2][4]
        put(16, t148); // [2][5]
        put(17, t149); // [3][1]
    }
}
