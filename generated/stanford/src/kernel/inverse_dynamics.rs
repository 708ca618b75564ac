//! Torques from the standard parameters.
//!
//! `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil and Dombre, 9.5.2.
//!
//! 274 multiplications, 272 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, STANDARD, Trig};

/// Torques from the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], out: &mut [S; 6]) {
    entries(trig, dq, ddq, phi, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], mut put: impl FnMut(usize, S)) {
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let [
        _, _, _, _, _, YY1, _, _, _, _, M2, MSX2,
        MSY2, MSZ2, XX2, YY2, ZZ2, XY2, XZ2, YZ2, M3, MSX3, MSY3, MSZ3,
        XX3, YY3, ZZ3, XY3, XZ3, YZ3, M4, MSX4, MSY4, MSZ4, XX4, YY4,
        ZZ4, XY4, XZ4, YZ4, M5, MSX5, MSY5, MSZ5, XX5, YY5, ZZ5, XY5,
        XZ5, YZ5, M6, MSX6, MSY6, MSZ6, XX6, YY6, ZZ6, XY6, XZ6, YZ6,
        ..] = *phi;
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
        t14, t15, t16, t17, t18, t19, t20, t21,
        t22, t23, t24,
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
        let t18 = t3 + t17;
        let t19 = t4 - t16;
        let t20 = t15 - ddq2;
        let t21 = ddq2 + t15;
        let t22 = t13 + t14;
        let t23 = t16 - t19;
        let t24 = t17 + t18;
        [
        t1, w3_z, t3, t4, t8, t10, a2_y, t13,
        t14, t15, t16, t17, t18, t19, t20, t21,
        t22, t23, t24,
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
        t42, t45, t48, a4_y, t54, t57, w4_z, dw4_z,
        t60, t61, t62, t63, t64, t65, dw4_y, t67,
        t68, t69, t70, t71,
    ] = {
        let t42 = c4 * dq2 + s4 * t1;
        let t45 = c4 * t1 - s4 * dq2;
        let t48 = c4 * t34 - s4 * a3_y;
        let a4_y = c4 * a3_y + s4 * t34;
        let t54 = c4 * t24 + s4 * t20;
        let t57 = s4 * t24 - c4 * t20;
        let w4_z = w3_z + dq4;
        let dw4_z = t19 + ddq4;
        let t60 = t42 * t42;
        let t61 = w4_z * w4_z;
        let t62 = t42 * t45;
        let t63 = t42 * w4_z;
        let t64 = t45 * w4_z;
        let t65 = t57 + t64;
        let dw4_y = t63 - t54;
        let t67 = t62 - dw4_z;
        let t68 = dw4_z + t62;
        let t69 = t60 + t61;
        let t70 = t63 + dw4_y;
        let t71 = t64 + t65;
        [
        t42, t45, t48, a4_y, t54, t57, w4_z, dw4_z,
        t60, t61, t62, t63, t64, t65, dw4_y, t67,
        t68, t69, t70, t71,
    ]
    };
    // link 5: motion
    let [
        t74, t77, t80, t83, t86, t89, w5_z, dw5_z,
        t92, t93, t94, t95, t96, t97, dw5_y, t99,
        t100, t101, t102, t103,
    ] = {
        let t74 = c5 * t42 + s5 * w4_z;
        let t77 = c5 * w4_z - s5 * t42;
        let t80 = c5 * t48 + s5 * a3_z;
        let t83 = s5 * t48 - c5 * a3_z;
        let t86 = c5 * t67 + s5 * t71;
        let t89 = c5 * t71 - s5 * t67;
        let w5_z = dq5 - t45;
        let dw5_z = dw4_y + ddq5;
        let t92 = t74 * t74;
        let t93 = w5_z * w5_z;
        let t94 = t74 * t77;
        let t95 = t74 * w5_z;
        let t96 = t77 * w5_z;
        let t97 = t89 + t96;
        let dw5_y = t86 + t95;
        let t99 = dw5_z - t94;
        let t100 = dw5_z + t94;
        let t101 = t92 + t93;
        let t102 = t95 + dw5_y;
        let t103 = t96 + t97;
        [
        t74, t77, t80, t83, t86, t89, w5_z, dw5_z,
        t92, t93, t94, t95, t96, t97, dw5_y, t99,
        t100, t101, t102, t103,
    ]
    };
    // link 6: motion
    let [
        t114, t118, a6_y, t124, t127, t129, t132, t133,
        t134, dw6_x, dw6_y, t137, t138, t139, t140, t141,
        t142, t143,
    ] = {
        let t106 = c6 * t74 - s6 * w5_z;
        let w6_y = c6 * w5_z + s6 * t74;
        let t113 = t80 - D6 * t99;
        let t114 = t83 + D6 * t101;
        let t115 = a4_y + D6 * t103;
        let t118 = c6 * t113 - s6 * t115;
        let a6_y = c6 * t115 + s6 * t113;
        let t124 = c6 * t99 + s6 * t103;
        let t127 = s6 * t99 - c6 * t103;
        let w6_z = t77 + dq6;
        let t129 = dw5_y - ddq6;
        let t130 = t106 * t106;
        let t131 = w6_z * w6_z;
        let t132 = t106 * w6_y;
        let t133 = t106 * w6_z;
        let t134 = w6_y * w6_z;
        let dw6_x = t127 + t134;
        let dw6_y = t124 + t133;
        let t137 = t130 - t131;
        let t138 = t101 - t137;
        let t139 = t129 - t132;
        let t140 = t129 + t132;
        let t141 = t130 + t131;
        let t142 = t133 + dw6_y;
        let t143 = t134 + dw6_x;
        [
        t114, t118, a6_y, t124, t127, t129, t132, t133,
        t134, dw6_x, dw6_y, t137, t138, t139, t140, t141,
        t142, t143,
    ]
    };
    // link 6: force and moment
    let [t196, n6_z, t211, t214, t223, t224] = {
        let t165 = XZ6 * t127;
        let t166 = t134 * (ZZ6 - YY6) + XX6 * dw6_x + XY6 * t142 - XZ6 * t140;
        let t167 = YY6 * dw6_y - t133 * (XX6 - ZZ6) + XY6 * t143 - XZ6 * t137;
        let t168 = ZZ6 * t129 - t132 * (XX6 - YY6) + XY6 * (t138 - t141) - t165;
        let f6_x = MSZ6 * t124 + (MSY6 * t139 - MSX6 * t138) - M6 * t118;
        let f6_y = M6 * a6_y - (MSZ6 * t127 + (MSX6 * t140 + MSY6 * t141));
        let t196 = M6 * t114 + (MSZ6 * t101 + (MSX6 * t142 - MSY6 * t143));
        let t206 = MSY6 * t114 + MSZ6 * a6_y - (t166 + YZ6 * (t101 - t141));
        let t207 = MSZ6 * t118 - MSX6 * t114 - (t167 - YZ6 * t139);
        let n6_z = MSX6 * a6_y + MSY6 * t118 - (t168 - YZ6 * t124);
        let t211 = c6 * f6_x - s6 * f6_y;
        let t214 = s6 * f6_x + c6 * f6_y;
        let t223 = s6 * t207 - c6 * t206 - D6 * t214;
        let t224 = s6 * t206 + c6 * t207 - D6 * t211;
        put(5, n6_z);
        [t196, n6_z, t211, t214, t223, t224]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t302, t305, t308, t311] = {
        let t225 = t77 * t77;
        let t226 = t93 + t225;
        let t227 = t92 + t225;
        let t245 = XY5 * t89 - (t94 * (ZZ5 - XX5) + YY5 * dw5_z);
        let t246 = XY5 * (t227 - t226) - (t95 * (YY5 - XX5) + ZZ5 * dw5_y);
        let t251 = XY5 * t100 - (XX5 * t97 - t96 * (ZZ5 - YY5)) - XZ5 * t102;
        let t287 = MSX5 * t83 - MSZ5 * t80;
        let t293 = YZ5 * t99 - (XZ5 * t103 - t246) + (MSX5 * a4_y + MSY5 * t80);
        let t294 = M5 * t80 + (MSX5 * t226 - MSY5 * t86 - MSZ5 * t99) - t211;
        let t295 = t196 + (M5 * t83 + (MSZ5 * t101 + (MSX5 * t100 + MSY5 * t89)));
        let f5_z = t214 + (M5 * a4_y - (MSX5 * t102 + MSY5 * t227 - MSZ5 * t103));
        let n5_x = t223 - (MSY5 * t83 + MSZ5 * a4_y - (t251 - YZ5 * (t227 - t101)));
        let t298 = n6_z + t293;
        let n5_z = XZ5 * (t226 - t101) - t245 - YZ5 * t86 + t287 - t224;
        let t302 = c5 * t294 + s5 * t295;
        let t305 = s5 * t294 - c5 * t295;
        let t308 = c5 * n5_x + s5 * t298;
        let t311 = c5 * t298 - s5 * n5_x;
        put(4, n5_z);
        [f5_z, n5_z, t302, t305, t308, t311]
    };
    // link 4: force and moment
    let [t383, n4_z, t389, t392, t395, t398] = {
        let t312 = t45 * t45;
        let t313 = t61 + t312;
        let t314 = t60 + t312;
        let t336 = XZ4 * (t313 - t69);
        let t337 = XZ4 * t71;
        let t338 = t64 * (ZZ4 - YY4) - XX4 * t65 - XY4 * t68 + XZ4 * t70;
        let t340 = XY4 * (t313 - t314) - (t63 * (YY4 - XX4) + ZZ4 * dw4_y) + t337;
        let t343 = YZ4 * t54;
        let t346 = YY4 * dw4_z - t62 * (XX4 - ZZ4) + XY4 * t57 - t336 + t343;
        let t381 = t302 + (M4 * t48 + (MSX4 * t313 - MSY4 * t54 - MSZ4 * t67));
        let f4_y = f5_z - (MSZ4 * t69 + (MSY4 * t57 - MSX4 * t68) - M4 * a4_y);
        let t383 = t305 + (M4 * a3_z - (MSZ4 * t71 + (MSX4 * t70 - MSY4 * t314)));
        let n4_x = t308 + (t338 + YZ4 * (t69 - t314) + (MSY4 * a4_y + MSZ4 * a3_z));
        let t385 = MSX4 * a3_z - MSY4 * t48 - (YZ4 * t67 - t340) - n5_z;
        let n4_z = t311 + (t346 + (MSZ4 * t48 + MSX4 * a4_y));
        let t389 = c4 * t381 + s4 * f4_y;
        let t392 = c4 * f4_y - s4 * t381;
        let t395 = c4 * n4_x + s4 * t385;
        let t398 = c4 * t385 - s4 * n4_x;
        put(3, n4_z);
        [t383, n4_z, t389, t392, t395, t398]
    };
    // link 3: force and moment
    let [t411, t418, t425, f3_y, f3_z, n3_z, t473, t474] = {
        let t411 = t38 - t39;
        let t418 = t38 - t22;
        let t422 = t15 * (YY3 - ZZ3) - XX3 * ddq2 - XY3 * t3 + XZ3 * t4;
        let t423 = t17 * (XX3 - ZZ3) + YY3 * t18 + XY3 * t21 - XZ3 * t418;
        let t424 = t16 * (YY3 - XX3) + ZZ3 * t19 - XY3 * t411 + XZ3 * t20;
        let t425 = t39 - t22;
        let t465 = t389 + (M3 * t34 + (MSZ3 * t24 + (MSX3 * t38 - MSY3 * t23)));
        let f3_y = t392 + (M3 * a3_y + (MSX3 * t4 - MSY3 * t39 - MSZ3 * t20));
        let f3_z = t383 - (MSZ3 * t22 - (MSX3 * t3 - MSY3 * t21) - M3 * a3_z);
        let n3_x = t395 + (MSY3 * a3_z - MSZ3 * a3_y - (YZ3 * t425 - t422));
        let n3_z = n4_z + (t424 - YZ3 * t24 + (MSX3 * a3_y + MSY3 * t34));
        let t471 = q3 * t465;
        let t473 = t398 + (t423 + YZ3 * t23 + (MSZ3 * t34 + MSX3 * a3_z)) + t471;
        let t474 = n3_x - q3 * f3_y;
        put(2, f3_z);
        [t411, t418, t425, f3_y, f3_z, n3_z, t473, t474]
    };
    // link 2: force and moment
    let t543 = {
        let t496 = XY2 * t21 - (t17 * (YY2 - ZZ2) + XX2 * t18) - XZ2 * t23;
        let t497 = XZ2 * t425 - (t15 * (XX2 - ZZ2) - YY2 * ddq2 + XY2 * t3);
        let t498 = XZ2 * t24 - (ZZ2 * t19 - t16 * (YY2 - XX2) + XY2 * t411);
        let f2_x = f3_y - (M2 * t10 + (MSZ2 * t20 + (MSX2 * t39 + MSY2 * t4)));
        let f2_y = M2 * a2_y + (MSZ2 * t22 + (MSX2 * t21 + MSY2 * t3)) - f3_z;
        let n2_z = t497 + YZ2 * t4 + (MSX2 * a2_y - MSZ2 * t10) - t474;
        let t539 = s2 * (t473 + (MSY2 * a2_y - MSZ2 * t8 - (t496 - YZ2 * t418)));
        let t540 = c2 * (n3_z + (MSY2 * t10 - MSX2 * t8 - (t498 + YZ2 * t20)));
        let t543 = D2 * (c2 * f2_x - s2 * f2_y) - (t539 + t540);
        put(1, n2_z);
        t543
    };
    // link 1: force and moment
    {
        let n1_z = YY1 * ddq1 - t543;
        put(0, n1_z);
    }
}
