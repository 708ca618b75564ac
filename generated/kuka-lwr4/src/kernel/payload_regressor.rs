//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin (the paper's (7)).
//!
//! 349 multiplications, 221 additions; 7 x 10, 66 of 70 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 66;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9),
    (1, 0), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7), (1, 8), (1, 9),
    (2, 0), (2, 1), (2, 2), (2, 3), (2, 4), (2, 5), (2, 6), (2, 7), (2, 8), (2, 9),
    (3, 0), (3, 1), (3, 2), (3, 3), (3, 4), (3, 5), (3, 6), (3, 7), (3, 8), (3, 9),
    (4, 1), (4, 2), (4, 3), (4, 4), (4, 5), (4, 6), (4, 7), (4, 8), (4, 9), (5, 1),
    (5, 2), (5, 3), (5, 4), (5, 5), (5, 6), (5, 7), (5, 8), (5, 9), (6, 1), (6, 2),
    (6, 4), (6, 5), (6, 6), (6, 7), (6, 8), (6, 9),
];

/// Regressor of a body fixed to the tool frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 10]; 7]) {
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
    let [w2_x, w2_y, a2_x, a2_y, t6, dw2_x, t9] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let t6 = dq2 * w2_y;
        let dw2_x = s2 * ddq1 + t6;
        let t9 = dq2 * w2_x - c2 * ddq1;
        [w2_x, w2_y, a2_x, a2_y, t6, dw2_x, t9]
    };
    // link 3: motion
    let [
        w3_x, t15, t32, t35, t38, w3_z, t42, t43,
        t44,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t15 = c3 * dq2 + s3 * w2_x;
        let t30 = L2 * (t6 + dw2_x);
        let t31 = L2 * (ddq2 - w2_x * w2_y) - a2_x;
        let t32 = L2 * (w2_x * w2_x + dq2 * dq2) - a2_y;
        let t35 = c3 * t31 + s3 * t30;
        let t38 = c3 * t30 - s3 * t31;
        let w3_z = w2_y + dq3;
        let t42 = dq3 * t15 - (c3 * dw2_x - s3 * ddq2);
        let t43 = c3 * ddq2 + s3 * dw2_x + dq3 * w3_x;
        let t44 = t9 - ddq3;
        [
        w3_x, t15, t32, t35, t38, w3_z, t42, t43,
        t44,
    ]
    };
    // link 4: motion
    let [w4_x, t50, a4_x, t62, w4_z, t66, t67, t68] = {
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t50 = c4 * w3_z + s4 * w3_x;
        let a4_x = s4 * t32 - c4 * t35;
        let t62 = c4 * t32 + s4 * t35;
        let w4_z = dq4 - t15;
        let t66 = dq4 * t50 - (s4 * t44 - c4 * t42);
        let t67 = dq4 * w4_x - (c4 * t44 + s4 * t42);
        let t68 = t43 - ddq4;
        [w4_x, t50, a4_x, t62, w4_z, t66, t67, t68]
    };
    // link 5: motion
    let [
        w5_x, t74, t92, a5_x, t99, w5_z, t103, t104,
        dw5_z,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let t74 = s5 * w4_x - c5 * w4_z;
        let t91 = a4_x - L3 * (t68 - w4_x * t50);
        let t92 = t62 + L3 * (w4_x * w4_x + w4_z * w4_z);
        let t93 = L3 * (t66 + t50 * w4_z) - t38;
        let a5_x = c5 * t91 + s5 * t93;
        let t99 = c5 * t93 - s5 * t91;
        let w5_z = t50 + dq5;
        let t103 = c5 * t66 + s5 * t68 + dq5 * t74;
        let t104 = c5 * t68 - s5 * t66 + dq5 * w5_x;
        let dw5_z = t67 + ddq5;
        [
        w5_x, t74, t92, a5_x, t99, w5_z, t103, t104,
        dw5_z,
    ]
    };
    // link 6: motion
    let [w6_x, w6_y, t120, t123, w6_z, dw6_x, t128, dw6_z] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t120 = s6 * t92 - c6 * a5_x;
        let t123 = c6 * t92 + s6 * a5_x;
        let w6_z = t74 + dq6;
        let dw6_x = s6 * dw5_z - c6 * t103 + dq6 * w6_y;
        let t128 = dq6 * w6_x - (c6 * dw5_z + s6 * t103);
        let dw6_z = t104 + ddq6;
        [w6_x, w6_y, t120, t123, w6_z, dw6_x, t128, dw6_z]
    };
    // link 7: motion
    let [w7_x, t135, t144, a7_y, w7_z, dw7_x, t152, dw7_z] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t135 = c7 * w6_z + s7 * w6_x;
        let t144 = c7 * t120 - s7 * t99;
        let a7_y = c7 * t99 + s7 * t120;
        let w7_z = w6_y + dq7;
        let dw7_x = c7 * dw6_x - s7 * dw6_z - dq7 * t135;
        let t152 = c7 * dw6_z + s7 * dw6_x + dq7 * w7_x;
        let dw7_z = ddq7 - t128;
        put(58, a7_y); // row 7, MSX
        put(59, t144); // row 7, MSY
        put(62, dw7_z); // row 7, ZZ
        [w7_x, t135, t144, a7_y, w7_z, dw7_x, t152, dw7_z]
    };
    // joint axes in frame 3
    let [z1_3_x, t155] = {
        let z1_3_x = s2 * c3;
        let t155 = s2 * s3;
        [z1_3_x, t155]
    };
    // joint axes in frame 4
    let [t158, z1_5_z, t162, z2_4_y] = {
        let t158 = c2 * s4 - c4 * z1_3_x;
        let z1_5_z = c2 * c4 + s4 * z1_3_x;
        let t162 = s3 * c4;
        let z2_4_y = s3 * s4;
        [t158, z1_5_z, t162, z2_4_y]
    };
    // joint axes in frame 5
    let [t166, z1_6_z, t172, t175, t176, z3_5_y] = {
        let t166 = c5 * t158 + s5 * t155;
        let z1_6_z = c5 * t155 - s5 * t158;
        let t172 = c5 * t162 + c3 * s5;
        let t175 = c3 * c5 - s5 * t162;
        let t176 = s4 * c5;
        let z3_5_y = s4 * s5;
        [t166, z1_6_z, t172, t175, t176, z3_5_y]
    };
    // joint axes in frame 7
    let [
        t178, t179, t180, t181, t182, t183, t184, t185,
        t186, t187, t188, t189, t190, t191, t192,
    ] = {
        let t178 = w7_x * w7_x;
        let t179 = t135 * t135;
        let t180 = w7_z * w7_z;
        let t181 = w7_x * t135;
        let t182 = w7_x * w7_z;
        let t183 = t135 * w7_z;
        let t184 = t179 + t180;
        let t185 = dw7_z + t181;
        let t186 = t182 - t152;
        let t187 = dw7_z - t181;
        let t188 = t178 + t180;
        let t189 = dw7_x + t183;
        let t190 = t152 + t182;
        let t191 = t183 - dw7_x;
        let t192 = t178 + t179;
        put(60, t181); // row 7, XX
        put(64, t189); // row 7, XZ
        put(65, t186); // row 7, YZ
        [
        t178, t179, t180, t181, t182, t183, t184, t185,
        t186, t187, t188, t189, t190, t191, t192,
    ]
    };
    // payload: column M
    let [t195, t198] = {
        let t195 = c7 * t144 + s7 * a7_y;
        let t198 = s7 * t144 - c7 * a7_y;
        let t201 = s6 * t123 - c6 * t195;
        let t207 = c5 * t201 + s5 * t198;
        let t210 = s5 * t201 - c5 * t198;
        let t211 = L3 * t210;
        let t212 = L3 * t207;
        let t217 = s4 * t211;
        let t220 = c4 * t211 + L2 * t210;
        let t221 = L2 * (s4 * (s6 * t195 + c6 * t123) - c4 * t207) - t212;
        let t226 = c2 * t217 + (t155 * t221 - z1_3_x * t220);
        let t229 = s3 * t220 + c3 * t221;
        put(0, t226); // row 1, M
        put(10, t229); // row 2, M
        put(20, t217); // row 3, M
        put(30, t212); // row 4, M
        put(51, t195); // row 6, MSZ
        [t195, t198]
    };
    // payload: column MSX
    let [t231, t234, t236, t237] = {
        let t231 = s7 * t187;
        let t232 = c7 * t184 + t231;
        let t234 = c7 * t187;
        let t235 = t234 - s7 * t184;
        let t236 = s7 * t123;
        let t237 = c7 * t123;
        let t240 = c6 * t232 + s6 * t190;
        let t246 = c6 * t236 + s6 * a7_y;
        let t249 = c6 * a7_y - s6 * t236;
        let t252 = c5 * t240 + s5 * t235;
        let t255 = c5 * t235 - s5 * t240;
        let t264 = c5 * t246 + s5 * t237 + L3 * t255;
        let t265 = c5 * t237 - s5 * t246 - L3 * t252;
        let t274 = s4 * t264 + c4 * t249;
        let t277 = c4 * t264 - s4 * t249 + L2 * t255;
        let t278 = L2 * (c4 * t252 + s4 * (s6 * t232 - c6 * t190)) - t265;
        let t283 = c2 * t274 + (t155 * t278 - z1_3_x * t277);
        let t286 = s3 * t277 + c3 * t278;
        put(1, t283); // row 1, MSX
        put(11, t286); // row 2, MSX
        put(21, t274); // row 3, MSX
        put(31, t265); // row 4, MSX
        put(40, t249); // row 5, MSX
        put(50, t236); // row 6, MSY
        [t231, t234, t236, t237]
    };
    // payload: column MSY
    let [t287, t290] = {
        let t287 = c7 * t185;
        let t289 = s7 * t188 - t287;
        let t290 = s7 * t185;
        let t292 = t290 + c7 * t188;
        let t295 = c6 * t289 + s6 * t191;
        let t301 = c6 * t237 + s6 * t144;
        let t304 = c6 * t144 - s6 * t237;
        let t307 = c5 * t295 + s5 * t292;
        let t310 = s5 * t295 - c5 * t292;
        let t319 = c5 * t301 - s5 * t236 + L3 * t310;
        let t320 = L3 * t307 - (s5 * t301 + c5 * t236);
        let t329 = s4 * t319 + c4 * t304;
        let t332 = c4 * t319 - s4 * t304 + L2 * t310;
        let t333 = t320 + L2 * (c4 * t307 + s4 * (s6 * t289 - c6 * t191));
        let t338 = c2 * t329 - (z1_3_x * t332 + t155 * t333);
        let t341 = s3 * t332 - c3 * t333;
        put(2, t338); // row 1, MSY
        put(12, t341); // row 2, MSY
        put(22, t329); // row 3, MSY
        put(32, t320); // row 4, MSY
        put(41, t304); // row 5, MSY
        [t287, t290]
    };
    // payload: column MSZ
    {
        let t344 = c7 * t186 + s7 * t189;
        let t347 = c7 * t189 - s7 * t186;
        let t350 = c6 * t344 + s6 * t192;
        let t354 = c6 * t198;
        let t355 = s6 * t198;
        let t358 = c5 * t350 + s5 * t347;
        let t361 = s5 * t350 - c5 * t347;
        let t370 = L3 * t361 - (c5 * t354 + s5 * t195);
        let t371 = L3 * t358 - (c5 * t195 - s5 * t354);
        let t380 = s4 * t370 + c4 * t355;
        let t383 = c4 * t370 - s4 * t355 + L2 * t361;
        let t384 = t371 + L2 * (c4 * t358 - s4 * (c6 * t192 - s6 * t344));
        let t389 = c2 * t380 - (z1_3_x * t383 + t155 * t384);
        let t392 = s3 * t383 - c3 * t384;
        put(3, t389); // row 1, MSZ
        put(13, t392); // row 2, MSZ
        put(23, t380); // row 3, MSZ
        put(33, t371); // row 4, MSZ
        put(42, t355); // row 5, MSZ
    }
    // payload: column XX
    let [t394, t397, t398, t400, t403] = {
        let t394 = s7 * t182;
        let t395 = c7 * dw7_x - t394;
        let t397 = c7 * t182;
        let t398 = s7 * dw7_x + t397;
        let t400 = s6 * t181;
        let t401 = t400 - c6 * t395;
        let t403 = c6 * t181;
        let t404 = s6 * t395 + t403;
        let t409 = z1_5_z * t404 + (t166 * t401 - z1_6_z * t398);
        let t414 = t172 * t401 - t175 * t398 - z2_4_y * t404;
        let t419 = c4 * t404 + (t176 * t401 + z3_5_y * t398);
        let t422 = c5 * t398 - s5 * t401;
        put(4, t409); // row 1, XX
        put(14, t414); // row 2, XX
        put(24, t419); // row 3, XX
        put(34, t422); // row 4, XX
        put(43, t404); // row 5, XX
        [t394, t397, t398, t400, t403]
    };
    // payload: column YY
    let [t423, t426] = {
        let t423 = c7 * t183;
        let t425 = t423 + s7 * t152;
        let t426 = s7 * t183;
        let t428 = c7 * t152 - t426;
        let t430 = t400 + c6 * t425;
        let t432 = s6 * t425 - t403;
        let t437 = z1_5_z * t432 + (z1_6_z * t428 - t166 * t430);
        let t442 = t175 * t428 - t172 * t430 - z2_4_y * t432;
        let t447 = c4 * t432 - (t176 * t430 + z3_5_y * t428);
        let t450 = s5 * t430 - c5 * t428;
        put(5, t437); // row 1, YY
        put(15, t442); // row 2, YY
        put(25, t447); // row 3, YY
        put(35, t450); // row 4, YY
        put(44, t432); // row 5, YY
        put(53, t428); // row 6, YY
        [t423, t426]
    };
    // payload: column ZZ
    let t477 = {
        let t451 = t394 - t423;
        let t452 = t397 + t426;
        let t455 = c6 * t451 - s6 * dw7_z;
        let t458 = s6 * t451 + c6 * dw7_z;
        let t463 = z1_5_z * t458 - (t166 * t455 - z1_6_z * t452);
        let t468 = t175 * t452 - t172 * t455 - z2_4_y * t458;
        let t473 = c4 * t458 - (t176 * t455 + z3_5_y * t452);
        let t476 = s5 * t455 - c5 * t452;
        let t477 = t178 - t179;
        put(6, t463); // row 1, ZZ
        put(16, t468); // row 2, ZZ
        put(26, t473); // row 3, ZZ
        put(36, t476); // row 4, ZZ
        put(45, t458); // row 5, ZZ
        put(54, t452); // row 6, ZZ
        put(63, t477); // row 7, XY
        t477
    };
    // payload: column XY
    let t508 = {
        let t480 = s7 * t191 - c7 * t190;
        let t483 = s7 * t190 + c7 * t191;
        let t486 = c6 * t480 - s6 * t477;
        let t489 = s6 * t480 + c6 * t477;
        let t494 = z1_5_z * t489 - (t166 * t486 - z1_6_z * t483);
        let t499 = t175 * t483 - t172 * t486 - z2_4_y * t489;
        let t504 = c4 * t489 - (t176 * t486 + z3_5_y * t483);
        let t507 = s5 * t486 - c5 * t483;
        let t508 = t178 - t180;
        put(7, t494); // row 1, XY
        put(17, t499); // row 2, XY
        put(27, t504); // row 3, XY
        put(37, t507); // row 4, XY
        put(46, t489); // row 5, XY
        put(55, t483); // row 6, XY
        t508
    };
    // payload: column XZ
    let t537 = {
        let t510 = t234 + s7 * t508;
        let t512 = c7 * t508 - t231;
        let t515 = c6 * t510 - s6 * t189;
        let t518 = s6 * t510 + c6 * t189;
        let t523 = z1_5_z * t518 - (t166 * t515 - z1_6_z * t512);
        let t528 = t175 * t512 - t172 * t515 - z2_4_y * t518;
        let t533 = c4 * t518 - (t176 * t515 + z3_5_y * t512);
        let t536 = s5 * t515 - c5 * t512;
        let t537 = t180 - t179;
        put(8, t523); // row 1, XZ
        put(18, t528); // row 2, XZ
        put(28, t533); // row 3, XZ
        put(38, t536); // row 4, XZ
        put(47, t518); // row 5, XZ
        put(56, t512); // row 6, XZ
        t537
    };
    // payload: column YZ
    {
        let t539 = t290 + c7 * t537;
        let t541 = s7 * t537 - t287;
        let t544 = c6 * t539 + s6 * t186;
        let t547 = c6 * t186 - s6 * t539;
        let t552 = z1_5_z * t547 + (t166 * t544 + z1_6_z * t541);
        let t557 = t172 * t544 + t175 * t541 - z2_4_y * t547;
        let t562 = c4 * t547 + (t176 * t544 - z3_5_y * t541);
        let t566 = -(s5 * t544 + c5 * t541);
        let t567 = -t237;
        let t568 = -t398;
        let t569 = -t181;
        put(9, t552); // row 1, YZ
        put(19, t557); // row 2, YZ
        put(29, t562); // row 3, YZ
        put(39, t566); // row 4, YZ
        put(48, t547); // row 5, YZ
        put(49, t567); // row 6, MSX
        put(52, t568); // row 6, XX
        put(57, t541); // row 6, YZ
        put(61, t569); // row 7, YY
    }
}
