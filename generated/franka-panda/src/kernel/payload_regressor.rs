//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its
//! origin. Katsumata et al. 2019, (7).
//!
//! 389 multiplications, 277 additions; 7 x 10, 68 of 70 structurally nonzero.

use super::super::runtime::{Scalar, apart};
use super::super::{DOF, GRAVITY, Trig, constants};

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

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 10 + PATTERN[k].1
}

/// Regressor of a body fixed to the tool frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 10]; 7]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            59 => flat[60] = S::default(),
            61 => flat[63] = S::default(),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 10]; 7]) {
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
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6, ddq7] = *ddq;
    let k0 = S::constant(-GRAVITY[2]);
    let k4 = S::constant(0.088);
    let k_A = S::constant(constants::A);
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
    // link 2: motion
    let [t0, t1, t2, t3, dw2_y, t13, t14, t15] = {
        let t0 = s2 * k0;
        let t1 = c2 * k0;
        let t2 = s2 * dq1;
        let t3 = c2 * dq1;
        let t10 = dq2 * t3;
        let dw2_y = dq2 * t2 - c2 * ddq1;
        let t13 = t2 * t3 - ddq2;
        let t14 = t2 * t2 + dq2 * dq2;
        let t15 = t10 + (s2 * ddq1 + t10);
        [t0, t1, t2, t3, dw2_y, t13, t14, t15]
    };
    // link 3: motion
    let [
        t16, z1_3_y, t22, t25, a3_y, t31, w3_y, w3_z,
        dw3_y, t51, t52, t53, t54, t55, t56,
    ] = {
        let t16 = s2 * c3;
        let z1_3_y = s2 * s3;
        let t20 = k_L2 * t15;
        let t21 = t0 + k_L2 * t13;
        let t22 = k_L2 * t14 - t1;
        let t25 = c3 * t21 - s3 * t20;
        let a3_y = c3 * t20 + s3 * t21;
        let t31 = c3 * t2 - s3 * dq2;
        let w3_y = c3 * dq2 + s3 * t2;
        let w3_z = t3 + dq3;
        let t42 = dw2_y - ddq3;
        let t43 = t31 * t31;
        let t44 = w3_z * w3_z;
        let t45 = t31 * w3_y;
        let t46 = t31 * w3_z;
        let t47 = w3_y * w3_z;
        let dw3_y = s3 * t15 - c3 * t13 + t46;
        let t51 = t14 + (t44 - t43);
        let t52 = t45 - t42;
        let t53 = t42 + t45;
        let t54 = t43 + t44;
        let t55 = t46 + dw3_y;
        let t56 = t47 - (c3 * t15 + s3 * t13 - t47);
        [
        t16, z1_3_y, t22, t25, a3_y, t31, w3_y, w3_z,
        dw3_y, t51, t52, t53, t54, t55, t56,
    ]
    };
    // link 4: motion
    let [
        t61, t65, t68, t71, w4_y, t81, t89, t91,
        t92, t93, t94, t95, t96,
    ] = {
        let t60 = t25 + k_A * t51;
        let t61 = a3_y - k_A * t53;
        let t62 = t22 + k_A * t55;
        let t65 = c4 * t60 + s4 * t62;
        let t68 = c4 * t62 - s4 * t60;
        let t71 = c4 * t31 - s4 * w3_z;
        let w4_y = c4 * w3_z + s4 * t31;
        let t81 = w3_y - dq4;
        let t82 = dw3_y - ddq4;
        let t83 = t71 * t71;
        let t84 = t81 * t81;
        let t85 = t71 * w4_y;
        let t86 = t71 * t81;
        let t87 = w4_y * t81;
        let t89 = s4 * t56 - c4 * t52 + t86;
        let t91 = t54 - (t83 - t84);
        let t92 = t85 - t82;
        let t93 = t82 + t85;
        let t94 = t83 + t84;
        let t95 = t86 + t89;
        let t96 = t87 + (t87 - (c4 * t56 + s4 * t52));
        [
        t61, t65, t68, t71, w4_y, t81, t89, t91,
        t92, t93, t94, t95, t96,
    ]
    };
    // link 5: motion
    let [
        t107, a5_x, t114, t117, t120, w5_z, t135, t136,
        t137, t138,
    ] = {
        let t106 = t65 - (k_A * t91 - k_L3 * t92);
        let t107 = t68 + (k_L3 * t94 - k_A * t93);
        let t108 = t61 + (k_A * t95 + k_L3 * t96);
        let a5_x = s5 * t108 - c5 * t106;
        let t114 = c5 * t108 + s5 * t106;
        let t117 = c5 * t71 - s5 * t81;
        let t120 = c5 * t81 + s5 * t71;
        let w5_z = w4_y + dq5;
        let dw5_z = ddq5 - t89;
        let t133 = t120 * w5_z;
        let t135 = c5 * t92 - s5 * t96 - t117 * w5_z;
        let t136 = dw5_z + t117 * t120;
        let t137 = t117 * t117 + w5_z * w5_z;
        let t138 = t133 - (c5 * t96 + s5 * t92 - t133);
        [
        t107, a5_x, t114, t117, t120, w5_z, t135, t136,
        t137, t138,
    ]
    };
    // link 6: motion
    let [
        a6_x, t144, t147, w6_y, w6_z, dw6_y, t167, t168,
        t169, t170, t171, t172,
    ] = {
        let a6_x = c6 * a5_x - s6 * t107;
        let t144 = c6 * t107 + s6 * a5_x;
        let t147 = c6 * t117 - s6 * w5_z;
        let w6_y = c6 * w5_z + s6 * t117;
        let w6_z = dq6 - t120;
        let dw6_z = t135 + ddq6;
        let t159 = t147 * t147;
        let t160 = w6_z * w6_z;
        let t161 = t147 * w6_y;
        let t162 = t147 * w6_z;
        let t163 = w6_y * w6_z;
        let dw6_x = c6 * t138 + s6 * t136 + t163;
        let dw6_y = c6 * t136 - s6 * t138 + t162;
        let t167 = t137 + (t160 - t159);
        let t168 = dw6_z + t161;
        let t169 = t161 - dw6_z;
        let t170 = t159 + t160;
        let t171 = t162 + dw6_y;
        let t172 = t163 + dw6_x;
        [
        a6_x, t144, t147, w6_y, w6_z, dw6_y, t167, t168,
        t169, t170, t171, t172,
    ]
    };
    // link 7: motion
    let [
        t177, t181, a7_y, t193, t196, dw7_z, t201, t202,
        t203, dw7_x, t205, t206, t207, t208, t209, t210,
        t211, t212,
    ] = {
        let t176 = k4 * t167 - a6_x;
        let t177 = t144 + k4 * t169;
        let t178 = t114 + k4 * t171;
        let t181 = c7 * t176 + s7 * t178;
        let a7_y = s7 * t176 - c7 * t178;
        let t187 = c7 * t147 - s7 * w6_z;
        let w7_y = c7 * w6_z + s7 * t147;
        let t193 = c7 * t168 - s7 * t172;
        let t196 = c7 * t172 + s7 * t168;
        let w7_z = dq7 - w6_y;
        let dw7_z = ddq7 - dw6_y;
        let t199 = t187 * t187;
        let t200 = w7_z * w7_z;
        let t201 = t187 * w7_y;
        let t202 = t187 * w7_z;
        let t203 = w7_y * w7_z;
        let dw7_x = t196 + t203;
        let t205 = t193 + t202;
        let t206 = t200 - t199;
        let t207 = t170 + t206;
        let t208 = dw7_z + t201;
        let t209 = dw7_z - t201;
        let t210 = t199 + t200;
        let t211 = t202 + t205;
        let t212 = t203 + dw7_x;
        let t213 = -t201;
        put(60, a7_y); // row 7, MSX
        put(61, t181); // row 7, MSY
        put(62, t201); // row 7, XX
        put(63, t213); // row 7, YY
        put(64, dw7_z); // row 7, ZZ
        put(66, t196); // row 7, XZ
        put(67, t193); // row 7, YZ
        [
        t177, t181, a7_y, t193, t196, dw7_z, t201, t202,
        t203, dw7_x, t205, t206, t207, t208, t209, t210,
        t211, t212,
    ]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, z2_4_x, t221] = {
        let z1_4_x = c2 * s4 - c4 * t16;
        let z1_4_y = c2 * c4 + s4 * t16;
        let z2_4_x = s3 * c4;
        let t221 = s3 * s4;
        [z1_4_x, z1_4_y, z2_4_x, t221]
    };
    // joint axes in frame 5
    let [z1_5_x, t227, z2_5_x, t233, t234, z3_5_x, z3_6_z] = {
        let z1_5_x = c5 * z1_4_x + s5 * z1_3_y;
        let t227 = s5 * z1_4_x - c5 * z1_3_y;
        let z2_5_x = c5 * z2_4_x + c3 * s5;
        let t233 = s5 * z2_4_x - c3 * c5;
        let t234 = c4 * k_A;
        let z3_5_x = s4 * c5;
        let z3_6_z = s4 * s5;
        [z1_5_x, t227, z2_5_x, t233, t234, z3_5_x, z3_6_z]
    };
    // payload: column M
    let [t239, t242, t274, t277] = {
        let t239 = c7 * t181 + s7 * a7_y;
        let t242 = s7 * t181 - c7 * a7_y;
        let t243 = k4 * t177;
        let t244 = k4 * t242;
        let t247 = c6 * t239 - s6 * t177;
        let t250 = s6 * t239 + c6 * t177;
        let t251 = s6 * t244;
        let t252 = c6 * t244;
        let t255 = c5 * t247 + s5 * t242;
        let t258 = c5 * t242 - s5 * t247;
        let t269 = k_A * t258;
        let t270 = c5 * t251 + s5 * t243 + k_L3 * t258;
        let t271 = k_L3 * t255 + k_A * t250 - (c5 * t243 - s5 * t251);
        let t272 = t269 - t252;
        let t274 = t234 + k_L2 * s4;
        let t277 = s4 * k_A - k_L2 * c4;
        let t283 = t258 * t277 - t270;
        let t284 = t272 - t258 * t274;
        let t285 = t250 * t274 + t255 * t277 - t271;
        let t290 = z1_3_y * t285 - (z1_4_y * t284 - z1_4_x * t283);
        let t295 = c3 * t285 + (z2_4_x * t283 + t221 * t284);
        let t299 = t269 - (s4 * t270 + c4 * t272);
        let t300 = -t243;
        put(0, t290); // row 1, M
        put(10, t295); // row 2, M
        put(20, t299); // row 3, M
        put(30, t271); // row 4, M
        put(40, t252); // row 5, M
        put(50, t300); // row 6, M
        [t239, t242, t274, t277]
    };
    // payload: column MSX
    let [t302, t305, t307, t308] = {
        let t302 = s7 * t209;
        let t303 = c7 * t207 + t302;
        let t305 = c7 * t209;
        let t306 = t305 - s7 * t207;
        let t307 = s7 * t177;
        let t308 = c7 * t177;
        let t311 = k4 * t211 - t308;
        let t312 = a7_y + k4 * t306;
        let t315 = c6 * t303 + s6 * t211;
        let t318 = s6 * t303 - c6 * t211;
        let t321 = c6 * t307 + s6 * t312;
        let t324 = s6 * t307 - c6 * t312;
        let t327 = s5 * t306 - c5 * t315;
        let t330 = s5 * t315 + c5 * t306;
        let t341 = k_A * t330;
        let t342 = c5 * t321 + s5 * t311 + k_L3 * t330;
        let t343 = c5 * t311 - s5 * t321 + (k_A * t318 - k_L3 * t327);
        let t344 = t324 + t341;
        let t350 = t342 - t277 * t330;
        let t351 = t344 - t274 * t330;
        let t352 = t274 * t318 - t277 * t327 - t343;
        let t357 = z1_3_y * t352 + (z1_4_x * t350 + z1_4_y * t351);
        let t362 = c3 * t352 + (z2_4_x * t350 - t221 * t351);
        let t366 = s4 * t342 + c4 * t344 - t341;
        put(1, t357); // row 1, MSX
        put(11, t362); // row 2, MSX
        put(21, t366); // row 3, MSX
        put(31, t343); // row 4, MSX
        put(41, t324); // row 5, MSX
        put(51, t311); // row 6, MSX
        [t302, t305, t307, t308]
    };
    // payload: column MSY
    let [t367, t370] = {
        let t367 = c7 * t208;
        let t369 = t367 - s7 * t210;
        let t370 = s7 * t208;
        let t372 = t370 + c7 * t210;
        let t375 = t307 - k4 * t212;
        let t376 = k4 * t372 - t181;
        let t379 = s6 * t212 - c6 * t369;
        let t382 = s6 * t369 + c6 * t212;
        let t385 = s6 * t376 - c6 * t308;
        let t388 = s6 * t308 + c6 * t376;
        let t391 = s5 * t372 - c5 * t379;
        let t394 = s5 * t379 + c5 * t372;
        let t405 = k_A * t394;
        let t406 = k_L3 * t394 - (s5 * t375 - c5 * t385);
        let t407 = s5 * t385 + c5 * t375 + (k_L3 * t391 + k_A * t382);
        let t408 = t405 - t388;
        let t414 = t406 - t277 * t394;
        let t415 = t408 - t274 * t394;
        let t416 = t274 * t382 + t277 * t391 - t407;
        let t421 = z1_3_y * t416 - (z1_4_x * t414 + z1_4_y * t415);
        let t426 = c3 * t416 + (t221 * t415 - z2_4_x * t414);
        let t430 = t405 - (s4 * t406 + c4 * t408);
        put(2, t421); // row 1, MSY
        put(12, t426); // row 2, MSY
        put(22, t430); // row 3, MSY
        put(32, t407); // row 4, MSY
        put(42, t388); // row 5, MSY
        put(52, t375); // row 6, MSY
        [t367, t370]
    };
    // payload: column MSZ
    {
        let t433 = c7 * t193 + s7 * t196;
        let t436 = c7 * t196 - s7 * t193;
        let t438 = k4 * t436;
        let t439 = k4 * t170 - t239;
        let t442 = s6 * t170 - c6 * t433;
        let t445 = s6 * t433 + c6 * t170;
        let t448 = s6 * t438 - c6 * t242;
        let t451 = s6 * t242 + c6 * t438;
        let t454 = c5 * t442 + s5 * t436;
        let t457 = c5 * t436 - s5 * t442;
        let t468 = k_A * t457;
        let t469 = k_L3 * t457 - (s5 * t439 - c5 * t448);
        let t470 = s5 * t448 + c5 * t439 + (k_L3 * t454 - k_A * t445);
        let t471 = t468 - t451;
        let t477 = t277 * t457 - t469;
        let t478 = t471 - t274 * t457;
        let t479 = t470 - (t277 * t454 - t274 * t445);
        let t484 = z1_4_x * t477 - z1_4_y * t478 - z1_3_y * t479;
        let t489 = z2_4_x * t477 + t221 * t478 - c3 * t479;
        let t493 = t468 - (s4 * t469 + c4 * t471);
        put(3, t484); // row 1, MSZ
        put(13, t489); // row 2, MSZ
        put(23, t493); // row 3, MSZ
        put(33, t470); // row 4, MSZ
        put(43, t451); // row 5, MSZ
        put(53, t439); // row 6, MSZ
    }
    // payload: column XX
    let [t495, t498, t501, t504] = {
        let t495 = s7 * t202;
        let t496 = c7 * dw7_x + t495;
        let t498 = c7 * t202;
        let t499 = s7 * dw7_x - t498;
        let t501 = s6 * t201;
        let t502 = c6 * t496 + t501;
        let t504 = c6 * t201;
        let t505 = s6 * t496 - t504;
        let t510 = z1_4_y * t505 + (z1_5_x * t502 + t227 * t499);
        let t515 = z2_5_x * t502 + t233 * t499 - t221 * t505;
        let t520 = c4 * t505 + (z3_5_x * t502 + z3_6_z * t499);
        let t523 = c5 * t499 - s5 * t502;
        put(4, t510); // row 1, XX
        put(14, t515); // row 2, XX
        put(24, t520); // row 3, XX
        put(34, t523); // row 4, XX
        put(44, t505); // row 5, XX
        put(54, t499); // row 6, XX
        [t495, t498, t501, t504]
    };
    // payload: column YY
    let [t524, t527] = {
        let t524 = c7 * t203;
        let t526 = t524 + s7 * t205;
        let t527 = s7 * t203;
        let t529 = c7 * t205 - t527;
        let t531 = t501 + c6 * t526;
        let t533 = t504 - s6 * t526;
        let t538 = z1_4_y * t533 - (z1_5_x * t531 - t227 * t529);
        let t543 = t233 * t529 - z2_5_x * t531 - t221 * t533;
        let t548 = c4 * t533 + (z3_6_z * t529 - z3_5_x * t531);
        let t551 = s5 * t531 + c5 * t529;
        put(5, t538); // row 1, YY
        put(15, t543); // row 2, YY
        put(25, t548); // row 3, YY
        put(35, t551); // row 4, YY
        put(45, t533); // row 5, YY
        put(55, t529); // row 6, YY
        [t524, t527]
    };
    // payload: column ZZ
    let t578 = {
        let t552 = t524 - t495;
        let t553 = t498 + t527;
        let t556 = c6 * t552 + s6 * dw7_z;
        let t559 = s6 * t552 - c6 * dw7_z;
        let t564 = z1_4_y * t559 + (z1_5_x * t556 + t227 * t553);
        let t569 = z2_5_x * t556 + t233 * t553 - t221 * t559;
        let t574 = c4 * t559 + (z3_5_x * t556 + z3_6_z * t553);
        let t577 = c5 * t553 - s5 * t556;
        let t578 = t210 - t207;
        put(6, t564); // row 1, ZZ
        put(16, t569); // row 2, ZZ
        put(26, t574); // row 3, ZZ
        put(36, t577); // row 4, ZZ
        put(46, t559); // row 5, ZZ
        put(56, t553); // row 6, ZZ
        put(65, t578); // row 7, XY
        t578
    };
    // payload: column XY
    {
        let t581 = c7 * t211 - s7 * t212;
        let t584 = s7 * t211 + c7 * t212;
        let t587 = c6 * t581 + s6 * t578;
        let t590 = s6 * t581 - c6 * t578;
        let t595 = z1_4_y * t590 + (z1_5_x * t587 + t227 * t584);
        let t600 = z2_5_x * t587 + t233 * t584 - t221 * t590;
        let t605 = c4 * t590 + (z3_5_x * t587 + z3_6_z * t584);
        let t608 = c5 * t584 - s5 * t587;
        put(7, t595); // row 1, XY
        put(17, t600); // row 2, XY
        put(27, t605); // row 3, XY
        put(37, t608); // row 4, XY
        put(47, t590); // row 5, XY
        put(57, t584); // row 6, XY
    }
    // payload: column XZ
    let t637 = {
        let t610 = t305 - s7 * t206;
        let t612 = t302 + c7 * t206;
        let t615 = c6 * t610 + s6 * t196;
        let t618 = s6 * t610 - c6 * t196;
        let t623 = z1_4_y * t618 + (z1_5_x * t615 + t227 * t612);
        let t628 = z2_5_x * t615 + t233 * t612 - t221 * t618;
        let t633 = c4 * t618 + (z3_5_x * t615 + z3_6_z * t612);
        let t636 = c5 * t612 - s5 * t615;
        let t637 = t170 - t210;
        put(8, t623); // row 1, XZ
        put(18, t628); // row 2, XZ
        put(28, t633); // row 3, XZ
        put(38, t636); // row 4, XZ
        put(48, t618); // row 5, XZ
        put(58, t612); // row 6, XZ
        t637
    };
    // payload: column YZ
    {
        let t639 = c7 * t637 - t370;
        let t641 = t367 + s7 * t637;
        let t644 = c6 * t639 + s6 * t193;
        let t647 = s6 * t639 - c6 * t193;
        let t652 = z1_4_y * t647 + (z1_5_x * t644 + t227 * t641);
        let t657 = z2_5_x * t644 + t233 * t641 - t221 * t647;
        let t662 = c4 * t647 + (z3_5_x * t644 + z3_6_z * t641);
        let t665 = c5 * t641 - s5 * t644;
        put(9, t652); // row 1, YZ
        put(19, t657); // row 2, YZ
        put(29, t662); // row 3, YZ
        put(39, t665); // row 4, YZ
        put(49, t647); // row 5, YZ
        put(59, t641); // row 6, YZ
    }
}
