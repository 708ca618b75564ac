//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil
//! and Dombre, 12.4.
//!
//! 813 multiplications, 634 additions; 7 x 91, 276 of 637 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig, constants};

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

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 91 + PATTERN[k].1
}

/// Regressor `W` of the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 91]; 7]) {
    let flat = &mut out.as_flattened_mut()[..];
    clear(&mut flat[0..6]);
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[7..13]),
            58 => clear(&mut flat[71..77]),
            59 => clear(&mut flat[78..84]),
            60 => clear(&mut flat[85..102]),
            62 => flat[104] = S::default(),
            118 => flat[161] = S::default(),
            119 => clear(&mut flat[163..169]),
            120 => clear(&mut flat[170..176]),
            121 => clear(&mut flat[177..203]),
            123 => flat[205] = S::default(),
            169 => clear(&mut flat[252..254]),
            170 => clear(&mut flat[255..261]),
            171 => clear(&mut flat[262..268]),
            172 => clear(&mut flat[269..304]),
            174 => flat[306] = S::default(),
            210 => clear(&mut flat[343..346]),
            211 => clear(&mut flat[347..353]),
            212 => clear(&mut flat[354..360]),
            213 => clear(&mut flat[361..405]),
            215 => flat[407] = S::default(),
            221 => flat[414] = S::default(),
            240 => clear(&mut flat[434..438]),
            241 => clear(&mut flat[439..445]),
            242 => clear(&mut flat[446..452]),
            243 => clear(&mut flat[453..506]),
            245 => flat[508] = S::default(),
            261 => clear(&mut flat[525..530]),
            262 => clear(&mut flat[531..537]),
            263 => clear(&mut flat[538..544]),
            264 => clear(&mut flat[545..607]),
            266 => flat[609] = S::default(),
            272 => clear(&mut flat[616..622]),
            273 => clear(&mut flat[623..629]),
            274 => clear(&mut flat[630..636]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
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
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6, ddq7] = *ddq;
    let k1 = S::constant(-GRAVITY[2]);
    let k4 = S::constant(0.088);
    let k5 = S::constant(1.0);
    let k_A = S::constant(constants::A);
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
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
    // joint axes in frame 3
    let [v1_3_x, v1_3_y, v2_3_x, v2_4_z] = {
        let t1 = s2 * k_L2;
        let v1_3_x = s3 * t1;
        let v1_3_y = c3 * t1;
        let v2_3_x = c3 * k_L2;
        let v2_4_z = s3 * k_L2;
        [v1_3_x, v1_3_y, v2_3_x, v2_4_z]
    };
    // link 2: motion
    let [
        t6, t7, t8, t9, t15, t16, t17, t18,
        t19, t20, t21, t22, t23, t24, t25,
    ] = {
        let t6 = s2 * k1;
        let t7 = c2 * k1;
        let t8 = s2 * dq1;
        let t9 = c2 * dq1;
        let t10 = s2 * ddq1;
        let t11 = c2 * ddq1;
        let t12 = t8 * t8;
        let t13 = dq2 * dq2;
        let t14 = t8 * t9;
        let t15 = dq2 * t8;
        let t16 = dq2 * t9;
        let t17 = t10 + t16;
        let t18 = t11 - t15;
        let t19 = t12 - t13;
        let t20 = t0 - t19;
        let t21 = ddq2 - t14;
        let t22 = ddq2 + t14;
        let t23 = t12 + t13;
        let t24 = t18 - t15;
        let t25 = t16 + t17;
        let t26 = -t7;
        let t27 = -t14;
        let t28 = -t10;
        let t29 = -t11;
        put(61, t26); // row 2, MSX2
        put(62, t6); // row 2, MSY2
        put(63, t27); // row 2, XX2
        put(64, t14); // row 2, YY2
        put(67, t28); // row 2, XZ2
        put(68, t29); // row 2, YZ2
        [
        t6, t7, t8, t9, t15, t16, t17, t18,
        t19, t20, t21, t22, t23, t24, t25,
    ]
    };
    // MSZ2: column
    {
        let t32 = c2 * t6 - s2 * t7;
        put(1, t32); // row 1, MSZ2
    }
    // XX2: column
    let t34 = {
        let t34 = c2 * t15;
        let t35 = s2 * t17 + t34;
        put(2, t35); // row 1, XX2
        t34
    };
    // YY2: column
    let t36 = {
        let t36 = s2 * t16;
        let t38 = c2 * t18 - t36;
        put(3, t38); // row 1, YY2
        t36
    };
    // ZZ2: column
    {
        let t39 = t36 - t34;
        put(4, t39); // row 1, ZZ2
    }
    // XY2: column
    {
        let t40 = t23 - t20;
        let t43 = s2 * t24 + c2 * t25;
        put(5, t43); // row 1, XY2
        put(66, t40); // row 2, XY2
    }
    // XZ2: column
    {
        let t46 = c2 * t19 - s2 * t22;
        put(6, t46); // row 1, XZ2
    }
    // YZ2: column
    {
        let t50 = s2 * (t23 - t0) - c2 * t21;
        put(7, t50); // row 1, YZ2
    }
    // link 3: motion
    let [
        t51, z1_3_y, t57, t60, a3_y, t66, w3_y, t72,
        t75, w3_z, dw3_z, t80, t81, t82, dw3_x, dw3_y,
        t85, t86, t87, t88, t89, t90, t91,
    ] = {
        let t51 = s2 * c3;
        let z1_3_y = s2 * s3;
        let t55 = k_L2 * t25;
        let t56 = t6 - k_L2 * t21;
        let t57 = k_L2 * t23 - t7;
        let t60 = c3 * t56 - s3 * t55;
        let a3_y = c3 * t55 + s3 * t56;
        let t66 = c3 * t8 - s3 * dq2;
        let w3_y = c3 * dq2 + s3 * t8;
        let t72 = c3 * t21 + s3 * t25;
        let t75 = s3 * t21 - c3 * t25;
        let w3_z = t9 + dq3;
        let dw3_z = t18 + ddq3;
        let t78 = t66 * t66;
        let t79 = w3_z * w3_z;
        let t80 = t66 * w3_y;
        let t81 = t66 * w3_z;
        let t82 = w3_y * w3_z;
        let dw3_x = t75 + t82;
        let dw3_y = t72 + t81;
        let t85 = t79 - t78;
        let t86 = t23 + t85;
        let t87 = dw3_z + t80;
        let t88 = t80 - dw3_z;
        let t89 = t78 + t79;
        let t90 = t81 + dw3_y;
        let t91 = t82 + dw3_x;
        let t92 = -t80;
        put(122, a3_y); // row 3, MSX3
        put(123, t60); // row 3, MSY3
        put(124, t80); // row 3, XX3
        put(125, t92); // row 3, YY3
        put(126, dw3_z); // row 3, ZZ3
        put(128, t75); // row 3, XZ3
        put(129, t72); // row 3, YZ3
        [
        t51, z1_3_y, t57, t60, a3_y, t66, w3_y, t72,
        t75, w3_z, dw3_z, t80, t81, t82, dw3_x, dw3_y,
        t85, t86, t87, t88, t89, t90, t91,
    ]
    };
    // joint axes in frame 4
    let [
        t93, t95, z1_4_x, z1_4_y, t104, t107, t108, z2_4_x,
        t110, t113, t116,
    ] = {
        let t93 = k_A * z1_3_y;
        let t95 = v1_3_y + c2 * k_A;
        let z1_4_x = c2 * s4 - c4 * t51;
        let z1_4_y = c2 * c4 + s4 * t51;
        let t104 = s4 * t93 - c4 * v1_3_x;
        let t107 = c4 * t93 + s4 * v1_3_x;
        let t108 = c3 * k_A;
        let z2_4_x = s3 * c4;
        let t110 = s3 * s4;
        let t113 = s4 * t108 - c4 * v2_3_x;
        let t116 = c4 * t108 + s4 * v2_3_x;
        [
        t93, t95, z1_4_x, z1_4_y, t104, t107, t108, z2_4_x,
        t110, t113, t116,
    ]
    };
    // M3: column
    {
        let t117 = k_L2 * a3_y;
        let t118 = k_L2 * t60;
        let t121 = t51 * t117 - z1_3_y * t118;
        let t125 = -(s3 * t117 + c3 * t118);
        put(8, t121); // row 1, M3
        put(69, t125); // row 2, M3
    }
    // MSX3: column
    {
        let t126 = k_L2 * t88;
        let t128 = t57 - k_L2 * t86;
        let t133 = c2 * a3_y + (z1_3_y * t128 - t51 * t126);
        let t136 = s3 * t126 + c3 * t128;
        put(9, t133); // row 1, MSX3
        put(70, t136); // row 2, MSX3
    }
    // MSY3: column
    {
        let t138 = k_L2 * t87;
        let t139 = k_L2 * t89 - t57;
        let t144 = c2 * t60 - (t51 * t139 + z1_3_y * t138);
        let t147 = s3 * t139 - c3 * t138;
        put(10, t144); // row 1, MSY3
        put(71, t147); // row 2, MSY3
    }
    // MSZ3: column
    {
        let t150 = k_L2 * t75 - a3_y;
        let t151 = k_L2 * t72 - t60;
        let t154 = z1_3_y * t151 - t51 * t150;
        let t157 = s3 * t150 + c3 * t151;
        put(11, t154); // row 1, MSZ3
        put(72, t157); // row 2, MSZ3
    }
    // XX3: column
    let [t159, t160, t164] = {
        let t159 = z1_3_y * t81;
        let t160 = c2 * t80;
        let t162 = t160 - (t51 * dw3_x + t159);
        let t164 = c3 * t81;
        let t165 = s3 * dw3_x - t164;
        put(12, t162); // row 1, XX3
        put(73, t165); // row 2, XX3
        [t159, t160, t164]
    };
    // YY3: column
    let [t166, t170] = {
        let t166 = t51 * t82;
        let t169 = t166 + z1_3_y * dw3_y - t160;
        let t170 = s3 * t82;
        let t172 = c3 * dw3_y - t170;
        put(13, t169); // row 1, YY3
        put(74, t172); // row 2, YY3
        [t166, t170]
    };
    // ZZ3: column
    {
        let t175 = c2 * dw3_z - (t166 - t159);
        let t176 = t164 + t170;
        put(14, t175); // row 1, ZZ3
        put(75, t176); // row 2, ZZ3
    }
    // XY3: column
    {
        let t177 = t89 - t86;
        let t182 = c2 * t177 + (z1_3_y * t91 - t51 * t90);
        let t185 = s3 * t90 + c3 * t91;
        put(15, t182); // row 1, XY3
        put(76, t185); // row 2, XY3
        put(127, t177); // row 3, XY3
    }
    // XZ3: column
    {
        let t190 = c2 * t75 + (t51 * t88 + z1_3_y * t85);
        let t193 = c3 * t85 - s3 * t88;
        put(16, t190); // row 1, XZ3
        put(77, t193); // row 2, XZ3
    }
    // YZ3: column
    {
        let t194 = t23 - t89;
        let t199 = c2 * t72 + (z1_3_y * t87 - t51 * t194);
        let t202 = s3 * t194 + c3 * t87;
        put(17, t199); // row 1, YZ3
        put(78, t202); // row 2, YZ3
    }
    // link 4: motion
    let [
        t207, t211, a4_y, t217, w4_y, t223, t226, w4_z,
        dw4_z, t231, t232, t233, dw4_x, t235, t236, t237,
        t238, t239, t240, t241, t242,
    ] = {
        let t206 = t60 + k_A * t86;
        let t207 = a3_y - k_A * t88;
        let t208 = t57 + k_A * t90;
        let t211 = c4 * t206 + s4 * t208;
        let a4_y = s4 * t206 - c4 * t208;
        let t217 = c4 * t66 - s4 * w3_z;
        let w4_y = c4 * w3_z + s4 * t66;
        let t223 = c4 * t87 - s4 * t91;
        let t226 = c4 * t91 + s4 * t87;
        let w4_z = dq4 - w3_y;
        let dw4_z = ddq4 - dw3_y;
        let t229 = t217 * t217;
        let t230 = w4_z * w4_z;
        let t231 = t217 * w4_y;
        let t232 = t217 * w4_z;
        let t233 = w4_y * w4_z;
        let dw4_x = t226 + t233;
        let t235 = t223 + t232;
        let t236 = t230 - t229;
        let t237 = t89 + t236;
        let t238 = dw4_z + t231;
        let t239 = dw4_z - t231;
        let t240 = t229 + t230;
        let t241 = t232 + t235;
        let t242 = t233 + dw4_x;
        let t243 = -t231;
        put(173, a4_y); // row 4, MSX4
        put(174, t211); // row 4, MSY4
        put(175, t231); // row 4, XX4
        put(176, t243); // row 4, YY4
        put(177, dw4_z); // row 4, ZZ4
        put(179, t226); // row 4, XZ4
        put(180, t223); // row 4, YZ4
        [
        t207, t211, a4_y, t217, w4_y, t223, t226, w4_z,
        dw4_z, t231, t232, t233, dw4_x, t235, t236, t237,
        t238, t239, t240, t241, t242,
    ]
    };
    // M4: column
    {
        let t248 = t207 * t95 + (t211 * t104 - a4_y * t107);
        let t253 = t211 * t113 - a4_y * t116 - t207 * v2_4_z;
        let t254 = k_A * t207;
        put(18, t248); // row 1, M4
        put(79, t253); // row 2, M4
        put(130, t254); // row 3, M4
    }
    // MSY4: column
    {
        let t257 = t207 * z1_4_x + z1_3_y * t211;
        let t263 = t238 * t104 + t240 * t107 - t242 * t95 - t257;
        let t266 = t207 * z2_4_x + c3 * t211;
        let t272 = t242 * v2_4_z + (t238 * t113 + t240 * t116) - t266;
        let t276 = -(s4 * t207 + k_A * t242);
        put(20, t263); // row 1, MSY4
        put(81, t272); // row 2, MSY4
        put(132, t276); // row 3, MSY4
    }
    // MSZ4: column
    {
        let t279 = a4_y * z1_4_x + t211 * z1_4_y;
        let t285 = t89 * t95 - (t223 * t104 - t226 * t107) - t279;
        let t293 = t89 * v2_4_z - (t226 * t116 - t223 * t113);
        let t294 = t211 * t110 - a4_y * z2_4_x - t293;
        let t299 = k_A * t89 - (s4 * a4_y + c4 * t211);
        put(21, t285); // row 1, MSZ4
        put(82, t294); // row 2, MSZ4
        put(133, t299); // row 3, MSZ4
    }
    // XX4: column
    let [t301, t302, t306, t307, t311] = {
        let t301 = t232 * z1_4_y;
        let t302 = z1_3_y * t231;
        let t304 = dw4_x * z1_4_x - t301 - t302;
        let t306 = t232 * t110;
        let t307 = c3 * t231;
        let t309 = dw4_x * z2_4_x + t306 - t307;
        let t311 = c4 * t232;
        let t312 = s4 * dw4_x - t311;
        put(22, t304); // row 1, XX4
        put(83, t309); // row 2, XX4
        put(134, t312); // row 3, XX4
        [t301, t302, t306, t307, t311]
    };
    // YY4: column
    let [t313, t317, t321] = {
        let t313 = t233 * z1_4_x;
        let t316 = t302 + (t235 * z1_4_y - t313);
        let t317 = t233 * z2_4_x;
        let t320 = t307 - (t317 + t235 * t110);
        let t321 = s4 * t233;
        let t323 = c4 * t235 - t321;
        put(23, t316); // row 1, YY4
        put(84, t320); // row 2, YY4
        put(135, t323); // row 3, YY4
        [t313, t317, t321]
    };
    // ZZ4: column
    {
        let t326 = t301 + t313 - z1_3_y * dw4_z;
        let t329 = t317 - t306 - c3 * dw4_z;
        let t330 = t311 + t321;
        put(24, t326); // row 1, ZZ4
        put(85, t329); // row 2, ZZ4
        put(136, t330); // row 3, ZZ4
    }
    // XY4: column
    {
        let t331 = t240 - t237;
        let t336 = t241 * z1_4_x + t242 * z1_4_y - z1_3_y * t331;
        let t341 = t241 * z2_4_x - t242 * t110 - c3 * t331;
        let t344 = s4 * t241 + c4 * t242;
        put(25, t336); // row 1, XY4
        put(86, t341); // row 2, XY4
        put(137, t344); // row 3, XY4
        put(178, t331); // row 4, XY4
    }
    // XZ4: column
    {
        let t349 = t239 * z1_4_x + t236 * z1_4_y - z1_3_y * t226;
        let t354 = t239 * z2_4_x - t236 * t110 - c3 * t226;
        let t357 = s4 * t239 + c4 * t236;
        put(26, t349); // row 1, XZ4
        put(87, t354); // row 2, XZ4
        put(138, t357); // row 3, XZ4
    }
    // YZ4: column
    {
        let t358 = t89 - t240;
        let t363 = z1_4_x * t358 + t238 * z1_4_y - z1_3_y * t223;
        let t368 = z2_4_x * t358 - t238 * t110 - c3 * t223;
        let t371 = s4 * t358 + c4 * t238;
        put(27, t363); // row 1, YZ4
        put(88, t368); // row 2, YZ4
        put(139, t371); // row 3, YZ4
    }
    // joint axes in frame 5
    let [
        t378, z1_5_x, t384, t387, v1_5_y, t397, z2_5_x, t403,
        t406, v2_5_y, z3_5_x, z3_6_z, v3_5_x, v3_5_y, t418, v4_5_y,
    ] = {
        let t376 = t104 - k_L3 * z1_3_y;
        let t377 = k_A * z1_4_y + k_L3 * z1_4_x - t95;
        let t378 = t107 - t93;
        let z1_5_x = c5 * z1_4_x + s5 * z1_3_y;
        let t384 = s5 * z1_4_x - c5 * z1_3_y;
        let t387 = c5 * t376 + s5 * t377;
        let v1_5_y = s5 * t376 - c5 * t377;
        let t395 = t113 - c3 * k_L3;
        let t396 = v2_4_z + (k_L3 * z2_4_x - k_A * t110);
        let t397 = t116 - t108;
        let z2_5_x = c5 * z2_4_x + c3 * s5;
        let t403 = s5 * z2_4_x - c3 * c5;
        let t406 = c5 * t395 + s5 * t396;
        let v2_5_y = s5 * t395 - c5 * t396;
        let t413 = k_A - (c4 * k_A + s4 * k_L3);
        let z3_5_x = s4 * c5;
        let z3_6_z = s4 * s5;
        let v3_5_x = s5 * t413;
        let v3_5_y = c5 * t413;
        let t418 = c5 * k_L3;
        let v4_5_y = s5 * k_L3;
        [
        t378, z1_5_x, t384, t387, v1_5_y, t397, z2_5_x, t403,
        t406, v2_5_y, z3_5_x, z3_6_z, v3_5_x, v3_5_y, t418, v4_5_y,
    ]
    };
    // link 5: motion
    let [
        t422, a5_z, t434, a5_y, t440, t443, t446, t449,
        w5_z, dw5_z, t454, t455, t456, t457, t458, t459,
        t460, t461, t462, t463, t464, t465,
    ] = {
        let t422 = k_A * t241;
        let t429 = t211 + (k_L3 * t238 - k_A * t237);
        let a5_z = a4_y - (k_A * t239 + k_L3 * t240);
        let t431 = t422 + k_L3 * t242 - t207;
        let t434 = c5 * t429 + s5 * t431;
        let a5_y = s5 * t429 - c5 * t431;
        let t440 = c5 * t217 + s5 * w4_z;
        let t443 = c5 * w4_z - s5 * t217;
        let t446 = c5 * t238 + s5 * t242;
        let t449 = c5 * t242 - s5 * t238;
        let w5_z = w4_y + dq5;
        let dw5_z = t235 + ddq5;
        let t452 = t440 * t440;
        let t453 = w5_z * w5_z;
        let t454 = t440 * t443;
        let t455 = t440 * w5_z;
        let t456 = t443 * w5_z;
        let t457 = t456 - t449;
        let t458 = t446 - t455;
        let t459 = t452 - t453;
        let t460 = t240 - t459;
        let t461 = dw5_z - t454;
        let t462 = dw5_z + t454;
        let t463 = t452 + t453;
        let t464 = t455 - t458;
        let t465 = t456 + t457;
        let t466 = -t454;
        let t467 = -t446;
        put(214, a5_y); // row 5, MSX5
        put(215, t434); // row 5, MSY5
        put(216, t466); // row 5, XX5
        put(217, t454); // row 5, YY5
        put(218, dw5_z); // row 5, ZZ5
        put(220, t449); // row 5, XZ5
        put(221, t467); // row 5, YZ5
        [
        t422, a5_z, t434, a5_y, t440, t443, t446, t449,
        w5_z, dw5_z, t454, t455, t456, t457, t458, t459,
        t460, t461, t462, t463, t464, t465,
    ]
    };
    // MSX4: column
    {
        let t475 = t241 * t95 + (t237 * t104 - t239 * t107);
        let t476 = t207 * z1_4_y - z1_3_y * a4_y + t475;
        let t479 = t207 * t110 + c3 * a4_y;
        let t485 = t237 * t113 - t239 * t116 - t241 * v2_4_z - t479;
        let t487 = t422 + c4 * t207;
        put(19, t476); // row 1, MSX4
        put(80, t485); // row 2, MSX4
        put(131, t487); // row 3, MSX4
    }
    // M5: column
    let [t489, t494, t499, t502] = {
        let t489 = a5_y * v1_5_y;
        let t492 = t434 * t387 + t489 - a5_z * t378;
        let t494 = a5_y * v2_5_y;
        let t497 = t434 * t406 + t494 - a5_z * t397;
        let t499 = a5_y * v3_5_y;
        let t500 = t499 - t434 * v3_5_x;
        let t502 = a5_y * v4_5_y;
        let t505 = t434 * t418 + t502 - k_A * a5_z;
        put(28, t492); // row 1, M5
        put(89, t497); // row 2, M5
        put(140, t500); // row 3, M5
        put(181, t505); // row 4, M5
        [t489, t494, t499, t502]
    };
    // MSX5: column
    {
        let t513 = t464 * t378 + (t460 * t387 + t462 * v1_5_y);
        let t514 = a5_z * t384 + a5_y * z1_4_y + t513;
        let t522 = t464 * t397 + (t460 * t406 + t462 * v2_5_y);
        let t523 = a5_z * t403 - a5_y * t110 + t522;
        let t530 = a5_z * z3_6_z + c4 * a5_y - (t460 * v3_5_x - t462 * v3_5_y);
        let t537 = c5 * a5_z + (k_A * t464 + (t460 * t418 + t462 * v4_5_y));
        put(29, t514); // row 1, MSX5
        put(90, t523); // row 2, MSX5
        put(141, t530); // row 3, MSX5
        put(182, t537); // row 4, MSX5
    }
    // MSY5: column
    let [t542, t551, t560, t565] = {
        let t542 = t463 * v1_5_y;
        let t546 = a5_z * z1_5_x + t434 * z1_4_y + (t465 * t378 + (t461 * t387 - t542));
        let t551 = t463 * v2_5_y;
        let t555 = a5_z * z2_5_x - t434 * t110 + (t465 * t397 + (t461 * t406 - t551));
        let t560 = t463 * v3_5_y;
        let t562 = a5_z * z3_5_x + c4 * t434 - (t461 * v3_5_x + t560);
        let t565 = t463 * v4_5_y;
        let t569 = k_A * t465 + (t461 * t418 - t565) - s5 * a5_z;
        put(30, t546); // row 1, MSY5
        put(91, t555); // row 2, MSY5
        put(142, t562); // row 3, MSY5
        put(183, t569); // row 4, MSY5
        [t542, t551, t560, t565]
    };
    // MSZ5: column
    {
        let t577 = t240 * t378 - (t449 * v1_5_y - t446 * t387);
        let t578 = t434 * t384 - a5_y * z1_5_x + t577;
        let t586 = t240 * t397 + (t446 * t406 - t449 * v2_5_y);
        let t587 = t434 * t403 - a5_y * z2_5_x + t586;
        let t594 = t434 * z3_6_z - a5_y * z3_5_x - (t446 * v3_5_x + t449 * v3_5_y);
        let t602 = k_A * t240 + (t446 * t418 - t449 * v4_5_y);
        let t603 = s5 * a5_y + c5 * t434 + t602;
        put(31, t578); // row 1, MSZ5
        put(92, t587); // row 2, MSZ5
        put(143, t594); // row 3, MSZ5
        put(184, t603); // row 4, MSZ5
    }
    // XX5: column
    let [t605, t606, t610, t611, t615, t616, t620] = {
        let t605 = t455 * t384;
        let t606 = t454 * z1_4_y;
        let t608 = t605 - t457 * z1_5_x - t606;
        let t610 = t455 * t403;
        let t611 = t454 * t110;
        let t613 = t611 + (t610 - t457 * z2_5_x);
        let t615 = t455 * z3_6_z;
        let t616 = c4 * t454;
        let t618 = t615 - t457 * z3_5_x - t616;
        let t620 = c5 * t455;
        let t621 = s5 * t457 + t620;
        put(32, t608); // row 1, XX5
        put(93, t613); // row 2, XX5
        put(144, t618); // row 3, XX5
        put(185, t621); // row 4, XX5
        [t605, t606, t610, t611, t615, t616, t620]
    };
    // YY5: column
    let [t622, t626, t630, t634] = {
        let t622 = t456 * z1_5_x;
        let t625 = t606 + (t622 + t458 * t384);
        let t626 = t456 * z2_5_x;
        let t629 = t626 + t458 * t403 - t611;
        let t630 = t456 * z3_5_x;
        let t633 = t616 + (t630 + t458 * z3_6_z);
        let t634 = s5 * t456;
        let t636 = c5 * t458 - t634;
        put(33, t625); // row 1, YY5
        put(94, t629); // row 2, YY5
        put(145, t633); // row 3, YY5
        put(186, t636); // row 4, YY5
        [t622, t626, t630, t634]
    };
    // ZZ5: column
    {
        let t639 = dw5_z * z1_4_y - (t605 + t622);
        let t645 = c4 * dw5_z - (t615 + t630);
        let t646 = t634 - t620;
        let t647 = -(dw5_z * t110 + (t610 + t626));
        put(34, t639); // row 1, ZZ5
        put(95, t647); // row 2, ZZ5
        put(146, t645); // row 3, ZZ5
        put(187, t646); // row 4, ZZ5
    }
    // XY5: column
    {
        let t648 = t463 - t460;
        let t653 = z1_4_y * t648 + (t464 * z1_5_x + t465 * t384);
        let t658 = t464 * z2_5_x + t465 * t403 - t110 * t648;
        let t663 = c4 * t648 + (t464 * z3_5_x + t465 * z3_6_z);
        let t666 = c5 * t465 - s5 * t464;
        put(35, t653); // row 1, XY5
        put(96, t658); // row 2, XY5
        put(147, t663); // row 3, XY5
        put(188, t666); // row 4, XY5
        put(219, t648); // row 5, XY5
    }
    // XZ5: column
    {
        let t671 = t449 * z1_4_y + (t462 * z1_5_x + t459 * t384);
        let t676 = t462 * z2_5_x + t459 * t403 - t449 * t110;
        let t681 = c4 * t449 + (t462 * z3_5_x + t459 * z3_6_z);
        let t684 = c5 * t459 - s5 * t462;
        put(36, t671); // row 1, XZ5
        put(97, t676); // row 2, XZ5
        put(148, t681); // row 3, XZ5
        put(189, t684); // row 4, XZ5
    }
    // YZ5: column
    {
        let t685 = t240 - t463;
        let t690 = z1_5_x * t685 - t461 * t384 - t446 * z1_4_y;
        let t695 = t446 * t110 + (z2_5_x * t685 - t461 * t403);
        let t700 = z3_5_x * t685 - t461 * z3_6_z - c4 * t446;
        let t704 = -(s5 * t685 + c5 * t461);
        put(37, t690); // row 1, YZ5
        put(98, t695); // row 2, YZ5
        put(149, t700); // row 3, YZ5
        put(190, t704); // row 4, YZ5
    }
    // joint axes in frame 6
    let [
        z1_6_x, z1_6_y, t713, v1_6_y, t719, z2_7_z, t725, t728,
        z3_6_x, z3_6_y, v3_6_x, t736, t737, z4_6_y, t741, v4_6_y,
    ] = {
        let z1_6_x = c6 * z1_5_x + s6 * z1_4_y;
        let z1_6_y = c6 * z1_4_y - s6 * z1_5_x;
        let t713 = c6 * t387 + s6 * t378;
        let v1_6_y = s6 * t387 - c6 * t378;
        let t719 = s6 * t110 - c6 * z2_5_x;
        let z2_7_z = c6 * t110 + s6 * z2_5_x;
        let t725 = c6 * t406 + s6 * t397;
        let t728 = c6 * t397 - s6 * t406;
        let z3_6_x = c6 * z3_5_x + c4 * s6;
        let z3_6_y = c4 * c6 - s6 * z3_5_x;
        let v3_6_x = c6 * v3_5_x;
        let t736 = s6 * v3_5_x;
        let t737 = s5 * c6;
        let z4_6_y = s5 * s6;
        let t741 = c6 * t418 + k_A * s6;
        let v4_6_y = s6 * t418 - k_A * c6;
        [
        z1_6_x, z1_6_y, t713, v1_6_y, t719, z2_7_z, t725, t728,
        z3_6_x, z3_6_y, v3_6_x, t736, t737, z4_6_y, t741, v4_6_y,
    ]
    };
    // link 6: motion
    let [
        t747, a6_y, t753, w6_y, t759, t762, w6_z, dw6_z,
        t767, t768, t769, dw6_x, dw6_y, t772, t773, t774,
        t775, t776, t777, t778,
    ] = {
        let t747 = c6 * t434 - s6 * a5_z;
        let a6_y = c6 * a5_z + s6 * t434;
        let t753 = c6 * t440 - s6 * w5_z;
        let w6_y = c6 * w5_z + s6 * t440;
        let t759 = c6 * t461 + s6 * t465;
        let t762 = s6 * t461 - c6 * t465;
        let w6_z = t443 + dq6;
        let dw6_z = t458 + ddq6;
        let t765 = t753 * t753;
        let t766 = w6_z * w6_z;
        let t767 = t753 * w6_y;
        let t768 = t753 * w6_z;
        let t769 = w6_y * w6_z;
        let dw6_x = t762 + t769;
        let dw6_y = t759 + t768;
        let t772 = t766 - t765;
        let t773 = t463 + t772;
        let t774 = dw6_z + t767;
        let t775 = dw6_z - t767;
        let t776 = t765 + t766;
        let t777 = t768 + dw6_y;
        let t778 = t769 + dw6_x;
        let t779 = -t767;
        put(244, a6_y); // row 6, MSX6
        put(245, t747); // row 6, MSY6
        put(246, t767); // row 6, XX6
        put(247, t779); // row 6, YY6
        put(248, dw6_z); // row 6, ZZ6
        put(250, t762); // row 6, XZ6
        put(251, t759); // row 6, YZ6
        [
        t747, a6_y, t753, w6_y, t759, t762, w6_z, dw6_z,
        t767, t768, t769, dw6_x, dw6_y, t772, t773, t774,
        t775, t776, t777, t778,
    ]
    };
    // M6: column
    {
        let t783 = t489 + (t747 * t713 + a6_y * v1_6_y);
        let t787 = t494 - (a6_y * t728 - t747 * t725);
        let t791 = t499 - (t747 * v3_6_x + a6_y * t736);
        let t795 = t502 + (t747 * t741 + a6_y * v4_6_y);
        put(38, t783); // row 1, M6
        put(99, t787); // row 2, M6
        put(150, t791); // row 3, M6
        put(191, t795); // row 4, M6
    }
    // MSX6: column
    {
        let t803 = t777 * v1_5_y + (t773 * t713 + t775 * v1_6_y);
        let t804 = a5_y * z1_6_y + a6_y * t384 + t803;
        let t812 = t775 * t728 - t773 * t725 - t777 * v2_5_y;
        let t813 = a6_y * t403 - a5_y * z2_7_z - t812;
        let t821 = t777 * v3_5_y - (t773 * v3_6_x + t775 * t736);
        let t822 = a5_y * z3_6_y + a6_y * z3_6_z + t821;
        let t830 = t777 * v4_5_y + (t773 * t741 + t775 * v4_6_y);
        let t831 = a5_y * z4_6_y + c5 * a6_y + t830;
        let t832 = c6 * a5_y;
        put(39, t804); // row 1, MSX6
        put(100, t813); // row 2, MSX6
        put(151, t822); // row 3, MSX6
        put(192, t831); // row 4, MSX6
        put(222, t832); // row 5, MSX6
    }
    // MSY6: column
    {
        let t840 = t778 * v1_5_y + (t776 * v1_6_y - t774 * t713);
        let t841 = t747 * t384 - a5_y * z1_6_x - t840;
        let t849 = t778 * v2_5_y - (t774 * t725 + t776 * t728);
        let t850 = a5_y * t719 + t747 * t403 - t849;
        let t858 = t776 * t736 - t774 * v3_6_x - t778 * v3_5_y;
        let t859 = t747 * z3_6_z - a5_y * z3_6_x + t858;
        let t867 = t778 * v4_5_y - (t774 * t741 - t776 * v4_6_y);
        let t868 = a5_y * t737 + c5 * t747 - t867;
        let t870 = -(s6 * a5_y);
        put(40, t841); // row 1, MSY6
        put(101, t850); // row 2, MSY6
        put(152, t859); // row 3, MSY6
        put(193, t868); // row 4, MSY6
        put(223, t870); // row 5, MSY6
    }
    // MSZ6: column
    {
        let t878 = t542 - (t759 * t713 + t762 * v1_6_y) - (a6_y * z1_6_x + t747 * z1_6_y);
        let t886 = a6_y * t719 + t747 * z2_7_z + (t551 - (t759 * t725 - t762 * t728));
        let t894 = t560 + (t759 * v3_6_x + t762 * t736) - (a6_y * z3_6_x + t747 * z3_6_y);
        let t902 = a6_y * t737 - t747 * z4_6_y + (t565 - (t759 * t741 + t762 * v4_6_y));
        let t906 = -(s6 * a6_y + c6 * t747);
        put(41, t878); // row 1, MSZ6
        put(102, t886); // row 2, MSZ6
        put(153, t894); // row 3, MSZ6
        put(194, t902); // row 4, MSZ6
        put(224, t906); // row 5, MSZ6
    }
    // XX6: column
    let [
        t908, t909, t913, t914, t918, t919, t923, t924,
        t928,
    ] = {
        let t908 = t768 * z1_6_y;
        let t909 = t767 * t384;
        let t911 = t909 + (dw6_x * z1_6_x - t908);
        let t913 = t768 * z2_7_z;
        let t914 = t767 * t403;
        let t916 = t914 + (t913 - dw6_x * t719);
        let t918 = t768 * z3_6_y;
        let t919 = t767 * z3_6_z;
        let t921 = t919 + (dw6_x * z3_6_x - t918);
        let t923 = t768 * z4_6_y;
        let t924 = c5 * t767;
        let t926 = t924 - (dw6_x * t737 + t923);
        let t928 = c6 * t768;
        let t929 = s6 * dw6_x - t928;
        put(42, t911); // row 1, XX6
        put(103, t916); // row 2, XX6
        put(154, t921); // row 3, XX6
        put(195, t926); // row 4, XX6
        put(225, t929); // row 5, XX6
        [
        t908, t909, t913, t914, t918, t919, t923, t924,
        t928,
    ]
    };
    // YY6: column
    let [t930, t934, t938, t942, t946] = {
        let t930 = t769 * z1_6_x;
        let t933 = dw6_y * z1_6_y - t930 - t909;
        let t934 = t769 * t719;
        let t937 = t934 - dw6_y * z2_7_z - t914;
        let t938 = t769 * z3_6_x;
        let t941 = dw6_y * z3_6_y - t938 - t919;
        let t942 = t769 * t737;
        let t945 = t942 + dw6_y * z4_6_y - t924;
        let t946 = s6 * t769;
        let t948 = c6 * dw6_y - t946;
        put(43, t933); // row 1, YY6
        put(104, t937); // row 2, YY6
        put(155, t941); // row 3, YY6
        put(196, t945); // row 4, YY6
        put(226, t948); // row 5, YY6
        [t930, t934, t938, t942, t946]
    };
    // ZZ6: column
    {
        let t951 = dw6_z * t384 + (t908 + t930);
        let t954 = dw6_z * t403 - (t913 + t934);
        let t957 = dw6_z * z3_6_z + (t918 + t938);
        let t960 = c5 * dw6_z + (t923 - t942);
        let t961 = t928 + t946;
        put(44, t951); // row 1, ZZ6
        put(105, t954); // row 2, ZZ6
        put(156, t957); // row 3, ZZ6
        put(197, t960); // row 4, ZZ6
        put(227, t961); // row 5, ZZ6
    }
    // XY6: column
    {
        let t962 = t776 - t773;
        let t967 = t384 * t962 + (t777 * z1_6_x + t778 * z1_6_y);
        let t972 = t403 * t962 - (t777 * t719 + t778 * z2_7_z);
        let t977 = z3_6_z * t962 + (t777 * z3_6_x + t778 * z3_6_y);
        let t982 = c5 * t962 + (t778 * z4_6_y - t777 * t737);
        let t985 = s6 * t777 + c6 * t778;
        put(45, t967); // row 1, XY6
        put(106, t972); // row 2, XY6
        put(157, t977); // row 3, XY6
        put(198, t982); // row 4, XY6
        put(228, t985); // row 5, XY6
        put(249, t962); // row 6, XY6
    }
    // link 7: motion
    let [
        t990, t994, t997, t1006, t1009, dw7_z, t1014, t1015,
        t1016, dw7_x, t1018, t1019, t1020, t1021, t1022, t1023,
        t1024, t1025,
    ] = {
        let t989 = t747 + k4 * t773;
        let t990 = a6_y + k4 * t775;
        let t991 = a5_y + k4 * t777;
        let t994 = c7 * t989 + s7 * t991;
        let t997 = c7 * t991 - s7 * t989;
        let t1000 = c7 * t753 - s7 * w6_z;
        let w7_y = c7 * w6_z + s7 * t753;
        let t1006 = c7 * t774 - s7 * t778;
        let t1009 = c7 * t778 + s7 * t774;
        let w7_z = dq7 - w6_y;
        let dw7_z = ddq7 - dw6_y;
        let t1012 = t1000 * t1000;
        let t1013 = w7_z * w7_z;
        let t1014 = t1000 * w7_y;
        let t1015 = t1000 * w7_z;
        let t1016 = w7_y * w7_z;
        let dw7_x = t1009 + t1016;
        let t1018 = t1006 + t1015;
        let t1019 = t1013 - t1012;
        let t1020 = t776 + t1019;
        let t1021 = dw7_z + t1014;
        let t1022 = dw7_z - t1014;
        let t1023 = t1012 + t1013;
        let t1024 = t1015 + t1018;
        let t1025 = t1016 + dw7_x;
        let t1026 = -t997;
        let t1027 = -t1014;
        put(265, t1026); // row 7, MSX7
        put(266, t994); // row 7, MSY7
        put(267, t1014); // row 7, XX7
        put(268, t1027); // row 7, YY7
        put(269, dw7_z); // row 7, ZZ7
        put(271, t1009); // row 7, XZ7
        put(272, t1006); // row 7, YZ7
        [
        t990, t994, t997, t1006, t1009, dw7_z, t1014, t1015,
        t1016, dw7_x, t1018, t1019, t1020, t1021, t1022, t1023,
        t1024, t1025,
    ]
    };
    // XZ6: column
    {
        let t1032 = t762 * t384 + (t775 * z1_6_x + t772 * z1_6_y);
        let t1037 = t762 * t403 - (t775 * t719 + t772 * z2_7_z);
        let t1042 = t762 * z3_6_z + (t775 * z3_6_x + t772 * z3_6_y);
        let t1047 = c5 * t762 - (t775 * t737 - t772 * z4_6_y);
        let t1050 = s6 * t775 + c6 * t772;
        put(46, t1032); // row 1, XZ6
        put(107, t1037); // row 2, XZ6
        put(158, t1042); // row 3, XZ6
        put(199, t1047); // row 4, XZ6
        put(229, t1050); // row 5, XZ6
    }
    // YZ6: column
    {
        let t1051 = t463 - t776;
        let t1056 = t759 * t384 + (z1_6_x * t1051 + t774 * z1_6_y);
        let t1061 = t759 * t403 - (t719 * t1051 + t774 * z2_7_z);
        let t1066 = t759 * z3_6_z + (z3_6_x * t1051 + t774 * z3_6_y);
        let t1071 = c5 * t759 + (t774 * z4_6_y - t737 * t1051);
        let t1074 = s6 * t1051 + c6 * t774;
        put(47, t1056); // row 1, YZ6
        put(108, t1061); // row 2, YZ6
        put(159, t1066); // row 3, YZ6
        put(200, t1071); // row 4, YZ6
        put(230, t1074); // row 5, YZ6
    }
    // joint axes in frame 7
    let [
        t1077, t1078, z1_7_x, t1084, t1087, v2_7_z, z2_7_x, t1094,
        t1097, t1098, z3_7_x, z3_7_y, t1107, t1108, z4_7_x, z4_7_y,
        t1115, z5_7_x, t1117,
    ] = {
        let t1077 = v1_5_y + k4 * z1_6_y;
        let t1078 = v1_6_y + k4 * t384;
        let z1_7_x = c7 * z1_6_x + s7 * t384;
        let t1084 = c7 * t384 - s7 * z1_6_x;
        let t1087 = v2_5_y - k4 * z2_7_z;
        let v2_7_z = t728 - k4 * t403;
        let z2_7_x = s7 * t403 - c7 * t719;
        let t1094 = c7 * t403 + s7 * t719;
        let t1097 = v3_5_y + k4 * z3_6_y;
        let t1098 = k4 * z3_6_z - t736;
        let z3_7_x = c7 * z3_6_x + s7 * z3_6_z;
        let z3_7_y = c7 * z3_6_z - s7 * z3_6_x;
        let t1107 = v4_5_y + k4 * z4_6_y;
        let t1108 = v4_6_y + c5 * k4;
        let z4_7_x = c5 * s7 - c7 * t737;
        let z4_7_y = c5 * c7 + s7 * t737;
        let t1115 = c6 * k4;
        let z5_7_x = s6 * c7;
        let t1117 = s6 * s7;
        [
        t1077, t1078, z1_7_x, t1084, t1087, v2_7_z, z2_7_x, t1094,
        t1097, t1098, z3_7_x, z3_7_y, t1107, t1108, z4_7_x, z4_7_y,
        t1115, z5_7_x, t1117,
    ]
    };
    // M7: column
    let t1120 = {
        let t1120 = s7 * t997 - c7 * t994;
        let t1123 = s7 * t994 + c7 * t997;
        let t1128 = t1077 * t1123 + (t990 * t1078 - t713 * t1120);
        let t1133 = t1087 * t1123 - (t725 * t1120 + t990 * v2_7_z);
        let t1138 = t1097 * t1123 + (v3_6_x * t1120 + t990 * t1098);
        let t1143 = t1107 * t1123 - (t741 * t1120 - t990 * t1108);
        let t1144 = t1115 * t1123;
        let t1145 = k4 * t990;
        put(48, t1128); // row 1, M7
        put(109, t1133); // row 2, M7
        put(160, t1138); // row 3, M7
        put(201, t1143); // row 4, M7
        put(231, t1144); // row 5, M7
        put(252, t1145); // row 6, M7
        t1120
    };
    // MSX7: column
    let t1147 = {
        let t1147 = s7 * t1022;
        let t1148 = c7 * t1020 + t1147;
        let t1151 = s7 * t1020 - c7 * t1022;
        let t1159 = t990 * t1084 + t997 * z1_6_y;
        let t1160 = t1077 * t1151 + (t713 * t1148 + t1024 * t1078) + t1159;
        let t1168 = t990 * t1094 - t997 * z2_7_z;
        let t1169 = t1087 * t1151 + (t725 * t1148 - t1024 * v2_7_z) + t1168;
        let t1174 = v3_6_x * t1148 - t1024 * t1098 - t1097 * t1151;
        let t1178 = t990 * z3_7_y + t997 * z3_6_y - t1174;
        let t1186 = t990 * z4_7_y + t997 * z4_6_y;
        let t1187 = t1107 * t1151 + (t741 * t1148 + t1024 * t1108) + t1186;
        let t1192 = t1115 * t1151 + (c6 * t997 - t990 * t1117);
        let t1195 = k4 * t1024 + c7 * t990;
        put(49, t1160); // row 1, MSX7
        put(110, t1169); // row 2, MSX7
        put(161, t1178); // row 3, MSX7
        put(202, t1187); // row 4, MSX7
        put(232, t1192); // row 5, MSX7
        put(253, t1195); // row 6, MSX7
        t1147
    };
    // MSY7: column
    let t1196 = {
        let t1196 = c7 * t1021;
        let t1198 = t1196 - s7 * t1023;
        let t1201 = s7 * t1021 + c7 * t1023;
        let t1209 = t990 * z1_7_x + t994 * z1_6_y;
        let t1210 = t1077 * t1201 + (t713 * t1198 - t1025 * t1078) - t1209;
        let t1218 = t990 * z2_7_x - t994 * z2_7_z;
        let t1219 = t1087 * t1201 + (t725 * t1198 + t1025 * v2_7_z) - t1218;
        let t1227 = t990 * z3_7_x + t994 * z3_6_y;
        let t1228 = t1097 * t1201 - (v3_6_x * t1198 + t1025 * t1098) - t1227;
        let t1236 = t990 * z4_7_x + t994 * z4_6_y;
        let t1237 = t1107 * t1201 + (t741 * t1198 - t1025 * t1108) - t1236;
        let t1242 = t1115 * t1201 - (t990 * z5_7_x + c6 * t994);
        let t1246 = -(k4 * t1025 + s7 * t990);
        put(50, t1210); // row 1, MSY7
        put(111, t1219); // row 2, MSY7
        put(162, t1228); // row 3, MSY7
        put(203, t1237); // row 4, MSY7
        put(233, t1242); // row 5, MSY7
        put(254, t1246); // row 6, MSY7
        t1196
    };
    // MSZ7: column
    {
        let t1249 = c7 * t1006 + s7 * t1009;
        let t1252 = c7 * t1009 - s7 * t1006;
        let t1260 = t994 * t1084 - t997 * z1_7_x;
        let t1261 = t1077 * t1252 + (t776 * t1078 - t713 * t1249) - t1260;
        let t1269 = t997 * z2_7_x - t994 * t1094;
        let t1270 = t1087 * t1252 - (t725 * t1249 + t776 * v2_7_z) + t1269;
        let t1278 = t997 * z3_7_x - t994 * z3_7_y;
        let t1279 = t1097 * t1252 + (v3_6_x * t1249 + t776 * t1098) + t1278;
        let t1287 = t997 * z4_7_x - t994 * z4_7_y;
        let t1288 = t1107 * t1252 + (t776 * t1108 - t741 * t1249) + t1287;
        let t1293 = t1115 * t1252 + (t997 * z5_7_x + t994 * t1117);
        let t1295 = t1120 + k4 * t776;
        put(51, t1261); // row 1, MSZ7
        put(112, t1270); // row 2, MSZ7
        put(163, t1279); // row 3, MSZ7
        put(204, t1288); // row 4, MSZ7
        put(234, t1293); // row 5, MSZ7
        put(255, t1295); // row 6, MSZ7
    }
    // XX7: column
    let [
        t1297, t1298, t1302, t1303, t1307, t1308, t1312, t1313,
        t1317, t1318, t1322,
    ] = {
        let t1297 = t1015 * t1084;
        let t1298 = t1014 * z1_6_y;
        let t1300 = dw7_x * z1_7_x - t1297 - t1298;
        let t1302 = t1015 * t1094;
        let t1303 = t1014 * z2_7_z;
        let t1305 = t1303 - (t1302 - dw7_x * z2_7_x);
        let t1307 = t1015 * z3_7_y;
        let t1308 = t1014 * z3_6_y;
        let t1310 = dw7_x * z3_7_x - t1307 - t1308;
        let t1312 = t1015 * z4_7_y;
        let t1313 = t1014 * z4_6_y;
        let t1315 = dw7_x * z4_7_x - t1312 - t1313;
        let t1317 = t1015 * t1117;
        let t1318 = c6 * t1014;
        let t1320 = dw7_x * z5_7_x + t1317 - t1318;
        let t1322 = c7 * t1015;
        let t1323 = s7 * dw7_x - t1322;
        put(52, t1300); // row 1, XX7
        put(113, t1305); // row 2, XX7
        put(164, t1310); // row 3, XX7
        put(205, t1315); // row 4, XX7
        put(235, t1320); // row 5, XX7
        put(256, t1323); // row 6, XX7
        [
        t1297, t1298, t1302, t1303, t1307, t1308, t1312, t1313,
        t1317, t1318, t1322,
    ]
    };
    // YY7: column
    let [t1324, t1328, t1332, t1336, t1340, t1344] = {
        let t1324 = t1016 * z1_7_x;
        let t1327 = t1298 - (t1324 - t1018 * t1084);
        let t1328 = t1016 * z2_7_x;
        let t1331 = t1018 * t1094 - t1328 - t1303;
        let t1332 = t1016 * z3_7_x;
        let t1335 = t1308 + (t1018 * z3_7_y - t1332);
        let t1336 = t1016 * z4_7_x;
        let t1339 = t1313 - (t1336 - t1018 * z4_7_y);
        let t1340 = t1016 * z5_7_x;
        let t1343 = t1318 - (t1340 + t1018 * t1117);
        let t1344 = s7 * t1016;
        let t1346 = c7 * t1018 - t1344;
        put(53, t1327); // row 1, YY7
        put(114, t1331); // row 2, YY7
        put(165, t1335); // row 3, YY7
        put(206, t1339); // row 4, YY7
        put(236, t1343); // row 5, YY7
        put(257, t1346); // row 6, YY7
        [t1324, t1328, t1332, t1336, t1340, t1344]
    };
    // ZZ7: column
    {
        let t1349 = t1297 + t1324 - dw7_z * z1_6_y;
        let t1352 = dw7_z * z2_7_z + (t1302 + t1328);
        let t1355 = t1307 + t1332 - dw7_z * z3_6_y;
        let t1358 = t1312 + t1336 - dw7_z * z4_6_y;
        let t1361 = t1340 - t1317 - c6 * dw7_z;
        let t1362 = t1322 + t1344;
        put(54, t1349); // row 1, ZZ7
        put(115, t1352); // row 2, ZZ7
        put(166, t1355); // row 3, ZZ7
        put(207, t1358); // row 4, ZZ7
        put(237, t1361); // row 5, ZZ7
        put(258, t1362); // row 6, ZZ7
    }
    // XY7: column
    {
        let t1363 = t1023 - t1020;
        let t1368 = t1024 * z1_7_x + t1025 * t1084 - z1_6_y * t1363;
        let t1373 = z2_7_z * t1363 + (t1024 * z2_7_x + t1025 * t1094);
        let t1378 = t1024 * z3_7_x + t1025 * z3_7_y - z3_6_y * t1363;
        let t1383 = t1024 * z4_7_x + t1025 * z4_7_y - z4_6_y * t1363;
        let t1388 = t1024 * z5_7_x - t1025 * t1117 - c6 * t1363;
        let t1391 = s7 * t1024 + c7 * t1025;
        put(55, t1368); // row 1, XY7
        put(116, t1373); // row 2, XY7
        put(167, t1378); // row 3, XY7
        put(208, t1383); // row 4, XY7
        put(238, t1388); // row 5, XY7
        put(259, t1391); // row 6, XY7
        put(270, t1363); // row 7, XY7
    }
    // XZ7: column
    {
        let t1396 = t1022 * z1_7_x + t1019 * t1084 - t1009 * z1_6_y;
        let t1401 = t1009 * z2_7_z + (t1022 * z2_7_x + t1019 * t1094);
        let t1406 = t1022 * z3_7_x + t1019 * z3_7_y - t1009 * z3_6_y;
        let t1411 = t1022 * z4_7_x + t1019 * z4_7_y - t1009 * z4_6_y;
        let t1416 = t1022 * z5_7_x - t1019 * t1117 - c6 * t1009;
        let t1418 = t1147 + c7 * t1019;
        put(56, t1396); // row 1, XZ7
        put(117, t1401); // row 2, XZ7
        put(168, t1406); // row 3, XZ7
        put(209, t1411); // row 4, XZ7
        put(239, t1416); // row 5, XZ7
        put(260, t1418); // row 6, XZ7
    }
    // YZ7: column
    {
        let t1419 = t776 - t1023;
        let t1424 = z1_7_x * t1419 + t1021 * t1084 - t1006 * z1_6_y;
        let t1429 = t1006 * z2_7_z + (z2_7_x * t1419 + t1021 * t1094);
        let t1434 = z3_7_x * t1419 + t1021 * z3_7_y - t1006 * z3_6_y;
        let t1439 = z4_7_x * t1419 + t1021 * z4_7_y - t1006 * z4_6_y;
        let t1444 = z5_7_x * t1419 - t1021 * t1117 - c6 * t1006;
        let t1446 = t1196 + s7 * t1419;
        let t1447 = dq1.sign();
        let t1448 = dq2.sign();
        let t1449 = dq3.sign();
        let t1450 = dq4.sign();
        let t1451 = dq5.sign();
        let t1452 = dq6.sign();
        let t1453 = dq7.sign();
        put(57, t1424); // row 1, YZ7
        put(59, t1447); // row 1, FC1
        put(118, t1429); // row 2, YZ7
        put(120, t1448); // row 2, FC2
        put(169, t1434); // row 3, YZ7
        put(171, t1449); // row 3, FC3
        put(210, t1439); // row 4, YZ7
        put(212, t1450); // row 4, FC4
        put(240, t1444); // row 5, YZ7
        put(242, t1451); // row 5, FC5
        put(261, t1446); // row 6, YZ7
        put(263, t1452); // row 6, FC6
        put(274, t1453); // row 7, FC7
    }
}
