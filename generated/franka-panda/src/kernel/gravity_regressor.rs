//! Regressor at rest.
//!
//! `g = W_g phi` for the links' parameters only; columns as the first of `STANDARD_NAMES`.
//!
//! 259 multiplications, 155 additions; 7 x 70, 92 of 490 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 92;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 13), (0, 20), (0, 21), (0, 22), (0, 23), (0, 30), (0, 31), (0, 32), (0, 33), (0, 40),
    (0, 41), (0, 42), (0, 43), (0, 50), (0, 51), (0, 52), (0, 53), (0, 60), (0, 61), (0, 62),
    (0, 63), (1, 11), (1, 12), (1, 20), (1, 21), (1, 22), (1, 23), (1, 30), (1, 31), (1, 32),
    (1, 33), (1, 40), (1, 41), (1, 42), (1, 43), (1, 50), (1, 51), (1, 52), (1, 53), (1, 60),
    (1, 61), (1, 62), (1, 63), (2, 21), (2, 22), (2, 30), (2, 31), (2, 32), (2, 33), (2, 40),
    (2, 41), (2, 42), (2, 43), (2, 50), (2, 51), (2, 52), (2, 53), (2, 60), (2, 61), (2, 62),
    (2, 63), (3, 31), (3, 32), (3, 40), (3, 41), (3, 42), (3, 43), (3, 50), (3, 51), (3, 52),
    (3, 53), (3, 60), (3, 61), (3, 62), (3, 63), (4, 41), (4, 42), (4, 51), (4, 52), (4, 53),
    (4, 60), (4, 61), (4, 62), (4, 63), (5, 51), (5, 52), (5, 60), (5, 61), (5, 62), (5, 63),
    (6, 61), (6, 62),
];

