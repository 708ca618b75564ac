//! Torques from the standard parameters.
//!
//! `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil and Dombre, 9.5.2.
//!
//! 374 multiplications, 378 additions; 7, 7 of 7 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, STANDARD, Trig};

/// Torques from the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], out: &mut [S; 7]) {
    entries(trig, dq, ddq, phi, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6, ddq7] = *ddq;
    let [
        _, _, _, _, _, _, ZZ1, _, _, _, _, MSX2,
        MSY2, MSZ2, XX2, YY2, ZZ2, XY2, XZ2, YZ2, M3, MSX3, MSY3, MSZ3,
        XX3, YY3, ZZ3, XY3, XZ3, YZ3, M4, MSX4, MSY4, MSZ4, XX4, YY4,
        ZZ4, XY4, XZ4, YZ4, M5, MSX5, MSY5, MSZ5, XX5, YY5, ZZ5, XY5,
        XZ5, YZ5, M6, MSX6, MSY6, MSZ6, XX6, YY6, ZZ6, XY6, XZ6, YZ6,
        M7, MSX7, MSY7, MSZ7, XX7, YY7, ZZ7, XY7, XZ7, YZ7, FV1, FV2,
        FV3, FV4, FV5, FV6, FV7, FC1, FC2, FC3, FC4, FC5, FC6, FC7,
        FO1, FO2, FO3, FO4, FO5, FO6, FO7,
        ..] = *phi;
    let A = S::constant(0.0825);
    let L2 = S::constant(0.316);
    let L3 = S::constant(0.384);
    let k0 = S::constant(9.81);
    let k4 = S::constant(0.088);
    // link 2: motion
    let [
        t0, t1, t2, t3, t4, t5, t6, t7,
        t8, dw2_y,
    ] = {
        let t0 = s2 * dq1;
        let t1 = c2 * dq1;
        let t2 = s2 * ddq1;
        let t3 = c2 * ddq1;
        let t4 = s2 * k0;
        let t5 = c2 * k0;
        let t6 = dq2 * t1;
        let t7 = dq2 * t0;
        let t8 = t2 + t6;
        let dw2_y = t7 - t3;
        [
        t0, t1, t2, t3, t4, t5, t6, t7,
        t8, dw2_y,
    ]
    };
    // link 3: motion
    let [
        w3_x, w3_y, t22, t23, t24, t25, t26, t27,
        t29, t30, t35, a3_x, a3_y, w3_z, dw3_x, dw3_y,
        dw3_z,
    ] = {
        let w3_x = s3 * dq2 - c3 * t0;
        let w3_y = c3 * dq2 + s3 * t0;
        let t22 = t0 * t0;
        let t23 = t1 * t1;
        let t24 = dq2 * dq2;
        let t25 = t0 * t1;
        let t26 = t25 - ddq2;
        let t27 = ddq2 + t25;
        let t29 = t7 + dw2_y;
        let t30 = t6 + t8;
        let t33 = L2 * t30;
        let t34 = t4 + L2 * t26;
        let t35 = L2 * (t22 + t24) - t5;
        let a3_x = s3 * t33 - c3 * t34;
        let a3_y = c3 * t33 + s3 * t34;
        let w3_z = t1 + dq3;
        let dw3_x = s3 * ddq2 - c3 * t8 + dq3 * w3_y;
        let dw3_y = c3 * ddq2 + s3 * t8 - dq3 * w3_x;
        let dw3_z = ddq3 - dw2_y;
        [
        w3_x, w3_y, t22, t23, t24, t25, t26, t27,
        t29, t30, t35, a3_x, a3_y, w3_z, dw3_x, dw3_y,
        dw3_z,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t60, t61, t62, t63, t64, t65,
        t66, t67, t68, t69, t70, t71, t72, t73,
        t78, a4_x, a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t60 = w3_x * w3_x;
        let t61 = w3_y * w3_y;
        let t62 = w3_z * w3_z;
        let t63 = w3_x * w3_y;
        let t64 = w3_x * w3_z;
        let t65 = w3_y * w3_z;
        let t66 = t61 + t62;
        let t67 = t63 - dw3_z;
        let t68 = dw3_y + t64;
        let t69 = dw3_z + t63;
        let t70 = t60 + t62;
        let t71 = t65 - dw3_x;
        let t72 = t64 - dw3_y;
        let t73 = dw3_x + t65;
        let t77 = a3_x - A * t66;
        let t78 = a3_y + A * t69;
        let t79 = A * t72 - t35;
        let a4_x = c4 * t77 + s4 * t79;
        let a4_y = c4 * t79 - s4 * t77;
        let w4_z = dq4 - w3_y;
        let dw4_x = c4 * dw3_x + s4 * dw3_z + dq4 * w4_y;
        let dw4_y = c4 * dw3_z - s4 * dw3_x - dq4 * w4_x;
        let dw4_z = ddq4 - dw3_y;
        [
        w4_x, w4_y, t60, t61, t62, t63, t64, t65,
        t66, t67, t68, t69, t70, t71, t72, t73,
        t78, a4_x, a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ]
    };
    // link 5: motion
    let [
        w5_x, t97, t104, t105, t106, t107, t108, t109,
        t110, t111, t112, t113, t114, t115, t116, t117,
        t118, a5_z, a5_x, a6_z, w5_z, dw5_x, t141, dw5_z,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t97 = c5 * w4_z + s5 * w4_x;
        let t104 = w4_x * w4_x;
        let t105 = w4_y * w4_y;
        let t106 = w4_z * w4_z;
        let t107 = w4_x * w4_y;
        let t108 = w4_x * w4_z;
        let t109 = w4_y * w4_z;
        let t110 = t105 + t106;
        let t111 = t107 - dw4_z;
        let t112 = dw4_y + t108;
        let t113 = dw4_z + t107;
        let t114 = t104 + t106;
        let t115 = t109 - dw4_x;
        let t116 = t108 - dw4_y;
        let t117 = dw4_x + t109;
        let t118 = t104 + t105;
        let t128 = a4_x + (A * t110 + L3 * t111);
        let a5_z = a4_y - (A * t113 + L3 * t114);
        let t130 = L3 * t117 - A * t116 - t78;
        let a5_x = c5 * t128 - s5 * t130;
        let a6_z = c5 * t130 + s5 * t128;
        let w5_z = w4_y + dq5;
        let dw5_x = c5 * dw4_x - s5 * dw4_z - dq5 * t97;
        let t141 = c5 * dw4_z + s5 * dw4_x + dq5 * w5_x;
        let dw5_z = dw4_y + ddq5;
        [
        w5_x, t97, t104, t105, t106, t107, t108, t109,
        t110, t111, t112, t113, t114, t115, t116, t117,
        t118, a5_z, a5_x, a6_z, w5_z, dw5_x, t141, dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t155, t156, t157, t158, t159, t160,
        t161, t162, t163, t164, t165, t166, t167, t168,
        t169, a6_x, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t155 = w5_x * w5_x;
        let t156 = t97 * t97;
        let t157 = w5_z * w5_z;
        let t158 = w5_x * t97;
        let t159 = w5_x * w5_z;
        let t160 = t97 * w5_z;
        let t161 = t156 + t157;
        let t162 = dw5_z + t158;
        let t163 = t159 - t141;
        let t164 = dw5_z - t158;
        let t165 = t155 + t157;
        let t166 = dw5_x + t160;
        let t167 = t141 + t159;
        let t168 = dw5_x - t160;
        let t169 = t155 + t156;
        let a6_x = c6 * a5_x + s6 * a5_z;
        let a6_y = c6 * a5_z - s6 * a5_x;
        let w6_z = t97 + dq6;
        let dw6_x = c6 * dw5_x + s6 * dw5_z + dq6 * w6_y;
        let dw6_y = c6 * dw5_z - s6 * dw5_x - dq6 * w6_x;
        let dw6_z = t141 + ddq6;
        [
        w6_x, w6_y, t155, t156, t157, t158, t159, t160,
        t161, t162, t163, t164, t165, t166, t167, t168,
        t169, a6_x, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ]
    };
    // link 7: motion
    let [
        w7_x, w7_y, t194, t195, t196, t197, t198, t199,
        t200, t201, t202, t203, t204, t205, t206, t207,
        t208, t213, a7_x, a7_y, w7_z, dw7_x, dw7_y, dw7_z,
    ] = {
        let w7_x = c7 * w6_x + s7 * w6_z;
        let w7_y = c7 * w6_z - s7 * w6_x;
        let t194 = w6_x * w6_x;
        let t195 = w6_y * w6_y;
        let t196 = w6_z * w6_z;
        let t197 = w6_x * w6_y;
        let t198 = w6_x * w6_z;
        let t199 = w6_y * w6_z;
        let t200 = t195 + t196;
        let t201 = t197 - dw6_z;
        let t202 = dw6_y + t198;
        let t203 = dw6_z + t197;
        let t204 = t194 + t196;
        let t205 = t199 - dw6_x;
        let t206 = t198 - dw6_y;
        let t207 = dw6_x + t199;
        let t208 = t194 + t195;
        let t212 = a6_x - k4 * t200;
        let t213 = a6_y + k4 * t203;
        let t214 = a6_z + k4 * t206;
        let a7_x = c7 * t212 + s7 * t214;
        let a7_y = c7 * t214 - s7 * t212;
        let w7_z = dq7 - w6_y;
        let dw7_x = c7 * dw6_x + s7 * dw6_z + dq7 * w7_y;
        let dw7_y = c7 * dw6_z - s7 * dw6_x - dq7 * w7_x;
        let dw7_z = ddq7 - dw6_y;
        [
        w7_x, w7_y, t194, t195, t196, t197, t198, t199,
        t200, t201, t202, t203, t204, t205, t206, t207,
        t208, t213, a7_x, a7_y, w7_z, dw7_x, dw7_y, dw7_z,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t310, t313, t316, t322, t323] = {
        let t227 = w7_x * w7_x;
        let t228 = w7_y * w7_y;
        let t229 = w7_z * w7_z;
        let t230 = w7_x * w7_y;
        let t231 = w7_x * w7_z;
        let t232 = w7_y * w7_z;
        let t234 = t230 - dw7_z;
        let t235 = dw7_y + t231;
        let t236 = dw7_z + t230;
        let t238 = t232 - dw7_x;
        let t239 = t231 - dw7_y;
        let t240 = dw7_x + t232;
        let t263 = XZ7 * (t229 - t227);
        let t264 = XZ7 * t238;
        let t265 = t232 * (ZZ7 - YY7) + XX7 * dw7_x - XY7 * t239 + XZ7 * t236;
        let t267 = t230 * (YY7 - XX7) + ZZ7 * dw7_z + XY7 * (t227 - t228) - t264;
        let t270 = YZ7 * t234;
        let t273 = t231 * (XX7 - ZZ7) + YY7 * dw7_y + XY7 * t240 + t263 - t270;
        let f7_x = M7 * a7_x + (MSZ7 * t235 + (MSY7 * t234 - MSX7 * (t228 + t229)));
        let f7_y = M7 * a7_y + (MSZ7 * t238 + (MSX7 * t236 - MSY7 * (t227 + t229)));
        let f7_z = MSX7 * t239 + MSY7 * t240 - MSZ7 * (t227 + t228) - M7 * t213;
        let n7_x = t265 + YZ7 * (t228 - t229) - (MSY7 * t213 + MSZ7 * a7_y);
        let n7_y = t273 + (MSZ7 * a7_x + MSX7 * t213);
        let n7_z = t267 + YZ7 * t235 + (MSX7 * a7_y - MSY7 * a7_x);
        let t310 = c7 * f7_x - s7 * f7_y;
        let t313 = s7 * f7_x + c7 * f7_y;
        let t316 = c7 * n7_x - s7 * n7_y;
        let t322 = s7 * n7_x + c7 * n7_y - k4 * f7_z;
        let t323 = n7_z + k4 * t313;
        [f7_z, n7_z, t310, t313, t316, t322, t323]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t398, t401, t404, t407] = {
        let t345 = XZ6 * (t196 - t194);
        let t346 = XZ6 * t205;
        let t347 = t199 * (ZZ6 - YY6) + XX6 * dw6_x - XY6 * t206 + XZ6 * t203;
        let t349 = t197 * (YY6 - XX6) + ZZ6 * dw6_z + XY6 * (t194 - t195) - t346;
        let t352 = YZ6 * t201;
        let t355 = t198 * (XX6 - ZZ6) + YY6 * dw6_y + XY6 * t207 + t345 - t352;
        let f6_x = t310 + (M6 * a6_x + (MSZ6 * t202 + (MSY6 * t201 - MSX6 * t200)));
        let f6_y = M6 * a6_y + (MSZ6 * t205 + (MSX6 * t203 - MSY6 * t204)) - f7_z;
        let f6_z = t313 + (M6 * a6_z + (MSX6 * t206 + MSY6 * t207 - MSZ6 * t208));
        let n6_x = t316 + (t347 + YZ6 * (t195 - t196) + (MSY6 * a6_z - MSZ6 * a6_y));
        let n6_y = t355 + (MSZ6 * a6_x - MSX6 * a6_z) - t323;
        let n6_z = t322 + (t349 + YZ6 * t202 + (MSX6 * a6_y - MSY6 * a6_x));
        let t398 = c6 * f6_x - s6 * f6_y;
        let t401 = s6 * f6_x + c6 * f6_y;
        let t404 = c6 * n6_x - s6 * n6_y;
        let t407 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t398, t401, t404, t407]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t482, t485, t497, t498, t499] = {
        let t429 = XZ5 * (t157 - t155);
        let t430 = XZ5 * t166;
        let t431 = XX5 * dw5_x - t160 * (ZZ5 - YY5) - XY5 * t167 + XZ5 * t164;
        let t433 = ZZ5 * dw5_z - t158 * (YY5 - XX5) + XY5 * (t155 - t156) + t430;
        let t436 = YZ5 * t162;
        let t439 = t159 * (XX5 - ZZ5) - YY5 * t141 + XY5 * t168 + t429 + t436;
        let f5_x = t398 + (M5 * a5_x + (MSZ5 * t163 - (MSX5 * t161 + MSY5 * t162)));
        let f5_y = MSX5 * t164 - MSY5 * t165 - MSZ5 * t166 - M5 * a6_z - f6_z;
        let f5_z = t401 + (M5 * a5_z + (MSX5 * t167 + MSY5 * t168 - MSZ5 * t169));
        let n5_x = t404 + (t431 + YZ5 * (t156 - t157) + (MSY5 * a5_z + MSZ5 * a6_z));
        let n5_y = t439 + (MSZ5 * a5_x - MSX5 * a5_z) - n6_z;
        let n5_z = t407 + (t433 + YZ5 * t163 - (MSX5 * a6_z + MSY5 * a5_x));
        let t482 = c5 * f5_x - s5 * f5_y;
        let t485 = s5 * f5_x + c5 * f5_y;
        let t497 = c5 * n5_x - s5 * n5_y - L3 * t485;
        let t498 = s5 * n5_x + c5 * n5_y + (L3 * t482 + A * f5_z);
        let t499 = n5_z - A * t485;
        [f5_z, n5_z, t482, t485, t497, t498, t499]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t574, t580, t586, t587] = {
        let t521 = XZ4 * (t106 - t104);
        let t522 = XZ4 * t115;
        let t523 = t109 * (ZZ4 - YY4) + XX4 * dw4_x - XY4 * t116 + XZ4 * t113;
        let t525 = t107 * (YY4 - XX4) + ZZ4 * dw4_z + XY4 * (t104 - t105) - t522;
        let t528 = YZ4 * t111;
        let t531 = t108 * (XX4 - ZZ4) + YY4 * dw4_y + XY4 * t117 + t521 - t528;
        let f4_x = t482 + (M4 * a4_x + (MSZ4 * t112 + (MSY4 * t111 - MSX4 * t110)));
        let f4_y = f5_z + (M4 * a4_y + (MSZ4 * t115 + (MSX4 * t113 - MSY4 * t114)));
        let f4_z = MSX4 * t116 + MSY4 * t117 - MSZ4 * t118 - M4 * t78 - t485;
        let n4_x = t497 + (t523 + YZ4 * (t105 - t106) - (MSY4 * t78 + MSZ4 * a4_y));
        let n4_y = t499 + (t531 + (MSZ4 * a4_x + MSX4 * t78));
        let n4_z = t525 + YZ4 * t112 + (MSX4 * a4_y - MSY4 * a4_x) - t498;
        let t574 = c4 * f4_x - s4 * f4_y;
        let t580 = c4 * n4_x - s4 * n4_y;
        let t586 = s4 * n4_x + c4 * n4_y - A * f4_z;
        let t587 = n4_z + A * (s4 * f4_x + c4 * f4_y);
        [f4_z, n4_z, t574, t580, t586, t587]
    };
    // link 3: force and moment
    let [n3_z, t666, t667] = {
        let t609 = XZ3 * (t62 - t60);
        let t610 = XZ3 * t71;
        let t611 = t65 * (ZZ3 - YY3) + XX3 * dw3_x - XY3 * t72 + XZ3 * t69;
        let t613 = t63 * (YY3 - XX3) + ZZ3 * dw3_z + XY3 * (t60 - t61) - t610;
        let t616 = YZ3 * t67;
        let t619 = t64 * (XX3 - ZZ3) + YY3 * dw3_y + XY3 * t73 + t609 - t616;
        let f3_x = t574 + (M3 * a3_x + (MSZ3 * t68 + (MSY3 * t67 - MSX3 * t66)));
        let f3_y = M3 * a3_y + (MSZ3 * t71 + (MSX3 * t69 - MSY3 * t70)) - f4_z;
        let n3_x = t580 + (t611 + YZ3 * (t61 - t62) - (MSY3 * t35 + MSZ3 * a3_y));
        let n3_y = t619 + (MSZ3 * a3_x + MSX3 * t35) - t587;
        let n3_z = t586 + (t613 + YZ3 * t68 + (MSX3 * a3_y - MSY3 * a3_x));
        let t666 = c3 * n3_x - s3 * n3_y - L2 * (s3 * f3_x + c3 * f3_y);
        let t667 = s3 * n3_x + c3 * n3_y + L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, t666, t667]
    };
    // link 2: force and moment
    let [n2_z, t714] = {
        let t689 = XZ2 * (t24 - t22);
        let t690 = XZ2 * t2;
        let t691 = XY2 * t29 - (t6 * (ZZ2 - YY2) + XX2 * t8) + XZ2 * t27;
        let t693 = t25 * (YY2 - XX2) + ZZ2 * ddq2 + XY2 * (t22 - t23) - t690;
        let t696 = YZ2 * t26;
        let t699 = YY2 * dw2_y - t7 * (XX2 - ZZ2) - XY2 * t30 + t689 - t696;
        let n2_x = t666 + (t691 + YZ2 * (t23 - t24) + MSZ2 * t5);
        let n2_y = t699 - MSZ2 * t4 - n3_z;
        let n2_z = t667 + (t693 - YZ2 * t3 + (MSY2 * t4 - MSX2 * t5));
        let t714 = s2 * n2_x + c2 * n2_y;
        [n2_z, t714]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = ZZ1 * ddq1 - t714;
        n1_z
    };
    // drives
    {
        let t752 = FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t753 = FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t754 = FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign());
        let t755 = FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign());
        let t756 = FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign());
        let t757 = FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign());
        let t758 = FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign());
        put(0, t752);
        put(1, t753);
        put(2, t754);
        put(3, t755);
        put(4, t756);
        put(5, t757);
        put(6, t758);
    }
}
