//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4.
//!
//! 675 multiplications, 492 additions; 7 x 64, 211 of 448 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 211;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9),
    (0, 10), (0, 11), (0, 12), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18), (0, 19),
    (0, 20), (0, 21), (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28), (0, 29),
    (0, 30), (0, 31), (0, 32), (0, 33), (0, 34), (0, 35), (0, 36), (0, 37), (0, 38), (0, 39),
    (0, 40), (0, 41), (0, 42), (0, 43), (0, 50), (0, 57), (1, 1), (1, 2), (1, 3), (1, 4),
    (1, 5), (1, 6), (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (1, 12), (1, 13), (1, 14),
    (1, 15), (1, 16), (1, 17), (1, 18), (1, 19), (1, 20), (1, 21), (1, 22), (1, 23), (1, 24),
    (1, 25), (1, 26), (1, 27), (1, 28), (1, 29), (1, 30), (1, 31), (1, 32), (1, 33), (1, 34),
    (1, 35), (1, 36), (1, 37), (1, 38), (1, 39), (1, 40), (1, 41), (1, 42), (1, 44), (1, 51),
    (1, 58), (2, 8), (2, 9), (2, 10), (2, 11), (2, 12), (2, 13), (2, 14), (2, 15), (2, 16),
    (2, 17), (2, 18), (2, 19), (2, 20), (2, 21), (2, 22), (2, 23), (2, 24), (2, 25), (2, 26),
    (2, 27), (2, 28), (2, 29), (2, 30), (2, 31), (2, 32), (2, 33), (2, 34), (2, 35), (2, 36),
    (2, 37), (2, 38), (2, 39), (2, 40), (2, 41), (2, 42), (2, 45), (2, 52), (2, 59), (3, 15),
    (3, 16), (3, 17), (3, 18), (3, 19), (3, 20), (3, 21), (3, 22), (3, 23), (3, 24), (3, 25),
    (3, 26), (3, 27), (3, 28), (3, 29), (3, 30), (3, 31), (3, 32), (3, 33), (3, 34), (3, 35),
    (3, 36), (3, 37), (3, 38), (3, 39), (3, 40), (3, 41), (3, 42), (3, 46), (3, 53), (3, 60),
    (4, 22), (4, 23), (4, 24), (4, 25), (4, 26), (4, 27), (4, 28), (4, 29), (4, 30), (4, 31),
    (4, 32), (4, 33), (4, 34), (4, 35), (4, 36), (4, 37), (4, 38), (4, 39), (4, 40), (4, 41),
    (4, 42), (4, 47), (4, 54), (4, 61), (5, 29), (5, 30), (5, 31), (5, 32), (5, 33), (5, 34),
    (5, 35), (5, 36), (5, 37), (5, 38), (5, 39), (5, 40), (5, 41), (5, 42), (5, 48), (5, 55),
    (5, 62), (6, 36), (6, 37), (6, 38), (6, 39), (6, 40), (6, 41), (6, 42), (6, 49), (6, 56),
    (6, 63),
];

/// Regressor `W_b` of the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 64]; 7]) {
    let flat = &mut out.as_flattened_mut()[..];
    flat[44..50].fill(S::default());
    flat[51..57].fill(S::default());
    flat[58..65].fill(S::default());
    flat[107] = S::default();
    flat[109..115].fill(S::default());
    flat[116..122].fill(S::default());
    flat[123..136].fill(S::default());
    flat[171..173].fill(S::default());
    flat[174..180].fill(S::default());
    flat[181..187].fill(S::default());
    flat[188..207].fill(S::default());
    flat[235..238].fill(S::default());
    flat[239..245].fill(S::default());
    flat[246..252].fill(S::default());
    flat[253..278].fill(S::default());
    flat[299..303].fill(S::default());
    flat[304..310].fill(S::default());
    flat[311..317].fill(S::default());
    flat[318..349].fill(S::default());
    flat[363..368].fill(S::default());
    flat[369..375].fill(S::default());
    flat[376..382].fill(S::default());
    flat[383..420].fill(S::default());
    flat[427..433].fill(S::default());
    flat[434..440].fill(S::default());
    flat[441..447].fill(S::default());
    nonzeros(trig, dq, ddq, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 64]; 7]) {
    entries(trig, dq, ddq, |k, x| {
        out[PATTERN[k].0][PATTERN[k].1] = x;
    });
}

