//! Regressor of a body fixed to the tool frame.
//!
//! `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin (the paper's (7)).
//!
//! 270 multiplications, 190 additions; 6 x 10, 58 of 60 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 58;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9),
    (1, 0), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7), (1, 8), (1, 9),
    (2, 0), (2, 1), (2, 2), (2, 3), (2, 4), (2, 5), (2, 6), (2, 7), (2, 8), (2, 9),
    (3, 0), (3, 1), (3, 2), (3, 3), (3, 4), (3, 5), (3, 6), (3, 7), (3, 8), (3, 9),
    (4, 0), (4, 1), (4, 2), (4, 3), (4, 4), (4, 5), (4, 6), (4, 7), (4, 8), (4, 9),
    (5, 1), (5, 2), (5, 4), (5, 5), (5, 6), (5, 7), (5, 8), (5, 9),
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
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let A3 = S::constant(-0.57155);
    let D4 = S::constant(0.17415);
    let D5 = S::constant(0.11985);
    let D6 = S::constant(0.11655);
    let k0 = S::constant(9.81);
    let k1 = S::constant(0.6127);
    let k2 = S::constant(0.57155);
    // link 2: motion
    let [w2_x, w2_y, a2_x, a2_y, t7, dw2_x, dw2_y] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let t7 = dq2 * w2_x;
        let dw2_x = s2 * ddq1 + dq2 * w2_y;
        let dw2_y = c2 * ddq1 - t7;
        [w2_x, w2_y, a2_x, a2_y, t7, dw2_x, dw2_y]
    };
    // link 3: motion
    let [
        w3_x, w3_y, t30, a3_x, a3_y, w3_z, dw3_x, dw3_y,
        dw3_z,
    ] = {
        let w3_x = c3 * w2_x + s3 * w2_y;
        let w3_y = c3 * w2_y - s3 * w2_x;
        let t30 = (t7 - dw2_y) * k1;
        let t31 = a2_x + (w2_y * w2_y + dq2 * dq2) * k1;
        let t32 = a2_y - (ddq2 + w2_x * w2_y) * k1;
        let a3_x = c3 * t31 + s3 * t32;
        let a3_y = c3 * t32 - s3 * t31;
        let w3_z = dq2 + dq3;
        let dw3_x = c3 * dw2_x + s3 * dw2_y + dq3 * w3_y;
        let dw3_y = c3 * dw2_y - s3 * dw2_x - dq3 * w3_x;
        let dw3_z = ddq2 + ddq3;
        [
        w3_x, w3_y, t30, a3_x, a3_y, w3_z, dw3_x, dw3_y,
        dw3_z,
    ]
    };
    // link 4: motion
    let [
        w4_x, t50, t80, a4_x, a4_y, w4_z, t90, t91,
        dw4_z,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_y;
        let t50 = s4 * w3_x - c4 * w3_y;
        let t58 = w3_y * w3_y;
        let t61 = w3_x * w3_z;
        let t78 = a3_x + ((t58 + w3_z * w3_z) * k2 + D4 * (dw3_y + t61));
        let t79 = a3_y + (D4 * (w3_y * w3_z - dw3_x) - (dw3_z + w3_x * w3_y) * k2);
        let t80 = t30 + (D4 * (w3_x * w3_x + t58) - (dw3_y - t61) * k2);
        let a4_x = c4 * t78 + s4 * t79;
        let a4_y = c4 * t79 - s4 * t78;
        let w4_z = w3_z + dq4;
        let t90 = dq4 * t50 - (c4 * dw3_x + s4 * dw3_y);
        let t91 = s4 * dw3_x - c4 * dw3_y + dq4 * w4_x;
        let dw4_z = dw3_z + ddq4;
        [
        w4_x, t50, t80, a4_x, a4_y, w4_z, t90, t91,
        dw4_z,
    ]
    };
    // link 5: motion
    let [
        w5_x, t98, t116, a5_x, t123, w5_z, t127, t128,
        dw5_z,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let t98 = s5 * w4_x - c5 * w4_z;
        let t115 = a4_x + D5 * (dw4_z + w4_x * t50);
        let t116 = a4_y + D5 * (w4_x * w4_x + w4_z * w4_z);
        let t117 = t80 - D5 * (t90 + t50 * w4_z);
        let a5_x = c5 * t115 - s5 * t117;
        let t123 = c5 * t117 + s5 * t115;
        let w5_z = t50 + dq5;
        let t127 = c5 * t90 - s5 * dw4_z + dq5 * t98;
        let t128 = dq5 * w5_x - (c5 * dw4_z + s5 * t90);
        let dw5_z = t91 + ddq5;
        [
        w5_x, t98, t116, a5_x, t123, w5_z, t127, t128,
        dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, t135, t153, t157, a6_y, w6_z, t164, t165,
        dw6_z,
    ] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t135 = c6 * w5_z + s6 * w5_x;
        let t152 = D6 * (dw5_z + w5_x * t98) - a5_x;
        let t153 = t123 + D6 * (w5_x * w5_x + w5_z * w5_z);
        let t154 = t116 + D6 * (t127 + t98 * w5_z);
        let t157 = c6 * t152 - s6 * t154;
        let a6_y = c6 * t154 + s6 * t152;
        let w6_z = dq6 - t98;
        let t164 = c6 * t127 + s6 * dw5_z + dq6 * t135;
        let t165 = c6 * dw5_z - s6 * t127 + dq6 * w6_x;
        let dw6_z = ddq6 - t128;
        put(50, a6_y); // row 6, MSX
        put(51, t157); // row 6, MSY
        put(54, dw6_z); // row 6, ZZ
        [
        w6_x, t135, t153, t157, a6_y, w6_z, t164, t165,
        dw6_z,
    ]
    };
    // joint axes in frame 3
    let [v1_3_z, z1_3_x, t173, t174, t175] = {
        let v1_3_z = c2 * k1;
        let z1_3_x = s2 * c3 + c2 * s3;
        let t173 = s2 * s3 - c2 * c3;
        let t174 = s3 * k1;
        let t175 = c3 * k1;
        [v1_3_z, z1_3_x, t173, t174, t175]
    };
    // joint axes in frame 4
    let [
        v1_4_z, t182, t185, t188, t191, v2_4_x, v2_4_y, t199,
        v3_5_z,
    ] = {
        let t176 = D4 * t173;
        let t177 = D4 * z1_3_x;
        let v1_4_z = v1_3_z - k2 * t173;
        let t182 = s4 * t173 - c4 * z1_3_x;
        let t185 = c4 * t173 + s4 * z1_3_x;
        let t188 = c4 * t176 + s4 * t177;
        let t191 = s4 * t176 - c4 * t177;
        let t192 = A3 - t175;
        let v2_4_x = s4 * t192 - c4 * t174;
        let v2_4_y = c4 * t192 + s4 * t174;
        let t199 = s4 * k2;
        let v3_5_z = c4 * k2;
        [
        v1_4_z, t182, t185, t188, t191, v2_4_x, v2_4_y, t199,
        v3_5_z,
    ]
    };
    // joint axes in frame 5
    let [t201, t202] = {
        let t201 = c5 * t182;
        let t202 = s5 * t182;
        [t201, t202]
    };
    // joint axes in frame 6
    let [
        t203, t204, t205, t206, t207, t208, t209, t210,
        t211, t212, t213, t214, t215, t216, t217,
    ] = {
        let t203 = w6_x * w6_x;
        let t204 = t135 * t135;
        let t205 = w6_z * w6_z;
        let t206 = w6_x * t135;
        let t207 = w6_x * w6_z;
        let t208 = t135 * w6_z;
        let t209 = t204 + t205;
        let t210 = dw6_z + t206;
        let t211 = t207 - t165;
        let t212 = t206 - dw6_z;
        let t213 = t203 + t205;
        let t214 = t208 - t164;
        let t215 = t165 + t207;
        let t216 = t164 + t208;
        let t217 = t203 + t204;
        put(52, t206); // row 6, XX
        put(56, t214); // row 6, XZ
        put(57, t211); // row 6, YZ
        [
        t203, t204, t205, t206, t207, t208, t209, t210,
        t211, t212, t213, t214, t215, t216, t217,
    ]
    };
    // payload: column M
    let [t220, t223] = {
        let t220 = c6 * t157 + s6 * a6_y;
        let t223 = c6 * a6_y - s6 * t157;
        let t224 = D6 * t223;
        let t225 = D6 * t220;
        let t228 = s5 * t153 - c5 * t220;
        let t231 = s5 * t220 + c5 * t153;
        let t237 = D5 * t228 - s5 * t224;
        let t240 = t182 * (D5 * t231 - c5 * t224) - t185 * t225;
        let t246 = t191 * t223 - t188 * t228 - v1_4_z * t231 - t240;
        let t250 = t237 + (v2_4_x * t228 + v2_4_y * t223);
        let t254 = t237 - (t199 * t228 + v3_5_z * t223);
        put(0, t246); // row 1, M
        put(10, t250); // row 2, M
        put(20, t254); // row 3, M
        put(30, t237); // row 4, M
        put(40, t225); // row 5, M
        [t220, t223]
    };
    // payload: column MSX
    let [t256, t259, t261, t262] = {
        let t256 = s6 * t212;
        let t257 = c6 * t209 - t256;
        let t259 = c6 * t212;
        let t260 = s6 * t209 + t259;
        let t261 = s6 * t153;
        let t262 = c6 * t153;
        let t265 = t261 - D6 * t260;
        let t266 = D6 * t257 - t262;
        let t269 = c5 * t257 + s5 * t215;
        let t272 = s5 * t257 - c5 * t215;
        let t282 = c5 * a6_y - s5 * t265 - D5 * t269;
        let t285 = t185 * t266 - t182 * (D5 * t272 - (c5 * t265 + s5 * a6_y));
        let t291 = t285 + (t188 * t269 - t191 * t260 - v1_4_z * t272);
        let t295 = t282 - (v2_4_x * t269 + v2_4_y * t260);
        let t299 = t282 + (t199 * t269 + v3_5_z * t260);
        put(1, t291); // row 1, MSX
        put(11, t295); // row 2, MSX
        put(21, t299); // row 3, MSX
        put(31, t282); // row 4, MSX
        put(41, t266); // row 5, MSX
        [t256, t259, t261, t262]
    };
    // payload: column MSY
    let [t300, t303] = {
        let t300 = c6 * t210;
        let t302 = t300 - s6 * t213;
        let t303 = s6 * t210;
        let t305 = t303 + c6 * t213;
        let t308 = D6 * t305 - t262;
        let t309 = t261 + D6 * t302;
        let t312 = s5 * t216 - c5 * t302;
        let t315 = s5 * t302 + c5 * t216;
        let t325 = s5 * t308 + c5 * t157 + D5 * t312;
        let t328 = t182 * (s5 * t157 - c5 * t308 - D5 * t315) + t185 * t309;
        let t334 = t328 - (v1_4_z * t315 + (t188 * t312 + t191 * t305));
        let t338 = t325 - (v2_4_y * t305 - v2_4_x * t312);
        let t342 = t325 + (v3_5_z * t305 - t199 * t312);
        put(2, t334); // row 1, MSY
        put(12, t338); // row 2, MSY
        put(22, t342); // row 3, MSY
        put(32, t325); // row 4, MSY
        put(42, t309); // row 5, MSY
        [t300, t303]
    };
    // payload: column MSZ
    {
        let t345 = c6 * t211 + s6 * t214;
        let t348 = s6 * t211 - c6 * t214;
        let t351 = t223 + D6 * t348;
        let t352 = t220 - D6 * t345;
        let t355 = c5 * t345 + s5 * t217;
        let t358 = s5 * t345 - c5 * t217;
        let t364 = D5 * t355 - s5 * t351;
        let t372 = v1_4_z * t358 + (t191 * t348 - t188 * t355);
        let t373 = t182 * (c5 * t351 + D5 * t358) + t185 * t352 + t372;
        let t377 = t364 + (v2_4_x * t355 + v2_4_y * t348);
        let t381 = t364 - (t199 * t355 + v3_5_z * t348);
        put(3, t373); // row 1, MSZ
        put(13, t377); // row 2, MSZ
        put(23, t381); // row 3, MSZ
        put(33, t364); // row 4, MSZ
        put(43, t352); // row 5, MSZ
    }
    // payload: column XX
    let [t383, t386, t389, t394] = {
        let t383 = s6 * t207;
        let t384 = c6 * t164 + t383;
        let t386 = c6 * t207;
        let t387 = s6 * t164 - t386;
        let t389 = t202 * t206;
        let t392 = t185 * t387 + (t201 * t384 + t389);
        let t394 = c5 * t206;
        let t395 = t394 - s5 * t384;
        put(4, t392); // row 1, XX
        put(14, t395); // row 2, XX
        put(24, t395); // row 3, XX
        put(34, t395); // row 4, XX
        put(44, t387); // row 5, XX
        [t383, t386, t389, t394]
    };
    // payload: column YY
    let [t396, t399] = {
        let t396 = c6 * t208;
        let t398 = t396 + s6 * t165;
        let t399 = s6 * t208;
        let t401 = c6 * t165 - t399;
        let t405 = t185 * t401 - (t389 + t201 * t398);
        let t407 = s5 * t398 - t394;
        put(5, t405); // row 1, YY
        put(15, t407); // row 2, YY
        put(25, t407); // row 3, YY
        put(35, t407); // row 4, YY
        put(45, t401); // row 5, YY
        [t396, t399]
    };
    // payload: column ZZ
    let t418 = {
        let t408 = t383 - t396;
        let t409 = t386 + t399;
        let t414 = t185 * t409 + (dw6_z * t202 - t201 * t408);
        let t417 = s5 * t408 + c5 * dw6_z;
        let t418 = t203 - t204;
        put(6, t414); // row 1, ZZ
        put(16, t417); // row 2, ZZ
        put(26, t417); // row 3, ZZ
        put(36, t417); // row 4, ZZ
        put(46, t409); // row 5, ZZ
        put(55, t418); // row 6, XY
        t418
    };
    // payload: column XY
    let t433 = {
        let t421 = s6 * t216 - c6 * t215;
        let t424 = s6 * t215 + c6 * t216;
        let t429 = t185 * t424 + (t202 * t418 - t201 * t421);
        let t432 = s5 * t421 + c5 * t418;
        let t433 = t203 - t205;
        put(7, t429); // row 1, XY
        put(17, t432); // row 2, XY
        put(27, t432); // row 3, XY
        put(37, t432); // row 4, XY
        put(47, t424); // row 5, XY
        t433
    };
    // payload: column XZ
    let t446 = {
        let t435 = t259 - s6 * t433;
        let t437 = t256 + c6 * t433;
        let t442 = t185 * t437 + (t201 * t435 + t202 * t214);
        let t445 = c5 * t214 - s5 * t435;
        let t446 = t205 - t204;
        put(8, t442); // row 1, XZ
        put(18, t445); // row 2, XZ
        put(28, t445); // row 3, XZ
        put(38, t445); // row 4, XZ
        put(48, t437); // row 5, XZ
        t446
    };
    // payload: column YZ
    {
        let t448 = t303 + c6 * t446;
        let t450 = s6 * t446 - t300;
        let t455 = t185 * t450 + (t201 * t448 + t202 * t211);
        let t458 = c5 * t211 - s5 * t448;
        let t459 = -t206;
        put(9, t455); // row 1, YZ
        put(19, t458); // row 2, YZ
        put(29, t458); // row 3, YZ
        put(39, t458); // row 4, YZ
        put(49, t450); // row 5, YZ
        put(53, t459); // row 6, YY
    }
}
