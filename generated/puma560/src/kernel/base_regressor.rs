//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil
//! and Dombre, 12.4.
//!
//! 379 multiplications, 298 additions; 6 x 52, 157 of 312 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 157;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9),
    (0, 10), (0, 11), (0, 12), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18), (0, 19),
    (0, 20), (0, 21), (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28), (0, 29),
    (0, 30), (0, 31), (0, 32), (0, 33), (0, 34), (0, 35), (0, 40), (0, 46), (1, 1), (1, 2),
    (1, 3), (1, 4), (1, 5), (1, 6), (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (1, 12),
    (1, 13), (1, 14), (1, 15), (1, 16), (1, 17), (1, 18), (1, 19), (1, 20), (1, 21), (1, 22),
    (1, 23), (1, 24), (1, 25), (1, 26), (1, 27), (1, 28), (1, 29), (1, 30), (1, 31), (1, 32),
    (1, 33), (1, 34), (1, 35), (1, 41), (1, 47), (2, 8), (2, 9), (2, 10), (2, 11), (2, 12),
    (2, 13), (2, 14), (2, 15), (2, 16), (2, 17), (2, 18), (2, 19), (2, 20), (2, 21), (2, 22),
    (2, 23), (2, 24), (2, 25), (2, 26), (2, 27), (2, 28), (2, 29), (2, 30), (2, 31), (2, 32),
    (2, 33), (2, 34), (2, 35), (2, 36), (2, 42), (2, 48), (3, 15), (3, 16), (3, 17), (3, 18),
    (3, 19), (3, 20), (3, 21), (3, 22), (3, 23), (3, 24), (3, 25), (3, 26), (3, 27), (3, 28),
    (3, 29), (3, 30), (3, 31), (3, 32), (3, 33), (3, 34), (3, 35), (3, 37), (3, 43), (3, 49),
    (4, 22), (4, 23), (4, 24), (4, 25), (4, 26), (4, 27), (4, 28), (4, 29), (4, 30), (4, 31),
    (4, 32), (4, 33), (4, 34), (4, 35), (4, 38), (4, 44), (4, 50), (5, 29), (5, 30), (5, 31),
    (5, 32), (5, 33), (5, 34), (5, 35), (5, 39), (5, 45), (5, 51),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 52 + PATTERN[k].1
}

