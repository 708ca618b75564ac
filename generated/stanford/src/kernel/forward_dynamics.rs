//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 455 multiplications, 363 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, Trig};

/// Accelerations that torques cause: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE], out: &mut [S; 6]) {
    entries(trig, dq, tau, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [tau1, tau2, tau3, tau4, tau5, tau6] = *tau;
    let [
        YY1R, MSX2, MSZ2, YY2R, ZZ2R, XY2R, XZ2R, YZ2R, M3R, MSX3, MSY3, MSZ3R,
        MSX4, MSZ4R, YY4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSZ5R, YY5R, ZZ5R, XY5,
        XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        ..] = *beta;
    let D2 = S::constant(0.154);
    let D6 = S::constant(0.263);
    let k2 = S::constant(9.81);
    let k3 = S::constant(2.0);
    let k4 = S::constant(1.0);
    // composite body 6
    let [
        t2, t5, t14, t15, t17, t23, t39, t47,
        t56, t59, t62,
    ] = {
        let t2 = c6 * MSY6 + s6 * MSX6;
        let t5 = c6 * MSX6 - s6 * MSY6;
        let t14 = c6 * XZ6 - s6 * YZ6 - D6 * t5;
        let t15 = s6 * XZ6 + c6 * YZ6 - D6 * t2;
        let t16 = c5 * t2;
        let t17 = s5 * t2;
        let t20 = c5 * t14 + s5 * ZZ6;
        let t23 = s5 * t14 - c5 * ZZ6;
        let t29 = c4 * t5 - s4 * t16;
        let t38 = s4 * t20 + c4 * t15 - q3 * (c4 * t16 + s4 * t5);
        let t39 = q3 * t29 - (c4 * t20 - s4 * t15);
        let t47 = s2 * t38 + c2 * t23 + D2 * (c2 * t29 + s2 * t17);
        let t49 = s6 * XY6;
        let t52 = c6 * XY6;
        let t53 = s6 * XX6R + t52;
        let t56 = c6 * (c6 * XX6R - t49) - s6 * t52;
        let t59 = c6 * t53 - s6 * t49;
        let t62 = s6 * t53 + c6 * t49;
        [
        t2, t5, t14, t15, t17, t23, t39, t47,
        t56, t59, t62,
    ]
    };
    // composite body 5
    let [
        t65, t71, t74, t77, t80, t92, t100, t113,
        t116, t119,
    ] = {
        let t63 = MSX5 + t5;
        let t64 = ZZ5R + ZZ6;
        let t65 = YY5R + t62;
        let t66 = XZ5 + t14;
        let t67 = XY5 + t59;
        let t68 = YZ5 + t15;
        let t71 = c5 * MSZ5R - s5 * t63;
        let t74 = s5 * MSZ5R + c5 * t63;
        let t77 = c5 * t67 + s5 * t68;
        let t80 = s5 * t67 - c5 * t68;
        let t82 = s4 * t71;
        let t92 = q3 * t82 - (c4 * t77 - s4 * t65);
        let t97 = c2 * t80;
        let t98 = s2 * (s4 * t77 + c4 * t65 + q3 * (c4 * t71)) + t97;
        let t100 = t98 + D2 * (c2 * t82 - s2 * t74);
        let t102 = s5 * t66;
        let t105 = c5 * t66;
        let t106 = s5 * t56 - t105;
        let t110 = c5 * t64 - t102;
        let t113 = c5 * (c5 * t56 + t102) + s5 * (t105 + s5 * t64);
        let t116 = c5 * t106 - s5 * t110;
        let t119 = s5 * t106 + c5 * t110;
        [
        t65, t71, t74, t77, t80, t92, t100, t113,
        t116, t119,
    ]
    };
    // composite body 4
    let [
        t123, t129, t132, t135, t138, t142, t148, t161,
        t164, t167,
    ] = {
        let t120 = MSX4 + t74;
        let t121 = MSZ4R + t2;
        let t122 = ZZ4R + t65;
        let t123 = YY4R + t119;
        let t124 = XZ4 + t77;
        let t125 = XY4 + t116;
        let t126 = YZ4 + t80;
        let t129 = c4 * t121 + s4 * t120;
        let t132 = c4 * t120 - s4 * t121;
        let t135 = s4 * t126 - c4 * t125;
        let t138 = s4 * t125 + c4 * t126;
        let t142 = q3 * t132 - t135;
        let t148 = D2 * (c2 * t132) - (s2 * (t138 + q3 * t129) + c2 * t123);
        let t150 = s4 * t124;
        let t153 = c4 * t124;
        let t154 = s4 * t113 + t153;
        let t158 = t150 + c4 * t122;
        let t161 = c4 * (c4 * t113 - t150) - s4 * (t153 - s4 * t122);
        let t164 = c4 * t154 - s4 * t158;
        let t167 = s4 * t154 + c4 * t158;
        [
        t123, t129, t132, t135, t138, t142, t148, t161,
        t164, t167,
    ]
    };
    // composite body 3
    let [t168, t169, t174, t176, t179, t181, t182, t184] = {
        let t168 = MSX3 + t132;
        let t169 = MSY3 + t129;
        let t170 = MSZ3R + t71;
        let t174 = D2 * (s2 * M3R) - s2 * t168;
        let t176 = t170 + q3 * M3R;
        let t178 = q3 * (t170 + t176);
        let t179 = t167 + t178;
        let t181 = t138 + q3 * t169;
        let t182 = t161 + t178;
        let t184 = q3 * t168 - t135;
        [t168, t169, t174, t176, t179, t181, t182, t184]
    };
    // composite body 2
    let [t188, t199, t213] = {
        let t188 = YY2R + t182;
        let t189 = t181 - XZ2R;
        let t198 = D2 * (c2 * (MSZ2 + t176) - s2 * (MSX2 + t169));
        let t199 = s2 * (XY2R - t164) - c2 * (YZ2R + t184) + t198;
        let t207 = c2 * (s2 * t189 + c2 * (ZZ2R + t123));
        let t212 = D2 * (D2 * M3R - t168 - t168);
        let t213 = s2 * (s2 * t179 + c2 * t189) + t207 + t212;
        [t188, t199, t213]
    };
    // composite body 1
    let t214 = {
        let t214 = YY1R + t213;
        t214
    };
    // link 2: motion
    let [t215, w3_z, t218, t219, t220, t221, dw2_y] = {
        let t215 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t218 = s2 * k2;
        let t219 = c2 * k2;
        let t220 = D2 * (dq1 * dq1);
        let t221 = dq2 * w3_z;
        let dw2_y = dq2 * t215;
        [t215, w3_z, t218, t219, t220, t221, dw2_y]
    };
    // link 3: motion
    let [
        t223, t224, t225, t226, t227, t228, t229, t230,
        t231, t236, t241, a3_y,
    ] = {
        let t223 = t215 * t215;
        let t224 = w3_z * w3_z;
        let t225 = dq2 * dq2;
        let t226 = t215 * w3_z;
        let t227 = t224 + t225;
        let t228 = t223 + t225;
        let t229 = dw2_y + dw2_y;
        let t230 = t221 + t221;
        let t231 = t223 + t224;
        let t236 = q3 * t228 - t219;
        let t238 = dq3 * k3;
        let t241 = q3 * t230 - t220 + t215 * t238;
        let a3_y = dq2 * t238 - (t218 + q3 * t226);
        [
        t223, t224, t225, t226, t227, t228, t229, t230,
        t231, t236, t241, a3_y,
    ]
    };
    // link 4: motion
    let [t245, w4_y, a4_x, a4_y, w4_z, dw4_x, dw4_y] = {
        let t245 = c4 * dq2 + s4 * t215;
        let w4_y = s4 * dq2 - c4 * t215;
        let a4_x = s4 * a3_y - c4 * t241;
        let a4_y = c4 * a3_y + s4 * t241;
        let w4_z = w3_z + dq4;
        let dw4_x = dq4 * w4_y - s4 * t221;
        let dw4_y = dq4 * t245 - c4 * t221;
        [t245, w4_y, a4_x, a4_y, w4_z, dw4_x, dw4_y]
    };
    // link 5: motion
    let [
        t264, w5_y, t274, t275, t276, t277, t278, t279,
        t280, t281, t282, t283, t284, t285, t286, t287,
        a5_x, a5_y, w5_z, dw5_x, dw5_y,
    ] = {
        let t264 = c5 * t245 + s5 * w4_z;
        let w5_y = s5 * t245 - c5 * w4_z;
        let t274 = t245 * t245;
        let t275 = w4_y * w4_y;
        let t276 = w4_z * w4_z;
        let t277 = t245 * w4_y;
        let t278 = t245 * w4_z;
        let t279 = w4_y * w4_z;
        let t280 = t275 + t276;
        let t281 = dw2_y - t277;
        let t282 = dw4_y - t278;
        let t283 = dw2_y + t277;
        let t284 = t274 + t276;
        let t285 = t279 - dw4_x;
        let t286 = dw4_y + t278;
        let t287 = dw4_x + t279;
        let a5_x = c5 * a4_x + s5 * t236;
        let a5_y = c5 * t236 - s5 * a4_x;
        let w5_z = w4_y + dq5;
        let dw5_x = c5 * dw4_x + s5 * dw2_y + dq5 * w5_y;
        let dw5_y = c5 * dw2_y - s5 * dw4_x + dq5 * t264;
        [
        t264, w5_y, t274, t275, t276, t277, t278, t279,
        t280, t281, t282, t283, t284, t285, t286, t287,
        a5_x, a5_y, w5_z, dw5_x, dw5_y,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t311, t312, t313, t314, t315, t316,
        t317, t318, t319, t320, t321, t322, t323, t324,
        t329, a6_x, a6_y, w6_z, dw6_x, dw6_y,
    ] = {
        let w6_x = s6 * w5_z - c6 * t264;
        let w6_y = c6 * w5_z + s6 * t264;
        let t311 = t264 * t264;
        let t312 = w5_y * w5_y;
        let t313 = w5_z * w5_z;
        let t314 = t264 * w5_y;
        let t315 = t264 * w5_z;
        let t316 = w5_y * w5_z;
        let t317 = t312 + t313;
        let t318 = dw4_y + t314;
        let t319 = dw5_y - t315;
        let t320 = dw4_y - t314;
        let t321 = t311 + t313;
        let t322 = t316 - dw5_x;
        let t323 = dw5_y + t315;
        let t324 = dw5_x + t316;
        let t328 = a5_x + D6 * t318;
        let t329 = a5_y + D6 * t321;
        let t330 = a4_y - D6 * t324;
        let a6_x = c6 * t328 + s6 * t330;
        let a6_y = c6 * t330 - s6 * t328;
        let w6_z = dq6 - w5_y;
        let dw6_x = c6 * dw5_x + s6 * dw4_y + dq6 * w6_y;
        let dw6_y = c6 * dw4_y - s6 * dw5_x - dq6 * w6_x;
        [
        w6_x, w6_y, t311, t312, t313, t314, t315, t316,
        t317, t318, t319, t320, t321, t322, t323, t324,
        t329, a6_x, a6_y, w6_z, dw6_x, dw6_y,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t404, t407, t416, t417] = {
        let t342 = w6_x * w6_x;
        let t343 = w6_y * w6_y;
        let t344 = w6_z * w6_z;
        let t345 = w6_x * w6_y;
        let t346 = w6_x * w6_z;
        let t347 = w6_y * w6_z;
        let t349 = dw5_y + t345;
        let t351 = t345 - dw5_y;
        let t354 = t346 - dw6_y;
        let t355 = dw6_x + t347;
        let t374 = XZ6 * (t347 - dw6_x);
        let t379 = YZ6 * (t343 - t344);
        let t380 = YZ6 * t349;
        let t381 = YZ6 * (dw6_y + t346);
        let t382 = ZZ6 * t347 + XX6R * dw6_x - XY6 * t354 + XZ6 * t351 + t379;
        let t383 = t346 * (XX6R - ZZ6) + XY6 * t355 + XZ6 * (t344 - t342) - t380;
        let t384 = XY6 * (t342 - t343) - (XX6R * t345 + ZZ6 * dw5_y) - t374 + t381;
        let f6_x = MSY6 * t349 - MSX6 * (t343 + t344);
        let f6_y = MSX6 * t351 - MSY6 * (t342 + t344);
        let f6_z = MSX6 * t354 + MSY6 * t355;
        let n6_x = t382 - MSY6 * t329;
        let n6_y = t383 + MSX6 * t329;
        let n6_z = t384 + (MSX6 * a6_y - MSY6 * a6_x);
        let t404 = c6 * f6_x - s6 * f6_y;
        let t407 = s6 * f6_x + c6 * f6_y;
        let t416 = c6 * n6_x - s6 * n6_y - D6 * t407;
        let t417 = s6 * n6_x + c6 * n6_y + D6 * t404;
        [f6_z, n6_z, t404, t407, t416, t417]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t472, t475, t478, t481] = {
        let t438 = YY5R * dw4_y - ZZ5R * t314 - XY5 * t322 + XZ5 * (t312 - t311);
        let t439 = XY5 * (t311 - t313) - (YY5R * t315 + ZZ5R * dw5_y) + XZ5 * t324;
        let t441 = YZ5 * (t313 - t312);
        let t456 = MSZ5R * a4_y;
        let t461 = XY5 * t320 - t316 * (ZZ5R - YY5R) - XZ5 * t323 + t441 - t456;
        let f5_x = t404 + (MSZ5R * t318 - MSX5 * t317);
        let f5_y = MSX5 * t320 + MSZ5R * t321 - f6_z;
        let f5_z = t407 - (MSX5 * t323 + MSZ5R * t324);
        let n5_x = t416 + t461;
        let t468 = n6_z + (t439 + YZ5 * t318 + MSX5 * a4_y);
        let n5_z = t417 + (t438 - YZ5 * t319 + (MSZ5R * a5_x + MSX5 * a5_y));
        let t472 = c5 * f5_x - s5 * f5_y;
        let t475 = s5 * f5_x + c5 * f5_y;
        let t478 = c5 * n5_x + s5 * t468;
        let t481 = s5 * n5_x - c5 * t468;
        [f5_z, n5_z, t472, t475, t478, t481]
    };
    // link 4: force and moment
    let [t530, t533, t536, t539, t542, t545] = {
        let t502 = ZZ4R * t277 + YY4R * dw2_y - XY4 * t285 + XZ4 * (t275 - t274);
        let t503 = YY4R * t278 + ZZ4R * dw4_y + XY4 * (t274 - t276) + XZ4 * t287;
        let t505 = YZ4 * (t276 - t275);
        let t520 = MSZ4R * t236;
        let t525 = XY4 * t283 - t279 * (ZZ4R - YY4R) + XZ4 * t286 + t505 - t520;
        let f4_x = t472 + (MSZ4R * t281 - MSX4 * t280);
        let f4_y = f5_z - (MSX4 * t283 + MSZ4R * t284);
        let t530 = t475 + (MSX4 * t286 - MSZ4R * t287);
        let n4_x = t478 + t525;
        let n4_y = n5_z + (t503 + YZ4 * t281 + MSX4 * t236);
        let t533 = t481 + (t502 + YZ4 * t282 + (MSZ4R * a4_x - MSX4 * a4_y));
        let t536 = c4 * f4_x - s4 * f4_y;
        let t539 = s4 * f4_x + c4 * f4_y;
        let t542 = c4 * n4_x - s4 * n4_y;
        let t545 = s4 * n4_x + c4 * n4_y;
        [t530, t533, t536, t539, t542, t545]
    };
    // link 3: force and moment
    let [t546, t547, t548, f3_y, t577, n3_z, t583, t584] = {
        let t546 = t225 - t223;
        let t547 = t224 - t225;
        let t548 = t223 - t224;
        let f3_x = t536 + (MSY3 * t229 - MSX3 * t231 - MSZ3R * t230 - M3R * t241);
        let f3_y = t539 + (M3R * a3_y - (MSY3 * t227 + MSZ3R * t226));
        let t577 = t530 + (M3R * t236 + (MSY3 * t226 + MSZ3R * t228));
        let n3_x = t542 - (MSY3 * t236 + MSZ3R * a3_y);
        let n3_y = t545 + (MSX3 * t236 - MSZ3R * t241);
        let n3_z = MSX3 * a3_y + MSY3 * t241 - t533;
        let t583 = n3_y + q3 * f3_x;
        let t584 = q3 * f3_y - n3_x;
        [t546, t547, t548, f3_y, t577, n3_z, t583, t584]
    };
    // link 2: force and moment
    let [n2_z, t630] = {
        let t602 = t221 * (ZZ2R - YY2R) + XY2R * t226 - XZ2R * t229 - YZ2R * t547;
        let t603 = dw2_y * (YY2R + ZZ2R) + XY2R * t546 + XZ2R * t230 + YZ2R * t226;
        let f2_x = f3_y - (MSX2 * t227 + MSZ2 * t226);
        let f2_y = t577 + (MSX2 * t226 + MSZ2 * t228);
        let n2_x = t583 + (t602 + MSZ2 * t220);
        let n2_y = t603 + MSX2 * t220 - n3_z;
        let n2_z = t584 + (ZZ2R * t226 - XZ2R * t548 - (MSZ2 * t218 + MSX2 * t219));
        let f1_x = c2 * f2_x - s2 * f2_y;
        let t630 = s2 * n2_x + c2 * n2_y + D2 * f1_x;
        [n2_z, t630]
    };
    // drives
    let [t631, t632, t633, t634, t635, t636] = {
        let t631 = t630 + tau1;
        let t632 = tau2 - n2_z;
        let t633 = t577 + tau3;
        let t634 = t533 + tau4;
        let t635 = tau5 - n5_z;
        let t636 = tau6 - n6_z;
        [t631, t632, t633, t634, t635, t636]
    };
    // M = L D L'
    let [
        t637, t638, t639, t640, t641, t642, t646, t650,
        t653, t656, t659, t666, t672, t677, t682, t692,
        t702, t709, t722, t735, t751,
    ] = {
        let t637 = k4 / t214;
        let t638 = t199 * t637;
        let t639 = t174 * t637;
        let t640 = t148 * t637;
        let t641 = t100 * t637;
        let t642 = t47 * t637;
        let t645 = t188 - t214 * (t638 * t638);
        let t646 = k4 / t645;
        let t647 = t214 * t638;
        let t650 = t646 * (t169 + t639 * t647);
        let t653 = t646 * (t142 - t640 * t647);
        let t656 = t646 * (t92 - t641 * t647);
        let t659 = t646 * (t39 - t642 * t647);
        let t665 = M3R - t214 * (t639 * t639) - t645 * (t650 * t650);
        let t666 = k4 / t665;
        let t667 = t214 * t639;
        let t669 = t645 * t650;
        let t672 = t666 * (t653 * t669 - t640 * t667);
        let t677 = t666 * (t656 * t669 - (t74 + t641 * t667));
        let t682 = t666 * (t17 - t642 * t667 + t659 * t669);
        let t690 = t665 * (t672 * t672);
        let t691 = t123 - t214 * (t640 * t640) - t645 * (t653 * t653) - t690;
        let t692 = k4 / t691;
        let t693 = t214 * t640;
        let t696 = t645 * t653;
        let t699 = t665 * t672;
        let t702 = t692 * (t80 + t641 * t693 + t656 * t696 + t677 * t699);
        let t709 = t692 * (t23 + t642 * t693 + t659 * t696 + t682 * t699);
        let t717 = t665 * (t677 * t677);
        let t720 = t691 * (t702 * t702);
        let t721 = t65 - t214 * (t641 * t641) - t645 * (t656 * t656) - t717 - t720;
        let t722 = k4 / t721;
        let t730 = t682 * (t665 * t677);
        let t733 = t709 * (t691 * t702);
        let t734 = t15 - t642 * (t214 * t641) - t659 * (t645 * t656) - t730 - t733;
        let t735 = t722 * t734;
        let t743 = t665 * (t682 * t682);
        let t746 = t691 * (t709 * t709);
        let t747 = ZZ6 - t214 * (t642 * t642) - t645 * (t659 * t659) - t743 - t746;
        let t751 = k4 / (t747 - t721 * (t735 * t735));
        [
        t637, t638, t639, t640, t641, t642, t646, t650,
        t653, t656, t659, t666, t672, t677, t682, t692,
        t702, t709, t722, t735, t751,
    ]
    };
    // ddq
    {
        let t753 = t632 + t631 * t638;
        let t757 = t633 + t631 * t639 + t650 * t753;
        let t763 = t634 + t631 * t640 - t653 * t753 - t672 * t757;
        let t771 = t635 + t631 * t641 - t656 * t753 - t677 * t757 + t702 * t763;
        let t779 = t636 + t631 * t642 - t659 * t753 - t682 * t757 + t709 * t763;
        let t787 = t751 * (t779 - t735 * t771);
        let t789 = t722 * t771 - t735 * t787;
        let t793 = t692 * t763 + t702 * t789 + t709 * t787;
        let t799 = t666 * t757 - t672 * t793 - t677 * t789 - t682 * t787;
        let t806 = t659 * t787;
        let t807 = t646 * t753 + t650 * t799 - t653 * t793 - t656 * t789 - t806;
        let t814 = t641 * t789;
        let t815 = t631 * t637 + t638 * t807 + t639 * t799 + t640 * t793 + t814;
        let t817 = t815 + t642 * t787;
        put(0, t817);
        put(1, t807);
        put(2, t799);
        put(3, t793);
        put(4, t789);
        put(5, t787);
    }
}
