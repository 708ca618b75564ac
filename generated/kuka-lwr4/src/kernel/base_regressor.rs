//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4.
//!
//! 612 multiplications, 433 additions; 7 x 57, 202 of 399 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

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

/// Regressor `W_b` of the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 57]; 7]) {
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
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6, ddq7] = *ddq;
    let L2 = S::constant(0.4);
    let L3 = S::constant(0.39);
    let k0 = S::constant(9.81);
    // link 2: motion
    let [w2_x, w2_y, a2_x, a2_y, t6, t7, dw2_x, t9] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t2 = s2 * ddq1;
        let t3 = c2 * ddq1;
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let t6 = dq2 * w2_y;
        let t7 = dq2 * w2_x;
        let dw2_x = t2 + t6;
        let t9 = t7 - t3;
        put(0, ddq1); // row 1, ZZ1R
        put(41, dq1); // row 1, FV1
        put(43, a2_y); // row 2, MSX2
        put(46, ddq2); // row 2, ZZ2R
        put(48, t2); // row 2, XZ2
        put(49, t3); // row 2, YZ2
        put(85, dq2); // row 2, FV2
        put(122, dq3); // row 3, FV3
        put(152, dq4); // row 4, FV4
        put(175, dq5); // row 5, FV5
        put(191, dq6); // row 6, FV6
        put(200, dq7); // row 7, FV7
        [w2_x, w2_y, a2_x, a2_y, t6, t7, dw2_x, t9]
    };
    // link 3: motion
    let [
        w3_x, t15, t22, t23, t24, t25, t26, t27,
        t29, t30, t31, t32, t37, t40, t43, w3_z,
        t47, t48, dw3_z,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t15 = c3 * dq2 + s3 * w2_x;
        let t22 = w2_x * w2_x;
        let t23 = w2_y * w2_y;
        let t24 = dq2 * dq2;
        let t25 = w2_x * w2_y;
        let t26 = ddq2 - t25;
        let t27 = ddq2 + t25;
        let t29 = t7 + t9;
        let t30 = t6 + dw2_x;
        let t31 = c3 * a2_x;
        let t32 = s3 * a2_x;
        let t35 = L2 * t30;
        let t36 = L2 * t26 - a2_x;
        let t37 = L2 * (t22 + t24) - a2_y;
        let t40 = c3 * t36 + s3 * t35;
        let t43 = c3 * t35 - s3 * t36;
        let w3_z = w2_y + dq3;
        let t47 = s3 * ddq2 - c3 * dw2_x + dq3 * t15;
        let t48 = c3 * ddq2 + s3 * dw2_x + dq3 * w3_x;
        let dw3_z = ddq3 - t9;
        put(90, dw3_z); // row 3, ZZ3R
        [
        w3_x, t15, t22, t23, t24, t25, t26, t27,
        t29, t30, t31, t32, t37, t40, t43, w3_z,
        t47, t48, dw3_z,
    ]
    };
    // link 4: motion
    let [
        w4_x, t55, t62, t63, t64, t65, t66, t67,
        t68, t69, t70, t71, t72, t73, t76, a4_y,
        w4_z, t83, t84, dw4_z,
    ] = {
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t55 = c4 * w3_z + s4 * w3_x;
        let t62 = w3_x * w3_x;
        let t63 = t15 * t15;
        let t64 = w3_z * w3_z;
        let t65 = w3_x * t15;
        let t66 = w3_x * w3_z;
        let t67 = t15 * w3_z;
        let t68 = dw3_z + t65;
        let t69 = t66 - t48;
        let t70 = dw3_z - t65;
        let t71 = t47 - t67;
        let t72 = t48 + t66;
        let t73 = t47 + t67;
        let t76 = c4 * t40 - s4 * t37;
        let a4_y = c4 * t37 + s4 * t40;
        let w4_z = dq4 - t15;
        let t83 = c4 * t47 + s4 * dw3_z + dq4 * t55;
        let t84 = c4 * dw3_z - s4 * t47 + dq4 * w4_x;
        let dw4_z = ddq4 - t48;
        put(89, t65); // row 3, XX3R
        put(93, t69); // row 3, YZ3
        put(124, a4_y); // row 4, MSX4
        put(125, t76); // row 4, MSY4R
        put(127, dw4_z); // row 4, ZZ4R
        [
        w4_x, t55, t62, t63, t64, t65, t66, t67,
        t68, t69, t70, t71, t72, t73, t76, a4_y,
        w4_z, t83, t84, dw4_z,
    ]
    };
    // link 5: motion
    let [
        w5_x, t91, t98, t99, t100, t101, t102, t103,
        t104, t105, t106, t107, t108, t109, t110, t111,
        t116, t120, a5_y, w5_z, t127, dw5_y, dw5_z,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let t91 = s5 * w4_x - c5 * w4_z;
        let t98 = w4_x * w4_x;
        let t99 = t55 * t55;
        let t100 = w4_z * w4_z;
        let t101 = w4_x * t55;
        let t102 = w4_x * w4_z;
        let t103 = t55 * w4_z;
        let t104 = t99 + t100;
        let t105 = dw4_z + t101;
        let t106 = t102 - t84;
        let t107 = t101 - dw4_z;
        let t108 = t98 + t100;
        let t109 = t103 - t83;
        let t110 = t84 + t102;
        let t111 = t83 + t103;
        let t115 = t76 - L3 * t105;
        let t116 = a4_y + L3 * t108;
        let t117 = L3 * t111 - t43;
        let t120 = c5 * t115 - s5 * t117;
        let a5_y = c5 * t117 + s5 * t115;
        let w5_z = t55 + dq5;
        let t127 = c5 * t83 - s5 * dw4_z + dq5 * t91;
        let dw5_y = c5 * dw4_z + s5 * t83 - dq5 * w5_x;
        let dw5_z = t84 + ddq5;
        put(126, t101); // row 4, XX4R
        put(129, t109); // row 4, XZ4
        put(130, t106); // row 4, YZ4
        put(154, a5_y); // row 5, MSX5
        put(155, t120); // row 5, MSY5R
        put(157, dw5_z); // row 5, ZZ5R
        [
        w5_x, t91, t98, t99, t100, t101, t102, t103,
        t104, t105, t106, t107, t108, t109, t110, t111,
        t116, t120, a5_y, w5_z, t127, dw5_y, dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t142, t143, t144, t145, t146, t147,
        t148, t149, t150, t151, t152, t153, t154, t155,
        t158, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t142 = w5_x * w5_x;
        let t143 = t91 * t91;
        let t144 = w5_z * w5_z;
        let t145 = w5_x * t91;
        let t146 = w5_x * w5_z;
        let t147 = t91 * w5_z;
        let t148 = t143 + t144;
        let t149 = dw5_z + t145;
        let t150 = dw5_y + t146;
        let t151 = t145 - dw5_z;
        let t152 = t142 + t144;
        let t153 = t147 - t127;
        let t154 = dw5_y - t146;
        let t155 = t127 + t147;
        let t158 = c6 * t120 + s6 * t116;
        let a6_y = s6 * t120 - c6 * t116;
        let w6_z = t91 + dq6;
        let dw6_x = s6 * dw5_z - c6 * t127 + dq6 * w6_y;
        let dw6_y = c6 * dw5_z + s6 * t127 - dq6 * w6_x;
        let dw6_z = ddq6 - dw5_y;
        put(156, t145); // row 5, XX5R
        put(159, t153); // row 5, XZ5
        put(160, t150); // row 5, YZ5
        put(177, a6_y); // row 6, MSX6
        put(178, t158); // row 6, MSY6R
        put(180, dw6_z); // row 6, ZZ6R
        [
        w6_x, w6_y, t142, t143, t144, t145, t146, t147,
        t148, t149, t150, t151, t152, t153, t154, t155,
        t158, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ]
    };
    // link 7: motion
    let [
        w7_x, t173, t180, t181, t182, t183, t184, t185,
        t186, t187, t188, t189, t190, t191, t192, t193,
        t196, a7_y, w7_z, dw7_x, t204, dw7_z,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t173 = c7 * w6_z + s7 * w6_x;
        let t180 = w6_x * w6_x;
        let t181 = w6_y * w6_y;
        let t182 = w6_z * w6_z;
        let t183 = w6_x * w6_y;
        let t184 = w6_x * w6_z;
        let t185 = w6_y * w6_z;
        let t186 = t181 + t182;
        let t187 = dw6_z - t183;
        let t188 = dw6_y + t184;
        let t189 = dw6_z + t183;
        let t190 = t180 + t182;
        let t191 = dw6_x - t185;
        let t192 = dw6_y - t184;
        let t193 = dw6_x + t185;
        let t196 = c7 * t158 - s7 * a5_y;
        let a7_y = c7 * a5_y + s7 * t158;
        let w7_z = w6_y + dq7;
        let dw7_x = c7 * dw6_x - s7 * dw6_z - dq7 * t173;
        let t204 = c7 * dw6_z + s7 * dw6_x + dq7 * w7_x;
        let dw7_z = dw6_y + ddq7;
        put(182, t191); // row 6, XZ6
        put(183, t188); // row 6, YZ6
        put(193, a7_y); // row 7, MSX7
        put(194, t196); // row 7, MSY7
        put(196, dw7_z); // row 7, ZZ7
        [
        w7_x, t173, t180, t181, t182, t183, t184, t185,
        t186, t187, t188, t189, t190, t191, t192, t193,
        t196, a7_y, w7_z, dw7_x, t204, dw7_z,
    ]
    };
    // joint axes in frame 3
    let [z1_3_x, t207] = {
        let z1_3_x = s2 * c3;
        let t207 = s2 * s3;
        [z1_3_x, t207]
    };
    // joint axes in frame 4
    let [t210, z1_5_z, t214, z2_4_y] = {
        let t210 = c2 * s4 - c4 * z1_3_x;
        let z1_5_z = c2 * c4 + s4 * z1_3_x;
        let t214 = s3 * c4;
        let z2_4_y = s3 * s4;
        [t210, z1_5_z, t214, z2_4_y]
    };
    // joint axes in frame 5
    let [t218, z1_6_z, t224, t227, t228, z3_5_y] = {
        let t218 = c5 * t210 + s5 * t207;
        let z1_6_z = c5 * t207 - s5 * t210;
        let t224 = c5 * t214 + c3 * s5;
        let t227 = c3 * c5 - s5 * t214;
        let t228 = s4 * c5;
        let z3_5_y = s4 * s5;
        [t218, z1_6_z, t224, t227, t228, z3_5_y]
    };
    // XX2: column
    let t231 = {
        let t231 = c2 * t7;
        let t232 = s2 * dw2_x + t231;
        put(1, t232); // row 1, XX2R
        t231
    };
    // ZZ2: column
    {
        let t234 = s2 * t6 - t231;
        put(2, t234); // row 1, ZZ2R
    }
    // XY2: column
    {
        let t235 = t22 - t23;
        let t238 = c2 * t30 - s2 * t29;
        put(3, t238); // row 1, XY2
        put(47, t235); // row 2, XY2
    }
    // XZ2: column
    {
        let t242 = s2 * t27 + c2 * (t24 - t22);
        put(4, t242); // row 1, XZ2
    }
    // YZ2: column
    {
        let t246 = s2 * (t23 - t24) + c2 * t26;
        put(5, t246); // row 1, YZ2
    }
    // MSX3: column
    let [t249, t250] = {
        let t249 = a2_y * t207 - c2 * t32;
        let t250 = c3 * a2_y;
        [t249, t250]
    };
    // XZ3: column
    {
        let t251 = t62 - t64;
        let t256 = t70 * z1_3_x + t207 * t251 - c2 * t71;
        let t259 = c3 * t251 - s3 * t70;
        let t261 = t249 - L2 * t256;
        let t263 = t250 - L2 * t259;
        let t265 = L2 * t71 - t32;
        put(6, t261); // row 1, MSX3
        put(11, t256); // row 1, XZ3
        put(50, t263); // row 2, MSX3
        put(55, t259); // row 2, XZ3
        put(87, t265); // row 3, MSX3
    }
    // MSY3: column
    let [t268, t269] = {
        let t268 = a2_y * z1_3_x - c2 * t31;
        let t269 = s3 * a2_y;
        [t268, t269]
    };
    // YZ3: column
    let [t278, t284] = {
        let t270 = t64 - t63;
        let t275 = c2 * t69 - (z1_3_x * t270 + t68 * t207);
        let t278 = c3 * t68 - s3 * t270;
        let t280 = t268 - L2 * t275;
        let t282 = L2 * t278 - t269;
        let t284 = t31 + L2 * t69;
        put(7, t280); // row 1, MSY3R
        put(12, t275); // row 1, YZ3
        put(51, t282); // row 2, MSY3R
        [t278, t284]
    };
    // XX3: column
    let [t286, t291] = {
        let t286 = t66 * t207;
        let t289 = c2 * t65 - (t47 * z1_3_x + t286);
        let t291 = c3 * t66;
        let t292 = s3 * t47 - t291;
        put(8, t289); // row 1, XX3R
        put(52, t292); // row 2, XX3R
        [t286, t291]
    };
    // ZZ3: column
    {
        let t296 = c2 * dw3_z + (t286 - t67 * z1_3_x);
        let t298 = t291 + s3 * t67;
        put(9, t296); // row 1, ZZ3R
        put(53, t298); // row 2, ZZ3R
    }
    // XY3: column
    {
        let t299 = t62 - t63;
        let t304 = c2 * t299 + (t73 * t207 - t72 * z1_3_x);
        let t307 = s3 * t72 + c3 * t73;
        put(10, t304); // row 1, XY3
        put(54, t307); // row 2, XY3
        put(91, t299); // row 3, XY3
    }
    // MSX4: column
    let [t309, t311, t312] = {
        let t309 = s4 * t107;
        let t311 = s4 * t43;
        let t312 = c4 * t43;
        let t315 = t311 + L2 * t110;
        let t316 = L2 * (c4 * t104 - t309) - a4_y;
        let t321 = t207 * t316 - z1_3_x * t315 - c2 * t312;
        let t324 = s3 * t315 + c3 * t316;
        put(13, t321); // row 1, MSX4
        put(57, t324); // row 2, MSX4
        put(95, t311); // row 3, MSY4R
        [t309, t311, t312]
    };
    // MSY4: column
    let t325 = {
        let t325 = c4 * t105;
        let t330 = t312 - L2 * t111;
        let t331 = L2 * (t325 - s4 * t108) - t76;
        let t336 = c2 * t311 + (t207 * t331 - z1_3_x * t330);
        let t339 = s3 * t330 + c3 * t331;
        put(14, t336); // row 1, MSY4R
        put(58, t339); // row 2, MSY4R
        t325
    };
    // XX4: column
    let [t341, t346, t351] = {
        let t341 = t102 * z1_5_z;
        let t344 = t83 * t210 - t341 - t101 * t207;
        let t346 = t102 * z2_4_y;
        let t349 = t83 * t214 + t346 - c3 * t101;
        let t351 = c4 * t102;
        let t352 = s4 * t83 - t351;
        put(15, t344); // row 1, XX4R
        put(59, t349); // row 2, XX4R
        put(96, t352); // row 3, XX4R
        [t341, t346, t351]
    };
    // ZZ4: column
    {
        let t356 = t341 + t103 * t210 - dw4_z * t207;
        let t360 = t103 * t214 - t346 - c3 * dw4_z;
        let t362 = t351 + s4 * t103;
        put(16, t356); // row 1, ZZ4R
        put(60, t360); // row 2, ZZ4R
        put(97, t362); // row 3, ZZ4R
    }
    // XY4: column
    {
        let t363 = t98 - t99;
        let t368 = t110 * t210 + t111 * z1_5_z - t207 * t363;
        let t373 = t110 * t214 - t111 * z2_4_y - c3 * t363;
        let t376 = s4 * t110 + c4 * t111;
        put(17, t368); // row 1, XY4
        put(61, t373); // row 2, XY4
        put(98, t376); // row 3, XY4
        put(128, t363); // row 4, XY4
    }
    // XZ4: column
    {
        let t377 = t100 - t98;
        let t382 = t107 * t210 - z1_5_z * t377 - t109 * t207;
        let t387 = t107 * t214 + z2_4_y * t377 - c3 * t109;
        let t389 = t309 - c4 * t377;
        put(18, t382); // row 1, XZ4
        put(62, t387); // row 2, XZ4
        put(99, t389); // row 3, XZ4
    }
    // YZ4: column
    {
        let t390 = t100 - t99;
        let t395 = t210 * t390 - t105 * z1_5_z - t106 * t207;
        let t400 = t214 * t390 + t105 * z2_4_y - c3 * t106;
        let t402 = s4 * t390 - t325;
        put(19, t395); // row 1, YZ4
        put(63, t400); // row 2, YZ4
        put(100, t402); // row 3, YZ4
    }
    // MSX5: column
    let [t404, t409, t410] = {
        let t404 = s5 * t151;
        let t405 = c5 * t148 - t404;
        let t408 = s5 * t148 + c5 * t151;
        let t409 = s5 * t116;
        let t410 = c5 * t116;
        let t413 = t409 - L3 * t408;
        let t414 = t410 - L3 * t405;
        let t423 = s4 * t413 + c4 * a5_y;
        let t426 = s4 * a5_y - c4 * t413 + L2 * t408;
        let t427 = L2 * (c4 * t405 + s4 * t154) - t414;
        let t432 = c2 * t423 + (z1_3_x * t426 + t207 * t427);
        let t435 = c3 * t427 - s3 * t426;
        put(20, t432); // row 1, MSX5
        put(64, t435); // row 2, MSX5
        put(101, t423); // row 3, MSX5
        put(131, t414); // row 4, MSX5
        [t404, t409, t410]
    };
    // MSY5: column
    let t436 = {
        let t436 = c5 * t149;
        let t438 = s5 * t152 - t436;
        let t441 = s5 * t149 + c5 * t152;
        let t444 = t410 - L3 * t441;
        let t445 = L3 * t438 - t409;
        let t454 = s4 * t444 + c4 * t120;
        let t457 = s4 * t120 - c4 * t444 + L2 * t441;
        let t458 = L2 * (s4 * t155 - c4 * t438) - t445;
        let t463 = c2 * t454 + (z1_3_x * t457 + t207 * t458);
        let t466 = c3 * t458 - s3 * t457;
        put(21, t463); // row 1, MSY5R
        put(65, t466); // row 2, MSY5R
        put(102, t454); // row 3, MSY5R
        put(132, t445); // row 4, MSY5R
        t436
    };
    // XX5: column
    let [t468, t473, t478, t483] = {
        let t468 = t146 * z1_6_z;
        let t471 = t145 * z1_5_z - (t468 - t127 * t218);
        let t473 = t146 * t227;
        let t476 = t127 * t224 - t473 - t145 * z2_4_y;
        let t478 = t146 * z3_5_y;
        let t481 = c4 * t145 + (t127 * t228 + t478);
        let t483 = c5 * t146;
        let t484 = t483 - s5 * t127;
        put(22, t471); // row 1, XX5R
        put(66, t476); // row 2, XX5R
        put(103, t481); // row 3, XX5R
        put(133, t484); // row 4, XX5R
        [t468, t473, t478, t483]
    };
    // ZZ5: column
    let t498 = {
        let t488 = dw5_z * z1_5_z + (t468 + t147 * t218);
        let t492 = t473 + t147 * t224 - dw5_z * z2_4_y;
        let t496 = c4 * dw5_z + (t147 * t228 - t478);
        let t498 = t483 + s5 * t147;
        put(23, t488); // row 1, ZZ5R
        put(67, t492); // row 2, ZZ5R
        put(104, t496); // row 3, ZZ5R
        t498
    };
    // XY5: column
    {
        let t499 = t142 - t143;
        let t504 = z1_5_z * t499 + (t155 * z1_6_z - t154 * t218);
        let t509 = t155 * t227 - t154 * t224 - z2_4_y * t499;
        let t514 = c4 * t499 - (t154 * t228 + t155 * z3_5_y);
        let t517 = s5 * t154 - c5 * t155;
        put(24, t504); // row 1, XY5
        put(68, t509); // row 2, XY5
        put(105, t514); // row 3, XY5
        put(135, t517); // row 4, XY5
        put(158, t499); // row 5, XY5
    }
    // XZ5: column
    {
        let t518 = t144 - t142;
        let t523 = t153 * z1_5_z + (t151 * t218 - z1_6_z * t518);
        let t528 = t151 * t224 - t227 * t518 - t153 * z2_4_y;
        let t533 = c4 * t153 + (t151 * t228 + z3_5_y * t518);
        let t535 = c5 * t518 - t404;
        put(25, t523); // row 1, XZ5
        put(69, t528); // row 2, XZ5
        put(106, t533); // row 3, XZ5
        put(136, t535); // row 4, XZ5
    }
    // YZ5: column
    {
        let t536 = t144 - t143;
        let t541 = t150 * z1_5_z + (t218 * t536 - t149 * z1_6_z);
        let t546 = t224 * t536 - t149 * t227 - t150 * z2_4_y;
        let t551 = c4 * t150 + (t228 * t536 + t149 * z3_5_y);
        let t553 = t436 - s5 * t536;
        put(26, t541); // row 1, YZ5
        put(70, t546); // row 2, YZ5
        put(107, t551); // row 3, YZ5
        put(137, t553); // row 4, YZ5
    }
    // MSX6: column
    let [t555, t558, t560, t561, t577] = {
        let t555 = s6 * t189;
        let t556 = c6 * t186 + t555;
        let t558 = c6 * t189;
        let t560 = s6 * a5_y;
        let t561 = c6 * a5_y;
        let t564 = c5 * t556 + s5 * t192;
        let t567 = c5 * t192 - s5 * t556;
        let t576 = c5 * t560 - s5 * a6_y + L3 * t567;
        let t577 = s5 * t560 + c5 * a6_y + L3 * t564;
        let t586 = s4 * t576 + c4 * t561;
        let t589 = L2 * t567 - (s4 * t561 - c4 * t576);
        let t590 = t577 + L2 * (c4 * t564 - s4 * (t558 - s6 * t186));
        let t595 = c2 * t586 - (z1_3_x * t589 - t207 * t590);
        let t598 = s3 * t589 + c3 * t590;
        put(27, t595); // row 1, MSX6
        put(71, t598); // row 2, MSX6
        put(108, t586); // row 3, MSX6
        put(161, t561); // row 5, MSX6
        [t555, t558, t560, t561, t577]
    };
    // MSY6: column
    let [t599, t602] = {
        let t599 = c6 * t187;
        let t601 = t599 - s6 * t190;
        let t602 = s6 * t187;
        let t607 = s5 * t193 - c5 * t601;
        let t610 = s5 * t601 + c5 * t193;
        let t619 = c5 * t561 - s5 * t158 - L3 * t610;
        let t620 = L3 * t607 - (s5 * t561 + c5 * t158);
        let t629 = s4 * t619 - c4 * t560;
        let t632 = c4 * t619 + s4 * t560 - L2 * t610;
        let t633 = t620 - L2 * (s4 * (t602 + c6 * t190) - c4 * t607);
        let t638 = c2 * t629 - (z1_3_x * t632 + t207 * t633);
        let t641 = s3 * t632 - c3 * t633;
        put(28, t638); // row 1, MSY6R
        put(72, t641); // row 2, MSY6R
        put(109, t629); // row 3, MSY6R
        put(139, t620); // row 4, MSY6R
        [t599, t602]
    };
    // XX6: column
    let [t643, t646] = {
        let t643 = s6 * t184;
        let t644 = t643 - c6 * dw6_x;
        let t646 = c6 * t184;
        let t647 = s6 * dw6_x + t646;
        let t652 = z1_5_z * t647 + (t218 * t644 - t183 * z1_6_z);
        let t657 = t224 * t644 - t183 * t227 - z2_4_y * t647;
        let t662 = c4 * t647 + (t228 * t644 + t183 * z3_5_y);
        let t665 = c5 * t183 - s5 * t644;
        put(29, t652); // row 1, XX6R
        put(73, t657); // row 2, XX6R
        put(110, t662); // row 3, XX6R
        put(140, t665); // row 4, XX6R
        put(163, t647); // row 5, XX6R
        [t643, t646]
    };
    // ZZ6: column
    {
        let t667 = t643 + c6 * t185;
        let t669 = s6 * t185 - t646;
        let t674 = z1_5_z * t669 + (dw6_z * z1_6_z - t218 * t667);
        let t679 = dw6_z * t227 - t224 * t667 - z2_4_y * t669;
        let t684 = c4 * t669 - (t228 * t667 + dw6_z * z3_5_y);
        let t687 = s5 * t667 - c5 * dw6_z;
        put(30, t674); // row 1, ZZ6R
        put(74, t679); // row 2, ZZ6R
        put(111, t684); // row 3, ZZ6R
        put(141, t687); // row 4, ZZ6R
        put(164, t669); // row 5, ZZ6R
    }
    // XY6: column
    {
        let t688 = t180 - t181;
        let t691 = c6 * t192 - s6 * t193;
        let t694 = s6 * t192 + c6 * t193;
        let t699 = z1_5_z * t694 + (z1_6_z * t688 - t218 * t691);
        let t704 = t227 * t688 - t224 * t691 - z2_4_y * t694;
        let t709 = c4 * t694 - (t228 * t691 + z3_5_y * t688);
        let t712 = s5 * t691 - c5 * t688;
        put(31, t699); // row 1, XY6
        put(75, t704); // row 2, XY6
        put(112, t709); // row 3, XY6
        put(142, t712); // row 4, XY6
        put(165, t694); // row 5, XY6
        put(181, t688); // row 6, XY6
    }
    // XZ6: column
    {
        let t713 = t182 - t180;
        let t715 = t558 - s6 * t713;
        let t717 = t555 + c6 * t713;
        let t722 = z1_5_z * t717 + (t191 * z1_6_z - t218 * t715);
        let t727 = t191 * t227 - t224 * t715 - z2_4_y * t717;
        let t732 = c4 * t717 - (t228 * t715 + t191 * z3_5_y);
        let t735 = s5 * t715 - c5 * t191;
        put(32, t722); // row 1, XZ6
        put(76, t727); // row 2, XZ6
        put(113, t732); // row 3, XZ6
        put(143, t735); // row 4, XZ6
        put(166, t717); // row 5, XZ6
    }
    // YZ6: column
    {
        let t736 = t181 - t182;
        let t738 = c6 * t736 - t602;
        let t740 = t599 + s6 * t736;
        let t745 = z1_5_z * t740 + (t188 * z1_6_z - t218 * t738);
        let t750 = t188 * t227 - t224 * t738 - z2_4_y * t740;
        let t755 = c4 * t740 - (t228 * t738 + t188 * z3_5_y);
        let t758 = s5 * t738 - c5 * t188;
        put(33, t745); // row 1, YZ6
        put(77, t750); // row 2, YZ6
        put(114, t755); // row 3, YZ6
        put(144, t758); // row 4, YZ6
        put(167, t740); // row 5, YZ6
    }
    // MSX7: column
    let [
        t759, t760, t761, t762, t763, t764, t766, t767,
        t769, t770, t771, t772, t774, t777, t779, t780,
    ] = {
        let t759 = w7_x * w7_x;
        let t760 = t173 * t173;
        let t761 = w7_z * w7_z;
        let t762 = w7_x * t173;
        let t763 = w7_x * w7_z;
        let t764 = t173 * w7_z;
        let t765 = t760 + t761;
        let t766 = dw7_z + t762;
        let t767 = t763 - t204;
        let t768 = t762 - dw7_z;
        let t769 = t759 + t761;
        let t770 = dw7_x + t764;
        let t771 = t204 + t763;
        let t772 = t764 - dw7_x;
        let t774 = s7 * t768;
        let t775 = c7 * t765 - t774;
        let t777 = c7 * t768;
        let t778 = s7 * t765 + t777;
        let t779 = s7 * a6_y;
        let t780 = c7 * a6_y;
        let t783 = c6 * t775 + s6 * t771;
        let t789 = c6 * t779 - s6 * a7_y;
        let t792 = s6 * t779 + c6 * a7_y;
        let t795 = c5 * t783 - s5 * t778;
        let t798 = s5 * t783 + c5 * t778;
        let t807 = c5 * t789 + s5 * t780 + L3 * t798;
        let t808 = s5 * t789 - c5 * t780 - L3 * t795;
        let t817 = c4 * t792 - s4 * t807;
        let t820 = c4 * t807 + s4 * t792 + L2 * t798;
        let t821 = L2 * (c4 * t795 + s4 * (s6 * t775 - c6 * t771)) - t808;
        let t826 = c2 * t817 + (z1_3_x * t820 + t207 * t821);
        let t829 = c3 * t821 - s3 * t820;
        put(34, t826); // row 1, MSX7
        put(78, t829); // row 2, MSX7
        put(115, t817); // row 3, MSX7
        put(145, t808); // row 4, MSX7
        put(168, t792); // row 5, MSX7
        put(184, t780); // row 6, MSX7
        put(195, t762); // row 7, XX7R
        put(198, t770); // row 7, XZ7
        put(199, t767); // row 7, YZ7
        [
        t759, t760, t761, t762, t763, t764, t766, t767,
        t769, t770, t771, t772, t774, t777, t779, t780,
    ]
    };
    // MSY7: column
    let [t830, t833] = {
        let t830 = c7 * t766;
        let t832 = s7 * t769 - t830;
        let t833 = s7 * t766;
        let t835 = t833 + c7 * t769;
        let t838 = c6 * t832 + s6 * t772;
        let t844 = c6 * t780 - s6 * t196;
        let t847 = s6 * t780 + c6 * t196;
        let t850 = c5 * t838 + s5 * t835;
        let t853 = s5 * t838 - c5 * t835;
        let t862 = L3 * t853 - (c5 * t844 - s5 * t779);
        let t863 = s5 * t844 + c5 * t779 + L3 * t850;
        let t872 = s4 * t862 + c4 * t847;
        let t875 = s4 * t847 - c4 * t862 - L2 * t853;
        let t876 = L2 * (s4 * (c6 * t772 - s6 * t832) - c4 * t850) - t863;
        let t881 = c2 * t872 + (z1_3_x * t875 + t207 * t876);
        let t884 = c3 * t876 - s3 * t875;
        put(35, t881); // row 1, MSY7
        put(79, t884); // row 2, MSY7
        put(116, t872); // row 3, MSY7
        put(146, t863); // row 4, MSY7
        put(169, t847); // row 5, MSY7
        [t830, t833]
    };
    // XX7: column
    let [t886, t889, t890] = {
        let t886 = s7 * t763;
        let t887 = c7 * dw7_x - t886;
        let t889 = c7 * t763;
        let t890 = s7 * dw7_x + t889;
        let t893 = s6 * t762 - c6 * t887;
        let t896 = s6 * t887 + c6 * t762;
        let t901 = z1_5_z * t896 + (t218 * t893 - z1_6_z * t890);
        let t906 = t224 * t893 - t227 * t890 - z2_4_y * t896;
        let t911 = c4 * t896 + (t228 * t893 + z3_5_y * t890);
        let t914 = c5 * t890 - s5 * t893;
        put(36, t901); // row 1, XX7R
        put(80, t906); // row 2, XX7R
        put(117, t911); // row 3, XX7R
        put(147, t914); // row 4, XX7R
        put(170, t896); // row 5, XX7R
        [t886, t889, t890]
    };
    // ZZ7: column
    {
        let t916 = t886 - c7 * t764;
        let t918 = t889 + s7 * t764;
        let t921 = c6 * t916 - s6 * dw7_z;
        let t924 = s6 * t916 + c6 * dw7_z;
        let t929 = z1_5_z * t924 - (t218 * t921 - z1_6_z * t918);
        let t934 = t227 * t918 - t224 * t921 - z2_4_y * t924;
        let t939 = c4 * t924 - (t228 * t921 + z3_5_y * t918);
        let t942 = s5 * t921 - c5 * t918;
        put(37, t929); // row 1, ZZ7
        put(81, t934); // row 2, ZZ7
        put(118, t939); // row 3, ZZ7
        put(148, t942); // row 4, ZZ7
        put(171, t924); // row 5, ZZ7
        put(187, t918); // row 6, ZZ7
    }
    // XY7: column
    {
        let t943 = t759 - t760;
        let t946 = s7 * t772 - c7 * t771;
        let t949 = s7 * t771 + c7 * t772;
        let t952 = c6 * t946 - s6 * t943;
        let t955 = s6 * t946 + c6 * t943;
        let t960 = z1_5_z * t955 - (t218 * t952 - z1_6_z * t949);
        let t965 = t227 * t949 - t224 * t952 - z2_4_y * t955;
        let t970 = c4 * t955 - (t228 * t952 + z3_5_y * t949);
        let t973 = s5 * t952 - c5 * t949;
        put(38, t960); // row 1, XY7
        put(82, t965); // row 2, XY7
        put(119, t970); // row 3, XY7
        put(149, t973); // row 4, XY7
        put(172, t955); // row 5, XY7
        put(188, t949); // row 6, XY7
        put(197, t943); // row 7, XY7
    }
    // XZ7: column
    {
        let t974 = t759 - t761;
        let t976 = s7 * t974 - t777;
        let t978 = t774 + c7 * t974;
        let t981 = c6 * t976 - s6 * t770;
        let t984 = s6 * t976 + c6 * t770;
        let t989 = z1_5_z * t984 + (z1_6_z * t978 - t218 * t981);
        let t994 = t227 * t978 - t224 * t981 - z2_4_y * t984;
        let t999 = c4 * t984 - (t228 * t981 + z3_5_y * t978);
        let t1002 = s5 * t981 - c5 * t978;
        put(39, t989); // row 1, XZ7
        put(83, t994); // row 2, XZ7
        put(120, t999); // row 3, XZ7
        put(150, t1002); // row 4, XZ7
        put(173, t984); // row 5, XZ7
        put(189, t978); // row 6, XZ7
    }
    // YZ7: column
    {
        let t1003 = t760 - t761;
        let t1005 = t833 - c7 * t1003;
        let t1007 = t830 + s7 * t1003;
        let t1010 = c6 * t1005 + s6 * t767;
        let t1013 = c6 * t767 - s6 * t1005;
        let t1018 = z1_5_z * t1013 + (t218 * t1010 - z1_6_z * t1007);
        let t1023 = t224 * t1010 - t227 * t1007 - z2_4_y * t1013;
        let t1028 = c4 * t1013 + (t228 * t1010 + z3_5_y * t1007);
        let t1031 = c5 * t1007 - s5 * t1010;
        let t1032 = dq1.sign();
        let t1033 = dq2.sign();
        let t1034 = dq3.sign();
        let t1035 = dq4.sign();
        let t1036 = dq5.sign();
        let t1037 = dq6.sign();
        let t1038 = dq7.sign();
        let t1039 = -a2_x;
        let t1040 = -t25;
        let t1041 = -t278;
        let t1042 = -t284;
        let t1043 = -t71;
        let t1044 = -t312;
        let t1045 = -t498;
        let t1046 = -t577;
        let t1047 = -t560;
        let t1048 = -t183;
        let t1049 = -t779;
        let t1050 = -t890;
        let t1051 = -t1007;
        put(40, t1018); // row 1, YZ7
        put(42, t1032); // row 1, FC1
        put(44, t1039); // row 2, MSY2R
        put(45, t1040); // row 2, XX2R
        put(56, t1041); // row 2, YZ3
        put(84, t1023); // row 2, YZ7
        put(86, t1033); // row 2, FC2
        put(88, t1042); // row 3, MSY3R
        put(92, t1043); // row 3, XZ3
        put(94, t1044); // row 3, MSX4
        put(121, t1028); // row 3, YZ7
        put(123, t1034); // row 3, FC3
        put(134, t1045); // row 4, ZZ5R
        put(138, t1046); // row 4, MSX6
        put(151, t1031); // row 4, YZ7
        put(153, t1035); // row 4, FC4
        put(162, t1047); // row 5, MSY6R
        put(174, t1013); // row 5, YZ7
        put(176, t1036); // row 5, FC5
        put(179, t1048); // row 6, XX6R
        put(185, t1049); // row 6, MSY7
        put(186, t1050); // row 6, XX7R
        put(190, t1051); // row 6, YZ7
        put(192, t1037); // row 6, FC6
        put(201, t1038); // row 7, FC7
    }
}