/// Regressor at rest: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 70]; 7]) {
    let flat = &mut out.as_flattened_mut()[..];
    flat[0..13].fill(S::default());
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
    flat[323..331].fill(S::default());
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
    let A = S::constant(0.0825);
    let L2 = S::constant(0.316);
    let L3 = S::constant(0.384);
    let k0 = S::constant(9.81);
    let k4 = S::constant(0.088);
    // link 2: motion
    let [t0, a3_z] = {
        let t0 = s2 * k0;
        let a3_z = c2 * k0;
        put(22, t0); // row 2, MSY2
        [t0, a3_z]
    };
    // link 3: motion
    let [t2, z1_3_y, t4, a3_y] = {
        let t2 = s2 * c3;
        let z1_3_y = s2 * s3;
        let t4 = c3 * t0;
        let a3_y = s3 * t0;
        put(43, a3_y); // row 3, MSX3
        put(44, t4); // row 3, MSY3
        [t2, z1_3_y, t4, a3_y]
    };
    // link 4: motion
    let [t8, a4_y] = {
        let t8 = c4 * t4 - s4 * a3_z;
        let a4_y = c4 * a3_z + s4 * t4;
        put(61, a4_y); // row 4, MSX4
        put(62, t8); // row 4, MSY4
        [t8, a4_y]
    };
    // link 5: motion
    let [t14, a5_y] = {
        let t14 = c5 * t8 - s5 * a3_y;
        let a5_y = c5 * a3_y + s5 * t8;
        put(75, a5_y); // row 5, MSX5
        put(76, t14); // row 5, MSY5
        [t14, a5_y]
    };
    // link 6: motion
    let [t20, a6_y] = {
        let t20 = c6 * t14 - s6 * a4_y;
        let a6_y = c6 * a4_y + s6 * t14;
        put(84, a6_y); // row 6, MSX6
        put(85, t20); // row 6, MSY6
        [t20, a6_y]
    };
    // link 7: motion
    let [t26, t29] = {
        let t26 = c7 * t20 + s7 * a5_y;
        let t29 = c7 * a5_y - s7 * t20;
        put(91, t26); // row 7, MSY7
        [t26, t29]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, z2_4_x, t37] = {
        let z1_4_x = c2 * s4 - c4 * t2;
        let z1_4_y = c2 * c4 + s4 * t2;
        let z2_4_x = s3 * c4;
        let t37 = s3 * s4;
        [z1_4_x, z1_4_y, z2_4_x, t37]
    };
    // joint axes in frame 5
    let t38 = {
        let t38 = c4 * A;
        t38
    };
    // MSZ2: column
    {
        let t41 = c2 * t0 - s2 * a3_z;
        put(0, t41); // row 1, MSZ2
    }
    // M3: column
    let [t49, t52] = {
        let t42 = L2 * a3_y;
        let t43 = L2 * t4;
        let t46 = t2 * t42 - z1_3_y * t43;
        let t49 = s3 * t42 + c3 * t43;
        let t52 = c3 * t4 + s3 * a3_y;
        put(1, t46); // row 1, M3
        [t49, t52]
    };
    // MSX3: column
    let t56 = {
        let t55 = c2 * a3_y - a3_z * z1_3_y;
        let t56 = c3 * a3_z;
        put(2, t55); // row 1, MSX3
        t56
    };
    // MSY3: column
    {
        let t59 = c2 * t4 - a3_z * t2;
        let t60 = s3 * a3_z;
        put(3, t59); // row 1, MSY3
        put(25, t60); // row 2, MSY3
    }
    // MSZ3: column
    {
        let t63 = t2 * a3_y - z1_3_y * t4;
        put(4, t63); // row 1, MSZ3
    }
    // M4: column
    let [t65, t68, t71] = {
        let t65 = t38 + L2 * s4;
        let t68 = s4 * A - L2 * c4;
        let t69 = a3_y * t68;
        let t70 = a3_y * t65;
        let t71 = a4_y * t65;
        let t73 = t8 * t68 - t71;
        let t78 = z1_3_y * t73 + (z1_4_x * t69 + z1_4_y * t70);
        let t83 = c3 * t73 + (z2_4_x * t69 - t37 * t70);
        let t84 = A * a3_y;
        put(5, t78); // row 1, M4
        put(27, t83); // row 2, M4
        put(45, t84); // row 3, M4
        [t65, t68, t71]
    };
    // MSX4: column
    let t90 = {
        let t87 = a3_y * z1_4_y - z1_3_y * a4_y;
        let t90 = a3_y * t37 + c3 * a4_y;
        let t91 = c4 * a3_y;
        put(6, t87); // row 1, MSX4
        put(46, t91); // row 3, MSX4
        t90
    };
    // MSY4: column
    let [t94, t97, t98] = {
        let t94 = a3_y * z1_4_x + z1_3_y * t8;
        let t97 = a3_y * z2_4_x + c3 * t8;
        let t98 = s4 * a3_y;
        [t94, t97, t98]
    };
    // MSZ4: column
    let [t101, t107] = {
        let t101 = a4_y * z1_4_x + t8 * z1_4_y;
        let t104 = t8 * t37 - a4_y * z2_4_x;
        let t107 = s4 * a4_y + c4 * t8;
        put(30, t104); // row 2, MSZ4
        [t101, t107]
    };
    // M5: column
    let [t109, t110, t112, t113] = {
        let t109 = s5 * a5_y;
        let t110 = c5 * t14 + t109;
        let t112 = c5 * a5_y;
        let t113 = s5 * t14 - t112;
        let t114 = L3 * t113;
        let t117 = L3 * t110 - A * a4_y;
        let t118 = A * t113;
        let t123 = t68 * t113 - t114;
        let t124 = t65 * t113 - t118;
        let t125 = t68 * t110 - t71 - t117;
        let t130 = z1_3_y * t125 - (z1_4_x * t123 + z1_4_y * t124);
        let t135 = c3 * t125 + (t37 * t124 - z2_4_x * t123);
        let t139 = s4 * t114 + c4 * t118 - t118;
        put(9, t130); // row 1, M5
        put(31, t135); // row 2, M5
        put(49, t139); // row 3, M5
        put(63, t117); // row 4, M5
        put(66, t110); // row 4, MSZ5
        [t109, t110, t112, t113]
    };
    // MSX5: column
    let [t140, t141] = {
        let t140 = s5 * a4_y;
        let t141 = c5 * a4_y;
        let t146 = z1_4_x * t140 + a5_y * z1_4_y - z1_3_y * t141;
        let t151 = z2_4_x * t140 - a5_y * t37 - c3 * t141;
        let t154 = s4 * t140 + c4 * a5_y;
        put(10, t146); // row 1, MSX5
        put(32, t151); // row 2, MSX5
        put(50, t154); // row 3, MSX5
        put(64, t141); // row 4, MSX5
        [t140, t141]
    };
    // MSY5: column
    {
        let t159 = z1_3_y * t140 + (z1_4_x * t141 + t14 * z1_4_y);
        let t164 = c3 * t140 + (z2_4_x * t141 - t14 * t37);
        let t167 = s4 * t141 + c4 * t14;
        put(11, t159); // row 1, MSY5
        put(33, t164); // row 2, MSY5
        put(51, t167); // row 3, MSY5
    }
    // MSZ5: column
    {
        let t170 = z1_4_x * t113 - z1_3_y * t110;
        let t173 = z2_4_x * t113 - c3 * t110;
        let t174 = s4 * t113;
        put(12, t170); // row 1, MSZ5
        put(34, t173); // row 2, MSZ5
        put(52, t174); // row 3, MSZ5
    }
    // M6: column
    let [t176, t177, t179, t180] = {
        let t176 = s6 * a6_y;
        let t177 = c6 * t20 + t176;
        let t179 = c6 * a6_y;
        let t180 = s6 * t20 - t179;
        let t182 = t109 + c5 * t177;
        let t184 = t112 - s5 * t177;
        let t185 = L3 * t184;
        let t188 = L3 * t182 + A * t180;
        let t189 = A * t184;
        let t195 = t68 * t184 - t185;
        let t196 = t65 * t184 - t189;
        let t197 = t65 * t180 + t68 * t182 - t188;
        let t202 = z1_3_y * t197 + (z1_4_x * t195 + z1_4_y * t196);
        let t207 = c3 * t197 + (z2_4_x * t195 - t37 * t196);
        let t211 = t189 - (s4 * t185 + c4 * t189);
        put(13, t202); // row 1, M6
        put(35, t207); // row 2, M6
        put(53, t211); // row 3, M6
        put(67, t188); // row 4, M6
        [t176, t177, t179, t180]
    };
    // MSX6: column
    let [t212, t213] = {
        let t212 = s6 * a5_y;
        let t213 = c6 * a5_y;
        let t216 = s5 * a6_y - c5 * t212;
        let t219 = s5 * t212 + c5 * a6_y;
        let t224 = z1_4_x * t216 + z1_4_y * t213 - z1_3_y * t219;
        let t229 = z2_4_x * t216 - t37 * t213 - c3 * t219;
        let t232 = s4 * t216 + c4 * t213;
        put(14, t224); // row 1, MSX6
        put(36, t229); // row 2, MSX6
        put(54, t232); // row 3, MSX6
        put(68, t219); // row 4, MSX6
        put(77, t213); // row 5, MSX6
        [t212, t213]
    };
    // MSY6: column
    {
        let t235 = s5 * t20 - c5 * t213;
        let t238 = s5 * t213 + c5 * t20;
        let t243 = z1_4_x * t235 - z1_4_y * t212 - z1_3_y * t238;
        let t248 = z2_4_x * t235 + t37 * t212 - c3 * t238;
        let t251 = s4 * t235 - c4 * t212;
        put(15, t243); // row 1, MSY6
        put(37, t248); // row 2, MSY6
        put(55, t251); // row 3, MSY6
        put(69, t238); // row 4, MSY6
    }
    // MSZ6: column
    let t253 = {
        let t252 = c5 * t180;
        let t253 = s5 * t180;
        let t258 = z1_3_y * t253 + (z1_4_x * t252 - z1_4_y * t177);
        let t263 = c3 * t253 + (z2_4_x * t252 + t37 * t177);
        let t266 = s4 * t252 - c4 * t177;
        put(16, t258); // row 1, MSZ6
        put(38, t263); // row 2, MSZ6
        put(56, t266); // row 3, MSZ6
        t253
    };
    // M7: column
    let [t269, t272] = {
        let t269 = s7 * t29 - c7 * t26;
        let t272 = s7 * t26 + c7 * t29;
        let t273 = k4 * a6_y;
        let t274 = k4 * t272;
        let t276 = t176 - c6 * t269;
        let t278 = t179 + s6 * t269;
        let t279 = s6 * t274;
        let t280 = c6 * t274;
        let t283 = c5 * t276 + s5 * t272;
        let t286 = c5 * t272 - s5 * t276;
        let t297 = A * t286;
        let t298 = c5 * t279 - s5 * t273 + L3 * t286;
        let t299 = s5 * t279 + c5 * t273 - (A * t278 - L3 * t283);
        let t300 = t297 - t280;
        let t306 = t298 - t68 * t286;
        let t307 = t65 * t286 - t300;
        let t308 = t68 * t283 - t65 * t278 - t299;
        let t313 = z1_3_y * t308 + (z1_4_y * t307 - z1_4_x * t306);
        let t318 = c3 * t308 - (z2_4_x * t306 + t37 * t307);
        let t322 = t297 - (s4 * t298 + c4 * t300);
        put(17, t313); // row 1, M7
        put(39, t318); // row 2, M7
        put(57, t322); // row 3, M7
        put(71, t299); // row 4, M7
        put(80, t280); // row 5, M7
        put(86, t273); // row 6, M7
        put(89, t269); // row 6, MSZ7
        [t269, t272]
    };
    // MSX7: column
    let [t323, t324] = {
        let t323 = s7 * a6_y;
        let t324 = c7 * a6_y;
        let t327 = c6 * t323 + s6 * t29;
        let t330 = c6 * t29 - s6 * t323;
        let t333 = s5 * t324 - c5 * t327;
        let t336 = s5 * t327 + c5 * t324;
        let t341 = z1_4_x * t333 + z1_4_y * t330 - z1_3_y * t336;
        let t346 = z2_4_x * t333 - t37 * t330 - c3 * t336;
        let t349 = s4 * t333 + c4 * t330;
        put(18, t341); // row 1, MSX7
        put(40, t346); // row 2, MSX7
        put(58, t349); // row 3, MSX7
        put(72, t336); // row 4, MSX7
        put(81, t330); // row 5, MSX7
        put(87, t324); // row 6, MSX7
        [t323, t324]
    };
    // MSY7: column
    let [t355, t361] = {
        let t352 = s6 * t26 - c6 * t324;
        let t355 = s6 * t324 + c6 * t26;
        let t358 = c5 * t352 - s5 * t323;
        let t361 = s5 * t352 + c5 * t323;
        let t366 = z1_3_y * t361 - (z1_4_y * t355 - z1_4_x * t358);
        let t371 = c3 * t361 + (z2_4_x * t358 + t37 * t355);
        let t374 = s4 * t358 - c4 * t355;
        put(19, t366); // row 1, MSY7
        put(41, t371); // row 2, MSY7
        put(59, t374); // row 3, MSY7
        [t355, t361]
    };
    // MSZ7: column
    {
        let t375 = c6 * t272;
        let t376 = s6 * t272;
        let t379 = c5 * t375 + s5 * t269;
        let t382 = c5 * t269 - s5 * t375;
        let t387 = z1_4_x * t379 + z1_4_y * t376 - z1_3_y * t382;
        let t392 = z2_4_x * t379 - t37 * t376 - c3 * t382;
        let t395 = s4 * t379 + c4 * t376;
        let t396 = -t94;
        let t397 = -t101;
        let t398 = -a3_z;
        let t399 = -t49;
        let t400 = -t56;
        let t401 = -t52;
        let t402 = -t90;
        let t403 = -t97;
        let t404 = -t98;
        let t405 = -t107;
        let t406 = -t140;
        let t407 = -t253;
        let t408 = -t361;
        let t409 = -t212;
        let t410 = -t177;
        let t411 = -t355;
        let t412 = -t323;
        let t413 = -t29;
        put(7, t396); // row 1, MSY4
        put(8, t397); // row 1, MSZ4
        put(20, t387); // row 1, MSZ7
        put(21, t398); // row 2, MSX2
        put(23, t399); // row 2, M3
        put(24, t400); // row 2, MSX3
        put(26, t401); // row 2, MSZ3
        put(28, t402); // row 2, MSX4
        put(29, t403); // row 2, MSY4
        put(42, t392); // row 2, MSZ7
        put(47, t404); // row 3, MSY4
        put(48, t405); // row 3, MSZ4
        put(60, t395); // row 3, MSZ7
        put(65, t406); // row 4, MSY5
        put(70, t407); // row 4, MSZ6
        put(73, t408); // row 4, MSY7
        put(74, t382); // row 4, MSZ7
        put(78, t409); // row 5, MSY6
        put(79, t410); // row 5, MSZ6
        put(82, t411); // row 5, MSY7
        put(83, t376); // row 5, MSZ7
        put(88, t412); // row 6, MSY7
        put(90, t413); // row 7, MSX7
    }
}
