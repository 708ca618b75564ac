//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 697 multiplications, 580 additions; 7, 7 of 7 structurally nonzero.

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
    let k0 = S::constant(9.81);
    let k1 = S::constant(0.088);
    let k5 = S::constant(1.0);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        t1, t2, t3, t4, t6, t7, dw2_y, t10,
        t11,
    ] = {
        let t1 = s2 * k0;
        let t2 = c2 * k0;
        let t3 = s2 * dq1;
        let t4 = c2 * dq1;
        let t6 = dq2 * dq2;
        let t7 = t3 * t4;
        let dw2_y = dq2 * t3;
        let t9 = dq2 * t4;
        let t10 = t3 * t3 + t6;
        let t11 = t9 + t9;
        [
        t1, t2, t3, t4, t6, t7, dw2_y, t10,
        t11,
    ]
    };
    // composite body 7
    let [
        t14, t17, t20, t23, t33, t52, t67, t84,
        t87, t107, t109, t110, t111,
    ] = {
        let t14 = c7 * MSY7 + s7 * MSX7;
        let t17 = c7 * MSX7 - s7 * MSY7;
        let t20 = c7 * XZ7 - s7 * YZ7;
        let t23 = s7 * XZ7 + c7 * YZ7;
        let t24 = k1 * t17;
        let t25 = ZZ7 + t24;
        let t26 = c6 * t14;
        let t27 = s6 * t14;
        let t30 = c6 * t20 + s6 * t25;
        let t33 = s6 * t20 - c6 * t25;
        let t36 = s5 * t17 - c5 * t26;
        let t39 = s5 * t26 + c5 * t17;
        let t50 = A * t39;
        let t51 = c5 * t30 + s5 * t23 + L3 * t39;
        let t52 = s5 * t30 - c5 * t23 + (L3 * t36 - A * t27);
        let t53 = t33 + t50;
        let t56 = c4 * t36 + s4 * t27;
        let t62 = c4 * t51 - s4 * t53;
        let t67 = s4 * t51 + c4 * t53 - t50;
        let t68 = A * (s4 * t36 - c4 * t27) - t52;
        let t83 = c3 * t62 + s3 * t68 - L2 * (s3 * t56 - c3 * t39);
        let t84 = s3 * t62 - c3 * t68 + L2 * (c3 * t56 + s3 * t39);
        let t87 = s2 * t83 - c2 * t67;
        let t89 = s7 * XY7;
        let t92 = c7 * XY7;
        let t93 = s7 * XX7R + t92;
        let t104 = k1 * (t17 + t17);
        let t107 = c7 * (c7 * XX7R - t89) - s7 * t92 + t104 - (t24 + t24);
        let t109 = c7 * t93 - s7 * t89 - k1 * t14;
        let t110 = s7 * t93 + c7 * t89 + t104;
        let t111 = ZZ7 + t104;
        [
        t14, t17, t20, t23, t33, t52, t67, t84,
        t87, t107, t109, t110, t111,
    ]
    };
    // composite body 6
    let [
        t114, t120, t123, t126, t129, t133, t136, t144,
        t159, t176, t179, t192, t195, t198, t199,
    ] = {
        let t112 = MSX6R + t17;
        let t113 = XX6R + t107;
        let t114 = ZZ6R + t110;
        let t115 = XY6R - t20;
        let t116 = XZ6 + t109;
        let t117 = YZ6 - t23;
        let t120 = c6 * MSY6R + s6 * t112;
        let t123 = c6 * t112 - s6 * MSY6R;
        let t126 = c6 * t116 - s6 * t117;
        let t129 = s6 * t116 + c6 * t117;
        let t130 = c5 * t120;
        let t131 = s5 * t120;
        let t133 = s5 * t114;
        let t136 = c5 * t114;
        let t142 = A * t131;
        let t143 = c5 * t126 + t133 + L3 * t131;
        let t144 = s5 * t126 - t136 + (A * t123 - L3 * t130);
        let t145 = t129 + t142;
        let t148 = c4 * t130 + s4 * t123;
        let t154 = c4 * t143 - s4 * t145;
        let t159 = s4 * t143 + c4 * t145 - t142;
        let t160 = A * (c4 * t123 - s4 * t130) - t144;
        let t175 = c3 * t154 + s3 * t160 + L2 * (s3 * t148 + c3 * t131);
        let t176 = s3 * t154 - c3 * t160 + L2 * (s3 * t131 - c3 * t148);
        let t179 = s2 * t175 - c2 * t159;
        let t181 = s6 * t115;
        let t184 = c6 * t115;
        let t185 = s6 * t113 + t184;
        let t189 = t181 + c6 * t111;
        let t192 = c6 * (c6 * t113 - t181) - s6 * (t184 - s6 * t111);
        let t195 = c6 * t185 - s6 * t189;
        let t198 = s6 * t185 + c6 * t189;
        let t199 = t120 + t120;
        [
        t114, t120, t123, t126, t129, t133, t136, t144,
        t159, t176, t179, t192, t195, t198, t199,
    ]
    };
    // composite body 5
    let [
        t203, t209, t212, t223, t234, t251, t254, t278,
        t279, t280, t283, t284, t288,
    ] = {
        let t200 = MSX5 + t123;
        let t201 = MSY5R - t14;
        let t202 = XX5R + t192;
        let t203 = ZZ5R + t198;
        let t204 = XY5 - t126;
        let t205 = XZ5 + t195;
        let t206 = YZ5 - t129;
        let t209 = c5 * t201 + s5 * t200;
        let t212 = c5 * t200 - s5 * t201;
        let t215 = c5 * t205 - s5 * t206;
        let t219 = L3 * t212;
        let t221 = A * t212;
        let t222 = t215 - t219;
        let t223 = s5 * t205 + c5 * t206 - L3 * t209;
        let t224 = t203 - t221;
        let t225 = c4 * t209;
        let t229 = c4 * t222 - s4 * t224;
        let t234 = t221 + (s4 * t222 + c4 * t224);
        let t235 = t223 + A * (s4 * t209);
        let t250 = c3 * t229 - s3 * t235 - L2 * (c3 * t212 - s3 * t225);
        let t251 = s3 * t229 + c3 * t235 - L2 * (c3 * t225 + s3 * t212);
        let t254 = s2 * t250 - c2 * t234;
        let t256 = s5 * t204;
        let t259 = c5 * t204;
        let t260 = s5 * t202 + t259;
        let t262 = t136 + t256;
        let t275 = L3 * t199 - A * (t212 + t212);
        let t277 = t221 + t221;
        let t278 = c5 * (c5 * t202 - t256) - s5 * (t259 - t133) + t275 + t277;
        let t279 = A * t209;
        let t280 = c5 * t260 - s5 * t262 + t279;
        let t283 = t215 - (t219 - A * t120);
        let t284 = s5 * t260 + c5 * t262 + t275;
        let t286 = L3 * t120;
        let t288 = t203 + t275 - (t286 + t286);
        [
        t203, t209, t212, t223, t234, t251, t254, t278,
        t279, t280, t283, t284, t288,
    ]
    };
    // composite body 4
    let [
        t292, t298, t301, t307, t321, t324, t345, t349,
        t351, t352, t353, t354,
    ] = {
        let t289 = MSX4R + t212;
        let t290 = MSY4R + t120;
        let t291 = XX4R + t278;
        let t292 = ZZ4R + t284;
        let t293 = XY4R + t283;
        let t294 = XZ4 - t280;
        let t295 = YZ4 - t223;
        let t298 = c4 * t290 + s4 * t289;
        let t301 = c4 * t289 - s4 * t290;
        let t304 = c4 * t294 - s4 * t295;
        let t307 = s4 * t294 + c4 * t295;
        let t308 = A * t301;
        let t309 = t292 + t308;
        let t321 = s3 * t304 - c3 * t309 - L2 * (c3 * t298);
        let t323 = c2 * t307;
        let t324 = s2 * (c3 * t304 + s3 * t309 + L2 * (s3 * t298)) - t323;
        let t326 = s4 * t293;
        let t329 = c4 * t293;
        let t330 = s4 * t291 + t329;
        let t334 = t326 + c4 * t288;
        let t345 = t298 + t298;
        let t346 = A * (t301 + t301);
        let t347 = c4 * (c4 * t291 - t326) - s4 * (t329 - s4 * t288) + t346;
        let t349 = t347 - (t308 + t308);
        let t351 = c4 * t330 - s4 * t334 - A * t298;
        let t352 = t279 + t304;
        let t353 = s4 * t330 + c4 * t334 + t346;
        let t354 = t292 + t346;
        [
        t292, t298, t301, t307, t321, t324, t345, t349,
        t351, t352, t353, t354,
    ]
    };
    // composite body 3
    let [t358, t376, t377, t380, t396, t401, t402, t406] = {
        let t355 = MSX3R + t301;
        let t356 = MSY3R + t209;
        let t357 = XX3R + t349;
        let t358 = ZZ3R + t353;
        let t359 = XY3R - t352;
        let t360 = XZ3 + t351;
        let t361 = YZ3 - t307;
        let t376 = c3 * t360 - s3 * t361 - L2 * (c3 * t355 - s3 * t356);
        let t377 = s3 * t360 + c3 * t361 - L2 * (c3 * t356 + s3 * t355);
        let t380 = s2 * t376 - c2 * t358;
        let t382 = s3 * t359;
        let t385 = c3 * t359;
        let t386 = s3 * t357 + t385;
        let t390 = t382 + c3 * t354;
        let t396 = c3 * t386 - s3 * t390;
        let t400 = L2 * t345;
        let t401 = c3 * (c3 * t357 - t382) - s3 * (t385 - s3 * t354) + t400;
        let t402 = s3 * t386 + c3 * t390 + t400;
        let t404 = L2 * t298;
        let t406 = t358 + t400 - (t404 + t404);
        [t358, t376, t377, t380, t396, t401, t402, t406]
    };
    // composite body 2
    let [t408, t414, t423] = {
        let t408 = ZZ2R + t402;
        let t409 = XY2 - t376;
        let t414 = s2 * (XZ2 + t396) + c2 * (YZ2 - t377);
        let t422 = c2 * (s2 * t409 + c2 * t406);
        let t423 = s2 * (s2 * (XX2R + t401) + c2 * t409) + t422;
        [t408, t414, t423]
    };
    // composite body 1
    let t424 = {
        let t424 = ZZ1R + t423;
        t424
    };
    // M = L D L'
    let [
        t425, t426, t427, t428, t429, t430, t431, t435,
        t439, t442, t445, t448, t451, t458, t465, t470,
        t475, t480, t490, t500, t507, t514, t527, t540,
        t549, t565, t581, t600,
    ] = {
        let t425 = k5 / t424;
        let t426 = t414 * t425;
        let t427 = t380 * t425;
        let t428 = t324 * t425;
        let t429 = t254 * t425;
        let t430 = t179 * t425;
        let t431 = t87 * t425;
        let t434 = t408 - t424 * (t426 * t426);
        let t435 = k5 / t434;
        let t436 = t424 * t426;
        let t439 = t435 * (t377 - t427 * t436);
        let t442 = t435 * (t321 - t428 * t436);
        let t445 = t435 * (t251 - t429 * t436);
        let t448 = t435 * (t176 - t430 * t436);
        let t451 = t435 * (t84 - t431 * t436);
        let t457 = t358 - t424 * (t427 * t427) - t434 * (t439 * t439);
        let t458 = k5 / t457;
        let t459 = t424 * t427;
        let t462 = t434 * t439;
        let t465 = t458 * (t307 - t428 * t459 - t442 * t462);
        let t470 = t458 * (t234 - t429 * t459 - t445 * t462);
        let t475 = t458 * (t159 - t430 * t459 - t448 * t462);
        let t480 = t458 * (t67 - t431 * t459 - t451 * t462);
        let t488 = t457 * (t465 * t465);
        let t489 = t292 - t424 * (t428 * t428) - t434 * (t442 * t442) - t488;
        let t490 = k5 / t489;
        let t491 = t424 * t428;
        let t494 = t434 * t442;
        let t497 = t457 * t465;
        let t500 = t490 * (t223 + t429 * t491 + t445 * t494 + t470 * t497);
        let t507 = t490 * (t144 + t430 * t491 + t448 * t494 + t475 * t497);
        let t514 = t490 * (t52 + t431 * t491 + t451 * t494 + t480 * t497);
        let t522 = t457 * (t470 * t470);
        let t525 = t489 * (t500 * t500);
        let t526 = t203 - t424 * (t429 * t429) - t434 * (t445 * t445) - t522 - t525;
        let t527 = k5 / t526;
        let t528 = t424 * t429;
        let t531 = t434 * t445;
        let t534 = t457 * t470;
        let t537 = t489 * t500;
        let t539 = t129 - t430 * t528 - t448 * t531 - t475 * t534 - t507 * t537;
        let t540 = t527 * t539;
        let t548 = t33 - t431 * t528 - t451 * t531 - t480 * t534 - t514 * t537;
        let t549 = t527 * t548;
        let t557 = t457 * (t475 * t475);
        let t560 = t489 * (t507 * t507);
        let t561 = t114 - t424 * (t430 * t430) - t434 * (t448 * t448) - t557 - t560;
        let t564 = t561 - t526 * (t540 * t540);
        let t565 = k5 / t564;
        let t573 = t480 * (t457 * t475);
        let t576 = t514 * (t489 * t507);
        let t577 = t23 - t431 * (t424 * t430) - t451 * (t434 * t448) - t573 - t576;
        let t581 = t565 * (t577 - t549 * (t526 * t540));
        let t589 = t457 * (t480 * t480);
        let t592 = t489 * (t514 * t514);
        let t593 = ZZ7 - t424 * (t431 * t431) - t434 * (t451 * t451) - t589 - t592;
        let t600 = k5 / (t593 - t526 * (t549 * t549) - t564 * (t581 * t581));
        [
        t425, t426, t427, t428, t429, t430, t431, t435,
        t439, t442, t445, t448, t451, t458, t465, t470,
        t475, t480, t490, t500, t507, t514, t527, t540,
        t549, t565, t581, t600,
    ]
    };
    // link 3: motion
    let [
        t605, a3_x, a3_y, w3_x, w3_y, t620, t623, w3_z,
        t627, t628, t629, dw3_x, dw3_y, t632, t633, t634,
        t635, t636, t637, t638,
    ] = {
        let t603 = L2 * t11;
        let t604 = t1 + L2 * t7;
        let t605 = L2 * t10 - t2;
        let a3_x = s3 * t603 - c3 * t604;
        let a3_y = c3 * t603 + s3 * t604;
        let w3_x = s3 * dq2 - c3 * t3;
        let w3_y = c3 * dq2 + s3 * t3;
        let t620 = s3 * t11 - c3 * t7;
        let t623 = c3 * t11 + s3 * t7;
        let w3_z = t4 + dq3;
        let t625 = w3_x * w3_x;
        let t626 = w3_z * w3_z;
        let t627 = w3_x * w3_y;
        let t628 = w3_x * w3_z;
        let t629 = w3_y * w3_z;
        let dw3_x = t629 - t623;
        let dw3_y = t620 - t628;
        let t632 = t625 - t626;
        let t633 = t632 - t10;
        let t634 = dw2_y + t627;
        let t635 = t627 - dw2_y;
        let t636 = t625 + t626;
        let t637 = t628 - dw3_y;
        let t638 = t629 + dw3_x;
        [
        t605, a3_x, a3_y, w3_x, w3_y, t620, t623, w3_z,
        t627, t628, t629, dw3_x, dw3_y, t632, t633, t634,
        t635, t636, t637, t638,
    ]
    };
    // link 4: motion
    let [
        t643, a4_x, a4_y, w4_x, w4_y, t659, t662, w4_z,
        t666, t667, t668, dw4_x, t670, t671, t672, t673,
        t674, t675, t676, t677,
    ] = {
        let t642 = a3_x + A * t633;
        let t643 = a3_y + A * t635;
        let t644 = A * t637 - t605;
        let a4_x = c4 * t642 + s4 * t644;
        let a4_y = c4 * t644 - s4 * t642;
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t659 = c4 * t634 + s4 * t638;
        let t662 = s4 * t634 - c4 * t638;
        let w4_z = dq4 - w3_y;
        let t664 = w4_x * w4_x;
        let t665 = w4_z * w4_z;
        let t666 = w4_x * w4_y;
        let t667 = w4_x * w4_z;
        let t668 = w4_y * w4_z;
        let dw4_x = t668 - t662;
        let t670 = t659 + t667;
        let t671 = t664 - t665;
        let t672 = t671 - t636;
        let t673 = dw3_y + t666;
        let t674 = t666 - dw3_y;
        let t675 = t664 + t665;
        let t676 = t667 + t670;
        let t677 = t668 + dw4_x;
        [
        t643, a4_x, a4_y, w4_x, w4_y, t659, t662, w4_z,
        t666, t667, t668, dw4_x, t670, t671, t672, t673,
        t674, t675, t676, t677,
    ]
    };
    // link 5: motion
    let [
        a5_z, a5_x, a6_z, w5_x, t701, t704, t707, w5_z,
        t711, t712, t713, dw5_x, dw5_y, t716, t717, t718,
        t719, t720, t721, t722,
    ] = {
        let t687 = a4_x + (L3 * t673 - A * t672);
        let a5_z = a4_y - (A * t674 + L3 * t675);
        let t689 = L3 * t677 - A * t676 - t643;
        let a5_x = c5 * t687 - s5 * t689;
        let a6_z = c5 * t689 + s5 * t687;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t701 = c5 * w4_z + s5 * w4_x;
        let t704 = c5 * t673 - s5 * t677;
        let t707 = c5 * t677 + s5 * t673;
        let w5_z = w4_y + dq5;
        let t709 = w5_x * w5_x;
        let t710 = w5_z * w5_z;
        let t711 = w5_x * t701;
        let t712 = w5_x * w5_z;
        let t713 = t701 * w5_z;
        let dw5_x = t707 - t713;
        let dw5_y = t704 - t712;
        let t716 = t709 - t710;
        let t717 = t716 - t675;
        let t718 = t670 - t711;
        let t719 = t670 + t711;
        let t720 = t709 + t710;
        let t721 = t712 - dw5_y;
        let t722 = dw5_x - t713;
        [
        a5_z, a5_x, a6_z, w5_x, t701, t704, t707, w5_z,
        t711, t712, t713, dw5_x, dw5_y, t716, t717, t718,
        t719, t720, t721, t722,
    ]
    };
    // link 6: motion
    let [
        a6_x, a6_y, w6_x, w6_y, t737, t740, w6_z, t744,
        t745, t746, dw6_x, dw7_z, t749, t750, t751, t752,
        t753, t754, t755,
    ] = {
        let a6_x = c6 * a5_x + s6 * a5_z;
        let a6_y = c6 * a5_z - s6 * a5_x;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t737 = c6 * t718 + s6 * t722;
        let t740 = s6 * t718 - c6 * t722;
        let w6_z = t701 + dq6;
        let t742 = w6_x * w6_x;
        let t743 = w6_z * w6_z;
        let t744 = w6_x * w6_y;
        let t745 = w6_x * w6_z;
        let t746 = w6_y * w6_z;
        let dw6_x = t746 - t740;
        let dw7_z = t737 + t745;
        let t749 = t742 - t743;
        let t750 = t749 - t720;
        let t751 = dw5_y + t744;
        let t752 = t744 - dw5_y;
        let t753 = t742 + t743;
        let t754 = t745 + dw7_z;
        let t755 = t746 + dw6_x;
        [
        a6_x, a6_y, w6_x, w6_y, t737, t740, w6_z, t744,
        t745, t746, dw6_x, dw7_z, t749, t750, t751, t752,
        t753, t754, t755,
    ]
    };
    // link 7: motion
    let [
        t760, a7_x, a7_y, t776, t779, t783, t784, t785,
        dw7_x, t788, t789, t790, t791, t792, t793, t794,
    ] = {
        let t759 = a6_x + k1 * t750;
        let t760 = a6_y + k1 * t752;
        let t761 = a6_z + k1 * t754;
        let a7_x = c7 * t759 + s7 * t761;
        let a7_y = c7 * t761 - s7 * t759;
        let w7_x = c7 * w6_x + s7 * w6_z;
        let w7_y = c7 * w6_z - s7 * w6_x;
        let t776 = c7 * t751 + s7 * t755;
        let t779 = s7 * t751 - c7 * t755;
        let w7_z = dq7 - w6_y;
        let t781 = w7_x * w7_x;
        let t782 = w7_z * w7_z;
        let t783 = w7_x * w7_y;
        let t784 = w7_x * w7_z;
        let t785 = w7_y * w7_z;
        let dw7_x = t785 - t779;
        let t788 = t781 - t782;
        let t789 = t788 - t753;
        let t790 = t783 - dw7_z;
        let t791 = dw7_z + t783;
        let t792 = t781 + t782;
        let t793 = t784 + (t776 + t784);
        let t794 = t785 + dw7_x;
        [
        t760, a7_x, a7_y, t776, t779, t783, t784, t785,
        dw7_x, t788, t789, t790, t791, t792, t793, t794,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t842, t845, t848, t854, t855] = {
        let t815 = ZZ7 * dw7_z - XX7R * t783 + XY7 * (t789 + t792) - XZ7 * t779;
        let t817 = YZ7 * (t753 - t792);
        let t820 = ZZ7 * t785 + XX7R * dw7_x - XY7 * t793 + XZ7 * t791 + t817;
        let t821 = t784 * (XX7R - ZZ7) + XY7 * t794 - XZ7 * t788 - YZ7 * t790;
        let f7_x = MSX7 * t789 + MSY7 * t790;
        let f7_y = MSX7 * t791 - MSY7 * t792;
        let f7_z = MSX7 * t793 + MSY7 * t794;
        let n7_x = t820 - MSY7 * t760;
        let n7_y = t821 + MSX7 * t760;
        let n7_z = t815 - YZ7 * t776 + (MSX7 * a7_y - MSY7 * a7_x);
        let t842 = c7 * f7_x - s7 * f7_y;
        let t845 = s7 * f7_x + c7 * f7_y;
        let t848 = c7 * n7_x - s7 * n7_y;
        let t854 = s7 * n7_x + c7 * n7_y - k1 * f7_z;
        let t855 = n7_z + k1 * t845;
        [f7_z, n7_z, t842, t845, t848, t854, t855]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t909, t912, t915, t918] = {
        let t876 = XY6R * (t750 + t753) - (XX6R * t744 + ZZ6R * dw5_y) - XZ6 * t740;
        let t878 = YZ6 * (t720 - t753);
        let t881 = ZZ6R * t746 + XX6R * dw6_x - XY6R * t754 + XZ6 * t752 + t878;
        let t882 = t745 * (XX6R - ZZ6R) + XY6R * t755 - XZ6 * t749 - YZ6 * t751;
        let f6_x = t842 + (MSX6R * t750 + MSY6R * t751);
        let f6_y = MSX6R * t752 - MSY6R * t753 - f7_z;
        let f6_z = t845 + (MSX6R * t754 + MSY6R * t755);
        let n6_x = t848 + (t881 + MSY6R * a6_z);
        let n6_y = t882 - MSX6R * a6_z - t855;
        let n6_z = t854 + (t876 - YZ6 * t737 + (MSX6R * a6_y - MSY6R * a6_x));
        let t909 = c6 * f6_x - s6 * f6_y;
        let t912 = s6 * f6_x + c6 * f6_y;
        let t915 = c6 * n6_x - s6 * n6_y;
        let t918 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t909, t912, t915, t918]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t972, t975, t987, t988, t989] = {
        let t939 = XX5R * t711 - ZZ5R * t670 + XY5 * (t717 + t720) + XZ5 * t707;
        let t941 = YZ5 * (t675 - t720);
        let t944 = XX5R * dw5_x - ZZ5R * t713 - XY5 * t721 - XZ5 * t719 + t941;
        let t945 = t712 * (XX5R - ZZ5R) + XY5 * t722 - XZ5 * t716 - YZ5 * t718;
        let f5_x = t909 + (MSX5 * t717 + MSY5R * t718);
        let t965 = f6_z + (MSX5 * t719 + MSY5R * t720);
        let f5_z = t912 + (MSX5 * t721 + MSY5R * t722);
        let n5_x = t915 + (t944 + MSY5R * a5_z);
        let n5_y = t945 - MSX5 * a5_z - n6_z;
        let n5_z = t918 + (t939 + YZ5 * t704 - (MSX5 * a6_z + MSY5R * a5_x));
        let t972 = c5 * f5_x + s5 * t965;
        let t975 = s5 * f5_x - c5 * t965;
        let t987 = c5 * n5_x - s5 * n5_y - L3 * t975;
        let t988 = s5 * n5_x + c5 * n5_y + (L3 * t972 + A * f5_z);
        let t989 = n5_z - A * t975;
        [f5_z, n5_z, t972, t975, t987, t988, t989]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t1043, t1049, t1055, t1056] = {
        let t1010 = XY4R * (t672 + t675) - (XX4R * t666 + ZZ4R * dw3_y) - XZ4 * t662;
        let t1012 = YZ4 * (t636 - t675);
        let t1015 = ZZ4R * t668 + XX4R * dw4_x - XY4R * t676 + XZ4 * t674 + t1012;
        let t1016 = t667 * (XX4R - ZZ4R) + XY4R * t677 - XZ4 * t671 - YZ4 * t673;
        let f4_x = t972 + (MSX4R * t672 + MSY4R * t673);
        let f4_y = f5_z + (MSX4R * t674 - MSY4R * t675);
        let f4_z = MSX4R * t676 + MSY4R * t677 - t975;
        let n4_x = t987 + (t1015 - MSY4R * t643);
        let n4_y = t989 + (t1016 + MSX4R * t643);
        let n4_z = t1010 - YZ4 * t659 + (MSX4R * a4_y - MSY4R * a4_x) - t988;
        let t1043 = c4 * f4_x - s4 * f4_y;
        let t1049 = c4 * n4_x - s4 * n4_y;
        let t1055 = s4 * n4_x + c4 * n4_y - A * f4_z;
        let t1056 = n4_z + A * (s4 * f4_x + c4 * f4_y);
        [f4_z, n4_z, t1043, t1049, t1055, t1056]
    };
    // link 3: force and moment
    let [n3_z, n2_x, t1119] = {
        let t1077 = XY3R * (t633 + t636) - (XX3R * t627 + ZZ3R * dw2_y) - XZ3 * t623;
        let t1079 = YZ3 * (t10 - t636);
        let t1082 = ZZ3R * t629 + XX3R * dw3_x - XY3R * t637 + XZ3 * t635 + t1079;
        let t1083 = t628 * (XX3R - ZZ3R) + XY3R * t638 - XZ3 * t632 - YZ3 * t634;
        let f3_x = t1043 + (MSX3R * t633 + MSY3R * t634);
        let f3_y = MSX3R * t635 - MSY3R * t636 - f4_z;
        let n3_x = t1049 + (t1082 - MSY3R * t605);
        let n3_y = t1083 + MSX3R * t605 - t1056;
        let n3_z = t1055 + (t1077 + YZ3 * t620 + (MSX3R * a3_y - MSY3R * a3_x));
        let n2_x = c3 * n3_x - s3 * n3_y - L2 * (s3 * f3_x + c3 * f3_y);
        let t1119 = s3 * n3_x + c3 * n3_y + L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, n2_x, t1119]
    };
    // link 2: force and moment
    let [t1133, n2_z, t1142] = {
        let t1125 = c2 * (s2 * XX2R + c2 * (XY2 + XY2)) - XY2;
        let t1133 = (t1125 + t1125) * (dq1 * dq2) + t6 * (s2 * YZ2 - c2 * XZ2);
        let n2_z = t1119 + (MSY2R * t1 - MSX2 * t2) - t0 * t1125;
        let t1142 = s2 * n2_x - c2 * n3_z;
        [t1133, n2_z, t1142]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t1133 - t1142;
        n1_z
    };
    // drives
    let [t1186, t1187, t1188, t1189, t1190, t1191, t1192] = {
        let t1186 = tau1 - (FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign()));
        let t1187 = tau2 - (FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign()));
        let t1188 = tau3 - (FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign()));
        let t1189 = tau4 - (FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign()));
        let t1190 = tau5 - (FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign()));
        let t1191 = tau6 - (FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign()));
        let t1192 = tau7 - (FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign()));
        [t1186, t1187, t1188, t1189, t1190, t1191, t1192]
    };
    // ddq
    {
        let t1194 = t1187 + t1186 * t426;
        let t1198 = t1188 + t1186 * t427 - t439 * t1194;
        let t1204 = t1189 + t1186 * t428 - t442 * t1194 - t465 * t1198;
        let t1212 = t1190 + t1186 * t429 - t445 * t1194 - t470 * t1198 + t500 * t1204;
        let t1220 = t1191 + t1186 * t430 - t448 * t1194 - t475 * t1198 + t507 * t1204;
        let t1222 = t1220 - t540 * t1212;
        let t1230 = t1192 + t1186 * t431 - t451 * t1194 - t480 * t1198 + t514 * t1204;
        let t1241 = t600 * (t1230 - t549 * t1212 - t581 * t1222);
        let t1243 = t565 * t1222 - t581 * t1241;
        let t1247 = t527 * t1212 - t540 * t1243 - t549 * t1241;
        let t1253 = t490 * t1204 + t500 * t1247 + t507 * t1243 + t514 * t1241;
        let t1260 = t480 * t1241;
        let t1261 = t458 * t1198 - t465 * t1253 - t470 * t1247 - t475 * t1243 - t1260;
        let t1268 = t448 * t1243;
        let t1269 = t435 * t1194 - t439 * t1261 - t442 * t1253 - t445 * t1247 - t1268;
        let t1271 = t1269 - t451 * t1241;
        let t1278 = t429 * t1247;
        let t1279 = t1186 * t425 + t426 * t1271 + t427 * t1261 + t428 * t1253 + t1278;
        let t1283 = t1279 + t430 * t1243 + t431 * t1241;
        put(0, t1283);
        put(1, t1271);
        put(2, t1261);
        put(3, t1253);
        put(4, t1247);
        put(5, t1243);
        put(6, t1241);
    }
}
