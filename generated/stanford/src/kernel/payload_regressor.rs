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
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        t1, w3_z, t8, t10, t12, t19, t20, t21,
        t22,
    ] = {
        let t1 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t7 = D2 * ddq1;
        let t8 = D2 * t0;
        let t10 = s2 * k0 + c2 * t7;
        let t12 = c2 * k0 - s2 * t7;
        let t17 = dq2 * w3_z;
        let t19 = c2 * ddq1 - dq2 * t1;
        let t20 = t1 * w3_z - ddq2;
        let t21 = t1 * t1 + dq2 * dq2;
        let t22 = t17 + (s2 * ddq1 + t17);
        [
        t1, w3_z, t8, t10, t12, t19, t20, t21,
        t22,
    ]
    };
    // link 3: motion
    let [t32, t33, a3_z] = {
        let t29 = dq3 * k2;
        let t32 = q3 * t22 - t8 + t1 * t29;
        let t33 = t10 + q3 * t20 - dq2 * t29;
        let a3_z = ddq3 + (t12 - q3 * t21);
        [t32, t33, a3_z]
    };
    // link 4: motion
    let [t37, w4_y, t43, a4_y, w4_z, dw4_y, t60, t61] = {
        let t37 = c4 * dq2 + s4 * t1;
        let w4_y = s4 * dq2 - c4 * t1;
        let t43 = c4 * t32 + s4 * t33;
        let a4_y = s4 * t32 - c4 * t33;
        let w4_z = w3_z + dq4;
        let dw4_z = t19 + ddq4;
        let t57 = w4_y * w4_z;
        let dw4_x = c4 * t20 - s4 * t22 + t57;
        let dw4_y = t37 * w4_z - (c4 * t22 + s4 * t20);
        let t60 = dw4_z + t37 * w4_y;
        let t61 = t57 + dw4_x;
        [t37, w4_y, t43, a4_y, w4_z, dw4_y, t60, t61]
    };
    // link 5: motion
    let [
        t64, t67, t70, t73, w5_z, dw5_y, t89, t90,
        t91,
    ] = {
        let t64 = c5 * t37 + s5 * w4_z;
        let t67 = c5 * w4_z - s5 * t37;
        let t70 = c5 * t43 + s5 * a3_z;
        let t73 = s5 * t43 - c5 * a3_z;
        let w5_z = w4_y + dq5;
        let dw5_z = dw4_y + ddq5;
        let t86 = t67 * w5_z;
        let dw5_y = t64 * w5_z - (c5 * t60 + s5 * t61);
        let t89 = dw5_z - t64 * t67;
        let t90 = t64 * t64 + w5_z * w5_z;
        let t91 = t86 + (s5 * t60 - c5 * t61 + t86);
        [
        t64, t67, t70, t73, w5_z, dw5_y, t89, t90,
        t91,
    ]
    };
    // link 6: motion
    let [
        t102, t106, a6_y, t112, t115, dw6_z, t120, t121,
        t122, dw6_x, dw6_y, t125, t126, t127, t128, t129,
        t130, t131,
    ] = {
        let w6_x = s6 * w5_z - c6 * t64;
        let w6_y = c6 * w5_z + s6 * t64;
        let t101 = t70 - D6 * t89;
        let t102 = t73 + D6 * t90;
        let t103 = a4_y + D6 * t91;
        let t106 = c6 * t101 - s6 * t103;
        let a6_y = c6 * t103 + s6 * t101;
        let t112 = c6 * t89 + s6 * t91;
        let t115 = s6 * t89 - c6 * t91;
        let w6_z = t67 + dq6;
        let dw6_z = ddq6 - dw5_y;
        let t118 = w6_x * w6_x;
        let t119 = w6_z * w6_z;
        let t120 = w6_x * w6_y;
        let t121 = w6_x * w6_z;
        let t122 = w6_y * w6_z;
        let dw6_x = t115 + t122;
        let dw6_y = t112 - t121;
        let t125 = t119 - t118;
        let t126 = t90 + t125;
        let t127 = dw6_z - t120;
        let t128 = dw6_z + t120;
        let t129 = t118 + t119;
        let t130 = t121 - dw6_y;
        let t131 = t122 + dw6_x;
        put(44, a6_y); // row 6, MSX
        put(45, t106); // row 6, MSY
        put(47, t120); // row 6, YY
        put(48, dw6_z); // row 6, ZZ
        put(50, t115); // row 6, XZ
        put(51, t112); // row 6, YZ
        [
        t102, t106, a6_y, t112, t115, dw6_z, t120, t121,
        t122, dw6_x, dw6_y, t125, t126, t127, t128, t129,
        t130, t131,
    ]
    };
    // joint axes in frame 2
    let [t132, v1_2_y] = {
        let t132 = c2 * D2;
        let v1_2_y = s2 * D2;
        [t132, v1_2_y]
    };
    // joint axes in frame 4
    let [t134, t135, t136, t137] = {
        let t134 = s2 * s4;
        let t135 = s2 * c4;
        let t136 = s4 * t132;
        let t137 = c4 * t132;
        [t134, t135, t136, t137]
    };
    // payload: column M
    let [t140, t143, t145] = {
        let t140 = c6 * t106 + s6 * a6_y;
        let t143 = c6 * a6_y - s6 * t106;
        let t144 = D6 * t143;
        let t145 = D6 * t140;
        let t148 = c5 * t140 + s5 * t102;
        let t151 = s5 * t140 - c5 * t102;
        let t153 = s5 * t144;
        let t156 = c5 * t144 + q3 * t143;
        let t157 = t145 + q3 * t148;
        let t167 = v1_2_y * t151 - (t136 * t148 - t137 * t143);
        let t168 = c2 * t153 + (t134 * t156 + t135 * t157) - t167;
        let t171 = c4 * t156 - s4 * t157;
        put(0, t168); // row 1, M
        put(10, t171); // row 2, M
        put(20, t151); // row 3, M
        put(24, t153); // row 4, M
        [t140, t143, t145]
    };
    // payload: column MSX
    let [t173, t176, t178, t179] = {
        let t173 = s6 * t128;
        let t174 = c6 * t126 + t173;
        let t176 = c6 * t128;
        let t177 = t176 - s6 * t126;
        let t178 = s6 * t102;
        let t179 = c6 * t102;
        let t182 = t178 + D6 * t177;
        let t183 = t179 - D6 * t174;
        let t186 = s5 * t130 - c5 * t174;
        let t189 = s5 * t174 + c5 * t130;
        let t195 = s5 * t182 + c5 * a6_y;
        let t198 = q3 * t177 - (s5 * a6_y - c5 * t182);
        let t199 = t183 + q3 * t186;
        let t209 = v1_2_y * t189 + (t136 * t186 + t137 * t177);
        let t210 = c2 * t195 + (t134 * t198 - t135 * t199) - t209;
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
        let t214 = c6 * t127;
        let t216 = s6 * t129 - t214;
        let t217 = s6 * t127;
        let t219 = t217 + c6 * t129;
        let t222 = t179 - D6 * t219;
        let t223 = D6 * t216 - t178;
        let t226 = c5 * t216 + s5 * t131;
        let t229 = c5 * t131 - s5 * t216;
        let t235 = s5 * t222 + c5 * t106;
        let t238 = c5 * t222 - s5 * t106 - q3 * t219;
        let t239 = t223 + q3 * t226;
        let t249 = v1_2_y * t229 - (t137 * t219 - t136 * t226);
        let t250 = c2 * t235 + (t134 * t238 - t135 * t239) - t249;
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
        let t256 = c6 * t112 + s6 * t115;
        let t259 = s6 * t112 - c6 * t115;
        let t262 = t143 + D6 * t259;
        let t263 = D6 * t256 - t140;
        let t266 = c5 * t256 - s5 * t90;
        let t269 = s5 * t256 + c5 * t90;
        let t271 = s5 * t262;
        let t274 = c5 * t262 + q3 * t259;
        let t275 = t263 + q3 * t266;
        let t285 = v1_2_y * t269 - (t136 * t266 + t137 * t259);
        let t286 = c2 * t271 - (t135 * t275 - t134 * t274) + t285;
        let t289 = c4 * t274 + s4 * t275;
        put(3, t286); // row 1, MSZ
        put(13, t289); // row 2, MSZ
        put(27, t271); // row 4, MSZ
        put(37, t263); // row 5, MSZ
        t269
    };
    // payload: column XX
    let [t291, t294, t297, t300] = {
        let t291 = s6 * t121;
        let t292 = t291 - c6 * dw6_x;
        let t294 = c6 * t121;
        let t295 = s6 * dw6_x + t294;
        let t297 = s5 * t120;
        let t298 = c5 * t292 + t297;
        let t300 = c5 * t120;
        let t301 = s5 * t292 - t300;
        let t306 = c2 * t301 - (t135 * t295 - t134 * t298);
        let t309 = c4 * t298 + s4 * t295;
        put(4, t306); // row 1, XX
        put(14, t309); // row 2, XX
        put(28, t301); // row 4, XX
        put(38, t295); // row 5, XX
        [t291, t294, t297, t300]
    };
    // payload: column YY
    let [t310, t313] = {
        let t310 = c6 * t122;
        let t312 = t310 + s6 * dw6_y;
        let t313 = s6 * t122;
        let t315 = c6 * dw6_y - t313;
        let t317 = c5 * t312 - t297;
        let t319 = t300 + s5 * t312;
        let t324 = c2 * t319 + (t134 * t317 - t135 * t315);
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
        let t340 = c2 * t335 - (t134 * t332 + t135 * t329);
        let t343 = s4 * t329 - c4 * t332;
        let t344 = t129 - t126;
        put(6, t340); // row 1, ZZ
        put(16, t343); // row 2, ZZ
        put(30, t335); // row 4, ZZ
        put(40, t329); // row 5, ZZ
        put(49, t344); // row 6, XY
        t344
    };
    // payload: column XY
    {
        let t347 = c6 * t130 + s6 * t131;
        let t350 = c6 * t131 - s6 * t130;
        let t353 = c5 * t347 - s5 * t344;
        let t356 = s5 * t347 + c5 * t344;
        let t361 = c2 * t356 - (t135 * t350 - t134 * t353);
        let t364 = c4 * t353 + s4 * t350;
        put(7, t361); // row 1, XY
        put(17, t364); // row 2, XY
        put(31, t356); // row 4, XY
        put(41, t350); // row 5, XY
    }
    // payload: column XZ
    let t383 = {
        let t366 = s6 * t125 - t176;
        let t368 = t173 + c6 * t125;
        let t371 = s5 * t115 - c5 * t366;
        let t374 = s5 * t366 + c5 * t115;
        let t379 = c2 * t374 - (t134 * t371 + t135 * t368);
        let t382 = s4 * t368 - c4 * t371;
        let t383 = t129 - t90;
        put(8, t379); // row 1, XZ
        put(18, t382); // row 2, XZ
        put(32, t374); // row 4, XZ
        put(42, t368); // row 5, XZ
        t383
    };
    // payload: column YZ
    {
        let t385 = t217 + c6 * t383;
        let t387 = t214 - s6 * t383;
        let t390 = c5 * t385 - s5 * t112;
        let t393 = s5 * t385 + c5 * t112;
        let t398 = c2 * t393 - (t135 * t387 - t134 * t390);
        let t401 = c4 * t390 + s4 * t387;
        let t402 = -t269;
        let t403 = -t145;
        let t404 = -t120;
        put(9, t398); // row 1, YZ
        put(19, t401); // row 2, YZ
        put(23, t402); // row 3, MSZ
        put(33, t393); // row 4, YZ
        put(34, t403); // row 5, M
        put(43, t387); // row 5, YZ
        put(46, t404); // row 6, XX
    }
}
