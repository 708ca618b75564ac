//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4.
//!
//! 344 multiplications, 254 additions; 6 x 37, 121 of 222 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 121;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9),
    (0, 10), (0, 11), (0, 12), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18), (0, 19),
    (0, 20), (0, 21), (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28), (0, 29),
    (0, 30), (0, 31), (0, 32), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7),
    (1, 8), (1, 9), (1, 10), (1, 11), (1, 12), (1, 13), (1, 14), (1, 15), (1, 16), (1, 17),
    (1, 18), (1, 19), (1, 20), (1, 21), (1, 22), (1, 23), (1, 24), (1, 25), (1, 26), (1, 27),
    (1, 28), (1, 29), (1, 30), (1, 31), (1, 32), (2, 8), (2, 9), (2, 10), (2, 11), (2, 12),
    (2, 13), (2, 19), (2, 20), (2, 26), (2, 27), (2, 33), (3, 12), (3, 13), (3, 14), (3, 15),
    (3, 16), (3, 17), (3, 18), (3, 19), (3, 20), (3, 21), (3, 22), (3, 23), (3, 24), (3, 25),
    (3, 26), (3, 27), (3, 28), (3, 29), (3, 30), (3, 31), (3, 32), (3, 34), (4, 19), (4, 20),
    (4, 21), (4, 22), (4, 23), (4, 24), (4, 25), (4, 26), (4, 27), (4, 28), (4, 29), (4, 30),
    (4, 31), (4, 32), (4, 35), (5, 26), (5, 27), (5, 28), (5, 29), (5, 30), (5, 31), (5, 32),
    (5, 36),
];

