//! Torques from the base parameters.
//!
//! `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil and Dombre, 9.6.
//!
//! 229 multiplications, 216 additions; 6, 6 of 6 structurally nonzero.

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
        XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6, IA3, IA4, IA5,
        IA6,
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
    let [t34, a3_y, a3_z, t38, t39] = {
        let t31 = dq3 * k2;
        let t34 = q3 * t24 - t8 + t1 * t31;
        let a3_y = dq2 * t31 - (t10 + q3 * t20);
        let a3_z = ddq3 - (a2_y + q3 * t22);
        let t37 = w3_z * w3_z;
        let t38 = t13 + t37;
        let t39 = t14 + t37;
        [t34, a3_y, a3_z, t38, t39]
    };
    // link 4: motion
    let [
        t42, w4_y, a4_x, a4_y, t54, t57, w4_z, dw4_z,
        t60, t61, t62, t63, t64, dw4_y, t67, t68,
        t69, t70, t71,
    ] = {
        let t42 = c4 * dq2 + s4 * t1;
        let w4_y = s4 * dq2 - c4 * t1;
        let a4_x = s4 * a3_y - c4 * t34;
        let a4_y = c4 * a3_y + s4 * t34;
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
        let dw4_y = t63 - t54;
        let t67 = dw4_z + t62;
        let t68 = dw4_z - t62;
        let t69 = t60 + t61;
        let t70 = t63 + dw4_y;
        let t71 = t64 + dw4_x;
        [
        t42, w4_y, a4_x, a4_y, t54, t57, w4_z, dw4_z,
        t60, t61, t62, t63, t64, dw4_y, t67, t68,
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
        let a5_x = c5 * a4_x - s5 * a3_z;
        let t83 = c5 * a3_z + s5 * a4_x;
        let t86 = c5 * t67 + s5 * t71;
        let t89 = s5 * t67 - c5 * t71;
        let w5_z = w4_y + dq5;
        let dw5_z = dw4_y + ddq5;
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
        t114, a6_x, a6_y, t124, t127, dw6_z, t132, t133,
        t134, dw6_x, t137, t138, t139, t140, t141, t142,
        t143,
    ] = {
        let w6_x = s6 * w5_z - c6 * t74;
        let w6_y = c6 * w5_z + s6 * t74;
        let t113 = a5_x + D6 * t99;
        let t114 = D6 * t101 - t83;
        let t115 = a4_y - D6 * t103;
        let a6_x = c6 * t113 + s6 * t115;
        let a6_y = c6 * t115 - s6 * t113;
        let t124 = c6 * t99 - s6 * t103;
        let t127 = c6 * t103 + s6 * t99;
        let w6_z = dq6 - w5_y;
        let dw6_z = ddq6 - dw5_y;
        let t130 = w6_x * w6_x;
        let t131 = w6_z * w6_z;
        let t132 = w6_x * w6_y;
        let t133 = w6_x * w6_z;
        let t134 = w6_y * w6_z;
        let dw6_x = t127 + t134;
        let dw6_y = t124 - t133;
        let t137 = t130 - t131;
        let t138 = t137 - t101;
        let t139 = t132 - dw6_z;
        let t140 = dw6_z + t132;
        let t141 = t130 + t131;
        let t142 = t133 - dw6_y;
        let t143 = t134 + dw6_x;
        [
        t114, a6_x, a6_y, t124, t127, dw6_z, t132, t133,
        t134, dw6_x, t137, t138, t139, t140, t141, t142,
        t143,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t191, t194, t203, t204] = {
        let t164 = ZZ6 * dw6_z - XX6R * t132 + XY6 * (t138 + t141) + XZ6 * t127;
        let t166 = YZ6 * (t101 - t141);
        let t169 = ZZ6 * t134 + XX6R * dw6_x - XY6 * t142 + XZ6 * t140 + t166;
        let t170 = t133 * (XX6R - ZZ6) + XY6 * t143 - XZ6 * t137 - YZ6 * t139;
        let f6_x = MSX6 * t138 + MSY6 * t139;
        let f6_y = MSX6 * t140 - MSY6 * t141;
        let f6_z = MSX6 * t142 + MSY6 * t143;
        let n6_x = t169 - MSY6 * t114;
        let n6_y = t170 + MSX6 * t114;
        let n6_z = t164 + YZ6 * t124 + (MSX6 * a6_y - MSY6 * a6_x);
        let t191 = c6 * f6_x - s6 * f6_y;
        let t194 = s6 * f6_x + c6 * f6_y;
        let t203 = c6 * n6_x - s6 * n6_y - D6 * t194;
        let t204 = s6 * n6_x + c6 * n6_y + D6 * t191;
        [f6_z, n6_z, t191, t194, t203, t204]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t262, t265, t268, t271] = {
        let t205 = w5_y * w5_y;
        let t206 = t93 + t205;
        let t207 = t92 + t205;
        let t228 = YY5R * dw5_z - ZZ5R * t94 - XY5 * t89 + XZ5 * (t206 - t101);
        let t229 = XY5 * (t207 - t206) - (YY5R * t95 + ZZ5R * dw5_y) + XZ5 * t103;
        let t231 = YZ5 * (t101 - t207);
        let t246 = MSZ5R * a4_y;
        let t251 = XY5 * t100 - t96 * (ZZ5R - YY5R) - XZ5 * t102 + t231 - t246;
        let f5_x = t191 + (MSZ5R * t99 - MSX5 * t206);
        let f5_y = MSX5 * t100 + MSZ5R * t101 - f6_z;
        let f5_z = t194 - (MSX5 * t102 + MSZ5R * t103);
        let n5_x = t203 + t251;
        let t258 = n6_z + (t229 + YZ5 * t99 + MSX5 * a4_y);
        let n5_z = t204 + (t228 + YZ5 * t86 + (MSZ5R * a5_x - MSX5 * t83));
        let t262 = c5 * f5_x - s5 * f5_y;
        let t265 = s5 * f5_x + c5 * f5_y;
        let t268 = c5 * n5_x + s5 * t258;
        let t271 = s5 * n5_x - c5 * t258;
        [f5_z, n5_z, t262, t265, t268, t271]
    };
    // link 4: force and moment
    let [t323, t326, t329, t332, t335, t338] = {
        let t272 = w4_y * w4_y;
        let t273 = t61 + t272;
        let t274 = t60 + t272;
        let t295 = ZZ4R * t62 - YY4R * dw4_z - XY4 * t57 + XZ4 * (t273 - t69);
        let t296 = YY4R * t63 + ZZ4R * dw4_y + XY4 * (t274 - t273) + XZ4 * t71;
        let t298 = YZ4 * (t69 - t274);
        let t313 = MSZ4R * a3_z;
        let t318 = XZ4 * t70 - (t64 * (ZZ4R - YY4R) + XY4 * t68) + t298 + t313;
        let f4_x = t262 - (MSX4 * t273 + MSZ4R * t67);
        let f4_y = f5_z + (MSX4 * t68 - MSZ4R * t69);
        let t323 = t265 + (MSX4 * t70 - MSZ4R * t71);
        let n4_x = t268 + t318;
        let n4_y = n5_z + (t296 - YZ4 * t67 - MSX4 * a3_z);
        let t326 = t271 + (t295 - YZ4 * t54 + (MSZ4R * a4_x - MSX4 * a4_y));
        let t329 = c4 * f4_x - s4 * f4_y;
        let t332 = s4 * f4_x + c4 * f4_y;
        let t335 = c4 * n4_x - s4 * n4_y;
        let t338 = s4 * n4_x + c4 * n4_y;
        [t323, t326, t329, t332, t335, t338]
    };
    // link 3: force and moment
    let [t339, t340, t341, f3_y, f3_z, n3_z, t380, t381] = {
        let t339 = t39 - t38;
        let t340 = t38 - t22;
        let t341 = t22 - t39;
        let f3_x = t329 + (MSY3 * t23 - MSX3 * t38 - MSZ3R * t24 - M3R * t34);
        let f3_y = t332 + (M3R * a3_y + (MSX3 * t4 - MSY3 * t39 - MSZ3R * t20));
        let f3_z = M3R * a3_z + (MSX3 * t3 - MSY3 * t21 - MSZ3R * t22) - t323;
        let n3_x = t335 + (MSY3 * a3_z - MSZ3R * a3_y);
        let n3_y = t338 - (MSZ3R * t34 + MSX3 * a3_z);
        let n3_z = MSX3 * a3_y + MSY3 * t34 - t326;
        let t380 = n3_y + q3 * f3_x;
        let t381 = q3 * f3_y - n3_x;
        [t339, t340, t341, f3_y, f3_z, n3_z, t380, t381]
    };
    // link 2: force and moment
    let t434 = {
        let t403 = YZ2R * t4;
        let t404 = YZ2R * t20;
        let t405 = t17 * (ZZ2R - YY2R) + XY2R * t21 - XZ2R * t23 - YZ2R * t340;
        let t406 = ZZ2R * t15 + YY2R * ddq2 - XY2R * t3 - XZ2R * t341 + t403;
        let t407 = YY2R * t16 + ZZ2R * dw2_y + XY2R * t339 + XZ2R * t24 + t404;
        let f2_x = f3_y - (MSX2 * t39 + MSZ2 * t20);
        let f2_y = MSX2 * t21 + MSZ2 * t22 - f3_z;
        let n2_x = t380 + (t405 + MSZ2 * t8);
        let n2_y = t407 + MSX2 * t8 - n3_z;
        let n2_z = t381 + (t406 + (MSX2 * a2_y - MSZ2 * t10));
        let f1_x = c2 * f2_x - s2 * f2_y;
        let t434 = s2 * n2_x + c2 * n2_y + D2 * f1_x;
        put(1, n2_z);
        t434
    };
    // link 1: force and moment
    {
        let n1_z = YY1R * ddq1 - t434;
        put(0, n1_z);
    }
    // drives
    {
        let t438 = f3_z + IA3 * ddq3;
        let t440 = IA4 * ddq4 - t326;
        let t442 = n5_z + IA5 * ddq5;
        let t444 = n6_z + IA6 * ddq6;
        put(2, t438);
        put(3, t440);
        put(4, t442);
        put(5, t444);
    }
}
