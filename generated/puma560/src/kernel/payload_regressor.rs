//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its
//! origin. Katsumata et al. 2019, (7).
//!
//! 268 multiplications, 192 additions; 6 x 10, 56 of 60 structurally nonzero.

use super::super::runtime::{Scalar, apart};
use super::super::{DOF, GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 56;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9),
    (1, 0), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7), (1, 8), (1, 9),
    (2, 0), (2, 1), (2, 2), (2, 3), (2, 4), (2, 5), (2, 6), (2, 7), (2, 8), (2, 9),
    (3, 1), (3, 2), (3, 3), (3, 4), (3, 5), (3, 6), (3, 7), (3, 8), (3, 9), (4, 1),
    (4, 2), (4, 3), (4, 4), (4, 5), (4, 6), (4, 7), (4, 8), (4, 9), (5, 1), (5, 2),
    (5, 4), (5, 5), (5, 6), (5, 7), (5, 8), (5, 9),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 10 + PATTERN[k].1
}

/// Regressor of a body fixed to the tool frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 10]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            29 => flat[30] = S::default(),
            38 => flat[40] = S::default(),
            47 => flat[50] = S::default(),
            49 => flat[53] = S::default(),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 10]; 6]) {
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
    let k0 = S::constant(-GRAVITY[2]);
    let k3 = S::constant(-constants::D3);
    let k4 = S::constant(-constants::A3);
    let k6 = S::constant(-(-constants::D3 - constants::D2));
    let k_A2 = S::constant(constants::A2);
    let k_D2 = S::constant(constants::D2);
    let k_D4 = S::constant(constants::D4);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [t4, t6, a2_y, t11, t12, t19, t20, t21] = {
        let t3 = k_D2 * ddq1;
        let t4 = k_D2 * t0;
        let t6 = s2 * k0 + c2 * t3;
        let a2_y = s2 * t3 - c2 * k0;
        let t9 = s2 * dq1;
        let t11 = s2 * ddq1;
        let t12 = c2 * ddq1;
        let t16 = dq2 * t9;
        let dw2_y = t16 - t12;
        let t19 = t9 * t9 - dq2 * dq2 - t0;
        let t20 = ddq2 + t9 * (c2 * dq1);
        let t21 = t16 + dw2_y;
        [t4, t6, a2_y, t11, t12, t19, t20, t21]
    };
    // link 3: motion
    let [
        t24, z1_3_y, w3_z, a3_z, a3_x, a3_y, t50, w3_y,
        dw3_y, t60, t61, t62, t63, t64, t65,
    ] = {
        let t24 = s2 * c3 + c2 * s3;
        let z1_3_y = s2 * s3 - c2 * c3;
        let w3_z = dq2 + dq3;
        let dw3_z = ddq2 + ddq3;
        let t39 = k_A2 * t19 + t12 * k3 - t6;
        let t40 = a2_y + (k_A2 * t20 - t11 * k3);
        let a3_z = t0 * k3 - k_A2 * t21 - t4;
        let a3_x = c3 * t39 + s3 * t40;
        let a3_y = c3 * t40 - s3 * t39;
        let t50 = dq1 * t24;
        let w3_y = dq1 * z1_3_y;
        let t52 = t50 * t50;
        let t53 = w3_z * w3_z;
        let t54 = t50 * w3_y;
        let t55 = w3_z * t50;
        let t56 = w3_z * w3_y;
        let dw3_x = t56 - ddq1 * t24;
        let dw3_y = ddq1 * z1_3_y + t55;
        let t60 = t52 - t53 - t0;
        let t61 = dw3_z + t54;
        let t62 = dw3_z - t54;
        let t63 = t52 + t53;
        let t64 = t55 + dw3_y;
        let t65 = t56 + dw3_x;
        [
        t24, z1_3_y, w3_z, a3_z, a3_x, a3_y, t50, w3_y,
        dw3_y, t60, t61, t62, t63, t64, t65,
    ]
    };
    // link 4: motion
    let [
        t66, z1_4_y, t78, a4_x, a4_y, w4_x, w4_y, w4_z,
        dw4_y, t105, t106,
    ] = {
        let t66 = c4 * t24;
        let z1_4_y = s4 * t24;
        let t77 = a3_x + (k_D4 * t61 - t60 * k4);
        let t78 = a3_y + (k_D4 * t63 - t62 * k4);
        let t79 = a3_z - (k_D4 * t65 - t64 * k4);
        let a4_x = c4 * t77 + s4 * t79;
        let a4_y = c4 * t79 - s4 * t77;
        let w4_x = s4 * w3_z - c4 * t50;
        let w4_y = c4 * w3_z + s4 * t50;
        let w4_z = dq4 - w3_y;
        let dw4_z = ddq4 - dw3_y;
        let t102 = w4_y * w4_z;
        let dw4_x = c4 * t65 + s4 * t61 + t102;
        let dw4_y = c4 * t61 - s4 * t65 - w4_x * w4_z;
        let t105 = w4_x * w4_y - dw4_z;
        let t106 = t102 + dw4_x;
        [
        t66, z1_4_y, t78, a4_x, a4_y, w4_x, w4_y, w4_z,
        dw4_y, t105, t106,
    ]
    };
    // link 5: motion
    let [
        a5_x, a5_y, w5_x, t118, w5_z, dw5_y, t134, t135,
        t136,
    ] = {
        let a5_x = c5 * a4_x + s5 * t78;
        let a5_y = c5 * t78 - s5 * a4_x;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t118 = c5 * w4_z + s5 * w4_x;
        let w5_z = w4_y + dq5;
        let dw5_z = dw4_y + ddq5;
        let t131 = t118 * w5_z;
        let dw5_x = c5 * t106 + s5 * t105 - t131;
        let dw5_y = c5 * t105 - s5 * t106 - w5_x * w5_z;
        let t134 = dw5_z + w5_x * t118;
        let t135 = w5_x * w5_x + w5_z * w5_z;
        let t136 = dw5_x - t131;
        [
        a5_x, a5_y, w5_x, t118, w5_z, dw5_y, t134, t135,
        t136,
    ]
    };
    // joint axes in frame 3
    let [v1_3_z, v1_3_x, v1_3_y, v2_3_x, v2_3_y] = {
        let v1_3_z = c2 * k_A2;
        let t138 = c2 * k6;
        let t139 = s2 * k6;
        let v1_3_x = s3 * t139 - c3 * t138;
        let v1_3_y = c3 * t139 + s3 * t138;
        let v2_3_x = s3 * k_A2;
        let v2_3_y = c3 * k_A2;
        [v1_3_z, v1_3_x, v1_3_y, v2_3_x, v2_3_y]
    };
    // joint axes in frame 4
    let [v1_4_x, v1_4_y, v2_4_z, v2_4_x, t161, v3_4_x, t163] = {
        let t151 = v1_3_z + (z1_3_y * k4 + k_D4 * t24);
        let v1_4_x = c4 * v1_3_x + s4 * t151;
        let v1_4_y = c4 * t151 - s4 * v1_3_x;
        let t158 = k_D4 + v2_3_x;
        let v2_4_z = k4 - v2_3_y;
        let v2_4_x = c4 * t158;
        let t161 = s4 * t158;
        let v3_4_x = c4 * k_D4;
        let t163 = s4 * k_D4;
        [v1_4_x, v1_4_y, v2_4_z, v2_4_x, t161, v3_4_x, t163]
    };
    // joint axes in frame 5
    let [
        z1_5_x, z1_5_y, v1_5_x, v1_5_y, z2_5_x, z2_6_z, v2_5_x, v2_6_z,
        v3_5_x, v3_6_z,
    ] = {
        let z1_5_x = s5 * z1_3_y - c5 * t66;
        let z1_5_y = c5 * z1_3_y + s5 * t66;
        let v1_5_x = c5 * v1_4_x + s5 * v1_3_y;
        let v1_5_y = c5 * v1_3_y - s5 * v1_4_x;
        let z2_5_x = s4 * c5;
        let z2_6_z = s4 * s5;
        let v2_5_x = c5 * v2_4_x - s5 * v2_4_z;
        let v2_6_z = c5 * v2_4_z + s5 * v2_4_x;
        let v3_5_x = c5 * v3_4_x - s5 * k4;
        let v3_6_z = c5 * k4 + s5 * v3_4_x;
        [
        z1_5_x, z1_5_y, v1_5_x, v1_5_y, z2_5_x, z2_6_z, v2_5_x, v2_6_z,
        v3_5_x, v3_6_z,
    ]
    };
    // link 6: motion
    let [
        a6_x, a6_y, t204, t207, dw6_z, t212, t213, t214,
        dw6_x, dw6_y, t217, t218, t219, t220, t221, t222,
        t223,
    ] = {
        let a6_x = c6 * a5_x + s6 * a4_y;
        let a6_y = c6 * a4_y - s6 * a5_x;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t204 = c6 * t134 - s6 * t136;
        let t207 = c6 * t136 + s6 * t134;
        let w6_z = t118 + dq6;
        let dw6_z = ddq6 - dw5_y;
        let t210 = w6_x * w6_x;
        let t211 = w6_z * w6_z;
        let t212 = w6_x * w6_y;
        let t213 = w6_x * w6_z;
        let t214 = w6_y * w6_z;
        let dw6_x = t207 + t214;
        let dw6_y = t204 - t213;
        let t217 = t210 - t211;
        let t218 = t217 - t135;
        let t219 = t212 - dw6_z;
        let t220 = dw6_z + t212;
        let t221 = t210 + t211;
        let t222 = t213 - dw6_y;
        let t223 = t214 + dw6_x;
        let t224 = -a6_x;
        let t225 = -t212;
        put(48, a6_y); // row 6, MSX
        put(49, t224); // row 6, MSY
        put(50, t225); // row 6, XX
        put(51, t212); // row 6, YY
        put(52, dw6_z); // row 6, ZZ
        put(54, t207); // row 6, XZ
        put(55, t204); // row 6, YZ
        [
        a6_x, a6_y, t204, t207, dw6_z, t212, t213, t214,
        dw6_x, dw6_y, t217, t218, t219, t220, t221, t222,
        t223,
    ]
    };
    // payload: column M
    let [t228, t231] = {
        let t228 = c6 * a6_x - s6 * a6_y;
        let t231 = s6 * a6_x + c6 * a6_y;
        let t236 = v1_4_y * t231 + (v1_5_x * t228 + a5_y * v1_5_y);
        let t241 = v2_5_x * t228 - a5_y * v2_6_z - t161 * t231;
        let t246 = v3_5_x * t228 - a5_y * v3_6_z - t163 * t231;
        put(0, t236); // row 1, M
        put(10, t241); // row 2, M
        put(20, t246); // row 3, M
        put(41, t228); // row 5, MSZ
        [t228, t231]
    };
    // payload: column MSX
    let [t248, t251, t253, t254] = {
        let t248 = s6 * t220;
        let t249 = c6 * t218 - t248;
        let t251 = c6 * t220;
        let t252 = s6 * t218 + t251;
        let t253 = s6 * a5_y;
        let t254 = c6 * a5_y;
        let t264 = v1_4_y * t252 + (v1_5_x * t249 - t222 * v1_5_y);
        let t265 = z1_4_y * t254 - (z1_5_x * t253 + a6_y * z1_5_y) + t264;
        let t270 = c4 * t254 + (a6_y * z2_6_z - z2_5_x * t253);
        let t276 = t270 + (v2_5_x * t249 + t222 * v2_6_z - t161 * t252);
        let t282 = t270 + (v3_5_x * t249 + t222 * v3_6_z - t163 * t252);
        let t285 = s5 * t253 + c5 * a6_y;
        let t286 = -t253;
        put(1, t265); // row 1, MSX
        put(11, t276); // row 2, MSX
        put(21, t282); // row 3, MSX
        put(30, t285); // row 4, MSX
        put(39, t254); // row 5, MSX
        put(40, t286); // row 5, MSY
        [t248, t251, t253, t254]
    };
    // payload: column MSY
    let [t287, t290] = {
        let t287 = c6 * t219;
        let t289 = t287 + s6 * t221;
        let t290 = s6 * t219;
        let t292 = c6 * t221 - t290;
        let t302 = v1_5_x * t289 - t223 * v1_5_y - v1_4_y * t292;
        let t303 = a6_x * z1_5_y - z1_5_x * t254 - z1_4_y * t253 + t302;
        let t308 = c4 * t253 + (z2_5_x * t254 + a6_x * z2_6_z);
        let t314 = t161 * t292 + (v2_5_x * t289 + t223 * v2_6_z) - t308;
        let t320 = t163 * t292 + (v3_5_x * t289 + t223 * v3_6_z) - t308;
        let t323 = s5 * t254 - c5 * a6_x;
        put(2, t303); // row 1, MSY
        put(12, t314); // row 2, MSY
        put(22, t320); // row 3, MSY
        put(31, t323); // row 4, MSY
        [t287, t290]
    };
    // payload: column MSZ
    {
        let t326 = c6 * t204 + s6 * t207;
        let t329 = s6 * t204 - c6 * t207;
        let t332 = z1_5_x * t231 - z1_4_y * t228;
        let t338 = v1_4_y * t329 + (v1_5_x * t326 + t135 * v1_5_y) - t332;
        let t341 = c4 * t228 - z2_5_x * t231;
        let t347 = t341 - (t161 * t329 + (t135 * v2_6_z - v2_5_x * t326));
        let t353 = t341 + (v3_5_x * t326 - t135 * v3_6_z - t163 * t329);
        let t354 = s5 * t231;
        put(3, t338); // row 1, MSZ
        put(13, t347); // row 2, MSZ
        put(23, t353); // row 3, MSZ
        put(32, t354); // row 4, MSZ
    }
    // payload: column XX
    let [t356, t359, t362, t367, t372] = {
        let t356 = s6 * t213;
        let t357 = t356 - c6 * dw6_x;
        let t359 = c6 * t213;
        let t360 = s6 * dw6_x + t359;
        let t362 = t212 * z1_5_y;
        let t365 = z1_4_y * t360 + (t362 - z1_5_x * t357);
        let t367 = t212 * z2_6_z;
        let t370 = c4 * t360 - (z2_5_x * t357 + t367);
        let t372 = c5 * t212;
        let t373 = s5 * t357 - t372;
        put(4, t365); // row 1, XX
        put(14, t370); // row 2, XX
        put(24, t370); // row 3, XX
        put(33, t373); // row 4, XX
        put(42, t360); // row 5, XX
        [t356, t359, t362, t367, t372]
    };
    // payload: column YY
    let [t374, t377] = {
        let t374 = c6 * t214;
        let t376 = t374 + s6 * dw6_y;
        let t377 = s6 * t214;
        let t379 = c6 * dw6_y - t377;
        let t383 = z1_4_y * t379 - (t362 + z1_5_x * t376);
        let t387 = c4 * t379 + (t367 - z2_5_x * t376);
        let t389 = t372 + s5 * t376;
        put(5, t383); // row 1, YY
        put(15, t387); // row 2, YY
        put(25, t387); // row 3, YY
        put(34, t389); // row 4, YY
        put(43, t379); // row 5, YY
        [t374, t377]
    };
    // payload: column ZZ
    let t405 = {
        let t390 = t356 + t374;
        let t391 = t377 - t359;
        let t396 = z1_4_y * t391 + (z1_5_x * t390 - dw6_z * z1_5_y);
        let t401 = c4 * t391 + (z2_5_x * t390 + dw6_z * z2_6_z);
        let t404 = c5 * dw6_z - s5 * t390;
        let t405 = t218 + t221;
        put(6, t396); // row 1, ZZ
        put(16, t401); // row 2, ZZ
        put(26, t401); // row 3, ZZ
        put(35, t404); // row 4, ZZ
        put(44, t391); // row 5, ZZ
        put(53, t405); // row 6, XY
        t405
    };
    // payload: column XY
    {
        let t408 = c6 * t222 + s6 * t223;
        let t411 = c6 * t223 - s6 * t222;
        let t416 = z1_4_y * t411 - (z1_5_x * t408 + z1_5_y * t405);
        let t421 = c4 * t411 + (z2_6_z * t405 - z2_5_x * t408);
        let t424 = s5 * t408 + c5 * t405;
        put(7, t416); // row 1, XY
        put(17, t421); // row 2, XY
        put(27, t421); // row 3, XY
        put(36, t424); // row 4, XY
        put(45, t411); // row 5, XY
    }
    // payload: column XZ
    let t442 = {
        let t426 = t251 + s6 * t217;
        let t428 = t248 - c6 * t217;
        let t433 = z1_4_y * t428 + (z1_5_x * t426 - t207 * z1_5_y);
        let t438 = c4 * t428 + (z2_5_x * t426 + t207 * z2_6_z);
        let t441 = c5 * t207 - s5 * t426;
        let t442 = t135 - t221;
        put(8, t433); // row 1, XZ
        put(18, t438); // row 2, XZ
        put(28, t438); // row 3, XZ
        put(37, t441); // row 4, XZ
        put(46, t428); // row 5, XZ
        t442
    };
    // payload: column YZ
    {
        let t444 = t290 + c6 * t442;
        let t446 = s6 * t442 - t287;
        let t451 = z1_4_y * t446 - (t204 * z1_5_y - z1_5_x * t444);
        let t456 = c4 * t446 + (z2_5_x * t444 + t204 * z2_6_z);
        let t459 = c5 * t204 - s5 * t444;
        put(9, t451); // row 1, YZ
        put(19, t456); // row 2, YZ
        put(29, t456); // row 3, YZ
        put(38, t459); // row 4, YZ
        put(47, t446); // row 5, YZ
    }
}
