//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil and Dombre, 12.4.
//!
//! 811 multiplications, 573 additions; 7 x 84, 266 of 588 structurally nonzero.

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
    let L2 = S::constant(0.4);
    let L3 = S::constant(0.39);
    let k0 = S::constant(9.81);
    let k3 = S::constant(0.16000000000000003);
    let k4 = S::constant(0.8);
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
        put(58, dq1); // row 1, FV1
        put(60, a2_y); // row 2, MSX2
        put(64, ddq2); // row 2, ZZ2
        put(66, t2); // row 2, XZ2
        put(67, t3); // row 2, YZ2
        put(118, dq2); // row 2, FV2
        put(167, dq3); // row 3, FV3
        put(207, dq4); // row 4, FV4
        put(235, dq5); // row 5, FV5
        put(254, dq6); // row 6, FV6
        put(264, dq7); // row 7, FV7
        [w2_x, w2_y, a2_x, a2_y, t6, t7, dw2_x, dw2_y]
    };
    // link 3: motion
    let [
        w3_x, t15, t22, t23, t24, t25, t26, t27,
        t29, t30, t31, t32, a3_z, t40, t43, w3_z,
        t47, t48, dw3_z,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t15 = c3 * dq2 + s3 * w2_x;
        let t22 = w2_x * w2_x;
        let t23 = w2_y * w2_y;
        let t24 = dq2 * dq2;
        let t25 = w2_x * w2_y;
        let t26 = t25 - ddq2;
        let t27 = ddq2 + t25;
        let t29 = dw2_y - t7;
        let t30 = t6 + dw2_x;
        let t31 = c3 * a2_x;
        let t32 = s3 * a2_x;
        let t35 = L2 * t30;
        let t36 = a2_x + L2 * t26;
        let a3_z = a2_y - L2 * (t22 + t24);
        let t40 = s3 * t35 - c3 * t36;
        let t43 = c3 * t35 + s3 * t36;
        let w3_z = w2_y + dq3;
        let t47 = dq3 * t15 - (c3 * dw2_x - s3 * ddq2);
        let t48 = c3 * ddq2 + s3 * dw2_x + dq3 * w3_x;
        let dw3_z = dw2_y + ddq3;
        put(63, t25); // row 2, YY2
        put(124, dw3_z); // row 3, ZZ3
        [
        w3_x, t15, t22, t23, t24, t25, t26, t27,
        t29, t30, t31, t32, a3_z, t40, t43, w3_z,
        t47, t48, dw3_z,
    ]
    };
    // link 4: motion
    let [
        t52, t55, t62, t63, t64, t65, t66, t67,
        t68, t69, t70, t71, t72, t73, t76, a4_y,
        t80, t83, t84, dw4_z,
    ] = {
        let t52 = s4 * w3_z - c4 * w3_x;
        let t55 = c4 * w3_z + s4 * w3_x;
        let t62 = w3_x * w3_x;
        let t63 = t15 * t15;
        let t64 = w3_z * w3_z;
        let t65 = w3_x * t15;
        let t66 = w3_x * w3_z;
        let t67 = t15 * w3_z;
        let t68 = dw3_z + t65;
        let t69 = t66 - t48;
        let t70 = dw3_z - t65;
        let t71 = t67 - t47;
        let t72 = t48 + t66;
        let t73 = t47 + t67;
        let t76 = c4 * t40 + s4 * a3_z;
        let a4_y = s4 * t40 - c4 * a3_z;
        let t80 = t15 - dq4;
        let t83 = c4 * t47 + s4 * dw3_z + dq4 * t55;
        let t84 = s4 * t47 - c4 * dw3_z + dq4 * t52;
        let dw4_z = ddq4 - t48;
        put(122, t65); // row 3, XX3
        put(126, t71); // row 3, XZ3
        put(127, t69); // row 3, YZ3
        put(169, a4_y); // row 4, MSX4
        put(170, t76); // row 4, MSY4
        put(173, dw4_z); // row 4, ZZ4
        [
        t52, t55, t62, t63, t64, t65, t66, t67,
        t68, t69, t70, t71, t72, t73, t76, a4_y,
        t80, t83, t84, dw4_z,
    ]
    };
    // link 5: motion
    let [
        t88, t91, t98, t99, t100, t101, t102, t103,
        t104, t105, t106, t107, t108, t109, t110, t111,
        t112, t117, t121, a5_y, w5_z, t128, dw5_y, dw5_z,
    ] = {
        let t88 = c5 * t52 + s5 * t80;
        let t91 = c5 * t80 - s5 * t52;
        let t98 = t52 * t52;
        let t99 = t55 * t55;
        let t100 = t80 * t80;
        let t101 = t52 * t55;
        let t102 = t52 * t80;
        let t103 = t55 * t80;
        let t104 = t99 + t100;
        let t105 = t101 - dw4_z;
        let t106 = t84 + t102;
        let t107 = dw4_z + t101;
        let t108 = t98 + t100;
        let t109 = t83 + t103;
        let t110 = t102 - t84;
        let t111 = t103 - t83;
        let t112 = t98 + t99;
        let t116 = t76 + L3 * t105;
        let t117 = a4_y + L3 * t108;
        let t118 = t43 + L3 * t111;
        let t121 = c5 * t116 + s5 * t118;
        let a5_y = s5 * t116 - c5 * t118;
        let w5_z = t55 + dq5;
        let t128 = c5 * t83 - s5 * dw4_z + dq5 * t91;
        let dw5_y = c5 * dw4_z + s5 * t83 + dq5 * t88;
        let dw5_z = ddq5 - t84;
        put(172, t101); // row 4, YY4
        put(176, t106); // row 4, YZ4
        put(209, a5_y); // row 5, MSX5
        put(210, t121); // row 5, MSY5
        put(213, dw5_z); // row 5, ZZ5
        [
        t88, t91, t98, t99, t100, t101, t102, t103,
        t104, t105, t106, t107, t108, t109, t110, t111,
        t112, t117, t121, a5_y, w5_z, t128, dw5_y, dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t143, t144, t145, t146, t147, t148,
        t149, t150, t151, t152, t153, t154, t155, t156,
        t157, t160, t163, w6_z, dw6_x, dw6_y, dw6_z,
    ] = {
        let w6_x = s6 * w5_z - c6 * t88;
        let w6_y = c6 * w5_z + s6 * t88;
        let t143 = t88 * t88;
        let t144 = t91 * t91;
        let t145 = w5_z * w5_z;
        let t146 = t88 * t91;
        let t147 = t88 * w5_z;
        let t148 = t91 * w5_z;
        let t149 = t144 + t145;
        let t150 = dw5_z - t146;
        let t151 = dw5_y - t147;
        let t152 = dw5_z + t146;
        let t153 = t143 + t145;
        let t154 = t148 - t128;
        let t155 = dw5_y + t147;
        let t156 = t128 + t148;
        let t157 = t143 + t144;
        let t160 = c6 * t121 + s6 * t117;
        let t163 = c6 * t117 - s6 * t121;
        let w6_z = t91 + dq6;
        let dw6_x = s6 * dw5_z - c6 * t128 + dq6 * w6_y;
        let dw6_y = c6 * dw5_z + s6 * t128 - dq6 * w6_x;
        let dw6_z = ddq6 - dw5_y;
        put(212, t146); // row 5, YY5
        put(215, t154); // row 5, XZ5
        put(216, t151); // row 5, YZ5
        put(238, t160); // row 6, MSY6
        put(241, dw6_z); // row 6, ZZ6
        [
        w6_x, w6_y, t143, t144, t145, t146, t147, t148,
        t149, t150, t151, t152, t153, t154, t155, t156,
        t157, t160, t163, w6_z, dw6_x, dw6_y, dw6_z,
    ]
    };
    // link 7: motion
    let [
        w7_x, t175, t182, t183, t184, t185, t186, t187,
        t188, t189, t190, t191, t192, t193, t194, t195,
        t196, t199, a7_y, w7_z, t206, t207, dw7_z,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t175 = c7 * w6_z + s7 * w6_x;
        let t182 = w6_x * w6_x;
        let t183 = w6_y * w6_y;
        let t184 = w6_z * w6_z;
        let t185 = w6_x * w6_y;
        let t186 = w6_x * w6_z;
        let t187 = w6_y * w6_z;
        let t188 = t183 + t184;
        let t189 = dw6_z - t185;
        let t190 = dw6_y + t186;
        let t191 = dw6_z + t185;
        let t192 = t182 + t184;
        let t193 = dw6_x - t187;
        let t194 = dw6_y - t186;
        let t195 = dw6_x + t187;
        let t196 = t182 + t183;
        let t199 = c7 * t160 - s7 * a5_y;
        let a7_y = c7 * a5_y + s7 * t160;
        let w7_z = w6_y + dq7;
        let t206 = s7 * dw6_z - c7 * dw6_x + dq7 * t175;
        let t207 = c7 * dw6_z + s7 * dw6_x + dq7 * w7_x;
        let dw7_z = dw6_y + ddq7;
        put(240, t185); // row 6, YY6
        put(243, t193); // row 6, XZ6
        put(244, t190); // row 6, YZ6
        put(256, a7_y); // row 7, MSX7
        put(257, t199); // row 7, MSY7
        put(260, dw7_z); // row 7, ZZ7
        [
        w7_x, t175, t182, t183, t184, t185, t186, t187,
        t188, t189, t190, t191, t192, t193, t194, t195,
        t196, t199, a7_y, w7_z, t206, t207, dw7_z,
    ]
    };
    // joint axes in frame 3
    let [z1_3_x, t210] = {
        let z1_3_x = s2 * c3;
        let t210 = s2 * s3;
        [z1_3_x, t210]
    };
    // joint axes in frame 4
    let [t213, z1_5_z, t217, z2_4_y] = {
        let t213 = c2 * s4 - c4 * z1_3_x;
        let z1_5_z = c2 * c4 + s4 * z1_3_x;
        let t217 = s3 * c4;
        let z2_4_y = s3 * s4;
        [t213, z1_5_z, t217, z2_4_y]
    };
    // joint axes in frame 5
    let [t221, z1_6_z, t227, t230, t231, z3_5_y] = {
        let t221 = c5 * t213 + s5 * t210;
        let z1_6_z = c5 * t210 - s5 * t213;
        let t227 = c5 * t217 + c3 * s5;
        let t230 = c3 * c5 - s5 * t217;
        let t231 = s4 * c5;
        let z3_5_y = s4 * s5;
        [t221, z1_6_z, t227, t230, t231, z3_5_y]
    };
    // MSZ2: column
    {
        let t235 = c2 * a2_x - s2 * a2_y;
        put(1, t235); // row 1, MSZ2
    }
    // XX2: column
    let t237 = {
        let t237 = c2 * t7;
        let t238 = s2 * dw2_x + t237;
        put(2, t238); // row 1, XX2
        t237
    };
    // YY2: column
    let t239 = {
        let t239 = s2 * t6;
        let t241 = c2 * dw2_y - t239;
        put(3, t241); // row 1, YY2
        t239
    };
    // ZZ2: column
    {
        let t242 = t239 - t237;
        put(4, t242); // row 1, ZZ2
    }
    // XY2: column
    {
        let t243 = t22 - t23;
        let t246 = s2 * t29 + c2 * t30;
        put(5, t246); // row 1, XY2
        put(65, t243); // row 2, XY2
    }
    // XZ2: column
    {
        let t250 = s2 * t27 + c2 * (t24 - t22);
        put(6, t250); // row 1, XZ2
    }
    // YZ2: column
    {
        let t254 = s2 * (t23 - t24) - c2 * t26;
        put(7, t254); // row 1, YZ2
    }
    // MSZ3: column
    let [t257, t260, t261, t262] = {
        let t257 = t32 * z1_3_x - t31 * t210;
        let t260 = s3 * t32 + c3 * t31;
        let t261 = L2 * t257;
        let t262 = L2 * t260;
        [t257, t260, t261, t262]
    };
    // XX3: column
    let [t264, t265, t267, t269, t270] = {
        let t264 = t66 * t210;
        let t265 = c2 * t65;
        let t267 = t265 - (t47 * z1_3_x + t264);
        let t269 = c3 * t66;
        let t270 = s3 * t47 - t269;
        put(12, t267); // row 1, XX3
        put(72, t270); // row 2, XX3
        [t264, t265, t267, t269, t270]
    };
    // YY3: column
    let [t271, t275, t278, t279] = {
        let t271 = t67 * z1_3_x;
        let t274 = t271 + t48 * t210 - t265;
        let t275 = s3 * t67;
        let t277 = c3 * t48 - t275;
        let t278 = t267 + t274;
        let t279 = t270 + t277;
        let t281 = t261 + t278 * k3;
        let t283 = t279 * k3 - t262;
        put(8, t281); // row 1, M3
        put(13, t274); // row 1, YY3
        put(68, t283); // row 2, M3
        put(73, t277); // row 2, YY3
        [t271, t275, t278, t279]
    };
    // MSX3: column
    let [t286, t287] = {
        let t286 = a2_y * t210 - c2 * t32;
        let t287 = c3 * a2_y;
        [t286, t287]
    };
    // XZ3: column
    let t302 = {
        let t288 = t62 - t64;
        let t293 = c2 * t71 + (t70 * z1_3_x + t210 * t288);
        let t296 = c3 * t288 - s3 * t70;
        let t298 = t286 - L2 * t293;
        let t300 = t287 - L2 * t296;
        let t302 = t32 + L2 * t71;
        put(9, t298); // row 1, MSX3
        put(16, t293); // row 1, XZ3
        put(69, t300); // row 2, MSX3
        put(76, t296); // row 2, XZ3
        t302
    };
    // MSY3: column
    let [t305, t306] = {
        let t305 = a2_y * z1_3_x - c2 * t31;
        let t306 = s3 * a2_y;
        [t305, t306]
    };
    // YZ3: column
    let [t315, t321] = {
        let t307 = t63 - t64;
        let t312 = c2 * t69 - (t68 * t210 - z1_3_x * t307);
        let t315 = s3 * t307 + c3 * t68;
        let t317 = t305 - L2 * t312;
        let t319 = L2 * t315 - t306;
        let t321 = t31 + L2 * t69;
        put(10, t317); // row 1, MSY3
        put(17, t312); // row 1, YZ3
        put(70, t319); // row 2, MSY3
        [t315, t321]
    };
    // YY3: column
    {
        let t323 = t257 + t278 * k4;
        let t325 = t279 * k4 - t260;
        put(11, t323); // row 1, MSZ3
        put(71, t325); // row 2, MSZ3
    }
    // ZZ3: column
    {
        let t328 = c2 * dw3_z + (t264 - t271);
        let t329 = t269 + t275;
        put(14, t328); // row 1, ZZ3
        put(74, t329); // row 2, ZZ3
    }
    // XY3: column
    {
        let t330 = t62 - t63;
        let t335 = c2 * t330 - (t72 * z1_3_x - t73 * t210);
        let t338 = s3 * t72 + c3 * t73;
        put(15, t335); // row 1, XY3
        put(75, t338); // row 2, XY3
        put(125, t330); // row 3, XY3
    }
    // M4: column
    let [t341, t344] = {
        let t341 = c4 * t76 + s4 * a4_y;
        let t344 = s4 * t76 - c4 * a4_y;
        let t345 = L2 * t43;
        let t346 = L2 * t341;
        let t349 = z1_3_x * t345 + t210 * t346;
        let t352 = c3 * t346 - s3 * t345;
        put(18, t349); // row 1, M4
        put(78, t352); // row 2, M4
        put(130, t341); // row 3, MSZ4
        [t341, t344]
    };
    // MSX4: column
    let [t354, t356, t357] = {
        let t354 = s4 * t107;
        let t356 = s4 * t43;
        let t357 = c4 * t43;
        let t360 = t356 + L2 * t110;
        let t361 = L2 * (c4 * t104 + t354) - a4_y;
        let t366 = t210 * t361 - z1_3_x * t360 - c2 * t357;
        let t369 = s3 * t360 + c3 * t361;
        put(19, t366); // row 1, MSX4
        put(79, t369); // row 2, MSX4
        put(129, t356); // row 3, MSY4
        [t354, t356, t357]
    };
    // MSY4: column
    let t370 = {
        let t370 = c4 * t105;
        let t375 = t357 + L2 * t111;
        let t376 = t76 + L2 * (t370 + s4 * t108);
        let t381 = c2 * t356 - (z1_3_x * t375 + t210 * t376);
        let t384 = s3 * t375 - c3 * t376;
        put(20, t381); // row 1, MSY4
        put(80, t384); // row 2, MSY4
        t370
    };
    // MSZ4: column
    {
        let t389 = L2 * (s4 * t109 - c4 * t106);
        let t390 = t344 + L2 * t112;
        let t395 = c2 * t341 + (z1_3_x * t390 + t210 * t389);
        let t398 = c3 * t389 - s3 * t390;
        put(21, t395); // row 1, MSZ4
        put(81, t398); // row 2, MSZ4
    }
    // XX4: column
    let [t400, t401, t405, t406, t410] = {
        let t400 = t102 * z1_5_z;
        let t401 = t101 * t210;
        let t403 = t401 - (t400 - t83 * t213);
        let t405 = t102 * z2_4_y;
        let t406 = c3 * t101;
        let t408 = t406 + (t83 * t217 + t405);
        let t410 = c4 * t102;
        let t411 = s4 * t83 - t410;
        put(22, t403); // row 1, XX4
        put(82, t408); // row 2, XX4
        put(131, t411); // row 3, XX4
        [t400, t401, t405, t406, t410]
    };
    // YY4: column
    let [t412, t415, t416, t420] = {
        let t412 = t103 * t213;
        let t415 = t401 + (t84 * z1_5_z - t412);
        let t416 = t103 * t217;
        let t419 = t416 + t84 * z2_4_y - t406;
        let t420 = s4 * t103;
        let t422 = t420 - c4 * t84;
        put(83, t419); // row 2, YY4
        put(132, t422); // row 3, YY4
        [t412, t415, t416, t420]
    };
    // ZZ4: column
    let t428 = {
        let t425 = t400 - t412 - dw4_z * t210;
        let t428 = c3 * dw4_z + (t405 + t416);
        let t429 = t410 - t420;
        put(24, t425); // row 1, ZZ4
        put(133, t429); // row 3, ZZ4
        t428
    };
    // XY4: column
    {
        let t430 = t98 - t99;
        let t435 = t110 * t213 - t111 * z1_5_z - t210 * t430;
        let t440 = t110 * t217 + t111 * z2_4_y - c3 * t430;
        let t443 = s4 * t110 - c4 * t111;
        put(25, t435); // row 1, XY4
        put(85, t440); // row 2, XY4
        put(134, t443); // row 3, XY4
        put(174, t430); // row 4, XY4
    }
    // XZ4: column
    {
        let t444 = t98 - t100;
        let t449 = t109 * t210 + (z1_5_z * t444 - t107 * t213);
        let t454 = c3 * t109 - (t107 * t217 + z2_4_y * t444);
        let t456 = c4 * t444 - t354;
        put(26, t449); // row 1, XZ4
        put(86, t454); // row 2, XZ4
        put(135, t456); // row 3, XZ4
    }
    // YZ4: column
    {
        let t457 = t100 - t99;
        let t462 = t213 * t457 + t105 * z1_5_z - t106 * t210;
        let t467 = t217 * t457 - t105 * z2_4_y - c3 * t106;
        let t469 = t370 + s4 * t457;
        put(27, t462); // row 1, YZ4
        put(87, t467); // row 2, YZ4
        put(136, t469); // row 3, YZ4
    }
    // M5: column
    let [t471, t472, t474, t475, t477] = {
        let t471 = s5 * a5_y;
        let t472 = c5 * t121 + t471;
        let t474 = c5 * a5_y;
        let t475 = t474 - s5 * t121;
        let t476 = L3 * t475;
        let t477 = L3 * t472;
        let t482 = s4 * t476;
        let t485 = c4 * t476 + L2 * t475;
        let t486 = t477 + L2 * (c4 * t472 + s4 * t117);
        let t491 = c2 * t482 + (t210 * t486 - z1_3_x * t485);
        let t494 = s3 * t485 + c3 * t486;
        put(28, t491); // row 1, M5
        put(88, t494); // row 2, M5
        put(137, t482); // row 3, M5
        [t471, t472, t474, t475, t477]
    };
    // MSX5: column
    let [t496, t501, t502] = {
        let t496 = s5 * t152;
        let t497 = c5 * t149 + t496;
        let t500 = c5 * t152 - s5 * t149;
        let t501 = s5 * t117;
        let t502 = c5 * t117;
        let t505 = t501 + L3 * t500;
        let t506 = t502 - L3 * t497;
        let t515 = s4 * t505 + c4 * a5_y;
        let t518 = L2 * t500 - (s4 * a5_y - c4 * t505);
        let t519 = L2 * (c4 * t497 + s4 * t155) - t506;
        let t524 = c2 * t515 - (z1_3_x * t518 - t210 * t519);
        let t527 = s3 * t518 + c3 * t519;
        put(29, t524); // row 1, MSX5
        put(89, t527); // row 2, MSX5
        put(138, t515); // row 3, MSX5
        put(178, t506); // row 4, MSX5
        [t496, t501, t502]
    };
    // MSY5: column
    let t528 = {
        let t528 = c5 * t150;
        let t530 = s5 * t153 - t528;
        let t533 = s5 * t150 + c5 * t153;
        let t536 = t502 - L3 * t533;
        let t537 = L3 * t530 - t501;
        let t546 = s4 * t536 + c4 * t121;
        let t549 = s4 * t121 - c4 * t536 + L2 * t533;
        let t550 = L2 * (s4 * t156 - c4 * t530) - t537;
        let t555 = c2 * t546 + (z1_3_x * t549 + t210 * t550);
        let t558 = c3 * t550 - s3 * t549;
        put(30, t555); // row 1, MSY5
        put(90, t558); // row 2, MSY5
        put(139, t546); // row 3, MSY5
        put(179, t537); // row 4, MSY5
        t528
    };
    // MSZ5: column
    {
        let t561 = c5 * t151 + s5 * t154;
        let t564 = s5 * t151 - c5 * t154;
        let t567 = t475 + L3 * t564;
        let t568 = L3 * t561 - t472;
        let t573 = s4 * t567;
        let t576 = c4 * t567 + L2 * t564;
        let t577 = L2 * (s4 * t157 - c4 * t561) - t568;
        let t582 = c2 * t573 + (t210 * t577 - z1_3_x * t576);
        let t585 = s3 * t576 + c3 * t577;
        put(31, t582); // row 1, MSZ5
        put(91, t585); // row 2, MSZ5
        put(140, t573); // row 3, MSZ5
        put(180, t568); // row 4, MSZ5
    }
    // XX5: column
    let [t587, t588, t592, t593, t597, t598, t602, t603] = {
        let t587 = t147 * z1_6_z;
        let t588 = t146 * z1_5_z;
        let t590 = t128 * t221 + t587 - t588;
        let t592 = t147 * t230;
        let t593 = t146 * z2_4_y;
        let t595 = t593 + (t128 * t227 + t592);
        let t597 = t147 * z3_5_y;
        let t598 = c4 * t146;
        let t600 = t128 * t231 - t597 - t598;
        let t602 = c5 * t147;
        let t603 = s5 * t128 + t602;
        put(32, t590); // row 1, XX5
        put(92, t595); // row 2, XX5
        put(141, t600); // row 3, XX5
        [t587, t588, t592, t593, t597, t598, t602, t603]
    };
    // YY5: column
    let [t604, t608, t611, t612, t616] = {
        let t604 = t148 * t221;
        let t607 = t588 - (t604 + dw5_y * z1_6_z);
        let t608 = t148 * t227;
        let t611 = t593 + (t608 + dw5_y * t230);
        let t612 = t148 * t231;
        let t615 = t598 - (t612 - dw5_y * z3_5_y);
        let t616 = s5 * t148;
        let t618 = t616 + c5 * dw5_y;
        put(33, t607); // row 1, YY5
        put(142, t615); // row 3, YY5
        put(182, t618); // row 4, YY5
        [t604, t608, t611, t612, t616]
    };
    // ZZ5: column
    {
        let t621 = dw5_z * z1_5_z + (t604 - t587);
        let t624 = t608 - t592 - dw5_z * z2_4_y;
        let t627 = c4 * dw5_z + (t597 + t612);
        let t628 = t602 - t616;
        put(34, t621); // row 1, ZZ5
        put(94, t624); // row 2, ZZ5
        put(143, t627); // row 3, ZZ5
        put(183, t628); // row 4, ZZ5
    }
    // XY5: column
    {
        let t629 = t143 - t144;
        let t634 = z1_5_z * t629 - (t155 * t221 - t156 * z1_6_z);
        let t639 = t156 * t230 - t155 * t227 - z2_4_y * t629;
        let t644 = c4 * t629 - (t155 * t231 + t156 * z3_5_y);
        let t647 = s5 * t155 - c5 * t156;
        put(35, t634); // row 1, XY5
        put(95, t639); // row 2, XY5
        put(144, t644); // row 3, XY5
        put(184, t647); // row 4, XY5
        put(214, t629); // row 5, XY5
    }
    // XZ5: column
    {
        let t648 = t143 - t145;
        let t653 = t154 * z1_5_z + (z1_6_z * t648 - t152 * t221);
        let t658 = t230 * t648 - t152 * t227 - t154 * z2_4_y;
        let t663 = c4 * t154 - (t152 * t231 + z3_5_y * t648);
        let t665 = t496 - c5 * t648;
        put(36, t653); // row 1, XZ5
        put(96, t658); // row 2, XZ5
        put(145, t663); // row 3, XZ5
        put(185, t665); // row 4, XZ5
    }
    // YZ5: column
    {
        let t666 = t145 - t144;
        let t671 = t151 * z1_5_z + (t221 * t666 - t150 * z1_6_z);
        let t676 = t227 * t666 - t150 * t230 - t151 * z2_4_y;
        let t681 = c4 * t151 + (t231 * t666 + t150 * z3_5_y);
        let t683 = t528 - s5 * t666;
        put(37, t671); // row 1, YZ5
        put(97, t676); // row 2, YZ5
        put(146, t681); // row 3, YZ5
        put(186, t683); // row 4, YZ5
    }
    // M6: column
    let [t685, t686, t688, t689] = {
        let t685 = s6 * t163;
        let t686 = t685 - c6 * t160;
        let t688 = c6 * t163;
        let t689 = s6 * t160 + t688;
        let t691 = c5 * t686 - t471;
        let t693 = t474 + s5 * t686;
        let t694 = L3 * t693;
        let t695 = L3 * t691;
        let t700 = s4 * t694;
        let t703 = c4 * t694 + L2 * t693;
        let t704 = L2 * (s4 * t689 - c4 * t691) - t695;
        let t709 = c2 * t700 + (t210 * t704 - z1_3_x * t703);
        let t712 = s3 * t703 + c3 * t704;
        put(38, t709); // row 1, M6
        put(98, t712); // row 2, M6
        put(147, t700); // row 3, M6
        put(187, t695); // row 4, M6
        put(219, t686); // row 5, MSZ6
        [t685, t686, t688, t689]
    };
    // MSX6: column
    let [t714, t717, t719, t720] = {
        let t714 = s6 * t191;
        let t715 = c6 * t188 + t714;
        let t717 = c6 * t191;
        let t719 = s6 * a5_y;
        let t720 = c6 * a5_y;
        let t723 = c5 * t715 + s5 * t194;
        let t726 = c5 * t194 - s5 * t715;
        let t735 = c5 * t719 + s5 * t163 + L3 * t726;
        let t736 = c5 * t163 - s5 * t719 - L3 * t723;
        let t745 = s4 * t735 + c4 * t720;
        let t748 = c4 * t735 - s4 * t720 + L2 * t726;
        let t749 = t736 - L2 * (c4 * t723 + s4 * (s6 * t188 - t717));
        let t754 = c2 * t745 - (z1_3_x * t748 + t210 * t749);
        let t757 = s3 * t748 - c3 * t749;
        put(39, t754); // row 1, MSX6
        put(99, t757); // row 2, MSX6
        put(148, t745); // row 3, MSX6
        put(188, t736); // row 4, MSX6
        put(217, t720); // row 5, MSX6
        [t714, t717, t719, t720]
    };
    // MSY6: column
    let [t758, t761] = {
        let t758 = c6 * t189;
        let t760 = s6 * t192 - t758;
        let t761 = s6 * t189;
        let t766 = c5 * t760 + s5 * t195;
        let t769 = s5 * t760 - c5 * t195;
        let t778 = c5 * t720 - s5 * t160 + L3 * t769;
        let t779 = L3 * t766 - (s5 * t720 + c5 * t160);
        let t788 = s4 * t778 - c4 * t719;
        let t791 = c4 * t778 + s4 * t719 + L2 * t769;
        let t792 = t779 + L2 * (c4 * t766 - s4 * (t761 + c6 * t192));
        let t797 = c2 * t788 - (z1_3_x * t791 + t210 * t792);
        let t800 = s3 * t791 - c3 * t792;
        put(40, t797); // row 1, MSY6
        put(100, t800); // row 2, MSY6
        put(149, t788); // row 3, MSY6
        put(189, t779); // row 4, MSY6
        [t758, t761]
    };
    // MSZ6: column
    {
        let t803 = c6 * t190 + s6 * t193;
        let t809 = c5 * t803 - s5 * t196;
        let t812 = s5 * t803 + c5 * t196;
        let t817 = c5 * t689 - L3 * t812;
        let t818 = s5 * t689 + L3 * t809;
        let t827 = c4 * t686 - s4 * t817;
        let t830 = L2 * t812 - (c4 * t817 + s4 * t686);
        let t831 = L2 * (s4 * (c6 * t193 - s6 * t190) - c4 * t809) - t818;
        let t836 = c2 * t827 + (t210 * t831 - z1_3_x * t830);
        let t839 = s3 * t830 + c3 * t831;
        put(41, t836); // row 1, MSZ6
        put(101, t839); // row 2, MSZ6
        put(150, t827); // row 3, MSZ6
        put(190, t818); // row 4, MSZ6
    }
    // XX6: column
    let [t841, t844, t847, t852, t857, t862] = {
        let t841 = s6 * t186;
        let t842 = t841 - c6 * dw6_x;
        let t844 = c6 * t186;
        let t845 = s6 * dw6_x + t844;
        let t847 = t185 * z1_6_z;
        let t850 = z1_5_z * t845 - (t847 - t221 * t842);
        let t852 = t185 * t230;
        let t855 = t227 * t842 - t852 - z2_4_y * t845;
        let t857 = t185 * z3_5_y;
        let t860 = c4 * t845 + (t231 * t842 + t857);
        let t862 = c5 * t185;
        let t863 = t862 - s5 * t842;
        put(42, t850); // row 1, XX6
        put(102, t855); // row 2, XX6
        put(151, t860); // row 3, XX6
        put(191, t863); // row 4, XX6
        put(220, t845); // row 5, XX6
        [t841, t844, t847, t852, t857, t862]
    };
    // YY6: column
    let [t864, t867, t883] = {
        let t864 = c6 * t187;
        let t866 = t864 + s6 * dw6_y;
        let t867 = s6 * t187;
        let t869 = c6 * dw6_y - t867;
        let t873 = z1_5_z * t869 + (t847 + t221 * t866);
        let t877 = t852 + t227 * t866 - z2_4_y * t869;
        let t881 = c4 * t869 + (t231 * t866 - t857);
        let t883 = t862 + s5 * t866;
        put(43, t873); // row 1, YY6
        put(103, t877); // row 2, YY6
        put(152, t881); // row 3, YY6
        put(221, t869); // row 5, YY6
        [t864, t867, t883]
    };
    // ZZ6: column
    {
        let t884 = t841 + t864;
        let t885 = t867 - t844;
        let t890 = z1_5_z * t885 - (t221 * t884 - dw6_z * z1_6_z);
        let t895 = dw6_z * t230 - t227 * t884 - z2_4_y * t885;
        let t900 = c4 * t885 - (t231 * t884 + dw6_z * z3_5_y);
        let t903 = s5 * t884 - c5 * dw6_z;
        put(44, t890); // row 1, ZZ6
        put(104, t895); // row 2, ZZ6
        put(153, t900); // row 3, ZZ6
        put(193, t903); // row 4, ZZ6
        put(222, t885); // row 5, ZZ6
    }
    // XY6: column
    {
        let t904 = t182 - t183;
        let t907 = c6 * t194 - s6 * t195;
        let t910 = s6 * t194 + c6 * t195;
        let t915 = z1_5_z * t910 - (t221 * t907 - z1_6_z * t904);
        let t920 = t230 * t904 - t227 * t907 - z2_4_y * t910;
        let t925 = c4 * t910 - (t231 * t907 + z3_5_y * t904);
        let t928 = s5 * t907 - c5 * t904;
        put(45, t915); // row 1, XY6
        put(105, t920); // row 2, XY6
        put(154, t925); // row 3, XY6
        put(194, t928); // row 4, XY6
        put(223, t910); // row 5, XY6
        put(242, t904); // row 6, XY6
    }
    // XZ6: column
    {
        let t929 = t184 - t182;
        let t931 = t717 - s6 * t929;
        let t933 = t714 + c6 * t929;
        let t938 = z1_5_z * t933 - (t221 * t931 - t193 * z1_6_z);
        let t943 = t193 * t230 - t227 * t931 - z2_4_y * t933;
        let t948 = c4 * t933 - (t231 * t931 + t193 * z3_5_y);
        let t951 = s5 * t931 - c5 * t193;
        put(46, t938); // row 1, XZ6
        put(106, t943); // row 2, XZ6
        put(155, t948); // row 3, XZ6
        put(195, t951); // row 4, XZ6
        put(224, t933); // row 5, XZ6
    }
    // YZ6: column
    {
        let t952 = t183 - t184;
        let t954 = c6 * t952 - t761;
        let t956 = t758 + s6 * t952;
        let t961 = z1_5_z * t956 + (t190 * z1_6_z - t221 * t954);
        let t966 = t190 * t230 - t227 * t954 - z2_4_y * t956;
        let t971 = c4 * t956 - (t231 * t954 + t190 * z3_5_y);
        let t974 = s5 * t954 - c5 * t190;
        put(47, t961); // row 1, YZ6
        put(107, t966); // row 2, YZ6
        put(156, t971); // row 3, YZ6
        put(196, t974); // row 4, YZ6
        put(225, t956); // row 5, YZ6
    }
    // M7: column
    let [
        t975, t976, t977, t978, t979, t980, t981, t982,
        t983, t984, t985, t986, t987, t988, t989, t992,
        t995,
    ] = {
        let t975 = w7_x * w7_x;
        let t976 = t175 * t175;
        let t977 = w7_z * w7_z;
        let t978 = w7_x * t175;
        let t979 = w7_x * w7_z;
        let t980 = t175 * w7_z;
        let t981 = t976 + t977;
        let t982 = dw7_z + t978;
        let t983 = t979 - t207;
        let t984 = t978 - dw7_z;
        let t985 = t975 + t977;
        let t986 = t980 - t206;
        let t987 = t207 + t979;
        let t988 = t206 + t980;
        let t989 = t975 + t976;
        let t992 = c7 * t199 + s7 * a7_y;
        let t995 = s7 * t199 - c7 * a7_y;
        let t997 = t685 - c6 * t992;
        let t1002 = c5 * t997 + s5 * t995;
        let t1005 = s5 * t997 - c5 * t995;
        let t1006 = L3 * t1005;
        let t1007 = L3 * t1002;
        let t1012 = s4 * t1006;
        let t1015 = c4 * t1006 + L2 * t1005;
        let t1016 = L2 * (s4 * (t688 + s6 * t992) - c4 * t1002) - t1007;
        let t1021 = c2 * t1012 - (z1_3_x * t1015 - t210 * t1016);
        let t1024 = s3 * t1015 + c3 * t1016;
        put(48, t1021); // row 1, M7
        put(108, t1024); // row 2, M7
        put(157, t1012); // row 3, M7
        put(197, t1007); // row 4, M7
        put(247, t992); // row 6, MSZ7
        put(258, t978); // row 7, XX7
        put(262, t986); // row 7, XZ7
        put(263, t983); // row 7, YZ7
        [
        t975, t976, t977, t978, t979, t980, t981, t982,
        t983, t984, t985, t986, t987, t988, t989, t992,
        t995,
    ]
    };
    // MSX7: column
    let [t1026, t1029, t1031, t1032] = {
        let t1026 = s7 * t984;
        let t1027 = t1026 - c7 * t981;
        let t1029 = c7 * t984;
        let t1030 = s7 * t981 + t1029;
        let t1031 = s7 * t163;
        let t1032 = c7 * t163;
        let t1035 = c6 * t1027 - s6 * t987;
        let t1041 = c6 * t1031 + s6 * a7_y;
        let t1044 = c6 * a7_y - s6 * t1031;
        let t1047 = c5 * t1035 + s5 * t1030;
        let t1050 = s5 * t1035 - c5 * t1030;
        let t1059 = c5 * t1041 + s5 * t1032 + L3 * t1050;
        let t1060 = L3 * t1047 - (s5 * t1041 - c5 * t1032);
        let t1069 = s4 * t1059 + c4 * t1044;
        let t1072 = c4 * t1059 - s4 * t1044 + L2 * t1050;
        let t1073 = t1060 + L2 * (c4 * t1047 + s4 * (s6 * t1027 + c6 * t987));
        let t1078 = c2 * t1069 - (z1_3_x * t1072 + t210 * t1073);
        let t1081 = s3 * t1072 - c3 * t1073;
        put(49, t1078); // row 1, MSX7
        put(109, t1081); // row 2, MSX7
        put(158, t1069); // row 3, MSX7
        put(198, t1060); // row 4, MSX7
        put(226, t1044); // row 5, MSX7
        put(246, t1031); // row 6, MSY7
        [t1026, t1029, t1031, t1032]
    };
    // MSY7: column
    let [t1082, t1085] = {
        let t1082 = c7 * t982;
        let t1084 = t1082 - s7 * t985;
        let t1085 = s7 * t982;
        let t1087 = t1085 + c7 * t985;
        let t1090 = c6 * t1084 - s6 * t988;
        let t1096 = c6 * t1032 + s6 * t199;
        let t1099 = c6 * t199 - s6 * t1032;
        let t1102 = s5 * t1087 - c5 * t1090;
        let t1105 = s5 * t1090 + c5 * t1087;
        let t1114 = L3 * t1105 - (c5 * t1096 - s5 * t1031);
        let t1115 = L3 * t1102 - (s5 * t1096 + c5 * t1031);
        let t1124 = c4 * t1099 - s4 * t1114;
        let t1127 = c4 * t1114 + s4 * t1099 + L2 * t1105;
        let t1128 = L2 * (s4 * (s6 * t1084 + c6 * t988) - c4 * t1102) - t1115;
        let t1133 = c2 * t1124 + (z1_3_x * t1127 + t210 * t1128);
        let t1136 = c3 * t1128 - s3 * t1127;
        put(50, t1133); // row 1, MSY7
        put(110, t1136); // row 2, MSY7
        put(159, t1124); // row 3, MSY7
        put(199, t1115); // row 4, MSY7
        put(227, t1099); // row 5, MSY7
        [t1082, t1085]
    };
    // MSZ7: column
    {
        let t1139 = c7 * t983 + s7 * t986;
        let t1142 = s7 * t983 - c7 * t986;
        let t1145 = c6 * t1139 + s6 * t989;
        let t1149 = c6 * t995;
        let t1150 = s6 * t995;
        let t1153 = c5 * t1145 - s5 * t1142;
        let t1156 = s5 * t1145 + c5 * t1142;
        let t1165 = c5 * t1149 + s5 * t992 - L3 * t1156;
        let t1166 = s5 * t1149 - c5 * t992 + L3 * t1153;
        let t1175 = c4 * t1150 - s4 * t1165;
        let t1178 = c4 * t1165 + s4 * t1150 - L2 * t1156;
        let t1179 = L2 * (s4 * (c6 * t989 - s6 * t1139) - c4 * t1153) - t1166;
        let t1184 = c2 * t1175 + (z1_3_x * t1178 + t210 * t1179);
        let t1187 = c3 * t1179 - s3 * t1178;
        put(51, t1184); // row 1, MSZ7
        put(111, t1187); // row 2, MSZ7
        put(160, t1175); // row 3, MSZ7
        put(200, t1166); // row 4, MSZ7
        put(228, t1150); // row 5, MSZ7
    }
    // XX7: column
    let [t1189, t1192, t1193, t1195, t1198] = {
        let t1189 = s7 * t979;
        let t1190 = c7 * t206 + t1189;
        let t1192 = c7 * t979;
        let t1193 = t1192 - s7 * t206;
        let t1195 = s6 * t978;
        let t1196 = c6 * t1190 + t1195;
        let t1198 = c6 * t978;
        let t1199 = t1198 - s6 * t1190;
        let t1204 = z1_5_z * t1199 + (t221 * t1196 - z1_6_z * t1193);
        let t1209 = t227 * t1196 - t230 * t1193 - z2_4_y * t1199;
        let t1214 = c4 * t1199 + (t231 * t1196 + z3_5_y * t1193);
        let t1217 = c5 * t1193 - s5 * t1196;
        put(52, t1204); // row 1, XX7
        put(112, t1209); // row 2, XX7
        put(161, t1214); // row 3, XX7
        put(201, t1217); // row 4, XX7
        put(229, t1199); // row 5, XX7
        [t1189, t1192, t1193, t1195, t1198]
    };
    // YY7: column
    let [t1218, t1221] = {
        let t1218 = c7 * t980;
        let t1220 = t1218 + s7 * t207;
        let t1221 = s7 * t980;
        let t1223 = c7 * t207 - t1221;
        let t1225 = t1195 + c6 * t1220;
        let t1227 = s6 * t1220 - t1198;
        let t1232 = z1_5_z * t1227 - (t221 * t1225 - z1_6_z * t1223);
        let t1237 = t230 * t1223 - t227 * t1225 - z2_4_y * t1227;
        let t1242 = c4 * t1227 - (t231 * t1225 + z3_5_y * t1223);
        let t1245 = s5 * t1225 - c5 * t1223;
        put(53, t1232); // row 1, YY7
        put(113, t1237); // row 2, YY7
        put(162, t1242); // row 3, YY7
        put(202, t1245); // row 4, YY7
        put(230, t1227); // row 5, YY7
        put(249, t1223); // row 6, YY7
        [t1218, t1221]
    };
    // ZZ7: column
    {
        let t1246 = t1189 - t1218;
        let t1247 = t1192 + t1221;
        let t1250 = c6 * t1246 - s6 * dw7_z;
        let t1253 = s6 * t1246 + c6 * dw7_z;
        let t1258 = z1_5_z * t1253 + (z1_6_z * t1247 - t221 * t1250);
        let t1263 = t230 * t1247 - t227 * t1250 - z2_4_y * t1253;
        let t1268 = c4 * t1253 - (t231 * t1250 + z3_5_y * t1247);
        let t1271 = s5 * t1250 - c5 * t1247;
        put(54, t1258); // row 1, ZZ7
        put(114, t1263); // row 2, ZZ7
        put(163, t1268); // row 3, ZZ7
        put(203, t1271); // row 4, ZZ7
        put(231, t1253); // row 5, ZZ7
        put(250, t1247); // row 6, ZZ7
    }
    // XY7: column
    {
        let t1272 = t975 - t976;
        let t1275 = s7 * t988 - c7 * t987;
        let t1278 = s7 * t987 + c7 * t988;
        let t1281 = c6 * t1275 - s6 * t1272;
        let t1284 = s6 * t1275 + c6 * t1272;
        let t1289 = z1_5_z * t1284 + (z1_6_z * t1278 - t221 * t1281);
        let t1294 = t230 * t1278 - t227 * t1281 - z2_4_y * t1284;
        let t1299 = c4 * t1284 - (t231 * t1281 + z3_5_y * t1278);
        let t1302 = s5 * t1281 - c5 * t1278;
        put(55, t1289); // row 1, XY7
        put(115, t1294); // row 2, XY7
        put(164, t1299); // row 3, XY7
        put(204, t1302); // row 4, XY7
        put(232, t1284); // row 5, XY7
        put(251, t1278); // row 6, XY7
        put(261, t1272); // row 7, XY7
    }
    // XZ7: column
    {
        let t1303 = t975 - t977;
        let t1305 = s7 * t1303 - t1029;
        let t1307 = t1026 + c7 * t1303;
        let t1310 = c6 * t1305 - s6 * t986;
        let t1313 = s6 * t1305 + c6 * t986;
        let t1318 = z1_5_z * t1313 + (z1_6_z * t1307 - t221 * t1310);
        let t1323 = t230 * t1307 - t227 * t1310 - z2_4_y * t1313;
        let t1328 = c4 * t1313 - (t231 * t1310 + z3_5_y * t1307);
        let t1331 = s5 * t1310 - c5 * t1307;
        put(56, t1318); // row 1, XZ7
        put(116, t1323); // row 2, XZ7
        put(165, t1328); // row 3, XZ7
        put(205, t1331); // row 4, XZ7
        put(233, t1313); // row 5, XZ7
        put(252, t1307); // row 6, XZ7
    }
    // YZ7: column
    {
        let t1332 = t977 - t976;
        let t1334 = t1085 + c7 * t1332;
        let t1336 = t1082 - s7 * t1332;
        let t1339 = c6 * t1334 + s6 * t983;
        let t1342 = c6 * t983 - s6 * t1334;
        let t1347 = z1_5_z * t1342 + (t221 * t1339 - z1_6_z * t1336);
        let t1352 = t227 * t1339 - t230 * t1336 - z2_4_y * t1342;
        let t1357 = c4 * t1342 + (t231 * t1339 + z3_5_y * t1336);
        let t1360 = c5 * t1336 - s5 * t1339;
        let t1361 = dq1.sign();
        let t1362 = dq2.sign();
        let t1363 = dq3.sign();
        let t1364 = dq4.sign();
        let t1365 = dq5.sign();
        let t1366 = dq6.sign();
        let t1367 = dq7.sign();
        let t1368 = -t415;
        let t1369 = -a2_x;
        let t1370 = -t25;
        let t1371 = -t315;
        let t1372 = -t428;
        let t1373 = -t611;
        let t1374 = -t302;
        let t1375 = -t321;
        let t1376 = -t65;
        let t1377 = -t357;
        let t1378 = -t101;
        let t1379 = -t109;
        let t1380 = -t477;
        let t1381 = -t603;
        let t1382 = -t883;
        let t1383 = -t146;
        let t1384 = -t719;
        let t1385 = -t163;
        let t1386 = -t185;
        let t1387 = -t1032;
        let t1388 = -t1193;
        let t1389 = -t1336;
        let t1390 = -t978;
        put(23, t1368); // row 1, YY4
        put(57, t1347); // row 1, YZ7
        put(59, t1361); // row 1, FC1
        put(61, t1369); // row 2, MSY2
        put(62, t1370); // row 2, XX2
        put(77, t1371); // row 2, YZ3
        put(84, t1372); // row 2, ZZ4
        put(93, t1373); // row 2, YY5
        put(117, t1352); // row 2, YZ7
        put(119, t1362); // row 2, FC2
        put(120, t1374); // row 3, MSX3
        put(121, t1375); // row 3, MSY3
        put(123, t1376); // row 3, YY3
        put(128, t1377); // row 3, MSX4
        put(166, t1357); // row 3, YZ7
        put(168, t1363); // row 3, FC3
        put(171, t1378); // row 4, XX4
        put(175, t1379); // row 4, XZ4
        put(177, t1380); // row 4, M5
        put(181, t1381); // row 4, XX5
        put(192, t1382); // row 4, YY6
        put(206, t1360); // row 4, YZ7
        put(208, t1364); // row 4, FC4
        put(211, t1383); // row 5, XX5
        put(218, t1384); // row 5, MSY6
        put(234, t1342); // row 5, YZ7
        put(236, t1365); // row 5, FC5
        put(237, t1385); // row 6, MSX6
        put(239, t1386); // row 6, XX6
        put(245, t1387); // row 6, MSX7
        put(248, t1388); // row 6, XX7
        put(253, t1389); // row 6, YZ7
        put(255, t1366); // row 6, FC6
        put(259, t1390); // row 7, YY7
        put(265, t1367); // row 7, FC7
    }
}
