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
        w2_x, w2_y, t3, t4, t5, t6, a2_z, t10,
        a2_y, t15, t16, t17, dw2_x, dw2_y, t20, t21,
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
        let a2_y = s2 * t7 - t6;
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
        let t25 = t16 - dw2_y;
        let t26 = t17 + dw2_x;
        put(51, t3); // row 2, XZ2
        put(52, t4); // row 2, YZ2
        [
        w2_x, w2_y, t3, t4, t5, t6, a2_z, t10,
        a2_y, t15, t16, t17, dw2_x, dw2_y, t20, t21,
        t22, t23, t24, t25, t26,
    ]
    };
    // link 3: motion
    let [
        w3_x, t32, a3_z, t41, a3_y, t47, t50, w3_z,
        dw3_z, t55, t56, t57, t58, dw3_y, t60, t61,
        t62, t63, t64, t65, t66,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t32 = c3 * dq2 + s3 * w2_x;
        let t36 = t10 + t22 * k2;
        let a3_z = a2_y + t24 * k2;
        let t38 = a2_z - t26 * k2;
        let t41 = c3 * t36 + s3 * t38;
        let a3_y = s3 * t36 - c3 * t38;
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
        let dw3_y = t47 - t56;
        let t60 = t53 - t54;
        let t61 = t60 - t24;
        let t62 = dw3_z + t55;
        let t63 = dw3_z - t55;
        let t64 = t53 + t54;
        let t65 = t56 - dw3_y;
        let t66 = t57 + t58;
        put(91, a3_y); // row 3, MSX3
        put(92, t41); // row 3, MSY3R
        put(93, t55); // row 3, XX3R
        put(94, dw3_z); // row 3, ZZ3R
        put(96, t50); // row 3, XZ3
        put(97, t47); // row 3, YZ3
        [
        w3_x, t32, a3_z, t41, a3_y, t47, t50, w3_z,
        dw3_z, t55, t56, t57, t58, dw3_y, t60, t61,
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
        let t78 = t66 * k3 - a3_z;
        let t81 = c4 * t76 + s4 * t78;
        let a4_y = s4 * t76 - c4 * t78;
        let t87 = c4 * t62 + s4 * t66;
        let t90 = s4 * t62 - c4 * t66;
        let w4_z = t32 + dq4;
        let dw4_z = ddq4 - dw3_y;
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
        let t105 = dw4_y - t96;
        let t106 = t97 + dw4_x;
        put(129, a4_y); // row 4, MSX4
        put(130, t81); // row 4, MSY4R
        put(132, dw4_z); // row 4, ZZ4R
        put(134, t90); // row 4, XZ4
        put(135, t87); // row 4, YZ4
        [
        w4_x, w4_y, t77, t81, a4_y, t87, t90, w4_z,
        dw4_z, t95, t96, t97, dw4_x, dw4_y, t100, t101,
        t102, t103, t104, t105, t106,
    ]
    };
    // link 5: motion
    let [
        w5_x, t112, a5_z, t121, a5_y, t127, t130, w5_z,
        dw5_z, t135, t136, t137, t138, dw5_y, t140, t141,
        t142, t143, t144, t145, t146,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t112 = c5 * w4_z + s5 * w4_x;
        let t116 = t81 + t102 * k4;
        let a5_z = a4_y + t104 * k4;
        let t118 = t106 * k4 - t77;
        let t121 = c5 * t116 - s5 * t118;
        let a5_y = c5 * t118 + s5 * t116;
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
        let dw5_y = t127 - t136;
        let t140 = t133 - t134;
        let t141 = t140 - t104;
        let t142 = dw5_z + t135;
        let t143 = t135 - dw5_z;
        let t144 = t133 + t134;
        let t145 = t136 - dw5_y;
        let t146 = t137 + t138;
        put(160, a5_y); // row 5, MSX5
        put(161, t121); // row 5, MSY5R
        put(162, t135); // row 5, XX5R
        put(163, dw5_z); // row 5, ZZ5R
        put(165, t130); // row 5, XZ5
        put(166, t127); // row 5, YZ5
        [
        w5_x, t112, a5_z, t121, a5_y, t127, t130, w5_z,
        dw5_z, t135, t136, t137, t138, dw5_y, t140, t141,
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
        let dw6_z = ddq6 - dw5_y;
        let t173 = w6_x * w6_x;
        let t174 = w6_z * w6_z;
        let t175 = w6_x * w6_y;
        let t176 = w6_x * w6_z;
        let t177 = w6_y * w6_z;
        let dw6_x = t170 + t177;
        let dw6_y = t167 - t176;
        let t180 = t174 - t173;
        let t181 = t144 + t180;
        let t182 = t175 - dw6_z;
        let t183 = dw6_z + t175;
        let t184 = t173 + t174;
        let t185 = t176 - dw6_y;
        let t186 = t177 + dw6_x;
        put(184, a6_y); // row 6, MSX6
        put(185, t161); // row 6, MSY6R
        put(187, dw6_z); // row 6, ZZ6R
        put(189, t170); // row 6, XZ6
        put(190, t167); // row 6, YZ6
        [
        w6_x, w6_y, t157, t161, a6_y, t167, t170, w6_z,
        dw6_z, t175, t176, t177, dw6_x, dw6_y, t180, t181,
        t182, t183, t184, t185, t186,
    ]
    };
    // link 7: motion
    let [
        a7_z, t201, a7_y, t207, t210, dw7_z, t215, t216,
        t217, t218, t220, t221, t222, t223, t224, t225,
        t226,
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
        let dw7_y = t207 - t216;
        let t220 = t214 - t213;
        let t221 = t184 + t220;
        let t222 = dw7_z + t215;
        let t223 = t215 - dw7_z;
        let t224 = t213 + t214;
        let t225 = t216 - dw7_y;
        let t226 = t217 + t218;
        put(201, a7_y); // row 7, MSX7
        put(202, t201); // row 7, MSY7
        put(203, t215); // row 7, XX7R
        put(204, dw7_z); // row 7, ZZ7
        put(206, t210); // row 7, XZ7
        put(207, t207); // row 7, YZ7
        [
        a7_z, t201, a7_y, t207, t210, dw7_z, t215, t216,
        t217, t218, t220, t221, t222, t223, t224, t225,
        t226,
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
        let t255 = c4 * v1_2_y - s4 * v1_3_x;
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
        let t275 = t3 * k1 - t6;
        put(1, t273); // row 1, MSX2
        put(6, t272); // row 1, XZ2
        put(46, t275); // row 2, MSX2
    }
    // YZ2: column
    {
        let t279 = s2 * (t0 - t24) - c2 * t22;
        let t280 = k1 * t279;
        let t282 = t5 + t4 * k1;
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
        let t291 = c2 * t26 - s2 * t25;
        put(5, t291); // row 1, XY2
        put(50, t288); // row 2, XY2
    }
    // MSX3: column
    {
        let t299 = t65 * v1_2_y + (t61 * v1_3_x + t63 * v1_3_y);
        let t300 = a3_z * z1_4_z + c2 * a3_y + t299;
        let t305 = c3 * a3_z + (t61 * v2_3_x - t63 * v2_4_z);
        put(8, t300); // row 1, MSX3
        put(53, t305); // row 2, MSX3
    }
    // MSY3: column
    {
        let t313 = t66 * v1_2_y + (t62 * v1_3_x + t64 * v1_3_y);
        let t314 = a3_z * z1_3_x + c2 * t41 - t313;
        let t319 = t64 * v2_4_z - t62 * v2_3_x - s3 * a3_z;
        put(9, t314); // row 1, MSY3R
        put(54, t319); // row 2, MSY3R
    }
    // XX3: column
    let [t321, t326] = {
        let t321 = t56 * z1_4_z;
        let t324 = c2 * t55 - (t58 * z1_3_x + t321);
        let t326 = c3 * t56;
        let t327 = s3 * t58 - t326;
        put(10, t324); // row 1, XX3R
        put(55, t327); // row 2, XX3R
        [t321, t326]
    };
    // ZZ3: column
    {
        let t331 = c2 * dw3_z + (t321 - t57 * z1_3_x);
        let t333 = t326 + s3 * t57;
        put(11, t331); // row 1, ZZ3R
        put(56, t333); // row 2, ZZ3R
    }
    // XY3: column
    {
        let t334 = t61 + t64;
        let t339 = c2 * t334 + (t66 * z1_4_z - t65 * z1_3_x);
        let t342 = s3 * t65 + c3 * t66;
        put(12, t339); // row 1, XY3
        put(57, t342); // row 2, XY3
        put(95, t334); // row 3, XY3
    }
    // XZ3: column
    {
        let t347 = c2 * t50 + (t63 * z1_3_x + t60 * z1_4_z);
        let t350 = c3 * t60 - s3 * t63;
        put(13, t347); // row 1, XZ3
        put(58, t350); // row 2, XZ3
    }
    // YZ3: column
    {
        let t351 = t64 - t24;
        let t356 = c2 * t47 - (z1_3_x * t351 + t62 * z1_4_z);
        let t359 = s3 * t351 - c3 * t62;
        put(14, t356); // row 1, YZ3
        put(59, t359); // row 2, YZ3
    }
    // MSX4: column
    let [t361, t366, t367] = {
        let t361 = s4 * t103;
        let t362 = c4 * t101 + t361;
        let t365 = s4 * t101 - c4 * t103;
        let t366 = s4 * t77;
        let t367 = c4 * t77;
        let t370 = k3 * t365 - t366;
        let t371 = k3 * t362 - t367;
        let t381 = v1_2_y * t365 - (t105 * v1_3_y - v1_3_x * t362);
        let t382 = c2 * t371 - (z1_3_x * t370 - a4_y * z1_4_z) - t381;
        let t389 = s3 * t370 + c3 * a4_y - (v2_3_x * t362 + t105 * v2_4_z);
        put(15, t382); // row 1, MSX4
        put(60, t389); // row 2, MSX4
        put(98, t371); // row 3, MSX4
        [t361, t366, t367]
    };
    // MSY4: column
    let t390 = {
        let t390 = c4 * t102;
        let t392 = t390 + s4 * t104;
        let t395 = s4 * t102 - c4 * t104;
        let t398 = t367 + k3 * t395;
        let t399 = t366 - k3 * t392;
        let t409 = v1_2_y * t395 + (v1_3_x * t392 - t106 * v1_3_y);
        let t410 = c2 * t399 + (z1_3_x * t398 + t81 * z1_4_z) + t409;
        let t417 = c3 * t81 - s3 * t398 + (v2_3_x * t392 + t106 * v2_4_z);
        put(16, t410); // row 1, MSY4R
        put(61, t417); // row 2, MSY4R
        put(99, t399); // row 3, MSY4R
        t390
    };
    // XX4: column
    let [t419, t424, t429] = {
        let t419 = t96 * z1_4_y;
        let t422 = dw4_x * z1_4_x + t419 - t95 * z1_4_z;
        let t424 = t96 * z2_4_y;
        let t427 = t424 - dw4_x * t246 - c3 * t95;
        let t429 = c4 * t96;
        let t430 = s4 * dw4_x + t429;
        put(17, t422); // row 1, XX4R
        put(62, t427); // row 2, XX4R
        put(100, t430); // row 3, XX4R
        [t419, t424, t429]
    };
    // ZZ4: column
    {
        let t434 = dw4_z * z1_4_z + (t97 * z1_4_x - t419);
        let t438 = c3 * dw4_z - (t424 + t97 * t246);
        let t440 = s4 * t97 - t429;
        put(18, t434); // row 1, ZZ4R
        put(63, t438); // row 2, ZZ4R
        put(101, t440); // row 3, ZZ4R
    }
    // XY4: column
    {
        let t441 = t104 - t101;
        let t446 = z1_4_z * t441 + (t105 * z1_4_x + t106 * z1_4_y);
        let t451 = c3 * t441 + (t106 * z2_4_y - t105 * t246);
        let t454 = s4 * t105 + c4 * t106;
        put(19, t446); // row 1, XY4
        put(64, t451); // row 2, XY4
        put(102, t454); // row 3, XY4
        put(133, t441); // row 4, XY4
    }
    // XZ4: column
    {
        let t459 = t90 * z1_4_z + (t103 * z1_4_x + t100 * z1_4_y);
        let t464 = c3 * t90 + (t100 * z2_4_y - t103 * t246);
        let t466 = t361 + c4 * t100;
        put(20, t459); // row 1, XZ4
        put(65, t464); // row 2, XZ4
        put(103, t466); // row 3, XZ4
    }
    // YZ4: column
    {
        let t467 = t64 - t104;
        let t472 = t87 * z1_4_z + (z1_4_x * t467 - t102 * z1_4_y);
        let t477 = c3 * t87 - (t246 * t467 + t102 * z2_4_y);
        let t479 = s4 * t467 - t390;
        put(21, t472); // row 1, YZ4
        put(66, t477); // row 2, YZ4
        put(104, t479); // row 3, YZ4
    }
    // MSX5: column
    let [t481, t486, t487] = {
        let t481 = s5 * t143;
        let t482 = c5 * t141 + t481;
        let t485 = c5 * t143 - s5 * t141;
        let t486 = s5 * a5_z;
        let t487 = c5 * a5_z;
        let t491 = t487 + k4 * t482;
        let t494 = t486 - k4 * t485 + k3 * t145;
        let t495 = a5_y - k3 * t482;
        let t505 = v1_3_y * t485 - (t252 * t482 + t145 * t255);
        let t506 = z1_4_z * t491 + (z1_4_x * t494 + z1_4_y * t495) - t505;
        let t516 = v2_4_z * t485 - (t145 * t249 - t248 * t482);
        let t517 = c3 * t491 + (z2_4_y * t495 - t246 * t494) + t516;
        let t520 = s4 * t494 + c4 * t495;
        put(22, t506); // row 1, MSX5
        put(67, t517); // row 2, MSX5
        put(105, t520); // row 3, MSX5
        put(136, t491); // row 4, MSX5
        [t481, t486, t487]
    };
    // MSY5: column
    let t521 = {
        let t521 = c5 * t142;
        let t523 = s5 * t144 - t521;
        let t526 = s5 * t142 + c5 * t144;
        let t530 = k4 * t523 - t486;
        let t533 = t487 - k4 * t526 - k3 * t146;
        let t534 = t121 - k3 * t523;
        let t544 = t252 * t523 - t146 * t255 - v1_3_y * t526;
        let t545 = z1_4_z * t530 + (z1_4_x * t533 + z1_4_y * t534) + t544;
        let t555 = v2_4_z * t526 + (t248 * t523 + t146 * t249);
        let t556 = c3 * t530 - (t246 * t533 - z2_4_y * t534) + t555;
        let t559 = s4 * t533 + c4 * t534;
        put(23, t545); // row 1, MSY5R
        put(68, t556); // row 2, MSY5R
        put(106, t559); // row 3, MSY5R
        put(137, t530); // row 4, MSY5R
        t521
    };
    // XX5: column
    let [t561, t566, t571, t576] = {
        let t561 = t136 * z1_6_z;
        let t564 = t135 * z1_4_y + (t138 * t258 - t561);
        let t566 = t136 * t267;
        let t569 = t135 * z2_4_y + (t138 * t264 - t566);
        let t571 = t136 * z3_6_z;
        let t574 = c4 * t135 - (t138 * z3_5_x + t571);
        let t576 = c5 * t136;
        let t577 = s5 * t138 - t576;
        put(24, t564); // row 1, XX5R
        put(69, t569); // row 2, XX5R
        put(107, t574); // row 3, XX5R
        put(138, t577); // row 4, XX5R
        [t561, t566, t571, t576]
    };
    // ZZ5: column
    {
        let t581 = dw5_z * z1_4_y + (t561 + t137 * t258);
        let t585 = dw5_z * z2_4_y + (t566 + t137 * t264);
        let t589 = c4 * dw5_z + (t571 - t137 * z3_5_x);
        let t591 = t576 + s5 * t137;
        put(25, t581); // row 1, ZZ5R
        put(70, t585); // row 2, ZZ5R
        put(108, t589); // row 3, ZZ5R
        put(139, t591); // row 4, ZZ5R
    }
    // XY5: column
    {
        let t592 = t141 + t144;
        let t597 = z1_4_y * t592 + (t145 * t258 + t146 * z1_6_z);
        let t602 = z2_4_y * t592 + (t145 * t264 + t146 * t267);
        let t607 = c4 * t592 - (t145 * z3_5_x - t146 * z3_6_z);
        let t610 = s5 * t145 + c5 * t146;
        put(26, t597); // row 1, XY5
        put(71, t602); // row 2, XY5
        put(109, t607); // row 3, XY5
        put(140, t610); // row 4, XY5
        put(164, t592); // row 5, XY5
    }
    // XZ5: column
    {
        let t615 = t130 * z1_4_y + (t143 * t258 + t140 * z1_6_z);
        let t620 = t130 * z2_4_y + (t143 * t264 + t140 * t267);
        let t625 = c4 * t130 - (t143 * z3_5_x - t140 * z3_6_z);
        let t627 = t481 + c5 * t140;
        put(27, t615); // row 1, XZ5
        put(72, t620); // row 2, XZ5
        put(110, t625); // row 3, XZ5
        put(141, t627); // row 4, XZ5
    }
    // YZ5: column
    {
        let t628 = t144 - t104;
        let t633 = t127 * z1_4_y - (t142 * z1_6_z - t258 * t628);
        let t638 = t127 * z2_4_y + (t264 * t628 - t142 * t267);
        let t643 = c4 * t127 - (z3_5_x * t628 + t142 * z3_6_z);
        let t645 = s5 * t628 - t521;
        put(28, t633); // row 1, YZ5
        put(73, t638); // row 2, YZ5
        put(111, t643); // row 3, YZ5
        put(142, t645); // row 4, YZ5
    }
    // MSX6: column
    let [t647, t650, t652, t653] = {
        let t647 = s6 * t183;
        let t648 = c6 * t181 + t647;
        let t650 = c6 * t183;
        let t651 = t650 - s6 * t181;
        let t652 = s6 * t157;
        let t653 = c6 * t157;
        let t656 = t652 + k5 * t651;
        let t657 = k5 * t648 - t653;
        let t660 = s5 * t185 - c5 * t648;
        let t663 = s5 * t648 + c5 * t185;
        let t673 = c5 * a6_y - s5 * t656 + k4 * t660;
        let t676 = c5 * t656 + s5 * a6_y - k4 * t663 + k3 * t651;
        let t677 = k3 * t660 - t657;
        let t687 = t252 * t660 + t255 * t651 - v1_3_y * t663;
        let t688 = z1_4_z * t673 + (z1_4_x * t676 - z1_4_y * t677) + t687;
        let t698 = v2_4_z * t663 - (t249 * t651 - t248 * t660);
        let t699 = c3 * t673 - (t246 * t676 + z2_4_y * t677) + t698;
        let t702 = s4 * t676 - c4 * t677;
        put(29, t688); // row 1, MSX6
        put(74, t699); // row 2, MSX6
        put(112, t702); // row 3, MSX6
        put(143, t673); // row 4, MSX6
        put(167, t657); // row 5, MSX6
        [t647, t650, t652, t653]
    };
    // MSY6: column
    let [t703, t706] = {
        let t703 = c6 * t182;
        let t705 = t703 + s6 * t184;
        let t706 = s6 * t182;
        let t708 = c6 * t184 - t706;
        let t711 = k5 * t708 - t653;
        let t712 = t652 - k5 * t705;
        let t715 = c5 * t705 + s5 * t186;
        let t718 = c5 * t186 - s5 * t705;
        let t728 = s5 * t711 + c5 * t161 + k4 * t715;
        let t731 = s5 * t161 - c5 * t711 - k4 * t718 - k3 * t708;
        let t732 = k3 * t715 - t712;
        let t742 = t252 * t715 - t255 * t708 - v1_3_y * t718;
        let t743 = z1_4_z * t728 + (z1_4_x * t731 - z1_4_y * t732) + t742;
        let t753 = v2_4_z * t718 + (t248 * t715 + t249 * t708);
        let t754 = c3 * t728 - (t246 * t731 + z2_4_y * t732) + t753;
        let t757 = s4 * t731 - c4 * t732;
        put(30, t743); // row 1, MSY6R
        put(75, t754); // row 2, MSY6R
        put(113, t757); // row 3, MSY6R
        put(144, t728); // row 4, MSY6R
        put(168, t712); // row 5, MSY6R
        [t703, t706]
    };
    // XX6: column
    let [t759, t762] = {
        let t759 = s6 * t176;
        let t760 = t759 - c6 * dw6_x;
        let t762 = c6 * t176;
        let t763 = s6 * dw6_x + t762;
        let t768 = z1_4_y * t763 - (t175 * z1_6_z - t258 * t760);
        let t773 = z2_4_y * t763 + (t264 * t760 - t175 * t267);
        let t778 = c4 * t763 - (z3_5_x * t760 + t175 * z3_6_z);
        let t781 = s5 * t760 - c5 * t175;
        put(31, t768); // row 1, XX6R
        put(76, t773); // row 2, XX6R
        put(114, t778); // row 3, XX6R
        put(145, t781); // row 4, XX6R
        put(169, t763); // row 5, XX6R
        [t759, t762]
    };
    // ZZ6: column
    {
        let t783 = t759 + c6 * t177;
        let t785 = s6 * t177 - t762;
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
        let t804 = t184 - t181;
        let t807 = c6 * t185 + s6 * t186;
        let t810 = c6 * t186 - s6 * t185;
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
        let t830 = s6 * t180 - t650;
        let t832 = t647 + c6 * t180;
        let t837 = z1_4_y * t832 + (t258 * t830 + t170 * z1_6_z);
        let t842 = z2_4_y * t832 + (t264 * t830 + t170 * t267);
        let t847 = c4 * t832 + (t170 * z3_6_z - z3_5_x * t830);
        let t850 = s5 * t830 + c5 * t170;
        put(34, t837); // row 1, XZ6
        put(79, t842); // row 2, XZ6
        put(117, t847); // row 3, XZ6
        put(148, t850); // row 4, XZ6
        put(172, t832); // row 5, XZ6
    }
    // YZ6: column
    {
        let t851 = t144 - t184;
        let t853 = t706 + c6 * t851;
        let t855 = s6 * t851 - t703;
        let t860 = z1_4_y * t855 + (t167 * z1_6_z - t258 * t853);
        let t865 = z2_4_y * t855 - (t264 * t853 - t167 * t267);
        let t870 = c4 * t855 + (z3_5_x * t853 + t167 * z3_6_z);
        let t873 = c5 * t167 - s5 * t853;
        put(35, t860); // row 1, YZ6
        put(80, t865); // row 2, YZ6
        put(118, t870); // row 3, YZ6
        put(149, t873); // row 4, YZ6
        put(173, t855); // row 5, YZ6
    }
    // MSX7: column
    let [t875, t878, t880, t881] = {
        let t875 = s7 * t223;
        let t876 = t875 - c7 * t221;
        let t878 = c7 * t223;
        let t879 = s7 * t221 + t878;
        let t880 = s7 * a7_z;
        let t881 = c7 * a7_z;
        let t884 = t880 - k6 * t879;
        let t885 = t881 + k6 * t876;
        let t888 = c6 * t876 - s6 * t225;
        let t891 = s6 * t876 + c6 * t225;
        let t900 = s6 * a7_y - c6 * t884 - k5 * t891;
        let t901 = s6 * t884 + c6 * a7_y - k5 * t888;
        let t904 = c5 * t888 + s5 * t879;
        let t907 = c5 * t879 - s5 * t888;
        let t917 = s5 * t900 + c5 * t885 + k4 * t904;
        let t920 = c5 * t900 - s5 * t885 + k4 * t907 - k3 * t891;
        let t921 = t901 - k3 * t904;
        let t931 = t252 * t904 + t255 * t891 - v1_3_y * t907;
        let t932 = z1_4_z * t917 - (z1_4_x * t920 - z1_4_y * t921) + t931;
        let t942 = v2_4_z * t907 + (t248 * t904 - t249 * t891);
        let t943 = c3 * t917 + (t246 * t920 + z2_4_y * t921) + t942;
        let t946 = c4 * t921 - s4 * t920;
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
        let t947 = c7 * t222;
        let t949 = s7 * t224 - t947;
        let t950 = s7 * t222;
        let t952 = t950 + c7 * t224;
        let t955 = t881 - k6 * t952;
        let t956 = k6 * t949 - t880;
        let t959 = c6 * t949 + s6 * t226;
        let t962 = c6 * t226 - s6 * t949;
        let t971 = s6 * t201 - c6 * t955 + k5 * t962;
        let t972 = s6 * t955 + c6 * t201 - k5 * t959;
        let t975 = c5 * t959 + s5 * t952;
        let t978 = c5 * t952 - s5 * t959;
        let t988 = s5 * t971 + c5 * t956 + k4 * t975;
        let t991 = c5 * t971 - s5 * t956 + k4 * t978 + k3 * t962;
        let t992 = t972 - k3 * t975;
        let t1002 = t252 * t975 - t255 * t962 - v1_3_y * t978;
        let t1003 = z1_4_z * t988 + (z1_4_y * t992 - z1_4_x * t991) + t1002;
        let t1013 = v2_4_z * t978 + (t248 * t975 + t249 * t962);
        let t1014 = c3 * t988 + (t246 * t991 + z2_4_y * t992) + t1013;
        let t1017 = c4 * t992 - s4 * t991;
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
        let t1019 = s7 * t216;
        let t1020 = c7 * t218 + t1019;
        let t1022 = c7 * t216;
        let t1023 = s7 * t218 - t1022;
        let t1026 = c6 * t1020 + s6 * t215;
        let t1029 = c6 * t215 - s6 * t1020;
        let t1034 = z1_4_y * t1029 + (t258 * t1026 + z1_6_z * t1023);
        let t1039 = z2_4_y * t1029 + (t264 * t1026 + t267 * t1023);
        let t1044 = c4 * t1029 + (z3_6_z * t1023 - z3_5_x * t1026);
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
        let t1049 = t1019 - c7 * t217;
        let t1051 = t1022 + s7 * t217;
        let t1054 = s6 * dw7_z - c6 * t1049;
        let t1057 = s6 * t1049 + c6 * dw7_z;
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
        let t1076 = t224 - t221;
        let t1079 = c7 * t225 - s7 * t226;
        let t1082 = s7 * t225 + c7 * t226;
        let t1085 = c6 * t1079 + s6 * t1076;
        let t1088 = c6 * t1076 - s6 * t1079;
        let t1093 = z1_4_y * t1088 + (t258 * t1085 + z1_6_z * t1082);
        let t1098 = z2_4_y * t1088 + (t264 * t1085 + t267 * t1082);
        let t1103 = c4 * t1088 - (z3_5_x * t1085 - z3_6_z * t1082);
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
        let t1108 = t878 + s7 * t220;
        let t1110 = t875 - c7 * t220;
        let t1113 = c6 * t1108 + s6 * t210;
        let t1116 = c6 * t210 - s6 * t1108;
        let t1121 = z1_4_y * t1116 + (t258 * t1113 + z1_6_z * t1110);
        let t1126 = z2_4_y * t1116 + (t264 * t1113 + t267 * t1110);
        let t1131 = c4 * t1116 - (z3_5_x * t1113 - z3_6_z * t1110);
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
        let t1135 = t224 - t184;
        let t1137 = t950 + c7 * t1135;
        let t1139 = s7 * t1135 - t947;
        let t1142 = c6 * t1137 + s6 * t207;
        let t1145 = c6 * t207 - s6 * t1137;
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
        let t1172 = -t95;
        let t1173 = -t175;
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
