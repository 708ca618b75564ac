//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its
//! origin. Katsumata et al. 2019, (7).
//!
//! 242 multiplications, 163 additions; 6 x 10, 52 of 60 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig, constants};

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

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 10 + PATTERN[k].1
}

/// Regressor of a body fixed to the tool frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 10]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            23 => clear(&mut flat[24..30]),
            43 => flat[50] = S::default(),
            45 => flat[53] = S::default(),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 10]; 6]) {
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
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let k0 = S::constant(-GRAVITY[2]);
    let k2 = S::constant(2.0);
    let k_D2 = S::constant(constants::D2);
    let k_D6 = S::constant(constants::D6);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        t4, t6, a2_y, t9, w3_z, dw2_y, t20, t21,
        t22,
    ] = {
        let t3 = k_D2 * ddq1;
        let t4 = k_D2 * t0;
        let t6 = s2 * k0 + c2 * t3;
        let a2_y = s2 * t3 - c2 * k0;
        let t9 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t17 = dq2 * w3_z;
        let dw2_y = dq2 * t9 - c2 * ddq1;
        let t20 = t9 * w3_z - ddq2;
        let t21 = t9 * t9 + dq2 * dq2;
        let t22 = t17 + (s2 * ddq1 + t17);
        [
        t4, t6, a2_y, t9, w3_z, dw2_y, t20, t21,
        t22,
    ]
    };
    // link 3: motion
    let [t32, a3_y, a3_z] = {
        let t29 = dq3 * k2;
        let t32 = t9 * t29 - (t4 - q3 * t22);
        let a3_y = dq2 * t29 - (t6 + q3 * t20);
        let a3_z = ddq3 - (a2_y + q3 * t21);
        [t32, a3_y, a3_z]
    };
    // link 4: motion
    let [
        t35, t36, t39, a4_y, t45, w4_y, w4_z, dw4_y,
        t62, t63,
    ] = {
        let t35 = s2 * s4;
        let t36 = s2 * c4;
        let t39 = c4 * t32 - s4 * a3_y;
        let a4_y = c4 * a3_y + s4 * t32;
        let t45 = c4 * dq2 + s4 * t9;
        let w4_y = s4 * dq2 - c4 * t9;
        let w4_z = w3_z + dq4;
        let dw4_z = ddq4 - dw2_y;
        let t59 = w4_y * w4_z;
        let dw4_x = c4 * t20 - s4 * t22 + t59;
        let dw4_y = t45 * w4_z - (c4 * t22 + s4 * t20);
        let t62 = dw4_z + t45 * w4_y;
        let t63 = t59 + dw4_x;
        [
        t35, t36, t39, a4_y, t45, w4_y, w4_z, dw4_y,
        t62, t63,
    ]
    };
    // link 5: motion
    let [
        t66, t69, t72, w5_y, w5_z, t90, t91, t92,
        t93,
    ] = {
        let t66 = c5 * t39 + s5 * a3_z;
        let t69 = c5 * a3_z - s5 * t39;
        let t72 = c5 * t45 + s5 * w4_z;
        let w5_y = s5 * t45 - c5 * w4_z;
        let w5_z = w4_y + dq5;
        let dw5_z = dw4_y + ddq5;
        let t88 = w5_y * w5_z;
        let dw5_x = c5 * t63 - s5 * t62 + t88;
        let t90 = c5 * t62 + s5 * t63 - t72 * w5_z;
        let t91 = dw5_z + t72 * w5_y;
        let t92 = t72 * t72 + w5_z * w5_z;
        let t93 = t88 + dw5_x;
        [
        t66, t69, t72, w5_y, w5_z, t90, t91, t92,
        t93,
    ]
    };
    // joint axes in frame 2
    let [t94, v1_2_y] = {
        let t94 = c2 * k_D2;
        let v1_2_y = s2 * k_D2;
        [t94, v1_2_y]
    };
    // joint axes in frame 4
    let [t96, t97] = {
        let t96 = s4 * t94;
        let t97 = c4 * t94;
        [t96, t97]
    };
    // link 6: motion
    let [
        t102, t106, a6_y, t118, t121, dw6_z, t126, t127,
        t128, dw6_x, dw6_y, t131, t132, t133, t134, t135,
        t136, t137,
    ] = {
        let t101 = t66 - k_D6 * t91;
        let t102 = k_D6 * t92 - t69;
        let t103 = a4_y - k_D6 * t93;
        let t106 = c6 * t101 - s6 * t103;
        let a6_y = c6 * t103 + s6 * t101;
        let w6_x = s6 * w5_z - c6 * t72;
        let w6_y = c6 * w5_z + s6 * t72;
        let t118 = c6 * t91 - s6 * t93;
        let t121 = c6 * t93 + s6 * t91;
        let w6_z = dq6 - w5_y;
        let dw6_z = t90 + ddq6;
        let t124 = w6_x * w6_x;
        let t125 = w6_z * w6_z;
        let t126 = w6_x * w6_y;
        let t127 = w6_x * w6_z;
        let t128 = w6_y * w6_z;
        let dw6_x = t121 + t128;
        let dw6_y = t118 - t127;
        let t131 = t125 - t124;
        let t132 = t92 + t131;
        let t133 = t126 - dw6_z;
        let t134 = dw6_z + t126;
        let t135 = t124 + t125;
        let t136 = dw6_y - t127;
        let t137 = t128 + dw6_x;
        let t138 = -t126;
        put(44, a6_y); // row 6, MSX
        put(45, t106); // row 6, MSY
        put(46, t138); // row 6, XX
        put(47, t126); // row 6, YY
        put(48, dw6_z); // row 6, ZZ
        put(50, t121); // row 6, XZ
        put(51, t118); // row 6, YZ
        [
        t102, t106, a6_y, t118, t121, dw6_z, t126, t127,
        t128, dw6_x, dw6_y, t131, t132, t133, t134, t135,
        t136, t137,
    ]
    };
    // payload: column M
    let [t141, t144] = {
        let t141 = c6 * t106 + s6 * a6_y;
        let t144 = c6 * a6_y - s6 * t106;
        let t145 = k_D6 * t144;
        let t146 = k_D6 * t141;
        let t149 = c5 * t141 + s5 * t102;
        let t152 = s5 * t141 - c5 * t102;
        let t154 = s5 * t145;
        let t157 = c5 * t145 + q3 * t144;
        let t158 = t146 + q3 * t149;
        let t168 = t96 * t149 - t97 * t144 - v1_2_y * t152;
        let t169 = c2 * t154 + (t35 * t157 + t36 * t158) + t168;
        let t172 = c4 * t157 - s4 * t158;
        let t173 = -t146;
        put(0, t169); // row 1, M
        put(10, t172); // row 2, M
        put(20, t152); // row 3, M
        put(24, t154); // row 4, M
        put(34, t173); // row 5, M
        [t141, t144]
    };
    // payload: column MSX
    let [t175, t178, t180, t181] = {
        let t175 = s6 * t134;
        let t176 = c6 * t132 + t175;
        let t178 = c6 * t134;
        let t179 = t178 - s6 * t132;
        let t180 = s6 * t102;
        let t181 = c6 * t102;
        let t184 = t180 + k_D6 * t179;
        let t185 = t181 - k_D6 * t176;
        let t188 = c5 * t176 + s5 * t136;
        let t191 = s5 * t176 - c5 * t136;
        let t197 = s5 * t184 + c5 * a6_y;
        let t200 = c5 * t184 - s5 * a6_y + q3 * t179;
        let t201 = t185 - q3 * t188;
        let t211 = v1_2_y * t191 + (t97 * t179 - t96 * t188);
        let t212 = c2 * t197 + (t35 * t200 - t36 * t201) - t211;
        let t215 = c4 * t200 + s4 * t201;
        put(1, t212); // row 1, MSX
        put(11, t215); // row 2, MSX
        put(21, t191); // row 3, MSX
        put(25, t197); // row 4, MSX
        put(35, t185); // row 5, MSX
        [t175, t178, t180, t181]
    };
    // payload: column MSY
    let [t216, t219] = {
        let t216 = c6 * t133;
        let t218 = t216 + s6 * t135;
        let t219 = s6 * t133;
        let t221 = t219 - c6 * t135;
        let t224 = t181 + k_D6 * t221;
        let t225 = k_D6 * t218 - t180;
        let t228 = c5 * t218 + s5 * t137;
        let t231 = c5 * t137 - s5 * t218;
        let t237 = s5 * t224 + c5 * t106;
        let t240 = c5 * t224 - s5 * t106 + q3 * t221;
        let t241 = t225 + q3 * t228;
        let t251 = v1_2_y * t231 + (t96 * t228 + t97 * t221);
        let t252 = c2 * t237 + (t35 * t240 - t36 * t241) - t251;
        let t255 = c4 * t240 + s4 * t241;
        put(2, t252); // row 1, MSY
        put(12, t255); // row 2, MSY
        put(22, t231); // row 3, MSY
        put(26, t237); // row 4, MSY
        put(36, t225); // row 5, MSY
        [t216, t219]
    };
    // payload: column MSZ
    {
        let t258 = c6 * t118 + s6 * t121;
        let t261 = s6 * t118 - c6 * t121;
        let t264 = t144 + k_D6 * t261;
        let t265 = k_D6 * t258 - t141;
        let t268 = c5 * t258 - s5 * t92;
        let t271 = s5 * t258 + c5 * t92;
        let t273 = s5 * t264;
        let t276 = c5 * t264 + q3 * t261;
        let t277 = t265 + q3 * t268;
        let t287 = v1_2_y * t271 - (t96 * t268 + t97 * t261);
        let t288 = c2 * t273 + (t35 * t276 - t36 * t277) + t287;
        let t291 = c4 * t276 + s4 * t277;
        let t292 = -t271;
        put(3, t288); // row 1, MSZ
        put(13, t291); // row 2, MSZ
        put(23, t292); // row 3, MSZ
        put(27, t273); // row 4, MSZ
        put(37, t265); // row 5, MSZ
    }
    // payload: column XX
    let [t294, t297, t300, t303] = {
        let t294 = s6 * t127;
        let t295 = t294 - c6 * dw6_x;
        let t297 = c6 * t127;
        let t298 = s6 * dw6_x + t297;
        let t300 = s5 * t126;
        let t301 = c5 * t295 + t300;
        let t303 = c5 * t126;
        let t304 = s5 * t295 - t303;
        let t309 = c2 * t304 + (t35 * t301 - t36 * t298);
        let t312 = c4 * t301 + s4 * t298;
        put(4, t309); // row 1, XX
        put(14, t312); // row 2, XX
        put(28, t304); // row 4, XX
        put(38, t298); // row 5, XX
        [t294, t297, t300, t303]
    };
    // payload: column YY
    let [t313, t316] = {
        let t313 = c6 * t128;
        let t315 = t313 + s6 * dw6_y;
        let t316 = s6 * t128;
        let t318 = c6 * dw6_y - t316;
        let t320 = c5 * t315 - t300;
        let t322 = t303 + s5 * t315;
        let t327 = c2 * t322 + (t35 * t320 - t36 * t318);
        let t330 = c4 * t320 + s4 * t318;
        put(5, t327); // row 1, YY
        put(15, t330); // row 2, YY
        put(29, t322); // row 4, YY
        put(39, t318); // row 5, YY
        [t313, t316]
    };
    // payload: column ZZ
    let t347 = {
        let t331 = t294 + t313;
        let t332 = t316 - t297;
        let t335 = c5 * t331 + s5 * dw6_z;
        let t338 = c5 * dw6_z - s5 * t331;
        let t343 = c2 * t338 - (t35 * t335 + t36 * t332);
        let t346 = s4 * t332 - c4 * t335;
        let t347 = t135 - t132;
        put(6, t343); // row 1, ZZ
        put(16, t346); // row 2, ZZ
        put(30, t338); // row 4, ZZ
        put(40, t332); // row 5, ZZ
        put(49, t347); // row 6, XY
        t347
    };
    // payload: column XY
    {
        let t350 = c6 * t136 - s6 * t137;
        let t353 = s6 * t136 + c6 * t137;
        let t356 = c5 * t350 + s5 * t347;
        let t359 = c5 * t347 - s5 * t350;
        let t364 = c2 * t359 - (t35 * t356 + t36 * t353);
        let t367 = s4 * t353 - c4 * t356;
        put(7, t364); // row 1, XY
        put(17, t367); // row 2, XY
        put(31, t359); // row 4, XY
        put(41, t353); // row 5, XY
    }
    // payload: column XZ
    let t386 = {
        let t369 = t178 - s6 * t131;
        let t371 = t175 + c6 * t131;
        let t374 = c5 * t369 + s5 * t121;
        let t377 = c5 * t121 - s5 * t369;
        let t382 = c2 * t377 - (t35 * t374 + t36 * t371);
        let t385 = s4 * t371 - c4 * t374;
        let t386 = t92 - t135;
        put(8, t382); // row 1, XZ
        put(18, t385); // row 2, XZ
        put(32, t377); // row 4, XZ
        put(42, t371); // row 5, XZ
        t386
    };
    // payload: column YZ
    {
        let t388 = t219 + c6 * t386;
        let t390 = s6 * t386 - t216;
        let t393 = c5 * t388 + s5 * t118;
        let t396 = c5 * t118 - s5 * t388;
        let t401 = c2 * t396 - (t35 * t393 + t36 * t390);
        let t404 = s4 * t390 - c4 * t393;
        put(9, t401); // row 1, YZ
        put(19, t404); // row 2, YZ
        put(33, t396); // row 4, YZ
        put(43, t390); // row 5, YZ
    }
}
