//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 743 multiplications, 614 additions; 7, 7 of 7 structurally nonzero.

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
    // link 2: motion
    let [w2_x, w2_y, t441, t442, a2_z, dw2_x, t445] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t441 = s2 * k6;
        let t442 = c2 * k6;
        let a2_z = k5 * (dq1 * dq1);
        let dw2_x = dq2 * w2_y;
        let t445 = dq2 * w2_x;
        [w2_x, w2_y, t441, t442, a2_z, dw2_x, t445]
    };
    // link 3: motion
    let [
        w3_x, t451, t454, t455, t456, t457, t458, t459,
        t460, t461, a3_z, t470, a3_y, w3_z, dw3_x, dw4_z,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t451 = c3 * dq2 + s3 * w2_x;
        let t454 = w2_x * w2_x;
        let t455 = w2_y * w2_y;
        let t456 = dq2 * dq2;
        let t457 = w2_x * w2_y;
        let t458 = t455 + t456;
        let t459 = t454 + t456;
        let t460 = t445 + t445;
        let t461 = dw2_x + dw2_x;
        let t465 = t441 + k4 * t457;
        let a3_z = k4 * t459 - t442;
        let t467 = a2_z - k4 * t461;
        let t470 = c3 * t465 + s3 * t467;
        let a3_y = s3 * t465 - c3 * t467;
        let w3_z = w2_y + dq3;
        let dw3_x = c3 * dw2_x - dq3 * t451;
        let dw4_z = s3 * dw2_x + dq3 * w3_x;
        [
        w3_x, t451, t454, t455, t456, t457, t458, t459,
        t460, t461, a3_z, t470, a3_y, w3_z, dw3_x, dw4_z,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t491, t492, t493, t494, t495, t496,
        t497, t498, t499, t500, t501, t502, t503, t504,
        t509, a4_x, a4_y, w4_z, dw4_x, t521,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t491 = w3_x * w3_x;
        let t492 = t451 * t451;
        let t493 = w3_z * w3_z;
        let t494 = w3_x * t451;
        let t495 = w3_x * w3_z;
        let t496 = t451 * w3_z;
        let t497 = t492 + t493;
        let t498 = t445 - t494;
        let t499 = t495 - dw4_z;
        let t500 = t445 + t494;
        let t501 = t491 + t493;
        let t502 = dw3_x + t496;
        let t503 = dw4_z + t495;
        let t504 = dw3_x - t496;
        let t508 = k3 * t498 - t470;
        let t509 = a3_y - k3 * t501;
        let t510 = a3_z + k3 * t504;
        let a4_x = c4 * t508 + s4 * t510;
        let a4_y = c4 * t510 - s4 * t508;
        let w4_z = t451 + dq4;
        let dw4_x = c4 * dw3_x - s4 * t445 + dq4 * w4_y;
        let t521 = c4 * t445 + s4 * dw3_x + dq4 * w4_x;
        [
        w4_x, w4_y, t491, t492, t493, t494, t495, t496,
        t497, t498, t499, t500, t501, t502, t503, t504,
        t509, a4_x, a4_y, w4_z, dw4_x, t521,
    ]
    };
    // link 5: motion
    let [
        w5_x, t527, t534, t535, t536, t537, t538, t539,
        t540, t541, t542, t543, t544, t545, t546, t547,
        a5_z, a5_x, a5_y, w5_z, dw5_x, dw6_z,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t527 = c5 * w4_z + s5 * w4_x;
        let t534 = w4_x * w4_x;
        let t535 = w4_y * w4_y;
        let t536 = w4_z * w4_z;
        let t537 = w4_x * w4_y;
        let t538 = w4_x * w4_z;
        let t539 = w4_y * w4_z;
        let t540 = t535 + t536;
        let t541 = t537 - dw4_z;
        let t542 = t538 - t521;
        let t543 = dw4_z + t537;
        let t544 = t534 + t536;
        let t545 = t539 - dw4_x;
        let t546 = t521 + t538;
        let t547 = dw4_x + t539;
        let t551 = a4_x - k2 * t541;
        let a5_z = a4_y + k2 * t544;
        let t553 = t509 + k2 * t547;
        let a5_x = c5 * t551 + s5 * t553;
        let a5_y = c5 * t553 - s5 * t551;
        let w5_z = w4_y + dq5;
        let dw5_x = c5 * dw4_x - s5 * dw4_z - dq5 * t527;
        let dw6_z = c5 * dw4_z + s5 * dw4_x + dq5 * w5_x;
        [
        w5_x, t527, t534, t535, t536, t537, t538, t539,
        t540, t541, t542, t543, t544, t545, t546, t547,
        a5_z, a5_x, a5_y, w5_z, dw5_x, dw6_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t577, t578, t579, t580, t581, t582,
        t583, t584, t585, t586, t587, t588, t589, t590,
        t595, a6_x, a6_y, w6_z, dw6_x, t607,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t577 = w5_x * w5_x;
        let t578 = t527 * t527;
        let t579 = w5_z * w5_z;
        let t580 = w5_x * t527;
        let t581 = w5_x * w5_z;
        let t582 = t527 * w5_z;
        let t583 = t578 + t579;
        let t584 = t521 - t580;
        let t585 = t581 - dw6_z;
        let t586 = t521 + t580;
        let t587 = t577 + t579;
        let t588 = dw5_x + t582;
        let t589 = dw6_z + t581;
        let t590 = dw5_x - t582;
        let t594 = a5_x + k1 * t584;
        let t595 = a5_y - k1 * t587;
        let t596 = a5_z + k1 * t590;
        let a6_x = c6 * t594 + s6 * t596;
        let a6_y = c6 * t596 - s6 * t594;
        let w6_z = t527 + dq6;
        let dw6_x = c6 * dw5_x - s6 * t521 + dq6 * w6_y;
        let t607 = c6 * t521 + s6 * dw5_x + dq6 * w6_x;
        [
        w6_x, w6_y, t577, t578, t579, t580, t581, t582,
        t583, t584, t585, t586, t587, t588, t589, t590,
        t595, a6_x, a6_y, w6_z, dw6_x, t607,
    ]
    };
    // link 7: motion
    let [
        w7_x, t613, t620, t621, t622, t623, t624, t625,
        t626, t627, t628, t629, t630, t631, t632, t633,
        a7_z, a7_x, a7_y, w7_z, dw7_x, t650,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t613 = c7 * w6_z + s7 * w6_x;
        let t620 = w6_x * w6_x;
        let t621 = w6_y * w6_y;
        let t622 = w6_z * w6_z;
        let t623 = w6_x * w6_y;
        let t624 = w6_x * w6_z;
        let t625 = w6_y * w6_z;
        let t626 = t621 + t622;
        let t627 = t623 - dw6_z;
        let t628 = t624 - t607;
        let t629 = dw6_z + t623;
        let t630 = t620 + t622;
        let t631 = t625 - dw6_x;
        let t632 = t607 + t624;
        let t633 = dw6_x + t625;
        let t637 = a6_x - k0 * t627;
        let a7_z = a6_y + k0 * t630;
        let t639 = t595 + k0 * t633;
        let a7_x = c7 * t637 + s7 * t639;
        let a7_y = c7 * t639 - s7 * t637;
        let w7_z = w6_y + dq7;
        let dw7_x = c7 * dw6_x - s7 * dw6_z - dq7 * t613;
        let t650 = c7 * dw6_z + s7 * dw6_x + dq7 * w7_x;
        [
        w7_x, t613, t620, t621, t622, t623, t624, t625,
        t626, t627, t628, t629, t630, t631, t632, t633,
        a7_z, a7_x, a7_y, w7_z, dw7_x, t650,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t713, t716, t725, t726] = {
        let t651 = w7_x * w7_x;
        let t652 = t613 * t613;
        let t653 = w7_z * w7_z;
        let t654 = w7_x * t613;
        let t655 = w7_x * w7_z;
        let t656 = t613 * w7_z;
        let t658 = t607 - t654;
        let t660 = t607 + t654;
        let t663 = t650 + t655;
        let t664 = dw7_x - t656;
        let t683 = XZ7 * (dw7_x + t656);
        let t688 = YZ7 * (t652 - t653);
        let t689 = YZ7 * t658;
        let t690 = YZ7 * (t655 - t650);
        let t691 = XX7R * dw7_x - ZZ7 * t656 - XY7 * t663 - XZ7 * t660 + t688;
        let t692 = t655 * (XX7R - ZZ7) + XY7 * t664 + XZ7 * (t653 - t651) - t689;
        let t693 = XX7R * t654 - ZZ7 * t607 + XY7 * (t651 - t652) + t683 + t690;
        let f7_x = MSY7 * t658 - MSX7 * (t652 + t653);
        let t699 = MSX7 * t660 + MSY7 * (t651 + t653);
        let f7_z = MSX7 * t663 + MSY7 * t664;
        let n7_x = t691 + MSY7 * a7_z;
        let n7_y = t692 - MSX7 * a7_z;
        let n7_z = t693 + (MSX7 * a7_y - MSY7 * a7_x);
        let t713 = c7 * f7_x + s7 * t699;
        let t716 = s7 * f7_x - c7 * t699;
        let t725 = c7 * n7_x - s7 * n7_y + k0 * t716;
        let t726 = s7 * n7_x + c7 * n7_y - k0 * t713;
        [f7_z, n7_z, t713, t716, t725, t726]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t781, t784, t793, t794] = {
        let t748 = ZZ6R * dw6_z - XX6R * t623 + XY6 * (t620 - t621) - XZ6 * t631;
        let t750 = YZ6 * (t621 - t622);
        let t751 = YZ6 * t627;
        let t753 = ZZ6R * t625 + XX6R * dw6_x - XY6 * t632 + XZ6 * t629 + t750;
        let t754 = t624 * (XX6R - ZZ6R) + XY6 * t633 + XZ6 * (t622 - t620) - t751;
        let f6_x = t713 + (MSY6R * t627 - MSX6 * t626);
        let f6_y = f7_z + (MSX6 * t629 - MSY6R * t630);
        let f6_z = MSX6 * t632 + MSY6R * t633 - t716;
        let n6_x = t725 + (t753 - MSY6R * t595);
        let n6_y = n7_z + (t754 + MSX6 * t595);
        let n6_z = t748 + YZ6 * t628 + (MSX6 * a6_y - MSY6R * a6_x) - t726;
        let t781 = c6 * f6_x - s6 * f6_y;
        let t784 = s6 * f6_x + c6 * f6_y;
        let t793 = c6 * n6_x - s6 * n6_y + k1 * t784;
        let t794 = s6 * n6_x + c6 * n6_y - k1 * t781;
        [f6_z, n6_z, t781, t784, t793, t794]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t849, t852, t861, t862] = {
        let t816 = XX5R * t580 - ZZ5R * t521 + XY5 * (t577 - t578) + XZ5 * t588;
        let t818 = YZ5 * (t578 - t579);
        let t819 = YZ5 * t584;
        let t821 = XX5R * dw5_x - ZZ5R * t582 - XY5 * t589 - XZ5 * t586 + t818;
        let t822 = t581 * (XX5R - ZZ5R) + XY5 * t590 + XZ5 * (t579 - t577) - t819;
        let f5_x = t781 + (MSY5R * t584 - MSX5 * t583);
        let t842 = f6_z + (MSX5 * t586 + MSY5R * t587);
        let f5_z = t784 + (MSX5 * t589 + MSY5R * t590);
        let n5_x = t793 + (t821 + MSY5R * a5_z);
        let n5_y = t822 - MSX5 * a5_z - n6_z;
        let n5_z = t794 + (t816 + YZ5 * t585 + (MSX5 * a5_y - MSY5R * a5_x));
        let t849 = c5 * f5_x + s5 * t842;
        let t852 = s5 * f5_x - c5 * t842;
        let t861 = c5 * n5_x - s5 * n5_y + k2 * t852;
        let t862 = s5 * n5_x + c5 * n5_y - k2 * t849;
        [f5_z, n5_z, t849, t852, t861, t862]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t917, t920, t929, t930] = {
        let t884 = ZZ4R * dw4_z - XX4R * t537 + XY4 * (t534 - t535) - XZ4 * t545;
        let t886 = YZ4 * (t535 - t536);
        let t887 = YZ4 * t541;
        let t889 = ZZ4R * t539 + XX4R * dw4_x - XY4 * t546 + XZ4 * t543 + t886;
        let t890 = t538 * (XX4R - ZZ4R) + XY4 * t547 + XZ4 * (t536 - t534) - t887;
        let f4_x = t849 + (MSY4R * t541 - MSX4 * t540);
        let f4_y = f5_z + (MSX4 * t543 - MSY4R * t544);
        let f4_z = MSX4 * t546 + MSY4R * t547 - t852;
        let n4_x = t861 + (t889 - MSY4R * t509);
        let n4_y = n5_z + (t890 + MSX4 * t509);
        let n4_z = t884 + YZ4 * t542 + (MSX4 * a4_y - MSY4R * a4_x) - t862;
        let t917 = c4 * f4_x - s4 * f4_y;
        let t920 = s4 * f4_x + c4 * f4_y;
        let t929 = c4 * n4_x - s4 * n4_y + k3 * t920;
        let t930 = s4 * n4_x + c4 * n4_y - k3 * t917;
        [f4_z, n4_z, t917, t920, t929, t930]
    };
    // link 3: force and moment
    let [f3_z, n3_z, t985, t997, t998] = {
        let t952 = XX3R * t494 - ZZ3R * t445 + XY3 * (t491 - t492) + XZ3 * t502;
        let t954 = YZ3 * (t492 - t493);
        let t955 = YZ3 * t498;
        let t957 = XX3R * dw3_x - ZZ3R * t496 - XY3 * t503 - XZ3 * t500 + t954;
        let t958 = t495 * (XX3R - ZZ3R) + XY3 * t504 + XZ3 * (t493 - t491) - t955;
        let f3_x = t917 + (MSY3R * t498 - MSX3 * t497);
        let t978 = f4_z + (MSX3 * t500 + MSY3R * t501);
        let f3_z = t920 + (MSX3 * t503 + MSY3R * t504);
        let n3_x = t929 + (t957 + MSY3R * a3_z);
        let n3_y = t958 - MSX3 * a3_z - n4_z;
        let n3_z = t930 + (t952 + YZ3 * t499 + (MSX3 * a3_y + MSY3R * t470));
        let t985 = c3 * f3_x + s3 * t978;
        let t997 = c3 * n3_x - s3 * n3_y + k4 * (s3 * f3_x - c3 * t978);
        let t998 = s3 * n3_x + c3 * n3_y - k4 * t985;
        [f3_z, n3_z, t985, t997, t998]
    };
    // link 2: force and moment
    let [n2_z, n1_z] = {
        let t1017 = YZ2 * (t455 - t456);
        let t1018 = YZ2 * t457;
        let t1020 = t445 * (XX2R - ZZ2R) + XY2 * t461 + XZ2 * (t456 - t454) - t1018;
        let t1027 = MSY2R * a2_z;
        let t1032 = dw2_x * (XX2R + ZZ2R) - XY2 * t460 + XZ2 * t457 + t1017 + t1027;
        let t1034 = XY2 * (t454 - t455) - XX2R * t457 + (MSY2R * t441 - MSX2 * t442);
        let f2_x = t985 + (MSY2R * t457 - MSX2 * t458);
        let f2_y = f3_z + (MSX2 * t457 - MSY2R * t459);
        let n2_x = t997 + t1032;
        let n2_y = n3_z + (t1020 - MSX2 * a2_z);
        let n2_z = t1034 - t998;
        let f1_x = c2 * f2_x - s2 * f2_y;
        let n1_z = s2 * n2_x + c2 * n2_y - k5 * f1_x;
        [n2_z, n1_z]
    };
    // drives
    let [t1090, t1091, t1092, t1093, t1094, t1095, t1096] = {
        let t1090 = tau1 - (FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign()));
        let t1091 = tau2 - (FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign()));
        let t1092 = tau3 - (FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign()));
        let t1093 = tau4 - (FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign()));
        let t1094 = tau5 - (FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign()));
        let t1095 = tau6 - (FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign()));
        let t1096 = tau7 - (FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign()));
        [t1090, t1091, t1092, t1093, t1094, t1095, t1096]
    };
    // M = L D L'
    let [
        t1097, t1098, t1099, t1100, t1101, t1102, t1103, t1107,
        t1111, t1114, t1117, t1120, t1123, t1130, t1137, t1142,
        t1147, t1152, t1162, t1172, t1179, t1186, t1199, t1212,
        t1221, t1237, t1253, t1272,
    ] = {
        let t1097 = k7 / t437;
        let t1098 = t425 * t1097;
        let t1099 = t383 * t1097;
        let t1100 = t327 * t1097;
        let t1101 = t257 * t1097;
        let t1102 = t173 * t1097;
        let t1103 = t83 * t1097;
        let t1106 = t414 - t437 * (t1098 * t1098);
        let t1107 = k7 / t1106;
        let t1108 = t437 * t1098;
        let t1111 = t1107 * (t377 + t1099 * t1108);
        let t1114 = t1107 * (t319 + t1100 * t1108);
        let t1117 = t1107 * (t249 + t1101 * t1108);
        let t1120 = t1107 * (t165 + t1102 * t1108);
        let t1123 = t1107 * (t75 + t1103 * t1108);
        let t1129 = t358 - t437 * (t1099 * t1099) - t1106 * (t1111 * t1111);
        let t1130 = k7 / t1129;
        let t1131 = t437 * t1099;
        let t1134 = t1106 * t1111;
        let t1137 = t1130 * (t307 - t1100 * t1131 - t1114 * t1134);
        let t1142 = t1130 * (t233 - t1101 * t1131 - t1117 * t1134);
        let t1147 = t1130 * (t149 - t1102 * t1131 - t1120 * t1134);
        let t1152 = t1130 * (t59 - t1103 * t1131 - t1123 * t1134);
        let t1160 = t1129 * (t1137 * t1137);
        let t1161 = t288 - t437 * (t1100 * t1100) - t1106 * (t1114 * t1114) - t1160;
        let t1162 = k7 / t1161;
        let t1163 = t437 * t1100;
        let t1166 = t1106 * t1114;
        let t1169 = t1129 * t1137;
        let t1172 = t1162 * (t221 + t1101 * t1163 + t1117 * t1166 + t1142 * t1169);
        let t1179 = t1162 * (t133 + t1102 * t1163 + t1120 * t1166 + t1147 * t1169);
        let t1186 = t1162 * (t43 + t1103 * t1163 + t1123 * t1166 + t1152 * t1169);
        let t1194 = t1129 * (t1142 * t1142);
        let t1197 = t1161 * (t1172 * t1172);
        let t1198 = t202 - t437 * (t1101 * t1101) - t1106 * (t1117 * t1117) - t1194 - t1197;
        let t1199 = k7 / t1198;
        let t1200 = t437 * t1101;
        let t1203 = t1106 * t1117;
        let t1206 = t1129 * t1142;
        let t1209 = t1161 * t1172;
        let t1211 = t121 - t1102 * t1200 - t1120 * t1203 - t1147 * t1206 - t1179 * t1209;
        let t1212 = t1199 * t1211;
        let t1220 = t27 - t1103 * t1200 - t1123 * t1203 - t1152 * t1206 - t1186 * t1209;
        let t1221 = t1199 * t1220;
        let t1229 = t1129 * (t1147 * t1147);
        let t1232 = t1161 * (t1179 * t1179);
        let t1233 = t102 - t437 * (t1102 * t1102) - t1106 * (t1120 * t1120) - t1229 - t1232;
        let t1236 = t1233 - t1198 * (t1212 * t1212);
        let t1237 = k7 / t1236;
        let t1245 = t1152 * (t1129 * t1147);
        let t1248 = t1186 * (t1161 * t1179);
        let t1249 = t15 + t1103 * (t437 * t1102) + t1123 * (t1106 * t1120) + t1245 + t1248;
        let t1253 = t1237 * (t1249 + t1221 * (t1198 * t1212));
        let t1261 = t1129 * (t1152 * t1152);
        let t1264 = t1161 * (t1186 * t1186);
        let t1265 = ZZ7 - t437 * (t1103 * t1103) - t1106 * (t1123 * t1123) - t1261 - t1264;
        let t1272 = k7 / (t1265 - t1198 * (t1221 * t1221) - t1236 * (t1253 * t1253));
        [
        t1097, t1098, t1099, t1100, t1101, t1102, t1103, t1107,
        t1111, t1114, t1117, t1120, t1123, t1130, t1137, t1142,
        t1147, t1152, t1162, t1172, t1179, t1186, t1199, t1212,
        t1221, t1237, t1253, t1272,
    ]
    };
    // ddq
    {
        let t1274 = t1091 - t1090 * t1098;
        let t1278 = t1092 - t1090 * t1099 + t1111 * t1274;
        let t1284 = t1093 - t1090 * t1100 + t1114 * t1274 - t1137 * t1278;
        let t1292 = t1094 - t1090 * t1101 + t1117 * t1274 - t1142 * t1278 + t1172 * t1284;
        let t1300 = t1095 - t1090 * t1102 + t1120 * t1274 - t1147 * t1278 + t1179 * t1284;
        let t1302 = t1300 - t1212 * t1292;
        let t1310 = t1096 - t1090 * t1103 + t1123 * t1274 - t1152 * t1278 + t1186 * t1284;
        let t1321 = t1272 * (t1310 - t1221 * t1292 + t1253 * t1302);
        let t1323 = t1237 * t1302 + t1253 * t1321;
        let t1327 = t1199 * t1292 - t1212 * t1323 - t1221 * t1321;
        let t1333 = t1162 * t1284 + t1172 * t1327 + t1179 * t1323 + t1186 * t1321;
        let t1340 = t1152 * t1321;
        let t1341 = t1130 * t1278 - t1137 * t1333 - t1142 * t1327 - t1147 * t1323 - t1340;
        let t1348 = t1120 * t1323;
        let t1349 = t1107 * t1274 + t1111 * t1341 + t1114 * t1333 + t1117 * t1327 + t1348;
        let t1351 = t1349 + t1123 * t1321;
        let t1358 = t1101 * t1327;
        let t1359 = t1090 * t1097 - t1098 * t1351 - t1099 * t1341 - t1100 * t1333 - t1358;
        let t1363 = t1359 - t1102 * t1323 - t1103 * t1321;
        put(0, t1363);
        put(1, t1351);
        put(2, t1341);
        put(3, t1333);
        put(4, t1327);
        put(5, t1323);
        put(6, t1321);
    }
}
