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
    let [w2_x, w2_y, a2_x, a2_y, dw2_y, t13, t14, t15] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let t10 = dq2 * w2_y;
        let dw2_x = s2 * ddq1 + t10;
        let dw2_y = c2 * ddq1 - dq2 * w2_x;
        let t13 = w2_x * w2_y - ddq2;
        let t14 = w2_x * w2_x + dq2 * dq2;
        let t15 = t10 + dw2_x;
        [w2_x, w2_y, a2_x, a2_y, dw2_y, t13, t14, t15]
    };
    // link 3: motion
    let [
        t18, t21, a3_z, t29, t32, w3_z, t45, t46,
        t47,
    ] = {
        let t18 = s3 * dq2 - c3 * w2_x;
        let t21 = c3 * dq2 + s3 * w2_x;
        let t24 = L2 * t15;
        let t25 = a2_x + L2 * t13;
        let a3_z = a2_y - L2 * t14;
        let t29 = s3 * t24 - c3 * t25;
        let t32 = c3 * t24 + s3 * t25;
        let w3_z = w2_y + dq3;
        let dw3_z = dw2_y + ddq3;
        let t43 = t21 * w3_z;
        let dw3_x = c3 * t15 + s3 * t13 - t43;
        let t45 = s3 * t15 - c3 * t13 - t18 * w3_z;
        let t46 = t18 * t21 - dw3_z;
        let t47 = dw3_x - t43;
        [
        t18, t21, a3_z, t29, t32, w3_z, t45, t46,
        t47,
    ]
    };
    // link 4: motion
    let [
        t50, t53, t56, t59, t66, t74, t75, t76,
        t77,
    ] = {
        let t50 = c4 * t18 + s4 * w3_z;
        let t53 = s4 * t18 - c4 * w3_z;
        let t56 = c4 * t29 + s4 * a3_z;
        let t59 = s4 * t29 - c4 * a3_z;
        let t66 = t21 - dq4;
        let t72 = t53 * t66;
        let t74 = c4 * t46 - s4 * t47 - t50 * t66;
        let t75 = t45 - ddq4 - t50 * t53;
        let t76 = t50 * t50 + t66 * t66;
        let t77 = t72 - (c4 * t47 + s4 * t46 - t72);
        [
        t50, t53, t56, t59, t66, t74, t75, t76,
        t77,
    ]
    };
    // link 5: motion
    let [
        t80, w5_y, t88, t92, a5_y, w5_z, t108, t109,
        t110,
    ] = {
        let t80 = c5 * t50 + s5 * t66;
        let w5_y = s5 * t50 - c5 * t66;
        let t87 = t56 + L3 * t75;
        let t88 = t59 + L3 * t76;
        let t89 = t32 - L3 * t77;
        let t92 = c5 * t87 + s5 * t89;
        let a5_y = s5 * t87 - c5 * t89;
        let w5_z = dq5 - t53;
        let t106 = w5_y * w5_z;
        let dw5_x = t106 - (c5 * t77 + s5 * t75);
        let t108 = c5 * t75 - s5 * t77 - t80 * w5_z;
        let t109 = t80 * w5_y - (t74 - ddq5);
        let t110 = t106 + dw5_x;
        [
        t80, w5_y, t88, t92, a5_y, w5_z, t108, t109,
        t110,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t119, t122, t129, t137, t138, t139,
        t140,
    ] = {
        let w6_x = s6 * w5_z - c6 * t80;
        let w6_y = c6 * w5_z + s6 * t80;
        let t119 = c6 * t92 + s6 * t88;
        let t122 = c6 * t88 - s6 * t92;
        let t129 = w5_y - dq6;
        let dw6_z = t108 + ddq6;
        let t135 = w6_y * t129;
        let dw6_x = c6 * t110 + s6 * t109 - t135;
        let t137 = c6 * t109 - s6 * t110 + w6_x * t129;
        let t138 = w6_x * w6_y - dw6_z;
        let t139 = w6_x * w6_x + t129 * t129;
        let t140 = t135 - dw6_x;
        [
        w6_x, w6_y, t119, t122, t129, t137, t138, t139,
        t140,
    ]
    };
    // link 7: motion
    let [
        t149, a7_y, t155, t158, dw7_z, t163, t164, t165,
        t166, t167, t168, t169, t170, t171, t172, t173,
        t174,
    ] = {
        let w7_x = c7 * w6_x + s7 * t129;
        let t146 = s7 * w6_x - c7 * t129;
        let t149 = c7 * t119 - s7 * a5_y;
        let a7_y = c7 * a5_y + s7 * t119;
        let t155 = c7 * t138 + s7 * t140;
        let t158 = s7 * t138 - c7 * t140;
        let w7_z = w6_y + dq7;
        let dw7_z = t137 + ddq7;
        let t161 = w7_x * w7_x;
        let t162 = w7_z * w7_z;
        let t163 = w7_x * t146;
        let t164 = w7_x * w7_z;
        let t165 = t146 * w7_z;
        let t166 = t165 - t158;
        let t167 = t164 - t155;
        let t168 = t161 - t162;
        let t169 = t168 - t139;
        let t170 = dw7_z + t163;
        let t171 = dw7_z - t163;
        let t172 = t161 + t162;
        let t173 = t164 + t167;
        let t174 = t165 + t166;
        put(58, a7_y); // row 7, MSX
        put(59, t149); // row 7, MSY
        put(60, t163); // row 7, XX
        put(62, dw7_z); // row 7, ZZ
        put(64, t158); // row 7, XZ
        put(65, t155); // row 7, YZ
        [
        t149, a7_y, t155, t158, dw7_z, t163, t164, t165,
        t166, t167, t168, t169, t170, t171, t172, t173,
        t174,
    ]
    };
    // joint axes in frame 3
    let [z1_3_x, t176] = {
        let z1_3_x = s2 * c3;
        let t176 = s2 * s3;
        [z1_3_x, t176]
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
        let z1_5_x = c5 * z1_4_x - s5 * t176;
        let z1_6_z = c5 * t176 + s5 * z1_4_x;
        let t193 = c5 * t183 + c3 * s5;
        let t196 = c3 * c5 - s5 * t183;
        let t197 = s4 * c5;
        let z3_5_y = s4 * s5;
        [z1_5_x, z1_6_z, t193, t196, t197, z3_5_y]
    };
    // payload: column M
    let [t201, t204] = {
        let t201 = c7 * t149 + s7 * a7_y;
        let t204 = s7 * t149 - c7 * a7_y;
        let t207 = s6 * t122 - c6 * t201;
        let t213 = c5 * t207 + s5 * t204;
        let t216 = s5 * t207 - c5 * t204;
        let t217 = L3 * t216;
        let t218 = L3 * t213;
        let t223 = s4 * t217;
        let t226 = c4 * t217 + L2 * t216;
        let t227 = L2 * (s4 * (s6 * t201 + c6 * t122) - c4 * t213) - t218;
        let t232 = c2 * t223 + (t176 * t227 - z1_3_x * t226);
        let t235 = s3 * t226 + c3 * t227;
        put(0, t232); // row 1, M
        put(10, t235); // row 2, M
        put(20, t223); // row 3, M
        put(30, t218); // row 4, M
        put(51, t201); // row 6, MSZ
        [t201, t204]
    };
    // payload: column MSX
    let [t237, t240, t242, t243] = {
        let t237 = s7 * t171;
        let t238 = c7 * t169 - t237;
        let t240 = c7 * t171;
        let t241 = s7 * t169 + t240;
        let t242 = s7 * t122;
        let t243 = c7 * t122;
        let t246 = c6 * t238 - s6 * t173;
        let t252 = c6 * t242 + s6 * a7_y;
        let t255 = c6 * a7_y - s6 * t242;
        let t258 = c5 * t246 - s5 * t241;
        let t261 = s5 * t246 + c5 * t241;
        let t270 = c5 * t252 + s5 * t243 + L3 * t261;
        let t271 = L3 * t258 - (s5 * t252 - c5 * t243);
        let t280 = s4 * t270 + c4 * t255;
        let t283 = c4 * t270 - s4 * t255 + L2 * t261;
        let t284 = t271 + L2 * (c4 * t258 + s4 * (s6 * t238 + c6 * t173));
        let t289 = c2 * t280 - (z1_3_x * t283 + t176 * t284);
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
        let t293 = c7 * t170;
        let t295 = t293 - s7 * t172;
        let t296 = s7 * t170;
        let t298 = t296 + c7 * t172;
        let t301 = s6 * t174 - c6 * t295;
        let t307 = c6 * t243 + s6 * t149;
        let t310 = c6 * t149 - s6 * t243;
        let t313 = c5 * t301 + s5 * t298;
        let t316 = s5 * t301 - c5 * t298;
        let t325 = c5 * t307 - s5 * t242 + L3 * t316;
        let t326 = L3 * t313 - (s5 * t307 + c5 * t242);
        let t335 = s4 * t325 + c4 * t310;
        let t338 = c4 * t325 - s4 * t310 + L2 * t316;
        let t339 = t326 - L2 * (s4 * (s6 * t295 + c6 * t174) - c4 * t313);
        let t344 = c2 * t335 - (z1_3_x * t338 + t176 * t339);
        let t347 = s3 * t338 - c3 * t339;
        put(2, t344); // row 1, MSY
        put(12, t347); // row 2, MSY
        put(22, t335); // row 3, MSY
        put(32, t326); // row 4, MSY
        put(41, t310); // row 5, MSY
        [t293, t296]
    };
    // payload: column MSZ
    {
        let t350 = c7 * t155 + s7 * t158;
        let t353 = c7 * t158 - s7 * t155;
        let t356 = c6 * t350 + s6 * t139;
        let t360 = c6 * t204;
        let t361 = s6 * t204;
        let t364 = c5 * t356 + s5 * t353;
        let t367 = s5 * t356 - c5 * t353;
        let t376 = c5 * t360 + s5 * t201 - L3 * t367;
        let t377 = s5 * t360 - c5 * t201 + L3 * t364;
        let t386 = c4 * t361 - s4 * t376;
        let t389 = L2 * t367 - (c4 * t376 + s4 * t361);
        let t390 = t377 + L2 * (c4 * t364 - s4 * (c6 * t139 - s6 * t350));
        let t395 = c2 * t386 - (z1_3_x * t389 + t176 * t390);
        let t398 = s3 * t389 - c3 * t390;
        put(3, t395); // row 1, MSZ
        put(13, t398); // row 2, MSZ
        put(23, t386); // row 3, MSZ
        put(33, t377); // row 4, MSZ
        put(42, t361); // row 5, MSZ
    }
    // payload: column XX
    let [t400, t403, t406, t409, t428] = {
        let t400 = s7 * t164;
        let t401 = c7 * t166 + t400;
        let t403 = c7 * t164;
        let t404 = s7 * t166 - t403;
        let t406 = s6 * t163;
        let t407 = c6 * t401 + t406;
        let t409 = c6 * t163;
        let t410 = t409 - s6 * t401;
        let t415 = z1_5_z * t410 - (z1_5_x * t407 - z1_6_z * t404);
        let t420 = t193 * t407 + t196 * t404 - z2_4_y * t410;
        let t425 = c4 * t410 + (t197 * t407 - z3_5_y * t404);
        let t428 = s5 * t407 + c5 * t404;
        put(4, t415); // row 1, XX
        put(14, t420); // row 2, XX
        put(24, t425); // row 3, XX
        put(43, t410); // row 5, XX
        put(52, t404); // row 6, XX
        [t400, t403, t406, t409, t428]
    };
    // payload: column YY
    let [t429, t432] = {
        let t429 = c7 * t165;
        let t431 = t429 + s7 * t167;
        let t432 = s7 * t165;
        let t434 = c7 * t167 - t432;
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
        let t483 = t169 + t172;
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
        let t486 = s7 * t174 - c7 * t173;
        let t489 = s7 * t173 + c7 * t174;
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
        let t515 = t240 + s7 * t168;
        let t517 = c7 * t168 - t237;
        let t520 = c6 * t515 - s6 * t158;
        let t523 = s6 * t515 + c6 * t158;
        let t528 = z1_5_z * t523 + (z1_5_x * t520 + z1_6_z * t517);
        let t533 = t196 * t517 - t193 * t520 - z2_4_y * t523;
        let t538 = c4 * t523 - (t197 * t520 + z3_5_y * t517);
        let t541 = s5 * t520 - c5 * t517;
        let t542 = t139 - t172;
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
        let t544 = t296 - c7 * t542;
        let t546 = t293 + s7 * t542;
        let t549 = c6 * t544 + s6 * t155;
        let t552 = c6 * t155 - s6 * t544;
        let t557 = z1_5_z * t552 - (z1_5_x * t549 + z1_6_z * t546);
        let t562 = t193 * t549 - t196 * t546 - z2_4_y * t552;
        let t567 = c4 * t552 + (t197 * t549 + z3_5_y * t546);
        let t570 = c5 * t546 - s5 * t549;
        let t571 = -t428;
        let t572 = -t243;
        let t573 = -t546;
        let t574 = -t163;
        put(9, t557); // row 1, YZ
        put(19, t562); // row 2, YZ
        put(29, t567); // row 3, YZ
        put(34, t571); // row 4, XX
        put(39, t570); // row 4, YZ
        put(48, t552); // row 5, YZ
        put(49, t572); // row 6, MSX
        put(57, t573); // row 6, YZ
        put(61, t574); // row 7, YY
    }
}
