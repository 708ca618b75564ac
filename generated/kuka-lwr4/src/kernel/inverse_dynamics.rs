//! Torques from the standard parameters.
//!
//! `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil and Dombre, 9.5.2.
//!
//! 357 multiplications, 355 additions; 7, 7 of 7 structurally nonzero.

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
        w3_x, t15, t22, t23, t24, t25, t26, t27,
        t29, t30, a3_z, a3_x, t41, w3_z, dw3_x, t46,
        dw3_z,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t15 = c3 * dq2 + s3 * w2_x;
        let t22 = w2_x * w2_x;
        let t23 = w2_y * w2_y;
        let t24 = dq2 * dq2;
        let t25 = w2_x * w2_y;
        let t26 = t25 - ddq2;
        let t27 = ddq2 + t25;
        let t29 = t7 - dw2_y;
        let t30 = t6 + dw2_x;
        let t33 = L2 * t30;
        let t34 = a2_x + L2 * t26;
        let a3_z = a2_y - L2 * (t22 + t24);
        let a3_x = c3 * t34 - s3 * t33;
        let t41 = c3 * t33 + s3 * t34;
        let w3_z = w2_y + dq3;
        let dw3_x = c3 * dw2_x - s3 * ddq2 - dq3 * t15;
        let t46 = c3 * ddq2 + s3 * dw2_x + dq3 * w3_x;
        let dw3_z = dw2_y + ddq3;
        [
        w3_x, t15, t22, t23, t24, t25, t26, t27,
        t29, t30, a3_z, a3_x, t41, w3_z, dw3_x, t46,
        dw3_z,
    ]
    };
    // link 4: motion
    let [
        w4_x, t53, t60, t61, t62, t63, t64, t65,
        t66, t67, t68, t69, t70, t71, t72, t73,
        a4_x, t79, w4_z, dw4_x, t84, dw4_z,
    ] = {
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t53 = c4 * w3_z + s4 * w3_x;
        let t60 = w3_x * w3_x;
        let t61 = t15 * t15;
        let t62 = w3_z * w3_z;
        let t63 = w3_x * t15;
        let t64 = w3_x * w3_z;
        let t65 = t15 * w3_z;
        let t66 = t61 + t62;
        let t67 = dw3_z + t63;
        let t68 = t64 - t46;
        let t69 = dw3_z - t63;
        let t70 = t60 + t62;
        let t71 = dw3_x + t65;
        let t72 = t46 + t64;
        let t73 = dw3_x - t65;
        let a4_x = c4 * a3_x - s4 * a3_z;
        let t79 = c4 * a3_z + s4 * a3_x;
        let w4_z = dq4 - t15;
        let dw4_x = c4 * dw3_x - s4 * dw3_z - dq4 * t53;
        let t84 = c4 * dw3_z + s4 * dw3_x + dq4 * w4_x;
        let dw4_z = ddq4 - t46;
        [
        w4_x, t53, t60, t61, t62, t63, t64, t65,
        t66, t67, t68, t69, t70, t71, t72, t73,
        a4_x, t79, w4_z, dw4_x, t84, dw4_z,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t98, t99, t100, t101, t102, t103,
        t104, t105, t106, t107, t108, t109, t110, t111,
        t112, t117, a5_x, a6_z, w5_z, dw5_x, dw5_y, dw5_z,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t98 = w4_x * w4_x;
        let t99 = t53 * t53;
        let t100 = w4_z * w4_z;
        let t101 = w4_x * t53;
        let t102 = w4_x * w4_z;
        let t103 = t53 * w4_z;
        let t104 = t99 + t100;
        let t105 = dw4_z + t101;
        let t106 = t102 - t84;
        let t107 = dw4_z - t101;
        let t108 = t98 + t100;
        let t109 = dw4_x + t103;
        let t110 = t84 + t102;
        let t111 = dw4_x - t103;
        let t112 = t98 + t99;
        let t116 = a4_x + L3 * t105;
        let t117 = L3 * t108 - t79;
        let t118 = t41 + L3 * t111;
        let a5_x = c5 * t116 - s5 * t118;
        let a6_z = c5 * t118 + s5 * t116;
        let w5_z = t53 + dq5;
        let dw5_x = c5 * dw4_x + s5 * dw4_z + dq5 * w5_y;
        let dw5_y = c5 * dw4_z - s5 * dw4_x - dq5 * w5_x;
        let dw5_z = t84 + ddq5;
        [
        w5_x, w5_y, t98, t99, t100, t101, t102, t103,
        t104, t105, t106, t107, t108, t109, t110, t111,
        t112, t117, a5_x, a6_z, w5_z, dw5_x, dw5_y, dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t143, t144, t145, t146, t147, t148,
        t149, t150, t151, t152, t153, t154, t155, t156,
        t157, a6_x, t163, w6_z, dw6_x, dw6_y, dw6_z,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t143 = w5_x * w5_x;
        let t144 = w5_y * w5_y;
        let t145 = w5_z * w5_z;
        let t146 = w5_x * w5_y;
        let t147 = w5_x * w5_z;
        let t148 = w5_y * w5_z;
        let t149 = t144 + t145;
        let t150 = t146 - dw5_z;
        let t151 = dw5_y + t147;
        let t152 = dw5_z + t146;
        let t153 = t143 + t145;
        let t154 = t148 - dw5_x;
        let t155 = t147 - dw5_y;
        let t156 = dw5_x + t148;
        let t157 = t143 + t144;
        let a6_x = c6 * a5_x - s6 * t117;
        let t163 = c6 * t117 + s6 * a5_x;
        let w6_z = dq6 - w5_y;
        let dw6_x = c6 * dw5_x + s6 * dw5_z + dq6 * w6_y;
        let dw6_y = c6 * dw5_z - s6 * dw5_x - dq6 * w6_x;
        let dw6_z = ddq6 - dw5_y;
        [
        w6_x, w6_y, t143, t144, t145, t146, t147, t148,
        t149, t150, t151, t152, t153, t154, t155, t156,
        t157, a6_x, t163, w6_z, dw6_x, dw6_y, dw6_z,
    ]
    };
    // link 7: motion
    let [
        w7_x, t175, t182, t183, t184, t185, t186, t187,
        t188, t189, t190, t191, t192, t193, t194, t195,
        t196, a7_x, t202, w7_z, dw7_x, t207, dw7_z,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t175 = c7 * w6_z + s7 * w6_x;
        let t182 = w6_x * w6_x;
        let t183 = w6_y * w6_y;
        let t184 = w6_z * w6_z;
        let t185 = w6_x * w6_y;
        let t186 = w6_x * w6_z;
        let t187 = w6_y * w6_z;
        let t188 = t183 + t184;
        let t189 = t185 - dw6_z;
        let t190 = dw6_y + t186;
        let t191 = dw6_z + t185;
        let t192 = t182 + t184;
        let t193 = t187 - dw6_x;
        let t194 = t186 - dw6_y;
        let t195 = dw6_x + t187;
        let t196 = t182 + t183;
        let a7_x = c7 * a6_x - s7 * a6_z;
        let t202 = c7 * a6_z + s7 * a6_x;
        let w7_z = w6_y + dq7;
        let dw7_x = c7 * dw6_x - s7 * dw6_z - dq7 * t175;
        let t207 = c7 * dw6_z + s7 * dw6_x + dq7 * w7_x;
        let dw7_z = dw6_y + ddq7;
        [
        w7_x, t175, t182, t183, t184, t185, t186, t187,
        t188, t189, t190, t191, t192, t193, t194, t195,
        t196, a7_x, t202, w7_z, dw7_x, t207, dw7_z,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t292, t295, t298, t301] = {
        let t209 = w7_x * w7_x;
        let t210 = t175 * t175;
        let t211 = w7_z * w7_z;
        let t212 = w7_x * t175;
        let t213 = w7_x * w7_z;
        let t214 = t175 * w7_z;
        let t216 = dw7_z + t212;
        let t217 = t213 - t207;
        let t218 = dw7_z - t212;
        let t220 = dw7_x + t214;
        let t221 = t207 + t213;
        let t222 = dw7_x - t214;
        let t245 = XZ7 * (t211 - t209);
        let t246 = XZ7 * t220;
        let t247 = XX7 * dw7_x - t214 * (ZZ7 - YY7) - XY7 * t221 + XZ7 * t218;
        let t249 = ZZ7 * dw7_z - t212 * (YY7 - XX7) + XY7 * (t209 - t210) + t246;
        let t252 = YZ7 * t216;
        let t255 = t213 * (XX7 - ZZ7) - YY7 * t207 + XY7 * t222 + t245 + t252;
        let f7_x = M7 * a7_x + (MSZ7 * t217 - (MSX7 * (t210 + t211) + MSY7 * t216));
        let f7_y = MSX7 * t218 - MSY7 * (t209 + t211) - MSZ7 * t220 - M7 * t202;
        let f7_z = MSX7 * t221 + MSY7 * t222 - MSZ7 * (t209 + t210) - M7 * t163;
        let n7_x = t247 + YZ7 * (t210 - t211) + (MSZ7 * t202 - MSY7 * t163);
        let n7_y = t255 + (MSZ7 * a7_x + MSX7 * t163);
        let n7_z = t249 + YZ7 * t217 - (MSX7 * t202 + MSY7 * a7_x);
        let t292 = c7 * f7_x - s7 * f7_y;
        let t295 = s7 * f7_x + c7 * f7_y;
        let t298 = c7 * n7_x - s7 * n7_y;
        let t301 = s7 * n7_x + c7 * n7_y;
        [f7_z, n7_z, t292, t295, t298, t301]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t376, t379, t382, t385] = {
        let t323 = XZ6 * (t184 - t182);
        let t324 = XZ6 * t193;
        let t325 = t187 * (ZZ6 - YY6) + XX6 * dw6_x - XY6 * t194 + XZ6 * t191;
        let t327 = t185 * (YY6 - XX6) + ZZ6 * dw6_z + XY6 * (t182 - t183) - t324;
        let t330 = YZ6 * t189;
        let t333 = t186 * (XX6 - ZZ6) + YY6 * dw6_y + XY6 * t195 + t323 - t330;
        let f6_x = t292 + (M6 * a6_x + (MSZ6 * t190 + (MSY6 * t189 - MSX6 * t188)));
        let f6_y = f7_z + (MSZ6 * t193 + (MSX6 * t191 - MSY6 * t192) - M6 * t163);
        let f6_z = M6 * a6_z + (MSX6 * t194 + MSY6 * t195 - MSZ6 * t196) - t295;
        let n6_x = t298 + (t325 + YZ6 * (t183 - t184) + (MSY6 * a6_z + MSZ6 * t163));
        let n6_y = n7_z + (t333 + (MSZ6 * a6_x - MSX6 * a6_z));
        let n6_z = t327 + YZ6 * t190 - (MSX6 * t163 + MSY6 * a6_x) - t301;
        let t376 = c6 * f6_x - s6 * f6_y;
        let t379 = s6 * f6_x + c6 * f6_y;
        let t382 = c6 * n6_x - s6 * n6_y;
        let t385 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t376, t379, t382, t385]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t460, t463, t472, t473] = {
        let t407 = XZ5 * (t145 - t143);
        let t408 = XZ5 * t154;
        let t409 = t148 * (ZZ5 - YY5) + XX5 * dw5_x - XY5 * t155 + XZ5 * t152;
        let t411 = t146 * (YY5 - XX5) + ZZ5 * dw5_z + XY5 * (t143 - t144) - t408;
        let t414 = YZ5 * t150;
        let t417 = t147 * (XX5 - ZZ5) + YY5 * dw5_y + XY5 * t156 + t407 - t414;
        let f5_x = t376 + (M5 * a5_x + (MSZ5 * t151 + (MSY5 * t150 - MSX5 * t149)));
        let f5_y = MSZ5 * t154 + (MSX5 * t152 - MSY5 * t153) - M5 * a6_z - f6_z;
        let f5_z = t379 + (MSX5 * t155 + MSY5 * t156 - MSZ5 * t157 - M5 * t117);
        let n5_x = t382 + (t409 + YZ5 * (t144 - t145) + (MSZ5 * a6_z - MSY5 * t117));
        let n5_y = t417 + (MSZ5 * a5_x + MSX5 * t117) - n6_z;
        let n5_z = t385 + (t411 + YZ5 * t151 - (MSX5 * a6_z + MSY5 * a5_x));
        let t460 = c5 * f5_x - s5 * f5_y;
        let t463 = s5 * f5_x + c5 * f5_y;
        let t472 = c5 * n5_x - s5 * n5_y - L3 * t463;
        let t473 = s5 * n5_x + c5 * n5_y + L3 * t460;
        [f5_z, n5_z, t460, t463, t472, t473]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t548, t551, t554] = {
        let t495 = XZ4 * (t100 - t98);
        let t496 = XZ4 * t109;
        let t497 = XX4 * dw4_x - t103 * (ZZ4 - YY4) - XY4 * t110 + XZ4 * t107;
        let t499 = ZZ4 * dw4_z - t101 * (YY4 - XX4) + XY4 * (t98 - t99) + t496;
        let t502 = YZ4 * t105;
        let t505 = t102 * (XX4 - ZZ4) - YY4 * t84 + XY4 * t111 + t495 + t502;
        let f4_x = t460 + (M4 * a4_x + (MSZ4 * t106 - (MSX4 * t104 + MSY4 * t105)));
        let f4_y = MSX4 * t107 - MSY4 * t108 - MSZ4 * t109 - M4 * t79 - f5_z;
        let f4_z = t463 + (MSX4 * t110 + MSY4 * t111 - MSZ4 * t112 - M4 * t41);
        let n4_x = t472 + (t497 + YZ4 * (t99 - t100) + (MSZ4 * t79 - MSY4 * t41));
        let n4_y = t505 + (MSZ4 * a4_x + MSX4 * t41) - n5_z;
        let n4_z = t473 + (t499 + YZ4 * t106 - (MSX4 * t79 + MSY4 * a4_x));
        let t548 = c4 * f4_x - s4 * f4_y;
        let t551 = c4 * n4_x - s4 * n4_y;
        let t554 = s4 * n4_x + c4 * n4_y;
        [f4_z, n4_z, t548, t551, t554]
    };
    // link 3: force and moment
    let [n3_z, t633, t634] = {
        let t576 = XZ3 * (t62 - t60);
        let t577 = XZ3 * t71;
        let t578 = XX3 * dw3_x - t65 * (ZZ3 - YY3) - XY3 * t72 + XZ3 * t69;
        let t580 = ZZ3 * dw3_z - t63 * (YY3 - XX3) + XY3 * (t60 - t61) + t577;
        let t583 = YZ3 * t67;
        let t586 = t64 * (XX3 - ZZ3) - YY3 * t46 + XY3 * t73 + t576 + t583;
        let f3_x = t548 + (M3 * a3_x + (MSZ3 * t68 - (MSX3 * t66 + MSY3 * t67)));
        let f3_y = f4_z + (MSX3 * t69 - MSY3 * t70 - MSZ3 * t71 - M3 * t41);
        let n3_x = t551 + (t578 + YZ3 * (t61 - t62) + (MSY3 * a3_z + MSZ3 * t41));
        let n3_y = n4_z + (t586 + (MSZ3 * a3_x - MSX3 * a3_z));
        let n3_z = t580 + YZ3 * t68 - (MSX3 * t41 + MSY3 * a3_x) - t554;
        let t633 = c3 * n3_x - s3 * n3_y - L2 * (s3 * f3_x + c3 * f3_y);
        let t634 = s3 * n3_x + c3 * n3_y + L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, t633, t634]
    };
    // link 2: force and moment
    let [n2_z, t681] = {
        let t656 = XZ2 * (t24 - t22);
        let t657 = XZ2 * t2;
        let t658 = t6 * (ZZ2 - YY2) + XX2 * dw2_x - XY2 * t29 + XZ2 * t27;
        let t660 = t25 * (YY2 - XX2) + ZZ2 * ddq2 + XY2 * (t22 - t23) + t657;
        let t663 = YZ2 * t26;
        let t666 = t7 * (XX2 - ZZ2) + YY2 * dw2_y + XY2 * t30 + t656 - t663;
        let n2_x = t633 + (t658 + YZ2 * (t23 - t24) - MSZ2 * a2_y);
        let n2_y = n3_z + (t666 + MSZ2 * a2_x);
        let n2_z = t660 + YZ2 * t3 + (MSX2 * a2_y - MSY2 * a2_x) - t634;
        let t681 = s2 * n2_x + c2 * n2_y;
        [n2_z, t681]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t681 + ZZ1 * ddq1;
        n1_z
    };
    // drives
    {
        let t700 = n1_z + FV1 * dq1 + FC1 * dq1.sign();
        let t703 = n2_z + FV2 * dq2 + FC2 * dq2.sign();
        let t706 = n3_z + FV3 * dq3 + FC3 * dq3.sign();
        let t709 = n4_z + FV4 * dq4 + FC4 * dq4.sign();
        let t712 = n5_z + FV5 * dq5 + FC5 * dq5.sign();
        let t715 = n6_z + FV6 * dq6 + FC6 * dq6.sign();
        let t718 = n7_z + FV7 * dq7 + FC7 * dq7.sign();
        put(0, t700);
        put(1, t703);
        put(2, t706);
        put(3, t709);
        put(4, t712);
        put(5, t715);
        put(6, t718);
    }
}
