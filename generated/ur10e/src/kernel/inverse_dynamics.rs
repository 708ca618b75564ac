//! Torques from the standard parameters.
//!
//! `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil
//! and Dombre, 9.5.2.
//!
//! 309 multiplications, 289 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, STANDARD, GRAVITY, Trig, constants};

/// Torques from the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], out: &mut [S; 6]) {
    entries(trig, dq, ddq, phi, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let [
        _, _, _, _, _, _, ZZ1, _, _, _, _, MSX2,
        MSY2, MSZ2, XX2, YY2, ZZ2, XY2, XZ2, YZ2, M3, MSX3, MSY3, MSZ3,
        XX3, YY3, ZZ3, XY3, XZ3, YZ3, M4, MSX4, MSY4, MSZ4, XX4, YY4,
        ZZ4, XY4, XZ4, YZ4, M5, MSX5, MSY5, MSZ5, XX5, YY5, ZZ5, XY5,
        XZ5, YZ5, M6, MSX6, MSY6, MSZ6, XX6, YY6, ZZ6, XY6, XZ6, YZ6,
        IA1, IA2, IA3, IA4, IA5, IA6, FV1, FV2, FV3, FV4, FV5, FV6,
        FC1, FC2, FC3, FC4, FC5, FC6, FO1, FO2, FO3, FO4, FO5, FO6,
        ..] = *phi;
    let k0 = S::constant(-GRAVITY[2]);
    let k1 = S::constant(-constants::A2);
    let k2 = S::constant(-constants::A3);
    let k_D4 = S::constant(constants::D4);
    let k_D5 = S::constant(constants::D5);
    let k_D6 = S::constant(constants::D6);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [a2_x, a2_y, t5, t8, t13, t14, t15] = {
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t5 = s2 * ddq1;
        let t8 = dq2 * dq2;
        let t10 = dq2 * w2_x;
        let dw2_y = c2 * ddq1 - t10;
        let t13 = w2_x * w2_x - t8 - t0;
        let t14 = ddq2 + w2_x * w2_y;
        let t15 = t10 - dw2_y;
        [a2_x, a2_y, t5, t8, t13, t14, t15]
    };
    // link 3: motion
    let [
        t18, t21, w3_z, dw3_z, t26, a3_x, a3_y, t35,
        t36, t40, t47, t48, t49, t50, t51, t52,
    ] = {
        let t18 = s2 * c3 + c2 * s3;
        let t21 = c2 * c3 - s2 * s3;
        let w3_z = dq2 + dq3;
        let dw3_z = ddq2 + ddq3;
        let t26 = t15 * k1;
        let t27 = a2_x - t13 * k1;
        let t28 = a2_y - t14 * k1;
        let a3_x = c3 * t27 + s3 * t28;
        let a3_y = c3 * t28 - s3 * t27;
        let t35 = ddq1 * t21;
        let t36 = ddq1 * t18;
        let w3_x = dq1 * t18;
        let w3_y = dq1 * t21;
        let t39 = w3_x * w3_x;
        let t40 = w3_z * w3_z;
        let t41 = w3_x * w3_y;
        let t42 = w3_z * w3_x;
        let t43 = w3_z * w3_y;
        let dw3_x = t36 + t43;
        let dw3_y = t35 - t42;
        let t47 = t39 - t40 - t0;
        let t48 = t41 - dw3_z;
        let t49 = dw3_z + t41;
        let t50 = t39 + t40;
        let t51 = t42 - dw3_y;
        let t52 = t43 + dw3_x;
        [
        t18, t21, w3_z, dw3_z, t26, a3_x, a3_y, t35,
        t36, t40, t47, t48, t49, t50, t51, t52,
    ]
    };
    // link 4: motion
    let [
        t55, t58, w4_z, dw4_z, t72, a4_x, a4_y, t79,
        t80, w4_x, w4_y, t84, dw4_y, t91, t92, t93,
        t94, t95, t96,
    ] = {
        let t55 = c4 * t18 + s4 * t21;
        let t58 = c4 * t21 - s4 * t18;
        let w4_z = w3_z + dq4;
        let dw4_z = dw3_z + ddq4;
        let t70 = a3_x + (k_D4 * t35 - t47 * k2);
        let t71 = a3_y - (t49 * k2 + k_D4 * t36);
        let t72 = t26 + (t51 * k2 + k_D4 * t0);
        let a4_x = c4 * t70 + s4 * t71;
        let a4_y = c4 * t71 - s4 * t70;
        let t79 = ddq1 * t58;
        let t80 = ddq1 * t55;
        let w4_x = dq1 * t55;
        let w4_y = dq1 * t58;
        let t83 = w4_x * w4_x;
        let t84 = w4_z * w4_z;
        let t85 = w4_x * w4_y;
        let t86 = w4_z * w4_x;
        let t87 = w4_z * w4_y;
        let dw4_x = t80 + t87;
        let dw4_y = t79 - t86;
        let t91 = t83 - t84 - t0;
        let t92 = t85 - dw4_z;
        let t93 = dw4_z + t85;
        let t94 = t83 + t84;
        let t95 = t86 - dw4_y;
        let t96 = t87 + dw4_x;
        [
        t55, t58, w4_z, dw4_z, t72, a4_x, a4_y, t79,
        t80, w4_x, w4_y, t84, dw4_y, t91, t92, t93,
        t94, t95, t96,
    ]
    };
    // link 5: motion
    let [
        t101, a5_x, t108, w5_x, w5_y, t117, t120, w5_z,
        dw5_z, t125, t126, t127, dw5_x, t129, t130, t131,
        t132, t133, t134, t135, t136,
    ] = {
        let t100 = a4_x - k_D5 * t92;
        let t101 = a4_y + k_D5 * t94;
        let t102 = t72 + k_D5 * t96;
        let a5_x = c5 * t100 - s5 * t102;
        let t108 = c5 * t102 + s5 * t100;
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t117 = c5 * t92 + s5 * t96;
        let t120 = s5 * t92 - c5 * t96;
        let w5_z = dq5 - w4_y;
        let dw5_z = ddq5 - dw4_y;
        let t123 = w5_x * w5_x;
        let t124 = w5_z * w5_z;
        let t125 = w5_x * w5_y;
        let t126 = w5_x * w5_z;
        let t127 = w5_y * w5_z;
        let dw5_x = t127 - t120;
        let t129 = t117 + t126;
        let t130 = t123 - t124;
        let t131 = t130 - t94;
        let t132 = t125 - dw5_z;
        let t133 = dw5_z + t125;
        let t134 = t123 + t124;
        let t135 = t126 + t129;
        let t136 = t127 + dw5_x;
        [
        t101, a5_x, t108, w5_x, w5_y, t117, t120, w5_z,
        dw5_z, t125, t126, t127, dw5_x, t129, t130, t131,
        t132, t133, t134, t135, t136,
    ]
    };
    // link 6: motion
    let [
        t141, a6_x, t148, t157, t160, dw6_z, t165, t166,
        t167, dw6_x, dw6_y, t170, t171, t172, t173, t174,
        t175, t176,
    ] = {
        let t140 = a5_x + k_D6 * t132;
        let t141 = t108 + k_D6 * t134;
        let t142 = k_D6 * t136 - t101;
        let a6_x = c6 * t140 - s6 * t142;
        let t148 = c6 * t142 + s6 * t140;
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t154 = c6 * w5_z + s6 * w5_x;
        let t157 = c6 * t132 - s6 * t136;
        let t160 = c6 * t136 + s6 * t132;
        let w6_z = w5_y + dq6;
        let dw6_z = ddq6 - t129;
        let t163 = w6_x * w6_x;
        let t164 = w6_z * w6_z;
        let t165 = w6_x * t154;
        let t166 = w6_x * w6_z;
        let t167 = t154 * w6_z;
        let dw6_x = t160 - t167;
        let dw6_y = t157 - t166;
        let t170 = t163 - t164;
        let t171 = t170 - t134;
        let t172 = dw6_z + t165;
        let t173 = dw6_z - t165;
        let t174 = t163 + t164;
        let t175 = t166 - dw6_y;
        let t176 = dw6_x - t167;
        [
        t141, a6_x, t148, t157, t160, dw6_z, t165, t166,
        t167, dw6_x, dw6_y, t170, t171, t172, t173, t174,
        t175, t176,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t244, t247, t256, t257] = {
        let t198 = XZ6 * t160;
        let t199 = XX6 * dw6_x - t167 * (ZZ6 - YY6) - XY6 * t175 + XZ6 * t173;
        let t200 = t166 * (XX6 - ZZ6) + YY6 * dw6_y + XY6 * t176 - XZ6 * t170;
        let t201 = ZZ6 * dw6_z - t165 * (YY6 - XX6) + XY6 * (t171 + t174) + t198;
        let f6_x = M6 * a6_x + (MSZ6 * t157 + (MSX6 * t171 - MSY6 * t172));
        let f6_y = MSX6 * t173 - MSY6 * t174 - MSZ6 * t160 - M6 * t148;
        let f6_z = MSX6 * t175 + MSY6 * t176 - MSZ6 * t134 - M6 * t141;
        let n6_x = t199 + YZ6 * (t134 - t174) + (MSZ6 * t148 - MSY6 * t141);
        let n6_y = t200 + YZ6 * t172 + (MSZ6 * a6_x + MSX6 * t141);
        let n6_z = t201 + YZ6 * t157 - (MSX6 * t148 + MSY6 * a6_x);
        let t244 = c6 * f6_x - s6 * f6_y;
        let t247 = s6 * f6_x + c6 * f6_y;
        let t256 = c6 * n6_x - s6 * n6_y - k_D6 * t247;
        let t257 = s6 * n6_x + c6 * n6_y + k_D6 * t244;
        [f6_z, n6_z, t244, t247, t256, t257]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t331, t334, t343, t344] = {
        let t279 = XZ5 * t120;
        let t280 = t127 * (ZZ5 - YY5) + XX5 * dw5_x - XY5 * t135 + XZ5 * t133;
        let t281 = t126 * (XX5 - ZZ5) - YY5 * t129 + XY5 * t136 - XZ5 * t130;
        let t282 = t125 * (YY5 - XX5) + ZZ5 * dw5_z + XY5 * (t131 + t134) - t279;
        let f5_x = t244 + (M5 * a5_x + (MSX5 * t131 + MSY5 * t132 - MSZ5 * t117));
        let f5_y = f6_z + (MSZ5 * t120 + (MSX5 * t133 - MSY5 * t134) - M5 * t108);
        let f5_z = MSX5 * t135 + MSY5 * t136 - MSZ5 * t94 - M5 * t101 - t247;
        let n5_x = t256 + (t280 + YZ5 * (t94 - t134) + (MSZ5 * t108 - MSY5 * t101));
        let n5_y = n6_z + (t281 - YZ5 * t132 + (MSZ5 * a5_x + MSX5 * t101));
        let n5_z = t282 - YZ5 * t117 - (MSX5 * t108 + MSY5 * a5_x) - t257;
        let t331 = c5 * f5_x - s5 * f5_y;
        let t334 = s5 * f5_x + c5 * f5_y;
        let t343 = c5 * n5_x - s5 * n5_y - k_D5 * t334;
        let t344 = s5 * n5_x + c5 * n5_y + k_D5 * t331;
        [f5_z, n5_z, t331, t334, t343, t344]
    };
    // link 4: force and moment
    let [t368, f4_z, n4_z, t413, t416, t428, t429, t430] = {
        let t349 = t55 * (XX4 - YY4) + t58 * (XY4 + XY4);
        let t351 = t58 * t349 - XY4;
        let t354 = XZ4 * t55 + YZ4 * t58;
        let t367 = dw4_z * t354 + t84 * (XZ4 * t58 - YZ4 * t55);
        let t368 = t80 * t349 + YY4 * ddq1 + (t351 + t351) * (dq1 * w4_z) + t367;
        let f4_x = t331 + (M4 * a4_x + (MSZ4 * t79 + (MSX4 * t91 + MSY4 * t92)));
        let f4_y = M4 * a4_y + (MSX4 * t93 - MSY4 * t94 - MSZ4 * t80) - f5_z;
        let f4_z = t334 + (MSX4 * t95 + MSY4 * t96 - MSZ4 * t0 - M4 * t72);
        let n4_x = t343 - (MSY4 * t72 + MSZ4 * a4_y);
        let n4_y = MSZ4 * a4_x + MSX4 * t72 - n5_z;
        let t409 = t344 + (MSX4 * a4_y - MSY4 * a4_x);
        let n4_z = ZZ4 * dw4_z + ddq1 * t354 - t0 * t351 + t409;
        let t413 = c4 * f4_x - s4 * f4_y;
        let t416 = s4 * f4_x + c4 * f4_y;
        let t428 = c4 * n4_x - s4 * n4_y - k_D4 * t416;
        let t429 = s4 * n4_x + c4 * n4_y + (k_D4 * t413 + k2 * f4_z);
        let t430 = n4_z - k2 * t416;
        [t368, f4_z, n4_z, t413, t416, t428, t429, t430]
    };
    // link 3: force and moment
    let [t460, n3_z, t503, t509, t510] = {
        let t435 = t18 * (XX3 - YY3) + t21 * (XY3 + XY3);
        let t437 = t21 * t435 - XY3;
        let t440 = XZ3 * t18 + YZ3 * t21;
        let t453 = dw3_z * t440 + t40 * (XZ3 * t21 - YZ3 * t18);
        let t454 = t36 * t435 + YY3 * ddq1 + (t437 + t437) * (dq1 * w3_z) + t453;
        let t460 = t368 + t454;
        let f3_x = t413 + (M3 * a3_x + (MSZ3 * t35 + (MSX3 * t47 + MSY3 * t48)));
        let f3_y = t416 + (M3 * a3_y + (MSX3 * t49 - MSY3 * t50 - MSZ3 * t36));
        let f3_z = f4_z + (MSX3 * t51 + MSY3 * t52 - MSZ3 * t0 - M3 * t26);
        let n3_x = t428 - (MSY3 * t26 + MSZ3 * a3_y);
        let n3_y = t429 + (MSZ3 * a3_x + MSX3 * t26);
        let t496 = t430 + (MSX3 * a3_y - MSY3 * a3_x);
        let n3_z = ZZ3 * dw3_z + ddq1 * t440 - t0 * t437 + t496;
        let t503 = c3 * n3_x - s3 * n3_y;
        let t509 = s3 * n3_x + c3 * n3_y + k1 * f3_z;
        let t510 = n3_z - k1 * (s3 * f3_x + c3 * f3_y);
        [t460, n3_z, t503, t509, t510]
    };
    // link 2: force and moment
    let [t540, n2_z, t552] = {
        let t515 = s2 * (XX2 - YY2) + c2 * (XY2 + XY2);
        let t517 = c2 * t515 - XY2;
        let t520 = s2 * XZ2 + c2 * YZ2;
        let t533 = ddq2 * t520 + t8 * (c2 * XZ2 - s2 * YZ2);
        let t534 = t5 * t515 + YY2 * ddq1 + (t517 + t517) * (dq1 * dq2) + t533;
        let t540 = t460 + t534;
        let n2_x = t503 - MSZ2 * a2_y;
        let n2_y = t509 + MSZ2 * a2_x;
        let t548 = t510 + (MSX2 * a2_y - MSY2 * a2_x);
        let n2_z = ZZ2 * ddq2 + ddq1 * t520 - t0 * t517 + t548;
        let t552 = s2 * n2_x + c2 * n2_y;
        [t540, n2_z, t552]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t540 + (t552 + ZZ1 * ddq1);
        n1_z
    };
    // drives
    {
        let t598 = FO1 + (n1_z + IA1 * ddq1 + FV1 * dq1 + FC1 * dq1.sign());
        let t599 = FO2 + (n2_z + IA2 * ddq2 + FV2 * dq2 + FC2 * dq2.sign());
        let t600 = FO3 + (n3_z + IA3 * ddq3 + FV3 * dq3 + FC3 * dq3.sign());
        let t601 = FO4 + (n4_z + IA4 * ddq4 + FV4 * dq4 + FC4 * dq4.sign());
        let t602 = FO5 + (n5_z + IA5 * ddq5 + FV5 * dq5 + FC5 * dq5.sign());
        let t603 = FO6 + (n6_z + IA6 * ddq6 + FV6 * dq6 + FC6 * dq6.sign());
        put(0, t598);
        put(1, t599);
        put(2, t600);
        put(3, t601);
        put(4, t602);
        put(5, t603);
    }
}
