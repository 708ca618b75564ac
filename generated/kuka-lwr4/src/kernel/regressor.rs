//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil and Dombre, 12.4.
//!
//! 789 multiplications, 557 additions; 7 x 84, 266 of 588 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 266;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 6), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18), (0, 19), (0, 20), (0, 21),
    (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28), (0, 29), (0, 30), (0, 31),
    (0, 32), (0, 33), (0, 34), (0, 35), (0, 36), (0, 37), (0, 38), (0, 39), (0, 40), (0, 41),
    (0, 42), (0, 43), (0, 44), (0, 45), (0, 46), (0, 47), (0, 48), (0, 49), (0, 50), (0, 51),
    (0, 52), (0, 53), (0, 54), (0, 55), (0, 56), (0, 57), (0, 58), (0, 59), (0, 60), (0, 61),
    (0, 62), (0, 63), (0, 64), (0, 65), (0, 66), (0, 67), (0, 68), (0, 69), (0, 70), (0, 77),
    (1, 11), (1, 12), (1, 14), (1, 15), (1, 16), (1, 17), (1, 18), (1, 19), (1, 20), (1, 21),
    (1, 22), (1, 23), (1, 24), (1, 25), (1, 26), (1, 27), (1, 28), (1, 29), (1, 30), (1, 31),
    (1, 32), (1, 33), (1, 34), (1, 35), (1, 36), (1, 37), (1, 38), (1, 39), (1, 40), (1, 41),
    (1, 42), (1, 43), (1, 44), (1, 45), (1, 46), (1, 47), (1, 48), (1, 49), (1, 50), (1, 51),
    (1, 52), (1, 53), (1, 54), (1, 55), (1, 56), (1, 57), (1, 58), (1, 59), (1, 60), (1, 61),
    (1, 62), (1, 63), (1, 64), (1, 65), (1, 66), (1, 67), (1, 68), (1, 69), (1, 71), (1, 78),
    (2, 21), (2, 22), (2, 24), (2, 25), (2, 26), (2, 27), (2, 28), (2, 29), (2, 31), (2, 32),
    (2, 33), (2, 34), (2, 35), (2, 36), (2, 37), (2, 38), (2, 39), (2, 40), (2, 41), (2, 42),
    (2, 43), (2, 44), (2, 45), (2, 46), (2, 47), (2, 48), (2, 49), (2, 50), (2, 51), (2, 52),
    (2, 53), (2, 54), (2, 55), (2, 56), (2, 57), (2, 58), (2, 59), (2, 60), (2, 61), (2, 62),
    (2, 63), (2, 64), (2, 65), (2, 66), (2, 67), (2, 68), (2, 69), (2, 72), (2, 79), (3, 31),
    (3, 32), (3, 34), (3, 35), (3, 36), (3, 37), (3, 38), (3, 39), (3, 40), (3, 41), (3, 42),
    (3, 43), (3, 44), (3, 45), (3, 46), (3, 47), (3, 48), (3, 49), (3, 50), (3, 51), (3, 52),
    (3, 53), (3, 54), (3, 55), (3, 56), (3, 57), (3, 58), (3, 59), (3, 60), (3, 61), (3, 62),
    (3, 63), (3, 64), (3, 65), (3, 66), (3, 67), (3, 68), (3, 69), (3, 73), (3, 80), (4, 41),
    (4, 42), (4, 44), (4, 45), (4, 46), (4, 47), (4, 48), (4, 49), (4, 51), (4, 52), (4, 53),
    (4, 54), (4, 55), (4, 56), (4, 57), (4, 58), (4, 59), (4, 61), (4, 62), (4, 63), (4, 64),
    (4, 65), (4, 66), (4, 67), (4, 68), (4, 69), (4, 74), (4, 81), (5, 51), (5, 52), (5, 54),
    (5, 55), (5, 56), (5, 57), (5, 58), (5, 59), (5, 61), (5, 62), (5, 63), (5, 64), (5, 65),
    (5, 66), (5, 67), (5, 68), (5, 69), (5, 75), (5, 82), (6, 61), (6, 62), (6, 64), (6, 65),
    (6, 66), (6, 67), (6, 68), (6, 69), (6, 76), (6, 83),
];

