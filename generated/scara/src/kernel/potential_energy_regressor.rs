//! Potential energy, one entry per standard parameter.
//!
//! `U = h phi`, J per unit, zero at the world frame's origin; an offset torque counts as `FO q`.
//!
//! 1 multiplications, 1 additions; 40, 8 of 40 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 8;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (3, 0), (10, 0), (13, 0), (20, 0), (23, 0), (30, 0), (33, 0),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 1 + PATTERN[k].1
}

/// Potential energy, one entry per standard parameter: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [S; 40]) {
    let flat = &mut out[..];
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[1..3]),
            1 => clear(&mut flat[4..10]),
            2 => clear(&mut flat[11..13]),
            3 => clear(&mut flat[14..20]),
            4 => clear(&mut flat[21..23]),
            5 => clear(&mut flat[24..30]),
            6 => clear(&mut flat[31..33]),
            7 => clear(&mut flat[34..40]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [S; 40]) {
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
    let k1 = S::constant(-GRAVITY[2]);
    let k2 = S::constant(-GRAVITY[2] * constants::H);
    let k3 = S::constant(GRAVITY[2]);
    let k_H = S::constant(constants::H);
    // frame 3
    let t0 = {
        let t0 = k_H - q3;
        put(0, k2);
        put(1, k1);
        put(2, k2);
        put(3, k1);
        put(5, k3);
        put(7, k3);
        t0
    };
    // potential energy
    {
        let t1 = k1 * t0;
        put(4, t1);
        put(6, t1);
    }
}
