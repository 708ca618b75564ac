//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil and Dombre, 12.4.
//!
//! 421 multiplications, 330 additions; 6 x 84, 212 of 504 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 212;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 6), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18), (0, 19), (0, 20), (0, 21),
    (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28), (0, 29), (0, 30), (0, 31),
    (0, 32), (0, 33), (0, 34), (0, 35), (0, 36), (0, 37), (0, 38), (0, 39), (0, 40), (0, 41),
    (0, 42), (0, 43), (0, 44), (0, 45), (0, 46), (0, 47), (0, 48), (0, 49), (0, 50), (0, 51),
    (0, 52), (0, 53), (0, 54), (0, 55), (0, 56), (0, 57), (0, 58), (0, 59), (0, 60), (0, 66),
    (0, 72), (0, 78), (1, 11), (1, 12), (1, 14), (1, 15), (1, 16), (1, 17), (1, 18), (1, 19),
    (1, 20), (1, 21), (1, 22), (1, 23), (1, 24), (1, 25), (1, 26), (1, 27), (1, 28), (1, 29),
    (1, 30), (1, 31), (1, 32), (1, 33), (1, 34), (1, 35), (1, 36), (1, 37), (1, 38), (1, 39),
    (1, 40), (1, 41), (1, 42), (1, 43), (1, 44), (1, 45), (1, 46), (1, 47), (1, 48), (1, 49),
    (1, 50), (1, 51), (1, 52), (1, 53), (1, 54), (1, 55), (1, 56), (1, 57), (1, 58), (1, 59),
    (1, 61), (1, 67), (1, 73), (1, 79), (2, 21), (2, 22), (2, 24), (2, 25), (2, 26), (2, 27),
    (2, 28), (2, 29), (2, 30), (2, 31), (2, 32), (2, 33), (2, 34), (2, 35), (2, 36), (2, 37),
    (2, 38), (2, 39), (2, 40), (2, 41), (2, 42), (2, 43), (2, 44), (2, 45), (2, 46), (2, 47),
    (2, 48), (2, 49), (2, 50), (2, 51), (2, 52), (2, 53), (2, 54), (2, 55), (2, 56), (2, 57),
    (2, 58), (2, 59), (2, 62), (2, 68), (2, 74), (2, 80), (3, 31), (3, 32), (3, 34), (3, 35),
    (3, 36), (3, 37), (3, 38), (3, 39), (3, 40), (3, 41), (3, 42), (3, 43), (3, 44), (3, 45),
    (3, 46), (3, 47), (3, 48), (3, 49), (3, 50), (3, 51), (3, 52), (3, 53), (3, 54), (3, 55),
    (3, 56), (3, 57), (3, 58), (3, 59), (3, 63), (3, 69), (3, 75), (3, 81), (4, 41), (4, 42),
    (4, 44), (4, 45), (4, 46), (4, 47), (4, 48), (4, 49), (4, 50), (4, 51), (4, 52), (4, 53),
    (4, 54), (4, 55), (4, 56), (4, 57), (4, 58), (4, 59), (4, 64), (4, 70), (4, 76), (4, 82),
    (5, 51), (5, 52), (5, 54), (5, 55), (5, 56), (5, 57), (5, 58), (5, 59), (5, 65), (5, 71),
    (5, 77), (5, 83),
];

