//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil
//! and Dombre, 12.4.
//!
//! 859 multiplications, 669 additions; 7 x 91, 280 of 637 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 280;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 6), (0, 10), (0, 11), (0, 12), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18),
    (0, 19), (0, 20), (0, 21), (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28),
    (0, 29), (0, 30), (0, 31), (0, 32), (0, 33), (0, 34), (0, 35), (0, 36), (0, 37), (0, 38),
    (0, 39), (0, 40), (0, 41), (0, 42), (0, 43), (0, 44), (0, 45), (0, 46), (0, 47), (0, 48),
    (0, 49), (0, 50), (0, 51), (0, 52), (0, 53), (0, 54), (0, 55), (0, 56), (0, 57), (0, 58),
    (0, 59), (0, 60), (0, 61), (0, 62), (0, 63), (0, 64), (0, 65), (0, 66), (0, 67), (0, 68),
    (0, 69), (0, 70), (0, 77), (0, 84), (1, 11), (1, 12), (1, 14), (1, 15), (1, 16), (1, 17),
    (1, 18), (1, 19), (1, 20), (1, 21), (1, 22), (1, 23), (1, 24), (1, 25), (1, 26), (1, 27),
    (1, 28), (1, 29), (1, 30), (1, 31), (1, 32), (1, 33), (1, 34), (1, 35), (1, 36), (1, 37),
    (1, 38), (1, 39), (1, 40), (1, 41), (1, 42), (1, 43), (1, 44), (1, 45), (1, 46), (1, 47),
    (1, 48), (1, 49), (1, 50), (1, 51), (1, 52), (1, 53), (1, 54), (1, 55), (1, 56), (1, 57),
    (1, 58), (1, 59), (1, 60), (1, 61), (1, 62), (1, 63), (1, 64), (1, 65), (1, 66), (1, 67),
    (1, 68), (1, 69), (1, 71), (1, 78), (1, 85), (2, 21), (2, 22), (2, 24), (2, 25), (2, 26),
    (2, 27), (2, 28), (2, 29), (2, 30), (2, 31), (2, 32), (2, 33), (2, 34), (2, 35), (2, 36),
    (2, 37), (2, 38), (2, 39), (2, 40), (2, 41), (2, 42), (2, 43), (2, 44), (2, 45), (2, 46),
    (2, 47), (2, 48), (2, 49), (2, 50), (2, 51), (2, 52), (2, 53), (2, 54), (2, 55), (2, 56),
    (2, 57), (2, 58), (2, 59), (2, 60), (2, 61), (2, 62), (2, 63), (2, 64), (2, 65), (2, 66),
    (2, 67), (2, 68), (2, 69), (2, 72), (2, 79), (2, 86), (3, 31), (3, 32), (3, 34), (3, 35),
    (3, 36), (3, 37), (3, 38), (3, 39), (3, 40), (3, 41), (3, 42), (3, 43), (3, 44), (3, 45),
    (3, 46), (3, 47), (3, 48), (3, 49), (3, 50), (3, 51), (3, 52), (3, 53), (3, 54), (3, 55),
    (3, 56), (3, 57), (3, 58), (3, 59), (3, 60), (3, 61), (3, 62), (3, 63), (3, 64), (3, 65),
    (3, 66), (3, 67), (3, 68), (3, 69), (3, 73), (3, 80), (3, 87), (4, 41), (4, 42), (4, 44),
    (4, 45), (4, 46), (4, 47), (4, 48), (4, 49), (4, 50), (4, 51), (4, 52), (4, 53), (4, 54),
    (4, 55), (4, 56), (4, 57), (4, 58), (4, 59), (4, 60), (4, 61), (4, 62), (4, 63), (4, 64),
    (4, 65), (4, 66), (4, 67), (4, 68), (4, 69), (4, 74), (4, 81), (4, 88), (5, 51), (5, 52),
    (5, 54), (5, 55), (5, 56), (5, 57), (5, 58), (5, 59), (5, 60), (5, 61), (5, 62), (5, 63),
    (5, 64), (5, 65), (5, 66), (5, 67), (5, 68), (5, 69), (5, 75), (5, 82), (5, 89), (6, 61),
    (6, 62), (6, 64), (6, 65), (6, 66), (6, 67), (6, 68), (6, 69), (6, 76), (6, 83), (6, 90),
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
            0 => clear(&mut flat[7..10]),
            61 => clear(&mut flat[71..77]),
            62 => clear(&mut flat[78..84]),
            63 => clear(&mut flat[85..102]),
            65 => flat[104] = S::default(),
            121 => flat[161] = S::default(),
            122 => clear(&mut flat[163..169]),
            123 => clear(&mut flat[170..176]),
            124 => clear(&mut flat[177..203]),
            126 => flat[205] = S::default(),
            172 => clear(&mut flat[252..254]),
            173 => clear(&mut flat[255..261]),
            174 => clear(&mut flat[262..268]),
            175 => clear(&mut flat[269..304]),
            177 => flat[306] = S::default(),
            213 => clear(&mut flat[343..346]),
            214 => clear(&mut flat[347..353]),
            215 => clear(&mut flat[354..360]),
            216 => clear(&mut flat[361..405]),
            218 => flat[407] = S::default(),
            244 => clear(&mut flat[434..438]),
            245 => clear(&mut flat[439..445]),
            246 => clear(&mut flat[446..452]),
            247 => clear(&mut flat[453..506]),
            249 => flat[508] = S::default(),
            265 => clear(&mut flat[525..530]),
            266 => clear(&mut flat[531..537]),
            267 => clear(&mut flat[538..544]),
            268 => clear(&mut flat[545..607]),
            270 => flat[609] = S::default(),
            276 => clear(&mut flat[616..622]),
            277 => clear(&mut flat[623..629]),
            278 => clear(&mut flat[630..636]),
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
    let k0 = S::constant(0.01175);
    let k1 = S::constant(0.42076);
    let k2 = S::constant(-GRAVITY[2]);
    let k3 = S::constant(0.0001380625);
    let k4 = S::constant(0.0235);
    let k5 = S::constant(0.01275);
    let k6 = S::constant(0.31436);
    let k7 = S::constant(0.00035);
    let k8 = S::constant(0.167455);
    let k9 = S::constant(1.0);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        put(0, ddq1); // row 1, ZZ1
        put(61, dq1); // row 1, FV1
        put(63, k9); // row 1, FO1
        put(68, ddq2); // row 2, ZZ2
        put(122, dq2); // row 2, FV2
        put(124, k9); // row 2, FO2
        put(173, dq3); // row 3, FV3
        put(175, k9); // row 3, FO3
        put(214, dq4); // row 4, FV4
        put(216, k9); // row 4, FO4
        put(245, dq5); // row 5, FV5
        put(247, k9); // row 5, FO5
        put(266, dq6); // row 6, FV6
        put(268, k9); // row 6, FO6
        put(277, dq7); // row 7, FV7
        put(279, k9); // row 7, FO7
        t0
    };
    // joint axes in frame 2
    let [t1, v1_2_y] = {
        let t1 = c2 * k0;
        let v1_2_y = s2 * k0;
        [t1, v1_2_y]
    };
    // joint axes in frame 3
    let [v1_3_x, v1_3_y, v2_3_x, v2_4_z] = {
        let t3 = s2 * k1;
        let v1_3_x = s3 * t3 - c3 * t1;
        let v1_3_y = c3 * t3 + s3 * t1;
        let v2_3_x = c3 * k1;
        let v2_4_z = s3 * k1;
        [v1_3_x, v1_3_y, v2_3_x, v2_4_z]
    };
    // link 2: motion
    let [
        t12, t13, a2_z, t17, a2_y, w2_x, w2_y, t22,
        t23, t27, t28, dw2_x, dw2_y, t31, t32, t33,
        t34, t35, t36, t37,
    ] = {
        let t12 = s2 * k2;
        let t13 = c2 * k2;
        let t14 = ddq1 * k0;
        let a2_z = t0 * k0;
        let t17 = t12 + c2 * t14;
        let a2_y = s2 * t14 - t13;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t22 = s2 * ddq1;
        let t23 = c2 * ddq1;
        let t24 = w2_x * w2_x;
        let t25 = dq2 * dq2;
        let t26 = w2_x * w2_y;
        let t27 = dq2 * w2_x;
        let t28 = dq2 * w2_y;
        let dw2_x = t22 + t28;
        let dw2_y = t23 - t27;
        let t31 = t25 - t24;
        let t32 = t0 + t31;
        let t33 = t26 - ddq2;
        let t34 = ddq2 + t26;
        let t35 = t24 + t25;
        let t36 = dw2_y - t27;
        let t37 = t28 + dw2_x;
        let t38 = -t26;
        put(66, t38); // row 2, XX2
        put(67, t26); // row 2, YY2
        put(70, t22); // row 2, XZ2
        put(71, t23); // row 2, YZ2
        [
        t12, t13, a2_z, t17, a2_y, w2_x, w2_y, t22,
        t23, t27, t28, dw2_x, dw2_y, t31, t32, t33,
        t34, t35, t36, t37,
    ]
    };
    // MSZ2: column
    let [t41, t42] = {
        let t41 = s2 * t13 - c2 * t12;
        let t42 = k0 * t41;
        [t41, t42]
    };
    // XX2: column
    let [t44, t45] = {
        let t44 = c2 * t27;
        let t45 = s2 * dw2_x + t44;
        put(5, t45); // row 1, XX2
        [t44, t45]
    };
    // YY2: column
    let [t46, t49] = {
        let t46 = s2 * t28;
        let t48 = c2 * dw2_y - t46;
        let t49 = t45 + t48;
        let t51 = t49 * k3 - t42;
        put(1, t51); // row 1, M2
        put(6, t48); // row 1, YY2
        [t46, t49]
    };
    // XZ2: column
    {
        let t54 = s2 * t34 + c2 * t31;
        let t55 = k0 * t54;
        let t57 = k0 * t22 - t13;
        put(2, t55); // row 1, MSX2
        put(9, t54); // row 1, XZ2
        put(64, t57); // row 2, MSX2
    }
    // YZ2: column
    {
        let t61 = s2 * (t0 - t35) - c2 * t33;
        let t62 = k0 * t61;
        let t64 = t12 + k0 * t23;
        put(3, t62); // row 1, MSY2
        put(10, t61); // row 1, YZ2
        put(65, t64); // row 2, MSY2
    }
    // YY2: column
    {
        let t66 = t41 - t49 * k4;
        put(4, t66); // row 1, MSZ2
    }
    // ZZ2: column
    {
        let t67 = t46 - t44;
        put(7, t67); // row 1, ZZ2
    }
    // XY2: column
    {
        let t68 = t35 - t32;
        let t71 = s2 * t36 + c2 * t37;
        put(8, t71); // row 1, XY2
        put(69, t68); // row 2, XY2
    }
    // link 3: motion
    let [
        z1_3_x, z1_4_z, a3_z, t82, a3_y, w3_x, t91, t94,
        t97, w3_z, dw3_z, t102, t103, t104, t105, t106,
        t107, t108, t109, t110, t111, t112, t113,
    ] = {
        let z1_3_x = s2 * c3;
        let z1_4_z = s2 * s3;
        let t77 = t17 + t33 * k1;
        let a3_z = a2_y + t35 * k1;
        let t79 = t37 * k1 - a2_z;
        let t82 = c3 * t77 - s3 * t79;
        let a3_y = c3 * t79 + s3 * t77;
        let w3_x = c3 * w2_x - s3 * dq2;
        let t91 = c3 * dq2 + s3 * w2_x;
        let t94 = c3 * t33 - s3 * t37;
        let t97 = c3 * t37 + s3 * t33;
        let w3_z = w2_y + dq3;
        let dw3_z = dw2_y + ddq3;
        let t100 = w3_x * w3_x;
        let t101 = w3_z * w3_z;
        let t102 = w3_x * t91;
        let t103 = w3_x * w3_z;
        let t104 = t91 * w3_z;
        let t105 = t104 - t97;
        let t106 = t103 - t94;
        let t107 = t100 - t101;
        let t108 = t35 - t107;
        let t109 = dw3_z + t102;
        let t110 = dw3_z - t102;
        let t111 = t100 + t101;
        let t112 = t103 + t106;
        let t113 = t104 + t105;
        let t114 = -t102;
        put(125, a3_y); // row 3, MSX3
        put(126, t82); // row 3, MSY3
        put(127, t102); // row 3, XX3
        put(128, t114); // row 3, YY3
        put(129, dw3_z); // row 3, ZZ3
        put(131, t97); // row 3, XZ3
        put(132, t94); // row 3, YZ3
        [
        z1_3_x, z1_4_z, a3_z, t82, a3_y, w3_x, t91, t94,
        t97, w3_z, dw3_z, t102, t103, t104, t105, t106,
        t107, t108, t109, t110, t111, t112, t113,
    ]
    };
    // M3: column
    {
        let t119 = a3_z * v1_2_y - (t82 * v1_3_x - a3_y * v1_3_y);
        let t123 = -(t82 * v2_3_x + a3_y * v2_4_z);
        put(11, t119); // row 1, M3
        put(72, t123); // row 2, M3
    }
    // MSX3: column
    {
        let t131 = t112 * v1_2_y + (t110 * v1_3_y - t108 * v1_3_x);
        let t132 = z1_4_z * a3_z + c2 * a3_y + t131;
        let t137 = c3 * a3_z - (t108 * v2_3_x + t110 * v2_4_z);
        put(12, t132); // row 1, MSX3
        put(73, t137); // row 2, MSX3
    }
    // MSY3: column
    let [t142, t149] = {
        let t142 = t111 * v1_3_y;
        let t146 = z1_3_x * a3_z + c2 * t82 - (t113 * v1_2_y + (t109 * v1_3_x + t142));
        let t149 = t111 * v2_4_z;
        let t151 = t149 - t109 * v2_3_x - s3 * a3_z;
        put(13, t146); // row 1, MSY3
        put(74, t151); // row 2, MSY3
        [t142, t149]
    };
    // MSZ3: column
    {
        let t159 = t94 * v1_3_x - t97 * v1_3_y - t35 * v1_2_y;
        let t160 = z1_4_z * t82 - z1_3_x * a3_y + t159;
        let t167 = s3 * a3_y + c3 * t82 + (t94 * v2_3_x + t97 * v2_4_z);
        put(14, t160); // row 1, MSZ3
        put(75, t167); // row 2, MSZ3
    }
    // joint axes in frame 4
    let [
        z1_4_x, z1_4_y, v1_4_x, v1_4_y, t185, z2_4_y, t189, t192,
        t193, v3_4_y,
    ] = {
        let t170 = v1_3_x - c2 * k5;
        let t171 = v1_2_y + z1_3_x * k5;
        let z1_4_x = c4 * z1_3_x + c2 * s4;
        let z1_4_y = c2 * c4 - s4 * z1_3_x;
        let v1_4_x = c4 * t170 + s4 * t171;
        let v1_4_y = c4 * t171 - s4 * t170;
        let t184 = s3 * k5;
        let t185 = s3 * c4;
        let z2_4_y = s3 * s4;
        let t189 = s4 * t184 - c4 * v2_3_x;
        let t192 = c4 * t184 + s4 * v2_3_x;
        let t193 = c4 * k5;
        let v3_4_y = s4 * k5;
        [
        z1_4_x, z1_4_y, v1_4_x, v1_4_y, t185, z2_4_y, t189, t192,
        t193, v3_4_y,
    ]
    };
    // XX3: column
    let [t196, t197, t201] = {
        let t196 = z1_4_z * t103;
        let t197 = c2 * t102;
        let t199 = t197 - (z1_3_x * t105 + t196);
        let t201 = c3 * t103;
        let t202 = s3 * t105 - t201;
        put(15, t199); // row 1, XX3
        put(76, t202); // row 2, XX3
        [t196, t197, t201]
    };
    // YY3: column
    let [t203, t207] = {
        let t203 = z1_3_x * t104;
        let t206 = t203 + z1_4_z * t106 - t197;
        let t207 = s3 * t104;
        let t209 = c3 * t106 - t207;
        put(16, t206); // row 1, YY3
        put(77, t209); // row 2, YY3
        [t203, t207]
    };
    // ZZ3: column
    {
        let t212 = c2 * dw3_z + (t196 - t203);
        let t213 = t201 + t207;
        put(17, t212); // row 1, ZZ3
        put(78, t213); // row 2, ZZ3
    }
    // XY3: column
    {
        let t214 = t111 - t108;
        let t219 = c2 * t214 + (z1_4_z * t113 - z1_3_x * t112);
        let t222 = s3 * t112 + c3 * t113;
        put(18, t219); // row 1, XY3
        put(79, t222); // row 2, XY3
        put(130, t214); // row 3, XY3
    }
    // XZ3: column
    {
        let t227 = c2 * t97 + (z1_3_x * t110 + z1_4_z * t107);
        let t230 = c3 * t107 - s3 * t110;
        put(19, t227); // row 1, XZ3
        put(80, t230); // row 2, XZ3
    }
    // YZ3: column
    {
        let t231 = t111 - t35;
        let t236 = c2 * t94 - (z1_3_x * t231 + z1_4_z * t109);
        let t239 = s3 * t231 - c3 * t109;
        put(20, t236); // row 1, YZ3
        put(81, t239); // row 2, YZ3
    }
    // link 4: motion
    let [
        t244, t248, a4_y, w4_x, w4_y, t260, t263, w4_z,
        dw4_z, t268, t269, t270, dw4_x, dw4_y, t273, t274,
        t275, t276, t277, t278, t279,
    ] = {
        let t243 = t82 + t109 * k5;
        let t244 = t111 * k5 - a3_y;
        let t245 = a3_z - t113 * k5;
        let t248 = c4 * t243 - s4 * t245;
        let a4_y = c4 * t245 + s4 * t243;
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t260 = c4 * t109 + s4 * t113;
        let t263 = s4 * t109 - c4 * t113;
        let w4_z = t91 + dq4;
        let dw4_z = t106 + ddq4;
        let t266 = w4_x * w4_x;
        let t267 = w4_z * w4_z;
        let t268 = w4_x * w4_y;
        let t269 = w4_x * w4_z;
        let t270 = w4_y * w4_z;
        let dw4_x = t263 + t270;
        let dw4_y = t260 - t269;
        let t273 = t267 - t266;
        let t274 = t111 + t273;
        let t275 = t268 - dw4_z;
        let t276 = dw4_z + t268;
        let t277 = t266 + t267;
        let t278 = dw4_y - t269;
        let t279 = t270 + dw4_x;
        let t280 = -t268;
        put(176, a4_y); // row 4, MSX4
        put(177, t248); // row 4, MSY4
        put(178, t280); // row 4, XX4
        put(179, t268); // row 4, YY4
        put(180, dw4_z); // row 4, ZZ4
        put(182, t263); // row 4, XZ4
        put(183, t260); // row 4, YZ4
        [
        t244, t248, a4_y, w4_x, w4_y, t260, t263, w4_z,
        dw4_z, t268, t269, t270, dw4_x, dw4_y, t273, t274,
        t275, t276, t277, t278, t279,
    ]
    };
    // M4: column
    {
        let t285 = a4_y * v1_4_y - t248 * v1_4_x - t244 * v1_3_y;
        let t290 = t244 * v2_4_z - (a4_y * t192 - t248 * t189);
        let t293 = t248 * t193 + a4_y * v3_4_y;
        put(21, t285); // row 1, M4
        put(82, t290); // row 2, M4
        put(133, t293); // row 3, M4
    }
    // MSX4: column
    {
        let t301 = t278 * v1_3_y + (t276 * v1_4_y - t274 * v1_4_x);
        let t302 = z1_4_z * a4_y - t244 * z1_4_y + t301;
        let t310 = t278 * v2_4_z + (t276 * t192 - t274 * t189);
        let t311 = c3 * a4_y - t244 * z2_4_y - t310;
        let t316 = t274 * t193 + t276 * v3_4_y - c4 * t244;
        put(22, t302); // row 1, MSX4
        put(83, t311); // row 2, MSX4
        put(134, t316); // row 3, MSX4
    }
    // MSY4: column
    let [t321, t330, t337] = {
        let t321 = t277 * v1_4_y;
        let t325 = t244 * z1_4_x + z1_4_z * t248 - (t279 * v1_3_y + (t321 - t275 * v1_4_x));
        let t330 = t277 * t192;
        let t334 = t279 * v2_4_z - (t275 * t189 - t330) - (t244 * t185 - c3 * t248);
        let t337 = t277 * v3_4_y;
        let t339 = s4 * t244 - (t275 * t193 + t337);
        put(23, t325); // row 1, MSY4
        put(84, t334); // row 2, MSY4
        put(135, t339); // row 3, MSY4
        [t321, t330, t337]
    };
    // MSZ4: column
    {
        let t347 = t142 - (t263 * v1_4_y - t260 * v1_4_x) - (a4_y * z1_4_x + t248 * z1_4_y);
        let t355 = a4_y * t185 - t248 * z2_4_y + (t263 * t192 - t260 * t189 - t149);
        let t363 = -(s4 * a4_y + c4 * t248 + (t260 * t193 + t263 * v3_4_y));
        put(24, t347); // row 1, MSZ4
        put(85, t355); // row 2, MSZ4
        put(136, t363); // row 3, MSZ4
    }
    // XX4: column
    let [t365, t366, t370, t371, t375] = {
        let t365 = t269 * z1_4_y;
        let t366 = z1_4_z * t268;
        let t368 = dw4_x * z1_4_x + t365 - t366;
        let t370 = t269 * z2_4_y;
        let t371 = c3 * t268;
        let t373 = t370 - dw4_x * t185 - t371;
        let t375 = c4 * t269;
        let t376 = s4 * dw4_x + t375;
        put(25, t368); // row 1, XX4
        put(86, t373); // row 2, XX4
        put(137, t376); // row 3, XX4
        [t365, t366, t370, t371, t375]
    };
    // YY4: column
    let [t377, t381, t385] = {
        let t377 = t270 * z1_4_x;
        let t380 = t366 - (t377 - dw4_y * z1_4_y);
        let t381 = t270 * t185;
        let t384 = t371 + (t381 + dw4_y * z2_4_y);
        let t385 = s4 * t270;
        let t387 = c4 * dw4_y - t385;
        put(26, t380); // row 1, YY4
        put(87, t384); // row 2, YY4
        put(138, t387); // row 3, YY4
        [t377, t381, t385]
    };
    // ZZ4: column
    {
        let t390 = z1_4_z * dw4_z + (t377 - t365);
        let t393 = c3 * dw4_z - (t370 + t381);
        let t394 = t385 - t375;
        put(27, t390); // row 1, ZZ4
        put(88, t393); // row 2, ZZ4
        put(139, t394); // row 3, ZZ4
    }
    // XY4: column
    {
        let t395 = t277 - t274;
        let t400 = z1_4_z * t395 + (t278 * z1_4_x + t279 * z1_4_y);
        let t405 = c3 * t395 - (t278 * t185 - t279 * z2_4_y);
        let t408 = s4 * t278 + c4 * t279;
        put(28, t400); // row 1, XY4
        put(89, t405); // row 2, XY4
        put(140, t408); // row 3, XY4
        put(181, t395); // row 4, XY4
    }
    // XZ4: column
    {
        let t413 = z1_4_z * t263 + (t276 * z1_4_x + t273 * z1_4_y);
        let t418 = c3 * t263 - (t276 * t185 - t273 * z2_4_y);
        let t421 = s4 * t276 + c4 * t273;
        put(29, t413); // row 1, XZ4
        put(90, t418); // row 2, XZ4
        put(141, t421); // row 3, XZ4
    }
    // YZ4: column
    {
        let t422 = t111 - t277;
        let t427 = z1_4_z * t260 + (z1_4_x * t422 - t275 * z1_4_y);
        let t432 = c3 * t260 - (t185 * t422 + t275 * z2_4_y);
        let t435 = s4 * t422 - c4 * t275;
        put(30, t427); // row 1, YZ4
        put(91, t432); // row 2, YZ4
        put(142, t435); // row 3, YZ4
    }
    // joint axes in frame 5
    let [
        z1_5_x, z1_6_z, v1_5_x, t451, t458, t461, t464, t467,
        z3_5_x, z3_6_z, v3_5_x, v3_5_y, v4_5_x, v4_6_z,
    ] = {
        let t438 = v1_4_x + z1_4_z * k6;
        let t439 = v1_3_y + k6 * z1_4_x;
        let z1_5_x = c5 * z1_4_x - s5 * z1_4_z;
        let z1_6_z = c5 * z1_4_z + s5 * z1_4_x;
        let v1_5_x = c5 * t438 + s5 * t439;
        let t451 = s5 * t438 - c5 * t439;
        let t454 = t189 - c3 * k6;
        let t455 = v2_4_z + k6 * t185;
        let t458 = c5 * t185 + c3 * s5;
        let t461 = c3 * c5 - s5 * t185;
        let t464 = c5 * t454 + s5 * t455;
        let t467 = s5 * t454 - c5 * t455;
        let t468 = s4 * k6;
        let z3_5_x = s4 * c5;
        let z3_6_z = s4 * s5;
        let v3_5_x = s5 * t468 - c5 * t193;
        let v3_5_y = c5 * t468 + s5 * t193;
        let v4_5_x = c5 * k6;
        let v4_6_z = s5 * k6;
        [
        z1_5_x, z1_6_z, v1_5_x, t451, t458, t461, t464, t467,
        z3_5_x, z3_6_z, v3_5_x, v3_5_y, v4_5_x, v4_6_z,
    ]
    };
    // link 5: motion
    let [
        a5_z, t487, a5_y, w5_x, t496, t499, t502, w5_z,
        dw5_z, t507, t508, t509, t510, t511, t512, t513,
        t514, t515, t516, t517, t518,
    ] = {
        let t482 = t248 + t275 * k6;
        let a5_z = a4_y + t277 * k6;
        let t484 = t279 * k6 - t244;
        let t487 = c5 * t482 - s5 * t484;
        let a5_y = c5 * t484 + s5 * t482;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t496 = c5 * w4_z + s5 * w4_x;
        let t499 = c5 * t275 - s5 * t279;
        let t502 = c5 * t279 + s5 * t275;
        let w5_z = w4_y + dq5;
        let dw5_z = dw4_y + ddq5;
        let t505 = w5_x * w5_x;
        let t506 = w5_z * w5_z;
        let t507 = w5_x * t496;
        let t508 = w5_x * w5_z;
        let t509 = t496 * w5_z;
        let t510 = t509 - t502;
        let t511 = t508 - t499;
        let t512 = t505 - t506;
        let t513 = t512 - t277;
        let t514 = dw5_z + t507;
        let t515 = t507 - dw5_z;
        let t516 = t505 + t506;
        let t517 = t508 + t511;
        let t518 = t509 + t510;
        let t519 = -t507;
        put(217, a5_y); // row 5, MSX5
        put(218, t487); // row 5, MSY5
        put(219, t507); // row 5, XX5
        put(220, t519); // row 5, YY5
        put(221, dw5_z); // row 5, ZZ5
        put(223, t502); // row 5, XZ5
        put(224, t499); // row 5, YZ5
        [
        a5_z, t487, a5_y, w5_x, t496, t499, t502, w5_z,
        dw5_z, t507, t508, t509, t510, t511, t512, t513,
        t514, t515, t516, t517, t518,
    ]
    };
    // M5: column
    {
        let t524 = a5_z * v1_4_y - (t487 * v1_5_x + a5_y * t451);
        let t529 = t487 * t464 + a5_y * t467 - a5_z * t192;
        let t534 = a5_z * v3_4_y + (a5_y * v3_5_y - t487 * v3_5_x);
        let t538 = -(t487 * v4_5_x + a5_y * v4_6_z);
        put(31, t524); // row 1, M5
        put(92, t529); // row 2, M5
        put(143, t534); // row 3, M5
        put(184, t538); // row 4, M5
    }
    // MSX5: column
    {
        let t546 = t517 * v1_4_y + (t513 * v1_5_x + t515 * t451);
        let t547 = a5_z * z1_6_z + a5_y * z1_4_y + t546;
        let t555 = t517 * t192 + (t513 * t464 + t515 * t467);
        let t556 = a5_z * t461 + a5_y * z2_4_y - t555;
        let t564 = t517 * v3_4_y - (t515 * v3_5_y - t513 * v3_5_x);
        let t565 = a5_z * z3_6_z + c4 * a5_y + t564;
        let t570 = c5 * a5_z + (t513 * v4_5_x + t515 * v4_6_z);
        put(32, t547); // row 1, MSX5
        put(93, t556); // row 2, MSX5
        put(144, t565); // row 3, MSX5
        put(185, t570); // row 4, MSX5
    }
    // MSY5: column
    let [t575, t584, t593, t600] = {
        let t575 = t516 * t451;
        let t579 = a5_z * z1_5_x + t487 * z1_4_y - (t518 * v1_4_y - (t575 - t514 * v1_5_x));
        let t584 = t516 * t467;
        let t588 = t487 * z2_4_y - a5_z * t458 - (t584 - t514 * t464 - t518 * t192);
        let t593 = t516 * v3_5_y;
        let t597 = a5_z * z3_5_x + c4 * t487 - (t518 * v3_4_y + (t514 * v3_5_x + t593));
        let t600 = t516 * v4_6_z;
        let t602 = t600 - t514 * v4_5_x - s5 * a5_z;
        put(33, t579); // row 1, MSY5
        put(94, t588); // row 2, MSY5
        put(145, t597); // row 3, MSY5
        put(186, t602); // row 4, MSY5
        [t575, t584, t593, t600]
    };
    // MSZ5: column
    {
        let t610 = t487 * z1_6_z - a5_y * z1_5_x - (t321 - (t499 * v1_5_x + t502 * t451));
        let t618 = a5_y * t458 + t487 * t461 + (t330 - (t499 * t464 + t502 * t467));
        let t626 = t487 * z3_6_z - a5_y * z3_5_x + (t499 * v3_5_x - t502 * v3_5_y - t337);
        let t633 = s5 * a5_y + c5 * t487 + (t499 * v4_5_x + t502 * v4_6_z);
        put(34, t610); // row 1, MSZ5
        put(95, t618); // row 2, MSZ5
        put(146, t626); // row 3, MSZ5
        put(187, t633); // row 4, MSZ5
    }
    // XX5: column
    let [t635, t636, t640, t641, t645, t646, t650] = {
        let t635 = t508 * z1_6_z;
        let t636 = t507 * z1_4_y;
        let t638 = t636 - (t510 * z1_5_x + t635);
        let t640 = t508 * t461;
        let t641 = t507 * z2_4_y;
        let t643 = t641 + (t510 * t458 - t640);
        let t645 = t508 * z3_6_z;
        let t646 = c4 * t507;
        let t648 = t646 - (t510 * z3_5_x + t645);
        let t650 = c5 * t508;
        let t651 = s5 * t510 - t650;
        put(35, t638); // row 1, XX5
        put(96, t643); // row 2, XX5
        put(147, t648); // row 3, XX5
        put(188, t651); // row 4, XX5
        [t635, t636, t640, t641, t645, t646, t650]
    };
    // YY5: column
    let [t652, t656, t660, t664] = {
        let t652 = t509 * z1_5_x;
        let t655 = t652 + t511 * z1_6_z - t636;
        let t656 = t509 * t458;
        let t659 = t511 * t461 - t656 - t641;
        let t660 = t509 * z3_5_x;
        let t663 = t660 + t511 * z3_6_z - t646;
        let t664 = s5 * t509;
        let t666 = c5 * t511 - t664;
        put(36, t655); // row 1, YY5
        put(97, t659); // row 2, YY5
        put(148, t663); // row 3, YY5
        put(189, t666); // row 4, YY5
        [t652, t656, t660, t664]
    };
    // ZZ5: column
    {
        let t669 = dw5_z * z1_4_y - (t652 - t635);
        let t672 = dw5_z * z2_4_y + (t640 + t656);
        let t675 = c4 * dw5_z + (t645 - t660);
        let t676 = t650 + t664;
        put(37, t669); // row 1, ZZ5
        put(98, t672); // row 2, ZZ5
        put(149, t675); // row 3, ZZ5
        put(190, t676); // row 4, ZZ5
    }
    // XY5: column
    {
        let t677 = t513 + t516;
        let t682 = z1_4_y * t677 + (t518 * z1_6_z - t517 * z1_5_x);
        let t687 = z2_4_y * t677 + (t517 * t458 + t518 * t461);
        let t692 = c4 * t677 - (t517 * z3_5_x - t518 * z3_6_z);
        let t695 = s5 * t517 + c5 * t518;
        put(38, t682); // row 1, XY5
        put(99, t687); // row 2, XY5
        put(150, t692); // row 3, XY5
        put(191, t695); // row 4, XY5
        put(222, t677); // row 5, XY5
    }
    // XZ5: column
    {
        let t700 = t502 * z1_4_y + (t512 * z1_6_z - t515 * z1_5_x);
        let t705 = t502 * z2_4_y + (t515 * t458 + t512 * t461);
        let t710 = c4 * t502 + (t512 * z3_6_z - t515 * z3_5_x);
        let t713 = s5 * t515 + c5 * t512;
        put(39, t700); // row 1, XZ5
        put(100, t705); // row 2, XZ5
        put(151, t710); // row 3, XZ5
        put(192, t713); // row 4, XZ5
    }
    // YZ5: column
    {
        let t714 = t516 - t277;
        let t719 = t499 * z1_4_y - (z1_5_x * t714 + t514 * z1_6_z);
        let t724 = t499 * z2_4_y + (t458 * t714 - t514 * t461);
        let t729 = c4 * t499 - (z3_5_x * t714 + t514 * z3_6_z);
        let t732 = s5 * t714 - c5 * t514;
        put(40, t719); // row 1, YZ5
        put(101, t724); // row 2, YZ5
        put(152, t729); // row 3, YZ5
        put(193, t732); // row 4, YZ5
    }
    // joint axes in frame 6
    let [
        z1_6_x, z1_6_y, v1_6_x, v1_6_y, z2_6_x, z2_6_y, t761, t764,
        z3_6_x, z3_6_y, t777, v3_6_y, t782, z4_6_y, t786, t789,
        t790, v5_6_y,
    ] = {
        let t735 = v1_5_x - k7 * z1_4_y;
        let t736 = v1_4_y + k7 * z1_5_x;
        let z1_6_x = c6 * z1_5_x + s6 * z1_4_y;
        let z1_6_y = c6 * z1_4_y - s6 * z1_5_x;
        let v1_6_x = c6 * t735 + s6 * t736;
        let v1_6_y = c6 * t736 - s6 * t735;
        let t751 = t464 + k7 * z2_4_y;
        let t752 = t192 + k7 * t458;
        let z2_6_x = s6 * z2_4_y - c6 * t458;
        let z2_6_y = c6 * z2_4_y + s6 * t458;
        let t761 = c6 * t751 + s6 * t752;
        let t764 = c6 * t752 - s6 * t751;
        let t767 = c4 * k7 - v3_5_x;
        let t768 = v3_4_y + k7 * z3_5_x;
        let z3_6_x = c6 * z3_5_x + c4 * s6;
        let z3_6_y = c4 * c6 - s6 * z3_5_x;
        let t777 = c6 * t767 - s6 * t768;
        let v3_6_y = c6 * t768 + s6 * t767;
        let t781 = s5 * k7;
        let t782 = s5 * c6;
        let z4_6_y = s5 * s6;
        let t786 = s6 * t781 - c6 * v4_5_x;
        let t789 = c6 * t781 + s6 * v4_5_x;
        let t790 = c6 * k7;
        let v5_6_y = s6 * k7;
        [
        z1_6_x, z1_6_y, v1_6_x, v1_6_y, z2_6_x, z2_6_y, t761, t764,
        z3_6_x, z3_6_y, t777, v3_6_y, t782, z4_6_y, t786, t789,
        t790, v5_6_y,
    ]
    };
    // link 6: motion
    let [
        t796, t800, a6_y, w6_x, w6_y, t812, t815, w6_z,
        dw6_z, t820, t821, t822, dw6_x, dw6_y, t825, t826,
        t827, t828, t829, t830, t831,
    ] = {
        let t795 = t487 + t514 * k7;
        let t796 = t516 * k7 - a5_y;
        let t797 = t518 * k7 - a5_z;
        let t800 = c6 * t795 + s6 * t797;
        let a6_y = s6 * t795 - c6 * t797;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t812 = c6 * t514 + s6 * t518;
        let t815 = s6 * t514 - c6 * t518;
        let w6_z = t496 + dq6;
        let dw6_z = t511 + ddq6;
        let t818 = w6_x * w6_x;
        let t819 = w6_z * w6_z;
        let t820 = w6_x * w6_y;
        let t821 = w6_x * w6_z;
        let t822 = w6_y * w6_z;
        let dw6_x = t815 + t822;
        let dw6_y = t812 - t821;
        let t825 = t818 - t819;
        let t826 = t825 - t516;
        let t827 = t820 - dw6_z;
        let t828 = dw6_z + t820;
        let t829 = t818 + t819;
        let t830 = dw6_y - t821;
        let t831 = t822 + dw6_x;
        let t832 = -t820;
        put(248, a6_y); // row 6, MSX6
        put(249, t800); // row 6, MSY6
        put(250, t832); // row 6, XX6
        put(251, t820); // row 6, YY6
        put(252, dw6_z); // row 6, ZZ6
        put(254, t815); // row 6, XZ6
        put(255, t812); // row 6, YZ6
        [
        t796, t800, a6_y, w6_x, w6_y, t812, t815, w6_z,
        dw6_z, t820, t821, t822, dw6_x, dw6_y, t825, t826,
        t827, t828, t829, t830, t831,
    ]
    };
    // M6: column
    {
        let t837 = t796 * t451 + (a6_y * v1_6_y - t800 * v1_6_x);
        let t842 = t800 * t761 - a6_y * t764 - t796 * t467;
        let t847 = t800 * t777 + a6_y * v3_6_y - t796 * v3_5_y;
        let t852 = t796 * v4_6_z + (t800 * t786 - a6_y * t789);
        let t855 = t800 * t790 + a6_y * v5_6_y;
        put(41, t837); // row 1, M6
        put(102, t842); // row 2, M6
        put(153, t847); // row 3, M6
        put(194, t852); // row 4, M6
        put(225, t855); // row 5, M6
    }
    // MSX6: column
    {
        let t863 = t826 * v1_6_x + t828 * v1_6_y - t830 * t451;
        let t864 = a6_y * z1_6_z - t796 * z1_6_y + t863;
        let t867 = t796 * z2_6_y - a6_y * t461;
        let t873 = t830 * t467 - (t826 * t761 + t828 * t764) - t867;
        let t881 = t826 * t777 - t828 * v3_6_y - t830 * v3_5_y;
        let t882 = a6_y * z3_6_z - t796 * z3_6_y - t881;
        let t890 = t830 * v4_6_z + (t826 * t786 + t828 * t789);
        let t891 = c5 * a6_y - t796 * z4_6_y - t890;
        let t896 = t828 * v5_6_y - t826 * t790 - c6 * t796;
        put(42, t864); // row 1, MSX6
        put(103, t873); // row 2, MSX6
        put(154, t882); // row 3, MSX6
        put(195, t891); // row 4, MSX6
        put(226, t896); // row 5, MSX6
    }
    // MSY6: column
    let [t901, t910, t919, t928, t935] = {
        let t901 = t829 * v1_6_y;
        let t905 = t796 * z1_6_x + t800 * z1_6_z + (t831 * t451 - (t901 - t827 * v1_6_x));
        let t910 = t829 * t764;
        let t914 = t796 * z2_6_x + t800 * t461 - (t831 * t467 - (t910 - t827 * t761));
        let t919 = t829 * v3_6_y;
        let t923 = t796 * z3_6_x + t800 * z3_6_z - (t831 * v3_5_y + (t827 * t777 + t919));
        let t928 = t829 * t789;
        let t932 = c5 * t800 - t796 * t782 + (t831 * v4_6_z + (t928 - t827 * t786));
        let t935 = t829 * v5_6_y;
        let t937 = s6 * t796 - (t827 * t790 + t935);
        put(43, t905); // row 1, MSY6
        put(104, t914); // row 2, MSY6
        put(155, t923); // row 3, MSY6
        put(196, t932); // row 4, MSY6
        put(227, t937); // row 5, MSY6
        [t901, t910, t919, t928, t935]
    };
    // MSZ6: column
    {
        let t945 = t812 * v1_6_x - t815 * v1_6_y - t575 - (a6_y * z1_6_x + t800 * z1_6_y);
        let t953 = t584 - (t812 * t761 - t815 * t764) - (a6_y * z2_6_x + t800 * z2_6_y);
        let t961 = t593 - (t812 * t777 + t815 * v3_6_y) - (a6_y * z3_6_x + t800 * z3_6_y);
        let t969 = a6_y * t782 - t800 * z4_6_y - (t600 + (t812 * t786 - t815 * t789));
        let t977 = -(s6 * a6_y + c6 * t800 + (t812 * t790 + t815 * v5_6_y));
        put(44, t945); // row 1, MSZ6
        put(105, t953); // row 2, MSZ6
        put(156, t961); // row 3, MSZ6
        put(197, t969); // row 4, MSZ6
        put(228, t977); // row 5, MSZ6
    }
    // XX6: column
    let [
        t979, t980, t984, t985, t989, t990, t994, t995,
        t999,
    ] = {
        let t979 = t821 * z1_6_y;
        let t980 = t820 * z1_6_z;
        let t982 = dw6_x * z1_6_x + t979 - t980;
        let t984 = t821 * z2_6_y;
        let t985 = t820 * t461;
        let t987 = dw6_x * z2_6_x + t984 - t985;
        let t989 = t821 * z3_6_y;
        let t990 = t820 * z3_6_z;
        let t992 = dw6_x * z3_6_x + t989 - t990;
        let t994 = t821 * z4_6_y;
        let t995 = c5 * t820;
        let t997 = t994 - dw6_x * t782 - t995;
        let t999 = c6 * t821;
        let t1000 = s6 * dw6_x + t999;
        put(45, t982); // row 1, XX6
        put(106, t987); // row 2, XX6
        put(157, t992); // row 3, XX6
        put(198, t997); // row 4, XX6
        put(229, t1000); // row 5, XX6
        [
        t979, t980, t984, t985, t989, t990, t994, t995,
        t999,
    ]
    };
    // YY6: column
    let [t1001, t1005, t1009, t1013, t1017] = {
        let t1001 = t822 * z1_6_x;
        let t1004 = t980 + (dw6_y * z1_6_y - t1001);
        let t1005 = t822 * z2_6_x;
        let t1008 = t985 + (dw6_y * z2_6_y - t1005);
        let t1009 = t822 * z3_6_x;
        let t1012 = t990 + (dw6_y * z3_6_y - t1009);
        let t1013 = t822 * t782;
        let t1016 = t995 + (t1013 + dw6_y * z4_6_y);
        let t1017 = s6 * t822;
        let t1019 = c6 * dw6_y - t1017;
        put(46, t1004); // row 1, YY6
        put(107, t1008); // row 2, YY6
        put(158, t1012); // row 3, YY6
        put(199, t1016); // row 4, YY6
        put(230, t1019); // row 5, YY6
        [t1001, t1005, t1009, t1013, t1017]
    };
    // ZZ6: column
    {
        let t1022 = dw6_z * z1_6_z - (t979 - t1001);
        let t1025 = dw6_z * t461 + (t1005 - t984);
        let t1028 = dw6_z * z3_6_z + (t1009 - t989);
        let t1031 = c5 * dw6_z - (t994 + t1013);
        let t1032 = t1017 - t999;
        put(47, t1022); // row 1, ZZ6
        put(108, t1025); // row 2, ZZ6
        put(159, t1028); // row 3, ZZ6
        put(200, t1031); // row 4, ZZ6
        put(231, t1032); // row 5, ZZ6
    }
    // XY6: column
    {
        let t1033 = t826 + t829;
        let t1038 = z1_6_z * t1033 + (t830 * z1_6_x + t831 * z1_6_y);
        let t1043 = t461 * t1033 + (t830 * z2_6_x + t831 * z2_6_y);
        let t1048 = z3_6_z * t1033 + (t830 * z3_6_x + t831 * z3_6_y);
        let t1053 = c5 * t1033 + (t831 * z4_6_y - t830 * t782);
        let t1056 = s6 * t830 + c6 * t831;
        put(48, t1038); // row 1, XY6
        put(109, t1043); // row 2, XY6
        put(160, t1048); // row 3, XY6
        put(201, t1053); // row 4, XY6
        put(232, t1056); // row 5, XY6
        put(253, t1033); // row 6, XY6
    }
    // XZ6: column
    {
        let t1061 = t815 * z1_6_z - (t825 * z1_6_y - t828 * z1_6_x);
        let t1066 = t815 * t461 + (t828 * z2_6_x - t825 * z2_6_y);
        let t1071 = t815 * z3_6_z + (t828 * z3_6_x - t825 * z3_6_y);
        let t1076 = c5 * t815 - (t828 * t782 + t825 * z4_6_y);
        let t1079 = s6 * t828 - c6 * t825;
        put(49, t1061); // row 1, XZ6
        put(110, t1066); // row 2, XZ6
        put(161, t1071); // row 3, XZ6
        put(202, t1076); // row 4, XZ6
        put(233, t1079); // row 5, XZ6
    }
    // YZ6: column
    {
        let t1080 = t516 - t829;
        let t1085 = t812 * z1_6_z + (z1_6_x * t1080 - t827 * z1_6_y);
        let t1090 = t812 * t461 - (t827 * z2_6_y - z2_6_x * t1080);
        let t1095 = t812 * z3_6_z + (z3_6_x * t1080 - t827 * z3_6_y);
        let t1100 = c5 * t812 - (t782 * t1080 + t827 * z4_6_y);
        let t1103 = s6 * t1080 - c6 * t827;
        put(50, t1085); // row 1, YZ6
        put(111, t1090); // row 2, YZ6
        put(162, t1095); // row 3, YZ6
        put(203, t1100); // row 4, YZ6
        put(234, t1103); // row 5, YZ6
    }
    // joint axes in frame 7
    let [
        t1106, t1107, t1110, t1113, t1116, t1117, z2_7_x, t1123,
        t1126, t1127, t1130, t1133, t1136, t1137, t1140, t1143,
        t1144, z5_7_x, t1146,
    ] = {
        let t1106 = v1_6_x + k8 * z1_6_z;
        let t1107 = t451 - k8 * z1_6_x;
        let t1110 = s7 * z1_6_z - c7 * z1_6_x;
        let t1113 = c7 * z1_6_z + s7 * z1_6_x;
        let t1116 = t761 - k8 * t461;
        let t1117 = t467 + k8 * z2_6_x;
        let z2_7_x = c7 * z2_6_x - s7 * t461;
        let t1123 = c7 * t461 + s7 * z2_6_x;
        let t1126 = t777 - k8 * z3_6_z;
        let t1127 = v3_5_y + k8 * z3_6_x;
        let t1130 = s7 * z3_6_z - c7 * z3_6_x;
        let t1133 = c7 * z3_6_z + s7 * z3_6_x;
        let t1136 = t786 - c5 * k8;
        let t1137 = v4_6_z + k8 * t782;
        let t1140 = c7 * t782 + c5 * s7;
        let t1143 = c5 * c7 - s7 * t782;
        let t1144 = s6 * k8;
        let z5_7_x = s6 * c7;
        let t1146 = s6 * s7;
        [
        t1106, t1107, t1110, t1113, t1116, t1117, z2_7_x, t1123,
        t1126, t1127, t1130, t1133, t1136, t1137, t1140, t1143,
        t1144, z5_7_x, t1146,
    ]
    };
    // link 7: motion
    let [
        a7_z, t1155, a7_y, t1167, t1170, dw7_z, t1175, t1176,
        t1177, t1178, t1179, t1180, t1181, t1182, t1183, t1184,
        t1185, t1186,
    ] = {
        let t1150 = t800 + t827 * k8;
        let a7_z = a6_y + t829 * k8;
        let t1152 = t796 - t831 * k8;
        let t1155 = c7 * t1150 + s7 * t1152;
        let a7_y = s7 * t1150 - c7 * t1152;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t1164 = c7 * w6_z + s7 * w6_x;
        let t1167 = c7 * t827 - s7 * t831;
        let t1170 = c7 * t831 + s7 * t827;
        let w7_z = w6_y + dq7;
        let dw7_z = dw6_y + ddq7;
        let t1173 = w7_x * w7_x;
        let t1174 = w7_z * w7_z;
        let t1175 = w7_x * t1164;
        let t1176 = w7_x * w7_z;
        let t1177 = t1164 * w7_z;
        let t1178 = t1177 - t1170;
        let t1179 = t1176 - t1167;
        let t1180 = t1173 - t1174;
        let t1181 = t829 - t1180;
        let t1182 = dw7_z + t1175;
        let t1183 = t1175 - dw7_z;
        let t1184 = t1173 + t1174;
        let t1185 = t1176 + t1179;
        let t1186 = t1177 + t1178;
        let t1187 = -t1175;
        put(269, a7_y); // row 7, MSX7
        put(270, t1155); // row 7, MSY7
        put(271, t1175); // row 7, XX7
        put(272, t1187); // row 7, YY7
        put(273, dw7_z); // row 7, ZZ7
        put(275, t1170); // row 7, XZ7
        put(276, t1167); // row 7, YZ7
        [
        a7_z, t1155, a7_y, t1167, t1170, dw7_z, t1175, t1176,
        t1177, t1178, t1179, t1180, t1181, t1182, t1183, t1184,
        t1185, t1186,
    ]
    };
    // M7: column
    let t1190 = {
        let t1190 = c7 * t1155 + s7 * a7_y;
        let t1193 = c7 * a7_y - s7 * t1155;
        let t1198 = a7_z * v1_6_y - t1106 * t1190 - t1107 * t1193;
        let t1203 = t1117 * t1193 - (a7_z * t764 - t1116 * t1190);
        let t1208 = t1127 * t1193 + (t1126 * t1190 + a7_z * v3_6_y);
        let t1213 = t1136 * t1190 - a7_z * t789 - t1137 * t1193;
        let t1218 = t1144 * t1193 + (t790 * t1190 + a7_z * v5_6_y);
        let t1220 = -(k8 * t1190);
        put(51, t1198); // row 1, M7
        put(112, t1203); // row 2, M7
        put(163, t1208); // row 3, M7
        put(204, t1213); // row 4, M7
        put(235, t1218); // row 5, M7
        put(256, t1220); // row 6, M7
        t1190
    };
    // MSX7: column
    let t1222 = {
        let t1222 = s7 * t1183;
        let t1223 = c7 * t1181 - t1222;
        let t1226 = s7 * t1181 + c7 * t1183;
        let t1234 = a7_z * t1113 + a7_y * z1_6_y;
        let t1235 = t1107 * t1226 - (t1106 * t1223 - t1185 * v1_6_y) + t1234;
        let t1243 = a7_z * t1123 + a7_y * z2_6_y;
        let t1244 = t1116 * t1223 - t1185 * t764 - t1117 * t1226 + t1243;
        let t1252 = a7_z * t1133 + a7_y * z3_6_y;
        let t1253 = t1126 * t1223 + t1185 * v3_6_y - t1127 * t1226 + t1252;
        let t1261 = a7_z * t1143 + a7_y * z4_6_y;
        let t1262 = t1137 * t1226 + (t1136 * t1223 - t1185 * t789) + t1261;
        let t1270 = a7_z * t1146 + c6 * a7_y;
        let t1271 = t790 * t1223 + t1185 * v5_6_y - t1144 * t1226 + t1270;
        let t1274 = c7 * a7_z - k8 * t1223;
        put(52, t1235); // row 1, MSX7
        put(113, t1244); // row 2, MSX7
        put(164, t1253); // row 3, MSX7
        put(205, t1262); // row 4, MSX7
        put(236, t1271); // row 5, MSX7
        put(257, t1274); // row 6, MSX7
        t1222
    };
    // MSY7: column
    let t1275 = {
        let t1275 = c7 * t1182;
        let t1277 = s7 * t1184 - t1275;
        let t1280 = s7 * t1182 + c7 * t1184;
        let t1288 = t1155 * z1_6_y - a7_z * t1110;
        let t1289 = t1107 * t1280 + (t1106 * t1277 - t1186 * v1_6_y) + t1288;
        let t1294 = t1117 * t1280 - (t1186 * t764 - t1116 * t1277);
        let t1298 = a7_z * z2_7_x + t1155 * z2_6_y - t1294;
        let t1303 = t1127 * t1280 + (t1126 * t1277 + t1186 * v3_6_y);
        let t1307 = t1155 * z3_6_y - a7_z * t1130 - t1303;
        let t1315 = a7_z * t1140 - t1155 * z4_6_y;
        let t1316 = t1137 * t1280 - (t1136 * t1277 - t1186 * t789) - t1315;
        let t1321 = t1144 * t1280 + (t790 * t1277 + t1186 * v5_6_y);
        let t1325 = a7_z * z5_7_x + c6 * t1155 - t1321;
        let t1328 = k8 * t1277 - s7 * a7_z;
        put(53, t1289); // row 1, MSY7
        put(114, t1298); // row 2, MSY7
        put(165, t1307); // row 3, MSY7
        put(206, t1316); // row 4, MSY7
        put(237, t1325); // row 5, MSY7
        put(258, t1328); // row 6, MSY7
        t1275
    };
    // MSZ7: column
    {
        let t1331 = c7 * t1167 + s7 * t1170;
        let t1334 = s7 * t1167 - c7 * t1170;
        let t1342 = t1106 * t1331 - t901 - t1107 * t1334 + (a7_y * t1110 + t1155 * t1113);
        let t1350 = t1155 * t1123 - a7_y * z2_7_x - (t1116 * t1331 - t910 - t1117 * t1334);
        let t1358 = a7_y * t1130 + t1155 * t1133 - (t919 + t1126 * t1331 - t1127 * t1334);
        let t1366 = a7_y * t1140 + t1155 * t1143 - (t1137 * t1334 + (t1136 * t1331 - t928));
        let t1374 = t1155 * t1146 - a7_y * z5_7_x - (t935 + t790 * t1331 - t1144 * t1334);
        let t1376 = t1190 + k8 * t1331;
        put(54, t1342); // row 1, MSZ7
        put(115, t1350); // row 2, MSZ7
        put(166, t1358); // row 3, MSZ7
        put(207, t1366); // row 4, MSZ7
        put(238, t1374); // row 5, MSZ7
        put(259, t1376); // row 6, MSZ7
    }
    // XX7: column
    let [
        t1378, t1379, t1383, t1384, t1388, t1389, t1393, t1394,
        t1398, t1399, t1403,
    ] = {
        let t1378 = t1176 * t1113;
        let t1379 = t1175 * z1_6_y;
        let t1381 = t1379 - (t1378 - t1178 * t1110);
        let t1383 = t1176 * t1123;
        let t1384 = t1175 * z2_6_y;
        let t1386 = t1384 - (t1178 * z2_7_x + t1383);
        let t1388 = t1176 * t1133;
        let t1389 = t1175 * z3_6_y;
        let t1391 = t1389 + (t1178 * t1130 - t1388);
        let t1393 = t1176 * t1143;
        let t1394 = t1175 * z4_6_y;
        let t1396 = t1394 + (t1178 * t1140 - t1393);
        let t1398 = t1176 * t1146;
        let t1399 = c6 * t1175;
        let t1401 = t1399 - (t1178 * z5_7_x + t1398);
        let t1403 = c7 * t1176;
        let t1404 = s7 * t1178 - t1403;
        put(55, t1381); // row 1, XX7
        put(116, t1386); // row 2, XX7
        put(167, t1391); // row 3, XX7
        put(208, t1396); // row 4, XX7
        put(239, t1401); // row 5, XX7
        put(260, t1404); // row 6, XX7
        [
        t1378, t1379, t1383, t1384, t1388, t1389, t1393, t1394,
        t1398, t1399, t1403,
    ]
    };
    // YY7: column
    let [t1405, t1409, t1413, t1417, t1421, t1425] = {
        let t1405 = t1177 * t1110;
        let t1408 = t1179 * t1113 - t1405 - t1379;
        let t1409 = t1177 * z2_7_x;
        let t1412 = t1409 + t1179 * t1123 - t1384;
        let t1413 = t1177 * t1130;
        let t1416 = t1179 * t1133 - t1413 - t1389;
        let t1417 = t1177 * t1140;
        let t1420 = t1179 * t1143 - t1417 - t1394;
        let t1421 = t1177 * z5_7_x;
        let t1424 = t1421 + t1179 * t1146 - t1399;
        let t1425 = s7 * t1177;
        let t1427 = c7 * t1179 - t1425;
        put(56, t1408); // row 1, YY7
        put(117, t1412); // row 2, YY7
        put(168, t1416); // row 3, YY7
        put(209, t1420); // row 4, YY7
        put(240, t1424); // row 5, YY7
        put(261, t1427); // row 6, YY7
        [t1405, t1409, t1413, t1417, t1421, t1425]
    };
    // ZZ7: column
    {
        let t1430 = dw7_z * z1_6_y + (t1378 + t1405);
        let t1433 = dw7_z * z2_6_y + (t1383 - t1409);
        let t1436 = dw7_z * z3_6_y + (t1388 + t1413);
        let t1439 = dw7_z * z4_6_y + (t1393 + t1417);
        let t1442 = c6 * dw7_z - (t1421 - t1398);
        let t1443 = t1403 + t1425;
        put(57, t1430); // row 1, ZZ7
        put(118, t1433); // row 2, ZZ7
        put(169, t1436); // row 3, ZZ7
        put(210, t1439); // row 4, ZZ7
        put(241, t1442); // row 5, ZZ7
        put(262, t1443); // row 6, ZZ7
    }
    // XY7: column
    {
        let t1444 = t1184 - t1181;
        let t1449 = z1_6_y * t1444 + (t1185 * t1110 + t1186 * t1113);
        let t1454 = z2_6_y * t1444 + (t1186 * t1123 - t1185 * z2_7_x);
        let t1459 = z3_6_y * t1444 + (t1185 * t1130 + t1186 * t1133);
        let t1464 = z4_6_y * t1444 + (t1185 * t1140 + t1186 * t1143);
        let t1469 = c6 * t1444 - (t1185 * z5_7_x - t1186 * t1146);
        let t1472 = s7 * t1185 + c7 * t1186;
        put(58, t1449); // row 1, XY7
        put(119, t1454); // row 2, XY7
        put(170, t1459); // row 3, XY7
        put(211, t1464); // row 4, XY7
        put(242, t1469); // row 5, XY7
        put(263, t1472); // row 6, XY7
        put(274, t1444); // row 7, XY7
    }
    // XZ7: column
    {
        let t1477 = t1170 * z1_6_y + (t1183 * t1110 + t1180 * t1113);
        let t1482 = t1170 * z2_6_y - (t1183 * z2_7_x - t1180 * t1123);
        let t1487 = t1170 * z3_6_y + (t1183 * t1130 + t1180 * t1133);
        let t1492 = t1170 * z4_6_y + (t1183 * t1140 + t1180 * t1143);
        let t1497 = c6 * t1170 + (t1180 * t1146 - t1183 * z5_7_x);
        let t1499 = t1222 + c7 * t1180;
        put(59, t1477); // row 1, XZ7
        put(120, t1482); // row 2, XZ7
        put(171, t1487); // row 3, XZ7
        put(212, t1492); // row 4, XZ7
        put(243, t1497); // row 5, XZ7
        put(264, t1499); // row 6, XZ7
    }
    // YZ7: column
    {
        let t1500 = t1184 - t829;
        let t1505 = t1167 * z1_6_y - (t1182 * t1113 - t1110 * t1500);
        let t1510 = t1167 * z2_6_y - (z2_7_x * t1500 + t1182 * t1123);
        let t1515 = t1167 * z3_6_y + (t1130 * t1500 - t1182 * t1133);
        let t1520 = t1167 * z4_6_y + (t1140 * t1500 - t1182 * t1143);
        let t1525 = c6 * t1167 - (z5_7_x * t1500 + t1182 * t1146);
        let t1527 = s7 * t1500 - t1275;
        let t1528 = dq1.sign();
        let t1529 = dq2.sign();
        let t1530 = dq3.sign();
        let t1531 = dq4.sign();
        let t1532 = dq5.sign();
        let t1533 = dq6.sign();
        let t1534 = dq7.sign();
        put(60, t1505); // row 1, YZ7
        put(62, t1528); // row 1, FC1
        put(121, t1510); // row 2, YZ7
        put(123, t1529); // row 2, FC2
        put(172, t1515); // row 3, YZ7
        put(174, t1530); // row 3, FC3
        put(213, t1520); // row 4, YZ7
        put(215, t1531); // row 4, FC4
        put(244, t1525); // row 5, YZ7
        put(246, t1532); // row 5, FC5
        put(265, t1527); // row 6, YZ7
        put(267, t1533); // row 6, FC6
        put(278, t1534); // row 7, FC7
    }
}
