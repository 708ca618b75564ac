//! Accelerations under given torques.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` in
//! closed form.
//!
//! 552 multiplications, 454 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, GRAVITY, Trig, constants};

/// Accelerations under given torques: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE], out: &mut [S; 6]) {
    entries(trig, dq, tau, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [tau1, tau2, tau3, tau4, tau5, tau6] = *tau;
    let [
        ZZ1R, MSX2R, MSY2, XX2R, ZZ2R, XY2, XZ2R, YZ2, MSX3R, MSY3R, XX3R, ZZ3R,
        XY3R, XZ3, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        IA3, IA4, IA5, IA6, FV1, FV2, FV3, FV4, FV5, FV6, FC1, FC2,
        FC3, FC4, FC5, FC6,
        ..] = *beta;
    let k1 = S::constant(-constants::A3);
    let k2 = S::constant(-constants::D3);
    let k5 = S::constant(-GRAVITY[2]);
    let k6 = S::constant(1.0);
    let k_A2 = S::constant(constants::A2);
    let k_D2 = S::constant(constants::D2);
    let k_D4 = S::constant(constants::D4);
    // composite body 6
    let [
        t0, t3, t6, t9, t12, t16, t19, t20,
        t39, t60, t68, t77, t80, t83,
    ] = {
        let t0 = ZZ6 + IA6;
        let t3 = c6 * MSY6 + s6 * MSX6;
        let t6 = c6 * MSX6 - s6 * MSY6;
        let t9 = c6 * XZ6 - s6 * YZ6;
        let t12 = s6 * XZ6 + c6 * YZ6;
        let t13 = c5 * t3;
        let t14 = s5 * t3;
        let t16 = s5 * ZZ6;
        let t17 = c5 * t9 + t16;
        let t19 = c5 * ZZ6;
        let t20 = s5 * t9 - t19;
        let t23 = c4 * t13 + s4 * t6;
        let t26 = c4 * t6 - s4 * t13;
        let t38 = c4 * t17 - s4 * t12 - k_D4 * t26;
        let t39 = s4 * t17 + c4 * t12 + (t14 * k1 - k_D4 * t23);
        let t40 = t20 + t26 * k1;
        let t43 = s3 * t14 - c3 * t23;
        let t46 = s3 * t23 + c3 * t14;
        let t60 = t39 - k_A2 * t46;
        let t65 = c2 * (s3 * t38 + c3 * t40 - (t43 * k2 + k_A2 * t26));
        let t67 = k_D2 * (c2 * t43 + s2 * t46);
        let t68 = s2 * (c3 * t38 - s3 * t40 - t46 * k2) + t65 + t67;
        let t70 = s6 * XY6;
        let t73 = c6 * XY6;
        let t74 = s6 * XX6R + t73;
        let t77 = c6 * (c6 * XX6R - t70) - s6 * t73;
        let t80 = c6 * t74 - s6 * t70;
        let t83 = s6 * t74 + c6 * t70;
        [
        t0, t3, t6, t9, t12, t16, t19, t20,
        t39, t60, t68, t77, t80, t83,
    ]
    };
    // composite body 5
    let [
        t90, t93, t96, t99, t102, t106, t109, t117,
        t138, t146, t157, t160, t163, t164,
    ] = {
        let t84 = MSX5 + t6;
        let t85 = XX5R + t77;
        let t86 = ZZ5R + t83;
        let t87 = XY5 - t9;
        let t88 = XZ5 + t80;
        let t89 = YZ5 - t12;
        let t90 = IA5 + t86;
        let t93 = c5 * MSY5R + s5 * t84;
        let t96 = c5 * t84 - s5 * MSY5R;
        let t99 = c5 * t88 - s5 * t89;
        let t102 = s5 * t88 + c5 * t89;
        let t103 = c4 * t93;
        let t104 = s4 * t93;
        let t106 = s4 * t86;
        let t109 = c4 * t86;
        let t116 = c4 * t99 - t106 + k_D4 * t104;
        let t117 = s4 * t99 + t109 - (k_D4 * t103 + k1 * t96);
        let t118 = k1 * t104 - t102;
        let t121 = c3 * t103 + s3 * t96;
        let t124 = c3 * t96 - s3 * t103;
        let t138 = t117 + k_A2 * t124;
        let t143 = c2 * (s3 * t116 - c3 * t118 + (k2 * t121 + k_A2 * t104));
        let t145 = k_D2 * (c2 * t121 + s2 * t124);
        let t146 = s2 * (c3 * t116 + s3 * t118 + k2 * t124) + t143 - t145;
        let t148 = s5 * t87;
        let t151 = c5 * t87;
        let t152 = s5 * t85 + t151;
        let t154 = t19 + t148;
        let t157 = c5 * (c5 * t85 - t148) - s5 * (t151 - t16);
        let t160 = c5 * t152 - s5 * t154;
        let t163 = s5 * t152 + c5 * t154;
        let t164 = t93 + t93;
        [
        t90, t93, t96, t99, t102, t106, t109, t117,
        t138, t146, t157, t160, t163, t164,
    ]
    };
    // composite body 4
    let [
        t172, t175, t178, t189, t206, t214, t233, t239,
        t241, t244, t245, t249,
    ] = {
        let t165 = MSX4 + t96;
        let t166 = MSY4R + t3;
        let t167 = XX4R + t157;
        let t168 = ZZ4R + t163;
        let t169 = XY4 + t99;
        let t170 = XZ4 - t160;
        let t171 = YZ4 - t102;
        let t172 = IA4 + t168;
        let t175 = c4 * t166 + s4 * t165;
        let t178 = c4 * t165 - s4 * t166;
        let t181 = c4 * t170 - s4 * t171;
        let t185 = k_D4 * t178;
        let t187 = k1 * t178;
        let t188 = t181 - t185;
        let t189 = s4 * t170 + c4 * t171 - k_D4 * t175;
        let t190 = t168 - t187;
        let t191 = c3 * t175;
        let t192 = s3 * t175;
        let t206 = t189 - k_A2 * t192;
        let t211 = c2 * (s3 * t188 - c3 * t190 + (k2 * t191 - k_A2 * t178));
        let t213 = k_D2 * (s2 * t192 - c2 * t191);
        let t214 = s2 * (c3 * t188 + s3 * t190 - k2 * t192) + t211 + t213;
        let t216 = s4 * t169;
        let t219 = c4 * t169;
        let t220 = s4 * t167 + t219;
        let t222 = t109 + t216;
        let t233 = t175 + t175;
        let t236 = k1 * (t178 + t178) + k_D4 * t164;
        let t238 = t187 + t187;
        let t239 = c4 * (c4 * t167 - t216) - s4 * (t219 - t106) - t236 + t238;
        let t241 = c4 * t220 - s4 * t222 + k1 * t175;
        let t244 = t181 - (t185 + k1 * t93);
        let t245 = s4 * t220 + c4 * t222 - t236;
        let t247 = k_D4 * t93;
        let t249 = t168 - t236 + (t247 + t247);
        [
        t172, t175, t178, t189, t206, t214, t233, t239,
        t241, t244, t245, t249,
    ]
    };
    // composite body 3
    let [
        t257, t260, t263, t274, t275, t283, t309, t311,
        t314, t315, t319,
    ] = {
        let t250 = MSX3R + t178;
        let t251 = MSY3R + t93;
        let t252 = XX3R + t239;
        let t253 = ZZ3R + t245;
        let t254 = XY3R - t244;
        let t255 = XZ3 + t241;
        let t256 = YZ3 - t189;
        let t257 = IA3 + t253;
        let t260 = c3 * t251 + s3 * t250;
        let t263 = c3 * t250 - s3 * t251;
        let t266 = c3 * t255 - s3 * t256;
        let t270 = k2 * t263;
        let t272 = k_A2 * t263;
        let t274 = s3 * t255 + c3 * t256 + k2 * t260;
        let t275 = t253 + t272;
        let t282 = k_D2 * (c2 * t260 + s2 * t263);
        let t283 = s2 * (t266 + t270) + c2 * t274 - t282;
        let t285 = s3 * t254;
        let t288 = c3 * t254;
        let t289 = s3 * t252 + t288;
        let t293 = t285 + c3 * t249;
        let t306 = k_A2 * (t263 + t263) - k2 * t233;
        let t307 = c3 * (c3 * t252 - t285) - s3 * (t288 - s3 * t249) + t306;
        let t309 = t307 - (t272 + t272);
        let t311 = c3 * t289 - s3 * t293 - k_A2 * t260;
        let t314 = t266 - (k_A2 * t175 - t270);
        let t315 = s3 * t289 + c3 * t293 + t306;
        let t317 = k2 * t175;
        let t319 = t253 + t306 + (t317 + t317);
        [
        t257, t260, t263, t274, t275, t283, t309, t311,
        t314, t315, t319,
    ]
    };
    // composite body 2
    let [t323, t334, t345] = {
        let t323 = ZZ2R + t319;
        let t324 = XY2 + t311;
        let t333 = k_D2 * (c2 * (MSY2 + t260) + s2 * (MSX2R + t263));
        let t334 = s2 * (XZ2R + t314) + c2 * (YZ2 + t274) - t333;
        let t342 = c2 * (s2 * t324 + c2 * t315);
        let t345 = s2 * (s2 * (XX2R + t309) + c2 * t324) + t342 + k_D2 * t233;
        [t323, t334, t345]
    };
    // composite body 1
    let t346 = {
        let t346 = ZZ1R + t345;
        t346
    };
    // link 1: motion
    let t347 = {
        let t347 = dq1 * dq1;
        t347
    };
    // link 2: motion
    let [t348, t349, t350, t354, t355, t358, t359, t360] = {
        let t348 = s2 * k5;
        let t349 = c2 * k5;
        let t350 = k_D2 * t347;
        let t351 = s2 * dq1;
        let t353 = t351 * t351;
        let t354 = dq2 * dq2;
        let t355 = t351 * (c2 * dq1);
        let dw2_y = dq2 * t351;
        let t358 = t353 - t354 - t347;
        let t359 = t353 + t354;
        let t360 = dw2_y + dw2_y;
        [t348, t349, t350, t354, t355, t358, t359, t360]
    };
    // link 3: motion
    let [
        t363, t366, w3_z, a3_x, a3_y, a3_z, t382, w3_y,
        t385, t386, dw3_y, t390, t391, t392, t393,
    ] = {
        let t363 = s2 * c3 + c2 * s3;
        let t366 = s2 * s3 - c2 * c3;
        let w3_z = dq2 + dq3;
        let t371 = k_A2 * t358 - t348;
        let t372 = k_A2 * t355 - t349;
        let a3_x = c3 * t371 + s3 * t372;
        let a3_y = c3 * t372 - s3 * t371;
        let a3_z = k2 * t347 - k_A2 * t360 - t350;
        let t382 = dq1 * t363;
        let w3_y = dq1 * t366;
        let t384 = t382 * t382;
        let t385 = w3_z * w3_z;
        let t386 = t382 * w3_y;
        let dw3_y = w3_z * t382;
        let dw3_x = w3_z * w3_y;
        let t390 = t384 - t385 - t347;
        let t391 = t384 + t385;
        let t392 = dw3_y + dw3_y;
        let t393 = dw3_x + dw3_x;
        [
        t363, t366, w3_z, a3_x, a3_y, a3_z, t382, w3_y,
        t385, t386, dw3_y, t390, t391, t392, t393,
    ]
    };
    // link 4: motion
    let [
        t404, a4_x, a4_y, w4_x, w4_y, t420, t423, w4_z,
        t427, t428, t429, dw4_x, dw4_y, t432, t433, t434,
        t435, t436, t437, t438,
    ] = {
        let t403 = a3_x + (k_D4 * t386 - k1 * t390);
        let t404 = a3_y + (k1 * t386 + k_D4 * t391);
        let t405 = a3_z + (k1 * t392 - k_D4 * t393);
        let a4_x = c4 * t403 + s4 * t405;
        let a4_y = c4 * t405 - s4 * t403;
        let w4_x = s4 * w3_z - c4 * t382;
        let w4_y = c4 * w3_z + s4 * t382;
        let t420 = c4 * t386 - s4 * t393;
        let t423 = c4 * t393 + s4 * t386;
        let w4_z = dq4 - w3_y;
        let t425 = w4_x * w4_x;
        let t426 = w4_z * w4_z;
        let t427 = w4_x * w4_y;
        let t428 = w4_x * w4_z;
        let t429 = w4_y * w4_z;
        let dw4_x = t423 + t429;
        let dw4_y = t420 - t428;
        let t432 = t425 - t426;
        let t433 = t432 - t391;
        let t434 = dw3_y + t427;
        let t435 = t427 - dw3_y;
        let t436 = t425 + t426;
        let t437 = t428 - dw4_y;
        let t438 = t429 + dw4_x;
        [
        t404, a4_x, a4_y, w4_x, w4_y, t420, t423, w4_z,
        t427, t428, t429, dw4_x, dw4_y, t432, t433, t434,
        t435, t436, t437, t438,
    ]
    };
    // link 5: motion
    let [
        a5_x, a5_y, w5_x, t450, t453, t456, w5_z, t460,
        t461, t462, dw5_x, dw5_y, t465, t466, t467, t468,
        t469, t470, t471,
    ] = {
        let a5_x = c5 * a4_x + s5 * t404;
        let a5_y = c5 * t404 - s5 * a4_x;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t450 = c5 * w4_z + s5 * w4_x;
        let t453 = c5 * t434 - s5 * t438;
        let t456 = c5 * t438 + s5 * t434;
        let w5_z = w4_y + dq5;
        let t458 = w5_x * w5_x;
        let t459 = w5_z * w5_z;
        let t460 = w5_x * t450;
        let t461 = w5_x * w5_z;
        let t462 = t450 * w5_z;
        let dw5_x = t456 - t462;
        let dw5_y = t453 - t461;
        let t465 = t458 - t459;
        let t466 = t465 - t436;
        let t467 = dw4_y + t460;
        let t468 = dw4_y - t460;
        let t469 = t458 + t459;
        let t470 = t461 - dw5_y;
        let t471 = dw5_x - t462;
        [
        a5_x, a5_y, w5_x, t450, t453, t456, w5_z, t460,
        t461, t462, dw5_x, dw5_y, t465, t466, t467, t468,
        t469, t470, t471,
    ]
    };
    // link 6: motion
    let [
        a6_x, a6_y, t486, t489, t493, t494, t495, dw6_x,
        t498, t499, t500, t501, t502, t503, t504,
    ] = {
        let a6_x = c6 * a5_x + s6 * a4_y;
        let a6_y = c6 * a4_y - s6 * a5_x;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t486 = c6 * t467 - s6 * t471;
        let t489 = c6 * t471 + s6 * t467;
        let w6_z = t450 + dq6;
        let t491 = w6_x * w6_x;
        let t492 = w6_z * w6_z;
        let t493 = w6_x * w6_y;
        let t494 = w6_x * w6_z;
        let t495 = w6_y * w6_z;
        let dw6_x = t489 + t495;
        let dw6_y = t486 - t494;
        let t498 = t491 - t492;
        let t499 = t498 - t469;
        let t500 = dw5_y + t493;
        let t501 = t493 - dw5_y;
        let t502 = t491 + t492;
        let t503 = t494 - dw6_y;
        let t504 = t495 + dw6_x;
        [
        a6_x, a6_y, t486, t489, t493, t494, t495, dw6_x,
        t498, t499, t500, t501, t502, t503, t504,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t552, t555, t558, t561] = {
        let t525 = XY6 * (t499 + t502) - (XX6R * t493 + ZZ6 * dw5_y) + XZ6 * t489;
        let t527 = YZ6 * (t469 - t502);
        let t530 = ZZ6 * t495 + XX6R * dw6_x - XY6 * t503 + XZ6 * t501 + t527;
        let t531 = t494 * (XX6R - ZZ6) + XY6 * t504 - XZ6 * t498 - YZ6 * t500;
        let f6_x = MSX6 * t499 + MSY6 * t500;
        let f6_y = MSX6 * t501 - MSY6 * t502;
        let f6_z = MSX6 * t503 + MSY6 * t504;
        let n6_x = t530 - MSY6 * a5_y;
        let n6_y = t531 + MSX6 * a5_y;
        let n6_z = t525 + YZ6 * t486 + (MSX6 * a6_y - MSY6 * a6_x);
        let t552 = c6 * f6_x - s6 * f6_y;
        let t555 = s6 * f6_x + c6 * f6_y;
        let t558 = c6 * n6_x - s6 * n6_y;
        let t561 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t552, t555, t558, t561]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t615, t618, t621, t624] = {
        let t582 = XX5R * t460 + ZZ5R * dw4_y + XY5 * (t466 + t469) + XZ5 * t456;
        let t584 = YZ5 * (t436 - t469);
        let t587 = XX5R * dw5_x - ZZ5R * t462 - XY5 * t470 + XZ5 * t468 + t584;
        let t588 = t461 * (XX5R - ZZ5R) + XY5 * t471 - XZ5 * t465 + YZ5 * t467;
        let f5_x = t552 + (MSX5 * t466 - MSY5R * t467);
        let f5_y = MSX5 * t468 - MSY5R * t469 - f6_z;
        let f5_z = t555 + (MSX5 * t470 + MSY5R * t471);
        let n5_x = t558 + (t587 + MSY5R * a4_y);
        let n5_y = t588 - MSX5 * a4_y - n6_z;
        let n5_z = t561 + (t582 + YZ5 * t453 + (MSX5 * a5_y - MSY5R * a5_x));
        let t615 = c5 * f5_x - s5 * f5_y;
        let t618 = s5 * f5_x + c5 * f5_y;
        let t621 = c5 * n5_x - s5 * n5_y;
        let t624 = s5 * n5_x + c5 * n5_y;
        [f5_z, n5_z, t615, t618, t621, t624]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t678, t681, t693, t694, t695] = {
        let t645 = XY4 * (t433 + t436) - (XX4R * t427 + ZZ4R * dw3_y) + XZ4 * t423;
        let t647 = YZ4 * (t391 - t436);
        let t650 = ZZ4R * t429 + XX4R * dw4_x - XY4 * t437 + XZ4 * t435 + t647;
        let t651 = t428 * (XX4R - ZZ4R) + XY4 * t438 - XZ4 * t432 - YZ4 * t434;
        let f4_x = t615 + (MSX4 * t433 + MSY4R * t434);
        let f4_y = f5_z + (MSX4 * t435 - MSY4R * t436);
        let f4_z = MSX4 * t437 + MSY4R * t438 - t618;
        let n4_x = t621 + (t650 - MSY4R * t404);
        let n4_y = n5_z + (t651 + MSX4 * t404);
        let n4_z = t645 + YZ4 * t420 + (MSX4 * a4_y - MSY4R * a4_x) - t624;
        let t678 = c4 * f4_x - s4 * f4_y;
        let t681 = s4 * f4_x + c4 * f4_y;
        let t693 = c4 * n4_x - s4 * n4_y - k_D4 * t681;
        let t694 = s4 * n4_x + c4 * n4_y + (k_D4 * t678 + k1 * f4_z);
        let t695 = n4_z - k1 * t681;
        [f4_z, n4_z, t678, t681, t693, t694, t695]
    };
    // link 3: force and moment
    let [t709, n3_z, t734, t737, t749, t750, t751] = {
        let t701 = t366 * (t366 * (XY3R + XY3R) - XX3R * t363) - XY3R;
        let t709 = (t701 + t701) * (dq1 * w3_z) + t385 * (XZ3 * t366 + YZ3 * t363);
        let f3_x = t678 + (MSX3R * t390 - MSY3R * t386);
        let t726 = f4_z + (MSX3R * t386 + MSY3R * t391);
        let f3_z = t681 + (MSY3R * t393 - MSX3R * t392);
        let n3_x = t693 + MSY3R * a3_z;
        let t729 = t695 + MSX3R * a3_z;
        let n3_z = t694 + (MSX3R * a3_y - MSY3R * a3_x) - t347 * t701;
        let t734 = c3 * f3_x + s3 * t726;
        let t737 = s3 * f3_x - c3 * t726;
        let t749 = c3 * n3_x + s3 * t729 + k2 * t737;
        let t750 = s3 * n3_x - c3 * t729 - (k2 * t734 + k_A2 * f3_z);
        let t751 = n3_z + k_A2 * t737;
        [t709, n3_z, t734, t737, t749, t750, t751]
    };
    // link 2: force and moment
    let [t767, n2_z, t792] = {
        let t757 = c2 * (s2 * XX2R + c2 * (XY2 + XY2)) - XY2;
        let t765 = (t757 + t757) * (dq1 * dq2) + t354 * (s2 * YZ2 - c2 * XZ2R);
        let t767 = t709 + t765;
        let f2_x = t734 + (MSX2R * t358 + MSY2 * t355);
        let f2_y = t737 + (MSX2R * t355 - MSY2 * t359);
        let n2_x = t749 - MSY2 * t350;
        let n2_y = t750 + MSX2R * t350;
        let n2_z = t751 + (MSY2 * t348 - MSX2R * t349) - t347 * t757;
        let f1_x = c2 * f2_x - s2 * f2_y;
        let t792 = s2 * n2_x + c2 * n2_y + k_D2 * f1_x;
        [t767, n2_z, t792]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t767 - t792;
        n1_z
    };
    // drives
    let [t824, t825, t826, t827, t828, t829] = {
        let t824 = tau1 - (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t825 = tau2 - (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t826 = tau3 - (n3_z + FV3 * dq3 + FC3 * dq3.sign());
        let t827 = tau4 - (n4_z + FV4 * dq4 + FC4 * dq4.sign());
        let t828 = tau5 - (n5_z + FV5 * dq5 + FC5 * dq5.sign());
        let t829 = tau6 - (n6_z + FV6 * dq6 + FC6 * dq6.sign());
        [t824, t825, t826, t827, t828, t829]
    };
    // M = L D L'
    let [
        t830, t831, t832, t833, t834, t835, t839, t843,
        t846, t849, t852, t859, t866, t871, t876, t886,
        t896, t903, t916, t929, t945,
    ] = {
        let t830 = k6 / t346;
        let t831 = t334 * t830;
        let t832 = t283 * t830;
        let t833 = t214 * t830;
        let t834 = t146 * t830;
        let t835 = t68 * t830;
        let t838 = t323 - t346 * (t831 * t831);
        let t839 = k6 / t838;
        let t840 = t346 * t831;
        let t843 = t839 * (t275 - t832 * t840);
        let t846 = t839 * (t206 - t833 * t840);
        let t849 = t839 * (t138 - t834 * t840);
        let t852 = t839 * (t60 - t835 * t840);
        let t858 = t257 - t346 * (t832 * t832) - t838 * (t843 * t843);
        let t859 = k6 / t858;
        let t860 = t346 * t832;
        let t863 = t838 * t843;
        let t866 = t859 * (t189 - t833 * t860 - t846 * t863);
        let t871 = t859 * (t117 - t834 * t860 - t849 * t863);
        let t876 = t859 * (t39 - t835 * t860 - t852 * t863);
        let t884 = t858 * (t866 * t866);
        let t885 = t172 - t346 * (t833 * t833) - t838 * (t846 * t846) - t884;
        let t886 = k6 / t885;
        let t887 = t346 * t833;
        let t890 = t838 * t846;
        let t893 = t858 * t866;
        let t896 = t886 * (t102 + t834 * t887 + t849 * t890 + t871 * t893);
        let t903 = t886 * (t20 + t835 * t887 + t852 * t890 + t876 * t893);
        let t911 = t858 * (t871 * t871);
        let t914 = t885 * (t896 * t896);
        let t915 = t90 - t346 * (t834 * t834) - t838 * (t849 * t849) - t911 - t914;
        let t916 = k6 / t915;
        let t924 = t876 * (t858 * t871);
        let t927 = t903 * (t885 * t896);
        let t928 = t12 - t835 * (t346 * t834) - t852 * (t838 * t849) - t924 - t927;
        let t929 = t916 * t928;
        let t937 = t858 * (t876 * t876);
        let t940 = t885 * (t903 * t903);
        let t941 = t0 - t346 * (t835 * t835) - t838 * (t852 * t852) - t937 - t940;
        let t945 = k6 / (t941 - t915 * (t929 * t929));
        [
        t830, t831, t832, t833, t834, t835, t839, t843,
        t846, t849, t852, t859, t866, t871, t876, t886,
        t896, t903, t916, t929, t945,
    ]
    };
    // ddq
    {
        let t947 = t825 + t824 * t831;
        let t951 = t826 + t824 * t832 - t843 * t947;
        let t957 = t827 + t824 * t833 - t846 * t947 - t866 * t951;
        let t965 = t828 + t824 * t834 - t849 * t947 - t871 * t951 + t896 * t957;
        let t973 = t829 + t824 * t835 - t852 * t947 - t876 * t951 + t903 * t957;
        let t981 = t945 * (t973 - t929 * t965);
        let t983 = t916 * t965 - t929 * t981;
        let t987 = t886 * t957 + t896 * t983 + t903 * t981;
        let t993 = t859 * t951 - t866 * t987 - t871 * t983 - t876 * t981;
        let t1000 = t852 * t981;
        let t1001 = t839 * t947 - t843 * t993 - t846 * t987 - t849 * t983 - t1000;
        let t1008 = t834 * t983;
        let t1009 = t824 * t830 + t831 * t1001 + t832 * t993 + t833 * t987 + t1008;
        let t1011 = t1009 + t835 * t981;
        put(0, t1011);
        put(1, t1001);
        put(2, t993);
        put(3, t987);
        put(4, t983);
        put(5, t981);
    }
}
