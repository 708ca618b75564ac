//! Torques from the base parameters.
//!
//! `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil
//! and Dombre, 9.6.
//!
//! 265 multiplications, 238 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, GRAVITY, Trig, constants};

/// Torques from the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE], out: &mut [S; 6]) {
    entries(trig, dq, ddq, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let [
        ZZ1R, MSX2R, MSY2, XX2R, ZZ2R, XY2, XZ2R, YZ2, MSX3R, MSY3, XX3R, ZZ3R,
        XY3, XZ3R, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        IA3, IA4, IA5, IA6, FV1, FV2, FV3, FV4, FV5, FV6, FC1, FC2,
        FC3, FC4, FC5, FC6, FO1, FO2, FO3, FO4, FO5, FO6,
        ..] = *beta;
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
        t55, t58, w4_z, dw4_z, t72, a4_x, a4_y, t80,
        w4_x, w4_y, t84, dw4_y, t91, t92, t93, t94,
        t95, t96,
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
        let t80 = ddq1 * t55;
        let w4_x = dq1 * t55;
        let w4_y = dq1 * t58;
        let t83 = w4_x * w4_x;
        let t84 = w4_z * w4_z;
        let t85 = w4_x * w4_y;
        let t86 = w4_z * w4_x;
        let t87 = w4_z * w4_y;
        let dw4_x = t80 + t87;
        let dw4_y = ddq1 * t58 - t86;
        let t91 = t83 - t84 - t0;
        let t92 = t85 - dw4_z;
        let t93 = dw4_z + t85;
        let t94 = t83 + t84;
        let t95 = t86 - dw4_y;
        let t96 = t87 + dw4_x;
        [
        t55, t58, w4_z, dw4_z, t72, a4_x, a4_y, t80,
        w4_x, w4_y, t84, dw4_y, t91, t92, t93, t94,
        t95, t96,
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
        t139, t142, t151, t154, dw6_z, t159, t160, t161,
        dw6_x, t164, t165, t166, t167, t168, t169, t170,
    ] = {
        let t139 = c6 * a5_x + s6 * t101;
        let t142 = c6 * t101 - s6 * a5_x;
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t148 = c6 * w5_z + s6 * w5_x;
        let t151 = c6 * t132 - s6 * t136;
        let t154 = c6 * t136 + s6 * t132;
        let w6_z = w5_y + dq6;
        let dw6_z = ddq6 - t129;
        let t157 = w6_x * w6_x;
        let t158 = w6_z * w6_z;
        let t159 = w6_x * t148;
        let t160 = w6_x * w6_z;
        let t161 = t148 * w6_z;
        let dw6_x = t154 - t161;
        let dw6_y = t151 - t160;
        let t164 = t157 - t158;
        let t165 = t164 - t134;
        let t166 = dw6_z + t159;
        let t167 = dw6_z - t159;
        let t168 = t157 + t158;
        let t169 = t160 - dw6_y;
        let t170 = dw6_x - t161;
        [
        t139, t142, t151, t154, dw6_z, t159, t160, t161,
        dw6_x, t164, t165, t166, t167, t168, t169, t170,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t222, t225, t228, t231] = {
        let t172 = XZ6 - k_D6 * MSX6;
        let t174 = YZ6 - k_D6 * MSY6;
        let t195 = XX6R * t159 + ZZ6 * dw6_z + XY6 * (t165 + t168) + t154 * t172;
        let t197 = t174 * (t134 - t168);
        let t200 = XX6R * dw6_x - ZZ6 * t161 - XY6 * t169 + t167 * t172 + t197;
        let t201 = t160 * (XX6R - ZZ6) + XY6 * t170 - t164 * t172 + t166 * t174;
        let f6_x = MSX6 * t165 - MSY6 * t166;
        let f6_y = MSX6 * t167 - MSY6 * t168;
        let f6_z = MSX6 * t169 + MSY6 * t170;
        let n6_x = t200 - MSY6 * t108;
        let n6_y = t201 + MSX6 * t108;
        let n6_z = t195 + t151 * t174 + (MSX6 * t142 - MSY6 * t139);
        let t222 = c6 * f6_x - s6 * f6_y;
        let t225 = s6 * f6_x + c6 * f6_y;
        let t228 = c6 * n6_x - s6 * n6_y;
        let t231 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t222, t225, t228, t231]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t285, t288, t297, t298] = {
        let t252 = ZZ5R * dw5_z - XX5R * t125 + XY5 * (t131 + t134) - XZ5 * t120;
        let t254 = YZ5 * (t94 - t134);
        let t257 = ZZ5R * t127 + XX5R * dw5_x - XY5 * t135 + XZ5 * t133 + t254;
        let t258 = t126 * (XX5R - ZZ5R) + XY5 * t136 - XZ5 * t130 - YZ5 * t132;
        let f5_x = t222 + (MSX5 * t131 + MSY5R * t132);
        let f5_y = f6_z + (MSX5 * t133 - MSY5R * t134);
        let f5_z = MSX5 * t135 + MSY5R * t136 - t225;
        let n5_x = t228 + (t257 - MSY5R * t101);
        let n5_y = n6_z + (t258 + MSX5 * t101);
        let n5_z = t252 - YZ5 * t117 - (MSX5 * t108 + MSY5R * a5_x) - t231;
        let t285 = c5 * f5_x - s5 * f5_y;
        let t288 = s5 * f5_x + c5 * f5_y;
        let t297 = c5 * n5_x - s5 * n5_y - k_D5 * t288;
        let t298 = s5 * n5_x + c5 * n5_y + k_D5 * t285;
        [f5_z, n5_z, t285, t288, t297, t298]
    };
    // link 4: force and moment
    let [t319, f4_z, n4_z, t348, t351, t363, t364, t365] = {
        let t302 = XX4R * t55 + t58 * (XY4 + XY4);
        let t304 = t58 * t302 - XY4;
        let t307 = XZ4 * t55 + YZ4 * t58;
        let t318 = dw4_z * t307 + t84 * (XZ4 * t58 - YZ4 * t55);
        let t319 = t80 * t302 + (t304 + t304) * (dq1 * w4_z) + t318;
        let f4_x = t285 + (MSX4 * t91 + MSY4R * t92);
        let f4_y = MSX4 * t93 - MSY4R * t94 - f5_z;
        let f4_z = t288 + (MSX4 * t95 + MSY4R * t96);
        let n4_x = t297 - MSY4R * t72;
        let n4_y = MSX4 * t72 - n5_z;
        let t344 = t298 + (MSX4 * a4_y - MSY4R * a4_x);
        let n4_z = ZZ4R * dw4_z + ddq1 * t307 - t0 * t304 + t344;
        let t348 = c4 * f4_x - s4 * f4_y;
        let t351 = s4 * f4_x + c4 * f4_y;
        let t363 = c4 * n4_x - s4 * n4_y - k_D4 * t351;
        let t364 = s4 * n4_x + c4 * n4_y + (k_D4 * t348 + k2 * f4_z);
        let t365 = n4_z - k2 * t351;
        [t319, f4_z, n4_z, t348, t351, t363, t364, t365]
    };
    // link 3: force and moment
    let [t392, n3_z, n2_x, n2_y, t426] = {
        let t369 = XX3R * t18 + t21 * (XY3 + XY3);
        let t371 = t21 * t369 - XY3;
        let t374 = XZ3R * t18 + YZ3 * t21;
        let t385 = dw3_z * t374 + t40 * (XZ3R * t21 - YZ3 * t18);
        let t392 = t319 + (t36 * t369 + (t371 + t371) * (dq1 * w3_z) + t385);
        let f3_x = t348 + (MSX3R * t47 + MSY3 * t48);
        let f3_y = t351 + (MSX3R * t49 - MSY3 * t50);
        let f3_z = f4_z + (MSX3R * t51 + MSY3 * t52);
        let n3_x = t363 - MSY3 * t26;
        let n3_y = t364 + MSX3R * t26;
        let t412 = t365 + (MSX3R * a3_y - MSY3 * a3_x);
        let n3_z = ZZ3R * dw3_z + ddq1 * t374 - t0 * t371 + t412;
        let n2_x = c3 * n3_x - s3 * n3_y;
        let n2_y = s3 * n3_x + c3 * n3_y + k1 * f3_z;
        let t426 = n3_z - k1 * (s3 * f3_x + c3 * f3_y);
        [t392, n3_z, n2_x, n2_y, t426]
    };
    // link 2: force and moment
    let [t453, n2_z, t461] = {
        let t430 = s2 * XX2R + c2 * (XY2 + XY2);
        let t432 = c2 * t430 - XY2;
        let t435 = s2 * XZ2R + c2 * YZ2;
        let t446 = ddq2 * t435 + t8 * (c2 * XZ2R - s2 * YZ2);
        let t453 = t392 + (t5 * t430 + (t432 + t432) * (dq1 * dq2) + t446);
        let t457 = t426 + (MSX2R * a2_y - MSY2 * a2_x);
        let n2_z = ZZ2R * ddq2 + ddq1 * t435 - t0 * t432 + t457;
        let t461 = s2 * n2_x + c2 * n2_y;
        [t453, n2_z, t461]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t453 + (t461 + ZZ1R * ddq1);
        n1_z
    };
    // drives
    {
        let t503 = FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t504 = FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t505 = FO3 + (n3_z + IA3 * ddq3 + FV3 * dq3 + FC3 * dq3.sign());
        let t506 = FO4 + (n4_z + IA4 * ddq4 + FV4 * dq4 + FC4 * dq4.sign());
        let t507 = FO5 + (n5_z + IA5 * ddq5 + FV5 * dq5 + FC5 * dq5.sign());
        let t508 = FO6 + (n6_z + IA6 * ddq6 + FV6 * dq6 + FC6 * dq6.sign());
        put(0, t503);
        put(1, t504);
        put(2, t505);
        put(3, t506);
        put(4, t507);
        put(5, t508);
    }
}
