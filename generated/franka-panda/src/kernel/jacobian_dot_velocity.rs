//! Acceleration of the last DH frame at zero `ddq`: `dJ/dt dq`.
//!
//! In world axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
//!
//! 184 multiplications, 122 additions; 6, 6 of 6 structurally nonzero.

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
    let k3 = S::constant(0.088);
    let k_A = S::constant(constants::A);
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
    // link 2: motion
    let [t0, t1, t4, dw2_y, t7, t8] = {
        let t0 = s2 * dq1;
        let t1 = c2 * dq1;
        let t4 = t0 * t1;
        let dw2_y = dq2 * t0;
        let t6 = dq2 * t1;
        let t7 = t0 * t0 + dq2 * dq2;
        let t8 = t6 + t6;
        [t0, t1, t4, dw2_y, t7, t8]
    };
    // link 3: motion
    let [
        t9, t10, t12, a3_x, a3_y, w3_x, w3_y, w3_z,
        dw3_y, t41, t42, t43, t44, t45, t46,
    ] = {
        let t9 = s2 * c3;
        let t10 = s2 * s3;
        let t11 = k_L2 * t4;
        let t12 = k_L2 * t7;
        let t13 = k_L2 * t8;
        let a3_x = s3 * t13 - c3 * t11;
        let a3_y = c3 * t13 + s3 * t11;
        let w3_x = s3 * dq2 - c3 * t0;
        let w3_y = c3 * dq2 + s3 * t0;
        let w3_z = t1 + dq3;
        let t33 = w3_x * w3_x;
        let t34 = w3_z * w3_z;
        let t35 = w3_x * w3_y;
        let t36 = w3_x * w3_z;
        let t37 = w3_y * w3_z;
        let dw3_x = t37 - (c3 * t8 + s3 * t4);
        let dw3_y = s3 * t8 - c3 * t4 - t36;
        let t41 = t33 - t34 - t7;
        let t42 = dw2_y + t35;
        let t43 = t35 - dw2_y;
        let t44 = t33 + t34;
        let t45 = t36 - dw3_y;
        let t46 = t37 + dw3_x;
        [
        t9, t10, t12, a3_x, a3_y, w3_x, w3_y, w3_z,
        dw3_y, t41, t42, t43, t44, t45, t46,
    ]
    };
    // link 4: motion
    let [
        t51, a4_x, a4_y, w4_x, w4_y, w4_z, t78, t80,
        t81, t82, t83, t84, t85,
    ] = {
        let t50 = a3_x + k_A * t41;
        let t51 = a3_y + k_A * t43;
        let t52 = k_A * t45 - t12;
        let a4_x = c4 * t50 + s4 * t52;
        let a4_y = c4 * t52 - s4 * t50;
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let w4_z = dq4 - w3_y;
        let t72 = w4_x * w4_x;
        let t73 = w4_z * w4_z;
        let t74 = w4_x * w4_y;
        let t75 = w4_x * w4_z;
        let t76 = w4_y * w4_z;
        let dw4_x = t76 - (s4 * t42 - c4 * t46);
        let t78 = c4 * t42 + s4 * t46 + t75;
        let t80 = t72 - t73 - t44;
        let t81 = dw3_y + t74;
        let t82 = t74 - dw3_y;
        let t83 = t72 + t73;
        let t84 = t75 + t78;
        let t85 = t76 + dw4_x;
        [
        t51, a4_x, a4_y, w4_x, w4_y, w4_z, t78, t80,
        t81, t82, t83, t84, t85,
    ]
    };
    // link 5: motion
    let [
        a5_z, a5_x, a6_z, w5_x, t109, w5_z, dw5_y, t124,
        t125, t126,
    ] = {
        let t95 = a4_x + (k_L3 * t81 - k_A * t80);
        let a5_z = a4_y - (k_A * t82 + k_L3 * t83);
        let t97 = k_L3 * t85 - k_A * t84 - t51;
        let a5_x = c5 * t95 - s5 * t97;
        let a6_z = c5 * t97 + s5 * t95;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t109 = c5 * w4_z + s5 * w4_x;
        let w5_z = w4_y + dq5;
        let t121 = t109 * w5_z;
        let dw5_x = c5 * t85 + s5 * t81 - t121;
        let dw5_y = c5 * t81 - s5 * t85 - w5_x * w5_z;
        let t124 = t78 - w5_x * t109;
        let t125 = w5_x * w5_x + w5_z * w5_z;
        let t126 = dw5_x - t121;
        [
        a5_z, a5_x, a6_z, w5_x, t109, w5_z, dw5_y, t124,
        t125, t126,
    ]
    };
    // link 6: motion
    let [
        a6_x, a6_y, w6_x, w6_y, w6_z, dw7_z, t154, t155,
        t156, t157, t158,
    ] = {
        let a6_x = c6 * a5_x + s6 * a5_z;
        let a6_y = c6 * a5_z - s6 * a5_x;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let w6_z = t109 + dq6;
        let t148 = w6_x * w6_y;
        let t149 = w6_x * w6_z;
        let t150 = w6_y * w6_z;
        let dw6_x = t150 - (s6 * t124 - c6 * t126);
        let dw7_z = c6 * t124 + s6 * t126 + t149;
        let t154 = w6_x * w6_x - w6_z * w6_z - t125;
        let t155 = dw5_y + t148;
        let t156 = t148 - dw5_y;
        let t157 = t149 + dw7_z;
        let t158 = t150 + dw6_x;
        [
        a6_x, a6_y, w6_x, w6_y, w6_z, dw7_z, t154, t155,
        t156, t157, t158,
    ]
    };
    // link 7: motion
    let [t163, a7_x, a7_y, dw7_x, t187] = {
        let t162 = a6_x + k3 * t154;
        let t163 = a6_y + k3 * t156;
        let t164 = a6_z + k3 * t157;
        let a7_x = c7 * t162 + s7 * t164;
        let a7_y = c7 * t164 - s7 * t162;
        let w7_x = c7 * w6_x + s7 * w6_z;
        let w7_y = c7 * w6_z - s7 * w6_x;
        let w7_z = dq7 - w6_y;
        let dw7_x = w7_y * w7_z - (s7 * t155 - c7 * t158);
        let t187 = c7 * t155 + s7 * t158 + w7_x * w7_z;
        [t163, a7_x, a7_y, dw7_x, t187]
    };
    // frame 2
    let [t188, t189, t190, t191] = {
        let t188 = c1 * c2;
        let t189 = c1 * s2;
        let t190 = s1 * c2;
        let t191 = s1 * s2;
        [t188, t189, t190, t191]
    };
    // frame 3
    let [t194, t197, t200, t203] = {
        let t194 = c3 * t188 - s1 * s3;
        let t197 = s1 * c3 + s3 * t188;
        let t200 = c3 * t190 + c1 * s3;
        let t203 = c1 * c3 - s3 * t190;
        [t194, t197, t200, t203]
    };
    // frame 4
    let [t206, t209, t212, t215, t218, t221] = {
        let t206 = c4 * t194 + s4 * t189;
        let t209 = c4 * t189 - s4 * t194;
        let t212 = c4 * t200 + s4 * t191;
        let t215 = c4 * t191 - s4 * t200;
        let t218 = c2 * s4 - c4 * t9;
        let t221 = c2 * c4 + s4 * t9;
        [t206, t209, t212, t215, t218, t221]
    };
    // frame 5
    let [t224, t227, t230, t233, t236, t239] = {
        let t224 = c5 * t206 - s5 * t197;
        let t227 = c5 * t197 + s5 * t206;
        let t230 = c5 * t212 + s5 * t203;
        let t233 = c5 * t203 - s5 * t212;
        let t236 = c5 * t218 + s5 * t10;
        let t239 = c5 * t10 - s5 * t218;
        [t224, t227, t230, t233, t236, t239]
    };
    // frame 6
    let [t242, t245, t248, t251, t254, t257] = {
        let t242 = c6 * t224 + s6 * t209;
        let t245 = c6 * t209 - s6 * t224;
        let t248 = c6 * t230 + s6 * t215;
        let t251 = c6 * t215 - s6 * t230;
        let t254 = c6 * t236 + s6 * t221;
        let t257 = c6 * t221 - s6 * t236;
        [t242, t245, t248, t251, t254, t257]
    };
    // frame 7
    let [t260, t263, t266, t269, t272, t275] = {
        let t260 = c7 * t242 + s7 * t227;
        let t263 = c7 * t227 - s7 * t242;
        let t266 = c7 * t248 - s7 * t233;
        let t269 = c7 * t233 + s7 * t248;
        let t272 = c7 * t254 - s7 * t239;
        let t275 = c7 * t239 + s7 * t254;
        [t260, t263, t266, t269, t272, t275]
    };
    // in world axes
    {
        let t280 = t163 * t245 + (a7_x * t260 + a7_y * t263);
        let t285 = t163 * t251 + (a7_x * t266 - a7_y * t269);
        let t290 = t163 * t257 + (a7_x * t272 - a7_y * t275);
        let t295 = dw7_x * t260 - t187 * t263 - dw7_z * t245;
        let t300 = dw7_x * t266 + t187 * t269 - dw7_z * t251;
        let t305 = dw7_x * t272 + t187 * t275 - dw7_z * t257;
        put(0, t280);
        put(1, t285);
        put(2, t290);
        put(3, t295);
        put(4, t300);
        put(5, t305);
    }
}
