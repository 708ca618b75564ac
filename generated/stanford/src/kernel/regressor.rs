//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil and Dombre, 12.4.
//!
//! 453 multiplications, 338 additions; 6 x 66, 174 of 396 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

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

/// Regressor `W` of the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 66]; 6]) {
    out.as_flattened_mut().fill(S::default());
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
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], mut put: impl FnMut(usize, S)) {
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let D2 = S::constant(0.154);
    let D6 = S::constant(0.263);
    let k0 = S::constant(9.81);
    let k2 = S::constant(2.0);
    // link 2: motion
    let [
        t0, w3_z, t2, t3, t8, t10, a2_y, t13,
        t14, t15, t16,
    ] = {
        let t0 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t2 = s2 * ddq1;
        let t3 = c2 * ddq1;
        let t7 = D2 * ddq1;
        let t8 = D2 * (dq1 * dq1);
        let t10 = s2 * k0 + c2 * t7;
        let a2_y = s2 * t7 - c2 * k0;
        let t13 = dq2 * w3_z;
        let t14 = dq2 * t0;
        let t15 = t2 + t13;
        let t16 = t3 - t14;
        put(0, ddq1); // row 1, YY1
        put(51, ddq1); // row 1, IA1
        put(52, a2_y); // row 2, MSX2
        put(55, ddq2); // row 2, YY2
        put(59, t3); // row 2, YZ2
        put(64, ddq2); // row 2, XX3
        put(67, t2); // row 2, XY3
        put(100, ddq2); // row 2, IA2
        put(102, t2); // row 3, MSX3
        put(117, ddq3); // row 3, IA3
        put(145, ddq4); // row 4, IA4
        put(164, ddq5); // row 5, IA5
        put(173, ddq6); // row 6, IA6
        [
        t0, w3_z, t2, t3, t8, t10, a2_y, t13,
        t14, t15, t16,
    ]
    };
    // link 3: motion
    let [
        t17, t18, t19, t20, t21, t22, t23, t24,
        t25, t26, t27, t28, t30, t37, a3_y, t39,
    ] = {
        let t17 = t0 * t0;
        let t18 = w3_z * w3_z;
        let t19 = dq2 * dq2;
        let t20 = t0 * w3_z;
        let t21 = t18 + t19;
        let t22 = ddq2 - t20;
        let t23 = ddq2 + t20;
        let t24 = t17 + t19;
        let t25 = t14 - t16;
        let t26 = t13 + t15;
        let t27 = t17 + t18;
        let t28 = q3 * t22;
        let t30 = q3 * t26;
        let t34 = dq3 * k2;
        let t37 = t30 - t8 + t0 * t34;
        let a3_y = t28 - t10 + dq2 * t34;
        let t39 = a2_y + q3 * t24 - ddq3;
        put(56, t20); // row 2, ZZ2
        put(66, t20); // row 2, ZZ3
        [
        t17, t18, t19, t20, t21, t22, t23, t24,
        t25, t26, t27, t28, t30, t37, a3_y, t39,
    ]
    };
    // link 4: motion
    let [t42, w4_y, t54, a4_y, w4_z, t61, t62, dw4_z] = {
        let t42 = c4 * dq2 + s4 * t0;
        let w4_y = s4 * dq2 - c4 * t0;
        let t54 = c4 * t37 - s4 * a3_y;
        let a4_y = c4 * a3_y + s4 * t37;
        let w4_z = w3_z + dq4;
        let t61 = c4 * ddq2 + s4 * t15 - dq4 * w4_y;
        let t62 = c4 * t15 - s4 * ddq2 - dq4 * t42;
        let dw4_z = t16 + ddq4;
        put(118, a4_y); // row 4, MSX4
        put(119, t54); // row 4, MSZ4
        put(121, dw4_z); // row 4, YY4
        [t42, w4_y, t54, a4_y, w4_z, t61, t62, dw4_z]
    };
    // link 5: motion
    let [
        t66, t69, t76, t77, t78, t79, t80, t81,
        t82, t83, t84, t85, t86, t87, t88, t89,
        t90, a5_x, a5_y, w5_z, t100, t101, dw5_z,
    ] = {
        let t66 = c5 * t42 + s5 * w4_z;
        let t69 = c5 * w4_z - s5 * t42;
        let t76 = t42 * t42;
        let t77 = w4_y * w4_y;
        let t78 = w4_z * w4_z;
        let t79 = t42 * w4_y;
        let t80 = t42 * w4_z;
        let t81 = w4_y * w4_z;
        let t82 = t77 + t78;
        let t83 = dw4_z + t79;
        let t84 = t62 + t80;
        let t85 = dw4_z - t79;
        let t86 = t76 + t78;
        let t87 = t61 + t81;
        let t88 = t62 - t80;
        let t89 = t81 - t61;
        let t90 = t76 + t77;
        let a5_x = s5 * t39 - c5 * t54;
        let a5_y = c5 * t39 + s5 * t54;
        let w5_z = w4_y + dq5;
        let t100 = c5 * t61 + s5 * dw4_z + dq5 * t69;
        let t101 = c5 * dw4_z - s5 * t61 - dq5 * t66;
        let dw5_z = ddq5 - t62;
        put(106, t88); // row 3, MSX4
        put(107, t90); // row 3, MSY4
        put(108, t89); // row 3, MSZ4
        put(120, t79); // row 4, XX4
        put(123, t87); // row 4, XY4
        put(125, t84); // row 4, YZ4
        put(146, a5_y); // row 5, MSX5
        put(147, a5_x); // row 5, MSZ5
        put(149, dw5_z); // row 5, YY5
        [
        t66, t69, t76, t77, t78, t79, t80, t81,
        t82, t83, t84, t85, t86, t87, t88, t89,
        t90, a5_x, a5_y, w5_z, t100, t101, dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t115, t116, t117, t118, t119, t120,
        t121, t122, t123, t124, t125, t126, t127, t128,
        t129, t134, t138, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ] = {
        let w6_x = s6 * w5_z - c6 * t66;
        let w6_y = c6 * w5_z + s6 * t66;
        let t115 = t66 * t66;
        let t116 = t69 * t69;
        let t117 = w5_z * w5_z;
        let t118 = t66 * t69;
        let t119 = t66 * w5_z;
        let t120 = t69 * w5_z;
        let t121 = t116 + t117;
        let t122 = t118 - dw5_z;
        let t123 = t101 + t119;
        let t124 = dw5_z + t118;
        let t125 = t115 + t117;
        let t126 = t120 - t100;
        let t127 = t119 - t101;
        let t128 = t100 + t120;
        let t129 = t115 + t116;
        let t133 = D6 * t122 - a5_x;
        let t134 = a5_y + D6 * t125;
        let t135 = a4_y + D6 * t128;
        let t138 = c6 * t133 - s6 * t135;
        let a6_y = c6 * t135 + s6 * t133;
        let w6_z = t69 + dq6;
        let dw6_x = s6 * dw5_z - c6 * t100 + dq6 * w6_y;
        let dw6_y = c6 * dw5_z + s6 * t100 - dq6 * w6_x;
        let dw6_z = t101 + ddq6;
        put(150, t118); // row 5, ZZ5
        put(151, t126); // row 5, XY5
        put(153, t123); // row 5, YZ5
        put(165, a6_y); // row 6, MSX6
        put(166, t138); // row 6, MSY6
        put(169, dw6_z); // row 6, ZZ6
        [
        w6_x, w6_y, t115, t116, t117, t118, t119, t120,
        t121, t122, t123, t124, t125, t126, t127, t128,
        t129, t134, t138, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ]
    };
    // joint axes in frame 2
    let [t148, v1_2_y] = {
        let t148 = c2 * D2;
        let v1_2_y = s2 * D2;
        [t148, v1_2_y]
    };
    // joint axes in frame 4
    let [t150, t151, t152, t153] = {
        let t150 = s2 * s4;
        let t151 = s2 * c4;
        let t152 = s4 * t148;
        let t153 = c4 * t148;
        [t150, t151, t152, t153]
    };
    // M2: column
    {
        let t156 = t10 * t148 + a2_y * v1_2_y;
        put(1, t156); // row 1, M2
    }
    // MSX2: column
    let t160 = {
        let t160 = t21 * t148 + t23 * v1_2_y;
        let t161 = t160 - c2 * t8;
        put(2, t161); // row 1, MSX2
        t160
    };
    // MSY2: column
    let t167 = {
        let t167 = t3 * t148 + t2 * v1_2_y;
        let t168 = s2 * a2_y + c2 * t10 + t167;
        put(3, t168); // row 1, MSY2
        t167
    };
    // MSZ2: column
    let t172 = {
        let t172 = t24 * v1_2_y - t22 * t148;
        let t173 = t172 - s2 * t8;
        put(4, t173); // row 1, MSZ2
        t172
    };
    // XX2: column
    let t175 = {
        let t175 = c2 * t14;
        let t176 = s2 * t15 + t175;
        put(5, t176); // row 1, XX2
        put(16, t176); // row 1, YY3
        t175
    };
    // YY2: column
    let t177 = {
        let t177 = s2 * t13;
        let t178 = t177 - t175;
        put(6, t178); // row 1, YY2
        put(15, t178); // row 1, XX3
        t177
    };
    // ZZ2: column
    {
        let t180 = c2 * t16 - t177;
        put(7, t180); // row 1, ZZ2
        put(17, t180); // row 1, ZZ3
    }
    // XY2: column
    let t184 = {
        let t184 = s2 * t23 + c2 * (t19 - t17);
        put(18, t184); // row 1, XY3
        t184
    };
    // XZ2: column
    {
        let t185 = t18 - t17;
        let t188 = s2 * t25 - c2 * t26;
        put(9, t188); // row 1, XZ2
        put(20, t188); // row 1, YZ3
        put(58, t185); // row 2, XZ2
        put(69, t185); // row 2, YZ3
    }
    // YZ2: column
    let t192 = {
        let t192 = s2 * (t18 - t19) + c2 * t22;
        put(10, t192); // row 1, YZ2
        t192
    };
    // M3: column
    let t197 = {
        let t194 = q3 * a3_y;
        let t197 = t39 * v1_2_y;
        let t199 = s2 * (q3 * t37) + (t197 - a3_y * t148);
        put(11, t199); // row 1, M3
        put(60, t194); // row 2, M3
        t197
    };
    // MSX3: column
    {
        let t201 = q3 * t3;
        let t206 = s2 * (q3 * t27 - t39) + c2 * a3_y - t167;
        put(12, t206); // row 1, MSX3
        put(61, t201); // row 2, MSX3
    }
    // MSY3: column
    {
        let t209 = t39 - q3 * t21;
        let t213 = t160 + (c2 * t37 - s2 * (q3 * t25));
        put(13, t213); // row 1, MSY3
        put(62, t209); // row 2, MSY3
    }
    // MSZ3: column
    {
        let t215 = t28 + a3_y;
        let t217 = t172 + s2 * (t30 + t37);
        put(14, t217); // row 1, MSZ3
        put(63, t215); // row 2, MSZ3
    }
    // M4: column
    let [t220, t223] = {
        let t220 = c4 * t54 + s4 * a4_y;
        let t223 = c4 * a4_y - s4 * t54;
        let t225 = q3 * t223;
        let t229 = s2 * (q3 * t220) + (t197 - t148 * t223);
        put(21, t229); // row 1, M4
        put(70, t225); // row 2, M4
        [t220, t223]
    };
    // MSX4: column
    let [t234, t236, t237] = {
        let t234 = c4 * t85;
        let t235 = t234 - s4 * t82;
        let t236 = s4 * t39;
        let t237 = c4 * t39;
        let t241 = t236 + q3 * t235;
        let t244 = s2 * (q3 * (c4 * t82 + s4 * t85) - t237) + c2 * a4_y;
        let t248 = t244 - (t148 * t235 + t88 * v1_2_y);
        put(22, t248); // row 1, MSX4
        put(71, t241); // row 2, MSX4
        [t234, t236, t237]
    };
    // MSY4: column
    let t263 = {
        let t254 = s4 * t84 - c4 * t87;
        let t258 = q3 * t254 - t223;
        let t262 = t148 * t254 + t90 * v1_2_y;
        let t263 = s2 * (t220 + q3 * (c4 * t84 + s4 * t87)) + t262;
        put(72, t258); // row 2, MSY4
        t263
    };
    // MSZ4: column
    let t267 = {
        let t267 = s4 * t83;
        let t269 = t267 + c4 * t86;
        let t273 = t237 - q3 * t269;
        let t276 = s2 * (t236 - q3 * (s4 * t86 - c4 * t83)) + c2 * t54;
        let t280 = t276 + (t148 * t269 - t89 * v1_2_y);
        put(24, t280); // row 1, MSZ4
        put(73, t273); // row 2, MSZ4
        t267
    };
    // XX4: column
    let [t282, t283, t287] = {
        let t282 = t80 * t151;
        let t283 = c2 * t79;
        let t285 = t283 + (t61 * t150 + t282);
        let t287 = s4 * t80;
        let t288 = c4 * t61 - t287;
        put(25, t285); // row 1, XX4
        put(74, t288); // row 2, XX4
        [t282, t283, t287]
    };
    // YY4: column
    let [t289, t293] = {
        let t289 = t81 * t150;
        let t292 = c2 * dw4_z - (t282 + t289);
        let t293 = c4 * t81;
        let t294 = t287 - t293;
        put(26, t292); // row 1, YY4
        put(75, t294); // row 2, YY4
        [t289, t293]
    };
    // ZZ4: column
    {
        let t297 = t289 + t62 * t151 - t283;
        let t299 = t293 - s4 * t62;
        put(27, t297); // row 1, ZZ4
        put(76, t299); // row 2, ZZ4
    }
    // XY4: column
    {
        let t300 = t76 - t78;
        let t305 = c2 * t87 - (t151 * t300 - t85 * t150);
        let t307 = t234 + s4 * t300;
        put(28, t305); // row 1, XY4
        put(77, t307); // row 2, XY4
    }
    // XZ4: column
    {
        let t308 = t76 - t77;
        let t313 = c2 * t308 + (t88 * t150 - t89 * t151);
        let t316 = c4 * t88 + s4 * t89;
        put(29, t313); // row 1, XZ4
        put(78, t316); // row 2, XZ4
        put(124, t308); // row 4, XZ4
    }
    // YZ4: column
    {
        let t317 = t77 - t78;
        let t322 = c2 * t84 + (t150 * t317 + t83 * t151);
        let t324 = c4 * t317 - t267;
        put(30, t322); // row 1, YZ4
        put(79, t324); // row 2, YZ4
    }
    // M5: column
    let [t327, t330] = {
        let t327 = s5 * a5_y - c5 * a5_x;
        let t330 = s5 * a5_x + c5 * a5_y;
        let t331 = q3 * a4_y;
        let t332 = q3 * t327;
        let t340 = v1_2_y * t330 - (a4_y * t153 - t152 * t327);
        let t341 = t150 * t331 + t151 * t332 + t340;
        let t344 = c4 * t331 - s4 * t332;
        put(31, t341); // row 1, M5
        put(80, t344); // row 2, M5
        put(127, t327); // row 4, MSY5
        [t327, t330]
    };
    // MSX5: column
    let [t346, t349, t351, t352] = {
        let t346 = s5 * t124;
        let t347 = c5 * t121 + t346;
        let t349 = c5 * t124;
        let t350 = s5 * t121 - t349;
        let t351 = s5 * a4_y;
        let t352 = c5 * a4_y;
        let t355 = t351 + q3 * t127;
        let t356 = a5_y - q3 * t347;
        let t361 = t150 * t355 + t151 * t356 - c2 * t352;
        let t367 = t152 * t347 + t127 * t153 - v1_2_y * t350 - t361;
        let t370 = s4 * t356 - c4 * t355;
        put(32, t367); // row 1, MSX5
        put(81, t370); // row 2, MSX5
        put(110, t350); // row 3, MSX5
        put(126, t352); // row 4, MSX5
        put(128, t351); // row 4, MSZ5
        [t346, t349, t351, t352]
    };
    // MSY5: column
    {
        let t373 = s5 * t126 - c5 * t123;
        let t376 = s5 * t123 + c5 * t126;
        let t378 = q3 * t373;
        let t379 = t330 - q3 * t129;
        let t389 = v1_2_y * t376 + (t152 * t373 - t129 * t153);
        let t390 = c2 * t327 - (t151 * t378 - t150 * t379) - t389;
        let t393 = c4 * t379 + s4 * t378;
        put(33, t390); // row 1, MSY5
        put(82, t393); // row 2, MSY5
        put(111, t376); // row 3, MSY5
    }
    // MSZ5: column
    let [t394, t397] = {
        let t394 = c5 * t122;
        let t396 = t394 + s5 * t125;
        let t397 = s5 * t122;
        let t399 = t397 - c5 * t125;
        let t402 = t352 + q3 * t128;
        let t403 = q3 * t396 - a5_x;
        let t413 = t152 * t396 - t128 * t153 - v1_2_y * t399;
        let t414 = c2 * t351 + (t150 * t402 + t151 * t403) + t413;
        let t417 = c4 * t402 - s4 * t403;
        put(34, t414); // row 1, MSZ5
        put(83, t417); // row 2, MSZ5
        put(112, t399); // row 3, MSZ5
        [t394, t397]
    };
    // XX5: column
    let [t419, t422, t425, t430] = {
        let t419 = s5 * t119;
        let t420 = c5 * t100 - t419;
        let t422 = c5 * t119;
        let t423 = s5 * t100 + t422;
        let t425 = t118 * t151;
        let t428 = c2 * t423 + (t150 * t420 + t425);
        let t430 = s4 * t118;
        let t431 = c4 * t420 - t430;
        put(35, t428); // row 1, XX5
        put(84, t431); // row 2, XX5
        put(129, t423); // row 4, XX5
        [t419, t422, t425, t430]
    };
    // YY5: column
    let [t432, t434] = {
        let t432 = c5 * t120;
        let t433 = t419 + t432;
        let t434 = s5 * t120;
        let t435 = t434 - t422;
        let t440 = c2 * t435 + (t150 * t433 - dw5_z * t151);
        let t443 = c4 * t433 + s4 * dw5_z;
        put(36, t440); // row 1, YY5
        put(85, t443); // row 2, YY5
        put(130, t435); // row 4, YY5
        [t432, t434]
    };
    // ZZ5: column
    {
        let t445 = t432 + s5 * t101;
        let t447 = c5 * t101 - t434;
        let t451 = c2 * t447 - (t425 + t150 * t445);
        let t453 = t430 - c4 * t445;
        put(37, t451); // row 1, ZZ5
        put(86, t453); // row 2, ZZ5
        put(131, t447); // row 4, ZZ5
    }
    // XY5: column
    {
        let t454 = t115 - t117;
        let t456 = t349 + s5 * t454;
        let t458 = c5 * t454 - t346;
        let t463 = c2 * t458 - (t150 * t456 + t126 * t151);
        let t466 = s4 * t126 - c4 * t456;
        put(38, t463); // row 1, XY5
        put(87, t466); // row 2, XY5
        put(132, t458); // row 4, XY5
    }
    // XZ5: column
    {
        let t467 = t116 - t115;
        let t470 = c5 * t127 + s5 * t128;
        let t473 = s5 * t127 - c5 * t128;
        let t478 = c2 * t473 + (t150 * t470 - t151 * t467);
        let t481 = c4 * t470 + s4 * t467;
        put(39, t478); // row 1, XZ5
        put(88, t481); // row 2, XZ5
        put(133, t473); // row 4, XZ5
        put(152, t467); // row 5, XZ5
    }
    // YZ5: column
    {
        let t482 = t116 - t117;
        let t484 = t397 + c5 * t482;
        let t486 = s5 * t482 - t394;
        let t491 = c2 * t486 + (t150 * t484 - t123 * t151);
        let t494 = c4 * t484 + s4 * t123;
        put(40, t491); // row 1, YZ5
        put(89, t494); // row 2, YZ5
        put(134, t486); // row 4, YZ5
    }
    // M6: column
    let [
        t495, t496, t497, t498, t499, t500, t501, t502,
        t503, t504, t505, t506, t507, t508, t509, t512,
        t515, t517,
    ] = {
        let t495 = w6_x * w6_x;
        let t496 = w6_y * w6_y;
        let t497 = w6_z * w6_z;
        let t498 = w6_x * w6_y;
        let t499 = w6_x * w6_z;
        let t500 = w6_y * w6_z;
        let t501 = t496 + t497;
        let t502 = t498 - dw6_z;
        let t503 = dw6_y + t499;
        let t504 = dw6_z + t498;
        let t505 = t495 + t497;
        let t506 = dw6_x - t500;
        let t507 = t499 - dw6_y;
        let t508 = dw6_x + t500;
        let t509 = t495 + t496;
        let t512 = c6 * t138 + s6 * a6_y;
        let t515 = c6 * a6_y - s6 * t138;
        let t516 = D6 * t515;
        let t517 = D6 * t512;
        let t520 = c5 * t512 + s5 * t134;
        let t523 = s5 * t512 - c5 * t134;
        let t525 = s5 * t516;
        let t528 = c5 * t516 + q3 * t515;
        let t529 = t517 + q3 * t520;
        let t539 = t152 * t520 - t153 * t515 - v1_2_y * t523;
        let t540 = c2 * t525 + (t150 * t528 + t151 * t529) + t539;
        let t543 = c4 * t528 - s4 * t529;
        put(41, t540); // row 1, M6
        put(90, t543); // row 2, M6
        put(113, t523); // row 3, M6
        put(135, t525); // row 4, M6
        put(168, t498); // row 6, YY6
        put(171, t506); // row 6, XZ6
        put(172, t503); // row 6, YZ6
        [
        t495, t496, t497, t498, t499, t500, t501, t502,
        t503, t504, t505, t506, t507, t508, t509, t512,
        t515, t517,
    ]
    };
    // MSX6: column
    let [t545, t548, t550, t551] = {
        let t545 = s6 * t504;
        let t546 = c6 * t501 + t545;
        let t548 = c6 * t504;
        let t549 = t548 - s6 * t501;
        let t550 = s6 * t134;
        let t551 = c6 * t134;
        let t554 = t550 + D6 * t549;
        let t555 = t551 - D6 * t546;
        let t558 = c5 * t546 - s5 * t507;
        let t561 = s5 * t546 + c5 * t507;
        let t567 = s5 * t554 + c5 * a6_y;
        let t570 = q3 * t549 - (s5 * a6_y - c5 * t554);
        let t571 = t555 - q3 * t558;
        let t581 = t152 * t558 - t153 * t549 - v1_2_y * t561;
        let t582 = c2 * t567 + (t150 * t570 - t151 * t571) + t581;
        let t585 = c4 * t570 + s4 * t571;
        put(42, t582); // row 1, MSX6
        put(91, t585); // row 2, MSX6
        put(114, t561); // row 3, MSX6
        put(136, t567); // row 4, MSX6
        put(155, t555); // row 5, MSX6
        [t545, t548, t550, t551]
    };
    // MSY6: column
    let [t586, t589] = {
        let t586 = c6 * t502;
        let t588 = t586 + s6 * t505;
        let t589 = s6 * t502;
        let t591 = c6 * t505 - t589;
        let t594 = D6 * t591 - t551;
        let t595 = D6 * t588 - t550;
        let t598 = c5 * t588 + s5 * t508;
        let t601 = c5 * t508 - s5 * t588;
        let t607 = c5 * t138 - s5 * t594;
        let t610 = c5 * t594 + s5 * t138 + q3 * t591;
        let t611 = t595 + q3 * t598;
        let t621 = v1_2_y * t601 + (t152 * t598 - t153 * t591);
        let t622 = c2 * t607 - (t150 * t610 + t151 * t611) - t621;
        let t625 = s4 * t611 - c4 * t610;
        put(43, t622); // row 1, MSY6
        put(92, t625); // row 2, MSY6
        put(115, t601); // row 3, MSY6
        put(137, t607); // row 4, MSY6
        put(156, t595); // row 5, MSY6
        [t586, t589]
    };
    // MSZ6: column
    let t641 = {
        let t628 = c6 * t503 + s6 * t506;
        let t631 = s6 * t503 - c6 * t506;
        let t634 = t515 + D6 * t631;
        let t635 = D6 * t628 - t512;
        let t638 = s5 * t509 - c5 * t628;
        let t641 = s5 * t628 + c5 * t509;
        let t643 = s5 * t634;
        let t646 = c5 * t634 + q3 * t631;
        let t647 = q3 * t638 - t635;
        let t657 = v1_2_y * t641 - (t153 * t631 - t152 * t638);
        let t658 = c2 * t643 + (t150 * t646 + t151 * t647) + t657;
        let t661 = c4 * t646 - s4 * t647;
        put(44, t658); // row 1, MSZ6
        put(93, t661); // row 2, MSZ6
        put(138, t643); // row 4, MSZ6
        put(157, t635); // row 5, MSZ6
        t641
    };
    // XX6: column
    let [t663, t666, t669, t672] = {
        let t663 = s6 * t499;
        let t664 = t663 - c6 * dw6_x;
        let t666 = c6 * t499;
        let t667 = s6 * dw6_x + t666;
        let t669 = s5 * t498;
        let t670 = c5 * t664 + t669;
        let t672 = c5 * t498;
        let t673 = s5 * t664 - t672;
        let t678 = c2 * t673 + (t150 * t670 - t151 * t667);
        let t681 = c4 * t670 + s4 * t667;
        put(45, t678); // row 1, XX6
        put(94, t681); // row 2, XX6
        put(139, t673); // row 4, XX6
        put(158, t667); // row 5, XX6
        [t663, t666, t669, t672]
    };
    // YY6: column
    let [t682, t685] = {
        let t682 = c6 * t500;
        let t684 = t682 + s6 * dw6_y;
        let t685 = s6 * t500;
        let t687 = c6 * dw6_y - t685;
        let t689 = c5 * t684 - t669;
        let t691 = t672 + s5 * t684;
        let t696 = c2 * t691 + (t150 * t689 - t151 * t687);
        let t699 = c4 * t689 + s4 * t687;
        put(46, t696); // row 1, YY6
        put(95, t699); // row 2, YY6
        put(140, t691); // row 4, YY6
        put(159, t687); // row 5, YY6
        [t682, t685]
    };
    // ZZ6: column
    {
        let t700 = t663 + t682;
        let t701 = t685 - t666;
        let t704 = c5 * t700 + s5 * dw6_z;
        let t707 = c5 * dw6_z - s5 * t700;
        let t712 = c2 * t707 - (t150 * t704 + t151 * t701);
        let t715 = s4 * t701 - c4 * t704;
        put(47, t712); // row 1, ZZ6
        put(96, t715); // row 2, ZZ6
        put(141, t707); // row 4, ZZ6
        put(160, t701); // row 5, ZZ6
    }
    // XY6: column
    {
        let t716 = t495 - t496;
        let t719 = c6 * t507 + s6 * t508;
        let t722 = c6 * t508 - s6 * t507;
        let t725 = c5 * t719 - s5 * t716;
        let t728 = s5 * t719 + c5 * t716;
        let t733 = c2 * t728 + (t150 * t725 - t151 * t722);
        let t736 = c4 * t725 + s4 * t722;
        put(48, t733); // row 1, XY6
        put(97, t736); // row 2, XY6
        put(142, t728); // row 4, XY6
        put(161, t722); // row 5, XY6
        put(170, t716); // row 6, XY6
    }
    // XZ6: column
    {
        let t737 = t497 - t495;
        let t739 = s6 * t737 - t548;
        let t741 = t545 + c6 * t737;
        let t744 = c5 * t739 - s5 * t506;
        let t747 = s5 * t739 + c5 * t506;
        let t752 = c2 * t747 + (t150 * t744 - t151 * t741);
        let t755 = c4 * t744 + s4 * t741;
        put(49, t752); // row 1, XZ6
        put(98, t755); // row 2, XZ6
        put(143, t747); // row 4, XZ6
        put(162, t741); // row 5, XZ6
    }
    // YZ6: column
    {
        let t756 = t496 - t497;
        let t758 = t589 + c6 * t756;
        let t760 = s6 * t756 - t586;
        let t763 = c5 * t758 + s5 * t503;
        let t766 = c5 * t503 - s5 * t758;
        let t771 = c2 * t766 - (t150 * t763 + t151 * t760);
        let t774 = s4 * t760 - c4 * t763;
        let t775 = -t184;
        let t776 = -t192;
        let t777 = -t263;
        let t778 = -t10;
        let t779 = -t20;
        let t780 = -t2;
        let t781 = -t3;
        let t782 = -t39;
        let t783 = -t23;
        let t784 = -t24;
        let t785 = -t330;
        let t786 = -t641;
        let t787 = -t79;
        let t788 = -t118;
        let t789 = -t517;
        let t790 = -t498;
        put(8, t775); // row 1, XY2
        put(19, t776); // row 1, XZ3
        put(23, t777); // row 1, MSY4
        put(50, t771); // row 1, YZ6
        put(53, t778); // row 2, MSZ2
        put(54, t779); // row 2, XX2
        put(57, t780); // row 2, XY2
        put(65, t779); // row 2, YY3
        put(68, t781); // row 2, XZ3
        put(99, t774); // row 2, YZ6
        put(101, t782); // row 3, M3
        put(103, t783); // row 3, MSY3
        put(104, t784); // row 3, MSZ3
        put(105, t782); // row 3, M4
        put(109, t785); // row 3, M5
        put(116, t786); // row 3, MSZ6
        put(122, t787); // row 4, ZZ4
        put(144, t766); // row 4, YZ6
        put(148, t788); // row 5, XX5
        put(154, t789); // row 5, M6
        put(163, t760); // row 5, YZ6
        put(167, t790); // row 6, XX6
    }
}
