//! Potential energy, one entry per standard parameter.
//!
//! `U = h phi`, J per unit, zero at the world frame's origin; an offset torque counts as `FO q`.
//!
//! 29 multiplications, 15 additions; 78, 18 of 78 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 18;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (3, 0), (11, 0), (12, 0), (20, 0), (21, 0), (22, 0), (30, 0), (31, 0), (32, 0), (33, 0),
    (40, 0), (41, 0), (42, 0), (43, 0), (50, 0), (51, 0), (52, 0), (53, 0),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 1 + PATTERN[k].1
}

/// Potential energy, one entry per standard parameter: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [S; 78]) {
    let flat = &mut out[..];
    clear(&mut flat[0..3]);
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[4..11]),
            2 => clear(&mut flat[13..20]),
            5 => clear(&mut flat[23..30]),
            9 => clear(&mut flat[34..40]),
            13 => clear(&mut flat[44..50]),
            17 => clear(&mut flat[54..78]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [S; 78]) {
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
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let k1 = S::constant(-constants::A3);
    let k3 = S::constant(-GRAVITY[2]);
    let k4 = S::constant(-GRAVITY[2] * constants::A2);
    let k_A2 = S::constant(constants::A2);
    let k_D4 = S::constant(constants::D4);
    // frame 3
    let [t0, t3, t6] = {
        let t0 = s2 * k_A2;
        let t3 = s2 * c3 + c2 * s3;
        let t6 = s2 * s3 - c2 * c3;
        put(0, k3);
        [t0, t3, t6]
    };
    // frame 4
    let [t10, t11, t12] = {
        let t10 = t3 * k1 - k_D4 * t6 - t0;
        let t11 = c4 * t3;
        let t12 = s4 * t3;
        [t10, t11, t12]
    };
    // frame 5
    let [t15, t18] = {
        let t15 = s5 * t6 - c5 * t11;
        let t18 = c5 * t6 + s5 * t11;
        [t15, t18]
    };
    // frame 6
    let [t21, t24] = {
        let t21 = c6 * t15 + s6 * t12;
        let t24 = c6 * t12 - s6 * t15;
        [t21, t24]
    };
    // potential energy
    {
        let t29 = k3 * t6;
        let t30 = k3 * t10;
        let t32 = k3 * t12;
        let t33 = k3 * t15;
        let t34 = k3 * t18;
        let t35 = k3 * t21;
        let t36 = k3 * t24;
        let t37 = -(s2 * k3);
        let t38 = -(c2 * k3);
        let t39 = -(s2 * k4);
        let t40 = -(k3 * t3);
        let t41 = -(k3 * t11);
        let t42 = -t29;
        let t43 = -t34;
        put(1, t37);
        put(2, t38);
        put(3, t39);
        put(4, t40);
        put(5, t29);
        put(6, t30);
        put(7, t41);
        put(8, t32);
        put(9, t42);
        put(10, t30);
        put(11, t33);
        put(12, t34);
        put(13, t32);
        put(14, t30);
        put(15, t35);
        put(16, t36);
        put(17, t43);
    }
}
