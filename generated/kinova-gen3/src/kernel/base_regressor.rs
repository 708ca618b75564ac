//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4.
//!
//! 691 multiplications, 501 additions; 7 x 64, 211 of 448 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 211;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9),
    (0, 10), (0, 11), (0, 12), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18), (0, 19),
    (0, 20), (0, 21), (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28), (0, 29),
    (0, 30), (0, 31), (0, 32), (0, 33), (0, 34), (0, 35), (0, 36), (0, 37), (0, 38), (0, 39),
    (0, 40), (0, 41), (0, 42), (0, 43), (0, 50), (0, 57), (1, 1), (1, 2), (1, 3), (1, 4),
    (1, 5), (1, 6), (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (1, 12), (1, 13), (1, 14),
    (1, 15), (1, 16), (1, 17), (1, 18), (1, 19), (1, 20), (1, 21), (1, 22), (1, 23), (1, 24),
    (1, 25), (1, 26), (1, 27), (1, 28), (1, 29), (1, 30), (1, 31), (1, 32), (1, 33), (1, 34),
    (1, 35), (1, 36), (1, 37), (1, 38), (1, 39), (1, 40), (1, 41), (1, 42), (1, 44), (1, 51),
    (1, 58), (2, 8), (2, 9), (2, 10), (2, 11), (2, 12), (2, 13), (2, 14), (2, 15), (2, 16),
    (2, 17), (2, 18), (2, 19), (2, 20), (2, 21), (2, 22), (2, 23), (2, 24), (2, 25), (2, 26),
    (2, 27), (2, 28), (2, 29), (2, 30), (2, 31), (2, 32), (2, 33), (2, 34), (2, 35), (2, 36),
    (2, 37), (2, 38), (2, 39), (2, 40), (2, 41), (2, 42), (2, 45), (2, 52), (2, 59), (3, 15),
    (3, 16), (3, 17), (3, 18), (3, 19), (3, 20), (3, 21), (3, 22), (3, 23), (3, 24), (3, 25),
    (3, 26), (3, 27), (3, 28), (3, 29), (3, 30), (3, 31), (3, 32), (3, 33), (3, 34), (3, 35),
    (3, 36), (3, 37), (3, 38), (3, 39), (3, 40), (3, 41), (3, 42), (3, 46), (3, 53), (3, 60),
    (4, 22), (4, 23), (4, 24), (4, 25), (4, 26), (4, 27), (4, 28), (4, 29), (4, 30), (4, 31),
    (4, 32), (4, 33), (4, 34), (4, 35), (4, 36), (4, 37), (4, 38), (4, 39), (4, 40), (4, 41),
    (4, 42), (4, 47), (4, 54), (4, 61), (5, 29), (5, 30), (5, 31), (5, 32), (5, 33), (5, 34),
    (5, 35), (5, 36), (5, 37), (5, 38), (5, 39), (5, 40), (5, 41), (5, 42), (5, 48), (5, 55),
    (5, 62), (6, 36), (6, 37), (6, 38), (6, 39), (6, 40), (6, 41), (6, 42), (6, 49), (6, 56),
    (6, 63),
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
    let k0 = S::constant(9.81);
    let k1 = S::constant(0.01175);
    let k2 = S::constant(0.42076);
    let k3 = S::constant(0.01275);
    let k4 = S::constant(0.31436);
    let k5 = S::constant(0.00035);
    let k6 = S::constant(0.167455);
    let k7 = S::constant(1.0);
    // link 2: motion
    let [
        w2_x, w2_y, t2, t3, t5, t6, a2_z, t10,
        t12, t13, t14, dw2_x, dw2_y,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t2 = s2 * ddq1;
        let t3 = c2 * ddq1;
        let t5 = s2 * k0;
        let t6 = c2 * k0;
        let t7 = ddq1 * k1;
        let a2_z = dq1 * dq1 * k1;
        let t10 = t5 + c2 * t7;
        let t12 = t6 - s2 * t7;
        let t13 = dq2 * w2_y;
        let t14 = dq2 * w2_x;
        let dw2_x = t2 + t13;
        let dw2_y = t3 - t14;
        put(0, ddq1); // row 1, ZZ1R
        put(43, dq1); // row 1, FV1
        put(45, k7); // row 1, FO1
        put(49, ddq2); // row 2, ZZ2R
        put(51, t2); // row 2, XZ2
        put(52, t3); // row 2, YZ2
        put(88, dq2); // row 2, FV2
        put(90, k7); // row 2, FO2
        put(126, dq3); // row 3, FV3
        put(128, k7); // row 3, FO3
        put(157, dq4); // row 4, FV4
        put(159, k7); // row 4, FO4
        put(181, dq5); // row 5, FV5
        put(183, k7); // row 5, FO5
        put(198, dq6); // row 6, FV6
        put(200, k7); // row 6, FO6
        put(208, dq7); // row 7, FV7
        put(210, k7); // row 7, FO7
        [
        w2_x, w2_y, t2, t3, t5, t6, a2_z, t10,
        t12, t13, t14, dw2_x, dw2_y,
    ]
    };
    // link 3: motion
    let [
        w3_x, t22, t29, t30, t31, t32, t33, t34,
        t36, t37, t42, t46, a3_y, w3_z, t53, t54,
        dw3_z,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t22 = c3 * dq2 + s3 * w2_x;
        let t29 = w2_x * w2_x;
        let t30 = w2_y * w2_y;
        let t31 = dq2 * dq2;
        let t32 = w2_x * w2_y;
        let t33 = ddq2 - t32;
        let t34 = ddq2 + t32;
        let t36 = dw2_y - t14;
        let t37 = t13 + dw2_x;
        let t41 = t10 - t33 * k2;
        let t42 = t12 - (t29 + t31) * k2;
        let t43 = a2_z - t37 * k2;
        let t46 = c3 * t41 + s3 * t43;
        let a3_y = s3 * t41 - c3 * t43;
        let w3_z = w2_y + dq3;
        let t53 = s3 * ddq2 - c3 * dw2_x + dq3 * t22;
        let t54 = c3 * ddq2 + s3 * dw2_x + dq3 * w3_x;
        let dw3_z = dw2_y + ddq3;
        put(91, a3_y); // row 3, MSX3
        put(92, t46); // row 3, MSY3R
        put(94, dw3_z); // row 3, ZZ3R
        [
        w3_x, t22, t29, t30, t31, t32, t33, t34,
        t36, t37, t42, t46, a3_y, w3_z, t53, t54,
        dw3_z,
    ]
    };
    // link 4: motion
    let [
        w4_x, t61, t68, t69, t70, t71, t72, t73,
        t74, t75, t76, t77, t78, t79, t80, t81,
        t86, t90, a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let t61 = s4 * w3_x - c4 * w3_z;
        let t68 = w3_x * w3_x;
        let t69 = t22 * t22;
        let t70 = w3_z * w3_z;
        let t71 = w3_x * t22;
        let t72 = w3_x * w3_z;
        let t73 = t22 * w3_z;
        let t74 = t69 + t70;
        let t75 = dw3_z + t71;
        let t76 = t72 - t54;
        let t77 = t71 - dw3_z;
        let t78 = t68 + t70;
        let t79 = t73 - t53;
        let t80 = t54 + t72;
        let t81 = t53 + t73;
        let t85 = t46 + t75 * k3;
        let t86 = a3_y - t78 * k3;
        let t87 = t42 + t81 * k3;
        let t90 = c4 * t85 + s4 * t87;
        let a4_y = s4 * t85 - c4 * t87;
        let w4_z = t22 + dq4;
        let dw4_x = s4 * dw3_z - c4 * t53 - dq4 * t61;
        let dw4_y = c4 * dw3_z + s4 * t53 - dq4 * w4_x;
        let dw4_z = t54 + ddq4;
        put(93, t71); // row 3, XX3R
        put(96, t79); // row 3, XZ3
        put(97, t76); // row 3, YZ3
        put(129, a4_y); // row 4, MSX4
        put(130, t90); // row 4, MSY4R
        put(132, dw4_z); // row 4, ZZ4R
        [
        w4_x, t61, t68, t69, t70, t71, t72, t73,
        t74, t75, t76, t77, t78, t79, t80, t81,
        t86, t90, a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ]
    };
    // link 5: motion
    let [
        w5_x, t105, t112, t113, t114, t115, t116, t117,
        t118, t119, t120, t121, t122, t123, t124, t125,
        a5_z, t134, a5_y, w5_z, t141, t142, dw5_z,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t105 = c5 * w4_z + s5 * w4_x;
        let t112 = w4_x * w4_x;
        let t113 = t61 * t61;
        let t114 = w4_z * w4_z;
        let t115 = w4_x * t61;
        let t116 = w4_x * w4_z;
        let t117 = t61 * w4_z;
        let t118 = t113 + t114;
        let t119 = dw4_z + t115;
        let t120 = dw4_y + t116;
        let t121 = dw4_z - t115;
        let t122 = t112 + t114;
        let t123 = dw4_x + t117;
        let t124 = dw4_y - t116;
        let t125 = dw4_x - t117;
        let t129 = t90 - t119 * k4;
        let a5_z = a4_y + t122 * k4;
        let t131 = t86 + t125 * k4;
        let t134 = c5 * t129 - s5 * t131;
        let a5_y = c5 * t131 + s5 * t129;
        let w5_z = dq5 - t61;
        let t141 = s5 * dw4_z - c5 * dw4_x + dq5 * t105;
        let t142 = c5 * dw4_z + s5 * dw4_x + dq5 * w5_x;
        let dw5_z = dw4_y + ddq5;
        put(131, t115); // row 4, XX4R
        put(134, t123); // row 4, XZ4
        put(135, t120); // row 4, YZ4
        put(160, a5_y); // row 5, MSX5
        put(161, t134); // row 5, MSY5R
        put(163, dw5_z); // row 5, ZZ5R
        [
        w5_x, t105, t112, t113, t114, t115, t116, t117,
        t118, t119, t120, t121, t122, t123, t124, t125,
        a5_z, t134, a5_y, w5_z, t141, t142, dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, t149, t156, t157, t158, t159, t160, t161,
        t162, t163, t164, t165, t166, t167, t168, t169,
        t174, t178, a6_y, w6_z, dw6_x, t186, dw6_z,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let t149 = s6 * w5_x - c6 * w5_z;
        let t156 = w5_x * w5_x;
        let t157 = t105 * t105;
        let t158 = w5_z * w5_z;
        let t159 = w5_x * t105;
        let t160 = w5_x * w5_z;
        let t161 = t105 * w5_z;
        let t162 = t157 + t158;
        let t163 = dw5_z + t159;
        let t164 = t160 - t142;
        let t165 = dw5_z - t159;
        let t166 = t156 + t158;
        let t167 = t161 - t141;
        let t168 = t142 + t160;
        let t169 = t141 + t161;
        let t173 = t134 + t163 * k5;
        let t174 = t166 * k5 - a5_y;
        let t175 = t169 * k5 - a5_z;
        let t178 = c6 * t173 + s6 * t175;
        let a6_y = s6 * t173 - c6 * t175;
        let w6_z = t105 + dq6;
        let dw6_x = s6 * dw5_z - c6 * t141 - dq6 * t149;
        let t186 = dq6 * w6_x - (c6 * dw5_z + s6 * t141);
        let dw6_z = t142 + ddq6;
        put(162, t159); // row 5, XX5R
        put(165, t167); // row 5, XZ5
        put(166, t164); // row 5, YZ5
        put(184, a6_y); // row 6, MSX6
        put(185, t178); // row 6, MSY6R
        put(187, dw6_z); // row 6, ZZ6R
        [
        w6_x, t149, t156, t157, t158, t159, t160, t161,
        t162, t163, t164, t165, t166, t167, t168, t169,
        t174, t178, a6_y, w6_z, dw6_x, t186, dw6_z,
    ]
    };
    // link 7: motion
    let [
        w7_x, t193, t200, t201, t202, t203, t204, t205,
        t206, t207, t208, t209, t210, t211, t212, t213,
        a7_z, t222, a7_y, w7_z, t229, t230, dw7_z,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t193 = c7 * w6_z + s7 * w6_x;
        let t200 = w6_x * w6_x;
        let t201 = t149 * t149;
        let t202 = w6_z * w6_z;
        let t203 = w6_x * t149;
        let t204 = w6_x * w6_z;
        let t205 = t149 * w6_z;
        let t206 = t201 + t202;
        let t207 = dw6_z + t203;
        let t208 = t204 - t186;
        let t209 = dw6_z - t203;
        let t210 = t200 + t202;
        let t211 = dw6_x + t205;
        let t212 = t186 + t204;
        let t213 = dw6_x - t205;
        let t217 = t178 - t207 * k6;
        let a7_z = a6_y + t210 * k6;
        let t219 = t213 * k6 - t174;
        let t222 = c7 * t217 - s7 * t219;
        let a7_y = c7 * t219 + s7 * t217;
        let w7_z = dq7 - t149;
        let t229 = s7 * dw6_z - c7 * dw6_x + dq7 * t193;
        let t230 = c7 * dw6_z + s7 * dw6_x + dq7 * w7_x;
        let dw7_z = ddq7 - t186;
        put(186, t203); // row 6, XX6R
        put(189, t211); // row 6, XZ6
        put(190, t208); // row 6, YZ6
        put(201, a7_y); // row 7, MSX7
        put(202, t222); // row 7, MSY7
        put(204, dw7_z); // row 7, ZZ7
        [
        w7_x, t193, t200, t201, t202, t203, t204, t205,
        t206, t207, t208, t209, t210, t211, t212, t213,
        a7_z, t222, a7_y, w7_z, t229, t230, dw7_z,
    ]
    };
    // joint axes in frame 2
    let [t232, v1_2_y] = {
        let t232 = c2 * k1;
        let v1_2_y = s2 * k1;
        [t232, v1_2_y]
    };
    // joint axes in frame 3
    let [z1_3_x, z1_4_z, t239, v1_3_y, v2_3_x, v2_4_z] = {
        let t234 = s2 * k2;
        let z1_3_x = s2 * c3;
        let z1_4_z = s2 * s3;
        let t239 = c3 * t232 - s3 * t234;
        let v1_3_y = c3 * t234 + s3 * t232;
        let v2_3_x = c3 * k2;
        let v2_4_z = s3 * k2;
        [z1_3_x, z1_4_z, t239, v1_3_y, v2_3_x, v2_4_z]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, t251, z2_4_y, t253, t254, t257, t260] = {
        let z1_4_x = c4 * z1_3_x + c2 * s4;
        let z1_4_y = c2 * c4 - s4 * z1_3_x;
        let t251 = s3 * c4;
        let z2_4_y = s3 * s4;
        let t253 = c4 * v2_3_x;
        let t254 = s4 * v2_3_x;
        let t257 = s4 * v1_2_y - c4 * t239;
        let t260 = c4 * v1_2_y + s4 * t239;
        [z1_4_x, z1_4_y, t251, z2_4_y, t253, t254, t257, t260]
    };
    // joint axes in frame 5
    let [t263, z1_6_z, t269, t272, z3_5_x, z3_6_z] = {
        let t263 = s5 * z1_4_z - c5 * z1_4_x;
        let z1_6_z = c5 * z1_4_z + s5 * z1_4_x;
        let t269 = c5 * t251 + c3 * s5;
        let t272 = c3 * c5 - s5 * t251;
        let z3_5_x = s4 * c5;
        let z3_6_z = s4 * s5;
        [t263, z1_6_z, t269, t272, z3_5_x, z3_6_z]
    };
    // XZ2: column
    {
        let t278 = s2 * t34 + c2 * (t31 - t29);
        let t279 = k1 * t278;
        let t281 = t2 * k1 - t6;
        put(1, t279); // row 1, MSX2
        put(6, t278); // row 1, XZ2
        put(46, t281); // row 2, MSX2
    }
    // YZ2: column
    {
        let t285 = c2 * t33 - s2 * (t31 - t30);
        let t286 = k1 * t285;
        let t288 = t5 + t3 * k1;
        put(2, t286); // row 1, MSY2R
        put(7, t285); // row 1, YZ2
        put(47, t288); // row 2, MSY2R
    }
    // XX2: column
    let t290 = {
        let t290 = c2 * t14;
        let t291 = s2 * dw2_x + t290;
        put(3, t291); // row 1, XX2R
        t290
    };
    // ZZ2: column
    {
        let t293 = s2 * t13 - t290;
        put(4, t293); // row 1, ZZ2R
    }
    // XY2: column
    {
        let t294 = t29 - t30;
        let t297 = s2 * t36 + c2 * t37;
        put(5, t297); // row 1, XY2
        put(50, t294); // row 2, XY2
    }
    // MSX3: column
    {
        let t305 = t80 * v1_2_y - (t77 * v1_3_y - t74 * t239);
        let t306 = c2 * a3_y - t42 * z1_4_z + t305;
        let t311 = t77 * v2_4_z - t74 * v2_3_x - c3 * t42;
        put(8, t306); // row 1, MSX3
        put(53, t311); // row 2, MSX3
    }
    // MSY3: column
    {
        let t319 = t81 * v1_2_y + (t78 * v1_3_y - t75 * t239);
        let t320 = c2 * t46 - t42 * z1_3_x - t319;
        let t325 = s3 * t42 + (t78 * v2_4_z - t75 * v2_3_x);
        put(9, t320); // row 1, MSY3R
        put(54, t325); // row 2, MSY3R
    }
    // XX3: column
    let [t327, t332] = {
        let t327 = t72 * z1_4_z;
        let t330 = c2 * t71 - (t53 * z1_3_x + t327);
        let t332 = c3 * t72;
        let t333 = s3 * t53 - t332;
        put(10, t330); // row 1, XX3R
        put(55, t333); // row 2, XX3R
        [t327, t332]
    };
    // ZZ3: column
    {
        let t337 = c2 * dw3_z + (t327 - t73 * z1_3_x);
        let t339 = t332 + s3 * t73;
        put(11, t337); // row 1, ZZ3R
        put(56, t339); // row 2, ZZ3R
    }
    // XY3: column
    {
        let t340 = t68 - t69;
        let t345 = c2 * t340 + (t81 * z1_4_z - t80 * z1_3_x);
        let t348 = s3 * t80 + c3 * t81;
        put(12, t345); // row 1, XY3
        put(57, t348); // row 2, XY3
        put(95, t340); // row 3, XY3
    }
    // XZ3: column
    {
        let t349 = t70 - t68;
        let t354 = c2 * t79 - (t77 * z1_3_x + z1_4_z * t349);
        let t357 = s3 * t77 - c3 * t349;
        put(13, t354); // row 1, XZ3
        put(58, t357); // row 2, XZ3
    }
    // YZ3: column
    {
        let t358 = t70 - t69;
        let t363 = c2 * t76 - (z1_3_x * t358 + t75 * z1_4_z);
        let t366 = s3 * t358 - c3 * t75;
        put(14, t363); // row 1, YZ3
        put(59, t366); // row 2, YZ3
    }
    // MSX4: column
    let [t368, t373, t374] = {
        let t368 = s4 * t121;
        let t369 = c4 * t118 + t368;
        let t372 = s4 * t118 - c4 * t121;
        let t373 = s4 * t86;
        let t374 = c4 * t86;
        let t377 = t373 + k3 * t372;
        let t378 = t374 + k3 * t369;
        let t388 = t239 * t369 + t124 * v1_3_y - v1_2_y * t372;
        let t389 = c2 * t378 - (z1_3_x * t377 - a4_y * z1_4_z) + t388;
        let t396 = s3 * t377 + c3 * a4_y - (v2_3_x * t369 + t124 * v2_4_z);
        put(15, t389); // row 1, MSX4
        put(60, t396); // row 2, MSX4
        put(98, t378); // row 3, MSX4
        [t368, t373, t374]
    };
    // MSY4: column
    let t397 = {
        let t397 = c4 * t119;
        let t399 = t397 - s4 * t122;
        let t402 = s4 * t119 + c4 * t122;
        let t405 = t374 + k3 * t402;
        let t406 = k3 * t399 - t373;
        let t416 = v1_2_y * t402 + (t125 * v1_3_y - t239 * t399);
        let t417 = c2 * t406 + (t90 * z1_4_z - z1_3_x * t405) - t416;
        let t424 = s3 * t405 + c3 * t90 + (t125 * v2_4_z - v2_3_x * t399);
        put(16, t417); // row 1, MSY4R
        put(61, t424); // row 2, MSY4R
        put(99, t406); // row 3, MSY4R
        t397
    };
    // XX4: column
    let [t426, t431, t436] = {
        let t426 = t116 * z1_4_y;
        let t429 = t115 * z1_4_z + (dw4_x * z1_4_x + t426);
        let t431 = t116 * z2_4_y;
        let t434 = c3 * t115 - (dw4_x * t251 - t431);
        let t436 = c4 * t116;
        let t437 = s4 * dw4_x + t436;
        put(17, t429); // row 1, XX4R
        put(62, t434); // row 2, XX4R
        put(100, t437); // row 3, XX4R
        [t426, t431, t436]
    };
    // ZZ4: column
    let t447 = {
        let t441 = dw4_z * z1_4_z - (t426 + t117 * z1_4_x);
        let t445 = c3 * dw4_z - (t431 - t117 * t251);
        let t447 = t436 + s4 * t117;
        put(18, t441); // row 1, ZZ4R
        put(63, t445); // row 2, ZZ4R
        t447
    };
    // XY4: column
    {
        let t448 = t112 - t113;
        let t453 = z1_4_z * t448 + (t124 * z1_4_x + t125 * z1_4_y);
        let t458 = c3 * t448 + (t125 * z2_4_y - t124 * t251);
        let t461 = s4 * t124 + c4 * t125;
        put(19, t453); // row 1, XY4
        put(64, t458); // row 2, XY4
        put(102, t461); // row 3, XY4
        put(133, t448); // row 4, XY4
    }
    // XZ4: column
    {
        let t462 = t114 - t112;
        let t467 = t123 * z1_4_z + (t121 * z1_4_x + z1_4_y * t462);
        let t472 = c3 * t123 + (z2_4_y * t462 - t121 * t251);
        let t474 = t368 + c4 * t462;
        put(20, t467); // row 1, XZ4
        put(65, t472); // row 2, XZ4
        put(103, t474); // row 3, XZ4
    }
    // YZ4: column
    {
        let t475 = t114 - t113;
        let t480 = t120 * z1_4_z + (t119 * z1_4_y - z1_4_x * t475);
        let t485 = c3 * t120 + (t251 * t475 + t119 * z2_4_y);
        let t487 = t397 - s4 * t475;
        put(21, t480); // row 1, YZ4
        put(66, t485); // row 2, YZ4
        put(104, t487); // row 3, YZ4
    }
    // MSX5: column
    let [t489, t494, t495] = {
        let t489 = s5 * t165;
        let t490 = c5 * t162 + t489;
        let t493 = s5 * t162 - c5 * t165;
        let t494 = s5 * a5_z;
        let t495 = c5 * a5_z;
        let t499 = t495 - k4 * t490;
        let t502 = t494 - k4 * t493 + k3 * t168;
        let t503 = a5_y + k3 * t490;
        let t513 = v1_3_y * t493 - (t168 * t260 - t257 * t490);
        let t514 = z1_4_z * t499 + (z1_4_x * t502 + z1_4_y * t503) - t513;
        let t524 = v2_4_z * t493 - (t253 * t490 + t168 * t254);
        let t525 = c3 * t499 + (z2_4_y * t503 - t251 * t502) + t524;
        let t528 = s4 * t502 + c4 * t503;
        put(22, t514); // row 1, MSX5
        put(67, t525); // row 2, MSX5
        put(105, t528); // row 3, MSX5
        put(136, t499); // row 4, MSX5
        [t489, t494, t495]
    };
    // MSY5: column
    let t529 = {
        let t529 = c5 * t163;
        let t531 = s5 * t166 - t529;
        let t534 = s5 * t163 + c5 * t166;
        let t538 = k4 * t531 - t494;
        let t541 = t495 - k4 * t534 - k3 * t169;
        let t542 = t134 - k3 * t531;
        let t552 = v1_3_y * t534 + (t169 * t260 - t257 * t531);
        let t553 = z1_4_z * t538 + (z1_4_x * t541 + z1_4_y * t542) - t552;
        let t563 = v2_4_z * t534 + (t253 * t531 + t169 * t254);
        let t564 = c3 * t538 + (z2_4_y * t542 - t251 * t541) + t563;
        let t567 = s4 * t541 + c4 * t542;
        put(23, t553); // row 1, MSY5R
        put(68, t564); // row 2, MSY5R
        put(106, t567); // row 3, MSY5R
        put(137, t538); // row 4, MSY5R
        t529
    };
    // XX5: column
    let [t569, t574, t579, t584] = {
        let t569 = t160 * z1_6_z;
        let t572 = t159 * z1_4_y - (t569 - t141 * t263);
        let t574 = t160 * t272;
        let t577 = t159 * z2_4_y + (t141 * t269 - t574);
        let t579 = t160 * z3_6_z;
        let t582 = c4 * t159 - (t141 * z3_5_x + t579);
        let t584 = c5 * t160;
        let t585 = s5 * t141 - t584;
        put(24, t572); // row 1, XX5R
        put(69, t577); // row 2, XX5R
        put(107, t582); // row 3, XX5R
        put(138, t585); // row 4, XX5R
        [t569, t574, t579, t584]
    };
    // ZZ5: column
    {
        let t589 = dw5_z * z1_4_y + (t569 + t161 * t263);
        let t593 = dw5_z * z2_4_y + (t574 + t161 * t269);
        let t597 = c4 * dw5_z + (t579 - t161 * z3_5_x);
        let t599 = t584 + s5 * t161;
        put(25, t589); // row 1, ZZ5R
        put(70, t593); // row 2, ZZ5R
        put(108, t597); // row 3, ZZ5R
        put(139, t599); // row 4, ZZ5R
    }
    // XY5: column
    {
        let t600 = t156 - t157;
        let t605 = z1_4_y * t600 + (t168 * t263 + t169 * z1_6_z);
        let t610 = z2_4_y * t600 + (t168 * t269 + t169 * t272);
        let t615 = c4 * t600 - (t168 * z3_5_x - t169 * z3_6_z);
        let t618 = s5 * t168 + c5 * t169;
        put(26, t605); // row 1, XY5
        put(71, t610); // row 2, XY5
        put(109, t615); // row 3, XY5
        put(140, t618); // row 4, XY5
        put(164, t600); // row 5, XY5
    }
    // XZ5: column
    {
        let t619 = t156 - t158;
        let t624 = t167 * z1_4_y + (z1_6_z * t619 - t165 * t263);
        let t629 = t167 * z2_4_y + (t272 * t619 - t165 * t269);
        let t634 = c4 * t167 + (t165 * z3_5_x + z3_6_z * t619);
        let t636 = c5 * t619 - t489;
        put(27, t624); // row 1, XZ5
        put(72, t629); // row 2, XZ5
        put(110, t634); // row 3, XZ5
        put(141, t636); // row 4, XZ5
    }
    // YZ5: column
    {
        let t637 = t158 - t157;
        let t642 = t164 * z1_4_y + (t263 * t637 - t163 * z1_6_z);
        let t647 = t164 * z2_4_y - (t163 * t272 - t269 * t637);
        let t652 = c4 * t164 - (z3_5_x * t637 + t163 * z3_6_z);
        let t654 = s5 * t637 - t529;
        put(28, t642); // row 1, YZ5
        put(73, t647); // row 2, YZ5
        put(111, t652); // row 3, YZ5
        put(142, t654); // row 4, YZ5
    }
    // MSX6: column
    let [t656, t659, t661, t662] = {
        let t656 = s6 * t209;
        let t657 = c6 * t206 + t656;
        let t659 = c6 * t209;
        let t660 = s6 * t206 - t659;
        let t661 = s6 * t174;
        let t662 = c6 * t174;
        let t665 = k5 * t660 - t661;
        let t666 = k5 * t657 - t662;
        let t669 = s5 * t212 - c5 * t657;
        let t672 = s5 * t657 + c5 * t212;
        let t682 = s5 * t665 + c5 * a6_y + k4 * t669;
        let t685 = s5 * a6_y - c5 * t665 - k4 * t672 - k3 * t660;
        let t686 = t666 - k3 * t669;
        let t696 = t257 * t669 - t260 * t660 - v1_3_y * t672;
        let t697 = z1_4_z * t682 + (z1_4_x * t685 + z1_4_y * t686) + t696;
        let t707 = v2_4_z * t672 + (t253 * t669 + t254 * t660);
        let t708 = c3 * t682 - (t251 * t685 - z2_4_y * t686) + t707;
        let t711 = s4 * t685 + c4 * t686;
        put(29, t697); // row 1, MSX6
        put(74, t708); // row 2, MSX6
        put(112, t711); // row 3, MSX6
        put(143, t682); // row 4, MSX6
        put(167, t666); // row 5, MSX6
        [t656, t659, t661, t662]
    };
    // MSY6: column
    let [t712, t715] = {
        let t712 = c6 * t207;
        let t714 = t712 - s6 * t210;
        let t715 = s6 * t207;
        let t717 = t715 + c6 * t210;
        let t720 = k5 * t717 - t662;
        let t721 = t661 + k5 * t714;
        let t724 = s5 * t213 - c5 * t714;
        let t727 = s5 * t714 + c5 * t213;
        let t737 = s5 * t720 + c5 * t178 + k4 * t724;
        let t740 = k4 * t727 - (s5 * t178 - c5 * t720) + k3 * t717;
        let t741 = t721 - k3 * t724;
        let t751 = v1_3_y * t727 - (t257 * t724 - t260 * t717);
        let t752 = z1_4_z * t737 - (z1_4_x * t740 - z1_4_y * t741) - t751;
        let t762 = v2_4_z * t727 + (t253 * t724 + t254 * t717);
        let t763 = c3 * t737 + (t251 * t740 + z2_4_y * t741) + t762;
        let t766 = c4 * t741 - s4 * t740;
        put(30, t752); // row 1, MSY6R
        put(75, t763); // row 2, MSY6R
        put(113, t766); // row 3, MSY6R
        put(144, t737); // row 4, MSY6R
        put(168, t721); // row 5, MSY6R
        [t712, t715]
    };
    // XX6: column
    let [t768, t771] = {
        let t768 = s6 * t204;
        let t769 = t768 - c6 * dw6_x;
        let t771 = c6 * t204;
        let t772 = s6 * dw6_x + t771;
        let t777 = z1_4_y * t772 + (t263 * t769 + t203 * z1_6_z);
        let t782 = z2_4_y * t772 + (t269 * t769 + t203 * t272);
        let t787 = c4 * t772 + (t203 * z3_6_z - z3_5_x * t769);
        let t790 = s5 * t769 + c5 * t203;
        put(31, t777); // row 1, XX6R
        put(76, t782); // row 2, XX6R
        put(114, t787); // row 3, XX6R
        put(145, t790); // row 4, XX6R
        put(169, t772); // row 5, XX6R
        [t768, t771]
    };
    // ZZ6: column
    let t794 = {
        let t792 = c6 * t205 - t768;
        let t794 = t771 + s6 * t205;
        let t799 = t263 * t792 + dw6_z * z1_6_z - z1_4_y * t794;
        let t804 = t269 * t792 + dw6_z * t272 - z2_4_y * t794;
        let t809 = dw6_z * z3_6_z - z3_5_x * t792 - c4 * t794;
        let t812 = s5 * t792 + c5 * dw6_z;
        put(32, t799); // row 1, ZZ6R
        put(77, t804); // row 2, ZZ6R
        put(115, t809); // row 3, ZZ6R
        put(146, t812); // row 4, ZZ6R
        t794
    };
    // XY6: column
    {
        let t813 = t200 - t201;
        let t816 = c6 * t212 + s6 * t213;
        let t819 = c6 * t213 - s6 * t212;
        let t824 = z1_4_y * t819 + (t263 * t816 + z1_6_z * t813);
        let t829 = z2_4_y * t819 + (t269 * t816 + t272 * t813);
        let t834 = c4 * t819 + (z3_6_z * t813 - z3_5_x * t816);
        let t837 = s5 * t816 + c5 * t813;
        put(33, t824); // row 1, XY6
        put(78, t829); // row 2, XY6
        put(116, t834); // row 3, XY6
        put(147, t837); // row 4, XY6
        put(171, t819); // row 5, XY6
        put(188, t813); // row 6, XY6
    }
    // XZ6: column
    {
        let t838 = t202 - t200;
        let t840 = s6 * t838 - t659;
        let t842 = t656 + c6 * t838;
        let t847 = z1_4_y * t842 + (t263 * t840 + t211 * z1_6_z);
        let t852 = z2_4_y * t842 + (t269 * t840 + t211 * t272);
        let t857 = c4 * t842 + (t211 * z3_6_z - z3_5_x * t840);
        let t860 = s5 * t840 + c5 * t211;
        put(34, t847); // row 1, XZ6
        put(79, t852); // row 2, XZ6
        put(117, t857); // row 3, XZ6
        put(148, t860); // row 4, XZ6
        put(172, t842); // row 5, XZ6
    }
    // YZ6: column
    {
        let t861 = t201 - t202;
        let t863 = t715 - c6 * t861;
        let t865 = t712 + s6 * t861;
        let t870 = z1_4_y * t865 + (t263 * t863 + t208 * z1_6_z);
        let t875 = z2_4_y * t865 + (t269 * t863 + t208 * t272);
        let t880 = c4 * t865 + (t208 * z3_6_z - z3_5_x * t863);
        let t883 = s5 * t863 + c5 * t208;
        put(35, t870); // row 1, YZ6
        put(80, t875); // row 2, YZ6
        put(118, t880); // row 3, YZ6
        put(149, t883); // row 4, YZ6
        put(173, t865); // row 5, YZ6
    }
    // MSX7: column
    let [
        t884, t885, t886, t887, t888, t889, t891, t892,
        t894, t895, t896, t897, t899, t902, t904, t905,
    ] = {
        let t884 = w7_x * w7_x;
        let t885 = t193 * t193;
        let t886 = w7_z * w7_z;
        let t887 = w7_x * t193;
        let t888 = w7_x * w7_z;
        let t889 = t193 * w7_z;
        let t890 = t885 + t886;
        let t891 = dw7_z + t887;
        let t892 = t888 - t230;
        let t893 = t887 - dw7_z;
        let t894 = t884 + t886;
        let t895 = t889 - t229;
        let t896 = t230 + t888;
        let t897 = t229 + t889;
        let t899 = s7 * t893;
        let t900 = t899 - c7 * t890;
        let t902 = c7 * t893;
        let t903 = s7 * t890 + t902;
        let t904 = s7 * a7_z;
        let t905 = c7 * a7_z;
        let t908 = t904 - k6 * t903;
        let t909 = t905 + k6 * t900;
        let t912 = s6 * t896 - c6 * t900;
        let t915 = s6 * t900 + c6 * t896;
        let t924 = c6 * t908 - s6 * a7_y + k5 * t915;
        let t925 = s6 * t908 + c6 * a7_y + k5 * t912;
        let t928 = s5 * t903 - c5 * t912;
        let t931 = s5 * t912 + c5 * t903;
        let t941 = k4 * t928 - (s5 * t924 - c5 * t909);
        let t944 = c5 * t924 + s5 * t909 - k4 * t931 + k3 * t915;
        let t945 = k3 * t928 - t925;
        let t955 = t257 * t928 + t260 * t915 - v1_3_y * t931;
        let t956 = z1_4_z * t941 - (z1_4_y * t945 - z1_4_x * t944) + t955;
        let t961 = t251 * t944 + z2_4_y * t945 - c3 * t941;
        let t967 = v2_4_z * t931 + (t253 * t928 - t254 * t915) - t961;
        let t970 = s4 * t944 - c4 * t945;
        put(36, t956); // row 1, MSX7
        put(81, t967); // row 2, MSX7
        put(119, t970); // row 3, MSX7
        put(150, t941); // row 4, MSX7
        put(174, t925); // row 5, MSX7
        put(191, t909); // row 6, MSX7
        put(203, t887); // row 7, XX7R
        put(206, t895); // row 7, XZ7
        put(207, t892); // row 7, YZ7
        [
        t884, t885, t886, t887, t888, t889, t891, t892,
        t894, t895, t896, t897, t899, t902, t904, t905,
    ]
    };
    // MSY7: column
    let [t971, t974] = {
        let t971 = c7 * t891;
        let t973 = s7 * t894 - t971;
        let t974 = s7 * t891;
        let t976 = t974 + c7 * t894;
        let t979 = t905 - k6 * t976;
        let t980 = k6 * t973 - t904;
        let t983 = c6 * t973 + s6 * t897;
        let t986 = s6 * t973 - c6 * t897;
        let t995 = c6 * t979 - s6 * t222 + k5 * t986;
        let t996 = s6 * t979 + c6 * t222 - k5 * t983;
        let t999 = c5 * t983 + s5 * t976;
        let t1002 = s5 * t983 - c5 * t976;
        let t1012 = k4 * t999 - (s5 * t995 - c5 * t980);
        let t1015 = c5 * t995 + s5 * t980 + k4 * t1002 + k3 * t986;
        let t1016 = k3 * t999 - t996;
        let t1026 = v1_3_y * t1002 + (t257 * t999 + t260 * t986);
        let t1027 = z1_4_z * t1012 + (z1_4_x * t1015 - z1_4_y * t1016) + t1026;
        let t1037 = v2_4_z * t1002 - (t253 * t999 - t254 * t986);
        let t1038 = c3 * t1012 - (t251 * t1015 + z2_4_y * t1016) - t1037;
        let t1041 = s4 * t1015 - c4 * t1016;
        put(37, t1027); // row 1, MSY7
        put(82, t1038); // row 2, MSY7
        put(120, t1041); // row 3, MSY7
        put(151, t1012); // row 4, MSY7
        put(175, t996); // row 5, MSY7
        put(192, t980); // row 6, MSY7
        [t971, t974]
    };
    // XX7: column
    let [t1043, t1046] = {
        let t1043 = s7 * t888;
        let t1044 = c7 * t229 + t1043;
        let t1046 = c7 * t888;
        let t1047 = s7 * t229 - t1046;
        let t1050 = c6 * t1044 + s6 * t887;
        let t1053 = c6 * t887 - s6 * t1044;
        let t1058 = z1_4_y * t1053 + (t263 * t1050 + z1_6_z * t1047);
        let t1063 = z2_4_y * t1053 + (t269 * t1050 + t272 * t1047);
        let t1068 = c4 * t1053 + (z3_6_z * t1047 - z3_5_x * t1050);
        let t1071 = s5 * t1050 + c5 * t1047;
        put(38, t1058); // row 1, XX7R
        put(83, t1063); // row 2, XX7R
        put(121, t1068); // row 3, XX7R
        put(152, t1071); // row 4, XX7R
        put(176, t1053); // row 5, XX7R
        put(193, t1047); // row 6, XX7R
        [t1043, t1046]
    };
    // ZZ7: column
    {
        let t1073 = t1043 - c7 * t889;
        let t1075 = t1046 + s7 * t889;
        let t1078 = s6 * dw7_z - c6 * t1073;
        let t1081 = s6 * t1073 + c6 * dw7_z;
        let t1086 = z1_4_y * t1081 + (t263 * t1078 + z1_6_z * t1075);
        let t1091 = z2_4_y * t1081 + (t269 * t1078 + t272 * t1075);
        let t1096 = c4 * t1081 - (z3_5_x * t1078 - z3_6_z * t1075);
        let t1099 = s5 * t1078 + c5 * t1075;
        put(39, t1086); // row 1, ZZ7
        put(84, t1091); // row 2, ZZ7
        put(122, t1096); // row 3, ZZ7
        put(153, t1099); // row 4, ZZ7
        put(177, t1081); // row 5, ZZ7
        put(194, t1075); // row 6, ZZ7
    }
    // XY7: column
    {
        let t1100 = t884 - t885;
        let t1103 = c7 * t896 - s7 * t897;
        let t1106 = s7 * t896 + c7 * t897;
        let t1109 = c6 * t1103 + s6 * t1100;
        let t1112 = c6 * t1100 - s6 * t1103;
        let t1117 = z1_4_y * t1112 + (t263 * t1109 + z1_6_z * t1106);
        let t1122 = z2_4_y * t1112 + (t269 * t1109 + t272 * t1106);
        let t1127 = c4 * t1112 - (z3_5_x * t1109 - z3_6_z * t1106);
        let t1130 = s5 * t1109 + c5 * t1106;
        put(40, t1117); // row 1, XY7
        put(85, t1122); // row 2, XY7
        put(123, t1127); // row 3, XY7
        put(154, t1130); // row 4, XY7
        put(178, t1112); // row 5, XY7
        put(195, t1106); // row 6, XY7
        put(205, t1100); // row 7, XY7
    }
    // XZ7: column
    {
        let t1131 = t884 - t886;
        let t1133 = s7 * t1131 - t902;
        let t1135 = t899 + c7 * t1131;
        let t1138 = s6 * t895 - c6 * t1133;
        let t1141 = s6 * t1133 + c6 * t895;
        let t1146 = z1_4_y * t1141 + (t263 * t1138 + z1_6_z * t1135);
        let t1151 = z2_4_y * t1141 + (t269 * t1138 + t272 * t1135);
        let t1156 = c4 * t1141 - (z3_5_x * t1138 - z3_6_z * t1135);
        let t1159 = s5 * t1138 + c5 * t1135;
        put(41, t1146); // row 1, XZ7
        put(86, t1151); // row 2, XZ7
        put(124, t1156); // row 3, XZ7
        put(155, t1159); // row 4, XZ7
        put(179, t1141); // row 5, XZ7
        put(196, t1135); // row 6, XZ7
    }
    // YZ7: column
    {
        let t1160 = t886 - t885;
        let t1162 = t974 + c7 * t1160;
        let t1164 = s7 * t1160 - t971;
        let t1167 = c6 * t1162 + s6 * t892;
        let t1170 = c6 * t892 - s6 * t1162;
        let t1175 = z1_4_y * t1170 + (t263 * t1167 + z1_6_z * t1164);
        let t1180 = z2_4_y * t1170 + (t269 * t1167 + t272 * t1164);
        let t1185 = c4 * t1170 + (z3_6_z * t1164 - z3_5_x * t1167);
        let t1188 = s5 * t1167 + c5 * t1164;
        let t1189 = dq1.sign();
        let t1190 = dq2.sign();
        let t1191 = dq3.sign();
        let t1192 = dq4.sign();
        let t1193 = dq5.sign();
        let t1194 = dq6.sign();
        let t1195 = dq7.sign();
        let t1196 = -t32;
        let t1197 = -t447;
        let t1198 = -t794;
        put(42, t1175); // row 1, YZ7
        put(44, t1189); // row 1, FC1
        put(48, t1196); // row 2, XX2R
        put(87, t1180); // row 2, YZ7
        put(89, t1190); // row 2, FC2
        put(101, t1197); // row 3, ZZ4R
        put(125, t1185); // row 3, YZ7
        put(127, t1191); // row 3, FC3
        put(156, t1188); // row 4, YZ7
        put(158, t1192); // row 4, FC4
        put(170, t1198); // row 5, ZZ6R
        put(180, t1170); // row 5, YZ7
        put(182, t1193); // row 5, FC5
        put(197, t1164); // row 6, YZ7
        put(199, t1194); // row 6, FC6
        put(209, t1195); // row 7, FC7
    }
}
