//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil
//! and Dombre, 12.4.
//!
//! 308 multiplications, 243 additions; 6 x 58, 161 of 348 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig, constants};

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

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 58 + PATTERN[k].1
}

/// Regressor `W_b` of the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 58]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[1..3]),
            33 => clear(&mut flat[36..40]),
            34 => clear(&mut flat[41..46]),
            35 => clear(&mut flat[47..52]),
            36 => clear(&mut flat[53..59]),
            71 => clear(&mut flat[94..99]),
            72 => clear(&mut flat[100..105]),
            73 => clear(&mut flat[106..111]),
            74 => clear(&mut flat[112..124]),
            103 => clear(&mut flat[153..158]),
            104 => clear(&mut flat[159..164]),
            105 => clear(&mut flat[165..170]),
            106 => clear(&mut flat[171..189]),
            127 => flat[210] = S::default(),
            128 => clear(&mut flat[212..217]),
            129 => clear(&mut flat[218..223]),
            130 => clear(&mut flat[224..229]),
            131 => clear(&mut flat[230..254]),
            145 => clear(&mut flat[268..270]),
            146 => clear(&mut flat[271..276]),
            147 => clear(&mut flat[277..282]),
            148 => clear(&mut flat[283..288]),
            149 => clear(&mut flat[289..319]),
            156 => clear(&mut flat[326..329]),
            157 => clear(&mut flat[330..335]),
            158 => clear(&mut flat[336..341]),
            159 => clear(&mut flat[342..347]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 58]; 6]) {
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
    let k0 = S::constant(-constants::A2);
    let k1 = S::constant(-GRAVITY[2]);
    let k3 = S::constant(-constants::A3);
    let k7 = S::constant(1.0);
    let k_A3 = S::constant(constants::A3);
    let k_D4 = S::constant(constants::D4);
    let k_D5 = S::constant(constants::D5);
    let k_D6 = S::constant(constants::D6);
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
    // joint axes in frame 3
    let [v1_3_z, t2, t3] = {
        let v1_3_z = c2 * k0;
        let t2 = s3 * k0;
        let t3 = c3 * k0;
        [v1_3_z, t2, t3]
    };
    // link 2: motion
    let [
        a2_x, a2_y, t13, t14, dw2_x, t17, t18, t19,
        t20, t21, t22, t23,
    ] = {
        let a2_x = s2 * k1;
        let a2_y = c2 * k1;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t8 = s2 * ddq1;
        let t9 = c2 * ddq1;
        let t10 = w2_x * w2_x;
        let t11 = dq2 * dq2;
        let t12 = w2_x * w2_y;
        let t13 = dq2 * w2_x;
        let t14 = dq2 * w2_y;
        let dw2_x = t8 + t14;
        let dw2_y = t9 - t13;
        let t17 = t10 - t11;
        let t18 = t17 - t0;
        let t19 = ddq2 - t12;
        let t20 = ddq2 + t12;
        let t21 = t10 + t11;
        let t22 = dw2_y - t13;
        let t23 = t14 + dw2_x;
        let t24 = -a2_x;
        let t25 = -t12;
        put(37, a2_y); // row 2, MSX2R
        put(38, t24); // row 2, MSY2
        put(39, t25); // row 2, XX2R
        put(42, t8); // row 2, XZ2R
        put(43, t9); // row 2, YZ2
        [
        a2_x, a2_y, t13, t14, dw2_x, t17, t18, t19,
        t20, t21, t22, t23,
    ]
    };
    // XX2: column
    let t27 = {
        let t27 = c2 * t13;
        let t28 = s2 * dw2_x + t27;
        put(1, t28); // row 1, XX2R
        t27
    };
    // ZZ2: column
    {
        let t30 = s2 * t14 - t27;
        put(2, t30); // row 1, ZZ2R
    }
    // XY2: column
    {
        let t31 = t18 + t21;
        let t34 = s2 * t22 + c2 * t23;
        put(3, t34); // row 1, XY2
        put(41, t31); // row 2, XY2
    }
    // XZ2: column
    {
        let t37 = s2 * t20 - c2 * t17;
        put(4, t37); // row 1, XZ2R
    }
    // YZ2: column
    {
        let t41 = c2 * t19 - s2 * (t21 - t0);
        put(5, t41); // row 1, YZ2
    }
    // link 3: motion
    let [
        z1_3_x, z1_3_y, w3_z, dw3_z, t52, t57, a3_y, t61,
        t62, t68, t69, dw3_x, t72, t73, t74, t75,
        t76, t77, t78,
    ] = {
        let z1_3_x = s2 * c3 + c2 * s3;
        let z1_3_y = c2 * c3 - s2 * s3;
        let w3_z = dq2 + dq3;
        let dw3_z = ddq2 + ddq3;
        let t52 = t22 * k0;
        let t53 = t18 * k0 - a2_x;
        let t54 = t20 * k0 - a2_y;
        let t57 = c3 * t53 + s3 * t54;
        let a3_y = s3 * t53 - c3 * t54;
        let t61 = ddq1 * z1_3_y;
        let t62 = ddq1 * z1_3_x;
        let w3_x = dq1 * z1_3_x;
        let w3_y = dq1 * z1_3_y;
        let t65 = w3_x * w3_x;
        let t66 = w3_z * w3_z;
        let t67 = w3_x * w3_y;
        let t68 = w3_z * w3_x;
        let t69 = w3_z * w3_y;
        let dw3_x = t62 + t69;
        let t72 = t66 - t65;
        let t73 = t0 + t72;
        let t74 = dw3_z - t67;
        let t75 = dw3_z + t67;
        let t76 = t65 + t66;
        let t77 = t68 + (t68 - t61);
        let t78 = t69 + dw3_x;
        let t79 = -t67;
        put(46, t79); // row 2, XX3R
        put(47, dw3_z); // row 2, ZZ3R
        put(49, t62); // row 2, XZ3R
        put(50, t61); // row 2, YZ3
        put(75, a3_y); // row 3, MSX3R
        put(76, t57); // row 3, MSY3
        put(77, t79); // row 3, XX3R
        put(78, dw3_z); // row 3, ZZ3R
        put(80, t62); // row 3, XZ3R
        put(81, t61); // row 3, YZ3
        [
        z1_3_x, z1_3_y, w3_z, dw3_z, t52, t57, a3_y, t61,
        t62, t68, t69, dw3_x, t72, t73, t74, t75,
        t76, t77, t78,
    ]
    };
    // joint axes in frame 4
    let [v1_4_z, v1_4_x, v1_5_z, t93, t96, t97, v3_5_z] = {
        let t80 = k_D4 * z1_3_y;
        let t81 = k_D4 * z1_3_x;
        let v1_4_z = v1_3_z + z1_3_y * k3;
        let v1_4_x = c4 * t80 - s4 * t81;
        let v1_5_z = c4 * t81 + s4 * t80;
        let t90 = t3 - k_A3;
        let t93 = c4 * t2 + s4 * t90;
        let t96 = c4 * t90 - s4 * t2;
        let t97 = s4 * k3;
        let v3_5_z = c4 * k3;
        [v1_4_z, v1_4_x, v1_5_z, t93, t96, t97, v3_5_z]
    };
    // MSX3: column
    {
        let t101 = t77 * v1_3_z - z1_3_y * t52;
        let t105 = a3_y + (t73 * t2 - t75 * t3);
        put(6, t101); // row 1, MSX3R
        put(44, t105); // row 2, MSX3R
    }
    // MSY3: column
    {
        let t108 = z1_3_x * t52 + t78 * v1_3_z;
        let t112 = t57 + (t74 * t2 + t76 * t3);
        put(7, t108); // row 1, MSY3
        put(45, t112); // row 2, MSY3
    }
    // XX3: column
    let t114 = {
        let t114 = z1_3_y * t68;
        let t115 = z1_3_x * dw3_x + t114;
        put(8, t115); // row 1, XX3R
        t114
    };
    // ZZ3: column
    {
        let t117 = z1_3_x * t69 - t114;
        put(9, t117); // row 1, ZZ3R
    }
    // XY3: column
    {
        let t118 = t76 - t73;
        let t121 = z1_3_y * t78 - z1_3_x * t77;
        put(10, t121); // row 1, XY3
        put(48, t118); // row 2, XY3
        put(79, t118); // row 3, XY3
    }
    // XZ3: column
    {
        let t124 = z1_3_x * t75 + z1_3_y * t72;
        put(11, t124); // row 1, XZ3R
    }
    // YZ3: column
    {
        let t128 = z1_3_x * (t0 - t76) + z1_3_y * t74;
        put(12, t128); // row 1, YZ3
    }
    // link 4: motion
    let [
        z1_4_x, t134, w4_z, t148, t151, a4_y, w4_x, t158,
        t162, t163, dw4_x, t165, t166, t167, t168, t169,
        t170, t171, t172,
    ] = {
        let z1_4_x = c4 * z1_3_x + s4 * z1_3_y;
        let t134 = s4 * z1_3_x - c4 * z1_3_y;
        let w4_z = w3_z + dq4;
        let dw4_z = dw3_z + ddq4;
        let t146 = t57 - (t73 * k3 + k_D4 * t61);
        let t147 = t75 * k3 + k_D4 * t62 - a3_y;
        let t148 = t52 - (t77 * k3 + k_D4 * t0);
        let t151 = c4 * t146 + s4 * t147;
        let a4_y = s4 * t146 - c4 * t147;
        let t155 = ddq1 * t134;
        let t156 = ddq1 * z1_4_x;
        let w4_x = dq1 * z1_4_x;
        let t158 = dq1 * t134;
        let t159 = w4_x * w4_x;
        let t160 = w4_z * w4_z;
        let t161 = w4_x * t158;
        let t162 = w4_z * w4_x;
        let t163 = w4_z * t158;
        let dw4_x = t156 - t163;
        let t165 = t155 + t162;
        let t166 = t159 - t160;
        let t167 = t166 - t0;
        let t168 = dw4_z + t161;
        let t169 = t161 - dw4_z;
        let t170 = t159 + t160;
        let t171 = t162 + t165;
        let t172 = t163 - dw4_x;
        let t173 = -t155;
        put(53, t161); // row 2, XX4R
        put(54, dw4_z); // row 2, ZZ4R
        put(56, t156); // row 2, XZ4
        put(57, t173); // row 2, YZ4
        put(84, t161); // row 3, XX4R
        put(85, dw4_z); // row 3, ZZ4R
        put(87, t156); // row 3, XZ4
        put(88, t173); // row 3, YZ4
        put(107, a4_y); // row 4, MSX4
        put(108, t151); // row 4, MSY4R
        put(109, t161); // row 4, XX4R
        put(110, dw4_z); // row 4, ZZ4R
        put(112, t156); // row 4, XZ4
        put(113, t173); // row 4, YZ4
        [
        z1_4_x, t134, w4_z, t148, t151, a4_y, w4_x, t158,
        t162, t163, dw4_x, t165, t166, t167, t168, t169,
        t170, t171, t172,
    ]
    };
    // MSX4: column
    {
        let t180 = t134 * t148 + (t171 * v1_4_z + (t167 * v1_4_x + t169 * v1_5_z));
        let t184 = a4_y + (t169 * t96 - t167 * t93);
        let t188 = a4_y + (t169 * v3_5_z - t167 * t97);
        put(13, t180); // row 1, MSX4
        put(51, t184); // row 2, MSX4
        put(82, t188); // row 3, MSX4
    }
    // MSY4: column
    {
        let t195 = z1_4_x * t148 - (t172 * v1_4_z - (t170 * v1_5_z - t168 * v1_4_x));
        let t199 = t151 + (t168 * t93 + t170 * t96);
        let t203 = t151 + (t168 * t97 + t170 * v3_5_z);
        put(14, t195); // row 1, MSY4R
        put(52, t199); // row 2, MSY4R
        put(83, t203); // row 3, MSY4R
    }
    // XX4: column
    let t205 = {
        let t205 = t134 * t162;
        let t206 = z1_4_x * dw4_x - t205;
        put(15, t206); // row 1, XX4R
        t205
    };
    // ZZ4: column
    {
        let t208 = t205 - z1_4_x * t163;
        put(16, t208); // row 1, ZZ4R
    }
    // XY4: column
    {
        let t209 = t167 + t170;
        let t212 = t134 * t172 - z1_4_x * t171;
        put(17, t212); // row 1, XY4
        put(55, t209); // row 2, XY4
        put(86, t209); // row 3, XY4
        put(111, t209); // row 4, XY4
    }
    // XZ4: column
    {
        let t215 = t134 * t166 - z1_4_x * t169;
        put(18, t215); // row 1, XZ4
    }
    // YZ4: column
    {
        let t219 = z1_4_x * (t0 - t170) - t134 * t168;
        put(19, t219); // row 1, YZ4
    }
    // link 5: motion
    let [
        z1_5_x, t221, t226, t230, a5_y, w5_x, w5_y, t242,
        t245, w5_z, dw5_z, t250, t251, t252, dw5_x, t254,
        t255, t256, t257, t258, t259, t260, t261,
    ] = {
        let z1_5_x = c5 * z1_4_x;
        let t221 = s5 * z1_4_x;
        let t225 = t151 - k_D5 * t168;
        let t226 = a4_y + k_D5 * t170;
        let t227 = t148 + k_D5 * t172;
        let t230 = c5 * t225 - s5 * t227;
        let a5_y = c5 * t227 + s5 * t225;
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t242 = c5 * t168 + s5 * t172;
        let t245 = s5 * t168 - c5 * t172;
        let w5_z = t158 + dq5;
        let dw5_z = t165 + ddq5;
        let t248 = w5_x * w5_x;
        let t249 = w5_z * w5_z;
        let t250 = w5_x * w5_y;
        let t251 = w5_x * w5_z;
        let t252 = w5_y * w5_z;
        let dw5_x = t245 + t252;
        let t254 = t251 - t242;
        let t255 = t248 - t249;
        let t256 = t255 - t170;
        let t257 = t250 - dw5_z;
        let t258 = dw5_z + t250;
        let t259 = t248 + t249;
        let t260 = t251 + t254;
        let t261 = t252 + dw5_x;
        let t262 = -t250;
        put(132, a5_y); // row 5, MSX5
        put(133, t230); // row 5, MSY5R
        put(134, t262); // row 5, XX5R
        put(135, dw5_z); // row 5, ZZ5R
        put(137, t245); // row 5, XZ5
        put(138, t242); // row 5, YZ5
        [
        z1_5_x, t221, t226, t230, a5_y, w5_x, w5_y, t242,
        t245, w5_z, dw5_z, t250, t251, t252, dw5_x, t254,
        t255, t256, t257, t258, t259, t260, t261,
    ]
    };
    // MSX5: column
    let [t264, t269, t270] = {
        let t264 = s5 * t258;
        let t265 = c5 * t256 - t264;
        let t268 = s5 * t256 + c5 * t258;
        let t269 = s5 * t226;
        let t270 = c5 * t226;
        let t274 = t270 + k_D5 * t265;
        let t277 = z1_4_x * (t269 + k_D5 * t268) - t134 * a5_y;
        let t283 = v1_4_z * t268 + (v1_4_x * t265 + t260 * v1_5_z) - t277;
        let t287 = t274 + (t260 * t96 - t93 * t265);
        let t291 = t274 + (t260 * v3_5_z - t97 * t265);
        put(20, t283); // row 1, MSX5
        put(58, t287); // row 2, MSX5
        put(89, t291); // row 3, MSX5
        put(114, t274); // row 4, MSX5
        [t264, t269, t270]
    };
    // MSY5: column
    let t292 = {
        let t292 = c5 * t257;
        let t294 = t292 + s5 * t259;
        let t297 = s5 * t257 - c5 * t259;
        let t301 = k_D5 * t294 - t269;
        let t309 = v1_4_z * t297 + (v1_4_x * t294 + t261 * v1_5_z);
        let t310 = t134 * t230 - z1_4_x * (t270 + k_D5 * t297) + t309;
        let t314 = t301 - (t93 * t294 - t261 * t96);
        let t318 = t301 + (t261 * v3_5_z - t97 * t294);
        put(21, t310); // row 1, MSY5R
        put(59, t314); // row 2, MSY5R
        put(90, t318); // row 3, MSY5R
        put(115, t301); // row 4, MSY5R
        t292
    };
    // XX5: column
    let [t320, t325] = {
        let t320 = t221 * t251;
        let t323 = z1_5_x * dw5_x - t320 - t134 * t250;
        let t325 = c5 * t251;
        let t326 = s5 * dw5_x + t325;
        put(22, t323); // row 1, XX5R
        put(60, t326); // row 2, XX5R
        put(91, t326); // row 3, XX5R
        put(116, t326); // row 4, XX5R
        [t320, t325]
    };
    // ZZ5: column
    {
        let t330 = t134 * dw5_z + (t320 + z1_5_x * t252);
        let t332 = s5 * t252 - t325;
        put(23, t330); // row 1, ZZ5R
        put(61, t332); // row 2, ZZ5R
        put(92, t332); // row 3, ZZ5R
        put(117, t332); // row 4, ZZ5R
    }
    // XY5: column
    {
        let t333 = t256 + t259;
        let t338 = t134 * t333 - (z1_5_x * t260 + t221 * t261);
        let t341 = c5 * t261 - s5 * t260;
        put(24, t338); // row 1, XY5
        put(62, t341); // row 2, XY5
        put(93, t341); // row 3, XY5
        put(118, t341); // row 4, XY5
        put(136, t333); // row 5, XY5
    }
    // XZ5: column
    {
        let t346 = t134 * t245 + (z1_5_x * t258 + t221 * t255);
        let t348 = t264 - c5 * t255;
        put(25, t346); // row 1, XZ5
        put(63, t348); // row 2, XZ5
        put(94, t348); // row 3, XZ5
        put(119, t348); // row 4, XZ5
    }
    // YZ5: column
    {
        let t349 = t170 - t259;
        let t354 = t134 * t242 + (z1_5_x * t349 + t221 * t257);
        let t356 = s5 * t349 - t292;
        put(26, t354); // row 1, YZ5
        put(64, t356); // row 2, YZ5
        put(95, t356); // row 3, YZ5
        put(120, t356); // row 4, YZ5
    }
    // link 6: motion
    let [
        t361, t365, a6_y, t377, t380, dw6_z, t385, t386,
        t387, t388, t390, t391, t392, t393, t394, t395,
        t396,
    ] = {
        let t360 = t230 - k_D6 * t257;
        let t361 = a5_y - k_D6 * t259;
        let t362 = k_D6 * t261 - t226;
        let t365 = c6 * t360 + s6 * t362;
        let a6_y = s6 * t360 - c6 * t362;
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t374 = c6 * w5_z + s6 * w5_x;
        let t377 = c6 * t257 - s6 * t261;
        let t380 = c6 * t261 + s6 * t257;
        let w6_z = w5_y + dq6;
        let dw6_z = ddq6 - t254;
        let t383 = w6_x * w6_x;
        let t384 = w6_z * w6_z;
        let t385 = w6_x * t374;
        let t386 = w6_x * w6_z;
        let t387 = t374 * w6_z;
        let t388 = t387 - t380;
        let t390 = t383 - t384;
        let t391 = t259 - t390;
        let t392 = dw6_z + t385;
        let t393 = t385 - dw6_z;
        let t394 = t383 + t384;
        let t395 = t386 + (t386 - t377);
        let t396 = t387 + t388;
        put(150, a6_y); // row 6, MSX6
        put(151, t365); // row 6, MSY6
        put(152, t385); // row 6, XX6R
        put(153, dw6_z); // row 6, ZZ6
        put(155, t380); // row 6, XZ6
        put(156, t377); // row 6, YZ6
        [
        t361, t365, a6_y, t377, t380, dw6_z, t385, t386,
        t387, t388, t390, t391, t392, t393, t394, t395,
        t396,
    ]
    };
    // MSX6: column
    let [t398, t401, t403, t404] = {
        let t398 = s6 * t393;
        let t399 = c6 * t391 - t398;
        let t401 = c6 * t393;
        let t402 = s6 * t391 + t401;
        let t403 = s6 * t361;
        let t404 = c6 * t361;
        let t407 = t403 + k_D6 * t402;
        let t408 = t404 + k_D6 * t399;
        let t411 = c5 * t399 + s5 * t395;
        let t414 = s5 * t399 - c5 * t395;
        let t424 = s5 * t407 + c5 * a6_y - k_D5 * t411;
        let t427 = z1_4_x * (c5 * t407 - s5 * a6_y + k_D5 * t414) + t134 * t408;
        let t433 = t427 - (v1_4_z * t414 + (v1_4_x * t411 - v1_5_z * t402));
        let t437 = t424 + (t93 * t411 + t96 * t402);
        let t441 = t424 + (t97 * t411 + v3_5_z * t402);
        put(27, t433); // row 1, MSX6
        put(65, t437); // row 2, MSX6
        put(96, t441); // row 3, MSX6
        put(121, t424); // row 4, MSX6
        put(139, t408); // row 5, MSX6
        [t398, t401, t403, t404]
    };
    // MSY6: column
    let [t442, t445] = {
        let t442 = c6 * t392;
        let t444 = t442 - s6 * t394;
        let t445 = s6 * t392;
        let t447 = t445 + c6 * t394;
        let t450 = t404 + k_D6 * t447;
        let t451 = k_D6 * t444 - t403;
        let t454 = c5 * t444 - s5 * t396;
        let t457 = s5 * t444 + c5 * t396;
        let t467 = s5 * t450 + c5 * t365 - k_D5 * t454;
        let t470 = z1_4_x * (c5 * t450 - s5 * t365 + k_D5 * t457) + t134 * t451;
        let t476 = t470 - (v1_4_z * t457 - (v1_5_z * t447 - v1_4_x * t454));
        let t480 = t467 + (t93 * t454 + t96 * t447);
        let t484 = t467 + (t97 * t454 + v3_5_z * t447);
        put(28, t476); // row 1, MSY6
        put(66, t480); // row 2, MSY6
        put(97, t484); // row 3, MSY6
        put(122, t467); // row 4, MSY6
        put(140, t451); // row 5, MSY6
        [t442, t445]
    };
    // XX6: column
    let [t486, t489] = {
        let t486 = s6 * t386;
        let t487 = c6 * t388 + t486;
        let t489 = c6 * t386;
        let t490 = s6 * t388 - t489;
        let t495 = t134 * t490 - (z1_5_x * t487 + t221 * t385);
        let t498 = c5 * t385 - s5 * t487;
        put(29, t495); // row 1, XX6R
        put(67, t498); // row 2, XX6R
        put(98, t498); // row 3, XX6R
        put(123, t498); // row 4, XX6R
        put(141, t490); // row 5, XX6R
        [t486, t489]
    };
    // ZZ6: column
    {
        let t500 = t486 - c6 * t387;
        let t502 = t489 + s6 * t387;
        let t507 = t134 * t502 + (z1_5_x * t500 - t221 * dw6_z);
        let t510 = s5 * t500 + c5 * dw6_z;
        put(30, t507); // row 1, ZZ6
        put(68, t510); // row 2, ZZ6
        put(99, t510); // row 3, ZZ6
        put(124, t510); // row 4, ZZ6
        put(142, t502); // row 5, ZZ6
    }
    // XY6: column
    {
        let t511 = t394 - t391;
        let t514 = c6 * t395 - s6 * t396;
        let t517 = s6 * t395 + c6 * t396;
        let t522 = t134 * t517 - (z1_5_x * t514 + t221 * t511);
        let t525 = c5 * t511 - s5 * t514;
        put(31, t522); // row 1, XY6
        put(69, t525); // row 2, XY6
        put(100, t525); // row 3, XY6
        put(125, t525); // row 4, XY6
        put(143, t517); // row 5, XY6
        put(154, t511); // row 6, XY6
    }
    // XZ6: column
    {
        let t527 = t401 - s6 * t390;
        let t529 = t398 + c6 * t390;
        let t534 = t134 * t529 - (z1_5_x * t527 + t221 * t380);
        let t537 = c5 * t380 - s5 * t527;
        put(32, t534); // row 1, XZ6
        put(70, t537); // row 2, XZ6
        put(101, t537); // row 3, XZ6
        put(126, t537); // row 4, XZ6
        put(144, t529); // row 5, XZ6
    }
    // YZ6: column
    {
        let t538 = t394 - t259;
        let t540 = t445 + c6 * t538;
        let t542 = s6 * t538 - t442;
        let t547 = t134 * t542 - (z1_5_x * t540 + t221 * t377);
        let t550 = c5 * t377 - s5 * t540;
        let t551 = dq1.sign();
        let t552 = dq2.sign();
        let t553 = dq3.sign();
        let t554 = dq4.sign();
        let t555 = dq5.sign();
        let t556 = dq6.sign();
        put(33, t547); // row 1, YZ6
        put(35, t551); // row 1, FC1
        put(71, t550); // row 2, YZ6
        put(73, t552); // row 2, FC2
        put(102, t550); // row 3, YZ6
        put(105, t553); // row 3, FC3
        put(127, t550); // row 4, YZ6
        put(130, t554); // row 4, FC4
        put(145, t542); // row 5, YZ6
        put(148, t555); // row 5, FC5
        put(159, t556); // row 6, FC6
    }
}
