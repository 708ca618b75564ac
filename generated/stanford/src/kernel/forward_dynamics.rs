//! Accelerations that torques cause.
//!
//! `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
//!
//! 450 multiplications, 361 additions; 6, 6 of 6 structurally nonzero.

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
        XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        ..] = *beta;
    let D2 = S::constant(0.154);
    let D6 = S::constant(0.263);
    let k2 = S::constant(9.81);
    let k3 = S::constant(2.0);
    let k4 = S::constant(1.0);
    // composite body 6
    let [
        t2, t5, t14, t15, t17, t23, t39, t47,
        t56, t59, t62,
    ] = {
        let t2 = c6 * MSY6 + s6 * MSX6;
        let t5 = c6 * MSX6 - s6 * MSY6;
        let t14 = c6 * XZ6 - s6 * YZ6 - D6 * t5;
        let t15 = s6 * XZ6 + c6 * YZ6 - D6 * t2;
        let t16 = c5 * t2;
        let t17 = s5 * t2;
        let t20 = c5 * t14 + s5 * ZZ6;
        let t23 = s5 * t14 - c5 * ZZ6;
        let t29 = c4 * t5 - s4 * t16;
        let t38 = s4 * t20 + c4 * t15 - q3 * (c4 * t16 + s4 * t5);
        let t39 = q3 * t29 - (c4 * t20 - s4 * t15);
        let t47 = s2 * t38 + c2 * t23 + D2 * (c2 * t29 + s2 * t17);
        let t49 = s6 * XY6;
        let t52 = c6 * XY6;
        let t53 = s6 * XX6R + t52;
        let t56 = c6 * (c6 * XX6R - t49) - s6 * t52;
        let t59 = c6 * t53 - s6 * t49;
        let t62 = s6 * t53 + c6 * t49;
        [
        t2, t5, t14, t15, t17, t23, t39, t47,
        t56, t59, t62,
    ]
    };
    // composite body 5
    let [
        t65, t71, t74, t77, t80, t92, t100, t113,
        t116, t119,
    ] = {
        let t63 = MSX5 + t5;
        let t64 = ZZ5R + ZZ6;
        let t65 = YY5R + t62;
        let t66 = XZ5 + t14;
        let t67 = XY5 + t59;
        let t68 = YZ5 + t15;
        let t71 = c5 * MSZ5R - s5 * t63;
        let t74 = s5 * MSZ5R + c5 * t63;
        let t77 = c5 * t67 + s5 * t68;
        let t80 = s5 * t67 - c5 * t68;
        let t82 = s4 * t71;
        let t92 = q3 * t82 - (c4 * t77 - s4 * t65);
        let t97 = c2 * t80;
        let t98 = s2 * (s4 * t77 + c4 * t65 + q3 * (c4 * t71)) + t97;
        let t100 = t98 + D2 * (c2 * t82 - s2 * t74);
        let t102 = s5 * t66;
        let t105 = c5 * t66;
        let t106 = s5 * t56 - t105;
        let t110 = c5 * t64 - t102;
        let t113 = c5 * (c5 * t56 + t102) + s5 * (t105 + s5 * t64);
        let t116 = c5 * t106 - s5 * t110;
        let t119 = s5 * t106 + c5 * t110;
        [
        t65, t71, t74, t77, t80, t92, t100, t113,
        t116, t119,
    ]
    };
    // composite body 4
    let [
        t123, t129, t132, t135, t138, t142, t148, t161,
        t164, t167,
    ] = {
        let t120 = MSX4 + t74;
        let t121 = MSZ4R + t2;
        let t122 = ZZ4R + t65;
        let t123 = YY4R + t119;
        let t124 = XZ4 + t77;
        let t125 = XY4 + t116;
        let t126 = YZ4 + t80;
        let t129 = c4 * t121 + s4 * t120;
        let t132 = c4 * t120 - s4 * t121;
        let t135 = s4 * t126 - c4 * t125;
        let t138 = s4 * t125 + c4 * t126;
        let t142 = q3 * t132 - t135;
        let t148 = D2 * (c2 * t132) - (s2 * (t138 + q3 * t129) + c2 * t123);
        let t150 = s4 * t124;
        let t153 = c4 * t124;
        let t154 = s4 * t113 + t153;
        let t158 = t150 + c4 * t122;
        let t161 = c4 * (c4 * t113 - t150) - s4 * (t153 - s4 * t122);
        let t164 = c4 * t154 - s4 * t158;
        let t167 = s4 * t154 + c4 * t158;
        [
        t123, t129, t132, t135, t138, t142, t148, t161,
        t164, t167,
    ]
    };
    // composite body 3
    let [t168, t169, t174, t176, t179, t181, t182, t184] = {
        let t168 = MSX3 + t132;
        let t169 = MSY3 + t129;
        let t170 = MSZ3R + t71;
        let t174 = D2 * (s2 * M3R) - s2 * t168;
        let t176 = t170 + q3 * M3R;
        let t178 = q3 * (t170 + t176);
        let t179 = t167 + t178;
        let t181 = t138 + q3 * t169;
        let t182 = t161 + t178;
        let t184 = q3 * t168 - t135;
        [t168, t169, t174, t176, t179, t181, t182, t184]
    };
    // composite body 2
    let [t188, t199, t213] = {
        let t188 = YY2R + t182;
        let t189 = t181 - XZ2R;
        let t198 = D2 * (c2 * (MSZ2 + t176) - s2 * (MSX2 + t169));
        let t199 = s2 * (XY2R - t164) - c2 * (YZ2R + t184) + t198;
        let t207 = c2 * (s2 * t189 + c2 * (ZZ2R + t123));
        let t212 = D2 * (D2 * M3R - t168 - t168);
        let t213 = s2 * (s2 * t179 + c2 * t189) + t207 + t212;
        [t188, t199, t213]
    };
    // composite body 1
    let t214 = {
        let t214 = YY1R + t213;
        t214
    };
    // link 1: motion
    let t215 = {
        let t215 = dq1 * dq1;
        t215
    };
    // link 2: motion
    let [
        t216, w3_z, t218, t219, t220, t221, t222, t223,
        dw2_y, t225, t226, t227, t228,
    ] = {
        let t216 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t218 = s2 * k2;
        let t219 = c2 * k2;
        let t220 = D2 * t215;
        let t221 = t216 * t216;
        let t222 = dq2 * dq2;
        let t223 = t216 * w3_z;
        let dw2_y = dq2 * t216;
        let t225 = dq2 * w3_z;
        let t226 = t221 + t222;
        let t227 = dw2_y + dw2_y;
        let t228 = t225 + t225;
        [
        t216, w3_z, t218, t219, t220, t221, t222, t223,
        dw2_y, t225, t226, t227, t228,
    ]
    };
    // link 3: motion
    let [t233, t238, a3_y, t241, t242] = {
        let t233 = q3 * t226 - t219;
        let t235 = dq3 * k3;
        let t238 = q3 * t228 - t220 + t216 * t235;
        let a3_y = dq2 * t235 - (t218 + q3 * t223);
        let t240 = w3_z * w3_z;
        let t241 = t221 + t240;
        let t242 = t222 + t240;
        [t233, t238, a3_y, t241, t242]
    };
    // link 4: motion
    let [
        t245, w4_y, a4_x, a4_y, t257, t260, w4_z, t262,
        t263, t264, t265, t266, dw4_y, t269, t270, t271,
        t272, t273,
    ] = {
        let t245 = c4 * dq2 + s4 * t216;
        let w4_y = s4 * dq2 - c4 * t216;
        let a4_x = s4 * a3_y - c4 * t238;
        let a4_y = c4 * a3_y + s4 * t238;
        let t257 = c4 * t228 + s4 * t223;
        let t260 = s4 * t228 - c4 * t223;
        let w4_z = w3_z + dq4;
        let t262 = t245 * t245;
        let t263 = w4_z * w4_z;
        let t264 = t245 * w4_y;
        let t265 = t245 * w4_z;
        let t266 = w4_y * w4_z;
        let dw4_x = t266 - t260;
        let dw4_y = t265 - t257;
        let t269 = dw2_y - t264;
        let t270 = dw2_y + t264;
        let t271 = t262 + t263;
        let t272 = t265 + dw4_y;
        let t273 = t266 + dw4_x;
        [
        t245, w4_y, a4_x, a4_y, t257, t260, w4_z, t262,
        t263, t264, t265, t266, dw4_y, t269, t270, t271,
        t272, t273,
    ]
    };
    // link 5: motion
    let [
        t276, w5_y, a5_x, a5_y, t288, t291, w5_z, t293,
        t294, t295, t296, t297, dw5_y, t300, t301, t302,
        t303, t304,
    ] = {
        let t276 = c5 * t245 + s5 * w4_z;
        let w5_y = s5 * t245 - c5 * w4_z;
        let a5_x = c5 * a4_x + s5 * t233;
        let a5_y = c5 * t233 - s5 * a4_x;
        let t288 = c5 * t269 - s5 * t273;
        let t291 = c5 * t273 + s5 * t269;
        let w5_z = w4_y + dq5;
        let t293 = t276 * t276;
        let t294 = w5_z * w5_z;
        let t295 = t276 * w5_y;
        let t296 = t276 * w5_z;
        let t297 = w5_y * w5_z;
        let dw5_x = t291 + t297;
        let dw5_y = t288 + t296;
        let t300 = dw4_y + t295;
        let t301 = dw4_y - t295;
        let t302 = t293 + t294;
        let t303 = t296 + dw5_y;
        let t304 = t297 + dw5_x;
        [
        t276, w5_y, a5_x, a5_y, t288, t291, w5_z, t293,
        t294, t295, t296, t297, dw5_y, t300, t301, t302,
        t303, t304,
    ]
    };
    // link 6: motion
    let [
        t315, a6_x, a6_y, t325, t328, t332, t333, t334,
        dw6_x, t337, t338, t339, t340, t341, t342, t343,
    ] = {
        let w6_x = s6 * w5_z - c6 * t276;
        let w6_y = c6 * w5_z + s6 * t276;
        let t314 = a5_x + D6 * t300;
        let t315 = a5_y + D6 * t302;
        let t316 = a4_y - D6 * t304;
        let a6_x = c6 * t314 + s6 * t316;
        let a6_y = c6 * t316 - s6 * t314;
        let t325 = c6 * t300 - s6 * t304;
        let t328 = c6 * t304 + s6 * t300;
        let w6_z = dq6 - w5_y;
        let t330 = w6_x * w6_x;
        let t331 = w6_z * w6_z;
        let t332 = w6_x * w6_y;
        let t333 = w6_x * w6_z;
        let t334 = w6_y * w6_z;
        let dw6_x = t328 + t334;
        let dw6_y = t325 - t333;
        let t337 = t330 - t331;
        let t338 = t337 - t302;
        let t339 = dw5_y + t332;
        let t340 = t332 - dw5_y;
        let t341 = t330 + t331;
        let t342 = t333 - dw6_y;
        let t343 = t334 + dw6_x;
        [
        t315, a6_x, a6_y, t325, t328, t332, t333, t334,
        dw6_x, t337, t338, t339, t340, t341, t342, t343,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t391, t394, t403, t404] = {
        let t364 = XY6 * (t338 + t341) - (XX6R * t332 + ZZ6 * dw5_y) + XZ6 * t328;
        let t366 = YZ6 * (t302 - t341);
        let t369 = ZZ6 * t334 + XX6R * dw6_x - XY6 * t342 + XZ6 * t340 + t366;
        let t370 = t333 * (XX6R - ZZ6) + XY6 * t343 - XZ6 * t337 - YZ6 * t339;
        let f6_x = MSX6 * t338 + MSY6 * t339;
        let f6_y = MSX6 * t340 - MSY6 * t341;
        let f6_z = MSX6 * t342 + MSY6 * t343;
        let n6_x = t369 - MSY6 * t315;
        let n6_y = t370 + MSX6 * t315;
        let n6_z = t364 + YZ6 * t325 + (MSX6 * a6_y - MSY6 * a6_x);
        let t391 = c6 * f6_x - s6 * f6_y;
        let t394 = s6 * f6_x + c6 * f6_y;
        let t403 = c6 * n6_x - s6 * n6_y - D6 * t394;
        let t404 = s6 * n6_x + c6 * n6_y + D6 * t391;
        [f6_z, n6_z, t391, t394, t403, t404]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t462, t465, t468, t471] = {
        let t405 = w5_y * w5_y;
        let t406 = t294 + t405;
        let t407 = t293 + t405;
        let t428 = YY5R * dw4_y - ZZ5R * t295 + XY5 * t291 + XZ5 * (t406 - t302);
        let t429 = XY5 * (t407 - t406) - (YY5R * t296 + ZZ5R * dw5_y) + XZ5 * t304;
        let t431 = YZ5 * (t302 - t407);
        let t446 = MSZ5R * a4_y;
        let t451 = XY5 * t301 - t297 * (ZZ5R - YY5R) - XZ5 * t303 + t431 - t446;
        let f5_x = t391 + (MSZ5R * t300 - MSX5 * t406);
        let f5_y = MSX5 * t301 + MSZ5R * t302 - f6_z;
        let f5_z = t394 - (MSX5 * t303 + MSZ5R * t304);
        let n5_x = t403 + t451;
        let t458 = n6_z + (t429 + YZ5 * t300 + MSX5 * a4_y);
        let n5_z = t404 + (t428 - YZ5 * t288 + (MSZ5R * a5_x + MSX5 * a5_y));
        let t462 = c5 * f5_x - s5 * f5_y;
        let t465 = s5 * f5_x + c5 * f5_y;
        let t468 = c5 * n5_x + s5 * t458;
        let t471 = s5 * n5_x - c5 * t458;
        [f5_z, n5_z, t462, t465, t468, t471]
    };
    // link 4: force and moment
    let [t523, t526, t529, t532, t535, t538] = {
        let t472 = w4_y * w4_y;
        let t473 = t263 + t472;
        let t474 = t262 + t472;
        let t495 = ZZ4R * t264 + YY4R * dw2_y - XY4 * t260 + XZ4 * (t473 - t271);
        let t496 = YY4R * t265 + ZZ4R * dw4_y + XY4 * (t474 - t473) + XZ4 * t273;
        let t498 = YZ4 * (t271 - t474);
        let t513 = MSZ4R * t233;
        let t518 = XY4 * t270 - t266 * (ZZ4R - YY4R) + XZ4 * t272 + t498 - t513;
        let f4_x = t462 + (MSZ4R * t269 - MSX4 * t473);
        let f4_y = f5_z - (MSX4 * t270 + MSZ4R * t271);
        let t523 = t465 + (MSX4 * t272 - MSZ4R * t273);
        let n4_x = t468 + t518;
        let n4_y = n5_z + (t496 + YZ4 * t269 + MSX4 * t233);
        let t526 = t471 + (t495 - YZ4 * t257 + (MSZ4R * a4_x - MSX4 * a4_y));
        let t529 = c4 * f4_x - s4 * f4_y;
        let t532 = s4 * f4_x + c4 * f4_y;
        let t535 = c4 * n4_x - s4 * n4_y;
        let t538 = s4 * n4_x + c4 * n4_y;
        [t523, t526, t529, t532, t535, t538]
    };
    // link 3: force and moment
    let [t539, t540, t541, f3_y, t570, n3_z, t576, t577] = {
        let t539 = t242 - t241;
        let t540 = t241 - t226;
        let t541 = t226 - t242;
        let f3_x = t529 + (MSY3 * t227 - MSX3 * t241 - MSZ3R * t228 - M3R * t238);
        let f3_y = t532 + (M3R * a3_y - (MSY3 * t242 + MSZ3R * t223));
        let t570 = t523 + (M3R * t233 + (MSY3 * t223 + MSZ3R * t226));
        let n3_x = t535 - (MSY3 * t233 + MSZ3R * a3_y);
        let n3_y = t538 + (MSX3 * t233 - MSZ3R * t238);
        let n3_z = MSX3 * a3_y + MSY3 * t238 - t526;
        let t576 = n3_y + q3 * f3_x;
        let t577 = q3 * f3_y - n3_x;
        [t539, t540, t541, f3_y, t570, n3_z, t576, t577]
    };
    // link 2: force and moment
    let [n2_z, t623] = {
        let t595 = t225 * (ZZ2R - YY2R) + XY2R * t223 - XZ2R * t227 - YZ2R * t540;
        let t596 = dw2_y * (YY2R + ZZ2R) + XY2R * t539 + XZ2R * t228 + YZ2R * t223;
        let f2_x = f3_y - (MSX2 * t242 + MSZ2 * t223);
        let f2_y = t570 + (MSX2 * t223 + MSZ2 * t226);
        let n2_x = t576 + (t595 + MSZ2 * t220);
        let n2_y = t596 + MSX2 * t220 - n3_z;
        let n2_z = t577 + (ZZ2R * t223 - XZ2R * t541 - (MSZ2 * t218 + MSX2 * t219));
        let f1_x = c2 * f2_x - s2 * f2_y;
        let t623 = s2 * n2_x + c2 * n2_y + D2 * f1_x;
        [n2_z, t623]
    };
    // drives
    let [t624, t625, t626, t627, t628, t629] = {
        let t624 = t623 + tau1;
        let t625 = tau2 - n2_z;
        let t626 = t570 + tau3;
        let t627 = t526 + tau4;
        let t628 = tau5 - n5_z;
        let t629 = tau6 - n6_z;
        [t624, t625, t626, t627, t628, t629]
    };
    // M = L D L'
    let [
        t630, t631, t632, t633, t634, t635, t639, t643,
        t646, t649, t652, t659, t665, t670, t675, t685,
        t695, t702, t715, t728, t744,
    ] = {
        let t630 = k4 / t214;
        let t631 = t199 * t630;
        let t632 = t174 * t630;
        let t633 = t148 * t630;
        let t634 = t100 * t630;
        let t635 = t47 * t630;
        let t638 = t188 - t214 * (t631 * t631);
        let t639 = k4 / t638;
        let t640 = t214 * t631;
        let t643 = t639 * (t169 + t632 * t640);
        let t646 = t639 * (t142 - t633 * t640);
        let t649 = t639 * (t92 - t634 * t640);
        let t652 = t639 * (t39 - t635 * t640);
        let t658 = M3R - t214 * (t632 * t632) - t638 * (t643 * t643);
        let t659 = k4 / t658;
        let t660 = t214 * t632;
        let t662 = t638 * t643;
        let t665 = t659 * (t646 * t662 - t633 * t660);
        let t670 = t659 * (t649 * t662 - (t74 + t634 * t660));
        let t675 = t659 * (t17 - t635 * t660 + t652 * t662);
        let t683 = t658 * (t665 * t665);
        let t684 = t123 - t214 * (t633 * t633) - t638 * (t646 * t646) - t683;
        let t685 = k4 / t684;
        let t686 = t214 * t633;
        let t689 = t638 * t646;
        let t692 = t658 * t665;
        let t695 = t685 * (t80 + t634 * t686 + t649 * t689 + t670 * t692);
        let t702 = t685 * (t23 + t635 * t686 + t652 * t689 + t675 * t692);
        let t710 = t658 * (t670 * t670);
        let t713 = t684 * (t695 * t695);
        let t714 = t65 - t214 * (t634 * t634) - t638 * (t649 * t649) - t710 - t713;
        let t715 = k4 / t714;
        let t723 = t675 * (t658 * t670);
        let t726 = t702 * (t684 * t695);
        let t727 = t15 - t635 * (t214 * t634) - t652 * (t638 * t649) - t723 - t726;
        let t728 = t715 * t727;
        let t736 = t658 * (t675 * t675);
        let t739 = t684 * (t702 * t702);
        let t740 = ZZ6 - t214 * (t635 * t635) - t638 * (t652 * t652) - t736 - t739;
        let t744 = k4 / (t740 - t714 * (t728 * t728));
        [
        t630, t631, t632, t633, t634, t635, t639, t643,
        t646, t649, t652, t659, t665, t670, t675, t685,
        t695, t702, t715, t728, t744,
    ]
    };
    // ddq
    {
        let t746 = t625 + t624 * t631;
        let t750 = t626 + t624 * t632 + t643 * t746;
        let t756 = t627 + t624 * t633 - t646 * t746 - t665 * t750;
        let t764 = t628 + t624 * t634 - t649 * t746 - t670 * t750 + t695 * t756;
        let t772 = t629 + t624 * t635 - t652 * t746 - t675 * t750 + t702 * t756;
        let t780 = t744 * (t772 - t728 * t764);
        let t782 = t715 * t764 - t728 * t780;
        let t786 = t685 * t756 + t695 * t782 + t702 * t780;
        let t792 = t659 * t750 - t665 * t786 - t670 * t782 - t675 * t780;
        let t799 = t652 * t780;
        let t800 = t639 * t746 + t643 * t792 - t646 * t786 - t649 * t782 - t799;
        let t807 = t634 * t782;
        let t808 = t624 * t630 + t631 * t800 + t632 * t792 + t633 * t786 + t807;
        let t810 = t808 + t635 * t780;
        put(0, t810);
        put(1, t800);
        put(2, t792);
        put(3, t786);
        put(4, t782);
        put(5, t780);
    }
}
