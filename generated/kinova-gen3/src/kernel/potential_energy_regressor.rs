//! Potential energy, one entry per standard parameter.
//!
//! `U = h phi`, J per unit, zero at the world frame's origin; an offset torque counts as `FO q`.
//!
//! 40 multiplications, 19 additions; 91, 32 of 91 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{GRAVITY, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 32;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (3, 0), (10, 0), (11, 0), (12, 0), (20, 0), (21, 0), (22, 0), (23, 0), (30, 0),
    (31, 0), (32, 0), (33, 0), (40, 0), (41, 0), (42, 0), (43, 0), (50, 0), (51, 0), (52, 0),
    (53, 0), (60, 0), (61, 0), (62, 0), (63, 0), (84, 0), (85, 0), (86, 0), (87, 0), (88, 0),
    (89, 0), (90, 0),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 1 + PATTERN[k].1
}

/// Potential energy, one entry per standard parameter: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [S; 91]) {
    let flat = &mut out[..];
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[1..3]),
            1 => clear(&mut flat[4..10]),
            4 => clear(&mut flat[13..20]),
            8 => clear(&mut flat[24..30]),
            12 => clear(&mut flat[34..40]),
            16 => clear(&mut flat[44..50]),
            20 => clear(&mut flat[54..60]),
            24 => clear(&mut flat[64..84]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [S; 91]) {
    entries(trig, |k, x| {
        out[PATTERN[k].0] = x;
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
    let [q1, q2, q3, q4, q5, q6, q7] = trig.q;
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let k0 = S::constant(0.42076);
    let k1 = S::constant(0.28481);
    let k2 = S::constant(0.01275);
    let k3 = S::constant(0.31436);
    let k4 = S::constant(0.00035);
    let k5 = S::constant(0.167455);
    let k6 = S::constant(-GRAVITY[2]);
    let k7 = S::constant(-GRAVITY[2] * 0.28481);
    let k8 = S::constant(GRAVITY[2]);
    // frame 3
    let [t1, t2, t3] = {
        let t1 = k1 + c2 * k0;
        let t2 = s2 * c3;
        let t3 = s2 * s3;
        put(0, k7);
        put(1, k8);
        put(2, k7);
        put(25, q1);
        put(26, q2);
        put(27, q3);
        put(28, q4);
        put(29, q5);
        put(30, q6);
        put(31, q7);
        [t1, t2, t3]
    };
    // frame 4
    let [t5, t8, t11] = {
        let t5 = t1 + t3 * k2;
        let t8 = c4 * t2 + c2 * s4;
        let t11 = s4 * t2 - c2 * c4;
        [t5, t8, t11]
    };
    // frame 5
    let [t13, t16, t19] = {
        let t13 = t5 - t11 * k3;
        let t16 = s5 * t3 - c5 * t8;
        let t19 = c5 * t3 + s5 * t8;
        [t13, t16, t19]
    };
    // frame 6
    let [t21, t24, t27] = {
        let t21 = t13 + t19 * k4;
        let t24 = c6 * t16 + s6 * t11;
        let t27 = c6 * t11 - s6 * t16;
        [t21, t24, t27]
    };
    // frame 7
    let [t29, t32, t35] = {
        let t29 = t21 - t27 * k5;
        let t32 = c7 * t24 + s7 * t19;
        let t35 = c7 * t19 - s7 * t24;
        [t29, t32, t35]
    };
    // potential energy
    {
        let t38 = k6 * t1;
        let t40 = k6 * t3;
        let t41 = k6 * t5;
        let t43 = k6 * t11;
        let t44 = k6 * t13;
        let t45 = k6 * t16;
        let t46 = k6 * t19;
        let t47 = k6 * t21;
        let t48 = k6 * t24;
        let t49 = k6 * t27;
        let t50 = k6 * t29;
        let t51 = k6 * t32;
        let t52 = k6 * t35;
        let t53 = -(s2 * k6);
        let t54 = -(c2 * k6);
        let t55 = -(k6 * t2);
        let t56 = -(k6 * t8);
        let t57 = -t40;
        let t58 = -t46;
        put(3, t53);
        put(4, t54);
        put(5, t38);
        put(6, t55);
        put(7, t40);
        put(8, t54);
        put(9, t41);
        put(10, t56);
        put(11, t43);
        put(12, t57);
        put(13, t44);
        put(14, t45);
        put(15, t46);
        put(16, t43);
        put(17, t47);
        put(18, t48);
        put(19, t49);
        put(20, t58);
        put(21, t50);
        put(22, t51);
        put(23, t52);
        put(24, t49);
    }
}
