//! Torques from the base parameters.
//!
//! `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil
//! and Dombre, 9.6.
//!
//! 314 multiplications, 299 additions; 7, 7 of 7 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, GRAVITY, Trig, constants};

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
        ZZ1R, MSX2, MSY2R, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3R, MSY3R, XX3R, ZZ3R,
        XY3R, XZ3, YZ3, MSX4R, MSY4R, XX4R, ZZ4R, XY4R, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6R, MSY6R, XX6R, ZZ6R, XY6R, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7, FV1, FV2, FV3, FV4, FV5,
        FV6, FV7, FC1, FC2, FC3, FC4, FC5, FC6, FC7, FO1, FO2, FO3,
        FO4, FO5, FO6, FO7,
        ..] = *beta;
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
        t206, dw7_x, t209, t210, t211, t212, t213, t214,
        t215,
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
        let t209 = t202 - t203;
        let t210 = t209 - t173;
        let t211 = t204 - dw7_z;
        let t212 = dw7_z + t204;
        let t213 = t202 + t203;
        let t214 = t205 + (t196 + t205);
        let t215 = t206 + dw7_x;
        [
        t180, a7_x, a7_y, t196, t199, dw7_z, t204, t205,
        t206, dw7_x, t209, t210, t211, t212, t213, t214,
        t215,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t263, t266, t269, t275, t276] = {
        let t236 = ZZ7 * dw7_z - XX7R * t204 + XY7 * (t210 + t213) - XZ7 * t199;
        let t238 = YZ7 * (t173 - t213);
        let t241 = ZZ7 * t206 + XX7R * dw7_x - XY7 * t214 + XZ7 * t212 + t238;
        let t242 = t205 * (XX7R - ZZ7) + XY7 * t215 - XZ7 * t209 - YZ7 * t211;
        let f7_x = MSX7 * t210 + MSY7 * t211;
        let f7_y = MSX7 * t212 - MSY7 * t213;
        let f7_z = MSX7 * t214 + MSY7 * t215;
        let n7_x = t241 - MSY7 * t180;
        let n7_y = t242 + MSX7 * t180;
        let n7_z = t236 - YZ7 * t196 + (MSX7 * a7_y - MSY7 * a7_x);
        let t263 = c7 * f7_x - s7 * f7_y;
        let t266 = s7 * f7_x + c7 * f7_y;
        let t269 = c7 * n7_x - s7 * n7_y;
        let t275 = s7 * n7_x + c7 * n7_y - k4 * f7_z;
        let t276 = n7_z + k4 * t266;
        [f7_z, n7_z, t263, t266, t269, t275, t276]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t330, t333, t336, t339] = {
        let t297 = ZZ6R * dw6_z - XX6R * t164 + XY6R * (t170 + t173) + XZ6 * t159;
        let t299 = YZ6 * (t139 - t173);
        let t302 = ZZ6R * t166 + XX6R * dw6_x - XY6R * t174 + XZ6 * t172 + t299;
        let t303 = t165 * (XX6R - ZZ6R) + XY6R * t175 - XZ6 * t169 - YZ6 * t171;
        let f6_x = t263 + (MSX6R * t170 + MSY6R * t171);
        let f6_y = MSX6R * t172 - MSY6R * t173 - f7_z;
        let f6_z = t266 + (MSX6R * t174 + MSY6R * t175);
        let n6_x = t269 + (t302 + MSY6R * a6_z);
        let n6_y = t303 - MSX6R * a6_z - t276;
        let n6_z = t275 + (t297 + YZ6 * t156 + (MSX6R * a6_y - MSY6R * a6_x));
        let t330 = c6 * f6_x - s6 * f6_y;
        let t333 = s6 * f6_x + c6 * f6_y;
        let t336 = c6 * n6_x - s6 * n6_y;
        let t339 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t330, t333, t336, t339]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t393, t396, t408, t409, t410] = {
        let t360 = XX5R * t130 + ZZ5R * dw5_z + XY5 * (t136 + t139) + XZ5 * t125;
        let t362 = YZ5 * (t93 - t139);
        let t365 = XX5R * dw5_x - ZZ5R * t132 - XY5 * t140 + XZ5 * t138 + t362;
        let t366 = t131 * (XX5R - ZZ5R) + XY5 * t141 - XZ5 * t135 + YZ5 * t137;
        let f5_x = t330 + (MSX5 * t136 - MSY5R * t137);
        let f5_y = MSX5 * t138 - MSY5R * t139 - f6_z;
        let f5_z = t333 + (MSX5 * t140 + MSY5R * t141);
        let n5_x = t336 + (t365 + MSY5R * a5_z);
        let n5_y = t366 - MSX5 * a5_z - n6_z;
        let n5_z = t339 + (t360 + YZ5 * t122 - (MSX5 * a6_z + MSY5R * a5_x));
        let t393 = c5 * f5_x - s5 * f5_y;
        let t396 = s5 * f5_x + c5 * f5_y;
        let t408 = c5 * n5_x - s5 * n5_y - k_L3 * t396;
        let t409 = s5 * n5_x + c5 * n5_y + (k_L3 * t393 + k_A * f5_z);
        let t410 = n5_z - k_A * t396;
        [f5_z, n5_z, t393, t396, t408, t409, t410]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t464, t470, t476, t477] = {
        let t431 = ZZ4R * dw4_z - XX4R * t84 + XY4R * (t90 + t93) - XZ4 * t79;
        let t433 = YZ4 * (t53 - t93);
        let t436 = ZZ4R * t86 + XX4R * dw4_x - XY4R * t94 + XZ4 * t92 + t433;
        let t437 = t85 * (XX4R - ZZ4R) + XY4R * t95 - XZ4 * t89 - YZ4 * t91;
        let f4_x = t393 + (MSX4R * t90 + MSY4R * t91);
        let f4_y = f5_z + (MSX4R * t92 - MSY4R * t93);
        let f4_z = MSX4R * t94 + MSY4R * t95 - t396;
        let n4_x = t408 + (t436 - MSY4R * t60);
        let n4_y = t410 + (t437 + MSX4R * t60);
        let n4_z = t431 - YZ4 * t76 + (MSX4R * a4_y - MSY4R * a4_x) - t409;
        let t464 = c4 * f4_x - s4 * f4_y;
        let t470 = c4 * n4_x - s4 * n4_y;
        let t476 = s4 * n4_x + c4 * n4_y - k_A * f4_z;
        let t477 = n4_z + k_A * (s4 * f4_x + c4 * f4_y);
        [f4_z, n4_z, t464, t470, t476, t477]
    };
    // link 3: force and moment
    let [n3_z, n2_x, t540] = {
        let t498 = ZZ3R * dw3_z - XX3R * t44 + XY3R * (t50 + t53) - XZ3 * t39;
        let t500 = YZ3 * (t15 - t53);
        let t503 = ZZ3R * t46 + XX3R * dw3_x - XY3R * t54 + XZ3 * t52 + t500;
        let t504 = t45 * (XX3R - ZZ3R) + XY3R * t55 - XZ3 * t49 - YZ3 * t51;
        let f3_x = t464 + (MSX3R * t50 + MSY3R * t51);
        let f3_y = MSX3R * t52 - MSY3R * t53 - f4_z;
        let n3_x = t470 + (t503 - MSY3R * t21);
        let n3_y = t504 + MSX3R * t21 - t477;
        let n3_z = t476 + (t498 + YZ3 * t36 + (MSX3R * a3_y - MSY3R * a3_x));
        let n2_x = c3 * n3_x - s3 * n3_y - k_L2 * (s3 * f3_x + c3 * f3_y);
        let t540 = s3 * n3_x + c3 * n3_y + k_L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, n2_x, t540]
    };
    // link 2: force and moment
    let [t561, n2_z, t574] = {
        let t544 = s2 * XX2R + c2 * (XY2 + XY2);
        let t546 = c2 * t544 - XY2;
        let t549 = s2 * XZ2 + c2 * YZ2;
        let t560 = t8 * (s2 * YZ2 - c2 * XZ2) - ddq2 * t549;
        let t561 = t5 * t544 + (t546 + t546) * (dq1 * dq2) + t560;
        let t570 = t540 + (MSY2R * t1 - MSX2 * t2);
        let n2_z = ZZ2R * ddq2 - ddq1 * t549 - t0 * t546 + t570;
        let t574 = s2 * n2_x - c2 * n3_z;
        [t561, n2_z, t574]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t561 + (ZZ1R * ddq1 - t574);
        n1_z
    };
    // drives
    {
        let t613 = FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t614 = FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t615 = FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign());
        let t616 = FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign());
        let t617 = FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign());
        let t618 = FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign());
        let t619 = FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign());
        put(0, t613);
        put(1, t614);
        put(2, t615);
        put(3, t616);
        put(4, t617);
        put(5, t618);
        put(6, t619);
    }
}
