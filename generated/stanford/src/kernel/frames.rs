//! DH frames of all rows in the base frame.
//!
//! `out[i]` is the top three rows of the homogeneous matrix `T(0, i+1)`, m and one. Khalil and Dombre, 3.2.
//!
//! 46 multiplications, 33 additions; 6 x 3 x 4, 64 of 72 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{Trig};

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

/// DH frames of all rows in the base frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[[S; 4]; 3]; 6]) {
    let flat = &mut out.as_flattened_mut().as_flattened_mut()[..];
    flat[1] = S::default();
    flat[3] = S::default();
    flat[5] = S::default();
    flat[7..9].fill(S::default());
    flat[10] = S::default();
    flat[21] = S::default();
    flat[32] = S::default();
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
    let [_, _, q3, ..] = trig.q;
    let [s1, s2, _, s4, s5, s6] = trig.sin;
    let [c1, c2, _, c4, c5, c6] = trig.cos;
    let D1 = S::constant(0.412);
    let D2 = S::constant(0.154);
    let D6 = S::constant(0.263);
    let k3 = S::constant(-1.0);
    // frame 2
    let [t0, t1, t2, t3, t4, t5] = {
        let t0 = s1 * D2;
        let t1 = c1 * D2;
        let t2 = c1 * c2;
        let t3 = c1 * s2;
        let t4 = s1 * c2;
        let t5 = s1 * s2;
        put(0, c1); // [0][0][0]
        put(2, s1); // [0][1][0]
        put(3, c1); // [0][1][2]
        put(4, k3); // [0][2][1]
        put(5, D1); // [0][2][3]
        put(6, t2); // [1][0][0]
        put(8, t3); // [1][0][2]
        put(10, t4); // [1][1][0]
        put(11, c1); // [1][1][1]
        put(12, t5); // [1][1][2]
        put(13, t1); // [1][1][3]
        put(15, c2); // [1][2][2]
        put(16, D1); // [1][2][3]
        put(17, s1); // [2][0][0]
        put(18, t2); // [2][0][1]
        put(19, t3); // [2][0][2]
        put(22, t4); // [2][1][1]
        put(23, t5); // [2][1][2]
        put(26, c2); // [2][2][2]
        [t0, t1, t2, t3, t4, t5]
    };
    // frame 3
    let [t9, t10, t11] = {
        let t9 = q3 * t3 - t0;
        let t10 = t1 + q3 * t5;
        let t11 = D1 + c2 * q3;
        put(20, t9); // [2][0][3]
        put(24, t10); // [2][1][3]
        put(27, t11); // [2][2][3]
        put(31, t9); // [3][0][3]
        put(35, t10); // [3][1][3]
        put(39, t11); // [3][2][3]
        put(43, t9); // [4][0][3]
        put(47, t10); // [4][1][3]
        put(51, t11); // [4][2][3]
        [t9, t10, t11]
    };
    // frame 4
    let [t14, t17, t20, t23, t24, t25] = {
        let t14 = s1 * c4 + s4 * t2;
        let t17 = c4 * t2 - s1 * s4;
        let t20 = s4 * t4 - c1 * c4;
        let t23 = c4 * t4 + c1 * s4;
        let t24 = s2 * s4;
        let t25 = s2 * c4;
        put(28, t14); // [3][0][0]
        put(30, t17); // [3][0][2]
        put(32, t20); // [3][1][0]
        put(34, t23); // [3][1][2]
        put(41, t17); // [4][0][1]
        put(45, t23); // [4][1][1]
        [t14, t17, t20, t23, t24, t25]
    };
    // frame 5
    let [t28, t31, t34, t37, t40, t43] = {
        let t28 = c5 * t14 - s5 * t3;
        let t31 = c5 * t3 + s5 * t14;
        let t34 = c5 * t20 - s5 * t5;
        let t37 = c5 * t5 + s5 * t20;
        let t40 = c5 * t24 + c2 * s5;
        let t43 = c2 * c5 - s5 * t24;
        put(40, t28); // [4][0][0]
        put(42, t31); // [4][0][2]
        put(44, t34); // [4][1][0]
        put(46, t37); // [4][1][2]
        put(50, t43); // [4][2][2]
        put(54, t31); // [5][0][2]
        put(58, t37); // [5][1][2]
        put(62, t43); // [5][2][2]
        [t28, t31, t34, t37, t40, t43]
    };
    // frame 6
    {
        let t47 = t9 + D6 * t31;
        let t48 = t10 + D6 * t37;
        let t49 = t11 + D6 * t43;
        let t52 = c6 * t28 + s6 * t17;
        let t55 = c6 * t17 - s6 * t28;
        let t58 = c6 * t34 + s6 * t23;
        let t61 = c6 * t23 - s6 * t34;
        let t67 = s6 * t40 - c6 * t25;
        let t68 = -s1;
        let t69 = -t0;
        let t70 = -s2;
        let t71 = -c1;
        let t72 = -t3;
        let t73 = -t5;
        let t74 = -t24;
        let t75 = -c2;
        let t76 = -t25;
        let t77 = -t40;
        let t78 = -(c6 * t40 + s6 * t25);
        put(1, t68); // [0][0][2]
        put(7, t68); // [1][0][1]
        put(9, t69); // [1][0][3]
        put(14, t70); // [1][2][0]
        put(21, t71); // [2][1][0]
        put(25, t70); // [2][2][1]
        put(29, t72); // [3][0][1]
        put(33, t73); // [3][1][1]
        put(36, t74); // [3][2][0]
        put(37, t75); // [3][2][1]
        put(38, t76); // [3][2][2]
        put(48, t77); // [4][2][0]
        put(49, t76); // [4][2][1]
        put(52, t52); // [5][0][0]
        put(53, t55); // [5][0][1]
        put(55, t47); // [5][0][3]
        put(56, t58); // [5][1][0]
        put(57, t61); // [5][1][1]
        put(59, t48); // [5][1][3]
        put(60, t78); // [5][2][0]
        put(61, t67); // [5][2][1]
        put(63, t49); // [5][2][3]
    }
}
