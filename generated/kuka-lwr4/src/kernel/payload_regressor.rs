//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its
//! origin. Katsumata et al. 2019, (7).
//!
//! 350 multiplications, 225 additions; 7 x 10, 66 of 70 structurally nonzero.

use super::super::runtime::{Scalar, apart};
use super::super::{DOF, GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 66;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9),
    (1, 0), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7), (1, 8), (1, 9),
    (2, 0), (2, 1), (2, 2), (2, 3), (2, 4), (2, 5), (2, 6), (2, 7), (2, 8), (2, 9),
    (3, 0), (3, 1), (3, 2), (3, 3), (3, 4), (3, 5), (3, 6), (3, 7), (3, 8), (3, 9),
    (4, 1), (4, 2), (4, 3), (4, 4), (4, 5), (4, 6), (4, 7), (4, 8), (4, 9), (5, 1),
    (5, 2), (5, 3), (5, 4), (5, 5), (5, 6), (5, 7), (5, 8), (5, 9), (6, 1), (6, 2),
    (6, 4), (6, 5), (6, 6), (6, 7), (6, 8), (6, 9),
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
            39 => flat[40] = S::default(),
            48 => flat[50] = S::default(),
            57 => flat[60] = S::default(),
            59 => flat[63] = S::default(),
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
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
    // link 2: motion
    let [a2_x, a2_y, w2_x, w2_y, t12, t13, t14, t15] = {
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t10 = dq2 * w2_y;
        let dw2_x = s2 * ddq1 + t10;
        let t12 = dq2 * w2_x - c2 * ddq1;
        let t13 = w2_x * w2_y - ddq2;
        let t14 = w2_x * w2_x + dq2 * dq2;
        let t15 = t10 + dw2_x;
        [a2_x, a2_y, w2_x, w2_y, t12, t13, t14, t15]
    };
    // link 3: motion
    let [
        z1_3_x, t17, t22, t25, t28, t31, t34, w3_z,
        dw3_y, t48, t49,
    ] = {
        let z1_3_x = s2 * c3;
        let t17 = s2 * s3;
        let t20 = k_L2 * t15;
        let t21 = a2_x + k_L2 * t13;
        let t22 = k_L2 * t14 - a2_y;
        let t25 = s3 * t20 - c3 * t21;
        let t28 = c3 * t20 + s3 * t21;
        let t31 = s3 * dq2 - c3 * w2_x;
        let t34 = c3 * dq2 + s3 * w2_x;
        let w3_z = w2_y + dq3;
        let t45 = t34 * w3_z;
        let dw3_x = c3 * t15 + s3 * t13 - t45;
        let dw3_y = c3 * t13 - s3 * t15 + t31 * w3_z;
        let t48 = t12 - ddq3 + t31 * t34;
        let t49 = t45 - dw3_x;
        [
        z1_3_x, t17, t22, t25, t28, t31, t34, w3_z,
        dw3_y, t48, t49,
    ]
    };
    // link 4: motion
    let [
        t52, t55, t58, t61, t68, t76, t77, t78,
        t79,
    ] = {
        let t52 = c4 * t25 - s4 * t22;
        let t55 = c4 * t22 + s4 * t25;
        let t58 = c4 * t31 + s4 * w3_z;
        let t61 = c4 * w3_z - s4 * t31;
        let t68 = t34 - dq4;
        let dw4_z = dw3_y + ddq4;
        let t74 = t61 * t68;
        let t76 = c4 * t48 + s4 * t49 - t58 * t68;
        let t77 = t58 * t61 - dw4_z;
        let t78 = t58 * t58 + t68 * t68;
        let t79 = c4 * t49 - s4 * t48 - t74 - t74;
        [
        t52, t55, t58, t61, t68, t76, t77, t78,
        t79,
    ]
    };
    // link 5: motion
    let [
        t84, t88, a5_y, t94, t97, w5_z, dw5_y, t111,
        t112,
    ] = {
        let t83 = t52 + k_L3 * t77;
        let t84 = t55 + k_L3 * t78;
        let t85 = k_L3 * t79 - t28;
        let t88 = c5 * t83 - s5 * t85;
        let a5_y = c5 * t85 + s5 * t83;
        let t94 = c5 * t58 + s5 * t68;
        let t97 = c5 * t68 - s5 * t58;
        let w5_z = t61 + dq5;
        let dw5_z = ddq5 - t76;
        let t108 = t97 * w5_z;
        let dw5_y = s5 * t79 - c5 * t77 + t94 * w5_z;
        let t111 = dw5_z - t94 * t97;
        let t112 = t108 + (c5 * t79 + s5 * t77 + t108);
        [
        t84, t88, a5_y, t94, t97, w5_z, dw5_y, t111,
        t112,
    ]
    };
    // link 6: motion
    let [
        t115, t118, w6_x, w6_y, w6_z, t139, t140, t141,
        t142,
    ] = {
        let t115 = c6 * t88 + s6 * t84;
        let t118 = c6 * t84 - s6 * t88;
        let w6_x = s6 * w5_z - c6 * t94;
        let w6_y = c6 * w5_z + s6 * t94;
        let w6_z = t97 + dq6;
        let dw6_z = ddq6 - dw5_y;
        let t137 = w6_y * w6_z;
        let dw6_x = s6 * t111 - c6 * t112 + t137;
        let t139 = c6 * t111 + s6 * t112 - w6_x * w6_z;
        let t140 = w6_x * w6_y - dw6_z;
        let t141 = w6_x * w6_x + w6_z * w6_z;
        let t142 = t137 + dw6_x;
        [
        t115, t118, w6_x, w6_y, w6_z, t139, t140, t141,
        t142,
    ]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_5_z, t149, z2_4_y] = {
        let z1_4_x = c4 * z1_3_x - c2 * s4;
        let z1_5_z = c2 * c4 + s4 * z1_3_x;
        let t149 = s3 * c4;
        let z2_4_y = s3 * s4;
        [z1_4_x, z1_5_z, t149, z2_4_y]
    };
    // joint axes in frame 5
    let [z1_5_x, z1_6_z, t159, t162, t163, z3_5_y] = {
        let z1_5_x = c5 * z1_4_x - s5 * t17;
        let z1_6_z = c5 * t17 + s5 * z1_4_x;
        let t159 = c5 * t149 + c3 * s5;
        let t162 = c3 * c5 - s5 * t149;
        let t163 = s4 * c5;
        let z3_5_y = s4 * s5;
        [z1_5_x, z1_6_z, t159, t162, t163, z3_5_y]
    };
    // link 7: motion
    let [
        t167, a7_y, t179, t182, dw7_z, t187, t188, t189,
        dw7_x, t191, t192, t193, t194, t195, t196, t197,
        t198,
    ] = {
        let t167 = c7 * t115 - s7 * a5_y;
        let a7_y = c7 * a5_y + s7 * t115;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t176 = c7 * w6_z + s7 * w6_x;
        let t179 = c7 * t140 - s7 * t142;
        let t182 = c7 * t142 + s7 * t140;
        let w7_z = w6_y + dq7;
        let dw7_z = t139 + ddq7;
        let t185 = w7_x * w7_x;
        let t186 = w7_z * w7_z;
        let t187 = w7_x * t176;
        let t188 = w7_x * w7_z;
        let t189 = t176 * w7_z;
        let dw7_x = t182 - t189;
        let t191 = t188 - t179;
        let t192 = t185 - t186;
        let t193 = t192 - t141;
        let t194 = dw7_z + t187;
        let t195 = t187 - dw7_z;
        let t196 = t185 + t186;
        let t197 = t188 + t191;
        let t198 = t189 - dw7_x;
        let t199 = -t187;
        put(58, a7_y); // row 7, MSX
        put(59, t167); // row 7, MSY
        put(60, t187); // row 7, XX
        put(61, t199); // row 7, YY
        put(62, dw7_z); // row 7, ZZ
        put(64, t182); // row 7, XZ
        put(65, t179); // row 7, YZ
        [
        t167, a7_y, t179, t182, dw7_z, t187, t188, t189,
        dw7_x, t191, t192, t193, t194, t195, t196, t197,
        t198,
    ]
    };
    // payload: column M
    let [t202, t205] = {
        let t202 = c7 * t167 + s7 * a7_y;
        let t205 = s7 * t167 - c7 * a7_y;
        let t208 = s6 * t118 - c6 * t202;
        let t214 = c5 * t208 + s5 * t205;
        let t217 = s5 * t208 - c5 * t205;
        let t218 = k_L3 * t217;
        let t219 = k_L3 * t214;
        let t224 = s4 * t218;
        let t227 = c4 * t218 + k_L2 * t217;
        let t228 = t219 + k_L2 * (c4 * t214 - s4 * (s6 * t202 + c6 * t118));
        let t233 = c2 * t224 - (z1_3_x * t227 + t17 * t228);
        let t236 = s3 * t227 - c3 * t228;
        put(0, t233); // row 1, M
        put(10, t236); // row 2, M
        put(20, t224); // row 3, M
        put(30, t219); // row 4, M
        put(51, t202); // row 6, MSZ
        [t202, t205]
    };
    // payload: column MSX
    let [t238, t241, t243, t244] = {
        let t238 = s7 * t195;
        let t239 = c7 * t193 + t238;
        let t241 = c7 * t195;
        let t242 = t241 - s7 * t193;
        let t243 = s7 * t118;
        let t244 = c7 * t118;
        let t247 = c6 * t239 - s6 * t197;
        let t253 = c6 * t243 + s6 * a7_y;
        let t256 = c6 * a7_y - s6 * t243;
        let t259 = c5 * t247 + s5 * t242;
        let t262 = s5 * t247 - c5 * t242;
        let t271 = c5 * t253 + s5 * t244 + k_L3 * t262;
        let t272 = k_L3 * t259 - (s5 * t253 - c5 * t244);
        let t281 = s4 * t271 + c4 * t256;
        let t284 = c4 * t271 - s4 * t256 + k_L2 * t262;
        let t285 = t272 + k_L2 * (c4 * t259 + s4 * (s6 * t239 + c6 * t197));
        let t290 = c2 * t281 - (z1_3_x * t284 + t17 * t285);
        let t293 = s3 * t284 - c3 * t285;
        let t294 = -t244;
        put(1, t290); // row 1, MSX
        put(11, t293); // row 2, MSX
        put(21, t281); // row 3, MSX
        put(31, t272); // row 4, MSX
        put(40, t256); // row 5, MSX
        put(49, t294); // row 6, MSX
        put(50, t243); // row 6, MSY
        [t238, t241, t243, t244]
    };
    // payload: column MSY
    let [t295, t298] = {
        let t295 = c7 * t194;
        let t297 = s7 * t196 - t295;
        let t298 = s7 * t194;
        let t300 = t298 + c7 * t196;
        let t303 = c6 * t297 + s6 * t198;
        let t309 = c6 * t244 + s6 * t167;
        let t312 = c6 * t167 - s6 * t244;
        let t315 = c5 * t303 + s5 * t300;
        let t318 = s5 * t303 - c5 * t300;
        let t327 = c5 * t309 - s5 * t243 + k_L3 * t318;
        let t328 = k_L3 * t315 - (s5 * t309 + c5 * t243);
        let t337 = s4 * t327 + c4 * t312;
        let t340 = c4 * t327 - s4 * t312 + k_L2 * t318;
        let t341 = k_L2 * (s4 * (c6 * t198 - s6 * t297) - c4 * t315) - t328;
        let t346 = c2 * t337 + (t17 * t341 - z1_3_x * t340);
        let t349 = s3 * t340 + c3 * t341;
        put(2, t346); // row 1, MSY
        put(12, t349); // row 2, MSY
        put(22, t337); // row 3, MSY
        put(32, t328); // row 4, MSY
        put(41, t312); // row 5, MSY
        [t295, t298]
    };
    // payload: column MSZ
    {
        let t352 = c7 * t179 + s7 * t182;
        let t355 = s7 * t179 - c7 * t182;
        let t358 = c6 * t352 + s6 * t141;
        let t362 = c6 * t205;
        let t363 = s6 * t205;
        let t366 = c5 * t358 - s5 * t355;
        let t369 = s5 * t358 + c5 * t355;
        let t378 = k_L3 * t369 - (c5 * t362 + s5 * t202);
        let t379 = k_L3 * t366 - (c5 * t202 - s5 * t362);
        let t388 = s4 * t378 + c4 * t363;
        let t391 = c4 * t378 - s4 * t363 + k_L2 * t369;
        let t392 = t379 + k_L2 * (c4 * t366 - s4 * (c6 * t141 - s6 * t352));
        let t397 = c2 * t388 - (z1_3_x * t391 + t17 * t392);
        let t400 = s3 * t391 - c3 * t392;
        put(3, t397); // row 1, MSZ
        put(13, t400); // row 2, MSZ
        put(23, t388); // row 3, MSZ
        put(33, t379); // row 4, MSZ
        put(42, t363); // row 5, MSZ
    }
    // payload: column XX
    let [t402, t405, t408, t411] = {
        let t402 = s7 * t188;
        let t403 = c7 * dw7_x - t402;
        let t405 = c7 * t188;
        let t406 = s7 * dw7_x + t405;
        let t408 = s6 * t187;
        let t409 = t408 - c6 * t403;
        let t411 = c6 * t187;
        let t412 = s6 * t403 + t411;
        let t417 = z1_5_z * t412 - (z1_5_x * t409 + z1_6_z * t406);
        let t422 = t159 * t409 - t162 * t406 - z2_4_y * t412;
        let t427 = c4 * t412 + (t163 * t409 + z3_5_y * t406);
        let t430 = c5 * t406 - s5 * t409;
        let t431 = -t406;
        put(4, t417); // row 1, XX
        put(14, t422); // row 2, XX
        put(24, t427); // row 3, XX
        put(34, t430); // row 4, XX
        put(43, t412); // row 5, XX
        put(52, t431); // row 6, XX
        [t402, t405, t408, t411]
    };
    // payload: column YY
    let [t432, t435] = {
        let t432 = c7 * t189;
        let t434 = t432 + s7 * t191;
        let t435 = s7 * t189;
        let t437 = c7 * t191 - t435;
        let t439 = t408 + c6 * t434;
        let t441 = s6 * t434 - t411;
        let t446 = z1_5_z * t441 + (z1_5_x * t439 + z1_6_z * t437);
        let t451 = t162 * t437 - t159 * t439 - z2_4_y * t441;
        let t456 = c4 * t441 - (t163 * t439 + z3_5_y * t437);
        let t459 = s5 * t439 - c5 * t437;
        put(5, t446); // row 1, YY
        put(15, t451); // row 2, YY
        put(25, t456); // row 3, YY
        put(35, t459); // row 4, YY
        put(44, t441); // row 5, YY
        put(53, t437); // row 6, YY
        [t432, t435]
    };
    // payload: column ZZ
    let t486 = {
        let t460 = t402 - t432;
        let t461 = t405 + t435;
        let t464 = c6 * t460 - s6 * dw7_z;
        let t467 = s6 * t460 + c6 * dw7_z;
        let t472 = z1_5_z * t467 + (z1_5_x * t464 + z1_6_z * t461);
        let t477 = t162 * t461 - t159 * t464 - z2_4_y * t467;
        let t482 = c4 * t467 - (t163 * t464 + z3_5_y * t461);
        let t485 = s5 * t464 - c5 * t461;
        let t486 = t193 + t196;
        put(6, t472); // row 1, ZZ
        put(16, t477); // row 2, ZZ
        put(26, t482); // row 3, ZZ
        put(36, t485); // row 4, ZZ
        put(45, t467); // row 5, ZZ
        put(54, t461); // row 6, ZZ
        put(63, t486); // row 7, XY
        t486
    };
    // payload: column XY
    {
        let t489 = s7 * t198 - c7 * t197;
        let t492 = s7 * t197 + c7 * t198;
        let t495 = c6 * t489 - s6 * t486;
        let t498 = s6 * t489 + c6 * t486;
        let t503 = z1_5_z * t498 + (z1_5_x * t495 + z1_6_z * t492);
        let t508 = t162 * t492 - t159 * t495 - z2_4_y * t498;
        let t513 = c4 * t498 - (t163 * t495 + z3_5_y * t492);
        let t516 = s5 * t495 - c5 * t492;
        put(7, t503); // row 1, XY
        put(17, t508); // row 2, XY
        put(27, t513); // row 3, XY
        put(37, t516); // row 4, XY
        put(46, t498); // row 5, XY
        put(55, t492); // row 6, XY
    }
    // payload: column XZ
    let t545 = {
        let t518 = s7 * t192 - t241;
        let t520 = t238 + c7 * t192;
        let t523 = c6 * t518 - s6 * t182;
        let t526 = s6 * t518 + c6 * t182;
        let t531 = z1_5_z * t526 + (z1_5_x * t523 + z1_6_z * t520);
        let t536 = t162 * t520 - t159 * t523 - z2_4_y * t526;
        let t541 = c4 * t526 - (t163 * t523 + z3_5_y * t520);
        let t544 = s5 * t523 - c5 * t520;
        let t545 = t196 - t141;
        put(8, t531); // row 1, XZ
        put(18, t536); // row 2, XZ
        put(28, t541); // row 3, XZ
        put(38, t544); // row 4, XZ
        put(47, t526); // row 5, XZ
        put(56, t520); // row 6, XZ
        t545
    };
    // payload: column YZ
    {
        let t547 = t298 + c7 * t545;
        let t549 = s7 * t545 - t295;
        let t552 = c6 * t547 + s6 * t179;
        let t555 = c6 * t179 - s6 * t547;
        let t560 = z1_5_z * t555 - (z1_5_x * t552 - z1_6_z * t549);
        let t565 = t159 * t552 + t162 * t549 - z2_4_y * t555;
        let t570 = c4 * t555 - (z3_5_y * t549 - t163 * t552);
        let t574 = -(s5 * t552 + c5 * t549);
        put(9, t560); // row 1, YZ
        put(19, t565); // row 2, YZ
        put(29, t570); // row 3, YZ
        put(39, t574); // row 4, YZ
        put(48, t555); // row 5, YZ
        put(57, t549); // row 6, YZ
    }
}
