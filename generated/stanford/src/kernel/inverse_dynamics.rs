//! Torques from the standard parameters.
//!
//! `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil and Dombre, 9.5.2.
//!
//! 287 multiplications, 285 additions; 6, 6 of 6 structurally nonzero.

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
        IA1, IA2, IA3, IA4, IA5, IA6,
        ..] = *phi;
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
        t90, a5_x, t96, w5_z, dw5_x, dw5_y, dw5_z,
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
        let t90 = t76 + t77;
        let a5_x = c5 * a4_x - s5 * a3_z;
        let t96 = c5 * a3_z + s5 * a4_x;
        let w5_z = w4_y + dq5;
        let dw5_x = c5 * dw4_x - s5 * dw4_z + dq5 * w5_y;
        let dw5_y = dq5 * t66 - (c5 * dw4_z + s5 * dw4_x);
        let dw5_z = dw4_y + ddq5;
        [
        t66, w5_y, t76, t77, t78, t79, t80, t81,
        t82, t83, t84, t85, t86, t87, t88, t89,
        t90, a5_x, t96, w5_z, dw5_x, dw5_y, dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t115, t116, t117, t118, t119, t120,
        t121, t122, t123, t124, t125, t126, t127, t128,
        t129, t134, a6_x, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ] = {
        let w6_x = s6 * w5_z - c6 * t66;
        let w6_y = c6 * w5_z + s6 * t66;
        let t115 = t66 * t66;
        let t116 = w5_y * w5_y;
        let t117 = w5_z * w5_z;
        let t118 = t66 * w5_y;
        let t119 = t66 * w5_z;
        let t120 = w5_y * w5_z;
        let t121 = t116 + t117;
        let t122 = dw5_z + t118;
        let t123 = dw5_y - t119;
        let t124 = dw5_z - t118;
        let t125 = t115 + t117;
        let t126 = t120 - dw5_x;
        let t127 = dw5_y + t119;
        let t128 = dw5_x + t120;
        let t129 = t115 + t116;
        let t133 = a5_x + D6 * t122;
        let t134 = D6 * t125 - t96;
        let t135 = a4_y - D6 * t128;
        let a6_x = c6 * t133 + s6 * t135;
        let a6_y = c6 * t135 - s6 * t133;
        let w6_z = dq6 - w5_y;
        let dw6_x = c6 * dw5_x + s6 * dw5_z + dq6 * w6_y;
        let dw6_y = c6 * dw5_z - s6 * dw5_x - dq6 * w6_x;
        let dw6_z = ddq6 - dw5_y;
        [
        w6_x, w6_y, t115, t116, t117, t118, t119, t120,
        t121, t122, t123, t124, t125, t126, t127, t128,
        t129, t134, a6_x, a6_y, w6_z, dw6_x, dw6_y, dw6_z,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t231, t234, t243, t244] = {
        let t148 = w6_x * w6_x;
        let t149 = w6_y * w6_y;
        let t150 = w6_z * w6_z;
        let t151 = w6_x * w6_y;
        let t152 = w6_x * w6_z;
        let t153 = w6_y * w6_z;
        let t155 = t151 - dw6_z;
        let t156 = dw6_y + t152;
        let t157 = dw6_z + t151;
        let t159 = t153 - dw6_x;
        let t160 = t152 - dw6_y;
        let t161 = dw6_x + t153;
        let t184 = XZ6 * (t150 - t148);
        let t185 = XZ6 * t159;
        let t186 = t153 * (ZZ6 - YY6) + XX6 * dw6_x - XY6 * t160 + XZ6 * t157;
        let t188 = t151 * (YY6 - XX6) + ZZ6 * dw6_z + XY6 * (t148 - t149) - t185;
        let t191 = YZ6 * t155;
        let t194 = t152 * (XX6 - ZZ6) + YY6 * dw6_y + XY6 * t161 + t184 - t191;
        let f6_x = M6 * a6_x + (MSZ6 * t156 + (MSY6 * t155 - MSX6 * (t149 + t150)));
        let f6_y = M6 * a6_y + (MSZ6 * t159 + (MSX6 * t157 - MSY6 * (t148 + t150)));
        let f6_z = MSX6 * t160 + MSY6 * t161 - MSZ6 * (t148 + t149) - M6 * t134;
        let n6_x = t186 + YZ6 * (t149 - t150) - (MSY6 * t134 + MSZ6 * a6_y);
        let n6_y = t194 + (MSZ6 * a6_x + MSX6 * t134);
        let n6_z = t188 + YZ6 * t156 + (MSX6 * a6_y - MSY6 * a6_x);
        let t231 = c6 * f6_x - s6 * f6_y;
        let t234 = s6 * f6_x + c6 * f6_y;
        let t243 = c6 * n6_x - s6 * n6_y - D6 * t234;
        let t244 = s6 * n6_x + c6 * n6_y + D6 * t231;
        [f6_z, n6_z, t231, t234, t243, t244]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t319, t322, t325, t328] = {
        let t266 = XZ5 * (t116 - t115);
        let t267 = XZ5 * t128;
        let t268 = XX5 * dw5_x - t120 * (ZZ5 - YY5) + XY5 * t124 - XZ5 * t127;
        let t270 = XY5 * (t115 - t117) - (t119 * (YY5 - XX5) + ZZ5 * dw5_y) + t267;
        let t273 = YZ5 * t123;
        let t276 = t118 * (XX5 - ZZ5) + YY5 * dw5_z - XY5 * t126 + t266 - t273;
        let f5_x = t231 + (M5 * a5_x + (MSZ5 * t122 + (MSY5 * t123 - MSX5 * t121)));
        let t312 = f6_z + (M5 * t96 - (MSZ5 * t125 + (MSX5 * t124 + MSY5 * t126)));
        let f5_z = t234 + (M5 * a4_y - (MSZ5 * t128 + (MSX5 * t127 + MSY5 * t129)));
        let n5_x = t243 + (t268 + YZ5 * (t117 - t116) + (MSY5 * t96 - MSZ5 * a4_y));
        let t315 = n6_z + (t270 + YZ5 * t122 + (MSX5 * a4_y - MSY5 * a5_x));
        let n5_z = t244 + (t276 + (MSZ5 * a5_x - MSX5 * t96));
        let t319 = c5 * f5_x + s5 * t312;
        let t322 = s5 * f5_x - c5 * t312;
        let t325 = c5 * n5_x + s5 * t315;
        let t328 = s5 * n5_x - c5 * t315;
        [f5_z, n5_z, t319, t322, t325, t328]
    };
    // link 4: force and moment
    let [t397, t400, t403, t406, t409, t412] = {
        let t346 = t79 * (XX4 - ZZ4) + YY4 * dw4_z + XY4 * t87;
        let t351 = XZ4 * t89;
        let t352 = XX4 * dw4_x - t81 * (ZZ4 - YY4) - XY4 * t85 + XZ4 * t88;
        let t354 = t80 * (YY4 - XX4) + ZZ4 * dw4_y + XY4 * (t76 - t78) + t351;
        let t388 = MSZ4 * a4_x - MSX4 * a4_y;
        let f4_x = t319 + (M4 * a4_x - (MSZ4 * t83 + (MSX4 * t82 + MSY4 * t84)));
        let f4_y = f5_z + (M4 * a4_y + (MSX4 * t85 - MSY4 * t87 - MSZ4 * t86));
        let t397 = t322 + (MSX4 * t88 - MSY4 * t90 - MSZ4 * t89 - M4 * a3_z);
        let n4_x = t325 + (t352 + YZ4 * (t78 - t77) + (MSY4 * a4_y + MSZ4 * a3_z));
        let n4_y = n5_z + (t354 - YZ4 * t83 - (MSX4 * a3_z + MSY4 * a4_x));
        let t400 = t328 + (XZ4 * (t77 - t76) - t346 + YZ4 * t84 + t388);
        let t403 = c4 * f4_x - s4 * f4_y;
        let t406 = s4 * f4_x + c4 * f4_y;
        let t409 = c4 * n4_x - s4 * n4_y;
        let t412 = s4 * n4_x + c4 * n4_y;
        [t397, t400, t403, t406, t409, t412]
    };
    // link 3: force and moment
    let [t425, t432, t439, f3_y, f3_z, n3_z, t487, t488] = {
        let t425 = t19 - t17;
        let t432 = t18 - t19;
        let t436 = XZ3 * t3 - (t20 * (ZZ3 - YY3) + XX3 * ddq2 + XY3 * t2);
        let t437 = XZ3 * t432 - (t13 * (XX3 - ZZ3) + YY3 * t15 + XY3 * t23);
        let t438 = t14 * (YY3 - XX3) - ZZ3 * dw2_y + XY3 * t425 + XZ3 * t22;
        let t439 = t17 - t18;
        let f3_x = t403 + (MSY3 * t25 - MSX3 * t27 - MSZ3 * t26 - M3 * t37);
        let f3_y = t406 + (M3 * a3_y + (MSX3 * t3 - MSY3 * t21 - MSZ3 * t22));
        let f3_z = M3 * a3_z + (MSX3 * t2 - MSY3 * t23 - MSZ3 * t24) - t397;
        let n3_x = t409 + (t436 + YZ3 * t439 + (MSY3 * a3_z - MSZ3 * a3_y));
        let n3_y = t412 + (t437 - YZ3 * t25 - (MSZ3 * t37 + MSX3 * a3_z));
        let n3_z = t438 - YZ3 * t26 + (MSX3 * a3_y + MSY3 * t37) - t400;
        let t487 = n3_y + q3 * f3_x;
        let t488 = q3 * f3_y - n3_x;
        [t425, t432, t439, f3_y, f3_z, n3_z, t487, t488]
    };
    // link 2: force and moment
    let [n2_z, t557] = {
        let t510 = t13 * (ZZ2 - YY2) - XX2 * t15 + XY2 * t23 - XZ2 * t25;
        let t511 = YY2 * ddq2 - t20 * (XX2 - ZZ2) - XY2 * t2 - XZ2 * t439;
        let t512 = t14 * (YY2 - XX2) + ZZ2 * dw2_y + XY2 * t425 + XZ2 * t26;
        let f2_x = f3_y - (M2 * t10 + (MSZ2 * t22 + (MSX2 * t21 + MSY2 * t3)));
        let f2_y = M2 * a2_y + (MSZ2 * t24 + (MSX2 * t23 + MSY2 * t2)) - f3_z;
        let n2_x = t487 + (t510 - YZ2 * t432 + (MSZ2 * t8 - MSY2 * a2_y));
        let n2_z = t488 + (t511 + YZ2 * t3 + (MSX2 * a2_y - MSZ2 * t10));
        let t554 = c2 * (n3_z + (MSY2 * t10 - MSX2 * t8 - (t512 + YZ2 * t22)));
        let t557 = s2 * n2_x - t554 + D2 * (c2 * f2_x - s2 * f2_y);
        [n2_z, t557]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = YY1 * ddq1 - t557;
        n1_z
    };
    // drives
    {
        let t561 = n1_z + IA1 * ddq1;
        let t563 = n2_z + IA2 * ddq2;
        let t565 = f3_z + IA3 * ddq3;
        let t567 = IA4 * ddq4 - t400;
        let t569 = n5_z + IA5 * ddq5;
        let t571 = n6_z + IA6 * ddq6;
        put(0, t561);
        put(1, t563);
        put(2, t565);
        put(3, t567);
        put(4, t569);
        put(5, t571);
    }
}
