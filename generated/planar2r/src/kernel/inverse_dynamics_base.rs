//! Torques from the base parameters.
//!
//! `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil
//! and Dombre, 9.6.
//!
//! 27 multiplications, 19 additions; 2, 2 of 2 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, GRAVITY, Trig, constants};

/// Torques from the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE], out: &mut [S; 2]) {
    entries(trig, dq, ddq, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [s1, s2] = trig.sin;
    let [c1, c2] = trig.cos;
    let [dq1, dq2] = *dq;
    let [ddq1, ddq2] = *ddq;
    let [MSX1R, MSY1, ZZ1R, MSX2, MSY2, ZZ2, FV1, FV2, FC1, FC2, ..] = *beta;
    let k0 = S::constant(-GRAVITY[1]);
    let k_L1 = S::constant(constants::L1);
    // link 1: motion
    let [a1_x, a1_y, t2] = {
        let a1_x = s1 * k0;
        let a1_y = c1 * k0;
        let t2 = dq1 * dq1;
        [a1_x, a1_y, t2]
    };
    // link 2: motion
    let [dw2_z, a2_x, a2_y, t15] = {
        let w2_z = dq1 + dq2;
        let dw2_z = ddq1 + ddq2;
        let t7 = a1_x - k_L1 * t2;
        let t8 = a1_y + k_L1 * ddq1;
        let a2_x = c2 * t7 + s2 * t8;
        let a2_y = c2 * t8 - s2 * t7;
        let t15 = w2_z * w2_z;
        [dw2_z, a2_x, a2_y, t15]
    };
    // link 2: force and moment
    let [n2_z, t31] = {
        let f2_y = MSX2 * dw2_z - MSY2 * t15;
        let n2_z = ZZ2 * dw2_z + (MSX2 * a2_y - MSY2 * a2_x);
        let t31 = n2_z + k_L1 * (c2 * f2_y - s2 * (MSX2 * t15 + MSY2 * dw2_z));
        [n2_z, t31]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t31 + (ZZ1R * ddq1 + (MSX1R * a1_y - MSY1 * a1_x));
        n1_z
    };
    // drives
    {
        let t44 = n1_z + FV1 * dq1 + FC1 * dq1.sign();
        let t47 = n2_z + FV2 * dq2 + FC2 * dq2.sign();
        put(0, t44);
        put(1, t47);
    }
}
