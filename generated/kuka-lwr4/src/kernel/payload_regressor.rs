//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin (the paper's (7)).
//!
//! 350 multiplications, 225 additions; 7 x 10, 66 of 70 structurally nonzero.

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
    let flat = &mut out.as_flattened_mut()[..];
    flat[40] = S::default();
    flat[50] = S::default();
    flat[60] = S::default();
    flat[63] = S::default();
    nonzeros(trig, dq, ddq, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 10]; 7]) {
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
    let [a2_x, a2_y, w2_x, w2_y, t12, t13, t14, t15] = {
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t10 = dq2 * w2_y;
        let dw2_x = s2 * ddq1 + t10;
        let t12 = dq2 * w2_x - c2 * ddq1;
        let t13 = w2_x * w2_y - ddq2;
        let t14 = w2_x * w2_x + dq2 * dq2;
        let t15 = t10 + dw2_x;
        [a2_x, a2_y, w2_x, w2_y, t12, t13, t14, t15]
    };
    // link 3: motion
    let [
        z1_3_x, t17, t22, t25, t28, t31, t34, w3_z,
        dw3_y, t48, t49,
    ] = {
        let z1_3_x = s2 * c3;
        let t17 = s2 * s3;
        let t20 = L2 * t15;
        let t21 = a2_x + L2 * t13;
        let t22 = L2 * t14 - a2_y;
        let t25 = s3 * t20 - c3 * t21;
        let t28 = c3 * t20 + s3 * t21;
        let t31 = s3 * dq2 - c3 * w2_x;
        let t34 = c3 * dq2 + s3 * w2_x;
        let w3_z = w2_y + dq3;
        let t45 = t34 * w3_z;
        let dw3_x = c3 * t15 + s3 * t13 - t45;
        let dw3_y = c3 * t13 - s3 * t15 + t31 * w3_z;
        let t48 = t12 - ddq3 + t31 * t34;
        let t49 = t45 - dw3_x;
        [
        z1_3_x, t17, t22, t25, t28, t31, t34, w3_z,
        dw3_y, t48, t49,
    ]
    };
    // link 4: motion
    let [
        t52, t55, t58, t61, t68, t76, t77, t78,
        t79,
    ] = {
        let t52 = c4 * t25 - s4 * t22;
        let t55 = c4 * t22 + s4 * t25;
        let t58 = c4 * t31 + s4 * w3_z;
        let t61 = c4 * w3_z - s4 * t31;
        let t68 = t34 - dq4;
        let dw4_z = dw3_y + ddq4;
        let t74 = t61 * t68;
        let t76 = c4 * t48 + s4 * t49 - t58 * t68;
        let t77 = t58 * t61 - dw4_z;
        let t78 = t58 * t58 + t68 * t68;
        let t79 = c4 * t49 - s4 * t48 - t74 - t74;
        [
        t52, t55, t58, t61, t68, t76, t77, t78,
        t79,
    ]
    };
    // link 5: motion
    let [
        t84, t88, a5_y, t94, t97, w5_z, dw5_y, t111,
        t112,
    ] = {
        let t83 = t52 + L3 * t77;
        let t84 = t55 + L3 * t78;
        let t85 = L3 * t79 - t28;
        let t88 = c5 * t83 - s5 * t85;
        let a5_y = c5 * t85 + s5 * t83;
        let t94 = c5 * t58 + s5 * t68;
        let t97 = c5 * t68 - s5 * t58;
        let w5_z = t61 + dq5;
        let dw5_z = ddq5 - t76;
        let t108 = t97 * w5_z;
        let dw5_y = s5 * t79 - c5 * t77 + t94 * w5_z;
        let t111 = dw5_z - t94 * t97;
        let t112 = t108 + (c5 * t79 + s5 * t77 + t108);
        [
        t84, t88, a5_y, t94, t97, w5_z, dw5_y, t111,
        t112,
    ]
    };
    // link 6: motion
    let [
        t115, t118, w6_x, w6_y, w6_z, t139, t140, t141,
        t142,
    ] = {
        let t115 = c6 * t88 + s6 * t84;
        let t118 = c6 * t84 - s6 * t88;
        let w6_x = s6 * w5_z - c6 * t94;
        let w6_y = c6 * w5_z + s6 * t94;
        let w6_z = t97 + dq6;
        let dw6_z = ddq6 - dw5_y;
        let t137 = w6_y * w6_z;
        let dw6_x = s6 * t111 - c6 * t112 + t137;
        let t139 = c6 * t111 + s6 * t112 - w6_x * w6_z;
        let t140 = w6_x * w6_y - dw6_z;
        let t141 = w6_x * w6_x + w6_z * w6_z;
        let t142 = t137 + dw6_x;
        [
        t115, t118, w6_x, w6_y, w6_z, t139, t140, t141,
        t142,
    ]
    };
    // link 7: motion
    let [
        t145, a7_y, t157, t160, dw7_z, t165, t166, t167,
        dw7_x, t169, t170, t171, t172, t173, t174, t175,
        t176,
    ] = {
        let t145 = c7 * t115 - s7 * a5_y;
        let a7_y = c7 * a5_y + s7 * t115;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t154 = c7 * w6_z + s7 * w6_x;
        let t157 = c7 * t140 - s7 * t142;
        let t160 = c7 * t142 + s7 * t140;
        let w7_z = w6_y + dq7;
        let dw7_z = t139 + ddq7;
        let t163 = w7_x * w7_x;
        let t164 = w7_z * w7_z;
        let t165 = w7_x * t154;
        let t166 = w7_x * w7_z;
        let t167 = t154 * w7_z;
        let dw7_x = t160 - t167;
        let t169 = t166 - t157;
        let t170 = t163 - t164;
        let t171 = t170 - t141;
        let t172 = dw7_z + t165;
        let t173 = t165 - dw7_z;
        let t174 = t163 + t164;
        let t175 = t166 + t169;
        let t176 = t167 - dw7_x;
        put(58, a7_y); // row 7, MSX
        put(59, t145); // row 7, MSY
        put(60, t165); // row 7, XX
        put(62, dw7_z); // row 7, ZZ
        put(64, t160); // row 7, XZ
        put(65, t157); // row 7, YZ
        [
        t145, a7_y, t157, t160, dw7_z, t165, t166, t167,
        dw7_x, t169, t170, t171, t172, t173, t174, t175,
        t176,
    ]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_5_z, t183, z2_4_y] = {
        let z1_4_x = c4 * z1_3_x - c2 * s4;
        let z1_5_z = c2 * c4 + s4 * z1_3_x;
        let t183 = s3 * c4;
        let z2_4_y = s3 * s4;
        [z1_4_x, z1_5_z, t183, z2_4_y]
    };
    // joint axes in frame 5
    let [z1_5_x, z1_6_z, t193, t196, t197, z3_5_y] = {
        let z1_5_x = c5 * z1_4_x - s5 * t17;
        let z1_6_z = c5 * t17 + s5 * z1_4_x;
        let t193 = c5 * t183 + c3 * s5;
        let t196 = c3 * c5 - s5 * t183;
        let t197 = s4 * c5;
        let z3_5_y = s4 * s5;
        [z1_5_x, z1_6_z, t193, t196, t197, z3_5_y]
    };
    // payload: column M
    let [t201, t204] = {
        let t201 = c7 * t145 + s7 * a7_y;
        let t204 = s7 * t145 - c7 * a7_y;
        let t207 = s6 * t118 - c6 * t201;
        let t213 = c5 * t207 + s5 * t204;
        let t216 = s5 * t207 - c5 * t204;
        let t217 = L3 * t216;
        let t218 = L3 * t213;
        let t223 = s4 * t217;
        let t226 = c4 * t217 + L2 * t216;
        let t227 = t218 + L2 * (c4 * t213 - s4 * (s6 * t201 + c6 * t118));
        let t232 = c2 * t223 - (z1_3_x * t226 + t17 * t227);
        let t235 = s3 * t226 - c3 * t227;
        put(0, t232); // row 1, M
        put(10, t235); // row 2, M
        put(20, t223); // row 3, M
        put(30, t218); // row 4, M
        put(51, t201); // row 6, MSZ
        [t201, t204]
    };
    // payload: column MSX
    let [t237, t240, t242, t243] = {
        let t237 = s7 * t173;
        let t238 = c7 * t171 + t237;
        let t240 = c7 * t173;
        let t241 = t240 - s7 * t171;
        let t242 = s7 * t118;
        let t243 = c7 * t118;
        let t246 = c6 * t238 - s6 * t175;
        let t252 = c6 * t242 + s6 * a7_y;
        let t255 = c6 * a7_y - s6 * t242;
        let t258 = c5 * t246 + s5 * t241;
        let t261 = s5 * t246 - c5 * t241;
        let t270 = c5 * t252 + s5 * t243 + L3 * t261;
        let t271 = L3 * t258 - (s5 * t252 - c5 * t243);
        let t280 = s4 * t270 + c4 * t255;
        let t283 = c4 * t270 - s4 * t255 + L2 * t261;
        let t284 = t271 + L2 * (c4 * t258 + s4 * (s6 * t238 + c6 * t175));
        let t289 = c2 * t280 - (z1_3_x * t283 + t17 * t284);
        let t292 = s3 * t283 - c3 * t284;
        put(1, t289); // row 1, MSX
        put(11, t292); // row 2, MSX
        put(21, t280); // row 3, MSX
        put(31, t271); // row 4, MSX
        put(40, t255); // row 5, MSX
        put(50, t242); // row 6, MSY
        [t237, t240, t242, t243]
    };
    // payload: column MSY
    let [t293, t296] = {
        let t293 = c7 * t172;
        let t295 = s7 * t174 - t293;
        let t296 = s7 * t172;
        let t298 = t296 + c7 * t174;
        let t301 = c6 * t295 + s6 * t176;
        let t307 = c6 * t243 + s6 * t145;
        let t310 = c6 * t145 - s6 * t243;
        let t313 = c5 * t301 + s5 * t298;
        let t316 = s5 * t301 - c5 * t298;
        let t325 = c5 * t307 - s5 * t242 + L3 * t316;
        let t326 = L3 * t313 - (s5 * t307 + c5 * t242);
        let t335 = s4 * t325 + c4 * t310;
        let t338 = c4 * t325 - s4 * t310 + L2 * t316;
        let t339 = L2 * (s4 * (c6 * t176 - s6 * t295) - c4 * t313) - t326;
        let t344 = c2 * t335 + (t17 * t339 - z1_3_x * t338);
        let t347 = s3 * t338 + c3 * t339;
        put(2, t344); // row 1, MSY
        put(12, t347); // row 2, MSY
        put(22, t335); // row 3, MSY
        put(32, t326); // row 4, MSY
        put(41, t310); // row 5, MSY
        [t293, t296]
    };
    // payload: column MSZ
    {
        let t350 = c7 * t157 + s7 * t160;
        let t353 = s7 * t157 - c7 * t160;
        let t356 = c6 * t350 + s6 * t141;
        let t360 = c6 * t204;
        let t361 = s6 * t204;
        let t364 = c5 * t356 - s5 * t353;
        let t367 = s5 * t356 + c5 * t353;
        let t376 = L3 * t367 - (c5 * t360 + s5 * t201);
        let t377 = L3 * t364 - (c5 * t201 - s5 * t360);
        let t386 = s4 * t376 + c4 * t361;
        let t389 = c4 * t376 - s4 * t361 + L2 * t367;
        let t390 = t377 + L2 * (c4 * t364 - s4 * (c6 * t141 - s6 * t350));
        let t395 = c2 * t386 - (z1_3_x * t389 + t17 * t390);
        let t398 = s3 * t389 - c3 * t390;
        put(3, t395); // row 1, MSZ
        put(13, t398); // row 2, MSZ
        put(23, t386); // row 3, MSZ
        put(33, t377); // row 4, MSZ
        put(42, t361); // row 5, MSZ
    }
    // payload: column XX
    let [t400, t403, t404, t406, t409] = {
        let t400 = s7 * t166;
        let t401 = c7 * dw7_x - t400;
        let t403 = c7 * t166;
        let t404 = s7 * dw7_x + t403;
        let t406 = s6 * t165;
        let t407 = t406 - c6 * t401;
        let t409 = c6 * t165;
        let t410 = s6 * t401 + t409;
        let t415 = z1_5_z * t410 - (z1_5_x * t407 + z1_6_z * t404);
        let t420 = t193 * t407 - t196 * t404 - z2_4_y * t410;
        let t425 = c4 * t410 + (t197 * t407 + z3_5_y * t404);
        let t428 = c5 * t404 - s5 * t407;
        put(4, t415); // row 1, XX
        put(14, t420); // row 2, XX
        put(24, t425); // row 3, XX
        put(34, t428); // row 4, XX
        put(43, t410); // row 5, XX
        [t400, t403, t404, t406, t409]
    };
    // payload: column YY
    let [t429, t432] = {
        let t429 = c7 * t167;
        let t431 = t429 + s7 * t169;
        let t432 = s7 * t167;
        let t434 = c7 * t169 - t432;
        let t436 = t406 + c6 * t431;
        let t438 = s6 * t431 - t409;
        let t443 = z1_5_z * t438 + (z1_5_x * t436 + z1_6_z * t434);
        let t448 = t196 * t434 - t193 * t436 - z2_4_y * t438;
        let t453 = c4 * t438 - (t197 * t436 + z3_5_y * t434);
        let t456 = s5 * t436 - c5 * t434;
        put(5, t443); // row 1, YY
        put(15, t448); // row 2, YY
        put(25, t453); // row 3, YY
        put(35, t456); // row 4, YY
        put(44, t438); // row 5, YY
        put(53, t434); // row 6, YY
        [t429, t432]
    };
    // payload: column ZZ
    let t483 = {
        let t457 = t400 - t429;
        let t458 = t403 + t432;
        let t461 = c6 * t457 - s6 * dw7_z;
        let t464 = s6 * t457 + c6 * dw7_z;
        let t469 = z1_5_z * t464 + (z1_5_x * t461 + z1_6_z * t458);
        let t474 = t196 * t458 - t193 * t461 - z2_4_y * t464;
        let t479 = c4 * t464 - (t197 * t461 + z3_5_y * t458);
        let t482 = s5 * t461 - c5 * t458;
        let t483 = t171 + t174;
        put(6, t469); // row 1, ZZ
        put(16, t474); // row 2, ZZ
        put(26, t479); // row 3, ZZ
        put(36, t482); // row 4, ZZ
        put(45, t464); // row 5, ZZ
        put(54, t458); // row 6, ZZ
        put(63, t483); // row 7, XY
        t483
    };
    // payload: column XY
    {
        let t486 = s7 * t176 - c7 * t175;
        let t489 = s7 * t175 + c7 * t176;
        let t492 = c6 * t486 - s6 * t483;
        let t495 = s6 * t486 + c6 * t483;
        let t500 = z1_5_z * t495 + (z1_5_x * t492 + z1_6_z * t489);
        let t505 = t196 * t489 - t193 * t492 - z2_4_y * t495;
        let t510 = c4 * t495 - (t197 * t492 + z3_5_y * t489);
        let t513 = s5 * t492 - c5 * t489;
        put(7, t500); // row 1, XY
        put(17, t505); // row 2, XY
        put(27, t510); // row 3, XY
        put(37, t513); // row 4, XY
        put(46, t495); // row 5, XY
        put(55, t489); // row 6, XY
    }
    // payload: column XZ
    let t542 = {
        let t515 = s7 * t170 - t240;
        let t517 = t237 + c7 * t170;
        let t520 = c6 * t515 - s6 * t160;
        let t523 = s6 * t515 + c6 * t160;
        let t528 = z1_5_z * t523 + (z1_5_x * t520 + z1_6_z * t517);
        let t533 = t196 * t517 - t193 * t520 - z2_4_y * t523;
        let t538 = c4 * t523 - (t197 * t520 + z3_5_y * t517);
        let t541 = s5 * t520 - c5 * t517;
        let t542 = t174 - t141;
        put(8, t528); // row 1, XZ
        put(18, t533); // row 2, XZ
        put(28, t538); // row 3, XZ
        put(38, t541); // row 4, XZ
        put(47, t523); // row 5, XZ
        put(56, t517); // row 6, XZ
        t542
    };
    // payload: column YZ
    {
        let t544 = t296 + c7 * t542;
        let t546 = s7 * t542 - t293;
        let t549 = c6 * t544 + s6 * t157;
        let t552 = c6 * t157 - s6 * t544;
        let t557 = z1_5_z * t552 - (z1_5_x * t549 - z1_6_z * t546);
        let t562 = t193 * t549 + t196 * t546 - z2_4_y * t552;
        let t567 = c4 * t552 - (z3_5_y * t546 - t197 * t549);
        let t571 = -(s5 * t549 + c5 * t546);
        let t572 = -t243;
        let t573 = -t404;
        let t574 = -t165;
        put(9, t557); // row 1, YZ
        put(19, t562); // row 2, YZ
        put(29, t567); // row 3, YZ
        put(39, t571); // row 4, YZ
        put(48, t552); // row 5, YZ
        put(49, t572); // row 6, MSX
        put(52, t573); // row 6, XX
        put(57, t546); // row 6, YZ
        put(61, t574); // row 7, YY
    }
}
