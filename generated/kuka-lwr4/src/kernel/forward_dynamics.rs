//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 668 multiplications, 536 additions; 7, 7 of 7 structurally nonzero.

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
        FV6, FV7, FC1, FC2, FC3, FC4, FC5, FC6, FC7,
        ..] = *beta;
    let L2 = S::constant(0.4);
    let L3 = S::constant(0.39);
    let k2 = S::constant(9.81);
    let k3 = S::constant(1.0);
    // composite body 7
    let [
        t2, t5, t8, t11, t15, t18, t19, t35,
        t44, t60, t63, t72, t75, t78,
    ] = {
        let t2 = c7 * MSY7 + s7 * MSX7;
        let t5 = c7 * MSX7 - s7 * MSY7;
        let t8 = c7 * XZ7 - s7 * YZ7;
        let t11 = s7 * XZ7 + c7 * YZ7;
        let t12 = c6 * t2;
        let t15 = s6 * ZZ7;
        let t16 = c6 * t8 - t15;
        let t18 = c6 * ZZ7;
        let t19 = s6 * t8 + t18;
        let t22 = c5 * t12 + s5 * t5;
        let t25 = c5 * t5 - s5 * t12;
        let t34 = c5 * t16 - s5 * t11 - L3 * t25;
        let t35 = s5 * t16 + c5 * t11 - L3 * t22;
        let t38 = c4 * t22 + s4 * (s6 * t2);
        let t41 = c4 * t34 + s4 * t19;
        let t44 = s4 * t34 - c4 * t19;
        let t59 = c3 * t41 - s3 * t35 - L2 * (c3 * t25 - s3 * t38);
        let t60 = s3 * t41 + c3 * t35 - L2 * (c3 * t38 + s3 * t25);
        let t63 = s2 * t59 - c2 * t44;
        let t65 = s7 * XY7;
        let t68 = c7 * XY7;
        let t69 = s7 * XX7R + t68;
        let t72 = c7 * (c7 * XX7R - t65) - s7 * t68;
        let t75 = c7 * t69 - s7 * t65;
        let t78 = s7 * t69 + c7 * t65;
        [
        t2, t5, t8, t11, t15, t18, t19, t35,
        t44, t60, t63, t72, t75, t78,
    ]
    };
    // composite body 6
    let [
        t81, t87, t90, t93, t96, t100, t103, t108,
        t117, t133, t136, t147, t150, t153, t154,
    ] = {
        let t79 = MSX6 + t5;
        let t80 = XX6R + t72;
        let t81 = ZZ6R + t78;
        let t82 = XY6 + t8;
        let t83 = XZ6 - t75;
        let t84 = YZ6 - t11;
        let t87 = c6 * MSY6R + s6 * t79;
        let t90 = c6 * t79 - s6 * MSY6R;
        let t93 = c6 * t83 - s6 * t84;
        let t96 = s6 * t83 + c6 * t84;
        let t97 = c5 * t87;
        let t98 = s5 * t87;
        let t100 = s5 * t81;
        let t103 = c5 * t81;
        let t107 = c5 * t93 + t100 + L3 * t98;
        let t108 = s5 * t93 - t103 - L3 * t97;
        let t111 = s4 * t90 - c4 * t97;
        let t114 = c4 * t107 + s4 * t96;
        let t117 = s4 * t107 - c4 * t96;
        let t132 = c3 * t114 - s3 * t108 - L2 * (s3 * t111 - c3 * t98);
        let t133 = s3 * t114 + c3 * t108 + L2 * (c3 * t111 + s3 * t98);
        let t136 = s2 * t132 - c2 * t117;
        let t138 = s6 * t82;
        let t141 = c6 * t82;
        let t142 = s6 * t80 + t141;
        let t144 = t18 + t138;
        let t147 = c6 * (c6 * t80 - t138) - s6 * (t141 - t15);
        let t150 = c6 * t142 - s6 * t144;
        let t153 = s6 * t142 + c6 * t144;
        let t154 = t87 + t87;
        [
        t81, t87, t90, t93, t96, t100, t103, t108,
        t117, t133, t136, t147, t150, t153, t154,
    ]
    };
    // composite body 5
    let [
        t158, t164, t167, t176, t177, t184, t200, t203,
        t217, t222, t223, t227,
    ] = {
        let t155 = MSX5 + t90;
        let t156 = MSY5R + t2;
        let t157 = XX5R + t147;
        let t158 = ZZ5R + t153;
        let t159 = XY5 - t93;
        let t160 = XZ5 + t150;
        let t161 = YZ5 - t96;
        let t164 = c5 * t156 + s5 * t155;
        let t167 = c5 * t155 - s5 * t156;
        let t176 = c5 * t160 - s5 * t161 - L3 * t167;
        let t177 = s5 * t160 + c5 * t161 - L3 * t164;
        let t178 = c4 * t164;
        let t181 = c4 * t176 + s4 * t158;
        let t184 = s4 * t176 - c4 * t158;
        let t199 = c3 * t181 - s3 * t177 - L2 * (c3 * t167 - s3 * t178);
        let t200 = s3 * t181 + c3 * t177 - L2 * (c3 * t178 + s3 * t167);
        let t203 = s2 * t199 - c2 * t184;
        let t205 = s5 * t159;
        let t208 = c5 * t159;
        let t209 = s5 * t157 + t208;
        let t211 = t103 + t205;
        let t217 = c5 * t209 - s5 * t211;
        let t221 = L3 * t154;
        let t222 = c5 * (c5 * t157 - t205) - s5 * (t208 - t100) + t221;
        let t223 = s5 * t209 + c5 * t211 + t221;
        let t225 = L3 * t87;
        let t227 = t158 + t221 - (t225 + t225);
        [
        t158, t164, t167, t176, t177, t184, t200, t203,
        t217, t222, t223, t227,
    ]
    };
    // composite body 4
    let [
        t231, t237, t240, t243, t246, t250, t253, t258,
        t261, t274, t277, t280, t281,
    ] = {
        let t228 = MSX4 + t167;
        let t229 = MSY4R - t87;
        let t230 = XX4R + t222;
        let t231 = ZZ4R + t223;
        let t232 = XY4 - t176;
        let t233 = XZ4 + t217;
        let t234 = YZ4 - t177;
        let t237 = c4 * t229 + s4 * t228;
        let t240 = c4 * t228 - s4 * t229;
        let t243 = c4 * t233 - s4 * t234;
        let t246 = s4 * t233 + c4 * t234;
        let t250 = s3 * t231;
        let t253 = c3 * t231;
        let t258 = s3 * t243 + t253 - L2 * (c3 * t237);
        let t261 = s2 * (c3 * t243 - t250 + L2 * (s3 * t237)) - c2 * t246;
        let t263 = s4 * t232;
        let t266 = c4 * t232;
        let t267 = s4 * t230 + t266;
        let t271 = t263 + c4 * t227;
        let t274 = c4 * (c4 * t230 - t263) - s4 * (t266 - s4 * t227);
        let t277 = c4 * t267 - s4 * t271;
        let t280 = s4 * t267 + c4 * t271;
        let t281 = t237 + t237;
        [
        t231, t237, t240, t243, t246, t250, t253, t258,
        t261, t274, t277, t280, t281,
    ]
    };
    // composite body 3
    let [t285, t303, t304, t307, t321, t326, t327, t331] = {
        let t282 = MSX3 + t240;
        let t283 = MSY3R + t164;
        let t284 = XX3R + t274;
        let t285 = ZZ3R + t280;
        let t286 = XY3 + t243;
        let t287 = XZ3 - t277;
        let t288 = YZ3 - t246;
        let t303 = c3 * t287 - s3 * t288 - L2 * (c3 * t282 - s3 * t283);
        let t304 = s3 * t287 + c3 * t288 - L2 * (c3 * t283 + s3 * t282);
        let t307 = s2 * t303 + c2 * t285;
        let t309 = s3 * t286;
        let t312 = c3 * t286;
        let t313 = s3 * t284 + t312;
        let t315 = t253 + t309;
        let t321 = c3 * t313 - s3 * t315;
        let t325 = L2 * t281;
        let t326 = c3 * (c3 * t284 - t309) - s3 * (t312 - t250) - t325;
        let t327 = s3 * t313 + c3 * t315 - t325;
        let t329 = L2 * t237;
        let t331 = t285 - t325 + (t329 + t329);
        [t285, t303, t304, t307, t321, t326, t327, t331]
    };
    // composite body 2
    let [t333, t339, t348] = {
        let t333 = ZZ2R + t327;
        let t334 = XY2 + t303;
        let t339 = s2 * (XZ2 - t321) + c2 * (YZ2 - t304);
        let t347 = c2 * (s2 * t334 + c2 * t331);
        let t348 = s2 * (s2 * (XX2R + t326) + c2 * t334) + t347;
        [t333, t339, t348]
    };
    // composite body 1
    let t349 = {
        let t349 = ZZ1R + t348;
        t349
    };
    // link 2: motion
    let [w2_x, w2_y, a2_x, a2_y, dw2_x, t355] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let a2_x = s2 * k2;
        let a2_y = c2 * k2;
        let dw2_x = dq2 * w2_y;
        let t355 = dq2 * w2_x;
        [w2_x, w2_y, a2_x, a2_y, dw2_x, t355]
    };
    // link 3: motion
    let [
        w3_x, t361, t364, t365, t366, t367, t369, t370,
        a3_z, a3_x, t381, w3_z, dw3_x, t386,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t361 = c3 * dq2 + s3 * w2_x;
        let t364 = w2_x * w2_x;
        let t365 = w2_y * w2_y;
        let t366 = dq2 * dq2;
        let t367 = w2_x * w2_y;
        let t369 = t355 + t355;
        let t370 = dw2_x + dw2_x;
        let t373 = L2 * t370;
        let t374 = a2_x + L2 * t367;
        let a3_z = a2_y - L2 * (t364 + t366);
        let a3_x = c3 * t374 - s3 * t373;
        let t381 = c3 * t373 + s3 * t374;
        let w3_z = w2_y + dq3;
        let dw3_x = c3 * dw2_x - dq3 * t361;
        let t386 = s3 * dw2_x + dq3 * w3_x;
        [
        w3_x, t361, t364, t365, t366, t367, t369, t370,
        a3_z, a3_x, t381, w3_z, dw3_x, t386,
    ]
    };
    // link 4: motion
    let [
        w4_x, t392, t399, t400, t401, t402, t403, t404,
        t405, t406, t407, t408, t409, t410, t411, t412,
        a4_x, t418, w4_z, dw4_x, dw4_y,
    ] = {
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t392 = c4 * w3_z + s4 * w3_x;
        let t399 = w3_x * w3_x;
        let t400 = t361 * t361;
        let t401 = w3_z * w3_z;
        let t402 = w3_x * t361;
        let t403 = w3_x * w3_z;
        let t404 = t361 * w3_z;
        let t405 = t400 + t401;
        let t406 = t355 - t402;
        let t407 = t403 - t386;
        let t408 = t355 + t402;
        let t409 = t399 + t401;
        let t410 = dw3_x + t404;
        let t411 = t386 + t403;
        let t412 = dw3_x - t404;
        let a4_x = c4 * a3_x - s4 * a3_z;
        let t418 = c4 * a3_z + s4 * a3_x;
        let w4_z = dq4 - t361;
        let dw4_x = c4 * dw3_x + s4 * t355 - dq4 * t392;
        let dw4_y = c4 * t355 - s4 * dw3_x - dq4 * w4_x;
        [
        w4_x, t392, t399, t400, t401, t402, t403, t404,
        t405, t406, t407, t408, t409, t410, t411, t412,
        a4_x, t418, w4_z, dw4_x, dw4_y,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t436, t437, t438, t439, t440, t441,
        t442, t443, t444, t445, t446, t447, t448, t449,
        t454, a5_x, a6_z, w5_z, dw5_x, dw6_z,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t436 = w4_x * w4_x;
        let t437 = t392 * t392;
        let t438 = w4_z * w4_z;
        let t439 = w4_x * t392;
        let t440 = w4_x * w4_z;
        let t441 = t392 * w4_z;
        let t442 = t437 + t438;
        let t443 = t386 - t439;
        let t444 = dw4_y + t440;
        let t445 = t386 + t439;
        let t446 = t436 + t438;
        let t447 = dw4_x + t441;
        let t448 = t440 - dw4_y;
        let t449 = dw4_x - t441;
        let t453 = a4_x - L3 * t443;
        let t454 = L3 * t446 - t418;
        let t455 = t381 + L3 * t449;
        let a5_x = c5 * t453 - s5 * t455;
        let a6_z = c5 * t455 + s5 * t453;
        let w5_z = t392 + dq5;
        let dw5_x = c5 * dw4_x - s5 * t386 + dq5 * w5_y;
        let dw6_z = c5 * t386 + s5 * dw4_x + dq5 * w5_x;
        [
        w5_x, w5_y, t436, t437, t438, t439, t440, t441,
        t442, t443, t444, t445, t446, t447, t448, t449,
        t454, a5_x, a6_z, w5_z, dw5_x, dw6_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t479, t480, t481, t482, t483, t484,
        t485, t486, t487, t488, t489, t490, t491, t492,
        a6_x, t498, w6_z, dw6_x, t503,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t479 = w5_x * w5_x;
        let t480 = w5_y * w5_y;
        let t481 = w5_z * w5_z;
        let t482 = w5_x * w5_y;
        let t483 = w5_x * w5_z;
        let t484 = w5_y * w5_z;
        let t485 = t480 + t481;
        let t486 = dw4_y + t482;
        let t487 = t483 - dw6_z;
        let t488 = t482 - dw4_y;
        let t489 = t479 + t481;
        let t490 = t484 - dw5_x;
        let t491 = dw6_z + t483;
        let t492 = dw5_x + t484;
        let a6_x = c6 * a5_x - s6 * t454;
        let t498 = c6 * t454 + s6 * a5_x;
        let w6_z = dq6 - w5_y;
        let dw6_x = c6 * dw5_x - s6 * dw4_y + dq6 * w6_y;
        let t503 = c6 * dw4_y + s6 * dw5_x + dq6 * w6_x;
        [
        w6_x, w6_y, t479, t480, t481, t482, t483, t484,
        t485, t486, t487, t488, t489, t490, t491, t492,
        a6_x, t498, w6_z, dw6_x, t503,
    ]
    };
    // link 7: motion
    let [
        w7_x, t509, t516, t517, t518, t519, t520, t521,
        t522, t523, t524, t525, t526, t527, t528, t529,
        a7_x, t535, w7_z, dw7_x, t540,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t509 = c7 * w6_z + s7 * w6_x;
        let t516 = w6_x * w6_x;
        let t517 = w6_y * w6_y;
        let t518 = w6_z * w6_z;
        let t519 = w6_x * w6_y;
        let t520 = w6_x * w6_z;
        let t521 = w6_y * w6_z;
        let t522 = t517 + t518;
        let t523 = t519 - dw6_z;
        let t524 = t520 - t503;
        let t525 = dw6_z + t519;
        let t526 = t516 + t518;
        let t527 = t521 - dw6_x;
        let t528 = t503 + t520;
        let t529 = dw6_x + t521;
        let a7_x = c7 * a6_x - s7 * a6_z;
        let t535 = c7 * a6_z + s7 * a6_x;
        let w7_z = w6_y + dq7;
        let dw7_x = c7 * dw6_x - s7 * dw6_z - dq7 * t509;
        let t540 = c7 * dw6_z + s7 * dw6_x + dq7 * w7_x;
        [
        w7_x, t509, t516, t517, t518, t519, t520, t521,
        t522, t523, t524, t525, t526, t527, t528, t529,
        a7_x, t535, w7_z, dw7_x, t540,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t603, t606, t609, t612] = {
        let t541 = w7_x * w7_x;
        let t542 = t509 * t509;
        let t543 = w7_z * w7_z;
        let t544 = w7_x * t509;
        let t545 = w7_x * w7_z;
        let t546 = t509 * w7_z;
        let t548 = t503 - t544;
        let t550 = t503 + t544;
        let t553 = t540 + t545;
        let t554 = dw7_x - t546;
        let t573 = XZ7 * (dw7_x + t546);
        let t578 = YZ7 * (t542 - t543);
        let t579 = YZ7 * t548;
        let t580 = YZ7 * (t545 - t540);
        let t581 = XX7R * dw7_x - ZZ7 * t546 - XY7 * t553 - XZ7 * t550 + t578;
        let t582 = t545 * (XX7R - ZZ7) + XY7 * t554 + XZ7 * (t543 - t541) - t579;
        let t583 = XX7R * t544 - ZZ7 * t503 + XY7 * (t541 - t542) + t573 + t580;
        let f7_x = MSY7 * t548 - MSX7 * (t542 + t543);
        let t589 = MSX7 * t550 + MSY7 * (t541 + t543);
        let f7_z = MSX7 * t553 + MSY7 * t554;
        let n7_x = t581 - MSY7 * t498;
        let n7_y = t582 + MSX7 * t498;
        let n7_z = t583 - (MSX7 * t535 + MSY7 * a7_x);
        let t603 = c7 * f7_x + s7 * t589;
        let t606 = s7 * f7_x - c7 * t589;
        let t609 = c7 * n7_x - s7 * n7_y;
        let t612 = s7 * n7_x + c7 * n7_y;
        [f7_z, n7_z, t603, t606, t609, t612]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t667, t670, t673, t676] = {
        let t634 = ZZ6R * dw6_z - XX6R * t519 + XY6 * (t516 - t517) - XZ6 * t527;
        let t636 = YZ6 * (t517 - t518);
        let t637 = YZ6 * t523;
        let t639 = ZZ6R * t521 + XX6R * dw6_x - XY6 * t528 + XZ6 * t525 + t636;
        let t640 = t520 * (XX6R - ZZ6R) + XY6 * t529 + XZ6 * (t518 - t516) - t637;
        let f6_x = t603 + (MSY6R * t523 - MSX6 * t522);
        let f6_y = f7_z + (MSX6 * t525 - MSY6R * t526);
        let f6_z = MSX6 * t528 + MSY6R * t529 - t606;
        let n6_x = t609 + (t639 + MSY6R * a6_z);
        let n6_y = n7_z + (t640 - MSX6 * a6_z);
        let n6_z = t634 + YZ6 * t524 - (MSX6 * t498 + MSY6R * a6_x) - t612;
        let t667 = c6 * f6_x - s6 * f6_y;
        let t670 = s6 * f6_x + c6 * f6_y;
        let t673 = c6 * n6_x - s6 * n6_y;
        let t676 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t667, t670, t673, t676]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t731, t734, t743, t744] = {
        let t698 = XY5 * (t479 - t480) - (XX5R * t482 + ZZ5R * dw4_y) - XZ5 * t490;
        let t700 = YZ5 * (t480 - t481);
        let t701 = YZ5 * t486;
        let t703 = ZZ5R * t484 + XX5R * dw5_x - XY5 * t491 + XZ5 * t488 + t700;
        let t704 = t483 * (XX5R - ZZ5R) + XY5 * t492 + XZ5 * (t481 - t479) - t701;
        let f5_x = t667 + (MSY5R * t486 - MSX5 * t485);
        let f5_y = MSX5 * t488 - MSY5R * t489 - f6_z;
        let f5_z = t670 + (MSX5 * t491 + MSY5R * t492);
        let n5_x = t673 + (t703 - MSY5R * t454);
        let n5_y = t704 + MSX5 * t454 - n6_z;
        let n5_z = t676 + (t698 + YZ5 * t487 - (MSX5 * a6_z + MSY5R * a5_x));
        let t731 = c5 * f5_x - s5 * f5_y;
        let t734 = s5 * f5_x + c5 * f5_y;
        let t743 = c5 * n5_x - s5 * n5_y - L3 * t734;
        let t744 = s5 * n5_x + c5 * n5_y + L3 * t731;
        [f5_z, n5_z, t731, t734, t743, t744]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t799, t802, t805] = {
        let t766 = XX4R * t439 - ZZ4R * t386 + XY4 * (t436 - t437) + XZ4 * t447;
        let t768 = YZ4 * (t437 - t438);
        let t769 = YZ4 * t443;
        let t771 = XX4R * dw4_x - ZZ4R * t441 - XY4 * t448 - XZ4 * t445 + t768;
        let t772 = t440 * (XX4R - ZZ4R) + XY4 * t449 + XZ4 * (t438 - t436) - t769;
        let f4_x = t731 + (MSY4R * t443 - MSX4 * t442);
        let f4_z = t734 + (MSX4 * t448 + MSY4R * t449);
        let n4_x = t743 + (t771 - MSY4R * t381);
        let n4_y = t772 + MSX4 * t381 - n5_z;
        let n4_z = t744 + (t766 + YZ4 * t444 - (MSX4 * t418 + MSY4R * a4_x));
        let t799 = c4 * f4_x + s4 * (f5_z + (MSX4 * t445 + MSY4R * t446));
        let t802 = c4 * n4_x - s4 * n4_y;
        let t805 = s4 * n4_x + c4 * n4_y;
        [f4_z, n4_z, t799, t802, t805]
    };
    // link 3: force and moment
    let [n3_z, t868, t869] = {
        let t827 = XX3R * t402 - ZZ3R * t355 + XY3 * (t399 - t400) + XZ3 * t410;
        let t829 = YZ3 * (t400 - t401);
        let t830 = YZ3 * t406;
        let t832 = XX3R * dw3_x - ZZ3R * t404 - XY3 * t411 - XZ3 * t408 + t829;
        let t833 = t403 * (XX3R - ZZ3R) + XY3 * t412 + XZ3 * (t401 - t399) - t830;
        let f3_x = t799 + (MSY3R * t406 - MSX3 * t405);
        let f3_y = f4_z - (MSX3 * t408 + MSY3R * t409);
        let n3_x = t802 + (t832 + MSY3R * a3_z);
        let n3_y = n4_z + (t833 - MSX3 * a3_z);
        let n3_z = t827 + YZ3 * t407 - (MSX3 * t381 + MSY3R * a3_x) - t805;
        let t868 = c3 * n3_x - s3 * n3_y - L2 * (s3 * f3_x + c3 * f3_y);
        let t869 = s3 * n3_x + c3 * n3_y + L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, t868, t869]
    };
    // link 2: force and moment
    let [n2_z, n1_z] = {
        let t888 = YZ2 * (t365 - t366);
        let t889 = YZ2 * t367;
        let t891 = t355 * (XX2R - ZZ2R) + XY2 * t370 + XZ2 * (t366 - t364) - t889;
        let t895 = XY2 * (t364 - t365) - XX2R * t367 + (MSX2 * a2_y - MSY2R * a2_x);
        let n2_x = t868 + (dw2_x * (XX2R + ZZ2R) - XY2 * t369 + XZ2 * t367 + t888);
        let n2_y = n3_z + t891;
        let n2_z = t895 - t869;
        let n1_z = s2 * n2_x + c2 * n2_y;
        [n2_z, n1_z]
    };
    // drives
    let [t937, t938, t939, t940, t941, t942, t943] = {
        let t937 = tau1 - (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t938 = tau2 - (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t939 = tau3 - (n3_z + FV3 * dq3 + FC3 * dq3.sign());
        let t940 = tau4 - (n4_z + FV4 * dq4 + FC4 * dq4.sign());
        let t941 = tau5 - (n5_z + FV5 * dq5 + FC5 * dq5.sign());
        let t942 = tau6 - (n6_z + FV6 * dq6 + FC6 * dq6.sign());
        let t943 = tau7 - (n7_z + FV7 * dq7 + FC7 * dq7.sign());
        [t937, t938, t939, t940, t941, t942, t943]
    };
    // M = L D L'
    let [
        t944, t945, t946, t947, t948, t949, t950, t954,
        t958, t961, t964, t967, t970, t977, t984, t989,
        t994, t999, t1009, t1019, t1026, t1033, t1046, t1059,
        t1068, t1084, t1100, t1119,
    ] = {
        let t944 = k3 / t349;
        let t945 = t339 * t944;
        let t946 = t307 * t944;
        let t947 = t261 * t944;
        let t948 = t203 * t944;
        let t949 = t136 * t944;
        let t950 = t63 * t944;
        let t953 = t333 - t349 * (t945 * t945);
        let t954 = k3 / t953;
        let t955 = t349 * t945;
        let t958 = t954 * (t304 + t946 * t955);
        let t961 = t954 * (t258 + t947 * t955);
        let t964 = t954 * (t200 + t948 * t955);
        let t967 = t954 * (t133 + t949 * t955);
        let t970 = t954 * (t60 + t950 * t955);
        let t976 = t285 - t349 * (t946 * t946) - t953 * (t958 * t958);
        let t977 = k3 / t976;
        let t978 = t349 * t946;
        let t981 = t953 * t958;
        let t984 = t977 * (t246 + t947 * t978 + t961 * t981);
        let t989 = t977 * (t184 + t948 * t978 + t964 * t981);
        let t994 = t977 * (t117 + t949 * t978 + t967 * t981);
        let t999 = t977 * (t44 + t950 * t978 + t970 * t981);
        let t1007 = t976 * (t984 * t984);
        let t1008 = t231 - t349 * (t947 * t947) - t953 * (t961 * t961) - t1007;
        let t1009 = k3 / t1008;
        let t1010 = t349 * t947;
        let t1013 = t953 * t961;
        let t1016 = t976 * t984;
        let t1019 = t1009 * (t177 - t948 * t1010 - t964 * t1013 - t989 * t1016);
        let t1026 = t1009 * (t108 - t949 * t1010 - t967 * t1013 - t994 * t1016);
        let t1033 = t1009 * (t35 - t950 * t1010 - t970 * t1013 - t999 * t1016);
        let t1041 = t976 * (t989 * t989);
        let t1044 = t1008 * (t1019 * t1019);
        let t1045 = t158 - t349 * (t948 * t948) - t953 * (t964 * t964) - t1041 - t1044;
        let t1046 = k3 / t1045;
        let t1047 = t349 * t948;
        let t1050 = t953 * t964;
        let t1053 = t976 * t989;
        let t1056 = t1008 * t1019;
        let t1058 = t96 - t949 * t1047 - t967 * t1050 - t994 * t1053 - t1026 * t1056;
        let t1059 = t1046 * t1058;
        let t1067 = t19 - t950 * t1047 - t970 * t1050 - t999 * t1053 - t1033 * t1056;
        let t1068 = t1046 * t1067;
        let t1076 = t976 * (t994 * t994);
        let t1079 = t1008 * (t1026 * t1026);
        let t1080 = t81 - t349 * (t949 * t949) - t953 * (t967 * t967) - t1076 - t1079;
        let t1083 = t1080 - t1045 * (t1059 * t1059);
        let t1084 = k3 / t1083;
        let t1092 = t999 * (t976 * t994);
        let t1095 = t1033 * (t1008 * t1026);
        let t1096 = t11 + t950 * (t349 * t949) + t970 * (t953 * t967) + t1092 + t1095;
        let t1100 = t1084 * (t1096 + t1068 * (t1045 * t1059));
        let t1108 = t976 * (t999 * t999);
        let t1111 = t1008 * (t1033 * t1033);
        let t1112 = ZZ7 - t349 * (t950 * t950) - t953 * (t970 * t970) - t1108 - t1111;
        let t1119 = k3 / (t1112 - t1045 * (t1068 * t1068) - t1083 * (t1100 * t1100));
        [
        t944, t945, t946, t947, t948, t949, t950, t954,
        t958, t961, t964, t967, t970, t977, t984, t989,
        t994, t999, t1009, t1019, t1026, t1033, t1046, t1059,
        t1068, t1084, t1100, t1119,
    ]
    };
    // ddq
    {
        let t1121 = t938 - t937 * t945;
        let t1125 = t939 - t937 * t946 + t958 * t1121;
        let t1131 = t940 - t937 * t947 + t961 * t1121 + t984 * t1125;
        let t1139 = t941 - t937 * t948 + t964 * t1121 + t989 * t1125 - t1019 * t1131;
        let t1147 = t942 - t937 * t949 + t967 * t1121 + t994 * t1125 - t1026 * t1131;
        let t1149 = t1147 - t1059 * t1139;
        let t1157 = t943 - t937 * t950 + t970 * t1121 + t999 * t1125 - t1033 * t1131;
        let t1168 = t1119 * (t1157 - t1068 * t1139 + t1100 * t1149);
        let t1170 = t1084 * t1149 + t1100 * t1168;
        let t1174 = t1046 * t1139 - t1059 * t1170 - t1068 * t1168;
        let t1180 = t1009 * t1131 - t1019 * t1174 - t1026 * t1170 - t1033 * t1168;
        let t1187 = t999 * t1168;
        let t1188 = t977 * t1125 + t984 * t1180 + t989 * t1174 + t994 * t1170 + t1187;
        let t1195 = t967 * t1170;
        let t1196 = t954 * t1121 + t958 * t1188 + t961 * t1180 + t964 * t1174 + t1195;
        let t1198 = t1196 + t970 * t1168;
        let t1205 = t948 * t1174;
        let t1206 = t937 * t944 - t945 * t1198 - t946 * t1188 - t947 * t1180 - t1205;
        let t1210 = t1206 - t949 * t1170 - t950 * t1168;
        put(0, t1210);
        put(1, t1198);
        put(2, t1188);
        put(3, t1180);
        put(4, t1174);
        put(5, t1170);
        put(6, t1168);
    }
}
