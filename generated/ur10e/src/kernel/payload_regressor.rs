//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin (the paper's (7)).
//!
//! 261 multiplications, 184 additions; 6 x 10, 58 of 60 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 58;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9),
    (1, 0), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7), (1, 8), (1, 9),
    (2, 0), (2, 1), (2, 2), (2, 3), (2, 4), (2, 5), (2, 6), (2, 7), (2, 8), (2, 9),
    (3, 0), (3, 1), (3, 2), (3, 3), (3, 4), (3, 5), (3, 6), (3, 7), (3, 8), (3, 9),
    (4, 0), (4, 1), (4, 2), (4, 3), (4, 4), (4, 5), (4, 6), (4, 7), (4, 8), (4, 9),
    (5, 1), (5, 2), (5, 4), (5, 5), (5, 6), (5, 7), (5, 8), (5, 9),
];

/// Regressor of a body fixed to the tool frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 10]; 6]) {
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
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let A3 = S::constant(-0.57155);
    let D4 = S::constant(0.17415);
    let D5 = S::constant(0.11985);
    let D6 = S::constant(0.11655);
    let k0 = S::constant(9.81);
    let k1 = S::constant(0.6127);
    let k2 = S::constant(0.57155);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        w2_x, w2_y, t3, t4, a2_x, a2_y, t13, t14,
        t15,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t3 = s2 * ddq1;
        let t4 = c2 * ddq1;
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let t10 = dq2 * w2_x;
        let dw2_y = t4 - t10;
        let t13 = w2_x * w2_x - dq2 * dq2 - t0;
        let t14 = ddq2 + w2_x * w2_y;
        let t15 = dw2_y - t10;
        [
        w2_x, w2_y, t3, t4, a2_x, a2_y, t13, t14,
        t15,
    ]
    };
    // link 3: motion
    let [
        w3_x, w3_y, t24, a3_x, a3_y, t35, t38, w3_z,
        dw3_z, t47, t48, t49,
    ] = {
        let w3_x = c3 * w2_x + s3 * w2_y;
        let w3_y = c3 * w2_y - s3 * w2_x;
        let t24 = t15 * k1;
        let t25 = t13 * k1 - a2_x;
        let t26 = a2_y - t14 * k1;
        let a3_x = s3 * t26 - c3 * t25;
        let a3_y = c3 * t26 + s3 * t25;
        let t35 = c3 * t4 - s3 * t3;
        let t38 = c3 * t3 + s3 * t4;
        let w3_z = dq2 + dq3;
        let dw3_z = ddq2 + ddq3;
        let t44 = w3_x * w3_z;
        let t47 = t0 + (w3_z * w3_z - w3_x * w3_x);
        let t48 = dw3_z + w3_x * w3_y;
        let t49 = t44 + (t44 - t35);
        [
        w3_x, w3_y, t24, a3_x, a3_y, t35, t38, w3_z,
        dw3_z, t47, t48, t49,
    ]
    };
    // link 4: motion
    let [
        w4_x, t55, t67, t70, t73, w4_z, t88, t89,
        t90, t91,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_y;
        let t55 = s4 * w3_x - c4 * w3_y;
        let t65 = a3_x + (t47 * k2 + D4 * t35);
        let t66 = t48 * k2 + D4 * t38 - a3_y;
        let t67 = t49 * k2 + D4 * t0 - t24;
        let t70 = s4 * t66 - c4 * t65;
        let t73 = c4 * t66 + s4 * t65;
        let w4_z = w3_z + dq4;
        let dw4_z = dw3_z + ddq4;
        let t86 = t55 * w4_z;
        let dw4_x = c4 * t38 + s4 * t35 - t86;
        let t88 = w4_x * w4_z - (c4 * t35 - s4 * t38);
        let t89 = dw4_z + w4_x * t55;
        let t90 = w4_x * w4_x + w4_z * w4_z;
        let t91 = dw4_x - t86;
        [
        w4_x, t55, t67, t70, t73, w4_z, t88, t89,
        t90, t91,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t102, t106, t109, w5_z, t124, t125,
        t126, t127,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t101 = t70 - D5 * t89;
        let t102 = D5 * t90 - t73;
        let t103 = t67 + D5 * t91;
        let t106 = c5 * t101 + s5 * t103;
        let t109 = s5 * t101 - c5 * t103;
        let w5_z = t55 + dq5;
        let dw5_z = t88 + ddq5;
        let t122 = w5_y * w5_z;
        let dw5_x = c5 * t91 + s5 * t89 + t122;
        let t124 = w5_x * w5_z - (c5 * t89 - s5 * t91);
        let t125 = w5_x * w5_y - dw5_z;
        let t126 = w5_x * w5_x + w5_z * w5_z;
        let t127 = t122 + dw5_x;
        [
        w5_x, w5_y, t102, t106, t109, w5_z, t124, t125,
        t126, t127,
    ]
    };
    // link 6: motion
    let [
        t138, t142, a6_y, t148, t151, dw6_z, t156, t157,
        t158, t159, t160, t161, t162, t163, t164, t165,
        t166, t167,
    ] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t133 = c6 * w5_z + s6 * w5_x;
        let t137 = t106 - D6 * t125;
        let t138 = t109 - D6 * t126;
        let t139 = t102 - D6 * t127;
        let t142 = c6 * t137 - s6 * t139;
        let a6_y = c6 * t139 + s6 * t137;
        let t148 = c6 * t125 - s6 * t127;
        let t151 = c6 * t127 + s6 * t125;
        let w6_z = w5_y + dq6;
        let dw6_z = ddq6 - t124;
        let t154 = w6_x * w6_x;
        let t155 = w6_z * w6_z;
        let t156 = w6_x * t133;
        let t157 = w6_x * w6_z;
        let t158 = t133 * w6_z;
        let t159 = t158 - t151;
        let t160 = t157 - t148;
        let t161 = t154 - t155;
        let t162 = t126 - t161;
        let t163 = dw6_z + t156;
        let t164 = t156 - dw6_z;
        let t165 = t154 + t155;
        let t166 = t157 + t160;
        let t167 = t158 + t159;
        put(50, a6_y); // row 6, MSX
        put(51, t142); // row 6, MSY
        put(52, t156); // row 6, XX
        put(54, dw6_z); // row 6, ZZ
        put(56, t151); // row 6, XZ
        put(57, t148); // row 6, YZ
        [
        t138, t142, a6_y, t148, t151, dw6_z, t156, t157,
        t158, t159, t160, t161, t162, t163, t164, t165,
        t166, t167,
    ]
    };
    // joint axes in frame 3
    let [v1_3_z, z1_3_x, z1_3_y, t175, t176] = {
        let v1_3_z = c2 * k1;
        let z1_3_x = s2 * c3 + c2 * s3;
        let z1_3_y = c2 * c3 - s2 * s3;
        let t175 = s3 * k1;
        let t176 = c3 * k1;
        [v1_3_z, z1_3_x, z1_3_y, t175, t176]
    };
    // joint axes in frame 4
    let [
        v1_4_z, z1_4_x, t186, v1_4_x, v1_5_z, t196, t199, t200,
        v3_5_z,
    ] = {
        let t177 = D4 * z1_3_y;
        let t178 = D4 * z1_3_x;
        let v1_4_z = v1_3_z + k2 * z1_3_y;
        let z1_4_x = c4 * z1_3_x + s4 * z1_3_y;
        let t186 = s4 * z1_3_x - c4 * z1_3_y;
        let v1_4_x = c4 * t177 - s4 * t178;
        let v1_5_z = c4 * t178 + s4 * t177;
        let t193 = t176 - A3;
        let t196 = c4 * t175 + s4 * t193;
        let t199 = c4 * t193 - s4 * t175;
        let t200 = s4 * k2;
        let v3_5_z = c4 * k2;
        [
        v1_4_z, z1_4_x, t186, v1_4_x, v1_5_z, t196, t199, t200,
        v3_5_z,
    ]
    };
    // joint axes in frame 5
    let [z1_5_x, t203] = {
        let z1_5_x = c5 * z1_4_x;
        let t203 = s5 * z1_4_x;
        [z1_5_x, t203]
    };
    // payload: column M
    let [t206, t209] = {
        let t206 = c6 * t142 + s6 * a6_y;
        let t209 = s6 * t142 - c6 * a6_y;
        let t210 = D6 * t209;
        let t211 = D6 * t206;
        let t214 = c5 * t206 + s5 * t138;
        let t217 = c5 * t138 - s5 * t206;
        let t223 = s5 * t210 - D5 * t214;
        let t231 = v1_4_z * t217 + (v1_5_z * t209 - v1_4_x * t214);
        let t232 = z1_4_x * (c5 * t210 - D5 * t217) + t186 * t211 + t231;
        let t236 = t223 + (t196 * t214 + t199 * t209);
        let t240 = t223 + (t200 * t214 + v3_5_z * t209);
        put(0, t232); // row 1, M
        put(10, t236); // row 2, M
        put(20, t240); // row 3, M
        put(30, t223); // row 4, M
        put(40, t211); // row 5, M
        [t206, t209]
    };
    // payload: column MSX
    let [t242, t245, t247, t248] = {
        let t242 = s6 * t164;
        let t243 = t242 - c6 * t162;
        let t245 = c6 * t164;
        let t246 = s6 * t162 + t245;
        let t247 = s6 * t138;
        let t248 = c6 * t138;
        let t251 = t247 + D6 * t246;
        let t252 = t248 - D6 * t243;
        let t255 = c5 * t243 - s5 * t166;
        let t258 = s5 * t243 + c5 * t166;
        let t268 = s5 * t251 + c5 * a6_y + D5 * t255;
        let t271 = z1_4_x * (D5 * t258 - (c5 * t251 - s5 * a6_y)) - t186 * t252;
        let t277 = v1_4_z * t258 + (v1_4_x * t255 + v1_5_z * t246) - t271;
        let t281 = t268 + (t199 * t246 - t196 * t255);
        let t285 = t268 + (v3_5_z * t246 - t200 * t255);
        put(1, t277); // row 1, MSX
        put(11, t281); // row 2, MSX
        put(21, t285); // row 3, MSX
        put(31, t268); // row 4, MSX
        put(41, t252); // row 5, MSX
        [t242, t245, t247, t248]
    };
    // payload: column MSY
    let [t286, t289] = {
        let t286 = c6 * t163;
        let t288 = t286 - s6 * t165;
        let t289 = s6 * t163;
        let t291 = t289 + c6 * t165;
        let t294 = t248 + D6 * t291;
        let t295 = D6 * t288 - t247;
        let t298 = s5 * t167 - c5 * t288;
        let t301 = s5 * t288 + c5 * t167;
        let t311 = s5 * t294 + c5 * t142 + D5 * t298;
        let t314 = t186 * t295 - z1_4_x * (s5 * t142 - c5 * t294 - D5 * t301);
        let t320 = t314 + (v1_4_x * t298 + v1_5_z * t291 - v1_4_z * t301);
        let t324 = t311 + (t199 * t291 - t196 * t298);
        let t328 = t311 + (v3_5_z * t291 - t200 * t298);
        put(2, t320); // row 1, MSY
        put(12, t324); // row 2, MSY
        put(22, t328); // row 3, MSY
        put(32, t311); // row 4, MSY
        put(42, t295); // row 5, MSY
        [t286, t289]
    };
    // payload: column MSZ
    {
        let t331 = c6 * t148 + s6 * t151;
        let t334 = s6 * t148 - c6 * t151;
        let t337 = D6 * t334 - t209;
        let t338 = t206 - D6 * t331;
        let t341 = c5 * t331 + s5 * t126;
        let t344 = c5 * t126 - s5 * t331;
        let t350 = D5 * t341 - s5 * t337;
        let t358 = v1_4_z * t344 + (v1_5_z * t334 - v1_4_x * t341);
        let t359 = t186 * t338 - z1_4_x * (c5 * t337 - D5 * t344) - t358;
        let t363 = t350 - (t196 * t341 + t199 * t334);
        let t367 = t350 - (t200 * t341 + v3_5_z * t334);
        put(3, t359); // row 1, MSZ
        put(13, t363); // row 2, MSZ
        put(23, t367); // row 3, MSZ
        put(33, t350); // row 4, MSZ
        put(43, t338); // row 5, MSZ
    }
    // payload: column XX
    let [t369, t372, t375, t380] = {
        let t369 = s6 * t157;
        let t370 = c6 * t159 + t369;
        let t372 = c6 * t157;
        let t373 = s6 * t159 - t372;
        let t375 = t156 * t203;
        let t378 = t186 * t373 - (z1_5_x * t370 + t375);
        let t380 = c5 * t156;
        let t381 = t380 - s5 * t370;
        put(4, t378); // row 1, XX
        put(14, t381); // row 2, XX
        put(24, t381); // row 3, XX
        put(34, t381); // row 4, XX
        put(44, t373); // row 5, XX
        [t369, t372, t375, t380]
    };
    // payload: column YY
    let [t382, t385] = {
        let t382 = c6 * t158;
        let t384 = t382 + s6 * t160;
        let t385 = s6 * t158;
        let t387 = c6 * t160 - t385;
        let t391 = t186 * t387 + (t375 + z1_5_x * t384);
        let t393 = s5 * t384 - t380;
        put(5, t391); // row 1, YY
        put(15, t393); // row 2, YY
        put(25, t393); // row 3, YY
        put(35, t393); // row 4, YY
        put(45, t387); // row 5, YY
        [t382, t385]
    };
    // payload: column ZZ
    let t404 = {
        let t394 = t369 - t382;
        let t395 = t372 + t385;
        let t400 = t186 * t395 + (z1_5_x * t394 - dw6_z * t203);
        let t403 = s5 * t394 + c5 * dw6_z;
        let t404 = t165 - t162;
        put(6, t400); // row 1, ZZ
        put(16, t403); // row 2, ZZ
        put(26, t403); // row 3, ZZ
        put(36, t403); // row 4, ZZ
        put(46, t395); // row 5, ZZ
        put(55, t404); // row 6, XY
        t404
    };
    // payload: column XY
    {
        let t407 = c6 * t166 - s6 * t167;
        let t410 = s6 * t166 + c6 * t167;
        let t415 = t186 * t410 - (z1_5_x * t407 + t203 * t404);
        let t418 = c5 * t404 - s5 * t407;
        put(7, t415); // row 1, XY
        put(17, t418); // row 2, XY
        put(27, t418); // row 3, XY
        put(37, t418); // row 4, XY
        put(47, t410); // row 5, XY
    }
    // payload: column XZ
    let t431 = {
        let t420 = s6 * t161 - t245;
        let t422 = t242 + c6 * t161;
        let t427 = t186 * t422 - (t151 * t203 - z1_5_x * t420);
        let t430 = s5 * t420 + c5 * t151;
        let t431 = t165 - t126;
        put(8, t427); // row 1, XZ
        put(18, t430); // row 2, XZ
        put(28, t430); // row 3, XZ
        put(38, t430); // row 4, XZ
        put(48, t422); // row 5, XZ
        t431
    };
    // payload: column YZ
    {
        let t433 = t289 + c6 * t431;
        let t435 = s6 * t431 - t286;
        let t440 = t186 * t435 - (z1_5_x * t433 + t148 * t203);
        let t443 = c5 * t148 - s5 * t433;
        let t444 = -t156;
        put(9, t440); // row 1, YZ
        put(19, t443); // row 2, YZ
        put(29, t443); // row 3, YZ
        put(39, t443); // row 4, YZ
        put(49, t435); // row 5, YZ
        put(53, t444); // row 6, YY
    }
}
