//! Jacobian of the last DH frame's origin, in base axes.
//!
//! `(v, w) = J dq`: rows 0-2 linear, m/s, rows 3-5 angular, rad/s. Khalil and Dombre, 5.2.
//!
//! 66 multiplications, 38 additions; 6 x 7, 29 of 42 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 29;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (1, 0), (1, 1), (1, 2), (1, 3), (2, 1), (2, 2),
    (2, 3), (3, 1), (3, 2), (3, 3), (3, 4), (3, 5), (3, 6), (4, 1), (4, 2), (4, 3),
    (4, 4), (4, 5), (4, 6), (5, 0), (5, 2), (5, 3), (5, 4), (5, 5), (5, 6),
];

/// Jacobian of the last DH frame's origin, in base axes: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 7]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    flat[4..7].fill(S::default());
    flat[11..15].fill(S::default());
    flat[18..22].fill(S::default());
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
        put(11, s1); // [3][1]
        put(23, k3); // [5][0]
        put(24, c2); // [5][2]
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
        put(19, t19); // [4][3]
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
        let t33 = c4 * t3 - s4 * t16;
        let t36 = c4 * t20 - c2 * s4;
        let t39 = c2 * c4 + s4 * t20;
        put(14, t27); // [3][4]
        put(26, t39); // [5][4]
        [t24, t27, t30, t33, t36, t39]
    };
    // frame 5
    let [
        t40, t41, t42, t43, t44, t45, t48, t54,
        t55, t56, t59,
    ] = {
        let t40 = L3 * t27;
        let t41 = L3 * t33;
        let t42 = L3 * t39;
        let t43 = t40 - t4;
        let t44 = t5 + t41;
        let t45 = t7 + t42;
        let t48 = c5 * t24 - s5 * t13;
        let t51 = c5 * t13 + s5 * t24;
        let t54 = c5 * t30 + s5 * t19;
        let t55 = c5 * t19;
        let t56 = s5 * t30;
        let t59 = s5 * t21 - c5 * t36;
        let t62 = c5 * t21 + s5 * t36;
        put(0, t44); // [0][0]
        put(4, t43); // [1][0]
        put(15, t51); // [3][5]
        put(27, t62); // [5][5]
        [
        t40, t41, t42, t43, t44, t45, t48, t54,
        t55, t56, t59,
    ]
    };
    // frame 6
    let t69 = {
        let t65 = c6 * t27 - s6 * t48;
        let t66 = t56 - t55;
        let t69 = c6 * t33 + s6 * t54;
        let t72 = c6 * t39 + s6 * t59;
        put(16, t65); // [3][6]
        put(21, t66); // [4][5]
        put(28, t72); // [5][6]
        t69
    };
    // columns
    {
        let t73 = L1 - t45;
        let t74 = c1 * t73;
        let t75 = s1 * t73;
        let t78 = c1 * t43 - s1 * t44;
        let t81 = c2 * t41 - t3 * t42;
        let t84 = c2 * t40 + t1 * t42;
        let t87 = t1 * t41 + t3 * t40;
        let t90 = t19 * t42 - t21 * t41;
        let t93 = t13 * t42 - t21 * t40;
        let t96 = t13 * t41 - t19 * t40;
        let t97 = -t1;
        let t98 = -t13;
        let t99 = -c1;
        let t100 = -t3;
        let t101 = -t33;
        let t102 = -t69;
        let t103 = -t21;
        put(1, t74); // [0][1]
        put(2, t81); // [0][2]
        put(3, t90); // [0][3]
        put(5, t75); // [1][1]
        put(6, t84); // [1][2]
        put(7, t93); // [1][3]
        put(8, t78); // [2][1]
        put(9, t87); // [2][2]
        put(10, t96); // [2][3]
        put(12, t97); // [3][2]
        put(13, t98); // [3][3]
        put(17, t99); // [4][1]
        put(18, t100); // [4][2]
        put(20, t101); // [4][4]
        put(22, t102); // [4][6]
        put(25, t103); // [5][3]
    }
}
