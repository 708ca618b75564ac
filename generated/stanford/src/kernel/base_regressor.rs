//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4.
//!
//! 337 multiplications, 252 additions; 6 x 37, 121 of 222 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 121;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9),
    (0, 10), (0, 11), (0, 12), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18), (0, 19),
    (0, 20), (0, 21), (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28), (0, 29),
    (0, 30), (0, 31), (0, 32), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7),
    (1, 8), (1, 9), (1, 10), (1, 11), (1, 12), (1, 13), (1, 14), (1, 15), (1, 16), (1, 17),
    (1, 18), (1, 19), (1, 20), (1, 21), (1, 22), (1, 23), (1, 24), (1, 25), (1, 26), (1, 27),
    (1, 28), (1, 29), (1, 30), (1, 31), (1, 32), (2, 8), (2, 9), (2, 10), (2, 11), (2, 12),
    (2, 13), (2, 19), (2, 20), (2, 26), (2, 27), (2, 33), (3, 12), (3, 13), (3, 14), (3, 15),
    (3, 16), (3, 17), (3, 18), (3, 19), (3, 20), (3, 21), (3, 22), (3, 23), (3, 24), (3, 25),
    (3, 26), (3, 27), (3, 28), (3, 29), (3, 30), (3, 31), (3, 32), (3, 34), (4, 19), (4, 20),
    (4, 21), (4, 22), (4, 23), (4, 24), (4, 25), (4, 26), (4, 27), (4, 28), (4, 29), (4, 30),
    (4, 31), (4, 32), (4, 35), (5, 26), (5, 27), (5, 28), (5, 29), (5, 30), (5, 31), (5, 32),
    (5, 36),
];

