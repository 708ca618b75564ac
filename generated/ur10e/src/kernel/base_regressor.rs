//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4.
//!
//! 316 multiplications, 249 additions; 6 x 58, 161 of 348 structurally nonzero.

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
        w2_x, w2_y, t3, t4, a2_x, a2_y, t9, t10,
        t11, dw2_x, t14, t15, t16, t17, t18, t19,
        t20,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t3 = s2 * ddq1;
        let t4 = c2 * ddq1;
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let t7 = w2_x * w2_x;
        let t8 = dq2 * dq2;
        let t9 = w2_x * w2_y;
        let t10 = dq2 * w2_x;
        let t11 = dq2 * w2_y;
        let dw2_x = t3 + t11;
        let dw2_y = t4 - t10;
        let t14 = t7 - t8;
        let t15 = t14 - t0;
        let t16 = ddq2 - t9;
        let t17 = ddq2 + t9;
        let t18 = t7 + t8;
        let t19 = dw2_y - t10;
        let t20 = t11 + dw2_x;
        put(37, a2_y); // row 2, MSX2R
        put(42, t3); // row 2, XZ2R
        put(43, t4); // row 2, YZ2
        [
        w2_x, w2_y, t3, t4, a2_x, a2_y, t9, t10,
        t11, dw2_x, t14, t15, t16, t17, t18, t19,
        t20,
    ]
    };
    // link 3: motion
    let [
        w3_x, t26, t29, t34, a3_y, t40, t43, w3_z,
        dw3_z, t49, t50, dw3_x, t53, t54, t55, t56,
        t57, t58, t59,
    ] = {
        let w3_x = c3 * w2_x + s3 * w2_y;
        let t26 = s3 * w2_x - c3 * w2_y;
        let t29 = t19 * k1;
        let t30 = t15 * k1 - a2_x;
        let t31 = t17 * k1 - a2_y;
        let t34 = c3 * t30 + s3 * t31;
        let a3_y = s3 * t30 - c3 * t31;
        let t40 = c3 * t4 - s3 * t3;
        let t43 = c3 * t3 + s3 * t4;
        let w3_z = dq2 + dq3;
        let dw3_z = ddq2 + ddq3;
        let t46 = w3_x * w3_x;
        let t47 = w3_z * w3_z;
        let t48 = w3_x * t26;
        let t49 = w3_x * w3_z;
        let t50 = t26 * w3_z;
        let dw3_x = t43 - t50;
        let dw3_y = t40 - t49;
        let t53 = t46 - t47;
        let t54 = t53 - t0;
        let t55 = dw3_z + t48;
        let t56 = dw3_z - t48;
        let t57 = t46 + t47;
        let t58 = dw3_y - t49;
        let t59 = t50 - dw3_x;
        put(46, t48); // row 2, XX3R
        put(47, dw3_z); // row 2, ZZ3R
        put(49, t43); // row 2, XZ3R
        put(50, t40); // row 2, YZ3
        put(75, a3_y); // row 3, MSX3R
        put(76, t34); // row 3, MSY3
        put(77, t48); // row 3, XX3R
        put(78, dw3_z); // row 3, ZZ3R
        put(80, t43); // row 3, XZ3R
        put(81, t40); // row 3, YZ3
        [
        w3_x, t26, t29, t34, a3_y, t40, t43, w3_z,
        dw3_z, t49, t50, dw3_x, t53, t54, t55, t56,
        t57, t58, t59,
    ]
    };
    // link 4: motion
    let [
        w4_x, t65, t77, t80, a4_y, w4_z, t95, t96,
        t97, dw4_y, t99, t100, t101, t102, t103, t104,
        t105,
    ] = {
        let w4_x = c4 * w3_x - s4 * t26;
        let t65 = c4 * t26 + s4 * w3_x;
        let t75 = t34 + (t54 * k2 - D4 * t40);
        let t76 = a3_y - (t56 * k2 + D4 * t43);
        let t77 = t29 - (D4 * t0 - t58 * k2);
        let t80 = c4 * t75 - s4 * t76;
        let a4_y = c4 * t76 + s4 * t75;
        let t86 = c4 * t40 - s4 * t43;
        let t89 = c4 * t43 + s4 * t40;
        let w4_z = w3_z + dq4;
        let dw4_z = dw3_z + ddq4;
        let t92 = w4_x * w4_x;
        let t93 = w4_z * w4_z;
        let t94 = w4_x * t65;
        let t95 = w4_x * w4_z;
        let t96 = t65 * w4_z;
        let t97 = t96 - t89;
        let dw4_y = t86 - t95;
        let t99 = t93 - t92;
        let t100 = t0 + t99;
        let t101 = dw4_z + t94;
        let t102 = t94 - dw4_z;
        let t103 = t92 + t93;
        let t104 = dw4_y - t95;
        let t105 = t96 + t97;
        put(53, t94); // row 2, XX4R
        put(54, dw4_z); // row 2, ZZ4R
        put(56, t89); // row 2, XZ4
        put(57, t86); // row 2, YZ4
        put(84, t94); // row 3, XX4R
        put(85, dw4_z); // row 3, ZZ4R
        put(87, t89); // row 3, XZ4
        put(88, t86); // row 3, YZ4
        put(107, a4_y); // row 4, MSX4
        put(108, t80); // row 4, MSY4R
        put(109, t94); // row 4, XX4R
        put(110, dw4_z); // row 4, ZZ4R
        put(112, t89); // row 4, XZ4
        put(113, t86); // row 4, YZ4
        [
        w4_x, t65, t77, t80, a4_y, w4_z, t95, t96,
        t97, dw4_y, t99, t100, t101, t102, t103, t104,
        t105,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t116, t120, a5_y, t126, t129, w5_z,
        dw5_z, t134, t135, t136, dw5_x, t138, t139, t140,
        t141, t142, t143, t144, t145,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t115 = t80 - D5 * t101;
        let t116 = a4_y + D5 * t103;
        let t117 = t77 + D5 * t105;
        let t120 = c5 * t115 - s5 * t117;
        let a5_y = c5 * t117 + s5 * t115;
        let t126 = c5 * t101 + s5 * t105;
        let t129 = s5 * t101 - c5 * t105;
        let w5_z = t65 + dq5;
        let dw5_z = ddq5 - dw4_y;
        let t132 = w5_x * w5_x;
        let t133 = w5_z * w5_z;
        let t134 = w5_x * w5_y;
        let t135 = w5_x * w5_z;
        let t136 = w5_y * w5_z;
        let dw5_x = t129 + t136;
        let t138 = t126 - t135;
        let t139 = t132 - t133;
        let t140 = t103 - t139;
        let t141 = t134 - dw5_z;
        let t142 = dw5_z + t134;
        let t143 = t132 + t133;
        let t144 = t138 - t135;
        let t145 = t136 + dw5_x;
        put(132, a5_y); // row 5, MSX5
        put(133, t120); // row 5, MSY5R
        put(135, dw5_z); // row 5, ZZ5R
        put(137, t129); // row 5, XZ5
        put(138, t126); // row 5, YZ5
        [
        w5_x, w5_y, t116, t120, a5_y, t126, t129, w5_z,
        dw5_z, t134, t135, t136, dw5_x, t138, t139, t140,
        t141, t142, t143, t144, t145,
    ]
    };
    // link 6: motion
    let [
        t156, t160, a6_y, t166, t169, dw6_z, t174, t175,
        t176, t177, t179, t180, t181, t182, t183, t184,
        t185,
    ] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t151 = c6 * w5_z + s6 * w5_x;
        let t155 = t120 - D6 * t141;
        let t156 = a5_y - D6 * t143;
        let t157 = t116 - D6 * t145;
        let t160 = c6 * t155 - s6 * t157;
        let a6_y = c6 * t157 + s6 * t155;
        let t166 = c6 * t141 - s6 * t145;
        let t169 = c6 * t145 + s6 * t141;
        let w6_z = w5_y + dq6;
        let dw6_z = t138 + ddq6;
        let t172 = w6_x * w6_x;
        let t173 = w6_z * w6_z;
        let t174 = w6_x * t151;
        let t175 = w6_x * w6_z;
        let t176 = t151 * w6_z;
        let t177 = t176 - t169;
        let dw6_y = t166 - t175;
        let t179 = t172 - t173;
        let t180 = t179 - t143;
        let t181 = dw6_z + t174;
        let t182 = dw6_z - t174;
        let t183 = t172 + t173;
        let t184 = dw6_y - t175;
        let t185 = t176 + t177;
        put(150, a6_y); // row 6, MSX6
        put(151, t160); // row 6, MSY6
        put(152, t174); // row 6, XX6R
        put(153, dw6_z); // row 6, ZZ6
        put(155, t169); // row 6, XZ6
        put(156, t166); // row 6, YZ6
        [
        t156, t160, a6_y, t166, t169, dw6_z, t174, t175,
        t176, t177, t179, t180, t181, t182, t183, t184,
        t185,
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
        t198, t201, t204, t207, v1_5_z, t214, v2_4_y, t218,
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
        let t214 = c4 * t193 - s4 * t211;
        let v2_4_y = c4 * t211 + s4 * t193;
        let t218 = s4 * k2;
        let v3_5_z = c4 * k2;
        [
        t198, t201, t204, t207, v1_5_z, t214, v2_4_y, t218,
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
        let t223 = c2 * t10;
        let t224 = s2 * dw2_x + t223;
        put(1, t224); // row 1, XX2R
        t223
    };
    // ZZ2: column
    {
        let t226 = s2 * t11 - t223;
        put(2, t226); // row 1, ZZ2R
    }
    // XY2: column
    {
        let t227 = t15 + t18;
        let t230 = s2 * t19 + c2 * t20;
        put(3, t230); // row 1, XY2
        put(41, t227); // row 2, XY2
    }
    // XZ2: column
    {
        let t233 = s2 * t17 - c2 * t14;
        put(4, t233); // row 1, XZ2R
    }
    // YZ2: column
    {
        let t237 = c2 * t16 - s2 * (t18 - t0);
        put(5, t237); // row 1, YZ2
    }
    // MSX3: column
    {
        let t240 = t29 * t192 - t58 * v1_3_z;
        let t244 = a3_y - (t54 * t193 + t56 * t194);
        put(6, t240); // row 1, MSX3R
        put(44, t244); // row 2, MSX3R
    }
    // MSY3: column
    {
        let t247 = t29 * z1_3_x - t59 * v1_3_z;
        let t251 = t34 + (t55 * t193 + t57 * t194);
        put(7, t247); // row 1, MSY3
        put(45, t251); // row 2, MSY3
    }
    // XX3: column
    let t253 = {
        let t253 = t49 * t192;
        let t254 = dw3_x * z1_3_x - t253;
        put(8, t254); // row 1, XX3R
        t253
    };
    // ZZ3: column
    {
        let t256 = t253 - t50 * z1_3_x;
        put(9, t256); // row 1, ZZ3R
    }
    // XY3: column
    {
        let t257 = t54 + t57;
        let t260 = t58 * z1_3_x + t59 * t192;
        put(10, t260); // row 1, XY3
        put(48, t257); // row 2, XY3
        put(79, t257); // row 3, XY3
    }
    // XZ3: column
    {
        let t263 = t56 * z1_3_x + t53 * t192;
        put(11, t263); // row 1, XZ3R
    }
    // YZ3: column
    {
        let t267 = z1_3_x * (t0 - t57) - t55 * t192;
        put(12, t267); // row 1, YZ3
    }
    // MSX4: column
    {
        let t274 = t77 * t204 + (t104 * t198 + (t100 * t207 + t102 * v1_5_z));
        let t278 = a4_y - (t102 * v2_4_y - t100 * t214);
        let t282 = a4_y + (t100 * t218 + t102 * v3_5_z);
        put(13, t274); // row 1, MSX4
        put(51, t278); // row 2, MSX4
        put(82, t282); // row 3, MSX4
    }
    // MSY4: column
    {
        let t289 = t105 * t198 + (t101 * t207 + t103 * v1_5_z) - t77 * t201;
        let t293 = t80 + (t101 * t214 - t103 * v2_4_y);
        let t297 = t80 + (t101 * t218 + t103 * v3_5_z);
        put(14, t289); // row 1, MSY4R
        put(52, t293); // row 2, MSY4R
        put(83, t297); // row 3, MSY4R
    }
    // XX4: column
    let t299 = {
        let t299 = t95 * t204;
        let t300 = t97 * t201 - t299;
        put(15, t300); // row 1, XX4R
        t299
    };
    // ZZ4: column
    {
        let t302 = t299 + t96 * t201;
        put(16, t302); // row 1, ZZ4R
    }
    // XY4: column
    {
        let t303 = t103 - t100;
        let t306 = t105 * t204 - t104 * t201;
        put(17, t306); // row 1, XY4
        put(55, t303); // row 2, XY4
        put(86, t303); // row 3, XY4
        put(111, t303); // row 4, XY4
    }
    // XZ4: column
    {
        let t309 = t102 * t201 - t99 * t204;
        put(18, t309); // row 1, XZ4
    }
    // YZ4: column
    {
        let t313 = t201 * (t103 - t0) - t101 * t204;
        put(19, t313); // row 1, YZ4
    }
    // MSX5: column
    let [t315, t320, t321] = {
        let t315 = s5 * t142;
        let t316 = c5 * t140 + t315;
        let t319 = s5 * t140 - c5 * t142;
        let t320 = s5 * t116;
        let t321 = c5 * t116;
        let t325 = t321 - D5 * t316;
        let t333 = t198 * t319 + (t207 * t316 - t144 * v1_5_z);
        let t334 = t201 * (t320 - D5 * t319) + a5_y * t204 + t333;
        let t338 = t325 + (t214 * t316 + t144 * v2_4_y);
        let t342 = t325 + (t218 * t316 - t144 * v3_5_z);
        put(20, t334); // row 1, MSX5
        put(58, t338); // row 2, MSX5
        put(89, t342); // row 3, MSX5
        put(114, t325); // row 4, MSX5
        [t315, t320, t321]
    };
    // MSY5: column
    let t343 = {
        let t343 = c5 * t141;
        let t345 = t343 + s5 * t143;
        let t348 = c5 * t143 - s5 * t141;
        let t352 = D5 * t345 - t320;
        let t360 = t198 * t348 - (t207 * t345 - t145 * v1_5_z);
        let t361 = t201 * (t321 - D5 * t348) + t120 * t204 + t360;
        let t365 = t352 - (t214 * t345 + t145 * v2_4_y);
        let t369 = t352 - (t218 * t345 - t145 * v3_5_z);
        put(21, t361); // row 1, MSY5R
        put(59, t365); // row 2, MSY5R
        put(90, t369); // row 3, MSY5R
        put(115, t352); // row 4, MSY5R
        t343
    };
    // XX5: column
    let [t371, t376] = {
        let t371 = t135 * t221;
        let t374 = t371 - dw5_x * t220 - t134 * t204;
        let t376 = c5 * t135;
        let t377 = s5 * dw5_x + t376;
        put(22, t374); // row 1, XX5R
        put(60, t377); // row 2, XX5R
        put(91, t377); // row 3, XX5R
        put(116, t377); // row 4, XX5R
        [t371, t376]
    };
    // ZZ5: column
    {
        let t381 = dw5_z * t204 - (t371 + t136 * t220);
        let t383 = s5 * t136 - t376;
        put(23, t381); // row 1, ZZ5R
        put(61, t383); // row 2, ZZ5R
        put(92, t383); // row 3, ZZ5R
        put(117, t383); // row 4, ZZ5R
    }
    // XY5: column
    {
        let t384 = t143 - t140;
        let t389 = t204 * t384 + (t145 * t221 - t144 * t220);
        let t392 = s5 * t144 + c5 * t145;
        put(24, t389); // row 1, XY5
        put(62, t392); // row 2, XY5
        put(93, t392); // row 3, XY5
        put(118, t392); // row 4, XY5
        put(136, t384); // row 5, XY5
    }
    // XZ5: column
    {
        let t397 = t129 * t204 - (t142 * t220 + t139 * t221);
        let t399 = t315 - c5 * t139;
        put(25, t397); // row 1, XZ5
        put(63, t399); // row 2, XZ5
        put(94, t399); // row 3, XZ5
        put(119, t399); // row 4, XZ5
    }
    // YZ5: column
    {
        let t400 = t103 - t143;
        let t405 = t126 * t204 - (t220 * t400 + t141 * t221);
        let t407 = s5 * t400 - t343;
        put(26, t405); // row 1, YZ5
        put(64, t407); // row 2, YZ5
        put(95, t407); // row 3, YZ5
        put(120, t407); // row 4, YZ5
    }
    // MSX6: column
    let [t409, t412, t414, t415] = {
        let t409 = s6 * t182;
        let t410 = t409 - c6 * t180;
        let t412 = c6 * t182;
        let t413 = s6 * t180 + t412;
        let t414 = s6 * t156;
        let t415 = c6 * t156;
        let t418 = t414 - D6 * t413;
        let t419 = t415 + D6 * t410;
        let t422 = c5 * t410 - s5 * t184;
        let t425 = s5 * t410 + c5 * t184;
        let t435 = s5 * t418 + c5 * a6_y - D5 * t422;
        let t438 = t201 * (s5 * a6_y - c5 * t418 - D5 * t425) + t204 * t419;
        let t444 = t438 + (t198 * t425 + (t207 * t422 - v1_5_z * t413));
        let t448 = t435 + (t214 * t422 + v2_4_y * t413);
        let t452 = t435 + (t218 * t422 - v3_5_z * t413);
        put(27, t444); // row 1, MSX6
        put(65, t448); // row 2, MSX6
        put(96, t452); // row 3, MSX6
        put(121, t435); // row 4, MSX6
        put(139, t419); // row 5, MSX6
        [t409, t412, t414, t415]
    };
    // MSY6: column
    let [t453, t456] = {
        let t453 = c6 * t181;
        let t455 = t453 - s6 * t183;
        let t456 = s6 * t181;
        let t458 = t456 + c6 * t183;
        let t461 = t415 + D6 * t458;
        let t462 = D6 * t455 - t414;
        let t465 = c5 * t455 - s5 * t185;
        let t468 = s5 * t455 + c5 * t185;
        let t478 = s5 * t461 + c5 * t160 - D5 * t465;
        let t481 = t204 * t462 - t201 * (c5 * t461 - s5 * t160 + D5 * t468);
        let t487 = t481 + (t198 * t468 + (t207 * t465 + v1_5_z * t458));
        let t491 = t478 + (t214 * t465 - v2_4_y * t458);
        let t495 = t478 + (t218 * t465 + v3_5_z * t458);
        put(28, t487); // row 1, MSY6
        put(66, t491); // row 2, MSY6
        put(97, t495); // row 3, MSY6
        put(122, t478); // row 4, MSY6
        put(140, t462); // row 5, MSY6
        [t453, t456]
    };
    // XX6: column
    let [t497, t500] = {
        let t497 = s6 * t175;
        let t498 = c6 * t177 + t497;
        let t500 = c6 * t175;
        let t501 = s6 * t177 - t500;
        let t506 = t204 * t501 + (t220 * t498 + t174 * t221);
        let t509 = c5 * t174 - s5 * t498;
        put(29, t506); // row 1, XX6R
        put(67, t509); // row 2, XX6R
        put(98, t509); // row 3, XX6R
        put(123, t509); // row 4, XX6R
        put(141, t501); // row 5, XX6R
        [t497, t500]
    };
    // ZZ6: column
    {
        let t511 = t497 - c6 * t176;
        let t513 = t500 + s6 * t176;
        let t518 = t204 * t513 + (dw6_z * t221 - t220 * t511);
        let t521 = s5 * t511 + c5 * dw6_z;
        put(30, t518); // row 1, ZZ6
        put(68, t521); // row 2, ZZ6
        put(99, t521); // row 3, ZZ6
        put(124, t521); // row 4, ZZ6
        put(142, t513); // row 5, ZZ6
    }
    // XY6: column
    {
        let t522 = t180 + t183;
        let t525 = c6 * t184 + s6 * t185;
        let t528 = c6 * t185 - s6 * t184;
        let t533 = t204 * t528 - (t220 * t525 - t221 * t522);
        let t536 = s5 * t525 + c5 * t522;
        put(31, t533); // row 1, XY6
        put(69, t536); // row 2, XY6
        put(100, t536); // row 3, XY6
        put(125, t536); // row 4, XY6
        put(143, t528); // row 5, XY6
        put(154, t522); // row 6, XY6
    }
    // XZ6: column
    {
        let t538 = t412 + s6 * t179;
        let t540 = c6 * t179 - t409;
        let t545 = t204 * t540 + (t169 * t221 - t220 * t538);
        let t548 = s5 * t538 + c5 * t169;
        put(32, t545); // row 1, XZ6
        put(70, t548); // row 2, XZ6
        put(101, t548); // row 3, XZ6
        put(126, t548); // row 4, XZ6
        put(144, t540); // row 5, XZ6
    }
    // YZ6: column
    {
        let t549 = t183 - t143;
        let t551 = t456 + c6 * t549;
        let t553 = s6 * t549 - t453;
        let t558 = t204 * t553 + (t220 * t551 + t166 * t221);
        let t561 = c5 * t166 - s5 * t551;
        let t562 = dq1.sign();
        let t563 = dq2.sign();
        let t564 = dq3.sign();
        let t565 = dq4.sign();
        let t566 = dq5.sign();
        let t567 = dq6.sign();
        let t568 = -a2_x;
        let t569 = -t9;
        let t570 = -t134;
        put(33, t558); // row 1, YZ6
        put(35, t562); // row 1, FC1
        put(38, t568); // row 2, MSY2
        put(39, t569); // row 2, XX2R
        put(71, t561); // row 2, YZ6
        put(73, t563); // row 2, FC2
        put(102, t561); // row 3, YZ6
        put(105, t564); // row 3, FC3
        put(127, t561); // row 4, YZ6
        put(130, t565); // row 4, FC4
        put(134, t570); // row 5, XX5R
        put(145, t553); // row 5, YZ6
        put(148, t566); // row 5, FC5
        put(159, t567); // row 6, FC6
    }
}
