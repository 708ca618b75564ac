//! Regressor at rest.
//!
//! `g = W_g phi` of the links' parameters; columns as the first of `STANDARD_NAMES`, without the
//! drives'.
//!
//! 237 multiplications, 135 additions; 7 x 70, 89 of 490 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 89;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 13), (0, 20), (0, 21), (0, 22), (0, 23), (0, 30), (0, 31), (0, 32), (0, 33), (0, 40),
    (0, 41), (0, 42), (0, 43), (0, 50), (0, 51), (0, 52), (0, 53), (0, 60), (0, 61), (0, 62),
    (0, 63), (1, 11), (1, 12), (1, 20), (1, 21), (1, 22), (1, 23), (1, 30), (1, 31), (1, 32),
    (1, 33), (1, 40), (1, 41), (1, 42), (1, 43), (1, 50), (1, 51), (1, 52), (1, 53), (1, 60),
    (1, 61), (1, 62), (1, 63), (2, 21), (2, 22), (2, 31), (2, 32), (2, 33), (2, 40), (2, 41),
    (2, 42), (2, 43), (2, 50), (2, 51), (2, 52), (2, 53), (2, 60), (2, 61), (2, 62), (2, 63),
    (3, 31), (3, 32), (3, 40), (3, 41), (3, 42), (3, 43), (3, 50), (3, 51), (3, 52), (3, 53),
    (3, 60), (3, 61), (3, 62), (3, 63), (4, 41), (4, 42), (4, 51), (4, 52), (4, 53), (4, 61),
    (4, 62), (4, 63), (5, 51), (5, 52), (5, 61), (5, 62), (5, 63), (6, 61), (6, 62),
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
            44 => clear(&mut flat[163..171]),
            47 => clear(&mut flat[174..180]),
            51 => clear(&mut flat[184..190]),
            55 => clear(&mut flat[194..200]),
            59 => clear(&mut flat[204..241]),
            61 => clear(&mut flat[243..250]),
            65 => clear(&mut flat[254..260]),
            69 => clear(&mut flat[264..270]),
            73 => clear(&mut flat[274..321]),
            75 => clear(&mut flat[323..331]),
            78 => clear(&mut flat[334..341]),
            81 => clear(&mut flat[344..401]),
            83 => clear(&mut flat[403..411]),
            86 => clear(&mut flat[414..481]),
            88 => clear(&mut flat[483..490]),
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
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
    // link 2: motion
    let [a2_x, a2_y] = {
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let t2 = -a2_x;
        put(21, a2_y); // row 2, MSX2
        put(22, t2); // row 2, MSY2
        [a2_x, a2_y]
    };
    // link 3: motion
    let [z1_3_x, t4, a3_x, t6] = {
        let z1_3_x = s2 * c3;
        let t4 = s2 * s3;
        let a3_x = c3 * a2_x;
        let t6 = s3 * a2_x;
        let t7 = -t6;
        let t8 = -a3_x;
        put(43, t7); // row 3, MSX3
        put(44, t8); // row 3, MSY3
        [z1_3_x, t4, a3_x, t6]
    };
    // link 4: motion
    let [t11, a5_z] = {
        let t11 = s4 * a2_y - c4 * a3_x;
        let a5_z = c4 * a2_y + s4 * a3_x;
        let t15 = -a5_z;
        put(60, t15); // row 4, MSX4
        put(61, t11); // row 4, MSY4
        [t11, a5_z]
    };
    // link 5: motion
    let [t18, a5_y] = {
        let t18 = c5 * t11 + s5 * t6;
        let a5_y = s5 * t11 - c5 * t6;
        put(74, a5_y); // row 5, MSX5
        put(75, t18); // row 5, MSY5
        [t18, a5_y]
    };
    // link 6: motion
    let [a6_x, a6_y] = {
        let a6_x = s6 * a5_z - c6 * t18;
        let a6_y = c6 * a5_z + s6 * t18;
        let t28 = -a6_x;
        put(82, a6_y); // row 6, MSX6
        put(83, t28); // row 6, MSY6
        [a6_x, a6_y]
    };
    // link 7: motion
    let [a7_x, t34] = {
        let a7_x = c7 * a6_x + s7 * a5_y;
        let t34 = s7 * a6_x - c7 * a5_y;
        let t35 = -t34;
        let t36 = -a7_x;
        put(87, t35); // row 7, MSX7
        put(88, t36); // row 7, MSY7
        [a7_x, t34]
    };
    // MSZ2: column
    {
        let t39 = c2 * a2_x - s2 * a2_y;
        put(0, t39); // row 1, MSZ2
    }
    // M3: column
    let [t42, t45] = {
        let t40 = k_L2 * t6;
        let t41 = k_L2 * a3_x;
        let t42 = z1_3_x * t40;
        let t44 = t42 - t4 * t41;
        let t45 = s3 * t40;
        let t48 = -(t45 + c3 * t41);
        put(1, t44); // row 1, M3
        put(23, t48); // row 2, M3
        [t42, t45]
    };
    // MSX3: column
    {
        let t51 = a2_y * t4 - c2 * t6;
        let t52 = c3 * a2_y;
        put(2, t51); // row 1, MSX3
        put(24, t52); // row 2, MSX3
    }
    // MSY3: column
    {
        let t55 = a2_y * z1_3_x - c2 * a3_x;
        let t57 = -(s3 * a2_y);
        put(3, t55); // row 1, MSY3
        put(25, t57); // row 2, MSY3
    }
    // MSZ3: column
    {
        let t60 = z1_3_x * t6 - t4 * a3_x;
        let t64 = -(s3 * t6 + c3 * a3_x);
        put(4, t60); // row 1, MSZ3
        put(26, t64); // row 2, MSZ3
    }
    // M4: column
    let [t66, t67, t70] = {
        let t66 = s4 * a5_z;
        let t67 = c4 * t11 - t66;
        let t70 = s4 * t11 + c4 * a5_z;
        let t71 = k_L2 * t67;
        let t73 = t42 + t4 * t71;
        let t75 = c3 * t71 - t45;
        put(5, t73); // row 1, M4
        put(27, t75); // row 2, M4
        put(47, t67); // row 3, MSZ4
        [t66, t67, t70]
    };
    // MSX4: column
    let [t76, t77] = {
        let t76 = s4 * t6;
        let t77 = c4 * t6;
        let t82 = t4 * a5_z - z1_3_x * t76 - c2 * t77;
        let t85 = s3 * t76 + c3 * a5_z;
        let t86 = -t77;
        put(6, t82); // row 1, MSX4
        put(28, t85); // row 2, MSX4
        put(45, t86); // row 3, MSX4
        put(46, t76); // row 3, MSY4
        [t76, t77]
    };
    // MSY4: column
    {
        let t91 = c2 * t76 - (z1_3_x * t77 + t4 * t11);
        let t94 = s3 * t77 - c3 * t11;
        put(7, t91); // row 1, MSY4
        put(29, t94); // row 2, MSY4
    }
    // MSZ4: column
    {
        let t97 = z1_3_x * t70 + c2 * t67;
        let t99 = -(s3 * t70);
        put(8, t97); // row 1, MSZ4
        put(30, t99); // row 2, MSZ4
    }
    // M5: column
    let [t101, t102, t104, t105] = {
        let t101 = s5 * a5_y;
        let t102 = c5 * t18 + t101;
        let t104 = c5 * a5_y;
        let t105 = t104 - s5 * t18;
        let t106 = k_L3 * t105;
        let t107 = k_L3 * t102;
        let t111 = s4 * t106;
        let t114 = c4 * t106 + k_L2 * t105;
        let t115 = t107 + k_L2 * (c4 * t102 - t66);
        let t120 = c2 * t111 + (t4 * t115 - z1_3_x * t114);
        let t123 = s3 * t114 + c3 * t115;
        let t124 = -t107;
        let t125 = -t102;
        put(9, t120); // row 1, M5
        put(31, t123); // row 2, M5
        put(48, t111); // row 3, M5
        put(62, t124); // row 4, M5
        put(65, t125); // row 4, MSZ5
        [t101, t102, t104, t105]
    };
    // MSX5: column
    let [t126, t127] = {
        let t126 = s5 * a5_z;
        let t127 = c5 * a5_z;
        let t130 = c4 * t126 + s4 * a5_y;
        let t133 = c4 * a5_y - s4 * t126;
        let t138 = c2 * t133 + (z1_3_x * t130 + t4 * t127);
        let t141 = c3 * t127 - s3 * t130;
        let t142 = -t127;
        put(10, t138); // row 1, MSX5
        put(32, t141); // row 2, MSX5
        put(49, t133); // row 3, MSX5
        put(63, t142); // row 4, MSX5
        put(64, t126); // row 4, MSY5
        [t126, t127]
    };
    // MSY5: column
    {
        let t145 = c4 * t127 + s4 * t18;
        let t148 = c4 * t18 - s4 * t127;
        let t153 = c2 * t148 - (t4 * t126 - z1_3_x * t145);
        let t157 = -(s3 * t145 + c3 * t126);
        put(11, t153); // row 1, MSY5
        put(33, t157); // row 2, MSY5
        put(50, t148); // row 3, MSY5
    }
    // MSZ5: column
    {
        let t158 = c4 * t105;
        let t159 = s4 * t105;
        let t164 = c2 * t159 - (z1_3_x * t158 - t4 * t102);
        let t167 = s3 * t158 + c3 * t102;
        put(12, t164); // row 1, MSZ5
        put(34, t167); // row 2, MSZ5
        put(51, t159); // row 3, MSZ5
    }
    // M6: column
    let [t169, t170, t172, t173] = {
        let t169 = s6 * a6_y;
        let t170 = c6 * a6_x - t169;
        let t172 = c6 * a6_y;
        let t173 = s6 * a6_x + t172;
        let t175 = c5 * t170 - t101;
        let t177 = t104 + s5 * t170;
        let t178 = k_L3 * t177;
        let t179 = k_L3 * t175;
        let t184 = s4 * t178;
        let t187 = c4 * t178 + k_L2 * t177;
        let t188 = t179 + k_L2 * (c4 * t175 + s4 * t173);
        let t193 = c2 * t184 - (z1_3_x * t187 + t4 * t188);
        let t196 = s3 * t187 - c3 * t188;
        put(13, t193); // row 1, M6
        put(35, t196); // row 2, M6
        put(52, t184); // row 3, M6
        put(66, t179); // row 4, M6
        put(78, t170); // row 5, MSZ6
        [t169, t170, t172, t173]
    };
    // MSX6: column
    let [t197, t198] = {
        let t197 = s6 * a5_y;
        let t198 = c6 * a5_y;
        let t201 = c5 * t197 - s5 * a6_y;
        let t204 = s5 * t197 + c5 * a6_y;
        let t207 = c4 * t201 - s4 * t198;
        let t210 = s4 * t201 + c4 * t198;
        let t215 = c2 * t210 + (t4 * t204 - z1_3_x * t207);
        let t218 = s3 * t207 + c3 * t204;
        let t219 = -t204;
        let t220 = -t197;
        put(14, t215); // row 1, MSX6
        put(36, t218); // row 2, MSX6
        put(53, t210); // row 3, MSX6
        put(67, t219); // row 4, MSX6
        put(76, t198); // row 5, MSX6
        put(77, t220); // row 5, MSY6
        [t197, t198]
    };
    // MSY6: column
    {
        let t223 = c5 * t198 + s5 * a6_x;
        let t226 = c5 * a6_x - s5 * t198;
        let t229 = c4 * t223 + s4 * t197;
        let t232 = s4 * t223 - c4 * t197;
        let t237 = c2 * t232 - (z1_3_x * t229 + t4 * t226);
        let t240 = s3 * t229 - c3 * t226;
        put(15, t237); // row 1, MSY6
        put(37, t240); // row 2, MSY6
        put(54, t232); // row 3, MSY6
        put(68, t226); // row 4, MSY6
    }
    // MSZ6: column
    {
        let t241 = c5 * t173;
        let t242 = s5 * t173;
        let t245 = s4 * t170 - c4 * t241;
        let t248 = s4 * t241 + c4 * t170;
        let t253 = c2 * t248 + (z1_3_x * t245 + t4 * t242);
        let t256 = c3 * t242 - s3 * t245;
        let t257 = -t242;
        put(16, t253); // row 1, MSZ6
        put(38, t256); // row 2, MSZ6
        put(55, t248); // row 3, MSZ6
        put(69, t257); // row 4, MSZ6
    }
    // M7: column
    let [t260, t263] = {
        let t260 = c7 * a7_x + s7 * t34;
        let t263 = c7 * t34 - s7 * a7_x;
        let t265 = c6 * t260 - t169;
        let t270 = c5 * t265 + s5 * t263;
        let t273 = s5 * t265 - c5 * t263;
        let t274 = k_L3 * t273;
        let t275 = k_L3 * t270;
        let t280 = s4 * t274;
        let t283 = c4 * t274 + k_L2 * t273;
        let t284 = t275 + k_L2 * (c4 * t270 + s4 * (t172 + s6 * t260));
        let t289 = c2 * t280 - (z1_3_x * t283 + t4 * t284);
        let t292 = s3 * t283 - c3 * t284;
        let t293 = -t260;
        put(17, t289); // row 1, M7
        put(39, t292); // row 2, M7
        put(56, t280); // row 3, M7
        put(70, t275); // row 4, M7
        put(86, t293); // row 6, MSZ7
        [t260, t263]
    };
    // MSX7: column
    let [t294, t295] = {
        let t294 = s7 * a6_y;
        let t295 = c7 * a6_y;
        let t298 = c6 * t294 + s6 * t34;
        let t301 = s6 * t294 - c6 * t34;
        let t304 = c5 * t298 + s5 * t295;
        let t307 = c5 * t295 - s5 * t298;
        let t310 = c4 * t304 + s4 * t301;
        let t313 = c4 * t301 - s4 * t304;
        let t318 = c2 * t313 + (z1_3_x * t310 + t4 * t307);
        let t321 = c3 * t307 - s3 * t310;
        let t322 = -t307;
        let t323 = -t294;
        put(18, t318); // row 1, MSX7
        put(40, t321); // row 2, MSX7
        put(57, t313); // row 3, MSX7
        put(71, t322); // row 4, MSX7
        put(79, t301); // row 5, MSX7
        put(84, t295); // row 6, MSX7
        put(85, t323); // row 6, MSY7
        [t294, t295]
    };
    // MSY7: column
    {
        let t326 = c6 * t295 + s6 * a7_x;
        let t329 = s6 * t295 - c6 * a7_x;
        let t332 = s5 * t294 - c5 * t326;
        let t335 = s5 * t326 + c5 * t294;
        let t338 = c4 * t332 - s4 * t329;
        let t341 = s4 * t332 + c4 * t329;
        let t346 = c2 * t341 - (z1_3_x * t338 + t4 * t335);
        let t349 = s3 * t338 - c3 * t335;
        put(19, t346); // row 1, MSY7
        put(41, t349); // row 2, MSY7
        put(58, t341); // row 3, MSY7
        put(72, t335); // row 4, MSY7
        put(80, t329); // row 5, MSY7
    }
    // MSZ7: column
    {
        let t350 = c6 * t263;
        let t351 = s6 * t263;
        let t354 = s5 * t260 - c5 * t350;
        let t357 = s5 * t350 + c5 * t260;
        let t360 = c4 * t354 - s4 * t351;
        let t363 = s4 * t354 + c4 * t351;
        let t368 = c2 * t363 - (z1_3_x * t360 + t4 * t357);
        let t371 = s3 * t360 - c3 * t357;
        put(20, t368); // row 1, MSZ7
        put(42, t371); // row 2, MSZ7
        put(59, t363); // row 3, MSZ7
        put(73, t357); // row 4, MSZ7
        put(81, t351); // row 5, MSZ7
    }
}