/// Regressor `W_b` of the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 37]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    flat[33..38].fill(S::default());
    flat[70..82].fill(S::default());
    flat[88..93].fill(S::default());
    flat[95..100].fill(S::default());
    flat[102..107].fill(S::default());
    flat[108..123].fill(S::default());
    flat[144] = S::default();
    flat[146..167].fill(S::default());
    flat[181..183].fill(S::default());
    flat[184..211].fill(S::default());
    flat[218..221].fill(S::default());
    nonzeros(trig, dq, ddq, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 37]; 6]) {
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
        put(0, ddq1); // row 1, YY1R
        put(35, ddq2); // row 2, YY2R
        put(75, ddq3); // row 3, IA3
        put(97, ddq4); // row 4, IA4
        put(112, ddq5); // row 5, IA5
        put(120, ddq6); // row 6, IA6
        t0
    };
    // link 2: motion
    let [
        t4, t6, a2_y, t9, w3_z, t11, t12, t13,
        t14, t16, t17, t19, t20, t21, t22, t23,
        t24,
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
        let t19 = t12 - t16;
        let t20 = t15 - ddq2;
        let t21 = ddq2 + t15;
        let t22 = t13 + t14;
        let t23 = t16 - t19;
        let t24 = t17 + (t11 + t17);
        put(33, a2_y); // row 2, MSX2
        put(36, t15); // row 2, ZZ2R
        put(39, t12); // row 2, YZ2R
        put(66, t11); // row 3, MSX3
        [
        t4, t6, a2_y, t9, w3_z, t11, t12, t13,
        t14, t16, t17, t19, t20, t21, t22, t23,
        t24,
    ]
    };
    // link 3: motion
    let [t25, t27, t34, a3_y, t36, t38, t39] = {
        let t25 = q3 * t20;
        let t27 = q3 * t24;
        let t31 = dq3 * k2;
        let t34 = t9 * t31 - (t4 - t27);
        let a3_y = dq2 * t31 - (t6 + t25);
        let t36 = a2_y + q3 * t22 - ddq3;
        let t37 = w3_z * w3_z;
        let t38 = t13 + t37;
        let t39 = t14 + t37;
        [t25, t27, t34, a3_y, t36, t38, t39]
    };
    // link 4: motion
    let [
        t40, t41, t44, a4_y, t50, t53, t56, t59,
        w4_z, dw4_z, t62, t63, t64, t65, t66, dw4_y,
        t69, t70, t71, t72, t73,
    ] = {
        let t40 = s2 * s4;
        let t41 = s2 * c4;
        let t44 = c4 * t34 - s4 * a3_y;
        let a4_y = c4 * a3_y + s4 * t34;
        let t50 = c4 * dq2 + s4 * t9;
        let t53 = c4 * t9 - s4 * dq2;
        let t56 = c4 * t24 + s4 * t20;
        let t59 = c4 * t20 - s4 * t24;
        let w4_z = w3_z + dq4;
        let dw4_z = t19 + ddq4;
        let t62 = t50 * t50;
        let t63 = w4_z * w4_z;
        let t64 = t50 * t53;
        let t65 = t50 * w4_z;
        let t66 = t53 * w4_z;
        let dw4_x = t59 - t66;
        let dw4_y = t65 - t56;
        let t69 = t64 - dw4_z;
        let t70 = dw4_z + t64;
        let t71 = t62 + t63;
        let t72 = t65 + dw4_y;
        let t73 = dw4_x - t66;
        put(70, t73); // row 3, MSZ4R
        put(76, a4_y); // row 4, MSX4
        put(77, t44); // row 4, MSZ4R
        put(78, dw4_z); // row 4, YY4R
        put(79, t64); // row 4, ZZ4R
        put(82, t56); // row 4, YZ4
        [
        t40, t41, t44, a4_y, t50, t53, t56, t59,
        w4_z, dw4_z, t62, t63, t64, t65, t66, dw4_y,
        t69, t70, t71, t72, t73,
    ]
    };
    // link 5: motion
    let [
        a5_x, a5_y, t82, t85, t88, t91, w5_z, dw5_z,
        t94, t95, t96, t97, t98, t100, t101, t102,
        t103, t104, t105,
    ] = {
        let a5_x = s5 * t36 - c5 * t44;
        let a5_y = c5 * t36 + s5 * t44;
        let t82 = c5 * t50 + s5 * w4_z;
        let t85 = c5 * w4_z - s5 * t50;
        let t88 = s5 * t73 - c5 * t69;
        let t91 = c5 * t73 + s5 * t69;
        let w5_z = dq5 - t53;
        let dw5_z = dw4_y + ddq5;
        let t94 = t82 * t82;
        let t95 = w5_z * w5_z;
        let t96 = t82 * t85;
        let t97 = t82 * w5_z;
        let t98 = t85 * w5_z;
        let dw5_x = t91 - t98;
        let t100 = t88 - t97;
        let t101 = t96 - dw5_z;
        let t102 = dw5_z + t96;
        let t103 = t94 + t95;
        let t104 = t100 - t97;
        let t105 = dw5_x - t98;
        put(98, a5_y); // row 5, MSX5
        put(99, a5_x); // row 5, MSZ5R
        put(100, dw5_z); // row 5, YY5R
        put(101, t96); // row 5, ZZ5R
        put(102, t91); // row 5, XY5
        put(104, t88); // row 5, YZ5
        [
        a5_x, a5_y, t82, t85, t88, t91, w5_z, dw5_z,
        t94, t95, t96, t97, t98, t100, t101, t102,
        t103, t104, t105,
    ]
    };
    // link 6: motion
    let [
        t110, t114, a6_y, t126, t129, dw6_z, t134, t135,
        t136, dw6_x, t139, t140, t141, t142, t143, t144,
        t145,
    ] = {
        let t109 = D6 * t101 - a5_x;
        let t110 = a5_y + D6 * t103;
        let t111 = a4_y - D6 * t105;
        let t114 = c6 * t109 - s6 * t111;
        let a6_y = c6 * t111 + s6 * t109;
        let t120 = c6 * t82 - s6 * w5_z;
        let w6_y = c6 * w5_z + s6 * t82;
        let t126 = c6 * t101 + s6 * t105;
        let t129 = c6 * t105 - s6 * t101;
        let w6_z = t85 + dq6;
        let dw6_z = t100 + ddq6;
        let t132 = t120 * t120;
        let t133 = w6_z * w6_z;
        let t134 = t120 * w6_y;
        let t135 = t120 * w6_z;
        let t136 = w6_y * w6_z;
        let dw6_x = t129 + t136;
        let t139 = t132 - t133;
        let t140 = t139 - t103;
        let t141 = dw6_z + t134;
        let t142 = dw6_z - t134;
        let t143 = t132 + t133;
        let t144 = t126 - t135 - t135;
        let t145 = t136 + dw6_x;
        put(113, a6_y); // row 6, MSX6
        put(114, t114); // row 6, MSY6
        put(115, t134); // row 6, XX6R
        put(116, dw6_z); // row 6, ZZ6
        put(118, t129); // row 6, XZ6
        [
        t110, t114, a6_y, t126, t129, dw6_z, t134, t135,
        t136, dw6_x, t139, t140, t141, t142, t143, t144,
        t145,
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
    // MSX2: column
    let t153 = {
        let t153 = t39 * t146 + t21 * v1_2_y;
        let t154 = t153 - c2 * t4;
        put(1, t154); // row 1, MSX2
        t153
    };
    // MSZ2: column
    let t158 = {
        let t158 = t20 * t146 + t22 * v1_2_y;
        let t159 = t158 - s2 * t4;
        put(2, t159); // row 1, MSZ2
        t158
    };
    // YY2: column
    let t160 = {
        let t160 = s2 * t17;
        let t162 = t160 - c2 * t16;
        put(3, t162); // row 1, YY2R
        t160
    };
    // ZZ2: column
    {
        let t164 = c2 * t19 - t160;
        put(4, t164); // row 1, ZZ2R
    }
    // XY2: column
    {
        let t168 = c2 * (t38 - t39) - s2 * t21;
        put(5, t168); // row 1, XY2R
    }
    // XZ2: column
    {
        let t169 = t39 - t22;
        let t172 = s2 * t23 - c2 * t24;
        put(6, t172); // row 1, XZ2R
        put(38, t169); // row 2, XZ2R
    }
    // YZ2: column
    {
        let t176 = s2 * (t38 - t22) - c2 * t20;
        put(7, t176); // row 1, YZ2R
    }
    // M3: column
    {
        let t178 = q3 * a3_y;
        let t183 = s2 * (q3 * t34) - (a3_y * t146 - t36 * v1_2_y);
        put(8, t183); // row 1, M3R
        put(40, t178); // row 2, M3R
    }
    // MSX3: column
    {
        let t185 = q3 * t12;
        let t192 = t12 * t146 + t11 * v1_2_y;
        let t193 = s2 * (q3 * t38 - t36) + c2 * a3_y - t192;
        put(9, t193); // row 1, MSX3
        put(41, t185); // row 2, MSX3
    }
    // MSY3: column
    {
        let t196 = t36 - q3 * t39;
        let t200 = t153 + (c2 * t34 - s2 * (q3 * t23));
        put(10, t200); // row 1, MSY3
        put(42, t196); // row 2, MSY3
    }
    // MSZ3: column
    {
        let t202 = a3_y - t25;
        let t204 = t158 + s2 * (t27 + t34);
        put(11, t204); // row 1, MSZ3R
        put(43, t202); // row 2, MSZ3R
    }
    // MSX4: column
    let [t206, t207, t212, t214, t215] = {
        let t205 = t53 * t53;
        let t206 = t63 + t205;
        let t207 = t62 + t205;
        let t212 = c4 * t70;
        let t213 = t212 - s4 * t206;
        let t214 = s4 * t36;
        let t215 = c4 * t36;
        let t219 = t214 + q3 * t213;
        let t222 = s2 * (q3 * (c4 * t206 + s4 * t70) - t215) + c2 * a4_y;
        let t226 = t222 - (t146 * t213 - t72 * v1_2_y);
        put(12, t226); // row 1, MSX4
        put(44, t219); // row 2, MSX4
        [t206, t207, t212, t214, t215]
    };
    // MSZ4: column
    let t230 = {
        let t230 = s4 * t69;
        let t232 = t230 - c4 * t71;
        let t236 = t215 + q3 * t232;
        let t239 = s2 * (t214 - q3 * (c4 * t69 + s4 * t71)) + c2 * t44;
        let t243 = t239 - (t146 * t232 + t73 * v1_2_y);
        put(13, t243); // row 1, MSZ4R
        put(45, t236); // row 2, MSZ4R
        t230
    };
    // YY4: column
    let [t244, t249] = {
        let t244 = t40 * t66;
        let t248 = c2 * dw4_z - (t41 * t65 - t244);
        let t249 = c4 * t66;
        let t251 = t249 + s4 * t65;
        put(14, t248); // row 1, YY4R
        put(46, t251); // row 2, YY4R
        [t244, t249]
    };
    // ZZ4: column
    {
        let t255 = c2 * t64 - (t244 + t41 * dw4_y);
        let t257 = s4 * dw4_y - t249;
        put(15, t255); // row 1, ZZ4R
        put(47, t257); // row 2, ZZ4R
    }
    // XY4: column
    {
        let t258 = t207 - t206;
        let t263 = t40 * t70 - t41 * t258 - c2 * t59;
        let t265 = t212 + s4 * t258;
        put(16, t263); // row 1, XY4
        put(48, t265); // row 2, XY4
    }
    // XZ4: column
    {
        let t266 = t71 - t206;
        let t271 = c2 * t266 - (t40 * t72 + t41 * t73);
        let t274 = s4 * t73 - c4 * t72;
        put(17, t271); // row 1, XZ4
        put(49, t274); // row 2, XZ4
        put(81, t266); // row 4, XZ4
    }
    // YZ4: column
    {
        let t275 = t207 - t71;
        let t280 = c2 * t56 + (t40 * t275 - t41 * t69);
        let t282 = t230 + c4 * t275;
        put(18, t280); // row 1, YZ4
        put(50, t282); // row 2, YZ4
    }
    // MSX5: column
    let [t284, t285, t287, t290, t292, t293] = {
        let t283 = t85 * t85;
        let t284 = t95 + t283;
        let t285 = t94 + t283;
        let t287 = s5 * t102;
        let t288 = c5 * t284 + t287;
        let t290 = c5 * t102;
        let t291 = s5 * t284 - t290;
        let t292 = s5 * a4_y;
        let t293 = c5 * a4_y;
        let t296 = q3 * t104 - t292;
        let t297 = q3 * t288 - a5_y;
        let t307 = t148 * t288 - t104 * t149 - v1_2_y * t291;
        let t308 = c2 * t293 + (t40 * t296 + t41 * t297) + t307;
        let t311 = c4 * t296 - s4 * t297;
        put(19, t308); // row 1, MSX5
        put(51, t311); // row 2, MSX5
        put(71, t291); // row 3, MSX5
        put(83, t293); // row 4, MSX5
        put(84, t292); // row 4, MSZ5R
        [t284, t285, t287, t290, t292, t293]
    };
    // MSZ5: column
    let [t312, t315] = {
        let t312 = c5 * t101;
        let t314 = t312 + s5 * t103;
        let t315 = s5 * t101;
        let t317 = t315 - c5 * t103;
        let t320 = t293 - q3 * t105;
        let t321 = a5_x - q3 * t314;
        let t331 = v1_2_y * t317 - (t148 * t314 + t105 * t149);
        let t332 = c2 * t292 + (t40 * t320 - t41 * t321) - t331;
        let t335 = c4 * t320 + s4 * t321;
        put(20, t332); // row 1, MSZ5R
        put(52, t335); // row 2, MSZ5R
        put(72, t317); // row 3, MSZ5R
        [t312, t315]
    };
    // YY5: column
    let [t336, t339] = {
        let t336 = c5 * t98;
        let t338 = t336 + s5 * t97;
        let t339 = s5 * t98;
        let t341 = t339 - c5 * t97;
        let t346 = c2 * t341 - (t41 * dw5_z - t40 * t338);
        let t349 = c4 * t338 + s4 * dw5_z;
        put(21, t346); // row 1, YY5R
        put(53, t349); // row 2, YY5R
        put(85, t341); // row 4, YY5R
        [t336, t339]
    };
    // ZZ5: column
    {
        let t351 = t336 + s5 * t100;
        let t353 = c5 * t100 - t339;
        let t358 = c2 * t353 - (t40 * t351 + t41 * t96);
        let t361 = s4 * t96 - c4 * t351;
        put(22, t358); // row 1, ZZ5R
        put(54, t361); // row 2, ZZ5R
        put(86, t353); // row 4, ZZ5R
    }
    // XY5: column
    {
        let t362 = t285 - t284;
        let t364 = t290 + s5 * t362;
        let t366 = c5 * t362 - t287;
        let t371 = c2 * t366 - (t40 * t364 + t41 * t91);
        let t374 = s4 * t91 - c4 * t364;
        put(23, t371); // row 1, XY5
        put(55, t374); // row 2, XY5
        put(87, t366); // row 4, XY5
    }
    // XZ5: column
    {
        let t375 = t284 - t103;
        let t378 = c5 * t104 + s5 * t105;
        let t381 = c5 * t105 - s5 * t104;
        let t386 = c2 * t381 - (t40 * t378 + t41 * t375);
        let t389 = s4 * t375 - c4 * t378;
        put(24, t386); // row 1, XZ5
        put(56, t389); // row 2, XZ5
        put(88, t381); // row 4, XZ5
        put(103, t375); // row 5, XZ5
    }
    // YZ5: column
    {
        let t390 = t285 - t103;
        let t392 = t315 + c5 * t390;
        let t394 = s5 * t390 - t312;
        let t399 = c2 * t394 + (t40 * t392 - t41 * t88);
        let t402 = c4 * t392 + s4 * t88;
        put(25, t399); // row 1, YZ5
        put(57, t402); // row 2, YZ5
        put(89, t394); // row 4, YZ5
    }
    // MSX6: column
    let [t404, t407, t409, t410] = {
        let t404 = s6 * t142;
        let t405 = t404 - c6 * t140;
        let t407 = c6 * t142;
        let t408 = s6 * t140 + t407;
        let t409 = s6 * t110;
        let t410 = c6 * t110;
        let t413 = t409 + D6 * t408;
        let t414 = t410 - D6 * t405;
        let t417 = c5 * t405 - s5 * t144;
        let t420 = s5 * t405 + c5 * t144;
        let t426 = s5 * t413 + c5 * a6_y;
        let t429 = c5 * t413 - s5 * a6_y + q3 * t408;
        let t430 = t414 - q3 * t417;
        let t440 = v1_2_y * t420 - (t148 * t417 - t149 * t408);
        let t441 = c2 * t426 + (t40 * t429 - t41 * t430) - t440;
        let t444 = c4 * t429 + s4 * t430;
        put(26, t441); // row 1, MSX6
        put(58, t444); // row 2, MSX6
        put(73, t420); // row 3, MSX6
        put(90, t426); // row 4, MSX6
        put(105, t414); // row 5, MSX6
        [t404, t407, t409, t410]
    };
    // MSY6: column
    let [t445, t448] = {
        let t445 = c6 * t141;
        let t447 = s6 * t143 - t445;
        let t448 = s6 * t141;
        let t450 = t448 + c6 * t143;
        let t453 = t410 - D6 * t450;
        let t454 = D6 * t447 - t409;
        let t457 = c5 * t447 + s5 * t145;
        let t460 = c5 * t145 - s5 * t447;
        let t466 = s5 * t453 + c5 * t114;
        let t469 = s5 * t114 - c5 * t453 + q3 * t450;
        let t470 = t454 + q3 * t457;
        let t480 = t149 * t450 - t148 * t457 - v1_2_y * t460;
        let t481 = c2 * t466 - (t40 * t469 + t41 * t470) + t480;
        let t484 = s4 * t470 - c4 * t469;
        put(27, t481); // row 1, MSY6
        put(59, t484); // row 2, MSY6
        put(74, t460); // row 3, MSY6
        put(91, t466); // row 4, MSY6
        put(106, t454); // row 5, MSY6
        [t445, t448]
    };
    // XX6: column
    let [t486, t489] = {
        let t486 = s6 * t135;
        let t487 = c6 * dw6_x + t486;
        let t489 = c6 * t135;
        let t490 = s6 * dw6_x - t489;
        let t493 = c5 * t487 + s5 * t134;
        let t496 = c5 * t134 - s5 * t487;
        let t501 = c2 * t496 - (t40 * t493 + t41 * t490);
        let t504 = s4 * t490 - c4 * t493;
        put(28, t501); // row 1, XX6R
        put(60, t504); // row 2, XX6R
        put(92, t496); // row 4, XX6R
        put(107, t490); // row 5, XX6R
        [t486, t489]
    };
    // ZZ6: column
    {
        let t506 = c6 * t136 - t486;
        let t508 = t489 + s6 * t136;
        let t511 = c5 * t506 + s5 * dw6_z;
        let t514 = c5 * dw6_z - s5 * t506;
        let t519 = c2 * t514 - (t40 * t511 + t41 * t508);
        let t522 = s4 * t508 - c4 * t511;
        put(29, t519); // row 1, ZZ6
        put(61, t522); // row 2, ZZ6
        put(93, t514); // row 4, ZZ6
        put(108, t508); // row 5, ZZ6
    }
    // XY6: column
    {
        let t523 = t140 + t143;
        let t526 = c6 * t144 + s6 * t145;
        let t529 = c6 * t145 - s6 * t144;
        let t532 = s5 * t523 - c5 * t526;
        let t535 = s5 * t526 + c5 * t523;
        let t540 = c2 * t535 - (t40 * t532 + t41 * t529);
        let t543 = s4 * t529 - c4 * t532;
        put(30, t540); // row 1, XY6
        put(62, t543); // row 2, XY6
        put(94, t535); // row 4, XY6
        put(109, t529); // row 5, XY6
        put(117, t523); // row 6, XY6
    }
    // XZ6: column
    {
        let t545 = t407 + s6 * t139;
        let t547 = t404 - c6 * t139;
        let t550 = c5 * t545 + s5 * t129;
        let t553 = c5 * t129 - s5 * t545;
        let t558 = c2 * t553 - (t40 * t550 + t41 * t547);
        let t561 = s4 * t547 - c4 * t550;
        put(31, t558); // row 1, XZ6
        put(63, t561); // row 2, XZ6
        put(95, t553); // row 4, XZ6
        put(110, t547); // row 5, XZ6
    }
    // YZ6: column
    {
        let t562 = t103 - t143;
        let t564 = t448 - c6 * t562;
        let t566 = t445 + s6 * t562;
        let t569 = c5 * t564 + s5 * t126;
        let t572 = s5 * t564 - c5 * t126;
        let t577 = c2 * t572 - (t41 * t566 - t40 * t569);
        let t580 = c4 * t569 + s4 * t566;
        let t581 = -t6;
        let t582 = -t11;
        let t583 = -t36;
        let t584 = -t21;
        let t585 = -t22;
        let t586 = -t72;
        let t587 = -t59;
        let t588 = -t126;
        put(32, t577); // row 1, YZ6
        put(34, t581); // row 2, MSZ2
        put(37, t582); // row 2, XY2R
        put(64, t580); // row 2, YZ6
        put(65, t583); // row 3, M3R
        put(67, t584); // row 3, MSY3
        put(68, t585); // row 3, MSZ3R
        put(69, t586); // row 3, MSX4
        put(80, t587); // row 4, XY4
        put(96, t572); // row 4, YZ6
        put(111, t566); // row 5, YZ6
        put(119, t588); // row 6, YZ6
    }
}
