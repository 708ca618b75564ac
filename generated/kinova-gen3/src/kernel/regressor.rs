//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil and Dombre, 12.4.
//!
//! 956 multiplications, 705 additions; 7 x 91, 280 of 637 structurally nonzero.

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
    // link 2: motion
    let [
        w2_x, w2_y, t2, t3, t5, t6, a2_z, t10,
        t12, t13, t14, dw2_x, dw2_y,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t2 = s2 * ddq1;
        let t3 = c2 * ddq1;
        let t5 = s2 * k0;
        let t6 = c2 * k0;
        let t7 = ddq1 * k1;
        let a2_z = dq1 * dq1 * k1;
        let t10 = t5 + c2 * t7;
        let t12 = t6 - s2 * t7;
        let t13 = dq2 * w2_y;
        let t14 = dq2 * w2_x;
        let dw2_x = t2 + t13;
        let dw2_y = t3 - t14;
        put(0, ddq1); // row 1, ZZ1
        put(61, dq1); // row 1, FV1
        put(63, k9); // row 1, FO1
        put(68, ddq2); // row 2, ZZ2
        put(70, t2); // row 2, XZ2
        put(71, t3); // row 2, YZ2
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
        [
        w2_x, w2_y, t2, t3, t5, t6, a2_z, t10,
        t12, t13, t14, dw2_x, dw2_y,
    ]
    };
    // link 3: motion
    let [
        w3_x, t22, t29, t30, t31, t32, t33, t34,
        t36, t37, a3_z, t46, t49, w3_z, t53, t54,
        dw3_z,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t22 = c3 * dq2 + s3 * w2_x;
        let t29 = w2_x * w2_x;
        let t30 = w2_y * w2_y;
        let t31 = dq2 * dq2;
        let t32 = w2_x * w2_y;
        let t33 = ddq2 - t32;
        let t34 = ddq2 + t32;
        let t36 = t14 - dw2_y;
        let t37 = t13 + dw2_x;
        let t41 = t10 - t33 * k2;
        let a3_z = (t29 + t31) * k2 - t12;
        let t43 = a2_z - t37 * k2;
        let t46 = c3 * t41 + s3 * t43;
        let t49 = c3 * t43 - s3 * t41;
        let w3_z = w2_y + dq3;
        let t53 = s3 * ddq2 - c3 * dw2_x + dq3 * t22;
        let t54 = c3 * ddq2 + s3 * dw2_x + dq3 * w3_x;
        let dw3_z = dw2_y + ddq3;
        put(67, t32); // row 2, YY2
        put(126, t46); // row 3, MSY3
        put(129, dw3_z); // row 3, ZZ3
        [
        w3_x, t22, t29, t30, t31, t32, t33, t34,
        t36, t37, a3_z, t46, t49, w3_z, t53, t54,
        dw3_z,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t68, t69, t70, t71, t72, t73,
        t74, t75, t76, t77, t78, t79, t80, t81,
        t82, t87, t91, a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t68 = w3_x * w3_x;
        let t69 = t22 * t22;
        let t70 = w3_z * w3_z;
        let t71 = w3_x * t22;
        let t72 = w3_x * w3_z;
        let t73 = t22 * w3_z;
        let t74 = t69 + t70;
        let t75 = dw3_z + t71;
        let t76 = t72 - t54;
        let t77 = dw3_z - t71;
        let t78 = t68 + t70;
        let t79 = t73 - t53;
        let t80 = t54 + t72;
        let t81 = t53 + t73;
        let t82 = t68 + t69;
        let t86 = t46 + t75 * k3;
        let t87 = t49 + t78 * k3;
        let t88 = a3_z - t81 * k3;
        let t91 = c4 * t86 - s4 * t88;
        let a4_y = c4 * t88 + s4 * t86;
        let w4_z = t22 + dq4;
        let dw4_x = dq4 * w4_y - (c4 * t53 - s4 * dw3_z);
        let dw4_y = c4 * dw3_z + s4 * t53 - dq4 * w4_x;
        let dw4_z = t54 + ddq4;
        put(127, t71); // row 3, XX3
        put(131, t79); // row 3, XZ3
        put(132, t76); // row 3, YZ3
        put(176, a4_y); // row 4, MSX4
        put(177, t91); // row 4, MSY4
        put(180, dw4_z); // row 4, ZZ4
        [
        w4_x, w4_y, t68, t69, t70, t71, t72, t73,
        t74, t75, t76, t77, t78, t79, t80, t81,
        t82, t87, t91, a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ]
    };
    // link 5: motion
    let [
        t103, t106, t113, t114, t115, t116, t117, t118,
        t119, t120, t121, t122, t123, t124, t125, t126,
        t127, a5_z, t136, a5_y, w5_z, t143, t144, dw5_z,
    ] = {
        let t103 = s5 * w4_z - c5 * w4_x;
        let t106 = c5 * w4_z + s5 * w4_x;
        let t113 = w4_x * w4_x;
        let t114 = w4_y * w4_y;
        let t115 = w4_z * w4_z;
        let t116 = w4_x * w4_y;
        let t117 = w4_x * w4_z;
        let t118 = w4_y * w4_z;
        let t119 = t114 + t115;
        let t120 = dw4_z - t116;
        let t121 = dw4_y + t117;
        let t122 = dw4_z + t116;
        let t123 = t113 + t115;
        let t124 = dw4_x - t118;
        let t125 = t117 - dw4_y;
        let t126 = dw4_x + t118;
        let t127 = t113 + t114;
        let t131 = t91 - t120 * k4;
        let a5_z = a4_y + t123 * k4;
        let t133 = t87 - t126 * k4;
        let t136 = c5 * t131 + s5 * t133;
        let a5_y = s5 * t131 - c5 * t133;
        let w5_z = w4_y + dq5;
        let t143 = dq5 * t106 - (c5 * dw4_x - s5 * dw4_z);
        let t144 = dq5 * t103 - (c5 * dw4_z + s5 * dw4_x);
        let dw5_z = dw4_y + ddq5;
        put(179, t116); // row 4, YY4
        put(182, t124); // row 4, XZ4
        put(183, t121); // row 4, YZ4
        put(217, a5_y); // row 5, MSX5
        put(218, t136); // row 5, MSY5
        put(221, dw5_z); // row 5, ZZ5
        [
        t103, t106, t113, t114, t115, t116, t117, t118,
        t119, t120, t121, t122, t123, t124, t125, t126,
        t127, a5_z, t136, a5_y, w5_z, t143, t144, dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t158, t159, t160, t161, t162, t163,
        t164, t165, t166, t167, t168, t169, t170, t171,
        t172, t177, t181, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ] = {
        let w6_x = s6 * w5_z - c6 * t103;
        let w6_y = c6 * w5_z + s6 * t103;
        let t158 = t103 * t103;
        let t159 = t106 * t106;
        let t160 = w5_z * w5_z;
        let t161 = t103 * t106;
        let t162 = t103 * w5_z;
        let t163 = t106 * w5_z;
        let t164 = t159 + t160;
        let t165 = t161 - dw5_z;
        let t166 = t144 - t162;
        let t167 = dw5_z + t161;
        let t168 = t158 + t160;
        let t169 = t163 - t143;
        let t170 = t144 + t162;
        let t171 = t143 + t163;
        let t172 = t158 + t159;
        let t176 = t136 - t165 * k5;
        let t177 = t168 * k5 - a5_y;
        let t178 = a5_z - t171 * k5;
        let t181 = c6 * t176 - s6 * t178;
        let a6_y = c6 * t178 + s6 * t176;
        let w6_z = t106 + dq6;
        let dw6_x = s6 * dw5_z - c6 * t143 + dq6 * w6_y;
        let dw6_y = c6 * dw5_z + s6 * t143 - dq6 * w6_x;
        let dw6_z = ddq6 - t144;
        put(220, t161); // row 5, YY5
        put(223, t169); // row 5, XZ5
        put(224, t166); // row 5, YZ5
        put(248, a6_y); // row 6, MSX6
        put(249, t181); // row 6, MSY6
        put(252, dw6_z); // row 6, ZZ6
        [
        w6_x, w6_y, t158, t159, t160, t161, t162, t163,
        t164, t165, t166, t167, t168, t169, t170, t171,
        t172, t177, t181, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ]
    };
    // link 7: motion
    let [
        w7_x, t196, t203, t204, t205, t206, t207, t208,
        t209, t210, t211, t212, t213, t214, t215, t216,
        t217, a7_z, t226, a7_y, w7_z, t233, t234, dw7_z,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t196 = c7 * w6_z + s7 * w6_x;
        let t203 = w6_x * w6_x;
        let t204 = w6_y * w6_y;
        let t205 = w6_z * w6_z;
        let t206 = w6_x * w6_y;
        let t207 = w6_x * w6_z;
        let t208 = w6_y * w6_z;
        let t209 = t204 + t205;
        let t210 = dw6_z - t206;
        let t211 = dw6_y + t207;
        let t212 = dw6_z + t206;
        let t213 = t203 + t205;
        let t214 = dw6_x - t208;
        let t215 = dw6_y - t207;
        let t216 = dw6_x + t208;
        let t217 = t203 + t204;
        let t221 = t181 - t210 * k6;
        let a7_z = a6_y + t213 * k6;
        let t223 = t177 - t216 * k6;
        let t226 = c7 * t221 + s7 * t223;
        let a7_y = s7 * t221 - c7 * t223;
        let w7_z = w6_y + dq7;
        let t233 = s7 * dw6_z - c7 * dw6_x + dq7 * t196;
        let t234 = c7 * dw6_z + s7 * dw6_x + dq7 * w7_x;
        let dw7_z = dw6_y + ddq7;
        put(251, t206); // row 6, YY6
        put(254, t214); // row 6, XZ6
        put(255, t211); // row 6, YZ6
        put(269, a7_y); // row 7, MSX7
        put(270, t226); // row 7, MSY7
        put(273, dw7_z); // row 7, ZZ7
        [
        w7_x, t196, t203, t204, t205, t206, t207, t208,
        t209, t210, t211, t212, t213, t214, t215, t216,
        t217, a7_z, t226, a7_y, w7_z, t233, t234, dw7_z,
    ]
    };
    // joint axes in frame 2
    let [t236, v1_2_y] = {
        let t236 = c2 * k1;
        let v1_2_y = s2 * k1;
        [t236, v1_2_y]
    };
    // joint axes in frame 3
    let [z1_3_x, z1_4_z, t243, v1_3_y, v2_3_x, v2_4_z] = {
        let t238 = s2 * k2;
        let z1_3_x = s2 * c3;
        let z1_4_z = s2 * s3;
        let t243 = c3 * t236 - s3 * t238;
        let v1_3_y = c3 * t238 + s3 * t236;
        let v2_3_x = c3 * k2;
        let v2_4_z = s3 * k2;
        [z1_3_x, z1_4_z, t243, v1_3_y, v2_3_x, v2_4_z]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, t255, z2_4_y, t257, t258, t261, t264] = {
        let z1_4_x = c4 * z1_3_x + c2 * s4;
        let z1_4_y = c2 * c4 - s4 * z1_3_x;
        let t255 = s3 * c4;
        let z2_4_y = s3 * s4;
        let t257 = c4 * v2_3_x;
        let t258 = s4 * v2_3_x;
        let t261 = c4 * t243 - s4 * v1_2_y;
        let t264 = c4 * v1_2_y + s4 * t243;
        [z1_4_x, z1_4_y, t255, z2_4_y, t257, t258, t261, t264]
    };
    // joint axes in frame 5
    let [t267, z1_6_z, t273, t276, z3_5_x, z3_6_z] = {
        let t267 = s5 * z1_4_z - c5 * z1_4_x;
        let z1_6_z = c5 * z1_4_z + s5 * z1_4_x;
        let t273 = c5 * t255 + c3 * s5;
        let t276 = c3 * c5 - s5 * t255;
        let z3_5_x = s4 * c5;
        let z3_6_z = s4 * s5;
        [t267, z1_6_z, t273, t276, z3_5_x, z3_6_z]
    };
    // MSZ2: column
    let [t281, t282] = {
        let t281 = s2 * t6 - c2 * t5;
        let t282 = k1 * t281;
        [t281, t282]
    };
    // XX2: column
    let [t284, t285] = {
        let t284 = c2 * t14;
        let t285 = s2 * dw2_x + t284;
        put(5, t285); // row 1, XX2
        [t284, t285]
    };
    // YY2: column
    let [t286, t289] = {
        let t286 = s2 * t13;
        let t288 = c2 * dw2_y - t286;
        let t289 = t285 + t288;
        let t291 = t289 * k7 - t282;
        put(1, t291); // row 1, M2
        put(6, t288); // row 1, YY2
        [t286, t289]
    };
    // XZ2: column
    {
        let t295 = s2 * t34 - c2 * (t29 - t31);
        let t296 = k1 * t295;
        let t298 = t2 * k1 - t6;
        put(2, t296); // row 1, MSX2
        put(9, t295); // row 1, XZ2
        put(64, t298); // row 2, MSX2
    }
    // YZ2: column
    {
        let t302 = s2 * (t30 - t31) + c2 * t33;
        let t303 = k1 * t302;
        let t305 = t5 + t3 * k1;
        put(3, t303); // row 1, MSY2
        put(10, t302); // row 1, YZ2
        put(65, t305); // row 2, MSY2
    }
    // YY2: column
    {
        let t307 = t281 - t289 * k8;
        put(4, t307); // row 1, MSZ2
    }
    // ZZ2: column
    {
        let t308 = t286 - t284;
        put(7, t308); // row 1, ZZ2
    }
    // XY2: column
    {
        let t309 = t29 - t30;
        let t312 = c2 * t37 - s2 * t36;
        put(8, t312); // row 1, XY2
        put(69, t309); // row 2, XY2
    }
    // M3: column
    {
        let t317 = a3_z * v1_2_y + (t46 * t243 - t49 * v1_3_y);
        let t320 = t49 * v2_4_z - t46 * v2_3_x;
        put(11, t317); // row 1, M3
        put(72, t320); // row 2, M3
    }
    // MSX3: column
    {
        let t328 = t80 * v1_2_y + (t74 * t243 + t77 * v1_3_y);
        let t329 = a3_z * z1_4_z - c2 * t49 + t328;
        let t334 = c3 * a3_z - (t74 * v2_3_x + t77 * v2_4_z);
        put(12, t329); // row 1, MSX3
        put(73, t334); // row 2, MSX3
    }
    // MSY3: column
    {
        let t342 = t81 * v1_2_y - (t75 * t243 - t78 * v1_3_y);
        let t343 = a3_z * z1_3_x + c2 * t46 - t342;
        let t348 = t78 * v2_4_z - t75 * v2_3_x - s3 * a3_z;
        put(13, t343); // row 1, MSY3
        put(74, t348); // row 2, MSY3
    }
    // MSZ3: column
    {
        let t356 = t82 * v1_2_y + (t76 * t243 + t79 * v1_3_y);
        let t357 = t49 * z1_3_x + t46 * z1_4_z - t356;
        let t364 = c3 * t46 - s3 * t49 + (t76 * v2_3_x + t79 * v2_4_z);
        put(14, t357); // row 1, MSZ3
        put(75, t364); // row 2, MSZ3
    }
    // XX3: column
    let [t366, t367, t371] = {
        let t366 = t72 * z1_4_z;
        let t367 = c2 * t71;
        let t369 = t367 - (t53 * z1_3_x + t366);
        let t371 = c3 * t72;
        let t372 = s3 * t53 - t371;
        put(15, t369); // row 1, XX3
        put(76, t372); // row 2, XX3
        [t366, t367, t371]
    };
    // YY3: column
    let [t373, t377] = {
        let t373 = t73 * z1_3_x;
        let t376 = t373 + t54 * z1_4_z - t367;
        let t377 = s3 * t73;
        let t379 = c3 * t54 - t377;
        put(16, t376); // row 1, YY3
        put(77, t379); // row 2, YY3
        [t373, t377]
    };
    // ZZ3: column
    {
        let t382 = c2 * dw3_z + (t366 - t373);
        let t383 = t371 + t377;
        put(17, t382); // row 1, ZZ3
        put(78, t383); // row 2, ZZ3
    }
    // XY3: column
    {
        let t384 = t68 - t69;
        let t389 = c2 * t384 + (t81 * z1_4_z - t80 * z1_3_x);
        let t392 = s3 * t80 + c3 * t81;
        put(18, t389); // row 1, XY3
        put(79, t392); // row 2, XY3
        put(130, t384); // row 3, XY3
    }
    // XZ3: column
    {
        let t393 = t68 - t70;
        let t398 = c2 * t79 + (t77 * z1_3_x + z1_4_z * t393);
        let t401 = c3 * t393 - s3 * t77;
        put(19, t398); // row 1, XZ3
        put(80, t401); // row 2, XZ3
    }
    // YZ3: column
    {
        let t402 = t70 - t69;
        let t407 = c2 * t76 - (z1_3_x * t402 + t75 * z1_4_z);
        let t410 = s3 * t402 - c3 * t75;
        put(20, t407); // row 1, YZ3
        put(81, t410); // row 2, YZ3
    }
    // M4: column
    let [t413, t416] = {
        let t413 = c4 * t91 + s4 * a4_y;
        let t416 = s4 * t91 - c4 * a4_y;
        let t417 = k3 * t416;
        let t418 = k3 * t413;
        let t426 = v1_2_y * t416 - (t243 * t413 - t87 * v1_3_y);
        let t427 = c2 * t418 - z1_3_x * t417 - t426;
        let t432 = s3 * t417 - (v2_3_x * t413 - t87 * v2_4_z);
        put(21, t427); // row 1, M4
        put(82, t432); // row 2, M4
        put(133, t418); // row 3, M4
        [t413, t416]
    };
    // MSX4: column
    let [t434, t439, t440] = {
        let t434 = s4 * t122;
        let t435 = c4 * t119 + t434;
        let t438 = c4 * t122 - s4 * t119;
        let t439 = s4 * t87;
        let t440 = c4 * t87;
        let t443 = t439 + k3 * t438;
        let t444 = k3 * t435 - t440;
        let t454 = v1_2_y * t438 + (t243 * t435 - t125 * v1_3_y);
        let t455 = c2 * t444 + (z1_3_x * t443 + a4_y * z1_4_z) + t454;
        let t462 = t125 * v2_4_z - v2_3_x * t435 - (s3 * t443 - c3 * a4_y);
        put(22, t455); // row 1, MSX4
        put(83, t462); // row 2, MSX4
        put(134, t444); // row 3, MSX4
        [t434, t439, t440]
    };
    // MSY4: column
    let t463 = {
        let t463 = c4 * t120;
        let t465 = s4 * t123 - t463;
        let t468 = s4 * t120 + c4 * t123;
        let t471 = k3 * t468 - t440;
        let t472 = t439 - k3 * t465;
        let t482 = v1_2_y * t468 + (t243 * t465 + t126 * v1_3_y);
        let t483 = c2 * t472 + (t91 * z1_4_z - z1_3_x * t471) - t482;
        let t490 = s3 * t471 + c3 * t91 + (v2_3_x * t465 + t126 * v2_4_z);
        put(23, t483); // row 1, MSY4
        put(84, t490); // row 2, MSY4
        put(135, t472); // row 3, MSY4
        t463
    };
    // MSZ4: column
    let t500 = {
        let t493 = c4 * t121 + s4 * t124;
        let t496 = s4 * t121 - c4 * t124;
        let t499 = t416 + k3 * t496;
        let t500 = t413 + k3 * t493;
        let t508 = v1_2_y * t496 + (t127 * v1_3_y - t243 * t493);
        let t509 = z1_3_x * t499 - c2 * t500 + t508;
        let t514 = v2_3_x * t493 - t127 * v2_4_z - s3 * t499;
        put(24, t509); // row 1, MSZ4
        put(85, t514); // row 2, MSZ4
        t500
    };
    // XX4: column
    let [t516, t517, t521, t522, t526] = {
        let t516 = t117 * z1_4_y;
        let t517 = t116 * z1_4_z;
        let t519 = dw4_x * z1_4_x + t516 - t517;
        let t521 = t117 * z2_4_y;
        let t522 = c3 * t116;
        let t524 = t521 - dw4_x * t255 - t522;
        let t526 = c4 * t117;
        let t527 = s4 * dw4_x + t526;
        put(25, t519); // row 1, XX4
        put(86, t524); // row 2, XX4
        put(137, t527); // row 3, XX4
        [t516, t517, t521, t522, t526]
    };
    // YY4: column
    let [t528, t532, t536] = {
        let t528 = t118 * z1_4_x;
        let t531 = t517 - (t528 - dw4_y * z1_4_y);
        let t532 = t118 * t255;
        let t535 = t522 + (t532 + dw4_y * z2_4_y);
        let t536 = s4 * t118;
        let t538 = c4 * dw4_y - t536;
        put(26, t531); // row 1, YY4
        put(87, t535); // row 2, YY4
        put(138, t538); // row 3, YY4
        [t528, t532, t536]
    };
    // ZZ4: column
    {
        let t541 = dw4_z * z1_4_z - (t516 - t528);
        let t544 = c3 * dw4_z - (t521 + t532);
        let t545 = t536 - t526;
        put(27, t541); // row 1, ZZ4
        put(88, t544); // row 2, ZZ4
        put(139, t545); // row 3, ZZ4
    }
    // XY4: column
    {
        let t546 = t113 - t114;
        let t551 = z1_4_z * t546 - (t125 * z1_4_x - t126 * z1_4_y);
        let t556 = c3 * t546 + (t125 * t255 + t126 * z2_4_y);
        let t559 = c4 * t126 - s4 * t125;
        put(28, t551); // row 1, XY4
        put(89, t556); // row 2, XY4
        put(140, t559); // row 3, XY4
        put(181, t546); // row 4, XY4
    }
    // XZ4: column
    {
        let t560 = t113 - t115;
        let t565 = t124 * z1_4_z + (t122 * z1_4_x - z1_4_y * t560);
        let t570 = c3 * t124 - (t122 * t255 + z2_4_y * t560);
        let t572 = t434 - c4 * t560;
        put(29, t565); // row 1, XZ4
        put(90, t570); // row 2, XZ4
        put(141, t572); // row 3, XZ4
    }
    // YZ4: column
    {
        let t573 = t114 - t115;
        let t578 = t121 * z1_4_z + (z1_4_x * t573 + t120 * z1_4_y);
        let t583 = c3 * t121 + (t120 * z2_4_y - t255 * t573);
        let t585 = t463 + s4 * t573;
        put(30, t578); // row 1, YZ4
        put(91, t583); // row 2, YZ4
        put(142, t585); // row 3, YZ4
    }
    // M5: column
    let [t588, t591, t593] = {
        let t588 = c5 * t136 + s5 * a5_y;
        let t591 = s5 * t136 - c5 * a5_y;
        let t593 = k4 * t588;
        let t595 = k3 * t588;
        let t596 = k4 * t591 - k3 * a5_z;
        let t606 = v1_3_y * t591 - (t261 * t588 + a5_z * t264);
        let t607 = z1_4_y * t595 - z1_4_x * t596 - z1_4_z * t593 - t606;
        let t612 = c3 * t593 - (t255 * t596 + z2_4_y * t595);
        let t618 = v2_4_z * t591 - (t257 * t588 + a5_z * t258) - t612;
        let t621 = c4 * t595 - s4 * t596;
        put(31, t607); // row 1, M5
        put(92, t618); // row 2, M5
        put(143, t621); // row 3, M5
        [t588, t591, t593]
    };
    // MSX5: column
    let [t623, t628, t629] = {
        let t623 = s5 * t167;
        let t624 = c5 * t164 + t623;
        let t627 = c5 * t167 - s5 * t164;
        let t628 = s5 * a5_z;
        let t629 = c5 * a5_z;
        let t633 = t629 - k4 * t624;
        let t636 = k3 * t170 - (t628 + k4 * t627);
        let t637 = a5_y + k3 * t624;
        let t647 = t170 * t264 - t261 * t624 - v1_3_y * t627;
        let t648 = z1_4_z * t633 - (z1_4_x * t636 - z1_4_y * t637) - t647;
        let t658 = t170 * t258 - t257 * t624 - v2_4_z * t627;
        let t659 = c3 * t633 + (t255 * t636 + z2_4_y * t637) + t658;
        let t662 = c4 * t637 - s4 * t636;
        put(32, t648); // row 1, MSX5
        put(93, t659); // row 2, MSX5
        put(144, t662); // row 3, MSX5
        put(185, t633); // row 4, MSX5
        [t623, t628, t629]
    };
    // MSY5: column
    let t663 = {
        let t663 = c5 * t165;
        let t665 = t663 + s5 * t168;
        let t668 = s5 * t165 - c5 * t168;
        let t672 = k4 * t665 - t628;
        let t675 = t629 + k4 * t668 - k3 * t171;
        let t676 = k3 * t665 - t136;
        let t686 = t261 * t665 + t171 * t264 - v1_3_y * t668;
        let t687 = z1_4_z * t672 - (z1_4_y * t676 - z1_4_x * t675) - t686;
        let t697 = v2_4_z * t668 - (t257 * t665 + t171 * t258);
        let t698 = c3 * t672 - (t255 * t675 + z2_4_y * t676) - t697;
        let t701 = s4 * t675 - c4 * t676;
        put(33, t687); // row 1, MSY5
        put(94, t698); // row 2, MSY5
        put(145, t701); // row 3, MSY5
        put(186, t672); // row 4, MSY5
        t663
    };
    // MSZ5: column
    {
        let t704 = c5 * t166 + s5 * t169;
        let t707 = s5 * t166 - c5 * t169;
        let t711 = t588 + k4 * t704;
        let t713 = k3 * t704;
        let t714 = t591 + k4 * t707 - k3 * t172;
        let t724 = t261 * t704 + t172 * t264 - v1_3_y * t707;
        let t725 = z1_4_z * t711 - (z1_4_y * t713 - z1_4_x * t714) - t724;
        let t735 = t257 * t704 + t172 * t258 - v2_4_z * t707;
        let t736 = c3 * t711 - (t255 * t714 + z2_4_y * t713) + t735;
        let t739 = s4 * t714 - c4 * t713;
        put(34, t725); // row 1, MSZ5
        put(95, t736); // row 2, MSZ5
        put(146, t739); // row 3, MSZ5
        put(187, t711); // row 4, MSZ5
    }
    // XX5: column
    let [t741, t742, t746, t747, t751, t752, t756] = {
        let t741 = t162 * z1_6_z;
        let t742 = t161 * z1_4_y;
        let t744 = t143 * t267 + t741 - t742;
        let t746 = t162 * t276;
        let t747 = t161 * z2_4_y;
        let t749 = t143 * t273 + t746 - t747;
        let t751 = t162 * z3_6_z;
        let t752 = c4 * t161;
        let t754 = t751 - t143 * z3_5_x - t752;
        let t756 = c5 * t162;
        let t757 = s5 * t143 + t756;
        put(35, t744); // row 1, XX5
        put(96, t749); // row 2, XX5
        put(147, t754); // row 3, XX5
        put(188, t757); // row 4, XX5
        [t741, t742, t746, t747, t751, t752, t756]
    };
    // YY5: column
    let [t758, t762, t766, t770, t772] = {
        let t758 = t163 * t267;
        let t761 = t742 - (t758 + t144 * z1_6_z);
        let t762 = t163 * t273;
        let t765 = t747 - (t762 + t144 * t276);
        let t766 = t163 * z3_5_x;
        let t769 = t752 + (t766 - t144 * z3_6_z);
        let t770 = s5 * t163;
        let t772 = t770 + c5 * t144;
        put(36, t761); // row 1, YY5
        put(97, t765); // row 2, YY5
        put(148, t769); // row 3, YY5
        [t758, t762, t766, t770, t772]
    };
    // ZZ5: column
    {
        let t775 = dw5_z * z1_4_y + (t758 - t741);
        let t778 = dw5_z * z2_4_y + (t762 - t746);
        let t781 = c4 * dw5_z - (t751 + t766);
        let t782 = t770 - t756;
        put(37, t775); // row 1, ZZ5
        put(98, t778); // row 2, ZZ5
        put(149, t781); // row 3, ZZ5
        put(190, t782); // row 4, ZZ5
    }
    // XY5: column
    {
        let t783 = t158 - t159;
        let t788 = z1_4_y * t783 + (t171 * z1_6_z - t170 * t267);
        let t793 = z2_4_y * t783 - (t170 * t273 - t171 * t276);
        let t798 = c4 * t783 + (t170 * z3_5_x + t171 * z3_6_z);
        let t801 = c5 * t171 - s5 * t170;
        put(38, t788); // row 1, XY5
        put(99, t793); // row 2, XY5
        put(150, t798); // row 3, XY5
        put(191, t801); // row 4, XY5
        put(222, t783); // row 5, XY5
    }
    // XZ5: column
    {
        let t802 = t158 - t160;
        let t807 = t169 * z1_4_y - (t167 * t267 - z1_6_z * t802);
        let t812 = t169 * z2_4_y + (t276 * t802 - t167 * t273);
        let t817 = c4 * t169 + (t167 * z3_5_x + z3_6_z * t802);
        let t819 = c5 * t802 - t623;
        put(39, t807); // row 1, XZ5
        put(100, t812); // row 2, XZ5
        put(151, t817); // row 3, XZ5
        put(192, t819); // row 4, XZ5
    }
    // YZ5: column
    {
        let t820 = t160 - t159;
        let t825 = t166 * z1_4_y + (t267 * t820 + t165 * z1_6_z);
        let t830 = t166 * z2_4_y + (t273 * t820 + t165 * t276);
        let t835 = c4 * t166 + (t165 * z3_6_z - z3_5_x * t820);
        let t837 = t663 + s5 * t820;
        put(40, t825); // row 1, YZ5
        put(101, t830); // row 2, YZ5
        put(152, t835); // row 3, YZ5
        put(193, t837); // row 4, YZ5
    }
    // M6: column
    let [t840, t843] = {
        let t840 = c6 * t181 + s6 * a6_y;
        let t843 = c6 * a6_y - s6 * t181;
        let t844 = k5 * t843;
        let t845 = k5 * t840;
        let t848 = s5 * t177 - c5 * t840;
        let t851 = s5 * t840 + c5 * t177;
        let t857 = k4 * t848 - s5 * t844;
        let t860 = k3 * t843 - (k4 * t851 - c5 * t844);
        let t861 = t845 - k3 * t848;
        let t871 = v1_3_y * t851 + (t261 * t848 - t264 * t843);
        let t872 = z1_4_z * t857 + (z1_4_x * t860 + z1_4_y * t861) - t871;
        let t877 = t255 * t860 - z2_4_y * t861 - c3 * t857;
        let t883 = v2_4_z * t851 + (t257 * t848 - t258 * t843) - t877;
        let t886 = s4 * t860 + c4 * t861;
        put(41, t872); // row 1, M6
        put(102, t883); // row 2, M6
        put(153, t886); // row 3, M6
        put(194, t857); // row 4, M6
        put(225, t845); // row 5, M6
        [t840, t843]
    };
    // MSX6: column
    let [t888, t891, t893, t894] = {
        let t888 = s6 * t212;
        let t889 = c6 * t209 + t888;
        let t891 = c6 * t212;
        let t892 = t891 - s6 * t209;
        let t893 = s6 * t177;
        let t894 = c6 * t177;
        let t897 = t893 + k5 * t892;
        let t898 = k5 * t889 - t894;
        let t901 = c5 * t889 + s5 * t215;
        let t904 = c5 * t215 - s5 * t889;
        let t914 = c5 * a6_y - s5 * t897 - k4 * t901;
        let t917 = c5 * t897 + s5 * a6_y + k4 * t904 + k3 * t892;
        let t918 = t898 + k3 * t901;
        let t928 = v1_3_y * t904 + (t261 * t901 + t264 * t892);
        let t929 = z1_4_z * t914 + (z1_4_x * t917 + z1_4_y * t918) + t928;
        let t939 = v2_4_z * t904 + (t257 * t901 + t258 * t892);
        let t940 = c3 * t914 - (t255 * t917 - z2_4_y * t918) - t939;
        let t943 = s4 * t917 + c4 * t918;
        put(42, t929); // row 1, MSX6
        put(103, t940); // row 2, MSX6
        put(154, t943); // row 3, MSX6
        put(195, t914); // row 4, MSX6
        put(226, t898); // row 5, MSX6
        [t888, t891, t893, t894]
    };
    // MSY6: column
    let [t944, t947] = {
        let t944 = c6 * t210;
        let t946 = s6 * t213 - t944;
        let t947 = s6 * t210;
        let t949 = t947 + c6 * t213;
        let t952 = k5 * t949 - t894;
        let t953 = t893 - k5 * t946;
        let t956 = c5 * t946 + s5 * t216;
        let t959 = s5 * t946 - c5 * t216;
        let t969 = s5 * t952 + c5 * t181 + k4 * t956;
        let t972 = k4 * t959 - (c5 * t952 - s5 * t181) - k3 * t949;
        let t973 = t953 - k3 * t956;
        let t983 = t261 * t956 + t264 * t949 - v1_3_y * t959;
        let t984 = z1_4_z * t969 + (z1_4_x * t972 + z1_4_y * t973) - t983;
        let t994 = t257 * t956 + t258 * t949 - v2_4_z * t959;
        let t995 = c3 * t969 - (t255 * t972 - z2_4_y * t973) + t994;
        let t998 = s4 * t972 + c4 * t973;
        put(43, t984); // row 1, MSY6
        put(104, t995); // row 2, MSY6
        put(155, t998); // row 3, MSY6
        put(196, t969); // row 4, MSY6
        put(227, t953); // row 5, MSY6
        [t944, t947]
    };
    // MSZ6: column
    let t1008 = {
        let t1001 = c6 * t211 + s6 * t214;
        let t1004 = c6 * t214 - s6 * t211;
        let t1007 = t843 + k5 * t1004;
        let t1008 = t840 + k5 * t1001;
        let t1011 = s5 * t217 - c5 * t1001;
        let t1014 = s5 * t1001 + c5 * t217;
        let t1020 = s5 * t1007 - k4 * t1011;
        let t1023 = k3 * t1004 - (k4 * t1014 - c5 * t1007);
        let t1024 = k3 * t1011 - t1008;
        let t1034 = t264 * t1004 - t261 * t1011 - v1_3_y * t1014;
        let t1035 = z1_4_z * t1020 - (z1_4_x * t1023 - z1_4_y * t1024) - t1034;
        let t1045 = v2_4_z * t1014 + (t257 * t1011 - t258 * t1004);
        let t1046 = c3 * t1020 + (t255 * t1023 + z2_4_y * t1024) - t1045;
        let t1049 = c4 * t1024 - s4 * t1023;
        put(44, t1035); // row 1, MSZ6
        put(105, t1046); // row 2, MSZ6
        put(156, t1049); // row 3, MSZ6
        put(197, t1020); // row 4, MSZ6
        t1008
    };
    // XX6: column
    let [t1051, t1054, t1057, t1062, t1067, t1072] = {
        let t1051 = s6 * t207;
        let t1052 = t1051 - c6 * dw6_x;
        let t1054 = c6 * t207;
        let t1055 = s6 * dw6_x + t1054;
        let t1057 = t206 * z1_6_z;
        let t1060 = z1_4_y * t1055 - (t1057 - t267 * t1052);
        let t1062 = t206 * t276;
        let t1065 = z2_4_y * t1055 + (t273 * t1052 - t1062);
        let t1067 = t206 * z3_6_z;
        let t1070 = c4 * t1055 - (z3_5_x * t1052 + t1067);
        let t1072 = c5 * t206;
        let t1073 = s5 * t1052 - t1072;
        put(45, t1060); // row 1, XX6
        put(106, t1065); // row 2, XX6
        put(157, t1070); // row 3, XX6
        put(198, t1073); // row 4, XX6
        put(229, t1055); // row 5, XX6
        [t1051, t1054, t1057, t1062, t1067, t1072]
    };
    // YY6: column
    let [t1074, t1077] = {
        let t1074 = c6 * t208;
        let t1076 = t1074 + s6 * dw6_y;
        let t1077 = s6 * t208;
        let t1079 = c6 * dw6_y - t1077;
        let t1083 = z1_4_y * t1079 + (t1057 + t267 * t1076);
        let t1087 = z2_4_y * t1079 + (t1062 + t273 * t1076);
        let t1091 = c4 * t1079 - (z3_5_x * t1076 - t1067);
        let t1093 = t1072 + s5 * t1076;
        put(46, t1083); // row 1, YY6
        put(107, t1087); // row 2, YY6
        put(158, t1091); // row 3, YY6
        put(199, t1093); // row 4, YY6
        put(230, t1079); // row 5, YY6
        [t1074, t1077]
    };
    // ZZ6: column
    {
        let t1094 = t1051 + t1074;
        let t1095 = t1077 - t1054;
        let t1100 = z1_4_y * t1095 - (t267 * t1094 - dw6_z * z1_6_z);
        let t1105 = z2_4_y * t1095 + (dw6_z * t276 - t273 * t1094);
        let t1110 = c4 * t1095 + (z3_5_x * t1094 + dw6_z * z3_6_z);
        let t1113 = c5 * dw6_z - s5 * t1094;
        put(47, t1100); // row 1, ZZ6
        put(108, t1105); // row 2, ZZ6
        put(159, t1110); // row 3, ZZ6
        put(200, t1113); // row 4, ZZ6
        put(231, t1095); // row 5, ZZ6
    }
    // XY6: column
    {
        let t1114 = t203 - t204;
        let t1117 = s6 * t216 - c6 * t215;
        let t1120 = s6 * t215 + c6 * t216;
        let t1125 = z1_4_y * t1120 + (t267 * t1117 + z1_6_z * t1114);
        let t1130 = z2_4_y * t1120 + (t273 * t1117 + t276 * t1114);
        let t1135 = c4 * t1120 - (z3_5_x * t1117 - z3_6_z * t1114);
        let t1138 = s5 * t1117 + c5 * t1114;
        put(48, t1125); // row 1, XY6
        put(109, t1130); // row 2, XY6
        put(160, t1135); // row 3, XY6
        put(201, t1138); // row 4, XY6
        put(232, t1120); // row 5, XY6
        put(253, t1114); // row 6, XY6
    }
    // XZ6: column
    {
        let t1139 = t205 - t203;
        let t1141 = s6 * t1139 - t891;
        let t1143 = t888 + c6 * t1139;
        let t1148 = z1_4_y * t1143 + (t267 * t1141 + t214 * z1_6_z);
        let t1153 = z2_4_y * t1143 + (t273 * t1141 + t214 * t276);
        let t1158 = c4 * t1143 + (t214 * z3_6_z - z3_5_x * t1141);
        let t1161 = s5 * t1141 + c5 * t214;
        put(49, t1148); // row 1, XZ6
        put(110, t1153); // row 2, XZ6
        put(161, t1158); // row 3, XZ6
        put(202, t1161); // row 4, XZ6
        put(233, t1143); // row 5, XZ6
    }
    // YZ6: column
    {
        let t1162 = t204 - t205;
        let t1164 = t947 - c6 * t1162;
        let t1166 = t944 + s6 * t1162;
        let t1171 = z1_4_y * t1166 + (t267 * t1164 + t211 * z1_6_z);
        let t1176 = z2_4_y * t1166 + (t273 * t1164 + t211 * t276);
        let t1181 = c4 * t1166 + (t211 * z3_6_z - z3_5_x * t1164);
        let t1184 = s5 * t1164 + c5 * t211;
        put(50, t1171); // row 1, YZ6
        put(111, t1176); // row 2, YZ6
        put(162, t1181); // row 3, YZ6
        put(203, t1184); // row 4, YZ6
        put(234, t1166); // row 5, YZ6
    }
    // M7: column
    let [
        t1185, t1186, t1187, t1188, t1189, t1190, t1191, t1192,
        t1193, t1194, t1195, t1196, t1197, t1198, t1199, t1202,
        t1205, t1207,
    ] = {
        let t1185 = w7_x * w7_x;
        let t1186 = t196 * t196;
        let t1187 = w7_z * w7_z;
        let t1188 = w7_x * t196;
        let t1189 = w7_x * w7_z;
        let t1190 = t196 * w7_z;
        let t1191 = t1186 + t1187;
        let t1192 = dw7_z + t1188;
        let t1193 = t1189 - t234;
        let t1194 = t1188 - dw7_z;
        let t1195 = t1185 + t1187;
        let t1196 = t1190 - t233;
        let t1197 = t234 + t1189;
        let t1198 = t233 + t1190;
        let t1199 = t1185 + t1186;
        let t1202 = c7 * t226 + s7 * a7_y;
        let t1205 = s7 * t226 - c7 * a7_y;
        let t1206 = k6 * t1205;
        let t1207 = k6 * t1202;
        let t1210 = c6 * t1202 + s6 * a7_z;
        let t1213 = c6 * a7_z - s6 * t1202;
        let t1218 = c6 * t1206 - k5 * t1213;
        let t1219 = k5 * t1210 - s6 * t1206;
        let t1222 = s5 * t1205 - c5 * t1210;
        let t1225 = s5 * t1210 + c5 * t1205;
        let t1235 = s5 * t1218 - c5 * t1207 + k4 * t1222;
        let t1238 = k3 * t1213 - (c5 * t1218 + s5 * t1207 + k4 * t1225);
        let t1239 = t1219 - k3 * t1222;
        let t1249 = t264 * t1213 - t261 * t1222 - v1_3_y * t1225;
        let t1250 = z1_4_z * t1235 + (z1_4_x * t1238 + z1_4_y * t1239) + t1249;
        let t1255 = t255 * t1238 - z2_4_y * t1239 - c3 * t1235;
        let t1261 = v2_4_z * t1225 + (t257 * t1222 - t258 * t1213) - t1255;
        let t1264 = s4 * t1238 + c4 * t1239;
        put(51, t1250); // row 1, M7
        put(112, t1261); // row 2, M7
        put(163, t1264); // row 3, M7
        put(204, t1235); // row 4, M7
        put(235, t1219); // row 5, M7
        put(271, t1188); // row 7, XX7
        put(275, t1196); // row 7, XZ7
        put(276, t1193); // row 7, YZ7
        [
        t1185, t1186, t1187, t1188, t1189, t1190, t1191, t1192,
        t1193, t1194, t1195, t1196, t1197, t1198, t1199, t1202,
        t1205, t1207,
    ]
    };
    // MSX7: column
    let [t1266, t1269, t1271, t1272] = {
        let t1266 = s7 * t1194;
        let t1267 = t1266 - c7 * t1191;
        let t1269 = c7 * t1194;
        let t1270 = s7 * t1191 + t1269;
        let t1271 = s7 * a7_z;
        let t1272 = c7 * a7_z;
        let t1275 = t1271 - k6 * t1270;
        let t1276 = t1272 + k6 * t1267;
        let t1279 = s6 * t1197 - c6 * t1267;
        let t1282 = s6 * t1267 + c6 * t1197;
        let t1291 = c6 * t1275 - s6 * a7_y + k5 * t1282;
        let t1292 = s6 * t1275 + c6 * a7_y + k5 * t1279;
        let t1295 = c5 * t1279 - s5 * t1270;
        let t1298 = s5 * t1279 + c5 * t1270;
        let t1308 = c5 * t1276 - s5 * t1291 - k4 * t1295;
        let t1311 = c5 * t1291 + s5 * t1276 - k4 * t1298 + k3 * t1282;
        let t1312 = t1292 + k3 * t1295;
        let t1322 = v1_3_y * t1298 - (t261 * t1295 + t264 * t1282);
        let t1323 = z1_4_z * t1308 + (z1_4_x * t1311 + z1_4_y * t1312) - t1322;
        let t1333 = t257 * t1295 + t258 * t1282 - v2_4_z * t1298;
        let t1334 = c3 * t1308 - (t255 * t1311 - z2_4_y * t1312) - t1333;
        let t1337 = s4 * t1311 + c4 * t1312;
        put(52, t1323); // row 1, MSX7
        put(113, t1334); // row 2, MSX7
        put(164, t1337); // row 3, MSX7
        put(205, t1308); // row 4, MSX7
        put(236, t1292); // row 5, MSX7
        put(257, t1276); // row 6, MSX7
        [t1266, t1269, t1271, t1272]
    };
    // MSY7: column
    let [t1338, t1341] = {
        let t1338 = c7 * t1192;
        let t1340 = s7 * t1195 - t1338;
        let t1341 = s7 * t1192;
        let t1343 = t1341 + c7 * t1195;
        let t1346 = k6 * t1343 - t1272;
        let t1347 = k6 * t1340 - t1271;
        let t1350 = c6 * t1340 + s6 * t1198;
        let t1353 = s6 * t1340 - c6 * t1198;
        let t1362 = k5 * t1353 - (c6 * t1346 + s6 * t226);
        let t1363 = c6 * t226 - s6 * t1346 - k5 * t1350;
        let t1366 = c5 * t1350 + s5 * t1343;
        let t1369 = s5 * t1350 - c5 * t1343;
        let t1379 = c5 * t1347 - s5 * t1362 + k4 * t1366;
        let t1382 = c5 * t1362 + s5 * t1347 + k4 * t1369 + k3 * t1353;
        let t1383 = k3 * t1366 - t1363;
        let t1393 = v1_3_y * t1369 + (t264 * t1353 - t261 * t1366);
        let t1394 = z1_4_z * t1379 - (z1_4_y * t1383 - z1_4_x * t1382) + t1393;
        let t1404 = t257 * t1366 - t258 * t1353 - v2_4_z * t1369;
        let t1405 = c3 * t1379 - (t255 * t1382 + z2_4_y * t1383) + t1404;
        let t1408 = s4 * t1382 - c4 * t1383;
        put(53, t1394); // row 1, MSY7
        put(114, t1405); // row 2, MSY7
        put(165, t1408); // row 3, MSY7
        put(206, t1379); // row 4, MSY7
        put(237, t1363); // row 5, MSY7
        put(258, t1347); // row 6, MSY7
        [t1338, t1341]
    };
    // MSZ7: column
    {
        let t1411 = c7 * t1193 + s7 * t1196;
        let t1414 = s7 * t1193 - c7 * t1196;
        let t1417 = t1205 + k6 * t1414;
        let t1418 = t1202 + k6 * t1411;
        let t1421 = c6 * t1411 + s6 * t1199;
        let t1424 = s6 * t1411 - c6 * t1199;
        let t1429 = c6 * t1417 + k5 * t1424;
        let t1430 = s6 * t1417 - k5 * t1421;
        let t1433 = s5 * t1414 - c5 * t1421;
        let t1436 = s5 * t1421 + c5 * t1414;
        let t1446 = c5 * t1418 - s5 * t1429 - k4 * t1433;
        let t1449 = c5 * t1429 + s5 * t1418 + k4 * t1436 + k3 * t1424;
        let t1450 = t1430 + k3 * t1433;
        let t1460 = v1_3_y * t1436 + (t261 * t1433 + t264 * t1424);
        let t1461 = z1_4_z * t1446 + (z1_4_x * t1449 + z1_4_y * t1450) + t1460;
        let t1471 = v2_4_z * t1436 + (t257 * t1433 + t258 * t1424);
        let t1472 = c3 * t1446 + (z2_4_y * t1450 - t255 * t1449) - t1471;
        let t1475 = s4 * t1449 + c4 * t1450;
        put(54, t1461); // row 1, MSZ7
        put(115, t1472); // row 2, MSZ7
        put(166, t1475); // row 3, MSZ7
        put(207, t1446); // row 4, MSZ7
        put(238, t1430); // row 5, MSZ7
        put(259, t1418); // row 6, MSZ7
    }
    // XX7: column
    let [t1477, t1480, t1483, t1486] = {
        let t1477 = s7 * t1189;
        let t1478 = c7 * t233 + t1477;
        let t1480 = c7 * t1189;
        let t1481 = s7 * t233 - t1480;
        let t1483 = s6 * t1188;
        let t1484 = c6 * t1478 + t1483;
        let t1486 = c6 * t1188;
        let t1487 = t1486 - s6 * t1478;
        let t1492 = z1_4_y * t1487 + (t267 * t1484 + z1_6_z * t1481);
        let t1497 = z2_4_y * t1487 + (t273 * t1484 + t276 * t1481);
        let t1502 = c4 * t1487 + (z3_6_z * t1481 - z3_5_x * t1484);
        let t1505 = s5 * t1484 + c5 * t1481;
        put(55, t1492); // row 1, XX7
        put(116, t1497); // row 2, XX7
        put(167, t1502); // row 3, XX7
        put(208, t1505); // row 4, XX7
        put(239, t1487); // row 5, XX7
        put(260, t1481); // row 6, XX7
        [t1477, t1480, t1483, t1486]
    };
    // YY7: column
    let [t1506, t1509] = {
        let t1506 = c7 * t1190;
        let t1508 = t1506 + s7 * t234;
        let t1509 = s7 * t1190;
        let t1511 = c7 * t234 - t1509;
        let t1513 = t1483 + c6 * t1508;
        let t1515 = s6 * t1508 - t1486;
        let t1520 = z1_4_y * t1515 - (t267 * t1513 - z1_6_z * t1511);
        let t1525 = z2_4_y * t1515 + (t276 * t1511 - t273 * t1513);
        let t1530 = c4 * t1515 + (z3_5_x * t1513 + z3_6_z * t1511);
        let t1533 = c5 * t1511 - s5 * t1513;
        put(56, t1520); // row 1, YY7
        put(117, t1525); // row 2, YY7
        put(168, t1530); // row 3, YY7
        put(209, t1533); // row 4, YY7
        put(240, t1515); // row 5, YY7
        put(261, t1511); // row 6, YY7
        [t1506, t1509]
    };
    // ZZ7: column
    {
        let t1534 = t1506 - t1477;
        let t1535 = t1480 + t1509;
        let t1538 = c6 * t1534 + s6 * dw7_z;
        let t1541 = c6 * dw7_z - s6 * t1534;
        let t1546 = z1_4_y * t1541 + (t267 * t1538 + z1_6_z * t1535);
        let t1551 = z2_4_y * t1541 + (t273 * t1538 + t276 * t1535);
        let t1556 = c4 * t1541 + (z3_6_z * t1535 - z3_5_x * t1538);
        let t1559 = s5 * t1538 + c5 * t1535;
        put(57, t1546); // row 1, ZZ7
        put(118, t1551); // row 2, ZZ7
        put(169, t1556); // row 3, ZZ7
        put(210, t1559); // row 4, ZZ7
        put(241, t1541); // row 5, ZZ7
        put(262, t1535); // row 6, ZZ7
    }
    // XY7: column
    {
        let t1560 = t1185 - t1186;
        let t1563 = s7 * t1198 - c7 * t1197;
        let t1566 = s7 * t1197 + c7 * t1198;
        let t1569 = c6 * t1563 - s6 * t1560;
        let t1572 = s6 * t1563 + c6 * t1560;
        let t1577 = z1_4_y * t1572 + (z1_6_z * t1566 - t267 * t1569);
        let t1582 = z2_4_y * t1572 + (t276 * t1566 - t273 * t1569);
        let t1587 = c4 * t1572 + (z3_5_x * t1569 + z3_6_z * t1566);
        let t1590 = c5 * t1566 - s5 * t1569;
        put(58, t1577); // row 1, XY7
        put(119, t1582); // row 2, XY7
        put(170, t1587); // row 3, XY7
        put(211, t1590); // row 4, XY7
        put(242, t1572); // row 5, XY7
        put(263, t1566); // row 6, XY7
        put(274, t1560); // row 7, XY7
    }
    // XZ7: column
    {
        let t1591 = t1187 - t1185;
        let t1593 = t1269 + s7 * t1591;
        let t1595 = t1266 - c7 * t1591;
        let t1598 = c6 * t1593 + s6 * t1196;
        let t1601 = c6 * t1196 - s6 * t1593;
        let t1606 = z1_4_y * t1601 + (t267 * t1598 + z1_6_z * t1595);
        let t1611 = z2_4_y * t1601 + (t273 * t1598 + t276 * t1595);
        let t1616 = c4 * t1601 - (z3_5_x * t1598 - z3_6_z * t1595);
        let t1619 = s5 * t1598 + c5 * t1595;
        put(59, t1606); // row 1, XZ7
        put(120, t1611); // row 2, XZ7
        put(171, t1616); // row 3, XZ7
        put(212, t1619); // row 4, XZ7
        put(243, t1601); // row 5, XZ7
        put(264, t1595); // row 6, XZ7
    }
    // YZ7: column
    {
        let t1620 = t1187 - t1186;
        let t1622 = t1341 + c7 * t1620;
        let t1624 = s7 * t1620 - t1338;
        let t1627 = c6 * t1622 + s6 * t1193;
        let t1630 = c6 * t1193 - s6 * t1622;
        let t1635 = z1_4_y * t1630 + (t267 * t1627 + z1_6_z * t1624);
        let t1640 = z2_4_y * t1630 + (t273 * t1627 + t276 * t1624);
        let t1645 = c4 * t1630 + (z3_6_z * t1624 - z3_5_x * t1627);
        let t1648 = s5 * t1627 + c5 * t1624;
        let t1649 = dq1.sign();
        let t1650 = dq2.sign();
        let t1651 = dq3.sign();
        let t1652 = dq4.sign();
        let t1653 = dq5.sign();
        let t1654 = dq6.sign();
        let t1655 = dq7.sign();
        let t1656 = -t32;
        let t1657 = -t49;
        let t1658 = -t71;
        let t1659 = -t500;
        let t1660 = -t116;
        let t1661 = -t593;
        let t1662 = -t772;
        let t1663 = -t161;
        let t1664 = -t1008;
        let t1665 = -t206;
        let t1666 = -t1207;
        let t1667 = -t1188;
        put(60, t1635); // row 1, YZ7
        put(62, t1649); // row 1, FC1
        put(66, t1656); // row 2, XX2
        put(121, t1640); // row 2, YZ7
        put(123, t1650); // row 2, FC2
        put(125, t1657); // row 3, MSX3
        put(128, t1658); // row 3, YY3
        put(136, t1659); // row 3, MSZ4
        put(172, t1645); // row 3, YZ7
        put(174, t1651); // row 3, FC3
        put(178, t1660); // row 4, XX4
        put(184, t1661); // row 4, M5
        put(189, t1662); // row 4, YY5
        put(213, t1648); // row 4, YZ7
        put(215, t1652); // row 4, FC4
        put(219, t1663); // row 5, XX5
        put(228, t1664); // row 5, MSZ6
        put(244, t1630); // row 5, YZ7
        put(246, t1653); // row 5, FC5
        put(250, t1665); // row 6, XX6
        put(256, t1666); // row 6, M7
        put(265, t1624); // row 6, YZ7
        put(267, t1654); // row 6, FC6
        put(272, t1667); // row 7, YY7
        put(278, t1655); // row 7, FC7
    }
}
