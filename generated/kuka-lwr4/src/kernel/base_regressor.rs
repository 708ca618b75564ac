//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil
//! and Dombre, 12.4.
//!
//! 597 multiplications, 426 additions; 7 x 57, 202 of 399 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 202;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11),
    (0, 12), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18), (0, 19), (0, 20), (0, 21),
    (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28), (0, 29), (0, 30), (0, 31),
    (0, 32), (0, 33), (0, 34), (0, 35), (0, 36), (0, 37), (0, 38), (0, 39), (0, 40), (0, 41),
    (0, 42), (0, 43), (0, 50), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7),
    (1, 8), (1, 9), (1, 10), (1, 11), (1, 12), (1, 13), (1, 14), (1, 15), (1, 16), (1, 17),
    (1, 18), (1, 19), (1, 20), (1, 21), (1, 22), (1, 23), (1, 24), (1, 25), (1, 26), (1, 27),
    (1, 28), (1, 29), (1, 30), (1, 31), (1, 32), (1, 33), (1, 34), (1, 35), (1, 36), (1, 37),
    (1, 38), (1, 39), (1, 40), (1, 41), (1, 42), (1, 44), (1, 51), (2, 8), (2, 9), (2, 10),
    (2, 11), (2, 12), (2, 13), (2, 14), (2, 15), (2, 16), (2, 17), (2, 18), (2, 19), (2, 20),
    (2, 21), (2, 22), (2, 23), (2, 24), (2, 25), (2, 26), (2, 27), (2, 28), (2, 29), (2, 30),
    (2, 31), (2, 32), (2, 33), (2, 34), (2, 35), (2, 36), (2, 37), (2, 38), (2, 39), (2, 40),
    (2, 41), (2, 42), (2, 45), (2, 52), (3, 15), (3, 16), (3, 17), (3, 18), (3, 19), (3, 20),
    (3, 21), (3, 22), (3, 23), (3, 24), (3, 25), (3, 26), (3, 27), (3, 28), (3, 29), (3, 30),
    (3, 31), (3, 32), (3, 33), (3, 34), (3, 35), (3, 36), (3, 37), (3, 38), (3, 39), (3, 40),
    (3, 41), (3, 42), (3, 46), (3, 53), (4, 22), (4, 23), (4, 24), (4, 25), (4, 26), (4, 27),
    (4, 28), (4, 29), (4, 30), (4, 31), (4, 32), (4, 33), (4, 34), (4, 35), (4, 36), (4, 37),
    (4, 38), (4, 39), (4, 40), (4, 41), (4, 42), (4, 47), (4, 54), (5, 29), (5, 30), (5, 31),
    (5, 32), (5, 33), (5, 34), (5, 35), (5, 36), (5, 37), (5, 38), (5, 39), (5, 40), (5, 41),
    (5, 42), (5, 48), (5, 55), (6, 36), (6, 37), (6, 38), (6, 39), (6, 40), (6, 41), (6, 42),
    (6, 49), (6, 56),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 57 + PATTERN[k].1
}

