//! Acceleration of the last DH frame at zero `ddq`: `dJ/dt dq`.
//!
//! In world axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
//!
//! 140 multiplications, 79 additions; 6, 6 of 6 structurally nonzero.

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
    let [s1, s2, s3, s4, s5, s6] = trig.sin;
    let [c1, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let k0 = S::constant(-constants::A2);
    let k1 = S::constant(-constants::A3);
    let k_D4 = S::constant(constants::D4);
    let k_D5 = S::constant(constants::D5);
    let k_D6 = S::constant(constants::D6);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [t5, t8, t9] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t5 = w2_x * w2_y;
        let t6 = dq2 * w2_x;
        let t8 = w2_x * w2_x - dq2 * dq2 - t0;
        let t9 = t6 + t6;
        [t5, t8, t9]
    };
    // link 3: motion
    let [
        t12, t15, w3_z, t19, t22, a3_y, t30, t33,
        t34,
    ] = {
        let t12 = s2 * c3 + c2 * s3;
        let t15 = c2 * c3 - s2 * s3;
        let w3_z = dq2 + dq3;
        let t17 = t8 * k0;
        let t18 = t5 * k0;
        let t19 = t9 * k0;
        let t22 = c3 * t17 + s3 * t18;
        let a3_y = s3 * t17 - c3 * t18;
        let w3_x = dq1 * t12;
        let w3_y = dq1 * t15;
        let t30 = w3_x * w3_y;
        let t31 = w3_z * w3_x;
        let t33 = w3_x * w3_x - w3_z * w3_z - t0;
        let t34 = t31 + t31;
        [
        t12, t15, w3_z, t19, t22, a3_y, t30, t33,
        t34,
    ]
    };
    // link 4: motion
    let [
        t37, t40, w4_z, a4_x, a4_y, t55, w4_x, w4_y,
        t60, dw5_z, t63, t64,
    ] = {
        let t37 = c4 * t12 + s4 * t15;
        let t40 = c4 * t15 - s4 * t12;
        let w4_z = w3_z + dq4;
        let t45 = t22 + t33 * k1;
        let t46 = a3_y - t30 * k1;
        let a4_x = s4 * t46 - c4 * t45;
        let a4_y = c4 * t46 + s4 * t45;
        let t55 = t19 + (t34 * k1 + k_D4 * t0);
        let w4_x = dq1 * t37;
        let w4_y = dq1 * t40;
        let t60 = w4_x * w4_y;
        let dw5_z = w4_z * w4_x;
        let dw4_x = w4_z * w4_y;
        let t63 = w4_x * w4_x + w4_z * w4_z;
        let t64 = dw4_x + dw4_x;
        [
        t37, t40, w4_z, a4_x, a4_y, t55, w4_x, w4_y,
        t60, dw5_z, t63, t64,
    ]
    };
    // link 5: motion
    let [
        t65, t66, t71, a5_x, t78, w5_x, w5_y, w5_z,
        t98, t99, t100, t101,
    ] = {
        let t65 = c5 * t37;
        let t66 = s5 * t37;
        let t70 = a4_x - k_D5 * t60;
        let t71 = a4_y + k_D5 * t63;
        let t72 = t55 + k_D5 * t64;
        let a5_x = c5 * t70 - s5 * t72;
        let t78 = c5 * t72 + s5 * t70;
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let w5_z = dq5 - w4_y;
        let t96 = w5_y * w5_z;
        let dw5_x = t96 - (s5 * t60 - c5 * t64);
        let t98 = c5 * t60 + s5 * t64 + w5_x * w5_z;
        let t99 = w5_x * w5_y - dw5_z;
        let t100 = w5_x * w5_x + w5_z * w5_z;
        let t101 = t96 + dw5_x;
        [
        t65, t66, t71, a5_x, t78, w5_x, w5_y, w5_z,
        t98, t99, t100, t101,
    ]
    };
    // link 6: motion
    let [t106, a6_x, t113, dw6_x, dw6_y] = {
        let t105 = a5_x + k_D6 * t99;
        let t106 = t78 + k_D6 * t100;
        let t107 = k_D6 * t101 - t71;
        let a6_x = c6 * t105 - s6 * t107;
        let t113 = c6 * t107 + s6 * t105;
        let w6_x = c6 * w5_x - s6 * w5_z;
        let w6_z = w5_y + dq6;
        let dw6_x = c6 * t101 + s6 * t99 - (c6 * w5_z + s6 * w5_x) * w6_z;
        let dw6_y = c6 * t99 - s6 * t101 - w6_x * w6_z;
        [t106, a6_x, t113, dw6_x, dw6_y]
    };
    // frame 2
    let [t131, t132, t133, t134] = {
        let t131 = c1 * c2;
        let t132 = c1 * s2;
        let t133 = s1 * c2;
        let t134 = s1 * s2;
        [t131, t132, t133, t134]
    };
    // frame 3
    let [t137, t140, t143, t146] = {
        let t137 = c3 * t131 - s3 * t132;
        let t140 = c3 * t132 + s3 * t131;
        let t143 = c3 * t133 - s3 * t134;
        let t146 = c3 * t134 + s3 * t133;
        [t137, t140, t143, t146]
    };
    // frame 4
    let [t149, t152, t155, t158] = {
        let t149 = c4 * t137 - s4 * t140;
        let t152 = c4 * t140 + s4 * t137;
        let t155 = c4 * t143 - s4 * t146;
        let t158 = c4 * t146 + s4 * t143;
        [t149, t152, t155, t158]
    };
    // frame 5
    let [t161, t164, t167, t170] = {
        let t161 = c5 * t149 + s1 * s5;
        let t164 = s1 * c5 - s5 * t149;
        let t167 = c5 * t155 - c1 * s5;
        let t170 = c1 * c5 + s5 * t155;
        [t161, t164, t167, t170]
    };
    // frame 6
    let [t173, t176, t179, t182, t185, t188] = {
        let t173 = c6 * t161 - s6 * t152;
        let t176 = c6 * t152 + s6 * t161;
        let t179 = c6 * t167 - s6 * t158;
        let t182 = c6 * t158 + s6 * t167;
        let t185 = c6 * t65 + s6 * t40;
        let t188 = c6 * t40 - s6 * t65;
        [t173, t176, t179, t182, t185, t188]
    };
    // in world axes
    {
        let t193 = a6_x * t173 + t113 * t176 - t106 * t164;
        let t198 = t106 * t170 + (a6_x * t179 + t113 * t182);
        let t203 = t66 * t106 + (a6_x * t185 - t113 * t188);
        let t208 = dw6_x * t173 - dw6_y * t176 - t98 * t164;
        let t213 = t98 * t170 + (dw6_x * t179 - dw6_y * t182);
        let t218 = t66 * t98 + (dw6_x * t185 + dw6_y * t188);
        put(0, t193);
        put(1, t198);
        put(2, t203);
        put(3, t208);
        put(4, t213);
        put(5, t218);
    }
}
