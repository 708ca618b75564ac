//! Accelerations under given torques.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` in
//! closed form.
//!
//! 725 multiplications, 596 additions; 7, 7 of 7 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, GRAVITY, Trig};

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
        FV6, FV7, FC1, FC2, FC3, FC4, FC5, FC6, FC7, FO1, FO2, FO3,
        FO4, FO5, FO6, FO7,
        ..] = *beta;
    let k0 = S::constant(0.167455);
    let k1 = S::constant(0.00035);
    let k2 = S::constant(0.31436);
    let k3 = S::constant(0.01275);
    let k4 = S::constant(0.42076);
    let k5 = S::constant(0.01175);
    let k6 = S::constant(-GRAVITY[2]);
    let k7 = S::constant(1.0);
    // composite body 7
    let [
        t2, t5, t14, t15, t19, t22, t27, t43,
        t59, t75, t83, t92, t95, t98, t99,
    ] = {
        let t2 = c7 * MSY7 + s7 * MSX7;
        let t5 = c7 * MSX7 - s7 * MSY7;
        let t14 = c7 * XZ7 - s7 * YZ7 + t5 * k0;
        let t15 = s7 * XZ7 + c7 * YZ7 + t2 * k0;
        let t16 = c6 * t2;
        let t17 = s6 * t2;
        let t19 = s6 * ZZ7;
        let t22 = c6 * ZZ7;
        let t26 = c6 * t14 - t19 - t17 * k1;
        let t27 = s6 * t14 + t22 + t16 * k1;
        let t30 = c5 * t16 + s5 * t5;
        let t33 = c5 * t5 - s5 * t16;
        let t42 = c5 * t26 - s5 * t15 + t33 * k2;
        let t43 = s5 * t26 + c5 * t15 + t30 * k2;
        let t46 = s4 * t17 - c4 * t30;
        let t49 = s4 * t30 + c4 * t17;
        let t58 = c4 * t42 - s4 * t27 - t49 * k3;
        let t59 = s4 * t42 + c4 * t27 - t46 * k3;
        let t62 = c3 * t46 - s3 * t33;
        let t74 = c3 * t58 - s3 * t43 + (s3 * t46 + c3 * t33) * k4;
        let t75 = s3 * t58 + c3 * t43 - t62 * k4;
        let t83 = s2 * t74 + c2 * t59 - (c2 * t62 + s2 * t49) * k5;
        let t85 = s7 * XY7;
        let t88 = c7 * XY7;
        let t89 = s7 * XX7R + t88;
        let t92 = c7 * (c7 * XX7R - t85) - s7 * t88;
        let t95 = c7 * t89 - s7 * t85;
        let t98 = s7 * t89 + c7 * t85;
        let t99 = t2 + t2;
        [
        t2, t5, t14, t15, t19, t22, t27, t43,
        t59, t75, t83, t92, t95, t98, t99,
    ]
    };
    // composite body 6
    let [
        t102, t108, t111, t120, t121, t133, t149, t165,
        t173, t187, t191, t193, t194, t198,
    ] = {
        let t100 = MSX6 + t5;
        let t101 = XX6R + t92;
        let t102 = ZZ6R + t98;
        let t103 = XY6 + t14;
        let t104 = XZ6 - t95;
        let t105 = YZ6 - t15;
        let t108 = c6 * MSY6R + s6 * t100;
        let t111 = c6 * t100 - s6 * MSY6R;
        let t120 = c6 * t104 - s6 * t105 + k1 * t111;
        let t121 = s6 * t104 + c6 * t105 + k1 * t108;
        let t122 = c5 * t108;
        let t123 = s5 * t108;
        let t132 = c5 * t120 + s5 * t102 - k2 * t123;
        let t133 = s5 * t120 - c5 * t102 + k2 * t122;
        let t136 = c4 * t122 + s4 * t111;
        let t139 = c4 * t111 - s4 * t122;
        let t148 = c4 * t132 - s4 * t121 + k3 * t139;
        let t149 = s4 * t132 + c4 * t121 + k3 * t136;
        let t152 = s3 * t123 - c3 * t136;
        let t164 = c3 * t148 - s3 * t133 - k4 * (s3 * t136 + c3 * t123);
        let t165 = s3 * t148 + c3 * t133 - k4 * t152;
        let t173 = s2 * t164 + c2 * t149 - k5 * (c2 * t152 - s2 * t139);
        let t175 = s6 * t103;
        let t178 = c6 * t103;
        let t179 = s6 * t101 + t178;
        let t181 = t22 + t175;
        let t187 = c6 * t179 - s6 * t181;
        let t191 = t108 + t108;
        let t192 = k1 * t99;
        let t193 = c6 * (c6 * t101 - t175) - s6 * (t178 - t19) + t192;
        let t194 = s6 * t179 + c6 * t181 + t192;
        let t196 = t2 * k1;
        let t198 = t102 + t192 - (t196 + t196);
        [
        t102, t108, t111, t120, t121, t133, t149, t165,
        t173, t187, t191, t193, t194, t198,
    ]
    };
    // composite body 5
    let [
        t202, t208, t211, t220, t221, t233, t249, t257,
        t273, t277, t279, t280, t284,
    ] = {
        let t199 = MSX5 + t111;
        let t200 = MSY5R + t2;
        let t201 = XX5R + t193;
        let t202 = ZZ5R + t194;
        let t203 = XY5 - t120;
        let t204 = XZ5 + t187;
        let t205 = YZ5 - t121;
        let t208 = c5 * t200 + s5 * t199;
        let t211 = c5 * t199 - s5 * t200;
        let t220 = c5 * t204 - s5 * t205 + k2 * t211;
        let t221 = s5 * t204 + c5 * t205 + k2 * t208;
        let t222 = c4 * t208;
        let t223 = s4 * t208;
        let t232 = c4 * t220 - s4 * t202 - k3 * t223;
        let t233 = s4 * t220 + c4 * t202 + k3 * t222;
        let t236 = c3 * t222 + s3 * t211;
        let t248 = c3 * t232 - s3 * t221 + k4 * (c3 * t211 - s3 * t222);
        let t249 = s3 * t232 + c3 * t221 + k4 * t236;
        let t257 = s2 * t248 + c2 * t233 - k5 * (s2 * t223 - c2 * t236);
        let t259 = s5 * t203;
        let t262 = c5 * t203;
        let t263 = s5 * t201 + t262;
        let t267 = t259 + c5 * t198;
        let t273 = c5 * t263 - s5 * t267;
        let t277 = t208 + t208;
        let t278 = k2 * t191;
        let t279 = c5 * (c5 * t201 - t259) - s5 * (t262 - s5 * t198) - t278;
        let t280 = s5 * t263 + c5 * t267 - t278;
        let t282 = k2 * t108;
        let t284 = t202 - t278 + (t282 + t282);
        [
        t202, t208, t211, t220, t221, t233, t249, t257,
        t273, t277, t279, t280, t284,
    ]
    };
    // composite body 4
    let [
        t288, t294, t297, t306, t307, t319, t327, t343,
        t347, t349, t350, t354,
    ] = {
        let t285 = MSX4 + t211;
        let t286 = MSY4R + t108;
        let t287 = XX4R + t279;
        let t288 = ZZ4R + t280;
        let t289 = XY4 + t220;
        let t290 = XZ4 - t273;
        let t291 = YZ4 - t221;
        let t294 = c4 * t286 + s4 * t285;
        let t297 = c4 * t285 - s4 * t286;
        let t306 = c4 * t290 - s4 * t291 + k3 * t297;
        let t307 = s4 * t290 + c4 * t291 + k3 * t294;
        let t308 = c3 * t294;
        let t319 = s3 * t306 - c3 * t288 + k4 * t308;
        let t324 = c2 * t307;
        let t325 = s2 * (c3 * t306 + s3 * t288 - k4 * (s3 * t294)) + t324;
        let t327 = t325 + k5 * (c2 * t308 + s2 * t297);
        let t329 = s4 * t289;
        let t332 = c4 * t289;
        let t333 = s4 * t287 + t332;
        let t337 = t329 + c4 * t284;
        let t343 = c4 * t333 - s4 * t337;
        let t347 = t294 + t294;
        let t348 = k3 * t277;
        let t349 = c4 * (c4 * t287 - t329) - s4 * (t332 - s4 * t284) + t348;
        let t350 = s4 * t333 + c4 * t337 + t348;
        let t352 = k3 * t208;
        let t354 = t288 + t348 - (t352 + t352);
        [
        t288, t294, t297, t306, t307, t319, t327, t343,
        t347, t349, t350, t354,
    ]
    };
    // composite body 3
    let [
        t358, t367, t376, t377, t383, t399, t403, t405,
        t406, t410,
    ] = {
        let t355 = MSX3 + t297;
        let t356 = MSY3R + t208;
        let t357 = XX3R + t349;
        let t358 = ZZ3R + t350;
        let t359 = XY3 - t306;
        let t360 = XZ3 + t343;
        let t361 = YZ3 - t307;
        let t364 = c3 * t356 + s3 * t355;
        let t367 = c3 * t355 - s3 * t356;
        let t376 = c3 * t360 - s3 * t361 + k4 * t367;
        let t377 = s3 * t360 + c3 * t361 + k4 * t364;
        let t383 = s2 * t376 + c2 * t358 + k5 * (c2 * t364);
        let t385 = s3 * t359;
        let t388 = c3 * t359;
        let t389 = s3 * t357 + t388;
        let t393 = t385 + c3 * t354;
        let t399 = c3 * t389 - s3 * t393;
        let t403 = t364 + t364;
        let t404 = k4 * t347;
        let t405 = c3 * (c3 * t357 - t385) - s3 * (t388 - s3 * t354) - t404;
        let t406 = s3 * t389 + c3 * t393 - t404;
        let t408 = k4 * t294;
        let t410 = t358 - t404 + (t408 + t408);
        [
        t358, t367, t376, t377, t383, t399, t403, t405,
        t406, t410,
    ]
    };
    // composite body 2
    let [t414, t425, t436] = {
        let t414 = ZZ2R + t406;
        let t415 = XY2 + t376;
        let t424 = k5 * (c2 * (MSY2R + t294) + s2 * (MSX2 + t367));
        let t425 = s2 * (XZ2 - t399) + c2 * (YZ2 - t377) + t424;
        let t433 = c2 * (s2 * t415 + c2 * t410);
        let t436 = s2 * (s2 * (XX2R + t405) + c2 * t415) + t433 + k5 * t403;
        [t414, t425, t436]
    };
    // composite body 1
    let t437 = {
        let t437 = ZZ1R + t436;
        t437
    };
    // link 1: motion
    let t438 = {
        let t438 = dq1 * dq1;
        t438
    };
    // link 2: motion
    let [
        t439, t440, a2_z, w2_x, w2_y, t445, t446, t447,
        t450, t451, t452,
    ] = {
        let t439 = s2 * k6;
        let t440 = c2 * k6;
        let a2_z = k5 * t438;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t444 = w2_x * w2_x;
        let t445 = dq2 * dq2;
        let t446 = w2_x * w2_y;
        let t447 = dq2 * w2_x;
        let dw2_x = dq2 * w2_y;
        let t450 = t444 - t445 - t438;
        let t451 = t444 + t445;
        let t452 = dw2_x + dw2_x;
        [
        t439, t440, a2_z, w2_x, w2_y, t445, t446, t447,
        t450, t451, t452,
    ]
    };
    // link 3: motion
    let [
        a3_z, t461, a3_y, w3_x, t470, t473, t476, w3_z,
        t480, t481, t482, dw3_x, dw3_y, t485, t486, t487,
        t488, t489, t490, t491,
    ] = {
        let t456 = t439 + k4 * t446;
        let a3_z = k4 * t451 - t440;
        let t458 = a2_z - k4 * t452;
        let t461 = c3 * t456 + s3 * t458;
        let a3_y = s3 * t456 - c3 * t458;
        let w3_x = c3 * w2_x - s3 * dq2;
        let t470 = c3 * dq2 + s3 * w2_x;
        let t473 = c3 * t446 - s3 * t452;
        let t476 = c3 * t452 + s3 * t446;
        let w3_z = w2_y + dq3;
        let t478 = w3_x * w3_x;
        let t479 = w3_z * w3_z;
        let t480 = w3_x * t470;
        let t481 = w3_x * w3_z;
        let t482 = t470 * w3_z;
        let dw3_x = t476 - t482;
        let dw3_y = t473 - t481;
        let t485 = t478 - t479;
        let t486 = t485 - t451;
        let t487 = t447 - t480;
        let t488 = t447 + t480;
        let t489 = t478 + t479;
        let t490 = t481 - dw3_y;
        let t491 = dw3_x - t482;
        [
        a3_z, t461, a3_y, w3_x, t470, t473, t476, w3_z,
        t480, t481, t482, dw3_x, dw3_y, t485, t486, t487,
        t488, t489, t490, t491,
    ]
    };
    // link 4: motion
    let [
        t496, a4_x, a4_y, w4_x, w4_y, t512, t515, w4_z,
        t519, t520, t521, dw4_x, t523, t524, t525, t526,
        t527, t528, t529, t530,
    ] = {
        let t495 = k3 * t487 - t461;
        let t496 = a3_y - k3 * t489;
        let t497 = a3_z + k3 * t491;
        let a4_x = c4 * t495 + s4 * t497;
        let a4_y = c4 * t497 - s4 * t495;
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t512 = c4 * t487 + s4 * t491;
        let t515 = s4 * t487 - c4 * t491;
        let w4_z = t470 + dq4;
        let t517 = w4_x * w4_x;
        let t518 = w4_z * w4_z;
        let t519 = w4_x * w4_y;
        let t520 = w4_x * w4_z;
        let t521 = w4_y * w4_z;
        let dw4_x = t521 - t515;
        let t523 = t512 + t520;
        let t524 = t517 - t518;
        let t525 = t524 - t489;
        let t526 = dw3_y + t519;
        let t527 = t519 - dw3_y;
        let t528 = t517 + t518;
        let t529 = t520 + t523;
        let t530 = t521 + dw4_x;
        [
        t496, a4_x, a4_y, w4_x, w4_y, t512, t515, w4_z,
        t519, t520, t521, dw4_x, t523, t524, t525, t526,
        t527, t528, t529, t530,
    ]
    };
    // link 5: motion
    let [
        a5_z, a5_x, a5_y, w5_x, t548, t551, t554, w5_z,
        t558, t559, t560, dw5_x, dw5_y, t563, t564, t565,
        t566, t567, t568, t569,
    ] = {
        let t534 = a4_x - k2 * t526;
        let a5_z = a4_y + k2 * t528;
        let t536 = t496 + k2 * t530;
        let a5_x = c5 * t534 + s5 * t536;
        let a5_y = c5 * t536 - s5 * t534;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t548 = c5 * w4_z + s5 * w4_x;
        let t551 = c5 * t526 - s5 * t530;
        let t554 = c5 * t530 + s5 * t526;
        let w5_z = w4_y + dq5;
        let t556 = w5_x * w5_x;
        let t557 = w5_z * w5_z;
        let t558 = w5_x * t548;
        let t559 = w5_x * w5_z;
        let t560 = t548 * w5_z;
        let dw5_x = t554 - t560;
        let dw5_y = t551 - t559;
        let t563 = t556 - t557;
        let t564 = t563 - t528;
        let t565 = t523 - t558;
        let t566 = t523 + t558;
        let t567 = t556 + t557;
        let t568 = t559 - dw5_y;
        let t569 = dw5_x - t560;
        [
        a5_z, a5_x, a5_y, w5_x, t548, t551, t554, w5_z,
        t558, t559, t560, dw5_x, dw5_y, t563, t564, t565,
        t566, t567, t568, t569,
    ]
    };
    // link 6: motion
    let [
        t574, a6_x, a6_y, w6_x, w6_y, t590, t593, w6_z,
        t597, t598, t599, dw6_x, t601, t602, t603, t604,
        t605, t606, t607, t608,
    ] = {
        let t573 = a5_x + k1 * t565;
        let t574 = a5_y - k1 * t567;
        let t575 = a5_z + k1 * t569;
        let a6_x = c6 * t573 + s6 * t575;
        let a6_y = c6 * t575 - s6 * t573;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t590 = c6 * t565 + s6 * t569;
        let t593 = s6 * t565 - c6 * t569;
        let w6_z = t548 + dq6;
        let t595 = w6_x * w6_x;
        let t596 = w6_z * w6_z;
        let t597 = w6_x * w6_y;
        let t598 = w6_x * w6_z;
        let t599 = w6_y * w6_z;
        let dw6_x = t599 - t593;
        let t601 = t590 + t598;
        let t602 = t595 - t596;
        let t603 = t602 - t567;
        let t604 = dw5_y + t597;
        let t605 = t597 - dw5_y;
        let t606 = t595 + t596;
        let t607 = t598 + t601;
        let t608 = t599 + dw6_x;
        [
        t574, a6_x, a6_y, w6_x, w6_y, t590, t593, w6_z,
        t597, t598, t599, dw6_x, t601, t602, t603, t604,
        t605, t606, t607, t608,
    ]
    };
    // link 7: motion
    let [
        t611, t614, t623, t626, t630, t631, t632, dw7_x,
        t635, t636, t637, t638, t639, t640, t641,
    ] = {
        let t611 = c7 * a6_x + s7 * t574;
        let t614 = c7 * t574 - s7 * a6_x;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t620 = c7 * w6_z + s7 * w6_x;
        let t623 = c7 * t604 - s7 * t608;
        let t626 = c7 * t608 + s7 * t604;
        let w7_z = w6_y + dq7;
        let t628 = w7_x * w7_x;
        let t629 = w7_z * w7_z;
        let t630 = w7_x * t620;
        let t631 = w7_x * w7_z;
        let t632 = t620 * w7_z;
        let dw7_x = t626 - t632;
        let dw7_y = t623 - t631;
        let t635 = t628 - t629;
        let t636 = t635 - t606;
        let t637 = t601 - t630;
        let t638 = t601 + t630;
        let t639 = t628 + t629;
        let t640 = t631 - dw7_y;
        let t641 = dw7_x - t632;
        [
        t611, t614, t623, t626, t630, t631, t632, dw7_x,
        t635, t636, t637, t638, t639, t640, t641,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t693, t696, t699, t702] = {
        let t643 = XZ7 + MSX7 * k0;
        let t645 = YZ7 + MSY7 * k0;
        let t666 = XX7R * t630 - ZZ7 * t601 + XY7 * (t636 + t639) + t626 * t643;
        let t668 = t645 * (t606 - t639);
        let t671 = XX7R * dw7_x - ZZ7 * t632 - XY7 * t640 - t638 * t643 + t668;
        let t672 = t631 * (XX7R - ZZ7) + XY7 * t641 - t635 * t643 - t637 * t645;
        let f7_x = MSX7 * t636 + MSY7 * t637;
        let t679 = MSX7 * t638 + MSY7 * t639;
        let f7_z = MSX7 * t640 + MSY7 * t641;
        let n7_x = t671 + MSY7 * a6_y;
        let n7_y = t672 - MSX7 * a6_y;
        let n7_z = t666 + t623 * t645 + (MSX7 * t614 - MSY7 * t611);
        let t693 = c7 * f7_x + s7 * t679;
        let t696 = s7 * f7_x - c7 * t679;
        let t699 = c7 * n7_x - s7 * n7_y;
        let t702 = s7 * n7_x + c7 * n7_y;
        [f7_z, n7_z, t693, t696, t699, t702]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t756, t759, t768, t769] = {
        let t723 = XY6 * (t603 + t606) - (XX6R * t597 + ZZ6R * dw5_y) - XZ6 * t593;
        let t725 = YZ6 * (t567 - t606);
        let t728 = ZZ6R * t599 + XX6R * dw6_x - XY6 * t607 + XZ6 * t605 + t725;
        let t729 = t598 * (XX6R - ZZ6R) + XY6 * t608 - XZ6 * t602 - YZ6 * t604;
        let f6_x = t693 + (MSX6 * t603 + MSY6R * t604);
        let f6_y = f7_z + (MSX6 * t605 - MSY6R * t606);
        let f6_z = MSX6 * t607 + MSY6R * t608 - t696;
        let n6_x = t699 + (t728 - MSY6R * t574);
        let n6_y = n7_z + (t729 + MSX6 * t574);
        let n6_z = t723 - YZ6 * t590 + (MSX6 * a6_y - MSY6R * a6_x) - t702;
        let t756 = c6 * f6_x - s6 * f6_y;
        let t759 = s6 * f6_x + c6 * f6_y;
        let t768 = c6 * n6_x - s6 * n6_y + k1 * t759;
        let t769 = s6 * n6_x + c6 * n6_y - k1 * t756;
        [f6_z, n6_z, t756, t759, t768, t769]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t823, t826, t835, t836] = {
        let t790 = XX5R * t558 - ZZ5R * t523 + XY5 * (t564 + t567) + XZ5 * t554;
        let t792 = YZ5 * (t528 - t567);
        let t795 = XX5R * dw5_x - ZZ5R * t560 - XY5 * t568 - XZ5 * t566 + t792;
        let t796 = t559 * (XX5R - ZZ5R) + XY5 * t569 - XZ5 * t563 - YZ5 * t565;
        let f5_x = t756 + (MSX5 * t564 + MSY5R * t565);
        let t816 = f6_z + (MSX5 * t566 + MSY5R * t567);
        let f5_z = t759 + (MSX5 * t568 + MSY5R * t569);
        let n5_x = t768 + (t795 + MSY5R * a5_z);
        let n5_y = t796 - MSX5 * a5_z - n6_z;
        let n5_z = t769 + (t790 + YZ5 * t551 + (MSX5 * a5_y - MSY5R * a5_x));
        let t823 = c5 * f5_x + s5 * t816;
        let t826 = s5 * f5_x - c5 * t816;
        let t835 = c5 * n5_x - s5 * n5_y + k2 * t826;
        let t836 = s5 * n5_x + c5 * n5_y - k2 * t823;
        [f5_z, n5_z, t823, t826, t835, t836]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t890, t893, t902, t903] = {
        let t857 = XY4 * (t525 + t528) - (XX4R * t519 + ZZ4R * dw3_y) - XZ4 * t515;
        let t859 = YZ4 * (t489 - t528);
        let t862 = ZZ4R * t521 + XX4R * dw4_x - XY4 * t529 + XZ4 * t527 + t859;
        let t863 = t520 * (XX4R - ZZ4R) + XY4 * t530 - XZ4 * t524 - YZ4 * t526;
        let f4_x = t823 + (MSX4 * t525 + MSY4R * t526);
        let f4_y = f5_z + (MSX4 * t527 - MSY4R * t528);
        let f4_z = MSX4 * t529 + MSY4R * t530 - t826;
        let n4_x = t835 + (t862 - MSY4R * t496);
        let n4_y = n5_z + (t863 + MSX4 * t496);
        let n4_z = t857 - YZ4 * t512 + (MSX4 * a4_y - MSY4R * a4_x) - t836;
        let t890 = c4 * f4_x - s4 * f4_y;
        let t893 = s4 * f4_x + c4 * f4_y;
        let t902 = c4 * n4_x - s4 * n4_y + k3 * t893;
        let t903 = s4 * n4_x + c4 * n4_y - k3 * t890;
        [f4_z, n4_z, t890, t893, t902, t903]
    };
    // link 3: force and moment
    let [f3_z, n3_z, t957, t969, t970] = {
        let t924 = XX3R * t480 - ZZ3R * t447 + XY3 * (t486 + t489) + XZ3 * t476;
        let t926 = YZ3 * (t451 - t489);
        let t929 = XX3R * dw3_x - ZZ3R * t482 - XY3 * t490 - XZ3 * t488 + t926;
        let t930 = t481 * (XX3R - ZZ3R) + XY3 * t491 - XZ3 * t485 - YZ3 * t487;
        let f3_x = t890 + (MSX3 * t486 + MSY3R * t487);
        let t950 = f4_z + (MSX3 * t488 + MSY3R * t489);
        let f3_z = t893 + (MSX3 * t490 + MSY3R * t491);
        let n3_x = t902 + (t929 + MSY3R * a3_z);
        let n3_y = t930 - MSX3 * a3_z - n4_z;
        let n3_z = t903 + (t924 + YZ3 * t473 + (MSX3 * a3_y + MSY3R * t461));
        let t957 = c3 * f3_x + s3 * t950;
        let t969 = c3 * n3_x - s3 * n3_y + k4 * (s3 * f3_x - c3 * t950);
        let t970 = s3 * n3_x + c3 * n3_y - k4 * t957;
        [f3_z, n3_z, t957, t969, t970]
    };
    // link 2: force and moment
    let [t984, n2_z, t1010] = {
        let t976 = c2 * (s2 * XX2R + c2 * (XY2 + XY2)) - XY2;
        let t984 = (t976 + t976) * (dq1 * dq2) + t445 * (c2 * XZ2 - s2 * YZ2);
        let f2_x = t957 + (MSX2 * t450 + MSY2R * t446);
        let f2_y = f3_z + (MSX2 * t446 - MSY2R * t451);
        let n2_x = t969 + MSY2R * a2_z;
        let n2_y = n3_z - MSX2 * a2_z;
        let n2_z = MSY2R * t439 - MSX2 * t440 - t970 - t438 * t976;
        let f1_x = c2 * f2_x - s2 * f2_y;
        let t1010 = s2 * n2_x + c2 * n2_y - k5 * f1_x;
        [t984, n2_z, t1010]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t984 + t1010;
        n1_z
    };
    // drives
    let [t1054, t1055, t1056, t1057, t1058, t1059, t1060] = {
        let t1054 = tau1 - (FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign()));
        let t1055 = tau2 - (FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign()));
        let t1056 = tau3 - (FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign()));
        let t1057 = tau4 - (FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign()));
        let t1058 = tau5 - (FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign()));
        let t1059 = tau6 - (FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign()));
        let t1060 = tau7 - (FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign()));
        [t1054, t1055, t1056, t1057, t1058, t1059, t1060]
    };
    // M = L D L'
    let [
        t1061, t1062, t1063, t1064, t1065, t1066, t1067, t1071,
        t1075, t1078, t1081, t1084, t1087, t1094, t1101, t1106,
        t1111, t1116, t1126, t1136, t1143, t1150, t1163, t1176,
        t1185, t1201, t1217, t1236,
    ] = {
        let t1061 = k7 / t437;
        let t1062 = t425 * t1061;
        let t1063 = t383 * t1061;
        let t1064 = t327 * t1061;
        let t1065 = t257 * t1061;
        let t1066 = t173 * t1061;
        let t1067 = t83 * t1061;
        let t1070 = t414 - t437 * (t1062 * t1062);
        let t1071 = k7 / t1070;
        let t1072 = t437 * t1062;
        let t1075 = t1071 * (t377 + t1063 * t1072);
        let t1078 = t1071 * (t319 + t1064 * t1072);
        let t1081 = t1071 * (t249 + t1065 * t1072);
        let t1084 = t1071 * (t165 + t1066 * t1072);
        let t1087 = t1071 * (t75 + t1067 * t1072);
        let t1093 = t358 - t437 * (t1063 * t1063) - t1070 * (t1075 * t1075);
        let t1094 = k7 / t1093;
        let t1095 = t437 * t1063;
        let t1098 = t1070 * t1075;
        let t1101 = t1094 * (t307 - t1064 * t1095 - t1078 * t1098);
        let t1106 = t1094 * (t233 - t1065 * t1095 - t1081 * t1098);
        let t1111 = t1094 * (t149 - t1066 * t1095 - t1084 * t1098);
        let t1116 = t1094 * (t59 - t1067 * t1095 - t1087 * t1098);
        let t1124 = t1093 * (t1101 * t1101);
        let t1125 = t288 - t437 * (t1064 * t1064) - t1070 * (t1078 * t1078) - t1124;
        let t1126 = k7 / t1125;
        let t1127 = t437 * t1064;
        let t1130 = t1070 * t1078;
        let t1133 = t1093 * t1101;
        let t1136 = t1126 * (t221 + t1065 * t1127 + t1081 * t1130 + t1106 * t1133);
        let t1143 = t1126 * (t133 + t1066 * t1127 + t1084 * t1130 + t1111 * t1133);
        let t1150 = t1126 * (t43 + t1067 * t1127 + t1087 * t1130 + t1116 * t1133);
        let t1158 = t1093 * (t1106 * t1106);
        let t1161 = t1125 * (t1136 * t1136);
        let t1162 = t202 - t437 * (t1065 * t1065) - t1070 * (t1081 * t1081) - t1158 - t1161;
        let t1163 = k7 / t1162;
        let t1164 = t437 * t1065;
        let t1167 = t1070 * t1081;
        let t1170 = t1093 * t1106;
        let t1173 = t1125 * t1136;
        let t1175 = t121 - t1066 * t1164 - t1084 * t1167 - t1111 * t1170 - t1143 * t1173;
        let t1176 = t1163 * t1175;
        let t1184 = t27 - t1067 * t1164 - t1087 * t1167 - t1116 * t1170 - t1150 * t1173;
        let t1185 = t1163 * t1184;
        let t1193 = t1093 * (t1111 * t1111);
        let t1196 = t1125 * (t1143 * t1143);
        let t1197 = t102 - t437 * (t1066 * t1066) - t1070 * (t1084 * t1084) - t1193 - t1196;
        let t1200 = t1197 - t1162 * (t1176 * t1176);
        let t1201 = k7 / t1200;
        let t1209 = t1116 * (t1093 * t1111);
        let t1212 = t1150 * (t1125 * t1143);
        let t1213 = t15 + t1067 * (t437 * t1066) + t1087 * (t1070 * t1084) + t1209 + t1212;
        let t1217 = t1201 * (t1213 + t1185 * (t1162 * t1176));
        let t1225 = t1093 * (t1116 * t1116);
        let t1228 = t1125 * (t1150 * t1150);
        let t1229 = ZZ7 - t437 * (t1067 * t1067) - t1070 * (t1087 * t1087) - t1225 - t1228;
        let t1236 = k7 / (t1229 - t1162 * (t1185 * t1185) - t1200 * (t1217 * t1217));
        [
        t1061, t1062, t1063, t1064, t1065, t1066, t1067, t1071,
        t1075, t1078, t1081, t1084, t1087, t1094, t1101, t1106,
        t1111, t1116, t1126, t1136, t1143, t1150, t1163, t1176,
        t1185, t1201, t1217, t1236,
    ]
    };
    // ddq
    {
        let t1238 = t1055 - t1054 * t1062;
        let t1242 = t1056 - t1054 * t1063 + t1075 * t1238;
        let t1248 = t1057 - t1054 * t1064 + t1078 * t1238 - t1101 * t1242;
        let t1256 = t1058 - t1054 * t1065 + t1081 * t1238 - t1106 * t1242 + t1136 * t1248;
        let t1264 = t1059 - t1054 * t1066 + t1084 * t1238 - t1111 * t1242 + t1143 * t1248;
        let t1266 = t1264 - t1176 * t1256;
        let t1274 = t1060 - t1054 * t1067 + t1087 * t1238 - t1116 * t1242 + t1150 * t1248;
        let t1285 = t1236 * (t1274 - t1185 * t1256 + t1217 * t1266);
        let t1287 = t1201 * t1266 + t1217 * t1285;
        let t1291 = t1163 * t1256 - t1176 * t1287 - t1185 * t1285;
        let t1297 = t1126 * t1248 + t1136 * t1291 + t1143 * t1287 + t1150 * t1285;
        let t1304 = t1116 * t1285;
        let t1305 = t1094 * t1242 - t1101 * t1297 - t1106 * t1291 - t1111 * t1287 - t1304;
        let t1312 = t1084 * t1287;
        let t1313 = t1071 * t1238 + t1075 * t1305 + t1078 * t1297 + t1081 * t1291 + t1312;
        let t1315 = t1313 + t1087 * t1285;
        let t1322 = t1065 * t1291;
        let t1323 = t1054 * t1061 - t1062 * t1315 - t1063 * t1305 - t1064 * t1297 - t1322;
        let t1327 = t1323 - t1066 * t1287 - t1067 * t1285;
        put(0, t1327);
        put(1, t1315);
        put(2, t1305);
        put(3, t1297);
        put(4, t1291);
        put(5, t1287);
        put(6, t1285);
    }
}
