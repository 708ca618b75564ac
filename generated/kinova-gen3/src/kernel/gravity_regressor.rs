//! Regressor at rest.
//!
//! `g = W_g phi` for the links' parameters only; columns as the first of `STANDARD_NAMES`.
//!
//! 283 multiplications, 166 additions; 7 x 70, 94 of 490 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 94;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 10), (0, 13), (0, 20), (0, 21), (0, 22), (0, 23), (0, 30), (0, 31), (0, 32), (0, 33),
    (0, 40), (0, 41), (0, 42), (0, 43), (0, 50), (0, 51), (0, 52), (0, 53), (0, 60), (0, 61),
    (0, 62), (0, 63), (1, 11), (1, 12), (1, 20), (1, 21), (1, 22), (1, 23), (1, 30), (1, 31),
    (1, 32), (1, 33), (1, 40), (1, 41), (1, 42), (1, 43), (1, 50), (1, 51), (1, 52), (1, 53),
    (1, 60), (1, 61), (1, 62), (1, 63), (2, 21), (2, 22), (2, 30), (2, 31), (2, 32), (2, 33),
    (2, 40), (2, 41), (2, 42), (2, 43), (2, 50), (2, 51), (2, 52), (2, 53), (2, 60), (2, 61),
    (2, 62), (2, 63), (3, 31), (3, 32), (3, 40), (3, 41), (3, 42), (3, 43), (3, 50), (3, 51),
    (3, 52), (3, 53), (3, 60), (3, 61), (3, 62), (3, 63), (4, 41), (4, 42), (4, 50), (4, 51),
    (4, 52), (4, 53), (4, 60), (4, 61), (4, 62), (4, 63), (5, 51), (5, 52), (5, 60), (5, 61),
    (5, 62), (5, 63), (6, 61), (6, 62),
];

/// Regressor at rest: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 70]; 7]) {
    let flat = &mut out.as_flattened_mut()[..];
    flat[0..10].fill(S::default());
    flat[11..13].fill(S::default());
    flat[14..20].fill(S::default());
    flat[24..30].fill(S::default());
    flat[34..40].fill(S::default());
    flat[44..50].fill(S::default());
    flat[54..60].fill(S::default());
    flat[64..81].fill(S::default());
    flat[83..90].fill(S::default());
    flat[94..100].fill(S::default());
    flat[104..110].fill(S::default());
    flat[114..120].fill(S::default());
    flat[124..130].fill(S::default());
    flat[134..161].fill(S::default());
    flat[163..170].fill(S::default());
    flat[174..180].fill(S::default());
    flat[184..190].fill(S::default());
    flat[194..200].fill(S::default());
    flat[204..241].fill(S::default());
    flat[243..250].fill(S::default());
    flat[254..260].fill(S::default());
    flat[264..270].fill(S::default());
    flat[274..321].fill(S::default());
    flat[323..330].fill(S::default());
    flat[334..340].fill(S::default());
    flat[344..401].fill(S::default());
    flat[403..410].fill(S::default());
    flat[414..481].fill(S::default());
    flat[483..490].fill(S::default());
    nonzeros(trig, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 70]; 7]) {
    entries(trig, |k, x| {
        out[PATTERN[k].0][PATTERN[k].1] = x;
    });
}

