//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil and Dombre, 12.4.
//!
//! 934 multiplications, 690 additions; 7 x 91, 280 of 637 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 280;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 6), (0, 10), (0, 11), (0, 12), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18),
    (0, 19), (0, 20), (0, 21), (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28),
    (0, 29), (0, 30), (0, 31), (0, 32), (0, 33), (0, 34), (0, 35), (0, 36), (0, 37), (0, 38),
    (0, 39), (0, 40), (0, 41), (0, 42), (0, 43), (0, 44), (0, 45), (0, 46), (0, 47), (0, 48),
    (0, 49), (0, 50), (0, 51), (0, 52), (0, 53), (0, 54), (0, 55), (0, 56), (0, 57), (0, 58),
    (0, 59), (0, 60), (0, 61), (0, 62), (0, 63), (0, 64), (0, 65), (0, 66), (0, 67), (0, 68),
    (0, 69), (0, 70), (0, 77), (0, 84), (1, 11), (1, 12), (1, 14), (1, 15), (1, 16), (1, 17),
    (1, 18), (1, 19), (1, 20), (1, 21), (1, 22), (1, 23), (1, 24), (1, 25), (1, 26), (1, 27),
    (1, 28), (1, 29), (1, 30), (1, 31), (1, 32), (1, 33), (1, 34), (1, 35), (1, 36), (1, 37),
    (1, 38), (1, 39), (1, 40), (1, 41), (1, 42), (1, 43), (1, 44), (1, 45), (1, 46), (1, 47),
    (1, 48), (1, 49), (1, 50), (1, 51), (1, 52), (1, 53), (1, 54), (1, 55), (1, 56), (1, 57),
    (1, 58), (1, 59), (1, 60), (1, 61), (1, 62), (1, 63), (1, 64), (1, 65), (1, 66), (1, 67),
    (1, 68), (1, 69), (1, 71), (1, 78), (1, 85), (2, 21), (2, 22), (2, 24), (2, 25), (2, 26),
    (2, 27), (2, 28), (2, 29), (2, 30), (2, 31), (2, 32), (2, 33), (2, 34), (2, 35), (2, 36),
    (2, 37), (2, 38), (2, 39), (2, 40), (2, 41), (2, 42), (2, 43), (2, 44), (2, 45), (2, 46),
    (2, 47), (2, 48), (2, 49), (2, 50), (2, 51), (2, 52), (2, 53), (2, 54), (2, 55), (2, 56),
    (2, 57), (2, 58), (2, 59), (2, 60), (2, 61), (2, 62), (2, 63), (2, 64), (2, 65), (2, 66),
    (2, 67), (2, 68), (2, 69), (2, 72), (2, 79), (2, 86), (3, 31), (3, 32), (3, 34), (3, 35),
    (3, 36), (3, 37), (3, 38), (3, 39), (3, 40), (3, 41), (3, 42), (3, 43), (3, 44), (3, 45),
    (3, 46), (3, 47), (3, 48), (3, 49), (3, 50), (3, 51), (3, 52), (3, 53), (3, 54), (3, 55),
    (3, 56), (3, 57), (3, 58), (3, 59), (3, 60), (3, 61), (3, 62), (3, 63), (3, 64), (3, 65),
    (3, 66), (3, 67), (3, 68), (3, 69), (3, 73), (3, 80), (3, 87), (4, 41), (4, 42), (4, 44),
    (4, 45), (4, 46), (4, 47), (4, 48), (4, 49), (4, 50), (4, 51), (4, 52), (4, 53), (4, 54),
    (4, 55), (4, 56), (4, 57), (4, 58), (4, 59), (4, 60), (4, 61), (4, 62), (4, 63), (4, 64),
    (4, 65), (4, 66), (4, 67), (4, 68), (4, 69), (4, 74), (4, 81), (4, 88), (5, 51), (5, 52),
    (5, 54), (5, 55), (5, 56), (5, 57), (5, 58), (5, 59), (5, 60), (5, 61), (5, 62), (5, 63),
    (5, 64), (5, 65), (5, 66), (5, 67), (5, 68), (5, 69), (5, 75), (5, 82), (5, 89), (6, 61),
    (6, 62), (6, 64), (6, 65), (6, 66), (6, 67), (6, 68), (6, 69), (6, 76), (6, 83), (6, 90),
];

