//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil
//! and Dombre, 12.4.
//!
//! 406 multiplications, 322 additions; 6 x 84, 212 of 504 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 212;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 6), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18), (0, 19), (0, 20), (0, 21),
    (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28), (0, 29), (0, 30), (0, 31),
    (0, 32), (0, 33), (0, 34), (0, 35), (0, 36), (0, 37), (0, 38), (0, 39), (0, 40), (0, 41),
    (0, 42), (0, 43), (0, 44), (0, 45), (0, 46), (0, 47), (0, 48), (0, 49), (0, 50), (0, 51),
    (0, 52), (0, 53), (0, 54), (0, 55), (0, 56), (0, 57), (0, 58), (0, 59), (0, 60), (0, 66),
    (0, 72), (0, 78), (1, 11), (1, 12), (1, 14), (1, 15), (1, 16), (1, 17), (1, 18), (1, 19),
    (1, 20), (1, 21), (1, 22), (1, 23), (1, 24), (1, 25), (1, 26), (1, 27), (1, 28), (1, 29),
    (1, 30), (1, 31), (1, 32), (1, 33), (1, 34), (1, 35), (1, 36), (1, 37), (1, 38), (1, 39),
    (1, 40), (1, 41), (1, 42), (1, 43), (1, 44), (1, 45), (1, 46), (1, 47), (1, 48), (1, 49),
    (1, 50), (1, 51), (1, 52), (1, 53), (1, 54), (1, 55), (1, 56), (1, 57), (1, 58), (1, 59),
    (1, 61), (1, 67), (1, 73), (1, 79), (2, 21), (2, 22), (2, 24), (2, 25), (2, 26), (2, 27),
    (2, 28), (2, 29), (2, 30), (2, 31), (2, 32), (2, 33), (2, 34), (2, 35), (2, 36), (2, 37),
    (2, 38), (2, 39), (2, 40), (2, 41), (2, 42), (2, 43), (2, 44), (2, 45), (2, 46), (2, 47),
    (2, 48), (2, 49), (2, 50), (2, 51), (2, 52), (2, 53), (2, 54), (2, 55), (2, 56), (2, 57),
    (2, 58), (2, 59), (2, 62), (2, 68), (2, 74), (2, 80), (3, 31), (3, 32), (3, 34), (3, 35),
    (3, 36), (3, 37), (3, 38), (3, 39), (3, 40), (3, 41), (3, 42), (3, 43), (3, 44), (3, 45),
    (3, 46), (3, 47), (3, 48), (3, 49), (3, 50), (3, 51), (3, 52), (3, 53), (3, 54), (3, 55),
    (3, 56), (3, 57), (3, 58), (3, 59), (3, 63), (3, 69), (3, 75), (3, 81), (4, 41), (4, 42),
    (4, 44), (4, 45), (4, 46), (4, 47), (4, 48), (4, 49), (4, 50), (4, 51), (4, 52), (4, 53),
    (4, 54), (4, 55), (4, 56), (4, 57), (4, 58), (4, 59), (4, 64), (4, 70), (4, 76), (4, 82),
    (5, 51), (5, 52), (5, 54), (5, 55), (5, 56), (5, 57), (5, 58), (5, 59), (5, 65), (5, 71),
    (5, 77), (5, 83),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 84 + PATTERN[k].1
}

