//! Torques from the standard parameters.
//!
//! `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil
//! and Dombre, 9.5.2.
//!
//! 360 multiplications, 356 additions; 7, 7 of 7 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, STANDARD, GRAVITY, Trig, constants};

/// Torques from the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], out: &mut [S; 7]) {
    entries(trig, dq, ddq, phi, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], mut put: impl FnMut(usize, S)) {
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
    let k0 = S::constant(-GRAVITY[2]);
    let k4 = S::constant(0.088);
    let k_A = S::constant(constants::A);
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        t1, t2, t3, t4, t5, t8, dw2_y, t14,
        t15, t16,
    ] = {
        let t1 = s2 * k0;
        let t2 = c2 * k0;
        let t3 = s2 * dq1;
        let t4 = c2 * dq1;
        let t5 = s2 * ddq1;
        let t8 = dq2 * dq2;
        let t11 = dq2 * t4;
        let dw2_y = dq2 * t3 - c2 * ddq1;
        let t14 = t3 * t4 - ddq2;
        let t15 = t3 * t3 + t8;
        let t16 = t11 + (t5 + t11);
        [
        t1, t2, t3, t4, t5, t8, dw2_y, t14,
        t15, t16,
    ]
    };
    // link 3: motion
    let [
        t21, a3_x, a3_y, w3_x, w3_y, t36, t39, w3_z,
        dw3_z, t44, t45, t46, dw3_x, dw3_y, t49, t50,
        t51, t52, t53, t54, t55,
    ] = {
        let t19 = k_L2 * t16;
        let t20 = t1 + k_L2 * t14;
        let t21 = k_L2 * t15 - t2;
        let a3_x = s3 * t19 - c3 * t20;
        let a3_y = c3 * t19 + s3 * t20;
        let w3_x = s3 * dq2 - c3 * t3;
        let w3_y = c3 * dq2 + s3 * t3;
        let t36 = s3 * t16 - c3 * t14;
        let t39 = c3 * t16 + s3 * t14;
        let w3_z = t4 + dq3;
        let dw3_z = ddq3 - dw2_y;
        let t42 = w3_x * w3_x;
        let t43 = w3_z * w3_z;
        let t44 = w3_x * w3_y;
        let t45 = w3_x * w3_z;
        let t46 = w3_y * w3_z;
        let dw3_x = t46 - t39;
        let dw3_y = t36 - t45;
        let t49 = t42 - t43;
        let t50 = t49 - t15;
        let t51 = t44 - dw3_z;
        let t52 = dw3_z + t44;
        let t53 = t42 + t43;
        let t54 = t45 - dw3_y;
        let t55 = t46 + dw3_x;
        [
        t21, a3_x, a3_y, w3_x, w3_y, t36, t39, w3_z,
        dw3_z, t44, t45, t46, dw3_x, dw3_y, t49, t50,
        t51, t52, t53, t54, t55,
    ]
    };
    // link 4: motion
    let [
        t60, a4_x, a4_y, w4_x, w4_y, t76, t79, w4_z,
        dw4_z, t84, t85, t86, dw4_x, t88, t89, t90,
        t91, t92, t93, t94, t95,
    ] = {
        let t59 = a3_x + k_A * t50;
        let t60 = a3_y + k_A * t52;
        let t61 = k_A * t54 - t21;
        let a4_x = c4 * t59 + s4 * t61;
        let a4_y = c4 * t61 - s4 * t59;
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t76 = c4 * t51 + s4 * t55;
        let t79 = s4 * t51 - c4 * t55;
        let w4_z = dq4 - w3_y;
        let dw4_z = ddq4 - dw3_y;
        let t82 = w4_x * w4_x;
        let t83 = w4_z * w4_z;
        let t84 = w4_x * w4_y;
        let t85 = w4_x * w4_z;
        let t86 = w4_y * w4_z;
        let dw4_x = t86 - t79;
        let t88 = t76 + t85;
        let t89 = t82 - t83;
        let t90 = t89 - t53;
        let t91 = t84 - dw4_z;
        let t92 = dw4_z + t84;
        let t93 = t82 + t83;
        let t94 = t85 + t88;
        let t95 = t86 + dw4_x;
        [
        t60, a4_x, a4_y, w4_x, w4_y, t76, t79, w4_z,
        dw4_z, t84, t85, t86, dw4_x, t88, t89, t90,
        t91, t92, t93, t94, t95,
    ]
    };
    // link 5: motion
    let [
        a5_z, a5_x, a6_z, w5_x, t119, t122, t125, w5_z,
        dw5_z, t130, t131, t132, dw5_x, dw5_y, t135, t136,
        t137, t138, t139, t140, t141,
    ] = {
        let t105 = a4_x + (k_L3 * t91 - k_A * t90);
        let a5_z = a4_y - (k_A * t92 + k_L3 * t93);
        let t107 = k_L3 * t95 - k_A * t94 - t60;
        let a5_x = c5 * t105 - s5 * t107;
        let a6_z = c5 * t107 + s5 * t105;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t119 = c5 * w4_z + s5 * w4_x;
        let t122 = c5 * t91 - s5 * t95;
        let t125 = c5 * t95 + s5 * t91;
        let w5_z = w4_y + dq5;
        let dw5_z = ddq5 - t88;
        let t128 = w5_x * w5_x;
        let t129 = w5_z * w5_z;
        let t130 = w5_x * t119;
        let t131 = w5_x * w5_z;
        let t132 = t119 * w5_z;
        let dw5_x = t125 - t132;
        let dw5_y = t122 - t131;
        let t135 = t128 - t129;
        let t136 = t135 - t93;
        let t137 = dw5_z + t130;
        let t138 = dw5_z - t130;
        let t139 = t128 + t129;
        let t140 = t131 - dw5_y;
        let t141 = dw5_x - t132;
        [
        a5_z, a5_x, a6_z, w5_x, t119, t122, t125, w5_z,
        dw5_z, t130, t131, t132, dw5_x, dw5_y, t135, t136,
        t137, t138, t139, t140, t141,
    ]
    };
    // link 6: motion
    let [
        a6_x, a6_y, w6_x, w6_y, t156, t159, w6_z, dw6_z,
        t164, t165, t166, dw6_x, dw6_y, t169, t170, t171,
        t172, t173, t174, t175,
    ] = {
        let a6_x = c6 * a5_x + s6 * a5_z;
        let a6_y = c6 * a5_z - s6 * a5_x;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t156 = c6 * t137 - s6 * t141;
        let t159 = c6 * t141 + s6 * t137;
        let w6_z = t119 + dq6;
        let dw6_z = ddq6 - dw5_y;
        let t162 = w6_x * w6_x;
        let t163 = w6_z * w6_z;
        let t164 = w6_x * w6_y;
        let t165 = w6_x * w6_z;
        let t166 = w6_y * w6_z;
        let dw6_x = t159 + t166;
        let dw6_y = t156 - t165;
        let t169 = t162 - t163;
        let t170 = t169 - t139;
        let t171 = t164 - dw6_z;
        let t172 = dw6_z + t164;
        let t173 = t162 + t163;
        let t174 = t165 - dw6_y;
        let t175 = t166 + dw6_x;
        [
        a6_x, a6_y, w6_x, w6_y, t156, t159, w6_z, dw6_z,
        t164, t165, t166, dw6_x, dw6_y, t169, t170, t171,
        t172, t173, t174, t175,
    ]
    };
    // link 7: motion
    let [
        t180, a7_x, a7_y, t196, t199, dw7_z, t204, t205,
        t206, dw7_x, t208, t209, t210, t211, t212, t213,
        t214, t215,
    ] = {
        let t179 = a6_x + k4 * t170;
        let t180 = a6_y + k4 * t172;
        let t181 = a6_z + k4 * t174;
        let a7_x = c7 * t179 + s7 * t181;
        let a7_y = c7 * t181 - s7 * t179;
        let w7_x = c7 * w6_x + s7 * w6_z;
        let w7_y = c7 * w6_z - s7 * w6_x;
        let t196 = c7 * t171 + s7 * t175;
        let t199 = s7 * t171 - c7 * t175;
        let w7_z = dq7 - w6_y;
        let dw7_z = ddq7 - dw6_y;
        let t202 = w7_x * w7_x;
        let t203 = w7_z * w7_z;
        let t204 = w7_x * w7_y;
        let t205 = w7_x * w7_z;
        let t206 = w7_y * w7_z;
        let dw7_x = t206 - t199;
        let t208 = t196 + t205;
        let t209 = t202 - t203;
        let t210 = t209 - t173;
        let t211 = t204 - dw7_z;
        let t212 = dw7_z + t204;
        let t213 = t202 + t203;
        let t214 = t205 + t208;
        let t215 = t206 + dw7_x;
        [
        t180, a7_x, a7_y, t196, t199, dw7_z, t204, t205,
        t206, dw7_x, t208, t209, t210, t211, t212, t213,
        t214, t215,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t283, t286, t289, t295, t296] = {
        let t237 = XZ7 * t199;
        let t238 = t206 * (ZZ7 - YY7) + XX7 * dw7_x - XY7 * t214 + XZ7 * t212;
        let t239 = t205 * (XX7 - ZZ7) - YY7 * t208 + XY7 * t215 - XZ7 * t209;
        let t240 = t204 * (YY7 - XX7) + ZZ7 * dw7_z + XY7 * (t210 + t213) - t237;
        let f7_x = M7 * a7_x + (MSX7 * t210 + MSY7 * t211 - MSZ7 * t196);
        let f7_y = M7 * a7_y + (MSZ7 * t199 + (MSX7 * t212 - MSY7 * t213));
        let f7_z = MSX7 * t214 + MSY7 * t215 - MSZ7 * t173 - M7 * t180;
        let n7_x = t238 + YZ7 * (t173 - t213) - (MSY7 * t180 + MSZ7 * a7_y);
        let n7_y = t239 - YZ7 * t211 + (MSZ7 * a7_x + MSX7 * t180);
        let n7_z = t240 - YZ7 * t196 + (MSX7 * a7_y - MSY7 * a7_x);
        let t283 = c7 * f7_x - s7 * f7_y;
        let t286 = s7 * f7_x + c7 * f7_y;
        let t289 = c7 * n7_x - s7 * n7_y;
        let t295 = s7 * n7_x + c7 * n7_y - k4 * f7_z;
        let t296 = n7_z + k4 * t286;
        [f7_z, n7_z, t283, t286, t289, t295, t296]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t370, t373, t376, t379] = {
        let t318 = XZ6 * t159;
        let t319 = t166 * (ZZ6 - YY6) + XX6 * dw6_x - XY6 * t174 + XZ6 * t172;
        let t320 = t165 * (XX6 - ZZ6) + YY6 * dw6_y + XY6 * t175 - XZ6 * t169;
        let t321 = t164 * (YY6 - XX6) + ZZ6 * dw6_z + XY6 * (t170 + t173) + t318;
        let f6_x = t283 + (M6 * a6_x + (MSZ6 * t156 + (MSX6 * t170 + MSY6 * t171)));
        let f6_y = M6 * a6_y + (MSX6 * t172 - MSY6 * t173 - MSZ6 * t159) - f7_z;
        let f6_z = t286 + (M6 * a6_z + (MSX6 * t174 + MSY6 * t175 - MSZ6 * t139));
        let n6_x = t289 + (t319 + YZ6 * (t139 - t173) + (MSY6 * a6_z - MSZ6 * a6_y));
        let n6_y = t320 - YZ6 * t171 + (MSZ6 * a6_x - MSX6 * a6_z) - t296;
        let n6_z = t295 + (t321 + YZ6 * t156 + (MSX6 * a6_y - MSY6 * a6_x));
        let t370 = c6 * f6_x - s6 * f6_y;
        let t373 = s6 * f6_x + c6 * f6_y;
        let t376 = c6 * n6_x - s6 * n6_y;
        let t379 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t370, t373, t376, t379]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t453, t456, t468, t469, t470] = {
        let t401 = XZ5 * t125;
        let t402 = XX5 * dw5_x - t132 * (ZZ5 - YY5) - XY5 * t140 + XZ5 * t138;
        let t403 = t131 * (XX5 - ZZ5) + YY5 * dw5_y + XY5 * t141 - XZ5 * t135;
        let t404 = ZZ5 * dw5_z - t130 * (YY5 - XX5) + XY5 * (t136 + t139) + t401;
        let f5_x = t370 + (M5 * a5_x + (MSZ5 * t122 + (MSX5 * t136 - MSY5 * t137)));
        let f5_y = MSX5 * t138 - MSY5 * t139 - MSZ5 * t125 - M5 * a6_z - f6_z;
        let f5_z = t373 + (M5 * a5_z + (MSX5 * t140 + MSY5 * t141 - MSZ5 * t93));
        let n5_x = t376 + (t402 + YZ5 * (t93 - t139) + (MSY5 * a5_z + MSZ5 * a6_z));
        let n5_y = t403 + YZ5 * t137 + (MSZ5 * a5_x - MSX5 * a5_z) - n6_z;
        let n5_z = t379 + (t404 + YZ5 * t122 - (MSX5 * a6_z + MSY5 * a5_x));
        let t453 = c5 * f5_x - s5 * f5_y;
        let t456 = s5 * f5_x + c5 * f5_y;
        let t468 = c5 * n5_x - s5 * n5_y - k_L3 * t456;
        let t469 = s5 * n5_x + c5 * n5_y + (k_L3 * t453 + k_A * f5_z);
        let t470 = n5_z - k_A * t456;
        [f5_z, n5_z, t453, t456, t468, t469, t470]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t544, t550, t556, t557] = {
        let t492 = XZ4 * t79;
        let t493 = t86 * (ZZ4 - YY4) + XX4 * dw4_x - XY4 * t94 + XZ4 * t92;
        let t494 = t85 * (XX4 - ZZ4) - YY4 * t88 + XY4 * t95 - XZ4 * t89;
        let t495 = t84 * (YY4 - XX4) + ZZ4 * dw4_z + XY4 * (t90 + t93) - t492;
        let f4_x = t453 + (M4 * a4_x + (MSX4 * t90 + MSY4 * t91 - MSZ4 * t76));
        let f4_y = f5_z + (M4 * a4_y + (MSZ4 * t79 + (MSX4 * t92 - MSY4 * t93)));
        let f4_z = MSX4 * t94 + MSY4 * t95 - MSZ4 * t53 - M4 * t60 - t456;
        let n4_x = t468 + (t493 + YZ4 * (t53 - t93) - (MSY4 * t60 + MSZ4 * a4_y));
        let n4_y = t470 + (t494 - YZ4 * t91 + (MSZ4 * a4_x + MSX4 * t60));
        let n4_z = t495 - YZ4 * t76 + (MSX4 * a4_y - MSY4 * a4_x) - t469;
        let t544 = c4 * f4_x - s4 * f4_y;
        let t550 = c4 * n4_x - s4 * n4_y;
        let t556 = s4 * n4_x + c4 * n4_y - k_A * f4_z;
        let t557 = n4_z + k_A * (s4 * f4_x + c4 * f4_y);
        [f4_z, n4_z, t544, t550, t556, t557]
    };
    // link 3: force and moment
    let [n3_z, t635, t636] = {
        let t579 = XZ3 * t39;
        let t580 = t46 * (ZZ3 - YY3) + XX3 * dw3_x - XY3 * t54 + XZ3 * t52;
        let t581 = t45 * (XX3 - ZZ3) + YY3 * dw3_y + XY3 * t55 - XZ3 * t49;
        let t582 = t44 * (YY3 - XX3) + ZZ3 * dw3_z + XY3 * (t50 + t53) - t579;
        let f3_x = t544 + (M3 * a3_x + (MSZ3 * t36 + (MSX3 * t50 + MSY3 * t51)));
        let f3_y = M3 * a3_y + (MSZ3 * t39 + (MSX3 * t52 - MSY3 * t53)) - f4_z;
        let n3_x = t550 + (t580 + YZ3 * (t15 - t53) - (MSY3 * t21 + MSZ3 * a3_y));
        let n3_y = t581 - YZ3 * t51 + (MSZ3 * a3_x + MSX3 * t21) - t557;
        let n3_z = t556 + (t582 + YZ3 * t36 + (MSX3 * a3_y - MSY3 * a3_x));
        let t635 = c3 * n3_x - s3 * n3_y - k_L2 * (s3 * f3_x + c3 * f3_y);
        let t636 = s3 * n3_x + c3 * n3_y + k_L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, t635, t636]
    };
    // link 2: force and moment
    let [t660, n2_z, t677] = {
        let t641 = s2 * (XX2 - YY2) + c2 * (XY2 + XY2);
        let t643 = c2 * t641 - XY2;
        let t646 = s2 * XZ2 + c2 * YZ2;
        let t659 = t8 * (s2 * YZ2 - c2 * XZ2) - ddq2 * t646;
        let t660 = t5 * t641 + YY2 * ddq1 + (t643 + t643) * (dq1 * dq2) + t659;
        let n2_x = t635 + MSZ2 * t2;
        let t673 = t636 + (MSY2 * t1 - MSX2 * t2);
        let n2_z = ZZ2 * ddq2 - ddq1 * t646 - t0 * t643 + t673;
        let t677 = s2 * n2_x - c2 * (n3_z + MSZ2 * t1);
        [t660, n2_z, t677]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t660 + (ZZ1 * ddq1 - t677);
        n1_z
    };
    // drives
    {
        let t716 = FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t717 = FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t718 = FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign());
        let t719 = FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign());
        let t720 = FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign());
        let t721 = FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign());
        let t722 = FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign());
        put(0, t716);
        put(1, t717);
        put(2, t718);
        put(3, t719);
        put(4, t720);
        put(5, t721);
        put(6, t722);
    }
}
