//! Regressor at rest.
//!
//! `g = W_g phi` for the links' parameters only; columns as the first of `STANDARD_NAMES`.
//!
//! 255 multiplications, 153 additions; 7 x 70, 92 of 490 structurally nonzero.

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
    out.as_flattened_mut().fill(S::default());
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
    let [t2, a3_y] = {
        let t2 = c3 * t0;
        let a3_y = s3 * t0;
        put(43, a3_y); // row 3, MSX3
        put(44, t2); // row 3, MSY3
        [t2, a3_y]
    };
    // link 4: motion
    let [t6, a4_y] = {
        let t6 = c4 * t2 - s4 * a3_z;
        let a4_y = c4 * a3_z + s4 * t2;
        put(61, a4_y); // row 4, MSX4
        put(62, t6); // row 4, MSY4
        [t6, a4_y]
    };
    // link 5: motion
    let [t12, a5_y] = {
        let t12 = c5 * t6 - s5 * a3_y;
        let a5_y = c5 * a3_y + s5 * t6;
        put(75, a5_y); // row 5, MSX5
        put(76, t12); // row 5, MSY5
        [t12, a5_y]
    };
    // link 6: motion
    let [t18, a6_y] = {
        let t18 = c6 * t12 - s6 * a4_y;
        let a6_y = c6 * a4_y + s6 * t12;
        put(84, a6_y); // row 6, MSX6
        put(85, t18); // row 6, MSY6
        [t18, a6_y]
    };
    // link 7: motion
    let [t24, t27] = {
        let t24 = c7 * t18 + s7 * a5_y;
        let t27 = c7 * a5_y - s7 * t18;
        put(91, t24); // row 7, MSY7
        [t24, t27]
    };
    // joint axes in frame 3
    let [t28, z1_3_y] = {
        let t28 = s2 * c3;
        let z1_3_y = s2 * s3;
        [t28, z1_3_y]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, z2_4_x, t37] = {
        let z1_4_x = c2 * s4 - c4 * t28;
        let z1_4_y = c2 * c4 + s4 * t28;
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
    let t44 = {
        let t44 = c3 * t2 + s3 * a3_y;
        t44
    };
    // MSZ3: column
    let t49 = {
        let t47 = a3_y * t28 - t2 * z1_3_y;
        let t48 = L2 * t47;
        let t49 = L2 * t44;
        put(1, t48); // row 1, M3
        put(4, t47); // row 1, MSZ3
        t49
    };
    // MSX3: column
    let t53 = {
        let t52 = c2 * a3_y - a3_z * z1_3_y;
        let t53 = c3 * a3_z;
        put(2, t52); // row 1, MSX3
        t53
    };
    // MSY3: column
    {
        let t56 = c2 * t2 - a3_z * t28;
        let t57 = s3 * a3_z;
        put(3, t56); // row 1, MSY3
        put(25, t57); // row 2, MSY3
    }
    // M4: column
    let [t59, t62, t65] = {
        let t59 = t38 + L2 * s4;
        let t62 = s4 * A - L2 * c4;
        let t63 = a3_y * t62;
        let t64 = a3_y * t59;
        let t65 = a4_y * t59;
        let t67 = t6 * t62 - t65;
        let t72 = z1_3_y * t67 + (z1_4_x * t63 + z1_4_y * t64);
        let t77 = c3 * t67 + (z2_4_x * t63 - t37 * t64);
        let t78 = A * a3_y;
        put(5, t72); // row 1, M4
        put(27, t77); // row 2, M4
        put(45, t78); // row 3, M4
        [t59, t62, t65]
    };
    // MSX4: column
    let t84 = {
        let t81 = a3_y * z1_4_y - a4_y * z1_3_y;
        let t84 = a3_y * t37 + c3 * a4_y;
        let t85 = c4 * a3_y;
        put(6, t81); // row 1, MSX4
        put(46, t85); // row 3, MSX4
        t84
    };
    // MSY4: column
    let [t88, t91, t92] = {
        let t88 = a3_y * z1_4_x + t6 * z1_3_y;
        let t91 = a3_y * z2_4_x + c3 * t6;
        let t92 = s4 * a3_y;
        [t88, t91, t92]
    };
    // MSZ4: column
    let [t95, t101] = {
        let t95 = a4_y * z1_4_x + t6 * z1_4_y;
        let t98 = t6 * t37 - a4_y * z2_4_x;
        let t101 = s4 * a4_y + c4 * t6;
        put(30, t98); // row 2, MSZ4
        [t95, t101]
    };
    // M5: column
    let [t103, t104, t106, t107] = {
        let t103 = s5 * a5_y;
        let t104 = c5 * t12 + t103;
        let t106 = c5 * a5_y;
        let t107 = s5 * t12 - t106;
        let t108 = L3 * t107;
        let t111 = L3 * t104 - A * a4_y;
        let t112 = A * t107;
        let t117 = t108 - t62 * t107;
        let t118 = t112 - t59 * t107;
        let t119 = t62 * t104 - t65 - t111;
        let t124 = z1_3_y * t119 + (z1_4_x * t117 + z1_4_y * t118);
        let t129 = c3 * t119 - (t37 * t118 - z2_4_x * t117);
        let t133 = s4 * t108 + c4 * t112 - t112;
        put(9, t124); // row 1, M5
        put(31, t129); // row 2, M5
        put(49, t133); // row 3, M5
        put(63, t111); // row 4, M5
        put(66, t104); // row 4, MSZ5
        [t103, t104, t106, t107]
    };
    // MSX5: column
    let [t134, t135] = {
        let t134 = s5 * a4_y;
        let t135 = c5 * a4_y;
        let t140 = z1_4_x * t134 + a5_y * z1_4_y - z1_3_y * t135;
        let t145 = z2_4_x * t134 - a5_y * t37 - c3 * t135;
        let t148 = s4 * t134 + c4 * a5_y;
        put(10, t140); // row 1, MSX5
        put(32, t145); // row 2, MSX5
        put(50, t148); // row 3, MSX5
        put(64, t135); // row 4, MSX5
        [t134, t135]
    };
    // MSY5: column
    {
        let t153 = z1_3_y * t134 + (z1_4_x * t135 + t12 * z1_4_y);
        let t158 = c3 * t134 + (z2_4_x * t135 - t12 * t37);
        let t161 = s4 * t135 + c4 * t12;
        put(11, t153); // row 1, MSY5
        put(33, t158); // row 2, MSY5
        put(51, t161); // row 3, MSY5
    }
    // MSZ5: column
    {
        let t164 = z1_4_x * t107 - z1_3_y * t104;
        let t167 = z2_4_x * t107 - c3 * t104;
        let t168 = s4 * t107;
        put(12, t164); // row 1, MSZ5
        put(34, t167); // row 2, MSZ5
        put(52, t168); // row 3, MSZ5
    }
    // M6: column
    let [t170, t171, t173, t174] = {
        let t170 = s6 * a6_y;
        let t171 = c6 * t18 + t170;
        let t173 = c6 * a6_y;
        let t174 = s6 * t18 - t173;
        let t176 = t103 + c5 * t171;
        let t178 = t106 - s5 * t171;
        let t179 = L3 * t178;
        let t182 = L3 * t176 + A * t174;
        let t183 = A * t178;
        let t189 = t179 - t62 * t178;
        let t190 = t183 - t59 * t178;
        let t191 = t59 * t174 + t62 * t176 - t182;
        let t196 = z1_3_y * t191 - (z1_4_x * t189 + z1_4_y * t190);
        let t201 = c3 * t191 + (t37 * t190 - z2_4_x * t189);
        let t205 = t183 - (s4 * t179 + c4 * t183);
        put(13, t196); // row 1, M6
        put(35, t201); // row 2, M6
        put(53, t205); // row 3, M6
        put(67, t182); // row 4, M6
        [t170, t171, t173, t174]
    };
    // MSX6: column
    let [t206, t207] = {
        let t206 = s6 * a5_y;
        let t207 = c6 * a5_y;
        let t210 = s5 * a6_y - c5 * t206;
        let t213 = s5 * t206 + c5 * a6_y;
        let t218 = z1_4_x * t210 + z1_4_y * t207 - z1_3_y * t213;
        let t223 = z2_4_x * t210 - t37 * t207 - c3 * t213;
        let t226 = s4 * t210 + c4 * t207;
        put(14, t218); // row 1, MSX6
        put(36, t223); // row 2, MSX6
        put(54, t226); // row 3, MSX6
        put(68, t213); // row 4, MSX6
        put(77, t207); // row 5, MSX6
        [t206, t207]
    };
    // MSY6: column
    {
        let t229 = s5 * t18 - c5 * t207;
        let t232 = s5 * t207 + c5 * t18;
        let t237 = z1_4_x * t229 - z1_4_y * t206 - z1_3_y * t232;
        let t242 = z2_4_x * t229 + t37 * t206 - c3 * t232;
        let t245 = s4 * t229 - c4 * t206;
        put(15, t237); // row 1, MSY6
        put(37, t242); // row 2, MSY6
        put(55, t245); // row 3, MSY6
        put(69, t232); // row 4, MSY6
    }
    // MSZ6: column
    let t247 = {
        let t246 = c5 * t174;
        let t247 = s5 * t174;
        let t252 = z1_3_y * t247 - (z1_4_y * t171 - z1_4_x * t246);
        let t257 = c3 * t247 + (z2_4_x * t246 + t37 * t171);
        let t260 = s4 * t246 - c4 * t171;
        put(16, t252); // row 1, MSZ6
        put(38, t257); // row 2, MSZ6
        put(56, t260); // row 3, MSZ6
        t247
    };
    // M7: column
    let [t263, t266] = {
        let t263 = s7 * t27 - c7 * t24;
        let t266 = s7 * t24 + c7 * t27;
        let t267 = k4 * a6_y;
        let t268 = k4 * t266;
        let t270 = t170 - c6 * t263;
        let t272 = t173 + s6 * t263;
        let t273 = s6 * t268;
        let t274 = c6 * t268;
        let t277 = c5 * t270 + s5 * t266;
        let t280 = c5 * t266 - s5 * t270;
        let t291 = A * t280;
        let t292 = s5 * t267 - c5 * t273 - L3 * t280;
        let t293 = s5 * t273 + c5 * t267 - (A * t272 - L3 * t277);
        let t294 = t274 - t291;
        let t300 = t292 + t62 * t280;
        let t301 = t294 + t59 * t280;
        let t302 = t293 + (t59 * t272 - t62 * t277);
        let t307 = z1_4_x * t300 + z1_4_y * t301 - z1_3_y * t302;
        let t312 = z2_4_x * t300 - t37 * t301 - c3 * t302;
        let t316 = t291 + (s4 * t292 + c4 * t294);
        put(17, t307); // row 1, M7
        put(39, t312); // row 2, M7
        put(57, t316); // row 3, M7
        put(71, t293); // row 4, M7
        put(80, t274); // row 5, M7
        put(86, t267); // row 6, M7
        put(89, t263); // row 6, MSZ7
        [t263, t266]
    };
    // MSX7: column
    let [t317, t318] = {
        let t317 = s7 * a6_y;
        let t318 = c7 * a6_y;
        let t321 = c6 * t317 + s6 * t27;
        let t324 = c6 * t27 - s6 * t317;
        let t327 = s5 * t318 - c5 * t321;
        let t330 = s5 * t321 + c5 * t318;
        let t335 = z1_4_x * t327 + z1_4_y * t324 - z1_3_y * t330;
        let t340 = z2_4_x * t327 - t37 * t324 - c3 * t330;
        let t343 = s4 * t327 + c4 * t324;
        put(18, t335); // row 1, MSX7
        put(40, t340); // row 2, MSX7
        put(58, t343); // row 3, MSX7
        put(72, t330); // row 4, MSX7
        put(81, t324); // row 5, MSX7
        put(87, t318); // row 6, MSX7
        [t317, t318]
    };
    // MSY7: column
    let [t349, t355] = {
        let t346 = s6 * t24 - c6 * t318;
        let t349 = s6 * t318 + c6 * t24;
        let t352 = c5 * t346 - s5 * t317;
        let t355 = s5 * t346 + c5 * t317;
        let t360 = z1_3_y * t355 + (z1_4_x * t352 - z1_4_y * t349);
        let t365 = c3 * t355 + (z2_4_x * t352 + t37 * t349);
        let t368 = s4 * t352 - c4 * t349;
        put(19, t360); // row 1, MSY7
        put(41, t365); // row 2, MSY7
        put(59, t368); // row 3, MSY7
        [t349, t355]
    };
    // MSZ7: column
    {
        let t369 = c6 * t266;
        let t370 = s6 * t266;
        let t373 = c5 * t369 + s5 * t263;
        let t376 = c5 * t263 - s5 * t369;
        let t381 = z1_4_x * t373 + z1_4_y * t370 - z1_3_y * t376;
        let t386 = z2_4_x * t373 - t37 * t370 - c3 * t376;
        let t389 = s4 * t373 + c4 * t370;
        let t390 = -t88;
        let t391 = -t95;
        let t392 = -a3_z;
        let t393 = -t49;
        let t394 = -t53;
        let t395 = -t44;
        let t396 = -t84;
        let t397 = -t91;
        let t398 = -t92;
        let t399 = -t101;
        let t400 = -t134;
        let t401 = -t247;
        let t402 = -t355;
        let t403 = -t206;
        let t404 = -t171;
        let t405 = -t349;
        let t406 = -t317;
        let t407 = -t27;
        put(7, t390); // row 1, MSY4
        put(8, t391); // row 1, MSZ4
        put(20, t381); // row 1, MSZ7
        put(21, t392); // row 2, MSX2
        put(23, t393); // row 2, M3
        put(24, t394); // row 2, MSX3
        put(26, t395); // row 2, MSZ3
        put(28, t396); // row 2, MSX4
        put(29, t397); // row 2, MSY4
        put(42, t386); // row 2, MSZ7
        put(47, t398); // row 3, MSY4
        put(48, t399); // row 3, MSZ4
        put(60, t389); // row 3, MSZ7
        put(65, t400); // row 4, MSY5
        put(70, t401); // row 4, MSZ6
        put(73, t402); // row 4, MSY7
        put(74, t376); // row 4, MSZ7
        put(78, t403); // row 5, MSY6
        put(79, t404); // row 5, MSZ6
        put(82, t405); // row 5, MSY7
        put(83, t370); // row 5, MSZ7
        put(88, t406); // row 6, MSY7
        put(90, t407); // row 7, MSX7
    }
}
