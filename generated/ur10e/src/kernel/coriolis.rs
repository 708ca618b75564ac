//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 247 multiplications, 223 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, Trig};

/// Coriolis and centrifugal torques `C dq`: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], out: &mut [S; 6]) {
    entries(trig, dq, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [
        _, _, _, XX2R, ZZ2R, XY2, XZ2R, YZ2, MSX3R, MSY3, XX3R, ZZ3R,
        XY3, XZ3R, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        ..] = *beta;
    let D4 = S::constant(0.17415);
    let D5 = S::constant(0.11985);
    let D6 = S::constant(0.11655);
    let k0 = S::constant(0.6127);
    let k1 = S::constant(0.57155);
    // link 2: motion
    let [w2_x, w2_y, dw2_x, t3] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let dw2_x = dq2 * w2_y;
        let t3 = dq2 * w2_x;
        [w2_x, w2_y, dw2_x, t3]
    };
    // link 3: motion
    let [
        w3_x, w3_y, t16, t17, t18, t19, t21, t22,
        t25, a3_x, t31, w3_z, dw3_x, t36,
    ] = {
        let w3_x = c3 * w2_x + s3 * w2_y;
        let w3_y = c3 * w2_y - s3 * w2_x;
        let t16 = w2_x * w2_x;
        let t17 = w2_y * w2_y;
        let t18 = dq2 * dq2;
        let t19 = w2_x * w2_y;
        let t21 = t3 + t3;
        let t22 = dw2_x + dw2_x;
        let t23 = (t17 + t18) * k0;
        let t24 = t19 * k0;
        let t25 = t21 * k0;
        let a3_x = c3 * t23 - s3 * t24;
        let t31 = c3 * t24 + s3 * t23;
        let w3_z = dq2 + dq3;
        let dw3_x = c3 * dw2_x - s3 * t3 + dq3 * w3_y;
        let t36 = c3 * t3 + s3 * dw2_x + dq3 * w3_x;
        [
        w3_x, w3_y, t16, t17, t18, t19, t21, t22,
        t25, a3_x, t31, w3_z, dw3_x, t36,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t49, t50, t51, t52, t53, t54,
        t55, t56, t57, t58, t59, t60, t73, a4_x,
        a4_y, w4_z, dw4_x, dw5_z,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_y;
        let w4_y = c4 * w3_y - s4 * w3_x;
        let t49 = w3_x * w3_x;
        let t50 = w3_y * w3_y;
        let t51 = w3_z * w3_z;
        let t52 = w3_x * w3_y;
        let t53 = w3_x * w3_z;
        let t54 = w3_y * w3_z;
        let t55 = t50 + t51;
        let t56 = t53 - t36;
        let t57 = t49 + t51;
        let t58 = t54 - dw3_x;
        let t59 = t36 + t53;
        let t60 = dw3_x + t54;
        let t71 = a3_x + (t55 * k1 + D4 * t56);
        let t72 = D4 * t58 - t52 * k1 - t31;
        let t73 = t25 + (t59 * k1 + D4 * (t49 + t50));
        let a4_x = c4 * t71 + s4 * t72;
        let a4_y = c4 * t72 - s4 * t71;
        let w4_z = w3_z + dq4;
        let dw4_x = c4 * dw3_x - s4 * t36 + dq4 * w4_y;
        let dw5_z = c4 * t36 + s4 * dw3_x + dq4 * w4_x;
        [
        w4_x, w4_y, t49, t50, t51, t52, t53, t54,
        t55, t56, t57, t58, t59, t60, t73, a4_x,
        a4_y, w4_z, dw4_x, dw5_z,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t93, t94, t95, t96, t97, t98,
        t99, t100, t101, t102, t103, t104, t109, a5_x,
        t116, w5_z, dw5_x, t121,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t93 = w4_x * w4_x;
        let t94 = w4_y * w4_y;
        let t95 = w4_z * w4_z;
        let t96 = w4_x * w4_y;
        let t97 = w4_x * w4_z;
        let t98 = w4_y * w4_z;
        let t99 = t94 + t95;
        let t100 = t97 - dw5_z;
        let t101 = t93 + t95;
        let t102 = t98 - dw4_x;
        let t103 = dw5_z + t97;
        let t104 = dw4_x + t98;
        let t108 = a4_x - D5 * t96;
        let t109 = a4_y + D5 * t101;
        let t110 = t73 + D5 * t104;
        let a5_x = c5 * t108 - s5 * t110;
        let t116 = c5 * t110 + s5 * t108;
        let w5_z = dq5 - w4_y;
        let dw5_x = c5 * dw4_x + dq5 * w5_y;
        let t121 = s5 * dw4_x + dq5 * w5_x;
        [
        w5_x, w5_y, t93, t94, t95, t96, t97, t98,
        t99, t100, t101, t102, t103, t104, t109, a5_x,
        t116, w5_z, dw5_x, t121,
    ]
    };
    // link 6: motion
    let [
        w6_x, t127, t134, t135, t136, t137, t138, t139,
        t140, t141, t142, t143, t144, t145, t146, t147,
        t152, a6_x, t159, w6_z, dw6_x, t164,
    ] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t127 = c6 * w5_z + s6 * w5_x;
        let t134 = w5_x * w5_x;
        let t135 = w5_y * w5_y;
        let t136 = w5_z * w5_z;
        let t137 = w5_x * w5_y;
        let t138 = w5_x * w5_z;
        let t139 = w5_y * w5_z;
        let t140 = t135 + t136;
        let t141 = t137 - dw5_z;
        let t142 = t138 - t121;
        let t143 = dw5_z + t137;
        let t144 = t134 + t136;
        let t145 = t139 - dw5_x;
        let t146 = t121 + t138;
        let t147 = dw5_x + t139;
        let t151 = a5_x + D6 * t141;
        let t152 = t116 + D6 * t144;
        let t153 = D6 * t147 - t109;
        let a6_x = c6 * t151 - s6 * t153;
        let t159 = c6 * t153 + s6 * t151;
        let w6_z = w5_y + dq6;
        let dw6_x = c6 * dw5_x - s6 * dw5_z - dq6 * t127;
        let t164 = c6 * dw5_z + s6 * dw5_x + dq6 * w6_x;
        [
        w6_x, t127, t134, t135, t136, t137, t138, t139,
        t140, t141, t142, t143, t144, t145, t146, t147,
        t152, a6_x, t159, w6_z, dw6_x, t164,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t227, t230, t239, t240] = {
        let t165 = w6_x * w6_x;
        let t166 = t127 * t127;
        let t167 = w6_z * w6_z;
        let t168 = w6_x * t127;
        let t169 = w6_x * w6_z;
        let t170 = t127 * w6_z;
        let t172 = t121 - t168;
        let t174 = t121 + t168;
        let t177 = t164 + t169;
        let t178 = dw6_x - t170;
        let t197 = XZ6 * (dw6_x + t170);
        let t202 = YZ6 * (t166 - t167);
        let t203 = YZ6 * t172;
        let t204 = YZ6 * (t169 - t164);
        let t205 = XX6R * dw6_x - ZZ6 * t170 - XY6 * t177 - XZ6 * t174 + t202;
        let t206 = t169 * (XX6R - ZZ6) + XY6 * t178 + XZ6 * (t167 - t165) - t203;
        let t207 = XX6R * t168 - ZZ6 * t121 + XY6 * (t165 - t166) + t197 + t204;
        let f6_x = MSY6 * t172 - MSX6 * (t166 + t167);
        let t213 = MSX6 * t174 + MSY6 * (t165 + t167);
        let f6_z = MSX6 * t177 + MSY6 * t178;
        let n6_x = t205 - MSY6 * t152;
        let n6_y = t206 + MSX6 * t152;
        let n6_z = t207 - (MSX6 * t159 + MSY6 * a6_x);
        let t227 = c6 * f6_x + s6 * t213;
        let t230 = s6 * f6_x - c6 * t213;
        let t239 = c6 * n6_x - s6 * n6_y - D6 * t230;
        let t240 = s6 * n6_x + c6 * n6_y + D6 * t227;
        put(5, n6_z);
        [f6_z, n6_z, t227, t230, t239, t240]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t295, t298, t307, t308] = {
        let t262 = ZZ5R * dw5_z - XX5R * t137 + XY5 * (t134 - t135) - XZ5 * t145;
        let t264 = YZ5 * (t135 - t136);
        let t265 = YZ5 * t141;
        let t267 = ZZ5R * t139 + XX5R * dw5_x - XY5 * t146 + XZ5 * t143 + t264;
        let t268 = t138 * (XX5R - ZZ5R) + XY5 * t147 + XZ5 * (t136 - t134) - t265;
        let f5_x = t227 + (MSY5R * t141 - MSX5 * t140);
        let f5_y = f6_z + (MSX5 * t143 - MSY5R * t144);
        let f5_z = MSX5 * t146 + MSY5R * t147 - t230;
        let n5_x = t239 + (t267 - MSY5R * t109);
        let n5_y = n6_z + (t268 + MSX5 * t109);
        let n5_z = t262 + YZ5 * t142 - (MSX5 * t116 + MSY5R * a5_x) - t240;
        let t295 = c5 * f5_x - s5 * f5_y;
        let t298 = s5 * f5_x + c5 * f5_y;
        let t307 = c5 * n5_x - s5 * n5_y - D5 * t298;
        let t308 = s5 * n5_x + c5 * n5_y + D5 * t295;
        put(4, n5_z);
        [f5_z, n5_z, t295, t298, t307, t308]
    };
    // link 4: force and moment
    let [f4_z, t361, t364, t376, t377, t378] = {
        let t330 = YZ4 * (t94 - t95);
        let t331 = YZ4 * t96;
        let t333 = ZZ4R * t98 + XX4R * dw4_x - XY4 * t103 + XZ4 * t96 + t330;
        let t334 = t97 * (XX4R - ZZ4R) + XY4 * t104 + XZ4 * (t95 - t93) - t331;
        let t335 = XY4 * (t93 - t94) - XX4R * t96 - XZ4 * t102 + YZ4 * t100;
        let f4_x = t295 + (MSY4R * t96 - MSX4 * t99);
        let f4_y = MSX4 * t96 - MSY4R * t101 - f5_z;
        let f4_z = t298 + (MSX4 * t103 + MSY4R * t104);
        let n4_x = t307 + (t333 - MSY4R * t73);
        let n4_y = t334 + MSX4 * t73 - n5_z;
        let n4_z = t308 + (t335 + (MSX4 * a4_y - MSY4R * a4_x));
        let t361 = c4 * f4_x - s4 * f4_y;
        let t364 = s4 * f4_x + c4 * f4_y;
        let t376 = c4 * n4_x - s4 * n4_y - D4 * t364;
        let t377 = s4 * n4_x + c4 * n4_y + (D4 * t361 + k1 * f4_z);
        let t378 = n4_z - k1 * t364;
        put(3, n4_z);
        [f4_z, t361, t364, t376, t377, t378]
    };
    // link 3: force and moment
    let [t434, t440, t441] = {
        let t400 = YZ3 * (t50 - t51);
        let t401 = YZ3 * t52;
        let t403 = ZZ3R * t54 + XX3R * dw3_x - XY3 * t59 + XZ3R * t52 + t400;
        let t404 = t53 * (XX3R - ZZ3R) + XY3 * t60 + XZ3R * (t51 - t49) - t401;
        let t405 = XY3 * (t49 - t50) - XX3R * t52 - XZ3R * t58 + YZ3 * t56;
        let f3_x = t361 + (MSY3 * t52 - MSX3R * t55);
        let f3_y = t364 + (MSX3R * t52 - MSY3 * t57);
        let f3_z = f4_z + (MSX3R * t59 + MSY3 * t60);
        let n3_x = t376 + (t403 - MSY3 * t25);
        let n3_y = t377 + (t404 + MSX3R * t25);
        let n3_z = t378 + (t405 - (MSX3R * t31 + MSY3 * a3_x));
        let t434 = c3 * n3_x - s3 * n3_y;
        let t440 = s3 * n3_x + c3 * n3_y + k0 * f3_z;
        let t441 = n3_z - k0 * (s3 * f3_x + c3 * f3_y);
        put(2, n3_z);
        [t434, t440, t441]
    };
    // link 2: force and moment
    {
        let t460 = YZ2 * (t17 - t18);
        let t461 = YZ2 * t19;
        let t463 = t3 * (XX2R - ZZ2R) + XY2 * t22 + XZ2R * (t18 - t16) - t461;
        let n2_x = t434 + (dw2_x * (XX2R + ZZ2R) - XY2 * t21 + XZ2R * t19 + t460);
        let n2_y = t440 + t463;
        let n2_z = t441 + (XY2 * (t16 - t17) - XX2R * t19);
        let n1_z = s2 * n2_x + c2 * n2_y;
        put(0, n1_z);
        put(1, n2_z);
    }
}
