//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4.
//!
//! 640 multiplications, 472 additions; 7 x 64, 209 of 448 structurally nonzero.

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
    // link 2: motion
    let [
        t0, t1, t2, t3, t4, t5, t6, t7,
        t8, t9,
    ] = {
        let t0 = s2 * dq1;
        let t1 = c2 * dq1;
        let t2 = s2 * ddq1;
        let t3 = c2 * ddq1;
        let t4 = s2 * k0;
        let t5 = c2 * k0;
        let t6 = dq2 * t1;
        let t7 = dq2 * t0;
        let t8 = t2 + t6;
        let t9 = t3 - t7;
        put(0, ddq1); // row 1, ZZ1R
        put(41, dq1); // row 1, FV1
        put(43, k5); // row 1, FO1
        put(45, t4); // row 2, MSY2R
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
        [
        t0, t1, t2, t3, t4, t5, t6, t7,
        t8, t9,
    ]
    };
    // link 3: motion
    let [
        t12, w3_y, t22, t23, t24, t25, t26, t27,
        t29, t30, t31, t32, t37, a3_x, t43, w3_z,
        dw3_x, dw3_y, dw3_z,
    ] = {
        let t12 = c3 * t0 - s3 * dq2;
        let w3_y = c3 * dq2 + s3 * t0;
        let t22 = t0 * t0;
        let t23 = t1 * t1;
        let t24 = dq2 * dq2;
        let t25 = t0 * t1;
        let t26 = ddq2 - t25;
        let t27 = ddq2 + t25;
        let t29 = t9 - t7;
        let t30 = t6 + t8;
        let t31 = c3 * t4;
        let t32 = s3 * t4;
        let t35 = L2 * t30;
        let t36 = L2 * t26 - t4;
        let t37 = t5 - L2 * (t22 + t24);
        let a3_x = c3 * t36 + s3 * t35;
        let t43 = s3 * t36 - c3 * t35;
        let w3_z = t1 + dq3;
        let dw3_x = s3 * ddq2 - c3 * t8 + dq3 * w3_y;
        let dw3_y = c3 * ddq2 + s3 * t8 + dq3 * t12;
        let dw3_z = t9 + ddq3;
        put(92, dw3_z); // row 3, ZZ3R
        [
        t12, w3_y, t22, t23, t24, t25, t26, t27,
        t29, t30, t31, t32, t37, a3_x, t43, w3_z,
        dw3_x, dw3_y, dw3_z,
    ]
    };
    // link 4: motion
    let [
        t52, w4_y, t62, t63, t64, t65, t66, t67,
        t69, t70, t71, t72, t73, t74, t79, t83,
        a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ] = {
        let t52 = c4 * t12 - s4 * w3_z;
        let w4_y = c4 * w3_z + s4 * t12;
        let t62 = t12 * t12;
        let t63 = w3_y * w3_y;
        let t64 = w3_z * w3_z;
        let t65 = t12 * w3_y;
        let t66 = t12 * w3_z;
        let t67 = w3_y * w3_z;
        let t69 = dw3_z + t65;
        let t70 = dw3_y - t66;
        let t71 = t65 - dw3_z;
        let t72 = dw3_x - t67;
        let t73 = dw3_y + t66;
        let t74 = dw3_x + t67;
        let t78 = A * (t63 + t64) - a3_x;
        let t79 = t43 + A * t71;
        let t80 = t37 - A * t73;
        let t83 = c4 * t78 - s4 * t80;
        let a4_y = c4 * t80 + s4 * t78;
        let w4_z = dq4 - w3_y;
        let dw4_x = c4 * dw3_x + s4 * dw3_z + dq4 * w4_y;
        let dw4_y = c4 * dw3_z - s4 * dw3_x + dq4 * t52;
        let dw4_z = ddq4 - dw3_y;
        put(91, t65); // row 3, XX3R
        put(94, t72); // row 3, XZ3
        put(95, t70); // row 3, YZ3
        put(127, a4_y); // row 4, MSX4R
        put(128, t83); // row 4, MSY4R
        put(130, dw4_z); // row 4, ZZ4R
        [
        t52, w4_y, t62, t63, t64, t65, t66, t67,
        t69, t70, t71, t72, t73, t74, t79, t83,
        a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ]
    };
    // link 5: motion
    let [
        t95, t98, t105, t106, t107, t108, t109, t110,
        t111, t112, t113, t114, t115, t116, t117, t118,
        t121, t129, t133, a5_y, w5_z, t140, t141, dw5_z,
    ] = {
        let t95 = c5 * t52 + s5 * w4_z;
        let t98 = c5 * w4_z - s5 * t52;
        let t105 = t52 * t52;
        let t106 = w4_y * w4_y;
        let t107 = w4_z * w4_z;
        let t108 = t52 * w4_y;
        let t109 = t52 * w4_z;
        let t110 = w4_y * w4_z;
        let t111 = t106 + t107;
        let t112 = dw4_z + t108;
        let t113 = dw4_y - t109;
        let t114 = dw4_z - t108;
        let t115 = t105 + t107;
        let t116 = dw4_x - t110;
        let t117 = dw4_y + t109;
        let t118 = dw4_x + t110;
        let t121 = A * t117;
        let t128 = t83 + (L3 * t112 - A * t111);
        let t129 = A * t114 + L3 * t115 - a4_y;
        let t130 = t79 + (t121 + L3 * t118);
        let t133 = c5 * t128 + s5 * t130;
        let a5_y = s5 * t128 - c5 * t130;
        let w5_z = w4_y + dq5;
        let t140 = dq5 * t98 - (c5 * dw4_x - s5 * dw4_z);
        let t141 = dq5 * t95 - (c5 * dw4_z + s5 * dw4_x);
        let dw5_z = dw4_y + ddq5;
        put(129, t108); // row 4, XX4R
        put(132, t116); // row 4, XZ4
        put(133, t113); // row 4, YZ4
        put(158, a5_y); // row 5, MSX5
        put(159, t133); // row 5, MSY5R
        put(161, dw5_z); // row 5, ZZ5R
        [
        t95, t98, t105, t106, t107, t108, t109, t110,
        t111, t112, t113, t114, t115, t116, t117, t118,
        t121, t129, t133, a5_y, w5_z, t140, t141, dw5_z,
    ]
    };
    // link 6: motion
    let [
        t145, w6_y, t155, t156, t157, t158, t159, t160,
        t161, t162, t163, t164, t165, t166, t167, t168,
        t171, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ] = {
        let t145 = c6 * t95 - s6 * w5_z;
        let w6_y = c6 * w5_z + s6 * t95;
        let t155 = t95 * t95;
        let t156 = t98 * t98;
        let t157 = w5_z * w5_z;
        let t158 = t95 * t98;
        let t159 = t95 * w5_z;
        let t160 = t98 * w5_z;
        let t161 = t156 + t157;
        let t162 = t158 - dw5_z;
        let t163 = t141 - t159;
        let t164 = dw5_z + t158;
        let t165 = t155 + t157;
        let t166 = t160 - t140;
        let t167 = t141 + t159;
        let t168 = t140 + t160;
        let t171 = c6 * t133 + s6 * t129;
        let a6_y = s6 * t133 - c6 * t129;
        let w6_z = t98 + dq6;
        let dw6_x = s6 * dw5_z - c6 * t140 + dq6 * w6_y;
        let dw6_y = c6 * dw5_z + s6 * t140 + dq6 * t145;
        let dw6_z = ddq6 - t141;
        put(163, t166); // row 5, XZ5
        put(164, t163); // row 5, YZ5
        put(182, a6_y); // row 6, MSX6R
        put(183, t171); // row 6, MSY6R
        put(185, dw6_z); // row 6, ZZ6R
        [
        t145, w6_y, t155, t156, t157, t158, t159, t160,
        t161, t162, t163, t164, t165, t166, t167, t168,
        t171, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ]
    };
    // link 7: motion
    let [
        t183, w7_y, t193, t194, t195, t196, t197, t198,
        t199, t200, t201, t202, t203, t204, t205, t206,
        t211, t215, a7_y, w7_z, dw7_x, dw7_y, dw7_z,
    ] = {
        let t183 = c7 * t145 - s7 * w6_z;
        let w7_y = c7 * w6_z + s7 * t145;
        let t193 = t145 * t145;
        let t194 = w6_y * w6_y;
        let t195 = w6_z * w6_z;
        let t196 = t145 * w6_y;
        let t197 = t145 * w6_z;
        let t198 = w6_y * w6_z;
        let t199 = t194 + t195;
        let t200 = dw6_z + t196;
        let t201 = dw6_y - t197;
        let t202 = t196 - dw6_z;
        let t203 = t193 + t195;
        let t204 = dw6_x - t198;
        let t205 = dw6_y + t197;
        let t206 = dw6_x + t198;
        let t210 = t171 + k4 * t199;
        let t211 = k4 * t202 - a6_y;
        let t212 = a5_y + k4 * t205;
        let t215 = c7 * t210 + s7 * t212;
        let a7_y = s7 * t210 - c7 * t212;
        let w7_z = dq7 - w6_y;
        let dw7_x = c7 * dw6_x + s7 * dw6_z + dq7 * w7_y;
        let dw7_y = c7 * dw6_z - s7 * dw6_x + dq7 * t183;
        let dw7_z = ddq7 - dw6_y;
        put(184, t196); // row 6, XX6R
        put(187, t204); // row 6, XZ6
        put(188, t201); // row 6, YZ6
        put(199, a7_y); // row 7, MSX7
        put(200, t215); // row 7, MSY7
        put(202, dw7_z); // row 7, ZZ7
        [
        t183, w7_y, t193, t194, t195, t196, t197, t198,
        t199, t200, t201, t202, t203, t204, t205, t206,
        t211, t215, a7_y, w7_z, dw7_x, dw7_y, dw7_z,
    ]
    };
    // joint axes in frame 3
    let [t225, z1_3_y] = {
        let t225 = s2 * c3;
        let z1_3_y = s2 * s3;
        [t225, z1_3_y]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, z2_4_x, t234] = {
        let z1_4_x = c2 * s4 - c4 * t225;
        let z1_4_y = c2 * c4 + s4 * t225;
        let z2_4_x = s3 * c4;
        let t234 = s3 * s4;
        [z1_4_x, z1_4_y, z2_4_x, t234]
    };
    // joint axes in frame 5
    let [z1_5_x, t240, z2_5_x, t246, t247, z3_5_x, z3_6_z] = {
        let z1_5_x = c5 * z1_4_x + s5 * z1_3_y;
        let t240 = s5 * z1_4_x - c5 * z1_3_y;
        let z2_5_x = c5 * z2_4_x + c3 * s5;
        let t246 = s5 * z2_4_x - c3 * c5;
        let t247 = c4 * A;
        let z3_5_x = s4 * c5;
        let z3_6_z = s4 * s5;
        [z1_5_x, t240, z2_5_x, t246, t247, z3_5_x, z3_6_z]
    };
    // XX2: column
    let t251 = {
        let t251 = c2 * t7;
        let t252 = s2 * t8 + t251;
        put(1, t252); // row 1, XX2R
        t251
    };
    // ZZ2: column
    {
        let t254 = s2 * t6 - t251;
        put(2, t254); // row 1, ZZ2R
    }
    // XY2: column
    {
        let t255 = t22 - t23;
        let t258 = s2 * t29 + c2 * t30;
        put(3, t258); // row 1, XY2
        put(48, t255); // row 2, XY2
    }
    // XZ2: column
    {
        let t262 = c2 * (t22 - t24) - s2 * t27;
        put(4, t262); // row 1, XZ2
    }
    // YZ2: column
    {
        let t266 = s2 * (t24 - t23) - c2 * t26;
        put(5, t266); // row 1, YZ2
    }
    // MSX3: column
    let [t269, t270, t271] = {
        let t269 = c2 * t32 - t5 * z1_3_y;
        let t270 = c3 * t5;
        let t271 = s3 * t71;
        [t269, t270, t271]
    };
    // XZ3: column
    let t283 = {
        let t272 = t64 - t62;
        let t277 = c2 * t72 + (t71 * t225 + z1_3_y * t272);
        let t279 = c3 * t272 - t271;
        let t281 = t269 - L2 * t277;
        let t283 = t270 + L2 * t279;
        let t285 = t32 - L2 * t72;
        put(6, t281); // row 1, MSX3R
        put(11, t277); // row 1, XZ3
        put(56, t279); // row 2, XZ3
        put(89, t285); // row 3, MSX3R
        t283
    };
    // MSY3: column
    let [t288, t289, t290] = {
        let t288 = c2 * t31 - t5 * t225;
        let t289 = s3 * t5;
        let t290 = c3 * t69;
        [t288, t289, t290]
    };
    // YZ3: column
    {
        let t291 = t64 - t63;
        let t296 = c2 * t70 + (t225 * t291 + t69 * z1_3_y);
        let t298 = t290 - s3 * t291;
        let t300 = t288 - L2 * t296;
        let t302 = t289 - L2 * t298;
        let t304 = t31 - L2 * t70;
        put(7, t300); // row 1, MSY3R
        put(12, t296); // row 1, YZ3
        put(52, t302); // row 2, MSY3R
        put(57, t298); // row 2, YZ3
        put(90, t304); // row 3, MSY3R
    }
    // XX3: column
    let [t306, t311] = {
        let t306 = t66 * z1_3_y;
        let t309 = c2 * t65 - (dw3_x * t225 + t306);
        let t311 = c3 * t66;
        let t312 = s3 * dw3_x - t311;
        put(8, t309); // row 1, XX3R
        put(53, t312); // row 2, XX3R
        [t306, t311]
    };
    // ZZ3: column
    {
        let t316 = c2 * dw3_z + (t306 - t67 * t225);
        let t318 = t311 + s3 * t67;
        put(9, t316); // row 1, ZZ3R
        put(54, t318); // row 2, ZZ3R
    }
    // XY3: column
    {
        let t319 = t62 - t63;
        let t324 = c2 * t319 - (t73 * t225 - t74 * z1_3_y);
        let t327 = s3 * t73 + c3 * t74;
        put(10, t324); // row 1, XY3R
        put(55, t327); // row 2, XY3R
        put(93, t319); // row 3, XY3R
    }
    // MSX4: column
    let [t329, t332] = {
        let t329 = t247 + L2 * s4;
        let t332 = s4 * A - L2 * c4;
        let t333 = t117 * t332;
        let t338 = t117 * t329 - t79;
        let t339 = t111 * t332 - t114 * t329 - a4_y;
        let t344 = z1_3_y * t339 + (z1_4_x * t333 + z1_4_y * t338);
        let t349 = c3 * t339 - (t234 * t338 - z2_4_x * t333);
        let t351 = t121 - c4 * t79;
        put(13, t344); // row 1, MSX4R
        put(58, t349); // row 2, MSX4R
        put(96, t351); // row 3, MSX4R
        [t329, t332]
    };
    // MSY4: column
    {
        let t353 = t118 * t329;
        let t357 = t118 * t332 - t79;
        let t358 = t115 * t329 + t112 * t332 - t83;
        let t363 = z1_3_y * t358 - (z1_4_x * t357 + z1_4_y * t353);
        let t368 = c3 * t358 + (t234 * t353 - z2_4_x * t357);
        let t371 = s4 * t79 - A * t118;
        put(14, t363); // row 1, MSY4R
        put(59, t368); // row 2, MSY4R
        put(97, t371); // row 3, MSY4R
    }
    // XX4: column
    let [t373, t378, t383] = {
        let t373 = t109 * z1_4_y;
        let t376 = dw4_x * z1_4_x - t373 - t108 * z1_3_y;
        let t378 = t109 * t234;
        let t381 = dw4_x * z2_4_x + t378 - c3 * t108;
        let t383 = c4 * t109;
        let t384 = s4 * dw4_x - t383;
        put(15, t376); // row 1, XX4R
        put(60, t381); // row 2, XX4R
        put(98, t384); // row 3, XX4R
        [t373, t378, t383]
    };
    // ZZ4: column
    {
        let t388 = t373 + t110 * z1_4_x - dw4_z * z1_3_y;
        let t392 = t110 * z2_4_x - t378 - c3 * dw4_z;
        let t394 = t383 + s4 * t110;
        put(16, t388); // row 1, ZZ4R
        put(61, t392); // row 2, ZZ4R
        put(99, t394); // row 3, ZZ4R
    }
    // XY4: column
    {
        let t395 = t105 - t106;
        let t400 = t117 * z1_4_x + t118 * z1_4_y - z1_3_y * t395;
        let t405 = t117 * z2_4_x - t118 * t234 - c3 * t395;
        let t408 = s4 * t117 + c4 * t118;
        put(17, t400); // row 1, XY4R
        put(62, t405); // row 2, XY4R
        put(100, t408); // row 3, XY4R
        put(131, t395); // row 4, XY4R
    }
    // XZ4: column
    {
        let t409 = t107 - t105;
        let t414 = t114 * z1_4_x + z1_4_y * t409 - t116 * z1_3_y;
        let t419 = t114 * z2_4_x - t234 * t409 - c3 * t116;
        let t422 = s4 * t114 + c4 * t409;
        put(18, t414); // row 1, XZ4
        put(63, t419); // row 2, XZ4
        put(101, t422); // row 3, XZ4
    }
    // YZ4: column
    {
        let t423 = t106 - t107;
        let t428 = z1_4_x * t423 + t112 * z1_4_y - t113 * z1_3_y;
        let t433 = z2_4_x * t423 - t112 * t234 - c3 * t113;
        let t436 = s4 * t423 + c4 * t112;
        put(19, t428); // row 1, YZ4
        put(64, t433); // row 2, YZ4
        put(102, t436); // row 3, YZ4
    }
    // MSX5: column
    let [t438, t443, t444] = {
        let t438 = s5 * t164;
        let t439 = c5 * t161 + t438;
        let t442 = c5 * t164 - s5 * t161;
        let t443 = s5 * t129;
        let t444 = c5 * t129;
        let t449 = A * t442;
        let t450 = t443 + L3 * t442;
        let t451 = L3 * t439 + A * t167 - t444;
        let t452 = a5_y - t449;
        let t458 = t332 * t442 - t450;
        let t459 = t452 + t329 * t442;
        let t460 = t167 * t329 + t332 * t439 - t451;
        let t465 = z1_3_y * t460 + (z1_4_x * t458 + z1_4_y * t459);
        let t470 = c3 * t460 + (z2_4_x * t458 - t234 * t459);
        let t474 = t449 - (s4 * t450 - c4 * t452);
        put(20, t465); // row 1, MSX5
        put(65, t470); // row 2, MSX5
        put(103, t474); // row 3, MSX5
        put(134, t451); // row 4, MSX5
        [t438, t443, t444]
    };
    // MSY5: column
    let t475 = {
        let t475 = c5 * t162;
        let t477 = t475 + s5 * t165;
        let t480 = s5 * t162 - c5 * t165;
        let t485 = A * t480;
        let t486 = t444 + L3 * t480;
        let t487 = t443 + (A * t168 - L3 * t477);
        let t488 = t133 - t485;
        let t494 = t486 - t332 * t480;
        let t495 = t488 + t329 * t480;
        let t496 = t168 * t329 - t332 * t477 - t487;
        let t501 = z1_3_y * t496 + (z1_4_y * t495 - z1_4_x * t494);
        let t506 = c3 * t496 - (z2_4_x * t494 + t234 * t495);
        let t510 = t485 - (s4 * t486 - c4 * t488);
        put(21, t501); // row 1, MSY5R
        put(66, t506); // row 2, MSY5R
        put(104, t510); // row 3, MSY5R
        put(135, t487); // row 4, MSY5R
        t475
    };
    // XX5: column
    let [t512, t517, t522, t527] = {
        let t512 = t159 * t240;
        let t515 = t512 - t140 * z1_5_x - t158 * z1_4_y;
        let t517 = t159 * t246;
        let t520 = t158 * t234 - (t140 * z2_5_x - t517);
        let t522 = t159 * z3_6_z;
        let t525 = t522 - t140 * z3_5_x - c4 * t158;
        let t527 = c5 * t159;
        let t528 = s5 * t140 + t527;
        put(22, t515); // row 1, XX5R
        put(67, t520); // row 2, XX5R
        put(105, t525); // row 3, XX5R
        put(136, t528); // row 4, XX5R
        [t512, t517, t522, t527]
    };
    // ZZ5: column
    let t536 = {
        let t532 = dw5_z * z1_4_y - (t512 + t160 * z1_5_x);
        let t536 = dw5_z * t234 + (t517 + t160 * z2_5_x);
        let t540 = c4 * dw5_z - (t522 + t160 * z3_5_x);
        let t542 = s5 * t160 - t527;
        put(23, t532); // row 1, ZZ5R
        put(106, t540); // row 3, ZZ5R
        put(137, t542); // row 4, ZZ5R
        t536
    };
    // XY5: column
    {
        let t543 = t155 - t156;
        let t548 = z1_4_y * t543 + (t167 * z1_5_x + t168 * t240);
        let t553 = t167 * z2_5_x + t168 * t246 - t234 * t543;
        let t558 = c4 * t543 + (t167 * z3_5_x + t168 * z3_6_z);
        let t561 = c5 * t168 - s5 * t167;
        put(24, t548); // row 1, XY5
        put(69, t553); // row 2, XY5
        put(107, t558); // row 3, XY5
        put(138, t561); // row 4, XY5
        put(162, t543); // row 5, XY5
    }
    // XZ5: column
    {
        let t562 = t155 - t157;
        let t567 = t166 * z1_4_y + (t164 * z1_5_x + t240 * t562);
        let t572 = t164 * z2_5_x + t246 * t562 - t166 * t234;
        let t577 = c4 * t166 + (t164 * z3_5_x + z3_6_z * t562);
        let t579 = c5 * t562 - t438;
        put(25, t567); // row 1, XZ5
        put(70, t572); // row 2, XZ5
        put(108, t577); // row 3, XZ5
        put(139, t579); // row 4, XZ5
    }
    // YZ5: column
    {
        let t580 = t157 - t156;
        let t585 = t163 * z1_4_y + (t162 * t240 - z1_5_x * t580);
        let t590 = t162 * t246 - z2_5_x * t580 - t163 * t234;
        let t595 = c4 * t163 + (t162 * z3_6_z - z3_5_x * t580);
        let t597 = t475 + s5 * t580;
        put(26, t585); // row 1, YZ5
        put(71, t590); // row 2, YZ5
        put(109, t595); // row 3, YZ5
        put(140, t597); // row 4, YZ5
    }
    // MSX6: column
    let [t599, t602, t604, t605] = {
        let t599 = s6 * t202;
        let t600 = c6 * t199 - t599;
        let t602 = c6 * t202;
        let t603 = s6 * t199 + t602;
        let t604 = s6 * a5_y;
        let t605 = c6 * a5_y;
        let t608 = c5 * t600 + s5 * t205;
        let t611 = c5 * t205 - s5 * t600;
        let t622 = A * t611;
        let t623 = c5 * t604 - s5 * a6_y + L3 * t611;
        let t624 = s5 * t604 + c5 * a6_y + (L3 * t608 + A * t603);
        let t625 = t622 - t605;
        let t631 = t332 * t611 - t623;
        let t632 = t329 * t611 - t625;
        let t633 = t329 * t603 + t332 * t608 - t624;
        let t638 = z1_3_y * t633 + (z1_4_x * t631 + z1_4_y * t632);
        let t643 = c3 * t633 - (t234 * t632 - z2_4_x * t631);
        let t647 = t622 - (s4 * t623 + c4 * t625);
        put(27, t638); // row 1, MSX6R
        put(72, t643); // row 2, MSX6R
        put(110, t647); // row 3, MSX6R
        put(141, t624); // row 4, MSX6R
        put(165, t605); // row 5, MSX6R
        [t599, t602, t604, t605]
    };
    // MSY6: column
    let [t648, t651] = {
        let t648 = c6 * t200;
        let t650 = t648 - s6 * t203;
        let t651 = s6 * t200;
        let t653 = t651 + c6 * t203;
        let t656 = c5 * t650 - s5 * t206;
        let t659 = s5 * t650 + c5 * t206;
        let t670 = A * t659;
        let t671 = L3 * t659 - (c5 * t605 - s5 * t171);
        let t672 = s5 * t605 + c5 * t171 + (L3 * t656 + A * t653);
        let t673 = t670 - t604;
        let t679 = t671 - t332 * t659;
        let t680 = t329 * t659 - t673;
        let t681 = t329 * t653 + t332 * t656 - t672;
        let t686 = z1_3_y * t681 + (z1_4_x * t679 - z1_4_y * t680);
        let t691 = c3 * t681 + (z2_4_x * t679 + t234 * t680);
        let t695 = s4 * t671 + c4 * t673 - t670;
        put(28, t686); // row 1, MSY6R
        put(73, t691); // row 2, MSY6R
        put(111, t695); // row 3, MSY6R
        put(142, t672); // row 4, MSY6R
        [t648, t651]
    };
    // XX6: column
    let [t697, t700] = {
        let t697 = s6 * t197;
        let t698 = c6 * dw6_x + t697;
        let t700 = c6 * t197;
        let t701 = s6 * dw6_x - t700;
        let t706 = z1_4_y * t701 + (z1_5_x * t698 + t196 * t240);
        let t711 = z2_5_x * t698 + t196 * t246 - t234 * t701;
        let t716 = c4 * t701 + (z3_5_x * t698 + t196 * z3_6_z);
        let t719 = c5 * t196 - s5 * t698;
        put(29, t706); // row 1, XX6R
        put(74, t711); // row 2, XX6R
        put(112, t716); // row 3, XX6R
        put(143, t719); // row 4, XX6R
        put(167, t701); // row 5, XX6R
        [t697, t700]
    };
    // ZZ6: column
    {
        let t721 = c6 * t198 - t697;
        let t723 = t700 + s6 * t198;
        let t728 = z1_4_y * t723 + (z1_5_x * t721 + dw6_z * t240);
        let t733 = z2_5_x * t721 + dw6_z * t246 - t234 * t723;
        let t738 = c4 * t723 + (z3_5_x * t721 + dw6_z * z3_6_z);
        let t741 = c5 * dw6_z - s5 * t721;
        put(30, t728); // row 1, ZZ6R
        put(75, t733); // row 2, ZZ6R
        put(113, t738); // row 3, ZZ6R
        put(144, t741); // row 4, ZZ6R
        put(168, t723); // row 5, ZZ6R
    }
    // XY6: column
    {
        let t742 = t193 - t194;
        let t745 = c6 * t205 - s6 * t206;
        let t748 = s6 * t205 + c6 * t206;
        let t753 = z1_4_y * t748 + (z1_5_x * t745 + t240 * t742);
        let t758 = z2_5_x * t745 + t246 * t742 - t234 * t748;
        let t763 = c4 * t748 + (z3_5_x * t745 + z3_6_z * t742);
        let t766 = c5 * t742 - s5 * t745;
        put(31, t753); // row 1, XY6R
        put(76, t758); // row 2, XY6R
        put(114, t763); // row 3, XY6R
        put(145, t766); // row 4, XY6R
        put(169, t748); // row 5, XY6R
        put(186, t742); // row 6, XY6R
    }
    // XZ6: column
    {
        let t767 = t195 - t193;
        let t769 = t602 + s6 * t767;
        let t771 = c6 * t767 - t599;
        let t776 = z1_4_y * t771 + (t204 * t240 - z1_5_x * t769);
        let t781 = t204 * t246 - z2_5_x * t769 - t234 * t771;
        let t786 = c4 * t771 - (z3_5_x * t769 - t204 * z3_6_z);
        let t789 = s5 * t769 + c5 * t204;
        put(32, t776); // row 1, XZ6
        put(77, t781); // row 2, XZ6
        put(115, t786); // row 3, XZ6
        put(146, t789); // row 4, XZ6
        put(170, t771); // row 5, XZ6
    }
    // YZ6: column
    {
        let t790 = t195 - t194;
        let t792 = t651 + c6 * t790;
        let t794 = t648 - s6 * t790;
        let t799 = z1_4_y * t794 + (t201 * t240 - z1_5_x * t792);
        let t804 = t201 * t246 - z2_5_x * t792 - t234 * t794;
        let t809 = c4 * t794 + (t201 * z3_6_z - z3_5_x * t792);
        let t812 = s5 * t792 + c5 * t201;
        put(33, t799); // row 1, YZ6
        put(78, t804); // row 2, YZ6
        put(116, t809); // row 3, YZ6
        put(147, t812); // row 4, YZ6
        put(171, t794); // row 5, YZ6
    }
    // MSX7: column
    let [
        t813, t814, t815, t816, t817, t818, t820, t821,
        t823, t824, t825, t826, t828, t831, t833, t834,
    ] = {
        let t813 = t183 * t183;
        let t814 = w7_y * w7_y;
        let t815 = w7_z * w7_z;
        let t816 = t183 * w7_y;
        let t817 = t183 * w7_z;
        let t818 = w7_y * w7_z;
        let t819 = t814 + t815;
        let t820 = dw7_z + t816;
        let t821 = dw7_y - t817;
        let t822 = dw7_z - t816;
        let t823 = t813 + t815;
        let t824 = dw7_x - t818;
        let t825 = dw7_y + t817;
        let t826 = dw7_x + t818;
        let t828 = s7 * t822;
        let t829 = c7 * t819 + t828;
        let t831 = c7 * t822;
        let t832 = t831 - s7 * t819;
        let t833 = s7 * t211;
        let t834 = c7 * t211;
        let t837 = k4 * t825 - t834;
        let t838 = a7_y + k4 * t832;
        let t841 = c6 * t829 + s6 * t825;
        let t844 = s6 * t829 - c6 * t825;
        let t847 = c6 * t833 + s6 * t838;
        let t850 = s6 * t833 - c6 * t838;
        let t853 = s5 * t832 - c5 * t841;
        let t856 = s5 * t841 + c5 * t832;
        let t867 = A * t856;
        let t868 = c5 * t847 + s5 * t837 + L3 * t856;
        let t869 = c5 * t837 - s5 * t847 + (A * t844 - L3 * t853);
        let t870 = t850 + t867;
        let t876 = t332 * t856 - t868;
        let t877 = t329 * t856 - t870;
        let t878 = t329 * t844 - t332 * t853 - t869;
        let t883 = z1_3_y * t878 - (z1_4_x * t876 + z1_4_y * t877);
        let t888 = c3 * t878 + (t234 * t877 - z2_4_x * t876);
        let t892 = s4 * t868 + c4 * t870 - t867;
        put(34, t883); // row 1, MSX7
        put(79, t888); // row 2, MSX7
        put(117, t892); // row 3, MSX7
        put(148, t869); // row 4, MSX7
        put(172, t850); // row 5, MSX7
        put(189, t837); // row 6, MSX7
        put(201, t816); // row 7, XX7R
        put(204, t824); // row 7, XZ7
        put(205, t821); // row 7, YZ7
        [
        t813, t814, t815, t816, t817, t818, t820, t821,
        t823, t824, t825, t826, t828, t831, t833, t834,
    ]
    };
    // MSY7: column
    let [t893, t896] = {
        let t893 = c7 * t820;
        let t895 = s7 * t823 - t893;
        let t896 = s7 * t820;
        let t898 = t896 + c7 * t823;
        let t901 = t833 - k4 * t826;
        let t902 = k4 * t898 - t215;
        let t905 = c6 * t895 + s6 * t826;
        let t908 = c6 * t826 - s6 * t895;
        let t911 = s6 * t902 - c6 * t834;
        let t914 = s6 * t834 + c6 * t902;
        let t917 = c5 * t905 - s5 * t898;
        let t920 = s5 * t905 + c5 * t898;
        let t931 = A * t920;
        let t932 = s5 * t901 - c5 * t911 - L3 * t920;
        let t933 = s5 * t911 + c5 * t901 + (A * t908 - L3 * t917);
        let t934 = t931 - t914;
        let t940 = t932 + t332 * t920;
        let t941 = t934 - t329 * t920;
        let t942 = t933 + (t332 * t917 - t329 * t908);
        let t947 = z1_4_x * t940 - z1_4_y * t941 - z1_3_y * t942;
        let t952 = z2_4_x * t940 + t234 * t941 - c3 * t942;
        let t956 = t931 + (s4 * t932 - c4 * t934);
        put(35, t947); // row 1, MSY7
        put(80, t952); // row 2, MSY7
        put(118, t956); // row 3, MSY7
        put(149, t933); // row 4, MSY7
        put(173, t914); // row 5, MSY7
        put(190, t901); // row 6, MSY7
        [t893, t896]
    };
    // XX7: column
    let [t958, t961] = {
        let t958 = s7 * t817;
        let t959 = c7 * dw7_x + t958;
        let t961 = c7 * t817;
        let t962 = s7 * dw7_x - t961;
        let t965 = c6 * t959 + s6 * t816;
        let t968 = s6 * t959 - c6 * t816;
        let t973 = z1_4_y * t968 + (z1_5_x * t965 + t240 * t962);
        let t978 = z2_5_x * t965 + t246 * t962 - t234 * t968;
        let t983 = c4 * t968 + (z3_5_x * t965 + z3_6_z * t962);
        let t986 = c5 * t962 - s5 * t965;
        put(36, t973); // row 1, XX7R
        put(81, t978); // row 2, XX7R
        put(119, t983); // row 3, XX7R
        put(150, t986); // row 4, XX7R
        put(174, t968); // row 5, XX7R
        put(191, t962); // row 6, XX7R
        [t958, t961]
    };
    // ZZ7: column
    {
        let t988 = c7 * t818 - t958;
        let t990 = t961 + s7 * t818;
        let t993 = c6 * t988 + s6 * dw7_z;
        let t996 = s6 * t988 - c6 * dw7_z;
        let t1001 = z1_4_y * t996 + (z1_5_x * t993 + t240 * t990);
        let t1006 = z2_5_x * t993 + t246 * t990 - t234 * t996;
        let t1011 = c4 * t996 + (z3_5_x * t993 + z3_6_z * t990);
        let t1014 = c5 * t990 - s5 * t993;
        put(37, t1001); // row 1, ZZ7
        put(82, t1006); // row 2, ZZ7
        put(120, t1011); // row 3, ZZ7
        put(151, t1014); // row 4, ZZ7
        put(175, t996); // row 5, ZZ7
        put(192, t990); // row 6, ZZ7
    }
    // XY7: column
    {
        let t1015 = t813 - t814;
        let t1018 = c7 * t825 - s7 * t826;
        let t1021 = s7 * t825 + c7 * t826;
        let t1024 = c6 * t1018 + s6 * t1015;
        let t1027 = s6 * t1018 - c6 * t1015;
        let t1032 = z1_4_y * t1027 + (z1_5_x * t1024 + t240 * t1021);
        let t1037 = z2_5_x * t1024 + t246 * t1021 - t234 * t1027;
        let t1042 = c4 * t1027 + (z3_5_x * t1024 + z3_6_z * t1021);
        let t1045 = c5 * t1021 - s5 * t1024;
        put(38, t1032); // row 1, XY7
        put(83, t1037); // row 2, XY7
        put(121, t1042); // row 3, XY7
        put(152, t1045); // row 4, XY7
        put(176, t1027); // row 5, XY7
        put(193, t1021); // row 6, XY7
        put(203, t1015); // row 7, XY7
    }
    // XZ7: column
    {
        let t1046 = t813 - t815;
        let t1048 = t831 + s7 * t1046;
        let t1050 = t828 - c7 * t1046;
        let t1053 = c6 * t1048 + s6 * t824;
        let t1056 = s6 * t1048 - c6 * t824;
        let t1061 = z1_4_y * t1056 + (z1_5_x * t1053 + t240 * t1050);
        let t1066 = z2_5_x * t1053 + t246 * t1050 - t234 * t1056;
        let t1071 = c4 * t1056 + (z3_5_x * t1053 + z3_6_z * t1050);
        let t1074 = c5 * t1050 - s5 * t1053;
        put(39, t1061); // row 1, XZ7
        put(84, t1066); // row 2, XZ7
        put(122, t1071); // row 3, XZ7
        put(153, t1074); // row 4, XZ7
        put(177, t1056); // row 5, XZ7
        put(194, t1050); // row 6, XZ7
    }
    // YZ7: column
    {
        let t1075 = t814 - t815;
        let t1077 = c7 * t1075 - t896;
        let t1079 = t893 + s7 * t1075;
        let t1082 = c6 * t1077 + s6 * t821;
        let t1085 = s6 * t1077 - c6 * t821;
        let t1090 = z1_4_y * t1085 + (z1_5_x * t1082 + t240 * t1079);
        let t1095 = z2_5_x * t1082 + t246 * t1079 - t234 * t1085;
        let t1100 = c4 * t1085 + (z3_5_x * t1082 + z3_6_z * t1079);
        let t1103 = c5 * t1079 - s5 * t1082;
        let t1104 = dq1.sign();
        let t1105 = dq2.sign();
        let t1106 = dq3.sign();
        let t1107 = dq4.sign();
        let t1108 = dq5.sign();
        let t1109 = dq6.sign();
        let t1110 = dq7.sign();
        let t1111 = -t5;
        let t1112 = -t25;
        let t1113 = -t2;
        let t1114 = -t3;
        let t1115 = -t283;
        let t1116 = -t536;
        let t1117 = -t158;
        let t1118 = -t604;
        put(40, t1090); // row 1, YZ7
        put(42, t1104); // row 1, FC1
        put(44, t1111); // row 2, MSX2
        put(46, t1112); // row 2, XX2R
        put(49, t1113); // row 2, XZ2
        put(50, t1114); // row 2, YZ2
        put(51, t1115); // row 2, MSX3R
        put(68, t1116); // row 2, ZZ5R
        put(85, t1095); // row 2, YZ7
        put(87, t1105); // row 2, FC2
        put(123, t1100); // row 3, YZ7
        put(125, t1106); // row 3, FC3
        put(154, t1103); // row 4, YZ7
        put(156, t1107); // row 4, FC4
        put(160, t1117); // row 5, XX5R
        put(166, t1118); // row 5, MSY6R
        put(178, t1085); // row 5, YZ7
        put(180, t1108); // row 5, FC5
        put(195, t1079); // row 6, YZ7
        put(197, t1109); // row 6, FC6
        put(207, t1110); // row 7, FC7
    }
}
