//! Mass matrix `M`, symmetric, kg m^2.
//!
//! From the base parameters, rotors on the diagonal, by composite bodies. Featherstone, 6.2.
//!
//! 163 multiplications, 143 additions; 6 x 6, 36 of 36 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{BASE, Trig};

/// Mass matrix `M`, symmetric, kg m^2: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], out: &mut [[S; 6]; 6]) {
    entries(trig, beta, |k, x| {
        out[k / 6][k % 6] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [
        ZZ1R, _, _, XX2R, ZZ2R, XY2, XZ2R, YZ2, MSX3R, MSY3, XX3R, ZZ3R,
        XY3, XZ3R, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        ..] = *beta;
    let D4 = S::constant(0.17415);
    let D5 = S::constant(0.11985);
    let D6 = S::constant(0.11655);
    let k3 = S::constant(0.57155);
    let k4 = S::constant(0.6127);
    // composite body 6
    let [
        t2, t5, t14, t15, t19, t22, t72, t75,
        t78, t79,
    ] = {
        let t2 = c6 * MSY6 + s6 * MSX6;
        let t5 = s6 * MSY6 - c6 * MSX6;
        let t14 = c6 * XZ6 - s6 * YZ6 + D6 * t5;
        let t15 = D6 * t2 - (s6 * XZ6 + c6 * YZ6);
        let t16 = c5 * t2;
        let t17 = s5 * t2;
        let t19 = s5 * ZZ6;
        let t22 = c5 * ZZ6;
        let t26 = c5 * t14 - t19 + D5 * t17;
        let t27 = s5 * t14 + t22 - D5 * t16;
        let t30 = c4 * t16 - s4 * t5;
        let t33 = s4 * t16 + c4 * t5;
        let t45 = c4 * t26 + s4 * t15 + D4 * t33;
        let t46 = c4 * t15 - s4 * t26 + (D4 * t30 + t17 * k3);
        let t47 = t27 + t33 * k3;
        let t60 = t47 + (s3 * t30 + c3 * t33) * k4;
        let t62 = c2 * (t17 * k4 - (s3 * t45 - c3 * t46));
        let t63 = s2 * (c3 * t45 + s3 * t46) - t62;
        let t65 = s6 * XY6;
        let t68 = c6 * XY6;
        let t69 = s6 * XX6R + t68;
        let t72 = s6 * t68 - c6 * (c6 * XX6R - t65);
        let t75 = c6 * t69 - s6 * t65;
        let t78 = s6 * t69 + c6 * t65;
        let t79 = t2 + t2;
        put(5, t63); // [0][5]
        put(11, t60); // [1][5]
        put(17, t47); // [2][5]
        put(23, t27); // [3][5]
        put(29, t15); // [4][5]
        put(30, t63); // [5][0]
        put(31, t60); // [5][1]
        put(32, t47); // [5][2]
        put(33, t27); // [5][3]
        put(34, t15); // [5][4]
        put(35, ZZ6); // [5][5]
        [
        t2, t5, t14, t15, t19, t22, t72, t75,
        t78, t79,
    ]
    };
    // composite body 5
    let [
        t88, t91, t100, t101, t147, t151, t153, t154,
        t158,
    ] = {
        let t80 = t5 - MSX5;
        let t81 = t72 - XX5R;
        let t82 = ZZ5R + t78;
        let t83 = XY5 + t14;
        let t84 = t75 - XZ5;
        let t85 = YZ5 + t15;
        let t88 = s5 * t80 - c5 * MSY5R;
        let t91 = s5 * MSY5R + c5 * t80;
        let t100 = D5 * t91 - (c5 * t84 + s5 * t85);
        let t101 = D5 * t88 - (s5 * t84 - c5 * t85);
        let t102 = c4 * t88;
        let t103 = s4 * t88;
        let t115 = c4 * t100 + s4 * t82 - D4 * t103;
        let t116 = s4 * t100 - c4 * t82 + (D4 * t102 - k3 * t91);
        let t117 = t101 - k3 * t103;
        let t130 = t117 - k4 * (s3 * t102 + c3 * t103);
        let t131 = s2 * (s3 * t116 - c3 * t115);
        let t133 = c2 * (s3 * t115 + c3 * t116 - k4 * t91) - t131;
        let t135 = s5 * t83;
        let t138 = c5 * t83;
        let t139 = s5 * t81 - t138;
        let t141 = t22 + t135;
        let t147 = c5 * t139 + s5 * t141;
        let t151 = t88 + t88;
        let t152 = D5 * t79;
        let t153 = c5 * (c5 * t81 + t135) + s5 * (t138 - t19) + t152;
        let t154 = s5 * t139 - c5 * t141 + t152;
        let t156 = D5 * t2;
        let t158 = t82 - t152 + (t156 + t156);
        put(4, t133); // [0][4]
        put(10, t130); // [1][4]
        put(16, t117); // [2][4]
        put(22, t101); // [3][4]
        put(24, t133); // [4][0]
        put(25, t130); // [4][1]
        put(26, t117); // [4][2]
        put(27, t101); // [4][3]
        put(28, t82); // [4][4]
        [
        t88, t91, t100, t101, t147, t151, t153, t154,
        t158,
    ]
    };
    // composite body 4
    let [t168, t171, t182, t223, t225, t228, t229, t233] = {
        let t159 = MSX4 - t91;
        let t160 = MSY4R + t2;
        let t161 = t153 - XX4R;
        let t162 = ZZ4R - t154;
        let t163 = XY4 - t100;
        let t164 = XZ4 - t147;
        let t165 = t101 - YZ4;
        let t168 = c4 * t160 + s4 * t159;
        let t171 = s4 * t160 - c4 * t159;
        let t174 = c4 * t164 + s4 * t165;
        let t178 = D4 * t171;
        let t180 = k3 * t171;
        let t181 = t174 + t178;
        let t182 = c4 * t165 - s4 * t164 + D4 * t168;
        let t183 = t162 + t180;
        let t194 = t183 + k4 * (s3 * t168 + c3 * t171);
        let t196 = c2 * (c3 * t182 - s3 * t181);
        let t197 = s2 * (c3 * t181 + s3 * t182) - t196;
        let t199 = s4 * t163;
        let t202 = c4 * t163;
        let t203 = s4 * t161 - t202;
        let t207 = t199 + c4 * t158;
        let t220 = D4 * t151 - k3 * (t171 + t171);
        let t221 = c4 * (c4 * t161 + t199) + s4 * (t202 - s4 * t158) + t220;
        let t223 = t221 + (t180 + t180);
        let t225 = k3 * t168 - (c4 * t203 + s4 * t207);
        let t228 = t174 - (k3 * t88 - t178);
        let t229 = t220 - (c4 * t207 - s4 * t203);
        let t231 = D4 * t88;
        let t233 = t162 - t220 + (t231 + t231);
        put(3, t197); // [0][3]
        put(9, t194); // [1][3]
        put(15, t183); // [2][3]
        put(18, t197); // [3][0]
        put(19, t194); // [3][1]
        put(20, t183); // [3][2]
        put(21, t162); // [3][3]
        [t168, t171, t182, t223, t225, t228, t229, t233]
    };
    // composite body 3
    let [t252, t281, t283, t285, t286, t287] = {
        let t234 = MSX3R - t171;
        let t235 = MSY3 + t168;
        let t236 = XX3R - t223;
        let t237 = ZZ3R + t233;
        let t238 = XY3 + t225;
        let t239 = XZ3R + t228;
        let t240 = YZ3 - t182;
        let t246 = s3 * t235 - c3 * t234;
        let t249 = c3 * t239 - s3 * t240;
        let t252 = s3 * t239 + c3 * t240;
        let t253 = k4 * t246;
        let t254 = t237 + t253;
        let t257 = s2 * t249 + c2 * t252;
        let t259 = s3 * t238;
        let t262 = c3 * t238;
        let t263 = s3 * t236 + t262;
        let t267 = c3 * t229 - t259;
        let t278 = k4 * (t246 + t246);
        let t279 = t278 - (c3 * (t259 - c3 * t236) + s3 * (t262 + s3 * t229));
        let t281 = t253 + t253 - t279;
        let t283 = c3 * t263 + s3 * t267 + k4 * (c3 * t235 + s3 * t234);
        let t285 = t249 - k4 * t88;
        let t286 = t278 - (c3 * t267 - s3 * t263);
        let t287 = t237 + t278;
        put(2, t257); // [0][2]
        put(8, t254); // [1][2]
        put(12, t257); // [2][0]
        put(13, t254); // [2][1]
        put(14, t237); // [2][2]
        [t252, t281, t283, t285, t286, t287]
    };
    // composite body 2
    let t304 = {
        let t289 = ZZ2R + t287;
        let t290 = XY2 + t283;
        let t295 = s2 * (XZ2R + t285) + c2 * (YZ2 + t252);
        let t303 = c2 * (s2 * t290 + c2 * t286);
        let t304 = s2 * (s2 * (XX2R - t281) + c2 * t290) + t303;
        put(1, t295); // [0][1]
        put(6, t295); // [1][0]
        put(7, t289); // [1][1]
        t304
    };
    // composite body 1
    {
        let t305 = ZZ1R + t304;
        put(0, t305); // [0][0]
    }
}
