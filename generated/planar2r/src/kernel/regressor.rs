//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil
//! and Dombre, 12.4.
//!
//! 18 multiplications, 12 additions; 2 x 24, 14 of 48 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 14;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 1), (0, 2), (0, 6), (0, 10), (0, 11), (0, 12), (0, 16), (0, 20), (0, 22), (1, 11),
    (1, 12), (1, 16), (1, 21), (1, 23),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 24 + PATTERN[k].1
}

/// Regressor `W` of the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 24]; 2]) {
    let flat = &mut out.as_flattened_mut()[..];
    flat[0] = S::default();
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            1 => clear(&mut flat[3..6]),
            2 => clear(&mut flat[7..10]),
            5 => clear(&mut flat[13..16]),
            6 => clear(&mut flat[17..20]),
            7 => flat[21] = S::default(),
            8 => clear(&mut flat[23..35]),
            10 => clear(&mut flat[37..40]),
            11 => clear(&mut flat[41..45]),
            12 => flat[46] = S::default(),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 24]; 2]) {
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
    // link 1: motion
    let [a1_x, a1_y, t2] = {
        let a1_x = s1 * k0;
        let a1_y = c1 * k0;
        let t2 = dq1 * dq1;
        let t3 = -a1_x;
        put(0, a1_y); // row 1, MSX1
        put(1, t3); // row 1, MSY1
        put(2, ddq1); // row 1, ZZ1
        put(7, dq1); // row 1, FV1
        put(12, dq2); // row 2, FV2
        [a1_x, a1_y, t2]
    };
    // link 2: motion
    let [dw2_z, t12, a2_y, t16] = {
        let w2_z = dq1 + dq2;
        let dw2_z = ddq1 + ddq2;
        let t8 = k_L1 * t2 - a1_x;
        let t9 = a1_y + k_L1 * ddq1;
        let t12 = c2 * t8 - s2 * t9;
        let a2_y = c2 * t9 + s2 * t8;
        let t16 = w2_z * w2_z;
        put(6, dw2_z); // row 1, ZZ2
        put(9, a2_y); // row 2, MSX2
        put(10, t12); // row 2, MSY2
        put(11, dw2_z); // row 2, ZZ2
        [dw2_z, t12, a2_y, t16]
    };
    // joint axes in frame 2
    let [v1_2_x, v1_2_y] = {
        let v1_2_x = s2 * k_L1;
        let v1_2_y = c2 * k_L1;
        [v1_2_x, v1_2_y]
    };
    // M2: column
    {
        let t21 = a2_y * v1_2_y - t12 * v1_2_x;
        put(3, t21); // row 1, M2
    }
    // MSX2: column
    {
        let t25 = a2_y - (t16 * v1_2_x - dw2_z * v1_2_y);
        put(4, t25); // row 1, MSX2
    }
    // MSY2: column
    {
        let t29 = t12 - (dw2_z * v1_2_x + t16 * v1_2_y);
        put(5, t29); // row 1, MSY2
    }
    // YZ2: column
    {
        let t30 = dq1.sign();
        let t31 = dq2.sign();
        put(8, t30); // row 1, FC1
        put(13, t31); // row 2, FC2
    }
}
