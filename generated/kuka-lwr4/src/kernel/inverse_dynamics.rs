//! Torques from the standard parameters.
//!
//! `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil
//! and Dombre, 9.5.2.
//!
//! 343 multiplications, 333 additions; 7, 7 of 7 structurally nonzero.

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
        ..] = *phi;
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
        dw7_x, dw7_y, t191, t192, t193, t194, t195, t196,
        t197,
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
        dw7_x, dw7_y, t191, t192, t193, t194, t195, t196,
        t197,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t265, t268, t271, t274] = {
        let t219 = XZ7 * t181;
        let t220 = XX7 * dw7_x - t188 * (ZZ7 - YY7) - XY7 * t196 + XZ7 * t194;
        let t221 = t187 * (XX7 - ZZ7) + YY7 * dw7_y + XY7 * t197 - XZ7 * t191;
        let t222 = ZZ7 * dw7_z - t186 * (YY7 - XX7) + XY7 * (t192 + t195) + t219;
        let f7_x = M7 * a7_x + (MSZ7 * t178 + (MSX7 * t192 - MSY7 * t193));
        let f7_y = M7 * a7_y + (MSX7 * t194 - MSY7 * t195 - MSZ7 * t181);
        let f7_z = MSX7 * t196 + MSY7 * t197 - MSZ7 * t161 - M7 * t135;
        let n7_x = t220 + YZ7 * (t161 - t195) - (MSY7 * t135 + MSZ7 * a7_y);
        let n7_y = t221 + YZ7 * t193 + (MSZ7 * a7_x + MSX7 * t135);
        let n7_z = t222 + YZ7 * t178 + (MSX7 * a7_y - MSY7 * a7_x);
        let t265 = c7 * f7_x - s7 * f7_y;
        let t268 = s7 * f7_x + c7 * f7_y;
        let t271 = c7 * n7_x - s7 * n7_y;
        let t274 = s7 * n7_x + c7 * n7_y;
        [f7_z, n7_z, t265, t268, t271, t274]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t348, t351, t354, t357] = {
        let t296 = XZ6 * t147;
        let t297 = t154 * (ZZ6 - YY6) + XX6 * dw6_x - XY6 * t162 + XZ6 * t160;
        let t298 = t153 * (XX6 - ZZ6) - YY6 * t156 + XY6 * t163 - XZ6 * t157;
        let t299 = t152 * (YY6 - XX6) + ZZ6 * dw6_z + XY6 * (t158 + t161) - t296;
        let f6_x = t265 + (M6 * a6_x + (MSX6 * t158 + MSY6 * t159 - MSZ6 * t144));
        let f6_y = f7_z + (MSZ6 * t147 + (MSX6 * t160 - MSY6 * t161) - M6 * t135);
        let f6_z = MSX6 * t162 + MSY6 * t163 - MSZ6 * t127 - M6 * a5_y - t268;
        let n6_x = t271 + (t297 + YZ6 * (t127 - t161) + (MSZ6 * t135 - MSY6 * a5_y));
        let n6_y = n7_z + (t298 - YZ6 * t159 + (MSZ6 * a6_x + MSX6 * a5_y));
        let n6_z = t299 - YZ6 * t144 - (MSX6 * t135 + MSY6 * a6_x) - t274;
        let t348 = c6 * f6_x - s6 * f6_y;
        let t351 = s6 * f6_x + c6 * f6_y;
        let t354 = c6 * n6_x - s6 * n6_y;
        let t357 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t348, t351, t354, t357]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t431, t434, t443, t444] = {
        let t379 = XZ5 * t113;
        let t380 = t120 * (ZZ5 - YY5) + XX5 * dw5_x - XY5 * t128 + XZ5 * t126;
        let t381 = t119 * (XX5 - ZZ5) + YY5 * dw5_y + XY5 * t129 - XZ5 * t123;
        let t382 = t118 * (YY5 - XX5) + ZZ5 * dw5_z + XY5 * (t124 + t127) - t379;
        let f5_x = t348 + (M5 * a5_x + (MSZ5 * t110 + (MSX5 * t124 + MSY5 * t125)));
        let f5_y = M5 * a5_y + (MSZ5 * t113 + (MSX5 * t126 - MSY5 * t127)) - f6_z;
        let f5_z = t351 + (MSX5 * t128 + MSY5 * t129 - MSZ5 * t87 - M5 * t94);
        let n5_x = t354 + (t380 + YZ5 * (t87 - t127) - (MSY5 * t94 + MSZ5 * a5_y));
        let n5_y = t381 - YZ5 * t125 + (MSZ5 * a5_x + MSX5 * t94) - n6_z;
        let n5_z = t357 + (t382 + YZ5 * t110 + (MSX5 * a5_y - MSY5 * a5_x));
        let t431 = c5 * f5_x - s5 * f5_y;
        let t434 = s5 * f5_x + c5 * f5_y;
        let t443 = c5 * n5_x - s5 * n5_y - k_L3 * t434;
        let t444 = s5 * n5_x + c5 * n5_y + k_L3 * t431;
        [f5_z, n5_z, t431, t434, t443, t444]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t518, t521, t524] = {
        let t466 = XZ4 * t73;
        let t467 = XZ4 * t86 - (t80 * (ZZ4 - YY4) + XX4 * t81 + XY4 * t88);
        let t468 = t79 * (XX4 - ZZ4) - YY4 * t82 - XY4 * t89 - XZ4 * t83;
        let t469 = ZZ4 * dw4_z - t78 * (YY4 - XX4) + XY4 * (t84 + t87) - t466;
        let f4_x = t431 + (M4 * a4_x + (MSX4 * t84 - MSY4 * t85 - MSZ4 * t70));
        let f4_y = MSZ4 * t73 + (MSX4 * t86 - MSY4 * t87) - M4 * t61 - f5_z;
        let f4_z = t434 + (MSX4 * t88 - MSY4 * t89 - MSZ4 * t53 - M4 * t27);
        let n4_x = t443 + (t467 + YZ4 * (t53 - t87) + (MSZ4 * t61 - MSY4 * t27));
        let n4_y = t468 + YZ4 * t85 + (MSZ4 * a4_x + MSX4 * t27) - n5_z;
        let n4_z = t444 + (t469 - YZ4 * t70 - (MSX4 * t61 + MSY4 * a4_x));
        let t518 = c4 * f4_x - s4 * f4_y;
        let t521 = c4 * n4_x - s4 * n4_y;
        let t524 = s4 * n4_x + c4 * n4_y;
        [f4_z, n4_z, t518, t521, t524]
    };
    // link 3: force and moment
    let [n3_z, t602, t603] = {
        let t546 = XZ3 * t39;
        let t547 = XX3 * dw3_x - t46 * (ZZ3 - YY3) - XY3 * t54 + XZ3 * t52;
        let t548 = t45 * (XX3 - ZZ3) + YY3 * dw3_y + XY3 * t55 - XZ3 * t49;
        let t549 = ZZ3 * dw3_z - t44 * (YY3 - XX3) + XY3 * (t50 + t53) + t546;
        let f3_x = t518 + (M3 * a3_x + (MSZ3 * t36 + (MSX3 * t50 - MSY3 * t51)));
        let f3_y = f4_z + (MSX3 * t52 - MSY3 * t53 - MSZ3 * t39 - M3 * t27);
        let n3_x = t521 + (t547 + YZ3 * (t15 - t53) + (MSY3 * a3_z + MSZ3 * t27));
        let n3_y = n4_z + (t548 + YZ3 * t51 + (MSZ3 * a3_x - MSX3 * a3_z));
        let n3_z = t549 + YZ3 * t36 - (MSX3 * t27 + MSY3 * a3_x) - t524;
        let t602 = c3 * n3_x - s3 * n3_y - k_L2 * (s3 * f3_x + c3 * f3_y);
        let t603 = s3 * n3_x + c3 * n3_y + k_L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, t602, t603]
    };
    // link 2: force and moment
    let [t627, n2_z, t644] = {
        let t608 = s2 * (XX2 - YY2) + c2 * (XY2 + XY2);
        let t610 = c2 * t608 - XY2;
        let t613 = s2 * XZ2 + c2 * YZ2;
        let t626 = ddq2 * t613 + t8 * (c2 * XZ2 - s2 * YZ2);
        let t627 = t5 * t608 + YY2 * ddq1 + (t610 + t610) * (dq1 * dq2) + t626;
        let n2_x = t602 - MSZ2 * a2_y;
        let n2_y = n3_z + MSZ2 * a2_x;
        let t640 = MSX2 * a2_y - MSY2 * a2_x - t603;
        let n2_z = ZZ2 * ddq2 + ddq1 * t613 - t0 * t610 + t640;
        let t644 = s2 * n2_x + c2 * n2_y;
        [t627, n2_z, t644]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t627 + (t644 + ZZ1 * ddq1);
        n1_z
    };
    // drives
    {
        let t664 = n1_z + FV1 * dq1 + FC1 * dq1.sign();
        let t667 = n2_z + FV2 * dq2 + FC2 * dq2.sign();
        let t670 = n3_z + FV3 * dq3 + FC3 * dq3.sign();
        let t673 = n4_z + FV4 * dq4 + FC4 * dq4.sign();
        let t676 = n5_z + FV5 * dq5 + FC5 * dq5.sign();
        let t679 = n6_z + FV6 * dq6 + FC6 * dq6.sign();
        let t682 = n7_z + FV7 * dq7 + FC7 * dq7.sign();
        put(0, t664);
        put(1, t667);
        put(2, t670);
        put(3, t673);
        put(4, t676);
        put(5, t679);
        put(6, t682);
    }
}
