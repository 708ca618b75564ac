//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin (the paper's (7)).
//!
//! 242 multiplications, 163 additions; 6 x 10, 52 of 60 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 52;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9),
    (1, 0), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7), (1, 8), (1, 9),
    (2, 0), (2, 1), (2, 2), (2, 3), (3, 0), (3, 1), (3, 2), (3, 3), (3, 4), (3, 5),
    (3, 6), (3, 7), (3, 8), (3, 9), (4, 0), (4, 1), (4, 2), (4, 3), (4, 4), (4, 5),
    (4, 6), (4, 7), (4, 8), (4, 9), (5, 1), (5, 2), (5, 4), (5, 5), (5, 6), (5, 7),
    (5, 8), (5, 9),
];

/// Regressor of a body fixed to the tool frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 10]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    flat[24..30].fill(S::default());
    flat[50] = S::default();
    flat[53] = S::default();
    nonzeros(trig, dq, ddq, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
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
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        t4, t6, a2_y, t9, w3_z, dw2_y, t20, t21,
        t22,
    ] = {
        let t3 = D2 * ddq1;
        let t4 = D2 * t0;
        let t6 = s2 * k0 + c2 * t3;
        let a2_y = s2 * t3 - c2 * k0;
        let t9 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t17 = dq2 * w3_z;
        let dw2_y = dq2 * t9 - c2 * ddq1;
        let t20 = t9 * w3_z - ddq2;
        let t21 = t9 * t9 + dq2 * dq2;
        let t22 = t17 + (s2 * ddq1 + t17);
        [
        t4, t6, a2_y, t9, w3_z, dw2_y, t20, t21,
        t22,
    ]
    };
    // link 3: motion
    let [t32, a3_y, a3_z] = {
        let t29 = dq3 * k2;
        let t32 = t9 * t29 - (t4 - q3 * t22);
        let a3_y = dq2 * t29 - (t6 + q3 * t20);
        let a3_z = ddq3 - (a2_y + q3 * t21);
        [t32, a3_y, a3_z]
    };
    // link 4: motion
    let [
        t35, t36, t39, a4_y, t45, w4_y, w4_z, dw4_y,
        t62, t63,
    ] = {
        let t35 = s2 * s4;
        let t36 = s2 * c4;
        let t39 = c4 * t32 - s4 * a3_y;
        let a4_y = c4 * a3_y + s4 * t32;
        let t45 = c4 * dq2 + s4 * t9;
        let w4_y = s4 * dq2 - c4 * t9;
        let w4_z = w3_z + dq4;
        let dw4_z = ddq4 - dw2_y;
        let t59 = w4_y * w4_z;
        let dw4_x = c4 * t20 - s4 * t22 + t59;
        let dw4_y = t45 * w4_z - (c4 * t22 + s4 * t20);
        let t62 = dw4_z + t45 * w4_y;
        let t63 = t59 + dw4_x;
        [
        t35, t36, t39, a4_y, t45, w4_y, w4_z, dw4_y,
        t62, t63,
    ]
    };
    // link 5: motion
    let [
        t66, t69, t72, w5_y, w5_z, t90, t91, t92,
        t93,
    ] = {
        let t66 = c5 * t39 + s5 * a3_z;
        let t69 = c5 * a3_z - s5 * t39;
        let t72 = c5 * t45 + s5 * w4_z;
        let w5_y = s5 * t45 - c5 * w4_z;
        let w5_z = w4_y + dq5;
        let dw5_z = dw4_y + ddq5;
        let t88 = w5_y * w5_z;
        let dw5_x = c5 * t63 - s5 * t62 + t88;
        let t90 = c5 * t62 + s5 * t63 - t72 * w5_z;
        let t91 = dw5_z + t72 * w5_y;
        let t92 = t72 * t72 + w5_z * w5_z;
        let t93 = t88 + dw5_x;
        [
        t66, t69, t72, w5_y, w5_z, t90, t91, t92,
        t93,
    ]
    };
    // link 6: motion
    let [
        t98, t102, a6_y, t114, t117, dw6_z, t122, t123,
        t124, dw6_x, dw6_y, t127, t128, t129, t130, t131,
        t132, t133,
    ] = {
        let t97 = t66 - D6 * t91;
        let t98 = D6 * t92 - t69;
        let t99 = a4_y - D6 * t93;
        let t102 = c6 * t97 - s6 * t99;
        let a6_y = c6 * t99 + s6 * t97;
        let w6_x = s6 * w5_z - c6 * t72;
        let w6_y = c6 * w5_z + s6 * t72;
        let t114 = c6 * t91 - s6 * t93;
        let t117 = c6 * t93 + s6 * t91;
        let w6_z = dq6 - w5_y;
        let dw6_z = t90 + ddq6;
        let t120 = w6_x * w6_x;
        let t121 = w6_z * w6_z;
        let t122 = w6_x * w6_y;
        let t123 = w6_x * w6_z;
        let t124 = w6_y * w6_z;
        let dw6_x = t117 + t124;
        let dw6_y = t114 - t123;
        let t127 = t121 - t120;
        let t128 = t92 + t127;
        let t129 = t122 - dw6_z;
        let t130 = dw6_z + t122;
        let t131 = t120 + t121;
        let t132 = dw6_y - t123;
        let t133 = t124 + dw6_x;
        put(44, a6_y); // row 6, MSX
        put(45, t102); // row 6, MSY
        put(47, t122); // row 6, YY
        put(48, dw6_z); // row 6, ZZ
        put(50, t117); // row 6, XZ
        put(51, t114); // row 6, YZ
        [
        t98, t102, a6_y, t114, t117, dw6_z, t122, t123,
        t124, dw6_x, dw6_y, t127, t128, t129, t130, t131,
        t132, t133,
    ]
    };
    // joint axes in frame 2
    let [t134, v1_2_y] = {
        let t134 = c2 * D2;
        let v1_2_y = s2 * D2;
        [t134, v1_2_y]
    };
    // joint axes in frame 4
    let [t136, t137] = {
        let t136 = s4 * t134;
        let t137 = c4 * t134;
        [t136, t137]
    };
    // payload: column M
    let [t140, t143, t145] = {
        let t140 = c6 * t102 + s6 * a6_y;
        let t143 = c6 * a6_y - s6 * t102;
        let t144 = D6 * t143;
        let t145 = D6 * t140;
        let t148 = c5 * t140 + s5 * t98;
        let t151 = s5 * t140 - c5 * t98;
        let t153 = s5 * t144;
        let t156 = c5 * t144 + q3 * t143;
        let t157 = t145 + q3 * t148;
        let t167 = t136 * t148 - t137 * t143 - v1_2_y * t151;
        let t168 = c2 * t153 + (t35 * t156 + t36 * t157) + t167;
        let t171 = c4 * t156 - s4 * t157;
        put(0, t168); // row 1, M
        put(10, t171); // row 2, M
        put(20, t151); // row 3, M
        put(24, t153); // row 4, M
        [t140, t143, t145]
    };
    // payload: column MSX
    let [t173, t176, t178, t179] = {
        let t173 = s6 * t130;
        let t174 = c6 * t128 + t173;
        let t176 = c6 * t130;
        let t177 = t176 - s6 * t128;
        let t178 = s6 * t98;
        let t179 = c6 * t98;
        let t182 = t178 + D6 * t177;
        let t183 = t179 - D6 * t174;
        let t186 = c5 * t174 + s5 * t132;
        let t189 = s5 * t174 - c5 * t132;
        let t195 = s5 * t182 + c5 * a6_y;
        let t198 = c5 * t182 - s5 * a6_y + q3 * t177;
        let t199 = t183 - q3 * t186;
        let t209 = v1_2_y * t189 + (t137 * t177 - t136 * t186);
        let t210 = c2 * t195 + (t35 * t198 - t36 * t199) - t209;
        let t213 = c4 * t198 + s4 * t199;
        put(1, t210); // row 1, MSX
        put(11, t213); // row 2, MSX
        put(21, t189); // row 3, MSX
        put(25, t195); // row 4, MSX
        put(35, t183); // row 5, MSX
        [t173, t176, t178, t179]
    };
    // payload: column MSY
    let [t214, t217] = {
        let t214 = c6 * t129;
        let t216 = t214 + s6 * t131;
        let t217 = s6 * t129;
        let t219 = t217 - c6 * t131;
        let t222 = t179 + D6 * t219;
        let t223 = D6 * t216 - t178;
        let t226 = c5 * t216 + s5 * t133;
        let t229 = c5 * t133 - s5 * t216;
        let t235 = s5 * t222 + c5 * t102;
        let t238 = c5 * t222 - s5 * t102 + q3 * t219;
        let t239 = t223 + q3 * t226;
        let t249 = v1_2_y * t229 + (t136 * t226 + t137 * t219);
        let t250 = c2 * t235 + (t35 * t238 - t36 * t239) - t249;
        let t253 = c4 * t238 + s4 * t239;
        put(2, t250); // row 1, MSY
        put(12, t253); // row 2, MSY
        put(22, t229); // row 3, MSY
        put(26, t235); // row 4, MSY
        put(36, t223); // row 5, MSY
        [t214, t217]
    };
    // payload: column MSZ
    let t269 = {
        let t256 = c6 * t114 + s6 * t117;
        let t259 = s6 * t114 - c6 * t117;
        let t262 = t143 + D6 * t259;
        let t263 = D6 * t256 - t140;
        let t266 = c5 * t256 - s5 * t92;
        let t269 = s5 * t256 + c5 * t92;
        let t271 = s5 * t262;
        let t274 = c5 * t262 + q3 * t259;
        let t275 = t263 + q3 * t266;
        let t285 = v1_2_y * t269 - (t136 * t266 + t137 * t259);
        let t286 = c2 * t271 + (t35 * t274 - t36 * t275) + t285;
        let t289 = c4 * t274 + s4 * t275;
        put(3, t286); // row 1, MSZ
        put(13, t289); // row 2, MSZ
        put(27, t271); // row 4, MSZ
        put(37, t263); // row 5, MSZ
        t269
    };
    // payload: column XX
    let [t291, t294, t297, t300] = {
        let t291 = s6 * t123;
        let t292 = t291 - c6 * dw6_x;
        let t294 = c6 * t123;
        let t295 = s6 * dw6_x + t294;
        let t297 = s5 * t122;
        let t298 = c5 * t292 + t297;
        let t300 = c5 * t122;
        let t301 = s5 * t292 - t300;
        let t306 = c2 * t301 + (t35 * t298 - t36 * t295);
        let t309 = c4 * t298 + s4 * t295;
        put(4, t306); // row 1, XX
        put(14, t309); // row 2, XX
        put(28, t301); // row 4, XX
        put(38, t295); // row 5, XX
        [t291, t294, t297, t300]
    };
    // payload: column YY
    let [t310, t313] = {
        let t310 = c6 * t124;
        let t312 = t310 + s6 * dw6_y;
        let t313 = s6 * t124;
        let t315 = c6 * dw6_y - t313;
        let t317 = c5 * t312 - t297;
        let t319 = t300 + s5 * t312;
        let t324 = c2 * t319 + (t35 * t317 - t36 * t315);
        let t327 = c4 * t317 + s4 * t315;
        put(5, t324); // row 1, YY
        put(15, t327); // row 2, YY
        put(29, t319); // row 4, YY
        put(39, t315); // row 5, YY
        [t310, t313]
    };
    // payload: column ZZ
    let t344 = {
        let t328 = t291 + t310;
        let t329 = t313 - t294;
        let t332 = c5 * t328 + s5 * dw6_z;
        let t335 = c5 * dw6_z - s5 * t328;
        let t340 = c2 * t335 - (t35 * t332 + t36 * t329);
        let t343 = s4 * t329 - c4 * t332;
        let t344 = t131 - t128;
        put(6, t340); // row 1, ZZ
        put(16, t343); // row 2, ZZ
        put(30, t335); // row 4, ZZ
        put(40, t329); // row 5, ZZ
        put(49, t344); // row 6, XY
        t344
    };
    // payload: column XY
    {
        let t347 = c6 * t132 - s6 * t133;
        let t350 = s6 * t132 + c6 * t133;
        let t353 = c5 * t347 + s5 * t344;
        let t356 = c5 * t344 - s5 * t347;
        let t361 = c2 * t356 - (t35 * t353 + t36 * t350);
        let t364 = s4 * t350 - c4 * t353;
        put(7, t361); // row 1, XY
        put(17, t364); // row 2, XY
        put(31, t356); // row 4, XY
        put(41, t350); // row 5, XY
    }
    // payload: column XZ
    let t383 = {
        let t366 = t176 - s6 * t127;
        let t368 = t173 + c6 * t127;
        let t371 = c5 * t366 + s5 * t117;
        let t374 = c5 * t117 - s5 * t366;
        let t379 = c2 * t374 - (t35 * t371 + t36 * t368);
        let t382 = s4 * t368 - c4 * t371;
        let t383 = t92 - t131;
        put(8, t379); // row 1, XZ
        put(18, t382); // row 2, XZ
        put(32, t374); // row 4, XZ
        put(42, t368); // row 5, XZ
        t383
    };
    // payload: column YZ
    {
        let t385 = t217 + c6 * t383;
        let t387 = s6 * t383 - t214;
        let t390 = c5 * t385 + s5 * t114;
        let t393 = c5 * t114 - s5 * t385;
        let t398 = c2 * t393 - (t35 * t390 + t36 * t387);
        let t401 = s4 * t387 - c4 * t390;
        let t402 = -t269;
        let t403 = -t145;
        let t404 = -t122;
        put(9, t398); // row 1, YZ
        put(19, t401); // row 2, YZ
        put(23, t402); // row 3, MSZ
        put(33, t393); // row 4, YZ
        put(34, t403); // row 5, M
        put(43, t387); // row 5, YZ
        put(46, t404); // row 6, XX
    }
}
