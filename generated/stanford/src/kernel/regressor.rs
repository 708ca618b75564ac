//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil and Dombre, 12.4.
//!
//! 444 multiplications, 332 additions; 6 x 66, 174 of 396 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 174;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 5), (0, 10), (0, 11), (0, 12), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18),
    (0, 19), (0, 20), (0, 21), (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28),
    (0, 29), (0, 30), (0, 31), (0, 32), (0, 33), (0, 34), (0, 35), (0, 36), (0, 37), (0, 38),
    (0, 39), (0, 40), (0, 41), (0, 42), (0, 43), (0, 44), (0, 45), (0, 46), (0, 47), (0, 48),
    (0, 49), (0, 50), (0, 51), (0, 52), (0, 53), (0, 54), (0, 55), (0, 56), (0, 57), (0, 58),
    (0, 59), (0, 60), (1, 11), (1, 13), (1, 14), (1, 15), (1, 16), (1, 17), (1, 18), (1, 19),
    (1, 20), (1, 21), (1, 22), (1, 23), (1, 24), (1, 25), (1, 26), (1, 27), (1, 28), (1, 29),
    (1, 30), (1, 31), (1, 32), (1, 33), (1, 34), (1, 35), (1, 36), (1, 37), (1, 38), (1, 39),
    (1, 40), (1, 41), (1, 42), (1, 43), (1, 44), (1, 45), (1, 46), (1, 47), (1, 48), (1, 49),
    (1, 50), (1, 51), (1, 52), (1, 53), (1, 54), (1, 55), (1, 56), (1, 57), (1, 58), (1, 59),
    (1, 61), (2, 20), (2, 21), (2, 22), (2, 23), (2, 30), (2, 31), (2, 32), (2, 33), (2, 40),
    (2, 41), (2, 42), (2, 43), (2, 50), (2, 51), (2, 52), (2, 53), (2, 62), (3, 31), (3, 33),
    (3, 34), (3, 35), (3, 36), (3, 37), (3, 38), (3, 39), (3, 41), (3, 42), (3, 43), (3, 44),
    (3, 45), (3, 46), (3, 47), (3, 48), (3, 49), (3, 50), (3, 51), (3, 52), (3, 53), (3, 54),
    (3, 55), (3, 56), (3, 57), (3, 58), (3, 59), (3, 63), (4, 41), (4, 43), (4, 44), (4, 45),
    (4, 46), (4, 47), (4, 48), (4, 49), (4, 50), (4, 51), (4, 52), (4, 53), (4, 54), (4, 55),
    (4, 56), (4, 57), (4, 58), (4, 59), (4, 64), (5, 51), (5, 52), (5, 54), (5, 55), (5, 56),
    (5, 57), (5, 58), (5, 59), (5, 65),
];

