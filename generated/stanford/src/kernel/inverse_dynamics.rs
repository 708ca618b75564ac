//! Torques from the standard parameters.
//!
//! `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil
//! and Dombre, 9.5.2.
//!
//! 280 multiplications, 278 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, STANDARD, GRAVITY, Trig, constants};

/// Torques from the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], out: &mut [S; 6]) {
    entries(trig, dq, ddq, phi, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], mut put: impl FnMut(usize, S)) {
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
        IA1, IA2, IA3, IA4, IA5, IA6,
        ..] = *phi;
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
        t14, t15, t16, t17, t18, dw2_y, t20, t21,
        t22, t23, t24,
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
        let t18 = t11 + t17;
        let dw2_y = t16 - t12;
        let t20 = t15 - ddq2;
        let t21 = ddq2 + t15;
        let t22 = t13 + t14;
        let t23 = t16 + dw2_y;
        let t24 = t17 + t18;
        [
        t4, t6, a2_y, t9, w3_z, t11, t12, t13,
        t14, t15, t16, t17, t18, dw2_y, t20, t21,
        t22, t23, t24,
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
        t60, t61, t62, t63, t64, dw4_x, dw4_y, t67,
        t68, t69, t70, t71,
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
        t60, t61, t62, t63, t64, dw4_x, dw4_y, t67,
        t68, t69, t70, t71,
    ]
    };
    // link 5: motion
    let [
        a5_x, t77, t80, w5_y, t86, t89, w5_z, dw5_z,
        t92, t93, t94, t95, t96, dw5_x, dw5_y, t99,
        t100, t101, t102, t103,
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
        t92, t93, t94, t95, t96, dw5_x, dw5_y, t99,
        t100, t101, t102, t103,
    ]
    };
    // link 6: motion
    let [
        t108, a6_x, a6_y, t124, t127, dw6_z, t132, t133,
        t134, dw6_x, dw6_y, t137, t138, t139, t140, t141,
        t142, t143,
    ] = {
        let t107 = a5_x + k_D6 * t99;
        let t108 = k_D6 * t101 - t77;
        let t109 = a4_y - k_D6 * t103;
        let a6_x = c6 * t107 + s6 * t109;
        let a6_y = c6 * t109 - s6 * t107;
        let w6_x = s6 * w5_z - c6 * t80;
        let w6_y = c6 * w5_z + s6 * t80;
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
        t108, a6_x, a6_y, t124, t127, dw6_z, t132, t133,
        t134, dw6_x, dw6_y, t137, t138, t139, t140, t141,
        t142, t143,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t211, t214, t223, t224] = {
        let t165 = XZ6 * t127;
        let t166 = t134 * (ZZ6 - YY6) + XX6 * dw6_x - XY6 * t142 + XZ6 * t140;
        let t167 = t133 * (XX6 - ZZ6) + YY6 * dw6_y + XY6 * t143 - XZ6 * t137;
        let t168 = t132 * (YY6 - XX6) + ZZ6 * dw6_z + XY6 * (t138 + t141) + t165;
        let f6_x = M6 * a6_x + (MSZ6 * t124 + (MSX6 * t138 + MSY6 * t139));
        let f6_y = M6 * a6_y + (MSX6 * t140 - MSY6 * t141 - MSZ6 * t127);
        let f6_z = MSX6 * t142 + MSY6 * t143 - MSZ6 * t101 - M6 * t108;
        let n6_x = t166 + YZ6 * (t101 - t141) - (MSY6 * t108 + MSZ6 * a6_y);
        let n6_y = t167 - YZ6 * t139 + (MSZ6 * a6_x + MSX6 * t108);
        let n6_z = t168 + YZ6 * t124 + (MSX6 * a6_y - MSY6 * a6_x);
        let t211 = c6 * f6_x - s6 * f6_y;
        let t214 = s6 * f6_x + c6 * f6_y;
        let t223 = c6 * n6_x - s6 * n6_y - k_D6 * t214;
        let t224 = s6 * n6_x + c6 * n6_y + k_D6 * t211;
        [f6_z, n6_z, t211, t214, t223, t224]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t302, t305, t308, t311] = {
        let t225 = w5_y * w5_y;
        let t226 = t93 + t225;
        let t227 = t92 + t225;
        let t249 = XZ5 * (t226 - t101);
        let t250 = XZ5 * t103;
        let t251 = XX5 * dw5_x - t96 * (ZZ5 - YY5) + XY5 * t100 - XZ5 * t102;
        let t253 = XY5 * (t227 - t226) - (t95 * (YY5 - XX5) + ZZ5 * dw5_y) + t250;
        let t256 = YZ5 * t86;
        let t259 = t94 * (XX5 - ZZ5) + YY5 * dw5_z - XY5 * t89 + t249 + t256;
        let f5_x = t211 + (M5 * a5_x + (MSZ5 * t99 - (MSX5 * t226 + MSY5 * t86)));
        let t295 = f6_z + (M5 * t77 - (MSZ5 * t101 + (MSX5 * t100 + MSY5 * t89)));
        let f5_z = t214 + (M5 * a4_y - (MSZ5 * t103 + (MSX5 * t102 + MSY5 * t227)));
        let n5_x = t223 + (t251 + YZ5 * (t101 - t227) + (MSY5 * t77 - MSZ5 * a4_y));
        let t298 = n6_z + (t253 + YZ5 * t99 + (MSX5 * a4_y - MSY5 * a5_x));
        let n5_z = t224 + (t259 + (MSZ5 * a5_x - MSX5 * t77));
        let t302 = c5 * f5_x + s5 * t295;
        let t305 = s5 * f5_x - c5 * t295;
        let t308 = c5 * n5_x + s5 * t298;
        let t311 = s5 * n5_x - c5 * t298;
        [f5_z, n5_z, t302, t305, t308, t311]
    };
    // link 4: force and moment
    let [t383, t386, t389, t392, t395, t398] = {
        let t312 = w4_y * w4_y;
        let t313 = t61 + t312;
        let t314 = t60 + t312;
        let t332 = t62 * (XX4 - ZZ4) + YY4 * dw4_z + XY4 * t57;
        let t337 = XZ4 * t71;
        let t338 = XX4 * dw4_x - t64 * (ZZ4 - YY4) - XY4 * t68 + XZ4 * t70;
        let t340 = t63 * (YY4 - XX4) + ZZ4 * dw4_y + XY4 * (t314 - t313) + t337;
        let t374 = MSZ4 * a4_x - MSX4 * a4_y;
        let f4_x = t302 + (M4 * a4_x + (MSY4 * t54 - MSX4 * t313 - MSZ4 * t67));
        let f4_y = f5_z + (M4 * a4_y + (MSX4 * t68 - MSY4 * t57 - MSZ4 * t69));
        let t383 = t305 + (MSX4 * t70 - MSY4 * t314 - MSZ4 * t71 - M4 * a3_z);
        let n4_x = t308 + (t338 + YZ4 * (t69 - t314) + (MSY4 * a4_y + MSZ4 * a3_z));
        let n4_y = n5_z + (t340 - YZ4 * t67 - (MSX4 * a3_z + MSY4 * a4_x));
        let t386 = t311 + (XZ4 * (t313 - t69) - t332 - YZ4 * t54 + t374);
        let t389 = c4 * f4_x - s4 * f4_y;
        let t392 = s4 * f4_x + c4 * f4_y;
        let t395 = c4 * n4_x - s4 * n4_y;
        let t398 = s4 * n4_x + c4 * n4_y;
        [t383, t386, t389, t392, t395, t398]
    };
    // link 3: force and moment
    let [t411, t418, t425, f3_y, f3_z, n3_z, t473, t474] = {
        let t411 = t39 - t38;
        let t418 = t38 - t22;
        let t422 = XZ3 * t12 - (t15 * (ZZ3 - YY3) + XX3 * ddq2 + XY3 * t11);
        let t423 = XZ3 * t418 - (t17 * (XX3 - ZZ3) + YY3 * t18 + XY3 * t21);
        let t424 = t16 * (YY3 - XX3) - ZZ3 * dw2_y + XY3 * t411 + XZ3 * t20;
        let t425 = t22 - t39;
        let f3_x = t389 + (MSY3 * t23 - MSX3 * t38 - MSZ3 * t24 - M3 * t34);
        let f3_y = t392 + (M3 * a3_y + (MSX3 * t12 - MSY3 * t39 - MSZ3 * t20));
        let f3_z = M3 * a3_z + (MSX3 * t11 - MSY3 * t21 - MSZ3 * t22) - t383;
        let n3_x = t395 + (t422 + YZ3 * t425 + (MSY3 * a3_z - MSZ3 * a3_y));
        let n3_y = t398 + (t423 - YZ3 * t23 - (MSZ3 * t34 + MSX3 * a3_z));
        let n3_z = t424 - YZ3 * t24 + (MSX3 * a3_y + MSY3 * t34) - t386;
        let t473 = n3_y + q3 * f3_x;
        let t474 = q3 * f3_y - n3_x;
        [t411, t418, t425, f3_y, f3_z, n3_z, t473, t474]
    };
    // link 2: force and moment
    let [n2_z, t543] = {
        let t496 = t17 * (ZZ2 - YY2) - XX2 * t18 + XY2 * t21 - XZ2 * t23;
        let t497 = YY2 * ddq2 - t15 * (XX2 - ZZ2) - XY2 * t11 - XZ2 * t425;
        let t498 = t16 * (YY2 - XX2) + ZZ2 * dw2_y + XY2 * t411 + XZ2 * t24;
        let f2_x = f3_y - (M2 * t6 + (MSZ2 * t20 + (MSX2 * t39 + MSY2 * t12)));
        let f2_y = M2 * a2_y + (MSZ2 * t22 + (MSX2 * t21 + MSY2 * t11)) - f3_z;
        let n2_x = t473 + (t496 - YZ2 * t418 + (MSZ2 * t4 - MSY2 * a2_y));
        let n2_z = t474 + (t497 + YZ2 * t12 + (MSX2 * a2_y - MSZ2 * t6));
        let t540 = c2 * (n3_z + (MSY2 * t6 - MSX2 * t4 - (t498 + YZ2 * t20)));
        let t543 = s2 * n2_x - t540 + k_D2 * (c2 * f2_x - s2 * f2_y);
        [n2_z, t543]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = YY1 * ddq1 - t543;
        n1_z
    };
    // drives
    {
        let t547 = n1_z + IA1 * ddq1;
        let t549 = n2_z + IA2 * ddq2;
        let t551 = f3_z + IA3 * ddq3;
        let t553 = IA4 * ddq4 - t386;
        let t555 = n5_z + IA5 * ddq5;
        let t557 = n6_z + IA6 * ddq6;
        put(0, t547);
        put(1, t549);
        put(2, t551);
        put(3, t553);
        put(4, t555);
        put(5, t557);
    }
}
