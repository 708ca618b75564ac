//! Acceleration of the last DH frame at zero `ddq`: `dJ/dt dq`.
//!
//! In world axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
//!
//! 169 multiplications, 99 additions; 6, 6 of 6 structurally nonzero.

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
    let [s1, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [c1, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
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
        t9, t10, t12, a3_x, t19, w3_x, t25, w3_z,
        dw3_y, t38, t39,
    ] = {
        let t9 = s2 * c3;
        let t10 = s2 * s3;
        let t11 = k_L2 * t4;
        let t12 = k_L2 * t7;
        let t13 = k_L2 * t8;
        let a3_x = c3 * t11 - s3 * t13;
        let t19 = c3 * t13 + s3 * t11;
        let w3_x = c3 * w2_x - s3 * dq2;
        let t25 = c3 * dq2 + s3 * w2_x;
        let w3_z = w2_y + dq3;
        let t35 = t25 * w3_z;
        let dw3_x = c3 * t8 + s3 * t4 - t35;
        let dw3_y = c3 * t4 - s3 * t8 - w3_x * w3_z;
        let t38 = t5 - w3_x * t25;
        let t39 = dw3_x - t35;
        [
        t9, t10, t12, a3_x, t19, w3_x, t25, w3_z,
        dw3_y, t38, t39,
    ]
    };
    // link 4: motion
    let [
        a4_x, a4_y, w4_x, t51, w4_z, dw4_y, t66, t67,
        t68,
    ] = {
        let a4_x = c4 * a3_x + s4 * t12;
        let a4_y = c4 * t12 - s4 * a3_x;
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t51 = c4 * w3_z + s4 * w3_x;
        let w4_z = dq4 - t25;
        let t63 = t51 * w4_z;
        let dw4_x = c4 * t39 + s4 * t38 - t63;
        let dw4_y = c4 * t38 - s4 * t39 - w4_x * w4_z;
        let t66 = dw3_y + w4_x * t51;
        let t67 = w4_x * w4_x + w4_z * w4_z;
        let t68 = dw4_x - t63;
        [
        a4_x, a4_y, w4_x, t51, w4_z, dw4_y, t66, t67,
        t68,
    ]
    };
    // link 5: motion
    let [
        t73, a5_x, a6_z, w5_x, w5_y, w5_z, dw5_y, t99,
        t100,
    ] = {
        let t72 = a4_x + k_L3 * t66;
        let t73 = a4_y + k_L3 * t67;
        let t74 = t19 + k_L3 * t68;
        let a5_x = c5 * t72 - s5 * t74;
        let a6_z = c5 * t74 + s5 * t72;
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let w5_z = t51 + dq5;
        let t96 = w5_y * w5_z;
        let dw5_x = c5 * t68 + s5 * t66 + t96;
        let dw5_y = c5 * t66 - s5 * t68 - w5_x * w5_z;
        let t99 = dw4_y + w5_x * w5_y;
        let t100 = t96 + dw5_x;
        [
        t73, a5_x, a6_z, w5_x, w5_y, w5_z, dw5_y, t99,
        t100,
    ]
    };
    // link 6: motion
    let [a6_x, t106, w6_x, w6_y, w6_z, t124, t125, t126] = {
        let a6_x = c6 * a5_x - s6 * t73;
        let t106 = c6 * t73 + s6 * a5_x;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let w6_z = dq6 - w5_y;
        let t122 = w6_y * w6_z;
        let dw6_x = t122 - (s6 * t99 - c6 * t100);
        let t124 = c6 * t99 + s6 * t100 + w6_x * w6_z;
        let t125 = dw5_y + w6_x * w6_y;
        let t126 = t122 + dw6_x;
        [a6_x, t106, w6_x, w6_y, w6_z, t124, t125, t126]
    };
    // link 7: motion
    let [a7_x, t132, dw7_x, dw7_y] = {
        let a7_x = c7 * a6_x - s7 * a6_z;
        let t132 = c7 * a6_z + s7 * a6_x;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let w7_z = w6_y + dq7;
        let dw7_x = c7 * t126 + s7 * t125 - (c7 * w6_z + s7 * w6_x) * w7_z;
        let dw7_y = c7 * t125 - s7 * t126 - w7_x * w7_z;
        [a7_x, t132, dw7_x, dw7_y]
    };
    // frame 2
    let [t150, t151, t152, t153] = {
        let t150 = c1 * c2;
        let t151 = c1 * s2;
        let t152 = s1 * c2;
        let t153 = s1 * s2;
        [t150, t151, t152, t153]
    };
    // frame 3
    let [t156, t159, t162, t165] = {
        let t156 = c3 * t150 - s1 * s3;
        let t159 = s1 * c3 + s3 * t150;
        let t162 = c3 * t152 + c1 * s3;
        let t165 = c1 * c3 - s3 * t152;
        [t156, t159, t162, t165]
    };
    // frame 4
    let [t168, t171, t174, t177, t180, t183] = {
        let t168 = c4 * t156 + s4 * t151;
        let t171 = c4 * t151 - s4 * t156;
        let t174 = c4 * t162 + s4 * t153;
        let t177 = c4 * t153 - s4 * t162;
        let t180 = c4 * t9 - c2 * s4;
        let t183 = c2 * c4 + s4 * t9;
        [t168, t171, t174, t177, t180, t183]
    };
    // frame 5
    let [t186, t189, t192, t195, t198, t201] = {
        let t186 = c5 * t168 - s5 * t159;
        let t189 = c5 * t159 + s5 * t168;
        let t192 = c5 * t174 + s5 * t165;
        let t195 = c5 * t165 - s5 * t174;
        let t198 = c5 * t180 - s5 * t10;
        let t201 = c5 * t10 + s5 * t180;
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
    // in world axes
    {
        let t242 = t106 * t207 + (a7_x * t222 + t132 * t225);
        let t247 = t106 * t213 + (a7_x * t228 - t132 * t231);
        let t252 = a7_x * t234 + t132 * t237 - t106 * t219;
        let t257 = t124 * t207 + (dw7_x * t222 - dw7_y * t225);
        let t262 = t124 * t213 + (dw7_x * t228 + dw7_y * t231);
        let t267 = dw7_x * t234 - dw7_y * t237 - t124 * t219;
        put(0, t242);
        put(1, t247);
        put(2, t252);
        put(3, t257);
        put(4, t262);
        put(5, t267);
    }
}
