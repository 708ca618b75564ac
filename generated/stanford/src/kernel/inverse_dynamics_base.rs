//! Torques from the base parameters.
//!
//! `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil and Dombre, 9.6.
//!
//! 236 multiplications, 220 additions; 6, 6 of 6 structurally nonzero.

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
    // link 2: motion
    let [
        t0, w3_z, t2, t3, t8, t10, a2_y, t13,
        t14, t15, dw2_y,
    ] = {
        let t0 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t2 = s2 * ddq1;
        let t3 = c2 * ddq1;
        let t7 = D2 * ddq1;
        let t8 = D2 * (dq1 * dq1);
        let t10 = s2 * k0 + c2 * t7;
        let a2_y = s2 * t7 - c2 * k0;
        let t13 = dq2 * w3_z;
        let t14 = dq2 * t0;
        let t15 = t2 + t13;
        let dw2_y = t14 - t3;
        [
        t0, w3_z, t2, t3, t8, t10, a2_y, t13,
        t14, t15, dw2_y,
    ]
    };
    // link 3: motion
    let [
        t17, t18, t19, t20, t21, t22, t23, t24,
        t25, t26, t27, t37, a3_y, a3_z,
    ] = {
        let t17 = t0 * t0;
        let t18 = w3_z * w3_z;
        let t19 = dq2 * dq2;
        let t20 = t0 * w3_z;
        let t21 = t18 + t19;
        let t22 = t20 - ddq2;
        let t23 = ddq2 + t20;
        let t24 = t17 + t19;
        let t25 = t14 + dw2_y;
        let t26 = t13 + t15;
        let t27 = t17 + t18;
        let t34 = dq3 * k2;
        let t37 = q3 * t26 - t8 + t0 * t34;
        let a3_y = dq2 * t34 - (t10 + q3 * t22);
        let a3_z = ddq3 - (a2_y + q3 * t24);
        [
        t17, t18, t19, t20, t21, t22, t23, t24,
        t25, t26, t27, t37, a3_y, a3_z,
    ]
    };
    // link 4: motion
    let [t42, w4_y, a4_x, a4_y, w4_z, dw4_x, dw4_y, dw4_z] = {
        let t42 = c4 * dq2 + s4 * t0;
        let w4_y = s4 * dq2 - c4 * t0;
        let a4_x = s4 * a3_y - c4 * t37;
        let a4_y = c4 * a3_y + s4 * t37;
        let w4_z = w3_z + dq4;
        let dw4_x = dq4 * w4_y - (c4 * ddq2 + s4 * t15);
        let dw4_y = s4 * ddq2 - c4 * t15 + dq4 * t42;
        let dw4_z = ddq4 - dw2_y;
        [t42, w4_y, a4_x, a4_y, w4_z, dw4_x, dw4_y, dw4_z]
    };
    // link 5: motion
    let [
        t66, w5_y, t76, t77, t78, t79, t80, t81,
        t82, t83, t84, t85, t86, t87, t88, t89,
        a5_x, t95, w5_z, dw5_x, dw5_y, dw5_z,
    ] = {
        let t66 = c5 * t42 + s5 * w4_z;
        let w5_y = s5 * t42 - c5 * w4_z;
        let t76 = t42 * t42;
        let t77 = w4_y * w4_y;
        let t78 = w4_z * w4_z;
        let t79 = t42 * w4_y;
        let t80 = t42 * w4_z;
        let t81 = w4_y * w4_z;
        let t82 = t77 + t78;
        let t83 = dw4_z + t79;
        let t84 = dw4_y - t80;
        let t85 = dw4_z - t79;
        let t86 = t76 + t78;
        let t87 = t81 - dw4_x;
        let t88 = dw4_y + t80;
        let t89 = dw4_x + t81;
        let a5_x = c5 * a4_x - s5 * a3_z;
        let t95 = c5 * a3_z + s5 * a4_x;
        let w5_z = w4_y + dq5;
        let dw5_x = c5 * dw4_x - s5 * dw4_z + dq5 * w5_y;
        let dw5_y = dq5 * t66 - (c5 * dw4_z + s5 * dw4_x);
        let dw5_z = dw4_y + ddq5;
        [
        t66, w5_y, t76, t77, t78, t79, t80, t81,
        t82, t83, t84, t85, t86, t87, t88, t89,
        a5_x, t95, w5_z, dw5_x, dw5_y, dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t114, t115, t116, t117, t118, t119,
        t120, t121, t122, t123, t124, t125, t126, t127,
        t132, a6_x, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ] = {
        let w6_x = s6 * w5_z - c6 * t66;
        let w6_y = c6 * w5_z + s6 * t66;
        let t114 = t66 * t66;
        let t115 = w5_y * w5_y;
        let t116 = w5_z * w5_z;
        let t117 = t66 * w5_y;
        let t118 = t66 * w5_z;
        let t119 = w5_y * w5_z;
        let t120 = t115 + t116;
        let t121 = dw5_z + t117;
        let t122 = dw5_y - t118;
        let t123 = dw5_z - t117;
        let t124 = t114 + t116;
        let t125 = t119 - dw5_x;
        let t126 = dw5_y + t118;
        let t127 = dw5_x + t119;
        let t131 = a5_x + D6 * t121;
        let t132 = D6 * t124 - t95;
        let t133 = a4_y - D6 * t127;
        let a6_x = c6 * t131 + s6 * t133;
        let a6_y = c6 * t133 - s6 * t131;
        let w6_z = dq6 - w5_y;
        let dw6_x = c6 * dw5_x + s6 * dw5_z + dq6 * w6_y;
        let dw6_y = c6 * dw5_z - s6 * dw5_x - dq6 * w6_x;
        let dw6_z = ddq6 - dw5_y;
        [
        w6_x, w6_y, t114, t115, t116, t117, t118, t119,
        t120, t121, t122, t123, t124, t125, t126, t127,
        t132, a6_x, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t208, t211, t220, t221] = {
        let t146 = w6_x * w6_x;
        let t147 = w6_y * w6_y;
        let t148 = w6_z * w6_z;
        let t149 = w6_x * w6_y;
        let t150 = w6_x * w6_z;
        let t151 = w6_y * w6_z;
        let t153 = t149 - dw6_z;
        let t155 = dw6_z + t149;
        let t158 = t150 - dw6_y;
        let t159 = dw6_x + t151;
        let t178 = XZ6 * (t151 - dw6_x);
        let t183 = YZ6 * (t147 - t148);
        let t184 = YZ6 * t153;
        let t185 = YZ6 * (dw6_y + t150);
        let t186 = ZZ6 * t151 + XX6R * dw6_x - XY6 * t158 + XZ6 * t155 + t183;
        let t187 = t150 * (XX6R - ZZ6) + XY6 * t159 + XZ6 * (t148 - t146) - t184;
        let t188 = ZZ6 * dw6_z - XX6R * t149 + XY6 * (t146 - t147) - t178 + t185;
        let f6_x = MSY6 * t153 - MSX6 * (t147 + t148);
        let f6_y = MSX6 * t155 - MSY6 * (t146 + t148);
        let f6_z = MSX6 * t158 + MSY6 * t159;
        let n6_x = t186 - MSY6 * t132;
        let n6_y = t187 + MSX6 * t132;
        let n6_z = t188 + (MSX6 * a6_y - MSY6 * a6_x);
        let t208 = c6 * f6_x - s6 * f6_y;
        let t211 = s6 * f6_x + c6 * f6_y;
        let t220 = c6 * n6_x - s6 * n6_y - D6 * t211;
        let t221 = s6 * n6_x + c6 * n6_y + D6 * t208;
        [f6_z, n6_z, t208, t211, t220, t221]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t276, t279, t282, t285] = {
        let t242 = YY5R * dw5_z - ZZ5R * t117 - XY5 * t125 + XZ5 * (t115 - t114);
        let t243 = XY5 * (t114 - t116) - (YY5R * t118 + ZZ5R * dw5_y) + XZ5 * t127;
        let t245 = YZ5 * (t116 - t115);
        let t260 = MSZ5R * a4_y;
        let t265 = XY5 * t123 - t119 * (ZZ5R - YY5R) - XZ5 * t126 + t245 - t260;
        let f5_x = t208 + (MSZ5R * t121 - MSX5 * t120);
        let f5_y = MSX5 * t123 + MSZ5R * t124 - f6_z;
        let f5_z = t211 - (MSX5 * t126 + MSZ5R * t127);
        let n5_x = t220 + t265;
        let t272 = n6_z + (t243 + YZ5 * t121 + MSX5 * a4_y);
        let n5_z = t221 + (t242 - YZ5 * t122 + (MSZ5R * a5_x - MSX5 * t95));
        let t276 = c5 * f5_x - s5 * f5_y;
        let t279 = s5 * f5_x + c5 * f5_y;
        let t282 = c5 * n5_x + s5 * t272;
        let t285 = s5 * n5_x - c5 * t272;
        [f5_z, n5_z, t276, t279, t282, t285]
    };
    // link 4: force and moment
    let [t334, t337, t340, t343, t346, t349] = {
        let t306 = ZZ4R * t79 - YY4R * dw4_z - XY4 * t87 + XZ4 * (t77 - t76);
        let t307 = YY4R * t80 + ZZ4R * dw4_y + XY4 * (t76 - t78) + XZ4 * t89;
        let t309 = YZ4 * (t78 - t77);
        let t324 = MSZ4R * a3_z;
        let t329 = XZ4 * t88 - (t81 * (ZZ4R - YY4R) + XY4 * t85) + t309 + t324;
        let f4_x = t276 - (MSX4 * t82 + MSZ4R * t83);
        let f4_y = f5_z + (MSX4 * t85 - MSZ4R * t86);
        let t334 = t279 + (MSX4 * t88 - MSZ4R * t89);
        let n4_x = t282 + t329;
        let n4_y = n5_z + (t307 - YZ4 * t83 - MSX4 * a3_z);
        let t337 = t285 + (t306 + YZ4 * t84 + (MSZ4R * a4_x - MSX4 * a4_y));
        let t340 = c4 * f4_x - s4 * f4_y;
        let t343 = s4 * f4_x + c4 * f4_y;
        let t346 = c4 * n4_x - s4 * n4_y;
        let t349 = s4 * n4_x + c4 * n4_y;
        [t334, t337, t340, t343, t346, t349]
    };
    // link 3: force and moment
    let [t350, t351, t352, f3_y, f3_z, n3_z, t391, t392] = {
        let t350 = t19 - t17;
        let t351 = t18 - t19;
        let t352 = t17 - t18;
        let f3_x = t340 + (MSY3 * t25 - MSX3 * t27 - MSZ3R * t26 - M3R * t37);
        let f3_y = t343 + (M3R * a3_y + (MSX3 * t3 - MSY3 * t21 - MSZ3R * t22));
        let f3_z = M3R * a3_z + (MSX3 * t2 - MSY3 * t23 - MSZ3R * t24) - t334;
        let n3_x = t346 + (MSY3 * a3_z - MSZ3R * a3_y);
        let n3_y = t349 - (MSZ3R * t37 + MSX3 * a3_z);
        let n3_z = MSX3 * a3_y + MSY3 * t37 - t337;
        let t391 = n3_y + q3 * f3_x;
        let t392 = q3 * f3_y - n3_x;
        [t350, t351, t352, f3_y, f3_z, n3_z, t391, t392]
    };
    // link 2: force and moment
    let t445 = {
        let t414 = YZ2R * t3;
        let t415 = YZ2R * t22;
        let t416 = t13 * (ZZ2R - YY2R) + XY2R * t23 - XZ2R * t25 - YZ2R * t351;
        let t417 = ZZ2R * t20 + YY2R * ddq2 - XY2R * t2 - XZ2R * t352 + t414;
        let t418 = YY2R * t14 + ZZ2R * dw2_y + XY2R * t350 + XZ2R * t26 + t415;
        let f2_x = f3_y - (MSX2 * t21 + MSZ2 * t22);
        let f2_y = MSX2 * t23 + MSZ2 * t24 - f3_z;
        let n2_x = t391 + (t416 + MSZ2 * t8);
        let n2_y = t418 + MSX2 * t8 - n3_z;
        let n2_z = t392 + (t417 + (MSX2 * a2_y - MSZ2 * t10));
        let f1_x = c2 * f2_x - s2 * f2_y;
        let t445 = s2 * n2_x + c2 * n2_y + D2 * f1_x;
        put(1, n2_z);
        t445
    };
    // link 1: force and moment
    {
        let n1_z = YY1R * ddq1 - t445;
        put(0, n1_z);
    }
    // drives
    {
        let t449 = f3_z + IA3 * ddq3;
        let t451 = IA4 * ddq4 - t337;
        let t453 = n5_z + IA5 * ddq5;
        let t455 = n6_z + IA6 * ddq6;
        put(2, t449);
        put(3, t451);
        put(4, t453);
        put(5, t455);
    }
}