/// Regressor `W_b` of the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 37]; 6]) {
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
        put(0, ddq1); // row 1, YY1R
        put(33, a2_y); // row 2, MSX2
        put(35, ddq2); // row 2, YY2R
        put(39, t3); // row 2, YZ2R
        put(66, t2); // row 3, MSX3
        put(75, ddq3); // row 3, IA3
        put(97, ddq4); // row 4, IA4
        put(112, ddq5); // row 5, IA5
        put(120, ddq6); // row 6, IA6
        [
        t0, w3_z, t2, t3, t8, t10, a2_y, t13,
        t14, t15, t16,
    ]
    };
    // link 3: motion
    let [
        t17, t18, t19, t21, t22, t23, t24, t25,
        t26, t27, t28, t30, t37, a3_y, t39,
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
        put(36, t20); // row 2, ZZ2R
        [
        t17, t18, t19, t21, t22, t23, t24, t25,
        t26, t27, t28, t30, t37, a3_y, t39,
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
        put(76, a4_y); // row 4, MSX4
        put(77, t54); // row 4, MSZ4R
        put(78, dw4_z); // row 4, YY4R
        [t42, w4_y, t54, a4_y, w4_z, t61, t62, dw4_z]
    };
    // link 5: motion
    let [
        t66, t69, t76, t77, t78, t79, t80, t81,
        t82, t83, t84, t85, t86, t87, t88, t89,
        a5_x, a5_y, w5_z, t99, t100, dw5_z,
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
        let a5_x = s5 * t39 - c5 * t54;
        let a5_y = c5 * t39 + s5 * t54;
        let w5_z = w4_y + dq5;
        let t99 = c5 * t61 + s5 * dw4_z + dq5 * t69;
        let t100 = c5 * dw4_z - s5 * t61 - dq5 * t66;
        let dw5_z = ddq5 - t62;
        put(69, t88); // row 3, MSX4
        put(70, t89); // row 3, MSZ4R
        put(80, t87); // row 4, XY4
        put(82, t84); // row 4, YZ4
        put(98, a5_y); // row 5, MSX5
        put(99, a5_x); // row 5, MSZ5R
        put(100, dw5_z); // row 5, YY5R
        [
        t66, t69, t76, t77, t78, t79, t80, t81,
        t82, t83, t84, t85, t86, t87, t88, t89,
        a5_x, a5_y, w5_z, t99, t100, dw5_z,
    ]
    };
    // link 6: motion
    let [
        t104, w6_y, t114, t115, t116, t117, t118, t119,
        t120, t121, t122, t123, t124, t125, t126, t127,
        t132, t136, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ] = {
        let t104 = c6 * t66 - s6 * w5_z;
        let w6_y = c6 * w5_z + s6 * t66;
        let t114 = t66 * t66;
        let t115 = t69 * t69;
        let t116 = w5_z * w5_z;
        let t117 = t66 * t69;
        let t118 = t66 * w5_z;
        let t119 = t69 * w5_z;
        let t120 = t115 + t116;
        let t121 = t117 - dw5_z;
        let t122 = t100 + t118;
        let t123 = dw5_z + t117;
        let t124 = t114 + t116;
        let t125 = t119 - t99;
        let t126 = t118 - t100;
        let t127 = t99 + t119;
        let t131 = D6 * t121 - a5_x;
        let t132 = a5_y + D6 * t124;
        let t133 = a4_y + D6 * t127;
        let t136 = c6 * t131 - s6 * t133;
        let a6_y = c6 * t133 + s6 * t131;
        let w6_z = t69 + dq6;
        let dw6_x = dq6 * w6_y - (c6 * t99 - s6 * dw5_z);
        let dw6_y = c6 * dw5_z + s6 * t99 + dq6 * t104;
        let dw6_z = t100 + ddq6;
        put(101, t117); // row 5, ZZ5R
        put(102, t125); // row 5, XY5
        put(104, t122); // row 5, YZ5
        put(113, a6_y); // row 6, MSX6
        put(114, t136); // row 6, MSY6
        put(116, dw6_z); // row 6, ZZ6
        [
        t104, w6_y, t114, t115, t116, t117, t118, t119,
        t120, t121, t122, t123, t124, t125, t126, t127,
        t132, t136, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ]
    };
    // joint axes in frame 2
    let [t146, v1_2_y] = {
        let t146 = c2 * D2;
        let v1_2_y = s2 * D2;
        [t146, v1_2_y]
    };
    // joint axes in frame 4
    let [t148, t149, t150, t151] = {
        let t148 = s2 * s4;
        let t149 = s2 * c4;
        let t150 = s4 * t146;
        let t151 = c4 * t146;
        [t148, t149, t150, t151]
    };
    // MSX2: column
    let t155 = {
        let t155 = t21 * t146 + t23 * v1_2_y;
        let t156 = t155 - c2 * t8;
        put(1, t156); // row 1, MSX2
        t155
    };
    // MSZ2: column
    let t160 = {
        let t160 = t24 * v1_2_y - t22 * t146;
        let t161 = t160 - s2 * t8;
        put(2, t161); // row 1, MSZ2
        t160
    };
    // YY2: column
    let t162 = {
        let t162 = s2 * t13;
        let t164 = t162 - c2 * t14;
        put(3, t164); // row 1, YY2R
        t162
    };
    // ZZ2: column
    {
        let t166 = c2 * t16 - t162;
        put(4, t166); // row 1, ZZ2R
    }
    // XY2: column
    {
        let t170 = c2 * (t17 - t19) - s2 * t23;
        put(5, t170); // row 1, XY2R
    }
    // XZ2: column
    {
        let t171 = t18 - t17;
        let t174 = s2 * t25 - c2 * t26;
        put(6, t174); // row 1, XZ2R
        put(38, t171); // row 2, XZ2R
    }
    // YZ2: column
    {
        let t178 = s2 * (t18 - t19) + c2 * t22;
        put(7, t178); // row 1, YZ2R
    }
    // M3: column
    {
        let t180 = q3 * a3_y;
        let t185 = s2 * (q3 * t37) + (t39 * v1_2_y - a3_y * t146);
        put(8, t185); // row 1, M3R
        put(40, t180); // row 2, M3R
    }
    // MSX3: column
    {
        let t187 = q3 * t3;
        let t194 = t3 * t146 + t2 * v1_2_y;
        let t195 = c2 * a3_y - s2 * (t39 - q3 * t27) - t194;
        put(9, t195); // row 1, MSX3
        put(41, t187); // row 2, MSX3
    }
    // MSY3: column
    {
        let t198 = t39 - q3 * t21;
        let t202 = t155 - (s2 * (q3 * t25) - c2 * t37);
        put(10, t202); // row 1, MSY3
        put(42, t198); // row 2, MSY3
    }
    // MSZ3: column
    {
        let t204 = t28 + a3_y;
        let t206 = t160 + s2 * (t30 + t37);
        put(11, t206); // row 1, MSZ3R
        put(43, t204); // row 2, MSZ3R
    }
    // MSX4: column
    let [t211, t213, t214] = {
        let t211 = c4 * t85;
        let t212 = s4 * t82 - t211;
        let t213 = s4 * t39;
        let t214 = c4 * t39;
        let t218 = t213 - q3 * t212;
        let t221 = s2 * (q3 * (c4 * t82 + s4 * t85) - t214) + c2 * a4_y;
        let t225 = t221 - (t88 * v1_2_y - t146 * t212);
        put(12, t225); // row 1, MSX4
        put(44, t218); // row 2, MSX4
        [t211, t213, t214]
    };
    // MSZ4: column
    let t229 = {
        let t229 = s4 * t83;
        let t231 = t229 + c4 * t86;
        let t235 = t214 - q3 * t231;
        let t238 = s2 * (t213 + q3 * (c4 * t83 - s4 * t86)) + c2 * t54;
        let t242 = t238 - (t89 * v1_2_y - t146 * t231);
        put(13, t242); // row 1, MSZ4R
        put(45, t235); // row 2, MSZ4R
        t229
    };
    // YY4: column
    let [t243, t248] = {
        let t243 = t81 * t148;
        let t247 = c2 * dw4_z - (t243 + t80 * t149);
        let t248 = c4 * t81;
        let t250 = s4 * t80 - t248;
        put(14, t247); // row 1, YY4R
        put(46, t250); // row 2, YY4R
        [t243, t248]
    };
    // ZZ4: column
    {
        let t254 = t243 + t62 * t149 - c2 * t79;
        let t256 = t248 - s4 * t62;
        put(15, t254); // row 1, ZZ4R
        put(47, t256); // row 2, ZZ4R
    }
    // XY4: column
    {
        let t257 = t78 - t76;
        let t262 = c2 * t87 + (t85 * t148 + t149 * t257);
        let t264 = t211 - s4 * t257;
        put(16, t262); // row 1, XY4
        put(48, t264); // row 2, XY4
    }
    // XZ4: column
    {
        let t265 = t76 - t77;
        let t270 = c2 * t265 + (t88 * t148 - t89 * t149);
        let t273 = c4 * t88 + s4 * t89;
        put(17, t270); // row 1, XZ4
        put(49, t273); // row 2, XZ4
        put(81, t265); // row 4, XZ4
    }
    // YZ4: column
    {
        let t274 = t77 - t78;
        let t279 = c2 * t84 + (t148 * t274 + t83 * t149);
        let t281 = c4 * t274 - t229;
        put(18, t279); // row 1, YZ4
        put(50, t281); // row 2, YZ4
    }
    // MSX5: column
    let [t283, t286, t288, t289] = {
        let t283 = s5 * t123;
        let t284 = c5 * t120 + t283;
        let t286 = c5 * t123;
        let t287 = s5 * t120 - t286;
        let t288 = s5 * a4_y;
        let t289 = c5 * a4_y;
        let t292 = t288 + q3 * t126;
        let t293 = a5_y - q3 * t284;
        let t303 = t150 * t284 + t126 * t151 - v1_2_y * t287;
        let t304 = c2 * t289 - (t148 * t292 + t149 * t293) + t303;
        let t307 = s4 * t293 - c4 * t292;
        put(19, t304); // row 1, MSX5
        put(51, t307); // row 2, MSX5
        put(71, t287); // row 3, MSX5
        put(83, t289); // row 4, MSX5
        put(84, t288); // row 4, MSZ5R
        [t283, t286, t288, t289]
    };
    // MSZ5: column
    let [t308, t311] = {
        let t308 = c5 * t121;
        let t310 = t308 + s5 * t124;
        let t311 = s5 * t121;
        let t313 = t311 - c5 * t124;
        let t316 = t289 + q3 * t127;
        let t317 = a5_x - q3 * t310;
        let t327 = v1_2_y * t313 + (t127 * t151 - t150 * t310);
        let t328 = c2 * t288 + (t148 * t316 - t149 * t317) - t327;
        let t331 = c4 * t316 + s4 * t317;
        put(20, t328); // row 1, MSZ5R
        put(52, t331); // row 2, MSZ5R
        put(72, t313); // row 3, MSZ5R
        [t308, t311]
    };
    // YY5: column
    let [t332, t335] = {
        let t332 = c5 * t119;
        let t334 = t332 + s5 * t118;
        let t335 = s5 * t119;
        let t337 = t335 - c5 * t118;
        let t342 = c2 * t337 + (t148 * t334 - dw5_z * t149);
        let t345 = c4 * t334 + s4 * dw5_z;
        put(21, t342); // row 1, YY5R
        put(53, t345); // row 2, YY5R
        put(85, t337); // row 4, YY5R
        [t332, t335]
    };
    // ZZ5: column
    {
        let t347 = t332 + s5 * t100;
        let t349 = c5 * t100 - t335;
        let t354 = c2 * t349 - (t148 * t347 + t117 * t149);
        let t357 = s4 * t117 - c4 * t347;
        put(22, t354); // row 1, ZZ5R
        put(54, t357); // row 2, ZZ5R
        put(86, t349); // row 4, ZZ5R
    }
    // XY5: column
    {
        let t358 = t114 - t116;
        let t360 = t286 + s5 * t358;
        let t362 = c5 * t358 - t283;
        let t367 = c2 * t362 - (t148 * t360 + t125 * t149);
        let t370 = s4 * t125 - c4 * t360;
        put(23, t367); // row 1, XY5
        put(55, t370); // row 2, XY5
        put(87, t362); // row 4, XY5
    }
    // XZ5: column
    {
        let t371 = t115 - t114;
        let t374 = c5 * t126 + s5 * t127;
        let t377 = s5 * t126 - c5 * t127;
        let t382 = c2 * t377 + (t148 * t374 - t149 * t371);
        let t385 = c4 * t374 + s4 * t371;
        put(24, t382); // row 1, XZ5
        put(56, t385); // row 2, XZ5
        put(88, t377); // row 4, XZ5
        put(103, t371); // row 5, XZ5
    }
    // YZ5: column
    {
        let t386 = t115 - t116;
        let t388 = t311 + c5 * t386;
        let t390 = s5 * t386 - t308;
        let t395 = c2 * t390 - (t122 * t149 - t148 * t388);
        let t398 = c4 * t388 + s4 * t122;
        put(25, t395); // row 1, YZ5
        put(57, t398); // row 2, YZ5
        put(89, t390); // row 4, YZ5
    }
    // MSX6: column
    let [
        t399, t400, t401, t402, t403, t404, t406, t407,
        t409, t410, t411, t412, t414, t417, t419, t420,
    ] = {
        let t399 = t104 * t104;
        let t400 = w6_y * w6_y;
        let t401 = w6_z * w6_z;
        let t402 = t104 * w6_y;
        let t403 = t104 * w6_z;
        let t404 = w6_y * w6_z;
        let t405 = t400 + t401;
        let t406 = dw6_z + t402;
        let t407 = dw6_y - t403;
        let t408 = dw6_z - t402;
        let t409 = t399 + t401;
        let t410 = dw6_x - t404;
        let t411 = dw6_y + t403;
        let t412 = dw6_x + t404;
        let t414 = s6 * t408;
        let t415 = c6 * t405 + t414;
        let t417 = c6 * t408;
        let t418 = t417 - s6 * t405;
        let t419 = s6 * t132;
        let t420 = c6 * t132;
        let t423 = t419 + D6 * t418;
        let t424 = t420 - D6 * t415;
        let t427 = c5 * t415 + s5 * t411;
        let t430 = s5 * t415 - c5 * t411;
        let t436 = s5 * t423 + c5 * a6_y;
        let t439 = c5 * t423 - s5 * a6_y + q3 * t418;
        let t440 = t424 - q3 * t427;
        let t450 = v1_2_y * t430 + (t151 * t418 - t150 * t427);
        let t451 = c2 * t436 + (t148 * t439 - t149 * t440) - t450;
        let t454 = c4 * t439 + s4 * t440;
        put(26, t451); // row 1, MSX6
        put(58, t454); // row 2, MSX6
        put(73, t430); // row 3, MSX6
        put(90, t436); // row 4, MSX6
        put(105, t424); // row 5, MSX6
        put(115, t402); // row 6, XX6R
        put(118, t410); // row 6, XZ6
        put(119, t407); // row 6, YZ6
        [
        t399, t400, t401, t402, t403, t404, t406, t407,
        t409, t410, t411, t412, t414, t417, t419, t420,
    ]
    };
    // MSY6: column
    let [t455, t458] = {
        let t455 = c6 * t406;
        let t457 = s6 * t409 - t455;
        let t458 = s6 * t406;
        let t460 = t458 + c6 * t409;
        let t463 = t420 - D6 * t460;
        let t464 = D6 * t457 - t419;
        let t467 = c5 * t457 + s5 * t412;
        let t470 = c5 * t412 - s5 * t457;
        let t476 = s5 * t463 + c5 * t136;
        let t479 = s5 * t136 - c5 * t463 + q3 * t460;
        let t480 = t464 + q3 * t467;
        let t490 = t151 * t460 - t150 * t467 - v1_2_y * t470;
        let t491 = c2 * t476 - (t148 * t479 + t149 * t480) + t490;
        let t494 = s4 * t480 - c4 * t479;
        put(27, t491); // row 1, MSY6
        put(59, t494); // row 2, MSY6
        put(74, t470); // row 3, MSY6
        put(91, t476); // row 4, MSY6
        put(106, t464); // row 5, MSY6
        [t455, t458]
    };
    // XX6: column
    let [t496, t499] = {
        let t496 = s6 * t403;
        let t497 = c6 * dw6_x + t496;
        let t499 = c6 * t403;
        let t500 = s6 * dw6_x - t499;
        let t503 = c5 * t497 + s5 * t402;
        let t506 = c5 * t402 - s5 * t497;
        let t511 = c2 * t506 - (t148 * t503 + t149 * t500);
        let t514 = s4 * t500 - c4 * t503;
        put(28, t511); // row 1, XX6R
        put(60, t514); // row 2, XX6R
        put(92, t506); // row 4, XX6R
        put(107, t500); // row 5, XX6R
        [t496, t499]
    };
    // ZZ6: column
    {
        let t516 = t496 - c6 * t404;
        let t518 = t499 + s6 * t404;
        let t521 = s5 * dw6_z - c5 * t516;
        let t524 = s5 * t516 + c5 * dw6_z;
        let t529 = c2 * t524 - (t148 * t521 + t149 * t518);
        let t532 = s4 * t518 - c4 * t521;
        put(29, t529); // row 1, ZZ6
        put(61, t532); // row 2, ZZ6
        put(93, t524); // row 4, ZZ6
        put(108, t518); // row 5, ZZ6
    }
    // XY6: column
    {
        let t533 = t399 - t400;
        let t536 = s6 * t412 - c6 * t411;
        let t539 = s6 * t411 + c6 * t412;
        let t542 = c5 * t536 - s5 * t533;
        let t545 = s5 * t536 + c5 * t533;
        let t550 = c2 * t545 + (t148 * t542 - t149 * t539);
        let t553 = c4 * t542 + s4 * t539;
        put(30, t550); // row 1, XY6
        put(62, t553); // row 2, XY6
        put(94, t545); // row 4, XY6
        put(109, t539); // row 5, XY6
        put(117, t533); // row 6, XY6
    }
    // XZ6: column
    {
        let t554 = t401 - t399;
        let t556 = s6 * t554 - t417;
        let t558 = t414 + c6 * t554;
        let t561 = c5 * t556 - s5 * t410;
        let t564 = s5 * t556 + c5 * t410;
        let t569 = c2 * t564 + (t148 * t561 - t149 * t558);
        let t572 = c4 * t561 + s4 * t558;
        put(31, t569); // row 1, XZ6
        put(63, t572); // row 2, XZ6
        put(95, t564); // row 4, XZ6
        put(110, t558); // row 5, XZ6
    }
    // YZ6: column
    {
        let t573 = t400 - t401;
        let t575 = t458 - c6 * t573;
        let t577 = t455 + s6 * t573;
        let t580 = c5 * t575 - s5 * t407;
        let t583 = s5 * t575 + c5 * t407;
        let t588 = c2 * t583 + (t148 * t580 - t149 * t577);
        let t591 = c4 * t580 + s4 * t577;
        let t592 = -t10;
        let t593 = -t2;
        let t594 = -t39;
        let t595 = -t23;
        let t596 = -t24;
        let t597 = -t79;
        put(32, t588); // row 1, YZ6
        put(34, t592); // row 2, MSZ2
        put(37, t593); // row 2, XY2R
        put(64, t591); // row 2, YZ6
        put(65, t594); // row 3, M3R
        put(67, t595); // row 3, MSY3
        put(68, t596); // row 3, MSZ3R
        put(79, t597); // row 4, ZZ4R
        put(96, t583); // row 4, YZ6
        put(111, t577); // row 5, YZ6
    }
}
