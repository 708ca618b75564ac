//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 287 multiplications, 260 additions; 7, 7 of 7 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, Trig, constants};

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
        _, _, _, XX2R, _, XY2, XZ2, YZ2, MSX3R, MSY3R, XX3R, ZZ3R,
        XY3R, XZ3, YZ3, MSX4R, MSY4R, XX4R, ZZ4R, XY4R, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6R, MSY6R, XX6R, ZZ6R, XY6R, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7,
        ..] = *beta;
    let k3 = S::constant(0.088);
    let k_A = S::constant(constants::A);
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [t1, t2, t4, t5, dw2_y, t8, t9] = {
        let t1 = s2 * dq1;
        let t2 = c2 * dq1;
        let t4 = dq2 * dq2;
        let t5 = t1 * t2;
        let dw2_y = dq2 * t1;
        let t7 = dq2 * t2;
        let t8 = t1 * t1 + t4;
        let t9 = t7 + t7;
        [t1, t2, t4, t5, dw2_y, t8, t9]
    };
    // link 3: motion
    let [
        t11, a3_x, a3_y, w3_x, w3_y, t27, t30, w3_z,
        t34, t35, t36, dw3_x, dw3_y, t39, t40, t41,
        t42, t43, t44, t45,
    ] = {
        let t10 = k_L2 * t5;
        let t11 = k_L2 * t8;
        let t12 = k_L2 * t9;
        let a3_x = s3 * t12 - c3 * t10;
        let a3_y = c3 * t12 + s3 * t10;
        let w3_x = s3 * dq2 - c3 * t1;
        let w3_y = c3 * dq2 + s3 * t1;
        let t27 = s3 * t9 - c3 * t5;
        let t30 = c3 * t9 + s3 * t5;
        let w3_z = t2 + dq3;
        let t32 = w3_x * w3_x;
        let t33 = w3_z * w3_z;
        let t34 = w3_x * w3_y;
        let t35 = w3_x * w3_z;
        let t36 = w3_y * w3_z;
        let dw3_x = t36 - t30;
        let dw3_y = t27 - t35;
        let t39 = t32 - t33;
        let t40 = t39 - t8;
        let t41 = dw2_y + t34;
        let t42 = t34 - dw2_y;
        let t43 = t32 + t33;
        let t44 = t35 - dw3_y;
        let t45 = t36 + dw3_x;
        [
        t11, a3_x, a3_y, w3_x, w3_y, t27, t30, w3_z,
        t34, t35, t36, dw3_x, dw3_y, t39, t40, t41,
        t42, t43, t44, t45,
    ]
    };
    // link 4: motion
    let [
        t50, a4_x, a4_y, w4_x, w4_y, t66, t69, w4_z,
        t73, t74, t75, dw4_x, t77, t78, t79, t80,
        t81, t82, t83, t84,
    ] = {
        let t49 = a3_x + k_A * t40;
        let t50 = a3_y + k_A * t42;
        let t51 = k_A * t44 - t11;
        let a4_x = c4 * t49 + s4 * t51;
        let a4_y = c4 * t51 - s4 * t49;
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t66 = c4 * t41 + s4 * t45;
        let t69 = s4 * t41 - c4 * t45;
        let w4_z = dq4 - w3_y;
        let t71 = w4_x * w4_x;
        let t72 = w4_z * w4_z;
        let t73 = w4_x * w4_y;
        let t74 = w4_x * w4_z;
        let t75 = w4_y * w4_z;
        let dw4_x = t75 - t69;
        let t77 = t66 + t74;
        let t78 = t71 - t72;
        let t79 = t78 - t43;
        let t80 = dw3_y + t73;
        let t81 = t73 - dw3_y;
        let t82 = t71 + t72;
        let t83 = t74 + t77;
        let t84 = t75 + dw4_x;
        [
        t50, a4_x, a4_y, w4_x, w4_y, t66, t69, w4_z,
        t73, t74, t75, dw4_x, t77, t78, t79, t80,
        t81, t82, t83, t84,
    ]
    };
    // link 5: motion
    let [
        a5_z, a5_x, a6_z, w5_x, t108, t111, t114, w5_z,
        t118, t119, t120, dw5_x, dw5_y, t123, t124, t125,
        t126, t127, t128, t129,
    ] = {
        let t94 = a4_x + (k_L3 * t80 - k_A * t79);
        let a5_z = a4_y - (k_A * t81 + k_L3 * t82);
        let t96 = k_L3 * t84 - k_A * t83 - t50;
        let a5_x = c5 * t94 - s5 * t96;
        let a6_z = c5 * t96 + s5 * t94;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t108 = c5 * w4_z + s5 * w4_x;
        let t111 = c5 * t80 - s5 * t84;
        let t114 = c5 * t84 + s5 * t80;
        let w5_z = w4_y + dq5;
        let t116 = w5_x * w5_x;
        let t117 = w5_z * w5_z;
        let t118 = w5_x * t108;
        let t119 = w5_x * w5_z;
        let t120 = t108 * w5_z;
        let dw5_x = t114 - t120;
        let dw5_y = t111 - t119;
        let t123 = t116 - t117;
        let t124 = t123 - t82;
        let t125 = t77 - t118;
        let t126 = t77 + t118;
        let t127 = t116 + t117;
        let t128 = t119 - dw5_y;
        let t129 = dw5_x - t120;
        [
        a5_z, a5_x, a6_z, w5_x, t108, t111, t114, w5_z,
        t118, t119, t120, dw5_x, dw5_y, t123, t124, t125,
        t126, t127, t128, t129,
    ]
    };
    // link 6: motion
    let [
        a6_x, a6_y, w6_x, w6_y, t144, t147, w6_z, t151,
        t152, t153, dw6_x, dw7_z, t156, t157, t158, t159,
        t160, t161, t162,
    ] = {
        let a6_x = c6 * a5_x + s6 * a5_z;
        let a6_y = c6 * a5_z - s6 * a5_x;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t144 = c6 * t125 + s6 * t129;
        let t147 = s6 * t125 - c6 * t129;
        let w6_z = t108 + dq6;
        let t149 = w6_x * w6_x;
        let t150 = w6_z * w6_z;
        let t151 = w6_x * w6_y;
        let t152 = w6_x * w6_z;
        let t153 = w6_y * w6_z;
        let dw6_x = t153 - t147;
        let dw7_z = t144 + t152;
        let t156 = t149 - t150;
        let t157 = t156 - t127;
        let t158 = dw5_y + t151;
        let t159 = t151 - dw5_y;
        let t160 = t149 + t150;
        let t161 = t152 + dw7_z;
        let t162 = t153 + dw6_x;
        [
        a6_x, a6_y, w6_x, w6_y, t144, t147, w6_z, t151,
        t152, t153, dw6_x, dw7_z, t156, t157, t158, t159,
        t160, t161, t162,
    ]
    };
    // link 7: motion
    let [
        t167, a7_x, a7_y, t183, t186, t190, t191, t192,
        dw7_x, t195, t196, t197, t198, t199, t200, t201,
    ] = {
        let t166 = a6_x + k3 * t157;
        let t167 = a6_y + k3 * t159;
        let t168 = a6_z + k3 * t161;
        let a7_x = c7 * t166 + s7 * t168;
        let a7_y = c7 * t168 - s7 * t166;
        let w7_x = c7 * w6_x + s7 * w6_z;
        let w7_y = c7 * w6_z - s7 * w6_x;
        let t183 = c7 * t158 + s7 * t162;
        let t186 = s7 * t158 - c7 * t162;
        let w7_z = dq7 - w6_y;
        let t188 = w7_x * w7_x;
        let t189 = w7_z * w7_z;
        let t190 = w7_x * w7_y;
        let t191 = w7_x * w7_z;
        let t192 = w7_y * w7_z;
        let dw7_x = t192 - t186;
        let t195 = t188 - t189;
        let t196 = t195 - t160;
        let t197 = t190 - dw7_z;
        let t198 = dw7_z + t190;
        let t199 = t188 + t189;
        let t200 = t191 + (t183 + t191);
        let t201 = t192 + dw7_x;
        [
        t167, a7_x, a7_y, t183, t186, t190, t191, t192,
        dw7_x, t195, t196, t197, t198, t199, t200, t201,
    ]
    };
    // link 7: force and moment
    let [f7_z, t249, t252, t255, t261, t262] = {
        let t222 = ZZ7 * dw7_z - XX7R * t190 + XY7 * (t196 + t199) - XZ7 * t186;
        let t224 = YZ7 * (t160 - t199);
        let t227 = ZZ7 * t192 + XX7R * dw7_x - XY7 * t200 + XZ7 * t198 + t224;
        let t228 = t191 * (XX7R - ZZ7) + XY7 * t201 - XZ7 * t195 - YZ7 * t197;
        let f7_x = MSX7 * t196 + MSY7 * t197;
        let f7_y = MSX7 * t198 - MSY7 * t199;
        let f7_z = MSX7 * t200 + MSY7 * t201;
        let n7_x = t227 - MSY7 * t167;
        let n7_y = t228 + MSX7 * t167;
        let n7_z = t222 - YZ7 * t183 + (MSX7 * a7_y - MSY7 * a7_x);
        let t249 = c7 * f7_x - s7 * f7_y;
        let t252 = s7 * f7_x + c7 * f7_y;
        let t255 = c7 * n7_x - s7 * n7_y;
        let t261 = s7 * n7_x + c7 * n7_y - k3 * f7_z;
        let t262 = n7_z + k3 * t252;
        put(6, n7_z);
        [f7_z, t249, t252, t255, t261, t262]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t316, t319, t322, t325] = {
        let t283 = XY6R * (t157 + t160) - (XX6R * t151 + ZZ6R * dw5_y) - XZ6 * t147;
        let t285 = YZ6 * (t127 - t160);
        let t288 = ZZ6R * t153 + XX6R * dw6_x - XY6R * t161 + XZ6 * t159 + t285;
        let t289 = t152 * (XX6R - ZZ6R) + XY6R * t162 - XZ6 * t156 - YZ6 * t158;
        let f6_x = t249 + (MSX6R * t157 + MSY6R * t158);
        let f6_y = MSX6R * t159 - MSY6R * t160 - f7_z;
        let f6_z = t252 + (MSX6R * t161 + MSY6R * t162);
        let n6_x = t255 + (t288 + MSY6R * a6_z);
        let n6_y = t289 - MSX6R * a6_z - t262;
        let n6_z = t261 + (t283 - YZ6 * t144 + (MSX6R * a6_y - MSY6R * a6_x));
        let t316 = c6 * f6_x - s6 * f6_y;
        let t319 = s6 * f6_x + c6 * f6_y;
        let t322 = c6 * n6_x - s6 * n6_y;
        let t325 = s6 * n6_x + c6 * n6_y;
        put(5, n6_z);
        [f6_z, n6_z, t316, t319, t322, t325]
    };
    // link 5: force and moment
    let [f5_z, t379, t382, t394, t395, t396] = {
        let t346 = XX5R * t118 - ZZ5R * t77 + XY5 * (t124 + t127) + XZ5 * t114;
        let t348 = YZ5 * (t82 - t127);
        let t351 = XX5R * dw5_x - ZZ5R * t120 - XY5 * t128 - XZ5 * t126 + t348;
        let t352 = t119 * (XX5R - ZZ5R) + XY5 * t129 - XZ5 * t123 - YZ5 * t125;
        let f5_x = t316 + (MSX5 * t124 + MSY5R * t125);
        let t372 = f6_z + (MSX5 * t126 + MSY5R * t127);
        let f5_z = t319 + (MSX5 * t128 + MSY5R * t129);
        let n5_x = t322 + (t351 + MSY5R * a5_z);
        let n5_y = t352 - MSX5 * a5_z - n6_z;
        let n5_z = t325 + (t346 + YZ5 * t111 - (MSX5 * a6_z + MSY5R * a5_x));
        let t379 = c5 * f5_x + s5 * t372;
        let t382 = s5 * f5_x - c5 * t372;
        let t394 = c5 * n5_x - s5 * n5_y - k_L3 * t382;
        let t395 = s5 * n5_x + c5 * n5_y + (k_L3 * t379 + k_A * f5_z);
        let t396 = n5_z - k_A * t382;
        put(4, n5_z);
        [f5_z, t379, t382, t394, t395, t396]
    };
    // link 4: force and moment
    let [f4_z, t450, t456, t462, t463] = {
        let t417 = XY4R * (t79 + t82) - (XX4R * t73 + ZZ4R * dw3_y) - XZ4 * t69;
        let t419 = YZ4 * (t43 - t82);
        let t422 = ZZ4R * t75 + XX4R * dw4_x - XY4R * t83 + XZ4 * t81 + t419;
        let t423 = t74 * (XX4R - ZZ4R) + XY4R * t84 - XZ4 * t78 - YZ4 * t80;
        let f4_x = t379 + (MSX4R * t79 + MSY4R * t80);
        let f4_y = f5_z + (MSX4R * t81 - MSY4R * t82);
        let f4_z = MSX4R * t83 + MSY4R * t84 - t382;
        let n4_x = t394 + (t422 - MSY4R * t50);
        let n4_y = t396 + (t423 + MSX4R * t50);
        let n4_z = t417 - YZ4 * t66 + (MSX4R * a4_y - MSY4R * a4_x) - t395;
        let t450 = c4 * f4_x - s4 * f4_y;
        let t456 = c4 * n4_x - s4 * n4_y;
        let t462 = s4 * n4_x + c4 * n4_y - k_A * f4_z;
        let t463 = n4_z + k_A * (s4 * f4_x + c4 * f4_y);
        put(3, n4_z);
        [f4_z, t450, t456, t462, t463]
    };
    // link 3: force and moment
    let [n3_z, n2_x, t526] = {
        let t484 = XY3R * (t40 + t43) - (XX3R * t34 + ZZ3R * dw2_y) - XZ3 * t30;
        let t486 = YZ3 * (t8 - t43);
        let t489 = ZZ3R * t36 + XX3R * dw3_x - XY3R * t44 + XZ3 * t42 + t486;
        let t490 = t35 * (XX3R - ZZ3R) + XY3R * t45 - XZ3 * t39 - YZ3 * t41;
        let f3_x = t450 + (MSX3R * t40 + MSY3R * t41);
        let f3_y = MSX3R * t42 - MSY3R * t43 - f4_z;
        let n3_x = t456 + (t489 - MSY3R * t11);
        let n3_y = t490 + MSX3R * t11 - t463;
        let n3_z = t462 + (t484 + YZ3 * t27 + (MSX3R * a3_y - MSY3R * a3_x));
        let n2_x = c3 * n3_x - s3 * n3_y - k_L2 * (s3 * f3_x + c3 * f3_y);
        let t526 = s3 * n3_x + c3 * n3_y + k_L2 * (c3 * f3_x - s3 * f3_y);
        put(2, n3_z);
        [n3_z, n2_x, t526]
    };
    // link 2: force and moment
    let [t540, t545] = {
        let t532 = c2 * (s2 * XX2R + c2 * (XY2 + XY2)) - XY2;
        let t540 = (t532 + t532) * (dq1 * dq2) + t4 * (s2 * YZ2 - c2 * XZ2);
        let n2_z = t526 - t0 * t532;
        let t545 = s2 * n2_x - c2 * n3_z;
        put(1, n2_z);
        [t540, t545]
    };
    // link 1: force and moment
    {
        let n1_z = t540 - t545;
        put(0, n1_z);
    }
}
