//! DH frames of all rows in the base frame.
//!
//! `out[i]` is the top three rows of the homogeneous matrix `T(0, i+1)`, m and one. Khalil and Dombre, 3.2.
//!
//! 77 multiplications, 56 additions; 7 x 3 x 4, 75 of 84 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{Trig};

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

/// DH frames of all rows in the base frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[[S; 4]; 3]; 7]) {
    let flat = &mut out.as_flattened_mut().as_flattened_mut()[..];
    flat[2..4].fill(S::default());
    flat[6..10].fill(S::default());
    flat[15] = S::default();
    flat[19] = S::default();
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
        put(0, c1); // [0][0][0]
        put(2, s1); // [0][1][0]
        put(3, c1); // [0][1][1]
        put(4, k5); // [0][2][2]
        put(5, L1); // [0][2][3]
        put(6, t0); // [1][0][0]
        put(9, t2); // [1][1][0]
        put(11, c1); // [1][1][2]
        put(14, L1); // [1][2][3]
        put(17, t1); // [2][0][2]
        put(21, t3); // [2][1][2]
        put(25, c2); // [2][2][2]
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
        let t19 = c1 * c3 - s3 * t2;
        let t20 = s2 * c3;
        let t21 = s2 * s3;
        put(15, t10); // [2][0][0]
        put(18, t4); // [2][0][3]
        put(19, t16); // [2][1][0]
        put(20, t19); // [2][1][1]
        put(22, t5); // [2][1][3]
        put(24, t21); // [2][2][1]
        put(26, t7); // [2][2][3]
        put(29, t13); // [3][0][2]
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
        put(27, t30); // [3][0][0]
        put(28, t33); // [3][0][1]
        put(30, t25); // [3][0][3]
        put(31, t36); // [3][1][0]
        put(32, t39); // [3][1][1]
        put(34, t26); // [3][1][3]
        put(35, t42); // [3][2][0]
        put(36, t45); // [3][2][1]
        put(38, t27); // [3][2][3]
        put(41, t33); // [4][0][2]
        put(45, t39); // [4][1][2]
        put(49, t45); // [4][2][2]
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
        let t56 = t26 + (L3 * t39 - A * t36);
        let t57 = t27 + (L3 * t45 - A * t42);
        let t60 = c5 * t30 - s5 * t13;
        let t63 = c5 * t13 + s5 * t30;
        let t66 = c5 * t36 + s5 * t19;
        let t69 = s5 * t36 - c5 * t19;
        let t72 = c5 * t42 + s5 * t21;
        let t75 = s5 * t42 - c5 * t21;
        put(39, t60); // [4][0][0]
        put(42, t55); // [4][0][3]
        put(43, t66); // [4][1][0]
        put(46, t56); // [4][1][3]
        put(47, t72); // [4][2][0]
        put(50, t57); // [4][2][3]
        put(53, t63); // [5][0][2]
        put(54, t55); // [5][0][3]
        put(57, t69); // [5][1][2]
        put(58, t56); // [5][1][3]
        put(61, t75); // [5][2][2]
        put(62, t57); // [5][2][3]
        [
        t55, t56, t57, t60, t63, t66, t69, t72,
        t75,
    ]
    };
    // frame 6
    let [t78, t81, t84, t87, t90, t93] = {
        let t78 = c6 * t60 + s6 * t33;
        let t81 = c6 * t33 - s6 * t60;
        let t84 = c6 * t66 + s6 * t39;
        let t87 = s6 * t66 - c6 * t39;
        let t90 = c6 * t72 + s6 * t45;
        let t93 = s6 * t72 - c6 * t45;
        put(51, t78); // [5][0][0]
        put(52, t81); // [5][0][1]
        put(55, t84); // [5][1][0]
        put(59, t90); // [5][2][0]
        put(69, t87); // [6][1][2]
        put(73, t93); // [6][2][2]
        [t78, t81, t84, t87, t90, t93]
    };
    // frame 7
    {
        let t97 = t55 + k4 * t78;
        let t98 = t56 + k4 * t84;
        let t99 = t57 + k4 * t90;
        let t102 = c7 * t78 + s7 * t63;
        let t105 = c7 * t63 - s7 * t78;
        let t108 = c7 * t84 + s7 * t69;
        let t111 = c7 * t69 - s7 * t84;
        let t114 = c7 * t90 + s7 * t75;
        let t117 = c7 * t75 - s7 * t90;
        let t118 = -s1;
        let t119 = -t1;
        let t120 = -t3;
        let t121 = -s2;
        let t122 = -c2;
        let t123 = -t13;
        let t124 = -t20;
        let t125 = -t19;
        let t126 = -t21;
        let t127 = -t63;
        let t128 = -t69;
        let t129 = -t75;
        let t130 = -t87;
        let t131 = -t93;
        let t132 = -t81;
        put(1, t118); // [0][0][1]
        put(7, t119); // [1][0][1]
        put(8, t118); // [1][0][2]
        put(10, t120); // [1][1][1]
        put(12, t121); // [1][2][0]
        put(13, t122); // [1][2][1]
        put(16, t123); // [2][0][1]
        put(23, t124); // [2][2][0]
        put(33, t125); // [3][1][2]
        put(37, t126); // [3][2][2]
        put(40, t127); // [4][0][1]
        put(44, t128); // [4][1][1]
        put(48, t129); // [4][2][1]
        put(56, t130); // [5][1][1]
        put(60, t131); // [5][2][1]
        put(63, t102); // [6][0][0]
        put(64, t105); // [6][0][1]
        put(65, t132); // [6][0][2]
        put(66, t97); // [6][0][3]
        put(67, t108); // [6][1][0]
        put(68, t111); // [6][1][1]
        put(70, t98); // [6][1][3]
        put(71, t114); // [6][2][0]
        put(72, t117); // [6][2][1]
        put(74, t99); // [6][2][3]
    }
}