/// Regressor `W` of the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 91]; 7]) {
    let flat = &mut out.as_flattened_mut()[..];
    flat[0..6].fill(S::default());
    flat[7..10].fill(S::default());
    flat[71..77].fill(S::default());
    flat[78..84].fill(S::default());
    flat[85..102].fill(S::default());
    flat[104] = S::default();
    flat[161] = S::default();
    flat[163..169].fill(S::default());
    flat[170..176].fill(S::default());
    flat[177..203].fill(S::default());
    flat[205] = S::default();
    flat[252..254].fill(S::default());
    flat[255..261].fill(S::default());
    flat[262..268].fill(S::default());
    flat[269..304].fill(S::default());
    flat[306] = S::default();
    flat[343..346].fill(S::default());
    flat[347..353].fill(S::default());
    flat[354..360].fill(S::default());
    flat[361..405].fill(S::default());
    flat[407] = S::default();
    flat[434..438].fill(S::default());
    flat[439..445].fill(S::default());
    flat[446..452].fill(S::default());
    flat[453..506].fill(S::default());
    flat[508] = S::default();
    flat[525..530].fill(S::default());
    flat[531..537].fill(S::default());
    flat[538..544].fill(S::default());
    flat[545..607].fill(S::default());
    flat[609] = S::default();
    flat[616..622].fill(S::default());
    flat[623..629].fill(S::default());
    flat[630..636].fill(S::default());
    nonzeros(trig, dq, ddq, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 91]; 7]) {
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
    let k7 = S::constant(0.0001380625);
    let k8 = S::constant(0.0235);
    let k9 = S::constant(1.0);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        put(0, ddq1); // row 1, ZZ1
        put(61, dq1); // row 1, FV1
        put(63, k9); // row 1, FO1
        put(68, ddq2); // row 2, ZZ2
        put(122, dq2); // row 2, FV2
        put(124, k9); // row 2, FO2
        put(173, dq3); // row 3, FV3
        put(175, k9); // row 3, FO3
        put(214, dq4); // row 4, FV4
        put(216, k9); // row 4, FO4
        put(245, dq5); // row 5, FV5
        put(247, k9); // row 5, FO5
        put(266, dq6); // row 6, FV6
        put(268, k9); // row 6, FO6
        put(277, dq7); // row 7, FV7
        put(279, k9); // row 7, FO7
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
        put(67, t15); // row 2, YY2
        put(70, t11); // row 2, XZ2
        put(71, t12); // row 2, YZ2
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
        let t34 = t26 * k2 - a2_z;
        let t37 = c3 * t32 - s3 * t34;
        let a3_y = c3 * t34 + s3 * t32;
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
        let t62 = t55 - t56;
        let t63 = t62 - t24;
        let t64 = dw3_z + t57;
        let t65 = t57 - dw3_z;
        let t66 = t55 + t56;
        let t67 = t58 + t61;
        let t68 = t59 + t60;
        put(125, a3_y); // row 3, MSX3
        put(126, t37); // row 3, MSY3
        put(127, t57); // row 3, XX3
        put(129, dw3_z); // row 3, ZZ3
        put(131, t52); // row 3, XZ3
        put(132, t49); // row 3, YZ3
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
        let t107 = t98 - dw4_y;
        let t108 = t99 + dw4_x;
        put(176, a4_y); // row 4, MSX4
        put(177, t77); // row 4, MSY4
        put(179, t97); // row 4, YY4
        put(180, dw4_z); // row 4, ZZ4
        put(182, t92); // row 4, XZ4
        put(183, t89); // row 4, YZ4
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
        let t145 = t137 - dw5_z;
        let t146 = t135 + t136;
        let t147 = t138 + t141;
        let t148 = t139 + t140;
        put(217, a5_y); // row 5, MSX5
        put(218, t117); // row 5, MSY5
        put(219, t137); // row 5, XX5
        put(221, dw5_z); // row 5, ZZ5
        put(223, t132); // row 5, XZ5
        put(224, t129); // row 5, YZ5
        [
        a5_z, t117, a5_y, w5_x, t126, t129, t132, w5_z,
        dw5_z, t137, t138, t139, t140, t141, t142, t143,
        t144, t145, t146, t147, t148,
    ]
    };
    // link 6: motion
    let [
        t153, t157, a6_y, w6_x, w6_y, t169, t172, w6_z,
        dw6_z, t177, t178, t179, dw6_x, dw6_y, t182, t183,
        t184, t185, t186, t187, t188,
    ] = {
        let t152 = t117 + t144 * k5;
        let t153 = t146 * k5 - a5_y;
        let t154 = a5_z - t148 * k5;
        let t157 = c6 * t152 - s6 * t154;
        let a6_y = c6 * t154 + s6 * t152;
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
        let dw6_y = t169 - t178;
        let t182 = t176 - t175;
        let t183 = t146 + t182;
        let t184 = t177 - dw6_z;
        let t185 = dw6_z + t177;
        let t186 = t175 + t176;
        let t187 = dw6_y - t178;
        let t188 = t179 + dw6_x;
        put(248, a6_y); // row 6, MSX6
        put(249, t157); // row 6, MSY6
        put(251, t177); // row 6, YY6
        put(252, dw6_z); // row 6, ZZ6
        put(254, t172); // row 6, XZ6
        put(255, t169); // row 6, YZ6
        [
        t153, t157, a6_y, w6_x, w6_y, t169, t172, w6_z,
        dw6_z, t177, t178, t179, dw6_x, dw6_y, t182, t183,
        t184, t185, t186, t187, t188,
    ]
    };
    // link 7: motion
    let [
        a7_z, t197, a7_y, t209, t212, dw7_z, t217, t218,
        t219, t220, t221, t222, t223, t224, t225, t226,
        t227, t228,
    ] = {
        let t192 = t157 + t184 * k6;
        let a7_z = a6_y + t186 * k6;
        let t194 = t188 * k6 - t153;
        let t197 = c7 * t192 - s7 * t194;
        let a7_y = c7 * t194 + s7 * t192;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t206 = c7 * w6_z + s7 * w6_x;
        let t209 = c7 * t184 - s7 * t188;
        let t212 = c7 * t188 + s7 * t184;
        let w7_z = w6_y + dq7;
        let dw7_z = dw6_y + ddq7;
        let t215 = w7_x * w7_x;
        let t216 = w7_z * w7_z;
        let t217 = w7_x * t206;
        let t218 = w7_x * w7_z;
        let t219 = t206 * w7_z;
        let t220 = t219 - t212;
        let t221 = t218 - t209;
        let t222 = t215 - t216;
        let t223 = t222 - t186;
        let t224 = dw7_z + t217;
        let t225 = t217 - dw7_z;
        let t226 = t215 + t216;
        let t227 = t218 + t221;
        let t228 = t219 + t220;
        put(269, a7_y); // row 7, MSX7
        put(270, t197); // row 7, MSY7
        put(271, t217); // row 7, XX7
        put(273, dw7_z); // row 7, ZZ7
        put(275, t212); // row 7, XZ7
        put(276, t209); // row 7, YZ7
        [
        a7_z, t197, a7_y, t209, t212, dw7_z, t217, t218,
        t219, t220, t221, t222, t223, t224, t225, t226,
        t227, t228,
    ]
    };
    // joint axes in frame 2
    let [t229, v1_2_y] = {
        let t229 = c2 * k1;
        let v1_2_y = s2 * k1;
        [t229, v1_2_y]
    };
    // joint axes in frame 3
    let [v1_3_x, v1_3_y, v2_3_x, v2_4_z] = {
        let t231 = s2 * k2;
        let v1_3_x = s3 * t231 - c3 * t229;
        let v1_3_y = c3 * t231 + s3 * t229;
        let v2_3_x = c3 * k2;
        let v2_4_z = s3 * k2;
        [v1_3_x, v1_3_y, v2_3_x, v2_4_z]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, t246, z2_4_y, t248, t249, t252, t255] = {
        let z1_4_x = c4 * z1_3_x + c2 * s4;
        let z1_4_y = c2 * c4 - s4 * z1_3_x;
        let t246 = s3 * c4;
        let z2_4_y = s3 * s4;
        let t248 = c4 * v2_3_x;
        let t249 = s4 * v2_3_x;
        let t252 = c4 * v1_3_x + s4 * v1_2_y;
        let t255 = s4 * v1_3_x - c4 * v1_2_y;
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
    // MSZ2: column
    let [t272, t273] = {
        let t272 = s2 * t2 - c2 * t1;
        let t273 = k1 * t272;
        [t272, t273]
    };
    // XX2: column
    let [t275, t276] = {
        let t275 = c2 * t16;
        let t276 = s2 * dw2_x + t275;
        put(5, t276); // row 1, XX2
        [t275, t276]
    };
    // YY2: column
    let [t277, t280] = {
        let t277 = s2 * t17;
        let t279 = c2 * dw2_y - t277;
        let t280 = t276 + t279;
        let t282 = t280 * k7 - t273;
        put(1, t282); // row 1, M2
        put(6, t279); // row 1, YY2
        [t277, t280]
    };
    // XZ2: column
    {
        let t285 = s2 * t23 + c2 * t20;
        let t286 = k1 * t285;
        let t288 = k1 * t11 - t2;
        put(2, t286); // row 1, MSX2
        put(9, t285); // row 1, XZ2
        put(64, t288); // row 2, MSX2
    }
    // YZ2: column
    {
        let t292 = s2 * (t0 - t24) - c2 * t22;
        let t293 = k1 * t292;
        let t295 = t1 + k1 * t12;
        put(3, t293); // row 1, MSY2
        put(10, t292); // row 1, YZ2
        put(65, t295); // row 2, MSY2
    }
    // YY2: column
    {
        let t297 = t272 - t280 * k8;
        put(4, t297); // row 1, MSZ2
    }
    // ZZ2: column
    {
        let t298 = t277 - t275;
        put(7, t298); // row 1, ZZ2
    }
    // XY2: column
    {
        let t299 = t24 - t21;
        let t302 = s2 * t25 + c2 * t26;
        put(8, t302); // row 1, XY2
        put(69, t299); // row 2, XY2
    }
    // M3: column
    let t310 = {
        let t307 = a3_z * v1_2_y - (t37 * v1_3_x - a3_y * v1_3_y);
        let t310 = t37 * v2_3_x + a3_y * v2_4_z;
        put(11, t307); // row 1, M3
        t310
    };
    // MSX3: column
    {
        let t318 = t67 * v1_2_y + (t63 * v1_3_x - t65 * v1_3_y);
        let t319 = z1_4_z * a3_z + c2 * a3_y + t318;
        let t324 = c3 * a3_z + (t63 * v2_3_x + t65 * v2_4_z);
        put(12, t319); // row 1, MSX3
        put(73, t324); // row 2, MSX3
    }
    // MSY3: column
    let [t329, t336] = {
        let t329 = t66 * v1_3_y;
        let t333 = z1_3_x * a3_z + c2 * t37 - (t68 * v1_2_y + (t64 * v1_3_x + t329));
        let t336 = t66 * v2_4_z;
        let t338 = t336 - t64 * v2_3_x - s3 * a3_z;
        put(13, t333); // row 1, MSY3
        put(74, t338); // row 2, MSY3
        [t329, t336]
    };
    // MSZ3: column
    {
        let t346 = t49 * v1_3_x - t52 * v1_3_y - t24 * v1_2_y;
        let t347 = z1_4_z * t37 - z1_3_x * a3_y + t346;
        let t354 = s3 * a3_y + c3 * t37 + (t49 * v2_3_x + t52 * v2_4_z);
        put(14, t347); // row 1, MSZ3
        put(75, t354); // row 2, MSZ3
    }
    // XX3: column
    let [t356, t357, t361] = {
        let t356 = z1_4_z * t58;
        let t357 = c2 * t57;
        let t359 = t357 - (z1_3_x * t60 + t356);
        let t361 = c3 * t58;
        let t362 = s3 * t60 - t361;
        put(15, t359); // row 1, XX3
        put(76, t362); // row 2, XX3
        [t356, t357, t361]
    };
    // YY3: column
    let [t363, t367] = {
        let t363 = z1_3_x * t59;
        let t366 = t363 + z1_4_z * t61 - t357;
        let t367 = s3 * t59;
        let t369 = c3 * t61 - t367;
        put(16, t366); // row 1, YY3
        put(77, t369); // row 2, YY3
        [t363, t367]
    };
    // ZZ3: column
    {
        let t372 = c2 * dw3_z + (t356 - t363);
        let t373 = t361 + t367;
        put(17, t372); // row 1, ZZ3
        put(78, t373); // row 2, ZZ3
    }
    // XY3: column
    {
        let t374 = t63 + t66;
        let t379 = c2 * t374 + (z1_4_z * t68 - z1_3_x * t67);
        let t382 = s3 * t67 + c3 * t68;
        put(18, t379); // row 1, XY3
        put(79, t382); // row 2, XY3
        put(130, t374); // row 3, XY3
    }
    // XZ3: column
    {
        let t387 = c2 * t52 - (z1_3_x * t65 - z1_4_z * t62);
        let t390 = s3 * t65 + c3 * t62;
        put(19, t387); // row 1, XZ3
        put(80, t390); // row 2, XZ3
    }
    // YZ3: column
    {
        let t391 = t66 - t24;
        let t396 = c2 * t49 - (z1_3_x * t391 + z1_4_z * t64);
        let t399 = s3 * t391 - c3 * t64;
        put(20, t396); // row 1, YZ3
        put(81, t399); // row 2, YZ3
    }
    // M4: column
    let [t402, t405] = {
        let t402 = c4 * t77 + s4 * a4_y;
        let t405 = c4 * a4_y - s4 * t77;
        let t406 = k3 * t405;
        let t407 = k3 * t402;
        let t415 = v1_2_y * t405 - (v1_3_x * t402 + t73 * v1_3_y);
        let t416 = z1_3_x * t406 + c2 * t407 + t415;
        let t421 = t73 * v2_4_z - v2_3_x * t402 - s3 * t406;
        put(21, t416); // row 1, M4
        put(82, t421); // row 2, M4
        put(133, t407); // row 3, M4
        [t402, t405]
    };
    // MSX4: column
    let [t423, t428, t429] = {
        let t423 = s4 * t105;
        let t424 = c4 * t103 + t423;
        let t427 = c4 * t105 - s4 * t103;
        let t428 = s4 * t73;
        let t429 = c4 * t73;
        let t432 = t428 + k3 * t427;
        let t433 = k3 * t424 - t429;
        let t443 = v1_2_y * t427 - (v1_3_x * t424 + t107 * v1_3_y);
        let t444 = c2 * t433 + (z1_3_x * t432 + z1_4_z * a4_y) + t443;
        let t451 = c3 * a4_y - s3 * t432 - (v2_3_x * t424 - t107 * v2_4_z);
        put(22, t444); // row 1, MSX4
        put(83, t451); // row 2, MSX4
        put(134, t433); // row 3, MSX4
        [t423, t428, t429]
    };
    // MSY4: column
    let t452 = {
        let t452 = c4 * t104;
        let t454 = t452 + s4 * t106;
        let t457 = s4 * t104 - c4 * t106;
        let t460 = t429 + k3 * t457;
        let t461 = t428 - k3 * t454;
        let t471 = v1_2_y * t457 - (t108 * v1_3_y - v1_3_x * t454);
        let t472 = c2 * t461 + (z1_3_x * t460 + z1_4_z * t77) + t471;
        let t479 = c3 * t77 - s3 * t460 + (v2_3_x * t454 + t108 * v2_4_z);
        put(23, t472); // row 1, MSY4
        put(84, t479); // row 2, MSY4
        put(135, t461); // row 3, MSY4
        t452
    };
    // MSZ4: column
    let t489 = {
        let t482 = c4 * t89 + s4 * t92;
        let t485 = s4 * t89 - c4 * t92;
        let t488 = k3 * t485 - t405;
        let t489 = t402 + k3 * t482;
        let t497 = z1_3_x * t488 - c2 * t489 + (v1_2_y * t485 + (t329 + v1_3_x * t482));
        let t501 = v2_3_x * t482 - t336 - s3 * t488;
        put(24, t497); // row 1, MSZ4
        put(85, t501); // row 2, MSZ4
        t489
    };
    // XX4: column
    let [t503, t504, t508, t509, t513] = {
        let t503 = t98 * z1_4_y;
        let t504 = z1_4_z * t97;
        let t506 = dw4_x * z1_4_x + t503 - t504;
        let t508 = t98 * z2_4_y;
        let t509 = c3 * t97;
        let t511 = t508 - dw4_x * t246 - t509;
        let t513 = c4 * t98;
        let t514 = s4 * dw4_x + t513;
        put(25, t506); // row 1, XX4
        put(86, t511); // row 2, XX4
        put(137, t514); // row 3, XX4
        [t503, t504, t508, t509, t513]
    };
    // YY4: column
    let [t515, t519, t523] = {
        let t515 = t99 * z1_4_x;
        let t518 = t504 + (dw4_y * z1_4_y - t515);
        let t519 = t99 * t246;
        let t522 = t509 + (t519 + dw4_y * z2_4_y);
        let t523 = s4 * t99;
        let t525 = c4 * dw4_y - t523;
        put(26, t518); // row 1, YY4
        put(87, t522); // row 2, YY4
        put(138, t525); // row 3, YY4
        [t515, t519, t523]
    };
    // ZZ4: column
    {
        let t528 = z1_4_z * dw4_z - (t503 - t515);
        let t531 = c3 * dw4_z - (t508 + t519);
        let t532 = t523 - t513;
        put(27, t528); // row 1, ZZ4
        put(88, t531); // row 2, ZZ4
        put(139, t532); // row 3, ZZ4
    }
    // XY4: column
    {
        let t533 = t106 - t103;
        let t538 = z1_4_z * t533 - (t107 * z1_4_x - t108 * z1_4_y);
        let t543 = c3 * t533 + (t107 * t246 + t108 * z2_4_y);
        let t546 = c4 * t108 - s4 * t107;
        put(28, t538); // row 1, XY4
        put(89, t543); // row 2, XY4
        put(140, t546); // row 3, XY4
        put(181, t533); // row 4, XY4
    }
    // XZ4: column
    {
        let t551 = z1_4_z * t92 + (t105 * z1_4_x + t102 * z1_4_y);
        let t556 = c3 * t92 - (t105 * t246 - t102 * z2_4_y);
        let t558 = t423 + c4 * t102;
        put(29, t551); // row 1, XZ4
        put(90, t556); // row 2, XZ4
        put(141, t558); // row 3, XZ4
    }
    // YZ4: column
    {
        let t559 = t66 - t106;
        let t564 = z1_4_z * t89 - (t104 * z1_4_y - z1_4_x * t559);
        let t569 = c3 * t89 - (t246 * t559 + t104 * z2_4_y);
        let t571 = s4 * t559 - t452;
        put(30, t564); // row 1, YZ4
        put(91, t569); // row 2, YZ4
        put(142, t571); // row 3, YZ4
    }
    // M5: column
    let [t574, t577, t579] = {
        let t574 = c5 * t117 + s5 * a5_y;
        let t577 = s5 * t117 - c5 * a5_y;
        let t579 = k4 * t574;
        let t581 = k3 * t574;
        let t582 = k4 * t577 - k3 * a5_z;
        let t592 = v1_3_y * t577 + (t252 * t574 + a5_z * t255);
        let t593 = z1_4_y * t581 - z1_4_x * t582 - z1_4_z * t579 - t592;
        let t598 = c3 * t579 - (t246 * t582 + z2_4_y * t581);
        let t604 = v2_4_z * t577 - (t248 * t574 + a5_z * t249) - t598;
        let t607 = c4 * t581 - s4 * t582;
        put(31, t593); // row 1, M5
        put(92, t604); // row 2, M5
        put(143, t607); // row 3, M5
        [t574, t577, t579]
    };
    // MSX5: column
    let [t609, t614, t615] = {
        let t609 = s5 * t145;
        let t610 = c5 * t143 + t609;
        let t613 = s5 * t143 - c5 * t145;
        let t614 = s5 * a5_z;
        let t615 = c5 * a5_z;
        let t619 = t615 + k4 * t610;
        let t622 = t614 + k4 * t613 + k3 * t147;
        let t623 = a5_y - k3 * t610;
        let t633 = v1_3_y * t613 + (t252 * t610 - t147 * t255);
        let t634 = z1_4_z * t619 + (z1_4_x * t622 + z1_4_y * t623) + t633;
        let t644 = t248 * t610 - t147 * t249 - v2_4_z * t613;
        let t645 = c3 * t619 + (z2_4_y * t623 - t246 * t622) + t644;
        let t648 = s4 * t622 + c4 * t623;
        put(32, t634); // row 1, MSX5
        put(93, t645); // row 2, MSX5
        put(144, t648); // row 3, MSX5
        put(185, t619); // row 4, MSX5
        [t609, t614, t615]
    };
    // MSY5: column
    let [t649, t650, t653] = {
        let t649 = c5 * t144;
        let t650 = s5 * t146;
        let t651 = t650 - t649;
        let t653 = c5 * t146;
        let t654 = s5 * t144 + t653;
        let t658 = k4 * t651 - t614;
        let t661 = t615 - k4 * t654 - k3 * t148;
        let t662 = t117 - k3 * t651;
        let t672 = t252 * t651 + t148 * t255 - v1_3_y * t654;
        let t673 = z1_4_z * t658 + (z1_4_x * t661 + z1_4_y * t662) + t672;
        let t683 = v2_4_z * t654 + (t248 * t651 + t148 * t249);
        let t684 = c3 * t658 + (z2_4_y * t662 - t246 * t661) + t683;
        let t687 = s4 * t661 + c4 * t662;
        put(33, t673); // row 1, MSY5
        put(94, t684); // row 2, MSY5
        put(145, t687); // row 3, MSY5
        put(186, t658); // row 4, MSY5
        [t649, t650, t653]
    };
    // MSZ5: column
    {
        let t690 = c5 * t129 + s5 * t132;
        let t693 = s5 * t129 - c5 * t132;
        let t697 = t574 + k4 * t690;
        let t699 = k3 * t690;
        let t700 = t577 + k4 * t693 - k3 * t106;
        let t705 = z1_4_y * t699 - z1_4_x * t700 - z1_4_z * t697;
        let t711 = v1_3_y * t693 + (t252 * t690 + t106 * t255) - t705;
        let t721 = t248 * t690 + t106 * t249 - v2_4_z * t693;
        let t722 = c3 * t697 - (t246 * t700 + z2_4_y * t699) + t721;
        let t725 = s4 * t700 - c4 * t699;
        put(34, t711); // row 1, MSZ5
        put(95, t722); // row 2, MSZ5
        put(146, t725); // row 3, MSZ5
        put(187, t697); // row 4, MSZ5
    }
    // XX5: column
    let [t727, t728, t732, t733, t737, t738, t742] = {
        let t727 = t138 * z1_6_z;
        let t728 = t137 * z1_4_y;
        let t730 = t728 - (t727 - t140 * t258);
        let t732 = t138 * t267;
        let t733 = t137 * z2_4_y;
        let t735 = t733 + (t140 * t264 - t732);
        let t737 = t138 * z3_6_z;
        let t738 = c4 * t137;
        let t740 = t738 - (t140 * z3_5_x + t737);
        let t742 = c5 * t138;
        let t743 = s5 * t140 - t742;
        put(35, t730); // row 1, XX5
        put(96, t735); // row 2, XX5
        put(147, t740); // row 3, XX5
        put(188, t743); // row 4, XX5
        [t727, t728, t732, t733, t737, t738, t742]
    };
    // YY5: column
    let [t744, t748, t752, t756] = {
        let t744 = t139 * t258;
        let t747 = t141 * z1_6_z - t744 - t728;
        let t748 = t139 * t264;
        let t751 = t141 * t267 - t748 - t733;
        let t752 = t139 * z3_5_x;
        let t755 = t752 + t141 * z3_6_z - t738;
        let t756 = s5 * t139;
        let t758 = c5 * t141 - t756;
        put(36, t747); // row 1, YY5
        put(97, t751); // row 2, YY5
        put(148, t755); // row 3, YY5
        put(189, t758); // row 4, YY5
        [t744, t748, t752, t756]
    };
    // ZZ5: column
    {
        let t761 = dw5_z * z1_4_y + (t727 + t744);
        let t764 = dw5_z * z2_4_y + (t732 + t748);
        let t767 = c4 * dw5_z + (t737 - t752);
        let t768 = t742 + t756;
        put(37, t761); // row 1, ZZ5
        put(98, t764); // row 2, ZZ5
        put(149, t767); // row 3, ZZ5
        put(190, t768); // row 4, ZZ5
    }
    // XY5: column
    {
        let t769 = t143 + t146;
        let t774 = z1_4_y * t769 + (t147 * t258 + t148 * z1_6_z);
        let t779 = z2_4_y * t769 + (t147 * t264 + t148 * t267);
        let t784 = c4 * t769 - (t147 * z3_5_x - t148 * z3_6_z);
        let t787 = s5 * t147 + c5 * t148;
        put(38, t774); // row 1, XY5
        put(99, t779); // row 2, XY5
        put(150, t784); // row 3, XY5
        put(191, t787); // row 4, XY5
        put(222, t769); // row 5, XY5
    }
    // XZ5: column
    {
        let t792 = t132 * z1_4_y + (t145 * t258 + t142 * z1_6_z);
        let t797 = t132 * z2_4_y + (t145 * t264 + t142 * t267);
        let t802 = c4 * t132 - (t145 * z3_5_x - t142 * z3_6_z);
        let t804 = t609 + c5 * t142;
        put(39, t792); // row 1, XZ5
        put(100, t797); // row 2, XZ5
        put(151, t802); // row 3, XZ5
        put(192, t804); // row 4, XZ5
    }
    // YZ5: column
    {
        let t805 = t146 - t106;
        let t810 = t129 * z1_4_y + (t258 * t805 - t144 * z1_6_z);
        let t815 = t129 * z2_4_y + (t264 * t805 - t144 * t267);
        let t820 = c4 * t129 - (z3_5_x * t805 + t144 * z3_6_z);
        let t822 = s5 * t805 - t649;
        put(40, t810); // row 1, YZ5
        put(101, t815); // row 2, YZ5
        put(152, t820); // row 3, YZ5
        put(193, t822); // row 4, YZ5
    }
    // M6: column
    let [t825, t828] = {
        let t825 = c6 * t157 + s6 * a6_y;
        let t828 = s6 * t157 - c6 * a6_y;
        let t829 = k5 * t828;
        let t830 = k5 * t825;
        let t833 = c5 * t825 - s5 * t153;
        let t836 = s5 * t825 + c5 * t153;
        let t842 = s5 * t829 - k4 * t833;
        let t845 = c5 * t829 + k4 * t836 + k3 * t828;
        let t846 = t830 + k3 * t833;
        let t856 = t255 * t828 - t252 * t833 - v1_3_y * t836;
        let t857 = z1_4_z * t842 + (z1_4_y * t846 - z1_4_x * t845) + t856;
        let t867 = v2_4_z * t836 + (t249 * t828 - t248 * t833);
        let t868 = c3 * t842 + (t246 * t845 + z2_4_y * t846) + t867;
        let t871 = c4 * t846 - s4 * t845;
        put(41, t857); // row 1, M6
        put(102, t868); // row 2, M6
        put(153, t871); // row 3, M6
        put(194, t842); // row 4, M6
        put(225, t830); // row 5, M6
        [t825, t828]
    };
    // MSX6: column
    let [t873, t876, t878, t879] = {
        let t873 = s6 * t185;
        let t874 = c6 * t183 + t873;
        let t876 = c6 * t185;
        let t877 = t876 - s6 * t183;
        let t878 = s6 * t153;
        let t879 = c6 * t153;
        let t882 = t878 + k5 * t877;
        let t883 = k5 * t874 - t879;
        let t886 = c5 * t874 + s5 * t187;
        let t889 = s5 * t874 - c5 * t187;
        let t899 = c5 * a6_y - s5 * t882 - k4 * t886;
        let t902 = c5 * t882 + s5 * a6_y - k4 * t889 + k3 * t877;
        let t903 = t883 + k3 * t886;
        let t913 = v1_3_y * t889 + (t252 * t886 + t255 * t877);
        let t914 = z1_4_z * t899 + (z1_4_x * t902 + z1_4_y * t903) - t913;
        let t924 = v2_4_z * t889 - (t248 * t886 + t249 * t877);
        let t925 = c3 * t899 + (z2_4_y * t903 - t246 * t902) + t924;
        let t928 = s4 * t902 + c4 * t903;
        put(42, t914); // row 1, MSX6
        put(103, t925); // row 2, MSX6
        put(154, t928); // row 3, MSX6
        put(195, t899); // row 4, MSX6
        put(226, t883); // row 5, MSX6
        [t873, t876, t878, t879]
    };
    // MSY6: column
    let [t929, t930, t932, t933] = {
        let t929 = c6 * t184;
        let t930 = s6 * t186;
        let t931 = t929 + t930;
        let t932 = s6 * t184;
        let t933 = c6 * t186;
        let t934 = t932 - t933;
        let t937 = t879 + k5 * t934;
        let t938 = t878 - k5 * t931;
        let t941 = c5 * t931 + s5 * t188;
        let t944 = s5 * t931 - c5 * t188;
        let t954 = c5 * t157 - s5 * t937 + k4 * t941;
        let t957 = c5 * t937 + s5 * t157 + k4 * t944 + k3 * t934;
        let t958 = k3 * t941 - t938;
        let t963 = z1_4_y * t958 - z1_4_x * t957 - z1_4_z * t954;
        let t969 = v1_3_y * t944 + (t252 * t941 - t255 * t934) - t963;
        let t979 = v2_4_z * t944 + (t249 * t934 - t248 * t941);
        let t980 = c3 * t954 - (t246 * t957 + z2_4_y * t958) - t979;
        let t983 = s4 * t957 - c4 * t958;
        put(43, t969); // row 1, MSY6
        put(104, t980); // row 2, MSY6
        put(155, t983); // row 3, MSY6
        put(196, t954); // row 4, MSY6
        put(227, t938); // row 5, MSY6
        [t929, t930, t932, t933]
    };
    // MSZ6: column
    let t993 = {
        let t986 = c6 * t169 + s6 * t172;
        let t989 = s6 * t169 - c6 * t172;
        let t992 = t828 + k5 * t989;
        let t993 = t825 + k5 * t986;
        let t995 = c5 * t986 - t650;
        let t997 = t653 + s5 * t986;
        let t1003 = k4 * t995 - s5 * t992;
        let t1006 = c5 * t992 + k4 * t997 + k3 * t989;
        let t1007 = t993 + k3 * t995;
        let t1017 = v1_3_y * t997 + (t252 * t995 - t255 * t989);
        let t1018 = z1_4_z * t1003 + (z1_4_x * t1006 - z1_4_y * t1007) + t1017;
        let t1028 = v2_4_z * t997 + (t249 * t989 - t248 * t995);
        let t1029 = c3 * t1003 - (t246 * t1006 + z2_4_y * t1007) - t1028;
        let t1032 = s4 * t1006 - c4 * t1007;
        put(44, t1018); // row 1, MSZ6
        put(105, t1029); // row 2, MSZ6
        put(156, t1032); // row 3, MSZ6
        put(197, t1003); // row 4, MSZ6
        t993
    };
    // XX6: column
    let [t1034, t1037, t1040, t1045, t1050, t1055] = {
        let t1034 = s6 * t178;
        let t1035 = t1034 - c6 * dw6_x;
        let t1037 = c6 * t178;
        let t1038 = s6 * dw6_x + t1037;
        let t1040 = t177 * z1_6_z;
        let t1043 = z1_4_y * t1038 + (t258 * t1035 - t1040);
        let t1045 = t177 * t267;
        let t1048 = z2_4_y * t1038 - (t1045 - t264 * t1035);
        let t1050 = t177 * z3_6_z;
        let t1053 = c4 * t1038 - (z3_5_x * t1035 + t1050);
        let t1055 = c5 * t177;
        let t1056 = s5 * t1035 - t1055;
        put(45, t1043); // row 1, XX6
        put(106, t1048); // row 2, XX6
        put(157, t1053); // row 3, XX6
        put(198, t1056); // row 4, XX6
        put(229, t1038); // row 5, XX6
        [t1034, t1037, t1040, t1045, t1050, t1055]
    };
    // YY6: column
    let [t1057, t1060] = {
        let t1057 = c6 * t179;
        let t1059 = t1057 + s6 * dw6_y;
        let t1060 = s6 * t179;
        let t1062 = c6 * dw6_y - t1060;
        let t1066 = z1_4_y * t1062 + (t1040 + t258 * t1059);
        let t1070 = z2_4_y * t1062 + (t1045 + t264 * t1059);
        let t1074 = c4 * t1062 + (t1050 - z3_5_x * t1059);
        let t1076 = t1055 + s5 * t1059;
        put(46, t1066); // row 1, YY6
        put(107, t1070); // row 2, YY6
        put(158, t1074); // row 3, YY6
        put(199, t1076); // row 4, YY6
        put(230, t1062); // row 5, YY6
        [t1057, t1060]
    };
    // ZZ6: column
    {
        let t1077 = t1034 + t1057;
        let t1078 = t1060 - t1037;
        let t1083 = z1_4_y * t1078 + (dw6_z * z1_6_z - t258 * t1077);
        let t1088 = z2_4_y * t1078 - (t264 * t1077 - dw6_z * t267);
        let t1093 = c4 * t1078 + (z3_5_x * t1077 + dw6_z * z3_6_z);
        let t1096 = c5 * dw6_z - s5 * t1077;
        put(47, t1083); // row 1, ZZ6
        put(108, t1088); // row 2, ZZ6
        put(159, t1093); // row 3, ZZ6
        put(200, t1096); // row 4, ZZ6
        put(231, t1078); // row 5, ZZ6
    }
    // XY6: column
    {
        let t1097 = t186 - t183;
        let t1100 = s6 * t188 - c6 * t187;
        let t1103 = s6 * t187 + c6 * t188;
        let t1108 = z1_4_y * t1103 + (t258 * t1100 + z1_6_z * t1097);
        let t1113 = z2_4_y * t1103 + (t264 * t1100 + t267 * t1097);
        let t1118 = c4 * t1103 - (z3_5_x * t1100 - z3_6_z * t1097);
        let t1121 = s5 * t1100 + c5 * t1097;
        put(48, t1108); // row 1, XY6
        put(109, t1113); // row 2, XY6
        put(160, t1118); // row 3, XY6
        put(201, t1121); // row 4, XY6
        put(232, t1103); // row 5, XY6
        put(253, t1097); // row 6, XY6
    }
    // XZ6: column
    {
        let t1123 = t876 - s6 * t182;
        let t1125 = t873 + c6 * t182;
        let t1130 = z1_4_y * t1125 + (t172 * z1_6_z - t258 * t1123);
        let t1135 = z2_4_y * t1125 + (t172 * t267 - t264 * t1123);
        let t1140 = c4 * t1125 + (z3_5_x * t1123 + t172 * z3_6_z);
        let t1143 = c5 * t172 - s5 * t1123;
        put(49, t1130); // row 1, XZ6
        put(110, t1135); // row 2, XZ6
        put(161, t1140); // row 3, XZ6
        put(202, t1143); // row 4, XZ6
        put(233, t1125); // row 5, XZ6
    }
    // YZ6: column
    {
        let t1144 = t146 - t186;
        let t1146 = t932 + c6 * t1144;
        let t1148 = s6 * t1144 - t929;
        let t1153 = z1_4_y * t1148 - (t258 * t1146 - t169 * z1_6_z);
        let t1158 = z2_4_y * t1148 + (t169 * t267 - t264 * t1146);
        let t1163 = c4 * t1148 + (z3_5_x * t1146 + t169 * z3_6_z);
        let t1166 = c5 * t169 - s5 * t1146;
        put(50, t1153); // row 1, YZ6
        put(111, t1158); // row 2, YZ6
        put(162, t1163); // row 3, YZ6
        put(203, t1166); // row 4, YZ6
        put(234, t1148); // row 5, YZ6
    }
    // M7: column
    let [t1169, t1172, t1174] = {
        let t1169 = c7 * t197 + s7 * a7_y;
        let t1172 = s7 * t197 - c7 * a7_y;
        let t1173 = k6 * t1172;
        let t1174 = k6 * t1169;
        let t1177 = c6 * t1169 + s6 * a7_z;
        let t1180 = s6 * t1169 - c6 * a7_z;
        let t1185 = c6 * t1173 + k5 * t1180;
        let t1186 = k5 * t1177 - s6 * t1173;
        let t1189 = s5 * t1172 - c5 * t1177;
        let t1192 = s5 * t1177 + c5 * t1172;
        let t1202 = s5 * t1185 - c5 * t1174 + k4 * t1189;
        let t1205 = c5 * t1185 + s5 * t1174 + k4 * t1192 + k3 * t1180;
        let t1206 = t1186 - k3 * t1189;
        let t1216 = t252 * t1189 + t255 * t1180 - v1_3_y * t1192;
        let t1217 = z1_4_z * t1202 - (z1_4_x * t1205 - z1_4_y * t1206) + t1216;
        let t1227 = v2_4_z * t1192 + (t248 * t1189 + t249 * t1180);
        let t1228 = c3 * t1202 + (t246 * t1205 + z2_4_y * t1206) + t1227;
        let t1231 = c4 * t1206 - s4 * t1205;
        put(51, t1217); // row 1, M7
        put(112, t1228); // row 2, M7
        put(163, t1231); // row 3, M7
        put(204, t1202); // row 4, M7
        put(235, t1186); // row 5, M7
        [t1169, t1172, t1174]
    };
    // MSX7: column
    let [t1233, t1236, t1238, t1239] = {
        let t1233 = s7 * t225;
        let t1234 = c7 * t223 + t1233;
        let t1236 = c7 * t225;
        let t1237 = s7 * t223 - t1236;
        let t1238 = s7 * a7_z;
        let t1239 = c7 * a7_z;
        let t1242 = t1238 + k6 * t1237;
        let t1243 = t1239 + k6 * t1234;
        let t1246 = c6 * t1234 - s6 * t227;
        let t1249 = s6 * t1234 + c6 * t227;
        let t1258 = c6 * t1242 - s6 * a7_y + k5 * t1249;
        let t1259 = s6 * t1242 + c6 * a7_y - k5 * t1246;
        let t1262 = s5 * t1237 - c5 * t1246;
        let t1265 = s5 * t1246 + c5 * t1237;
        let t1275 = c5 * t1243 - s5 * t1258 - k4 * t1262;
        let t1278 = c5 * t1258 + s5 * t1243 + k4 * t1265 + k3 * t1249;
        let t1279 = t1259 + k3 * t1262;
        let t1289 = v1_3_y * t1265 - (t252 * t1262 + t255 * t1249);
        let t1290 = z1_4_z * t1275 + (z1_4_x * t1278 + z1_4_y * t1279) + t1289;
        let t1300 = v2_4_z * t1265 + (t248 * t1262 + t249 * t1249);
        let t1301 = c3 * t1275 - (t246 * t1278 - z2_4_y * t1279) - t1300;
        let t1304 = s4 * t1278 + c4 * t1279;
        put(52, t1290); // row 1, MSX7
        put(113, t1301); // row 2, MSX7
        put(164, t1304); // row 3, MSX7
        put(205, t1275); // row 4, MSX7
        put(236, t1259); // row 5, MSX7
        put(257, t1243); // row 6, MSX7
        [t1233, t1236, t1238, t1239]
    };
    // MSY7: column
    let [t1305, t1308] = {
        let t1305 = c7 * t224;
        let t1307 = s7 * t226 - t1305;
        let t1308 = s7 * t224;
        let t1310 = t1308 + c7 * t226;
        let t1313 = t1239 - k6 * t1310;
        let t1314 = k6 * t1307 - t1238;
        let t1317 = c6 * t1307 + s6 * t228;
        let t1320 = s6 * t1307 - c6 * t228;
        let t1329 = c6 * t1313 - s6 * t197 + k5 * t1320;
        let t1330 = s6 * t1313 + c6 * t197 - k5 * t1317;
        let t1333 = c5 * t1317 + s5 * t1310;
        let t1336 = s5 * t1317 - c5 * t1310;
        let t1346 = k4 * t1333 - (s5 * t1329 - c5 * t1314);
        let t1349 = c5 * t1329 + s5 * t1314 + k4 * t1336 + k3 * t1320;
        let t1350 = k3 * t1333 - t1330;
        let t1355 = z1_4_y * t1350 - z1_4_x * t1349 - z1_4_z * t1346;
        let t1361 = v1_3_y * t1336 + (t252 * t1333 - t255 * t1320) - t1355;
        let t1371 = v2_4_z * t1336 + (t249 * t1320 - t248 * t1333);
        let t1372 = c3 * t1346 - (t246 * t1349 + z2_4_y * t1350) - t1371;
        let t1375 = s4 * t1349 - c4 * t1350;
        put(53, t1361); // row 1, MSY7
        put(114, t1372); // row 2, MSY7
        put(165, t1375); // row 3, MSY7
        put(206, t1346); // row 4, MSY7
        put(237, t1330); // row 5, MSY7
        put(258, t1314); // row 6, MSY7
        [t1305, t1308]
    };
    // MSZ7: column
    {
        let t1378 = c7 * t209 + s7 * t212;
        let t1381 = c7 * t212 - s7 * t209;
        let t1384 = t1172 - k6 * t1381;
        let t1385 = t1169 + k6 * t1378;
        let t1387 = t930 + c6 * t1378;
        let t1389 = s6 * t1378 - t933;
        let t1394 = c6 * t1384 + k5 * t1389;
        let t1395 = s6 * t1384 - k5 * t1387;
        let t1398 = c5 * t1387 + s5 * t1381;
        let t1401 = s5 * t1387 - c5 * t1381;
        let t1411 = c5 * t1385 - s5 * t1394 + k4 * t1398;
        let t1414 = c5 * t1394 + s5 * t1385 + k4 * t1401 + k3 * t1389;
        let t1415 = k3 * t1398 - t1395;
        let t1425 = v1_3_y * t1401 + (t252 * t1398 - t255 * t1389);
        let t1426 = z1_4_z * t1411 + (z1_4_x * t1414 - z1_4_y * t1415) + t1425;
        let t1436 = v2_4_z * t1401 - (t248 * t1398 - t249 * t1389);
        let t1437 = c3 * t1411 - (t246 * t1414 + z2_4_y * t1415) - t1436;
        let t1440 = s4 * t1414 - c4 * t1415;
        put(54, t1426); // row 1, MSZ7
        put(115, t1437); // row 2, MSZ7
        put(166, t1440); // row 3, MSZ7
        put(207, t1411); // row 4, MSZ7
        put(238, t1395); // row 5, MSZ7
        put(259, t1385); // row 6, MSZ7
    }
    // XX7: column
    let [t1442, t1445, t1448, t1451] = {
        let t1442 = s7 * t218;
        let t1443 = c7 * t220 + t1442;
        let t1445 = c7 * t218;
        let t1446 = s7 * t220 - t1445;
        let t1448 = s6 * t217;
        let t1449 = c6 * t1443 + t1448;
        let t1451 = c6 * t217;
        let t1452 = t1451 - s6 * t1443;
        let t1457 = z1_4_y * t1452 + (t258 * t1449 + z1_6_z * t1446);
        let t1462 = z2_4_y * t1452 + (t264 * t1449 + t267 * t1446);
        let t1467 = c4 * t1452 + (z3_6_z * t1446 - z3_5_x * t1449);
        let t1470 = s5 * t1449 + c5 * t1446;
        put(55, t1457); // row 1, XX7
        put(116, t1462); // row 2, XX7
        put(167, t1467); // row 3, XX7
        put(208, t1470); // row 4, XX7
        put(239, t1452); // row 5, XX7
        put(260, t1446); // row 6, XX7
        [t1442, t1445, t1448, t1451]
    };
    // YY7: column
    let [t1471, t1474] = {
        let t1471 = c7 * t219;
        let t1473 = t1471 + s7 * t221;
        let t1474 = s7 * t219;
        let t1476 = c7 * t221 - t1474;
        let t1478 = t1448 + c6 * t1473;
        let t1480 = s6 * t1473 - t1451;
        let t1485 = z1_4_y * t1480 - (t258 * t1478 - z1_6_z * t1476);
        let t1490 = z2_4_y * t1480 + (t267 * t1476 - t264 * t1478);
        let t1495 = c4 * t1480 + (z3_5_x * t1478 + z3_6_z * t1476);
        let t1498 = c5 * t1476 - s5 * t1478;
        put(56, t1485); // row 1, YY7
        put(117, t1490); // row 2, YY7
        put(168, t1495); // row 3, YY7
        put(209, t1498); // row 4, YY7
        put(240, t1480); // row 5, YY7
        put(261, t1476); // row 6, YY7
        [t1471, t1474]
    };
    // ZZ7: column
    {
        let t1499 = t1442 - t1471;
        let t1500 = t1445 + t1474;
        let t1503 = c6 * t1499 - s6 * dw7_z;
        let t1506 = s6 * t1499 + c6 * dw7_z;
        let t1511 = z1_4_y * t1506 + (z1_6_z * t1500 - t258 * t1503);
        let t1516 = z2_4_y * t1506 - (t264 * t1503 - t267 * t1500);
        let t1521 = c4 * t1506 + (z3_5_x * t1503 + z3_6_z * t1500);
        let t1524 = c5 * t1500 - s5 * t1503;
        put(57, t1511); // row 1, ZZ7
        put(118, t1516); // row 2, ZZ7
        put(169, t1521); // row 3, ZZ7
        put(210, t1524); // row 4, ZZ7
        put(241, t1506); // row 5, ZZ7
        put(262, t1500); // row 6, ZZ7
    }
    // XY7: column
    {
        let t1525 = t223 + t226;
        let t1528 = s7 * t228 - c7 * t227;
        let t1531 = s7 * t227 + c7 * t228;
        let t1534 = c6 * t1528 - s6 * t1525;
        let t1537 = s6 * t1528 + c6 * t1525;
        let t1542 = z1_4_y * t1537 + (z1_6_z * t1531 - t258 * t1534);
        let t1547 = z2_4_y * t1537 - (t264 * t1534 - t267 * t1531);
        let t1552 = c4 * t1537 + (z3_5_x * t1534 + z3_6_z * t1531);
        let t1555 = c5 * t1531 - s5 * t1534;
        put(58, t1542); // row 1, XY7
        put(119, t1547); // row 2, XY7
        put(170, t1552); // row 3, XY7
        put(211, t1555); // row 4, XY7
        put(242, t1537); // row 5, XY7
        put(263, t1531); // row 6, XY7
        put(274, t1525); // row 7, XY7
    }
    // XZ7: column
    {
        let t1557 = s7 * t222 - t1236;
        let t1559 = t1233 + c7 * t222;
        let t1562 = s6 * t212 - c6 * t1557;
        let t1565 = s6 * t1557 + c6 * t212;
        let t1570 = z1_4_y * t1565 + (t258 * t1562 + z1_6_z * t1559);
        let t1575 = z2_4_y * t1565 + (t264 * t1562 + t267 * t1559);
        let t1580 = c4 * t1565 - (z3_5_x * t1562 - z3_6_z * t1559);
        let t1583 = s5 * t1562 + c5 * t1559;
        put(59, t1570); // row 1, XZ7
        put(120, t1575); // row 2, XZ7
        put(171, t1580); // row 3, XZ7
        put(212, t1583); // row 4, XZ7
        put(243, t1565); // row 5, XZ7
        put(264, t1559); // row 6, XZ7
    }
    // YZ7: column
    {
        let t1584 = t226 - t186;
        let t1586 = t1308 + c7 * t1584;
        let t1588 = s7 * t1584 - t1305;
        let t1591 = c6 * t1586 + s6 * t209;
        let t1594 = c6 * t209 - s6 * t1586;
        let t1599 = z1_4_y * t1594 + (t258 * t1591 + z1_6_z * t1588);
        let t1604 = z2_4_y * t1594 + (t264 * t1591 + t267 * t1588);
        let t1609 = c4 * t1594 + (z3_6_z * t1588 - z3_5_x * t1591);
        let t1612 = s5 * t1591 + c5 * t1588;
        let t1613 = dq1.sign();
        let t1614 = dq2.sign();
        let t1615 = dq3.sign();
        let t1616 = dq4.sign();
        let t1617 = dq5.sign();
        let t1618 = dq6.sign();
        let t1619 = dq7.sign();
        let t1620 = -t15;
        let t1621 = -t310;
        let t1622 = -t57;
        let t1623 = -t489;
        let t1624 = -t97;
        let t1625 = -t579;
        let t1626 = -t137;
        let t1627 = -t993;
        let t1628 = -t177;
        let t1629 = -t1174;
        let t1630 = -t217;
        put(60, t1599); // row 1, YZ7
        put(62, t1613); // row 1, FC1
        put(66, t1620); // row 2, XX2
        put(72, t1621); // row 2, M3
        put(121, t1604); // row 2, YZ7
        put(123, t1614); // row 2, FC2
        put(128, t1622); // row 3, YY3
        put(136, t1623); // row 3, MSZ4
        put(172, t1609); // row 3, YZ7
        put(174, t1615); // row 3, FC3
        put(178, t1624); // row 4, XX4
        put(184, t1625); // row 4, M5
        put(213, t1612); // row 4, YZ7
        put(215, t1616); // row 4, FC4
        put(220, t1626); // row 5, YY5
        put(228, t1627); // row 5, MSZ6
        put(244, t1594); // row 5, YZ7
        put(246, t1617); // row 5, FC5
        put(250, t1628); // row 6, XX6
        put(256, t1629); // row 6, M7
        put(265, t1588); // row 6, YZ7
        put(267, t1618); // row 6, FC6
        put(272, t1630); // row 7, YY7
        put(278, t1619); // row 7, FC7
    }
}
