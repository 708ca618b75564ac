//! Torques from the base parameters.
//!
//! `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil and Dombre, 9.6.
//!
//! 328 multiplications, 316 additions; 7, 7 of 7 structurally nonzero.

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
        ZZ1R, MSX2, MSY2R, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3R, MSY3R, XX3R, ZZ3R,
        XY3R, XZ3, YZ3, MSX4R, MSY4R, XX4R, ZZ4R, XY4R, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6R, MSY6R, XX6R, ZZ6R, XY6R, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7, FV1, FV2, FV3, FV4, FV5,
        FV6, FV7, FC1, FC2, FC3, FC4, FC5, FC6, FC7, FO1, FO2, FO3,
        FO4, FO5, FO6, FO7,
        ..] = *beta;
    let A = S::constant(0.0825);
    let L2 = S::constant(0.316);
    let L3 = S::constant(0.384);
    let k0 = S::constant(9.81);
    let k4 = S::constant(0.088);
    // link 2: motion
    let [
        t0, t1, t2, t3, t4, t5, t6, t7,
        t8, dw2_y,
    ] = {
        let t0 = s2 * dq1;
        let t1 = c2 * dq1;
        let t2 = s2 * ddq1;
        let t3 = c2 * ddq1;
        let t4 = s2 * k0;
        let t5 = c2 * k0;
        let t6 = dq2 * t1;
        let t7 = dq2 * t0;
        let t8 = t2 + t6;
        let dw2_y = t7 - t3;
        [
        t0, t1, t2, t3, t4, t5, t6, t7,
        t8, dw2_y,
    ]
    };
    // link 3: motion
    let [
        w3_x, w3_y, t22, t23, t24, t25, t26, t27,
        t29, t30, t35, a3_x, a3_y, w3_z, dw3_x, dw3_y,
        dw3_z,
    ] = {
        let w3_x = s3 * dq2 - c3 * t0;
        let w3_y = c3 * dq2 + s3 * t0;
        let t22 = t0 * t0;
        let t23 = t1 * t1;
        let t24 = dq2 * dq2;
        let t25 = t0 * t1;
        let t26 = t25 - ddq2;
        let t27 = ddq2 + t25;
        let t29 = t7 + dw2_y;
        let t30 = t6 + t8;
        let t33 = L2 * t30;
        let t34 = t4 + L2 * t26;
        let t35 = L2 * (t22 + t24) - t5;
        let a3_x = s3 * t33 - c3 * t34;
        let a3_y = c3 * t33 + s3 * t34;
        let w3_z = t1 + dq3;
        let dw3_x = s3 * ddq2 - c3 * t8 + dq3 * w3_y;
        let dw3_y = c3 * ddq2 + s3 * t8 - dq3 * w3_x;
        let dw3_z = ddq3 - dw2_y;
        [
        w3_x, w3_y, t22, t23, t24, t25, t26, t27,
        t29, t30, t35, a3_x, a3_y, w3_z, dw3_x, dw3_y,
        dw3_z,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t60, t61, t62, t63, t64, t65,
        t66, t67, t68, t69, t70, t71, t72, t73,
        t78, a4_x, a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
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
        let t77 = a3_x - A * t66;
        let t78 = a3_y + A * t69;
        let t79 = A * t72 - t35;
        let a4_x = c4 * t77 + s4 * t79;
        let a4_y = c4 * t79 - s4 * t77;
        let w4_z = dq4 - w3_y;
        let dw4_x = c4 * dw3_x + s4 * dw3_z + dq4 * w4_y;
        let dw4_y = c4 * dw3_z - s4 * dw3_x - dq4 * w4_x;
        let dw4_z = ddq4 - dw3_y;
        [
        w4_x, w4_y, t60, t61, t62, t63, t64, t65,
        t66, t67, t68, t69, t70, t71, t72, t73,
        t78, a4_x, a4_y, w4_z, dw4_x, dw4_y, dw4_z,
    ]
    };
    // link 5: motion
    let [
        w5_x, t97, t104, t105, t106, t107, t108, t109,
        t110, t111, t112, t113, t114, t115, t116, t117,
        a5_z, a5_x, a6_z, w5_z, dw5_x, t140, dw5_z,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t97 = c5 * w4_z + s5 * w4_x;
        let t104 = w4_x * w4_x;
        let t105 = w4_y * w4_y;
        let t106 = w4_z * w4_z;
        let t107 = w4_x * w4_y;
        let t108 = w4_x * w4_z;
        let t109 = w4_y * w4_z;
        let t110 = t105 + t106;
        let t111 = t107 - dw4_z;
        let t112 = dw4_y + t108;
        let t113 = dw4_z + t107;
        let t114 = t104 + t106;
        let t115 = t109 - dw4_x;
        let t116 = t108 - dw4_y;
        let t117 = dw4_x + t109;
        let t127 = a4_x + (A * t110 + L3 * t111);
        let a5_z = a4_y - (A * t113 + L3 * t114);
        let t129 = L3 * t117 - A * t116 - t78;
        let a5_x = c5 * t127 - s5 * t129;
        let a6_z = c5 * t129 + s5 * t127;
        let w5_z = w4_y + dq5;
        let dw5_x = c5 * dw4_x - s5 * dw4_z - dq5 * t97;
        let t140 = c5 * dw4_z + s5 * dw4_x + dq5 * w5_x;
        let dw5_z = dw4_y + ddq5;
        [
        w5_x, t97, t104, t105, t106, t107, t108, t109,
        t110, t111, t112, t113, t114, t115, t116, t117,
        a5_z, a5_x, a6_z, w5_z, dw5_x, t140, dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t154, t155, t156, t157, t158, t159,
        t160, t161, t162, t163, t164, t165, t166, t167,
        a6_x, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t154 = w5_x * w5_x;
        let t155 = t97 * t97;
        let t156 = w5_z * w5_z;
        let t157 = w5_x * t97;
        let t158 = w5_x * w5_z;
        let t159 = t97 * w5_z;
        let t160 = t155 + t156;
        let t161 = dw5_z + t157;
        let t162 = t158 - t140;
        let t163 = dw5_z - t157;
        let t164 = t154 + t156;
        let t165 = dw5_x + t159;
        let t166 = t140 + t158;
        let t167 = dw5_x - t159;
        let a6_x = c6 * a5_x + s6 * a5_z;
        let a6_y = c6 * a5_z - s6 * a5_x;
        let w6_z = t97 + dq6;
        let dw6_x = c6 * dw5_x + s6 * dw5_z + dq6 * w6_y;
        let dw6_y = c6 * dw5_z - s6 * dw5_x - dq6 * w6_x;
        let dw6_z = t140 + ddq6;
        [
        w6_x, w6_y, t154, t155, t156, t157, t158, t159,
        t160, t161, t162, t163, t164, t165, t166, t167,
        a6_x, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ]
    };
    // link 7: motion
    let [
        w7_x, w7_y, t192, t193, t194, t195, t196, t197,
        t198, t199, t200, t201, t202, t203, t204, t205,
        t210, a7_x, a7_y, w7_z, dw7_x, dw7_y, dw7_z,
    ] = {
        let w7_x = c7 * w6_x + s7 * w6_z;
        let w7_y = c7 * w6_z - s7 * w6_x;
        let t192 = w6_x * w6_x;
        let t193 = w6_y * w6_y;
        let t194 = w6_z * w6_z;
        let t195 = w6_x * w6_y;
        let t196 = w6_x * w6_z;
        let t197 = w6_y * w6_z;
        let t198 = t193 + t194;
        let t199 = t195 - dw6_z;
        let t200 = dw6_y + t196;
        let t201 = dw6_z + t195;
        let t202 = t192 + t194;
        let t203 = t197 - dw6_x;
        let t204 = t196 - dw6_y;
        let t205 = dw6_x + t197;
        let t209 = a6_x - k4 * t198;
        let t210 = a6_y + k4 * t201;
        let t211 = a6_z + k4 * t204;
        let a7_x = c7 * t209 + s7 * t211;
        let a7_y = c7 * t211 - s7 * t209;
        let w7_z = dq7 - w6_y;
        let dw7_x = c7 * dw6_x + s7 * dw6_z + dq7 * w7_y;
        let dw7_y = c7 * dw6_z - s7 * dw6_x - dq7 * w7_x;
        let dw7_z = ddq7 - dw6_y;
        [
        w7_x, w7_y, t192, t193, t194, t195, t196, t197,
        t198, t199, t200, t201, t202, t203, t204, t205,
        t210, a7_x, a7_y, w7_z, dw7_x, dw7_y, dw7_z,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t286, t289, t292, t298, t299] = {
        let t224 = w7_x * w7_x;
        let t225 = w7_y * w7_y;
        let t226 = w7_z * w7_z;
        let t227 = w7_x * w7_y;
        let t228 = w7_x * w7_z;
        let t229 = w7_y * w7_z;
        let t231 = t227 - dw7_z;
        let t233 = dw7_z + t227;
        let t236 = t228 - dw7_y;
        let t237 = dw7_x + t229;
        let t256 = XZ7 * (t229 - dw7_x);
        let t261 = YZ7 * (t225 - t226);
        let t262 = YZ7 * t231;
        let t263 = YZ7 * (dw7_y + t228);
        let t264 = ZZ7 * t229 + XX7R * dw7_x - XY7 * t236 + XZ7 * t233 + t261;
        let t265 = t228 * (XX7R - ZZ7) + XY7 * t237 + XZ7 * (t226 - t224) - t262;
        let t266 = ZZ7 * dw7_z - XX7R * t227 + XY7 * (t224 - t225) - t256 + t263;
        let f7_x = MSY7 * t231 - MSX7 * (t225 + t226);
        let f7_y = MSX7 * t233 - MSY7 * (t224 + t226);
        let f7_z = MSX7 * t236 + MSY7 * t237;
        let n7_x = t264 - MSY7 * t210;
        let n7_y = t265 + MSX7 * t210;
        let n7_z = t266 + (MSX7 * a7_y - MSY7 * a7_x);
        let t286 = c7 * f7_x - s7 * f7_y;
        let t289 = s7 * f7_x + c7 * f7_y;
        let t292 = c7 * n7_x - s7 * n7_y;
        let t298 = s7 * n7_x + c7 * n7_y - k4 * f7_z;
        let t299 = n7_z + k4 * t289;
        [f7_z, n7_z, t286, t289, t292, t298, t299]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t354, t357, t360, t363] = {
        let t321 = ZZ6R * dw6_z - XX6R * t195 + XY6R * (t192 - t193) - XZ6 * t203;
        let t323 = YZ6 * (t193 - t194);
        let t324 = YZ6 * t199;
        let t326 = ZZ6R * t197 + XX6R * dw6_x - XY6R * t204 + XZ6 * t201 + t323;
        let t327 = t196 * (XX6R - ZZ6R) + XY6R * t205 + XZ6 * (t194 - t192) - t324;
        let f6_x = t286 + (MSY6R * t199 - MSX6R * t198);
        let f6_y = MSX6R * t201 - MSY6R * t202 - f7_z;
        let f6_z = t289 + (MSX6R * t204 + MSY6R * t205);
        let n6_x = t292 + (t326 + MSY6R * a6_z);
        let n6_y = t327 - MSX6R * a6_z - t299;
        let n6_z = t298 + (t321 + YZ6 * t200 + (MSX6R * a6_y - MSY6R * a6_x));
        let t354 = c6 * f6_x - s6 * f6_y;
        let t357 = s6 * f6_x + c6 * f6_y;
        let t360 = c6 * n6_x - s6 * n6_y;
        let t363 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t354, t357, t360, t363]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t418, t421, t433, t434, t435] = {
        let t385 = XX5R * t157 + ZZ5R * dw5_z + XY5 * (t154 - t155) + XZ5 * t165;
        let t387 = YZ5 * (t155 - t156);
        let t388 = YZ5 * t161;
        let t390 = XX5R * dw5_x - ZZ5R * t159 - XY5 * t166 + XZ5 * t163 + t387;
        let t391 = t158 * (XX5R - ZZ5R) + XY5 * t167 + XZ5 * (t156 - t154) + t388;
        let f5_x = t354 - (MSX5 * t160 + MSY5R * t161);
        let f5_y = MSX5 * t163 - MSY5R * t164 - f6_z;
        let f5_z = t357 + (MSX5 * t166 + MSY5R * t167);
        let n5_x = t360 + (t390 + MSY5R * a5_z);
        let n5_y = t391 - MSX5 * a5_z - n6_z;
        let n5_z = t363 + (t385 + YZ5 * t162 - (MSX5 * a6_z + MSY5R * a5_x));
        let t418 = c5 * f5_x - s5 * f5_y;
        let t421 = s5 * f5_x + c5 * f5_y;
        let t433 = c5 * n5_x - s5 * n5_y - L3 * t421;
        let t434 = s5 * n5_x + c5 * n5_y + (L3 * t418 + A * f5_z);
        let t435 = n5_z - A * t421;
        [f5_z, n5_z, t418, t421, t433, t434, t435]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t490, t496, t502, t503] = {
        let t457 = ZZ4R * dw4_z - XX4R * t107 + XY4R * (t104 - t105) - XZ4 * t115;
        let t459 = YZ4 * (t105 - t106);
        let t460 = YZ4 * t111;
        let t462 = ZZ4R * t109 + XX4R * dw4_x - XY4R * t116 + XZ4 * t113 + t459;
        let t463 = t108 * (XX4R - ZZ4R) + XY4R * t117 + XZ4 * (t106 - t104) - t460;
        let f4_x = t418 + (MSY4R * t111 - MSX4R * t110);
        let f4_y = f5_z + (MSX4R * t113 - MSY4R * t114);
        let f4_z = MSX4R * t116 + MSY4R * t117 - t421;
        let n4_x = t433 + (t462 - MSY4R * t78);
        let n4_y = t435 + (t463 + MSX4R * t78);
        let n4_z = t457 + YZ4 * t112 + (MSX4R * a4_y - MSY4R * a4_x) - t434;
        let t490 = c4 * f4_x - s4 * f4_y;
        let t496 = c4 * n4_x - s4 * n4_y;
        let t502 = s4 * n4_x + c4 * n4_y - A * f4_z;
        let t503 = n4_z + A * (s4 * f4_x + c4 * f4_y);
        [f4_z, n4_z, t490, t496, t502, t503]
    };
    // link 3: force and moment
    let [n3_z, t566, t567] = {
        let t525 = ZZ3R * dw3_z - XX3R * t63 + XY3R * (t60 - t61) - XZ3 * t71;
        let t527 = YZ3 * (t61 - t62);
        let t528 = YZ3 * t67;
        let t530 = ZZ3R * t65 + XX3R * dw3_x - XY3R * t72 + XZ3 * t69 + t527;
        let t531 = t64 * (XX3R - ZZ3R) + XY3R * t73 + XZ3 * (t62 - t60) - t528;
        let f3_x = t490 + (MSY3R * t67 - MSX3R * t66);
        let f3_y = MSX3R * t69 - MSY3R * t70 - f4_z;
        let n3_x = t496 + (t530 - MSY3R * t35);
        let n3_y = t531 + MSX3R * t35 - t503;
        let n3_z = t502 + (t525 + YZ3 * t68 + (MSX3R * a3_y - MSY3R * a3_x));
        let t566 = c3 * n3_x - s3 * n3_y - L2 * (s3 * f3_x + c3 * f3_y);
        let t567 = s3 * n3_x + c3 * n3_y + L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, t566, t567]
    };
    // link 2: force and moment
    let [n2_z, t606] = {
        let t589 = ZZ2R * ddq2 - XX2R * t25 + XY2 * (t22 - t23) - XZ2 * t2;
        let t591 = YZ2 * (t23 - t24);
        let t592 = YZ2 * t26;
        let t594 = XY2 * t29 - (ZZ2R * t6 + XX2R * t8) + XZ2 * t27 + t591;
        let t595 = XZ2 * (t24 - t22) - (t7 * (XX2R - ZZ2R) + XY2 * t30) - t592;
        let n2_x = t566 + t594;
        let n2_y = t595 - n3_z;
        let n2_z = t567 + (t589 - YZ2 * t3 + (MSY2R * t4 - MSX2 * t5));
        let t606 = s2 * n2_x + c2 * n2_y;
        [n2_z, t606]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = ZZ1R * ddq1 - t606;
        n1_z
    };
    // drives
    {
        let t644 = FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t645 = FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t646 = FO3 + (n3_z + FV3 * dq3 + FC3 * dq3.sign());
        let t647 = FO4 + (n4_z + FV4 * dq4 + FC4 * dq4.sign());
        let t648 = FO5 + (n5_z + FV5 * dq5 + FC5 * dq5.sign());
        let t649 = FO6 + (n6_z + FV6 * dq6 + FC6 * dq6.sign());
        let t650 = FO7 + (n7_z + FV7 * dq7 + FC7 * dq7.sign());
        put(0, t644);
        put(1, t645);
        put(2, t646);
        put(3, t647);
        put(4, t648);
        put(5, t649);
        put(6, t650);
    }
}
