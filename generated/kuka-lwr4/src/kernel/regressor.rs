//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil
//! and Dombre, 12.4.
//!
//! 757 multiplications, 578 additions; 7 x 84, 266 of 588 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 266;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 6), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18), (0, 19), (0, 20), (0, 21),
    (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28), (0, 29), (0, 30), (0, 31),
    (0, 32), (0, 33), (0, 34), (0, 35), (0, 36), (0, 37), (0, 38), (0, 39), (0, 40), (0, 41),
    (0, 42), (0, 43), (0, 44), (0, 45), (0, 46), (0, 47), (0, 48), (0, 49), (0, 50), (0, 51),
    (0, 52), (0, 53), (0, 54), (0, 55), (0, 56), (0, 57), (0, 58), (0, 59), (0, 60), (0, 61),
    (0, 62), (0, 63), (0, 64), (0, 65), (0, 66), (0, 67), (0, 68), (0, 69), (0, 70), (0, 77),
    (1, 11), (1, 12), (1, 14), (1, 15), (1, 16), (1, 17), (1, 18), (1, 19), (1, 20), (1, 21),
    (1, 22), (1, 23), (1, 24), (1, 25), (1, 26), (1, 27), (1, 28), (1, 29), (1, 30), (1, 31),
    (1, 32), (1, 33), (1, 34), (1, 35), (1, 36), (1, 37), (1, 38), (1, 39), (1, 40), (1, 41),
    (1, 42), (1, 43), (1, 44), (1, 45), (1, 46), (1, 47), (1, 48), (1, 49), (1, 50), (1, 51),
    (1, 52), (1, 53), (1, 54), (1, 55), (1, 56), (1, 57), (1, 58), (1, 59), (1, 60), (1, 61),
    (1, 62), (1, 63), (1, 64), (1, 65), (1, 66), (1, 67), (1, 68), (1, 69), (1, 71), (1, 78),
    (2, 21), (2, 22), (2, 24), (2, 25), (2, 26), (2, 27), (2, 28), (2, 29), (2, 31), (2, 32),
    (2, 33), (2, 34), (2, 35), (2, 36), (2, 37), (2, 38), (2, 39), (2, 40), (2, 41), (2, 42),
    (2, 43), (2, 44), (2, 45), (2, 46), (2, 47), (2, 48), (2, 49), (2, 50), (2, 51), (2, 52),
    (2, 53), (2, 54), (2, 55), (2, 56), (2, 57), (2, 58), (2, 59), (2, 60), (2, 61), (2, 62),
    (2, 63), (2, 64), (2, 65), (2, 66), (2, 67), (2, 68), (2, 69), (2, 72), (2, 79), (3, 31),
    (3, 32), (3, 34), (3, 35), (3, 36), (3, 37), (3, 38), (3, 39), (3, 40), (3, 41), (3, 42),
    (3, 43), (3, 44), (3, 45), (3, 46), (3, 47), (3, 48), (3, 49), (3, 50), (3, 51), (3, 52),
    (3, 53), (3, 54), (3, 55), (3, 56), (3, 57), (3, 58), (3, 59), (3, 60), (3, 61), (3, 62),
    (3, 63), (3, 64), (3, 65), (3, 66), (3, 67), (3, 68), (3, 69), (3, 73), (3, 80), (4, 41),
    (4, 42), (4, 44), (4, 45), (4, 46), (4, 47), (4, 48), (4, 49), (4, 51), (4, 52), (4, 53),
    (4, 54), (4, 55), (4, 56), (4, 57), (4, 58), (4, 59), (4, 61), (4, 62), (4, 63), (4, 64),
    (4, 65), (4, 66), (4, 67), (4, 68), (4, 69), (4, 74), (4, 81), (5, 51), (5, 52), (5, 54),
    (5, 55), (5, 56), (5, 57), (5, 58), (5, 59), (5, 61), (5, 62), (5, 63), (5, 64), (5, 65),
    (5, 66), (5, 67), (5, 68), (5, 69), (5, 75), (5, 82), (6, 61), (6, 62), (6, 64), (6, 65),
    (6, 66), (6, 67), (6, 68), (6, 69), (6, 76), (6, 83),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 84 + PATTERN[k].1
}

