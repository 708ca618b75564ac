//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil
//! and Dombre, 12.4.
//!
//! 675 multiplications, 492 additions; 7 x 64, 211 of 448 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig};

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

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 64 + PATTERN[k].1
}

/// Regressor `W_b` of the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 64]; 7]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            43 => clear(&mut flat[44..50]),
            44 => clear(&mut flat[51..57]),
            45 => clear(&mut flat[58..65]),
            87 => flat[107] = S::default(),
            88 => clear(&mut flat[109..115]),
            89 => clear(&mut flat[116..122]),
            90 => clear(&mut flat[123..136]),
            125 => clear(&mut flat[171..173]),
            126 => clear(&mut flat[174..180]),
            127 => clear(&mut flat[181..187]),
            128 => clear(&mut flat[188..207]),
            156 => clear(&mut flat[235..238]),
            157 => clear(&mut flat[239..245]),
            158 => clear(&mut flat[246..252]),
            159 => clear(&mut flat[253..278]),
            180 => clear(&mut flat[299..303]),
            181 => clear(&mut flat[304..310]),
            182 => clear(&mut flat[311..317]),
            183 => clear(&mut flat[318..349]),
            197 => clear(&mut flat[363..368]),
            198 => clear(&mut flat[369..375]),
            199 => clear(&mut flat[376..382]),
            200 => clear(&mut flat[383..420]),
            207 => clear(&mut flat[427..433]),
            208 => clear(&mut flat[434..440]),
            209 => clear(&mut flat[441..447]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 64]; 7]) {
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
    let k3 = S::constant(0.01275);
    let k4 = S::constant(0.31436);
    let k5 = S::constant(0.00035);
    let k6 = S::constant(0.167455);
    let k7 = S::constant(1.0);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        put(0, ddq1); // row 1, ZZ1R
        put(43, dq1); // row 1, FV1
        put(45, k7); // row 1, FO1
        put(49, ddq2); // row 2, ZZ2R
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
        t0
    };
    // joint axes in frame 2
    let [t1, v1_2_y] = {
        let t1 = c2 * k0;
        let v1_2_y = s2 * k0;
        [t1, v1_2_y]
    };
    // joint axes in frame 3
    let [t6, v1_3_y, v2_3_x, v2_4_z] = {
        let t3 = s2 * k1;
        let t6 = c3 * t1 - s3 * t3;
        let v1_3_y = c3 * t3 + s3 * t1;
        let v2_3_x = c3 * k1;
        let v2_4_z = s3 * k1;
        [t6, v1_3_y, v2_3_x, v2_4_z]
    };
    // link 2: motion
    let [
        t12, t13, a2_z, t17, t19, w2_x, w2_y, t22,
        t23, t27, t28, dw2_x, dw2_y, t31, t32, t33,
        t34, t35, t36, t37,
    ] = {
        let t12 = s2 * k2;
        let t13 = c2 * k2;
        let t14 = ddq1 * k0;
        let a2_z = t0 * k0;
        let t17 = t12 + c2 * t14;
        let t19 = t13 - s2 * t14;
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
        put(48, t38); // row 2, XX2R
        put(51, t22); // row 2, XZ2
        put(52, t23); // row 2, YZ2
        [
        t12, t13, a2_z, t17, t19, w2_x, w2_y, t22,
        t23, t27, t28, dw2_x, dw2_y, t31, t32, t33,
        t34, t35, t36, t37,
    ]
    };
    // XZ2: column
    {
        let t41 = s2 * t34 + c2 * t31;
        let t42 = k0 * t41;
        let t44 = k0 * t22 - t13;
        put(1, t42); // row 1, MSX2
        put(6, t41); // row 1, XZ2
        put(46, t44); // row 2, MSX2
    }
    // YZ2: column
    {
        let t48 = s2 * (t0 - t35) - c2 * t33;
        let t49 = k0 * t48;
        let t51 = t12 + k0 * t23;
        put(2, t49); // row 1, MSY2R
        put(7, t48); // row 1, YZ2
        put(47, t51); // row 2, MSY2R
    }
    // XX2: column
    let t53 = {
        let t53 = c2 * t27;
        let t54 = s2 * dw2_x + t53;
        put(3, t54); // row 1, XX2R
        t53
    };
    // ZZ2: column
    {
        let t56 = s2 * t28 - t53;
        put(4, t56); // row 1, ZZ2R
    }
    // XY2: column
    {
        let t57 = t35 - t32;
        let t60 = s2 * t36 + c2 * t37;
        put(5, t60); // row 1, XY2
        put(50, t57); // row 2, XY2
    }
    // link 3: motion
    let [
        z1_3_x, z1_4_z, a3_z, t71, a3_y, w3_x, t80, t83,
        t86, w3_z, dw3_z, t91, t92, t93, t94, t95,
        t96, t97, t98, t99, t100, t101, t102,
    ] = {
        let z1_3_x = s2 * c3;
        let z1_4_z = s2 * s3;
        let t66 = t17 + t33 * k1;
        let a3_z = t35 * k1 - t19;
        let t68 = a2_z - t37 * k1;
        let t71 = c3 * t66 + s3 * t68;
        let a3_y = s3 * t66 - c3 * t68;
        let w3_x = c3 * w2_x - s3 * dq2;
        let t80 = c3 * dq2 + s3 * w2_x;
        let t83 = c3 * t33 - s3 * t37;
        let t86 = c3 * t37 + s3 * t33;
        let w3_z = w2_y + dq3;
        let dw3_z = dw2_y + ddq3;
        let t89 = w3_x * w3_x;
        let t90 = w3_z * w3_z;
        let t91 = w3_x * t80;
        let t92 = w3_x * w3_z;
        let t93 = t80 * w3_z;
        let t94 = t93 - t86;
        let t95 = t92 - t83;
        let t96 = t90 - t89;
        let t97 = t35 + t96;
        let t98 = dw3_z + t91;
        let t99 = t91 - dw3_z;
        let t100 = t89 + t90;
        let t101 = t92 + t95;
        let t102 = t93 + t94;
        put(91, a3_y); // row 3, MSX3
        put(92, t71); // row 3, MSY3R
        put(93, t91); // row 3, XX3R
        put(94, dw3_z); // row 3, ZZ3R
        put(96, t86); // row 3, XZ3
        put(97, t83); // row 3, YZ3
        [
        z1_3_x, z1_4_z, a3_z, t71, a3_y, w3_x, t80, t83,
        t86, w3_z, dw3_z, t91, t92, t93, t94, t95,
        t96, t97, t98, t99, t100, t101, t102,
    ]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, t109, z2_4_y, t111, t112, t115, t118] = {
        let z1_4_x = c4 * z1_3_x + c2 * s4;
        let z1_4_y = c2 * c4 - s4 * z1_3_x;
        let t109 = s3 * c4;
        let z2_4_y = s3 * s4;
        let t111 = c4 * v2_3_x;
        let t112 = s4 * v2_3_x;
        let t115 = c4 * t6 - s4 * v1_2_y;
        let t118 = c4 * v1_2_y + s4 * t6;
        [z1_4_x, z1_4_y, t109, z2_4_y, t111, t112, t115, t118]
    };
    // joint axes in frame 5
    let [t121, z1_6_z, t127, t130, z3_5_x, z3_6_z] = {
        let t121 = s5 * z1_4_z - c5 * z1_4_x;
        let z1_6_z = c5 * z1_4_z + s5 * z1_4_x;
        let t127 = c5 * t109 + c3 * s5;
        let t130 = c3 * c5 - s5 * t109;
        let z3_5_x = s4 * c5;
        let z3_6_z = s4 * s5;
        [t121, z1_6_z, t127, t130, z3_5_x, z3_6_z]
    };
    // MSX3: column
    {
        let t140 = t101 * v1_2_y + (t97 * t6 - t99 * v1_3_y);
        let t141 = z1_4_z * a3_z + c2 * a3_y + t140;
        let t146 = c3 * a3_z + (t99 * v2_4_z - t97 * v2_3_x);
        put(8, t141); // row 1, MSX3
        put(53, t146); // row 2, MSX3
    }
    // MSY3: column
    {
        let t154 = t102 * v1_2_y + (t100 * v1_3_y - t98 * t6);
        let t155 = z1_3_x * a3_z + c2 * t71 - t154;
        let t160 = t100 * v2_4_z - t98 * v2_3_x - s3 * a3_z;
        put(9, t155); // row 1, MSY3R
        put(54, t160); // row 2, MSY3R
    }
    // XX3: column
    let [t162, t167] = {
        let t162 = z1_4_z * t92;
        let t165 = c2 * t91 - (z1_3_x * t94 + t162);
        let t167 = c3 * t92;
        let t168 = s3 * t94 - t167;
        put(10, t165); // row 1, XX3R
        put(55, t168); // row 2, XX3R
        [t162, t167]
    };
    // ZZ3: column
    {
        let t172 = c2 * dw3_z - (z1_3_x * t93 - t162);
        let t174 = t167 + s3 * t93;
        put(11, t172); // row 1, ZZ3R
        put(56, t174); // row 2, ZZ3R
    }
    // XY3: column
    {
        let t175 = t100 - t97;
        let t180 = c2 * t175 + (z1_4_z * t102 - z1_3_x * t101);
        let t183 = s3 * t101 + c3 * t102;
        put(12, t180); // row 1, XY3
        put(57, t183); // row 2, XY3
        put(95, t175); // row 3, XY3
    }
    // XZ3: column
    {
        let t188 = c2 * t86 - (z1_3_x * t99 + z1_4_z * t96);
        let t191 = s3 * t99 - c3 * t96;
        put(13, t188); // row 1, XZ3
        put(58, t191); // row 2, XZ3
    }
    // YZ3: column
    {
        let t192 = t100 - t35;
        let t197 = c2 * t83 - (z1_3_x * t192 + z1_4_z * t98);
        let t200 = s3 * t192 - c3 * t98;
        put(14, t197); // row 1, YZ3
        put(59, t200); // row 2, YZ3
    }
    // link 4: motion
    let [
        t205, t209, a4_y, w4_x, w4_y, t221, t224, w4_z,
        dw4_z, t229, t230, t231, dw4_x, dw4_y, t234, t235,
        t236, t237, t238, t239, t240,
    ] = {
        let t204 = t71 + t98 * k3;
        let t205 = t100 * k3 - a3_y;
        let t206 = t102 * k3 - a3_z;
        let t209 = c4 * t204 + s4 * t206;
        let a4_y = s4 * t204 - c4 * t206;
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t221 = c4 * t98 + s4 * t102;
        let t224 = s4 * t98 - c4 * t102;
        let w4_z = t80 + dq4;
        let dw4_z = t95 + ddq4;
        let t227 = w4_x * w4_x;
        let t228 = w4_z * w4_z;
        let t229 = w4_x * w4_y;
        let t230 = w4_x * w4_z;
        let t231 = w4_y * w4_z;
        let dw4_x = t224 + t231;
        let dw4_y = t221 - t230;
        let t234 = t228 - t227;
        let t235 = t100 + t234;
        let t236 = t229 - dw4_z;
        let t237 = dw4_z + t229;
        let t238 = t227 + t228;
        let t239 = dw4_y - t230;
        let t240 = t231 + dw4_x;
        let t241 = -t229;
        put(129, a4_y); // row 4, MSX4
        put(130, t209); // row 4, MSY4R
        put(131, t241); // row 4, XX4R
        put(132, dw4_z); // row 4, ZZ4R
        put(134, t224); // row 4, XZ4
        put(135, t221); // row 4, YZ4
        [
        t205, t209, a4_y, w4_x, w4_y, t221, t224, w4_z,
        dw4_z, t229, t230, t231, dw4_x, dw4_y, t234, t235,
        t236, t237, t238, t239, t240,
    ]
    };
    // MSX4: column
    let [t243, t248, t249] = {
        let t243 = s4 * t237;
        let t244 = c4 * t235 + t243;
        let t247 = s4 * t235 - c4 * t237;
        let t248 = s4 * t205;
        let t249 = c4 * t205;
        let t252 = t248 - k3 * t247;
        let t253 = k3 * t244 - t249;
        let t263 = t6 * t244 + t239 * v1_3_y - v1_2_y * t247;
        let t264 = c2 * t253 + (z1_3_x * t252 + z1_4_z * a4_y) + t263;
        let t271 = c3 * a4_y - s3 * t252 - (v2_3_x * t244 + t239 * v2_4_z);
        put(15, t264); // row 1, MSX4
        put(60, t271); // row 2, MSX4
        put(98, t253); // row 3, MSX4
        [t243, t248, t249]
    };
    // MSY4: column
    let t272 = {
        let t272 = c4 * t236;
        let t274 = t272 + s4 * t238;
        let t277 = s4 * t236 - c4 * t238;
        let t280 = t249 + k3 * t277;
        let t281 = t248 - k3 * t274;
        let t291 = v1_2_y * t277 - (t6 * t274 + t240 * v1_3_y);
        let t292 = c2 * t281 + (z1_3_x * t280 + z1_4_z * t209) + t291;
        let t299 = v2_3_x * t274 + t240 * v2_4_z - (s3 * t280 - c3 * t209);
        put(16, t292); // row 1, MSY4R
        put(61, t299); // row 2, MSY4R
        put(99, t281); // row 3, MSY4R
        t272
    };
    // XX4: column
    let [t301, t306, t311] = {
        let t301 = t230 * z1_4_y;
        let t304 = dw4_x * z1_4_x + t301 - z1_4_z * t229;
        let t306 = t230 * z2_4_y;
        let t309 = t306 - dw4_x * t109 - c3 * t229;
        let t311 = c4 * t230;
        let t312 = s4 * dw4_x + t311;
        put(17, t304); // row 1, XX4R
        put(62, t309); // row 2, XX4R
        put(100, t312); // row 3, XX4R
        [t301, t306, t311]
    };
    // ZZ4: column
    {
        let t316 = z1_4_z * dw4_z + (t231 * z1_4_x - t301);
        let t320 = c3 * dw4_z - (t306 + t231 * t109);
        let t322 = s4 * t231 - t311;
        put(18, t316); // row 1, ZZ4R
        put(63, t320); // row 2, ZZ4R
        put(101, t322); // row 3, ZZ4R
    }
    // XY4: column
    {
        let t323 = t238 - t235;
        let t328 = z1_4_z * t323 + (t239 * z1_4_x + t240 * z1_4_y);
        let t333 = c3 * t323 + (t240 * z2_4_y - t239 * t109);
        let t336 = s4 * t239 + c4 * t240;
        put(19, t328); // row 1, XY4
        put(64, t333); // row 2, XY4
        put(102, t336); // row 3, XY4
        put(133, t323); // row 4, XY4
    }
    // XZ4: column
    {
        let t341 = z1_4_z * t224 + (t237 * z1_4_x + t234 * z1_4_y);
        let t346 = c3 * t224 + (t234 * z2_4_y - t237 * t109);
        let t348 = t243 + c4 * t234;
        put(20, t341); // row 1, XZ4
        put(65, t346); // row 2, XZ4
        put(103, t348); // row 3, XZ4
    }
    // YZ4: column
    {
        let t349 = t100 - t238;
        let t354 = z1_4_z * t221 + (z1_4_x * t349 - t236 * z1_4_y);
        let t359 = c3 * t221 - (t109 * t349 + t236 * z2_4_y);
        let t361 = s4 * t349 - t272;
        put(21, t354); // row 1, YZ4
        put(66, t359); // row 2, YZ4
        put(104, t361); // row 3, YZ4
    }
    // link 5: motion
    let [
        a5_z, t370, a5_y, w5_x, t379, t382, t385, w5_z,
        dw5_z, t390, t391, t392, t393, t394, t395, t396,
        t397, t398, t399, t400, t401,
    ] = {
        let t365 = t209 + t236 * k4;
        let a5_z = a4_y + t238 * k4;
        let t367 = t240 * k4 - t205;
        let t370 = c5 * t365 - s5 * t367;
        let a5_y = c5 * t367 + s5 * t365;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t379 = c5 * w4_z + s5 * w4_x;
        let t382 = c5 * t236 - s5 * t240;
        let t385 = c5 * t240 + s5 * t236;
        let w5_z = w4_y + dq5;
        let dw5_z = dw4_y + ddq5;
        let t388 = w5_x * w5_x;
        let t389 = w5_z * w5_z;
        let t390 = w5_x * t379;
        let t391 = w5_x * w5_z;
        let t392 = t379 * w5_z;
        let t393 = t392 - t385;
        let t394 = t391 - t382;
        let t395 = t388 - t389;
        let t396 = t395 - t238;
        let t397 = dw5_z + t390;
        let t398 = dw5_z - t390;
        let t399 = t388 + t389;
        let t400 = t391 + t394;
        let t401 = t392 + t393;
        put(160, a5_y); // row 5, MSX5
        put(161, t370); // row 5, MSY5R
        put(162, t390); // row 5, XX5R
        put(163, dw5_z); // row 5, ZZ5R
        put(165, t385); // row 5, XZ5
        put(166, t382); // row 5, YZ5
        [
        a5_z, t370, a5_y, w5_x, t379, t382, t385, w5_z,
        dw5_z, t390, t391, t392, t393, t394, t395, t396,
        t397, t398, t399, t400, t401,
    ]
    };
    // MSX5: column
    let [t403, t408, t409] = {
        let t403 = s5 * t398;
        let t404 = c5 * t396 - t403;
        let t407 = s5 * t396 + c5 * t398;
        let t408 = s5 * a5_z;
        let t409 = c5 * a5_z;
        let t413 = t409 + k4 * t404;
        let t416 = t408 + k4 * t407 + k3 * t400;
        let t417 = a5_y - k3 * t404;
        let t427 = v1_3_y * t407 + (t400 * t118 - t115 * t404);
        let t428 = z1_4_z * t413 + (z1_4_x * t416 + z1_4_y * t417) + t427;
        let t438 = v2_4_z * t407 + (t400 * t112 - t111 * t404);
        let t439 = c3 * t413 + (z2_4_y * t417 - t109 * t416) - t438;
        let t442 = s4 * t416 + c4 * t417;
        put(22, t428); // row 1, MSX5
        put(67, t439); // row 2, MSX5
        put(105, t442); // row 3, MSX5
        put(136, t413); // row 4, MSX5
        [t403, t408, t409]
    };
    // MSY5: column
    let t443 = {
        let t443 = c5 * t397;
        let t445 = s5 * t399 - t443;
        let t448 = s5 * t397 + c5 * t399;
        let t452 = k4 * t445 - t408;
        let t455 = k4 * t448 - t409 + k3 * t401;
        let t456 = t370 - k3 * t445;
        let t466 = v1_3_y * t448 + (t115 * t445 + t401 * t118);
        let t467 = z1_4_z * t452 + (z1_4_y * t456 - z1_4_x * t455) - t466;
        let t477 = v2_4_z * t448 + (t111 * t445 + t401 * t112);
        let t478 = c3 * t452 + (t109 * t455 + z2_4_y * t456) + t477;
        let t481 = c4 * t456 - s4 * t455;
        put(23, t467); // row 1, MSY5R
        put(68, t478); // row 2, MSY5R
        put(106, t481); // row 3, MSY5R
        put(137, t452); // row 4, MSY5R
        t443
    };
    // XX5: column
    let [t483, t488, t493, t498] = {
        let t483 = t391 * z1_6_z;
        let t486 = t390 * z1_4_y + (t393 * t121 - t483);
        let t488 = t391 * t130;
        let t491 = t390 * z2_4_y + (t393 * t127 - t488);
        let t493 = t391 * z3_6_z;
        let t496 = c4 * t390 - (t393 * z3_5_x + t493);
        let t498 = c5 * t391;
        let t499 = s5 * t393 - t498;
        put(24, t486); // row 1, XX5R
        put(69, t491); // row 2, XX5R
        put(107, t496); // row 3, XX5R
        put(138, t499); // row 4, XX5R
        [t483, t488, t493, t498]
    };
    // ZZ5: column
    {
        let t503 = dw5_z * z1_4_y + (t483 + t392 * t121);
        let t507 = dw5_z * z2_4_y + (t488 + t392 * t127);
        let t511 = c4 * dw5_z - (t392 * z3_5_x - t493);
        let t513 = t498 + s5 * t392;
        put(25, t503); // row 1, ZZ5R
        put(70, t507); // row 2, ZZ5R
        put(108, t511); // row 3, ZZ5R
        put(139, t513); // row 4, ZZ5R
    }
    // XY5: column
    {
        let t514 = t396 + t399;
        let t519 = z1_4_y * t514 + (t400 * t121 + t401 * z1_6_z);
        let t524 = z2_4_y * t514 + (t400 * t127 + t401 * t130);
        let t529 = c4 * t514 + (t401 * z3_6_z - t400 * z3_5_x);
        let t532 = s5 * t400 + c5 * t401;
        put(26, t519); // row 1, XY5
        put(71, t524); // row 2, XY5
        put(109, t529); // row 3, XY5
        put(140, t532); // row 4, XY5
        put(164, t514); // row 5, XY5
    }
    // XZ5: column
    {
        let t537 = t385 * z1_4_y + (t395 * z1_6_z - t398 * t121);
        let t542 = t385 * z2_4_y + (t395 * t130 - t398 * t127);
        let t547 = c4 * t385 + (t398 * z3_5_x + t395 * z3_6_z);
        let t549 = c5 * t395 - t403;
        put(27, t537); // row 1, XZ5
        put(72, t542); // row 2, XZ5
        put(110, t547); // row 3, XZ5
        put(141, t549); // row 4, XZ5
    }
    // YZ5: column
    {
        let t550 = t399 - t238;
        let t555 = t382 * z1_4_y + (t121 * t550 - t397 * z1_6_z);
        let t560 = t382 * z2_4_y - (t397 * t130 - t127 * t550);
        let t565 = c4 * t382 - (z3_5_x * t550 + t397 * z3_6_z);
        let t567 = s5 * t550 - t443;
        put(28, t555); // row 1, YZ5
        put(73, t560); // row 2, YZ5
        put(111, t565); // row 3, YZ5
        put(142, t567); // row 4, YZ5
    }
    // link 6: motion
    let [
        t572, t576, a6_y, w6_x, w6_y, t588, t591, w6_z,
        dw6_z, t596, t597, t598, dw6_x, t600, t601, t602,
        t603, t604, t605, t606, t607,
    ] = {
        let t571 = t370 + t397 * k5;
        let t572 = t399 * k5 - a5_y;
        let t573 = t401 * k5 - a5_z;
        let t576 = c6 * t571 + s6 * t573;
        let a6_y = s6 * t571 - c6 * t573;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t588 = c6 * t397 + s6 * t401;
        let t591 = s6 * t397 - c6 * t401;
        let w6_z = t379 + dq6;
        let dw6_z = t394 + ddq6;
        let t594 = w6_x * w6_x;
        let t595 = w6_z * w6_z;
        let t596 = w6_x * w6_y;
        let t597 = w6_x * w6_z;
        let t598 = w6_y * w6_z;
        let dw6_x = t591 + t598;
        let t600 = t597 - t588;
        let t601 = t594 - t595;
        let t602 = t601 - t399;
        let t603 = t596 - dw6_z;
        let t604 = dw6_z + t596;
        let t605 = t594 + t595;
        let t606 = t597 + t600;
        let t607 = t598 + dw6_x;
        let t608 = -t596;
        put(184, a6_y); // row 6, MSX6
        put(185, t576); // row 6, MSY6R
        put(186, t608); // row 6, XX6R
        put(187, dw6_z); // row 6, ZZ6R
        put(189, t591); // row 6, XZ6
        put(190, t588); // row 6, YZ6
        [
        t572, t576, a6_y, w6_x, w6_y, t588, t591, w6_z,
        dw6_z, t596, t597, t598, dw6_x, t600, t601, t602,
        t603, t604, t605, t606, t607,
    ]
    };
    // MSX6: column
    let [t610, t613, t615, t616] = {
        let t610 = s6 * t604;
        let t611 = t610 - c6 * t602;
        let t613 = c6 * t604;
        let t614 = s6 * t602 + t613;
        let t615 = s6 * t572;
        let t616 = c6 * t572;
        let t619 = t615 + k5 * t614;
        let t620 = k5 * t611 - t616;
        let t623 = s5 * t606 - c5 * t611;
        let t626 = s5 * t611 + c5 * t606;
        let t636 = c5 * a6_y - s5 * t619 + k4 * t623;
        let t639 = k3 * t614 - (k4 * t626 - (c5 * t619 + s5 * a6_y));
        let t640 = t620 - k3 * t623;
        let t650 = v1_3_y * t626 - (t118 * t614 - t115 * t623);
        let t651 = z1_4_z * t636 + (z1_4_x * t639 + z1_4_y * t640) - t650;
        let t661 = v2_4_z * t626 - (t112 * t614 - t111 * t623);
        let t662 = c3 * t636 - (t109 * t639 - z2_4_y * t640) + t661;
        let t665 = s4 * t639 + c4 * t640;
        put(29, t651); // row 1, MSX6
        put(74, t662); // row 2, MSX6
        put(112, t665); // row 3, MSX6
        put(143, t636); // row 4, MSX6
        put(167, t620); // row 5, MSX6
        [t610, t613, t615, t616]
    };
    // MSY6: column
    let [t666, t669] = {
        let t666 = c6 * t603;
        let t668 = t666 + s6 * t605;
        let t669 = s6 * t603;
        let t671 = t669 - c6 * t605;
        let t674 = t616 + k5 * t671;
        let t675 = t615 - k5 * t668;
        let t678 = c5 * t668 + s5 * t607;
        let t681 = c5 * t607 - s5 * t668;
        let t691 = c5 * t576 - s5 * t674 + k4 * t678;
        let t694 = k3 * t671 - (k4 * t681 - (c5 * t674 + s5 * t576));
        let t695 = t675 - k3 * t678;
        let t705 = v1_3_y * t681 - (t118 * t671 - t115 * t678);
        let t706 = z1_4_z * t691 + (z1_4_x * t694 + z1_4_y * t695) - t705;
        let t716 = t112 * t671 - t111 * t678 - v2_4_z * t681;
        let t717 = c3 * t691 + (z2_4_y * t695 - t109 * t694) - t716;
        let t720 = s4 * t694 + c4 * t695;
        put(30, t706); // row 1, MSY6R
        put(75, t717); // row 2, MSY6R
        put(113, t720); // row 3, MSY6R
        put(144, t691); // row 4, MSY6R
        put(168, t675); // row 5, MSY6R
        [t666, t669]
    };
    // XX6: column
    let [t722, t725] = {
        let t722 = s6 * t597;
        let t723 = t722 - c6 * dw6_x;
        let t725 = c6 * t597;
        let t726 = s6 * dw6_x + t725;
        let t731 = z1_4_y * t726 + (t121 * t723 - t596 * z1_6_z);
        let t736 = z2_4_y * t726 - (t596 * t130 - t127 * t723);
        let t741 = c4 * t726 - (z3_5_x * t723 + t596 * z3_6_z);
        let t744 = s5 * t723 - c5 * t596;
        put(31, t731); // row 1, XX6R
        put(76, t736); // row 2, XX6R
        put(114, t741); // row 3, XX6R
        put(145, t744); // row 4, XX6R
        put(169, t726); // row 5, XX6R
        [t722, t725]
    };
    // ZZ6: column
    {
        let t746 = t722 + c6 * t598;
        let t748 = s6 * t598 - t725;
        let t753 = z1_4_y * t748 + (dw6_z * z1_6_z - t121 * t746);
        let t758 = z2_4_y * t748 + (dw6_z * t130 - t127 * t746);
        let t763 = c4 * t748 + (z3_5_x * t746 + dw6_z * z3_6_z);
        let t766 = c5 * dw6_z - s5 * t746;
        put(32, t753); // row 1, ZZ6R
        put(77, t758); // row 2, ZZ6R
        put(115, t763); // row 3, ZZ6R
        put(146, t766); // row 4, ZZ6R
        put(170, t748); // row 5, ZZ6R
    }
    // XY6: column
    {
        let t767 = t602 + t605;
        let t770 = c6 * t606 + s6 * t607;
        let t773 = c6 * t607 - s6 * t606;
        let t778 = z1_4_y * t773 + (t121 * t770 + z1_6_z * t767);
        let t783 = z2_4_y * t773 + (t127 * t770 + t130 * t767);
        let t788 = c4 * t773 + (z3_6_z * t767 - z3_5_x * t770);
        let t791 = s5 * t770 + c5 * t767;
        put(33, t778); // row 1, XY6
        put(78, t783); // row 2, XY6
        put(116, t788); // row 3, XY6
        put(147, t791); // row 4, XY6
        put(171, t773); // row 5, XY6
        put(188, t767); // row 6, XY6
    }
    // link 7: motion
    let [
        a7_z, t800, a7_y, t812, t815, dw7_z, t820, t821,
        t822, t823, t825, t826, t827, t828, t829, t830,
        t831,
    ] = {
        let t795 = t576 + t603 * k6;
        let a7_z = a6_y + t605 * k6;
        let t797 = t572 - t607 * k6;
        let t800 = c7 * t795 + s7 * t797;
        let a7_y = s7 * t795 - c7 * t797;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t809 = c7 * w6_z + s7 * w6_x;
        let t812 = c7 * t603 - s7 * t607;
        let t815 = c7 * t607 + s7 * t603;
        let w7_z = w6_y + dq7;
        let dw7_z = ddq7 - t600;
        let t818 = w7_x * w7_x;
        let t819 = w7_z * w7_z;
        let t820 = w7_x * t809;
        let t821 = w7_x * w7_z;
        let t822 = t809 * w7_z;
        let t823 = t822 - t815;
        let dw7_y = t812 - t821;
        let t825 = t819 - t818;
        let t826 = t605 + t825;
        let t827 = dw7_z + t820;
        let t828 = t820 - dw7_z;
        let t829 = t818 + t819;
        let t830 = t821 - dw7_y;
        let t831 = t822 + t823;
        put(201, a7_y); // row 7, MSX7
        put(202, t800); // row 7, MSY7
        put(203, t820); // row 7, XX7R
        put(204, dw7_z); // row 7, ZZ7
        put(206, t815); // row 7, XZ7
        put(207, t812); // row 7, YZ7
        [
        a7_z, t800, a7_y, t812, t815, dw7_z, t820, t821,
        t822, t823, t825, t826, t827, t828, t829, t830,
        t831,
    ]
    };
    // XZ6: column
    {
        let t833 = t613 + s6 * t601;
        let t835 = t610 - c6 * t601;
        let t840 = z1_4_y * t835 + (t591 * z1_6_z - t121 * t833);
        let t845 = z2_4_y * t835 - (t127 * t833 - t591 * t130);
        let t850 = c4 * t835 + (z3_5_x * t833 + t591 * z3_6_z);
        let t853 = c5 * t591 - s5 * t833;
        put(34, t840); // row 1, XZ6
        put(79, t845); // row 2, XZ6
        put(117, t850); // row 3, XZ6
        put(148, t853); // row 4, XZ6
        put(172, t835); // row 5, XZ6
    }
    // YZ6: column
    {
        let t854 = t399 - t605;
        let t856 = t669 + c6 * t854;
        let t858 = s6 * t854 - t666;
        let t863 = z1_4_y * t858 - (t121 * t856 - t588 * z1_6_z);
        let t868 = z2_4_y * t858 + (t588 * t130 - t127 * t856);
        let t873 = c4 * t858 + (z3_5_x * t856 + t588 * z3_6_z);
        let t876 = c5 * t588 - s5 * t856;
        put(35, t863); // row 1, YZ6
        put(80, t868); // row 2, YZ6
        put(118, t873); // row 3, YZ6
        put(149, t876); // row 4, YZ6
        put(173, t858); // row 5, YZ6
    }
    // MSX7: column
    let [t878, t881, t883, t884] = {
        let t878 = s7 * t828;
        let t879 = c7 * t826 - t878;
        let t881 = c7 * t828;
        let t882 = s7 * t826 + t881;
        let t883 = s7 * a7_z;
        let t884 = c7 * a7_z;
        let t887 = k6 * t882 - t883;
        let t888 = t884 - k6 * t879;
        let t891 = c6 * t879 + s6 * t830;
        let t894 = s6 * t879 - c6 * t830;
        let t903 = c6 * t887 + s6 * a7_y + k5 * t894;
        let t904 = k5 * t891 - (s6 * t887 - c6 * a7_y);
        let t907 = c5 * t891 - s5 * t882;
        let t910 = s5 * t891 + c5 * t882;
        let t920 = s5 * t903 + c5 * t888 - k4 * t907;
        let t923 = s5 * t888 - c5 * t903 - k4 * t910 - k3 * t894;
        let t924 = t904 + k3 * t907;
        let t934 = v1_3_y * t910 - (t115 * t907 - t118 * t894);
        let t935 = z1_4_z * t920 + (z1_4_x * t923 + z1_4_y * t924) - t934;
        let t945 = v2_4_z * t910 + (t112 * t894 - t111 * t907);
        let t946 = c3 * t920 + (z2_4_y * t924 - t109 * t923) + t945;
        let t949 = s4 * t923 + c4 * t924;
        put(36, t935); // row 1, MSX7
        put(81, t946); // row 2, MSX7
        put(119, t949); // row 3, MSX7
        put(150, t920); // row 4, MSX7
        put(174, t904); // row 5, MSX7
        put(191, t888); // row 6, MSX7
        [t878, t881, t883, t884]
    };
    // MSY7: column
    let [t950, t953] = {
        let t950 = c7 * t827;
        let t952 = s7 * t829 - t950;
        let t953 = s7 * t827;
        let t955 = t953 + c7 * t829;
        let t958 = t884 - k6 * t955;
        let t959 = k6 * t952 - t883;
        let t962 = c6 * t952 + s6 * t831;
        let t965 = s6 * t952 - c6 * t831;
        let t974 = c6 * t958 - s6 * t800 + k5 * t965;
        let t975 = s6 * t958 + c6 * t800 - k5 * t962;
        let t978 = c5 * t962 + s5 * t955;
        let t981 = c5 * t955 - s5 * t962;
        let t991 = c5 * t959 - s5 * t974 + k4 * t978;
        let t994 = c5 * t974 + s5 * t959 - k4 * t981 + k3 * t965;
        let t995 = t975 - k3 * t978;
        let t1005 = t118 * t965 - t115 * t978 - v1_3_y * t981;
        let t1006 = z1_4_z * t991 + (z1_4_x * t994 + z1_4_y * t995) + t1005;
        let t1016 = v2_4_z * t981 + (t111 * t978 - t112 * t965);
        let t1017 = c3 * t991 + (z2_4_y * t995 - t109 * t994) + t1016;
        let t1020 = s4 * t994 + c4 * t995;
        put(37, t1006); // row 1, MSY7
        put(82, t1017); // row 2, MSY7
        put(120, t1020); // row 3, MSY7
        put(151, t991); // row 4, MSY7
        put(175, t975); // row 5, MSY7
        put(192, t959); // row 6, MSY7
        [t950, t953]
    };
    // XX7: column
    let [t1022, t1025] = {
        let t1022 = s7 * t821;
        let t1023 = c7 * t823 + t1022;
        let t1025 = c7 * t821;
        let t1026 = s7 * t823 - t1025;
        let t1029 = c6 * t1023 + s6 * t820;
        let t1032 = c6 * t820 - s6 * t1023;
        let t1037 = z1_4_y * t1032 + (t121 * t1029 + z1_6_z * t1026);
        let t1042 = z2_4_y * t1032 + (t127 * t1029 + t130 * t1026);
        let t1047 = c4 * t1032 - (z3_5_x * t1029 - z3_6_z * t1026);
        let t1050 = s5 * t1029 + c5 * t1026;
        put(38, t1037); // row 1, XX7R
        put(83, t1042); // row 2, XX7R
        put(121, t1047); // row 3, XX7R
        put(152, t1050); // row 4, XX7R
        put(176, t1032); // row 5, XX7R
        put(193, t1026); // row 6, XX7R
        [t1022, t1025]
    };
    // ZZ7: column
    {
        let t1052 = c7 * t822 - t1022;
        let t1054 = t1025 + s7 * t822;
        let t1057 = c6 * t1052 + s6 * dw7_z;
        let t1060 = c6 * dw7_z - s6 * t1052;
        let t1065 = z1_4_y * t1060 + (t121 * t1057 + z1_6_z * t1054);
        let t1070 = z2_4_y * t1060 + (t127 * t1057 + t130 * t1054);
        let t1075 = c4 * t1060 + (z3_6_z * t1054 - z3_5_x * t1057);
        let t1078 = s5 * t1057 + c5 * t1054;
        put(39, t1065); // row 1, ZZ7
        put(84, t1070); // row 2, ZZ7
        put(122, t1075); // row 3, ZZ7
        put(153, t1078); // row 4, ZZ7
        put(177, t1060); // row 5, ZZ7
        put(194, t1054); // row 6, ZZ7
    }
    // XY7: column
    {
        let t1079 = t829 - t826;
        let t1082 = c7 * t830 - s7 * t831;
        let t1085 = s7 * t830 + c7 * t831;
        let t1088 = c6 * t1082 + s6 * t1079;
        let t1091 = c6 * t1079 - s6 * t1082;
        let t1096 = z1_4_y * t1091 + (t121 * t1088 + z1_6_z * t1085);
        let t1101 = z2_4_y * t1091 + (t127 * t1088 + t130 * t1085);
        let t1106 = c4 * t1091 + (z3_6_z * t1085 - z3_5_x * t1088);
        let t1109 = s5 * t1088 + c5 * t1085;
        put(40, t1096); // row 1, XY7
        put(85, t1101); // row 2, XY7
        put(123, t1106); // row 3, XY7
        put(154, t1109); // row 4, XY7
        put(178, t1091); // row 5, XY7
        put(195, t1085); // row 6, XY7
        put(205, t1079); // row 7, XY7
    }
    // XZ7: column
    {
        let t1111 = t881 + s7 * t825;
        let t1113 = t878 - c7 * t825;
        let t1116 = c6 * t1111 + s6 * t815;
        let t1119 = c6 * t815 - s6 * t1111;
        let t1124 = z1_4_y * t1119 + (t121 * t1116 + z1_6_z * t1113);
        let t1129 = z2_4_y * t1119 + (t127 * t1116 + t130 * t1113);
        let t1134 = c4 * t1119 + (z3_6_z * t1113 - z3_5_x * t1116);
        let t1137 = s5 * t1116 + c5 * t1113;
        put(41, t1124); // row 1, XZ7
        put(86, t1129); // row 2, XZ7
        put(124, t1134); // row 3, XZ7
        put(155, t1137); // row 4, XZ7
        put(179, t1119); // row 5, XZ7
        put(196, t1113); // row 6, XZ7
    }
    // YZ7: column
    {
        let t1138 = t829 - t605;
        let t1140 = t953 + c7 * t1138;
        let t1142 = s7 * t1138 - t950;
        let t1145 = c6 * t1140 + s6 * t812;
        let t1148 = c6 * t812 - s6 * t1140;
        let t1153 = z1_4_y * t1148 + (t121 * t1145 + z1_6_z * t1142);
        let t1158 = z2_4_y * t1148 + (t127 * t1145 + t130 * t1142);
        let t1163 = c4 * t1148 + (z3_6_z * t1142 - z3_5_x * t1145);
        let t1166 = s5 * t1145 + c5 * t1142;
        let t1167 = dq1.sign();
        let t1168 = dq2.sign();
        let t1169 = dq3.sign();
        let t1170 = dq4.sign();
        let t1171 = dq5.sign();
        let t1172 = dq6.sign();
        let t1173 = dq7.sign();
        put(42, t1153); // row 1, YZ7
        put(44, t1167); // row 1, FC1
        put(87, t1158); // row 2, YZ7
        put(89, t1168); // row 2, FC2
        put(125, t1163); // row 3, YZ7
        put(127, t1169); // row 3, FC3
        put(156, t1166); // row 4, YZ7
        put(158, t1170); // row 4, FC4
        put(180, t1148); // row 5, YZ7
        put(182, t1171); // row 5, FC5
        put(197, t1142); // row 6, YZ7
        put(199, t1172); // row 6, FC6
        put(209, t1173); // row 7, FC7
    }
}
