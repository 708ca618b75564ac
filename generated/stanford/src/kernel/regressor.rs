//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil
//! and Dombre, 12.4.
//!
//! 420 multiplications, 330 additions; 6 x 66, 174 of 396 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 174;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 5), (0, 10), (0, 11), (0, 12), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18),
    (0, 19), (0, 20), (0, 21), (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28),
    (0, 29), (0, 30), (0, 31), (0, 32), (0, 33), (0, 34), (0, 35), (0, 36), (0, 37), (0, 38),
    (0, 39), (0, 40), (0, 41), (0, 42), (0, 43), (0, 44), (0, 45), (0, 46), (0, 47), (0, 48),
    (0, 49), (0, 50), (0, 51), (0, 52), (0, 53), (0, 54), (0, 55), (0, 56), (0, 57), (0, 58),
    (0, 59), (0, 60), (1, 11), (1, 13), (1, 14), (1, 15), (1, 16), (1, 17), (1, 18), (1, 19),
    (1, 20), (1, 21), (1, 22), (1, 23), (1, 24), (1, 25), (1, 26), (1, 27), (1, 28), (1, 29),
    (1, 30), (1, 31), (1, 32), (1, 33), (1, 34), (1, 35), (1, 36), (1, 37), (1, 38), (1, 39),
    (1, 40), (1, 41), (1, 42), (1, 43), (1, 44), (1, 45), (1, 46), (1, 47), (1, 48), (1, 49),
    (1, 50), (1, 51), (1, 52), (1, 53), (1, 54), (1, 55), (1, 56), (1, 57), (1, 58), (1, 59),
    (1, 61), (2, 20), (2, 21), (2, 22), (2, 23), (2, 30), (2, 31), (2, 32), (2, 33), (2, 40),
    (2, 41), (2, 42), (2, 43), (2, 50), (2, 51), (2, 52), (2, 53), (2, 62), (3, 31), (3, 33),
    (3, 34), (3, 35), (3, 36), (3, 37), (3, 38), (3, 39), (3, 41), (3, 42), (3, 43), (3, 44),
    (3, 45), (3, 46), (3, 47), (3, 48), (3, 49), (3, 50), (3, 51), (3, 52), (3, 53), (3, 54),
    (3, 55), (3, 56), (3, 57), (3, 58), (3, 59), (3, 63), (4, 41), (4, 43), (4, 44), (4, 45),
    (4, 46), (4, 47), (4, 48), (4, 49), (4, 50), (4, 51), (4, 52), (4, 53), (4, 54), (4, 55),
    (4, 56), (4, 57), (4, 58), (4, 59), (4, 64), (5, 51), (5, 52), (5, 54), (5, 55), (5, 56),
    (5, 57), (5, 58), (5, 59), (5, 65),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 66 + PATTERN[k].1
}