/// Regressor `W` of the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 84]; 6]) {
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
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let A3 = S::constant(-0.57155);
    let D4 = S::constant(0.17415);
    let D5 = S::constant(0.11985);
    let D6 = S::constant(0.11655);
    let k0 = S::constant(9.81);
    let k1 = S::constant(0.6127);
    let k2 = S::constant(0.57155);
    let k7 = S::constant(1.0);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        put(0, ddq1); // row 1, ZZ1
        put(48, ddq1); // row 1, IA1
        put(49, dq1); // row 1, FV1
        put(51, k7); // row 1, FO1
        put(56, ddq2); // row 2, ZZ2
        put(100, ddq2); // row 2, IA2
        put(101, dq2); // row 2, FV2
        put(103, k7); // row 2, FO2
        put(142, ddq3); // row 3, IA3
        put(143, dq3); // row 3, FV3
        put(145, k7); // row 3, FO3
        put(174, ddq4); // row 4, IA4
        put(175, dq4); // row 4, FV4
        put(177, k7); // row 4, FO4
        put(196, ddq5); // row 5, IA5
        put(197, dq5); // row 5, FV5
        put(199, k7); // row 5, FO5
        put(208, ddq6); // row 6, IA6
        put(209, dq6); // row 6, FV6
        put(211, k7); // row 6, FO6
        t0
    };
    // link 2: motion
    let [
        w2_x, w2_y, t3, t4, a2_x, a2_y, t9, t10,
        t11, dw2_x, dw2_y, t14, t15, t16, t17, t18,
        t19, t20,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t3 = s2 * ddq1;
        let t4 = c2 * ddq1;
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let t7 = w2_x * w2_x;
        let t8 = dq2 * dq2;
        let t9 = w2_x * w2_y;
        let t10 = dq2 * w2_x;
        let t11 = dq2 * w2_y;
        let dw2_x = t3 + t11;
        let dw2_y = t4 - t10;
        let t14 = t7 - t8;
        let t15 = t14 - t0;
        let t16 = ddq2 - t9;
        let t17 = ddq2 + t9;
        let t18 = t7 + t8;
        let t19 = dw2_y - t10;
        let t20 = t11 + dw2_x;
        put(52, a2_y); // row 2, MSX2
        put(55, t9); // row 2, YY2
        put(58, t3); // row 2, XZ2
        put(59, t4); // row 2, YZ2
        [
        w2_x, w2_y, t3, t4, a2_x, a2_y, t9, t10,
        t11, dw2_x, dw2_y, t14, t15, t16, t17, t18,
        t19, t20,
    ]
    };
    // link 3: motion
    let [
        w3_x, t26, t29, t34, a3_y, t40, t43, w3_z,
        dw3_z, t48, t49, t50, dw3_x, dw3_y, t53, t54,
        t55, t56, t57, t58, t59,
    ] = {
        let w3_x = c3 * w2_x + s3 * w2_y;
        let t26 = s3 * w2_x - c3 * w2_y;
        let t29 = t19 * k1;
        let t30 = t15 * k1 - a2_x;
        let t31 = a2_y - t17 * k1;
        let t34 = c3 * t30 - s3 * t31;
        let a3_y = c3 * t31 + s3 * t30;
        let t40 = c3 * t4 - s3 * t3;
        let t43 = c3 * t3 + s3 * t4;
        let w3_z = dq2 + dq3;
        let dw3_z = ddq2 + ddq3;
        let t46 = w3_x * w3_x;
        let t47 = w3_z * w3_z;
        let t48 = w3_x * t26;
        let t49 = w3_x * w3_z;
        let t50 = t26 * w3_z;
        let dw3_x = t43 - t50;
        let dw3_y = t40 - t49;
        let t53 = t47 - t46;
        let t54 = t0 + t53;
        let t55 = dw3_z + t48;
        let t56 = dw3_z - t48;
        let t57 = t46 + t47;
        let t58 = dw3_y - t49;
        let t59 = t50 - dw3_x;
        put(64, t48); // row 2, XX3
        put(66, dw3_z); // row 2, ZZ3
        put(68, t43); // row 2, XZ3
        put(69, t40); // row 2, YZ3
        put(104, a3_y); // row 3, MSX3
        put(105, t34); // row 3, MSY3
        put(106, t48); // row 3, XX3
        put(108, dw3_z); // row 3, ZZ3
        put(110, t43); // row 3, XZ3
        put(111, t40); // row 3, YZ3
        [
        w3_x, t26, t29, t34, a3_y, t40, t43, w3_z,
        dw3_z, t48, t49, t50, dw3_x, dw3_y, t53, t54,
        t55, t56, t57, t58, t59,
    ]
    };
    // link 4: motion
    let [
        w4_x, t65, t77, t80, a4_y, t86, t89, w4_z,
        t94, t95, t96, dw4_x, t98, t99, t100, t101,
        t102, t103, t104, t105,
    ] = {
        let w4_x = c4 * w3_x - s4 * t26;
        let t65 = c4 * t26 + s4 * w3_x;
        let t75 = t34 - (t54 * k2 + D4 * t40);
        let t76 = t56 * k2 + D4 * t43 - a3_y;
        let t77 = t29 + (t58 * k2 - D4 * t0);
        let t80 = c4 * t75 + s4 * t76;
        let a4_y = s4 * t75 - c4 * t76;
        let t86 = s4 * t43 - c4 * t40;
        let t89 = c4 * t43 + s4 * t40;
        let w4_z = w3_z + dq4;
        let dw4_z = dw3_z + ddq4;
        let t92 = w4_x * w4_x;
        let t93 = w4_z * w4_z;
        let t94 = w4_x * t65;
        let t95 = w4_x * w4_z;
        let t96 = t65 * w4_z;
        let dw4_x = t89 - t96;
        let t98 = t86 + t95;
        let t99 = t92 - t93;
        let t100 = t99 - t0;
        let t101 = dw4_z + t94;
        let t102 = dw4_z - t94;
        let t103 = t92 + t93;
        let t104 = t95 + t98;
        let t105 = t96 - dw4_x;
        put(74, t94); // row 2, XX4
        put(76, dw4_z); // row 2, ZZ4
        put(78, t89); // row 2, XZ4
        put(116, t94); // row 3, XX4
        put(118, dw4_z); // row 3, ZZ4
        put(120, t89); // row 3, XZ4
        put(146, a4_y); // row 4, MSX4
        put(147, t80); // row 4, MSY4
        put(148, t94); // row 4, XX4
        put(150, dw4_z); // row 4, ZZ4
        put(152, t89); // row 4, XZ4
        [
        w4_x, t65, t77, t80, a4_y, t86, t89, w4_z,
        t94, t95, t96, dw4_x, t98, t99, t100, t101,
        t102, t103, t104, t105,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t116, t120, a5_y, t126, t129, w5_z,
        dw5_z, t134, t135, t136, dw5_x, t138, t139, t140,
        t141, t142, t143, t144, t145,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t115 = t80 - D5 * t101;
        let t116 = a4_y + D5 * t103;
        let t117 = t77 + D5 * t105;
        let t120 = c5 * t115 - s5 * t117;
        let a5_y = c5 * t117 + s5 * t115;
        let t126 = c5 * t101 + s5 * t105;
        let t129 = s5 * t101 - c5 * t105;
        let w5_z = t65 + dq5;
        let dw5_z = t98 + ddq5;
        let t132 = w5_x * w5_x;
        let t133 = w5_z * w5_z;
        let t134 = w5_x * w5_y;
        let t135 = w5_x * w5_z;
        let t136 = w5_y * w5_z;
        let dw5_x = t129 + t136;
        let t138 = t126 - t135;
        let t139 = t133 - t132;
        let t140 = t103 + t139;
        let t141 = t134 - dw5_z;
        let t142 = dw5_z + t134;
        let t143 = t132 + t133;
        let t144 = t138 - t135;
        let t145 = t136 + dw5_x;
        put(178, a5_y); // row 5, MSX5
        put(179, t120); // row 5, MSY5
        put(181, t134); // row 5, YY5
        put(182, dw5_z); // row 5, ZZ5
        put(184, t129); // row 5, XZ5
        put(185, t126); // row 5, YZ5
        [
        w5_x, w5_y, t116, t120, a5_y, t126, t129, w5_z,
        dw5_z, t134, t135, t136, dw5_x, t138, t139, t140,
        t141, t142, t143, t144, t145,
    ]
    };
    // link 6: motion
    let [
        t156, t160, a6_y, t166, t169, dw6_z, t174, t175,
        t176, t177, t178, t179, t180, t181, t182, t183,
        t184, t185,
    ] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t151 = c6 * w5_z + s6 * w5_x;
        let t155 = t120 - D6 * t141;
        let t156 = a5_y - D6 * t143;
        let t157 = t116 - D6 * t145;
        let t160 = c6 * t155 - s6 * t157;
        let a6_y = c6 * t157 + s6 * t155;
        let t166 = c6 * t141 - s6 * t145;
        let t169 = c6 * t145 + s6 * t141;
        let w6_z = w5_y + dq6;
        let dw6_z = t138 + ddq6;
        let t172 = w6_x * w6_x;
        let t173 = w6_z * w6_z;
        let t174 = w6_x * t151;
        let t175 = w6_x * w6_z;
        let t176 = t151 * w6_z;
        let t177 = t176 - t169;
        let t178 = t175 - t166;
        let t179 = t172 - t173;
        let t180 = t143 - t179;
        let t181 = dw6_z + t174;
        let t182 = dw6_z - t174;
        let t183 = t172 + t173;
        let t184 = t175 + t178;
        let t185 = t176 + t177;
        put(200, a6_y); // row 6, MSX6
        put(201, t160); // row 6, MSY6
        put(202, t174); // row 6, XX6
        put(204, dw6_z); // row 6, ZZ6
        put(206, t169); // row 6, XZ6
        put(207, t166); // row 6, YZ6
        [
        t156, t160, a6_y, t166, t169, dw6_z, t174, t175,
        t176, t177, t178, t179, t180, t181, t182, t183,
        t184, t185,
    ]
    };
    // joint axes in frame 3
    let [v1_3_z, z1_3_x, t192, t193, t194] = {
        let v1_3_z = c2 * k1;
        let z1_3_x = s2 * c3 + c2 * s3;
        let t192 = s2 * s3 - c2 * c3;
        let t193 = s3 * k1;
        let t194 = c3 * k1;
        [v1_3_z, z1_3_x, t192, t193, t194]
    };
    // joint axes in frame 4
    let [
        t198, z1_4_x, t204, t207, t210, t214, v2_4_y, t218,
        v3_5_z,
    ] = {
        let t195 = D4 * t192;
        let t196 = D4 * z1_3_x;
        let t198 = k2 * t192 - v1_3_z;
        let z1_4_x = c4 * z1_3_x - s4 * t192;
        let t204 = c4 * t192 + s4 * z1_3_x;
        let t207 = c4 * t195 + s4 * t196;
        let t210 = s4 * t195 - c4 * t196;
        let t211 = A3 - t194;
        let t214 = c4 * t193 - s4 * t211;
        let v2_4_y = c4 * t211 + s4 * t193;
        let t218 = s4 * k2;
        let v3_5_z = c4 * k2;
        [
        t198, z1_4_x, t204, t207, t210, t214, v2_4_y, t218,
        v3_5_z,
    ]
    };
    // joint axes in frame 5
    let [z1_5_x, t221] = {
        let z1_5_x = c5 * z1_4_x;
        let t221 = s5 * z1_4_x;
        [z1_5_x, t221]
    };
    // MSZ2: column
    {
        let t224 = c2 * a2_x - s2 * a2_y;
        put(1, t224); // row 1, MSZ2
    }
    // XX2: column
    let t226 = {
        let t226 = c2 * t10;
        let t227 = s2 * dw2_x + t226;
        put(2, t227); // row 1, XX2
        t226
    };
    // YY2: column
    let t228 = {
        let t228 = s2 * t11;
        let t230 = c2 * dw2_y - t228;
        put(3, t230); // row 1, YY2
        t228
    };
    // ZZ2: column
    {
        let t231 = t228 - t226;
        put(4, t231); // row 1, ZZ2
    }
    // XY2: column
    {
        let t232 = t15 + t18;
        let t235 = s2 * t19 + c2 * t20;
        put(5, t235); // row 1, XY2
        put(57, t232); // row 2, XY2
    }
    // XZ2: column
    {
        let t238 = s2 * t17 - c2 * t14;
        put(6, t238); // row 1, XZ2
    }
    // YZ2: column
    {
        let t242 = s2 * (t0 - t18) + c2 * t16;
        put(7, t242); // row 1, YZ2
    }
    // M3: column
    {
        let t243 = t29 * v1_3_z;
        let t246 = t34 * t193 - a3_y * t194;
        put(8, t243); // row 1, M3
        put(60, t246); // row 2, M3
    }
    // MSX3: column
    {
        let t249 = t29 * t192 - t58 * v1_3_z;
        let t253 = a3_y + (t54 * t193 - t56 * t194);
        put(9, t249); // row 1, MSX3
        put(61, t253); // row 2, MSX3
    }
    // MSY3: column
    {
        let t256 = t29 * z1_3_x - t59 * v1_3_z;
        let t260 = t34 + (t55 * t193 + t57 * t194);
        put(10, t256); // row 1, MSY3
        put(62, t260); // row 2, MSY3
    }
    // MSZ3: column
    {
        let t265 = t34 * t192 - a3_y * z1_3_x - t0 * v1_3_z;
        let t268 = t43 * t194 - t40 * t193;
        put(11, t265); // row 1, MSZ3
        put(63, t268); // row 2, MSZ3
    }
    // XX3: column
    let t270 = {
        let t270 = t49 * t192;
        let t271 = dw3_x * z1_3_x - t270;
        put(12, t271); // row 1, XX3
        t270
    };
    // YY3: column
    let t272 = {
        let t272 = t50 * z1_3_x;
        let t274 = t272 - dw3_y * t192;
        put(13, t274); // row 1, YY3
        t272
    };
    // ZZ3: column
    {
        let t275 = t270 - t272;
        put(14, t275); // row 1, ZZ3
    }
    // XY3: column
    {
        let t276 = t57 - t54;
        let t279 = t58 * z1_3_x + t59 * t192;
        put(15, t279); // row 1, XY3
        put(67, t276); // row 2, XY3
        put(109, t276); // row 3, XY3
    }
    // XZ3: column
    {
        let t282 = t56 * z1_3_x - t53 * t192;
        put(16, t282); // row 1, XZ3
    }
    // YZ3: column
    {
        let t286 = z1_3_x * (t0 - t57) - t55 * t192;
        put(17, t286); // row 1, YZ3
    }
    // M4: column
    {
        let t291 = t80 * t207 + a4_y * t210 - t77 * t198;
        let t294 = t80 * t214 + a4_y * v2_4_y;
        let t297 = t80 * t218 - a4_y * v3_5_z;
        put(18, t291); // row 1, M4
        put(70, t294); // row 2, M4
        put(112, t297); // row 3, M4
    }
    // MSX4: column
    {
        let t304 = t77 * t204 - (t104 * t198 + (t100 * t207 - t102 * t210));
        let t308 = a4_y + (t102 * v2_4_y - t100 * t214);
        let t312 = a4_y - (t100 * t218 + t102 * v3_5_z);
        put(19, t304); // row 1, MSX4
        put(71, t308); // row 2, MSX4
        put(113, t312); // row 3, MSX4
    }
    // MSY4: column
    let [t315, t321, t325] = {
        let t315 = t103 * t210;
        let t319 = t77 * z1_4_x + (t105 * t198 + (t101 * t207 - t315));
        let t321 = t103 * v2_4_y;
        let t323 = t80 + (t101 * t214 - t321);
        let t325 = t103 * v3_5_z;
        let t327 = t80 + (t101 * t218 + t325);
        put(20, t319); // row 1, MSY4
        put(72, t323); // row 2, MSY4
        put(114, t327); // row 3, MSY4
        [t315, t321, t325]
    };
    // MSZ4: column
    {
        let t335 = t89 * t210 - t86 * t207 - t0 * t198;
        let t336 = t80 * t204 - a4_y * z1_4_x - t335;
        let t339 = t86 * t214 - t89 * v2_4_y;
        let t342 = t86 * t218 + t89 * v3_5_z;
        put(21, t336); // row 1, MSZ4
        put(73, t339); // row 2, MSZ4
        put(115, t342); // row 3, MSZ4
    }
    // XX4: column
    let t344 = {
        let t344 = t95 * t204;
        let t345 = dw4_x * z1_4_x - t344;
        put(22, t345); // row 1, XX4
        t344
    };
    // YY4: column
    let t346 = {
        let t346 = t96 * z1_4_x;
        let t348 = t346 + t98 * t204;
        put(23, t348); // row 1, YY4
        t346
    };
    // ZZ4: column
    {
        let t349 = t344 - t346;
        put(24, t349); // row 1, ZZ4
    }
    // XY4: column
    {
        let t350 = t100 + t103;
        let t353 = t105 * t204 - t104 * z1_4_x;
        put(25, t353); // row 1, XY4
        put(77, t350); // row 2, XY4
        put(119, t350); // row 3, XY4
        put(151, t350); // row 4, XY4
    }
    // XZ4: column
    {
        let t356 = t102 * z1_4_x + t99 * t204;
        put(26, t356); // row 1, XZ4
    }
    // YZ4: column
    {
        let t360 = z1_4_x * (t0 - t103) - t101 * t204;
        put(27, t360); // row 1, YZ4
    }
    // M5: column
    let [t363, t366, t368] = {
        let t363 = c5 * t120 + s5 * a5_y;
        let t366 = s5 * t120 - c5 * a5_y;
        let t368 = D5 * t363;
        let t375 = z1_4_x * (D5 * t366) + (t198 * t366 + (t207 * t363 + t116 * t210));
        let t379 = t214 * t363 + t116 * v2_4_y - t368;
        let t383 = t218 * t363 - t116 * v3_5_z - t368;
        put(28, t375); // row 1, M5
        put(80, t379); // row 2, M5
        put(122, t383); // row 3, M5
        [t363, t366, t368]
    };
    // MSX5: column
    let [t385, t390, t391] = {
        let t385 = s5 * t142;
        let t386 = c5 * t140 + t385;
        let t389 = s5 * t140 - c5 * t142;
        let t390 = s5 * t116;
        let t391 = c5 * t116;
        let t395 = t391 - D5 * t386;
        let t398 = z1_4_x * (t390 - D5 * t389) - a5_y * t204;
        let t404 = t198 * t389 + (t207 * t386 + t144 * t210) - t398;
        let t408 = t395 + (t214 * t386 + t144 * v2_4_y);
        let t412 = t395 - (t144 * v3_5_z - t218 * t386);
        put(29, t404); // row 1, MSX5
        put(81, t408); // row 2, MSX5
        put(123, t412); // row 3, MSX5
        put(155, t395); // row 4, MSX5
        [t385, t390, t391]
    };
    // MSY5: column
    let [t413, t414, t417] = {
        let t413 = c5 * t141;
        let t414 = s5 * t143;
        let t415 = t413 + t414;
        let t417 = c5 * t143;
        let t418 = t417 - s5 * t141;
        let t422 = D5 * t415 - t390;
        let t430 = t207 * t415 + t145 * t210 - t198 * t418;
        let t431 = z1_4_x * (D5 * t418 - t391) + t120 * t204 - t430;
        let t435 = t422 - (t214 * t415 + t145 * v2_4_y);
        let t439 = t422 + (t145 * v3_5_z - t218 * t415);
        put(30, t431); // row 1, MSY5
        put(82, t435); // row 2, MSY5
        put(124, t439); // row 3, MSY5
        put(156, t422); // row 4, MSY5
        [t413, t414, t417]
    };
    // MSZ5: column
    {
        let t442 = c5 * t126 + s5 * t129;
        let t445 = c5 * t129 - s5 * t126;
        let t449 = D5 * t442 - t363;
        let t455 = z1_4_x * (t366 + D5 * t445) + (t198 * t445 + (t315 - t207 * t442));
        let t458 = t449 + (t321 - t214 * t442);
        let t461 = t449 - (t325 + t218 * t442);
        put(31, t455); // row 1, MSZ5
        put(83, t458); // row 2, MSZ5
        put(125, t461); // row 3, MSZ5
        put(157, t449); // row 4, MSZ5
    }
    // XX5: column
    let [t463, t464, t468] = {
        let t463 = t135 * t221;
        let t464 = t134 * t204;
        let t466 = dw5_x * z1_5_x - t463 - t464;
        let t468 = c5 * t135;
        let t469 = s5 * dw5_x + t468;
        put(32, t466); // row 1, XX5
        put(84, t469); // row 2, XX5
        put(126, t469); // row 3, XX5
        put(158, t469); // row 4, XX5
        [t463, t464, t468]
    };
    // YY5: column
    let [t470, t474] = {
        let t470 = t136 * z1_5_x;
        let t473 = t464 - (t470 + t138 * t221);
        let t474 = s5 * t136;
        let t476 = c5 * t138 - t474;
        put(33, t473); // row 1, YY5
        put(85, t476); // row 2, YY5
        put(127, t476); // row 3, YY5
        put(159, t476); // row 4, YY5
        [t470, t474]
    };
    // ZZ5: column
    {
        let t479 = dw5_z * t204 + (t463 + t470);
        let t480 = t474 - t468;
        put(34, t479); // row 1, ZZ5
        put(86, t480); // row 2, ZZ5
        put(128, t480); // row 3, ZZ5
        put(160, t480); // row 4, ZZ5
    }
    // XY5: column
    {
        let t481 = t143 - t140;
        let t486 = t204 * t481 + (t144 * z1_5_x - t145 * t221);
        let t489 = s5 * t144 + c5 * t145;
        put(35, t486); // row 1, XY5
        put(87, t489); // row 2, XY5
        put(129, t489); // row 3, XY5
        put(161, t489); // row 4, XY5
        put(183, t481); // row 5, XY5
    }
    // XZ5: column
    {
        let t494 = t129 * t204 + (t142 * z1_5_x - t139 * t221);
        let t496 = t385 + c5 * t139;
        put(36, t494); // row 1, XZ5
        put(88, t496); // row 2, XZ5
        put(130, t496); // row 3, XZ5
        put(162, t496); // row 4, XZ5
    }
    // YZ5: column
    {
        let t497 = t103 - t143;
        let t502 = t126 * t204 + (z1_5_x * t497 + t141 * t221);
        let t504 = s5 * t497 - t413;
        put(37, t502); // row 1, YZ5
        put(89, t504); // row 2, YZ5
        put(131, t504); // row 3, YZ5
        put(163, t504); // row 4, YZ5
    }
    // M6: column
    let [t507, t510] = {
        let t507 = c6 * t160 + s6 * a6_y;
        let t510 = s6 * t160 - c6 * a6_y;
        let t511 = D6 * t510;
        let t512 = D6 * t507;
        let t515 = c5 * t507 + s5 * t156;
        let t518 = c5 * t156 - s5 * t507;
        let t524 = s5 * t511 - D5 * t515;
        let t532 = t207 * t515 - t210 * t510 - t198 * t518;
        let t533 = z1_4_x * (c5 * t511 - D5 * t518) + t204 * t512 + t532;
        let t537 = t524 + (t214 * t515 - v2_4_y * t510);
        let t541 = t524 + (t218 * t515 + v3_5_z * t510);
        put(38, t533); // row 1, M6
        put(90, t537); // row 2, M6
        put(132, t541); // row 3, M6
        put(164, t524); // row 4, M6
        put(186, t512); // row 5, M6
        [t507, t510]
    };
    // MSX6: column
    let [t543, t546, t548, t549] = {
        let t543 = s6 * t182;
        let t544 = c6 * t180 + t543;
        let t546 = c6 * t182;
        let t547 = s6 * t180 - t546;
        let t548 = s6 * t156;
        let t549 = c6 * t156;
        let t552 = t548 + D6 * t547;
        let t553 = t549 + D6 * t544;
        let t556 = c5 * t544 + s5 * t184;
        let t559 = s5 * t544 - c5 * t184;
        let t569 = s5 * t552 + c5 * a6_y - D5 * t556;
        let t572 = t204 * t553 - z1_4_x * (s5 * a6_y - c5 * t552 - D5 * t559);
        let t578 = t572 + (t198 * t559 - (t210 * t547 - t207 * t556));
        let t582 = t569 - (v2_4_y * t547 - t214 * t556);
        let t586 = t569 + (t218 * t556 + v3_5_z * t547);
        put(39, t578); // row 1, MSX6
        put(91, t582); // row 2, MSX6
        put(133, t586); // row 3, MSX6
        put(165, t569); // row 4, MSX6
        put(187, t553); // row 5, MSX6
        [t543, t546, t548, t549]
    };
    // MSY6: column
    let [t587, t590] = {
        let t587 = c6 * t181;
        let t589 = t587 - s6 * t183;
        let t590 = s6 * t181;
        let t592 = t590 + c6 * t183;
        let t595 = t549 + D6 * t592;
        let t596 = D6 * t589 - t548;
        let t599 = c5 * t589 - s5 * t185;
        let t602 = s5 * t589 + c5 * t185;
        let t612 = s5 * t595 + c5 * t160 - D5 * t599;
        let t615 = z1_4_x * (D5 * t602 - (s5 * t160 - c5 * t595)) + t204 * t596;
        let t621 = t615 - (t210 * t592 - t207 * t599 - t198 * t602);
        let t625 = t612 - (v2_4_y * t592 - t214 * t599);
        let t629 = t612 + (t218 * t599 + v3_5_z * t592);
        put(40, t621); // row 1, MSY6
        put(92, t625); // row 2, MSY6
        put(134, t629); // row 3, MSY6
        put(166, t612); // row 4, MSY6
        put(188, t596); // row 5, MSY6
        [t587, t590]
    };
    // MSZ6: column
    {
        let t632 = c6 * t166 + s6 * t169;
        let t635 = s6 * t166 - c6 * t169;
        let t638 = t510 - D6 * t635;
        let t639 = t507 - D6 * t632;
        let t641 = t414 + c5 * t632;
        let t643 = s5 * t632 - t417;
        let t649 = s5 * t638 + D5 * t641;
        let t657 = t210 * t635 - t207 * t641 - t198 * t643;
        let t658 = z1_4_x * (c5 * t638 - D5 * t643) + t204 * t639 + t657;
        let t662 = t649 + (v2_4_y * t635 - t214 * t641);
        let t666 = t649 - (t218 * t641 + v3_5_z * t635);
        put(41, t658); // row 1, MSZ6
        put(93, t662); // row 2, MSZ6
        put(135, t666); // row 3, MSZ6
        put(167, t649); // row 4, MSZ6
        put(189, t639); // row 5, MSZ6
    }
    // XX6: column
    let [t668, t671, t674, t679] = {
        let t668 = s6 * t175;
        let t669 = c6 * t177 + t668;
        let t671 = c6 * t175;
        let t672 = s6 * t177 - t671;
        let t674 = t174 * t221;
        let t677 = t204 * t672 - (z1_5_x * t669 + t674);
        let t679 = c5 * t174;
        let t680 = t679 - s5 * t669;
        put(42, t677); // row 1, XX6
        put(94, t680); // row 2, XX6
        put(136, t680); // row 3, XX6
        put(168, t680); // row 4, XX6
        put(190, t672); // row 5, XX6
        [t668, t671, t674, t679]
    };
    // YY6: column
    let [t681, t684] = {
        let t681 = c6 * t176;
        let t683 = t681 + s6 * t178;
        let t684 = s6 * t176;
        let t686 = c6 * t178 - t684;
        let t690 = t204 * t686 + (t674 + z1_5_x * t683);
        let t692 = s5 * t683 - t679;
        put(43, t690); // row 1, YY6
        put(95, t692); // row 2, YY6
        put(137, t692); // row 3, YY6
        put(169, t692); // row 4, YY6
        put(191, t686); // row 5, YY6
        [t681, t684]
    };
    // ZZ6: column
    {
        let t693 = t668 - t681;
        let t694 = t671 + t684;
        let t699 = t204 * t694 - (dw6_z * t221 - z1_5_x * t693);
        let t702 = s5 * t693 + c5 * dw6_z;
        put(44, t699); // row 1, ZZ6
        put(96, t702); // row 2, ZZ6
        put(138, t702); // row 3, ZZ6
        put(170, t702); // row 4, ZZ6
        put(192, t694); // row 5, ZZ6
    }
    // XY6: column
    {
        let t703 = t183 - t180;
        let t706 = c6 * t184 - s6 * t185;
        let t709 = s6 * t184 + c6 * t185;
        let t714 = t204 * t709 - (z1_5_x * t706 + t221 * t703);
        let t717 = c5 * t703 - s5 * t706;
        put(45, t714); // row 1, XY6
        put(97, t717); // row 2, XY6
        put(139, t717); // row 3, XY6
        put(171, t717); // row 4, XY6
        put(193, t709); // row 5, XY6
        put(205, t703); // row 6, XY6
    }
    // XZ6: column
    {
        let t719 = t546 + s6 * t179;
        let t721 = c6 * t179 - t543;
        let t726 = t204 * t721 + (z1_5_x * t719 - t169 * t221);
        let t729 = s5 * t719 + c5 * t169;
        put(46, t726); // row 1, XZ6
        put(98, t729); // row 2, XZ6
        put(140, t729); // row 3, XZ6
        put(172, t729); // row 4, XZ6
        put(194, t721); // row 5, XZ6
    }
    // YZ6: column
    {
        let t730 = t183 - t143;
        let t732 = t590 + c6 * t730;
        let t734 = s6 * t730 - t587;
        let t739 = t204 * t734 - (z1_5_x * t732 + t166 * t221);
        let t742 = c5 * t166 - s5 * t732;
        let t743 = dq1.sign();
        let t744 = dq2.sign();
        let t745 = dq3.sign();
        let t746 = dq4.sign();
        let t747 = dq5.sign();
        let t748 = dq6.sign();
        let t749 = -a2_x;
        let t750 = -t9;
        let t751 = -t48;
        let t752 = -t94;
        let t753 = -t86;
        let t754 = -t368;
        let t755 = -t134;
        let t756 = -t174;
        put(47, t739); // row 1, YZ6
        put(50, t743); // row 1, FC1
        put(53, t749); // row 2, MSY2
        put(54, t750); // row 2, XX2
        put(65, t751); // row 2, YY3
        put(75, t752); // row 2, YY4
        put(79, t753); // row 2, YZ4
        put(99, t742); // row 2, YZ6
        put(102, t744); // row 2, FC2
        put(107, t751); // row 3, YY3
        put(117, t752); // row 3, YY4
        put(121, t753); // row 3, YZ4
        put(141, t742); // row 3, YZ6
        put(144, t745); // row 3, FC3
        put(149, t752); // row 4, YY4
        put(153, t753); // row 4, YZ4
        put(154, t754); // row 4, M5
        put(173, t742); // row 4, YZ6
        put(176, t746); // row 4, FC4
        put(180, t755); // row 5, XX5
        put(195, t734); // row 5, YZ6
        put(198, t747); // row 5, FC5
        put(203, t756); // row 6, YY6
        put(210, t748); // row 6, FC6
    }
}
