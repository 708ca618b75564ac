//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin (the paper's (7)).
//!
//! 419 multiplications, 281 additions; 7 x 10, 68 of 70 structurally nonzero.

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
    let flat = &mut out.as_flattened_mut()[..];
    flat[60] = S::default();
    flat[63] = S::default();
    nonzeros(trig, dq, ddq, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
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
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6, ddq7] = *ddq;
    let k0 = S::constant(9.81);
    let k1 = S::constant(0.01175);
    let k2 = S::constant(0.42076);
    let k3 = S::constant(0.01275);
    let k4 = S::constant(0.31436);
    let k5 = S::constant(0.00035);
    let k6 = S::constant(0.167455);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        a2_z, t6, a2_y, w2_x, w2_y, dw2_y, t20, t21,
        t22,
    ] = {
        let t3 = ddq1 * k1;
        let a2_z = t0 * k1;
        let t6 = s2 * k0 + c2 * t3;
        let a2_y = s2 * t3 - c2 * k0;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t17 = dq2 * w2_y;
        let dw2_x = s2 * ddq1 + t17;
        let dw2_y = c2 * ddq1 - dq2 * w2_x;
        let t20 = ddq2 - w2_x * w2_y;
        let t21 = w2_x * w2_x + dq2 * dq2;
        let t22 = t17 + dw2_x;
        [
        a2_z, t6, a2_y, w2_x, w2_y, dw2_y, t20, t21,
        t22,
    ]
    };
    // link 3: motion
    let [
        z1_3_x, z1_4_z, a3_z, t33, t36, w3_x, t42, w3_z,
        t57, t58, t59, t60,
    ] = {
        let z1_3_x = s2 * c3;
        let z1_4_z = s2 * s3;
        let t28 = t20 * k2 - t6;
        let a3_z = a2_y + t21 * k2;
        let t30 = a2_z - t22 * k2;
        let t33 = s3 * t30 - c3 * t28;
        let t36 = c3 * t30 + s3 * t28;
        let w3_x = c3 * w2_x - s3 * dq2;
        let t42 = c3 * dq2 + s3 * w2_x;
        let w3_z = w2_y + dq3;
        let dw3_z = dw2_y + ddq3;
        let t55 = t42 * w3_z;
        let t57 = c3 * t20 + s3 * t22 + w3_x * w3_z;
        let t58 = dw3_z + w3_x * t42;
        let t59 = w3_x * w3_x + w3_z * w3_z;
        let t60 = t55 + (s3 * t20 - c3 * t22 + t55);
        [
        z1_3_x, z1_4_z, a3_z, t33, t36, w3_x, t42, w3_z,
        t57, t58, t59, t60,
    ]
    };
    // link 4: motion
    let [
        t65, t69, a4_y, w4_x, t78, w4_z, t93, t94,
        t95, t96,
    ] = {
        let t64 = t33 + t58 * k3;
        let t65 = t36 + t59 * k3;
        let t66 = a3_z - t60 * k3;
        let t69 = c4 * t64 - s4 * t66;
        let a4_y = c4 * t66 + s4 * t64;
        let w4_x = c4 * w3_x + s4 * w3_z;
        let t78 = s4 * w3_x - c4 * w3_z;
        let w4_z = t42 + dq4;
        let dw4_z = t57 + ddq4;
        let t91 = t78 * w4_z;
        let dw4_x = s4 * t58 - c4 * t60 - t91;
        let t93 = w4_x * w4_z - (c4 * t58 + s4 * t60);
        let t94 = dw4_z + w4_x * t78;
        let t95 = w4_x * w4_x + w4_z * w4_z;
        let t96 = dw4_x - t91;
        [
        t65, t69, a4_y, w4_x, t78, w4_z, t93, t94,
        t95, t96,
    ]
    };
    // link 5: motion
    let [
        a5_z, t105, a5_y, w5_x, t114, t121, t129, t130,
        t131, t132,
    ] = {
        let t100 = t69 - t94 * k4;
        let a5_z = a4_y + t95 * k4;
        let t102 = t65 - t96 * k4;
        let t105 = c5 * t100 + s5 * t102;
        let a5_y = s5 * t100 - c5 * t102;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t114 = c5 * w4_z + s5 * w4_x;
        let t121 = t78 - dq5;
        let dw5_z = ddq5 - t93;
        let t127 = t114 * t121;
        let dw5_x = c5 * t96 - s5 * t94 + t127;
        let t129 = c5 * t94 + s5 * t96 - w5_x * t121;
        let t130 = dw5_z + w5_x * t114;
        let t131 = w5_x * w5_x + t121 * t121;
        let t132 = t127 + dw5_x;
        [
        a5_z, t105, a5_y, w5_x, t114, t121, t129, t130,
        t131, t132,
    ]
    };
    // link 6: motion
    let [
        t137, t141, a6_y, t147, t150, w6_z, dw6_y, t166,
        t167, t168,
    ] = {
        let t136 = t105 + t130 * k5;
        let t137 = a5_y - t131 * k5;
        let t138 = a5_z + t132 * k5;
        let t141 = c6 * t136 - s6 * t138;
        let a6_y = c6 * t138 + s6 * t136;
        let t147 = s6 * t121 - c6 * w5_x;
        let t150 = c6 * t121 + s6 * w5_x;
        let w6_z = t114 + dq6;
        let dw6_z = t129 + ddq6;
        let t163 = t150 * w6_z;
        let dw6_x = c6 * t132 + s6 * t130 - t163;
        let dw6_y = t147 * w6_z - (s6 * t132 - c6 * t130);
        let t166 = t147 * t150 - dw6_z;
        let t167 = t147 * t147 + w6_z * w6_z;
        let t168 = dw6_x - t163;
        [
        t137, t141, a6_y, t147, t150, w6_z, dw6_y, t166,
        t167, t168,
    ]
    };
    // link 7: motion
    let [
        a7_z, t177, a7_y, t189, t192, dw7_z, t197, t198,
        t199, t200, t201, t202, t203, t204, t205, t206,
        t207, t208,
    ] = {
        let t172 = t141 + t166 * k6;
        let a7_z = a6_y + t167 * k6;
        let t174 = t137 + t168 * k6;
        let t177 = c7 * t172 - s7 * t174;
        let a7_y = c7 * t174 + s7 * t172;
        let t183 = c7 * t147 + s7 * w6_z;
        let t186 = s7 * t147 - c7 * w6_z;
        let t189 = c7 * t166 - s7 * t168;
        let t192 = c7 * t168 + s7 * t166;
        let t193 = t150 - dq7;
        let dw7_z = dw6_y + ddq7;
        let t195 = t183 * t183;
        let t196 = t193 * t193;
        let t197 = t183 * t186;
        let t198 = t183 * t193;
        let t199 = t186 * t193;
        let t200 = t199 - t192;
        let t201 = t198 - t189;
        let t202 = t196 - t195;
        let t203 = t167 + t202;
        let t204 = dw7_z + t197;
        let t205 = t197 - dw7_z;
        let t206 = t195 + t196;
        let t207 = t198 + t201;
        let t208 = t199 + t200;
        put(60, a7_y); // row 7, MSX
        put(61, t177); // row 7, MSY
        put(62, t197); // row 7, XX
        put(64, dw7_z); // row 7, ZZ
        put(66, t192); // row 7, XZ
        put(67, t189); // row 7, YZ
        [
        a7_z, t177, a7_y, t189, t192, dw7_z, t197, t198,
        t199, t200, t201, t202, t203, t204, t205, t206,
        t207, t208,
    ]
    };
    // joint axes in frame 2
    let [t209, v1_2_y] = {
        let t209 = c2 * k1;
        let v1_2_y = s2 * k1;
        [t209, v1_2_y]
    };
    // joint axes in frame 3
    let [t214, v1_3_y, v2_3_x, v2_4_z] = {
        let t211 = s2 * k2;
        let t214 = c3 * t209 - s3 * t211;
        let v1_3_y = c3 * t211 + s3 * t209;
        let v2_3_x = c3 * k2;
        let v2_4_z = s3 * k2;
        [t214, v1_3_y, v2_3_x, v2_4_z]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, t226, z2_4_y, t228, t229, t232, t235] = {
        let z1_4_x = c4 * z1_3_x + c2 * s4;
        let z1_4_y = c2 * c4 - s4 * z1_3_x;
        let t226 = s3 * c4;
        let z2_4_y = s3 * s4;
        let t228 = c4 * v2_3_x;
        let t229 = s4 * v2_3_x;
        let t232 = s4 * v1_2_y - c4 * t214;
        let t235 = c4 * v1_2_y + s4 * t214;
        [z1_4_x, z1_4_y, t226, z2_4_y, t228, t229, t232, t235]
    };
    // joint axes in frame 5
    let [t238, z1_6_z, t244, t247, z3_5_x, z3_6_z] = {
        let t238 = s5 * z1_4_z - c5 * z1_4_x;
        let z1_6_z = c5 * z1_4_z + s5 * z1_4_x;
        let t244 = c5 * t226 + c3 * s5;
        let t247 = c3 * c5 - s5 * t226;
        let z3_5_x = s4 * c5;
        let z3_6_z = s4 * s5;
        [t238, z1_6_z, t244, t247, z3_5_x, z3_6_z]
    };
    // payload: column M
    let [t252, t255, t257] = {
        let t252 = c7 * t177 + s7 * a7_y;
        let t255 = s7 * t177 - c7 * a7_y;
        let t256 = k6 * t255;
        let t257 = k6 * t252;
        let t260 = c6 * t252 + s6 * a7_z;
        let t263 = c6 * a7_z - s6 * t252;
        let t268 = k5 * t263 - c6 * t256;
        let t269 = k5 * t260 - s6 * t256;
        let t272 = s5 * t255 - c5 * t260;
        let t275 = s5 * t260 + c5 * t255;
        let t285 = k4 * t272 - (s5 * t268 + c5 * t257);
        let t288 = s5 * t257 - c5 * t268 + k4 * t275 - k3 * t263;
        let t289 = t269 - k3 * t272;
        let t299 = t232 * t272 + t235 * t263 - v1_3_y * t275;
        let t300 = z1_4_z * t285 + (z1_4_y * t289 - z1_4_x * t288) + t299;
        let t310 = v2_4_z * t275 - (t229 * t263 - t228 * t272);
        let t311 = c3 * t285 + (t226 * t288 + z2_4_y * t289) + t310;
        let t314 = c4 * t289 - s4 * t288;
        put(0, t300); // row 1, M
        put(10, t311); // row 2, M
        put(20, t314); // row 3, M
        put(30, t285); // row 4, M
        put(40, t269); // row 5, M
        [t252, t255, t257]
    };
    // payload: column MSX
    let [t316, t319, t321, t322] = {
        let t316 = s7 * t205;
        let t317 = c7 * t203 - t316;
        let t319 = c7 * t205;
        let t320 = s7 * t203 + t319;
        let t321 = s7 * a7_z;
        let t322 = c7 * a7_z;
        let t325 = k6 * t320 - t321;
        let t326 = t322 - k6 * t317;
        let t329 = c6 * t317 + s6 * t207;
        let t332 = c6 * t207 - s6 * t317;
        let t341 = k5 * t332 - (c6 * t325 + s6 * a7_y);
        let t342 = c6 * a7_y - s6 * t325 + k5 * t329;
        let t345 = s5 * t320 - c5 * t329;
        let t348 = s5 * t329 + c5 * t320;
        let t358 = c5 * t326 - s5 * t341 + k4 * t345;
        let t361 = c5 * t341 + s5 * t326 - k4 * t348 + k3 * t332;
        let t362 = t342 - k3 * t345;
        let t372 = t232 * t345 + t235 * t332 - v1_3_y * t348;
        let t373 = z1_4_z * t358 + (z1_4_x * t361 + z1_4_y * t362) + t372;
        let t383 = v2_4_z * t348 + (t228 * t345 - t229 * t332);
        let t384 = c3 * t358 - (t226 * t361 - z2_4_y * t362) + t383;
        let t387 = s4 * t361 + c4 * t362;
        put(1, t373); // row 1, MSX
        put(11, t384); // row 2, MSX
        put(21, t387); // row 3, MSX
        put(31, t358); // row 4, MSX
        put(41, t342); // row 5, MSX
        put(51, t326); // row 6, MSX
        [t316, t319, t321, t322]
    };
    // payload: column MSY
    let [t388, t391] = {
        let t388 = c7 * t204;
        let t390 = s7 * t206 - t388;
        let t391 = s7 * t204;
        let t393 = t391 + c7 * t206;
        let t396 = k6 * t393 - t322;
        let t397 = k6 * t390 - t321;
        let t400 = c6 * t390 + s6 * t208;
        let t403 = c6 * t208 - s6 * t390;
        let t412 = c6 * t396 + s6 * t177 + k5 * t403;
        let t413 = c6 * t177 - s6 * t396 - k5 * t400;
        let t416 = c5 * t400 + s5 * t393;
        let t419 = s5 * t400 - c5 * t393;
        let t429 = s5 * t412 + c5 * t397 + k4 * t416;
        let t432 = c5 * t412 - s5 * t397 - k4 * t419 + k3 * t403;
        let t433 = t413 - k3 * t416;
        let t443 = v1_3_y * t419 + (t232 * t416 - t235 * t403);
        let t444 = z1_4_z * t429 + (z1_4_y * t433 - z1_4_x * t432) + t443;
        let t454 = t228 * t416 + t229 * t403 - v2_4_z * t419;
        let t455 = c3 * t429 + (t226 * t432 + z2_4_y * t433) + t454;
        let t458 = c4 * t433 - s4 * t432;
        put(2, t444); // row 1, MSY
        put(12, t455); // row 2, MSY
        put(22, t458); // row 3, MSY
        put(32, t429); // row 4, MSY
        put(42, t413); // row 5, MSY
        put(52, t397); // row 6, MSY
        [t388, t391]
    };
    // payload: column MSZ
    {
        let t461 = c7 * t189 + s7 * t192;
        let t464 = s7 * t189 - c7 * t192;
        let t467 = t255 + k6 * t464;
        let t468 = t252 + k6 * t461;
        let t471 = c6 * t461 + s6 * t167;
        let t474 = c6 * t167 - s6 * t461;
        let t479 = c6 * t467 - k5 * t474;
        let t480 = s6 * t467 - k5 * t471;
        let t483 = s5 * t464 - c5 * t471;
        let t486 = s5 * t471 + c5 * t464;
        let t496 = c5 * t468 - s5 * t479 - k4 * t483;
        let t499 = k3 * t474 - (c5 * t479 + s5 * t468 + k4 * t486);
        let t500 = t480 + k3 * t483;
        let t510 = t232 * t483 + t235 * t474 - v1_3_y * t486;
        let t511 = z1_4_z * t496 + (z1_4_y * t500 - z1_4_x * t499) - t510;
        let t521 = t229 * t474 - t228 * t483 - v2_4_z * t486;
        let t522 = c3 * t496 + (t226 * t499 + z2_4_y * t500) + t521;
        let t525 = c4 * t500 - s4 * t499;
        put(3, t511); // row 1, MSZ
        put(13, t522); // row 2, MSZ
        put(23, t525); // row 3, MSZ
        put(33, t496); // row 4, MSZ
        put(43, t480); // row 5, MSZ
        put(53, t468); // row 6, MSZ
    }
    // payload: column XX
    let [t527, t530, t533, t536] = {
        let t527 = s7 * t198;
        let t528 = c7 * t200 + t527;
        let t530 = c7 * t198;
        let t531 = s7 * t200 - t530;
        let t533 = s6 * t197;
        let t534 = c6 * t528 + t533;
        let t536 = c6 * t197;
        let t537 = t536 - s6 * t528;
        let t542 = z1_4_y * t537 + (t238 * t534 + z1_6_z * t531);
        let t547 = z2_4_y * t537 + (t244 * t534 + t247 * t531);
        let t552 = c4 * t537 - (z3_5_x * t534 - z3_6_z * t531);
        let t555 = s5 * t534 + c5 * t531;
        put(4, t542); // row 1, XX
        put(14, t547); // row 2, XX
        put(24, t552); // row 3, XX
        put(34, t555); // row 4, XX
        put(44, t537); // row 5, XX
        put(54, t531); // row 6, XX
        [t527, t530, t533, t536]
    };
    // payload: column YY
    let [t556, t559] = {
        let t556 = c7 * t199;
        let t558 = t556 + s7 * t201;
        let t559 = s7 * t199;
        let t561 = c7 * t201 - t559;
        let t563 = t533 + c6 * t558;
        let t565 = s6 * t558 - t536;
        let t570 = z1_4_y * t565 - (t238 * t563 - z1_6_z * t561);
        let t575 = z2_4_y * t565 + (t247 * t561 - t244 * t563);
        let t580 = c4 * t565 + (z3_5_x * t563 + z3_6_z * t561);
        let t583 = c5 * t561 - s5 * t563;
        put(5, t570); // row 1, YY
        put(15, t575); // row 2, YY
        put(25, t580); // row 3, YY
        put(35, t583); // row 4, YY
        put(45, t565); // row 5, YY
        put(55, t561); // row 6, YY
        [t556, t559]
    };
    // payload: column ZZ
    let t610 = {
        let t584 = t556 - t527;
        let t585 = t530 + t559;
        let t588 = c6 * t584 + s6 * dw7_z;
        let t591 = c6 * dw7_z - s6 * t584;
        let t596 = z1_4_y * t591 + (t238 * t588 + z1_6_z * t585);
        let t601 = z2_4_y * t591 + (t244 * t588 + t247 * t585);
        let t606 = c4 * t591 + (z3_6_z * t585 - z3_5_x * t588);
        let t609 = s5 * t588 + c5 * t585;
        let t610 = t206 - t203;
        put(6, t596); // row 1, ZZ
        put(16, t601); // row 2, ZZ
        put(26, t606); // row 3, ZZ
        put(36, t609); // row 4, ZZ
        put(46, t591); // row 5, ZZ
        put(56, t585); // row 6, ZZ
        put(65, t610); // row 7, XY
        t610
    };
    // payload: column XY
    {
        let t613 = c7 * t207 - s7 * t208;
        let t616 = s7 * t207 + c7 * t208;
        let t619 = c6 * t613 + s6 * t610;
        let t622 = c6 * t610 - s6 * t613;
        let t627 = z1_4_y * t622 + (t238 * t619 + z1_6_z * t616);
        let t632 = z2_4_y * t622 + (t244 * t619 + t247 * t616);
        let t637 = c4 * t622 + (z3_6_z * t616 - z3_5_x * t619);
        let t640 = s5 * t619 + c5 * t616;
        put(7, t627); // row 1, XY
        put(17, t632); // row 2, XY
        put(27, t637); // row 3, XY
        put(37, t640); // row 4, XY
        put(47, t622); // row 5, XY
        put(57, t616); // row 6, XY
    }
    // payload: column XZ
    let t669 = {
        let t642 = t319 + s7 * t202;
        let t644 = t316 - c7 * t202;
        let t647 = c6 * t642 + s6 * t192;
        let t650 = c6 * t192 - s6 * t642;
        let t655 = z1_4_y * t650 + (t238 * t647 + z1_6_z * t644);
        let t660 = z2_4_y * t650 + (t244 * t647 + t247 * t644);
        let t665 = c4 * t650 - (z3_5_x * t647 - z3_6_z * t644);
        let t668 = s5 * t647 + c5 * t644;
        let t669 = t206 - t167;
        put(8, t655); // row 1, XZ
        put(18, t660); // row 2, XZ
        put(28, t665); // row 3, XZ
        put(38, t668); // row 4, XZ
        put(48, t650); // row 5, XZ
        put(58, t644); // row 6, XZ
        t669
    };
    // payload: column YZ
    {
        let t671 = t391 + c7 * t669;
        let t673 = s7 * t669 - t388;
        let t676 = c6 * t671 + s6 * t189;
        let t679 = c6 * t189 - s6 * t671;
        let t684 = z1_4_y * t679 + (t238 * t676 + z1_6_z * t673);
        let t689 = z2_4_y * t679 + (t244 * t676 + t247 * t673);
        let t694 = c4 * t679 - (z3_5_x * t676 - z3_6_z * t673);
        let t697 = s5 * t676 + c5 * t673;
        let t698 = -t257;
        let t699 = -t197;
        put(9, t684); // row 1, YZ
        put(19, t689); // row 2, YZ
        put(29, t694); // row 3, YZ
        put(39, t697); // row 4, YZ
        put(49, t679); // row 5, YZ
        put(50, t698); // row 6, M
        put(59, t673); // row 6, YZ
        put(63, t699); // row 7, YY
    }
}
