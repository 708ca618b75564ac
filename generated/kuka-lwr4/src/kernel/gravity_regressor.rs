//! Regressor at rest.
//!
//! `g = W_g phi` for the links' parameters only; columns as the first of `STANDARD_NAMES`.
//!
//! 237 multiplications, 135 additions; 7 x 70, 89 of 490 structurally nonzero.

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
    flat[163..171].fill(S::default());
    flat[174..180].fill(S::default());
    flat[184..190].fill(S::default());
    flat[194..200].fill(S::default());
    flat[204..241].fill(S::default());
    flat[243..250].fill(S::default());
    flat[254..260].fill(S::default());
    flat[264..270].fill(S::default());
    flat[274..321].fill(S::default());
    flat[323..331].fill(S::default());
    flat[334..341].fill(S::default());
    flat[344..401].fill(S::default());
    flat[403..411].fill(S::default());
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
    let [z1_3_x, t3, a3_x, t5] = {
        let z1_3_x = s2 * c3;
        let t3 = s2 * s3;
        let a3_x = c3 * a2_x;
        let t5 = s3 * a2_x;
        [z1_3_x, t3, a3_x, t5]
    };
    // link 4: motion
    let [t8, a5_z] = {
        let t8 = s4 * a2_y - c4 * a3_x;
        let a5_z = c4 * a2_y + s4 * a3_x;
        put(61, t8); // row 4, MSY4
        [t8, a5_z]
    };
    // link 5: motion
    let [t14, a5_y] = {
        let t14 = c5 * t8 + s5 * t5;
        let a5_y = s5 * t8 - c5 * t5;
        put(74, a5_y); // row 5, MSX5
        put(75, t14); // row 5, MSY5
        [t14, a5_y]
    };
    // link 6: motion
    let [a6_x, a6_y] = {
        let a6_x = s6 * a5_z - c6 * t14;
        let a6_y = c6 * a5_z + s6 * t14;
        put(82, a6_y); // row 6, MSX6
        [a6_x, a6_y]
    };
    // link 7: motion
    let [a7_x, t29] = {
        let a7_x = c7 * a6_x + s7 * a5_y;
        let t29 = s7 * a6_x - c7 * a5_y;
        [a7_x, t29]
    };
    // MSZ2: column
    {
        let t32 = c2 * a2_x - s2 * a2_y;
        put(0, t32); // row 1, MSZ2
    }
    // M3: column
    let [t35, t38, t40] = {
        let t33 = L2 * t5;
        let t34 = L2 * a3_x;
        let t35 = z1_3_x * t33;
        let t37 = t35 - t3 * t34;
        let t38 = s3 * t33;
        let t40 = t38 + c3 * t34;
        put(1, t37); // row 1, M3
        [t35, t38, t40]
    };
    // MSX3: column
    {
        let t43 = a2_y * t3 - c2 * t5;
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
    // MSZ3: column
    let t54 = {
        let t51 = z1_3_x * t5 - t3 * a3_x;
        let t54 = s3 * t5 + c3 * a3_x;
        put(4, t51); // row 1, MSZ3
        t54
    };
    // M4: column
    let [t56, t57, t60] = {
        let t56 = s4 * a5_z;
        let t57 = c4 * t8 - t56;
        let t60 = s4 * t8 + c4 * a5_z;
        let t61 = L2 * t57;
        let t63 = t35 + t3 * t61;
        let t65 = c3 * t61 - t38;
        put(5, t63); // row 1, M4
        put(27, t65); // row 2, M4
        put(47, t57); // row 3, MSZ4
        [t56, t57, t60]
    };
    // MSX4: column
    let [t66, t67] = {
        let t66 = s4 * t5;
        let t67 = c4 * t5;
        let t72 = t3 * a5_z - z1_3_x * t66 - c2 * t67;
        let t75 = s3 * t66 + c3 * a5_z;
        put(6, t72); // row 1, MSX4
        put(28, t75); // row 2, MSX4
        put(46, t66); // row 3, MSY4
        [t66, t67]
    };
    // MSY4: column
    {
        let t80 = c2 * t66 - (z1_3_x * t67 + t3 * t8);
        let t83 = s3 * t67 - c3 * t8;
        put(7, t80); // row 1, MSY4
        put(29, t83); // row 2, MSY4
    }
    // MSZ4: column
    let t87 = {
        let t86 = z1_3_x * t60 + c2 * t57;
        let t87 = s3 * t60;
        put(8, t86); // row 1, MSZ4
        t87
    };
    // M5: column
    let [t89, t90, t92, t93, t95] = {
        let t89 = s5 * a5_y;
        let t90 = c5 * t14 + t89;
        let t92 = c5 * a5_y;
        let t93 = t92 - s5 * t14;
        let t94 = L3 * t93;
        let t95 = L3 * t90;
        let t99 = s4 * t94;
        let t102 = c4 * t94 + L2 * t93;
        let t103 = t95 + L2 * (c4 * t90 - t56);
        let t108 = c2 * t99 + (t3 * t103 - z1_3_x * t102);
        let t111 = s3 * t102 + c3 * t103;
        put(9, t108); // row 1, M5
        put(31, t111); // row 2, M5
        put(48, t99); // row 3, M5
        [t89, t90, t92, t93, t95]
    };
    // MSX5: column
    let [t112, t113] = {
        let t112 = s5 * a5_z;
        let t113 = c5 * a5_z;
        let t116 = c4 * t112 + s4 * a5_y;
        let t119 = c4 * a5_y - s4 * t112;
        let t124 = c2 * t119 + (z1_3_x * t116 + t3 * t113);
        let t127 = c3 * t113 - s3 * t116;
        put(10, t124); // row 1, MSX5
        put(32, t127); // row 2, MSX5
        put(49, t119); // row 3, MSX5
        put(64, t112); // row 4, MSY5
        [t112, t113]
    };
    // MSY5: column
    let t141 = {
        let t130 = c4 * t113 + s4 * t14;
        let t133 = c4 * t14 - s4 * t113;
        let t138 = c2 * t133 - (t3 * t112 - z1_3_x * t130);
        let t141 = s3 * t130 + c3 * t112;
        put(11, t138); // row 1, MSY5
        put(50, t133); // row 3, MSY5
        t141
    };
    // MSZ5: column
    {
        let t142 = c4 * t93;
        let t143 = s4 * t93;
        let t148 = c2 * t143 - (z1_3_x * t142 - t3 * t90);
        let t151 = s3 * t142 + c3 * t90;
        put(12, t148); // row 1, MSZ5
        put(34, t151); // row 2, MSZ5
        put(51, t143); // row 3, MSZ5
    }
    // M6: column
    let [t153, t154, t156, t157] = {
        let t153 = s6 * a6_y;
        let t154 = c6 * a6_x - t153;
        let t156 = c6 * a6_y;
        let t157 = s6 * a6_x + t156;
        let t159 = c5 * t154 - t89;
        let t161 = t92 + s5 * t154;
        let t162 = L3 * t161;
        let t163 = L3 * t159;
        let t168 = s4 * t162;
        let t171 = c4 * t162 + L2 * t161;
        let t172 = t163 + L2 * (c4 * t159 + s4 * t157);
        let t177 = c2 * t168 - (z1_3_x * t171 + t3 * t172);
        let t180 = s3 * t171 - c3 * t172;
        put(13, t177); // row 1, M6
        put(35, t180); // row 2, M6
        put(52, t168); // row 3, M6
        put(66, t163); // row 4, M6
        put(78, t154); // row 5, MSZ6
        [t153, t154, t156, t157]
    };
    // MSX6: column
    let [t181, t182, t188] = {
        let t181 = s6 * a5_y;
        let t182 = c6 * a5_y;
        let t185 = c5 * t181 - s5 * a6_y;
        let t188 = s5 * t181 + c5 * a6_y;
        let t191 = c4 * t185 - s4 * t182;
        let t194 = s4 * t185 + c4 * t182;
        let t199 = c2 * t194 + (t3 * t188 - z1_3_x * t191);
        let t202 = s3 * t191 + c3 * t188;
        put(14, t199); // row 1, MSX6
        put(36, t202); // row 2, MSX6
        put(53, t194); // row 3, MSX6
        put(76, t182); // row 5, MSX6
        [t181, t182, t188]
    };
    // MSY6: column
    {
        let t205 = c5 * t182 + s5 * a6_x;
        let t208 = c5 * a6_x - s5 * t182;
        let t211 = c4 * t205 + s4 * t181;
        let t214 = s4 * t205 - c4 * t181;
        let t219 = c2 * t214 - (z1_3_x * t211 + t3 * t208);
        let t222 = s3 * t211 - c3 * t208;
        put(15, t219); // row 1, MSY6
        put(37, t222); // row 2, MSY6
        put(54, t214); // row 3, MSY6
        put(68, t208); // row 4, MSY6
    }
    // MSZ6: column
    let t224 = {
        let t223 = c5 * t157;
        let t224 = s5 * t157;
        let t227 = s4 * t154 - c4 * t223;
        let t230 = s4 * t223 + c4 * t154;
        let t235 = c2 * t230 + (z1_3_x * t227 + t3 * t224);
        let t238 = c3 * t224 - s3 * t227;
        put(16, t235); // row 1, MSZ6
        put(38, t238); // row 2, MSZ6
        put(55, t230); // row 3, MSZ6
        t224
    };
    // M7: column
    let [t241, t244] = {
        let t241 = c7 * a7_x + s7 * t29;
        let t244 = c7 * t29 - s7 * a7_x;
        let t246 = c6 * t241 - t153;
        let t251 = c5 * t246 + s5 * t244;
        let t254 = s5 * t246 - c5 * t244;
        let t255 = L3 * t254;
        let t256 = L3 * t251;
        let t261 = s4 * t255;
        let t264 = c4 * t255 + L2 * t254;
        let t265 = t256 + L2 * (c4 * t251 + s4 * (t156 + s6 * t241));
        let t270 = c2 * t261 - (z1_3_x * t264 + t3 * t265);
        let t273 = s3 * t264 - c3 * t265;
        put(17, t270); // row 1, M7
        put(39, t273); // row 2, M7
        put(56, t261); // row 3, M7
        put(70, t256); // row 4, M7
        [t241, t244]
    };
    // MSX7: column
    let [t274, t275, t287] = {
        let t274 = s7 * a6_y;
        let t275 = c7 * a6_y;
        let t278 = c6 * t274 + s6 * t29;
        let t281 = s6 * t274 - c6 * t29;
        let t284 = c5 * t278 + s5 * t275;
        let t287 = c5 * t275 - s5 * t278;
        let t290 = c4 * t284 + s4 * t281;
        let t293 = c4 * t281 - s4 * t284;
        let t298 = c2 * t293 + (z1_3_x * t290 + t3 * t287);
        let t301 = c3 * t287 - s3 * t290;
        put(18, t298); // row 1, MSX7
        put(40, t301); // row 2, MSX7
        put(57, t293); // row 3, MSX7
        put(79, t281); // row 5, MSX7
        put(84, t275); // row 6, MSX7
        [t274, t275, t287]
    };
    // MSY7: column
    {
        let t304 = c6 * t275 + s6 * a7_x;
        let t307 = s6 * t275 - c6 * a7_x;
        let t310 = s5 * t274 - c5 * t304;
        let t313 = s5 * t304 + c5 * t274;
        let t316 = c4 * t310 - s4 * t307;
        let t319 = s4 * t310 + c4 * t307;
        let t324 = c2 * t319 - (z1_3_x * t316 + t3 * t313);
        let t327 = s3 * t316 - c3 * t313;
        put(19, t324); // row 1, MSY7
        put(41, t327); // row 2, MSY7
        put(58, t319); // row 3, MSY7
        put(72, t313); // row 4, MSY7
        put(80, t307); // row 5, MSY7
    }
    // MSZ7: column
    {
        let t328 = c6 * t244;
        let t329 = s6 * t244;
        let t332 = s5 * t241 - c5 * t328;
        let t335 = s5 * t328 + c5 * t241;
        let t338 = c4 * t332 - s4 * t329;
        let t341 = s4 * t332 + c4 * t329;
        let t346 = c2 * t341 - (z1_3_x * t338 + t3 * t335);
        let t349 = s3 * t338 - c3 * t335;
        let t350 = -a2_x;
        let t351 = -t40;
        let t352 = -t48;
        let t353 = -t54;
        let t354 = -t87;
        let t355 = -t141;
        let t356 = -t5;
        let t357 = -a3_x;
        let t358 = -t67;
        let t359 = -a5_z;
        let t360 = -t95;
        let t361 = -t113;
        let t362 = -t90;
        let t363 = -t188;
        let t364 = -t224;
        let t365 = -t287;
        let t366 = -t181;
        let t367 = -a6_x;
        let t368 = -t274;
        let t369 = -t241;
        let t370 = -t29;
        let t371 = -a7_x;
        put(20, t346); // row 1, MSZ7
        put(22, t350); // row 2, MSY2
        put(23, t351); // row 2, M3
        put(25, t352); // row 2, MSY3
        put(26, t353); // row 2, MSZ3
        put(30, t354); // row 2, MSZ4
        put(33, t355); // row 2, MSY5
        put(42, t349); // row 2, MSZ7
        put(43, t356); // row 3, MSX3
        put(44, t357); // row 3, MSY3
        put(45, t358); // row 3, MSX4
        put(59, t341); // row 3, MSZ7
        put(60, t359); // row 4, MSX4
        put(62, t360); // row 4, M5
        put(63, t361); // row 4, MSX5
        put(65, t362); // row 4, MSZ5
        put(67, t363); // row 4, MSX6
        put(69, t364); // row 4, MSZ6
        put(71, t365); // row 4, MSX7
        put(73, t335); // row 4, MSZ7
        put(77, t366); // row 5, MSY6
        put(81, t329); // row 5, MSZ7
        put(83, t367); // row 6, MSY6
        put(85, t368); // row 6, MSY7
        put(86, t369); // row 6, MSZ7
        put(87, t370); // row 7, MSX7
        put(88, t371); // row 7, MSY7
    }
}
