//! Mass matrix `M`, symmetric, kg m^2.
//!
//! From the base parameters, rotors on the diagonal, by composite bodies. Featherstone, 6.2.
//!
//! 197 multiplications, 154 additions; 7 x 7, 49 of 49 structurally nonzero.

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
        ZZ1R, _, _, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3, MSY3R, XX3R, ZZ3R,
        XY3, XZ3, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6R, XX6R, ZZ6R, XY6, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7,
        ..] = *beta;
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
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
        let t34 = c5 * t16 + s5 * t11 - k_L3 * t25;
        let t35 = c5 * t11 - s5 * t16 - k_L3 * t22;
        let t38 = c4 * t22 + s4 * (s6 * t2);
        let t41 = c4 * t34 - s4 * t19;
        let t44 = s4 * t34 + c4 * t19;
        let t59 = k_L2 * (s3 * t38 + c3 * t25) - (c3 * t41 + s3 * t35);
        let t60 = k_L2 * (c3 * t38 - s3 * t25) - (c3 * t35 - s3 * t41);
        let t63 = s2 * t59 + c2 * t44;
        let t65 = s7 * XY7;
        let t68 = c7 * XY7;
        let t69 = s7 * XX7R + t68;
        let t72 = s7 * t68 - c7 * (c7 * XX7R - t65);
        let t75 = s7 * t65 - c7 * t69;
        let t78 = s7 * t69 + c7 * t65;
        put(6, t63); // [0][6]
        put(13, t60); // [1][6]
        put(20, t44); // [2][6]
        put(27, t35); // [3][6]
        put(34, t19); // [4][6]
        put(42, t63); // [6][0]
        put(43, t60); // [6][1]
        put(44, t44); // [6][2]
        put(45, t35); // [6][3]
        put(46, t19); // [6][4]
        put(48, ZZ7); // [6][6]
        [
        t2, t5, t8, t11, t15, t18, t72, t75,
        t78,
    ]
    };
    // composite body 6
    let [
        t87, t90, t93, t96, t100, t103, t147, t150,
        t153, t154,
    ] = {
        let t79 = t5 - MSX6;
        let t80 = t72 - XX6R;
        let t81 = ZZ6R + t78;
        let t82 = XY6 + t8;
        let t83 = XZ6 + t75;
        let t84 = t11 - YZ6;
        let t87 = c6 * MSY6R - s6 * t79;
        let t90 = s6 * MSY6R + c6 * t79;
        let t93 = c6 * t83 + s6 * t84;
        let t96 = s6 * t83 - c6 * t84;
        let t97 = c5 * t87;
        let t98 = s5 * t87;
        let t100 = s5 * t81;
        let t103 = c5 * t81;
        let t107 = c5 * t93 + t100 + k_L3 * t98;
        let t108 = s5 * t93 - t103 - k_L3 * t97;
        let t111 = c4 * t97 + s4 * t90;
        let t114 = c4 * t107 + s4 * t96;
        let t117 = c4 * t96 - s4 * t107;
        let t132 = c3 * t114 - s3 * t108 + k_L2 * (s3 * t111 + c3 * t98);
        let t133 = k_L2 * (c3 * t111 - s3 * t98) - (s3 * t114 + c3 * t108);
        let t136 = s2 * t132 + c2 * t117;
        let t138 = s6 * t82;
        let t141 = c6 * t82;
        let t142 = s6 * t80 - t141;
        let t144 = t18 + t138;
        let t147 = c6 * (c6 * t80 + t138) + s6 * (t141 - t15);
        let t150 = c6 * t142 + s6 * t144;
        let t153 = s6 * t142 - c6 * t144;
        let t154 = t87 + t87;
        put(5, t136); // [0][5]
        put(12, t133); // [1][5]
        put(19, t117); // [2][5]
        put(26, t108); // [3][5]
        put(33, t96); // [4][5]
        put(35, t136); // [5][0]
        put(36, t133); // [5][1]
        put(37, t117); // [5][2]
        put(38, t108); // [5][3]
        put(39, t96); // [5][4]
        put(40, t81); // [5][5]
        [
        t87, t90, t93, t96, t100, t103, t147, t150,
        t153, t154,
    ]
    };
    // composite body 5
    let [t164, t167, t176, t177, t217, t222, t223, t227] = {
        let t155 = MSX5 - t90;
        let t156 = MSY5R + t2;
        let t157 = XX5R - t147;
        let t158 = ZZ5R - t153;
        let t159 = t93 - XY5;
        let t160 = t150 - XZ5;
        let t161 = YZ5 - t96;
        let t164 = c5 * t156 + s5 * t155;
        let t167 = s5 * t156 - c5 * t155;
        let t176 = c5 * t160 + s5 * t161 - k_L3 * t167;
        let t177 = c5 * t161 - s5 * t160 - k_L3 * t164;
        let t178 = c4 * t164;
        let t181 = s4 * t158 - c4 * t176;
        let t184 = s4 * t176 + c4 * t158;
        let t199 = s3 * t177 - c3 * t181 - k_L2 * (s3 * t178 + c3 * t167);
        let t200 = k_L2 * (c3 * t178 - s3 * t167) - (s3 * t181 + c3 * t177);
        let t203 = c2 * t184 - s2 * t199;
        let t205 = s5 * t159;
        let t208 = c5 * t159;
        let t209 = t208 - s5 * t157;
        let t211 = t103 - t205;
        let t217 = c5 * t209 + s5 * t211;
        let t221 = k_L3 * t154;
        let t222 = c5 * (c5 * t157 + t205) + s5 * (t100 + t208) + t221;
        let t223 = s5 * t209 - c5 * t211 - t221;
        let t225 = k_L3 * t87;
        let t227 = t158 + t221 - (t225 + t225);
        put(4, t203); // [0][4]
        put(11, t200); // [1][4]
        put(18, t184); // [2][4]
        put(25, t177); // [3][4]
        put(28, t203); // [4][0]
        put(29, t200); // [4][1]
        put(30, t184); // [4][2]
        put(31, t177); // [4][3]
        put(32, t158); // [4][4]
        [t164, t167, t176, t177, t217, t222, t223, t227]
    };
    // composite body 4
    let [
        t237, t240, t243, t246, t250, t253, t274, t277,
        t280, t281,
    ] = {
        let t228 = MSX4 - t167;
        let t229 = MSY4R - t87;
        let t230 = XX4R + t222;
        let t231 = ZZ4R - t223;
        let t232 = XY4 + t176;
        let t233 = t217 - XZ4;
        let t234 = YZ4 - t177;
        let t237 = c4 * t229 + s4 * t228;
        let t240 = c4 * t228 - s4 * t229;
        let t243 = c4 * t233 + s4 * t234;
        let t246 = s4 * t233 - c4 * t234;
        let t250 = s3 * t231;
        let t253 = c3 * t231;
        let t258 = s3 * t243 - t253 + k_L2 * (c3 * t237);
        let t261 = c2 * t246 - s2 * (c3 * t243 + t250 - k_L2 * (s3 * t237));
        let t263 = s4 * t232;
        let t266 = c4 * t232;
        let t267 = s4 * t230 + t266;
        let t271 = t263 + c4 * t227;
        let t274 = s4 * (t266 - s4 * t227) - c4 * (c4 * t230 - t263);
        let t277 = s4 * t271 - c4 * t267;
        let t280 = s4 * t267 + c4 * t271;
        let t281 = t237 + t237;
        put(3, t261); // [0][3]
        put(10, t258); // [1][3]
        put(17, t246); // [2][3]
        put(21, t261); // [3][0]
        put(22, t258); // [3][1]
        put(23, t246); // [3][2]
        put(24, t231); // [3][3]
        [
        t237, t240, t243, t246, t250, t253, t274, t277,
        t280, t281,
    ]
    };
    // composite body 3
    let [t303, t304, t321, t326, t327, t331] = {
        let t282 = MSX3 + t240;
        let t283 = MSY3R + t164;
        let t284 = t274 - XX3R;
        let t285 = ZZ3R + t280;
        let t286 = t243 - XY3;
        let t287 = XZ3 + t277;
        let t288 = YZ3 + t246;
        let t303 = s3 * t288 - c3 * t287 - k_L2 * (s3 * t283 - c3 * t282);
        let t304 = k_L2 * (c3 * t283 + s3 * t282) - (s3 * t287 + c3 * t288);
        let t307 = c2 * t285 - s2 * t303;
        let t309 = s3 * t286;
        let t312 = c3 * t286;
        let t313 = s3 * t284 + t312;
        let t315 = t309 - t253;
        let t321 = s3 * t315 - c3 * t313;
        let t325 = k_L2 * t281;
        let t326 = t325 - (c3 * (t309 - c3 * t284) + s3 * (t250 + t312));
        let t327 = s3 * t313 + c3 * t315 + t325;
        let t329 = k_L2 * t237;
        let t331 = t329 + t329 - (t325 - t285);
        put(2, t307); // [0][2]
        put(9, t304); // [1][2]
        put(14, t307); // [2][0]
        put(15, t304); // [2][1]
        put(16, t285); // [2][2]
        [t303, t304, t321, t326, t327, t331]
    };
    // composite body 2
    let t348 = {
        let t333 = ZZ2R - t327;
        let t334 = XY2 - t303;
        let t339 = s2 * (XZ2 - t321) + c2 * (YZ2 + t304);
        let t347 = c2 * (s2 * t334 + c2 * t331);
        let t348 = s2 * (s2 * (t326 - XX2R) - c2 * t334) - t347;
        put(1, t339); // [0][1]
        put(7, t339); // [1][0]
        put(8, t333); // [1][1]
        t348
    };
    // composite body 1
    {
        let t349 = ZZ1R - t348;
        let t350 = -t11;
        put(0, t349); // [0][0]
        put(41, t350); // [5][6]
        put(47, t350); // [6][5]
    }
}