/// Regressor `W` of the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 66]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    flat[0..5].fill(S::default());
    flat[6..10].fill(S::default());
    flat[61..77].fill(S::default());
    flat[78] = S::default();
    flat[126] = S::default();
    flat[128..152].fill(S::default());
    flat[156..162].fill(S::default());
    flat[166..172].fill(S::default());
    flat[176..182].fill(S::default());
    flat[186..194].fill(S::default());
    flat[195..229].fill(S::default());
    flat[230] = S::default();
    flat[238] = S::default();
    flat[258..261].fill(S::default());
    flat[262..305].fill(S::default());
    flat[306] = S::default();
    flat[324..328].fill(S::default());
    flat[329..381].fill(S::default());
    flat[383] = S::default();
    flat[390..395].fill(S::default());
    nonzeros(trig, dq, ddq, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 66]; 6]) {
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
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let D2 = S::constant(0.154);
    let D6 = S::constant(0.263);
    let k0 = S::constant(9.81);
    let k2 = S::constant(2.0);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        put(0, ddq1); // row 1, YY1
        put(51, ddq1); // row 1, IA1
        put(55, ddq2); // row 2, YY2
        put(64, ddq2); // row 2, XX3
        put(100, ddq2); // row 2, IA2
        put(117, ddq3); // row 3, IA3
        put(145, ddq4); // row 4, IA4
        put(164, ddq5); // row 5, IA5
        put(173, ddq6); // row 6, IA6
        t0
    };
    // link 2: motion
    let [
        t4, t6, a2_y, t9, w3_z, t11, t12, t13,
        t14, t15, t16, t17, t18, t19, t20, t21,
        t22, t23, t24,
    ] = {
        let t3 = D2 * ddq1;
        let t4 = D2 * t0;
        let t6 = s2 * k0 + c2 * t3;
        let a2_y = s2 * t3 - c2 * k0;
        let t9 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t11 = s2 * ddq1;
        let t12 = c2 * ddq1;
        let t13 = t9 * t9;
        let t14 = dq2 * dq2;
        let t15 = t9 * w3_z;
        let t16 = dq2 * t9;
        let t17 = dq2 * w3_z;
        let t18 = t11 + t17;
        let t19 = t12 - t16;
        let t20 = t15 - ddq2;
        let t21 = ddq2 + t15;
        let t22 = t13 + t14;
        let t23 = t16 - t19;
        let t24 = t17 + t18;
        put(52, a2_y); // row 2, MSX2
        put(56, t15); // row 2, ZZ2
        put(59, t12); // row 2, YZ2
        put(66, t15); // row 2, ZZ3
        put(67, t11); // row 2, XY3
        put(102, t11); // row 3, MSX3
        [
        t4, t6, a2_y, t9, w3_z, t11, t12, t13,
        t14, t15, t16, t17, t18, t19, t20, t21,
        t22, t23, t24,
    ]
    };
    // link 3: motion
    let [t25, t27, t34, a3_y, t36, t38, t39] = {
        let t25 = q3 * t20;
        let t27 = q3 * t24;
        let t31 = dq3 * k2;
        let t34 = t27 - t4 + t9 * t31;
        let a3_y = dq2 * t31 - (t6 + t25);
        let t36 = a2_y + q3 * t22 - ddq3;
        let t37 = w3_z * w3_z;
        let t38 = t13 + t37;
        let t39 = t14 + t37;
        [t25, t27, t34, a3_y, t36, t38, t39]
    };
    // link 4: motion
    let [
        t40, t41, t44, a4_y, t50, w4_y, t56, t59,
        w4_z, dw4_z, t62, t63, t64, t65, t66, t67,
        t68, t69, t70, t71, t72, t73,
    ] = {
        let t40 = s2 * s4;
        let t41 = s2 * c4;
        let t44 = c4 * t34 - s4 * a3_y;
        let a4_y = c4 * a3_y + s4 * t34;
        let t50 = c4 * dq2 + s4 * t9;
        let w4_y = s4 * dq2 - c4 * t9;
        let t56 = c4 * t24 + s4 * t20;
        let t59 = s4 * t24 - c4 * t20;
        let w4_z = w3_z + dq4;
        let dw4_z = t19 + ddq4;
        let t62 = t50 * t50;
        let t63 = w4_z * w4_z;
        let t64 = t50 * w4_y;
        let t65 = t50 * w4_z;
        let t66 = w4_y * w4_z;
        let t67 = t59 - t66;
        let t68 = t56 - t65;
        let t69 = dw4_z + t64;
        let t70 = dw4_z - t64;
        let t71 = t62 + t63;
        let t72 = t68 - t65;
        let t73 = t66 - t67;
        put(106, t72); // row 3, MSX4
        put(108, t73); // row 3, MSZ4
        put(118, a4_y); // row 4, MSX4
        put(119, t44); // row 4, MSZ4
        put(120, t64); // row 4, XX4
        put(121, dw4_z); // row 4, YY4
        put(123, t59); // row 4, XY4
        put(125, t56); // row 4, YZ4
        [
        t40, t41, t44, a4_y, t50, w4_y, t56, t59,
        w4_z, dw4_z, t62, t63, t64, t65, t66, t67,
        t68, t69, t70, t71, t72, t73,
    ]
    };
    // link 5: motion
    let [
        t76, a5_y, t82, t85, t88, t91, w5_z, dw5_z,
        t94, t95, t96, t97, t98, t99, t100, t101,
        t102, t103, t104, t105,
    ] = {
        let t76 = c5 * t44 - s5 * t36;
        let a5_y = c5 * t36 + s5 * t44;
        let t82 = c5 * t50 + s5 * w4_z;
        let t85 = c5 * w4_z - s5 * t50;
        let t88 = c5 * t69 + s5 * t73;
        let t91 = c5 * t73 - s5 * t69;
        let w5_z = w4_y + dq5;
        let dw5_z = ddq5 - t68;
        let t94 = t82 * t82;
        let t95 = w5_z * w5_z;
        let t96 = t82 * t85;
        let t97 = t82 * w5_z;
        let t98 = t85 * w5_z;
        let t99 = t98 - t91;
        let t100 = t88 - t97;
        let t101 = dw5_z - t96;
        let t102 = dw5_z + t96;
        let t103 = t94 + t95;
        let t104 = t97 - t100;
        let t105 = t98 + t99;
        put(146, a5_y); // row 5, MSX5
        put(149, dw5_z); // row 5, YY5
        put(150, t96); // row 5, ZZ5
        put(151, t91); // row 5, XY5
        put(153, t88); // row 5, YZ5
        [
        t76, a5_y, t82, t85, t88, t91, w5_z, dw5_z,
        t94, t95, t96, t97, t98, t99, t100, t101,
        t102, t103, t104, t105,
    ]
    };
    // link 6: motion
    let [
        t110, t114, a6_y, t126, t129, dw6_z, t134, t135,
        t136, dw6_x, dw6_y, t139, t140, t141, t142, t143,
        t144, t145,
    ] = {
        let t109 = t76 - D6 * t101;
        let t110 = a5_y + D6 * t103;
        let t111 = a4_y + D6 * t105;
        let t114 = c6 * t109 - s6 * t111;
        let a6_y = c6 * t111 + s6 * t109;
        let w6_x = s6 * w5_z - c6 * t82;
        let w6_y = c6 * w5_z + s6 * t82;
        let t126 = c6 * t101 + s6 * t105;
        let t129 = s6 * t101 - c6 * t105;
        let w6_z = t85 + dq6;
        let dw6_z = t100 + ddq6;
        let t132 = w6_x * w6_x;
        let t133 = w6_z * w6_z;
        let t134 = w6_x * w6_y;
        let t135 = w6_x * w6_z;
        let t136 = w6_y * w6_z;
        let dw6_x = t129 + t136;
        let dw6_y = t126 - t135;
        let t139 = t133 - t132;
        let t140 = t103 + t139;
        let t141 = t134 - dw6_z;
        let t142 = dw6_z + t134;
        let t143 = t132 + t133;
        let t144 = t135 - dw6_y;
        let t145 = t136 + dw6_x;
        put(165, a6_y); // row 6, MSX6
        put(166, t114); // row 6, MSY6
        put(168, t134); // row 6, YY6
        put(169, dw6_z); // row 6, ZZ6
        put(171, t129); // row 6, XZ6
        put(172, t126); // row 6, YZ6
        [
        t110, t114, a6_y, t126, t129, dw6_z, t134, t135,
        t136, dw6_x, dw6_y, t139, t140, t141, t142, t143,
        t144, t145,
    ]
    };
    // joint axes in frame 2
    let [t146, v1_2_y] = {
        let t146 = c2 * D2;
        let v1_2_y = s2 * D2;
        [t146, v1_2_y]
    };
    // joint axes in frame 4
    let [t148, t149] = {
        let t148 = s4 * t146;
        let t149 = c4 * t146;
        [t148, t149]
    };
    // M2: column
    {
        let t152 = t6 * t146 + a2_y * v1_2_y;
        put(1, t152); // row 1, M2
    }
    // MSX2: column
    let t156 = {
        let t156 = t39 * t146 + t21 * v1_2_y;
        let t157 = t156 - c2 * t4;
        put(2, t157); // row 1, MSX2
        t156
    };
    // MSY2: column
    let t163 = {
        let t163 = t12 * t146 + t11 * v1_2_y;
        let t164 = s2 * a2_y + c2 * t6 + t163;
        put(3, t164); // row 1, MSY2
        t163
    };
    // MSZ2: column
    let t168 = {
        let t168 = t20 * t146 + t22 * v1_2_y;
        let t169 = t168 - s2 * t4;
        put(4, t169); // row 1, MSZ2
        t168
    };
    // XX2: column
    let t171 = {
        let t171 = c2 * t16;
        let t172 = s2 * t18 + t171;
        put(5, t172); // row 1, XX2
        put(16, t172); // row 1, YY3
        t171
    };
    // YY2: column
    let t173 = {
        let t173 = s2 * t17;
        let t174 = t173 - t171;
        put(6, t174); // row 1, YY2
        put(15, t174); // row 1, XX3
        t173
    };
    // ZZ2: column
    {
        let t176 = c2 * t19 - t173;
        put(7, t176); // row 1, ZZ2
        put(17, t176); // row 1, ZZ3
    }
    // XY2: column
    let t180 = {
        let t180 = s2 * t21 - c2 * (t38 - t39);
        put(18, t180); // row 1, XY3
        t180
    };
    // XZ2: column
    {
        let t181 = t39 - t22;
        let t184 = s2 * t23 - c2 * t24;
        put(9, t184); // row 1, XZ2
        put(20, t184); // row 1, YZ3
        put(58, t181); // row 2, XZ2
        put(69, t181); // row 2, YZ3
    }
    // YZ2: column
    let t188 = {
        let t188 = s2 * (t22 - t38) + c2 * t20;
        put(19, t188); // row 1, XZ3
        t188
    };
    // M3: column
    let t193 = {
        let t190 = q3 * a3_y;
        let t193 = t36 * v1_2_y;
        let t195 = s2 * (q3 * t34) - (a3_y * t146 - t193);
        put(11, t195); // row 1, M3
        put(60, t190); // row 2, M3
        t193
    };
    // MSX3: column
    {
        let t197 = q3 * t12;
        let t202 = s2 * (q3 * t38 - t36) + c2 * a3_y - t163;
        put(12, t202); // row 1, MSX3
        put(61, t197); // row 2, MSX3
    }
    // MSY3: column
    {
        let t205 = t36 - q3 * t39;
        let t209 = t156 - (s2 * (q3 * t23) - c2 * t34);
        put(13, t209); // row 1, MSY3
        put(62, t205); // row 2, MSY3
    }
    // MSZ3: column
    {
        let t211 = a3_y - t25;
        let t213 = t168 + s2 * (t27 + t34);
        put(14, t213); // row 1, MSZ3
        put(63, t211); // row 2, MSZ3
    }
    // M4: column
    let [t215, t216, t219, t222] = {
        let t214 = w4_y * w4_y;
        let t215 = t63 + t214;
        let t216 = t62 + t214;
        let t219 = c4 * t44 + s4 * a4_y;
        let t222 = c4 * a4_y - s4 * t44;
        let t224 = q3 * t222;
        let t228 = s2 * (q3 * t219) + (t193 - t146 * t222);
        put(21, t228); // row 1, M4
        put(70, t224); // row 2, M4
        put(107, t216); // row 3, MSY4
        [t215, t216, t219, t222]
    };
    // MSX4: column
    let [t233, t235, t236] = {
        let t233 = c4 * t70;
        let t234 = t233 - s4 * t215;
        let t235 = s4 * t36;
        let t236 = c4 * t36;
        let t240 = t235 + q3 * t234;
        let t243 = s2 * (q3 * (c4 * t215 + s4 * t70) - t236) + c2 * a4_y;
        let t247 = t243 - (t146 * t234 + t72 * v1_2_y);
        put(22, t247); // row 1, MSX4
        put(71, t240); // row 2, MSX4
        [t233, t235, t236]
    };
    // MSY4: column
    let t257 = {
        let t253 = c4 * t59 - s4 * t56;
        let t257 = t222 + q3 * t253;
        let t258 = s2 * (t219 + q3 * (c4 * t56 + s4 * t59));
        let t262 = t146 * t253 - v1_2_y * t216 - t258;
        put(23, t262); // row 1, MSY4
        t257
    };
    // MSZ4: column
    let t266 = {
        let t266 = s4 * t69;
        let t268 = t266 + c4 * t71;
        let t272 = t236 - q3 * t268;
        let t275 = s2 * (t235 - q3 * (s4 * t71 - c4 * t69)) + c2 * t44;
        let t279 = t275 + (t146 * t268 - t73 * v1_2_y);
        put(24, t279); // row 1, MSZ4
        put(73, t272); // row 2, MSZ4
        t266
    };
    // XX4: column
    let [t281, t282, t286] = {
        let t281 = t41 * t65;
        let t282 = c2 * t64;
        let t284 = t282 + (t40 * t67 + t281);
        let t286 = s4 * t65;
        let t287 = c4 * t67 - t286;
        put(25, t284); // row 1, XX4
        put(74, t287); // row 2, XX4
        [t281, t282, t286]
    };
    // YY4: column
    let [t288, t292] = {
        let t288 = t40 * t66;
        let t291 = c2 * dw4_z - (t281 + t288);
        let t292 = c4 * t66;
        let t293 = t286 - t292;
        put(26, t291); // row 1, YY4
        put(75, t293); // row 2, YY4
        [t288, t292]
    };
    // ZZ4: column
    {
        let t296 = t288 + t41 * t68 - t282;
        let t298 = t292 - s4 * t68;
        put(27, t296); // row 1, ZZ4
        put(76, t298); // row 2, ZZ4
    }
    // XY4: column
    {
        let t299 = t216 - t215;
        let t304 = c2 * t59 + (t40 * t70 - t41 * t299);
        let t306 = t233 + s4 * t299;
        put(28, t304); // row 1, XY4
        put(77, t306); // row 2, XY4
    }
    // XZ4: column
    {
        let t307 = t71 - t215;
        let t312 = c2 * t307 + (t40 * t72 - t41 * t73);
        let t315 = c4 * t72 + s4 * t73;
        put(29, t312); // row 1, XZ4
        put(78, t315); // row 2, XZ4
        put(124, t307); // row 4, XZ4
    }
    // YZ4: column
    {
        let t316 = t216 - t71;
        let t321 = c2 * t56 + (t40 * t316 + t41 * t69);
        let t323 = c4 * t316 - t266;
        put(30, t321); // row 1, YZ4
        put(79, t323); // row 2, YZ4
    }
    // M5: column
    let [t325, t326, t329, t332] = {
        let t324 = t85 * t85;
        let t325 = t95 + t324;
        let t326 = t94 + t324;
        let t329 = c5 * t76 + s5 * a5_y;
        let t332 = s5 * t76 - c5 * a5_y;
        let t333 = q3 * a4_y;
        let t334 = q3 * t329;
        let t342 = t148 * t329 - a4_y * t149 - v1_2_y * t332;
        let t343 = t40 * t333 + t41 * t334 + t342;
        let t346 = c4 * t333 - s4 * t334;
        put(31, t343); // row 1, M5
        put(80, t346); // row 2, M5
        put(109, t332); // row 3, M5
        put(127, t329); // row 4, MSY5
        [t325, t326, t329, t332]
    };
    // MSX5: column
    let [t348, t351, t353, t354] = {
        let t348 = s5 * t102;
        let t349 = c5 * t325 + t348;
        let t351 = c5 * t102;
        let t352 = s5 * t325 - t351;
        let t353 = s5 * a4_y;
        let t354 = c5 * a4_y;
        let t357 = t353 + q3 * t104;
        let t358 = a5_y - q3 * t349;
        let t363 = t40 * t357 + t41 * t358 - c2 * t354;
        let t369 = t148 * t349 + t104 * t149 - v1_2_y * t352 - t363;
        let t372 = s4 * t358 - c4 * t357;
        put(32, t369); // row 1, MSX5
        put(81, t372); // row 2, MSX5
        put(110, t352); // row 3, MSX5
        put(126, t354); // row 4, MSX5
        put(128, t353); // row 4, MSZ5
        [t348, t351, t353, t354]
    };
    // MSY5: column
    {
        let t375 = s5 * t91 - c5 * t88;
        let t378 = s5 * t88 + c5 * t91;
        let t380 = q3 * t375;
        let t381 = t332 + q3 * t326;
        let t391 = v1_2_y * t378 - (t149 * t326 - t148 * t375);
        let t392 = c2 * t329 - (t40 * t381 + t41 * t380) - t391;
        let t395 = s4 * t380 - c4 * t381;
        put(33, t392); // row 1, MSY5
        put(82, t395); // row 2, MSY5
        put(111, t378); // row 3, MSY5
    }
    // MSZ5: column
    let [t396, t397, t399, t400, t401] = {
        let t396 = c5 * t101;
        let t397 = s5 * t103;
        let t398 = t396 - t397;
        let t399 = s5 * t101;
        let t400 = c5 * t103;
        let t401 = t399 + t400;
        let t404 = t354 + q3 * t105;
        let t405 = q3 * t398 - t76;
        let t415 = v1_2_y * t401 - (t148 * t398 + t105 * t149);
        let t416 = c2 * t353 - (t41 * t405 - t40 * t404) + t415;
        let t419 = c4 * t404 + s4 * t405;
        put(34, t416); // row 1, MSZ5
        put(83, t419); // row 2, MSZ5
        [t396, t397, t399, t400, t401]
    };
    // XX5: column
    let [t421, t424, t427, t432] = {
        let t421 = s5 * t97;
        let t422 = c5 * t99 - t421;
        let t424 = c5 * t97;
        let t425 = s5 * t99 + t424;
        let t427 = t41 * t96;
        let t430 = c2 * t425 + (t40 * t422 + t427);
        let t432 = s4 * t96;
        let t433 = c4 * t422 - t432;
        put(35, t430); // row 1, XX5
        put(84, t433); // row 2, XX5
        put(129, t425); // row 4, XX5
        [t421, t424, t427, t432]
    };
    // YY5: column
    let [t434, t436] = {
        let t434 = c5 * t98;
        let t435 = t421 + t434;
        let t436 = s5 * t98;
        let t437 = t436 - t424;
        let t442 = c2 * t437 - (t41 * dw5_z - t40 * t435);
        let t445 = c4 * t435 + s4 * dw5_z;
        put(36, t442); // row 1, YY5
        put(85, t445); // row 2, YY5
        put(130, t437); // row 4, YY5
        [t434, t436]
    };
    // ZZ5: column
    {
        let t447 = t434 + s5 * t100;
        let t449 = c5 * t100 - t436;
        let t453 = c2 * t449 - (t427 + t40 * t447);
        let t455 = t432 - c4 * t447;
        put(37, t453); // row 1, ZZ5
        put(86, t455); // row 2, ZZ5
        put(131, t449); // row 4, ZZ5
    }
    // XY5: column
    {
        let t456 = t326 - t325;
        let t458 = t351 + s5 * t456;
        let t460 = c5 * t456 - t348;
        let t465 = c2 * t460 - (t40 * t458 + t41 * t91);
        let t468 = s4 * t91 - c4 * t458;
        put(38, t465); // row 1, XY5
        put(87, t468); // row 2, XY5
        put(132, t460); // row 4, XY5
    }
    // XZ5: column
    {
        let t469 = t325 - t103;
        let t472 = c5 * t104 + s5 * t105;
        let t475 = s5 * t104 - c5 * t105;
        let t480 = c2 * t475 + (t40 * t472 - t41 * t469);
        let t483 = c4 * t472 + s4 * t469;
        put(39, t480); // row 1, XZ5
        put(88, t483); // row 2, XZ5
        put(133, t475); // row 4, XZ5
        put(152, t469); // row 5, XZ5
    }
    // YZ5: column
    {
        let t484 = t326 - t103;
        let t486 = t399 - c5 * t484;
        let t488 = t396 + s5 * t484;
        let t493 = c2 * t488 - (t40 * t486 + t41 * t88);
        let t496 = s4 * t88 - c4 * t486;
        put(40, t493); // row 1, YZ5
        put(89, t496); // row 2, YZ5
        put(134, t488); // row 4, YZ5
    }
    // M6: column
    let [t499, t502, t504] = {
        let t499 = c6 * t114 + s6 * a6_y;
        let t502 = c6 * a6_y - s6 * t114;
        let t503 = D6 * t502;
        let t504 = D6 * t499;
        let t507 = c5 * t499 + s5 * t110;
        let t510 = s5 * t499 - c5 * t110;
        let t512 = s5 * t503;
        let t515 = c5 * t503 + q3 * t502;
        let t516 = t504 + q3 * t507;
        let t526 = t148 * t507 - t149 * t502 - v1_2_y * t510;
        let t527 = c2 * t512 + (t40 * t515 + t41 * t516) + t526;
        let t530 = c4 * t515 - s4 * t516;
        put(41, t527); // row 1, M6
        put(90, t530); // row 2, M6
        put(113, t510); // row 3, M6
        put(135, t512); // row 4, M6
        [t499, t502, t504]
    };
    // MSX6: column
    let [t532, t535, t537, t538] = {
        let t532 = s6 * t142;
        let t533 = c6 * t140 + t532;
        let t535 = c6 * t142;
        let t536 = s6 * t140 - t535;
        let t537 = s6 * t110;
        let t538 = c6 * t110;
        let t541 = t537 - D6 * t536;
        let t542 = t538 - D6 * t533;
        let t545 = c5 * t533 - s5 * t144;
        let t548 = s5 * t533 + c5 * t144;
        let t554 = s5 * t541 + c5 * a6_y;
        let t557 = c5 * t541 - s5 * a6_y - q3 * t536;
        let t558 = t542 - q3 * t545;
        let t568 = t148 * t545 + t149 * t536 - v1_2_y * t548;
        let t569 = c2 * t554 + (t40 * t557 - t41 * t558) + t568;
        let t572 = c4 * t557 + s4 * t558;
        put(42, t569); // row 1, MSX6
        put(91, t572); // row 2, MSX6
        put(114, t548); // row 3, MSX6
        put(136, t554); // row 4, MSX6
        put(155, t542); // row 5, MSX6
        [t532, t535, t537, t538]
    };
    // MSY6: column
    let [t573, t576] = {
        let t573 = c6 * t141;
        let t575 = t573 + s6 * t143;
        let t576 = s6 * t141;
        let t578 = t576 - c6 * t143;
        let t581 = t538 + D6 * t578;
        let t582 = D6 * t575 - t537;
        let t585 = c5 * t575 + s5 * t145;
        let t588 = c5 * t145 - s5 * t575;
        let t594 = s5 * t581 + c5 * t114;
        let t597 = c5 * t581 - s5 * t114 + q3 * t578;
        let t598 = t582 + q3 * t585;
        let t608 = v1_2_y * t588 + (t148 * t585 + t149 * t578);
        let t609 = c2 * t594 + (t40 * t597 - t41 * t598) - t608;
        let t612 = c4 * t597 + s4 * t598;
        put(43, t609); // row 1, MSY6
        put(92, t612); // row 2, MSY6
        put(115, t588); // row 3, MSY6
        put(137, t594); // row 4, MSY6
        put(156, t582); // row 5, MSY6
        [t573, t576]
    };
    // MSZ6: column
    let t626 = {
        let t615 = c6 * t126 + s6 * t129;
        let t618 = c6 * t129 - s6 * t126;
        let t621 = t502 - D6 * t618;
        let t622 = D6 * t615 - t499;
        let t624 = t397 - c5 * t615;
        let t626 = t400 + s5 * t615;
        let t628 = s5 * t621;
        let t631 = c5 * t621 - q3 * t618;
        let t632 = t622 - q3 * t624;
        let t642 = v1_2_y * t626 + (t148 * t624 + t149 * t618);
        let t643 = c2 * t628 + (t40 * t631 - t41 * t632) + t642;
        let t646 = c4 * t631 + s4 * t632;
        put(44, t643); // row 1, MSZ6
        put(93, t646); // row 2, MSZ6
        put(138, t628); // row 4, MSZ6
        put(157, t622); // row 5, MSZ6
        t626
    };
    // XX6: column
    let [t648, t651, t654, t657] = {
        let t648 = s6 * t135;
        let t649 = t648 - c6 * dw6_x;
        let t651 = c6 * t135;
        let t652 = s6 * dw6_x + t651;
        let t654 = s5 * t134;
        let t655 = c5 * t649 + t654;
        let t657 = c5 * t134;
        let t658 = s5 * t649 - t657;
        let t663 = c2 * t658 + (t40 * t655 - t41 * t652);
        let t666 = c4 * t655 + s4 * t652;
        put(45, t663); // row 1, XX6
        put(94, t666); // row 2, XX6
        put(139, t658); // row 4, XX6
        put(158, t652); // row 5, XX6
        [t648, t651, t654, t657]
    };
    // YY6: column
    let [t667, t670] = {
        let t667 = c6 * t136;
        let t669 = t667 + s6 * dw6_y;
        let t670 = s6 * t136;
        let t672 = c6 * dw6_y - t670;
        let t674 = c5 * t669 - t654;
        let t676 = t657 + s5 * t669;
        let t681 = c2 * t676 - (t41 * t672 - t40 * t674);
        let t684 = c4 * t674 + s4 * t672;
        put(46, t681); // row 1, YY6
        put(95, t684); // row 2, YY6
        put(140, t676); // row 4, YY6
        put(159, t672); // row 5, YY6
        [t667, t670]
    };
    // ZZ6: column
    {
        let t685 = t648 + t667;
        let t686 = t670 - t651;
        let t689 = c5 * t685 + s5 * dw6_z;
        let t692 = c5 * dw6_z - s5 * t685;
        let t697 = c2 * t692 - (t40 * t689 + t41 * t686);
        let t700 = s4 * t686 - c4 * t689;
        put(47, t697); // row 1, ZZ6
        put(96, t700); // row 2, ZZ6
        put(141, t692); // row 4, ZZ6
        put(160, t686); // row 5, ZZ6
    }
    // XY6: column
    {
        let t701 = t143 - t140;
        let t704 = c6 * t144 + s6 * t145;
        let t707 = c6 * t145 - s6 * t144;
        let t710 = c5 * t704 - s5 * t701;
        let t713 = s5 * t704 + c5 * t701;
        let t718 = c2 * t713 - (t41 * t707 - t40 * t710);
        let t721 = c4 * t710 + s4 * t707;
        put(48, t718); // row 1, XY6
        put(97, t721); // row 2, XY6
        put(142, t713); // row 4, XY6
        put(161, t707); // row 5, XY6
        put(170, t701); // row 6, XY6
    }
    // XZ6: column
    {
        let t723 = s6 * t139 - t535;
        let t725 = t532 + c6 * t139;
        let t728 = c5 * t723 - s5 * t129;
        let t731 = s5 * t723 + c5 * t129;
        let t736 = c2 * t731 + (t40 * t728 - t41 * t725);
        let t739 = c4 * t728 + s4 * t725;
        put(49, t736); // row 1, XZ6
        put(98, t739); // row 2, XZ6
        put(143, t731); // row 4, XZ6
        put(162, t725); // row 5, XZ6
    }
    // YZ6: column
    {
        let t740 = t103 - t143;
        let t742 = t576 + c6 * t740;
        let t744 = s6 * t740 - t573;
        let t747 = c5 * t742 + s5 * t126;
        let t750 = c5 * t126 - s5 * t742;
        let t755 = c2 * t750 - (t40 * t747 + t41 * t744);
        let t758 = s4 * t744 - c4 * t747;
        let t759 = -t180;
        let t760 = -t188;
        let t761 = -t6;
        let t762 = -t15;
        let t763 = -t11;
        let t764 = -t12;
        let t765 = -t257;
        let t766 = -t36;
        let t767 = -t21;
        let t768 = -t22;
        let t769 = -t401;
        let t770 = -t626;
        let t771 = -t64;
        let t772 = -t76;
        let t773 = -t96;
        let t774 = -t504;
        let t775 = -t134;
        put(8, t759); // row 1, XY2
        put(10, t760); // row 1, YZ2
        put(50, t755); // row 1, YZ6
        put(53, t761); // row 2, MSZ2
        put(54, t762); // row 2, XX2
        put(57, t763); // row 2, XY2
        put(65, t762); // row 2, YY3
        put(68, t764); // row 2, XZ3
        put(72, t765); // row 2, MSY4
        put(99, t758); // row 2, YZ6
        put(101, t766); // row 3, M3
        put(103, t767); // row 3, MSY3
        put(104, t768); // row 3, MSZ3
        put(105, t766); // row 3, M4
        put(112, t769); // row 3, MSZ5
        put(116, t770); // row 3, MSZ6
        put(122, t771); // row 4, ZZ4
        put(144, t750); // row 4, YZ6
        put(147, t772); // row 5, MSZ5
        put(148, t773); // row 5, XX5
        put(154, t774); // row 5, M6
        put(163, t744); // row 5, YZ6
        put(167, t775); // row 6, XX6
    }
}