/// The same, only the entries of [`PATTERN`].
#[inline]
pub fn packed<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [S; NONZEROS]) {
    entries(trig, dq, ddq, |k, x| out[k] = x);
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6, ddq7] = *ddq;
    let k0 = S::constant(9.81);
    let k1 = S::constant(0.01175);
    let k2 = S::constant(0.42076);
    let k3 = S::constant(0.01275);
    let k4 = S::constant(0.31436);
    let k5 = S::constant(0.00035);
    let k6 = S::constant(0.167455);
    let k7 = S::constant(1.0);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        put(0, ddq1); // row 1, ZZ1R
        put(43, dq1); // row 1, FV1
        put(45, k7); // row 1, FO1
        put(49, ddq2); // row 2, ZZ2R
        put(88, dq2); // row 2, FV2
        put(90, k7); // row 2, FO2
        put(126, dq3); // row 3, FV3
        put(128, k7); // row 3, FO3
        put(157, dq4); // row 4, FV4
        put(159, k7); // row 4, FO4
        put(181, dq5); // row 5, FV5
        put(183, k7); // row 5, FO5
        put(198, dq6); // row 6, FV6
        put(200, k7); // row 6, FO6
        put(208, dq7); // row 7, FV7
        put(210, k7); // row 7, FO7
        t0
    };
    // link 2: motion
    let [
        t1, t2, a2_z, t6, t8, w2_x, w2_y, t11,
        t12, t15, t16, t17, dw2_x, dw2_y, t20, t21,
        t22, t23, t24, t25, t26,
    ] = {
        let t1 = s2 * k0;
        let t2 = c2 * k0;
        let t3 = ddq1 * k1;
        let a2_z = t0 * k1;
        let t6 = t1 + c2 * t3;
        let t8 = t2 - s2 * t3;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t11 = s2 * ddq1;
        let t12 = c2 * ddq1;
        let t13 = w2_x * w2_x;
        let t14 = dq2 * dq2;
        let t15 = w2_x * w2_y;
        let t16 = dq2 * w2_x;
        let t17 = dq2 * w2_y;
        let dw2_x = t11 + t17;
        let dw2_y = t12 - t16;
        let t20 = t14 - t13;
        let t21 = t0 + t20;
        let t22 = t15 - ddq2;
        let t23 = ddq2 + t15;
        let t24 = t13 + t14;
        let t25 = dw2_y - t16;
        let t26 = t17 + dw2_x;
        put(51, t11); // row 2, XZ2
        put(52, t12); // row 2, YZ2
        [
        t1, t2, a2_z, t6, t8, w2_x, w2_y, t11,
        t12, t15, t16, t17, dw2_x, dw2_y, t20, t21,
        t22, t23, t24, t25, t26,
    ]
    };
    // link 3: motion
    let [
        z1_3_x, z1_4_z, a3_z, t37, a3_y, w3_x, t46, t49,
        t52, w3_z, dw3_z, t57, t58, t59, t60, t61,
        t62, t63, t64, t65, t66, t67, t68,
    ] = {
        let z1_3_x = s2 * c3;
        let z1_4_z = s2 * s3;
        let t32 = t6 + t22 * k2;
        let a3_z = t24 * k2 - t8;
        let t34 = a2_z - t26 * k2;
        let t37 = c3 * t32 + s3 * t34;
        let a3_y = s3 * t32 - c3 * t34;
        let w3_x = c3 * w2_x - s3 * dq2;
        let t46 = c3 * dq2 + s3 * w2_x;
        let t49 = c3 * t22 - s3 * t26;
        let t52 = c3 * t26 + s3 * t22;
        let w3_z = w2_y + dq3;
        let dw3_z = dw2_y + ddq3;
        let t55 = w3_x * w3_x;
        let t56 = w3_z * w3_z;
        let t57 = w3_x * t46;
        let t58 = w3_x * w3_z;
        let t59 = t46 * w3_z;
        let t60 = t59 - t52;
        let t61 = t58 - t49;
        let t62 = t56 - t55;
        let t63 = t24 + t62;
        let t64 = dw3_z + t57;
        let t65 = t57 - dw3_z;
        let t66 = t55 + t56;
        let t67 = t58 + t61;
        let t68 = t59 + t60;
        put(91, a3_y); // row 3, MSX3
        put(92, t37); // row 3, MSY3R
        put(93, t57); // row 3, XX3R
        put(94, dw3_z); // row 3, ZZ3R
        put(96, t52); // row 3, XZ3
        put(97, t49); // row 3, YZ3
        [
        z1_3_x, z1_4_z, a3_z, t37, a3_y, w3_x, t46, t49,
        t52, w3_z, dw3_z, t57, t58, t59, t60, t61,
        t62, t63, t64, t65, t66, t67, t68,
    ]
    };
    // link 4: motion
    let [
        t73, t77, a4_y, w4_x, w4_y, t89, t92, w4_z,
        dw4_z, t97, t98, t99, dw4_x, dw4_y, t102, t103,
        t104, t105, t106, t107, t108,
    ] = {
        let t72 = t37 + t64 * k3;
        let t73 = t66 * k3 - a3_y;
        let t74 = t68 * k3 - a3_z;
        let t77 = c4 * t72 + s4 * t74;
        let a4_y = s4 * t72 - c4 * t74;
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t89 = c4 * t64 + s4 * t68;
        let t92 = s4 * t64 - c4 * t68;
        let w4_z = t46 + dq4;
        let dw4_z = t61 + ddq4;
        let t95 = w4_x * w4_x;
        let t96 = w4_z * w4_z;
        let t97 = w4_x * w4_y;
        let t98 = w4_x * w4_z;
        let t99 = w4_y * w4_z;
        let dw4_x = t92 + t99;
        let dw4_y = t89 - t98;
        let t102 = t96 - t95;
        let t103 = t66 + t102;
        let t104 = t97 - dw4_z;
        let t105 = dw4_z + t97;
        let t106 = t95 + t96;
        let t107 = dw4_y - t98;
        let t108 = t99 + dw4_x;
        put(129, a4_y); // row 4, MSX4
        put(130, t77); // row 4, MSY4R
        put(132, dw4_z); // row 4, ZZ4R
        put(134, t92); // row 4, XZ4
        put(135, t89); // row 4, YZ4
        [
        t73, t77, a4_y, w4_x, w4_y, t89, t92, w4_z,
        dw4_z, t97, t98, t99, dw4_x, dw4_y, t102, t103,
        t104, t105, t106, t107, t108,
    ]
    };
    // link 5: motion
    let [
        a5_z, t117, a5_y, w5_x, t126, t129, t132, w5_z,
        dw5_z, t137, t138, t139, t140, t141, t142, t143,
        t144, t145, t146, t147, t148,
    ] = {
        let t112 = t77 + t104 * k4;
        let a5_z = a4_y + t106 * k4;
        let t114 = t108 * k4 - t73;
        let t117 = c5 * t112 - s5 * t114;
        let a5_y = c5 * t114 + s5 * t112;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t126 = c5 * w4_z + s5 * w4_x;
        let t129 = c5 * t104 - s5 * t108;
        let t132 = c5 * t108 + s5 * t104;
        let w5_z = w4_y + dq5;
        let dw5_z = dw4_y + ddq5;
        let t135 = w5_x * w5_x;
        let t136 = w5_z * w5_z;
        let t137 = w5_x * t126;
        let t138 = w5_x * w5_z;
        let t139 = t126 * w5_z;
        let t140 = t139 - t132;
        let t141 = t138 - t129;
        let t142 = t135 - t136;
        let t143 = t142 - t106;
        let t144 = dw5_z + t137;
        let t145 = dw5_z - t137;
        let t146 = t135 + t136;
        let t147 = t138 + t141;
        let t148 = t139 + t140;
        put(160, a5_y); // row 5, MSX5
        put(161, t117); // row 5, MSY5R
        put(162, t137); // row 5, XX5R
        put(163, dw5_z); // row 5, ZZ5R
        put(165, t132); // row 5, XZ5
        put(166, t129); // row 5, YZ5
        [
        a5_z, t117, a5_y, w5_x, t126, t129, t132, w5_z,
        dw5_z, t137, t138, t139, t140, t141, t142, t143,
        t144, t145, t146, t147, t148,
    ]
    };
    // link 6: motion
    let [
        t153, t157, a6_y, w6_x, w6_y, t169, t172, w6_z,
        dw6_z, t177, t178, t179, dw6_x, t181, t182, t183,
        t184, t185, t186, t187, t188,
    ] = {
        let t152 = t117 + t144 * k5;
        let t153 = t146 * k5 - a5_y;
        let t154 = t148 * k5 - a5_z;
        let t157 = c6 * t152 + s6 * t154;
        let a6_y = s6 * t152 - c6 * t154;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t169 = c6 * t144 + s6 * t148;
        let t172 = s6 * t144 - c6 * t148;
        let w6_z = t126 + dq6;
        let dw6_z = t141 + ddq6;
        let t175 = w6_x * w6_x;
        let t176 = w6_z * w6_z;
        let t177 = w6_x * w6_y;
        let t178 = w6_x * w6_z;
        let t179 = w6_y * w6_z;
        let dw6_x = t172 + t179;
        let t181 = t178 - t169;
        let t182 = t175 - t176;
        let t183 = t182 - t146;
        let t184 = t177 - dw6_z;
        let t185 = dw6_z + t177;
        let t186 = t175 + t176;
        let t187 = t178 + t181;
        let t188 = t179 + dw6_x;
        put(184, a6_y); // row 6, MSX6
        put(185, t157); // row 6, MSY6R
        put(187, dw6_z); // row 6, ZZ6R
        put(189, t172); // row 6, XZ6
        put(190, t169); // row 6, YZ6
        [
        t153, t157, a6_y, w6_x, w6_y, t169, t172, w6_z,
        dw6_z, t177, t178, t179, dw6_x, t181, t182, t183,
        t184, t185, t186, t187, t188,
    ]
    };
    // link 7: motion
    let [
        a7_z, t197, a7_y, t209, t212, dw7_z, t217, t218,
        t219, t220, t222, t223, t224, t225, t226, t227,
        t228,
    ] = {
        let t192 = t157 + t184 * k6;
        let a7_z = a6_y + t186 * k6;
        let t194 = t153 - t188 * k6;
        let t197 = c7 * t192 + s7 * t194;
        let a7_y = s7 * t192 - c7 * t194;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t206 = c7 * w6_z + s7 * w6_x;
        let t209 = c7 * t184 - s7 * t188;
        let t212 = c7 * t188 + s7 * t184;
        let w7_z = w6_y + dq7;
        let dw7_z = ddq7 - t181;
        let t215 = w7_x * w7_x;
        let t216 = w7_z * w7_z;
        let t217 = w7_x * t206;
        let t218 = w7_x * w7_z;
        let t219 = t206 * w7_z;
        let t220 = t219 - t212;
        let dw7_y = t209 - t218;
        let t222 = t216 - t215;
        let t223 = t186 + t222;
        let t224 = dw7_z + t217;
        let t225 = t217 - dw7_z;
        let t226 = t215 + t216;
        let t227 = t218 - dw7_y;
        let t228 = t219 + t220;
        put(201, a7_y); // row 7, MSX7
        put(202, t197); // row 7, MSY7
        put(203, t217); // row 7, XX7R
        put(204, dw7_z); // row 7, ZZ7
        put(206, t212); // row 7, XZ7
        put(207, t209); // row 7, YZ7
        [
        a7_z, t197, a7_y, t209, t212, dw7_z, t217, t218,
        t219, t220, t222, t223, t224, t225, t226, t227,
        t228,
    ]
    };
    // joint axes in frame 2
    let [t229, v1_2_y] = {
        let t229 = c2 * k1;
        let v1_2_y = s2 * k1;
        [t229, v1_2_y]
    };
    // joint axes in frame 3
    let [t234, v1_3_y, v2_3_x, v2_4_z] = {
        let t231 = s2 * k2;
        let t234 = c3 * t229 - s3 * t231;
        let v1_3_y = c3 * t231 + s3 * t229;
        let v2_3_x = c3 * k2;
        let v2_4_z = s3 * k2;
        [t234, v1_3_y, v2_3_x, v2_4_z]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, t246, z2_4_y, t248, t249, t252, t255] = {
        let z1_4_x = c4 * z1_3_x + c2 * s4;
        let z1_4_y = c2 * c4 - s4 * z1_3_x;
        let t246 = s3 * c4;
        let z2_4_y = s3 * s4;
        let t248 = c4 * v2_3_x;
        let t249 = s4 * v2_3_x;
        let t252 = c4 * t234 - s4 * v1_2_y;
        let t255 = c4 * v1_2_y + s4 * t234;
        [z1_4_x, z1_4_y, t246, z2_4_y, t248, t249, t252, t255]
    };
    // joint axes in frame 5
    let [t258, z1_6_z, t264, t267, z3_5_x, z3_6_z] = {
        let t258 = s5 * z1_4_z - c5 * z1_4_x;
        let z1_6_z = c5 * z1_4_z + s5 * z1_4_x;
        let t264 = c5 * t246 + c3 * s5;
        let t267 = c3 * c5 - s5 * t246;
        let z3_5_x = s4 * c5;
        let z3_6_z = s4 * s5;
        [t258, z1_6_z, t264, t267, z3_5_x, z3_6_z]
    };
    // XZ2: column
    {
        let t272 = s2 * t23 + c2 * t20;
        let t273 = k1 * t272;
        let t275 = k1 * t11 - t2;
        put(1, t273); // row 1, MSX2
        put(6, t272); // row 1, XZ2
        put(46, t275); // row 2, MSX2
    }
    // YZ2: column
    {
        let t279 = s2 * (t0 - t24) - c2 * t22;
        let t280 = k1 * t279;
        let t282 = t1 + k1 * t12;
        put(2, t280); // row 1, MSY2R
        put(7, t279); // row 1, YZ2
        put(47, t282); // row 2, MSY2R
    }
    // XX2: column
    let t284 = {
        let t284 = c2 * t16;
        let t285 = s2 * dw2_x + t284;
        put(3, t285); // row 1, XX2R
        t284
    };
    // ZZ2: column
    {
        let t287 = s2 * t17 - t284;
        put(4, t287); // row 1, ZZ2R
    }
    // XY2: column
    {
        let t288 = t24 - t21;
        let t291 = s2 * t25 + c2 * t26;
        put(5, t291); // row 1, XY2
        put(50, t288); // row 2, XY2
    }
    // MSX3: column
    {
        let t299 = t67 * v1_2_y + (t63 * t234 - t65 * v1_3_y);
        let t300 = z1_4_z * a3_z + c2 * a3_y + t299;
        let t305 = c3 * a3_z + (t65 * v2_4_z - t63 * v2_3_x);
        put(8, t300); // row 1, MSX3
        put(53, t305); // row 2, MSX3
    }
    // MSY3: column
    {
        let t313 = t68 * v1_2_y + (t66 * v1_3_y - t64 * t234);
        let t314 = z1_3_x * a3_z + c2 * t37 - t313;
        let t319 = t66 * v2_4_z - t64 * v2_3_x - s3 * a3_z;
        put(9, t314); // row 1, MSY3R
        put(54, t319); // row 2, MSY3R
    }
    // XX3: column
    let [t321, t326] = {
        let t321 = z1_4_z * t58;
        let t324 = c2 * t57 - (z1_3_x * t60 + t321);
        let t326 = c3 * t58;
        let t327 = s3 * t60 - t326;
        put(10, t324); // row 1, XX3R
        put(55, t327); // row 2, XX3R
        [t321, t326]
    };
    // ZZ3: column
    {
        let t331 = c2 * dw3_z - (z1_3_x * t59 - t321);
        let t333 = t326 + s3 * t59;
        put(11, t331); // row 1, ZZ3R
        put(56, t333); // row 2, ZZ3R
    }
    // XY3: column
    {
        let t334 = t66 - t63;
        let t339 = c2 * t334 + (z1_4_z * t68 - z1_3_x * t67);
        let t342 = s3 * t67 + c3 * t68;
        put(12, t339); // row 1, XY3
        put(57, t342); // row 2, XY3
        put(95, t334); // row 3, XY3
    }
    // XZ3: column
    {
        let t347 = c2 * t52 - (z1_3_x * t65 + z1_4_z * t62);
        let t350 = s3 * t65 - c3 * t62;
        put(13, t347); // row 1, XZ3
        put(58, t350); // row 2, XZ3
    }
    // YZ3: column
    {
        let t351 = t66 - t24;
        let t356 = c2 * t49 - (z1_3_x * t351 + z1_4_z * t64);
        let t359 = s3 * t351 - c3 * t64;
        put(14, t356); // row 1, YZ3
        put(59, t359); // row 2, YZ3
    }
    // MSX4: column
    let [t361, t366, t367] = {
        let t361 = s4 * t105;
        let t362 = c4 * t103 + t361;
        let t365 = s4 * t103 - c4 * t105;
        let t366 = s4 * t73;
        let t367 = c4 * t73;
        let t370 = t366 - k3 * t365;
        let t371 = k3 * t362 - t367;
        let t381 = t234 * t362 + t107 * v1_3_y - v1_2_y * t365;
        let t382 = c2 * t371 + (z1_3_x * t370 + z1_4_z * a4_y) + t381;
        let t389 = c3 * a4_y - s3 * t370 - (v2_3_x * t362 + t107 * v2_4_z);
        put(15, t382); // row 1, MSX4
        put(60, t389); // row 2, MSX4
        put(98, t371); // row 3, MSX4
        [t361, t366, t367]
    };
    // MSY4: column
    let t390 = {
        let t390 = c4 * t104;
        let t392 = t390 + s4 * t106;
        let t395 = s4 * t104 - c4 * t106;
        let t398 = t367 + k3 * t395;
        let t399 = t366 - k3 * t392;
        let t409 = v1_2_y * t395 - (t234 * t392 + t108 * v1_3_y);
        let t410 = c2 * t399 + (z1_3_x * t398 + z1_4_z * t77) + t409;
        let t417 = v2_3_x * t392 + t108 * v2_4_z - (s3 * t398 - c3 * t77);
        put(16, t410); // row 1, MSY4R
        put(61, t417); // row 2, MSY4R
        put(99, t399); // row 3, MSY4R
        t390
    };
    // XX4: column
    let [t419, t424, t429] = {
        let t419 = t98 * z1_4_y;
        let t422 = dw4_x * z1_4_x + t419 - z1_4_z * t97;
        let t424 = t98 * z2_4_y;
        let t427 = t424 - dw4_x * t246 - c3 * t97;
        let t429 = c4 * t98;
        let t430 = s4 * dw4_x + t429;
        put(17, t422); // row 1, XX4R
        put(62, t427); // row 2, XX4R
        put(100, t430); // row 3, XX4R
        [t419, t424, t429]
    };
    // ZZ4: column
    {
        let t434 = z1_4_z * dw4_z + (t99 * z1_4_x - t419);
        let t438 = c3 * dw4_z - (t424 + t99 * t246);
        let t440 = s4 * t99 - t429;
        put(18, t434); // row 1, ZZ4R
        put(63, t438); // row 2, ZZ4R
        put(101, t440); // row 3, ZZ4R
    }
    // XY4: column
    {
        let t441 = t106 - t103;
        let t446 = z1_4_z * t441 + (t107 * z1_4_x + t108 * z1_4_y);
        let t451 = c3 * t441 + (t108 * z2_4_y - t107 * t246);
        let t454 = s4 * t107 + c4 * t108;
        put(19, t446); // row 1, XY4
        put(64, t451); // row 2, XY4
        put(102, t454); // row 3, XY4
        put(133, t441); // row 4, XY4
    }
    // XZ4: column
    {
        let t459 = z1_4_z * t92 + (t105 * z1_4_x + t102 * z1_4_y);
        let t464 = c3 * t92 + (t102 * z2_4_y - t105 * t246);
        let t466 = t361 + c4 * t102;
        put(20, t459); // row 1, XZ4
        put(65, t464); // row 2, XZ4
        put(103, t466); // row 3, XZ4
    }
    // YZ4: column
    {
        let t467 = t66 - t106;
        let t472 = z1_4_z * t89 + (z1_4_x * t467 - t104 * z1_4_y);
        let t477 = c3 * t89 - (t246 * t467 + t104 * z2_4_y);
        let t479 = s4 * t467 - t390;
        put(21, t472); // row 1, YZ4
        put(66, t477); // row 2, YZ4
        put(104, t479); // row 3, YZ4
    }
    // MSX5: column
    let [t481, t486, t487] = {
        let t481 = s5 * t145;
        let t482 = c5 * t143 - t481;
        let t485 = s5 * t143 + c5 * t145;
        let t486 = s5 * a5_z;
        let t487 = c5 * a5_z;
        let t491 = t487 + k4 * t482;
        let t494 = t486 + k4 * t485 + k3 * t147;
        let t495 = a5_y - k3 * t482;
        let t505 = v1_3_y * t485 + (t147 * t255 - t252 * t482);
        let t506 = z1_4_z * t491 + (z1_4_x * t494 + z1_4_y * t495) + t505;
        let t516 = v2_4_z * t485 + (t147 * t249 - t248 * t482);
        let t517 = c3 * t491 + (z2_4_y * t495 - t246 * t494) - t516;
        let t520 = s4 * t494 + c4 * t495;
        put(22, t506); // row 1, MSX5
        put(67, t517); // row 2, MSX5
        put(105, t520); // row 3, MSX5
        put(136, t491); // row 4, MSX5
        [t481, t486, t487]
    };
    // MSY5: column
    let t521 = {
        let t521 = c5 * t144;
        let t523 = s5 * t146 - t521;
        let t526 = s5 * t144 + c5 * t146;
        let t530 = k4 * t523 - t486;
        let t533 = k4 * t526 - t487 + k3 * t148;
        let t534 = t117 - k3 * t523;
        let t544 = v1_3_y * t526 + (t252 * t523 + t148 * t255);
        let t545 = z1_4_z * t530 + (z1_4_y * t534 - z1_4_x * t533) - t544;
        let t555 = v2_4_z * t526 + (t248 * t523 + t148 * t249);
        let t556 = c3 * t530 + (t246 * t533 + z2_4_y * t534) + t555;
        let t559 = c4 * t534 - s4 * t533;
        put(23, t545); // row 1, MSY5R
        put(68, t556); // row 2, MSY5R
        put(106, t559); // row 3, MSY5R
        put(137, t530); // row 4, MSY5R
        t521
    };
    // XX5: column
    let [t561, t566, t571, t576] = {
        let t561 = t138 * z1_6_z;
        let t564 = t137 * z1_4_y + (t140 * t258 - t561);
        let t566 = t138 * t267;
        let t569 = t137 * z2_4_y + (t140 * t264 - t566);
        let t571 = t138 * z3_6_z;
        let t574 = c4 * t137 - (t140 * z3_5_x + t571);
        let t576 = c5 * t138;
        let t577 = s5 * t140 - t576;
        put(24, t564); // row 1, XX5R
        put(69, t569); // row 2, XX5R
        put(107, t574); // row 3, XX5R
        put(138, t577); // row 4, XX5R
        [t561, t566, t571, t576]
    };
    // ZZ5: column
    {
        let t581 = dw5_z * z1_4_y + (t561 + t139 * t258);
        let t585 = dw5_z * z2_4_y + (t566 + t139 * t264);
        let t589 = c4 * dw5_z - (t139 * z3_5_x - t571);
        let t591 = t576 + s5 * t139;
        put(25, t581); // row 1, ZZ5R
        put(70, t585); // row 2, ZZ5R
        put(108, t589); // row 3, ZZ5R
        put(139, t591); // row 4, ZZ5R
    }
    // XY5: column
    {
        let t592 = t143 + t146;
        let t597 = z1_4_y * t592 + (t147 * t258 + t148 * z1_6_z);
        let t602 = z2_4_y * t592 + (t147 * t264 + t148 * t267);
        let t607 = c4 * t592 + (t148 * z3_6_z - t147 * z3_5_x);
        let t610 = s5 * t147 + c5 * t148;
        put(26, t597); // row 1, XY5
        put(71, t602); // row 2, XY5
        put(109, t607); // row 3, XY5
        put(140, t610); // row 4, XY5
        put(164, t592); // row 5, XY5
    }
    // XZ5: column
    {
        let t615 = t132 * z1_4_y + (t142 * z1_6_z - t145 * t258);
        let t620 = t132 * z2_4_y + (t142 * t267 - t145 * t264);
        let t625 = c4 * t132 + (t145 * z3_5_x + t142 * z3_6_z);
        let t627 = c5 * t142 - t481;
        put(27, t615); // row 1, XZ5
        put(72, t620); // row 2, XZ5
        put(110, t625); // row 3, XZ5
        put(141, t627); // row 4, XZ5
    }
    // YZ5: column
    {
        let t628 = t146 - t106;
        let t633 = t129 * z1_4_y + (t258 * t628 - t144 * z1_6_z);
        let t638 = t129 * z2_4_y - (t144 * t267 - t264 * t628);
        let t643 = c4 * t129 - (z3_5_x * t628 + t144 * z3_6_z);
        let t645 = s5 * t628 - t521;
        put(28, t633); // row 1, YZ5
        put(73, t638); // row 2, YZ5
        put(111, t643); // row 3, YZ5
        put(142, t645); // row 4, YZ5
    }
    // MSX6: column
    let [t647, t650, t652, t653] = {
        let t647 = s6 * t185;
        let t648 = t647 - c6 * t183;
        let t650 = c6 * t185;
        let t651 = s6 * t183 + t650;
        let t652 = s6 * t153;
        let t653 = c6 * t153;
        let t656 = t652 + k5 * t651;
        let t657 = k5 * t648 - t653;
        let t660 = s5 * t187 - c5 * t648;
        let t663 = s5 * t648 + c5 * t187;
        let t673 = c5 * a6_y - s5 * t656 + k4 * t660;
        let t676 = k3 * t651 - (k4 * t663 - (c5 * t656 + s5 * a6_y));
        let t677 = t657 - k3 * t660;
        let t687 = v1_3_y * t663 - (t255 * t651 - t252 * t660);
        let t688 = z1_4_z * t673 + (z1_4_x * t676 + z1_4_y * t677) - t687;
        let t698 = v2_4_z * t663 - (t249 * t651 - t248 * t660);
        let t699 = c3 * t673 - (t246 * t676 - z2_4_y * t677) + t698;
        let t702 = s4 * t676 + c4 * t677;
        put(29, t688); // row 1, MSX6
        put(74, t699); // row 2, MSX6
        put(112, t702); // row 3, MSX6
        put(143, t673); // row 4, MSX6
        put(167, t657); // row 5, MSX6
        [t647, t650, t652, t653]
    };
    // MSY6: column
    let [t703, t706] = {
        let t703 = c6 * t184;
        let t705 = t703 + s6 * t186;
        let t706 = s6 * t184;
        let t708 = t706 - c6 * t186;
        let t711 = t653 + k5 * t708;
        let t712 = t652 - k5 * t705;
        let t715 = c5 * t705 + s5 * t188;
        let t718 = c5 * t188 - s5 * t705;
        let t728 = c5 * t157 - s5 * t711 + k4 * t715;
        let t731 = k3 * t708 - (k4 * t718 - (c5 * t711 + s5 * t157));
        let t732 = t712 - k3 * t715;
        let t742 = v1_3_y * t718 - (t255 * t708 - t252 * t715);
        let t743 = z1_4_z * t728 + (z1_4_x * t731 + z1_4_y * t732) - t742;
        let t753 = t249 * t708 - t248 * t715 - v2_4_z * t718;
        let t754 = c3 * t728 + (z2_4_y * t732 - t246 * t731) - t753;
        let t757 = s4 * t731 + c4 * t732;
        put(30, t743); // row 1, MSY6R
        put(75, t754); // row 2, MSY6R
        put(113, t757); // row 3, MSY6R
        put(144, t728); // row 4, MSY6R
        put(168, t712); // row 5, MSY6R
        [t703, t706]
    };
    // XX6: column
    let [t759, t762] = {
        let t759 = s6 * t178;
        let t760 = t759 - c6 * dw6_x;
        let t762 = c6 * t178;
        let t763 = s6 * dw6_x + t762;
        let t768 = z1_4_y * t763 + (t258 * t760 - t177 * z1_6_z);
        let t773 = z2_4_y * t763 - (t177 * t267 - t264 * t760);
        let t778 = c4 * t763 - (z3_5_x * t760 + t177 * z3_6_z);
        let t781 = s5 * t760 - c5 * t177;
        put(31, t768); // row 1, XX6R
        put(76, t773); // row 2, XX6R
        put(114, t778); // row 3, XX6R
        put(145, t781); // row 4, XX6R
        put(169, t763); // row 5, XX6R
        [t759, t762]
    };
    // ZZ6: column
    {
        let t783 = t759 + c6 * t179;
        let t785 = s6 * t179 - t762;
        let t790 = z1_4_y * t785 + (dw6_z * z1_6_z - t258 * t783);
        let t795 = z2_4_y * t785 + (dw6_z * t267 - t264 * t783);
        let t800 = c4 * t785 + (z3_5_x * t783 + dw6_z * z3_6_z);
        let t803 = c5 * dw6_z - s5 * t783;
        put(32, t790); // row 1, ZZ6R
        put(77, t795); // row 2, ZZ6R
        put(115, t800); // row 3, ZZ6R
        put(146, t803); // row 4, ZZ6R
        put(170, t785); // row 5, ZZ6R
    }
    // XY6: column
    {
        let t804 = t183 + t186;
        let t807 = c6 * t187 + s6 * t188;
        let t810 = c6 * t188 - s6 * t187;
        let t815 = z1_4_y * t810 + (t258 * t807 + z1_6_z * t804);
        let t820 = z2_4_y * t810 + (t264 * t807 + t267 * t804);
        let t825 = c4 * t810 + (z3_6_z * t804 - z3_5_x * t807);
        let t828 = s5 * t807 + c5 * t804;
        put(33, t815); // row 1, XY6
        put(78, t820); // row 2, XY6
        put(116, t825); // row 3, XY6
        put(147, t828); // row 4, XY6
        put(171, t810); // row 5, XY6
        put(188, t804); // row 6, XY6
    }
    // XZ6: column
    {
        let t830 = t650 + s6 * t182;
        let t832 = t647 - c6 * t182;
        let t837 = z1_4_y * t832 + (t172 * z1_6_z - t258 * t830);
        let t842 = z2_4_y * t832 - (t264 * t830 - t172 * t267);
        let t847 = c4 * t832 + (z3_5_x * t830 + t172 * z3_6_z);
        let t850 = c5 * t172 - s5 * t830;
        put(34, t837); // row 1, XZ6
        put(79, t842); // row 2, XZ6
        put(117, t847); // row 3, XZ6
        put(148, t850); // row 4, XZ6
        put(172, t832); // row 5, XZ6
    }
    // YZ6: column
    {
        let t851 = t146 - t186;
        let t853 = t706 + c6 * t851;
        let t855 = s6 * t851 - t703;
        let t860 = z1_4_y * t855 - (t258 * t853 - t169 * z1_6_z);
        let t865 = z2_4_y * t855 + (t169 * t267 - t264 * t853);
        let t870 = c4 * t855 + (z3_5_x * t853 + t169 * z3_6_z);
        let t873 = c5 * t169 - s5 * t853;
        put(35, t860); // row 1, YZ6
        put(80, t865); // row 2, YZ6
        put(118, t870); // row 3, YZ6
        put(149, t873); // row 4, YZ6
        put(173, t855); // row 5, YZ6
    }
    // MSX7: column
    let [t875, t878, t880, t881] = {
        let t875 = s7 * t225;
        let t876 = c7 * t223 - t875;
        let t878 = c7 * t225;
        let t879 = s7 * t223 + t878;
        let t880 = s7 * a7_z;
        let t881 = c7 * a7_z;
        let t884 = k6 * t879 - t880;
        let t885 = t881 - k6 * t876;
        let t888 = c6 * t876 + s6 * t227;
        let t891 = s6 * t876 - c6 * t227;
        let t900 = c6 * t884 + s6 * a7_y + k5 * t891;
        let t901 = k5 * t888 - (s6 * t884 - c6 * a7_y);
        let t904 = c5 * t888 - s5 * t879;
        let t907 = s5 * t888 + c5 * t879;
        let t917 = s5 * t900 + c5 * t885 - k4 * t904;
        let t920 = s5 * t885 - c5 * t900 - k4 * t907 - k3 * t891;
        let t921 = t901 + k3 * t904;
        let t931 = v1_3_y * t907 - (t252 * t904 - t255 * t891);
        let t932 = z1_4_z * t917 + (z1_4_x * t920 + z1_4_y * t921) - t931;
        let t942 = v2_4_z * t907 + (t249 * t891 - t248 * t904);
        let t943 = c3 * t917 + (z2_4_y * t921 - t246 * t920) + t942;
        let t946 = s4 * t920 + c4 * t921;
        put(36, t932); // row 1, MSX7
        put(81, t943); // row 2, MSX7
        put(119, t946); // row 3, MSX7
        put(150, t917); // row 4, MSX7
        put(174, t901); // row 5, MSX7
        put(191, t885); // row 6, MSX7
        [t875, t878, t880, t881]
    };
    // MSY7: column
    let [t947, t950] = {
        let t947 = c7 * t224;
        let t949 = s7 * t226 - t947;
        let t950 = s7 * t224;
        let t952 = t950 + c7 * t226;
        let t955 = t881 - k6 * t952;
        let t956 = k6 * t949 - t880;
        let t959 = c6 * t949 + s6 * t228;
        let t962 = s6 * t949 - c6 * t228;
        let t971 = c6 * t955 - s6 * t197 + k5 * t962;
        let t972 = s6 * t955 + c6 * t197 - k5 * t959;
        let t975 = c5 * t959 + s5 * t952;
        let t978 = c5 * t952 - s5 * t959;
        let t988 = c5 * t956 - s5 * t971 + k4 * t975;
        let t991 = c5 * t971 + s5 * t956 - k4 * t978 + k3 * t962;
        let t992 = t972 - k3 * t975;
        let t1002 = t255 * t962 - t252 * t975 - v1_3_y * t978;
        let t1003 = z1_4_z * t988 + (z1_4_x * t991 + z1_4_y * t992) + t1002;
        let t1013 = v2_4_z * t978 + (t248 * t975 - t249 * t962);
        let t1014 = c3 * t988 + (z2_4_y * t992 - t246 * t991) + t1013;
        let t1017 = s4 * t991 + c4 * t992;
        put(37, t1003); // row 1, MSY7
        put(82, t1014); // row 2, MSY7
        put(120, t1017); // row 3, MSY7
        put(151, t988); // row 4, MSY7
        put(175, t972); // row 5, MSY7
        put(192, t956); // row 6, MSY7
        [t947, t950]
    };
    // XX7: column
    let [t1019, t1022] = {
        let t1019 = s7 * t218;
        let t1020 = c7 * t220 + t1019;
        let t1022 = c7 * t218;
        let t1023 = s7 * t220 - t1022;
        let t1026 = c6 * t1020 + s6 * t217;
        let t1029 = c6 * t217 - s6 * t1020;
        let t1034 = z1_4_y * t1029 + (t258 * t1026 + z1_6_z * t1023);
        let t1039 = z2_4_y * t1029 + (t264 * t1026 + t267 * t1023);
        let t1044 = c4 * t1029 - (z3_5_x * t1026 - z3_6_z * t1023);
        let t1047 = s5 * t1026 + c5 * t1023;
        put(38, t1034); // row 1, XX7R
        put(83, t1039); // row 2, XX7R
        put(121, t1044); // row 3, XX7R
        put(152, t1047); // row 4, XX7R
        put(176, t1029); // row 5, XX7R
        put(193, t1023); // row 6, XX7R
        [t1019, t1022]
    };
    // ZZ7: column
    {
        let t1049 = c7 * t219 - t1019;
        let t1051 = t1022 + s7 * t219;
        let t1054 = c6 * t1049 + s6 * dw7_z;
        let t1057 = c6 * dw7_z - s6 * t1049;
        let t1062 = z1_4_y * t1057 + (t258 * t1054 + z1_6_z * t1051);
        let t1067 = z2_4_y * t1057 + (t264 * t1054 + t267 * t1051);
        let t1072 = c4 * t1057 + (z3_6_z * t1051 - z3_5_x * t1054);
        let t1075 = s5 * t1054 + c5 * t1051;
        put(39, t1062); // row 1, ZZ7
        put(84, t1067); // row 2, ZZ7
        put(122, t1072); // row 3, ZZ7
        put(153, t1075); // row 4, ZZ7
        put(177, t1057); // row 5, ZZ7
        put(194, t1051); // row 6, ZZ7
    }
    // XY7: column
    {
        let t1076 = t226 - t223;
        let t1079 = c7 * t227 - s7 * t228;
        let t1082 = s7 * t227 + c7 * t228;
        let t1085 = c6 * t1079 + s6 * t1076;
        let t1088 = c6 * t1076 - s6 * t1079;
        let t1093 = z1_4_y * t1088 + (t258 * t1085 + z1_6_z * t1082);
        let t1098 = z2_4_y * t1088 + (t264 * t1085 + t267 * t1082);
        let t1103 = c4 * t1088 + (z3_6_z * t1082 - z3_5_x * t1085);
        let t1106 = s5 * t1085 + c5 * t1082;
        put(40, t1093); // row 1, XY7
        put(85, t1098); // row 2, XY7
        put(123, t1103); // row 3, XY7
        put(154, t1106); // row 4, XY7
        put(178, t1088); // row 5, XY7
        put(195, t1082); // row 6, XY7
        put(205, t1076); // row 7, XY7
    }
    // XZ7: column
    {
        let t1108 = t878 + s7 * t222;
        let t1110 = t875 - c7 * t222;
        let t1113 = c6 * t1108 + s6 * t212;
        let t1116 = c6 * t212 - s6 * t1108;
        let t1121 = z1_4_y * t1116 + (t258 * t1113 + z1_6_z * t1110);
        let t1126 = z2_4_y * t1116 + (t264 * t1113 + t267 * t1110);
        let t1131 = c4 * t1116 + (z3_6_z * t1110 - z3_5_x * t1113);
        let t1134 = s5 * t1113 + c5 * t1110;
        put(41, t1121); // row 1, XZ7
        put(86, t1126); // row 2, XZ7
        put(124, t1131); // row 3, XZ7
        put(155, t1134); // row 4, XZ7
        put(179, t1116); // row 5, XZ7
        put(196, t1110); // row 6, XZ7
    }
    // YZ7: column
    {
        let t1135 = t226 - t186;
        let t1137 = t950 + c7 * t1135;
        let t1139 = s7 * t1135 - t947;
        let t1142 = c6 * t1137 + s6 * t209;
        let t1145 = c6 * t209 - s6 * t1137;
        let t1150 = z1_4_y * t1145 + (t258 * t1142 + z1_6_z * t1139);
        let t1155 = z2_4_y * t1145 + (t264 * t1142 + t267 * t1139);
        let t1160 = c4 * t1145 + (z3_6_z * t1139 - z3_5_x * t1142);
        let t1163 = s5 * t1142 + c5 * t1139;
        let t1164 = dq1.sign();
        let t1165 = dq2.sign();
        let t1166 = dq3.sign();
        let t1167 = dq4.sign();
        let t1168 = dq5.sign();
        let t1169 = dq6.sign();
        let t1170 = dq7.sign();
        let t1171 = -t15;
        let t1172 = -t97;
        let t1173 = -t177;
        put(42, t1150); // row 1, YZ7
        put(44, t1164); // row 1, FC1
        put(48, t1171); // row 2, XX2R
        put(87, t1155); // row 2, YZ7
        put(89, t1165); // row 2, FC2
        put(125, t1160); // row 3, YZ7
        put(127, t1166); // row 3, FC3
        put(131, t1172); // row 4, XX4R
        put(156, t1163); // row 4, YZ7
        put(158, t1167); // row 4, FC4
        put(180, t1145); // row 5, YZ7
        put(182, t1168); // row 5, FC5
        put(186, t1173); // row 6, XX6R
        put(197, t1139); // row 6, YZ7
        put(199, t1169); // row 6, FC6
        put(209, t1170); // row 7, FC7
    }
}
