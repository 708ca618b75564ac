//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 284 multiplications, 260 additions; 7, 7 of 7 structurally nonzero.

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
        _, _, _, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3, MSY3R, XX3R, ZZ3R,
        XY3, XZ3, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6R, XX6R, ZZ6R, XY6, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7,
        ..] = *beta;
    let L2 = S::constant(0.4);
    let L3 = S::constant(0.39);
    // link 2: motion
    let [w2_x, w2_y, dw2_x, t3] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let dw2_x = dq2 * w2_y;
        let t3 = dq2 * w2_x;
        [w2_x, w2_y, dw2_x, t3]
    };
    // link 3: motion
    let [
        w3_x, t9, t12, t13, t14, t15, t17, t18,
        t20, a3_x, t27, w3_z, dw3_x, t32,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t9 = c3 * dq2 + s3 * w2_x;
        let t12 = w2_x * w2_x;
        let t13 = w2_y * w2_y;
        let t14 = dq2 * dq2;
        let t15 = w2_x * w2_y;
        let t17 = t3 + t3;
        let t18 = dw2_x + dw2_x;
        let t19 = L2 * t15;
        let t20 = L2 * (t12 + t14);
        let t21 = L2 * t18;
        let a3_x = c3 * t19 - s3 * t21;
        let t27 = c3 * t21 + s3 * t19;
        let w3_z = w2_y + dq3;
        let dw3_x = c3 * dw2_x - dq3 * t9;
        let t32 = s3 * dw2_x + dq3 * w3_x;
        [
        w3_x, t9, t12, t13, t14, t15, t17, t18,
        t20, a3_x, t27, w3_z, dw3_x, t32,
    ]
    };
    // link 4: motion
    let [
        w4_x, t38, t45, t46, t47, t48, t49, t50,
        t51, t52, t53, t54, t55, t56, t57, t58,
        a4_x, a4_y, w4_z, dw4_x, dw4_y,
    ] = {
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t38 = c4 * w3_z + s4 * w3_x;
        let t45 = w3_x * w3_x;
        let t46 = t9 * t9;
        let t47 = w3_z * w3_z;
        let t48 = w3_x * t9;
        let t49 = w3_x * w3_z;
        let t50 = t9 * w3_z;
        let t51 = t46 + t47;
        let t52 = t3 - t48;
        let t53 = t49 - t32;
        let t54 = t3 + t48;
        let t55 = t45 + t47;
        let t56 = dw3_x + t50;
        let t57 = t32 + t49;
        let t58 = dw3_x - t50;
        let a4_x = c4 * a3_x + s4 * t20;
        let a4_y = c4 * t20 - s4 * a3_x;
        let w4_z = dq4 - t9;
        let dw4_x = c4 * dw3_x + s4 * t3 - dq4 * t38;
        let dw4_y = c4 * t3 - s4 * dw3_x - dq4 * w4_x;
        [
        w4_x, t38, t45, t46, t47, t48, t49, t50,
        t51, t52, t53, t54, t55, t56, t57, t58,
        a4_x, a4_y, w4_z, dw4_x, dw4_y,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t82, t83, t84, t85, t86, t87,
        t88, t89, t90, t91, t92, t93, t94, t95,
        t100, a5_x, a6_z, w5_z, dw5_x, dw6_z,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t82 = w4_x * w4_x;
        let t83 = t38 * t38;
        let t84 = w4_z * w4_z;
        let t85 = w4_x * t38;
        let t86 = w4_x * w4_z;
        let t87 = t38 * w4_z;
        let t88 = t83 + t84;
        let t89 = t32 - t85;
        let t90 = dw4_y + t86;
        let t91 = t32 + t85;
        let t92 = t82 + t84;
        let t93 = dw4_x + t87;
        let t94 = t86 - dw4_y;
        let t95 = dw4_x - t87;
        let t99 = a4_x - L3 * t89;
        let t100 = a4_y + L3 * t92;
        let t101 = t27 + L3 * t95;
        let a5_x = c5 * t99 - s5 * t101;
        let a6_z = c5 * t101 + s5 * t99;
        let w5_z = t38 + dq5;
        let dw5_x = c5 * dw4_x - s5 * t32 + dq5 * w5_y;
        let dw6_z = c5 * t32 + s5 * dw4_x + dq5 * w5_x;
        [
        w5_x, w5_y, t82, t83, t84, t85, t86, t87,
        t88, t89, t90, t91, t92, t93, t94, t95,
        t100, a5_x, a6_z, w5_z, dw5_x, dw6_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t125, t126, t127, t128, t129, t130,
        t131, t132, t133, t134, t135, t136, t137, t138,
        a6_x, t144, w6_z, dw6_x, t149,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t125 = w5_x * w5_x;
        let t126 = w5_y * w5_y;
        let t127 = w5_z * w5_z;
        let t128 = w5_x * w5_y;
        let t129 = w5_x * w5_z;
        let t130 = w5_y * w5_z;
        let t131 = t126 + t127;
        let t132 = dw4_y + t128;
        let t133 = t129 - dw6_z;
        let t134 = t128 - dw4_y;
        let t135 = t125 + t127;
        let t136 = t130 - dw5_x;
        let t137 = dw6_z + t129;
        let t138 = dw5_x + t130;
        let a6_x = c6 * a5_x - s6 * t100;
        let t144 = c6 * t100 + s6 * a5_x;
        let w6_z = dq6 - w5_y;
        let dw6_x = c6 * dw5_x - s6 * dw4_y + dq6 * w6_y;
        let t149 = c6 * dw4_y + s6 * dw5_x + dq6 * w6_x;
        [
        w6_x, w6_y, t125, t126, t127, t128, t129, t130,
        t131, t132, t133, t134, t135, t136, t137, t138,
        a6_x, t144, w6_z, dw6_x, t149,
    ]
    };
    // link 7: motion
    let [
        w7_x, t155, t162, t163, t164, t165, t166, t167,
        t168, t169, t170, t171, t172, t173, t174, t175,
        a7_x, t181, w7_z, dw7_x, t186,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t155 = c7 * w6_z + s7 * w6_x;
        let t162 = w6_x * w6_x;
        let t163 = w6_y * w6_y;
        let t164 = w6_z * w6_z;
        let t165 = w6_x * w6_y;
        let t166 = w6_x * w6_z;
        let t167 = w6_y * w6_z;
        let t168 = t163 + t164;
        let t169 = t165 - dw6_z;
        let t170 = t166 - t149;
        let t171 = dw6_z + t165;
        let t172 = t162 + t164;
        let t173 = t167 - dw6_x;
        let t174 = t149 + t166;
        let t175 = dw6_x + t167;
        let a7_x = c7 * a6_x - s7 * a6_z;
        let t181 = c7 * a6_z + s7 * a6_x;
        let w7_z = w6_y + dq7;
        let dw7_x = c7 * dw6_x - s7 * dw6_z - dq7 * t155;
        let t186 = c7 * dw6_z + s7 * dw6_x + dq7 * w7_x;
        [
        w7_x, t155, t162, t163, t164, t165, t166, t167,
        t168, t169, t170, t171, t172, t173, t174, t175,
        a7_x, t181, w7_z, dw7_x, t186,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t249, t252, t255, t258] = {
        let t187 = w7_x * w7_x;
        let t188 = t155 * t155;
        let t189 = w7_z * w7_z;
        let t190 = w7_x * t155;
        let t191 = w7_x * w7_z;
        let t192 = t155 * w7_z;
        let t194 = t149 - t190;
        let t196 = t149 + t190;
        let t199 = t186 + t191;
        let t200 = dw7_x - t192;
        let t219 = XZ7 * (dw7_x + t192);
        let t224 = YZ7 * (t188 - t189);
        let t225 = YZ7 * t194;
        let t226 = YZ7 * (t191 - t186);
        let t227 = XX7R * dw7_x - ZZ7 * t192 - XY7 * t199 - XZ7 * t196 + t224;
        let t228 = t191 * (XX7R - ZZ7) + XY7 * t200 + XZ7 * (t189 - t187) - t225;
        let t229 = XX7R * t190 - ZZ7 * t149 + XY7 * (t187 - t188) + t219 + t226;
        let f7_x = MSY7 * t194 - MSX7 * (t188 + t189);
        let t235 = MSX7 * t196 + MSY7 * (t187 + t189);
        let f7_z = MSX7 * t199 + MSY7 * t200;
        let n7_x = t227 - MSY7 * t144;
        let n7_y = t228 + MSX7 * t144;
        let n7_z = t229 - (MSX7 * t181 + MSY7 * a7_x);
        let t249 = c7 * f7_x + s7 * t235;
        let t252 = s7 * f7_x - c7 * t235;
        let t255 = c7 * n7_x - s7 * n7_y;
        let t258 = s7 * n7_x + c7 * n7_y;
        put(6, n7_z);
        [f7_z, n7_z, t249, t252, t255, t258]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t313, t316, t319, t322] = {
        let t280 = ZZ6R * dw6_z - XX6R * t165 + XY6 * (t162 - t163) - XZ6 * t173;
        let t282 = YZ6 * (t163 - t164);
        let t283 = YZ6 * t169;
        let t285 = ZZ6R * t167 + XX6R * dw6_x - XY6 * t174 + XZ6 * t171 + t282;
        let t286 = t166 * (XX6R - ZZ6R) + XY6 * t175 + XZ6 * (t164 - t162) - t283;
        let f6_x = t249 + (MSY6R * t169 - MSX6 * t168);
        let f6_y = f7_z + (MSX6 * t171 - MSY6R * t172);
        let f6_z = MSX6 * t174 + MSY6R * t175 - t252;
        let n6_x = t255 + (t285 + MSY6R * a6_z);
        let n6_y = n7_z + (t286 - MSX6 * a6_z);
        let n6_z = t280 + YZ6 * t170 - (MSX6 * t144 + MSY6R * a6_x) - t258;
        let t313 = c6 * f6_x - s6 * f6_y;
        let t316 = s6 * f6_x + c6 * f6_y;
        let t319 = c6 * n6_x - s6 * n6_y;
        let t322 = s6 * n6_x + c6 * n6_y;
        put(5, n6_z);
        [f6_z, n6_z, t313, t316, t319, t322]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t377, t380, t389, t390] = {
        let t344 = XY5 * (t125 - t126) - (XX5R * t128 + ZZ5R * dw4_y) - XZ5 * t136;
        let t346 = YZ5 * (t126 - t127);
        let t347 = YZ5 * t132;
        let t349 = ZZ5R * t130 + XX5R * dw5_x - XY5 * t137 + XZ5 * t134 + t346;
        let t350 = t129 * (XX5R - ZZ5R) + XY5 * t138 + XZ5 * (t127 - t125) - t347;
        let f5_x = t313 + (MSY5R * t132 - MSX5 * t131);
        let f5_y = MSX5 * t134 - MSY5R * t135 - f6_z;
        let f5_z = t316 + (MSX5 * t137 + MSY5R * t138);
        let n5_x = t319 + (t349 - MSY5R * t100);
        let n5_y = t350 + MSX5 * t100 - n6_z;
        let n5_z = t322 + (t344 + YZ5 * t133 - (MSX5 * a6_z + MSY5R * a5_x));
        let t377 = c5 * f5_x - s5 * f5_y;
        let t380 = s5 * f5_x + c5 * f5_y;
        let t389 = c5 * n5_x - s5 * n5_y - L3 * t380;
        let t390 = s5 * n5_x + c5 * n5_y + L3 * t377;
        put(4, n5_z);
        [f5_z, n5_z, t377, t380, t389, t390]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t445, t448, t451] = {
        let t412 = XX4R * t85 - ZZ4R * t32 + XY4 * (t82 - t83) + XZ4 * t93;
        let t414 = YZ4 * (t83 - t84);
        let t415 = YZ4 * t89;
        let t417 = XX4R * dw4_x - ZZ4R * t87 - XY4 * t94 - XZ4 * t91 + t414;
        let t418 = t86 * (XX4R - ZZ4R) + XY4 * t95 + XZ4 * (t84 - t82) - t415;
        let f4_x = t377 + (MSY4R * t89 - MSX4 * t88);
        let f4_z = t380 + (MSX4 * t94 + MSY4R * t95);
        let n4_x = t389 + (t417 - MSY4R * t27);
        let n4_y = t418 + MSX4 * t27 - n5_z;
        let n4_z = t390 + (t412 + YZ4 * t90 + (MSX4 * a4_y - MSY4R * a4_x));
        let t445 = c4 * f4_x + s4 * (f5_z + (MSX4 * t91 + MSY4R * t92));
        let t448 = c4 * n4_x - s4 * n4_y;
        let t451 = s4 * n4_x + c4 * n4_y;
        put(3, n4_z);
        [f4_z, n4_z, t445, t448, t451]
    };
    // link 3: force and moment
    let [n3_z, t514, t515] = {
        let t473 = XX3R * t48 - ZZ3R * t3 + XY3 * (t45 - t46) + XZ3 * t56;
        let t475 = YZ3 * (t46 - t47);
        let t476 = YZ3 * t52;
        let t478 = XX3R * dw3_x - ZZ3R * t50 - XY3 * t57 - XZ3 * t54 + t475;
        let t479 = t49 * (XX3R - ZZ3R) + XY3 * t58 + XZ3 * (t47 - t45) - t476;
        let f3_x = t445 + (MSY3R * t52 - MSX3 * t51);
        let f3_y = f4_z - (MSX3 * t54 + MSY3R * t55);
        let n3_x = t448 + (t478 - MSY3R * t20);
        let n3_y = n4_z + (t479 + MSX3 * t20);
        let n3_z = t473 + YZ3 * t53 - (MSX3 * t27 + MSY3R * a3_x) - t451;
        let t514 = c3 * n3_x - s3 * n3_y - L2 * (s3 * f3_x + c3 * f3_y);
        let t515 = s3 * n3_x + c3 * n3_y + L2 * (c3 * f3_x - s3 * f3_y);
        put(2, n3_z);
        [n3_z, t514, t515]
    };
    // link 2: force and moment
    {
        let t534 = YZ2 * (t13 - t14);
        let t535 = YZ2 * t15;
        let t537 = t3 * (XX2R - ZZ2R) + XY2 * t18 + XZ2 * (t14 - t12) - t535;
        let n2_x = t514 + (dw2_x * (XX2R + ZZ2R) - XY2 * t17 + XZ2 * t15 + t534);
        let n2_y = n3_z + t537;
        let n2_z = XY2 * (t12 - t13) - XX2R * t15 - t515;
        let n1_z = s2 * n2_x + c2 * n2_y;
        put(0, n1_z);
        put(1, n2_z);
    }
}
