//! Mass matrix `M`, symmetric, kg m^2.
//!
//! From the base parameters, rotors on the diagonal, by composite bodies. Featherstone, 6.2.
//!
//! 242 multiplications, 197 additions; 7 x 7, 49 of 49 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{BASE, Trig};

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
        ZZ1R, MSX2, MSY2R, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3, MSY3R, XX3R, ZZ3R,
        XY3, XZ3, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6R, XX6R, ZZ6R, XY6, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7,
        ..] = *beta;
    let k0 = S::constant(0.167455);
    let k1 = S::constant(0.00035);
    let k2 = S::constant(0.31436);
    let k3 = S::constant(0.01275);
    let k4 = S::constant(0.42076);
    let k5 = S::constant(0.01175);
    // composite body 7
    let [
        t2, t5, t14, t15, t19, t22, t92, t95,
        t98, t99,
    ] = {
        let t2 = c7 * MSY7 + s7 * MSX7;
        let t5 = s7 * MSY7 - c7 * MSX7;
        let t14 = c7 * XZ7 - s7 * YZ7 - t5 * k0;
        let t15 = s7 * XZ7 + c7 * YZ7 + t2 * k0;
        let t16 = c6 * t2;
        let t17 = s6 * t2;
        let t19 = s6 * ZZ7;
        let t22 = c6 * ZZ7;
        let t26 = t17 * k1 - (c6 * t14 - t19);
        let t27 = s6 * t14 + t22 + t16 * k1;
        let t30 = s5 * t5 - c5 * t16;
        let t33 = s5 * t16 + c5 * t5;
        let t42 = c5 * t26 + s5 * t15 + t33 * k2;
        let t43 = t30 * k2 - (c5 * t15 - s5 * t26);
        let t46 = c4 * t30 + s4 * t17;
        let t49 = c4 * t17 - s4 * t30;
        let t58 = c4 * t42 + s4 * t27 + t49 * k3;
        let t59 = c4 * t27 - s4 * t42 - t46 * k3;
        let t62 = c3 * t46 + s3 * t33;
        let t74 = c3 * t58 - s3 * t43 + (c3 * t33 - s3 * t46) * k4;
        let t75 = s3 * t58 + c3 * t43 + t62 * k4;
        let t83 = c2 * t59 - s2 * t74 - (c2 * t62 + s2 * t49) * k5;
        let t85 = s7 * XY7;
        let t88 = c7 * XY7;
        let t89 = s7 * XX7R + t88;
        let t92 = c7 * (t85 - c7 * XX7R) + s7 * t88;
        let t95 = s7 * t85 - c7 * t89;
        let t98 = s7 * t89 + c7 * t85;
        let t99 = t2 + t2;
        put(6, t83); // [0][6]
        put(13, t75); // [1][6]
        put(20, t59); // [2][6]
        put(27, t43); // [3][6]
        put(34, t27); // [4][6]
        put(42, t83); // [6][0]
        put(43, t75); // [6][1]
        put(44, t59); // [6][2]
        put(45, t43); // [6][3]
        put(46, t27); // [6][4]
        put(48, ZZ7); // [6][6]
        [
        t2, t5, t14, t15, t19, t22, t92, t95,
        t98, t99,
    ]
    };
    // composite body 6
    let [
        t108, t111, t120, t121, t187, t191, t193, t194,
        t198,
    ] = {
        let t100 = MSX6 - t5;
        let t101 = t92 - XX6R;
        let t102 = ZZ6R + t98;
        let t103 = XY6 + t14;
        let t104 = XZ6 + t95;
        let t105 = YZ6 - t15;
        let t108 = c6 * MSY6R + s6 * t100;
        let t111 = s6 * MSY6R - c6 * t100;
        let t120 = k1 * t111 - (c6 * t104 - s6 * t105);
        let t121 = s6 * t104 + c6 * t105 + k1 * t108;
        let t122 = c5 * t108;
        let t123 = s5 * t108;
        let t132 = k2 * t123 - (s5 * t102 - c5 * t120);
        let t133 = s5 * t120 + c5 * t102 - k2 * t122;
        let t136 = s4 * t111 - c4 * t122;
        let t139 = s4 * t122 + c4 * t111;
        let t148 = c4 * t132 + s4 * t121 + k3 * t139;
        let t149 = c4 * t121 - s4 * t132 - k3 * t136;
        let t152 = c3 * t136 + s3 * t123;
        let t164 = s3 * t133 - c3 * t148 + k4 * (s3 * t136 - c3 * t123);
        let t165 = s3 * t148 + c3 * t133 + k4 * t152;
        let t173 = s2 * t164 + c2 * t149 - k5 * (c2 * t152 + s2 * t139);
        let t175 = s6 * t103;
        let t178 = c6 * t103;
        let t179 = s6 * t101 - t178;
        let t181 = t22 + t175;
        let t187 = c6 * t179 + s6 * t181;
        let t191 = t108 + t108;
        let t192 = k1 * t99;
        let t193 = t192 - (c6 * (c6 * t101 + t175) + s6 * (t178 - t19));
        let t194 = t192 - (s6 * t179 - c6 * t181);
        let t196 = t2 * k1;
        let t198 = t102 + t192 - (t196 + t196);
        put(5, t173); // [0][5]
        put(12, t165); // [1][5]
        put(19, t149); // [2][5]
        put(26, t133); // [3][5]
        put(33, t121); // [4][5]
        put(35, t173); // [5][0]
        put(36, t165); // [5][1]
        put(37, t149); // [5][2]
        put(38, t133); // [5][3]
        put(39, t121); // [5][4]
        put(40, t102); // [5][5]
        [
        t108, t111, t120, t121, t187, t191, t193, t194,
        t198,
    ]
    };
    // composite body 5
    let [
        t208, t211, t220, t221, t273, t277, t279, t280,
        t284,
    ] = {
        let t199 = t111 - MSX5;
        let t200 = MSY5R + t2;
        let t201 = XX5R + t193;
        let t202 = ZZ5R + t194;
        let t203 = XY5 + t120;
        let t204 = t187 - XZ5;
        let t205 = t121 - YZ5;
        let t208 = s5 * t199 - c5 * t200;
        let t211 = s5 * t200 + c5 * t199;
        let t220 = s5 * t205 - c5 * t204 - k2 * t211;
        let t221 = s5 * t204 + c5 * t205 + k2 * t208;
        let t222 = c4 * t208;
        let t223 = s4 * t208;
        let t232 = s4 * t202 - c4 * t220 - k3 * t223;
        let t233 = s4 * t220 + c4 * t202 - k3 * t222;
        let t236 = c3 * t222 + s3 * t211;
        let t248 = c3 * t232 - s3 * t221 - k4 * (s3 * t222 - c3 * t211);
        let t249 = s3 * t232 + c3 * t221 + k4 * t236;
        let t257 = c2 * t233 - s2 * t248 + k5 * (s2 * t223 - c2 * t236);
        let t259 = s5 * t203;
        let t262 = c5 * t203;
        let t263 = s5 * t201 + t262;
        let t267 = t259 + c5 * t198;
        let t273 = s5 * t267 - c5 * t263;
        let t277 = t208 + t208;
        let t278 = k2 * t191;
        let t279 = s5 * (t262 - s5 * t198) - c5 * (c5 * t201 - t259) + t278;
        let t280 = s5 * t263 + c5 * t267 - t278;
        let t282 = k2 * t108;
        let t284 = t202 - t278 + (t282 + t282);
        put(4, t257); // [0][4]
        put(11, t249); // [1][4]
        put(18, t233); // [2][4]
        put(25, t221); // [3][4]
        put(28, t257); // [4][0]
        put(29, t249); // [4][1]
        put(30, t233); // [4][2]
        put(31, t221); // [4][3]
        put(32, t202); // [4][4]
        [
        t208, t211, t220, t221, t273, t277, t279, t280,
        t284,
    ]
    };
    // composite body 4
    let [
        t294, t297, t306, t307, t343, t347, t349, t350,
        t354,
    ] = {
        let t285 = t211 - MSX4;
        let t286 = MSY4R + t108;
        let t287 = XX4R - t279;
        let t288 = ZZ4R + t280;
        let t289 = XY4 + t220;
        let t290 = XZ4 + t273;
        let t291 = YZ4 + t221;
        let t294 = s4 * t285 - c4 * t286;
        let t297 = s4 * t286 + c4 * t285;
        let t306 = s4 * t291 - c4 * t290 + k3 * t297;
        let t307 = s4 * t290 + c4 * t291 - k3 * t294;
        let t308 = c3 * t294;
        let t319 = s3 * t306 + c3 * t288 + k4 * t308;
        let t324 = c2 * t307;
        let t325 = s2 * (s3 * t288 - c3 * t306 + k4 * (s3 * t294)) + t324;
        let t327 = t325 - k5 * (c2 * t308 + s2 * t297);
        let t329 = s4 * t289;
        let t332 = c4 * t289;
        let t333 = s4 * t287 + t332;
        let t337 = t329 + c4 * t284;
        let t343 = s4 * t337 - c4 * t333;
        let t347 = t294 + t294;
        let t348 = k3 * t277;
        let t349 = c4 * (t329 - c4 * t287) + s4 * (t332 - s4 * t284) + t348;
        let t350 = s4 * t333 + c4 * t337 - t348;
        let t352 = k3 * t208;
        let t354 = t288 - t348 + (t352 + t352);
        put(3, t327); // [0][3]
        put(10, t319); // [1][3]
        put(17, t307); // [2][3]
        put(21, t327); // [3][0]
        put(22, t319); // [3][1]
        put(23, t307); // [3][2]
        put(24, t288); // [3][3]
        [
        t294, t297, t306, t307, t343, t347, t349, t350,
        t354,
    ]
    };
    // composite body 3
    let [t367, t376, t377, t399, t403, t405, t406, t410] = {
        let t355 = t297 - MSX3;
        let t356 = MSY3R - t208;
        let t357 = t349 - XX3R;
        let t358 = ZZ3R + t350;
        let t359 = XY3 + t306;
        let t360 = t343 - XZ3;
        let t361 = t307 - YZ3;
        let t364 = c3 * t356 - s3 * t355;
        let t367 = s3 * t356 + c3 * t355;
        let t376 = c3 * t360 - s3 * t361 + k4 * t367;
        let t377 = s3 * t360 + c3 * t361 - k4 * t364;
        let t383 = k5 * (c2 * t364) - (s2 * t376 - c2 * t358);
        let t385 = s3 * t359;
        let t388 = c3 * t359;
        let t389 = s3 * t357 - t388;
        let t393 = t385 + c3 * t354;
        let t399 = c3 * t389 + s3 * t393;
        let t403 = t364 + t364;
        let t404 = k4 * t347;
        let t405 = s3 * (s3 * t354 - t388) - c3 * (c3 * t357 + t385) + t404;
        let t406 = s3 * t389 - c3 * t393 - t404;
        let t408 = k4 * t294;
        let t410 = t358 + t404 - (t408 + t408);
        put(2, t383); // [0][2]
        put(9, t377); // [1][2]
        put(14, t383); // [2][0]
        put(15, t377); // [2][1]
        put(16, t358); // [2][2]
        [t367, t376, t377, t399, t403, t405, t406, t410]
    };
    // composite body 2
    let t436 = {
        let t414 = ZZ2R - t406;
        let t415 = t376 - XY2;
        let t424 = k5 * (c2 * (MSY2R - t294) + s2 * (MSX2 - t367));
        let t425 = s2 * (XZ2 + t399) + c2 * (YZ2 + t377) + t424;
        let t433 = c2 * (s2 * t415 - c2 * t410);
        let t436 = s2 * (c2 * t415 - s2 * (XX2R + t405)) + t433 - k5 * t403;
        put(1, t425); // [0][1]
        put(7, t425); // [1][0]
        put(8, t414); // [1][1]
        t436
    };
    // composite body 1
    {
        let t437 = ZZ1R - t436;
        let t438 = -t15;
        put(0, t437); // [0][0]
        put(41, t438); // [5][6]
        put(47, t438); // [6][5]
    }
}
