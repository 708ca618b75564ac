//! Accelerations under given torques.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` in
//! closed form.
//!
//! 514 multiplications, 420 additions; 6, 6 of 6 structurally nonzero.

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
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [tau1, tau2, tau3, tau4, tau5, tau6] = *tau;
    let [
        ZZ1R, MSX2R, MSY2, XX2R, ZZ2R, XY2, XZ2R, YZ2, MSX3R, MSY3, XX3R, ZZ3R,
        XY3, XZ3R, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        IA3, IA4, IA5, IA6, FV1, FV2, FV3, FV4, FV5, FV6, FC1, FC2,
        FC3, FC4, FC5, FC6, FO1, FO2, FO3, FO4, FO5, FO6,
        ..] = *beta;
    let k3 = S::constant(-constants::A3);
    let k4 = S::constant(-constants::A2);
    let k5 = S::constant(-GRAVITY[2]);
    let k6 = S::constant(1.0);
    let k_D4 = S::constant(constants::D4);
    let k_D5 = S::constant(constants::D5);
    let k_D6 = S::constant(constants::D6);
    // composite body 6
    let [
        t0, t3, t6, t15, t16, t20, t23, t28,
        t48, t61, t64, t73, t76, t79, t80,
    ] = {
        let t0 = ZZ6 + IA6;
        let t3 = c6 * MSY6 + s6 * MSX6;
        let t6 = c6 * MSX6 - s6 * MSY6;
        let t15 = c6 * XZ6 - s6 * YZ6 - k_D6 * t6;
        let t16 = s6 * XZ6 + c6 * YZ6 - k_D6 * t3;
        let t17 = c5 * t3;
        let t18 = s5 * t3;
        let t20 = s5 * ZZ6;
        let t23 = c5 * ZZ6;
        let t27 = c5 * t15 - t20 + k_D5 * t18;
        let t28 = s5 * t15 + t23 - k_D5 * t17;
        let t31 = c4 * t17 + s4 * t6;
        let t34 = c4 * t6 - s4 * t17;
        let t46 = c4 * t27 - s4 * t16 - k_D4 * t34;
        let t47 = s4 * t27 + c4 * t16 - (k_D4 * t31 + t18 * k3);
        let t48 = t28 - t34 * k3;
        let t61 = t48 - (c3 * t34 - s3 * t31) * k4;
        let t63 = c2 * (s3 * t46 + c3 * t47 - t18 * k4);
        let t64 = s2 * (c3 * t46 - s3 * t47) + t63;
        let t66 = s6 * XY6;
        let t69 = c6 * XY6;
        let t70 = s6 * XX6R + t69;
        let t73 = c6 * (c6 * XX6R - t66) - s6 * t69;
        let t76 = c6 * t70 - s6 * t66;
        let t79 = s6 * t70 + c6 * t66;
        let t80 = t3 + t3;
        [
        t0, t3, t6, t15, t16, t20, t23, t28,
        t48, t61, t64, t73, t76, t79, t80,
    ]
    };
    // composite body 5
    let [
        t87, t90, t93, t102, t103, t119, t132, t135,
        t149, t153, t155, t156, t160,
    ] = {
        let t81 = MSX5 + t6;
        let t82 = XX5R + t73;
        let t83 = ZZ5R + t79;
        let t84 = XY5 + t15;
        let t85 = XZ5 - t76;
        let t86 = YZ5 - t16;
        let t87 = IA5 + t83;
        let t90 = c5 * MSY5R + s5 * t81;
        let t93 = c5 * t81 - s5 * MSY5R;
        let t102 = c5 * t85 - s5 * t86 - k_D5 * t93;
        let t103 = s5 * t85 + c5 * t86 - k_D5 * t90;
        let t104 = c4 * t90;
        let t105 = s4 * t90;
        let t117 = c4 * t102 + s4 * t83 + k_D4 * t105;
        let t118 = s4 * t102 - c4 * t83 + (k3 * t93 - k_D4 * t104);
        let t119 = t103 + k3 * t105;
        let t132 = t119 + k4 * (s3 * t104 + c3 * t105);
        let t134 = c2 * (s3 * t117 + c3 * t118 + k4 * t93);
        let t135 = s2 * (c3 * t117 - s3 * t118) + t134;
        let t137 = s5 * t84;
        let t140 = c5 * t84;
        let t141 = s5 * t82 + t140;
        let t143 = t23 + t137;
        let t149 = c5 * t141 - s5 * t143;
        let t153 = t90 + t90;
        let t154 = k_D5 * t80;
        let t155 = c5 * (c5 * t82 - t137) - s5 * (t140 - t20) - t154;
        let t156 = s5 * t141 + c5 * t143 - t154;
        let t158 = k_D5 * t3;
        let t160 = t83 - t154 + (t158 + t158);
        [
        t87, t90, t93, t102, t103, t119, t132, t135,
        t149, t153, t155, t156, t160,
    ]
    };
    // composite body 4
    let [
        t168, t171, t174, t185, t186, t197, t200, t226,
        t228, t231, t232, t236,
    ] = {
        let t161 = MSX4 + t93;
        let t162 = MSY4R + t3;
        let t163 = XX4R + t155;
        let t164 = ZZ4R + t156;
        let t165 = XY4 - t102;
        let t166 = XZ4 + t149;
        let t167 = YZ4 - t103;
        let t168 = IA4 + t164;
        let t171 = c4 * t162 + s4 * t161;
        let t174 = c4 * t161 - s4 * t162;
        let t177 = c4 * t166 - s4 * t167;
        let t181 = k_D4 * t174;
        let t183 = k3 * t174;
        let t184 = t177 - t181;
        let t185 = s4 * t166 + c4 * t167 - k_D4 * t171;
        let t186 = t164 - t183;
        let t197 = t186 - k4 * (c3 * t174 - s3 * t171);
        let t199 = c2 * (s3 * t184 + c3 * t185);
        let t200 = s2 * (c3 * t184 - s3 * t185) + t199;
        let t202 = s4 * t165;
        let t205 = c4 * t165;
        let t206 = s4 * t163 + t205;
        let t210 = t202 + c4 * t160;
        let t223 = k_D4 * t153 - k3 * (t174 + t174);
        let t224 = c4 * (c4 * t163 - t202) - s4 * (t205 - s4 * t160) + t223;
        let t226 = t224 + (t183 + t183);
        let t228 = c4 * t206 - s4 * t210 + k3 * t171;
        let t231 = t177 - (t181 - k3 * t90);
        let t232 = s4 * t206 + c4 * t210 + t223;
        let t234 = k_D4 * t90;
        let t236 = t164 + t223 - (t234 + t234);
        [
        t168, t171, t174, t185, t186, t197, t200, t226,
        t228, t231, t232, t236,
    ]
    };
    // composite body 3
    let [
        t244, t256, t258, t261, t285, t287, t289, t290,
        t291,
    ] = {
        let t237 = MSX3R + t174;
        let t238 = MSY3 + t171;
        let t239 = XX3R + t226;
        let t240 = ZZ3R + t236;
        let t241 = XY3 + t228;
        let t242 = XZ3R + t231;
        let t243 = YZ3 + t185;
        let t244 = IA3 + t240;
        let t250 = c3 * t237 - s3 * t238;
        let t253 = c3 * t242 - s3 * t243;
        let t256 = s3 * t242 + c3 * t243;
        let t257 = k4 * t250;
        let t258 = t240 - t257;
        let t261 = s2 * t253 + c2 * t256;
        let t263 = s3 * t241;
        let t266 = c3 * t241;
        let t267 = s3 * t239 + t266;
        let t271 = t263 + c3 * t232;
        let t282 = k4 * (t250 + t250);
        let t283 = c3 * (c3 * t239 - t263) - s3 * (t266 - s3 * t232) - t282;
        let t285 = t283 + (t257 + t257);
        let t287 = c3 * t267 - s3 * t271 + k4 * (c3 * t238 + s3 * t237);
        let t289 = t253 + k4 * t90;
        let t290 = s3 * t267 + c3 * t271 - t282;
        let t291 = t240 - t282;
        [
        t244, t256, t258, t261, t285, t287, t289, t290,
        t291,
    ]
    };
    // composite body 2
    let [t293, t299, t308] = {
        let t293 = ZZ2R + t291;
        let t294 = XY2 + t287;
        let t299 = s2 * (XZ2R + t289) + c2 * (YZ2 + t256);
        let t307 = c2 * (s2 * t294 + c2 * t290);
        let t308 = s2 * (s2 * (XX2R + t285) + c2 * t294) + t307;
        [t293, t299, t308]
    };
    // composite body 1
    let t309 = {
        let t309 = ZZ1R + t308;
        t309
    };
    // link 1: motion
    let t310 = {
        let t310 = dq1 * dq1;
        t310
    };
    // link 2: motion
    let [a2_x, a2_y, t316, t317, t320, t321] = {
        let a2_x = s2 * k5;
        let a2_y = c2 * k5;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t316 = dq2 * dq2;
        let t317 = w2_x * w2_y;
        let t318 = dq2 * w2_x;
        let t320 = w2_x * w2_x - t316 - t310;
        let t321 = t318 + t318;
        [a2_x, a2_y, t316, t317, t320, t321]
    };
    // link 3: motion
    let [
        t324, t327, w3_z, t331, a3_x, a3_y, t343, t344,
        t348, t349, t350, t351,
    ] = {
        let t324 = s2 * c3 + c2 * s3;
        let t327 = c2 * c3 - s2 * s3;
        let w3_z = dq2 + dq3;
        let t331 = k4 * t321;
        let t332 = a2_x - k4 * t320;
        let t333 = a2_y - k4 * t317;
        let a3_x = c3 * t332 + s3 * t333;
        let a3_y = c3 * t333 - s3 * t332;
        let w3_x = dq1 * t324;
        let w3_y = dq1 * t327;
        let t342 = w3_x * w3_x;
        let t343 = w3_z * w3_z;
        let t344 = w3_x * w3_y;
        let t345 = w3_z * w3_x;
        let dw3_x = w3_z * w3_y;
        let t348 = t342 - t343 - t310;
        let t349 = t342 + t343;
        let t350 = t345 + t345;
        let t351 = dw3_x + dw3_x;
        [
        t324, t327, w3_z, t331, a3_x, a3_y, t343, t344,
        t348, t349, t350, t351,
    ]
    };
    // link 4: motion
    let [
        t354, t357, w4_z, a4_x, a4_y, t372, w4_x, w4_y,
        t376, t377, dw5_z, t381, t382, t383, t384,
    ] = {
        let t354 = c4 * t324 + s4 * t327;
        let t357 = c4 * t327 - s4 * t324;
        let w4_z = w3_z + dq4;
        let t362 = a3_x - k3 * t348;
        let t363 = a3_y - k3 * t344;
        let a4_x = c4 * t362 + s4 * t363;
        let a4_y = c4 * t363 - s4 * t362;
        let t372 = t331 + (k3 * t350 + k_D4 * t310);
        let w4_x = dq1 * t354;
        let w4_y = dq1 * t357;
        let t375 = w4_x * w4_x;
        let t376 = w4_z * w4_z;
        let t377 = w4_x * w4_y;
        let dw5_z = w4_z * w4_x;
        let dw4_x = w4_z * w4_y;
        let t381 = t375 - t376 - t310;
        let t382 = t375 + t376;
        let t383 = dw5_z + dw5_z;
        let t384 = dw4_x + dw4_x;
        [
        t354, t357, w4_z, a4_x, a4_y, t372, w4_x, w4_y,
        t376, t377, dw5_z, t381, t382, t383, t384,
    ]
    };
    // link 5: motion
    let [
        t389, a5_x, t396, w5_x, w5_y, t405, t408, w5_z,
        t412, t413, t414, dw5_x, t416, t417, t418, t419,
        t420, t421, t422, t423,
    ] = {
        let t388 = a4_x - k_D5 * t377;
        let t389 = a4_y + k_D5 * t382;
        let t390 = t372 + k_D5 * t384;
        let a5_x = c5 * t388 - s5 * t390;
        let t396 = c5 * t390 + s5 * t388;
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t405 = c5 * t377 + s5 * t384;
        let t408 = s5 * t377 - c5 * t384;
        let w5_z = dq5 - w4_y;
        let t410 = w5_x * w5_x;
        let t411 = w5_z * w5_z;
        let t412 = w5_x * w5_y;
        let t413 = w5_x * w5_z;
        let t414 = w5_y * w5_z;
        let dw5_x = t414 - t408;
        let t416 = t405 + t413;
        let t417 = t410 - t411;
        let t418 = t417 - t382;
        let t419 = t412 - dw5_z;
        let t420 = dw5_z + t412;
        let t421 = t410 + t411;
        let t422 = t413 + t416;
        let t423 = t414 + dw5_x;
        [
        t389, a5_x, t396, w5_x, w5_y, t405, t408, w5_z,
        t412, t413, t414, dw5_x, t416, t417, t418, t419,
        t420, t421, t422, t423,
    ]
    };
    // link 6: motion
    let [
        t426, t429, t438, t441, t445, t446, t447, dw6_x,
        t450, t451, t452, t453, t454, t455, t456,
    ] = {
        let t426 = c6 * a5_x + s6 * t389;
        let t429 = c6 * t389 - s6 * a5_x;
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t435 = c6 * w5_z + s6 * w5_x;
        let t438 = c6 * t419 - s6 * t423;
        let t441 = c6 * t423 + s6 * t419;
        let w6_z = w5_y + dq6;
        let t443 = w6_x * w6_x;
        let t444 = w6_z * w6_z;
        let t445 = w6_x * t435;
        let t446 = w6_x * w6_z;
        let t447 = t435 * w6_z;
        let dw6_x = t441 - t447;
        let dw6_y = t438 - t446;
        let t450 = t443 - t444;
        let t451 = t450 - t421;
        let t452 = t416 - t445;
        let t453 = t416 + t445;
        let t454 = t443 + t444;
        let t455 = t446 - dw6_y;
        let t456 = dw6_x - t447;
        [
        t426, t429, t438, t441, t445, t446, t447, dw6_x,
        t450, t451, t452, t453, t454, t455, t456,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t508, t511, t514, t517] = {
        let t458 = XZ6 - k_D6 * MSX6;
        let t460 = YZ6 - k_D6 * MSY6;
        let t481 = XX6R * t445 - ZZ6 * t416 + XY6 * (t451 + t454) + t441 * t458;
        let t483 = t460 * (t421 - t454);
        let t486 = XX6R * dw6_x - ZZ6 * t447 - XY6 * t455 - t453 * t458 + t483;
        let t487 = t446 * (XX6R - ZZ6) + XY6 * t456 - t450 * t458 - t452 * t460;
        let f6_x = MSX6 * t451 + MSY6 * t452;
        let t494 = MSX6 * t453 + MSY6 * t454;
        let f6_z = MSX6 * t455 + MSY6 * t456;
        let n6_x = t486 - MSY6 * t396;
        let n6_y = t487 + MSX6 * t396;
        let n6_z = t481 + t438 * t460 + (MSX6 * t429 - MSY6 * t426);
        let t508 = c6 * f6_x + s6 * t494;
        let t511 = s6 * f6_x - c6 * t494;
        let t514 = c6 * n6_x - s6 * n6_y;
        let t517 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t508, t511, t514, t517]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t571, t574, t583, t584] = {
        let t538 = ZZ5R * dw5_z - XX5R * t412 + XY5 * (t418 + t421) - XZ5 * t408;
        let t540 = YZ5 * (t382 - t421);
        let t543 = ZZ5R * t414 + XX5R * dw5_x - XY5 * t422 + XZ5 * t420 + t540;
        let t544 = t413 * (XX5R - ZZ5R) + XY5 * t423 - XZ5 * t417 - YZ5 * t419;
        let f5_x = t508 + (MSX5 * t418 + MSY5R * t419);
        let f5_y = f6_z + (MSX5 * t420 - MSY5R * t421);
        let f5_z = MSX5 * t422 + MSY5R * t423 - t511;
        let n5_x = t514 + (t543 - MSY5R * t389);
        let n5_y = n6_z + (t544 + MSX5 * t389);
        let n5_z = t538 - YZ5 * t405 - (MSX5 * t396 + MSY5R * a5_x) - t517;
        let t571 = c5 * f5_x - s5 * f5_y;
        let t574 = s5 * f5_x + c5 * f5_y;
        let t583 = c5 * n5_x - s5 * n5_y - k_D5 * t574;
        let t584 = s5 * n5_x + c5 * n5_y + k_D5 * t571;
        [f5_z, n5_z, t571, t574, t583, t584]
    };
    // link 4: force and moment
    let [t598, f4_z, n4_z, t623, t626, t638, t639, t640] = {
        let t590 = t357 * (XX4R * t354 + t357 * (XY4 + XY4)) - XY4;
        let t598 = (t590 + t590) * (dq1 * w4_z) + t376 * (XZ4 * t357 - YZ4 * t354);
        let f4_x = t571 + (MSX4 * t381 + MSY4R * t377);
        let f4_y = MSX4 * t377 - MSY4R * t382 - f5_z;
        let f4_z = t574 + (MSX4 * t383 + MSY4R * t384);
        let n4_x = t583 - MSY4R * t372;
        let n4_y = MSX4 * t372 - n5_z;
        let n4_z = t584 + (MSX4 * a4_y - MSY4R * a4_x) - t310 * t590;
        let t623 = c4 * f4_x - s4 * f4_y;
        let t626 = s4 * f4_x + c4 * f4_y;
        let t638 = c4 * n4_x - s4 * n4_y - k_D4 * t626;
        let t639 = s4 * n4_x + c4 * n4_y + (k_D4 * t623 + k3 * f4_z);
        let t640 = n4_z - k3 * t626;
        [t598, f4_z, n4_z, t623, t626, t638, t639, t640]
    };
    // link 3: force and moment
    let [t656, n3_z, n2_x, n2_y, t690] = {
        let t646 = t327 * (XX3R * t324 + t327 * (XY3 + XY3)) - XY3;
        let t654 = (t646 + t646) * (dq1 * w3_z) + t343 * (XZ3R * t327 - YZ3 * t324);
        let t656 = t598 + t654;
        let f3_x = t623 + (MSX3R * t348 + MSY3 * t344);
        let f3_y = t626 + (MSX3R * t344 - MSY3 * t349);
        let f3_z = f4_z + (MSX3R * t350 + MSY3 * t351);
        let n3_x = t638 - MSY3 * t331;
        let n3_y = t639 + MSX3R * t331;
        let n3_z = t640 + (MSX3R * a3_y - MSY3 * a3_x) - t310 * t646;
        let n2_x = c3 * n3_x - s3 * n3_y;
        let n2_y = s3 * n3_x + c3 * n3_y + k4 * f3_z;
        let t690 = n3_z - k4 * (s3 * f3_x + c3 * f3_y);
        [t656, n3_z, n2_x, n2_y, t690]
    };
    // link 2: force and moment
    let [t706, n2_z, t714] = {
        let t696 = c2 * (s2 * XX2R + c2 * (XY2 + XY2)) - XY2;
        let t704 = (t696 + t696) * (dq1 * dq2) + t316 * (c2 * XZ2R - s2 * YZ2);
        let t706 = t656 + t704;
        let n2_z = t690 + (MSX2R * a2_y - MSY2 * a2_x) - t310 * t696;
        let t714 = s2 * n2_x + c2 * n2_y;
        [t706, n2_z, t714]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t706 + t714;
        n1_z
    };
    // drives
    let [t752, t753, t754, t755, t756, t757] = {
        let t752 = tau1 - (FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign()));
        let t753 = tau2 - (FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign()));
        let t754 = tau3 - (FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign()));
        let t755 = tau4 - (FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign()));
        let t756 = tau5 - (FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign()));
        let t757 = tau6 - (FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign()));
        [t752, t753, t754, t755, t756, t757]
    };
    // M = L D L'
    let [
        t758, t759, t760, t761, t762, t763, t767, t771,
        t774, t777, t780, t787, t794, t799, t804, t814,
        t824, t831, t844, t857, t873,
    ] = {
        let t758 = k6 / t309;
        let t759 = t299 * t758;
        let t760 = t261 * t758;
        let t761 = t200 * t758;
        let t762 = t135 * t758;
        let t763 = t64 * t758;
        let t766 = t293 - t309 * (t759 * t759);
        let t767 = k6 / t766;
        let t768 = t309 * t759;
        let t771 = t767 * (t258 - t760 * t768);
        let t774 = t767 * (t197 - t761 * t768);
        let t777 = t767 * (t132 - t762 * t768);
        let t780 = t767 * (t61 - t763 * t768);
        let t786 = t244 - t309 * (t760 * t760) - t766 * (t771 * t771);
        let t787 = k6 / t786;
        let t788 = t309 * t760;
        let t791 = t766 * t771;
        let t794 = t787 * (t186 - t761 * t788 - t774 * t791);
        let t799 = t787 * (t119 - t762 * t788 - t777 * t791);
        let t804 = t787 * (t48 - t763 * t788 - t780 * t791);
        let t812 = t786 * (t794 * t794);
        let t813 = t168 - t309 * (t761 * t761) - t766 * (t774 * t774) - t812;
        let t814 = k6 / t813;
        let t815 = t309 * t761;
        let t818 = t766 * t774;
        let t821 = t786 * t794;
        let t824 = t814 * (t103 - t762 * t815 - t777 * t818 - t799 * t821);
        let t831 = t814 * (t28 - t763 * t815 - t780 * t818 - t804 * t821);
        let t839 = t786 * (t799 * t799);
        let t842 = t813 * (t824 * t824);
        let t843 = t87 - t309 * (t762 * t762) - t766 * (t777 * t777) - t839 - t842;
        let t844 = k6 / t843;
        let t852 = t804 * (t786 * t799);
        let t855 = t831 * (t813 * t824);
        let t856 = t16 + t763 * (t309 * t762) + t780 * (t766 * t777) + t852 + t855;
        let t857 = t844 * t856;
        let t865 = t786 * (t804 * t804);
        let t868 = t813 * (t831 * t831);
        let t869 = t0 - t309 * (t763 * t763) - t766 * (t780 * t780) - t865 - t868;
        let t873 = k6 / (t869 - t843 * (t857 * t857));
        [
        t758, t759, t760, t761, t762, t763, t767, t771,
        t774, t777, t780, t787, t794, t799, t804, t814,
        t824, t831, t844, t857, t873,
    ]
    };
    // ddq
    {
        let t875 = t753 - t752 * t759;
        let t879 = t754 - t752 * t760 - t771 * t875;
        let t885 = t755 - t752 * t761 - t774 * t875 - t794 * t879;
        let t893 = t756 - t752 * t762 - t777 * t875 - t799 * t879 - t824 * t885;
        let t901 = t757 - t752 * t763 - t780 * t875 - t804 * t879 - t831 * t885;
        let t909 = t873 * (t901 + t857 * t893);
        let t911 = t844 * t893 + t857 * t909;
        let t915 = t814 * t885 - t824 * t911 - t831 * t909;
        let t921 = t787 * t879 - t794 * t915 - t799 * t911 - t804 * t909;
        let t928 = t780 * t909;
        let t929 = t767 * t875 - t771 * t921 - t774 * t915 - t777 * t911 - t928;
        let t936 = t762 * t911;
        let t937 = t752 * t758 - t759 * t929 - t760 * t921 - t761 * t915 - t936;
        let t939 = t937 - t763 * t909;
        put(0, t939);
        put(1, t929);
        put(2, t921);
        put(3, t915);
        put(4, t911);
        put(5, t909);
    }
}
