//! Torques from the standard parameters.
//!
//! `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil and Dombre, 9.5.2.
//!
//! 342 multiplications, 342 additions; 7, 7 of 7 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, STANDARD, Trig};

/// Torques from the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], out: &mut [S; 7]) {
    entries(trig, dq, ddq, phi, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], mut put: impl FnMut(usize, S)) {
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
        dw7_x, dw7_y, t195, t196, t197, t198, t199, t200,
        t201,
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
        dw7_x, dw7_y, t195, t196, t197, t198, t199, t200,
        t201,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t269, t272, t275, t278] = {
        let t223 = XZ7 * t185;
        let t224 = XX7 * dw7_x - t192 * (ZZ7 - YY7) - XY7 * t200 + XZ7 * t198;
        let t225 = t191 * (XX7 - ZZ7) + YY7 * dw7_y + XY7 * t201 - XZ7 * t195;
        let t226 = ZZ7 * dw7_z - t190 * (YY7 - XX7) + XY7 * (t196 + t199) + t223;
        let f7_x = M7 * a7_x + (MSZ7 * t182 + (MSX7 * t196 - MSY7 * t197));
        let f7_y = M7 * a7_y + (MSX7 * t198 - MSY7 * t199 - MSZ7 * t185);
        let f7_z = MSX7 * t200 + MSY7 * t201 - MSZ7 * t165 - M7 * t145;
        let n7_x = t224 + YZ7 * (t165 - t199) - (MSY7 * t145 + MSZ7 * a7_y);
        let n7_y = t225 + YZ7 * t197 + (MSZ7 * a7_x + MSX7 * t145);
        let n7_z = t226 + YZ7 * t182 + (MSX7 * a7_y - MSY7 * a7_x);
        let t269 = c7 * f7_x - s7 * f7_y;
        let t272 = s7 * f7_x + c7 * f7_y;
        let t275 = c7 * n7_x - s7 * n7_y;
        let t278 = s7 * n7_x + c7 * n7_y;
        [f7_z, n7_z, t269, t272, t275, t278]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t352, t355, t358, t361] = {
        let t300 = XZ6 * t151;
        let t301 = t158 * (ZZ6 - YY6) + XX6 * dw6_x - XY6 * t166 + XZ6 * t164;
        let t302 = t157 * (XX6 - ZZ6) - YY6 * t160 + XY6 * t167 - XZ6 * t161;
        let t303 = t156 * (YY6 - XX6) + ZZ6 * dw6_z + XY6 * (t162 + t165) - t300;
        let f6_x = t269 + (M6 * a6_x + (MSX6 * t162 + MSY6 * t163 - MSZ6 * t148));
        let f6_y = f7_z + (MSZ6 * t151 + (MSX6 * t164 - MSY6 * t165) - M6 * t145);
        let f6_z = MSX6 * t166 + MSY6 * t167 - MSZ6 * t131 - M6 * a5_y - t272;
        let n6_x = t275 + (t301 + YZ6 * (t131 - t165) + (MSZ6 * t145 - MSY6 * a5_y));
        let n6_y = n7_z + (t302 - YZ6 * t163 + (MSZ6 * a6_x + MSX6 * a5_y));
        let n6_z = t303 - YZ6 * t148 - (MSX6 * t145 + MSY6 * a6_x) - t278;
        let t352 = c6 * f6_x - s6 * f6_y;
        let t355 = s6 * f6_x + c6 * f6_y;
        let t358 = c6 * n6_x - s6 * n6_y;
        let t361 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t352, t355, t358, t361]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t435, t438, t447, t448] = {
        let t383 = XZ5 * t117;
        let t384 = t124 * (ZZ5 - YY5) + XX5 * dw5_x - XY5 * t132 + XZ5 * t130;
        let t385 = t123 * (XX5 - ZZ5) + YY5 * dw5_y + XY5 * t133 - XZ5 * t127;
        let t386 = t122 * (YY5 - XX5) + ZZ5 * dw5_z + XY5 * (t128 + t131) - t383;
        let f5_x = t352 + (M5 * a5_x + (MSZ5 * t114 + (MSX5 * t128 + MSY5 * t129)));
        let f5_y = M5 * a5_y + (MSZ5 * t117 + (MSX5 * t130 - MSY5 * t131)) - f6_z;
        let f5_z = t355 + (MSX5 * t132 + MSY5 * t133 - MSZ5 * t91 - M5 * t104);
        let n5_x = t358 + (t384 + YZ5 * (t91 - t131) - (MSY5 * t104 + MSZ5 * a5_y));
        let n5_y = t385 - YZ5 * t129 + (MSZ5 * a5_x + MSX5 * t104) - n6_z;
        let n5_z = t361 + (t386 + YZ5 * t114 + (MSX5 * a5_y - MSY5 * a5_x));
        let t435 = c5 * f5_x - s5 * f5_y;
        let t438 = s5 * f5_x + c5 * f5_y;
        let t447 = c5 * n5_x - s5 * n5_y - L3 * t438;
        let t448 = s5 * n5_x + c5 * n5_y + L3 * t435;
        [f5_z, n5_z, t435, t438, t447, t448]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t522, t525, t528] = {
        let t470 = XZ4 * t77;
        let t471 = XZ4 * t90 - (t84 * (ZZ4 - YY4) + XX4 * t85 + XY4 * t92);
        let t472 = t83 * (XX4 - ZZ4) - YY4 * t86 - XY4 * t93 - XZ4 * t87;
        let t473 = ZZ4 * dw4_z - t82 * (YY4 - XX4) + XY4 * (t88 + t91) - t470;
        let f4_x = t435 + (M4 * a4_x + (MSX4 * t88 - MSY4 * t89 - MSZ4 * t74));
        let f4_y = MSZ4 * t77 + (MSX4 * t90 - MSY4 * t91) - M4 * t71 - f5_z;
        let f4_z = t438 + (MSX4 * t92 - MSY4 * t93 - MSZ4 * t57 - M4 * t37);
        let n4_x = t447 + (t471 + YZ4 * (t57 - t91) + (MSZ4 * t71 - MSY4 * t37));
        let n4_y = t472 + YZ4 * t89 + (MSZ4 * a4_x + MSX4 * t37) - n5_z;
        let n4_z = t448 + (t473 - YZ4 * t74 - (MSX4 * t71 + MSY4 * a4_x));
        let t522 = c4 * f4_x - s4 * f4_y;
        let t525 = c4 * n4_x - s4 * n4_y;
        let t528 = s4 * n4_x + c4 * n4_y;
        [f4_z, n4_z, t522, t525, t528]
    };
    // link 3: force and moment
    let [n3_z, t606, t607] = {
        let t550 = XZ3 * t43;
        let t551 = XX3 * dw3_x - t50 * (ZZ3 - YY3) - XY3 * t58 + XZ3 * t56;
        let t552 = t49 * (XX3 - ZZ3) + YY3 * dw3_y + XY3 * t59 - XZ3 * t53;
        let t553 = ZZ3 * dw3_z - t48 * (YY3 - XX3) + XY3 * (t54 + t57) + t550;
        let f3_x = t522 + (M3 * a3_x + (MSZ3 * t40 + (MSX3 * t54 - MSY3 * t55)));
        let f3_y = f4_z + (MSX3 * t56 - MSY3 * t57 - MSZ3 * t43 - M3 * t37);
        let n3_x = t525 + (t551 + YZ3 * (t18 - t57) + (MSY3 * a3_z + MSZ3 * t37));
        let n3_y = n4_z + (t552 + YZ3 * t55 + (MSZ3 * a3_x - MSX3 * a3_z));
        let n3_z = t553 + YZ3 * t40 - (MSX3 * t37 + MSY3 * a3_x) - t528;
        let t606 = c3 * n3_x - s3 * n3_y - L2 * (s3 * f3_x + c3 * f3_y);
        let t607 = s3 * n3_x + c3 * n3_y + L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, t606, t607]
    };
    // link 2: force and moment
    let [n2_z, t653] = {
        let t629 = XZ2 * t3;
        let t630 = t11 * (ZZ2 - YY2) + XX2 * dw2_x - XY2 * t19 + XZ2 * t17;
        let t631 = t10 * (XX2 - ZZ2) + YY2 * dw2_y + XY2 * t20 - XZ2 * t14;
        let t632 = t9 * (YY2 - XX2) + ZZ2 * ddq2 + XY2 * (t15 + t18) + t629;
        let n2_x = t606 + (t630 + YZ2 * (t0 - t18) - MSZ2 * a2_y);
        let n2_y = n3_z + (t631 - YZ2 * t16 + MSZ2 * a2_x);
        let n2_z = t632 + YZ2 * t4 + (MSX2 * a2_y - MSY2 * a2_x) - t607;
        let t653 = s2 * n2_x + c2 * n2_y;
        [n2_z, t653]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t653 + ZZ1 * ddq1;
        n1_z
    };
    // drives
    {
        let t672 = n1_z + FV1 * dq1 + FC1 * dq1.sign();
        let t675 = n2_z + FV2 * dq2 + FC2 * dq2.sign();
        let t678 = n3_z + FV3 * dq3 + FC3 * dq3.sign();
        let t681 = n4_z + FV4 * dq4 + FC4 * dq4.sign();
        let t684 = n5_z + FV5 * dq5 + FC5 * dq5.sign();
        let t687 = n6_z + FV6 * dq6 + FC6 * dq6.sign();
        let t690 = n7_z + FV7 * dq7 + FC7 * dq7.sign();
        put(0, t672);
        put(1, t675);
        put(2, t678);
        put(3, t681);
        put(4, t684);
        put(5, t687);
        put(6, t690);
    }
}
