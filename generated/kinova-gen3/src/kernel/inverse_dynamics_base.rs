//! Torques from the base parameters.
//!
//! `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil
//! and Dombre, 9.6.
//!
//! 326 multiplications, 312 additions; 7, 7 of 7 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, GRAVITY, Trig};

/// Torques from the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE], out: &mut [S; 7]) {
    entries(trig, dq, ddq, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6, ddq7] = *ddq;
    let [
        ZZ1R, MSX2, MSY2R, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3, MSY3R, XX3R, ZZ3R,
        XY3, XZ3, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6R, XX6R, ZZ6R, XY6, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7, FV1, FV2, FV3, FV4, FV5,
        FV6, FV7, FC1, FC2, FC3, FC4, FC5, FC6, FC7, FO1, FO2, FO3,
        FO4, FO5, FO6, FO7,
        ..] = *beta;
    let k0 = S::constant(-GRAVITY[2]);
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
        a2_z, t6, a2_y, w2_x, w2_y, t11, t14, dw2_y,
        t21, t22, t23, t24, t25,
    ] = {
        let t3 = ddq1 * k1;
        let a2_z = t0 * k1;
        let t6 = s2 * k0 + c2 * t3;
        let a2_y = s2 * t3 - c2 * k0;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t11 = s2 * ddq1;
        let t13 = w2_x * w2_x;
        let t14 = dq2 * dq2;
        let t15 = w2_x * w2_y;
        let t17 = dq2 * w2_y;
        let dw2_x = t11 + t17;
        let dw2_y = c2 * ddq1 - dq2 * w2_x;
        let t21 = t13 - t14 - t0;
        let t22 = t15 - ddq2;
        let t23 = ddq2 + t15;
        let t24 = t13 + t14;
        let t25 = t17 + dw2_x;
        [
        a2_z, t6, a2_y, w2_x, w2_y, t11, t14, dw2_y,
        t21, t22, t23, t24, t25,
    ]
    };
    // link 3: motion
    let [
        a3_z, t34, a3_y, w3_x, t43, t46, t49, w3_z,
        dw3_z, t54, t55, t56, dw3_x, dw3_y, t59, t60,
        t61, t62, t63, t64, t65,
    ] = {
        let t29 = t6 + t22 * k2;
        let a3_z = a2_y + t24 * k2;
        let t31 = a2_z - t25 * k2;
        let t34 = c3 * t29 + s3 * t31;
        let a3_y = s3 * t29 - c3 * t31;
        let w3_x = c3 * w2_x - s3 * dq2;
        let t43 = c3 * dq2 + s3 * w2_x;
        let t46 = c3 * t22 - s3 * t25;
        let t49 = c3 * t25 + s3 * t22;
        let w3_z = w2_y + dq3;
        let dw3_z = dw2_y + ddq3;
        let t52 = w3_x * w3_x;
        let t53 = w3_z * w3_z;
        let t54 = w3_x * t43;
        let t55 = w3_x * w3_z;
        let t56 = t43 * w3_z;
        let dw3_x = t49 - t56;
        let dw3_y = t46 - t55;
        let t59 = t52 - t53;
        let t60 = t59 - t24;
        let t61 = dw3_z + t54;
        let t62 = dw3_z - t54;
        let t63 = t52 + t53;
        let t64 = t55 - dw3_y;
        let t65 = dw3_x - t56;
        [
        a3_z, t34, a3_y, w3_x, t43, t46, t49, w3_z,
        dw3_z, t54, t55, t56, dw3_x, dw3_y, t59, t60,
        t61, t62, t63, t64, t65,
    ]
    };
    // link 4: motion
    let [
        t70, a4_x, a4_y, w4_x, w4_y, t86, t89, w4_z,
        dw4_z, t94, t95, t96, dw4_x, dw4_y, t99, t100,
        t101, t102, t103, t104, t105,
    ] = {
        let t69 = t34 + t61 * k3;
        let t70 = a3_y - t63 * k3;
        let t71 = a3_z + t65 * k3;
        let a4_x = s4 * t71 - c4 * t69;
        let a4_y = c4 * t71 + s4 * t69;
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t86 = c4 * t61 - s4 * t65;
        let t89 = c4 * t65 + s4 * t61;
        let w4_z = t43 + dq4;
        let dw4_z = ddq4 - dw3_y;
        let t92 = w4_x * w4_x;
        let t93 = w4_z * w4_z;
        let t94 = w4_x * w4_y;
        let t95 = w4_x * w4_z;
        let t96 = w4_y * w4_z;
        let dw4_x = t89 + t96;
        let dw4_y = t86 - t95;
        let t99 = t92 - t93;
        let t100 = t99 - t63;
        let t101 = t94 - dw4_z;
        let t102 = dw4_z + t94;
        let t103 = t92 + t93;
        let t104 = t95 - dw4_y;
        let t105 = t96 + dw4_x;
        [
        t70, a4_x, a4_y, w4_x, w4_y, t86, t89, w4_z,
        dw4_z, t94, t95, t96, dw4_x, dw4_y, t99, t100,
        t101, t102, t103, t104, t105,
    ]
    };
    // link 5: motion
    let [
        a5_z, a5_x, a5_y, w5_x, t123, t126, t129, w5_z,
        dw5_z, t134, t135, t136, dw5_x, dw5_y, t139, t140,
        t141, t142, t143, t144, t145,
    ] = {
        let t109 = a4_x - t101 * k4;
        let a5_z = a4_y + t103 * k4;
        let t111 = t70 + t105 * k4;
        let a5_x = c5 * t109 + s5 * t111;
        let a5_y = c5 * t111 - s5 * t109;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t123 = c5 * w4_z + s5 * w4_x;
        let t126 = c5 * t101 - s5 * t105;
        let t129 = c5 * t105 + s5 * t101;
        let w5_z = w4_y + dq5;
        let dw5_z = dw4_y + ddq5;
        let t132 = w5_x * w5_x;
        let t133 = w5_z * w5_z;
        let t134 = w5_x * t123;
        let t135 = w5_x * w5_z;
        let t136 = t123 * w5_z;
        let dw5_x = t129 - t136;
        let dw5_y = t126 - t135;
        let t139 = t132 - t133;
        let t140 = t139 - t103;
        let t141 = dw5_z + t134;
        let t142 = dw5_z - t134;
        let t143 = t132 + t133;
        let t144 = t135 - dw5_y;
        let t145 = dw5_x - t136;
        [
        a5_z, a5_x, a5_y, w5_x, t123, t126, t129, w5_z,
        dw5_z, t134, t135, t136, dw5_x, dw5_y, t139, t140,
        t141, t142, t143, t144, t145,
    ]
    };
    // link 6: motion
    let [
        t150, a6_x, a6_y, w6_x, w6_y, t166, t169, w6_z,
        dw6_z, t174, t175, t176, dw6_x, dw6_y, t179, t180,
        t181, t182, t183, t184, t185,
    ] = {
        let t149 = a5_x - t141 * k5;
        let t150 = a5_y - t143 * k5;
        let t151 = a5_z + t145 * k5;
        let a6_x = c6 * t149 + s6 * t151;
        let a6_y = c6 * t151 - s6 * t149;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t166 = c6 * t141 - s6 * t145;
        let t169 = c6 * t145 + s6 * t141;
        let w6_z = t123 + dq6;
        let dw6_z = ddq6 - dw5_y;
        let t172 = w6_x * w6_x;
        let t173 = w6_z * w6_z;
        let t174 = w6_x * w6_y;
        let t175 = w6_x * w6_z;
        let t176 = w6_y * w6_z;
        let dw6_x = t169 + t176;
        let dw6_y = t166 - t175;
        let t179 = t172 - t173;
        let t180 = t179 - t143;
        let t181 = t174 - dw6_z;
        let t182 = dw6_z + t174;
        let t183 = t172 + t173;
        let t184 = t175 - dw6_y;
        let t185 = t176 + dw6_x;
        [
        t150, a6_x, a6_y, w6_x, w6_y, t166, t169, w6_z,
        dw6_z, t174, t175, t176, dw6_x, dw6_y, t179, t180,
        t181, t182, t183, t184, t185,
    ]
    };
    // link 7: motion
    let [
        t188, t191, t200, t203, dw7_z, t208, t209, t210,
        dw7_x, t213, t214, t215, t216, t217, t218, t219,
    ] = {
        let t188 = c7 * a6_x + s7 * t150;
        let t191 = c7 * t150 - s7 * a6_x;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t197 = c7 * w6_z + s7 * w6_x;
        let t200 = c7 * t181 - s7 * t185;
        let t203 = c7 * t185 + s7 * t181;
        let w7_z = w6_y + dq7;
        let dw7_z = dw6_y + ddq7;
        let t206 = w7_x * w7_x;
        let t207 = w7_z * w7_z;
        let t208 = w7_x * t197;
        let t209 = w7_x * w7_z;
        let t210 = t197 * w7_z;
        let dw7_x = t203 - t210;
        let dw7_y = t200 - t209;
        let t213 = t206 - t207;
        let t214 = t213 - t183;
        let t215 = dw7_z + t208;
        let t216 = dw7_z - t208;
        let t217 = t206 + t207;
        let t218 = t209 - dw7_y;
        let t219 = dw7_x - t210;
        [
        t188, t191, t200, t203, dw7_z, t208, t209, t210,
        dw7_x, t213, t214, t215, t216, t217, t218, t219,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t271, t274, t277, t280] = {
        let t221 = XZ7 + MSX7 * k6;
        let t223 = YZ7 + MSY7 * k6;
        let t244 = XX7R * t208 + ZZ7 * dw7_z + XY7 * (t214 + t217) + t203 * t221;
        let t246 = t223 * (t183 - t217);
        let t249 = XX7R * dw7_x - ZZ7 * t210 - XY7 * t218 + t216 * t221 + t246;
        let t250 = t209 * (XX7R - ZZ7) + XY7 * t219 - t213 * t221 + t215 * t223;
        let f7_x = MSX7 * t214 - MSY7 * t215;
        let f7_y = MSX7 * t216 - MSY7 * t217;
        let f7_z = MSX7 * t218 + MSY7 * t219;
        let n7_x = t249 + MSY7 * a6_y;
        let n7_y = t250 - MSX7 * a6_y;
        let n7_z = t244 + t200 * t223 + (MSX7 * t191 - MSY7 * t188);
        let t271 = c7 * f7_x - s7 * f7_y;
        let t274 = s7 * f7_x + c7 * f7_y;
        let t277 = c7 * n7_x - s7 * n7_y;
        let t280 = s7 * n7_x + c7 * n7_y;
        [f7_z, n7_z, t271, t274, t277, t280]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t334, t337, t346, t347] = {
        let t301 = ZZ6R * dw6_z - XX6R * t174 + XY6 * (t180 + t183) + XZ6 * t169;
        let t303 = YZ6 * (t143 - t183);
        let t306 = ZZ6R * t176 + XX6R * dw6_x - XY6 * t184 + XZ6 * t182 + t303;
        let t307 = t175 * (XX6R - ZZ6R) + XY6 * t185 - XZ6 * t179 - YZ6 * t181;
        let f6_x = t271 + (MSX6 * t180 + MSY6R * t181);
        let f6_y = f7_z + (MSX6 * t182 - MSY6R * t183);
        let f6_z = MSX6 * t184 + MSY6R * t185 - t274;
        let n6_x = t277 + (t306 - MSY6R * t150);
        let n6_y = n7_z + (t307 + MSX6 * t150);
        let n6_z = t301 + YZ6 * t166 + (MSX6 * a6_y - MSY6R * a6_x) - t280;
        let t334 = c6 * f6_x - s6 * f6_y;
        let t337 = s6 * f6_x + c6 * f6_y;
        let t346 = c6 * n6_x - s6 * n6_y + k5 * t337;
        let t347 = s6 * n6_x + c6 * n6_y - k5 * t334;
        [f6_z, n6_z, t334, t337, t346, t347]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t401, t404, t413, t414] = {
        let t368 = XX5R * t134 + ZZ5R * dw5_z + XY5 * (t140 + t143) + XZ5 * t129;
        let t370 = YZ5 * (t103 - t143);
        let t373 = XX5R * dw5_x - ZZ5R * t136 - XY5 * t144 + XZ5 * t142 + t370;
        let t374 = t135 * (XX5R - ZZ5R) + XY5 * t145 - XZ5 * t139 + YZ5 * t141;
        let f5_x = t334 + (MSX5 * t140 - MSY5R * t141);
        let f5_y = MSX5 * t142 - MSY5R * t143 - f6_z;
        let f5_z = t337 + (MSX5 * t144 + MSY5R * t145);
        let n5_x = t346 + (t373 + MSY5R * a5_z);
        let n5_y = t374 - MSX5 * a5_z - n6_z;
        let n5_z = t347 + (t368 + YZ5 * t126 + (MSX5 * a5_y - MSY5R * a5_x));
        let t401 = c5 * f5_x - s5 * f5_y;
        let t404 = s5 * f5_x + c5 * f5_y;
        let t413 = c5 * n5_x - s5 * n5_y + k4 * t404;
        let t414 = s5 * n5_x + c5 * n5_y - k4 * t401;
        [f5_z, n5_z, t401, t404, t413, t414]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t468, t471, t480, t481] = {
        let t435 = ZZ4R * dw4_z - XX4R * t94 + XY4 * (t100 + t103) + XZ4 * t89;
        let t437 = YZ4 * (t63 - t103);
        let t440 = ZZ4R * t96 + XX4R * dw4_x - XY4 * t104 + XZ4 * t102 + t437;
        let t441 = t95 * (XX4R - ZZ4R) + XY4 * t105 - XZ4 * t99 - YZ4 * t101;
        let f4_x = t401 + (MSX4 * t100 + MSY4R * t101);
        let f4_y = f5_z + (MSX4 * t102 - MSY4R * t103);
        let f4_z = MSX4 * t104 + MSY4R * t105 - t404;
        let n4_x = t413 + (t440 - MSY4R * t70);
        let n4_y = n5_z + (t441 + MSX4 * t70);
        let n4_z = t435 + YZ4 * t86 + (MSX4 * a4_y - MSY4R * a4_x) - t414;
        let t468 = c4 * f4_x - s4 * f4_y;
        let t471 = s4 * f4_x + c4 * f4_y;
        let t480 = c4 * n4_x - s4 * n4_y + k3 * t471;
        let t481 = s4 * n4_x + c4 * n4_y - k3 * t468;
        [f4_z, n4_z, t468, t471, t480, t481]
    };
    // link 3: force and moment
    let [f3_z, n3_z, t535, t547, t548] = {
        let t502 = XX3R * t54 + ZZ3R * dw3_z + XY3 * (t60 + t63) + XZ3 * t49;
        let t504 = YZ3 * (t24 - t63);
        let t507 = XX3R * dw3_x - ZZ3R * t56 - XY3 * t64 + XZ3 * t62 + t504;
        let t508 = t55 * (XX3R - ZZ3R) + XY3 * t65 - XZ3 * t59 + YZ3 * t61;
        let f3_x = t468 + (MSX3 * t60 - MSY3R * t61);
        let f3_y = MSX3 * t62 - MSY3R * t63 - f4_z;
        let f3_z = t471 + (MSX3 * t64 + MSY3R * t65);
        let n3_x = t480 + (t507 + MSY3R * a3_z);
        let n3_y = t508 - MSX3 * a3_z - n4_z;
        let n3_z = t481 + (t502 + YZ3 * t46 + (MSX3 * a3_y + MSY3R * t34));
        let t535 = c3 * f3_x - s3 * f3_y;
        let t547 = c3 * n3_x - s3 * n3_y + k2 * (s3 * f3_x + c3 * f3_y);
        let t548 = s3 * n3_x + c3 * n3_y - k2 * t535;
        [f3_z, n3_z, t535, t547, t548]
    };
    // link 2: force and moment
    let [t569, n2_z, t599] = {
        let t552 = s2 * XX2R + c2 * (XY2 + XY2);
        let t554 = c2 * t552 - XY2;
        let t557 = s2 * XZ2 + c2 * YZ2;
        let t568 = ddq2 * t557 + t14 * (c2 * XZ2 - s2 * YZ2);
        let t569 = t11 * t552 + (t554 + t554) * (dq1 * dq2) + t568;
        let f2_x = t535 + (MSX2 * t21 + MSY2R * t22);
        let f2_y = f3_z + (MSX2 * t23 - MSY2R * t24);
        let n2_x = t547 + MSY2R * a2_z;
        let n2_y = n3_z - MSX2 * a2_z;
        let t590 = MSX2 * a2_y + MSY2R * t6 - t548;
        let n2_z = ZZ2R * ddq2 + ddq1 * t557 - t0 * t554 + t590;
        let f1_x = c2 * f2_x - s2 * f2_y;
        let t599 = s2 * n2_x + c2 * n2_y - k1 * f1_x;
        [t569, n2_z, t599]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t569 + (t599 + ZZ1R * ddq1);
        n1_z
    };
    // drives
    {
        let t638 = FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t639 = FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t640 = FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign());
        let t641 = FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign());
        let t642 = FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign());
        let t643 = FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign());
        let t644 = FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign());
        put(0, t638);
        put(1, t639);
        put(2, t640);
        put(3, t641);
        put(4, t642);
        put(5, t643);
        put(6, t644);
    }
}
