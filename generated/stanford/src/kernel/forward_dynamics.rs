//! Accelerations under given torques.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` in
//! closed form.
//!
//! 447 multiplications, 362 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, GRAVITY, Trig, constants};

/// Accelerations under given torques: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE], out: &mut [S; 6]) {
    entries(trig, dq, tau, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
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
    let k2 = S::constant(-GRAVITY[2]);
    let k3 = S::constant(2.0);
    let k4 = S::constant(1.0);
    let k_D2 = S::constant(constants::D2);
    let k_D6 = S::constant(constants::D6);
    // composite body 6
    let [
        t0, t3, t6, t15, t16, t18, t24, t40,
        t48, t57, t60, t63,
    ] = {
        let t0 = ZZ6 + IA6;
        let t3 = c6 * MSY6 + s6 * MSX6;
        let t6 = c6 * MSX6 - s6 * MSY6;
        let t15 = c6 * XZ6 - s6 * YZ6 - k_D6 * t6;
        let t16 = s6 * XZ6 + c6 * YZ6 - k_D6 * t3;
        let t17 = c5 * t3;
        let t18 = s5 * t3;
        let t21 = c5 * t15 + s5 * ZZ6;
        let t24 = s5 * t15 - c5 * ZZ6;
        let t30 = c4 * t6 - s4 * t17;
        let t39 = s4 * t21 + c4 * t16 - q3 * (c4 * t17 + s4 * t6);
        let t40 = q3 * t30 - (c4 * t21 - s4 * t16);
        let t48 = s2 * t39 + c2 * t24 + k_D2 * (c2 * t30 + s2 * t18);
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
        let t102 = t100 + k_D2 * (c2 * t84 - s2 * t76);
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
        let t151 = k_D2 * (c2 * t135) - (s2 * (t141 + q3 * t132) + c2 * t125);
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
        let t178 = k_D2 * (s2 * M3R) - s2 * t171;
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
        let t202 = k_D2 * (c2 * (MSZ2 + t180) - s2 * (MSX2 + t172));
        let t203 = s2 * (XY2R - t167) - c2 * (YZ2R + t188) + t202;
        let t211 = c2 * (s2 * t193 + c2 * (ZZ2R + t125));
        let t216 = k_D2 * (k_D2 * M3R - t171 - t171);
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
        t220, t221, t222, t223, w3_z, t225, t226, t227,
        dw2_y, t229, t230, t231, t232,
    ] = {
        let t220 = s2 * k2;
        let t221 = c2 * k2;
        let t222 = k_D2 * t219;
        let t223 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t225 = t223 * t223;
        let t226 = dq2 * dq2;
        let t227 = t223 * w3_z;
        let dw2_y = dq2 * t223;
        let t229 = dq2 * w3_z;
        let t230 = t225 + t226;
        let t231 = dw2_y + dw2_y;
        let t232 = t229 + t229;
        [
        t220, t221, t222, t223, w3_z, t225, t226, t227,
        dw2_y, t229, t230, t231, t232,
    ]
    };
    // link 3: motion
    let [t237, t242, a3_y, t245, t246] = {
        let t237 = q3 * t230 - t221;
        let t239 = dq3 * k3;
        let t242 = q3 * t232 - t222 + t223 * t239;
        let a3_y = dq2 * t239 - (t220 + q3 * t227);
        let t244 = w3_z * w3_z;
        let t245 = t225 + t244;
        let t246 = t226 + t244;
        [t237, t242, a3_y, t245, t246]
    };
    // link 4: motion
    let [
        a4_x, a4_y, t255, w4_y, t261, t264, w4_z, t266,
        t267, t268, t269, t270, dw4_y, t273, t274, t275,
        t276, t277,
    ] = {
        let a4_x = s4 * a3_y - c4 * t242;
        let a4_y = c4 * a3_y + s4 * t242;
        let t255 = c4 * dq2 + s4 * t223;
        let w4_y = s4 * dq2 - c4 * t223;
        let t261 = c4 * t232 + s4 * t227;
        let t264 = s4 * t232 - c4 * t227;
        let w4_z = w3_z + dq4;
        let t266 = t255 * t255;
        let t267 = w4_z * w4_z;
        let t268 = t255 * w4_y;
        let t269 = t255 * w4_z;
        let t270 = w4_y * w4_z;
        let dw4_x = t270 - t264;
        let dw4_y = t269 - t261;
        let t273 = dw2_y - t268;
        let t274 = dw2_y + t268;
        let t275 = t266 + t267;
        let t276 = t269 + dw4_y;
        let t277 = t270 + dw4_x;
        [
        a4_x, a4_y, t255, w4_y, t261, t264, w4_z, t266,
        t267, t268, t269, t270, dw4_y, t273, t274, t275,
        t276, t277,
    ]
    };
    // link 5: motion
    let [
        a5_x, a5_y, t286, w5_y, t292, t295, w5_z, t297,
        t298, t299, t300, t301, dw5_y, t304, t305, t306,
        t307, t308,
    ] = {
        let a5_x = c5 * a4_x + s5 * t237;
        let a5_y = c5 * t237 - s5 * a4_x;
        let t286 = c5 * t255 + s5 * w4_z;
        let w5_y = s5 * t255 - c5 * w4_z;
        let t292 = c5 * t273 - s5 * t277;
        let t295 = c5 * t277 + s5 * t273;
        let w5_z = w4_y + dq5;
        let t297 = t286 * t286;
        let t298 = w5_z * w5_z;
        let t299 = t286 * w5_y;
        let t300 = t286 * w5_z;
        let t301 = w5_y * w5_z;
        let dw5_x = t295 + t301;
        let dw5_y = t292 + t300;
        let t304 = dw4_y + t299;
        let t305 = dw4_y - t299;
        let t306 = t297 + t298;
        let t307 = t300 + dw5_y;
        let t308 = t301 + dw5_x;
        [
        a5_x, a5_y, t286, w5_y, t292, t295, w5_z, t297,
        t298, t299, t300, t301, dw5_y, t304, t305, t306,
        t307, t308,
    ]
    };
    // link 6: motion
    let [
        t311, t314, t323, t326, t330, t331, t332, dw6_x,
        t335, t336, t337, t338, t339, t340, t341,
    ] = {
        let t311 = c6 * a5_x + s6 * a4_y;
        let t314 = c6 * a4_y - s6 * a5_x;
        let w6_x = s6 * w5_z - c6 * t286;
        let w6_y = c6 * w5_z + s6 * t286;
        let t323 = c6 * t304 - s6 * t308;
        let t326 = c6 * t308 + s6 * t304;
        let w6_z = dq6 - w5_y;
        let t328 = w6_x * w6_x;
        let t329 = w6_z * w6_z;
        let t330 = w6_x * w6_y;
        let t331 = w6_x * w6_z;
        let t332 = w6_y * w6_z;
        let dw6_x = t326 + t332;
        let dw6_y = t323 - t331;
        let t335 = t328 - t329;
        let t336 = t335 - t306;
        let t337 = dw5_y + t330;
        let t338 = t330 - dw5_y;
        let t339 = t328 + t329;
        let t340 = t331 - dw6_y;
        let t341 = t332 + dw6_x;
        [
        t311, t314, t323, t326, t330, t331, t332, dw6_x,
        t335, t336, t337, t338, t339, t340, t341,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t393, t396, t399, t402] = {
        let t343 = XZ6 - k_D6 * MSX6;
        let t345 = YZ6 - k_D6 * MSY6;
        let t366 = XY6 * (t336 + t339) - (XX6R * t330 + ZZ6 * dw5_y) + t326 * t343;
        let t368 = t345 * (t306 - t339);
        let t371 = ZZ6 * t332 + XX6R * dw6_x - XY6 * t340 + t338 * t343 + t368;
        let t372 = t331 * (XX6R - ZZ6) + XY6 * t341 - t335 * t343 - t337 * t345;
        let f6_x = MSX6 * t336 + MSY6 * t337;
        let f6_y = MSX6 * t338 - MSY6 * t339;
        let f6_z = MSX6 * t340 + MSY6 * t341;
        let n6_x = t371 - MSY6 * a5_y;
        let n6_y = t372 + MSX6 * a5_y;
        let n6_z = t366 + t323 * t345 + (MSX6 * t314 - MSY6 * t311);
        let t393 = c6 * f6_x - s6 * f6_y;
        let t396 = s6 * f6_x + c6 * f6_y;
        let t399 = c6 * n6_x - s6 * n6_y;
        let t402 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t393, t396, t399, t402]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t460, t463, t466, t469] = {
        let t403 = w5_y * w5_y;
        let t404 = t298 + t403;
        let t405 = t297 + t403;
        let t426 = YY5R * dw4_y - ZZ5R * t299 + XY5 * t295 + XZ5 * (t404 - t306);
        let t427 = XY5 * (t405 - t404) - (YY5R * t300 + ZZ5R * dw5_y) + XZ5 * t308;
        let t429 = YZ5 * (t306 - t405);
        let t444 = MSZ5R * a4_y;
        let t449 = XY5 * t305 - t301 * (ZZ5R - YY5R) - XZ5 * t307 + t429 - t444;
        let f5_x = t393 + (MSZ5R * t304 - MSX5 * t404);
        let f5_y = MSX5 * t305 + MSZ5R * t306 - f6_z;
        let f5_z = t396 - (MSX5 * t307 + MSZ5R * t308);
        let n5_x = t399 + t449;
        let t456 = n6_z + (t427 + YZ5 * t304 + MSX5 * a4_y);
        let n5_z = t402 + (t426 - YZ5 * t292 + (MSZ5R * a5_x + MSX5 * a5_y));
        let t460 = c5 * f5_x - s5 * f5_y;
        let t463 = s5 * f5_x + c5 * f5_y;
        let t466 = c5 * n5_x + s5 * t456;
        let t469 = s5 * n5_x - c5 * t456;
        [f5_z, n5_z, t460, t463, t466, t469]
    };
    // link 4: force and moment
    let [t521, t524, t527, t530, t533, t536] = {
        let t470 = w4_y * w4_y;
        let t471 = t267 + t470;
        let t472 = t266 + t470;
        let t493 = ZZ4R * t268 + YY4R * dw2_y - XY4 * t264 + XZ4 * (t471 - t275);
        let t494 = YY4R * t269 + ZZ4R * dw4_y + XY4 * (t472 - t471) + XZ4 * t277;
        let t496 = YZ4 * (t275 - t472);
        let t511 = MSZ4R * t237;
        let t516 = XY4 * t274 - t270 * (ZZ4R - YY4R) + XZ4 * t276 + t496 - t511;
        let f4_x = t460 + (MSZ4R * t273 - MSX4 * t471);
        let f4_y = f5_z - (MSX4 * t274 + MSZ4R * t275);
        let t521 = t463 + (MSX4 * t276 - MSZ4R * t277);
        let n4_x = t466 + t516;
        let n4_y = n5_z + (t494 + YZ4 * t273 + MSX4 * t237);
        let t524 = t469 + (t493 - YZ4 * t261 + (MSZ4R * a4_x - MSX4 * a4_y));
        let t527 = c4 * f4_x - s4 * f4_y;
        let t530 = s4 * f4_x + c4 * f4_y;
        let t533 = c4 * n4_x - s4 * n4_y;
        let t536 = s4 * n4_x + c4 * n4_y;
        [t521, t524, t527, t530, t533, t536]
    };
    // link 3: force and moment
    let [t537, t538, t539, f3_y, t568, n3_z, t574, t575] = {
        let t537 = t246 - t245;
        let t538 = t245 - t230;
        let t539 = t230 - t246;
        let f3_x = t527 + (MSY3 * t231 - MSX3 * t245 - MSZ3R * t232 - M3R * t242);
        let f3_y = t530 + (M3R * a3_y - (MSY3 * t246 + MSZ3R * t227));
        let t568 = t521 + (M3R * t237 + (MSY3 * t227 + MSZ3R * t230));
        let n3_x = t533 - (MSY3 * t237 + MSZ3R * a3_y);
        let n3_y = t536 + (MSX3 * t237 - MSZ3R * t242);
        let n3_z = MSX3 * a3_y + MSY3 * t242 - t524;
        let t574 = n3_y + q3 * f3_x;
        let t575 = q3 * f3_y - n3_x;
        [t537, t538, t539, f3_y, t568, n3_z, t574, t575]
    };
    // link 2: force and moment
    let [n2_z, t621] = {
        let t593 = t229 * (ZZ2R - YY2R) + XY2R * t227 - XZ2R * t231 - YZ2R * t538;
        let t594 = dw2_y * (YY2R + ZZ2R) + XY2R * t537 + XZ2R * t232 + YZ2R * t227;
        let f2_x = f3_y - (MSX2 * t246 + MSZ2 * t227);
        let f2_y = t568 + (MSX2 * t227 + MSZ2 * t230);
        let n2_x = t574 + (t593 + MSZ2 * t222);
        let n2_y = t594 + MSX2 * t222 - n3_z;
        let n2_z = t575 + (ZZ2R * t227 - XZ2R * t539 - (MSZ2 * t220 + MSX2 * t221));
        let f1_x = c2 * f2_x - s2 * f2_y;
        let t621 = s2 * n2_x + c2 * n2_y + k_D2 * f1_x;
        [n2_z, t621]
    };
    // drives
    let [t622, t623, t624, t625, t626, t627] = {
        let t622 = t621 + tau1;
        let t623 = tau2 - n2_z;
        let t624 = t568 + tau3;
        let t625 = t524 + tau4;
        let t626 = tau5 - n5_z;
        let t627 = tau6 - n6_z;
        [t622, t623, t624, t625, t626, t627]
    };
    // M = L D L'
    let [
        t628, t629, t630, t631, t632, t633, t637, t641,
        t644, t647, t650, t657, t663, t668, t673, t683,
        t693, t700, t713, t726, t742,
    ] = {
        let t628 = k4 / t218;
        let t629 = t203 * t628;
        let t630 = t178 * t628;
        let t631 = t151 * t628;
        let t632 = t102 * t628;
        let t633 = t48 * t628;
        let t636 = t192 - t218 * (t629 * t629);
        let t637 = k4 / t636;
        let t638 = t218 * t629;
        let t641 = t637 * (t172 + t630 * t638);
        let t644 = t637 * (t145 - t631 * t638);
        let t647 = t637 * (t94 - t632 * t638);
        let t650 = t637 * (t40 - t633 * t638);
        let t656 = t174 - t218 * (t630 * t630) - t636 * (t641 * t641);
        let t657 = k4 / t656;
        let t658 = t218 * t630;
        let t660 = t636 * t641;
        let t663 = t657 * (t644 * t660 - t631 * t658);
        let t668 = t657 * (t647 * t660 - (t76 + t632 * t658));
        let t673 = t657 * (t18 - t633 * t658 + t650 * t660);
        let t681 = t656 * (t663 * t663);
        let t682 = t129 - t218 * (t631 * t631) - t636 * (t644 * t644) - t681;
        let t683 = k4 / t682;
        let t684 = t218 * t631;
        let t687 = t636 * t644;
        let t690 = t656 * t663;
        let t693 = t683 * (t82 + t632 * t684 + t647 * t687 + t668 * t690);
        let t700 = t683 * (t24 + t633 * t684 + t650 * t687 + t673 * t690);
        let t708 = t656 * (t668 * t668);
        let t711 = t682 * (t693 * t693);
        let t712 = t70 - t218 * (t632 * t632) - t636 * (t647 * t647) - t708 - t711;
        let t713 = k4 / t712;
        let t721 = t673 * (t656 * t668);
        let t724 = t700 * (t682 * t693);
        let t725 = t16 - t633 * (t218 * t632) - t650 * (t636 * t647) - t721 - t724;
        let t726 = t713 * t725;
        let t734 = t656 * (t673 * t673);
        let t737 = t682 * (t700 * t700);
        let t738 = t0 - t218 * (t633 * t633) - t636 * (t650 * t650) - t734 - t737;
        let t742 = k4 / (t738 - t712 * (t726 * t726));
        [
        t628, t629, t630, t631, t632, t633, t637, t641,
        t644, t647, t650, t657, t663, t668, t673, t683,
        t693, t700, t713, t726, t742,
    ]
    };
    // ddq
    {
        let t744 = t623 + t622 * t629;
        let t748 = t624 + t622 * t630 + t641 * t744;
        let t754 = t625 + t622 * t631 - t644 * t744 - t663 * t748;
        let t762 = t626 + t622 * t632 - t647 * t744 - t668 * t748 + t693 * t754;
        let t770 = t627 + t622 * t633 - t650 * t744 - t673 * t748 + t700 * t754;
        let t778 = t742 * (t770 - t726 * t762);
        let t780 = t713 * t762 - t726 * t778;
        let t784 = t683 * t754 + t693 * t780 + t700 * t778;
        let t790 = t657 * t748 - t663 * t784 - t668 * t780 - t673 * t778;
        let t797 = t650 * t778;
        let t798 = t637 * t744 + t641 * t790 - t644 * t784 - t647 * t780 - t797;
        let t805 = t632 * t780;
        let t806 = t622 * t628 + t629 * t798 + t630 * t790 + t631 * t784 + t805;
        let t808 = t806 + t633 * t778;
        put(0, t808);
        put(1, t798);
        put(2, t790);
        put(3, t784);
        put(4, t780);
        put(5, t778);
    }
}
