//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 725 multiplications, 596 additions; 7, 7 of 7 structurally nonzero.

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
    let k0 = S::constant(9.81);
    let k1 = S::constant(0.01175);
    let k2 = S::constant(0.167455);
    let k3 = S::constant(0.00035);
    let k4 = S::constant(0.31436);
    let k5 = S::constant(0.01275);
    let k6 = S::constant(0.42076);
    let k7 = S::constant(1.0);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        t1, t2, a2_z, w2_x, w2_y, t7, t8, t9,
        t12, t13, t14,
    ] = {
        let t1 = s2 * k0;
        let t2 = c2 * k0;
        let a2_z = k1 * t0;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t6 = w2_x * w2_x;
        let t7 = dq2 * dq2;
        let t8 = w2_x * w2_y;
        let t9 = dq2 * w2_x;
        let dw2_x = dq2 * w2_y;
        let t12 = t6 - t7 - t0;
        let t13 = t6 + t7;
        let t14 = dw2_x + dw2_x;
        [
        t1, t2, a2_z, w2_x, w2_y, t7, t8, t9,
        t12, t13, t14,
    ]
    };
    // composite body 7
    let [
        t17, t20, t29, t30, t34, t37, t42, t58,
        t74, t90, t98, t107, t110, t113, t114,
    ] = {
        let t17 = c7 * MSY7 + s7 * MSX7;
        let t20 = c7 * MSX7 - s7 * MSY7;
        let t29 = c7 * XZ7 - s7 * YZ7 + t20 * k2;
        let t30 = s7 * XZ7 + c7 * YZ7 + t17 * k2;
        let t31 = c6 * t17;
        let t32 = s6 * t17;
        let t34 = s6 * ZZ7;
        let t37 = c6 * ZZ7;
        let t41 = c6 * t29 - t34 - t32 * k3;
        let t42 = s6 * t29 + t37 + t31 * k3;
        let t45 = c5 * t31 + s5 * t20;
        let t48 = c5 * t20 - s5 * t31;
        let t57 = c5 * t41 - s5 * t30 + t48 * k4;
        let t58 = s5 * t41 + c5 * t30 + t45 * k4;
        let t61 = s4 * t32 - c4 * t45;
        let t64 = s4 * t45 + c4 * t32;
        let t73 = c4 * t57 - s4 * t42 - t64 * k5;
        let t74 = s4 * t57 + c4 * t42 - t61 * k5;
        let t77 = c3 * t61 - s3 * t48;
        let t89 = c3 * t73 - s3 * t58 + (s3 * t61 + c3 * t48) * k6;
        let t90 = s3 * t73 + c3 * t58 - t77 * k6;
        let t98 = s2 * t89 + c2 * t74 - (c2 * t77 + s2 * t64) * k1;
        let t100 = s7 * XY7;
        let t103 = c7 * XY7;
        let t104 = s7 * XX7R + t103;
        let t107 = c7 * (c7 * XX7R - t100) - s7 * t103;
        let t110 = c7 * t104 - s7 * t100;
        let t113 = s7 * t104 + c7 * t100;
        let t114 = t17 + t17;
        [
        t17, t20, t29, t30, t34, t37, t42, t58,
        t74, t90, t98, t107, t110, t113, t114,
    ]
    };
    // composite body 6
    let [
        t117, t123, t126, t135, t136, t148, t164, t180,
        t188, t202, t206, t208, t209, t213,
    ] = {
        let t115 = MSX6 + t20;
        let t116 = XX6R + t107;
        let t117 = ZZ6R + t113;
        let t118 = XY6 + t29;
        let t119 = XZ6 - t110;
        let t120 = YZ6 - t30;
        let t123 = c6 * MSY6R + s6 * t115;
        let t126 = c6 * t115 - s6 * MSY6R;
        let t135 = c6 * t119 - s6 * t120 + k3 * t126;
        let t136 = s6 * t119 + c6 * t120 + k3 * t123;
        let t137 = c5 * t123;
        let t138 = s5 * t123;
        let t147 = c5 * t135 + s5 * t117 - k4 * t138;
        let t148 = s5 * t135 - c5 * t117 + k4 * t137;
        let t151 = c4 * t137 + s4 * t126;
        let t154 = c4 * t126 - s4 * t137;
        let t163 = c4 * t147 - s4 * t136 + k5 * t154;
        let t164 = s4 * t147 + c4 * t136 + k5 * t151;
        let t167 = s3 * t138 - c3 * t151;
        let t179 = c3 * t163 - s3 * t148 - k6 * (s3 * t151 + c3 * t138);
        let t180 = s3 * t163 + c3 * t148 - k6 * t167;
        let t188 = s2 * t179 + c2 * t164 - k1 * (c2 * t167 - s2 * t154);
        let t190 = s6 * t118;
        let t193 = c6 * t118;
        let t194 = s6 * t116 + t193;
        let t196 = t37 + t190;
        let t202 = c6 * t194 - s6 * t196;
        let t206 = t123 + t123;
        let t207 = k3 * t114;
        let t208 = c6 * (c6 * t116 - t190) - s6 * (t193 - t34) + t207;
        let t209 = s6 * t194 + c6 * t196 + t207;
        let t211 = t17 * k3;
        let t213 = t117 + t207 - (t211 + t211);
        [
        t117, t123, t126, t135, t136, t148, t164, t180,
        t188, t202, t206, t208, t209, t213,
    ]
    };
    // composite body 5
    let [
        t217, t223, t226, t235, t236, t248, t264, t272,
        t288, t292, t294, t295, t299,
    ] = {
        let t214 = MSX5 + t126;
        let t215 = MSY5R + t17;
        let t216 = XX5R + t208;
        let t217 = ZZ5R + t209;
        let t218 = XY5 - t135;
        let t219 = XZ5 + t202;
        let t220 = YZ5 - t136;
        let t223 = c5 * t215 + s5 * t214;
        let t226 = c5 * t214 - s5 * t215;
        let t235 = c5 * t219 - s5 * t220 + k4 * t226;
        let t236 = s5 * t219 + c5 * t220 + k4 * t223;
        let t237 = c4 * t223;
        let t238 = s4 * t223;
        let t247 = c4 * t235 - s4 * t217 - k5 * t238;
        let t248 = s4 * t235 + c4 * t217 + k5 * t237;
        let t251 = c3 * t237 + s3 * t226;
        let t263 = c3 * t247 - s3 * t236 + k6 * (c3 * t226 - s3 * t237);
        let t264 = s3 * t247 + c3 * t236 + k6 * t251;
        let t272 = s2 * t263 + c2 * t248 - k1 * (s2 * t238 - c2 * t251);
        let t274 = s5 * t218;
        let t277 = c5 * t218;
        let t278 = s5 * t216 + t277;
        let t282 = t274 + c5 * t213;
        let t288 = c5 * t278 - s5 * t282;
        let t292 = t223 + t223;
        let t293 = k4 * t206;
        let t294 = c5 * (c5 * t216 - t274) - s5 * (t277 - s5 * t213) - t293;
        let t295 = s5 * t278 + c5 * t282 - t293;
        let t297 = k4 * t123;
        let t299 = t217 - t293 + (t297 + t297);
        [
        t217, t223, t226, t235, t236, t248, t264, t272,
        t288, t292, t294, t295, t299,
    ]
    };
    // composite body 4
    let [
        t303, t309, t312, t321, t322, t334, t342, t358,
        t362, t364, t365, t369,
    ] = {
        let t300 = MSX4 + t226;
        let t301 = MSY4R + t123;
        let t302 = XX4R + t294;
        let t303 = ZZ4R + t295;
        let t304 = XY4 + t235;
        let t305 = XZ4 - t288;
        let t306 = YZ4 - t236;
        let t309 = c4 * t301 + s4 * t300;
        let t312 = c4 * t300 - s4 * t301;
        let t321 = c4 * t305 - s4 * t306 + k5 * t312;
        let t322 = s4 * t305 + c4 * t306 + k5 * t309;
        let t323 = c3 * t309;
        let t334 = s3 * t321 - c3 * t303 + k6 * t323;
        let t339 = c2 * t322;
        let t340 = s2 * (c3 * t321 + s3 * t303 - k6 * (s3 * t309)) + t339;
        let t342 = t340 + k1 * (c2 * t323 + s2 * t312);
        let t344 = s4 * t304;
        let t347 = c4 * t304;
        let t348 = s4 * t302 + t347;
        let t352 = t344 + c4 * t299;
        let t358 = c4 * t348 - s4 * t352;
        let t362 = t309 + t309;
        let t363 = k5 * t292;
        let t364 = c4 * (c4 * t302 - t344) - s4 * (t347 - s4 * t299) + t363;
        let t365 = s4 * t348 + c4 * t352 + t363;
        let t367 = k5 * t223;
        let t369 = t303 + t363 - (t367 + t367);
        [
        t303, t309, t312, t321, t322, t334, t342, t358,
        t362, t364, t365, t369,
    ]
    };
    // composite body 3
    let [
        t373, t382, t391, t392, t398, t414, t418, t420,
        t421, t425,
    ] = {
        let t370 = MSX3 + t312;
        let t371 = MSY3R + t223;
        let t372 = XX3R + t364;
        let t373 = ZZ3R + t365;
        let t374 = XY3 - t321;
        let t375 = XZ3 + t358;
        let t376 = YZ3 - t322;
        let t379 = c3 * t371 + s3 * t370;
        let t382 = c3 * t370 - s3 * t371;
        let t391 = c3 * t375 - s3 * t376 + k6 * t382;
        let t392 = s3 * t375 + c3 * t376 + k6 * t379;
        let t398 = s2 * t391 + c2 * t373 + k1 * (c2 * t379);
        let t400 = s3 * t374;
        let t403 = c3 * t374;
        let t404 = s3 * t372 + t403;
        let t408 = t400 + c3 * t369;
        let t414 = c3 * t404 - s3 * t408;
        let t418 = t379 + t379;
        let t419 = k6 * t362;
        let t420 = c3 * (c3 * t372 - t400) - s3 * (t403 - s3 * t369) - t419;
        let t421 = s3 * t404 + c3 * t408 - t419;
        let t423 = k6 * t309;
        let t425 = t373 - t419 + (t423 + t423);
        [
        t373, t382, t391, t392, t398, t414, t418, t420,
        t421, t425,
    ]
    };
    // composite body 2
    let [t429, t440, t451] = {
        let t429 = ZZ2R + t421;
        let t430 = XY2 + t391;
        let t439 = k1 * (c2 * (MSY2R + t309) + s2 * (MSX2 + t382));
        let t440 = s2 * (XZ2 - t414) + c2 * (YZ2 - t392) + t439;
        let t448 = c2 * (s2 * t430 + c2 * t425);
        let t451 = s2 * (s2 * (XX2R + t420) + c2 * t430) + t448 + k1 * t418;
        [t429, t440, t451]
    };
    // composite body 1
    let t452 = {
        let t452 = ZZ1R + t451;
        t452
    };
    // M = L D L'
    let [
        t453, t454, t455, t456, t457, t458, t459, t463,
        t467, t470, t473, t476, t479, t486, t493, t498,
        t503, t508, t518, t528, t535, t542, t555, t568,
        t577, t593, t609, t628,
    ] = {
        let t453 = k7 / t452;
        let t454 = t440 * t453;
        let t455 = t398 * t453;
        let t456 = t342 * t453;
        let t457 = t272 * t453;
        let t458 = t188 * t453;
        let t459 = t98 * t453;
        let t462 = t429 - t452 * (t454 * t454);
        let t463 = k7 / t462;
        let t464 = t452 * t454;
        let t467 = t463 * (t392 + t455 * t464);
        let t470 = t463 * (t334 + t456 * t464);
        let t473 = t463 * (t264 + t457 * t464);
        let t476 = t463 * (t180 + t458 * t464);
        let t479 = t463 * (t90 + t459 * t464);
        let t485 = t373 - t452 * (t455 * t455) - t462 * (t467 * t467);
        let t486 = k7 / t485;
        let t487 = t452 * t455;
        let t490 = t462 * t467;
        let t493 = t486 * (t322 - t456 * t487 - t470 * t490);
        let t498 = t486 * (t248 - t457 * t487 - t473 * t490);
        let t503 = t486 * (t164 - t458 * t487 - t476 * t490);
        let t508 = t486 * (t74 - t459 * t487 - t479 * t490);
        let t516 = t485 * (t493 * t493);
        let t517 = t303 - t452 * (t456 * t456) - t462 * (t470 * t470) - t516;
        let t518 = k7 / t517;
        let t519 = t452 * t456;
        let t522 = t462 * t470;
        let t525 = t485 * t493;
        let t528 = t518 * (t236 + t457 * t519 + t473 * t522 + t498 * t525);
        let t535 = t518 * (t148 + t458 * t519 + t476 * t522 + t503 * t525);
        let t542 = t518 * (t58 + t459 * t519 + t479 * t522 + t508 * t525);
        let t550 = t485 * (t498 * t498);
        let t553 = t517 * (t528 * t528);
        let t554 = t217 - t452 * (t457 * t457) - t462 * (t473 * t473) - t550 - t553;
        let t555 = k7 / t554;
        let t556 = t452 * t457;
        let t559 = t462 * t473;
        let t562 = t485 * t498;
        let t565 = t517 * t528;
        let t567 = t136 - t458 * t556 - t476 * t559 - t503 * t562 - t535 * t565;
        let t568 = t555 * t567;
        let t576 = t42 - t459 * t556 - t479 * t559 - t508 * t562 - t542 * t565;
        let t577 = t555 * t576;
        let t585 = t485 * (t503 * t503);
        let t588 = t517 * (t535 * t535);
        let t589 = t117 - t452 * (t458 * t458) - t462 * (t476 * t476) - t585 - t588;
        let t592 = t589 - t554 * (t568 * t568);
        let t593 = k7 / t592;
        let t601 = t508 * (t485 * t503);
        let t604 = t542 * (t517 * t535);
        let t605 = t30 + t459 * (t452 * t458) + t479 * (t462 * t476) + t601 + t604;
        let t609 = t593 * (t605 + t577 * (t554 * t568));
        let t617 = t485 * (t508 * t508);
        let t620 = t517 * (t542 * t542);
        let t621 = ZZ7 - t452 * (t459 * t459) - t462 * (t479 * t479) - t617 - t620;
        let t628 = k7 / (t621 - t554 * (t577 * t577) - t592 * (t609 * t609));
        [
        t453, t454, t455, t456, t457, t458, t459, t463,
        t467, t470, t473, t476, t479, t486, t493, t498,
        t503, t508, t518, t528, t535, t542, t555, t568,
        t577, t593, t609, t628,
    ]
    };
    // link 3: motion
    let [
        a3_z, t637, a3_y, w3_x, t646, t649, t652, w3_z,
        t656, t657, t658, dw3_x, dw3_y, t661, t662, t663,
        t664, t665, t666, t667,
    ] = {
        let t632 = t1 + k6 * t8;
        let a3_z = k6 * t13 - t2;
        let t634 = a2_z - k6 * t14;
        let t637 = c3 * t632 + s3 * t634;
        let a3_y = s3 * t632 - c3 * t634;
        let w3_x = c3 * w2_x - s3 * dq2;
        let t646 = c3 * dq2 + s3 * w2_x;
        let t649 = c3 * t8 - s3 * t14;
        let t652 = c3 * t14 + s3 * t8;
        let w3_z = w2_y + dq3;
        let t654 = w3_x * w3_x;
        let t655 = w3_z * w3_z;
        let t656 = w3_x * t646;
        let t657 = w3_x * w3_z;
        let t658 = t646 * w3_z;
        let dw3_x = t652 - t658;
        let dw3_y = t649 - t657;
        let t661 = t654 - t655;
        let t662 = t661 - t13;
        let t663 = t9 - t656;
        let t664 = t9 + t656;
        let t665 = t654 + t655;
        let t666 = t657 - dw3_y;
        let t667 = dw3_x - t658;
        [
        a3_z, t637, a3_y, w3_x, t646, t649, t652, w3_z,
        t656, t657, t658, dw3_x, dw3_y, t661, t662, t663,
        t664, t665, t666, t667,
    ]
    };
    // link 4: motion
    let [
        t672, a4_x, a4_y, w4_x, w4_y, t688, t691, w4_z,
        t695, t696, t697, dw4_x, t699, t700, t701, t702,
        t703, t704, t705, t706,
    ] = {
        let t671 = k5 * t663 - t637;
        let t672 = a3_y - k5 * t665;
        let t673 = a3_z + k5 * t667;
        let a4_x = c4 * t671 + s4 * t673;
        let a4_y = c4 * t673 - s4 * t671;
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t688 = c4 * t663 + s4 * t667;
        let t691 = s4 * t663 - c4 * t667;
        let w4_z = t646 + dq4;
        let t693 = w4_x * w4_x;
        let t694 = w4_z * w4_z;
        let t695 = w4_x * w4_y;
        let t696 = w4_x * w4_z;
        let t697 = w4_y * w4_z;
        let dw4_x = t697 - t691;
        let t699 = t688 + t696;
        let t700 = t693 - t694;
        let t701 = t700 - t665;
        let t702 = dw3_y + t695;
        let t703 = t695 - dw3_y;
        let t704 = t693 + t694;
        let t705 = t696 + t699;
        let t706 = t697 + dw4_x;
        [
        t672, a4_x, a4_y, w4_x, w4_y, t688, t691, w4_z,
        t695, t696, t697, dw4_x, t699, t700, t701, t702,
        t703, t704, t705, t706,
    ]
    };
    // link 5: motion
    let [
        a5_z, a5_x, a5_y, w5_x, t724, t727, t730, w5_z,
        t734, t735, t736, dw5_x, dw5_y, t739, t740, t741,
        t742, t743, t744, t745,
    ] = {
        let t710 = a4_x - k4 * t702;
        let a5_z = a4_y + k4 * t704;
        let t712 = t672 + k4 * t706;
        let a5_x = c5 * t710 + s5 * t712;
        let a5_y = c5 * t712 - s5 * t710;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t724 = c5 * w4_z + s5 * w4_x;
        let t727 = c5 * t702 - s5 * t706;
        let t730 = c5 * t706 + s5 * t702;
        let w5_z = w4_y + dq5;
        let t732 = w5_x * w5_x;
        let t733 = w5_z * w5_z;
        let t734 = w5_x * t724;
        let t735 = w5_x * w5_z;
        let t736 = t724 * w5_z;
        let dw5_x = t730 - t736;
        let dw5_y = t727 - t735;
        let t739 = t732 - t733;
        let t740 = t739 - t704;
        let t741 = t699 - t734;
        let t742 = t699 + t734;
        let t743 = t732 + t733;
        let t744 = t735 - dw5_y;
        let t745 = dw5_x - t736;
        [
        a5_z, a5_x, a5_y, w5_x, t724, t727, t730, w5_z,
        t734, t735, t736, dw5_x, dw5_y, t739, t740, t741,
        t742, t743, t744, t745,
    ]
    };
    // link 6: motion
    let [
        t750, a6_x, a6_y, w6_x, w6_y, t766, t769, w6_z,
        t773, t774, t775, dw6_x, t777, t778, t779, t780,
        t781, t782, t783, t784,
    ] = {
        let t749 = a5_x + k3 * t741;
        let t750 = a5_y - k3 * t743;
        let t751 = a5_z + k3 * t745;
        let a6_x = c6 * t749 + s6 * t751;
        let a6_y = c6 * t751 - s6 * t749;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t766 = c6 * t741 + s6 * t745;
        let t769 = s6 * t741 - c6 * t745;
        let w6_z = t724 + dq6;
        let t771 = w6_x * w6_x;
        let t772 = w6_z * w6_z;
        let t773 = w6_x * w6_y;
        let t774 = w6_x * w6_z;
        let t775 = w6_y * w6_z;
        let dw6_x = t775 - t769;
        let t777 = t766 + t774;
        let t778 = t771 - t772;
        let t779 = t778 - t743;
        let t780 = dw5_y + t773;
        let t781 = t773 - dw5_y;
        let t782 = t771 + t772;
        let t783 = t774 + t777;
        let t784 = t775 + dw6_x;
        [
        t750, a6_x, a6_y, w6_x, w6_y, t766, t769, w6_z,
        t773, t774, t775, dw6_x, t777, t778, t779, t780,
        t781, t782, t783, t784,
    ]
    };
    // link 7: motion
    let [
        t787, t790, t799, t802, t806, t807, t808, dw7_x,
        t811, t812, t813, t814, t815, t816, t817,
    ] = {
        let t787 = c7 * a6_x + s7 * t750;
        let t790 = c7 * t750 - s7 * a6_x;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t796 = c7 * w6_z + s7 * w6_x;
        let t799 = c7 * t780 - s7 * t784;
        let t802 = c7 * t784 + s7 * t780;
        let w7_z = w6_y + dq7;
        let t804 = w7_x * w7_x;
        let t805 = w7_z * w7_z;
        let t806 = w7_x * t796;
        let t807 = w7_x * w7_z;
        let t808 = t796 * w7_z;
        let dw7_x = t802 - t808;
        let dw7_y = t799 - t807;
        let t811 = t804 - t805;
        let t812 = t811 - t782;
        let t813 = t777 - t806;
        let t814 = t777 + t806;
        let t815 = t804 + t805;
        let t816 = t807 - dw7_y;
        let t817 = dw7_x - t808;
        [
        t787, t790, t799, t802, t806, t807, t808, dw7_x,
        t811, t812, t813, t814, t815, t816, t817,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t869, t872, t875, t878] = {
        let t819 = XZ7 + MSX7 * k2;
        let t821 = YZ7 + MSY7 * k2;
        let t842 = XX7R * t806 - ZZ7 * t777 + XY7 * (t812 + t815) + t802 * t819;
        let t844 = t821 * (t782 - t815);
        let t847 = XX7R * dw7_x - ZZ7 * t808 - XY7 * t816 - t814 * t819 + t844;
        let t848 = t807 * (XX7R - ZZ7) + XY7 * t817 - t811 * t819 - t813 * t821;
        let f7_x = MSX7 * t812 + MSY7 * t813;
        let t855 = MSX7 * t814 + MSY7 * t815;
        let f7_z = MSX7 * t816 + MSY7 * t817;
        let n7_x = t847 + MSY7 * a6_y;
        let n7_y = t848 - MSX7 * a6_y;
        let n7_z = t842 + t799 * t821 + (MSX7 * t790 - MSY7 * t787);
        let t869 = c7 * f7_x + s7 * t855;
        let t872 = s7 * f7_x - c7 * t855;
        let t875 = c7 * n7_x - s7 * n7_y;
        let t878 = s7 * n7_x + c7 * n7_y;
        [f7_z, n7_z, t869, t872, t875, t878]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t932, t935, t944, t945] = {
        let t899 = XY6 * (t779 + t782) - (XX6R * t773 + ZZ6R * dw5_y) - XZ6 * t769;
        let t901 = YZ6 * (t743 - t782);
        let t904 = ZZ6R * t775 + XX6R * dw6_x - XY6 * t783 + XZ6 * t781 + t901;
        let t905 = t774 * (XX6R - ZZ6R) + XY6 * t784 - XZ6 * t778 - YZ6 * t780;
        let f6_x = t869 + (MSX6 * t779 + MSY6R * t780);
        let f6_y = f7_z + (MSX6 * t781 - MSY6R * t782);
        let f6_z = MSX6 * t783 + MSY6R * t784 - t872;
        let n6_x = t875 + (t904 - MSY6R * t750);
        let n6_y = n7_z + (t905 + MSX6 * t750);
        let n6_z = t899 - YZ6 * t766 + (MSX6 * a6_y - MSY6R * a6_x) - t878;
        let t932 = c6 * f6_x - s6 * f6_y;
        let t935 = s6 * f6_x + c6 * f6_y;
        let t944 = c6 * n6_x - s6 * n6_y + k3 * t935;
        let t945 = s6 * n6_x + c6 * n6_y - k3 * t932;
        [f6_z, n6_z, t932, t935, t944, t945]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t999, t1002, t1011, t1012] = {
        let t966 = XX5R * t734 - ZZ5R * t699 + XY5 * (t740 + t743) + XZ5 * t730;
        let t968 = YZ5 * (t704 - t743);
        let t971 = XX5R * dw5_x - ZZ5R * t736 - XY5 * t744 - XZ5 * t742 + t968;
        let t972 = t735 * (XX5R - ZZ5R) + XY5 * t745 - XZ5 * t739 - YZ5 * t741;
        let f5_x = t932 + (MSX5 * t740 + MSY5R * t741);
        let t992 = f6_z + (MSX5 * t742 + MSY5R * t743);
        let f5_z = t935 + (MSX5 * t744 + MSY5R * t745);
        let n5_x = t944 + (t971 + MSY5R * a5_z);
        let n5_y = t972 - MSX5 * a5_z - n6_z;
        let n5_z = t945 + (t966 + YZ5 * t727 + (MSX5 * a5_y - MSY5R * a5_x));
        let t999 = c5 * f5_x + s5 * t992;
        let t1002 = s5 * f5_x - c5 * t992;
        let t1011 = c5 * n5_x - s5 * n5_y + k4 * t1002;
        let t1012 = s5 * n5_x + c5 * n5_y - k4 * t999;
        [f5_z, n5_z, t999, t1002, t1011, t1012]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t1066, t1069, t1078, t1079] = {
        let t1033 = XY4 * (t701 + t704) - (XX4R * t695 + ZZ4R * dw3_y) - XZ4 * t691;
        let t1035 = YZ4 * (t665 - t704);
        let t1038 = ZZ4R * t697 + XX4R * dw4_x - XY4 * t705 + XZ4 * t703 + t1035;
        let t1039 = t696 * (XX4R - ZZ4R) + XY4 * t706 - XZ4 * t700 - YZ4 * t702;
        let f4_x = t999 + (MSX4 * t701 + MSY4R * t702);
        let f4_y = f5_z + (MSX4 * t703 - MSY4R * t704);
        let f4_z = MSX4 * t705 + MSY4R * t706 - t1002;
        let n4_x = t1011 + (t1038 - MSY4R * t672);
        let n4_y = n5_z + (t1039 + MSX4 * t672);
        let n4_z = t1033 - YZ4 * t688 + (MSX4 * a4_y - MSY4R * a4_x) - t1012;
        let t1066 = c4 * f4_x - s4 * f4_y;
        let t1069 = s4 * f4_x + c4 * f4_y;
        let t1078 = c4 * n4_x - s4 * n4_y + k5 * t1069;
        let t1079 = s4 * n4_x + c4 * n4_y - k5 * t1066;
        [f4_z, n4_z, t1066, t1069, t1078, t1079]
    };
    // link 3: force and moment
    let [f3_z, n3_z, t1133, t1145, t1146] = {
        let t1100 = XX3R * t656 - ZZ3R * t9 + XY3 * (t662 + t665) + XZ3 * t652;
        let t1102 = YZ3 * (t13 - t665);
        let t1105 = XX3R * dw3_x - ZZ3R * t658 - XY3 * t666 - XZ3 * t664 + t1102;
        let t1106 = t657 * (XX3R - ZZ3R) + XY3 * t667 - XZ3 * t661 - YZ3 * t663;
        let f3_x = t1066 + (MSX3 * t662 + MSY3R * t663);
        let t1126 = f4_z + (MSX3 * t664 + MSY3R * t665);
        let f3_z = t1069 + (MSX3 * t666 + MSY3R * t667);
        let n3_x = t1078 + (t1105 + MSY3R * a3_z);
        let n3_y = t1106 - MSX3 * a3_z - n4_z;
        let n3_z = t1079 + (t1100 + YZ3 * t649 + (MSX3 * a3_y + MSY3R * t637));
        let t1133 = c3 * f3_x + s3 * t1126;
        let t1145 = c3 * n3_x - s3 * n3_y + k6 * (s3 * f3_x - c3 * t1126);
        let t1146 = s3 * n3_x + c3 * n3_y - k6 * t1133;
        [f3_z, n3_z, t1133, t1145, t1146]
    };
    // link 2: force and moment
    let [t1160, n2_z, t1186] = {
        let t1152 = c2 * (s2 * XX2R + c2 * (XY2 + XY2)) - XY2;
        let t1160 = (t1152 + t1152) * (dq1 * dq2) + t7 * (c2 * XZ2 - s2 * YZ2);
        let f2_x = t1133 + (MSX2 * t12 + MSY2R * t8);
        let f2_y = f3_z + (MSX2 * t8 - MSY2R * t13);
        let n2_x = t1145 + MSY2R * a2_z;
        let n2_y = n3_z - MSX2 * a2_z;
        let n2_z = MSY2R * t1 - MSX2 * t2 - t1146 - t0 * t1152;
        let f1_x = c2 * f2_x - s2 * f2_y;
        let t1186 = s2 * n2_x + c2 * n2_y - k1 * f1_x;
        [t1160, n2_z, t1186]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t1160 + t1186;
        n1_z
    };
    // drives
    let [t1230, t1231, t1232, t1233, t1234, t1235, t1236] = {
        let t1230 = tau1 - (FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign()));
        let t1231 = tau2 - (FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign()));
        let t1232 = tau3 - (FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign()));
        let t1233 = tau4 - (FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign()));
        let t1234 = tau5 - (FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign()));
        let t1235 = tau6 - (FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign()));
        let t1236 = tau7 - (FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign()));
        [t1230, t1231, t1232, t1233, t1234, t1235, t1236]
    };
    // ddq
    {
        let t1238 = t1231 - t1230 * t454;
        let t1242 = t1232 - t1230 * t455 + t467 * t1238;
        let t1248 = t1233 - t1230 * t456 + t470 * t1238 - t493 * t1242;
        let t1256 = t1234 - t1230 * t457 + t473 * t1238 - t498 * t1242 + t528 * t1248;
        let t1264 = t1235 - t1230 * t458 + t476 * t1238 - t503 * t1242 + t535 * t1248;
        let t1266 = t1264 - t568 * t1256;
        let t1274 = t1236 - t1230 * t459 + t479 * t1238 - t508 * t1242 + t542 * t1248;
        let t1285 = t628 * (t1274 - t577 * t1256 + t609 * t1266);
        let t1287 = t593 * t1266 + t609 * t1285;
        let t1291 = t555 * t1256 - t568 * t1287 - t577 * t1285;
        let t1297 = t518 * t1248 + t528 * t1291 + t535 * t1287 + t542 * t1285;
        let t1304 = t508 * t1285;
        let t1305 = t486 * t1242 - t493 * t1297 - t498 * t1291 - t503 * t1287 - t1304;
        let t1312 = t476 * t1287;
        let t1313 = t463 * t1238 + t467 * t1305 + t470 * t1297 + t473 * t1291 + t1312;
        let t1315 = t1313 + t479 * t1285;
        let t1322 = t457 * t1291;
        let t1323 = t1230 * t453 - t454 * t1315 - t455 * t1305 - t456 * t1297 - t1322;
        let t1327 = t1323 - t458 * t1287 - t459 * t1285;
        put(0, t1327);
        put(1, t1315);
        put(2, t1305);
        put(3, t1297);
        put(4, t1291);
        put(5, t1287);
        put(6, t1285);
    }
}
