//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4.
//!
//! 308 multiplications, 243 additions; 6 x 58, 161 of 348 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 161;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11),
    (0, 12), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18), (0, 19), (0, 20), (0, 21),
    (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28), (0, 29), (0, 30), (0, 31),
    (0, 32), (0, 33), (0, 34), (0, 35), (0, 40), (0, 46), (0, 52), (1, 1), (1, 2), (1, 3),
    (1, 4), (1, 5), (1, 6), (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (1, 12), (1, 13),
    (1, 14), (1, 15), (1, 16), (1, 17), (1, 18), (1, 19), (1, 20), (1, 21), (1, 22), (1, 23),
    (1, 24), (1, 25), (1, 26), (1, 27), (1, 28), (1, 29), (1, 30), (1, 31), (1, 32), (1, 33),
    (1, 34), (1, 35), (1, 41), (1, 47), (1, 53), (2, 8), (2, 9), (2, 10), (2, 11), (2, 12),
    (2, 13), (2, 14), (2, 15), (2, 16), (2, 17), (2, 18), (2, 19), (2, 20), (2, 21), (2, 22),
    (2, 23), (2, 24), (2, 25), (2, 26), (2, 27), (2, 28), (2, 29), (2, 30), (2, 31), (2, 32),
    (2, 33), (2, 34), (2, 35), (2, 36), (2, 42), (2, 48), (2, 54), (3, 15), (3, 16), (3, 17),
    (3, 18), (3, 19), (3, 20), (3, 21), (3, 22), (3, 23), (3, 24), (3, 25), (3, 26), (3, 27),
    (3, 28), (3, 29), (3, 30), (3, 31), (3, 32), (3, 33), (3, 34), (3, 35), (3, 37), (3, 43),
    (3, 49), (3, 55), (4, 22), (4, 23), (4, 24), (4, 25), (4, 26), (4, 27), (4, 28), (4, 29),
    (4, 30), (4, 31), (4, 32), (4, 33), (4, 34), (4, 35), (4, 38), (4, 44), (4, 50), (4, 56),
    (5, 29), (5, 30), (5, 31), (5, 32), (5, 33), (5, 34), (5, 35), (5, 39), (5, 45), (5, 51),
    (5, 57),
];

