//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 450 multiplications, 365 additions; 6, 6 of 6 structurally nonzero.

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
        XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6, IA3, IA4, IA5,
        IA6,
        ..] = *beta;
    let D2 = S::constant(0.154);
    let D6 = S::constant(0.263);
    let k2 = S::constant(9.81);
    let k3 = S::constant(2.0);
    let k4 = S::constant(1.0);
    // composite body 6
    let [
        t0, t3, t6, t15, t16, t18, t24, t40,
        t48, t57, t60, t63,
    ] = {
        let t0 = ZZ6 + IA6;
        let t3 = c6 * MSY6 + s6 * MSX6;
        let t6 = c6 * MSX6 - s6 * MSY6;
        let t15 = c6 * XZ6 - s6 * YZ6 - D6 * t6;
        let t16 = s6 * XZ6 + c6 * YZ6 - D6 * t3;
        let t17 = c5 * t3;
        let t18 = s5 * t3;
        let t21 = c5 * t15 + s5 * ZZ6;
        let t24 = s5 * t15 - c5 * ZZ6;
        let t30 = c4 * t6 - s4 * t17;
        let t39 = s4 * t21 + c4 * t16 - q3 * (c4 * t17 + s4 * t6);
        let t40 = q3 * t30 - (c4 * t21 - s4 * t16);
        let t48 = s2 * t39 + c2 * t24 + D2 * (c2 * t30 + s2 * t18);
        let t50 = s6 * XY6;
        let t53 = c6 * XY6;
        let t54 = s6 * XX6R + t53;
        let t57 = c6 * (c6 * XX6R - t50) - s6 * t53;
        let t60 = c6 * t54 - s6 * t50;
        let t63 = s6 * t54 + c6 * t50;
        [
        t0, t3, t6, t15, t16, t18, t24, t40,
        t48, t57, t60, t63,
    ]
    };
    // composite body 5
    let [
        t66, t70, t73, t76, t79, t82, t94, t102,
        t115, t118, t121,
    ] = {
        let t64 = MSX5 + t6;
        let t65 = ZZ5R + ZZ6;
        let t66 = YY5R + t63;
        let t67 = XZ5 + t15;
        let t68 = XY5 + t60;
        let t69 = YZ5 + t16;
        let t70 = IA5 + t66;
        let t73 = c5 * MSZ5R - s5 * t64;
        let t76 = s5 * MSZ5R + c5 * t64;
        let t79 = c5 * t68 + s5 * t69;
        let t82 = s5 * t68 - c5 * t69;
        let t84 = s4 * t73;
        let t94 = q3 * t84 - (c4 * t79 - s4 * t66);
        let t99 = c2 * t82;
        let t100 = s2 * (s4 * t79 + c4 * t66 + q3 * (c4 * t73)) + t99;
        let t102 = t100 + D2 * (c2 * t84 - s2 * t76);
        let t104 = s5 * t67;
        let t107 = c5 * t67;
        let t108 = s5 * t57 - t107;
        let t112 = c5 * t65 - t104;
        let t115 = c5 * (c5 * t57 + t104) + s5 * (t107 + s5 * t65);
        let t118 = c5 * t108 - s5 * t112;
        let t121 = s5 * t108 + c5 * t112;
        [
        t66, t70, t73, t76, t79, t82, t94, t102,
        t115, t118, t121,
    ]
    };
    // composite body 4
    let [
        t125, t129, t132, t135, t138, t141, t145, t151,
        t164, t167, t170,
    ] = {
        let t122 = MSX4 + t76;
        let t123 = MSZ4R + t3;
        let t124 = ZZ4R + t66;
        let t125 = YY4R + t121;
        let t126 = XZ4 + t79;
        let t127 = XY4 + t118;
        let t128 = YZ4 + t82;
        let t129 = IA4 + t125;
        let t132 = c4 * t123 + s4 * t122;
        let t135 = c4 * t122 - s4 * t123;
        let t138 = s4 * t128 - c4 * t127;
        let t141 = s4 * t127 + c4 * t128;
        let t145 = q3 * t135 - t138;
        let t151 = D2 * (c2 * t135) - (s2 * (t141 + q3 * t132) + c2 * t125);
        let t153 = s4 * t126;
        let t156 = c4 * t126;
        let t157 = s4 * t115 + t156;
        let t161 = t153 + c4 * t124;
        let t164 = c4 * (c4 * t115 - t153) - s4 * (t156 - s4 * t124);
        let t167 = c4 * t157 - s4 * t161;
        let t170 = s4 * t157 + c4 * t161;
        [
        t125, t129, t132, t135, t138, t141, t145, t151,
        t164, t167, t170,
    ]
    };
    // composite body 3
    let [
        t171, t172, t174, t178, t180, t183, t185, t186,
        t188,
    ] = {
        let t171 = MSX3 + t135;
        let t172 = MSY3 + t132;
        let t173 = MSZ3R + t73;
        let t174 = M3R + IA3;
        let t178 = D2 * (s2 * M3R) - s2 * t171;
        let t180 = t173 + q3 * M3R;
        let t182 = q3 * (t173 + t180);
        let t183 = t170 + t182;
        let t185 = t141 + q3 * t172;
        let t186 = t164 + t182;
        let t188 = q3 * t171 - t138;
        [
        t171, t172, t174, t178, t180, t183, t185, t186,
        t188,
    ]
    };
    // composite body 2
    let [t192, t203, t217] = {
        let t192 = YY2R + t186;
        let t193 = t185 - XZ2R;
        let t202 = D2 * (c2 * (MSZ2 + t180) - s2 * (MSX2 + t172));
        let t203 = s2 * (XY2R - t167) - c2 * (YZ2R + t188) + t202;
        let t211 = c2 * (s2 * t193 + c2 * (ZZ2R + t125));
        let t216 = D2 * (D2 * M3R - t171 - t171);
        let t217 = s2 * (s2 * t183 + c2 * t193) + t211 + t216;
        [t192, t203, t217]
    };
    // composite body 1
    let t218 = {
        let t218 = YY1R + t217;
        t218
    };
    // link 1: motion
    let t219 = {
        let t219 = dq1 * dq1;
        t219
    };
    // link 2: motion
    let [
        t220, w3_z, t222, t223, t224, t225, t226, t227,
        dw2_y, t229, t230, t231, t232,
    ] = {
        let t220 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t222 = s2 * k2;
        let t223 = c2 * k2;
        let t224 = D2 * t219;
        let t225 = t220 * t220;
        let t226 = dq2 * dq2;
        let t227 = t220 * w3_z;
        let dw2_y = dq2 * t220;
        let t229 = dq2 * w3_z;
        let t230 = t225 + t226;
        let t231 = dw2_y + dw2_y;
        let t232 = t229 + t229;
        [
        t220, w3_z, t222, t223, t224, t225, t226, t227,
        dw2_y, t229, t230, t231, t232,
    ]
    };
    // link 3: motion
    let [t237, t242, a3_y, t245, t246] = {
        let t237 = q3 * t230 - t223;
        let t239 = dq3 * k3;
        let t242 = q3 * t232 - t224 + t220 * t239;
        let a3_y = dq2 * t239 - (t222 + q3 * t227);
        let t244 = w3_z * w3_z;
        let t245 = t225 + t244;
        let t246 = t226 + t244;
        [t237, t242, a3_y, t245, t246]
    };
    // link 4: motion
    let [
        t249, w4_y, a4_x, a4_y, t261, t264, w4_z, t266,
        t267, t268, t269, t270, dw4_y, t273, t274, t275,
        t276, t277,
    ] = {
        let t249 = c4 * dq2 + s4 * t220;
        let w4_y = s4 * dq2 - c4 * t220;
        let a4_x = s4 * a3_y - c4 * t242;
        let a4_y = c4 * a3_y + s4 * t242;
        let t261 = c4 * t232 + s4 * t227;
        let t264 = s4 * t232 - c4 * t227;
        let w4_z = w3_z + dq4;
        let t266 = t249 * t249;
        let t267 = w4_z * w4_z;
        let t268 = t249 * w4_y;
        let t269 = t249 * w4_z;
        let t270 = w4_y * w4_z;
        let dw4_x = t270 - t264;
        let dw4_y = t269 - t261;
        let t273 = dw2_y - t268;
        let t274 = dw2_y + t268;
        let t275 = t266 + t267;
        let t276 = t269 + dw4_y;
        let t277 = t270 + dw4_x;
        [
        t249, w4_y, a4_x, a4_y, t261, t264, w4_z, t266,
        t267, t268, t269, t270, dw4_y, t273, t274, t275,
        t276, t277,
    ]
    };
    // link 5: motion
    let [
        t280, w5_y, a5_x, a5_y, t292, t295, w5_z, t297,
        t298, t299, t300, t301, dw5_y, t304, t305, t306,
        t307, t308,
    ] = {
        let t280 = c5 * t249 + s5 * w4_z;
        let w5_y = s5 * t249 - c5 * w4_z;
        let a5_x = c5 * a4_x + s5 * t237;
        let a5_y = c5 * t237 - s5 * a4_x;
        let t292 = c5 * t273 - s5 * t277;
        let t295 = c5 * t277 + s5 * t273;
        let w5_z = w4_y + dq5;
        let t297 = t280 * t280;
        let t298 = w5_z * w5_z;
        let t299 = t280 * w5_y;
        let t300 = t280 * w5_z;
        let t301 = w5_y * w5_z;
        let dw5_x = t295 + t301;
        let dw5_y = t292 + t300;
        let t304 = dw4_y + t299;
        let t305 = dw4_y - t299;
        let t306 = t297 + t298;
        let t307 = t300 + dw5_y;
        let t308 = t301 + dw5_x;
        [
        t280, w5_y, a5_x, a5_y, t292, t295, w5_z, t297,
        t298, t299, t300, t301, dw5_y, t304, t305, t306,
        t307, t308,
    ]
    };
    // link 6: motion
    let [
        t319, a6_x, a6_y, t329, t332, t336, t337, t338,
        dw6_x, t341, t342, t343, t344, t345, t346, t347,
    ] = {
        let w6_x = s6 * w5_z - c6 * t280;
        let w6_y = c6 * w5_z + s6 * t280;
        let t318 = a5_x + D6 * t304;
        let t319 = a5_y + D6 * t306;
        let t320 = a4_y - D6 * t308;
        let a6_x = c6 * t318 + s6 * t320;
        let a6_y = c6 * t320 - s6 * t318;
        let t329 = c6 * t304 - s6 * t308;
        let t332 = c6 * t308 + s6 * t304;
        let w6_z = dq6 - w5_y;
        let t334 = w6_x * w6_x;
        let t335 = w6_z * w6_z;
        let t336 = w6_x * w6_y;
        let t337 = w6_x * w6_z;
        let t338 = w6_y * w6_z;
        let dw6_x = t332 + t338;
        let dw6_y = t329 - t337;
        let t341 = t334 - t335;
        let t342 = t341 - t306;
        let t343 = dw5_y + t336;
        let t344 = t336 - dw5_y;
        let t345 = t334 + t335;
        let t346 = t337 - dw6_y;
        let t347 = t338 + dw6_x;
        [
        t319, a6_x, a6_y, t329, t332, t336, t337, t338,
        dw6_x, t341, t342, t343, t344, t345, t346, t347,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t395, t398, t407, t408] = {
        let t368 = XY6 * (t342 + t345) - (XX6R * t336 + ZZ6 * dw5_y) + XZ6 * t332;
        let t370 = YZ6 * (t306 - t345);
        let t373 = ZZ6 * t338 + XX6R * dw6_x - XY6 * t346 + XZ6 * t344 + t370;
        let t374 = t337 * (XX6R - ZZ6) + XY6 * t347 - XZ6 * t341 - YZ6 * t343;
        let f6_x = MSX6 * t342 + MSY6 * t343;
        let f6_y = MSX6 * t344 - MSY6 * t345;
        let f6_z = MSX6 * t346 + MSY6 * t347;
        let n6_x = t373 - MSY6 * t319;
        let n6_y = t374 + MSX6 * t319;
        let n6_z = t368 + YZ6 * t329 + (MSX6 * a6_y - MSY6 * a6_x);
        let t395 = c6 * f6_x - s6 * f6_y;
        let t398 = s6 * f6_x + c6 * f6_y;
        let t407 = c6 * n6_x - s6 * n6_y - D6 * t398;
        let t408 = s6 * n6_x + c6 * n6_y + D6 * t395;
        [f6_z, n6_z, t395, t398, t407, t408]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t466, t469, t472, t475] = {
        let t409 = w5_y * w5_y;
        let t410 = t298 + t409;
        let t411 = t297 + t409;
        let t432 = YY5R * dw4_y - ZZ5R * t299 + XY5 * t295 + XZ5 * (t410 - t306);
        let t433 = XY5 * (t411 - t410) - (YY5R * t300 + ZZ5R * dw5_y) + XZ5 * t308;
        let t435 = YZ5 * (t306 - t411);
        let t450 = MSZ5R * a4_y;
        let t455 = XY5 * t305 - t301 * (ZZ5R - YY5R) - XZ5 * t307 + t435 - t450;
        let f5_x = t395 + (MSZ5R * t304 - MSX5 * t410);
        let f5_y = MSX5 * t305 + MSZ5R * t306 - f6_z;
        let f5_z = t398 - (MSX5 * t307 + MSZ5R * t308);
        let n5_x = t407 + t455;
        let t462 = n6_z + (t433 + YZ5 * t304 + MSX5 * a4_y);
        let n5_z = t408 + (t432 - YZ5 * t292 + (MSZ5R * a5_x + MSX5 * a5_y));
        let t466 = c5 * f5_x - s5 * f5_y;
        let t469 = s5 * f5_x + c5 * f5_y;
        let t472 = c5 * n5_x + s5 * t462;
        let t475 = s5 * n5_x - c5 * t462;
        [f5_z, n5_z, t466, t469, t472, t475]
    };
    // link 4: force and moment
    let [t527, t530, t533, t536, t539, t542] = {
        let t476 = w4_y * w4_y;
        let t477 = t267 + t476;
        let t478 = t266 + t476;
        let t499 = ZZ4R * t268 + YY4R * dw2_y - XY4 * t264 + XZ4 * (t477 - t275);
        let t500 = YY4R * t269 + ZZ4R * dw4_y + XY4 * (t478 - t477) + XZ4 * t277;
        let t502 = YZ4 * (t275 - t478);
        let t517 = MSZ4R * t237;
        let t522 = XY4 * t274 - t270 * (ZZ4R - YY4R) + XZ4 * t276 + t502 - t517;
        let f4_x = t466 + (MSZ4R * t273 - MSX4 * t477);
        let f4_y = f5_z - (MSX4 * t274 + MSZ4R * t275);
        let t527 = t469 + (MSX4 * t276 - MSZ4R * t277);
        let n4_x = t472 + t522;
        let n4_y = n5_z + (t500 + YZ4 * t273 + MSX4 * t237);
        let t530 = t475 + (t499 - YZ4 * t261 + (MSZ4R * a4_x - MSX4 * a4_y));
        let t533 = c4 * f4_x - s4 * f4_y;
        let t536 = s4 * f4_x + c4 * f4_y;
        let t539 = c4 * n4_x - s4 * n4_y;
        let t542 = s4 * n4_x + c4 * n4_y;
        [t527, t530, t533, t536, t539, t542]
    };
    // link 3: force and moment
    let [t543, t544, t545, f3_y, t574, n3_z, t580, t581] = {
        let t543 = t246 - t245;
        let t544 = t245 - t230;
        let t545 = t230 - t246;
        let f3_x = t533 + (MSY3 * t231 - MSX3 * t245 - MSZ3R * t232 - M3R * t242);
        let f3_y = t536 + (M3R * a3_y - (MSY3 * t246 + MSZ3R * t227));
        let t574 = t527 + (M3R * t237 + (MSY3 * t227 + MSZ3R * t230));
        let n3_x = t539 - (MSY3 * t237 + MSZ3R * a3_y);
        let n3_y = t542 + (MSX3 * t237 - MSZ3R * t242);
        let n3_z = MSX3 * a3_y + MSY3 * t242 - t530;
        let t580 = n3_y + q3 * f3_x;
        let t581 = q3 * f3_y - n3_x;
        [t543, t544, t545, f3_y, t574, n3_z, t580, t581]
    };
    // link 2: force and moment
    let [n2_z, t627] = {
        let t599 = t229 * (ZZ2R - YY2R) + XY2R * t227 - XZ2R * t231 - YZ2R * t544;
        let t600 = dw2_y * (YY2R + ZZ2R) + XY2R * t543 + XZ2R * t232 + YZ2R * t227;
        let f2_x = f3_y - (MSX2 * t246 + MSZ2 * t227);
        let f2_y = t574 + (MSX2 * t227 + MSZ2 * t230);
        let n2_x = t580 + (t599 + MSZ2 * t224);
        let n2_y = t600 + MSX2 * t224 - n3_z;
        let n2_z = t581 + (ZZ2R * t227 - XZ2R * t545 - (MSZ2 * t222 + MSX2 * t223));
        let f1_x = c2 * f2_x - s2 * f2_y;
        let t627 = s2 * n2_x + c2 * n2_y + D2 * f1_x;
        [n2_z, t627]
    };
    // drives
    let [t628, t629, t630, t631, t632, t633] = {
        let t628 = t627 + tau1;
        let t629 = tau2 - n2_z;
        let t630 = t574 + tau3;
        let t631 = t530 + tau4;
        let t632 = tau5 - n5_z;
        let t633 = tau6 - n6_z;
        [t628, t629, t630, t631, t632, t633]
    };
    // M = L D L'
    let [
        t634, t635, t636, t637, t638, t639, t643, t647,
        t650, t653, t656, t663, t669, t674, t679, t689,
        t699, t706, t719, t732, t748,
    ] = {
        let t634 = k4 / t218;
        let t635 = t203 * t634;
        let t636 = t178 * t634;
        let t637 = t151 * t634;
        let t638 = t102 * t634;
        let t639 = t48 * t634;
        let t642 = t192 - t218 * (t635 * t635);
        let t643 = k4 / t642;
        let t644 = t218 * t635;
        let t647 = t643 * (t172 + t636 * t644);
        let t650 = t643 * (t145 - t637 * t644);
        let t653 = t643 * (t94 - t638 * t644);
        let t656 = t643 * (t40 - t639 * t644);
        let t662 = t174 - t218 * (t636 * t636) - t642 * (t647 * t647);
        let t663 = k4 / t662;
        let t664 = t218 * t636;
        let t666 = t642 * t647;
        let t669 = t663 * (t650 * t666 - t637 * t664);
        let t674 = t663 * (t653 * t666 - (t76 + t638 * t664));
        let t679 = t663 * (t18 - t639 * t664 + t656 * t666);
        let t687 = t662 * (t669 * t669);
        let t688 = t129 - t218 * (t637 * t637) - t642 * (t650 * t650) - t687;
        let t689 = k4 / t688;
        let t690 = t218 * t637;
        let t693 = t642 * t650;
        let t696 = t662 * t669;
        let t699 = t689 * (t82 + t638 * t690 + t653 * t693 + t674 * t696);
        let t706 = t689 * (t24 + t639 * t690 + t656 * t693 + t679 * t696);
        let t714 = t662 * (t674 * t674);
        let t717 = t688 * (t699 * t699);
        let t718 = t70 - t218 * (t638 * t638) - t642 * (t653 * t653) - t714 - t717;
        let t719 = k4 / t718;
        let t727 = t679 * (t662 * t674);
        let t730 = t706 * (t688 * t699);
        let t731 = t16 - t639 * (t218 * t638) - t656 * (t642 * t653) - t727 - t730;
        let t732 = t719 * t731;
        let t740 = t662 * (t679 * t679);
        let t743 = t688 * (t706 * t706);
        let t744 = t0 - t218 * (t639 * t639) - t642 * (t656 * t656) - t740 - t743;
        let t748 = k4 / (t744 - t718 * (t732 * t732));
        [
        t634, t635, t636, t637, t638, t639, t643, t647,
        t650, t653, t656, t663, t669, t674, t679, t689,
        t699, t706, t719, t732, t748,
    ]
    };
    // ddq
    {
        let t750 = t629 + t628 * t635;
        let t754 = t630 + t628 * t636 + t647 * t750;
        let t760 = t631 + t628 * t637 - t650 * t750 - t669 * t754;
        let t768 = t632 + t628 * t638 - t653 * t750 - t674 * t754 + t699 * t760;
        let t776 = t633 + t628 * t639 - t656 * t750 - t679 * t754 + t706 * t760;
        let t784 = t748 * (t776 - t732 * t768);
        let t786 = t719 * t768 - t732 * t784;
        let t790 = t689 * t760 + t699 * t786 + t706 * t784;
        let t796 = t663 * t754 - t669 * t790 - t674 * t786 - t679 * t784;
        let t803 = t656 * t784;
        let t804 = t643 * t750 + t647 * t796 - t650 * t790 - t653 * t786 - t803;
        let t811 = t638 * t786;
        let t812 = t628 * t634 + t635 * t804 + t636 * t796 + t637 * t790 + t811;
        let t814 = t812 + t639 * t784;
        put(0, t814);
        put(1, t804);
        put(2, t796);
        put(3, t790);
        put(4, t786);
        put(5, t784);
    }
}
