//! Accelerations under given torques.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` in
//! closed form.
//!
//! 654 multiplications, 520 additions; 7, 7 of 7 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, GRAVITY, Trig, constants};

/// Accelerations under given torques: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE], out: &mut [S; 7]) {
    entries(trig, dq, tau, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let [tau1, tau2, tau3, tau4, tau5, tau6, tau7] = *tau;
    let [
        ZZ1R, MSX2, MSY2R, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3, MSY3R, XX3R, ZZ3R,
        XY3, XZ3, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6R, XX6R, ZZ6R, XY6, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7, FV1, FV2, FV3, FV4, FV5,
        FV6, FV7, FC1, FC2, FC3, FC4, FC5, FC6, FC7,
        ..] = *beta;
    let k2 = S::constant(-GRAVITY[2]);
    let k3 = S::constant(1.0);
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
    // composite body 7
    let [
        t2, t5, t8, t11, t15, t18, t19, t35,
        t44, t60, t63, t72, t75, t78,
    ] = {
        let t2 = c7 * MSY7 + s7 * MSX7;
        let t5 = c7 * MSX7 - s7 * MSY7;
        let t8 = c7 * XZ7 - s7 * YZ7;
        let t11 = s7 * XZ7 + c7 * YZ7;
        let t12 = c6 * t2;
        let t15 = s6 * ZZ7;
        let t16 = c6 * t8 - t15;
        let t18 = c6 * ZZ7;
        let t19 = s6 * t8 + t18;
        let t22 = c5 * t12 + s5 * t5;
        let t25 = c5 * t5 - s5 * t12;
        let t34 = c5 * t16 - s5 * t11 - k_L3 * t25;
        let t35 = s5 * t16 + c5 * t11 - k_L3 * t22;
        let t38 = c4 * t22 + s4 * (s6 * t2);
        let t41 = c4 * t34 + s4 * t19;
        let t44 = s4 * t34 - c4 * t19;
        let t59 = c3 * t41 - s3 * t35 - k_L2 * (c3 * t25 - s3 * t38);
        let t60 = s3 * t41 + c3 * t35 - k_L2 * (c3 * t38 + s3 * t25);
        let t63 = s2 * t59 - c2 * t44;
        let t65 = s7 * XY7;
        let t68 = c7 * XY7;
        let t69 = s7 * XX7R + t68;
        let t72 = c7 * (c7 * XX7R - t65) - s7 * t68;
        let t75 = c7 * t69 - s7 * t65;
        let t78 = s7 * t69 + c7 * t65;
        [
        t2, t5, t8, t11, t15, t18, t19, t35,
        t44, t60, t63, t72, t75, t78,
    ]
    };
    // composite body 6
    let [
        t81, t87, t90, t93, t96, t100, t103, t108,
        t117, t133, t136, t147, t150, t153, t154,
    ] = {
        let t79 = MSX6 + t5;
        let t80 = XX6R + t72;
        let t81 = ZZ6R + t78;
        let t82 = XY6 + t8;
        let t83 = XZ6 - t75;
        let t84 = YZ6 - t11;
        let t87 = c6 * MSY6R + s6 * t79;
        let t90 = c6 * t79 - s6 * MSY6R;
        let t93 = c6 * t83 - s6 * t84;
        let t96 = s6 * t83 + c6 * t84;
        let t97 = c5 * t87;
        let t98 = s5 * t87;
        let t100 = s5 * t81;
        let t103 = c5 * t81;
        let t107 = c5 * t93 + t100 + k_L3 * t98;
        let t108 = s5 * t93 - t103 - k_L3 * t97;
        let t111 = s4 * t90 - c4 * t97;
        let t114 = c4 * t107 + s4 * t96;
        let t117 = s4 * t107 - c4 * t96;
        let t132 = c3 * t114 - s3 * t108 - k_L2 * (s3 * t111 - c3 * t98);
        let t133 = s3 * t114 + c3 * t108 + k_L2 * (c3 * t111 + s3 * t98);
        let t136 = s2 * t132 - c2 * t117;
        let t138 = s6 * t82;
        let t141 = c6 * t82;
        let t142 = s6 * t80 + t141;
        let t144 = t18 + t138;
        let t147 = c6 * (c6 * t80 - t138) - s6 * (t141 - t15);
        let t150 = c6 * t142 - s6 * t144;
        let t153 = s6 * t142 + c6 * t144;
        let t154 = t87 + t87;
        [
        t81, t87, t90, t93, t96, t100, t103, t108,
        t117, t133, t136, t147, t150, t153, t154,
    ]
    };
    // composite body 5
    let [
        t158, t164, t167, t176, t177, t184, t200, t203,
        t217, t222, t223, t227,
    ] = {
        let t155 = MSX5 + t90;
        let t156 = MSY5R + t2;
        let t157 = XX5R + t147;
        let t158 = ZZ5R + t153;
        let t159 = XY5 - t93;
        let t160 = XZ5 + t150;
        let t161 = YZ5 - t96;
        let t164 = c5 * t156 + s5 * t155;
        let t167 = c5 * t155 - s5 * t156;
        let t176 = c5 * t160 - s5 * t161 - k_L3 * t167;
        let t177 = s5 * t160 + c5 * t161 - k_L3 * t164;
        let t178 = c4 * t164;
        let t181 = c4 * t176 + s4 * t158;
        let t184 = s4 * t176 - c4 * t158;
        let t199 = c3 * t181 - s3 * t177 - k_L2 * (c3 * t167 - s3 * t178);
        let t200 = s3 * t181 + c3 * t177 - k_L2 * (c3 * t178 + s3 * t167);
        let t203 = s2 * t199 - c2 * t184;
        let t205 = s5 * t159;
        let t208 = c5 * t159;
        let t209 = s5 * t157 + t208;
        let t211 = t103 + t205;
        let t217 = c5 * t209 - s5 * t211;
        let t221 = k_L3 * t154;
        let t222 = c5 * (c5 * t157 - t205) - s5 * (t208 - t100) + t221;
        let t223 = s5 * t209 + c5 * t211 + t221;
        let t225 = k_L3 * t87;
        let t227 = t158 + t221 - (t225 + t225);
        [
        t158, t164, t167, t176, t177, t184, t200, t203,
        t217, t222, t223, t227,
    ]
    };
    // composite body 4
    let [
        t231, t237, t240, t243, t246, t250, t253, t258,
        t261, t274, t277, t280, t281,
    ] = {
        let t228 = MSX4 + t167;
        let t229 = MSY4R - t87;
        let t230 = XX4R + t222;
        let t231 = ZZ4R + t223;
        let t232 = XY4 - t176;
        let t233 = XZ4 + t217;
        let t234 = YZ4 - t177;
        let t237 = c4 * t229 + s4 * t228;
        let t240 = c4 * t228 - s4 * t229;
        let t243 = c4 * t233 - s4 * t234;
        let t246 = s4 * t233 + c4 * t234;
        let t250 = s3 * t231;
        let t253 = c3 * t231;
        let t258 = s3 * t243 + t253 - k_L2 * (c3 * t237);
        let t261 = s2 * (c3 * t243 - t250 + k_L2 * (s3 * t237)) - c2 * t246;
        let t263 = s4 * t232;
        let t266 = c4 * t232;
        let t267 = s4 * t230 + t266;
        let t271 = t263 + c4 * t227;
        let t274 = c4 * (c4 * t230 - t263) - s4 * (t266 - s4 * t227);
        let t277 = c4 * t267 - s4 * t271;
        let t280 = s4 * t267 + c4 * t271;
        let t281 = t237 + t237;
        [
        t231, t237, t240, t243, t246, t250, t253, t258,
        t261, t274, t277, t280, t281,
    ]
    };
    // composite body 3
    let [t285, t303, t304, t307, t321, t326, t327, t331] = {
        let t282 = MSX3 + t240;
        let t283 = MSY3R + t164;
        let t284 = XX3R + t274;
        let t285 = ZZ3R + t280;
        let t286 = XY3 + t243;
        let t287 = XZ3 - t277;
        let t288 = YZ3 - t246;
        let t303 = c3 * t287 - s3 * t288 - k_L2 * (c3 * t282 - s3 * t283);
        let t304 = s3 * t287 + c3 * t288 - k_L2 * (c3 * t283 + s3 * t282);
        let t307 = s2 * t303 + c2 * t285;
        let t309 = s3 * t286;
        let t312 = c3 * t286;
        let t313 = s3 * t284 + t312;
        let t315 = t253 + t309;
        let t321 = c3 * t313 - s3 * t315;
        let t325 = k_L2 * t281;
        let t326 = c3 * (c3 * t284 - t309) - s3 * (t312 - t250) - t325;
        let t327 = s3 * t313 + c3 * t315 - t325;
        let t329 = k_L2 * t237;
        let t331 = t285 - t325 + (t329 + t329);
        [t285, t303, t304, t307, t321, t326, t327, t331]
    };
    // composite body 2
    let [t333, t339, t348] = {
        let t333 = ZZ2R + t327;
        let t334 = XY2 + t303;
        let t339 = s2 * (XZ2 - t321) + c2 * (YZ2 - t304);
        let t347 = c2 * (s2 * t334 + c2 * t331);
        let t348 = s2 * (s2 * (XX2R + t326) + c2 * t334) + t347;
        [t333, t339, t348]
    };
    // composite body 1
    let t349 = {
        let t349 = ZZ1R + t348;
        t349
    };
    // link 1: motion
    let t350 = {
        let t350 = dq1 * dq1;
        t350
    };
    // link 2: motion
    let [
        a2_x, a2_y, w2_x, w2_y, t356, t357, t358, t360,
        t361,
    ] = {
        let a2_x = s2 * k2;
        let a2_y = c2 * k2;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t356 = dq2 * dq2;
        let t357 = w2_x * w2_y;
        let t358 = dq2 * w2_x;
        let dw2_x = dq2 * w2_y;
        let t360 = w2_x * w2_x + t356;
        let t361 = dw2_x + dw2_x;
        [
        a2_x, a2_y, w2_x, w2_y, t356, t357, t358, t360,
        t361,
    ]
    };
    // link 3: motion
    let [
        a3_z, a3_x, t372, w3_x, t378, t381, t384, w3_z,
        t388, t389, t390, dw3_x, dw3_y, t393, t394, t395,
        t396, t397, t398, t399,
    ] = {
        let t364 = k_L2 * t361;
        let t365 = a2_x + k_L2 * t357;
        let a3_z = a2_y - k_L2 * t360;
        let a3_x = c3 * t365 - s3 * t364;
        let t372 = c3 * t364 + s3 * t365;
        let w3_x = c3 * w2_x - s3 * dq2;
        let t378 = c3 * dq2 + s3 * w2_x;
        let t381 = c3 * t357 - s3 * t361;
        let t384 = c3 * t361 + s3 * t357;
        let w3_z = w2_y + dq3;
        let t386 = w3_x * w3_x;
        let t387 = w3_z * w3_z;
        let t388 = w3_x * t378;
        let t389 = w3_x * w3_z;
        let t390 = t378 * w3_z;
        let dw3_x = t384 - t390;
        let dw3_y = t381 - t389;
        let t393 = t386 - t387;
        let t394 = t393 - t360;
        let t395 = t358 - t388;
        let t396 = t358 + t388;
        let t397 = t386 + t387;
        let t398 = t389 - dw3_y;
        let t399 = dw3_x - t390;
        [
        a3_z, a3_x, t372, w3_x, t378, t381, t384, w3_z,
        t388, t389, t390, dw3_x, dw3_y, t393, t394, t395,
        t396, t397, t398, t399,
    ]
    };
    // link 4: motion
    let [
        a4_x, t405, w4_x, t411, t414, t417, w4_z, t421,
        t422, t423, dw4_x, dw4_y, t426, t427, t428, t429,
        t430, t431, t432,
    ] = {
        let a4_x = c4 * a3_x - s4 * a3_z;
        let t405 = c4 * a3_z + s4 * a3_x;
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t411 = c4 * w3_z + s4 * w3_x;
        let t414 = c4 * t395 - s4 * t399;
        let t417 = c4 * t399 + s4 * t395;
        let w4_z = dq4 - t378;
        let t419 = w4_x * w4_x;
        let t420 = w4_z * w4_z;
        let t421 = w4_x * t411;
        let t422 = w4_x * w4_z;
        let t423 = t411 * w4_z;
        let dw4_x = t417 - t423;
        let dw4_y = t414 - t422;
        let t426 = t419 - t420;
        let t427 = t426 - t397;
        let t428 = dw3_y + t421;
        let t429 = dw3_y - t421;
        let t430 = t419 + t420;
        let t431 = t422 - dw4_y;
        let t432 = dw4_x - t423;
        [
        a4_x, t405, w4_x, t411, t414, t417, w4_z, t421,
        t422, t423, dw4_x, dw4_y, t426, t427, t428, t429,
        t430, t431, t432,
    ]
    };
    // link 5: motion
    let [
        t437, a5_x, a6_z, w5_x, w5_y, t453, t456, w5_z,
        t460, t461, t462, dw5_x, dw5_y, t465, t466, t467,
        t468, t469, t470, t471,
    ] = {
        let t436 = a4_x + k_L3 * t428;
        let t437 = k_L3 * t430 - t405;
        let t438 = t372 + k_L3 * t432;
        let a5_x = c5 * t436 - s5 * t438;
        let a6_z = c5 * t438 + s5 * t436;
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t453 = c5 * t428 - s5 * t432;
        let t456 = c5 * t432 + s5 * t428;
        let w5_z = t411 + dq5;
        let t458 = w5_x * w5_x;
        let t459 = w5_z * w5_z;
        let t460 = w5_x * w5_y;
        let t461 = w5_x * w5_z;
        let t462 = w5_y * w5_z;
        let dw5_x = t456 + t462;
        let dw5_y = t453 - t461;
        let t465 = t458 - t459;
        let t466 = t465 - t430;
        let t467 = dw4_y + t460;
        let t468 = t460 - dw4_y;
        let t469 = t458 + t459;
        let t470 = t461 - dw5_y;
        let t471 = t462 + dw5_x;
        [
        t437, a5_x, a6_z, w5_x, w5_y, t453, t456, w5_z,
        t460, t461, t462, dw5_x, dw5_y, t465, t466, t467,
        t468, t469, t470, t471,
    ]
    };
    // link 6: motion
    let [
        a6_x, t477, w6_x, w6_y, t486, t489, w6_z, t493,
        t494, t495, dw6_x, t497, t498, t499, t500, t501,
        t502, t503, t504,
    ] = {
        let a6_x = c6 * a5_x - s6 * t437;
        let t477 = c6 * t437 + s6 * a5_x;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t486 = c6 * t467 + s6 * t471;
        let t489 = s6 * t467 - c6 * t471;
        let w6_z = dq6 - w5_y;
        let t491 = w6_x * w6_x;
        let t492 = w6_z * w6_z;
        let t493 = w6_x * w6_y;
        let t494 = w6_x * w6_z;
        let t495 = w6_y * w6_z;
        let dw6_x = t495 - t489;
        let t497 = t486 + t494;
        let t498 = t491 - t492;
        let t499 = t498 - t469;
        let t500 = dw5_y + t493;
        let t501 = t493 - dw5_y;
        let t502 = t491 + t492;
        let t503 = t494 + t497;
        let t504 = t495 + dw6_x;
        [
        a6_x, t477, w6_x, w6_y, t486, t489, w6_z, t493,
        t494, t495, dw6_x, t497, t498, t499, t500, t501,
        t502, t503, t504,
    ]
    };
    // link 7: motion
    let [
        a7_x, t510, t519, t522, t526, t527, t528, dw7_x,
        t531, t532, t533, t534, t535, t536, t537,
    ] = {
        let a7_x = c7 * a6_x - s7 * a6_z;
        let t510 = c7 * a6_z + s7 * a6_x;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t516 = c7 * w6_z + s7 * w6_x;
        let t519 = c7 * t500 - s7 * t504;
        let t522 = c7 * t504 + s7 * t500;
        let w7_z = w6_y + dq7;
        let t524 = w7_x * w7_x;
        let t525 = w7_z * w7_z;
        let t526 = w7_x * t516;
        let t527 = w7_x * w7_z;
        let t528 = t516 * w7_z;
        let dw7_x = t522 - t528;
        let dw7_y = t519 - t527;
        let t531 = t524 - t525;
        let t532 = t531 - t502;
        let t533 = t497 - t526;
        let t534 = t497 + t526;
        let t535 = t524 + t525;
        let t536 = t527 - dw7_y;
        let t537 = dw7_x - t528;
        [
        a7_x, t510, t519, t522, t526, t527, t528, dw7_x,
        t531, t532, t533, t534, t535, t536, t537,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t585, t588, t591, t594] = {
        let t558 = XX7R * t526 - ZZ7 * t497 + XY7 * (t532 + t535) + XZ7 * t522;
        let t560 = YZ7 * (t502 - t535);
        let t563 = XX7R * dw7_x - ZZ7 * t528 - XY7 * t536 - XZ7 * t534 + t560;
        let t564 = t527 * (XX7R - ZZ7) + XY7 * t537 - XZ7 * t531 - YZ7 * t533;
        let f7_x = MSX7 * t532 + MSY7 * t533;
        let t571 = MSX7 * t534 + MSY7 * t535;
        let f7_z = MSX7 * t536 + MSY7 * t537;
        let n7_x = t563 - MSY7 * t477;
        let n7_y = t564 + MSX7 * t477;
        let n7_z = t558 + YZ7 * t519 - (MSX7 * t510 + MSY7 * a7_x);
        let t585 = c7 * f7_x + s7 * t571;
        let t588 = s7 * f7_x - c7 * t571;
        let t591 = c7 * n7_x - s7 * n7_y;
        let t594 = s7 * n7_x + c7 * n7_y;
        [f7_z, n7_z, t585, t588, t591, t594]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t648, t651, t654, t657] = {
        let t615 = XY6 * (t499 + t502) - (XX6R * t493 + ZZ6R * dw5_y) - XZ6 * t489;
        let t617 = YZ6 * (t469 - t502);
        let t620 = ZZ6R * t495 + XX6R * dw6_x - XY6 * t503 + XZ6 * t501 + t617;
        let t621 = t494 * (XX6R - ZZ6R) + XY6 * t504 - XZ6 * t498 - YZ6 * t500;
        let f6_x = t585 + (MSX6 * t499 + MSY6R * t500);
        let f6_y = f7_z + (MSX6 * t501 - MSY6R * t502);
        let f6_z = MSX6 * t503 + MSY6R * t504 - t588;
        let n6_x = t591 + (t620 + MSY6R * a6_z);
        let n6_y = n7_z + (t621 - MSX6 * a6_z);
        let n6_z = t615 - YZ6 * t486 - (MSX6 * t477 + MSY6R * a6_x) - t594;
        let t648 = c6 * f6_x - s6 * f6_y;
        let t651 = s6 * f6_x + c6 * f6_y;
        let t654 = c6 * n6_x - s6 * n6_y;
        let t657 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t648, t651, t654, t657]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t711, t714, t723, t724] = {
        let t678 = XY5 * (t466 + t469) - (XX5R * t460 + ZZ5R * dw4_y) + XZ5 * t456;
        let t680 = YZ5 * (t430 - t469);
        let t683 = ZZ5R * t462 + XX5R * dw5_x - XY5 * t470 + XZ5 * t468 + t680;
        let t684 = t461 * (XX5R - ZZ5R) + XY5 * t471 - XZ5 * t465 - YZ5 * t467;
        let f5_x = t648 + (MSX5 * t466 + MSY5R * t467);
        let f5_y = MSX5 * t468 - MSY5R * t469 - f6_z;
        let f5_z = t651 + (MSX5 * t470 + MSY5R * t471);
        let n5_x = t654 + (t683 - MSY5R * t437);
        let n5_y = t684 + MSX5 * t437 - n6_z;
        let n5_z = t657 + (t678 + YZ5 * t453 - (MSX5 * a6_z + MSY5R * a5_x));
        let t711 = c5 * f5_x - s5 * f5_y;
        let t714 = s5 * f5_x + c5 * f5_y;
        let t723 = c5 * n5_x - s5 * n5_y - k_L3 * t714;
        let t724 = s5 * n5_x + c5 * n5_y + k_L3 * t711;
        [f5_z, n5_z, t711, t714, t723, t724]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t778, t781, t784] = {
        let t745 = XX4R * t421 + ZZ4R * dw3_y + XY4 * (t427 + t430) + XZ4 * t417;
        let t747 = YZ4 * (t397 - t430);
        let t750 = XX4R * dw4_x - ZZ4R * t423 - XY4 * t431 + XZ4 * t429 + t747;
        let t751 = t422 * (XX4R - ZZ4R) + XY4 * t432 - XZ4 * t426 + YZ4 * t428;
        let f4_x = t711 + (MSX4 * t427 - MSY4R * t428);
        let f4_y = MSX4 * t429 - MSY4R * t430 - f5_z;
        let f4_z = t714 + (MSX4 * t431 + MSY4R * t432);
        let n4_x = t723 + (t750 - MSY4R * t372);
        let n4_y = t751 + MSX4 * t372 - n5_z;
        let n4_z = t724 + (t745 + YZ4 * t414 - (MSX4 * t405 + MSY4R * a4_x));
        let t778 = c4 * f4_x - s4 * f4_y;
        let t781 = c4 * n4_x - s4 * n4_y;
        let t784 = s4 * n4_x + c4 * n4_y;
        [f4_z, n4_z, t778, t781, t784]
    };
    // link 3: force and moment
    let [n3_z, n2_x, t847] = {
        let t805 = XX3R * t388 - ZZ3R * t358 + XY3 * (t394 + t397) + XZ3 * t384;
        let t807 = YZ3 * (t360 - t397);
        let t810 = XX3R * dw3_x - ZZ3R * t390 - XY3 * t398 - XZ3 * t396 + t807;
        let t811 = t389 * (XX3R - ZZ3R) + XY3 * t399 - XZ3 * t393 - YZ3 * t395;
        let f3_x = t778 + (MSX3 * t394 + MSY3R * t395);
        let f3_y = f4_z - (MSX3 * t396 + MSY3R * t397);
        let n3_x = t781 + (t810 + MSY3R * a3_z);
        let n3_y = n4_z + (t811 - MSX3 * a3_z);
        let n3_z = t805 + YZ3 * t381 - (MSX3 * t372 + MSY3R * a3_x) - t784;
        let n2_x = c3 * n3_x - s3 * n3_y - k_L2 * (s3 * f3_x + c3 * f3_y);
        let t847 = s3 * n3_x + c3 * n3_y + k_L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, n2_x, t847]
    };
    // link 2: force and moment
    let [t861, n2_z, t870] = {
        let t853 = c2 * (s2 * XX2R + c2 * (XY2 + XY2)) - XY2;
        let t861 = (t853 + t853) * (dq1 * dq2) + t356 * (c2 * XZ2 - s2 * YZ2);
        let n2_z = MSX2 * a2_y - MSY2R * a2_x - t847 - t350 * t853;
        let t870 = s2 * n2_x + c2 * n3_z;
        [t861, n2_z, t870]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t861 + t870;
        n1_z
    };
    // drives
    let [t907, t908, t909, t910, t911, t912, t913] = {
        let t907 = tau1 - (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t908 = tau2 - (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t909 = tau3 - (n3_z + FV3 * dq3 + FC3 * dq3.sign());
        let t910 = tau4 - (n4_z + FV4 * dq4 + FC4 * dq4.sign());
        let t911 = tau5 - (n5_z + FV5 * dq5 + FC5 * dq5.sign());
        let t912 = tau6 - (n6_z + FV6 * dq6 + FC6 * dq6.sign());
        let t913 = tau7 - (n7_z + FV7 * dq7 + FC7 * dq7.sign());
        [t907, t908, t909, t910, t911, t912, t913]
    };
    // M = L D L'
    let [
        t914, t915, t916, t917, t918, t919, t920, t924,
        t928, t931, t934, t937, t940, t947, t954, t959,
        t964, t969, t979, t989, t996, t1003, t1016, t1029,
        t1038, t1054, t1070, t1089,
    ] = {
        let t914 = k3 / t349;
        let t915 = t339 * t914;
        let t916 = t307 * t914;
        let t917 = t261 * t914;
        let t918 = t203 * t914;
        let t919 = t136 * t914;
        let t920 = t63 * t914;
        let t923 = t333 - t349 * (t915 * t915);
        let t924 = k3 / t923;
        let t925 = t349 * t915;
        let t928 = t924 * (t304 + t916 * t925);
        let t931 = t924 * (t258 + t917 * t925);
        let t934 = t924 * (t200 + t918 * t925);
        let t937 = t924 * (t133 + t919 * t925);
        let t940 = t924 * (t60 + t920 * t925);
        let t946 = t285 - t349 * (t916 * t916) - t923 * (t928 * t928);
        let t947 = k3 / t946;
        let t948 = t349 * t916;
        let t951 = t923 * t928;
        let t954 = t947 * (t246 + t917 * t948 + t931 * t951);
        let t959 = t947 * (t184 + t918 * t948 + t934 * t951);
        let t964 = t947 * (t117 + t919 * t948 + t937 * t951);
        let t969 = t947 * (t44 + t920 * t948 + t940 * t951);
        let t977 = t946 * (t954 * t954);
        let t978 = t231 - t349 * (t917 * t917) - t923 * (t931 * t931) - t977;
        let t979 = k3 / t978;
        let t980 = t349 * t917;
        let t983 = t923 * t931;
        let t986 = t946 * t954;
        let t989 = t979 * (t177 - t918 * t980 - t934 * t983 - t959 * t986);
        let t996 = t979 * (t108 - t919 * t980 - t937 * t983 - t964 * t986);
        let t1003 = t979 * (t35 - t920 * t980 - t940 * t983 - t969 * t986);
        let t1011 = t946 * (t959 * t959);
        let t1014 = t978 * (t989 * t989);
        let t1015 = t158 - t349 * (t918 * t918) - t923 * (t934 * t934) - t1011 - t1014;
        let t1016 = k3 / t1015;
        let t1017 = t349 * t918;
        let t1020 = t923 * t934;
        let t1023 = t946 * t959;
        let t1026 = t978 * t989;
        let t1028 = t96 - t919 * t1017 - t937 * t1020 - t964 * t1023 - t996 * t1026;
        let t1029 = t1016 * t1028;
        let t1037 = t19 - t920 * t1017 - t940 * t1020 - t969 * t1023 - t1003 * t1026;
        let t1038 = t1016 * t1037;
        let t1046 = t946 * (t964 * t964);
        let t1049 = t978 * (t996 * t996);
        let t1050 = t81 - t349 * (t919 * t919) - t923 * (t937 * t937) - t1046 - t1049;
        let t1053 = t1050 - t1015 * (t1029 * t1029);
        let t1054 = k3 / t1053;
        let t1062 = t969 * (t946 * t964);
        let t1065 = t1003 * (t978 * t996);
        let t1066 = t11 + t920 * (t349 * t919) + t940 * (t923 * t937) + t1062 + t1065;
        let t1070 = t1054 * (t1066 + t1038 * (t1015 * t1029));
        let t1078 = t946 * (t969 * t969);
        let t1081 = t978 * (t1003 * t1003);
        let t1082 = ZZ7 - t349 * (t920 * t920) - t923 * (t940 * t940) - t1078 - t1081;
        let t1089 = k3 / (t1082 - t1015 * (t1038 * t1038) - t1053 * (t1070 * t1070));
        [
        t914, t915, t916, t917, t918, t919, t920, t924,
        t928, t931, t934, t937, t940, t947, t954, t959,
        t964, t969, t979, t989, t996, t1003, t1016, t1029,
        t1038, t1054, t1070, t1089,
    ]
    };
    // ddq
    {
        let t1091 = t908 - t907 * t915;
        let t1095 = t909 - t907 * t916 + t928 * t1091;
        let t1101 = t910 - t907 * t917 + t931 * t1091 + t954 * t1095;
        let t1109 = t911 - t907 * t918 + t934 * t1091 + t959 * t1095 - t989 * t1101;
        let t1117 = t912 - t907 * t919 + t937 * t1091 + t964 * t1095 - t996 * t1101;
        let t1119 = t1117 - t1029 * t1109;
        let t1127 = t913 - t907 * t920 + t940 * t1091 + t969 * t1095 - t1003 * t1101;
        let t1138 = t1089 * (t1127 - t1038 * t1109 + t1070 * t1119);
        let t1140 = t1054 * t1119 + t1070 * t1138;
        let t1144 = t1016 * t1109 - t1029 * t1140 - t1038 * t1138;
        let t1150 = t979 * t1101 - t989 * t1144 - t996 * t1140 - t1003 * t1138;
        let t1157 = t969 * t1138;
        let t1158 = t947 * t1095 + t954 * t1150 + t959 * t1144 + t964 * t1140 + t1157;
        let t1165 = t937 * t1140;
        let t1166 = t924 * t1091 + t928 * t1158 + t931 * t1150 + t934 * t1144 + t1165;
        let t1168 = t1166 + t940 * t1138;
        let t1175 = t918 * t1144;
        let t1176 = t907 * t914 - t915 * t1168 - t916 * t1158 - t917 * t1150 - t1175;
        let t1180 = t1176 - t919 * t1140 - t920 * t1138;
        put(0, t1180);
        put(1, t1168);
        put(2, t1158);
        put(3, t1150);
        put(4, t1144);
        put(5, t1140);
        put(6, t1138);
    }
}
