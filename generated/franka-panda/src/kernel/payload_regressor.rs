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
    let flat = &mut out.as_flattened_mut()[..];
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
    let A = S::constant(0.0825);
    let L2 = S::constant(0.316);
    let L3 = S::constant(0.384);
    let k0 = S::constant(9.81);
    let k4 = S::constant(0.088);
    // link 2: motion
    let [t0, t1, t2, t3, dw2_y, t13, t14, t15] = {
        let t0 = s2 * k0;
        let t1 = c2 * k0;
        let t2 = s2 * dq1;
        let t3 = c2 * dq1;
        let t10 = dq2 * t3;
        let dw2_y = dq2 * t2 - c2 * ddq1;
        let t13 = t2 * t3 - ddq2;
        let t14 = t2 * t2 + dq2 * dq2;
        let t15 = t10 + (s2 * ddq1 + t10);
        [t0, t1, t2, t3, dw2_y, t13, t14, t15]
    };
    // link 3: motion
    let [
        t16, z1_3_y, t22, t25, a3_y, t31, w3_y, w3_z,
        dw3_y, t51, t52, t53, t54, t55, t56,
    ] = {
        let t16 = s2 * c3;
        let z1_3_y = s2 * s3;
        let t20 = L2 * t15;
        let t21 = t0 + L2 * t13;
        let t22 = L2 * t14 - t1;
        let t25 = c3 * t21 - s3 * t20;
        let a3_y = c3 * t20 + s3 * t21;
        let t31 = c3 * t2 - s3 * dq2;
        let w3_y = c3 * dq2 + s3 * t2;
        let w3_z = t3 + dq3;
        let t42 = dw2_y - ddq3;
        let t43 = t31 * t31;
        let t44 = w3_z * w3_z;
        let t45 = t31 * w3_y;
        let t46 = t31 * w3_z;
        let t47 = w3_y * w3_z;
        let dw3_y = s3 * t15 - c3 * t13 + t46;
        let t51 = t14 + (t44 - t43);
        let t52 = t45 - t42;
        let t53 = t42 + t45;
        let t54 = t43 + t44;
        let t55 = t46 + dw3_y;
        let t56 = t47 - (c3 * t15 + s3 * t13 - t47);
        [
        t16, z1_3_y, t22, t25, a3_y, t31, w3_y, w3_z,
        dw3_y, t51, t52, t53, t54, t55, t56,
    ]
    };
    // link 4: motion
    let [
        t61, t65, t68, t71, w4_y, t81, t89, t91,
        t92, t93, t94, t95, t96,
    ] = {
        let t60 = t25 + A * t51;
        let t61 = a3_y - A * t53;
        let t62 = t22 + A * t55;
        let t65 = c4 * t60 + s4 * t62;
        let t68 = c4 * t62 - s4 * t60;
        let t71 = c4 * t31 - s4 * w3_z;
        let w4_y = c4 * w3_z + s4 * t31;
        let t81 = w3_y - dq4;
        let t82 = dw3_y - ddq4;
        let t83 = t71 * t71;
        let t84 = t81 * t81;
        let t85 = t71 * w4_y;
        let t86 = t71 * t81;
        let t87 = w4_y * t81;
        let t89 = s4 * t56 - c4 * t52 + t86;
        let t91 = t54 - (t83 - t84);
        let t92 = t85 - t82;
        let t93 = t82 + t85;
        let t94 = t83 + t84;
        let t95 = t86 + t89;
        let t96 = t87 + (t87 - (c4 * t56 + s4 * t52));
        [
        t61, t65, t68, t71, w4_y, t81, t89, t91,
        t92, t93, t94, t95, t96,
    ]
    };
    // link 5: motion
    let [
        t107, a5_x, t114, t117, t120, w5_z, t135, t136,
        t137, t138,
    ] = {
        let t106 = t65 - (A * t91 - L3 * t92);
        let t107 = t68 + (L3 * t94 - A * t93);
        let t108 = t61 + (A * t95 + L3 * t96);
        let a5_x = s5 * t108 - c5 * t106;
        let t114 = c5 * t108 + s5 * t106;
        let t117 = c5 * t71 - s5 * t81;
        let t120 = c5 * t81 + s5 * t71;
        let w5_z = w4_y + dq5;
        let dw5_z = ddq5 - t89;
        let t133 = t120 * w5_z;
        let t135 = c5 * t92 - s5 * t96 - t117 * w5_z;
        let t136 = dw5_z + t117 * t120;
        let t137 = t117 * t117 + w5_z * w5_z;
        let t138 = t133 - (c5 * t96 + s5 * t92 - t133);
        [
        t107, a5_x, t114, t117, t120, w5_z, t135, t136,
        t137, t138,
    ]
    };
    // link 6: motion
    let [
        a6_x, t144, t147, w6_y, w6_z, dw6_y, t167, t168,
        t169, t170, t171, t172,
    ] = {
        let a6_x = c6 * a5_x - s6 * t107;
        let t144 = c6 * t107 + s6 * a5_x;
        let t147 = c6 * t117 - s6 * w5_z;
        let w6_y = c6 * w5_z + s6 * t117;
        let w6_z = dq6 - t120;
        let dw6_z = t135 + ddq6;
        let t159 = t147 * t147;
        let t160 = w6_z * w6_z;
        let t161 = t147 * w6_y;
        let t162 = t147 * w6_z;
        let t163 = w6_y * w6_z;
        let dw6_x = c6 * t138 + s6 * t136 + t163;
        let dw6_y = c6 * t136 - s6 * t138 + t162;
        let t167 = t137 + (t160 - t159);
        let t168 = dw6_z + t161;
        let t169 = t161 - dw6_z;
        let t170 = t159 + t160;
        let t171 = t162 + dw6_y;
        let t172 = t163 + dw6_x;
        [
        a6_x, t144, t147, w6_y, w6_z, dw6_y, t167, t168,
        t169, t170, t171, t172,
    ]
    };
    // link 7: motion
    let [
        t177, t181, a7_y, t193, t196, dw7_z, t201, t202,
        t203, dw7_x, t205, t206, t207, t208, t209, t210,
        t211, t212,
    ] = {
        let t176 = k4 * t167 - a6_x;
        let t177 = t144 + k4 * t169;
        let t178 = t114 + k4 * t171;
        let t181 = c7 * t176 + s7 * t178;
        let a7_y = s7 * t176 - c7 * t178;
        let t187 = c7 * t147 - s7 * w6_z;
        let w7_y = c7 * w6_z + s7 * t147;
        let t193 = c7 * t168 - s7 * t172;
        let t196 = c7 * t172 + s7 * t168;
        let w7_z = dq7 - w6_y;
        let dw7_z = ddq7 - dw6_y;
        let t199 = t187 * t187;
        let t200 = w7_z * w7_z;
        let t201 = t187 * w7_y;
        let t202 = t187 * w7_z;
        let t203 = w7_y * w7_z;
        let dw7_x = t196 + t203;
        let t205 = t193 + t202;
        let t206 = t200 - t199;
        let t207 = t170 + t206;
        let t208 = dw7_z + t201;
        let t209 = dw7_z - t201;
        let t210 = t199 + t200;
        let t211 = t202 + t205;
        let t212 = t203 + dw7_x;
        put(60, a7_y); // row 7, MSX
        put(61, t181); // row 7, MSY
        put(62, t201); // row 7, XX
        put(64, dw7_z); // row 7, ZZ
        put(66, t196); // row 7, XZ
        put(67, t193); // row 7, YZ
        [
        t177, t181, a7_y, t193, t196, dw7_z, t201, t202,
        t203, dw7_x, t205, t206, t207, t208, t209, t210,
        t211, t212,
    ]
    };
    // joint axes in frame 4
    let [z1_4_x, z1_4_y, z2_4_x, t220] = {
        let z1_4_x = c2 * s4 - c4 * t16;
        let z1_4_y = c2 * c4 + s4 * t16;
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
    let [t238, t241, t242, t273, t276] = {
        let t238 = c7 * t181 + s7 * a7_y;
        let t241 = s7 * t181 - c7 * a7_y;
        let t242 = k4 * t177;
        let t243 = k4 * t241;
        let t246 = c6 * t238 - s6 * t177;
        let t249 = s6 * t238 + c6 * t177;
        let t250 = s6 * t243;
        let t251 = c6 * t243;
        let t254 = c5 * t246 + s5 * t241;
        let t257 = c5 * t241 - s5 * t246;
        let t268 = A * t257;
        let t269 = c5 * t250 + s5 * t242 + L3 * t257;
        let t270 = L3 * t254 + A * t249 - (c5 * t242 - s5 * t250);
        let t271 = t268 - t251;
        let t273 = t233 + L2 * s4;
        let t276 = s4 * A - L2 * c4;
        let t282 = t257 * t276 - t269;
        let t283 = t271 - t257 * t273;
        let t284 = t249 * t273 + t254 * t276 - t270;
        let t289 = z1_3_y * t284 - (z1_4_y * t283 - z1_4_x * t282);
        let t294 = c3 * t284 + (z2_4_x * t282 + t220 * t283);
        let t298 = t268 - (s4 * t269 + c4 * t271);
        put(0, t289); // row 1, M
        put(10, t294); // row 2, M
        put(20, t298); // row 3, M
        put(30, t270); // row 4, M
        put(40, t251); // row 5, M
        [t238, t241, t242, t273, t276]
    };
    // payload: column MSX
    let [t300, t303, t305, t306] = {
        let t300 = s7 * t209;
        let t301 = c7 * t207 + t300;
        let t303 = c7 * t209;
        let t304 = t303 - s7 * t207;
        let t305 = s7 * t177;
        let t306 = c7 * t177;
        let t309 = k4 * t211 - t306;
        let t310 = a7_y + k4 * t304;
        let t313 = c6 * t301 + s6 * t211;
        let t316 = s6 * t301 - c6 * t211;
        let t319 = c6 * t305 + s6 * t310;
        let t322 = s6 * t305 - c6 * t310;
        let t325 = s5 * t304 - c5 * t313;
        let t328 = s5 * t313 + c5 * t304;
        let t339 = A * t328;
        let t340 = c5 * t319 + s5 * t309 + L3 * t328;
        let t341 = c5 * t309 - s5 * t319 + (A * t316 - L3 * t325);
        let t342 = t322 + t339;
        let t348 = t340 - t276 * t328;
        let t349 = t342 - t273 * t328;
        let t350 = t273 * t316 - t276 * t325 - t341;
        let t355 = z1_3_y * t350 + (z1_4_x * t348 + z1_4_y * t349);
        let t360 = c3 * t350 + (z2_4_x * t348 - t220 * t349);
        let t364 = s4 * t340 + c4 * t342 - t339;
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
        let t365 = c7 * t208;
        let t367 = t365 - s7 * t210;
        let t368 = s7 * t208;
        let t370 = t368 + c7 * t210;
        let t373 = t305 - k4 * t212;
        let t374 = k4 * t370 - t181;
        let t377 = s6 * t212 - c6 * t367;
        let t380 = s6 * t367 + c6 * t212;
        let t383 = s6 * t374 - c6 * t306;
        let t386 = s6 * t306 + c6 * t374;
        let t389 = s5 * t370 - c5 * t377;
        let t392 = s5 * t377 + c5 * t370;
        let t403 = A * t392;
        let t404 = L3 * t392 - (s5 * t373 - c5 * t383);
        let t405 = s5 * t383 + c5 * t373 + (L3 * t389 + A * t380);
        let t406 = t403 - t386;
        let t412 = t404 - t276 * t392;
        let t413 = t406 - t273 * t392;
        let t414 = t273 * t380 + t276 * t389 - t405;
        let t419 = z1_3_y * t414 - (z1_4_x * t412 + z1_4_y * t413);
        let t424 = c3 * t414 + (t220 * t413 - z2_4_x * t412);
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
        let t431 = c7 * t193 + s7 * t196;
        let t434 = c7 * t196 - s7 * t193;
        let t436 = k4 * t434;
        let t437 = k4 * t170 - t238;
        let t440 = s6 * t170 - c6 * t431;
        let t443 = s6 * t431 + c6 * t170;
        let t446 = s6 * t436 - c6 * t241;
        let t449 = s6 * t241 + c6 * t436;
        let t452 = c5 * t440 + s5 * t434;
        let t455 = c5 * t434 - s5 * t440;
        let t466 = A * t455;
        let t467 = L3 * t455 - (s5 * t437 - c5 * t446);
        let t468 = s5 * t446 + c5 * t437 + (L3 * t452 - A * t443);
        let t469 = t466 - t449;
        let t475 = t276 * t455 - t467;
        let t476 = t469 - t273 * t455;
        let t477 = t468 - (t276 * t452 - t273 * t443);
        let t482 = z1_4_x * t475 - z1_4_y * t476 - z1_3_y * t477;
        let t487 = z2_4_x * t475 + t220 * t476 - c3 * t477;
        let t491 = t466 - (s4 * t467 + c4 * t469);
        put(3, t482); // row 1, MSZ
        put(13, t487); // row 2, MSZ
        put(23, t491); // row 3, MSZ
        put(33, t468); // row 4, MSZ
        put(43, t449); // row 5, MSZ
        put(53, t437); // row 6, MSZ
    }
    // payload: column XX
    let [t493, t496, t499, t502] = {
        let t493 = s7 * t202;
        let t494 = c7 * dw7_x + t493;
        let t496 = c7 * t202;
        let t497 = s7 * dw7_x - t496;
        let t499 = s6 * t201;
        let t500 = c6 * t494 + t499;
        let t502 = c6 * t201;
        let t503 = s6 * t494 - t502;
        let t508 = z1_4_y * t503 + (z1_5_x * t500 + t226 * t497);
        let t513 = z2_5_x * t500 + t232 * t497 - t220 * t503;
        let t518 = c4 * t503 + (z3_5_x * t500 + z3_6_z * t497);
        let t521 = c5 * t497 - s5 * t500;
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
        let t522 = c7 * t203;
        let t524 = t522 + s7 * t205;
        let t525 = s7 * t203;
        let t527 = c7 * t205 - t525;
        let t529 = t499 + c6 * t524;
        let t531 = t502 - s6 * t524;
        let t536 = z1_4_y * t531 - (z1_5_x * t529 - t226 * t527);
        let t541 = t232 * t527 - z2_5_x * t529 - t220 * t531;
        let t546 = c4 * t531 + (z3_6_z * t527 - z3_5_x * t529);
        let t549 = s5 * t529 + c5 * t527;
        put(5, t536); // row 1, YY
        put(15, t541); // row 2, YY
        put(25, t546); // row 3, YY
        put(35, t549); // row 4, YY
        put(45, t531); // row 5, YY
        put(55, t527); // row 6, YY
        [t522, t525]
    };
    // payload: column ZZ
    let t576 = {
        let t550 = t522 - t493;
        let t551 = t496 + t525;
        let t554 = c6 * t550 + s6 * dw7_z;
        let t557 = s6 * t550 - c6 * dw7_z;
        let t562 = z1_4_y * t557 + (z1_5_x * t554 + t226 * t551);
        let t567 = z2_5_x * t554 + t232 * t551 - t220 * t557;
        let t572 = c4 * t557 + (z3_5_x * t554 + z3_6_z * t551);
        let t575 = c5 * t551 - s5 * t554;
        let t576 = t210 - t207;
        put(6, t562); // row 1, ZZ
        put(16, t567); // row 2, ZZ
        put(26, t572); // row 3, ZZ
        put(36, t575); // row 4, ZZ
        put(46, t557); // row 5, ZZ
        put(56, t551); // row 6, ZZ
        put(65, t576); // row 7, XY
        t576
    };
    // payload: column XY
    {
        let t579 = c7 * t211 - s7 * t212;
        let t582 = s7 * t211 + c7 * t212;
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
        let t608 = t303 - s7 * t206;
        let t610 = t300 + c7 * t206;
        let t613 = c6 * t608 + s6 * t196;
        let t616 = s6 * t608 - c6 * t196;
        let t621 = z1_4_y * t616 + (z1_5_x * t613 + t226 * t610);
        let t626 = z2_5_x * t613 + t232 * t610 - t220 * t616;
        let t631 = c4 * t616 + (z3_5_x * t613 + z3_6_z * t610);
        let t634 = c5 * t610 - s5 * t613;
        let t635 = t170 - t210;
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
        let t637 = c7 * t635 - t368;
        let t639 = t365 + s7 * t635;
        let t642 = c6 * t637 + s6 * t193;
        let t645 = s6 * t637 - c6 * t193;
        let t650 = z1_4_y * t645 + (z1_5_x * t642 + t226 * t639);
        let t655 = z2_5_x * t642 + t232 * t639 - t220 * t645;
        let t660 = c4 * t645 + (z3_5_x * t642 + z3_6_z * t639);
        let t663 = c5 * t639 - s5 * t642;
        let t664 = -t242;
        let t665 = -t201;
        put(9, t650); // row 1, YZ
        put(19, t655); // row 2, YZ
        put(29, t660); // row 3, YZ
        put(39, t663); // row 4, YZ
        put(49, t645); // row 5, YZ
        put(50, t664); // row 6, M
        put(59, t639); // row 6, YZ
        put(63, t665); // row 7, YY
    }
}
