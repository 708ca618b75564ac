//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 531 multiplications, 441 additions; 6, 6 of 6 structurally nonzero.

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
    // link 2: motion
    let [w2_x, w2_y, a2_x, a2_y, dw2_x, t311] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let a2_x = s2 * k5;
        let a2_y = c2 * k5;
        let dw2_x = dq2 * w2_y;
        let t311 = dq2 * w2_x;
        [w2_x, w2_y, a2_x, a2_y, dw2_x, t311]
    };
    // link 3: motion
    let [
        w3_x, w3_y, t324, t325, t326, t327, t329, t330,
        t333, a3_x, a3_y, w3_z, dw3_x, t346,
    ] = {
        let w3_x = c3 * w2_x + s3 * w2_y;
        let w3_y = c3 * w2_y - s3 * w2_x;
        let t324 = w2_x * w2_x;
        let t325 = w2_y * w2_y;
        let t326 = dq2 * dq2;
        let t327 = w2_x * w2_y;
        let t329 = t311 + t311;
        let t330 = dw2_x + dw2_x;
        let t333 = k4 * t329;
        let t334 = a2_x + k4 * (t325 + t326);
        let t335 = a2_y - k4 * t327;
        let a3_x = c3 * t334 + s3 * t335;
        let a3_y = c3 * t335 - s3 * t334;
        let w3_z = dq2 + dq3;
        let dw3_x = c3 * dw2_x - s3 * t311 + dq3 * w3_y;
        let t346 = c3 * t311 + s3 * dw2_x + dq3 * w3_x;
        [
        w3_x, w3_y, t324, t325, t326, t327, t329, t330,
        t333, a3_x, a3_y, w3_z, dw3_x, t346,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t359, t360, t361, t362, t363, t364,
        t365, t366, t367, t368, t369, t370, t383, a4_x,
        a4_y, w4_z, dw4_x, dw5_z,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_y;
        let w4_y = c4 * w3_y - s4 * w3_x;
        let t359 = w3_x * w3_x;
        let t360 = w3_y * w3_y;
        let t361 = w3_z * w3_z;
        let t362 = w3_x * w3_y;
        let t363 = w3_x * w3_z;
        let t364 = w3_y * w3_z;
        let t365 = t360 + t361;
        let t366 = t363 - t346;
        let t367 = t359 + t361;
        let t368 = t364 - dw3_x;
        let t369 = t346 + t363;
        let t370 = dw3_x + t364;
        let t381 = a3_x + (k3 * t365 + D4 * t366);
        let t382 = a3_y + (D4 * t368 - k3 * t362);
        let t383 = t333 + (k3 * t369 + D4 * (t359 + t360));
        let a4_x = c4 * t381 + s4 * t382;
        let a4_y = c4 * t382 - s4 * t381;
        let w4_z = w3_z + dq4;
        let dw4_x = c4 * dw3_x - s4 * t346 + dq4 * w4_y;
        let dw5_z = c4 * t346 + s4 * dw3_x + dq4 * w4_x;
        [
        w4_x, w4_y, t359, t360, t361, t362, t363, t364,
        t365, t366, t367, t368, t369, t370, t383, a4_x,
        a4_y, w4_z, dw4_x, dw5_z,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t403, t404, t405, t406, t407, t408,
        t409, t410, t411, t412, t413, t414, t419, a5_x,
        t426, w5_z, dw5_x, t431,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t403 = w4_x * w4_x;
        let t404 = w4_y * w4_y;
        let t405 = w4_z * w4_z;
        let t406 = w4_x * w4_y;
        let t407 = w4_x * w4_z;
        let t408 = w4_y * w4_z;
        let t409 = t404 + t405;
        let t410 = t407 - dw5_z;
        let t411 = t403 + t405;
        let t412 = t408 - dw4_x;
        let t413 = dw5_z + t407;
        let t414 = dw4_x + t408;
        let t418 = a4_x - D5 * t406;
        let t419 = a4_y + D5 * t411;
        let t420 = t383 + D5 * t414;
        let a5_x = c5 * t418 - s5 * t420;
        let t426 = c5 * t420 + s5 * t418;
        let w5_z = dq5 - w4_y;
        let dw5_x = c5 * dw4_x + dq5 * w5_y;
        let t431 = s5 * dw4_x + dq5 * w5_x;
        [
        w5_x, w5_y, t403, t404, t405, t406, t407, t408,
        t409, t410, t411, t412, t413, t414, t419, a5_x,
        t426, w5_z, dw5_x, t431,
    ]
    };
    // link 6: motion
    let [
        w6_x, t437, t444, t445, t446, t447, t448, t449,
        t450, t451, t452, t453, t454, t455, t456, t457,
        t462, a6_x, t469, w6_z, dw6_x, t474,
    ] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t437 = c6 * w5_z + s6 * w5_x;
        let t444 = w5_x * w5_x;
        let t445 = w5_y * w5_y;
        let t446 = w5_z * w5_z;
        let t447 = w5_x * w5_y;
        let t448 = w5_x * w5_z;
        let t449 = w5_y * w5_z;
        let t450 = t445 + t446;
        let t451 = t447 - dw5_z;
        let t452 = t448 - t431;
        let t453 = dw5_z + t447;
        let t454 = t444 + t446;
        let t455 = t449 - dw5_x;
        let t456 = t431 + t448;
        let t457 = dw5_x + t449;
        let t461 = a5_x + D6 * t451;
        let t462 = t426 + D6 * t454;
        let t463 = D6 * t457 - t419;
        let a6_x = c6 * t461 - s6 * t463;
        let t469 = c6 * t463 + s6 * t461;
        let w6_z = w5_y + dq6;
        let dw6_x = c6 * dw5_x - s6 * dw5_z - dq6 * t437;
        let t474 = c6 * dw5_z + s6 * dw5_x + dq6 * w6_x;
        [
        w6_x, t437, t444, t445, t446, t447, t448, t449,
        t450, t451, t452, t453, t454, t455, t456, t457,
        t462, a6_x, t469, w6_z, dw6_x, t474,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t537, t540, t549, t550] = {
        let t475 = w6_x * w6_x;
        let t476 = t437 * t437;
        let t477 = w6_z * w6_z;
        let t478 = w6_x * t437;
        let t479 = w6_x * w6_z;
        let t480 = t437 * w6_z;
        let t482 = t431 - t478;
        let t484 = t431 + t478;
        let t487 = t474 + t479;
        let t488 = dw6_x - t480;
        let t507 = XZ6 * (dw6_x + t480);
        let t512 = YZ6 * (t476 - t477);
        let t513 = YZ6 * t482;
        let t514 = YZ6 * (t479 - t474);
        let t515 = XX6R * dw6_x - ZZ6 * t480 - XY6 * t487 - XZ6 * t484 + t512;
        let t516 = t479 * (XX6R - ZZ6) + XY6 * t488 + XZ6 * (t477 - t475) - t513;
        let t517 = XX6R * t478 - ZZ6 * t431 + XY6 * (t475 - t476) + t507 + t514;
        let f6_x = MSY6 * t482 - MSX6 * (t476 + t477);
        let t523 = MSX6 * t484 + MSY6 * (t475 + t477);
        let f6_z = MSX6 * t487 + MSY6 * t488;
        let n6_x = t515 - MSY6 * t462;
        let n6_y = t516 + MSX6 * t462;
        let n6_z = t517 - (MSX6 * t469 + MSY6 * a6_x);
        let t537 = c6 * f6_x + s6 * t523;
        let t540 = s6 * f6_x - c6 * t523;
        let t549 = c6 * n6_x - s6 * n6_y - D6 * t540;
        let t550 = s6 * n6_x + c6 * n6_y + D6 * t537;
        [f6_z, n6_z, t537, t540, t549, t550]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t605, t608, t617, t618] = {
        let t572 = ZZ5R * dw5_z - XX5R * t447 + XY5 * (t444 - t445) - XZ5 * t455;
        let t574 = YZ5 * (t445 - t446);
        let t575 = YZ5 * t451;
        let t577 = ZZ5R * t449 + XX5R * dw5_x - XY5 * t456 + XZ5 * t453 + t574;
        let t578 = t448 * (XX5R - ZZ5R) + XY5 * t457 + XZ5 * (t446 - t444) - t575;
        let f5_x = t537 + (MSY5R * t451 - MSX5 * t450);
        let f5_y = f6_z + (MSX5 * t453 - MSY5R * t454);
        let f5_z = MSX5 * t456 + MSY5R * t457 - t540;
        let n5_x = t549 + (t577 - MSY5R * t419);
        let n5_y = n6_z + (t578 + MSX5 * t419);
        let n5_z = t572 + YZ5 * t452 - (MSX5 * t426 + MSY5R * a5_x) - t550;
        let t605 = c5 * f5_x - s5 * f5_y;
        let t608 = s5 * f5_x + c5 * f5_y;
        let t617 = c5 * n5_x - s5 * n5_y - D5 * t608;
        let t618 = s5 * n5_x + c5 * n5_y + D5 * t605;
        [f5_z, n5_z, t605, t608, t617, t618]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t671, t674, t686, t687, t688] = {
        let t640 = YZ4 * (t404 - t405);
        let t641 = YZ4 * t406;
        let t643 = ZZ4R * t408 + XX4R * dw4_x - XY4 * t413 + XZ4 * t406 + t640;
        let t644 = t407 * (XX4R - ZZ4R) + XY4 * t414 + XZ4 * (t405 - t403) - t641;
        let t645 = XY4 * (t403 - t404) - XX4R * t406 - XZ4 * t412 + YZ4 * t410;
        let f4_x = t605 + (MSY4R * t406 - MSX4 * t409);
        let f4_y = MSX4 * t406 - MSY4R * t411 - f5_z;
        let f4_z = t608 + (MSX4 * t413 + MSY4R * t414);
        let n4_x = t617 + (t643 - MSY4R * t383);
        let n4_y = t644 + MSX4 * t383 - n5_z;
        let n4_z = t618 + (t645 + (MSX4 * a4_y - MSY4R * a4_x));
        let t671 = c4 * f4_x - s4 * f4_y;
        let t674 = s4 * f4_x + c4 * f4_y;
        let t686 = c4 * n4_x - s4 * n4_y - D4 * t674;
        let t687 = s4 * n4_x + c4 * n4_y + (D4 * t671 + k3 * f4_z);
        let t688 = n4_z - k3 * t674;
        [f4_z, n4_z, t671, t674, t686, t687, t688]
    };
    // link 3: force and moment
    let [n3_z, t744, t750, t751] = {
        let t710 = YZ3 * (t360 - t361);
        let t711 = YZ3 * t362;
        let t713 = ZZ3R * t364 + XX3R * dw3_x - XY3 * t369 + XZ3R * t362 + t710;
        let t714 = t363 * (XX3R - ZZ3R) + XY3 * t370 + XZ3R * (t361 - t359) - t711;
        let t715 = XY3 * (t359 - t360) - XX3R * t362 - XZ3R * t368 + YZ3 * t366;
        let f3_x = t671 + (MSY3 * t362 - MSX3R * t365);
        let f3_y = t674 + (MSX3R * t362 - MSY3 * t367);
        let f3_z = f4_z + (MSX3R * t369 + MSY3 * t370);
        let n3_x = t686 + (t713 - MSY3 * t333);
        let n3_y = t687 + (t714 + MSX3R * t333);
        let n3_z = t688 + (t715 + (MSX3R * a3_y - MSY3 * a3_x));
        let t744 = c3 * n3_x - s3 * n3_y;
        let t750 = s3 * n3_x + c3 * n3_y + k4 * f3_z;
        let t751 = n3_z - k4 * (s3 * f3_x + c3 * f3_y);
        [n3_z, t744, t750, t751]
    };
    // link 2: force and moment
    let [n2_z, n1_z] = {
        let t770 = YZ2 * (t325 - t326);
        let t771 = YZ2 * t327;
        let t773 = t311 * (XX2R - ZZ2R) + XY2 * t330 + XZ2R * (t326 - t324) - t771;
        let t777 = XY2 * (t324 - t325) - XX2R * t327 + (MSX2R * a2_y - MSY2 * a2_x);
        let n2_x = t744 + (dw2_x * (XX2R + ZZ2R) - XY2 * t329 + XZ2R * t327 + t770);
        let n2_y = t750 + t773;
        let n2_z = t751 + t777;
        let n1_z = s2 * n2_x + c2 * n2_y;
        [n2_z, n1_z]
    };
    // drives
    let [t784, t785, t786, t787, t788, t789] = {
        let t784 = tau1 - n1_z;
        let t785 = tau2 - n2_z;
        let t786 = tau3 - n3_z;
        let t787 = tau4 - n4_z;
        let t788 = tau5 - n5_z;
        let t789 = tau6 - n6_z;
        [t784, t785, t786, t787, t788, t789]
    };
    // M = L D L'
    let [
        t790, t791, t792, t793, t794, t795, t799, t803,
        t806, t809, t812, t819, t826, t831, t836, t846,
        t856, t863, t876, t889, t905,
    ] = {
        let t790 = k6 / t305;
        let t791 = t295 * t790;
        let t792 = t257 * t790;
        let t793 = t197 * t790;
        let t794 = t133 * t790;
        let t795 = t63 * t790;
        let t798 = t289 - t305 * (t791 * t791);
        let t799 = k6 / t798;
        let t800 = t305 * t791;
        let t803 = t799 * (t254 - t792 * t800);
        let t806 = t799 * (t194 - t793 * t800);
        let t809 = t799 * (t130 - t794 * t800);
        let t812 = t799 * (t60 - t795 * t800);
        let t818 = t237 - t305 * (t792 * t792) - t798 * (t803 * t803);
        let t819 = k6 / t818;
        let t820 = t305 * t792;
        let t823 = t798 * t803;
        let t826 = t819 * (t183 - t793 * t820 - t806 * t823);
        let t831 = t819 * (t117 - t794 * t820 - t809 * t823);
        let t836 = t819 * (t47 - t795 * t820 - t812 * t823);
        let t844 = t818 * (t826 * t826);
        let t845 = t162 - t305 * (t793 * t793) - t798 * (t806 * t806) - t844;
        let t846 = k6 / t845;
        let t847 = t305 * t793;
        let t850 = t798 * t806;
        let t853 = t818 * t826;
        let t856 = t846 * (t101 - t794 * t847 - t809 * t850 - t831 * t853);
        let t863 = t846 * (t27 - t795 * t847 - t812 * t850 - t836 * t853);
        let t871 = t818 * (t831 * t831);
        let t874 = t845 * (t856 * t856);
        let t875 = t82 - t305 * (t794 * t794) - t798 * (t809 * t809) - t871 - t874;
        let t876 = k6 / t875;
        let t884 = t836 * (t818 * t831);
        let t887 = t863 * (t845 * t856);
        let t888 = t15 + t795 * (t305 * t794) + t812 * (t798 * t809) + t884 + t887;
        let t889 = t876 * t888;
        let t897 = t818 * (t836 * t836);
        let t900 = t845 * (t863 * t863);
        let t901 = ZZ6 - t305 * (t795 * t795) - t798 * (t812 * t812) - t897 - t900;
        let t905 = k6 / (t901 - t875 * (t889 * t889));
        [
        t790, t791, t792, t793, t794, t795, t799, t803,
        t806, t809, t812, t819, t826, t831, t836, t846,
        t856, t863, t876, t889, t905,
    ]
    };
    // ddq
    {
        let t907 = t785 - t784 * t791;
        let t911 = t786 - t784 * t792 - t803 * t907;
        let t917 = t787 - t784 * t793 - t806 * t907 - t826 * t911;
        let t925 = t788 - t784 * t794 - t809 * t907 - t831 * t911 - t856 * t917;
        let t933 = t789 - t784 * t795 - t812 * t907 - t836 * t911 - t863 * t917;
        let t941 = t905 * (t933 + t889 * t925);
        let t943 = t876 * t925 + t889 * t941;
        let t947 = t846 * t917 - t856 * t943 - t863 * t941;
        let t953 = t819 * t911 - t826 * t947 - t831 * t943 - t836 * t941;
        let t960 = t812 * t941;
        let t961 = t799 * t907 - t803 * t953 - t806 * t947 - t809 * t943 - t960;
        let t968 = t794 * t943;
        let t969 = t784 * t790 - t791 * t961 - t792 * t953 - t793 * t947 - t968;
        let t971 = t969 - t795 * t941;
        put(0, t971);
        put(1, t961);
        put(2, t953);
        put(3, t947);
        put(4, t943);
        put(5, t941);
    }
}
