//! Jacobian of the tool frame's origin, in world axes.
//!
//! `(v, w) = J dq` as in `jacobian`; `tau = J' f` are the torques of a wrench on the tool. Khalil
//! and Dombre, 5.2.
//!
//! 66 multiplications, 38 additions; 6 x 7, 29 of 42 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 29;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (1, 0), (1, 1), (1, 2), (1, 3), (2, 1), (2, 2),
    (2, 3), (3, 1), (3, 2), (3, 3), (3, 4), (3, 5), (3, 6), (4, 1), (4, 2), (4, 3),
    (4, 4), (4, 5), (4, 6), (5, 0), (5, 2), (5, 3), (5, 4), (5, 5), (5, 6),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 7 + PATTERN[k].1
}

/// Jacobian of the tool frame's origin, in world axes: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 7]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            3 => clear(&mut flat[4..7]),
            7 => clear(&mut flat[11..15]),
            10 => clear(&mut flat[18..22]),
            16 => flat[28] = S::default(),
            23 => flat[36] = S::default(),
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
    let k3 = S::constant(1.0);
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
        put(11, s1); // [3][1]
        put(12, t4); // [3][2]
        put(18, t5); // [4][2]
        put(23, k3); // [5][0]
        put(24, c2); // [5][2]
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
        let t25 = -t23;
        put(13, t24); // [3][3]
        put(19, t21); // [4][3]
        put(25, t25); // [5][3]
        [
        t6, t7, t9, t12, t15, t18, t21, t22,
        t23,
    ]
    };
    // frame 4
    let [t28, t31, t34, t37, t40, t43] = {
        let t28 = c4 * t12 + s4 * t1;
        let t31 = s4 * t12 - c4 * t1;
        let t34 = c4 * t18 + s4 * t3;
        let t37 = c4 * t3 - s4 * t18;
        let t40 = c4 * t22 - c2 * s4;
        let t43 = c2 * c4 + s4 * t22;
        let t44 = -t37;
        put(14, t31); // [3][4]
        put(20, t44); // [4][4]
        put(26, t43); // [5][4]
        [t28, t31, t34, t37, t40, t43]
    };
    // frame 5
    let [
        t45, t46, t47, t48, t49, t50, t53, t59,
        t60, t61, t64,
    ] = {
        let t45 = k_L3 * t31;
        let t46 = k_L3 * t37;
        let t47 = k_L3 * t43;
        let t48 = t45 - t6;
        let t49 = t7 + t46;
        let t50 = t9 + t47;
        let t53 = c5 * t28 - s5 * t15;
        let t56 = c5 * t15 + s5 * t28;
        let t59 = c5 * t34 + s5 * t21;
        let t60 = c5 * t21;
        let t61 = s5 * t34;
        let t64 = s5 * t23 - c5 * t40;
        let t67 = c5 * t23 + s5 * t40;
        put(0, t49); // [0][0]
        put(4, t48); // [1][0]
        put(15, t56); // [3][5]
        put(27, t67); // [5][5]
        [
        t45, t46, t47, t48, t49, t50, t53, t59,
        t60, t61, t64,
    ]
    };
    // frame 6
    {
        let t70 = c6 * t31 - s6 * t53;
        let t71 = t61 - t60;
        let t77 = c6 * t43 + s6 * t64;
        let t78 = -(c6 * t37 + s6 * t59);
        put(16, t70); // [3][6]
        put(21, t71); // [4][5]
        put(22, t78); // [4][6]
        put(28, t77); // [5][6]
    }
    // columns
    {
        let t79 = k_L1 - t50;
        let t80 = c1 * t79;
        let t81 = s1 * t79;
        let t84 = c1 * t48 - s1 * t49;
        let t87 = c2 * t46 - t3 * t47;
        let t90 = c2 * t45 + t1 * t47;
        let t93 = t1 * t46 + t3 * t45;
        let t96 = t21 * t47 - t23 * t46;
        let t99 = t15 * t47 - t23 * t45;
        let t102 = t15 * t46 - t21 * t45;
        let t103 = -c1;
        put(1, t80); // [0][1]
        put(2, t87); // [0][2]
        put(3, t96); // [0][3]
        put(5, t81); // [1][1]
        put(6, t90); // [1][2]
        put(7, t99); // [1][3]
        put(8, t84); // [2][1]
        put(9, t93); // [2][2]
        put(10, t102); // [2][3]
        put(17, t103); // [4][1]
    }
}
