//! DH frames of all rows in the base frame.
//!
//! `out[i]` is the top three rows of the homogeneous matrix `T(0, i+1)`, m and one. Khalil and Dombre, 3.2.
//!
//! 64 multiplications, 50 additions; 6 x 3 x 4, 61 of 72 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{Trig};

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

/// DH frames of all rows in the base frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[[S; 4]; 3]; 6]) {
    let flat = &mut out.as_flattened_mut().as_flattened_mut()[..];
    flat[2..4].fill(S::default());
    flat[6..10].fill(S::default());
    flat[15] = S::default();
    flat[19] = S::default();
    flat[22] = S::default();
    flat[34] = S::default();
    flat[46] = S::default();
    nonzeros(trig, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
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
fn entries<S: Scalar>(trig: &Trig<S>, mut put: impl FnMut(usize, S)) {
    let [s1, s2, s3, s4, s5, s6] = trig.sin;
    let [c1, c2, c3, c4, c5, c6] = trig.cos;
    let D1 = S::constant(0.1807);
    let D4 = S::constant(0.17415);
    let D5 = S::constant(0.11985);
    let D6 = S::constant(0.11655);
    let k0 = S::constant(0.6127);
    let k2 = S::constant(0.57155);
    let k6 = S::constant(1.0);
    // frame 2
    let [t0, t1, t2, t3] = {
        let t0 = c1 * c2;
        let t1 = c1 * s2;
        let t2 = s1 * c2;
        let t3 = s1 * s2;
        put(0, c1); // [0][0][0]
        put(2, s1); // [0][1][0]
        put(3, c1); // [0][1][1]
        put(4, k6); // [0][2][2]
        put(5, D1); // [0][2][3]
        put(6, t0); // [1][0][0]
        put(8, s1); // [1][0][2]
        put(9, t2); // [1][1][0]
        put(12, s2); // [1][2][0]
        put(13, c2); // [1][2][1]
        put(14, D1); // [1][2][3]
        put(17, s1); // [2][0][2]
        put(28, s1); // [3][0][2]
        [t0, t1, t2, t3]
    };
    // frame 3
    let [
        t4, t5, t7, t10, t13, t16, t19, t22,
        t25,
    ] = {
        let t4 = t0 * k0;
        let t5 = t2 * k0;
        let t7 = D1 - s2 * k0;
        let t10 = c3 * t0 - s3 * t1;
        let t13 = c3 * t1 + s3 * t0;
        let t16 = c3 * t2 - s3 * t3;
        let t19 = c3 * t3 + s3 * t2;
        let t22 = s2 * c3 + c2 * s3;
        let t25 = c2 * c3 - s2 * s3;
        put(15, t10); // [2][0][0]
        put(19, t16); // [2][1][0]
        put(23, t22); // [2][2][0]
        put(24, t25); // [2][2][1]
        put(25, t7); // [2][2][3]
        [
        t4, t5, t7, t10, t13, t16, t19, t22,
        t25,
    ]
    };
    // frame 4
    let [
        t33, t34, t35, t38, t41, t44, t47, t50,
        t53,
    ] = {
        let t33 = s1 * D4 - t10 * k2 - t4;
        let t34 = t5 + (t16 * k2 + c1 * D4);
        let t35 = t7 - t22 * k2;
        let t38 = c4 * t10 - s4 * t13;
        let t41 = c4 * t13 + s4 * t10;
        let t44 = c4 * t16 - s4 * t19;
        let t47 = c4 * t19 + s4 * t16;
        let t50 = c4 * t22 + s4 * t25;
        let t53 = c4 * t25 - s4 * t22;
        put(26, t38); // [3][0][0]
        put(29, t33); // [3][0][3]
        put(30, t44); // [3][1][0]
        put(34, t50); // [3][2][0]
        put(35, t53); // [3][2][1]
        put(36, t35); // [3][2][3]
        put(39, t41); // [4][0][2]
        put(43, t47); // [4][1][2]
        [
        t33, t34, t35, t38, t41, t44, t47, t50,
        t53,
    ]
    };
    // frame 5
    let [
        t57, t58, t59, t62, t65, t68, t71, t72,
        t73,
    ] = {
        let t57 = t33 + D5 * t41;
        let t58 = D5 * t47 - t34;
        let t59 = t35 - D5 * t53;
        let t62 = c5 * t38 + s1 * s5;
        let t65 = s1 * c5 - s5 * t38;
        let t68 = c5 * t44 - c1 * s5;
        let t71 = c1 * c5 + s5 * t44;
        let t72 = c5 * t50;
        let t73 = s5 * t50;
        put(37, t62); // [4][0][0]
        put(38, t65); // [4][0][1]
        put(40, t57); // [4][0][3]
        put(41, t68); // [4][1][0]
        put(44, t58); // [4][1][3]
        put(45, t72); // [4][2][0]
        put(48, t59); // [4][2][3]
        put(51, t65); // [5][0][2]
        [
        t57, t58, t59, t62, t65, t68, t71, t72,
        t73,
    ]
    };
    // frame 6
    {
        let t77 = t57 + D6 * t65;
        let t78 = t58 - D6 * t71;
        let t79 = t59 - D6 * t73;
        let t82 = c6 * t62 - s6 * t41;
        let t88 = c6 * t68 - s6 * t47;
        let t94 = c6 * t72 + s6 * t53;
        let t97 = c6 * t53 - s6 * t72;
        let t98 = -s1;
        let t99 = -t1;
        let t100 = -t3;
        let t101 = -c1;
        let t102 = -t13;
        let t103 = -t4;
        let t104 = -t19;
        let t105 = -t5;
        let t106 = -t41;
        let t107 = -t47;
        let t108 = -t34;
        let t109 = -t71;
        let t110 = -t73;
        let t111 = -t53;
        let t112 = -(c6 * t41 + s6 * t62);
        let t113 = -(c6 * t47 + s6 * t68);
        put(1, t98); // [0][0][1]
        put(7, t99); // [1][0][1]
        put(10, t100); // [1][1][1]
        put(11, t101); // [1][1][2]
        put(16, t102); // [2][0][1]
        put(18, t103); // [2][0][3]
        put(20, t104); // [2][1][1]
        put(21, t101); // [2][1][2]
        put(22, t105); // [2][1][3]
        put(27, t106); // [3][0][1]
        put(31, t107); // [3][1][1]
        put(32, t101); // [3][1][2]
        put(33, t108); // [3][1][3]
        put(42, t109); // [4][1][1]
        put(46, t110); // [4][2][1]
        put(47, t111); // [4][2][2]
        put(49, t82); // [5][0][0]
        put(50, t112); // [5][0][1]
        put(52, t77); // [5][0][3]
        put(53, t88); // [5][1][0]
        put(54, t113); // [5][1][1]
        put(55, t109); // [5][1][2]
        put(56, t78); // [5][1][3]
        put(57, t94); // [5][2][0]
        put(58, t97); // [5][2][1]
        put(59, t110); // [5][2][2]
        put(60, t79); // [5][2][3]
    }
}
