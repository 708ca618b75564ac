//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 447 multiplications, 362 additions; 6, 6 of 6 structurally nonzero.

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
    let k2 = S::constant(1.0);
    let k3 = S::constant(9.81);
    let k4 = S::constant(2.0);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // composite body 6
    let [
        t1, t4, t7, t16, t17, t19, t25, t41,
        t49, t58, t61, t64,
    ] = {
        let t1 = ZZ6 + IA6;
        let t4 = c6 * MSY6 + s6 * MSX6;
        let t7 = c6 * MSX6 - s6 * MSY6;
        let t16 = c6 * XZ6 - s6 * YZ6 - D6 * t7;
        let t17 = s6 * XZ6 + c6 * YZ6 - D6 * t4;
        let t18 = c5 * t4;
        let t19 = s5 * t4;
        let t22 = c5 * t16 + s5 * ZZ6;
        let t25 = s5 * t16 - c5 * ZZ6;
        let t31 = c4 * t7 - s4 * t18;
        let t40 = s4 * t22 + c4 * t17 - q3 * (c4 * t18 + s4 * t7);
        let t41 = q3 * t31 - (c4 * t22 - s4 * t17);
        let t49 = s2 * t40 + c2 * t25 + D2 * (c2 * t31 + s2 * t19);
        let t51 = s6 * XY6;
        let t54 = c6 * XY6;
        let t55 = s6 * XX6R + t54;
        let t58 = c6 * (c6 * XX6R - t51) - s6 * t54;
        let t61 = c6 * t55 - s6 * t51;
        let t64 = s6 * t55 + c6 * t51;
        [
        t1, t4, t7, t16, t17, t19, t25, t41,
        t49, t58, t61, t64,
    ]
    };
    // composite body 5
    let [
        t67, t71, t74, t77, t80, t83, t95, t103,
        t116, t119, t122,
    ] = {
        let t65 = MSX5 + t7;
        let t66 = ZZ5R + ZZ6;
        let t67 = YY5R + t64;
        let t68 = XZ5 + t16;
        let t69 = XY5 + t61;
        let t70 = YZ5 + t17;
        let t71 = IA5 + t67;
        let t74 = c5 * MSZ5R - s5 * t65;
        let t77 = s5 * MSZ5R + c5 * t65;
        let t80 = c5 * t69 + s5 * t70;
        let t83 = s5 * t69 - c5 * t70;
        let t85 = s4 * t74;
        let t95 = q3 * t85 - (c4 * t80 - s4 * t67);
        let t100 = c2 * t83;
        let t101 = s2 * (s4 * t80 + c4 * t67 + q3 * (c4 * t74)) + t100;
        let t103 = t101 + D2 * (c2 * t85 - s2 * t77);
        let t105 = s5 * t68;
        let t108 = c5 * t68;
        let t109 = s5 * t58 - t108;
        let t113 = c5 * t66 - t105;
        let t116 = c5 * (c5 * t58 + t105) + s5 * (t108 + s5 * t66);
        let t119 = c5 * t109 - s5 * t113;
        let t122 = s5 * t109 + c5 * t113;
        [
        t67, t71, t74, t77, t80, t83, t95, t103,
        t116, t119, t122,
    ]
    };
    // composite body 4
    let [
        t126, t130, t133, t136, t139, t142, t146, t152,
        t165, t168, t171,
    ] = {
        let t123 = MSX4 + t77;
        let t124 = MSZ4R + t4;
        let t125 = ZZ4R + t67;
        let t126 = YY4R + t122;
        let t127 = XZ4 + t80;
        let t128 = XY4 + t119;
        let t129 = YZ4 + t83;
        let t130 = IA4 + t126;
        let t133 = c4 * t124 + s4 * t123;
        let t136 = c4 * t123 - s4 * t124;
        let t139 = s4 * t129 - c4 * t128;
        let t142 = s4 * t128 + c4 * t129;
        let t146 = q3 * t136 - t139;
        let t152 = D2 * (c2 * t136) - (s2 * (t142 + q3 * t133) + c2 * t126);
        let t154 = s4 * t127;
        let t157 = c4 * t127;
        let t158 = s4 * t116 + t157;
        let t162 = t154 + c4 * t125;
        let t165 = c4 * (c4 * t116 - t154) - s4 * (t157 - s4 * t125);
        let t168 = c4 * t158 - s4 * t162;
        let t171 = s4 * t158 + c4 * t162;
        [
        t126, t130, t133, t136, t139, t142, t146, t152,
        t165, t168, t171,
    ]
    };
    // composite body 3
    let [
        t172, t173, t175, t179, t181, t184, t186, t187,
        t189,
    ] = {
        let t172 = MSX3 + t136;
        let t173 = MSY3 + t133;
        let t174 = MSZ3R + t74;
        let t175 = M3R + IA3;
        let t179 = D2 * (s2 * M3R) - s2 * t172;
        let t181 = t174 + q3 * M3R;
        let t183 = q3 * (t174 + t181);
        let t184 = t171 + t183;
        let t186 = t142 + q3 * t173;
        let t187 = t165 + t183;
        let t189 = q3 * t172 - t139;
        [
        t172, t173, t175, t179, t181, t184, t186, t187,
        t189,
    ]
    };
    // composite body 2
    let [t193, t204, t218] = {
        let t193 = YY2R + t187;
        let t194 = t186 - XZ2R;
        let t203 = D2 * (c2 * (MSZ2 + t181) - s2 * (MSX2 + t173));
        let t204 = s2 * (XY2R - t168) - c2 * (YZ2R + t189) + t203;
        let t212 = c2 * (s2 * t194 + c2 * (ZZ2R + t126));
        let t217 = D2 * (D2 * M3R - t172 - t172);
        let t218 = s2 * (s2 * t184 + c2 * t194) + t212 + t217;
        [t193, t204, t218]
    };
    // composite body 1
    let t219 = {
        let t219 = YY1R + t218;
        t219
    };
    // M = L D L'
    let [
        t220, t221, t222, t223, t224, t225, t229, t233,
        t236, t239, t242, t249, t255, t260, t265, t275,
        t285, t292, t305, t318, t334,
    ] = {
        let t220 = k2 / t219;
        let t221 = t204 * t220;
        let t222 = t179 * t220;
        let t223 = t152 * t220;
        let t224 = t103 * t220;
        let t225 = t49 * t220;
        let t228 = t193 - t219 * (t221 * t221);
        let t229 = k2 / t228;
        let t230 = t219 * t221;
        let t233 = t229 * (t173 + t222 * t230);
        let t236 = t229 * (t146 - t223 * t230);
        let t239 = t229 * (t95 - t224 * t230);
        let t242 = t229 * (t41 - t225 * t230);
        let t248 = t175 - t219 * (t222 * t222) - t228 * (t233 * t233);
        let t249 = k2 / t248;
        let t250 = t219 * t222;
        let t252 = t228 * t233;
        let t255 = t249 * (t236 * t252 - t223 * t250);
        let t260 = t249 * (t239 * t252 - (t77 + t224 * t250));
        let t265 = t249 * (t19 - t225 * t250 + t242 * t252);
        let t273 = t248 * (t255 * t255);
        let t274 = t130 - t219 * (t223 * t223) - t228 * (t236 * t236) - t273;
        let t275 = k2 / t274;
        let t276 = t219 * t223;
        let t279 = t228 * t236;
        let t282 = t248 * t255;
        let t285 = t275 * (t83 + t224 * t276 + t239 * t279 + t260 * t282);
        let t292 = t275 * (t25 + t225 * t276 + t242 * t279 + t265 * t282);
        let t300 = t248 * (t260 * t260);
        let t303 = t274 * (t285 * t285);
        let t304 = t71 - t219 * (t224 * t224) - t228 * (t239 * t239) - t300 - t303;
        let t305 = k2 / t304;
        let t313 = t265 * (t248 * t260);
        let t316 = t292 * (t274 * t285);
        let t317 = t17 - t225 * (t219 * t224) - t242 * (t228 * t239) - t313 - t316;
        let t318 = t305 * t317;
        let t326 = t248 * (t265 * t265);
        let t329 = t274 * (t292 * t292);
        let t330 = t1 - t219 * (t225 * t225) - t228 * (t242 * t242) - t326 - t329;
        let t334 = k2 / (t330 - t304 * (t318 * t318));
        [
        t220, t221, t222, t223, t224, t225, t229, t233,
        t236, t239, t242, t249, t255, t260, t265, t275,
        t285, t292, t305, t318, t334,
    ]
    };
    // link 2: motion
    let [
        t335, t336, t337, t338, w3_z, t340, t341, t342,
        dw2_y, t344, t345, t346, t347,
    ] = {
        let t335 = s2 * k3;
        let t336 = c2 * k3;
        let t337 = D2 * t0;
        let t338 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t340 = t338 * t338;
        let t341 = dq2 * dq2;
        let t342 = t338 * w3_z;
        let dw2_y = dq2 * t338;
        let t344 = dq2 * w3_z;
        let t345 = t340 + t341;
        let t346 = dw2_y + dw2_y;
        let t347 = t344 + t344;
        [
        t335, t336, t337, t338, w3_z, t340, t341, t342,
        dw2_y, t344, t345, t346, t347,
    ]
    };
    // link 3: motion
    let [t352, t357, a3_y, t360, t361] = {
        let t352 = q3 * t345 - t336;
        let t354 = dq3 * k4;
        let t357 = q3 * t347 - t337 + t338 * t354;
        let a3_y = dq2 * t354 - (t335 + q3 * t342);
        let t359 = w3_z * w3_z;
        let t360 = t340 + t359;
        let t361 = t341 + t359;
        [t352, t357, a3_y, t360, t361]
    };
    // link 4: motion
    let [
        a4_x, a4_y, t370, w4_y, t376, t379, w4_z, t381,
        t382, t383, t384, t385, dw4_y, t388, t389, t390,
        t391, t392,
    ] = {
        let a4_x = s4 * a3_y - c4 * t357;
        let a4_y = c4 * a3_y + s4 * t357;
        let t370 = c4 * dq2 + s4 * t338;
        let w4_y = s4 * dq2 - c4 * t338;
        let t376 = c4 * t347 + s4 * t342;
        let t379 = s4 * t347 - c4 * t342;
        let w4_z = w3_z + dq4;
        let t381 = t370 * t370;
        let t382 = w4_z * w4_z;
        let t383 = t370 * w4_y;
        let t384 = t370 * w4_z;
        let t385 = w4_y * w4_z;
        let dw4_x = t385 - t379;
        let dw4_y = t384 - t376;
        let t388 = dw2_y - t383;
        let t389 = dw2_y + t383;
        let t390 = t381 + t382;
        let t391 = t384 + dw4_y;
        let t392 = t385 + dw4_x;
        [
        a4_x, a4_y, t370, w4_y, t376, t379, w4_z, t381,
        t382, t383, t384, t385, dw4_y, t388, t389, t390,
        t391, t392,
    ]
    };
    // link 5: motion
    let [
        a5_x, a5_y, t401, w5_y, t407, t410, w5_z, t412,
        t413, t414, t415, t416, dw5_y, t419, t420, t421,
        t422, t423,
    ] = {
        let a5_x = c5 * a4_x + s5 * t352;
        let a5_y = c5 * t352 - s5 * a4_x;
        let t401 = c5 * t370 + s5 * w4_z;
        let w5_y = s5 * t370 - c5 * w4_z;
        let t407 = c5 * t388 - s5 * t392;
        let t410 = c5 * t392 + s5 * t388;
        let w5_z = w4_y + dq5;
        let t412 = t401 * t401;
        let t413 = w5_z * w5_z;
        let t414 = t401 * w5_y;
        let t415 = t401 * w5_z;
        let t416 = w5_y * w5_z;
        let dw5_x = t410 + t416;
        let dw5_y = t407 + t415;
        let t419 = dw4_y + t414;
        let t420 = dw4_y - t414;
        let t421 = t412 + t413;
        let t422 = t415 + dw5_y;
        let t423 = t416 + dw5_x;
        [
        a5_x, a5_y, t401, w5_y, t407, t410, w5_z, t412,
        t413, t414, t415, t416, dw5_y, t419, t420, t421,
        t422, t423,
    ]
    };
    // link 6: motion
    let [
        t426, t429, t438, t441, t445, t446, t447, dw6_x,
        t450, t451, t452, t453, t454, t455, t456,
    ] = {
        let t426 = c6 * a5_x + s6 * a4_y;
        let t429 = c6 * a4_y - s6 * a5_x;
        let w6_x = s6 * w5_z - c6 * t401;
        let w6_y = c6 * w5_z + s6 * t401;
        let t438 = c6 * t419 - s6 * t423;
        let t441 = c6 * t423 + s6 * t419;
        let w6_z = dq6 - w5_y;
        let t443 = w6_x * w6_x;
        let t444 = w6_z * w6_z;
        let t445 = w6_x * w6_y;
        let t446 = w6_x * w6_z;
        let t447 = w6_y * w6_z;
        let dw6_x = t441 + t447;
        let dw6_y = t438 - t446;
        let t450 = t443 - t444;
        let t451 = t450 - t421;
        let t452 = dw5_y + t445;
        let t453 = t445 - dw5_y;
        let t454 = t443 + t444;
        let t455 = t446 - dw6_y;
        let t456 = t447 + dw6_x;
        [
        t426, t429, t438, t441, t445, t446, t447, dw6_x,
        t450, t451, t452, t453, t454, t455, t456,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t508, t511, t514, t517] = {
        let t458 = XZ6 - D6 * MSX6;
        let t460 = YZ6 - D6 * MSY6;
        let t481 = XY6 * (t451 + t454) - (XX6R * t445 + ZZ6 * dw5_y) + t441 * t458;
        let t483 = t460 * (t421 - t454);
        let t486 = ZZ6 * t447 + XX6R * dw6_x - XY6 * t455 + t453 * t458 + t483;
        let t487 = t446 * (XX6R - ZZ6) + XY6 * t456 - t450 * t458 - t452 * t460;
        let f6_x = MSX6 * t451 + MSY6 * t452;
        let f6_y = MSX6 * t453 - MSY6 * t454;
        let f6_z = MSX6 * t455 + MSY6 * t456;
        let n6_x = t486 - MSY6 * a5_y;
        let n6_y = t487 + MSX6 * a5_y;
        let n6_z = t481 + t438 * t460 + (MSX6 * t429 - MSY6 * t426);
        let t508 = c6 * f6_x - s6 * f6_y;
        let t511 = s6 * f6_x + c6 * f6_y;
        let t514 = c6 * n6_x - s6 * n6_y;
        let t517 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t508, t511, t514, t517]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t575, t578, t581, t584] = {
        let t518 = w5_y * w5_y;
        let t519 = t413 + t518;
        let t520 = t412 + t518;
        let t541 = YY5R * dw4_y - ZZ5R * t414 + XY5 * t410 + XZ5 * (t519 - t421);
        let t542 = XY5 * (t520 - t519) - (YY5R * t415 + ZZ5R * dw5_y) + XZ5 * t423;
        let t544 = YZ5 * (t421 - t520);
        let t559 = MSZ5R * a4_y;
        let t564 = XY5 * t420 - t416 * (ZZ5R - YY5R) - XZ5 * t422 + t544 - t559;
        let f5_x = t508 + (MSZ5R * t419 - MSX5 * t519);
        let f5_y = MSX5 * t420 + MSZ5R * t421 - f6_z;
        let f5_z = t511 - (MSX5 * t422 + MSZ5R * t423);
        let n5_x = t514 + t564;
        let t571 = n6_z + (t542 + YZ5 * t419 + MSX5 * a4_y);
        let n5_z = t517 + (t541 - YZ5 * t407 + (MSZ5R * a5_x + MSX5 * a5_y));
        let t575 = c5 * f5_x - s5 * f5_y;
        let t578 = s5 * f5_x + c5 * f5_y;
        let t581 = c5 * n5_x + s5 * t571;
        let t584 = s5 * n5_x - c5 * t571;
        [f5_z, n5_z, t575, t578, t581, t584]
    };
    // link 4: force and moment
    let [t636, t639, t642, t645, t648, t651] = {
        let t585 = w4_y * w4_y;
        let t586 = t382 + t585;
        let t587 = t381 + t585;
        let t608 = ZZ4R * t383 + YY4R * dw2_y - XY4 * t379 + XZ4 * (t586 - t390);
        let t609 = YY4R * t384 + ZZ4R * dw4_y + XY4 * (t587 - t586) + XZ4 * t392;
        let t611 = YZ4 * (t390 - t587);
        let t626 = MSZ4R * t352;
        let t631 = XY4 * t389 - t385 * (ZZ4R - YY4R) + XZ4 * t391 + t611 - t626;
        let f4_x = t575 + (MSZ4R * t388 - MSX4 * t586);
        let f4_y = f5_z - (MSX4 * t389 + MSZ4R * t390);
        let t636 = t578 + (MSX4 * t391 - MSZ4R * t392);
        let n4_x = t581 + t631;
        let n4_y = n5_z + (t609 + YZ4 * t388 + MSX4 * t352);
        let t639 = t584 + (t608 - YZ4 * t376 + (MSZ4R * a4_x - MSX4 * a4_y));
        let t642 = c4 * f4_x - s4 * f4_y;
        let t645 = s4 * f4_x + c4 * f4_y;
        let t648 = c4 * n4_x - s4 * n4_y;
        let t651 = s4 * n4_x + c4 * n4_y;
        [t636, t639, t642, t645, t648, t651]
    };
    // link 3: force and moment
    let [t652, t653, t654, f3_y, t683, n3_z, t689, t690] = {
        let t652 = t361 - t360;
        let t653 = t360 - t345;
        let t654 = t345 - t361;
        let f3_x = t642 + (MSY3 * t346 - MSX3 * t360 - MSZ3R * t347 - M3R * t357);
        let f3_y = t645 + (M3R * a3_y - (MSY3 * t361 + MSZ3R * t342));
        let t683 = t636 + (M3R * t352 + (MSY3 * t342 + MSZ3R * t345));
        let n3_x = t648 - (MSY3 * t352 + MSZ3R * a3_y);
        let n3_y = t651 + (MSX3 * t352 - MSZ3R * t357);
        let n3_z = MSX3 * a3_y + MSY3 * t357 - t639;
        let t689 = n3_y + q3 * f3_x;
        let t690 = q3 * f3_y - n3_x;
        [t652, t653, t654, f3_y, t683, n3_z, t689, t690]
    };
    // link 2: force and moment
    let [n2_z, t736] = {
        let t708 = t344 * (ZZ2R - YY2R) + XY2R * t342 - XZ2R * t346 - YZ2R * t653;
        let t709 = dw2_y * (YY2R + ZZ2R) + XY2R * t652 + XZ2R * t347 + YZ2R * t342;
        let f2_x = f3_y - (MSX2 * t361 + MSZ2 * t342);
        let f2_y = t683 + (MSX2 * t342 + MSZ2 * t345);
        let n2_x = t689 + (t708 + MSZ2 * t337);
        let n2_y = t709 + MSX2 * t337 - n3_z;
        let n2_z = t690 + (ZZ2R * t342 - XZ2R * t654 - (MSZ2 * t335 + MSX2 * t336));
        let f1_x = c2 * f2_x - s2 * f2_y;
        let t736 = s2 * n2_x + c2 * n2_y + D2 * f1_x;
        [n2_z, t736]
    };
    // drives
    let [t737, t738, t739, t740, t741, t742] = {
        let t737 = t736 + tau1;
        let t738 = tau2 - n2_z;
        let t739 = t683 + tau3;
        let t740 = t639 + tau4;
        let t741 = tau5 - n5_z;
        let t742 = tau6 - n6_z;
        [t737, t738, t739, t740, t741, t742]
    };
    // ddq
    {
        let t744 = t738 + t737 * t221;
        let t748 = t739 + t737 * t222 + t233 * t744;
        let t754 = t740 + t737 * t223 - t236 * t744 - t255 * t748;
        let t762 = t741 + t737 * t224 - t239 * t744 - t260 * t748 + t285 * t754;
        let t770 = t742 + t737 * t225 - t242 * t744 - t265 * t748 + t292 * t754;
        let t778 = t334 * (t770 - t318 * t762);
        let t780 = t305 * t762 - t318 * t778;
        let t784 = t275 * t754 + t285 * t780 + t292 * t778;
        let t790 = t249 * t748 - t255 * t784 - t260 * t780 - t265 * t778;
        let t797 = t242 * t778;
        let t798 = t229 * t744 + t233 * t790 - t236 * t784 - t239 * t780 - t797;
        let t805 = t224 * t780;
        let t806 = t737 * t220 + t221 * t798 + t222 * t790 + t223 * t784 + t805;
        let t808 = t806 + t225 * t778;
        put(0, t808);
        put(1, t798);
        put(2, t790);
        put(3, t784);
        put(4, t780);
        put(5, t778);
    }
}
