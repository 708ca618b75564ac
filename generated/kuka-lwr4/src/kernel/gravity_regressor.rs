//! Regressor at rest.
//!
//! `g = W_g phi` for the links' parameters only; columns as the first of `STANDARD_NAMES`.
//!
//! 236 multiplications, 133 additions; 7 x 70, 89 of 490 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{Trig};

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
    let L2 = S::constant(0.4);
    let L3 = S::constant(0.39);
    let k0 = S::constant(9.81);
    // link 2: motion
    let [a2_x, a2_y] = {
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        put(21, a2_y); // row 2, MSX2
        [a2_x, a2_y]
    };
    // link 3: motion
    let [a3_x, t3] = {
        let a3_x = c3 * a2_x;
        let t3 = s3 * a2_x;
        [a3_x, t3]
    };
    // link 4: motion
    let [t6, a5_z] = {
        let t6 = s4 * a2_y - c4 * a3_x;
        let a5_z = c4 * a2_y + s4 * a3_x;
        put(61, t6); // row 4, MSY4
        [t6, a5_z]
    };
    // link 5: motion
    let [t12, a5_y] = {
        let t12 = c5 * t6 + s5 * t3;
        let a5_y = s5 * t6 - c5 * t3;
        put(74, a5_y); // row 5, MSX5
        put(75, t12); // row 5, MSY5
        [t12, a5_y]
    };
    // link 6: motion
    let [a6_x, a6_y] = {
        let a6_x = s6 * a5_z - c6 * t12;
        let a6_y = c6 * a5_z + s6 * t12;
        put(82, a6_y); // row 6, MSX6
        [a6_x, a6_y]
    };
    // link 7: motion
    let [a7_x, t27] = {
        let a7_x = c7 * a6_x + s7 * a5_y;
        let t27 = s7 * a6_x - c7 * a5_y;
        [a7_x, t27]
    };
    // joint axes in frame 3
    let [z1_3_x, t29] = {
        let z1_3_x = s2 * c3;
        let t29 = s2 * s3;
        [z1_3_x, t29]
    };
    // MSZ2: column
    {
        let t32 = c2 * a2_x - s2 * a2_y;
        put(0, t32); // row 1, MSZ2
    }
    // MSZ3: column
    let [t38, t40] = {
        let t35 = t3 * z1_3_x - a3_x * t29;
        let t38 = s3 * t3 + c3 * a3_x;
        let t39 = L2 * t35;
        let t40 = L2 * t38;
        put(1, t39); // row 1, M3
        put(4, t35); // row 1, MSZ3
        [t38, t40]
    };
    // MSX3: column
    {
        let t43 = a2_y * t29 - c2 * t3;
        let t44 = c3 * a2_y;
        put(2, t43); // row 1, MSX3
        put(24, t44); // row 2, MSX3
    }
    // MSY3: column
    let t48 = {
        let t47 = a2_y * z1_3_x - c2 * a3_x;
        let t48 = s3 * a2_y;
        put(3, t47); // row 1, MSY3
        t48
    };
    // M4: column
    let [t50, t51, t54] = {
        let t50 = s4 * a5_z;
        let t51 = c4 * t6 - t50;
        let t54 = s4 * t6 + c4 * a5_z;
        let t55 = L2 * t3;
        let t56 = L2 * t51;
        let t59 = z1_3_x * t55 + t29 * t56;
        let t62 = c3 * t56 - s3 * t55;
        put(5, t59); // row 1, M4
        put(27, t62); // row 2, M4
        put(47, t51); // row 3, MSZ4
        [t50, t51, t54]
    };
    // MSX4: column
    let [t63, t64] = {
        let t63 = s4 * t3;
        let t64 = c4 * t3;
        let t69 = a5_z * t29 - z1_3_x * t63 - c2 * t64;
        let t72 = s3 * t63 + c3 * a5_z;
        put(6, t69); // row 1, MSX4
        put(28, t72); // row 2, MSX4
        put(46, t63); // row 3, MSY4
        [t63, t64]
    };
    // MSY4: column
    {
        let t77 = c2 * t63 - (z1_3_x * t64 + t6 * t29);
        let t80 = s3 * t64 - c3 * t6;
        put(7, t77); // row 1, MSY4
        put(29, t80); // row 2, MSY4
    }
    // MSZ4: column
    let t84 = {
        let t83 = z1_3_x * t54 + c2 * t51;
        let t84 = s3 * t54;
        put(8, t83); // row 1, MSZ4
        t84
    };
    // M5: column
    let [t86, t87, t89, t90, t92] = {
        let t86 = s5 * a5_y;
        let t87 = c5 * t12 + t86;
        let t89 = c5 * a5_y;
        let t90 = t89 - s5 * t12;
        let t91 = L3 * t90;
        let t92 = L3 * t87;
        let t96 = s4 * t91;
        let t99 = c4 * t91 + L2 * t90;
        let t100 = t92 + L2 * (c4 * t87 - t50);
        let t105 = c2 * t96 + (t29 * t100 - z1_3_x * t99);
        let t108 = s3 * t99 + c3 * t100;
        put(9, t105); // row 1, M5
        put(31, t108); // row 2, M5
        put(48, t96); // row 3, M5
        [t86, t87, t89, t90, t92]
    };
    // MSX5: column
    let [t109, t110] = {
        let t109 = s5 * a5_z;
        let t110 = c5 * a5_z;
        let t113 = c4 * t109 + s4 * a5_y;
        let t116 = c4 * a5_y - s4 * t109;
        let t121 = c2 * t116 + (z1_3_x * t113 + t29 * t110);
        let t124 = c3 * t110 - s3 * t113;
        put(10, t121); // row 1, MSX5
        put(32, t124); // row 2, MSX5
        put(49, t116); // row 3, MSX5
        put(64, t109); // row 4, MSY5
        [t109, t110]
    };
    // MSY5: column
    let t138 = {
        let t127 = c4 * t110 + s4 * t12;
        let t130 = c4 * t12 - s4 * t110;
        let t135 = c2 * t130 + (z1_3_x * t127 - t29 * t109);
        let t138 = s3 * t127 + c3 * t109;
        put(11, t135); // row 1, MSY5
        put(50, t130); // row 3, MSY5
        t138
    };
    // MSZ5: column
    {
        let t139 = c4 * t90;
        let t140 = s4 * t90;
        let t145 = c2 * t140 + (t29 * t87 - z1_3_x * t139);
        let t148 = s3 * t139 + c3 * t87;
        put(12, t145); // row 1, MSZ5
        put(34, t148); // row 2, MSZ5
        put(51, t140); // row 3, MSZ5
    }
    // M6: column
    let [t150, t151, t153, t154] = {
        let t150 = s6 * a6_y;
        let t151 = c6 * a6_x - t150;
        let t153 = c6 * a6_y;
        let t154 = s6 * a6_x + t153;
        let t156 = c5 * t151 - t86;
        let t158 = t89 + s5 * t151;
        let t159 = L3 * t158;
        let t160 = L3 * t156;
        let t165 = s4 * t159;
        let t168 = c4 * t159 + L2 * t158;
        let t169 = t160 + L2 * (c4 * t156 + s4 * t154);
        let t174 = c2 * t165 - (z1_3_x * t168 + t29 * t169);
        let t177 = s3 * t168 - c3 * t169;
        put(13, t174); // row 1, M6
        put(35, t177); // row 2, M6
        put(52, t165); // row 3, M6
        put(66, t160); // row 4, M6
        put(78, t151); // row 5, MSZ6
        [t150, t151, t153, t154]
    };
    // MSX6: column
    let [t178, t179, t185] = {
        let t178 = s6 * a5_y;
        let t179 = c6 * a5_y;
        let t182 = c5 * t178 - s5 * a6_y;
        let t185 = s5 * t178 + c5 * a6_y;
        let t188 = c4 * t182 - s4 * t179;
        let t191 = s4 * t182 + c4 * t179;
        let t196 = c2 * t191 - (z1_3_x * t188 - t29 * t185);
        let t199 = s3 * t188 + c3 * t185;
        put(14, t196); // row 1, MSX6
        put(36, t199); // row 2, MSX6
        put(53, t191); // row 3, MSX6
        put(76, t179); // row 5, MSX6
        [t178, t179, t185]
    };
    // MSY6: column
    {
        let t202 = c5 * t179 + s5 * a6_x;
        let t205 = c5 * a6_x - s5 * t179;
        let t208 = c4 * t202 + s4 * t178;
        let t211 = s4 * t202 - c4 * t178;
        let t216 = c2 * t211 - (z1_3_x * t208 + t29 * t205);
        let t219 = s3 * t208 - c3 * t205;
        put(15, t216); // row 1, MSY6
        put(37, t219); // row 2, MSY6
        put(54, t211); // row 3, MSY6
        put(68, t205); // row 4, MSY6
    }
    // MSZ6: column
    let t221 = {
        let t220 = c5 * t154;
        let t221 = s5 * t154;
        let t224 = c4 * t220 - s4 * t151;
        let t227 = s4 * t220 + c4 * t151;
        let t232 = c2 * t227 + (t29 * t221 - z1_3_x * t224);
        let t235 = s3 * t224 + c3 * t221;
        put(16, t232); // row 1, MSZ6
        put(38, t235); // row 2, MSZ6
        put(55, t227); // row 3, MSZ6
        t221
    };
    // M7: column
    let [t238, t241] = {
        let t238 = c7 * a7_x + s7 * t27;
        let t241 = c7 * t27 - s7 * a7_x;
        let t243 = c6 * t238 - t150;
        let t248 = c5 * t243 + s5 * t241;
        let t251 = s5 * t243 - c5 * t241;
        let t252 = L3 * t251;
        let t253 = L3 * t248;
        let t258 = s4 * t252;
        let t261 = c4 * t252 + L2 * t251;
        let t262 = t253 + L2 * (c4 * t248 + s4 * (t153 + s6 * t238));
        let t267 = c2 * t258 - (z1_3_x * t261 + t29 * t262);
        let t270 = s3 * t261 - c3 * t262;
        put(17, t267); // row 1, M7
        put(39, t270); // row 2, M7
        put(56, t258); // row 3, M7
        put(70, t253); // row 4, M7
        [t238, t241]
    };
    // MSX7: column
    let [t271, t272, t284] = {
        let t271 = s7 * a6_y;
        let t272 = c7 * a6_y;
        let t275 = c6 * t271 + s6 * t27;
        let t278 = s6 * t271 - c6 * t27;
        let t281 = c5 * t275 + s5 * t272;
        let t284 = c5 * t272 - s5 * t275;
        let t287 = c4 * t281 + s4 * t278;
        let t290 = c4 * t278 - s4 * t281;
        let t295 = c2 * t290 + (z1_3_x * t287 + t29 * t284);
        let t298 = c3 * t284 - s3 * t287;
        put(18, t295); // row 1, MSX7
        put(40, t298); // row 2, MSX7
        put(57, t290); // row 3, MSX7
        put(79, t278); // row 5, MSX7
        put(84, t272); // row 6, MSX7
        [t271, t272, t284]
    };
    // MSY7: column
    {
        let t301 = c6 * t272 + s6 * a7_x;
        let t304 = s6 * t272 - c6 * a7_x;
        let t307 = s5 * t271 - c5 * t301;
        let t310 = s5 * t301 + c5 * t271;
        let t313 = c4 * t307 - s4 * t304;
        let t316 = s4 * t307 + c4 * t304;
        let t321 = c2 * t316 - (z1_3_x * t313 + t29 * t310);
        let t324 = s3 * t313 - c3 * t310;
        put(19, t321); // row 1, MSY7
        put(41, t324); // row 2, MSY7
        put(58, t316); // row 3, MSY7
        put(72, t310); // row 4, MSY7
        put(80, t304); // row 5, MSY7
    }
    // MSZ7: column
    {
        let t325 = c6 * t241;
        let t326 = s6 * t241;
        let t329 = s5 * t238 - c5 * t325;
        let t332 = s5 * t325 + c5 * t238;
        let t335 = c4 * t329 - s4 * t326;
        let t338 = s4 * t329 + c4 * t326;
        let t343 = c2 * t338 - (z1_3_x * t335 + t29 * t332);
        let t346 = s3 * t335 - c3 * t332;
        let t347 = -a2_x;
        let t348 = -t40;
        let t349 = -t48;
        let t350 = -t38;
        let t351 = -t84;
        let t352 = -t138;
        let t353 = -t3;
        let t354 = -a3_x;
        let t355 = -t64;
        let t356 = -a5_z;
        let t357 = -t92;
        let t358 = -t110;
        let t359 = -t87;
        let t360 = -t185;
        let t361 = -t221;
        let t362 = -t284;
        let t363 = -t178;
        let t364 = -a6_x;
        let t365 = -t271;
        let t366 = -t238;
        let t367 = -t27;
        let t368 = -a7_x;
        put(20, t343); // row 1, MSZ7
        put(22, t347); // row 2, MSY2
        put(23, t348); // row 2, M3
        put(25, t349); // row 2, MSY3
        put(26, t350); // row 2, MSZ3
        put(30, t351); // row 2, MSZ4
        put(33, t352); // row 2, MSY5
        put(42, t346); // row 2, MSZ7
        put(43, t353); // row 3, MSX3
        put(44, t354); // row 3, MSY3
        put(45, t355); // row 3, MSX4
        put(59, t338); // row 3, MSZ7
        put(60, t356); // row 4, MSX4
        put(62, t357); // row 4, M5
        put(63, t358); // row 4, MSX5
        put(65, t359); // row 4, MSZ5
        put(67, t360); // row 4, MSX6
        put(69, t361); // row 4, MSZ6
        put(71, t362); // row 4, MSX7
        put(73, t332); // row 4, MSZ7
        put(77, t363); // row 5, MSY6
        put(81, t326); // row 5, MSZ7
        put(83, t364); // row 6, MSY6
        put(85, t365); // row 6, MSY7
        put(86, t366); // row 6, MSZ7
        put(87, t367); // row 7, MSX7
        put(88, t368); // row 7, MSY7
    }
}
