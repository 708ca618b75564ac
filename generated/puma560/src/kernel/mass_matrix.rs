//! Mass matrix `M`, symmetric, kg m^2.
//!
//! From the base parameters, rotors on the diagonal, by composite bodies. Featherstone, 6.2.
//!
//! 184 multiplications, 163 additions; 6 x 6, 36 of 36 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{BASE, Trig, constants};

/// Mass matrix `M`, symmetric, kg m^2: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], out: &mut [[S; 6]; 6]) {
    entries(trig, beta, |k, x| {
        out[k / 6][k % 6] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [
        ZZ1R, MSX2R, MSY2, XX2R, ZZ2R, XY2, XZ2R, YZ2, MSX3R, MSY3R, XX3R, ZZ3R,
        XY3R, XZ3, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        IA3, IA4, IA5, IA6,
        ..] = *beta;
    let k1 = S::constant(-constants::A3);
    let k2 = S::constant(-constants::D3);
    let k_A2 = S::constant(constants::A2);
    let k_D2 = S::constant(constants::D2);
    let k_D4 = S::constant(constants::D4);
    // composite body 6
    let [
        t3, t6, t9, t12, t16, t19, t77, t80,
        t83,
    ] = {
        let t0 = ZZ6 + IA6;
        let t3 = c6 * MSY6 + s6 * MSX6;
        let t6 = s6 * MSY6 - c6 * MSX6;
        let t9 = c6 * XZ6 - s6 * YZ6;
        let t12 = s6 * XZ6 + c6 * YZ6;
        let t13 = c5 * t3;
        let t14 = s5 * t3;
        let t16 = s5 * ZZ6;
        let t17 = c5 * t9 + t16;
        let t19 = c5 * ZZ6;
        let t20 = t19 - s5 * t9;
        let t23 = s4 * t6 - c4 * t13;
        let t26 = s4 * t13 + c4 * t6;
        let t38 = c4 * t17 - s4 * t12 + k_D4 * t26;
        let t39 = s4 * t17 + c4 * t12 + (k_D4 * t23 + t14 * k1);
        let t40 = t20 + t26 * k1;
        let t43 = c3 * t23 + s3 * t14;
        let t46 = s3 * t23 - c3 * t14;
        let t60 = t39 + k_A2 * t46;
        let t65 = c2 * (c3 * t40 - s3 * t38 + (t43 * k2 - k_A2 * t26));
        let t67 = k_D2 * (s2 * t46 - c2 * t43);
        let t68 = t65 - s2 * (c3 * t38 + s3 * t40 + t46 * k2) + t67;
        let t70 = s6 * XY6;
        let t73 = c6 * XY6;
        let t74 = s6 * XX6R + t73;
        let t77 = c6 * (c6 * XX6R - t70) - s6 * t73;
        let t80 = c6 * t74 - s6 * t70;
        let t83 = s6 * t74 + c6 * t70;
        put(5, t68); // [0][5]
        put(11, t60); // [1][5]
        put(17, t39); // [2][5]
        put(23, t20); // [3][5]
        put(29, t12); // [4][5]
        put(30, t68); // [5][0]
        put(31, t60); // [5][1]
        put(32, t39); // [5][2]
        put(33, t20); // [5][3]
        put(34, t12); // [5][4]
        put(35, t0); // [5][5]
        [
        t3, t6, t9, t12, t16, t19, t77, t80,
        t83,
    ]
    };
    // composite body 5
    let [
        t93, t96, t99, t102, t106, t109, t157, t160,
        t163, t164,
    ] = {
        let t84 = t6 - MSX5;
        let t85 = XX5R + t77;
        let t86 = ZZ5R + t83;
        let t87 = t9 - XY5;
        let t88 = XZ5 + t80;
        let t89 = t12 - YZ5;
        let t90 = IA5 + t86;
        let t93 = s5 * t84 - c5 * MSY5R;
        let t96 = s5 * MSY5R + c5 * t84;
        let t99 = c5 * t88 + s5 * t89;
        let t102 = c5 * t89 - s5 * t88;
        let t103 = c4 * t93;
        let t104 = s4 * t93;
        let t106 = s4 * t86;
        let t109 = c4 * t86;
        let t116 = t106 - c4 * t99 + k_D4 * t104;
        let t117 = s4 * t99 + t109 + (k_D4 * t103 + k1 * t96);
        let t118 = t102 - k1 * t104;
        let t121 = c3 * t103 + s3 * t96;
        let t124 = c3 * t96 - s3 * t103;
        let t138 = t117 - k_A2 * t124;
        let t143 = c2 * (s3 * t116 + c3 * t118 + (k2 * t121 + k_A2 * t104));
        let t145 = k_D2 * (c2 * t121 + s2 * t124);
        let t146 = s2 * (c3 * t116 - s3 * t118 + k2 * t124) + t143 - t145;
        let t148 = s5 * t87;
        let t151 = c5 * t87;
        let t152 = s5 * t85 - t151;
        let t154 = t19 - t148;
        let t157 = c5 * (c5 * t85 + t148) + s5 * (t16 + t151);
        let t160 = s5 * t154 - c5 * t152;
        let t163 = s5 * t152 + c5 * t154;
        let t164 = t93 + t93;
        put(4, t146); // [0][4]
        put(10, t138); // [1][4]
        put(16, t117); // [2][4]
        put(22, t102); // [3][4]
        put(24, t146); // [4][0]
        put(25, t138); // [4][1]
        put(26, t117); // [4][2]
        put(27, t102); // [4][3]
        put(28, t90); // [4][4]
        [
        t93, t96, t99, t102, t106, t109, t157, t160,
        t163, t164,
    ]
    };
    // composite body 4
    let [
        t175, t178, t189, t233, t239, t241, t244, t245,
        t249,
    ] = {
        let t165 = t96 - MSX4;
        let t166 = MSY4R + t3;
        let t167 = XX4R + t157;
        let t168 = ZZ4R + t163;
        let t169 = XY4 + t99;
        let t170 = XZ4 + t160;
        let t171 = YZ4 + t102;
        let t172 = IA4 + t168;
        let t175 = s4 * t165 - c4 * t166;
        let t178 = s4 * t166 + c4 * t165;
        let t181 = c4 * t170 - s4 * t171;
        let t185 = k_D4 * t178;
        let t187 = k1 * t178;
        let t188 = t181 + t185;
        let t189 = s4 * t170 + c4 * t171 + k_D4 * t175;
        let t190 = t168 + t187;
        let t191 = c3 * t175;
        let t192 = s3 * t175;
        let t206 = t189 + k_A2 * t192;
        let t211 = c2 * (s3 * t188 - c3 * t190 + (k_A2 * t178 - k2 * t191));
        let t212 = s2 * (c3 * t188 + s3 * t190 + k2 * t192) + t211;
        let t214 = k_D2 * (s2 * t192 - c2 * t191) - t212;
        let t216 = s4 * t169;
        let t219 = c4 * t169;
        let t220 = s4 * t167 + t219;
        let t222 = t109 + t216;
        let t233 = t175 + t175;
        let t236 = k1 * (t178 + t178) + k_D4 * t164;
        let t237 = s4 * (t106 - t219) - c4 * (t216 - c4 * t167) + t236;
        let t239 = t187 + t187 - t237;
        let t241 = k1 * t175 - (c4 * t220 - s4 * t222);
        let t244 = t181 + (t185 + k1 * t93);
        let t245 = s4 * t220 + c4 * t222 + t236;
        let t247 = k_D4 * t93;
        let t249 = t168 + t236 - (t247 + t247);
        put(3, t214); // [0][3]
        put(9, t206); // [1][3]
        put(15, t189); // [2][3]
        put(18, t214); // [3][0]
        put(19, t206); // [3][1]
        put(20, t189); // [3][2]
        put(21, t172); // [3][3]
        [
        t175, t178, t189, t233, t239, t241, t244, t245,
        t249,
    ]
    };
    // composite body 3
    let [t260, t263, t274, t309, t311, t314, t315, t319] = {
        let t250 = t178 - MSX3R;
        let t251 = MSY3R - t93;
        let t252 = t239 - XX3R;
        let t253 = ZZ3R + t245;
        let t254 = t244 - XY3R;
        let t255 = t241 - XZ3;
        let t256 = YZ3 - t189;
        let t257 = IA3 + t253;
        let t260 = s3 * t250 - c3 * t251;
        let t263 = s3 * t251 + c3 * t250;
        let t266 = c3 * t255 + s3 * t256;
        let t270 = k2 * t263;
        let t272 = k_A2 * t263;
        let t274 = k2 * t260 - (c3 * t256 - s3 * t255);
        let t275 = t253 - t272;
        let t282 = k_D2 * (c2 * t260 + s2 * t263);
        let t283 = s2 * (t266 + t270) + c2 * t274 - t282;
        let t285 = s3 * t254;
        let t288 = c3 * t254;
        let t289 = s3 * t252 + t288;
        let t293 = t285 - c3 * t249;
        let t306 = k_A2 * (t263 + t263) - k2 * t233;
        let t307 = c3 * (t285 - c3 * t252) + s3 * (t288 + s3 * t249) - t306;
        let t309 = t307 + (t272 + t272);
        let t311 = s3 * t293 - c3 * t289 + k_A2 * t260;
        let t314 = k_A2 * t175 - t270 - t266;
        let t315 = s3 * t289 + c3 * t293 + t306;
        let t317 = k2 * t175;
        let t319 = t253 - t306 - (t317 + t317);
        put(2, t283); // [0][2]
        put(8, t275); // [1][2]
        put(12, t283); // [2][0]
        put(13, t275); // [2][1]
        put(14, t257); // [2][2]
        [t260, t263, t274, t309, t311, t314, t315, t319]
    };
    // composite body 2
    let t345 = {
        let t323 = ZZ2R + t319;
        let t324 = XY2 + t311;
        let t332 = s2 * (XZ2R + t314) - c2 * (t274 - YZ2);
        let t334 = k_D2 * (c2 * (MSY2 - t260) - s2 * (t263 - MSX2R)) - t332;
        let t342 = c2 * (c2 * t315 - s2 * t324);
        let t345 = k_D2 * t233 - (s2 * (s2 * (XX2R + t309) + c2 * t324) - t342);
        put(1, t334); // [0][1]
        put(6, t334); // [1][0]
        put(7, t323); // [1][1]
        t345
    };
    // composite body 1
    {
        let t346 = ZZ1R - t345;
        put(0, t346); // [0][0]
    }
}
