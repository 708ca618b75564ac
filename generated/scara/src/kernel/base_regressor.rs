//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil
//! and Dombre, 12.4.
//!
//! 34 multiplications, 26 additions; 4 x 8, 19 of 32 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 19;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (1, 1), (1, 2),
    (1, 3), (1, 4), (1, 5), (1, 6), (1, 7), (2, 4), (3, 5), (3, 6), (3, 7),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 8 + PATTERN[k].1
}

/// Regressor `W_b` of the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 8]; 4]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            7 => flat[8] = S::default(),
            14 => clear(&mut flat[16..20]),
            15 => clear(&mut flat[21..29]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 8]; 4]) {
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
        put(0, ddq1); // row 1, ZZ1R
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
        put(3, dw2_z); // row 1, ZZ2R
        put(8, a2_y); // row 2, MSX2R
        put(9, t7); // row 2, MSY2R
        put(10, dw2_z); // row 2, ZZ2R
        [w2_z, dw2_z, t7, a2_y, t11]
    };
    // link 3: motion
    let [t14, t15] = {
        let t14 = t7 + k_L2 * t11;
        let t15 = a2_y + k_L2 * dw2_z;
        let a3_z = ddq3 + k2;
        put(15, a3_z); // row 3, M3R
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
        put(7, t26); // row 1, ZZ4
        put(14, t26); // row 2, ZZ4
        put(16, a4_y); // row 4, MSX4
        put(17, t21); // row 4, MSY4
        put(18, dw4_z); // row 4, ZZ4
        [dw4_z, t21, a4_y, t25]
    };
    // joint axes in frame 2
    let [v1_2_x, v1_2_y] = {
        let v1_2_x = s2 * k_L1;
        let v1_2_y = c2 * k_L1;
        [v1_2_x, v1_2_y]
    };
    // MSX2: column
    {
        let t32 = a2_y + (dw2_z * v1_2_y - t11 * v1_2_x);
        put(1, t32); // row 1, MSX2R
    }
    // MSY2: column
    {
        let t36 = t7 - (t11 * v1_2_y + dw2_z * v1_2_x);
        put(2, t36); // row 1, MSY2R
    }
    // M3: column
    {
        let t37 = k_L2 * t15;
        let t41 = t37 + (t15 * v1_2_y - t14 * v1_2_x);
        put(4, t41); // row 1, M3R
        put(11, t37); // row 2, M3R
    }
    // MSX4: column
    let [t44, t47] = {
        let t44 = c4 * t25 + s4 * dw4_z;
        let t47 = s4 * t25 - c4 * dw4_z;
        let t49 = k_L2 * t47 - a4_y;
        let t53 = t49 + (v1_2_y * t47 - v1_2_x * t44);
        put(5, t53); // row 1, MSX4
        put(12, t49); // row 2, MSX4
        [t44, t47]
    };
    // MSY4: column
    {
        let t55 = k_L2 * t44 - t21;
        let t59 = t55 + (v1_2_y * t44 + v1_2_x * t47);
        put(6, t59); // row 1, MSY4
        put(13, t55); // row 2, MSY4
    }
}
