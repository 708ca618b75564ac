//! Torques from the base parameters.
//!
//! `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil and Dombre, 9.6.
//!
//! 344 multiplications, 330 additions; 7, 7 of 7 structurally nonzero.

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
        FV6, FV7, FC1, FC2, FC3, FC4, FC5, FC6, FC7, FO1, FO2, FO3,
        FO4, FO5, FO6, FO7,
        ..] = *beta;
    let k0 = S::constant(9.81);
    let k1 = S::constant(0.01175);
    let k2 = S::constant(0.42076);
    let k3 = S::constant(0.01275);
    let k4 = S::constant(0.31436);
    let k5 = S::constant(0.00035);
    let k6 = S::constant(0.167455);
    // link 2: motion
    let [
        w2_x, w2_y, t2, t3, a2_z, t10, a2_y, t13,
        t14, dw2_x, dw2_y,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t2 = s2 * ddq1;
        let t3 = c2 * ddq1;
        let t7 = ddq1 * k1;
        let a2_z = dq1 * dq1 * k1;
        let t10 = s2 * k0 + c2 * t7;
        let a2_y = s2 * t7 - c2 * k0;
        let t13 = dq2 * w2_y;
        let t14 = dq2 * w2_x;
        let dw2_x = t2 + t13;
        let dw2_y = t3 - t14;
        [
        w2_x, w2_y, t2, t3, a2_z, t10, a2_y, t13,
        t14, dw2_x, dw2_y,
    ]
    };
    // link 3: motion
    let [
        w3_x, t22, t29, t30, t31, t32, t33, t34,
        t35, t36, t37, t38, a3_z, t47, a3_y, w3_z,
        dw3_x, t55, dw3_z,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t22 = c3 * dq2 + s3 * w2_x;
        let t29 = w2_x * w2_x;
        let t30 = w2_y * w2_y;
        let t31 = dq2 * dq2;
        let t32 = w2_x * w2_y;
        let t33 = t30 + t31;
        let t34 = t32 - ddq2;
        let t35 = ddq2 + t32;
        let t36 = t29 + t31;
        let t37 = t14 - dw2_y;
        let t38 = t13 + dw2_x;
        let t42 = t10 + t34 * k2;
        let a3_z = a2_y + t36 * k2;
        let t44 = a2_z - t38 * k2;
        let t47 = c3 * t42 + s3 * t44;
        let a3_y = s3 * t42 - c3 * t44;
        let w3_z = w2_y + dq3;
        let dw3_x = c3 * dw2_x - s3 * ddq2 - dq3 * t22;
        let t55 = c3 * ddq2 + s3 * dw2_x + dq3 * w3_x;
        let dw3_z = dw2_y + ddq3;
        [
        w3_x, t22, t29, t30, t31, t32, t33, t34,
        t35, t36, t37, t38, a3_z, t47, a3_y, w3_z,
        dw3_x, t55, dw3_z,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t69, t70, t71, t72, t73, t74,
        t75, t76, t77, t78, t79, t80, t81, t82,
        t87, a4_x, a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t69 = w3_x * w3_x;
        let t70 = t22 * t22;
        let t71 = w3_z * w3_z;
        let t72 = w3_x * t22;
        let t73 = w3_x * w3_z;
        let t74 = t22 * w3_z;
        let t75 = t70 + t71;
        let t76 = dw3_z + t72;
        let t77 = t73 - t55;
        let t78 = dw3_z - t72;
        let t79 = t69 + t71;
        let t80 = dw3_x + t74;
        let t81 = t55 + t73;
        let t82 = dw3_x - t74;
        let t86 = t47 + t76 * k3;
        let t87 = a3_y - t79 * k3;
        let t88 = a3_z + t82 * k3;
        let a4_x = s4 * t88 - c4 * t86;
        let a4_y = c4 * t88 + s4 * t86;
        let w4_z = t22 + dq4;
        let dw4_x = c4 * dw3_x + s4 * dw3_z + dq4 * w4_y;
        let dw4_y = c4 * dw3_z - s4 * dw3_x - dq4 * w4_x;
        let dw4_z = t55 + ddq4;
        [
        w4_x, w4_y, t69, t70, t71, t72, t73, t74,
        t75, t76, t77, t78, t79, t80, t81, t82,
        t87, a4_x, a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ]
    };
    // link 5: motion
    let [
        w5_x, t106, t113, t114, t115, t116, t117, t118,
        t119, t120, t121, t122, t123, t124, t125, t126,
        a5_z, a5_x, a5_y, w5_z, dw5_x, t143, dw5_z,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t106 = c5 * w4_z + s5 * w4_x;
        let t113 = w4_x * w4_x;
        let t114 = w4_y * w4_y;
        let t115 = w4_z * w4_z;
        let t116 = w4_x * w4_y;
        let t117 = w4_x * w4_z;
        let t118 = w4_y * w4_z;
        let t119 = t114 + t115;
        let t120 = t116 - dw4_z;
        let t121 = dw4_y + t117;
        let t122 = dw4_z + t116;
        let t123 = t113 + t115;
        let t124 = t118 - dw4_x;
        let t125 = t117 - dw4_y;
        let t126 = dw4_x + t118;
        let t130 = a4_x - t120 * k4;
        let a5_z = a4_y + t123 * k4;
        let t132 = t87 + t126 * k4;
        let a5_x = c5 * t130 + s5 * t132;
        let a5_y = c5 * t132 - s5 * t130;
        let w5_z = w4_y + dq5;
        let dw5_x = c5 * dw4_x - s5 * dw4_z - dq5 * t106;
        let t143 = c5 * dw4_z + s5 * dw4_x + dq5 * w5_x;
        let dw5_z = dw4_y + ddq5;
        [
        w5_x, t106, t113, t114, t115, t116, t117, t118,
        t119, t120, t121, t122, t123, t124, t125, t126,
        a5_z, a5_x, a5_y, w5_z, dw5_x, t143, dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t157, t158, t159, t160, t161, t162,
        t163, t164, t165, t166, t167, t168, t169, t170,
        t175, a6_x, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t157 = w5_x * w5_x;
        let t158 = t106 * t106;
        let t159 = w5_z * w5_z;
        let t160 = w5_x * t106;
        let t161 = w5_x * w5_z;
        let t162 = t106 * w5_z;
        let t163 = t158 + t159;
        let t164 = dw5_z + t160;
        let t165 = t161 - t143;
        let t166 = dw5_z - t160;
        let t167 = t157 + t159;
        let t168 = dw5_x + t162;
        let t169 = t143 + t161;
        let t170 = dw5_x - t162;
        let t174 = a5_x - t164 * k5;
        let t175 = a5_y - t167 * k5;
        let t176 = a5_z + t170 * k5;
        let a6_x = c6 * t174 + s6 * t176;
        let a6_y = c6 * t176 - s6 * t174;
        let w6_z = t106 + dq6;
        let dw6_x = c6 * dw5_x + s6 * dw5_z + dq6 * w6_y;
        let dw6_y = c6 * dw5_z - s6 * dw5_x - dq6 * w6_x;
        let dw6_z = t143 + ddq6;
        [
        w6_x, w6_y, t157, t158, t159, t160, t161, t162,
        t163, t164, t165, t166, t167, t168, t169, t170,
        t175, a6_x, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ]
    };
    // link 7: motion
    let [
        w7_x, t194, t201, t202, t203, t204, t205, t206,
        t207, t208, t209, t210, t211, t212, t213, t214,
        a7_z, a7_x, a7_y, w7_z, dw7_x, t231, dw7_z,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t194 = c7 * w6_z + s7 * w6_x;
        let t201 = w6_x * w6_x;
        let t202 = w6_y * w6_y;
        let t203 = w6_z * w6_z;
        let t204 = w6_x * w6_y;
        let t205 = w6_x * w6_z;
        let t206 = w6_y * w6_z;
        let t207 = t202 + t203;
        let t208 = t204 - dw6_z;
        let t209 = dw6_y + t205;
        let t210 = dw6_z + t204;
        let t211 = t201 + t203;
        let t212 = t206 - dw6_x;
        let t213 = t205 - dw6_y;
        let t214 = dw6_x + t206;
        let t218 = a6_x - t208 * k6;
        let a7_z = a6_y + t211 * k6;
        let t220 = t175 + t214 * k6;
        let a7_x = c7 * t218 + s7 * t220;
        let a7_y = c7 * t220 - s7 * t218;
        let w7_z = w6_y + dq7;
        let dw7_x = c7 * dw6_x - s7 * dw6_z - dq7 * t194;
        let t231 = c7 * dw6_z + s7 * dw6_x + dq7 * w7_x;
        let dw7_z = dw6_y + ddq7;
        [
        w7_x, t194, t201, t202, t203, t204, t205, t206,
        t207, t208, t209, t210, t211, t212, t213, t214,
        a7_z, a7_x, a7_y, w7_z, dw7_x, t231, dw7_z,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t295, t298, t307, t308] = {
        let t233 = w7_x * w7_x;
        let t234 = t194 * t194;
        let t235 = w7_z * w7_z;
        let t236 = w7_x * t194;
        let t237 = w7_x * w7_z;
        let t238 = t194 * w7_z;
        let t240 = dw7_z + t236;
        let t242 = dw7_z - t236;
        let t245 = t231 + t237;
        let t246 = dw7_x - t238;
        let t265 = XZ7 * (dw7_x + t238);
        let t270 = YZ7 * (t234 - t235);
        let t271 = YZ7 * t240;
        let t272 = YZ7 * (t237 - t231);
        let t273 = XX7R * dw7_x - ZZ7 * t238 - XY7 * t245 + XZ7 * t242 + t270;
        let t274 = t237 * (XX7R - ZZ7) + XY7 * t246 + XZ7 * (t235 - t233) + t271;
        let t275 = XX7R * t236 + ZZ7 * dw7_z + XY7 * (t233 - t234) + t265 + t272;
        let t278 = MSX7 * (t234 + t235) + MSY7 * t240;
        let f7_y = MSX7 * t242 - MSY7 * (t233 + t235);
        let f7_z = MSX7 * t245 + MSY7 * t246;
        let n7_x = t273 + MSY7 * a7_z;
        let n7_y = t274 - MSX7 * a7_z;
        let n7_z = t275 + (MSX7 * a7_y - MSY7 * a7_x);
        let t295 = c7 * t278 + s7 * f7_y;
        let t298 = c7 * f7_y - s7 * t278;
        let t307 = c7 * n7_x - s7 * n7_y + k6 * t298;
        let t308 = s7 * n7_x + c7 * n7_y + k6 * t295;
        [f7_z, n7_z, t295, t298, t307, t308]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t363, t366, t375, t376] = {
        let t330 = ZZ6R * dw6_z - XX6R * t204 + XY6 * (t201 - t202) - XZ6 * t212;
        let t332 = YZ6 * (t202 - t203);
        let t333 = YZ6 * t208;
        let t335 = ZZ6R * t206 + XX6R * dw6_x - XY6 * t213 + XZ6 * t210 + t332;
        let t336 = t205 * (XX6R - ZZ6R) + XY6 * t214 + XZ6 * (t203 - t201) - t333;
        let f6_x = MSY6R * t208 - MSX6 * t207 - t295;
        let f6_y = f7_z + (MSX6 * t210 - MSY6R * t211);
        let f6_z = MSX6 * t213 + MSY6R * t214 - t298;
        let n6_x = t307 + (t335 - MSY6R * t175);
        let n6_y = n7_z + (t336 + MSX6 * t175);
        let n6_z = t330 + YZ6 * t209 + (MSX6 * a6_y - MSY6R * a6_x) - t308;
        let t363 = c6 * f6_x - s6 * f6_y;
        let t366 = s6 * f6_x + c6 * f6_y;
        let t375 = c6 * n6_x - s6 * n6_y + k5 * t366;
        let t376 = s6 * n6_x + c6 * n6_y - k5 * t363;
        [f6_z, n6_z, t363, t366, t375, t376]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t431, t434, t443, t444] = {
        let t398 = XX5R * t160 + ZZ5R * dw5_z + XY5 * (t157 - t158) + XZ5 * t168;
        let t400 = YZ5 * (t158 - t159);
        let t401 = YZ5 * t164;
        let t403 = XX5R * dw5_x - ZZ5R * t162 - XY5 * t169 + XZ5 * t166 + t400;
        let t404 = t161 * (XX5R - ZZ5R) + XY5 * t170 + XZ5 * (t159 - t157) + t401;
        let f5_x = t363 - (MSX5 * t163 + MSY5R * t164);
        let f5_y = MSX5 * t166 - MSY5R * t167 - f6_z;
        let f5_z = t366 + (MSX5 * t169 + MSY5R * t170);
        let n5_x = t375 + (t403 + MSY5R * a5_z);
        let n5_y = t404 - MSX5 * a5_z - n6_z;
        let n5_z = t376 + (t398 + YZ5 * t165 + (MSX5 * a5_y - MSY5R * a5_x));
        let t431 = c5 * f5_x - s5 * f5_y;
        let t434 = s5 * f5_x + c5 * f5_y;
        let t443 = c5 * n5_x - s5 * n5_y + k4 * t434;
        let t444 = s5 * n5_x + c5 * n5_y - k4 * t431;
        [f5_z, n5_z, t431, t434, t443, t444]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t499, t502, t511, t512] = {
        let t466 = ZZ4R * dw4_z - XX4R * t116 + XY4 * (t113 - t114) - XZ4 * t124;
        let t468 = YZ4 * (t114 - t115);
        let t469 = YZ4 * t120;
        let t471 = ZZ4R * t118 + XX4R * dw4_x - XY4 * t125 + XZ4 * t122 + t468;
        let t472 = t117 * (XX4R - ZZ4R) + XY4 * t126 + XZ4 * (t115 - t113) - t469;
        let f4_x = t431 + (MSY4R * t120 - MSX4 * t119);
        let f4_y = f5_z + (MSX4 * t122 - MSY4R * t123);
        let f4_z = MSX4 * t125 + MSY4R * t126 - t434;
        let n4_x = t443 + (t471 - MSY4R * t87);
        let n4_y = n5_z + (t472 + MSX4 * t87);
        let n4_z = t466 + YZ4 * t121 + (MSX4 * a4_y - MSY4R * a4_x) - t444;
        let t499 = c4 * f4_x - s4 * f4_y;
        let t502 = s4 * f4_x + c4 * f4_y;
        let t511 = c4 * n4_x - s4 * n4_y + k3 * t502;
        let t512 = s4 * n4_x + c4 * n4_y - k3 * t499;
        [f4_z, n4_z, t499, t502, t511, t512]
    };
    // link 3: force and moment
    let [f3_z, n3_z, t567, t579, t580] = {
        let t534 = XX3R * t72 + ZZ3R * dw3_z + XY3 * (t69 - t70) + XZ3 * t80;
        let t536 = YZ3 * (t70 - t71);
        let t537 = YZ3 * t76;
        let t539 = XX3R * dw3_x - ZZ3R * t74 - XY3 * t81 + XZ3 * t78 + t536;
        let t540 = t73 * (XX3R - ZZ3R) + XY3 * t82 + XZ3 * (t71 - t69) + t537;
        let f3_x = t499 - (MSX3 * t75 + MSY3R * t76);
        let f3_y = MSX3 * t78 - MSY3R * t79 - f4_z;
        let f3_z = t502 + (MSX3 * t81 + MSY3R * t82);
        let n3_x = t511 + (t539 + MSY3R * a3_z);
        let n3_y = t540 - MSX3 * a3_z - n4_z;
        let n3_z = t512 + (t534 + YZ3 * t77 + (MSX3 * a3_y + MSY3R * t47));
        let t567 = c3 * f3_x - s3 * f3_y;
        let t579 = c3 * n3_x - s3 * n3_y + k2 * (s3 * f3_x + c3 * f3_y);
        let t580 = s3 * n3_x + c3 * n3_y - k2 * t567;
        [f3_z, n3_z, t567, t579, t580]
    };
    // link 2: force and moment
    let [n2_z, t636] = {
        let t602 = ZZ2R * ddq2 - XX2R * t32 + XY2 * (t29 - t30) + XZ2 * t2;
        let t604 = YZ2 * (t30 - t31);
        let t605 = YZ2 * t34;
        let t607 = ZZ2R * t13 + XX2R * dw2_x - XY2 * t37 + XZ2 * t35 + t604;
        let t608 = t14 * (XX2R - ZZ2R) + XY2 * t38 + XZ2 * (t31 - t29) - t605;
        let f2_x = t567 + (MSY2R * t34 - MSX2 * t33);
        let f2_y = f3_z + (MSX2 * t35 - MSY2R * t36);
        let n2_x = t579 + (t607 + MSY2R * a2_z);
        let n2_y = n3_z + (t608 - MSX2 * a2_z);
        let n2_z = t602 + YZ2 * t3 + (MSX2 * a2_y + MSY2R * t10) - t580;
        let f1_x = c2 * f2_x - s2 * f2_y;
        let t636 = s2 * n2_x + c2 * n2_y - k1 * f1_x;
        [n2_z, t636]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t636 + ZZ1R * ddq1;
        n1_z
    };
    // drives
    {
        let t674 = FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t675 = FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t676 = FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign());
        let t677 = FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign());
        let t678 = FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign());
        let t679 = FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign());
        let t680 = FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign());
        put(0, t674);
        put(1, t675);
        put(2, t676);
        put(3, t677);
        put(4, t678);
        put(5, t679);
        put(6, t680);
    }
}
