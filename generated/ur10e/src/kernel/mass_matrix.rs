//! Mass matrix `M`, symmetric, kg m^2.
//!
//! From the base parameters, rotors on the diagonal, by composite bodies. Featherstone, 6.2.
//!
//! 163 multiplications, 147 additions; 6 x 6, 36 of 36 structurally nonzero.

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
        ZZ1R, _, _, XX2R, ZZ2R, XY2, XZ2R, YZ2, MSX3R, MSY3, XX3R, ZZ3R,
        XY3, XZ3R, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        IA3, IA4, IA5, IA6,
        ..] = *beta;
    let k3 = S::constant(-constants::A3);
    let k4 = S::constant(-constants::A2);
    let k_D4 = S::constant(constants::D4);
    let k_D5 = S::constant(constants::D5);
    let k_D6 = S::constant(constants::D6);
    // composite body 6
    let [
        t3, t6, t15, t16, t20, t23, t73, t76,
        t79, t80,
    ] = {
        let t0 = ZZ6 + IA6;
        let t3 = c6 * MSY6 + s6 * MSX6;
        let t6 = c6 * MSX6 - s6 * MSY6;
        let t15 = c6 * XZ6 - s6 * YZ6 - k_D6 * t6;
        let t16 = k_D6 * t3 - (s6 * XZ6 + c6 * YZ6);
        let t17 = c5 * t3;
        let t18 = s5 * t3;
        let t20 = s5 * ZZ6;
        let t23 = c5 * ZZ6;
        let t27 = c5 * t15 - t20 + k_D5 * t18;
        let t28 = s5 * t15 + t23 - k_D5 * t17;
        let t31 = c4 * t17 + s4 * t6;
        let t34 = s4 * t17 - c4 * t6;
        let t46 = c4 * t27 + s4 * t16 + k_D4 * t34;
        let t47 = k_D4 * t31 + t18 * k3 - (s4 * t27 - c4 * t16);
        let t48 = t28 + t34 * k3;
        let t61 = t48 + (s3 * t31 + c3 * t34) * k4;
        let t63 = c2 * (s3 * t46 - c3 * t47 - t18 * k4);
        let t64 = s2 * (c3 * t46 + s3 * t47) + t63;
        let t66 = s6 * XY6;
        let t69 = c6 * XY6;
        let t70 = s6 * XX6R + t69;
        let t73 = c6 * (c6 * XX6R - t66) - s6 * t69;
        let t76 = s6 * t66 - c6 * t70;
        let t79 = s6 * t70 + c6 * t66;
        let t80 = t3 + t3;
        put(5, t64); // [0][5]
        put(11, t61); // [1][5]
        put(17, t48); // [2][5]
        put(23, t28); // [3][5]
        put(29, t16); // [4][5]
        put(30, t64); // [5][0]
        put(31, t61); // [5][1]
        put(32, t48); // [5][2]
        put(33, t28); // [5][3]
        put(34, t16); // [5][4]
        put(35, t0); // [5][5]
        [
        t3, t6, t15, t16, t20, t23, t73, t76,
        t79, t80,
    ]
    };
    // composite body 5
    let [
        t90, t93, t102, t103, t149, t153, t155, t156,
        t160,
    ] = {
        let t81 = MSX5 + t6;
        let t82 = XX5R + t73;
        let t83 = ZZ5R + t79;
        let t84 = XY5 + t15;
        let t85 = XZ5 + t76;
        let t86 = YZ5 + t16;
        let t87 = IA5 + t83;
        let t90 = c5 * MSY5R + s5 * t81;
        let t93 = c5 * t81 - s5 * MSY5R;
        let t102 = s5 * t86 - c5 * t85 + k_D5 * t93;
        let t103 = s5 * t85 + c5 * t86 - k_D5 * t90;
        let t104 = c4 * t90;
        let t105 = s4 * t90;
        let t117 = c4 * t102 - s4 * t83 - k_D4 * t105;
        let t118 = s4 * t102 + c4 * t83 + (k_D4 * t104 - k3 * t93);
        let t119 = t103 + k3 * t105;
        let t132 = t119 + k4 * (s3 * t104 + c3 * t105);
        let t134 = c2 * (s3 * t117 + c3 * t118 - k4 * t93);
        let t135 = s2 * (s3 * t118 - c3 * t117) - t134;
        let t137 = s5 * t84;
        let t140 = c5 * t84;
        let t141 = s5 * t82 + t140;
        let t143 = t23 + t137;
        let t149 = c5 * t141 - s5 * t143;
        let t153 = t90 + t90;
        let t154 = k_D5 * t80;
        let t155 = t154 - (c5 * (c5 * t82 - t137) - s5 * (t140 - t20));
        let t156 = t154 - (s5 * t141 + c5 * t143);
        let t158 = k_D5 * t3;
        let t160 = t158 + t158 - (t154 - t83);
        put(4, t135); // [0][4]
        put(10, t132); // [1][4]
        put(16, t119); // [2][4]
        put(22, t103); // [3][4]
        put(24, t135); // [4][0]
        put(25, t132); // [4][1]
        put(26, t119); // [4][2]
        put(27, t103); // [4][3]
        put(28, t87); // [4][4]
        [
        t90, t93, t102, t103, t149, t153, t155, t156,
        t160,
    ]
    };
    // composite body 4
    let [t171, t174, t185, t226, t228, t231, t232, t236] = {
        let t161 = MSX4 + t93;
        let t162 = MSY4R + t3;
        let t163 = XX4R - t155;
        let t164 = t156 - ZZ4R;
        let t165 = XY4 + t102;
        let t166 = XZ4 + t149;
        let t167 = t103 - YZ4;
        let t168 = IA4 - t164;
        let t171 = c4 * t162 + s4 * t161;
        let t174 = s4 * t162 - c4 * t161;
        let t177 = c4 * t166 + s4 * t167;
        let t181 = k_D4 * t174;
        let t183 = k3 * t174;
        let t184 = t177 + t181;
        let t185 = k_D4 * t171 - (s4 * t166 - c4 * t167);
        let t186 = t183 - t164;
        let t197 = t186 + k4 * (s3 * t171 + c3 * t174);
        let t199 = c2 * (c3 * t185 - s3 * t184);
        let t200 = s2 * (c3 * t184 + s3 * t185) - t199;
        let t202 = s4 * t165;
        let t205 = c4 * t165;
        let t206 = s4 * t163 + t205;
        let t210 = t202 + c4 * t160;
        let t223 = k3 * (t174 + t174) + k_D4 * t153;
        let t224 = c4 * (c4 * t163 - t202) + s4 * (s4 * t160 - t205) + t223;
        let t226 = t224 - (t183 + t183);
        let t228 = k3 * t171 - (s4 * t210 - c4 * t206);
        let t231 = t177 + (t181 + k3 * t90);
        let t232 = s4 * t206 + c4 * t210 + t223;
        let t234 = k_D4 * t90;
        let t236 = t223 - t164 - (t234 + t234);
        put(3, t200); // [0][3]
        put(9, t197); // [1][3]
        put(15, t186); // [2][3]
        put(18, t200); // [3][0]
        put(19, t197); // [3][1]
        put(20, t186); // [3][2]
        put(21, t168); // [3][3]
        [t171, t174, t185, t226, t228, t231, t232, t236]
    };
    // composite body 3
    let [t256, t285, t287, t289, t290, t291] = {
        let t237 = t174 - MSX3R;
        let t238 = MSY3 + t171;
        let t239 = XX3R + t226;
        let t240 = ZZ3R + t236;
        let t241 = XY3 + t228;
        let t242 = XZ3R + t231;
        let t243 = YZ3 - t185;
        let t244 = IA3 + t240;
        let t250 = s3 * t238 + c3 * t237;
        let t253 = s3 * t243 - c3 * t242;
        let t256 = s3 * t242 + c3 * t243;
        let t257 = k4 * t250;
        let t258 = t240 + t257;
        let t261 = c2 * t256 - s2 * t253;
        let t263 = s3 * t241;
        let t266 = c3 * t241;
        let t267 = s3 * t239 + t266;
        let t271 = t263 + c3 * t232;
        let t282 = k4 * (t250 + t250);
        let t283 = t282 - (c3 * (t263 - c3 * t239) - s3 * (s3 * t232 - t266));
        let t285 = t283 - (t257 + t257);
        let t287 = c3 * t267 - s3 * t271 + k4 * (c3 * t238 - s3 * t237);
        let t289 = k4 * t90 - t253;
        let t290 = s3 * t267 + c3 * t271 + t282;
        let t291 = t240 + t282;
        put(2, t261); // [0][2]
        put(8, t258); // [1][2]
        put(12, t261); // [2][0]
        put(13, t258); // [2][1]
        put(14, t244); // [2][2]
        [t256, t285, t287, t289, t290, t291]
    };
    // composite body 2
    let t308 = {
        let t293 = ZZ2R + t291;
        let t294 = XY2 + t287;
        let t299 = s2 * (XZ2R + t289) + c2 * (YZ2 + t256);
        let t307 = c2 * (s2 * t294 + c2 * t290);
        let t308 = s2 * (s2 * (XX2R + t285) + c2 * t294) + t307;
        put(1, t299); // [0][1]
        put(6, t299); // [1][0]
        put(7, t293); // [1][1]
        t308
    };
    // composite body 1
    {
        let t309 = ZZ1R + t308;
        put(0, t309); // [0][0]
    }
}
