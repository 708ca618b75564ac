//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil and Dombre, 12.4.
//!
//! 413 multiplications, 323 additions; 6 x 84, 212 of 504 structurally nonzero.

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
    let flat = &mut out.as_flattened_mut()[..];
    flat[0..6].fill(S::default());
    flat[7..13].fill(S::default());
    flat[61..66].fill(S::default());
    flat[67..72].fill(S::default());
    flat[73..78].fill(S::default());
    flat[79..95].fill(S::default());
    flat[97] = S::default();
    flat[144] = S::default();
    flat[146..151].fill(S::default());
    flat[152..157].fill(S::default());
    flat[158..163].fill(S::default());
    flat[164..189].fill(S::default());
    flat[191] = S::default();
    flat[228..230].fill(S::default());
    flat[231..236].fill(S::default());
    flat[237..242].fill(S::default());
    flat[243..248].fill(S::default());
    flat[249..283].fill(S::default());
    flat[285] = S::default();
    flat[312..315].fill(S::default());
    flat[316..321].fill(S::default());
    flat[322..327].fill(S::default());
    flat[328..333].fill(S::default());
    flat[334..377].fill(S::default());
    flat[379] = S::default();
    flat[396..400].fill(S::default());
    flat[401..406].fill(S::default());
    flat[407..412].fill(S::default());
    flat[413..418].fill(S::default());
    flat[419..471].fill(S::default());
    flat[473] = S::default();
    flat[480..485].fill(S::default());
    flat[486..491].fill(S::default());
    flat[492..497].fill(S::default());
    flat[498..503].fill(S::default());
    nonzeros(trig, dq, ddq, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 84]; 6]) {
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
        a2_x, a2_y, t9, t10, t11, dw2_x, dw2_y, t14,
        t15, t16, t17, t18, t19, t20,
    ] = {
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t5 = s2 * ddq1;
        let t6 = c2 * ddq1;
        let t7 = w2_x * w2_x;
        let t8 = dq2 * dq2;
        let t9 = w2_x * w2_y;
        let t10 = dq2 * w2_x;
        let t11 = dq2 * w2_y;
        let dw2_x = t5 + t11;
        let dw2_y = t6 - t10;
        let t14 = t7 - t8;
        let t15 = t14 - t0;
        let t16 = ddq2 - t9;
        let t17 = ddq2 + t9;
        let t18 = t7 + t8;
        let t19 = dw2_y - t10;
        let t20 = t11 + dw2_x;
        put(52, a2_y); // row 2, MSX2
        put(55, t9); // row 2, YY2
        put(58, t5); // row 2, XZ2
        put(59, t6); // row 2, YZ2
        [
        a2_x, a2_y, t9, t10, t11, dw2_x, dw2_y, t14,
        t15, t16, t17, t18, t19, t20,
    ]
    };
    // link 3: motion
    let [
        z1_3_x, z1_3_y, w3_z, dw3_z, t31, t36, a3_y, t40,
        t41, t46, t47, t48, dw3_x, dw3_y, t51, t52,
        t53, t54, t55, t56, t57,
    ] = {
        let z1_3_x = s2 * c3 + c2 * s3;
        let z1_3_y = c2 * c3 - s2 * s3;
        let w3_z = dq2 + dq3;
        let dw3_z = ddq2 + ddq3;
        let t31 = t19 * k1;
        let t32 = t15 * k1 - a2_x;
        let t33 = a2_y - t17 * k1;
        let t36 = c3 * t32 - s3 * t33;
        let a3_y = c3 * t33 + s3 * t32;
        let t40 = ddq1 * z1_3_y;
        let t41 = ddq1 * z1_3_x;
        let w3_x = dq1 * z1_3_x;
        let w3_y = dq1 * z1_3_y;
        let t44 = w3_x * w3_x;
        let t45 = w3_z * w3_z;
        let t46 = w3_x * w3_y;
        let t47 = w3_z * w3_x;
        let t48 = w3_z * w3_y;
        let dw3_x = t41 + t48;
        let dw3_y = t40 - t47;
        let t51 = t45 - t44;
        let t52 = t0 + t51;
        let t53 = dw3_z - t46;
        let t54 = dw3_z + t46;
        let t55 = t44 + t45;
        let t56 = t47 - dw3_y;
        let t57 = t48 + dw3_x;
        put(65, t46); // row 2, YY3
        put(66, dw3_z); // row 2, ZZ3
        put(68, t41); // row 2, XZ3
        put(69, t40); // row 2, YZ3
        put(104, a3_y); // row 3, MSX3
        put(105, t36); // row 3, MSY3
        put(107, t46); // row 3, YY3
        put(108, dw3_z); // row 3, ZZ3
        put(110, t41); // row 3, XZ3
        put(111, t40); // row 3, YZ3
        [
        z1_3_x, z1_3_y, w3_z, dw3_z, t31, t36, a3_y, t40,
        t41, t46, t47, t48, dw3_x, dw3_y, t51, t52,
        t53, t54, t55, t56, t57,
    ]
    };
    // link 4: motion
    let [
        z1_4_x, t63, w4_z, t77, t80, a4_y, t84, t85,
        w4_x, t87, t90, t91, t92, dw4_x, t94, t95,
        t96, t97, t98, t99, t100, t101,
    ] = {
        let z1_4_x = c4 * z1_3_x + s4 * z1_3_y;
        let t63 = s4 * z1_3_x - c4 * z1_3_y;
        let w4_z = w3_z + dq4;
        let dw4_z = dw3_z + ddq4;
        let t75 = t36 - (t52 * k2 + D4 * t40);
        let t76 = a3_y - (t54 * k2 + D4 * t41);
        let t77 = t31 - (t56 * k2 + D4 * t0);
        let t80 = c4 * t75 - s4 * t76;
        let a4_y = c4 * t76 + s4 * t75;
        let t84 = ddq1 * t63;
        let t85 = ddq1 * z1_4_x;
        let w4_x = dq1 * z1_4_x;
        let t87 = dq1 * t63;
        let t88 = w4_x * w4_x;
        let t89 = w4_z * w4_z;
        let t90 = w4_x * t87;
        let t91 = w4_z * w4_x;
        let t92 = w4_z * t87;
        let dw4_x = t85 - t92;
        let t94 = t84 + t91;
        let t95 = t89 - t88;
        let t96 = t0 + t95;
        let t97 = dw4_z + t90;
        let t98 = dw4_z - t90;
        let t99 = t88 + t89;
        let t100 = t91 + t94;
        let t101 = t92 - dw4_x;
        put(74, t90); // row 2, XX4
        put(76, dw4_z); // row 2, ZZ4
        put(78, t85); // row 2, XZ4
        put(116, t90); // row 3, XX4
        put(118, dw4_z); // row 3, ZZ4
        put(120, t85); // row 3, XZ4
        put(146, a4_y); // row 4, MSX4
        put(147, t80); // row 4, MSY4
        put(148, t90); // row 4, XX4
        put(150, dw4_z); // row 4, ZZ4
        put(152, t85); // row 4, XZ4
        [
        z1_4_x, t63, w4_z, t77, t80, a4_y, t84, t85,
        w4_x, t87, t90, t91, t92, dw4_x, t94, t95,
        t96, t97, t98, t99, t100, t101,
    ]
    };
    // link 5: motion
    let [
        z1_5_x, t103, t108, t112, a5_y, w5_x, w5_y, t124,
        t127, w5_z, dw5_z, t132, t133, t134, dw5_x, t136,
        t137, t138, t139, t140, t141, t142, t143,
    ] = {
        let z1_5_x = c5 * z1_4_x;
        let t103 = s5 * z1_4_x;
        let t107 = t80 - D5 * t97;
        let t108 = a4_y + D5 * t99;
        let t109 = t77 + D5 * t101;
        let t112 = c5 * t107 - s5 * t109;
        let a5_y = c5 * t109 + s5 * t107;
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t124 = c5 * t97 + s5 * t101;
        let t127 = s5 * t97 - c5 * t101;
        let w5_z = t87 + dq5;
        let dw5_z = t94 + ddq5;
        let t130 = w5_x * w5_x;
        let t131 = w5_z * w5_z;
        let t132 = w5_x * w5_y;
        let t133 = w5_x * w5_z;
        let t134 = w5_y * w5_z;
        let dw5_x = t127 + t134;
        let t136 = t124 - t133;
        let t137 = t130 - t131;
        let t138 = t137 - t99;
        let t139 = t132 - dw5_z;
        let t140 = dw5_z + t132;
        let t141 = t130 + t131;
        let t142 = t136 - t133;
        let t143 = t134 + dw5_x;
        put(178, a5_y); // row 5, MSX5
        put(179, t112); // row 5, MSY5
        put(181, t132); // row 5, YY5
        put(182, dw5_z); // row 5, ZZ5
        put(184, t127); // row 5, XZ5
        put(185, t124); // row 5, YZ5
        [
        z1_5_x, t103, t108, t112, a5_y, w5_x, w5_y, t124,
        t127, w5_z, dw5_z, t132, t133, t134, dw5_x, t136,
        t137, t138, t139, t140, t141, t142, t143,
    ]
    };
    // link 6: motion
    let [
        t148, t152, a6_y, t164, t167, dw6_z, t172, t173,
        t174, t175, t176, t177, t178, t179, t180, t181,
        t182, t183,
    ] = {
        let t147 = t112 - D6 * t139;
        let t148 = a5_y - D6 * t141;
        let t149 = t108 - D6 * t143;
        let t152 = c6 * t147 - s6 * t149;
        let a6_y = c6 * t149 + s6 * t147;
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t161 = c6 * w5_z + s6 * w5_x;
        let t164 = c6 * t139 - s6 * t143;
        let t167 = c6 * t143 + s6 * t139;
        let w6_z = w5_y + dq6;
        let dw6_z = t136 + ddq6;
        let t170 = w6_x * w6_x;
        let t171 = w6_z * w6_z;
        let t172 = w6_x * t161;
        let t173 = w6_x * w6_z;
        let t174 = t161 * w6_z;
        let t175 = t174 - t167;
        let t176 = t173 - t164;
        let t177 = t170 - t171;
        let t178 = t177 - t141;
        let t179 = dw6_z + t172;
        let t180 = t172 - dw6_z;
        let t181 = t170 + t171;
        let t182 = t173 + t176;
        let t183 = t174 + t175;
        put(200, a6_y); // row 6, MSX6
        put(201, t152); // row 6, MSY6
        put(202, t172); // row 6, XX6
        put(204, dw6_z); // row 6, ZZ6
        put(206, t167); // row 6, XZ6
        put(207, t164); // row 6, YZ6
        [
        t148, t152, a6_y, t164, t167, dw6_z, t172, t173,
        t174, t175, t176, t177, t178, t179, t180, t181,
        t182, t183,
    ]
    };
    // joint axes in frame 3
    let [v1_3_z, t185, t186] = {
        let v1_3_z = c2 * k1;
        let t185 = s3 * k1;
        let t186 = c3 * k1;
        [v1_3_z, t185, t186]
    };
    // joint axes in frame 4
    let [v1_4_z, t193, v1_5_z, t200, v2_4_y, t204, v3_5_z] = {
        let t187 = D4 * z1_3_y;
        let t188 = D4 * z1_3_x;
        let v1_4_z = v1_3_z + z1_3_y * k2;
        let t193 = s4 * t188 - c4 * t187;
        let v1_5_z = c4 * t188 + s4 * t187;
        let t197 = t186 - A3;
        let t200 = c4 * t185 + s4 * t197;
        let v2_4_y = s4 * t185 - c4 * t197;
        let t204 = s4 * k2;
        let v3_5_z = c4 * k2;
        [v1_4_z, t193, v1_5_z, t200, v2_4_y, t204, v3_5_z]
    };
    // MSZ2: column
    {
        let t208 = c2 * a2_x - s2 * a2_y;
        put(1, t208); // row 1, MSZ2
    }
    // XX2: column
    let t210 = {
        let t210 = c2 * t10;
        let t211 = s2 * dw2_x + t210;
        put(2, t211); // row 1, XX2
        t210
    };
    // YY2: column
    let t212 = {
        let t212 = s2 * t11;
        let t214 = c2 * dw2_y - t212;
        put(3, t214); // row 1, YY2
        t212
    };
    // ZZ2: column
    {
        let t215 = t212 - t210;
        put(4, t215); // row 1, ZZ2
    }
    // XY2: column
    {
        let t216 = t15 + t18;
        let t219 = s2 * t19 + c2 * t20;
        put(5, t219); // row 1, XY2
        put(57, t216); // row 2, XY2
    }
    // XZ2: column
    {
        let t222 = s2 * t17 - c2 * t14;
        put(6, t222); // row 1, XZ2
    }
    // YZ2: column
    {
        let t226 = s2 * (t0 - t18) + c2 * t16;
        put(7, t226); // row 1, YZ2
    }
    // M3: column
    {
        let t227 = t31 * v1_3_z;
        let t230 = t36 * t185 - a3_y * t186;
        put(8, t227); // row 1, M3
        put(60, t230); // row 2, M3
    }
    // MSX3: column
    {
        let t233 = t56 * v1_3_z - z1_3_y * t31;
        let t237 = a3_y + (t52 * t185 - t54 * t186);
        put(9, t233); // row 1, MSX3
        put(61, t237); // row 2, MSX3
    }
    // MSY3: column
    {
        let t240 = z1_3_x * t31 + t57 * v1_3_z;
        let t244 = t36 + (t53 * t185 + t55 * t186);
        put(10, t240); // row 1, MSY3
        put(62, t244); // row 2, MSY3
    }
    // MSZ3: column
    let t249 = {
        let t249 = z1_3_x * a3_y + z1_3_y * t36 + t0 * v1_3_z;
        let t252 = t41 * t186 - t40 * t185;
        put(63, t252); // row 2, MSZ3
        t249
    };
    // XX3: column
    let t254 = {
        let t254 = z1_3_y * t47;
        let t255 = z1_3_x * dw3_x + t254;
        put(12, t255); // row 1, XX3
        t254
    };
    // YY3: column
    let t256 = {
        let t256 = z1_3_x * t48;
        let t258 = z1_3_y * dw3_y - t256;
        put(13, t258); // row 1, YY3
        t256
    };
    // ZZ3: column
    {
        let t259 = t256 - t254;
        put(14, t259); // row 1, ZZ3
    }
    // XY3: column
    {
        let t260 = t55 - t52;
        let t263 = z1_3_y * t57 - z1_3_x * t56;
        put(15, t263); // row 1, XY3
        put(67, t260); // row 2, XY3
        put(109, t260); // row 3, XY3
    }
    // XZ3: column
    {
        let t266 = z1_3_x * t54 + z1_3_y * t51;
        put(16, t266); // row 1, XZ3
    }
    // YZ3: column
    {
        let t270 = z1_3_x * (t0 - t55) + z1_3_y * t53;
        put(17, t270); // row 1, YZ3
    }
    // M4: column
    {
        let t275 = t77 * v1_4_z + (t80 * t193 - a4_y * v1_5_z);
        let t278 = t80 * t200 + a4_y * v2_4_y;
        let t281 = t80 * t204 - a4_y * v3_5_z;
        put(18, t275); // row 1, M4
        put(70, t278); // row 2, M4
        put(112, t281); // row 3, M4
    }
    // MSX4: column
    {
        let t288 = t63 * t77 + (t100 * v1_4_z - (t98 * v1_5_z - t96 * t193));
        let t292 = a4_y + (t96 * t200 + t98 * v2_4_y);
        let t296 = a4_y + (t96 * t204 - t98 * v3_5_z);
        put(19, t288); // row 1, MSX4
        put(71, t292); // row 2, MSX4
        put(113, t296); // row 3, MSX4
    }
    // MSY4: column
    let [t299, t305, t309] = {
        let t299 = t99 * v1_5_z;
        let t303 = z1_4_x * t77 + (t97 * t193 + t299 - t101 * v1_4_z);
        let t305 = t99 * v2_4_y;
        let t307 = t80 - (t305 - t97 * t200);
        let t309 = t99 * v3_5_z;
        let t311 = t80 + (t97 * t204 + t309);
        put(20, t303); // row 1, MSY4
        put(72, t307); // row 2, MSY4
        put(114, t311); // row 3, MSY4
        [t299, t305, t309]
    };
    // MSZ4: column
    {
        let t319 = t0 * v1_4_z - (t84 * t193 + t85 * v1_5_z);
        let t320 = t63 * t80 - z1_4_x * a4_y - t319;
        let t323 = t84 * t200 - t85 * v2_4_y;
        let t326 = t84 * t204 + t85 * v3_5_z;
        put(21, t320); // row 1, MSZ4
        put(73, t323); // row 2, MSZ4
        put(115, t326); // row 3, MSZ4
    }
    // XX4: column
    let t328 = {
        let t328 = t63 * t91;
        let t329 = z1_4_x * dw4_x - t328;
        put(22, t329); // row 1, XX4
        t328
    };
    // YY4: column
    let t330 = {
        let t330 = z1_4_x * t92;
        let t332 = t330 + t63 * t94;
        put(23, t332); // row 1, YY4
        t330
    };
    // ZZ4: column
    {
        let t333 = t328 - t330;
        put(24, t333); // row 1, ZZ4
    }
    // XY4: column
    {
        let t334 = t99 - t96;
        let t337 = t63 * t101 - z1_4_x * t100;
        put(25, t337); // row 1, XY4
        put(77, t334); // row 2, XY4
        put(119, t334); // row 3, XY4
        put(151, t334); // row 4, XY4
    }
    // XZ4: column
    {
        let t340 = z1_4_x * t98 - t63 * t95;
        put(26, t340); // row 1, XZ4
    }
    // YZ4: column
    {
        let t344 = z1_4_x * (t0 - t99) - t63 * t97;
        put(27, t344); // row 1, YZ4
    }
    // M5: column
    let [t347, t350, t352] = {
        let t347 = c5 * t112 + s5 * a5_y;
        let t350 = s5 * t112 - c5 * a5_y;
        let t352 = D5 * t347;
        let t359 = z1_4_x * (D5 * t350) - (v1_4_z * t350 + (t108 * v1_5_z - t193 * t347));
        let t363 = t200 * t347 + t108 * v2_4_y - t352;
        let t367 = t204 * t347 - t108 * v3_5_z - t352;
        put(28, t359); // row 1, M5
        put(80, t363); // row 2, M5
        put(122, t367); // row 3, M5
        [t347, t350, t352]
    };
    // MSX5: column
    let [t369, t374, t375] = {
        let t369 = s5 * t140;
        let t370 = t369 - c5 * t138;
        let t373 = s5 * t138 + c5 * t140;
        let t374 = s5 * t108;
        let t375 = c5 * t108;
        let t379 = t375 - D5 * t370;
        let t382 = z1_4_x * (t374 + D5 * t373) - t63 * a5_y;
        let t388 = v1_4_z * t373 + (t193 * t370 - t142 * v1_5_z) - t382;
        let t392 = t379 + (t200 * t370 + t142 * v2_4_y);
        let t396 = t379 + (t204 * t370 - t142 * v3_5_z);
        put(29, t388); // row 1, MSX5
        put(81, t392); // row 2, MSX5
        put(123, t396); // row 3, MSX5
        put(155, t379); // row 4, MSX5
        [t369, t374, t375]
    };
    // MSY5: column
    let [t397, t398, t401] = {
        let t397 = c5 * t139;
        let t398 = s5 * t141;
        let t399 = t397 + t398;
        let t401 = c5 * t141;
        let t402 = t401 - s5 * t139;
        let t406 = D5 * t399 - t374;
        let t414 = t143 * v1_5_z - t193 * t399 - v1_4_z * t402;
        let t415 = z1_4_x * (D5 * t402 - t375) + t63 * t112 + t414;
        let t419 = t406 - (t200 * t399 + t143 * v2_4_y);
        let t423 = t406 - (t204 * t399 - t143 * v3_5_z);
        put(30, t415); // row 1, MSY5
        put(82, t419); // row 2, MSY5
        put(124, t423); // row 3, MSY5
        put(156, t406); // row 4, MSY5
        [t397, t398, t401]
    };
    // MSZ5: column
    {
        let t426 = c5 * t124 + s5 * t127;
        let t429 = s5 * t124 - c5 * t127;
        let t433 = D5 * t426 - t347;
        let t439 = v1_4_z * t429 - (t299 + t193 * t426) - z1_4_x * (D5 * t429 - t350);
        let t442 = t433 - (t200 * t426 - t305);
        let t445 = t433 - (t309 + t204 * t426);
        put(31, t439); // row 1, MSZ5
        put(83, t442); // row 2, MSZ5
        put(125, t445); // row 3, MSZ5
        put(157, t433); // row 4, MSZ5
    }
    // XX5: column
    let [t447, t448, t452] = {
        let t447 = t103 * t133;
        let t448 = t63 * t132;
        let t450 = z1_5_x * dw5_x - t447 - t448;
        let t452 = c5 * t133;
        let t453 = s5 * dw5_x + t452;
        put(32, t450); // row 1, XX5
        put(84, t453); // row 2, XX5
        put(126, t453); // row 3, XX5
        put(158, t453); // row 4, XX5
        [t447, t448, t452]
    };
    // YY5: column
    let [t454, t458] = {
        let t454 = z1_5_x * t134;
        let t457 = t448 - (t454 + t103 * t136);
        let t458 = s5 * t134;
        let t460 = c5 * t136 - t458;
        put(33, t457); // row 1, YY5
        put(85, t460); // row 2, YY5
        put(127, t460); // row 3, YY5
        put(159, t460); // row 4, YY5
        [t454, t458]
    };
    // ZZ5: column
    {
        let t463 = t63 * dw5_z + (t447 + t454);
        let t464 = t458 - t452;
        put(34, t463); // row 1, ZZ5
        put(86, t464); // row 2, ZZ5
        put(128, t464); // row 3, ZZ5
        put(160, t464); // row 4, ZZ5
    }
    // XY5: column
    {
        let t465 = t138 + t141;
        let t470 = t63 * t465 - (t103 * t143 - z1_5_x * t142);
        let t473 = s5 * t142 + c5 * t143;
        put(35, t470); // row 1, XY5
        put(87, t473); // row 2, XY5
        put(129, t473); // row 3, XY5
        put(161, t473); // row 4, XY5
        put(183, t465); // row 5, XY5
    }
    // XZ5: column
    {
        let t478 = t63 * t127 + (z1_5_x * t140 + t103 * t137);
        let t480 = t369 - c5 * t137;
        put(36, t478); // row 1, XZ5
        put(88, t480); // row 2, XZ5
        put(130, t480); // row 3, XZ5
        put(162, t480); // row 4, XZ5
    }
    // YZ5: column
    {
        let t481 = t99 - t141;
        let t486 = t63 * t124 + (z1_5_x * t481 + t103 * t139);
        let t488 = s5 * t481 - t397;
        put(37, t486); // row 1, YZ5
        put(89, t488); // row 2, YZ5
        put(131, t488); // row 3, YZ5
        put(163, t488); // row 4, YZ5
    }
    // M6: column
    let [t491, t494] = {
        let t491 = c6 * t152 + s6 * a6_y;
        let t494 = s6 * t152 - c6 * a6_y;
        let t495 = D6 * t494;
        let t496 = D6 * t491;
        let t499 = c5 * t491 + s5 * t148;
        let t502 = s5 * t491 - c5 * t148;
        let t508 = s5 * t495 - D5 * t499;
        let t516 = t193 * t499 + v1_5_z * t494 - v1_4_z * t502;
        let t517 = z1_4_x * (c5 * t495 + D5 * t502) + t63 * t496 + t516;
        let t521 = t508 + (t200 * t499 - v2_4_y * t494);
        let t525 = t508 + (t204 * t499 + v3_5_z * t494);
        put(38, t517); // row 1, M6
        put(90, t521); // row 2, M6
        put(132, t525); // row 3, M6
        put(164, t508); // row 4, M6
        put(186, t496); // row 5, M6
        [t491, t494]
    };
    // MSX6: column
    let [t527, t530, t532, t533] = {
        let t527 = s6 * t180;
        let t528 = c6 * t178 + t527;
        let t530 = c6 * t180;
        let t531 = t530 - s6 * t178;
        let t532 = s6 * t148;
        let t533 = c6 * t148;
        let t536 = t532 + D6 * t531;
        let t537 = t533 - D6 * t528;
        let t540 = s5 * t182 - c5 * t528;
        let t543 = s5 * t528 + c5 * t182;
        let t553 = s5 * t536 + c5 * a6_y - D5 * t540;
        let t556 = t63 * t537 - z1_4_x * (D5 * t543 - (c5 * t536 - s5 * a6_y));
        let t562 = t556 + (v1_4_z * t543 + (t193 * t540 + v1_5_z * t531));
        let t566 = t553 - (v2_4_y * t531 - t200 * t540);
        let t570 = t553 + (t204 * t540 + v3_5_z * t531);
        put(39, t562); // row 1, MSX6
        put(91, t566); // row 2, MSX6
        put(133, t570); // row 3, MSX6
        put(165, t553); // row 4, MSX6
        put(187, t537); // row 5, MSX6
        [t527, t530, t532, t533]
    };
    // MSY6: column
    let [t571, t574] = {
        let t571 = c6 * t179;
        let t573 = t571 - s6 * t181;
        let t574 = s6 * t179;
        let t576 = t574 + c6 * t181;
        let t579 = t533 + D6 * t576;
        let t580 = D6 * t573 - t532;
        let t583 = c5 * t573 - s5 * t183;
        let t586 = s5 * t573 + c5 * t183;
        let t596 = s5 * t579 + c5 * t152 - D5 * t583;
        let t599 = z1_4_x * (D5 * t586 - (s5 * t152 - c5 * t579)) + t63 * t580;
        let t605 = t599 - (v1_4_z * t586 - (t193 * t583 + v1_5_z * t576));
        let t609 = t596 + (t200 * t583 - v2_4_y * t576);
        let t613 = t596 + (t204 * t583 + v3_5_z * t576);
        put(40, t605); // row 1, MSY6
        put(92, t609); // row 2, MSY6
        put(134, t613); // row 3, MSY6
        put(166, t596); // row 4, MSY6
        put(188, t580); // row 5, MSY6
        [t571, t574]
    };
    // MSZ6: column
    {
        let t616 = c6 * t164 + s6 * t167;
        let t619 = c6 * t167 - s6 * t164;
        let t622 = t494 + D6 * t619;
        let t623 = t491 - D6 * t616;
        let t625 = t398 + c5 * t616;
        let t627 = s5 * t616 - t401;
        let t633 = s5 * t622 + D5 * t625;
        let t641 = v1_4_z * t627 - (t193 * t625 - v1_5_z * t619);
        let t642 = z1_4_x * (c5 * t622 - D5 * t627) + t63 * t623 + t641;
        let t646 = t633 - (t200 * t625 + v2_4_y * t619);
        let t650 = t633 + (v3_5_z * t619 - t204 * t625);
        put(41, t642); // row 1, MSZ6
        put(93, t646); // row 2, MSZ6
        put(135, t650); // row 3, MSZ6
        put(167, t633); // row 4, MSZ6
        put(189, t623); // row 5, MSZ6
    }
    // XX6: column
    let [t652, t655, t658, t663] = {
        let t652 = s6 * t173;
        let t653 = c6 * t175 + t652;
        let t655 = c6 * t173;
        let t656 = s6 * t175 - t655;
        let t658 = t103 * t172;
        let t661 = t63 * t656 - (z1_5_x * t653 + t658);
        let t663 = c5 * t172;
        let t664 = t663 - s5 * t653;
        put(42, t661); // row 1, XX6
        put(94, t664); // row 2, XX6
        put(136, t664); // row 3, XX6
        put(168, t664); // row 4, XX6
        put(190, t656); // row 5, XX6
        [t652, t655, t658, t663]
    };
    // YY6: column
    let [t665, t668] = {
        let t665 = c6 * t174;
        let t667 = t665 + s6 * t176;
        let t668 = s6 * t174;
        let t670 = c6 * t176 - t668;
        let t674 = t63 * t670 + (t658 + z1_5_x * t667);
        let t676 = s5 * t667 - t663;
        put(43, t674); // row 1, YY6
        put(95, t676); // row 2, YY6
        put(137, t676); // row 3, YY6
        put(169, t676); // row 4, YY6
        put(191, t670); // row 5, YY6
        [t665, t668]
    };
    // ZZ6: column
    {
        let t677 = t652 - t665;
        let t678 = t655 + t668;
        let t683 = t63 * t678 + (z1_5_x * t677 - t103 * dw6_z);
        let t686 = s5 * t677 + c5 * dw6_z;
        put(44, t683); // row 1, ZZ6
        put(96, t686); // row 2, ZZ6
        put(138, t686); // row 3, ZZ6
        put(170, t686); // row 4, ZZ6
        put(192, t678); // row 5, ZZ6
    }
    // XY6: column
    {
        let t687 = t178 + t181;
        let t690 = s6 * t183 - c6 * t182;
        let t693 = s6 * t182 + c6 * t183;
        let t698 = t63 * t693 + (z1_5_x * t690 - t103 * t687);
        let t701 = s5 * t690 + c5 * t687;
        put(45, t698); // row 1, XY6
        put(97, t701); // row 2, XY6
        put(139, t701); // row 3, XY6
        put(171, t701); // row 4, XY6
        put(193, t693); // row 5, XY6
        put(205, t687); // row 6, XY6
    }
    // XZ6: column
    {
        let t703 = s6 * t177 - t530;
        let t705 = t527 + c6 * t177;
        let t710 = t63 * t705 + (z1_5_x * t703 - t103 * t167);
        let t713 = s5 * t703 + c5 * t167;
        put(46, t710); // row 1, XZ6
        put(98, t713); // row 2, XZ6
        put(140, t713); // row 3, XZ6
        put(172, t713); // row 4, XZ6
        put(194, t705); // row 5, XZ6
    }
    // YZ6: column
    {
        let t714 = t181 - t141;
        let t716 = t574 + c6 * t714;
        let t718 = s6 * t714 - t571;
        let t723 = t63 * t718 - (z1_5_x * t716 + t103 * t164);
        let t726 = c5 * t164 - s5 * t716;
        let t727 = dq1.sign();
        let t728 = dq2.sign();
        let t729 = dq3.sign();
        let t730 = dq4.sign();
        let t731 = dq5.sign();
        let t732 = dq6.sign();
        let t733 = -t249;
        let t734 = -a2_x;
        let t735 = -t9;
        let t736 = -t46;
        let t737 = -t90;
        let t738 = -t84;
        let t739 = -t352;
        let t740 = -t132;
        let t741 = -t172;
        put(11, t733); // row 1, MSZ3
        put(47, t723); // row 1, YZ6
        put(50, t727); // row 1, FC1
        put(53, t734); // row 2, MSY2
        put(54, t735); // row 2, XX2
        put(64, t736); // row 2, XX3
        put(75, t737); // row 2, YY4
        put(79, t738); // row 2, YZ4
        put(99, t726); // row 2, YZ6
        put(102, t728); // row 2, FC2
        put(106, t736); // row 3, XX3
        put(117, t737); // row 3, YY4
        put(121, t738); // row 3, YZ4
        put(141, t726); // row 3, YZ6
        put(144, t729); // row 3, FC3
        put(149, t737); // row 4, YY4
        put(153, t738); // row 4, YZ4
        put(154, t739); // row 4, M5
        put(173, t726); // row 4, YZ6
        put(176, t730); // row 4, FC4
        put(180, t740); // row 5, XX5
        put(195, t718); // row 5, YZ6
        put(198, t731); // row 5, FC5
        put(203, t741); // row 6, YY6
        put(210, t732); // row 6, FC6
    }
}
