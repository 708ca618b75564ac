//! Torques from the base parameters.
//!
//! `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil and Dombre, 9.6.
//!
//! 225 multiplications, 212 additions; 6, 6 of 6 structurally nonzero.

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
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let [
        YY1R, MSX2, MSZ2, YY2R, ZZ2R, XY2R, XZ2R, YZ2R, M3R, MSX3, MSY3, MSZ3R,
        MSX4, MSZ4R, YY4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSZ5R, YY5R, ZZ5R, XY5,
        XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        ..] = *beta;
    let D2 = S::constant(0.154);
    let D6 = S::constant(0.263);
    let k0 = S::constant(9.81);
    let k2 = S::constant(2.0);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        t1, w3_z, t3, t4, t8, t10, a2_y, t13,
        t14, t15, t16, t17, dw2_y, t20, t21, t22,
        t23, t24,
    ] = {
        let t1 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t3 = s2 * ddq1;
        let t4 = c2 * ddq1;
        let t7 = D2 * ddq1;
        let t8 = D2 * t0;
        let t10 = s2 * k0 + c2 * t7;
        let a2_y = s2 * t7 - c2 * k0;
        let t13 = t1 * t1;
        let t14 = dq2 * dq2;
        let t15 = t1 * w3_z;
        let t16 = dq2 * t1;
        let t17 = dq2 * w3_z;
        let dw2_y = t16 - t4;
        let t20 = t15 - ddq2;
        let t21 = ddq2 + t15;
        let t22 = t13 + t14;
        let t23 = t16 + dw2_y;
        let t24 = t17 + (t3 + t17);
        [
        t1, w3_z, t3, t4, t8, t10, a2_y, t13,
        t14, t15, t16, t17, dw2_y, t20, t21, t22,
        t23, t24,
    ]
    };
    // link 3: motion
    let [t34, a3_y, t36, t38, t39] = {
        let t31 = dq3 * k2;
        let t34 = t8 - q3 * t24 - t1 * t31;
        let a3_y = dq2 * t31 - (t10 + q3 * t20);
        let t36 = a2_y + q3 * t22 - ddq3;
        let t37 = w3_z * w3_z;
        let t38 = t13 + t37;
        let t39 = t14 + t37;
        [t34, a3_y, t36, t38, t39]
    };
    // link 4: motion
    let [
        t42, w4_y, a4_x, t51, t54, t57, w4_z, dw4_z,
        t60, t61, t62, t63, t64, t66, t67, t68,
        t69, t70, t71,
    ] = {
        let t42 = c4 * dq2 + s4 * t1;
        let w4_y = s4 * dq2 - c4 * t1;
        let a4_x = c4 * t34 + s4 * a3_y;
        let t51 = s4 * t34 - c4 * a3_y;
        let t54 = c4 * t24 + s4 * t20;
        let t57 = s4 * t24 - c4 * t20;
        let w4_z = w3_z + dq4;
        let dw4_z = ddq4 - dw2_y;
        let t60 = t42 * t42;
        let t61 = w4_z * w4_z;
        let t62 = t42 * w4_y;
        let t63 = t42 * w4_z;
        let t64 = w4_y * w4_z;
        let dw4_x = t64 - t57;
        let t66 = t54 - t63;
        let t67 = dw4_z + t62;
        let t68 = t62 - dw4_z;
        let t69 = t60 + t61;
        let t70 = t66 - t63;
        let t71 = t64 + dw4_x;
        [
        t42, w4_y, a4_x, t51, t54, t57, w4_z, dw4_z,
        t60, t61, t62, t63, t64, t66, t67, t68,
        t69, t70, t71,
    ]
    };
    // link 5: motion
    let [
        t74, w5_y, a5_x, t83, t86, t89, w5_z, dw5_z,
        t92, t93, t94, t95, t96, dw5_y, t99, t100,
        t101, t102, t103,
    ] = {
        let t74 = c5 * t42 + s5 * w4_z;
        let w5_y = s5 * t42 - c5 * w4_z;
        let a5_x = c5 * a4_x + s5 * t36;
        let t83 = c5 * t36 - s5 * a4_x;
        let t86 = c5 * t67 + s5 * t71;
        let t89 = s5 * t67 - c5 * t71;
        let w5_z = w4_y + dq5;
        let dw5_z = ddq5 - t66;
        let t92 = t74 * t74;
        let t93 = w5_z * w5_z;
        let t94 = t74 * w5_y;
        let t95 = t74 * w5_z;
        let t96 = w5_y * w5_z;
        let dw5_x = t96 - t89;
        let dw5_y = t95 - t86;
        let t99 = dw5_z + t94;
        let t100 = dw5_z - t94;
        let t101 = t92 + t93;
        let t102 = t95 + dw5_y;
        let t103 = t96 + dw5_x;
        [
        t74, w5_y, a5_x, t83, t86, t89, w5_z, dw5_z,
        t92, t93, t94, t95, t96, dw5_y, t99, t100,
        t101, t102, t103,
    ]
    };
    // link 6: motion
    let [
        t114, t118, t121, t124, t127, dw6_z, t132, t133,
        t134, t135, t137, t138, t139, t140, t141, t142,
        t143,
    ] = {
        let t106 = c6 * t74 - s6 * w5_z;
        let w6_y = c6 * w5_z + s6 * t74;
        let t113 = a5_x + D6 * t99;
        let t114 = t83 + D6 * t101;
        let t115 = t51 + D6 * t103;
        let t118 = s6 * t115 - c6 * t113;
        let t121 = c6 * t115 + s6 * t113;
        let t124 = c6 * t99 - s6 * t103;
        let t127 = c6 * t103 + s6 * t99;
        let t128 = w5_y - dq6;
        let dw6_z = ddq6 - dw5_y;
        let t130 = t106 * t106;
        let t131 = t128 * t128;
        let t132 = t106 * w6_y;
        let t133 = t106 * t128;
        let t134 = w6_y * t128;
        let t135 = t134 - t127;
        let t137 = t131 - t130;
        let t138 = t101 + t137;
        let t139 = dw6_z + t132;
        let t140 = t132 - dw6_z;
        let t141 = t130 + t131;
        let t142 = t133 + (t133 - t124);
        let t143 = t134 + t135;
        [
        t114, t118, t121, t124, t127, dw6_z, t132, t133,
        t134, t135, t137, t138, t139, t140, t141, t142,
        t143,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t191, t194, t203, t204] = {
        let t164 = XX6R * t132 + ZZ6 * dw6_z + XY6 * (t141 - t138) + XZ6 * t127;
        let t166 = YZ6 * (t141 - t101);
        let t169 = ZZ6 * t134 + XX6R * t135 + XY6 * t142 + XZ6 * t140 + t166;
        let t170 = YZ6 * t139 - (t133 * (ZZ6 - XX6R) + XY6 * t143 - XZ6 * t137);
        let t174 = MSX6 * t138 + MSY6 * t139;
        let t177 = MSX6 * t140 + MSY6 * t141;
        let f6_z = MSX6 * t142 - MSY6 * t143;
        let t186 = t169 + MSY6 * t114;
        let n6_y = t170 + MSX6 * t114;
        let n6_z = t164 + YZ6 * t124 - (MSX6 * t121 - MSY6 * t118);
        let t191 = c6 * t174 - s6 * t177;
        let t194 = s6 * t174 + c6 * t177;
        let t203 = D6 * t194 - (c6 * t186 + s6 * n6_y);
        let t204 = s6 * t186 - c6 * n6_y + D6 * t191;
        put(5, n6_z);
        [f6_z, n6_z, t191, t194, t203, t204]
    };
    // link 5: force and moment
    let [t256, n5_z, t262, t265, t268, t271] = {
        let t205 = w5_y * w5_y;
        let t206 = t93 + t205;
        let t207 = t92 + t205;
        let t227 = t96 * (YY5R - ZZ5R) + XY5 * t100 - XZ5 * t102;
        let t228 = XZ5 * (t206 - t101) - (XY5 * t89 - (YY5R * dw5_z - ZZ5R * t94));
        let t229 = XZ5 * t103 - (YY5R * t95 + ZZ5R * dw5_y + XY5 * (t206 - t207));
        let t254 = t191 + (MSX5 * t206 - MSZ5R * t99);
        let f5_y = MSX5 * t100 + MSZ5R * t101 - f6_z;
        let t256 = t194 + (MSX5 * t102 + MSZ5R * t103);
        let n5_x = t203 + (MSZ5R * t51 - (YZ5 * (t207 - t101) - t227));
        let t258 = n6_z + (t229 + YZ5 * t99 - MSX5 * t51);
        let n5_z = t228 + YZ5 * t86 + (MSZ5R * a5_x + MSX5 * t83) - t204;
        let t262 = c5 * t254 + s5 * f5_y;
        let t265 = c5 * f5_y - s5 * t254;
        let t268 = c5 * n5_x + s5 * t258;
        let t271 = s5 * n5_x - c5 * t258;
        put(4, n5_z);
        [t256, n5_z, t262, t265, t268, t271]
    };
    // link 4: force and moment
    let [t323, n4_z, t329, t332, t335, t338] = {
        let t272 = w4_y * w4_y;
        let t273 = t61 + t272;
        let t274 = t60 + t272;
        let t295 = YY4R * dw4_z - ZZ4R * t62 + XY4 * t57 - XZ4 * (t273 - t69);
        let t296 = XZ4 * t71 - (ZZ4R * t66 - YY4R * t63 - XY4 * (t274 - t273));
        let t298 = YZ4 * (t274 - t69);
        let t313 = MSZ4R * t36;
        let t318 = XY4 * t68 - t64 * (ZZ4R - YY4R) - XZ4 * t70 - t298 - t313;
        let t321 = t262 + (MSX4 * t273 + MSZ4R * t67);
        let t322 = t256 + (MSX4 * t68 + MSZ4R * t69);
        let t323 = MSX4 * t70 + MSZ4R * t71 - t265;
        let n4_x = t268 + t318;
        let n4_y = n5_z + (t296 - YZ4 * t67 + MSX4 * t36);
        let n4_z = t295 + YZ4 * t54 - (MSZ4R * a4_x + MSX4 * t51) - t271;
        let t329 = c4 * t321 - s4 * t322;
        let t332 = s4 * t321 + c4 * t322;
        let t335 = s4 * n4_y - c4 * n4_x;
        let t338 = s4 * n4_x + c4 * n4_y;
        put(3, n4_z);
        [t323, n4_z, t329, t332, t335, t338]
    };
    // link 3: force and moment
    let [t339, t340, t341, f3_y, f3_z, t377, t380, t381] = {
        let t339 = t38 - t39;
        let t340 = t22 - t38;
        let t341 = t22 - t39;
        let t372 = t329 - (M3R * t34 + (MSY3 * t23 - MSX3 * t38 - MSZ3R * t24));
        let f3_y = M3R * a3_y - (MSZ3R * t20 - (MSX3 * t4 - MSY3 * t39)) - t332;
        let f3_z = t323 + (MSX3 * t3 - MSY3 * t21 - MSZ3R * t22 - M3R * t36);
        let n3_y = t338 + (MSZ3R * t34 + MSX3 * t36);
        let t377 = MSY3 * t34 - MSX3 * a3_y - n4_z;
        let t380 = n3_y - q3 * t372;
        let t381 = t335 + (MSY3 * t36 + MSZ3R * a3_y) + q3 * f3_y;
        put(2, f3_z);
        [t339, t340, t341, f3_y, f3_z, t377, t380, t381]
    };
    // link 2: force and moment
    let t434 = {
        let t403 = YZ2R * t4;
        let t404 = YZ2R * t20;
        let t405 = t17 * (YY2R - ZZ2R) - XY2R * t21 + XZ2R * t23 - YZ2R * t340;
        let t406 = ZZ2R * t15 + YY2R * ddq2 - XY2R * t3 - XZ2R * t341 + t403;
        let t407 = XZ2R * t24 - (XY2R * t339 - (YY2R * t16 + ZZ2R * dw2_y)) + t404;
        let n2_x = t380 + (MSZ2 * t8 - t405);
        let n2_y = t377 + (t407 + MSX2 * t8);
        let n2_z = t381 + (t406 + (MSX2 * a2_y - MSZ2 * t10));
        let t427 = c2 * (MSX2 * t39 + MSZ2 * t20 - f3_y);
        let f1_x = s2 * (f3_z - (MSX2 * t21 + MSZ2 * t22)) - t427;
        let t434 = s2 * n2_x + c2 * n2_y + D2 * f1_x;
        put(1, n2_z);
        t434
    };
    // link 1: force and moment
    {
        let n1_z = YY1R * ddq1 - t434;
        put(0, n1_z);
    }
}
