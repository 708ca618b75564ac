//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 729 multiplications, 606 additions; 7, 7 of 7 structurally nonzero.

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
    let k6 = S::constant(9.81);
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
        w2_x, w2_y, t441, t442, a2_z, t446, t447, dw2_x,
        t449, t450, t451, t452, t453,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t441 = s2 * k6;
        let t442 = c2 * k6;
        let a2_z = k5 * t438;
        let t444 = w2_x * w2_x;
        let t445 = dq2 * dq2;
        let t446 = w2_x * w2_y;
        let t447 = dq2 * w2_x;
        let dw2_x = dq2 * w2_y;
        let t449 = t444 - t445;
        let t450 = t449 - t438;
        let t451 = t444 + t445;
        let t452 = t447 + t447;
        let t453 = dw2_x + dw2_x;
        [
        w2_x, w2_y, t441, t442, a2_z, t446, t447, dw2_x,
        t449, t450, t451, t452, t453,
    ]
    };
    // link 3: motion
    let [
        w3_x, t459, a3_z, t468, a3_y, t474, t477, w3_z,
        t481, t482, t483, dw3_x, dw3_y, t486, t487, t488,
        t489, t490, t491, t492,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t459 = c3 * dq2 + s3 * w2_x;
        let t463 = t441 + k4 * t446;
        let a3_z = k4 * t451 - t442;
        let t465 = a2_z - k4 * t453;
        let t468 = c3 * t463 + s3 * t465;
        let a3_y = s3 * t463 - c3 * t465;
        let t474 = c3 * t446 - s3 * t453;
        let t477 = c3 * t453 + s3 * t446;
        let w3_z = w2_y + dq3;
        let t479 = w3_x * w3_x;
        let t480 = w3_z * w3_z;
        let t481 = w3_x * t459;
        let t482 = w3_x * w3_z;
        let t483 = t459 * w3_z;
        let dw3_x = t477 - t483;
        let dw3_y = t474 - t482;
        let t486 = t479 - t480;
        let t487 = t486 - t451;
        let t488 = t447 - t481;
        let t489 = t447 + t481;
        let t490 = t479 + t480;
        let t491 = t482 - dw3_y;
        let t492 = dw3_x - t483;
        [
        w3_x, t459, a3_z, t468, a3_y, t474, t477, w3_z,
        t481, t482, t483, dw3_x, dw3_y, t486, t487, t488,
        t489, t490, t491, t492,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t503, a4_x, a4_y, t513, t516, w4_z,
        t520, t521, t522, dw4_x, t524, t525, t526, t527,
        t528, t529, t530, t531,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t502 = k3 * t488 - t468;
        let t503 = a3_y - k3 * t490;
        let t504 = a3_z + k3 * t492;
        let a4_x = c4 * t502 + s4 * t504;
        let a4_y = c4 * t504 - s4 * t502;
        let t513 = c4 * t488 + s4 * t492;
        let t516 = s4 * t488 - c4 * t492;
        let w4_z = t459 + dq4;
        let t518 = w4_x * w4_x;
        let t519 = w4_z * w4_z;
        let t520 = w4_x * w4_y;
        let t521 = w4_x * w4_z;
        let t522 = w4_y * w4_z;
        let dw4_x = t522 - t516;
        let t524 = t513 + t521;
        let t525 = t518 - t519;
        let t526 = t525 - t490;
        let t527 = dw3_y + t520;
        let t528 = t520 - dw3_y;
        let t529 = t518 + t519;
        let t530 = t521 + t524;
        let t531 = t522 + dw4_x;
        [
        w4_x, w4_y, t503, a4_x, a4_y, t513, t516, w4_z,
        t520, t521, t522, dw4_x, t524, t525, t526, t527,
        t528, t529, t530, t531,
    ]
    };
    // link 5: motion
    let [
        w5_x, t537, a5_z, a5_x, a5_y, t552, t555, w5_z,
        t559, t560, t561, dw5_x, dw5_y, t564, t565, t566,
        t567, t568, t569, t570,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t537 = c5 * w4_z + s5 * w4_x;
        let t541 = a4_x - k2 * t527;
        let a5_z = a4_y + k2 * t529;
        let t543 = t503 + k2 * t531;
        let a5_x = c5 * t541 + s5 * t543;
        let a5_y = c5 * t543 - s5 * t541;
        let t552 = c5 * t527 - s5 * t531;
        let t555 = c5 * t531 + s5 * t527;
        let w5_z = w4_y + dq5;
        let t557 = w5_x * w5_x;
        let t558 = w5_z * w5_z;
        let t559 = w5_x * t537;
        let t560 = w5_x * w5_z;
        let t561 = t537 * w5_z;
        let dw5_x = t555 - t561;
        let dw5_y = t552 - t560;
        let t564 = t557 - t558;
        let t565 = t564 - t529;
        let t566 = t524 - t559;
        let t567 = t524 + t559;
        let t568 = t557 + t558;
        let t569 = t560 - dw5_y;
        let t570 = dw5_x - t561;
        [
        w5_x, t537, a5_z, a5_x, a5_y, t552, t555, w5_z,
        t559, t560, t561, dw5_x, dw5_y, t564, t565, t566,
        t567, t568, t569, t570,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t581, a6_x, a6_y, t591, t594, w6_z,
        t598, t599, t600, dw6_x, t602, t603, t604, t605,
        t606, t607, t608, t609,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t580 = a5_x + k1 * t566;
        let t581 = a5_y - k1 * t568;
        let t582 = a5_z + k1 * t570;
        let a6_x = c6 * t580 + s6 * t582;
        let a6_y = c6 * t582 - s6 * t580;
        let t591 = c6 * t566 + s6 * t570;
        let t594 = s6 * t566 - c6 * t570;
        let w6_z = t537 + dq6;
        let t596 = w6_x * w6_x;
        let t597 = w6_z * w6_z;
        let t598 = w6_x * w6_y;
        let t599 = w6_x * w6_z;
        let t600 = w6_y * w6_z;
        let dw6_x = t600 - t594;
        let t602 = t591 + t599;
        let t603 = t596 - t597;
        let t604 = t603 - t568;
        let t605 = dw5_y + t598;
        let t606 = t598 - dw5_y;
        let t607 = t596 + t597;
        let t608 = t599 + t602;
        let t609 = t600 + dw6_x;
        [
        w6_x, w6_y, t581, a6_x, a6_y, t591, t594, w6_z,
        t598, t599, t600, dw6_x, t602, t603, t604, t605,
        t606, t607, t608, t609,
    ]
    };
    // link 7: motion
    let [
        a7_z, a7_x, a7_y, t630, t633, t637, t638, t639,
        dw7_x, t642, t643, t644, t645, t646, t647, t648,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t615 = c7 * w6_z + s7 * w6_x;
        let t619 = a6_x - k0 * t605;
        let a7_z = a6_y + k0 * t607;
        let t621 = t581 + k0 * t609;
        let a7_x = c7 * t619 + s7 * t621;
        let a7_y = c7 * t621 - s7 * t619;
        let t630 = c7 * t605 - s7 * t609;
        let t633 = c7 * t609 + s7 * t605;
        let w7_z = w6_y + dq7;
        let t635 = w7_x * w7_x;
        let t636 = w7_z * w7_z;
        let t637 = w7_x * t615;
        let t638 = w7_x * w7_z;
        let t639 = t615 * w7_z;
        let dw7_x = t633 - t639;
        let dw7_y = t630 - t638;
        let t642 = t635 - t636;
        let t643 = t642 - t607;
        let t644 = t602 - t637;
        let t645 = t602 + t637;
        let t646 = t635 + t636;
        let t647 = t638 - dw7_y;
        let t648 = dw7_x - t639;
        [
        a7_z, a7_x, a7_y, t630, t633, t637, t638, t639,
        dw7_x, t642, t643, t644, t645, t646, t647, t648,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t696, t699, t708, t709] = {
        let t669 = XX7R * t637 - ZZ7 * t602 + XY7 * (t643 + t646) + XZ7 * t633;
        let t671 = YZ7 * (t607 - t646);
        let t674 = XX7R * dw7_x - ZZ7 * t639 - XY7 * t647 - XZ7 * t645 + t671;
        let t675 = t638 * (XX7R - ZZ7) + XY7 * t648 - XZ7 * t642 - YZ7 * t644;
        let f7_x = MSX7 * t643 + MSY7 * t644;
        let t682 = MSX7 * t645 + MSY7 * t646;
        let f7_z = MSX7 * t647 + MSY7 * t648;
        let n7_x = t674 + MSY7 * a7_z;
        let n7_y = t675 - MSX7 * a7_z;
        let n7_z = t669 + YZ7 * t630 + (MSX7 * a7_y - MSY7 * a7_x);
        let t696 = c7 * f7_x + s7 * t682;
        let t699 = s7 * f7_x - c7 * t682;
        let t708 = c7 * n7_x - s7 * n7_y + k0 * t699;
        let t709 = s7 * n7_x + c7 * n7_y - k0 * t696;
        [f7_z, n7_z, t696, t699, t708, t709]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t763, t766, t775, t776] = {
        let t730 = XY6 * (t604 + t607) - (XX6R * t598 + ZZ6R * dw5_y) - XZ6 * t594;
        let t732 = YZ6 * (t568 - t607);
        let t735 = ZZ6R * t600 + XX6R * dw6_x - XY6 * t608 + XZ6 * t606 + t732;
        let t736 = t599 * (XX6R - ZZ6R) + XY6 * t609 - XZ6 * t603 - YZ6 * t605;
        let f6_x = t696 + (MSX6 * t604 + MSY6R * t605);
        let f6_y = f7_z + (MSX6 * t606 - MSY6R * t607);
        let f6_z = MSX6 * t608 + MSY6R * t609 - t699;
        let n6_x = t708 + (t735 - MSY6R * t581);
        let n6_y = n7_z + (t736 + MSX6 * t581);
        let n6_z = t730 - YZ6 * t591 + (MSX6 * a6_y - MSY6R * a6_x) - t709;
        let t763 = c6 * f6_x - s6 * f6_y;
        let t766 = s6 * f6_x + c6 * f6_y;
        let t775 = c6 * n6_x - s6 * n6_y + k1 * t766;
        let t776 = s6 * n6_x + c6 * n6_y - k1 * t763;
        [f6_z, n6_z, t763, t766, t775, t776]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t830, t833, t842, t843] = {
        let t797 = XX5R * t559 - ZZ5R * t524 + XY5 * (t565 + t568) + XZ5 * t555;
        let t799 = YZ5 * (t529 - t568);
        let t802 = XX5R * dw5_x - ZZ5R * t561 - XY5 * t569 - XZ5 * t567 + t799;
        let t803 = t560 * (XX5R - ZZ5R) + XY5 * t570 - XZ5 * t564 - YZ5 * t566;
        let f5_x = t763 + (MSX5 * t565 + MSY5R * t566);
        let t823 = f6_z + (MSX5 * t567 + MSY5R * t568);
        let f5_z = t766 + (MSX5 * t569 + MSY5R * t570);
        let n5_x = t775 + (t802 + MSY5R * a5_z);
        let n5_y = t803 - MSX5 * a5_z - n6_z;
        let n5_z = t776 + (t797 + YZ5 * t552 + (MSX5 * a5_y - MSY5R * a5_x));
        let t830 = c5 * f5_x + s5 * t823;
        let t833 = s5 * f5_x - c5 * t823;
        let t842 = c5 * n5_x - s5 * n5_y + k2 * t833;
        let t843 = s5 * n5_x + c5 * n5_y - k2 * t830;
        [f5_z, n5_z, t830, t833, t842, t843]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t897, t900, t909, t910] = {
        let t864 = XY4 * (t526 + t529) - (XX4R * t520 + ZZ4R * dw3_y) - XZ4 * t516;
        let t866 = YZ4 * (t490 - t529);
        let t869 = ZZ4R * t522 + XX4R * dw4_x - XY4 * t530 + XZ4 * t528 + t866;
        let t870 = t521 * (XX4R - ZZ4R) + XY4 * t531 - XZ4 * t525 - YZ4 * t527;
        let f4_x = t830 + (MSX4 * t526 + MSY4R * t527);
        let f4_y = f5_z + (MSX4 * t528 - MSY4R * t529);
        let f4_z = MSX4 * t530 + MSY4R * t531 - t833;
        let n4_x = t842 + (t869 - MSY4R * t503);
        let n4_y = n5_z + (t870 + MSX4 * t503);
        let n4_z = t864 - YZ4 * t513 + (MSX4 * a4_y - MSY4R * a4_x) - t843;
        let t897 = c4 * f4_x - s4 * f4_y;
        let t900 = s4 * f4_x + c4 * f4_y;
        let t909 = c4 * n4_x - s4 * n4_y + k3 * t900;
        let t910 = s4 * n4_x + c4 * n4_y - k3 * t897;
        [f4_z, n4_z, t897, t900, t909, t910]
    };
    // link 3: force and moment
    let [f3_z, n3_z, t964, t976, t977] = {
        let t931 = XX3R * t481 - ZZ3R * t447 + XY3 * (t487 + t490) + XZ3 * t477;
        let t933 = YZ3 * (t451 - t490);
        let t936 = XX3R * dw3_x - ZZ3R * t483 - XY3 * t491 - XZ3 * t489 + t933;
        let t937 = t482 * (XX3R - ZZ3R) + XY3 * t492 - XZ3 * t486 - YZ3 * t488;
        let f3_x = t897 + (MSX3 * t487 + MSY3R * t488);
        let t957 = f4_z + (MSX3 * t489 + MSY3R * t490);
        let f3_z = t900 + (MSX3 * t491 + MSY3R * t492);
        let n3_x = t909 + (t936 + MSY3R * a3_z);
        let n3_y = t937 - MSX3 * a3_z - n4_z;
        let n3_z = t910 + (t931 + YZ3 * t474 + (MSX3 * a3_y + MSY3R * t468));
        let t964 = c3 * f3_x + s3 * t957;
        let t976 = c3 * n3_x - s3 * n3_y + k4 * (s3 * f3_x - c3 * t957);
        let t977 = s3 * n3_x + c3 * n3_y - k4 * t964;
        [f3_z, n3_z, t964, t976, t977]
    };
    // link 2: force and moment
    let [n2_z, n1_z] = {
        let t995 = YZ2 * (t438 - t451);
        let t998 = t447 * (XX2R - ZZ2R) + XY2 * t453 - XZ2 * t449 - YZ2 * t446;
        let t1005 = MSY2R * a2_z;
        let t1010 = dw2_x * (XX2R + ZZ2R) - XY2 * t452 + XZ2 * t446 + t995 + t1005;
        let t1012 = XY2 * (t450 + t451) - XX2R * t446 + (MSY2R * t441 - MSX2 * t442);
        let f2_x = t964 + (MSX2 * t450 + MSY2R * t446);
        let f2_y = f3_z + (MSX2 * t446 - MSY2R * t451);
        let n2_x = t976 + t1010;
        let n2_y = n3_z + (t998 - MSX2 * a2_z);
        let n2_z = t1012 - t977;
        let f1_x = c2 * f2_x - s2 * f2_y;
        let n1_z = s2 * n2_x + c2 * n2_y - k5 * f1_x;
        [n2_z, n1_z]
    };
    // drives
    let [t1068, t1069, t1070, t1071, t1072, t1073, t1074] = {
        let t1068 = tau1 - (FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign()));
        let t1069 = tau2 - (FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign()));
        let t1070 = tau3 - (FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign()));
        let t1071 = tau4 - (FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign()));
        let t1072 = tau5 - (FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign()));
        let t1073 = tau6 - (FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign()));
        let t1074 = tau7 - (FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign()));
        [t1068, t1069, t1070, t1071, t1072, t1073, t1074]
    };
    // M = L D L'
    let [
        t1075, t1076, t1077, t1078, t1079, t1080, t1081, t1085,
        t1089, t1092, t1095, t1098, t1101, t1108, t1115, t1120,
        t1125, t1130, t1140, t1150, t1157, t1164, t1177, t1190,
        t1199, t1215, t1231, t1250,
    ] = {
        let t1075 = k7 / t437;
        let t1076 = t425 * t1075;
        let t1077 = t383 * t1075;
        let t1078 = t327 * t1075;
        let t1079 = t257 * t1075;
        let t1080 = t173 * t1075;
        let t1081 = t83 * t1075;
        let t1084 = t414 - t437 * (t1076 * t1076);
        let t1085 = k7 / t1084;
        let t1086 = t437 * t1076;
        let t1089 = t1085 * (t377 + t1077 * t1086);
        let t1092 = t1085 * (t319 + t1078 * t1086);
        let t1095 = t1085 * (t249 + t1079 * t1086);
        let t1098 = t1085 * (t165 + t1080 * t1086);
        let t1101 = t1085 * (t75 + t1081 * t1086);
        let t1107 = t358 - t437 * (t1077 * t1077) - t1084 * (t1089 * t1089);
        let t1108 = k7 / t1107;
        let t1109 = t437 * t1077;
        let t1112 = t1084 * t1089;
        let t1115 = t1108 * (t307 - t1078 * t1109 - t1092 * t1112);
        let t1120 = t1108 * (t233 - t1079 * t1109 - t1095 * t1112);
        let t1125 = t1108 * (t149 - t1080 * t1109 - t1098 * t1112);
        let t1130 = t1108 * (t59 - t1081 * t1109 - t1101 * t1112);
        let t1138 = t1107 * (t1115 * t1115);
        let t1139 = t288 - t437 * (t1078 * t1078) - t1084 * (t1092 * t1092) - t1138;
        let t1140 = k7 / t1139;
        let t1141 = t437 * t1078;
        let t1144 = t1084 * t1092;
        let t1147 = t1107 * t1115;
        let t1150 = t1140 * (t221 + t1079 * t1141 + t1095 * t1144 + t1120 * t1147);
        let t1157 = t1140 * (t133 + t1080 * t1141 + t1098 * t1144 + t1125 * t1147);
        let t1164 = t1140 * (t43 + t1081 * t1141 + t1101 * t1144 + t1130 * t1147);
        let t1172 = t1107 * (t1120 * t1120);
        let t1175 = t1139 * (t1150 * t1150);
        let t1176 = t202 - t437 * (t1079 * t1079) - t1084 * (t1095 * t1095) - t1172 - t1175;
        let t1177 = k7 / t1176;
        let t1178 = t437 * t1079;
        let t1181 = t1084 * t1095;
        let t1184 = t1107 * t1120;
        let t1187 = t1139 * t1150;
        let t1189 = t121 - t1080 * t1178 - t1098 * t1181 - t1125 * t1184 - t1157 * t1187;
        let t1190 = t1177 * t1189;
        let t1198 = t27 - t1081 * t1178 - t1101 * t1181 - t1130 * t1184 - t1164 * t1187;
        let t1199 = t1177 * t1198;
        let t1207 = t1107 * (t1125 * t1125);
        let t1210 = t1139 * (t1157 * t1157);
        let t1211 = t102 - t437 * (t1080 * t1080) - t1084 * (t1098 * t1098) - t1207 - t1210;
        let t1214 = t1211 - t1176 * (t1190 * t1190);
        let t1215 = k7 / t1214;
        let t1223 = t1130 * (t1107 * t1125);
        let t1226 = t1164 * (t1139 * t1157);
        let t1227 = t15 + t1081 * (t437 * t1080) + t1101 * (t1084 * t1098) + t1223 + t1226;
        let t1231 = t1215 * (t1227 + t1199 * (t1176 * t1190));
        let t1239 = t1107 * (t1130 * t1130);
        let t1242 = t1139 * (t1164 * t1164);
        let t1243 = ZZ7 - t437 * (t1081 * t1081) - t1084 * (t1101 * t1101) - t1239 - t1242;
        let t1250 = k7 / (t1243 - t1176 * (t1199 * t1199) - t1214 * (t1231 * t1231));
        [
        t1075, t1076, t1077, t1078, t1079, t1080, t1081, t1085,
        t1089, t1092, t1095, t1098, t1101, t1108, t1115, t1120,
        t1125, t1130, t1140, t1150, t1157, t1164, t1177, t1190,
        t1199, t1215, t1231, t1250,
    ]
    };
    // ddq
    {
        let t1252 = t1069 - t1068 * t1076;
        let t1256 = t1070 - t1068 * t1077 + t1089 * t1252;
        let t1262 = t1071 - t1068 * t1078 + t1092 * t1252 - t1115 * t1256;
        let t1270 = t1072 - t1068 * t1079 + t1095 * t1252 - t1120 * t1256 + t1150 * t1262;
        let t1278 = t1073 - t1068 * t1080 + t1098 * t1252 - t1125 * t1256 + t1157 * t1262;
        let t1280 = t1278 - t1190 * t1270;
        let t1288 = t1074 - t1068 * t1081 + t1101 * t1252 - t1130 * t1256 + t1164 * t1262;
        let t1299 = t1250 * (t1288 - t1199 * t1270 + t1231 * t1280);
        let t1301 = t1215 * t1280 + t1231 * t1299;
        let t1305 = t1177 * t1270 - t1190 * t1301 - t1199 * t1299;
        let t1311 = t1140 * t1262 + t1150 * t1305 + t1157 * t1301 + t1164 * t1299;
        let t1318 = t1130 * t1299;
        let t1319 = t1108 * t1256 - t1115 * t1311 - t1120 * t1305 - t1125 * t1301 - t1318;
        let t1326 = t1098 * t1301;
        let t1327 = t1085 * t1252 + t1089 * t1319 + t1092 * t1311 + t1095 * t1305 + t1326;
        let t1329 = t1327 + t1101 * t1299;
        let t1336 = t1079 * t1305;
        let t1337 = t1068 * t1075 - t1076 * t1329 - t1077 * t1319 - t1078 * t1311 - t1336;
        let t1341 = t1337 - t1080 * t1301 - t1081 * t1299;
        put(0, t1341);
        put(1, t1329);
        put(2, t1319);
        put(3, t1311);
        put(4, t1305);
        put(5, t1301);
        put(6, t1299);
    }
}