/// Regressor `W` of the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 84]; 7]) {
    let flat = &mut out.as_flattened_mut()[..];
    flat[0..6].fill(S::default());
    flat[7..13].fill(S::default());
    flat[71..77].fill(S::default());
    flat[78..95].fill(S::default());
    flat[97] = S::default();
    flat[154] = S::default();
    flat[156..162].fill(S::default());
    flat[163..189].fill(S::default());
    flat[191] = S::default();
    flat[198] = S::default();
    flat[238..240].fill(S::default());
    flat[241..247].fill(S::default());
    flat[248..283].fill(S::default());
    flat[285] = S::default();
    flat[322..325].fill(S::default());
    flat[326..332].fill(S::default());
    flat[333..377].fill(S::default());
    flat[379] = S::default();
    flat[386] = S::default();
    flat[396] = S::default();
    flat[406..410].fill(S::default());
    flat[411..417].fill(S::default());
    flat[418..471].fill(S::default());
    flat[473] = S::default();
    flat[480] = S::default();
    flat[490..495].fill(S::default());
    flat[496..502].fill(S::default());
    flat[503..565].fill(S::default());
    flat[567] = S::default();
    flat[574..580].fill(S::default());
    flat[581..587].fill(S::default());
    nonzeros(trig, dq, ddq, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 84]; 7]) {
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
    let L2 = S::constant(0.4);
    let L3 = S::constant(0.39);
    let k0 = S::constant(9.81);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        put(0, ddq1); // row 1, ZZ1
        put(58, dq1); // row 1, FV1
        put(64, ddq2); // row 2, ZZ2
        put(118, dq2); // row 2, FV2
        put(167, dq3); // row 3, FV3
        put(207, dq4); // row 4, FV4
        put(235, dq5); // row 5, FV5
        put(254, dq6); // row 6, FV6
        put(264, dq7); // row 7, FV7
        t0
    };
    // link 2: motion
    let [
        a2_x, a2_y, w2_x, w2_y, t9, t10, t11, dw2_x,
        dw2_y, t14, t15, t16, t17, t18, t19, t20,
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
        let t14 = t8 - t7;
        let t15 = t0 + t14;
        let t16 = ddq2 - t9;
        let t17 = ddq2 + t9;
        let t18 = t7 + t8;
        let t19 = dw2_y - t10;
        let t20 = t11 + dw2_x;
        put(60, a2_y); // row 2, MSX2
        put(63, t9); // row 2, YY2
        put(66, t5); // row 2, XZ2
        put(67, t6); // row 2, YZ2
        [
        a2_x, a2_y, w2_x, w2_y, t9, t10, t11, dw2_x,
        dw2_y, t14, t15, t16, t17, t18, t19, t20,
    ]
    };
    // link 3: motion
    let [
        z1_3_x, t22, a3_z, t30, a3_y, w3_x, t39, t42,
        t45, w3_z, dw3_z, t50, t51, t52, t53, t54,
        t55, t56, t57, t58, t59, t60, t61,
    ] = {
        let z1_3_x = s2 * c3;
        let t22 = s2 * s3;
        let t25 = L2 * t20;
        let t26 = L2 * t16 - a2_x;
        let a3_z = a2_y - L2 * t18;
        let t30 = c3 * t26 + s3 * t25;
        let a3_y = s3 * t26 - c3 * t25;
        let w3_x = c3 * w2_x - s3 * dq2;
        let t39 = c3 * dq2 + s3 * w2_x;
        let t42 = c3 * t16 + s3 * t20;
        let t45 = c3 * t20 - s3 * t16;
        let w3_z = w2_y + dq3;
        let dw3_z = dw2_y + ddq3;
        let t48 = w3_x * w3_x;
        let t49 = w3_z * w3_z;
        let t50 = w3_x * t39;
        let t51 = w3_x * w3_z;
        let t52 = t39 * w3_z;
        let t53 = t52 - t45;
        let t54 = t42 + t51;
        let t55 = t48 - t49;
        let t56 = t55 - t18;
        let t57 = dw3_z + t50;
        let t58 = dw3_z - t50;
        let t59 = t48 + t49;
        let t60 = t51 + t54;
        let t61 = t52 + t53;
        put(120, a3_y); // row 3, MSX3
        put(121, t30); // row 3, MSY3
        put(122, t50); // row 3, XX3
        put(124, dw3_z); // row 3, ZZ3
        put(126, t45); // row 3, XZ3
        [
        z1_3_x, t22, a3_z, t30, a3_y, w3_x, t39, t42,
        t45, w3_z, dw3_z, t50, t51, t52, t53, t54,
        t55, t56, t57, t58, t59, t60, t61,
    ]
    };
    // link 4: motion
    let [
        t64, a4_y, w4_x, t73, t76, t79, w4_z, dw4_z,
        t84, t85, t86, t87, t88, t89, t90, t91,
        t92, t93, t94, t95,
    ] = {
        let t64 = c4 * t30 + s4 * a3_z;
        let a4_y = s4 * t30 - c4 * a3_z;
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t73 = c4 * w3_z + s4 * w3_x;
        let t76 = s4 * t61 - c4 * t57;
        let t79 = c4 * t61 + s4 * t57;
        let w4_z = dq4 - t39;
        let dw4_z = ddq4 - t54;
        let t82 = w4_x * w4_x;
        let t83 = w4_z * w4_z;
        let t84 = w4_x * t73;
        let t85 = w4_x * w4_z;
        let t86 = t73 * w4_z;
        let t87 = t79 + t86;
        let t88 = t85 - t76;
        let t89 = t83 - t82;
        let t90 = t59 + t89;
        let t91 = dw4_z + t84;
        let t92 = t84 - dw4_z;
        let t93 = t82 + t83;
        let t94 = t85 + t88;
        let t95 = t86 + t87;
        put(169, a4_y); // row 4, MSX4
        put(170, t64); // row 4, MSY4
        put(171, t84); // row 4, XX4
        put(173, dw4_z); // row 4, ZZ4
        put(176, t76); // row 4, YZ4
        [
        t64, a4_y, w4_x, t73, t76, t79, w4_z, dw4_z,
        t84, t85, t86, t87, t88, t89, t90, t91,
        t92, t93, t94, t95,
    ]
    };
    // link 5: motion
    let [
        t100, t104, a5_y, w5_x, t113, t116, t119, w5_z,
        dw5_z, t124, t125, t126, t127, dw5_y, t129, t130,
        t131, t132, t133, t134, t135,
    ] = {
        let t99 = t64 - L3 * t91;
        let t100 = a4_y + L3 * t93;
        let t101 = a3_y + L3 * t95;
        let t104 = c5 * t99 - s5 * t101;
        let a5_y = c5 * t101 + s5 * t99;
        let w5_x = c5 * w4_x + s5 * w4_z;
        let t113 = s5 * w4_x - c5 * w4_z;
        let t116 = c5 * t91 + s5 * t95;
        let t119 = s5 * t91 - c5 * t95;
        let w5_z = t73 + dq5;
        let dw5_z = t88 + ddq5;
        let t122 = w5_x * w5_x;
        let t123 = w5_z * w5_z;
        let t124 = w5_x * t113;
        let t125 = w5_x * w5_z;
        let t126 = t113 * w5_z;
        let t127 = t126 - t119;
        let dw5_y = t116 - t125;
        let t129 = t123 - t122;
        let t130 = t93 + t129;
        let t131 = dw5_z + t124;
        let t132 = t124 - dw5_z;
        let t133 = t122 + t123;
        let t134 = t125 - dw5_y;
        let t135 = t126 + t127;
        put(209, a5_y); // row 5, MSX5
        put(210, t104); // row 5, MSY5
        put(211, t124); // row 5, XX5
        put(213, dw5_z); // row 5, ZZ5
        put(215, t119); // row 5, XZ5
        put(216, t116); // row 5, YZ5
        [
        t100, t104, a5_y, w5_x, t113, t116, t119, w5_z,
        dw5_z, t124, t125, t126, t127, dw5_y, t129, t130,
        t131, t132, t133, t134, t135,
    ]
    };
    // link 6: motion
    let [
        t138, t141, w6_x, w6_y, t150, t153, w6_z, dw6_z,
        t158, t159, t160, dw6_x, t162, t163, t164, t165,
        t166, t167, t168, t169,
    ] = {
        let t138 = c6 * t104 + s6 * t100;
        let t141 = c6 * t100 - s6 * t104;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t150 = c6 * t131 + s6 * t135;
        let t153 = s6 * t131 - c6 * t135;
        let w6_z = t113 + dq6;
        let dw6_z = ddq6 - dw5_y;
        let t156 = w6_x * w6_x;
        let t157 = w6_z * w6_z;
        let t158 = w6_x * w6_y;
        let t159 = w6_x * w6_z;
        let t160 = w6_y * w6_z;
        let dw6_x = t153 + t160;
        let t162 = t150 - t159;
        let t163 = t156 - t157;
        let t164 = t163 - t133;
        let t165 = t158 - dw6_z;
        let t166 = dw6_z + t158;
        let t167 = t156 + t157;
        let t168 = t162 - t159;
        let t169 = t160 + dw6_x;
        put(238, t138); // row 6, MSY6
        put(240, t158); // row 6, YY6
        put(241, dw6_z); // row 6, ZZ6
        put(243, t153); // row 6, XZ6
        put(244, t150); // row 6, YZ6
        [
        t138, t141, w6_x, w6_y, t150, t153, w6_z, dw6_z,
        t158, t159, t160, dw6_x, t162, t163, t164, t165,
        t166, t167, t168, t169,
    ]
    };
    // link 7: motion
    let [
        t172, a7_y, t184, t187, dw7_z, t192, t193, t194,
        t195, t196, t197, t198, t199, t200, t201, t202,
        t203,
    ] = {
        let t172 = c7 * t138 - s7 * a5_y;
        let a7_y = c7 * a5_y + s7 * t138;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t181 = c7 * w6_z + s7 * w6_x;
        let t184 = c7 * t165 - s7 * t169;
        let t187 = c7 * t169 + s7 * t165;
        let w7_z = w6_y + dq7;
        let dw7_z = t162 + ddq7;
        let t190 = w7_x * w7_x;
        let t191 = w7_z * w7_z;
        let t192 = w7_x * t181;
        let t193 = w7_x * w7_z;
        let t194 = t181 * w7_z;
        let t195 = t194 - t187;
        let t196 = t193 - t184;
        let t197 = t190 - t191;
        let t198 = t197 - t167;
        let t199 = dw7_z + t192;
        let t200 = t192 - dw7_z;
        let t201 = t190 + t191;
        let t202 = t193 + t196;
        let t203 = t194 + t195;
        put(256, a7_y); // row 7, MSX7
        put(257, t172); // row 7, MSY7
        put(258, t192); // row 7, XX7
        put(260, dw7_z); // row 7, ZZ7
        put(262, t187); // row 7, XZ7
        put(263, t184); // row 7, YZ7
        [
        t172, a7_y, t184, t187, dw7_z, t192, t193, t194,
        t195, t196, t197, t198, t199, t200, t201, t202,
        t203,
    ]
    };
    // joint axes in frame 4
    let [t206, z1_5_z, t210, z2_4_y] = {
        let t206 = c2 * s4 - c4 * z1_3_x;
        let z1_5_z = c2 * c4 + s4 * z1_3_x;
        let t210 = s3 * c4;
        let z2_4_y = s3 * s4;
        [t206, z1_5_z, t210, z2_4_y]
    };
    // joint axes in frame 5
    let [t214, t217, t220, t223, t224, z3_5_y] = {
        let t214 = c5 * t206 + s5 * t22;
        let t217 = s5 * t206 - c5 * t22;
        let t220 = c5 * t210 + c3 * s5;
        let t223 = c3 * c5 - s5 * t210;
        let t224 = s4 * c5;
        let z3_5_y = s4 * s5;
        [t214, t217, t220, t223, t224, z3_5_y]
    };
    // MSZ2: column
    {
        let t228 = c2 * a2_x - s2 * a2_y;
        put(1, t228); // row 1, MSZ2
    }
    // XX2: column
    let t230 = {
        let t230 = c2 * t10;
        let t231 = s2 * dw2_x + t230;
        put(2, t231); // row 1, XX2
        t230
    };
    // YY2: column
    let t232 = {
        let t232 = s2 * t11;
        let t234 = c2 * dw2_y - t232;
        put(3, t234); // row 1, YY2
        t232
    };
    // ZZ2: column
    {
        let t235 = t232 - t230;
        put(4, t235); // row 1, ZZ2
    }
    // XY2: column
    {
        let t236 = t18 - t15;
        let t239 = s2 * t19 + c2 * t20;
        put(5, t239); // row 1, XY2
        put(65, t236); // row 2, XY2
    }
    // XZ2: column
    {
        let t242 = s2 * t17 + c2 * t14;
        put(6, t242); // row 1, XZ2
    }
    // YZ2: column
    {
        let t246 = c2 * t16 - s2 * (t18 - t0);
        put(7, t246); // row 1, YZ2
    }
    // M3: column
    let [t249, t252] = {
        let t247 = L2 * a3_y;
        let t248 = L2 * t30;
        let t249 = z1_3_x * t247;
        let t251 = t22 * t248 - t249;
        let t252 = s3 * t247;
        let t254 = t252 + c3 * t248;
        put(8, t251); // row 1, M3
        put(68, t254); // row 2, M3
        [t249, t252]
    };
    // MSX3: column
    {
        let t255 = L2 * t58;
        let t257 = a3_z - L2 * t56;
        let t262 = c2 * a3_y - (z1_3_x * t255 - t22 * t257);
        let t265 = s3 * t255 + c3 * t257;
        put(9, t262); // row 1, MSX3
        put(69, t265); // row 2, MSX3
    }
    // MSY3: column
    let t266 = {
        let t266 = L2 * t59;
        let t267 = L2 * t57;
        let t268 = a3_z + t266;
        let t273 = c2 * t30 + (z1_3_x * t268 + t22 * t267);
        let t276 = c3 * t267 - s3 * t268;
        put(10, t273); // row 1, MSY3
        put(70, t276); // row 2, MSY3
        t266
    };
    // MSZ3: column
    {
        let t279 = L2 * t45 - a3_y;
        let t280 = t30 + L2 * t42;
        let t283 = z1_3_x * t279 + t22 * t280;
        let t286 = c3 * t280 - s3 * t279;
        put(11, t283); // row 1, MSZ3
        put(71, t286); // row 2, MSZ3
    }
    // XX3: column
    let [t288, t289, t293] = {
        let t288 = t22 * t51;
        let t289 = c2 * t50;
        let t291 = t289 - (z1_3_x * t53 + t288);
        let t293 = c3 * t51;
        let t294 = s3 * t53 - t293;
        put(12, t291); // row 1, XX3
        put(72, t294); // row 2, XX3
        [t288, t289, t293]
    };
    // YY3: column
    let [t295, t299] = {
        let t295 = z1_3_x * t52;
        let t298 = t295 + t22 * t54 - t289;
        let t299 = s3 * t52;
        let t301 = c3 * t54 - t299;
        put(13, t298); // row 1, YY3
        put(73, t301); // row 2, YY3
        [t295, t299]
    };
    // ZZ3: column
    {
        let t304 = c2 * dw3_z + (t288 - t295);
        let t305 = t293 + t299;
        put(14, t304); // row 1, ZZ3
        put(74, t305); // row 2, ZZ3
    }
    // XY3: column
    {
        let t306 = t56 + t59;
        let t311 = c2 * t306 + (t22 * t61 - z1_3_x * t60);
        let t314 = s3 * t60 + c3 * t61;
        put(15, t311); // row 1, XY3
        put(75, t314); // row 2, XY3
        put(125, t306); // row 3, XY3
    }
    // XZ3: column
    {
        let t319 = c2 * t45 + (z1_3_x * t58 + t22 * t55);
        let t322 = c3 * t55 - s3 * t58;
        put(16, t319); // row 1, XZ3
        put(76, t322); // row 2, XZ3
    }
    // YZ3: column
    let t328 = {
        let t323 = t59 - t18;
        let t328 = c2 * t42 + (z1_3_x * t323 + t22 * t57);
        let t331 = s3 * t323 - c3 * t57;
        put(77, t331); // row 2, YZ3
        t328
    };
    // M4: column
    let [t334, t337] = {
        let t334 = c4 * t64 + s4 * a4_y;
        let t337 = c4 * a4_y - s4 * t64;
        let t338 = L2 * t334;
        let t340 = t22 * t338 - t249;
        let t342 = t252 + c3 * t338;
        put(18, t340); // row 1, M4
        put(78, t342); // row 2, M4
        put(130, t334); // row 3, MSZ4
        [t334, t337]
    };
    // MSX4: column
    let [t344, t346, t347] = {
        let t344 = s4 * t92;
        let t346 = s4 * a3_y;
        let t347 = c4 * a3_y;
        let t350 = L2 * t94 - t346;
        let t351 = L2 * (c4 * t90 - t344) - a4_y;
        let t356 = c2 * t347 + (t22 * t351 - z1_3_x * t350);
        let t359 = s3 * t350 + c3 * t351;
        put(19, t356); // row 1, MSX4
        put(79, t359); // row 2, MSX4
        put(128, t347); // row 3, MSX4
        [t344, t346, t347]
    };
    // MSY4: column
    let [t360, t361] = {
        let t360 = c4 * t91;
        let t361 = s4 * t93;
        let t365 = t347 + L2 * t95;
        let t366 = L2 * (t360 - t361) - t64;
        let t371 = z1_3_x * t365 + t22 * t366 - c2 * t346;
        let t374 = c3 * t366 - s3 * t365;
        put(20, t371); // row 1, MSY4
        put(80, t374); // row 2, MSY4
        [t360, t361]
    };
    // MSZ4: column
    {
        let t378 = L2 * (s4 * t79 - c4 * t76);
        let t379 = t337 - t266;
        let t384 = c2 * t334 + (t22 * t378 - z1_3_x * t379);
        let t387 = s3 * t379 + c3 * t378;
        put(21, t384); // row 1, MSZ4
        put(81, t387); // row 2, MSZ4
    }
    // XX4: column
    let [t389, t390, t394, t395, t399] = {
        let t389 = t85 * z1_5_z;
        let t390 = t22 * t84;
        let t392 = t87 * t206 - t389 - t390;
        let t394 = t85 * z2_4_y;
        let t395 = c3 * t84;
        let t397 = t87 * t210 + t394 - t395;
        let t399 = c4 * t85;
        let t400 = s4 * t87 - t399;
        put(22, t392); // row 1, XX4
        put(82, t397); // row 2, XX4
        put(131, t400); // row 3, XX4
        [t389, t390, t394, t395, t399]
    };
    // YY4: column
    let [t401, t405, t409] = {
        let t401 = t86 * t206;
        let t404 = t390 + (t88 * z1_5_z - t401);
        let t405 = t86 * t210;
        let t408 = t395 - (t405 + t88 * z2_4_y);
        let t409 = s4 * t86;
        let t411 = c4 * t88 - t409;
        put(23, t404); // row 1, YY4
        put(83, t408); // row 2, YY4
        put(132, t411); // row 3, YY4
        [t401, t405, t409]
    };
    // ZZ4: column
    {
        let t414 = t389 + t401 - t22 * dw4_z;
        let t417 = t405 - t394 - c3 * dw4_z;
        let t418 = t399 + t409;
        put(24, t414); // row 1, ZZ4
        put(84, t417); // row 2, ZZ4
        put(133, t418); // row 3, ZZ4
    }
    // XY4: column
    {
        let t419 = t93 - t90;
        let t424 = t94 * t206 + t95 * z1_5_z - t22 * t419;
        let t429 = t94 * t210 - t95 * z2_4_y - c3 * t419;
        let t432 = s4 * t94 + c4 * t95;
        put(25, t424); // row 1, XY4
        put(85, t429); // row 2, XY4
        put(134, t432); // row 3, XY4
        put(174, t419); // row 4, XY4
    }
    // XZ4: column
    {
        let t437 = t22 * t79 + (t92 * t206 - t89 * z1_5_z);
        let t442 = c3 * t79 + (t92 * t210 + t89 * z2_4_y);
        let t444 = t344 - c4 * t89;
        put(26, t437); // row 1, XZ4
        put(86, t442); // row 2, XZ4
        put(135, t444); // row 3, XZ4
    }
    // YZ4: column
    {
        let t445 = t93 - t59;
        let t450 = t206 * t445 - t91 * z1_5_z - t22 * t76;
        let t455 = t210 * t445 + t91 * z2_4_y - c3 * t76;
        let t457 = s4 * t445 - t360;
        put(27, t450); // row 1, YZ4
        put(87, t455); // row 2, YZ4
        put(136, t457); // row 3, YZ4
    }
    // M5: column
    let [t459, t460, t462, t463, t465] = {
        let t459 = s5 * a5_y;
        let t460 = c5 * t104 + t459;
        let t462 = c5 * a5_y;
        let t463 = t462 - s5 * t104;
        let t464 = L3 * t463;
        let t465 = L3 * t460;
        let t470 = s4 * t464;
        let t473 = c4 * t464 + L2 * t463;
        let t474 = t465 + L2 * (c4 * t460 + s4 * t100);
        let t479 = c2 * t470 + (t22 * t474 - z1_3_x * t473);
        let t482 = s3 * t473 + c3 * t474;
        put(28, t479); // row 1, M5
        put(88, t482); // row 2, M5
        put(137, t470); // row 3, M5
        [t459, t460, t462, t463, t465]
    };
    // MSX5: column
    let [t484, t489, t490] = {
        let t484 = s5 * t132;
        let t485 = t484 - c5 * t130;
        let t488 = s5 * t130 + c5 * t132;
        let t489 = s5 * t100;
        let t490 = c5 * t100;
        let t493 = t489 - L3 * t488;
        let t494 = t490 + L3 * t485;
        let t503 = s4 * t493 + c4 * a5_y;
        let t506 = c4 * t493 - s4 * a5_y - L2 * t488;
        let t507 = t494 + L2 * (c4 * t485 + s4 * t134);
        let t512 = c2 * t503 - (z1_3_x * t506 + t22 * t507);
        let t515 = s3 * t506 - c3 * t507;
        put(29, t512); // row 1, MSX5
        put(89, t515); // row 2, MSX5
        put(138, t503); // row 3, MSX5
        put(178, t494); // row 4, MSX5
        [t484, t489, t490]
    };
    // MSY5: column
    let [t516, t517, t520] = {
        let t516 = c5 * t131;
        let t517 = s5 * t133;
        let t518 = t517 - t516;
        let t520 = c5 * t133;
        let t521 = s5 * t131 + t520;
        let t524 = t490 - L3 * t521;
        let t525 = L3 * t518 - t489;
        let t534 = s4 * t524 + c4 * t104;
        let t537 = c4 * t524 - s4 * t104 - L2 * t521;
        let t538 = L2 * (s4 * t135 - c4 * t518) - t525;
        let t543 = c2 * t534 + (t22 * t538 - z1_3_x * t537);
        let t546 = s3 * t537 + c3 * t538;
        put(30, t543); // row 1, MSY5
        put(90, t546); // row 2, MSY5
        put(139, t534); // row 3, MSY5
        put(179, t525); // row 4, MSY5
        [t516, t517, t520]
    };
    // MSZ5: column
    {
        let t549 = c5 * t116 + s5 * t119;
        let t552 = s5 * t116 - c5 * t119;
        let t555 = t463 + L3 * t552;
        let t556 = L3 * t549 - t460;
        let t560 = s4 * t555;
        let t563 = c4 * t555 + L2 * t552;
        let t564 = t556 - L2 * (t361 - c4 * t549);
        let t569 = c2 * t560 - (z1_3_x * t563 + t22 * t564);
        let t572 = s3 * t563 - c3 * t564;
        put(31, t569); // row 1, MSZ5
        put(91, t572); // row 2, MSZ5
        put(140, t560); // row 3, MSZ5
        put(180, t556); // row 4, MSZ5
    }
    // XX5: column
    let [t574, t575, t579, t580, t584, t585, t589] = {
        let t574 = t125 * t217;
        let t575 = t124 * z1_5_z;
        let t577 = t575 + (t127 * t214 + t574);
        let t579 = t125 * t223;
        let t580 = t124 * z2_4_y;
        let t582 = t127 * t220 - t579 - t580;
        let t584 = t125 * z3_5_y;
        let t585 = c4 * t124;
        let t587 = t585 + (t127 * t224 + t584);
        let t589 = c5 * t125;
        let t590 = t589 - s5 * t127;
        put(32, t577); // row 1, XX5
        put(92, t582); // row 2, XX5
        put(141, t587); // row 3, XX5
        put(181, t590); // row 4, XX5
        [t574, t575, t579, t580, t584, t585, t589]
    };
    // YY5: column
    let [t591, t595, t599, t603] = {
        let t591 = t126 * t214;
        let t594 = dw5_y * t217 - t591 - t575;
        let t595 = t126 * t220;
        let t598 = t580 - (t595 + dw5_y * t223);
        let t599 = t126 * t224;
        let t602 = dw5_y * z3_5_y - t599 - t585;
        let t603 = s5 * t126;
        let t605 = t603 + c5 * dw5_y;
        put(33, t594); // row 1, YY5
        put(93, t598); // row 2, YY5
        put(142, t602); // row 3, YY5
        put(182, t605); // row 4, YY5
        [t591, t595, t599, t603]
    };
    // ZZ5: column
    let t615 = {
        let t608 = dw5_z * z1_5_z + (t591 - t574);
        let t611 = t579 + t595 - dw5_z * z2_4_y;
        let t614 = c4 * dw5_z + (t599 - t584);
        let t615 = t589 + t603;
        put(34, t608); // row 1, ZZ5
        put(94, t611); // row 2, ZZ5
        put(143, t614); // row 3, ZZ5
        t615
    };
    // XY5: column
    let t634 = {
        let t616 = t133 - t130;
        let t621 = z1_5_z * t616 + (t134 * t214 - t135 * t217);
        let t626 = t134 * t220 + t135 * t223 - z2_4_y * t616;
        let t631 = c4 * t616 - (t135 * z3_5_y - t134 * t224);
        let t634 = s5 * t134 + c5 * t135;
        put(35, t621); // row 1, XY5
        put(95, t626); // row 2, XY5
        put(144, t631); // row 3, XY5
        put(214, t616); // row 5, XY5
        t634
    };
    // XZ5: column
    {
        let t639 = t119 * z1_5_z + (t132 * t214 + t129 * t217);
        let t644 = t132 * t220 - t129 * t223 - t119 * z2_4_y;
        let t649 = c4 * t119 + (t132 * t224 + t129 * z3_5_y);
        let t651 = c5 * t129 - t484;
        put(36, t639); // row 1, XZ5
        put(96, t644); // row 2, XZ5
        put(145, t649); // row 3, XZ5
        put(185, t651); // row 4, XZ5
    }
    // YZ5: column
    {
        let t652 = t133 - t93;
        let t657 = t116 * z1_5_z + (t214 * t652 + t131 * t217);
        let t662 = t220 * t652 - t131 * t223 - t116 * z2_4_y;
        let t667 = c4 * t116 + (t224 * t652 + t131 * z3_5_y);
        let t669 = t516 - s5 * t652;
        put(37, t657); // row 1, YZ5
        put(97, t662); // row 2, YZ5
        put(146, t667); // row 3, YZ5
        put(186, t669); // row 4, YZ5
    }
    // M6: column
    let [t671, t672, t674, t675] = {
        let t671 = s6 * t141;
        let t672 = t671 - c6 * t138;
        let t674 = c6 * t141;
        let t675 = s6 * t138 + t674;
        let t677 = c5 * t672 - t459;
        let t679 = t462 + s5 * t672;
        let t680 = L3 * t679;
        let t681 = L3 * t677;
        let t686 = s4 * t680;
        let t689 = c4 * t680 + L2 * t679;
        let t690 = L2 * (s4 * t675 - c4 * t677) - t681;
        let t695 = c2 * t686 - (z1_3_x * t689 - t22 * t690);
        let t698 = s3 * t689 + c3 * t690;
        put(38, t695); // row 1, M6
        put(98, t698); // row 2, M6
        put(147, t686); // row 3, M6
        put(187, t681); // row 4, M6
        put(219, t672); // row 5, MSZ6
        [t671, t672, t674, t675]
    };
    // MSX6: column
    let [t700, t703, t705, t706] = {
        let t700 = s6 * t166;
        let t701 = c6 * t164 - t700;
        let t703 = c6 * t166;
        let t705 = s6 * a5_y;
        let t706 = c6 * a5_y;
        let t709 = c5 * t701 - s5 * t168;
        let t712 = s5 * t701 + c5 * t168;
        let t721 = c5 * t705 + s5 * t141 + L3 * t712;
        let t722 = c5 * t141 - s5 * t705 + L3 * t709;
        let t731 = s4 * t721 + c4 * t706;
        let t734 = c4 * t721 - s4 * t706 + L2 * t712;
        let t735 = t722 + L2 * (c4 * t709 + s4 * (s6 * t164 + t703));
        let t740 = c2 * t731 - (z1_3_x * t734 + t22 * t735);
        let t743 = s3 * t734 - c3 * t735;
        put(39, t740); // row 1, MSX6
        put(99, t743); // row 2, MSX6
        put(148, t731); // row 3, MSX6
        put(188, t722); // row 4, MSX6
        put(217, t706); // row 5, MSX6
        [t700, t703, t705, t706]
    };
    // MSY6: column
    let [t744, t745, t747, t748] = {
        let t744 = c6 * t165;
        let t745 = s6 * t167;
        let t746 = t744 + t745;
        let t747 = s6 * t165;
        let t748 = c6 * t167;
        let t752 = c5 * t746 + s5 * t169;
        let t755 = s5 * t746 - c5 * t169;
        let t764 = c5 * t706 - s5 * t138 + L3 * t755;
        let t765 = L3 * t752 - (s5 * t706 + c5 * t138);
        let t774 = s4 * t764 - c4 * t705;
        let t777 = c4 * t764 + s4 * t705 + L2 * t755;
        let t778 = L2 * (s4 * (t748 - t747) - c4 * t752) - t765;
        let t783 = c2 * t774 + (t22 * t778 - z1_3_x * t777);
        let t786 = s3 * t777 + c3 * t778;
        put(40, t783); // row 1, MSY6
        put(100, t786); // row 2, MSY6
        put(149, t774); // row 3, MSY6
        put(189, t765); // row 4, MSY6
        [t744, t745, t747, t748]
    };
    // MSZ6: column
    {
        let t789 = c6 * t150 + s6 * t153;
        let t794 = c5 * t789 - t517;
        let t796 = t520 + s5 * t789;
        let t801 = L3 * t796 - c5 * t675;
        let t802 = s5 * t675 + L3 * t794;
        let t811 = s4 * t801 + c4 * t672;
        let t814 = c4 * t801 - s4 * t672 + L2 * t796;
        let t815 = t802 + L2 * (c4 * t794 + s4 * (s6 * t150 - c6 * t153));
        let t820 = c2 * t811 - (z1_3_x * t814 + t22 * t815);
        let t823 = s3 * t814 - c3 * t815;
        put(41, t820); // row 1, MSZ6
        put(101, t823); // row 2, MSZ6
        put(150, t811); // row 3, MSZ6
        put(190, t802); // row 4, MSZ6
    }
    // XX6: column
    let [t825, t828, t831, t836, t841, t846] = {
        let t825 = s6 * t159;
        let t826 = t825 - c6 * dw6_x;
        let t828 = c6 * t159;
        let t829 = s6 * dw6_x + t828;
        let t831 = t158 * t217;
        let t834 = z1_5_z * t829 + (t214 * t826 + t831);
        let t836 = t158 * t223;
        let t839 = t220 * t826 - t836 - z2_4_y * t829;
        let t841 = t158 * z3_5_y;
        let t844 = c4 * t829 + (t224 * t826 + t841);
        let t846 = c5 * t158;
        let t847 = t846 - s5 * t826;
        put(42, t834); // row 1, XX6
        put(102, t839); // row 2, XX6
        put(151, t844); // row 3, XX6
        put(191, t847); // row 4, XX6
        put(220, t829); // row 5, XX6
        [t825, t828, t831, t836, t841, t846]
    };
    // YY6: column
    let [t848, t851, t867] = {
        let t848 = c6 * t160;
        let t850 = t848 + s6 * t162;
        let t851 = s6 * t160;
        let t853 = c6 * t162 - t851;
        let t857 = z1_5_z * t853 - (t831 - t214 * t850);
        let t861 = t836 + t220 * t850 - z2_4_y * t853;
        let t865 = c4 * t853 + (t224 * t850 - t841);
        let t867 = t846 + s5 * t850;
        put(43, t857); // row 1, YY6
        put(103, t861); // row 2, YY6
        put(152, t865); // row 3, YY6
        put(221, t853); // row 5, YY6
        [t848, t851, t867]
    };
    // ZZ6: column
    {
        let t868 = t825 + t848;
        let t869 = t851 - t828;
        let t874 = z1_5_z * t869 - (t214 * t868 + dw6_z * t217);
        let t879 = dw6_z * t223 - t220 * t868 - z2_4_y * t869;
        let t884 = c4 * t869 - (t224 * t868 + dw6_z * z3_5_y);
        let t887 = s5 * t868 - c5 * dw6_z;
        put(44, t874); // row 1, ZZ6
        put(104, t879); // row 2, ZZ6
        put(153, t884); // row 3, ZZ6
        put(193, t887); // row 4, ZZ6
        put(222, t869); // row 5, ZZ6
    }
    // XY6: column
    {
        let t888 = t164 + t167;
        let t891 = c6 * t168 - s6 * t169;
        let t894 = s6 * t168 + c6 * t169;
        let t899 = z1_5_z * t894 - (t214 * t891 + t217 * t888);
        let t904 = t223 * t888 - t220 * t891 - z2_4_y * t894;
        let t909 = c4 * t894 - (t224 * t891 + z3_5_y * t888);
        let t912 = s5 * t891 - c5 * t888;
        put(45, t899); // row 1, XY6
        put(105, t904); // row 2, XY6
        put(154, t909); // row 3, XY6
        put(194, t912); // row 4, XY6
        put(223, t894); // row 5, XY6
        put(242, t888); // row 6, XY6
    }
    // XZ6: column
    {
        let t914 = t703 + s6 * t163;
        let t916 = t700 - c6 * t163;
        let t921 = z1_5_z * t916 - (t214 * t914 + t153 * t217);
        let t926 = t153 * t223 - t220 * t914 - z2_4_y * t916;
        let t931 = c4 * t916 - (t224 * t914 + t153 * z3_5_y);
        let t934 = s5 * t914 - c5 * t153;
        put(46, t921); // row 1, XZ6
        put(106, t926); // row 2, XZ6
        put(155, t931); // row 3, XZ6
        put(195, t934); // row 4, XZ6
        put(224, t916); // row 5, XZ6
    }
    // YZ6: column
    {
        let t935 = t133 - t167;
        let t937 = t747 + c6 * t935;
        let t939 = s6 * t935 - t744;
        let t944 = z1_5_z * t939 - (t214 * t937 + t150 * t217);
        let t949 = t150 * t223 - t220 * t937 - z2_4_y * t939;
        let t954 = c4 * t939 - (t224 * t937 + t150 * z3_5_y);
        let t957 = s5 * t937 - c5 * t150;
        put(47, t944); // row 1, YZ6
        put(107, t949); // row 2, YZ6
        put(156, t954); // row 3, YZ6
        put(196, t957); // row 4, YZ6
        put(225, t939); // row 5, YZ6
    }
    // M7: column
    let [t960, t963] = {
        let t960 = c7 * t172 + s7 * a7_y;
        let t963 = s7 * t172 - c7 * a7_y;
        let t965 = t671 - c6 * t960;
        let t970 = c5 * t965 + s5 * t963;
        let t973 = s5 * t965 - c5 * t963;
        let t974 = L3 * t973;
        let t975 = L3 * t970;
        let t980 = s4 * t974;
        let t983 = c4 * t974 + L2 * t973;
        let t984 = L2 * (s4 * (t674 + s6 * t960) - c4 * t970) - t975;
        let t989 = c2 * t980 - (z1_3_x * t983 - t22 * t984);
        let t992 = s3 * t983 + c3 * t984;
        put(48, t989); // row 1, M7
        put(108, t992); // row 2, M7
        put(157, t980); // row 3, M7
        put(197, t975); // row 4, M7
        put(247, t960); // row 6, MSZ7
        [t960, t963]
    };
    // MSX7: column
    let [t994, t997, t999, t1000] = {
        let t994 = s7 * t200;
        let t995 = c7 * t198 + t994;
        let t997 = c7 * t200;
        let t998 = s7 * t198 - t997;
        let t999 = s7 * t141;
        let t1000 = c7 * t141;
        let t1003 = s6 * t202 - c6 * t995;
        let t1009 = c6 * t999 + s6 * a7_y;
        let t1012 = c6 * a7_y - s6 * t999;
        let t1015 = c5 * t1003 + s5 * t998;
        let t1018 = c5 * t998 - s5 * t1003;
        let t1027 = c5 * t1009 + s5 * t1000 + L3 * t1018;
        let t1028 = c5 * t1000 - s5 * t1009 - L3 * t1015;
        let t1037 = s4 * t1027 + c4 * t1012;
        let t1040 = L2 * t1018 - (s4 * t1012 - c4 * t1027);
        let t1041 = L2 * (c4 * t1015 - s4 * (s6 * t995 + c6 * t202)) - t1028;
        let t1046 = c2 * t1037 + (t22 * t1041 - z1_3_x * t1040);
        let t1049 = s3 * t1040 + c3 * t1041;
        put(49, t1046); // row 1, MSX7
        put(109, t1049); // row 2, MSX7
        put(158, t1037); // row 3, MSX7
        put(198, t1028); // row 4, MSX7
        put(226, t1012); // row 5, MSX7
        put(246, t999); // row 6, MSY7
        [t994, t997, t999, t1000]
    };
    // MSY7: column
    let [t1050, t1053] = {
        let t1050 = c7 * t199;
        let t1052 = s7 * t201 - t1050;
        let t1053 = s7 * t199;
        let t1055 = t1053 + c7 * t201;
        let t1058 = c6 * t1052 + s6 * t203;
        let t1064 = c6 * t1000 + s6 * t172;
        let t1067 = c6 * t172 - s6 * t1000;
        let t1070 = c5 * t1058 + s5 * t1055;
        let t1073 = c5 * t1055 - s5 * t1058;
        let t1082 = c5 * t1064 - s5 * t999 - L3 * t1073;
        let t1083 = L3 * t1070 - (s5 * t1064 + c5 * t999);
        let t1092 = s4 * t1082 + c4 * t1067;
        let t1095 = c4 * t1082 - s4 * t1067 - L2 * t1073;
        let t1096 = t1083 + L2 * (c4 * t1070 - s4 * (c6 * t203 - s6 * t1052));
        let t1101 = c2 * t1092 - (z1_3_x * t1095 + t22 * t1096);
        let t1104 = s3 * t1095 - c3 * t1096;
        put(50, t1101); // row 1, MSY7
        put(110, t1104); // row 2, MSY7
        put(159, t1092); // row 3, MSY7
        put(199, t1083); // row 4, MSY7
        put(227, t1067); // row 5, MSY7
        [t1050, t1053]
    };
    // MSZ7: column
    {
        let t1107 = c7 * t184 + s7 * t187;
        let t1110 = s7 * t184 - c7 * t187;
        let t1112 = t745 + c6 * t1107;
        let t1115 = c6 * t963;
        let t1116 = s6 * t963;
        let t1119 = s5 * t1110 - c5 * t1112;
        let t1122 = s5 * t1112 + c5 * t1110;
        let t1131 = L3 * t1122 - (c5 * t1115 + s5 * t960);
        let t1132 = s5 * t1115 - c5 * t960 - L3 * t1119;
        let t1141 = s4 * t1131 + c4 * t1116;
        let t1144 = c4 * t1131 - s4 * t1116 + L2 * t1122;
        let t1145 = t1132 - L2 * (c4 * t1119 + s4 * (t748 - s6 * t1107));
        let t1150 = c2 * t1141 - (z1_3_x * t1144 + t22 * t1145);
        let t1153 = s3 * t1144 - c3 * t1145;
        put(51, t1150); // row 1, MSZ7
        put(111, t1153); // row 2, MSZ7
        put(160, t1141); // row 3, MSZ7
        put(200, t1132); // row 4, MSZ7
        put(228, t1116); // row 5, MSZ7
    }
    // XX7: column
    let [t1155, t1158, t1161, t1164, t1183] = {
        let t1155 = s7 * t193;
        let t1156 = c7 * t195 + t1155;
        let t1158 = c7 * t193;
        let t1159 = s7 * t195 - t1158;
        let t1161 = s6 * t192;
        let t1162 = c6 * t1156 + t1161;
        let t1164 = c6 * t192;
        let t1165 = t1164 - s6 * t1156;
        let t1170 = z1_5_z * t1165 + (t214 * t1162 - t217 * t1159);
        let t1175 = t220 * t1162 + t223 * t1159 - z2_4_y * t1165;
        let t1180 = c4 * t1165 - (z3_5_y * t1159 - t224 * t1162);
        let t1183 = s5 * t1162 + c5 * t1159;
        put(52, t1170); // row 1, XX7
        put(112, t1175); // row 2, XX7
        put(161, t1180); // row 3, XX7
        put(229, t1165); // row 5, XX7
        put(248, t1159); // row 6, XX7
        [t1155, t1158, t1161, t1164, t1183]
    };
    // YY7: column
    let [t1184, t1187] = {
        let t1184 = c7 * t194;
        let t1186 = t1184 + s7 * t196;
        let t1187 = s7 * t194;
        let t1189 = c7 * t196 - t1187;
        let t1191 = t1161 + c6 * t1186;
        let t1193 = s6 * t1186 - t1164;
        let t1198 = z1_5_z * t1193 - (t214 * t1191 + t217 * t1189);
        let t1203 = t223 * t1189 - t220 * t1191 - z2_4_y * t1193;
        let t1208 = c4 * t1193 - (t224 * t1191 + z3_5_y * t1189);
        let t1211 = s5 * t1191 - c5 * t1189;
        put(53, t1198); // row 1, YY7
        put(113, t1203); // row 2, YY7
        put(162, t1208); // row 3, YY7
        put(202, t1211); // row 4, YY7
        put(230, t1193); // row 5, YY7
        put(249, t1189); // row 6, YY7
        [t1184, t1187]
    };
    // ZZ7: column
    {
        let t1212 = t1155 - t1184;
        let t1213 = t1158 + t1187;
        let t1216 = c6 * t1212 - s6 * dw7_z;
        let t1219 = s6 * t1212 + c6 * dw7_z;
        let t1224 = z1_5_z * t1219 - (t214 * t1216 + t217 * t1213);
        let t1229 = t223 * t1213 - t220 * t1216 - z2_4_y * t1219;
        let t1234 = c4 * t1219 - (t224 * t1216 + z3_5_y * t1213);
        let t1237 = s5 * t1216 - c5 * t1213;
        put(54, t1224); // row 1, ZZ7
        put(114, t1229); // row 2, ZZ7
        put(163, t1234); // row 3, ZZ7
        put(203, t1237); // row 4, ZZ7
        put(231, t1219); // row 5, ZZ7
        put(250, t1213); // row 6, ZZ7
    }
    // XY7: column
    {
        let t1238 = t198 + t201;
        let t1241 = s7 * t203 - c7 * t202;
        let t1244 = s7 * t202 + c7 * t203;
        let t1247 = c6 * t1241 - s6 * t1238;
        let t1250 = s6 * t1241 + c6 * t1238;
        let t1255 = z1_5_z * t1250 - (t214 * t1247 + t217 * t1244);
        let t1260 = t223 * t1244 - t220 * t1247 - z2_4_y * t1250;
        let t1265 = c4 * t1250 - (t224 * t1247 + z3_5_y * t1244);
        let t1268 = s5 * t1247 - c5 * t1244;
        put(55, t1255); // row 1, XY7
        put(115, t1260); // row 2, XY7
        put(164, t1265); // row 3, XY7
        put(204, t1268); // row 4, XY7
        put(232, t1250); // row 5, XY7
        put(251, t1244); // row 6, XY7
        put(261, t1238); // row 7, XY7
    }
    // XZ7: column
    {
        let t1270 = s7 * t197 - t997;
        let t1272 = t994 + c7 * t197;
        let t1275 = c6 * t1270 - s6 * t187;
        let t1278 = s6 * t1270 + c6 * t187;
        let t1283 = z1_5_z * t1278 - (t214 * t1275 + t217 * t1272);
        let t1288 = t223 * t1272 - t220 * t1275 - z2_4_y * t1278;
        let t1293 = c4 * t1278 - (t224 * t1275 + z3_5_y * t1272);
        let t1296 = s5 * t1275 - c5 * t1272;
        put(56, t1283); // row 1, XZ7
        put(116, t1288); // row 2, XZ7
        put(165, t1293); // row 3, XZ7
        put(205, t1296); // row 4, XZ7
        put(233, t1278); // row 5, XZ7
        put(252, t1272); // row 6, XZ7
    }
    // YZ7: column
    {
        let t1297 = t201 - t167;
        let t1299 = t1053 + c7 * t1297;
        let t1301 = s7 * t1297 - t1050;
        let t1304 = c6 * t1299 + s6 * t184;
        let t1307 = c6 * t184 - s6 * t1299;
        let t1312 = z1_5_z * t1307 - (t217 * t1301 - t214 * t1304);
        let t1317 = t220 * t1304 + t223 * t1301 - z2_4_y * t1307;
        let t1322 = c4 * t1307 - (z3_5_y * t1301 - t224 * t1304);
        let t1326 = dq1.sign();
        let t1327 = dq2.sign();
        let t1328 = dq3.sign();
        let t1329 = dq4.sign();
        let t1330 = dq5.sign();
        let t1331 = dq6.sign();
        let t1332 = dq7.sign();
        let t1333 = -t328;
        let t1334 = -a2_x;
        let t1335 = -t9;
        let t1336 = -t50;
        let t1337 = -t42;
        let t1338 = -t346;
        let t1339 = -t84;
        let t1340 = -t79;
        let t1341 = -t465;
        let t1342 = -t615;
        let t1343 = -t634;
        let t1344 = -t867;
        let t1345 = -t1183;
        let t1346 = -(s5 * t1304 + c5 * t1301);
        let t1347 = -t124;
        let t1348 = -t705;
        let t1349 = -t141;
        let t1350 = -t158;
        let t1351 = -t1000;
        let t1352 = -t192;
        put(17, t1333); // row 1, YZ3
        put(57, t1312); // row 1, YZ7
        put(59, t1326); // row 1, FC1
        put(61, t1334); // row 2, MSY2
        put(62, t1335); // row 2, XX2
        put(117, t1317); // row 2, YZ7
        put(119, t1327); // row 2, FC2
        put(123, t1336); // row 3, YY3
        put(127, t1337); // row 3, YZ3
        put(129, t1338); // row 3, MSY4
        put(166, t1322); // row 3, YZ7
        put(168, t1328); // row 3, FC3
        put(172, t1339); // row 4, YY4
        put(175, t1340); // row 4, XZ4
        put(177, t1341); // row 4, M5
        put(183, t1342); // row 4, ZZ5
        put(184, t1343); // row 4, XY5
        put(192, t1344); // row 4, YY6
        put(201, t1345); // row 4, XX7
        put(206, t1346); // row 4, YZ7
        put(208, t1329); // row 4, FC4
        put(212, t1347); // row 5, YY5
        put(218, t1348); // row 5, MSY6
        put(234, t1307); // row 5, YZ7
        put(236, t1330); // row 5, FC5
        put(237, t1349); // row 6, MSX6
        put(239, t1350); // row 6, XX6
        put(245, t1351); // row 6, MSX7
        put(253, t1301); // row 6, YZ7
        put(255, t1331); // row 6, FC6
        put(259, t1352); // row 7, YY7
        put(265, t1332); // row 7, FC7
    }
}
