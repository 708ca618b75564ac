//! Torques from the standard parameters.
//!
//! `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil and Dombre, 9.5.2.
//!
//! 396 multiplications, 399 additions; 7, 7 of 7 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, STANDARD, Trig};

/// Torques from the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], out: &mut [S; 7]) {
    entries(trig, dq, ddq, phi, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6, ddq7] = *ddq;
    let [
        _, _, _, _, _, _, ZZ1, _, _, _, M2, MSX2,
        MSY2, MSZ2, XX2, YY2, ZZ2, XY2, XZ2, YZ2, M3, MSX3, MSY3, MSZ3,
        XX3, YY3, ZZ3, XY3, XZ3, YZ3, M4, MSX4, MSY4, MSZ4, XX4, YY4,
        ZZ4, XY4, XZ4, YZ4, M5, MSX5, MSY5, MSZ5, XX5, YY5, ZZ5, XY5,
        XZ5, YZ5, M6, MSX6, MSY6, MSZ6, XX6, YY6, ZZ6, XY6, XZ6, YZ6,
        M7, MSX7, MSY7, MSZ7, XX7, YY7, ZZ7, XY7, XZ7, YZ7, FV1, FV2,
        FV3, FV4, FV5, FV6, FV7, FC1, FC2, FC3, FC4, FC5, FC6, FC7,
        FO1, FO2, FO3, FO4, FO5, FO6, FO7,
        ..] = *phi;
    let k0 = S::constant(9.81);
    let k1 = S::constant(0.01175);
    let k2 = S::constant(0.42076);
    let k3 = S::constant(0.01275);
    let k4 = S::constant(0.31436);
    let k5 = S::constant(0.00035);
    let k6 = S::constant(0.167455);
    // link 2: motion
    let [
        w2_x, w2_y, t2, t3, a2_z, t10, a2_y, t13,
        t14, dw2_x, dw2_y,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t2 = s2 * ddq1;
        let t3 = c2 * ddq1;
        let t7 = ddq1 * k1;
        let a2_z = dq1 * dq1 * k1;
        let t10 = s2 * k0 + c2 * t7;
        let a2_y = s2 * t7 - c2 * k0;
        let t13 = dq2 * w2_y;
        let t14 = dq2 * w2_x;
        let dw2_x = t2 + t13;
        let dw2_y = t3 - t14;
        [
        w2_x, w2_y, t2, t3, a2_z, t10, a2_y, t13,
        t14, dw2_x, dw2_y,
    ]
    };
    // link 3: motion
    let [
        w3_x, t22, t29, t30, t31, t32, t33, t34,
        t35, t36, t37, t38, a3_z, t47, a3_y, w3_z,
        dw3_x, t55, dw3_z,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t22 = c3 * dq2 + s3 * w2_x;
        let t29 = w2_x * w2_x;
        let t30 = w2_y * w2_y;
        let t31 = dq2 * dq2;
        let t32 = w2_x * w2_y;
        let t33 = t30 + t31;
        let t34 = t32 - ddq2;
        let t35 = ddq2 + t32;
        let t36 = t29 + t31;
        let t37 = t14 - dw2_y;
        let t38 = t13 + dw2_x;
        let t42 = t10 + t34 * k2;
        let a3_z = a2_y + t36 * k2;
        let t44 = a2_z - t38 * k2;
        let t47 = c3 * t42 + s3 * t44;
        let a3_y = s3 * t42 - c3 * t44;
        let w3_z = w2_y + dq3;
        let dw3_x = c3 * dw2_x - s3 * ddq2 - dq3 * t22;
        let t55 = c3 * ddq2 + s3 * dw2_x + dq3 * w3_x;
        let dw3_z = dw2_y + ddq3;
        [
        w3_x, t22, t29, t30, t31, t32, t33, t34,
        t35, t36, t37, t38, a3_z, t47, a3_y, w3_z,
        dw3_x, t55, dw3_z,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t69, t70, t71, t72, t73, t74,
        t75, t76, t77, t78, t79, t80, t81, t82,
        t83, t88, a4_x, a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t69 = w3_x * w3_x;
        let t70 = t22 * t22;
        let t71 = w3_z * w3_z;
        let t72 = w3_x * t22;
        let t73 = w3_x * w3_z;
        let t74 = t22 * w3_z;
        let t75 = t70 + t71;
        let t76 = dw3_z + t72;
        let t77 = t73 - t55;
        let t78 = dw3_z - t72;
        let t79 = t69 + t71;
        let t80 = dw3_x + t74;
        let t81 = t55 + t73;
        let t82 = dw3_x - t74;
        let t83 = t69 + t70;
        let t87 = t47 + t76 * k3;
        let t88 = a3_y - t79 * k3;
        let t89 = a3_z + t82 * k3;
        let a4_x = s4 * t89 - c4 * t87;
        let a4_y = c4 * t89 + s4 * t87;
        let w4_z = t22 + dq4;
        let dw4_x = c4 * dw3_x + s4 * dw3_z + dq4 * w4_y;
        let dw4_y = c4 * dw3_z - s4 * dw3_x - dq4 * w4_x;
        let dw4_z = t55 + ddq4;
        [
        w4_x, w4_y, t69, t70, t71, t72, t73, t74,
        t75, t76, t77, t78, t79, t80, t81, t82,
        t83, t88, a4_x, a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ]
    };
    // link 5: motion
    let [
        w5_x, t107, t114, t115, t116, t117, t118, t119,
        t120, t121, t122, t123, t124, t125, t126, t127,
        t128, a5_z, a5_x, a5_y, w5_z, dw5_x, t145, dw5_z,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t107 = c5 * w4_z + s5 * w4_x;
        let t114 = w4_x * w4_x;
        let t115 = w4_y * w4_y;
        let t116 = w4_z * w4_z;
        let t117 = w4_x * w4_y;
        let t118 = w4_x * w4_z;
        let t119 = w4_y * w4_z;
        let t120 = t115 + t116;
        let t121 = t117 - dw4_z;
        let t122 = dw4_y + t118;
        let t123 = dw4_z + t117;
        let t124 = t114 + t116;
        let t125 = t119 - dw4_x;
        let t126 = t118 - dw4_y;
        let t127 = dw4_x + t119;
        let t128 = t114 + t115;
        let t132 = a4_x - t121 * k4;
        let a5_z = a4_y + t124 * k4;
        let t134 = t88 + t127 * k4;
        let a5_x = c5 * t132 + s5 * t134;
        let a5_y = c5 * t134 - s5 * t132;
        let w5_z = w4_y + dq5;
        let dw5_x = c5 * dw4_x - s5 * dw4_z - dq5 * t107;
        let t145 = c5 * dw4_z + s5 * dw4_x + dq5 * w5_x;
        let dw5_z = dw4_y + ddq5;
        [
        w5_x, t107, t114, t115, t116, t117, t118, t119,
        t120, t121, t122, t123, t124, t125, t126, t127,
        t128, a5_z, a5_x, a5_y, w5_z, dw5_x, t145, dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t159, t160, t161, t162, t163, t164,
        t165, t166, t167, t168, t169, t170, t171, t172,
        t173, t178, a6_x, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t159 = w5_x * w5_x;
        let t160 = t107 * t107;
        let t161 = w5_z * w5_z;
        let t162 = w5_x * t107;
        let t163 = w5_x * w5_z;
        let t164 = t107 * w5_z;
        let t165 = t160 + t161;
        let t166 = dw5_z + t162;
        let t167 = t163 - t145;
        let t168 = dw5_z - t162;
        let t169 = t159 + t161;
        let t170 = dw5_x + t164;
        let t171 = t145 + t163;
        let t172 = dw5_x - t164;
        let t173 = t159 + t160;
        let t177 = a5_x - t166 * k5;
        let t178 = a5_y - t169 * k5;
        let t179 = a5_z + t172 * k5;
        let a6_x = c6 * t177 + s6 * t179;
        let a6_y = c6 * t179 - s6 * t177;
        let w6_z = t107 + dq6;
        let dw6_x = c6 * dw5_x + s6 * dw5_z + dq6 * w6_y;
        let dw6_y = c6 * dw5_z - s6 * dw5_x - dq6 * w6_x;
        let dw6_z = t145 + ddq6;
        [
        w6_x, w6_y, t159, t160, t161, t162, t163, t164,
        t165, t166, t167, t168, t169, t170, t171, t172,
        t173, t178, a6_x, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ]
    };
    // link 7: motion
    let [
        w7_x, t197, t204, t205, t206, t207, t208, t209,
        t210, t211, t212, t213, t214, t215, t216, t217,
        t218, a7_z, a7_x, a7_y, w7_z, dw7_x, t235, dw7_z,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t197 = c7 * w6_z + s7 * w6_x;
        let t204 = w6_x * w6_x;
        let t205 = w6_y * w6_y;
        let t206 = w6_z * w6_z;
        let t207 = w6_x * w6_y;
        let t208 = w6_x * w6_z;
        let t209 = w6_y * w6_z;
        let t210 = t205 + t206;
        let t211 = t207 - dw6_z;
        let t212 = dw6_y + t208;
        let t213 = dw6_z + t207;
        let t214 = t204 + t206;
        let t215 = t209 - dw6_x;
        let t216 = t208 - dw6_y;
        let t217 = dw6_x + t209;
        let t218 = t204 + t205;
        let t222 = a6_x - t211 * k6;
        let a7_z = a6_y + t214 * k6;
        let t224 = t178 + t217 * k6;
        let a7_x = c7 * t222 + s7 * t224;
        let a7_y = c7 * t224 - s7 * t222;
        let w7_z = w6_y + dq7;
        let dw7_x = c7 * dw6_x - s7 * dw6_z - dq7 * t197;
        let t235 = c7 * dw6_z + s7 * dw6_x + dq7 * w7_x;
        let dw7_z = dw6_y + ddq7;
        [
        w7_x, t197, t204, t205, t206, t207, t208, t209,
        t210, t211, t212, t213, t214, t215, t216, t217,
        t218, a7_z, a7_x, a7_y, w7_z, dw7_x, t235, dw7_z,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t320, t323, t332, t333] = {
        let t237 = w7_x * w7_x;
        let t238 = t197 * t197;
        let t239 = w7_z * w7_z;
        let t240 = w7_x * t197;
        let t241 = w7_x * w7_z;
        let t242 = t197 * w7_z;
        let t244 = dw7_z + t240;
        let t245 = t241 - t235;
        let t246 = dw7_z - t240;
        let t248 = dw7_x + t242;
        let t249 = t235 + t241;
        let t250 = dw7_x - t242;
        let t273 = XZ7 * (t239 - t237);
        let t274 = XZ7 * t248;
        let t275 = XX7 * dw7_x - t242 * (ZZ7 - YY7) - XY7 * t249 + XZ7 * t246;
        let t277 = ZZ7 * dw7_z - t240 * (YY7 - XX7) + XY7 * (t237 - t238) + t274;
        let t280 = YZ7 * t244;
        let t283 = t241 * (XX7 - ZZ7) - YY7 * t235 + XY7 * t250 + t273 + t280;
        let f7_x = M7 * a7_x + (MSZ7 * t245 - (MSX7 * (t238 + t239) + MSY7 * t244));
        let f7_y = M7 * a7_y + (MSX7 * t246 - MSY7 * (t237 + t239) - MSZ7 * t248);
        let f7_z = M7 * a7_z + (MSX7 * t249 + MSY7 * t250 - MSZ7 * (t237 + t238));
        let n7_x = t275 + YZ7 * (t238 - t239) + (MSY7 * a7_z - MSZ7 * a7_y);
        let n7_y = t283 + (MSZ7 * a7_x - MSX7 * a7_z);
        let n7_z = t277 + YZ7 * t245 + (MSX7 * a7_y - MSY7 * a7_x);
        let t320 = c7 * f7_x - s7 * f7_y;
        let t323 = s7 * f7_x + c7 * f7_y;
        let t332 = c7 * n7_x - s7 * n7_y + k6 * t323;
        let t333 = s7 * n7_x + c7 * n7_y - k6 * t320;
        [f7_z, n7_z, t320, t323, t332, t333]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t408, t411, t420, t421] = {
        let t355 = XZ6 * (t206 - t204);
        let t356 = XZ6 * t215;
        let t357 = t209 * (ZZ6 - YY6) + XX6 * dw6_x - XY6 * t216 + XZ6 * t213;
        let t359 = t207 * (YY6 - XX6) + ZZ6 * dw6_z + XY6 * (t204 - t205) - t356;
        let t362 = YZ6 * t211;
        let t365 = t208 * (XX6 - ZZ6) + YY6 * dw6_y + XY6 * t217 + t355 - t362;
        let f6_x = t320 + (M6 * a6_x + (MSZ6 * t212 + (MSY6 * t211 - MSX6 * t210)));
        let f6_y = f7_z + (M6 * a6_y + (MSZ6 * t215 + (MSX6 * t213 - MSY6 * t214)));
        let f6_z = MSX6 * t216 + MSY6 * t217 - MSZ6 * t218 - M6 * t178 - t323;
        let n6_x = t332 + (t357 + YZ6 * (t205 - t206) - (MSY6 * t178 + MSZ6 * a6_y));
        let n6_y = n7_z + (t365 + (MSZ6 * a6_x + MSX6 * t178));
        let n6_z = t359 + YZ6 * t212 + (MSX6 * a6_y - MSY6 * a6_x) - t333;
        let t408 = c6 * f6_x - s6 * f6_y;
        let t411 = s6 * f6_x + c6 * f6_y;
        let t420 = c6 * n6_x - s6 * n6_y + k5 * t411;
        let t421 = s6 * n6_x + c6 * n6_y - k5 * t408;
        [f6_z, n6_z, t408, t411, t420, t421]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t496, t499, t508, t509] = {
        let t443 = XZ5 * (t161 - t159);
        let t444 = XZ5 * t170;
        let t445 = XX5 * dw5_x - t164 * (ZZ5 - YY5) - XY5 * t171 + XZ5 * t168;
        let t447 = ZZ5 * dw5_z - t162 * (YY5 - XX5) + XY5 * (t159 - t160) + t444;
        let t450 = YZ5 * t166;
        let t453 = t163 * (XX5 - ZZ5) - YY5 * t145 + XY5 * t172 + t443 + t450;
        let f5_x = t408 + (M5 * a5_x + (MSZ5 * t167 - (MSX5 * t165 + MSY5 * t166)));
        let f5_y = M5 * a5_y + (MSX5 * t168 - MSY5 * t169 - MSZ5 * t170) - f6_z;
        let f5_z = t411 + (M5 * a5_z + (MSX5 * t171 + MSY5 * t172 - MSZ5 * t173));
        let n5_x = t420 + (t445 + YZ5 * (t160 - t161) + (MSY5 * a5_z - MSZ5 * a5_y));
        let n5_y = t453 + (MSZ5 * a5_x - MSX5 * a5_z) - n6_z;
        let n5_z = t421 + (t447 + YZ5 * t167 + (MSX5 * a5_y - MSY5 * a5_x));
        let t496 = c5 * f5_x - s5 * f5_y;
        let t499 = s5 * f5_x + c5 * f5_y;
        let t508 = c5 * n5_x - s5 * n5_y + k4 * t499;
        let t509 = s5 * n5_x + c5 * n5_y - k4 * t496;
        [f5_z, n5_z, t496, t499, t508, t509]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t584, t587, t596, t597] = {
        let t531 = XZ4 * (t116 - t114);
        let t532 = XZ4 * t125;
        let t533 = t119 * (ZZ4 - YY4) + XX4 * dw4_x - XY4 * t126 + XZ4 * t123;
        let t535 = t117 * (YY4 - XX4) + ZZ4 * dw4_z + XY4 * (t114 - t115) - t532;
        let t538 = YZ4 * t121;
        let t541 = t118 * (XX4 - ZZ4) + YY4 * dw4_y + XY4 * t127 + t531 - t538;
        let f4_x = t496 + (M4 * a4_x + (MSZ4 * t122 + (MSY4 * t121 - MSX4 * t120)));
        let f4_y = f5_z + (M4 * a4_y + (MSZ4 * t125 + (MSX4 * t123 - MSY4 * t124)));
        let f4_z = MSX4 * t126 + MSY4 * t127 - MSZ4 * t128 - M4 * t88 - t499;
        let n4_x = t508 + (t533 + YZ4 * (t115 - t116) - (MSY4 * t88 + MSZ4 * a4_y));
        let n4_y = n5_z + (t541 + (MSZ4 * a4_x + MSX4 * t88));
        let n4_z = t535 + YZ4 * t122 + (MSX4 * a4_y - MSY4 * a4_x) - t509;
        let t584 = c4 * f4_x - s4 * f4_y;
        let t587 = s4 * f4_x + c4 * f4_y;
        let t596 = c4 * n4_x - s4 * n4_y + k3 * t587;
        let t597 = s4 * n4_x + c4 * n4_y - k3 * t584;
        [f4_z, n4_z, t584, t587, t596, t597]
    };
    // link 3: force and moment
    let [f3_z, n3_z, t672, t684, t685] = {
        let t619 = XZ3 * (t71 - t69);
        let t620 = XZ3 * t80;
        let t621 = XX3 * dw3_x - t74 * (ZZ3 - YY3) - XY3 * t81 + XZ3 * t78;
        let t623 = ZZ3 * dw3_z - t72 * (YY3 - XX3) + XY3 * (t69 - t70) + t620;
        let t626 = YZ3 * t76;
        let t629 = t73 * (XX3 - ZZ3) - YY3 * t55 + XY3 * t82 + t619 + t626;
        let f3_x = t584 + (MSZ3 * t77 - (MSX3 * t75 + MSY3 * t76) - M3 * t47);
        let f3_y = M3 * a3_y + (MSX3 * t78 - MSY3 * t79 - MSZ3 * t80) - f4_z;
        let f3_z = t587 + (M3 * a3_z + (MSX3 * t81 + MSY3 * t82 - MSZ3 * t83));
        let n3_x = t596 + (t621 + YZ3 * (t70 - t71) + (MSY3 * a3_z - MSZ3 * a3_y));
        let n3_y = t629 - (MSZ3 * t47 + MSX3 * a3_z) - n4_z;
        let n3_z = t597 + (t623 + YZ3 * t77 + (MSX3 * a3_y + MSY3 * t47));
        let t672 = c3 * f3_x - s3 * f3_y;
        let t684 = c3 * n3_x - s3 * n3_y + k2 * (s3 * f3_x + c3 * f3_y);
        let t685 = s3 * n3_x + c3 * n3_y - k2 * t672;
        [f3_z, n3_z, t672, t684, t685]
    };
    // link 2: force and moment
    let [n2_z, t757] = {
        let t707 = XZ2 * (t31 - t29);
        let t708 = XZ2 * t2;
        let t709 = t13 * (ZZ2 - YY2) + XX2 * dw2_x - XY2 * t37 + XZ2 * t35;
        let t711 = t32 * (YY2 - XX2) + ZZ2 * ddq2 + XY2 * (t29 - t30) + t708;
        let t714 = YZ2 * t34;
        let t717 = t14 * (XX2 - ZZ2) + YY2 * dw2_y + XY2 * t38 + t707 - t714;
        let f2_x = t672 + (MSZ2 * t3 + (MSY2 * t34 - MSX2 * t33) - M2 * t10);
        let f2_y = f3_z + (M2 * a2_y + (MSX2 * t35 - MSY2 * t36 - MSZ2 * t2));
        let n2_x = t684 + (t709 + YZ2 * (t30 - t31) + (MSY2 * a2_z - MSZ2 * a2_y));
        let n2_y = n3_z + (t717 - (MSZ2 * t10 + MSX2 * a2_z));
        let n2_z = t711 + YZ2 * t3 + (MSX2 * a2_y + MSY2 * t10) - t685;
        let t757 = s2 * n2_x + c2 * n2_y - k1 * (c2 * f2_x - s2 * f2_y);
        [n2_z, t757]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t757 + ZZ1 * ddq1;
        n1_z
    };
    // drives
    {
        let t795 = FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t796 = FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t797 = FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign());
        let t798 = FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign());
        let t799 = FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign());
        let t800 = FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign());
        let t801 = FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign());
        put(0, t795);
        put(1, t796);
        put(2, t797);
        put(3, t798);
        put(4, t799);
        put(5, t800);
        put(6, t801);
    }
}
