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
    out.as_flattened_mut().fill(S::default());
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
        w2_x, w2_y, t3, t4, t5, t6, a2_z, t10,
        t12, t15, t16, t17, dw2_x, dw2_y, t20, t21,
        t22, t23, t24, t25, t26,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t3 = s2 * ddq1;
        let t4 = c2 * ddq1;
        let t5 = s2 * k0;
        let t6 = c2 * k0;
        let t7 = ddq1 * k1;
        let a2_z = t0 * k1;
        let t10 = t5 + c2 * t7;
        let t12 = t6 - s2 * t7;
        let t13 = w2_x * w2_x;
        let t14 = dq2 * dq2;
        let t15 = w2_x * w2_y;
        let t16 = dq2 * w2_x;
        let t17 = dq2 * w2_y;
        let dw2_x = t3 + t17;
        let dw2_y = t4 - t16;
        let t20 = t14 - t13;
        let t21 = t0 + t20;
        let t22 = t15 - ddq2;
        let t23 = ddq2 + t15;
        let t24 = t13 + t14;
        let t25 = dw2_y - t16;
        let t26 = t17 + dw2_x;
        put(67, t15); // row 2, YY2
        put(70, t3); // row 2, XZ2
        put(71, t4); // row 2, YZ2
        [
        w2_x, w2_y, t3, t4, t5, t6, a2_z, t10,
        t12, t15, t16, t17, dw2_x, dw2_y, t20, t21,
        t22, t23, t24, t25, t26,
    ]
    };
    // link 3: motion
    let [
        w3_x, t32, a3_z, t41, a3_y, t47, t50, w3_z,
        dw3_z, t55, t56, t57, t58, t59, t60, t61,
        t62, t63, t64, t65, t66,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t32 = c3 * dq2 + s3 * w2_x;
        let t36 = t10 + t22 * k2;
        let a3_z = t24 * k2 - t12;
        let t38 = t26 * k2 - a2_z;
        let t41 = c3 * t36 - s3 * t38;
        let a3_y = c3 * t38 + s3 * t36;
        let t47 = c3 * t22 - s3 * t26;
        let t50 = c3 * t26 + s3 * t22;
        let w3_z = w2_y + dq3;
        let dw3_z = dw2_y + ddq3;
        let t53 = w3_x * w3_x;
        let t54 = w3_z * w3_z;
        let t55 = w3_x * t32;
        let t56 = w3_x * w3_z;
        let t57 = t32 * w3_z;
        let t58 = t57 - t50;
        let t59 = t56 - t47;
        let t60 = t53 - t54;
        let t61 = t60 - t24;
        let t62 = dw3_z + t55;
        let t63 = t55 - dw3_z;
        let t64 = t53 + t54;
        let t65 = t56 + t59;
        let t66 = t57 + t58;
        put(125, a3_y); // row 3, MSX3
        put(126, t41); // row 3, MSY3
        put(127, t55); // row 3, XX3
        put(129, dw3_z); // row 3, ZZ3
        put(131, t50); // row 3, XZ3
        put(132, t47); // row 3, YZ3
        [
        w3_x, t32, a3_z, t41, a3_y, t47, t50, w3_z,
        dw3_z, t55, t56, t57, t58, t59, t60, t61,
        t62, t63, t64, t65, t66,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t77, t81, a4_y, t87, t90, w4_z,
        dw4_z, t95, t96, t97, dw4_x, dw4_y, t100, t101,
        t102, t103, t104, t105, t106,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t76 = t41 + t62 * k3;
        let t77 = t64 * k3 - a3_y;
        let t78 = a3_z - t66 * k3;
        let t81 = c4 * t76 - s4 * t78;
        let a4_y = c4 * t78 + s4 * t76;
        let t87 = c4 * t62 + s4 * t66;
        let t90 = s4 * t62 - c4 * t66;
        let w4_z = t32 + dq4;
        let dw4_z = t59 + ddq4;
        let t93 = w4_x * w4_x;
        let t94 = w4_z * w4_z;
        let t95 = w4_x * w4_y;
        let t96 = w4_x * w4_z;
        let t97 = w4_y * w4_z;
        let dw4_x = t90 + t97;
        let dw4_y = t87 - t96;
        let t100 = t94 - t93;
        let t101 = t64 + t100;
        let t102 = t95 - dw4_z;
        let t103 = dw4_z + t95;
        let t104 = t93 + t94;
        let t105 = t96 - dw4_y;
        let t106 = t97 + dw4_x;
        put(176, a4_y); // row 4, MSX4
        put(177, t81); // row 4, MSY4
        put(179, t95); // row 4, YY4
        put(180, dw4_z); // row 4, ZZ4
        put(182, t90); // row 4, XZ4
        put(183, t87); // row 4, YZ4
        [
        w4_x, w4_y, t77, t81, a4_y, t87, t90, w4_z,
        dw4_z, t95, t96, t97, dw4_x, dw4_y, t100, t101,
        t102, t103, t104, t105, t106,
    ]
    };
    // link 5: motion
    let [
        w5_x, t112, a5_z, t121, a5_y, t127, t130, w5_z,
        dw5_z, t135, t136, t137, t138, t139, t140, t141,
        t142, t143, t144, t145, t146,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t112 = c5 * w4_z + s5 * w4_x;
        let t116 = t81 + t102 * k4;
        let a5_z = a4_y + t104 * k4;
        let t118 = t77 - t106 * k4;
        let t121 = c5 * t116 + s5 * t118;
        let a5_y = s5 * t116 - c5 * t118;
        let t127 = c5 * t102 - s5 * t106;
        let t130 = c5 * t106 + s5 * t102;
        let w5_z = w4_y + dq5;
        let dw5_z = dw4_y + ddq5;
        let t133 = w5_x * w5_x;
        let t134 = w5_z * w5_z;
        let t135 = w5_x * t112;
        let t136 = w5_x * w5_z;
        let t137 = t112 * w5_z;
        let t138 = t137 - t130;
        let t139 = t136 - t127;
        let t140 = t133 - t134;
        let t141 = t140 - t104;
        let t142 = dw5_z + t135;
        let t143 = t135 - dw5_z;
        let t144 = t133 + t134;
        let t145 = t136 + t139;
        let t146 = t137 + t138;
        put(217, a5_y); // row 5, MSX5
        put(218, t121); // row 5, MSY5
        put(219, t135); // row 5, XX5
        put(221, dw5_z); // row 5, ZZ5
        put(223, t130); // row 5, XZ5
        put(224, t127); // row 5, YZ5
        [
        w5_x, t112, a5_z, t121, a5_y, t127, t130, w5_z,
        dw5_z, t135, t136, t137, t138, t139, t140, t141,
        t142, t143, t144, t145, t146,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t157, t161, a6_y, t167, t170, w6_z,
        dw6_z, t175, t176, t177, dw6_x, dw6_y, t180, t181,
        t182, t183, t184, t185, t186,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t156 = t121 + t142 * k5;
        let t157 = t144 * k5 - a5_y;
        let t158 = a5_z - t146 * k5;
        let t161 = c6 * t156 - s6 * t158;
        let a6_y = c6 * t158 + s6 * t156;
        let t167 = c6 * t142 + s6 * t146;
        let t170 = s6 * t142 - c6 * t146;
        let w6_z = t112 + dq6;
        let dw6_z = t139 + ddq6;
        let t173 = w6_x * w6_x;
        let t174 = w6_z * w6_z;
        let t175 = w6_x * w6_y;
        let t176 = w6_x * w6_z;
        let t177 = w6_y * w6_z;
        let dw6_x = t170 + t177;
        let dw6_y = t167 - t176;
        let t180 = t173 - t174;
        let t181 = t144 - t180;
        let t182 = t175 - dw6_z;
        let t183 = dw6_z + t175;
        let t184 = t173 + t174;
        let t185 = dw6_y - t176;
        let t186 = t177 + dw6_x;
        put(248, a6_y); // row 6, MSX6
        put(249, t161); // row 6, MSY6
        put(251, t175); // row 6, YY6
        put(252, dw6_z); // row 6, ZZ6
        put(254, t170); // row 6, XZ6
        put(255, t167); // row 6, YZ6
        [
        w6_x, w6_y, t157, t161, a6_y, t167, t170, w6_z,
        dw6_z, t175, t176, t177, dw6_x, dw6_y, t180, t181,
        t182, t183, t184, t185, t186,
    ]
    };
    // link 7: motion
    let [
        a7_z, t201, a7_y, t207, t210, dw7_z, t215, t216,
        t217, t218, t219, t220, t221, t222, t223, t224,
        t225, t226,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t192 = c7 * w6_z + s7 * w6_x;
        let t196 = t161 + t182 * k6;
        let a7_z = a6_y + t184 * k6;
        let t198 = t186 * k6 - t157;
        let t201 = c7 * t196 - s7 * t198;
        let a7_y = c7 * t198 + s7 * t196;
        let t207 = c7 * t182 - s7 * t186;
        let t210 = c7 * t186 + s7 * t182;
        let w7_z = w6_y + dq7;
        let dw7_z = dw6_y + ddq7;
        let t213 = w7_x * w7_x;
        let t214 = w7_z * w7_z;
        let t215 = w7_x * t192;
        let t216 = w7_x * w7_z;
        let t217 = t192 * w7_z;
        let t218 = t217 - t210;
        let t219 = t216 - t207;
        let t220 = t213 - t214;
        let t221 = t184 - t220;
        let t222 = dw7_z + t215;
        let t223 = t215 - dw7_z;
        let t224 = t213 + t214;
        let t225 = t216 + t219;
        let t226 = t217 + t218;
        put(269, a7_y); // row 7, MSX7
        put(270, t201); // row 7, MSY7
        put(271, t215); // row 7, XX7
        put(273, dw7_z); // row 7, ZZ7
        put(275, t210); // row 7, XZ7
        put(276, t207); // row 7, YZ7
        [
        a7_z, t201, a7_y, t207, t210, dw7_z, t215, t216,
        t217, t218, t219, t220, t221, t222, t223, t224,
        t225, t226,
    ]
    };
    // joint axes in frame 2
    let [t227, v1_2_y] = {
        let t227 = c2 * k1;
        let v1_2_y = s2 * k1;
        [t227, v1_2_y]
    };
    // joint axes in frame 3
    let [z1_3_x, z1_4_z, v1_3_x, v1_3_y, v2_3_x, v2_4_z] = {
        let t229 = s2 * k2;
        let z1_3_x = s2 * c3;
        let z1_4_z = s2 * s3;
        let v1_3_x = s3 * t229 - c3 * t227;
        let v1_3_y = c3 * t229 + s3 * t227;
        let v2_3_x = c3 * k2;
        let v2_4_z = s3 * k2;
        [z1_3_x, z1_4_z, v1_3_x, v1_3_y, v2_3_x, v2_4_z]
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
        let t272 = s2 * t6 - c2 * t5;
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
        let t288 = t3 * k1 - t6;
        put(2, t286); // row 1, MSX2
        put(9, t285); // row 1, XZ2
        put(64, t288); // row 2, MSX2
    }
    // YZ2: column
    {
        let t292 = s2 * (t0 - t24) - c2 * t22;
        let t293 = k1 * t292;
        let t295 = t5 + t4 * k1;
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
        let t307 = a3_z * v1_2_y + (a3_y * v1_3_y - t41 * v1_3_x);
        let t310 = t41 * v2_3_x + a3_y * v2_4_z;
        put(11, t307); // row 1, M3
        t310
    };
    // MSX3: column
    {
        let t318 = t65 * v1_2_y - (t63 * v1_3_y - t61 * v1_3_x);
        let t319 = a3_z * z1_4_z + c2 * a3_y + t318;
        let t324 = c3 * a3_z + (t61 * v2_3_x + t63 * v2_4_z);
        put(12, t319); // row 1, MSX3
        put(73, t324); // row 2, MSX3
    }
    // MSY3: column
    let [t329, t336] = {
        let t329 = t64 * v1_3_y;
        let t333 = a3_z * z1_3_x + c2 * t41 - (t66 * v1_2_y + (t62 * v1_3_x + t329));
        let t336 = t64 * v2_4_z;
        let t338 = t336 - t62 * v2_3_x - s3 * a3_z;
        put(13, t333); // row 1, MSY3
        put(74, t338); // row 2, MSY3
        [t329, t336]
    };
    // MSZ3: column
    {
        let t341 = a3_y * z1_3_x - t41 * z1_4_z;
        let t347 = t47 * v1_3_x - t50 * v1_3_y - t24 * v1_2_y - t341;
        let t354 = s3 * a3_y + c3 * t41 + (t47 * v2_3_x + t50 * v2_4_z);
        put(14, t347); // row 1, MSZ3
        put(75, t354); // row 2, MSZ3
    }
    // XX3: column
    let [t356, t357, t361] = {
        let t356 = t56 * z1_4_z;
        let t357 = c2 * t55;
        let t359 = t357 - (t58 * z1_3_x + t356);
        let t361 = c3 * t56;
        let t362 = s3 * t58 - t361;
        put(15, t359); // row 1, XX3
        put(76, t362); // row 2, XX3
        [t356, t357, t361]
    };
    // YY3: column
    let [t363, t367] = {
        let t363 = t57 * z1_3_x;
        let t366 = t363 + t59 * z1_4_z - t357;
        let t367 = s3 * t57;
        let t369 = c3 * t59 - t367;
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
        let t374 = t61 + t64;
        let t379 = c2 * t374 + (t66 * z1_4_z - t65 * z1_3_x);
        let t382 = s3 * t65 + c3 * t66;
        put(18, t379); // row 1, XY3
        put(79, t382); // row 2, XY3
        put(130, t374); // row 3, XY3
    }
    // XZ3: column
    {
        let t387 = c2 * t50 + (t60 * z1_4_z - t63 * z1_3_x);
        let t390 = s3 * t63 + c3 * t60;
        put(19, t387); // row 1, XZ3
        put(80, t390); // row 2, XZ3
    }
    // YZ3: column
    {
        let t391 = t64 - t24;
        let t396 = c2 * t47 - (z1_3_x * t391 + t62 * z1_4_z);
        let t399 = s3 * t391 - c3 * t62;
        put(20, t396); // row 1, YZ3
        put(81, t399); // row 2, YZ3
    }
    // M4: column
    let [t402, t405] = {
        let t402 = c4 * t81 + s4 * a4_y;
        let t405 = c4 * a4_y - s4 * t81;
        let t406 = k3 * t405;
        let t407 = k3 * t402;
        let t415 = v1_3_x * t402 + t77 * v1_3_y - v1_2_y * t405;
        let t416 = z1_3_x * t406 + c2 * t407 - t415;
        let t421 = t77 * v2_4_z - v2_3_x * t402 - s3 * t406;
        put(21, t416); // row 1, M4
        put(82, t421); // row 2, M4
        put(133, t407); // row 3, M4
        [t402, t405]
    };
    // MSX4: column
    let [t423, t428, t429] = {
        let t423 = s4 * t103;
        let t424 = c4 * t101 + t423;
        let t427 = s4 * t101 - c4 * t103;
        let t428 = s4 * t77;
        let t429 = c4 * t77;
        let t432 = t428 - k3 * t427;
        let t433 = k3 * t424 - t429;
        let t443 = v1_2_y * t427 + (v1_3_x * t424 + t105 * v1_3_y);
        let t444 = c2 * t433 + (z1_3_x * t432 + a4_y * z1_4_z) - t443;
        let t451 = c3 * a4_y - s3 * t432 + (t105 * v2_4_z - v2_3_x * t424);
        put(22, t444); // row 1, MSX4
        put(83, t451); // row 2, MSX4
        put(134, t433); // row 3, MSX4
        [t423, t428, t429]
    };
    // MSY4: column
    let t452 = {
        let t452 = c4 * t102;
        let t454 = t452 + s4 * t104;
        let t457 = c4 * t104 - s4 * t102;
        let t460 = k3 * t457 - t429;
        let t461 = t428 - k3 * t454;
        let t471 = v1_2_y * t457 - (v1_3_x * t454 - t106 * v1_3_y);
        let t472 = c2 * t461 - (z1_3_x * t460 - t81 * z1_4_z) - t471;
        let t479 = s3 * t460 + c3 * t81 + (v2_3_x * t454 + t106 * v2_4_z);
        put(23, t472); // row 1, MSY4
        put(84, t479); // row 2, MSY4
        put(135, t461); // row 3, MSY4
        t452
    };
    // MSZ4: column
    let t489 = {
        let t482 = c4 * t87 + s4 * t90;
        let t485 = s4 * t87 - c4 * t90;
        let t488 = t405 - k3 * t485;
        let t489 = t402 + k3 * t482;
        let t497 = v1_2_y * t485 + (t329 + v1_3_x * t482) - (z1_3_x * t488 + c2 * t489);
        let t501 = s3 * t488 - (t336 - v2_3_x * t482);
        put(24, t497); // row 1, MSZ4
        put(85, t501); // row 2, MSZ4
        t489
    };
    // XX4: column
    let [t503, t504, t508, t509, t513] = {
        let t503 = t96 * z1_4_y;
        let t504 = t95 * z1_4_z;
        let t506 = dw4_x * z1_4_x + t503 - t504;
        let t508 = t96 * z2_4_y;
        let t509 = c3 * t95;
        let t511 = t508 - dw4_x * t246 - t509;
        let t513 = c4 * t96;
        let t514 = s4 * dw4_x + t513;
        put(25, t506); // row 1, XX4
        put(86, t511); // row 2, XX4
        put(137, t514); // row 3, XX4
        [t503, t504, t508, t509, t513]
    };
    // YY4: column
    let [t515, t519, t523] = {
        let t515 = t97 * z1_4_x;
        let t518 = t504 - (t515 - dw4_y * z1_4_y);
        let t519 = t97 * t246;
        let t522 = t509 + (t519 + dw4_y * z2_4_y);
        let t523 = s4 * t97;
        let t525 = c4 * dw4_y - t523;
        put(26, t518); // row 1, YY4
        put(87, t522); // row 2, YY4
        put(138, t525); // row 3, YY4
        [t515, t519, t523]
    };
    // ZZ4: column
    {
        let t528 = dw4_z * z1_4_z + (t515 - t503);
        let t531 = c3 * dw4_z - (t508 + t519);
        let t532 = t523 - t513;
        put(27, t528); // row 1, ZZ4
        put(88, t531); // row 2, ZZ4
        put(139, t532); // row 3, ZZ4
    }
    // XY4: column
    {
        let t533 = t104 - t101;
        let t538 = z1_4_z * t533 - (t105 * z1_4_x - t106 * z1_4_y);
        let t543 = c3 * t533 + (t105 * t246 + t106 * z2_4_y);
        let t546 = c4 * t106 - s4 * t105;
        put(28, t538); // row 1, XY4
        put(89, t543); // row 2, XY4
        put(140, t546); // row 3, XY4
        put(181, t533); // row 4, XY4
    }
    // XZ4: column
    {
        let t551 = t90 * z1_4_z + (t103 * z1_4_x + t100 * z1_4_y);
        let t556 = c3 * t90 + (t100 * z2_4_y - t103 * t246);
        let t558 = t423 + c4 * t100;
        put(29, t551); // row 1, XZ4
        put(90, t556); // row 2, XZ4
        put(141, t558); // row 3, XZ4
    }
    // YZ4: column
    {
        let t559 = t64 - t104;
        let t564 = t87 * z1_4_z + (z1_4_x * t559 - t102 * z1_4_y);
        let t569 = c3 * t87 - (t246 * t559 + t102 * z2_4_y);
        let t571 = s4 * t559 - t452;
        put(30, t564); // row 1, YZ4
        put(91, t569); // row 2, YZ4
        put(142, t571); // row 3, YZ4
    }
    // M5: column
    let [t574, t577, t579] = {
        let t574 = c5 * t121 + s5 * a5_y;
        let t577 = s5 * t121 - c5 * a5_y;
        let t579 = k4 * t574;
        let t581 = k3 * t574;
        let t582 = k3 * a5_z - k4 * t577;
        let t592 = v1_3_y * t577 + (t252 * t574 + a5_z * t255);
        let t593 = z1_4_x * t582 + z1_4_y * t581 - z1_4_z * t579 - t592;
        let t603 = t248 * t574 + a5_z * t249 - v2_4_z * t577;
        let t604 = z2_4_y * t581 - t246 * t582 - c3 * t579 - t603;
        let t607 = s4 * t582 + c4 * t581;
        put(31, t593); // row 1, M5
        put(92, t604); // row 2, M5
        put(143, t607); // row 3, M5
        [t574, t577, t579]
    };
    // MSX5: column
    let [t609, t614, t615] = {
        let t609 = s5 * t143;
        let t610 = c5 * t141 + t609;
        let t613 = c5 * t143 - s5 * t141;
        let t614 = s5 * a5_z;
        let t615 = c5 * a5_z;
        let t619 = t615 + k4 * t610;
        let t622 = k4 * t613 - t614 - k3 * t145;
        let t623 = a5_y - k3 * t610;
        let t633 = t252 * t610 - t145 * t255 - v1_3_y * t613;
        let t634 = z1_4_z * t619 + (z1_4_y * t623 - z1_4_x * t622) + t633;
        let t644 = v2_4_z * t613 + (t248 * t610 - t145 * t249);
        let t645 = c3 * t619 + (t246 * t622 + z2_4_y * t623) + t644;
        let t648 = c4 * t623 - s4 * t622;
        put(32, t634); // row 1, MSX5
        put(93, t645); // row 2, MSX5
        put(144, t648); // row 3, MSX5
        put(185, t619); // row 4, MSX5
        [t609, t614, t615]
    };
    // MSY5: column
    let [t649, t650, t653] = {
        let t649 = c5 * t142;
        let t650 = s5 * t144;
        let t651 = t650 - t649;
        let t653 = c5 * t144;
        let t654 = s5 * t142 + t653;
        let t658 = k4 * t651 - t614;
        let t661 = k4 * t654 - t615 + k3 * t146;
        let t662 = t121 - k3 * t651;
        let t667 = z1_4_x * t661 - z1_4_y * t662 - z1_4_z * t658;
        let t673 = t252 * t651 + t146 * t255 - v1_3_y * t654 - t667;
        let t683 = v2_4_z * t654 + (t248 * t651 + t146 * t249);
        let t684 = c3 * t658 + (t246 * t661 + z2_4_y * t662) + t683;
        let t687 = c4 * t662 - s4 * t661;
        put(33, t673); // row 1, MSY5
        put(94, t684); // row 2, MSY5
        put(145, t687); // row 3, MSY5
        put(186, t658); // row 4, MSY5
        [t649, t650, t653]
    };
    // MSZ5: column
    {
        let t690 = c5 * t127 + s5 * t130;
        let t693 = c5 * t130 - s5 * t127;
        let t697 = t574 + k4 * t690;
        let t699 = k3 * t690;
        let t700 = t577 - k4 * t693 - k3 * t104;
        let t710 = v1_3_y * t693 - (t252 * t690 + t104 * t255);
        let t711 = z1_4_z * t697 - (z1_4_y * t699 - z1_4_x * t700) - t710;
        let t716 = t246 * t700 + z2_4_y * t699 - c3 * t697;
        let t722 = v2_4_z * t693 + (t248 * t690 + t104 * t249) - t716;
        let t725 = s4 * t700 - c4 * t699;
        put(34, t711); // row 1, MSZ5
        put(95, t722); // row 2, MSZ5
        put(146, t725); // row 3, MSZ5
        put(187, t697); // row 4, MSZ5
    }
    // XX5: column
    let [t727, t728, t732, t733, t737, t738, t742] = {
        let t727 = t136 * z1_6_z;
        let t728 = t135 * z1_4_y;
        let t730 = t728 + (t138 * t258 - t727);
        let t732 = t136 * t267;
        let t733 = t135 * z2_4_y;
        let t735 = t733 - (t732 - t138 * t264);
        let t737 = t136 * z3_6_z;
        let t738 = c4 * t135;
        let t740 = t738 - (t138 * z3_5_x + t737);
        let t742 = c5 * t136;
        let t743 = s5 * t138 - t742;
        put(35, t730); // row 1, XX5
        put(96, t735); // row 2, XX5
        put(147, t740); // row 3, XX5
        put(188, t743); // row 4, XX5
        [t727, t728, t732, t733, t737, t738, t742]
    };
    // YY5: column
    let [t744, t748, t752, t756] = {
        let t744 = t137 * t258;
        let t747 = t139 * z1_6_z - t744 - t728;
        let t748 = t137 * t264;
        let t751 = t139 * t267 - t748 - t733;
        let t752 = t137 * z3_5_x;
        let t755 = t752 + t139 * z3_6_z - t738;
        let t756 = s5 * t137;
        let t758 = c5 * t139 - t756;
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
        let t769 = t141 + t144;
        let t774 = z1_4_y * t769 + (t145 * t258 + t146 * z1_6_z);
        let t779 = z2_4_y * t769 + (t145 * t264 + t146 * t267);
        let t784 = c4 * t769 - (t145 * z3_5_x - t146 * z3_6_z);
        let t787 = s5 * t145 + c5 * t146;
        put(38, t774); // row 1, XY5
        put(99, t779); // row 2, XY5
        put(150, t784); // row 3, XY5
        put(191, t787); // row 4, XY5
        put(222, t769); // row 5, XY5
    }
    // XZ5: column
    {
        let t792 = t130 * z1_4_y + (t143 * t258 + t140 * z1_6_z);
        let t797 = t130 * z2_4_y + (t143 * t264 + t140 * t267);
        let t802 = c4 * t130 + (t140 * z3_6_z - t143 * z3_5_x);
        let t804 = t609 + c5 * t140;
        put(39, t792); // row 1, XZ5
        put(100, t797); // row 2, XZ5
        put(151, t802); // row 3, XZ5
        put(192, t804); // row 4, XZ5
    }
    // YZ5: column
    {
        let t805 = t144 - t104;
        let t810 = t127 * z1_4_y - (t142 * z1_6_z - t258 * t805);
        let t815 = t127 * z2_4_y - (t142 * t267 - t264 * t805);
        let t820 = c4 * t127 - (z3_5_x * t805 + t142 * z3_6_z);
        let t822 = s5 * t805 - t649;
        put(40, t810); // row 1, YZ5
        put(101, t815); // row 2, YZ5
        put(152, t820); // row 3, YZ5
        put(193, t822); // row 4, YZ5
    }
    // M6: column
    let [t825, t828] = {
        let t825 = c6 * t161 + s6 * a6_y;
        let t828 = s6 * t161 - c6 * a6_y;
        let t829 = k5 * t828;
        let t830 = k5 * t825;
        let t833 = c5 * t825 - s5 * t157;
        let t836 = s5 * t825 + c5 * t157;
        let t842 = s5 * t829 - k4 * t833;
        let t845 = c5 * t829 + k4 * t836 + k3 * t828;
        let t846 = t830 + k3 * t833;
        let t856 = v1_3_y * t836 + (t252 * t833 - t255 * t828);
        let t857 = z1_4_z * t842 + (z1_4_y * t846 - z1_4_x * t845) - t856;
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
        let t873 = s6 * t183;
        let t874 = c6 * t181 + t873;
        let t876 = c6 * t183;
        let t877 = s6 * t181 - t876;
        let t878 = s6 * t157;
        let t879 = c6 * t157;
        let t882 = t878 - k5 * t877;
        let t883 = k5 * t874 - t879;
        let t886 = c5 * t874 + s5 * t185;
        let t889 = c5 * t185 - s5 * t874;
        let t899 = c5 * a6_y - s5 * t882 - k4 * t886;
        let t902 = c5 * t882 + s5 * a6_y + k4 * t889 - k3 * t877;
        let t903 = t883 + k3 * t886;
        let t913 = v1_3_y * t889 + (t255 * t877 - t252 * t886);
        let t914 = z1_4_z * t899 + (z1_4_x * t902 + z1_4_y * t903) + t913;
        let t924 = t249 * t877 - t248 * t886 - v2_4_z * t889;
        let t925 = c3 * t899 - (t246 * t902 - z2_4_y * t903) + t924;
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
        let t929 = c6 * t182;
        let t930 = s6 * t184;
        let t931 = t929 + t930;
        let t932 = s6 * t182;
        let t933 = c6 * t184;
        let t934 = t933 - t932;
        let t937 = t879 - k5 * t934;
        let t938 = t878 - k5 * t931;
        let t941 = c5 * t931 + s5 * t186;
        let t944 = s5 * t931 - c5 * t186;
        let t954 = k4 * t941 - (s5 * t937 - c5 * t161);
        let t957 = c5 * t937 + s5 * t161 + k4 * t944 - k3 * t934;
        let t958 = t938 - k3 * t941;
        let t968 = v1_3_y * t944 + (t252 * t941 + t255 * t934);
        let t969 = z1_4_z * t954 + (z1_4_x * t957 + z1_4_y * t958) + t968;
        let t979 = t248 * t941 + t249 * t934 - v2_4_z * t944;
        let t980 = c3 * t954 - (t246 * t957 - z2_4_y * t958) + t979;
        let t983 = s4 * t957 + c4 * t958;
        put(43, t969); // row 1, MSY6
        put(104, t980); // row 2, MSY6
        put(155, t983); // row 3, MSY6
        put(196, t954); // row 4, MSY6
        put(227, t938); // row 5, MSY6
        [t929, t930, t932, t933]
    };
    // MSZ6: column
    let t993 = {
        let t986 = c6 * t167 + s6 * t170;
        let t989 = c6 * t170 - s6 * t167;
        let t992 = k5 * t989 - t828;
        let t993 = t825 + k5 * t986;
        let t995 = t650 - c5 * t986;
        let t997 = t653 + s5 * t986;
        let t1003 = s5 * t992 - k4 * t995;
        let t1006 = c5 * t992 - k4 * t997 + k3 * t989;
        let t1007 = k3 * t995 - t993;
        let t1017 = v1_3_y * t997 - (t252 * t995 - t255 * t989);
        let t1018 = z1_4_z * t1003 - (z1_4_x * t1006 - z1_4_y * t1007) + t1017;
        let t1028 = t249 * t989 - t248 * t995 - v2_4_z * t997;
        let t1029 = c3 * t1003 + (t246 * t1006 + z2_4_y * t1007) + t1028;
        let t1032 = c4 * t1007 - s4 * t1006;
        put(44, t1018); // row 1, MSZ6
        put(105, t1029); // row 2, MSZ6
        put(156, t1032); // row 3, MSZ6
        put(197, t1003); // row 4, MSZ6
        t993
    };
    // XX6: column
    let [t1034, t1037, t1040, t1045, t1050, t1055] = {
        let t1034 = s6 * t176;
        let t1035 = t1034 - c6 * dw6_x;
        let t1037 = c6 * t176;
        let t1038 = s6 * dw6_x + t1037;
        let t1040 = t175 * z1_6_z;
        let t1043 = z1_4_y * t1038 + (t258 * t1035 - t1040);
        let t1045 = t175 * t267;
        let t1048 = z2_4_y * t1038 - (t1045 - t264 * t1035);
        let t1050 = t175 * z3_6_z;
        let t1053 = c4 * t1038 - (z3_5_x * t1035 + t1050);
        let t1055 = c5 * t175;
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
        let t1057 = c6 * t177;
        let t1059 = t1057 + s6 * dw6_y;
        let t1060 = s6 * t177;
        let t1062 = c6 * dw6_y - t1060;
        let t1066 = z1_4_y * t1062 + (t1040 + t258 * t1059);
        let t1070 = z2_4_y * t1062 + (t1045 + t264 * t1059);
        let t1074 = c4 * t1062 - (z3_5_x * t1059 - t1050);
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
        let t1097 = t184 - t181;
        let t1100 = c6 * t185 - s6 * t186;
        let t1103 = s6 * t185 + c6 * t186;
        let t1108 = z1_4_y * t1103 + (z1_6_z * t1097 - t258 * t1100);
        let t1113 = z2_4_y * t1103 - (t264 * t1100 - t267 * t1097);
        let t1118 = c4 * t1103 + (z3_5_x * t1100 + z3_6_z * t1097);
        let t1121 = c5 * t1097 - s5 * t1100;
        put(48, t1108); // row 1, XY6
        put(109, t1113); // row 2, XY6
        put(160, t1118); // row 3, XY6
        put(201, t1121); // row 4, XY6
        put(232, t1103); // row 5, XY6
        put(253, t1097); // row 6, XY6
    }
    // XZ6: column
    {
        let t1123 = t876 + s6 * t180;
        let t1125 = t873 - c6 * t180;
        let t1130 = z1_4_y * t1125 + (t170 * z1_6_z - t258 * t1123);
        let t1135 = z2_4_y * t1125 + (t170 * t267 - t264 * t1123);
        let t1140 = c4 * t1125 + (z3_5_x * t1123 + t170 * z3_6_z);
        let t1143 = c5 * t170 - s5 * t1123;
        put(49, t1130); // row 1, XZ6
        put(110, t1135); // row 2, XZ6
        put(161, t1140); // row 3, XZ6
        put(202, t1143); // row 4, XZ6
        put(233, t1125); // row 5, XZ6
    }
    // YZ6: column
    {
        let t1144 = t144 - t184;
        let t1146 = t932 + c6 * t1144;
        let t1148 = s6 * t1144 - t929;
        let t1153 = z1_4_y * t1148 - (t258 * t1146 - t167 * z1_6_z);
        let t1158 = z2_4_y * t1148 + (t167 * t267 - t264 * t1146);
        let t1163 = c4 * t1148 + (z3_5_x * t1146 + t167 * z3_6_z);
        let t1166 = c5 * t167 - s5 * t1146;
        put(50, t1153); // row 1, YZ6
        put(111, t1158); // row 2, YZ6
        put(162, t1163); // row 3, YZ6
        put(203, t1166); // row 4, YZ6
        put(234, t1148); // row 5, YZ6
    }
    // M7: column
    let [t1169, t1172, t1174] = {
        let t1169 = c7 * t201 + s7 * a7_y;
        let t1172 = s7 * t201 - c7 * a7_y;
        let t1173 = k6 * t1172;
        let t1174 = k6 * t1169;
        let t1177 = c6 * t1169 + s6 * a7_z;
        let t1180 = s6 * t1169 - c6 * a7_z;
        let t1185 = c6 * t1173 + k5 * t1180;
        let t1186 = k5 * t1177 - s6 * t1173;
        let t1189 = s5 * t1172 - c5 * t1177;
        let t1192 = s5 * t1177 + c5 * t1172;
        let t1202 = k4 * t1189 - (c5 * t1174 - s5 * t1185);
        let t1205 = c5 * t1185 + s5 * t1174 + k4 * t1192 + k3 * t1180;
        let t1206 = t1186 - k3 * t1189;
        let t1211 = z1_4_x * t1205 - z1_4_y * t1206 - z1_4_z * t1202;
        let t1217 = t252 * t1189 + t255 * t1180 - v1_3_y * t1192 - t1211;
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
        let t1233 = s7 * t223;
        let t1234 = c7 * t221 - t1233;
        let t1236 = c7 * t223;
        let t1237 = s7 * t221 + t1236;
        let t1238 = s7 * a7_z;
        let t1239 = c7 * a7_z;
        let t1242 = k6 * t1237 - t1238;
        let t1243 = t1239 - k6 * t1234;
        let t1246 = c6 * t1234 + s6 * t225;
        let t1249 = s6 * t1234 - c6 * t225;
        let t1258 = c6 * t1242 + s6 * a7_y + k5 * t1249;
        let t1259 = k5 * t1246 - (s6 * t1242 - c6 * a7_y);
        let t1262 = s5 * t1237 - c5 * t1246;
        let t1265 = s5 * t1246 + c5 * t1237;
        let t1275 = s5 * t1258 + c5 * t1243 + k4 * t1262;
        let t1278 = c5 * t1258 - s5 * t1243 + k4 * t1265 + k3 * t1249;
        let t1279 = t1259 - k3 * t1262;
        let t1289 = v1_3_y * t1265 - (t252 * t1262 + t255 * t1249);
        let t1290 = z1_4_z * t1275 + (z1_4_y * t1279 - z1_4_x * t1278) - t1289;
        let t1300 = v2_4_z * t1265 + (t248 * t1262 + t249 * t1249);
        let t1301 = c3 * t1275 + (t246 * t1278 + z2_4_y * t1279) + t1300;
        let t1304 = c4 * t1279 - s4 * t1278;
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
        let t1305 = c7 * t222;
        let t1307 = s7 * t224 - t1305;
        let t1308 = s7 * t222;
        let t1310 = t1308 + c7 * t224;
        let t1313 = t1239 - k6 * t1310;
        let t1314 = k6 * t1307 - t1238;
        let t1317 = c6 * t1307 + s6 * t226;
        let t1320 = c6 * t226 - s6 * t1307;
        let t1329 = s6 * t201 - c6 * t1313 + k5 * t1320;
        let t1330 = s6 * t1313 + c6 * t201 - k5 * t1317;
        let t1333 = c5 * t1317 + s5 * t1310;
        let t1336 = s5 * t1317 - c5 * t1310;
        let t1346 = s5 * t1329 + c5 * t1314 + k4 * t1333;
        let t1349 = c5 * t1329 - s5 * t1314 - k4 * t1336 + k3 * t1320;
        let t1350 = t1330 - k3 * t1333;
        let t1355 = z1_4_x * t1349 - z1_4_y * t1350 - z1_4_z * t1346;
        let t1361 = v1_3_y * t1336 + (t252 * t1333 + t255 * t1320) - t1355;
        let t1371 = t248 * t1333 + t249 * t1320 - v2_4_z * t1336;
        let t1372 = c3 * t1346 + (t246 * t1349 + z2_4_y * t1350) + t1371;
        let t1375 = c4 * t1350 - s4 * t1349;
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
        let t1378 = c7 * t207 + s7 * t210;
        let t1381 = c7 * t210 - s7 * t207;
        let t1384 = t1172 - k6 * t1381;
        let t1385 = t1169 + k6 * t1378;
        let t1387 = t930 + c6 * t1378;
        let t1389 = s6 * t1378 - t933;
        let t1394 = c6 * t1384 + k5 * t1389;
        let t1395 = s6 * t1384 - k5 * t1387;
        let t1398 = c5 * t1387 + s5 * t1381;
        let t1401 = c5 * t1381 - s5 * t1387;
        let t1411 = c5 * t1385 - s5 * t1394 + k4 * t1398;
        let t1414 = k3 * t1389 - (k4 * t1401 - (c5 * t1394 + s5 * t1385));
        let t1415 = t1395 - k3 * t1398;
        let t1425 = v1_3_y * t1401 + (t255 * t1389 - t252 * t1398);
        let t1426 = z1_4_z * t1411 + (z1_4_x * t1414 + z1_4_y * t1415) - t1425;
        let t1436 = v2_4_z * t1401 - (t249 * t1389 - t248 * t1398);
        let t1437 = c3 * t1411 + (z2_4_y * t1415 - t246 * t1414) + t1436;
        let t1440 = s4 * t1414 + c4 * t1415;
        put(54, t1426); // row 1, MSZ7
        put(115, t1437); // row 2, MSZ7
        put(166, t1440); // row 3, MSZ7
        put(207, t1411); // row 4, MSZ7
        put(238, t1395); // row 5, MSZ7
        put(259, t1385); // row 6, MSZ7
    }
    // XX7: column
    let [t1442, t1445, t1448, t1451] = {
        let t1442 = s7 * t216;
        let t1443 = c7 * t218 + t1442;
        let t1445 = c7 * t216;
        let t1446 = s7 * t218 - t1445;
        let t1448 = s6 * t215;
        let t1449 = c6 * t1443 + t1448;
        let t1451 = c6 * t215;
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
        let t1471 = c7 * t217;
        let t1473 = t1471 + s7 * t219;
        let t1474 = s7 * t217;
        let t1476 = c7 * t219 - t1474;
        let t1478 = t1448 + c6 * t1473;
        let t1480 = s6 * t1473 - t1451;
        let t1485 = z1_4_y * t1480 + (z1_6_z * t1476 - t258 * t1478);
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
        let t1499 = t1471 - t1442;
        let t1500 = t1445 + t1474;
        let t1503 = c6 * t1499 + s6 * dw7_z;
        let t1506 = c6 * dw7_z - s6 * t1499;
        let t1511 = z1_4_y * t1506 + (t258 * t1503 + z1_6_z * t1500);
        let t1516 = z2_4_y * t1506 + (t264 * t1503 + t267 * t1500);
        let t1521 = c4 * t1506 + (z3_6_z * t1500 - z3_5_x * t1503);
        let t1524 = s5 * t1503 + c5 * t1500;
        put(57, t1511); // row 1, ZZ7
        put(118, t1516); // row 2, ZZ7
        put(169, t1521); // row 3, ZZ7
        put(210, t1524); // row 4, ZZ7
        put(241, t1506); // row 5, ZZ7
        put(262, t1500); // row 6, ZZ7
    }
    // XY7: column
    {
        let t1525 = t224 - t221;
        let t1528 = c7 * t225 - s7 * t226;
        let t1531 = s7 * t225 + c7 * t226;
        let t1534 = c6 * t1528 + s6 * t1525;
        let t1537 = c6 * t1525 - s6 * t1528;
        let t1542 = z1_4_y * t1537 + (t258 * t1534 + z1_6_z * t1531);
        let t1547 = z2_4_y * t1537 + (t264 * t1534 + t267 * t1531);
        let t1552 = c4 * t1537 - (z3_5_x * t1534 - z3_6_z * t1531);
        let t1555 = s5 * t1534 + c5 * t1531;
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
        let t1557 = s7 * t220 - t1236;
        let t1559 = t1233 + c7 * t220;
        let t1562 = s6 * t210 - c6 * t1557;
        let t1565 = s6 * t1557 + c6 * t210;
        let t1570 = z1_4_y * t1565 + (t258 * t1562 + z1_6_z * t1559);
        let t1575 = z2_4_y * t1565 + (t264 * t1562 + t267 * t1559);
        let t1580 = c4 * t1565 + (z3_6_z * t1559 - z3_5_x * t1562);
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
        let t1584 = t224 - t184;
        let t1586 = t1308 + c7 * t1584;
        let t1588 = s7 * t1584 - t1305;
        let t1591 = c6 * t1586 + s6 * t207;
        let t1594 = c6 * t207 - s6 * t1586;
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
        let t1622 = -t55;
        let t1623 = -t489;
        let t1624 = -t95;
        let t1625 = -t579;
        let t1626 = -t135;
        let t1627 = -t993;
        let t1628 = -t175;
        let t1629 = -t1174;
        let t1630 = -t215;
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