/// The same, only the entries of [`PATTERN`].
#[inline]
pub fn packed<S: Scalar>(trig: &Trig<S>, out: &mut [S; NONZEROS]) {
    entries(trig, |k, x| out[k] = x);
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let k0 = S::constant(9.81);
    let k1 = S::constant(0.01175);
    let k2 = S::constant(0.42076);
    let k3 = S::constant(0.01275);
    let k4 = S::constant(0.31436);
    let k5 = S::constant(0.00035);
    let k6 = S::constant(0.167455);
    // link 2: motion
    let [t0, t1] = {
        let t0 = s2 * k0;
        let t1 = c2 * k0;
        put(23, t0); // row 2, MSY2
        [t0, t1]
    };
    // link 3: motion
    let [z1_3_x, z1_4_z, t4, a3_y] = {
        let z1_3_x = s2 * c3;
        let z1_4_z = s2 * s3;
        let t4 = c3 * t0;
        let a3_y = s3 * t0;
        put(44, a3_y); // row 3, MSX3
        put(45, t4); // row 3, MSY3
        [z1_3_x, z1_4_z, t4, a3_y]
    };
    // link 4: motion
    let [t8, a4_y] = {
        let t8 = c4 * t4 + s4 * t1;
        let a4_y = s4 * t4 - c4 * t1;
        put(62, a4_y); // row 4, MSX4
        put(63, t8); // row 4, MSY4
        [t8, a4_y]
    };
    // link 5: motion
    let [t14, a5_y] = {
        let t14 = c5 * t8 - s5 * a3_y;
        let a5_y = c5 * a3_y + s5 * t8;
        put(76, a5_y); // row 5, MSX5
        put(77, t14); // row 5, MSY5
        [t14, a5_y]
    };
    // link 6: motion
    let [t20, a6_y] = {
        let t20 = c6 * t14 - s6 * a4_y;
        let a6_y = c6 * a4_y + s6 * t14;
        put(86, a6_y); // row 6, MSX6
        put(87, t20); // row 6, MSY6
        [t20, a6_y]
    };
    // link 7: motion
    let [t26, a7_y] = {
        let t26 = c7 * t20 - s7 * a5_y;
        let a7_y = c7 * a5_y + s7 * t20;
        put(92, a7_y); // row 7, MSX7
        put(93, t26); // row 7, MSY7
        [t26, a7_y]
    };
    // joint axes in frame 2
    let [t30, v1_2_y] = {
        let t30 = c2 * k1;
        let v1_2_y = s2 * k1;
        [t30, v1_2_y]
    };
    // joint axes in frame 3
    let [t35, v1_3_y, v2_3_x, v2_4_z] = {
        let t32 = s2 * k2;
        let t35 = c3 * t30 - s3 * t32;
        let v1_3_y = c3 * t32 + s3 * t30;
        let v2_3_x = c3 * k2;
        let v2_4_z = s3 * k2;
        [t35, v1_3_y, v2_3_x, v2_4_z]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, t47, z2_4_y, t49, t50, t53, t56] = {
        let z1_4_x = c4 * z1_3_x + c2 * s4;
        let z1_4_y = c2 * c4 - s4 * z1_3_x;
        let t47 = s3 * c4;
        let z2_4_y = s3 * s4;
        let t49 = c4 * v2_3_x;
        let t50 = s4 * v2_3_x;
        let t53 = s4 * v1_2_y - c4 * t35;
        let t56 = c4 * v1_2_y + s4 * t35;
        [z1_4_x, z1_4_y, t47, z2_4_y, t49, t50, t53, t56]
    };
    // MSZ2: column
    let t59 = {
        let t59 = c2 * t0 - s2 * t1;
        let t60 = k1 * t59;
        put(0, t60); // row 1, M2
        t59
    };
    // M3: column
    let [t62, t67, t68] = {
        let t62 = a3_y * v1_3_y;
        let t65 = t4 * t35 + t62 - t1 * v1_2_y;
        let t67 = a3_y * v2_4_z;
        let t68 = t4 * v2_3_x + t67;
        put(2, t65); // row 1, M3
        [t62, t67, t68]
    };
    // MSX3: column
    let t72 = {
        let t71 = c2 * a3_y - t1 * z1_4_z;
        let t72 = c3 * t1;
        put(3, t71); // row 1, MSX3
        t72
    };
    // MSY3: column
    {
        let t75 = c2 * t4 - t1 * z1_3_x;
        let t76 = s3 * t1;
        put(4, t75); // row 1, MSY3
        put(26, t76); // row 2, MSY3
    }
    // MSZ3: column
    {
        let t79 = z1_4_z * t4 - z1_3_x * a3_y;
        let t82 = s3 * a3_y + c3 * t4;
        put(5, t79); // row 1, MSZ3
        put(27, t82); // row 2, MSZ3
    }
    // M4: column
    let [t85, t88] = {
        let t85 = c4 * t8 + s4 * a4_y;
        let t88 = s4 * t8 - c4 * a4_y;
        let t89 = k3 * t88;
        let t90 = k3 * t85;
        let t98 = t62 + t35 * t85 - v1_2_y * t88 - (z1_3_x * t89 - c2 * t90);
        let t102 = s3 * t89 - (t67 + v2_3_x * t85);
        put(6, t98); // row 1, M4
        put(28, t102); // row 2, M4
        put(46, t90); // row 3, M4
        [t85, t88]
    };
    // MSX4: column
    let [t103, t104] = {
        let t103 = s4 * a3_y;
        let t104 = c4 * a3_y;
        let t109 = c2 * t104 + (z1_4_z * a4_y - z1_3_x * t103);
        let t112 = s3 * t103 + c3 * a4_y;
        put(7, t109); // row 1, MSX4
        put(29, t112); // row 2, MSX4
        put(47, t104); // row 3, MSX4
        [t103, t104]
    };
    // MSY4: column
    {
        let t117 = z1_4_z * t8 - z1_3_x * t104 - c2 * t103;
        let t120 = s3 * t104 + c3 * t8;
        put(8, t117); // row 1, MSY4
        put(30, t120); // row 2, MSY4
    }
    // MSZ4: column
    let t124 = {
        let t123 = z1_3_x * t88 - c2 * t85;
        let t124 = s3 * t88;
        put(9, t123); // row 1, MSZ4
        t124
    };
    // M5: column
    let [t126, t127, t129, t130, t132] = {
        let t126 = s5 * a5_y;
        let t127 = c5 * t14 + t126;
        let t129 = c5 * a5_y;
        let t130 = s5 * t14 - t129;
        let t132 = k4 * t127;
        let t134 = k3 * t127;
        let t135 = a4_y * k3 - k4 * t130;
        let t140 = z1_4_z * t132 - (z1_4_x * t135 + z1_4_y * t134);
        let t146 = a4_y * t56 - t53 * t127 - v1_3_y * t130 - t140;
        let t151 = c3 * t132 + (t47 * t135 - z2_4_y * t134);
        let t157 = v2_4_z * t130 - (t49 * t127 + a4_y * t50) - t151;
        let t160 = s4 * t135 + c4 * t134;
        put(10, t146); // row 1, M5
        put(32, t157); // row 2, M5
        put(50, t160); // row 3, M5
        put(67, t127); // row 4, MSZ5
        [t126, t127, t129, t130, t132]
    };
    // MSX5: column
    let [t161, t162] = {
        let t161 = s5 * a4_y;
        let t162 = c5 * a4_y;
        let t167 = z1_4_z * t162 + (z1_4_x * t161 + a5_y * z1_4_y);
        let t172 = c3 * t162 - (t47 * t161 - a5_y * z2_4_y);
        let t175 = s4 * t161 + c4 * a5_y;
        put(11, t167); // row 1, MSX5
        put(33, t172); // row 2, MSX5
        put(51, t175); // row 3, MSX5
        put(65, t162); // row 4, MSX5
        [t161, t162]
    };
    // MSY5: column
    {
        let t180 = z1_4_x * t162 + t14 * z1_4_y - z1_4_z * t161;
        let t185 = t14 * z2_4_y - t47 * t162 - c3 * t161;
        let t188 = s4 * t162 + c4 * t14;
        put(12, t180); // row 1, MSY5
        put(34, t185); // row 2, MSY5
        put(52, t188); // row 3, MSY5
    }
    // MSZ5: column
    {
        let t191 = z1_4_x * t130 + z1_4_z * t127;
        let t194 = c3 * t127 - t47 * t130;
        let t195 = s4 * t130;
        put(13, t191); // row 1, MSZ5
        put(35, t194); // row 2, MSZ5
        put(53, t195); // row 3, MSZ5
    }
    // M6: column
    let [t197, t198, t200, t201, t213] = {
        let t197 = s6 * a6_y;
        let t198 = c6 * t20 + t197;
        let t200 = c6 * a6_y;
        let t201 = t200 - s6 * t20;
        let t202 = k5 * t201;
        let t203 = k5 * t198;
        let t205 = t126 + c5 * t198;
        let t207 = s5 * t198 - t129;
        let t213 = s5 * t202 + k4 * t205;
        let t216 = c5 * t202 - k4 * t207 + k3 * t201;
        let t217 = t203 + k3 * t205;
        let t227 = t56 * t201 - t53 * t205 - v1_3_y * t207;
        let t228 = z1_4_x * t216 + z1_4_y * t217 - z1_4_z * t213 + t227;
        let t238 = v2_4_z * t207 - (t49 * t205 + t50 * t201);
        let t239 = z2_4_y * t217 - t47 * t216 - c3 * t213 + t238;
        let t242 = s4 * t216 + c4 * t217;
        put(14, t228); // row 1, M6
        put(36, t239); // row 2, M6
        put(54, t242); // row 3, M6
        put(78, t203); // row 5, M6
        [t197, t198, t200, t201, t213]
    };
    // MSX6: column
    let [t243, t244] = {
        let t243 = s6 * a5_y;
        let t244 = c6 * a5_y;
        let t247 = s5 * a6_y - c5 * t243;
        let t250 = s5 * t243 + c5 * a6_y;
        let t255 = z1_4_z * t250 + (z1_4_x * t247 + z1_4_y * t244);
        let t260 = c3 * t250 + (z2_4_y * t244 - t47 * t247);
        let t263 = s4 * t247 + c4 * t244;
        put(15, t255); // row 1, MSX6
        put(37, t260); // row 2, MSX6
        put(55, t263); // row 3, MSX6
        put(69, t250); // row 4, MSX6
        put(79, t244); // row 5, MSX6
        [t243, t244]
    };
    // MSY6: column
    {
        let t266 = s5 * t20 - c5 * t244;
        let t269 = s5 * t244 + c5 * t20;
        let t274 = z1_4_z * t269 + (z1_4_x * t266 - z1_4_y * t243);
        let t279 = c3 * t269 - (t47 * t266 + z2_4_y * t243);
        let t282 = s4 * t266 - c4 * t243;
        put(16, t274); // row 1, MSY6
        put(38, t279); // row 2, MSY6
        put(56, t282); // row 3, MSY6
        put(70, t269); // row 4, MSY6
    }
    // MSZ6: column
    let t297 = {
        let t283 = c5 * t201;
        let t284 = s5 * t201;
        let t289 = z1_4_z * t284 - (z1_4_x * t283 + z1_4_y * t198);
        let t294 = c3 * t284 - (z2_4_y * t198 - t47 * t283);
        let t297 = s4 * t283 + c4 * t198;
        put(17, t289); // row 1, MSZ6
        put(39, t294); // row 2, MSZ6
        put(71, t284); // row 4, MSZ6
        t297
    };
    // M7: column
    let [t300, t303, t305] = {
        let t300 = c7 * t26 + s7 * a7_y;
        let t303 = s7 * t26 - c7 * a7_y;
        let t304 = k6 * t303;
        let t305 = k6 * t300;
        let t307 = t197 + c6 * t300;
        let t309 = t200 - s6 * t300;
        let t314 = k5 * t309 - c6 * t304;
        let t315 = k5 * t307 - s6 * t304;
        let t318 = s5 * t303 - c5 * t307;
        let t321 = s5 * t307 + c5 * t303;
        let t331 = k4 * t318 - (s5 * t314 + c5 * t305);
        let t334 = s5 * t305 - c5 * t314 + k4 * t321 - k3 * t309;
        let t335 = t315 - k3 * t318;
        let t345 = t53 * t318 + t56 * t309 - v1_3_y * t321;
        let t346 = z1_4_z * t331 + (z1_4_y * t335 - z1_4_x * t334) + t345;
        let t356 = v2_4_z * t321 + (t49 * t318 - t50 * t309);
        let t357 = c3 * t331 + (t47 * t334 + z2_4_y * t335) + t356;
        let t360 = c4 * t335 - s4 * t334;
        put(18, t346); // row 1, M7
        put(40, t357); // row 2, M7
        put(58, t360); // row 3, M7
        put(72, t331); // row 4, M7
        put(82, t315); // row 5, M7
        put(91, t300); // row 6, MSZ7
        [t300, t303, t305]
    };
    // MSX7: column
    let [t361, t362] = {
        let t361 = s7 * a6_y;
        let t362 = c7 * a6_y;
        let t365 = s6 * a7_y - c6 * t361;
        let t368 = s6 * t361 + c6 * a7_y;
        let t371 = c5 * t365 - s5 * t362;
        let t374 = s5 * t365 + c5 * t362;
        let t379 = z1_4_z * t374 + (z1_4_y * t368 - z1_4_x * t371);
        let t384 = c3 * t374 + (t47 * t371 + z2_4_y * t368);
        let t387 = c4 * t368 - s4 * t371;
        put(19, t379); // row 1, MSX7
        put(41, t384); // row 2, MSX7
        put(59, t387); // row 3, MSX7
        put(73, t374); // row 4, MSX7
        put(83, t368); // row 5, MSX7
        put(89, t362); // row 6, MSX7
        [t361, t362]
    };
    // MSY7: column
    {
        let t390 = s6 * t26 - c6 * t362;
        let t393 = s6 * t362 + c6 * t26;
        let t396 = c5 * t390 + s5 * t361;
        let t399 = s5 * t390 - c5 * t361;
        let t404 = z1_4_z * t399 - (z1_4_x * t396 - z1_4_y * t393);
        let t409 = c3 * t399 + (t47 * t396 + z2_4_y * t393);
        let t412 = c4 * t393 - s4 * t396;
        put(20, t404); // row 1, MSY7
        put(42, t409); // row 2, MSY7
        put(60, t412); // row 3, MSY7
        put(74, t399); // row 4, MSY7
        put(84, t393); // row 5, MSY7
    }
    // MSZ7: column
    {
        let t413 = c6 * t303;
        let t414 = s6 * t303;
        let t417 = c5 * t413 + s5 * t300;
        let t420 = c5 * t300 - s5 * t413;
        let t425 = z1_4_z * t420 + (z1_4_x * t417 + z1_4_y * t414);
        let t430 = c3 * t420 - (t47 * t417 - z2_4_y * t414);
        let t433 = s4 * t417 + c4 * t414;
        let t434 = -t59;
        let t435 = -t1;
        let t436 = -t68;
        let t437 = -t72;
        let t438 = -t124;
        let t439 = -t103;
        let t440 = -t85;
        let t441 = -t297;
        let t442 = -t132;
        let t443 = -t161;
        let t444 = -t213;
        let t445 = -t243;
        let t446 = -t198;
        let t447 = -t305;
        let t448 = -t361;
        put(1, t434); // row 1, MSZ2
        put(21, t425); // row 1, MSZ7
        put(22, t435); // row 2, MSX2
        put(24, t436); // row 2, M3
        put(25, t437); // row 2, MSX3
        put(31, t438); // row 2, MSZ4
        put(43, t430); // row 2, MSZ7
        put(48, t439); // row 3, MSY4
        put(49, t440); // row 3, MSZ4
        put(57, t441); // row 3, MSZ6
        put(61, t433); // row 3, MSZ7
        put(64, t442); // row 4, M5
        put(66, t443); // row 4, MSY5
        put(68, t444); // row 4, M6
        put(75, t420); // row 4, MSZ7
        put(80, t445); // row 5, MSY6
        put(81, t446); // row 5, MSZ6
        put(85, t414); // row 5, MSZ7
        put(88, t447); // row 6, M7
        put(90, t448); // row 6, MSY7
    }
}
