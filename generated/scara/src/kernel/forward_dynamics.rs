//! Accelerations under given torques.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` in
//! closed form.
//!
//! 72 multiplications, 50 additions; 4, 4 of 4 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, GRAVITY, Trig, constants};

/// Accelerations under given torques: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE], out: &mut [S; 4]) {
    entries(trig, dq, tau, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4] = trig.sin;
    let [_, c2, _, c4] = trig.cos;
    let [dq1, dq2, _, dq4] = *dq;
    let [tau1, tau2, tau3, tau4] = *tau;
    let [ZZ1R, MSX2R, MSY2R, ZZ2R, M3R, MSX4, MSY4, ZZ4, ..] = *beta;
    let k2 = S::constant(-GRAVITY[2]);
    let k3 = S::constant(1.0);
    let k_L1 = S::constant(constants::L1);
    let k_L2 = S::constant(constants::L2);
    // composite body 4
    let [t2, t5, t7, t12] = {
        let t2 = c4 * MSY4 + s4 * MSX4;
        let t5 = c4 * MSX4 - s4 * MSY4;
        let t7 = ZZ4 + k_L2 * t5;
        let t12 = t7 + k_L1 * (s2 * t2 + c2 * t5);
        [t2, t5, t7, t12]
    };
    // composite body 3
    let [t14, t15, t22] = {
        let t14 = t5 + k_L2 * M3R;
        let t15 = k_L1 * M3R;
        let t19 = q3 * (q3 * M3R);
        let t22 = ZZ4 + (k_L2 * (t5 + t14) + t19) - t19;
        [t14, t15, t22]
    };
    // composite body 2
    let [t25, t30, t34] = {
        let t25 = ZZ2R + t22;
        let t28 = c2 * (MSX2R + t14) - s2 * (MSY2R - t2);
        let t30 = t25 + k_L1 * t28;
        let t34 = t25 + k_L1 * (t28 + (t15 + t28));
        [t25, t30, t34]
    };
    // composite body 1
    let t35 = {
        let t35 = ZZ1R + t34;
        t35
    };
    // link 1: motion
    let t36 = {
        let t36 = dq1 * dq1;
        t36
    };
    // link 2: motion
    let [w2_z, t39, a2_y, t41] = {
        let w2_z = dq1 + dq2;
        let t38 = k_L1 * t36;
        let t39 = c2 * t38;
        let a2_y = s2 * t38;
        let t41 = w2_z * w2_z;
        [w2_z, t39, a2_y, t41]
    };
    // link 3: motion
    let t43 = {
        let t43 = t39 + k_L2 * t41;
        t43
    };
    // link 4: motion
    let [t47, a4_y, t51] = {
        let w4_z = dq4 - w2_z;
        let t47 = c4 * t43 + s4 * a2_y;
        let a4_y = s4 * t43 - c4 * a2_y;
        let t51 = w4_z * w4_z;
        [t47, a4_y, t51]
    };
    // link 4: force and moment
    let [n4_z, t59, t62] = {
        let t52 = MSX4 * t51;
        let t53 = MSY4 * t51;
        let n4_z = MSX4 * a4_y + MSY4 * t47;
        let t59 = s4 * t53 - c4 * t52;
        let t62 = s4 * t52 + c4 * t53;
        [n4_z, t59, t62]
    };
    // link 3: force and moment
    let [f2_z, f3_x, t67, t69] = {
        let f2_z = k2 * M3R;
        let f3_x = t59 - M3R * t43;
        let t67 = t62 + M3R * a2_y;
        let t69 = n4_z - k_L2 * t67;
        [f2_z, f3_x, t67, t69]
    };
    // link 2: force and moment
    let [n2_z, n1_z] = {
        let f2_x = f3_x - MSX2R * t41;
        let f2_y = t67 - MSY2R * t41;
        let n2_z = MSX2R * a2_y + MSY2R * t39 - t69;
        let f1_y = s2 * f2_x + c2 * f2_y;
        let n1_z = n2_z + k_L1 * f1_y;
        [n2_z, n1_z]
    };
    // drives
    let [t83, t84, t85, t86] = {
        let t83 = tau1 - n1_z;
        let t84 = tau2 - n2_z;
        let t85 = f2_z + tau3;
        let t86 = tau4 - n4_z;
        [t83, t84, t85, t86]
    };
    // M = L D L'
    let [t87, t88, t89, t93, t97, t98, t105] = {
        let t87 = k3 / t35;
        let t88 = t30 * t87;
        let t89 = t12 * t87;
        let t92 = t25 - t35 * (t88 * t88);
        let t93 = k3 / t92;
        let t97 = t93 * (t89 * (t35 * t88) - t7);
        let t98 = k3 / M3R;
        let t105 = k3 / (ZZ4 - t35 * (t89 * t89) - t92 * (t97 * t97));
        [t87, t88, t89, t93, t97, t98, t105]
    };
    // ddq
    {
        let t107 = t84 - t83 * t88;
        let t114 = t85 * t98;
        let t115 = t105 * (t86 + t83 * t89 - t97 * t107);
        let t117 = t93 * t107 - t97 * t115;
        let t121 = t83 * t87 - t88 * t117 + t89 * t115;
        put(0, t121);
        put(1, t117);
        put(2, t114);
        put(3, t115);
    }
}
