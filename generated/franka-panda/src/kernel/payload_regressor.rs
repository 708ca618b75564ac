//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin (the paper's (7)).
//!
//! 389 multiplications, 277 additions; 7 x 10, 68 of 70 structurally nonzero.

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
    let A = S::constant(0.0825);
    let L2 = S::constant(0.316);
    let L3 = S::constant(0.384);
    let k0 = S::constant(9.81);
    let k4 = S::constant(0.088);
    // link 2: motion
    let [t0, t1, t4, t5, dw2_y, t13, t14, t15] = {
        let t0 = s2 * dq1;
        let t1 = c2 * dq1;
        let t4 = s2 * k0;
        let t5 = c2 * k0;
        let t10 = dq2 * t1;
        let dw2_y = dq2 * t0 - c2 * ddq1;
        let t13 = t0 * t1 - ddq2;
        let t14 = t0 * t0 + dq2 * dq2;
        let t15 = t10 + (s2 * ddq1 + t10);
        [t0, t1, t4, t5, dw2_y, t13, t14, t15]
    };
    // link 3: motion
    let [
        t18, w3_y, t26, a3_x, a3_y, w3_z, dw3_y, t49,
        t50, t51, t52, t53, t54,
    ] = {
        let t18 = c3 * t0 - s3 * dq2;
        let w3_y = c3 * dq2 + s3 * t0;
        let t24 = L2 * t15;
        let t25 = t4 + L2 * t13;
        let t26 = t5 - L2 * t14;
        let a3_x = s3 * t24 - c3 * t25;
        let a3_y = c3 * t24 + s3 * t25;
        let w3_z = t1 + dq3;
        let t40 = dw2_y - ddq3;
        let t41 = t18 * t18;
        let t42 = w3_z * w3_z;
        let t43 = t18 * w3_y;
        let t44 = t18 * w3_z;
        let t45 = w3_y * w3_z;
        let dw3_y = s3 * t15 - c3 * t13 + t44;
        let t49 = t14 + (t42 - t41);
        let t50 = t40 - t43;
        let t51 = t40 + t43;
        let t52 = t41 + t42;
        let t53 = t44 + dw3_y;
        let t54 = t45 - (c3 * t15 + s3 * t13 - t45);
        [
        t18, w3_y, t26, a3_x, a3_y, w3_z, dw3_y, t49,
        t50, t51, t52, t53, t54,
    ]
    };
    // link 4: motion
    let [
        t57, w4_y, t65, a4_x, a4_y, w4_z, t87, t89,
        t90, t91, t92, t93, t94,
    ] = {
        let t57 = c4 * t18 - s4 * w3_z;
        let w4_y = c4 * w3_z + s4 * t18;
        let t64 = A * t49 - a3_x;
        let t65 = A * t51 - a3_y;
        let t66 = t26 - A * t53;
        let a4_x = s4 * t66 - c4 * t64;
        let a4_y = c4 * t66 + s4 * t64;
        let w4_z = dq4 - w3_y;
        let t80 = dw3_y - ddq4;
        let t81 = t57 * t57;
        let t82 = w4_z * w4_z;
        let t83 = t57 * w4_y;
        let t84 = t57 * w4_z;
        let t85 = w4_y * w4_z;
        let t87 = t84 - (c4 * t50 + s4 * t54);
        let t89 = t52 + (t82 - t81);
        let t90 = t80 - t83;
        let t91 = t80 + t83;
        let t92 = t81 + t82;
        let t93 = t84 + t87;
        let t94 = t85 - (s4 * t50 - c4 * t54 - t85);
        [
        t57, w4_y, t65, a4_x, a4_y, w4_z, t87, t89,
        t90, t91, t92, t93, t94,
    ]
    };
    // link 5: motion
    let [
        t97, t100, a5_z, t115, a6_z, w5_z, dw5_y, t134,
        t135, t136,
    ] = {
        let t97 = c5 * t57 + s5 * w4_z;
        let t100 = s5 * t57 - c5 * w4_z;
        let t110 = a4_x + (A * t89 + L3 * t90);
        let a5_z = a4_y + (A * t91 - L3 * t92);
        let t112 = t65 + (A * t93 + L3 * t94);
        let t115 = s5 * t112 - c5 * t110;
        let a6_z = c5 * t112 + s5 * t110;
        let w5_z = w4_y + dq5;
        let dw5_z = t87 + ddq5;
        let t131 = t100 * w5_z;
        let dw5_x = c5 * t94 + s5 * t90 + t131;
        let dw5_y = c5 * t90 - s5 * t94 + t97 * w5_z;
        let t134 = dw5_z + t97 * t100;
        let t135 = t97 * t97 + w5_z * w5_z;
        let t136 = t131 + dw5_x;
        [
        t97, t100, a5_z, t115, a6_z, w5_z, dw5_y, t134,
        t135, t136,
    ]
    };
    // link 6: motion
    let [
        t139, w6_y, t145, a6_y, w6_z, dw6_y, t165, t166,
        t167, t168, t169, t170,
    ] = {
        let t139 = c6 * t97 - s6 * w5_z;
        let w6_y = c6 * w5_z + s6 * t97;
        let t145 = c6 * t115 - s6 * a5_z;
        let a6_y = c6 * a5_z + s6 * t115;
        let w6_z = dq6 - t100;
        let t156 = dw5_y - ddq6;
        let t157 = t139 * t139;
        let t158 = w6_z * w6_z;
        let t159 = t139 * w6_y;
        let t160 = t139 * w6_z;
        let t161 = w6_y * w6_z;
        let dw6_x = c6 * t136 + s6 * t134 + t161;
        let dw6_y = c6 * t134 - s6 * t136 + t160;
        let t165 = t135 + (t158 - t157);
        let t166 = t159 - t156;
        let t167 = t156 + t159;
        let t168 = t157 + t158;
        let t169 = t160 + dw6_y;
        let t170 = t161 + dw6_x;
        [
        t139, w6_y, t145, a6_y, w6_z, dw6_y, t165, t166,
        t167, t168, t169, t170,
    ]
    };
    // link 7: motion
    let [
        t181, t185, a7_y, t191, t194, dw7_z, t199, t200,
        t201, dw7_x, t203, t204, t205, t206, t207, t208,
        t209, t210,
    ] = {
        let w7_x = s7 * w6_z - c7 * t139;
        let w7_y = c7 * w6_z + s7 * t139;
        let t180 = t145 + k4 * t165;
        let t181 = a6_y - k4 * t167;
        let t182 = a6_z - k4 * t169;
        let t185 = c7 * t180 - s7 * t182;
        let a7_y = c7 * t182 + s7 * t180;
        let t191 = c7 * t166 - s7 * t170;
        let t194 = c7 * t170 + s7 * t166;
        let t195 = w6_y - dq7;
        let dw7_z = ddq7 - dw6_y;
        let t197 = w7_x * w7_x;
        let t198 = t195 * t195;
        let t199 = w7_x * w7_y;
        let t200 = w7_x * t195;
        let t201 = w7_y * t195;
        let dw7_x = t194 - t201;
        let t203 = t191 + t200;
        let t204 = t198 - t197;
        let t205 = t168 + t204;
        let t206 = t199 - dw7_z;
        let t207 = dw7_z + t199;
        let t208 = t197 + t198;
        let t209 = t200 + t203;
        let t210 = t201 - dw7_x;
        put(60, a7_y); // row 7, MSX
        put(61, t185); // row 7, MSY
        put(63, t199); // row 7, YY
        put(64, dw7_z); // row 7, ZZ
        put(66, t194); // row 7, XZ
        put(67, t191); // row 7, YZ
        [
        t181, t185, a7_y, t191, t194, dw7_z, t199, t200,
        t201, dw7_x, t203, t204, t205, t206, t207, t208,
        t209, t210,
    ]
    };
    // joint axes in frame 3
    let [t211, z1_3_y] = {
        let t211 = s2 * c3;
        let z1_3_y = s2 * s3;
        [t211, z1_3_y]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, z2_4_x, t220] = {
        let z1_4_x = c2 * s4 - c4 * t211;
        let z1_4_y = c2 * c4 + s4 * t211;
        let z2_4_x = s3 * c4;
        let t220 = s3 * s4;
        [z1_4_x, z1_4_y, z2_4_x, t220]
    };
    // joint axes in frame 5
    let [z1_5_x, t226, z2_5_x, t232, t233, z3_5_x, z3_6_z] = {
        let z1_5_x = c5 * z1_4_x + s5 * z1_3_y;
        let t226 = s5 * z1_4_x - c5 * z1_3_y;
        let z2_5_x = c5 * z2_4_x + c3 * s5;
        let t232 = s5 * z2_4_x - c3 * c5;
        let t233 = c4 * A;
        let z3_5_x = s4 * c5;
        let z3_6_z = s4 * s5;
        [z1_5_x, t226, z2_5_x, t232, t233, z3_5_x, z3_6_z]
    };
    // payload: column M
    let [t238, t241, t273, t276] = {
        let t238 = c7 * t185 + s7 * a7_y;
        let t241 = s7 * t185 - c7 * a7_y;
        let t242 = k4 * t181;
        let t243 = k4 * t241;
        let t246 = c6 * t238 + s6 * t181;
        let t249 = c6 * t181 - s6 * t238;
        let t250 = s6 * t243;
        let t251 = c6 * t243;
        let t254 = c5 * t246 + s5 * t241;
        let t257 = c5 * t241 - s5 * t246;
        let t268 = A * t257;
        let t269 = c5 * t250 - s5 * t242 + L3 * t257;
        let t270 = s5 * t250 + c5 * t242 + (L3 * t254 - A * t249);
        let t271 = t251 - t268;
        let t273 = t233 + L2 * s4;
        let t276 = s4 * A - L2 * c4;
        let t282 = t257 * t276 - t269;
        let t283 = t271 + t257 * t273;
        let t284 = t254 * t276 - t249 * t273 - t270;
        let t289 = z1_3_y * t284 + (z1_4_x * t282 + z1_4_y * t283);
        let t294 = c3 * t284 + (z2_4_x * t282 - t220 * t283);
        let t298 = t268 - (s4 * t269 - c4 * t271);
        put(0, t289); // row 1, M
        put(10, t294); // row 2, M
        put(20, t298); // row 3, M
        put(30, t270); // row 4, M
        put(40, t251); // row 5, M
        put(50, t242); // row 6, M
        [t238, t241, t273, t276]
    };
    // payload: column MSX
    let [t300, t303, t305, t306] = {
        let t300 = s7 * t207;
        let t301 = c7 * t205 + t300;
        let t303 = c7 * t207;
        let t304 = s7 * t205 - t303;
        let t305 = s7 * t181;
        let t306 = c7 * t181;
        let t309 = t306 + k4 * t209;
        let t310 = k4 * t304 - a7_y;
        let t313 = c6 * t301 + s6 * t209;
        let t316 = s6 * t301 - c6 * t209;
        let t319 = c6 * t305 + s6 * t310;
        let t322 = c6 * t310 - s6 * t305;
        let t325 = c5 * t313 + s5 * t304;
        let t328 = c5 * t304 - s5 * t313;
        let t339 = A * t328;
        let t340 = s5 * t309 - c5 * t319 - L3 * t328;
        let t341 = s5 * t319 + c5 * t309 + (L3 * t325 + A * t316);
        let t342 = t322 - t339;
        let t348 = t340 + t276 * t328;
        let t349 = t342 + t273 * t328;
        let t350 = t273 * t316 + t276 * t325 - t341;
        let t355 = z1_3_y * t350 + (z1_4_x * t348 + z1_4_y * t349);
        let t360 = c3 * t350 + (z2_4_x * t348 - t220 * t349);
        let t364 = t339 + (s4 * t340 + c4 * t342);
        put(1, t355); // row 1, MSX
        put(11, t360); // row 2, MSX
        put(21, t364); // row 3, MSX
        put(31, t341); // row 4, MSX
        put(41, t322); // row 5, MSX
        put(51, t309); // row 6, MSX
        [t300, t303, t305, t306]
    };
    // payload: column MSY
    let [t365, t368] = {
        let t365 = c7 * t206;
        let t367 = t365 + s7 * t208;
        let t368 = s7 * t206;
        let t370 = c7 * t208 - t368;
        let t373 = k4 * t210 - t305;
        let t374 = k4 * t370 - t185;
        let t377 = s6 * t210 - c6 * t367;
        let t380 = s6 * t367 + c6 * t210;
        let t383 = c6 * t306 + s6 * t374;
        let t386 = c6 * t374 - s6 * t306;
        let t389 = c5 * t377 + s5 * t370;
        let t392 = c5 * t370 - s5 * t377;
        let t403 = A * t392;
        let t404 = L3 * t392 - (s5 * t373 - c5 * t383);
        let t405 = s5 * t383 + c5 * t373 + (L3 * t389 - A * t380);
        let t406 = t403 - t386;
        let t412 = t276 * t392 - t404;
        let t413 = t273 * t392 - t406;
        let t414 = t276 * t389 - t273 * t380 - t405;
        let t419 = z1_3_y * t414 + (z1_4_x * t412 + z1_4_y * t413);
        let t424 = c3 * t414 - (t220 * t413 - z2_4_x * t412);
        let t428 = t403 - (s4 * t404 + c4 * t406);
        put(2, t419); // row 1, MSY
        put(12, t424); // row 2, MSY
        put(22, t428); // row 3, MSY
        put(32, t405); // row 4, MSY
        put(42, t386); // row 5, MSY
        put(52, t373); // row 6, MSY
        [t365, t368]
    };
    // payload: column MSZ
    {
        let t431 = c7 * t191 + s7 * t194;
        let t434 = c7 * t194 - s7 * t191;
        let t436 = k4 * t434;
        let t437 = k4 * t168 - t238;
        let t440 = s6 * t168 - c6 * t431;
        let t443 = s6 * t431 + c6 * t168;
        let t446 = s6 * t436 - c6 * t241;
        let t449 = s6 * t241 + c6 * t436;
        let t452 = c5 * t440 + s5 * t434;
        let t455 = s5 * t440 - c5 * t434;
        let t466 = A * t455;
        let t467 = s5 * t437 - c5 * t446 + L3 * t455;
        let t468 = s5 * t446 + c5 * t437 + (L3 * t452 - A * t443);
        let t469 = t449 + t466;
        let t475 = t467 - t276 * t455;
        let t476 = t273 * t455 - t469;
        let t477 = t276 * t452 - t273 * t443 - t468;
        let t482 = z1_3_y * t477 + (z1_4_x * t475 - z1_4_y * t476);
        let t487 = c3 * t477 + (z2_4_x * t475 + t220 * t476);
        let t491 = s4 * t467 + c4 * t469 - t466;
        put(3, t482); // row 1, MSZ
        put(13, t487); // row 2, MSZ
        put(23, t491); // row 3, MSZ
        put(33, t468); // row 4, MSZ
        put(43, t449); // row 5, MSZ
        put(53, t437); // row 6, MSZ
    }
    // payload: column XX
    let [t493, t496, t499, t502] = {
        let t493 = s7 * t200;
        let t494 = c7 * dw7_x + t493;
        let t496 = c7 * t200;
        let t497 = s7 * dw7_x - t496;
        let t499 = s6 * t199;
        let t500 = t499 - c6 * t494;
        let t502 = c6 * t199;
        let t503 = s6 * t494 + t502;
        let t508 = z1_4_y * t503 - (z1_5_x * t500 - t226 * t497);
        let t513 = t232 * t497 - z2_5_x * t500 - t220 * t503;
        let t518 = c4 * t503 + (z3_6_z * t497 - z3_5_x * t500);
        let t521 = s5 * t500 + c5 * t497;
        put(4, t508); // row 1, XX
        put(14, t513); // row 2, XX
        put(24, t518); // row 3, XX
        put(34, t521); // row 4, XX
        put(44, t503); // row 5, XX
        put(54, t497); // row 6, XX
        [t493, t496, t499, t502]
    };
    // payload: column YY
    let [t522, t525] = {
        let t522 = c7 * t201;
        let t524 = t522 - s7 * t203;
        let t525 = s7 * t201;
        let t527 = t525 + c7 * t203;
        let t529 = t499 + c6 * t524;
        let t531 = s6 * t524 - t502;
        let t536 = z1_4_y * t531 + (z1_5_x * t529 + t226 * t527);
        let t541 = z2_5_x * t529 + t232 * t527 - t220 * t531;
        let t546 = c4 * t531 + (z3_5_x * t529 + z3_6_z * t527);
        let t549 = c5 * t527 - s5 * t529;
        put(5, t536); // row 1, YY
        put(15, t541); // row 2, YY
        put(25, t546); // row 3, YY
        put(35, t549); // row 4, YY
        put(45, t531); // row 5, YY
        put(55, t527); // row 6, YY
        [t522, t525]
    };
    // payload: column ZZ
    let [t557, t576] = {
        let t550 = t493 + t522;
        let t551 = t496 - t525;
        let t554 = s6 * dw7_z - c6 * t550;
        let t557 = s6 * t550 + c6 * dw7_z;
        let t562 = z1_5_x * t554 + t226 * t551 - z1_4_y * t557;
        let t567 = t220 * t557 + (z2_5_x * t554 + t232 * t551);
        let t572 = z3_5_x * t554 + z3_6_z * t551 - c4 * t557;
        let t575 = c5 * t551 - s5 * t554;
        let t576 = t208 - t205;
        put(6, t562); // row 1, ZZ
        put(16, t567); // row 2, ZZ
        put(26, t572); // row 3, ZZ
        put(36, t575); // row 4, ZZ
        put(56, t551); // row 6, ZZ
        put(65, t576); // row 7, XY
        [t557, t576]
    };
    // payload: column XY
    {
        let t579 = c7 * t209 + s7 * t210;
        let t582 = s7 * t209 - c7 * t210;
        let t585 = c6 * t579 + s6 * t576;
        let t588 = s6 * t579 - c6 * t576;
        let t593 = z1_4_y * t588 + (z1_5_x * t585 + t226 * t582);
        let t598 = z2_5_x * t585 + t232 * t582 - t220 * t588;
        let t603 = c4 * t588 + (z3_5_x * t585 + z3_6_z * t582);
        let t606 = c5 * t582 - s5 * t585;
        put(7, t593); // row 1, XY
        put(17, t598); // row 2, XY
        put(27, t603); // row 3, XY
        put(37, t606); // row 4, XY
        put(47, t588); // row 5, XY
        put(57, t582); // row 6, XY
    }
    // payload: column XZ
    let t635 = {
        let t608 = t303 - s7 * t204;
        let t610 = t300 + c7 * t204;
        let t613 = c6 * t608 + s6 * t194;
        let t616 = s6 * t608 - c6 * t194;
        let t621 = z1_4_y * t616 + (z1_5_x * t613 + t226 * t610);
        let t626 = z2_5_x * t613 + t232 * t610 - t220 * t616;
        let t631 = c4 * t616 + (z3_5_x * t613 + z3_6_z * t610);
        let t634 = c5 * t610 - s5 * t613;
        let t635 = t168 - t208;
        put(8, t621); // row 1, XZ
        put(18, t626); // row 2, XZ
        put(28, t631); // row 3, XZ
        put(38, t634); // row 4, XZ
        put(48, t616); // row 5, XZ
        put(58, t610); // row 6, XZ
        t635
    };
    // payload: column YZ
    {
        let t637 = t368 + c7 * t635;
        let t639 = s7 * t635 - t365;
        let t642 = c6 * t637 + s6 * t191;
        let t645 = s6 * t637 - c6 * t191;
        let t650 = z1_4_y * t645 + (z1_5_x * t642 + t226 * t639);
        let t655 = z2_5_x * t642 + t232 * t639 - t220 * t645;
        let t660 = c4 * t645 + (z3_5_x * t642 + z3_6_z * t639);
        let t663 = c5 * t639 - s5 * t642;
        let t664 = -t557;
        let t665 = -t199;
        put(9, t650); // row 1, YZ
        put(19, t655); // row 2, YZ
        put(29, t660); // row 3, YZ
        put(39, t663); // row 4, YZ
        put(46, t664); // row 5, ZZ
        put(49, t645); // row 5, YZ
        put(59, t639); // row 6, YZ
        put(62, t665); // row 7, XX
    }
}
