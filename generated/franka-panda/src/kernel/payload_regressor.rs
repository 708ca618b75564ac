//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin (the paper's (7)).
//!
//! 394 multiplications, 268 additions; 7 x 10, 68 of 70 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 68;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9),
    (1, 0), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7), (1, 8), (1, 9),
    (2, 0), (2, 1), (2, 2), (2, 3), (2, 4), (2, 5), (2, 6), (2, 7), (2, 8), (2, 9),
    (3, 0), (3, 1), (3, 2), (3, 3), (3, 4), (3, 5), (3, 6), (3, 7), (3, 8), (3, 9),
    (4, 0), (4, 1), (4, 2), (4, 3), (4, 4), (4, 5), (4, 6), (4, 7), (4, 8), (4, 9),
    (5, 0), (5, 1), (5, 2), (5, 3), (5, 4), (5, 5), (5, 6), (5, 7), (5, 8), (5, 9),
    (6, 1), (6, 2), (6, 4), (6, 5), (6, 6), (6, 7), (6, 8), (6, 9),
];

/// Regressor of a body fixed to the tool frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 10]; 7]) {
    out.as_flattened_mut().fill(S::default());
    entries(trig, dq, ddq, |k, x| {
        out[PATTERN[k].0][PATTERN[k].1] = x;
    });
}

