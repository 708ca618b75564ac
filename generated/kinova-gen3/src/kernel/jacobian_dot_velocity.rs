//! Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq`.
//!
//! In base axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
//!
//! 186 multiplications, 112 additions; 6, 6 of 6 structurally nonzero.

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
    let [s1, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [c1, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let k0 = S::constant(0.01175);
    let k1 = S::constant(0.42076);
    let k2 = S::constant(0.01275);
    let k3 = S::constant(0.31436);
    let k4 = S::constant(0.00035);
    let k5 = S::constant(0.167455);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [w2_x, w2_y, a2_z, t6, t7, t9, t10] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let a2_z = t0 * k0;
        let t6 = w2_x * w2_y;
        let t7 = dq2 * w2_x;
        let dw2_x = dq2 * w2_y;
        let t9 = w2_x * w2_x + dq2 * dq2;
        let t10 = dw2_x + dw2_x;
        [w2_x, w2_y, a2_z, t6, t7, t9, t10]
    };
    // link 3: motion
    let [
        w3_x, t16, a3_z, t23, a3_y, w3_z, dw3_y, t41,
        t42, t43,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t16 = c3 * dq2 + s3 * w2_x;
        let t17 = t6 * k1;
        let a3_z = t9 * k1;
        let t20 = a2_z - t10 * k1;
        let t23 = c3 * t17 + s3 * t20;
        let a3_y = s3 * t17 - c3 * t20;
        let w3_z = w2_y + dq3;
        let t38 = t16 * w3_z;
        let dw3_x = c3 * t10 + s3 * t6 - t38;
        let dw3_y = c3 * t6 - s3 * t10 - w3_x * w3_z;
        let t41 = t7 - w3_x * t16;
        let t42 = w3_x * w3_x + w3_z * w3_z;
        let t43 = dw3_x - t38;
        [
        w3_x, t16, a3_z, t23, a3_y, w3_z, dw3_y, t41,
        t42, t43,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t54, a4_x, a4_y, w4_z, t75, t76,
        t77, t78,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t53 = t41 * k2 - t23;
        let t54 = a3_y - t42 * k2;
        let t55 = a3_z + t43 * k2;
        let a4_x = c4 * t53 + s4 * t55;
        let a4_y = c4 * t55 - s4 * t53;
        let w4_z = t16 + dq4;
        let t73 = w4_y * w4_z;
        let dw4_x = t73 - (s4 * t41 - c4 * t43);
        let t75 = c4 * t41 + s4 * t43 + w4_x * w4_z;
        let t76 = dw3_y + w4_x * w4_y;
        let t77 = w4_x * w4_x + w4_z * w4_z;
        let t78 = t73 + dw4_x;
        [
        w4_x, w4_y, t54, a4_x, a4_y, w4_z, t75, t76,
        t77, t78,
    ]
    };
    // link 5: motion
    let [
        w5_x, t84, a5_z, a5_x, a5_y, w5_z, dw5_y, t111,
        t112, t113,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t84 = c5 * w4_z + s5 * w4_x;
        let t88 = a4_x - t76 * k3;
        let a5_z = a4_y + t77 * k3;
        let t90 = t54 + t78 * k3;
        let a5_x = c5 * t88 + s5 * t90;
        let a5_y = c5 * t90 - s5 * t88;
        let w5_z = w4_y + dq5;
        let t108 = t84 * w5_z;
        let dw5_x = c5 * t78 + s5 * t76 - t108;
        let dw5_y = c5 * t76 - s5 * t78 - w5_x * w5_z;
        let t111 = t75 - w5_x * t84;
        let t112 = w5_x * w5_x + w5_z * w5_z;
        let t113 = dw5_x - t108;
        [
        w5_x, t84, a5_z, a5_x, a5_y, w5_z, dw5_y, t111,
        t112, t113,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t124, a6_x, a6_y, w6_z, t145, t146,
        t147, t148,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t123 = a5_x + t111 * k4;
        let t124 = a5_y - t112 * k4;
        let t125 = a5_z + t113 * k4;
        let a6_x = c6 * t123 + s6 * t125;
        let a6_y = c6 * t125 - s6 * t123;
        let w6_z = t84 + dq6;
        let t143 = w6_y * w6_z;
        let dw6_x = t143 - (s6 * t111 - c6 * t113);
        let t145 = c6 * t111 + s6 * t113 + w6_x * w6_z;
        let t146 = dw5_y + w6_x * w6_y;
        let t147 = w6_x * w6_x + w6_z * w6_z;
        let t148 = t143 + dw6_x;
        [
        w6_x, w6_y, t124, a6_x, a6_y, w6_z, t145, t146,
        t147, t148,
    ]
    };
    // link 7: motion
    let [a7_z, a7_x, a7_y, dw7_x, dw7_y] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t158 = a6_x - t146 * k5;
        let a7_z = a6_y + t147 * k5;
        let t160 = t124 + t148 * k5;
        let a7_x = c7 * t158 + s7 * t160;
        let a7_y = c7 * t160 - s7 * t158;
        let w7_z = w6_y + dq7;
        let dw7_x = c7 * t148 + s7 * t146 - (c7 * w6_z + s7 * w6_x) * w7_z;
        let dw7_y = c7 * t146 - s7 * t148 - w7_x * w7_z;
        [a7_z, a7_x, a7_y, dw7_x, dw7_y]
    };
    // frame 2
    let [t178, t179, t180, t181] = {
        let t178 = c1 * c2;
        let t179 = c1 * s2;
        let t180 = s1 * c2;
        let t181 = s1 * s2;
        [t178, t179, t180, t181]
    };
    // frame 3
    let [t184, t187, t190, t193, t194, t195] = {
        let t184 = c3 * t178 - s1 * s3;
        let t187 = s1 * c3 + s3 * t178;
        let t190 = c3 * t180 + c1 * s3;
        let t193 = s3 * t180 - c1 * c3;
        let t194 = s2 * c3;
        let t195 = s2 * s3;
        [t184, t187, t190, t193, t194, t195]
    };
    // frame 4
    let [t198, t201, t204, t207, t210, t213] = {
        let t198 = c4 * t184 - s4 * t179;
        let t201 = c4 * t179 + s4 * t184;
        let t204 = s4 * t181 - c4 * t190;
        let t207 = c4 * t181 + s4 * t190;
        let t210 = c4 * t194 + c2 * s4;
        let t213 = s4 * t194 - c2 * c4;
        [t198, t201, t204, t207, t210, t213]
    };
    // frame 5
    let [t216, t219, t222, t225, t228, t231] = {
        let t216 = c5 * t198 - s5 * t187;
        let t219 = c5 * t187 + s5 * t198;
        let t222 = c5 * t204 + s5 * t193;
        let t225 = c5 * t193 - s5 * t204;
        let t228 = s5 * t195 - c5 * t210;
        let t231 = c5 * t195 + s5 * t210;
        [t216, t219, t222, t225, t228, t231]
    };
    // frame 6
    let [t234, t237, t240, t243, t246, t249] = {
        let t234 = c6 * t216 - s6 * t201;
        let t237 = c6 * t201 + s6 * t216;
        let t240 = c6 * t222 + s6 * t207;
        let t243 = c6 * t207 - s6 * t222;
        let t246 = c6 * t228 + s6 * t213;
        let t249 = c6 * t213 - s6 * t228;
        [t234, t237, t240, t243, t246, t249]
    };
    // frame 7
    let [t252, t255, t258, t261, t264, t267] = {
        let t252 = c7 * t234 - s7 * t219;
        let t255 = c7 * t219 + s7 * t234;
        let t258 = c7 * t240 + s7 * t225;
        let t261 = c7 * t225 - s7 * t240;
        let t264 = c7 * t246 + s7 * t231;
        let t267 = c7 * t231 - s7 * t246;
        [t252, t255, t258, t261, t264, t267]
    };
    // in base axes
    {
        let t272 = a7_x * t252 - a7_y * t255 - a7_z * t237;
        let t277 = a7_z * t243 + (a7_x * t258 + a7_y * t261);
        let t282 = a7_z * t249 + (a7_x * t264 + a7_y * t267);
        let t287 = t145 * t237 + (dw7_x * t252 - dw7_y * t255);
        let t292 = dw7_x * t258 + dw7_y * t261 - t145 * t243;
        let t297 = dw7_x * t264 + dw7_y * t267 - t145 * t249;
        put(0, t272);
        put(1, t277);
        put(2, t282);
        put(3, t287);
        put(4, t292);
        put(5, t297);
    }
}
