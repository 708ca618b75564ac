//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil
//! and Dombre, 12.4.
//!
//! 625 multiplications, 466 additions; 7 x 64, 209 of 448 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig, constants};

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
            0 => clear(&mut flat[1..3]),
            41 => clear(&mut flat[44..50]),
            42 => clear(&mut flat[51..57]),
            43 => clear(&mut flat[58..65]),
            85 => flat[107] = S::default(),
            86 => clear(&mut flat[109..115]),
            87 => clear(&mut flat[116..122]),
            88 => clear(&mut flat[123..136]),
            123 => clear(&mut flat[171..173]),
            124 => clear(&mut flat[174..180]),
            125 => clear(&mut flat[181..187]),
            126 => clear(&mut flat[188..207]),
            154 => clear(&mut flat[235..238]),
            155 => clear(&mut flat[239..245]),
            156 => clear(&mut flat[246..252]),
            157 => clear(&mut flat[253..278]),
            178 => clear(&mut flat[299..303]),
            179 => clear(&mut flat[304..310]),
            180 => clear(&mut flat[311..317]),
            181 => clear(&mut flat[318..349]),
            195 => clear(&mut flat[363..368]),
            196 => clear(&mut flat[369..375]),
            197 => clear(&mut flat[376..382]),
            198 => clear(&mut flat[383..420]),
            205 => clear(&mut flat[427..433]),
            206 => clear(&mut flat[434..440]),
            207 => clear(&mut flat[441..447]),
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
    let k0 = S::constant(-GRAVITY[2]);
    let k4 = S::constant(0.088);
    let k5 = S::constant(1.0);
    let k_A = S::constant(constants::A);
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        put(0, ddq1); // row 1, ZZ1R
        put(41, dq1); // row 1, FV1
        put(43, k5); // row 1, FO1
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
        t0
    };
    // link 2: motion
    let [
        t1, t2, t3, t4, t10, t11, t12, dw2_y,
        t14, t15, t16, t17, t18, t19, t20,
    ] = {
        let t1 = s2 * k0;
        let t2 = c2 * k0;
        let t3 = s2 * dq1;
        let t4 = c2 * dq1;
        let t5 = s2 * ddq1;
        let t6 = c2 * ddq1;
        let t7 = t3 * t3;
        let t8 = dq2 * dq2;
        let t9 = t3 * t4;
        let t10 = dq2 * t3;
        let t11 = dq2 * t4;
        let t12 = t5 + t11;
        let dw2_y = t10 - t6;
        let t14 = t7 - t8;
        let t15 = t14 - t0;
        let t16 = ddq2 - t9;
        let t17 = ddq2 + t9;
        let t18 = t7 + t8;
        let t19 = t10 + dw2_y;
        let t20 = t11 + t12;
        let t21 = -t2;
        let t22 = -t9;
        let t23 = -t5;
        let t24 = -t6;
        put(44, t21); // row 2, MSX2
        put(45, t1); // row 2, MSY2R
        put(46, t22); // row 2, XX2R
        put(49, t23); // row 2, XZ2
        put(50, t24); // row 2, YZ2
        [
        t1, t2, t3, t4, t10, t11, t12, dw2_y,
        t14, t15, t16, t17, t18, t19, t20,
    ]
    };
    // XX2: column
    let t26 = {
        let t26 = c2 * t10;
        let t27 = s2 * t12 + t26;
        put(1, t27); // row 1, XX2R
        t26
    };
    // ZZ2: column
    {
        let t29 = s2 * t11 - t26;
        put(2, t29); // row 1, ZZ2R
    }
    // XY2: column
    {
        let t30 = t15 + t18;
        let t33 = c2 * t20 - s2 * t19;
        put(3, t33); // row 1, XY2
        put(48, t30); // row 2, XY2
    }
    // XZ2: column
    {
        let t36 = c2 * t14 - s2 * t17;
        put(4, t36); // row 1, XZ2
    }
    // YZ2: column
    {
        let t40 = s2 * (t18 - t0) - c2 * t16;
        put(5, t40); // row 1, YZ2
    }
    // link 3: motion
    let [
        t41, z1_3_y, t47, t50, a3_y, t56, w3_y, t62,
        t65, w3_z, dw3_z, t70, t71, t72, dw3_x, dw3_y,
        t75, t76, t77, t78, t79, t80, t81,
    ] = {
        let t41 = s2 * c3;
        let z1_3_y = s2 * s3;
        let t45 = k_L2 * t20;
        let t46 = t1 - k_L2 * t16;
        let t47 = k_L2 * t18 - t2;
        let t50 = c3 * t46 - s3 * t45;
        let a3_y = c3 * t45 + s3 * t46;
        let t56 = c3 * t3 - s3 * dq2;
        let w3_y = c3 * dq2 + s3 * t3;
        let t62 = c3 * t16 + s3 * t20;
        let t65 = s3 * t16 - c3 * t20;
        let w3_z = t4 + dq3;
        let dw3_z = ddq3 - dw2_y;
        let t68 = t56 * t56;
        let t69 = w3_z * w3_z;
        let t70 = t56 * w3_y;
        let t71 = t56 * w3_z;
        let t72 = w3_y * w3_z;
        let dw3_x = t65 + t72;
        let dw3_y = t62 + t71;
        let t75 = t69 - t68;
        let t76 = t18 + t75;
        let t77 = dw3_z + t70;
        let t78 = t70 - dw3_z;
        let t79 = t68 + t69;
        let t80 = t71 + dw3_y;
        let t81 = t72 + dw3_x;
        put(89, a3_y); // row 3, MSX3R
        put(90, t50); // row 3, MSY3R
        put(91, t70); // row 3, XX3R
        put(92, dw3_z); // row 3, ZZ3R
        put(94, t65); // row 3, XZ3
        put(95, t62); // row 3, YZ3
        [
        t41, z1_3_y, t47, t50, a3_y, t56, w3_y, t62,
        t65, w3_z, dw3_z, t70, t71, t72, dw3_x, dw3_y,
        t75, t76, t77, t78, t79, t80, t81,
    ]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, z2_4_x, t89] = {
        let z1_4_x = c2 * s4 - c4 * t41;
        let z1_4_y = c2 * c4 + s4 * t41;
        let z2_4_x = s3 * c4;
        let t89 = s3 * s4;
        [z1_4_x, z1_4_y, z2_4_x, t89]
    };
    // joint axes in frame 5
    let [z1_5_x, t95, z2_5_x, t101, t102, z3_5_x, z3_6_z] = {
        let z1_5_x = c5 * z1_4_x + s5 * z1_3_y;
        let t95 = s5 * z1_4_x - c5 * z1_3_y;
        let z2_5_x = c5 * z2_4_x + c3 * s5;
        let t101 = s5 * z2_4_x - c3 * c5;
        let t102 = c4 * k_A;
        let z3_5_x = s4 * c5;
        let z3_6_z = s4 * s5;
        [z1_5_x, t95, z2_5_x, t101, t102, z3_5_x, z3_6_z]
    };
    // MSX3: column
    let t116 = {
        let t105 = k_L2 * t78;
        let t107 = t47 - k_L2 * t76;
        let t112 = c2 * a3_y - (t41 * t105 - z1_3_y * t107);
        let t115 = s3 * t105 + c3 * t107;
        let t116 = s3 * t78;
        put(6, t112); // row 1, MSX3R
        put(51, t115); // row 2, MSX3R
        t116
    };
    // MSY3: column
    let t128 = {
        let t118 = k_L2 * t77;
        let t119 = k_L2 * t79 - t47;
        let t124 = c2 * t50 - (t41 * t119 + z1_3_y * t118);
        let t127 = s3 * t119 - c3 * t118;
        let t128 = c3 * t77;
        put(7, t124); // row 1, MSY3R
        put(52, t127); // row 2, MSY3R
        t128
    };
    // XX3: column
    let [t130, t135] = {
        let t130 = z1_3_y * t71;
        let t133 = c2 * t70 - (t41 * dw3_x + t130);
        let t135 = c3 * t71;
        let t136 = s3 * dw3_x - t135;
        put(8, t133); // row 1, XX3R
        put(53, t136); // row 2, XX3R
        [t130, t135]
    };
    // ZZ3: column
    {
        let t140 = c2 * dw3_z + (t130 - t41 * t72);
        let t142 = t135 + s3 * t72;
        put(9, t140); // row 1, ZZ3R
        put(54, t142); // row 2, ZZ3R
    }
    // XY3: column
    {
        let t143 = t79 - t76;
        let t148 = c2 * t143 + (z1_3_y * t81 - t41 * t80);
        let t151 = s3 * t80 + c3 * t81;
        put(10, t148); // row 1, XY3R
        put(55, t151); // row 2, XY3R
        put(93, t143); // row 3, XY3R
    }
    // XZ3: column
    {
        let t156 = c2 * t65 + (t41 * t78 + z1_3_y * t75);
        let t158 = c3 * t75 - t116;
        put(11, t156); // row 1, XZ3
        put(56, t158); // row 2, XZ3
    }
    // YZ3: column
    {
        let t159 = t18 - t79;
        let t164 = c2 * t62 + (z1_3_y * t77 - t41 * t159);
        let t166 = t128 + s3 * t159;
        put(12, t164); // row 1, YZ3
        put(57, t166); // row 2, YZ3
    }
    // link 4: motion
    let [
        t171, t175, a4_y, w4_x, w4_y, t187, t190, w4_z,
        dw4_z, t195, t196, t197, dw4_x, t199, t200, t201,
        t202, t203, t204, t205, t206,
    ] = {
        let t170 = t50 + k_A * t76;
        let t171 = k_A * t78 - a3_y;
        let t172 = t47 + k_A * t80;
        let t175 = c4 * t170 + s4 * t172;
        let a4_y = s4 * t170 - c4 * t172;
        let w4_x = s4 * w3_z - c4 * t56;
        let w4_y = c4 * w3_z + s4 * t56;
        let t187 = c4 * t77 - s4 * t81;
        let t190 = c4 * t81 + s4 * t77;
        let w4_z = dq4 - w3_y;
        let dw4_z = ddq4 - dw3_y;
        let t193 = w4_x * w4_x;
        let t194 = w4_z * w4_z;
        let t195 = w4_x * w4_y;
        let t196 = w4_x * w4_z;
        let t197 = w4_y * w4_z;
        let dw4_x = t190 + t197;
        let t199 = t187 - t196;
        let t200 = t194 - t193;
        let t201 = t79 + t200;
        let t202 = t195 - dw4_z;
        let t203 = dw4_z + t195;
        let t204 = t193 + t194;
        let t205 = t199 - t196;
        let t206 = t197 + dw4_x;
        let t207 = -t195;
        put(127, a4_y); // row 4, MSX4R
        put(128, t175); // row 4, MSY4R
        put(129, t207); // row 4, XX4R
        put(130, dw4_z); // row 4, ZZ4R
        put(132, t190); // row 4, XZ4
        put(133, t187); // row 4, YZ4
        [
        t171, t175, a4_y, w4_x, w4_y, t187, t190, w4_z,
        dw4_z, t195, t196, t197, dw4_x, t199, t200, t201,
        t202, t203, t204, t205, t206,
    ]
    };
    // XX4: column
    let [t209, t214, t219] = {
        let t209 = t196 * z1_4_y;
        let t212 = z1_3_y * t195 + (dw4_x * z1_4_x + t209);
        let t214 = t196 * t89;
        let t217 = c3 * t195 + (dw4_x * z2_4_x - t214);
        let t219 = c4 * t196;
        let t220 = s4 * dw4_x + t219;
        put(15, t212); // row 1, XX4R
        put(60, t217); // row 2, XX4R
        put(98, t220); // row 3, XX4R
        [t209, t214, t219]
    };
    // ZZ4: column
    {
        let t224 = t197 * z1_4_x - t209 - z1_3_y * dw4_z;
        let t228 = t214 + t197 * z2_4_x - c3 * dw4_z;
        let t230 = s4 * t197 - t219;
        put(16, t224); // row 1, ZZ4R
        put(61, t228); // row 2, ZZ4R
        put(99, t230); // row 3, ZZ4R
    }
    // XY4: column
    {
        let t231 = t204 - t201;
        let t236 = t205 * z1_4_x + t206 * z1_4_y - z1_3_y * t231;
        let t241 = t205 * z2_4_x - t206 * t89 - c3 * t231;
        let t244 = s4 * t205 + c4 * t206;
        put(17, t236); // row 1, XY4R
        put(62, t241); // row 2, XY4R
        put(100, t244); // row 3, XY4R
        put(131, t231); // row 4, XY4R
    }
    // XZ4: column
    {
        let t249 = t203 * z1_4_x + t200 * z1_4_y - z1_3_y * t190;
        let t254 = t203 * z2_4_x - t200 * t89 - c3 * t190;
        let t257 = s4 * t203 + c4 * t200;
        put(18, t249); // row 1, XZ4
        put(63, t254); // row 2, XZ4
        put(101, t257); // row 3, XZ4
    }
    // YZ4: column
    {
        let t258 = t79 - t204;
        let t263 = z1_4_x * t258 - t202 * z1_4_y - z1_3_y * t187;
        let t268 = z2_4_x * t258 + t202 * t89 - c3 * t187;
        let t271 = s4 * t258 - c4 * t202;
        put(19, t263); // row 1, YZ4
        put(64, t268); // row 2, YZ4
        put(102, t271); // row 3, YZ4
    }
    // link 5: motion
    let [
        t274, a5_z, t286, a5_y, w5_x, t295, t298, t301,
        w5_z, dw5_z, t306, t307, t308, t309, dw5_y, t311,
        t312, t313, t314, t315, t316, t317,
    ] = {
        let t274 = k_A * t205;
        let t281 = t175 - (k_A * t201 + k_L3 * t202);
        let a5_z = a4_y - (k_A * t203 + k_L3 * t204);
        let t283 = t171 + (t274 + k_L3 * t206);
        let t286 = c5 * t281 + s5 * t283;
        let a5_y = s5 * t281 - c5 * t283;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t295 = c5 * w4_z + s5 * w4_x;
        let t298 = c5 * t202 - s5 * t206;
        let t301 = c5 * t206 + s5 * t202;
        let w5_z = w4_y + dq5;
        let dw5_z = t199 + ddq5;
        let t304 = w5_x * w5_x;
        let t305 = w5_z * w5_z;
        let t306 = w5_x * t295;
        let t307 = w5_x * w5_z;
        let t308 = t295 * w5_z;
        let t309 = t308 - t301;
        let dw5_y = t298 - t307;
        let t311 = t304 - t305;
        let t312 = t311 - t204;
        let t313 = dw5_z + t306;
        let t314 = dw5_z - t306;
        let t315 = t304 + t305;
        let t316 = dw5_y - t307;
        let t317 = t308 + t309;
        put(158, a5_y); // row 5, MSX5
        put(159, t286); // row 5, MSY5R
        put(160, t306); // row 5, XX5R
        put(161, dw5_z); // row 5, ZZ5R
        put(163, t301); // row 5, XZ5
        put(164, t298); // row 5, YZ5
        [
        t274, a5_z, t286, a5_y, w5_x, t295, t298, t301,
        w5_z, dw5_z, t306, t307, t308, t309, dw5_y, t311,
        t312, t313, t314, t315, t316, t317,
    ]
    };
    // MSX4: column
    let [t319, t322] = {
        let t319 = t102 + k_L2 * s4;
        let t322 = s4 * k_A - k_L2 * c4;
        let t323 = t205 * t322;
        let t328 = t205 * t319 - t171;
        let t329 = t201 * t322 - t203 * t319 - a4_y;
        let t334 = z1_3_y * t329 + (z1_4_x * t323 + z1_4_y * t328);
        let t339 = c3 * t329 - (t89 * t328 - z2_4_x * t323);
        let t341 = t274 - c4 * t171;
        put(13, t334); // row 1, MSX4R
        put(58, t339); // row 2, MSX4R
        put(96, t341); // row 3, MSX4R
        [t319, t322]
    };
    // MSY4: column
    {
        let t343 = t206 * t319;
        let t347 = t206 * t322 - t171;
        let t348 = t204 * t319 - t202 * t322 - t175;
        let t353 = z1_3_y * t348 - (z1_4_x * t347 + z1_4_y * t343);
        let t358 = c3 * t348 - (z2_4_x * t347 - t89 * t343);
        let t361 = s4 * t171 - k_A * t206;
        put(14, t353); // row 1, MSY4R
        put(59, t358); // row 2, MSY4R
        put(97, t361); // row 3, MSY4R
    }
    // MSX5: column
    let [t363, t368, t369] = {
        let t363 = s5 * t314;
        let t364 = t363 - c5 * t312;
        let t367 = s5 * t312 + c5 * t314;
        let t368 = s5 * a5_z;
        let t369 = c5 * a5_z;
        let t374 = k_A * t367;
        let t375 = k_L3 * t367 - t368;
        let t376 = t369 + (k_L3 * t364 + k_A * t316);
        let t377 = a5_y - t374;
        let t383 = t322 * t367 - t375;
        let t384 = t377 + t319 * t367;
        let t385 = t316 * t319 + t322 * t364 - t376;
        let t390 = z1_3_y * t385 + (z1_4_x * t383 + z1_4_y * t384);
        let t395 = c3 * t385 + (z2_4_x * t383 - t89 * t384);
        let t399 = t374 + (c4 * t377 - s4 * t375);
        put(20, t390); // row 1, MSX5
        put(65, t395); // row 2, MSX5
        put(103, t399); // row 3, MSX5
        put(134, t376); // row 4, MSX5
        [t363, t368, t369]
    };
    // MSY5: column
    let t400 = {
        let t400 = c5 * t313;
        let t402 = t400 - s5 * t315;
        let t405 = s5 * t313 + c5 * t315;
        let t410 = k_A * t405;
        let t411 = t369 + k_L3 * t405;
        let t412 = k_L3 * t402 + k_A * t317 - t368;
        let t413 = t286 + t410;
        let t419 = t322 * t405 - t411;
        let t420 = t319 * t405 - t413;
        let t421 = t317 * t319 + t322 * t402 - t412;
        let t426 = z1_3_y * t421 - (z1_4_x * t419 + z1_4_y * t420);
        let t431 = c3 * t421 - (z2_4_x * t419 - t89 * t420);
        let t435 = s4 * t411 + c4 * t413 - t410;
        put(21, t426); // row 1, MSY5R
        put(66, t431); // row 2, MSY5R
        put(104, t435); // row 3, MSY5R
        put(135, t412); // row 4, MSY5R
        t400
    };
    // XX5: column
    let [t437, t442, t447, t452] = {
        let t437 = t307 * t95;
        let t440 = t306 * z1_4_y - (t309 * z1_5_x + t437);
        let t442 = t307 * t101;
        let t447 = t307 * z3_6_z;
        let t450 = c4 * t306 - (t309 * z3_5_x + t447);
        let t452 = c5 * t307;
        let t453 = s5 * t309 - t452;
        let t454 = -(t306 * t89 + (t309 * z2_5_x + t442));
        put(22, t440); // row 1, XX5R
        put(67, t454); // row 2, XX5R
        put(105, t450); // row 3, XX5R
        put(136, t453); // row 4, XX5R
        [t437, t442, t447, t452]
    };
    // ZZ5: column
    {
        let t458 = dw5_z * z1_4_y + (t437 - t308 * z1_5_x);
        let t462 = t442 - t308 * z2_5_x - dw5_z * t89;
        let t466 = c4 * dw5_z + (t447 - t308 * z3_5_x);
        let t468 = t452 + s5 * t308;
        put(23, t458); // row 1, ZZ5R
        put(68, t462); // row 2, ZZ5R
        put(106, t466); // row 3, ZZ5R
        put(137, t468); // row 4, ZZ5R
    }
    // XY5: column
    {
        let t469 = t312 + t315;
        let t474 = z1_4_y * t469 + (t316 * z1_5_x + t317 * t95);
        let t479 = t316 * z2_5_x + t317 * t101 - t89 * t469;
        let t484 = c4 * t469 + (t316 * z3_5_x + t317 * z3_6_z);
        let t487 = c5 * t317 - s5 * t316;
        put(24, t474); // row 1, XY5
        put(69, t479); // row 2, XY5
        put(107, t484); // row 3, XY5
        put(138, t487); // row 4, XY5
        put(162, t469); // row 5, XY5
    }
    // XZ5: column
    {
        let t492 = t301 * z1_4_y + (t314 * z1_5_x + t311 * t95);
        let t497 = t314 * z2_5_x + t311 * t101 - t301 * t89;
        let t502 = c4 * t301 + (t314 * z3_5_x + t311 * z3_6_z);
        let t504 = c5 * t311 - t363;
        put(25, t492); // row 1, XZ5
        put(70, t497); // row 2, XZ5
        put(108, t502); // row 3, XZ5
        put(139, t504); // row 4, XZ5
    }
    // YZ5: column
    {
        let t505 = t315 - t204;
        let t510 = t298 * z1_4_y - (z1_5_x * t505 + t313 * t95);
        let t520 = c4 * t298 - (z3_5_x * t505 + t313 * z3_6_z);
        let t522 = s5 * t505 - t400;
        let t523 = -(t298 * t89 + (z2_5_x * t505 + t313 * t101));
        put(26, t510); // row 1, YZ5
        put(71, t523); // row 2, YZ5
        put(109, t520); // row 3, YZ5
        put(140, t522); // row 4, YZ5
    }
    // link 6: motion
    let [
        t526, a6_y, w6_x, t535, t538, t541, w6_z, dw6_z,
        t546, t547, t548, t549, dw6_y, t551, t552, t553,
        t554, t555, t556, t557,
    ] = {
        let t526 = c6 * t286 - s6 * a5_z;
        let a6_y = c6 * a5_z + s6 * t286;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let t535 = s6 * w5_x - c6 * w5_z;
        let t538 = c6 * t313 + s6 * t317;
        let t541 = s6 * t313 - c6 * t317;
        let w6_z = t295 + dq6;
        let dw6_z = ddq6 - dw5_y;
        let t544 = w6_x * w6_x;
        let t545 = w6_z * w6_z;
        let t546 = w6_x * t535;
        let t547 = w6_x * w6_z;
        let t548 = t535 * w6_z;
        let t549 = t548 - t541;
        let dw6_y = t538 - t547;
        let t551 = t545 - t544;
        let t552 = t315 + t551;
        let t553 = dw6_z + t546;
        let t554 = t546 - dw6_z;
        let t555 = t544 + t545;
        let t556 = dw6_y - t547;
        let t557 = t548 + t549;
        put(182, a6_y); // row 6, MSX6R
        put(183, t526); // row 6, MSY6R
        put(184, t546); // row 6, XX6R
        put(185, dw6_z); // row 6, ZZ6R
        put(187, t541); // row 6, XZ6
        put(188, t538); // row 6, YZ6
        [
        t526, a6_y, w6_x, t535, t538, t541, w6_z, dw6_z,
        t546, t547, t548, t549, dw6_y, t551, t552, t553,
        t554, t555, t556, t557,
    ]
    };
    // MSX6: column
    let [t559, t562, t564, t565] = {
        let t559 = s6 * t554;
        let t560 = c6 * t552 - t559;
        let t562 = c6 * t554;
        let t563 = s6 * t552 + t562;
        let t564 = s6 * a5_y;
        let t565 = c6 * a5_y;
        let t568 = c5 * t560 + s5 * t556;
        let t571 = c5 * t556 - s5 * t560;
        let t582 = k_A * t571;
        let t583 = c5 * t564 - s5 * a6_y + k_L3 * t571;
        let t584 = s5 * t564 + c5 * a6_y + (k_L3 * t568 + k_A * t563);
        let t585 = t565 - t582;
        let t591 = t322 * t571 - t583;
        let t592 = t585 + t319 * t571;
        let t593 = t319 * t563 + t322 * t568 - t584;
        let t598 = z1_3_y * t593 + (z1_4_x * t591 + z1_4_y * t592);
        let t603 = c3 * t593 + (z2_4_x * t591 - t89 * t592);
        let t607 = t582 + (c4 * t585 - s4 * t583);
        let t608 = -t564;
        put(27, t598); // row 1, MSX6R
        put(72, t603); // row 2, MSX6R
        put(110, t607); // row 3, MSX6R
        put(141, t584); // row 4, MSX6R
        put(165, t565); // row 5, MSX6R
        put(166, t608); // row 5, MSY6R
        [t559, t562, t564, t565]
    };
    // MSY6: column
    let [t609, t612] = {
        let t609 = c6 * t553;
        let t611 = s6 * t555 - t609;
        let t612 = s6 * t553;
        let t614 = t612 + c6 * t555;
        let t617 = c5 * t611 - s5 * t557;
        let t620 = s5 * t611 + c5 * t557;
        let t631 = k_A * t620;
        let t632 = c5 * t565 - s5 * t526 + k_L3 * t620;
        let t633 = s5 * t565 + c5 * t526 + (k_A * t614 - k_L3 * t617);
        let t634 = t564 + t631;
        let t640 = t632 - t322 * t620;
        let t641 = t319 * t620 - t634;
        let t642 = t319 * t614 - t322 * t617 - t633;
        let t647 = z1_3_y * t642 - (z1_4_x * t640 - z1_4_y * t641);
        let t652 = c3 * t642 - (z2_4_x * t640 + t89 * t641);
        let t656 = t631 - (s4 * t632 + c4 * t634);
        put(28, t647); // row 1, MSY6R
        put(73, t652); // row 2, MSY6R
        put(111, t656); // row 3, MSY6R
        put(142, t633); // row 4, MSY6R
        [t609, t612]
    };
    // link 7: motion
    let [
        t661, t665, a7_y, t677, t680, dw7_z, t685, t686,
        t687, dw7_x, t690, t691, t692, t693, t694, t695,
        t696,
    ] = {
        let t660 = t526 + k4 * t552;
        let t661 = k4 * t554 - a6_y;
        let t662 = a5_y + k4 * t556;
        let t665 = c7 * t660 + s7 * t662;
        let a7_y = s7 * t660 - c7 * t662;
        let w7_x = c7 * w6_x + s7 * w6_z;
        let w7_y = c7 * w6_z - s7 * w6_x;
        let t677 = c7 * t553 + s7 * t557;
        let t680 = s7 * t553 - c7 * t557;
        let w7_z = t535 + dq7;
        let dw7_z = ddq7 - dw6_y;
        let t683 = w7_x * w7_x;
        let t684 = w7_z * w7_z;
        let t685 = w7_x * w7_y;
        let t686 = w7_x * w7_z;
        let t687 = w7_y * w7_z;
        let dw7_x = t680 + t687;
        let t690 = t683 - t684;
        let t691 = t555 - t690;
        let t692 = dw7_z - t685;
        let t693 = dw7_z + t685;
        let t694 = t683 + t684;
        let t695 = t677 - t686 - t686;
        let t696 = t687 + dw7_x;
        let t697 = -t685;
        put(199, a7_y); // row 7, MSX7
        put(200, t665); // row 7, MSY7
        put(201, t697); // row 7, XX7R
        put(202, dw7_z); // row 7, ZZ7
        put(204, t680); // row 7, XZ7
        put(205, t677); // row 7, YZ7
        [
        t661, t665, a7_y, t677, t680, dw7_z, t685, t686,
        t687, dw7_x, t690, t691, t692, t693, t694, t695,
        t696,
    ]
    };
    // XX6: column
    let [t699, t702] = {
        let t699 = s6 * t547;
        let t700 = c6 * t549 + t699;
        let t702 = c6 * t547;
        let t703 = t702 - s6 * t549;
        let t708 = z1_4_y * t703 + (t546 * t95 - z1_5_x * t700);
        let t713 = t546 * t101 - z2_5_x * t700 - t89 * t703;
        let t718 = c4 * t703 + (t546 * z3_6_z - z3_5_x * t700);
        let t721 = s5 * t700 + c5 * t546;
        put(29, t708); // row 1, XX6R
        put(74, t713); // row 2, XX6R
        put(112, t718); // row 3, XX6R
        put(143, t721); // row 4, XX6R
        put(167, t703); // row 5, XX6R
        [t699, t702]
    };
    // ZZ6: column
    {
        let t723 = c6 * t548 - t699;
        let t725 = t702 + s6 * t548;
        let t730 = dw6_z * t95 - z1_5_x * t723 - z1_4_y * t725;
        let t735 = t89 * t725 + (dw6_z * t101 - z2_5_x * t723);
        let t740 = dw6_z * z3_6_z - z3_5_x * t723 - c4 * t725;
        let t743 = s5 * t723 + c5 * dw6_z;
        let t744 = -t725;
        put(30, t730); // row 1, ZZ6R
        put(75, t735); // row 2, ZZ6R
        put(113, t740); // row 3, ZZ6R
        put(144, t743); // row 4, ZZ6R
        put(168, t744); // row 5, ZZ6R
    }
    // XY6: column
    {
        let t745 = t555 - t552;
        let t748 = c6 * t556 + s6 * t557;
        let t751 = s6 * t556 - c6 * t557;
        let t756 = z1_4_y * t751 + (z1_5_x * t748 + t95 * t745);
        let t761 = z2_5_x * t748 + t101 * t745 - t89 * t751;
        let t766 = c4 * t751 + (z3_5_x * t748 + z3_6_z * t745);
        let t769 = c5 * t745 - s5 * t748;
        put(31, t756); // row 1, XY6R
        put(76, t761); // row 2, XY6R
        put(114, t766); // row 3, XY6R
        put(145, t769); // row 4, XY6R
        put(169, t751); // row 5, XY6R
        put(186, t745); // row 6, XY6R
    }
    // XZ6: column
    {
        let t771 = t562 + s6 * t551;
        let t773 = c6 * t551 - t559;
        let t778 = z1_4_y * t773 - (z1_5_x * t771 - t541 * t95);
        let t783 = t541 * t101 - z2_5_x * t771 - t89 * t773;
        let t788 = c4 * t773 - (z3_5_x * t771 - t541 * z3_6_z);
        let t791 = s5 * t771 + c5 * t541;
        put(32, t778); // row 1, XZ6
        put(77, t783); // row 2, XZ6
        put(115, t788); // row 3, XZ6
        put(146, t791); // row 4, XZ6
        put(170, t773); // row 5, XZ6
    }
    // YZ6: column
    {
        let t792 = t315 - t555;
        let t794 = t612 - c6 * t792;
        let t796 = t609 + s6 * t792;
        let t801 = z1_4_y * t796 + (t538 * t95 - z1_5_x * t794);
        let t806 = t538 * t101 - z2_5_x * t794 - t89 * t796;
        let t811 = c4 * t796 + (t538 * z3_6_z - z3_5_x * t794);
        let t814 = s5 * t794 + c5 * t538;
        put(33, t801); // row 1, YZ6
        put(78, t806); // row 2, YZ6
        put(116, t811); // row 3, YZ6
        put(147, t814); // row 4, YZ6
        put(171, t796); // row 5, YZ6
    }
    // MSX7: column
    let [t816, t819, t821, t822] = {
        let t816 = s7 * t693;
        let t817 = c7 * t691 + t816;
        let t819 = c7 * t693;
        let t820 = s7 * t691 - t819;
        let t821 = s7 * t661;
        let t822 = c7 * t661;
        let t825 = k4 * t695 - t822;
        let t826 = a7_y - k4 * t820;
        let t829 = c6 * t817 + s6 * t695;
        let t832 = s6 * t817 - c6 * t695;
        let t835 = c6 * t821 + s6 * t826;
        let t838 = s6 * t821 - c6 * t826;
        let t841 = c5 * t829 + s5 * t820;
        let t844 = s5 * t829 - c5 * t820;
        let t855 = k_A * t844;
        let t856 = c5 * t835 + s5 * t825 + k_L3 * t844;
        let t857 = c5 * t825 - s5 * t835 + (k_L3 * t841 + k_A * t832);
        let t858 = t838 + t855;
        let t864 = t856 - t322 * t844;
        let t865 = t319 * t844 - t858;
        let t866 = t319 * t832 + t322 * t841 - t857;
        let t871 = z1_3_y * t866 + (z1_4_x * t864 - z1_4_y * t865);
        let t876 = c3 * t866 + (z2_4_x * t864 + t89 * t865);
        let t880 = s4 * t856 + c4 * t858 - t855;
        put(34, t871); // row 1, MSX7
        put(79, t876); // row 2, MSX7
        put(117, t880); // row 3, MSX7
        put(148, t857); // row 4, MSX7
        put(172, t838); // row 5, MSX7
        put(189, t825); // row 6, MSX7
        [t816, t819, t821, t822]
    };
    // MSY7: column
    let [t881, t884] = {
        let t881 = c7 * t692;
        let t883 = t881 - s7 * t694;
        let t884 = s7 * t692;
        let t886 = t884 + c7 * t694;
        let t889 = t821 - k4 * t696;
        let t890 = k4 * t886 - t665;
        let t893 = c6 * t883 - s6 * t696;
        let t896 = s6 * t883 + c6 * t696;
        let t899 = c6 * t822 - s6 * t890;
        let t902 = s6 * t822 + c6 * t890;
        let t905 = c5 * t893 + s5 * t886;
        let t908 = s5 * t893 - c5 * t886;
        let t919 = k_A * t908;
        let t920 = c5 * t899 + s5 * t889 + k_L3 * t908;
        let t921 = c5 * t889 - s5 * t899 + (k_L3 * t905 + k_A * t896);
        let t922 = t902 + t919;
        let t928 = t322 * t908 - t920;
        let t929 = t922 - t319 * t908;
        let t930 = t319 * t896 + t322 * t905 - t921;
        let t935 = z1_3_y * t930 - (z1_4_x * t928 - z1_4_y * t929);
        let t940 = c3 * t930 - (z2_4_x * t928 + t89 * t929);
        let t944 = s4 * t920 + c4 * t922 - t919;
        put(35, t935); // row 1, MSY7
        put(80, t940); // row 2, MSY7
        put(118, t944); // row 3, MSY7
        put(149, t921); // row 4, MSY7
        put(173, t902); // row 5, MSY7
        put(190, t889); // row 6, MSY7
        [t881, t884]
    };
    // XX7: column
    let [t946, t949] = {
        let t946 = s7 * t686;
        let t947 = c7 * dw7_x - t946;
        let t949 = c7 * t686;
        let t950 = s7 * dw7_x + t949;
        let t953 = c6 * t947 - s6 * t685;
        let t956 = s6 * t947 + c6 * t685;
        let t961 = z1_4_y * t956 + (z1_5_x * t953 + t95 * t950);
        let t966 = z2_5_x * t953 + t101 * t950 - t89 * t956;
        let t971 = c4 * t956 + (z3_5_x * t953 + z3_6_z * t950);
        let t974 = c5 * t950 - s5 * t953;
        put(36, t961); // row 1, XX7R
        put(81, t966); // row 2, XX7R
        put(119, t971); // row 3, XX7R
        put(150, t974); // row 4, XX7R
        put(174, t956); // row 5, XX7R
        put(191, t950); // row 6, XX7R
        [t946, t949]
    };
    // ZZ7: column
    {
        let t976 = t946 + c7 * t687;
        let t978 = s7 * t687 - t949;
        let t981 = c6 * t976 + s6 * dw7_z;
        let t984 = s6 * t976 - c6 * dw7_z;
        let t989 = z1_4_y * t984 + (z1_5_x * t981 + t95 * t978);
        let t994 = z2_5_x * t981 + t101 * t978 - t89 * t984;
        let t999 = c4 * t984 + (z3_5_x * t981 + z3_6_z * t978);
        let t1002 = c5 * t978 - s5 * t981;
        put(37, t989); // row 1, ZZ7
        put(82, t994); // row 2, ZZ7
        put(120, t999); // row 3, ZZ7
        put(151, t1002); // row 4, ZZ7
        put(175, t984); // row 5, ZZ7
        put(192, t978); // row 6, ZZ7
    }
    // XY7: column
    {
        let t1003 = t694 - t691;
        let t1006 = c7 * t695 - s7 * t696;
        let t1009 = s7 * t695 + c7 * t696;
        let t1012 = c6 * t1006 + s6 * t1003;
        let t1015 = s6 * t1006 - c6 * t1003;
        let t1020 = z1_4_y * t1015 + (z1_5_x * t1012 + t95 * t1009);
        let t1025 = z2_5_x * t1012 + t101 * t1009 - t89 * t1015;
        let t1030 = c4 * t1015 + (z3_5_x * t1012 + z3_6_z * t1009);
        let t1033 = c5 * t1009 - s5 * t1012;
        put(38, t1020); // row 1, XY7
        put(83, t1025); // row 2, XY7
        put(121, t1030); // row 3, XY7
        put(152, t1033); // row 4, XY7
        put(176, t1015); // row 5, XY7
        put(193, t1009); // row 6, XY7
        put(203, t1003); // row 7, XY7
    }
    // XZ7: column
    {
        let t1035 = t819 + s7 * t690;
        let t1037 = t816 - c7 * t690;
        let t1040 = c6 * t1035 + s6 * t680;
        let t1043 = s6 * t1035 - c6 * t680;
        let t1048 = z1_4_y * t1043 + (z1_5_x * t1040 + t95 * t1037);
        let t1053 = z2_5_x * t1040 + t101 * t1037 - t89 * t1043;
        let t1058 = c4 * t1043 + (z3_5_x * t1040 + z3_6_z * t1037);
        let t1061 = c5 * t1037 - s5 * t1040;
        put(39, t1048); // row 1, XZ7
        put(84, t1053); // row 2, XZ7
        put(122, t1058); // row 3, XZ7
        put(153, t1061); // row 4, XZ7
        put(177, t1043); // row 5, XZ7
        put(194, t1037); // row 6, XZ7
    }
    // YZ7: column
    {
        let t1062 = t555 - t694;
        let t1064 = c7 * t1062 - t884;
        let t1066 = t881 + s7 * t1062;
        let t1069 = c6 * t1064 + s6 * t677;
        let t1072 = s6 * t1064 - c6 * t677;
        let t1077 = z1_4_y * t1072 + (z1_5_x * t1069 + t95 * t1066);
        let t1082 = z2_5_x * t1069 + t101 * t1066 - t89 * t1072;
        let t1087 = c4 * t1072 + (z3_5_x * t1069 + z3_6_z * t1066);
        let t1090 = c5 * t1066 - s5 * t1069;
        let t1091 = dq1.sign();
        let t1092 = dq2.sign();
        let t1093 = dq3.sign();
        let t1094 = dq4.sign();
        let t1095 = dq5.sign();
        let t1096 = dq6.sign();
        let t1097 = dq7.sign();
        put(40, t1077); // row 1, YZ7
        put(42, t1091); // row 1, FC1
        put(85, t1082); // row 2, YZ7
        put(87, t1092); // row 2, FC2
        put(123, t1087); // row 3, YZ7
        put(125, t1093); // row 3, FC3
        put(154, t1090); // row 4, YZ7
        put(156, t1094); // row 4, FC4
        put(178, t1072); // row 5, YZ7
        put(180, t1095); // row 5, FC5
        put(195, t1066); // row 6, YZ7
        put(197, t1096); // row 6, FC6
        put(207, t1097); // row 7, FC7
    }
}
