//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4.
//!
//! 597 multiplications, 426 additions; 7 x 57, 202 of 399 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 202;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11),
    (0, 12), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18), (0, 19), (0, 20), (0, 21),
    (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28), (0, 29), (0, 30), (0, 31),
    (0, 32), (0, 33), (0, 34), (0, 35), (0, 36), (0, 37), (0, 38), (0, 39), (0, 40), (0, 41),
    (0, 42), (0, 43), (0, 50), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7),
    (1, 8), (1, 9), (1, 10), (1, 11), (1, 12), (1, 13), (1, 14), (1, 15), (1, 16), (1, 17),
    (1, 18), (1, 19), (1, 20), (1, 21), (1, 22), (1, 23), (1, 24), (1, 25), (1, 26), (1, 27),
    (1, 28), (1, 29), (1, 30), (1, 31), (1, 32), (1, 33), (1, 34), (1, 35), (1, 36), (1, 37),
    (1, 38), (1, 39), (1, 40), (1, 41), (1, 42), (1, 44), (1, 51), (2, 8), (2, 9), (2, 10),
    (2, 11), (2, 12), (2, 13), (2, 14), (2, 15), (2, 16), (2, 17), (2, 18), (2, 19), (2, 20),
    (2, 21), (2, 22), (2, 23), (2, 24), (2, 25), (2, 26), (2, 27), (2, 28), (2, 29), (2, 30),
    (2, 31), (2, 32), (2, 33), (2, 34), (2, 35), (2, 36), (2, 37), (2, 38), (2, 39), (2, 40),
    (2, 41), (2, 42), (2, 45), (2, 52), (3, 15), (3, 16), (3, 17), (3, 18), (3, 19), (3, 20),
    (3, 21), (3, 22), (3, 23), (3, 24), (3, 25), (3, 26), (3, 27), (3, 28), (3, 29), (3, 30),
    (3, 31), (3, 32), (3, 33), (3, 34), (3, 35), (3, 36), (3, 37), (3, 38), (3, 39), (3, 40),
    (3, 41), (3, 42), (3, 46), (3, 53), (4, 22), (4, 23), (4, 24), (4, 25), (4, 26), (4, 27),
    (4, 28), (4, 29), (4, 30), (4, 31), (4, 32), (4, 33), (4, 34), (4, 35), (4, 36), (4, 37),
    (4, 38), (4, 39), (4, 40), (4, 41), (4, 42), (4, 47), (4, 54), (5, 29), (5, 30), (5, 31),
    (5, 32), (5, 33), (5, 34), (5, 35), (5, 36), (5, 37), (5, 38), (5, 39), (5, 40), (5, 41),
    (5, 42), (5, 48), (5, 55), (6, 36), (6, 37), (6, 38), (6, 39), (6, 40), (6, 41), (6, 42),
    (6, 49), (6, 56),
];

