//! Potential energy, one entry per standard parameter.
//!
//! `U = h phi`, J per unit, zero at the world frame's origin; an offset torque counts as `FO q`.
//!
//! 22 multiplications, 12 additions; 66, 20 of 66 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 20;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (2, 0), (10, 0), (11, 0), (13, 0), (20, 0), (22, 0), (23, 0), (30, 0), (31, 0),
    (32, 0), (33, 0), (40, 0), (41, 0), (42, 0), (43, 0), (50, 0), (51, 0), (52, 0), (53, 0),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 1 + PATTERN[k].1
}

/// Potential energy, one entry per standard parameter: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [S; 66]) {
    let flat = &mut out[..];
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => flat[1] = S::default(),
            1 => clear(&mut flat[3..10]),
            3 => flat[12] = S::default(),
            4 => clear(&mut flat[14..20]),
            5 => flat[21] = S::default(),
            7 => clear(&mut flat[24..30]),
            11 => clear(&mut flat[34..40]),
            15 => clear(&mut flat[44..50]),
            19 => clear(&mut flat[54..66]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [S; 66]) {
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
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let k2 = S::constant(-GRAVITY[2]);
    let k3 = S::constant(-GRAVITY[2] * constants::D1);
    let k4 = S::constant(GRAVITY[2]);
    let k_D1 = S::constant(constants::D1);
    let k_D6 = S::constant(constants::D6);
    // frame 3
    let t1 = {
        let t1 = k_D1 + c2 * q3;
        put(0, k3);
        put(1, k4);
        put(2, k3);
        t1
    };
    // frame 4
    let [t2, t3] = {
        let t2 = s2 * s4;
        let t3 = s2 * c4;
        [t2, t3]
    };
    // frame 5
    let [t6, t9] = {
        let t6 = c5 * t2 + c2 * s5;
        let t9 = c2 * c5 - s5 * t2;
        [t6, t9]
    };
    // frame 6
    let [t11, t14, t17] = {
        let t11 = t1 + k_D6 * t9;
        let t14 = c6 * t6 + s6 * t3;
        let t17 = s6 * t6 - c6 * t3;
        [t11, t14, t17]
    };
    // potential energy
    {
        let t19 = c2 * k2;
        let t20 = k2 * t1;
        let t24 = k2 * t9;
        let t25 = k2 * t11;
        let t27 = k2 * t17;
        let t28 = -(s2 * k2);
        let t29 = -(k2 * t2);
        let t30 = -t19;
        let t31 = -(k2 * t3);
        let t32 = -(k2 * t6);
        let t33 = -(k2 * t14);
        put(3, t28);
        put(4, t19);
        put(5, t20);
        put(6, t28);
        put(7, t19);
        put(8, t20);
        put(9, t29);
        put(10, t30);
        put(11, t31);
        put(12, t20);
        put(13, t32);
        put(14, t31);
        put(15, t24);
        put(16, t25);
        put(17, t33);
        put(18, t27);
        put(19, t24);
    }
}
