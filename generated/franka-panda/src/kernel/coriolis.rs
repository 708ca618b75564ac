//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 288 multiplications, 269 additions; 7, 7 of 7 structurally nonzero.

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
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let [
        _, _, _, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3R, MSY3R, XX3R, ZZ3R,
        XY3R, XZ3, YZ3, MSX4R, MSY4R, XX4R, ZZ4R, XY4R, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6R, MSY6R, XX6R, ZZ6R, XY6R, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7,
        ..] = *beta;
    let A = S::constant(0.0825);
    let L2 = S::constant(0.316);
    let L3 = S::constant(0.384);
    let k3 = S::constant(0.088);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        t1, t2, t5, dw2_y, t7, t8, t9, t10,
        t11, t12,
    ] = {
        let t1 = s2 * dq1;
        let t2 = c2 * dq1;
        let t3 = t1 * t1;
        let t4 = dq2 * dq2;
        let t5 = t1 * t2;
        let dw2_y = dq2 * t1;
        let t7 = dq2 * t2;
        let t8 = t3 - t4;
        let t9 = t8 - t0;
        let t10 = t3 + t4;
        let t11 = dw2_y + dw2_y;
        let t12 = t7 + t7;
        [
        t1, t2, t5, dw2_y, t7, t8, t9, t10,
        t11, t12,
    ]
    };
    // link 3: motion
    let [
        w3_x, w3_y, t20, a3_x, a3_y, t30, t33, w3_z,
        t37, t38, t39, dw3_x, dw3_y, t42, t43, t44,
        t45, t46, t47, t48,
    ] = {
        let w3_x = s3 * dq2 - c3 * t1;
        let w3_y = c3 * dq2 + s3 * t1;
        let t19 = L2 * t5;
        let t20 = L2 * t10;
        let t21 = L2 * t12;
        let a3_x = s3 * t21 - c3 * t19;
        let a3_y = c3 * t21 + s3 * t19;
        let t30 = s3 * t12 - c3 * t5;
        let t33 = c3 * t12 + s3 * t5;
        let w3_z = t2 + dq3;
        let t35 = w3_x * w3_x;
        let t36 = w3_z * w3_z;
        let t37 = w3_x * w3_y;
        let t38 = w3_x * w3_z;
        let t39 = w3_y * w3_z;
        let dw3_x = t39 - t33;
        let dw3_y = t30 - t38;
        let t42 = t35 - t36;
        let t43 = t42 - t10;
        let t44 = dw2_y + t37;
        let t45 = t37 - dw2_y;
        let t46 = t35 + t36;
        let t47 = t38 - dw3_y;
        let t48 = t39 + dw3_x;
        [
        w3_x, w3_y, t20, a3_x, a3_y, t30, t33, w3_z,
        t37, t38, t39, dw3_x, dw3_y, t42, t43, t44,
        t45, t46, t47, t48,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t59, a4_x, a4_y, t69, t72, w4_z,
        t76, t77, t78, dw4_x, t80, t81, t82, t83,
        t84, t85, t86, t87,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t58 = a3_x + A * t43;
        let t59 = a3_y + A * t45;
        let t60 = A * t47 - t20;
        let a4_x = c4 * t58 + s4 * t60;
        let a4_y = c4 * t60 - s4 * t58;
        let t69 = c4 * t44 + s4 * t48;
        let t72 = s4 * t44 - c4 * t48;
        let w4_z = dq4 - w3_y;
        let t74 = w4_x * w4_x;
        let t75 = w4_z * w4_z;
        let t76 = w4_x * w4_y;
        let t77 = w4_x * w4_z;
        let t78 = w4_y * w4_z;
        let dw4_x = t78 - t72;
        let t80 = t69 + t77;
        let t81 = t74 - t75;
        let t82 = t81 - t46;
        let t83 = dw3_y + t76;
        let t84 = t76 - dw3_y;
        let t85 = t74 + t75;
        let t86 = t77 + t80;
        let t87 = t78 + dw4_x;
        [
        w4_x, w4_y, t59, a4_x, a4_y, t69, t72, w4_z,
        t76, t77, t78, dw4_x, t80, t81, t82, t83,
        t84, t85, t86, t87,
    ]
    };
    // link 5: motion
    let [
        w5_x, t93, a5_z, a5_x, a6_z, t114, t117, w5_z,
        t121, t122, t123, dw5_x, dw5_y, t126, t127, t128,
        t129, t130, t131, t132,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t93 = c5 * w4_z + s5 * w4_x;
        let t103 = a4_x + (L3 * t83 - A * t82);
        let a5_z = a4_y - (A * t84 + L3 * t85);
        let t105 = L3 * t87 - A * t86 - t59;
        let a5_x = c5 * t103 - s5 * t105;
        let a6_z = c5 * t105 + s5 * t103;
        let t114 = c5 * t83 - s5 * t87;
        let t117 = c5 * t87 + s5 * t83;
        let w5_z = w4_y + dq5;
        let t119 = w5_x * w5_x;
        let t120 = w5_z * w5_z;
        let t121 = w5_x * t93;
        let t122 = w5_x * w5_z;
        let t123 = t93 * w5_z;
        let dw5_x = t117 - t123;
        let dw5_y = t114 - t122;
        let t126 = t119 - t120;
        let t127 = t126 - t85;
        let t128 = t80 - t121;
        let t129 = t80 + t121;
        let t130 = t119 + t120;
        let t131 = t122 - dw5_y;
        let t132 = dw5_x - t123;
        [
        w5_x, t93, a5_z, a5_x, a6_z, t114, t117, w5_z,
        t121, t122, t123, dw5_x, dw5_y, t126, t127, t128,
        t129, t130, t131, t132,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, a6_x, a6_y, t147, t150, w6_z, t154,
        t155, t156, dw6_x, dw7_z, t159, t160, t161, t162,
        t163, t164, t165,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let a6_x = c6 * a5_x + s6 * a5_z;
        let a6_y = c6 * a5_z - s6 * a5_x;
        let t147 = c6 * t128 + s6 * t132;
        let t150 = s6 * t128 - c6 * t132;
        let w6_z = t93 + dq6;
        let t152 = w6_x * w6_x;
        let t153 = w6_z * w6_z;
        let t154 = w6_x * w6_y;
        let t155 = w6_x * w6_z;
        let t156 = w6_y * w6_z;
        let dw6_x = t156 - t150;
        let dw7_z = t147 + t155;
        let t159 = t152 - t153;
        let t160 = t159 - t130;
        let t161 = dw5_y + t154;
        let t162 = t154 - dw5_y;
        let t163 = t152 + t153;
        let t164 = t155 + dw7_z;
        let t165 = t156 + dw6_x;
        [
        w6_x, w6_y, a6_x, a6_y, t147, t150, w6_z, t154,
        t155, t156, dw6_x, dw7_z, t159, t160, t161, t162,
        t163, t164, t165,
    ]
    };
    // link 7: motion
    let [
        t176, a7_x, a7_y, t186, t189, t193, t194, t195,
        dw7_x, t198, t199, t200, t201, t202, t203, t204,
    ] = {
        let w7_x = c7 * w6_x + s7 * w6_z;
        let w7_y = c7 * w6_z - s7 * w6_x;
        let t175 = a6_x + k3 * t160;
        let t176 = a6_y + k3 * t162;
        let t177 = a6_z + k3 * t164;
        let a7_x = c7 * t175 + s7 * t177;
        let a7_y = c7 * t177 - s7 * t175;
        let t186 = c7 * t161 + s7 * t165;
        let t189 = s7 * t161 - c7 * t165;
        let w7_z = dq7 - w6_y;
        let t191 = w7_x * w7_x;
        let t192 = w7_z * w7_z;
        let t193 = w7_x * w7_y;
        let t194 = w7_x * w7_z;
        let t195 = w7_y * w7_z;
        let dw7_x = t195 - t189;
        let t198 = t191 - t192;
        let t199 = t198 - t163;
        let t200 = t193 - dw7_z;
        let t201 = dw7_z + t193;
        let t202 = t191 + t192;
        let t203 = t194 + (t186 + t194);
        let t204 = t195 + dw7_x;
        [
        t176, a7_x, a7_y, t186, t189, t193, t194, t195,
        dw7_x, t198, t199, t200, t201, t202, t203, t204,
    ]
    };
    // link 7: force and moment
    let [f7_z, t252, t255, t258, t264, t265] = {
        let t225 = ZZ7 * dw7_z - XX7R * t193 + XY7 * (t199 + t202) - XZ7 * t189;
        let t227 = YZ7 * (t163 - t202);
        let t230 = ZZ7 * t195 + XX7R * dw7_x - XY7 * t203 + XZ7 * t201 + t227;
        let t231 = t194 * (XX7R - ZZ7) + XY7 * t204 - XZ7 * t198 - YZ7 * t200;
        let f7_x = MSX7 * t199 + MSY7 * t200;
        let f7_y = MSX7 * t201 - MSY7 * t202;
        let f7_z = MSX7 * t203 + MSY7 * t204;
        let n7_x = t230 - MSY7 * t176;
        let n7_y = t231 + MSX7 * t176;
        let n7_z = t225 - YZ7 * t186 + (MSX7 * a7_y - MSY7 * a7_x);
        let t252 = c7 * f7_x - s7 * f7_y;
        let t255 = s7 * f7_x + c7 * f7_y;
        let t258 = c7 * n7_x - s7 * n7_y;
        let t264 = s7 * n7_x + c7 * n7_y - k3 * f7_z;
        let t265 = n7_z + k3 * t255;
        put(6, n7_z);
        [f7_z, t252, t255, t258, t264, t265]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t319, t322, t325, t328] = {
        let t286 = XY6R * (t160 + t163) - (XX6R * t154 + ZZ6R * dw5_y) - XZ6 * t150;
        let t288 = YZ6 * (t130 - t163);
        let t291 = ZZ6R * t156 + XX6R * dw6_x - XY6R * t164 + XZ6 * t162 + t288;
        let t292 = t155 * (XX6R - ZZ6R) + XY6R * t165 - XZ6 * t159 - YZ6 * t161;
        let f6_x = t252 + (MSX6R * t160 + MSY6R * t161);
        let f6_y = MSX6R * t162 - MSY6R * t163 - f7_z;
        let f6_z = t255 + (MSX6R * t164 + MSY6R * t165);
        let n6_x = t258 + (t291 + MSY6R * a6_z);
        let n6_y = t292 - MSX6R * a6_z - t265;
        let n6_z = t264 + (t286 - YZ6 * t147 + (MSX6R * a6_y - MSY6R * a6_x));
        let t319 = c6 * f6_x - s6 * f6_y;
        let t322 = s6 * f6_x + c6 * f6_y;
        let t325 = c6 * n6_x - s6 * n6_y;
        let t328 = s6 * n6_x + c6 * n6_y;
        put(5, n6_z);
        [f6_z, n6_z, t319, t322, t325, t328]
    };
    // link 5: force and moment
    let [f5_z, t382, t385, t397, t398, t399] = {
        let t349 = XX5R * t121 - ZZ5R * t80 + XY5 * (t127 + t130) + XZ5 * t117;
        let t351 = YZ5 * (t85 - t130);
        let t354 = XX5R * dw5_x - ZZ5R * t123 - XY5 * t131 - XZ5 * t129 + t351;
        let t355 = t122 * (XX5R - ZZ5R) + XY5 * t132 - XZ5 * t126 - YZ5 * t128;
        let f5_x = t319 + (MSX5 * t127 + MSY5R * t128);
        let t375 = f6_z + (MSX5 * t129 + MSY5R * t130);
        let f5_z = t322 + (MSX5 * t131 + MSY5R * t132);
        let n5_x = t325 + (t354 + MSY5R * a5_z);
        let n5_y = t355 - MSX5 * a5_z - n6_z;
        let n5_z = t328 + (t349 + YZ5 * t114 - (MSX5 * a6_z + MSY5R * a5_x));
        let t382 = c5 * f5_x + s5 * t375;
        let t385 = s5 * f5_x - c5 * t375;
        let t397 = c5 * n5_x - s5 * n5_y - L3 * t385;
        let t398 = s5 * n5_x + c5 * n5_y + (L3 * t382 + A * f5_z);
        let t399 = n5_z - A * t385;
        put(4, n5_z);
        [f5_z, t382, t385, t397, t398, t399]
    };
    // link 4: force and moment
    let [f4_z, t453, t459, t465, t466] = {
        let t420 = XY4R * (t82 + t85) - (XX4R * t76 + ZZ4R * dw3_y) - XZ4 * t72;
        let t422 = YZ4 * (t46 - t85);
        let t425 = ZZ4R * t78 + XX4R * dw4_x - XY4R * t86 + XZ4 * t84 + t422;
        let t426 = t77 * (XX4R - ZZ4R) + XY4R * t87 - XZ4 * t81 - YZ4 * t83;
        let f4_x = t382 + (MSX4R * t82 + MSY4R * t83);
        let f4_y = f5_z + (MSX4R * t84 - MSY4R * t85);
        let f4_z = MSX4R * t86 + MSY4R * t87 - t385;
        let n4_x = t397 + (t425 - MSY4R * t59);
        let n4_y = t399 + (t426 + MSX4R * t59);
        let n4_z = t420 - YZ4 * t69 + (MSX4R * a4_y - MSY4R * a4_x) - t398;
        let t453 = c4 * f4_x - s4 * f4_y;
        let t459 = c4 * n4_x - s4 * n4_y;
        let t465 = s4 * n4_x + c4 * n4_y - A * f4_z;
        let t466 = n4_z + A * (s4 * f4_x + c4 * f4_y);
        put(3, n4_z);
        [f4_z, t453, t459, t465, t466]
    };
    // link 3: force and moment
    let [n3_z, t528, t529] = {
        let t487 = XY3R * (t43 + t46) - (XX3R * t37 + ZZ3R * dw2_y) - XZ3 * t33;
        let t489 = YZ3 * (t10 - t46);
        let t492 = ZZ3R * t39 + XX3R * dw3_x - XY3R * t47 + XZ3 * t45 + t489;
        let t493 = t38 * (XX3R - ZZ3R) + XY3R * t48 - XZ3 * t42 - YZ3 * t44;
        let f3_x = t453 + (MSX3R * t43 + MSY3R * t44);
        let f3_y = MSX3R * t45 - MSY3R * t46 - f4_z;
        let n3_x = t459 + (t492 - MSY3R * t20);
        let n3_y = t493 + MSX3R * t20 - t466;
        let n3_z = t465 + (t487 + YZ3 * t30 + (MSX3R * a3_y - MSY3R * a3_x));
        let t528 = c3 * n3_x - s3 * n3_y - L2 * (s3 * f3_x + c3 * f3_y);
        let t529 = s3 * n3_x + c3 * n3_y + L2 * (c3 * f3_x - s3 * f3_y);
        put(2, n3_z);
        [n3_z, t528, t529]
    };
    // link 2: force and moment
    {
        let t547 = YZ2 * (t0 - t10);
        let t550 = dw2_y * (XX2R - ZZ2R) + XY2 * t12 + XZ2 * t8 + YZ2 * t5;
        let n2_x = t528 + (XY2 * t11 - t7 * (XX2R + ZZ2R) + XZ2 * t5 + t547);
        let n2_z = t529 + (XY2 * (t9 + t10) - XX2R * t5);
        let n1_z = c2 * (n3_z + t550) - s2 * n2_x;
        put(0, n1_z);
        put(1, n2_z);
    }
}
