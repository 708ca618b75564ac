//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 654 multiplications, 520 additions; 7, 7 of 7 structurally nonzero.

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
        FV6, FV7, FC1, FC2, FC3, FC4, FC5, FC6, FC7,
        ..] = *beta;
    let L2 = S::constant(0.4);
    let L3 = S::constant(0.39);
    let k0 = S::constant(9.81);
    let k3 = S::constant(1.0);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        a2_x, a2_y, w2_x, w2_y, t6, t7, t8, t10,
        t11,
    ] = {
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t6 = dq2 * dq2;
        let t7 = w2_x * w2_y;
        let t8 = dq2 * w2_x;
        let dw2_x = dq2 * w2_y;
        let t10 = w2_x * w2_x + t6;
        let t11 = dw2_x + dw2_x;
        [
        a2_x, a2_y, w2_x, w2_y, t6, t7, t8, t10,
        t11,
    ]
    };
    // composite body 7
    let [
        t14, t17, t20, t23, t27, t30, t31, t47,
        t56, t72, t75, t84, t87, t90,
    ] = {
        let t14 = c7 * MSY7 + s7 * MSX7;
        let t17 = c7 * MSX7 - s7 * MSY7;
        let t20 = c7 * XZ7 - s7 * YZ7;
        let t23 = s7 * XZ7 + c7 * YZ7;
        let t24 = c6 * t14;
        let t27 = s6 * ZZ7;
        let t28 = c6 * t20 - t27;
        let t30 = c6 * ZZ7;
        let t31 = s6 * t20 + t30;
        let t34 = c5 * t24 + s5 * t17;
        let t37 = c5 * t17 - s5 * t24;
        let t46 = c5 * t28 - s5 * t23 - L3 * t37;
        let t47 = s5 * t28 + c5 * t23 - L3 * t34;
        let t50 = c4 * t34 + s4 * (s6 * t14);
        let t53 = c4 * t46 + s4 * t31;
        let t56 = s4 * t46 - c4 * t31;
        let t71 = c3 * t53 - s3 * t47 - L2 * (c3 * t37 - s3 * t50);
        let t72 = s3 * t53 + c3 * t47 - L2 * (c3 * t50 + s3 * t37);
        let t75 = s2 * t71 - c2 * t56;
        let t77 = s7 * XY7;
        let t80 = c7 * XY7;
        let t81 = s7 * XX7R + t80;
        let t84 = c7 * (c7 * XX7R - t77) - s7 * t80;
        let t87 = c7 * t81 - s7 * t77;
        let t90 = s7 * t81 + c7 * t77;
        [
        t14, t17, t20, t23, t27, t30, t31, t47,
        t56, t72, t75, t84, t87, t90,
    ]
    };
    // composite body 6
    let [
        t93, t99, t102, t105, t108, t112, t115, t120,
        t129, t145, t148, t159, t162, t165, t166,
    ] = {
        let t91 = MSX6 + t17;
        let t92 = XX6R + t84;
        let t93 = ZZ6R + t90;
        let t94 = XY6 + t20;
        let t95 = XZ6 - t87;
        let t96 = YZ6 - t23;
        let t99 = c6 * MSY6R + s6 * t91;
        let t102 = c6 * t91 - s6 * MSY6R;
        let t105 = c6 * t95 - s6 * t96;
        let t108 = s6 * t95 + c6 * t96;
        let t109 = c5 * t99;
        let t110 = s5 * t99;
        let t112 = s5 * t93;
        let t115 = c5 * t93;
        let t119 = c5 * t105 + t112 + L3 * t110;
        let t120 = s5 * t105 - t115 - L3 * t109;
        let t123 = s4 * t102 - c4 * t109;
        let t126 = c4 * t119 + s4 * t108;
        let t129 = s4 * t119 - c4 * t108;
        let t144 = c3 * t126 - s3 * t120 - L2 * (s3 * t123 - c3 * t110);
        let t145 = s3 * t126 + c3 * t120 + L2 * (c3 * t123 + s3 * t110);
        let t148 = s2 * t144 - c2 * t129;
        let t150 = s6 * t94;
        let t153 = c6 * t94;
        let t154 = s6 * t92 + t153;
        let t156 = t30 + t150;
        let t159 = c6 * (c6 * t92 - t150) - s6 * (t153 - t27);
        let t162 = c6 * t154 - s6 * t156;
        let t165 = s6 * t154 + c6 * t156;
        let t166 = t99 + t99;
        [
        t93, t99, t102, t105, t108, t112, t115, t120,
        t129, t145, t148, t159, t162, t165, t166,
    ]
    };
    // composite body 5
    let [
        t170, t176, t179, t188, t189, t196, t212, t215,
        t229, t234, t235, t239,
    ] = {
        let t167 = MSX5 + t102;
        let t168 = MSY5R + t14;
        let t169 = XX5R + t159;
        let t170 = ZZ5R + t165;
        let t171 = XY5 - t105;
        let t172 = XZ5 + t162;
        let t173 = YZ5 - t108;
        let t176 = c5 * t168 + s5 * t167;
        let t179 = c5 * t167 - s5 * t168;
        let t188 = c5 * t172 - s5 * t173 - L3 * t179;
        let t189 = s5 * t172 + c5 * t173 - L3 * t176;
        let t190 = c4 * t176;
        let t193 = c4 * t188 + s4 * t170;
        let t196 = s4 * t188 - c4 * t170;
        let t211 = c3 * t193 - s3 * t189 - L2 * (c3 * t179 - s3 * t190);
        let t212 = s3 * t193 + c3 * t189 - L2 * (c3 * t190 + s3 * t179);
        let t215 = s2 * t211 - c2 * t196;
        let t217 = s5 * t171;
        let t220 = c5 * t171;
        let t221 = s5 * t169 + t220;
        let t223 = t115 + t217;
        let t229 = c5 * t221 - s5 * t223;
        let t233 = L3 * t166;
        let t234 = c5 * (c5 * t169 - t217) - s5 * (t220 - t112) + t233;
        let t235 = s5 * t221 + c5 * t223 + t233;
        let t237 = L3 * t99;
        let t239 = t170 + t233 - (t237 + t237);
        [
        t170, t176, t179, t188, t189, t196, t212, t215,
        t229, t234, t235, t239,
    ]
    };
    // composite body 4
    let [
        t243, t249, t252, t255, t258, t262, t265, t270,
        t273, t286, t289, t292, t293,
    ] = {
        let t240 = MSX4 + t179;
        let t241 = MSY4R - t99;
        let t242 = XX4R + t234;
        let t243 = ZZ4R + t235;
        let t244 = XY4 - t188;
        let t245 = XZ4 + t229;
        let t246 = YZ4 - t189;
        let t249 = c4 * t241 + s4 * t240;
        let t252 = c4 * t240 - s4 * t241;
        let t255 = c4 * t245 - s4 * t246;
        let t258 = s4 * t245 + c4 * t246;
        let t262 = s3 * t243;
        let t265 = c3 * t243;
        let t270 = s3 * t255 + t265 - L2 * (c3 * t249);
        let t273 = s2 * (c3 * t255 - t262 + L2 * (s3 * t249)) - c2 * t258;
        let t275 = s4 * t244;
        let t278 = c4 * t244;
        let t279 = s4 * t242 + t278;
        let t283 = t275 + c4 * t239;
        let t286 = c4 * (c4 * t242 - t275) - s4 * (t278 - s4 * t239);
        let t289 = c4 * t279 - s4 * t283;
        let t292 = s4 * t279 + c4 * t283;
        let t293 = t249 + t249;
        [
        t243, t249, t252, t255, t258, t262, t265, t270,
        t273, t286, t289, t292, t293,
    ]
    };
    // composite body 3
    let [t297, t315, t316, t319, t333, t338, t339, t343] = {
        let t294 = MSX3 + t252;
        let t295 = MSY3R + t176;
        let t296 = XX3R + t286;
        let t297 = ZZ3R + t292;
        let t298 = XY3 + t255;
        let t299 = XZ3 - t289;
        let t300 = YZ3 - t258;
        let t315 = c3 * t299 - s3 * t300 - L2 * (c3 * t294 - s3 * t295);
        let t316 = s3 * t299 + c3 * t300 - L2 * (c3 * t295 + s3 * t294);
        let t319 = s2 * t315 + c2 * t297;
        let t321 = s3 * t298;
        let t324 = c3 * t298;
        let t325 = s3 * t296 + t324;
        let t327 = t265 + t321;
        let t333 = c3 * t325 - s3 * t327;
        let t337 = L2 * t293;
        let t338 = c3 * (c3 * t296 - t321) - s3 * (t324 - t262) - t337;
        let t339 = s3 * t325 + c3 * t327 - t337;
        let t341 = L2 * t249;
        let t343 = t297 - t337 + (t341 + t341);
        [t297, t315, t316, t319, t333, t338, t339, t343]
    };
    // composite body 2
    let [t345, t351, t360] = {
        let t345 = ZZ2R + t339;
        let t346 = XY2 + t315;
        let t351 = s2 * (XZ2 - t333) + c2 * (YZ2 - t316);
        let t359 = c2 * (s2 * t346 + c2 * t343);
        let t360 = s2 * (s2 * (XX2R + t338) + c2 * t346) + t359;
        [t345, t351, t360]
    };
    // composite body 1
    let t361 = {
        let t361 = ZZ1R + t360;
        t361
    };
    // M = L D L'
    let [
        t362, t363, t364, t365, t366, t367, t368, t372,
        t376, t379, t382, t385, t388, t395, t402, t407,
        t412, t417, t427, t437, t444, t451, t464, t477,
        t486, t502, t518, t537,
    ] = {
        let t362 = k3 / t361;
        let t363 = t351 * t362;
        let t364 = t319 * t362;
        let t365 = t273 * t362;
        let t366 = t215 * t362;
        let t367 = t148 * t362;
        let t368 = t75 * t362;
        let t371 = t345 - t361 * (t363 * t363);
        let t372 = k3 / t371;
        let t373 = t361 * t363;
        let t376 = t372 * (t316 + t364 * t373);
        let t379 = t372 * (t270 + t365 * t373);
        let t382 = t372 * (t212 + t366 * t373);
        let t385 = t372 * (t145 + t367 * t373);
        let t388 = t372 * (t72 + t368 * t373);
        let t394 = t297 - t361 * (t364 * t364) - t371 * (t376 * t376);
        let t395 = k3 / t394;
        let t396 = t361 * t364;
        let t399 = t371 * t376;
        let t402 = t395 * (t258 + t365 * t396 + t379 * t399);
        let t407 = t395 * (t196 + t366 * t396 + t382 * t399);
        let t412 = t395 * (t129 + t367 * t396 + t385 * t399);
        let t417 = t395 * (t56 + t368 * t396 + t388 * t399);
        let t425 = t394 * (t402 * t402);
        let t426 = t243 - t361 * (t365 * t365) - t371 * (t379 * t379) - t425;
        let t427 = k3 / t426;
        let t428 = t361 * t365;
        let t431 = t371 * t379;
        let t434 = t394 * t402;
        let t437 = t427 * (t189 - t366 * t428 - t382 * t431 - t407 * t434);
        let t444 = t427 * (t120 - t367 * t428 - t385 * t431 - t412 * t434);
        let t451 = t427 * (t47 - t368 * t428 - t388 * t431 - t417 * t434);
        let t459 = t394 * (t407 * t407);
        let t462 = t426 * (t437 * t437);
        let t463 = t170 - t361 * (t366 * t366) - t371 * (t382 * t382) - t459 - t462;
        let t464 = k3 / t463;
        let t465 = t361 * t366;
        let t468 = t371 * t382;
        let t471 = t394 * t407;
        let t474 = t426 * t437;
        let t476 = t108 - t367 * t465 - t385 * t468 - t412 * t471 - t444 * t474;
        let t477 = t464 * t476;
        let t485 = t31 - t368 * t465 - t388 * t468 - t417 * t471 - t451 * t474;
        let t486 = t464 * t485;
        let t494 = t394 * (t412 * t412);
        let t497 = t426 * (t444 * t444);
        let t498 = t93 - t361 * (t367 * t367) - t371 * (t385 * t385) - t494 - t497;
        let t501 = t498 - t463 * (t477 * t477);
        let t502 = k3 / t501;
        let t510 = t417 * (t394 * t412);
        let t513 = t451 * (t426 * t444);
        let t514 = t23 + t368 * (t361 * t367) + t388 * (t371 * t385) + t510 + t513;
        let t518 = t502 * (t514 + t486 * (t463 * t477));
        let t526 = t394 * (t417 * t417);
        let t529 = t426 * (t451 * t451);
        let t530 = ZZ7 - t361 * (t368 * t368) - t371 * (t388 * t388) - t526 - t529;
        let t537 = k3 / (t530 - t463 * (t486 * t486) - t501 * (t518 * t518));
        [
        t362, t363, t364, t365, t366, t367, t368, t372,
        t376, t379, t382, t385, t388, t395, t402, t407,
        t412, t417, t427, t437, t444, t451, t464, t477,
        t486, t502, t518, t537,
    ]
    };
    // link 3: motion
    let [
        a3_z, a3_x, t548, w3_x, t554, t557, t560, w3_z,
        t564, t565, t566, dw3_x, dw3_y, t569, t570, t571,
        t572, t573, t574, t575,
    ] = {
        let t540 = L2 * t11;
        let t541 = a2_x + L2 * t7;
        let a3_z = a2_y - L2 * t10;
        let a3_x = c3 * t541 - s3 * t540;
        let t548 = c3 * t540 + s3 * t541;
        let w3_x = c3 * w2_x - s3 * dq2;
        let t554 = c3 * dq2 + s3 * w2_x;
        let t557 = c3 * t7 - s3 * t11;
        let t560 = c3 * t11 + s3 * t7;
        let w3_z = w2_y + dq3;
        let t562 = w3_x * w3_x;
        let t563 = w3_z * w3_z;
        let t564 = w3_x * t554;
        let t565 = w3_x * w3_z;
        let t566 = t554 * w3_z;
        let dw3_x = t560 - t566;
        let dw3_y = t557 - t565;
        let t569 = t562 - t563;
        let t570 = t569 - t10;
        let t571 = t8 - t564;
        let t572 = t8 + t564;
        let t573 = t562 + t563;
        let t574 = t565 - dw3_y;
        let t575 = dw3_x - t566;
        [
        a3_z, a3_x, t548, w3_x, t554, t557, t560, w3_z,
        t564, t565, t566, dw3_x, dw3_y, t569, t570, t571,
        t572, t573, t574, t575,
    ]
    };
    // link 4: motion
    let [
        a4_x, t581, w4_x, t587, t590, t593, w4_z, t597,
        t598, t599, dw4_x, dw4_y, t602, t603, t604, t605,
        t606, t607, t608,
    ] = {
        let a4_x = c4 * a3_x - s4 * a3_z;
        let t581 = c4 * a3_z + s4 * a3_x;
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t587 = c4 * w3_z + s4 * w3_x;
        let t590 = c4 * t571 - s4 * t575;
        let t593 = c4 * t575 + s4 * t571;
        let w4_z = dq4 - t554;
        let t595 = w4_x * w4_x;
        let t596 = w4_z * w4_z;
        let t597 = w4_x * t587;
        let t598 = w4_x * w4_z;
        let t599 = t587 * w4_z;
        let dw4_x = t593 - t599;
        let dw4_y = t590 - t598;
        let t602 = t595 - t596;
        let t603 = t602 - t573;
        let t604 = dw3_y + t597;
        let t605 = dw3_y - t597;
        let t606 = t595 + t596;
        let t607 = t598 - dw4_y;
        let t608 = dw4_x - t599;
        [
        a4_x, t581, w4_x, t587, t590, t593, w4_z, t597,
        t598, t599, dw4_x, dw4_y, t602, t603, t604, t605,
        t606, t607, t608,
    ]
    };
    // link 5: motion
    let [
        t613, a5_x, a6_z, w5_x, w5_y, t629, t632, w5_z,
        t636, t637, t638, dw5_x, dw5_y, t641, t642, t643,
        t644, t645, t646, t647,
    ] = {
        let t612 = a4_x + L3 * t604;
        let t613 = L3 * t606 - t581;
        let t614 = t548 + L3 * t608;
        let a5_x = c5 * t612 - s5 * t614;
        let a6_z = c5 * t614 + s5 * t612;
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t629 = c5 * t604 - s5 * t608;
        let t632 = c5 * t608 + s5 * t604;
        let w5_z = t587 + dq5;
        let t634 = w5_x * w5_x;
        let t635 = w5_z * w5_z;
        let t636 = w5_x * w5_y;
        let t637 = w5_x * w5_z;
        let t638 = w5_y * w5_z;
        let dw5_x = t632 + t638;
        let dw5_y = t629 - t637;
        let t641 = t634 - t635;
        let t642 = t641 - t606;
        let t643 = dw4_y + t636;
        let t644 = t636 - dw4_y;
        let t645 = t634 + t635;
        let t646 = t637 - dw5_y;
        let t647 = t638 + dw5_x;
        [
        t613, a5_x, a6_z, w5_x, w5_y, t629, t632, w5_z,
        t636, t637, t638, dw5_x, dw5_y, t641, t642, t643,
        t644, t645, t646, t647,
    ]
    };
    // link 6: motion
    let [
        a6_x, t653, w6_x, w6_y, t662, t665, w6_z, t669,
        t670, t671, dw6_x, t673, t674, t675, t676, t677,
        t678, t679, t680,
    ] = {
        let a6_x = c6 * a5_x - s6 * t613;
        let t653 = c6 * t613 + s6 * a5_x;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t662 = c6 * t643 + s6 * t647;
        let t665 = s6 * t643 - c6 * t647;
        let w6_z = dq6 - w5_y;
        let t667 = w6_x * w6_x;
        let t668 = w6_z * w6_z;
        let t669 = w6_x * w6_y;
        let t670 = w6_x * w6_z;
        let t671 = w6_y * w6_z;
        let dw6_x = t671 - t665;
        let t673 = t662 + t670;
        let t674 = t667 - t668;
        let t675 = t674 - t645;
        let t676 = dw5_y + t669;
        let t677 = t669 - dw5_y;
        let t678 = t667 + t668;
        let t679 = t670 + t673;
        let t680 = t671 + dw6_x;
        [
        a6_x, t653, w6_x, w6_y, t662, t665, w6_z, t669,
        t670, t671, dw6_x, t673, t674, t675, t676, t677,
        t678, t679, t680,
    ]
    };
    // link 7: motion
    let [
        a7_x, t686, t695, t698, t702, t703, t704, dw7_x,
        t707, t708, t709, t710, t711, t712, t713,
    ] = {
        let a7_x = c7 * a6_x - s7 * a6_z;
        let t686 = c7 * a6_z + s7 * a6_x;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t692 = c7 * w6_z + s7 * w6_x;
        let t695 = c7 * t676 - s7 * t680;
        let t698 = c7 * t680 + s7 * t676;
        let w7_z = w6_y + dq7;
        let t700 = w7_x * w7_x;
        let t701 = w7_z * w7_z;
        let t702 = w7_x * t692;
        let t703 = w7_x * w7_z;
        let t704 = t692 * w7_z;
        let dw7_x = t698 - t704;
        let dw7_y = t695 - t703;
        let t707 = t700 - t701;
        let t708 = t707 - t678;
        let t709 = t673 - t702;
        let t710 = t673 + t702;
        let t711 = t700 + t701;
        let t712 = t703 - dw7_y;
        let t713 = dw7_x - t704;
        [
        a7_x, t686, t695, t698, t702, t703, t704, dw7_x,
        t707, t708, t709, t710, t711, t712, t713,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t761, t764, t767, t770] = {
        let t734 = XX7R * t702 - ZZ7 * t673 + XY7 * (t708 + t711) + XZ7 * t698;
        let t736 = YZ7 * (t678 - t711);
        let t739 = XX7R * dw7_x - ZZ7 * t704 - XY7 * t712 - XZ7 * t710 + t736;
        let t740 = t703 * (XX7R - ZZ7) + XY7 * t713 - XZ7 * t707 - YZ7 * t709;
        let f7_x = MSX7 * t708 + MSY7 * t709;
        let t747 = MSX7 * t710 + MSY7 * t711;
        let f7_z = MSX7 * t712 + MSY7 * t713;
        let n7_x = t739 - MSY7 * t653;
        let n7_y = t740 + MSX7 * t653;
        let n7_z = t734 + YZ7 * t695 - (MSX7 * t686 + MSY7 * a7_x);
        let t761 = c7 * f7_x + s7 * t747;
        let t764 = s7 * f7_x - c7 * t747;
        let t767 = c7 * n7_x - s7 * n7_y;
        let t770 = s7 * n7_x + c7 * n7_y;
        [f7_z, n7_z, t761, t764, t767, t770]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t824, t827, t830, t833] = {
        let t791 = XY6 * (t675 + t678) - (XX6R * t669 + ZZ6R * dw5_y) - XZ6 * t665;
        let t793 = YZ6 * (t645 - t678);
        let t796 = ZZ6R * t671 + XX6R * dw6_x - XY6 * t679 + XZ6 * t677 + t793;
        let t797 = t670 * (XX6R - ZZ6R) + XY6 * t680 - XZ6 * t674 - YZ6 * t676;
        let f6_x = t761 + (MSX6 * t675 + MSY6R * t676);
        let f6_y = f7_z + (MSX6 * t677 - MSY6R * t678);
        let f6_z = MSX6 * t679 + MSY6R * t680 - t764;
        let n6_x = t767 + (t796 + MSY6R * a6_z);
        let n6_y = n7_z + (t797 - MSX6 * a6_z);
        let n6_z = t791 - YZ6 * t662 - (MSX6 * t653 + MSY6R * a6_x) - t770;
        let t824 = c6 * f6_x - s6 * f6_y;
        let t827 = s6 * f6_x + c6 * f6_y;
        let t830 = c6 * n6_x - s6 * n6_y;
        let t833 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t824, t827, t830, t833]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t887, t890, t899, t900] = {
        let t854 = XY5 * (t642 + t645) - (XX5R * t636 + ZZ5R * dw4_y) + XZ5 * t632;
        let t856 = YZ5 * (t606 - t645);
        let t859 = ZZ5R * t638 + XX5R * dw5_x - XY5 * t646 + XZ5 * t644 + t856;
        let t860 = t637 * (XX5R - ZZ5R) + XY5 * t647 - XZ5 * t641 - YZ5 * t643;
        let f5_x = t824 + (MSX5 * t642 + MSY5R * t643);
        let f5_y = MSX5 * t644 - MSY5R * t645 - f6_z;
        let f5_z = t827 + (MSX5 * t646 + MSY5R * t647);
        let n5_x = t830 + (t859 - MSY5R * t613);
        let n5_y = t860 + MSX5 * t613 - n6_z;
        let n5_z = t833 + (t854 + YZ5 * t629 - (MSX5 * a6_z + MSY5R * a5_x));
        let t887 = c5 * f5_x - s5 * f5_y;
        let t890 = s5 * f5_x + c5 * f5_y;
        let t899 = c5 * n5_x - s5 * n5_y - L3 * t890;
        let t900 = s5 * n5_x + c5 * n5_y + L3 * t887;
        [f5_z, n5_z, t887, t890, t899, t900]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t954, t957, t960] = {
        let t921 = XX4R * t597 + ZZ4R * dw3_y + XY4 * (t603 + t606) + XZ4 * t593;
        let t923 = YZ4 * (t573 - t606);
        let t926 = XX4R * dw4_x - ZZ4R * t599 - XY4 * t607 + XZ4 * t605 + t923;
        let t927 = t598 * (XX4R - ZZ4R) + XY4 * t608 - XZ4 * t602 + YZ4 * t604;
        let f4_x = t887 + (MSX4 * t603 - MSY4R * t604);
        let f4_y = MSX4 * t605 - MSY4R * t606 - f5_z;
        let f4_z = t890 + (MSX4 * t607 + MSY4R * t608);
        let n4_x = t899 + (t926 - MSY4R * t548);
        let n4_y = t927 + MSX4 * t548 - n5_z;
        let n4_z = t900 + (t921 + YZ4 * t590 - (MSX4 * t581 + MSY4R * a4_x));
        let t954 = c4 * f4_x - s4 * f4_y;
        let t957 = c4 * n4_x - s4 * n4_y;
        let t960 = s4 * n4_x + c4 * n4_y;
        [f4_z, n4_z, t954, t957, t960]
    };
    // link 3: force and moment
    let [n3_z, n2_x, t1023] = {
        let t981 = XX3R * t564 - ZZ3R * t8 + XY3 * (t570 + t573) + XZ3 * t560;
        let t983 = YZ3 * (t10 - t573);
        let t986 = XX3R * dw3_x - ZZ3R * t566 - XY3 * t574 - XZ3 * t572 + t983;
        let t987 = t565 * (XX3R - ZZ3R) + XY3 * t575 - XZ3 * t569 - YZ3 * t571;
        let f3_x = t954 + (MSX3 * t570 + MSY3R * t571);
        let f3_y = f4_z - (MSX3 * t572 + MSY3R * t573);
        let n3_x = t957 + (t986 + MSY3R * a3_z);
        let n3_y = n4_z + (t987 - MSX3 * a3_z);
        let n3_z = t981 + YZ3 * t557 - (MSX3 * t548 + MSY3R * a3_x) - t960;
        let n2_x = c3 * n3_x - s3 * n3_y - L2 * (s3 * f3_x + c3 * f3_y);
        let t1023 = s3 * n3_x + c3 * n3_y + L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, n2_x, t1023]
    };
    // link 2: force and moment
    let [t1037, n2_z, t1046] = {
        let t1029 = c2 * (s2 * XX2R + c2 * (XY2 + XY2)) - XY2;
        let t1037 = (t1029 + t1029) * (dq1 * dq2) + t6 * (c2 * XZ2 - s2 * YZ2);
        let n2_z = MSX2 * a2_y - MSY2R * a2_x - t1023 - t0 * t1029;
        let t1046 = s2 * n2_x + c2 * n3_z;
        [t1037, n2_z, t1046]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t1037 + t1046;
        n1_z
    };
    // drives
    let [t1083, t1084, t1085, t1086, t1087, t1088, t1089] = {
        let t1083 = tau1 - (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t1084 = tau2 - (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t1085 = tau3 - (n3_z + FV3 * dq3 + FC3 * dq3.sign());
        let t1086 = tau4 - (n4_z + FV4 * dq4 + FC4 * dq4.sign());
        let t1087 = tau5 - (n5_z + FV5 * dq5 + FC5 * dq5.sign());
        let t1088 = tau6 - (n6_z + FV6 * dq6 + FC6 * dq6.sign());
        let t1089 = tau7 - (n7_z + FV7 * dq7 + FC7 * dq7.sign());
        [t1083, t1084, t1085, t1086, t1087, t1088, t1089]
    };
    // ddq
    {
        let t1091 = t1084 - t1083 * t363;
        let t1095 = t1085 - t1083 * t364 + t376 * t1091;
        let t1101 = t1086 - t1083 * t365 + t379 * t1091 + t402 * t1095;
        let t1109 = t1087 - t1083 * t366 + t382 * t1091 + t407 * t1095 - t437 * t1101;
        let t1117 = t1088 - t1083 * t367 + t385 * t1091 + t412 * t1095 - t444 * t1101;
        let t1119 = t1117 - t477 * t1109;
        let t1127 = t1089 - t1083 * t368 + t388 * t1091 + t417 * t1095 - t451 * t1101;
        let t1138 = t537 * (t1127 - t486 * t1109 + t518 * t1119);
        let t1140 = t502 * t1119 + t518 * t1138;
        let t1144 = t464 * t1109 - t477 * t1140 - t486 * t1138;
        let t1150 = t427 * t1101 - t437 * t1144 - t444 * t1140 - t451 * t1138;
        let t1157 = t417 * t1138;
        let t1158 = t395 * t1095 + t402 * t1150 + t407 * t1144 + t412 * t1140 + t1157;
        let t1165 = t385 * t1140;
        let t1166 = t372 * t1091 + t376 * t1158 + t379 * t1150 + t382 * t1144 + t1165;
        let t1168 = t1166 + t388 * t1138;
        let t1175 = t366 * t1144;
        let t1176 = t1083 * t362 - t363 * t1168 - t364 * t1158 - t365 * t1150 - t1175;
        let t1180 = t1176 - t367 * t1140 - t368 * t1138;
        put(0, t1180);
        put(1, t1168);
        put(2, t1158);
        put(3, t1150);
        put(4, t1144);
        put(5, t1140);
        put(6, t1138);
    }
}
