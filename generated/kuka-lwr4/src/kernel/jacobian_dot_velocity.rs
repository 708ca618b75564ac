//! Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq`.
//!
//! In base axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
//!
//! 165 multiplications, 90 additions; 6, 6 of 6 structurally nonzero.

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
    let [w2_x, w2_y, dw2_x, t3] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let dw2_x = dq2 * w2_y;
        let t3 = dq2 * w2_x;
        [w2_x, w2_y, dw2_x, t3]
    };
    // link 3: motion
    let [w3_x, t9, t18, a3_x, t25, w3_z, dw3_x, t30] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t9 = c3 * dq2 + s3 * w2_x;
        let t17 = L2 * (w2_x * w2_y);
        let t18 = L2 * (w2_x * w2_x + dq2 * dq2);
        let t19 = L2 * (dw2_x + dw2_x);
        let a3_x = c3 * t17 - s3 * t19;
        let t25 = c3 * t19 + s3 * t17;
        let w3_z = w2_y + dq3;
        let dw3_x = c3 * dw2_x - dq3 * t9;
        let t30 = s3 * dw2_x + dq3 * w3_x;
        [w3_x, t9, t18, a3_x, t25, w3_z, dw3_x, t30]
    };
    // link 4: motion
    let [w4_x, t36, a4_x, a4_y, w4_z, dw4_x, dw4_y] = {
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t36 = c4 * w3_z + s4 * w3_x;
        let a4_x = c4 * a3_x + s4 * t18;
        let a4_y = c4 * t18 - s4 * a3_x;
        let w4_z = dq4 - t9;
        let dw4_x = c4 * dw3_x + s4 * t3 - dq4 * t36;
        let dw4_y = c4 * t3 - s4 * dw3_x - dq4 * w4_x;
        [w4_x, t36, a4_x, a4_y, w4_z, dw4_x, dw4_y]
    };
    // link 5: motion
    let [w5_x, w5_y, t77, a5_x, a6_z, w5_z, dw5_x, dw6_z] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t76 = a4_x - L3 * (t30 - w4_x * t36);
        let t77 = a4_y + L3 * (w4_x * w4_x + w4_z * w4_z);
        let t78 = t25 + L3 * (dw4_x - t36 * w4_z);
        let a5_x = c5 * t76 - s5 * t78;
        let a6_z = c5 * t78 + s5 * t76;
        let w5_z = t36 + dq5;
        let dw5_x = c5 * dw4_x - s5 * t30 + dq5 * w5_y;
        let dw6_z = c5 * t30 + s5 * dw4_x + dq5 * w5_x;
        [w5_x, w5_y, t77, a5_x, a6_z, w5_z, dw5_x, dw6_z]
    };
    // link 6: motion
    let [w6_x, a6_x, t107, w6_z, dw6_x, t112] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let a6_x = c6 * a5_x - s6 * t77;
        let t107 = c6 * t77 + s6 * a5_x;
        let w6_z = dq6 - w5_y;
        let dw6_x = c6 * dw5_x - s6 * dw4_y + dq6 * w6_y;
        let t112 = c6 * dw4_y + s6 * dw5_x + dq6 * w6_x;
        [w6_x, a6_x, t107, w6_z, dw6_x, t112]
    };
    // link 7: motion
    let [a7_x, t130, dw7_x, t134] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let a7_x = c7 * a6_x - s7 * a6_z;
        let t130 = c7 * a6_z + s7 * a6_x;
        let dw7_x = c7 * dw6_x - s7 * dw6_z - dq7 * (c7 * w6_z + s7 * w6_x);
        let t134 = c7 * dw6_z + s7 * dw6_x + dq7 * w7_x;
        [a7_x, t130, dw7_x, t134]
    };
    // frame 2
    let [t135, t136, t137, t138] = {
        let t135 = c1 * c2;
        let t136 = c1 * s2;
        let t137 = s1 * c2;
        let t138 = s1 * s2;
        [t135, t136, t137, t138]
    };
    // frame 3
    let [t141, t144, t147, t150, t151, t152] = {
        let t141 = c3 * t135 - s1 * s3;
        let t144 = s1 * c3 + s3 * t135;
        let t147 = c3 * t137 + c1 * s3;
        let t150 = c1 * c3 - s3 * t137;
        let t151 = s2 * c3;
        let t152 = s2 * s3;
        [t141, t144, t147, t150, t151, t152]
    };
    // frame 4
    let [t155, t158, t161, t164, t167, t170] = {
        let t155 = c4 * t141 + s4 * t136;
        let t158 = c4 * t136 - s4 * t141;
        let t161 = c4 * t147 + s4 * t138;
        let t164 = c4 * t138 - s4 * t147;
        let t167 = c4 * t151 - c2 * s4;
        let t170 = c2 * c4 + s4 * t151;
        [t155, t158, t161, t164, t167, t170]
    };
    // frame 5
    let [t173, t176, t179, t182, t185, t188] = {
        let t173 = c5 * t155 - s5 * t144;
        let t176 = c5 * t144 + s5 * t155;
        let t179 = c5 * t161 + s5 * t150;
        let t182 = c5 * t150 - s5 * t161;
        let t185 = c5 * t167 - s5 * t152;
        let t188 = c5 * t152 + s5 * t167;
        [t173, t176, t179, t182, t185, t188]
    };
    // frame 6
    let [t191, t194, t197, t200, t203, t206] = {
        let t191 = c6 * t173 - s6 * t158;
        let t194 = c6 * t158 + s6 * t173;
        let t197 = c6 * t179 - s6 * t164;
        let t200 = c6 * t164 + s6 * t179;
        let t203 = c6 * t185 + s6 * t170;
        let t206 = c6 * t170 - s6 * t185;
        [t191, t194, t197, t200, t203, t206]
    };
    // frame 7
    let [t209, t212, t215, t218, t221, t224] = {
        let t209 = c7 * t191 - s7 * t176;
        let t212 = c7 * t176 + s7 * t191;
        let t215 = c7 * t197 + s7 * t182;
        let t218 = c7 * t182 - s7 * t197;
        let t221 = c7 * t203 - s7 * t188;
        let t224 = c7 * t188 + s7 * t203;
        [t209, t212, t215, t218, t221, t224]
    };
    // in base axes
    {
        let t229 = t107 * t194 + (a7_x * t209 + t130 * t212);
        let t234 = t107 * t200 + (a7_x * t215 - t130 * t218);
        let t239 = a7_x * t221 + t130 * t224 - t107 * t206;
        let t244 = t112 * t194 + (dw7_x * t209 + t134 * t212);
        let t249 = t112 * t200 + (dw7_x * t215 - t134 * t218);
        let t254 = dw7_x * t221 + t134 * t224 - t112 * t206;
        put(0, t229);
        put(1, t234);
        put(2, t239);
        put(3, t244);
        put(4, t249);
        put(5, t254);
    }
}
