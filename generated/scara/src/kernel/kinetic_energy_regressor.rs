//! Kinetic energy, one entry per standard parameter.
//!
//! `T = h phi`, J per unit. Khalil and Dombre, 9.4.
//!
//! 28 multiplications, 11 additions; 40, 13 of 40 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 13;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (6, 0), (10, 0), (11, 0), (12, 0), (16, 0), (20, 0), (21, 0), (22, 0), (26, 0), (30, 0),
    (31, 0), (32, 0), (36, 0),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 1 + PATTERN[k].1
}

/// Kinetic energy, one entry per standard parameter: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 40]) {
    let flat = &mut out[..];
    clear(&mut flat[0..6]);
    entries(trig, dq, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[7..10]),
            3 => clear(&mut flat[13..16]),
            4 => clear(&mut flat[17..20]),
            7 => clear(&mut flat[23..26]),
            8 => clear(&mut flat[27..30]),
            11 => clear(&mut flat[33..36]),
            12 => clear(&mut flat[37..40]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 40]) {
    entries(trig, dq, |k, x| {
        out[PATTERN[k].0] = x;
    });
}

/// The same, only the entries of [`PATTERN`].
#[inline]
pub fn packed<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; NONZEROS]) {
    entries(trig, dq, |k, x| out[k] = x);
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], mut put: impl FnMut(usize, S)) {
    let [_, s2, _, s4] = trig.sin;
    let [_, c2, _, c4] = trig.cos;
    let [dq1, dq2, dq3, dq4] = *dq;
    let k2 = S::constant(0.5);
    let k_L1 = S::constant(constants::L1);
    let k_L2 = S::constant(constants::L2);
    // link 2: velocity
    let [t1, t2, t3] = {
        let t0 = k_L1 * dq1;
        let t1 = s2 * t0;
        let t2 = c2 * t0;
        let t3 = dq1 + dq2;
        [t1, t2, t3]
    };
    // link 3: velocity
    let t5 = {
        let t5 = t2 + k_L2 * t3;
        t5
    };
    // link 4: velocity
    let [t8, t11, t12] = {
        let t8 = c4 * t1 - s4 * t5;
        let t11 = c4 * t5 + s4 * t1;
        let t12 = t3 - dq4;
        [t8, t11, t12]
    };
    // kinetic energy
    {
        let t14 = k2 * (dq1 * dq1);
        let t15 = t2 * t3;
        let t16 = t1 * t3;
        let t17 = t1 * t1;
        let t20 = k2 * (t17 + t2 * t2);
        let t22 = k2 * (t3 * t3);
        let t23 = t3 * t5;
        let t25 = dq3 * dq3;
        let t28 = k2 * (t25 + (t17 + t5 * t5));
        let t29 = t11 * t12;
        let t30 = t8 * t12;
        let t35 = k2 * (t25 + (t8 * t8 + t11 * t11));
        let t37 = k2 * (t12 * t12);
        let t38 = -t16;
        put(0, t14);
        put(1, t20);
        put(2, t15);
        put(3, t38);
        put(4, t22);
        put(5, t28);
        put(6, t23);
        put(7, t16);
        put(8, t22);
        put(9, t35);
        put(10, t29);
        put(11, t30);
        put(12, t37);
    }
}
