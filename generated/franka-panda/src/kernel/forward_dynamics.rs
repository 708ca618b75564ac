//! Accelerations under given torques.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` in
//! closed form.
//!
//! 697 multiplications, 580 additions; 7, 7 of 7 structurally nonzero.

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
        ZZ1R, MSX2, MSY2R, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3R, MSY3R, XX3R, ZZ3R,
        XY3R, XZ3, YZ3, MSX4R, MSY4R, XX4R, ZZ4R, XY4R, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6R, MSY6R, XX6R, ZZ6R, XY6R, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7, FV1, FV2, FV3, FV4, FV5,
        FV6, FV7, FC1, FC2, FC3, FC4, FC5, FC6, FC7, FO1, FO2, FO3,
        FO4, FO5, FO6, FO7,
        ..] = *beta;
    let k0 = S::constant(0.088);
    let k4 = S::constant(-GRAVITY[2]);
    let k5 = S::constant(1.0);
    let k_A = S::constant(constants::A);
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
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
        let t38 = k_A * t27;
        let t39 = c5 * t18 + s5 * t11 + k_L3 * t27;
        let t40 = s5 * t18 - c5 * t11 + (k_L3 * t24 - k_A * t15);
        let t41 = t21 + t38;
        let t44 = c4 * t24 + s4 * t15;
        let t50 = c4 * t39 - s4 * t41;
        let t55 = s4 * t39 + c4 * t41 - t38;
        let t56 = k_A * (s4 * t24 - c4 * t15) - t40;
        let t71 = c3 * t50 + s3 * t56 - k_L2 * (s3 * t44 - c3 * t27);
        let t72 = s3 * t50 - c3 * t56 + k_L2 * (c3 * t44 + s3 * t27);
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
        let t130 = k_A * t119;
        let t131 = c5 * t114 + t121 + k_L3 * t119;
        let t132 = s5 * t114 - t124 + (k_A * t111 - k_L3 * t118);
        let t133 = t117 + t130;
        let t136 = c4 * t118 + s4 * t111;
        let t142 = c4 * t131 - s4 * t133;
        let t147 = s4 * t131 + c4 * t133 - t130;
        let t148 = k_A * (c4 * t111 - s4 * t118) - t132;
        let t163 = c3 * t142 + s3 * t148 + k_L2 * (s3 * t136 + c3 * t119);
        let t164 = s3 * t142 - c3 * t148 + k_L2 * (s3 * t119 - c3 * t136);
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
        let t207 = k_L3 * t200;
        let t209 = k_A * t200;
        let t210 = t203 - t207;
        let t211 = s5 * t193 + c5 * t194 - k_L3 * t197;
        let t212 = t191 - t209;
        let t213 = c4 * t197;
        let t217 = c4 * t210 - s4 * t212;
        let t222 = t209 + (s4 * t210 + c4 * t212);
        let t223 = t211 + k_A * (s4 * t197);
        let t238 = c3 * t217 - s3 * t223 - k_L2 * (c3 * t200 - s3 * t213);
        let t239 = s3 * t217 + c3 * t223 - k_L2 * (c3 * t213 + s3 * t200);
        let t242 = s2 * t238 - c2 * t222;
        let t244 = s5 * t192;
        let t247 = c5 * t192;
        let t248 = s5 * t190 + t247;
        let t250 = t124 + t244;
        let t263 = k_L3 * t187 - k_A * (t200 + t200);
        let t265 = t209 + t209;
        let t266 = c5 * (c5 * t190 - t244) - s5 * (t247 - t121) + t263 + t265;
        let t267 = k_A * t197;
        let t268 = c5 * t248 - s5 * t250 + t267;
        let t271 = t203 - (t207 - k_A * t108);
        let t272 = s5 * t248 + c5 * t250 + t263;
        let t274 = k_L3 * t108;
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
        let t296 = k_A * t289;
        let t297 = t280 + t296;
        let t309 = s3 * t292 - c3 * t297 - k_L2 * (c3 * t286);
        let t311 = c2 * t295;
        let t312 = s2 * (c3 * t292 + s3 * t297 + k_L2 * (s3 * t286)) - t311;
        let t314 = s4 * t281;
        let t317 = c4 * t281;
        let t318 = s4 * t279 + t317;
        let t322 = t314 + c4 * t276;
        let t333 = t286 + t286;
        let t334 = k_A * (t289 + t289);
        let t335 = c4 * (c4 * t279 - t314) - s4 * (t317 - s4 * t276) + t334;
        let t337 = t335 - (t296 + t296);
        let t339 = c4 * t318 - s4 * t322 - k_A * t286;
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
        let t364 = c3 * t348 - s3 * t349 - k_L2 * (c3 * t343 - s3 * t344);
        let t365 = s3 * t348 + c3 * t349 - k_L2 * (c3 * t344 + s3 * t343);
        let t368 = s2 * t364 - c2 * t346;
        let t370 = s3 * t347;
        let t373 = c3 * t347;
        let t374 = s3 * t345 + t373;
        let t378 = t370 + c3 * t342;
        let t384 = c3 * t374 - s3 * t378;
        let t388 = k_L2 * t333;
        let t389 = c3 * (c3 * t345 - t370) - s3 * (t373 - s3 * t342) + t388;
        let t390 = s3 * t374 + c3 * t378 + t388;
        let t392 = k_L2 * t286;
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
        t414, t415, t416, t417, t419, t420, dw2_y, t423,
        t424,
    ] = {
        let t414 = s2 * k4;
        let t415 = c2 * k4;
        let t416 = s2 * dq1;
        let t417 = c2 * dq1;
        let t419 = dq2 * dq2;
        let t420 = t416 * t417;
        let dw2_y = dq2 * t416;
        let t422 = dq2 * t417;
        let t423 = t416 * t416 + t419;
        let t424 = t422 + t422;
        [
        t414, t415, t416, t417, t419, t420, dw2_y, t423,
        t424,
    ]
    };
    // link 3: motion
    let [
        t429, a3_x, a3_y, w3_x, w3_y, t444, t447, w3_z,
        t451, t452, t453, dw3_x, dw3_y, t456, t457, t458,
        t459, t460, t461, t462,
    ] = {
        let t427 = k_L2 * t424;
        let t428 = t414 + k_L2 * t420;
        let t429 = k_L2 * t423 - t415;
        let a3_x = s3 * t427 - c3 * t428;
        let a3_y = c3 * t427 + s3 * t428;
        let w3_x = s3 * dq2 - c3 * t416;
        let w3_y = c3 * dq2 + s3 * t416;
        let t444 = s3 * t424 - c3 * t420;
        let t447 = c3 * t424 + s3 * t420;
        let w3_z = t417 + dq3;
        let t449 = w3_x * w3_x;
        let t450 = w3_z * w3_z;
        let t451 = w3_x * w3_y;
        let t452 = w3_x * w3_z;
        let t453 = w3_y * w3_z;
        let dw3_x = t453 - t447;
        let dw3_y = t444 - t452;
        let t456 = t449 - t450;
        let t457 = t456 - t423;
        let t458 = dw2_y + t451;
        let t459 = t451 - dw2_y;
        let t460 = t449 + t450;
        let t461 = t452 - dw3_y;
        let t462 = t453 + dw3_x;
        [
        t429, a3_x, a3_y, w3_x, w3_y, t444, t447, w3_z,
        t451, t452, t453, dw3_x, dw3_y, t456, t457, t458,
        t459, t460, t461, t462,
    ]
    };
    // link 4: motion
    let [
        t467, a4_x, a4_y, w4_x, w4_y, t483, t486, w4_z,
        t490, t491, t492, dw4_x, t494, t495, t496, t497,
        t498, t499, t500, t501,
    ] = {
        let t466 = a3_x + k_A * t457;
        let t467 = a3_y + k_A * t459;
        let t468 = k_A * t461 - t429;
        let a4_x = c4 * t466 + s4 * t468;
        let a4_y = c4 * t468 - s4 * t466;
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t483 = c4 * t458 + s4 * t462;
        let t486 = s4 * t458 - c4 * t462;
        let w4_z = dq4 - w3_y;
        let t488 = w4_x * w4_x;
        let t489 = w4_z * w4_z;
        let t490 = w4_x * w4_y;
        let t491 = w4_x * w4_z;
        let t492 = w4_y * w4_z;
        let dw4_x = t492 - t486;
        let t494 = t483 + t491;
        let t495 = t488 - t489;
        let t496 = t495 - t460;
        let t497 = dw3_y + t490;
        let t498 = t490 - dw3_y;
        let t499 = t488 + t489;
        let t500 = t491 + t494;
        let t501 = t492 + dw4_x;
        [
        t467, a4_x, a4_y, w4_x, w4_y, t483, t486, w4_z,
        t490, t491, t492, dw4_x, t494, t495, t496, t497,
        t498, t499, t500, t501,
    ]
    };
    // link 5: motion
    let [
        a5_z, a5_x, a6_z, w5_x, t525, t528, t531, w5_z,
        t535, t536, t537, dw5_x, dw5_y, t540, t541, t542,
        t543, t544, t545, t546,
    ] = {
        let t511 = a4_x + (k_L3 * t497 - k_A * t496);
        let a5_z = a4_y - (k_A * t498 + k_L3 * t499);
        let t513 = k_L3 * t501 - k_A * t500 - t467;
        let a5_x = c5 * t511 - s5 * t513;
        let a6_z = c5 * t513 + s5 * t511;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t525 = c5 * w4_z + s5 * w4_x;
        let t528 = c5 * t497 - s5 * t501;
        let t531 = c5 * t501 + s5 * t497;
        let w5_z = w4_y + dq5;
        let t533 = w5_x * w5_x;
        let t534 = w5_z * w5_z;
        let t535 = w5_x * t525;
        let t536 = w5_x * w5_z;
        let t537 = t525 * w5_z;
        let dw5_x = t531 - t537;
        let dw5_y = t528 - t536;
        let t540 = t533 - t534;
        let t541 = t540 - t499;
        let t542 = t494 - t535;
        let t543 = t494 + t535;
        let t544 = t533 + t534;
        let t545 = t536 - dw5_y;
        let t546 = dw5_x - t537;
        [
        a5_z, a5_x, a6_z, w5_x, t525, t528, t531, w5_z,
        t535, t536, t537, dw5_x, dw5_y, t540, t541, t542,
        t543, t544, t545, t546,
    ]
    };
    // link 6: motion
    let [
        a6_x, a6_y, w6_x, w6_y, t561, t564, w6_z, t568,
        t569, t570, dw6_x, dw7_z, t573, t574, t575, t576,
        t577, t578, t579,
    ] = {
        let a6_x = c6 * a5_x + s6 * a5_z;
        let a6_y = c6 * a5_z - s6 * a5_x;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t561 = c6 * t542 + s6 * t546;
        let t564 = s6 * t542 - c6 * t546;
        let w6_z = t525 + dq6;
        let t566 = w6_x * w6_x;
        let t567 = w6_z * w6_z;
        let t568 = w6_x * w6_y;
        let t569 = w6_x * w6_z;
        let t570 = w6_y * w6_z;
        let dw6_x = t570 - t564;
        let dw7_z = t561 + t569;
        let t573 = t566 - t567;
        let t574 = t573 - t544;
        let t575 = dw5_y + t568;
        let t576 = t568 - dw5_y;
        let t577 = t566 + t567;
        let t578 = t569 + dw7_z;
        let t579 = t570 + dw6_x;
        [
        a6_x, a6_y, w6_x, w6_y, t561, t564, w6_z, t568,
        t569, t570, dw6_x, dw7_z, t573, t574, t575, t576,
        t577, t578, t579,
    ]
    };
    // link 7: motion
    let [
        t584, a7_x, a7_y, t600, t603, t607, t608, t609,
        dw7_x, t612, t613, t614, t615, t616, t617, t618,
    ] = {
        let t583 = a6_x + k0 * t574;
        let t584 = a6_y + k0 * t576;
        let t585 = a6_z + k0 * t578;
        let a7_x = c7 * t583 + s7 * t585;
        let a7_y = c7 * t585 - s7 * t583;
        let w7_x = c7 * w6_x + s7 * w6_z;
        let w7_y = c7 * w6_z - s7 * w6_x;
        let t600 = c7 * t575 + s7 * t579;
        let t603 = s7 * t575 - c7 * t579;
        let w7_z = dq7 - w6_y;
        let t605 = w7_x * w7_x;
        let t606 = w7_z * w7_z;
        let t607 = w7_x * w7_y;
        let t608 = w7_x * w7_z;
        let t609 = w7_y * w7_z;
        let dw7_x = t609 - t603;
        let t612 = t605 - t606;
        let t613 = t612 - t577;
        let t614 = t607 - dw7_z;
        let t615 = dw7_z + t607;
        let t616 = t605 + t606;
        let t617 = t608 + (t600 + t608);
        let t618 = t609 + dw7_x;
        [
        t584, a7_x, a7_y, t600, t603, t607, t608, t609,
        dw7_x, t612, t613, t614, t615, t616, t617, t618,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t666, t669, t672, t678, t679] = {
        let t639 = ZZ7 * dw7_z - XX7R * t607 + XY7 * (t613 + t616) - XZ7 * t603;
        let t641 = YZ7 * (t577 - t616);
        let t644 = ZZ7 * t609 + XX7R * dw7_x - XY7 * t617 + XZ7 * t615 + t641;
        let t645 = t608 * (XX7R - ZZ7) + XY7 * t618 - XZ7 * t612 - YZ7 * t614;
        let f7_x = MSX7 * t613 + MSY7 * t614;
        let f7_y = MSX7 * t615 - MSY7 * t616;
        let f7_z = MSX7 * t617 + MSY7 * t618;
        let n7_x = t644 - MSY7 * t584;
        let n7_y = t645 + MSX7 * t584;
        let n7_z = t639 - YZ7 * t600 + (MSX7 * a7_y - MSY7 * a7_x);
        let t666 = c7 * f7_x - s7 * f7_y;
        let t669 = s7 * f7_x + c7 * f7_y;
        let t672 = c7 * n7_x - s7 * n7_y;
        let t678 = s7 * n7_x + c7 * n7_y - k0 * f7_z;
        let t679 = n7_z + k0 * t669;
        [f7_z, n7_z, t666, t669, t672, t678, t679]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t733, t736, t739, t742] = {
        let t700 = XY6R * (t574 + t577) - (XX6R * t568 + ZZ6R * dw5_y) - XZ6 * t564;
        let t702 = YZ6 * (t544 - t577);
        let t705 = ZZ6R * t570 + XX6R * dw6_x - XY6R * t578 + XZ6 * t576 + t702;
        let t706 = t569 * (XX6R - ZZ6R) + XY6R * t579 - XZ6 * t573 - YZ6 * t575;
        let f6_x = t666 + (MSX6R * t574 + MSY6R * t575);
        let f6_y = MSX6R * t576 - MSY6R * t577 - f7_z;
        let f6_z = t669 + (MSX6R * t578 + MSY6R * t579);
        let n6_x = t672 + (t705 + MSY6R * a6_z);
        let n6_y = t706 - MSX6R * a6_z - t679;
        let n6_z = t678 + (t700 - YZ6 * t561 + (MSX6R * a6_y - MSY6R * a6_x));
        let t733 = c6 * f6_x - s6 * f6_y;
        let t736 = s6 * f6_x + c6 * f6_y;
        let t739 = c6 * n6_x - s6 * n6_y;
        let t742 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t733, t736, t739, t742]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t796, t799, t811, t812, t813] = {
        let t763 = XX5R * t535 - ZZ5R * t494 + XY5 * (t541 + t544) + XZ5 * t531;
        let t765 = YZ5 * (t499 - t544);
        let t768 = XX5R * dw5_x - ZZ5R * t537 - XY5 * t545 - XZ5 * t543 + t765;
        let t769 = t536 * (XX5R - ZZ5R) + XY5 * t546 - XZ5 * t540 - YZ5 * t542;
        let f5_x = t733 + (MSX5 * t541 + MSY5R * t542);
        let t789 = f6_z + (MSX5 * t543 + MSY5R * t544);
        let f5_z = t736 + (MSX5 * t545 + MSY5R * t546);
        let n5_x = t739 + (t768 + MSY5R * a5_z);
        let n5_y = t769 - MSX5 * a5_z - n6_z;
        let n5_z = t742 + (t763 + YZ5 * t528 - (MSX5 * a6_z + MSY5R * a5_x));
        let t796 = c5 * f5_x + s5 * t789;
        let t799 = s5 * f5_x - c5 * t789;
        let t811 = c5 * n5_x - s5 * n5_y - k_L3 * t799;
        let t812 = s5 * n5_x + c5 * n5_y + (k_L3 * t796 + k_A * f5_z);
        let t813 = n5_z - k_A * t799;
        [f5_z, n5_z, t796, t799, t811, t812, t813]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t867, t873, t879, t880] = {
        let t834 = XY4R * (t496 + t499) - (XX4R * t490 + ZZ4R * dw3_y) - XZ4 * t486;
        let t836 = YZ4 * (t460 - t499);
        let t839 = ZZ4R * t492 + XX4R * dw4_x - XY4R * t500 + XZ4 * t498 + t836;
        let t840 = t491 * (XX4R - ZZ4R) + XY4R * t501 - XZ4 * t495 - YZ4 * t497;
        let f4_x = t796 + (MSX4R * t496 + MSY4R * t497);
        let f4_y = f5_z + (MSX4R * t498 - MSY4R * t499);
        let f4_z = MSX4R * t500 + MSY4R * t501 - t799;
        let n4_x = t811 + (t839 - MSY4R * t467);
        let n4_y = t813 + (t840 + MSX4R * t467);
        let n4_z = t834 - YZ4 * t483 + (MSX4R * a4_y - MSY4R * a4_x) - t812;
        let t867 = c4 * f4_x - s4 * f4_y;
        let t873 = c4 * n4_x - s4 * n4_y;
        let t879 = s4 * n4_x + c4 * n4_y - k_A * f4_z;
        let t880 = n4_z + k_A * (s4 * f4_x + c4 * f4_y);
        [f4_z, n4_z, t867, t873, t879, t880]
    };
    // link 3: force and moment
    let [n3_z, n2_x, t943] = {
        let t901 = XY3R * (t457 + t460) - (XX3R * t451 + ZZ3R * dw2_y) - XZ3 * t447;
        let t903 = YZ3 * (t423 - t460);
        let t906 = ZZ3R * t453 + XX3R * dw3_x - XY3R * t461 + XZ3 * t459 + t903;
        let t907 = t452 * (XX3R - ZZ3R) + XY3R * t462 - XZ3 * t456 - YZ3 * t458;
        let f3_x = t867 + (MSX3R * t457 + MSY3R * t458);
        let f3_y = MSX3R * t459 - MSY3R * t460 - f4_z;
        let n3_x = t873 + (t906 - MSY3R * t429);
        let n3_y = t907 + MSX3R * t429 - t880;
        let n3_z = t879 + (t901 + YZ3 * t444 + (MSX3R * a3_y - MSY3R * a3_x));
        let n2_x = c3 * n3_x - s3 * n3_y - k_L2 * (s3 * f3_x + c3 * f3_y);
        let t943 = s3 * n3_x + c3 * n3_y + k_L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, n2_x, t943]
    };
    // link 2: force and moment
    let [t957, n2_z, t966] = {
        let t949 = c2 * (s2 * XX2R + c2 * (XY2 + XY2)) - XY2;
        let t957 = (t949 + t949) * (dq1 * dq2) + t419 * (s2 * YZ2 - c2 * XZ2);
        let n2_z = t943 + (MSY2R * t414 - MSX2 * t415) - t413 * t949;
        let t966 = s2 * n2_x - c2 * n3_z;
        [t957, n2_z, t966]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t957 - t966;
        n1_z
    };
    // drives
    let [t1010, t1011, t1012, t1013, t1014, t1015, t1016] = {
        let t1010 = tau1 - (FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign()));
        let t1011 = tau2 - (FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign()));
        let t1012 = tau3 - (FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign()));
        let t1013 = tau4 - (FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign()));
        let t1014 = tau5 - (FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign()));
        let t1015 = tau6 - (FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign()));
        let t1016 = tau7 - (FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign()));
        [t1010, t1011, t1012, t1013, t1014, t1015, t1016]
    };
    // M = L D L'
    let [
        t1017, t1018, t1019, t1020, t1021, t1022, t1023, t1027,
        t1031, t1034, t1037, t1040, t1043, t1050, t1057, t1062,
        t1067, t1072, t1082, t1092, t1099, t1106, t1119, t1132,
        t1141, t1157, t1173, t1192,
    ] = {
        let t1017 = k5 / t412;
        let t1018 = t402 * t1017;
        let t1019 = t368 * t1017;
        let t1020 = t312 * t1017;
        let t1021 = t242 * t1017;
        let t1022 = t167 * t1017;
        let t1023 = t75 * t1017;
        let t1026 = t396 - t412 * (t1018 * t1018);
        let t1027 = k5 / t1026;
        let t1028 = t412 * t1018;
        let t1031 = t1027 * (t365 - t1019 * t1028);
        let t1034 = t1027 * (t309 - t1020 * t1028);
        let t1037 = t1027 * (t239 - t1021 * t1028);
        let t1040 = t1027 * (t164 - t1022 * t1028);
        let t1043 = t1027 * (t72 - t1023 * t1028);
        let t1049 = t346 - t412 * (t1019 * t1019) - t1026 * (t1031 * t1031);
        let t1050 = k5 / t1049;
        let t1051 = t412 * t1019;
        let t1054 = t1026 * t1031;
        let t1057 = t1050 * (t295 - t1020 * t1051 - t1034 * t1054);
        let t1062 = t1050 * (t222 - t1021 * t1051 - t1037 * t1054);
        let t1067 = t1050 * (t147 - t1022 * t1051 - t1040 * t1054);
        let t1072 = t1050 * (t55 - t1023 * t1051 - t1043 * t1054);
        let t1080 = t1049 * (t1057 * t1057);
        let t1081 = t280 - t412 * (t1020 * t1020) - t1026 * (t1034 * t1034) - t1080;
        let t1082 = k5 / t1081;
        let t1083 = t412 * t1020;
        let t1086 = t1026 * t1034;
        let t1089 = t1049 * t1057;
        let t1092 = t1082 * (t211 + t1021 * t1083 + t1037 * t1086 + t1062 * t1089);
        let t1099 = t1082 * (t132 + t1022 * t1083 + t1040 * t1086 + t1067 * t1089);
        let t1106 = t1082 * (t40 + t1023 * t1083 + t1043 * t1086 + t1072 * t1089);
        let t1114 = t1049 * (t1062 * t1062);
        let t1117 = t1081 * (t1092 * t1092);
        let t1118 = t191 - t412 * (t1021 * t1021) - t1026 * (t1037 * t1037) - t1114 - t1117;
        let t1119 = k5 / t1118;
        let t1120 = t412 * t1021;
        let t1123 = t1026 * t1037;
        let t1126 = t1049 * t1062;
        let t1129 = t1081 * t1092;
        let t1131 = t117 - t1022 * t1120 - t1040 * t1123 - t1067 * t1126 - t1099 * t1129;
        let t1132 = t1119 * t1131;
        let t1140 = t21 - t1023 * t1120 - t1043 * t1123 - t1072 * t1126 - t1106 * t1129;
        let t1141 = t1119 * t1140;
        let t1149 = t1049 * (t1067 * t1067);
        let t1152 = t1081 * (t1099 * t1099);
        let t1153 = t102 - t412 * (t1022 * t1022) - t1026 * (t1040 * t1040) - t1149 - t1152;
        let t1156 = t1153 - t1118 * (t1132 * t1132);
        let t1157 = k5 / t1156;
        let t1165 = t1072 * (t1049 * t1067);
        let t1168 = t1106 * (t1081 * t1099);
        let t1169 = t11 - t1023 * (t412 * t1022) - t1043 * (t1026 * t1040) - t1165 - t1168;
        let t1173 = t1157 * (t1169 - t1141 * (t1118 * t1132));
        let t1181 = t1049 * (t1072 * t1072);
        let t1184 = t1081 * (t1106 * t1106);
        let t1185 = ZZ7 - t412 * (t1023 * t1023) - t1026 * (t1043 * t1043) - t1181 - t1184;
        let t1192 = k5 / (t1185 - t1118 * (t1141 * t1141) - t1156 * (t1173 * t1173));
        [
        t1017, t1018, t1019, t1020, t1021, t1022, t1023, t1027,
        t1031, t1034, t1037, t1040, t1043, t1050, t1057, t1062,
        t1067, t1072, t1082, t1092, t1099, t1106, t1119, t1132,
        t1141, t1157, t1173, t1192,
    ]
    };
    // ddq
    {
        let t1194 = t1011 + t1010 * t1018;
        let t1198 = t1012 + t1010 * t1019 - t1031 * t1194;
        let t1204 = t1013 + t1010 * t1020 - t1034 * t1194 - t1057 * t1198;
        let t1212 = t1014 + t1010 * t1021 - t1037 * t1194 - t1062 * t1198 + t1092 * t1204;
        let t1220 = t1015 + t1010 * t1022 - t1040 * t1194 - t1067 * t1198 + t1099 * t1204;
        let t1222 = t1220 - t1132 * t1212;
        let t1230 = t1016 + t1010 * t1023 - t1043 * t1194 - t1072 * t1198 + t1106 * t1204;
        let t1241 = t1192 * (t1230 - t1141 * t1212 - t1173 * t1222);
        let t1243 = t1157 * t1222 - t1173 * t1241;
        let t1247 = t1119 * t1212 - t1132 * t1243 - t1141 * t1241;
        let t1253 = t1082 * t1204 + t1092 * t1247 + t1099 * t1243 + t1106 * t1241;
        let t1260 = t1072 * t1241;
        let t1261 = t1050 * t1198 - t1057 * t1253 - t1062 * t1247 - t1067 * t1243 - t1260;
        let t1268 = t1040 * t1243;
        let t1269 = t1027 * t1194 - t1031 * t1261 - t1034 * t1253 - t1037 * t1247 - t1268;
        let t1271 = t1269 - t1043 * t1241;
        let t1278 = t1021 * t1247;
        let t1279 = t1010 * t1017 + t1018 * t1271 + t1019 * t1261 + t1020 * t1253 + t1278;
        let t1283 = t1279 + t1022 * t1243 + t1023 * t1241;
        put(0, t1283);
        put(1, t1271);
        put(2, t1261);
        put(3, t1253);
        put(4, t1247);
        put(5, t1243);
        put(6, t1241);
    }
}
