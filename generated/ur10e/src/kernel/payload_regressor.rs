//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin (the paper's (7)).
//!
//! 252 multiplications, 176 additions; 6 x 10, 58 of 60 structurally nonzero.

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
    let flat = &mut out.as_flattened_mut()[..];
    flat[50] = S::default();
    flat[53] = S::default();
    nonzeros(trig, dq, ddq, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
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
    let [a2_x, a2_y, t12, t13, t14] = {
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t9 = dq2 * w2_x;
        let dw2_y = c2 * ddq1 - t9;
        let t12 = t0 + (dq2 * dq2 - w2_x * w2_x);
        let t13 = ddq2 + w2_x * w2_y;
        let t14 = dw2_y - t9;
        [a2_x, a2_y, t12, t13, t14]
    };
    // link 3: motion
    let [
        z1_3_x, t20, w3_z, dw3_z, t25, t30, t33, t34,
        t35, t44, t45, t46,
    ] = {
        let z1_3_x = s2 * c3 + c2 * s3;
        let t20 = s2 * s3 - c2 * c3;
        let w3_z = dq2 + dq3;
        let dw3_z = ddq2 + ddq3;
        let t25 = t14 * k1;
        let t26 = a2_x + t12 * k1;
        let t27 = t13 * k1 - a2_y;
        let t30 = s3 * t27 - c3 * t26;
        let t33 = c3 * t27 + s3 * t26;
        let t34 = ddq1 * t20;
        let t35 = ddq1 * z1_3_x;
        let w3_x = dq1 * z1_3_x;
        let t41 = w3_z * w3_x;
        let t44 = t0 + (w3_z * w3_z - w3_x * w3_x);
        let t45 = dw3_z - w3_x * (dq1 * t20);
        let t46 = t41 + (t34 + t41);
        [
        z1_3_x, t20, w3_z, dw3_z, t25, t30, t33, t34,
        t35, t44, t45, t46,
    ]
    };
    // link 4: motion
    let [
        t49, t52, w4_z, t66, t69, t72, t75, t76,
        t83, t84, t85, t86,
    ] = {
        let t49 = s4 * t20 - c4 * z1_3_x;
        let t52 = c4 * t20 + s4 * z1_3_x;
        let w4_z = w3_z + dq4;
        let dw4_z = dw3_z + ddq4;
        let t64 = t30 - (t44 * k2 - D4 * t34);
        let t65 = t33 + (t45 * k2 + D4 * t35);
        let t66 = t46 * k2 + D4 * t0 - t25;
        let t69 = c4 * t64 + s4 * t65;
        let t72 = c4 * t65 - s4 * t64;
        let t75 = dq1 * t49;
        let t76 = dq1 * t52;
        let t81 = w4_z * t76;
        let t83 = ddq1 * t52 - w4_z * t75;
        let t84 = t75 * t76 - dw4_z;
        let t85 = t75 * t75 + w4_z * w4_z;
        let t86 = t81 + (ddq1 * t49 + t81);
        [
        t49, t52, w4_z, t66, t69, t72, t75, t76,
        t83, t84, t85, t86,
    ]
    };
    // link 5: motion
    let [
        t87, t88, t93, t97, t100, w5_x, w5_y, w5_z,
        t121, t122, t123, t124,
    ] = {
        let t87 = c5 * t49;
        let t88 = s5 * t49;
        let t92 = t69 + D5 * t84;
        let t93 = t72 - D5 * t85;
        let t94 = t66 - D5 * t86;
        let t97 = c5 * t92 + s5 * t94;
        let t100 = c5 * t94 - s5 * t92;
        let w5_x = s5 * w4_z - c5 * t75;
        let w5_y = c5 * w4_z + s5 * t75;
        let w5_z = t76 + dq5;
        let dw5_z = t83 + ddq5;
        let t119 = w5_y * w5_z;
        let t121 = s5 * t86 - c5 * t84 - w5_x * w5_z;
        let t122 = w5_x * w5_y - dw5_z;
        let t123 = w5_x * w5_x + w5_z * w5_z;
        let t124 = c5 * t86 + s5 * t84 - t119 - t119;
        [
        t87, t88, t93, t97, t100, w5_x, w5_y, w5_z,
        t121, t122, t123, t124,
    ]
    };
    // link 6: motion
    let [
        t129, t133, a6_y, t145, t148, dw6_z, t153, t154,
        t155, t156, t157, t158, t159, t160, t161, t162,
        t163, t164,
    ] = {
        let t128 = t97 - D6 * t122;
        let t129 = t100 + D6 * t123;
        let t130 = D6 * t124 - t93;
        let t133 = c6 * t128 - s6 * t130;
        let a6_y = c6 * t130 + s6 * t128;
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t142 = c6 * w5_z + s6 * w5_x;
        let t145 = c6 * t122 + s6 * t124;
        let t148 = s6 * t122 - c6 * t124;
        let w6_z = w5_y + dq6;
        let dw6_z = t121 + ddq6;
        let t151 = w6_x * w6_x;
        let t152 = w6_z * w6_z;
        let t153 = w6_x * t142;
        let t154 = w6_x * w6_z;
        let t155 = t142 * w6_z;
        let t156 = t155 - t148;
        let t157 = t154 - t145;
        let t158 = t151 - t152;
        let t159 = t123 - t158;
        let t160 = dw6_z + t153;
        let t161 = dw6_z - t153;
        let t162 = t151 + t152;
        let t163 = t154 + t157;
        let t164 = t155 + t156;
        put(50, a6_y); // row 6, MSX
        put(51, t133); // row 6, MSY
        put(52, t153); // row 6, XX
        put(54, dw6_z); // row 6, ZZ
        put(56, t148); // row 6, XZ
        put(57, t145); // row 6, YZ
        [
        t129, t133, a6_y, t145, t148, dw6_z, t153, t154,
        t155, t156, t157, t158, t159, t160, t161, t162,
        t163, t164,
    ]
    };
    // joint axes in frame 3
    let [v1_3_z, t166, t167] = {
        let v1_3_z = c2 * k1;
        let t166 = s3 * k1;
        let t167 = c3 * k1;
        [v1_3_z, t166, t167]
    };
    // joint axes in frame 4
    let [v1_4_z, t174, v1_5_z, t181, t184, t185, v3_5_z] = {
        let t168 = D4 * t20;
        let t169 = D4 * z1_3_x;
        let v1_4_z = v1_3_z - t20 * k2;
        let t174 = c4 * t168 + s4 * t169;
        let v1_5_z = c4 * t169 - s4 * t168;
        let t178 = t167 - A3;
        let t181 = c4 * t166 + s4 * t178;
        let t184 = c4 * t178 - s4 * t166;
        let t185 = s4 * k2;
        let v3_5_z = c4 * k2;
        [v1_4_z, t174, v1_5_z, t181, t184, t185, v3_5_z]
    };
    // payload: column M
    let [t189, t192] = {
        let t189 = c6 * t133 + s6 * a6_y;
        let t192 = s6 * t133 - c6 * a6_y;
        let t193 = D6 * t192;
        let t194 = D6 * t189;
        let t197 = s5 * t129 - c5 * t189;
        let t200 = s5 * t189 + c5 * t129;
        let t206 = s5 * t193 + D5 * t197;
        let t214 = v1_5_z * t192 - t174 * t197 - v1_4_z * t200;
        let t215 = t52 * t194 - t49 * (c5 * t193 + D5 * t200) + t214;
        let t219 = t206 + (t184 * t192 - t181 * t197);
        let t223 = t206 + (v3_5_z * t192 - t185 * t197);
        put(0, t215); // row 1, M
        put(10, t219); // row 2, M
        put(20, t223); // row 3, M
        put(30, t206); // row 4, M
        put(40, t194); // row 5, M
        [t189, t192]
    };
    // payload: column MSX
    let [t225, t228, t230, t231] = {
        let t225 = s6 * t161;
        let t226 = c6 * t159 + t225;
        let t228 = c6 * t161;
        let t229 = t228 - s6 * t159;
        let t230 = s6 * t129;
        let t231 = c6 * t129;
        let t234 = t230 + D6 * t229;
        let t235 = D6 * t226 - t231;
        let t238 = c5 * t226 + s5 * t163;
        let t241 = s5 * t226 - c5 * t163;
        let t251 = c5 * a6_y - s5 * t234 - D5 * t238;
        let t254 = t52 * t235 - t49 * (D5 * t241 - (c5 * t234 + s5 * a6_y));
        let t260 = t254 - (v1_4_z * t241 + (v1_5_z * t229 - t174 * t238));
        let t264 = t251 - (t184 * t229 - t181 * t238);
        let t268 = t251 + (t185 * t238 - v3_5_z * t229);
        put(1, t260); // row 1, MSX
        put(11, t264); // row 2, MSX
        put(21, t268); // row 3, MSX
        put(31, t251); // row 4, MSX
        put(41, t235); // row 5, MSX
        [t225, t228, t230, t231]
    };
    // payload: column MSY
    let [t269, t272] = {
        let t269 = c6 * t160;
        let t271 = t269 - s6 * t162;
        let t272 = s6 * t160;
        let t274 = t272 + c6 * t162;
        let t277 = D6 * t274 - t231;
        let t278 = t230 + D6 * t271;
        let t281 = c5 * t271 - s5 * t164;
        let t284 = s5 * t271 + c5 * t164;
        let t294 = s5 * t277 + c5 * t133 - D5 * t281;
        let t297 = t49 * (s5 * t133 - c5 * t277 - D5 * t284) + t52 * t278;
        let t303 = t297 + (t174 * t281 + v1_5_z * t274 - v1_4_z * t284);
        let t307 = t294 + (t181 * t281 + t184 * t274);
        let t311 = t294 + (t185 * t281 + v3_5_z * t274);
        put(2, t303); // row 1, MSY
        put(12, t307); // row 2, MSY
        put(22, t311); // row 3, MSY
        put(32, t294); // row 4, MSY
        put(42, t278); // row 5, MSY
        [t269, t272]
    };
    // payload: column MSZ
    {
        let t314 = c6 * t145 + s6 * t148;
        let t317 = c6 * t148 - s6 * t145;
        let t320 = t192 + D6 * t317;
        let t321 = t189 - D6 * t314;
        let t324 = c5 * t314 + s5 * t123;
        let t327 = s5 * t314 - c5 * t123;
        let t333 = s5 * t320 + D5 * t324;
        let t341 = v1_4_z * t327 + (v1_5_z * t317 - t174 * t324);
        let t342 = t52 * t321 - t49 * (c5 * t320 - D5 * t327) + t341;
        let t346 = t333 - (t181 * t324 - t184 * t317);
        let t350 = t333 + (v3_5_z * t317 - t185 * t324);
        put(3, t342); // row 1, MSZ
        put(13, t346); // row 2, MSZ
        put(23, t350); // row 3, MSZ
        put(33, t333); // row 4, MSZ
        put(43, t321); // row 5, MSZ
    }
    // payload: column XX
    let [t352, t355, t358, t363] = {
        let t352 = s6 * t154;
        let t353 = c6 * t156 + t352;
        let t355 = c6 * t154;
        let t356 = s6 * t156 - t355;
        let t358 = t88 * t153;
        let t361 = t52 * t356 + (t87 * t353 + t358);
        let t363 = c5 * t153;
        let t364 = t363 - s5 * t353;
        put(4, t361); // row 1, XX
        put(14, t364); // row 2, XX
        put(24, t364); // row 3, XX
        put(34, t364); // row 4, XX
        put(44, t356); // row 5, XX
        [t352, t355, t358, t363]
    };
    // payload: column YY
    let [t365, t368] = {
        let t365 = c6 * t155;
        let t367 = t365 + s6 * t157;
        let t368 = s6 * t155;
        let t370 = c6 * t157 - t368;
        let t374 = t52 * t370 - (t358 + t87 * t367);
        let t376 = s5 * t367 - t363;
        put(5, t374); // row 1, YY
        put(15, t376); // row 2, YY
        put(25, t376); // row 3, YY
        put(35, t376); // row 4, YY
        put(45, t370); // row 5, YY
        [t365, t368]
    };
    // payload: column ZZ
    let t387 = {
        let t377 = t365 - t352;
        let t378 = t355 + t368;
        let t383 = t52 * t378 + (t87 * t377 + t88 * dw6_z);
        let t386 = c5 * dw6_z - s5 * t377;
        let t387 = t162 - t159;
        put(6, t383); // row 1, ZZ
        put(16, t386); // row 2, ZZ
        put(26, t386); // row 3, ZZ
        put(36, t386); // row 4, ZZ
        put(46, t378); // row 5, ZZ
        put(55, t387); // row 6, XY
        t387
    };
    // payload: column XY
    {
        let t390 = s6 * t164 - c6 * t163;
        let t393 = s6 * t163 + c6 * t164;
        let t398 = t52 * t393 + (t88 * t387 - t87 * t390);
        let t401 = s5 * t390 + c5 * t387;
        put(7, t398); // row 1, XY
        put(17, t401); // row 2, XY
        put(27, t401); // row 3, XY
        put(37, t401); // row 4, XY
        put(47, t393); // row 5, XY
    }
    // payload: column XZ
    let t414 = {
        let t403 = t228 + s6 * t158;
        let t405 = c6 * t158 - t225;
        let t410 = t52 * t405 + (t88 * t148 - t87 * t403);
        let t413 = s5 * t403 + c5 * t148;
        let t414 = t162 - t123;
        put(8, t410); // row 1, XZ
        put(18, t413); // row 2, XZ
        put(28, t413); // row 3, XZ
        put(38, t413); // row 4, XZ
        put(48, t405); // row 5, XZ
        t414
    };
    // payload: column YZ
    {
        let t416 = t272 + c6 * t414;
        let t418 = s6 * t414 - t269;
        let t423 = t52 * t418 + (t87 * t416 + t88 * t145);
        let t426 = c5 * t145 - s5 * t416;
        let t427 = -t153;
        put(9, t423); // row 1, YZ
        put(19, t426); // row 2, YZ
        put(29, t426); // row 3, YZ
        put(39, t426); // row 4, YZ
        put(49, t418); // row 5, YZ
        put(53, t427); // row 6, YY
    }
}