/// Regressor `W` of the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 66]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    clear(&mut flat[0..5]);
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[6..10]),
            51 => clear(&mut flat[61..77]),
            52 => flat[78] = S::default(),
            99 => flat[126] = S::default(),
            100 => clear(&mut flat[128..152]),
            104 => clear(&mut flat[156..162]),
            108 => clear(&mut flat[166..172]),
            112 => clear(&mut flat[176..182]),
            116 => clear(&mut flat[186..194]),
            117 => clear(&mut flat[195..229]),
            118 => flat[230] = S::default(),
            125 => flat[238] = S::default(),
            144 => clear(&mut flat[258..261]),
            145 => clear(&mut flat[262..305]),
            146 => flat[306] = S::default(),
            163 => clear(&mut flat[324..328]),
            164 => clear(&mut flat[329..381]),
            166 => flat[383] = S::default(),
            172 => clear(&mut flat[390..395]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 66]; 6]) {
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
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let k1 = S::constant(-GRAVITY[2]);
    let k2 = S::constant(2.0);
    let k_D2 = S::constant(constants::D2);
    let k_D6 = S::constant(constants::D6);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        put(0, ddq1); // row 1, YY1
        put(51, ddq1); // row 1, IA1
        put(55, ddq2); // row 2, YY2
        put(64, ddq2); // row 2, XX3
        put(100, ddq2); // row 2, IA2
        put(117, ddq3); // row 3, IA3
        put(145, ddq4); // row 4, IA4
        put(164, ddq5); // row 5, IA5
        put(173, ddq6); // row 6, IA6
        t0
    };
    // joint axes in frame 2
    let [t1, v1_2_y] = {
        let t1 = c2 * k_D2;
        let v1_2_y = s2 * k_D2;
        [t1, v1_2_y]
    };
    // joint axes in frame 3
    let t3 = {
        let t3 = s2 * q3;
        t3
    };
    // joint axes in frame 4
    let [t6, t9, v2_4_x, v2_4_y] = {
        let t6 = c4 * t3 + s4 * t1;
        let t9 = c4 * t1 - s4 * t3;
        let v2_4_x = q3 * s4;
        let v2_4_y = q3 * c4;
        [t6, t9, v2_4_x, v2_4_y]
    };
    // link 2: motion
    let [
        t15, t17, a2_y, t20, w3_z, t22, t23, t24,
        t25, t27, t28, t29, t30, t31, t32, t33,
        t34, t35,
    ] = {
        let t14 = k_D2 * ddq1;
        let t15 = k_D2 * t0;
        let t17 = s2 * k1 + c2 * t14;
        let a2_y = s2 * t14 - c2 * k1;
        let t20 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t22 = s2 * ddq1;
        let t23 = c2 * ddq1;
        let t24 = t20 * t20;
        let t25 = dq2 * dq2;
        let t26 = t20 * w3_z;
        let t27 = dq2 * t20;
        let t28 = dq2 * w3_z;
        let t29 = t22 + t28;
        let t30 = t23 - t27;
        let t31 = ddq2 - t26;
        let t32 = ddq2 + t26;
        let t33 = t24 + t25;
        let t34 = t27 - t30;
        let t35 = t28 + t29;
        let t36 = -t17;
        let t37 = -t26;
        let t38 = -t22;
        let t39 = -t23;
        let t40 = -t32;
        let t41 = -t33;
        put(52, a2_y); // row 2, MSX2
        put(53, t36); // row 2, MSZ2
        put(54, t37); // row 2, XX2
        put(56, t26); // row 2, ZZ2
        put(57, t38); // row 2, XY2
        put(59, t23); // row 2, YZ2
        put(65, t37); // row 2, YY3
        put(66, t26); // row 2, ZZ3
        put(67, t22); // row 2, XY3
        put(68, t39); // row 2, XZ3
        put(102, t22); // row 3, MSX3
        put(103, t40); // row 3, MSY3
        put(104, t41); // row 3, MSZ3
        [
        t15, t17, a2_y, t20, w3_z, t22, t23, t24,
        t25, t27, t28, t29, t30, t31, t32, t33,
        t34, t35,
    ]
    };
    // link 3: motion
    let [t42, t44, t51, a3_y, t53, t55, t56] = {
        let t42 = q3 * t31;
        let t44 = q3 * t35;
        let t48 = dq3 * k2;
        let t51 = t20 * t48 - (t15 - t44);
        let a3_y = t42 - t17 + dq2 * t48;
        let t53 = a2_y + q3 * t33 - ddq3;
        let t54 = w3_z * w3_z;
        let t55 = t24 + t54;
        let t56 = t25 + t54;
        let t57 = -t53;
        put(101, t57); // row 3, M3
        put(105, t57); // row 3, M4
        [t42, t44, t51, a3_y, t53, t55, t56]
    };
    // M2: column
    {
        let t60 = t17 * t1 + a2_y * v1_2_y;
        put(1, t60); // row 1, M2
    }
    // MSX2: column
    let t64 = {
        let t64 = t56 * t1 + t32 * v1_2_y;
        let t65 = t64 - c2 * t15;
        put(2, t65); // row 1, MSX2
        t64
    };
    // MSY2: column
    let t71 = {
        let t71 = t23 * t1 + t22 * v1_2_y;
        let t72 = s2 * a2_y + c2 * t17 + t71;
        put(3, t72); // row 1, MSY2
        t71
    };
    // MSZ2: column
    let t76 = {
        let t76 = t33 * v1_2_y - t31 * t1;
        let t77 = t76 - s2 * t15;
        put(4, t77); // row 1, MSZ2
        t76
    };
    // XX2: column
    let t79 = {
        let t79 = c2 * t27;
        let t80 = s2 * t29 + t79;
        put(5, t80); // row 1, XX2
        put(16, t80); // row 1, YY3
        t79
    };
    // YY2: column
    let t81 = {
        let t81 = s2 * t28;
        let t82 = t81 - t79;
        put(6, t82); // row 1, YY2
        put(15, t82); // row 1, XX3
        t81
    };
    // ZZ2: column
    {
        let t84 = c2 * t30 - t81;
        put(7, t84); // row 1, ZZ2
        put(17, t84); // row 1, ZZ3
    }
    // XY2: column
    {
        let t88 = s2 * t32 + c2 * (t56 - t55);
        let t89 = -t88;
        put(8, t89); // row 1, XY2
        put(18, t88); // row 1, XY3
    }
    // XZ2: column
    {
        let t90 = t56 - t33;
        let t93 = s2 * t34 - c2 * t35;
        put(9, t93); // row 1, XZ2
        put(20, t93); // row 1, YZ3
        put(58, t90); // row 2, XZ2
        put(69, t90); // row 2, YZ3
    }
    // YZ2: column
    {
        let t97 = c2 * t31 - s2 * (t33 - t55);
        let t98 = -t97;
        put(10, t97); // row 1, YZ2
        put(19, t98); // row 1, XZ3
    }
    // M3: column
    let t103 = {
        let t100 = q3 * a3_y;
        let t103 = t53 * v1_2_y;
        let t105 = s2 * (q3 * t51) + (t103 - a3_y * t1);
        put(11, t105); // row 1, M3
        put(60, t100); // row 2, M3
        t103
    };
    // MSX3: column
    {
        let t107 = q3 * t23;
        let t112 = s2 * (q3 * t55 - t53) + c2 * a3_y - t71;
        put(12, t112); // row 1, MSX3
        put(61, t107); // row 2, MSX3
    }
    // MSY3: column
    {
        let t115 = t53 - q3 * t56;
        let t119 = t64 - (s2 * (q3 * t34) - c2 * t51);
        put(13, t119); // row 1, MSY3
        put(62, t115); // row 2, MSY3
    }
    // MSZ3: column
    {
        let t121 = t42 + a3_y;
        let t123 = t76 + s2 * (t44 + t51);
        put(14, t123); // row 1, MSZ3
        put(63, t121); // row 2, MSZ3
    }
    // link 4: motion
    let [
        t124, t125, t128, a4_y, t134, w4_y, t140, t143,
        w4_z, dw4_z, t146, t147, t148, t149, t150, t151,
        t152, t153, t154, t155, t156, t157,
    ] = {
        let t124 = s2 * s4;
        let t125 = s2 * c4;
        let t128 = c4 * t51 - s4 * a3_y;
        let a4_y = c4 * a3_y + s4 * t51;
        let t134 = c4 * dq2 + s4 * t20;
        let w4_y = s4 * dq2 - c4 * t20;
        let t140 = c4 * t35 - s4 * t31;
        let t143 = c4 * t31 + s4 * t35;
        let w4_z = w3_z + dq4;
        let dw4_z = t30 + ddq4;
        let t146 = t134 * t134;
        let t147 = w4_z * w4_z;
        let t148 = t134 * w4_y;
        let t149 = t134 * w4_z;
        let t150 = w4_y * w4_z;
        let t151 = t143 - t150;
        let t152 = t140 - t149;
        let t153 = dw4_z + t148;
        let t154 = dw4_z - t148;
        let t155 = t146 + t147;
        let t156 = t152 - t149;
        let t157 = t150 - t151;
        let t158 = -t148;
        put(106, t156); // row 3, MSX4
        put(108, t157); // row 3, MSZ4
        put(118, a4_y); // row 4, MSX4
        put(119, t128); // row 4, MSZ4
        put(120, t148); // row 4, XX4
        put(121, dw4_z); // row 4, YY4
        put(122, t158); // row 4, ZZ4
        put(123, t143); // row 4, XY4
        put(125, t140); // row 4, YZ4
        [
        t124, t125, t128, a4_y, t134, w4_y, t140, t143,
        w4_z, dw4_z, t146, t147, t148, t149, t150, t151,
        t152, t153, t154, t155, t156, t157,
    ]
    };
    // joint axes in frame 5
    let [t161, t164, t167, v1_5_y, t171, z2_5_y, v2_5_x, v2_6_z] = {
        let t161 = c5 * t124 + c2 * s5;
        let t164 = c2 * c5 - s5 * t124;
        let t167 = c5 * t6 - s5 * v1_2_y;
        let v1_5_y = c5 * v1_2_y + s5 * t6;
        let t171 = c4 * c5;
        let z2_5_y = c4 * s5;
        let v2_5_x = c5 * v2_4_x;
        let v2_6_z = s5 * v2_4_x;
        [t161, t164, t167, v1_5_y, t171, z2_5_y, v2_5_x, v2_6_z]
    };
    // M4: column
    let [t176, t177, t179, t183] = {
        let t175 = w4_y * w4_y;
        let t176 = t147 + t175;
        let t177 = t146 + t175;
        let t179 = a4_y * t9;
        let t181 = t103 + (t128 * t6 - t179);
        let t183 = a4_y * v2_4_y;
        let t184 = t183 - t128 * v2_4_x;
        put(21, t181); // row 1, M4
        put(70, t184); // row 2, M4
        put(107, t177); // row 3, MSY4
        [t176, t177, t179, t183]
    };
    // MSX4: column
    {
        let t192 = t156 * v1_2_y + (t154 * t9 - t6 * t176);
        let t193 = c2 * a4_y - t53 * t125 - t192;
        let t198 = s4 * t53 + (t154 * v2_4_y - v2_4_x * t176);
        put(22, t193); // row 1, MSX4
        put(71, t198); // row 2, MSX4
    }
    // MSY4: column
    {
        let t201 = t124 * a4_y + t125 * t128;
        let t207 = t143 * t9 - t140 * t6 - v1_2_y * t177 - t201;
        let t214 = s4 * t128 - c4 * a4_y - (t143 * v2_4_y - t140 * v2_4_x);
        put(23, t207); // row 1, MSY4
        put(72, t214); // row 2, MSY4
    }
    // MSZ4: column
    {
        let t222 = t157 * v1_2_y - (t153 * t6 + t155 * t9);
        let t223 = t53 * t124 + c2 * t128 - t222;
        let t228 = c4 * t53 - (t153 * v2_4_x + t155 * v2_4_y);
        put(24, t223); // row 1, MSZ4
        put(73, t228); // row 2, MSZ4
    }
    // XX4: column
    let [t230, t231, t235] = {
        let t230 = t125 * t149;
        let t231 = c2 * t148;
        let t233 = t231 + (t124 * t151 + t230);
        let t235 = s4 * t149;
        let t236 = c4 * t151 - t235;
        put(25, t233); // row 1, XX4
        put(74, t236); // row 2, XX4
        [t230, t231, t235]
    };
    // YY4: column
    let [t237, t241] = {
        let t237 = t124 * t150;
        let t240 = c2 * dw4_z - (t230 + t237);
        let t241 = c4 * t150;
        let t242 = t235 - t241;
        put(26, t240); // row 1, YY4
        put(75, t242); // row 2, YY4
        [t237, t241]
    };
    // ZZ4: column
    {
        let t245 = t237 + t125 * t152 - t231;
        let t247 = t241 - s4 * t152;
        put(27, t245); // row 1, ZZ4
        put(76, t247); // row 2, ZZ4
    }
    // XY4: column
    {
        let t248 = t177 - t176;
        let t253 = c2 * t143 + (t124 * t154 - t125 * t248);
        let t256 = c4 * t154 + s4 * t248;
        put(28, t253); // row 1, XY4
        put(77, t256); // row 2, XY4
    }
    // XZ4: column
    {
        let t257 = t155 - t176;
        let t262 = c2 * t257 - (t125 * t157 - t124 * t156);
        let t265 = c4 * t156 + s4 * t157;
        put(29, t262); // row 1, XZ4
        put(78, t265); // row 2, XZ4
        put(124, t257); // row 4, XZ4
    }
    // YZ4: column
    {
        let t266 = t177 - t155;
        let t271 = c2 * t140 + (t124 * t266 + t125 * t153);
        let t274 = c4 * t266 - s4 * t153;
        put(30, t271); // row 1, YZ4
        put(79, t274); // row 2, YZ4
    }
    // link 5: motion
    let [
        t277, a5_y, t283, t286, t289, t292, w5_z, dw5_z,
        t295, t296, t297, t298, t299, t300, t301, t302,
        t303, t304, t305, t306,
    ] = {
        let t277 = c5 * t128 - s5 * t53;
        let a5_y = c5 * t53 + s5 * t128;
        let t283 = c5 * t134 + s5 * w4_z;
        let t286 = c5 * w4_z - s5 * t134;
        let t289 = c5 * t153 + s5 * t157;
        let t292 = c5 * t157 - s5 * t153;
        let w5_z = w4_y + dq5;
        let dw5_z = ddq5 - t152;
        let t295 = t283 * t283;
        let t296 = w5_z * w5_z;
        let t297 = t283 * t286;
        let t298 = t283 * w5_z;
        let t299 = t286 * w5_z;
        let t300 = t299 - t292;
        let t301 = t289 - t298;
        let t302 = dw5_z - t297;
        let t303 = dw5_z + t297;
        let t304 = t295 + t296;
        let t305 = t298 - t301;
        let t306 = t299 + t300;
        let t307 = -t277;
        let t308 = -t297;
        put(146, a5_y); // row 5, MSX5
        put(147, t307); // row 5, MSZ5
        put(148, t308); // row 5, XX5
        put(149, dw5_z); // row 5, YY5
        put(150, t297); // row 5, ZZ5
        put(151, t292); // row 5, XY5
        put(153, t289); // row 5, YZ5
        [
        t277, a5_y, t283, t286, t289, t292, w5_z, dw5_z,
        t295, t296, t297, t298, t299, t300, t301, t302,
        t303, t304, t305, t306,
    ]
    };
    // M5: column
    let [t310, t311] = {
        let t309 = t286 * t286;
        let t310 = t296 + t309;
        let t311 = t295 + t309;
        let t315 = t277 * t167 + a5_y * v1_5_y - t179;
        let t319 = t183 - (t277 * v2_5_x + a5_y * v2_6_z);
        let t322 = s5 * t277 - c5 * a5_y;
        put(31, t315); // row 1, M5
        put(80, t319); // row 2, M5
        put(109, t322); // row 3, M5
        [t310, t311]
    };
    // MSX5: column
    {
        let t330 = t305 * t9 + (t167 * t310 + t303 * v1_5_y);
        let t331 = a4_y * t164 - t125 * a5_y + t330;
        let t339 = t305 * v2_4_y + (v2_5_x * t310 + t303 * v2_6_z);
        let t340 = s4 * a5_y - a4_y * z2_5_y - t339;
        let t343 = s5 * t310 - c5 * t303;
        let t344 = c5 * a4_y;
        put(32, t331); // row 1, MSX5
        put(81, t340); // row 2, MSX5
        put(110, t343); // row 3, MSX5
        put(126, t344); // row 4, MSX5
    }
    // MSY5: column
    {
        let t352 = t9 * t311 + (t289 * t167 - t292 * v1_5_y);
        let t353 = a5_y * t161 + t277 * t164 + t352;
        let t361 = v2_4_y * t311 + (t289 * v2_5_x - t292 * v2_6_z);
        let t362 = a5_y * t171 - t277 * z2_5_y - t361;
        let t365 = s5 * t289 + c5 * t292;
        let t368 = s5 * a5_y + c5 * t277;
        put(33, t353); // row 1, MSY5
        put(82, t362); // row 2, MSY5
        put(111, t365); // row 3, MSY5
        put(127, t368); // row 4, MSY5
    }
    // MSZ5: column
    let [t373, t382, t388] = {
        let t373 = t304 * v1_5_y;
        let t377 = a4_y * t161 + t125 * t277 - (t306 * t9 + (t302 * t167 - t373));
        let t382 = t304 * v2_6_z;
        let t386 = a4_y * t171 - s4 * t277 + (t306 * v2_4_y + (t302 * v2_5_x - t382));
        let t388 = c5 * t304;
        let t390 = s5 * a4_y;
        let t391 = -(s5 * t302 + t388);
        put(34, t377); // row 1, MSZ5
        put(83, t386); // row 2, MSZ5
        put(112, t391); // row 3, MSZ5
        put(128, t390); // row 4, MSZ5
        [t373, t382, t388]
    };
    // XX5: column
    let [t393, t394, t398, t399, t403] = {
        let t393 = t298 * t164;
        let t394 = t125 * t297;
        let t396 = t394 + (t300 * t161 + t393);
        let t398 = t298 * z2_5_y;
        let t399 = s4 * t297;
        let t401 = t300 * t171 - t398 - t399;
        let t403 = c5 * t298;
        let t404 = s5 * t300 + t403;
        put(35, t396); // row 1, XX5
        put(84, t401); // row 2, XX5
        put(129, t404); // row 4, XX5
        [t393, t394, t398, t399, t403]
    };
    // YY5: column
    let [t405, t409, t413] = {
        let t405 = t299 * t161;
        let t408 = t405 - t393 - t125 * dw5_z;
        let t409 = t299 * t171;
        let t412 = s4 * dw5_z + (t398 + t409);
        let t413 = s5 * t299;
        let t414 = t413 - t403;
        put(36, t408); // row 1, YY5
        put(85, t412); // row 2, YY5
        put(130, t414); // row 4, YY5
        [t405, t409, t413]
    };
    // ZZ5: column
    {
        let t417 = t301 * t164 - t405 - t394;
        let t420 = t399 - (t409 + t301 * z2_5_y);
        let t422 = c5 * t301 - t413;
        put(37, t417); // row 1, ZZ5
        put(86, t420); // row 2, ZZ5
        put(131, t422); // row 4, ZZ5
    }
    // XY5: column
    {
        let t423 = t311 - t310;
        let t428 = t164 * t423 - t303 * t161 - t125 * t292;
        let t433 = s4 * t292 - (t303 * t171 + z2_5_y * t423);
        let t436 = c5 * t423 - s5 * t303;
        put(38, t428); // row 1, XY5
        put(87, t433); // row 2, XY5
        put(132, t436); // row 4, XY5
    }
    // XZ5: column
    {
        let t437 = t310 - t304;
        let t442 = t305 * t161 - t306 * t164 - t125 * t437;
        let t447 = s4 * t437 + (t305 * t171 + t306 * z2_5_y);
        let t450 = s5 * t305 - c5 * t306;
        put(39, t442); // row 1, XZ5
        put(88, t447); // row 2, XZ5
        put(133, t450); // row 4, XZ5
        put(152, t437); // row 5, XZ5
    }
    // YZ5: column
    {
        let t451 = t311 - t304;
        let t456 = t161 * t451 + t302 * t164 - t125 * t289;
        let t461 = s4 * t289 - (t302 * z2_5_y - t171 * t451);
        let t464 = s5 * t451 + c5 * t302;
        put(40, t456); // row 1, YZ5
        put(89, t461); // row 2, YZ5
        put(134, t464); // row 4, YZ5
    }
    // link 6: motion
    let [
        t469, t473, a6_y, t485, t488, dw6_z, t493, t494,
        t495, dw6_x, dw6_y, t498, t499, t500, t501, t502,
        t503, t504,
    ] = {
        let t468 = t277 - k_D6 * t302;
        let t469 = a5_y + k_D6 * t304;
        let t470 = a4_y + k_D6 * t306;
        let t473 = c6 * t468 - s6 * t470;
        let a6_y = c6 * t470 + s6 * t468;
        let w6_x = s6 * w5_z - c6 * t283;
        let w6_y = c6 * w5_z + s6 * t283;
        let t485 = c6 * t302 + s6 * t306;
        let t488 = s6 * t302 - c6 * t306;
        let w6_z = t286 + dq6;
        let dw6_z = t301 + ddq6;
        let t491 = w6_x * w6_x;
        let t492 = w6_z * w6_z;
        let t493 = w6_x * w6_y;
        let t494 = w6_x * w6_z;
        let t495 = w6_y * w6_z;
        let dw6_x = t488 + t495;
        let dw6_y = t485 - t494;
        let t498 = t492 - t491;
        let t499 = t304 + t498;
        let t500 = dw6_z - t493;
        let t501 = dw6_z + t493;
        let t502 = t491 + t492;
        let t503 = dw6_y - t494;
        let t504 = t495 + dw6_x;
        let t505 = -t493;
        put(165, a6_y); // row 6, MSX6
        put(166, t473); // row 6, MSY6
        put(167, t505); // row 6, XX6
        put(168, t493); // row 6, YY6
        put(169, dw6_z); // row 6, ZZ6
        put(171, t488); // row 6, XZ6
        put(172, t485); // row 6, YZ6
        [
        t469, t473, a6_y, t485, t488, dw6_z, t493, t494,
        t495, dw6_x, dw6_y, t498, t499, t500, t501, t502,
        t503, t504,
    ]
    };
    // M6: column
    let [t508, t511] = {
        let t508 = c6 * t473 + s6 * a6_y;
        let t511 = c6 * a6_y - s6 * t473;
        let t512 = k_D6 * t511;
        let t513 = k_D6 * t508;
        let t521 = t167 * t508 + t469 * v1_5_y - t9 * t511;
        let t522 = t161 * t512 + t125 * t513 + t521;
        let t530 = v2_4_y * t511 - (v2_5_x * t508 + t469 * v2_6_z);
        let t531 = t171 * t512 - s4 * t513 + t530;
        let t534 = s5 * t508 - c5 * t469;
        let t535 = s5 * t512;
        let t536 = -t513;
        put(41, t522); // row 1, M6
        put(90, t531); // row 2, M6
        put(113, t534); // row 3, M6
        put(135, t535); // row 4, M6
        put(154, t536); // row 5, M6
        [t508, t511]
    };
    // MSX6: column
    let [t538, t541, t543, t544] = {
        let t538 = s6 * t501;
        let t539 = c6 * t499 + t538;
        let t541 = c6 * t501;
        let t542 = s6 * t499 - t541;
        let t543 = s6 * t469;
        let t544 = c6 * t469;
        let t547 = t543 - k_D6 * t542;
        let t548 = t544 - k_D6 * t539;
        let t558 = t9 * t542 + (t167 * t539 + t503 * v1_5_y);
        let t559 = t161 * t547 + a6_y * t164 - t125 * t548 + t558;
        let t569 = v2_4_y * t542 + (v2_5_x * t539 + t503 * v2_6_z);
        let t570 = s4 * t548 + (t171 * t547 - a6_y * z2_5_y) - t569;
        let t573 = s5 * t539 - c5 * t503;
        let t576 = s5 * t547 + c5 * a6_y;
        put(42, t559); // row 1, MSX6
        put(91, t570); // row 2, MSX6
        put(114, t573); // row 3, MSX6
        put(136, t576); // row 4, MSX6
        put(155, t548); // row 5, MSX6
        [t538, t541, t543, t544]
    };
    // MSY6: column
    let [t577, t580] = {
        let t577 = c6 * t500;
        let t579 = s6 * t502 - t577;
        let t580 = s6 * t500;
        let t582 = t580 + c6 * t502;
        let t585 = k_D6 * t582 - t544;
        let t586 = k_D6 * t579 - t543;
        let t596 = t9 * t582 - (t167 * t579 + t504 * v1_5_y);
        let t597 = t473 * t164 - t161 * t585 - t125 * t586 + t596;
        let t607 = v2_4_y * t582 - (v2_5_x * t579 + t504 * v2_6_z);
        let t608 = s4 * t586 - (t171 * t585 + t473 * z2_5_y) - t607;
        let t611 = c5 * t504 - s5 * t579;
        let t614 = c5 * t473 - s5 * t585;
        put(43, t597); // row 1, MSY6
        put(92, t608); // row 2, MSY6
        put(115, t611); // row 3, MSY6
        put(137, t614); // row 4, MSY6
        put(156, t586); // row 5, MSY6
        [t577, t580]
    };
    // MSZ6: column
    {
        let t617 = c6 * t485 + s6 * t488;
        let t620 = c6 * t488 - s6 * t485;
        let t623 = t511 - k_D6 * t620;
        let t624 = k_D6 * t617 - t508;
        let t632 = t161 * t623 - t125 * t624 + (t9 * t620 + (t373 - t167 * t617));
        let t640 = t171 * t623 + s4 * t624 - (v2_4_y * t620 + (t382 - v2_5_x * t617));
        let t643 = s5 * t623;
        let t644 = -(t388 + s5 * t617);
        put(44, t632); // row 1, MSZ6
        put(93, t640); // row 2, MSZ6
        put(116, t644); // row 3, MSZ6
        put(138, t643); // row 4, MSZ6
        put(157, t624); // row 5, MSZ6
    }
    // XX6: column
    let [t646, t649, t652, t657, t662] = {
        let t646 = s6 * t494;
        let t647 = t646 - c6 * dw6_x;
        let t649 = c6 * t494;
        let t650 = s6 * dw6_x + t649;
        let t652 = t493 * t164;
        let t655 = t161 * t647 - t652 - t125 * t650;
        let t657 = t493 * z2_5_y;
        let t660 = s4 * t650 + (t171 * t647 + t657);
        let t662 = c5 * t493;
        let t663 = s5 * t647 - t662;
        put(45, t655); // row 1, XX6
        put(94, t660); // row 2, XX6
        put(139, t663); // row 4, XX6
        put(158, t650); // row 5, XX6
        [t646, t649, t652, t657, t662]
    };
    // YY6: column
    let [t664, t667] = {
        let t664 = c6 * t495;
        let t666 = t664 + s6 * dw6_y;
        let t667 = s6 * t495;
        let t669 = c6 * dw6_y - t667;
        let t673 = t652 + t161 * t666 - t125 * t669;
        let t677 = s4 * t669 + (t171 * t666 - t657);
        let t679 = t662 + s5 * t666;
        put(46, t673); // row 1, YY6
        put(95, t677); // row 2, YY6
        put(140, t679); // row 4, YY6
        put(159, t669); // row 5, YY6
        [t664, t667]
    };
    // ZZ6: column
    {
        let t680 = t646 + t664;
        let t681 = t667 - t649;
        let t686 = dw6_z * t164 - t161 * t680 - t125 * t681;
        let t691 = s4 * t681 - (t171 * t680 + dw6_z * z2_5_y);
        let t694 = c5 * dw6_z - s5 * t680;
        put(47, t686); // row 1, ZZ6
        put(96, t691); // row 2, ZZ6
        put(141, t694); // row 4, ZZ6
        put(160, t681); // row 5, ZZ6
    }
    // XY6: column
    {
        let t695 = t502 - t499;
        let t698 = s6 * t504 - c6 * t503;
        let t701 = s6 * t503 + c6 * t504;
        let t706 = t161 * t698 + t164 * t695 - t125 * t701;
        let t711 = s4 * t701 - (z2_5_y * t695 - t171 * t698);
        let t714 = s5 * t698 + c5 * t695;
        put(48, t706); // row 1, XY6
        put(97, t711); // row 2, XY6
        put(142, t714); // row 4, XY6
        put(161, t701); // row 5, XY6
        put(170, t695); // row 6, XY6
    }
    // XZ6: column
    {
        let t716 = t541 - s6 * t498;
        let t718 = t538 + c6 * t498;
        let t723 = t488 * t164 - t161 * t716 - t125 * t718;
        let t728 = s4 * t718 - (t171 * t716 + t488 * z2_5_y);
        let t731 = c5 * t488 - s5 * t716;
        put(49, t723); // row 1, XZ6
        put(98, t728); // row 2, XZ6
        put(143, t731); // row 4, XZ6
        put(162, t718); // row 5, XZ6
    }
    // YZ6: column
    {
        let t732 = t304 - t502;
        let t734 = t580 - c6 * t732;
        let t736 = t577 + s6 * t732;
        let t741 = t161 * t734 + t485 * t164 - t125 * t736;
        let t746 = s4 * t736 + (t171 * t734 - t485 * z2_5_y);
        let t749 = s5 * t734 + c5 * t485;
        put(50, t741); // row 1, YZ6
        put(99, t746); // row 2, YZ6
        put(144, t749); // row 4, YZ6
        put(163, t736); // row 5, YZ6
    }
}
