//! Torques from the standard parameters.
//!
//! `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil and Dombre, 9.5.2.
//!
//! 359 multiplications, 365 additions; 7, 7 of 7 structurally nonzero.

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
        _, _, _, _, _, _, ZZ1, _, _, _, _, MSX2,
        MSY2, MSZ2, XX2, YY2, ZZ2, XY2, XZ2, YZ2, M3, MSX3, MSY3, MSZ3,
        XX3, YY3, ZZ3, XY3, XZ3, YZ3, M4, MSX4, MSY4, MSZ4, XX4, YY4,
        ZZ4, XY4, XZ4, YZ4, M5, MSX5, MSY5, MSZ5, XX5, YY5, ZZ5, XY5,
        XZ5, YZ5, M6, MSX6, MSY6, MSZ6, XX6, YY6, ZZ6, XY6, XZ6, YZ6,
        M7, MSX7, MSY7, MSZ7, XX7, YY7, ZZ7, XY7, XZ7, YZ7, FV1, FV2,
        FV3, FV4, FV5, FV6, FV7, FC1, FC2, FC3, FC4, FC5, FC6, FC7,
        FO1, FO2, FO3, FO4, FO5, FO6, FO7,
        ..] = *phi;
    let A = S::constant(0.0825);
    let L2 = S::constant(0.316);
    let L3 = S::constant(0.384);
    let k0 = S::constant(9.81);
    let k4 = S::constant(0.088);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        t1, t2, t3, t4, t5, t6, t9, t10,
        t11, t12, dw2_y, t14, t15, t16, t17, t18,
        t19, t20,
    ] = {
        let t1 = s2 * dq1;
        let t2 = c2 * dq1;
        let t3 = s2 * ddq1;
        let t4 = c2 * ddq1;
        let t5 = s2 * k0;
        let t6 = c2 * k0;
        let t7 = t1 * t1;
        let t8 = dq2 * dq2;
        let t9 = t1 * t2;
        let t10 = dq2 * t1;
        let t11 = dq2 * t2;
        let t12 = t3 + t11;
        let dw2_y = t10 - t4;
        let t14 = t7 - t8;
        let t15 = t14 - t0;
        let t16 = t9 - ddq2;
        let t17 = ddq2 + t9;
        let t18 = t7 + t8;
        let t19 = t10 + dw2_y;
        let t20 = t11 + t12;
        [
        t1, t2, t3, t4, t5, t6, t9, t10,
        t11, t12, dw2_y, t14, t15, t16, t17, t18,
        t19, t20,
    ]
    };
    // link 3: motion
    let [
        w3_x, w3_y, t31, a3_x, a3_y, t40, t43, w3_z,
        dw3_z, t48, t49, t50, dw3_x, dw3_y, t53, t54,
        t55, t56, t57, t58, t59,
    ] = {
        let w3_x = s3 * dq2 - c3 * t1;
        let w3_y = c3 * dq2 + s3 * t1;
        let t29 = L2 * t20;
        let t30 = t5 + L2 * t16;
        let t31 = L2 * t18 - t6;
        let a3_x = s3 * t29 - c3 * t30;
        let a3_y = c3 * t29 + s3 * t30;
        let t40 = s3 * t20 - c3 * t16;
        let t43 = c3 * t20 + s3 * t16;
        let w3_z = t2 + dq3;
        let dw3_z = ddq3 - dw2_y;
        let t46 = w3_x * w3_x;
        let t47 = w3_z * w3_z;
        let t48 = w3_x * w3_y;
        let t49 = w3_x * w3_z;
        let t50 = w3_y * w3_z;
        let dw3_x = t50 - t43;
        let dw3_y = t40 - t49;
        let t53 = t46 - t47;
        let t54 = t53 - t18;
        let t55 = t48 - dw3_z;
        let t56 = dw3_z + t48;
        let t57 = t46 + t47;
        let t58 = t49 - dw3_y;
        let t59 = t50 + dw3_x;
        [
        w3_x, w3_y, t31, a3_x, a3_y, t40, t43, w3_z,
        dw3_z, t48, t49, t50, dw3_x, dw3_y, t53, t54,
        t55, t56, t57, t58, t59,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t70, a4_x, a4_y, t80, t83, w4_z,
        dw4_z, t88, t89, t90, dw4_x, t92, t93, t94,
        t95, t96, t97, t98, t99,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t69 = a3_x + A * t54;
        let t70 = a3_y + A * t56;
        let t71 = A * t58 - t31;
        let a4_x = c4 * t69 + s4 * t71;
        let a4_y = c4 * t71 - s4 * t69;
        let t80 = c4 * t55 + s4 * t59;
        let t83 = s4 * t55 - c4 * t59;
        let w4_z = dq4 - w3_y;
        let dw4_z = ddq4 - dw3_y;
        let t86 = w4_x * w4_x;
        let t87 = w4_z * w4_z;
        let t88 = w4_x * w4_y;
        let t89 = w4_x * w4_z;
        let t90 = w4_y * w4_z;
        let dw4_x = t90 - t83;
        let t92 = t80 + t89;
        let t93 = t86 - t87;
        let t94 = t93 - t57;
        let t95 = t88 - dw4_z;
        let t96 = dw4_z + t88;
        let t97 = t86 + t87;
        let t98 = t89 + t92;
        let t99 = t90 + dw4_x;
        [
        w4_x, w4_y, t70, a4_x, a4_y, t80, t83, w4_z,
        dw4_z, t88, t89, t90, dw4_x, t92, t93, t94,
        t95, t96, t97, t98, t99,
    ]
    };
    // link 5: motion
    let [
        w5_x, t105, a5_z, a5_x, a6_z, t126, t129, w5_z,
        dw5_z, t134, t135, t136, dw5_x, dw5_y, t139, t140,
        t141, t142, t143, t144, t145,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t105 = c5 * w4_z + s5 * w4_x;
        let t115 = a4_x + (L3 * t95 - A * t94);
        let a5_z = a4_y - (A * t96 + L3 * t97);
        let t117 = L3 * t99 - A * t98 - t70;
        let a5_x = c5 * t115 - s5 * t117;
        let a6_z = c5 * t117 + s5 * t115;
        let t126 = c5 * t95 - s5 * t99;
        let t129 = c5 * t99 + s5 * t95;
        let w5_z = w4_y + dq5;
        let dw5_z = ddq5 - t92;
        let t132 = w5_x * w5_x;
        let t133 = w5_z * w5_z;
        let t134 = w5_x * t105;
        let t135 = w5_x * w5_z;
        let t136 = t105 * w5_z;
        let dw5_x = t129 - t136;
        let dw5_y = t126 - t135;
        let t139 = t132 - t133;
        let t140 = t139 - t97;
        let t141 = dw5_z + t134;
        let t142 = dw5_z - t134;
        let t143 = t132 + t133;
        let t144 = t135 - dw5_y;
        let t145 = dw5_x - t136;
        [
        w5_x, t105, a5_z, a5_x, a6_z, t126, t129, w5_z,
        dw5_z, t134, t135, t136, dw5_x, dw5_y, t139, t140,
        t141, t142, t143, t144, t145,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, a6_x, a6_y, t160, t163, w6_z, dw6_z,
        t168, t169, t170, dw6_x, dw6_y, t173, t174, t175,
        t176, t177, t178, t179,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let a6_x = c6 * a5_x + s6 * a5_z;
        let a6_y = c6 * a5_z - s6 * a5_x;
        let t160 = c6 * t141 - s6 * t145;
        let t163 = c6 * t145 + s6 * t141;
        let w6_z = t105 + dq6;
        let dw6_z = ddq6 - dw5_y;
        let t166 = w6_x * w6_x;
        let t167 = w6_z * w6_z;
        let t168 = w6_x * w6_y;
        let t169 = w6_x * w6_z;
        let t170 = w6_y * w6_z;
        let dw6_x = t163 + t170;
        let dw6_y = t160 - t169;
        let t173 = t166 - t167;
        let t174 = t173 - t143;
        let t175 = t168 - dw6_z;
        let t176 = dw6_z + t168;
        let t177 = t166 + t167;
        let t178 = t169 - dw6_y;
        let t179 = t170 + dw6_x;
        [
        w6_x, w6_y, a6_x, a6_y, t160, t163, w6_z, dw6_z,
        t168, t169, t170, dw6_x, dw6_y, t173, t174, t175,
        t176, t177, t178, t179,
    ]
    };
    // link 7: motion
    let [
        t190, a7_x, a7_y, t200, t203, dw7_z, t208, t209,
        t210, dw7_x, t212, t213, t214, t215, t216, t217,
        t218, t219,
    ] = {
        let w7_x = c7 * w6_x + s7 * w6_z;
        let w7_y = c7 * w6_z - s7 * w6_x;
        let t189 = a6_x + k4 * t174;
        let t190 = a6_y + k4 * t176;
        let t191 = a6_z + k4 * t178;
        let a7_x = c7 * t189 + s7 * t191;
        let a7_y = c7 * t191 - s7 * t189;
        let t200 = c7 * t175 + s7 * t179;
        let t203 = s7 * t175 - c7 * t179;
        let w7_z = dq7 - w6_y;
        let dw7_z = ddq7 - dw6_y;
        let t206 = w7_x * w7_x;
        let t207 = w7_z * w7_z;
        let t208 = w7_x * w7_y;
        let t209 = w7_x * w7_z;
        let t210 = w7_y * w7_z;
        let dw7_x = t210 - t203;
        let t212 = t200 + t209;
        let t213 = t206 - t207;
        let t214 = t213 - t177;
        let t215 = t208 - dw7_z;
        let t216 = dw7_z + t208;
        let t217 = t206 + t207;
        let t218 = t209 + t212;
        let t219 = t210 + dw7_x;
        [
        t190, a7_x, a7_y, t200, t203, dw7_z, t208, t209,
        t210, dw7_x, t212, t213, t214, t215, t216, t217,
        t218, t219,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t287, t290, t293, t299, t300] = {
        let t241 = XZ7 * t203;
        let t242 = t210 * (ZZ7 - YY7) + XX7 * dw7_x - XY7 * t218 + XZ7 * t216;
        let t243 = t209 * (XX7 - ZZ7) - YY7 * t212 + XY7 * t219 - XZ7 * t213;
        let t244 = t208 * (YY7 - XX7) + ZZ7 * dw7_z + XY7 * (t214 + t217) - t241;
        let f7_x = M7 * a7_x + (MSX7 * t214 + MSY7 * t215 - MSZ7 * t200);
        let f7_y = M7 * a7_y + (MSZ7 * t203 + (MSX7 * t216 - MSY7 * t217));
        let f7_z = MSX7 * t218 + MSY7 * t219 - MSZ7 * t177 - M7 * t190;
        let n7_x = t242 + YZ7 * (t177 - t217) - (MSY7 * t190 + MSZ7 * a7_y);
        let n7_y = t243 - YZ7 * t215 + (MSZ7 * a7_x + MSX7 * t190);
        let n7_z = t244 - YZ7 * t200 + (MSX7 * a7_y - MSY7 * a7_x);
        let t287 = c7 * f7_x - s7 * f7_y;
        let t290 = s7 * f7_x + c7 * f7_y;
        let t293 = c7 * n7_x - s7 * n7_y;
        let t299 = s7 * n7_x + c7 * n7_y - k4 * f7_z;
        let t300 = n7_z + k4 * t290;
        [f7_z, n7_z, t287, t290, t293, t299, t300]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t374, t377, t380, t383] = {
        let t322 = XZ6 * t163;
        let t323 = t170 * (ZZ6 - YY6) + XX6 * dw6_x - XY6 * t178 + XZ6 * t176;
        let t324 = t169 * (XX6 - ZZ6) + YY6 * dw6_y + XY6 * t179 - XZ6 * t173;
        let t325 = t168 * (YY6 - XX6) + ZZ6 * dw6_z + XY6 * (t174 + t177) + t322;
        let f6_x = t287 + (M6 * a6_x + (MSZ6 * t160 + (MSX6 * t174 + MSY6 * t175)));
        let f6_y = M6 * a6_y + (MSX6 * t176 - MSY6 * t177 - MSZ6 * t163) - f7_z;
        let f6_z = t290 + (M6 * a6_z + (MSX6 * t178 + MSY6 * t179 - MSZ6 * t143));
        let n6_x = t293 + (t323 + YZ6 * (t143 - t177) + (MSY6 * a6_z - MSZ6 * a6_y));
        let n6_y = t324 - YZ6 * t175 + (MSZ6 * a6_x - MSX6 * a6_z) - t300;
        let n6_z = t299 + (t325 + YZ6 * t160 + (MSX6 * a6_y - MSY6 * a6_x));
        let t374 = c6 * f6_x - s6 * f6_y;
        let t377 = s6 * f6_x + c6 * f6_y;
        let t380 = c6 * n6_x - s6 * n6_y;
        let t383 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t374, t377, t380, t383]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t457, t460, t472, t473, t474] = {
        let t405 = XZ5 * t129;
        let t406 = XX5 * dw5_x - t136 * (ZZ5 - YY5) - XY5 * t144 + XZ5 * t142;
        let t407 = t135 * (XX5 - ZZ5) + YY5 * dw5_y + XY5 * t145 - XZ5 * t139;
        let t408 = ZZ5 * dw5_z - t134 * (YY5 - XX5) + XY5 * (t140 + t143) + t405;
        let f5_x = t374 + (M5 * a5_x + (MSZ5 * t126 + (MSX5 * t140 - MSY5 * t141)));
        let f5_y = MSX5 * t142 - MSY5 * t143 - MSZ5 * t129 - M5 * a6_z - f6_z;
        let f5_z = t377 + (M5 * a5_z + (MSX5 * t144 + MSY5 * t145 - MSZ5 * t97));
        let n5_x = t380 + (t406 + YZ5 * (t97 - t143) + (MSY5 * a5_z + MSZ5 * a6_z));
        let n5_y = t407 + YZ5 * t141 + (MSZ5 * a5_x - MSX5 * a5_z) - n6_z;
        let n5_z = t383 + (t408 + YZ5 * t126 - (MSX5 * a6_z + MSY5 * a5_x));
        let t457 = c5 * f5_x - s5 * f5_y;
        let t460 = s5 * f5_x + c5 * f5_y;
        let t472 = c5 * n5_x - s5 * n5_y - L3 * t460;
        let t473 = s5 * n5_x + c5 * n5_y + (L3 * t457 + A * f5_z);
        let t474 = n5_z - A * t460;
        [f5_z, n5_z, t457, t460, t472, t473, t474]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t548, t554, t560, t561] = {
        let t496 = XZ4 * t83;
        let t497 = t90 * (ZZ4 - YY4) + XX4 * dw4_x - XY4 * t98 + XZ4 * t96;
        let t498 = t89 * (XX4 - ZZ4) - YY4 * t92 + XY4 * t99 - XZ4 * t93;
        let t499 = t88 * (YY4 - XX4) + ZZ4 * dw4_z + XY4 * (t94 + t97) - t496;
        let f4_x = t457 + (M4 * a4_x + (MSX4 * t94 + MSY4 * t95 - MSZ4 * t80));
        let f4_y = f5_z + (M4 * a4_y + (MSZ4 * t83 + (MSX4 * t96 - MSY4 * t97)));
        let f4_z = MSX4 * t98 + MSY4 * t99 - MSZ4 * t57 - M4 * t70 - t460;
        let n4_x = t472 + (t497 + YZ4 * (t57 - t97) - (MSY4 * t70 + MSZ4 * a4_y));
        let n4_y = t474 + (t498 - YZ4 * t95 + (MSZ4 * a4_x + MSX4 * t70));
        let n4_z = t499 - YZ4 * t80 + (MSX4 * a4_y - MSY4 * a4_x) - t473;
        let t548 = c4 * f4_x - s4 * f4_y;
        let t554 = c4 * n4_x - s4 * n4_y;
        let t560 = s4 * n4_x + c4 * n4_y - A * f4_z;
        let t561 = n4_z + A * (s4 * f4_x + c4 * f4_y);
        [f4_z, n4_z, t548, t554, t560, t561]
    };
    // link 3: force and moment
    let [n3_z, t639, t640] = {
        let t583 = XZ3 * t43;
        let t584 = t50 * (ZZ3 - YY3) + XX3 * dw3_x - XY3 * t58 + XZ3 * t56;
        let t585 = t49 * (XX3 - ZZ3) + YY3 * dw3_y + XY3 * t59 - XZ3 * t53;
        let t586 = t48 * (YY3 - XX3) + ZZ3 * dw3_z + XY3 * (t54 + t57) - t583;
        let f3_x = t548 + (M3 * a3_x + (MSZ3 * t40 + (MSX3 * t54 + MSY3 * t55)));
        let f3_y = M3 * a3_y + (MSZ3 * t43 + (MSX3 * t56 - MSY3 * t57)) - f4_z;
        let n3_x = t554 + (t584 + YZ3 * (t18 - t57) - (MSY3 * t31 + MSZ3 * a3_y));
        let n3_y = t585 - YZ3 * t55 + (MSZ3 * a3_x + MSX3 * t31) - t561;
        let n3_z = t560 + (t586 + YZ3 * t40 + (MSX3 * a3_y - MSY3 * a3_x));
        let t639 = c3 * n3_x - s3 * n3_y - L2 * (s3 * f3_x + c3 * f3_y);
        let t640 = s3 * n3_x + c3 * n3_y + L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, t639, t640]
    };
    // link 2: force and moment
    let [n2_z, t686] = {
        let t662 = XZ2 * t3;
        let t663 = XY2 * t19 - (t11 * (ZZ2 - YY2) + XX2 * t12) + XZ2 * t17;
        let t664 = YY2 * dw2_y - t10 * (XX2 - ZZ2) - XY2 * t20 - XZ2 * t14;
        let t665 = t9 * (YY2 - XX2) + ZZ2 * ddq2 + XY2 * (t15 + t18) - t662;
        let n2_x = t639 + (t663 + YZ2 * (t0 - t18) + MSZ2 * t6);
        let n2_y = t664 - YZ2 * t16 - MSZ2 * t5 - n3_z;
        let n2_z = t640 + (t665 - YZ2 * t4 + (MSY2 * t5 - MSX2 * t6));
        let t686 = s2 * n2_x + c2 * n2_y;
        [n2_z, t686]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = ZZ1 * ddq1 - t686;
        n1_z
    };
    // drives
    {
        let t724 = FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t725 = FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t726 = FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign());
        let t727 = FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign());
        let t728 = FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign());
        let t729 = FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign());
        let t730 = FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign());
        put(0, t724);
        put(1, t725);
        put(2, t726);
        put(3, t727);
        put(4, t728);
        put(5, t729);
        put(6, t730);
    }
}
