//! Potential energy, one entry per standard parameter.
//!
//! `U = h phi`, J per unit, zero at the world frame's origin; an offset torque counts as `FO q`.
//!
//! 32 multiplications, 12 additions; 84, 25 of 84 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 25;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (3, 0), (10, 0), (11, 0), (12, 0), (20, 0), (21, 0), (22, 0), (30, 0), (31, 0),
    (32, 0), (40, 0), (41, 0), (42, 0), (43, 0), (50, 0), (51, 0), (52, 0), (53, 0), (78, 0),
    (79, 0), (80, 0), (81, 0), (82, 0), (83, 0),
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
            7 => clear(&mut flat[23..30]),
            10 => clear(&mut flat[33..40]),
            14 => clear(&mut flat[44..50]),
            18 => clear(&mut flat[54..78]),
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
    let [q1, q2, q3, q4, q5, q6] = trig.q;
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let k0 = S::constant(-constants::A2);
    let k2 = S::constant(-constants::A3);
    let k5 = S::constant(-GRAVITY[2]);
    let k6 = S::constant(-GRAVITY[2] * constants::D1);
    let k_D1 = S::constant(constants::D1);
    let k_D5 = S::constant(constants::D5);
    let k_D6 = S::constant(constants::D6);
    // frame 3
    let [t1, t4, t7] = {
        let t1 = k_D1 - s2 * k0;
        let t4 = s2 * c3 + c2 * s3;
        let t7 = c2 * c3 - s2 * s3;
        put(0, k6);
        put(1, k5);
        put(2, k6);
        put(19, q1);
        put(20, q2);
        put(21, q3);
        put(22, q4);
        put(23, q5);
        put(24, q6);
        [t1, t4, t7]
    };
    // frame 4
    let [t9, t12, t15] = {
        let t9 = t1 - t4 * k2;
        let t12 = c4 * t4 + s4 * t7;
        let t15 = c4 * t7 - s4 * t4;
        [t9, t12, t15]
    };
    // frame 5
    let [t17, t18, t19] = {
        let t17 = t9 - k_D5 * t15;
        let t18 = c5 * t12;
        let t19 = s5 * t12;
        [t17, t18, t19]
    };
    // frame 6
    let [t21, t24, t27] = {
        let t21 = t17 - k_D6 * t19;
        let t24 = c6 * t18 + s6 * t15;
        let t27 = c6 * t15 - s6 * t18;
        [t21, t24, t27]
    };
    // potential energy
    {
        let t28 = s2 * k5;
        let t29 = c2 * k5;
        let t30 = k5 * t1;
        let t31 = k5 * t4;
        let t32 = k5 * t7;
        let t33 = k5 * t9;
        let t34 = k5 * t12;
        let t35 = k5 * t15;
        let t36 = k5 * t17;
        let t37 = k5 * t18;
        let t39 = k5 * t21;
        let t40 = k5 * t24;
        let t41 = k5 * t27;
        let t42 = -(k5 * t19);
        let t43 = -t35;
        put(3, t28);
        put(4, t29);
        put(5, t30);
        put(6, t31);
        put(7, t32);
        put(8, t33);
        put(9, t34);
        put(10, t35);
        put(11, t36);
        put(12, t37);
        put(13, t42);
        put(14, t43);
        put(15, t39);
        put(16, t40);
        put(17, t41);
        put(18, t42);
    }
}
