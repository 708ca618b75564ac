//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its
//! origin. Katsumata et al. 2019, (7).
//!
//! 34 multiplications, 24 additions; 4 x 10, 12 of 40 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 12;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 6), (1, 0), (1, 1), (1, 2), (1, 6), (2, 0), (3, 1),
    (3, 2), (3, 6),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 10 + PATTERN[k].1
}

/// Regressor of a body fixed to the tool frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 10]; 4]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            2 => clear(&mut flat[3..6]),
            3 => clear(&mut flat[7..10]),
            6 => clear(&mut flat[13..16]),
            7 => clear(&mut flat[17..20]),
            8 => clear(&mut flat[21..31]),
            10 => clear(&mut flat[33..36]),
            11 => clear(&mut flat[37..40]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 10]; 4]) {
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
    let [_, s2, _, s4] = trig.sin;
    let [_, c2, _, c4] = trig.cos;
    let [dq1, dq2, _, dq4] = *dq;
    let [ddq1, ddq2, ddq3, ddq4] = *ddq;
    let k2 = S::constant(GRAVITY[2]);
    let k_L1 = S::constant(constants::L1);
    let k_L2 = S::constant(constants::L2);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [w2_z, dw2_z, t7, a2_y, t11] = {
        let w2_z = dq1 + dq2;
        let dw2_z = ddq1 + ddq2;
        let t3 = k_L1 * t0;
        let t4 = k_L1 * ddq1;
        let t7 = c2 * t3 - s2 * t4;
        let a2_y = c2 * t4 + s2 * t3;
        let t11 = w2_z * w2_z;
        [w2_z, dw2_z, t7, a2_y, t11]
    };
    // link 3: motion
    let [t14, t15] = {
        let t14 = t7 + k_L2 * t11;
        let t15 = a2_y + k_L2 * dw2_z;
        let a3_z = ddq3 + k2;
        put(8, a3_z); // row 3, M
        [t14, t15]
    };
    // link 4: motion
    let [dw4_z, t21, a4_y, t25] = {
        let w4_z = dq4 - w2_z;
        let dw4_z = ddq4 - dw2_z;
        let t21 = c4 * t14 + s4 * t15;
        let a4_y = s4 * t14 - c4 * t15;
        let t25 = w4_z * w4_z;
        let t26 = -dw4_z;
        put(3, t26); // row 1, ZZ
        put(7, t26); // row 2, ZZ
        put(9, a4_y); // row 4, MSX
        put(10, t21); // row 4, MSY
        put(11, dw4_z); // row 4, ZZ
        [dw4_z, t21, a4_y, t25]
    };
    // joint axes in frame 2
    let [v1_2_x, v1_2_y] = {
        let v1_2_x = s2 * k_L1;
        let v1_2_y = c2 * k_L1;
        [v1_2_x, v1_2_y]
    };
    // payload: column M
    {
        let t34 = s4 * t21 - c4 * a4_y;
        let t35 = k_L2 * t34;
        let t39 = t35 + (v1_2_y * t34 - v1_2_x * (c4 * t21 + s4 * a4_y));
        put(0, t39); // row 1, M
        put(4, t35); // row 2, M
    }
    // payload: column MSX
    let [t42, t45] = {
        let t42 = c4 * t25 + s4 * dw4_z;
        let t45 = s4 * t25 - c4 * dw4_z;
        let t47 = k_L2 * t45 - a4_y;
        let t51 = t47 + (v1_2_y * t45 - v1_2_x * t42);
        put(1, t51); // row 1, MSX
        put(5, t47); // row 2, MSX
        [t42, t45]
    };
    // payload: column MSY
    {
        let t53 = k_L2 * t42 - t21;
        let t57 = t53 + (v1_2_y * t42 + v1_2_x * t45);
        put(2, t57); // row 1, MSY
        put(6, t53); // row 2, MSY
    }
}
