//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its
//! origin. Katsumata et al. 2019, (7).
//!
//! 21 multiplications, 15 additions; 2 x 10, 8 of 20 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 8;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 6), (1, 0), (1, 1), (1, 2), (1, 6),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 10 + PATTERN[k].1
}

/// Regressor of a body fixed to the tool frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 10]; 2]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            2 => clear(&mut flat[3..6]),
            3 => clear(&mut flat[7..10]),
            6 => clear(&mut flat[13..16]),
            7 => clear(&mut flat[17..20]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 10]; 2]) {
    entries(trig, dq, ddq, |k, x| {
        out[PATTERN[k].0][PATTERN[k].1] = x;
    });
}

/// The same, only the entries of [`PATTERN`].
#[inline]
pub fn packed<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [S; NONZEROS]) {
    entries(trig, dq, ddq, |k, x| out[k] = x);
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], mut put: impl FnMut(usize, S)) {
    let [s1, s2] = trig.sin;
    let [c1, c2] = trig.cos;
    let [dq1, dq2] = *dq;
    let [ddq1, ddq2] = *ddq;
    let k0 = S::constant(-GRAVITY[1]);
    let k_L1 = S::constant(constants::L1);
    let k_L2 = S::constant(constants::L2);
    // link 1: motion
    let [a1_x, a1_y, t2] = {
        let a1_x = s1 * k0;
        let a1_y = c1 * k0;
        let t2 = dq1 * dq1;
        [a1_x, a1_y, t2]
    };
    // link 2: motion
    let [dw2_z, t11, a2_y, t15] = {
        let w2_z = dq1 + dq2;
        let dw2_z = ddq1 + ddq2;
        let t7 = k_L1 * t2 - a1_x;
        let t8 = a1_y + k_L1 * ddq1;
        let t11 = c2 * t7 - s2 * t8;
        let a2_y = c2 * t8 + s2 * t7;
        let t15 = w2_z * w2_z;
        put(3, dw2_z); // row 1, ZZ
        put(6, t11); // row 2, MSY
        put(7, dw2_z); // row 2, ZZ
        [dw2_z, t11, a2_y, t15]
    };
    // joint axes in frame 2
    let [v1_2_x, v1_2_y, t19, t20, t21, t22] = {
        let v1_2_x = s2 * k_L1;
        let v1_2_y = c2 * k_L1;
        let t19 = dw2_z * k_L2;
        let t20 = t11 + t15 * k_L2;
        let t21 = a2_y + t19;
        let t22 = k_L2 * t21;
        put(4, t22); // row 2, M
        [v1_2_x, v1_2_y, t19, t20, t21, t22]
    };
    // payload: column M
    let t27 = {
        let t26 = t22 + (v1_2_y * t21 - v1_2_x * t20);
        let t27 = t19 + t21;
        put(0, t26); // row 1, M
        put(5, t27); // row 2, MSX
        t27
    };
    // payload: column MSX
    {
        let t31 = t27 + (dw2_z * v1_2_y - t15 * v1_2_x);
        put(1, t31); // row 1, MSX
    }
    // payload: column MSY
    {
        let t35 = t11 - (dw2_z * v1_2_x + t15 * v1_2_y);
        put(2, t35); // row 1, MSY
    }
}
