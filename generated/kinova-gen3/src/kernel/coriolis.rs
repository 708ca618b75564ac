//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 296 multiplications, 270 additions; 7, 7 of 7 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, Trig};

/// Coriolis and centrifugal torques `C dq`: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], out: &mut [S; 7]) {
    entries(trig, dq, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let [
        _, MSX2, MSY2R, XX2R, _, XY2, XZ2, YZ2, MSX3, MSY3R, XX3R, ZZ3R,
        XY3, XZ3, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6R, XX6R, ZZ6R, XY6, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7,
        ..] = *beta;
    let k0 = S::constant(0.01175);
    let k1 = S::constant(0.42076);
    let k2 = S::constant(0.01275);
    let k3 = S::constant(0.31436);
    let k4 = S::constant(0.00035);
    let k5 = S::constant(0.167455);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        a2_z, w2_x, w2_y, t5, t6, t7, t10, t11,
        t12,
    ] = {
        let a2_z = t0 * k0;
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t4 = w2_x * w2_x;
        let t5 = dq2 * dq2;
        let t6 = w2_x * w2_y;
        let t7 = dq2 * w2_x;
        let dw2_x = dq2 * w2_y;
        let t10 = t4 - t5 - t0;
        let t11 = t4 + t5;
        let t12 = dw2_x + dw2_x;
        [
        a2_z, w2_x, w2_y, t5, t6, t7, t10, t11,
        t12,
    ]
    };
    // link 3: motion
    let [
        a3_z, t19, t22, w3_x, t28, t31, t34, w3_z,
        t38, t39, t40, dw3_x, t42, t43, t44, t45,
        t46, t47, t48, t49,
    ] = {
        let t13 = t6 * k1;
        let a3_z = t11 * k1;
        let t16 = a2_z - t12 * k1;
        let t19 = c3 * t13 + s3 * t16;
        let t22 = c3 * t16 - s3 * t13;
        let w3_x = c3 * w2_x - s3 * dq2;
        let t28 = c3 * dq2 + s3 * w2_x;
        let t31 = s3 * t12 - c3 * t6;
        let t34 = c3 * t12 + s3 * t6;
        let w3_z = w2_y + dq3;
        let t36 = w3_x * w3_x;
        let t37 = w3_z * w3_z;
        let t38 = w3_x * t28;
        let t39 = w3_x * w3_z;
        let t40 = t28 * w3_z;
        let dw3_x = t34 - t40;
        let t42 = t31 + t39;
        let t43 = t37 - t36;
        let t44 = t11 + t43;
        let t45 = t7 - t38;
        let t46 = t7 + t38;
        let t47 = t36 + t37;
        let t48 = t39 + t42;
        let t49 = t40 - dw3_x;
        [
        a3_z, t19, t22, w3_x, t28, t31, t34, w3_z,
        t38, t39, t40, dw3_x, t42, t43, t44, t45,
        t46, t47, t48, t49,
    ]
    };
    // link 4: motion
    let [
        t54, a4_x, t61, w4_x, w4_y, t70, t73, w4_z,
        t77, t78, t79, dw4_x, t81, t82, t83, t84,
        t85, t86, t87, t88,
    ] = {
        let t53 = t45 * k2 - t19;
        let t54 = t22 + t47 * k2;
        let t55 = a3_z - t49 * k2;
        let a4_x = c4 * t53 + s4 * t55;
        let t61 = s4 * t53 - c4 * t55;
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t70 = s4 * t49 - c4 * t45;
        let t73 = c4 * t49 + s4 * t45;
        let w4_z = t28 + dq4;
        let t75 = w4_x * w4_x;
        let t76 = w4_z * w4_z;
        let t77 = w4_x * w4_y;
        let t78 = w4_x * w4_z;
        let t79 = w4_y * w4_z;
        let dw4_x = t79 - t73;
        let t81 = t78 - t70;
        let t82 = t75 - t76;
        let t83 = t82 - t47;
        let t84 = t77 - t42;
        let t85 = t42 + t77;
        let t86 = t75 + t76;
        let t87 = t78 + t81;
        let t88 = t79 + dw4_x;
        [
        t54, a4_x, t61, w4_x, w4_y, t70, t73, w4_z,
        t77, t78, t79, dw4_x, t81, t82, t83, t84,
        t85, t86, t87, t88,
    ]
    };
    // link 5: motion
    let [
        a5_z, a5_x, a5_y, w5_x, t106, t109, t112, w5_z,
        t116, t117, t118, dw5_x, t120, t121, t122, t123,
        t124, t125, t126, t127,
    ] = {
        let t92 = a4_x - t84 * k3;
        let a5_z = t86 * k3 - t61;
        let t94 = t88 * k3 - t54;
        let a5_x = c5 * t92 + s5 * t94;
        let a5_y = c5 * t94 - s5 * t92;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t106 = c5 * w4_z + s5 * w4_x;
        let t109 = c5 * t84 - s5 * t88;
        let t112 = c5 * t88 + s5 * t84;
        let w5_z = w4_y + dq5;
        let t114 = w5_x * w5_x;
        let t115 = w5_z * w5_z;
        let t116 = w5_x * t106;
        let t117 = w5_x * w5_z;
        let t118 = t106 * w5_z;
        let dw5_x = t112 - t118;
        let t120 = t117 - t109;
        let t121 = t114 - t115;
        let t122 = t121 - t86;
        let t123 = t116 - t81;
        let t124 = t81 + t116;
        let t125 = t114 + t115;
        let t126 = t117 + t120;
        let t127 = dw5_x - t118;
        [
        a5_z, a5_x, a5_y, w5_x, t106, t109, t112, w5_z,
        t116, t117, t118, dw5_x, t120, t121, t122, t123,
        t124, t125, t126, t127,
    ]
    };
    // link 6: motion
    let [
        t132, a6_x, a6_y, w6_x, t145, t148, t151, w6_z,
        t155, t156, t157, dw6_x, t159, t160, t161, t162,
        t163, t164, t165, t166,
    ] = {
        let t131 = a5_x - t123 * k4;
        let t132 = a5_y - t125 * k4;
        let t133 = a5_z + t127 * k4;
        let a6_x = c6 * t131 + s6 * t133;
        let a6_y = c6 * t133 - s6 * t131;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let t145 = s6 * w5_x - c6 * w5_z;
        let t148 = s6 * t127 - c6 * t123;
        let t151 = c6 * t127 + s6 * t123;
        let w6_z = t106 + dq6;
        let t153 = w6_x * w6_x;
        let t154 = w6_z * w6_z;
        let t155 = w6_x * t145;
        let t156 = w6_x * w6_z;
        let t157 = t145 * w6_z;
        let dw6_x = t151 - t157;
        let t159 = t148 + t156;
        let t160 = t153 - t154;
        let t161 = t160 - t125;
        let t162 = t120 + t155;
        let t163 = t120 - t155;
        let t164 = t153 + t154;
        let t165 = t156 + t159;
        let t166 = t157 - dw6_x;
        [
        t132, a6_x, a6_y, w6_x, t145, t148, t151, w6_z,
        t155, t156, t157, dw6_x, t159, t160, t161, t162,
        t163, t164, t165, t166,
    ]
    };
    // link 7: motion
    let [
        t169, t172, t181, t184, t188, t189, t190, dw7_x,
        t193, t194, t195, t196, t197, t198, t199,
    ] = {
        let t169 = c7 * a6_x + s7 * t132;
        let t172 = s7 * a6_x - c7 * t132;
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t178 = c7 * w6_z + s7 * w6_x;
        let t181 = s7 * t166 - c7 * t162;
        let t184 = c7 * t166 + s7 * t162;
        let t185 = t145 - dq7;
        let t186 = w7_x * w7_x;
        let t187 = t185 * t185;
        let t188 = w7_x * t178;
        let t189 = w7_x * t185;
        let t190 = t178 * t185;
        let dw7_x = t190 - t184;
        let dw7_y = t181 + t189;
        let t193 = t186 - t187;
        let t194 = t164 - t193;
        let t195 = t188 - t159;
        let t196 = t159 + t188;
        let t197 = t186 + t187;
        let t198 = t189 + dw7_y;
        let t199 = t190 + dw7_x;
        [
        t169, t172, t181, t184, t188, t189, t190, dw7_x,
        t193, t194, t195, t196, t197, t198, t199,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t251, t254, t257, t260] = {
        let t201 = XZ7 + MSX7 * k5;
        let t203 = YZ7 + MSY7 * k5;
        let t224 = ZZ7 * t159 - XX7R * t188 - XY7 * (t197 - t194) + t184 * t201;
        let t226 = t203 * (t164 - t197);
        let t229 = ZZ7 * t190 + XX7R * dw7_x + XY7 * t198 - t196 * t201 + t226;
        let t230 = t195 * t203 - (t189 * (XX7R - ZZ7) - XY7 * t199 + t193 * t201);
        let t234 = MSX7 * t194 + MSY7 * t195;
        let t237 = MSX7 * t196 + MSY7 * t197;
        let f7_z = MSY7 * t199 - MSX7 * t198;
        let n7_x = t229 + MSY7 * a6_y;
        let t247 = MSX7 * a6_y - t230;
        let n7_z = t181 * t203 - t224 - (MSX7 * t172 + MSY7 * t169);
        let t251 = c7 * t234 - s7 * t237;
        let t254 = s7 * t234 + c7 * t237;
        let t257 = c7 * n7_x + s7 * t247;
        let t260 = s7 * n7_x - c7 * t247;
        put(6, n7_z);
        [f7_z, n7_z, t251, t254, t257, t260]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t314, t317, t326, t327] = {
        let t281 = XX6R * t155 + ZZ6R * t120 + XY6 * (t161 + t164) + XZ6 * t151;
        let t283 = YZ6 * (t125 - t164);
        let t286 = XX6R * dw6_x - ZZ6R * t157 - XY6 * t165 + XZ6 * t163 + t283;
        let t287 = t156 * (XX6R - ZZ6R) - XY6 * t166 - XZ6 * t160 + YZ6 * t162;
        let t306 = t251 - (MSX6 * t161 - MSY6R * t162);
        let f6_y = f7_z - (MSY6R * t164 - MSX6 * t163);
        let f6_z = t254 + (MSX6 * t165 - MSY6R * t166);
        let n6_x = t257 + (t286 - MSY6R * t132);
        let n6_y = n7_z + (t287 + MSX6 * t132);
        let n6_z = t281 - YZ6 * t148 + (MSX6 * a6_y - MSY6R * a6_x) - t260;
        let t314 = c6 * t306 + s6 * f6_y;
        let t317 = s6 * t306 - c6 * f6_y;
        let t326 = s6 * n6_y - c6 * n6_x + k4 * t317;
        let t327 = s6 * n6_x + c6 * n6_y + k4 * t314;
        put(5, n6_z);
        [f6_z, n6_z, t314, t317, t326, t327]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t381, t384, t393, t394] = {
        let t348 = XX5R * t116 - ZZ5R * t81 + XY5 * (t122 + t125) + XZ5 * t112;
        let t350 = YZ5 * (t86 - t125);
        let t353 = XX5R * dw5_x - ZZ5R * t118 - XY5 * t126 - XZ5 * t124 + t350;
        let t354 = t117 * (XX5R - ZZ5R) + XY5 * t127 - XZ5 * t121 + YZ5 * t123;
        let t373 = t314 + (MSY5R * t123 - MSX5 * t122);
        let t374 = f6_z + (MSX5 * t124 + MSY5R * t125);
        let f5_z = MSX5 * t126 + MSY5R * t127 - t317;
        let n5_x = t353 + MSY5R * a5_z - t326;
        let t377 = n6_z - (t354 - MSX5 * a5_z);
        let n5_z = t327 + (t348 + YZ5 * t109 + (MSX5 * a5_y - MSY5R * a5_x));
        let t381 = c5 * t373 - s5 * t374;
        let t384 = s5 * t373 + c5 * t374;
        let t393 = c5 * n5_x + s5 * t377 - k3 * t384;
        let t394 = c5 * t377 - s5 * n5_x - k3 * t381;
        put(4, n5_z);
        [f5_z, n5_z, t381, t384, t393, t394]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t448, t451, t460, t461] = {
        let t415 = ZZ4R * t42 - XX4R * t77 + XY4 * (t83 + t86) - XZ4 * t73;
        let t417 = YZ4 * (t86 - t47);
        let t420 = ZZ4R * t79 + XX4R * dw4_x - XY4 * t87 + XZ4 * t85 - t417;
        let t421 = t78 * (XX4R - ZZ4R) + XY4 * t88 - XZ4 * t82 - YZ4 * t84;
        let f4_x = MSX4 * t83 + MSY4R * t84 - t381;
        let f4_y = f5_z + (MSX4 * t85 - MSY4R * t86);
        let f4_z = t384 + (MSX4 * t87 + MSY4R * t88);
        let n4_x = t393 + (t420 + MSY4R * t54);
        let n4_y = n5_z - (MSX4 * t54 - t421);
        let n4_z = t394 - (MSX4 * t61 + MSY4R * a4_x - (t415 + YZ4 * t70));
        let t448 = c4 * f4_x - s4 * f4_y;
        let t451 = s4 * f4_x + c4 * f4_y;
        let t460 = c4 * n4_x - s4 * n4_y + k2 * t451;
        let t461 = s4 * n4_x + c4 * n4_y - k2 * t448;
        put(3, n4_z);
        [f4_z, n4_z, t448, t451, t460, t461]
    };
    // link 3: force and moment
    let [f3_z, n3_z, t515, t527, t528] = {
        let t482 = XX3R * t38 - ZZ3R * t7 + XY3 * (t47 - t44) + XZ3 * t34;
        let t484 = YZ3 * (t11 - t47);
        let t487 = XX3R * dw3_x - ZZ3R * t40 - XY3 * t48 - XZ3 * t46 + t484;
        let t488 = t39 * (XX3R - ZZ3R) - XY3 * t49 + XZ3 * t43 - YZ3 * t45;
        let f3_x = t448 + (MSY3R * t45 - MSX3 * t44);
        let t508 = f4_z + (MSX3 * t46 + MSY3R * t47);
        let f3_z = t451 + (MSX3 * t48 - MSY3R * t49);
        let n3_x = t460 + (t487 + MSY3R * a3_z);
        let n3_y = t488 - MSX3 * a3_z - n4_z;
        let n3_z = t461 + (t482 - YZ3 * t31 - (MSX3 * t22 - MSY3R * t19));
        let t515 = c3 * f3_x + s3 * t508;
        let t527 = c3 * n3_x - s3 * n3_y + k1 * (s3 * f3_x - c3 * t508);
        let t528 = s3 * n3_x + c3 * n3_y - k1 * t515;
        put(2, n3_z);
        [f3_z, n3_z, t515, t527, t528]
    };
    // link 2: force and moment
    let [t542, t564] = {
        let t534 = XY2 - c2 * (s2 * XX2R + c2 * (XY2 + XY2));
        let t542 = t5 * (c2 * XZ2 - s2 * YZ2) - (t534 + t534) * (dq1 * dq2);
        let f2_x = t515 + (MSX2 * t10 + MSY2R * t6);
        let f2_y = f3_z - (MSY2R * t11 - MSX2 * t6);
        let n2_x = t527 + MSY2R * a2_z;
        let n2_y = n3_z - MSX2 * a2_z;
        let n2_z = t0 * t534 - t528;
        let f1_x = c2 * f2_x - s2 * f2_y;
        let t564 = s2 * n2_x + c2 * n2_y - k0 * f1_x;
        put(1, n2_z);
        [t542, t564]
    };
    // link 1: force and moment
    {
        let n1_z = t542 + t564;
        put(0, n1_z);
    }
}
