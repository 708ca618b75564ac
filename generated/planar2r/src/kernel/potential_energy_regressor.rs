//! Potential energy, one entry per standard parameter.
//!
//! `U = h phi`, J per unit, zero at the world frame's origin; an offset torque counts as `FO q`.
//!
//! 9 multiplications, 2 additions; 24, 5 of 24 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 5;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (1, 0), (2, 0), (10, 0), (11, 0), (12, 0),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 1 + PATTERN[k].1
}

/// Potential energy, one entry per standard parameter: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [S; 24]) {
    let flat = &mut out[..];
    flat[0] = S::default();
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            1 => clear(&mut flat[3..10]),
            4 => clear(&mut flat[13..24]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [S; 24]) {
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
    let [s1, s2] = trig.sin;
    let [c1, c2] = trig.cos;
    let k0 = S::constant(-GRAVITY[1]);
    let k1 = S::constant(-GRAVITY[1] * constants::L1);
    // frame 2
    let [t2, t5] = {
        let t2 = c1 * c2 - s1 * s2;
        let t5 = s1 * c2 + c1 * s2;
        [t2, t5]
    };
    // potential energy
    {
        let t6 = s1 * k0;
        let t7 = c1 * k0;
        let t8 = s1 * k1;
        let t9 = k0 * t5;
        let t10 = k0 * t2;
        put(0, t6);
        put(1, t7);
        put(2, t8);
        put(3, t9);
        put(4, t10);
    }
}
