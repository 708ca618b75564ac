//! Mass matrix `M`, symmetric, kg m^2.
//!
//! From the base parameters, rotors on the diagonal, by composite bodies. Featherstone, 6.2.
//!
//! 197 multiplications, 154 additions; 7 x 7, 49 of 49 structurally nonzero.

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
        ZZ1R, _, _, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3, MSY3R, XX3R, ZZ3R,
        XY3, XZ3, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6R, XX6R, ZZ6R, XY6, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7,
        ..] = *beta;
    let L2 = S::constant(0.4);
    let L3 = S::constant(0.39);
    // composite body 7
    let [
        t2, t5, t8, t11, t15, t18, t72, t75,
        t78,
    ] = {
        let t2 = c7 * MSY7 + s7 * MSX7;
        let t5 = s7 * MSY7 - c7 * MSX7;
        let t8 = c7 * XZ7 - s7 * YZ7;
        let t11 = s7 * XZ7 + c7 * YZ7;
        let t12 = c6 * t2;
        let t15 = s6 * ZZ7;
        let t16 = t15 - c6 * t8;
        let t18 = c6 * ZZ7;
        let t19 = s6 * t8 + t18;
        let t22 = c5 * t12 - s5 * t5;
        let t25 = s5 * t12 + c5 * t5;
        let t34 = c5 * t16 + s5 * t11 - L3 * t25;
        let t35 = c5 * t11 - s5 * t16 - L3 * t22;
        let t38 = c4 * t22 + s4 * (s6 * t2);
        let t41 = c4 * t34 - s4 * t19;
        let t44 = s4 * t34 + c4 * t19;
        let t59 = L2 * (s3 * t38 + c3 * t25) - (c3 * t41 + s3 * t35);
        let t60 = L2 * (c3 * t38 - s3 * t25) - (c3 * t35 - s3 * t41);
        let t63 = s2 * t59 + c2 * t44;
        let t65 = s7 * XY7;
        let t68 = c7 * XY7;
        let t69 = s7 * XX7R + t68;
        let t72 = s7 * t68 - c7 * (c7 * XX7R - t65);
        let t75 = s7 * t65 - c7 * t69;
        let t78 = s7 * t69 + c7 * t65;
        let t79 = -t11;
        put(6, t63); // [0][6]
        put(13, t60); // [1][6]
        put(20, t44); // [2][6]
        put(27, t35); // [3][6]
        put(34, t19); // [4][6]
        put(41, t79); // [5][6]
        put(42, t63); // [6][0]
        put(43, t60); // [6][1]
        put(44, t44); // [6][2]
        put(45, t35); // [6][3]
        put(46, t19); // [6][4]
        put(47, t79); // [6][5]
        put(48, ZZ7); // [6][6]
        [
        t2, t5, t8, t11, t15, t18, t72, t75,
        t78,
    ]
    };
    // composite body 6
    let [
        t88, t91, t94, t97, t101, t104, t148, t151,
        t154, t155,
    ] = {
        let t80 = t5 - MSX6;
        let t81 = t72 - XX6R;
        let t82 = ZZ6R + t78;
        let t83 = XY6 + t8;
        let t84 = XZ6 + t75;
        let t85 = t11 - YZ6;
        let t88 = c6 * MSY6R - s6 * t80;
        let t91 = s6 * MSY6R + c6 * t80;
        let t94 = c6 * t84 + s6 * t85;
        let t97 = s6 * t84 - c6 * t85;
        let t98 = c5 * t88;
        let t99 = s5 * t88;
        let t101 = s5 * t82;
        let t104 = c5 * t82;
        let t108 = c5 * t94 + t101 + L3 * t99;
        let t109 = s5 * t94 - t104 - L3 * t98;
        let t112 = c4 * t98 + s4 * t91;
        let t115 = c4 * t108 + s4 * t97;
        let t118 = c4 * t97 - s4 * t108;
        let t133 = c3 * t115 - s3 * t109 + L2 * (s3 * t112 + c3 * t99);
        let t134 = L2 * (c3 * t112 - s3 * t99) - (s3 * t115 + c3 * t109);
        let t137 = s2 * t133 + c2 * t118;
        let t139 = s6 * t83;
        let t142 = c6 * t83;
        let t143 = s6 * t81 - t142;
        let t145 = t18 + t139;
        let t148 = c6 * (c6 * t81 + t139) + s6 * (t142 - t15);
        let t151 = c6 * t143 + s6 * t145;
        let t154 = s6 * t143 - c6 * t145;
        let t155 = t88 + t88;
        put(5, t137); // [0][5]
        put(12, t134); // [1][5]
        put(19, t118); // [2][5]
        put(26, t109); // [3][5]
        put(33, t97); // [4][5]
        put(35, t137); // [5][0]
        put(36, t134); // [5][1]
        put(37, t118); // [5][2]
        put(38, t109); // [5][3]
        put(39, t97); // [5][4]
        put(40, t82); // [5][5]
        [
        t88, t91, t94, t97, t101, t104, t148, t151,
        t154, t155,
    ]
    };
    // composite body 5
    let [t165, t168, t177, t178, t218, t223, t224, t228] = {
        let t156 = MSX5 - t91;
        let t157 = MSY5R + t2;
        let t158 = XX5R - t148;
        let t159 = ZZ5R - t154;
        let t160 = t94 - XY5;
        let t161 = t151 - XZ5;
        let t162 = YZ5 - t97;
        let t165 = c5 * t157 + s5 * t156;
        let t168 = s5 * t157 - c5 * t156;
        let t177 = c5 * t161 + s5 * t162 - L3 * t168;
        let t178 = c5 * t162 - s5 * t161 - L3 * t165;
        let t179 = c4 * t165;
        let t182 = s4 * t159 - c4 * t177;
        let t185 = s4 * t177 + c4 * t159;
        let t200 = s3 * t178 - c3 * t182 - L2 * (s3 * t179 + c3 * t168);
        let t201 = L2 * (c3 * t179 - s3 * t168) - (s3 * t182 + c3 * t178);
        let t204 = c2 * t185 - s2 * t200;
        let t206 = s5 * t160;
        let t209 = c5 * t160;
        let t210 = t209 - s5 * t158;
        let t212 = t104 - t206;
        let t218 = c5 * t210 + s5 * t212;
        let t222 = L3 * t155;
        let t223 = c5 * (c5 * t158 + t206) + s5 * (t101 + t209) + t222;
        let t224 = s5 * t210 - c5 * t212 - t222;
        let t226 = L3 * t88;
        let t228 = t159 + t222 - (t226 + t226);
        put(4, t204); // [0][4]
        put(11, t201); // [1][4]
        put(18, t185); // [2][4]
        put(25, t178); // [3][4]
        put(28, t204); // [4][0]
        put(29, t201); // [4][1]
        put(30, t185); // [4][2]
        put(31, t178); // [4][3]
        put(32, t159); // [4][4]
        [t165, t168, t177, t178, t218, t223, t224, t228]
    };
    // composite body 4
    let [
        t238, t241, t244, t247, t251, t254, t275, t278,
        t281, t282,
    ] = {
        let t229 = MSX4 - t168;
        let t230 = MSY4R - t88;
        let t231 = XX4R + t223;
        let t232 = ZZ4R - t224;
        let t233 = XY4 + t177;
        let t234 = t218 - XZ4;
        let t235 = YZ4 - t178;
        let t238 = c4 * t230 + s4 * t229;
        let t241 = c4 * t229 - s4 * t230;
        let t244 = c4 * t234 + s4 * t235;
        let t247 = s4 * t234 - c4 * t235;
        let t251 = s3 * t232;
        let t254 = c3 * t232;
        let t259 = s3 * t244 - t254 + L2 * (c3 * t238);
        let t262 = c2 * t247 - s2 * (c3 * t244 + t251 - L2 * (s3 * t238));
        let t264 = s4 * t233;
        let t267 = c4 * t233;
        let t268 = s4 * t231 + t267;
        let t272 = t264 + c4 * t228;
        let t275 = s4 * (t267 - s4 * t228) - c4 * (c4 * t231 - t264);
        let t278 = s4 * t272 - c4 * t268;
        let t281 = s4 * t268 + c4 * t272;
        let t282 = t238 + t238;
        put(3, t262); // [0][3]
        put(10, t259); // [1][3]
        put(17, t247); // [2][3]
        put(21, t262); // [3][0]
        put(22, t259); // [3][1]
        put(23, t247); // [3][2]
        put(24, t232); // [3][3]
        [
        t238, t241, t244, t247, t251, t254, t275, t278,
        t281, t282,
    ]
    };
    // composite body 3
    let [t304, t305, t322, t327, t328, t332] = {
        let t283 = MSX3 + t241;
        let t284 = MSY3R + t165;
        let t285 = t275 - XX3R;
        let t286 = ZZ3R + t281;
        let t287 = t244 - XY3;
        let t288 = XZ3 + t278;
        let t289 = YZ3 + t247;
        let t304 = s3 * t289 - c3 * t288 - L2 * (s3 * t284 - c3 * t283);
        let t305 = L2 * (c3 * t284 + s3 * t283) - (s3 * t288 + c3 * t289);
        let t308 = c2 * t286 - s2 * t304;
        let t310 = s3 * t287;
        let t313 = c3 * t287;
        let t314 = s3 * t285 + t313;
        let t316 = t310 - t254;
        let t322 = s3 * t316 - c3 * t314;
        let t326 = L2 * t282;
        let t327 = t326 - (c3 * (t310 - c3 * t285) + s3 * (t251 + t313));
        let t328 = s3 * t314 + c3 * t316 + t326;
        let t330 = L2 * t238;
        let t332 = t330 + t330 - (t326 - t286);
        put(2, t308); // [0][2]
        put(9, t305); // [1][2]
        put(14, t308); // [2][0]
        put(15, t305); // [2][1]
        put(16, t286); // [2][2]
        [t304, t305, t322, t327, t328, t332]
    };
    // composite body 2
    let t349 = {
        let t334 = ZZ2R - t328;
        let t335 = XY2 - t304;
        let t340 = s2 * (XZ2 - t322) + c2 * (YZ2 + t305);
        let t348 = c2 * (s2 * t335 + c2 * t332);
        let t349 = s2 * (s2 * (t327 - XX2R) - c2 * t335) - t348;
        put(1, t340); // [0][1]
        put(7, t340); // [1][0]
        put(8, t334); // [1][1]
        t349
    };
    // composite body 1
    {
        let t350 = ZZ1R - t349;
        put(0, t350); // [0][0]
    }
}