/// Regressor `W_b` of the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 57]; 7]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[1..3]),
            41 => clear(&mut flat[44..50]),
            42 => clear(&mut flat[51..58]),
            84 => flat[100] = S::default(),
            85 => clear(&mut flat[102..108]),
            86 => clear(&mut flat[109..122]),
            121 => clear(&mut flat[157..159]),
            122 => clear(&mut flat[160..166]),
            123 => clear(&mut flat[167..186]),
            151 => clear(&mut flat[214..217]),
            152 => clear(&mut flat[218..224]),
            153 => clear(&mut flat[225..250]),
            174 => clear(&mut flat[271..275]),
            175 => clear(&mut flat[276..282]),
            176 => clear(&mut flat[283..314]),
            190 => clear(&mut flat[328..333]),
            191 => clear(&mut flat[334..340]),
            192 => clear(&mut flat[341..378]),
            199 => clear(&mut flat[385..391]),
            200 => clear(&mut flat[392..398]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 57]; 7]) {
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
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        put(0, ddq1); // row 1, ZZ1R
        put(41, dq1); // row 1, FV1
        put(46, ddq2); // row 2, ZZ2R
        put(85, dq2); // row 2, FV2
        put(122, dq3); // row 3, FV3
        put(152, dq4); // row 4, FV4
        put(175, dq5); // row 5, FV5
        put(191, dq6); // row 6, FV6
        put(200, dq7); // row 7, FV7
        t0
    };
    // link 2: motion
    let [
        a2_x, a2_y, w2_x, w2_y, t10, t11, dw2_x, dw2_y,
        t14, t15, t16, t17, t18, t19, t20,
    ] = {
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t5 = s2 * ddq1;
        let t6 = c2 * ddq1;
        let t7 = w2_x * w2_x;
        let t8 = dq2 * dq2;
        let t9 = w2_x * w2_y;
        let t10 = dq2 * w2_x;
        let t11 = dq2 * w2_y;
        let dw2_x = t5 + t11;
        let dw2_y = t6 - t10;
        let t14 = t7 - t8;
        let t15 = t14 - t0;
        let t16 = ddq2 - t9;
        let t17 = ddq2 + t9;
        let t18 = t7 + t8;
        let t19 = dw2_y - t10;
        let t20 = t11 + dw2_x;
        let t21 = -a2_x;
        let t22 = -t9;
        put(43, a2_y); // row 2, MSX2
        put(44, t21); // row 2, MSY2R
        put(45, t22); // row 2, XX2R
        put(48, t5); // row 2, XZ2
        put(49, t6); // row 2, YZ2
        [
        a2_x, a2_y, w2_x, w2_y, t10, t11, dw2_x, dw2_y,
        t14, t15, t16, t17, t18, t19, t20,
    ]
    };
    // XX2: column
    let t24 = {
        let t24 = c2 * t10;
        let t25 = s2 * dw2_x + t24;
        put(1, t25); // row 1, XX2R
        t24
    };
    // ZZ2: column
    {
        let t27 = s2 * t11 - t24;
        put(2, t27); // row 1, ZZ2R
    }
    // XY2: column
    {
        let t28 = t15 + t18;
        let t31 = s2 * t19 + c2 * t20;
        put(3, t31); // row 1, XY2
        put(47, t28); // row 2, XY2
    }
    // XZ2: column
    {
        let t34 = s2 * t17 - c2 * t14;
        put(4, t34); // row 1, XZ2
    }
    // YZ2: column
    {
        let t38 = s2 * (t0 - t18) + c2 * t16;
        put(5, t38); // row 1, YZ2
    }
    // link 3: motion
    let [
        z1_3_x, t40, a3_z, t48, a3_y, w3_x, t57, t60,
        t63, w3_z, dw3_z, t68, t69, t70, t71, t72,
        t73, t74, t75, t76, t77, t78, t79,
    ] = {
        let z1_3_x = s2 * c3;
        let t40 = s2 * s3;
        let t43 = k_L2 * t20;
        let t44 = k_L2 * t16 - a2_x;
        let a3_z = a2_y - k_L2 * t18;
        let t48 = c3 * t44 + s3 * t43;
        let a3_y = s3 * t44 - c3 * t43;
        let w3_x = c3 * w2_x - s3 * dq2;
        let t57 = c3 * dq2 + s3 * w2_x;
        let t60 = c3 * t16 + s3 * t20;
        let t63 = c3 * t20 - s3 * t16;
        let w3_z = w2_y + dq3;
        let dw3_z = dw2_y + ddq3;
        let t66 = w3_x * w3_x;
        let t67 = w3_z * w3_z;
        let t68 = w3_x * t57;
        let t69 = w3_x * w3_z;
        let t70 = t57 * w3_z;
        let t71 = t70 - t63;
        let t72 = t60 + t69;
        let t73 = t66 - t67;
        let t74 = t73 - t18;
        let t75 = dw3_z + t68;
        let t76 = t68 - dw3_z;
        let t77 = t66 + t67;
        let t78 = t69 + t72;
        let t79 = t70 + t71;
        let t80 = -t60;
        put(87, a3_y); // row 3, MSX3
        put(88, t48); // row 3, MSY3R
        put(89, t68); // row 3, XX3R
        put(90, dw3_z); // row 3, ZZ3R
        put(92, t63); // row 3, XZ3
        put(93, t80); // row 3, YZ3
        [
        z1_3_x, t40, a3_z, t48, a3_y, w3_x, t57, t60,
        t63, w3_z, dw3_z, t68, t69, t70, t71, t72,
        t73, t74, t75, t76, t77, t78, t79,
    ]
    };
    // joint axes in frame 4
    let [t83, z1_5_z, t87, z2_4_y] = {
        let t83 = c2 * s4 - c4 * z1_3_x;
        let z1_5_z = c2 * c4 + s4 * z1_3_x;
        let t87 = s3 * c4;
        let z2_4_y = s3 * s4;
        [t83, z1_5_z, t87, z2_4_y]
    };
    // joint axes in frame 5
    let [t91, z1_6_z, t97, t100, t101, z3_5_y] = {
        let t91 = c5 * t83 + s5 * t40;
        let z1_6_z = c5 * t40 - s5 * t83;
        let t97 = c5 * t87 + c3 * s5;
        let t100 = c3 * c5 - s5 * t87;
        let t101 = s4 * c5;
        let z3_5_y = s4 * s5;
        [t91, z1_6_z, t97, t100, t101, z3_5_y]
    };
    // MSX3: column
    {
        let t103 = k_L2 * t76;
        let t105 = a3_z - k_L2 * t74;
        let t110 = c2 * a3_y + (z1_3_x * t103 + t40 * t105);
        let t113 = c3 * t105 - s3 * t103;
        put(6, t110); // row 1, MSX3
        put(50, t113); // row 2, MSX3
    }
    // MSY3: column
    {
        let t115 = k_L2 * t75;
        let t116 = a3_z + k_L2 * t77;
        let t121 = c2 * t48 + (z1_3_x * t116 + t40 * t115);
        let t124 = c3 * t115 - s3 * t116;
        put(7, t121); // row 1, MSY3R
        put(51, t124); // row 2, MSY3R
    }
    // XX3: column
    let [t126, t131] = {
        let t126 = t40 * t69;
        let t129 = c2 * t68 - (z1_3_x * t71 + t126);
        let t131 = c3 * t69;
        let t132 = s3 * t71 - t131;
        put(8, t129); // row 1, XX3R
        put(52, t132); // row 2, XX3R
        [t126, t131]
    };
    // ZZ3: column
    {
        let t136 = c2 * dw3_z + (t126 - z1_3_x * t70);
        let t138 = t131 + s3 * t70;
        put(9, t136); // row 1, ZZ3R
        put(53, t138); // row 2, ZZ3R
    }
    // XY3: column
    {
        let t139 = t74 + t77;
        let t144 = c2 * t139 - (z1_3_x * t78 - t40 * t79);
        let t147 = s3 * t78 + c3 * t79;
        put(10, t144); // row 1, XY3
        put(54, t147); // row 2, XY3
        put(91, t139); // row 3, XY3
    }
    // XZ3: column
    {
        let t152 = c2 * t63 + (t40 * t73 - z1_3_x * t76);
        let t155 = s3 * t76 + c3 * t73;
        put(11, t152); // row 1, XZ3
        put(55, t155); // row 2, XZ3
    }
    // YZ3: column
    {
        let t156 = t77 - t18;
        let t164 = s3 * t156 - c3 * t75;
        let t165 = -(c2 * t60 + (z1_3_x * t156 + t40 * t75));
        put(12, t165); // row 1, YZ3
        put(56, t164); // row 2, YZ3
    }
    // link 4: motion
    let [
        t168, a4_y, w4_x, t177, t180, t183, w4_z, dw4_z,
        t188, t189, t190, t191, t192, t193, t194, t195,
        t196, t197, t198, t199,
    ] = {
        let t168 = c4 * t48 + s4 * a3_z;
        let a4_y = s4 * t48 - c4 * a3_z;
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t177 = c4 * w3_z + s4 * w3_x;
        let t180 = s4 * t79 - c4 * t75;
        let t183 = c4 * t79 + s4 * t75;
        let w4_z = dq4 - t57;
        let dw4_z = ddq4 - t72;
        let t186 = w4_x * w4_x;
        let t187 = w4_z * w4_z;
        let t188 = w4_x * t177;
        let t189 = w4_x * w4_z;
        let t190 = t177 * w4_z;
        let t191 = t183 + t190;
        let t192 = t189 - t180;
        let t193 = t186 - t187;
        let t194 = t193 - t77;
        let t195 = dw4_z + t188;
        let t196 = dw4_z - t188;
        let t197 = t186 + t187;
        let t198 = t189 + t192;
        let t199 = t190 + t191;
        let t200 = -t183;
        put(124, a4_y); // row 4, MSX4
        put(125, t168); // row 4, MSY4R
        put(126, t188); // row 4, XX4R
        put(127, dw4_z); // row 4, ZZ4R
        put(129, t200); // row 4, XZ4
        put(130, t180); // row 4, YZ4
        [
        t168, a4_y, w4_x, t177, t180, t183, w4_z, dw4_z,
        t188, t189, t190, t191, t192, t193, t194, t195,
        t196, t197, t198, t199,
    ]
    };
    // MSX4: column
    let [t202, t204, t205] = {
        let t202 = s4 * t196;
        let t204 = s4 * a3_y;
        let t205 = c4 * a3_y;
        let t208 = k_L2 * t198 - t204;
        let t209 = a4_y + k_L2 * (c4 * t194 - t202);
        let t214 = c2 * t205 - (z1_3_x * t208 + t40 * t209);
        let t217 = s3 * t208 - c3 * t209;
        let t218 = -t204;
        put(13, t214); // row 1, MSX4
        put(57, t217); // row 2, MSX4
        put(94, t205); // row 3, MSX4
        put(95, t218); // row 3, MSY4R
        [t202, t204, t205]
    };
    // MSY4: column
    let t219 = {
        let t219 = c4 * t195;
        let t224 = t205 + k_L2 * t199;
        let t225 = k_L2 * (t219 - s4 * t197) - t168;
        let t230 = z1_3_x * t224 + t40 * t225 - c2 * t204;
        let t233 = c3 * t225 - s3 * t224;
        put(14, t230); // row 1, MSY4R
        put(58, t233); // row 2, MSY4R
        t219
    };
    // XX4: column
    let [t235, t240, t245] = {
        let t235 = t189 * z1_5_z;
        let t238 = t191 * t83 - t235 - t40 * t188;
        let t240 = t189 * z2_4_y;
        let t243 = t191 * t87 + t240 - c3 * t188;
        let t245 = c4 * t189;
        let t246 = s4 * t191 - t245;
        put(15, t238); // row 1, XX4R
        put(59, t243); // row 2, XX4R
        put(96, t246); // row 3, XX4R
        [t235, t240, t245]
    };
    // ZZ4: column
    {
        let t250 = t235 + t190 * t83 - t40 * dw4_z;
        let t254 = t190 * t87 - t240 - c3 * dw4_z;
        let t256 = t245 + s4 * t190;
        put(16, t250); // row 1, ZZ4R
        put(60, t254); // row 2, ZZ4R
        put(97, t256); // row 3, ZZ4R
    }
    // XY4: column
    {
        let t257 = t194 + t197;
        let t262 = t198 * t83 + t199 * z1_5_z - t40 * t257;
        let t267 = t198 * t87 - t199 * z2_4_y - c3 * t257;
        let t270 = s4 * t198 + c4 * t199;
        put(17, t262); // row 1, XY4
        put(61, t267); // row 2, XY4
        put(98, t270); // row 3, XY4
        put(128, t257); // row 4, XY4
    }
    // XZ4: column
    {
        let t275 = t40 * t183 + (t193 * z1_5_z - t196 * t83);
        let t280 = c3 * t183 - (t196 * t87 + t193 * z2_4_y);
        let t282 = c4 * t193 - t202;
        put(18, t275); // row 1, XZ4
        put(62, t280); // row 2, XZ4
        put(99, t282); // row 3, XZ4
    }
    // YZ4: column
    {
        let t283 = t197 - t77;
        let t288 = t83 * t283 - t195 * z1_5_z - t40 * t180;
        let t293 = t87 * t283 + t195 * z2_4_y - c3 * t180;
        let t295 = s4 * t283 - t219;
        put(19, t288); // row 1, YZ4
        put(63, t293); // row 2, YZ4
        put(100, t295); // row 3, YZ4
    }
    // link 5: motion
    let [
        t300, t304, a5_y, w5_x, t313, t316, t319, w5_z,
        dw5_z, t324, t325, t326, t327, dw5_y, t329, t330,
        t331, t332, t333, t334, t335,
    ] = {
        let t299 = t168 - k_L3 * t195;
        let t300 = a4_y + k_L3 * t197;
        let t301 = a3_y + k_L3 * t199;
        let t304 = c5 * t299 - s5 * t301;
        let a5_y = c5 * t301 + s5 * t299;
        let w5_x = c5 * w4_x + s5 * w4_z;
        let t313 = s5 * w4_x - c5 * w4_z;
        let t316 = c5 * t195 + s5 * t199;
        let t319 = s5 * t195 - c5 * t199;
        let w5_z = t177 + dq5;
        let dw5_z = t192 + ddq5;
        let t322 = w5_x * w5_x;
        let t323 = w5_z * w5_z;
        let t324 = w5_x * t313;
        let t325 = w5_x * w5_z;
        let t326 = t313 * w5_z;
        let t327 = t326 - t319;
        let dw5_y = t316 - t325;
        let t329 = t322 - t323;
        let t330 = t329 - t197;
        let t331 = dw5_z + t324;
        let t332 = dw5_z - t324;
        let t333 = t322 + t323;
        let t334 = dw5_y - t325;
        let t335 = t326 + t327;
        put(154, a5_y); // row 5, MSX5
        put(155, t304); // row 5, MSY5R
        put(156, t324); // row 5, XX5R
        put(157, dw5_z); // row 5, ZZ5R
        put(159, t319); // row 5, XZ5
        put(160, t316); // row 5, YZ5
        [
        t300, t304, a5_y, w5_x, t313, t316, t319, w5_z,
        dw5_z, t324, t325, t326, t327, dw5_y, t329, t330,
        t331, t332, t333, t334, t335,
    ]
    };
    // MSX5: column
    let [t337, t342, t343] = {
        let t337 = s5 * t332;
        let t338 = c5 * t330 - t337;
        let t341 = s5 * t330 + c5 * t332;
        let t342 = s5 * t300;
        let t343 = c5 * t300;
        let t346 = t342 + k_L3 * t341;
        let t347 = t343 + k_L3 * t338;
        let t356 = s4 * t346 + c4 * a5_y;
        let t359 = c4 * t346 - s4 * a5_y + k_L2 * t341;
        let t360 = k_L2 * (s4 * t334 - c4 * t338) - t347;
        let t365 = c2 * t356 + (t40 * t360 - z1_3_x * t359);
        let t368 = s3 * t359 + c3 * t360;
        put(20, t365); // row 1, MSX5
        put(64, t368); // row 2, MSX5
        put(101, t356); // row 3, MSX5
        put(131, t347); // row 4, MSX5
        [t337, t342, t343]
    };
    // MSY5: column
    let t369 = {
        let t369 = c5 * t331;
        let t371 = s5 * t333 - t369;
        let t374 = s5 * t331 + c5 * t333;
        let t377 = t343 - k_L3 * t374;
        let t378 = k_L3 * t371 - t342;
        let t387 = s4 * t377 + c4 * t304;
        let t390 = c4 * t377 - s4 * t304 - k_L2 * t374;
        let t391 = t378 - k_L2 * (s4 * t335 - c4 * t371);
        let t396 = c2 * t387 - (z1_3_x * t390 + t40 * t391);
        let t399 = s3 * t390 - c3 * t391;
        put(21, t396); // row 1, MSY5R
        put(65, t399); // row 2, MSY5R
        put(102, t387); // row 3, MSY5R
        put(132, t378); // row 4, MSY5R
        t369
    };
    // XX5: column
    let [t401, t406, t411, t416] = {
        let t401 = t325 * z1_6_z;
        let t404 = t324 * z1_5_z - (t401 - t327 * t91);
        let t406 = t325 * t100;
        let t409 = t327 * t97 - t406 - t324 * z2_4_y;
        let t411 = t325 * z3_5_y;
        let t414 = c4 * t324 + (t327 * t101 + t411);
        let t416 = c5 * t325;
        let t417 = t416 - s5 * t327;
        put(22, t404); // row 1, XX5R
        put(66, t409); // row 2, XX5R
        put(103, t414); // row 3, XX5R
        put(133, t417); // row 4, XX5R
        [t401, t406, t411, t416]
    };
    // ZZ5: column
    {
        let t421 = dw5_z * z1_5_z + (t401 + t326 * t91);
        let t425 = t406 + t326 * t97 - dw5_z * z2_4_y;
        let t429 = c4 * dw5_z + (t326 * t101 - t411);
        let t432 = -(t416 + s5 * t326);
        put(23, t421); // row 1, ZZ5R
        put(67, t425); // row 2, ZZ5R
        put(104, t429); // row 3, ZZ5R
        put(134, t432); // row 4, ZZ5R
    }
    // XY5: column
    {
        let t433 = t330 + t333;
        let t438 = z1_5_z * t433 + (t335 * z1_6_z - t334 * t91);
        let t443 = t335 * t100 - t334 * t97 - z2_4_y * t433;
        let t448 = c4 * t433 - (t334 * t101 + t335 * z3_5_y);
        let t451 = s5 * t334 - c5 * t335;
        put(24, t438); // row 1, XY5
        put(68, t443); // row 2, XY5
        put(105, t448); // row 3, XY5
        put(135, t451); // row 4, XY5
        put(158, t433); // row 5, XY5
    }
    // XZ5: column
    {
        let t456 = t319 * z1_5_z - (t332 * t91 - t329 * z1_6_z);
        let t461 = t329 * t100 - t332 * t97 - t319 * z2_4_y;
        let t466 = c4 * t319 - (t332 * t101 + t329 * z3_5_y);
        let t468 = t337 - c5 * t329;
        put(25, t456); // row 1, XZ5
        put(69, t461); // row 2, XZ5
        put(106, t466); // row 3, XZ5
        put(136, t468); // row 4, XZ5
    }
    // YZ5: column
    {
        let t469 = t333 - t197;
        let t474 = t316 * z1_5_z + (t91 * t469 - t331 * z1_6_z);
        let t479 = t97 * t469 - t331 * t100 - t316 * z2_4_y;
        let t484 = c4 * t316 + (t101 * t469 + t331 * z3_5_y);
        let t486 = t369 - s5 * t469;
        put(26, t474); // row 1, YZ5
        put(70, t479); // row 2, YZ5
        put(107, t484); // row 3, YZ5
        put(137, t486); // row 4, YZ5
    }
    // link 6: motion
    let [
        t489, a6_y, w6_x, w6_y, t501, t504, w6_z, dw6_z,
        t509, t510, t511, dw6_x, t513, t514, t515, t516,
        t517, t518, t519, t520,
    ] = {
        let t489 = c6 * t304 + s6 * t300;
        let a6_y = s6 * t304 - c6 * t300;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t501 = c6 * t331 + s6 * t335;
        let t504 = s6 * t331 - c6 * t335;
        let w6_z = t313 + dq6;
        let dw6_z = ddq6 - dw5_y;
        let t507 = w6_x * w6_x;
        let t508 = w6_z * w6_z;
        let t509 = w6_x * w6_y;
        let t510 = w6_x * w6_z;
        let t511 = w6_y * w6_z;
        let dw6_x = t504 + t511;
        let t513 = t501 - t510;
        let t514 = t507 - t508;
        let t515 = t514 - t333;
        let t516 = t509 - dw6_z;
        let t517 = dw6_z + t509;
        let t518 = t507 + t508;
        let t519 = t513 - t510;
        let t520 = t511 + dw6_x;
        let t521 = -t509;
        put(177, a6_y); // row 6, MSX6
        put(178, t489); // row 6, MSY6R
        put(179, t521); // row 6, XX6R
        put(180, dw6_z); // row 6, ZZ6R
        put(182, t504); // row 6, XZ6
        put(183, t501); // row 6, YZ6
        [
        t489, a6_y, w6_x, w6_y, t501, t504, w6_z, dw6_z,
        t509, t510, t511, dw6_x, t513, t514, t515, t516,
        t517, t518, t519, t520,
    ]
    };
    // MSX6: column
    let [t523, t526, t528, t529] = {
        let t523 = s6 * t517;
        let t524 = c6 * t515 - t523;
        let t526 = c6 * t517;
        let t528 = s6 * a5_y;
        let t529 = c6 * a5_y;
        let t532 = c5 * t524 - s5 * t519;
        let t535 = s5 * t524 + c5 * t519;
        let t544 = k_L3 * t535 - (s5 * a6_y - c5 * t528);
        let t545 = k_L3 * t532 - (s5 * t528 + c5 * a6_y);
        let t554 = s4 * t544 + c4 * t529;
        let t557 = c4 * t544 - s4 * t529 + k_L2 * t535;
        let t558 = t545 + k_L2 * (c4 * t532 + s4 * (s6 * t515 + t526));
        let t563 = c2 * t554 - (z1_3_x * t557 + t40 * t558);
        let t566 = s3 * t557 - c3 * t558;
        let t567 = -t528;
        put(27, t563); // row 1, MSX6
        put(71, t566); // row 2, MSX6
        put(108, t554); // row 3, MSX6
        put(138, t545); // row 4, MSX6
        put(161, t529); // row 5, MSX6
        put(162, t567); // row 5, MSY6R
        [t523, t526, t528, t529]
    };
    // MSY6: column
    let [t568, t571] = {
        let t568 = c6 * t516;
        let t570 = t568 + s6 * t518;
        let t571 = s6 * t516;
        let t576 = c5 * t570 + s5 * t520;
        let t579 = c5 * t520 - s5 * t570;
        let t588 = c5 * t529 - s5 * t489 - k_L3 * t579;
        let t589 = k_L3 * t576 - (s5 * t529 + c5 * t489);
        let t598 = s4 * t588 - c4 * t528;
        let t601 = k_L2 * t579 - (c4 * t588 + s4 * t528);
        let t602 = k_L2 * (s4 * (c6 * t518 - t571) - c4 * t576) - t589;
        let t607 = c2 * t598 + (z1_3_x * t601 + t40 * t602);
        let t610 = c3 * t602 - s3 * t601;
        put(28, t607); // row 1, MSY6R
        put(72, t610); // row 2, MSY6R
        put(109, t598); // row 3, MSY6R
        put(139, t589); // row 4, MSY6R
        [t568, t571]
    };
    // XX6: column
    let [t612, t615] = {
        let t612 = s6 * t510;
        let t613 = t612 - c6 * dw6_x;
        let t615 = c6 * t510;
        let t616 = s6 * dw6_x + t615;
        let t621 = z1_5_z * t616 + (t91 * t613 - t509 * z1_6_z);
        let t626 = t97 * t613 - t509 * t100 - z2_4_y * t616;
        let t631 = c4 * t616 + (t101 * t613 + t509 * z3_5_y);
        let t634 = c5 * t509 - s5 * t613;
        put(29, t621); // row 1, XX6R
        put(73, t626); // row 2, XX6R
        put(110, t631); // row 3, XX6R
        put(140, t634); // row 4, XX6R
        put(163, t616); // row 5, XX6R
        [t612, t615]
    };
    // ZZ6: column
    {
        let t636 = t612 + c6 * t511;
        let t638 = s6 * t511 - t615;
        let t643 = z1_5_z * t638 - (t91 * t636 - dw6_z * z1_6_z);
        let t648 = dw6_z * t100 - t97 * t636 - z2_4_y * t638;
        let t653 = c4 * t638 - (t101 * t636 + dw6_z * z3_5_y);
        let t656 = s5 * t636 - c5 * dw6_z;
        put(30, t643); // row 1, ZZ6R
        put(74, t648); // row 2, ZZ6R
        put(111, t653); // row 3, ZZ6R
        put(141, t656); // row 4, ZZ6R
        put(164, t638); // row 5, ZZ6R
    }
    // XY6: column
    {
        let t657 = t515 + t518;
        let t660 = c6 * t519 - s6 * t520;
        let t663 = s6 * t519 + c6 * t520;
        let t668 = z1_5_z * t663 + (z1_6_z * t657 - t91 * t660);
        let t673 = t100 * t657 - t97 * t660 - z2_4_y * t663;
        let t678 = c4 * t663 - (t101 * t660 + z3_5_y * t657);
        let t681 = s5 * t660 - c5 * t657;
        put(31, t668); // row 1, XY6
        put(75, t673); // row 2, XY6
        put(112, t678); // row 3, XY6
        put(142, t681); // row 4, XY6
        put(165, t663); // row 5, XY6
        put(181, t657); // row 6, XY6
    }
    // link 7: motion
    let [
        t684, a7_y, t696, t699, dw7_z, t704, t705, t706,
        t707, t709, t710, t711, t712, t713, t714, t715,
    ] = {
        let t684 = c7 * t489 - s7 * a5_y;
        let a7_y = c7 * a5_y + s7 * t489;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t693 = c7 * w6_z + s7 * w6_x;
        let t696 = c7 * t516 - s7 * t520;
        let t699 = c7 * t520 + s7 * t516;
        let w7_z = w6_y + dq7;
        let dw7_z = t513 + ddq7;
        let t702 = w7_x * w7_x;
        let t703 = w7_z * w7_z;
        let t704 = w7_x * t693;
        let t705 = w7_x * w7_z;
        let t706 = t693 * w7_z;
        let t707 = t706 - t699;
        let t709 = t702 - t703;
        let t710 = t518 - t709;
        let t711 = dw7_z + t704;
        let t712 = dw7_z - t704;
        let t713 = t702 + t703;
        let t714 = t705 + (t705 - t696);
        let t715 = t706 + t707;
        put(193, a7_y); // row 7, MSX7
        put(194, t684); // row 7, MSY7
        put(195, t704); // row 7, XX7R
        put(196, dw7_z); // row 7, ZZ7
        put(198, t699); // row 7, XZ7
        put(199, t696); // row 7, YZ7
        [
        t684, a7_y, t696, t699, dw7_z, t704, t705, t706,
        t707, t709, t710, t711, t712, t713, t714, t715,
    ]
    };
    // XZ6: column
    {
        let t717 = t526 + s6 * t514;
        let t719 = t523 - c6 * t514;
        let t724 = z1_5_z * t719 - (t91 * t717 - t504 * z1_6_z);
        let t729 = t504 * t100 - t97 * t717 - z2_4_y * t719;
        let t734 = c4 * t719 - (t101 * t717 + t504 * z3_5_y);
        let t737 = s5 * t717 - c5 * t504;
        put(32, t724); // row 1, XZ6
        put(76, t729); // row 2, XZ6
        put(113, t734); // row 3, XZ6
        put(143, t737); // row 4, XZ6
        put(166, t719); // row 5, XZ6
    }
    // YZ6: column
    {
        let t738 = t333 - t518;
        let t740 = t571 + c6 * t738;
        let t742 = s6 * t738 - t568;
        let t747 = z1_5_z * t742 - (t91 * t740 - t501 * z1_6_z);
        let t752 = t501 * t100 - t97 * t740 - z2_4_y * t742;
        let t757 = c4 * t742 - (t101 * t740 + t501 * z3_5_y);
        let t760 = s5 * t740 - c5 * t501;
        put(33, t747); // row 1, YZ6
        put(77, t752); // row 2, YZ6
        put(114, t757); // row 3, YZ6
        put(144, t760); // row 4, YZ6
        put(167, t742); // row 5, YZ6
    }
    // MSX7: column
    let [t762, t765, t767, t768] = {
        let t762 = s7 * t712;
        let t763 = c7 * t710 + t762;
        let t765 = c7 * t712;
        let t766 = t765 - s7 * t710;
        let t767 = s7 * a6_y;
        let t768 = c7 * a6_y;
        let t771 = c6 * t763 + s6 * t714;
        let t777 = c6 * t767 - s6 * a7_y;
        let t780 = s6 * t767 + c6 * a7_y;
        let t783 = c5 * t771 + s5 * t766;
        let t786 = c5 * t766 - s5 * t771;
        let t795 = k_L3 * t786 - (c5 * t777 + s5 * t768);
        let t796 = s5 * t777 - c5 * t768 - k_L3 * t783;
        let t805 = s4 * t795 + c4 * t780;
        let t808 = k_L2 * t786 - (s4 * t780 - c4 * t795);
        let t809 = k_L2 * (c4 * t783 + s4 * (s6 * t763 - c6 * t714)) - t796;
        let t814 = c2 * t805 + (t40 * t809 - z1_3_x * t808);
        let t817 = s3 * t808 + c3 * t809;
        let t818 = -t767;
        put(34, t814); // row 1, MSX7
        put(78, t817); // row 2, MSX7
        put(115, t805); // row 3, MSX7
        put(145, t796); // row 4, MSX7
        put(168, t780); // row 5, MSX7
        put(184, t768); // row 6, MSX7
        put(185, t818); // row 6, MSY7
        [t762, t765, t767, t768]
    };
    // MSY7: column
    let [t819, t822] = {
        let t819 = c7 * t711;
        let t821 = t819 - s7 * t713;
        let t822 = s7 * t711;
        let t824 = t822 + c7 * t713;
        let t827 = s6 * t715 - c6 * t821;
        let t833 = c6 * t768 - s6 * t684;
        let t836 = s6 * t768 + c6 * t684;
        let t839 = c5 * t827 + s5 * t824;
        let t842 = s5 * t827 - c5 * t824;
        let t851 = s5 * t767 - c5 * t833 + k_L3 * t842;
        let t852 = s5 * t833 + c5 * t767 + k_L3 * t839;
        let t861 = s4 * t851 + c4 * t836;
        let t864 = k_L2 * t842 - (s4 * t836 - c4 * t851);
        let t865 = t852 + k_L2 * (c4 * t839 - s4 * (s6 * t821 + c6 * t715));
        let t870 = c2 * t861 - (z1_3_x * t864 + t40 * t865);
        let t873 = s3 * t864 - c3 * t865;
        put(35, t870); // row 1, MSY7
        put(79, t873); // row 2, MSY7
        put(116, t861); // row 3, MSY7
        put(146, t852); // row 4, MSY7
        put(169, t836); // row 5, MSY7
        [t819, t822]
    };
    // XX7: column
    let [t875, t878] = {
        let t875 = s7 * t705;
        let t876 = c7 * t707 + t875;
        let t878 = c7 * t705;
        let t879 = s7 * t707 - t878;
        let t882 = c6 * t876 + s6 * t704;
        let t885 = c6 * t704 - s6 * t876;
        let t890 = z1_5_z * t885 + (t91 * t882 + z1_6_z * t879);
        let t895 = t97 * t882 + t100 * t879 - z2_4_y * t885;
        let t900 = c4 * t885 - (z3_5_y * t879 - t101 * t882);
        let t904 = -(s5 * t882 + c5 * t879);
        put(36, t890); // row 1, XX7R
        put(80, t895); // row 2, XX7R
        put(117, t900); // row 3, XX7R
        put(147, t904); // row 4, XX7R
        put(170, t885); // row 5, XX7R
        put(186, t879); // row 6, XX7R
        [t875, t878]
    };
    // ZZ7: column
    {
        let t906 = t875 - c7 * t706;
        let t908 = t878 + s7 * t706;
        let t911 = c6 * t906 - s6 * dw7_z;
        let t914 = s6 * t906 + c6 * dw7_z;
        let t919 = z1_5_z * t914 + (z1_6_z * t908 - t91 * t911);
        let t924 = t100 * t908 - t97 * t911 - z2_4_y * t914;
        let t929 = c4 * t914 - (t101 * t911 + z3_5_y * t908);
        let t932 = s5 * t911 - c5 * t908;
        put(37, t919); // row 1, ZZ7
        put(81, t924); // row 2, ZZ7
        put(118, t929); // row 3, ZZ7
        put(148, t932); // row 4, ZZ7
        put(171, t914); // row 5, ZZ7
        put(187, t908); // row 6, ZZ7
    }
    // XY7: column
    {
        let t933 = t713 - t710;
        let t936 = c7 * t714 - s7 * t715;
        let t939 = s7 * t714 + c7 * t715;
        let t942 = c6 * t936 + s6 * t933;
        let t945 = c6 * t933 - s6 * t936;
        let t950 = z1_5_z * t945 + (t91 * t942 + z1_6_z * t939);
        let t955 = t97 * t942 + t100 * t939 - z2_4_y * t945;
        let t960 = c4 * t945 + (t101 * t942 - z3_5_y * t939);
        let t964 = -(s5 * t942 + c5 * t939);
        put(38, t950); // row 1, XY7
        put(82, t955); // row 2, XY7
        put(119, t960); // row 3, XY7
        put(149, t964); // row 4, XY7
        put(172, t945); // row 5, XY7
        put(188, t939); // row 6, XY7
        put(197, t933); // row 7, XY7
    }
    // XZ7: column
    {
        let t966 = t765 + s7 * t709;
        let t968 = c7 * t709 - t762;
        let t971 = c6 * t966 - s6 * t699;
        let t974 = s6 * t966 + c6 * t699;
        let t979 = z1_5_z * t974 + (z1_6_z * t968 - t91 * t971);
        let t984 = t100 * t968 - t97 * t971 - z2_4_y * t974;
        let t989 = c4 * t974 - (t101 * t971 + z3_5_y * t968);
        let t992 = s5 * t971 - c5 * t968;
        put(39, t979); // row 1, XZ7
        put(83, t984); // row 2, XZ7
        put(120, t989); // row 3, XZ7
        put(150, t992); // row 4, XZ7
        put(173, t974); // row 5, XZ7
        put(189, t968); // row 6, XZ7
    }
    // YZ7: column
    {
        let t993 = t713 - t518;
        let t995 = t822 + c7 * t993;
        let t997 = s7 * t993 - t819;
        let t1000 = c6 * t995 + s6 * t696;
        let t1003 = c6 * t696 - s6 * t995;
        let t1008 = z1_5_z * t1003 + (t91 * t1000 + z1_6_z * t997);
        let t1013 = t97 * t1000 + t100 * t997 - z2_4_y * t1003;
        let t1018 = c4 * t1003 + (t101 * t1000 - z3_5_y * t997);
        let t1022 = dq1.sign();
        let t1023 = dq2.sign();
        let t1024 = dq3.sign();
        let t1025 = dq4.sign();
        let t1026 = dq5.sign();
        let t1027 = dq6.sign();
        let t1028 = dq7.sign();
        let t1029 = -(s5 * t1000 + c5 * t997);
        put(40, t1008); // row 1, YZ7
        put(42, t1022); // row 1, FC1
        put(84, t1013); // row 2, YZ7
        put(86, t1023); // row 2, FC2
        put(121, t1018); // row 3, YZ7
        put(123, t1024); // row 3, FC3
        put(151, t1029); // row 4, YZ7
        put(153, t1025); // row 4, FC4
        put(174, t1003); // row 5, YZ7
        put(176, t1026); // row 5, FC5
        put(190, t997); // row 6, YZ7
        put(192, t1027); // row 6, FC6
        put(201, t1028); // row 7, FC7
    }
}
