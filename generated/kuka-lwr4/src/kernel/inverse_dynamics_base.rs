//! Torques from the base parameters.
//!
//! `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil and Dombre, 9.6.
//!
//! 296 multiplications, 284 additions; 7, 7 of 7 structurally nonzero.

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
        ZZ1R, MSX2, MSY2R, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3, MSY3R, XX3R, ZZ3R,
        XY3, XZ3, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6R, XX6R, ZZ6R, XY6, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7, FV1, FV2, FV3, FV4, FV5,
        FV6, FV7, FC1, FC2, FC3, FC4, FC5, FC6, FC7,
        ..] = *beta;
    let L2 = S::constant(0.4);
    let L3 = S::constant(0.39);
    let k0 = S::constant(9.81);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        w2_x, w2_y, t3, t4, a2_x, a2_y, t9, t10,
        t11, dw2_x, dw2_y, t14, t15, t16, t17, t18,
        t19, t20,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t3 = s2 * ddq1;
        let t4 = c2 * ddq1;
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let t7 = w2_x * w2_x;
        let t8 = dq2 * dq2;
        let t9 = w2_x * w2_y;
        let t10 = dq2 * w2_x;
        let t11 = dq2 * w2_y;
        let dw2_x = t3 + t11;
        let dw2_y = t4 - t10;
        let t14 = t7 - t8;
        let t15 = t14 - t0;
        let t16 = t9 - ddq2;
        let t17 = ddq2 + t9;
        let t18 = t7 + t8;
        let t19 = t10 - dw2_y;
        let t20 = t11 + dw2_x;
        [
        w2_x, w2_y, t3, t4, a2_x, a2_y, t9, t10,
        t11, dw2_x, dw2_y, t14, t15, t16, t17, t18,
        t19, t20,
    ]
    };
    // link 3: motion
    let [
        w3_x, t26, a3_z, a3_x, t37, t40, t43, w3_z,
        dw3_z, t48, t49, t50, dw3_x, dw3_y, t53, t54,
        t55, t56, t57, t58, t59,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t26 = c3 * dq2 + s3 * w2_x;
        let t29 = L2 * t20;
        let t30 = a2_x + L2 * t16;
        let a3_z = a2_y - L2 * t18;
        let a3_x = c3 * t30 - s3 * t29;
        let t37 = c3 * t29 + s3 * t30;
        let t40 = c3 * t16 - s3 * t20;
        let t43 = c3 * t20 + s3 * t16;
        let w3_z = w2_y + dq3;
        let dw3_z = dw2_y + ddq3;
        let t46 = w3_x * w3_x;
        let t47 = w3_z * w3_z;
        let t48 = w3_x * t26;
        let t49 = w3_x * w3_z;
        let t50 = t26 * w3_z;
        let dw3_x = t43 - t50;
        let dw3_y = t40 - t49;
        let t53 = t46 - t47;
        let t54 = t53 - t18;
        let t55 = dw3_z + t48;
        let t56 = dw3_z - t48;
        let t57 = t46 + t47;
        let t58 = t49 - dw3_y;
        let t59 = dw3_x - t50;
        [
        w3_x, t26, a3_z, a3_x, t37, t40, t43, w3_z,
        dw3_z, t48, t49, t50, dw3_x, dw3_y, t53, t54,
        t55, t56, t57, t58, t59,
    ]
    };
    // link 4: motion
    let [
        w4_x, t65, a4_x, t71, t74, t77, w4_z, dw4_z,
        t82, t83, t84, t85, t86, t87, t88, t89,
        t90, t91, t92, t93,
    ] = {
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t65 = c4 * w3_z + s4 * w3_x;
        let a4_x = c4 * a3_x - s4 * a3_z;
        let t71 = c4 * a3_z + s4 * a3_x;
        let t74 = c4 * t55 + s4 * t59;
        let t77 = s4 * t55 - c4 * t59;
        let w4_z = dq4 - t26;
        let dw4_z = dw3_y + ddq4;
        let t80 = w4_x * w4_x;
        let t81 = w4_z * w4_z;
        let t82 = w4_x * t65;
        let t83 = w4_x * w4_z;
        let t84 = t65 * w4_z;
        let t85 = t77 + t84;
        let t86 = t74 + t83;
        let t87 = t80 - t81;
        let t88 = t87 - t57;
        let t89 = dw4_z + t82;
        let t90 = dw4_z - t82;
        let t91 = t80 + t81;
        let t92 = t83 + t86;
        let t93 = t84 + t85;
        [
        w4_x, t65, a4_x, t71, t74, t77, w4_z, dw4_z,
        t82, t83, t84, t85, t86, t87, t88, t89,
        t90, t91, t92, t93,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t104, a5_x, a5_y, t114, t117, w5_z,
        dw5_z, t122, t123, t124, dw5_x, dw5_y, t127, t128,
        t129, t130, t131, t132, t133,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t103 = a4_x + L3 * t89;
        let t104 = L3 * t91 - t71;
        let t105 = L3 * t93 - t37;
        let a5_x = c5 * t103 + s5 * t105;
        let a5_y = c5 * t105 - s5 * t103;
        let t114 = c5 * t89 + s5 * t93;
        let t117 = c5 * t93 - s5 * t89;
        let w5_z = t65 + dq5;
        let dw5_z = t86 + ddq5;
        let t120 = w5_x * w5_x;
        let t121 = w5_z * w5_z;
        let t122 = w5_x * w5_y;
        let t123 = w5_x * w5_z;
        let t124 = w5_y * w5_z;
        let dw5_x = t124 - t117;
        let dw5_y = t114 - t123;
        let t127 = t120 - t121;
        let t128 = t127 - t91;
        let t129 = t122 - dw5_z;
        let t130 = dw5_z + t122;
        let t131 = t120 + t121;
        let t132 = t123 - dw5_y;
        let t133 = t124 + dw5_x;
        [
        w5_x, w5_y, t104, a5_x, a5_y, t114, t117, w5_z,
        dw5_z, t122, t123, t124, dw5_x, dw5_y, t127, t128,
        t129, t130, t131, t132, t133,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, a6_x, t145, t148, t151, w6_z, dw6_z,
        t156, t157, t158, dw6_x, t160, t161, t162, t163,
        t164, t165, t166, t167,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let a6_x = c6 * a5_x - s6 * t104;
        let t145 = c6 * t104 + s6 * a5_x;
        let t148 = c6 * t129 + s6 * t133;
        let t151 = s6 * t129 - c6 * t133;
        let w6_z = dq6 - w5_y;
        let dw6_z = ddq6 - dw5_y;
        let t154 = w6_x * w6_x;
        let t155 = w6_z * w6_z;
        let t156 = w6_x * w6_y;
        let t157 = w6_x * w6_z;
        let t158 = w6_y * w6_z;
        let dw6_x = t158 - t151;
        let t160 = t148 + t157;
        let t161 = t154 - t155;
        let t162 = t161 - t131;
        let t163 = t156 - dw6_z;
        let t164 = dw6_z + t156;
        let t165 = t154 + t155;
        let t166 = t157 + t160;
        let t167 = t158 + dw6_x;
        [
        w6_x, w6_y, a6_x, t145, t148, t151, w6_z, dw6_z,
        t156, t157, t158, dw6_x, t160, t161, t162, t163,
        t164, t165, t166, t167,
    ]
    };
    // link 7: motion
    let [
        a7_x, a7_y, t182, t185, dw7_z, t190, t191, t192,
        dw7_x, t195, t196, t197, t198, t199, t200, t201,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t173 = c7 * w6_z + s7 * w6_x;
        let a7_x = c7 * a6_x + s7 * a5_y;
        let a7_y = c7 * a5_y - s7 * a6_x;
        let t182 = c7 * t163 - s7 * t167;
        let t185 = c7 * t167 + s7 * t163;
        let w7_z = w6_y + dq7;
        let dw7_z = ddq7 - t160;
        let t188 = w7_x * w7_x;
        let t189 = w7_z * w7_z;
        let t190 = w7_x * t173;
        let t191 = w7_x * w7_z;
        let t192 = t173 * w7_z;
        let dw7_x = t185 - t192;
        let dw7_y = t182 - t191;
        let t195 = t188 - t189;
        let t196 = t195 - t165;
        let t197 = dw7_z + t190;
        let t198 = dw7_z - t190;
        let t199 = t188 + t189;
        let t200 = t191 - dw7_y;
        let t201 = dw7_x - t192;
        [
        a7_x, a7_y, t182, t185, dw7_z, t190, t191, t192,
        dw7_x, t195, t196, t197, t198, t199, t200, t201,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t249, t252, t255, t258] = {
        let t222 = XX7R * t190 + ZZ7 * dw7_z + XY7 * (t196 + t199) + XZ7 * t185;
        let t224 = YZ7 * (t165 - t199);
        let t227 = XX7R * dw7_x - ZZ7 * t192 - XY7 * t200 + XZ7 * t198 + t224;
        let t228 = t191 * (XX7R - ZZ7) + XY7 * t201 - XZ7 * t195 + YZ7 * t197;
        let f7_x = MSX7 * t196 - MSY7 * t197;
        let f7_y = MSX7 * t198 - MSY7 * t199;
        let f7_z = MSX7 * t200 + MSY7 * t201;
        let n7_x = t227 - MSY7 * t145;
        let n7_y = t228 + MSX7 * t145;
        let n7_z = t222 + YZ7 * t182 + (MSX7 * a7_y - MSY7 * a7_x);
        let t249 = c7 * f7_x - s7 * f7_y;
        let t252 = s7 * f7_x + c7 * f7_y;
        let t255 = c7 * n7_x - s7 * n7_y;
        let t258 = s7 * n7_x + c7 * n7_y;
        [f7_z, n7_z, t249, t252, t255, t258]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t312, t315, t318, t321] = {
        let t279 = ZZ6R * dw6_z - XX6R * t156 + XY6 * (t162 + t165) - XZ6 * t151;
        let t281 = YZ6 * (t131 - t165);
        let t284 = ZZ6R * t158 + XX6R * dw6_x - XY6 * t166 + XZ6 * t164 + t281;
        let t285 = t157 * (XX6R - ZZ6R) + XY6 * t167 - XZ6 * t161 - YZ6 * t163;
        let f6_x = t249 + (MSX6 * t162 + MSY6R * t163);
        let f6_y = f7_z + (MSX6 * t164 - MSY6R * t165);
        let f6_z = MSX6 * t166 + MSY6R * t167 - t252;
        let n6_x = t255 + (t284 - MSY6R * a5_y);
        let n6_y = n7_z + (t285 + MSX6 * a5_y);
        let n6_z = t279 - YZ6 * t148 - (MSX6 * t145 + MSY6R * a6_x) - t258;
        let t312 = c6 * f6_x - s6 * f6_y;
        let t315 = s6 * f6_x + c6 * f6_y;
        let t318 = c6 * n6_x - s6 * n6_y;
        let t321 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t312, t315, t318, t321]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t375, t378, t387, t388] = {
        let t342 = ZZ5R * dw5_z - XX5R * t122 + XY5 * (t128 + t131) - XZ5 * t117;
        let t344 = YZ5 * (t91 - t131);
        let t347 = ZZ5R * t124 + XX5R * dw5_x - XY5 * t132 + XZ5 * t130 + t344;
        let t348 = t123 * (XX5R - ZZ5R) + XY5 * t133 - XZ5 * t127 - YZ5 * t129;
        let f5_x = t312 + (MSX5 * t128 + MSY5R * t129);
        let f5_y = MSX5 * t130 - MSY5R * t131 - f6_z;
        let f5_z = t315 + (MSX5 * t132 + MSY5R * t133);
        let n5_x = t318 + (t347 - MSY5R * t104);
        let n5_y = t348 + MSX5 * t104 - n6_z;
        let n5_z = t321 + (t342 + YZ5 * t114 + (MSX5 * a5_y - MSY5R * a5_x));
        let t375 = c5 * f5_x - s5 * f5_y;
        let t378 = s5 * f5_x + c5 * f5_y;
        let t387 = c5 * n5_x - s5 * n5_y - L3 * t378;
        let t388 = s5 * n5_x + c5 * n5_y + L3 * t375;
        [f5_z, n5_z, t375, t378, t387, t388]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t442, t445, t448] = {
        let t409 = XX4R * t82 + ZZ4R * dw4_z + XY4 * (t88 + t91) - XZ4 * t77;
        let t411 = YZ4 * (t57 - t91);
        let t414 = XZ4 * t90 - (ZZ4R * t84 + XX4R * t85 + XY4 * t92) + t411;
        let t415 = t83 * (XX4R - ZZ4R) - XY4 * t93 - XZ4 * t87 + YZ4 * t89;
        let f4_x = t375 + (MSX4 * t88 - MSY4R * t89);
        let f4_y = MSX4 * t90 - MSY4R * t91 - f5_z;
        let f4_z = t378 + (MSX4 * t92 - MSY4R * t93);
        let n4_x = t387 + (t414 - MSY4R * t37);
        let n4_y = t415 + MSX4 * t37 - n5_z;
        let n4_z = t388 + (t409 - YZ4 * t74 - (MSX4 * t71 + MSY4R * a4_x));
        let t442 = c4 * f4_x - s4 * f4_y;
        let t445 = c4 * n4_x - s4 * n4_y;
        let t448 = s4 * n4_x + c4 * n4_y;
        [f4_z, n4_z, t442, t445, t448]
    };
    // link 3: force and moment
    let [n3_z, t510, t511] = {
        let t469 = XX3R * t48 + ZZ3R * dw3_z + XY3 * (t54 + t57) + XZ3 * t43;
        let t471 = YZ3 * (t18 - t57);
        let t474 = XX3R * dw3_x - ZZ3R * t50 - XY3 * t58 + XZ3 * t56 + t471;
        let t475 = t49 * (XX3R - ZZ3R) + XY3 * t59 - XZ3 * t53 + YZ3 * t55;
        let f3_x = t442 + (MSX3 * t54 - MSY3R * t55);
        let f3_y = f4_z + (MSX3 * t56 - MSY3R * t57);
        let n3_x = t445 + (t474 + MSY3R * a3_z);
        let n3_y = n4_z + (t475 - MSX3 * a3_z);
        let n3_z = t469 + YZ3 * t40 - (MSX3 * t37 + MSY3R * a3_x) - t448;
        let t510 = c3 * n3_x - s3 * n3_y - L2 * (s3 * f3_x + c3 * f3_y);
        let t511 = s3 * n3_x + c3 * n3_y + L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, t510, t511]
    };
    // link 2: force and moment
    let [n2_z, t549] = {
        let t532 = ZZ2R * ddq2 - XX2R * t9 + XY2 * (t15 + t18) + XZ2 * t3;
        let t534 = YZ2 * (t0 - t18);
        let t537 = ZZ2R * t11 + XX2R * dw2_x - XY2 * t19 + XZ2 * t17 + t534;
        let t538 = t10 * (XX2R - ZZ2R) + XY2 * t20 - XZ2 * t14 - YZ2 * t16;
        let n2_x = t510 + t537;
        let n2_y = n3_z + t538;
        let n2_z = t532 + YZ2 * t4 + (MSX2 * a2_y - MSY2R * a2_x) - t511;
        let t549 = s2 * n2_x + c2 * n2_y;
        [n2_z, t549]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t549 + ZZ1R * ddq1;
        n1_z
    };
    // drives
    {
        let t568 = n1_z + FV1 * dq1 + FC1 * dq1.sign();
        let t571 = n2_z + FV2 * dq2 + FC2 * dq2.sign();
        let t574 = n3_z + FV3 * dq3 + FC3 * dq3.sign();
        let t577 = n4_z + FV4 * dq4 + FC4 * dq4.sign();
        let t580 = n5_z + FV5 * dq5 + FC5 * dq5.sign();
        let t583 = n6_z + FV6 * dq6 + FC6 * dq6.sign();
        let t586 = n7_z + FV7 * dq7 + FC7 * dq7.sign();
        put(0, t568);
        put(1, t571);
        put(2, t574);
        put(3, t577);
        put(4, t580);
        put(5, t583);
        put(6, t586);
    }
}
