//! Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq`.
//!
//! In base axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
//!
//! 184 multiplications, 108 additions; 6, 6 of 6 structurally nonzero.

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
    let A = S::constant(0.0825);
    let L2 = S::constant(0.316);
    let L3 = S::constant(0.384);
    let k3 = S::constant(0.088);
    // link 2: motion
    let [t0, t1, t2, dw2_y] = {
        let t0 = s2 * dq1;
        let t1 = c2 * dq1;
        let t2 = dq2 * t1;
        let dw2_y = dq2 * t0;
        [t0, t1, t2, dw2_y]
    };
    // link 3: motion
    let [w3_x, w3_y, t18, a3_x, a3_y, w3_z, dw3_x, dw3_y] = {
        let w3_x = s3 * dq2 - c3 * t0;
        let w3_y = c3 * dq2 + s3 * t0;
        let t17 = L2 * (t0 * t1);
        let t18 = L2 * (t0 * t0 + dq2 * dq2);
        let t19 = L2 * (t2 + t2);
        let a3_x = s3 * t19 - c3 * t17;
        let a3_y = c3 * t19 + s3 * t17;
        let w3_z = t1 + dq3;
        let dw3_x = dq3 * w3_y - c3 * t2;
        let dw3_y = s3 * t2 - dq3 * w3_x;
        [w3_x, w3_y, t18, a3_x, a3_y, w3_z, dw3_x, dw3_y]
    };
    // link 4: motion
    let [w4_x, w4_y, t54, a4_x, a4_y, w4_z, dw4_x, t66] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t53 = a3_x - A * (w3_y * w3_y + w3_z * w3_z);
        let t54 = a3_y + A * (w3_x * w3_y - dw2_y);
        let t55 = A * (w3_x * w3_z - dw3_y) - t18;
        let a4_x = c4 * t53 + s4 * t55;
        let a4_y = c4 * t55 - s4 * t53;
        let w4_z = dq4 - w3_y;
        let dw4_x = c4 * dw3_x - s4 * dw2_y + dq4 * w4_y;
        let t66 = c4 * dw2_y + s4 * dw3_x + dq4 * w4_x;
        [w4_x, w4_y, t54, a4_x, a4_y, w4_z, dw4_x, t66]
    };
    // link 5: motion
    let [w5_x, t72, a5_z, a5_x, a6_z, w5_z, dw5_x, dw5_y] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t72 = c5 * w4_z + s5 * w4_x;
        let t81 = w4_z * w4_z;
        let t82 = w4_x * w4_y;
        let t100 = a4_x + (A * (w4_y * w4_y + t81) + L3 * (dw3_y + t82));
        let a5_z = a4_y - (A * (t82 - dw3_y) + L3 * (w4_x * w4_x + t81));
        let t102 = L3 * (dw4_x + w4_y * w4_z) - A * (t66 + w4_x * w4_z) - t54;
        let a5_x = c5 * t100 - s5 * t102;
        let a6_z = c5 * t102 + s5 * t100;
        let w5_z = w4_y + dq5;
        let dw5_x = c5 * dw4_x + s5 * dw3_y - dq5 * t72;
        let dw5_y = c5 * dw3_y - s5 * dw4_x - dq5 * w5_x;
        [w5_x, t72, a5_z, a5_x, a6_z, w5_z, dw5_x, dw5_y]
    };
    // link 6: motion
    let [w6_x, w6_y, a6_x, a6_y, w6_z, dw6_x, dw7_z] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let a6_x = c6 * a5_x + s6 * a5_z;
        let a6_y = c6 * a5_z - s6 * a5_x;
        let w6_z = t72 + dq6;
        let dw6_x = c6 * dw5_x - s6 * t66 + dq6 * w6_y;
        let dw7_z = c6 * t66 + s6 * dw5_x + dq6 * w6_x;
        [w6_x, w6_y, a6_x, a6_y, w6_z, dw6_x, dw7_z]
    };
    // link 7: motion
    let [t160, a7_x, a7_y, dw7_x, t171] = {
        let w7_x = c7 * w6_x + s7 * w6_z;
        let w7_y = c7 * w6_z - s7 * w6_x;
        let t159 = a6_x - k3 * (w6_y * w6_y + w6_z * w6_z);
        let t160 = a6_y + k3 * (w6_x * w6_y - dw5_y);
        let t161 = a6_z + k3 * (dw7_z + w6_x * w6_z);
        let a7_x = c7 * t159 + s7 * t161;
        let a7_y = c7 * t161 - s7 * t159;
        let dw7_x = c7 * dw6_x - s7 * dw5_y + dq7 * w7_y;
        let t171 = c7 * dw5_y + s7 * dw6_x + dq7 * w7_x;
        [t160, a7_x, a7_y, dw7_x, t171]
    };
    // frame 2
    let [t172, t173, t174, t175] = {
        let t172 = c1 * c2;
        let t173 = c1 * s2;
        let t174 = s1 * c2;
        let t175 = s1 * s2;
        [t172, t173, t174, t175]
    };
    // frame 3
    let [t178, t181, t184, t187, t188, t189] = {
        let t178 = c3 * t172 - s1 * s3;
        let t181 = s1 * c3 + s3 * t172;
        let t184 = c3 * t174 + c1 * s3;
        let t187 = c1 * c3 - s3 * t174;
        let t188 = s2 * c3;
        let t189 = s2 * s3;
        [t178, t181, t184, t187, t188, t189]
    };
    // frame 4
    let [t192, t195, t198, t201, t204, t207] = {
        let t192 = c4 * t178 + s4 * t173;
        let t195 = c4 * t173 - s4 * t178;
        let t198 = c4 * t184 + s4 * t175;
        let t201 = c4 * t175 - s4 * t184;
        let t204 = c2 * s4 - c4 * t188;
        let t207 = c2 * c4 + s4 * t188;
        [t192, t195, t198, t201, t204, t207]
    };
    // frame 5
    let [t210, t213, t216, t219, t222, t225] = {
        let t210 = c5 * t192 - s5 * t181;
        let t213 = c5 * t181 + s5 * t192;
        let t216 = c5 * t198 + s5 * t187;
        let t219 = c5 * t187 - s5 * t198;
        let t222 = c5 * t204 + s5 * t189;
        let t225 = c5 * t189 - s5 * t204;
        [t210, t213, t216, t219, t222, t225]
    };
    // frame 6
    let [t228, t231, t234, t237, t240, t243] = {
        let t228 = c6 * t210 + s6 * t195;
        let t231 = c6 * t195 - s6 * t210;
        let t234 = c6 * t216 + s6 * t201;
        let t237 = c6 * t201 - s6 * t216;
        let t240 = c6 * t222 + s6 * t207;
        let t243 = c6 * t207 - s6 * t222;
        [t228, t231, t234, t237, t240, t243]
    };
    // frame 7
    let [t246, t249, t252, t255, t258, t261] = {
        let t246 = c7 * t228 + s7 * t213;
        let t249 = c7 * t213 - s7 * t228;
        let t252 = c7 * t234 - s7 * t219;
        let t255 = c7 * t219 + s7 * t234;
        let t258 = c7 * t240 - s7 * t225;
        let t261 = c7 * t225 + s7 * t240;
        [t246, t249, t252, t255, t258, t261]
    };
    // in base axes
    {
        let t266 = t160 * t231 + (a7_x * t246 + a7_y * t249);
        let t271 = t160 * t237 + (a7_x * t252 - a7_y * t255);
        let t276 = t160 * t243 + (a7_x * t258 - a7_y * t261);
        let t281 = dw7_x * t246 - t171 * t249 - dw7_z * t231;
        let t286 = dw7_x * t252 + t171 * t255 - dw7_z * t237;
        let t291 = dw7_x * t258 + t171 * t261 - dw7_z * t243;
        put(0, t266);
        put(1, t271);
        put(2, t276);
        put(3, t281);
        put(4, t286);
        put(5, t291);
    }
}
