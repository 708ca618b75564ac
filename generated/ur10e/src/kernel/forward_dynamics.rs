//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 543 multiplications, 463 additions; 6, 6 of 6 structurally nonzero.

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
    // link 2: motion
    let [w2_x, w2_y, a2_x, a2_y, dw2_x, t315] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let a2_x = s2 * k5;
        let a2_y = c2 * k5;
        let dw2_x = dq2 * w2_y;
        let t315 = dq2 * w2_x;
        [w2_x, w2_y, a2_x, a2_y, dw2_x, t315]
    };
    // link 3: motion
    let [
        w3_x, w3_y, t328, t329, t330, t331, t333, t334,
        t337, a3_x, a3_y, w3_z, dw3_x, t350,
    ] = {
        let w3_x = c3 * w2_x + s3 * w2_y;
        let w3_y = c3 * w2_y - s3 * w2_x;
        let t328 = w2_x * w2_x;
        let t329 = w2_y * w2_y;
        let t330 = dq2 * dq2;
        let t331 = w2_x * w2_y;
        let t333 = t315 + t315;
        let t334 = dw2_x + dw2_x;
        let t337 = k4 * t333;
        let t338 = a2_x + k4 * (t329 + t330);
        let t339 = a2_y - k4 * t331;
        let a3_x = c3 * t338 + s3 * t339;
        let a3_y = c3 * t339 - s3 * t338;
        let w3_z = dq2 + dq3;
        let dw3_x = c3 * dw2_x - s3 * t315 + dq3 * w3_y;
        let t350 = c3 * t315 + s3 * dw2_x + dq3 * w3_x;
        [
        w3_x, w3_y, t328, t329, t330, t331, t333, t334,
        t337, a3_x, a3_y, w3_z, dw3_x, t350,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t363, t364, t365, t366, t367, t368,
        t369, t370, t371, t372, t373, t374, t387, a4_x,
        a4_y, w4_z, dw4_x, dw5_z,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_y;
        let w4_y = c4 * w3_y - s4 * w3_x;
        let t363 = w3_x * w3_x;
        let t364 = w3_y * w3_y;
        let t365 = w3_z * w3_z;
        let t366 = w3_x * w3_y;
        let t367 = w3_x * w3_z;
        let t368 = w3_y * w3_z;
        let t369 = t364 + t365;
        let t370 = t367 - t350;
        let t371 = t363 + t365;
        let t372 = t368 - dw3_x;
        let t373 = t350 + t367;
        let t374 = dw3_x + t368;
        let t385 = a3_x + (k3 * t369 + D4 * t370);
        let t386 = a3_y + (D4 * t372 - k3 * t366);
        let t387 = t337 + (k3 * t373 + D4 * (t363 + t364));
        let a4_x = c4 * t385 + s4 * t386;
        let a4_y = c4 * t386 - s4 * t385;
        let w4_z = w3_z + dq4;
        let dw4_x = c4 * dw3_x - s4 * t350 + dq4 * w4_y;
        let dw5_z = c4 * t350 + s4 * dw3_x + dq4 * w4_x;
        [
        w4_x, w4_y, t363, t364, t365, t366, t367, t368,
        t369, t370, t371, t372, t373, t374, t387, a4_x,
        a4_y, w4_z, dw4_x, dw5_z,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t407, t408, t409, t410, t411, t412,
        t413, t414, t415, t416, t417, t418, t423, a5_x,
        t430, w5_z, dw5_x, t435,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t407 = w4_x * w4_x;
        let t408 = w4_y * w4_y;
        let t409 = w4_z * w4_z;
        let t410 = w4_x * w4_y;
        let t411 = w4_x * w4_z;
        let t412 = w4_y * w4_z;
        let t413 = t408 + t409;
        let t414 = t411 - dw5_z;
        let t415 = t407 + t409;
        let t416 = t412 - dw4_x;
        let t417 = dw5_z + t411;
        let t418 = dw4_x + t412;
        let t422 = a4_x - D5 * t410;
        let t423 = a4_y + D5 * t415;
        let t424 = t387 + D5 * t418;
        let a5_x = c5 * t422 - s5 * t424;
        let t430 = c5 * t424 + s5 * t422;
        let w5_z = dq5 - w4_y;
        let dw5_x = c5 * dw4_x + dq5 * w5_y;
        let t435 = s5 * dw4_x + dq5 * w5_x;
        [
        w5_x, w5_y, t407, t408, t409, t410, t411, t412,
        t413, t414, t415, t416, t417, t418, t423, a5_x,
        t430, w5_z, dw5_x, t435,
    ]
    };
    // link 6: motion
    let [
        w6_x, t441, t448, t449, t450, t451, t452, t453,
        t454, t455, t456, t457, t458, t459, t460, t461,
        t466, a6_x, t473, w6_z, dw6_x, t478,
    ] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t441 = c6 * w5_z + s6 * w5_x;
        let t448 = w5_x * w5_x;
        let t449 = w5_y * w5_y;
        let t450 = w5_z * w5_z;
        let t451 = w5_x * w5_y;
        let t452 = w5_x * w5_z;
        let t453 = w5_y * w5_z;
        let t454 = t449 + t450;
        let t455 = t451 - dw5_z;
        let t456 = t452 - t435;
        let t457 = dw5_z + t451;
        let t458 = t448 + t450;
        let t459 = t453 - dw5_x;
        let t460 = t435 + t452;
        let t461 = dw5_x + t453;
        let t465 = a5_x + D6 * t455;
        let t466 = t430 + D6 * t458;
        let t467 = D6 * t461 - t423;
        let a6_x = c6 * t465 - s6 * t467;
        let t473 = c6 * t467 + s6 * t465;
        let w6_z = w5_y + dq6;
        let dw6_x = c6 * dw5_x - s6 * dw5_z - dq6 * t441;
        let t478 = c6 * dw5_z + s6 * dw5_x + dq6 * w6_x;
        [
        w6_x, t441, t448, t449, t450, t451, t452, t453,
        t454, t455, t456, t457, t458, t459, t460, t461,
        t466, a6_x, t473, w6_z, dw6_x, t478,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t541, t544, t553, t554] = {
        let t479 = w6_x * w6_x;
        let t480 = t441 * t441;
        let t481 = w6_z * w6_z;
        let t482 = w6_x * t441;
        let t483 = w6_x * w6_z;
        let t484 = t441 * w6_z;
        let t486 = t435 - t482;
        let t488 = t435 + t482;
        let t491 = t478 + t483;
        let t492 = dw6_x - t484;
        let t511 = XZ6 * (dw6_x + t484);
        let t516 = YZ6 * (t480 - t481);
        let t517 = YZ6 * t486;
        let t518 = YZ6 * (t483 - t478);
        let t519 = XX6R * dw6_x - ZZ6 * t484 - XY6 * t491 - XZ6 * t488 + t516;
        let t520 = t483 * (XX6R - ZZ6) + XY6 * t492 + XZ6 * (t481 - t479) - t517;
        let t521 = XX6R * t482 - ZZ6 * t435 + XY6 * (t479 - t480) + t511 + t518;
        let f6_x = MSY6 * t486 - MSX6 * (t480 + t481);
        let t527 = MSX6 * t488 + MSY6 * (t479 + t481);
        let f6_z = MSX6 * t491 + MSY6 * t492;
        let n6_x = t519 - MSY6 * t466;
        let n6_y = t520 + MSX6 * t466;
        let n6_z = t521 - (MSX6 * t473 + MSY6 * a6_x);
        let t541 = c6 * f6_x + s6 * t527;
        let t544 = s6 * f6_x - c6 * t527;
        let t553 = c6 * n6_x - s6 * n6_y - D6 * t544;
        let t554 = s6 * n6_x + c6 * n6_y + D6 * t541;
        [f6_z, n6_z, t541, t544, t553, t554]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t609, t612, t621, t622] = {
        let t576 = ZZ5R * dw5_z - XX5R * t451 + XY5 * (t448 - t449) - XZ5 * t459;
        let t578 = YZ5 * (t449 - t450);
        let t579 = YZ5 * t455;
        let t581 = ZZ5R * t453 + XX5R * dw5_x - XY5 * t460 + XZ5 * t457 + t578;
        let t582 = t452 * (XX5R - ZZ5R) + XY5 * t461 + XZ5 * (t450 - t448) - t579;
        let f5_x = t541 + (MSY5R * t455 - MSX5 * t454);
        let f5_y = f6_z + (MSX5 * t457 - MSY5R * t458);
        let f5_z = MSX5 * t460 + MSY5R * t461 - t544;
        let n5_x = t553 + (t581 - MSY5R * t423);
        let n5_y = n6_z + (t582 + MSX5 * t423);
        let n5_z = t576 + YZ5 * t456 - (MSX5 * t430 + MSY5R * a5_x) - t554;
        let t609 = c5 * f5_x - s5 * f5_y;
        let t612 = s5 * f5_x + c5 * f5_y;
        let t621 = c5 * n5_x - s5 * n5_y - D5 * t612;
        let t622 = s5 * n5_x + c5 * n5_y + D5 * t609;
        [f5_z, n5_z, t609, t612, t621, t622]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t675, t678, t690, t691, t692] = {
        let t644 = YZ4 * (t408 - t409);
        let t645 = YZ4 * t410;
        let t647 = ZZ4R * t412 + XX4R * dw4_x - XY4 * t417 + XZ4 * t410 + t644;
        let t648 = t411 * (XX4R - ZZ4R) + XY4 * t418 + XZ4 * (t409 - t407) - t645;
        let t649 = XY4 * (t407 - t408) - XX4R * t410 - XZ4 * t416 + YZ4 * t414;
        let f4_x = t609 + (MSY4R * t410 - MSX4 * t413);
        let f4_y = MSX4 * t410 - MSY4R * t415 - f5_z;
        let f4_z = t612 + (MSX4 * t417 + MSY4R * t418);
        let n4_x = t621 + (t647 - MSY4R * t387);
        let n4_y = t648 + MSX4 * t387 - n5_z;
        let n4_z = t622 + (t649 + (MSX4 * a4_y - MSY4R * a4_x));
        let t675 = c4 * f4_x - s4 * f4_y;
        let t678 = s4 * f4_x + c4 * f4_y;
        let t690 = c4 * n4_x - s4 * n4_y - D4 * t678;
        let t691 = s4 * n4_x + c4 * n4_y + (D4 * t675 + k3 * f4_z);
        let t692 = n4_z - k3 * t678;
        [f4_z, n4_z, t675, t678, t690, t691, t692]
    };
    // link 3: force and moment
    let [n3_z, t748, t754, t755] = {
        let t714 = YZ3 * (t364 - t365);
        let t715 = YZ3 * t366;
        let t717 = ZZ3R * t368 + XX3R * dw3_x - XY3 * t373 + XZ3R * t366 + t714;
        let t718 = t367 * (XX3R - ZZ3R) + XY3 * t374 + XZ3R * (t365 - t363) - t715;
        let t719 = XY3 * (t363 - t364) - XX3R * t366 - XZ3R * t372 + YZ3 * t370;
        let f3_x = t675 + (MSY3 * t366 - MSX3R * t369);
        let f3_y = t678 + (MSX3R * t366 - MSY3 * t371);
        let f3_z = f4_z + (MSX3R * t373 + MSY3 * t374);
        let n3_x = t690 + (t717 - MSY3 * t337);
        let n3_y = t691 + (t718 + MSX3R * t337);
        let n3_z = t692 + (t719 + (MSX3R * a3_y - MSY3 * a3_x));
        let t748 = c3 * n3_x - s3 * n3_y;
        let t754 = s3 * n3_x + c3 * n3_y + k4 * f3_z;
        let t755 = n3_z - k4 * (s3 * f3_x + c3 * f3_y);
        [n3_z, t748, t754, t755]
    };
    // link 2: force and moment
    let [n2_z, n1_z] = {
        let t774 = YZ2 * (t329 - t330);
        let t775 = YZ2 * t331;
        let t777 = t315 * (XX2R - ZZ2R) + XY2 * t334 + XZ2R * (t330 - t328) - t775;
        let t781 = XY2 * (t328 - t329) - XX2R * t331 + (MSX2R * a2_y - MSY2 * a2_x);
        let n2_x = t748 + (dw2_x * (XX2R + ZZ2R) - XY2 * t333 + XZ2R * t331 + t774);
        let n2_y = t754 + t777;
        let n2_z = t755 + t781;
        let n1_z = s2 * n2_x + c2 * n2_y;
        [n2_z, n1_z]
    };
    // drives
    let [t824, t825, t826, t827, t828, t829] = {
        let t824 = tau1 - (FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign()));
        let t825 = tau2 - (FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign()));
        let t826 = tau3 - (FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign()));
        let t827 = tau4 - (FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign()));
        let t828 = tau5 - (FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign()));
        let t829 = tau6 - (FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign()));
        [t824, t825, t826, t827, t828, t829]
    };
    // M = L D L'
    let [
        t830, t831, t832, t833, t834, t835, t839, t843,
        t846, t849, t852, t859, t866, t871, t876, t886,
        t896, t903, t916, t929, t945,
    ] = {
        let t830 = k6 / t309;
        let t831 = t299 * t830;
        let t832 = t261 * t830;
        let t833 = t200 * t830;
        let t834 = t135 * t830;
        let t835 = t64 * t830;
        let t838 = t293 - t309 * (t831 * t831);
        let t839 = k6 / t838;
        let t840 = t309 * t831;
        let t843 = t839 * (t258 - t832 * t840);
        let t846 = t839 * (t197 - t833 * t840);
        let t849 = t839 * (t132 - t834 * t840);
        let t852 = t839 * (t61 - t835 * t840);
        let t858 = t244 - t309 * (t832 * t832) - t838 * (t843 * t843);
        let t859 = k6 / t858;
        let t860 = t309 * t832;
        let t863 = t838 * t843;
        let t866 = t859 * (t186 - t833 * t860 - t846 * t863);
        let t871 = t859 * (t119 - t834 * t860 - t849 * t863);
        let t876 = t859 * (t48 - t835 * t860 - t852 * t863);
        let t884 = t858 * (t866 * t866);
        let t885 = t168 - t309 * (t833 * t833) - t838 * (t846 * t846) - t884;
        let t886 = k6 / t885;
        let t887 = t309 * t833;
        let t890 = t838 * t846;
        let t893 = t858 * t866;
        let t896 = t886 * (t103 - t834 * t887 - t849 * t890 - t871 * t893);
        let t903 = t886 * (t28 - t835 * t887 - t852 * t890 - t876 * t893);
        let t911 = t858 * (t871 * t871);
        let t914 = t885 * (t896 * t896);
        let t915 = t87 - t309 * (t834 * t834) - t838 * (t849 * t849) - t911 - t914;
        let t916 = k6 / t915;
        let t924 = t876 * (t858 * t871);
        let t927 = t903 * (t885 * t896);
        let t928 = t16 + t835 * (t309 * t834) + t852 * (t838 * t849) + t924 + t927;
        let t929 = t916 * t928;
        let t937 = t858 * (t876 * t876);
        let t940 = t885 * (t903 * t903);
        let t941 = t0 - t309 * (t835 * t835) - t838 * (t852 * t852) - t937 - t940;
        let t945 = k6 / (t941 - t915 * (t929 * t929));
        [
        t830, t831, t832, t833, t834, t835, t839, t843,
        t846, t849, t852, t859, t866, t871, t876, t886,
        t896, t903, t916, t929, t945,
    ]
    };
    // ddq
    {
        let t947 = t825 - t824 * t831;
        let t951 = t826 - t824 * t832 - t843 * t947;
        let t957 = t827 - t824 * t833 - t846 * t947 - t866 * t951;
        let t965 = t828 - t824 * t834 - t849 * t947 - t871 * t951 - t896 * t957;
        let t973 = t829 - t824 * t835 - t852 * t947 - t876 * t951 - t903 * t957;
        let t981 = t945 * (t973 + t929 * t965);
        let t983 = t916 * t965 + t929 * t981;
        let t987 = t886 * t957 - t896 * t983 - t903 * t981;
        let t993 = t859 * t951 - t866 * t987 - t871 * t983 - t876 * t981;
        let t1000 = t852 * t981;
        let t1001 = t839 * t947 - t843 * t993 - t846 * t987 - t849 * t983 - t1000;
        let t1008 = t834 * t983;
        let t1009 = t824 * t830 - t831 * t1001 - t832 * t993 - t833 * t987 - t1008;
        let t1011 = t1009 - t835 * t981;
        put(0, t1011);
        put(1, t1001);
        put(2, t993);
        put(3, t987);
        put(4, t983);
        put(5, t981);
    }
}
