//! Torques from the standard parameters.
//!
//! `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil and Dombre, 9.5.2.
//!
//! 319 multiplications, 323 additions; 6, 6 of 6 structurally nonzero.

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
    // link 2: motion
    let [
        w2_x, w2_y, t2, t3, a2_x, a2_y, t6, t7,
        dw2_x, dw2_y,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t2 = s2 * ddq1;
        let t3 = c2 * ddq1;
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let t6 = dq2 * w2_y;
        let t7 = dq2 * w2_x;
        let dw2_x = t2 + t6;
        let dw2_y = t3 - t7;
        [
        w2_x, w2_y, t2, t3, a2_x, a2_y, t6, t7,
        dw2_x, dw2_y,
    ]
    };
    // link 3: motion
    let [
        w3_x, w3_y, t22, t23, t24, t25, t27, t28,
        t29, t30, t33, a3_x, a3_y, w3_z, dw3_x, dw3_y,
        dw3_z,
    ] = {
        let w3_x = c3 * w2_x + s3 * w2_y;
        let w3_y = c3 * w2_y - s3 * w2_x;
        let t22 = w2_x * w2_x;
        let t23 = w2_y * w2_y;
        let t24 = dq2 * dq2;
        let t25 = w2_x * w2_y;
        let t27 = t25 - ddq2;
        let t28 = ddq2 + t25;
        let t29 = t7 - dw2_y;
        let t30 = t6 + dw2_x;
        let t33 = t29 * k1;
        let t34 = a2_x + (t23 + t24) * k1;
        let t35 = a2_y - t28 * k1;
        let a3_x = c3 * t34 + s3 * t35;
        let a3_y = c3 * t35 - s3 * t34;
        let w3_z = dq2 + dq3;
        let dw3_x = c3 * dw2_x + s3 * dw2_y + dq3 * w3_y;
        let dw3_y = c3 * dw2_y - s3 * dw2_x - dq3 * w3_x;
        let dw3_z = ddq2 + ddq3;
        [
        w3_x, w3_y, t22, t23, t24, t25, t27, t28,
        t29, t30, t33, a3_x, a3_y, w3_z, dw3_x, dw3_y,
        dw3_z,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t60, t61, t62, t63, t64, t65,
        t66, t67, t68, t69, t70, t71, t72, t73,
        t74, t86, a4_x, a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_y;
        let w4_y = c4 * w3_y - s4 * w3_x;
        let t60 = w3_x * w3_x;
        let t61 = w3_y * w3_y;
        let t62 = w3_z * w3_z;
        let t63 = w3_x * w3_y;
        let t64 = w3_x * w3_z;
        let t65 = w3_y * w3_z;
        let t66 = t61 + t62;
        let t67 = t63 - dw3_z;
        let t68 = dw3_y + t64;
        let t69 = dw3_z + t63;
        let t70 = t60 + t62;
        let t71 = t65 - dw3_x;
        let t72 = t64 - dw3_y;
        let t73 = dw3_x + t65;
        let t74 = t60 + t61;
        let t84 = a3_x + (t66 * k2 + D4 * t68);
        let t85 = a3_y + (D4 * t71 - t69 * k2);
        let t86 = t33 + (t72 * k2 + D4 * t74);
        let a4_x = c4 * t84 + s4 * t85;
        let a4_y = c4 * t85 - s4 * t84;
        let w4_z = w3_z + dq4;
        let dw4_x = c4 * dw3_x + s4 * dw3_y + dq4 * w4_y;
        let dw4_y = c4 * dw3_y - s4 * dw3_x - dq4 * w4_x;
        let dw4_z = dw3_z + ddq4;
        [
        w4_x, w4_y, t60, t61, t62, t63, t64, t65,
        t66, t67, t68, t69, t70, t71, t72, t73,
        t74, t86, a4_x, a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t111, t112, t113, t114, t115, t116,
        t117, t118, t119, t120, t121, t122, t123, t124,
        t125, t130, a5_x, t137, w5_z, dw5_x, dw5_y, dw5_z,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t111 = w4_x * w4_x;
        let t112 = w4_y * w4_y;
        let t113 = w4_z * w4_z;
        let t114 = w4_x * w4_y;
        let t115 = w4_x * w4_z;
        let t116 = w4_y * w4_z;
        let t117 = t112 + t113;
        let t118 = t114 - dw4_z;
        let t119 = dw4_y + t115;
        let t120 = dw4_z + t114;
        let t121 = t111 + t113;
        let t122 = t116 - dw4_x;
        let t123 = t115 - dw4_y;
        let t124 = dw4_x + t116;
        let t125 = t111 + t112;
        let t129 = a4_x - D5 * t118;
        let t130 = a4_y + D5 * t121;
        let t131 = t86 + D5 * t124;
        let a5_x = c5 * t129 - s5 * t131;
        let t137 = c5 * t131 + s5 * t129;
        let w5_z = dq5 - w4_y;
        let dw5_x = c5 * dw4_x + s5 * dw4_z + dq5 * w5_y;
        let dw5_y = c5 * dw4_z - s5 * dw4_x - dq5 * w5_x;
        let dw5_z = ddq5 - dw4_y;
        [
        w5_x, w5_y, t111, t112, t113, t114, t115, t116,
        t117, t118, t119, t120, t121, t122, t123, t124,
        t125, t130, a5_x, t137, w5_z, dw5_x, dw5_y, dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, t149, t156, t157, t158, t159, t160, t161,
        t162, t163, t164, t165, t166, t167, t168, t169,
        t170, t175, a6_x, t182, w6_z, dw6_x, t187, dw6_z,
    ] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t149 = c6 * w5_z + s6 * w5_x;
        let t156 = w5_x * w5_x;
        let t157 = w5_y * w5_y;
        let t158 = w5_z * w5_z;
        let t159 = w5_x * w5_y;
        let t160 = w5_x * w5_z;
        let t161 = w5_y * w5_z;
        let t162 = t157 + t158;
        let t163 = t159 - dw5_z;
        let t164 = dw5_y + t160;
        let t165 = dw5_z + t159;
        let t166 = t156 + t158;
        let t167 = t161 - dw5_x;
        let t168 = t160 - dw5_y;
        let t169 = dw5_x + t161;
        let t170 = t156 + t157;
        let t174 = a5_x + D6 * t163;
        let t175 = t137 + D6 * t166;
        let t176 = D6 * t169 - t130;
        let a6_x = c6 * t174 - s6 * t176;
        let t182 = c6 * t176 + s6 * t174;
        let w6_z = w5_y + dq6;
        let dw6_x = c6 * dw5_x - s6 * dw5_z - dq6 * t149;
        let t187 = c6 * dw5_z + s6 * dw5_x + dq6 * w6_x;
        let dw6_z = dw5_y + ddq6;
        [
        w6_x, t149, t156, t157, t158, t159, t160, t161,
        t162, t163, t164, t165, t166, t167, t168, t169,
        t170, t175, a6_x, t182, w6_z, dw6_x, t187, dw6_z,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t272, t275, t284, t285] = {
        let t189 = w6_x * w6_x;
        let t190 = t149 * t149;
        let t191 = w6_z * w6_z;
        let t192 = w6_x * t149;
        let t193 = w6_x * w6_z;
        let t194 = t149 * w6_z;
        let t196 = dw6_z + t192;
        let t197 = t193 - t187;
        let t198 = dw6_z - t192;
        let t200 = dw6_x + t194;
        let t201 = t187 + t193;
        let t202 = dw6_x - t194;
        let t225 = XZ6 * (t191 - t189);
        let t226 = XZ6 * t200;
        let t227 = XX6 * dw6_x - t194 * (ZZ6 - YY6) - XY6 * t201 + XZ6 * t198;
        let t229 = ZZ6 * dw6_z - t192 * (YY6 - XX6) + XY6 * (t189 - t190) + t226;
        let t232 = YZ6 * t196;
        let t235 = t193 * (XX6 - ZZ6) - YY6 * t187 + XY6 * t202 + t225 + t232;
        let f6_x = M6 * a6_x + (MSZ6 * t197 - (MSX6 * (t190 + t191) + MSY6 * t196));
        let f6_y = MSX6 * t198 - MSY6 * (t189 + t191) - MSZ6 * t200 - M6 * t182;
        let f6_z = MSX6 * t201 + MSY6 * t202 - MSZ6 * (t189 + t190) - M6 * t175;
        let n6_x = t227 + YZ6 * (t190 - t191) + (MSZ6 * t182 - MSY6 * t175);
        let n6_y = t235 + (MSZ6 * a6_x + MSX6 * t175);
        let n6_z = t229 + YZ6 * t197 - (MSX6 * t182 + MSY6 * a6_x);
        let t272 = c6 * f6_x - s6 * f6_y;
        let t275 = s6 * f6_x + c6 * f6_y;
        let t284 = c6 * n6_x - s6 * n6_y - D6 * t275;
        let t285 = s6 * n6_x + c6 * n6_y + D6 * t272;
        [f6_z, n6_z, t272, t275, t284, t285]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t360, t363, t372, t373] = {
        let t307 = XZ5 * (t158 - t156);
        let t308 = XZ5 * t167;
        let t309 = t161 * (ZZ5 - YY5) + XX5 * dw5_x - XY5 * t168 + XZ5 * t165;
        let t311 = t159 * (YY5 - XX5) + ZZ5 * dw5_z + XY5 * (t156 - t157) - t308;
        let t314 = YZ5 * t163;
        let t317 = t160 * (XX5 - ZZ5) + YY5 * dw5_y + XY5 * t169 + t307 - t314;
        let f5_x = t272 + (M5 * a5_x + (MSZ5 * t164 + (MSY5 * t163 - MSX5 * t162)));
        let f5_y = f6_z + (MSZ5 * t167 + (MSX5 * t165 - MSY5 * t166) - M5 * t137);
        let f5_z = MSX5 * t168 + MSY5 * t169 - MSZ5 * t170 - M5 * t130 - t275;
        let n5_x = t284 + (t309 + YZ5 * (t157 - t158) + (MSZ5 * t137 - MSY5 * t130));
        let n5_y = n6_z + (t317 + (MSZ5 * a5_x + MSX5 * t130));
        let n5_z = t311 + YZ5 * t164 - (MSX5 * t137 + MSY5 * a5_x) - t285;
        let t360 = c5 * f5_x - s5 * f5_y;
        let t363 = s5 * f5_x + c5 * f5_y;
        let t372 = c5 * n5_x - s5 * n5_y - D5 * t363;
        let t373 = s5 * n5_x + c5 * n5_y + D5 * t360;
        [f5_z, n5_z, t360, t363, t372, t373]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t448, t451, t463, t464, t465] = {
        let t395 = XZ4 * (t113 - t111);
        let t396 = XZ4 * t122;
        let t397 = t116 * (ZZ4 - YY4) + XX4 * dw4_x - XY4 * t123 + XZ4 * t120;
        let t399 = t114 * (YY4 - XX4) + ZZ4 * dw4_z + XY4 * (t111 - t112) - t396;
        let t402 = YZ4 * t118;
        let t405 = t115 * (XX4 - ZZ4) + YY4 * dw4_y + XY4 * t124 + t395 - t402;
        let f4_x = t360 + (M4 * a4_x + (MSZ4 * t119 + (MSY4 * t118 - MSX4 * t117)));
        let f4_y = M4 * a4_y + (MSZ4 * t122 + (MSX4 * t120 - MSY4 * t121)) - f5_z;
        let f4_z = t363 + (MSX4 * t123 + MSY4 * t124 - MSZ4 * t125 - M4 * t86);
        let n4_x = t372 + (t397 + YZ4 * (t112 - t113) - (MSY4 * t86 + MSZ4 * a4_y));
        let n4_y = t405 + (MSZ4 * a4_x + MSX4 * t86) - n5_z;
        let n4_z = t373 + (t399 + YZ4 * t119 + (MSX4 * a4_y - MSY4 * a4_x));
        let t448 = c4 * f4_x - s4 * f4_y;
        let t451 = s4 * f4_x + c4 * f4_y;
        let t463 = c4 * n4_x - s4 * n4_y - D4 * t451;
        let t464 = s4 * n4_x + c4 * n4_y + (D4 * t448 + k2 * f4_z);
        let t465 = n4_z - k2 * t451;
        [f4_z, n4_z, t448, t451, t463, t464, t465]
    };
    // link 3: force and moment
    let [n3_z, t543, t549, t550] = {
        let t487 = XZ3 * (t62 - t60);
        let t488 = XZ3 * t71;
        let t489 = t65 * (ZZ3 - YY3) + XX3 * dw3_x - XY3 * t72 + XZ3 * t69;
        let t491 = t63 * (YY3 - XX3) + ZZ3 * dw3_z + XY3 * (t60 - t61) - t488;
        let t494 = YZ3 * t67;
        let t497 = t64 * (XX3 - ZZ3) + YY3 * dw3_y + XY3 * t73 + t487 - t494;
        let f3_x = t448 + (M3 * a3_x + (MSZ3 * t68 + (MSY3 * t67 - MSX3 * t66)));
        let f3_y = t451 + (M3 * a3_y + (MSZ3 * t71 + (MSX3 * t69 - MSY3 * t70)));
        let f3_z = f4_z + (MSX3 * t72 + MSY3 * t73 - MSZ3 * t74 - M3 * t33);
        let n3_x = t463 + (t489 + YZ3 * (t61 - t62) - (MSY3 * t33 + MSZ3 * a3_y));
        let n3_y = t464 + (t497 + (MSZ3 * a3_x + MSX3 * t33));
        let n3_z = t465 + (t491 + YZ3 * t68 + (MSX3 * a3_y - MSY3 * a3_x));
        let t543 = c3 * n3_x - s3 * n3_y;
        let t549 = s3 * n3_x + c3 * n3_y + k1 * f3_z;
        let t550 = n3_z - k1 * (s3 * f3_x + c3 * f3_y);
        [n3_z, t543, t549, t550]
    };
    // link 2: force and moment
    let [n2_z, t597] = {
        let t572 = XZ2 * (t24 - t22);
        let t573 = XZ2 * t2;
        let t574 = t6 * (ZZ2 - YY2) + XX2 * dw2_x - XY2 * t29 + XZ2 * t28;
        let t576 = t25 * (YY2 - XX2) + ZZ2 * ddq2 + XY2 * (t22 - t23) + t573;
        let t579 = YZ2 * t27;
        let t582 = t7 * (XX2 - ZZ2) + YY2 * dw2_y + XY2 * t30 + t572 - t579;
        let n2_x = t543 + (t574 + YZ2 * (t23 - t24) - MSZ2 * a2_y);
        let n2_y = t549 + (t582 + MSZ2 * a2_x);
        let n2_z = t550 + (t576 + YZ2 * t3 + (MSX2 * a2_y - MSY2 * a2_x));
        let t597 = s2 * n2_x + c2 * n2_y;
        [n2_z, t597]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t597 + ZZ1 * ddq1;
        n1_z
    };
    // drives
    {
        let t642 = FO1 + (n1_z + IA1 * ddq1 + FV1 * dq1 + FC1 * dq1.sign());
        let t643 = FO2 + (n2_z + IA2 * ddq2 + FV2 * dq2 + FC2 * dq2.sign());
        let t644 = FO3 + (n3_z + IA3 * ddq3 + FV3 * dq3 + FC3 * dq3.sign());
        let t645 = FO4 + (n4_z + IA4 * ddq4 + FV4 * dq4 + FC4 * dq4.sign());
        let t646 = FO5 + (n5_z + IA5 * ddq5 + FV5 * dq5 + FC5 * dq5.sign());
        let t647 = FO6 + (n6_z + IA6 * ddq6 + FV6 * dq6 + FC6 * dq6.sign());
        put(0, t642);
        put(1, t643);
        put(2, t644);
        put(3, t645);
        put(4, t646);
        put(5, t647);
    }
}
