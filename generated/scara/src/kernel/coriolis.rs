//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 29 multiplications, 17 additions; 4, 3 of 4 structurally nonzero.

use super::super::runtime::{Scalar, apart};
use super::super::{DOF, BASE, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 3;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (1, 0), (3, 0),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 1 + PATTERN[k].1
}

/// Coriolis and centrifugal torques `C dq`: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], out: &mut [S; 4]) {
    let flat = &mut out[..];
    entries(trig, dq, beta, |k, x| {
        flat[place(k)] = x;
        match k {
            1 => flat[2] = S::default(),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], out: &mut [S; 4]) {
    entries(trig, dq, beta, |k, x| {
        out[PATTERN[k].0] = x;
    });
}

/// The same, only the entries of [`PATTERN`].
#[inline]
pub fn packed<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], out: &mut [S; NONZEROS]) {
    entries(trig, dq, beta, |k, x| out[k] = x);
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, _, s4] = trig.sin;
    let [_, c2, _, c4] = trig.cos;
    let [dq1, dq2, _, dq4] = *dq;
    let [_, MSX2R, MSY2R, _, M3R, MSX4, MSY4, ..] = *beta;
    let k_L1 = S::constant(constants::L1);
    let k_L2 = S::constant(constants::L2);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [w2_z, t3, a2_y, t5] = {
        let w2_z = dq1 + dq2;
        let t2 = k_L1 * t0;
        let t3 = c2 * t2;
        let a2_y = s2 * t2;
        let t5 = w2_z * w2_z;
        [w2_z, t3, a2_y, t5]
    };
    // link 3: motion
    let t7 = {
        let t7 = t3 + k_L2 * t5;
        t7
    };
    // link 4: motion
    let [t11, a4_y, t15] = {
        let w4_z = dq4 - w2_z;
        let t11 = c4 * t7 + s4 * a2_y;
        let a4_y = s4 * t7 - c4 * a2_y;
        let t15 = w4_z * w4_z;
        [t11, a4_y, t15]
    };
    // link 4: force and moment
    let [n4_z, t23, t26] = {
        let t16 = MSX4 * t15;
        let t17 = MSY4 * t15;
        let n4_z = MSX4 * a4_y + MSY4 * t11;
        let t23 = s4 * t17 - c4 * t16;
        let t26 = s4 * t16 + c4 * t17;
        put(2, n4_z);
        [n4_z, t23, t26]
    };
    // link 3: force and moment
    let [f3_x, t30, t32] = {
        let f3_x = t23 - M3R * t7;
        let t30 = t26 + M3R * a2_y;
        let t32 = n4_z - k_L2 * t30;
        [f3_x, t30, t32]
    };
    // link 2: force and moment
    {
        let f2_x = f3_x - MSX2R * t5;
        let f2_y = t30 - MSY2R * t5;
        let n2_z = MSX2R * a2_y + MSY2R * t3 - t32;
        let f1_y = s2 * f2_x + c2 * f2_y;
        let n1_z = n2_z + k_L1 * f1_y;
        put(0, n1_z);
        put(1, n2_z);
    }
}
