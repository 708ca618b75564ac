//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4.
//!
//! 328 multiplications, 258 additions; 6 x 58, 161 of 348 structurally nonzero.

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
        put(0, ddq1); // row 1, ZZ1R
        put(34, dq1); // row 1, FV1
        put(36, k7); // row 1, FO1
        put(37, a2_y); // row 2, MSX2R
        put(40, ddq2); // row 2, ZZ2R
        put(42, t2); // row 2, XZ2R
        put(43, t3); // row 2, YZ2
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
        [w2_x, w2_y, a2_x, a2_y, t6, t7, dw2_x, dw2_y]
    };
    // link 3: motion
    let [
        w3_x, t15, t22, t23, t24, t25, t27, t28,
        t29, t30, t33, t38, t41, w3_z, dw3_x, dw3_y,
        dw3_z,
    ] = {
        let w3_x = c3 * w2_x + s3 * w2_y;
        let t15 = s3 * w2_x - c3 * w2_y;
        let t22 = w2_x * w2_x;
        let t23 = w2_y * w2_y;
        let t24 = dq2 * dq2;
        let t25 = w2_x * w2_y;
        let t27 = t25 - ddq2;
        let t28 = ddq2 + t25;
        let t29 = dw2_y - t7;
        let t30 = t6 + dw2_x;
        let t33 = t29 * k1;
        let t34 = a2_x + (t23 + t24) * k1;
        let t35 = t28 * k1 - a2_y;
        let t38 = s3 * t35 - c3 * t34;
        let t41 = c3 * t35 + s3 * t34;
        let w3_z = dq2 + dq3;
        let dw3_x = c3 * dw2_x + s3 * dw2_y - dq3 * t15;
        let dw3_y = c3 * dw2_y - s3 * dw2_x - dq3 * w3_x;
        let dw3_z = ddq2 + ddq3;
        put(47, dw3_z); // row 2, ZZ3R
        put(76, t38); // row 3, MSY3
        put(78, dw3_z); // row 3, ZZ3R
        [
        w3_x, t15, t22, t23, t24, t25, t27, t28,
        t29, t30, t33, t38, t41, w3_z, dw3_x, dw3_y,
        dw3_z,
    ]
    };
    // link 4: motion
    let [
        w4_x, t53, t60, t61, t62, t64, t65, t66,
        t67, t69, t70, t72, t73, t86, t89, a4_y,
        w4_z, t96, t97, dw4_z,
    ] = {
        let w4_x = c4 * w3_x - s4 * t15;
        let t53 = c4 * t15 + s4 * w3_x;
        let t60 = w3_x * w3_x;
        let t61 = t15 * t15;
        let t62 = w3_z * w3_z;
        let t63 = w3_x * t15;
        let t64 = w3_x * w3_z;
        let t65 = t15 * w3_z;
        let t66 = t61 + t62;
        let t67 = dw3_z + t63;
        let t68 = dw3_y + t64;
        let t69 = dw3_z - t63;
        let t70 = t60 + t62;
        let t71 = dw3_x + t65;
        let t72 = t64 - dw3_y;
        let t73 = t65 - dw3_x;
        let t84 = t38 - (t66 * k2 + D4 * t68);
        let t85 = t41 + (t69 * k2 + D4 * t71);
        let t86 = t72 * k2 + D4 * (t60 + t61) - t33;
        let t89 = c4 * t84 + s4 * t85;
        let a4_y = s4 * t84 - c4 * t85;
        let w4_z = w3_z + dq4;
        let t96 = dq4 * t53 - (c4 * dw3_x + s4 * dw3_y);
        let t97 = dq4 * w4_x - (c4 * dw3_y - s4 * dw3_x);
        let dw4_z = dw3_z + ddq4;
        put(46, t63); // row 2, XX3R
        put(49, t71); // row 2, XZ3R
        put(50, t68); // row 2, YZ3
        put(54, dw4_z); // row 2, ZZ4R
        put(77, t63); // row 3, XX3R
        put(80, t71); // row 3, XZ3R
        put(81, t68); // row 3, YZ3
        put(85, dw4_z); // row 3, ZZ4R
        put(107, a4_y); // row 4, MSX4
        put(108, t89); // row 4, MSY4R
        put(110, dw4_z); // row 4, ZZ4R
        [
        w4_x, t53, t60, t61, t62, t64, t65, t66,
        t67, t69, t70, t72, t73, t86, t89, a4_y,
        w4_z, t96, t97, dw4_z,
    ]
    };
    // link 5: motion
    let [
        w5_x, t104, t111, t112, t113, t115, t116, t117,
        t118, t120, t121, t122, t123, t128, t132, a5_y,
        w5_z, dw5_x, dw5_y, dw5_z,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let t104 = s5 * w4_x - c5 * w4_z;
        let t111 = w4_x * w4_x;
        let t112 = t53 * t53;
        let t113 = w4_z * w4_z;
        let t114 = w4_x * t53;
        let t115 = w4_x * w4_z;
        let t116 = t53 * w4_z;
        let t117 = t112 + t113;
        let t118 = dw4_z + t114;
        let t119 = t115 - t97;
        let t120 = dw4_z - t114;
        let t121 = t111 + t113;
        let t122 = t97 + t115;
        let t123 = t96 + t116;
        let t127 = t89 - D5 * t118;
        let t128 = a4_y + D5 * t121;
        let t129 = t86 - D5 * t123;
        let t132 = c5 * t127 + s5 * t129;
        let a5_y = s5 * t127 - c5 * t129;
        let w5_z = t53 + dq5;
        let dw5_x = s5 * dw4_z - c5 * t96 - dq5 * t104;
        let dw5_y = c5 * dw4_z + s5 * t96 - dq5 * w5_x;
        let dw5_z = t97 + ddq5;
        put(53, t114); // row 2, XX4R
        put(57, t119); // row 2, YZ4
        put(84, t114); // row 3, XX4R
        put(88, t119); // row 3, YZ4
        put(109, t114); // row 4, XX4R
        put(113, t119); // row 4, YZ4
        put(132, a5_y); // row 5, MSX5
        put(133, t132); // row 5, MSY5R
        put(135, dw5_z); // row 5, ZZ5R
        [
        w5_x, t104, t111, t112, t113, t115, t116, t117,
        t118, t120, t121, t122, t123, t128, t132, a5_y,
        w5_z, dw5_x, dw5_y, dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, t147, t154, t155, t156, t157, t158, t159,
        t160, t161, t162, t163, t164, t165, t166, t167,
        t172, t176, a6_y, w6_z, t183, t184, dw6_z,
    ] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t147 = c6 * w5_z + s6 * w5_x;
        let t154 = w5_x * w5_x;
        let t155 = t104 * t104;
        let t156 = w5_z * w5_z;
        let t157 = w5_x * t104;
        let t158 = w5_x * w5_z;
        let t159 = t104 * w5_z;
        let t160 = t155 + t156;
        let t161 = dw5_z + t157;
        let t162 = dw5_y + t158;
        let t163 = t157 - dw5_z;
        let t164 = t154 + t156;
        let t165 = dw5_x + t159;
        let t166 = dw5_y - t158;
        let t167 = dw5_x - t159;
        let t171 = t132 + D6 * t161;
        let t172 = a5_y - D6 * t164;
        let t173 = D6 * t167 - t128;
        let t176 = c6 * t171 + s6 * t173;
        let a6_y = s6 * t171 - c6 * t173;
        let w6_z = dq6 - t104;
        let t183 = s6 * dw5_z - c6 * dw5_x + dq6 * t147;
        let t184 = c6 * dw5_z + s6 * dw5_x + dq6 * w6_x;
        let dw6_z = dw5_y + ddq6;
        put(134, t157); // row 5, XX5R
        put(137, t165); // row 5, XZ5
        put(138, t162); // row 5, YZ5
        put(150, a6_y); // row 6, MSX6
        put(151, t176); // row 6, MSY6
        put(153, dw6_z); // row 6, ZZ6
        [
        w6_x, t147, t154, t155, t156, t157, t158, t159,
        t160, t161, t162, t163, t164, t165, t166, t167,
        t172, t176, a6_y, w6_z, t183, t184, dw6_z,
    ]
    };
    // joint axes in frame 3
    let [v1_3_z, z1_3_x, t192, t193, t194] = {
        let v1_3_z = c2 * k1;
        let z1_3_x = s2 * c3 + c2 * s3;
        let t192 = s2 * s3 - c2 * c3;
        let t193 = s3 * k1;
        let t194 = c3 * k1;
        [v1_3_z, z1_3_x, t192, t193, t194]
    };
    // joint axes in frame 4
    let [
        t198, t201, t204, t207, v1_5_z, v2_4_x, v2_4_y, t218,
        v3_5_z,
    ] = {
        let t195 = D4 * t192;
        let t196 = D4 * z1_3_x;
        let t198 = k2 * t192 - v1_3_z;
        let t201 = s4 * t192 - c4 * z1_3_x;
        let t204 = c4 * t192 + s4 * z1_3_x;
        let t207 = c4 * t195 + s4 * t196;
        let v1_5_z = c4 * t196 - s4 * t195;
        let t211 = A3 - t194;
        let v2_4_x = s4 * t211 - c4 * t193;
        let v2_4_y = c4 * t211 + s4 * t193;
        let t218 = s4 * k2;
        let v3_5_z = c4 * k2;
        [
        t198, t201, t204, t207, v1_5_z, v2_4_x, v2_4_y, t218,
        v3_5_z,
    ]
    };
    // joint axes in frame 5
    let [t220, t221] = {
        let t220 = c5 * t201;
        let t221 = s5 * t201;
        [t220, t221]
    };
    // XX2: column
    let t223 = {
        let t223 = c2 * t7;
        let t224 = s2 * dw2_x + t223;
        put(1, t224); // row 1, XX2R
        t223
    };
    // ZZ2: column
    {
        let t226 = s2 * t6 - t223;
        put(2, t226); // row 1, ZZ2R
    }
    // XY2: column
    {
        let t227 = t22 - t23;
        let t230 = s2 * t29 + c2 * t30;
        put(3, t230); // row 1, XY2
        put(41, t227); // row 2, XY2
    }
    // XZ2: column
    {
        let t234 = s2 * t28 + c2 * (t24 - t22);
        put(4, t234); // row 1, XZ2R
    }
    // YZ2: column
    {
        let t238 = s2 * (t23 - t24) - c2 * t27;
        put(5, t238); // row 1, YZ2
    }
    // MSX3: column
    {
        let t241 = t33 * t192 + t72 * v1_3_z;
        let t245 = t66 * t193 - t69 * t194 - t41;
        put(6, t241); // row 1, MSX3R
        put(44, t245); // row 2, MSX3R
    }
    // MSY3: column
    {
        let t248 = t33 * z1_3_x - t73 * v1_3_z;
        let t252 = t38 + (t67 * t193 + t70 * t194);
        put(7, t248); // row 1, MSY3
        put(45, t252); // row 2, MSY3
    }
    // XX3: column
    let t254 = {
        let t254 = t64 * t192;
        let t255 = dw3_x * z1_3_x - t254;
        put(8, t255); // row 1, XX3R
        t254
    };
    // ZZ3: column
    {
        let t257 = t254 - t65 * z1_3_x;
        put(9, t257); // row 1, ZZ3R
    }
    // XY3: column
    {
        let t258 = t60 - t61;
        let t261 = t73 * t192 - t72 * z1_3_x;
        put(10, t261); // row 1, XY3
        put(48, t258); // row 2, XY3
        put(79, t258); // row 3, XY3
    }
    // XZ3: column
    {
        let t265 = t69 * z1_3_x - t192 * (t62 - t60);
        put(11, t265); // row 1, XZ3R
    }
    // YZ3: column
    {
        let t269 = z1_3_x * (t61 - t62) - t67 * t192;
        put(12, t269); // row 1, YZ3
    }
    // MSX4: column
    {
        let t276 = t117 * t207 - t120 * v1_5_z - t122 * t198 - t86 * t204;
        let t280 = a4_y + (t120 * v2_4_y - t117 * v2_4_x);
        let t284 = a4_y + (t117 * t218 - t120 * v3_5_z);
        put(13, t276); // row 1, MSX4
        put(51, t280); // row 2, MSX4
        put(82, t284); // row 3, MSX4
    }
    // MSY4: column
    {
        let t291 = t86 * t201 + (t123 * t198 + (t118 * t207 + t121 * v1_5_z));
        let t295 = t89 - (t118 * v2_4_x + t121 * v2_4_y);
        let t299 = t89 + (t118 * t218 + t121 * v3_5_z);
        put(14, t291); // row 1, MSY4R
        put(52, t295); // row 2, MSY4R
        put(83, t299); // row 3, MSY4R
    }
    // XX4: column
    let t301 = {
        let t301 = t115 * t204;
        let t302 = t96 * t201 - t301;
        put(15, t302); // row 1, XX4R
        t301
    };
    // ZZ4: column
    {
        let t304 = t301 + t116 * t201;
        put(16, t304); // row 1, ZZ4R
    }
    // XY4: column
    {
        let t305 = t111 - t112;
        let t308 = t122 * t201 + t123 * t204;
        put(17, t308); // row 1, XY4
        put(55, t305); // row 2, XY4
        put(86, t305); // row 3, XY4
        put(111, t305); // row 4, XY4
    }
    // XZ4: column
    {
        let t310 = t116 - t96;
        let t313 = t204 * (t111 - t113) - t120 * t201;
        put(18, t313); // row 1, XZ4
        put(56, t310); // row 2, XZ4
        put(87, t310); // row 3, XZ4
        put(112, t310); // row 4, XZ4
    }
    // YZ4: column
    {
        let t317 = t201 * (t113 - t112) - t118 * t204;
        put(19, t317); // row 1, YZ4
    }
    // MSX5: column
    let [t319, t324, t325] = {
        let t319 = s5 * t163;
        let t320 = t319 - c5 * t160;
        let t323 = s5 * t160 + c5 * t163;
        let t324 = s5 * t128;
        let t325 = c5 * t128;
        let t329 = t325 + D5 * t320;
        let t337 = t198 * t323 - (t207 * t320 + t166 * v1_5_z);
        let t338 = t201 * (t324 - D5 * t323) + a5_y * t204 + t337;
        let t342 = t329 + (v2_4_x * t320 + t166 * v2_4_y);
        let t346 = t329 - (t218 * t320 + t166 * v3_5_z);
        put(20, t338); // row 1, MSX5
        put(58, t342); // row 2, MSX5
        put(89, t346); // row 3, MSX5
        put(114, t329); // row 4, MSX5
        [t319, t324, t325]
    };
    // MSY5: column
    let t347 = {
        let t347 = c5 * t161;
        let t349 = s5 * t164 - t347;
        let t352 = s5 * t161 + c5 * t164;
        let t356 = D5 * t349 - t324;
        let t364 = t198 * t352 + (t167 * v1_5_z - t207 * t349);
        let t365 = t201 * (t325 - D5 * t352) + t132 * t204 + t364;
        let t369 = t356 + (v2_4_x * t349 - t167 * v2_4_y);
        let t373 = t356 + (t167 * v3_5_z - t218 * t349);
        put(21, t365); // row 1, MSY5R
        put(59, t369); // row 2, MSY5R
        put(90, t373); // row 3, MSY5R
        put(115, t356); // row 4, MSY5R
        t347
    };
    // XX5: column
    let [t375, t380] = {
        let t375 = t158 * t221;
        let t378 = t157 * t204 + (t375 - dw5_x * t220);
        let t380 = c5 * t158;
        let t381 = s5 * dw5_x + t380;
        put(22, t378); // row 1, XX5R
        put(60, t381); // row 2, XX5R
        put(91, t381); // row 3, XX5R
        put(116, t381); // row 4, XX5R
        [t375, t380]
    };
    // ZZ5: column
    let t387 = {
        let t385 = dw5_z * t204 + (t159 * t220 - t375);
        let t387 = t380 + s5 * t159;
        put(23, t385); // row 1, ZZ5R
        t387
    };
    // XY5: column
    {
        let t388 = t154 - t155;
        let t393 = t204 * t388 - (t166 * t220 - t167 * t221);
        let t396 = s5 * t166 + c5 * t167;
        put(24, t393); // row 1, XY5
        put(62, t396); // row 2, XY5
        put(93, t396); // row 3, XY5
        put(118, t396); // row 4, XY5
        put(136, t388); // row 5, XY5
    }
    // XZ5: column
    {
        let t397 = t156 - t154;
        let t402 = t165 * t204 + (t163 * t220 + t221 * t397);
        let t404 = c5 * t397 - t319;
        put(25, t402); // row 1, XZ5
        put(63, t404); // row 2, XZ5
        put(94, t404); // row 3, XZ5
        put(119, t404); // row 4, XZ5
    }
    // YZ5: column
    {
        let t405 = t155 - t156;
        let t410 = t162 * t204 + (t161 * t221 - t220 * t405);
        let t412 = t347 + s5 * t405;
        put(26, t410); // row 1, YZ5
        put(64, t412); // row 2, YZ5
        put(95, t412); // row 3, YZ5
        put(120, t412); // row 4, YZ5
    }
    // MSX6: column
    let [
        t413, t414, t415, t416, t417, t418, t420, t421,
        t423, t424, t425, t426, t428, t431, t433, t434,
    ] = {
        let t413 = w6_x * w6_x;
        let t414 = t147 * t147;
        let t415 = w6_z * w6_z;
        let t416 = w6_x * t147;
        let t417 = w6_x * w6_z;
        let t418 = t147 * w6_z;
        let t419 = t414 + t415;
        let t420 = dw6_z + t416;
        let t421 = t417 - t184;
        let t422 = dw6_z - t416;
        let t423 = t413 + t415;
        let t424 = t418 - t183;
        let t425 = t184 + t417;
        let t426 = t183 + t418;
        let t428 = s6 * t422;
        let t429 = c6 * t419 + t428;
        let t431 = c6 * t422;
        let t432 = s6 * t419 - t431;
        let t433 = s6 * t172;
        let t434 = c6 * t172;
        let t437 = t433 + D6 * t432;
        let t438 = t434 + D6 * t429;
        let t441 = c5 * t429 + s5 * t425;
        let t444 = c5 * t425 - s5 * t429;
        let t454 = s5 * t437 + c5 * a6_y - D5 * t441;
        let t457 = t204 * t438 - t201 * (c5 * t437 - s5 * a6_y - D5 * t444);
        let t463 = t457 - (t198 * t444 - (t207 * t441 + v1_5_z * t432));
        let t467 = t454 - (v2_4_x * t441 + v2_4_y * t432);
        let t471 = t454 + (t218 * t441 + v3_5_z * t432);
        put(27, t463); // row 1, MSX6
        put(65, t467); // row 2, MSX6
        put(96, t471); // row 3, MSX6
        put(121, t454); // row 4, MSX6
        put(139, t438); // row 5, MSX6
        put(152, t416); // row 6, XX6R
        put(155, t424); // row 6, XZ6
        put(156, t421); // row 6, YZ6
        [
        t413, t414, t415, t416, t417, t418, t420, t421,
        t423, t424, t425, t426, t428, t431, t433, t434,
    ]
    };
    // MSY6: column
    let [t472, t475] = {
        let t472 = c6 * t420;
        let t474 = t472 - s6 * t423;
        let t475 = s6 * t420;
        let t477 = t475 + c6 * t423;
        let t480 = t434 + D6 * t477;
        let t481 = D6 * t474 - t433;
        let t484 = c5 * t474 - s5 * t426;
        let t487 = s5 * t474 + c5 * t426;
        let t497 = s5 * t480 + c5 * t176 - D5 * t484;
        let t500 = t204 * t481 - t201 * (D5 * t487 - (s5 * t176 - c5 * t480));
        let t506 = t500 + (t198 * t487 + (t207 * t484 + v1_5_z * t477));
        let t510 = t497 - (v2_4_x * t484 + v2_4_y * t477);
        let t514 = t497 + (t218 * t484 + v3_5_z * t477);
        put(28, t506); // row 1, MSY6
        put(66, t510); // row 2, MSY6
        put(97, t514); // row 3, MSY6
        put(122, t497); // row 4, MSY6
        put(140, t481); // row 5, MSY6
        [t472, t475]
    };
    // XX6: column
    let [t516, t519] = {
        let t516 = s6 * t417;
        let t517 = c6 * t183 + t516;
        let t519 = c6 * t417;
        let t520 = s6 * t183 - t519;
        let t525 = t204 * t520 + (t220 * t517 + t221 * t416);
        let t528 = c5 * t416 - s5 * t517;
        put(29, t525); // row 1, XX6R
        put(67, t528); // row 2, XX6R
        put(98, t528); // row 3, XX6R
        put(123, t528); // row 4, XX6R
        put(141, t520); // row 5, XX6R
        [t516, t519]
    };
    // ZZ6: column
    {
        let t530 = c6 * t418 - t516;
        let t532 = t519 + s6 * t418;
        let t537 = t204 * t532 + (t220 * t530 + dw6_z * t221);
        let t540 = c5 * dw6_z - s5 * t530;
        put(30, t537); // row 1, ZZ6
        put(68, t540); // row 2, ZZ6
        put(99, t540); // row 3, ZZ6
        put(124, t540); // row 4, ZZ6
        put(142, t532); // row 5, ZZ6
    }
    // XY6: column
    {
        let t541 = t413 - t414;
        let t544 = c6 * t425 - s6 * t426;
        let t547 = s6 * t425 + c6 * t426;
        let t552 = t204 * t547 + (t220 * t544 + t221 * t541);
        let t555 = c5 * t541 - s5 * t544;
        put(31, t552); // row 1, XY6
        put(69, t555); // row 2, XY6
        put(100, t555); // row 3, XY6
        put(125, t555); // row 4, XY6
        put(143, t547); // row 5, XY6
        put(154, t541); // row 6, XY6
    }
    // XZ6: column
    {
        let t556 = t413 - t415;
        let t558 = t431 + s6 * t556;
        let t560 = c6 * t556 - t428;
        let t565 = t204 * t560 + (t221 * t424 - t220 * t558);
        let t568 = s5 * t558 + c5 * t424;
        put(32, t565); // row 1, XZ6
        put(70, t568); // row 2, XZ6
        put(101, t568); // row 3, XZ6
        put(126, t568); // row 4, XZ6
        put(144, t560); // row 5, XZ6
    }
    // YZ6: column
    {
        let t569 = t415 - t414;
        let t571 = t475 + c6 * t569;
        let t573 = s6 * t569 - t472;
        let t578 = t204 * t573 + (t220 * t571 + t221 * t421);
        let t581 = c5 * t421 - s5 * t571;
        let t582 = dq1.sign();
        let t583 = dq2.sign();
        let t584 = dq3.sign();
        let t585 = dq4.sign();
        let t586 = dq5.sign();
        let t587 = dq6.sign();
        let t588 = -a2_x;
        let t589 = -t25;
        let t590 = -t387;
        let t591 = -t41;
        put(33, t578); // row 1, YZ6
        put(35, t582); // row 1, FC1
        put(38, t588); // row 2, MSY2
        put(39, t589); // row 2, XX2R
        put(61, t590); // row 2, ZZ5R
        put(71, t581); // row 2, YZ6
        put(73, t583); // row 2, FC2
        put(75, t591); // row 3, MSX3R
        put(92, t590); // row 3, ZZ5R
        put(102, t581); // row 3, YZ6
        put(105, t584); // row 3, FC3
        put(117, t590); // row 4, ZZ5R
        put(127, t581); // row 4, YZ6
        put(130, t585); // row 4, FC4
        put(145, t573); // row 5, YZ6
        put(148, t586); // row 5, FC5
        put(159, t587); // row 6, FC6
    }
}
