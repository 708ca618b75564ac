//! Regressor at rest.
//!
//! `g = W_g phi` of the links' parameters; columns as the first of `STANDARD_NAMES`, without the
//! drives'.
//!
//! 259 multiplications, 155 additions; 7 x 70, 92 of 490 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{GRAVITY, Trig, constants};

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

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 70 + PATTERN[k].1
}

/// Regressor at rest: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 70]; 7]) {
    let flat = &mut out.as_flattened_mut()[..];
    clear(&mut flat[0..13]);
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[14..20]),
            4 => clear(&mut flat[24..30]),
            8 => clear(&mut flat[34..40]),
            12 => clear(&mut flat[44..50]),
            16 => clear(&mut flat[54..60]),
            20 => clear(&mut flat[64..81]),
            22 => clear(&mut flat[83..90]),
            26 => clear(&mut flat[94..100]),
            30 => clear(&mut flat[104..110]),
            34 => clear(&mut flat[114..120]),
            38 => clear(&mut flat[124..130]),
            42 => clear(&mut flat[134..161]),
            44 => clear(&mut flat[163..170]),
            48 => clear(&mut flat[174..180]),
            52 => clear(&mut flat[184..190]),
            56 => clear(&mut flat[194..200]),
            60 => clear(&mut flat[204..241]),
            62 => clear(&mut flat[243..250]),
            66 => clear(&mut flat[254..260]),
            70 => clear(&mut flat[264..270]),
            74 => clear(&mut flat[274..321]),
            76 => clear(&mut flat[323..331]),
            79 => clear(&mut flat[334..340]),
            83 => clear(&mut flat[344..401]),
            85 => clear(&mut flat[403..410]),
            89 => clear(&mut flat[414..481]),
            91 => clear(&mut flat[483..490]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
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
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let k0 = S::constant(-GRAVITY[2]);
    let k4 = S::constant(0.088);
    let k_A = S::constant(constants::A);
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
    // link 2: motion
    let [t0, a3_z] = {
        let t0 = s2 * k0;
        let a3_z = c2 * k0;
        let t2 = -a3_z;
        put(21, t2); // row 2, MSX2
        put(22, t0); // row 2, MSY2
        [t0, a3_z]
    };
    // link 3: motion
    let [t3, z1_3_y, t5, a3_y] = {
        let t3 = s2 * c3;
        let z1_3_y = s2 * s3;
        let t5 = c3 * t0;
        let a3_y = s3 * t0;
        put(43, a3_y); // row 3, MSX3
        put(44, t5); // row 3, MSY3
        [t3, z1_3_y, t5, a3_y]
    };
    // link 4: motion
    let [t9, a4_y] = {
        let t9 = c4 * t5 - s4 * a3_z;
        let a4_y = c4 * a3_z + s4 * t5;
        put(61, a4_y); // row 4, MSX4
        put(62, t9); // row 4, MSY4
        [t9, a4_y]
    };
    // link 5: motion
    let [t15, a5_y] = {
        let t15 = c5 * t9 - s5 * a3_y;
        let a5_y = c5 * a3_y + s5 * t9;
        put(75, a5_y); // row 5, MSX5
        put(76, t15); // row 5, MSY5
        [t15, a5_y]
    };
    // link 6: motion
    let [t21, a6_y] = {
        let t21 = c6 * t15 - s6 * a4_y;
        let a6_y = c6 * a4_y + s6 * t15;
        put(84, a6_y); // row 6, MSX6
        put(85, t21); // row 6, MSY6
        [t21, a6_y]
    };
    // link 7: motion
    let [t27, t30] = {
        let t27 = c7 * t21 + s7 * a5_y;
        let t30 = c7 * a5_y - s7 * t21;
        let t31 = -t30;
        put(90, t31); // row 7, MSX7
        put(91, t27); // row 7, MSY7
        [t27, t30]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, z2_4_x, t39] = {
        let z1_4_x = c2 * s4 - c4 * t3;
        let z1_4_y = c2 * c4 + s4 * t3;
        let z2_4_x = s3 * c4;
        let t39 = s3 * s4;
        [z1_4_x, z1_4_y, z2_4_x, t39]
    };
    // joint axes in frame 5
    let t40 = {
        let t40 = c4 * k_A;
        t40
    };
    // MSZ2: column
    {
        let t43 = c2 * t0 - s2 * a3_z;
        put(0, t43); // row 1, MSZ2
    }
    // M3: column
    {
        let t44 = k_L2 * a3_y;
        let t45 = k_L2 * t5;
        let t48 = t3 * t44 - z1_3_y * t45;
        let t55 = -(s3 * t44 + c3 * t45);
        let t56 = -(c3 * t5 + s3 * a3_y);
        put(1, t48); // row 1, M3
        put(23, t55); // row 2, M3
        put(26, t56); // row 2, MSZ3
    }
    // MSX3: column
    {
        let t59 = c2 * a3_y - a3_z * z1_3_y;
        let t61 = -(c3 * a3_z);
        put(2, t59); // row 1, MSX3
        put(24, t61); // row 2, MSX3
    }
    // MSY3: column
    {
        let t64 = c2 * t5 - a3_z * t3;
        let t65 = s3 * a3_z;
        put(3, t64); // row 1, MSY3
        put(25, t65); // row 2, MSY3
    }
    // MSZ3: column
    {
        let t68 = t3 * a3_y - z1_3_y * t5;
        put(4, t68); // row 1, MSZ3
    }
    // M4: column
    let [t70, t73, t76] = {
        let t70 = t40 + k_L2 * s4;
        let t73 = s4 * k_A - k_L2 * c4;
        let t74 = a3_y * t73;
        let t75 = a3_y * t70;
        let t76 = a4_y * t70;
        let t78 = t9 * t73 - t76;
        let t83 = z1_3_y * t78 + (z1_4_x * t74 + z1_4_y * t75);
        let t88 = c3 * t78 + (z2_4_x * t74 - t39 * t75);
        let t89 = k_A * a3_y;
        put(5, t83); // row 1, M4
        put(27, t88); // row 2, M4
        put(45, t89); // row 3, M4
        [t70, t73, t76]
    };
    // MSX4: column
    {
        let t92 = a3_y * z1_4_y - z1_3_y * a4_y;
        let t96 = c4 * a3_y;
        let t97 = -(a3_y * t39 + c3 * a4_y);
        put(6, t92); // row 1, MSX4
        put(28, t97); // row 2, MSX4
        put(46, t96); // row 3, MSX4
    }
    // MSY4: column
    {
        let t105 = -(a3_y * z1_4_x + z1_3_y * t9);
        let t106 = -(a3_y * z2_4_x + c3 * t9);
        let t107 = -(s4 * a3_y);
        put(7, t105); // row 1, MSY4
        put(29, t106); // row 2, MSY4
        put(47, t107); // row 3, MSY4
    }
    // MSZ4: column
    {
        let t113 = t9 * t39 - a4_y * z2_4_x;
        let t117 = -(a4_y * z1_4_x + t9 * z1_4_y);
        let t118 = -(s4 * a4_y + c4 * t9);
        put(8, t117); // row 1, MSZ4
        put(30, t113); // row 2, MSZ4
        put(48, t118); // row 3, MSZ4
    }
    // M5: column
    let [t120, t121, t123, t124] = {
        let t120 = s5 * a5_y;
        let t121 = c5 * t15 + t120;
        let t123 = c5 * a5_y;
        let t124 = s5 * t15 - t123;
        let t125 = k_L3 * t124;
        let t128 = k_L3 * t121 - k_A * a4_y;
        let t129 = k_A * t124;
        let t134 = t73 * t124 - t125;
        let t135 = t70 * t124 - t129;
        let t136 = t73 * t121 - t76 - t128;
        let t141 = z1_3_y * t136 - (z1_4_x * t134 + z1_4_y * t135);
        let t146 = c3 * t136 + (t39 * t135 - z2_4_x * t134);
        let t150 = s4 * t125 + c4 * t129 - t129;
        put(9, t141); // row 1, M5
        put(31, t146); // row 2, M5
        put(49, t150); // row 3, M5
        put(63, t128); // row 4, M5
        put(66, t121); // row 4, MSZ5
        [t120, t121, t123, t124]
    };
    // MSX5: column
    let [t151, t152] = {
        let t151 = s5 * a4_y;
        let t152 = c5 * a4_y;
        let t157 = z1_4_x * t151 + a5_y * z1_4_y - z1_3_y * t152;
        let t162 = z2_4_x * t151 - a5_y * t39 - c3 * t152;
        let t165 = s4 * t151 + c4 * a5_y;
        let t166 = -t151;
        put(10, t157); // row 1, MSX5
        put(32, t162); // row 2, MSX5
        put(50, t165); // row 3, MSX5
        put(64, t152); // row 4, MSX5
        put(65, t166); // row 4, MSY5
        [t151, t152]
    };
    // MSY5: column
    {
        let t171 = z1_3_y * t151 + (z1_4_x * t152 + t15 * z1_4_y);
        let t176 = c3 * t151 + (z2_4_x * t152 - t15 * t39);
        let t179 = s4 * t152 + c4 * t15;
        put(11, t171); // row 1, MSY5
        put(33, t176); // row 2, MSY5
        put(51, t179); // row 3, MSY5
    }
    // MSZ5: column
    {
        let t182 = z1_4_x * t124 - z1_3_y * t121;
        let t185 = z2_4_x * t124 - c3 * t121;
        let t186 = s4 * t124;
        put(12, t182); // row 1, MSZ5
        put(34, t185); // row 2, MSZ5
        put(52, t186); // row 3, MSZ5
    }
    // M6: column
    let [t188, t189, t191, t192] = {
        let t188 = s6 * a6_y;
        let t189 = c6 * t21 + t188;
        let t191 = c6 * a6_y;
        let t192 = s6 * t21 - t191;
        let t194 = t120 + c5 * t189;
        let t196 = t123 - s5 * t189;
        let t197 = k_L3 * t196;
        let t200 = k_L3 * t194 + k_A * t192;
        let t201 = k_A * t196;
        let t207 = t73 * t196 - t197;
        let t208 = t70 * t196 - t201;
        let t209 = t70 * t192 + t73 * t194 - t200;
        let t214 = z1_3_y * t209 + (z1_4_x * t207 + z1_4_y * t208);
        let t219 = c3 * t209 + (z2_4_x * t207 - t39 * t208);
        let t223 = t201 - (s4 * t197 + c4 * t201);
        let t224 = -t189;
        put(13, t214); // row 1, M6
        put(35, t219); // row 2, M6
        put(53, t223); // row 3, M6
        put(67, t200); // row 4, M6
        put(79, t224); // row 5, MSZ6
        [t188, t189, t191, t192]
    };
    // MSX6: column
    let [t225, t226] = {
        let t225 = s6 * a5_y;
        let t226 = c6 * a5_y;
        let t229 = s5 * a6_y - c5 * t225;
        let t232 = s5 * t225 + c5 * a6_y;
        let t237 = z1_4_x * t229 + z1_4_y * t226 - z1_3_y * t232;
        let t242 = z2_4_x * t229 - t39 * t226 - c3 * t232;
        let t245 = s4 * t229 + c4 * t226;
        let t246 = -t225;
        put(14, t237); // row 1, MSX6
        put(36, t242); // row 2, MSX6
        put(54, t245); // row 3, MSX6
        put(68, t232); // row 4, MSX6
        put(77, t226); // row 5, MSX6
        put(78, t246); // row 5, MSY6
        [t225, t226]
    };
    // MSY6: column
    {
        let t249 = s5 * t21 - c5 * t226;
        let t252 = s5 * t226 + c5 * t21;
        let t257 = z1_4_x * t249 - z1_4_y * t225 - z1_3_y * t252;
        let t262 = z2_4_x * t249 + t39 * t225 - c3 * t252;
        let t265 = s4 * t249 - c4 * t225;
        put(15, t257); // row 1, MSY6
        put(37, t262); // row 2, MSY6
        put(55, t265); // row 3, MSY6
        put(69, t252); // row 4, MSY6
    }
    // MSZ6: column
    {
        let t266 = c5 * t192;
        let t267 = s5 * t192;
        let t272 = z1_3_y * t267 + (z1_4_x * t266 - z1_4_y * t189);
        let t277 = c3 * t267 + (z2_4_x * t266 + t39 * t189);
        let t280 = s4 * t266 - c4 * t189;
        let t281 = -t267;
        put(16, t272); // row 1, MSZ6
        put(38, t277); // row 2, MSZ6
        put(56, t280); // row 3, MSZ6
        put(70, t281); // row 4, MSZ6
    }
    // M7: column
    let [t284, t287] = {
        let t284 = s7 * t30 - c7 * t27;
        let t287 = s7 * t27 + c7 * t30;
        let t288 = k4 * a6_y;
        let t289 = k4 * t287;
        let t291 = t188 - c6 * t284;
        let t293 = t191 + s6 * t284;
        let t294 = s6 * t289;
        let t295 = c6 * t289;
        let t298 = c5 * t291 + s5 * t287;
        let t301 = c5 * t287 - s5 * t291;
        let t312 = k_A * t301;
        let t313 = c5 * t294 - s5 * t288 + k_L3 * t301;
        let t314 = s5 * t294 + c5 * t288 - (k_A * t293 - k_L3 * t298);
        let t315 = t312 - t295;
        let t321 = t313 - t73 * t301;
        let t322 = t70 * t301 - t315;
        let t323 = t73 * t298 - t70 * t293 - t314;
        let t328 = z1_3_y * t323 + (z1_4_y * t322 - z1_4_x * t321);
        let t333 = c3 * t323 - (z2_4_x * t321 + t39 * t322);
        let t337 = t312 - (s4 * t313 + c4 * t315);
        put(17, t328); // row 1, M7
        put(39, t333); // row 2, M7
        put(57, t337); // row 3, M7
        put(71, t314); // row 4, M7
        put(80, t295); // row 5, M7
        put(86, t288); // row 6, M7
        put(89, t284); // row 6, MSZ7
        [t284, t287]
    };
    // MSX7: column
    let [t338, t339] = {
        let t338 = s7 * a6_y;
        let t339 = c7 * a6_y;
        let t342 = c6 * t338 + s6 * t30;
        let t345 = c6 * t30 - s6 * t338;
        let t348 = s5 * t339 - c5 * t342;
        let t351 = s5 * t342 + c5 * t339;
        let t356 = z1_4_x * t348 + z1_4_y * t345 - z1_3_y * t351;
        let t361 = z2_4_x * t348 - t39 * t345 - c3 * t351;
        let t364 = s4 * t348 + c4 * t345;
        let t365 = -t338;
        put(18, t356); // row 1, MSX7
        put(40, t361); // row 2, MSX7
        put(58, t364); // row 3, MSX7
        put(72, t351); // row 4, MSX7
        put(81, t345); // row 5, MSX7
        put(87, t339); // row 6, MSX7
        put(88, t365); // row 6, MSY7
        [t338, t339]
    };
    // MSY7: column
    {
        let t368 = s6 * t27 - c6 * t339;
        let t371 = s6 * t339 + c6 * t27;
        let t374 = c5 * t368 - s5 * t338;
        let t377 = s5 * t368 + c5 * t338;
        let t382 = z1_3_y * t377 - (z1_4_y * t371 - z1_4_x * t374);
        let t387 = c3 * t377 + (z2_4_x * t374 + t39 * t371);
        let t390 = s4 * t374 - c4 * t371;
        let t391 = -t377;
        let t392 = -t371;
        put(19, t382); // row 1, MSY7
        put(41, t387); // row 2, MSY7
        put(59, t390); // row 3, MSY7
        put(73, t391); // row 4, MSY7
        put(82, t392); // row 5, MSY7
    }
    // MSZ7: column
    {
        let t393 = c6 * t287;
        let t394 = s6 * t287;
        let t397 = c5 * t393 + s5 * t284;
        let t400 = c5 * t284 - s5 * t393;
        let t405 = z1_4_x * t397 + z1_4_y * t394 - z1_3_y * t400;
        let t410 = z2_4_x * t397 - t39 * t394 - c3 * t400;
        let t413 = s4 * t397 + c4 * t394;
        put(20, t405); // row 1, MSZ7
        put(42, t410); // row 2, MSZ7
        put(60, t413); // row 3, MSZ7
        put(74, t400); // row 4, MSZ7
        put(83, t394); // row 5, MSZ7
    }
}
