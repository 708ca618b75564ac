//! Regressor at rest.
//!
//! `g = W_g phi` of the links' parameters; columns as the first of `STANDARD_NAMES`, without the
//! drives'.
//!
//! 283 multiplications, 166 additions; 7 x 70, 94 of 490 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{GRAVITY, Trig};

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

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 70 + PATTERN[k].1
}

/// Regressor at rest: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 70]; 7]) {
    let flat = &mut out.as_flattened_mut()[..];
    clear(&mut flat[0..10]);
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[11..13]),
            1 => clear(&mut flat[14..20]),
            5 => clear(&mut flat[24..30]),
            9 => clear(&mut flat[34..40]),
            13 => clear(&mut flat[44..50]),
            17 => clear(&mut flat[54..60]),
            21 => clear(&mut flat[64..81]),
            23 => clear(&mut flat[83..90]),
            27 => clear(&mut flat[94..100]),
            31 => clear(&mut flat[104..110]),
            35 => clear(&mut flat[114..120]),
            39 => clear(&mut flat[124..130]),
            43 => clear(&mut flat[134..161]),
            45 => clear(&mut flat[163..170]),
            49 => clear(&mut flat[174..180]),
            53 => clear(&mut flat[184..190]),
            57 => clear(&mut flat[194..200]),
            61 => clear(&mut flat[204..241]),
            63 => clear(&mut flat[243..250]),
            67 => clear(&mut flat[254..260]),
            71 => clear(&mut flat[264..270]),
            75 => clear(&mut flat[274..321]),
            77 => clear(&mut flat[323..330]),
            81 => clear(&mut flat[334..340]),
            85 => clear(&mut flat[344..401]),
            87 => clear(&mut flat[403..410]),
            91 => clear(&mut flat[414..481]),
            93 => clear(&mut flat[483..490]),
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
        let t2 = -t1;
        put(22, t2); // row 2, MSX2
        put(23, t0); // row 2, MSY2
        [t0, t1]
    };
    // link 3: motion
    let [z1_3_x, z1_4_z, t5, a3_y] = {
        let z1_3_x = s2 * c3;
        let z1_4_z = s2 * s3;
        let t5 = c3 * t0;
        let a3_y = s3 * t0;
        put(44, a3_y); // row 3, MSX3
        put(45, t5); // row 3, MSY3
        [z1_3_x, z1_4_z, t5, a3_y]
    };
    // link 4: motion
    let [t9, a4_y] = {
        let t9 = c4 * t5 + s4 * t1;
        let a4_y = s4 * t5 - c4 * t1;
        put(62, a4_y); // row 4, MSX4
        put(63, t9); // row 4, MSY4
        [t9, a4_y]
    };
    // link 5: motion
    let [t15, a5_y] = {
        let t15 = c5 * t9 - s5 * a3_y;
        let a5_y = c5 * a3_y + s5 * t9;
        put(76, a5_y); // row 5, MSX5
        put(77, t15); // row 5, MSY5
        [t15, a5_y]
    };
    // link 6: motion
    let [t21, a6_y] = {
        let t21 = c6 * t15 - s6 * a4_y;
        let a6_y = c6 * a4_y + s6 * t15;
        put(86, a6_y); // row 6, MSX6
        put(87, t21); // row 6, MSY6
        [t21, a6_y]
    };
    // link 7: motion
    let [t27, a7_y] = {
        let t27 = c7 * t21 - s7 * a5_y;
        let a7_y = c7 * a5_y + s7 * t21;
        put(92, a7_y); // row 7, MSX7
        put(93, t27); // row 7, MSY7
        [t27, a7_y]
    };
    // joint axes in frame 2
    let [t31, v1_2_y] = {
        let t31 = c2 * k1;
        let v1_2_y = s2 * k1;
        [t31, v1_2_y]
    };
    // joint axes in frame 3
    let [t36, v1_3_y, v2_3_x, v2_4_z] = {
        let t33 = s2 * k2;
        let t36 = c3 * t31 - s3 * t33;
        let v1_3_y = c3 * t33 + s3 * t31;
        let v2_3_x = c3 * k2;
        let v2_4_z = s3 * k2;
        [t36, v1_3_y, v2_3_x, v2_4_z]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, t48, z2_4_y, t50, t51, t54, t57] = {
        let z1_4_x = c4 * z1_3_x + c2 * s4;
        let z1_4_y = c2 * c4 - s4 * z1_3_x;
        let t48 = s3 * c4;
        let z2_4_y = s3 * s4;
        let t50 = c4 * v2_3_x;
        let t51 = s4 * v2_3_x;
        let t54 = s4 * v1_2_y - c4 * t36;
        let t57 = c4 * v1_2_y + s4 * t36;
        [z1_4_x, z1_4_y, t48, z2_4_y, t50, t51, t54, t57]
    };
    // MSZ2: column
    {
        let t60 = c2 * t0 - s2 * t1;
        let t61 = k1 * t60;
        let t62 = -t60;
        put(0, t61); // row 1, M2
        put(1, t62); // row 1, MSZ2
    }
    // M3: column
    let [t64, t69] = {
        let t64 = a3_y * v1_3_y;
        let t67 = t5 * t36 + t64 - t1 * v1_2_y;
        let t69 = a3_y * v2_4_z;
        let t71 = -(t5 * v2_3_x + t69);
        put(2, t67); // row 1, M3
        put(24, t71); // row 2, M3
        [t64, t69]
    };
    // MSX3: column
    {
        let t74 = c2 * a3_y - t1 * z1_4_z;
        let t76 = -(c3 * t1);
        put(3, t74); // row 1, MSX3
        put(25, t76); // row 2, MSX3
    }
    // MSY3: column
    {
        let t79 = c2 * t5 - t1 * z1_3_x;
        let t80 = s3 * t1;
        put(4, t79); // row 1, MSY3
        put(26, t80); // row 2, MSY3
    }
    // MSZ3: column
    {
        let t83 = z1_4_z * t5 - z1_3_x * a3_y;
        let t86 = s3 * a3_y + c3 * t5;
        put(5, t83); // row 1, MSZ3
        put(27, t86); // row 2, MSZ3
    }
    // M4: column
    let [t89, t92] = {
        let t89 = c4 * t9 + s4 * a4_y;
        let t92 = s4 * t9 - c4 * a4_y;
        let t93 = k3 * t92;
        let t94 = k3 * t89;
        let t102 = t64 + t36 * t89 - v1_2_y * t92 - (z1_3_x * t93 - c2 * t94);
        let t106 = s3 * t93 - (t69 + v2_3_x * t89);
        let t107 = -t89;
        put(6, t102); // row 1, M4
        put(28, t106); // row 2, M4
        put(46, t94); // row 3, M4
        put(49, t107); // row 3, MSZ4
        [t89, t92]
    };
    // MSX4: column
    let [t108, t109] = {
        let t108 = s4 * a3_y;
        let t109 = c4 * a3_y;
        let t114 = c2 * t109 + (z1_4_z * a4_y - z1_3_x * t108);
        let t117 = s3 * t108 + c3 * a4_y;
        let t118 = -t108;
        put(7, t114); // row 1, MSX4
        put(29, t117); // row 2, MSX4
        put(47, t109); // row 3, MSX4
        put(48, t118); // row 3, MSY4
        [t108, t109]
    };
    // MSY4: column
    {
        let t123 = z1_4_z * t9 - z1_3_x * t109 - c2 * t108;
        let t126 = s3 * t109 + c3 * t9;
        put(8, t123); // row 1, MSY4
        put(30, t126); // row 2, MSY4
    }
    // MSZ4: column
    {
        let t129 = z1_3_x * t92 - c2 * t89;
        let t131 = -(s3 * t92);
        put(9, t129); // row 1, MSZ4
        put(31, t131); // row 2, MSZ4
    }
    // M5: column
    let [t133, t134, t136, t137] = {
        let t133 = s5 * a5_y;
        let t134 = c5 * t15 + t133;
        let t136 = c5 * a5_y;
        let t137 = s5 * t15 - t136;
        let t139 = k4 * t134;
        let t141 = k3 * t134;
        let t142 = a4_y * k3 - k4 * t137;
        let t147 = z1_4_z * t139 - (z1_4_x * t142 + z1_4_y * t141);
        let t153 = a4_y * t57 - t54 * t134 - v1_3_y * t137 - t147;
        let t158 = c3 * t139 + (t48 * t142 - z2_4_y * t141);
        let t164 = v2_4_z * t137 - (t50 * t134 + a4_y * t51) - t158;
        let t167 = s4 * t142 + c4 * t141;
        let t168 = -t139;
        put(10, t153); // row 1, M5
        put(32, t164); // row 2, M5
        put(50, t167); // row 3, M5
        put(64, t168); // row 4, M5
        put(67, t134); // row 4, MSZ5
        [t133, t134, t136, t137]
    };
    // MSX5: column
    let [t169, t170] = {
        let t169 = s5 * a4_y;
        let t170 = c5 * a4_y;
        let t175 = z1_4_z * t170 + (z1_4_x * t169 + a5_y * z1_4_y);
        let t180 = c3 * t170 - (t48 * t169 - a5_y * z2_4_y);
        let t183 = s4 * t169 + c4 * a5_y;
        let t184 = -t169;
        put(11, t175); // row 1, MSX5
        put(33, t180); // row 2, MSX5
        put(51, t183); // row 3, MSX5
        put(65, t170); // row 4, MSX5
        put(66, t184); // row 4, MSY5
        [t169, t170]
    };
    // MSY5: column
    {
        let t189 = z1_4_x * t170 + t15 * z1_4_y - z1_4_z * t169;
        let t194 = t15 * z2_4_y - t48 * t170 - c3 * t169;
        let t197 = s4 * t170 + c4 * t15;
        put(12, t189); // row 1, MSY5
        put(34, t194); // row 2, MSY5
        put(52, t197); // row 3, MSY5
    }
    // MSZ5: column
    {
        let t200 = z1_4_x * t137 + z1_4_z * t134;
        let t203 = c3 * t134 - t48 * t137;
        let t204 = s4 * t137;
        put(13, t200); // row 1, MSZ5
        put(35, t203); // row 2, MSZ5
        put(53, t204); // row 3, MSZ5
    }
    // M6: column
    let [t206, t207, t209, t210] = {
        let t206 = s6 * a6_y;
        let t207 = c6 * t21 + t206;
        let t209 = c6 * a6_y;
        let t210 = t209 - s6 * t21;
        let t211 = k5 * t210;
        let t212 = k5 * t207;
        let t214 = t133 + c5 * t207;
        let t216 = s5 * t207 - t136;
        let t222 = s5 * t211 + k4 * t214;
        let t225 = c5 * t211 - k4 * t216 + k3 * t210;
        let t226 = t212 + k3 * t214;
        let t236 = t57 * t210 - t54 * t214 - v1_3_y * t216;
        let t237 = z1_4_x * t225 + z1_4_y * t226 - z1_4_z * t222 + t236;
        let t247 = v2_4_z * t216 - (t50 * t214 + t51 * t210);
        let t248 = z2_4_y * t226 - t48 * t225 - c3 * t222 + t247;
        let t251 = s4 * t225 + c4 * t226;
        let t252 = -t222;
        let t253 = -t207;
        put(14, t237); // row 1, M6
        put(36, t248); // row 2, M6
        put(54, t251); // row 3, M6
        put(68, t252); // row 4, M6
        put(78, t212); // row 5, M6
        put(81, t253); // row 5, MSZ6
        [t206, t207, t209, t210]
    };
    // MSX6: column
    let [t254, t255] = {
        let t254 = s6 * a5_y;
        let t255 = c6 * a5_y;
        let t258 = s5 * a6_y - c5 * t254;
        let t261 = s5 * t254 + c5 * a6_y;
        let t266 = z1_4_z * t261 + (z1_4_x * t258 + z1_4_y * t255);
        let t271 = c3 * t261 + (z2_4_y * t255 - t48 * t258);
        let t274 = s4 * t258 + c4 * t255;
        let t275 = -t254;
        put(15, t266); // row 1, MSX6
        put(37, t271); // row 2, MSX6
        put(55, t274); // row 3, MSX6
        put(69, t261); // row 4, MSX6
        put(79, t255); // row 5, MSX6
        put(80, t275); // row 5, MSY6
        [t254, t255]
    };
    // MSY6: column
    {
        let t278 = s5 * t21 - c5 * t255;
        let t281 = s5 * t255 + c5 * t21;
        let t286 = z1_4_z * t281 + (z1_4_x * t278 - z1_4_y * t254);
        let t291 = c3 * t281 - (t48 * t278 + z2_4_y * t254);
        let t294 = s4 * t278 - c4 * t254;
        put(16, t286); // row 1, MSY6
        put(38, t291); // row 2, MSY6
        put(56, t294); // row 3, MSY6
        put(70, t281); // row 4, MSY6
    }
    // MSZ6: column
    {
        let t295 = c5 * t210;
        let t296 = s5 * t210;
        let t301 = z1_4_z * t296 - (z1_4_x * t295 + z1_4_y * t207);
        let t306 = c3 * t296 - (z2_4_y * t207 - t48 * t295);
        let t310 = -(s4 * t295 + c4 * t207);
        put(17, t301); // row 1, MSZ6
        put(39, t306); // row 2, MSZ6
        put(57, t310); // row 3, MSZ6
        put(71, t296); // row 4, MSZ6
    }
    // M7: column
    let [t313, t316] = {
        let t313 = c7 * t27 + s7 * a7_y;
        let t316 = s7 * t27 - c7 * a7_y;
        let t317 = k6 * t316;
        let t318 = k6 * t313;
        let t320 = t206 + c6 * t313;
        let t322 = t209 - s6 * t313;
        let t327 = k5 * t322 - c6 * t317;
        let t328 = k5 * t320 - s6 * t317;
        let t331 = s5 * t316 - c5 * t320;
        let t334 = s5 * t320 + c5 * t316;
        let t344 = k4 * t331 - (s5 * t327 + c5 * t318);
        let t347 = s5 * t318 - c5 * t327 + k4 * t334 - k3 * t322;
        let t348 = t328 - k3 * t331;
        let t358 = t54 * t331 + t57 * t322 - v1_3_y * t334;
        let t359 = z1_4_z * t344 + (z1_4_y * t348 - z1_4_x * t347) + t358;
        let t369 = v2_4_z * t334 + (t50 * t331 - t51 * t322);
        let t370 = c3 * t344 + (t48 * t347 + z2_4_y * t348) + t369;
        let t373 = c4 * t348 - s4 * t347;
        let t374 = -t318;
        put(18, t359); // row 1, M7
        put(40, t370); // row 2, M7
        put(58, t373); // row 3, M7
        put(72, t344); // row 4, M7
        put(82, t328); // row 5, M7
        put(88, t374); // row 6, M7
        put(91, t313); // row 6, MSZ7
        [t313, t316]
    };
    // MSX7: column
    let [t375, t376] = {
        let t375 = s7 * a6_y;
        let t376 = c7 * a6_y;
        let t379 = s6 * a7_y - c6 * t375;
        let t382 = s6 * t375 + c6 * a7_y;
        let t385 = c5 * t379 - s5 * t376;
        let t388 = s5 * t379 + c5 * t376;
        let t393 = z1_4_z * t388 + (z1_4_y * t382 - z1_4_x * t385);
        let t398 = c3 * t388 + (t48 * t385 + z2_4_y * t382);
        let t401 = c4 * t382 - s4 * t385;
        let t402 = -t375;
        put(19, t393); // row 1, MSX7
        put(41, t398); // row 2, MSX7
        put(59, t401); // row 3, MSX7
        put(73, t388); // row 4, MSX7
        put(83, t382); // row 5, MSX7
        put(89, t376); // row 6, MSX7
        put(90, t402); // row 6, MSY7
        [t375, t376]
    };
    // MSY7: column
    {
        let t405 = s6 * t27 - c6 * t376;
        let t408 = s6 * t376 + c6 * t27;
        let t411 = c5 * t405 + s5 * t375;
        let t414 = s5 * t405 - c5 * t375;
        let t419 = z1_4_z * t414 - (z1_4_x * t411 - z1_4_y * t408);
        let t424 = c3 * t414 + (t48 * t411 + z2_4_y * t408);
        let t427 = c4 * t408 - s4 * t411;
        put(20, t419); // row 1, MSY7
        put(42, t424); // row 2, MSY7
        put(60, t427); // row 3, MSY7
        put(74, t414); // row 4, MSY7
        put(84, t408); // row 5, MSY7
    }
    // MSZ7: column
    {
        let t428 = c6 * t316;
        let t429 = s6 * t316;
        let t432 = c5 * t428 + s5 * t313;
        let t435 = c5 * t313 - s5 * t428;
        let t440 = z1_4_z * t435 + (z1_4_x * t432 + z1_4_y * t429);
        let t445 = c3 * t435 - (t48 * t432 - z2_4_y * t429);
        let t448 = s4 * t432 + c4 * t429;
        put(21, t440); // row 1, MSZ7
        put(43, t445); // row 2, MSZ7
        put(61, t448); // row 3, MSZ7
        put(75, t435); // row 4, MSZ7
        put(85, t429); // row 5, MSZ7
    }
}
