//! Mass matrix `M`, symmetric, kg m^2.
//!
//! From the base parameters, rotors on the diagonal, by composite bodies. Featherstone, 6.2.
//!
//! 223 multiplications, 190 additions; 7 x 7, 49 of 49 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{BASE, Trig, constants};

/// Mass matrix `M`, symmetric, kg m^2: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], out: &mut [[S; 7]; 7]) {
    entries(trig, beta, |k, x| {
        out[k / 7][k % 7] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [
        ZZ1R, _, _, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3R, MSY3R, XX3R, ZZ3R,
        XY3R, XZ3, YZ3, MSX4R, MSY4R, XX4R, ZZ4R, XY4R, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6R, MSY6R, XX6R, ZZ6R, XY6R, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7,
        ..] = *beta;
    let k0 = S::constant(0.088);
    let k_A = S::constant(constants::A);
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
    // composite body 7
    let [t2, t5, t8, t11, t95, t97, t98, t99] = {
        let t2 = c7 * MSY7 + s7 * MSX7;
        let t5 = s7 * MSY7 - c7 * MSX7;
        let t8 = s7 * YZ7 - c7 * XZ7;
        let t11 = s7 * XZ7 + c7 * YZ7;
        let t12 = k0 * t5;
        let t13 = t12 - ZZ7;
        let t14 = c6 * t2;
        let t15 = s6 * t2;
        let t18 = c6 * t8 + s6 * t13;
        let t21 = c6 * t13 - s6 * t8;
        let t24 = c5 * t14 + s5 * t5;
        let t27 = c5 * t5 - s5 * t14;
        let t38 = k_A * t27;
        let t39 = c5 * t18 - s5 * t11 + k_L3 * t27;
        let t40 = s5 * t18 + c5 * t11 + (k_L3 * t24 + k_A * t15);
        let t41 = t21 - t38;
        let t44 = s4 * t15 - c4 * t24;
        let t50 = c4 * t39 + s4 * t41;
        let t55 = t38 + (c4 * t41 - s4 * t39);
        let t56 = t40 - k_A * (s4 * t24 + c4 * t15);
        let t71 = k_L2 * (s3 * t44 + c3 * t27) - (s3 * t56 - c3 * t50);
        let t72 = k_L2 * (c3 * t44 - s3 * t27) - (s3 * t50 + c3 * t56);
        let t75 = s2 * t71 + c2 * t55;
        let t77 = s7 * XY7;
        let t80 = c7 * XY7;
        let t81 = s7 * XX7R + t80;
        let t92 = k0 * (t5 + t5);
        let t95 = c7 * (t77 - c7 * XX7R) + s7 * t80 + t92 - (t12 + t12);
        let t97 = s7 * t77 - c7 * t81 + k0 * t2;
        let t98 = s7 * t81 + c7 * t77 - t92;
        let t99 = ZZ7 - t92;
        put(6, t75); // [0][6]
        put(13, t72); // [1][6]
        put(20, t55); // [2][6]
        put(27, t40); // [3][6]
        put(34, t21); // [4][6]
        put(41, t11); // [5][6]
        put(42, t75); // [6][0]
        put(43, t72); // [6][1]
        put(44, t55); // [6][2]
        put(45, t40); // [6][3]
        put(46, t21); // [6][4]
        put(47, t11); // [6][5]
        put(48, ZZ7); // [6][6]
        [t2, t5, t8, t11, t95, t97, t98, t99]
    };
    // composite body 6
    let [
        t108, t111, t114, t117, t121, t124, t180, t183,
        t186, t187,
    ] = {
        let t100 = t5 - MSX6R;
        let t101 = t95 - XX6R;
        let t102 = ZZ6R + t98;
        let t103 = XY6R + t8;
        let t104 = XZ6 - t97;
        let t105 = t11 - YZ6;
        let t108 = s6 * t100 - c6 * MSY6R;
        let t111 = s6 * MSY6R + c6 * t100;
        let t114 = c6 * t104 + s6 * t105;
        let t117 = s6 * t104 - c6 * t105;
        let t118 = c5 * t108;
        let t119 = s5 * t108;
        let t121 = s5 * t102;
        let t124 = c5 * t102;
        let t130 = k_A * t119;
        let t131 = k_L3 * t119 - (c5 * t114 + t121);
        let t132 = k_A * t111 - k_L3 * t118 - (s5 * t114 - t124);
        let t133 = t117 - t130;
        let t136 = c4 * t118 + s4 * t111;
        let t142 = c4 * t131 + s4 * t133;
        let t147 = t130 + (c4 * t133 - s4 * t131);
        let t148 = k_A * (c4 * t111 - s4 * t118) - t132;
        let t163 = c3 * t142 + s3 * t148 + k_L2 * (s3 * t136 + c3 * t119);
        let t164 = c3 * t148 - s3 * t142 - k_L2 * (s3 * t119 - c3 * t136);
        let t167 = s2 * t163 + c2 * t147;
        let t169 = s6 * t103;
        let t172 = c6 * t103;
        let t173 = t172 - s6 * t101;
        let t177 = t169 + c6 * t99;
        let t180 = c6 * (c6 * t101 + t169) + s6 * (t172 - s6 * t99);
        let t183 = s6 * t177 - c6 * t173;
        let t186 = s6 * t173 + c6 * t177;
        let t187 = t108 + t108;
        put(5, t167); // [0][5]
        put(12, t164); // [1][5]
        put(19, t147); // [2][5]
        put(26, t132); // [3][5]
        put(33, t117); // [4][5]
        put(35, t167); // [5][0]
        put(36, t164); // [5][1]
        put(37, t147); // [5][2]
        put(38, t132); // [5][3]
        put(39, t117); // [5][4]
        put(40, t102); // [5][5]
        [
        t108, t111, t114, t117, t121, t124, t180, t183,
        t186, t187,
    ]
    };
    // composite body 5
    let [
        t197, t200, t211, t266, t267, t268, t271, t272,
        t276,
    ] = {
        let t188 = t111 - MSX5;
        let t189 = t2 - MSY5R;
        let t190 = XX5R - t180;
        let t191 = ZZ5R + t186;
        let t192 = XY5 - t114;
        let t193 = XZ5 - t183;
        let t194 = t117 - YZ5;
        let t197 = c5 * t189 + s5 * t188;
        let t200 = s5 * t189 - c5 * t188;
        let t203 = c5 * t193 + s5 * t194;
        let t207 = k_L3 * t200;
        let t209 = k_A * t200;
        let t210 = t203 - t207;
        let t211 = c5 * t194 - s5 * t193 - k_L3 * t197;
        let t212 = t191 - t209;
        let t213 = c4 * t197;
        let t217 = c4 * t210 - s4 * t212;
        let t222 = t209 + (s4 * t210 + c4 * t212);
        let t223 = t211 + k_A * (s4 * t197);
        let t238 = c3 * t217 + s3 * t223 - k_L2 * (s3 * t213 + c3 * t200);
        let t239 = s3 * t217 - c3 * t223 + k_L2 * (c3 * t213 - s3 * t200);
        let t242 = c2 * t222 - s2 * t238;
        let t244 = s5 * t192;
        let t247 = c5 * t192;
        let t248 = s5 * t190 + t247;
        let t250 = t124 + t244;
        let t263 = k_A * (t200 + t200) + k_L3 * t187;
        let t264 = s5 * (t247 - t121) - c5 * (c5 * t190 - t244) + t263;
        let t266 = t209 + t209 - t264;
        let t267 = k_A * t197;
        let t268 = s5 * t250 - c5 * t248 + t267;
        let t271 = t203 - (t207 + k_A * t108);
        let t272 = s5 * t248 + c5 * t250 - t263;
        let t274 = k_L3 * t108;
        let t276 = t191 - t263 + (t274 + t274);
        put(4, t242); // [0][4]
        put(11, t239); // [1][4]
        put(18, t222); // [2][4]
        put(25, t211); // [3][4]
        put(28, t242); // [4][0]
        put(29, t239); // [4][1]
        put(30, t222); // [4][2]
        put(31, t211); // [4][3]
        put(32, t191); // [4][4]
        [
        t197, t200, t211, t266, t267, t268, t271, t272,
        t276,
    ]
    };
    // composite body 4
    let [
        t286, t289, t295, t333, t337, t339, t340, t341,
        t342,
    ] = {
        let t277 = MSX4R + t200;
        let t278 = t108 - MSY4R;
        let t279 = XX4R + t266;
        let t280 = ZZ4R + t272;
        let t281 = XY4R + t271;
        let t282 = XZ4 + t268;
        let t283 = YZ4 + t211;
        let t286 = s4 * t277 - c4 * t278;
        let t289 = s4 * t278 + c4 * t277;
        let t292 = c4 * t282 - s4 * t283;
        let t295 = s4 * t282 + c4 * t283;
        let t296 = k_A * t289;
        let t297 = t280 + t296;
        let t309 = s3 * t292 - c3 * t297 - k_L2 * (c3 * t286);
        let t310 = s2 * (c3 * t292 + s3 * t297 + k_L2 * (s3 * t286));
        let t312 = c2 * t295 - t310;
        let t314 = s4 * t281;
        let t317 = c4 * t281;
        let t318 = s4 * t279 + t317;
        let t322 = t314 + c4 * t276;
        let t333 = t286 + t286;
        let t334 = k_A * (t289 + t289);
        let t335 = c4 * (c4 * t279 - t314) + s4 * (s4 * t276 - t317) + t334;
        let t337 = t296 + t296 - t335;
        let t339 = s4 * t322 - c4 * t318 + k_A * t286;
        let t340 = t267 - t292;
        let t341 = s4 * t318 + c4 * t322 + t334;
        let t342 = t280 + t334;
        put(3, t312); // [0][3]
        put(10, t309); // [1][3]
        put(17, t295); // [2][3]
        put(21, t312); // [3][0]
        put(22, t309); // [3][1]
        put(23, t295); // [3][2]
        put(24, t280); // [3][3]
        [
        t286, t289, t295, t333, t337, t339, t340, t341,
        t342,
    ]
    };
    // composite body 3
    let [t364, t365, t384, t389, t390, t394] = {
        let t343 = MSX3R + t289;
        let t344 = MSY3R - t197;
        let t345 = XX3R - t337;
        let t346 = ZZ3R + t341;
        let t347 = XY3R + t340;
        let t348 = XZ3 - t339;
        let t349 = t295 - YZ3;
        let t364 = c3 * t348 + s3 * t349 + k_L2 * (s3 * t344 - c3 * t343);
        let t365 = s3 * t348 - c3 * t349 - k_L2 * (c3 * t344 + s3 * t343);
        let t368 = c2 * t346 - s2 * t364;
        let t370 = s3 * t347;
        let t373 = c3 * t347;
        let t374 = s3 * t345 + t373;
        let t378 = t370 + c3 * t342;
        let t384 = c3 * t374 - s3 * t378;
        let t388 = k_L2 * t333;
        let t389 = s3 * (s3 * t342 - t373) - c3 * (t370 - c3 * t345) + t388;
        let t390 = s3 * t374 + c3 * t378 + t388;
        let t392 = k_L2 * t286;
        let t394 = t346 + t388 - (t392 + t392);
        put(2, t368); // [0][2]
        put(9, t365); // [1][2]
        put(14, t368); // [2][0]
        put(15, t365); // [2][1]
        put(16, t346); // [2][2]
        [t364, t365, t384, t389, t390, t394]
    };
    // composite body 2
    let t411 = {
        let t396 = ZZ2R + t390;
        let t397 = t364 - XY2;
        let t402 = c2 * (t365 - YZ2) - s2 * (XZ2 + t384);
        let t410 = c2 * (s2 * t397 - c2 * t394);
        let t411 = s2 * (s2 * (XX2R + t389) - c2 * t397) - t410;
        put(1, t402); // [0][1]
        put(7, t402); // [1][0]
        put(8, t396); // [1][1]
        t411
    };
    // composite body 1
    {
        let t412 = ZZ1R + t411;
        put(0, t412); // [0][0]
    }
}
