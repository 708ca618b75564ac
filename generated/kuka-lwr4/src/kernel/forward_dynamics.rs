//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 655 multiplications, 529 additions; 7, 7 of 7 structurally nonzero.

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
    // link 1: motion
    let t350 = {
        let t350 = dq1 * dq1;
        t350
    };
    // link 2: motion
    let [
        w2_x, w2_y, a2_x, a2_y, t357, t358, dw2_x, t360,
        t361, t362, t363, t364,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let a2_x = s2 * k2;
        let a2_y = c2 * k2;
        let t355 = w2_x * w2_x;
        let t356 = dq2 * dq2;
        let t357 = w2_x * w2_y;
        let t358 = dq2 * w2_x;
        let dw2_x = dq2 * w2_y;
        let t360 = t355 - t356;
        let t361 = t360 - t350;
        let t362 = t355 + t356;
        let t363 = t358 + t358;
        let t364 = dw2_x + dw2_x;
        [
        w2_x, w2_y, a2_x, a2_y, t357, t358, dw2_x, t360,
        t361, t362, t363, t364,
    ]
    };
    // link 3: motion
    let [
        w3_x, t370, a3_z, a3_x, t381, t384, t387, w3_z,
        t391, t392, t393, dw3_x, dw3_y, t396, t397, t398,
        t399, t400, t401, t402,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t370 = c3 * dq2 + s3 * w2_x;
        let t373 = L2 * t364;
        let t374 = a2_x + L2 * t357;
        let a3_z = a2_y - L2 * t362;
        let a3_x = c3 * t374 - s3 * t373;
        let t381 = c3 * t373 + s3 * t374;
        let t384 = c3 * t357 - s3 * t364;
        let t387 = c3 * t364 + s3 * t357;
        let w3_z = w2_y + dq3;
        let t389 = w3_x * w3_x;
        let t390 = w3_z * w3_z;
        let t391 = w3_x * t370;
        let t392 = w3_x * w3_z;
        let t393 = t370 * w3_z;
        let dw3_x = t387 - t393;
        let dw3_y = t384 - t392;
        let t396 = t389 - t390;
        let t397 = t396 - t362;
        let t398 = t358 - t391;
        let t399 = t358 + t391;
        let t400 = t389 + t390;
        let t401 = t392 - dw3_y;
        let t402 = dw3_x - t393;
        [
        w3_x, t370, a3_z, a3_x, t381, t384, t387, w3_z,
        t391, t392, t393, dw3_x, dw3_y, t396, t397, t398,
        t399, t400, t401, t402,
    ]
    };
    // link 4: motion
    let [
        w4_x, t408, a4_x, t414, t417, t420, w4_z, t424,
        t425, t426, dw4_x, dw4_y, t429, t430, t431, t432,
        t433, t434, t435,
    ] = {
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t408 = c4 * w3_z + s4 * w3_x;
        let a4_x = c4 * a3_x - s4 * a3_z;
        let t414 = c4 * a3_z + s4 * a3_x;
        let t417 = c4 * t398 - s4 * t402;
        let t420 = c4 * t402 + s4 * t398;
        let w4_z = dq4 - t370;
        let t422 = w4_x * w4_x;
        let t423 = w4_z * w4_z;
        let t424 = w4_x * t408;
        let t425 = w4_x * w4_z;
        let t426 = t408 * w4_z;
        let dw4_x = t420 - t426;
        let dw4_y = t417 - t425;
        let t429 = t422 - t423;
        let t430 = t429 - t400;
        let t431 = dw3_y + t424;
        let t432 = dw3_y - t424;
        let t433 = t422 + t423;
        let t434 = t425 - dw4_y;
        let t435 = dw4_x - t426;
        [
        w4_x, t408, a4_x, t414, t417, t420, w4_z, t424,
        t425, t426, dw4_x, dw4_y, t429, t430, t431, t432,
        t433, t434, t435,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t446, a5_x, a6_z, t456, t459, w5_z,
        t463, t464, t465, dw5_x, dw5_y, t468, t469, t470,
        t471, t472, t473, t474,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t445 = a4_x + L3 * t431;
        let t446 = L3 * t433 - t414;
        let t447 = t381 + L3 * t435;
        let a5_x = c5 * t445 - s5 * t447;
        let a6_z = c5 * t447 + s5 * t445;
        let t456 = c5 * t431 - s5 * t435;
        let t459 = c5 * t435 + s5 * t431;
        let w5_z = t408 + dq5;
        let t461 = w5_x * w5_x;
        let t462 = w5_z * w5_z;
        let t463 = w5_x * w5_y;
        let t464 = w5_x * w5_z;
        let t465 = w5_y * w5_z;
        let dw5_x = t459 + t465;
        let dw5_y = t456 - t464;
        let t468 = t461 - t462;
        let t469 = t468 - t433;
        let t470 = dw4_y + t463;
        let t471 = t463 - dw4_y;
        let t472 = t461 + t462;
        let t473 = t464 - dw5_y;
        let t474 = t465 + dw5_x;
        [
        w5_x, w5_y, t446, a5_x, a6_z, t456, t459, w5_z,
        t463, t464, t465, dw5_x, dw5_y, t468, t469, t470,
        t471, t472, t473, t474,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, a6_x, t486, t489, t492, w6_z, t496,
        t497, t498, dw6_x, t500, t501, t502, t503, t504,
        t505, t506, t507,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let a6_x = c6 * a5_x - s6 * t446;
        let t486 = c6 * t446 + s6 * a5_x;
        let t489 = c6 * t470 + s6 * t474;
        let t492 = s6 * t470 - c6 * t474;
        let w6_z = dq6 - w5_y;
        let t494 = w6_x * w6_x;
        let t495 = w6_z * w6_z;
        let t496 = w6_x * w6_y;
        let t497 = w6_x * w6_z;
        let t498 = w6_y * w6_z;
        let dw6_x = t498 - t492;
        let t500 = t489 + t497;
        let t501 = t494 - t495;
        let t502 = t501 - t472;
        let t503 = dw5_y + t496;
        let t504 = t496 - dw5_y;
        let t505 = t494 + t495;
        let t506 = t497 + t500;
        let t507 = t498 + dw6_x;
        [
        w6_x, w6_y, a6_x, t486, t489, t492, w6_z, t496,
        t497, t498, dw6_x, t500, t501, t502, t503, t504,
        t505, t506, t507,
    ]
    };
    // link 7: motion
    let [
        a7_x, t519, t522, t525, t529, t530, t531, dw7_x,
        t534, t535, t536, t537, t538, t539, t540,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t513 = c7 * w6_z + s7 * w6_x;
        let a7_x = c7 * a6_x - s7 * a6_z;
        let t519 = c7 * a6_z + s7 * a6_x;
        let t522 = c7 * t503 - s7 * t507;
        let t525 = c7 * t507 + s7 * t503;
        let w7_z = w6_y + dq7;
        let t527 = w7_x * w7_x;
        let t528 = w7_z * w7_z;
        let t529 = w7_x * t513;
        let t530 = w7_x * w7_z;
        let t531 = t513 * w7_z;
        let dw7_x = t525 - t531;
        let dw7_y = t522 - t530;
        let t534 = t527 - t528;
        let t535 = t534 - t505;
        let t536 = t500 - t529;
        let t537 = t500 + t529;
        let t538 = t527 + t528;
        let t539 = t530 - dw7_y;
        let t540 = dw7_x - t531;
        [
        a7_x, t519, t522, t525, t529, t530, t531, dw7_x,
        t534, t535, t536, t537, t538, t539, t540,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t588, t591, t594, t597] = {
        let t561 = XX7R * t529 - ZZ7 * t500 + XY7 * (t535 + t538) + XZ7 * t525;
        let t563 = YZ7 * (t505 - t538);
        let t566 = XX7R * dw7_x - ZZ7 * t531 - XY7 * t539 - XZ7 * t537 + t563;
        let t567 = t530 * (XX7R - ZZ7) + XY7 * t540 - XZ7 * t534 - YZ7 * t536;
        let f7_x = MSX7 * t535 + MSY7 * t536;
        let t574 = MSX7 * t537 + MSY7 * t538;
        let f7_z = MSX7 * t539 + MSY7 * t540;
        let n7_x = t566 - MSY7 * t486;
        let n7_y = t567 + MSX7 * t486;
        let n7_z = t561 + YZ7 * t522 - (MSX7 * t519 + MSY7 * a7_x);
        let t588 = c7 * f7_x + s7 * t574;
        let t591 = s7 * f7_x - c7 * t574;
        let t594 = c7 * n7_x - s7 * n7_y;
        let t597 = s7 * n7_x + c7 * n7_y;
        [f7_z, n7_z, t588, t591, t594, t597]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t651, t654, t657, t660] = {
        let t618 = XY6 * (t502 + t505) - (XX6R * t496 + ZZ6R * dw5_y) - XZ6 * t492;
        let t620 = YZ6 * (t472 - t505);
        let t623 = ZZ6R * t498 + XX6R * dw6_x - XY6 * t506 + XZ6 * t504 + t620;
        let t624 = t497 * (XX6R - ZZ6R) + XY6 * t507 - XZ6 * t501 - YZ6 * t503;
        let f6_x = t588 + (MSX6 * t502 + MSY6R * t503);
        let f6_y = f7_z + (MSX6 * t504 - MSY6R * t505);
        let f6_z = MSX6 * t506 + MSY6R * t507 - t591;
        let n6_x = t594 + (t623 + MSY6R * a6_z);
        let n6_y = n7_z + (t624 - MSX6 * a6_z);
        let n6_z = t618 - YZ6 * t489 - (MSX6 * t486 + MSY6R * a6_x) - t597;
        let t651 = c6 * f6_x - s6 * f6_y;
        let t654 = s6 * f6_x + c6 * f6_y;
        let t657 = c6 * n6_x - s6 * n6_y;
        let t660 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t651, t654, t657, t660]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t714, t717, t726, t727] = {
        let t681 = XY5 * (t469 + t472) - (XX5R * t463 + ZZ5R * dw4_y) + XZ5 * t459;
        let t683 = YZ5 * (t433 - t472);
        let t686 = ZZ5R * t465 + XX5R * dw5_x - XY5 * t473 + XZ5 * t471 + t683;
        let t687 = t464 * (XX5R - ZZ5R) + XY5 * t474 - XZ5 * t468 - YZ5 * t470;
        let f5_x = t651 + (MSX5 * t469 + MSY5R * t470);
        let f5_y = MSX5 * t471 - MSY5R * t472 - f6_z;
        let f5_z = t654 + (MSX5 * t473 + MSY5R * t474);
        let n5_x = t657 + (t686 - MSY5R * t446);
        let n5_y = t687 + MSX5 * t446 - n6_z;
        let n5_z = t660 + (t681 + YZ5 * t456 - (MSX5 * a6_z + MSY5R * a5_x));
        let t714 = c5 * f5_x - s5 * f5_y;
        let t717 = s5 * f5_x + c5 * f5_y;
        let t726 = c5 * n5_x - s5 * n5_y - L3 * t717;
        let t727 = s5 * n5_x + c5 * n5_y + L3 * t714;
        [f5_z, n5_z, t714, t717, t726, t727]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t781, t784, t787] = {
        let t748 = XX4R * t424 + ZZ4R * dw3_y + XY4 * (t430 + t433) + XZ4 * t420;
        let t750 = YZ4 * (t400 - t433);
        let t753 = XX4R * dw4_x - ZZ4R * t426 - XY4 * t434 + XZ4 * t432 + t750;
        let t754 = t425 * (XX4R - ZZ4R) + XY4 * t435 - XZ4 * t429 + YZ4 * t431;
        let f4_x = t714 + (MSX4 * t430 - MSY4R * t431);
        let f4_y = MSX4 * t432 - MSY4R * t433 - f5_z;
        let f4_z = t717 + (MSX4 * t434 + MSY4R * t435);
        let n4_x = t726 + (t753 - MSY4R * t381);
        let n4_y = t754 + MSX4 * t381 - n5_z;
        let n4_z = t727 + (t748 + YZ4 * t417 - (MSX4 * t414 + MSY4R * a4_x));
        let t781 = c4 * f4_x - s4 * f4_y;
        let t784 = c4 * n4_x - s4 * n4_y;
        let t787 = s4 * n4_x + c4 * n4_y;
        [f4_z, n4_z, t781, t784, t787]
    };
    // link 3: force and moment
    let [n3_z, t849, t850] = {
        let t808 = XX3R * t391 - ZZ3R * t358 + XY3 * (t397 + t400) + XZ3 * t387;
        let t810 = YZ3 * (t362 - t400);
        let t813 = XX3R * dw3_x - ZZ3R * t393 - XY3 * t401 - XZ3 * t399 + t810;
        let t814 = t392 * (XX3R - ZZ3R) + XY3 * t402 - XZ3 * t396 - YZ3 * t398;
        let f3_x = t781 + (MSX3 * t397 + MSY3R * t398);
        let f3_y = f4_z - (MSX3 * t399 + MSY3R * t400);
        let n3_x = t784 + (t813 + MSY3R * a3_z);
        let n3_y = n4_z + (t814 - MSX3 * a3_z);
        let n3_z = t808 + YZ3 * t384 - (MSX3 * t381 + MSY3R * a3_x) - t787;
        let t849 = c3 * n3_x - s3 * n3_y - L2 * (s3 * f3_x + c3 * f3_y);
        let t850 = s3 * n3_x + c3 * n3_y + L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, t849, t850]
    };
    // link 2: force and moment
    let [n2_z, n1_z] = {
        let t868 = YZ2 * (t350 - t362);
        let t871 = t358 * (XX2R - ZZ2R) + XY2 * t364 - XZ2 * t360 - YZ2 * t357;
        let t875 = XY2 * (t361 + t362) - XX2R * t357 + (MSX2 * a2_y - MSY2R * a2_x);
        let n2_x = t849 + (dw2_x * (XX2R + ZZ2R) - XY2 * t363 + XZ2 * t357 + t868);
        let n2_y = n3_z + t871;
        let n2_z = t875 - t850;
        let n1_z = s2 * n2_x + c2 * n2_y;
        [n2_z, n1_z]
    };
    // drives
    let [t917, t918, t919, t920, t921, t922, t923] = {
        let t917 = tau1 - (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t918 = tau2 - (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t919 = tau3 - (n3_z + FV3 * dq3 + FC3 * dq3.sign());
        let t920 = tau4 - (n4_z + FV4 * dq4 + FC4 * dq4.sign());
        let t921 = tau5 - (n5_z + FV5 * dq5 + FC5 * dq5.sign());
        let t922 = tau6 - (n6_z + FV6 * dq6 + FC6 * dq6.sign());
        let t923 = tau7 - (n7_z + FV7 * dq7 + FC7 * dq7.sign());
        [t917, t918, t919, t920, t921, t922, t923]
    };
    // M = L D L'
    let [
        t924, t925, t926, t927, t928, t929, t930, t934,
        t938, t941, t944, t947, t950, t957, t964, t969,
        t974, t979, t989, t999, t1006, t1013, t1026, t1039,
        t1048, t1064, t1080, t1099,
    ] = {
        let t924 = k3 / t349;
        let t925 = t339 * t924;
        let t926 = t307 * t924;
        let t927 = t261 * t924;
        let t928 = t203 * t924;
        let t929 = t136 * t924;
        let t930 = t63 * t924;
        let t933 = t333 - t349 * (t925 * t925);
        let t934 = k3 / t933;
        let t935 = t349 * t925;
        let t938 = t934 * (t304 + t926 * t935);
        let t941 = t934 * (t258 + t927 * t935);
        let t944 = t934 * (t200 + t928 * t935);
        let t947 = t934 * (t133 + t929 * t935);
        let t950 = t934 * (t60 + t930 * t935);
        let t956 = t285 - t349 * (t926 * t926) - t933 * (t938 * t938);
        let t957 = k3 / t956;
        let t958 = t349 * t926;
        let t961 = t933 * t938;
        let t964 = t957 * (t246 + t927 * t958 + t941 * t961);
        let t969 = t957 * (t184 + t928 * t958 + t944 * t961);
        let t974 = t957 * (t117 + t929 * t958 + t947 * t961);
        let t979 = t957 * (t44 + t930 * t958 + t950 * t961);
        let t987 = t956 * (t964 * t964);
        let t988 = t231 - t349 * (t927 * t927) - t933 * (t941 * t941) - t987;
        let t989 = k3 / t988;
        let t990 = t349 * t927;
        let t993 = t933 * t941;
        let t996 = t956 * t964;
        let t999 = t989 * (t177 - t928 * t990 - t944 * t993 - t969 * t996);
        let t1006 = t989 * (t108 - t929 * t990 - t947 * t993 - t974 * t996);
        let t1013 = t989 * (t35 - t930 * t990 - t950 * t993 - t979 * t996);
        let t1021 = t956 * (t969 * t969);
        let t1024 = t988 * (t999 * t999);
        let t1025 = t158 - t349 * (t928 * t928) - t933 * (t944 * t944) - t1021 - t1024;
        let t1026 = k3 / t1025;
        let t1027 = t349 * t928;
        let t1030 = t933 * t944;
        let t1033 = t956 * t969;
        let t1036 = t988 * t999;
        let t1038 = t96 - t929 * t1027 - t947 * t1030 - t974 * t1033 - t1006 * t1036;
        let t1039 = t1026 * t1038;
        let t1047 = t19 - t930 * t1027 - t950 * t1030 - t979 * t1033 - t1013 * t1036;
        let t1048 = t1026 * t1047;
        let t1056 = t956 * (t974 * t974);
        let t1059 = t988 * (t1006 * t1006);
        let t1060 = t81 - t349 * (t929 * t929) - t933 * (t947 * t947) - t1056 - t1059;
        let t1063 = t1060 - t1025 * (t1039 * t1039);
        let t1064 = k3 / t1063;
        let t1072 = t979 * (t956 * t974);
        let t1075 = t1013 * (t988 * t1006);
        let t1076 = t11 + t930 * (t349 * t929) + t950 * (t933 * t947) + t1072 + t1075;
        let t1080 = t1064 * (t1076 + t1048 * (t1025 * t1039));
        let t1088 = t956 * (t979 * t979);
        let t1091 = t988 * (t1013 * t1013);
        let t1092 = ZZ7 - t349 * (t930 * t930) - t933 * (t950 * t950) - t1088 - t1091;
        let t1099 = k3 / (t1092 - t1025 * (t1048 * t1048) - t1063 * (t1080 * t1080));
        [
        t924, t925, t926, t927, t928, t929, t930, t934,
        t938, t941, t944, t947, t950, t957, t964, t969,
        t974, t979, t989, t999, t1006, t1013, t1026, t1039,
        t1048, t1064, t1080, t1099,
    ]
    };
    // ddq
    {
        let t1101 = t918 - t917 * t925;
        let t1105 = t919 - t917 * t926 + t938 * t1101;
        let t1111 = t920 - t917 * t927 + t941 * t1101 + t964 * t1105;
        let t1119 = t921 - t917 * t928 + t944 * t1101 + t969 * t1105 - t999 * t1111;
        let t1127 = t922 - t917 * t929 + t947 * t1101 + t974 * t1105 - t1006 * t1111;
        let t1129 = t1127 - t1039 * t1119;
        let t1137 = t923 - t917 * t930 + t950 * t1101 + t979 * t1105 - t1013 * t1111;
        let t1148 = t1099 * (t1137 - t1048 * t1119 + t1080 * t1129);
        let t1150 = t1064 * t1129 + t1080 * t1148;
        let t1154 = t1026 * t1119 - t1039 * t1150 - t1048 * t1148;
        let t1160 = t989 * t1111 - t999 * t1154 - t1006 * t1150 - t1013 * t1148;
        let t1167 = t979 * t1148;
        let t1168 = t957 * t1105 + t964 * t1160 + t969 * t1154 + t974 * t1150 + t1167;
        let t1175 = t947 * t1150;
        let t1176 = t934 * t1101 + t938 * t1168 + t941 * t1160 + t944 * t1154 + t1175;
        let t1178 = t1176 + t950 * t1148;
        let t1185 = t928 * t1154;
        let t1186 = t917 * t924 - t925 * t1178 - t926 * t1168 - t927 * t1160 - t1185;
        let t1190 = t1186 - t929 * t1150 - t930 * t1148;
        put(0, t1190);
        put(1, t1178);
        put(2, t1168);
        put(3, t1160);
        put(4, t1154);
        put(5, t1150);
        put(6, t1148);
    }
}
