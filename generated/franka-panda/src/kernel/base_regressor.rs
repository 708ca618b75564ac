//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4.
//!
//! 625 multiplications, 466 additions; 7 x 64, 209 of 448 structurally nonzero.

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
    let flat = &mut out.as_flattened_mut()[..];
    flat[1..3].fill(S::default());
    flat[44..50].fill(S::default());
    flat[51..57].fill(S::default());
    flat[58..65].fill(S::default());
    flat[107] = S::default();
    flat[109..115].fill(S::default());
    flat[116..122].fill(S::default());
    flat[123..136].fill(S::default());
    flat[171..173].fill(S::default());
    flat[174..180].fill(S::default());
    flat[181..187].fill(S::default());
    flat[188..207].fill(S::default());
    flat[235..238].fill(S::default());
    flat[239..245].fill(S::default());
    flat[246..252].fill(S::default());
    flat[253..278].fill(S::default());
    flat[299..303].fill(S::default());
    flat[304..310].fill(S::default());
    flat[311..317].fill(S::default());
    flat[318..349].fill(S::default());
    flat[363..368].fill(S::default());
    flat[369..375].fill(S::default());
    flat[376..382].fill(S::default());
    flat[383..420].fill(S::default());
    flat[427..433].fill(S::default());
    flat[434..440].fill(S::default());
    flat[441..447].fill(S::default());
    nonzeros(trig, dq, ddq, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 64]; 7]) {
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
        t11, t12, dw2_y, t14, t15, t16, t17, t18,
        t19, t20,
    ] = {
        let t1 = s2 * k0;
        let t2 = c2 * k0;
        let t3 = s2 * dq1;
        let t4 = c2 * dq1;
        let t5 = s2 * ddq1;
        let t6 = c2 * ddq1;
        let t7 = t3 * t3;
        let t8 = dq2 * dq2;
        let t9 = t3 * t4;
        let t10 = dq2 * t3;
        let t11 = dq2 * t4;
        let t12 = t5 + t11;
        let dw2_y = t10 - t6;
        let t14 = t7 - t8;
        let t15 = t14 - t0;
        let t16 = ddq2 - t9;
        let t17 = ddq2 + t9;
        let t18 = t7 + t8;
        let t19 = t10 + dw2_y;
        let t20 = t11 + t12;
        put(45, t1); // row 2, MSY2R
        [
        t1, t2, t3, t4, t5, t6, t9, t10,
        t11, t12, dw2_y, t14, t15, t16, t17, t18,
        t19, t20,
    ]
    };
    // link 3: motion
    let [
        t21, z1_3_y, t27, t30, a3_y, t36, w3_y, t42,
        t45, w3_z, dw3_z, t50, t51, t52, dw3_x, dw3_y,
        t55, t56, t57, t58, t59, t60, t61,
    ] = {
        let t21 = s2 * c3;
        let z1_3_y = s2 * s3;
        let t25 = L2 * t20;
        let t26 = t1 - L2 * t16;
        let t27 = L2 * t18 - t2;
        let t30 = c3 * t26 - s3 * t25;
        let a3_y = c3 * t25 + s3 * t26;
        let t36 = c3 * t3 - s3 * dq2;
        let w3_y = c3 * dq2 + s3 * t3;
        let t42 = c3 * t16 + s3 * t20;
        let t45 = s3 * t16 - c3 * t20;
        let w3_z = t4 + dq3;
        let dw3_z = ddq3 - dw2_y;
        let t48 = t36 * t36;
        let t49 = w3_z * w3_z;
        let t50 = t36 * w3_y;
        let t51 = t36 * w3_z;
        let t52 = w3_y * w3_z;
        let dw3_x = t45 + t52;
        let dw3_y = t42 + t51;
        let t55 = t49 - t48;
        let t56 = t18 + t55;
        let t57 = dw3_z + t50;
        let t58 = t50 - dw3_z;
        let t59 = t48 + t49;
        let t60 = t51 + dw3_y;
        let t61 = t52 + dw3_x;
        put(89, a3_y); // row 3, MSX3R
        put(90, t30); // row 3, MSY3R
        put(91, t50); // row 3, XX3R
        put(92, dw3_z); // row 3, ZZ3R
        put(94, t45); // row 3, XZ3
        put(95, t42); // row 3, YZ3
        [
        t21, z1_3_y, t27, t30, a3_y, t36, w3_y, t42,
        t45, w3_z, dw3_z, t50, t51, t52, dw3_x, dw3_y,
        t55, t56, t57, t58, t59, t60, t61,
    ]
    };
    // link 4: motion
    let [
        t66, t70, a4_y, w4_x, w4_y, t82, t85, w4_z,
        dw4_z, t90, t91, t92, dw4_x, t94, t95, t96,
        t97, t98, t99, t100, t101,
    ] = {
        let t65 = t30 + A * t56;
        let t66 = A * t58 - a3_y;
        let t67 = t27 + A * t60;
        let t70 = c4 * t65 + s4 * t67;
        let a4_y = s4 * t65 - c4 * t67;
        let w4_x = s4 * w3_z - c4 * t36;
        let w4_y = c4 * w3_z + s4 * t36;
        let t82 = c4 * t57 - s4 * t61;
        let t85 = c4 * t61 + s4 * t57;
        let w4_z = dq4 - w3_y;
        let dw4_z = ddq4 - dw3_y;
        let t88 = w4_x * w4_x;
        let t89 = w4_z * w4_z;
        let t90 = w4_x * w4_y;
        let t91 = w4_x * w4_z;
        let t92 = w4_y * w4_z;
        let dw4_x = t85 + t92;
        let t94 = t82 - t91;
        let t95 = t89 - t88;
        let t96 = t59 + t95;
        let t97 = t90 - dw4_z;
        let t98 = dw4_z + t90;
        let t99 = t88 + t89;
        let t100 = t94 - t91;
        let t101 = t92 + dw4_x;
        put(127, a4_y); // row 4, MSX4R
        put(128, t70); // row 4, MSY4R
        put(130, dw4_z); // row 4, ZZ4R
        put(132, t85); // row 4, XZ4
        put(133, t82); // row 4, YZ4
        [
        t66, t70, a4_y, w4_x, w4_y, t82, t85, w4_z,
        dw4_z, t90, t91, t92, dw4_x, t94, t95, t96,
        t97, t98, t99, t100, t101,
    ]
    };
    // link 5: motion
    let [
        t104, a5_z, t116, a5_y, w5_x, t125, t128, t131,
        w5_z, dw5_z, t136, t137, t138, t139, dw5_y, t141,
        t142, t143, t144, t145, t146, t147,
    ] = {
        let t104 = A * t100;
        let t111 = t70 - (A * t96 + L3 * t97);
        let a5_z = a4_y - (A * t98 + L3 * t99);
        let t113 = t66 + (t104 + L3 * t101);
        let t116 = c5 * t111 + s5 * t113;
        let a5_y = s5 * t111 - c5 * t113;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t125 = c5 * w4_z + s5 * w4_x;
        let t128 = c5 * t97 - s5 * t101;
        let t131 = c5 * t101 + s5 * t97;
        let w5_z = w4_y + dq5;
        let dw5_z = t94 + ddq5;
        let t134 = w5_x * w5_x;
        let t135 = w5_z * w5_z;
        let t136 = w5_x * t125;
        let t137 = w5_x * w5_z;
        let t138 = t125 * w5_z;
        let t139 = t138 - t131;
        let dw5_y = t128 - t137;
        let t141 = t134 - t135;
        let t142 = t141 - t99;
        let t143 = dw5_z + t136;
        let t144 = dw5_z - t136;
        let t145 = t134 + t135;
        let t146 = dw5_y - t137;
        let t147 = t138 + t139;
        put(158, a5_y); // row 5, MSX5
        put(159, t116); // row 5, MSY5R
        put(160, t136); // row 5, XX5R
        put(161, dw5_z); // row 5, ZZ5R
        put(163, t131); // row 5, XZ5
        put(164, t128); // row 5, YZ5
        [
        t104, a5_z, t116, a5_y, w5_x, t125, t128, t131,
        w5_z, dw5_z, t136, t137, t138, t139, dw5_y, t141,
        t142, t143, t144, t145, t146, t147,
    ]
    };
    // link 6: motion
    let [
        t150, a6_y, w6_x, t159, t162, t165, w6_z, dw6_z,
        t170, t171, t172, t173, dw6_y, t175, t176, t177,
        t178, t179, t180, t181,
    ] = {
        let t150 = c6 * t116 - s6 * a5_z;
        let a6_y = c6 * a5_z + s6 * t116;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let t159 = s6 * w5_x - c6 * w5_z;
        let t162 = c6 * t143 + s6 * t147;
        let t165 = s6 * t143 - c6 * t147;
        let w6_z = t125 + dq6;
        let dw6_z = ddq6 - dw5_y;
        let t168 = w6_x * w6_x;
        let t169 = w6_z * w6_z;
        let t170 = w6_x * t159;
        let t171 = w6_x * w6_z;
        let t172 = t159 * w6_z;
        let t173 = t172 - t165;
        let dw6_y = t162 - t171;
        let t175 = t169 - t168;
        let t176 = t145 + t175;
        let t177 = dw6_z + t170;
        let t178 = t170 - dw6_z;
        let t179 = t168 + t169;
        let t180 = dw6_y - t171;
        let t181 = t172 + t173;
        put(182, a6_y); // row 6, MSX6R
        put(183, t150); // row 6, MSY6R
        put(184, t170); // row 6, XX6R
        put(185, dw6_z); // row 6, ZZ6R
        put(187, t165); // row 6, XZ6
        put(188, t162); // row 6, YZ6
        [
        t150, a6_y, w6_x, t159, t162, t165, w6_z, dw6_z,
        t170, t171, t172, t173, dw6_y, t175, t176, t177,
        t178, t179, t180, t181,
    ]
    };
    // link 7: motion
    let [
        t186, t190, a7_y, t202, t205, dw7_z, t210, t211,
        t212, dw7_x, t215, t216, t217, t218, t219, t220,
        t221,
    ] = {
        let t185 = t150 + k4 * t176;
        let t186 = k4 * t178 - a6_y;
        let t187 = a5_y + k4 * t180;
        let t190 = c7 * t185 + s7 * t187;
        let a7_y = s7 * t185 - c7 * t187;
        let w7_x = c7 * w6_x + s7 * w6_z;
        let w7_y = c7 * w6_z - s7 * w6_x;
        let t202 = c7 * t177 + s7 * t181;
        let t205 = s7 * t177 - c7 * t181;
        let w7_z = t159 + dq7;
        let dw7_z = ddq7 - dw6_y;
        let t208 = w7_x * w7_x;
        let t209 = w7_z * w7_z;
        let t210 = w7_x * w7_y;
        let t211 = w7_x * w7_z;
        let t212 = w7_y * w7_z;
        let dw7_x = t205 + t212;
        let t215 = t208 - t209;
        let t216 = t179 - t215;
        let t217 = dw7_z - t210;
        let t218 = dw7_z + t210;
        let t219 = t208 + t209;
        let t220 = t202 - t211 - t211;
        let t221 = t212 + dw7_x;
        put(199, a7_y); // row 7, MSX7
        put(200, t190); // row 7, MSY7
        put(202, dw7_z); // row 7, ZZ7
        put(204, t205); // row 7, XZ7
        put(205, t202); // row 7, YZ7
        [
        t186, t190, a7_y, t202, t205, dw7_z, t210, t211,
        t212, dw7_x, t215, t216, t217, t218, t219, t220,
        t221,
    ]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, z2_4_x, t229] = {
        let z1_4_x = c2 * s4 - c4 * t21;
        let z1_4_y = c2 * c4 + s4 * t21;
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
        let t261 = L2 * t58;
        let t263 = t27 - L2 * t56;
        let t268 = c2 * a3_y - (t21 * t261 - z1_3_y * t263);
        let t271 = s3 * t261 + c3 * t263;
        let t272 = s3 * t58;
        put(6, t268); // row 1, MSX3R
        put(51, t271); // row 2, MSX3R
        t272
    };
    // MSY3: column
    let t284 = {
        let t274 = L2 * t57;
        let t275 = L2 * t59 - t27;
        let t280 = c2 * t30 - (t21 * t275 + z1_3_y * t274);
        let t283 = s3 * t275 - c3 * t274;
        let t284 = c3 * t57;
        put(7, t280); // row 1, MSY3R
        put(52, t283); // row 2, MSY3R
        t284
    };
    // XX3: column
    let [t286, t291] = {
        let t286 = z1_3_y * t51;
        let t289 = c2 * t50 - (t21 * dw3_x + t286);
        let t291 = c3 * t51;
        let t292 = s3 * dw3_x - t291;
        put(8, t289); // row 1, XX3R
        put(53, t292); // row 2, XX3R
        [t286, t291]
    };
    // ZZ3: column
    {
        let t296 = c2 * dw3_z + (t286 - t21 * t52);
        let t298 = t291 + s3 * t52;
        put(9, t296); // row 1, ZZ3R
        put(54, t298); // row 2, ZZ3R
    }
    // XY3: column
    {
        let t299 = t59 - t56;
        let t304 = c2 * t299 + (z1_3_y * t61 - t21 * t60);
        let t307 = s3 * t60 + c3 * t61;
        put(10, t304); // row 1, XY3R
        put(55, t307); // row 2, XY3R
        put(93, t299); // row 3, XY3R
    }
    // XZ3: column
    {
        let t312 = c2 * t45 + (t21 * t58 + z1_3_y * t55);
        let t314 = c3 * t55 - t272;
        put(11, t312); // row 1, XZ3
        put(56, t314); // row 2, XZ3
    }
    // YZ3: column
    {
        let t315 = t18 - t59;
        let t320 = c2 * t42 + (z1_3_y * t57 - t21 * t315);
        let t322 = t284 + s3 * t315;
        put(12, t320); // row 1, YZ3
        put(57, t322); // row 2, YZ3
    }
    // MSX4: column
    let [t324, t327] = {
        let t324 = t242 + L2 * s4;
        let t327 = s4 * A - L2 * c4;
        let t328 = t100 * t327;
        let t333 = t100 * t324 - t66;
        let t334 = t96 * t327 - t98 * t324 - a4_y;
        let t339 = z1_3_y * t334 + (z1_4_x * t328 + z1_4_y * t333);
        let t344 = c3 * t334 - (t229 * t333 - z2_4_x * t328);
        let t346 = t104 - c4 * t66;
        put(13, t339); // row 1, MSX4R
        put(58, t344); // row 2, MSX4R
        put(96, t346); // row 3, MSX4R
        [t324, t327]
    };
    // MSY4: column
    {
        let t348 = t101 * t324;
        let t352 = t101 * t327 - t66;
        let t353 = t99 * t324 - t97 * t327 - t70;
        let t358 = z1_3_y * t353 - (z1_4_x * t352 + z1_4_y * t348);
        let t363 = c3 * t353 - (z2_4_x * t352 - t229 * t348);
        let t366 = s4 * t66 - A * t101;
        put(14, t358); // row 1, MSY4R
        put(59, t363); // row 2, MSY4R
        put(97, t366); // row 3, MSY4R
    }
    // XX4: column
    let [t368, t373, t378] = {
        let t368 = t91 * z1_4_y;
        let t371 = z1_3_y * t90 + (dw4_x * z1_4_x + t368);
        let t373 = t91 * t229;
        let t376 = c3 * t90 + (dw4_x * z2_4_x - t373);
        let t378 = c4 * t91;
        let t379 = s4 * dw4_x + t378;
        put(15, t371); // row 1, XX4R
        put(60, t376); // row 2, XX4R
        put(98, t379); // row 3, XX4R
        [t368, t373, t378]
    };
    // ZZ4: column
    {
        let t383 = t92 * z1_4_x - t368 - z1_3_y * dw4_z;
        let t387 = t373 + t92 * z2_4_x - c3 * dw4_z;
        let t389 = s4 * t92 - t378;
        put(16, t383); // row 1, ZZ4R
        put(61, t387); // row 2, ZZ4R
        put(99, t389); // row 3, ZZ4R
    }
    // XY4: column
    {
        let t390 = t99 - t96;
        let t395 = t100 * z1_4_x + t101 * z1_4_y - z1_3_y * t390;
        let t400 = t100 * z2_4_x - t101 * t229 - c3 * t390;
        let t403 = s4 * t100 + c4 * t101;
        put(17, t395); // row 1, XY4R
        put(62, t400); // row 2, XY4R
        put(100, t403); // row 3, XY4R
        put(131, t390); // row 4, XY4R
    }
    // XZ4: column
    {
        let t408 = t98 * z1_4_x + t95 * z1_4_y - z1_3_y * t85;
        let t413 = t98 * z2_4_x - t95 * t229 - c3 * t85;
        let t416 = s4 * t98 + c4 * t95;
        put(18, t408); // row 1, XZ4
        put(63, t413); // row 2, XZ4
        put(101, t416); // row 3, XZ4
    }
    // YZ4: column
    {
        let t417 = t59 - t99;
        let t422 = z1_4_x * t417 - t97 * z1_4_y - z1_3_y * t82;
        let t427 = z2_4_x * t417 + t97 * t229 - c3 * t82;
        let t430 = s4 * t417 - c4 * t97;
        put(19, t422); // row 1, YZ4
        put(64, t427); // row 2, YZ4
        put(102, t430); // row 3, YZ4
    }
    // MSX5: column
    let [t432, t437, t438] = {
        let t432 = s5 * t144;
        let t433 = t432 - c5 * t142;
        let t436 = s5 * t142 + c5 * t144;
        let t437 = s5 * a5_z;
        let t438 = c5 * a5_z;
        let t443 = A * t436;
        let t444 = L3 * t436 - t437;
        let t445 = t438 + (L3 * t433 + A * t146);
        let t446 = a5_y - t443;
        let t452 = t327 * t436 - t444;
        let t453 = t446 + t324 * t436;
        let t454 = t146 * t324 + t327 * t433 - t445;
        let t459 = z1_3_y * t454 + (z1_4_x * t452 + z1_4_y * t453);
        let t464 = c3 * t454 + (z2_4_x * t452 - t229 * t453);
        let t468 = t443 + (c4 * t446 - s4 * t444);
        put(20, t459); // row 1, MSX5
        put(65, t464); // row 2, MSX5
        put(103, t468); // row 3, MSX5
        put(134, t445); // row 4, MSX5
        [t432, t437, t438]
    };
    // MSY5: column
    let t469 = {
        let t469 = c5 * t143;
        let t471 = t469 - s5 * t145;
        let t474 = s5 * t143 + c5 * t145;
        let t479 = A * t474;
        let t480 = t438 + L3 * t474;
        let t481 = L3 * t471 + A * t147 - t437;
        let t482 = t116 + t479;
        let t488 = t327 * t474 - t480;
        let t489 = t324 * t474 - t482;
        let t490 = t147 * t324 + t327 * t471 - t481;
        let t495 = z1_3_y * t490 - (z1_4_x * t488 + z1_4_y * t489);
        let t500 = c3 * t490 - (z2_4_x * t488 - t229 * t489);
        let t504 = s4 * t480 + c4 * t482 - t479;
        put(21, t495); // row 1, MSY5R
        put(66, t500); // row 2, MSY5R
        put(104, t504); // row 3, MSY5R
        put(135, t481); // row 4, MSY5R
        t469
    };
    // XX5: column
    let [t506, t511, t514, t516, t521] = {
        let t506 = t137 * t235;
        let t509 = t136 * z1_4_y - (t139 * z1_5_x + t506);
        let t511 = t137 * t241;
        let t514 = t136 * t229 + (t139 * z2_5_x + t511);
        let t516 = t137 * z3_6_z;
        let t519 = c4 * t136 - (t139 * z3_5_x + t516);
        let t521 = c5 * t137;
        let t522 = s5 * t139 - t521;
        put(22, t509); // row 1, XX5R
        put(105, t519); // row 3, XX5R
        put(136, t522); // row 4, XX5R
        [t506, t511, t514, t516, t521]
    };
    // ZZ5: column
    {
        let t526 = dw5_z * z1_4_y + (t506 - t138 * z1_5_x);
        let t530 = t511 - t138 * z2_5_x - dw5_z * t229;
        let t534 = c4 * dw5_z + (t516 - t138 * z3_5_x);
        let t536 = t521 + s5 * t138;
        put(23, t526); // row 1, ZZ5R
        put(68, t530); // row 2, ZZ5R
        put(106, t534); // row 3, ZZ5R
        put(137, t536); // row 4, ZZ5R
    }
    // XY5: column
    {
        let t537 = t142 + t145;
        let t542 = z1_4_y * t537 + (t146 * z1_5_x + t147 * t235);
        let t547 = t146 * z2_5_x + t147 * t241 - t229 * t537;
        let t552 = c4 * t537 + (t146 * z3_5_x + t147 * z3_6_z);
        let t555 = c5 * t147 - s5 * t146;
        put(24, t542); // row 1, XY5
        put(69, t547); // row 2, XY5
        put(107, t552); // row 3, XY5
        put(138, t555); // row 4, XY5
        put(162, t537); // row 5, XY5
    }
    // XZ5: column
    {
        let t560 = t131 * z1_4_y + (t144 * z1_5_x + t141 * t235);
        let t565 = t144 * z2_5_x + t141 * t241 - t131 * t229;
        let t570 = c4 * t131 + (t144 * z3_5_x + t141 * z3_6_z);
        let t572 = c5 * t141 - t432;
        put(25, t560); // row 1, XZ5
        put(70, t565); // row 2, XZ5
        put(108, t570); // row 3, XZ5
        put(139, t572); // row 4, XZ5
    }
    // YZ5: column
    let t583 = {
        let t573 = t145 - t99;
        let t578 = t128 * z1_4_y - (z1_5_x * t573 + t143 * t235);
        let t583 = t128 * t229 + (z2_5_x * t573 + t143 * t241);
        let t588 = c4 * t128 - (z3_5_x * t573 + t143 * z3_6_z);
        let t590 = s5 * t573 - t469;
        put(26, t578); // row 1, YZ5
        put(109, t588); // row 3, YZ5
        put(140, t590); // row 4, YZ5
        t583
    };
    // MSX6: column
    let [t592, t595, t597, t598] = {
        let t592 = s6 * t178;
        let t593 = c6 * t176 - t592;
        let t595 = c6 * t178;
        let t596 = s6 * t176 + t595;
        let t597 = s6 * a5_y;
        let t598 = c6 * a5_y;
        let t601 = c5 * t593 + s5 * t180;
        let t604 = c5 * t180 - s5 * t593;
        let t615 = A * t604;
        let t616 = c5 * t597 - s5 * a6_y + L3 * t604;
        let t617 = s5 * t597 + c5 * a6_y + (L3 * t601 + A * t596);
        let t618 = t598 - t615;
        let t624 = t327 * t604 - t616;
        let t625 = t618 + t324 * t604;
        let t626 = t324 * t596 + t327 * t601 - t617;
        let t631 = z1_3_y * t626 + (z1_4_x * t624 + z1_4_y * t625);
        let t636 = c3 * t626 + (z2_4_x * t624 - t229 * t625);
        let t640 = t615 + (c4 * t618 - s4 * t616);
        put(27, t631); // row 1, MSX6R
        put(72, t636); // row 2, MSX6R
        put(110, t640); // row 3, MSX6R
        put(141, t617); // row 4, MSX6R
        put(165, t598); // row 5, MSX6R
        [t592, t595, t597, t598]
    };
    // MSY6: column
    let [t641, t644] = {
        let t641 = c6 * t177;
        let t643 = s6 * t179 - t641;
        let t644 = s6 * t177;
        let t646 = t644 + c6 * t179;
        let t649 = c5 * t643 - s5 * t181;
        let t652 = s5 * t643 + c5 * t181;
        let t663 = A * t652;
        let t664 = c5 * t598 - s5 * t150 + L3 * t652;
        let t665 = s5 * t598 + c5 * t150 + (A * t646 - L3 * t649);
        let t666 = t597 + t663;
        let t672 = t664 - t327 * t652;
        let t673 = t324 * t652 - t666;
        let t674 = t324 * t646 - t327 * t649 - t665;
        let t679 = z1_3_y * t674 - (z1_4_x * t672 - z1_4_y * t673);
        let t684 = c3 * t674 - (z2_4_x * t672 + t229 * t673);
        let t688 = t663 - (s4 * t664 + c4 * t666);
        put(28, t679); // row 1, MSY6R
        put(73, t684); // row 2, MSY6R
        put(111, t688); // row 3, MSY6R
        put(142, t665); // row 4, MSY6R
        [t641, t644]
    };
    // XX6: column
    let [t690, t693] = {
        let t690 = s6 * t171;
        let t691 = c6 * t173 + t690;
        let t693 = c6 * t171;
        let t694 = t693 - s6 * t173;
        let t699 = z1_4_y * t694 + (t170 * t235 - z1_5_x * t691);
        let t704 = t170 * t241 - z2_5_x * t691 - t229 * t694;
        let t709 = c4 * t694 + (t170 * z3_6_z - z3_5_x * t691);
        let t712 = s5 * t691 + c5 * t170;
        put(29, t699); // row 1, XX6R
        put(74, t704); // row 2, XX6R
        put(112, t709); // row 3, XX6R
        put(143, t712); // row 4, XX6R
        put(167, t694); // row 5, XX6R
        [t690, t693]
    };
    // ZZ6: column
    let t716 = {
        let t714 = c6 * t172 - t690;
        let t716 = t693 + s6 * t172;
        let t721 = dw6_z * t235 - z1_5_x * t714 - z1_4_y * t716;
        let t726 = t229 * t716 + (dw6_z * t241 - z2_5_x * t714);
        let t731 = dw6_z * z3_6_z - z3_5_x * t714 - c4 * t716;
        let t734 = s5 * t714 + c5 * dw6_z;
        put(30, t721); // row 1, ZZ6R
        put(75, t726); // row 2, ZZ6R
        put(113, t731); // row 3, ZZ6R
        put(144, t734); // row 4, ZZ6R
        t716
    };
    // XY6: column
    {
        let t735 = t179 - t176;
        let t738 = c6 * t180 + s6 * t181;
        let t741 = s6 * t180 - c6 * t181;
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
        let t761 = t595 + s6 * t175;
        let t763 = c6 * t175 - t592;
        let t768 = z1_4_y * t763 - (z1_5_x * t761 - t165 * t235);
        let t773 = t165 * t241 - z2_5_x * t761 - t229 * t763;
        let t778 = c4 * t763 - (z3_5_x * t761 - t165 * z3_6_z);
        let t781 = s5 * t761 + c5 * t165;
        put(32, t768); // row 1, XZ6
        put(77, t773); // row 2, XZ6
        put(115, t778); // row 3, XZ6
        put(146, t781); // row 4, XZ6
        put(170, t763); // row 5, XZ6
    }
    // YZ6: column
    {
        let t782 = t145 - t179;
        let t784 = t644 - c6 * t782;
        let t786 = t641 + s6 * t782;
        let t791 = z1_4_y * t786 + (t162 * t235 - z1_5_x * t784);
        let t796 = t162 * t241 - z2_5_x * t784 - t229 * t786;
        let t801 = c4 * t786 + (t162 * z3_6_z - z3_5_x * t784);
        let t804 = s5 * t784 + c5 * t162;
        put(33, t791); // row 1, YZ6
        put(78, t796); // row 2, YZ6
        put(116, t801); // row 3, YZ6
        put(147, t804); // row 4, YZ6
        put(171, t786); // row 5, YZ6
    }
    // MSX7: column
    let [t806, t809, t811, t812] = {
        let t806 = s7 * t218;
        let t807 = c7 * t216 + t806;
        let t809 = c7 * t218;
        let t810 = s7 * t216 - t809;
        let t811 = s7 * t186;
        let t812 = c7 * t186;
        let t815 = k4 * t220 - t812;
        let t816 = a7_y - k4 * t810;
        let t819 = c6 * t807 + s6 * t220;
        let t822 = s6 * t807 - c6 * t220;
        let t825 = c6 * t811 + s6 * t816;
        let t828 = s6 * t811 - c6 * t816;
        let t831 = c5 * t819 + s5 * t810;
        let t834 = s5 * t819 - c5 * t810;
        let t845 = A * t834;
        let t846 = c5 * t825 + s5 * t815 + L3 * t834;
        let t847 = c5 * t815 - s5 * t825 + (L3 * t831 + A * t822);
        let t848 = t828 + t845;
        let t854 = t846 - t327 * t834;
        let t855 = t324 * t834 - t848;
        let t856 = t324 * t822 + t327 * t831 - t847;
        let t861 = z1_3_y * t856 + (z1_4_x * t854 - z1_4_y * t855);
        let t866 = c3 * t856 + (z2_4_x * t854 + t229 * t855);
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
        let t871 = c7 * t217;
        let t873 = t871 - s7 * t219;
        let t874 = s7 * t217;
        let t876 = t874 + c7 * t219;
        let t879 = t811 - k4 * t221;
        let t880 = k4 * t876 - t190;
        let t883 = c6 * t873 - s6 * t221;
        let t886 = s6 * t873 + c6 * t221;
        let t889 = c6 * t812 - s6 * t880;
        let t892 = s6 * t812 + c6 * t880;
        let t895 = c5 * t883 + s5 * t876;
        let t898 = s5 * t883 - c5 * t876;
        let t909 = A * t898;
        let t910 = c5 * t889 + s5 * t879 + L3 * t898;
        let t911 = c5 * t879 - s5 * t889 + (L3 * t895 + A * t886);
        let t912 = t892 + t909;
        let t918 = t327 * t898 - t910;
        let t919 = t912 - t324 * t898;
        let t920 = t324 * t886 + t327 * t895 - t911;
        let t925 = z1_3_y * t920 - (z1_4_x * t918 - z1_4_y * t919);
        let t930 = c3 * t920 - (z2_4_x * t918 + t229 * t919);
        let t934 = s4 * t910 + c4 * t912 - t909;
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
        let t936 = s7 * t211;
        let t937 = c7 * dw7_x - t936;
        let t939 = c7 * t211;
        let t940 = s7 * dw7_x + t939;
        let t943 = c6 * t937 - s6 * t210;
        let t946 = s6 * t937 + c6 * t210;
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
        let t966 = t936 + c7 * t212;
        let t968 = s7 * t212 - t939;
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
        let t993 = t219 - t216;
        let t996 = c7 * t220 - s7 * t221;
        let t999 = s7 * t220 + c7 * t221;
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
        let t1025 = t809 + s7 * t215;
        let t1027 = t806 - c7 * t215;
        let t1030 = c6 * t1025 + s6 * t205;
        let t1033 = s6 * t1025 - c6 * t205;
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
        let t1052 = t179 - t219;
        let t1054 = c7 * t1052 - t874;
        let t1056 = t871 + s7 * t1052;
        let t1059 = c6 * t1054 + s6 * t202;
        let t1062 = s6 * t1054 - c6 * t202;
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
        let t1088 = -t2;
        let t1089 = -t9;
        let t1090 = -t5;
        let t1091 = -t6;
        let t1092 = -t514;
        let t1093 = -t583;
        let t1094 = -t90;
        let t1095 = -t597;
        let t1096 = -t716;
        let t1097 = -t210;
        put(40, t1067); // row 1, YZ7
        put(42, t1081); // row 1, FC1
        put(44, t1088); // row 2, MSX2
        put(46, t1089); // row 2, XX2R
        put(49, t1090); // row 2, XZ2
        put(50, t1091); // row 2, YZ2
        put(67, t1092); // row 2, XX5R
        put(71, t1093); // row 2, YZ5
        put(85, t1072); // row 2, YZ7
        put(87, t1082); // row 2, FC2
        put(123, t1077); // row 3, YZ7
        put(125, t1083); // row 3, FC3
        put(129, t1094); // row 4, XX4R
        put(154, t1080); // row 4, YZ7
        put(156, t1084); // row 4, FC4
        put(166, t1095); // row 5, MSY6R
        put(168, t1096); // row 5, ZZ6R
        put(178, t1062); // row 5, YZ7
        put(180, t1085); // row 5, FC5
        put(195, t1056); // row 6, YZ7
        put(197, t1086); // row 6, FC6
        put(201, t1097); // row 7, XX7R
        put(207, t1087); // row 7, FC7
    }
}
