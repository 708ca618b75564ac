//! DH frames of all rows in the base frame.
//!
//! `out[i]` is the top three rows of the homogeneous matrix `T(0, i+1)`, m and one. Khalil and Dombre, 3.2.
//!
//! 68 multiplications, 48 additions; 7 x 3 x 4, 75 of 84 structurally nonzero.

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
    let L1 = S::constant(0.3105);
    let L2 = S::constant(0.4);
    let L3 = S::constant(0.39);
    let k3 = S::constant(1.0);
    // frame 2
    let [t0, t1, t2, t3] = {
        let t0 = c1 * c2;
        let t1 = c1 * s2;
        let t2 = s1 * c2;
        let t3 = s1 * s2;
        put(0, c1); // [0][0][0]
        put(2, s1); // [0][1][0]
        put(3, c1); // [0][1][1]
        put(4, k3); // [0][2][2]
        put(5, L1); // [0][2][3]
        put(6, t0); // [1][0][0]
        put(8, s1); // [1][0][2]
        put(9, t2); // [1][1][0]
        put(12, s2); // [1][2][0]
        put(13, c2); // [1][2][1]
        put(14, L1); // [1][2][3]
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
        put(19, t16); // [2][1][0]
        put(20, t19); // [2][1][1]
        put(23, t20); // [2][2][0]
        put(26, t7); // [2][2][3]
        put(33, t19); // [3][1][2]
        put(38, t7); // [3][2][3]
        [
        t4, t5, t7, t10, t13, t16, t19, t20,
        t21,
    ]
    };
    // frame 4
    let [t24, t27, t30, t33, t36, t39] = {
        let t24 = c4 * t10 + s4 * t1;
        let t27 = s4 * t10 - c4 * t1;
        let t30 = c4 * t16 + s4 * t3;
        let t33 = s4 * t16 - c4 * t3;
        let t36 = c4 * t20 - c2 * s4;
        let t39 = c2 * c4 + s4 * t20;
        put(27, t24); // [3][0][0]
        put(31, t30); // [3][1][0]
        put(35, t36); // [3][2][0]
        put(41, t27); // [4][0][2]
        put(45, t33); // [4][1][2]
        put(49, t39); // [4][2][2]
        [t24, t27, t30, t33, t36, t39]
    };
    // frame 5
    let [t48, t51, t54, t57, t60, t63] = {
        let t43 = L3 * t27 - t4;
        let t44 = L3 * t33 - t5;
        let t45 = t7 + L3 * t39;
        let t48 = c5 * t24 - s5 * t13;
        let t51 = c5 * t13 + s5 * t24;
        let t54 = c5 * t30 + s5 * t19;
        let t57 = c5 * t19 - s5 * t30;
        let t60 = c5 * t36 - s5 * t21;
        let t63 = c5 * t21 + s5 * t36;
        put(39, t48); // [4][0][0]
        put(42, t43); // [4][0][3]
        put(43, t54); // [4][1][0]
        put(44, t57); // [4][1][1]
        put(46, t44); // [4][1][3]
        put(47, t60); // [4][2][0]
        put(50, t45); // [4][2][3]
        put(53, t51); // [5][0][2]
        put(54, t43); // [5][0][3]
        put(58, t44); // [5][1][3]
        put(61, t63); // [5][2][2]
        put(62, t45); // [5][2][3]
        put(66, t43); // [6][0][3]
        put(70, t44); // [6][1][3]
        put(74, t45); // [6][2][3]
        [t48, t51, t54, t57, t60, t63]
    };
    // frame 6
    let [t66, t72, t78] = {
        let t66 = c6 * t48 + s6 * t27;
        let t69 = c6 * t27 - s6 * t48;
        let t72 = c6 * t54 + s6 * t33;
        let t75 = c6 * t33 - s6 * t54;
        let t78 = c6 * t60 + s6 * t39;
        let t81 = c6 * t39 - s6 * t60;
        put(51, t66); // [5][0][0]
        put(52, t69); // [5][0][1]
        put(55, t72); // [5][1][0]
        put(56, t75); // [5][1][1]
        put(59, t78); // [5][2][0]
        put(60, t81); // [5][2][1]
        put(65, t69); // [6][0][2]
        put(69, t75); // [6][1][2]
        put(73, t81); // [6][2][2]
        [t66, t72, t78]
    };
    // frame 7
    {
        let t84 = c7 * t66 - s7 * t51;
        let t90 = c7 * t72 + s7 * t57;
        let t93 = c7 * t57 - s7 * t72;
        let t96 = c7 * t78 - s7 * t63;
        let t100 = -s1;
        let t101 = -t1;
        let t102 = -t3;
        let t103 = -c1;
        let t104 = -t13;
        let t105 = -t4;
        let t106 = -t5;
        let t107 = -t21;
        let t108 = -t27;
        let t109 = -t33;
        let t110 = -t39;
        let t111 = -t51;
        let t112 = -t63;
        let t113 = -t57;
        let t114 = -(c7 * t51 + s7 * t66);
        let t115 = -(c7 * t63 + s7 * t78);
        put(1, t100); // [0][0][1]
        put(7, t101); // [1][0][1]
        put(10, t102); // [1][1][1]
        put(11, t103); // [1][1][2]
        put(16, t104); // [2][0][1]
        put(17, t101); // [2][0][2]
        put(18, t105); // [2][0][3]
        put(21, t102); // [2][1][2]
        put(22, t106); // [2][1][3]
        put(24, t107); // [2][2][1]
        put(28, t108); // [3][0][1]
        put(29, t104); // [3][0][2]
        put(30, t105); // [3][0][3]
        put(32, t109); // [3][1][1]
        put(34, t106); // [3][1][3]
        put(36, t110); // [3][2][1]
        put(37, t107); // [3][2][2]
        put(40, t111); // [4][0][1]
        put(48, t112); // [4][2][1]
        put(57, t113); // [5][1][2]
        put(63, t84); // [6][0][0]
        put(64, t114); // [6][0][1]
        put(67, t90); // [6][1][0]
        put(68, t93); // [6][1][1]
        put(71, t96); // [6][2][0]
        put(72, t115); // [6][2][1]
    }
}
