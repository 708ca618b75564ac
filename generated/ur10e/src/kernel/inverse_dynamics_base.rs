//! Torques from the base parameters.
//!
//! `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil and Dombre, 9.6.
//!
//! 278 multiplications, 269 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, Trig};

/// Torques from the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE], out: &mut [S; 6]) {
    entries(trig, dq, ddq, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
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
        t86, a4_x, a4_y, w4_z, dw4_x, dw4_y, dw4_z,
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
        let t84 = a3_x + (t66 * k2 + D4 * t68);
        let t85 = a3_y + (D4 * t71 - t69 * k2);
        let t86 = t33 + (t72 * k2 + D4 * (t60 + t61));
        let a4_x = c4 * t84 + s4 * t85;
        let a4_y = c4 * t85 - s4 * t84;
        let w4_z = w3_z + dq4;
        let dw4_x = c4 * dw3_x + s4 * dw3_y + dq4 * w4_y;
        let dw4_y = c4 * dw3_y - s4 * dw3_x - dq4 * w4_x;
        let dw4_z = dw3_z + ddq4;
        [
        w4_x, w4_y, t60, t61, t62, t63, t64, t65,
        t66, t67, t68, t69, t70, t71, t72, t73,
        t86, a4_x, a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t111, t112, t113, t114, t115, t116,
        t117, t118, t119, t120, t121, t122, t123, t124,
        t129, a5_x, t136, w5_z, dw5_x, dw5_y, dw5_z,
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
        let t128 = a4_x - D5 * t118;
        let t129 = a4_y + D5 * t121;
        let t130 = t86 + D5 * t124;
        let a5_x = c5 * t128 - s5 * t130;
        let t136 = c5 * t130 + s5 * t128;
        let w5_z = dq5 - w4_y;
        let dw5_x = c5 * dw4_x + s5 * dw4_z + dq5 * w5_y;
        let dw5_y = c5 * dw4_z - s5 * dw4_x - dq5 * w5_x;
        let dw5_z = ddq5 - dw4_y;
        [
        w5_x, w5_y, t111, t112, t113, t114, t115, t116,
        t117, t118, t119, t120, t121, t122, t123, t124,
        t129, a5_x, t136, w5_z, dw5_x, dw5_y, dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, t148, t155, t156, t157, t158, t159, t160,
        t161, t162, t163, t164, t165, t166, t167, t168,
        t173, a6_x, t180, w6_z, dw6_x, t185, dw6_z,
    ] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t148 = c6 * w5_z + s6 * w5_x;
        let t155 = w5_x * w5_x;
        let t156 = w5_y * w5_y;
        let t157 = w5_z * w5_z;
        let t158 = w5_x * w5_y;
        let t159 = w5_x * w5_z;
        let t160 = w5_y * w5_z;
        let t161 = t156 + t157;
        let t162 = t158 - dw5_z;
        let t163 = dw5_y + t159;
        let t164 = dw5_z + t158;
        let t165 = t155 + t157;
        let t166 = t160 - dw5_x;
        let t167 = t159 - dw5_y;
        let t168 = dw5_x + t160;
        let t172 = a5_x + D6 * t162;
        let t173 = t136 + D6 * t165;
        let t174 = D6 * t168 - t129;
        let a6_x = c6 * t172 - s6 * t174;
        let t180 = c6 * t174 + s6 * t172;
        let w6_z = w5_y + dq6;
        let dw6_x = c6 * dw5_x - s6 * dw5_z - dq6 * t148;
        let t185 = c6 * dw5_z + s6 * dw5_x + dq6 * w6_x;
        let dw6_z = dw5_y + ddq6;
        [
        w6_x, t148, t155, t156, t157, t158, t159, t160,
        t161, t162, t163, t164, t165, t166, t167, t168,
        t173, a6_x, t180, w6_z, dw6_x, t185, dw6_z,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t249, t252, t261, t262] = {
        let t187 = w6_x * w6_x;
        let t188 = t148 * t148;
        let t189 = w6_z * w6_z;
        let t190 = w6_x * t148;
        let t191 = w6_x * w6_z;
        let t192 = t148 * w6_z;
        let t194 = dw6_z + t190;
        let t196 = dw6_z - t190;
        let t199 = t185 + t191;
        let t200 = dw6_x - t192;
        let t219 = XZ6 * (dw6_x + t192);
        let t224 = YZ6 * (t188 - t189);
        let t225 = YZ6 * t194;
        let t226 = YZ6 * (t191 - t185);
        let t227 = XX6R * dw6_x - ZZ6 * t192 - XY6 * t199 + XZ6 * t196 + t224;
        let t228 = t191 * (XX6R - ZZ6) + XY6 * t200 + XZ6 * (t189 - t187) + t225;
        let t229 = XX6R * t190 + ZZ6 * dw6_z + XY6 * (t187 - t188) + t219 + t226;
        let t232 = MSX6 * (t188 + t189) + MSY6 * t194;
        let f6_y = MSX6 * t196 - MSY6 * (t187 + t189);
        let f6_z = MSX6 * t199 + MSY6 * t200;
        let n6_x = t227 - MSY6 * t173;
        let n6_y = t228 + MSX6 * t173;
        let n6_z = t229 - (MSX6 * t180 + MSY6 * a6_x);
        let t249 = c6 * t232 + s6 * f6_y;
        let t252 = c6 * f6_y - s6 * t232;
        let t261 = c6 * n6_x - s6 * n6_y - D6 * t252;
        let t262 = s6 * n6_x + c6 * n6_y - D6 * t249;
        [f6_z, n6_z, t249, t252, t261, t262]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t317, t320, t329, t330] = {
        let t284 = ZZ5R * dw5_z - XX5R * t158 + XY5 * (t155 - t156) - XZ5 * t166;
        let t286 = YZ5 * (t156 - t157);
        let t287 = YZ5 * t162;
        let t289 = ZZ5R * t160 + XX5R * dw5_x - XY5 * t167 + XZ5 * t164 + t286;
        let t290 = t159 * (XX5R - ZZ5R) + XY5 * t168 + XZ5 * (t157 - t155) - t287;
        let f5_x = MSY5R * t162 - MSX5 * t161 - t249;
        let f5_y = f6_z + (MSX5 * t164 - MSY5R * t165);
        let f5_z = MSX5 * t167 + MSY5R * t168 - t252;
        let n5_x = t261 + (t289 - MSY5R * t129);
        let n5_y = n6_z + (t290 + MSX5 * t129);
        let n5_z = t284 + YZ5 * t163 - (MSX5 * t136 + MSY5R * a5_x) - t262;
        let t317 = c5 * f5_x - s5 * f5_y;
        let t320 = s5 * f5_x + c5 * f5_y;
        let t329 = c5 * n5_x - s5 * n5_y - D5 * t320;
        let t330 = s5 * n5_x + c5 * n5_y + D5 * t317;
        [f5_z, n5_z, t317, t320, t329, t330]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t385, t388, t400, t401, t402] = {
        let t352 = ZZ4R * dw4_z - XX4R * t114 + XY4 * (t111 - t112) - XZ4 * t122;
        let t354 = YZ4 * (t112 - t113);
        let t355 = YZ4 * t118;
        let t357 = ZZ4R * t116 + XX4R * dw4_x - XY4 * t123 + XZ4 * t120 + t354;
        let t358 = t115 * (XX4R - ZZ4R) + XY4 * t124 + XZ4 * (t113 - t111) - t355;
        let f4_x = t317 + (MSY4R * t118 - MSX4 * t117);
        let f4_y = MSX4 * t120 - MSY4R * t121 - f5_z;
        let f4_z = t320 + (MSX4 * t123 + MSY4R * t124);
        let n4_x = t329 + (t357 - MSY4R * t86);
        let n4_y = t358 + MSX4 * t86 - n5_z;
        let n4_z = t330 + (t352 + YZ4 * t119 + (MSX4 * a4_y - MSY4R * a4_x));
        let t385 = c4 * f4_x - s4 * f4_y;
        let t388 = s4 * f4_x + c4 * f4_y;
        let t400 = c4 * n4_x - s4 * n4_y - D4 * t388;
        let t401 = s4 * n4_x + c4 * n4_y + (D4 * t385 + k2 * f4_z);
        let t402 = n4_z - k2 * t388;
        [f4_z, n4_z, t385, t388, t400, t401, t402]
    };
    // link 3: force and moment
    let [n3_z, t460, t466, t467] = {
        let t424 = ZZ3R * dw3_z - XX3R * t63 + XY3 * (t60 - t61) - XZ3R * t71;
        let t426 = YZ3 * (t61 - t62);
        let t427 = YZ3 * t67;
        let t429 = ZZ3R * t65 + XX3R * dw3_x - XY3 * t72 + XZ3R * t69 + t426;
        let t430 = t64 * (XX3R - ZZ3R) + XY3 * t73 + XZ3R * (t62 - t60) - t427;
        let f3_x = t385 + (MSY3 * t67 - MSX3R * t66);
        let f3_y = t388 + (MSX3R * t69 - MSY3 * t70);
        let f3_z = f4_z + (MSX3R * t72 + MSY3 * t73);
        let n3_x = t400 + (t429 - MSY3 * t33);
        let n3_y = t401 + (t430 + MSX3R * t33);
        let n3_z = t402 + (t424 + YZ3 * t68 + (MSX3R * a3_y - MSY3 * a3_x));
        let t460 = c3 * n3_x - s3 * n3_y;
        let t466 = s3 * n3_x + c3 * n3_y + k1 * f3_z;
        let t467 = n3_z - k1 * (s3 * f3_x + c3 * f3_y);
        [n3_z, t460, t466, t467]
    };
    // link 2: force and moment
    let [n2_z, t506] = {
        let t489 = ZZ2R * ddq2 - XX2R * t25 + XY2 * (t22 - t23) + XZ2R * t2;
        let t491 = YZ2 * (t23 - t24);
        let t492 = YZ2 * t27;
        let t494 = ZZ2R * t6 + XX2R * dw2_x - XY2 * t29 + XZ2R * t28 + t491;
        let t495 = t7 * (XX2R - ZZ2R) + XY2 * t30 + XZ2R * (t24 - t22) - t492;
        let n2_x = t460 + t494;
        let n2_y = t466 + t495;
        let n2_z = t467 + (t489 + YZ2 * t3 + (MSX2R * a2_y - MSY2 * a2_x));
        let t506 = s2 * n2_x + c2 * n2_y;
        [n2_z, t506]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t506 + ZZ1R * ddq1;
        n1_z
    };
    // drives
    {
        let t547 = FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t548 = FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t549 = FO3 + (n3_z + IA3 * ddq3 + FV3 * dq3 + FC3 * dq3.sign());
        let t550 = FO4 + (n4_z + IA4 * ddq4 + FV4 * dq4 + FC4 * dq4.sign());
        let t551 = FO5 + (n5_z + IA5 * ddq5 + FV5 * dq5 + FC5 * dq5.sign());
        let t552 = FO6 + (n6_z + IA6 * ddq6 + FV6 * dq6 + FC6 * dq6.sign());
        put(0, t547);
        put(1, t548);
        put(2, t549);
        put(3, t550);
        put(4, t551);
        put(5, t552);
    }
}
