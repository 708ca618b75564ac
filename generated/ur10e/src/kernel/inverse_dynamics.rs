//! Torques from the standard parameters.
//!
//! `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil and Dombre, 9.5.2.
//!
//! 307 multiplications, 312 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, STANDARD, Trig};

/// Torques from the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], out: &mut [S; 6]) {
    entries(trig, dq, ddq, phi, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], mut put: impl FnMut(usize, S)) {
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
    let D4 = S::constant(0.17415);
    let D5 = S::constant(0.11985);
    let D6 = S::constant(0.11655);
    let k0 = S::constant(9.81);
    let k1 = S::constant(0.6127);
    let k2 = S::constant(0.57155);
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
        w3_x, w3_y, t29, a3_x, a3_y, t40, t43, w3_z,
        dw3_z, t48, t49, t50, dw3_x, dw3_y, t53, t54,
        t55, t56, t57, t58, t59,
    ] = {
        let w3_x = c3 * w2_x + s3 * w2_y;
        let w3_y = c3 * w2_y - s3 * w2_x;
        let t29 = t19 * k1;
        let t30 = a2_x - t15 * k1;
        let t31 = a2_y - t17 * k1;
        let a3_x = c3 * t30 + s3 * t31;
        let a3_y = c3 * t31 - s3 * t30;
        let t40 = c3 * t4 - s3 * t3;
        let t43 = c3 * t3 + s3 * t4;
        let w3_z = dq2 + dq3;
        let dw3_z = ddq2 + ddq3;
        let t46 = w3_x * w3_x;
        let t47 = w3_z * w3_z;
        let t48 = w3_x * w3_y;
        let t49 = w3_x * w3_z;
        let t50 = w3_y * w3_z;
        let dw3_x = t43 + t50;
        let dw3_y = t40 - t49;
        let t53 = t46 - t47;
        let t54 = t53 - t0;
        let t55 = t48 - dw3_z;
        let t56 = dw3_z + t48;
        let t57 = t46 + t47;
        let t58 = t49 - dw3_y;
        let t59 = t50 + dw3_x;
        [
        w3_x, w3_y, t29, a3_x, a3_y, t40, t43, w3_z,
        dw3_z, t48, t49, t50, dw3_x, dw3_y, t53, t54,
        t55, t56, t57, t58, t59,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t77, a4_x, a4_y, t86, t89, w4_z,
        dw4_z, t94, t95, t96, dw4_x, dw4_y, t99, t100,
        t101, t102, t103, t104, t105,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_y;
        let w4_y = c4 * w3_y - s4 * w3_x;
        let t75 = a3_x + (D4 * t40 - t54 * k2);
        let t76 = a3_y - (t56 * k2 + D4 * t43);
        let t77 = t29 + (t58 * k2 + D4 * t0);
        let a4_x = c4 * t75 + s4 * t76;
        let a4_y = c4 * t76 - s4 * t75;
        let t86 = c4 * t40 - s4 * t43;
        let t89 = c4 * t43 + s4 * t40;
        let w4_z = w3_z + dq4;
        let dw4_z = dw3_z + ddq4;
        let t92 = w4_x * w4_x;
        let t93 = w4_z * w4_z;
        let t94 = w4_x * w4_y;
        let t95 = w4_x * w4_z;
        let t96 = w4_y * w4_z;
        let dw4_x = t89 + t96;
        let dw4_y = t86 - t95;
        let t99 = t92 - t93;
        let t100 = t99 - t0;
        let t101 = t94 - dw4_z;
        let t102 = dw4_z + t94;
        let t103 = t92 + t93;
        let t104 = t95 - dw4_y;
        let t105 = t96 + dw4_x;
        [
        w4_x, w4_y, t77, a4_x, a4_y, t86, t89, w4_z,
        dw4_z, t94, t95, t96, dw4_x, dw4_y, t99, t100,
        t101, t102, t103, t104, t105,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t116, a5_x, t123, t126, t129, w5_z,
        dw5_z, t134, t135, t136, dw5_x, t138, t139, t140,
        t141, t142, t143, t144, t145,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t115 = a4_x - D5 * t101;
        let t116 = a4_y + D5 * t103;
        let t117 = t77 + D5 * t105;
        let a5_x = c5 * t115 - s5 * t117;
        let t123 = c5 * t117 + s5 * t115;
        let t126 = c5 * t101 + s5 * t105;
        let t129 = s5 * t101 - c5 * t105;
        let w5_z = dq5 - w4_y;
        let dw5_z = ddq5 - dw4_y;
        let t132 = w5_x * w5_x;
        let t133 = w5_z * w5_z;
        let t134 = w5_x * w5_y;
        let t135 = w5_x * w5_z;
        let t136 = w5_y * w5_z;
        let dw5_x = t136 - t129;
        let t138 = t126 + t135;
        let t139 = t132 - t133;
        let t140 = t139 - t103;
        let t141 = t134 - dw5_z;
        let t142 = dw5_z + t134;
        let t143 = t132 + t133;
        let t144 = t135 + t138;
        let t145 = t136 + dw5_x;
        [
        w5_x, w5_y, t116, a5_x, t123, t126, t129, w5_z,
        dw5_z, t134, t135, t136, dw5_x, t138, t139, t140,
        t141, t142, t143, t144, t145,
    ]
    };
    // link 6: motion
    let [
        t156, a6_x, t163, t166, t169, dw6_z, t174, t175,
        t176, dw6_x, dw6_y, t179, t180, t181, t182, t183,
        t184, t185,
    ] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t151 = c6 * w5_z + s6 * w5_x;
        let t155 = a5_x + D6 * t141;
        let t156 = t123 + D6 * t143;
        let t157 = D6 * t145 - t116;
        let a6_x = c6 * t155 - s6 * t157;
        let t163 = c6 * t157 + s6 * t155;
        let t166 = c6 * t141 - s6 * t145;
        let t169 = c6 * t145 + s6 * t141;
        let w6_z = w5_y + dq6;
        let dw6_z = ddq6 - t138;
        let t172 = w6_x * w6_x;
        let t173 = w6_z * w6_z;
        let t174 = w6_x * t151;
        let t175 = w6_x * w6_z;
        let t176 = t151 * w6_z;
        let dw6_x = t169 - t176;
        let dw6_y = t166 - t175;
        let t179 = t172 - t173;
        let t180 = t179 - t143;
        let t181 = dw6_z + t174;
        let t182 = dw6_z - t174;
        let t183 = t172 + t173;
        let t184 = t175 - dw6_y;
        let t185 = dw6_x - t176;
        [
        t156, a6_x, t163, t166, t169, dw6_z, t174, t175,
        t176, dw6_x, dw6_y, t179, t180, t181, t182, t183,
        t184, t185,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t253, t256, t265, t266] = {
        let t207 = XZ6 * t169;
        let t208 = XX6 * dw6_x - t176 * (ZZ6 - YY6) - XY6 * t184 + XZ6 * t182;
        let t209 = t175 * (XX6 - ZZ6) + YY6 * dw6_y + XY6 * t185 - XZ6 * t179;
        let t210 = ZZ6 * dw6_z - t174 * (YY6 - XX6) + XY6 * (t180 + t183) + t207;
        let f6_x = M6 * a6_x + (MSZ6 * t166 + (MSX6 * t180 - MSY6 * t181));
        let f6_y = MSX6 * t182 - MSY6 * t183 - MSZ6 * t169 - M6 * t163;
        let f6_z = MSX6 * t184 + MSY6 * t185 - MSZ6 * t143 - M6 * t156;
        let n6_x = t208 + YZ6 * (t143 - t183) + (MSZ6 * t163 - MSY6 * t156);
        let n6_y = t209 + YZ6 * t181 + (MSZ6 * a6_x + MSX6 * t156);
        let n6_z = t210 + YZ6 * t166 - (MSX6 * t163 + MSY6 * a6_x);
        let t253 = c6 * f6_x - s6 * f6_y;
        let t256 = s6 * f6_x + c6 * f6_y;
        let t265 = c6 * n6_x - s6 * n6_y - D6 * t256;
        let t266 = s6 * n6_x + c6 * n6_y + D6 * t253;
        [f6_z, n6_z, t253, t256, t265, t266]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t340, t343, t352, t353] = {
        let t288 = XZ5 * t129;
        let t289 = t136 * (ZZ5 - YY5) + XX5 * dw5_x - XY5 * t144 + XZ5 * t142;
        let t290 = t135 * (XX5 - ZZ5) - YY5 * t138 + XY5 * t145 - XZ5 * t139;
        let t291 = t134 * (YY5 - XX5) + ZZ5 * dw5_z + XY5 * (t140 + t143) - t288;
        let f5_x = t253 + (M5 * a5_x + (MSX5 * t140 + MSY5 * t141 - MSZ5 * t126));
        let f5_y = f6_z + (MSZ5 * t129 + (MSX5 * t142 - MSY5 * t143) - M5 * t123);
        let f5_z = MSX5 * t144 + MSY5 * t145 - MSZ5 * t103 - M5 * t116 - t256;
        let n5_x = t265 + (t289 + YZ5 * (t103 - t143) + (MSZ5 * t123 - MSY5 * t116));
        let n5_y = n6_z + (t290 - YZ5 * t141 + (MSZ5 * a5_x + MSX5 * t116));
        let n5_z = t291 - YZ5 * t126 - (MSX5 * t123 + MSY5 * a5_x) - t266;
        let t340 = c5 * f5_x - s5 * f5_y;
        let t343 = s5 * f5_x + c5 * f5_y;
        let t352 = c5 * n5_x - s5 * n5_y - D5 * t343;
        let t353 = s5 * n5_x + c5 * n5_y + D5 * t340;
        [f5_z, n5_z, t340, t343, t352, t353]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t427, t430, t442, t443, t444] = {
        let t375 = XZ4 * t89;
        let t376 = t96 * (ZZ4 - YY4) + XX4 * dw4_x - XY4 * t104 + XZ4 * t102;
        let t377 = t95 * (XX4 - ZZ4) + YY4 * dw4_y + XY4 * t105 - XZ4 * t99;
        let t378 = t94 * (YY4 - XX4) + ZZ4 * dw4_z + XY4 * (t100 + t103) + t375;
        let f4_x = t340 + (M4 * a4_x + (MSZ4 * t86 + (MSX4 * t100 + MSY4 * t101)));
        let f4_y = M4 * a4_y + (MSX4 * t102 - MSY4 * t103 - MSZ4 * t89) - f5_z;
        let f4_z = t343 + (MSX4 * t104 + MSY4 * t105 - MSZ4 * t0 - M4 * t77);
        let n4_x = t352 + (t376 + YZ4 * (t0 - t103) - (MSY4 * t77 + MSZ4 * a4_y));
        let n4_y = t377 - YZ4 * t101 + (MSZ4 * a4_x + MSX4 * t77) - n5_z;
        let n4_z = t353 + (t378 + YZ4 * t86 + (MSX4 * a4_y - MSY4 * a4_x));
        let t427 = c4 * f4_x - s4 * f4_y;
        let t430 = s4 * f4_x + c4 * f4_y;
        let t442 = c4 * n4_x - s4 * n4_y - D4 * t430;
        let t443 = s4 * n4_x + c4 * n4_y + (D4 * t427 + k2 * f4_z);
        let t444 = n4_z - k2 * t430;
        [f4_z, n4_z, t427, t430, t442, t443, t444]
    };
    // link 3: force and moment
    let [n3_z, t521, t527, t528] = {
        let t466 = XZ3 * t43;
        let t467 = t50 * (ZZ3 - YY3) + XX3 * dw3_x - XY3 * t58 + XZ3 * t56;
        let t468 = t49 * (XX3 - ZZ3) + YY3 * dw3_y + XY3 * t59 - XZ3 * t53;
        let t469 = t48 * (YY3 - XX3) + ZZ3 * dw3_z + XY3 * (t54 + t57) + t466;
        let f3_x = t427 + (M3 * a3_x + (MSZ3 * t40 + (MSX3 * t54 + MSY3 * t55)));
        let f3_y = t430 + (M3 * a3_y + (MSX3 * t56 - MSY3 * t57 - MSZ3 * t43));
        let f3_z = f4_z + (MSX3 * t58 + MSY3 * t59 - MSZ3 * t0 - M3 * t29);
        let n3_x = t442 + (t467 + YZ3 * (t0 - t57) - (MSY3 * t29 + MSZ3 * a3_y));
        let n3_y = t443 + (t468 - YZ3 * t55 + (MSZ3 * a3_x + MSX3 * t29));
        let n3_z = t444 + (t469 + YZ3 * t40 + (MSX3 * a3_y - MSY3 * a3_x));
        let t521 = c3 * n3_x - s3 * n3_y;
        let t527 = s3 * n3_x + c3 * n3_y + k1 * f3_z;
        let t528 = n3_z - k1 * (s3 * f3_x + c3 * f3_y);
        [n3_z, t521, t527, t528]
    };
    // link 2: force and moment
    let [n2_z, t574] = {
        let t550 = XZ2 * t3;
        let t551 = t11 * (ZZ2 - YY2) + XX2 * dw2_x - XY2 * t19 + XZ2 * t17;
        let t552 = t10 * (XX2 - ZZ2) + YY2 * dw2_y + XY2 * t20 - XZ2 * t14;
        let t553 = t9 * (YY2 - XX2) + ZZ2 * ddq2 + XY2 * (t15 + t18) + t550;
        let n2_x = t521 + (t551 + YZ2 * (t0 - t18) - MSZ2 * a2_y);
        let n2_y = t527 + (t552 - YZ2 * t16 + MSZ2 * a2_x);
        let n2_z = t528 + (t553 + YZ2 * t4 + (MSX2 * a2_y - MSY2 * a2_x));
        let t574 = s2 * n2_x + c2 * n2_y;
        [n2_z, t574]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t574 + ZZ1 * ddq1;
        n1_z
    };
    // drives
    {
        let t619 = FO1 + (n1_z + IA1 * ddq1 + FV1 * dq1 + FC1 * dq1.sign());
        let t620 = FO2 + (n2_z + IA2 * ddq2 + FV2 * dq2 + FC2 * dq2.sign());
        let t621 = FO3 + (n3_z + IA3 * ddq3 + FV3 * dq3 + FC3 * dq3.sign());
        let t622 = FO4 + (n4_z + IA4 * ddq4 + FV4 * dq4 + FC4 * dq4.sign());
        let t623 = FO5 + (n5_z + IA5 * ddq5 + FV5 * dq5 + FC5 * dq5.sign());
        let t624 = FO6 + (n6_z + IA6 * ddq6 + FV6 * dq6 + FC6 * dq6.sign());
        put(0, t619);
        put(1, t620);
        put(2, t621);
        put(3, t622);
        put(4, t623);
        put(5, t624);
    }
}
