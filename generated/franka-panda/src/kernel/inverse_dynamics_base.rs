//! Torques from the base parameters.
//!
//! `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil and Dombre, 9.6.
//!
//! 313 multiplications, 307 additions; 7, 7 of 7 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, Trig};

/// Torques from the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE], out: &mut [S; 7]) {
    entries(trig, dq, ddq, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
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
        t210, dw7_x, t213, t214, t215, t216, t217, t218,
        t219,
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
        let t213 = t206 - t207;
        let t214 = t213 - t177;
        let t215 = t208 - dw7_z;
        let t216 = dw7_z + t208;
        let t217 = t206 + t207;
        let t218 = t209 + (t200 + t209);
        let t219 = t210 + dw7_x;
        [
        t190, a7_x, a7_y, t200, t203, dw7_z, t208, t209,
        t210, dw7_x, t213, t214, t215, t216, t217, t218,
        t219,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t267, t270, t273, t279, t280] = {
        let t240 = ZZ7 * dw7_z - XX7R * t208 + XY7 * (t214 + t217) - XZ7 * t203;
        let t242 = YZ7 * (t177 - t217);
        let t245 = ZZ7 * t210 + XX7R * dw7_x - XY7 * t218 + XZ7 * t216 + t242;
        let t246 = t209 * (XX7R - ZZ7) + XY7 * t219 - XZ7 * t213 - YZ7 * t215;
        let f7_x = MSX7 * t214 + MSY7 * t215;
        let f7_y = MSX7 * t216 - MSY7 * t217;
        let f7_z = MSX7 * t218 + MSY7 * t219;
        let n7_x = t245 - MSY7 * t190;
        let n7_y = t246 + MSX7 * t190;
        let n7_z = t240 - YZ7 * t200 + (MSX7 * a7_y - MSY7 * a7_x);
        let t267 = c7 * f7_x - s7 * f7_y;
        let t270 = s7 * f7_x + c7 * f7_y;
        let t273 = c7 * n7_x - s7 * n7_y;
        let t279 = s7 * n7_x + c7 * n7_y - k4 * f7_z;
        let t280 = n7_z + k4 * t270;
        [f7_z, n7_z, t267, t270, t273, t279, t280]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t334, t337, t340, t343] = {
        let t301 = ZZ6R * dw6_z - XX6R * t168 + XY6R * (t174 + t177) + XZ6 * t163;
        let t303 = YZ6 * (t143 - t177);
        let t306 = ZZ6R * t170 + XX6R * dw6_x - XY6R * t178 + XZ6 * t176 + t303;
        let t307 = t169 * (XX6R - ZZ6R) + XY6R * t179 - XZ6 * t173 - YZ6 * t175;
        let f6_x = t267 + (MSX6R * t174 + MSY6R * t175);
        let f6_y = MSX6R * t176 - MSY6R * t177 - f7_z;
        let f6_z = t270 + (MSX6R * t178 + MSY6R * t179);
        let n6_x = t273 + (t306 + MSY6R * a6_z);
        let n6_y = t307 - MSX6R * a6_z - t280;
        let n6_z = t279 + (t301 + YZ6 * t160 + (MSX6R * a6_y - MSY6R * a6_x));
        let t334 = c6 * f6_x - s6 * f6_y;
        let t337 = s6 * f6_x + c6 * f6_y;
        let t340 = c6 * n6_x - s6 * n6_y;
        let t343 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t334, t337, t340, t343]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t397, t400, t412, t413, t414] = {
        let t364 = XX5R * t134 + ZZ5R * dw5_z + XY5 * (t140 + t143) + XZ5 * t129;
        let t366 = YZ5 * (t97 - t143);
        let t369 = XX5R * dw5_x - ZZ5R * t136 - XY5 * t144 + XZ5 * t142 + t366;
        let t370 = t135 * (XX5R - ZZ5R) + XY5 * t145 - XZ5 * t139 + YZ5 * t141;
        let f5_x = t334 + (MSX5 * t140 - MSY5R * t141);
        let f5_y = MSX5 * t142 - MSY5R * t143 - f6_z;
        let f5_z = t337 + (MSX5 * t144 + MSY5R * t145);
        let n5_x = t340 + (t369 + MSY5R * a5_z);
        let n5_y = t370 - MSX5 * a5_z - n6_z;
        let n5_z = t343 + (t364 + YZ5 * t126 - (MSX5 * a6_z + MSY5R * a5_x));
        let t397 = c5 * f5_x - s5 * f5_y;
        let t400 = s5 * f5_x + c5 * f5_y;
        let t412 = c5 * n5_x - s5 * n5_y - L3 * t400;
        let t413 = s5 * n5_x + c5 * n5_y + (L3 * t397 + A * f5_z);
        let t414 = n5_z - A * t400;
        [f5_z, n5_z, t397, t400, t412, t413, t414]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t468, t474, t480, t481] = {
        let t435 = ZZ4R * dw4_z - XX4R * t88 + XY4R * (t94 + t97) - XZ4 * t83;
        let t437 = YZ4 * (t57 - t97);
        let t440 = ZZ4R * t90 + XX4R * dw4_x - XY4R * t98 + XZ4 * t96 + t437;
        let t441 = t89 * (XX4R - ZZ4R) + XY4R * t99 - XZ4 * t93 - YZ4 * t95;
        let f4_x = t397 + (MSX4R * t94 + MSY4R * t95);
        let f4_y = f5_z + (MSX4R * t96 - MSY4R * t97);
        let f4_z = MSX4R * t98 + MSY4R * t99 - t400;
        let n4_x = t412 + (t440 - MSY4R * t70);
        let n4_y = t414 + (t441 + MSX4R * t70);
        let n4_z = t435 - YZ4 * t80 + (MSX4R * a4_y - MSY4R * a4_x) - t413;
        let t468 = c4 * f4_x - s4 * f4_y;
        let t474 = c4 * n4_x - s4 * n4_y;
        let t480 = s4 * n4_x + c4 * n4_y - A * f4_z;
        let t481 = n4_z + A * (s4 * f4_x + c4 * f4_y);
        [f4_z, n4_z, t468, t474, t480, t481]
    };
    // link 3: force and moment
    let [n3_z, t543, t544] = {
        let t502 = ZZ3R * dw3_z - XX3R * t48 + XY3R * (t54 + t57) - XZ3 * t43;
        let t504 = YZ3 * (t18 - t57);
        let t507 = ZZ3R * t50 + XX3R * dw3_x - XY3R * t58 + XZ3 * t56 + t504;
        let t508 = t49 * (XX3R - ZZ3R) + XY3R * t59 - XZ3 * t53 - YZ3 * t55;
        let f3_x = t468 + (MSX3R * t54 + MSY3R * t55);
        let f3_y = MSX3R * t56 - MSY3R * t57 - f4_z;
        let n3_x = t474 + (t507 - MSY3R * t31);
        let n3_y = t508 + MSX3R * t31 - t481;
        let n3_z = t480 + (t502 + YZ3 * t40 + (MSX3R * a3_y - MSY3R * a3_x));
        let t543 = c3 * n3_x - s3 * n3_y - L2 * (s3 * f3_x + c3 * f3_y);
        let t544 = s3 * n3_x + c3 * n3_y + L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, t543, t544]
    };
    // link 2: force and moment
    let [n2_z, t582] = {
        let t565 = ZZ2R * ddq2 - XX2R * t9 + XY2 * (t15 + t18) - XZ2 * t3;
        let t567 = YZ2 * (t0 - t18);
        let t570 = XY2 * t19 - (ZZ2R * t11 + XX2R * t12) + XZ2 * t17 + t567;
        let t571 = t10 * (XX2R - ZZ2R) + XY2 * t20 + XZ2 * t14 + YZ2 * t16;
        let n2_x = t543 + t570;
        let n2_z = t544 + (t565 - YZ2 * t4 + (MSY2R * t5 - MSX2 * t6));
        let t582 = s2 * n2_x - c2 * (n3_z + t571);
        [n2_z, t582]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = ZZ1R * ddq1 - t582;
        n1_z
    };
    // drives
    {
        let t620 = FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t621 = FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t622 = FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign());
        let t623 = FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign());
        let t624 = FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign());
        let t625 = FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign());
        let t626 = FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign());
        put(0, t620);
        put(1, t621);
        put(2, t622);
        put(3, t623);
        put(4, t624);
        put(5, t625);
        put(6, t626);
    }
}
