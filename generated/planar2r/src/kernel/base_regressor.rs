//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil
//! and Dombre, 12.4.
//!
//! 16 multiplications, 11 additions; 2 x 10, 13 of 20 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 13;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 8), (1, 3), (1, 4),
    (1, 5), (1, 7), (1, 9),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 10 + PATTERN[k].1
}

/// Regressor `W_b` of the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 10]; 2]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            6 => flat[7] = S::default(),
            7 => clear(&mut flat[9..13]),
            10 => flat[16] = S::default(),
            11 => flat[18] = S::default(),
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
    // link 1: motion
    let [a1_x, a1_y, t2] = {
        let a1_x = s1 * k0;
        let a1_y = c1 * k0;
        let t2 = dq1 * dq1;
        let t3 = -a1_x;
        put(0, a1_y); // row 1, MSX1R
        put(1, t3); // row 1, MSY1
        put(2, ddq1); // row 1, ZZ1R
        put(6, dq1); // row 1, FV1
        put(11, dq2); // row 2, FV2
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
        put(5, dw2_z); // row 1, ZZ2
        put(8, a2_y); // row 2, MSX2
        put(9, t12); // row 2, MSY2
        put(10, dw2_z); // row 2, ZZ2
        [dw2_z, t12, a2_y, t16]
    };
    // joint axes in frame 2
    let [v1_2_x, v1_2_y] = {
        let v1_2_x = s2 * k_L1;
        let v1_2_y = c2 * k_L1;
        [v1_2_x, v1_2_y]
    };
    // MSX2: column
    {
        let t22 = a2_y + (dw2_z * v1_2_y - t16 * v1_2_x);
        put(3, t22); // row 1, MSX2
    }
    // MSY2: column
    {
        let t26 = t12 - (dw2_z * v1_2_x + t16 * v1_2_y);
        put(4, t26); // row 1, MSY2
    }
    // ZZ2: column
    {
        let t27 = dq1.sign();
        let t28 = dq2.sign();
        put(7, t27); // row 1, FC1
        put(12, t28); // row 2, FC2
    }
}