/// The same, only the entries of [`PATTERN`].
#[inline]
pub fn packed<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [S; NONZEROS]) {
    entries(trig, dq, ddq, |k, x| out[k] = x);
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6, ddq7] = *ddq;
    let A = S::constant(0.0825);
    let L2 = S::constant(0.316);
    let L3 = S::constant(0.384);
    let k0 = S::constant(9.81);
    let k4 = S::constant(0.088);
    // link 2: motion
    let [t0, t1, t4, t5, t6, t8, t9] = {
        let t0 = s2 * dq1;
        let t1 = c2 * dq1;
        let t4 = s2 * k0;
        let t5 = c2 * k0;
        let t6 = dq2 * t1;
        let t8 = s2 * ddq1 + t6;
        let t9 = c2 * ddq1 - dq2 * t0;
        [t0, t1, t4, t5, t6, t8, t9]
    };
    // link 3: motion
    let [
        t12, w3_y, t32, t35, a3_y, w3_z, t42, dw3_y,
        dw3_z,
    ] = {
        let t12 = c3 * t0 - s3 * dq2;
        let w3_y = c3 * dq2 + s3 * t0;
        let t30 = L2 * (t6 + t8);
        let t31 = t4 + L2 * (t0 * t1 - ddq2);
        let t32 = L2 * (t0 * t0 + dq2 * dq2) - t5;
        let t35 = c3 * t31 - s3 * t30;
        let a3_y = c3 * t30 + s3 * t31;
        let w3_z = t1 + dq3;
        let t42 = c3 * t8 - s3 * ddq2 - dq3 * w3_y;
        let dw3_y = c3 * ddq2 + s3 * t8 + dq3 * t12;
        let dw3_z = t9 + ddq3;
        [
        t12, w3_y, t32, t35, a3_y, w3_z, t42, dw3_y,
        dw3_z,
    ]
    };
    // link 4: motion
    let [
        t47, w4_y, t68, t72, a4_y, w4_z, dw4_x, dw4_y,
        t81,
    ] = {
        let t47 = c4 * t12 - s4 * w3_z;
        let w4_y = c4 * w3_z + s4 * t12;
        let t67 = t35 + A * (w3_y * w3_y + w3_z * w3_z);
        let t68 = a3_y - A * (t12 * w3_y - dw3_z);
        let t69 = t32 + A * (dw3_y + t12 * w3_z);
        let t72 = c4 * t67 + s4 * t69;
        let a4_y = s4 * t67 - c4 * t69;
        let w4_z = dq4 - w3_y;
        let dw4_x = s4 * dw3_z - c4 * t42 + dq4 * w4_y;
        let dw4_y = c4 * dw3_z + s4 * t42 + dq4 * t47;
        let t81 = dw3_y - ddq4;
        [
        t47, w4_y, t68, t72, a4_y, w4_z, dw4_x, dw4_y,
        t81,
    ]
    };
    // link 5: motion
    let [
        t84, t87, t116, t120, a6_z, w5_z, dw5_x, t128,
        dw5_z,
    ] = {
        let t84 = c5 * t47 + s5 * w4_z;
        let t87 = c5 * w4_z - s5 * t47;
        let t96 = w4_z * w4_z;
        let t97 = t47 * w4_y;
        let t115 = t72 - (A * (w4_y * w4_y + t96) + L3 * (t81 - t97));
        let t116 = L3 * (t47 * t47 + t96) - A * (t81 + t97) - a4_y;
        let t117 = A * (dw4_y + t47 * w4_z) + L3 * (dw4_x + w4_y * w4_z) - t68;
        let t120 = c5 * t115 + s5 * t117;
        let a6_z = c5 * t117 - s5 * t115;
        let w5_z = w4_y + dq5;
        let dw5_x = c5 * dw4_x + s5 * t81 - dq5 * t87;
        let t128 = s5 * dw4_x - c5 * t81 - dq5 * t84;
        let dw5_z = dw4_y + ddq5;
        [
        t84, t87, t116, t120, a6_z, w5_z, dw5_x, t128,
        dw5_z,
    ]
    };
    // link 6: motion
    let [t132, w6_y, t144, t147, w6_z, dw6_x, t152, dw6_z] = {
        let t132 = c6 * t84 - s6 * w5_z;
        let w6_y = c6 * w5_z + s6 * t84;
        let t144 = c6 * t120 + s6 * t116;
        let t147 = c6 * t116 - s6 * t120;
        let w6_z = t87 + dq6;
        let dw6_x = c6 * dw5_x + s6 * dw5_z + dq6 * w6_y;
        let t152 = s6 * dw5_x - c6 * dw5_z - dq6 * t132;
        let dw6_z = t128 + ddq6;
        [t132, w6_y, t144, t147, w6_z, dw6_x, t152, dw6_z]
    };
    // link 7: motion
    let [
        t156, w7_y, t177, t181, a7_y, w7_z, dw7_x, dw7_y,
        dw7_z,
    ] = {
        let t156 = c7 * t132 - s7 * w6_z;
        let w7_y = c7 * w6_z + s7 * t132;
        let t176 = t144 + k4 * (w6_y * w6_y + w6_z * w6_z);
        let t177 = t147 + k4 * (t132 * w6_y - dw6_z);
        let t178 = a6_z + k4 * (t152 - t132 * w6_z);
        let t181 = c7 * t176 - s7 * t178;
        let a7_y = c7 * t178 + s7 * t176;
        let w7_z = dq7 - w6_y;
        let dw7_x = c7 * dw6_x + s7 * dw6_z + dq7 * w7_y;
        let dw7_y = c7 * dw6_z - s7 * dw6_x + dq7 * t156;
        let dw7_z = t152 + ddq7;
        put(60, a7_y); // row 7, MSX
        put(61, t181); // row 7, MSY
        put(64, dw7_z); // row 7, ZZ
        [
        t156, w7_y, t177, t181, a7_y, w7_z, dw7_x, dw7_y,
        dw7_z,
    ]
    };
    // joint axes in frame 3
    let [t191, z1_3_y] = {
        let t191 = s2 * c3;
        let z1_3_y = s2 * s3;
        [t191, z1_3_y]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, z2_4_x, t200] = {
        let z1_4_x = c2 * s4 - c4 * t191;
        let z1_4_y = c2 * c4 + s4 * t191;
        let z2_4_x = s3 * c4;
        let t200 = s3 * s4;
        [z1_4_x, z1_4_y, z2_4_x, t200]
    };
    // joint axes in frame 5
    let [z1_5_x, t206, z2_5_x, t212, t213, z3_5_x, z3_6_z] = {
        let z1_5_x = c5 * z1_4_x + s5 * z1_3_y;
        let t206 = s5 * z1_4_x - c5 * z1_3_y;
        let z2_5_x = c5 * z2_4_x + c3 * s5;
        let t212 = s5 * z2_4_x - c3 * c5;
        let t213 = c4 * A;
        let z3_5_x = s4 * c5;
        let z3_6_z = s4 * s5;
        [z1_5_x, t206, z2_5_x, t212, t213, z3_5_x, z3_6_z]
    };
    // joint axes in frame 7
    let [
        t216, t217, t218, t219, t220, t221, t222, t223,
        t224, t225, t226, t227, t228, t229, t230,
    ] = {
        let t216 = t156 * t156;
        let t217 = w7_y * w7_y;
        let t218 = w7_z * w7_z;
        let t219 = t156 * w7_y;
        let t220 = t156 * w7_z;
        let t221 = w7_y * w7_z;
        let t222 = t217 + t218;
        let t223 = dw7_z + t219;
        let t224 = dw7_y - t220;
        let t225 = dw7_z - t219;
        let t226 = t216 + t218;
        let t227 = dw7_x - t221;
        let t228 = dw7_y + t220;
        let t229 = dw7_x + t221;
        let t230 = t216 + t217;
        put(62, t219); // row 7, XX
        put(66, t227); // row 7, XZ
        put(67, t224); // row 7, YZ
        [
        t216, t217, t218, t219, t220, t221, t222, t223,
        t224, t225, t226, t227, t228, t229, t230,
    ]
    };
    // payload: column M
    let [t233, t236, t237, t268, t271] = {
        let t233 = c7 * t181 + s7 * a7_y;
        let t236 = s7 * t181 - c7 * a7_y;
        let t237 = k4 * t177;
        let t238 = k4 * t236;
        let t241 = s6 * t177 - c6 * t233;
        let t244 = s6 * t233 + c6 * t177;
        let t245 = s6 * t238;
        let t246 = c6 * t238;
        let t249 = s5 * t236 - c5 * t241;
        let t252 = s5 * t241 + c5 * t236;
        let t263 = A * t252;
        let t264 = c5 * t245 + s5 * t237 + L3 * t252;
        let t265 = L3 * t249 + A * t244 - (c5 * t237 - s5 * t245);
        let t266 = t246 - t263;
        let t268 = t213 + L2 * s4;
        let t271 = s4 * A - L2 * c4;
        let t277 = t252 * t271 - t264;
        let t278 = t266 + t252 * t268;
        let t279 = t244 * t268 + t249 * t271 - t265;
        let t284 = z1_3_y * t279 + (z1_4_x * t277 + z1_4_y * t278);
        let t289 = c3 * t279 - (t200 * t278 - z2_4_x * t277);
        let t293 = t263 + (c4 * t266 - s4 * t264);
        put(0, t284); // row 1, M
        put(10, t289); // row 2, M
        put(20, t293); // row 3, M
        put(30, t265); // row 4, M
        put(40, t246); // row 5, M
        [t233, t236, t237, t268, t271]
    };
    // payload: column MSX
    let [t295, t298, t300, t301] = {
        let t295 = s7 * t225;
        let t296 = c7 * t222 + t295;
        let t298 = c7 * t225;
        let t299 = s7 * t222 - t298;
        let t300 = s7 * t177;
        let t301 = c7 * t177;
        let t304 = k4 * t228 - t301;
        let t305 = k4 * t299 - a7_y;
        let t308 = c6 * t296 + s6 * t228;
        let t311 = c6 * t228 - s6 * t296;
        let t314 = c6 * t300 - s6 * t305;
        let t317 = s6 * t300 + c6 * t305;
        let t320 = c5 * t308 + s5 * t299;
        let t323 = c5 * t299 - s5 * t308;
        let t334 = A * t323;
        let t335 = c5 * t314 + s5 * t304 - L3 * t323;
        let t336 = c5 * t304 - s5 * t314 - (A * t311 - L3 * t320);
        let t337 = t317 - t334;
        let t343 = t335 + t271 * t323;
        let t344 = t337 + t268 * t323;
        let t345 = t336 + (t268 * t311 - t271 * t320);
        let t350 = z1_4_x * t343 + z1_4_y * t344 - z1_3_y * t345;
        let t355 = z2_4_x * t343 - t200 * t344 - c3 * t345;
        let t359 = t334 + (s4 * t335 + c4 * t337);
        put(1, t350); // row 1, MSX
        put(11, t355); // row 2, MSX
        put(21, t359); // row 3, MSX
        put(31, t336); // row 4, MSX
        put(41, t317); // row 5, MSX
        put(51, t304); // row 6, MSX
        [t295, t298, t300, t301]
    };
    // payload: column MSY
    let [t360, t363] = {
        let t360 = c7 * t223;
        let t362 = t360 - s7 * t226;
        let t363 = s7 * t223;
        let t365 = t363 + c7 * t226;
        let t368 = t300 - k4 * t229;
        let t369 = t181 - k4 * t365;
        let t372 = s6 * t229 - c6 * t362;
        let t375 = s6 * t362 + c6 * t229;
        let t378 = c6 * t301 + s6 * t369;
        let t381 = s6 * t301 - c6 * t369;
        let t384 = c5 * t372 - s5 * t365;
        let t387 = s5 * t372 + c5 * t365;
        let t398 = A * t387;
        let t399 = c5 * t378 + s5 * t368 - L3 * t387;
        let t400 = A * t375 - L3 * t384 - (s5 * t378 - c5 * t368);
        let t401 = t381 - t398;
        let t407 = t399 + t271 * t387;
        let t408 = t401 + t268 * t387;
        let t409 = t400 - (t268 * t375 - t271 * t384);
        let t414 = z1_4_x * t407 + z1_4_y * t408 - z1_3_y * t409;
        let t419 = z2_4_x * t407 - t200 * t408 - c3 * t409;
        let t423 = t398 + (s4 * t399 + c4 * t401);
        put(2, t414); // row 1, MSY
        put(12, t419); // row 2, MSY
        put(22, t423); // row 3, MSY
        put(32, t400); // row 4, MSY
        put(42, t381); // row 5, MSY
        put(52, t368); // row 6, MSY
        [t360, t363]
    };
    // payload: column MSZ
    {
        let t426 = c7 * t224 + s7 * t227;
        let t429 = c7 * t227 - s7 * t224;
        let t431 = k4 * t429;
        let t432 = k4 * t230 - t233;
        let t435 = s6 * t230 - c6 * t426;
        let t438 = s6 * t426 + c6 * t230;
        let t441 = s6 * t431 - c6 * t236;
        let t444 = s6 * t236 + c6 * t431;
        let t447 = c5 * t435 + s5 * t429;
        let t450 = s5 * t435 - c5 * t429;
        let t461 = A * t450;
        let t462 = s5 * t432 - c5 * t441 + L3 * t450;
        let t463 = s5 * t441 + c5 * t432 + (L3 * t447 - A * t438);
        let t464 = t444 + t461;
        let t470 = t462 - t271 * t450;
        let t471 = t464 - t268 * t450;
        let t472 = t463 + (t268 * t438 - t271 * t447);
        let t477 = z1_4_x * t470 + z1_4_y * t471 - z1_3_y * t472;
        let t482 = z2_4_x * t470 - t200 * t471 - c3 * t472;
        let t486 = s4 * t462 + c4 * t464 - t461;
        put(3, t477); // row 1, MSZ
        put(13, t482); // row 2, MSZ
        put(23, t486); // row 3, MSZ
        put(33, t463); // row 4, MSZ
        put(43, t444); // row 5, MSZ
        put(53, t432); // row 6, MSZ
    }
    // payload: column XX
    let [t488, t491, t494, t497] = {
        let t488 = s7 * t220;
        let t489 = c7 * dw7_x + t488;
        let t491 = c7 * t220;
        let t492 = s7 * dw7_x - t491;
        let t494 = s6 * t219;
        let t495 = c6 * t489 + t494;
        let t497 = c6 * t219;
        let t498 = s6 * t489 - t497;
        let t503 = z1_4_y * t498 + (z1_5_x * t495 + t206 * t492);
        let t508 = z2_5_x * t495 + t212 * t492 - t200 * t498;
        let t513 = c4 * t498 + (z3_5_x * t495 + z3_6_z * t492);
        let t516 = c5 * t492 - s5 * t495;
        put(4, t503); // row 1, XX
        put(14, t508); // row 2, XX
        put(24, t513); // row 3, XX
        put(34, t516); // row 4, XX
        put(44, t498); // row 5, XX
        put(54, t492); // row 6, XX
        [t488, t491, t494, t497]
    };
    // payload: column YY
    let [t517, t520] = {
        let t517 = c7 * t221;
        let t519 = t517 + s7 * dw7_y;
        let t520 = s7 * t221;
        let t522 = c7 * dw7_y - t520;
        let t524 = t494 + c6 * t519;
        let t526 = t497 - s6 * t519;
        let t531 = z1_4_y * t526 - (z1_5_x * t524 - t206 * t522);
        let t536 = t212 * t522 - z2_5_x * t524 - t200 * t526;
        let t541 = c4 * t526 - (z3_5_x * t524 - z3_6_z * t522);
        let t544 = s5 * t524 + c5 * t522;
        put(5, t531); // row 1, YY
        put(15, t536); // row 2, YY
        put(25, t541); // row 3, YY
        put(35, t544); // row 4, YY
        put(45, t526); // row 5, YY
        put(55, t522); // row 6, YY
        [t517, t520]
    };
    // payload: column ZZ
    let t571 = {
        let t545 = t517 - t488;
        let t546 = t491 + t520;
        let t549 = c6 * t545 + s6 * dw7_z;
        let t552 = s6 * t545 - c6 * dw7_z;
        let t557 = z1_4_y * t552 + (z1_5_x * t549 + t206 * t546);
        let t562 = z2_5_x * t549 + t212 * t546 - t200 * t552;
        let t567 = c4 * t552 + (z3_5_x * t549 + z3_6_z * t546);
        let t570 = c5 * t546 - s5 * t549;
        let t571 = t216 - t217;
        put(6, t557); // row 1, ZZ
        put(16, t562); // row 2, ZZ
        put(26, t567); // row 3, ZZ
        put(36, t570); // row 4, ZZ
        put(46, t552); // row 5, ZZ
        put(56, t546); // row 6, ZZ
        put(65, t571); // row 7, XY
        t571
    };
    // payload: column XY
    let t602 = {
        let t574 = c7 * t228 - s7 * t229;
        let t577 = s7 * t228 + c7 * t229;
        let t580 = c6 * t574 + s6 * t571;
        let t583 = s6 * t574 - c6 * t571;
        let t588 = z1_4_y * t583 + (z1_5_x * t580 + t206 * t577);
        let t593 = z2_5_x * t580 + t212 * t577 - t200 * t583;
        let t598 = c4 * t583 + (z3_5_x * t580 + z3_6_z * t577);
        let t601 = c5 * t577 - s5 * t580;
        let t602 = t218 - t216;
        put(7, t588); // row 1, XY
        put(17, t593); // row 2, XY
        put(27, t598); // row 3, XY
        put(37, t601); // row 4, XY
        put(47, t583); // row 5, XY
        put(57, t577); // row 6, XY
        t602
    };
    // payload: column XZ
    let t631 = {
        let t604 = t298 - s7 * t602;
        let t606 = t295 + c7 * t602;
        let t609 = c6 * t604 + s6 * t227;
        let t612 = s6 * t604 - c6 * t227;
        let t617 = z1_4_y * t612 + (z1_5_x * t609 + t206 * t606);
        let t622 = z2_5_x * t609 + t212 * t606 - t200 * t612;
        let t627 = c4 * t612 + (z3_5_x * t609 + z3_6_z * t606);
        let t630 = c5 * t606 - s5 * t609;
        let t631 = t217 - t218;
        put(8, t617); // row 1, XZ
        put(18, t622); // row 2, XZ
        put(28, t627); // row 3, XZ
        put(38, t630); // row 4, XZ
        put(48, t612); // row 5, XZ
        put(58, t606); // row 6, XZ
        t631
    };
    // payload: column YZ
    {
        let t633 = c7 * t631 - t363;
        let t635 = t360 + s7 * t631;
        let t638 = c6 * t633 + s6 * t224;
        let t641 = s6 * t633 - c6 * t224;
        let t646 = z1_4_y * t641 + (z1_5_x * t638 + t206 * t635);
        let t651 = z2_5_x * t638 + t212 * t635 - t200 * t641;
        let t656 = c4 * t641 + (z3_5_x * t638 + z3_6_z * t635);
        let t659 = c5 * t635 - s5 * t638;
        let t660 = -t237;
        let t661 = -t219;
        put(9, t646); // row 1, YZ
        put(19, t651); // row 2, YZ
        put(29, t656); // row 3, YZ
        put(39, t659); // row 4, YZ
        put(49, t641); // row 5, YZ
        put(50, t660); // row 6, M
        put(59, t635); // row 6, YZ
        put(63, t661); // row 7, YY
    }
}
