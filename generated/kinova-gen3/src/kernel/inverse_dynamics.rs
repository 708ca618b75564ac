//! Torques from the standard parameters.
//!
//! `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil
//! and Dombre, 9.5.2.
//!
//! 381 multiplications, 378 additions; 7, 7 of 7 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, STANDARD, GRAVITY, Trig};

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
        _, _, _, _, _, _, ZZ1, _, _, _, M2, MSX2,
        MSY2, MSZ2, XX2, YY2, ZZ2, XY2, XZ2, YZ2, M3, MSX3, MSY3, MSZ3,
        XX3, YY3, ZZ3, XY3, XZ3, YZ3, M4, MSX4, MSY4, MSZ4, XX4, YY4,
        ZZ4, XY4, XZ4, YZ4, M5, MSX5, MSY5, MSZ5, XX5, YY5, ZZ5, XY5,
        XZ5, YZ5, M6, MSX6, MSY6, MSZ6, XX6, YY6, ZZ6, XY6, XZ6, YZ6,
        M7, MSX7, MSY7, MSZ7, XX7, YY7, ZZ7, XY7, XZ7, YZ7, FV1, FV2,
        FV3, FV4, FV5, FV6, FV7, FC1, FC2, FC3, FC4, FC5, FC6, FC7,
        FO1, FO2, FO3, FO4, FO5, FO6, FO7,
        ..] = *phi;
    let k0 = S::constant(-GRAVITY[2]);
    let k1 = S::constant(0.01175);
    let k2 = S::constant(0.42076);
    let k3 = S::constant(0.01275);
    let k4 = S::constant(0.31436);
    let k5 = S::constant(0.00035);
    let k6 = S::constant(0.167455);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        a2_z, t6, a2_y, w2_x, w2_y, t11, t12, t14,
        dw2_y, t21, t22, t23, t24, t25,
    ] = {
        let t3 = ddq1 * k1;
        let a2_z = t0 * k1;
        let t6 = s2 * k0 + c2 * t3;
        let a2_y = s2 * t3 - c2 * k0;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t11 = s2 * ddq1;
        let t12 = c2 * ddq1;
        let t13 = w2_x * w2_x;
        let t14 = dq2 * dq2;
        let t15 = w2_x * w2_y;
        let t17 = dq2 * w2_y;
        let dw2_x = t11 + t17;
        let dw2_y = t12 - dq2 * w2_x;
        let t21 = t13 - t14 - t0;
        let t22 = t15 - ddq2;
        let t23 = ddq2 + t15;
        let t24 = t13 + t14;
        let t25 = t17 + dw2_x;
        [
        a2_z, t6, a2_y, w2_x, w2_y, t11, t12, t14,
        dw2_y, t21, t22, t23, t24, t25,
    ]
    };
    // link 3: motion
    let [
        a3_z, t34, a3_y, w3_x, t43, t46, t49, w3_z,
        dw3_z, t54, t55, t56, dw3_x, dw3_y, t59, t60,
        t61, t62, t63, t64, t65,
    ] = {
        let t29 = t6 + t22 * k2;
        let a3_z = a2_y + t24 * k2;
        let t31 = a2_z - t25 * k2;
        let t34 = c3 * t29 + s3 * t31;
        let a3_y = s3 * t29 - c3 * t31;
        let w3_x = c3 * w2_x - s3 * dq2;
        let t43 = c3 * dq2 + s3 * w2_x;
        let t46 = c3 * t22 - s3 * t25;
        let t49 = c3 * t25 + s3 * t22;
        let w3_z = w2_y + dq3;
        let dw3_z = dw2_y + ddq3;
        let t52 = w3_x * w3_x;
        let t53 = w3_z * w3_z;
        let t54 = w3_x * t43;
        let t55 = w3_x * w3_z;
        let t56 = t43 * w3_z;
        let dw3_x = t49 - t56;
        let dw3_y = t46 - t55;
        let t59 = t52 - t53;
        let t60 = t59 - t24;
        let t61 = dw3_z + t54;
        let t62 = dw3_z - t54;
        let t63 = t52 + t53;
        let t64 = t55 - dw3_y;
        let t65 = dw3_x - t56;
        [
        a3_z, t34, a3_y, w3_x, t43, t46, t49, w3_z,
        dw3_z, t54, t55, t56, dw3_x, dw3_y, t59, t60,
        t61, t62, t63, t64, t65,
    ]
    };
    // link 4: motion
    let [
        t70, a4_x, a4_y, w4_x, w4_y, t86, t89, w4_z,
        dw4_z, t94, t95, t96, dw4_x, dw4_y, t99, t100,
        t101, t102, t103, t104, t105,
    ] = {
        let t69 = t34 + t61 * k3;
        let t70 = a3_y - t63 * k3;
        let t71 = a3_z + t65 * k3;
        let a4_x = s4 * t71 - c4 * t69;
        let a4_y = c4 * t71 + s4 * t69;
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t86 = c4 * t61 - s4 * t65;
        let t89 = c4 * t65 + s4 * t61;
        let w4_z = t43 + dq4;
        let dw4_z = ddq4 - dw3_y;
        let t92 = w4_x * w4_x;
        let t93 = w4_z * w4_z;
        let t94 = w4_x * w4_y;
        let t95 = w4_x * w4_z;
        let t96 = w4_y * w4_z;
        let dw4_x = t89 + t96;
        let dw4_y = t86 - t95;
        let t99 = t92 - t93;
        let t100 = t99 - t63;
        let t101 = t94 - dw4_z;
        let t102 = dw4_z + t94;
        let t103 = t92 + t93;
        let t104 = t95 - dw4_y;
        let t105 = t96 + dw4_x;
        [
        t70, a4_x, a4_y, w4_x, w4_y, t86, t89, w4_z,
        dw4_z, t94, t95, t96, dw4_x, dw4_y, t99, t100,
        t101, t102, t103, t104, t105,
    ]
    };
    // link 5: motion
    let [
        a5_z, a5_x, a5_y, w5_x, t123, t126, t129, w5_z,
        dw5_z, t134, t135, t136, dw5_x, dw5_y, t139, t140,
        t141, t142, t143, t144, t145,
    ] = {
        let t109 = a4_x - t101 * k4;
        let a5_z = a4_y + t103 * k4;
        let t111 = t70 + t105 * k4;
        let a5_x = c5 * t109 + s5 * t111;
        let a5_y = c5 * t111 - s5 * t109;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t123 = c5 * w4_z + s5 * w4_x;
        let t126 = c5 * t101 - s5 * t105;
        let t129 = c5 * t105 + s5 * t101;
        let w5_z = w4_y + dq5;
        let dw5_z = dw4_y + ddq5;
        let t132 = w5_x * w5_x;
        let t133 = w5_z * w5_z;
        let t134 = w5_x * t123;
        let t135 = w5_x * w5_z;
        let t136 = t123 * w5_z;
        let dw5_x = t129 - t136;
        let dw5_y = t126 - t135;
        let t139 = t132 - t133;
        let t140 = t139 - t103;
        let t141 = dw5_z + t134;
        let t142 = dw5_z - t134;
        let t143 = t132 + t133;
        let t144 = t135 - dw5_y;
        let t145 = dw5_x - t136;
        [
        a5_z, a5_x, a5_y, w5_x, t123, t126, t129, w5_z,
        dw5_z, t134, t135, t136, dw5_x, dw5_y, t139, t140,
        t141, t142, t143, t144, t145,
    ]
    };
    // link 6: motion
    let [
        t150, a6_x, a6_y, w6_x, w6_y, t166, t169, w6_z,
        dw6_z, t174, t175, t176, dw6_x, dw6_y, t179, t180,
        t181, t182, t183, t184, t185,
    ] = {
        let t149 = a5_x - t141 * k5;
        let t150 = a5_y - t143 * k5;
        let t151 = a5_z + t145 * k5;
        let a6_x = c6 * t149 + s6 * t151;
        let a6_y = c6 * t151 - s6 * t149;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t166 = c6 * t141 - s6 * t145;
        let t169 = c6 * t145 + s6 * t141;
        let w6_z = t123 + dq6;
        let dw6_z = ddq6 - dw5_y;
        let t172 = w6_x * w6_x;
        let t173 = w6_z * w6_z;
        let t174 = w6_x * w6_y;
        let t175 = w6_x * w6_z;
        let t176 = w6_y * w6_z;
        let dw6_x = t169 + t176;
        let dw6_y = t166 - t175;
        let t179 = t172 - t173;
        let t180 = t179 - t143;
        let t181 = t174 - dw6_z;
        let t182 = dw6_z + t174;
        let t183 = t172 + t173;
        let t184 = t175 - dw6_y;
        let t185 = t176 + dw6_x;
        [
        t150, a6_x, a6_y, w6_x, w6_y, t166, t169, w6_z,
        dw6_z, t174, t175, t176, dw6_x, dw6_y, t179, t180,
        t181, t182, t183, t184, t185,
    ]
    };
    // link 7: motion
    let [
        a7_z, a7_x, a7_y, t206, t209, dw7_z, t214, t215,
        t216, dw7_x, dw7_y, t219, t220, t221, t222, t223,
        t224, t225,
    ] = {
        let t189 = a6_x - t181 * k6;
        let a7_z = a6_y + t183 * k6;
        let t191 = t150 + t185 * k6;
        let a7_x = c7 * t189 + s7 * t191;
        let a7_y = c7 * t191 - s7 * t189;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t203 = c7 * w6_z + s7 * w6_x;
        let t206 = c7 * t181 - s7 * t185;
        let t209 = c7 * t185 + s7 * t181;
        let w7_z = w6_y + dq7;
        let dw7_z = dw6_y + ddq7;
        let t212 = w7_x * w7_x;
        let t213 = w7_z * w7_z;
        let t214 = w7_x * t203;
        let t215 = w7_x * w7_z;
        let t216 = t203 * w7_z;
        let dw7_x = t209 - t216;
        let dw7_y = t206 - t215;
        let t219 = t212 - t213;
        let t220 = t219 - t183;
        let t221 = dw7_z + t214;
        let t222 = dw7_z - t214;
        let t223 = t212 + t213;
        let t224 = t215 - dw7_y;
        let t225 = dw7_x - t216;
        [
        a7_z, a7_x, a7_y, t206, t209, dw7_z, t214, t215,
        t216, dw7_x, dw7_y, t219, t220, t221, t222, t223,
        t224, t225,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t293, t296, t305, t306] = {
        let t247 = XZ7 * t209;
        let t248 = XX7 * dw7_x - t216 * (ZZ7 - YY7) - XY7 * t224 + XZ7 * t222;
        let t249 = t215 * (XX7 - ZZ7) + YY7 * dw7_y + XY7 * t225 - XZ7 * t219;
        let t250 = ZZ7 * dw7_z - t214 * (YY7 - XX7) + XY7 * (t220 + t223) + t247;
        let f7_x = M7 * a7_x + (MSZ7 * t206 + (MSX7 * t220 - MSY7 * t221));
        let f7_y = M7 * a7_y + (MSX7 * t222 - MSY7 * t223 - MSZ7 * t209);
        let f7_z = M7 * a7_z + (MSX7 * t224 + MSY7 * t225 - MSZ7 * t183);
        let n7_x = t248 + YZ7 * (t183 - t223) + (MSY7 * a7_z - MSZ7 * a7_y);
        let n7_y = t249 + YZ7 * t221 + (MSZ7 * a7_x - MSX7 * a7_z);
        let n7_z = t250 + YZ7 * t206 + (MSX7 * a7_y - MSY7 * a7_x);
        let t293 = c7 * f7_x - s7 * f7_y;
        let t296 = s7 * f7_x + c7 * f7_y;
        let t305 = c7 * n7_x - s7 * n7_y + k6 * t296;
        let t306 = s7 * n7_x + c7 * n7_y - k6 * t293;
        [f7_z, n7_z, t293, t296, t305, t306]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t380, t383, t392, t393] = {
        let t328 = XZ6 * t169;
        let t329 = t176 * (ZZ6 - YY6) + XX6 * dw6_x - XY6 * t184 + XZ6 * t182;
        let t330 = t175 * (XX6 - ZZ6) + YY6 * dw6_y + XY6 * t185 - XZ6 * t179;
        let t331 = t174 * (YY6 - XX6) + ZZ6 * dw6_z + XY6 * (t180 + t183) + t328;
        let f6_x = t293 + (M6 * a6_x + (MSZ6 * t166 + (MSX6 * t180 + MSY6 * t181)));
        let f6_y = f7_z + (M6 * a6_y + (MSX6 * t182 - MSY6 * t183 - MSZ6 * t169));
        let f6_z = MSX6 * t184 + MSY6 * t185 - MSZ6 * t143 - M6 * t150 - t296;
        let n6_x = t305 + (t329 + YZ6 * (t143 - t183) - (MSY6 * t150 + MSZ6 * a6_y));
        let n6_y = n7_z + (t330 - YZ6 * t181 + (MSZ6 * a6_x + MSX6 * t150));
        let n6_z = t331 + YZ6 * t166 + (MSX6 * a6_y - MSY6 * a6_x) - t306;
        let t380 = c6 * f6_x - s6 * f6_y;
        let t383 = s6 * f6_x + c6 * f6_y;
        let t392 = c6 * n6_x - s6 * n6_y + k5 * t383;
        let t393 = s6 * n6_x + c6 * n6_y - k5 * t380;
        [f6_z, n6_z, t380, t383, t392, t393]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t467, t470, t479, t480] = {
        let t415 = XZ5 * t129;
        let t416 = XX5 * dw5_x - t136 * (ZZ5 - YY5) - XY5 * t144 + XZ5 * t142;
        let t417 = t135 * (XX5 - ZZ5) + YY5 * dw5_y + XY5 * t145 - XZ5 * t139;
        let t418 = ZZ5 * dw5_z - t134 * (YY5 - XX5) + XY5 * (t140 + t143) + t415;
        let f5_x = t380 + (M5 * a5_x + (MSZ5 * t126 + (MSX5 * t140 - MSY5 * t141)));
        let f5_y = M5 * a5_y + (MSX5 * t142 - MSY5 * t143 - MSZ5 * t129) - f6_z;
        let f5_z = t383 + (M5 * a5_z + (MSX5 * t144 + MSY5 * t145 - MSZ5 * t103));
        let n5_x = t392 + (t416 + YZ5 * (t103 - t143) + (MSY5 * a5_z - MSZ5 * a5_y));
        let n5_y = t417 + YZ5 * t141 + (MSZ5 * a5_x - MSX5 * a5_z) - n6_z;
        let n5_z = t393 + (t418 + YZ5 * t126 + (MSX5 * a5_y - MSY5 * a5_x));
        let t467 = c5 * f5_x - s5 * f5_y;
        let t470 = s5 * f5_x + c5 * f5_y;
        let t479 = c5 * n5_x - s5 * n5_y + k4 * t470;
        let t480 = s5 * n5_x + c5 * n5_y - k4 * t467;
        [f5_z, n5_z, t467, t470, t479, t480]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t554, t557, t566, t567] = {
        let t502 = XZ4 * t89;
        let t503 = t96 * (ZZ4 - YY4) + XX4 * dw4_x - XY4 * t104 + XZ4 * t102;
        let t504 = t95 * (XX4 - ZZ4) + YY4 * dw4_y + XY4 * t105 - XZ4 * t99;
        let t505 = t94 * (YY4 - XX4) + ZZ4 * dw4_z + XY4 * (t100 + t103) + t502;
        let f4_x = t467 + (M4 * a4_x + (MSZ4 * t86 + (MSX4 * t100 + MSY4 * t101)));
        let f4_y = f5_z + (M4 * a4_y + (MSX4 * t102 - MSY4 * t103 - MSZ4 * t89));
        let f4_z = MSX4 * t104 + MSY4 * t105 - MSZ4 * t63 - M4 * t70 - t470;
        let n4_x = t479 + (t503 + YZ4 * (t63 - t103) - (MSY4 * t70 + MSZ4 * a4_y));
        let n4_y = n5_z + (t504 - YZ4 * t101 + (MSZ4 * a4_x + MSX4 * t70));
        let n4_z = t505 + YZ4 * t86 + (MSX4 * a4_y - MSY4 * a4_x) - t480;
        let t554 = c4 * f4_x - s4 * f4_y;
        let t557 = s4 * f4_x + c4 * f4_y;
        let t566 = c4 * n4_x - s4 * n4_y + k3 * t557;
        let t567 = s4 * n4_x + c4 * n4_y - k3 * t554;
        [f4_z, n4_z, t554, t557, t566, t567]
    };
    // link 3: force and moment
    let [f3_z, n3_z, t641, t653, t654] = {
        let t589 = XZ3 * t49;
        let t590 = XX3 * dw3_x - t56 * (ZZ3 - YY3) - XY3 * t64 + XZ3 * t62;
        let t591 = t55 * (XX3 - ZZ3) + YY3 * dw3_y + XY3 * t65 - XZ3 * t59;
        let t592 = ZZ3 * dw3_z - t54 * (YY3 - XX3) + XY3 * (t60 + t63) + t589;
        let f3_x = t554 + (MSZ3 * t46 + (MSX3 * t60 - MSY3 * t61) - M3 * t34);
        let f3_y = M3 * a3_y + (MSX3 * t62 - MSY3 * t63 - MSZ3 * t49) - f4_z;
        let f3_z = t557 + (M3 * a3_z + (MSX3 * t64 + MSY3 * t65 - MSZ3 * t24));
        let n3_x = t566 + (t590 + YZ3 * (t24 - t63) + (MSY3 * a3_z - MSZ3 * a3_y));
        let n3_y = t591 + YZ3 * t61 - (MSZ3 * t34 + MSX3 * a3_z) - n4_z;
        let n3_z = t567 + (t592 + YZ3 * t46 + (MSX3 * a3_y + MSY3 * t34));
        let t641 = c3 * f3_x - s3 * f3_y;
        let t653 = c3 * n3_x - s3 * n3_y + k2 * (s3 * f3_x + c3 * f3_y);
        let t654 = s3 * n3_x + c3 * n3_y - k2 * t641;
        [f3_z, n3_z, t641, t653, t654]
    };
    // link 2: force and moment
    let [t678, n2_z, t720] = {
        let t659 = s2 * (XX2 - YY2) + c2 * (XY2 + XY2);
        let t661 = c2 * t659 - XY2;
        let t664 = s2 * XZ2 + c2 * YZ2;
        let t677 = ddq2 * t664 + t14 * (c2 * XZ2 - s2 * YZ2);
        let t678 = t11 * t659 + YY2 * ddq1 + (t661 + t661) * (dq1 * dq2) + t677;
        let f2_x = t641 + (MSZ2 * t12 + (MSX2 * t21 + MSY2 * t22) - M2 * t6);
        let f2_y = f3_z + (M2 * a2_y + (MSX2 * t23 - MSY2 * t24 - MSZ2 * t11));
        let n2_x = t653 + (MSY2 * a2_z - MSZ2 * a2_y);
        let n2_y = n3_z - (MSZ2 * t6 + MSX2 * a2_z);
        let t711 = MSX2 * a2_y + MSY2 * t6 - t654;
        let n2_z = ZZ2 * ddq2 + ddq1 * t664 - t0 * t661 + t711;
        let t720 = s2 * n2_x + c2 * n2_y - k1 * (c2 * f2_x - s2 * f2_y);
        [t678, n2_z, t720]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t678 + (t720 + ZZ1 * ddq1);
        n1_z
    };
    // drives
    {
        let t759 = FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t760 = FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t761 = FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign());
        let t762 = FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign());
        let t763 = FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign());
        let t764 = FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign());
        let t765 = FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign());
        put(0, t759);
        put(1, t760);
        put(2, t761);
        put(3, t762);
        put(4, t763);
        put(5, t764);
        put(6, t765);
    }
}
