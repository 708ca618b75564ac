//! Acceleration of the last DH frame at zero `ddq`: `dJ/dt dq`.
//!
//! In world axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
//!
//! 22 multiplications, 10 additions; 6, 2 of 6 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 2;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (1, 0),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 1 + PATTERN[k].1
}

/// Acceleration of the last DH frame at zero `ddq`: `dJ/dt dq`: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 6]) {
    let flat = &mut out[..];
    entries(trig, dq, |k, x| {
        flat[place(k)] = x;
        match k {
            1 => clear(&mut flat[2..6]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 6]) {
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
    let [s1, s2, _, s4] = trig.sin;
    let [c1, c2, _, c4] = trig.cos;
    let [dq1, dq2, ..] = *dq;
    let k_L1 = S::constant(constants::L1);
    let k_L2 = S::constant(constants::L2);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [t3, a2_y, t5] = {
        let w2_z = dq1 + dq2;
        let t2 = k_L1 * t0;
        let t3 = c2 * t2;
        let a2_y = s2 * t2;
        let t5 = w2_z * w2_z;
        [t3, a2_y, t5]
    };
    // link 3: motion
    let t7 = {
        let t7 = t3 + k_L2 * t5;
        t7
    };
    // link 4: motion
    let [t10, a4_y] = {
        let t10 = c4 * t7 + s4 * a2_y;
        let a4_y = s4 * t7 - c4 * a2_y;
        [t10, a4_y]
    };
    // frame 2
    let [t16, t19] = {
        let t16 = s1 * s2 - c1 * c2;
        let t19 = s1 * c2 + c1 * s2;
        [t16, t19]
    };
    // frame 4
    let [t22, t25] = {
        let t22 = c4 * t16 - s4 * t19;
        let t25 = c4 * t19 + s4 * t16;
        [t22, t25]
    };
    // in world axes
    {
        let t28 = t10 * t22 + a4_y * t25;
        let t31 = a4_y * t22 - t10 * t25;
        put(0, t28);
        put(1, t31);
    }
}
