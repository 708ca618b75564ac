//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil
//! and Dombre, 12.4.
//!
//! 43 multiplications, 35 additions; 4 x 40, 29 of 160 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 29;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 6), (0, 10), (0, 11), (0, 12), (0, 16), (0, 20), (0, 21), (0, 22), (0, 26), (0, 30),
    (0, 31), (0, 32), (0, 36), (1, 11), (1, 12), (1, 16), (1, 20), (1, 21), (1, 22), (1, 26),
    (1, 30), (1, 31), (1, 32), (1, 36), (2, 20), (2, 30), (3, 31), (3, 32), (3, 36),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 40 + PATTERN[k].1
}

/// Regressor `W` of the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 40]; 4]) {
    let flat = &mut out.as_flattened_mut()[..];
    clear(&mut flat[0..6]);
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[7..10]),
            3 => clear(&mut flat[13..16]),
            4 => clear(&mut flat[17..20]),
            7 => clear(&mut flat[23..26]),
            8 => clear(&mut flat[27..30]),
            11 => clear(&mut flat[33..36]),
            12 => clear(&mut flat[37..51]),
            14 => clear(&mut flat[53..56]),
            15 => clear(&mut flat[57..60]),
            18 => clear(&mut flat[63..66]),
            19 => clear(&mut flat[67..70]),
            22 => clear(&mut flat[73..76]),
            23 => clear(&mut flat[77..100]),
            24 => clear(&mut flat[101..110]),
            25 => clear(&mut flat[111..151]),
            27 => clear(&mut flat[153..156]),
            28 => clear(&mut flat[157..160]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 40]; 4]) {
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
        put(0, ddq1); // row 1, ZZ1
        t0
    };
    // link 2: motion
    let [w2_z, dw2_z, a2_x, a2_y, t11] = {
        let w2_z = dq1 + dq2;
        let dw2_z = ddq1 + ddq2;
        let t3 = k_L1 * t0;
        let t4 = k_L1 * ddq1;
        let a2_x = s2 * t4 - c2 * t3;
        let a2_y = c2 * t4 + s2 * t3;
        let t11 = w2_z * w2_z;
        let t12 = -a2_x;
        put(4, dw2_z); // row 1, ZZ2
        put(8, dw2_z); // row 1, ZZ3
        put(13, a2_y); // row 2, MSX2
        put(14, t12); // row 2, MSY2
        put(15, dw2_z); // row 2, ZZ2
        put(18, a2_x); // row 2, MSY3
        put(19, dw2_z); // row 2, ZZ3
        [w2_z, dw2_z, a2_x, a2_y, t11]
    };
    // link 3: motion
    let [t14, t15, t16] = {
        let t14 = k_L2 * dw2_z;
        let t15 = k_L2 * t11 - a2_x;
        let t16 = a2_y + t14;
        let a3_z = ddq3 + k2;
        put(24, a3_z); // row 3, M3
        put(25, a3_z); // row 3, M4
        [t14, t15, t16]
    };
    // link 4: motion
    let [t19, t22, a4_y, t26] = {
        let w4_z = dq4 - w2_z;
        let t19 = dw2_z - ddq4;
        let t22 = c4 * t15 + s4 * t16;
        let a4_y = s4 * t15 - c4 * t16;
        let t26 = w4_z * w4_z;
        let t27 = -t19;
        put(12, t19); // row 1, ZZ4
        put(23, t19); // row 2, ZZ4
        put(26, a4_y); // row 4, MSX4
        put(27, t22); // row 4, MSY4
        put(28, t27); // row 4, ZZ4
        [t19, t22, a4_y, t26]
    };
    // joint axes in frame 2
    let [v1_2_x, v1_2_y] = {
        let v1_2_x = s2 * k_L1;
        let v1_2_y = c2 * k_L1;
        [v1_2_x, v1_2_y]
    };
    // M2: column
    {
        let t32 = a2_y * v1_2_y + a2_x * v1_2_x;
        put(1, t32); // row 1, M2
    }
    // MSX2: column
    let t35 = {
        let t35 = t11 * v1_2_x - dw2_z * v1_2_y;
        let t36 = a2_y - t35;
        put(2, t36); // row 1, MSX2
        t35
    };
    // MSY2: column
    {
        let t40 = a2_x + (t11 * v1_2_y + dw2_z * v1_2_x);
        let t41 = -t40;
        put(3, t41); // row 1, MSY2
        put(7, t40); // row 1, MSY3
    }
    // M3: column
    {
        let t42 = k_L2 * t16;
        let t46 = t42 - (t15 * v1_2_x - t16 * v1_2_y);
        put(5, t46); // row 1, M3
        put(16, t42); // row 2, M3
    }
    // MSX3: column
    {
        let t47 = t14 + t16;
        let t48 = t47 - t35;
        put(6, t48); // row 1, MSX3
        put(17, t47); // row 2, MSX3
    }
    // M4: column
    {
        let t54 = s4 * t22 - c4 * a4_y;
        let t55 = k_L2 * t54;
        let t59 = t55 + (v1_2_y * t54 - v1_2_x * (c4 * t22 + s4 * a4_y));
        put(9, t59); // row 1, M4
        put(20, t55); // row 2, M4
    }
    // MSX4: column
    let [t62, t65] = {
        let t62 = c4 * t26 - s4 * t19;
        let t65 = s4 * t26 + c4 * t19;
        let t67 = k_L2 * t65 - a4_y;
        let t71 = t67 + (v1_2_y * t65 - v1_2_x * t62);
        put(10, t71); // row 1, MSX4
        put(21, t67); // row 2, MSX4
        [t62, t65]
    };
    // MSY4: column
    {
        let t73 = k_L2 * t62 - t22;
        let t77 = t73 + (v1_2_y * t62 + v1_2_x * t65);
        put(11, t77); // row 1, MSY4
        put(22, t73); // row 2, MSY4
    }
}
