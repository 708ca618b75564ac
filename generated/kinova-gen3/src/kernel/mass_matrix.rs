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
fn entries<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
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
        let t100 = -t15;
        put(6, t83); // [0][6]
        put(13, t75); // [1][6]
        put(20, t59); // [2][6]
        put(27, t43); // [3][6]
        put(34, t27); // [4][6]
        put(41, t100); // [5][6]
        put(42, t83); // [6][0]
        put(43, t75); // [6][1]
        put(44, t59); // [6][2]
        put(45, t43); // [6][3]
        put(46, t27); // [6][4]
        put(47, t100); // [6][5]
        put(48, ZZ7); // [6][6]
        [
        t2, t5, t14, t15, t19, t22, t92, t95,
        t98, t99,
    ]
    };
    // composite body 6
    let [
        t109, t112, t121, t122, t188, t192, t194, t195,
        t199,
    ] = {
        let t101 = MSX6 - t5;
        let t102 = t92 - XX6R;
        let t103 = ZZ6R + t98;
        let t104 = XY6 + t14;
        let t105 = XZ6 + t95;
        let t106 = YZ6 - t15;
        let t109 = c6 * MSY6R + s6 * t101;
        let t112 = s6 * MSY6R - c6 * t101;
        let t121 = k1 * t112 - (c6 * t105 - s6 * t106);
        let t122 = s6 * t105 + c6 * t106 + k1 * t109;
        let t123 = c5 * t109;
        let t124 = s5 * t109;
        let t133 = k2 * t124 - (s5 * t103 - c5 * t121);
        let t134 = s5 * t121 + c5 * t103 - k2 * t123;
        let t137 = s4 * t112 - c4 * t123;
        let t140 = s4 * t123 + c4 * t112;
        let t149 = c4 * t133 + s4 * t122 + k3 * t140;
        let t150 = c4 * t122 - s4 * t133 - k3 * t137;
        let t153 = c3 * t137 + s3 * t124;
        let t165 = s3 * t134 - c3 * t149 + k4 * (s3 * t137 - c3 * t124);
        let t166 = s3 * t149 + c3 * t134 + k4 * t153;
        let t174 = s2 * t165 + c2 * t150 - k5 * (c2 * t153 + s2 * t140);
        let t176 = s6 * t104;
        let t179 = c6 * t104;
        let t180 = s6 * t102 - t179;
        let t182 = t22 + t176;
        let t188 = c6 * t180 + s6 * t182;
        let t192 = t109 + t109;
        let t193 = k1 * t99;
        let t194 = t193 - (c6 * (c6 * t102 + t176) + s6 * (t179 - t19));
        let t195 = t193 - (s6 * t180 - c6 * t182);
        let t197 = t2 * k1;
        let t199 = t103 + t193 - (t197 + t197);
        put(5, t174); // [0][5]
        put(12, t166); // [1][5]
        put(19, t150); // [2][5]
        put(26, t134); // [3][5]
        put(33, t122); // [4][5]
        put(35, t174); // [5][0]
        put(36, t166); // [5][1]
        put(37, t150); // [5][2]
        put(38, t134); // [5][3]
        put(39, t122); // [5][4]
        put(40, t103); // [5][5]
        [
        t109, t112, t121, t122, t188, t192, t194, t195,
        t199,
    ]
    };
    // composite body 5
    let [
        t209, t212, t221, t222, t274, t278, t280, t281,
        t285,
    ] = {
        let t200 = t112 - MSX5;
        let t201 = MSY5R + t2;
        let t202 = XX5R + t194;
        let t203 = ZZ5R + t195;
        let t204 = XY5 + t121;
        let t205 = t188 - XZ5;
        let t206 = t122 - YZ5;
        let t209 = s5 * t200 - c5 * t201;
        let t212 = s5 * t201 + c5 * t200;
        let t221 = s5 * t206 - c5 * t205 - k2 * t212;
        let t222 = s5 * t205 + c5 * t206 + k2 * t209;
        let t223 = c4 * t209;
        let t224 = s4 * t209;
        let t233 = s4 * t203 - c4 * t221 - k3 * t224;
        let t234 = s4 * t221 + c4 * t203 - k3 * t223;
        let t237 = c3 * t223 + s3 * t212;
        let t249 = c3 * t233 - s3 * t222 - k4 * (s3 * t223 - c3 * t212);
        let t250 = s3 * t233 + c3 * t222 + k4 * t237;
        let t258 = c2 * t234 - s2 * t249 + k5 * (s2 * t224 - c2 * t237);
        let t260 = s5 * t204;
        let t263 = c5 * t204;
        let t264 = s5 * t202 + t263;
        let t268 = t260 + c5 * t199;
        let t274 = s5 * t268 - c5 * t264;
        let t278 = t209 + t209;
        let t279 = k2 * t192;
        let t280 = s5 * (t263 - s5 * t199) - c5 * (c5 * t202 - t260) + t279;
        let t281 = s5 * t264 + c5 * t268 - t279;
        let t283 = k2 * t109;
        let t285 = t203 - t279 + (t283 + t283);
        put(4, t258); // [0][4]
        put(11, t250); // [1][4]
        put(18, t234); // [2][4]
        put(25, t222); // [3][4]
        put(28, t258); // [4][0]
        put(29, t250); // [4][1]
        put(30, t234); // [4][2]
        put(31, t222); // [4][3]
        put(32, t203); // [4][4]
        [
        t209, t212, t221, t222, t274, t278, t280, t281,
        t285,
    ]
    };
    // composite body 4
    let [
        t295, t298, t307, t308, t344, t348, t350, t351,
        t355,
    ] = {
        let t286 = t212 - MSX4;
        let t287 = MSY4R + t109;
        let t288 = XX4R - t280;
        let t289 = ZZ4R + t281;
        let t290 = XY4 + t221;
        let t291 = XZ4 + t274;
        let t292 = YZ4 + t222;
        let t295 = s4 * t286 - c4 * t287;
        let t298 = s4 * t287 + c4 * t286;
        let t307 = s4 * t292 - c4 * t291 + k3 * t298;
        let t308 = s4 * t291 + c4 * t292 - k3 * t295;
        let t309 = c3 * t295;
        let t320 = s3 * t307 + c3 * t289 + k4 * t309;
        let t325 = c2 * t308;
        let t326 = s2 * (s3 * t289 - c3 * t307 + k4 * (s3 * t295)) + t325;
        let t328 = t326 - k5 * (c2 * t309 + s2 * t298);
        let t330 = s4 * t290;
        let t333 = c4 * t290;
        let t334 = s4 * t288 + t333;
        let t338 = t330 + c4 * t285;
        let t344 = s4 * t338 - c4 * t334;
        let t348 = t295 + t295;
        let t349 = k3 * t278;
        let t350 = c4 * (t330 - c4 * t288) + s4 * (t333 - s4 * t285) + t349;
        let t351 = s4 * t334 + c4 * t338 - t349;
        let t353 = k3 * t209;
        let t355 = t289 - t349 + (t353 + t353);
        put(3, t328); // [0][3]
        put(10, t320); // [1][3]
        put(17, t308); // [2][3]
        put(21, t328); // [3][0]
        put(22, t320); // [3][1]
        put(23, t308); // [3][2]
        put(24, t289); // [3][3]
        [
        t295, t298, t307, t308, t344, t348, t350, t351,
        t355,
    ]
    };
    // composite body 3
    let [t368, t377, t378, t400, t404, t406, t407, t411] = {
        let t356 = t298 - MSX3;
        let t357 = MSY3R - t209;
        let t358 = t350 - XX3R;
        let t359 = ZZ3R + t351;
        let t360 = XY3 + t307;
        let t361 = t344 - XZ3;
        let t362 = t308 - YZ3;
        let t365 = c3 * t357 - s3 * t356;
        let t368 = s3 * t357 + c3 * t356;
        let t377 = c3 * t361 - s3 * t362 + k4 * t368;
        let t378 = s3 * t361 + c3 * t362 - k4 * t365;
        let t384 = k5 * (c2 * t365) - (s2 * t377 - c2 * t359);
        let t386 = s3 * t360;
        let t389 = c3 * t360;
        let t390 = s3 * t358 - t389;
        let t394 = t386 + c3 * t355;
        let t400 = c3 * t390 + s3 * t394;
        let t404 = t365 + t365;
        let t405 = k4 * t348;
        let t406 = s3 * (s3 * t355 - t389) - c3 * (c3 * t358 + t386) + t405;
        let t407 = s3 * t390 - c3 * t394 - t405;
        let t409 = k4 * t295;
        let t411 = t359 + t405 - (t409 + t409);
        put(2, t384); // [0][2]
        put(9, t378); // [1][2]
        put(14, t384); // [2][0]
        put(15, t378); // [2][1]
        put(16, t359); // [2][2]
        [t368, t377, t378, t400, t404, t406, t407, t411]
    };
    // composite body 2
    let t437 = {
        let t415 = ZZ2R - t407;
        let t416 = t377 - XY2;
        let t425 = k5 * (c2 * (MSY2R - t295) + s2 * (MSX2 - t368));
        let t426 = s2 * (XZ2 + t400) + c2 * (YZ2 + t378) + t425;
        let t434 = c2 * (s2 * t416 - c2 * t411);
        let t437 = s2 * (c2 * t416 - s2 * (XX2R + t406)) + t434 - k5 * t404;
        put(1, t426); // [0][1]
        put(7, t426); // [1][0]
        put(8, t415); // [1][1]
        t437
    };
    // composite body 1
    {
        let t438 = ZZ1R - t437;
        put(0, t438); // [0][0]
    }
}
