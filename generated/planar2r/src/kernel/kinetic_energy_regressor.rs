//! Kinetic energy, one entry per standard parameter.
//!
//! `T = h phi`, J per unit. Khalil and Dombre, 9.4.
//!
//! 12 multiplications, 3 additions; 24, 5 of 24 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 5;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (6, 0), (10, 0), (11, 0), (12, 0), (16, 0),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 1 + PATTERN[k].1
}

/// Kinetic energy, one entry per standard parameter: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 24]) {
    let flat = &mut out[..];
    clear(&mut flat[0..6]);
    entries(trig, dq, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[7..10]),
            3 => clear(&mut flat[13..16]),
            4 => clear(&mut flat[17..24]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 24]) {
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
    let [_, s2] = trig.sin;
    let [_, c2] = trig.cos;
    let [dq1, dq2] = *dq;
    let k0 = S::constant(0.5);
    // link 2: velocity
    let [t1, t2, t3] = {
        let t0 = k0 * dq1;
        let t1 = s2 * t0;
        let t2 = c2 * t0;
        let t3 = dq1 + dq2;
        [t1, t2, t3]
    };
    // kinetic energy
    {
        let t5 = k0 * (dq1 * dq1);
        let t6 = t2 * t3;
        let t11 = k0 * (t1 * t1 + t2 * t2);
        let t13 = k0 * (t3 * t3);
        let t14 = -(t1 * t3);
        put(0, t5);
        put(1, t11);
        put(2, t6);
        put(3, t14);
        put(4, t13);
    }
}
