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
    // frame 2
    let [t9, t10, t11, t12] = {
        let t9 = c1 * c2;
        let t10 = c1 * s2;
        let t11 = s1 * c2;
        let t12 = s1 * s2;
        [t9, t10, t11, t12]
    };
    // frame 3
    let [t15, t18, t21, t24] = {
        let t15 = c3 * t9 - s1 * s3;
        let t18 = s1 * c3 + s3 * t9;
        let t21 = c3 * t11 + c1 * s3;
        let t24 = c1 * c3 - s3 * t11;
        [t15, t18, t21, t24]
    };
    // link 3: motion
    let [
        t25, t26, t28, a3_x, a3_y, w3_x, w3_y, w3_z,
        dw3_y, t57, t58, t59, t60, t61, t62,
    ] = {
        let t25 = s2 * c3;
        let t26 = s2 * s3;
        let t27 = L2 * t4;
        let t28 = L2 * t7;
        let t29 = L2 * t8;
        let a3_x = s3 * t29 - c3 * t27;
        let a3_y = c3 * t29 + s3 * t27;
        let w3_x = s3 * dq2 - c3 * t0;
        let w3_y = c3 * dq2 + s3 * t0;
        let w3_z = t1 + dq3;
        let t49 = w3_x * w3_x;
        let t50 = w3_z * w3_z;
        let t51 = w3_x * w3_y;
        let t52 = w3_x * w3_z;
        let t53 = w3_y * w3_z;
        let dw3_x = t53 - (c3 * t8 + s3 * t4);
        let dw3_y = s3 * t8 - c3 * t4 - t52;
        let t57 = t49 - t50 - t7;
        let t58 = dw2_y + t51;
        let t59 = t51 - dw2_y;
        let t60 = t49 + t50;
        let t61 = t52 - dw3_y;
        let t62 = t53 + dw3_x;
        [
        t25, t26, t28, a3_x, a3_y, w3_x, w3_y, w3_z,
        dw3_y, t57, t58, t59, t60, t61, t62,
    ]
    };
    // link 4: motion
    let [
        t67, a4_x, a4_y, w4_x, w4_y, w4_z, t94, t96,
        t97, t98, t99, t100, t101,
    ] = {
        let t66 = a3_x + A * t57;
        let t67 = a3_y + A * t59;
        let t68 = A * t61 - t28;
        let a4_x = c4 * t66 + s4 * t68;
        let a4_y = c4 * t68 - s4 * t66;
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let w4_z = dq4 - w3_y;
        let t88 = w4_x * w4_x;
        let t89 = w4_z * w4_z;
        let t90 = w4_x * w4_y;
        let t91 = w4_x * w4_z;
        let t92 = w4_y * w4_z;
        let dw4_x = t92 - (s4 * t58 - c4 * t62);
        let t94 = c4 * t58 + s4 * t62 + t91;
        let t96 = t88 - t89 - t60;
        let t97 = dw3_y + t90;
        let t98 = t90 - dw3_y;
        let t99 = t88 + t89;
        let t100 = t91 + t94;
        let t101 = t92 + dw4_x;
        [
        t67, a4_x, a4_y, w4_x, w4_y, w4_z, t94, t96,
        t97, t98, t99, t100, t101,
    ]
    };
    // link 5: motion
    let [
        a5_z, a5_x, a6_z, w5_x, t125, w5_z, dw5_y, t140,
        t141, t142,
    ] = {
        let t111 = a4_x + (L3 * t97 - A * t96);
        let a5_z = a4_y - (A * t98 + L3 * t99);
        let t113 = L3 * t101 - A * t100 - t67;
        let a5_x = c5 * t111 - s5 * t113;
        let a6_z = c5 * t113 + s5 * t111;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t125 = c5 * w4_z + s5 * w4_x;
        let w5_z = w4_y + dq5;
        let t137 = t125 * w5_z;
        let dw5_x = c5 * t101 + s5 * t97 - t137;
        let dw5_y = c5 * t97 - s5 * t101 - w5_x * w5_z;
        let t140 = t94 - w5_x * t125;
        let t141 = w5_x * w5_x + w5_z * w5_z;
        let t142 = dw5_x - t137;
        [
        a5_z, a5_x, a6_z, w5_x, t125, w5_z, dw5_y, t140,
        t141, t142,
    ]
    };
    // link 6: motion
    let [
        a6_x, a6_y, w6_x, w6_y, w6_z, dw7_z, t170, t171,
        t172, t173, t174,
    ] = {
        let a6_x = c6 * a5_x + s6 * a5_z;
        let a6_y = c6 * a5_z - s6 * a5_x;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let w6_z = t125 + dq6;
        let t164 = w6_x * w6_y;
        let t165 = w6_x * w6_z;
        let t166 = w6_y * w6_z;
        let dw6_x = t166 - (s6 * t140 - c6 * t142);
        let dw7_z = c6 * t140 + s6 * t142 + t165;
        let t170 = w6_x * w6_x - w6_z * w6_z - t141;
        let t171 = dw5_y + t164;
        let t172 = t164 - dw5_y;
        let t173 = t165 + dw7_z;
        let t174 = t166 + dw6_x;
        [
        a6_x, a6_y, w6_x, w6_y, w6_z, dw7_z, t170, t171,
        t172, t173, t174,
    ]
    };
    // link 7: motion
    let [t179, a7_x, a7_y, dw7_x, t203] = {
        let t178 = a6_x + k3 * t170;
        let t179 = a6_y + k3 * t172;
        let t180 = a6_z + k3 * t173;
        let a7_x = c7 * t178 + s7 * t180;
        let a7_y = c7 * t180 - s7 * t178;
        let w7_x = c7 * w6_x + s7 * w6_z;
        let w7_y = c7 * w6_z - s7 * w6_x;
        let w7_z = dq7 - w6_y;
        let dw7_x = w7_y * w7_z - (s7 * t171 - c7 * t174);
        let t203 = c7 * t171 + s7 * t174 + w7_x * w7_z;
        [t179, a7_x, a7_y, dw7_x, t203]
    };
    // frame 4
    let [t206, t209, t212, t215, t218, t221] = {
        let t206 = c4 * t15 + s4 * t10;
        let t209 = c4 * t10 - s4 * t15;
        let t212 = c4 * t21 + s4 * t12;
        let t215 = c4 * t12 - s4 * t21;
        let t218 = c2 * s4 - c4 * t25;
        let t221 = c2 * c4 + s4 * t25;
        [t206, t209, t212, t215, t218, t221]
    };
    // frame 5
    let [t224, t227, t230, t233, t236, t239] = {
        let t224 = c5 * t206 - s5 * t18;
        let t227 = c5 * t18 + s5 * t206;
        let t230 = c5 * t212 + s5 * t24;
        let t233 = c5 * t24 - s5 * t212;
        let t236 = c5 * t218 + s5 * t26;
        let t239 = c5 * t26 - s5 * t218;
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
        let t280 = t179 * t245 + (a7_x * t260 + a7_y * t263);
        let t285 = t179 * t251 + (a7_x * t266 - a7_y * t269);
        let t290 = t179 * t257 + (a7_x * t272 - a7_y * t275);
        let t295 = dw7_x * t260 - t203 * t263 - dw7_z * t245;
        let t300 = dw7_x * t266 + t203 * t269 - dw7_z * t251;
        let t305 = dw7_x * t272 + t203 * t275 - dw7_z * t257;
        put(0, t280);
        put(1, t285);
        put(2, t290);
        put(3, t295);
        put(4, t300);
        put(5, t305);
    }
}
