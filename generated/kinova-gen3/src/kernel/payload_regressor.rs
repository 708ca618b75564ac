//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin (the paper's (7)).
//!
//! 426 multiplications, 284 additions; 7 x 10, 68 of 70 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 68;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9),
    (1, 0), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7), (1, 8), (1, 9),
    (2, 0), (2, 1), (2, 2), (2, 3), (2, 4), (2, 5), (2, 6), (2, 7), (2, 8), (2, 9),
    (3, 0), (3, 1), (3, 2), (3, 3), (3, 4), (3, 5), (3, 6), (3, 7), (3, 8), (3, 9),
    (4, 0), (4, 1), (4, 2), (4, 3), (4, 4), (4, 5), (4, 6), (4, 7), (4, 8), (4, 9),
    (5, 0), (5, 1), (5, 2), (5, 3), (5, 4), (5, 5), (5, 6), (5, 7), (5, 8), (5, 9),
    (6, 1), (6, 2), (6, 4), (6, 5), (6, 6), (6, 7), (6, 8), (6, 9),
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
    let k0 = S::constant(9.81);
    let k1 = S::constant(0.01175);
    let k2 = S::constant(0.42076);
    let k3 = S::constant(0.01275);
    let k4 = S::constant(0.31436);
    let k5 = S::constant(0.00035);
    let k6 = S::constant(0.167455);
    // link 2: motion
    let [w2_x, w2_y, a2_z, t10, t12, t13, dw2_x, t16] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t7 = ddq1 * k1;
        let a2_z = dq1 * dq1 * k1;
        let t10 = s2 * k0 + c2 * t7;
        let t12 = c2 * k0 - s2 * t7;
        let t13 = dq2 * w2_y;
        let dw2_x = s2 * ddq1 + t13;
        let t16 = dq2 * w2_x - c2 * ddq1;
        [w2_x, w2_y, a2_z, t10, t12, t13, dw2_x, t16]
    };
    // link 3: motion
    let [
        w3_x, t22, a3_z, t43, a3_y, w3_z, t50, t51,
        t52,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t22 = c3 * dq2 + s3 * w2_x;
        let t38 = t10 + (w2_x * w2_y - ddq2) * k2;
        let a3_z = (w2_x * w2_x + dq2 * dq2) * k2 - t12;
        let t40 = (t13 + dw2_x) * k2 - a2_z;
        let t43 = c3 * t38 - s3 * t40;
        let a3_y = c3 * t40 + s3 * t38;
        let w3_z = w2_y + dq3;
        let t50 = s3 * ddq2 - c3 * dw2_x + dq3 * t22;
        let t51 = c3 * ddq2 + s3 * dw2_x + dq3 * w3_x;
        let t52 = t16 - ddq3;
        [
        w3_x, t22, a3_z, t43, a3_y, w3_z, t50, t51,
        t52,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t76, a4_x, a4_y, w4_z, t87, t88,
        dw4_z,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t75 = t43 - (t52 - w3_x * t22) * k3;
        let t76 = (w3_x * w3_x + w3_z * w3_z) * k3 - a3_y;
        let t77 = a3_z - (t50 + t22 * w3_z) * k3;
        let a4_x = s4 * t77 - c4 * t75;
        let a4_y = c4 * t77 + s4 * t75;
        let w4_z = t22 + dq4;
        let t87 = c4 * t50 + s4 * t52 - dq4 * w4_y;
        let t88 = c4 * t52 - s4 * t50 + dq4 * w4_x;
        let dw4_z = t51 + ddq4;
        [
        w4_x, w4_y, t76, a4_x, a4_y, w4_z, t87, t88,
        dw4_z,
    ]
    };
    // link 5: motion
    let [
        t92, t95, a5_z, t117, a5_y, w5_z, t124, t125,
        t126,
    ] = {
        let t92 = s5 * w4_z - c5 * w4_x;
        let t95 = c5 * w4_z + s5 * w4_x;
        let t112 = (w4_x * w4_y - dw4_z) * k4 - a4_x;
        let a5_z = a4_y + (w4_x * w4_x + w4_z * w4_z) * k4;
        let t114 = t76 + (t87 - w4_y * w4_z) * k4;
        let t117 = c5 * t112 + s5 * t114;
        let a5_y = s5 * t112 - c5 * t114;
        let w5_z = w4_y + dq5;
        let t124 = c5 * t87 + s5 * dw4_z + dq5 * t95;
        let t125 = s5 * t87 - c5 * dw4_z + dq5 * t92;
        let t126 = t88 - ddq5;
        [
        t92, t95, a5_z, t117, a5_y, w5_z, t124, t125,
        t126,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t150, t154, a6_y, w6_z, dw6_x, dw6_y,
        dw6_z,
    ] = {
        let w6_x = s6 * w5_z - c6 * t92;
        let w6_y = c6 * w5_z + s6 * t92;
        let t149 = t117 - (t126 + t92 * t95) * k5;
        let t150 = a5_y - (t92 * t92 + w5_z * w5_z) * k5;
        let t151 = (t124 + t95 * w5_z) * k5 - a5_z;
        let t154 = c6 * t149 + s6 * t151;
        let a6_y = s6 * t149 - c6 * t151;
        let w6_z = t95 + dq6;
        let dw6_x = dq6 * w6_y - (c6 * t124 + s6 * t126);
        let dw6_y = s6 * t124 - c6 * t126 - dq6 * w6_x;
        let dw6_z = ddq6 - t125;
        [
        w6_x, w6_y, t150, t154, a6_y, w6_z, dw6_x, dw6_y,
        dw6_z,
    ]
    };
    // link 7: motion
    let [
        w7_x, t169, a7_z, a7_x, a7_y, w7_z, t198, t199,
        dw7_z,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t169 = c7 * w6_z + s7 * w6_x;
        let t186 = (dw6_z - w6_x * w6_y) * k6 - t154;
        let a7_z = a6_y + (w6_x * w6_x + w6_z * w6_z) * k6;
        let t188 = t150 + (dw6_x + w6_y * w6_z) * k6;
        let a7_x = c7 * t186 + s7 * t188;
        let a7_y = c7 * t188 - s7 * t186;
        let w7_z = w6_y + dq7;
        let t198 = dq7 * t169 - (c7 * dw6_x - s7 * dw6_z);
        let t199 = c7 * dw6_z + s7 * dw6_x + dq7 * w7_x;
        let dw7_z = dw6_y + ddq7;
        put(60, a7_y); // row 7, MSX
        put(64, dw7_z); // row 7, ZZ
        [
        w7_x, t169, a7_z, a7_x, a7_y, w7_z, t198, t199,
        dw7_z,
    ]
    };
    // joint axes in frame 2
    let [t201, v1_2_y] = {
        let t201 = c2 * k1;
        let v1_2_y = s2 * k1;
        [t201, v1_2_y]
    };
    // joint axes in frame 3
    let [z1_3_x, z1_4_z, v1_3_x, v1_3_y, v2_3_x, v2_4_z] = {
        let t203 = s2 * k2;
        let z1_3_x = s2 * c3;
        let z1_4_z = s2 * s3;
        let v1_3_x = s3 * t203 - c3 * t201;
        let v1_3_y = c3 * t203 + s3 * t201;
        let v2_3_x = c3 * k2;
        let v2_4_z = s3 * k2;
        [z1_3_x, z1_4_z, v1_3_x, v1_3_y, v2_3_x, v2_4_z]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, t220, z2_4_y, t222, t223, t226, t229] = {
        let z1_4_x = c4 * z1_3_x + c2 * s4;
        let z1_4_y = c2 * c4 - s4 * z1_3_x;
        let t220 = s3 * c4;
        let z2_4_y = s3 * s4;
        let t222 = c4 * v2_3_x;
        let t223 = s4 * v2_3_x;
        let t226 = c4 * v1_3_x + s4 * v1_2_y;
        let t229 = s4 * v1_3_x - c4 * v1_2_y;
        [z1_4_x, z1_4_y, t220, z2_4_y, t222, t223, t226, t229]
    };
    // joint axes in frame 5
    let [z1_5_x, z1_6_z, t238, t241, z3_5_x, z3_6_z] = {
        let z1_5_x = c5 * z1_4_x - s5 * z1_4_z;
        let z1_6_z = c5 * z1_4_z + s5 * z1_4_x;
        let t238 = c5 * t220 + c3 * s5;
        let t241 = c3 * c5 - s5 * t220;
        let z3_5_x = s4 * c5;
        let z3_6_z = s4 * s5;
        [z1_5_x, z1_6_z, t238, t241, z3_5_x, z3_6_z]
    };
    // joint axes in frame 7
    let [
        t244, t245, t246, t247, t248, t249, t250, t251,
        t252, t253, t254, t255, t256, t257, t258,
    ] = {
        let t244 = w7_x * w7_x;
        let t245 = t169 * t169;
        let t246 = w7_z * w7_z;
        let t247 = w7_x * t169;
        let t248 = w7_x * w7_z;
        let t249 = t169 * w7_z;
        let t250 = t245 + t246;
        let t251 = dw7_z + t247;
        let t252 = t248 - t199;
        let t253 = dw7_z - t247;
        let t254 = t244 + t246;
        let t255 = t249 - t198;
        let t256 = t199 + t248;
        let t257 = t198 + t249;
        let t258 = t244 + t245;
        put(62, t247); // row 7, XX
        put(66, t255); // row 7, XZ
        put(67, t252); // row 7, YZ
        [
        t244, t245, t246, t247, t248, t249, t250, t251,
        t252, t253, t254, t255, t256, t257, t258,
    ]
    };
    // payload: column M
    let [t261, t264] = {
        let t261 = c7 * a7_x - s7 * a7_y;
        let t264 = s7 * a7_x + c7 * a7_y;
        let t265 = k6 * t264;
        let t266 = k6 * t261;
        let t269 = c6 * t261 - s6 * a7_z;
        let t272 = s6 * t261 + c6 * a7_z;
        let t277 = c6 * t265 + k5 * t272;
        let t278 = s6 * t265 - k5 * t269;
        let t281 = c5 * t269 - s5 * t264;
        let t284 = s5 * t269 + c5 * t264;
        let t294 = k4 * t281 - (s5 * t277 - c5 * t266);
        let t297 = c5 * t277 + s5 * t266 + k4 * t284 + k3 * t272;
        let t298 = t278 - k3 * t281;
        let t308 = v1_3_y * t284 + (t226 * t281 - t229 * t272);
        let t309 = z1_4_z * t294 + (z1_4_x * t297 + z1_4_y * t298) + t308;
        let t319 = v2_4_z * t284 + (t223 * t272 - t222 * t281);
        let t320 = c3 * t294 + (z2_4_y * t298 - t220 * t297) - t319;
        let t323 = s4 * t297 + c4 * t298;
        put(0, t309); // row 1, M
        put(10, t320); // row 2, M
        put(20, t323); // row 3, M
        put(30, t294); // row 4, M
        put(40, t278); // row 5, M
        put(50, t266); // row 6, M
        [t261, t264]
    };
    // payload: column MSX
    let [t325, t328, t330, t331] = {
        let t325 = s7 * t253;
        let t326 = c7 * t250 + t325;
        let t328 = c7 * t253;
        let t329 = s7 * t250 - t328;
        let t330 = s7 * a7_z;
        let t331 = c7 * a7_z;
        let t334 = k6 * t329 - t330;
        let t335 = t331 - k6 * t326;
        let t338 = c6 * t326 + s6 * t256;
        let t341 = c6 * t256 - s6 * t326;
        let t350 = c6 * t334 + s6 * a7_y - k5 * t341;
        let t351 = c6 * a7_y - s6 * t334 + k5 * t338;
        let t354 = c5 * t338 - s5 * t329;
        let t357 = s5 * t338 + c5 * t329;
        let t367 = s5 * t350 + c5 * t335 - k4 * t354;
        let t370 = c5 * t350 - s5 * t335 + k4 * t357 - k3 * t341;
        let t371 = t351 + k3 * t354;
        let t381 = v1_3_y * t357 + (t226 * t354 + t229 * t341);
        let t382 = z1_4_z * t367 - (z1_4_x * t370 - z1_4_y * t371) - t381;
        let t392 = v2_4_z * t357 - (t222 * t354 + t223 * t341);
        let t393 = c3 * t367 + (t220 * t370 + z2_4_y * t371) + t392;
        let t396 = c4 * t371 - s4 * t370;
        put(1, t382); // row 1, MSX
        put(11, t393); // row 2, MSX
        put(21, t396); // row 3, MSX
        put(31, t367); // row 4, MSX
        put(41, t351); // row 5, MSX
        put(51, t335); // row 6, MSX
        [t325, t328, t330, t331]
    };
    // payload: column MSY
    let [t397, t400] = {
        let t397 = c7 * t251;
        let t399 = s7 * t254 - t397;
        let t400 = s7 * t251;
        let t402 = t400 + c7 * t254;
        let t405 = t331 - k6 * t402;
        let t406 = k6 * t399 - t330;
        let t409 = c6 * t399 + s6 * t257;
        let t412 = c6 * t257 - s6 * t399;
        let t421 = k5 * t412 - (c6 * t405 + s6 * a7_x);
        let t422 = s6 * t405 - c6 * a7_x - k5 * t409;
        let t425 = c5 * t409 + s5 * t402;
        let t428 = c5 * t402 - s5 * t409;
        let t438 = s5 * t421 + c5 * t406 + k4 * t425;
        let t441 = k4 * t428 - (s5 * t406 - c5 * t421) + k3 * t412;
        let t442 = t422 - k3 * t425;
        let t452 = t226 * t425 + t229 * t412 - v1_3_y * t428;
        let t453 = z1_4_z * t438 + (z1_4_y * t442 - z1_4_x * t441) + t452;
        let t463 = v2_4_z * t428 + (t222 * t425 + t223 * t412);
        let t464 = c3 * t438 + (t220 * t441 + z2_4_y * t442) + t463;
        let t467 = c4 * t442 - s4 * t441;
        put(2, t453); // row 1, MSY
        put(12, t464); // row 2, MSY
        put(22, t467); // row 3, MSY
        put(32, t438); // row 4, MSY
        put(42, t422); // row 5, MSY
        put(52, t406); // row 6, MSY
        [t397, t400]
    };
    // payload: column MSZ
    {
        let t470 = c7 * t252 + s7 * t255;
        let t473 = s7 * t252 - c7 * t255;
        let t476 = k6 * t473 - t264;
        let t477 = k6 * t470 - t261;
        let t480 = c6 * t470 + s6 * t258;
        let t483 = s6 * t470 - c6 * t258;
        let t488 = c6 * t476 + k5 * t483;
        let t489 = s6 * t476 - k5 * t480;
        let t492 = s5 * t473 - c5 * t480;
        let t495 = s5 * t480 + c5 * t473;
        let t505 = c5 * t477 - s5 * t488 - k4 * t492;
        let t508 = c5 * t488 + s5 * t477 + k4 * t495 + k3 * t483;
        let t509 = t489 + k3 * t492;
        let t519 = t226 * t492 + t229 * t483 - v1_3_y * t495;
        let t520 = z1_4_z * t505 + (z1_4_x * t508 + z1_4_y * t509) - t519;
        let t530 = v2_4_z * t495 + (t222 * t492 + t223 * t483);
        let t531 = c3 * t505 + (z2_4_y * t509 - t220 * t508) - t530;
        let t534 = s4 * t508 + c4 * t509;
        put(3, t520); // row 1, MSZ
        put(13, t531); // row 2, MSZ
        put(23, t534); // row 3, MSZ
        put(33, t505); // row 4, MSZ
        put(43, t489); // row 5, MSZ
        put(53, t477); // row 6, MSZ
    }
    // payload: column XX
    let [t536, t539, t542, t545] = {
        let t536 = s7 * t248;
        let t537 = c7 * t198 + t536;
        let t539 = c7 * t248;
        let t540 = s7 * t198 - t539;
        let t542 = s6 * t247;
        let t543 = c6 * t537 + t542;
        let t545 = c6 * t247;
        let t546 = t545 - s6 * t537;
        let t551 = z1_4_y * t546 + (z1_6_z * t540 - z1_5_x * t543);
        let t556 = z2_4_y * t546 + (t238 * t543 + t241 * t540);
        let t561 = c4 * t546 + (z3_6_z * t540 - z3_5_x * t543);
        let t564 = s5 * t543 + c5 * t540;
        put(4, t551); // row 1, XX
        put(14, t556); // row 2, XX
        put(24, t561); // row 3, XX
        put(34, t564); // row 4, XX
        put(44, t546); // row 5, XX
        put(54, t540); // row 6, XX
        [t536, t539, t542, t545]
    };
    // payload: column YY
    let [t565, t568] = {
        let t565 = c7 * t249;
        let t567 = t565 + s7 * t199;
        let t568 = s7 * t249;
        let t570 = c7 * t199 - t568;
        let t572 = t542 + c6 * t567;
        let t574 = s6 * t567 - t545;
        let t579 = z1_4_y * t574 + (z1_5_x * t572 + z1_6_z * t570);
        let t584 = z2_4_y * t574 + (t241 * t570 - t238 * t572);
        let t589 = c4 * t574 + (z3_5_x * t572 + z3_6_z * t570);
        let t592 = c5 * t570 - s5 * t572;
        put(5, t579); // row 1, YY
        put(15, t584); // row 2, YY
        put(25, t589); // row 3, YY
        put(35, t592); // row 4, YY
        put(45, t574); // row 5, YY
        put(55, t570); // row 6, YY
        [t565, t568]
    };
    // payload: column ZZ
    let t619 = {
        let t593 = t536 - t565;
        let t594 = t539 + t568;
        let t597 = s6 * dw7_z - c6 * t593;
        let t600 = s6 * t593 + c6 * dw7_z;
        let t605 = z1_4_y * t600 + (z1_6_z * t594 - z1_5_x * t597);
        let t610 = z2_4_y * t600 + (t238 * t597 + t241 * t594);
        let t615 = c4 * t600 + (z3_6_z * t594 - z3_5_x * t597);
        let t618 = s5 * t597 + c5 * t594;
        let t619 = t244 - t245;
        put(6, t605); // row 1, ZZ
        put(16, t610); // row 2, ZZ
        put(26, t615); // row 3, ZZ
        put(36, t618); // row 4, ZZ
        put(46, t600); // row 5, ZZ
        put(56, t594); // row 6, ZZ
        put(65, t619); // row 7, XY
        t619
    };
    // payload: column XY
    let t650 = {
        let t622 = s7 * t257 - c7 * t256;
        let t625 = s7 * t256 + c7 * t257;
        let t628 = s6 * t619 - c6 * t622;
        let t631 = s6 * t622 + c6 * t619;
        let t636 = z1_4_y * t631 + (z1_6_z * t625 - z1_5_x * t628);
        let t641 = z2_4_y * t631 + (t238 * t628 + t241 * t625);
        let t646 = c4 * t631 - (z3_5_x * t628 - z3_6_z * t625);
        let t649 = s5 * t628 + c5 * t625;
        let t650 = t244 - t246;
        put(7, t636); // row 1, XY
        put(17, t641); // row 2, XY
        put(27, t646); // row 3, XY
        put(37, t649); // row 4, XY
        put(47, t631); // row 5, XY
        put(57, t625); // row 6, XY
        t650
    };
    // payload: column XZ
    let t679 = {
        let t652 = t328 + s7 * t650;
        let t654 = c7 * t650 - t325;
        let t657 = s6 * t255 - c6 * t652;
        let t660 = s6 * t652 + c6 * t255;
        let t665 = z1_4_y * t660 + (z1_6_z * t654 - z1_5_x * t657);
        let t670 = z2_4_y * t660 + (t238 * t657 + t241 * t654);
        let t675 = c4 * t660 + (z3_6_z * t654 - z3_5_x * t657);
        let t678 = s5 * t657 + c5 * t654;
        let t679 = t246 - t245;
        put(8, t665); // row 1, XZ
        put(18, t670); // row 2, XZ
        put(28, t675); // row 3, XZ
        put(38, t678); // row 4, XZ
        put(48, t660); // row 5, XZ
        put(58, t654); // row 6, XZ
        t679
    };
    // payload: column YZ
    {
        let t681 = t400 + c7 * t679;
        let t683 = s7 * t679 - t397;
        let t686 = c6 * t681 + s6 * t252;
        let t689 = c6 * t252 - s6 * t681;
        let t694 = z1_4_y * t689 + (z1_6_z * t683 - z1_5_x * t686);
        let t699 = z2_4_y * t689 + (t238 * t686 + t241 * t683);
        let t704 = c4 * t689 + (z3_6_z * t683 - z3_5_x * t686);
        let t707 = s5 * t686 + c5 * t683;
        let t708 = -a7_x;
        let t709 = -t247;
        put(9, t694); // row 1, YZ
        put(19, t699); // row 2, YZ
        put(29, t704); // row 3, YZ
        put(39, t707); // row 4, YZ
        put(49, t689); // row 5, YZ
        put(59, t683); // row 6, YZ
        put(61, t708); // row 7, MSY
        put(63, t709); // row 7, YY
    }
}
