//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 505 multiplications, 421 additions; 6, 6 of 6 structurally nonzero.

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
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [tau1, tau2, tau3, tau4, tau5, tau6] = *tau;
    let [
        ZZ1R, MSX2R, MSY2, XX2R, ZZ2R, XY2, XZ2R, YZ2, MSX3R, MSY3, XX3R, ZZ3R,
        XY3, XZ3R, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        ..] = *beta;
    let D4 = S::constant(0.17415);
    let D5 = S::constant(0.11985);
    let D6 = S::constant(0.11655);
    let k3 = S::constant(0.57155);
    let k4 = S::constant(0.6127);
    let k5 = S::constant(9.81);
    let k6 = S::constant(1.0);
    // composite body 6
    let [
        t2, t5, t14, t15, t19, t22, t27, t47,
        t60, t63, t72, t75, t78, t79,
    ] = {
        let t2 = c6 * MSY6 + s6 * MSX6;
        let t5 = c6 * MSX6 - s6 * MSY6;
        let t14 = c6 * XZ6 - s6 * YZ6 - D6 * t5;
        let t15 = s6 * XZ6 + c6 * YZ6 - D6 * t2;
        let t16 = c5 * t2;
        let t17 = s5 * t2;
        let t19 = s5 * ZZ6;
        let t22 = c5 * ZZ6;
        let t26 = c5 * t14 - t19 + D5 * t17;
        let t27 = s5 * t14 + t22 - D5 * t16;
        let t30 = c4 * t16 + s4 * t5;
        let t33 = c4 * t5 - s4 * t16;
        let t45 = c4 * t26 - s4 * t15 - D4 * t33;
        let t46 = s4 * t26 + c4 * t15 - (D4 * t30 + t17 * k3);
        let t47 = t27 - t33 * k3;
        let t60 = t47 - (c3 * t33 - s3 * t30) * k4;
        let t62 = c2 * (s3 * t45 + c3 * t46 - t17 * k4);
        let t63 = s2 * (c3 * t45 - s3 * t46) + t62;
        let t65 = s6 * XY6;
        let t68 = c6 * XY6;
        let t69 = s6 * XX6R + t68;
        let t72 = c6 * (c6 * XX6R - t65) - s6 * t68;
        let t75 = c6 * t69 - s6 * t65;
        let t78 = s6 * t69 + c6 * t65;
        let t79 = t2 + t2;
        [
        t2, t5, t14, t15, t19, t22, t27, t47,
        t60, t63, t72, t75, t78, t79,
    ]
    };
    // composite body 5
    let [
        t82, t88, t91, t100, t101, t117, t130, t133,
        t147, t151, t153, t154, t158,
    ] = {
        let t80 = MSX5 + t5;
        let t81 = XX5R + t72;
        let t82 = ZZ5R + t78;
        let t83 = XY5 + t14;
        let t84 = XZ5 - t75;
        let t85 = YZ5 - t15;
        let t88 = c5 * MSY5R + s5 * t80;
        let t91 = c5 * t80 - s5 * MSY5R;
        let t100 = c5 * t84 - s5 * t85 - D5 * t91;
        let t101 = s5 * t84 + c5 * t85 - D5 * t88;
        let t102 = c4 * t88;
        let t103 = s4 * t88;
        let t115 = c4 * t100 + s4 * t82 + D4 * t103;
        let t116 = s4 * t100 - c4 * t82 + (k3 * t91 - D4 * t102);
        let t117 = t101 + k3 * t103;
        let t130 = t117 + k4 * (s3 * t102 + c3 * t103);
        let t132 = c2 * (s3 * t115 + c3 * t116 + k4 * t91);
        let t133 = s2 * (c3 * t115 - s3 * t116) + t132;
        let t135 = s5 * t83;
        let t138 = c5 * t83;
        let t139 = s5 * t81 + t138;
        let t141 = t22 + t135;
        let t147 = c5 * t139 - s5 * t141;
        let t151 = t88 + t88;
        let t152 = D5 * t79;
        let t153 = c5 * (c5 * t81 - t135) - s5 * (t138 - t19) - t152;
        let t154 = s5 * t139 + c5 * t141 - t152;
        let t156 = D5 * t2;
        let t158 = t82 - t152 + (t156 + t156);
        [
        t82, t88, t91, t100, t101, t117, t130, t133,
        t147, t151, t153, t154, t158,
    ]
    };
    // composite body 4
    let [
        t162, t168, t171, t182, t183, t194, t197, t223,
        t225, t228, t229, t233,
    ] = {
        let t159 = MSX4 + t91;
        let t160 = MSY4R + t2;
        let t161 = XX4R + t153;
        let t162 = ZZ4R + t154;
        let t163 = XY4 - t100;
        let t164 = XZ4 + t147;
        let t165 = YZ4 - t101;
        let t168 = c4 * t160 + s4 * t159;
        let t171 = c4 * t159 - s4 * t160;
        let t174 = c4 * t164 - s4 * t165;
        let t178 = D4 * t171;
        let t180 = k3 * t171;
        let t181 = t174 - t178;
        let t182 = s4 * t164 + c4 * t165 - D4 * t168;
        let t183 = t162 - t180;
        let t194 = t183 - k4 * (c3 * t171 - s3 * t168);
        let t196 = c2 * (s3 * t181 + c3 * t182);
        let t197 = s2 * (c3 * t181 - s3 * t182) + t196;
        let t199 = s4 * t163;
        let t202 = c4 * t163;
        let t203 = s4 * t161 + t202;
        let t207 = t199 + c4 * t158;
        let t220 = D4 * t151 - k3 * (t171 + t171);
        let t221 = c4 * (c4 * t161 - t199) - s4 * (t202 - s4 * t158) + t220;
        let t223 = t221 + (t180 + t180);
        let t225 = c4 * t203 - s4 * t207 + k3 * t168;
        let t228 = t174 - (t178 - k3 * t88);
        let t229 = s4 * t203 + c4 * t207 + t220;
        let t231 = D4 * t88;
        let t233 = t162 + t220 - (t231 + t231);
        [
        t162, t168, t171, t182, t183, t194, t197, t223,
        t225, t228, t229, t233,
    ]
    };
    // composite body 3
    let [
        t237, t252, t254, t257, t281, t283, t285, t286,
        t287,
    ] = {
        let t234 = MSX3R + t171;
        let t235 = MSY3 + t168;
        let t236 = XX3R + t223;
        let t237 = ZZ3R + t233;
        let t238 = XY3 + t225;
        let t239 = XZ3R + t228;
        let t240 = YZ3 + t182;
        let t246 = c3 * t234 - s3 * t235;
        let t249 = c3 * t239 - s3 * t240;
        let t252 = s3 * t239 + c3 * t240;
        let t253 = k4 * t246;
        let t254 = t237 - t253;
        let t257 = s2 * t249 + c2 * t252;
        let t259 = s3 * t238;
        let t262 = c3 * t238;
        let t263 = s3 * t236 + t262;
        let t267 = t259 + c3 * t229;
        let t278 = k4 * (t246 + t246);
        let t279 = c3 * (c3 * t236 - t259) - s3 * (t262 - s3 * t229) - t278;
        let t281 = t279 + (t253 + t253);
        let t283 = c3 * t263 - s3 * t267 + k4 * (c3 * t235 + s3 * t234);
        let t285 = t249 + k4 * t88;
        let t286 = s3 * t263 + c3 * t267 - t278;
        let t287 = t237 - t278;
        [
        t237, t252, t254, t257, t281, t283, t285, t286,
        t287,
    ]
    };
    // composite body 2
    let [t289, t295, t304] = {
        let t289 = ZZ2R + t287;
        let t290 = XY2 + t283;
        let t295 = s2 * (XZ2R + t285) + c2 * (YZ2 + t252);
        let t303 = c2 * (s2 * t290 + c2 * t286);
        let t304 = s2 * (s2 * (XX2R + t281) + c2 * t290) + t303;
        [t289, t295, t304]
    };
    // composite body 1
    let t305 = {
        let t305 = ZZ1R + t304;
        t305
    };
    // link 1: motion
    let t306 = {
        let t306 = dq1 * dq1;
        t306
    };
    // link 2: motion
    let [
        w2_x, w2_y, a2_x, a2_y, t313, t314, dw2_x, t316,
        t317, t318, t319, t320,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let a2_x = s2 * k5;
        let a2_y = c2 * k5;
        let t311 = w2_x * w2_x;
        let t312 = dq2 * dq2;
        let t313 = w2_x * w2_y;
        let t314 = dq2 * w2_x;
        let dw2_x = dq2 * w2_y;
        let t316 = t311 - t312;
        let t317 = t316 - t306;
        let t318 = t311 + t312;
        let t319 = t314 + t314;
        let t320 = dw2_x + dw2_x;
        [
        w2_x, w2_y, a2_x, a2_y, t313, t314, dw2_x, t316,
        t317, t318, t319, t320,
    ]
    };
    // link 3: motion
    let [
        w3_x, w3_y, t329, a3_x, a3_y, w3_z, t341, t342,
        dw3_x, t344, t345, t346, t347, t348,
    ] = {
        let w3_x = c3 * w2_x + s3 * w2_y;
        let w3_y = c3 * w2_y - s3 * w2_x;
        let t329 = k4 * t319;
        let t330 = a2_x - k4 * t317;
        let t331 = a2_y - k4 * t313;
        let a3_x = c3 * t330 + s3 * t331;
        let a3_y = c3 * t331 - s3 * t330;
        let w3_z = dq2 + dq3;
        let t339 = w3_x * w3_x;
        let t340 = w3_z * w3_z;
        let t341 = w3_x * w3_y;
        let t342 = w3_x * w3_z;
        let dw3_x = w3_y * w3_z;
        let t344 = t339 - t340;
        let t345 = t344 - t306;
        let t346 = t339 + t340;
        let t347 = t342 + t342;
        let t348 = dw3_x + dw3_x;
        [
        w3_x, w3_y, t329, a3_x, a3_y, w3_z, t341, t342,
        dw3_x, t344, t345, t346, t347, t348,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, a4_x, a4_y, t368, w4_z, t372, dw5_z,
        dw4_x, t375, t376, t377, t378, t379,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_y;
        let w4_y = c4 * w3_y - s4 * w3_x;
        let t358 = a3_x - k3 * t345;
        let t359 = a3_y - k3 * t341;
        let a4_x = c4 * t358 + s4 * t359;
        let a4_y = c4 * t359 - s4 * t358;
        let t368 = t329 + (k3 * t347 + D4 * t306);
        let w4_z = w3_z + dq4;
        let t370 = w4_x * w4_x;
        let t371 = w4_z * w4_z;
        let t372 = w4_x * w4_y;
        let dw5_z = w4_x * w4_z;
        let dw4_x = w4_y * w4_z;
        let t375 = t370 - t371;
        let t376 = t375 - t306;
        let t377 = t370 + t371;
        let t378 = dw5_z + dw5_z;
        let t379 = dw4_x + dw4_x;
        [
        w4_x, w4_y, a4_x, a4_y, t368, w4_z, t372, dw5_z,
        dw4_x, t375, t376, t377, t378, t379,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t390, a5_x, t397, t400, t403, w5_z,
        t407, t408, t409, dw5_x, t411, t412, t413, t414,
        t415, t416, t417, t418,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t389 = a4_x - D5 * t372;
        let t390 = a4_y + D5 * t377;
        let t391 = t368 + D5 * t379;
        let a5_x = c5 * t389 - s5 * t391;
        let t397 = c5 * t391 + s5 * t389;
        let t400 = c5 * t372 + s5 * t379;
        let t403 = s5 * t372 - c5 * t379;
        let w5_z = dq5 - w4_y;
        let t405 = w5_x * w5_x;
        let t406 = w5_z * w5_z;
        let t407 = w5_x * w5_y;
        let t408 = w5_x * w5_z;
        let t409 = w5_y * w5_z;
        let dw5_x = t409 - t403;
        let t411 = t400 + t408;
        let t412 = t405 - t406;
        let t413 = t412 - t377;
        let t414 = t407 - dw5_z;
        let t415 = dw5_z + t407;
        let t416 = t405 + t406;
        let t417 = t408 + t411;
        let t418 = t409 + dw5_x;
        [
        w5_x, w5_y, t390, a5_x, t397, t400, t403, w5_z,
        t407, t408, t409, dw5_x, t411, t412, t413, t414,
        t415, t416, t417, t418,
    ]
    };
    // link 6: motion
    let [
        t429, a6_x, t436, t439, t442, t446, t447, t448,
        dw6_x, t451, t452, t453, t454, t455, t456, t457,
    ] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t424 = c6 * w5_z + s6 * w5_x;
        let t428 = a5_x + D6 * t414;
        let t429 = t397 + D6 * t416;
        let t430 = D6 * t418 - t390;
        let a6_x = c6 * t428 - s6 * t430;
        let t436 = c6 * t430 + s6 * t428;
        let t439 = c6 * t414 - s6 * t418;
        let t442 = c6 * t418 + s6 * t414;
        let w6_z = w5_y + dq6;
        let t444 = w6_x * w6_x;
        let t445 = w6_z * w6_z;
        let t446 = w6_x * t424;
        let t447 = w6_x * w6_z;
        let t448 = t424 * w6_z;
        let dw6_x = t442 - t448;
        let dw6_y = t439 - t447;
        let t451 = t444 - t445;
        let t452 = t451 - t416;
        let t453 = t411 - t446;
        let t454 = t411 + t446;
        let t455 = t444 + t445;
        let t456 = t447 - dw6_y;
        let t457 = dw6_x - t448;
        [
        t429, a6_x, t436, t439, t442, t446, t447, t448,
        dw6_x, t451, t452, t453, t454, t455, t456, t457,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t505, t508, t517, t518] = {
        let t478 = XX6R * t446 - ZZ6 * t411 + XY6 * (t452 + t455) + XZ6 * t442;
        let t480 = YZ6 * (t416 - t455);
        let t483 = XX6R * dw6_x - ZZ6 * t448 - XY6 * t456 - XZ6 * t454 + t480;
        let t484 = t447 * (XX6R - ZZ6) + XY6 * t457 - XZ6 * t451 - YZ6 * t453;
        let f6_x = MSX6 * t452 + MSY6 * t453;
        let t491 = MSX6 * t454 + MSY6 * t455;
        let f6_z = MSX6 * t456 + MSY6 * t457;
        let n6_x = t483 - MSY6 * t429;
        let n6_y = t484 + MSX6 * t429;
        let n6_z = t478 + YZ6 * t439 - (MSX6 * t436 + MSY6 * a6_x);
        let t505 = c6 * f6_x + s6 * t491;
        let t508 = s6 * f6_x - c6 * t491;
        let t517 = c6 * n6_x - s6 * n6_y - D6 * t508;
        let t518 = s6 * n6_x + c6 * n6_y + D6 * t505;
        [f6_z, n6_z, t505, t508, t517, t518]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t572, t575, t584, t585] = {
        let t539 = ZZ5R * dw5_z - XX5R * t407 + XY5 * (t413 + t416) - XZ5 * t403;
        let t541 = YZ5 * (t377 - t416);
        let t544 = ZZ5R * t409 + XX5R * dw5_x - XY5 * t417 + XZ5 * t415 + t541;
        let t545 = t408 * (XX5R - ZZ5R) + XY5 * t418 - XZ5 * t412 - YZ5 * t414;
        let f5_x = t505 + (MSX5 * t413 + MSY5R * t414);
        let f5_y = f6_z + (MSX5 * t415 - MSY5R * t416);
        let f5_z = MSX5 * t417 + MSY5R * t418 - t508;
        let n5_x = t517 + (t544 - MSY5R * t390);
        let n5_y = n6_z + (t545 + MSX5 * t390);
        let n5_z = t539 - YZ5 * t400 - (MSX5 * t397 + MSY5R * a5_x) - t518;
        let t572 = c5 * f5_x - s5 * f5_y;
        let t575 = s5 * f5_x + c5 * f5_y;
        let t584 = c5 * n5_x - s5 * n5_y - D5 * t575;
        let t585 = s5 * n5_x + c5 * n5_y + D5 * t572;
        [f5_z, n5_z, t572, t575, t584, t585]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t632, t635, t647, t648, t649] = {
        let t603 = YZ4 * (t306 - t377);
        let t606 = dw5_z * (XX4R - ZZ4R) + XY4 * t379 - XZ4 * t375 - YZ4 * t372;
        let t616 = MSY4R * t368;
        let t621 = dw4_x * (XX4R + ZZ4R) - XY4 * t378 + XZ4 * t372 + t603 - t616;
        let t623 = XY4 * (t376 + t377) - XX4R * t372 + (MSX4 * a4_y - MSY4R * a4_x);
        let f4_x = t572 + (MSX4 * t376 + MSY4R * t372);
        let f4_y = MSX4 * t372 - MSY4R * t377 - f5_z;
        let f4_z = t575 + (MSX4 * t378 + MSY4R * t379);
        let n4_x = t584 + t621;
        let n4_y = t606 + MSX4 * t368 - n5_z;
        let n4_z = t585 + t623;
        let t632 = c4 * f4_x - s4 * f4_y;
        let t635 = s4 * f4_x + c4 * f4_y;
        let t647 = c4 * n4_x - s4 * n4_y - D4 * t635;
        let t648 = s4 * n4_x + c4 * n4_y + (D4 * t632 + k3 * f4_z);
        let t649 = n4_z - k3 * t635;
        [f4_z, n4_z, t632, t635, t647, t648, t649]
    };
    // link 3: force and moment
    let [n3_z, t699, t705, t706] = {
        let t667 = YZ3 * (t306 - t346);
        let t670 = t342 * (XX3R - ZZ3R) + XY3 * t348 - XZ3R * t344 - YZ3 * t341;
        let t680 = MSY3 * t329;
        let t685 = dw3_x * (XX3R + ZZ3R) - XY3 * t347 + XZ3R * t341 + t667 - t680;
        let t687 = XY3 * (t345 + t346) - XX3R * t341 + (MSX3R * a3_y - MSY3 * a3_x);
        let f3_x = t632 + (MSX3R * t345 + MSY3 * t341);
        let f3_y = t635 + (MSX3R * t341 - MSY3 * t346);
        let f3_z = f4_z + (MSX3R * t347 + MSY3 * t348);
        let n3_x = t647 + t685;
        let n3_y = t648 + (t670 + MSX3R * t329);
        let n3_z = t649 + t687;
        let t699 = c3 * n3_x - s3 * n3_y;
        let t705 = s3 * n3_x + c3 * n3_y + k4 * f3_z;
        let t706 = n3_z - k4 * (s3 * f3_x + c3 * f3_y);
        [n3_z, t699, t705, t706]
    };
    // link 2: force and moment
    let [n2_z, n1_z] = {
        let t724 = YZ2 * (t306 - t318);
        let t727 = t314 * (XX2R - ZZ2R) + XY2 * t320 - XZ2R * t316 - YZ2 * t313;
        let t731 = XY2 * (t317 + t318) - XX2R * t313 + (MSX2R * a2_y - MSY2 * a2_x);
        let n2_x = t699 + (dw2_x * (XX2R + ZZ2R) - XY2 * t319 + XZ2R * t313 + t724);
        let n2_y = t705 + t727;
        let n2_z = t706 + t731;
        let n1_z = s2 * n2_x + c2 * n2_y;
        [n2_z, n1_z]
    };
    // drives
    let [t738, t739, t740, t741, t742, t743] = {
        let t738 = tau1 - n1_z;
        let t739 = tau2 - n2_z;
        let t740 = tau3 - n3_z;
        let t741 = tau4 - n4_z;
        let t742 = tau5 - n5_z;
        let t743 = tau6 - n6_z;
        [t738, t739, t740, t741, t742, t743]
    };
    // M = L D L'
    let [
        t744, t745, t746, t747, t748, t749, t753, t757,
        t760, t763, t766, t773, t780, t785, t790, t800,
        t810, t817, t830, t843, t859,
    ] = {
        let t744 = k6 / t305;
        let t745 = t295 * t744;
        let t746 = t257 * t744;
        let t747 = t197 * t744;
        let t748 = t133 * t744;
        let t749 = t63 * t744;
        let t752 = t289 - t305 * (t745 * t745);
        let t753 = k6 / t752;
        let t754 = t305 * t745;
        let t757 = t753 * (t254 - t746 * t754);
        let t760 = t753 * (t194 - t747 * t754);
        let t763 = t753 * (t130 - t748 * t754);
        let t766 = t753 * (t60 - t749 * t754);
        let t772 = t237 - t305 * (t746 * t746) - t752 * (t757 * t757);
        let t773 = k6 / t772;
        let t774 = t305 * t746;
        let t777 = t752 * t757;
        let t780 = t773 * (t183 - t747 * t774 - t760 * t777);
        let t785 = t773 * (t117 - t748 * t774 - t763 * t777);
        let t790 = t773 * (t47 - t749 * t774 - t766 * t777);
        let t798 = t772 * (t780 * t780);
        let t799 = t162 - t305 * (t747 * t747) - t752 * (t760 * t760) - t798;
        let t800 = k6 / t799;
        let t801 = t305 * t747;
        let t804 = t752 * t760;
        let t807 = t772 * t780;
        let t810 = t800 * (t101 - t748 * t801 - t763 * t804 - t785 * t807);
        let t817 = t800 * (t27 - t749 * t801 - t766 * t804 - t790 * t807);
        let t825 = t772 * (t785 * t785);
        let t828 = t799 * (t810 * t810);
        let t829 = t82 - t305 * (t748 * t748) - t752 * (t763 * t763) - t825 - t828;
        let t830 = k6 / t829;
        let t838 = t790 * (t772 * t785);
        let t841 = t817 * (t799 * t810);
        let t842 = t15 + t749 * (t305 * t748) + t766 * (t752 * t763) + t838 + t841;
        let t843 = t830 * t842;
        let t851 = t772 * (t790 * t790);
        let t854 = t799 * (t817 * t817);
        let t855 = ZZ6 - t305 * (t749 * t749) - t752 * (t766 * t766) - t851 - t854;
        let t859 = k6 / (t855 - t829 * (t843 * t843));
        [
        t744, t745, t746, t747, t748, t749, t753, t757,
        t760, t763, t766, t773, t780, t785, t790, t800,
        t810, t817, t830, t843, t859,
    ]
    };
    // ddq
    {
        let t861 = t739 - t738 * t745;
        let t865 = t740 - t738 * t746 - t757 * t861;
        let t871 = t741 - t738 * t747 - t760 * t861 - t780 * t865;
        let t879 = t742 - t738 * t748 - t763 * t861 - t785 * t865 - t810 * t871;
        let t887 = t743 - t738 * t749 - t766 * t861 - t790 * t865 - t817 * t871;
        let t895 = t859 * (t887 + t843 * t879);
        let t897 = t830 * t879 + t843 * t895;
        let t901 = t800 * t871 - t810 * t897 - t817 * t895;
        let t907 = t773 * t865 - t780 * t901 - t785 * t897 - t790 * t895;
        let t914 = t766 * t895;
        let t915 = t753 * t861 - t757 * t907 - t760 * t901 - t763 * t897 - t914;
        let t922 = t748 * t897;
        let t923 = t738 * t744 - t745 * t915 - t746 * t907 - t747 * t901 - t922;
        let t925 = t923 - t749 * t895;
        put(0, t925);
        put(1, t915);
        put(2, t907);
        put(3, t901);
        put(4, t897);
        put(5, t895);
    }
}
