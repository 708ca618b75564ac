//! Jacobian of the last DH frame's origin, in base axes.
//!
//! `(v, w) = J dq`: rows 0-2 linear, m/s, rows 3-5 angular, rad/s. Khalil and Dombre, 5.2.
//!
//! 93 multiplications, 57 additions; 6 x 7, 35 of 42 structurally nonzero.

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
    let A = S::constant(0.0825);
    let L1 = S::constant(0.333);
    let L2 = S::constant(0.316);
    let L3 = S::constant(0.384);
    let k4 = S::constant(0.088);
    let k5 = S::constant(1.0);
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
        let t4 = L2 * t1;
        let t5 = L2 * t3;
        let t7 = L1 + c2 * L2;
        let t10 = c3 * t0 - s1 * s3;
        let t13 = s1 * c3 + s3 * t0;
        let t16 = c3 * t2 + c1 * s3;
        let t19 = s3 * t2 - c1 * c3;
        let t20 = s2 * c3;
        let t21 = s2 * s3;
        put(19, t13); // [3][3]
        put(25, t19); // [4][3]
        [
        t4, t5, t7, t10, t13, t16, t19, t20,
        t21,
    ]
    };
    // frame 4
    let [
        t25, t26, t27, t30, t33, t36, t39, t42,
        t45,
    ] = {
        let t25 = t4 + A * t10;
        let t26 = t5 + A * t16;
        let t27 = t7 - A * t20;
        let t30 = c4 * t10 + s4 * t1;
        let t33 = c4 * t1 - s4 * t10;
        let t36 = c4 * t16 + s4 * t3;
        let t39 = c4 * t3 - s4 * t16;
        let t42 = c2 * s4 - c4 * t20;
        let t45 = c2 * c4 + s4 * t20;
        put(20, t33); // [3][4]
        put(26, t39); // [4][4]
        put(32, t45); // [5][4]
        [
        t25, t26, t27, t30, t33, t36, t39, t42,
        t45,
    ]
    };
    // frame 5
    let [
        t55, t56, t57, t60, t63, t66, t69, t72,
        t75,
    ] = {
        let t55 = t25 - (A * t30 - L3 * t33);
        let t56 = A * t36 - L3 * t39 - t26;
        let t57 = A * t42 - L3 * t45 - t27;
        let t60 = c5 * t30 - s5 * t13;
        let t63 = c5 * t13 + s5 * t30;
        let t66 = c5 * t36 - s5 * t19;
        let t69 = c5 * t19 + s5 * t36;
        let t72 = c5 * t42 + s5 * t21;
        let t75 = s5 * t42 - c5 * t21;
        put(21, t63); // [3][5]
        put(27, t69); // [4][5]
        put(33, t75); // [5][5]
        [
        t55, t56, t57, t60, t63, t66, t69, t72,
        t75,
    ]
    };
    // frame 6
    let [
        t78, t79, t80, t83, t84, t85, t88, t89,
        t90,
    ] = {
        let t78 = c6 * t60 + s6 * t33;
        let t79 = c6 * t33;
        let t80 = s6 * t60;
        let t83 = c6 * t66 + s6 * t39;
        let t84 = c6 * t39;
        let t85 = s6 * t66;
        let t88 = c6 * t72 + s6 * t45;
        let t89 = c6 * t45;
        let t90 = s6 * t72;
        [
        t78, t79, t80, t83, t84, t85, t88, t89,
        t90,
    ]
    };
    // frame 7
    let [t91, t92, t93, t94, t95, t96] = {
        let t91 = k4 * t78;
        let t92 = k4 * t83;
        let t93 = k4 * t88;
        let t94 = t55 + t91;
        let t95 = t56 - t92;
        let t96 = t93 - t57;
        let t97 = t80 - t79;
        let t98 = t85 - t84;
        let t99 = t90 - t89;
        put(0, t95); // [0][0]
        put(6, t94); // [1][0]
        put(22, t97); // [3][6]
        put(28, t98); // [4][6]
        put(34, t99); // [5][6]
        [t91, t92, t93, t94, t95, t96]
    };
    // columns
    {
        let t100 = t96 - L1;
        let t101 = c1 * t100;
        let t102 = s1 * t100;
        let t105 = s1 * t95 - c1 * t94;
        let t106 = t4 - t94;
        let t107 = t5 + t95;
        let t108 = t7 - t96;
        let t111 = c2 * t107 - t3 * t108;
        let t114 = t1 * t108 - c2 * t106;
        let t117 = t3 * t106 - t1 * t107;
        let t118 = t25 - t94;
        let t119 = t26 + t95;
        let t120 = t96 - t27;
        let t123 = t19 * t120 - t21 * t119;
        let t126 = t21 * t118 - t13 * t120;
        let t129 = t19 * t118 - t13 * t119;
        let t132 = t39 * t93 - t45 * t92;
        let t135 = t45 * t91 - t33 * t93;
        let t138 = t33 * t92 - t39 * t91;
        let t141 = t69 * t93 - t75 * t92;
        let t144 = t75 * t91 - t63 * t93;
        let t147 = t63 * t92 - t69 * t91;
        let t148 = -s1;
        let t149 = -t21;
        put(1, t101); // [0][1]
        put(2, t111); // [0][2]
        put(3, t123); // [0][3]
        put(4, t132); // [0][4]
        put(5, t141); // [0][5]
        put(7, t102); // [1][1]
        put(8, t114); // [1][2]
        put(9, t126); // [1][3]
        put(10, t135); // [1][4]
        put(11, t144); // [1][5]
        put(12, t105); // [2][1]
        put(13, t117); // [2][2]
        put(14, t129); // [2][3]
        put(15, t138); // [2][4]
        put(16, t147); // [2][5]
        put(17, t148); // [3][1]
        put(31, t149); // [5][3]
    }
}
