//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 711 multiplications, 596 additions; 7, 7 of 7 structurally nonzero.

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
    // link 2: motion
    let [t413, t414, t415, t416, t417, dw2_y] = {
        let t413 = s2 * dq1;
        let t414 = c2 * dq1;
        let t415 = s2 * k4;
        let t416 = c2 * k4;
        let t417 = dq2 * t414;
        let dw2_y = dq2 * t413;
        [t413, t414, t415, t416, t417, dw2_y]
    };
    // link 3: motion
    let [
        w3_x, w3_y, t427, t428, t429, t430, t432, t433,
        t438, a3_x, a3_y, w3_z, dw3_x, dw3_y,
    ] = {
        let w3_x = s3 * dq2 - c3 * t413;
        let w3_y = c3 * dq2 + s3 * t413;
        let t427 = t413 * t413;
        let t428 = t414 * t414;
        let t429 = dq2 * dq2;
        let t430 = t413 * t414;
        let t432 = dw2_y + dw2_y;
        let t433 = t417 + t417;
        let t436 = L2 * t433;
        let t437 = t415 + L2 * t430;
        let t438 = L2 * (t427 + t429) - t416;
        let a3_x = s3 * t436 - c3 * t437;
        let a3_y = c3 * t436 + s3 * t437;
        let w3_z = t414 + dq3;
        let dw3_x = dq3 * w3_y - c3 * t417;
        let dw3_y = s3 * t417 - dq3 * w3_x;
        [
        w3_x, w3_y, t427, t428, t429, t430, t432, t433,
        t438, a3_x, a3_y, w3_z, dw3_x, dw3_y,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t462, t463, t464, t465, t466, t467,
        t468, t469, t470, t471, t472, t473, t474, t475,
        t480, a4_x, a4_y, w4_z, dw4_x, t492,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t462 = w3_x * w3_x;
        let t463 = w3_y * w3_y;
        let t464 = w3_z * w3_z;
        let t465 = w3_x * w3_y;
        let t466 = w3_x * w3_z;
        let t467 = w3_y * w3_z;
        let t468 = t463 + t464;
        let t469 = dw2_y + t465;
        let t470 = dw3_y + t466;
        let t471 = t465 - dw2_y;
        let t472 = t462 + t464;
        let t473 = t467 - dw3_x;
        let t474 = t466 - dw3_y;
        let t475 = dw3_x + t467;
        let t479 = a3_x - A * t468;
        let t480 = a3_y + A * t471;
        let t481 = A * t474 - t438;
        let a4_x = c4 * t479 + s4 * t481;
        let a4_y = c4 * t481 - s4 * t479;
        let w4_z = dq4 - w3_y;
        let dw4_x = c4 * dw3_x - s4 * dw2_y + dq4 * w4_y;
        let t492 = c4 * dw2_y + s4 * dw3_x + dq4 * w4_x;
        [
        w4_x, w4_y, t462, t463, t464, t465, t466, t467,
        t468, t469, t470, t471, t472, t473, t474, t475,
        t480, a4_x, a4_y, w4_z, dw4_x, t492,
    ]
    };
    // link 5: motion
    let [
        w5_x, t498, t505, t506, t507, t508, t509, t510,
        t511, t512, t513, t514, t515, t516, t517, t518,
        a5_z, a5_x, a6_z, w5_z, dw5_x, dw5_y,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t498 = c5 * w4_z + s5 * w4_x;
        let t505 = w4_x * w4_x;
        let t506 = w4_y * w4_y;
        let t507 = w4_z * w4_z;
        let t508 = w4_x * w4_y;
        let t509 = w4_x * w4_z;
        let t510 = w4_y * w4_z;
        let t511 = t506 + t507;
        let t512 = dw3_y + t508;
        let t513 = t509 - t492;
        let t514 = t508 - dw3_y;
        let t515 = t505 + t507;
        let t516 = t510 - dw4_x;
        let t517 = t492 + t509;
        let t518 = dw4_x + t510;
        let t528 = a4_x + (A * t511 + L3 * t512);
        let a5_z = a4_y - (A * t514 + L3 * t515);
        let t530 = L3 * t518 - A * t517 - t480;
        let a5_x = c5 * t528 - s5 * t530;
        let a6_z = c5 * t530 + s5 * t528;
        let w5_z = w4_y + dq5;
        let dw5_x = c5 * dw4_x + s5 * dw3_y - dq5 * t498;
        let dw5_y = c5 * dw3_y - s5 * dw4_x - dq5 * w5_x;
        [
        w5_x, t498, t505, t506, t507, t508, t509, t510,
        t511, t512, t513, t514, t515, t516, t517, t518,
        a5_z, a5_x, a6_z, w5_z, dw5_x, dw5_y,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t554, t555, t556, t557, t558, t559,
        t560, t561, t562, t563, t564, t565, t566, t567,
        a6_x, a6_y, w6_z, dw6_x, dw7_z,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t554 = w5_x * w5_x;
        let t555 = t498 * t498;
        let t556 = w5_z * w5_z;
        let t557 = w5_x * t498;
        let t558 = w5_x * w5_z;
        let t559 = t498 * w5_z;
        let t560 = t555 + t556;
        let t561 = t492 - t557;
        let t562 = dw5_y + t558;
        let t563 = t492 + t557;
        let t564 = t554 + t556;
        let t565 = dw5_x + t559;
        let t566 = t558 - dw5_y;
        let t567 = dw5_x - t559;
        let a6_x = c6 * a5_x + s6 * a5_z;
        let a6_y = c6 * a5_z - s6 * a5_x;
        let w6_z = t498 + dq6;
        let dw6_x = c6 * dw5_x - s6 * t492 + dq6 * w6_y;
        let dw7_z = c6 * t492 + s6 * dw5_x + dq6 * w6_x;
        [
        w6_x, w6_y, t554, t555, t556, t557, t558, t559,
        t560, t561, t562, t563, t564, t565, t566, t567,
        a6_x, a6_y, w6_z, dw6_x, dw7_z,
    ]
    };
    // link 7: motion
    let [
        w7_x, w7_y, t591, t592, t593, t594, t595, t596,
        t597, t598, t599, t600, t601, t602, t603, t604,
        t609, a7_x, a7_y, w7_z, dw7_x, t621,
    ] = {
        let w7_x = c7 * w6_x + s7 * w6_z;
        let w7_y = c7 * w6_z - s7 * w6_x;
        let t591 = w6_x * w6_x;
        let t592 = w6_y * w6_y;
        let t593 = w6_z * w6_z;
        let t594 = w6_x * w6_y;
        let t595 = w6_x * w6_z;
        let t596 = w6_y * w6_z;
        let t597 = t592 + t593;
        let t598 = dw5_y + t594;
        let t599 = t595 - dw7_z;
        let t600 = t594 - dw5_y;
        let t601 = t591 + t593;
        let t602 = t596 - dw6_x;
        let t603 = dw7_z + t595;
        let t604 = dw6_x + t596;
        let t608 = a6_x - k0 * t597;
        let t609 = a6_y + k0 * t600;
        let t610 = a6_z + k0 * t603;
        let a7_x = c7 * t608 + s7 * t610;
        let a7_y = c7 * t610 - s7 * t608;
        let w7_z = dq7 - w6_y;
        let dw7_x = c7 * dw6_x - s7 * dw5_y + dq7 * w7_y;
        let t621 = c7 * dw5_y + s7 * dw6_x + dq7 * w7_x;
        [
        w7_x, w7_y, t591, t592, t593, t594, t595, t596,
        t597, t598, t599, t600, t601, t602, t603, t604,
        t609, a7_x, a7_y, w7_z, dw7_x, t621,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t684, t687, t690, t696, t697] = {
        let t622 = w7_x * w7_x;
        let t623 = w7_y * w7_y;
        let t624 = w7_z * w7_z;
        let t625 = w7_x * w7_y;
        let t626 = w7_x * w7_z;
        let t627 = w7_y * w7_z;
        let t629 = t625 - dw7_z;
        let t631 = dw7_z + t625;
        let t634 = t621 + t626;
        let t635 = dw7_x + t627;
        let t654 = XZ7 * (t627 - dw7_x);
        let t659 = YZ7 * (t623 - t624);
        let t660 = YZ7 * t629;
        let t661 = YZ7 * (t626 - t621);
        let t662 = ZZ7 * t627 + XX7R * dw7_x - XY7 * t634 + XZ7 * t631 + t659;
        let t663 = t626 * (XX7R - ZZ7) + XY7 * t635 + XZ7 * (t624 - t622) - t660;
        let t664 = ZZ7 * dw7_z - XX7R * t625 + XY7 * (t622 - t623) - t654 + t661;
        let f7_x = MSY7 * t629 - MSX7 * (t623 + t624);
        let f7_y = MSX7 * t631 - MSY7 * (t622 + t624);
        let f7_z = MSX7 * t634 + MSY7 * t635;
        let n7_x = t662 - MSY7 * t609;
        let n7_y = t663 + MSX7 * t609;
        let n7_z = t664 + (MSX7 * a7_y - MSY7 * a7_x);
        let t684 = c7 * f7_x - s7 * f7_y;
        let t687 = s7 * f7_x + c7 * f7_y;
        let t690 = c7 * n7_x - s7 * n7_y;
        let t696 = s7 * n7_x + c7 * n7_y - k0 * f7_z;
        let t697 = n7_z + k0 * t687;
        [f7_z, n7_z, t684, t687, t690, t696, t697]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t752, t755, t758, t761] = {
        let t719 = XY6R * (t591 - t592) - (XX6R * t594 + ZZ6R * dw5_y) - XZ6 * t602;
        let t721 = YZ6 * (t592 - t593);
        let t722 = YZ6 * t598;
        let t724 = ZZ6R * t596 + XX6R * dw6_x - XY6R * t603 + XZ6 * t600 + t721;
        let t725 = t595 * (XX6R - ZZ6R) + XY6R * t604 + XZ6 * (t593 - t591) - t722;
        let f6_x = t684 + (MSY6R * t598 - MSX6R * t597);
        let f6_y = MSX6R * t600 - MSY6R * t601 - f7_z;
        let f6_z = t687 + (MSX6R * t603 + MSY6R * t604);
        let n6_x = t690 + (t724 + MSY6R * a6_z);
        let n6_y = t725 - MSX6R * a6_z - t697;
        let n6_z = t696 + (t719 + YZ6 * t599 + (MSX6R * a6_y - MSY6R * a6_x));
        let t752 = c6 * f6_x - s6 * f6_y;
        let t755 = s6 * f6_x + c6 * f6_y;
        let t758 = c6 * n6_x - s6 * n6_y;
        let t761 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t752, t755, t758, t761]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t816, t819, t831, t832, t833] = {
        let t783 = XX5R * t557 - ZZ5R * t492 + XY5 * (t554 - t555) + XZ5 * t565;
        let t785 = YZ5 * (t555 - t556);
        let t786 = YZ5 * t561;
        let t788 = XX5R * dw5_x - ZZ5R * t559 - XY5 * t566 - XZ5 * t563 + t785;
        let t789 = t558 * (XX5R - ZZ5R) + XY5 * t567 + XZ5 * (t556 - t554) - t786;
        let f5_x = t752 + (MSY5R * t561 - MSX5 * t560);
        let t809 = f6_z + (MSX5 * t563 + MSY5R * t564);
        let f5_z = t755 + (MSX5 * t566 + MSY5R * t567);
        let n5_x = t758 + (t788 + MSY5R * a5_z);
        let n5_y = t789 - MSX5 * a5_z - n6_z;
        let n5_z = t761 + (t783 + YZ5 * t562 - (MSX5 * a6_z + MSY5R * a5_x));
        let t816 = c5 * f5_x + s5 * t809;
        let t819 = s5 * f5_x - c5 * t809;
        let t831 = c5 * n5_x - s5 * n5_y - L3 * t819;
        let t832 = s5 * n5_x + c5 * n5_y + (L3 * t816 + A * f5_z);
        let t833 = n5_z - A * t819;
        [f5_z, n5_z, t816, t819, t831, t832, t833]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t888, t894, t900, t901] = {
        let t855 = XY4R * (t505 - t506) - (XX4R * t508 + ZZ4R * dw3_y) - XZ4 * t516;
        let t857 = YZ4 * (t506 - t507);
        let t858 = YZ4 * t512;
        let t860 = ZZ4R * t510 + XX4R * dw4_x - XY4R * t517 + XZ4 * t514 + t857;
        let t861 = t509 * (XX4R - ZZ4R) + XY4R * t518 + XZ4 * (t507 - t505) - t858;
        let f4_x = t816 + (MSY4R * t512 - MSX4R * t511);
        let f4_y = f5_z + (MSX4R * t514 - MSY4R * t515);
        let f4_z = MSX4R * t517 + MSY4R * t518 - t819;
        let n4_x = t831 + (t860 - MSY4R * t480);
        let n4_y = t833 + (t861 + MSX4R * t480);
        let n4_z = t855 + YZ4 * t513 + (MSX4R * a4_y - MSY4R * a4_x) - t832;
        let t888 = c4 * f4_x - s4 * f4_y;
        let t894 = c4 * n4_x - s4 * n4_y;
        let t900 = s4 * n4_x + c4 * n4_y - A * f4_z;
        let t901 = n4_z + A * (s4 * f4_x + c4 * f4_y);
        [f4_z, n4_z, t888, t894, t900, t901]
    };
    // link 3: force and moment
    let [n3_z, t964, t965] = {
        let t923 = XY3R * (t462 - t463) - (XX3R * t465 + ZZ3R * dw2_y) - XZ3 * t473;
        let t925 = YZ3 * (t463 - t464);
        let t926 = YZ3 * t469;
        let t928 = ZZ3R * t467 + XX3R * dw3_x - XY3R * t474 + XZ3 * t471 + t925;
        let t929 = t466 * (XX3R - ZZ3R) + XY3R * t475 + XZ3 * (t464 - t462) - t926;
        let f3_x = t888 + (MSY3R * t469 - MSX3R * t468);
        let f3_y = MSX3R * t471 - MSY3R * t472 - f4_z;
        let n3_x = t894 + (t928 - MSY3R * t438);
        let n3_y = t929 + MSX3R * t438 - t901;
        let n3_z = t900 + (t923 + YZ3 * t470 + (MSX3R * a3_y - MSY3R * a3_x));
        let t964 = c3 * n3_x - s3 * n3_y - L2 * (s3 * f3_x + c3 * f3_y);
        let t965 = s3 * n3_x + c3 * n3_y + L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, t964, t965]
    };
    // link 2: force and moment
    let [n2_z, t997] = {
        let t984 = YZ2 * (t428 - t429);
        let t985 = YZ2 * t430;
        let t987 = XZ2 * (t429 - t427) - (dw2_y * (XX2R - ZZ2R) + XY2 * t433) - t985;
        let t991 = XY2 * (t427 - t428) - XX2R * t430 + (MSY2R * t415 - MSX2 * t416);
        let n2_x = t964 + (XY2 * t432 - t417 * (XX2R + ZZ2R) + XZ2 * t430 + t984);
        let n2_y = t987 - n3_z;
        let n2_z = t965 + t991;
        let t997 = s2 * n2_x + c2 * n2_y;
        [n2_z, t997]
    };
    // drives
    let [t1040, t1041, t1042, t1043, t1044, t1045, t1046] = {
        let t1040 = tau1 - (FO1 + (FV1 * dq1 - t997 + FC1 * dq1.sign()));
        let t1041 = tau2 - (FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign()));
        let t1042 = tau3 - (FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign()));
        let t1043 = tau4 - (FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign()));
        let t1044 = tau5 - (FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign()));
        let t1045 = tau6 - (FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign()));
        let t1046 = tau7 - (FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign()));
        [t1040, t1041, t1042, t1043, t1044, t1045, t1046]
    };
    // M = L D L'
    let [
        t1047, t1048, t1049, t1050, t1051, t1052, t1053, t1057,
        t1061, t1064, t1067, t1070, t1073, t1080, t1087, t1092,
        t1097, t1102, t1112, t1122, t1129, t1136, t1149, t1162,
        t1171, t1187, t1203, t1222,
    ] = {
        let t1047 = k5 / t412;
        let t1048 = t402 * t1047;
        let t1049 = t368 * t1047;
        let t1050 = t312 * t1047;
        let t1051 = t242 * t1047;
        let t1052 = t167 * t1047;
        let t1053 = t75 * t1047;
        let t1056 = t396 - t412 * (t1048 * t1048);
        let t1057 = k5 / t1056;
        let t1058 = t412 * t1048;
        let t1061 = t1057 * (t365 - t1049 * t1058);
        let t1064 = t1057 * (t309 - t1050 * t1058);
        let t1067 = t1057 * (t239 - t1051 * t1058);
        let t1070 = t1057 * (t164 - t1052 * t1058);
        let t1073 = t1057 * (t72 - t1053 * t1058);
        let t1079 = t346 - t412 * (t1049 * t1049) - t1056 * (t1061 * t1061);
        let t1080 = k5 / t1079;
        let t1081 = t412 * t1049;
        let t1084 = t1056 * t1061;
        let t1087 = t1080 * (t295 - t1050 * t1081 - t1064 * t1084);
        let t1092 = t1080 * (t222 - t1051 * t1081 - t1067 * t1084);
        let t1097 = t1080 * (t147 - t1052 * t1081 - t1070 * t1084);
        let t1102 = t1080 * (t55 - t1053 * t1081 - t1073 * t1084);
        let t1110 = t1079 * (t1087 * t1087);
        let t1111 = t280 - t412 * (t1050 * t1050) - t1056 * (t1064 * t1064) - t1110;
        let t1112 = k5 / t1111;
        let t1113 = t412 * t1050;
        let t1116 = t1056 * t1064;
        let t1119 = t1079 * t1087;
        let t1122 = t1112 * (t211 + t1051 * t1113 + t1067 * t1116 + t1092 * t1119);
        let t1129 = t1112 * (t132 + t1052 * t1113 + t1070 * t1116 + t1097 * t1119);
        let t1136 = t1112 * (t40 + t1053 * t1113 + t1073 * t1116 + t1102 * t1119);
        let t1144 = t1079 * (t1092 * t1092);
        let t1147 = t1111 * (t1122 * t1122);
        let t1148 = t191 - t412 * (t1051 * t1051) - t1056 * (t1067 * t1067) - t1144 - t1147;
        let t1149 = k5 / t1148;
        let t1150 = t412 * t1051;
        let t1153 = t1056 * t1067;
        let t1156 = t1079 * t1092;
        let t1159 = t1111 * t1122;
        let t1161 = t117 - t1052 * t1150 - t1070 * t1153 - t1097 * t1156 - t1129 * t1159;
        let t1162 = t1149 * t1161;
        let t1170 = t21 - t1053 * t1150 - t1073 * t1153 - t1102 * t1156 - t1136 * t1159;
        let t1171 = t1149 * t1170;
        let t1179 = t1079 * (t1097 * t1097);
        let t1182 = t1111 * (t1129 * t1129);
        let t1183 = t102 - t412 * (t1052 * t1052) - t1056 * (t1070 * t1070) - t1179 - t1182;
        let t1186 = t1183 - t1148 * (t1162 * t1162);
        let t1187 = k5 / t1186;
        let t1195 = t1102 * (t1079 * t1097);
        let t1198 = t1136 * (t1111 * t1129);
        let t1199 = t11 - t1053 * (t412 * t1052) - t1073 * (t1056 * t1070) - t1195 - t1198;
        let t1203 = t1187 * (t1199 - t1171 * (t1148 * t1162));
        let t1211 = t1079 * (t1102 * t1102);
        let t1214 = t1111 * (t1136 * t1136);
        let t1215 = ZZ7 - t412 * (t1053 * t1053) - t1056 * (t1073 * t1073) - t1211 - t1214;
        let t1222 = k5 / (t1215 - t1148 * (t1171 * t1171) - t1186 * (t1203 * t1203));
        [
        t1047, t1048, t1049, t1050, t1051, t1052, t1053, t1057,
        t1061, t1064, t1067, t1070, t1073, t1080, t1087, t1092,
        t1097, t1102, t1112, t1122, t1129, t1136, t1149, t1162,
        t1171, t1187, t1203, t1222,
    ]
    };
    // ddq
    {
        let t1224 = t1041 + t1040 * t1048;
        let t1228 = t1042 + t1040 * t1049 - t1061 * t1224;
        let t1234 = t1043 + t1040 * t1050 - t1064 * t1224 - t1087 * t1228;
        let t1242 = t1044 + t1040 * t1051 - t1067 * t1224 - t1092 * t1228 + t1122 * t1234;
        let t1250 = t1045 + t1040 * t1052 - t1070 * t1224 - t1097 * t1228 + t1129 * t1234;
        let t1252 = t1250 - t1162 * t1242;
        let t1260 = t1046 + t1040 * t1053 - t1073 * t1224 - t1102 * t1228 + t1136 * t1234;
        let t1271 = t1222 * (t1260 - t1171 * t1242 - t1203 * t1252);
        let t1273 = t1187 * t1252 - t1203 * t1271;
        let t1277 = t1149 * t1242 - t1162 * t1273 - t1171 * t1271;
        let t1283 = t1112 * t1234 + t1122 * t1277 + t1129 * t1273 + t1136 * t1271;
        let t1290 = t1102 * t1271;
        let t1291 = t1080 * t1228 - t1087 * t1283 - t1092 * t1277 - t1097 * t1273 - t1290;
        let t1298 = t1070 * t1273;
        let t1299 = t1057 * t1224 - t1061 * t1291 - t1064 * t1283 - t1067 * t1277 - t1298;
        let t1301 = t1299 - t1073 * t1271;
        let t1308 = t1051 * t1277;
        let t1309 = t1040 * t1047 + t1048 * t1301 + t1049 * t1291 + t1050 * t1283 + t1308;
        let t1313 = t1309 + t1052 * t1273 + t1053 * t1271;
        put(0, t1313);
        put(1, t1301);
        put(2, t1291);
        put(3, t1283);
        put(4, t1277);
        put(5, t1273);
        put(6, t1271);
    }
}
