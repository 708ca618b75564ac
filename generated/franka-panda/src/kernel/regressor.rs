//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil and Dombre, 12.4.
//!
//! 872 multiplications, 652 additions; 7 x 91, 276 of 637 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 276;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 6), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18), (0, 19), (0, 20), (0, 21),
    (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28), (0, 29), (0, 30), (0, 31),
    (0, 32), (0, 33), (0, 34), (0, 35), (0, 36), (0, 37), (0, 38), (0, 39), (0, 40), (0, 41),
    (0, 42), (0, 43), (0, 44), (0, 45), (0, 46), (0, 47), (0, 48), (0, 49), (0, 50), (0, 51),
    (0, 52), (0, 53), (0, 54), (0, 55), (0, 56), (0, 57), (0, 58), (0, 59), (0, 60), (0, 61),
    (0, 62), (0, 63), (0, 64), (0, 65), (0, 66), (0, 67), (0, 68), (0, 69), (0, 70), (0, 77),
    (0, 84), (1, 11), (1, 12), (1, 14), (1, 15), (1, 16), (1, 17), (1, 18), (1, 19), (1, 20),
    (1, 21), (1, 22), (1, 23), (1, 24), (1, 25), (1, 26), (1, 27), (1, 28), (1, 29), (1, 30),
    (1, 31), (1, 32), (1, 33), (1, 34), (1, 35), (1, 36), (1, 37), (1, 38), (1, 39), (1, 40),
    (1, 41), (1, 42), (1, 43), (1, 44), (1, 45), (1, 46), (1, 47), (1, 48), (1, 49), (1, 50),
    (1, 51), (1, 52), (1, 53), (1, 54), (1, 55), (1, 56), (1, 57), (1, 58), (1, 59), (1, 60),
    (1, 61), (1, 62), (1, 63), (1, 64), (1, 65), (1, 66), (1, 67), (1, 68), (1, 69), (1, 71),
    (1, 78), (1, 85), (2, 21), (2, 22), (2, 24), (2, 25), (2, 26), (2, 27), (2, 28), (2, 29),
    (2, 30), (2, 31), (2, 32), (2, 33), (2, 34), (2, 35), (2, 36), (2, 37), (2, 38), (2, 39),
    (2, 40), (2, 41), (2, 42), (2, 43), (2, 44), (2, 45), (2, 46), (2, 47), (2, 48), (2, 49),
    (2, 50), (2, 51), (2, 52), (2, 53), (2, 54), (2, 55), (2, 56), (2, 57), (2, 58), (2, 59),
    (2, 60), (2, 61), (2, 62), (2, 63), (2, 64), (2, 65), (2, 66), (2, 67), (2, 68), (2, 69),
    (2, 72), (2, 79), (2, 86), (3, 31), (3, 32), (3, 34), (3, 35), (3, 36), (3, 37), (3, 38),
    (3, 39), (3, 40), (3, 41), (3, 42), (3, 43), (3, 44), (3, 45), (3, 46), (3, 47), (3, 48),
    (3, 49), (3, 50), (3, 51), (3, 52), (3, 53), (3, 54), (3, 55), (3, 56), (3, 57), (3, 58),
    (3, 59), (3, 60), (3, 61), (3, 62), (3, 63), (3, 64), (3, 65), (3, 66), (3, 67), (3, 68),
    (3, 69), (3, 73), (3, 80), (3, 87), (4, 41), (4, 42), (4, 44), (4, 45), (4, 46), (4, 47),
    (4, 48), (4, 49), (4, 51), (4, 52), (4, 53), (4, 54), (4, 55), (4, 56), (4, 57), (4, 58),
    (4, 59), (4, 60), (4, 61), (4, 62), (4, 63), (4, 64), (4, 65), (4, 66), (4, 67), (4, 68),
    (4, 69), (4, 74), (4, 81), (4, 88), (5, 51), (5, 52), (5, 54), (5, 55), (5, 56), (5, 57),
    (5, 58), (5, 59), (5, 60), (5, 61), (5, 62), (5, 63), (5, 64), (5, 65), (5, 66), (5, 67),
    (5, 68), (5, 69), (5, 75), (5, 82), (5, 89), (6, 61), (6, 62), (6, 64), (6, 65), (6, 66),
    (6, 67), (6, 68), (6, 69), (6, 76), (6, 83), (6, 90),
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
    let A = S::constant(0.0825);
    let L2 = S::constant(0.316);
    let L3 = S::constant(0.384);
    let k0 = S::constant(9.81);
    let k4 = S::constant(0.088);
    let k5 = S::constant(0.099856);
    let k6 = S::constant(0.632);
    let k7 = S::constant(1.0);
    // link 2: motion
    let [
        t0, t1, t2, t3, t4, t5, t6, t7,
        t8, t9,
    ] = {
        let t0 = s2 * dq1;
        let t1 = c2 * dq1;
        let t2 = s2 * ddq1;
        let t3 = c2 * ddq1;
        let t4 = s2 * k0;
        let t5 = c2 * k0;
        let t6 = dq2 * t1;
        let t7 = dq2 * t0;
        let t8 = t2 + t6;
        let t9 = t3 - t7;
        put(0, ddq1); // row 1, ZZ1
        put(58, dq1); // row 1, FV1
        put(60, k7); // row 1, FO1
        put(62, t4); // row 2, MSY2
        put(65, ddq2); // row 2, ZZ2
        put(119, dq2); // row 2, FV2
        put(121, k7); // row 2, FO2
        put(170, dq3); // row 3, FV3
        put(172, k7); // row 3, FO3
        put(211, dq4); // row 4, FV4
        put(213, k7); // row 4, FO4
        put(241, dq5); // row 5, FV5
        put(243, k7); // row 5, FO5
        put(262, dq6); // row 6, FV6
        put(264, k7); // row 6, FO6
        put(273, dq7); // row 7, FV7
        put(275, k7); // row 7, FO7
        [
        t0, t1, t2, t3, t4, t5, t6, t7,
        t8, t9,
    ]
    };
    // link 3: motion
    let [
        t12, w3_y, t22, t23, t24, t25, t26, t27,
        t29, t30, t31, t32, t37, a3_x, a3_y, w3_z,
        dw3_x, dw3_y, dw3_z,
    ] = {
        let t12 = c3 * t0 - s3 * dq2;
        let w3_y = c3 * dq2 + s3 * t0;
        let t22 = t0 * t0;
        let t23 = t1 * t1;
        let t24 = dq2 * dq2;
        let t25 = t0 * t1;
        let t26 = t25 - ddq2;
        let t27 = ddq2 + t25;
        let t29 = t9 - t7;
        let t30 = t6 + t8;
        let t31 = c3 * t4;
        let t32 = s3 * t4;
        let t35 = L2 * t30;
        let t36 = t4 + L2 * t26;
        let t37 = t5 - L2 * (t22 + t24);
        let a3_x = s3 * t35 - c3 * t36;
        let a3_y = c3 * t35 + s3 * t36;
        let w3_z = t1 + dq3;
        let dw3_x = dq3 * w3_y - (c3 * t8 - s3 * ddq2);
        let dw3_y = c3 * ddq2 + s3 * t8 + dq3 * t12;
        let dw3_z = t9 + ddq3;
        put(64, t25); // row 2, YY2
        put(126, dw3_z); // row 3, ZZ3
        [
        t12, w3_y, t22, t23, t24, t25, t26, t27,
        t29, t30, t31, t32, t37, a3_x, a3_y, w3_z,
        dw3_x, dw3_y, dw3_z,
    ]
    };
    // link 4: motion
    let [
        t52, w4_y, t62, t63, t64, t65, t66, t67,
        t69, t70, t71, t72, t73, t74, t79, t83,
        a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ] = {
        let t52 = c4 * t12 - s4 * w3_z;
        let w4_y = c4 * w3_z + s4 * t12;
        let t62 = t12 * t12;
        let t63 = w3_y * w3_y;
        let t64 = w3_z * w3_z;
        let t65 = t12 * w3_y;
        let t66 = t12 * w3_z;
        let t67 = w3_y * w3_z;
        let t69 = dw3_z + t65;
        let t70 = dw3_y - t66;
        let t71 = dw3_z - t65;
        let t72 = dw3_x - t67;
        let t73 = dw3_y + t66;
        let t74 = dw3_x + t67;
        let t78 = A * (t63 + t64) - a3_x;
        let t79 = a3_y + A * t71;
        let t80 = A * t73 - t37;
        let t83 = c4 * t78 + s4 * t80;
        let a4_y = s4 * t78 - c4 * t80;
        let w4_z = dq4 - w3_y;
        let dw4_x = c4 * dw3_x + s4 * dw3_z + dq4 * w4_y;
        let dw4_y = c4 * dw3_z - s4 * dw3_x + dq4 * t52;
        let dw4_z = ddq4 - dw3_y;
        put(124, t65); // row 3, XX3
        put(128, t72); // row 3, XZ3
        put(129, t70); // row 3, YZ3
        put(173, a4_y); // row 4, MSX4
        put(174, t83); // row 4, MSY4
        put(177, dw4_z); // row 4, ZZ4
        [
        t52, w4_y, t62, t63, t64, t65, t66, t67,
        t69, t70, t71, t72, t73, t74, t79, t83,
        a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ]
    };
    // link 5: motion
    let [
        t95, t98, t105, t106, t107, t108, t109, t110,
        t111, t112, t113, t114, t115, t116, t117, t118,
        t119, t122, a5_z, t134, a5_y, w5_z, t141, t142,
        dw5_z,
    ] = {
        let t95 = c5 * t52 + s5 * w4_z;
        let t98 = c5 * w4_z - s5 * t52;
        let t105 = t52 * t52;
        let t106 = w4_y * w4_y;
        let t107 = w4_z * w4_z;
        let t108 = t52 * w4_y;
        let t109 = t52 * w4_z;
        let t110 = w4_y * w4_z;
        let t111 = t106 + t107;
        let t112 = dw4_z + t108;
        let t113 = dw4_y - t109;
        let t114 = dw4_z - t108;
        let t115 = t105 + t107;
        let t116 = dw4_x - t110;
        let t117 = dw4_y + t109;
        let t118 = dw4_x + t110;
        let t119 = t105 + t106;
        let t122 = A * t117;
        let t129 = t83 + (L3 * t112 - A * t111);
        let a5_z = a4_y - (A * t114 + L3 * t115);
        let t131 = t122 + L3 * t118 - t79;
        let t134 = c5 * t129 + s5 * t131;
        let a5_y = s5 * t129 - c5 * t131;
        let w5_z = w4_y + dq5;
        let t141 = s5 * dw4_z - c5 * dw4_x + dq5 * t98;
        let t142 = dq5 * t95 - (c5 * dw4_z + s5 * dw4_x);
        let dw5_z = dw4_y + ddq5;
        put(175, t108); // row 4, XX4
        put(179, t116); // row 4, XZ4
        put(180, t113); // row 4, YZ4
        put(214, a5_y); // row 5, MSX5
        put(215, t134); // row 5, MSY5
        put(218, dw5_z); // row 5, ZZ5
        [
        t95, t98, t105, t106, t107, t108, t109, t110,
        t111, t112, t113, t114, t115, t116, t117, t118,
        t119, t122, a5_z, t134, a5_y, w5_z, t141, t142,
        dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t156, t157, t158, t159, t160, t161,
        t162, t163, t164, t165, t166, t167, t168, t169,
        t170, t173, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ] = {
        let w6_x = s6 * w5_z - c6 * t95;
        let w6_y = c6 * w5_z + s6 * t95;
        let t156 = t95 * t95;
        let t157 = t98 * t98;
        let t158 = w5_z * w5_z;
        let t159 = t95 * t98;
        let t160 = t95 * w5_z;
        let t161 = t98 * w5_z;
        let t162 = t157 + t158;
        let t163 = t159 - dw5_z;
        let t164 = t142 - t160;
        let t165 = dw5_z + t159;
        let t166 = t156 + t158;
        let t167 = t161 - t141;
        let t168 = t142 + t160;
        let t169 = t141 + t161;
        let t170 = t156 + t157;
        let t173 = c6 * t134 - s6 * a5_z;
        let a6_y = c6 * a5_z + s6 * t134;
        let w6_z = t98 + dq6;
        let dw6_x = dq6 * w6_y - (c6 * t141 - s6 * dw5_z);
        let dw6_y = c6 * dw5_z + s6 * t141 - dq6 * w6_x;
        let dw6_z = ddq6 - t142;
        put(217, t159); // row 5, YY5
        put(220, t167); // row 5, XZ5
        put(221, t164); // row 5, YZ5
        put(244, a6_y); // row 6, MSX6
        put(245, t173); // row 6, MSY6
        put(248, dw6_z); // row 6, ZZ6
        [
        w6_x, w6_y, t156, t157, t158, t159, t160, t161,
        t162, t163, t164, t165, t166, t167, t168, t169,
        t170, t173, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ]
    };
    // link 7: motion
    let [
        w7_x, w7_y, t195, t196, t197, t198, t199, t200,
        t201, t202, t203, t204, t205, t206, t207, t208,
        t209, t214, t218, a7_y, t222, dw7_x, dw7_y, t227,
    ] = {
        let w7_x = c7 * w6_x + s7 * w6_z;
        let w7_y = c7 * w6_z - s7 * w6_x;
        let t195 = w6_x * w6_x;
        let t196 = w6_y * w6_y;
        let t197 = w6_z * w6_z;
        let t198 = w6_x * w6_y;
        let t199 = w6_x * w6_z;
        let t200 = w6_y * w6_z;
        let t201 = t196 + t197;
        let t202 = dw6_z - t198;
        let t203 = dw6_y + t199;
        let t204 = dw6_z + t198;
        let t205 = t195 + t197;
        let t206 = dw6_x - t200;
        let t207 = dw6_y - t199;
        let t208 = dw6_x + t200;
        let t209 = t195 + t196;
        let t213 = t173 + k4 * t201;
        let t214 = a6_y + k4 * t204;
        let t215 = a5_y + k4 * t207;
        let t218 = c7 * t213 + s7 * t215;
        let a7_y = s7 * t213 - c7 * t215;
        let t222 = w6_y - dq7;
        let dw7_x = c7 * dw6_x + s7 * dw6_z + dq7 * w7_y;
        let dw7_y = c7 * dw6_z - s7 * dw6_x - dq7 * w7_x;
        let t227 = dw6_y - ddq7;
        put(247, t198); // row 6, YY6
        put(250, t206); // row 6, XZ6
        put(251, t203); // row 6, YZ6
        put(265, a7_y); // row 7, MSX7
        put(266, t218); // row 7, MSY7
        [
        w7_x, w7_y, t195, t196, t197, t198, t199, t200,
        t201, t202, t203, t204, t205, t206, t207, t208,
        t209, t214, t218, a7_y, t222, dw7_x, dw7_y, t227,
    ]
    };
    // joint axes in frame 3
    let [t228, z1_3_y] = {
        let t228 = s2 * c3;
        let z1_3_y = s2 * s3;
        [t228, z1_3_y]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, z2_4_x, t237] = {
        let z1_4_x = c2 * s4 - c4 * t228;
        let z1_4_y = c2 * c4 + s4 * t228;
        let z2_4_x = s3 * c4;
        let t237 = s3 * s4;
        [z1_4_x, z1_4_y, z2_4_x, t237]
    };
    // joint axes in frame 5
    let [z1_5_x, t243, z2_5_x, t249, t250, z3_5_x, z3_6_z] = {
        let z1_5_x = c5 * z1_4_x + s5 * z1_3_y;
        let t243 = s5 * z1_4_x - c5 * z1_3_y;
        let z2_5_x = c5 * z2_4_x + c3 * s5;
        let t249 = s5 * z2_4_x - c3 * c5;
        let t250 = c4 * A;
        let z3_5_x = s4 * c5;
        let z3_6_z = s4 * s5;
        [z1_5_x, t243, z2_5_x, t249, t250, z3_5_x, z3_6_z]
    };
    // MSZ2: column
    {
        let t255 = c2 * t4 - s2 * t5;
        put(1, t255); // row 1, MSZ2
    }
    // XX2: column
    let t257 = {
        let t257 = c2 * t7;
        let t258 = s2 * t8 + t257;
        put(2, t258); // row 1, XX2
        t257
    };
    // YY2: column
    let t259 = {
        let t259 = s2 * t6;
        let t261 = c2 * t9 - t259;
        put(3, t261); // row 1, YY2
        t259
    };
    // ZZ2: column
    {
        let t262 = t259 - t257;
        put(4, t262); // row 1, ZZ2
    }
    // XY2: column
    {
        let t263 = t22 - t23;
        let t266 = s2 * t29 + c2 * t30;
        put(5, t266); // row 1, XY2
        put(66, t263); // row 2, XY2
    }
    // XZ2: column
    {
        let t270 = c2 * (t22 - t24) - s2 * t27;
        put(6, t270); // row 1, XZ2
    }
    // YZ2: column
    {
        let t274 = c2 * t26 - s2 * (t23 - t24);
        put(7, t274); // row 1, YZ2
    }
    // M3: column
    let t277 = {
        let t277 = c3 * t31 + s3 * t32;
        t277
    };
    // MSZ3: column
    let [t280, t281, t282] = {
        let t280 = t32 * t228 - t31 * z1_3_y;
        let t281 = L2 * t280;
        let t282 = L2 * t277;
        [t280, t281, t282]
    };
    // XX3: column
    let [t284, t285, t287, t289, t290] = {
        let t284 = t66 * z1_3_y;
        let t285 = c2 * t65;
        let t287 = t285 - (dw3_x * t228 + t284);
        let t289 = c3 * t66;
        let t290 = s3 * dw3_x - t289;
        put(12, t287); // row 1, XX3
        put(73, t290); // row 2, XX3
        [t284, t285, t287, t289, t290]
    };
    // YY3: column
    let [t291, t295, t298, t299] = {
        let t291 = t67 * t228;
        let t294 = t291 + dw3_y * z1_3_y - t285;
        let t295 = s3 * t67;
        let t297 = c3 * dw3_y - t295;
        let t298 = t287 + t294;
        let t299 = t290 + t297;
        let t301 = t281 + t298 * k5;
        let t303 = t299 * k5 - t282;
        put(8, t301); // row 1, M3
        put(13, t294); // row 1, YY3
        put(69, t303); // row 2, M3
        put(74, t297); // row 2, YY3
        [t291, t295, t298, t299]
    };
    // MSX3: column
    let [t306, t307, t308] = {
        let t306 = c2 * t32 - t5 * z1_3_y;
        let t307 = c3 * t5;
        let t308 = s3 * t71;
        [t306, t307, t308]
    };
    // XZ3: column
    let t320 = {
        let t309 = t62 - t64;
        let t314 = c2 * t72 - (t71 * t228 + z1_3_y * t309);
        let t316 = t308 - c3 * t309;
        let t318 = t306 - L2 * t314;
        let t320 = t307 + L2 * t316;
        let t322 = t32 - L2 * t72;
        put(9, t318); // row 1, MSX3
        put(16, t314); // row 1, XZ3
        put(77, t316); // row 2, XZ3
        put(122, t322); // row 3, MSX3
        t320
    };
    // MSY3: column
    let [t325, t326, t327] = {
        let t325 = c2 * t31 - t5 * t228;
        let t326 = s3 * t5;
        let t327 = c3 * t69;
        [t325, t326, t327]
    };
    // YZ3: column
    {
        let t328 = t63 - t64;
        let t333 = c2 * t70 - (t228 * t328 - t69 * z1_3_y);
        let t335 = t327 + s3 * t328;
        let t337 = t325 - L2 * t333;
        let t339 = t326 - L2 * t335;
        let t341 = t31 - L2 * t70;
        put(10, t337); // row 1, MSY3
        put(17, t333); // row 1, YZ3
        put(71, t339); // row 2, MSY3
        put(78, t335); // row 2, YZ3
        put(123, t341); // row 3, MSY3
    }
    // YY3: column
    {
        let t343 = t280 + t298 * k6;
        let t345 = t299 * k6 - t277;
        put(11, t343); // row 1, MSZ3
        put(72, t345); // row 2, MSZ3
    }
    // ZZ3: column
    {
        let t348 = c2 * dw3_z + (t284 - t291);
        let t349 = t289 + t295;
        put(14, t348); // row 1, ZZ3
        put(75, t349); // row 2, ZZ3
    }
    // XY3: column
    {
        let t350 = t62 - t63;
        let t355 = c2 * t350 + (t74 * z1_3_y - t73 * t228);
        let t358 = s3 * t73 + c3 * t74;
        put(15, t355); // row 1, XY3
        put(76, t358); // row 2, XY3
        put(127, t350); // row 3, XY3
    }
    // M4: column
    let [t360, t363] = {
        let t360 = t250 + L2 * s4;
        let t363 = s4 * A - L2 * c4;
        let t364 = t79 * t363;
        let t365 = t79 * t360;
        let t368 = t83 * t363 - a4_y * t360;
        let t373 = z1_3_y * t368 + (z1_4_x * t364 + z1_4_y * t365);
        let t378 = c3 * t368 + (z2_4_x * t364 - t237 * t365);
        let t379 = A * t79;
        put(18, t373); // row 1, M4
        put(79, t378); // row 2, M4
        put(130, t379); // row 3, M4
        [t360, t363]
    };
    // MSX4: column
    {
        let t380 = t117 * t363;
        let t385 = t79 + t117 * t360;
        let t386 = t111 * t363 - t114 * t360 - a4_y;
        let t391 = z1_3_y * t386 + (z1_4_x * t380 + z1_4_y * t385);
        let t396 = c3 * t386 - (t237 * t385 - z2_4_x * t380);
        let t398 = t122 + c4 * t79;
        put(19, t391); // row 1, MSX4
        put(80, t396); // row 2, MSX4
        put(131, t398); // row 3, MSX4
    }
    // MSY4: column
    let t418 = {
        let t400 = t118 * t360;
        let t404 = t79 + t118 * t363;
        let t405 = t115 * t360 + t112 * t363 - t83;
        let t410 = z1_3_y * t405 - (z1_4_x * t404 + z1_4_y * t400);
        let t415 = c3 * t405 + (t237 * t400 - z2_4_x * t404);
        let t418 = s4 * t79 + A * t118;
        put(20, t410); // row 1, MSY4
        put(81, t415); // row 2, MSY4
        t418
    };
    // MSZ4: column
    {
        let t423 = t116 * t360 - t113 * t363;
        let t424 = t119 * t363 - a4_y;
        let t425 = t83 - t119 * t360;
        let t430 = z1_3_y * t423 - (z1_4_y * t425 - z1_4_x * t424);
        let t435 = c3 * t423 + (z2_4_x * t424 + t237 * t425);
        let t440 = A * t119 - (s4 * a4_y + c4 * t83);
        put(21, t430); // row 1, MSZ4
        put(82, t435); // row 2, MSZ4
        put(133, t440); // row 3, MSZ4
    }
    // XX4: column
    let [t442, t443, t447, t448, t452] = {
        let t442 = t109 * z1_4_y;
        let t443 = t108 * z1_3_y;
        let t445 = dw4_x * z1_4_x - t442 - t443;
        let t447 = t109 * t237;
        let t448 = c3 * t108;
        let t450 = dw4_x * z2_4_x + t447 - t448;
        let t452 = c4 * t109;
        let t453 = s4 * dw4_x - t452;
        put(22, t445); // row 1, XX4
        put(83, t450); // row 2, XX4
        put(134, t453); // row 3, XX4
        [t442, t443, t447, t448, t452]
    };
    // YY4: column
    let [t454, t458, t462] = {
        let t454 = t110 * z1_4_x;
        let t457 = t443 - (t454 - dw4_y * z1_4_y);
        let t458 = t110 * z2_4_x;
        let t461 = t448 - (t458 + dw4_y * t237);
        let t462 = s4 * t110;
        let t464 = c4 * dw4_y - t462;
        put(23, t457); // row 1, YY4
        put(84, t461); // row 2, YY4
        put(135, t464); // row 3, YY4
        [t454, t458, t462]
    };
    // ZZ4: column
    {
        let t467 = t442 + t454 - dw4_z * z1_3_y;
        let t470 = t458 - t447 - c3 * dw4_z;
        let t471 = t452 + t462;
        put(24, t467); // row 1, ZZ4
        put(85, t470); // row 2, ZZ4
        put(136, t471); // row 3, ZZ4
    }
    // XY4: column
    {
        let t472 = t105 - t106;
        let t477 = t117 * z1_4_x + t118 * z1_4_y - z1_3_y * t472;
        let t482 = t117 * z2_4_x - t118 * t237 - c3 * t472;
        let t485 = s4 * t117 + c4 * t118;
        put(25, t477); // row 1, XY4
        put(86, t482); // row 2, XY4
        put(137, t485); // row 3, XY4
        put(178, t472); // row 4, XY4
    }
    // XZ4: column
    {
        let t486 = t105 - t107;
        let t491 = t114 * z1_4_x - z1_4_y * t486 - t116 * z1_3_y;
        let t496 = t114 * z2_4_x + t237 * t486 - c3 * t116;
        let t499 = s4 * t114 - c4 * t486;
        put(26, t491); // row 1, XZ4
        put(87, t496); // row 2, XZ4
        put(138, t499); // row 3, XZ4
    }
    // YZ4: column
    {
        let t500 = t106 - t107;
        let t505 = z1_4_x * t500 + t112 * z1_4_y - t113 * z1_3_y;
        let t510 = z2_4_x * t500 - t112 * t237 - c3 * t113;
        let t513 = s4 * t500 + c4 * t112;
        put(27, t505); // row 1, YZ4
        put(88, t510); // row 2, YZ4
        put(139, t513); // row 3, YZ4
    }
    // M5: column
    let [t515, t516, t518, t519] = {
        let t515 = s5 * a5_y;
        let t516 = c5 * t134 + t515;
        let t518 = c5 * a5_y;
        let t519 = s5 * t134 - t518;
        let t520 = L3 * t519;
        let t523 = L3 * t516 - A * a5_z;
        let t524 = A * t519;
        let t530 = t520 - t363 * t519;
        let t531 = t360 * t519 - t524;
        let t532 = t523 - (t363 * t516 - a5_z * t360);
        let t537 = z1_4_x * t530 - z1_4_y * t531 - z1_3_y * t532;
        let t542 = z2_4_x * t530 + t237 * t531 - c3 * t532;
        let t546 = s4 * t520 + c4 * t524 - t524;
        put(28, t537); // row 1, M5
        put(89, t542); // row 2, M5
        put(140, t546); // row 3, M5
        put(181, t523); // row 4, M5
        [t515, t516, t518, t519]
    };
    // MSX5: column
    let [t548, t553, t554] = {
        let t548 = s5 * t165;
        let t549 = c5 * t162 + t548;
        let t552 = c5 * t165 - s5 * t162;
        let t553 = s5 * a5_z;
        let t554 = c5 * a5_z;
        let t559 = A * t552;
        let t560 = t553 - L3 * t552;
        let t561 = t554 + (L3 * t549 + A * t168);
        let t562 = t559 - a5_y;
        let t568 = t560 + t363 * t552;
        let t569 = t360 * t552 - t562;
        let t570 = t168 * t360 + t363 * t549 - t561;
        let t575 = z1_3_y * t570 + (z1_4_x * t568 + z1_4_y * t569);
        let t580 = c3 * t570 + (z2_4_x * t568 - t237 * t569);
        let t584 = t559 + (s4 * t560 - c4 * t562);
        put(29, t575); // row 1, MSX5
        put(90, t580); // row 2, MSX5
        put(141, t584); // row 3, MSX5
        put(182, t561); // row 4, MSX5
        [t548, t553, t554]
    };
    // MSY5: column
    let t585 = {
        let t585 = c5 * t163;
        let t587 = t585 + s5 * t166;
        let t590 = s5 * t163 - c5 * t166;
        let t595 = A * t590;
        let t596 = t554 - L3 * t590;
        let t597 = A * t169 - L3 * t587 - t553;
        let t598 = t595 - t134;
        let t604 = t596 + t363 * t590;
        let t605 = t360 * t590 - t598;
        let t606 = t169 * t360 - t363 * t587 - t597;
        let t611 = z1_3_y * t606 + (z1_4_x * t604 + z1_4_y * t605);
        let t616 = c3 * t606 - (t237 * t605 - z2_4_x * t604);
        let t620 = t595 + (s4 * t596 - c4 * t598);
        put(30, t611); // row 1, MSY5
        put(91, t616); // row 2, MSY5
        put(142, t620); // row 3, MSY5
        put(183, t597); // row 4, MSY5
        t585
    };
    // MSZ5: column
    {
        let t623 = c5 * t164 + s5 * t167;
        let t626 = c5 * t167 - s5 * t164;
        let t631 = A * t626;
        let t632 = t519 + L3 * t626;
        let t633 = t516 + (A * t170 - L3 * t623);
        let t639 = t632 - t363 * t626;
        let t640 = t360 * t626 - t631;
        let t641 = t633 + (t363 * t623 - t170 * t360);
        let t646 = z1_4_x * t639 - z1_4_y * t640 - z1_3_y * t641;
        let t651 = z2_4_x * t639 + t237 * t640 - c3 * t641;
        let t655 = s4 * t632 + c4 * t631 - t631;
        put(31, t646); // row 1, MSZ5
        put(92, t651); // row 2, MSZ5
        put(143, t655); // row 3, MSZ5
        put(184, t633); // row 4, MSZ5
    }
    // XX5: column
    let [t657, t658, t662, t663, t667, t668, t672] = {
        let t657 = t160 * t243;
        let t658 = t159 * z1_4_y;
        let t660 = t657 - t141 * z1_5_x - t658;
        let t662 = t160 * t249;
        let t663 = t159 * t237;
        let t665 = t663 + (t662 - t141 * z2_5_x);
        let t667 = t160 * z3_6_z;
        let t668 = c4 * t159;
        let t670 = t667 - t141 * z3_5_x - t668;
        let t672 = c5 * t160;
        let t673 = s5 * t141 + t672;
        put(32, t660); // row 1, XX5
        put(93, t665); // row 2, XX5
        put(144, t670); // row 3, XX5
        put(185, t673); // row 4, XX5
        [t657, t658, t662, t663, t667, t668, t672]
    };
    // YY5: column
    let [t674, t678, t682, t686, t688] = {
        let t674 = t161 * z1_5_x;
        let t677 = t658 + (t674 - t142 * t243);
        let t678 = t161 * z2_5_x;
        let t681 = t678 - t142 * t249 - t663;
        let t682 = t161 * z3_5_x;
        let t685 = t668 + (t682 - t142 * z3_6_z);
        let t686 = s5 * t161;
        let t688 = t686 + c5 * t142;
        put(33, t677); // row 1, YY5
        put(94, t681); // row 2, YY5
        put(145, t685); // row 3, YY5
        [t674, t678, t682, t686, t688]
    };
    // ZZ5: column
    let t694 = {
        let t691 = dw5_z * z1_4_y - (t657 + t674);
        let t694 = dw5_z * t237 + (t662 + t678);
        let t697 = c4 * dw5_z - (t667 + t682);
        let t698 = t686 - t672;
        put(34, t691); // row 1, ZZ5
        put(146, t697); // row 3, ZZ5
        put(187, t698); // row 4, ZZ5
        t694
    };
    // XY5: column
    {
        let t699 = t156 - t157;
        let t704 = z1_4_y * t699 + (t168 * z1_5_x + t169 * t243);
        let t709 = t168 * z2_5_x + t169 * t249 - t237 * t699;
        let t714 = c4 * t699 + (t168 * z3_5_x + t169 * z3_6_z);
        let t717 = c5 * t169 - s5 * t168;
        put(35, t704); // row 1, XY5
        put(96, t709); // row 2, XY5
        put(147, t714); // row 3, XY5
        put(188, t717); // row 4, XY5
        put(219, t699); // row 5, XY5
    }
    // XZ5: column
    {
        let t718 = t156 - t158;
        let t723 = t167 * z1_4_y + (t165 * z1_5_x + t243 * t718);
        let t728 = t165 * z2_5_x + t249 * t718 - t167 * t237;
        let t733 = c4 * t167 + (t165 * z3_5_x + z3_6_z * t718);
        let t735 = c5 * t718 - t548;
        put(36, t723); // row 1, XZ5
        put(97, t728); // row 2, XZ5
        put(148, t733); // row 3, XZ5
        put(189, t735); // row 4, XZ5
    }
    // YZ5: column
    {
        let t736 = t157 - t158;
        let t741 = t164 * z1_4_y + (z1_5_x * t736 + t163 * t243);
        let t746 = z2_5_x * t736 + t163 * t249 - t164 * t237;
        let t751 = c4 * t164 + (z3_5_x * t736 + t163 * z3_6_z);
        let t753 = t585 - s5 * t736;
        put(37, t741); // row 1, YZ5
        put(98, t746); // row 2, YZ5
        put(149, t751); // row 3, YZ5
        put(190, t753); // row 4, YZ5
    }
    // M6: column
    let [t756, t759] = {
        let t756 = c6 * t173 + s6 * a6_y;
        let t759 = s6 * t173 - c6 * a6_y;
        let t761 = t515 + c5 * t756;
        let t763 = t518 - s5 * t756;
        let t764 = L3 * t763;
        let t767 = L3 * t761 + A * t759;
        let t768 = A * t763;
        let t774 = t363 * t763 - t764;
        let t775 = t768 - t360 * t763;
        let t776 = t360 * t759 + t363 * t761 - t767;
        let t781 = z1_3_y * t776 - (z1_4_y * t775 - z1_4_x * t774);
        let t786 = c3 * t776 + (z2_4_x * t774 + t237 * t775);
        let t790 = t768 - (s4 * t764 + c4 * t768);
        put(38, t781); // row 1, M6
        put(99, t786); // row 2, M6
        put(150, t790); // row 3, M6
        put(191, t767); // row 4, M6
        [t756, t759]
    };
    // MSX6: column
    let [t792, t795, t797, t798] = {
        let t792 = s6 * t204;
        let t793 = c6 * t201 + t792;
        let t795 = c6 * t204;
        let t796 = s6 * t201 - t795;
        let t797 = s6 * a5_y;
        let t798 = c6 * a5_y;
        let t801 = c5 * t793 + s5 * t207;
        let t804 = c5 * t207 - s5 * t793;
        let t815 = A * t804;
        let t816 = c5 * t797 - s5 * a6_y + L3 * t804;
        let t817 = s5 * t797 + c5 * a6_y + (L3 * t801 + A * t796);
        let t818 = t815 - t798;
        let t824 = t363 * t804 - t816;
        let t825 = t818 - t360 * t804;
        let t826 = t360 * t796 + t363 * t801 - t817;
        let t831 = z1_3_y * t826 - (z1_4_y * t825 - z1_4_x * t824);
        let t836 = c3 * t826 + (z2_4_x * t824 + t237 * t825);
        let t840 = t815 - (s4 * t816 + c4 * t818);
        put(39, t831); // row 1, MSX6
        put(100, t836); // row 2, MSX6
        put(151, t840); // row 3, MSX6
        put(192, t817); // row 4, MSX6
        put(222, t798); // row 5, MSX6
        [t792, t795, t797, t798]
    };
    // MSY6: column
    let [t841, t844] = {
        let t841 = c6 * t202;
        let t843 = s6 * t205 - t841;
        let t844 = s6 * t202;
        let t846 = t844 + c6 * t205;
        let t849 = c5 * t843 + s5 * t208;
        let t852 = s5 * t843 - c5 * t208;
        let t863 = A * t852;
        let t864 = c5 * t798 - s5 * t173 + L3 * t852;
        let t865 = s5 * t798 + c5 * t173 + (A * t846 - L3 * t849);
        let t866 = t797 + t863;
        let t872 = t363 * t852 - t864;
        let t873 = t866 - t360 * t852;
        let t874 = t865 - (t360 * t846 - t363 * t849);
        let t879 = z1_4_x * t872 - z1_4_y * t873 - z1_3_y * t874;
        let t884 = z2_4_x * t872 + t237 * t873 - c3 * t874;
        let t888 = t863 - (s4 * t864 + c4 * t866);
        put(40, t879); // row 1, MSY6
        put(101, t884); // row 2, MSY6
        put(152, t888); // row 3, MSY6
        put(193, t865); // row 4, MSY6
        [t841, t844]
    };
    // MSZ6: column
    {
        let t891 = c6 * t203 + s6 * t206;
        let t894 = c6 * t206 - s6 * t203;
        let t897 = s5 * t209 - c5 * t891;
        let t900 = s5 * t891 + c5 * t209;
        let t907 = A * t900;
        let t908 = c5 * t759 - L3 * t900;
        let t909 = L3 * t897 + A * t894 - s5 * t759;
        let t910 = t756 + t907;
        let t916 = t908 + t363 * t900;
        let t917 = t360 * t900 - t910;
        let t918 = t360 * t894 + t363 * t897 - t909;
        let t923 = z1_3_y * t918 + (z1_4_x * t916 + z1_4_y * t917);
        let t928 = c3 * t918 + (z2_4_x * t916 - t237 * t917);
        let t932 = t907 + (s4 * t908 - c4 * t910);
        put(41, t923); // row 1, MSZ6
        put(102, t928); // row 2, MSZ6
        put(153, t932); // row 3, MSZ6
        put(194, t909); // row 4, MSZ6
    }
    // XX6: column
    let [t934, t937, t940, t945, t950, t955, t956] = {
        let t934 = s6 * t199;
        let t935 = c6 * dw6_x - t934;
        let t937 = c6 * t199;
        let t938 = s6 * dw6_x + t937;
        let t940 = t198 * t243;
        let t943 = z1_4_y * t938 - (t940 - z1_5_x * t935);
        let t945 = t198 * t249;
        let t948 = z2_5_x * t935 - t945 - t237 * t938;
        let t950 = t198 * z3_6_z;
        let t953 = c4 * t938 + (z3_5_x * t935 - t950);
        let t955 = c5 * t198;
        let t956 = s5 * t935 + t955;
        put(42, t943); // row 1, XX6
        put(103, t948); // row 2, XX6
        put(154, t953); // row 3, XX6
        put(225, t938); // row 5, XX6
        [t934, t937, t940, t945, t950, t955, t956]
    };
    // YY6: column
    let [t957, t960] = {
        let t957 = c6 * t200;
        let t959 = t957 + s6 * dw6_y;
        let t960 = s6 * t200;
        let t962 = c6 * dw6_y - t960;
        let t966 = z1_4_y * t962 - (z1_5_x * t959 - t940);
        let t970 = t945 - z2_5_x * t959 - t237 * t962;
        let t974 = c4 * t962 - (z3_5_x * t959 - t950);
        let t976 = t955 + s5 * t959;
        put(43, t966); // row 1, YY6
        put(104, t970); // row 2, YY6
        put(155, t974); // row 3, YY6
        put(196, t976); // row 4, YY6
        put(226, t962); // row 5, YY6
        [t957, t960]
    };
    // ZZ6: column
    {
        let t977 = t934 + t957;
        let t978 = t960 - t937;
        let t983 = z1_4_y * t978 + (z1_5_x * t977 + dw6_z * t243);
        let t988 = z2_5_x * t977 + dw6_z * t249 - t237 * t978;
        let t993 = c4 * t978 + (z3_5_x * t977 + dw6_z * z3_6_z);
        let t996 = c5 * dw6_z - s5 * t977;
        put(44, t983); // row 1, ZZ6
        put(105, t988); // row 2, ZZ6
        put(156, t993); // row 3, ZZ6
        put(197, t996); // row 4, ZZ6
        put(227, t978); // row 5, ZZ6
    }
    // XY6: column
    {
        let t997 = t195 - t196;
        let t1000 = c6 * t207 - s6 * t208;
        let t1003 = s6 * t207 + c6 * t208;
        let t1008 = z1_4_y * t1003 + (z1_5_x * t1000 + t243 * t997);
        let t1013 = z2_5_x * t1000 + t249 * t997 - t237 * t1003;
        let t1018 = c4 * t1003 + (z3_5_x * t1000 + z3_6_z * t997);
        let t1021 = c5 * t997 - s5 * t1000;
        put(45, t1008); // row 1, XY6
        put(106, t1013); // row 2, XY6
        put(157, t1018); // row 3, XY6
        put(198, t1021); // row 4, XY6
        put(228, t1003); // row 5, XY6
        put(249, t997); // row 6, XY6
    }
    // XZ6: column
    {
        let t1022 = t197 - t195;
        let t1024 = s6 * t1022 - t795;
        let t1026 = t792 + c6 * t1022;
        let t1031 = z1_4_y * t1026 - (z1_5_x * t1024 - t206 * t243);
        let t1036 = t206 * t249 - z2_5_x * t1024 - t237 * t1026;
        let t1041 = c4 * t1026 + (t206 * z3_6_z - z3_5_x * t1024);
        let t1044 = s5 * t1024 + c5 * t206;
        put(46, t1031); // row 1, XZ6
        put(107, t1036); // row 2, XZ6
        put(158, t1041); // row 3, XZ6
        put(199, t1044); // row 4, XZ6
        put(229, t1026); // row 5, XZ6
    }
    // YZ6: column
    {
        let t1045 = t197 - t196;
        let t1047 = t844 + c6 * t1045;
        let t1049 = t841 - s6 * t1045;
        let t1054 = z1_4_y * t1049 + (t203 * t243 - z1_5_x * t1047);
        let t1059 = t203 * t249 - z2_5_x * t1047 - t237 * t1049;
        let t1064 = c4 * t1049 + (t203 * z3_6_z - z3_5_x * t1047);
        let t1067 = s5 * t1047 + c5 * t203;
        put(47, t1054); // row 1, YZ6
        put(108, t1059); // row 2, YZ6
        put(159, t1064); // row 3, YZ6
        put(200, t1067); // row 4, YZ6
        put(230, t1049); // row 5, YZ6
    }
    // M7: column
    let [
        t1068, t1069, t1070, t1071, t1072, t1073, t1074, t1075,
        t1076, t1077, t1078, t1079, t1080, t1081, t1082, t1085,
        t1088,
    ] = {
        let t1068 = w7_x * w7_x;
        let t1069 = w7_y * w7_y;
        let t1070 = t222 * t222;
        let t1071 = w7_x * w7_y;
        let t1072 = w7_x * t222;
        let t1073 = w7_y * t222;
        let t1074 = t1069 + t1070;
        let t1075 = t227 + t1071;
        let t1076 = dw7_y - t1072;
        let t1077 = t1071 - t227;
        let t1078 = t1068 + t1070;
        let t1079 = dw7_x + t1073;
        let t1080 = dw7_y + t1072;
        let t1081 = t1073 - dw7_x;
        let t1082 = t1068 + t1069;
        let t1085 = c7 * t218 + s7 * a7_y;
        let t1088 = s7 * t218 - c7 * a7_y;
        let t1089 = k4 * t214;
        let t1090 = k4 * t1088;
        let t1093 = c6 * t1085 + s6 * t214;
        let t1096 = s6 * t1085 - c6 * t214;
        let t1097 = s6 * t1090;
        let t1098 = c6 * t1090;
        let t1101 = c5 * t1093 + s5 * t1088;
        let t1104 = c5 * t1088 - s5 * t1093;
        let t1115 = A * t1104;
        let t1116 = s5 * t1089 - c5 * t1097 - L3 * t1104;
        let t1117 = s5 * t1097 + c5 * t1089 + (L3 * t1101 + A * t1096);
        let t1118 = t1098 - t1115;
        let t1124 = t1116 + t363 * t1104;
        let t1125 = t1118 + t360 * t1104;
        let t1126 = t360 * t1096 + t363 * t1101 - t1117;
        let t1131 = z1_3_y * t1126 + (z1_4_x * t1124 + z1_4_y * t1125);
        let t1136 = c3 * t1126 - (t237 * t1125 - z2_4_x * t1124);
        let t1140 = t1115 + (s4 * t1116 + c4 * t1118);
        put(48, t1131); // row 1, M7
        put(109, t1136); // row 2, M7
        put(160, t1140); // row 3, M7
        put(201, t1117); // row 4, M7
        put(231, t1098); // row 5, M7
        put(252, t1089); // row 6, M7
        put(268, t1071); // row 7, YY7
        put(271, t1079); // row 7, XZ7
        put(272, t1076); // row 7, YZ7
        [
        t1068, t1069, t1070, t1071, t1072, t1073, t1074, t1075,
        t1076, t1077, t1078, t1079, t1080, t1081, t1082, t1085,
        t1088,
    ]
    };
    // MSX7: column
    let [t1142, t1145, t1147, t1148] = {
        let t1142 = s7 * t1077;
        let t1143 = c7 * t1074 + t1142;
        let t1145 = c7 * t1077;
        let t1146 = s7 * t1074 - t1145;
        let t1147 = s7 * t214;
        let t1148 = c7 * t214;
        let t1151 = t1148 + k4 * t1080;
        let t1152 = k4 * t1146 - a7_y;
        let t1155 = c6 * t1143 + s6 * t1080;
        let t1158 = s6 * t1143 - c6 * t1080;
        let t1161 = c6 * t1147 + s6 * t1152;
        let t1164 = c6 * t1152 - s6 * t1147;
        let t1167 = c5 * t1155 + s5 * t1146;
        let t1170 = s5 * t1155 - c5 * t1146;
        let t1181 = A * t1170;
        let t1182 = s5 * t1151 - c5 * t1161 + L3 * t1170;
        let t1183 = s5 * t1161 + c5 * t1151 + (L3 * t1167 + A * t1158);
        let t1184 = t1164 + t1181;
        let t1190 = t1182 - t363 * t1170;
        let t1191 = t1184 - t360 * t1170;
        let t1192 = t360 * t1158 + t363 * t1167 - t1183;
        let t1197 = z1_3_y * t1192 + (z1_4_x * t1190 + z1_4_y * t1191);
        let t1202 = c3 * t1192 + (z2_4_x * t1190 - t237 * t1191);
        let t1206 = s4 * t1182 + c4 * t1184 - t1181;
        put(49, t1197); // row 1, MSX7
        put(110, t1202); // row 2, MSX7
        put(161, t1206); // row 3, MSX7
        put(202, t1183); // row 4, MSX7
        put(232, t1164); // row 5, MSX7
        put(253, t1151); // row 6, MSX7
        [t1142, t1145, t1147, t1148]
    };
    // MSY7: column
    let [t1207, t1210] = {
        let t1207 = c7 * t1075;
        let t1209 = t1207 + s7 * t1078;
        let t1210 = s7 * t1075;
        let t1212 = c7 * t1078 - t1210;
        let t1215 = k4 * t1081 - t1147;
        let t1216 = k4 * t1212 - t218;
        let t1219 = s6 * t1081 - c6 * t1209;
        let t1222 = s6 * t1209 + c6 * t1081;
        let t1225 = c6 * t1148 + s6 * t1216;
        let t1228 = c6 * t1216 - s6 * t1148;
        let t1231 = c5 * t1219 + s5 * t1212;
        let t1234 = c5 * t1212 - s5 * t1219;
        let t1245 = A * t1234;
        let t1246 = s5 * t1215 - c5 * t1225 - L3 * t1234;
        let t1247 = s5 * t1225 + c5 * t1215 - (A * t1222 - L3 * t1231);
        let t1248 = t1245 - t1228;
        let t1254 = t1246 + t363 * t1234;
        let t1255 = t1248 - t360 * t1234;
        let t1256 = t1247 + (t360 * t1222 - t363 * t1231);
        let t1261 = z1_4_x * t1254 - z1_4_y * t1255 - z1_3_y * t1256;
        let t1266 = z2_4_x * t1254 + t237 * t1255 - c3 * t1256;
        let t1270 = t1245 + (s4 * t1246 - c4 * t1248);
        put(50, t1261); // row 1, MSY7
        put(111, t1266); // row 2, MSY7
        put(162, t1270); // row 3, MSY7
        put(203, t1247); // row 4, MSY7
        put(233, t1228); // row 5, MSY7
        put(254, t1215); // row 6, MSY7
        [t1207, t1210]
    };
    // MSZ7: column
    {
        let t1273 = c7 * t1076 + s7 * t1079;
        let t1276 = c7 * t1079 - s7 * t1076;
        let t1278 = k4 * t1276;
        let t1279 = k4 * t1082 - t1085;
        let t1282 = s6 * t1082 - c6 * t1273;
        let t1285 = s6 * t1273 + c6 * t1082;
        let t1288 = c6 * t1088 - s6 * t1278;
        let t1291 = s6 * t1088 + c6 * t1278;
        let t1294 = c5 * t1282 + s5 * t1276;
        let t1297 = c5 * t1276 - s5 * t1282;
        let t1308 = A * t1297;
        let t1309 = c5 * t1288 + s5 * t1279 - L3 * t1297;
        let t1310 = c5 * t1279 - s5 * t1288 - (A * t1285 - L3 * t1294);
        let t1311 = t1308 - t1291;
        let t1317 = t1309 + t363 * t1297;
        let t1318 = t360 * t1297 - t1311;
        let t1319 = t363 * t1294 - t360 * t1285 - t1310;
        let t1324 = z1_3_y * t1319 + (z1_4_x * t1317 + z1_4_y * t1318);
        let t1329 = c3 * t1319 - (t237 * t1318 - z2_4_x * t1317);
        let t1333 = t1308 + (s4 * t1309 - c4 * t1311);
        put(51, t1324); // row 1, MSZ7
        put(112, t1329); // row 2, MSZ7
        put(163, t1333); // row 3, MSZ7
        put(204, t1310); // row 4, MSZ7
        put(234, t1291); // row 5, MSZ7
        put(255, t1279); // row 6, MSZ7
    }
    // XX7: column
    let [t1335, t1338, t1341, t1344] = {
        let t1335 = s7 * t1072;
        let t1336 = c7 * dw7_x + t1335;
        let t1338 = c7 * t1072;
        let t1339 = s7 * dw7_x - t1338;
        let t1341 = s6 * t1071;
        let t1342 = t1341 - c6 * t1336;
        let t1344 = c6 * t1071;
        let t1345 = s6 * t1336 + t1344;
        let t1350 = z1_4_y * t1345 - (z1_5_x * t1342 - t243 * t1339);
        let t1355 = t249 * t1339 - z2_5_x * t1342 - t237 * t1345;
        let t1360 = c4 * t1345 + (z3_6_z * t1339 - z3_5_x * t1342);
        let t1363 = s5 * t1342 + c5 * t1339;
        put(52, t1350); // row 1, XX7
        put(113, t1355); // row 2, XX7
        put(164, t1360); // row 3, XX7
        put(205, t1363); // row 4, XX7
        put(235, t1345); // row 5, XX7
        put(256, t1339); // row 6, XX7
        [t1335, t1338, t1341, t1344]
    };
    // YY7: column
    let [t1364, t1367] = {
        let t1364 = c7 * t1073;
        let t1366 = t1364 - s7 * dw7_y;
        let t1367 = s7 * t1073;
        let t1369 = t1367 + c7 * dw7_y;
        let t1371 = t1341 + c6 * t1366;
        let t1373 = s6 * t1366 - t1344;
        let t1378 = z1_4_y * t1373 + (z1_5_x * t1371 + t243 * t1369);
        let t1383 = z2_5_x * t1371 + t249 * t1369 - t237 * t1373;
        let t1388 = c4 * t1373 + (z3_5_x * t1371 + z3_6_z * t1369);
        let t1391 = c5 * t1369 - s5 * t1371;
        put(53, t1378); // row 1, YY7
        put(114, t1383); // row 2, YY7
        put(165, t1388); // row 3, YY7
        put(206, t1391); // row 4, YY7
        put(236, t1373); // row 5, YY7
        put(257, t1369); // row 6, YY7
        [t1364, t1367]
    };
    // ZZ7: column
    {
        let t1392 = t1335 + t1364;
        let t1393 = t1338 - t1367;
        let t1396 = c6 * t1392 + s6 * t227;
        let t1399 = c6 * t227 - s6 * t1392;
        let t1404 = z1_4_y * t1399 - (z1_5_x * t1396 - t243 * t1393);
        let t1409 = t249 * t1393 - z2_5_x * t1396 - t237 * t1399;
        let t1414 = c4 * t1399 + (z3_6_z * t1393 - z3_5_x * t1396);
        let t1417 = s5 * t1396 + c5 * t1393;
        put(54, t1404); // row 1, ZZ7
        put(115, t1409); // row 2, ZZ7
        put(166, t1414); // row 3, ZZ7
        put(207, t1417); // row 4, ZZ7
        put(237, t1399); // row 5, ZZ7
        put(258, t1393); // row 6, ZZ7
    }
    // XY7: column
    {
        let t1418 = t1068 - t1069;
        let t1421 = c7 * t1080 + s7 * t1081;
        let t1424 = s7 * t1080 - c7 * t1081;
        let t1427 = c6 * t1421 + s6 * t1418;
        let t1430 = s6 * t1421 - c6 * t1418;
        let t1435 = z1_4_y * t1430 + (z1_5_x * t1427 + t243 * t1424);
        let t1440 = z2_5_x * t1427 + t249 * t1424 - t237 * t1430;
        let t1445 = c4 * t1430 + (z3_5_x * t1427 + z3_6_z * t1424);
        let t1448 = c5 * t1424 - s5 * t1427;
        put(55, t1435); // row 1, XY7
        put(116, t1440); // row 2, XY7
        put(167, t1445); // row 3, XY7
        put(208, t1448); // row 4, XY7
        put(238, t1430); // row 5, XY7
        put(259, t1424); // row 6, XY7
        put(270, t1418); // row 7, XY7
    }
    // XZ7: column
    {
        let t1449 = t1070 - t1068;
        let t1451 = t1145 - s7 * t1449;
        let t1453 = t1142 + c7 * t1449;
        let t1456 = c6 * t1451 + s6 * t1079;
        let t1459 = s6 * t1451 - c6 * t1079;
        let t1464 = z1_4_y * t1459 + (z1_5_x * t1456 + t243 * t1453);
        let t1469 = z2_5_x * t1456 + t249 * t1453 - t237 * t1459;
        let t1474 = c4 * t1459 + (z3_5_x * t1456 + z3_6_z * t1453);
        let t1477 = c5 * t1453 - s5 * t1456;
        put(56, t1464); // row 1, XZ7
        put(117, t1469); // row 2, XZ7
        put(168, t1474); // row 3, XZ7
        put(209, t1477); // row 4, XZ7
        put(239, t1459); // row 5, XZ7
        put(260, t1453); // row 6, XZ7
    }
    // YZ7: column
    {
        let t1478 = t1069 - t1070;
        let t1480 = t1210 + c7 * t1478;
        let t1482 = s7 * t1478 - t1207;
        let t1485 = c6 * t1480 + s6 * t1076;
        let t1488 = s6 * t1480 - c6 * t1076;
        let t1493 = z1_4_y * t1488 + (z1_5_x * t1485 + t243 * t1482);
        let t1498 = z2_5_x * t1485 + t249 * t1482 - t237 * t1488;
        let t1503 = c4 * t1488 + (z3_5_x * t1485 + z3_6_z * t1482);
        let t1506 = c5 * t1482 - s5 * t1485;
        let t1507 = dq1.sign();
        let t1508 = dq2.sign();
        let t1509 = dq3.sign();
        let t1510 = dq4.sign();
        let t1511 = dq5.sign();
        let t1512 = dq6.sign();
        let t1513 = dq7.sign();
        let t1514 = -t5;
        let t1515 = -t25;
        let t1516 = -t2;
        let t1517 = -t3;
        let t1518 = -t320;
        let t1519 = -t694;
        let t1520 = -t65;
        let t1521 = -t418;
        let t1522 = -t108;
        let t1523 = -t688;
        let t1524 = -t956;
        let t1525 = -t159;
        let t1526 = -t797;
        let t1527 = -t756;
        let t1528 = -t198;
        let t1529 = -t1071;
        let t1530 = -t227;
        put(57, t1493); // row 1, YZ7
        put(59, t1507); // row 1, FC1
        put(61, t1514); // row 2, MSX2
        put(63, t1515); // row 2, XX2
        put(67, t1516); // row 2, XZ2
        put(68, t1517); // row 2, YZ2
        put(70, t1518); // row 2, MSX3
        put(95, t1519); // row 2, ZZ5
        put(118, t1498); // row 2, YZ7
        put(120, t1508); // row 2, FC2
        put(125, t1520); // row 3, YY3
        put(132, t1521); // row 3, MSY4
        put(169, t1503); // row 3, YZ7
        put(171, t1509); // row 3, FC3
        put(176, t1522); // row 4, YY4
        put(186, t1523); // row 4, YY5
        put(195, t1524); // row 4, XX6
        put(210, t1506); // row 4, YZ7
        put(212, t1510); // row 4, FC4
        put(216, t1525); // row 5, XX5
        put(223, t1526); // row 5, MSY6
        put(224, t1527); // row 5, MSZ6
        put(240, t1488); // row 5, YZ7
        put(242, t1511); // row 5, FC5
        put(246, t1528); // row 6, XX6
        put(261, t1482); // row 6, YZ7
        put(263, t1512); // row 6, FC6
        put(267, t1529); // row 7, XX7
        put(269, t1530); // row 7, ZZ7
        put(274, t1513); // row 7, FC7
    }
}
