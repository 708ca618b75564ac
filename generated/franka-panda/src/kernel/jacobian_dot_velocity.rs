//! Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq`.
//!
//! In base axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
//!
//! 184 multiplications, 122 additions; 6, 6 of 6 structurally nonzero.

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
        w3_x, w3_y, t16, a3_x, a3_y, w3_z, dw3_y, t39,
        t40, t41, t42, t43, t44,
    ] = {
        let w3_x = s3 * dq2 - c3 * t0;
        let w3_y = c3 * dq2 + s3 * t0;
        let t15 = L2 * t4;
        let t16 = L2 * t7;
        let t17 = L2 * t8;
        let a3_x = s3 * t17 - c3 * t15;
        let a3_y = c3 * t17 + s3 * t15;
        let w3_z = t1 + dq3;
        let t31 = w3_x * w3_x;
        let t32 = w3_z * w3_z;
        let t33 = w3_x * w3_y;
        let t34 = w3_x * w3_z;
        let t35 = w3_y * w3_z;
        let dw3_x = t35 - (c3 * t8 + s3 * t4);
        let dw3_y = s3 * t8 - c3 * t4 - t34;
        let t39 = t31 - t32 - t7;
        let t40 = dw2_y + t33;
        let t41 = t33 - dw2_y;
        let t42 = t31 + t32;
        let t43 = t34 - dw3_y;
        let t44 = t35 + dw3_x;
        [
        w3_x, w3_y, t16, a3_x, a3_y, w3_z, dw3_y, t39,
        t40, t41, t42, t43, t44,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t55, a4_x, a4_y, w4_z, t76, t78,
        t79, t80, t81, t82, t83,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t54 = a3_x + A * t39;
        let t55 = a3_y + A * t41;
        let t56 = A * t43 - t16;
        let a4_x = c4 * t54 + s4 * t56;
        let a4_y = c4 * t56 - s4 * t54;
        let w4_z = dq4 - w3_y;
        let t70 = w4_x * w4_x;
        let t71 = w4_z * w4_z;
        let t72 = w4_x * w4_y;
        let t73 = w4_x * w4_z;
        let t74 = w4_y * w4_z;
        let dw4_x = t74 - (s4 * t40 - c4 * t44);
        let t76 = c4 * t40 + s4 * t44 + t73;
        let t78 = t70 - t71 - t42;
        let t79 = dw3_y + t72;
        let t80 = t72 - dw3_y;
        let t81 = t70 + t71;
        let t82 = t73 + t76;
        let t83 = t74 + dw4_x;
        [
        w4_x, w4_y, t55, a4_x, a4_y, w4_z, t76, t78,
        t79, t80, t81, t82, t83,
    ]
    };
    // link 5: motion
    let [
        w5_x, t89, a5_z, a5_x, a6_z, w5_z, dw5_y, t122,
        t123, t124,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t89 = c5 * w4_z + s5 * w4_x;
        let t99 = a4_x + (L3 * t79 - A * t78);
        let a5_z = a4_y - (A * t80 + L3 * t81);
        let t101 = L3 * t83 - A * t82 - t55;
        let a5_x = c5 * t99 - s5 * t101;
        let a6_z = c5 * t101 + s5 * t99;
        let w5_z = w4_y + dq5;
        let t119 = t89 * w5_z;
        let dw5_x = c5 * t83 + s5 * t79 - t119;
        let dw5_y = c5 * t79 - s5 * t83 - w5_x * w5_z;
        let t122 = t76 - w5_x * t89;
        let t123 = w5_x * w5_x + w5_z * w5_z;
        let t124 = dw5_x - t119;
        [
        w5_x, t89, a5_z, a5_x, a6_z, w5_z, dw5_y, t122,
        t123, t124,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, a6_x, a6_y, w6_z, dw7_z, t152, t153,
        t154, t155, t156,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let a6_x = c6 * a5_x + s6 * a5_z;
        let a6_y = c6 * a5_z - s6 * a5_x;
        let w6_z = t89 + dq6;
        let t146 = w6_x * w6_y;
        let t147 = w6_x * w6_z;
        let t148 = w6_y * w6_z;
        let dw6_x = t148 - (s6 * t122 - c6 * t124);
        let dw7_z = c6 * t122 + s6 * t124 + t147;
        let t152 = w6_x * w6_x - w6_z * w6_z - t123;
        let t153 = dw5_y + t146;
        let t154 = t146 - dw5_y;
        let t155 = t147 + dw7_z;
        let t156 = t148 + dw6_x;
        [
        w6_x, w6_y, a6_x, a6_y, w6_z, dw7_z, t152, t153,
        t154, t155, t156,
    ]
    };
    // link 7: motion
    let [t167, a7_x, a7_y, dw7_x, t185] = {
        let w7_x = c7 * w6_x + s7 * w6_z;
        let w7_y = c7 * w6_z - s7 * w6_x;
        let t166 = a6_x + k3 * t152;
        let t167 = a6_y + k3 * t154;
        let t168 = a6_z + k3 * t155;
        let a7_x = c7 * t166 + s7 * t168;
        let a7_y = c7 * t168 - s7 * t166;
        let w7_z = dq7 - w6_y;
        let dw7_x = w7_y * w7_z - (s7 * t153 - c7 * t156);
        let t185 = c7 * t153 + s7 * t156 + w7_x * w7_z;
        [t167, a7_x, a7_y, dw7_x, t185]
    };
    // frame 2
    let [t186, t187, t188, t189] = {
        let t186 = c1 * c2;
        let t187 = c1 * s2;
        let t188 = s1 * c2;
        let t189 = s1 * s2;
        [t186, t187, t188, t189]
    };
    // frame 3
    let [t192, t195, t198, t201, t202, t203] = {
        let t192 = c3 * t186 - s1 * s3;
        let t195 = s1 * c3 + s3 * t186;
        let t198 = c3 * t188 + c1 * s3;
        let t201 = c1 * c3 - s3 * t188;
        let t202 = s2 * c3;
        let t203 = s2 * s3;
        [t192, t195, t198, t201, t202, t203]
    };
    // frame 4
    let [t206, t209, t212, t215, t218, t221] = {
        let t206 = c4 * t192 + s4 * t187;
        let t209 = c4 * t187 - s4 * t192;
        let t212 = c4 * t198 + s4 * t189;
        let t215 = c4 * t189 - s4 * t198;
        let t218 = c2 * s4 - c4 * t202;
        let t221 = c2 * c4 + s4 * t202;
        [t206, t209, t212, t215, t218, t221]
    };
    // frame 5
    let [t224, t227, t230, t233, t236, t239] = {
        let t224 = c5 * t206 - s5 * t195;
        let t227 = c5 * t195 + s5 * t206;
        let t230 = c5 * t212 + s5 * t201;
        let t233 = c5 * t201 - s5 * t212;
        let t236 = c5 * t218 + s5 * t203;
        let t239 = c5 * t203 - s5 * t218;
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
    // in base axes
    {
        let t280 = t167 * t245 + (a7_x * t260 + a7_y * t263);
        let t285 = t167 * t251 + (a7_x * t266 - a7_y * t269);
        let t290 = t167 * t257 + (a7_x * t272 - a7_y * t275);
        let t295 = dw7_x * t260 - t185 * t263 - dw7_z * t245;
        let t300 = dw7_x * t266 + t185 * t269 - dw7_z * t251;
        let t305 = dw7_x * t272 + t185 * t275 - dw7_z * t257;
        put(0, t280);
        put(1, t285);
        put(2, t290);
        put(3, t295);
        put(4, t300);
        put(5, t305);
    }
}
