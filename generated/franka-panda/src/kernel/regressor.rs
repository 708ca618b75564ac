//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil and Dombre, 12.4.
//!
//! 854 multiplications, 639 additions; 7 x 91, 276 of 637 structurally nonzero.

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
    let flat = &mut out.as_flattened_mut()[..];
    flat[0..6].fill(S::default());
    flat[7..13].fill(S::default());
    flat[71..77].fill(S::default());
    flat[78..84].fill(S::default());
    flat[85..102].fill(S::default());
    flat[104] = S::default();
    flat[161] = S::default();
    flat[163..169].fill(S::default());
    flat[170..176].fill(S::default());
    flat[177..203].fill(S::default());
    flat[205] = S::default();
    flat[252..254].fill(S::default());
    flat[255..261].fill(S::default());
    flat[262..268].fill(S::default());
    flat[269..304].fill(S::default());
    flat[306] = S::default();
    flat[343..346].fill(S::default());
    flat[347..353].fill(S::default());
    flat[354..360].fill(S::default());
    flat[361..405].fill(S::default());
    flat[407] = S::default();
    flat[414] = S::default();
    flat[434..438].fill(S::default());
    flat[439..445].fill(S::default());
    flat[446..452].fill(S::default());
    flat[453..506].fill(S::default());
    flat[508] = S::default();
    flat[525..530].fill(S::default());
    flat[531..537].fill(S::default());
    flat[538..544].fill(S::default());
    flat[545..607].fill(S::default());
    flat[609] = S::default();
    flat[616..622].fill(S::default());
    flat[623..629].fill(S::default());
    flat[630..636].fill(S::default());
    nonzeros(trig, dq, ddq, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 91]; 7]) {
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
        put(0, ddq1); // row 1, ZZ1
        put(58, dq1); // row 1, FV1
        put(60, k5); // row 1, FO1
        put(65, ddq2); // row 2, ZZ2
        put(119, dq2); // row 2, FV2
        put(121, k5); // row 2, FO2
        put(170, dq3); // row 3, FV3
        put(172, k5); // row 3, FO3
        put(211, dq4); // row 4, FV4
        put(213, k5); // row 4, FO4
        put(241, dq5); // row 5, FV5
        put(243, k5); // row 5, FO5
        put(262, dq6); // row 6, FV6
        put(264, k5); // row 6, FO6
        put(273, dq7); // row 7, FV7
        put(275, k5); // row 7, FO7
        t0
    };
    // link 2: motion
    let [
        t1, t2, t3, t4, t5, t6, t9, t10,
        t11, t12, t13, t14, t15, t16, t17, t18,
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
        let t13 = t6 - t10;
        let t14 = t7 - t8;
        let t15 = t14 - t0;
        let t16 = ddq2 - t9;
        let t17 = ddq2 + t9;
        let t18 = t7 + t8;
        let t19 = t13 - t10;
        let t20 = t11 + t12;
        put(62, t1); // row 2, MSY2
        put(64, t9); // row 2, YY2
        [
        t1, t2, t3, t4, t5, t6, t9, t10,
        t11, t12, t13, t14, t15, t16, t17, t18,
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
        let t27 = t2 - L2 * t18;
        let t30 = c3 * t26 - s3 * t25;
        let a3_y = c3 * t25 + s3 * t26;
        let t36 = c3 * t3 - s3 * dq2;
        let w3_y = c3 * dq2 + s3 * t3;
        let t42 = c3 * t16 + s3 * t20;
        let t45 = s3 * t16 - c3 * t20;
        let w3_z = t4 + dq3;
        let dw3_z = t13 + ddq3;
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
        put(122, a3_y); // row 3, MSX3
        put(123, t30); // row 3, MSY3
        put(124, t50); // row 3, XX3
        put(126, dw3_z); // row 3, ZZ3
        put(128, t45); // row 3, XZ3
        put(129, t42); // row 3, YZ3
        [
        t21, z1_3_y, t27, t30, a3_y, t36, w3_y, t42,
        t45, w3_z, dw3_z, t50, t51, t52, dw3_x, dw3_y,
        t55, t56, t57, t58, t59, t60, t61,
    ]
    };
    // link 4: motion
    let [
        t66, t70, a4_y, t76, w4_y, t82, t85, w4_z,
        dw4_z, t90, t91, t92, dw4_x, t94, t95, t96,
        t97, t98, t99, t100, t101,
    ] = {
        let t65 = t30 + A * t56;
        let t66 = a3_y - A * t58;
        let t67 = t27 - A * t60;
        let t70 = c4 * t65 - s4 * t67;
        let a4_y = c4 * t67 + s4 * t65;
        let t76 = c4 * t36 - s4 * w3_z;
        let w4_y = c4 * w3_z + s4 * t36;
        let t82 = c4 * t57 - s4 * t61;
        let t85 = c4 * t61 + s4 * t57;
        let w4_z = dq4 - w3_y;
        let dw4_z = ddq4 - dw3_y;
        let t88 = t76 * t76;
        let t89 = w4_z * w4_z;
        let t90 = t76 * w4_y;
        let t91 = t76 * w4_z;
        let t92 = w4_y * w4_z;
        let dw4_x = t85 + t92;
        let t94 = t82 + t91;
        let t95 = t89 - t88;
        let t96 = t59 + t95;
        let t97 = dw4_z + t90;
        let t98 = dw4_z - t90;
        let t99 = t88 + t89;
        let t100 = t91 + t94;
        let t101 = t92 + dw4_x;
        put(173, a4_y); // row 4, MSX4
        put(174, t70); // row 4, MSY4
        put(175, t90); // row 4, XX4
        put(177, dw4_z); // row 4, ZZ4
        put(179, t85); // row 4, XZ4
        put(180, t82); // row 4, YZ4
        [
        t66, t70, a4_y, t76, w4_y, t82, t85, w4_z,
        dw4_z, t90, t91, t92, dw4_x, t94, t95, t96,
        t97, t98, t99, t100, t101,
    ]
    };
    // link 5: motion
    let [
        t104, t112, t116, a5_y, t122, t125, t128, t131,
        w5_z, dw5_z, t136, t137, t138, dw5_x, t140, t141,
        t142, t143, t144, t145, t146, t147,
    ] = {
        let t104 = A * t100;
        let t111 = t70 - (A * t96 - L3 * t97);
        let t112 = A * t98 + L3 * t99 - a4_y;
        let t113 = t104 + L3 * t101 - t66;
        let t116 = c5 * t111 + s5 * t113;
        let a5_y = s5 * t111 - c5 * t113;
        let t122 = c5 * t76 + s5 * w4_z;
        let t125 = c5 * w4_z - s5 * t76;
        let t128 = c5 * t97 + s5 * t101;
        let t131 = c5 * t101 - s5 * t97;
        let w5_z = w4_y + dq5;
        let dw5_z = t94 + ddq5;
        let t134 = t122 * t122;
        let t135 = w5_z * w5_z;
        let t136 = t122 * t125;
        let t137 = t122 * w5_z;
        let t138 = t125 * w5_z;
        let dw5_x = t131 - t138;
        let t140 = t128 - t137;
        let t141 = t134 - t135;
        let t142 = t141 - t99;
        let t143 = dw5_z - t136;
        let t144 = dw5_z + t136;
        let t145 = t134 + t135;
        let t146 = t137 - t140;
        let t147 = t138 - dw5_x;
        put(214, a5_y); // row 5, MSX5
        put(215, t116); // row 5, MSY5
        put(217, t136); // row 5, YY5
        put(218, dw5_z); // row 5, ZZ5
        put(220, t131); // row 5, XZ5
        [
        t104, t112, t116, a5_y, t122, t125, t128, t131,
        w5_z, dw5_z, t136, t137, t138, dw5_x, t140, t141,
        t142, t143, t144, t145, t146, t147,
    ]
    };
    // link 6: motion
    let [
        t150, a6_y, t156, w6_y, t162, t165, w6_z, dw6_z,
        t170, t171, t172, dw6_x, dw6_y, t175, t176, t177,
        t178, t179, t180, t181,
    ] = {
        let t150 = c6 * t116 + s6 * t112;
        let a6_y = s6 * t116 - c6 * t112;
        let t156 = c6 * t122 - s6 * w5_z;
        let w6_y = c6 * w5_z + s6 * t122;
        let t162 = c6 * t143 + s6 * t147;
        let t165 = s6 * t143 - c6 * t147;
        let w6_z = t125 + dq6;
        let dw6_z = t140 + ddq6;
        let t168 = t156 * t156;
        let t169 = w6_z * w6_z;
        let t170 = t156 * w6_y;
        let t171 = t156 * w6_z;
        let t172 = w6_y * w6_z;
        let dw6_x = t165 + t172;
        let dw6_y = t162 + t171;
        let t175 = t168 - t169;
        let t176 = t145 - t175;
        let t177 = dw6_z + t170;
        let t178 = dw6_z - t170;
        let t179 = t168 + t169;
        let t180 = t171 + dw6_y;
        let t181 = t172 + dw6_x;
        put(244, a6_y); // row 6, MSX6
        put(245, t150); // row 6, MSY6
        put(246, t170); // row 6, XX6
        put(248, dw6_z); // row 6, ZZ6
        put(250, t165); // row 6, XZ6
        put(251, t162); // row 6, YZ6
        [
        t150, a6_y, t156, w6_y, t162, t165, w6_z, dw6_z,
        t170, t171, t172, dw6_x, dw6_y, t175, t176, t177,
        t178, t179, t180, t181,
    ]
    };
    // link 7: motion
    let [
        t186, t190, a7_y, t202, t205, dw7_z, t210, t211,
        t212, dw7_x, t214, t215, t216, t217, t218, t219,
        t220, t221,
    ] = {
        let t185 = t150 + k4 * t176;
        let t186 = a6_y + k4 * t178;
        let t187 = a5_y + k4 * t180;
        let t190 = c7 * t185 + s7 * t187;
        let a7_y = s7 * t185 - c7 * t187;
        let w7_x = s7 * w6_z - c7 * t156;
        let w7_y = c7 * w6_z + s7 * t156;
        let t202 = c7 * t177 - s7 * t181;
        let t205 = c7 * t181 + s7 * t177;
        let t206 = w6_y - dq7;
        let dw7_z = ddq7 - dw6_y;
        let t208 = w7_x * w7_x;
        let t209 = t206 * t206;
        let t210 = w7_x * w7_y;
        let t211 = w7_x * t206;
        let t212 = w7_y * t206;
        let dw7_x = t205 - t212;
        let t214 = t202 + t211;
        let t215 = t208 - t209;
        let t216 = t179 - t215;
        let t217 = dw7_z - t210;
        let t218 = dw7_z + t210;
        let t219 = t208 + t209;
        let t220 = t211 + t214;
        let t221 = t212 - dw7_x;
        put(265, a7_y); // row 7, MSX7
        put(266, t190); // row 7, MSY7
        put(268, t210); // row 7, YY7
        put(269, dw7_z); // row 7, ZZ7
        put(271, t205); // row 7, XZ7
        put(272, t202); // row 7, YZ7
        [
        t186, t190, a7_y, t202, t205, dw7_z, t210, t211,
        t212, dw7_x, t214, t215, t216, t217, t218, t219,
        t220, t221,
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
    // MSZ2: column
    {
        let t247 = c2 * t1 - s2 * t2;
        put(1, t247); // row 1, MSZ2
    }
    // XX2: column
    let t249 = {
        let t249 = c2 * t10;
        let t250 = s2 * t12 + t249;
        put(2, t250); // row 1, XX2
        t249
    };
    // YY2: column
    let t251 = {
        let t251 = s2 * t11;
        let t253 = c2 * t13 - t251;
        put(3, t253); // row 1, YY2
        t251
    };
    // ZZ2: column
    {
        let t254 = t251 - t249;
        put(4, t254); // row 1, ZZ2
    }
    // XY2: column
    {
        let t255 = t15 + t18;
        let t258 = s2 * t19 + c2 * t20;
        put(5, t258); // row 1, XY2
        put(66, t255); // row 2, XY2
    }
    // XZ2: column
    {
        let t261 = c2 * t14 - s2 * t17;
        put(6, t261); // row 1, XZ2
    }
    // YZ2: column
    {
        let t265 = s2 * (t18 - t0) - c2 * t16;
        put(7, t265); // row 1, YZ2
    }
    // M3: column
    let t273 = {
        let t266 = L2 * a3_y;
        let t267 = L2 * t30;
        let t270 = t21 * t266 - z1_3_y * t267;
        let t273 = s3 * t266 + c3 * t267;
        put(8, t270); // row 1, M3
        t273
    };
    // MSX3: column
    let t285 = {
        let t274 = L2 * t58;
        let t276 = t27 + L2 * t56;
        let t281 = c2 * a3_y - (t21 * t274 + z1_3_y * t276);
        let t284 = s3 * t274 - c3 * t276;
        let t285 = s3 * t58;
        put(9, t281); // row 1, MSX3
        put(70, t284); // row 2, MSX3
        t285
    };
    // MSY3: column
    let t297 = {
        let t287 = L2 * t57;
        let t288 = t27 + L2 * t59;
        let t293 = c2 * t30 - (t21 * t288 + z1_3_y * t287);
        let t296 = s3 * t288 - c3 * t287;
        let t297 = c3 * t57;
        put(10, t293); // row 1, MSY3
        put(71, t296); // row 2, MSY3
        t297
    };
    // MSZ3: column
    {
        let t300 = L2 * t45 - a3_y;
        let t301 = L2 * t42 - t30;
        let t304 = z1_3_y * t301 - t21 * t300;
        let t307 = s3 * t300 + c3 * t301;
        put(11, t304); // row 1, MSZ3
        put(72, t307); // row 2, MSZ3
    }
    // XX3: column
    let [t309, t310, t314] = {
        let t309 = z1_3_y * t51;
        let t310 = c2 * t50;
        let t312 = t310 - (t21 * dw3_x + t309);
        let t314 = c3 * t51;
        let t315 = s3 * dw3_x - t314;
        put(12, t312); // row 1, XX3
        put(73, t315); // row 2, XX3
        [t309, t310, t314]
    };
    // YY3: column
    let [t316, t320] = {
        let t316 = t21 * t52;
        let t319 = t316 + z1_3_y * dw3_y - t310;
        let t320 = s3 * t52;
        let t322 = c3 * dw3_y - t320;
        put(13, t319); // row 1, YY3
        put(74, t322); // row 2, YY3
        [t316, t320]
    };
    // ZZ3: column
    {
        let t325 = c2 * dw3_z - (t316 - t309);
        let t326 = t314 + t320;
        put(14, t325); // row 1, ZZ3
        put(75, t326); // row 2, ZZ3
    }
    // XY3: column
    {
        let t327 = t59 - t56;
        let t332 = c2 * t327 + (z1_3_y * t61 - t21 * t60);
        let t335 = s3 * t60 + c3 * t61;
        put(15, t332); // row 1, XY3
        put(76, t335); // row 2, XY3
        put(127, t327); // row 3, XY3
    }
    // XZ3: column
    {
        let t340 = c2 * t45 + (t21 * t58 + z1_3_y * t55);
        let t342 = c3 * t55 - t285;
        put(16, t340); // row 1, XZ3
        put(77, t342); // row 2, XZ3
    }
    // YZ3: column
    {
        let t343 = t18 - t59;
        let t348 = c2 * t42 - (t21 * t343 - z1_3_y * t57);
        let t350 = t297 + s3 * t343;
        put(17, t348); // row 1, YZ3
        put(78, t350); // row 2, YZ3
    }
    // M4: column
    let [t352, t355] = {
        let t352 = t242 + L2 * s4;
        let t355 = s4 * A - L2 * c4;
        let t356 = t66 * t355;
        let t357 = t66 * t352;
        let t360 = a4_y * t352 - t70 * t355;
        let t365 = z1_4_x * t356 + z1_4_y * t357 - z1_3_y * t360;
        let t370 = z2_4_x * t356 - t229 * t357 - c3 * t360;
        let t371 = A * t66;
        put(18, t365); // row 1, M4
        put(79, t370); // row 2, M4
        put(130, t371); // row 3, M4
        [t352, t355]
    };
    // MSX4: column
    {
        let t372 = t100 * t355;
        let t377 = t66 + t100 * t352;
        let t378 = a4_y - (t96 * t355 - t98 * t352);
        let t383 = z1_4_x * t372 + z1_4_y * t377 - z1_3_y * t378;
        let t388 = z2_4_x * t372 - t229 * t377 - c3 * t378;
        let t390 = t104 + c4 * t66;
        put(19, t383); // row 1, MSX4
        put(80, t388); // row 2, MSX4
        put(131, t390); // row 3, MSX4
    }
    // MSY4: column
    let [t393, t410] = {
        let t392 = t101 * t352;
        let t393 = t99 * t352;
        let t396 = t66 + t101 * t355;
        let t397 = t393 + t97 * t355 - t70;
        let t402 = z1_3_y * t397 - (z1_4_x * t396 + z1_4_y * t392);
        let t407 = c3 * t397 - (z2_4_x * t396 - t229 * t392);
        let t410 = s4 * t66 + A * t101;
        put(20, t402); // row 1, MSY4
        put(81, t407); // row 2, MSY4
        [t393, t410]
    };
    // MSZ4: column
    {
        let t415 = t85 * t352 - t82 * t355;
        let t416 = t59 * t355 - a4_y;
        let t417 = t59 * t352 - t70;
        let t422 = z1_3_y * t415 + (z1_4_x * t416 + z1_4_y * t417);
        let t427 = c3 * t415 - (t229 * t417 - z2_4_x * t416);
        let t432 = A * t59 - (s4 * a4_y + c4 * t70);
        put(21, t422); // row 1, MSZ4
        put(82, t427); // row 2, MSZ4
        put(133, t432); // row 3, MSZ4
    }
    // XX4: column
    let [t434, t435, t439, t440, t444] = {
        let t434 = t91 * z1_4_y;
        let t435 = z1_3_y * t90;
        let t437 = dw4_x * z1_4_x - t434 - t435;
        let t439 = t91 * t229;
        let t440 = c3 * t90;
        let t442 = dw4_x * z2_4_x + t439 - t440;
        let t444 = c4 * t91;
        let t445 = s4 * dw4_x - t444;
        put(22, t437); // row 1, XX4
        put(83, t442); // row 2, XX4
        put(134, t445); // row 3, XX4
        [t434, t435, t439, t440, t444]
    };
    // YY4: column
    let [t446, t450, t454] = {
        let t446 = t92 * z1_4_x;
        let t449 = t435 + (t94 * z1_4_y - t446);
        let t450 = t92 * z2_4_x;
        let t453 = t440 - (t450 + t94 * t229);
        let t454 = s4 * t92;
        let t456 = c4 * t94 - t454;
        put(23, t449); // row 1, YY4
        put(84, t453); // row 2, YY4
        put(135, t456); // row 3, YY4
        [t446, t450, t454]
    };
    // ZZ4: column
    {
        let t459 = t434 + t446 - z1_3_y * dw4_z;
        let t462 = t450 - t439 - c3 * dw4_z;
        let t463 = t444 + t454;
        put(24, t459); // row 1, ZZ4
        put(85, t462); // row 2, ZZ4
        put(136, t463); // row 3, ZZ4
    }
    // XY4: column
    {
        let t464 = t99 - t96;
        let t469 = t100 * z1_4_x + t101 * z1_4_y - z1_3_y * t464;
        let t474 = t100 * z2_4_x - t101 * t229 - c3 * t464;
        let t477 = s4 * t100 + c4 * t101;
        put(25, t469); // row 1, XY4
        put(86, t474); // row 2, XY4
        put(137, t477); // row 3, XY4
        put(178, t464); // row 4, XY4
    }
    // XZ4: column
    {
        let t482 = t98 * z1_4_x + t95 * z1_4_y - z1_3_y * t85;
        let t487 = t98 * z2_4_x - t95 * t229 - c3 * t85;
        let t490 = s4 * t98 + c4 * t95;
        put(26, t482); // row 1, XZ4
        put(87, t487); // row 2, XZ4
        put(138, t490); // row 3, XZ4
    }
    // YZ4: column
    {
        let t491 = t59 - t99;
        let t496 = z1_4_x * t491 + t97 * z1_4_y - z1_3_y * t82;
        let t501 = z2_4_x * t491 - t97 * t229 - c3 * t82;
        let t504 = s4 * t491 + c4 * t97;
        put(27, t496); // row 1, YZ4
        put(88, t501); // row 2, YZ4
        put(139, t504); // row 3, YZ4
    }
    // M5: column
    let [t506, t507, t509, t510] = {
        let t506 = s5 * a5_y;
        let t507 = c5 * t116 + t506;
        let t509 = c5 * a5_y;
        let t510 = s5 * t116 - t509;
        let t511 = L3 * t510;
        let t514 = L3 * t507 + A * t112;
        let t515 = A * t510;
        let t521 = t511 - t355 * t510;
        let t522 = t352 * t510 - t515;
        let t523 = t112 * t352 + t355 * t507 - t514;
        let t528 = z1_3_y * t523 - (z1_4_y * t522 - z1_4_x * t521);
        let t533 = c3 * t523 + (z2_4_x * t521 + t229 * t522);
        let t537 = s4 * t511 + c4 * t515 - t515;
        put(28, t528); // row 1, M5
        put(89, t533); // row 2, M5
        put(140, t537); // row 3, M5
        put(181, t514); // row 4, M5
        [t506, t507, t509, t510]
    };
    // MSX5: column
    let [t539, t544, t545] = {
        let t539 = s5 * t144;
        let t540 = c5 * t142 - t539;
        let t543 = s5 * t142 + c5 * t144;
        let t544 = s5 * t112;
        let t545 = c5 * t112;
        let t550 = A * t543;
        let t551 = t544 + L3 * t543;
        let t552 = A * t146 - L3 * t540 - t545;
        let t553 = a5_y - t550;
        let t559 = t355 * t543 - t551;
        let t560 = t553 + t352 * t543;
        let t561 = t146 * t352 - t355 * t540 - t552;
        let t566 = z1_3_y * t561 + (z1_4_x * t559 + z1_4_y * t560);
        let t571 = c3 * t561 + (z2_4_x * t559 - t229 * t560);
        let t575 = t550 + (c4 * t553 - s4 * t551);
        put(29, t566); // row 1, MSX5
        put(90, t571); // row 2, MSX5
        put(141, t575); // row 3, MSX5
        put(182, t552); // row 4, MSX5
        [t539, t544, t545]
    };
    // MSY5: column
    let [t576, t577, t580] = {
        let t576 = c5 * t143;
        let t577 = s5 * t145;
        let t578 = t576 - t577;
        let t580 = c5 * t145;
        let t581 = s5 * t143 + t580;
        let t586 = A * t581;
        let t587 = L3 * t581 - t545;
        let t588 = t544 + (L3 * t578 + A * t147);
        let t589 = t116 + t586;
        let t595 = t355 * t581 - t587;
        let t596 = t352 * t581 - t589;
        let t597 = t147 * t352 + t355 * t578 - t588;
        let t602 = z1_3_y * t597 - (z1_4_x * t595 + z1_4_y * t596);
        let t607 = c3 * t597 + (t229 * t596 - z2_4_x * t595);
        let t611 = s4 * t587 + c4 * t589 - t586;
        put(30, t602); // row 1, MSY5
        put(91, t607); // row 2, MSY5
        put(142, t611); // row 3, MSY5
        put(183, t588); // row 4, MSY5
        [t576, t577, t580]
    };
    // MSZ5: column
    {
        let t614 = c5 * t128 - s5 * t131;
        let t617 = s5 * t128 + c5 * t131;
        let t622 = A * t617;
        let t623 = t510 + L3 * t617;
        let t624 = t507 + (L3 * t614 + A * t99);
        let t629 = t355 * t617 - t623;
        let t630 = t352 * t617 - t622;
        let t631 = t393 + t355 * t614 - t624;
        let t636 = z1_3_y * t631 - (z1_4_x * t629 + z1_4_y * t630);
        let t641 = c3 * t631 - (z2_4_x * t629 - t229 * t630);
        let t645 = s4 * t623 + c4 * t622 - t622;
        put(31, t636); // row 1, MSZ5
        put(92, t641); // row 2, MSZ5
        put(143, t645); // row 3, MSZ5
        put(184, t624); // row 4, MSZ5
    }
    // XX5: column
    let [t647, t648, t652, t653, t657, t658, t662] = {
        let t647 = t137 * t235;
        let t648 = t136 * z1_4_y;
        let t650 = dw5_x * z1_5_x + t647 - t648;
        let t652 = t137 * t241;
        let t653 = t136 * t229;
        let t655 = t653 + (dw5_x * z2_5_x + t652);
        let t657 = t137 * z3_6_z;
        let t658 = c4 * t136;
        let t660 = dw5_x * z3_5_x + t657 - t658;
        let t662 = c5 * t137;
        let t663 = t662 - s5 * dw5_x;
        put(32, t650); // row 1, XX5
        put(93, t655); // row 2, XX5
        put(144, t660); // row 3, XX5
        put(185, t663); // row 4, XX5
        [t647, t648, t652, t653, t657, t658, t662]
    };
    // YY5: column
    let [t664, t668, t672, t676] = {
        let t664 = t138 * z1_5_x;
        let t667 = t648 + (t664 + t140 * t235);
        let t668 = t138 * z2_5_x;
        let t671 = t668 + t140 * t241 - t653;
        let t672 = t138 * z3_5_x;
        let t675 = t658 + (t672 + t140 * z3_6_z);
        let t676 = s5 * t138;
        let t678 = c5 * t140 - t676;
        put(33, t667); // row 1, YY5
        put(94, t671); // row 2, YY5
        put(145, t675); // row 3, YY5
        put(186, t678); // row 4, YY5
        [t664, t668, t672, t676]
    };
    // ZZ5: column
    let t684 = {
        let t681 = dw5_z * z1_4_y - (t647 + t664);
        let t684 = dw5_z * t229 + (t652 + t668);
        let t687 = c4 * dw5_z - (t657 + t672);
        let t688 = t676 - t662;
        put(34, t681); // row 1, ZZ5
        put(146, t687); // row 3, ZZ5
        put(187, t688); // row 4, ZZ5
        t684
    };
    // XY5: column
    {
        let t689 = t142 + t145;
        let t694 = z1_4_y * t689 + (t146 * z1_5_x + t147 * t235);
        let t699 = t146 * z2_5_x + t147 * t241 - t229 * t689;
        let t704 = c4 * t689 + (t146 * z3_5_x + t147 * z3_6_z);
        let t707 = c5 * t147 - s5 * t146;
        put(35, t694); // row 1, XY5
        put(96, t699); // row 2, XY5
        put(147, t704); // row 3, XY5
        put(188, t707); // row 4, XY5
        put(219, t689); // row 5, XY5
    }
    // XZ5: column
    {
        let t712 = t131 * z1_4_y + (t144 * z1_5_x + t141 * t235);
        let t717 = t144 * z2_5_x + t141 * t241 - t131 * t229;
        let t722 = c4 * t131 + (t144 * z3_5_x + t141 * z3_6_z);
        let t724 = c5 * t141 - t539;
        put(36, t712); // row 1, XZ5
        put(97, t717); // row 2, XZ5
        put(148, t722); // row 3, XZ5
        put(189, t724); // row 4, XZ5
    }
    // YZ5: column
    let t742 = {
        let t725 = t99 - t145;
        let t730 = z1_5_x * t725 - t143 * t235 - t128 * z1_4_y;
        let t735 = t128 * t229 - (t143 * t241 - z2_5_x * t725);
        let t740 = z3_5_x * t725 - t143 * z3_6_z - c4 * t128;
        let t742 = t576 + s5 * t725;
        put(37, t730); // row 1, YZ5
        put(98, t735); // row 2, YZ5
        put(149, t740); // row 3, YZ5
        t742
    };
    // M6: column
    let [t745, t748] = {
        let t745 = c6 * t150 + s6 * a6_y;
        let t748 = s6 * t150 - c6 * a6_y;
        let t750 = t506 + c5 * t745;
        let t752 = t509 - s5 * t745;
        let t753 = L3 * t752;
        let t756 = L3 * t750 + A * t748;
        let t757 = A * t752;
        let t763 = t753 - t355 * t752;
        let t764 = t352 * t752 - t757;
        let t765 = t352 * t748 + t355 * t750 - t756;
        let t770 = z1_3_y * t765 + (z1_4_y * t764 - z1_4_x * t763);
        let t775 = c3 * t765 - (z2_4_x * t763 + t229 * t764);
        let t779 = t757 - (s4 * t753 + c4 * t757);
        put(38, t770); // row 1, M6
        put(99, t775); // row 2, M6
        put(150, t779); // row 3, M6
        put(191, t756); // row 4, M6
        [t745, t748]
    };
    // MSX6: column
    let [t781, t784, t786, t787] = {
        let t781 = s6 * t178;
        let t782 = c6 * t176 + t781;
        let t784 = c6 * t178;
        let t785 = s6 * t176 - t784;
        let t786 = s6 * a5_y;
        let t787 = c6 * a5_y;
        let t790 = c5 * t782 + s5 * t180;
        let t793 = c5 * t180 - s5 * t782;
        let t804 = A * t793;
        let t805 = s5 * a6_y - c5 * t786 - L3 * t793;
        let t806 = s5 * t786 + c5 * a6_y + (L3 * t790 + A * t785);
        let t807 = t787 - t804;
        let t813 = t805 + t355 * t793;
        let t814 = t807 + t352 * t793;
        let t815 = t352 * t785 + t355 * t790 - t806;
        let t820 = z1_3_y * t815 + (z1_4_x * t813 + z1_4_y * t814);
        let t825 = c3 * t815 + (z2_4_x * t813 - t229 * t814);
        let t829 = t804 + (s4 * t805 + c4 * t807);
        put(39, t820); // row 1, MSX6
        put(100, t825); // row 2, MSX6
        put(151, t829); // row 3, MSX6
        put(192, t806); // row 4, MSX6
        put(222, t787); // row 5, MSX6
        [t781, t784, t786, t787]
    };
    // MSY6: column
    let [t830, t831, t833, t834] = {
        let t830 = c6 * t177;
        let t831 = s6 * t179;
        let t832 = t831 - t830;
        let t833 = s6 * t177;
        let t834 = c6 * t179;
        let t835 = t833 + t834;
        let t838 = c5 * t832 + s5 * t181;
        let t841 = s5 * t832 - c5 * t181;
        let t852 = A * t841;
        let t853 = s5 * t150 - c5 * t787 - L3 * t841;
        let t854 = s5 * t787 + c5 * t150 - (L3 * t838 - A * t835);
        let t855 = t786 + t852;
        let t861 = t853 + t355 * t841;
        let t862 = t855 - t352 * t841;
        let t863 = t854 - (t352 * t835 - t355 * t838);
        let t868 = z1_4_x * t861 - z1_4_y * t862 - z1_3_y * t863;
        let t873 = z2_4_x * t861 + t229 * t862 - c3 * t863;
        let t877 = t852 + (s4 * t853 - c4 * t855);
        put(40, t868); // row 1, MSY6
        put(101, t873); // row 2, MSY6
        put(152, t877); // row 3, MSY6
        put(193, t854); // row 4, MSY6
        [t830, t831, t833, t834]
    };
    // MSZ6: column
    {
        let t880 = c6 * t162 + s6 * t165;
        let t883 = c6 * t165 - s6 * t162;
        let t885 = c5 * t880 - t577;
        let t887 = t580 + s5 * t880;
        let t894 = A * t887;
        let t895 = c5 * t748 - L3 * t887;
        let t896 = A * t883 - L3 * t885 - s5 * t748;
        let t897 = t745 + t894;
        let t903 = t895 + t355 * t887;
        let t904 = t352 * t887 - t897;
        let t905 = t896 + (t355 * t885 - t352 * t883);
        let t910 = z1_4_x * t903 + z1_4_y * t904 - z1_3_y * t905;
        let t915 = z2_4_x * t903 - t229 * t904 - c3 * t905;
        let t919 = t894 + (s4 * t895 - c4 * t897);
        put(41, t910); // row 1, MSZ6
        put(102, t915); // row 2, MSZ6
        put(153, t919); // row 3, MSZ6
        put(194, t896); // row 4, MSZ6
    }
    // XX6: column
    let [t921, t924, t927, t932, t937, t942] = {
        let t921 = s6 * t171;
        let t922 = c6 * dw6_x + t921;
        let t924 = c6 * t171;
        let t925 = s6 * dw6_x - t924;
        let t927 = t170 * t235;
        let t930 = z1_4_y * t925 + (z1_5_x * t922 + t927);
        let t932 = t170 * t241;
        let t935 = z2_5_x * t922 + t932 - t229 * t925;
        let t937 = t170 * z3_6_z;
        let t940 = c4 * t925 + (z3_5_x * t922 + t937);
        let t942 = c5 * t170;
        let t943 = t942 - s5 * t922;
        put(42, t930); // row 1, XX6
        put(103, t935); // row 2, XX6
        put(154, t940); // row 3, XX6
        put(195, t943); // row 4, XX6
        put(225, t925); // row 5, XX6
        [t921, t924, t927, t932, t937, t942]
    };
    // YY6: column
    let [t944, t947, t957] = {
        let t944 = c6 * t172;
        let t946 = t944 + s6 * dw6_y;
        let t947 = s6 * t172;
        let t949 = c6 * dw6_y - t947;
        let t953 = z1_4_y * t949 - (t927 + z1_5_x * t946);
        let t957 = t229 * t949 + (t932 + z2_5_x * t946);
        let t961 = c4 * t949 - (t937 + z3_5_x * t946);
        let t963 = s5 * t946 - t942;
        put(43, t953); // row 1, YY6
        put(155, t961); // row 3, YY6
        put(196, t963); // row 4, YY6
        put(226, t949); // row 5, YY6
        [t944, t947, t957]
    };
    // ZZ6: column
    {
        let t964 = t944 - t921;
        let t965 = t924 + t947;
        let t970 = z1_4_y * t965 + (z1_5_x * t964 + dw6_z * t235);
        let t975 = z2_5_x * t964 + dw6_z * t241 - t229 * t965;
        let t980 = c4 * t965 + (z3_5_x * t964 + dw6_z * z3_6_z);
        let t983 = c5 * dw6_z - s5 * t964;
        put(44, t970); // row 1, ZZ6
        put(105, t975); // row 2, ZZ6
        put(156, t980); // row 3, ZZ6
        put(197, t983); // row 4, ZZ6
        put(227, t965); // row 5, ZZ6
    }
    // XY6: column
    {
        let t984 = t179 - t176;
        let t987 = s6 * t181 - c6 * t180;
        let t990 = s6 * t180 + c6 * t181;
        let t995 = z1_4_y * t990 - (z1_5_x * t987 - t235 * t984);
        let t1000 = t241 * t984 - z2_5_x * t987 - t229 * t990;
        let t1005 = c4 * t990 + (z3_6_z * t984 - z3_5_x * t987);
        let t1008 = s5 * t987 + c5 * t984;
        put(45, t995); // row 1, XY6
        put(106, t1000); // row 2, XY6
        put(157, t1005); // row 3, XY6
        put(198, t1008); // row 4, XY6
        put(228, t990); // row 5, XY6
        put(249, t984); // row 6, XY6
    }
    // XZ6: column
    {
        let t1010 = t784 + s6 * t175;
        let t1012 = t781 - c6 * t175;
        let t1017 = z1_4_y * t1012 + (z1_5_x * t1010 + t165 * t235);
        let t1022 = z2_5_x * t1010 + t165 * t241 - t229 * t1012;
        let t1027 = c4 * t1012 + (z3_5_x * t1010 + t165 * z3_6_z);
        let t1030 = c5 * t165 - s5 * t1010;
        put(46, t1017); // row 1, XZ6
        put(107, t1022); // row 2, XZ6
        put(158, t1027); // row 3, XZ6
        put(199, t1030); // row 4, XZ6
        put(229, t1012); // row 5, XZ6
    }
    // YZ6: column
    {
        let t1031 = t145 - t179;
        let t1033 = t833 - c6 * t1031;
        let t1035 = t830 + s6 * t1031;
        let t1040 = z1_4_y * t1035 + (t162 * t235 - z1_5_x * t1033);
        let t1045 = t162 * t241 - z2_5_x * t1033 - t229 * t1035;
        let t1050 = c4 * t1035 + (t162 * z3_6_z - z3_5_x * t1033);
        let t1053 = s5 * t1033 + c5 * t162;
        put(47, t1040); // row 1, YZ6
        put(108, t1045); // row 2, YZ6
        put(159, t1050); // row 3, YZ6
        put(200, t1053); // row 4, YZ6
        put(230, t1035); // row 5, YZ6
    }
    // M7: column
    let [t1056, t1059] = {
        let t1056 = c7 * t190 + s7 * a7_y;
        let t1059 = s7 * t190 - c7 * a7_y;
        let t1060 = k4 * t186;
        let t1061 = k4 * t1059;
        let t1064 = c6 * t1056 + s6 * t186;
        let t1067 = s6 * t1056 - c6 * t186;
        let t1068 = s6 * t1061;
        let t1069 = c6 * t1061;
        let t1072 = c5 * t1064 + s5 * t1059;
        let t1075 = s5 * t1064 - c5 * t1059;
        let t1086 = A * t1075;
        let t1087 = s5 * t1060 - c5 * t1068 + L3 * t1075;
        let t1088 = s5 * t1068 + c5 * t1060 + (L3 * t1072 + A * t1067);
        let t1089 = t1069 + t1086;
        let t1095 = t1087 - t355 * t1075;
        let t1096 = t352 * t1075 - t1089;
        let t1097 = t352 * t1067 + t355 * t1072 - t1088;
        let t1102 = z1_3_y * t1097 + (z1_4_x * t1095 - z1_4_y * t1096);
        let t1107 = c3 * t1097 + (z2_4_x * t1095 + t229 * t1096);
        let t1111 = s4 * t1087 + c4 * t1089 - t1086;
        put(48, t1102); // row 1, M7
        put(109, t1107); // row 2, M7
        put(160, t1111); // row 3, M7
        put(201, t1088); // row 4, M7
        put(231, t1069); // row 5, M7
        put(252, t1060); // row 6, M7
        [t1056, t1059]
    };
    // MSX7: column
    let [t1113, t1116, t1118, t1119] = {
        let t1113 = s7 * t218;
        let t1114 = c7 * t216 + t1113;
        let t1116 = c7 * t218;
        let t1117 = s7 * t216 - t1116;
        let t1118 = s7 * t186;
        let t1119 = c7 * t186;
        let t1122 = t1119 + k4 * t220;
        let t1123 = k4 * t1117 - a7_y;
        let t1126 = c6 * t1114 + s6 * t220;
        let t1129 = s6 * t1114 - c6 * t220;
        let t1132 = c6 * t1118 + s6 * t1123;
        let t1135 = c6 * t1123 - s6 * t1118;
        let t1138 = c5 * t1126 + s5 * t1117;
        let t1141 = c5 * t1117 - s5 * t1126;
        let t1152 = A * t1141;
        let t1153 = s5 * t1122 - c5 * t1132 - L3 * t1141;
        let t1154 = s5 * t1132 + c5 * t1122 + (L3 * t1138 + A * t1129);
        let t1155 = t1135 - t1152;
        let t1161 = t1153 + t355 * t1141;
        let t1162 = t1155 + t352 * t1141;
        let t1163 = t352 * t1129 + t355 * t1138 - t1154;
        let t1168 = z1_3_y * t1163 + (z1_4_x * t1161 + z1_4_y * t1162);
        let t1173 = c3 * t1163 + (z2_4_x * t1161 - t229 * t1162);
        let t1177 = t1152 + (s4 * t1153 + c4 * t1155);
        put(49, t1168); // row 1, MSX7
        put(110, t1173); // row 2, MSX7
        put(161, t1177); // row 3, MSX7
        put(202, t1154); // row 4, MSX7
        put(232, t1135); // row 5, MSX7
        put(253, t1122); // row 6, MSX7
        [t1113, t1116, t1118, t1119]
    };
    // MSY7: column
    let [t1178, t1181] = {
        let t1178 = c7 * t217;
        let t1180 = t1178 - s7 * t219;
        let t1181 = s7 * t217;
        let t1183 = t1181 + c7 * t219;
        let t1186 = k4 * t221 - t1118;
        let t1187 = k4 * t1183 - t190;
        let t1190 = c6 * t1180 + s6 * t221;
        let t1193 = c6 * t221 - s6 * t1180;
        let t1196 = c6 * t1119 + s6 * t1187;
        let t1199 = c6 * t1187 - s6 * t1119;
        let t1202 = c5 * t1190 + s5 * t1183;
        let t1205 = s5 * t1190 - c5 * t1183;
        let t1216 = A * t1205;
        let t1217 = L3 * t1205 - (c5 * t1196 - s5 * t1186);
        let t1218 = s5 * t1196 + c5 * t1186 - (A * t1193 - L3 * t1202);
        let t1219 = t1199 + t1216;
        let t1225 = t1217 - t355 * t1205;
        let t1226 = t352 * t1205 - t1219;
        let t1227 = t355 * t1202 - t352 * t1193 - t1218;
        let t1232 = z1_3_y * t1227 + (z1_4_x * t1225 - z1_4_y * t1226);
        let t1237 = c3 * t1227 + (z2_4_x * t1225 + t229 * t1226);
        let t1241 = s4 * t1217 + c4 * t1219 - t1216;
        put(50, t1232); // row 1, MSY7
        put(111, t1237); // row 2, MSY7
        put(162, t1241); // row 3, MSY7
        put(203, t1218); // row 4, MSY7
        put(233, t1199); // row 5, MSY7
        put(254, t1186); // row 6, MSY7
        [t1178, t1181]
    };
    // MSZ7: column
    {
        let t1244 = c7 * t202 + s7 * t205;
        let t1247 = c7 * t205 - s7 * t202;
        let t1249 = k4 * t1247;
        let t1250 = k4 * t179 - t1056;
        let t1252 = t831 - c6 * t1244;
        let t1254 = t834 + s6 * t1244;
        let t1257 = s6 * t1249 - c6 * t1059;
        let t1260 = s6 * t1059 + c6 * t1249;
        let t1263 = c5 * t1252 + s5 * t1247;
        let t1266 = s5 * t1252 - c5 * t1247;
        let t1277 = A * t1266;
        let t1278 = s5 * t1250 - c5 * t1257 + L3 * t1266;
        let t1279 = s5 * t1257 + c5 * t1250 + (L3 * t1263 - A * t1254);
        let t1280 = t1260 + t1277;
        let t1286 = t1278 - t355 * t1266;
        let t1287 = t352 * t1266 - t1280;
        let t1288 = t355 * t1263 - t352 * t1254 - t1279;
        let t1293 = z1_3_y * t1288 + (z1_4_x * t1286 - z1_4_y * t1287);
        let t1298 = c3 * t1288 + (z2_4_x * t1286 + t229 * t1287);
        let t1302 = s4 * t1278 + c4 * t1280 - t1277;
        put(51, t1293); // row 1, MSZ7
        put(112, t1298); // row 2, MSZ7
        put(163, t1302); // row 3, MSZ7
        put(204, t1279); // row 4, MSZ7
        put(234, t1260); // row 5, MSZ7
        put(255, t1250); // row 6, MSZ7
    }
    // XX7: column
    let [t1304, t1307, t1310, t1313] = {
        let t1304 = s7 * t211;
        let t1305 = c7 * dw7_x + t1304;
        let t1307 = c7 * t211;
        let t1308 = s7 * dw7_x - t1307;
        let t1310 = s6 * t210;
        let t1311 = c6 * t1305 - t1310;
        let t1313 = c6 * t210;
        let t1314 = s6 * t1305 + t1313;
        let t1319 = z1_4_y * t1314 + (z1_5_x * t1311 + t235 * t1308);
        let t1324 = z2_5_x * t1311 + t241 * t1308 - t229 * t1314;
        let t1329 = c4 * t1314 + (z3_5_x * t1311 + z3_6_z * t1308);
        let t1332 = c5 * t1308 - s5 * t1311;
        put(52, t1319); // row 1, XX7
        put(113, t1324); // row 2, XX7
        put(164, t1329); // row 3, XX7
        put(205, t1332); // row 4, XX7
        put(235, t1314); // row 5, XX7
        put(256, t1308); // row 6, XX7
        [t1304, t1307, t1310, t1313]
    };
    // YY7: column
    let [t1333, t1336] = {
        let t1333 = c7 * t212;
        let t1335 = t1333 - s7 * t214;
        let t1336 = s7 * t212;
        let t1338 = t1336 + c7 * t214;
        let t1340 = t1310 + c6 * t1335;
        let t1342 = s6 * t1335 - t1313;
        let t1347 = z1_4_y * t1342 + (z1_5_x * t1340 + t235 * t1338);
        let t1352 = z2_5_x * t1340 + t241 * t1338 - t229 * t1342;
        let t1357 = c4 * t1342 + (z3_5_x * t1340 + z3_6_z * t1338);
        let t1360 = c5 * t1338 - s5 * t1340;
        put(53, t1347); // row 1, YY7
        put(114, t1352); // row 2, YY7
        put(165, t1357); // row 3, YY7
        put(206, t1360); // row 4, YY7
        put(236, t1342); // row 5, YY7
        put(257, t1338); // row 6, YY7
        [t1333, t1336]
    };
    // ZZ7: column
    let t1368 = {
        let t1361 = t1304 + t1333;
        let t1362 = t1307 - t1336;
        let t1365 = c6 * t1361 - s6 * dw7_z;
        let t1368 = s6 * t1361 + c6 * dw7_z;
        let t1373 = t235 * t1362 - z1_5_x * t1365 - z1_4_y * t1368;
        let t1378 = t229 * t1368 + (t241 * t1362 - z2_5_x * t1365);
        let t1383 = z3_6_z * t1362 - z3_5_x * t1365 - c4 * t1368;
        let t1386 = s5 * t1365 + c5 * t1362;
        put(54, t1373); // row 1, ZZ7
        put(115, t1378); // row 2, ZZ7
        put(166, t1383); // row 3, ZZ7
        put(207, t1386); // row 4, ZZ7
        put(258, t1362); // row 6, ZZ7
        t1368
    };
    // XY7: column
    {
        let t1387 = t219 - t216;
        let t1390 = c7 * t220 + s7 * t221;
        let t1393 = s7 * t220 - c7 * t221;
        let t1396 = c6 * t1390 + s6 * t1387;
        let t1399 = s6 * t1390 - c6 * t1387;
        let t1404 = z1_4_y * t1399 + (z1_5_x * t1396 + t235 * t1393);
        let t1409 = z2_5_x * t1396 + t241 * t1393 - t229 * t1399;
        let t1414 = c4 * t1399 + (z3_5_x * t1396 + z3_6_z * t1393);
        let t1417 = c5 * t1393 - s5 * t1396;
        put(55, t1404); // row 1, XY7
        put(116, t1409); // row 2, XY7
        put(167, t1414); // row 3, XY7
        put(208, t1417); // row 4, XY7
        put(238, t1399); // row 5, XY7
        put(259, t1393); // row 6, XY7
        put(270, t1387); // row 7, XY7
    }
    // XZ7: column
    {
        let t1419 = t1116 + s7 * t215;
        let t1421 = t1113 - c7 * t215;
        let t1424 = c6 * t1419 + s6 * t205;
        let t1427 = s6 * t1419 - c6 * t205;
        let t1432 = z1_4_y * t1427 + (z1_5_x * t1424 + t235 * t1421);
        let t1437 = z2_5_x * t1424 + t241 * t1421 - t229 * t1427;
        let t1442 = c4 * t1427 + (z3_5_x * t1424 + z3_6_z * t1421);
        let t1445 = c5 * t1421 - s5 * t1424;
        put(56, t1432); // row 1, XZ7
        put(117, t1437); // row 2, XZ7
        put(168, t1442); // row 3, XZ7
        put(209, t1445); // row 4, XZ7
        put(239, t1427); // row 5, XZ7
        put(260, t1421); // row 6, XZ7
    }
    // YZ7: column
    {
        let t1446 = t179 - t219;
        let t1448 = c7 * t1446 - t1181;
        let t1450 = t1178 + s7 * t1446;
        let t1453 = c6 * t1448 + s6 * t202;
        let t1456 = s6 * t1448 - c6 * t202;
        let t1461 = z1_4_y * t1456 + (z1_5_x * t1453 + t235 * t1450);
        let t1466 = z2_5_x * t1453 + t241 * t1450 - t229 * t1456;
        let t1471 = c4 * t1456 + (z3_5_x * t1453 + z3_6_z * t1450);
        let t1474 = c5 * t1450 - s5 * t1453;
        let t1475 = dq1.sign();
        let t1476 = dq2.sign();
        let t1477 = dq3.sign();
        let t1478 = dq4.sign();
        let t1479 = dq5.sign();
        let t1480 = dq6.sign();
        let t1481 = dq7.sign();
        let t1482 = -t2;
        let t1483 = -t9;
        let t1484 = -t5;
        let t1485 = -t6;
        let t1486 = -t273;
        let t1487 = -t684;
        let t1488 = -t957;
        let t1489 = -t50;
        let t1490 = -t410;
        let t1491 = -t90;
        let t1492 = -t742;
        let t1493 = -t136;
        let t1494 = -t128;
        let t1495 = -t786;
        let t1496 = -t745;
        let t1497 = -t1368;
        let t1498 = -t170;
        let t1499 = -t210;
        put(57, t1461); // row 1, YZ7
        put(59, t1475); // row 1, FC1
        put(61, t1482); // row 2, MSX2
        put(63, t1483); // row 2, XX2
        put(67, t1484); // row 2, XZ2
        put(68, t1485); // row 2, YZ2
        put(69, t1486); // row 2, M3
        put(95, t1487); // row 2, ZZ5
        put(104, t1488); // row 2, YY6
        put(118, t1466); // row 2, YZ7
        put(120, t1476); // row 2, FC2
        put(125, t1489); // row 3, YY3
        put(132, t1490); // row 3, MSY4
        put(169, t1471); // row 3, YZ7
        put(171, t1477); // row 3, FC3
        put(176, t1491); // row 4, YY4
        put(190, t1492); // row 4, YZ5
        put(210, t1474); // row 4, YZ7
        put(212, t1478); // row 4, FC4
        put(216, t1493); // row 5, XX5
        put(221, t1494); // row 5, YZ5
        put(223, t1495); // row 5, MSY6
        put(224, t1496); // row 5, MSZ6
        put(237, t1497); // row 5, ZZ7
        put(240, t1456); // row 5, YZ7
        put(242, t1479); // row 5, FC5
        put(247, t1498); // row 6, YY6
        put(261, t1450); // row 6, YZ7
        put(263, t1480); // row 6, FC6
        put(267, t1499); // row 7, XX7
        put(274, t1481); // row 7, FC7
    }
}
