//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4.
//!
//! 625 multiplications, 465 additions; 7 x 64, 209 of 448 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 209;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11),
    (0, 12), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18), (0, 19), (0, 20), (0, 21),
    (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28), (0, 29), (0, 30), (0, 31),
    (0, 32), (0, 33), (0, 34), (0, 35), (0, 36), (0, 37), (0, 38), (0, 39), (0, 40), (0, 41),
    (0, 42), (0, 43), (0, 50), (0, 57), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6),
    (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (1, 12), (1, 13), (1, 14), (1, 15), (1, 16),
    (1, 17), (1, 18), (1, 19), (1, 20), (1, 21), (1, 22), (1, 23), (1, 24), (1, 25), (1, 26),
    (1, 27), (1, 28), (1, 29), (1, 30), (1, 31), (1, 32), (1, 33), (1, 34), (1, 35), (1, 36),
    (1, 37), (1, 38), (1, 39), (1, 40), (1, 41), (1, 42), (1, 44), (1, 51), (1, 58), (2, 8),
    (2, 9), (2, 10), (2, 11), (2, 12), (2, 13), (2, 14), (2, 15), (2, 16), (2, 17), (2, 18),
    (2, 19), (2, 20), (2, 21), (2, 22), (2, 23), (2, 24), (2, 25), (2, 26), (2, 27), (2, 28),
    (2, 29), (2, 30), (2, 31), (2, 32), (2, 33), (2, 34), (2, 35), (2, 36), (2, 37), (2, 38),
    (2, 39), (2, 40), (2, 41), (2, 42), (2, 45), (2, 52), (2, 59), (3, 15), (3, 16), (3, 17),
    (3, 18), (3, 19), (3, 20), (3, 21), (3, 22), (3, 23), (3, 24), (3, 25), (3, 26), (3, 27),
    (3, 28), (3, 29), (3, 30), (3, 31), (3, 32), (3, 33), (3, 34), (3, 35), (3, 36), (3, 37),
    (3, 38), (3, 39), (3, 40), (3, 41), (3, 42), (3, 46), (3, 53), (3, 60), (4, 22), (4, 23),
    (4, 24), (4, 25), (4, 26), (4, 27), (4, 28), (4, 29), (4, 30), (4, 31), (4, 32), (4, 33),
    (4, 34), (4, 35), (4, 36), (4, 37), (4, 38), (4, 39), (4, 40), (4, 41), (4, 42), (4, 47),
    (4, 54), (4, 61), (5, 29), (5, 30), (5, 31), (5, 32), (5, 33), (5, 34), (5, 35), (5, 36),
    (5, 37), (5, 38), (5, 39), (5, 40), (5, 41), (5, 42), (5, 48), (5, 55), (5, 62), (6, 36),
    (6, 37), (6, 38), (6, 39), (6, 40), (6, 41), (6, 42), (6, 49), (6, 56), (6, 63),
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
    let A = S::constant(0.0825);
    let L2 = S::constant(0.316);
    let L3 = S::constant(0.384);
    let k0 = S::constant(9.81);
    let k4 = S::constant(0.088);
    let k5 = S::constant(1.0);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        put(0, ddq1); // row 1, ZZ1R
        put(41, dq1); // row 1, FV1
        put(43, k5); // row 1, FO1
        put(47, ddq2); // row 2, ZZ2R
        put(86, dq2); // row 2, FV2
        put(88, k5); // row 2, FO2
        put(124, dq3); // row 3, FV3
        put(126, k5); // row 3, FO3
        put(155, dq4); // row 4, FV4
        put(157, k5); // row 4, FO4
        put(179, dq5); // row 5, FV5
        put(181, k5); // row 5, FO5
        put(196, dq6); // row 6, FV6
        put(198, k5); // row 6, FO6
        put(206, dq7); // row 7, FV7
        put(208, k5); // row 7, FO7
        t0
    };
    // link 2: motion
    let [
        t1, t2, t3, t4, t5, t6, t9, t10,
        t11, t12, t13, t14, t15, t16, t17, t18,
        t19, t20,
    ] = {
        let t1 = s2 * dq1;
        let t2 = c2 * dq1;
        let t3 = s2 * ddq1;
        let t4 = c2 * ddq1;
        let t5 = s2 * k0;
        let t6 = c2 * k0;
        let t7 = t1 * t1;
        let t8 = dq2 * dq2;
        let t9 = t1 * t2;
        let t10 = dq2 * t1;
        let t11 = dq2 * t2;
        let t12 = t3 + t11;
        let t13 = t4 - t10;
        let t14 = t7 - t8;
        let t15 = t14 - t0;
        let t16 = ddq2 - t9;
        let t17 = ddq2 + t9;
        let t18 = t7 + t8;
        let t19 = t10 - t13;
        let t20 = t11 + t12;
        put(45, t5); // row 2, MSY2R
        [
        t1, t2, t3, t4, t5, t6, t9, t10,
        t11, t12, t13, t14, t15, t16, t17, t18,
        t19, t20,
    ]
    };
    // link 3: motion
    let [
        t23, w3_y, t31, t34, a3_y, t40, t43, w3_z,
        dw3_z, t48, t49, t50, dw3_x, dw3_y, t53, t54,
        t55, t56, t57, t58, t59,
    ] = {
        let t23 = c3 * t1 - s3 * dq2;
        let w3_y = c3 * dq2 + s3 * t1;
        let t29 = L2 * t20;
        let t30 = t5 - L2 * t16;
        let t31 = t6 - L2 * t18;
        let t34 = c3 * t30 - s3 * t29;
        let a3_y = c3 * t29 + s3 * t30;
        let t40 = c3 * t16 + s3 * t20;
        let t43 = s3 * t16 - c3 * t20;
        let w3_z = t2 + dq3;
        let dw3_z = t13 + ddq3;
        let t46 = t23 * t23;
        let t47 = w3_z * w3_z;
        let t48 = t23 * w3_y;
        let t49 = t23 * w3_z;
        let t50 = w3_y * w3_z;
        let dw3_x = t43 + t50;
        let dw3_y = t40 + t49;
        let t53 = t47 - t46;
        let t54 = t18 + t53;
        let t55 = dw3_z + t48;
        let t56 = t48 - dw3_z;
        let t57 = t46 + t47;
        let t58 = t49 + dw3_y;
        let t59 = t50 + dw3_x;
        put(89, a3_y); // row 3, MSX3R
        put(90, t34); // row 3, MSY3R
        put(91, t48); // row 3, XX3R
        put(92, dw3_z); // row 3, ZZ3R
        put(94, t43); // row 3, XZ3
        put(95, t40); // row 3, YZ3
        [
        t23, w3_y, t31, t34, a3_y, t40, t43, w3_z,
        dw3_z, t48, t49, t50, dw3_x, dw3_y, t53, t54,
        t55, t56, t57, t58, t59,
    ]
    };
    // link 4: motion
    let [
        t62, w4_y, t70, t74, a4_y, t80, t83, w4_z,
        dw4_z, t88, t89, t90, dw4_x, t92, t93, t94,
        t95, t96, t97, t98, t99,
    ] = {
        let t62 = c4 * t23 - s4 * w3_z;
        let w4_y = c4 * w3_z + s4 * t23;
        let t69 = t34 + A * t54;
        let t70 = A * t56 - a3_y;
        let t71 = A * t58 - t31;
        let t74 = c4 * t69 + s4 * t71;
        let a4_y = s4 * t69 - c4 * t71;
        let t80 = c4 * t55 - s4 * t59;
        let t83 = c4 * t59 + s4 * t55;
        let w4_z = dq4 - w3_y;
        let dw4_z = ddq4 - dw3_y;
        let t86 = t62 * t62;
        let t87 = w4_z * w4_z;
        let t88 = t62 * w4_y;
        let t89 = t62 * w4_z;
        let t90 = w4_y * w4_z;
        let dw4_x = t83 + t90;
        let t92 = t80 + t89;
        let t93 = t86 - t87;
        let t94 = t57 - t93;
        let t95 = dw4_z + t88;
        let t96 = dw4_z - t88;
        let t97 = t86 + t87;
        let t98 = t89 + t92;
        let t99 = t90 + dw4_x;
        put(127, a4_y); // row 4, MSX4R
        put(128, t74); // row 4, MSY4R
        put(129, t88); // row 4, XX4R
        put(130, dw4_z); // row 4, ZZ4R
        put(132, t83); // row 4, XZ4
        put(133, t80); // row 4, YZ4
        [
        t62, w4_y, t70, t74, a4_y, t80, t83, w4_z,
        dw4_z, t88, t89, t90, dw4_x, t92, t93, t94,
        t95, t96, t97, t98, t99,
    ]
    };
    // link 5: motion
    let [
        t102, t105, t108, a5_z, t120, a5_y, t126, t129,
        w5_z, dw5_z, t134, t135, t136, dw5_x, t138, t139,
        t140, t141, t142, t143, t144, t145,
    ] = {
        let t102 = c5 * t62 + s5 * w4_z;
        let t105 = c5 * w4_z - s5 * t62;
        let t108 = A * t98;
        let t115 = t74 + (L3 * t95 - A * t94);
        let a5_z = a4_y - (A * t96 + L3 * t97);
        let t117 = t70 + (t108 + L3 * t99);
        let t120 = c5 * t115 + s5 * t117;
        let a5_y = s5 * t115 - c5 * t117;
        let t126 = c5 * t95 + s5 * t99;
        let t129 = c5 * t99 - s5 * t95;
        let w5_z = w4_y + dq5;
        let dw5_z = t92 + ddq5;
        let t132 = t102 * t102;
        let t133 = w5_z * w5_z;
        let t134 = t102 * t105;
        let t135 = t102 * w5_z;
        let t136 = t105 * w5_z;
        let dw5_x = t129 - t136;
        let t138 = t126 - t135;
        let t139 = t132 - t133;
        let t140 = t139 - t97;
        let t141 = dw5_z - t134;
        let t142 = dw5_z + t134;
        let t143 = t132 + t133;
        let t144 = t135 - t138;
        let t145 = t136 - dw5_x;
        put(158, a5_y); // row 5, MSX5
        put(159, t120); // row 5, MSY5R
        put(161, dw5_z); // row 5, ZZ5R
        put(163, t129); // row 5, XZ5
        [
        t102, t105, t108, a5_z, t120, a5_y, t126, t129,
        w5_z, dw5_z, t134, t135, t136, dw5_x, t138, t139,
        t140, t141, t142, t143, t144, t145,
    ]
    };
    // link 6: motion
    let [
        t148, w6_y, t154, a6_y, t160, t163, w6_z, dw6_z,
        t168, t169, t170, dw6_x, dw6_y, t173, t174, t175,
        t176, t177, t178, t179,
    ] = {
        let t148 = c6 * t102 - s6 * w5_z;
        let w6_y = c6 * w5_z + s6 * t102;
        let t154 = c6 * t120 - s6 * a5_z;
        let a6_y = c6 * a5_z + s6 * t120;
        let t160 = c6 * t141 + s6 * t145;
        let t163 = s6 * t141 - c6 * t145;
        let w6_z = t105 + dq6;
        let dw6_z = t138 + ddq6;
        let t166 = t148 * t148;
        let t167 = w6_z * w6_z;
        let t168 = t148 * w6_y;
        let t169 = t148 * w6_z;
        let t170 = w6_y * w6_z;
        let dw6_x = t163 + t170;
        let dw6_y = t160 + t169;
        let t173 = t167 - t166;
        let t174 = t143 + t173;
        let t175 = dw6_z + t168;
        let t176 = t168 - dw6_z;
        let t177 = t166 + t167;
        let t178 = t169 + dw6_y;
        let t179 = t170 + dw6_x;
        put(182, a6_y); // row 6, MSX6R
        put(183, t154); // row 6, MSY6R
        put(184, t168); // row 6, XX6R
        put(185, dw6_z); // row 6, ZZ6R
        put(187, t163); // row 6, XZ6
        put(188, t160); // row 6, YZ6
        [
        t148, w6_y, t154, a6_y, t160, t163, w6_z, dw6_z,
        t168, t169, t170, dw6_x, dw6_y, t173, t174, t175,
        t176, t177, t178, t179,
    ]
    };
    // link 7: motion
    let [
        t190, t194, a7_y, t200, t203, dw7_z, t208, t209,
        t210, dw7_x, t213, t214, t215, t216, t217, t218,
        t219,
    ] = {
        let t182 = c7 * t148 - s7 * w6_z;
        let w7_y = c7 * w6_z + s7 * t148;
        let t189 = t154 + k4 * t174;
        let t190 = k4 * t176 - a6_y;
        let t191 = a5_y + k4 * t178;
        let t194 = c7 * t189 + s7 * t191;
        let a7_y = s7 * t189 - c7 * t191;
        let t200 = c7 * t175 - s7 * t179;
        let t203 = c7 * t179 + s7 * t175;
        let w7_z = dq7 - w6_y;
        let dw7_z = ddq7 - dw6_y;
        let t206 = t182 * t182;
        let t207 = w7_z * w7_z;
        let t208 = t182 * w7_y;
        let t209 = t182 * w7_z;
        let t210 = w7_y * w7_z;
        let dw7_x = t203 + t210;
        let t213 = t207 - t206;
        let t214 = t177 + t213;
        let t215 = dw7_z + t208;
        let t216 = dw7_z - t208;
        let t217 = t206 + t207;
        let t218 = t209 + (t200 + t209);
        let t219 = t210 + dw7_x;
        put(199, a7_y); // row 7, MSX7
        put(200, t194); // row 7, MSY7
        put(201, t208); // row 7, XX7R
        put(202, dw7_z); // row 7, ZZ7
        put(204, t203); // row 7, XZ7
        put(205, t200); // row 7, YZ7
        [
        t190, t194, a7_y, t200, t203, dw7_z, t208, t209,
        t210, dw7_x, t213, t214, t215, t216, t217, t218,
        t219,
    ]
    };
    // joint axes in frame 3
    let [t220, z1_3_y] = {
        let t220 = s2 * c3;
        let z1_3_y = s2 * s3;
        [t220, z1_3_y]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, z2_4_x, t229] = {
        let z1_4_x = c2 * s4 - c4 * t220;
        let z1_4_y = c2 * c4 + s4 * t220;
        let z2_4_x = s3 * c4;
        let t229 = s3 * s4;
        [z1_4_x, z1_4_y, z2_4_x, t229]
    };
    // joint axes in frame 5
    let [z1_5_x, t235, z2_5_x, t241, t242, z3_5_x, z3_6_z] = {
        let z1_5_x = c5 * z1_4_x + s5 * z1_3_y;
        let t235 = s5 * z1_4_x - c5 * z1_3_y;
        let z2_5_x = c5 * z2_4_x + c3 * s5;
        let t241 = s5 * z2_4_x - c3 * c5;
        let t242 = c4 * A;
        let z3_5_x = s4 * c5;
        let z3_6_z = s4 * s5;
        [z1_5_x, t235, z2_5_x, t241, t242, z3_5_x, z3_6_z]
    };
    // XX2: column
    let t246 = {
        let t246 = c2 * t10;
        let t247 = s2 * t12 + t246;
        put(1, t247); // row 1, XX2R
        t246
    };
    // ZZ2: column
    {
        let t249 = s2 * t11 - t246;
        put(2, t249); // row 1, ZZ2R
    }
    // XY2: column
    {
        let t250 = t15 + t18;
        let t253 = c2 * t20 - s2 * t19;
        put(3, t253); // row 1, XY2
        put(48, t250); // row 2, XY2
    }
    // XZ2: column
    {
        let t256 = c2 * t14 - s2 * t17;
        put(4, t256); // row 1, XZ2
    }
    // YZ2: column
    {
        let t260 = s2 * (t18 - t0) - c2 * t16;
        put(5, t260); // row 1, YZ2
    }
    // MSX3: column
    let t272 = {
        let t261 = L2 * t56;
        let t263 = t31 + L2 * t54;
        let t268 = c2 * a3_y - (t220 * t261 + z1_3_y * t263);
        let t271 = s3 * t261 - c3 * t263;
        let t272 = s3 * t56;
        put(6, t268); // row 1, MSX3R
        put(51, t271); // row 2, MSX3R
        t272
    };
    // MSY3: column
    let t284 = {
        let t274 = L2 * t55;
        let t275 = t31 + L2 * t57;
        let t280 = c2 * t34 - (t220 * t275 + z1_3_y * t274);
        let t283 = s3 * t275 - c3 * t274;
        let t284 = c3 * t55;
        put(7, t280); // row 1, MSY3R
        put(52, t283); // row 2, MSY3R
        t284
    };
    // XX3: column
    let [t286, t291] = {
        let t286 = t49 * z1_3_y;
        let t289 = c2 * t48 - (dw3_x * t220 + t286);
        let t291 = c3 * t49;
        let t292 = s3 * dw3_x - t291;
        put(8, t289); // row 1, XX3R
        put(53, t292); // row 2, XX3R
        [t286, t291]
    };
    // ZZ3: column
    {
        let t296 = c2 * dw3_z + (t286 - t50 * t220);
        let t298 = t291 + s3 * t50;
        put(9, t296); // row 1, ZZ3R
        put(54, t298); // row 2, ZZ3R
    }
    // XY3: column
    {
        let t299 = t57 - t54;
        let t304 = c2 * t299 + (t59 * z1_3_y - t58 * t220);
        let t307 = s3 * t58 + c3 * t59;
        put(10, t304); // row 1, XY3R
        put(55, t307); // row 2, XY3R
        put(93, t299); // row 3, XY3R
    }
    // XZ3: column
    {
        let t312 = c2 * t43 + (t56 * t220 + t53 * z1_3_y);
        let t314 = c3 * t53 - t272;
        put(11, t312); // row 1, XZ3
        put(56, t314); // row 2, XZ3
    }
    // YZ3: column
    {
        let t315 = t57 - t18;
        let t320 = c2 * t40 + (t220 * t315 + t55 * z1_3_y);
        let t322 = t284 - s3 * t315;
        put(12, t320); // row 1, YZ3
        put(57, t322); // row 2, YZ3
    }
    // MSX4: column
    let [t324, t327] = {
        let t324 = t242 + L2 * s4;
        let t327 = s4 * A - L2 * c4;
        let t328 = t98 * t327;
        let t333 = t70 - t98 * t324;
        let t334 = t94 * t327 - t96 * t324 - a4_y;
        let t339 = z1_3_y * t334 + (z1_4_x * t328 - z1_4_y * t333);
        let t344 = c3 * t334 + (z2_4_x * t328 + t229 * t333);
        let t346 = t108 - c4 * t70;
        put(13, t339); // row 1, MSX4R
        put(58, t344); // row 2, MSX4R
        put(96, t346); // row 3, MSX4R
        [t324, t327]
    };
    // MSY4: column
    {
        let t348 = t99 * t324;
        let t352 = t70 - t99 * t327;
        let t353 = t97 * t324 + t95 * t327 - t74;
        let t358 = z1_3_y * t353 + (z1_4_x * t352 - z1_4_y * t348);
        let t363 = c3 * t353 + (z2_4_x * t352 + t229 * t348);
        let t366 = s4 * t70 - A * t99;
        put(14, t358); // row 1, MSY4R
        put(59, t363); // row 2, MSY4R
        put(97, t366); // row 3, MSY4R
    }
    // XX4: column
    let [t368, t373, t378] = {
        let t368 = t89 * z1_4_y;
        let t371 = dw4_x * z1_4_x - t368 - t88 * z1_3_y;
        let t373 = t89 * t229;
        let t376 = dw4_x * z2_4_x + t373 - c3 * t88;
        let t378 = c4 * t89;
        let t379 = s4 * dw4_x - t378;
        put(15, t371); // row 1, XX4R
        put(60, t376); // row 2, XX4R
        put(98, t379); // row 3, XX4R
        [t368, t373, t378]
    };
    // ZZ4: column
    {
        let t383 = t368 + t90 * z1_4_x - dw4_z * z1_3_y;
        let t387 = t90 * z2_4_x - t373 - c3 * dw4_z;
        let t389 = t378 + s4 * t90;
        put(16, t383); // row 1, ZZ4R
        put(61, t387); // row 2, ZZ4R
        put(99, t389); // row 3, ZZ4R
    }
    // XY4: column
    {
        let t390 = t97 - t94;
        let t395 = t98 * z1_4_x + t99 * z1_4_y - z1_3_y * t390;
        let t400 = t98 * z2_4_x - t99 * t229 - c3 * t390;
        let t403 = s4 * t98 + c4 * t99;
        put(17, t395); // row 1, XY4R
        put(62, t400); // row 2, XY4R
        put(100, t403); // row 3, XY4R
        put(131, t390); // row 4, XY4R
    }
    // XZ4: column
    {
        let t408 = t96 * z1_4_x - t93 * z1_4_y - t83 * z1_3_y;
        let t413 = t96 * z2_4_x + t93 * t229 - c3 * t83;
        let t416 = s4 * t96 - c4 * t93;
        put(18, t408); // row 1, XZ4
        put(63, t413); // row 2, XZ4
        put(101, t416); // row 3, XZ4
    }
    // YZ4: column
    {
        let t417 = t57 - t97;
        let t422 = z1_4_x * t417 + t95 * z1_4_y - t80 * z1_3_y;
        let t427 = z2_4_x * t417 - t95 * t229 - c3 * t80;
        let t430 = s4 * t417 + c4 * t95;
        put(19, t422); // row 1, YZ4
        put(64, t427); // row 2, YZ4
        put(102, t430); // row 3, YZ4
    }
    // MSX5: column
    let [t432, t437, t438] = {
        let t432 = s5 * t142;
        let t433 = c5 * t140 - t432;
        let t436 = s5 * t140 + c5 * t142;
        let t437 = s5 * a5_z;
        let t438 = c5 * a5_z;
        let t443 = A * t436;
        let t444 = t437 - L3 * t436;
        let t445 = t438 + (A * t144 - L3 * t433);
        let t446 = t443 - a5_y;
        let t452 = t444 + t327 * t436;
        let t453 = t324 * t436 - t446;
        let t454 = t144 * t324 - t327 * t433 - t445;
        let t459 = z1_3_y * t454 + (z1_4_x * t452 + z1_4_y * t453);
        let t464 = c3 * t454 - (t229 * t453 - z2_4_x * t452);
        let t468 = t443 - (c4 * t446 - s4 * t444);
        put(20, t459); // row 1, MSX5
        put(65, t464); // row 2, MSX5
        put(103, t468); // row 3, MSX5
        put(134, t445); // row 4, MSX5
        [t432, t437, t438]
    };
    // MSY5: column
    let t469 = {
        let t469 = c5 * t141;
        let t471 = s5 * t143 - t469;
        let t474 = s5 * t141 + c5 * t143;
        let t479 = A * t474;
        let t480 = t438 + L3 * t474;
        let t481 = A * t145 - L3 * t471 - t437;
        let t482 = t120 + t479;
        let t488 = t480 - t327 * t474;
        let t489 = t324 * t474 - t482;
        let t490 = t145 * t324 - t327 * t471 - t481;
        let t495 = z1_3_y * t490 - (z1_4_y * t489 - z1_4_x * t488);
        let t500 = c3 * t490 + (z2_4_x * t488 + t229 * t489);
        let t504 = s4 * t480 + c4 * t482 - t479;
        put(21, t495); // row 1, MSY5R
        put(66, t500); // row 2, MSY5R
        put(104, t504); // row 3, MSY5R
        put(135, t481); // row 4, MSY5R
        t469
    };
    // XX5: column
    let [t506, t511, t516, t521] = {
        let t506 = t135 * t235;
        let t509 = dw5_x * z1_5_x + t506 - t134 * z1_4_y;
        let t511 = t135 * t241;
        let t514 = t134 * t229 + (dw5_x * z2_5_x + t511);
        let t516 = t135 * z3_6_z;
        let t519 = dw5_x * z3_5_x + t516 - c4 * t134;
        let t521 = c5 * t135;
        let t522 = t521 - s5 * dw5_x;
        put(22, t509); // row 1, XX5R
        put(67, t514); // row 2, XX5R
        put(105, t519); // row 3, XX5R
        put(136, t522); // row 4, XX5R
        [t506, t511, t516, t521]
    };
    // ZZ5: column
    let t530 = {
        let t526 = dw5_z * z1_4_y - (t506 + t136 * z1_5_x);
        let t530 = dw5_z * t229 + (t511 + t136 * z2_5_x);
        let t534 = c4 * dw5_z - (t516 + t136 * z3_5_x);
        let t536 = s5 * t136 - t521;
        put(23, t526); // row 1, ZZ5R
        put(106, t534); // row 3, ZZ5R
        put(137, t536); // row 4, ZZ5R
        t530
    };
    // XY5: column
    {
        let t537 = t140 + t143;
        let t542 = z1_4_y * t537 + (t144 * z1_5_x + t145 * t235);
        let t547 = t144 * z2_5_x + t145 * t241 - t229 * t537;
        let t552 = c4 * t537 + (t144 * z3_5_x + t145 * z3_6_z);
        let t555 = c5 * t145 - s5 * t144;
        put(24, t542); // row 1, XY5
        put(69, t547); // row 2, XY5
        put(107, t552); // row 3, XY5
        put(138, t555); // row 4, XY5
        put(162, t537); // row 5, XY5
    }
    // XZ5: column
    {
        let t560 = t129 * z1_4_y + (t142 * z1_5_x + t139 * t235);
        let t565 = t142 * z2_5_x + t139 * t241 - t129 * t229;
        let t570 = c4 * t129 + (t142 * z3_5_x + t139 * z3_6_z);
        let t572 = c5 * t139 - t432;
        put(25, t560); // row 1, XZ5
        put(70, t565); // row 2, XZ5
        put(108, t570); // row 3, XZ5
        put(139, t572); // row 4, XZ5
    }
    // YZ5: column
    let t590 = {
        let t573 = t97 - t143;
        let t578 = z1_5_x * t573 - t141 * t235 - t126 * z1_4_y;
        let t583 = t126 * t229 - (t141 * t241 - z2_5_x * t573);
        let t588 = z3_5_x * t573 - t141 * z3_6_z - c4 * t126;
        let t590 = t469 + s5 * t573;
        put(26, t578); // row 1, YZ5
        put(71, t583); // row 2, YZ5
        put(109, t588); // row 3, YZ5
        t590
    };
    // MSX6: column
    let [t592, t595, t597, t598] = {
        let t592 = s6 * t176;
        let t593 = c6 * t174 - t592;
        let t595 = c6 * t176;
        let t596 = s6 * t174 + t595;
        let t597 = s6 * a5_y;
        let t598 = c6 * a5_y;
        let t601 = c5 * t593 + s5 * t178;
        let t604 = c5 * t178 - s5 * t593;
        let t615 = A * t604;
        let t616 = c5 * t597 - s5 * a6_y + L3 * t604;
        let t617 = s5 * t597 + c5 * a6_y + (L3 * t601 + A * t596);
        let t618 = t615 - t598;
        let t624 = t327 * t604 - t616;
        let t625 = t618 - t324 * t604;
        let t626 = t324 * t596 + t327 * t601 - t617;
        let t631 = z1_3_y * t626 + (z1_4_x * t624 - z1_4_y * t625);
        let t636 = c3 * t626 + (z2_4_x * t624 + t229 * t625);
        let t640 = t615 - (s4 * t616 + c4 * t618);
        put(27, t631); // row 1, MSX6R
        put(72, t636); // row 2, MSX6R
        put(110, t640); // row 3, MSX6R
        put(141, t617); // row 4, MSX6R
        put(165, t598); // row 5, MSX6R
        [t592, t595, t597, t598]
    };
    // MSY6: column
    let [t641, t644] = {
        let t641 = c6 * t175;
        let t643 = t641 - s6 * t177;
        let t644 = s6 * t175;
        let t646 = t644 + c6 * t177;
        let t649 = s5 * t179 - c5 * t643;
        let t652 = s5 * t643 + c5 * t179;
        let t663 = A * t652;
        let t664 = s5 * t154 - c5 * t598 + L3 * t652;
        let t665 = s5 * t598 + c5 * t154 + (A * t646 - L3 * t649);
        let t666 = t663 - t597;
        let t672 = t664 - t327 * t652;
        let t673 = t666 - t324 * t652;
        let t674 = t665 + (t327 * t649 - t324 * t646);
        let t679 = z1_4_x * t672 + z1_4_y * t673 - z1_3_y * t674;
        let t684 = z2_4_x * t672 - t229 * t673 - c3 * t674;
        let t688 = s4 * t664 + c4 * t666 - t663;
        put(28, t679); // row 1, MSY6R
        put(73, t684); // row 2, MSY6R
        put(111, t688); // row 3, MSY6R
        put(142, t665); // row 4, MSY6R
        [t641, t644]
    };
    // XX6: column
    let [t690, t693] = {
        let t690 = s6 * t169;
        let t691 = c6 * dw6_x + t690;
        let t693 = c6 * t169;
        let t694 = s6 * dw6_x - t693;
        let t699 = z1_4_y * t694 + (z1_5_x * t691 + t168 * t235);
        let t704 = z2_5_x * t691 + t168 * t241 - t229 * t694;
        let t709 = c4 * t694 + (z3_5_x * t691 + t168 * z3_6_z);
        let t712 = c5 * t168 - s5 * t691;
        put(29, t699); // row 1, XX6R
        put(74, t704); // row 2, XX6R
        put(112, t709); // row 3, XX6R
        put(143, t712); // row 4, XX6R
        put(167, t694); // row 5, XX6R
        [t690, t693]
    };
    // ZZ6: column
    {
        let t714 = c6 * t170 - t690;
        let t716 = t693 + s6 * t170;
        let t721 = z1_4_y * t716 + (z1_5_x * t714 + dw6_z * t235);
        let t726 = z2_5_x * t714 + dw6_z * t241 - t229 * t716;
        let t731 = c4 * t716 + (z3_5_x * t714 + dw6_z * z3_6_z);
        let t734 = c5 * dw6_z - s5 * t714;
        put(30, t721); // row 1, ZZ6R
        put(75, t726); // row 2, ZZ6R
        put(113, t731); // row 3, ZZ6R
        put(144, t734); // row 4, ZZ6R
        put(168, t716); // row 5, ZZ6R
    }
    // XY6: column
    {
        let t735 = t177 - t174;
        let t738 = c6 * t178 - s6 * t179;
        let t741 = s6 * t178 + c6 * t179;
        let t746 = z1_4_y * t741 + (z1_5_x * t738 + t235 * t735);
        let t751 = z2_5_x * t738 + t241 * t735 - t229 * t741;
        let t756 = c4 * t741 + (z3_5_x * t738 + z3_6_z * t735);
        let t759 = c5 * t735 - s5 * t738;
        put(31, t746); // row 1, XY6R
        put(76, t751); // row 2, XY6R
        put(114, t756); // row 3, XY6R
        put(145, t759); // row 4, XY6R
        put(169, t741); // row 5, XY6R
        put(186, t735); // row 6, XY6R
    }
    // XZ6: column
    {
        let t761 = t595 + s6 * t173;
        let t763 = c6 * t173 - t592;
        let t768 = z1_4_y * t763 + (t163 * t235 - z1_5_x * t761);
        let t773 = t163 * t241 - z2_5_x * t761 - t229 * t763;
        let t778 = c4 * t763 - (z3_5_x * t761 - t163 * z3_6_z);
        let t781 = s5 * t761 + c5 * t163;
        put(32, t768); // row 1, XZ6
        put(77, t773); // row 2, XZ6
        put(115, t778); // row 3, XZ6
        put(146, t781); // row 4, XZ6
        put(170, t763); // row 5, XZ6
    }
    // YZ6: column
    {
        let t782 = t177 - t143;
        let t784 = t644 + c6 * t782;
        let t786 = t641 - s6 * t782;
        let t791 = z1_4_y * t786 + (t160 * t235 - z1_5_x * t784);
        let t796 = t160 * t241 - z2_5_x * t784 - t229 * t786;
        let t801 = c4 * t786 + (t160 * z3_6_z - z3_5_x * t784);
        let t804 = s5 * t784 + c5 * t160;
        put(33, t791); // row 1, YZ6
        put(78, t796); // row 2, YZ6
        put(116, t801); // row 3, YZ6
        put(147, t804); // row 4, YZ6
        put(171, t786); // row 5, YZ6
    }
    // MSX7: column
    let [t806, t809, t811, t812] = {
        let t806 = s7 * t216;
        let t807 = c7 * t214 + t806;
        let t809 = c7 * t216;
        let t810 = s7 * t214 - t809;
        let t811 = s7 * t190;
        let t812 = c7 * t190;
        let t815 = k4 * t218 - t812;
        let t816 = k4 * t810 - a7_y;
        let t819 = c6 * t807 + s6 * t218;
        let t822 = c6 * t218 - s6 * t807;
        let t825 = c6 * t811 - s6 * t816;
        let t828 = s6 * t811 + c6 * t816;
        let t831 = c5 * t819 + s5 * t810;
        let t834 = s5 * t819 - c5 * t810;
        let t845 = A * t834;
        let t846 = c5 * t825 + s5 * t815 + L3 * t834;
        let t847 = c5 * t815 - s5 * t825 - (A * t822 - L3 * t831);
        let t848 = t828 + t845;
        let t854 = t846 - t327 * t834;
        let t855 = t848 - t324 * t834;
        let t856 = t327 * t831 - t324 * t822 - t847;
        let t861 = z1_3_y * t856 + (z1_4_x * t854 + z1_4_y * t855);
        let t866 = c3 * t856 + (z2_4_x * t854 - t229 * t855);
        let t870 = s4 * t846 + c4 * t848 - t845;
        put(34, t861); // row 1, MSX7
        put(79, t866); // row 2, MSX7
        put(117, t870); // row 3, MSX7
        put(148, t847); // row 4, MSX7
        put(172, t828); // row 5, MSX7
        put(189, t815); // row 6, MSX7
        [t806, t809, t811, t812]
    };
    // MSY7: column
    let [t871, t874] = {
        let t871 = c7 * t215;
        let t873 = t871 - s7 * t217;
        let t874 = s7 * t215;
        let t876 = t874 + c7 * t217;
        let t879 = t811 - k4 * t219;
        let t880 = k4 * t876 - t194;
        let t883 = c6 * t873 - s6 * t219;
        let t886 = s6 * t873 + c6 * t219;
        let t889 = c6 * t812 - s6 * t880;
        let t892 = s6 * t812 + c6 * t880;
        let t895 = c5 * t883 + s5 * t876;
        let t898 = c5 * t876 - s5 * t883;
        let t909 = A * t898;
        let t910 = c5 * t889 + s5 * t879 - L3 * t898;
        let t911 = c5 * t879 - s5 * t889 + (L3 * t895 + A * t886);
        let t912 = t892 - t909;
        let t918 = t910 + t327 * t898;
        let t919 = t912 + t324 * t898;
        let t920 = t911 - (t324 * t886 + t327 * t895);
        let t925 = z1_4_x * t918 + z1_4_y * t919 - z1_3_y * t920;
        let t930 = z2_4_x * t918 - t229 * t919 - c3 * t920;
        let t934 = t909 + (s4 * t910 + c4 * t912);
        put(35, t925); // row 1, MSY7
        put(80, t930); // row 2, MSY7
        put(118, t934); // row 3, MSY7
        put(149, t911); // row 4, MSY7
        put(173, t892); // row 5, MSY7
        put(190, t879); // row 6, MSY7
        [t871, t874]
    };
    // XX7: column
    let [t936, t939] = {
        let t936 = s7 * t209;
        let t937 = c7 * dw7_x + t936;
        let t939 = c7 * t209;
        let t940 = s7 * dw7_x - t939;
        let t943 = c6 * t937 + s6 * t208;
        let t946 = s6 * t937 - c6 * t208;
        let t951 = z1_4_y * t946 + (z1_5_x * t943 + t235 * t940);
        let t956 = z2_5_x * t943 + t241 * t940 - t229 * t946;
        let t961 = c4 * t946 + (z3_5_x * t943 + z3_6_z * t940);
        let t964 = c5 * t940 - s5 * t943;
        put(36, t951); // row 1, XX7R
        put(81, t956); // row 2, XX7R
        put(119, t961); // row 3, XX7R
        put(150, t964); // row 4, XX7R
        put(174, t946); // row 5, XX7R
        put(191, t940); // row 6, XX7R
        [t936, t939]
    };
    // ZZ7: column
    {
        let t966 = c7 * t210 - t936;
        let t968 = t939 + s7 * t210;
        let t971 = c6 * t966 + s6 * dw7_z;
        let t974 = s6 * t966 - c6 * dw7_z;
        let t979 = z1_4_y * t974 + (z1_5_x * t971 + t235 * t968);
        let t984 = z2_5_x * t971 + t241 * t968 - t229 * t974;
        let t989 = c4 * t974 + (z3_5_x * t971 + z3_6_z * t968);
        let t992 = c5 * t968 - s5 * t971;
        put(37, t979); // row 1, ZZ7
        put(82, t984); // row 2, ZZ7
        put(120, t989); // row 3, ZZ7
        put(151, t992); // row 4, ZZ7
        put(175, t974); // row 5, ZZ7
        put(192, t968); // row 6, ZZ7
    }
    // XY7: column
    {
        let t993 = t217 - t214;
        let t996 = c7 * t218 - s7 * t219;
        let t999 = s7 * t218 + c7 * t219;
        let t1002 = c6 * t996 + s6 * t993;
        let t1005 = s6 * t996 - c6 * t993;
        let t1010 = z1_4_y * t1005 + (z1_5_x * t1002 + t235 * t999);
        let t1015 = z2_5_x * t1002 + t241 * t999 - t229 * t1005;
        let t1020 = c4 * t1005 + (z3_5_x * t1002 + z3_6_z * t999);
        let t1023 = c5 * t999 - s5 * t1002;
        put(38, t1010); // row 1, XY7
        put(83, t1015); // row 2, XY7
        put(121, t1020); // row 3, XY7
        put(152, t1023); // row 4, XY7
        put(176, t1005); // row 5, XY7
        put(193, t999); // row 6, XY7
        put(203, t993); // row 7, XY7
    }
    // XZ7: column
    {
        let t1025 = t809 - s7 * t213;
        let t1027 = t806 + c7 * t213;
        let t1030 = c6 * t1025 + s6 * t203;
        let t1033 = s6 * t1025 - c6 * t203;
        let t1038 = z1_4_y * t1033 + (z1_5_x * t1030 + t235 * t1027);
        let t1043 = z2_5_x * t1030 + t241 * t1027 - t229 * t1033;
        let t1048 = c4 * t1033 + (z3_5_x * t1030 + z3_6_z * t1027);
        let t1051 = c5 * t1027 - s5 * t1030;
        put(39, t1038); // row 1, XZ7
        put(84, t1043); // row 2, XZ7
        put(122, t1048); // row 3, XZ7
        put(153, t1051); // row 4, XZ7
        put(177, t1033); // row 5, XZ7
        put(194, t1027); // row 6, XZ7
    }
    // YZ7: column
    {
        let t1052 = t177 - t217;
        let t1054 = c7 * t1052 - t874;
        let t1056 = t871 + s7 * t1052;
        let t1059 = c6 * t1054 + s6 * t200;
        let t1062 = s6 * t1054 - c6 * t200;
        let t1067 = z1_4_y * t1062 + (z1_5_x * t1059 + t235 * t1056);
        let t1072 = z2_5_x * t1059 + t241 * t1056 - t229 * t1062;
        let t1077 = c4 * t1062 + (z3_5_x * t1059 + z3_6_z * t1056);
        let t1080 = c5 * t1056 - s5 * t1059;
        let t1081 = dq1.sign();
        let t1082 = dq2.sign();
        let t1083 = dq3.sign();
        let t1084 = dq4.sign();
        let t1085 = dq5.sign();
        let t1086 = dq6.sign();
        let t1087 = dq7.sign();
        let t1088 = -t6;
        let t1089 = -t9;
        let t1090 = -t3;
        let t1091 = -t4;
        let t1092 = -t530;
        let t1093 = -t590;
        let t1094 = -t134;
        let t1095 = -t126;
        let t1096 = -t597;
        put(40, t1067); // row 1, YZ7
        put(42, t1081); // row 1, FC1
        put(44, t1088); // row 2, MSX2
        put(46, t1089); // row 2, XX2R
        put(49, t1090); // row 2, XZ2
        put(50, t1091); // row 2, YZ2
        put(68, t1092); // row 2, ZZ5R
        put(85, t1072); // row 2, YZ7
        put(87, t1082); // row 2, FC2
        put(123, t1077); // row 3, YZ7
        put(125, t1083); // row 3, FC3
        put(140, t1093); // row 4, YZ5
        put(154, t1080); // row 4, YZ7
        put(156, t1084); // row 4, FC4
        put(160, t1094); // row 5, XX5R
        put(164, t1095); // row 5, YZ5
        put(166, t1096); // row 5, MSY6R
        put(178, t1062); // row 5, YZ7
        put(180, t1085); // row 5, FC5
        put(195, t1056); // row 6, YZ7
        put(197, t1086); // row 6, FC6
        put(207, t1087); // row 7, FC7
    }
}
