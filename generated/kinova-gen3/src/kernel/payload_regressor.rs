//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its
//! origin. Katsumata et al. 2019, (7).
//!
//! 419 multiplications, 281 additions; 7 x 10, 68 of 70 structurally nonzero.

use super::super::runtime::{Scalar, apart};
use super::super::{DOF, GRAVITY, Trig};

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
    // joint axes in frame 2
    let [t169, v1_2_y] = {
        let t169 = c2 * k1;
        let v1_2_y = s2 * k1;
        [t169, v1_2_y]
    };
    // joint axes in frame 3
    let [t174, v1_3_y, v2_3_x, v2_4_z] = {
        let t171 = s2 * k2;
        let t174 = c3 * t169 - s3 * t171;
        let v1_3_y = c3 * t171 + s3 * t169;
        let v2_3_x = c3 * k2;
        let v2_4_z = s3 * k2;
        [t174, v1_3_y, v2_3_x, v2_4_z]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, t186, z2_4_y, t188, t189, t192, t195] = {
        let z1_4_x = c4 * z1_3_x + c2 * s4;
        let z1_4_y = c2 * c4 - s4 * z1_3_x;
        let t186 = s3 * c4;
        let z2_4_y = s3 * s4;
        let t188 = c4 * v2_3_x;
        let t189 = s4 * v2_3_x;
        let t192 = s4 * v1_2_y - c4 * t174;
        let t195 = c4 * v1_2_y + s4 * t174;
        [z1_4_x, z1_4_y, t186, z2_4_y, t188, t189, t192, t195]
    };
    // joint axes in frame 5
    let [t198, z1_6_z, t204, t207, z3_5_x, z3_6_z] = {
        let t198 = s5 * z1_4_z - c5 * z1_4_x;
        let z1_6_z = c5 * z1_4_z + s5 * z1_4_x;
        let t204 = c5 * t186 + c3 * s5;
        let t207 = c3 * c5 - s5 * t186;
        let z3_5_x = s4 * c5;
        let z3_6_z = s4 * s5;
        [t198, z1_6_z, t204, t207, z3_5_x, z3_6_z]
    };
    // link 7: motion
    let [
        a7_z, t218, a7_y, t230, t233, dw7_z, t238, t239,
        t240, t241, t242, t243, t244, t245, t246, t247,
        t248, t249,
    ] = {
        let t213 = t141 + t166 * k6;
        let a7_z = a6_y + t167 * k6;
        let t215 = t137 + t168 * k6;
        let t218 = c7 * t213 - s7 * t215;
        let a7_y = c7 * t215 + s7 * t213;
        let t224 = c7 * t147 + s7 * w6_z;
        let t227 = s7 * t147 - c7 * w6_z;
        let t230 = c7 * t166 - s7 * t168;
        let t233 = c7 * t168 + s7 * t166;
        let t234 = t150 - dq7;
        let dw7_z = dw6_y + ddq7;
        let t236 = t224 * t224;
        let t237 = t234 * t234;
        let t238 = t224 * t227;
        let t239 = t224 * t234;
        let t240 = t227 * t234;
        let t241 = t240 - t233;
        let t242 = t239 - t230;
        let t243 = t237 - t236;
        let t244 = t167 + t243;
        let t245 = dw7_z + t238;
        let t246 = t238 - dw7_z;
        let t247 = t236 + t237;
        let t248 = t239 + t242;
        let t249 = t240 + t241;
        let t250 = -t238;
        put(60, a7_y); // row 7, MSX
        put(61, t218); // row 7, MSY
        put(62, t238); // row 7, XX
        put(63, t250); // row 7, YY
        put(64, dw7_z); // row 7, ZZ
        put(66, t233); // row 7, XZ
        put(67, t230); // row 7, YZ
        [
        a7_z, t218, a7_y, t230, t233, dw7_z, t238, t239,
        t240, t241, t242, t243, t244, t245, t246, t247,
        t248, t249,
    ]
    };
    // payload: column M
    let [t253, t256] = {
        let t253 = c7 * t218 + s7 * a7_y;
        let t256 = s7 * t218 - c7 * a7_y;
        let t257 = k6 * t256;
        let t258 = k6 * t253;
        let t261 = c6 * t253 + s6 * a7_z;
        let t264 = c6 * a7_z - s6 * t253;
        let t269 = k5 * t264 - c6 * t257;
        let t270 = k5 * t261 - s6 * t257;
        let t273 = s5 * t256 - c5 * t261;
        let t276 = s5 * t261 + c5 * t256;
        let t286 = k4 * t273 - (s5 * t269 + c5 * t258);
        let t289 = s5 * t258 - c5 * t269 + k4 * t276 - k3 * t264;
        let t290 = t270 - k3 * t273;
        let t300 = t192 * t273 + t195 * t264 - v1_3_y * t276;
        let t301 = z1_4_z * t286 + (z1_4_y * t290 - z1_4_x * t289) + t300;
        let t311 = v2_4_z * t276 - (t189 * t264 - t188 * t273);
        let t312 = c3 * t286 + (t186 * t289 + z2_4_y * t290) + t311;
        let t315 = c4 * t290 - s4 * t289;
        let t316 = -t258;
        put(0, t301); // row 1, M
        put(10, t312); // row 2, M
        put(20, t315); // row 3, M
        put(30, t286); // row 4, M
        put(40, t270); // row 5, M
        put(50, t316); // row 6, M
        [t253, t256]
    };
    // payload: column MSX
    let [t318, t321, t323, t324] = {
        let t318 = s7 * t246;
        let t319 = c7 * t244 - t318;
        let t321 = c7 * t246;
        let t322 = s7 * t244 + t321;
        let t323 = s7 * a7_z;
        let t324 = c7 * a7_z;
        let t327 = k6 * t322 - t323;
        let t328 = t324 - k6 * t319;
        let t331 = c6 * t319 + s6 * t248;
        let t334 = c6 * t248 - s6 * t319;
        let t343 = k5 * t334 - (c6 * t327 + s6 * a7_y);
        let t344 = c6 * a7_y - s6 * t327 + k5 * t331;
        let t347 = s5 * t322 - c5 * t331;
        let t350 = s5 * t331 + c5 * t322;
        let t360 = c5 * t328 - s5 * t343 + k4 * t347;
        let t363 = c5 * t343 + s5 * t328 - k4 * t350 + k3 * t334;
        let t364 = t344 - k3 * t347;
        let t374 = t192 * t347 + t195 * t334 - v1_3_y * t350;
        let t375 = z1_4_z * t360 + (z1_4_x * t363 + z1_4_y * t364) + t374;
        let t385 = v2_4_z * t350 + (t188 * t347 - t189 * t334);
        let t386 = c3 * t360 - (t186 * t363 - z2_4_y * t364) + t385;
        let t389 = s4 * t363 + c4 * t364;
        put(1, t375); // row 1, MSX
        put(11, t386); // row 2, MSX
        put(21, t389); // row 3, MSX
        put(31, t360); // row 4, MSX
        put(41, t344); // row 5, MSX
        put(51, t328); // row 6, MSX
        [t318, t321, t323, t324]
    };
    // payload: column MSY
    let [t390, t393] = {
        let t390 = c7 * t245;
        let t392 = s7 * t247 - t390;
        let t393 = s7 * t245;
        let t395 = t393 + c7 * t247;
        let t398 = k6 * t395 - t324;
        let t399 = k6 * t392 - t323;
        let t402 = c6 * t392 + s6 * t249;
        let t405 = c6 * t249 - s6 * t392;
        let t414 = c6 * t398 + s6 * t218 + k5 * t405;
        let t415 = c6 * t218 - s6 * t398 - k5 * t402;
        let t418 = c5 * t402 + s5 * t395;
        let t421 = s5 * t402 - c5 * t395;
        let t431 = s5 * t414 + c5 * t399 + k4 * t418;
        let t434 = c5 * t414 - s5 * t399 - k4 * t421 + k3 * t405;
        let t435 = t415 - k3 * t418;
        let t445 = v1_3_y * t421 + (t192 * t418 - t195 * t405);
        let t446 = z1_4_z * t431 + (z1_4_y * t435 - z1_4_x * t434) + t445;
        let t456 = t188 * t418 + t189 * t405 - v2_4_z * t421;
        let t457 = c3 * t431 + (t186 * t434 + z2_4_y * t435) + t456;
        let t460 = c4 * t435 - s4 * t434;
        put(2, t446); // row 1, MSY
        put(12, t457); // row 2, MSY
        put(22, t460); // row 3, MSY
        put(32, t431); // row 4, MSY
        put(42, t415); // row 5, MSY
        put(52, t399); // row 6, MSY
        [t390, t393]
    };
    // payload: column MSZ
    {
        let t463 = c7 * t230 + s7 * t233;
        let t466 = s7 * t230 - c7 * t233;
        let t469 = t256 + k6 * t466;
        let t470 = t253 + k6 * t463;
        let t473 = c6 * t463 + s6 * t167;
        let t476 = c6 * t167 - s6 * t463;
        let t481 = c6 * t469 - k5 * t476;
        let t482 = s6 * t469 - k5 * t473;
        let t485 = s5 * t466 - c5 * t473;
        let t488 = s5 * t473 + c5 * t466;
        let t498 = c5 * t470 - s5 * t481 - k4 * t485;
        let t501 = k3 * t476 - (c5 * t481 + s5 * t470 + k4 * t488);
        let t502 = t482 + k3 * t485;
        let t512 = t192 * t485 + t195 * t476 - v1_3_y * t488;
        let t513 = z1_4_z * t498 + (z1_4_y * t502 - z1_4_x * t501) - t512;
        let t523 = t189 * t476 - t188 * t485 - v2_4_z * t488;
        let t524 = c3 * t498 + (t186 * t501 + z2_4_y * t502) + t523;
        let t527 = c4 * t502 - s4 * t501;
        put(3, t513); // row 1, MSZ
        put(13, t524); // row 2, MSZ
        put(23, t527); // row 3, MSZ
        put(33, t498); // row 4, MSZ
        put(43, t482); // row 5, MSZ
        put(53, t470); // row 6, MSZ
    }
    // payload: column XX
    let [t529, t532, t535, t538] = {
        let t529 = s7 * t239;
        let t530 = c7 * t241 + t529;
        let t532 = c7 * t239;
        let t533 = s7 * t241 - t532;
        let t535 = s6 * t238;
        let t536 = c6 * t530 + t535;
        let t538 = c6 * t238;
        let t539 = t538 - s6 * t530;
        let t544 = z1_4_y * t539 + (t198 * t536 + z1_6_z * t533);
        let t549 = z2_4_y * t539 + (t204 * t536 + t207 * t533);
        let t554 = c4 * t539 - (z3_5_x * t536 - z3_6_z * t533);
        let t557 = s5 * t536 + c5 * t533;
        put(4, t544); // row 1, XX
        put(14, t549); // row 2, XX
        put(24, t554); // row 3, XX
        put(34, t557); // row 4, XX
        put(44, t539); // row 5, XX
        put(54, t533); // row 6, XX
        [t529, t532, t535, t538]
    };
    // payload: column YY
    let [t558, t561] = {
        let t558 = c7 * t240;
        let t560 = t558 + s7 * t242;
        let t561 = s7 * t240;
        let t563 = c7 * t242 - t561;
        let t565 = t535 + c6 * t560;
        let t567 = s6 * t560 - t538;
        let t572 = z1_4_y * t567 - (t198 * t565 - z1_6_z * t563);
        let t577 = z2_4_y * t567 + (t207 * t563 - t204 * t565);
        let t582 = c4 * t567 + (z3_5_x * t565 + z3_6_z * t563);
        let t585 = c5 * t563 - s5 * t565;
        put(5, t572); // row 1, YY
        put(15, t577); // row 2, YY
        put(25, t582); // row 3, YY
        put(35, t585); // row 4, YY
        put(45, t567); // row 5, YY
        put(55, t563); // row 6, YY
        [t558, t561]
    };
    // payload: column ZZ
    let t612 = {
        let t586 = t558 - t529;
        let t587 = t532 + t561;
        let t590 = c6 * t586 + s6 * dw7_z;
        let t593 = c6 * dw7_z - s6 * t586;
        let t598 = z1_4_y * t593 + (t198 * t590 + z1_6_z * t587);
        let t603 = z2_4_y * t593 + (t204 * t590 + t207 * t587);
        let t608 = c4 * t593 + (z3_6_z * t587 - z3_5_x * t590);
        let t611 = s5 * t590 + c5 * t587;
        let t612 = t247 - t244;
        put(6, t598); // row 1, ZZ
        put(16, t603); // row 2, ZZ
        put(26, t608); // row 3, ZZ
        put(36, t611); // row 4, ZZ
        put(46, t593); // row 5, ZZ
        put(56, t587); // row 6, ZZ
        put(65, t612); // row 7, XY
        t612
    };
    // payload: column XY
    {
        let t615 = c7 * t248 - s7 * t249;
        let t618 = s7 * t248 + c7 * t249;
        let t621 = c6 * t615 + s6 * t612;
        let t624 = c6 * t612 - s6 * t615;
        let t629 = z1_4_y * t624 + (t198 * t621 + z1_6_z * t618);
        let t634 = z2_4_y * t624 + (t204 * t621 + t207 * t618);
        let t639 = c4 * t624 + (z3_6_z * t618 - z3_5_x * t621);
        let t642 = s5 * t621 + c5 * t618;
        put(7, t629); // row 1, XY
        put(17, t634); // row 2, XY
        put(27, t639); // row 3, XY
        put(37, t642); // row 4, XY
        put(47, t624); // row 5, XY
        put(57, t618); // row 6, XY
    }
    // payload: column XZ
    let t671 = {
        let t644 = t321 + s7 * t243;
        let t646 = t318 - c7 * t243;
        let t649 = c6 * t644 + s6 * t233;
        let t652 = c6 * t233 - s6 * t644;
        let t657 = z1_4_y * t652 + (t198 * t649 + z1_6_z * t646);
        let t662 = z2_4_y * t652 + (t204 * t649 + t207 * t646);
        let t667 = c4 * t652 - (z3_5_x * t649 - z3_6_z * t646);
        let t670 = s5 * t649 + c5 * t646;
        let t671 = t247 - t167;
        put(8, t657); // row 1, XZ
        put(18, t662); // row 2, XZ
        put(28, t667); // row 3, XZ
        put(38, t670); // row 4, XZ
        put(48, t652); // row 5, XZ
        put(58, t646); // row 6, XZ
        t671
    };
    // payload: column YZ
    {
        let t673 = t393 + c7 * t671;
        let t675 = s7 * t671 - t390;
        let t678 = c6 * t673 + s6 * t230;
        let t681 = c6 * t230 - s6 * t673;
        let t686 = z1_4_y * t681 + (t198 * t678 + z1_6_z * t675);
        let t691 = z2_4_y * t681 + (t204 * t678 + t207 * t675);
        let t696 = c4 * t681 - (z3_5_x * t678 - z3_6_z * t675);
        let t699 = s5 * t678 + c5 * t675;
        put(9, t686); // row 1, YZ
        put(19, t691); // row 2, YZ
        put(29, t696); // row 3, YZ
        put(39, t699); // row 4, YZ
        put(49, t681); // row 5, YZ
        put(59, t675); // row 6, YZ
    }
}
