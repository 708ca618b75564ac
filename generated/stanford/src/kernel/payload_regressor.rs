//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin (the paper's (7)).
//!
//! 245 multiplications, 164 additions; 6 x 10, 52 of 60 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 52;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9),
    (1, 0), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7), (1, 8), (1, 9),
    (2, 0), (2, 1), (2, 2), (2, 3), (3, 0), (3, 1), (3, 2), (3, 3), (3, 4), (3, 5),
    (3, 6), (3, 7), (3, 8), (3, 9), (4, 0), (4, 1), (4, 2), (4, 3), (4, 4), (4, 5),
    (4, 6), (4, 7), (4, 8), (4, 9), (5, 1), (5, 2), (5, 4), (5, 5), (5, 6), (5, 7),
    (5, 8), (5, 9),
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
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let D2 = S::constant(0.154);
    let D6 = S::constant(0.263);
    let k0 = S::constant(9.81);
    let k2 = S::constant(2.0);
    // link 2: motion
    let [t0, w3_z, t8, t10, t12, t13, t15, dw2_y] = {
        let t0 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t7 = D2 * ddq1;
        let t8 = D2 * (dq1 * dq1);
        let t10 = s2 * k0 + c2 * t7;
        let t12 = c2 * k0 - s2 * t7;
        let t13 = dq2 * w3_z;
        let t15 = s2 * ddq1 + t13;
        let dw2_y = dq2 * t0 - c2 * ddq1;
        [t0, w3_z, t8, t10, t12, t13, t15, dw2_y]
    };
    // link 3: motion
    let [t32, t33, t34] = {
        let t29 = dq3 * k2;
        let t32 = q3 * (t13 + t15) - t8 + t0 * t29;
        let t33 = t10 + q3 * (t0 * w3_z - ddq2) - dq2 * t29;
        let t34 = q3 * (t0 * t0 + dq2 * dq2) - t12 - ddq3;
        [t32, t33, t34]
    };
    // link 4: motion
    let [t37, t40, t49, a4_y, w4_z, t56, t57, dw4_z] = {
        let t37 = c4 * dq2 + s4 * t0;
        let t40 = c4 * t0 - s4 * dq2;
        let t49 = c4 * t32 + s4 * t33;
        let a4_y = s4 * t32 - c4 * t33;
        let w4_z = w3_z + dq4;
        let t56 = c4 * ddq2 + s4 * t15 + dq4 * t40;
        let t57 = c4 * t15 - s4 * ddq2 - dq4 * t37;
        let dw4_z = ddq4 - dw2_y;
        [t37, t40, t49, a4_y, w4_z, t56, t57, dw4_z]
    };
    // link 5: motion
    let [t61, t64, t73, t76, w5_z, t80, dw5_y, dw5_z] = {
        let t61 = c5 * t37 + s5 * w4_z;
        let t64 = c5 * w4_z - s5 * t37;
        let t73 = c5 * t49 - s5 * t34;
        let t76 = c5 * t34 + s5 * t49;
        let w5_z = dq5 - t40;
        let t80 = c5 * t56 + s5 * dw4_z + dq5 * t64;
        let dw5_y = s5 * t56 - c5 * dw4_z + dq5 * t61;
        let dw5_z = ddq5 - t57;
        [t61, t64, t73, t76, w5_z, t80, dw5_y, dw5_z]
    };
    // link 6: motion
    let [
        t85, w6_y, t106, t110, a6_y, w6_z, dw6_x, dw6_y,
        dw6_z,
    ] = {
        let t85 = c6 * t61 - s6 * w5_z;
        let w6_y = c6 * w5_z + s6 * t61;
        let t105 = t73 - D6 * (dw5_z - t61 * t64);
        let t106 = t76 + D6 * (t61 * t61 + w5_z * w5_z);
        let t107 = a4_y + D6 * (t80 + t64 * w5_z);
        let t110 = c6 * t105 - s6 * t107;
        let a6_y = c6 * t107 + s6 * t105;
        let w6_z = t64 + dq6;
        let dw6_x = s6 * dw5_z - c6 * t80 + dq6 * w6_y;
        let dw6_y = c6 * dw5_z + s6 * t80 + dq6 * t85;
        let dw6_z = ddq6 - dw5_y;
        put(44, a6_y); // row 6, MSX
        put(45, t110); // row 6, MSY
        put(48, dw6_z); // row 6, ZZ
        [
        t85, w6_y, t106, t110, a6_y, w6_z, dw6_x, dw6_y,
        dw6_z,
    ]
    };
    // joint axes in frame 2
    let [t120, v1_2_y] = {
        let t120 = c2 * D2;
        let v1_2_y = s2 * D2;
        [t120, v1_2_y]
    };
    // joint axes in frame 4
    let [t122, t123, t124, t125] = {
        let t122 = s2 * s4;
        let t123 = s2 * c4;
        let t124 = s4 * t120;
        let t125 = c4 * t120;
        [t122, t123, t124, t125]
    };
    // joint axes in frame 6
    let [
        t126, t127, t128, t129, t130, t131, t132, t133,
        t134, t135, t136, t137, t138, t139, t140,
    ] = {
        let t126 = t85 * t85;
        let t127 = w6_y * w6_y;
        let t128 = w6_z * w6_z;
        let t129 = t85 * w6_y;
        let t130 = t85 * w6_z;
        let t131 = w6_y * w6_z;
        let t132 = t127 + t128;
        let t133 = dw6_z + t129;
        let t134 = dw6_y - t130;
        let t135 = t129 - dw6_z;
        let t136 = t126 + t128;
        let t137 = dw6_x - t131;
        let t138 = dw6_y + t130;
        let t139 = dw6_x + t131;
        let t140 = t126 + t127;
        put(46, t129); // row 6, XX
        put(50, t137); // row 6, XZ
        put(51, t134); // row 6, YZ
        [
        t126, t127, t128, t129, t130, t131, t132, t133,
        t134, t135, t136, t137, t138, t139, t140,
    ]
    };
    // payload: column M
    let [t143, t146, t148] = {
        let t143 = c6 * t110 + s6 * a6_y;
        let t146 = c6 * a6_y - s6 * t110;
        let t147 = D6 * t146;
        let t148 = D6 * t143;
        let t151 = c5 * t143 + s5 * t106;
        let t154 = s5 * t143 - c5 * t106;
        let t156 = s5 * t147;
        let t159 = c5 * t147 + q3 * t146;
        let t160 = t148 + q3 * t151;
        let t170 = t124 * t151 - t125 * t146 - v1_2_y * t154;
        let t171 = c2 * t156 + (t122 * t159 + t123 * t160) + t170;
        let t174 = c4 * t159 - s4 * t160;
        put(0, t171); // row 1, M
        put(10, t174); // row 2, M
        put(20, t154); // row 3, M
        put(24, t156); // row 4, M
        [t143, t146, t148]
    };
    // payload: column MSX
    let [t176, t179, t181, t182] = {
        let t176 = s6 * t135;
        let t177 = c6 * t132 - t176;
        let t179 = c6 * t135;
        let t180 = s6 * t132 + t179;
        let t181 = s6 * t106;
        let t182 = c6 * t106;
        let t185 = D6 * t180 - t181;
        let t186 = t182 - D6 * t177;
        let t189 = c5 * t177 + s5 * t138;
        let t192 = s5 * t177 - c5 * t138;
        let t198 = c5 * a6_y - s5 * t185;
        let t201 = c5 * t185 + s5 * a6_y + q3 * t180;
        let t202 = t186 - q3 * t189;
        let t212 = t124 * t189 + t125 * t180 - v1_2_y * t192;
        let t213 = c2 * t198 - (t122 * t201 + t123 * t202) + t212;
        let t216 = s4 * t202 - c4 * t201;
        put(1, t213); // row 1, MSX
        put(11, t216); // row 2, MSX
        put(21, t192); // row 3, MSX
        put(25, t198); // row 4, MSX
        put(35, t186); // row 5, MSX
        [t176, t179, t181, t182]
    };
    // payload: column MSY
    let [t217, t220] = {
        let t217 = c6 * t133;
        let t219 = s6 * t136 - t217;
        let t220 = s6 * t133;
        let t222 = t220 + c6 * t136;
        let t225 = t182 - D6 * t222;
        let t226 = D6 * t219 - t181;
        let t229 = c5 * t219 + s5 * t139;
        let t232 = c5 * t139 - s5 * t219;
        let t238 = s5 * t225 + c5 * t110;
        let t241 = q3 * t222 - (c5 * t225 - s5 * t110);
        let t242 = t226 + q3 * t229;
        let t252 = t125 * t222 - t124 * t229 - v1_2_y * t232;
        let t253 = c2 * t238 - (t122 * t241 + t123 * t242) + t252;
        let t256 = s4 * t242 - c4 * t241;
        put(2, t253); // row 1, MSY
        put(12, t256); // row 2, MSY
        put(22, t232); // row 3, MSY
        put(26, t238); // row 4, MSY
        put(36, t226); // row 5, MSY
        [t217, t220]
    };
    // payload: column MSZ
    let t272 = {
        let t259 = c6 * t134 + s6 * t137;
        let t262 = s6 * t134 - c6 * t137;
        let t265 = t146 + D6 * t262;
        let t266 = D6 * t259 - t143;
        let t269 = c5 * t259 - s5 * t140;
        let t272 = s5 * t259 + c5 * t140;
        let t274 = s5 * t265;
        let t277 = c5 * t265 + q3 * t262;
        let t278 = t266 + q3 * t269;
        let t288 = t124 * t269 + t125 * t262 - v1_2_y * t272;
        let t289 = c2 * t274 + (t122 * t277 - t123 * t278) - t288;
        let t292 = c4 * t277 + s4 * t278;
        put(3, t289); // row 1, MSZ
        put(13, t292); // row 2, MSZ
        put(27, t274); // row 4, MSZ
        put(37, t266); // row 5, MSZ
        t272
    };
    // payload: column XX
    let [t294, t297, t300, t303] = {
        let t294 = s6 * t130;
        let t295 = c6 * dw6_x + t294;
        let t297 = c6 * t130;
        let t298 = s6 * dw6_x - t297;
        let t300 = s5 * t129;
        let t301 = c5 * t295 + t300;
        let t303 = c5 * t129;
        let t304 = t303 - s5 * t295;
        let t309 = c2 * t304 - (t122 * t301 + t123 * t298);
        let t312 = s4 * t298 - c4 * t301;
        put(4, t309); // row 1, XX
        put(14, t312); // row 2, XX
        put(28, t304); // row 4, XX
        put(38, t298); // row 5, XX
        [t294, t297, t300, t303]
    };
    // payload: column YY
    let [t313, t316] = {
        let t313 = c6 * t131;
        let t315 = t313 + s6 * dw6_y;
        let t316 = s6 * t131;
        let t318 = c6 * dw6_y - t316;
        let t320 = t300 + c5 * t315;
        let t322 = s5 * t315 - t303;
        let t327 = c2 * t322 - (t123 * t318 - t122 * t320);
        let t330 = c4 * t320 + s4 * t318;
        put(5, t327); // row 1, YY
        put(15, t330); // row 2, YY
        put(29, t322); // row 4, YY
        put(39, t318); // row 5, YY
        [t313, t316]
    };
    // payload: column ZZ
    let t347 = {
        let t331 = t294 - t313;
        let t332 = t297 + t316;
        let t335 = c5 * t331 - s5 * dw6_z;
        let t338 = s5 * t331 + c5 * dw6_z;
        let t343 = c2 * t338 + (t122 * t335 - t123 * t332);
        let t346 = c4 * t335 + s4 * t332;
        let t347 = t126 - t127;
        put(6, t343); // row 1, ZZ
        put(16, t346); // row 2, ZZ
        put(30, t338); // row 4, ZZ
        put(40, t332); // row 5, ZZ
        put(49, t347); // row 6, XY
        t347
    };
    // payload: column XY
    let t368 = {
        let t350 = s6 * t139 - c6 * t138;
        let t353 = s6 * t138 + c6 * t139;
        let t356 = c5 * t350 - s5 * t347;
        let t359 = s5 * t350 + c5 * t347;
        let t364 = c2 * t359 + (t122 * t356 - t123 * t353);
        let t367 = c4 * t356 + s4 * t353;
        let t368 = t128 - t126;
        put(7, t364); // row 1, XY
        put(17, t367); // row 2, XY
        put(31, t359); // row 4, XY
        put(41, t353); // row 5, XY
        t368
    };
    // payload: column XZ
    let t387 = {
        let t370 = t179 + s6 * t368;
        let t372 = c6 * t368 - t176;
        let t375 = c5 * t370 - s5 * t137;
        let t378 = s5 * t370 + c5 * t137;
        let t383 = c2 * t378 - (t123 * t372 - t122 * t375);
        let t386 = c4 * t375 + s4 * t372;
        let t387 = t127 - t128;
        put(8, t383); // row 1, XZ
        put(18, t386); // row 2, XZ
        put(32, t378); // row 4, XZ
        put(42, t372); // row 5, XZ
        t387
    };
    // payload: column YZ
    {
        let t389 = c6 * t387 - t220;
        let t391 = t217 + s6 * t387;
        let t394 = c5 * t389 + s5 * t134;
        let t397 = c5 * t134 - s5 * t389;
        let t402 = c2 * t397 - (t122 * t394 + t123 * t391);
        let t405 = s4 * t391 - c4 * t394;
        let t406 = -t272;
        let t407 = -t148;
        let t408 = -t129;
        put(9, t402); // row 1, YZ
        put(19, t405); // row 2, YZ
        put(23, t406); // row 3, MSZ
        put(33, t397); // row 4, YZ
        put(34, t407); // row 5, M
        put(43, t391); // row 5, YZ
        put(47, t408); // row 6, YY
    }
}
