//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil and Dombre, 12.4.
//!
//! 438 multiplications, 341 additions; 6 x 84, 212 of 504 structurally nonzero.

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
    // link 2: motion
    let [w2_x, w2_y, a2_x, a2_y, t6, t7, dw2_x, dw2_y] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t2 = s2 * ddq1;
        let t3 = c2 * ddq1;
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let t6 = dq2 * w2_y;
        let t7 = dq2 * w2_x;
        let dw2_x = t2 + t6;
        let dw2_y = t3 - t7;
        put(0, ddq1); // row 1, ZZ1
        put(48, ddq1); // row 1, IA1
        put(49, dq1); // row 1, FV1
        put(51, k7); // row 1, FO1
        put(52, a2_y); // row 2, MSX2
        put(56, ddq2); // row 2, ZZ2
        put(58, t2); // row 2, XZ2
        put(59, t3); // row 2, YZ2
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
        [w2_x, w2_y, a2_x, a2_y, t6, t7, dw2_x, dw2_y]
    };
    // link 3: motion
    let [
        w3_x, t15, t22, t23, t24, t25, t27, t28,
        t29, t30, t33, t38, t41, w3_z, dw3_x, t46,
        dw3_z,
    ] = {
        let w3_x = c3 * w2_x + s3 * w2_y;
        let t15 = s3 * w2_x - c3 * w2_y;
        let t22 = w2_x * w2_x;
        let t23 = w2_y * w2_y;
        let t24 = dq2 * dq2;
        let t25 = w2_x * w2_y;
        let t27 = t25 - ddq2;
        let t28 = ddq2 + t25;
        let t29 = dw2_y - t7;
        let t30 = t6 + dw2_x;
        let t33 = t29 * k1;
        let t34 = a2_x + (t23 + t24) * k1;
        let t35 = t28 * k1 - a2_y;
        let t38 = s3 * t35 - c3 * t34;
        let t41 = c3 * t35 + s3 * t34;
        let w3_z = dq2 + dq3;
        let dw3_x = c3 * dw2_x + s3 * dw2_y - dq3 * t15;
        let t46 = dq3 * w3_x - (c3 * dw2_y - s3 * dw2_x);
        let dw3_z = ddq2 + ddq3;
        put(55, t25); // row 2, YY2
        put(66, dw3_z); // row 2, ZZ3
        put(105, t38); // row 3, MSY3
        put(108, dw3_z); // row 3, ZZ3
        [
        w3_x, t15, t22, t23, t24, t25, t27, t28,
        t29, t30, t33, t38, t41, w3_z, dw3_x, t46,
        dw3_z,
    ]
    };
    // link 4: motion
    let [
        w4_x, t53, t60, t61, t62, t63, t64, t65,
        t66, t67, t68, t69, t70, t71, t72, t73,
        t74, t86, t89, a4_y, w4_z, t96, t97, dw4_z,
    ] = {
        let w4_x = c4 * w3_x - s4 * t15;
        let t53 = c4 * t15 + s4 * w3_x;
        let t60 = w3_x * w3_x;
        let t61 = t15 * t15;
        let t62 = w3_z * w3_z;
        let t63 = w3_x * t15;
        let t64 = w3_x * w3_z;
        let t65 = t15 * w3_z;
        let t66 = t61 + t62;
        let t67 = dw3_z + t63;
        let t68 = t64 - t46;
        let t69 = t63 - dw3_z;
        let t70 = t60 + t62;
        let t71 = dw3_x + t65;
        let t72 = t46 + t64;
        let t73 = t65 - dw3_x;
        let t74 = t60 + t61;
        let t84 = t38 - (t66 * k2 + D4 * t68);
        let t85 = t41 + (D4 * t71 - t69 * k2);
        let t86 = t33 - (t72 * k2 + D4 * t74);
        let t89 = c4 * t84 + s4 * t85;
        let a4_y = s4 * t84 - c4 * t85;
        let w4_z = w3_z + dq4;
        let t96 = dq4 * t53 - (c4 * dw3_x - s4 * t46);
        let t97 = c4 * t46 + s4 * dw3_x + dq4 * w4_x;
        let dw4_z = dw3_z + ddq4;
        put(64, t63); // row 2, XX3
        put(68, t71); // row 2, XZ3
        put(69, t68); // row 2, YZ3
        put(76, dw4_z); // row 2, ZZ4
        put(106, t63); // row 3, XX3
        put(110, t71); // row 3, XZ3
        put(111, t68); // row 3, YZ3
        put(118, dw4_z); // row 3, ZZ4
        put(146, a4_y); // row 4, MSX4
        put(147, t89); // row 4, MSY4
        put(150, dw4_z); // row 4, ZZ4
        [
        w4_x, t53, t60, t61, t62, t63, t64, t65,
        t66, t67, t68, t69, t70, t71, t72, t73,
        t74, t86, t89, a4_y, w4_z, t96, t97, dw4_z,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t111, t112, t113, t114, t115, t116,
        t117, t118, t119, t120, t121, t122, t123, t124,
        t125, t130, a5_x, a5_y, w5_z, dw5_x, dw5_y, dw5_z,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t111 = w4_x * w4_x;
        let t112 = t53 * t53;
        let t113 = w4_z * w4_z;
        let t114 = w4_x * t53;
        let t115 = w4_x * w4_z;
        let t116 = t53 * w4_z;
        let t117 = t112 + t113;
        let t118 = dw4_z + t114;
        let t119 = t115 - t97;
        let t120 = t114 - dw4_z;
        let t121 = t111 + t113;
        let t122 = t116 - t96;
        let t123 = t97 + t115;
        let t124 = t96 + t116;
        let t125 = t111 + t112;
        let t129 = D5 * t118 - t89;
        let t130 = a4_y + D5 * t121;
        let t131 = t86 + D5 * t124;
        let a5_x = c5 * t129 + s5 * t131;
        let a5_y = c5 * t131 - s5 * t129;
        let w5_z = t53 + dq5;
        let dw5_x = s5 * dw4_z - c5 * t96 + dq5 * w5_y;
        let dw5_y = c5 * dw4_z + s5 * t96 - dq5 * w5_x;
        let dw5_z = t97 + ddq5;
        put(74, t114); // row 2, XX4
        put(78, t122); // row 2, XZ4
        put(79, t119); // row 2, YZ4
        put(116, t114); // row 3, XX4
        put(120, t122); // row 3, XZ4
        put(121, t119); // row 3, YZ4
        put(148, t114); // row 4, XX4
        put(152, t122); // row 4, XZ4
        put(153, t119); // row 4, YZ4
        put(178, a5_y); // row 5, MSX5
        put(182, dw5_z); // row 5, ZZ5
        [
        w5_x, w5_y, t111, t112, t113, t114, t115, t116,
        t117, t118, t119, t120, t121, t122, t123, t124,
        t125, t130, a5_x, a5_y, w5_z, dw5_x, dw5_y, dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, t149, t156, t157, t158, t159, t160, t161,
        t162, t163, t164, t165, t166, t167, t168, t169,
        t170, t175, t179, a6_y, w6_z, t186, t187, dw6_z,
    ] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t149 = c6 * w5_z + s6 * w5_x;
        let t156 = w5_x * w5_x;
        let t157 = w5_y * w5_y;
        let t158 = w5_z * w5_z;
        let t159 = w5_x * w5_y;
        let t160 = w5_x * w5_z;
        let t161 = w5_y * w5_z;
        let t162 = t157 + t158;
        let t163 = dw5_z - t159;
        let t164 = dw5_y + t160;
        let t165 = dw5_z + t159;
        let t166 = t156 + t158;
        let t167 = dw5_x - t161;
        let t168 = t160 - dw5_y;
        let t169 = dw5_x + t161;
        let t170 = t156 + t157;
        let t174 = D6 * t163 - a5_x;
        let t175 = a5_y - D6 * t166;
        let t176 = t130 - D6 * t169;
        let t179 = c6 * t174 - s6 * t176;
        let a6_y = c6 * t176 + s6 * t174;
        let w6_z = w5_y + dq6;
        let t186 = s6 * dw5_z - c6 * dw5_x + dq6 * t149;
        let t187 = c6 * dw5_z + s6 * dw5_x + dq6 * w6_x;
        let dw6_z = dw5_y + ddq6;
        put(181, t159); // row 5, YY5
        put(184, t167); // row 5, XZ5
        put(185, t164); // row 5, YZ5
        put(200, a6_y); // row 6, MSX6
        put(201, t179); // row 6, MSY6
        put(204, dw6_z); // row 6, ZZ6
        [
        w6_x, t149, t156, t157, t158, t159, t160, t161,
        t162, t163, t164, t165, t166, t167, t168, t169,
        t170, t175, t179, a6_y, w6_z, t186, t187, dw6_z,
    ]
    };
    // joint axes in frame 3
    let [v1_3_z, z1_3_x, t195, t196, t197] = {
        let v1_3_z = c2 * k1;
        let z1_3_x = s2 * c3 + c2 * s3;
        let t195 = s2 * s3 - c2 * c3;
        let t196 = s3 * k1;
        let t197 = c3 * k1;
        [v1_3_z, z1_3_x, t195, t196, t197]
    };
    // joint axes in frame 4
    let [
        t201, t204, t207, t210, v1_5_z, t217, t220, t221,
        v3_5_z,
    ] = {
        let t198 = D4 * t195;
        let t199 = D4 * z1_3_x;
        let t201 = k2 * t195 - v1_3_z;
        let t204 = s4 * t195 - c4 * z1_3_x;
        let t207 = c4 * t195 + s4 * z1_3_x;
        let t210 = c4 * t198 + s4 * t199;
        let v1_5_z = c4 * t199 - s4 * t198;
        let t214 = t197 - A3;
        let t217 = c4 * t196 + s4 * t214;
        let t220 = c4 * t214 - s4 * t196;
        let t221 = s4 * k2;
        let v3_5_z = c4 * k2;
        [
        t201, t204, t207, t210, v1_5_z, t217, t220, t221,
        v3_5_z,
    ]
    };
    // joint axes in frame 5
    let [t223, t224] = {
        let t223 = c5 * t204;
        let t224 = s5 * t204;
        [t223, t224]
    };
    // MSZ2: column
    {
        let t227 = c2 * a2_x - s2 * a2_y;
        put(1, t227); // row 1, MSZ2
    }
    // XX2: column
    let t229 = {
        let t229 = c2 * t7;
        let t230 = s2 * dw2_x + t229;
        put(2, t230); // row 1, XX2
        t229
    };
    // YY2: column
    let t231 = {
        let t231 = s2 * t6;
        let t233 = c2 * dw2_y - t231;
        put(3, t233); // row 1, YY2
        t231
    };
    // ZZ2: column
    {
        let t234 = t231 - t229;
        put(4, t234); // row 1, ZZ2
    }
    // XY2: column
    {
        let t235 = t22 - t23;
        let t238 = s2 * t29 + c2 * t30;
        put(5, t238); // row 1, XY2
        put(57, t235); // row 2, XY2
    }
    // XZ2: column
    {
        let t242 = s2 * t28 - c2 * (t22 - t24);
        put(6, t242); // row 1, XZ2
    }
    // YZ2: column
    {
        let t246 = s2 * (t23 - t24) - c2 * t27;
        put(7, t246); // row 1, YZ2
    }
    // M3: column
    {
        let t247 = t33 * v1_3_z;
        let t250 = t38 * t196 + t41 * t197;
        put(8, t247); // row 1, M3
        put(60, t250); // row 2, M3
    }
    // MSX3: column
    {
        let t253 = t33 * t195 + t72 * v1_3_z;
        let t257 = t66 * t196 + t69 * t197 - t41;
        put(9, t253); // row 1, MSX3
        put(61, t257); // row 2, MSX3
    }
    // MSY3: column
    {
        let t260 = t33 * z1_3_x - t73 * v1_3_z;
        let t264 = t38 + (t67 * t196 + t70 * t197);
        put(10, t260); // row 1, MSY3
        put(62, t264); // row 2, MSY3
    }
    // MSZ3: column
    {
        let t269 = t41 * z1_3_x + t38 * t195 - t74 * v1_3_z;
        let t272 = t71 * t197 - t68 * t196;
        put(11, t269); // row 1, MSZ3
        put(63, t272); // row 2, MSZ3
    }
    // XX3: column
    let t274 = {
        let t274 = t64 * t195;
        let t275 = dw3_x * z1_3_x - t274;
        put(12, t275); // row 1, XX3
        t274
    };
    // YY3: column
    let t276 = {
        let t276 = t65 * z1_3_x;
        let t278 = t276 + t46 * t195;
        put(13, t278); // row 1, YY3
        t276
    };
    // ZZ3: column
    {
        let t279 = t274 - t276;
        put(14, t279); // row 1, ZZ3
    }
    // XY3: column
    {
        let t280 = t60 - t61;
        let t283 = t73 * t195 - t72 * z1_3_x;
        put(15, t283); // row 1, XY3
        put(67, t280); // row 2, XY3
        put(109, t280); // row 3, XY3
    }
    // XZ3: column
    {
        let t287 = t195 * (t60 - t62) - t69 * z1_3_x;
        put(16, t287); // row 1, XZ3
    }
    // YZ3: column
    {
        let t291 = z1_3_x * (t61 - t62) - t67 * t195;
        put(17, t291); // row 1, YZ3
    }
    // M4: column
    {
        let t296 = t89 * t210 - a4_y * v1_5_z - t86 * t201;
        let t299 = t89 * t217 - a4_y * t220;
        let t302 = t89 * t221 - a4_y * v3_5_z;
        put(18, t296); // row 1, M4
        put(70, t299); // row 2, M4
        put(112, t302); // row 3, M4
    }
    // MSX4: column
    {
        let t309 = t86 * t207 - (t123 * t201 - (t117 * t210 + t120 * v1_5_z));
        let t313 = a4_y + (t117 * t217 + t120 * t220);
        let t317 = a4_y + (t117 * t221 + t120 * v3_5_z);
        put(19, t309); // row 1, MSX4
        put(71, t313); // row 2, MSX4
        put(113, t317); // row 3, MSX4
    }
    // MSY4: column
    {
        let t324 = t124 * t201 + (t118 * t210 + t121 * v1_5_z) - t86 * t204;
        let t328 = t89 + (t118 * t217 + t121 * t220);
        let t332 = t89 + (t118 * t221 + t121 * v3_5_z);
        put(20, t324); // row 1, MSY4
        put(72, t328); // row 2, MSY4
        put(114, t332); // row 3, MSY4
    }
    // MSZ4: column
    {
        let t340 = t125 * t201 + (t122 * v1_5_z - t119 * t210);
        let t341 = a4_y * t204 + t89 * t207 + t340;
        let t344 = t122 * t220 - t119 * t217;
        let t347 = t122 * v3_5_z - t119 * t221;
        put(21, t341); // row 1, MSZ4
        put(73, t344); // row 2, MSZ4
        put(115, t347); // row 3, MSZ4
    }
    // XX4: column
    let t349 = {
        let t349 = t115 * t207;
        let t350 = t96 * t204 - t349;
        put(22, t350); // row 1, XX4
        t349
    };
    // YY4: column
    let t351 = {
        let t351 = t116 * t204;
        let t353 = t97 * t207 - t351;
        put(23, t353); // row 1, YY4
        t351
    };
    // ZZ4: column
    {
        let t354 = t349 + t351;
        put(24, t354); // row 1, ZZ4
    }
    // XY4: column
    {
        let t355 = t111 - t112;
        let t358 = t123 * t204 + t124 * t207;
        put(25, t358); // row 1, XY4
        put(77, t355); // row 2, XY4
        put(119, t355); // row 3, XY4
        put(151, t355); // row 4, XY4
    }
    // XZ4: column
    {
        let t362 = t120 * t204 + t207 * (t111 - t113);
        put(26, t362); // row 1, XZ4
    }
    // YZ4: column
    {
        let t366 = t204 * (t113 - t112) - t118 * t207;
        put(27, t366); // row 1, YZ4
    }
    // M5: column
    let [t369, t372] = {
        let t369 = c5 * a5_x - s5 * a5_y;
        let t372 = s5 * a5_x + c5 * a5_y;
        let t374 = D5 * t369;
        let t381 = t204 * (D5 * t372) - (t201 * t372 + (t210 * t369 + t130 * v1_5_z));
        let t385 = t374 - (t217 * t369 + t130 * t220);
        let t389 = t374 - (t221 * t369 + t130 * v3_5_z);
        put(28, t381); // row 1, M5
        put(80, t385); // row 2, M5
        put(122, t389); // row 3, M5
        put(154, t374); // row 4, M5
        [t369, t372]
    };
    // MSX5: column
    let [t391, t396, t397] = {
        let t391 = s5 * t165;
        let t392 = c5 * t162 + t391;
        let t395 = s5 * t162 - c5 * t165;
        let t396 = s5 * t130;
        let t397 = c5 * t130;
        let t401 = t397 - D5 * t392;
        let t409 = t201 * t395 + (t210 * t392 + t168 * v1_5_z);
        let t410 = a5_y * t207 - t204 * (D5 * t395 - t396) + t409;
        let t414 = t401 + (t217 * t392 + t168 * t220);
        let t418 = t401 + (t221 * t392 + t168 * v3_5_z);
        put(29, t410); // row 1, MSX5
        put(81, t414); // row 2, MSX5
        put(123, t418); // row 3, MSX5
        put(155, t401); // row 4, MSX5
        [t391, t396, t397]
    };
    // MSY5: column
    let t419 = {
        let t419 = c5 * t163;
        let t421 = s5 * t166 - t419;
        let t424 = s5 * t163 + c5 * t166;
        let t428 = D5 * t421 - t396;
        let t436 = t201 * t424 + (t169 * v1_5_z - t210 * t421);
        let t437 = t204 * (t397 - D5 * t424) - a5_x * t207 + t436;
        let t441 = t428 + (t169 * t220 - t217 * t421);
        let t445 = t428 + (t169 * v3_5_z - t221 * t421);
        put(30, t437); // row 1, MSY5
        put(82, t441); // row 2, MSY5
        put(124, t445); // row 3, MSY5
        put(156, t428); // row 4, MSY5
        t419
    };
    // MSZ5: column
    {
        let t448 = c5 * t164 + s5 * t167;
        let t451 = s5 * t164 - c5 * t167;
        let t455 = t369 + D5 * t448;
        let t461 = t201 * t451 + (t210 * t448 + t170 * v1_5_z);
        let t462 = t204 * (t372 + D5 * t451) - t461;
        let t466 = t455 - (t217 * t448 + t170 * t220);
        let t470 = t455 - (t221 * t448 + t170 * v3_5_z);
        put(31, t462); // row 1, MSZ5
        put(83, t466); // row 2, MSZ5
        put(125, t470); // row 3, MSZ5
        put(157, t455); // row 4, MSZ5
    }
    // XX5: column
    let [t472, t473, t477] = {
        let t472 = t160 * t224;
        let t473 = t159 * t207;
        let t475 = t472 - dw5_x * t223 - t473;
        let t477 = c5 * t160;
        let t478 = s5 * dw5_x + t477;
        put(32, t475); // row 1, XX5
        put(84, t478); // row 2, XX5
        put(126, t478); // row 3, XX5
        put(158, t478); // row 4, XX5
        [t472, t473, t477]
    };
    // YY5: column
    let [t479, t483] = {
        let t479 = t161 * t223;
        let t482 = t473 + (t479 + dw5_y * t224);
        let t483 = s5 * t161;
        let t485 = c5 * dw5_y - t483;
        put(33, t482); // row 1, YY5
        put(85, t485); // row 2, YY5
        put(127, t485); // row 3, YY5
        put(159, t485); // row 4, YY5
        [t479, t483]
    };
    // ZZ5: column
    {
        let t488 = dw5_z * t207 - (t472 + t479);
        let t489 = t483 - t477;
        put(34, t488); // row 1, ZZ5
        put(86, t489); // row 2, ZZ5
        put(128, t489); // row 3, ZZ5
        put(160, t489); // row 4, ZZ5
    }
    // XY5: column
    {
        let t490 = t156 - t157;
        let t495 = t207 * t490 + (t168 * t223 + t169 * t224);
        let t498 = c5 * t169 - s5 * t168;
        put(35, t495); // row 1, XY5
        put(87, t498); // row 2, XY5
        put(129, t498); // row 3, XY5
        put(161, t498); // row 4, XY5
        put(183, t490); // row 5, XY5
    }
    // XZ5: column
    {
        let t499 = t158 - t156;
        let t504 = t167 * t207 - (t165 * t223 - t224 * t499);
        let t506 = t391 + c5 * t499;
        put(36, t504); // row 1, XZ5
        put(88, t506); // row 2, XZ5
        put(130, t506); // row 3, XZ5
        put(162, t506); // row 4, XZ5
    }
    // YZ5: column
    {
        let t507 = t158 - t157;
        let t512 = t164 * t207 + (t223 * t507 + t163 * t224);
        let t514 = t419 - s5 * t507;
        put(37, t512); // row 1, YZ5
        put(89, t514); // row 2, YZ5
        put(131, t514); // row 3, YZ5
        put(163, t514); // row 4, YZ5
    }
    // M6: column
    let [
        t515, t516, t517, t518, t519, t520, t521, t522,
        t523, t524, t525, t526, t527, t528, t529, t532,
        t535,
    ] = {
        let t515 = w6_x * w6_x;
        let t516 = t149 * t149;
        let t517 = w6_z * w6_z;
        let t518 = w6_x * t149;
        let t519 = w6_x * w6_z;
        let t520 = t149 * w6_z;
        let t521 = t516 + t517;
        let t522 = dw6_z + t518;
        let t523 = t519 - t187;
        let t524 = dw6_z - t518;
        let t525 = t515 + t517;
        let t526 = t520 - t186;
        let t527 = t187 + t519;
        let t528 = t186 + t520;
        let t529 = t515 + t516;
        let t532 = c6 * t179 + s6 * a6_y;
        let t535 = s6 * t179 - c6 * a6_y;
        let t536 = D6 * t535;
        let t537 = D6 * t532;
        let t540 = c5 * t532 + s5 * t175;
        let t543 = s5 * t532 - c5 * t175;
        let t549 = s5 * t536 - D5 * t540;
        let t557 = t201 * t543 + (t210 * t540 + v1_5_z * t535);
        let t558 = t207 * t537 - t204 * (c5 * t536 + D5 * t543) + t557;
        let t562 = t549 + (t217 * t540 + t220 * t535);
        let t566 = t549 + (t221 * t540 + v3_5_z * t535);
        put(38, t558); // row 1, M6
        put(90, t562); // row 2, M6
        put(132, t566); // row 3, M6
        put(164, t549); // row 4, M6
        put(186, t537); // row 5, M6
        put(202, t518); // row 6, XX6
        put(206, t526); // row 6, XZ6
        put(207, t523); // row 6, YZ6
        [
        t515, t516, t517, t518, t519, t520, t521, t522,
        t523, t524, t525, t526, t527, t528, t529, t532,
        t535,
    ]
    };
    // MSX6: column
    let [t568, t571, t573, t574] = {
        let t568 = s6 * t524;
        let t569 = c6 * t521 + t568;
        let t571 = c6 * t524;
        let t572 = s6 * t521 - t571;
        let t573 = s6 * t175;
        let t574 = c6 * t175;
        let t577 = t573 + D6 * t572;
        let t578 = t574 + D6 * t569;
        let t581 = c5 * t569 + s5 * t527;
        let t584 = s5 * t569 - c5 * t527;
        let t594 = s5 * t577 + c5 * a6_y - D5 * t581;
        let t597 = t207 * t578 - t204 * (c5 * t577 - s5 * a6_y + D5 * t584);
        let t603 = t597 + (t201 * t584 + (t210 * t581 + v1_5_z * t572));
        let t607 = t594 + (t217 * t581 + t220 * t572);
        let t611 = t594 + (t221 * t581 + v3_5_z * t572);
        put(39, t603); // row 1, MSX6
        put(91, t607); // row 2, MSX6
        put(133, t611); // row 3, MSX6
        put(165, t594); // row 4, MSX6
        put(187, t578); // row 5, MSX6
        [t568, t571, t573, t574]
    };
    // MSY6: column
    let [t612, t615] = {
        let t612 = c6 * t522;
        let t614 = t612 - s6 * t525;
        let t615 = s6 * t522;
        let t617 = t615 + c6 * t525;
        let t620 = t574 + D6 * t617;
        let t621 = D6 * t614 - t573;
        let t624 = s5 * t528 - c5 * t614;
        let t627 = s5 * t614 + c5 * t528;
        let t637 = s5 * t620 + c5 * t179 + D5 * t624;
        let t640 = t204 * (s5 * t179 - c5 * t620 - D5 * t627) + t207 * t621;
        let t646 = t640 + (t201 * t627 - (t210 * t624 - v1_5_z * t617));
        let t650 = t637 + (t220 * t617 - t217 * t624);
        let t654 = t637 + (v3_5_z * t617 - t221 * t624);
        put(40, t646); // row 1, MSY6
        put(92, t650); // row 2, MSY6
        put(134, t654); // row 3, MSY6
        put(166, t637); // row 4, MSY6
        put(188, t621); // row 5, MSY6
        [t612, t615]
    };
    // MSZ6: column
    {
        let t657 = c6 * t523 + s6 * t526;
        let t660 = c6 * t526 - s6 * t523;
        let t663 = t535 + D6 * t660;
        let t664 = t532 - D6 * t657;
        let t667 = c5 * t657 + s5 * t529;
        let t670 = s5 * t657 - c5 * t529;
        let t676 = s5 * t663 + D5 * t667;
        let t684 = v1_5_z * t660 - t210 * t667 - t201 * t670;
        let t685 = t204 * (D5 * t670 - c5 * t663) + t207 * t664 + t684;
        let t689 = t676 + (t220 * t660 - t217 * t667);
        let t693 = t676 - (t221 * t667 - v3_5_z * t660);
        put(41, t685); // row 1, MSZ6
        put(93, t689); // row 2, MSZ6
        put(135, t693); // row 3, MSZ6
        put(167, t676); // row 4, MSZ6
        put(189, t664); // row 5, MSZ6
    }
    // XX6: column
    let [t695, t698, t701, t706] = {
        let t695 = s6 * t519;
        let t696 = c6 * t186 + t695;
        let t698 = c6 * t519;
        let t699 = s6 * t186 - t698;
        let t701 = t224 * t518;
        let t704 = t207 * t699 + (t223 * t696 + t701);
        let t706 = c5 * t518;
        let t707 = t706 - s5 * t696;
        put(42, t704); // row 1, XX6
        put(94, t707); // row 2, XX6
        put(136, t707); // row 3, XX6
        put(168, t707); // row 4, XX6
        put(190, t699); // row 5, XX6
        [t695, t698, t701, t706]
    };
    // YY6: column
    let [t708, t711] = {
        let t708 = c6 * t520;
        let t710 = t708 + s6 * t187;
        let t711 = s6 * t520;
        let t713 = c6 * t187 - t711;
        let t717 = t207 * t713 - (t701 + t223 * t710);
        let t719 = s5 * t710 - t706;
        put(43, t717); // row 1, YY6
        put(95, t719); // row 2, YY6
        put(137, t719); // row 3, YY6
        put(169, t719); // row 4, YY6
        put(191, t713); // row 5, YY6
        [t708, t711]
    };
    // ZZ6: column
    {
        let t720 = t695 - t708;
        let t721 = t698 + t711;
        let t726 = t207 * t721 - (t223 * t720 - dw6_z * t224);
        let t729 = s5 * t720 + c5 * dw6_z;
        put(44, t726); // row 1, ZZ6
        put(96, t729); // row 2, ZZ6
        put(138, t729); // row 3, ZZ6
        put(170, t729); // row 4, ZZ6
        put(192, t721); // row 5, ZZ6
    }
    // XY6: column
    {
        let t730 = t515 - t516;
        let t733 = s6 * t528 - c6 * t527;
        let t736 = s6 * t527 + c6 * t528;
        let t741 = t207 * t736 - (t223 * t733 - t224 * t730);
        let t744 = s5 * t733 + c5 * t730;
        put(45, t741); // row 1, XY6
        put(97, t744); // row 2, XY6
        put(139, t744); // row 3, XY6
        put(171, t744); // row 4, XY6
        put(193, t736); // row 5, XY6
        put(205, t730); // row 6, XY6
    }
    // XZ6: column
    {
        let t745 = t515 - t517;
        let t747 = t571 + s6 * t745;
        let t749 = c6 * t745 - t568;
        let t754 = t207 * t749 - (t223 * t747 - t224 * t526);
        let t757 = s5 * t747 + c5 * t526;
        put(46, t754); // row 1, XZ6
        put(98, t757); // row 2, XZ6
        put(140, t757); // row 3, XZ6
        put(172, t757); // row 4, XZ6
        put(194, t749); // row 5, XZ6
    }
    // YZ6: column
    {
        let t758 = t517 - t516;
        let t760 = t615 + c6 * t758;
        let t762 = s6 * t758 - t612;
        let t767 = t207 * t762 + (t223 * t760 + t224 * t523);
        let t770 = c5 * t523 - s5 * t760;
        let t771 = dq1.sign();
        let t772 = dq2.sign();
        let t773 = dq3.sign();
        let t774 = dq4.sign();
        let t775 = dq5.sign();
        let t776 = dq6.sign();
        let t777 = -a2_x;
        let t778 = -t25;
        let t779 = -t63;
        let t780 = -t114;
        let t781 = -t41;
        let t782 = -a5_x;
        let t783 = -t159;
        let t784 = -t518;
        put(47, t767); // row 1, YZ6
        put(50, t771); // row 1, FC1
        put(53, t777); // row 2, MSY2
        put(54, t778); // row 2, XX2
        put(65, t779); // row 2, YY3
        put(75, t780); // row 2, YY4
        put(99, t770); // row 2, YZ6
        put(102, t772); // row 2, FC2
        put(104, t781); // row 3, MSX3
        put(107, t779); // row 3, YY3
        put(117, t780); // row 3, YY4
        put(141, t770); // row 3, YZ6
        put(144, t773); // row 3, FC3
        put(149, t780); // row 4, YY4
        put(173, t770); // row 4, YZ6
        put(176, t774); // row 4, FC4
        put(179, t782); // row 5, MSY5
        put(180, t783); // row 5, XX5
        put(195, t762); // row 5, YZ6
        put(198, t775); // row 5, FC5
        put(203, t784); // row 6, YY6
        put(210, t776); // row 6, FC6
    }
}
