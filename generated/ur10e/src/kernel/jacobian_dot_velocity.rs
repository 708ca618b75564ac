//! Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq`.
//!
//! In base axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
//!
//! 144 multiplications, 83 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq`: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 6]) {
    entries(trig, dq, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], mut put: impl FnMut(usize, S)) {
    let [s1, s2, s3, s4, s5, s6] = trig.sin;
    let [c1, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let D4 = S::constant(0.17415);
    let D5 = S::constant(0.11985);
    let D6 = S::constant(0.11655);
    let k0 = S::constant(0.6127);
    let k1 = S::constant(0.57155);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [w2_x, w2_y, t5, t8, t9] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t5 = w2_x * w2_y;
        let t6 = dq2 * w2_x;
        let t8 = w2_x * w2_x - dq2 * dq2 - t0;
        let t9 = t6 + t6;
        [w2_x, w2_y, t5, t8, t9]
    };
    // link 3: motion
    let [
        w3_x, w3_y, t18, t21, a3_y, w3_z, t28, t31,
        t32,
    ] = {
        let w3_x = c3 * w2_x + s3 * w2_y;
        let w3_y = c3 * w2_y - s3 * w2_x;
        let t16 = t8 * k0;
        let t17 = t5 * k0;
        let t18 = t9 * k0;
        let t21 = c3 * t16 + s3 * t17;
        let a3_y = s3 * t16 - c3 * t17;
        let w3_z = dq2 + dq3;
        let t28 = w3_x * w3_y;
        let t29 = w3_x * w3_z;
        let t31 = w3_x * w3_x - w3_z * w3_z - t0;
        let t32 = t29 + t29;
        [
        w3_x, w3_y, t18, t21, a3_y, w3_z, t28, t31,
        t32,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, a4_x, a4_y, t52, w4_z, t56, dw5_z,
        t59, t60,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_y;
        let w4_y = c4 * w3_y - s4 * w3_x;
        let t42 = t21 + t31 * k1;
        let t43 = a3_y - t28 * k1;
        let a4_x = s4 * t43 - c4 * t42;
        let a4_y = c4 * t43 + s4 * t42;
        let t52 = t18 + (t32 * k1 + D4 * t0);
        let w4_z = w3_z + dq4;
        let t56 = w4_x * w4_y;
        let dw5_z = w4_x * w4_z;
        let dw4_x = w4_y * w4_z;
        let t59 = w4_x * w4_x + w4_z * w4_z;
        let t60 = dw4_x + dw4_x;
        [
        w4_x, w4_y, a4_x, a4_y, t52, w4_z, t56, dw5_z,
        t59, t60,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t71, a5_x, t78, w5_z, t92, t93,
        t94, t95,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t70 = a4_x - D5 * t56;
        let t71 = a4_y + D5 * t59;
        let t72 = t52 + D5 * t60;
        let a5_x = c5 * t70 - s5 * t72;
        let t78 = c5 * t72 + s5 * t70;
        let w5_z = dq5 - w4_y;
        let t90 = w5_y * w5_z;
        let dw5_x = t90 - (s5 * t56 - c5 * t60);
        let t92 = c5 * t56 + s5 * t60 + w5_x * w5_z;
        let t93 = w5_x * w5_y - dw5_z;
        let t94 = w5_x * w5_x + w5_z * w5_z;
        let t95 = t90 + dw5_x;
        [
        w5_x, w5_y, t71, a5_x, t78, w5_z, t92, t93,
        t94, t95,
    ]
    };
    // link 6: motion
    let [t106, a6_x, t113, dw6_x, dw6_y] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t105 = a5_x + D6 * t93;
        let t106 = t78 + D6 * t94;
        let t107 = D6 * t95 - t71;
        let a6_x = c6 * t105 - s6 * t107;
        let t113 = c6 * t107 + s6 * t105;
        let w6_z = w5_y + dq6;
        let dw6_x = c6 * t95 + s6 * t93 - (c6 * w5_z + s6 * w5_x) * w6_z;
        let dw6_y = c6 * t93 - s6 * t95 - w6_x * w6_z;
        [t106, a6_x, t113, dw6_x, dw6_y]
    };
    // frame 2
    let [t125, t126, t127, t128] = {
        let t125 = c1 * c2;
        let t126 = c1 * s2;
        let t127 = s1 * c2;
        let t128 = s1 * s2;
        [t125, t126, t127, t128]
    };
    // frame 3
    let [t131, t134, t137, t140, t143, t146] = {
        let t131 = c3 * t125 - s3 * t126;
        let t134 = c3 * t126 + s3 * t125;
        let t137 = c3 * t127 - s3 * t128;
        let t140 = c3 * t128 + s3 * t127;
        let t143 = s2 * c3 + c2 * s3;
        let t146 = c2 * c3 - s2 * s3;
        [t131, t134, t137, t140, t143, t146]
    };
    // frame 4
    let [t149, t152, t155, t158, t161, t164] = {
        let t149 = c4 * t131 - s4 * t134;
        let t152 = c4 * t134 + s4 * t131;
        let t155 = c4 * t137 - s4 * t140;
        let t158 = c4 * t140 + s4 * t137;
        let t161 = c4 * t143 + s4 * t146;
        let t164 = c4 * t146 - s4 * t143;
        [t149, t152, t155, t158, t161, t164]
    };
    // frame 5
    let [t167, t170, t173, t176, t177, t178] = {
        let t167 = c5 * t149 + s1 * s5;
        let t170 = s1 * c5 - s5 * t149;
        let t173 = c5 * t155 - c1 * s5;
        let t176 = c1 * c5 + s5 * t155;
        let t177 = c5 * t161;
        let t178 = s5 * t161;
        [t167, t170, t173, t176, t177, t178]
    };
    // frame 6
    let [t181, t184, t187, t190, t193, t196] = {
        let t181 = c6 * t167 - s6 * t152;
        let t184 = c6 * t152 + s6 * t167;
        let t187 = c6 * t173 - s6 * t158;
        let t190 = c6 * t158 + s6 * t173;
        let t193 = c6 * t177 + s6 * t164;
        let t196 = c6 * t164 - s6 * t177;
        [t181, t184, t187, t190, t193, t196]
    };
    // in base axes
    {
        let t201 = a6_x * t181 + t113 * t184 - t106 * t170;
        let t206 = t106 * t176 + (a6_x * t187 + t113 * t190);
        let t211 = t106 * t178 + (a6_x * t193 - t113 * t196);
        let t216 = dw6_x * t181 - dw6_y * t184 - t92 * t170;
        let t221 = t92 * t176 + (dw6_x * t187 - dw6_y * t190);
        let t226 = t92 * t178 + (dw6_x * t193 + dw6_y * t196);
        put(0, t201);
        put(1, t206);
        put(2, t211);
        put(3, t216);
        put(4, t221);
        put(5, t226);
    }
}