/// Regressor `W` of the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 84]; 7]) {
    let flat = &mut out.as_flattened_mut()[..];
    clear(&mut flat[0..6]);
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[7..13]),
            58 => clear(&mut flat[71..77]),
            59 => clear(&mut flat[78..95]),
            61 => flat[97] = S::default(),
            117 => flat[154] = S::default(),
            118 => clear(&mut flat[156..162]),
            119 => clear(&mut flat[163..189]),
            121 => flat[191] = S::default(),
            127 => flat[198] = S::default(),
            166 => clear(&mut flat[238..240]),
            167 => clear(&mut flat[241..247]),
            168 => clear(&mut flat[248..283]),
            170 => flat[285] = S::default(),
            206 => clear(&mut flat[322..325]),
            207 => clear(&mut flat[326..332]),
            208 => clear(&mut flat[333..377]),
            210 => flat[379] = S::default(),
            216 => flat[386] = S::default(),
            225 => flat[396] = S::default(),
            234 => clear(&mut flat[406..410]),
            235 => clear(&mut flat[411..417]),
            236 => clear(&mut flat[418..471]),
            238 => flat[473] = S::default(),
            244 => flat[480] = S::default(),
            253 => clear(&mut flat[490..495]),
            254 => clear(&mut flat[496..502]),
            255 => clear(&mut flat[503..565]),
            257 => flat[567] = S::default(),
            263 => clear(&mut flat[574..580]),
            264 => clear(&mut flat[581..587]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 84]; 7]) {
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
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        put(0, ddq1); // row 1, ZZ1
        put(58, dq1); // row 1, FV1
        put(64, ddq2); // row 2, ZZ2
        put(118, dq2); // row 2, FV2
        put(167, dq3); // row 3, FV3
        put(207, dq4); // row 4, FV4
        put(235, dq5); // row 5, FV5
        put(254, dq6); // row 6, FV6
        put(264, dq7); // row 7, FV7
        t0
    };
    // joint axes in frame 3
    let [t2, t3, t4, v2_3_y] = {
        let t1 = s2 * k_L2;
        let t2 = s3 * t1;
        let t3 = c3 * t1;
        let t4 = c3 * k_L2;
        let v2_3_y = s3 * k_L2;
        [t2, t3, t4, v2_3_y]
    };
    // link 2: motion
    let [
        a2_x, a2_y, w2_x, w2_y, t15, t16, dw2_x, dw2_y,
        t19, t20, t21, t22, t23, t24, t25,
    ] = {
        let a2_x = s2 * k1;
        let a2_y = c2 * k1;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t10 = s2 * ddq1;
        let t11 = c2 * ddq1;
        let t12 = w2_x * w2_x;
        let t13 = dq2 * dq2;
        let t14 = w2_x * w2_y;
        let t15 = dq2 * w2_x;
        let t16 = dq2 * w2_y;
        let dw2_x = t10 + t16;
        let dw2_y = t11 - t15;
        let t19 = t12 - t13;
        let t20 = t19 - t0;
        let t21 = ddq2 - t14;
        let t22 = ddq2 + t14;
        let t23 = t12 + t13;
        let t24 = dw2_y - t15;
        let t25 = t16 + dw2_x;
        let t26 = -a2_x;
        let t27 = -t14;
        put(60, a2_y); // row 2, MSX2
        put(61, t26); // row 2, MSY2
        put(62, t27); // row 2, XX2
        put(63, t14); // row 2, YY2
        put(66, t10); // row 2, XZ2
        put(67, t11); // row 2, YZ2
        [
        a2_x, a2_y, w2_x, w2_y, t15, t16, dw2_x, dw2_y,
        t19, t20, t21, t22, t23, t24, t25,
    ]
    };
    // MSZ2: column
    {
        let t30 = c2 * a2_x - s2 * a2_y;
        put(1, t30); // row 1, MSZ2
    }
    // XX2: column
    let t32 = {
        let t32 = c2 * t15;
        let t33 = s2 * dw2_x + t32;
        put(2, t33); // row 1, XX2
        t32
    };
    // YY2: column
    let t34 = {
        let t34 = s2 * t16;
        let t36 = c2 * dw2_y - t34;
        put(3, t36); // row 1, YY2
        t34
    };
    // ZZ2: column
    {
        let t37 = t34 - t32;
        put(4, t37); // row 1, ZZ2
    }
    // XY2: column
    {
        let t38 = t20 + t23;
        let t41 = s2 * t24 + c2 * t25;
        put(5, t41); // row 1, XY2
        put(65, t38); // row 2, XY2
    }
    // XZ2: column
    {
        let t44 = s2 * t22 - c2 * t19;
        put(6, t44); // row 1, XZ2
    }
    // YZ2: column
    {
        let t48 = s2 * (t0 - t23) + c2 * t21;
        put(7, t48); // row 1, YZ2
    }
    // link 3: motion
    let [
        z1_3_x, t50, a3_z, t58, a3_y, w3_x, t67, t70,
        t73, w3_z, dw3_z, t78, t79, t80, t81, t82,
        t83, t84, t85, t86, t87, t88, t89,
    ] = {
        let z1_3_x = s2 * c3;
        let t50 = s2 * s3;
        let t53 = k_L2 * t25;
        let t54 = k_L2 * t21 - a2_x;
        let a3_z = a2_y - k_L2 * t23;
        let t58 = c3 * t54 + s3 * t53;
        let a3_y = s3 * t54 - c3 * t53;
        let w3_x = c3 * w2_x - s3 * dq2;
        let t67 = c3 * dq2 + s3 * w2_x;
        let t70 = c3 * t21 + s3 * t25;
        let t73 = c3 * t25 - s3 * t21;
        let w3_z = w2_y + dq3;
        let dw3_z = dw2_y + ddq3;
        let t76 = w3_x * w3_x;
        let t77 = w3_z * w3_z;
        let t78 = w3_x * t67;
        let t79 = w3_x * w3_z;
        let t80 = t67 * w3_z;
        let t81 = t80 - t73;
        let t82 = t70 + t79;
        let t83 = t76 - t77;
        let t84 = t83 - t23;
        let t85 = dw3_z + t78;
        let t86 = dw3_z - t78;
        let t87 = t76 + t77;
        let t88 = t79 + t82;
        let t89 = t80 + t81;
        let t90 = -t78;
        let t91 = -t70;
        put(120, a3_y); // row 3, MSX3
        put(121, t58); // row 3, MSY3
        put(122, t78); // row 3, XX3
        put(123, t90); // row 3, YY3
        put(124, dw3_z); // row 3, ZZ3
        put(126, t73); // row 3, XZ3
        put(127, t91); // row 3, YZ3
        [
        z1_3_x, t50, a3_z, t58, a3_y, w3_x, t67, t70,
        t73, w3_z, dw3_z, t78, t79, t80, t81, t82,
        t83, t84, t85, t86, t87, t88, t89,
    ]
    };
    // joint axes in frame 4
    let [t94, z1_5_z, t98, v1_4_y, t100, z2_4_y, t102, v2_4_y] = {
        let t94 = c2 * s4 - c4 * z1_3_x;
        let z1_5_z = c2 * c4 + s4 * z1_3_x;
        let t98 = c4 * t2;
        let v1_4_y = s4 * t2;
        let t100 = s3 * c4;
        let z2_4_y = s3 * s4;
        let t102 = c4 * t4;
        let v2_4_y = s4 * t4;
        [t94, z1_5_z, t98, v1_4_y, t100, z2_4_y, t102, v2_4_y]
    };
    // M3: column
    let [t106, t109] = {
        let t104 = k_L2 * a3_y;
        let t105 = k_L2 * t58;
        let t106 = z1_3_x * t104;
        let t108 = t50 * t105 - t106;
        let t109 = s3 * t104;
        let t111 = t109 + c3 * t105;
        put(8, t108); // row 1, M3
        put(68, t111); // row 2, M3
        [t106, t109]
    };
    // MSX3: column
    {
        let t112 = k_L2 * t86;
        let t114 = k_L2 * t84 - a3_z;
        let t119 = c2 * a3_y - (z1_3_x * t112 + t50 * t114);
        let t122 = s3 * t112 - c3 * t114;
        put(9, t119); // row 1, MSX3
        put(69, t122); // row 2, MSX3
    }
    // MSY3: column
    let t123 = {
        let t123 = k_L2 * t87;
        let t124 = k_L2 * t85;
        let t125 = a3_z + t123;
        let t130 = c2 * t58 + (z1_3_x * t125 + t50 * t124);
        let t133 = c3 * t124 - s3 * t125;
        put(10, t130); // row 1, MSY3
        put(70, t133); // row 2, MSY3
        t123
    };
    // MSZ3: column
    {
        let t136 = k_L2 * t73 - a3_y;
        let t137 = t58 + k_L2 * t70;
        let t140 = z1_3_x * t136 + t50 * t137;
        let t143 = c3 * t137 - s3 * t136;
        put(11, t140); // row 1, MSZ3
        put(71, t143); // row 2, MSZ3
    }
    // XX3: column
    let [t145, t146, t150] = {
        let t145 = t50 * t79;
        let t146 = c2 * t78;
        let t148 = t146 - (z1_3_x * t81 + t145);
        let t150 = c3 * t79;
        let t151 = s3 * t81 - t150;
        put(12, t148); // row 1, XX3
        put(72, t151); // row 2, XX3
        [t145, t146, t150]
    };
    // YY3: column
    let [t152, t156] = {
        let t152 = z1_3_x * t80;
        let t155 = t152 + t50 * t82 - t146;
        let t156 = s3 * t80;
        let t158 = c3 * t82 - t156;
        put(13, t155); // row 1, YY3
        put(73, t158); // row 2, YY3
        [t152, t156]
    };
    // ZZ3: column
    {
        let t161 = c2 * dw3_z + (t145 - t152);
        let t162 = t150 + t156;
        put(14, t161); // row 1, ZZ3
        put(74, t162); // row 2, ZZ3
    }
    // XY3: column
    {
        let t163 = t84 + t87;
        let t168 = c2 * t163 + (t50 * t89 - z1_3_x * t88);
        let t171 = s3 * t88 + c3 * t89;
        put(15, t168); // row 1, XY3
        put(75, t171); // row 2, XY3
        put(125, t163); // row 3, XY3
    }
    // XZ3: column
    {
        let t176 = c2 * t73 + (z1_3_x * t86 + t50 * t83);
        let t179 = c3 * t83 - s3 * t86;
        put(16, t176); // row 1, XZ3
        put(76, t179); // row 2, XZ3
    }
    // YZ3: column
    {
        let t180 = t23 - t87;
        let t185 = z1_3_x * t180 - t50 * t85 - c2 * t70;
        let t189 = -(s3 * t180 + c3 * t85);
        put(17, t185); // row 1, YZ3
        put(77, t189); // row 2, YZ3
    }
    // joint axes in frame 5
    let [
        t196, z1_6_z, t202, v1_5_y, t212, t215, v2_5_x, v2_5_y,
        t223, z3_5_y, v3_5_x, v3_5_y, v4_5_x, v4_6_z,
    ] = {
        let t192 = t98 + k_L3 * t50;
        let t193 = k_L3 * t94 - t3;
        let t196 = c5 * t94 + s5 * t50;
        let z1_6_z = c5 * t50 - s5 * t94;
        let t202 = s5 * t193 - c5 * t192;
        let v1_5_y = c5 * t193 + s5 * t192;
        let t208 = t102 + c3 * k_L3;
        let t209 = v2_3_y + k_L3 * t100;
        let t212 = c5 * t100 + c3 * s5;
        let t215 = c3 * c5 - s5 * t100;
        let v2_5_x = s5 * t209 - c5 * t208;
        let v2_5_y = c5 * t209 + s5 * t208;
        let t222 = s4 * k_L3;
        let t223 = s4 * c5;
        let z3_5_y = s4 * s5;
        let v3_5_x = s5 * t222;
        let v3_5_y = c5 * t222;
        let v4_5_x = c5 * k_L3;
        let v4_6_z = s5 * k_L3;
        [
        t196, z1_6_z, t202, v1_5_y, t212, t215, v2_5_x, v2_5_y,
        t223, z3_5_y, v3_5_x, v3_5_y, v4_5_x, v4_6_z,
    ]
    };
    // joint axes in frame 6
    let [z1_6_x, z1_6_y, t237, z2_6_y, z3_6_x, z3_6_y, z4_6_x, t248] = {
        let z1_6_x = s6 * z1_5_z - c6 * t196;
        let z1_6_y = c6 * z1_5_z + s6 * t196;
        let t237 = c6 * t212 + s6 * z2_4_y;
        let z2_6_y = s6 * t212 - c6 * z2_4_y;
        let z3_6_x = c4 * s6 - c6 * t223;
        let z3_6_y = c4 * c6 + s6 * t223;
        let z4_6_x = s5 * c6;
        let t248 = s5 * s6;
        [z1_6_x, z1_6_y, t237, z2_6_y, z3_6_x, z3_6_y, z4_6_x, t248]
    };
    // joint axes in frame 7
    let [
        t251, t254, t257, t260, z3_7_x, t266, z4_7_x, z4_7_y,
        z5_7_x, t274,
    ] = {
        let t251 = s7 * z1_6_z - c7 * z1_6_x;
        let t254 = c7 * z1_6_z + s7 * z1_6_x;
        let t257 = c7 * t237 + s7 * t215;
        let t260 = c7 * t215 - s7 * t237;
        let z3_7_x = c7 * z3_6_x + s7 * z3_5_y;
        let t266 = s7 * z3_6_x - c7 * z3_5_y;
        let z4_7_x = c7 * z4_6_x + c5 * s7;
        let z4_7_y = c5 * c7 - s7 * z4_6_x;
        let z5_7_x = s6 * c7;
        let t274 = s6 * s7;
        [
        t251, t254, t257, t260, z3_7_x, t266, z4_7_x, z4_7_y,
        z5_7_x, t274,
    ]
    };
    // link 4: motion
    let [
        t277, a4_y, w4_x, t286, t289, t292, w4_z, dw4_z,
        t297, t298, t299, t300, t301, t302, t303, t304,
        t305, t306, t307, t308,
    ] = {
        let t277 = c4 * t58 + s4 * a3_z;
        let a4_y = s4 * t58 - c4 * a3_z;
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t286 = c4 * w3_z + s4 * w3_x;
        let t289 = s4 * t89 - c4 * t85;
        let t292 = c4 * t89 + s4 * t85;
        let w4_z = dq4 - t67;
        let dw4_z = ddq4 - t82;
        let t295 = w4_x * w4_x;
        let t296 = w4_z * w4_z;
        let t297 = w4_x * t286;
        let t298 = w4_x * w4_z;
        let t299 = t286 * w4_z;
        let t300 = t292 + t299;
        let t301 = t298 - t289;
        let t302 = t295 - t296;
        let t303 = t302 - t87;
        let t304 = dw4_z + t297;
        let t305 = t297 - dw4_z;
        let t306 = t295 + t296;
        let t307 = t298 + t301;
        let t308 = t299 + t300;
        let t309 = -t297;
        let t310 = -t292;
        put(169, a4_y); // row 4, MSX4
        put(170, t277); // row 4, MSY4
        put(171, t297); // row 4, XX4
        put(172, t309); // row 4, YY4
        put(173, dw4_z); // row 4, ZZ4
        put(175, t310); // row 4, XZ4
        put(176, t289); // row 4, YZ4
        [
        t277, a4_y, w4_x, t286, t289, t292, w4_z, dw4_z,
        t297, t298, t299, t300, t301, t302, t303, t304,
        t305, t306, t307, t308,
    ]
    };
    // M4: column
    let [t313, t316] = {
        let t313 = c4 * t277 + s4 * a4_y;
        let t316 = s4 * t277 - c4 * a4_y;
        let t317 = k_L2 * t313;
        let t319 = t50 * t317 - t106;
        let t321 = t109 + c3 * t317;
        put(18, t319); // row 1, M4
        put(78, t321); // row 2, M4
        put(130, t313); // row 3, MSZ4
        [t313, t316]
    };
    // MSX4: column
    let [t323, t325, t326] = {
        let t323 = s4 * t305;
        let t325 = s4 * a3_y;
        let t326 = c4 * a3_y;
        let t329 = k_L2 * t307 - t325;
        let t330 = a4_y + k_L2 * (c4 * t303 + t323);
        let t335 = c2 * t326 - (z1_3_x * t329 + t50 * t330);
        let t338 = s3 * t329 - c3 * t330;
        let t339 = -t325;
        put(19, t335); // row 1, MSX4
        put(79, t338); // row 2, MSX4
        put(128, t326); // row 3, MSX4
        put(129, t339); // row 3, MSY4
        [t323, t325, t326]
    };
    // MSY4: column
    let t340 = {
        let t340 = c4 * t304;
        let t345 = t326 + k_L2 * t308;
        let t346 = k_L2 * (t340 - s4 * t306) - t277;
        let t351 = z1_3_x * t345 + t50 * t346 - c2 * t325;
        let t354 = c3 * t346 - s3 * t345;
        put(20, t351); // row 1, MSY4
        put(80, t354); // row 2, MSY4
        t340
    };
    // MSZ4: column
    {
        let t358 = k_L2 * (s4 * t292 - c4 * t289);
        let t359 = t123 + t316;
        let t364 = c2 * t313 + (z1_3_x * t359 + t50 * t358);
        let t367 = c3 * t358 - s3 * t359;
        put(21, t364); // row 1, MSZ4
        put(81, t367); // row 2, MSZ4
    }
    // XX4: column
    let [t369, t370, t374, t375, t379] = {
        let t369 = t298 * z1_5_z;
        let t370 = t50 * t297;
        let t372 = t300 * t94 - t369 - t370;
        let t374 = t298 * z2_4_y;
        let t375 = c3 * t297;
        let t377 = t300 * t100 + t374 - t375;
        let t379 = c4 * t298;
        let t380 = s4 * t300 - t379;
        put(22, t372); // row 1, XX4
        put(82, t377); // row 2, XX4
        put(131, t380); // row 3, XX4
        [t369, t370, t374, t375, t379]
    };
    // YY4: column
    let [t381, t385, t389] = {
        let t381 = t299 * t94;
        let t384 = t370 + (t301 * z1_5_z - t381);
        let t385 = t299 * t100;
        let t388 = t375 - (t385 + t301 * z2_4_y);
        let t389 = s4 * t299;
        let t391 = c4 * t301 - t389;
        put(23, t384); // row 1, YY4
        put(83, t388); // row 2, YY4
        put(132, t391); // row 3, YY4
        [t381, t385, t389]
    };
    // ZZ4: column
    {
        let t394 = t369 + t381 - t50 * dw4_z;
        let t397 = t385 - t374 - c3 * dw4_z;
        let t398 = t379 + t389;
        put(24, t394); // row 1, ZZ4
        put(84, t397); // row 2, ZZ4
        put(133, t398); // row 3, ZZ4
    }
    // XY4: column
    {
        let t399 = t303 + t306;
        let t404 = t307 * t94 + t308 * z1_5_z - t50 * t399;
        let t409 = t307 * t100 - t308 * z2_4_y - c3 * t399;
        let t412 = s4 * t307 + c4 * t308;
        put(25, t404); // row 1, XY4
        put(85, t409); // row 2, XY4
        put(134, t412); // row 3, XY4
        put(174, t399); // row 4, XY4
    }
    // XZ4: column
    {
        let t417 = t50 * t292 + (t305 * t94 + t302 * z1_5_z);
        let t422 = c3 * t292 - (t302 * z2_4_y - t305 * t100);
        let t424 = t323 + c4 * t302;
        put(26, t417); // row 1, XZ4
        put(86, t422); // row 2, XZ4
        put(135, t424); // row 3, XZ4
    }
    // YZ4: column
    {
        let t425 = t306 - t87;
        let t430 = t94 * t425 - t304 * z1_5_z - t50 * t289;
        let t435 = t100 * t425 + t304 * z2_4_y - c3 * t289;
        let t437 = s4 * t425 - t340;
        put(27, t430); // row 1, YZ4
        put(87, t435); // row 2, YZ4
        put(136, t437); // row 3, YZ4
    }
    // link 5: motion
    let [
        t442, a5_x, a5_y, w5_x, w5_y, t458, t461, w5_z,
        dw5_z, t466, t467, t468, dw5_x, dw5_y, t471, t472,
        t473, t474, t475, t476, t477,
    ] = {
        let t441 = k_L3 * t304 - t277;
        let t442 = a4_y + k_L3 * t306;
        let t443 = a3_y + k_L3 * t308;
        let a5_x = c5 * t441 + s5 * t443;
        let a5_y = c5 * t443 - s5 * t441;
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t458 = c5 * t304 + s5 * t308;
        let t461 = s5 * t304 - c5 * t308;
        let w5_z = t286 + dq5;
        let dw5_z = t301 + ddq5;
        let t464 = w5_x * w5_x;
        let t465 = w5_z * w5_z;
        let t466 = w5_x * w5_y;
        let t467 = w5_x * w5_z;
        let t468 = w5_y * w5_z;
        let dw5_x = t461 + t468;
        let dw5_y = t458 - t467;
        let t471 = t464 - t465;
        let t472 = t471 - t306;
        let t473 = dw5_z - t466;
        let t474 = dw5_z + t466;
        let t475 = t464 + t465;
        let t476 = t467 - dw5_y;
        let t477 = t468 + dw5_x;
        let t478 = -a5_x;
        let t479 = -t466;
        put(209, a5_y); // row 5, MSX5
        put(210, t478); // row 5, MSY5
        put(211, t479); // row 5, XX5
        put(212, t466); // row 5, YY5
        put(213, dw5_z); // row 5, ZZ5
        put(215, t461); // row 5, XZ5
        put(216, t458); // row 5, YZ5
        [
        t442, a5_x, a5_y, w5_x, w5_y, t458, t461, w5_z,
        dw5_z, t466, t467, t468, dw5_x, dw5_y, t471, t472,
        t473, t474, t475, t476, t477,
    ]
    };
    // M5: column
    let [t481, t486, t491, t494] = {
        let t481 = a5_y * v1_5_y;
        let t484 = t442 * v1_4_y + (a5_x * t202 + t481);
        let t486 = a5_y * v2_5_y;
        let t489 = t442 * v2_4_y + (a5_x * v2_5_x + t486);
        let t491 = a5_y * v3_5_y;
        let t492 = a5_x * v3_5_x + t491;
        let t494 = a5_y * v4_6_z;
        let t495 = a5_x * v4_5_x - t494;
        put(28, t484); // row 1, M5
        put(88, t489); // row 2, M5
        put(137, t492); // row 3, M5
        put(177, t495); // row 4, M5
        [t481, t486, t491, t494]
    };
    // MSX5: column
    {
        let t503 = t476 * v1_4_y - (t472 * t202 + t474 * v1_5_y);
        let t504 = a5_y * z1_5_z - t442 * z1_6_z - t503;
        let t507 = t442 * t215 + a5_y * z2_4_y;
        let t513 = t472 * v2_5_x + t474 * v2_5_y - t476 * v2_4_y - t507;
        let t520 = t442 * z3_5_y + c4 * a5_y + (t472 * v3_5_x + t474 * v3_5_y);
        let t525 = c5 * t442 + (t472 * v4_5_x - t474 * v4_6_z);
        put(29, t504); // row 1, MSX5
        put(89, t513); // row 2, MSX5
        put(138, t520); // row 3, MSX5
        put(178, t525); // row 4, MSX5
    }
    // MSY5: column
    let [t530, t539, t548, t553] = {
        let t530 = t475 * v1_5_y;
        let t534 = t442 * t196 - a5_x * z1_5_z - (t477 * v1_4_y + (t473 * t202 + t530));
        let t539 = t475 * v2_5_y;
        let t543 = t442 * t212 + a5_x * z2_4_y - (t477 * v2_4_y + (t473 * v2_5_x + t539));
        let t548 = t475 * v3_5_y;
        let t550 = t442 * t223 - c4 * a5_x - (t473 * v3_5_x + t548);
        let t553 = t475 * v4_6_z;
        let t555 = t553 - t473 * v4_5_x - s5 * t442;
        put(30, t534); // row 1, MSY5
        put(90, t543); // row 2, MSY5
        put(139, t550); // row 3, MSY5
        put(179, t555); // row 4, MSY5
        [t530, t539, t548, t553]
    };
    // MSZ5: column
    {
        let t563 = t306 * v1_4_y - (t461 * v1_5_y - t458 * t202);
        let t564 = a5_y * t196 - a5_x * z1_6_z + t563;
        let t567 = a5_x * t215 - a5_y * t212;
        let t573 = t306 * v2_4_y + (t458 * v2_5_x - t461 * v2_5_y) - t567;
        let t580 = a5_y * t223 + a5_x * z3_5_y - (t461 * v3_5_y - t458 * v3_5_x);
        let t587 = t458 * v4_5_x + t461 * v4_6_z - (s5 * a5_y - c5 * a5_x);
        put(31, t564); // row 1, MSZ5
        put(91, t573); // row 2, MSZ5
        put(140, t580); // row 3, MSZ5
        put(180, t587); // row 4, MSZ5
    }
    // XX5: column
    let [t589, t590, t594, t595, t599, t600, t604] = {
        let t589 = t467 * z1_6_z;
        let t590 = t466 * z1_5_z;
        let t594 = t467 * t215;
        let t595 = t466 * z2_4_y;
        let t597 = t595 - (dw5_x * t212 + t594);
        let t599 = t467 * z3_5_y;
        let t600 = c4 * t466;
        let t602 = t599 - dw5_x * t223 - t600;
        let t604 = c5 * t467;
        let t605 = s5 * dw5_x + t604;
        let t606 = -(t590 + (dw5_x * t196 + t589));
        put(32, t606); // row 1, XX5
        put(92, t597); // row 2, XX5
        put(141, t602); // row 3, XX5
        put(181, t605); // row 4, XX5
        [t589, t590, t594, t595, t599, t600, t604]
    };
    // YY5: column
    let [t607, t611, t615, t619] = {
        let t607 = t468 * t196;
        let t610 = t590 + (t607 - dw5_y * z1_6_z);
        let t611 = t468 * t212;
        let t614 = t611 - dw5_y * t215 - t595;
        let t615 = t468 * t223;
        let t618 = t600 + (t615 + dw5_y * z3_5_y);
        let t619 = s5 * t468;
        let t621 = c5 * dw5_y - t619;
        put(33, t610); // row 1, YY5
        put(93, t614); // row 2, YY5
        put(142, t618); // row 3, YY5
        put(182, t621); // row 4, YY5
        [t607, t611, t615, t619]
    };
    // ZZ5: column
    {
        let t624 = dw5_z * z1_5_z - (t607 - t589);
        let t627 = t594 - t611 - dw5_z * z2_4_y;
        let t630 = c4 * dw5_z - (t599 + t615);
        let t631 = t619 - t604;
        put(34, t624); // row 1, ZZ5
        put(94, t627); // row 2, ZZ5
        put(143, t630); // row 3, ZZ5
        put(183, t631); // row 4, ZZ5
    }
    // XY5: column
    {
        let t632 = t472 + t475;
        let t637 = z1_5_z * t632 + (t476 * t196 - t477 * z1_6_z);
        let t642 = t476 * t212 - t477 * t215 - z2_4_y * t632;
        let t647 = c4 * t632 + (t476 * t223 + t477 * z3_5_y);
        let t650 = c5 * t477 - s5 * t476;
        put(35, t637); // row 1, XY5
        put(95, t642); // row 2, XY5
        put(144, t647); // row 3, XY5
        put(184, t650); // row 4, XY5
        put(214, t632); // row 5, XY5
    }
    // XZ5: column
    {
        let t655 = t461 * z1_5_z - (t474 * t196 - t471 * z1_6_z);
        let t660 = t471 * t215 - t474 * t212 - t461 * z2_4_y;
        let t665 = c4 * t461 - (t474 * t223 + t471 * z3_5_y);
        let t668 = s5 * t474 - c5 * t471;
        put(36, t655); // row 1, XZ5
        put(96, t660); // row 2, XZ5
        put(145, t665); // row 3, XZ5
        put(185, t668); // row 4, XZ5
    }
    // YZ5: column
    {
        let t669 = t475 - t306;
        let t674 = t458 * z1_5_z + (t196 * t669 - t473 * z1_6_z);
        let t679 = t212 * t669 - t473 * t215 - t458 * z2_4_y;
        let t684 = c4 * t458 + (t223 * t669 + t473 * z3_5_y);
        let t687 = c5 * t473 - s5 * t669;
        put(37, t674); // row 1, YZ5
        put(97, t679); // row 2, YZ5
        put(146, t684); // row 3, YZ5
        put(186, t687); // row 4, YZ5
    }
    // link 6: motion
    let [
        t690, t693, w6_x, w6_y, t702, t705, w6_z, dw6_z,
        t710, t711, t712, dw6_x, t714, t715, t716, t717,
        t718, t719, t720, t721,
    ] = {
        let t690 = s6 * t442 - c6 * a5_x;
        let t693 = c6 * t442 + s6 * a5_x;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t702 = c6 * t473 - s6 * t477;
        let t705 = c6 * t477 + s6 * t473;
        let w6_z = dq6 - w5_y;
        let dw6_z = ddq6 - dw5_y;
        let t708 = w6_x * w6_x;
        let t709 = w6_z * w6_z;
        let t710 = w6_x * w6_y;
        let t711 = w6_x * w6_z;
        let t712 = w6_y * w6_z;
        let dw6_x = t705 + t712;
        let t714 = t702 - t711;
        let t715 = t709 - t708;
        let t716 = t475 + t715;
        let t717 = t710 - dw6_z;
        let t718 = dw6_z + t710;
        let t719 = t708 + t709;
        let t720 = t714 - t711;
        let t721 = t712 + dw6_x;
        let t722 = -t693;
        let t723 = -t710;
        put(237, t722); // row 6, MSX6
        put(238, t690); // row 6, MSY6
        put(239, t723); // row 6, XX6
        put(240, t710); // row 6, YY6
        put(241, dw6_z); // row 6, ZZ6
        put(243, t705); // row 6, XZ6
        put(244, t702); // row 6, YZ6
        [
        t690, t693, w6_x, w6_y, t702, t705, w6_z, dw6_z,
        t710, t711, t712, dw6_x, t714, t715, t716, t717,
        t718, t719, t720, t721,
    ]
    };
    // M6: column
    let [t725, t728] = {
        let t725 = s6 * t693;
        let t726 = t725 - c6 * t690;
        let t728 = c6 * t693;
        let t729 = s6 * t690 + t728;
        let t733 = v1_4_y * t729 + (t481 + t202 * t726);
        let t737 = v2_4_y * t729 + (t486 + v2_5_x * t726);
        let t739 = t491 + v3_5_x * t726;
        let t741 = v4_5_x * t726 - t494;
        put(38, t733); // row 1, M6
        put(98, t737); // row 2, M6
        put(147, t739); // row 3, M6
        put(187, t741); // row 4, M6
        put(219, t726); // row 5, MSZ6
        [t725, t728]
    };
    // MSX6: column
    let t743 = {
        let t743 = s6 * t718;
        let t744 = c6 * t716 + t743;
        let t747 = c6 * t718 - s6 * t716;
        let t752 = v1_4_y * t747 + (t202 * t744 - t720 * v1_5_y);
        let t756 = a5_y * z1_6_y - t693 * z1_6_z - t752;
        let t764 = t693 * t215 - a5_y * z2_6_y;
        let t765 = t720 * v2_5_y - v2_5_x * t744 - v2_4_y * t747 - t764;
        let t772 = t720 * v3_5_y - v3_5_x * t744 + (a5_y * z3_6_y + t693 * z3_5_y);
        let t779 = c5 * t693 - a5_y * t248 - (v4_5_x * t744 + t720 * v4_6_z);
        let t780 = c6 * a5_y;
        put(39, t756); // row 1, MSX6
        put(99, t765); // row 2, MSX6
        put(148, t772); // row 3, MSX6
        put(188, t779); // row 4, MSX6
        put(217, t780); // row 5, MSX6
        t743
    };
    // MSY6: column
    let [t781, t782, t785] = {
        let t781 = c6 * t717;
        let t782 = s6 * t719;
        let t783 = t781 + t782;
        let t785 = c6 * t719;
        let t786 = s6 * t717 - t785;
        let t791 = v1_4_y * t786 + (t721 * v1_5_y - t202 * t783);
        let t795 = t690 * z1_6_z - a5_y * z1_6_x - t791;
        let t803 = a5_y * t237 + t690 * t215;
        let t804 = v2_5_x * t783 - t721 * v2_5_y - v2_4_y * t786 + t803;
        let t811 = v3_5_x * t783 - t721 * v3_5_y - (a5_y * z3_6_x + t690 * z3_5_y);
        let t818 = v4_5_x * t783 + t721 * v4_6_z - (a5_y * z4_6_x + c5 * t690);
        let t820 = -(s6 * a5_y);
        put(40, t795); // row 1, MSY6
        put(100, t804); // row 2, MSY6
        put(149, t811); // row 3, MSY6
        put(189, t818); // row 4, MSY6
        put(218, t820); // row 5, MSY6
        [t781, t782, t785]
    };
    // MSZ6: column
    {
        let t823 = c6 * t702 + s6 * t705;
        let t826 = c6 * t705 - s6 * t702;
        let t834 = v1_4_y * t826 + (t530 + t202 * t823) - (t690 * z1_6_y - t693 * z1_6_x);
        let t842 = v2_4_y * t826 + (t539 + v2_5_x * t823) - (t693 * t237 + t690 * z2_6_y);
        let t848 = t548 + v3_5_x * t823 + (t693 * z3_6_x - t690 * z3_6_y);
        let t854 = v4_5_x * t823 - t553 + (t693 * z4_6_x + t690 * t248);
        put(41, t834); // row 1, MSZ6
        put(101, t842); // row 2, MSZ6
        put(150, t848); // row 3, MSZ6
        put(190, t854); // row 4, MSZ6
    }
    // XX6: column
    let [
        t856, t857, t861, t862, t866, t867, t871, t872,
        t876,
    ] = {
        let t856 = t711 * z1_6_y;
        let t857 = t710 * z1_6_z;
        let t859 = dw6_x * z1_6_x + t856 - t857;
        let t861 = t711 * z2_6_y;
        let t862 = t710 * t215;
        let t864 = t861 - dw6_x * t237 - t862;
        let t866 = t711 * z3_6_y;
        let t867 = t710 * z3_5_y;
        let t869 = t867 + (dw6_x * z3_6_x + t866);
        let t871 = t711 * t248;
        let t872 = c5 * t710;
        let t874 = t872 + (dw6_x * z4_6_x - t871);
        let t876 = c6 * t711;
        let t877 = s6 * dw6_x + t876;
        put(42, t859); // row 1, XX6
        put(102, t864); // row 2, XX6
        put(151, t869); // row 3, XX6
        put(191, t874); // row 4, XX6
        put(220, t877); // row 5, XX6
        [
        t856, t857, t861, t862, t866, t867, t871, t872,
        t876,
    ]
    };
    // YY6: column
    let [t878, t882, t886, t890, t894] = {
        let t878 = t712 * z1_6_x;
        let t881 = t857 + (t714 * z1_6_y - t878);
        let t882 = t712 * t237;
        let t885 = t862 + (t882 + t714 * z2_6_y);
        let t886 = t712 * z3_6_x;
        let t889 = t714 * z3_6_y - t886 - t867;
        let t890 = t712 * z4_6_x;
        let t894 = s6 * t712;
        let t896 = c6 * t714 - t894;
        let t897 = -(t872 + (t890 + t714 * t248));
        put(43, t881); // row 1, YY6
        put(103, t885); // row 2, YY6
        put(152, t889); // row 3, YY6
        put(192, t897); // row 4, YY6
        put(221, t896); // row 5, YY6
        [t878, t882, t886, t890, t894]
    };
    // ZZ6: column
    {
        let t900 = dw6_z * z1_6_z - (t856 - t878);
        let t903 = dw6_z * t215 - (t861 + t882);
        let t906 = t886 - t866 - dw6_z * z3_5_y;
        let t909 = t871 + t890 - c5 * dw6_z;
        let t910 = t894 - t876;
        put(44, t900); // row 1, ZZ6
        put(104, t903); // row 2, ZZ6
        put(153, t906); // row 3, ZZ6
        put(193, t909); // row 4, ZZ6
        put(222, t910); // row 5, ZZ6
    }
    // XY6: column
    {
        let t911 = t719 - t716;
        let t916 = z1_6_z * t911 + (t720 * z1_6_x + t721 * z1_6_y);
        let t921 = t215 * t911 + (t721 * z2_6_y - t720 * t237);
        let t926 = t720 * z3_6_x + t721 * z3_6_y - z3_5_y * t911;
        let t931 = t720 * z4_6_x - t721 * t248 - c5 * t911;
        let t934 = s6 * t720 + c6 * t721;
        put(45, t916); // row 1, XY6
        put(105, t921); // row 2, XY6
        put(154, t926); // row 3, XY6
        put(194, t931); // row 4, XY6
        put(223, t934); // row 5, XY6
        put(242, t911); // row 6, XY6
    }
    // XZ6: column
    {
        let t939 = t705 * z1_6_z + (t718 * z1_6_x + t715 * z1_6_y);
        let t944 = t705 * t215 + (t715 * z2_6_y - t718 * t237);
        let t949 = t718 * z3_6_x + t715 * z3_6_y - t705 * z3_5_y;
        let t954 = t718 * z4_6_x - t715 * t248 - c5 * t705;
        let t956 = t743 + c6 * t715;
        put(46, t939); // row 1, XZ6
        put(106, t944); // row 2, XZ6
        put(155, t949); // row 3, XZ6
        put(195, t954); // row 4, XZ6
        put(224, t956); // row 5, XZ6
    }
    // YZ6: column
    {
        let t957 = t475 - t719;
        let t962 = t702 * z1_6_z - (t717 * z1_6_y - z1_6_x * t957);
        let t967 = t702 * t215 - (t237 * t957 + t717 * z2_6_y);
        let t972 = z3_6_x * t957 - t717 * z3_6_y - t702 * z3_5_y;
        let t977 = z4_6_x * t957 + t717 * t248 - c5 * t702;
        let t979 = s6 * t957 - t781;
        put(47, t962); // row 1, YZ6
        put(107, t967); // row 2, YZ6
        put(156, t972); // row 3, YZ6
        put(196, t977); // row 4, YZ6
        put(225, t979); // row 5, YZ6
    }
    // link 7: motion
    let [
        t982, a7_y, t994, t997, dw7_z, t1002, t1003, t1004,
        t1005, dw7_y, t1007, t1008, t1009, t1010, t1011, t1012,
        t1013,
    ] = {
        let t982 = c7 * t690 - s7 * a5_y;
        let a7_y = c7 * a5_y + s7 * t690;
        let t988 = s7 * w6_z - c7 * w6_x;
        let t991 = c7 * w6_z + s7 * w6_x;
        let t994 = c7 * t717 - s7 * t721;
        let t997 = c7 * t721 + s7 * t717;
        let w7_z = w6_y + dq7;
        let dw7_z = t714 + ddq7;
        let t1000 = t988 * t988;
        let t1001 = w7_z * w7_z;
        let t1002 = t988 * t991;
        let t1003 = t988 * w7_z;
        let t1004 = t991 * w7_z;
        let t1005 = t1004 - t997;
        let dw7_y = t994 + t1003;
        let t1007 = t1000 - t1001;
        let t1008 = t1007 - t719;
        let t1009 = dw7_z - t1002;
        let t1010 = dw7_z + t1002;
        let t1011 = t1000 + t1001;
        let t1012 = t1003 + dw7_y;
        let t1013 = t1004 + t1005;
        let t1014 = -t1002;
        put(256, a7_y); // row 7, MSX7
        put(257, t982); // row 7, MSY7
        put(258, t1014); // row 7, XX7
        put(259, t1002); // row 7, YY7
        put(260, dw7_z); // row 7, ZZ7
        put(262, t997); // row 7, XZ7
        put(263, t994); // row 7, YZ7
        [
        t982, a7_y, t994, t997, dw7_z, t1002, t1003, t1004,
        t1005, dw7_y, t1007, t1008, t1009, t1010, t1011, t1012,
        t1013,
    ]
    };
    // M7: column
    {
        let t1017 = c7 * t982 + s7 * a7_y;
        let t1020 = s7 * t982 - c7 * a7_y;
        let t1022 = t725 - c6 * t1017;
        let t1024 = t728 + s6 * t1017;
        let t1029 = v1_4_y * t1024 + (t202 * t1022 - v1_5_y * t1020);
        let t1034 = v2_4_y * t1024 + (v2_5_x * t1022 - v2_5_y * t1020);
        let t1037 = v3_5_x * t1022 - v3_5_y * t1020;
        let t1040 = v4_5_x * t1022 + v4_6_z * t1020;
        put(48, t1029); // row 1, M7
        put(108, t1034); // row 2, M7
        put(157, t1037); // row 3, M7
        put(197, t1040); // row 4, M7
        put(247, t1017); // row 6, MSZ7
    }
    // MSX7: column
    let t1042 = {
        let t1042 = s7 * t1010;
        let t1043 = c7 * t1008 - t1042;
        let t1046 = s7 * t1008 + c7 * t1010;
        let t1049 = c6 * t1043 + s6 * t1012;
        let t1052 = c6 * t1012 - s6 * t1043;
        let t1060 = a7_y * z1_6_y - t693 * t254;
        let t1061 = v1_4_y * t1052 + (t202 * t1049 + v1_5_y * t1046) + t1060;
        let t1069 = t693 * t260 - a7_y * z2_6_y;
        let t1070 = v2_4_y * t1052 + (v2_5_x * t1049 + v2_5_y * t1046) - t1069;
        let t1077 = v3_5_x * t1049 + v3_5_y * t1046 + (a7_y * z3_6_y - t693 * t266);
        let t1084 = t693 * z4_7_y - a7_y * t248 - (v4_6_z * t1046 - v4_5_x * t1049);
        let t1087 = c6 * a7_y - t693 * t274;
        let t1089 = -(c7 * t693);
        put(49, t1061); // row 1, MSX7
        put(109, t1070); // row 2, MSX7
        put(158, t1077); // row 3, MSX7
        put(198, t1084); // row 4, MSX7
        put(226, t1087); // row 5, MSX7
        put(245, t1089); // row 6, MSX7
        t1042
    };
    // MSY7: column
    let t1090 = {
        let t1090 = c7 * t1009;
        let t1092 = t1090 - s7 * t1011;
        let t1095 = s7 * t1009 + c7 * t1011;
        let t1098 = s6 * t1013 - c6 * t1092;
        let t1101 = s6 * t1092 + c6 * t1013;
        let t1109 = t693 * t251 + t982 * z1_6_y;
        let t1110 = v1_4_y * t1101 + (t202 * t1098 - v1_5_y * t1095) + t1109;
        let t1115 = v2_5_y * t1095 - v2_5_x * t1098 - v2_4_y * t1101;
        let t1119 = t693 * t257 + t982 * z2_6_y - t1115;
        let t1126 = v3_5_x * t1098 - v3_5_y * t1095 + (t982 * z3_6_y - t693 * z3_7_x);
        let t1133 = v4_5_x * t1098 + v4_6_z * t1095 - (t693 * z4_7_x + t982 * t248);
        let t1136 = c6 * t982 - t693 * z5_7_x;
        let t1137 = s7 * t693;
        put(50, t1110); // row 1, MSY7
        put(110, t1119); // row 2, MSY7
        put(159, t1126); // row 3, MSY7
        put(199, t1133); // row 4, MSY7
        put(227, t1136); // row 5, MSY7
        put(246, t1137); // row 6, MSY7
        t1090
    };
    // MSZ7: column
    {
        let t1140 = c7 * t994 + s7 * t997;
        let t1143 = c7 * t997 - s7 * t994;
        let t1145 = t782 + c6 * t1140;
        let t1147 = s6 * t1140 - t785;
        let t1152 = v1_4_y * t1147 + (v1_5_y * t1143 - t202 * t1145);
        let t1156 = a7_y * t251 + t982 * t254 - t1152;
        let t1161 = v2_4_y * t1147 + (v2_5_y * t1143 - v2_5_x * t1145);
        let t1165 = a7_y * t257 + t982 * t260 - t1161;
        let t1172 = v3_5_x * t1145 - v3_5_y * t1143 - (a7_y * z3_7_x - t982 * t266);
        let t1179 = v4_5_x * t1145 + v4_6_z * t1143 - (a7_y * z4_7_x + t982 * z4_7_y);
        let t1182 = t982 * t274 - a7_y * z5_7_x;
        put(51, t1156); // row 1, MSZ7
        put(111, t1165); // row 2, MSZ7
        put(160, t1172); // row 3, MSZ7
        put(200, t1179); // row 4, MSZ7
        put(228, t1182); // row 5, MSZ7
    }
    // XX7: column
    let [
        t1184, t1185, t1189, t1190, t1194, t1195, t1199, t1200,
        t1204, t1205, t1209,
    ] = {
        let t1184 = t1003 * t254;
        let t1185 = t1002 * z1_6_y;
        let t1187 = t1005 * t251 + t1184 - t1185;
        let t1189 = t1003 * t260;
        let t1190 = t1002 * z2_6_y;
        let t1192 = t1005 * t257 + t1189 - t1190;
        let t1194 = t1003 * t266;
        let t1195 = t1002 * z3_6_y;
        let t1197 = t1194 - t1005 * z3_7_x - t1195;
        let t1199 = t1003 * z4_7_y;
        let t1200 = t1002 * t248;
        let t1202 = t1200 - (t1005 * z4_7_x + t1199);
        let t1204 = t1003 * t274;
        let t1205 = c6 * t1002;
        let t1207 = t1204 - t1005 * z5_7_x - t1205;
        let t1209 = c7 * t1003;
        let t1210 = s7 * t1005 + t1209;
        put(52, t1187); // row 1, XX7
        put(112, t1192); // row 2, XX7
        put(161, t1197); // row 3, XX7
        put(201, t1202); // row 4, XX7
        put(229, t1207); // row 5, XX7
        put(248, t1210); // row 6, XX7
        [
        t1184, t1185, t1189, t1190, t1194, t1195, t1199, t1200,
        t1204, t1205, t1209,
    ]
    };
    // YY7: column
    let [t1211, t1215, t1219, t1223, t1227, t1231] = {
        let t1211 = t1004 * t251;
        let t1214 = t1185 - (t1211 + dw7_y * t254);
        let t1215 = t1004 * t257;
        let t1218 = t1190 - (t1215 + dw7_y * t260);
        let t1219 = t1004 * z3_7_x;
        let t1222 = t1195 + (t1219 - dw7_y * t266);
        let t1223 = t1004 * z4_7_x;
        let t1226 = t1223 + dw7_y * z4_7_y - t1200;
        let t1227 = t1004 * z5_7_x;
        let t1230 = t1205 - (dw7_y * t274 - t1227);
        let t1231 = s7 * t1004;
        let t1234 = -(t1231 + c7 * dw7_y);
        put(53, t1214); // row 1, YY7
        put(113, t1218); // row 2, YY7
        put(162, t1222); // row 3, YY7
        put(202, t1226); // row 4, YY7
        put(230, t1230); // row 5, YY7
        put(249, t1234); // row 6, YY7
        [t1211, t1215, t1219, t1223, t1227, t1231]
    };
    // ZZ7: column
    {
        let t1237 = dw7_z * z1_6_y - (t1184 - t1211);
        let t1240 = dw7_z * z2_6_y + (t1215 - t1189);
        let t1243 = dw7_z * z3_6_y - (t1194 + t1219);
        let t1246 = t1199 - t1223 - dw7_z * t248;
        let t1249 = c6 * dw7_z - (t1204 + t1227);
        let t1250 = t1231 - t1209;
        put(54, t1237); // row 1, ZZ7
        put(114, t1240); // row 2, ZZ7
        put(163, t1243); // row 3, ZZ7
        put(203, t1246); // row 4, ZZ7
        put(231, t1249); // row 5, ZZ7
        put(250, t1250); // row 6, ZZ7
    }
    // XY7: column
    {
        let t1251 = t1008 + t1011;
        let t1256 = z1_6_y * t1251 - (t1012 * t251 - t1013 * t254);
        let t1261 = z2_6_y * t1251 + (t1013 * t260 - t1012 * t257);
        let t1266 = z3_6_y * t1251 + (t1012 * z3_7_x + t1013 * t266);
        let t1271 = t1012 * z4_7_x - t1013 * z4_7_y - t248 * t1251;
        let t1276 = c6 * t1251 + (t1012 * z5_7_x + t1013 * t274);
        let t1279 = c7 * t1013 - s7 * t1012;
        put(55, t1256); // row 1, XY7
        put(115, t1261); // row 2, XY7
        put(164, t1266); // row 3, XY7
        put(204, t1271); // row 4, XY7
        put(232, t1276); // row 5, XY7
        put(251, t1279); // row 6, XY7
        put(261, t1251); // row 7, XY7
    }
    // XZ7: column
    {
        let t1284 = t997 * z1_6_y + (t1007 * t254 - t1010 * t251);
        let t1289 = t997 * z2_6_y + (t1007 * t260 - t1010 * t257);
        let t1294 = t997 * z3_6_y + (t1010 * z3_7_x + t1007 * t266);
        let t1299 = t1010 * z4_7_x - t1007 * z4_7_y - t997 * t248;
        let t1304 = c6 * t997 + (t1010 * z5_7_x + t1007 * t274);
        let t1306 = c7 * t1007 - t1042;
        put(56, t1284); // row 1, XZ7
        put(116, t1289); // row 2, XZ7
        put(165, t1294); // row 3, XZ7
        put(205, t1299); // row 4, XZ7
        put(233, t1304); // row 5, XZ7
        put(252, t1306); // row 6, XZ7
    }
    // YZ7: column
    {
        let t1307 = t1011 - t719;
        let t1312 = t994 * z1_6_y - (t1009 * t254 - t251 * t1307);
        let t1317 = t994 * z2_6_y + (t257 * t1307 - t1009 * t260);
        let t1322 = t994 * z3_6_y - (z3_7_x * t1307 + t1009 * t266);
        let t1327 = t1009 * z4_7_y - z4_7_x * t1307 - t994 * t248;
        let t1332 = c6 * t994 - (z5_7_x * t1307 + t1009 * t274);
        let t1334 = s7 * t1307 - t1090;
        let t1335 = dq1.sign();
        let t1336 = dq2.sign();
        let t1337 = dq3.sign();
        let t1338 = dq4.sign();
        let t1339 = dq5.sign();
        let t1340 = dq6.sign();
        let t1341 = dq7.sign();
        put(57, t1312); // row 1, YZ7
        put(59, t1335); // row 1, FC1
        put(117, t1317); // row 2, YZ7
        put(119, t1336); // row 2, FC2
        put(166, t1322); // row 3, YZ7
        put(168, t1337); // row 3, FC3
        put(206, t1327); // row 4, YZ7
        put(208, t1338); // row 4, FC4
        put(234, t1332); // row 5, YZ7
        put(236, t1339); // row 5, FC5
        put(253, t1334); // row 6, YZ7
        put(255, t1340); // row 6, FC6
        put(265, t1341); // row 7, FC7
    }
}