/// Regressor `W` of the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 84]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    clear(&mut flat[0..6]);
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[7..13]),
            48 => clear(&mut flat[61..66]),
            49 => clear(&mut flat[67..72]),
            50 => clear(&mut flat[73..78]),
            51 => clear(&mut flat[79..95]),
            53 => flat[97] = S::default(),
            99 => flat[144] = S::default(),
            100 => clear(&mut flat[146..151]),
            101 => clear(&mut flat[152..157]),
            102 => clear(&mut flat[158..163]),
            103 => clear(&mut flat[164..189]),
            105 => flat[191] = S::default(),
            141 => clear(&mut flat[228..230]),
            142 => clear(&mut flat[231..236]),
            143 => clear(&mut flat[237..242]),
            144 => clear(&mut flat[243..248]),
            145 => clear(&mut flat[249..283]),
            147 => flat[285] = S::default(),
            173 => clear(&mut flat[312..315]),
            174 => clear(&mut flat[316..321]),
            175 => clear(&mut flat[322..327]),
            176 => clear(&mut flat[328..333]),
            177 => clear(&mut flat[334..377]),
            179 => flat[379] = S::default(),
            195 => clear(&mut flat[396..400]),
            196 => clear(&mut flat[401..406]),
            197 => clear(&mut flat[407..412]),
            198 => clear(&mut flat[413..418]),
            199 => clear(&mut flat[419..471]),
            201 => flat[473] = S::default(),
            207 => clear(&mut flat[480..485]),
            208 => clear(&mut flat[486..491]),
            209 => clear(&mut flat[492..497]),
            210 => clear(&mut flat[498..503]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 84]; 6]) {
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
        put(0, ddq1); // row 1, ZZ1
        put(48, ddq1); // row 1, IA1
        put(49, dq1); // row 1, FV1
        put(51, k7); // row 1, FO1
        put(56, ddq2); // row 2, ZZ2
        put(100, ddq2); // row 2, IA2
        put(101, dq2); // row 2, FV2
        put(103, k7); // row 2, FO2
        put(142, ddq3); // row 3, IA3
        put(143, dq3); // row 3, FV3
        put(145, k7); // row 3, FO3
        put(174, ddq4); // row 4, IA4
        put(175, dq4); // row 4, FV4
        put(177, k7); // row 4, FO4
        put(196, ddq5); // row 5, IA5
        put(197, dq5); // row 5, FV5
        put(199, k7); // row 5, FO5
        put(208, ddq6); // row 6, IA6
        put(209, dq6); // row 6, FV6
        put(211, k7); // row 6, FO6
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
        a2_x, a2_y, t13, t14, dw2_x, dw2_y, t17, t18,
        t19, t20, t21, t22, t23,
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
        put(52, a2_y); // row 2, MSX2
        put(53, t24); // row 2, MSY2
        put(54, t25); // row 2, XX2
        put(55, t12); // row 2, YY2
        put(58, t8); // row 2, XZ2
        put(59, t9); // row 2, YZ2
        [
        a2_x, a2_y, t13, t14, dw2_x, dw2_y, t17, t18,
        t19, t20, t21, t22, t23,
    ]
    };
    // MSZ2: column
    {
        let t28 = c2 * a2_x - s2 * a2_y;
        put(1, t28); // row 1, MSZ2
    }
    // XX2: column
    let t30 = {
        let t30 = c2 * t13;
        let t31 = s2 * dw2_x + t30;
        put(2, t31); // row 1, XX2
        t30
    };
    // YY2: column
    let t32 = {
        let t32 = s2 * t14;
        let t34 = c2 * dw2_y - t32;
        put(3, t34); // row 1, YY2
        t32
    };
    // ZZ2: column
    {
        let t35 = t32 - t30;
        put(4, t35); // row 1, ZZ2
    }
    // XY2: column
    {
        let t36 = t18 + t21;
        let t39 = s2 * t22 + c2 * t23;
        put(5, t39); // row 1, XY2
        put(57, t36); // row 2, XY2
    }
    // XZ2: column
    {
        let t42 = s2 * t20 - c2 * t17;
        put(6, t42); // row 1, XZ2
    }
    // YZ2: column
    {
        let t46 = c2 * t19 - s2 * (t21 - t0);
        put(7, t46); // row 1, YZ2
    }
    // link 3: motion
    let [
        z1_3_x, t52, w3_z, dw3_z, t57, t62, a3_y, t66,
        t67, t73, t74, dw3_x, t76, t77, t78, t79,
        t80, t81, t82, t83,
    ] = {
        let z1_3_x = s2 * c3 + c2 * s3;
        let t52 = s2 * s3 - c2 * c3;
        let w3_z = dq2 + dq3;
        let dw3_z = ddq2 + ddq3;
        let t57 = t22 * k0;
        let t58 = t18 * k0 - a2_x;
        let t59 = t20 * k0 - a2_y;
        let t62 = c3 * t58 + s3 * t59;
        let a3_y = s3 * t58 - c3 * t59;
        let t66 = ddq1 * t52;
        let t67 = ddq1 * z1_3_x;
        let w3_x = dq1 * z1_3_x;
        let t69 = dq1 * t52;
        let t70 = w3_x * w3_x;
        let t71 = w3_z * w3_z;
        let t72 = w3_x * t69;
        let t73 = w3_z * w3_x;
        let t74 = w3_z * t69;
        let dw3_x = t67 - t74;
        let t76 = t66 + t73;
        let t77 = t70 - t71;
        let t78 = t77 - t0;
        let t79 = dw3_z + t72;
        let t80 = dw3_z - t72;
        let t81 = t70 + t71;
        let t82 = t73 + t76;
        let t83 = t74 - dw3_x;
        let t84 = -t72;
        let t85 = -t66;
        put(64, t72); // row 2, XX3
        put(65, t84); // row 2, YY3
        put(66, dw3_z); // row 2, ZZ3
        put(68, t67); // row 2, XZ3
        put(69, t85); // row 2, YZ3
        put(104, a3_y); // row 3, MSX3
        put(105, t62); // row 3, MSY3
        put(106, t72); // row 3, XX3
        put(107, t84); // row 3, YY3
        put(108, dw3_z); // row 3, ZZ3
        put(110, t67); // row 3, XZ3
        put(111, t85); // row 3, YZ3
        [
        z1_3_x, t52, w3_z, dw3_z, t57, t62, a3_y, t66,
        t67, t73, t74, dw3_x, t76, t77, t78, t79,
        t80, t81, t82, t83,
    ]
    };
    // joint axes in frame 4
    let [t89, t92, t95, t99, t102, t103, v3_5_z] = {
        let t86 = k_D4 * t52;
        let t87 = k_D4 * z1_3_x;
        let t89 = t52 * k3 - v1_3_z;
        let t92 = c4 * t86 + s4 * t87;
        let t95 = s4 * t86 - c4 * t87;
        let t96 = t3 - k_A3;
        let t99 = c4 * t2 + s4 * t96;
        let t102 = c4 * t96 - s4 * t2;
        let t103 = s4 * k3;
        let v3_5_z = c4 * k3;
        [t89, t92, t95, t99, t102, t103, v3_5_z]
    };
    // M3: column
    {
        let t105 = t57 * v1_3_z;
        let t108 = t62 * t2 - a3_y * t3;
        put(8, t105); // row 1, M3
        put(60, t108); // row 2, M3
    }
    // MSX3: column
    {
        let t111 = t52 * t57 + t82 * v1_3_z;
        let t115 = a3_y - (t78 * t2 + t80 * t3);
        put(9, t111); // row 1, MSX3
        put(61, t115); // row 2, MSX3
    }
    // MSY3: column
    {
        let t118 = z1_3_x * t57 - t83 * v1_3_z;
        let t122 = t62 + (t79 * t2 + t81 * t3);
        put(10, t118); // row 1, MSY3
        put(62, t122); // row 2, MSY3
    }
    // MSZ3: column
    {
        let t127 = t52 * t62 - z1_3_x * a3_y - t0 * v1_3_z;
        let t130 = t66 * t2 + t67 * t3;
        put(11, t127); // row 1, MSZ3
        put(63, t130); // row 2, MSZ3
    }
    // XX3: column
    let t132 = {
        let t132 = t52 * t73;
        let t133 = z1_3_x * dw3_x - t132;
        put(12, t133); // row 1, XX3
        t132
    };
    // YY3: column
    let t134 = {
        let t134 = z1_3_x * t74;
        let t136 = t134 + t52 * t76;
        put(13, t136); // row 1, YY3
        t134
    };
    // ZZ3: column
    {
        let t137 = t132 - t134;
        put(14, t137); // row 1, ZZ3
    }
    // XY3: column
    {
        let t138 = t78 + t81;
        let t141 = t52 * t83 - z1_3_x * t82;
        put(15, t141); // row 1, XY3
        put(67, t138); // row 2, XY3
        put(109, t138); // row 3, XY3
    }
    // XZ3: column
    {
        let t144 = z1_3_x * t80 + t52 * t77;
        put(16, t144); // row 1, XZ3
    }
    // YZ3: column
    {
        let t148 = z1_3_x * (t0 - t81) - t52 * t79;
        put(17, t148); // row 1, YZ3
    }
    // link 4: motion
    let [
        z1_4_x, t154, w4_z, t168, t171, a4_y, t175, t176,
        w4_x, t178, t182, t183, dw4_x, t185, t186, t187,
        t188, t189, t190, t191, t192,
    ] = {
        let z1_4_x = c4 * z1_3_x - s4 * t52;
        let t154 = c4 * t52 + s4 * z1_3_x;
        let w4_z = w3_z + dq4;
        let dw4_z = dw3_z + ddq4;
        let t166 = t62 + (t78 * k3 + k_D4 * t66);
        let t167 = a3_y - (t80 * k3 + k_D4 * t67);
        let t168 = t82 * k3 + k_D4 * t0 - t57;
        let t171 = c4 * t166 - s4 * t167;
        let a4_y = c4 * t167 + s4 * t166;
        let t175 = ddq1 * t154;
        let t176 = ddq1 * z1_4_x;
        let w4_x = dq1 * z1_4_x;
        let t178 = dq1 * t154;
        let t179 = w4_x * w4_x;
        let t180 = w4_z * w4_z;
        let t181 = w4_x * t178;
        let t182 = w4_z * w4_x;
        let t183 = w4_z * t178;
        let dw4_x = t176 - t183;
        let t185 = t175 + t182;
        let t186 = t180 - t179;
        let t187 = t0 + t186;
        let t188 = dw4_z + t181;
        let t189 = dw4_z - t181;
        let t190 = t179 + t180;
        let t191 = t182 + t185;
        let t192 = t183 - dw4_x;
        let t193 = -t181;
        let t194 = -t175;
        put(74, t181); // row 2, XX4
        put(75, t193); // row 2, YY4
        put(76, dw4_z); // row 2, ZZ4
        put(78, t176); // row 2, XZ4
        put(79, t194); // row 2, YZ4
        put(116, t181); // row 3, XX4
        put(117, t193); // row 3, YY4
        put(118, dw4_z); // row 3, ZZ4
        put(120, t176); // row 3, XZ4
        put(121, t194); // row 3, YZ4
        put(146, a4_y); // row 4, MSX4
        put(147, t171); // row 4, MSY4
        put(148, t181); // row 4, XX4
        put(149, t193); // row 4, YY4
        put(150, dw4_z); // row 4, ZZ4
        put(152, t176); // row 4, XZ4
        put(153, t194); // row 4, YZ4
        [
        z1_4_x, t154, w4_z, t168, t171, a4_y, t175, t176,
        w4_x, t178, t182, t183, dw4_x, t185, t186, t187,
        t188, t189, t190, t191, t192,
    ]
    };
    // joint axes in frame 5
    let [t196, t197, t198] = {
        let t196 = t89 + k_D5 * z1_4_x;
        let t197 = k_D5 - t99;
        let t198 = k_D5 - t103;
        [t196, t197, t198]
    };
    // M4: column
    {
        let t203 = t168 * t89 + (t171 * t92 + a4_y * t95);
        let t206 = t171 * t99 - a4_y * t102;
        let t209 = t171 * t103 - a4_y * v3_5_z;
        put(18, t203); // row 1, M4
        put(70, t206); // row 2, M4
        put(112, t209); // row 3, M4
    }
    // MSX4: column
    {
        let t216 = t187 * t92 + t189 * t95 - t191 * t89 - t154 * t168;
        let t220 = a4_y + (t187 * t99 - t189 * t102);
        let t224 = a4_y + (t187 * t103 - t189 * v3_5_z);
        put(19, t216); // row 1, MSX4
        put(71, t220); // row 2, MSX4
        put(113, t224); // row 3, MSX4
    }
    // MSY4: column
    let [t227, t233, t237] = {
        let t227 = t190 * t95;
        let t231 = t192 * t89 - (t227 - t188 * t92) - z1_4_x * t168;
        let t233 = t190 * t102;
        let t235 = t171 + (t188 * t99 + t233);
        let t237 = t190 * v3_5_z;
        let t239 = t171 + (t188 * t103 + t237);
        put(20, t231); // row 1, MSY4
        put(72, t235); // row 2, MSY4
        put(114, t239); // row 3, MSY4
        [t227, t233, t237]
    };
    // MSZ4: column
    {
        let t247 = t0 * t89 + (t175 * t92 - t176 * t95);
        let t248 = t154 * t171 - z1_4_x * a4_y + t247;
        let t251 = t175 * t99 + t176 * t102;
        let t254 = t175 * t103 + t176 * v3_5_z;
        put(21, t248); // row 1, MSZ4
        put(73, t251); // row 2, MSZ4
        put(115, t254); // row 3, MSZ4
    }
    // XX4: column
    let t256 = {
        let t256 = t154 * t182;
        let t257 = z1_4_x * dw4_x - t256;
        put(22, t257); // row 1, XX4
        t256
    };
    // YY4: column
    let t258 = {
        let t258 = z1_4_x * t183;
        let t260 = t258 + t154 * t185;
        put(23, t260); // row 1, YY4
        t258
    };
    // ZZ4: column
    {
        let t261 = t256 - t258;
        put(24, t261); // row 1, ZZ4
    }
    // XY4: column
    {
        let t262 = t190 - t187;
        let t265 = t154 * t192 - z1_4_x * t191;
        put(25, t265); // row 1, XY4
        put(77, t262); // row 2, XY4
        put(119, t262); // row 3, XY4
        put(151, t262); // row 4, XY4
    }
    // XZ4: column
    {
        let t268 = z1_4_x * t189 - t154 * t186;
        put(26, t268); // row 1, XZ4
    }
    // YZ4: column
    {
        let t272 = z1_4_x * (t0 - t190) - t154 * t188;
        put(27, t272); // row 1, YZ4
    }
    // link 5: motion
    let [
        z1_5_x, t274, t279, t283, t286, w5_x, w5_y, t295,
        t298, w5_z, dw5_z, t303, t304, t305, dw5_x, t307,
        t308, t309, t310, t311, t312, t313, t314,
    ] = {
        let z1_5_x = c5 * z1_4_x;
        let t274 = s5 * z1_4_x;
        let t278 = t171 - k_D5 * t188;
        let t279 = a4_y + k_D5 * t190;
        let t280 = t168 - k_D5 * t192;
        let t283 = c5 * t278 + s5 * t280;
        let t286 = c5 * t280 - s5 * t278;
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t295 = c5 * t188 + s5 * t192;
        let t298 = s5 * t188 - c5 * t192;
        let w5_z = t178 + dq5;
        let dw5_z = t185 + ddq5;
        let t301 = w5_x * w5_x;
        let t302 = w5_z * w5_z;
        let t303 = w5_x * w5_y;
        let t304 = w5_x * w5_z;
        let t305 = w5_y * w5_z;
        let dw5_x = t298 + t305;
        let t307 = t295 - t304;
        let t308 = t302 - t301;
        let t309 = t190 + t308;
        let t310 = t303 - dw5_z;
        let t311 = dw5_z + t303;
        let t312 = t301 + t302;
        let t313 = t307 - t304;
        let t314 = t305 + dw5_x;
        let t315 = -t286;
        let t316 = -t303;
        put(178, t315); // row 5, MSX5
        put(179, t283); // row 5, MSY5
        put(180, t316); // row 5, XX5
        put(181, t303); // row 5, YY5
        put(182, dw5_z); // row 5, ZZ5
        put(184, t298); // row 5, XZ5
        put(185, t295); // row 5, YZ5
        [
        z1_5_x, t274, t279, t283, t286, w5_x, w5_y, t295,
        t298, w5_z, dw5_z, t303, t304, t305, dw5_x, t307,
        t308, t309, t310, t311, t312, t313, t314,
    ]
    };
    // M5: column
    let [t319, t322] = {
        let t319 = s5 * t286 - c5 * t283;
        let t322 = s5 * t283 + c5 * t286;
        let t324 = k_D5 * t319;
        let t331 = z1_4_x * (k_D5 * t322) + (t89 * t322 + (t279 * t95 - t92 * t319));
        let t335 = t324 - (t99 * t319 + t279 * t102);
        let t339 = t324 - (t103 * t319 + t279 * v3_5_z);
        put(28, t331); // row 1, M5
        put(80, t335); // row 2, M5
        put(122, t339); // row 3, M5
        put(154, t324); // row 4, M5
        [t319, t322]
    };
    // MSX5: column
    let [t341, t346, t347] = {
        let t341 = s5 * t311;
        let t342 = c5 * t309 + t341;
        let t345 = s5 * t309 - c5 * t311;
        let t346 = s5 * t279;
        let t347 = c5 * t279;
        let t351 = t347 - k_D5 * t342;
        let t354 = t154 * t286 - z1_4_x * (k_D5 * t345 - t346);
        let t360 = t89 * t345 + (t92 * t342 + t313 * t95) - t354;
        let t364 = t351 - (t313 * t102 - t99 * t342);
        let t368 = t351 + (t103 * t342 - t313 * v3_5_z);
        put(29, t360); // row 1, MSX5
        put(81, t364); // row 2, MSX5
        put(123, t368); // row 3, MSX5
        put(155, t351); // row 4, MSX5
        [t341, t346, t347]
    };
    // MSY5: column
    let [t369, t370, t373] = {
        let t369 = c5 * t310;
        let t370 = s5 * t312;
        let t371 = t369 + t370;
        let t373 = c5 * t312;
        let t374 = t373 - s5 * t310;
        let t378 = k_D5 * t371 - t346;
        let t386 = t89 * t374 - (t92 * t371 + t314 * t95);
        let t387 = z1_4_x * (k_D5 * t374 - t347) + t154 * t283 + t386;
        let t391 = t378 + (t314 * t102 - t99 * t371);
        let t395 = t378 + (t314 * v3_5_z - t103 * t371);
        put(30, t387); // row 1, MSY5
        put(82, t391); // row 2, MSY5
        put(124, t395); // row 3, MSY5
        put(156, t378); // row 4, MSY5
        [t369, t370, t373]
    };
    // MSZ5: column
    {
        let t398 = c5 * t295 + s5 * t298;
        let t401 = c5 * t298 - s5 * t295;
        let t405 = t319 + k_D5 * t398;
        let t411 = z1_4_x * (t322 + k_D5 * t401) + (t89 * t401 + (t227 - t92 * t398));
        let t414 = t405 - (t233 + t99 * t398);
        let t417 = t405 - (t237 + t103 * t398);
        put(31, t411); // row 1, MSZ5
        put(83, t414); // row 2, MSZ5
        put(125, t417); // row 3, MSZ5
        put(157, t405); // row 4, MSZ5
    }
    // XX5: column
    let [t419, t420, t424] = {
        let t419 = t274 * t304;
        let t420 = t154 * t303;
        let t422 = z1_5_x * dw5_x - t419 - t420;
        let t424 = c5 * t304;
        let t425 = s5 * dw5_x + t424;
        put(32, t422); // row 1, XX5
        put(84, t425); // row 2, XX5
        put(126, t425); // row 3, XX5
        put(158, t425); // row 4, XX5
        [t419, t420, t424]
    };
    // YY5: column
    let [t426, t430] = {
        let t426 = z1_5_x * t305;
        let t429 = t420 - (t426 + t274 * t307);
        let t430 = s5 * t305;
        let t432 = c5 * t307 - t430;
        put(33, t429); // row 1, YY5
        put(85, t432); // row 2, YY5
        put(127, t432); // row 3, YY5
        put(159, t432); // row 4, YY5
        [t426, t430]
    };
    // ZZ5: column
    {
        let t435 = t154 * dw5_z + (t419 + t426);
        let t436 = t430 - t424;
        put(34, t435); // row 1, ZZ5
        put(86, t436); // row 2, ZZ5
        put(128, t436); // row 3, ZZ5
        put(160, t436); // row 4, ZZ5
    }
    // XY5: column
    {
        let t437 = t312 - t309;
        let t442 = t154 * t437 + (z1_5_x * t313 - t274 * t314);
        let t445 = s5 * t313 + c5 * t314;
        put(35, t442); // row 1, XY5
        put(87, t445); // row 2, XY5
        put(129, t445); // row 3, XY5
        put(161, t445); // row 4, XY5
        put(183, t437); // row 5, XY5
    }
    // XZ5: column
    {
        let t450 = t154 * t298 + (z1_5_x * t311 - t274 * t308);
        let t452 = t341 + c5 * t308;
        put(36, t450); // row 1, XZ5
        put(88, t452); // row 2, XZ5
        put(130, t452); // row 3, XZ5
        put(162, t452); // row 4, XZ5
    }
    // YZ5: column
    {
        let t453 = t190 - t312;
        let t458 = t154 * t295 + (z1_5_x * t453 + t274 * t310);
        let t460 = s5 * t453 - t369;
        put(37, t458); // row 1, YZ5
        put(89, t460); // row 2, YZ5
        put(131, t460); // row 3, YZ5
        put(163, t460); // row 4, YZ5
    }
    // link 6: motion
    let [
        t465, t469, a6_y, t481, t484, dw6_z, t489, t490,
        t491, t492, t493, t494, t495, t496, t497, t498,
        t499, t500,
    ] = {
        let t464 = t283 - k_D6 * t310;
        let t465 = t286 + k_D6 * t312;
        let t466 = t279 - k_D6 * t314;
        let t469 = c6 * t464 - s6 * t466;
        let a6_y = c6 * t466 + s6 * t464;
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t478 = c6 * w5_z + s6 * w5_x;
        let t481 = c6 * t310 - s6 * t314;
        let t484 = c6 * t314 + s6 * t310;
        let w6_z = w5_y + dq6;
        let dw6_z = t307 + ddq6;
        let t487 = w6_x * w6_x;
        let t488 = w6_z * w6_z;
        let t489 = w6_x * t478;
        let t490 = w6_x * w6_z;
        let t491 = t478 * w6_z;
        let t492 = t491 - t484;
        let t493 = t490 - t481;
        let t494 = t487 - t488;
        let t495 = t312 - t494;
        let t496 = dw6_z + t489;
        let t497 = dw6_z - t489;
        let t498 = t487 + t488;
        let t499 = t490 + t493;
        let t500 = t491 + t492;
        let t501 = -t489;
        put(200, a6_y); // row 6, MSX6
        put(201, t469); // row 6, MSY6
        put(202, t489); // row 6, XX6
        put(203, t501); // row 6, YY6
        put(204, dw6_z); // row 6, ZZ6
        put(206, t484); // row 6, XZ6
        put(207, t481); // row 6, YZ6
        [
        t465, t469, a6_y, t481, t484, dw6_z, t489, t490,
        t491, t492, t493, t494, t495, t496, t497, t498,
        t499, t500,
    ]
    };
    // M6: column
    let [t504, t507] = {
        let t504 = c6 * t469 + s6 * a6_y;
        let t507 = s6 * t469 - c6 * a6_y;
        let t508 = k_D6 * t507;
        let t509 = k_D6 * t504;
        let t512 = s5 * t465 - c5 * t504;
        let t520 = t196 * (s5 * t504 + c5 * t465) - (t92 * t512 + t95 * t507);
        let t524 = t520 + (z1_5_x * t508 + t154 * t509);
        let t528 = s5 * t508;
        let t529 = t197 * t512 + t102 * t507 + t528;
        let t533 = t528 + (t198 * t512 + v3_5_z * t507);
        let t535 = t528 + k_D5 * t512;
        put(38, t524); // row 1, M6
        put(90, t529); // row 2, M6
        put(132, t533); // row 3, M6
        put(164, t535); // row 4, M6
        put(186, t509); // row 5, M6
        [t504, t507]
    };
    // MSX6: column
    let [t537, t540, t542, t543] = {
        let t537 = s6 * t497;
        let t538 = c6 * t495 + t537;
        let t540 = c6 * t497;
        let t541 = s6 * t495 - t540;
        let t542 = s6 * t465;
        let t543 = c6 * t465;
        let t546 = k_D6 * t541 - t542;
        let t547 = k_D6 * t538 - t543;
        let t550 = c5 * t538 + s5 * t499;
        let t558 = t196 * (c5 * t499 - s5 * t538) - (t92 * t550 - t95 * t541);
        let t564 = t154 * t547 + (z1_5_x * t546 - t274 * a6_y) - t558;
        let t570 = s5 * t546 + c5 * a6_y;
        let t571 = t102 * t541 - t197 * t550 + t570;
        let t575 = t570 + (v3_5_z * t541 - t198 * t550);
        let t577 = t570 - k_D5 * t550;
        put(39, t564); // row 1, MSX6
        put(91, t571); // row 2, MSX6
        put(133, t575); // row 3, MSX6
        put(165, t577); // row 4, MSX6
        put(187, t547); // row 5, MSX6
        [t537, t540, t542, t543]
    };
    // MSY6: column
    let [t578, t581] = {
        let t578 = c6 * t496;
        let t580 = t578 - s6 * t498;
        let t581 = s6 * t496;
        let t583 = t581 + c6 * t498;
        let t586 = t543 - k_D6 * t583;
        let t587 = t542 + k_D6 * t580;
        let t590 = s5 * t500 - c5 * t580;
        let t598 = t196 * (s5 * t580 + c5 * t500) - (t92 * t590 + t95 * t583);
        let t604 = t598 + (t154 * t587 - (z1_5_x * t586 + t274 * t469));
        let t610 = c5 * t469 - s5 * t586;
        let t611 = t197 * t590 + t102 * t583 + t610;
        let t615 = t610 + (t198 * t590 + v3_5_z * t583);
        let t617 = t610 + k_D5 * t590;
        put(40, t604); // row 1, MSY6
        put(92, t611); // row 2, MSY6
        put(134, t615); // row 3, MSY6
        put(166, t617); // row 4, MSY6
        put(188, t587); // row 5, MSY6
        [t578, t581]
    };
    // MSZ6: column
    {
        let t620 = c6 * t481 + s6 * t484;
        let t623 = s6 * t481 - c6 * t484;
        let t626 = t507 - k_D6 * t623;
        let t627 = t504 - k_D6 * t620;
        let t629 = t370 + c5 * t620;
        let t636 = t92 * t629 - t95 * t623 - t196 * (t373 - s5 * t620);
        let t640 = z1_5_x * t626 + t154 * t627 - t636;
        let t644 = s5 * t626;
        let t645 = t197 * t629 - t102 * t623 + t644;
        let t649 = t644 + (t198 * t629 - v3_5_z * t623);
        let t651 = t644 + k_D5 * t629;
        put(41, t640); // row 1, MSZ6
        put(93, t645); // row 2, MSZ6
        put(135, t649); // row 3, MSZ6
        put(167, t651); // row 4, MSZ6
        put(189, t627); // row 5, MSZ6
    }
    // XX6: column
    let [t653, t656, t659, t664] = {
        let t653 = s6 * t490;
        let t654 = c6 * t492 + t653;
        let t656 = c6 * t490;
        let t657 = s6 * t492 - t656;
        let t659 = t274 * t489;
        let t662 = t154 * t657 - (z1_5_x * t654 + t659);
        let t664 = c5 * t489;
        let t665 = t664 - s5 * t654;
        put(42, t662); // row 1, XX6
        put(94, t665); // row 2, XX6
        put(136, t665); // row 3, XX6
        put(168, t665); // row 4, XX6
        put(190, t657); // row 5, XX6
        [t653, t656, t659, t664]
    };
    // YY6: column
    let [t666, t669] = {
        let t666 = c6 * t491;
        let t668 = t666 + s6 * t493;
        let t669 = s6 * t491;
        let t671 = c6 * t493 - t669;
        let t675 = t154 * t671 + (t659 + z1_5_x * t668);
        let t677 = s5 * t668 - t664;
        put(43, t675); // row 1, YY6
        put(95, t677); // row 2, YY6
        put(137, t677); // row 3, YY6
        put(169, t677); // row 4, YY6
        put(191, t671); // row 5, YY6
        [t666, t669]
    };
    // ZZ6: column
    {
        let t678 = t666 - t653;
        let t679 = t656 + t669;
        let t684 = t154 * t679 - (z1_5_x * t678 + t274 * dw6_z);
        let t687 = c5 * dw6_z - s5 * t678;
        put(44, t684); // row 1, ZZ6
        put(96, t687); // row 2, ZZ6
        put(138, t687); // row 3, ZZ6
        put(170, t687); // row 4, ZZ6
        put(192, t679); // row 5, ZZ6
    }
    // XY6: column
    {
        let t688 = t498 - t495;
        let t691 = s6 * t500 - c6 * t499;
        let t694 = s6 * t499 + c6 * t500;
        let t699 = t154 * t694 - (t274 * t688 - z1_5_x * t691);
        let t702 = s5 * t691 + c5 * t688;
        put(45, t699); // row 1, XY6
        put(97, t702); // row 2, XY6
        put(139, t702); // row 3, XY6
        put(171, t702); // row 4, XY6
        put(193, t694); // row 5, XY6
        put(205, t688); // row 6, XY6
    }
    // XZ6: column
    {
        let t704 = t540 + s6 * t494;
        let t706 = c6 * t494 - t537;
        let t711 = t154 * t706 + (z1_5_x * t704 - t274 * t484);
        let t714 = s5 * t704 + c5 * t484;
        put(46, t711); // row 1, XZ6
        put(98, t714); // row 2, XZ6
        put(140, t714); // row 3, XZ6
        put(172, t714); // row 4, XZ6
        put(194, t706); // row 5, XZ6
    }
    // YZ6: column
    {
        let t715 = t498 - t312;
        let t717 = t581 + c6 * t715;
        let t719 = s6 * t715 - t578;
        let t724 = t154 * t719 - (z1_5_x * t717 + t274 * t481);
        let t727 = c5 * t481 - s5 * t717;
        let t728 = dq1.sign();
        let t729 = dq2.sign();
        let t730 = dq3.sign();
        let t731 = dq4.sign();
        let t732 = dq5.sign();
        let t733 = dq6.sign();
        put(47, t724); // row 1, YZ6
        put(50, t728); // row 1, FC1
        put(99, t727); // row 2, YZ6
        put(102, t729); // row 2, FC2
        put(141, t727); // row 3, YZ6
        put(144, t730); // row 3, FC3
        put(173, t727); // row 4, YZ6
        put(176, t731); // row 4, FC4
        put(195, t719); // row 5, YZ6
        put(198, t732); // row 5, FC5
        put(210, t733); // row 6, FC6
    }
}
