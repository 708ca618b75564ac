//! Torques from the standard parameters.
//!
//! `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil
//! and Dombre, 9.5.2.
//!
//! 52 multiplications, 42 additions; 4, 4 of 4 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, STANDARD, GRAVITY, Trig, constants};

/// Torques from the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], out: &mut [S; 4]) {
    entries(trig, dq, ddq, phi, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], mut put: impl FnMut(usize, S)) {
    let [_, s2, _, s4] = trig.sin;
    let [_, c2, _, c4] = trig.cos;
    let [dq1, dq2, _, dq4] = *dq;
    let [ddq1, ddq2, ddq3, ddq4] = *ddq;
    let [
        _, _, _, _, _, _, ZZ1, _, _, _, M2, MSX2,
        MSY2, _, _, _, ZZ2, _, _, _, M3, MSX3, MSY3, _,
        _, _, ZZ3, _, _, _, M4, MSX4, MSY4, _, _, _,
        ZZ4,
        ..] = *phi;
    let k2 = S::constant(GRAVITY[2]);
    let k_L1 = S::constant(constants::L1);
    let k_L2 = S::constant(constants::L2);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
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
        [w2_z, dw2_z, a2_x, a2_y, t11]
    };
    // link 3: motion
    let [a3_x, t15, a3_z] = {
        let a3_x = a2_x - k_L2 * t11;
        let t15 = a2_y + k_L2 * dw2_z;
        let a3_z = ddq3 + k2;
        [a3_x, t15, a3_z]
    };
    // link 4: motion
    let [dw4_z, a4_x, t24, t25] = {
        let w4_z = dq4 - w2_z;
        let dw4_z = ddq4 - dw2_z;
        let a4_x = c4 * a3_x - s4 * t15;
        let t24 = c4 * t15 + s4 * a3_x;
        let t25 = w4_z * w4_z;
        [dw4_z, a4_x, t24, t25]
    };
    // link 4: force and moment
    let [n4_z, t43, t46] = {
        let f4_x = M4 * a4_x - (MSX4 * t25 + MSY4 * dw4_z);
        let f4_y = MSX4 * dw4_z - MSY4 * t25 - M4 * t24;
        let n4_z = ZZ4 * dw4_z - (MSX4 * t24 + MSY4 * a4_x);
        let t43 = c4 * f4_x - s4 * f4_y;
        let t46 = s4 * f4_x + c4 * f4_y;
        put(3, n4_z);
        [n4_z, t43, t46]
    };
    // link 3: force and moment
    let [f3_x, f3_y, t68] = {
        let f3_x = t43 + (M3 * a3_x + (MSY3 * dw2_z - MSX3 * t11));
        let f3_y = t46 - (M3 * t15 + (MSX3 * dw2_z + MSY3 * t11));
        let f3_z = a3_z * (M3 + M4);
        let n3_z = n4_z - (ZZ3 * dw2_z + (MSX3 * t15 + MSY3 * a3_x));
        let t68 = n3_z + k_L2 * f3_y;
        put(2, f3_z);
        [f3_x, f3_y, t68]
    };
    // link 2: force and moment
    let t91 = {
        let f2_x = f3_x + (M2 * a2_x - (MSX2 * t11 + MSY2 * dw2_z));
        let f2_y = M2 * a2_y + (MSX2 * dw2_z - MSY2 * t11) - f3_y;
        let n2_z = ZZ2 * dw2_z + (MSX2 * a2_y - MSY2 * a2_x) - t68;
        let t91 = n2_z + k_L1 * (s2 * f2_x + c2 * f2_y);
        put(1, n2_z);
        t91
    };
    // link 1: force and moment
    {
        let n1_z = t91 + ZZ1 * ddq1;
        put(0, n1_z);
    }
}
