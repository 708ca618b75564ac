//! Gravity torques `g`.
//!
//! N m, from the base parameters: the torques that hold the arm at rest.
//!
//! 1 multiplications, 1 additions; 4, 1 of 4 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{BASE, GRAVITY, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 1;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (2, 0),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 1 + PATTERN[k].1
}

/// Gravity torques `g`: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], out: &mut [S; 4]) {
    let flat = &mut out[..];
    clear(&mut flat[0..2]);
    entries(trig, beta, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => flat[3] = S::default(),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], out: &mut [S; 4]) {
    entries(trig, beta, |k, x| {
        out[PATTERN[k].0] = x;
    });
}

/// The same, only the entries of [`PATTERN`].
#[inline]
pub fn packed<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], out: &mut [S; NONZEROS]) {
    entries(trig, beta, |k, x| out[k] = x);
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, _, _, _, M3R, ..] = *beta;
    let _ = trig;
    let k0 = S::constant(-GRAVITY[2]);
    // link 3: force and moment
    let f2_z = k0 * M3R;
    let t1 = -f2_z;
    put(0, t1);
}
