//! Acceleration of the last DH frame at zero `ddq`: `dJ/dt dq`.
//!
//! In world axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
//!
//! 186 multiplications, 112 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

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
    let [a2_z, w2_x, w2_y, t6, t7, t9, t10] = {
        let a2_z = t0 * k0;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t6 = w2_x * w2_y;
        let t7 = dq2 * w2_x;
        let dw2_x = dq2 * w2_y;
        let t9 = w2_x * w2_x + dq2 * dq2;
        let t10 = dw2_x + dw2_x;
        [a2_z, w2_x, w2_y, t6, t7, t9, t10]
    };
    // link 3: motion
    let [
        t11, t12, a3_z, t19, a3_y, w3_x, t28, w3_z,
        dw3_y, t43, t44, t45,
    ] = {
        let t11 = s2 * c3;
        let t12 = s2 * s3;
        let t13 = t6 * k1;
        let a3_z = t9 * k1;
        let t16 = a2_z - t10 * k1;
        let t19 = c3 * t13 + s3 * t16;
        let a3_y = s3 * t13 - c3 * t16;
        let w3_x = c3 * w2_x - s3 * dq2;
        let t28 = c3 * dq2 + s3 * w2_x;
        let w3_z = w2_y + dq3;
        let t40 = t28 * w3_z;
        let dw3_x = c3 * t10 + s3 * t6 - t40;
        let dw3_y = c3 * t6 - s3 * t10 - w3_x * w3_z;
        let t43 = t7 - w3_x * t28;
        let t44 = w3_x * w3_x + w3_z * w3_z;
        let t45 = dw3_x - t40;
        [
        t11, t12, a3_z, t19, a3_y, w3_x, t28, w3_z,
        dw3_y, t43, t44, t45,
    ]
    };
    // link 4: motion
    let [
        t50, a4_x, a4_y, w4_x, w4_y, w4_z, t77, t78,
        t79, t80,
    ] = {
        let t49 = t43 * k2 - t19;
        let t50 = a3_y - t44 * k2;
        let t51 = a3_z + t45 * k2;
        let a4_x = c4 * t49 + s4 * t51;
        let a4_y = c4 * t51 - s4 * t49;
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let w4_z = t28 + dq4;
        let t75 = w4_y * w4_z;
        let dw4_x = t75 - (s4 * t43 - c4 * t45);
        let t77 = c4 * t43 + s4 * t45 + w4_x * w4_z;
        let t78 = dw3_y + w4_x * w4_y;
        let t79 = w4_x * w4_x + w4_z * w4_z;
        let t80 = t75 + dw4_x;
        [
        t50, a4_x, a4_y, w4_x, w4_y, w4_z, t77, t78,
        t79, t80,
    ]
    };
    // link 5: motion
    let [
        a5_z, a5_x, a5_y, w5_x, t98, w5_z, dw5_y, t113,
        t114, t115,
    ] = {
        let t84 = a4_x - t78 * k3;
        let a5_z = a4_y + t79 * k3;
        let t86 = t50 + t80 * k3;
        let a5_x = c5 * t84 + s5 * t86;
        let a5_y = c5 * t86 - s5 * t84;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t98 = c5 * w4_z + s5 * w4_x;
        let w5_z = w4_y + dq5;
        let t110 = t98 * w5_z;
        let dw5_x = c5 * t80 + s5 * t78 - t110;
        let dw5_y = c5 * t78 - s5 * t80 - w5_x * w5_z;
        let t113 = t77 - w5_x * t98;
        let t114 = w5_x * w5_x + w5_z * w5_z;
        let t115 = dw5_x - t110;
        [
        a5_z, a5_x, a5_y, w5_x, t98, w5_z, dw5_y, t113,
        t114, t115,
    ]
    };
    // link 6: motion
    let [
        t120, a6_x, a6_y, w6_x, w6_y, w6_z, t147, t148,
        t149, t150,
    ] = {
        let t119 = a5_x + t113 * k4;
        let t120 = a5_y - t114 * k4;
        let t121 = a5_z + t115 * k4;
        let a6_x = c6 * t119 + s6 * t121;
        let a6_y = c6 * t121 - s6 * t119;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let w6_z = t98 + dq6;
        let t145 = w6_y * w6_z;
        let dw6_x = t145 - (s6 * t113 - c6 * t115);
        let t147 = c6 * t113 + s6 * t115 + w6_x * w6_z;
        let t148 = dw5_y + w6_x * w6_y;
        let t149 = w6_x * w6_x + w6_z * w6_z;
        let t150 = t145 + dw6_x;
        [
        t120, a6_x, a6_y, w6_x, w6_y, w6_z, t147, t148,
        t149, t150,
    ]
    };
    // link 7: motion
    let [a7_z, a7_x, a7_y, dw7_x, dw7_y] = {
        let t154 = a6_x - t148 * k5;
        let a7_z = a6_y + t149 * k5;
        let t156 = t120 + t150 * k5;
        let a7_x = c7 * t154 + s7 * t156;
        let a7_y = c7 * t156 - s7 * t154;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let w7_z = w6_y + dq7;
        let dw7_x = c7 * t150 + s7 * t148 - (c7 * w6_z + s7 * w6_x) * w7_z;
        let dw7_y = c7 * t148 - s7 * t150 - w7_x * w7_z;
        [a7_z, a7_x, a7_y, dw7_x, dw7_y]
    };
    // frame 2
    let [t180, t181, t182, t183] = {
        let t180 = c1 * c2;
        let t181 = c1 * s2;
        let t182 = s1 * c2;
        let t183 = s1 * s2;
        [t180, t181, t182, t183]
    };
    // frame 3
    let [t186, t189, t192, t195] = {
        let t186 = c3 * t180 - s1 * s3;
        let t189 = s1 * c3 + s3 * t180;
        let t192 = c3 * t182 + c1 * s3;
        let t195 = s3 * t182 - c1 * c3;
        [t186, t189, t192, t195]
    };
    // frame 4
    let [t198, t201, t204, t207, t210, t213] = {
        let t198 = c4 * t186 - s4 * t181;
        let t201 = c4 * t181 + s4 * t186;
        let t204 = s4 * t183 - c4 * t192;
        let t207 = c4 * t183 + s4 * t192;
        let t210 = c4 * t11 + c2 * s4;
        let t213 = s4 * t11 - c2 * c4;
        [t198, t201, t204, t207, t210, t213]
    };
    // frame 5
    let [t216, t219, t222, t225, t228, t231] = {
        let t216 = c5 * t198 - s5 * t189;
        let t219 = c5 * t189 + s5 * t198;
        let t222 = c5 * t204 + s5 * t195;
        let t225 = c5 * t195 - s5 * t204;
        let t228 = s5 * t12 - c5 * t210;
        let t231 = c5 * t12 + s5 * t210;
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
    // in world axes
    {
        let t272 = a7_x * t252 - a7_y * t255 - a7_z * t237;
        let t277 = a7_z * t243 + (a7_x * t258 + a7_y * t261);
        let t282 = a7_z * t249 + (a7_x * t264 + a7_y * t267);
        let t287 = t147 * t237 + (dw7_x * t252 - dw7_y * t255);
        let t292 = dw7_x * t258 + dw7_y * t261 - t147 * t243;
        let t297 = dw7_x * t264 + dw7_y * t267 - t147 * t249;
        put(0, t272);
        put(1, t277);
        put(2, t282);
        put(3, t287);
        put(4, t292);
        put(5, t297);
    }
}
