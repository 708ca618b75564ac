//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 514 multiplications, 420 additions; 6, 6 of 6 structurally nonzero.

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
    let k0 = S::constant(9.81);
    let k1 = S::constant(0.6127);
    let k5 = S::constant(0.57155);
    let k6 = S::constant(1.0);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [a2_x, a2_y, t6, t7, t10, t11] = {
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t6 = dq2 * dq2;
        let t7 = w2_x * w2_y;
        let t8 = dq2 * w2_x;
        let t10 = w2_x * w2_x - t6 - t0;
        let t11 = t8 + t8;
        [a2_x, a2_y, t6, t7, t10, t11]
    };
    // link 3: motion
    let [
        t14, t17, w3_z, t21, a3_x, a3_y, t33, t34,
        t38, t39, t40, t41,
    ] = {
        let t14 = s2 * c3 + c2 * s3;
        let t17 = c2 * c3 - s2 * s3;
        let w3_z = dq2 + dq3;
        let t21 = k1 * t11;
        let t22 = a2_x - k1 * t10;
        let t23 = a2_y - k1 * t7;
        let a3_x = c3 * t22 + s3 * t23;
        let a3_y = c3 * t23 - s3 * t22;
        let w3_x = dq1 * t14;
        let w3_y = dq1 * t17;
        let t32 = w3_x * w3_x;
        let t33 = w3_z * w3_z;
        let t34 = w3_x * w3_y;
        let t35 = w3_z * w3_x;
        let dw3_x = w3_z * w3_y;
        let t38 = t32 - t33 - t0;
        let t39 = t32 + t33;
        let t40 = t35 + t35;
        let t41 = dw3_x + dw3_x;
        [
        t14, t17, w3_z, t21, a3_x, a3_y, t33, t34,
        t38, t39, t40, t41,
    ]
    };
    // composite body 6
    let [
        t42, t45, t48, t57, t58, t62, t65, t70,
        t90, t103, t106, t115, t118, t121, t122,
    ] = {
        let t42 = ZZ6 + IA6;
        let t45 = c6 * MSY6 + s6 * MSX6;
        let t48 = c6 * MSX6 - s6 * MSY6;
        let t57 = c6 * XZ6 - s6 * YZ6 - D6 * t48;
        let t58 = s6 * XZ6 + c6 * YZ6 - D6 * t45;
        let t59 = c5 * t45;
        let t60 = s5 * t45;
        let t62 = s5 * ZZ6;
        let t65 = c5 * ZZ6;
        let t69 = c5 * t57 - t62 + D5 * t60;
        let t70 = s5 * t57 + t65 - D5 * t59;
        let t73 = c4 * t59 + s4 * t48;
        let t76 = c4 * t48 - s4 * t59;
        let t88 = c4 * t69 - s4 * t58 - D4 * t76;
        let t89 = s4 * t69 + c4 * t58 - (D4 * t73 + t60 * k5);
        let t90 = t70 - t76 * k5;
        let t103 = t90 - (c3 * t76 - s3 * t73) * k1;
        let t105 = c2 * (s3 * t88 + c3 * t89 - t60 * k1);
        let t106 = s2 * (c3 * t88 - s3 * t89) + t105;
        let t108 = s6 * XY6;
        let t111 = c6 * XY6;
        let t112 = s6 * XX6R + t111;
        let t115 = c6 * (c6 * XX6R - t108) - s6 * t111;
        let t118 = c6 * t112 - s6 * t108;
        let t121 = s6 * t112 + c6 * t108;
        let t122 = t45 + t45;
        [
        t42, t45, t48, t57, t58, t62, t65, t70,
        t90, t103, t106, t115, t118, t121, t122,
    ]
    };
    // composite body 5
    let [
        t129, t132, t135, t144, t145, t161, t174, t177,
        t191, t195, t197, t198, t202,
    ] = {
        let t123 = MSX5 + t48;
        let t124 = XX5R + t115;
        let t125 = ZZ5R + t121;
        let t126 = XY5 + t57;
        let t127 = XZ5 - t118;
        let t128 = YZ5 - t58;
        let t129 = IA5 + t125;
        let t132 = c5 * MSY5R + s5 * t123;
        let t135 = c5 * t123 - s5 * MSY5R;
        let t144 = c5 * t127 - s5 * t128 - D5 * t135;
        let t145 = s5 * t127 + c5 * t128 - D5 * t132;
        let t146 = c4 * t132;
        let t147 = s4 * t132;
        let t159 = c4 * t144 + s4 * t125 + D4 * t147;
        let t160 = s4 * t144 - c4 * t125 + (k5 * t135 - D4 * t146);
        let t161 = t145 + k5 * t147;
        let t174 = t161 + k1 * (s3 * t146 + c3 * t147);
        let t176 = c2 * (s3 * t159 + c3 * t160 + k1 * t135);
        let t177 = s2 * (c3 * t159 - s3 * t160) + t176;
        let t179 = s5 * t126;
        let t182 = c5 * t126;
        let t183 = s5 * t124 + t182;
        let t185 = t65 + t179;
        let t191 = c5 * t183 - s5 * t185;
        let t195 = t132 + t132;
        let t196 = D5 * t122;
        let t197 = c5 * (c5 * t124 - t179) - s5 * (t182 - t62) - t196;
        let t198 = s5 * t183 + c5 * t185 - t196;
        let t200 = D5 * t45;
        let t202 = t125 - t196 + (t200 + t200);
        [
        t129, t132, t135, t144, t145, t161, t174, t177,
        t191, t195, t197, t198, t202,
    ]
    };
    // composite body 4
    let [
        t210, t213, t216, t227, t228, t239, t242, t268,
        t270, t273, t274, t278,
    ] = {
        let t203 = MSX4 + t135;
        let t204 = MSY4R + t45;
        let t205 = XX4R + t197;
        let t206 = ZZ4R + t198;
        let t207 = XY4 - t144;
        let t208 = XZ4 + t191;
        let t209 = YZ4 - t145;
        let t210 = IA4 + t206;
        let t213 = c4 * t204 + s4 * t203;
        let t216 = c4 * t203 - s4 * t204;
        let t219 = c4 * t208 - s4 * t209;
        let t223 = D4 * t216;
        let t225 = k5 * t216;
        let t226 = t219 - t223;
        let t227 = s4 * t208 + c4 * t209 - D4 * t213;
        let t228 = t206 - t225;
        let t239 = t228 - k1 * (c3 * t216 - s3 * t213);
        let t241 = c2 * (s3 * t226 + c3 * t227);
        let t242 = s2 * (c3 * t226 - s3 * t227) + t241;
        let t244 = s4 * t207;
        let t247 = c4 * t207;
        let t248 = s4 * t205 + t247;
        let t252 = t244 + c4 * t202;
        let t265 = D4 * t195 - k5 * (t216 + t216);
        let t266 = c4 * (c4 * t205 - t244) - s4 * (t247 - s4 * t202) + t265;
        let t268 = t266 + (t225 + t225);
        let t270 = c4 * t248 - s4 * t252 + k5 * t213;
        let t273 = t219 - (t223 - k5 * t132);
        let t274 = s4 * t248 + c4 * t252 + t265;
        let t276 = D4 * t132;
        let t278 = t206 + t265 - (t276 + t276);
        [
        t210, t213, t216, t227, t228, t239, t242, t268,
        t270, t273, t274, t278,
    ]
    };
    // composite body 3
    let [
        t286, t298, t300, t303, t327, t329, t331, t332,
        t333,
    ] = {
        let t279 = MSX3R + t216;
        let t280 = MSY3 + t213;
        let t281 = XX3R + t268;
        let t282 = ZZ3R + t278;
        let t283 = XY3 + t270;
        let t284 = XZ3R + t273;
        let t285 = YZ3 + t227;
        let t286 = IA3 + t282;
        let t292 = c3 * t279 - s3 * t280;
        let t295 = c3 * t284 - s3 * t285;
        let t298 = s3 * t284 + c3 * t285;
        let t299 = k1 * t292;
        let t300 = t282 - t299;
        let t303 = s2 * t295 + c2 * t298;
        let t305 = s3 * t283;
        let t308 = c3 * t283;
        let t309 = s3 * t281 + t308;
        let t313 = t305 + c3 * t274;
        let t324 = k1 * (t292 + t292);
        let t325 = c3 * (c3 * t281 - t305) - s3 * (t308 - s3 * t274) - t324;
        let t327 = t325 + (t299 + t299);
        let t329 = c3 * t309 - s3 * t313 + k1 * (c3 * t280 + s3 * t279);
        let t331 = t295 + k1 * t132;
        let t332 = s3 * t309 + c3 * t313 - t324;
        let t333 = t282 - t324;
        [
        t286, t298, t300, t303, t327, t329, t331, t332,
        t333,
    ]
    };
    // composite body 2
    let [t335, t341, t350] = {
        let t335 = ZZ2R + t333;
        let t336 = XY2 + t329;
        let t341 = s2 * (XZ2R + t331) + c2 * (YZ2 + t298);
        let t349 = c2 * (s2 * t336 + c2 * t332);
        let t350 = s2 * (s2 * (XX2R + t327) + c2 * t336) + t349;
        [t335, t341, t350]
    };
    // composite body 1
    let t351 = {
        let t351 = ZZ1R + t350;
        t351
    };
    // M = L D L'
    let [
        t352, t353, t354, t355, t356, t357, t361, t365,
        t368, t371, t374, t381, t388, t393, t398, t408,
        t418, t425, t438, t451, t467,
    ] = {
        let t352 = k6 / t351;
        let t353 = t341 * t352;
        let t354 = t303 * t352;
        let t355 = t242 * t352;
        let t356 = t177 * t352;
        let t357 = t106 * t352;
        let t360 = t335 - t351 * (t353 * t353);
        let t361 = k6 / t360;
        let t362 = t351 * t353;
        let t365 = t361 * (t300 - t354 * t362);
        let t368 = t361 * (t239 - t355 * t362);
        let t371 = t361 * (t174 - t356 * t362);
        let t374 = t361 * (t103 - t357 * t362);
        let t380 = t286 - t351 * (t354 * t354) - t360 * (t365 * t365);
        let t381 = k6 / t380;
        let t382 = t351 * t354;
        let t385 = t360 * t365;
        let t388 = t381 * (t228 - t355 * t382 - t368 * t385);
        let t393 = t381 * (t161 - t356 * t382 - t371 * t385);
        let t398 = t381 * (t90 - t357 * t382 - t374 * t385);
        let t406 = t380 * (t388 * t388);
        let t407 = t210 - t351 * (t355 * t355) - t360 * (t368 * t368) - t406;
        let t408 = k6 / t407;
        let t409 = t351 * t355;
        let t412 = t360 * t368;
        let t415 = t380 * t388;
        let t418 = t408 * (t145 - t356 * t409 - t371 * t412 - t393 * t415);
        let t425 = t408 * (t70 - t357 * t409 - t374 * t412 - t398 * t415);
        let t433 = t380 * (t393 * t393);
        let t436 = t407 * (t418 * t418);
        let t437 = t129 - t351 * (t356 * t356) - t360 * (t371 * t371) - t433 - t436;
        let t438 = k6 / t437;
        let t446 = t398 * (t380 * t393);
        let t449 = t425 * (t407 * t418);
        let t450 = t58 + t357 * (t351 * t356) + t374 * (t360 * t371) + t446 + t449;
        let t451 = t438 * t450;
        let t459 = t380 * (t398 * t398);
        let t462 = t407 * (t425 * t425);
        let t463 = t42 - t351 * (t357 * t357) - t360 * (t374 * t374) - t459 - t462;
        let t467 = k6 / (t463 - t437 * (t451 * t451));
        [
        t352, t353, t354, t355, t356, t357, t361, t365,
        t368, t371, t374, t381, t388, t393, t398, t408,
        t418, t425, t438, t451, t467,
    ]
    };
    // link 4: motion
    let [
        t470, t473, w4_z, a4_x, a4_y, t488, w4_x, w4_y,
        t492, t493, dw5_z, t497, t498, t499, t500,
    ] = {
        let t470 = c4 * t14 + s4 * t17;
        let t473 = c4 * t17 - s4 * t14;
        let w4_z = w3_z + dq4;
        let t478 = a3_x - k5 * t38;
        let t479 = a3_y - k5 * t34;
        let a4_x = c4 * t478 + s4 * t479;
        let a4_y = c4 * t479 - s4 * t478;
        let t488 = t21 + (k5 * t40 + D4 * t0);
        let w4_x = dq1 * t470;
        let w4_y = dq1 * t473;
        let t491 = w4_x * w4_x;
        let t492 = w4_z * w4_z;
        let t493 = w4_x * w4_y;
        let dw5_z = w4_z * w4_x;
        let dw4_x = w4_z * w4_y;
        let t497 = t491 - t492 - t0;
        let t498 = t491 + t492;
        let t499 = dw5_z + dw5_z;
        let t500 = dw4_x + dw4_x;
        [
        t470, t473, w4_z, a4_x, a4_y, t488, w4_x, w4_y,
        t492, t493, dw5_z, t497, t498, t499, t500,
    ]
    };
    // link 5: motion
    let [
        t505, a5_x, t512, w5_x, w5_y, t521, t524, w5_z,
        t528, t529, t530, dw5_x, t532, t533, t534, t535,
        t536, t537, t538, t539,
    ] = {
        let t504 = a4_x - D5 * t493;
        let t505 = a4_y + D5 * t498;
        let t506 = t488 + D5 * t500;
        let a5_x = c5 * t504 - s5 * t506;
        let t512 = c5 * t506 + s5 * t504;
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t521 = c5 * t493 + s5 * t500;
        let t524 = s5 * t493 - c5 * t500;
        let w5_z = dq5 - w4_y;
        let t526 = w5_x * w5_x;
        let t527 = w5_z * w5_z;
        let t528 = w5_x * w5_y;
        let t529 = w5_x * w5_z;
        let t530 = w5_y * w5_z;
        let dw5_x = t530 - t524;
        let t532 = t521 + t529;
        let t533 = t526 - t527;
        let t534 = t533 - t498;
        let t535 = t528 - dw5_z;
        let t536 = dw5_z + t528;
        let t537 = t526 + t527;
        let t538 = t529 + t532;
        let t539 = t530 + dw5_x;
        [
        t505, a5_x, t512, w5_x, w5_y, t521, t524, w5_z,
        t528, t529, t530, dw5_x, t532, t533, t534, t535,
        t536, t537, t538, t539,
    ]
    };
    // link 6: motion
    let [
        t542, t545, t554, t557, t561, t562, t563, dw6_x,
        t566, t567, t568, t569, t570, t571, t572,
    ] = {
        let t542 = c6 * a5_x + s6 * t505;
        let t545 = c6 * t505 - s6 * a5_x;
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t551 = c6 * w5_z + s6 * w5_x;
        let t554 = c6 * t535 - s6 * t539;
        let t557 = c6 * t539 + s6 * t535;
        let w6_z = w5_y + dq6;
        let t559 = w6_x * w6_x;
        let t560 = w6_z * w6_z;
        let t561 = w6_x * t551;
        let t562 = w6_x * w6_z;
        let t563 = t551 * w6_z;
        let dw6_x = t557 - t563;
        let dw6_y = t554 - t562;
        let t566 = t559 - t560;
        let t567 = t566 - t537;
        let t568 = t532 - t561;
        let t569 = t532 + t561;
        let t570 = t559 + t560;
        let t571 = t562 - dw6_y;
        let t572 = dw6_x - t563;
        [
        t542, t545, t554, t557, t561, t562, t563, dw6_x,
        t566, t567, t568, t569, t570, t571, t572,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t624, t627, t630, t633] = {
        let t574 = XZ6 - D6 * MSX6;
        let t576 = YZ6 - D6 * MSY6;
        let t597 = XX6R * t561 - ZZ6 * t532 + XY6 * (t567 + t570) + t557 * t574;
        let t599 = t576 * (t537 - t570);
        let t602 = XX6R * dw6_x - ZZ6 * t563 - XY6 * t571 - t569 * t574 + t599;
        let t603 = t562 * (XX6R - ZZ6) + XY6 * t572 - t566 * t574 - t568 * t576;
        let f6_x = MSX6 * t567 + MSY6 * t568;
        let t610 = MSX6 * t569 + MSY6 * t570;
        let f6_z = MSX6 * t571 + MSY6 * t572;
        let n6_x = t602 - MSY6 * t512;
        let n6_y = t603 + MSX6 * t512;
        let n6_z = t597 + t554 * t576 + (MSX6 * t545 - MSY6 * t542);
        let t624 = c6 * f6_x + s6 * t610;
        let t627 = s6 * f6_x - c6 * t610;
        let t630 = c6 * n6_x - s6 * n6_y;
        let t633 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t624, t627, t630, t633]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t687, t690, t699, t700] = {
        let t654 = ZZ5R * dw5_z - XX5R * t528 + XY5 * (t534 + t537) - XZ5 * t524;
        let t656 = YZ5 * (t498 - t537);
        let t659 = ZZ5R * t530 + XX5R * dw5_x - XY5 * t538 + XZ5 * t536 + t656;
        let t660 = t529 * (XX5R - ZZ5R) + XY5 * t539 - XZ5 * t533 - YZ5 * t535;
        let f5_x = t624 + (MSX5 * t534 + MSY5R * t535);
        let f5_y = f6_z + (MSX5 * t536 - MSY5R * t537);
        let f5_z = MSX5 * t538 + MSY5R * t539 - t627;
        let n5_x = t630 + (t659 - MSY5R * t505);
        let n5_y = n6_z + (t660 + MSX5 * t505);
        let n5_z = t654 - YZ5 * t521 - (MSX5 * t512 + MSY5R * a5_x) - t633;
        let t687 = c5 * f5_x - s5 * f5_y;
        let t690 = s5 * f5_x + c5 * f5_y;
        let t699 = c5 * n5_x - s5 * n5_y - D5 * t690;
        let t700 = s5 * n5_x + c5 * n5_y + D5 * t687;
        [f5_z, n5_z, t687, t690, t699, t700]
    };
    // link 4: force and moment
    let [t714, f4_z, n4_z, t739, t742, t754, t755, t756] = {
        let t706 = t473 * (XX4R * t470 + t473 * (XY4 + XY4)) - XY4;
        let t714 = (t706 + t706) * (dq1 * w4_z) + t492 * (XZ4 * t473 - YZ4 * t470);
        let f4_x = t687 + (MSX4 * t497 + MSY4R * t493);
        let f4_y = MSX4 * t493 - MSY4R * t498 - f5_z;
        let f4_z = t690 + (MSX4 * t499 + MSY4R * t500);
        let n4_x = t699 - MSY4R * t488;
        let n4_y = MSX4 * t488 - n5_z;
        let n4_z = t700 + (MSX4 * a4_y - MSY4R * a4_x) - t0 * t706;
        let t739 = c4 * f4_x - s4 * f4_y;
        let t742 = s4 * f4_x + c4 * f4_y;
        let t754 = c4 * n4_x - s4 * n4_y - D4 * t742;
        let t755 = s4 * n4_x + c4 * n4_y + (D4 * t739 + k5 * f4_z);
        let t756 = n4_z - k5 * t742;
        [t714, f4_z, n4_z, t739, t742, t754, t755, t756]
    };
    // link 3: force and moment
    let [t772, n3_z, n2_x, n2_y, t806] = {
        let t762 = t17 * (XX3R * t14 + t17 * (XY3 + XY3)) - XY3;
        let t770 = (t762 + t762) * (dq1 * w3_z) + t33 * (XZ3R * t17 - YZ3 * t14);
        let t772 = t714 + t770;
        let f3_x = t739 + (MSX3R * t38 + MSY3 * t34);
        let f3_y = t742 + (MSX3R * t34 - MSY3 * t39);
        let f3_z = f4_z + (MSX3R * t40 + MSY3 * t41);
        let n3_x = t754 - MSY3 * t21;
        let n3_y = t755 + MSX3R * t21;
        let n3_z = t756 + (MSX3R * a3_y - MSY3 * a3_x) - t0 * t762;
        let n2_x = c3 * n3_x - s3 * n3_y;
        let n2_y = s3 * n3_x + c3 * n3_y + k1 * f3_z;
        let t806 = n3_z - k1 * (s3 * f3_x + c3 * f3_y);
        [t772, n3_z, n2_x, n2_y, t806]
    };
    // link 2: force and moment
    let [t822, n2_z, t830] = {
        let t812 = c2 * (s2 * XX2R + c2 * (XY2 + XY2)) - XY2;
        let t820 = (t812 + t812) * (dq1 * dq2) + t6 * (c2 * XZ2R - s2 * YZ2);
        let t822 = t772 + t820;
        let n2_z = t806 + (MSX2R * a2_y - MSY2 * a2_x) - t0 * t812;
        let t830 = s2 * n2_x + c2 * n2_y;
        [t822, n2_z, t830]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t822 + t830;
        n1_z
    };
    // drives
    let [t868, t869, t870, t871, t872, t873] = {
        let t868 = tau1 - (FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign()));
        let t869 = tau2 - (FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign()));
        let t870 = tau3 - (FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign()));
        let t871 = tau4 - (FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign()));
        let t872 = tau5 - (FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign()));
        let t873 = tau6 - (FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign()));
        [t868, t869, t870, t871, t872, t873]
    };
    // ddq
    {
        let t875 = t869 - t868 * t353;
        let t879 = t870 - t868 * t354 - t365 * t875;
        let t885 = t871 - t868 * t355 - t368 * t875 - t388 * t879;
        let t893 = t872 - t868 * t356 - t371 * t875 - t393 * t879 - t418 * t885;
        let t901 = t873 - t868 * t357 - t374 * t875 - t398 * t879 - t425 * t885;
        let t909 = t467 * (t901 + t451 * t893);
        let t911 = t438 * t893 + t451 * t909;
        let t915 = t408 * t885 - t418 * t911 - t425 * t909;
        let t921 = t381 * t879 - t388 * t915 - t393 * t911 - t398 * t909;
        let t928 = t374 * t909;
        let t929 = t361 * t875 - t365 * t921 - t368 * t915 - t371 * t911 - t928;
        let t936 = t356 * t911;
        let t937 = t868 * t352 - t353 * t929 - t354 * t921 - t355 * t915 - t936;
        let t939 = t937 - t357 * t909;
        put(0, t939);
        put(1, t929);
        put(2, t921);
        put(3, t915);
        put(4, t911);
        put(5, t909);
    }
}
