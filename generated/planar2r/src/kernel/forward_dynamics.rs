//! Accelerations under given torques.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` in
//! closed form.
//!
//! 35 multiplications, 23 additions; 2, 2 of 2 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, GRAVITY, Trig, constants};

/// Accelerations under given torques: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE], out: &mut [S; 2]) {
    entries(trig, dq, tau, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [s1, s2] = trig.sin;
    let [c1, c2] = trig.cos;
    let [dq1, dq2] = *dq;
    let [tau1, tau2] = *tau;
    let [MSX1R, MSY1, ZZ1R, MSX2, MSY2, ZZ2, FV1, FV2, FC1, FC2, ..] = *beta;
    let k1 = S::constant(-GRAVITY[1]);
    let k2 = S::constant(1.0);
    let k_L1 = S::constant(constants::L1);
    // composite body 2
    let [t4, t7] = {
        let t2 = c2 * MSX2 - s2 * MSY2;
        let t4 = ZZ2 + k_L1 * t2;
        let t7 = ZZ2 + k_L1 * (t2 + t2);
        [t4, t7]
    };
    // composite body 1
    let t8 = {
        let t8 = ZZ1R + t7;
        t8
    };
    // link 1: motion
    let [a1_x, a1_y, t11] = {
        let a1_x = s1 * k1;
        let a1_y = c1 * k1;
        let t11 = dq1 * dq1;
        [a1_x, a1_y, t11]
    };
    // link 2: motion
    let [a2_x, a2_y, t21] = {
        let w2_z = dq1 + dq2;
        let t14 = a1_x - k_L1 * t11;
        let a2_x = c2 * t14 + s2 * a1_y;
        let a2_y = c2 * a1_y - s2 * t14;
        let t21 = w2_z * w2_z;
        [a2_x, a2_y, t21]
    };
    // link 2: force and moment
    let [n2_z, t31] = {
        let n2_z = MSX2 * a2_y - MSY2 * a2_x;
        let t31 = n2_z - k_L1 * (s2 * (MSX2 * t21) + c2 * (MSY2 * t21));
        [n2_z, t31]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t31 + (MSX1R * a1_y - MSY1 * a1_x);
        n1_z
    };
    // drives
    let [t46, t47] = {
        let t46 = tau1 - (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t47 = tau2 - (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        [t46, t47]
    };
    // M = L D L'
    let [t48, t49, t53] = {
        let t48 = k2 / t8;
        let t49 = t4 * t48;
        let t53 = k2 / (ZZ2 - t8 * (t49 * t49));
        [t48, t49, t53]
    };
    // ddq
    {
        let t57 = t53 * (t47 - t46 * t49);
        let t59 = t46 * t48 - t49 * t57;
        put(0, t59);
        put(1, t57);
    }
}
