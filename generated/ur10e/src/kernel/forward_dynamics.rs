//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 517 multiplications, 443 additions; 6, 6 of 6 structurally nonzero.

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
        IA3, IA4, IA5, IA6, FV1, FV2, FV3, FV4, FV5, FV6, FC1, FC2,
        FC3, FC4, FC5, FC6, FO1, FO2, FO3, FO4, FO5, FO6,
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
        t0, t3, t6, t15, t16, t20, t23, t28,
        t48, t61, t64, t73, t76, t79, t80,
    ] = {
        let t0 = ZZ6 + IA6;
        let t3 = c6 * MSY6 + s6 * MSX6;
        let t6 = c6 * MSX6 - s6 * MSY6;
        let t15 = c6 * XZ6 - s6 * YZ6 - D6 * t6;
        let t16 = s6 * XZ6 + c6 * YZ6 - D6 * t3;
        let t17 = c5 * t3;
        let t18 = s5 * t3;
        let t20 = s5 * ZZ6;
        let t23 = c5 * ZZ6;
        let t27 = c5 * t15 - t20 + D5 * t18;
        let t28 = s5 * t15 + t23 - D5 * t17;
        let t31 = c4 * t17 + s4 * t6;
        let t34 = c4 * t6 - s4 * t17;
        let t46 = c4 * t27 - s4 * t16 - D4 * t34;
        let t47 = s4 * t27 + c4 * t16 - (D4 * t31 + t18 * k3);
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
        let t102 = c5 * t85 - s5 * t86 - D5 * t93;
        let t103 = s5 * t85 + c5 * t86 - D5 * t90;
        let t104 = c4 * t90;
        let t105 = s4 * t90;
        let t117 = c4 * t102 + s4 * t83 + D4 * t105;
        let t118 = s4 * t102 - c4 * t83 + (k3 * t93 - D4 * t104);
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
        let t154 = D5 * t80;
        let t155 = c5 * (c5 * t82 - t137) - s5 * (t140 - t20) - t154;
        let t156 = s5 * t141 + c5 * t143 - t154;
        let t158 = D5 * t3;
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
        let t181 = D4 * t174;
        let t183 = k3 * t174;
        let t184 = t177 - t181;
        let t185 = s4 * t166 + c4 * t167 - D4 * t171;
        let t186 = t164 - t183;
        let t197 = t186 - k4 * (c3 * t174 - s3 * t171);
        let t199 = c2 * (s3 * t184 + c3 * t185);
        let t200 = s2 * (c3 * t184 - s3 * t185) + t199;
        let t202 = s4 * t165;
        let t205 = c4 * t165;
        let t206 = s4 * t163 + t205;
        let t210 = t202 + c4 * t160;
        let t223 = D4 * t153 - k3 * (t174 + t174);
        let t224 = c4 * (c4 * t163 - t202) - s4 * (t205 - s4 * t160) + t223;
        let t226 = t224 + (t183 + t183);
        let t228 = c4 * t206 - s4 * t210 + k3 * t171;
        let t231 = t177 - (t181 - k3 * t90);
        let t232 = s4 * t206 + c4 * t210 + t223;
        let t234 = D4 * t90;
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
    let [
        w2_x, w2_y, a2_x, a2_y, t317, t318, dw2_x, t320,
        t321, t322, t323, t324,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let a2_x = s2 * k5;
        let a2_y = c2 * k5;
        let t315 = w2_x * w2_x;
        let t316 = dq2 * dq2;
        let t317 = w2_x * w2_y;
        let t318 = dq2 * w2_x;
        let dw2_x = dq2 * w2_y;
        let t320 = t315 - t316;
        let t321 = t320 - t310;
        let t322 = t315 + t316;
        let t323 = t318 + t318;
        let t324 = dw2_x + dw2_x;
        [
        w2_x, w2_y, a2_x, a2_y, t317, t318, dw2_x, t320,
        t321, t322, t323, t324,
    ]
    };
    // link 3: motion
    let [
        w3_x, w3_y, t333, a3_x, a3_y, w3_z, t345, t346,
        dw3_x, t348, t349, t350, t351, t352,
    ] = {
        let w3_x = c3 * w2_x + s3 * w2_y;
        let w3_y = c3 * w2_y - s3 * w2_x;
        let t333 = k4 * t323;
        let t334 = a2_x - k4 * t321;
        let t335 = a2_y - k4 * t317;
        let a3_x = c3 * t334 + s3 * t335;
        let a3_y = c3 * t335 - s3 * t334;
        let w3_z = dq2 + dq3;
        let t343 = w3_x * w3_x;
        let t344 = w3_z * w3_z;
        let t345 = w3_x * w3_y;
        let t346 = w3_x * w3_z;
        let dw3_x = w3_y * w3_z;
        let t348 = t343 - t344;
        let t349 = t348 - t310;
        let t350 = t343 + t344;
        let t351 = t346 + t346;
        let t352 = dw3_x + dw3_x;
        [
        w3_x, w3_y, t333, a3_x, a3_y, w3_z, t345, t346,
        dw3_x, t348, t349, t350, t351, t352,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, a4_x, a4_y, t372, w4_z, t376, dw5_z,
        dw4_x, t379, t380, t381, t382, t383,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_y;
        let w4_y = c4 * w3_y - s4 * w3_x;
        let t362 = a3_x - k3 * t349;
        let t363 = a3_y - k3 * t345;
        let a4_x = c4 * t362 + s4 * t363;
        let a4_y = c4 * t363 - s4 * t362;
        let t372 = t333 + (k3 * t351 + D4 * t310);
        let w4_z = w3_z + dq4;
        let t374 = w4_x * w4_x;
        let t375 = w4_z * w4_z;
        let t376 = w4_x * w4_y;
        let dw5_z = w4_x * w4_z;
        let dw4_x = w4_y * w4_z;
        let t379 = t374 - t375;
        let t380 = t379 - t310;
        let t381 = t374 + t375;
        let t382 = dw5_z + dw5_z;
        let t383 = dw4_x + dw4_x;
        [
        w4_x, w4_y, a4_x, a4_y, t372, w4_z, t376, dw5_z,
        dw4_x, t379, t380, t381, t382, t383,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t394, a5_x, t401, t404, t407, w5_z,
        t411, t412, t413, dw5_x, t415, t416, t417, t418,
        t419, t420, t421, t422,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t393 = a4_x - D5 * t376;
        let t394 = a4_y + D5 * t381;
        let t395 = t372 + D5 * t383;
        let a5_x = c5 * t393 - s5 * t395;
        let t401 = c5 * t395 + s5 * t393;
        let t404 = c5 * t376 + s5 * t383;
        let t407 = s5 * t376 - c5 * t383;
        let w5_z = dq5 - w4_y;
        let t409 = w5_x * w5_x;
        let t410 = w5_z * w5_z;
        let t411 = w5_x * w5_y;
        let t412 = w5_x * w5_z;
        let t413 = w5_y * w5_z;
        let dw5_x = t413 - t407;
        let t415 = t404 + t412;
        let t416 = t409 - t410;
        let t417 = t416 - t381;
        let t418 = t411 - dw5_z;
        let t419 = dw5_z + t411;
        let t420 = t409 + t410;
        let t421 = t412 + t415;
        let t422 = t413 + dw5_x;
        [
        w5_x, w5_y, t394, a5_x, t401, t404, t407, w5_z,
        t411, t412, t413, dw5_x, t415, t416, t417, t418,
        t419, t420, t421, t422,
    ]
    };
    // link 6: motion
    let [
        t433, a6_x, t440, t443, t446, t450, t451, t452,
        dw6_x, t455, t456, t457, t458, t459, t460, t461,
    ] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t428 = c6 * w5_z + s6 * w5_x;
        let t432 = a5_x + D6 * t418;
        let t433 = t401 + D6 * t420;
        let t434 = D6 * t422 - t394;
        let a6_x = c6 * t432 - s6 * t434;
        let t440 = c6 * t434 + s6 * t432;
        let t443 = c6 * t418 - s6 * t422;
        let t446 = c6 * t422 + s6 * t418;
        let w6_z = w5_y + dq6;
        let t448 = w6_x * w6_x;
        let t449 = w6_z * w6_z;
        let t450 = w6_x * t428;
        let t451 = w6_x * w6_z;
        let t452 = t428 * w6_z;
        let dw6_x = t446 - t452;
        let dw6_y = t443 - t451;
        let t455 = t448 - t449;
        let t456 = t455 - t420;
        let t457 = t415 - t450;
        let t458 = t415 + t450;
        let t459 = t448 + t449;
        let t460 = t451 - dw6_y;
        let t461 = dw6_x - t452;
        [
        t433, a6_x, t440, t443, t446, t450, t451, t452,
        dw6_x, t455, t456, t457, t458, t459, t460, t461,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t509, t512, t521, t522] = {
        let t482 = XX6R * t450 - ZZ6 * t415 + XY6 * (t456 + t459) + XZ6 * t446;
        let t484 = YZ6 * (t420 - t459);
        let t487 = XX6R * dw6_x - ZZ6 * t452 - XY6 * t460 - XZ6 * t458 + t484;
        let t488 = t451 * (XX6R - ZZ6) + XY6 * t461 - XZ6 * t455 - YZ6 * t457;
        let f6_x = MSX6 * t456 + MSY6 * t457;
        let t495 = MSX6 * t458 + MSY6 * t459;
        let f6_z = MSX6 * t460 + MSY6 * t461;
        let n6_x = t487 - MSY6 * t433;
        let n6_y = t488 + MSX6 * t433;
        let n6_z = t482 + YZ6 * t443 - (MSX6 * t440 + MSY6 * a6_x);
        let t509 = c6 * f6_x + s6 * t495;
        let t512 = s6 * f6_x - c6 * t495;
        let t521 = c6 * n6_x - s6 * n6_y - D6 * t512;
        let t522 = s6 * n6_x + c6 * n6_y + D6 * t509;
        [f6_z, n6_z, t509, t512, t521, t522]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t576, t579, t588, t589] = {
        let t543 = ZZ5R * dw5_z - XX5R * t411 + XY5 * (t417 + t420) - XZ5 * t407;
        let t545 = YZ5 * (t381 - t420);
        let t548 = ZZ5R * t413 + XX5R * dw5_x - XY5 * t421 + XZ5 * t419 + t545;
        let t549 = t412 * (XX5R - ZZ5R) + XY5 * t422 - XZ5 * t416 - YZ5 * t418;
        let f5_x = t509 + (MSX5 * t417 + MSY5R * t418);
        let f5_y = f6_z + (MSX5 * t419 - MSY5R * t420);
        let f5_z = MSX5 * t421 + MSY5R * t422 - t512;
        let n5_x = t521 + (t548 - MSY5R * t394);
        let n5_y = n6_z + (t549 + MSX5 * t394);
        let n5_z = t543 - YZ5 * t404 - (MSX5 * t401 + MSY5R * a5_x) - t522;
        let t576 = c5 * f5_x - s5 * f5_y;
        let t579 = s5 * f5_x + c5 * f5_y;
        let t588 = c5 * n5_x - s5 * n5_y - D5 * t579;
        let t589 = s5 * n5_x + c5 * n5_y + D5 * t576;
        [f5_z, n5_z, t576, t579, t588, t589]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t636, t639, t651, t652, t653] = {
        let t607 = YZ4 * (t310 - t381);
        let t610 = dw5_z * (XX4R - ZZ4R) + XY4 * t383 - XZ4 * t379 - YZ4 * t376;
        let t620 = MSY4R * t372;
        let t625 = dw4_x * (XX4R + ZZ4R) - XY4 * t382 + XZ4 * t376 + t607 - t620;
        let t627 = XY4 * (t380 + t381) - XX4R * t376 + (MSX4 * a4_y - MSY4R * a4_x);
        let f4_x = t576 + (MSX4 * t380 + MSY4R * t376);
        let f4_y = MSX4 * t376 - MSY4R * t381 - f5_z;
        let f4_z = t579 + (MSX4 * t382 + MSY4R * t383);
        let n4_x = t588 + t625;
        let n4_y = t610 + MSX4 * t372 - n5_z;
        let n4_z = t589 + t627;
        let t636 = c4 * f4_x - s4 * f4_y;
        let t639 = s4 * f4_x + c4 * f4_y;
        let t651 = c4 * n4_x - s4 * n4_y - D4 * t639;
        let t652 = s4 * n4_x + c4 * n4_y + (D4 * t636 + k3 * f4_z);
        let t653 = n4_z - k3 * t639;
        [f4_z, n4_z, t636, t639, t651, t652, t653]
    };
    // link 3: force and moment
    let [n3_z, t703, t709, t710] = {
        let t671 = YZ3 * (t310 - t350);
        let t674 = t346 * (XX3R - ZZ3R) + XY3 * t352 - XZ3R * t348 - YZ3 * t345;
        let t684 = MSY3 * t333;
        let t689 = dw3_x * (XX3R + ZZ3R) - XY3 * t351 + XZ3R * t345 + t671 - t684;
        let t691 = XY3 * (t349 + t350) - XX3R * t345 + (MSX3R * a3_y - MSY3 * a3_x);
        let f3_x = t636 + (MSX3R * t349 + MSY3 * t345);
        let f3_y = t639 + (MSX3R * t345 - MSY3 * t350);
        let f3_z = f4_z + (MSX3R * t351 + MSY3 * t352);
        let n3_x = t651 + t689;
        let n3_y = t652 + (t674 + MSX3R * t333);
        let n3_z = t653 + t691;
        let t703 = c3 * n3_x - s3 * n3_y;
        let t709 = s3 * n3_x + c3 * n3_y + k4 * f3_z;
        let t710 = n3_z - k4 * (s3 * f3_x + c3 * f3_y);
        [n3_z, t703, t709, t710]
    };
    // link 2: force and moment
    let [n2_z, n1_z] = {
        let t728 = YZ2 * (t310 - t322);
        let t731 = t318 * (XX2R - ZZ2R) + XY2 * t324 - XZ2R * t320 - YZ2 * t317;
        let t735 = XY2 * (t321 + t322) - XX2R * t317 + (MSX2R * a2_y - MSY2 * a2_x);
        let n2_x = t703 + (dw2_x * (XX2R + ZZ2R) - XY2 * t323 + XZ2R * t317 + t728);
        let n2_y = t709 + t731;
        let n2_z = t710 + t735;
        let n1_z = s2 * n2_x + c2 * n2_y;
        [n2_z, n1_z]
    };
    // drives
    let [t778, t779, t780, t781, t782, t783] = {
        let t778 = tau1 - (FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign()));
        let t779 = tau2 - (FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign()));
        let t780 = tau3 - (FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign()));
        let t781 = tau4 - (FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign()));
        let t782 = tau5 - (FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign()));
        let t783 = tau6 - (FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign()));
        [t778, t779, t780, t781, t782, t783]
    };
    // M = L D L'
    let [
        t784, t785, t786, t787, t788, t789, t793, t797,
        t800, t803, t806, t813, t820, t825, t830, t840,
        t850, t857, t870, t883, t899,
    ] = {
        let t784 = k6 / t309;
        let t785 = t299 * t784;
        let t786 = t261 * t784;
        let t787 = t200 * t784;
        let t788 = t135 * t784;
        let t789 = t64 * t784;
        let t792 = t293 - t309 * (t785 * t785);
        let t793 = k6 / t792;
        let t794 = t309 * t785;
        let t797 = t793 * (t258 - t786 * t794);
        let t800 = t793 * (t197 - t787 * t794);
        let t803 = t793 * (t132 - t788 * t794);
        let t806 = t793 * (t61 - t789 * t794);
        let t812 = t244 - t309 * (t786 * t786) - t792 * (t797 * t797);
        let t813 = k6 / t812;
        let t814 = t309 * t786;
        let t817 = t792 * t797;
        let t820 = t813 * (t186 - t787 * t814 - t800 * t817);
        let t825 = t813 * (t119 - t788 * t814 - t803 * t817);
        let t830 = t813 * (t48 - t789 * t814 - t806 * t817);
        let t838 = t812 * (t820 * t820);
        let t839 = t168 - t309 * (t787 * t787) - t792 * (t800 * t800) - t838;
        let t840 = k6 / t839;
        let t841 = t309 * t787;
        let t844 = t792 * t800;
        let t847 = t812 * t820;
        let t850 = t840 * (t103 - t788 * t841 - t803 * t844 - t825 * t847);
        let t857 = t840 * (t28 - t789 * t841 - t806 * t844 - t830 * t847);
        let t865 = t812 * (t825 * t825);
        let t868 = t839 * (t850 * t850);
        let t869 = t87 - t309 * (t788 * t788) - t792 * (t803 * t803) - t865 - t868;
        let t870 = k6 / t869;
        let t878 = t830 * (t812 * t825);
        let t881 = t857 * (t839 * t850);
        let t882 = t16 + t789 * (t309 * t788) + t806 * (t792 * t803) + t878 + t881;
        let t883 = t870 * t882;
        let t891 = t812 * (t830 * t830);
        let t894 = t839 * (t857 * t857);
        let t895 = t0 - t309 * (t789 * t789) - t792 * (t806 * t806) - t891 - t894;
        let t899 = k6 / (t895 - t869 * (t883 * t883));
        [
        t784, t785, t786, t787, t788, t789, t793, t797,
        t800, t803, t806, t813, t820, t825, t830, t840,
        t850, t857, t870, t883, t899,
    ]
    };
    // ddq
    {
        let t901 = t779 - t778 * t785;
        let t905 = t780 - t778 * t786 - t797 * t901;
        let t911 = t781 - t778 * t787 - t800 * t901 - t820 * t905;
        let t919 = t782 - t778 * t788 - t803 * t901 - t825 * t905 - t850 * t911;
        let t927 = t783 - t778 * t789 - t806 * t901 - t830 * t905 - t857 * t911;
        let t935 = t899 * (t927 + t883 * t919);
        let t937 = t870 * t919 + t883 * t935;
        let t941 = t840 * t911 - t850 * t937 - t857 * t935;
        let t947 = t813 * t905 - t820 * t941 - t825 * t937 - t830 * t935;
        let t954 = t806 * t935;
        let t955 = t793 * t901 - t797 * t947 - t800 * t941 - t803 * t937 - t954;
        let t962 = t788 * t937;
        let t963 = t778 * t784 - t785 * t955 - t786 * t947 - t787 * t941 - t962;
        let t965 = t963 - t789 * t935;
        put(0, t965);
        put(1, t955);
        put(2, t947);
        put(3, t941);
        put(4, t937);
        put(5, t935);
    }
}
