//! Torques from the standard parameters.
//!
//! `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil and Dombre, 9.5.2.
//!
//! 380 multiplications, 384 additions; 7, 7 of 7 structurally nonzero.

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
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        w2_x, w2_y, t3, t4, a2_z, t10, a2_y, t15,
        t16, t17, dw2_x, dw2_y, t20, t21, t22, t23,
        t24, t25, t26,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t3 = s2 * ddq1;
        let t4 = c2 * ddq1;
        let t7 = ddq1 * k1;
        let a2_z = t0 * k1;
        let t10 = s2 * k0 + c2 * t7;
        let a2_y = s2 * t7 - c2 * k0;
        let t13 = w2_x * w2_x;
        let t14 = dq2 * dq2;
        let t15 = w2_x * w2_y;
        let t16 = dq2 * w2_x;
        let t17 = dq2 * w2_y;
        let dw2_x = t3 + t17;
        let dw2_y = t4 - t16;
        let t20 = t13 - t14;
        let t21 = t20 - t0;
        let t22 = t15 - ddq2;
        let t23 = ddq2 + t15;
        let t24 = t13 + t14;
        let t25 = t16 - dw2_y;
        let t26 = t17 + dw2_x;
        [
        w2_x, w2_y, t3, t4, a2_z, t10, a2_y, t15,
        t16, t17, dw2_x, dw2_y, t20, t21, t22, t23,
        t24, t25, t26,
    ]
    };
    // link 3: motion
    let [
        w3_x, t32, a3_z, t41, a3_y, t47, t50, w3_z,
        dw3_z, t55, t56, t57, dw3_x, dw3_y, t60, t61,
        t62, t63, t64, t65, t66,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t32 = c3 * dq2 + s3 * w2_x;
        let t36 = t10 + t22 * k2;
        let a3_z = a2_y + t24 * k2;
        let t38 = a2_z - t26 * k2;
        let t41 = c3 * t36 + s3 * t38;
        let a3_y = s3 * t36 - c3 * t38;
        let t47 = c3 * t22 - s3 * t26;
        let t50 = c3 * t26 + s3 * t22;
        let w3_z = w2_y + dq3;
        let dw3_z = dw2_y + ddq3;
        let t53 = w3_x * w3_x;
        let t54 = w3_z * w3_z;
        let t55 = w3_x * t32;
        let t56 = w3_x * w3_z;
        let t57 = t32 * w3_z;
        let dw3_x = t50 - t57;
        let dw3_y = t47 - t56;
        let t60 = t53 - t54;
        let t61 = t60 - t24;
        let t62 = dw3_z + t55;
        let t63 = dw3_z - t55;
        let t64 = t53 + t54;
        let t65 = t56 - dw3_y;
        let t66 = dw3_x - t57;
        [
        w3_x, t32, a3_z, t41, a3_y, t47, t50, w3_z,
        dw3_z, t55, t56, t57, dw3_x, dw3_y, t60, t61,
        t62, t63, t64, t65, t66,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t77, a4_x, a4_y, t87, t90, w4_z,
        dw4_z, t95, t96, t97, dw4_x, dw4_y, t100, t101,
        t102, t103, t104, t105, t106,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t76 = t41 + t62 * k3;
        let t77 = a3_y - t64 * k3;
        let t78 = a3_z + t66 * k3;
        let a4_x = s4 * t78 - c4 * t76;
        let a4_y = c4 * t78 + s4 * t76;
        let t87 = c4 * t62 - s4 * t66;
        let t90 = c4 * t66 + s4 * t62;
        let w4_z = t32 + dq4;
        let dw4_z = ddq4 - dw3_y;
        let t93 = w4_x * w4_x;
        let t94 = w4_z * w4_z;
        let t95 = w4_x * w4_y;
        let t96 = w4_x * w4_z;
        let t97 = w4_y * w4_z;
        let dw4_x = t90 + t97;
        let dw4_y = t87 - t96;
        let t100 = t93 - t94;
        let t101 = t100 - t64;
        let t102 = t95 - dw4_z;
        let t103 = dw4_z + t95;
        let t104 = t93 + t94;
        let t105 = t96 - dw4_y;
        let t106 = t97 + dw4_x;
        [
        w4_x, w4_y, t77, a4_x, a4_y, t87, t90, w4_z,
        dw4_z, t95, t96, t97, dw4_x, dw4_y, t100, t101,
        t102, t103, t104, t105, t106,
    ]
    };
    // link 5: motion
    let [
        w5_x, t112, a5_z, a5_x, a5_y, t127, t130, w5_z,
        dw5_z, t135, t136, t137, dw5_x, dw5_y, t140, t141,
        t142, t143, t144, t145, t146,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t112 = c5 * w4_z + s5 * w4_x;
        let t116 = a4_x - t102 * k4;
        let a5_z = a4_y + t104 * k4;
        let t118 = t77 + t106 * k4;
        let a5_x = c5 * t116 + s5 * t118;
        let a5_y = c5 * t118 - s5 * t116;
        let t127 = c5 * t102 - s5 * t106;
        let t130 = c5 * t106 + s5 * t102;
        let w5_z = w4_y + dq5;
        let dw5_z = dw4_y + ddq5;
        let t133 = w5_x * w5_x;
        let t134 = w5_z * w5_z;
        let t135 = w5_x * t112;
        let t136 = w5_x * w5_z;
        let t137 = t112 * w5_z;
        let dw5_x = t130 - t137;
        let dw5_y = t127 - t136;
        let t140 = t133 - t134;
        let t141 = t140 - t104;
        let t142 = dw5_z + t135;
        let t143 = dw5_z - t135;
        let t144 = t133 + t134;
        let t145 = t136 - dw5_y;
        let t146 = dw5_x - t137;
        [
        w5_x, t112, a5_z, a5_x, a5_y, t127, t130, w5_z,
        dw5_z, t135, t136, t137, dw5_x, dw5_y, t140, t141,
        t142, t143, t144, t145, t146,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t157, a6_x, a6_y, t167, t170, w6_z,
        dw6_z, t175, t176, t177, dw6_x, dw6_y, t180, t181,
        t182, t183, t184, t185, t186,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t156 = a5_x - t142 * k5;
        let t157 = a5_y - t144 * k5;
        let t158 = a5_z + t146 * k5;
        let a6_x = c6 * t156 + s6 * t158;
        let a6_y = c6 * t158 - s6 * t156;
        let t167 = c6 * t142 - s6 * t146;
        let t170 = c6 * t146 + s6 * t142;
        let w6_z = t112 + dq6;
        let dw6_z = ddq6 - dw5_y;
        let t173 = w6_x * w6_x;
        let t174 = w6_z * w6_z;
        let t175 = w6_x * w6_y;
        let t176 = w6_x * w6_z;
        let t177 = w6_y * w6_z;
        let dw6_x = t170 + t177;
        let dw6_y = t167 - t176;
        let t180 = t173 - t174;
        let t181 = t180 - t144;
        let t182 = t175 - dw6_z;
        let t183 = dw6_z + t175;
        let t184 = t173 + t174;
        let t185 = t176 - dw6_y;
        let t186 = t177 + dw6_x;
        [
        w6_x, w6_y, t157, a6_x, a6_y, t167, t170, w6_z,
        dw6_z, t175, t176, t177, dw6_x, dw6_y, t180, t181,
        t182, t183, t184, t185, t186,
    ]
    };
    // link 7: motion
    let [
        a7_z, a7_x, a7_y, t207, t210, dw7_z, t215, t216,
        t217, dw7_x, dw7_y, t220, t221, t222, t223, t224,
        t225, t226,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t192 = c7 * w6_z + s7 * w6_x;
        let t196 = a6_x - t182 * k6;
        let a7_z = a6_y + t184 * k6;
        let t198 = t157 + t186 * k6;
        let a7_x = c7 * t196 + s7 * t198;
        let a7_y = c7 * t198 - s7 * t196;
        let t207 = c7 * t182 - s7 * t186;
        let t210 = c7 * t186 + s7 * t182;
        let w7_z = w6_y + dq7;
        let dw7_z = dw6_y + ddq7;
        let t213 = w7_x * w7_x;
        let t214 = w7_z * w7_z;
        let t215 = w7_x * t192;
        let t216 = w7_x * w7_z;
        let t217 = t192 * w7_z;
        let dw7_x = t210 - t217;
        let dw7_y = t207 - t216;
        let t220 = t213 - t214;
        let t221 = t220 - t184;
        let t222 = dw7_z + t215;
        let t223 = dw7_z - t215;
        let t224 = t213 + t214;
        let t225 = t216 - dw7_y;
        let t226 = dw7_x - t217;
        [
        a7_z, a7_x, a7_y, t207, t210, dw7_z, t215, t216,
        t217, dw7_x, dw7_y, t220, t221, t222, t223, t224,
        t225, t226,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t294, t297, t306, t307] = {
        let t248 = XZ7 * t210;
        let t249 = XX7 * dw7_x - t217 * (ZZ7 - YY7) - XY7 * t225 + XZ7 * t223;
        let t250 = t216 * (XX7 - ZZ7) + YY7 * dw7_y + XY7 * t226 - XZ7 * t220;
        let t251 = ZZ7 * dw7_z - t215 * (YY7 - XX7) + XY7 * (t221 + t224) + t248;
        let f7_x = M7 * a7_x + (MSZ7 * t207 + (MSX7 * t221 - MSY7 * t222));
        let f7_y = M7 * a7_y + (MSX7 * t223 - MSY7 * t224 - MSZ7 * t210);
        let f7_z = M7 * a7_z + (MSX7 * t225 + MSY7 * t226 - MSZ7 * t184);
        let n7_x = t249 + YZ7 * (t184 - t224) + (MSY7 * a7_z - MSZ7 * a7_y);
        let n7_y = t250 + YZ7 * t222 + (MSZ7 * a7_x - MSX7 * a7_z);
        let n7_z = t251 + YZ7 * t207 + (MSX7 * a7_y - MSY7 * a7_x);
        let t294 = c7 * f7_x - s7 * f7_y;
        let t297 = s7 * f7_x + c7 * f7_y;
        let t306 = c7 * n7_x - s7 * n7_y + k6 * t297;
        let t307 = s7 * n7_x + c7 * n7_y - k6 * t294;
        [f7_z, n7_z, t294, t297, t306, t307]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t381, t384, t393, t394] = {
        let t329 = XZ6 * t170;
        let t330 = t177 * (ZZ6 - YY6) + XX6 * dw6_x - XY6 * t185 + XZ6 * t183;
        let t331 = t176 * (XX6 - ZZ6) + YY6 * dw6_y + XY6 * t186 - XZ6 * t180;
        let t332 = t175 * (YY6 - XX6) + ZZ6 * dw6_z + XY6 * (t181 + t184) + t329;
        let f6_x = t294 + (M6 * a6_x + (MSZ6 * t167 + (MSX6 * t181 + MSY6 * t182)));
        let f6_y = f7_z + (M6 * a6_y + (MSX6 * t183 - MSY6 * t184 - MSZ6 * t170));
        let f6_z = MSX6 * t185 + MSY6 * t186 - MSZ6 * t144 - M6 * t157 - t297;
        let n6_x = t306 + (t330 + YZ6 * (t144 - t184) - (MSY6 * t157 + MSZ6 * a6_y));
        let n6_y = n7_z + (t331 - YZ6 * t182 + (MSZ6 * a6_x + MSX6 * t157));
        let n6_z = t332 + YZ6 * t167 + (MSX6 * a6_y - MSY6 * a6_x) - t307;
        let t381 = c6 * f6_x - s6 * f6_y;
        let t384 = s6 * f6_x + c6 * f6_y;
        let t393 = c6 * n6_x - s6 * n6_y + k5 * t384;
        let t394 = s6 * n6_x + c6 * n6_y - k5 * t381;
        [f6_z, n6_z, t381, t384, t393, t394]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t468, t471, t480, t481] = {
        let t416 = XZ5 * t130;
        let t417 = XX5 * dw5_x - t137 * (ZZ5 - YY5) - XY5 * t145 + XZ5 * t143;
        let t418 = t136 * (XX5 - ZZ5) + YY5 * dw5_y + XY5 * t146 - XZ5 * t140;
        let t419 = ZZ5 * dw5_z - t135 * (YY5 - XX5) + XY5 * (t141 + t144) + t416;
        let f5_x = t381 + (M5 * a5_x + (MSZ5 * t127 + (MSX5 * t141 - MSY5 * t142)));
        let f5_y = M5 * a5_y + (MSX5 * t143 - MSY5 * t144 - MSZ5 * t130) - f6_z;
        let f5_z = t384 + (M5 * a5_z + (MSX5 * t145 + MSY5 * t146 - MSZ5 * t104));
        let n5_x = t393 + (t417 + YZ5 * (t104 - t144) + (MSY5 * a5_z - MSZ5 * a5_y));
        let n5_y = t418 + YZ5 * t142 + (MSZ5 * a5_x - MSX5 * a5_z) - n6_z;
        let n5_z = t394 + (t419 + YZ5 * t127 + (MSX5 * a5_y - MSY5 * a5_x));
        let t468 = c5 * f5_x - s5 * f5_y;
        let t471 = s5 * f5_x + c5 * f5_y;
        let t480 = c5 * n5_x - s5 * n5_y + k4 * t471;
        let t481 = s5 * n5_x + c5 * n5_y - k4 * t468;
        [f5_z, n5_z, t468, t471, t480, t481]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t555, t558, t567, t568] = {
        let t503 = XZ4 * t90;
        let t504 = t97 * (ZZ4 - YY4) + XX4 * dw4_x - XY4 * t105 + XZ4 * t103;
        let t505 = t96 * (XX4 - ZZ4) + YY4 * dw4_y + XY4 * t106 - XZ4 * t100;
        let t506 = t95 * (YY4 - XX4) + ZZ4 * dw4_z + XY4 * (t101 + t104) + t503;
        let f4_x = t468 + (M4 * a4_x + (MSZ4 * t87 + (MSX4 * t101 + MSY4 * t102)));
        let f4_y = f5_z + (M4 * a4_y + (MSX4 * t103 - MSY4 * t104 - MSZ4 * t90));
        let f4_z = MSX4 * t105 + MSY4 * t106 - MSZ4 * t64 - M4 * t77 - t471;
        let n4_x = t480 + (t504 + YZ4 * (t64 - t104) - (MSY4 * t77 + MSZ4 * a4_y));
        let n4_y = n5_z + (t505 - YZ4 * t102 + (MSZ4 * a4_x + MSX4 * t77));
        let n4_z = t506 + YZ4 * t87 + (MSX4 * a4_y - MSY4 * a4_x) - t481;
        let t555 = c4 * f4_x - s4 * f4_y;
        let t558 = s4 * f4_x + c4 * f4_y;
        let t567 = c4 * n4_x - s4 * n4_y + k3 * t558;
        let t568 = s4 * n4_x + c4 * n4_y - k3 * t555;
        [f4_z, n4_z, t555, t558, t567, t568]
    };
    // link 3: force and moment
    let [f3_z, n3_z, t642, t654, t655] = {
        let t590 = XZ3 * t50;
        let t591 = XX3 * dw3_x - t57 * (ZZ3 - YY3) - XY3 * t65 + XZ3 * t63;
        let t592 = t56 * (XX3 - ZZ3) + YY3 * dw3_y + XY3 * t66 - XZ3 * t60;
        let t593 = ZZ3 * dw3_z - t55 * (YY3 - XX3) + XY3 * (t61 + t64) + t590;
        let f3_x = t555 + (MSZ3 * t47 + (MSX3 * t61 - MSY3 * t62) - M3 * t41);
        let f3_y = M3 * a3_y + (MSX3 * t63 - MSY3 * t64 - MSZ3 * t50) - f4_z;
        let f3_z = t558 + (M3 * a3_z + (MSX3 * t65 + MSY3 * t66 - MSZ3 * t24));
        let n3_x = t567 + (t591 + YZ3 * (t24 - t64) + (MSY3 * a3_z - MSZ3 * a3_y));
        let n3_y = t592 + YZ3 * t62 - (MSZ3 * t41 + MSX3 * a3_z) - n4_z;
        let n3_z = t568 + (t593 + YZ3 * t47 + (MSX3 * a3_y + MSY3 * t41));
        let t642 = c3 * f3_x - s3 * f3_y;
        let t654 = c3 * n3_x - s3 * n3_y + k2 * (s3 * f3_x + c3 * f3_y);
        let t655 = s3 * n3_x + c3 * n3_y - k2 * t642;
        [f3_z, n3_z, t642, t654, t655]
    };
    // link 2: force and moment
    let [n2_z, t726] = {
        let t677 = XZ2 * t3;
        let t678 = t17 * (ZZ2 - YY2) + XX2 * dw2_x - XY2 * t25 + XZ2 * t23;
        let t679 = t16 * (XX2 - ZZ2) + YY2 * dw2_y + XY2 * t26 - XZ2 * t20;
        let t680 = t15 * (YY2 - XX2) + ZZ2 * ddq2 + XY2 * (t21 + t24) + t677;
        let f2_x = t642 + (MSZ2 * t4 + (MSX2 * t21 + MSY2 * t22) - M2 * t10);
        let f2_y = f3_z + (M2 * a2_y + (MSX2 * t23 - MSY2 * t24 - MSZ2 * t3));
        let n2_x = t654 + (t678 + YZ2 * (t0 - t24) + (MSY2 * a2_z - MSZ2 * a2_y));
        let n2_y = n3_z + (t679 - YZ2 * t22 - (MSZ2 * t10 + MSX2 * a2_z));
        let n2_z = t680 + YZ2 * t4 + (MSX2 * a2_y + MSY2 * t10) - t655;
        let t726 = s2 * n2_x + c2 * n2_y - k1 * (c2 * f2_x - s2 * f2_y);
        [n2_z, t726]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t726 + ZZ1 * ddq1;
        n1_z
    };
    // drives
    {
        let t764 = FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t765 = FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t766 = FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign());
        let t767 = FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign());
        let t768 = FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign());
        let t769 = FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign());
        let t770 = FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign());
        put(0, t764);
        put(1, t765);
        put(2, t766);
        put(3, t767);
        put(4, t768);
        put(5, t769);
        put(6, t770);
    }
}
