//! Potential energy, one entry per standard parameter.
//!
//! `U = h phi`, J per unit, zero at the world frame's origin; an offset torque counts as `FO q`.
//!
//! 34 multiplications, 14 additions; 84, 25 of 84 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 25;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (3, 0), (10, 0), (11, 0), (12, 0), (20, 0), (21, 0), (22, 0), (23, 0), (30, 0),
    (31, 0), (32, 0), (33, 0), (40, 0), (41, 0), (42, 0), (43, 0), (50, 0), (51, 0), (52, 0),
    (53, 0), (60, 0), (61, 0), (62, 0), (63, 0),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 1 + PATTERN[k].1
}

/// Potential energy, one entry per standard parameter: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [S; 84]) {
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
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [S; 84]) {
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
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let k3 = S::constant(-GRAVITY[2]);
    let k4 = S::constant(-GRAVITY[2] * constants::L1);
    let k_L1 = S::constant(constants::L1);
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
    // frame 3
    let [t1, t2, t3] = {
        let t1 = k_L1 + c2 * k_L2;
        let t2 = s2 * c3;
        let t3 = s2 * s3;
        put(0, k4);
        put(1, k3);
        put(2, k4);
        [t1, t2, t3]
    };
    // frame 4
    let [t6, t9] = {
        let t6 = c4 * t2 - c2 * s4;
        let t9 = c2 * c4 + s4 * t2;
        [t6, t9]
    };
    // frame 5
    let [t11, t14, t17] = {
        let t11 = t1 + k_L3 * t9;
        let t14 = c5 * t6 - s5 * t3;
        let t17 = c5 * t3 + s5 * t6;
        [t11, t14, t17]
    };
    // frame 6
    let [t20, t23] = {
        let t20 = c6 * t14 + s6 * t9;
        let t23 = c6 * t9 - s6 * t14;
        [t20, t23]
    };
    // frame 7
    let [t26, t29] = {
        let t26 = c7 * t20 - s7 * t17;
        let t29 = c7 * t17 + s7 * t20;
        [t26, t29]
    };
    // potential energy
    {
        let t30 = s2 * k3;
        let t31 = c2 * k3;
        let t32 = k3 * t1;
        let t33 = k3 * t2;
        let t35 = k3 * t6;
        let t36 = k3 * t9;
        let t37 = k3 * t11;
        let t38 = k3 * t14;
        let t39 = k3 * t17;
        let t40 = k3 * t20;
        let t41 = k3 * t23;
        let t42 = k3 * t26;
        let t44 = -(k3 * t3);
        let t45 = -t36;
        let t46 = -t39;
        let t47 = -(k3 * t29);
        put(3, t30);
        put(4, t31);
        put(5, t32);
        put(6, t33);
        put(7, t44);
        put(8, t31);
        put(9, t32);
        put(10, t35);
        put(11, t45);
        put(12, t44);
        put(13, t37);
        put(14, t38);
        put(15, t46);
        put(16, t36);
        put(17, t37);
        put(18, t40);
        put(19, t41);
        put(20, t39);
        put(21, t37);
        put(22, t42);
        put(23, t47);
        put(24, t41);
    }
}