/// Regressor `W_b` of the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 57]; 7]) {
    let flat = &mut out.as_flattened_mut()[..];
    flat[1..3].fill(S::default());
    flat[44..50].fill(S::default());
    flat[51..58].fill(S::default());
    flat[100] = S::default();
    flat[102..108].fill(S::default());
    flat[109..122].fill(S::default());
    flat[157..159].fill(S::default());
    flat[160..166].fill(S::default());
    flat[167..186].fill(S::default());
    flat[214..217].fill(S::default());
    flat[218..224].fill(S::default());
    flat[225..250].fill(S::default());
    flat[271..275].fill(S::default());
    flat[276..282].fill(S::default());
    flat[283..314].fill(S::default());
    flat[328..333].fill(S::default());
    flat[334..340].fill(S::default());
    flat[341..378].fill(S::default());
    flat[385..391].fill(S::default());
    flat[392..398].fill(S::default());
    nonzeros(trig, dq, ddq, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 57]; 7]) {
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
        put(0, ddq1); // row 1, ZZ1R
        put(41, dq1); // row 1, FV1
        put(46, ddq2); // row 2, ZZ2R
        put(85, dq2); // row 2, FV2
        put(122, dq3); // row 3, FV3
        put(152, dq4); // row 4, FV4
        put(175, dq5); // row 5, FV5
        put(191, dq6); // row 6, FV6
        put(200, dq7); // row 7, FV7
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
        let t14 = t7 - t8;
        let t15 = t14 - t0;
        let t16 = ddq2 - t9;
        let t17 = ddq2 + t9;
        let t18 = t7 + t8;
        let t19 = dw2_y - t10;
        let t20 = t11 + dw2_x;
        put(43, a2_y); // row 2, MSX2
        put(48, t5); // row 2, XZ2
        put(49, t6); // row 2, YZ2
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
        let t58 = t50 - dw3_z;
        let t59 = t48 + t49;
        let t60 = t51 + t54;
        let t61 = t52 + t53;
        put(87, a3_y); // row 3, MSX3
        put(88, t30); // row 3, MSY3R
        put(89, t50); // row 3, XX3R
        put(90, dw3_z); // row 3, ZZ3R
        put(92, t45); // row 3, XZ3
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
        let t89 = t82 - t83;
        let t90 = t89 - t59;
        let t91 = dw4_z + t84;
        let t92 = dw4_z - t84;
        let t93 = t82 + t83;
        let t94 = t85 + t88;
        let t95 = t86 + t87;
        put(124, a4_y); // row 4, MSX4
        put(125, t64); // row 4, MSY4R
        put(126, t84); // row 4, XX4R
        put(127, dw4_z); // row 4, ZZ4R
        put(130, t76); // row 4, YZ4
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
        let t129 = t122 - t123;
        let t130 = t129 - t93;
        let t131 = dw5_z + t124;
        let t132 = dw5_z - t124;
        let t133 = t122 + t123;
        let t134 = dw5_y - t125;
        let t135 = t126 + t127;
        put(154, a5_y); // row 5, MSX5
        put(155, t104); // row 5, MSY5R
        put(156, t124); // row 5, XX5R
        put(157, dw5_z); // row 5, ZZ5R
        put(159, t119); // row 5, XZ5
        put(160, t116); // row 5, YZ5
        [
        t100, t104, a5_y, w5_x, t113, t116, t119, w5_z,
        dw5_z, t124, t125, t126, t127, dw5_y, t129, t130,
        t131, t132, t133, t134, t135,
    ]
    };
    // link 6: motion
    let [
        t138, a6_y, w6_x, w6_y, t150, t153, w6_z, dw6_z,
        t158, t159, t160, dw6_x, t162, t163, t164, t165,
        t166, t167, t168, t169,
    ] = {
        let t138 = c6 * t104 + s6 * t100;
        let a6_y = s6 * t104 - c6 * t100;
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
        put(177, a6_y); // row 6, MSX6
        put(178, t138); // row 6, MSY6R
        put(180, dw6_z); // row 6, ZZ6R
        put(182, t153); // row 6, XZ6
        put(183, t150); // row 6, YZ6
        [
        t138, a6_y, w6_x, w6_y, t150, t153, w6_z, dw6_z,
        t158, t159, t160, dw6_x, t162, t163, t164, t165,
        t166, t167, t168, t169,
    ]
    };
    // link 7: motion
    let [
        t172, a7_y, t184, t187, dw7_z, t192, t193, t194,
        t195, t197, t198, t199, t200, t201, t202, t203,
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
        let t197 = t190 - t191;
        let t198 = t167 - t197;
        let t199 = dw7_z + t192;
        let t200 = dw7_z - t192;
        let t201 = t190 + t191;
        let t202 = t193 + (t193 - t184);
        let t203 = t194 + t195;
        put(193, a7_y); // row 7, MSX7
        put(194, t172); // row 7, MSY7
        put(195, t192); // row 7, XX7R
        put(196, dw7_z); // row 7, ZZ7
        put(198, t187); // row 7, XZ7
        put(199, t184); // row 7, YZ7
        [
        t172, a7_y, t184, t187, dw7_z, t192, t193, t194,
        t195, t197, t198, t199, t200, t201, t202, t203,
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
    let [t214, z1_6_z, t220, t223, t224, z3_5_y] = {
        let t214 = c5 * t206 + s5 * t22;
        let z1_6_z = c5 * t22 - s5 * t206;
        let t220 = c5 * t210 + c3 * s5;
        let t223 = c3 * c5 - s5 * t210;
        let t224 = s4 * c5;
        let z3_5_y = s4 * s5;
        [t214, z1_6_z, t220, t223, t224, z3_5_y]
    };
    // XX2: column
    let t227 = {
        let t227 = c2 * t10;
        let t228 = s2 * dw2_x + t227;
        put(1, t228); // row 1, XX2R
        t227
    };
    // ZZ2: column
    {
        let t230 = s2 * t11 - t227;
        put(2, t230); // row 1, ZZ2R
    }
    // XY2: column
    {
        let t231 = t15 + t18;
        let t234 = s2 * t19 + c2 * t20;
        put(3, t234); // row 1, XY2
        put(47, t231); // row 2, XY2
    }
    // XZ2: column
    {
        let t237 = s2 * t17 - c2 * t14;
        put(4, t237); // row 1, XZ2
    }
    // YZ2: column
    {
        let t241 = s2 * (t0 - t18) + c2 * t16;
        put(5, t241); // row 1, YZ2
    }
    // MSX3: column
    {
        let t242 = L2 * t58;
        let t244 = a3_z - L2 * t56;
        let t249 = c2 * a3_y + (z1_3_x * t242 + t22 * t244);
        let t252 = c3 * t244 - s3 * t242;
        put(6, t249); // row 1, MSX3
        put(50, t252); // row 2, MSX3
    }
    // MSY3: column
    {
        let t254 = L2 * t57;
        let t255 = a3_z + L2 * t59;
        let t260 = c2 * t30 + (z1_3_x * t255 + t22 * t254);
        let t263 = c3 * t254 - s3 * t255;
        put(7, t260); // row 1, MSY3R
        put(51, t263); // row 2, MSY3R
    }
    // XX3: column
    let [t265, t270] = {
        let t265 = t22 * t51;
        let t268 = c2 * t50 - (z1_3_x * t53 + t265);
        let t270 = c3 * t51;
        let t271 = s3 * t53 - t270;
        put(8, t268); // row 1, XX3R
        put(52, t271); // row 2, XX3R
        [t265, t270]
    };
    // ZZ3: column
    {
        let t275 = c2 * dw3_z + (t265 - z1_3_x * t52);
        let t277 = t270 + s3 * t52;
        put(9, t275); // row 1, ZZ3R
        put(53, t277); // row 2, ZZ3R
    }
    // XY3: column
    {
        let t278 = t56 + t59;
        let t283 = c2 * t278 - (z1_3_x * t60 - t22 * t61);
        let t286 = s3 * t60 + c3 * t61;
        put(10, t283); // row 1, XY3
        put(54, t286); // row 2, XY3
        put(91, t278); // row 3, XY3
    }
    // XZ3: column
    {
        let t291 = c2 * t45 + (t22 * t55 - z1_3_x * t58);
        let t294 = s3 * t58 + c3 * t55;
        put(11, t291); // row 1, XZ3
        put(55, t294); // row 2, XZ3
    }
    // YZ3: column
    let t300 = {
        let t295 = t59 - t18;
        let t300 = c2 * t42 + (z1_3_x * t295 + t22 * t57);
        let t303 = s3 * t295 - c3 * t57;
        put(56, t303); // row 2, YZ3
        t300
    };
    // MSX4: column
    let [t305, t307, t308] = {
        let t305 = s4 * t92;
        let t307 = s4 * a3_y;
        let t308 = c4 * a3_y;
        let t311 = L2 * t94 - t307;
        let t312 = a4_y + L2 * (c4 * t90 - t305);
        let t317 = c2 * t308 - (z1_3_x * t311 + t22 * t312);
        let t320 = s3 * t311 - c3 * t312;
        put(13, t317); // row 1, MSX4
        put(57, t320); // row 2, MSX4
        put(94, t308); // row 3, MSX4
        [t305, t307, t308]
    };
    // MSY4: column
    let t321 = {
        let t321 = c4 * t91;
        let t326 = t308 + L2 * t95;
        let t327 = L2 * (t321 - s4 * t93) - t64;
        let t332 = z1_3_x * t326 + t22 * t327 - c2 * t307;
        let t335 = c3 * t327 - s3 * t326;
        put(14, t332); // row 1, MSY4R
        put(58, t335); // row 2, MSY4R
        t321
    };
    // XX4: column
    let [t337, t342, t347] = {
        let t337 = t85 * z1_5_z;
        let t340 = t87 * t206 - t337 - t22 * t84;
        let t342 = t85 * z2_4_y;
        let t345 = t87 * t210 + t342 - c3 * t84;
        let t347 = c4 * t85;
        let t348 = s4 * t87 - t347;
        put(15, t340); // row 1, XX4R
        put(59, t345); // row 2, XX4R
        put(96, t348); // row 3, XX4R
        [t337, t342, t347]
    };
    // ZZ4: column
    {
        let t352 = t337 + t86 * t206 - t22 * dw4_z;
        let t356 = t86 * t210 - t342 - c3 * dw4_z;
        let t358 = t347 + s4 * t86;
        put(16, t352); // row 1, ZZ4R
        put(60, t356); // row 2, ZZ4R
        put(97, t358); // row 3, ZZ4R
    }
    // XY4: column
    {
        let t359 = t90 + t93;
        let t364 = t94 * t206 + t95 * z1_5_z - t22 * t359;
        let t369 = t94 * t210 - t95 * z2_4_y - c3 * t359;
        let t372 = s4 * t94 + c4 * t95;
        put(17, t364); // row 1, XY4
        put(61, t369); // row 2, XY4
        put(98, t372); // row 3, XY4
        put(128, t359); // row 4, XY4
    }
    // XZ4: column
    {
        let t377 = t22 * t79 + (t89 * z1_5_z - t92 * t206);
        let t382 = c3 * t79 - (t92 * t210 + t89 * z2_4_y);
        let t384 = c4 * t89 - t305;
        put(18, t377); // row 1, XZ4
        put(62, t382); // row 2, XZ4
        put(99, t384); // row 3, XZ4
    }
    // YZ4: column
    {
        let t385 = t93 - t59;
        let t390 = t206 * t385 - t91 * z1_5_z - t22 * t76;
        let t395 = t210 * t385 + t91 * z2_4_y - c3 * t76;
        let t397 = s4 * t385 - t321;
        put(19, t390); // row 1, YZ4
        put(63, t395); // row 2, YZ4
        put(100, t397); // row 3, YZ4
    }
    // MSX5: column
    let [t399, t404, t405] = {
        let t399 = s5 * t132;
        let t400 = c5 * t130 - t399;
        let t403 = s5 * t130 + c5 * t132;
        let t404 = s5 * t100;
        let t405 = c5 * t100;
        let t408 = t404 + L3 * t403;
        let t409 = t405 + L3 * t400;
        let t418 = s4 * t408 + c4 * a5_y;
        let t421 = c4 * t408 - s4 * a5_y + L2 * t403;
        let t422 = L2 * (s4 * t134 - c4 * t400) - t409;
        let t427 = c2 * t418 + (t22 * t422 - z1_3_x * t421);
        let t430 = s3 * t421 + c3 * t422;
        put(20, t427); // row 1, MSX5
        put(64, t430); // row 2, MSX5
        put(101, t418); // row 3, MSX5
        put(131, t409); // row 4, MSX5
        [t399, t404, t405]
    };
    // MSY5: column
    let t431 = {
        let t431 = c5 * t131;
        let t433 = s5 * t133 - t431;
        let t436 = s5 * t131 + c5 * t133;
        let t439 = t405 - L3 * t436;
        let t440 = L3 * t433 - t404;
        let t449 = s4 * t439 + c4 * t104;
        let t452 = c4 * t439 - s4 * t104 - L2 * t436;
        let t453 = t440 - L2 * (s4 * t135 - c4 * t433);
        let t458 = c2 * t449 - (z1_3_x * t452 + t22 * t453);
        let t461 = s3 * t452 - c3 * t453;
        put(21, t458); // row 1, MSY5R
        put(65, t461); // row 2, MSY5R
        put(102, t449); // row 3, MSY5R
        put(132, t440); // row 4, MSY5R
        t431
    };
    // XX5: column
    let [t463, t468, t473, t478] = {
        let t463 = t125 * z1_6_z;
        let t466 = t124 * z1_5_z - (t463 - t127 * t214);
        let t468 = t125 * t223;
        let t471 = t127 * t220 - t468 - t124 * z2_4_y;
        let t473 = t125 * z3_5_y;
        let t476 = c4 * t124 + (t127 * t224 + t473);
        let t478 = c5 * t125;
        let t479 = t478 - s5 * t127;
        put(22, t466); // row 1, XX5R
        put(66, t471); // row 2, XX5R
        put(103, t476); // row 3, XX5R
        put(133, t479); // row 4, XX5R
        [t463, t468, t473, t478]
    };
    // ZZ5: column
    let t493 = {
        let t483 = dw5_z * z1_5_z + (t463 + t126 * t214);
        let t487 = t468 + t126 * t220 - dw5_z * z2_4_y;
        let t491 = c4 * dw5_z + (t126 * t224 - t473);
        let t493 = t478 + s5 * t126;
        put(23, t483); // row 1, ZZ5R
        put(67, t487); // row 2, ZZ5R
        put(104, t491); // row 3, ZZ5R
        t493
    };
    // XY5: column
    {
        let t494 = t130 + t133;
        let t499 = z1_5_z * t494 + (t135 * z1_6_z - t134 * t214);
        let t504 = t135 * t223 - t134 * t220 - z2_4_y * t494;
        let t509 = c4 * t494 - (t134 * t224 + t135 * z3_5_y);
        let t512 = s5 * t134 - c5 * t135;
        put(24, t499); // row 1, XY5
        put(68, t504); // row 2, XY5
        put(105, t509); // row 3, XY5
        put(135, t512); // row 4, XY5
        put(158, t494); // row 5, XY5
    }
    // XZ5: column
    {
        let t517 = t119 * z1_5_z - (t132 * t214 - t129 * z1_6_z);
        let t522 = t129 * t223 - t132 * t220 - t119 * z2_4_y;
        let t527 = c4 * t119 - (t132 * t224 + t129 * z3_5_y);
        let t529 = t399 - c5 * t129;
        put(25, t517); // row 1, XZ5
        put(69, t522); // row 2, XZ5
        put(106, t527); // row 3, XZ5
        put(136, t529); // row 4, XZ5
    }
    // YZ5: column
    {
        let t530 = t133 - t93;
        let t535 = t116 * z1_5_z + (t214 * t530 - t131 * z1_6_z);
        let t540 = t220 * t530 - t131 * t223 - t116 * z2_4_y;
        let t545 = c4 * t116 + (t224 * t530 + t131 * z3_5_y);
        let t547 = t431 - s5 * t530;
        put(26, t535); // row 1, YZ5
        put(70, t540); // row 2, YZ5
        put(107, t545); // row 3, YZ5
        put(137, t547); // row 4, YZ5
    }
    // MSX6: column
    let [t549, t552, t554, t555] = {
        let t549 = s6 * t166;
        let t550 = c6 * t164 - t549;
        let t552 = c6 * t166;
        let t554 = s6 * a5_y;
        let t555 = c6 * a5_y;
        let t558 = c5 * t550 - s5 * t168;
        let t561 = s5 * t550 + c5 * t168;
        let t570 = L3 * t561 - (s5 * a6_y - c5 * t554);
        let t571 = L3 * t558 - (s5 * t554 + c5 * a6_y);
        let t580 = s4 * t570 + c4 * t555;
        let t583 = c4 * t570 - s4 * t555 + L2 * t561;
        let t584 = t571 + L2 * (c4 * t558 + s4 * (s6 * t164 + t552));
        let t589 = c2 * t580 - (z1_3_x * t583 + t22 * t584);
        let t592 = s3 * t583 - c3 * t584;
        put(27, t589); // row 1, MSX6
        put(71, t592); // row 2, MSX6
        put(108, t580); // row 3, MSX6
        put(138, t571); // row 4, MSX6
        put(161, t555); // row 5, MSX6
        [t549, t552, t554, t555]
    };
    // MSY6: column
    let [t593, t596] = {
        let t593 = c6 * t165;
        let t595 = t593 + s6 * t167;
        let t596 = s6 * t165;
        let t601 = c5 * t595 + s5 * t169;
        let t604 = c5 * t169 - s5 * t595;
        let t613 = c5 * t555 - s5 * t138 - L3 * t604;
        let t614 = L3 * t601 - (s5 * t555 + c5 * t138);
        let t623 = s4 * t613 - c4 * t554;
        let t626 = L2 * t604 - (c4 * t613 + s4 * t554);
        let t627 = L2 * (s4 * (c6 * t167 - t596) - c4 * t601) - t614;
        let t632 = c2 * t623 + (z1_3_x * t626 + t22 * t627);
        let t635 = c3 * t627 - s3 * t626;
        put(28, t632); // row 1, MSY6R
        put(72, t635); // row 2, MSY6R
        put(109, t623); // row 3, MSY6R
        put(139, t614); // row 4, MSY6R
        [t593, t596]
    };
    // XX6: column
    let [t637, t640] = {
        let t637 = s6 * t159;
        let t638 = t637 - c6 * dw6_x;
        let t640 = c6 * t159;
        let t641 = s6 * dw6_x + t640;
        let t646 = z1_5_z * t641 + (t214 * t638 - t158 * z1_6_z);
        let t651 = t220 * t638 - t158 * t223 - z2_4_y * t641;
        let t656 = c4 * t641 + (t224 * t638 + t158 * z3_5_y);
        let t659 = c5 * t158 - s5 * t638;
        put(29, t646); // row 1, XX6R
        put(73, t651); // row 2, XX6R
        put(110, t656); // row 3, XX6R
        put(140, t659); // row 4, XX6R
        put(163, t641); // row 5, XX6R
        [t637, t640]
    };
    // ZZ6: column
    {
        let t661 = t637 + c6 * t160;
        let t663 = s6 * t160 - t640;
        let t668 = z1_5_z * t663 - (t214 * t661 - dw6_z * z1_6_z);
        let t673 = dw6_z * t223 - t220 * t661 - z2_4_y * t663;
        let t678 = c4 * t663 - (t224 * t661 + dw6_z * z3_5_y);
        let t681 = s5 * t661 - c5 * dw6_z;
        put(30, t668); // row 1, ZZ6R
        put(74, t673); // row 2, ZZ6R
        put(111, t678); // row 3, ZZ6R
        put(141, t681); // row 4, ZZ6R
        put(164, t663); // row 5, ZZ6R
    }
    // XY6: column
    {
        let t682 = t164 + t167;
        let t685 = c6 * t168 - s6 * t169;
        let t688 = s6 * t168 + c6 * t169;
        let t693 = z1_5_z * t688 + (z1_6_z * t682 - t214 * t685);
        let t698 = t223 * t682 - t220 * t685 - z2_4_y * t688;
        let t703 = c4 * t688 - (t224 * t685 + z3_5_y * t682);
        let t706 = s5 * t685 - c5 * t682;
        put(31, t693); // row 1, XY6
        put(75, t698); // row 2, XY6
        put(112, t703); // row 3, XY6
        put(142, t706); // row 4, XY6
        put(165, t688); // row 5, XY6
        put(181, t682); // row 6, XY6
    }
    // XZ6: column
    {
        let t708 = t552 + s6 * t163;
        let t710 = t549 - c6 * t163;
        let t715 = z1_5_z * t710 - (t214 * t708 - t153 * z1_6_z);
        let t720 = t153 * t223 - t220 * t708 - z2_4_y * t710;
        let t725 = c4 * t710 - (t224 * t708 + t153 * z3_5_y);
        let t728 = s5 * t708 - c5 * t153;
        put(32, t715); // row 1, XZ6
        put(76, t720); // row 2, XZ6
        put(113, t725); // row 3, XZ6
        put(143, t728); // row 4, XZ6
        put(166, t710); // row 5, XZ6
    }
    // YZ6: column
    {
        let t729 = t133 - t167;
        let t731 = t596 + c6 * t729;
        let t733 = s6 * t729 - t593;
        let t738 = z1_5_z * t733 - (t214 * t731 - t150 * z1_6_z);
        let t743 = t150 * t223 - t220 * t731 - z2_4_y * t733;
        let t748 = c4 * t733 - (t224 * t731 + t150 * z3_5_y);
        let t751 = s5 * t731 - c5 * t150;
        put(33, t738); // row 1, YZ6
        put(77, t743); // row 2, YZ6
        put(114, t748); // row 3, YZ6
        put(144, t751); // row 4, YZ6
        put(167, t733); // row 5, YZ6
    }
    // MSX7: column
    let [t753, t756, t758, t759] = {
        let t753 = s7 * t200;
        let t754 = c7 * t198 + t753;
        let t756 = c7 * t200;
        let t757 = t756 - s7 * t198;
        let t758 = s7 * a6_y;
        let t759 = c7 * a6_y;
        let t762 = c6 * t754 + s6 * t202;
        let t768 = c6 * t758 - s6 * a7_y;
        let t771 = s6 * t758 + c6 * a7_y;
        let t774 = c5 * t762 + s5 * t757;
        let t777 = c5 * t757 - s5 * t762;
        let t786 = L3 * t777 - (c5 * t768 + s5 * t759);
        let t787 = s5 * t768 - c5 * t759 - L3 * t774;
        let t796 = s4 * t786 + c4 * t771;
        let t799 = L2 * t777 - (s4 * t771 - c4 * t786);
        let t800 = L2 * (c4 * t774 + s4 * (s6 * t754 - c6 * t202)) - t787;
        let t805 = c2 * t796 + (t22 * t800 - z1_3_x * t799);
        let t808 = s3 * t799 + c3 * t800;
        put(34, t805); // row 1, MSX7
        put(78, t808); // row 2, MSX7
        put(115, t796); // row 3, MSX7
        put(145, t787); // row 4, MSX7
        put(168, t771); // row 5, MSX7
        put(184, t759); // row 6, MSX7
        [t753, t756, t758, t759]
    };
    // MSY7: column
    let [t809, t812] = {
        let t809 = c7 * t199;
        let t811 = t809 - s7 * t201;
        let t812 = s7 * t199;
        let t814 = t812 + c7 * t201;
        let t817 = s6 * t203 - c6 * t811;
        let t823 = c6 * t759 - s6 * t172;
        let t826 = s6 * t759 + c6 * t172;
        let t829 = c5 * t817 + s5 * t814;
        let t832 = s5 * t817 - c5 * t814;
        let t841 = s5 * t758 - c5 * t823 + L3 * t832;
        let t842 = s5 * t823 + c5 * t758 + L3 * t829;
        let t851 = s4 * t841 + c4 * t826;
        let t854 = L2 * t832 - (s4 * t826 - c4 * t841);
        let t855 = t842 + L2 * (c4 * t829 - s4 * (s6 * t811 + c6 * t203));
        let t860 = c2 * t851 - (z1_3_x * t854 + t22 * t855);
        let t863 = s3 * t854 - c3 * t855;
        put(35, t860); // row 1, MSY7
        put(79, t863); // row 2, MSY7
        put(116, t851); // row 3, MSY7
        put(146, t842); // row 4, MSY7
        put(169, t826); // row 5, MSY7
        [t809, t812]
    };
    // XX7: column
    let [t865, t868, t893] = {
        let t865 = s7 * t193;
        let t866 = c7 * t195 + t865;
        let t868 = c7 * t193;
        let t869 = s7 * t195 - t868;
        let t872 = c6 * t866 + s6 * t192;
        let t875 = c6 * t192 - s6 * t866;
        let t880 = z1_5_z * t875 + (t214 * t872 + z1_6_z * t869);
        let t885 = t220 * t872 + t223 * t869 - z2_4_y * t875;
        let t890 = c4 * t875 - (z3_5_y * t869 - t224 * t872);
        let t893 = s5 * t872 + c5 * t869;
        put(36, t880); // row 1, XX7R
        put(80, t885); // row 2, XX7R
        put(117, t890); // row 3, XX7R
        put(170, t875); // row 5, XX7R
        put(186, t869); // row 6, XX7R
        [t865, t868, t893]
    };
    // ZZ7: column
    {
        let t895 = t865 - c7 * t194;
        let t897 = t868 + s7 * t194;
        let t900 = c6 * t895 - s6 * dw7_z;
        let t903 = s6 * t895 + c6 * dw7_z;
        let t908 = z1_5_z * t903 + (z1_6_z * t897 - t214 * t900);
        let t913 = t223 * t897 - t220 * t900 - z2_4_y * t903;
        let t918 = c4 * t903 - (t224 * t900 + z3_5_y * t897);
        let t921 = s5 * t900 - c5 * t897;
        put(37, t908); // row 1, ZZ7
        put(81, t913); // row 2, ZZ7
        put(118, t918); // row 3, ZZ7
        put(148, t921); // row 4, ZZ7
        put(171, t903); // row 5, ZZ7
        put(187, t897); // row 6, ZZ7
    }
    // XY7: column
    let t952 = {
        let t922 = t201 - t198;
        let t925 = c7 * t202 - s7 * t203;
        let t928 = s7 * t202 + c7 * t203;
        let t931 = c6 * t925 + s6 * t922;
        let t934 = c6 * t922 - s6 * t925;
        let t939 = z1_5_z * t934 + (t214 * t931 + z1_6_z * t928);
        let t944 = t220 * t931 + t223 * t928 - z2_4_y * t934;
        let t949 = c4 * t934 + (t224 * t931 - z3_5_y * t928);
        let t952 = s5 * t931 + c5 * t928;
        put(38, t939); // row 1, XY7
        put(82, t944); // row 2, XY7
        put(119, t949); // row 3, XY7
        put(172, t934); // row 5, XY7
        put(188, t928); // row 6, XY7
        put(197, t922); // row 7, XY7
        t952
    };
    // XZ7: column
    {
        let t954 = t756 + s7 * t197;
        let t956 = c7 * t197 - t753;
        let t959 = c6 * t954 - s6 * t187;
        let t962 = s6 * t954 + c6 * t187;
        let t967 = z1_5_z * t962 + (z1_6_z * t956 - t214 * t959);
        let t972 = t223 * t956 - t220 * t959 - z2_4_y * t962;
        let t977 = c4 * t962 - (t224 * t959 + z3_5_y * t956);
        let t980 = s5 * t959 - c5 * t956;
        put(39, t967); // row 1, XZ7
        put(83, t972); // row 2, XZ7
        put(120, t977); // row 3, XZ7
        put(150, t980); // row 4, XZ7
        put(173, t962); // row 5, XZ7
        put(189, t956); // row 6, XZ7
    }
    // YZ7: column
    {
        let t981 = t201 - t167;
        let t983 = t812 + c7 * t981;
        let t985 = s7 * t981 - t809;
        let t988 = c6 * t983 + s6 * t184;
        let t991 = c6 * t184 - s6 * t983;
        let t996 = z1_5_z * t991 + (t214 * t988 + z1_6_z * t985);
        let t1001 = t220 * t988 + t223 * t985 - z2_4_y * t991;
        let t1006 = c4 * t991 + (t224 * t988 - z3_5_y * t985);
        let t1010 = dq1.sign();
        let t1011 = dq2.sign();
        let t1012 = dq3.sign();
        let t1013 = dq4.sign();
        let t1014 = dq5.sign();
        let t1015 = dq6.sign();
        let t1016 = dq7.sign();
        let t1017 = -t300;
        let t1018 = -a2_x;
        let t1019 = -t9;
        let t1020 = -t42;
        let t1021 = -t307;
        let t1022 = -t79;
        let t1023 = -t493;
        let t1024 = -t893;
        let t1025 = -t952;
        let t1026 = -(s5 * t988 + c5 * t985);
        let t1027 = -t554;
        let t1028 = -t158;
        let t1029 = -t758;
        put(12, t1017); // row 1, YZ3
        put(40, t996); // row 1, YZ7
        put(42, t1010); // row 1, FC1
        put(44, t1018); // row 2, MSY2R
        put(45, t1019); // row 2, XX2R
        put(84, t1001); // row 2, YZ7
        put(86, t1011); // row 2, FC2
        put(93, t1020); // row 3, YZ3
        put(95, t1021); // row 3, MSY4R
        put(121, t1006); // row 3, YZ7
        put(123, t1012); // row 3, FC3
        put(129, t1022); // row 4, XZ4
        put(134, t1023); // row 4, ZZ5R
        put(147, t1024); // row 4, XX7R
        put(149, t1025); // row 4, XY7
        put(151, t1026); // row 4, YZ7
        put(153, t1013); // row 4, FC4
        put(162, t1027); // row 5, MSY6R
        put(174, t991); // row 5, YZ7
        put(176, t1014); // row 5, FC5
        put(179, t1028); // row 6, XX6R
        put(185, t1029); // row 6, MSY7
        put(190, t985); // row 6, YZ7
        put(192, t1015); // row 6, FC6
        put(201, t1016); // row 7, FC7
    }
}
