//! Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq`.
//!
//! In base axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
//!
//! 169 multiplications, 99 additions; 6, 6 of 6 structurally nonzero.

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
    let L2 = S::constant(0.4);
    let L3 = S::constant(0.39);
    // link 2: motion
    let [w2_x, w2_y, t4, t5, t7, t8] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t4 = w2_x * w2_y;
        let t5 = dq2 * w2_x;
        let dw2_x = dq2 * w2_y;
        let t7 = w2_x * w2_x + dq2 * dq2;
        let t8 = dw2_x + dw2_x;
        [w2_x, w2_y, t4, t5, t7, t8]
    };
    // link 3: motion
    let [
        w3_x, t14, t16, a3_x, t23, w3_z, dw3_y, t36,
        t37,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t14 = c3 * dq2 + s3 * w2_x;
        let t15 = L2 * t4;
        let t16 = L2 * t7;
        let t17 = L2 * t8;
        let a3_x = c3 * t15 - s3 * t17;
        let t23 = c3 * t17 + s3 * t15;
        let w3_z = w2_y + dq3;
        let t33 = t14 * w3_z;
        let dw3_x = c3 * t8 + s3 * t4 - t33;
        let dw3_y = c3 * t4 - s3 * t8 - w3_x * w3_z;
        let t36 = t5 - w3_x * t14;
        let t37 = dw3_x - t33;
        [
        w3_x, t14, t16, a3_x, t23, w3_z, dw3_y, t36,
        t37,
    ]
    };
    // link 4: motion
    let [
        w4_x, t43, a4_x, a4_y, w4_z, dw4_y, t64, t65,
        t66,
    ] = {
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t43 = c4 * w3_z + s4 * w3_x;
        let a4_x = c4 * a3_x + s4 * t16;
        let a4_y = c4 * t16 - s4 * a3_x;
        let w4_z = dq4 - t14;
        let t61 = t43 * w4_z;
        let dw4_x = c4 * t37 + s4 * t36 - t61;
        let dw4_y = c4 * t36 - s4 * t37 - w4_x * w4_z;
        let t64 = dw3_y + w4_x * t43;
        let t65 = w4_x * w4_x + w4_z * w4_z;
        let t66 = dw4_x - t61;
        [
        w4_x, t43, a4_x, a4_y, w4_z, dw4_y, t64, t65,
        t66,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t77, a5_x, a6_z, w5_z, dw5_y, t97,
        t98,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t76 = a4_x + L3 * t64;
        let t77 = a4_y + L3 * t65;
        let t78 = t23 + L3 * t66;
        let a5_x = c5 * t76 - s5 * t78;
        let a6_z = c5 * t78 + s5 * t76;
        let w5_z = t43 + dq5;
        let t94 = w5_y * w5_z;
        let dw5_x = c5 * t66 + s5 * t64 + t94;
        let dw5_y = c5 * t64 - s5 * t66 - w5_x * w5_z;
        let t97 = dw4_y + w5_x * w5_y;
        let t98 = t94 + dw5_x;
        [
        w5_x, w5_y, t77, a5_x, a6_z, w5_z, dw5_y, t97,
        t98,
    ]
    };
    // link 6: motion
    let [w6_x, w6_y, a6_x, t110, w6_z, t122, t123, t124] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let a6_x = c6 * a5_x - s6 * t77;
        let t110 = c6 * t77 + s6 * a5_x;
        let w6_z = dq6 - w5_y;
        let t120 = w6_y * w6_z;
        let dw6_x = t120 - (s6 * t97 - c6 * t98);
        let t122 = c6 * t97 + s6 * t98 + w6_x * w6_z;
        let t123 = dw5_y + w6_x * w6_y;
        let t124 = t120 + dw6_x;
        [w6_x, w6_y, a6_x, t110, w6_z, t122, t123, t124]
    };
    // link 7: motion
    let [a7_x, t136, dw7_x, dw7_y] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let a7_x = c7 * a6_x - s7 * a6_z;
        let t136 = c7 * a6_z + s7 * a6_x;
        let w7_z = w6_y + dq7;
        let dw7_x = c7 * t124 + s7 * t123 - (c7 * w6_z + s7 * w6_x) * w7_z;
        let dw7_y = c7 * t123 - s7 * t124 - w7_x * w7_z;
        [a7_x, t136, dw7_x, dw7_y]
    };
    // frame 2
    let [t148, t149, t150, t151] = {
        let t148 = c1 * c2;
        let t149 = c1 * s2;
        let t150 = s1 * c2;
        let t151 = s1 * s2;
        [t148, t149, t150, t151]
    };
    // frame 3
    let [t154, t157, t160, t163, t164, t165] = {
        let t154 = c3 * t148 - s1 * s3;
        let t157 = s1 * c3 + s3 * t148;
        let t160 = c3 * t150 + c1 * s3;
        let t163 = c1 * c3 - s3 * t150;
        let t164 = s2 * c3;
        let t165 = s2 * s3;
        [t154, t157, t160, t163, t164, t165]
    };
    // frame 4
    let [t168, t171, t174, t177, t180, t183] = {
        let t168 = c4 * t154 + s4 * t149;
        let t171 = c4 * t149 - s4 * t154;
        let t174 = c4 * t160 + s4 * t151;
        let t177 = c4 * t151 - s4 * t160;
        let t180 = c4 * t164 - c2 * s4;
        let t183 = c2 * c4 + s4 * t164;
        [t168, t171, t174, t177, t180, t183]
    };
    // frame 5
    let [t186, t189, t192, t195, t198, t201] = {
        let t186 = c5 * t168 - s5 * t157;
        let t189 = c5 * t157 + s5 * t168;
        let t192 = c5 * t174 + s5 * t163;
        let t195 = c5 * t163 - s5 * t174;
        let t198 = c5 * t180 - s5 * t165;
        let t201 = c5 * t165 + s5 * t180;
        [t186, t189, t192, t195, t198, t201]
    };
    // frame 6
    let [t204, t207, t210, t213, t216, t219] = {
        let t204 = c6 * t186 - s6 * t171;
        let t207 = c6 * t171 + s6 * t186;
        let t210 = c6 * t192 - s6 * t177;
        let t213 = c6 * t177 + s6 * t192;
        let t216 = c6 * t198 + s6 * t183;
        let t219 = c6 * t183 - s6 * t198;
        [t204, t207, t210, t213, t216, t219]
    };
    // frame 7
    let [t222, t225, t228, t231, t234, t237] = {
        let t222 = c7 * t204 - s7 * t189;
        let t225 = c7 * t189 + s7 * t204;
        let t228 = c7 * t210 + s7 * t195;
        let t231 = c7 * t195 - s7 * t210;
        let t234 = c7 * t216 - s7 * t201;
        let t237 = c7 * t201 + s7 * t216;
        [t222, t225, t228, t231, t234, t237]
    };
    // in base axes
    {
        let t242 = t110 * t207 + (a7_x * t222 + t136 * t225);
        let t247 = t110 * t213 + (a7_x * t228 - t136 * t231);
        let t252 = a7_x * t234 + t136 * t237 - t110 * t219;
        let t257 = t122 * t207 + (dw7_x * t222 - dw7_y * t225);
        let t262 = t122 * t213 + (dw7_x * t228 + dw7_y * t231);
        let t267 = dw7_x * t234 - dw7_y * t237 - t122 * t219;
        put(0, t242);
        put(1, t247);
        put(2, t252);
        put(3, t257);
        put(4, t262);
        put(5, t267);
    }
}
