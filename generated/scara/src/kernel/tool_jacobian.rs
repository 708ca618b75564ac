//! Jacobian of the tool frame's origin, in world axes.
//!
//! `(v, w) = J dq` as in `jacobian`; `tau = J' f` are the torques of a wrench on the tool. Khalil
//! and Dombre, 5.2.
//!
//! 8 multiplications, 6 additions; 6 x 4, 8 of 24 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 8;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (1, 0), (1, 1), (2, 2), (5, 0), (5, 1), (5, 3),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 4 + PATTERN[k].1
}

/// Jacobian of the tool frame's origin, in world axes: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 4]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            1 => clear(&mut flat[2..4]),
            3 => clear(&mut flat[6..10]),
            4 => clear(&mut flat[11..20]),
            6 => flat[22] = S::default(),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 4]; 6]) {
    entries(trig, |k, x| {
        out[PATTERN[k].0][PATTERN[k].1] = x;
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
    let [s1, s2, ..] = trig.sin;
    let [c1, c2, ..] = trig.cos;
    let k2 = S::constant(-1.0);
    let k3 = S::constant(1.0);
    let k_L1 = S::constant(constants::L1);
    let k_L2 = S::constant(constants::L2);
    // frame 2
    let [t0, t1, t4, t7] = {
        let t0 = c1 * k_L1;
        let t1 = s1 * k_L1;
        let t4 = c1 * c2 - s1 * s2;
        let t7 = s1 * c2 + c1 * s2;
        put(4, k2); // [2][2]
        put(5, k3); // [5][0]
        put(6, k3); // [5][1]
        put(7, k2); // [5][3]
        [t0, t1, t4, t7]
    };
    // frame 3
    {
        let t8 = k_L2 * t4;
        let t9 = k_L2 * t7;
        let t10 = t0 + t8;
        let t12 = -(t1 + t9);
        let t13 = -t9;
        put(0, t12); // [0][0]
        put(1, t13); // [0][1]
        put(2, t10); // [1][0]
        put(3, t8); // [1][1]
    }
}