/// Regressor `W_b` of the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 52]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            35 => clear(&mut flat[36..40]),
            36 => clear(&mut flat[41..46]),
            37 => clear(&mut flat[47..53]),
            72 => clear(&mut flat[88..93]),
            73 => clear(&mut flat[94..99]),
            74 => clear(&mut flat[100..112]),
            103 => clear(&mut flat[141..146]),
            104 => clear(&mut flat[147..152]),
            105 => clear(&mut flat[153..171]),
            126 => flat[192] = S::default(),
            127 => clear(&mut flat[194..199]),
            128 => clear(&mut flat[200..205]),
            129 => clear(&mut flat[206..230]),
            143 => clear(&mut flat[244..246]),
            144 => clear(&mut flat[247..252]),
            145 => clear(&mut flat[253..258]),
            146 => clear(&mut flat[259..289]),
            153 => clear(&mut flat[296..299]),
            154 => clear(&mut flat[300..305]),
            155 => clear(&mut flat[306..311]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 52]; 6]) {
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
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let k1 = S::constant(-(-constants::D3 - constants::D2));
    let k2 = S::constant(-GRAVITY[2]);
    let k4 = S::constant(-constants::D3);
    let k5 = S::constant(-constants::A3);
    let k_A2 = S::constant(constants::A2);
    let k_D2 = S::constant(constants::D2);
    let k_D4 = S::constant(constants::D4);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        put(0, ddq1); // row 1, ZZ1R
        put(36, dq1); // row 1, FV1
        put(41, ddq2); // row 2, ZZ2R
        put(73, dq2); // row 2, FV2
        put(103, ddq3); // row 3, IA3
        put(104, dq3); // row 3, FV3
        put(127, ddq4); // row 4, IA4
        put(128, dq4); // row 4, FV4
        put(144, ddq5); // row 5, IA5
        put(145, dq5); // row 5, FV5
        put(154, ddq6); // row 6, IA6
        put(155, dq6); // row 6, FV6
        t0
    };
    // joint axes in frame 3
    let [v1_3_z, v1_3_x, v1_3_y, v2_3_x, v2_3_y] = {
        let v1_3_z = c2 * k_A2;
        let t2 = c2 * k1;
        let t3 = s2 * k1;
        let v1_3_x = s3 * t3 - c3 * t2;
        let v1_3_y = c3 * t3 + s3 * t2;
        let v2_3_x = s3 * k_A2;
        let v2_3_y = c3 * k_A2;
        [v1_3_z, v1_3_x, v1_3_y, v2_3_x, v2_3_y]
    };
    // link 2: motion
    let [
        t12, t13, t15, t17, a2_y, t22, t23, t27,
        t28, t29, t31, t32, t33, t34, t35, t36,
        t37,
    ] = {
        let t12 = s2 * k2;
        let t13 = c2 * k2;
        let t14 = k_D2 * ddq1;
        let t15 = k_D2 * t0;
        let t17 = t12 + c2 * t14;
        let a2_y = s2 * t14 - t13;
        let t20 = s2 * dq1;
        let t21 = c2 * dq1;
        let t22 = s2 * ddq1;
        let t23 = c2 * ddq1;
        let t24 = t20 * t20;
        let t25 = dq2 * dq2;
        let t26 = t20 * t21;
        let t27 = dq2 * t20;
        let t28 = dq2 * t21;
        let t29 = t22 + t28;
        let dw2_y = t27 - t23;
        let t31 = t25 - t24;
        let t32 = t0 + t31;
        let t33 = ddq2 - t26;
        let t34 = ddq2 + t26;
        let t35 = t24 + t25;
        let t36 = t27 + dw2_y;
        let t37 = t28 + t29;
        let t38 = -t26;
        let t39 = -t22;
        let t40 = -t23;
        put(40, t38); // row 2, XX2R
        put(43, t39); // row 2, XZ2R
        put(44, t40); // row 2, YZ2
        [
        t12, t13, t15, t17, a2_y, t22, t23, t27,
        t28, t29, t31, t32, t33, t34, t35, t36,
        t37,
    ]
    };
    // MSX2: column
    let t41 = {
        let t41 = s2 * t34;
        t41
    };
    // XZ2: column
    {
        let t43 = t41 + c2 * t31;
        let t44 = k_D2 * t43;
        let t46 = k_D2 * t22 - t13;
        let t47 = -t43;
        put(1, t44); // row 1, MSX2R
        put(6, t47); // row 1, XZ2R
        put(38, t46); // row 2, MSX2R
    }
    // MSY2: column
    let t48 = {
        let t48 = c2 * t33;
        t48
    };
    // YZ2: column
    {
        let t51 = t48 + s2 * (t0 - t35);
        let t52 = k_D2 * t51;
        let t54 = t12 + k_D2 * t23;
        let t55 = -t51;
        put(2, t52); // row 1, MSY2
        put(7, t55); // row 1, YZ2
        put(39, t54); // row 2, MSY2
    }
    // XX2: column
    let t57 = {
        let t57 = c2 * t27;
        let t58 = s2 * t29 + t57;
        put(3, t58); // row 1, XX2R
        t57
    };
    // ZZ2: column
    {
        let t60 = s2 * t28 - t57;
        put(4, t60); // row 1, ZZ2R
    }
    // XY2: column
    {
        let t61 = t35 - t32;
        let t64 = c2 * t37 - s2 * t36;
        put(5, t64); // row 1, XY2
        put(42, t61); // row 2, XY2
    }
    // link 3: motion
    let [
        t67, t70, w3_z, t84, t87, a3_y, t93, t94,
        t98, t99, t100, t101, t102, t103, t104, t105,
        t106, t107, t108,
    ] = {
        let t67 = s2 * c3 + c2 * s3;
        let t70 = c2 * c3 - s2 * s3;
        let w3_z = dq2 + dq3;
        let dw3_z = ddq2 + ddq3;
        let t82 = t17 - (t23 * k4 - k_A2 * t32);
        let t83 = a2_y + (k_A2 * t34 - t22 * k4);
        let t84 = t15 + (k_A2 * t36 - t0 * k4);
        let t87 = c3 * t82 - s3 * t83;
        let a3_y = c3 * t83 + s3 * t82;
        let t91 = ddq1 * t70;
        let t92 = ddq1 * t67;
        let t93 = dq1 * t67;
        let t94 = dq1 * t70;
        let t95 = t93 * t93;
        let t96 = w3_z * w3_z;
        let t97 = t93 * t94;
        let t98 = w3_z * t93;
        let t99 = w3_z * t94;
        let t100 = t92 + t99;
        let t101 = t91 - t98;
        let t102 = t95 - t96;
        let t103 = t0 - t102;
        let t104 = dw3_z - t97;
        let t105 = dw3_z + t97;
        let t106 = t95 + t96;
        let t107 = t101 - t98;
        let t108 = t99 + t100;
        let t109 = -t97;
        let t110 = -t92;
        let t111 = -t91;
        put(47, t109); // row 2, XX3R
        put(48, dw3_z); // row 2, ZZ3R
        put(50, t110); // row 2, XZ3
        put(51, t111); // row 2, YZ3
        put(75, a3_y); // row 3, MSX3R
        put(76, t87); // row 3, MSY3R
        put(77, t109); // row 3, XX3R
        put(78, dw3_z); // row 3, ZZ3R
        put(80, t110); // row 3, XZ3
        put(81, t111); // row 3, YZ3
        [
        t67, t70, w3_z, t84, t87, a3_y, t93, t94,
        t98, t99, t100, t101, t102, t103, t104, t105,
        t106, t107, t108,
    ]
    };
    // joint axes in frame 4
    let [v1_4_x, t121, v2_4_z, v2_4_x, t125, v3_4_x, t127] = {
        let t115 = t70 * k5 - k_D4 * t67 - v1_3_z;
        let v1_4_x = c4 * v1_3_x - s4 * t115;
        let t121 = c4 * t115 + s4 * v1_3_x;
        let t122 = k_D4 + v2_3_x;
        let v2_4_z = k5 - v2_3_y;
        let v2_4_x = c4 * t122;
        let t125 = s4 * t122;
        let v3_4_x = c4 * k_D4;
        let t127 = s4 * k_D4;
        [v1_4_x, t121, v2_4_z, v2_4_x, t125, v3_4_x, t127]
    };
    // MSX3: column
    {
        let t134 = t107 * v1_3_z + (t105 * v1_3_y - t103 * v1_3_x) - t70 * t84;
        let t138 = a3_y + (t105 * v2_3_y - t103 * v2_3_x);
        put(8, t134); // row 1, MSX3R
        put(45, t138); // row 2, MSX3R
    }
    // MSY3: column
    {
        let t145 = t67 * t84 - (t108 * v1_3_z + (t104 * v1_3_x + t106 * v1_3_y));
        let t149 = t87 - (t104 * v2_3_x + t106 * v2_3_y);
        put(9, t145); // row 1, MSY3R
        put(46, t149); // row 2, MSY3R
    }
    // XX3: column
    let t151 = {
        let t151 = t70 * t98;
        let t152 = t67 * t100 + t151;
        put(10, t152); // row 1, XX3R
        t151
    };
    // ZZ3: column
    {
        let t154 = t67 * t99 - t151;
        put(11, t154); // row 1, ZZ3R
    }
    // XY3: column
    {
        let t155 = t106 - t103;
        let t158 = t67 * t107 + t70 * t108;
        put(12, t158); // row 1, XY3R
        put(49, t155); // row 2, XY3R
        put(79, t155); // row 3, XY3R
    }
    // XZ3: column
    {
        let t161 = t70 * t102 - t67 * t105;
        put(13, t161); // row 1, XZ3
    }
    // YZ3: column
    {
        let t165 = t67 * (t106 - t0) - t70 * t104;
        put(14, t165); // row 1, YZ3
    }
    // link 4: motion
    let [
        t166, z1_4_y, t178, t182, a4_y, w4_x, w4_y, t194,
        t197, w4_z, dw4_z, t202, t203, t204, dw4_x, t206,
        t207, t208, t209, t210, t211, t212, t213,
    ] = {
        let t166 = c4 * t67;
        let z1_4_y = s4 * t67;
        let t177 = t87 - (t103 * k5 + k_D4 * t104);
        let t178 = a3_y + (k_D4 * t106 - t105 * k5);
        let t179 = t84 + (t107 * k5 - k_D4 * t108);
        let t182 = c4 * t177 + s4 * t179;
        let a4_y = s4 * t177 - c4 * t179;
        let w4_x = s4 * w3_z - c4 * t93;
        let w4_y = c4 * w3_z + s4 * t93;
        let t194 = c4 * t104 + s4 * t108;
        let t197 = s4 * t104 - c4 * t108;
        let w4_z = t94 + dq4;
        let dw4_z = t101 + ddq4;
        let t200 = w4_x * w4_x;
        let t201 = w4_z * w4_z;
        let t202 = w4_x * w4_y;
        let t203 = w4_x * w4_z;
        let t204 = w4_y * w4_z;
        let dw4_x = t197 + t204;
        let t206 = t203 - t194;
        let t207 = t201 - t200;
        let t208 = t106 + t207;
        let t209 = t202 - dw4_z;
        let t210 = dw4_z + t202;
        let t211 = t200 + t201;
        let t212 = t203 + t206;
        let t213 = t204 + dw4_x;
        let t214 = -t202;
        put(106, a4_y); // row 4, MSX4
        put(107, t182); // row 4, MSY4R
        put(108, t214); // row 4, XX4R
        put(109, dw4_z); // row 4, ZZ4R
        put(111, t197); // row 4, XZ4
        put(112, t194); // row 4, YZ4
        [
        t166, z1_4_y, t178, t182, a4_y, w4_x, w4_y, t194,
        t197, w4_z, dw4_z, t202, t203, t204, dw4_x, t206,
        t207, t208, t209, t210, t211, t212, t213,
    ]
    };
    // MSX4: column
    {
        let t222 = t212 * v1_3_y + (t208 * v1_4_x + t210 * t121);
        let t223 = z1_4_y * t178 + t70 * a4_y - t222;
        let t224 = c4 * t178;
        let t230 = t224 + (t212 * v2_4_z - (t208 * v2_4_x + t210 * t125));
        let t236 = t224 - (t208 * v3_4_x + t210 * t127 - k5 * t212);
        put(15, t223); // row 1, MSX4
        put(52, t230); // row 2, MSX4
        put(82, t236); // row 3, MSX4
    }
    // MSY4: column
    {
        let t244 = t209 * v1_4_x + t211 * t121 - t213 * v1_3_y;
        let t245 = t166 * t178 + t70 * t182 + t244;
        let t246 = s4 * t178;
        let t252 = t213 * v2_4_z + (t209 * v2_4_x + t211 * t125) - t246;
        let t258 = k5 * t213 + (t209 * v3_4_x + t211 * t127) - t246;
        put(16, t245); // row 1, MSY4R
        put(53, t252); // row 2, MSY4R
        put(83, t258); // row 3, MSY4R
    }
    // joint axes in frame 5
    let [
        t261, t264, v1_5_x, t270, z2_5_x, z2_6_z, t275, v2_6_z,
        v3_5_x, v3_6_z,
    ] = {
        let t261 = c5 * t166 + s5 * t70;
        let t264 = c5 * t70 - s5 * t166;
        let v1_5_x = c5 * v1_4_x + s5 * v1_3_y;
        let t270 = s5 * v1_4_x - c5 * v1_3_y;
        let z2_5_x = s4 * c5;
        let z2_6_z = s4 * s5;
        let t275 = s5 * v2_4_z - c5 * v2_4_x;
        let v2_6_z = c5 * v2_4_z + s5 * v2_4_x;
        let v3_5_x = c5 * v3_4_x - s5 * k5;
        let v3_6_z = c5 * k5 + s5 * v3_4_x;
        [
        t261, t264, v1_5_x, t270, z2_5_x, z2_6_z, t275, v2_6_z,
        v3_5_x, v3_6_z,
    ]
    };
    // XX4: column
    let [t286, t291] = {
        let t286 = z1_4_y * t203;
        let t289 = t286 - t166 * dw4_x - t70 * t202;
        let t291 = c4 * t203;
        let t292 = s4 * dw4_x + t291;
        put(17, t289); // row 1, XX4R
        put(54, t292); // row 2, XX4R
        put(84, t292); // row 3, XX4R
        [t286, t291]
    };
    // ZZ4: column
    {
        let t296 = t70 * dw4_z - (t286 + t166 * t204);
        let t298 = s4 * t204 - t291;
        put(18, t296); // row 1, ZZ4R
        put(55, t298); // row 2, ZZ4R
        put(85, t298); // row 3, ZZ4R
    }
    // XY4: column
    {
        let t299 = t211 - t208;
        let t304 = t70 * t299 + (t166 * t212 + z1_4_y * t213);
        let t307 = c4 * t213 - s4 * t212;
        put(19, t304); // row 1, XY4
        put(56, t307); // row 2, XY4
        put(86, t307); // row 3, XY4
        put(110, t299); // row 4, XY4
    }
    // XZ4: column
    {
        let t312 = t70 * t197 + (z1_4_y * t207 - t166 * t210);
        let t315 = s4 * t210 + c4 * t207;
        put(20, t312); // row 1, XZ4
        put(57, t315); // row 2, XZ4
        put(87, t315); // row 3, XZ4
    }
    // YZ4: column
    {
        let t316 = t106 - t211;
        let t321 = t70 * t194 - (t166 * t316 + z1_4_y * t209);
        let t324 = s4 * t316 - c4 * t209;
        put(21, t321); // row 1, YZ4
        put(58, t324); // row 2, YZ4
        put(88, t324); // row 3, YZ4
    }
    // link 5: motion
    let [
        t327, a5_y, w5_x, t336, t339, t342, w5_z, dw5_z,
        t347, t348, t349, t350, t351, t352, t353, t354,
        t355, t356, t357, t358,
    ] = {
        let t327 = c5 * t182 - s5 * t178;
        let a5_y = c5 * t178 + s5 * t182;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t336 = c5 * w4_z + s5 * w4_x;
        let t339 = c5 * t209 - s5 * t213;
        let t342 = c5 * t213 + s5 * t209;
        let w5_z = w4_y + dq5;
        let dw5_z = ddq5 - t206;
        let t345 = w5_x * w5_x;
        let t346 = w5_z * w5_z;
        let t347 = w5_x * t336;
        let t348 = w5_x * w5_z;
        let t349 = t336 * w5_z;
        let t350 = t349 - t342;
        let t351 = t348 - t339;
        let t352 = t346 - t345;
        let t353 = t211 + t352;
        let t354 = dw5_z + t347;
        let t355 = t347 - dw5_z;
        let t356 = t345 + t346;
        let t357 = t348 + t351;
        let t358 = t349 + t350;
        put(130, a5_y); // row 5, MSX5
        put(131, t327); // row 5, MSY5R
        put(132, t347); // row 5, XX5R
        put(133, dw5_z); // row 5, ZZ5R
        put(135, t342); // row 5, XZ5
        put(136, t339); // row 5, YZ5
        [
        t327, a5_y, w5_x, t336, t339, t342, w5_z, dw5_z,
        t347, t348, t349, t350, t351, t352, t353, t354,
        t355, t356, t357, t358,
    ]
    };
    // MSX5: column
    {
        let t366 = t357 * t121 + (t353 * v1_5_x - t355 * t270);
        let t367 = a4_y * t264 + z1_4_y * a5_y - t366;
        let t370 = a4_y * z2_6_z + c4 * a5_y;
        let t376 = t370 + (t353 * t275 + t355 * v2_6_z - t357 * t125);
        let t382 = t370 - (t357 * t127 - (t355 * v3_6_z - t353 * v3_5_x));
        let t383 = c5 * a4_y;
        put(22, t367); // row 1, MSX5
        put(59, t376); // row 2, MSX5
        put(89, t382); // row 3, MSX5
        put(113, t383); // row 4, MSX5
    }
    // MSY5: column
    {
        let t391 = t354 * v1_5_x - t356 * t270 - t358 * t121;
        let t392 = z1_4_y * t327 - a4_y * t261 - t391;
        let t395 = a4_y * z2_5_x + c4 * t327;
        let t401 = t395 + (t358 * t125 + (t354 * t275 + t356 * v2_6_z));
        let t407 = t395 + (t358 * t127 - (t354 * v3_5_x - t356 * v3_6_z));
        let t409 = -(s5 * a4_y);
        put(23, t392); // row 1, MSY5R
        put(60, t401); // row 2, MSY5R
        put(90, t407); // row 3, MSY5R
        put(114, t409); // row 4, MSY5R
    }
    // XX5: column
    let [t411, t416, t421] = {
        let t411 = t348 * t264;
        let t414 = z1_4_y * t347 - (t411 - t350 * t261);
        let t416 = t348 * z2_6_z;
        let t419 = c4 * t347 - (t350 * z2_5_x + t416);
        let t421 = c5 * t348;
        let t422 = s5 * t350 - t421;
        put(24, t414); // row 1, XX5R
        put(61, t419); // row 2, XX5R
        put(91, t419); // row 3, XX5R
        put(115, t422); // row 4, XX5R
        [t411, t416, t421]
    };
    // ZZ5: column
    {
        let t426 = z1_4_y * dw5_z + (t411 + t349 * t261);
        let t430 = c4 * dw5_z - (t349 * z2_5_x - t416);
        let t432 = t421 + s5 * t349;
        put(25, t426); // row 1, ZZ5R
        put(62, t430); // row 2, ZZ5R
        put(92, t430); // row 3, ZZ5R
        put(116, t432); // row 4, ZZ5R
    }
    // XY5: column
    {
        let t433 = t356 - t353;
        let t438 = z1_4_y * t433 + (t357 * t261 + t358 * t264);
        let t443 = c4 * t433 + (t358 * z2_6_z - t357 * z2_5_x);
        let t446 = s5 * t357 + c5 * t358;
        put(26, t438); // row 1, XY5
        put(63, t443); // row 2, XY5
        put(93, t443); // row 3, XY5
        put(117, t446); // row 4, XY5
        put(134, t433); // row 5, XY5
    }
    // XZ5: column
    {
        let t451 = z1_4_y * t342 + (t355 * t261 - t352 * t264);
        let t456 = c4 * t342 - (t355 * z2_5_x + t352 * z2_6_z);
        let t459 = s5 * t355 - c5 * t352;
        put(27, t451); // row 1, XZ5
        put(64, t456); // row 2, XZ5
        put(94, t456); // row 3, XZ5
        put(118, t459); // row 4, XZ5
    }
    // YZ5: column
    {
        let t460 = t356 - t211;
        let t465 = z1_4_y * t339 - (t354 * t264 - t261 * t460);
        let t470 = c4 * t339 - (z2_5_x * t460 + t354 * z2_6_z);
        let t473 = s5 * t460 - c5 * t354;
        put(28, t465); // row 1, YZ5
        put(65, t470); // row 2, YZ5
        put(95, t470); // row 3, YZ5
        put(119, t473); // row 4, YZ5
    }
    // link 6: motion
    let [
        t476, a6_y, t488, t491, dw6_z, t496, t497, t498,
        dw6_x, t501, t502, t503, t504, t505, t506, t507,
    ] = {
        let t476 = c6 * t327 - s6 * a4_y;
        let a6_y = c6 * a4_y + s6 * t327;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let t485 = s6 * w5_x - c6 * w5_z;
        let t488 = c6 * t354 + s6 * t358;
        let t491 = s6 * t354 - c6 * t358;
        let w6_z = t336 + dq6;
        let dw6_z = t351 + ddq6;
        let t494 = w6_x * w6_x;
        let t495 = w6_z * w6_z;
        let t496 = w6_x * t485;
        let t497 = w6_x * w6_z;
        let t498 = t485 * w6_z;
        let dw6_x = t491 - t498;
        let dw6_y = t488 - t497;
        let t501 = t494 - t495;
        let t502 = t501 - t356;
        let t503 = dw6_z + t496;
        let t504 = dw6_z - t496;
        let t505 = t494 + t495;
        let t506 = t497 - dw6_y;
        let t507 = dw6_x - t498;
        put(147, a6_y); // row 6, MSX6
        put(148, t476); // row 6, MSY6
        put(149, t496); // row 6, XX6R
        put(150, dw6_z); // row 6, ZZ6
        put(152, t491); // row 6, XZ6
        put(153, t488); // row 6, YZ6
        [
        t476, a6_y, t488, t491, dw6_z, t496, t497, t498,
        dw6_x, t501, t502, t503, t504, t505, t506, t507,
    ]
    };
    // MSX6: column
    let [t509, t512, t514, t515] = {
        let t509 = s6 * t504;
        let t510 = c6 * t502 - t509;
        let t512 = c6 * t504;
        let t513 = s6 * t502 + t512;
        let t514 = s6 * a5_y;
        let t515 = c6 * a5_y;
        let t525 = t121 * t513 - (v1_5_x * t510 + t506 * t270);
        let t526 = z1_4_y * t515 + (t261 * t514 + a6_y * t264) - t525;
        let t531 = c4 * t515 + (a6_y * z2_6_z - z2_5_x * t514);
        let t537 = t531 - (t125 * t513 + (t275 * t510 - t506 * v2_6_z));
        let t543 = t531 - (t127 * t513 - (v3_5_x * t510 + t506 * v3_6_z));
        let t546 = s5 * t514 + c5 * a6_y;
        let t547 = -t514;
        put(29, t526); // row 1, MSX6
        put(66, t537); // row 2, MSX6
        put(96, t543); // row 3, MSX6
        put(120, t546); // row 4, MSX6
        put(137, t515); // row 5, MSX6
        put(138, t547); // row 5, MSY6
        [t509, t512, t514, t515]
    };
    // MSY6: column
    let [t548, t551] = {
        let t548 = c6 * t503;
        let t550 = t548 - s6 * t505;
        let t551 = s6 * t503;
        let t553 = t551 + c6 * t505;
        let t563 = t121 * t553 + (t507 * t270 - v1_5_x * t550);
        let t564 = t261 * t515 + t476 * t264 - z1_4_y * t514 + t563;
        let t569 = t476 * z2_6_z - z2_5_x * t515 - c4 * t514;
        let t575 = t569 + (t125 * t553 + (t275 * t550 + t507 * v2_6_z));
        let t581 = t569 + (t127 * t553 + (t507 * v3_6_z - v3_5_x * t550));
        let t584 = s5 * t515 + c5 * t476;
        put(30, t564); // row 1, MSY6
        put(67, t575); // row 2, MSY6
        put(97, t581); // row 3, MSY6
        put(121, t584); // row 4, MSY6
        [t548, t551]
    };
    // XX6: column
    let [t586, t589] = {
        let t586 = s6 * t497;
        let t587 = t586 - c6 * dw6_x;
        let t589 = c6 * t497;
        let t590 = s6 * dw6_x + t589;
        let t595 = z1_4_y * t590 + (t261 * t587 + t496 * t264);
        let t600 = c4 * t590 + (t496 * z2_6_z - z2_5_x * t587);
        let t603 = s5 * t587 + c5 * t496;
        put(31, t595); // row 1, XX6R
        put(68, t600); // row 2, XX6R
        put(98, t600); // row 3, XX6R
        put(122, t603); // row 4, XX6R
        put(139, t590); // row 5, XX6R
        [t586, t589]
    };
    // ZZ6: column
    {
        let t605 = t586 - c6 * t498;
        let t607 = t589 + s6 * t498;
        let t612 = dw6_z * t264 - t261 * t605 - z1_4_y * t607;
        let t617 = z2_5_x * t605 + dw6_z * z2_6_z - c4 * t607;
        let t620 = c5 * dw6_z - s5 * t605;
        let t621 = -t607;
        put(32, t612); // row 1, ZZ6
        put(69, t617); // row 2, ZZ6
        put(99, t617); // row 3, ZZ6
        put(123, t620); // row 4, ZZ6
        put(140, t621); // row 5, ZZ6
    }
    // XY6: column
    {
        let t622 = t502 + t505;
        let t625 = c6 * t506 + s6 * t507;
        let t628 = c6 * t507 - s6 * t506;
        let t633 = z1_4_y * t628 + (t261 * t625 + t264 * t622);
        let t638 = c4 * t628 + (z2_6_z * t622 - z2_5_x * t625);
        let t641 = s5 * t625 + c5 * t622;
        put(33, t633); // row 1, XY6
        put(70, t638); // row 2, XY6
        put(100, t638); // row 3, XY6
        put(124, t641); // row 4, XY6
        put(141, t628); // row 5, XY6
        put(151, t622); // row 6, XY6
    }
    // XZ6: column
    {
        let t643 = t512 + s6 * t501;
        let t645 = t509 - c6 * t501;
        let t650 = z1_4_y * t645 + (t491 * t264 - t261 * t643);
        let t655 = c4 * t645 + (z2_5_x * t643 + t491 * z2_6_z);
        let t658 = c5 * t491 - s5 * t643;
        put(34, t650); // row 1, XZ6
        put(71, t655); // row 2, XZ6
        put(101, t655); // row 3, XZ6
        put(125, t658); // row 4, XZ6
        put(142, t645); // row 5, XZ6
    }
    // YZ6: column
    {
        let t659 = t505 - t356;
        let t661 = t551 + c6 * t659;
        let t663 = t548 - s6 * t659;
        let t668 = z1_4_y * t663 + (t261 * t661 + t488 * t264);
        let t673 = c4 * t663 - (z2_5_x * t661 - t488 * z2_6_z);
        let t676 = s5 * t661 + c5 * t488;
        let t677 = dq1.sign();
        let t678 = dq2.sign();
        let t679 = dq3.sign();
        let t680 = dq4.sign();
        let t681 = dq5.sign();
        let t682 = dq6.sign();
        put(35, t668); // row 1, YZ6
        put(37, t677); // row 1, FC1
        put(72, t673); // row 2, YZ6
        put(74, t678); // row 2, FC2
        put(102, t673); // row 3, YZ6
        put(105, t679); // row 3, FC3
        put(126, t676); // row 4, YZ6
        put(129, t680); // row 4, FC4
        put(143, t663); // row 5, YZ6
        put(146, t681); // row 5, FC5
        put(156, t682); // row 6, FC6
    }
}
