//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 455 multiplications, 367 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, Trig};

/// Accelerations that torques cause: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE], out: &mut [S; 6]) {
    entries(trig, dq, tau, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [tau1, tau2, tau3, tau4, tau5, tau6] = *tau;
    let [
        YY1R, MSX2, MSZ2, YY2R, ZZ2R, XY2R, XZ2R, YZ2R, M3R, MSX3, MSY3, MSZ3R,
        MSX4, MSZ4R, YY4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSZ5R, YY5R, ZZ5R, XY5,
        XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6, IA3, IA4, IA5,
        IA6,
        ..] = *beta;
    let D2 = S::constant(0.154);
    let D6 = S::constant(0.263);
    let k2 = S::constant(9.81);
    let k3 = S::constant(2.0);
    let k4 = S::constant(1.0);
    // composite body 6
    let [
        t0, t3, t6, t15, t16, t18, t24, t40,
        t48, t57, t60, t63,
    ] = {
        let t0 = ZZ6 + IA6;
        let t3 = c6 * MSY6 + s6 * MSX6;
        let t6 = c6 * MSX6 - s6 * MSY6;
        let t15 = c6 * XZ6 - s6 * YZ6 - D6 * t6;
        let t16 = s6 * XZ6 + c6 * YZ6 - D6 * t3;
        let t17 = c5 * t3;
        let t18 = s5 * t3;
        let t21 = c5 * t15 + s5 * ZZ6;
        let t24 = s5 * t15 - c5 * ZZ6;
        let t30 = c4 * t6 - s4 * t17;
        let t39 = s4 * t21 + c4 * t16 - q3 * (c4 * t17 + s4 * t6);
        let t40 = q3 * t30 - (c4 * t21 - s4 * t16);
        let t48 = s2 * t39 + c2 * t24 + D2 * (c2 * t30 + s2 * t18);
        let t50 = s6 * XY6;
        let t53 = c6 * XY6;
        let t54 = s6 * XX6R + t53;
        let t57 = c6 * (c6 * XX6R - t50) - s6 * t53;
        let t60 = c6 * t54 - s6 * t50;
        let t63 = s6 * t54 + c6 * t50;
        [
        t0, t3, t6, t15, t16, t18, t24, t40,
        t48, t57, t60, t63,
    ]
    };
    // composite body 5
    let [
        t66, t70, t73, t76, t79, t82, t94, t102,
        t115, t118, t121,
    ] = {
        let t64 = MSX5 + t6;
        let t65 = ZZ5R + ZZ6;
        let t66 = YY5R + t63;
        let t67 = XZ5 + t15;
        let t68 = XY5 + t60;
        let t69 = YZ5 + t16;
        let t70 = IA5 + t66;
        let t73 = c5 * MSZ5R - s5 * t64;
        let t76 = s5 * MSZ5R + c5 * t64;
        let t79 = c5 * t68 + s5 * t69;
        let t82 = s5 * t68 - c5 * t69;
        let t84 = s4 * t73;
        let t94 = q3 * t84 - (c4 * t79 - s4 * t66);
        let t99 = c2 * t82;
        let t100 = s2 * (s4 * t79 + c4 * t66 + q3 * (c4 * t73)) + t99;
        let t102 = t100 + D2 * (c2 * t84 - s2 * t76);
        let t104 = s5 * t67;
        let t107 = c5 * t67;
        let t108 = s5 * t57 - t107;
        let t112 = c5 * t65 - t104;
        let t115 = c5 * (c5 * t57 + t104) + s5 * (t107 + s5 * t65);
        let t118 = c5 * t108 - s5 * t112;
        let t121 = s5 * t108 + c5 * t112;
        [
        t66, t70, t73, t76, t79, t82, t94, t102,
        t115, t118, t121,
    ]
    };
    // composite body 4
    let [
        t125, t129, t132, t135, t138, t141, t145, t151,
        t164, t167, t170,
    ] = {
        let t122 = MSX4 + t76;
        let t123 = MSZ4R + t3;
        let t124 = ZZ4R + t66;
        let t125 = YY4R + t121;
        let t126 = XZ4 + t79;
        let t127 = XY4 + t118;
        let t128 = YZ4 + t82;
        let t129 = IA4 + t125;
        let t132 = c4 * t123 + s4 * t122;
        let t135 = c4 * t122 - s4 * t123;
        let t138 = s4 * t128 - c4 * t127;
        let t141 = s4 * t127 + c4 * t128;
        let t145 = q3 * t135 - t138;
        let t151 = D2 * (c2 * t135) - (s2 * (t141 + q3 * t132) + c2 * t125);
        let t153 = s4 * t126;
        let t156 = c4 * t126;
        let t157 = s4 * t115 + t156;
        let t161 = t153 + c4 * t124;
        let t164 = c4 * (c4 * t115 - t153) - s4 * (t156 - s4 * t124);
        let t167 = c4 * t157 - s4 * t161;
        let t170 = s4 * t157 + c4 * t161;
        [
        t125, t129, t132, t135, t138, t141, t145, t151,
        t164, t167, t170,
    ]
    };
    // composite body 3
    let [
        t171, t172, t174, t178, t180, t183, t185, t186,
        t188,
    ] = {
        let t171 = MSX3 + t135;
        let t172 = MSY3 + t132;
        let t173 = MSZ3R + t73;
        let t174 = M3R + IA3;
        let t178 = D2 * (s2 * M3R) - s2 * t171;
        let t180 = t173 + q3 * M3R;
        let t182 = q3 * (t173 + t180);
        let t183 = t170 + t182;
        let t185 = t141 + q3 * t172;
        let t186 = t164 + t182;
        let t188 = q3 * t171 - t138;
        [
        t171, t172, t174, t178, t180, t183, t185, t186,
        t188,
    ]
    };
    // composite body 2
    let [t192, t203, t217] = {
        let t192 = YY2R + t186;
        let t193 = t185 - XZ2R;
        let t202 = D2 * (c2 * (MSZ2 + t180) - s2 * (MSX2 + t172));
        let t203 = s2 * (XY2R - t167) - c2 * (YZ2R + t188) + t202;
        let t211 = c2 * (s2 * t193 + c2 * (ZZ2R + t125));
        let t216 = D2 * (D2 * M3R - t171 - t171);
        let t217 = s2 * (s2 * t183 + c2 * t193) + t211 + t216;
        [t192, t203, t217]
    };
    // composite body 1
    let t218 = {
        let t218 = YY1R + t217;
        t218
    };
    // link 2: motion
    let [t219, w3_z, t222, t223, t224, t225, dw2_y] = {
        let t219 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t222 = s2 * k2;
        let t223 = c2 * k2;
        let t224 = D2 * (dq1 * dq1);
        let t225 = dq2 * w3_z;
        let dw2_y = dq2 * t219;
        [t219, w3_z, t222, t223, t224, t225, dw2_y]
    };
    // link 3: motion
    let [
        t227, t228, t229, t230, t231, t232, t233, t234,
        t235, t240, t245, a3_y,
    ] = {
        let t227 = t219 * t219;
        let t228 = w3_z * w3_z;
        let t229 = dq2 * dq2;
        let t230 = t219 * w3_z;
        let t231 = t228 + t229;
        let t232 = t227 + t229;
        let t233 = dw2_y + dw2_y;
        let t234 = t225 + t225;
        let t235 = t227 + t228;
        let t240 = q3 * t232 - t223;
        let t242 = dq3 * k3;
        let t245 = q3 * t234 - t224 + t219 * t242;
        let a3_y = dq2 * t242 - (t222 + q3 * t230);
        [
        t227, t228, t229, t230, t231, t232, t233, t234,
        t235, t240, t245, a3_y,
    ]
    };
    // link 4: motion
    let [t249, w4_y, a4_x, a4_y, w4_z, dw4_x, dw4_y] = {
        let t249 = c4 * dq2 + s4 * t219;
        let w4_y = s4 * dq2 - c4 * t219;
        let a4_x = s4 * a3_y - c4 * t245;
        let a4_y = c4 * a3_y + s4 * t245;
        let w4_z = w3_z + dq4;
        let dw4_x = dq4 * w4_y - s4 * t225;
        let dw4_y = dq4 * t249 - c4 * t225;
        [t249, w4_y, a4_x, a4_y, w4_z, dw4_x, dw4_y]
    };
    // link 5: motion
    let [
        t268, w5_y, t278, t279, t280, t281, t282, t283,
        t284, t285, t286, t287, t288, t289, t290, t291,
        a5_x, a5_y, w5_z, dw5_x, dw5_y,
    ] = {
        let t268 = c5 * t249 + s5 * w4_z;
        let w5_y = s5 * t249 - c5 * w4_z;
        let t278 = t249 * t249;
        let t279 = w4_y * w4_y;
        let t280 = w4_z * w4_z;
        let t281 = t249 * w4_y;
        let t282 = t249 * w4_z;
        let t283 = w4_y * w4_z;
        let t284 = t279 + t280;
        let t285 = dw2_y - t281;
        let t286 = dw4_y - t282;
        let t287 = dw2_y + t281;
        let t288 = t278 + t280;
        let t289 = t283 - dw4_x;
        let t290 = dw4_y + t282;
        let t291 = dw4_x + t283;
        let a5_x = c5 * a4_x + s5 * t240;
        let a5_y = c5 * t240 - s5 * a4_x;
        let w5_z = w4_y + dq5;
        let dw5_x = c5 * dw4_x + s5 * dw2_y + dq5 * w5_y;
        let dw5_y = c5 * dw2_y - s5 * dw4_x + dq5 * t268;
        [
        t268, w5_y, t278, t279, t280, t281, t282, t283,
        t284, t285, t286, t287, t288, t289, t290, t291,
        a5_x, a5_y, w5_z, dw5_x, dw5_y,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t315, t316, t317, t318, t319, t320,
        t321, t322, t323, t324, t325, t326, t327, t328,
        t333, a6_x, a6_y, w6_z, dw6_x, dw6_y,
    ] = {
        let w6_x = s6 * w5_z - c6 * t268;
        let w6_y = c6 * w5_z + s6 * t268;
        let t315 = t268 * t268;
        let t316 = w5_y * w5_y;
        let t317 = w5_z * w5_z;
        let t318 = t268 * w5_y;
        let t319 = t268 * w5_z;
        let t320 = w5_y * w5_z;
        let t321 = t316 + t317;
        let t322 = dw4_y + t318;
        let t323 = dw5_y - t319;
        let t324 = dw4_y - t318;
        let t325 = t315 + t317;
        let t326 = t320 - dw5_x;
        let t327 = dw5_y + t319;
        let t328 = dw5_x + t320;
        let t332 = a5_x + D6 * t322;
        let t333 = a5_y + D6 * t325;
        let t334 = a4_y - D6 * t328;
        let a6_x = c6 * t332 + s6 * t334;
        let a6_y = c6 * t334 - s6 * t332;
        let w6_z = dq6 - w5_y;
        let dw6_x = c6 * dw5_x + s6 * dw4_y + dq6 * w6_y;
        let dw6_y = c6 * dw4_y - s6 * dw5_x - dq6 * w6_x;
        [
        w6_x, w6_y, t315, t316, t317, t318, t319, t320,
        t321, t322, t323, t324, t325, t326, t327, t328,
        t333, a6_x, a6_y, w6_z, dw6_x, dw6_y,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t408, t411, t420, t421] = {
        let t346 = w6_x * w6_x;
        let t347 = w6_y * w6_y;
        let t348 = w6_z * w6_z;
        let t349 = w6_x * w6_y;
        let t350 = w6_x * w6_z;
        let t351 = w6_y * w6_z;
        let t353 = dw5_y + t349;
        let t355 = t349 - dw5_y;
        let t358 = t350 - dw6_y;
        let t359 = dw6_x + t351;
        let t378 = XZ6 * (t351 - dw6_x);
        let t383 = YZ6 * (t347 - t348);
        let t384 = YZ6 * t353;
        let t385 = YZ6 * (dw6_y + t350);
        let t386 = ZZ6 * t351 + XX6R * dw6_x - XY6 * t358 + XZ6 * t355 + t383;
        let t387 = t350 * (XX6R - ZZ6) + XY6 * t359 + XZ6 * (t348 - t346) - t384;
        let t388 = XY6 * (t346 - t347) - (XX6R * t349 + ZZ6 * dw5_y) - t378 + t385;
        let f6_x = MSY6 * t353 - MSX6 * (t347 + t348);
        let f6_y = MSX6 * t355 - MSY6 * (t346 + t348);
        let f6_z = MSX6 * t358 + MSY6 * t359;
        let n6_x = t386 - MSY6 * t333;
        let n6_y = t387 + MSX6 * t333;
        let n6_z = t388 + (MSX6 * a6_y - MSY6 * a6_x);
        let t408 = c6 * f6_x - s6 * f6_y;
        let t411 = s6 * f6_x + c6 * f6_y;
        let t420 = c6 * n6_x - s6 * n6_y - D6 * t411;
        let t421 = s6 * n6_x + c6 * n6_y + D6 * t408;
        [f6_z, n6_z, t408, t411, t420, t421]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t476, t479, t482, t485] = {
        let t442 = YY5R * dw4_y - ZZ5R * t318 - XY5 * t326 + XZ5 * (t316 - t315);
        let t443 = XY5 * (t315 - t317) - (YY5R * t319 + ZZ5R * dw5_y) + XZ5 * t328;
        let t445 = YZ5 * (t317 - t316);
        let t460 = MSZ5R * a4_y;
        let t465 = XY5 * t324 - t320 * (ZZ5R - YY5R) - XZ5 * t327 + t445 - t460;
        let f5_x = t408 + (MSZ5R * t322 - MSX5 * t321);
        let f5_y = MSX5 * t324 + MSZ5R * t325 - f6_z;
        let f5_z = t411 - (MSX5 * t327 + MSZ5R * t328);
        let n5_x = t420 + t465;
        let t472 = n6_z + (t443 + YZ5 * t322 + MSX5 * a4_y);
        let n5_z = t421 + (t442 - YZ5 * t323 + (MSZ5R * a5_x + MSX5 * a5_y));
        let t476 = c5 * f5_x - s5 * f5_y;
        let t479 = s5 * f5_x + c5 * f5_y;
        let t482 = c5 * n5_x + s5 * t472;
        let t485 = s5 * n5_x - c5 * t472;
        [f5_z, n5_z, t476, t479, t482, t485]
    };
    // link 4: force and moment
    let [t534, t537, t540, t543, t546, t549] = {
        let t506 = ZZ4R * t281 + YY4R * dw2_y - XY4 * t289 + XZ4 * (t279 - t278);
        let t507 = YY4R * t282 + ZZ4R * dw4_y + XY4 * (t278 - t280) + XZ4 * t291;
        let t509 = YZ4 * (t280 - t279);
        let t524 = MSZ4R * t240;
        let t529 = XY4 * t287 - t283 * (ZZ4R - YY4R) + XZ4 * t290 + t509 - t524;
        let f4_x = t476 + (MSZ4R * t285 - MSX4 * t284);
        let f4_y = f5_z - (MSX4 * t287 + MSZ4R * t288);
        let t534 = t479 + (MSX4 * t290 - MSZ4R * t291);
        let n4_x = t482 + t529;
        let n4_y = n5_z + (t507 + YZ4 * t285 + MSX4 * t240);
        let t537 = t485 + (t506 + YZ4 * t286 + (MSZ4R * a4_x - MSX4 * a4_y));
        let t540 = c4 * f4_x - s4 * f4_y;
        let t543 = s4 * f4_x + c4 * f4_y;
        let t546 = c4 * n4_x - s4 * n4_y;
        let t549 = s4 * n4_x + c4 * n4_y;
        [t534, t537, t540, t543, t546, t549]
    };
    // link 3: force and moment
    let [t550, t551, t552, f3_y, t581, n3_z, t587, t588] = {
        let t550 = t229 - t227;
        let t551 = t228 - t229;
        let t552 = t227 - t228;
        let f3_x = t540 + (MSY3 * t233 - MSX3 * t235 - MSZ3R * t234 - M3R * t245);
        let f3_y = t543 + (M3R * a3_y - (MSY3 * t231 + MSZ3R * t230));
        let t581 = t534 + (M3R * t240 + (MSY3 * t230 + MSZ3R * t232));
        let n3_x = t546 - (MSY3 * t240 + MSZ3R * a3_y);
        let n3_y = t549 + (MSX3 * t240 - MSZ3R * t245);
        let n3_z = MSX3 * a3_y + MSY3 * t245 - t537;
        let t587 = n3_y + q3 * f3_x;
        let t588 = q3 * f3_y - n3_x;
        [t550, t551, t552, f3_y, t581, n3_z, t587, t588]
    };
    // link 2: force and moment
    let [n2_z, t634] = {
        let t606 = t225 * (ZZ2R - YY2R) + XY2R * t230 - XZ2R * t233 - YZ2R * t551;
        let t607 = dw2_y * (YY2R + ZZ2R) + XY2R * t550 + XZ2R * t234 + YZ2R * t230;
        let f2_x = f3_y - (MSX2 * t231 + MSZ2 * t230);
        let f2_y = t581 + (MSX2 * t230 + MSZ2 * t232);
        let n2_x = t587 + (t606 + MSZ2 * t224);
        let n2_y = t607 + MSX2 * t224 - n3_z;
        let n2_z = t588 + (ZZ2R * t230 - XZ2R * t552 - (MSZ2 * t222 + MSX2 * t223));
        let f1_x = c2 * f2_x - s2 * f2_y;
        let t634 = s2 * n2_x + c2 * n2_y + D2 * f1_x;
        [n2_z, t634]
    };
    // drives
    let [t635, t636, t637, t638, t639, t640] = {
        let t635 = t634 + tau1;
        let t636 = tau2 - n2_z;
        let t637 = t581 + tau3;
        let t638 = t537 + tau4;
        let t639 = tau5 - n5_z;
        let t640 = tau6 - n6_z;
        [t635, t636, t637, t638, t639, t640]
    };
    // M = L D L'
    let [
        t641, t642, t643, t644, t645, t646, t650, t654,
        t657, t660, t663, t670, t676, t681, t686, t696,
        t706, t713, t726, t739, t755,
    ] = {
        let t641 = k4 / t218;
        let t642 = t203 * t641;
        let t643 = t178 * t641;
        let t644 = t151 * t641;
        let t645 = t102 * t641;
        let t646 = t48 * t641;
        let t649 = t192 - t218 * (t642 * t642);
        let t650 = k4 / t649;
        let t651 = t218 * t642;
        let t654 = t650 * (t172 + t643 * t651);
        let t657 = t650 * (t145 - t644 * t651);
        let t660 = t650 * (t94 - t645 * t651);
        let t663 = t650 * (t40 - t646 * t651);
        let t669 = t174 - t218 * (t643 * t643) - t649 * (t654 * t654);
        let t670 = k4 / t669;
        let t671 = t218 * t643;
        let t673 = t649 * t654;
        let t676 = t670 * (t657 * t673 - t644 * t671);
        let t681 = t670 * (t660 * t673 - (t76 + t645 * t671));
        let t686 = t670 * (t18 - t646 * t671 + t663 * t673);
        let t694 = t669 * (t676 * t676);
        let t695 = t129 - t218 * (t644 * t644) - t649 * (t657 * t657) - t694;
        let t696 = k4 / t695;
        let t697 = t218 * t644;
        let t700 = t649 * t657;
        let t703 = t669 * t676;
        let t706 = t696 * (t82 + t645 * t697 + t660 * t700 + t681 * t703);
        let t713 = t696 * (t24 + t646 * t697 + t663 * t700 + t686 * t703);
        let t721 = t669 * (t681 * t681);
        let t724 = t695 * (t706 * t706);
        let t725 = t70 - t218 * (t645 * t645) - t649 * (t660 * t660) - t721 - t724;
        let t726 = k4 / t725;
        let t734 = t686 * (t669 * t681);
        let t737 = t713 * (t695 * t706);
        let t738 = t16 - t646 * (t218 * t645) - t663 * (t649 * t660) - t734 - t737;
        let t739 = t726 * t738;
        let t747 = t669 * (t686 * t686);
        let t750 = t695 * (t713 * t713);
        let t751 = t0 - t218 * (t646 * t646) - t649 * (t663 * t663) - t747 - t750;
        let t755 = k4 / (t751 - t725 * (t739 * t739));
        [
        t641, t642, t643, t644, t645, t646, t650, t654,
        t657, t660, t663, t670, t676, t681, t686, t696,
        t706, t713, t726, t739, t755,
    ]
    };
    // ddq
    {
        let t757 = t636 + t635 * t642;
        let t761 = t637 + t635 * t643 + t654 * t757;
        let t767 = t638 + t635 * t644 - t657 * t757 - t676 * t761;
        let t775 = t639 + t635 * t645 - t660 * t757 - t681 * t761 + t706 * t767;
        let t783 = t640 + t635 * t646 - t663 * t757 - t686 * t761 + t713 * t767;
        let t791 = t755 * (t783 - t739 * t775);
        let t793 = t726 * t775 - t739 * t791;
        let t797 = t696 * t767 + t706 * t793 + t713 * t791;
        let t803 = t670 * t761 - t676 * t797 - t681 * t793 - t686 * t791;
        let t810 = t663 * t791;
        let t811 = t650 * t757 + t654 * t803 - t657 * t797 - t660 * t793 - t810;
        let t818 = t645 * t793;
        let t819 = t635 * t641 + t642 * t811 + t643 * t803 + t644 * t797 + t818;
        let t821 = t819 + t646 * t791;
        put(0, t821);
        put(1, t811);
        put(2, t803);
        put(3, t797);
        put(4, t793);
        put(5, t791);
    }
}
