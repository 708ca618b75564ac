//! Acceleration of the last DH frame at zero `ddq`: `dJ/dt dq`.
//!
//! In world axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
//!
//! 120 multiplications, 68 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig, constants};

/// Acceleration of the last DH frame at zero `ddq`: `dJ/dt dq`: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 6]) {
    entries(trig, dq, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], mut put: impl FnMut(usize, S)) {
    let [_, _, q3, ..] = trig.q;
    let [s1, s2, _, s4, s5, s6] = trig.sin;
    let [c1, c2, _, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let k1 = S::constant(2.0);
    let k_D2 = S::constant(constants::D2);
    let k_D6 = S::constant(constants::D6);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [t1, t2, w3_z, t6, dw2_y, t9, t10] = {
        let t1 = k_D2 * t0;
        let t2 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t6 = t2 * w3_z;
        let dw2_y = dq2 * t2;
        let t8 = dq2 * w3_z;
        let t9 = t2 * t2 + dq2 * dq2;
        let t10 = t8 + t8;
        [t1, t2, w3_z, t6, dw2_y, t9, t10]
    };
    // link 3: motion
    let [t12, t18, a3_y] = {
        let t12 = q3 * t9;
        let t15 = dq3 * k1;
        let t18 = q3 * t10 - t1 + t2 * t15;
        let a3_y = dq2 * t15 - q3 * t6;
        [t12, t18, a3_y]
    };
    // link 4: motion
    let [
        t20, t21, a4_x, a4_y, t30, w4_y, w4_z, dw4_y,
        t46, t47,
    ] = {
        let t20 = s2 * s4;
        let t21 = s2 * c4;
        let a4_x = s4 * a3_y - c4 * t18;
        let a4_y = c4 * a3_y + s4 * t18;
        let t30 = c4 * dq2 + s4 * t2;
        let w4_y = s4 * dq2 - c4 * t2;
        let w4_z = w3_z + dq4;
        let t43 = w4_y * w4_z;
        let dw4_x = t43 - (s4 * t10 - c4 * t6);
        let dw4_y = t30 * w4_z - (c4 * t10 + s4 * t6);
        let t46 = dw2_y - t30 * w4_y;
        let t47 = t43 + dw4_x;
        [
        t20, t21, a4_x, a4_y, t30, w4_y, w4_z, dw4_y,
        t46, t47,
    ]
    };
    // link 5: motion
    let [
        a5_x, a5_y, t56, w5_y, w5_z, dw5_y, t74, t75,
        t76,
    ] = {
        let a5_x = c5 * a4_x + s5 * t12;
        let a5_y = c5 * t12 - s5 * a4_x;
        let t56 = c5 * t30 + s5 * w4_z;
        let w5_y = s5 * t30 - c5 * w4_z;
        let w5_z = w4_y + dq5;
        let t71 = w5_y * w5_z;
        let dw5_x = c5 * t47 + s5 * t46 + t71;
        let dw5_y = c5 * t46 - s5 * t47 + t56 * w5_z;
        let t74 = dw4_y + t56 * w5_y;
        let t75 = t56 * t56 + w5_z * w5_z;
        let t76 = t71 + dw5_x;
        [
        a5_x, a5_y, t56, w5_y, w5_z, dw5_y, t74, t75,
        t76,
    ]
    };
    // link 6: motion
    let [t81, a6_x, a6_y, dw6_x, dw6_y] = {
        let t80 = a5_x + k_D6 * t74;
        let t81 = a5_y + k_D6 * t75;
        let t82 = a4_y - k_D6 * t76;
        let a6_x = c6 * t80 + s6 * t82;
        let a6_y = c6 * t82 - s6 * t80;
        let w6_x = s6 * w5_z - c6 * t56;
        let w6_y = c6 * w5_z + s6 * t56;
        let w6_z = dq6 - w5_y;
        let dw6_x = c6 * t76 + s6 * t74 + w6_y * w6_z;
        let dw6_y = c6 * t74 - s6 * t76 - w6_x * w6_z;
        [t81, a6_x, a6_y, dw6_x, dw6_y]
    };
    // frame 2
    let [t106, t107, t108, t109] = {
        let t106 = c1 * c2;
        let t107 = c1 * s2;
        let t108 = s1 * c2;
        let t109 = s1 * s2;
        [t106, t107, t108, t109]
    };
    // frame 4
    let [t112, t115, t118, t121] = {
        let t112 = s1 * c4 + s4 * t106;
        let t115 = c4 * t106 - s1 * s4;
        let t118 = s4 * t108 - c1 * c4;
        let t121 = c4 * t108 + c1 * s4;
        [t112, t115, t118, t121]
    };
    // frame 5
    let [t124, t127, t130, t133, t136, t139] = {
        let t124 = c5 * t112 - s5 * t107;
        let t127 = c5 * t107 + s5 * t112;
        let t130 = c5 * t118 - s5 * t109;
        let t133 = c5 * t109 + s5 * t118;
        let t136 = c5 * t20 + c2 * s5;
        let t139 = s5 * t20 - c2 * c5;
        [t124, t127, t130, t133, t136, t139]
    };
    // frame 6
    let [t142, t145, t148, t151, t154, t157] = {
        let t142 = c6 * t124 + s6 * t115;
        let t145 = c6 * t115 - s6 * t124;
        let t148 = c6 * t130 + s6 * t121;
        let t151 = c6 * t121 - s6 * t130;
        let t154 = c6 * t136 + s6 * t21;
        let t157 = s6 * t136 - c6 * t21;
        [t142, t145, t148, t151, t154, t157]
    };
    // in world axes
    {
        let t162 = a6_x * t142 + a6_y * t145 - t81 * t127;
        let t167 = a6_x * t148 + a6_y * t151 - t81 * t133;
        let t172 = t81 * t139 + (a6_y * t157 - a6_x * t154);
        let t177 = dw6_x * t142 + dw6_y * t145 - dw5_y * t127;
        let t182 = dw6_x * t148 + dw6_y * t151 - dw5_y * t133;
        let t187 = dw5_y * t139 + (dw6_y * t157 - dw6_x * t154);
        put(0, t162);
        put(1, t167);
        put(2, t172);
        put(3, t177);
        put(4, t182);
        put(5, t187);
    }
}
