//! Torques from the base parameters.
//!
//! `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil
//! and Dombre, 9.6.
//!
//! 297 multiplications, 276 additions; 7, 7 of 7 structurally nonzero.

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
        ZZ1R, MSX2, MSY2R, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3, MSY3R, XX3R, ZZ3R,
        XY3, XZ3, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6R, XX6R, ZZ6R, XY6, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7, FV1, FV2, FV3, FV4, FV5,
        FV6, FV7, FC1, FC2, FC3, FC4, FC5, FC6, FC7,
        ..] = *beta;
    let k0 = S::constant(-GRAVITY[2]);
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        a2_x, a2_y, w2_x, w2_y, t5, t8, dw2_y, t14,
        t15, t16,
    ] = {
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t5 = s2 * ddq1;
        let t8 = dq2 * dq2;
        let t11 = dq2 * w2_y;
        let dw2_x = t5 + t11;
        let dw2_y = c2 * ddq1 - dq2 * w2_x;
        let t14 = w2_x * w2_y - ddq2;
        let t15 = w2_x * w2_x + t8;
        let t16 = t11 + dw2_x;
        [
        a2_x, a2_y, w2_x, w2_y, t5, t8, dw2_y, t14,
        t15, t16,
    ]
    };
    // link 3: motion
    let [
        a3_z, a3_x, t27, w3_x, t33, t36, t39, w3_z,
        dw3_z, t44, t45, t46, dw3_x, dw3_y, t49, t50,
        t51, t52, t53, t54, t55,
    ] = {
        let t19 = k_L2 * t16;
        let t20 = a2_x + k_L2 * t14;
        let a3_z = a2_y - k_L2 * t15;
        let a3_x = c3 * t20 - s3 * t19;
        let t27 = c3 * t19 + s3 * t20;
        let w3_x = c3 * w2_x - s3 * dq2;
        let t33 = c3 * dq2 + s3 * w2_x;
        let t36 = c3 * t14 - s3 * t16;
        let t39 = c3 * t16 + s3 * t14;
        let w3_z = w2_y + dq3;
        let dw3_z = dw2_y + ddq3;
        let t42 = w3_x * w3_x;
        let t43 = w3_z * w3_z;
        let t44 = w3_x * t33;
        let t45 = w3_x * w3_z;
        let t46 = t33 * w3_z;
        let dw3_x = t39 - t46;
        let dw3_y = t36 - t45;
        let t49 = t42 - t43;
        let t50 = t49 - t15;
        let t51 = dw3_z + t44;
        let t52 = dw3_z - t44;
        let t53 = t42 + t43;
        let t54 = t45 - dw3_y;
        let t55 = dw3_x - t46;
        [
        a3_z, a3_x, t27, w3_x, t33, t36, t39, w3_z,
        dw3_z, t44, t45, t46, dw3_x, dw3_y, t49, t50,
        t51, t52, t53, t54, t55,
    ]
    };
    // link 4: motion
    let [
        a4_x, t61, w4_x, t67, t70, t73, w4_z, dw4_z,
        t78, t79, t80, t81, t82, t83, t84, t85,
        t86, t87, t88, t89,
    ] = {
        let a4_x = c4 * a3_x - s4 * a3_z;
        let t61 = c4 * a3_z + s4 * a3_x;
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t67 = c4 * w3_z + s4 * w3_x;
        let t70 = c4 * t51 + s4 * t55;
        let t73 = s4 * t51 - c4 * t55;
        let w4_z = dq4 - t33;
        let dw4_z = dw3_y + ddq4;
        let t76 = w4_x * w4_x;
        let t77 = w4_z * w4_z;
        let t78 = w4_x * t67;
        let t79 = w4_x * w4_z;
        let t80 = t67 * w4_z;
        let t81 = t73 + t80;
        let t82 = t70 + t79;
        let t83 = t76 - t77;
        let t84 = t83 - t53;
        let t85 = dw4_z + t78;
        let t86 = dw4_z - t78;
        let t87 = t76 + t77;
        let t88 = t79 + t82;
        let t89 = t80 + t81;
        [
        a4_x, t61, w4_x, t67, t70, t73, w4_z, dw4_z,
        t78, t79, t80, t81, t82, t83, t84, t85,
        t86, t87, t88, t89,
    ]
    };
    // link 5: motion
    let [
        t94, a5_x, a5_y, w5_x, w5_y, t110, t113, w5_z,
        dw5_z, t118, t119, t120, dw5_x, dw5_y, t123, t124,
        t125, t126, t127, t128, t129,
    ] = {
        let t93 = a4_x + k_L3 * t85;
        let t94 = k_L3 * t87 - t61;
        let t95 = k_L3 * t89 - t27;
        let a5_x = c5 * t93 + s5 * t95;
        let a5_y = c5 * t95 - s5 * t93;
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t110 = c5 * t85 + s5 * t89;
        let t113 = c5 * t89 - s5 * t85;
        let w5_z = t67 + dq5;
        let dw5_z = t82 + ddq5;
        let t116 = w5_x * w5_x;
        let t117 = w5_z * w5_z;
        let t118 = w5_x * w5_y;
        let t119 = w5_x * w5_z;
        let t120 = w5_y * w5_z;
        let dw5_x = t120 - t113;
        let dw5_y = t110 - t119;
        let t123 = t116 - t117;
        let t124 = t123 - t87;
        let t125 = t118 - dw5_z;
        let t126 = dw5_z + t118;
        let t127 = t116 + t117;
        let t128 = t119 - dw5_y;
        let t129 = t120 + dw5_x;
        [
        t94, a5_x, a5_y, w5_x, w5_y, t110, t113, w5_z,
        dw5_z, t118, t119, t120, dw5_x, dw5_y, t123, t124,
        t125, t126, t127, t128, t129,
    ]
    };
    // link 6: motion
    let [
        a6_x, t135, w6_x, w6_y, t144, t147, w6_z, dw6_z,
        t152, t153, t154, dw6_x, t156, t157, t158, t159,
        t160, t161, t162, t163,
    ] = {
        let a6_x = c6 * a5_x - s6 * t94;
        let t135 = c6 * t94 + s6 * a5_x;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t144 = c6 * t125 + s6 * t129;
        let t147 = s6 * t125 - c6 * t129;
        let w6_z = dq6 - w5_y;
        let dw6_z = ddq6 - dw5_y;
        let t150 = w6_x * w6_x;
        let t151 = w6_z * w6_z;
        let t152 = w6_x * w6_y;
        let t153 = w6_x * w6_z;
        let t154 = w6_y * w6_z;
        let dw6_x = t154 - t147;
        let t156 = t144 + t153;
        let t157 = t150 - t151;
        let t158 = t157 - t127;
        let t159 = t152 - dw6_z;
        let t160 = dw6_z + t152;
        let t161 = t150 + t151;
        let t162 = t153 + t156;
        let t163 = t154 + dw6_x;
        [
        a6_x, t135, w6_x, w6_y, t144, t147, w6_z, dw6_z,
        t152, t153, t154, dw6_x, t156, t157, t158, t159,
        t160, t161, t162, t163,
    ]
    };
    // link 7: motion
    let [
        a7_x, a7_y, t178, t181, dw7_z, t186, t187, t188,
        dw7_x, t191, t192, t193, t194, t195, t196, t197,
    ] = {
        let a7_x = c7 * a6_x + s7 * a5_y;
        let a7_y = c7 * a5_y - s7 * a6_x;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t175 = c7 * w6_z + s7 * w6_x;
        let t178 = c7 * t159 - s7 * t163;
        let t181 = c7 * t163 + s7 * t159;
        let w7_z = w6_y + dq7;
        let dw7_z = ddq7 - t156;
        let t184 = w7_x * w7_x;
        let t185 = w7_z * w7_z;
        let t186 = w7_x * t175;
        let t187 = w7_x * w7_z;
        let t188 = t175 * w7_z;
        let dw7_x = t181 - t188;
        let dw7_y = t178 - t187;
        let t191 = t184 - t185;
        let t192 = t191 - t161;
        let t193 = dw7_z + t186;
        let t194 = dw7_z - t186;
        let t195 = t184 + t185;
        let t196 = t187 - dw7_y;
        let t197 = dw7_x - t188;
        [
        a7_x, a7_y, t178, t181, dw7_z, t186, t187, t188,
        dw7_x, t191, t192, t193, t194, t195, t196, t197,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t245, t248, t251, t254] = {
        let t218 = XX7R * t186 + ZZ7 * dw7_z + XY7 * (t192 + t195) + XZ7 * t181;
        let t220 = YZ7 * (t161 - t195);
        let t223 = XX7R * dw7_x - ZZ7 * t188 - XY7 * t196 + XZ7 * t194 + t220;
        let t224 = t187 * (XX7R - ZZ7) + XY7 * t197 - XZ7 * t191 + YZ7 * t193;
        let f7_x = MSX7 * t192 - MSY7 * t193;
        let f7_y = MSX7 * t194 - MSY7 * t195;
        let f7_z = MSX7 * t196 + MSY7 * t197;
        let n7_x = t223 - MSY7 * t135;
        let n7_y = t224 + MSX7 * t135;
        let n7_z = t218 + YZ7 * t178 + (MSX7 * a7_y - MSY7 * a7_x);
        let t245 = c7 * f7_x - s7 * f7_y;
        let t248 = s7 * f7_x + c7 * f7_y;
        let t251 = c7 * n7_x - s7 * n7_y;
        let t254 = s7 * n7_x + c7 * n7_y;
        [f7_z, n7_z, t245, t248, t251, t254]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t308, t311, t314, t317] = {
        let t275 = ZZ6R * dw6_z - XX6R * t152 + XY6 * (t158 + t161) - XZ6 * t147;
        let t277 = YZ6 * (t127 - t161);
        let t280 = ZZ6R * t154 + XX6R * dw6_x - XY6 * t162 + XZ6 * t160 + t277;
        let t281 = t153 * (XX6R - ZZ6R) + XY6 * t163 - XZ6 * t157 - YZ6 * t159;
        let f6_x = t245 + (MSX6 * t158 + MSY6R * t159);
        let f6_y = f7_z + (MSX6 * t160 - MSY6R * t161);
        let f6_z = MSX6 * t162 + MSY6R * t163 - t248;
        let n6_x = t251 + (t280 - MSY6R * a5_y);
        let n6_y = n7_z + (t281 + MSX6 * a5_y);
        let n6_z = t275 - YZ6 * t144 - (MSX6 * t135 + MSY6R * a6_x) - t254;
        let t308 = c6 * f6_x - s6 * f6_y;
        let t311 = s6 * f6_x + c6 * f6_y;
        let t314 = c6 * n6_x - s6 * n6_y;
        let t317 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t308, t311, t314, t317]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t371, t374, t383, t384] = {
        let t338 = ZZ5R * dw5_z - XX5R * t118 + XY5 * (t124 + t127) - XZ5 * t113;
        let t340 = YZ5 * (t87 - t127);
        let t343 = ZZ5R * t120 + XX5R * dw5_x - XY5 * t128 + XZ5 * t126 + t340;
        let t344 = t119 * (XX5R - ZZ5R) + XY5 * t129 - XZ5 * t123 - YZ5 * t125;
        let f5_x = t308 + (MSX5 * t124 + MSY5R * t125);
        let f5_y = MSX5 * t126 - MSY5R * t127 - f6_z;
        let f5_z = t311 + (MSX5 * t128 + MSY5R * t129);
        let n5_x = t314 + (t343 - MSY5R * t94);
        let n5_y = t344 + MSX5 * t94 - n6_z;
        let n5_z = t317 + (t338 + YZ5 * t110 + (MSX5 * a5_y - MSY5R * a5_x));
        let t371 = c5 * f5_x - s5 * f5_y;
        let t374 = s5 * f5_x + c5 * f5_y;
        let t383 = c5 * n5_x - s5 * n5_y - k_L3 * t374;
        let t384 = s5 * n5_x + c5 * n5_y + k_L3 * t371;
        [f5_z, n5_z, t371, t374, t383, t384]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t438, t441, t444] = {
        let t405 = XX4R * t78 + ZZ4R * dw4_z + XY4 * (t84 + t87) - XZ4 * t73;
        let t407 = YZ4 * (t53 - t87);
        let t410 = XZ4 * t86 - (ZZ4R * t80 + XX4R * t81 + XY4 * t88) + t407;
        let t411 = t79 * (XX4R - ZZ4R) - XY4 * t89 - XZ4 * t83 + YZ4 * t85;
        let f4_x = t371 + (MSX4 * t84 - MSY4R * t85);
        let f4_y = MSX4 * t86 - MSY4R * t87 - f5_z;
        let f4_z = t374 + (MSX4 * t88 - MSY4R * t89);
        let n4_x = t383 + (t410 - MSY4R * t27);
        let n4_y = t411 + MSX4 * t27 - n5_z;
        let n4_z = t384 + (t405 - YZ4 * t70 - (MSX4 * t61 + MSY4R * a4_x));
        let t438 = c4 * f4_x - s4 * f4_y;
        let t441 = c4 * n4_x - s4 * n4_y;
        let t444 = s4 * n4_x + c4 * n4_y;
        [f4_z, n4_z, t438, t441, t444]
    };
    // link 3: force and moment
    let [n3_z, n2_x, t507] = {
        let t465 = XX3R * t44 + ZZ3R * dw3_z + XY3 * (t50 + t53) + XZ3 * t39;
        let t467 = YZ3 * (t15 - t53);
        let t470 = XX3R * dw3_x - ZZ3R * t46 - XY3 * t54 + XZ3 * t52 + t467;
        let t471 = t45 * (XX3R - ZZ3R) + XY3 * t55 - XZ3 * t49 + YZ3 * t51;
        let f3_x = t438 + (MSX3 * t50 - MSY3R * t51);
        let f3_y = f4_z + (MSX3 * t52 - MSY3R * t53);
        let n3_x = t441 + (t470 + MSY3R * a3_z);
        let n3_y = n4_z + (t471 - MSX3 * a3_z);
        let n3_z = t465 + YZ3 * t36 - (MSX3 * t27 + MSY3R * a3_x) - t444;
        let n2_x = c3 * n3_x - s3 * n3_y - k_L2 * (s3 * f3_x + c3 * f3_y);
        let t507 = s3 * n3_x + c3 * n3_y + k_L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, n2_x, t507]
    };
    // link 2: force and moment
    let [t528, n2_z, t541] = {
        let t511 = s2 * XX2R + c2 * (XY2 + XY2);
        let t513 = c2 * t511 - XY2;
        let t516 = s2 * XZ2 + c2 * YZ2;
        let t527 = ddq2 * t516 + t8 * (c2 * XZ2 - s2 * YZ2);
        let t528 = t5 * t511 + (t513 + t513) * (dq1 * dq2) + t527;
        let t537 = MSX2 * a2_y - MSY2R * a2_x - t507;
        let n2_z = ZZ2R * ddq2 + ddq1 * t516 - t0 * t513 + t537;
        let t541 = s2 * n2_x + c2 * n3_z;
        [t528, n2_z, t541]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t528 + (t541 + ZZ1R * ddq1);
        n1_z
    };
    // drives
    {
        let t561 = n1_z + FV1 * dq1 + FC1 * dq1.sign();
        let t564 = n2_z + FV2 * dq2 + FC2 * dq2.sign();
        let t567 = n3_z + FV3 * dq3 + FC3 * dq3.sign();
        let t570 = n4_z + FV4 * dq4 + FC4 * dq4.sign();
        let t573 = n5_z + FV5 * dq5 + FC5 * dq5.sign();
        let t576 = n6_z + FV6 * dq6 + FC6 * dq6.sign();
        let t579 = n7_z + FV7 * dq7 + FC7 * dq7.sign();
        put(0, t561);
        put(1, t564);
        put(2, t567);
        put(3, t570);
        put(4, t573);
        put(5, t576);
        put(6, t579);
    }
}