/// Regressor `W_b` of the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 58]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    flat[1..3].fill(S::default());
    flat[36..40].fill(S::default());
    flat[41..46].fill(S::default());
    flat[47..52].fill(S::default());
    flat[53..59].fill(S::default());
    flat[94..99].fill(S::default());
    flat[100..105].fill(S::default());
    flat[106..111].fill(S::default());
    flat[112..124].fill(S::default());
    flat[153..158].fill(S::default());
    flat[159..164].fill(S::default());
    flat[165..170].fill(S::default());
    flat[171..189].fill(S::default());
    flat[210] = S::default();
    flat[212..217].fill(S::default());
    flat[218..223].fill(S::default());
    flat[224..229].fill(S::default());
    flat[230..254].fill(S::default());
    flat[268..270].fill(S::default());
    flat[271..276].fill(S::default());
    flat[277..282].fill(S::default());
    flat[283..288].fill(S::default());
    flat[289..319].fill(S::default());
    flat[326..329].fill(S::default());
    flat[330..335].fill(S::default());
    flat[336..341].fill(S::default());
    flat[342..347].fill(S::default());
    nonzeros(trig, dq, ddq, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 58]; 6]) {
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
        put(0, ddq1); // row 1, ZZ1R
        put(34, dq1); // row 1, FV1
        put(36, k7); // row 1, FO1
        put(40, ddq2); // row 2, ZZ2R
        put(72, dq2); // row 2, FV2
        put(74, k7); // row 2, FO2
        put(103, ddq3); // row 3, IA3
        put(104, dq3); // row 3, FV3
        put(106, k7); // row 3, FO3
        put(128, ddq4); // row 4, IA4
        put(129, dq4); // row 4, FV4
        put(131, k7); // row 4, FO4
        put(146, ddq5); // row 5, IA5
        put(147, dq5); // row 5, FV5
        put(149, k7); // row 5, FO5
        put(157, ddq6); // row 6, IA6
        put(158, dq6); // row 6, FV6
        put(160, k7); // row 6, FO6
        t0
    };
    // link 2: motion
    let [
        a2_x, a2_y, t9, t10, t11, dw2_x, t14, t15,
        t16, t17, t18, t19, t20,
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
        put(37, a2_y); // row 2, MSX2R
        put(42, t5); // row 2, XZ2R
        put(43, t6); // row 2, YZ2
        [
        a2_x, a2_y, t9, t10, t11, dw2_x, t14, t15,
        t16, t17, t18, t19, t20,
    ]
    };
    // link 3: motion
    let [
        z1_3_x, z1_3_y, w3_z, dw3_z, t31, t36, a3_y, t40,
        t41, t46, t47, t48, dw3_x, t51, t52, t53,
        t54, t55, t56, t57,
    ] = {
        let z1_3_x = s2 * c3 + c2 * s3;
        let z1_3_y = c2 * c3 - s2 * s3;
        let w3_z = dq2 + dq3;
        let dw3_z = ddq2 + ddq3;
        let t31 = t19 * k1;
        let t32 = t15 * k1 - a2_x;
        let t33 = t17 * k1 - a2_y;
        let t36 = c3 * t32 + s3 * t33;
        let a3_y = s3 * t32 - c3 * t33;
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
        let t51 = t45 - t44;
        let t52 = t0 + t51;
        let t53 = dw3_z - t46;
        let t54 = dw3_z + t46;
        let t55 = t44 + t45;
        let t56 = t47 + (t47 - t40);
        let t57 = t48 + dw3_x;
        put(47, dw3_z); // row 2, ZZ3R
        put(49, t41); // row 2, XZ3R
        put(50, t40); // row 2, YZ3
        put(75, a3_y); // row 3, MSX3R
        put(76, t36); // row 3, MSY3
        put(78, dw3_z); // row 3, ZZ3R
        put(80, t41); // row 3, XZ3R
        put(81, t40); // row 3, YZ3
        [
        z1_3_x, z1_3_y, w3_z, dw3_z, t31, t36, a3_y, t40,
        t41, t46, t47, t48, dw3_x, t51, t52, t53,
        t54, t55, t56, t57,
    ]
    };
    // link 4: motion
    let [
        z1_4_x, t63, w4_z, t77, t80, a4_y, t84, w4_x,
        t87, t91, t92, dw4_x, t94, t95, t96, t97,
        t98, t99, t100, t101,
    ] = {
        let z1_4_x = c4 * z1_3_x + s4 * z1_3_y;
        let t63 = s4 * z1_3_x - c4 * z1_3_y;
        let w4_z = w3_z + dq4;
        let dw4_z = dw3_z + ddq4;
        let t75 = t36 - (t52 * k2 + D4 * t40);
        let t76 = t54 * k2 + D4 * t41 - a3_y;
        let t77 = t31 - (t56 * k2 + D4 * t0);
        let t80 = c4 * t75 + s4 * t76;
        let a4_y = s4 * t75 - c4 * t76;
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
        let t95 = t88 - t89;
        let t96 = t95 - t0;
        let t97 = dw4_z + t90;
        let t98 = t90 - dw4_z;
        let t99 = t88 + t89;
        let t100 = t91 + t94;
        let t101 = t92 - dw4_x;
        put(53, t90); // row 2, XX4R
        put(54, dw4_z); // row 2, ZZ4R
        put(56, t85); // row 2, XZ4
        put(84, t90); // row 3, XX4R
        put(85, dw4_z); // row 3, ZZ4R
        put(87, t85); // row 3, XZ4
        put(107, a4_y); // row 4, MSX4
        put(108, t80); // row 4, MSY4R
        put(109, t90); // row 4, XX4R
        put(110, dw4_z); // row 4, ZZ4R
        put(112, t85); // row 4, XZ4
        [
        z1_4_x, t63, w4_z, t77, t80, a4_y, t84, w4_x,
        t87, t91, t92, dw4_x, t94, t95, t96, t97,
        t98, t99, t100, t101,
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
        let t136 = t133 - t124;
        let t137 = t130 - t131;
        let t138 = t137 - t99;
        let t139 = t132 - dw5_z;
        let t140 = dw5_z + t132;
        let t141 = t130 + t131;
        let t142 = t133 + t136;
        let t143 = t134 + dw5_x;
        put(132, a5_y); // row 5, MSX5
        put(133, t112); // row 5, MSY5R
        put(135, dw5_z); // row 5, ZZ5R
        put(137, t127); // row 5, XZ5
        put(138, t124); // row 5, YZ5
        [
        z1_5_x, t103, t108, t112, a5_y, w5_x, w5_y, t124,
        t127, w5_z, dw5_z, t132, t133, t134, dw5_x, t136,
        t137, t138, t139, t140, t141, t142, t143,
    ]
    };
    // link 6: motion
    let [
        t148, t152, a6_y, t164, t167, dw6_z, t172, t173,
        t174, t175, t177, t178, t179, t180, t181, t182,
        t183,
    ] = {
        let t147 = t112 - D6 * t139;
        let t148 = a5_y - D6 * t141;
        let t149 = D6 * t143 - t108;
        let t152 = c6 * t147 + s6 * t149;
        let a6_y = s6 * t147 - c6 * t149;
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t161 = c6 * w5_z + s6 * w5_x;
        let t164 = c6 * t139 - s6 * t143;
        let t167 = c6 * t143 + s6 * t139;
        let w6_z = w5_y + dq6;
        let dw6_z = ddq6 - t136;
        let t170 = w6_x * w6_x;
        let t171 = w6_z * w6_z;
        let t172 = w6_x * t161;
        let t173 = w6_x * w6_z;
        let t174 = t161 * w6_z;
        let t175 = t174 - t167;
        let t177 = t170 - t171;
        let t178 = t141 - t177;
        let t179 = dw6_z + t172;
        let t180 = t172 - dw6_z;
        let t181 = t170 + t171;
        let t182 = t173 + (t173 - t164);
        let t183 = t174 + t175;
        put(150, a6_y); // row 6, MSX6
        put(151, t152); // row 6, MSY6
        put(152, t172); // row 6, XX6R
        put(153, dw6_z); // row 6, ZZ6
        put(155, t167); // row 6, XZ6
        put(156, t164); // row 6, YZ6
        [
        t148, t152, a6_y, t164, t167, dw6_z, t172, t173,
        t174, t175, t177, t178, t179, t180, t181, t182,
        t183,
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
    let [v1_4_z, v1_4_x, v1_5_z, t200, t203, t204, v3_5_z] = {
        let t187 = D4 * z1_3_y;
        let t188 = D4 * z1_3_x;
        let v1_4_z = v1_3_z + z1_3_y * k2;
        let v1_4_x = c4 * t187 - s4 * t188;
        let v1_5_z = c4 * t188 + s4 * t187;
        let t197 = t186 - A3;
        let t200 = c4 * t185 + s4 * t197;
        let t203 = c4 * t197 - s4 * t185;
        let t204 = s4 * k2;
        let v3_5_z = c4 * k2;
        [v1_4_z, v1_4_x, v1_5_z, t200, t203, t204, v3_5_z]
    };
    // XX2: column
    let t207 = {
        let t207 = c2 * t10;
        let t208 = s2 * dw2_x + t207;
        put(1, t208); // row 1, XX2R
        t207
    };
    // ZZ2: column
    {
        let t210 = s2 * t11 - t207;
        put(2, t210); // row 1, ZZ2R
    }
    // XY2: column
    {
        let t211 = t15 + t18;
        let t214 = s2 * t19 + c2 * t20;
        put(3, t214); // row 1, XY2
        put(41, t211); // row 2, XY2
    }
    // XZ2: column
    {
        let t217 = s2 * t17 - c2 * t14;
        put(4, t217); // row 1, XZ2R
    }
    // YZ2: column
    {
        let t221 = c2 * t16 - s2 * (t18 - t0);
        put(5, t221); // row 1, YZ2
    }
    // MSX3: column
    {
        let t224 = t56 * v1_3_z - z1_3_y * t31;
        let t228 = a3_y + (t52 * t185 - t54 * t186);
        put(6, t224); // row 1, MSX3R
        put(44, t228); // row 2, MSX3R
    }
    // MSY3: column
    {
        let t231 = z1_3_x * t31 + t57 * v1_3_z;
        let t235 = t36 + (t53 * t185 + t55 * t186);
        put(7, t231); // row 1, MSY3
        put(45, t235); // row 2, MSY3
    }
    // XX3: column
    let t237 = {
        let t237 = z1_3_y * t47;
        let t238 = z1_3_x * dw3_x + t237;
        put(8, t238); // row 1, XX3R
        t237
    };
    // ZZ3: column
    {
        let t240 = z1_3_x * t48 - t237;
        put(9, t240); // row 1, ZZ3R
    }
    // XY3: column
    {
        let t241 = t55 - t52;
        let t244 = z1_3_y * t57 - z1_3_x * t56;
        put(10, t244); // row 1, XY3
        put(48, t241); // row 2, XY3
        put(79, t241); // row 3, XY3
    }
    // XZ3: column
    {
        let t247 = z1_3_x * t54 + z1_3_y * t51;
        put(11, t247); // row 1, XZ3R
    }
    // YZ3: column
    {
        let t251 = z1_3_x * (t0 - t55) + z1_3_y * t53;
        put(12, t251); // row 1, YZ3
    }
    // MSX4: column
    {
        let t258 = t63 * t77 + (t100 * v1_4_z + (t96 * v1_4_x + t98 * v1_5_z));
        let t262 = a4_y + (t98 * t203 - t96 * t200);
        let t266 = a4_y + (t98 * v3_5_z - t96 * t204);
        put(13, t258); // row 1, MSX4
        put(51, t262); // row 2, MSX4
        put(82, t266); // row 3, MSX4
    }
    // MSY4: column
    {
        let t273 = z1_4_x * t77 - (t101 * v1_4_z - (t99 * v1_5_z - t97 * v1_4_x));
        let t277 = t80 + (t97 * t200 + t99 * t203);
        let t281 = t80 + (t97 * t204 + t99 * v3_5_z);
        put(14, t273); // row 1, MSY4R
        put(52, t277); // row 2, MSY4R
        put(83, t281); // row 3, MSY4R
    }
    // XX4: column
    let t283 = {
        let t283 = t63 * t91;
        let t284 = z1_4_x * dw4_x - t283;
        put(15, t284); // row 1, XX4R
        t283
    };
    // ZZ4: column
    {
        let t286 = t283 - z1_4_x * t92;
        put(16, t286); // row 1, ZZ4R
    }
    // XY4: column
    {
        let t287 = t96 + t99;
        let t290 = t63 * t101 - z1_4_x * t100;
        put(17, t290); // row 1, XY4
        put(55, t287); // row 2, XY4
        put(86, t287); // row 3, XY4
        put(111, t287); // row 4, XY4
    }
    // XZ4: column
    {
        let t293 = t63 * t95 - z1_4_x * t98;
        put(18, t293); // row 1, XZ4
    }
    // YZ4: column
    {
        let t297 = z1_4_x * (t0 - t99) - t63 * t97;
        put(19, t297); // row 1, YZ4
    }
    // MSX5: column
    let [t299, t304, t305] = {
        let t299 = s5 * t140;
        let t300 = c5 * t138 - t299;
        let t303 = s5 * t138 + c5 * t140;
        let t304 = s5 * t108;
        let t305 = c5 * t108;
        let t309 = t305 + D5 * t300;
        let t312 = z1_4_x * (t304 + D5 * t303) - t63 * a5_y;
        let t318 = v1_4_z * t303 + (v1_4_x * t300 + t142 * v1_5_z) - t312;
        let t322 = t309 + (t142 * t203 - t200 * t300);
        let t326 = t309 + (t142 * v3_5_z - t204 * t300);
        put(20, t318); // row 1, MSX5
        put(58, t322); // row 2, MSX5
        put(89, t326); // row 3, MSX5
        put(114, t309); // row 4, MSX5
        [t299, t304, t305]
    };
    // MSY5: column
    let t327 = {
        let t327 = c5 * t139;
        let t329 = t327 + s5 * t141;
        let t332 = s5 * t139 - c5 * t141;
        let t336 = D5 * t329 - t304;
        let t344 = v1_4_z * t332 + (v1_4_x * t329 + t143 * v1_5_z);
        let t345 = t63 * t112 - z1_4_x * (t305 + D5 * t332) + t344;
        let t349 = t336 - (t200 * t329 - t143 * t203);
        let t353 = t336 + (t143 * v3_5_z - t204 * t329);
        put(21, t345); // row 1, MSY5R
        put(59, t349); // row 2, MSY5R
        put(90, t353); // row 3, MSY5R
        put(115, t336); // row 4, MSY5R
        t327
    };
    // XX5: column
    let [t355, t360] = {
        let t355 = t103 * t133;
        let t358 = z1_5_x * dw5_x - t355 - t63 * t132;
        let t360 = c5 * t133;
        let t361 = s5 * dw5_x + t360;
        put(22, t358); // row 1, XX5R
        put(60, t361); // row 2, XX5R
        put(91, t361); // row 3, XX5R
        put(116, t361); // row 4, XX5R
        [t355, t360]
    };
    // ZZ5: column
    {
        let t365 = t63 * dw5_z + (t355 + z1_5_x * t134);
        let t367 = s5 * t134 - t360;
        put(23, t365); // row 1, ZZ5R
        put(61, t367); // row 2, ZZ5R
        put(92, t367); // row 3, ZZ5R
        put(117, t367); // row 4, ZZ5R
    }
    // XY5: column
    {
        let t368 = t138 + t141;
        let t373 = t63 * t368 - (z1_5_x * t142 + t103 * t143);
        let t376 = c5 * t143 - s5 * t142;
        put(24, t373); // row 1, XY5
        put(62, t376); // row 2, XY5
        put(93, t376); // row 3, XY5
        put(118, t376); // row 4, XY5
        put(136, t368); // row 5, XY5
    }
    // XZ5: column
    {
        let t381 = t63 * t127 + (z1_5_x * t140 + t103 * t137);
        let t383 = t299 - c5 * t137;
        put(25, t381); // row 1, XZ5
        put(63, t383); // row 2, XZ5
        put(94, t383); // row 3, XZ5
        put(119, t383); // row 4, XZ5
    }
    // YZ5: column
    {
        let t384 = t99 - t141;
        let t389 = t63 * t124 + (z1_5_x * t384 + t103 * t139);
        let t391 = s5 * t384 - t327;
        put(26, t389); // row 1, YZ5
        put(64, t391); // row 2, YZ5
        put(95, t391); // row 3, YZ5
        put(120, t391); // row 4, YZ5
    }
    // MSX6: column
    let [t393, t396, t398, t399] = {
        let t393 = s6 * t180;
        let t394 = c6 * t178 - t393;
        let t396 = c6 * t180;
        let t397 = s6 * t178 + t396;
        let t398 = s6 * t148;
        let t399 = c6 * t148;
        let t402 = t398 + D6 * t397;
        let t403 = t399 + D6 * t394;
        let t406 = c5 * t394 + s5 * t182;
        let t409 = s5 * t394 - c5 * t182;
        let t419 = s5 * t402 + c5 * a6_y - D5 * t406;
        let t422 = z1_4_x * (c5 * t402 - s5 * a6_y + D5 * t409) + t63 * t403;
        let t428 = t422 - (v1_4_z * t409 + (v1_4_x * t406 - v1_5_z * t397));
        let t432 = t419 + (t200 * t406 + t203 * t397);
        let t436 = t419 + (t204 * t406 + v3_5_z * t397);
        put(27, t428); // row 1, MSX6
        put(65, t432); // row 2, MSX6
        put(96, t436); // row 3, MSX6
        put(121, t419); // row 4, MSX6
        put(139, t403); // row 5, MSX6
        [t393, t396, t398, t399]
    };
    // MSY6: column
    let [t437, t440] = {
        let t437 = c6 * t179;
        let t439 = t437 - s6 * t181;
        let t440 = s6 * t179;
        let t442 = t440 + c6 * t181;
        let t445 = t399 + D6 * t442;
        let t446 = D6 * t439 - t398;
        let t449 = c5 * t439 - s5 * t183;
        let t452 = s5 * t439 + c5 * t183;
        let t462 = s5 * t445 + c5 * t152 - D5 * t449;
        let t465 = z1_4_x * (c5 * t445 - s5 * t152 + D5 * t452) + t63 * t446;
        let t471 = t465 - (v1_4_z * t452 - (v1_5_z * t442 - v1_4_x * t449));
        let t475 = t462 + (t200 * t449 + t203 * t442);
        let t479 = t462 + (t204 * t449 + v3_5_z * t442);
        put(28, t471); // row 1, MSY6
        put(66, t475); // row 2, MSY6
        put(97, t479); // row 3, MSY6
        put(122, t462); // row 4, MSY6
        put(140, t446); // row 5, MSY6
        [t437, t440]
    };
    // XX6: column
    let [t481, t484] = {
        let t481 = s6 * t173;
        let t482 = c6 * t175 + t481;
        let t484 = c6 * t173;
        let t485 = s6 * t175 - t484;
        let t490 = t63 * t485 - (z1_5_x * t482 + t103 * t172);
        let t493 = c5 * t172 - s5 * t482;
        put(29, t490); // row 1, XX6R
        put(67, t493); // row 2, XX6R
        put(98, t493); // row 3, XX6R
        put(123, t493); // row 4, XX6R
        put(141, t485); // row 5, XX6R
        [t481, t484]
    };
    // ZZ6: column
    {
        let t495 = t481 - c6 * t174;
        let t497 = t484 + s6 * t174;
        let t502 = t63 * t497 + (z1_5_x * t495 - t103 * dw6_z);
        let t505 = s5 * t495 + c5 * dw6_z;
        put(30, t502); // row 1, ZZ6
        put(68, t505); // row 2, ZZ6
        put(99, t505); // row 3, ZZ6
        put(124, t505); // row 4, ZZ6
        put(142, t497); // row 5, ZZ6
    }
    // XY6: column
    {
        let t506 = t181 - t178;
        let t509 = c6 * t182 - s6 * t183;
        let t512 = s6 * t182 + c6 * t183;
        let t517 = t63 * t512 - (z1_5_x * t509 + t103 * t506);
        let t520 = c5 * t506 - s5 * t509;
        put(31, t517); // row 1, XY6
        put(69, t520); // row 2, XY6
        put(100, t520); // row 3, XY6
        put(125, t520); // row 4, XY6
        put(143, t512); // row 5, XY6
        put(154, t506); // row 6, XY6
    }
    // XZ6: column
    {
        let t522 = t396 - s6 * t177;
        let t524 = t393 + c6 * t177;
        let t529 = t63 * t524 - (z1_5_x * t522 + t103 * t167);
        let t532 = c5 * t167 - s5 * t522;
        put(32, t529); // row 1, XZ6
        put(70, t532); // row 2, XZ6
        put(101, t532); // row 3, XZ6
        put(126, t532); // row 4, XZ6
        put(144, t524); // row 5, XZ6
    }
    // YZ6: column
    {
        let t533 = t181 - t141;
        let t535 = t440 + c6 * t533;
        let t537 = s6 * t533 - t437;
        let t542 = t63 * t537 - (z1_5_x * t535 + t103 * t164);
        let t545 = c5 * t164 - s5 * t535;
        let t546 = dq1.sign();
        let t547 = dq2.sign();
        let t548 = dq3.sign();
        let t549 = dq4.sign();
        let t550 = dq5.sign();
        let t551 = dq6.sign();
        let t552 = -a2_x;
        let t553 = -t9;
        let t554 = -t46;
        let t555 = -t84;
        let t556 = -t132;
        put(33, t542); // row 1, YZ6
        put(35, t546); // row 1, FC1
        put(38, t552); // row 2, MSY2
        put(39, t553); // row 2, XX2R
        put(46, t554); // row 2, XX3R
        put(57, t555); // row 2, YZ4
        put(71, t545); // row 2, YZ6
        put(73, t547); // row 2, FC2
        put(77, t554); // row 3, XX3R
        put(88, t555); // row 3, YZ4
        put(102, t545); // row 3, YZ6
        put(105, t548); // row 3, FC3
        put(113, t555); // row 4, YZ4
        put(127, t545); // row 4, YZ6
        put(130, t549); // row 4, FC4
        put(134, t556); // row 5, XX5R
        put(145, t537); // row 5, YZ6
        put(148, t550); // row 5, FC5
        put(159, t551); // row 6, FC6
    }
}
