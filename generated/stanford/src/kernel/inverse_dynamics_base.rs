//! Torques from the base parameters.
//!
//! `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil
//! and Dombre, 9.6.
//!
//! 226 multiplications, 213 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, GRAVITY, Trig, constants};

/// Torques from the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE], out: &mut [S; 6]) {
    entries(trig, dq, ddq, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let [
        YY1R, MSX2, MSZ2, YY2R, ZZ2R, XY2R, XZ2R, YZ2R, M3R, MSX3, MSY3, MSZ3R,
        MSX4, MSZ4R, YY4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSZ5R, YY5R, ZZ5R, XY5,
        XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6, IA3, IA4, IA5,
        IA6,
        ..] = *beta;
    let k0 = S::constant(-GRAVITY[2]);
    let k2 = S::constant(2.0);
    let k_D2 = S::constant(constants::D2);
    let k_D6 = S::constant(constants::D6);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        t4, t6, a2_y, t9, w3_z, t11, t12, t13,
        t14, t15, t16, t17, dw2_y, t20, t21, t22,
        t23, t24,
    ] = {
        let t3 = k_D2 * ddq1;
        let t4 = k_D2 * t0;
        let t6 = s2 * k0 + c2 * t3;
        let a2_y = s2 * t3 - c2 * k0;
        let t9 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t11 = s2 * ddq1;
        let t12 = c2 * ddq1;
        let t13 = t9 * t9;
        let t14 = dq2 * dq2;
        let t15 = t9 * w3_z;
        let t16 = dq2 * t9;
        let t17 = dq2 * w3_z;
        let dw2_y = t16 - t12;
        let t20 = t15 - ddq2;
        let t21 = ddq2 + t15;
        let t22 = t13 + t14;
        let t23 = t16 + dw2_y;
        let t24 = t17 + (t11 + t17);
        [
        t4, t6, a2_y, t9, w3_z, t11, t12, t13,
        t14, t15, t16, t17, dw2_y, t20, t21, t22,
        t23, t24,
    ]
    };
    // link 3: motion
    let [t34, a3_y, a3_z, t38, t39] = {
        let t31 = dq3 * k2;
        let t34 = q3 * t24 - t4 + t9 * t31;
        let a3_y = dq2 * t31 - (t6 + q3 * t20);
        let a3_z = ddq3 - (a2_y + q3 * t22);
        let t37 = w3_z * w3_z;
        let t38 = t13 + t37;
        let t39 = t14 + t37;
        [t34, a3_y, a3_z, t38, t39]
    };
    // link 4: motion
    let [
        a4_x, a4_y, t48, w4_y, t54, t57, w4_z, dw4_z,
        t60, t61, t62, t63, t64, dw4_y, t67, t68,
        t69, t70, t71,
    ] = {
        let a4_x = s4 * a3_y - c4 * t34;
        let a4_y = c4 * a3_y + s4 * t34;
        let t48 = c4 * dq2 + s4 * t9;
        let w4_y = s4 * dq2 - c4 * t9;
        let t54 = c4 * t24 + s4 * t20;
        let t57 = s4 * t24 - c4 * t20;
        let w4_z = w3_z + dq4;
        let dw4_z = ddq4 - dw2_y;
        let t60 = t48 * t48;
        let t61 = w4_z * w4_z;
        let t62 = t48 * w4_y;
        let t63 = t48 * w4_z;
        let t64 = w4_y * w4_z;
        let dw4_x = t64 - t57;
        let dw4_y = t63 - t54;
        let t67 = dw4_z + t62;
        let t68 = dw4_z - t62;
        let t69 = t60 + t61;
        let t70 = t63 + dw4_y;
        let t71 = t64 + dw4_x;
        [
        a4_x, a4_y, t48, w4_y, t54, t57, w4_z, dw4_z,
        t60, t61, t62, t63, t64, dw4_y, t67, t68,
        t69, t70, t71,
    ]
    };
    // link 5: motion
    let [
        a5_x, t77, t80, w5_y, t86, t89, w5_z, dw5_z,
        t92, t93, t94, t95, t96, dw5_y, t99, t100,
        t101, t102, t103,
    ] = {
        let a5_x = c5 * a4_x - s5 * a3_z;
        let t77 = c5 * a3_z + s5 * a4_x;
        let t80 = c5 * t48 + s5 * w4_z;
        let w5_y = s5 * t48 - c5 * w4_z;
        let t86 = c5 * t67 + s5 * t71;
        let t89 = s5 * t67 - c5 * t71;
        let w5_z = w4_y + dq5;
        let dw5_z = dw4_y + ddq5;
        let t92 = t80 * t80;
        let t93 = w5_z * w5_z;
        let t94 = t80 * w5_y;
        let t95 = t80 * w5_z;
        let t96 = w5_y * w5_z;
        let dw5_x = t96 - t89;
        let dw5_y = t95 - t86;
        let t99 = dw5_z + t94;
        let t100 = dw5_z - t94;
        let t101 = t92 + t93;
        let t102 = t95 + dw5_y;
        let t103 = t96 + dw5_x;
        [
        a5_x, t77, t80, w5_y, t86, t89, w5_z, dw5_z,
        t92, t93, t94, t95, t96, dw5_y, t99, t100,
        t101, t102, t103,
    ]
    };
    // link 6: motion
    let [
        t106, t109, t118, t121, dw6_z, t126, t127, t128,
        dw6_x, t131, t132, t133, t134, t135, t136, t137,
    ] = {
        let t106 = c6 * a5_x + s6 * a4_y;
        let t109 = c6 * a4_y - s6 * a5_x;
        let w6_x = s6 * w5_z - c6 * t80;
        let w6_y = c6 * w5_z + s6 * t80;
        let t118 = c6 * t99 - s6 * t103;
        let t121 = c6 * t103 + s6 * t99;
        let w6_z = dq6 - w5_y;
        let dw6_z = ddq6 - dw5_y;
        let t124 = w6_x * w6_x;
        let t125 = w6_z * w6_z;
        let t126 = w6_x * w6_y;
        let t127 = w6_x * w6_z;
        let t128 = w6_y * w6_z;
        let dw6_x = t121 + t128;
        let dw6_y = t118 - t127;
        let t131 = t124 - t125;
        let t132 = t131 - t101;
        let t133 = t126 - dw6_z;
        let t134 = dw6_z + t126;
        let t135 = t124 + t125;
        let t136 = t127 - dw6_y;
        let t137 = t128 + dw6_x;
        [
        t106, t109, t118, t121, dw6_z, t126, t127, t128,
        dw6_x, t131, t132, t133, t134, t135, t136, t137,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t189, t192, t195, t198] = {
        let t139 = XZ6 - k_D6 * MSX6;
        let t141 = YZ6 - k_D6 * MSY6;
        let t162 = ZZ6 * dw6_z - XX6R * t126 + XY6 * (t132 + t135) + t121 * t139;
        let t164 = t141 * (t101 - t135);
        let t167 = ZZ6 * t128 + XX6R * dw6_x - XY6 * t136 + t134 * t139 + t164;
        let t168 = t127 * (XX6R - ZZ6) + XY6 * t137 - t131 * t139 - t133 * t141;
        let f6_x = MSX6 * t132 + MSY6 * t133;
        let f6_y = MSX6 * t134 - MSY6 * t135;
        let f6_z = MSX6 * t136 + MSY6 * t137;
        let n6_x = t167 + MSY6 * t77;
        let n6_y = t168 - MSX6 * t77;
        let n6_z = t162 + t118 * t141 + (MSX6 * t109 - MSY6 * t106);
        let t189 = c6 * f6_x - s6 * f6_y;
        let t192 = s6 * f6_x + c6 * f6_y;
        let t195 = c6 * n6_x - s6 * n6_y;
        let t198 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t189, t192, t195, t198]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t256, t259, t262, t265] = {
        let t199 = w5_y * w5_y;
        let t200 = t93 + t199;
        let t201 = t92 + t199;
        let t222 = YY5R * dw5_z - ZZ5R * t94 - XY5 * t89 + XZ5 * (t200 - t101);
        let t223 = XY5 * (t201 - t200) - (YY5R * t95 + ZZ5R * dw5_y) + XZ5 * t103;
        let t225 = YZ5 * (t101 - t201);
        let t240 = MSZ5R * a4_y;
        let t245 = XY5 * t100 - t96 * (ZZ5R - YY5R) - XZ5 * t102 + t225 - t240;
        let f5_x = t189 + (MSZ5R * t99 - MSX5 * t200);
        let f5_y = MSX5 * t100 + MSZ5R * t101 - f6_z;
        let f5_z = t192 - (MSX5 * t102 + MSZ5R * t103);
        let n5_x = t195 + t245;
        let t252 = n6_z + (t223 + YZ5 * t99 + MSX5 * a4_y);
        let n5_z = t198 + (t222 + YZ5 * t86 + (MSZ5R * a5_x - MSX5 * t77));
        let t256 = c5 * f5_x - s5 * f5_y;
        let t259 = s5 * f5_x + c5 * f5_y;
        let t262 = c5 * n5_x + s5 * t252;
        let t265 = s5 * n5_x - c5 * t252;
        [f5_z, n5_z, t256, t259, t262, t265]
    };
    // link 4: force and moment
    let [t317, t320, t323, t326, t329, t332] = {
        let t266 = w4_y * w4_y;
        let t267 = t61 + t266;
        let t268 = t60 + t266;
        let t289 = ZZ4R * t62 - YY4R * dw4_z - XY4 * t57 + XZ4 * (t267 - t69);
        let t290 = YY4R * t63 + ZZ4R * dw4_y + XY4 * (t268 - t267) + XZ4 * t71;
        let t292 = YZ4 * (t69 - t268);
        let t307 = MSZ4R * a3_z;
        let t312 = XZ4 * t70 - (t64 * (ZZ4R - YY4R) + XY4 * t68) + t292 + t307;
        let f4_x = t256 - (MSX4 * t267 + MSZ4R * t67);
        let f4_y = f5_z + (MSX4 * t68 - MSZ4R * t69);
        let t317 = t259 + (MSX4 * t70 - MSZ4R * t71);
        let n4_x = t262 + t312;
        let n4_y = n5_z + (t290 - YZ4 * t67 - MSX4 * a3_z);
        let t320 = t265 + (t289 - YZ4 * t54 + (MSZ4R * a4_x - MSX4 * a4_y));
        let t323 = c4 * f4_x - s4 * f4_y;
        let t326 = s4 * f4_x + c4 * f4_y;
        let t329 = c4 * n4_x - s4 * n4_y;
        let t332 = s4 * n4_x + c4 * n4_y;
        [t317, t320, t323, t326, t329, t332]
    };
    // link 3: force and moment
    let [t333, t334, t335, f3_y, f3_z, n3_z, t374, t375] = {
        let t333 = t39 - t38;
        let t334 = t38 - t22;
        let t335 = t22 - t39;
        let f3_x = t323 + (MSY3 * t23 - MSX3 * t38 - MSZ3R * t24 - M3R * t34);
        let f3_y = t326 + (M3R * a3_y + (MSX3 * t12 - MSY3 * t39 - MSZ3R * t20));
        let f3_z = M3R * a3_z + (MSX3 * t11 - MSY3 * t21 - MSZ3R * t22) - t317;
        let n3_x = t329 + (MSY3 * a3_z - MSZ3R * a3_y);
        let n3_y = t332 - (MSZ3R * t34 + MSX3 * a3_z);
        let n3_z = MSX3 * a3_y + MSY3 * t34 - t320;
        let t374 = n3_y + q3 * f3_x;
        let t375 = q3 * f3_y - n3_x;
        [t333, t334, t335, f3_y, f3_z, n3_z, t374, t375]
    };
    // link 2: force and moment
    let t428 = {
        let t397 = YZ2R * t12;
        let t398 = YZ2R * t20;
        let t399 = t17 * (ZZ2R - YY2R) + XY2R * t21 - XZ2R * t23 - YZ2R * t334;
        let t400 = ZZ2R * t15 + YY2R * ddq2 - XY2R * t11 - XZ2R * t335 + t397;
        let t401 = YY2R * t16 + ZZ2R * dw2_y + XY2R * t333 + XZ2R * t24 + t398;
        let f2_x = f3_y - (MSX2 * t39 + MSZ2 * t20);
        let f2_y = MSX2 * t21 + MSZ2 * t22 - f3_z;
        let n2_x = t374 + (t399 + MSZ2 * t4);
        let n2_y = t401 + MSX2 * t4 - n3_z;
        let n2_z = t375 + (t400 + (MSX2 * a2_y - MSZ2 * t6));
        let f1_x = c2 * f2_x - s2 * f2_y;
        let t428 = s2 * n2_x + c2 * n2_y + k_D2 * f1_x;
        put(1, n2_z);
        t428
    };
    // link 1: force and moment
    {
        let n1_z = YY1R * ddq1 - t428;
        put(0, n1_z);
    }
    // drives
    {
        let t432 = f3_z + IA3 * ddq3;
        let t434 = IA4 * ddq4 - t320;
        let t436 = n5_z + IA5 * ddq5;
        let t438 = n6_z + IA6 * ddq6;
        put(2, t432);
        put(3, t434);
        put(4, t436);
        put(5, t438);
    }
}
