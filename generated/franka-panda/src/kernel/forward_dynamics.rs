//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 698 multiplications, 589 additions; 7, 7 of 7 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, Trig};

/// Accelerations that torques cause: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE], out: &mut [S; 7]) {
    entries(trig, dq, tau, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let [tau1, tau2, tau3, tau4, tau5, tau6, tau7] = *tau;
    let [
        ZZ1R, MSX2, MSY2R, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3R, MSY3R, XX3R, ZZ3R,
        XY3R, XZ3, YZ3, MSX4R, MSY4R, XX4R, ZZ4R, XY4R, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6R, MSY6R, XX6R, ZZ6R, XY6R, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7, FV1, FV2, FV3, FV4, FV5,
        FV6, FV7, FC1, FC2, FC3, FC4, FC5, FC6, FC7, FO1, FO2, FO3,
        FO4, FO5, FO6, FO7,
        ..] = *beta;
    let A = S::constant(0.0825);
    let L2 = S::constant(0.316);
    let L3 = S::constant(0.384);
    let k0 = S::constant(0.088);
    let k4 = S::constant(9.81);
    let k5 = S::constant(1.0);
    // composite body 7
    let [
        t2, t5, t8, t11, t21, t40, t55, t72,
        t75, t95, t97, t98, t99,
    ] = {
        let t2 = c7 * MSY7 + s7 * MSX7;
        let t5 = c7 * MSX7 - s7 * MSY7;
        let t8 = c7 * XZ7 - s7 * YZ7;
        let t11 = s7 * XZ7 + c7 * YZ7;
        let t12 = k0 * t5;
        let t13 = ZZ7 + t12;
        let t14 = c6 * t2;
        let t15 = s6 * t2;
        let t18 = c6 * t8 + s6 * t13;
        let t21 = s6 * t8 - c6 * t13;
        let t24 = s5 * t5 - c5 * t14;
        let t27 = s5 * t14 + c5 * t5;
        let t38 = A * t27;
        let t39 = c5 * t18 + s5 * t11 + L3 * t27;
        let t40 = s5 * t18 - c5 * t11 + (L3 * t24 - A * t15);
        let t41 = t21 + t38;
        let t44 = c4 * t24 + s4 * t15;
        let t50 = c4 * t39 - s4 * t41;
        let t55 = s4 * t39 + c4 * t41 - t38;
        let t56 = A * (s4 * t24 - c4 * t15) - t40;
        let t71 = c3 * t50 + s3 * t56 - L2 * (s3 * t44 - c3 * t27);
        let t72 = s3 * t50 - c3 * t56 + L2 * (c3 * t44 + s3 * t27);
        let t75 = s2 * t71 - c2 * t55;
        let t77 = s7 * XY7;
        let t80 = c7 * XY7;
        let t81 = s7 * XX7R + t80;
        let t92 = k0 * (t5 + t5);
        let t95 = c7 * (c7 * XX7R - t77) - s7 * t80 + t92 - (t12 + t12);
        let t97 = c7 * t81 - s7 * t77 - k0 * t2;
        let t98 = s7 * t81 + c7 * t77 + t92;
        let t99 = ZZ7 + t92;
        [
        t2, t5, t8, t11, t21, t40, t55, t72,
        t75, t95, t97, t98, t99,
    ]
    };
    // composite body 6
    let [
        t102, t108, t111, t114, t117, t121, t124, t132,
        t147, t164, t167, t180, t183, t186, t187,
    ] = {
        let t100 = MSX6R + t5;
        let t101 = XX6R + t95;
        let t102 = ZZ6R + t98;
        let t103 = XY6R - t8;
        let t104 = XZ6 + t97;
        let t105 = YZ6 - t11;
        let t108 = c6 * MSY6R + s6 * t100;
        let t111 = c6 * t100 - s6 * MSY6R;
        let t114 = c6 * t104 - s6 * t105;
        let t117 = s6 * t104 + c6 * t105;
        let t118 = c5 * t108;
        let t119 = s5 * t108;
        let t121 = s5 * t102;
        let t124 = c5 * t102;
        let t130 = A * t119;
        let t131 = c5 * t114 + t121 + L3 * t119;
        let t132 = s5 * t114 - t124 + (A * t111 - L3 * t118);
        let t133 = t117 + t130;
        let t136 = c4 * t118 + s4 * t111;
        let t142 = c4 * t131 - s4 * t133;
        let t147 = s4 * t131 + c4 * t133 - t130;
        let t148 = A * (c4 * t111 - s4 * t118) - t132;
        let t163 = c3 * t142 + s3 * t148 + L2 * (s3 * t136 + c3 * t119);
        let t164 = s3 * t142 - c3 * t148 + L2 * (s3 * t119 - c3 * t136);
        let t167 = s2 * t163 - c2 * t147;
        let t169 = s6 * t103;
        let t172 = c6 * t103;
        let t173 = s6 * t101 + t172;
        let t177 = t169 + c6 * t99;
        let t180 = c6 * (c6 * t101 - t169) - s6 * (t172 - s6 * t99);
        let t183 = c6 * t173 - s6 * t177;
        let t186 = s6 * t173 + c6 * t177;
        let t187 = t108 + t108;
        [
        t102, t108, t111, t114, t117, t121, t124, t132,
        t147, t164, t167, t180, t183, t186, t187,
    ]
    };
    // composite body 5
    let [
        t191, t197, t200, t211, t222, t239, t242, t266,
        t267, t268, t271, t272, t276,
    ] = {
        let t188 = MSX5 + t111;
        let t189 = MSY5R - t2;
        let t190 = XX5R + t180;
        let t191 = ZZ5R + t186;
        let t192 = XY5 - t114;
        let t193 = XZ5 + t183;
        let t194 = YZ5 - t117;
        let t197 = c5 * t189 + s5 * t188;
        let t200 = c5 * t188 - s5 * t189;
        let t203 = c5 * t193 - s5 * t194;
        let t207 = L3 * t200;
        let t209 = A * t200;
        let t210 = t203 - t207;
        let t211 = s5 * t193 + c5 * t194 - L3 * t197;
        let t212 = t191 - t209;
        let t213 = c4 * t197;
        let t217 = c4 * t210 - s4 * t212;
        let t222 = t209 + (s4 * t210 + c4 * t212);
        let t223 = t211 + A * (s4 * t197);
        let t238 = c3 * t217 - s3 * t223 - L2 * (c3 * t200 - s3 * t213);
        let t239 = s3 * t217 + c3 * t223 - L2 * (c3 * t213 + s3 * t200);
        let t242 = s2 * t238 - c2 * t222;
        let t244 = s5 * t192;
        let t247 = c5 * t192;
        let t248 = s5 * t190 + t247;
        let t250 = t124 + t244;
        let t263 = L3 * t187 - A * (t200 + t200);
        let t265 = t209 + t209;
        let t266 = c5 * (c5 * t190 - t244) - s5 * (t247 - t121) + t263 + t265;
        let t267 = A * t197;
        let t268 = c5 * t248 - s5 * t250 + t267;
        let t271 = t203 - (t207 - A * t108);
        let t272 = s5 * t248 + c5 * t250 + t263;
        let t274 = L3 * t108;
        let t276 = t191 + t263 - (t274 + t274);
        [
        t191, t197, t200, t211, t222, t239, t242, t266,
        t267, t268, t271, t272, t276,
    ]
    };
    // composite body 4
    let [
        t280, t286, t289, t295, t309, t312, t333, t337,
        t339, t340, t341, t342,
    ] = {
        let t277 = MSX4R + t200;
        let t278 = MSY4R + t108;
        let t279 = XX4R + t266;
        let t280 = ZZ4R + t272;
        let t281 = XY4R + t271;
        let t282 = XZ4 - t268;
        let t283 = YZ4 - t211;
        let t286 = c4 * t278 + s4 * t277;
        let t289 = c4 * t277 - s4 * t278;
        let t292 = c4 * t282 - s4 * t283;
        let t295 = s4 * t282 + c4 * t283;
        let t296 = A * t289;
        let t297 = t280 + t296;
        let t309 = s3 * t292 - c3 * t297 - L2 * (c3 * t286);
        let t311 = c2 * t295;
        let t312 = s2 * (c3 * t292 + s3 * t297 + L2 * (s3 * t286)) - t311;
        let t314 = s4 * t281;
        let t317 = c4 * t281;
        let t318 = s4 * t279 + t317;
        let t322 = t314 + c4 * t276;
        let t333 = t286 + t286;
        let t334 = A * (t289 + t289);
        let t335 = c4 * (c4 * t279 - t314) - s4 * (t317 - s4 * t276) + t334;
        let t337 = t335 - (t296 + t296);
        let t339 = c4 * t318 - s4 * t322 - A * t286;
        let t340 = t267 + t292;
        let t341 = s4 * t318 + c4 * t322 + t334;
        let t342 = t280 + t334;
        [
        t280, t286, t289, t295, t309, t312, t333, t337,
        t339, t340, t341, t342,
    ]
    };
    // composite body 3
    let [t346, t364, t365, t368, t384, t389, t390, t394] = {
        let t343 = MSX3R + t289;
        let t344 = MSY3R + t197;
        let t345 = XX3R + t337;
        let t346 = ZZ3R + t341;
        let t347 = XY3R - t340;
        let t348 = XZ3 + t339;
        let t349 = YZ3 - t295;
        let t364 = c3 * t348 - s3 * t349 - L2 * (c3 * t343 - s3 * t344);
        let t365 = s3 * t348 + c3 * t349 - L2 * (c3 * t344 + s3 * t343);
        let t368 = s2 * t364 - c2 * t346;
        let t370 = s3 * t347;
        let t373 = c3 * t347;
        let t374 = s3 * t345 + t373;
        let t378 = t370 + c3 * t342;
        let t384 = c3 * t374 - s3 * t378;
        let t388 = L2 * t333;
        let t389 = c3 * (c3 * t345 - t370) - s3 * (t373 - s3 * t342) + t388;
        let t390 = s3 * t374 + c3 * t378 + t388;
        let t392 = L2 * t286;
        let t394 = t346 + t388 - (t392 + t392);
        [t346, t364, t365, t368, t384, t389, t390, t394]
    };
    // composite body 2
    let [t396, t402, t411] = {
        let t396 = ZZ2R + t390;
        let t397 = XY2 - t364;
        let t402 = s2 * (XZ2 + t384) + c2 * (YZ2 - t365);
        let t410 = c2 * (s2 * t397 + c2 * t394);
        let t411 = s2 * (s2 * (XX2R + t389) + c2 * t397) + t410;
        [t396, t402, t411]
    };
    // composite body 1
    let t412 = {
        let t412 = ZZ1R + t411;
        t412
    };
    // link 1: motion
    let t413 = {
        let t413 = dq1 * dq1;
        t413
    };
    // link 2: motion
    let [
        t414, t415, t416, t417, t420, dw2_y, t422, t423,
        t424, t425, t426, t427,
    ] = {
        let t414 = s2 * dq1;
        let t415 = c2 * dq1;
        let t416 = s2 * k4;
        let t417 = c2 * k4;
        let t418 = t414 * t414;
        let t419 = dq2 * dq2;
        let t420 = t414 * t415;
        let dw2_y = dq2 * t414;
        let t422 = dq2 * t415;
        let t423 = t418 - t419;
        let t424 = t423 - t413;
        let t425 = t418 + t419;
        let t426 = dw2_y + dw2_y;
        let t427 = t422 + t422;
        [
        t414, t415, t416, t417, t420, dw2_y, t422, t423,
        t424, t425, t426, t427,
    ]
    };
    // link 3: motion
    let [
        w3_x, w3_y, t438, a3_x, a3_y, t447, t450, w3_z,
        t454, t455, t456, dw3_x, dw3_y, t459, t460, t461,
        t462, t463, t464, t465,
    ] = {
        let w3_x = s3 * dq2 - c3 * t414;
        let w3_y = c3 * dq2 + s3 * t414;
        let t436 = L2 * t427;
        let t437 = t416 + L2 * t420;
        let t438 = L2 * t425 - t417;
        let a3_x = s3 * t436 - c3 * t437;
        let a3_y = c3 * t436 + s3 * t437;
        let t447 = s3 * t427 - c3 * t420;
        let t450 = c3 * t427 + s3 * t420;
        let w3_z = t415 + dq3;
        let t452 = w3_x * w3_x;
        let t453 = w3_z * w3_z;
        let t454 = w3_x * w3_y;
        let t455 = w3_x * w3_z;
        let t456 = w3_y * w3_z;
        let dw3_x = t456 - t450;
        let dw3_y = t447 - t455;
        let t459 = t452 - t453;
        let t460 = t459 - t425;
        let t461 = dw2_y + t454;
        let t462 = t454 - dw2_y;
        let t463 = t452 + t453;
        let t464 = t455 - dw3_y;
        let t465 = t456 + dw3_x;
        [
        w3_x, w3_y, t438, a3_x, a3_y, t447, t450, w3_z,
        t454, t455, t456, dw3_x, dw3_y, t459, t460, t461,
        t462, t463, t464, t465,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t476, a4_x, a4_y, t486, t489, w4_z,
        t493, t494, t495, dw4_x, t497, t498, t499, t500,
        t501, t502, t503, t504,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t475 = a3_x + A * t460;
        let t476 = a3_y + A * t462;
        let t477 = A * t464 - t438;
        let a4_x = c4 * t475 + s4 * t477;
        let a4_y = c4 * t477 - s4 * t475;
        let t486 = c4 * t461 + s4 * t465;
        let t489 = s4 * t461 - c4 * t465;
        let w4_z = dq4 - w3_y;
        let t491 = w4_x * w4_x;
        let t492 = w4_z * w4_z;
        let t493 = w4_x * w4_y;
        let t494 = w4_x * w4_z;
        let t495 = w4_y * w4_z;
        let dw4_x = t495 - t489;
        let t497 = t486 + t494;
        let t498 = t491 - t492;
        let t499 = t498 - t463;
        let t500 = dw3_y + t493;
        let t501 = t493 - dw3_y;
        let t502 = t491 + t492;
        let t503 = t494 + t497;
        let t504 = t495 + dw4_x;
        [
        w4_x, w4_y, t476, a4_x, a4_y, t486, t489, w4_z,
        t493, t494, t495, dw4_x, t497, t498, t499, t500,
        t501, t502, t503, t504,
    ]
    };
    // link 5: motion
    let [
        w5_x, t510, a5_z, a5_x, a6_z, t531, t534, w5_z,
        t538, t539, t540, dw5_x, dw5_y, t543, t544, t545,
        t546, t547, t548, t549,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t510 = c5 * w4_z + s5 * w4_x;
        let t520 = a4_x + (L3 * t500 - A * t499);
        let a5_z = a4_y - (A * t501 + L3 * t502);
        let t522 = L3 * t504 - A * t503 - t476;
        let a5_x = c5 * t520 - s5 * t522;
        let a6_z = c5 * t522 + s5 * t520;
        let t531 = c5 * t500 - s5 * t504;
        let t534 = c5 * t504 + s5 * t500;
        let w5_z = w4_y + dq5;
        let t536 = w5_x * w5_x;
        let t537 = w5_z * w5_z;
        let t538 = w5_x * t510;
        let t539 = w5_x * w5_z;
        let t540 = t510 * w5_z;
        let dw5_x = t534 - t540;
        let dw5_y = t531 - t539;
        let t543 = t536 - t537;
        let t544 = t543 - t502;
        let t545 = t497 - t538;
        let t546 = t497 + t538;
        let t547 = t536 + t537;
        let t548 = t539 - dw5_y;
        let t549 = dw5_x - t540;
        [
        w5_x, t510, a5_z, a5_x, a6_z, t531, t534, w5_z,
        t538, t539, t540, dw5_x, dw5_y, t543, t544, t545,
        t546, t547, t548, t549,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, a6_x, a6_y, t564, t567, w6_z, t571,
        t572, t573, dw6_x, dw7_z, t576, t577, t578, t579,
        t580, t581, t582,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let a6_x = c6 * a5_x + s6 * a5_z;
        let a6_y = c6 * a5_z - s6 * a5_x;
        let t564 = c6 * t545 + s6 * t549;
        let t567 = s6 * t545 - c6 * t549;
        let w6_z = t510 + dq6;
        let t569 = w6_x * w6_x;
        let t570 = w6_z * w6_z;
        let t571 = w6_x * w6_y;
        let t572 = w6_x * w6_z;
        let t573 = w6_y * w6_z;
        let dw6_x = t573 - t567;
        let dw7_z = t564 + t572;
        let t576 = t569 - t570;
        let t577 = t576 - t547;
        let t578 = dw5_y + t571;
        let t579 = t571 - dw5_y;
        let t580 = t569 + t570;
        let t581 = t572 + dw7_z;
        let t582 = t573 + dw6_x;
        [
        w6_x, w6_y, a6_x, a6_y, t564, t567, w6_z, t571,
        t572, t573, dw6_x, dw7_z, t576, t577, t578, t579,
        t580, t581, t582,
    ]
    };
    // link 7: motion
    let [
        t593, a7_x, a7_y, t603, t606, t610, t611, t612,
        dw7_x, t615, t616, t617, t618, t619, t620, t621,
    ] = {
        let w7_x = c7 * w6_x + s7 * w6_z;
        let w7_y = c7 * w6_z - s7 * w6_x;
        let t592 = a6_x + k0 * t577;
        let t593 = a6_y + k0 * t579;
        let t594 = a6_z + k0 * t581;
        let a7_x = c7 * t592 + s7 * t594;
        let a7_y = c7 * t594 - s7 * t592;
        let t603 = c7 * t578 + s7 * t582;
        let t606 = s7 * t578 - c7 * t582;
        let w7_z = dq7 - w6_y;
        let t608 = w7_x * w7_x;
        let t609 = w7_z * w7_z;
        let t610 = w7_x * w7_y;
        let t611 = w7_x * w7_z;
        let t612 = w7_y * w7_z;
        let dw7_x = t612 - t606;
        let t615 = t608 - t609;
        let t616 = t615 - t580;
        let t617 = t610 - dw7_z;
        let t618 = dw7_z + t610;
        let t619 = t608 + t609;
        let t620 = t611 + (t603 + t611);
        let t621 = t612 + dw7_x;
        [
        t593, a7_x, a7_y, t603, t606, t610, t611, t612,
        dw7_x, t615, t616, t617, t618, t619, t620, t621,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t669, t672, t675, t681, t682] = {
        let t642 = ZZ7 * dw7_z - XX7R * t610 + XY7 * (t616 + t619) - XZ7 * t606;
        let t644 = YZ7 * (t580 - t619);
        let t647 = ZZ7 * t612 + XX7R * dw7_x - XY7 * t620 + XZ7 * t618 + t644;
        let t648 = t611 * (XX7R - ZZ7) + XY7 * t621 - XZ7 * t615 - YZ7 * t617;
        let f7_x = MSX7 * t616 + MSY7 * t617;
        let f7_y = MSX7 * t618 - MSY7 * t619;
        let f7_z = MSX7 * t620 + MSY7 * t621;
        let n7_x = t647 - MSY7 * t593;
        let n7_y = t648 + MSX7 * t593;
        let n7_z = t642 - YZ7 * t603 + (MSX7 * a7_y - MSY7 * a7_x);
        let t669 = c7 * f7_x - s7 * f7_y;
        let t672 = s7 * f7_x + c7 * f7_y;
        let t675 = c7 * n7_x - s7 * n7_y;
        let t681 = s7 * n7_x + c7 * n7_y - k0 * f7_z;
        let t682 = n7_z + k0 * t672;
        [f7_z, n7_z, t669, t672, t675, t681, t682]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t736, t739, t742, t745] = {
        let t703 = XY6R * (t577 + t580) - (XX6R * t571 + ZZ6R * dw5_y) - XZ6 * t567;
        let t705 = YZ6 * (t547 - t580);
        let t708 = ZZ6R * t573 + XX6R * dw6_x - XY6R * t581 + XZ6 * t579 + t705;
        let t709 = t572 * (XX6R - ZZ6R) + XY6R * t582 - XZ6 * t576 - YZ6 * t578;
        let f6_x = t669 + (MSX6R * t577 + MSY6R * t578);
        let f6_y = MSX6R * t579 - MSY6R * t580 - f7_z;
        let f6_z = t672 + (MSX6R * t581 + MSY6R * t582);
        let n6_x = t675 + (t708 + MSY6R * a6_z);
        let n6_y = t709 - MSX6R * a6_z - t682;
        let n6_z = t681 + (t703 - YZ6 * t564 + (MSX6R * a6_y - MSY6R * a6_x));
        let t736 = c6 * f6_x - s6 * f6_y;
        let t739 = s6 * f6_x + c6 * f6_y;
        let t742 = c6 * n6_x - s6 * n6_y;
        let t745 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t736, t739, t742, t745]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t799, t802, t814, t815, t816] = {
        let t766 = XX5R * t538 - ZZ5R * t497 + XY5 * (t544 + t547) + XZ5 * t534;
        let t768 = YZ5 * (t502 - t547);
        let t771 = XX5R * dw5_x - ZZ5R * t540 - XY5 * t548 - XZ5 * t546 + t768;
        let t772 = t539 * (XX5R - ZZ5R) + XY5 * t549 - XZ5 * t543 - YZ5 * t545;
        let f5_x = t736 + (MSX5 * t544 + MSY5R * t545);
        let t792 = f6_z + (MSX5 * t546 + MSY5R * t547);
        let f5_z = t739 + (MSX5 * t548 + MSY5R * t549);
        let n5_x = t742 + (t771 + MSY5R * a5_z);
        let n5_y = t772 - MSX5 * a5_z - n6_z;
        let n5_z = t745 + (t766 + YZ5 * t531 - (MSX5 * a6_z + MSY5R * a5_x));
        let t799 = c5 * f5_x + s5 * t792;
        let t802 = s5 * f5_x - c5 * t792;
        let t814 = c5 * n5_x - s5 * n5_y - L3 * t802;
        let t815 = s5 * n5_x + c5 * n5_y + (L3 * t799 + A * f5_z);
        let t816 = n5_z - A * t802;
        [f5_z, n5_z, t799, t802, t814, t815, t816]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t870, t876, t882, t883] = {
        let t837 = XY4R * (t499 + t502) - (XX4R * t493 + ZZ4R * dw3_y) - XZ4 * t489;
        let t839 = YZ4 * (t463 - t502);
        let t842 = ZZ4R * t495 + XX4R * dw4_x - XY4R * t503 + XZ4 * t501 + t839;
        let t843 = t494 * (XX4R - ZZ4R) + XY4R * t504 - XZ4 * t498 - YZ4 * t500;
        let f4_x = t799 + (MSX4R * t499 + MSY4R * t500);
        let f4_y = f5_z + (MSX4R * t501 - MSY4R * t502);
        let f4_z = MSX4R * t503 + MSY4R * t504 - t802;
        let n4_x = t814 + (t842 - MSY4R * t476);
        let n4_y = t816 + (t843 + MSX4R * t476);
        let n4_z = t837 - YZ4 * t486 + (MSX4R * a4_y - MSY4R * a4_x) - t815;
        let t870 = c4 * f4_x - s4 * f4_y;
        let t876 = c4 * n4_x - s4 * n4_y;
        let t882 = s4 * n4_x + c4 * n4_y - A * f4_z;
        let t883 = n4_z + A * (s4 * f4_x + c4 * f4_y);
        [f4_z, n4_z, t870, t876, t882, t883]
    };
    // link 3: force and moment
    let [n3_z, t945, t946] = {
        let t904 = XY3R * (t460 + t463) - (XX3R * t454 + ZZ3R * dw2_y) - XZ3 * t450;
        let t906 = YZ3 * (t425 - t463);
        let t909 = ZZ3R * t456 + XX3R * dw3_x - XY3R * t464 + XZ3 * t462 + t906;
        let t910 = t455 * (XX3R - ZZ3R) + XY3R * t465 - XZ3 * t459 - YZ3 * t461;
        let f3_x = t870 + (MSX3R * t460 + MSY3R * t461);
        let f3_y = MSX3R * t462 - MSY3R * t463 - f4_z;
        let n3_x = t876 + (t909 - MSY3R * t438);
        let n3_y = t910 + MSX3R * t438 - t883;
        let n3_z = t882 + (t904 + YZ3 * t447 + (MSX3R * a3_y - MSY3R * a3_x));
        let t945 = c3 * n3_x - s3 * n3_y - L2 * (s3 * f3_x + c3 * f3_y);
        let t946 = s3 * n3_x + c3 * n3_y + L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, t945, t946]
    };
    // link 2: force and moment
    let [n2_z, t977] = {
        let t964 = YZ2 * (t413 - t425);
        let t967 = dw2_y * (XX2R - ZZ2R) + XY2 * t427 + XZ2 * t423 + YZ2 * t420;
        let t971 = XY2 * (t424 + t425) - XX2R * t420 + (MSY2R * t416 - MSX2 * t417);
        let n2_x = t945 + (XY2 * t426 - t422 * (XX2R + ZZ2R) + XZ2 * t420 + t964);
        let n2_z = t946 + t971;
        let t977 = s2 * n2_x - c2 * (n3_z + t967);
        [n2_z, t977]
    };
    // drives
    let [t1020, t1021, t1022, t1023, t1024, t1025, t1026] = {
        let t1020 = tau1 - (FO1 + (FV1 * dq1 - t977 + FC1 * dq1.sign()));
        let t1021 = tau2 - (FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign()));
        let t1022 = tau3 - (FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign()));
        let t1023 = tau4 - (FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign()));
        let t1024 = tau5 - (FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign()));
        let t1025 = tau6 - (FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign()));
        let t1026 = tau7 - (FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign()));
        [t1020, t1021, t1022, t1023, t1024, t1025, t1026]
    };
    // M = L D L'
    let [
        t1027, t1028, t1029, t1030, t1031, t1032, t1033, t1037,
        t1041, t1044, t1047, t1050, t1053, t1060, t1067, t1072,
        t1077, t1082, t1092, t1102, t1109, t1116, t1129, t1142,
        t1151, t1167, t1183, t1202,
    ] = {
        let t1027 = k5 / t412;
        let t1028 = t402 * t1027;
        let t1029 = t368 * t1027;
        let t1030 = t312 * t1027;
        let t1031 = t242 * t1027;
        let t1032 = t167 * t1027;
        let t1033 = t75 * t1027;
        let t1036 = t396 - t412 * (t1028 * t1028);
        let t1037 = k5 / t1036;
        let t1038 = t412 * t1028;
        let t1041 = t1037 * (t365 - t1029 * t1038);
        let t1044 = t1037 * (t309 - t1030 * t1038);
        let t1047 = t1037 * (t239 - t1031 * t1038);
        let t1050 = t1037 * (t164 - t1032 * t1038);
        let t1053 = t1037 * (t72 - t1033 * t1038);
        let t1059 = t346 - t412 * (t1029 * t1029) - t1036 * (t1041 * t1041);
        let t1060 = k5 / t1059;
        let t1061 = t412 * t1029;
        let t1064 = t1036 * t1041;
        let t1067 = t1060 * (t295 - t1030 * t1061 - t1044 * t1064);
        let t1072 = t1060 * (t222 - t1031 * t1061 - t1047 * t1064);
        let t1077 = t1060 * (t147 - t1032 * t1061 - t1050 * t1064);
        let t1082 = t1060 * (t55 - t1033 * t1061 - t1053 * t1064);
        let t1090 = t1059 * (t1067 * t1067);
        let t1091 = t280 - t412 * (t1030 * t1030) - t1036 * (t1044 * t1044) - t1090;
        let t1092 = k5 / t1091;
        let t1093 = t412 * t1030;
        let t1096 = t1036 * t1044;
        let t1099 = t1059 * t1067;
        let t1102 = t1092 * (t211 + t1031 * t1093 + t1047 * t1096 + t1072 * t1099);
        let t1109 = t1092 * (t132 + t1032 * t1093 + t1050 * t1096 + t1077 * t1099);
        let t1116 = t1092 * (t40 + t1033 * t1093 + t1053 * t1096 + t1082 * t1099);
        let t1124 = t1059 * (t1072 * t1072);
        let t1127 = t1091 * (t1102 * t1102);
        let t1128 = t191 - t412 * (t1031 * t1031) - t1036 * (t1047 * t1047) - t1124 - t1127;
        let t1129 = k5 / t1128;
        let t1130 = t412 * t1031;
        let t1133 = t1036 * t1047;
        let t1136 = t1059 * t1072;
        let t1139 = t1091 * t1102;
        let t1141 = t117 - t1032 * t1130 - t1050 * t1133 - t1077 * t1136 - t1109 * t1139;
        let t1142 = t1129 * t1141;
        let t1150 = t21 - t1033 * t1130 - t1053 * t1133 - t1082 * t1136 - t1116 * t1139;
        let t1151 = t1129 * t1150;
        let t1159 = t1059 * (t1077 * t1077);
        let t1162 = t1091 * (t1109 * t1109);
        let t1163 = t102 - t412 * (t1032 * t1032) - t1036 * (t1050 * t1050) - t1159 - t1162;
        let t1166 = t1163 - t1128 * (t1142 * t1142);
        let t1167 = k5 / t1166;
        let t1175 = t1082 * (t1059 * t1077);
        let t1178 = t1116 * (t1091 * t1109);
        let t1179 = t11 - t1033 * (t412 * t1032) - t1053 * (t1036 * t1050) - t1175 - t1178;
        let t1183 = t1167 * (t1179 - t1151 * (t1128 * t1142));
        let t1191 = t1059 * (t1082 * t1082);
        let t1194 = t1091 * (t1116 * t1116);
        let t1195 = ZZ7 - t412 * (t1033 * t1033) - t1036 * (t1053 * t1053) - t1191 - t1194;
        let t1202 = k5 / (t1195 - t1128 * (t1151 * t1151) - t1166 * (t1183 * t1183));
        [
        t1027, t1028, t1029, t1030, t1031, t1032, t1033, t1037,
        t1041, t1044, t1047, t1050, t1053, t1060, t1067, t1072,
        t1077, t1082, t1092, t1102, t1109, t1116, t1129, t1142,
        t1151, t1167, t1183, t1202,
    ]
    };
    // ddq
    {
        let t1204 = t1021 + t1020 * t1028;
        let t1208 = t1022 + t1020 * t1029 - t1041 * t1204;
        let t1214 = t1023 + t1020 * t1030 - t1044 * t1204 - t1067 * t1208;
        let t1222 = t1024 + t1020 * t1031 - t1047 * t1204 - t1072 * t1208 + t1102 * t1214;
        let t1230 = t1025 + t1020 * t1032 - t1050 * t1204 - t1077 * t1208 + t1109 * t1214;
        let t1232 = t1230 - t1142 * t1222;
        let t1240 = t1026 + t1020 * t1033 - t1053 * t1204 - t1082 * t1208 + t1116 * t1214;
        let t1251 = t1202 * (t1240 - t1151 * t1222 - t1183 * t1232);
        let t1253 = t1167 * t1232 - t1183 * t1251;
        let t1257 = t1129 * t1222 - t1142 * t1253 - t1151 * t1251;
        let t1263 = t1092 * t1214 + t1102 * t1257 + t1109 * t1253 + t1116 * t1251;
        let t1270 = t1082 * t1251;
        let t1271 = t1060 * t1208 - t1067 * t1263 - t1072 * t1257 - t1077 * t1253 - t1270;
        let t1278 = t1050 * t1253;
        let t1279 = t1037 * t1204 - t1041 * t1271 - t1044 * t1263 - t1047 * t1257 - t1278;
        let t1281 = t1279 - t1053 * t1251;
        let t1288 = t1031 * t1257;
        let t1289 = t1020 * t1027 + t1028 * t1281 + t1029 * t1271 + t1030 * t1263 + t1288;
        let t1293 = t1289 + t1032 * t1253 + t1033 * t1251;
        put(0, t1293);
        put(1, t1281);
        put(2, t1271);
        put(3, t1263);
        put(4, t1257);
        put(5, t1253);
        put(6, t1251);
    }
}
