//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its
//! origin. Katsumata et al. 2019, (7).
//!
//! 252 multiplications, 176 additions; 6 x 10, 58 of 60 structurally nonzero.

use super::super::runtime::{Scalar, apart};
use super::super::{DOF, GRAVITY, Trig, constants};

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
            49 => flat[50] = S::default(),
            51 => flat[53] = S::default(),
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
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let k0 = S::constant(-GRAVITY[2]);
    let k1 = S::constant(-constants::A2);
    let k2 = S::constant(-constants::A3);
    let k_A3 = S::constant(constants::A3);
    let k_D4 = S::constant(constants::D4);
    let k_D5 = S::constant(constants::D5);
    let k_D6 = S::constant(constants::D6);
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
        let t64 = t30 - (t44 * k2 - k_D4 * t34);
        let t65 = t33 + (t45 * k2 + k_D4 * t35);
        let t66 = t46 * k2 + k_D4 * t0 - t25;
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
        let t92 = t69 + k_D5 * t84;
        let t93 = t72 - k_D5 * t85;
        let t94 = t66 - k_D5 * t86;
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
    // joint axes in frame 3
    let [v1_3_z, t126, t127] = {
        let v1_3_z = c2 * k1;
        let t126 = s3 * k1;
        let t127 = c3 * k1;
        [v1_3_z, t126, t127]
    };
    // joint axes in frame 4
    let [v1_4_z, t134, v1_5_z, t141, t144, t145, v3_5_z] = {
        let t128 = k_D4 * t20;
        let t129 = k_D4 * z1_3_x;
        let v1_4_z = v1_3_z - t20 * k2;
        let t134 = c4 * t128 + s4 * t129;
        let v1_5_z = c4 * t129 - s4 * t128;
        let t138 = t127 - k_A3;
        let t141 = c4 * t126 + s4 * t138;
        let t144 = c4 * t138 - s4 * t126;
        let t145 = s4 * k2;
        let v3_5_z = c4 * k2;
        [v1_4_z, t134, v1_5_z, t141, t144, t145, v3_5_z]
    };
    // link 6: motion
    let [
        t151, t155, a6_y, t167, t170, dw6_z, t175, t176,
        t177, t178, t179, t180, t181, t182, t183, t184,
        t185, t186,
    ] = {
        let t150 = t97 - k_D6 * t122;
        let t151 = t100 + k_D6 * t123;
        let t152 = k_D6 * t124 - t93;
        let t155 = c6 * t150 - s6 * t152;
        let a6_y = c6 * t152 + s6 * t150;
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t164 = c6 * w5_z + s6 * w5_x;
        let t167 = c6 * t122 + s6 * t124;
        let t170 = s6 * t122 - c6 * t124;
        let w6_z = w5_y + dq6;
        let dw6_z = t121 + ddq6;
        let t173 = w6_x * w6_x;
        let t174 = w6_z * w6_z;
        let t175 = w6_x * t164;
        let t176 = w6_x * w6_z;
        let t177 = t164 * w6_z;
        let t178 = t177 - t170;
        let t179 = t176 - t167;
        let t180 = t173 - t174;
        let t181 = t123 - t180;
        let t182 = dw6_z + t175;
        let t183 = dw6_z - t175;
        let t184 = t173 + t174;
        let t185 = t176 + t179;
        let t186 = t177 + t178;
        let t187 = -t175;
        put(50, a6_y); // row 6, MSX
        put(51, t155); // row 6, MSY
        put(52, t175); // row 6, XX
        put(53, t187); // row 6, YY
        put(54, dw6_z); // row 6, ZZ
        put(56, t170); // row 6, XZ
        put(57, t167); // row 6, YZ
        [
        t151, t155, a6_y, t167, t170, dw6_z, t175, t176,
        t177, t178, t179, t180, t181, t182, t183, t184,
        t185, t186,
    ]
    };
    // payload: column M
    let [t190, t193] = {
        let t190 = c6 * t155 + s6 * a6_y;
        let t193 = s6 * t155 - c6 * a6_y;
        let t194 = k_D6 * t193;
        let t195 = k_D6 * t190;
        let t198 = s5 * t151 - c5 * t190;
        let t201 = s5 * t190 + c5 * t151;
        let t207 = s5 * t194 + k_D5 * t198;
        let t215 = v1_5_z * t193 - t134 * t198 - v1_4_z * t201;
        let t216 = t52 * t195 - t49 * (c5 * t194 + k_D5 * t201) + t215;
        let t220 = t207 + (t144 * t193 - t141 * t198);
        let t224 = t207 + (v3_5_z * t193 - t145 * t198);
        put(0, t216); // row 1, M
        put(10, t220); // row 2, M
        put(20, t224); // row 3, M
        put(30, t207); // row 4, M
        put(40, t195); // row 5, M
        [t190, t193]
    };
    // payload: column MSX
    let [t226, t229, t231, t232] = {
        let t226 = s6 * t183;
        let t227 = c6 * t181 + t226;
        let t229 = c6 * t183;
        let t230 = t229 - s6 * t181;
        let t231 = s6 * t151;
        let t232 = c6 * t151;
        let t235 = t231 + k_D6 * t230;
        let t236 = k_D6 * t227 - t232;
        let t239 = c5 * t227 + s5 * t185;
        let t242 = s5 * t227 - c5 * t185;
        let t252 = c5 * a6_y - s5 * t235 - k_D5 * t239;
        let t255 = t52 * t236 - t49 * (k_D5 * t242 - (c5 * t235 + s5 * a6_y));
        let t261 = t255 - (v1_4_z * t242 + (v1_5_z * t230 - t134 * t239));
        let t265 = t252 - (t144 * t230 - t141 * t239);
        let t269 = t252 + (t145 * t239 - v3_5_z * t230);
        put(1, t261); // row 1, MSX
        put(11, t265); // row 2, MSX
        put(21, t269); // row 3, MSX
        put(31, t252); // row 4, MSX
        put(41, t236); // row 5, MSX
        [t226, t229, t231, t232]
    };
    // payload: column MSY
    let [t270, t273] = {
        let t270 = c6 * t182;
        let t272 = t270 - s6 * t184;
        let t273 = s6 * t182;
        let t275 = t273 + c6 * t184;
        let t278 = k_D6 * t275 - t232;
        let t279 = t231 + k_D6 * t272;
        let t282 = c5 * t272 - s5 * t186;
        let t285 = s5 * t272 + c5 * t186;
        let t295 = s5 * t278 + c5 * t155 - k_D5 * t282;
        let t298 = t49 * (s5 * t155 - c5 * t278 - k_D5 * t285) + t52 * t279;
        let t304 = t298 + (t134 * t282 + v1_5_z * t275 - v1_4_z * t285);
        let t308 = t295 + (t141 * t282 + t144 * t275);
        let t312 = t295 + (t145 * t282 + v3_5_z * t275);
        put(2, t304); // row 1, MSY
        put(12, t308); // row 2, MSY
        put(22, t312); // row 3, MSY
        put(32, t295); // row 4, MSY
        put(42, t279); // row 5, MSY
        [t270, t273]
    };
    // payload: column MSZ
    {
        let t315 = c6 * t167 + s6 * t170;
        let t318 = c6 * t170 - s6 * t167;
        let t321 = t193 + k_D6 * t318;
        let t322 = t190 - k_D6 * t315;
        let t325 = c5 * t315 + s5 * t123;
        let t328 = s5 * t315 - c5 * t123;
        let t334 = s5 * t321 + k_D5 * t325;
        let t342 = v1_4_z * t328 + (v1_5_z * t318 - t134 * t325);
        let t343 = t52 * t322 - t49 * (c5 * t321 - k_D5 * t328) + t342;
        let t347 = t334 - (t141 * t325 - t144 * t318);
        let t351 = t334 + (v3_5_z * t318 - t145 * t325);
        put(3, t343); // row 1, MSZ
        put(13, t347); // row 2, MSZ
        put(23, t351); // row 3, MSZ
        put(33, t334); // row 4, MSZ
        put(43, t322); // row 5, MSZ
    }
    // payload: column XX
    let [t353, t356, t359, t364] = {
        let t353 = s6 * t176;
        let t354 = c6 * t178 + t353;
        let t356 = c6 * t176;
        let t357 = s6 * t178 - t356;
        let t359 = t88 * t175;
        let t362 = t52 * t357 + (t87 * t354 + t359);
        let t364 = c5 * t175;
        let t365 = t364 - s5 * t354;
        put(4, t362); // row 1, XX
        put(14, t365); // row 2, XX
        put(24, t365); // row 3, XX
        put(34, t365); // row 4, XX
        put(44, t357); // row 5, XX
        [t353, t356, t359, t364]
    };
    // payload: column YY
    let [t366, t369] = {
        let t366 = c6 * t177;
        let t368 = t366 + s6 * t179;
        let t369 = s6 * t177;
        let t371 = c6 * t179 - t369;
        let t375 = t52 * t371 - (t359 + t87 * t368);
        let t377 = s5 * t368 - t364;
        put(5, t375); // row 1, YY
        put(15, t377); // row 2, YY
        put(25, t377); // row 3, YY
        put(35, t377); // row 4, YY
        put(45, t371); // row 5, YY
        [t366, t369]
    };
    // payload: column ZZ
    let t388 = {
        let t378 = t366 - t353;
        let t379 = t356 + t369;
        let t384 = t52 * t379 + (t87 * t378 + t88 * dw6_z);
        let t387 = c5 * dw6_z - s5 * t378;
        let t388 = t184 - t181;
        put(6, t384); // row 1, ZZ
        put(16, t387); // row 2, ZZ
        put(26, t387); // row 3, ZZ
        put(36, t387); // row 4, ZZ
        put(46, t379); // row 5, ZZ
        put(55, t388); // row 6, XY
        t388
    };
    // payload: column XY
    {
        let t391 = s6 * t186 - c6 * t185;
        let t394 = s6 * t185 + c6 * t186;
        let t399 = t52 * t394 + (t88 * t388 - t87 * t391);
        let t402 = s5 * t391 + c5 * t388;
        put(7, t399); // row 1, XY
        put(17, t402); // row 2, XY
        put(27, t402); // row 3, XY
        put(37, t402); // row 4, XY
        put(47, t394); // row 5, XY
    }
    // payload: column XZ
    let t415 = {
        let t404 = t229 + s6 * t180;
        let t406 = c6 * t180 - t226;
        let t411 = t52 * t406 + (t88 * t170 - t87 * t404);
        let t414 = s5 * t404 + c5 * t170;
        let t415 = t184 - t123;
        put(8, t411); // row 1, XZ
        put(18, t414); // row 2, XZ
        put(28, t414); // row 3, XZ
        put(38, t414); // row 4, XZ
        put(48, t406); // row 5, XZ
        t415
    };
    // payload: column YZ
    {
        let t417 = t273 + c6 * t415;
        let t419 = s6 * t415 - t270;
        let t424 = t52 * t419 + (t87 * t417 + t88 * t167);
        let t427 = c5 * t167 - s5 * t417;
        put(9, t424); // row 1, YZ
        put(19, t427); // row 2, YZ
        put(29, t427); // row 3, YZ
        put(39, t427); // row 4, YZ
        put(49, t419); // row 5, YZ
    }
}
