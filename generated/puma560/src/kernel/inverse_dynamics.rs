//! Torques from the standard parameters.
//!
//! `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil
//! and Dombre, 9.5.2.
//!
//! 322 multiplications, 303 additions; 6, 6 of 6 structurally nonzero.

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
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let [
        _, _, _, _, _, _, ZZ1, _, _, _, M2, MSX2,
        MSY2, MSZ2, XX2, YY2, ZZ2, XY2, XZ2, YZ2, M3, MSX3, MSY3, MSZ3,
        XX3, YY3, ZZ3, XY3, XZ3, YZ3, M4, MSX4, MSY4, MSZ4, XX4, YY4,
        ZZ4, XY4, XZ4, YZ4, M5, MSX5, MSY5, MSZ5, XX5, YY5, ZZ5, XY5,
        XZ5, YZ5, M6, MSX6, MSY6, MSZ6, XX6, YY6, ZZ6, XY6, XZ6, YZ6,
        IA1, IA2, IA3, IA4, IA5, IA6, FV1, FV2, FV3, FV4, FV5, FV6,
        FC1, FC2, FC3, FC4, FC5, FC6,
        ..] = *phi;
    let k0 = S::constant(-GRAVITY[2]);
    let k3 = S::constant(-constants::D3);
    let k4 = S::constant(-constants::A3);
    let k_A2 = S::constant(constants::A2);
    let k_D2 = S::constant(constants::D2);
    let k_D4 = S::constant(constants::D4);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        t4, t6, a2_y, t11, t12, t14, t19, t20,
        t21, t22, t23,
    ] = {
        let t3 = k_D2 * ddq1;
        let t4 = k_D2 * t0;
        let t6 = s2 * k0 + c2 * t3;
        let a2_y = s2 * t3 - c2 * k0;
        let t9 = s2 * dq1;
        let t11 = s2 * ddq1;
        let t12 = c2 * ddq1;
        let t13 = t9 * t9;
        let t14 = dq2 * dq2;
        let t15 = t9 * (c2 * dq1);
        let t16 = dq2 * t9;
        let dw2_y = t16 - t12;
        let t19 = t13 - t14 - t0;
        let t20 = t15 - ddq2;
        let t21 = ddq2 + t15;
        let t22 = t13 + t14;
        let t23 = t16 + dw2_y;
        [
        t4, t6, a2_y, t11, t12, t14, t19, t20,
        t21, t22, t23,
    ]
    };
    // link 3: motion
    let [
        t26, t29, w3_z, dw3_z, a3_z, a3_x, a3_y, t50,
        t51, t52, w3_y, t55, dw3_y, t62, t63, t64,
        t65, t66, t67,
    ] = {
        let t26 = s2 * c3 + c2 * s3;
        let t29 = s2 * s3 - c2 * c3;
        let w3_z = dq2 + dq3;
        let dw3_z = ddq2 + ddq3;
        let t41 = k_A2 * t19 + t12 * k3 - t6;
        let t42 = a2_y + (k_A2 * t21 - t11 * k3);
        let a3_z = t0 * k3 - k_A2 * t23 - t4;
        let a3_x = c3 * t41 + s3 * t42;
        let a3_y = c3 * t42 - s3 * t41;
        let t50 = ddq1 * t29;
        let t51 = ddq1 * t26;
        let t52 = dq1 * t26;
        let w3_y = dq1 * t29;
        let t54 = t52 * t52;
        let t55 = w3_z * w3_z;
        let t56 = t52 * w3_y;
        let t57 = w3_z * t52;
        let t58 = w3_z * w3_y;
        let dw3_x = t58 - t51;
        let dw3_y = t50 + t57;
        let t62 = t54 - t55 - t0;
        let t63 = dw3_z + t56;
        let t64 = dw3_z - t56;
        let t65 = t54 + t55;
        let t66 = t57 + dw3_y;
        let t67 = t58 + dw3_x;
        [
        t26, t29, w3_z, dw3_z, a3_z, a3_x, a3_y, t50,
        t51, t52, w3_y, t55, dw3_y, t62, t63, t64,
        t65, t66, t67,
    ]
    };
    // link 4: motion
    let [
        t78, a4_x, a4_y, w4_x, w4_y, t94, t97, w4_z,
        dw4_z, t102, t103, t104, dw4_x, dw4_y, t107, t108,
        t109, t110, t111, t112, t113,
    ] = {
        let t77 = a3_x + (k_D4 * t63 - t62 * k4);
        let t78 = a3_y + (k_D4 * t65 - t64 * k4);
        let t79 = a3_z + (t66 * k4 - k_D4 * t67);
        let a4_x = c4 * t77 + s4 * t79;
        let a4_y = c4 * t79 - s4 * t77;
        let w4_x = s4 * w3_z - c4 * t52;
        let w4_y = c4 * w3_z + s4 * t52;
        let t94 = c4 * t63 - s4 * t67;
        let t97 = c4 * t67 + s4 * t63;
        let w4_z = dq4 - w3_y;
        let dw4_z = ddq4 - dw3_y;
        let t100 = w4_x * w4_x;
        let t101 = w4_z * w4_z;
        let t102 = w4_x * w4_y;
        let t103 = w4_x * w4_z;
        let t104 = w4_y * w4_z;
        let dw4_x = t97 + t104;
        let dw4_y = t94 - t103;
        let t107 = t100 - t101;
        let t108 = t107 - t65;
        let t109 = t102 - dw4_z;
        let t110 = dw4_z + t102;
        let t111 = t100 + t101;
        let t112 = t103 - dw4_y;
        let t113 = t104 + dw4_x;
        [
        t78, a4_x, a4_y, w4_x, w4_y, t94, t97, w4_z,
        dw4_z, t102, t103, t104, dw4_x, dw4_y, t107, t108,
        t109, t110, t111, t112, t113,
    ]
    };
    // link 5: motion
    let [
        a5_x, a5_y, w5_x, t125, t128, t131, w5_z, dw5_z,
        t136, t137, t138, dw5_x, dw5_y, t141, t142, t143,
        t144, t145, t146, t147,
    ] = {
        let a5_x = c5 * a4_x + s5 * t78;
        let a5_y = c5 * t78 - s5 * a4_x;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t125 = c5 * w4_z + s5 * w4_x;
        let t128 = c5 * t109 - s5 * t113;
        let t131 = c5 * t113 + s5 * t109;
        let w5_z = w4_y + dq5;
        let dw5_z = dw4_y + ddq5;
        let t134 = w5_x * w5_x;
        let t135 = w5_z * w5_z;
        let t136 = w5_x * t125;
        let t137 = w5_x * w5_z;
        let t138 = t125 * w5_z;
        let dw5_x = t131 - t138;
        let dw5_y = t128 - t137;
        let t141 = t134 - t135;
        let t142 = t141 - t111;
        let t143 = dw5_z + t136;
        let t144 = dw5_z - t136;
        let t145 = t134 + t135;
        let t146 = t137 - dw5_y;
        let t147 = dw5_x - t138;
        [
        a5_x, a5_y, w5_x, t125, t128, t131, w5_z, dw5_z,
        t136, t137, t138, dw5_x, dw5_y, t141, t142, t143,
        t144, t145, t146, t147,
    ]
    };
    // link 6: motion
    let [
        a6_x, a6_y, t162, t165, dw6_z, t170, t171, t172,
        dw6_x, dw6_y, t175, t176, t177, t178, t179, t180,
        t181,
    ] = {
        let a6_x = c6 * a5_x + s6 * a4_y;
        let a6_y = c6 * a4_y - s6 * a5_x;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t162 = c6 * t143 - s6 * t147;
        let t165 = c6 * t147 + s6 * t143;
        let w6_z = t125 + dq6;
        let dw6_z = ddq6 - dw5_y;
        let t168 = w6_x * w6_x;
        let t169 = w6_z * w6_z;
        let t170 = w6_x * w6_y;
        let t171 = w6_x * w6_z;
        let t172 = w6_y * w6_z;
        let dw6_x = t165 + t172;
        let dw6_y = t162 - t171;
        let t175 = t168 - t169;
        let t176 = t175 - t145;
        let t177 = t170 - dw6_z;
        let t178 = dw6_z + t170;
        let t179 = t168 + t169;
        let t180 = t171 - dw6_y;
        let t181 = t172 + dw6_x;
        [
        a6_x, a6_y, t162, t165, dw6_z, t170, t171, t172,
        dw6_x, dw6_y, t175, t176, t177, t178, t179, t180,
        t181,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t249, t252, t255, t258] = {
        let t203 = XZ6 * t165;
        let t204 = t172 * (ZZ6 - YY6) + XX6 * dw6_x - XY6 * t180 + XZ6 * t178;
        let t205 = t171 * (XX6 - ZZ6) + YY6 * dw6_y + XY6 * t181 - XZ6 * t175;
        let t206 = t170 * (YY6 - XX6) + ZZ6 * dw6_z + XY6 * (t176 + t179) + t203;
        let f6_x = M6 * a6_x + (MSZ6 * t162 + (MSX6 * t176 + MSY6 * t177));
        let f6_y = M6 * a6_y + (MSX6 * t178 - MSY6 * t179 - MSZ6 * t165);
        let f6_z = MSX6 * t180 + MSY6 * t181 - MSZ6 * t145 - M6 * a5_y;
        let n6_x = t204 + YZ6 * (t145 - t179) - (MSY6 * a5_y + MSZ6 * a6_y);
        let n6_y = t205 - YZ6 * t177 + (MSZ6 * a6_x + MSX6 * a5_y);
        let n6_z = t206 + YZ6 * t162 + (MSX6 * a6_y - MSY6 * a6_x);
        let t249 = c6 * f6_x - s6 * f6_y;
        let t252 = s6 * f6_x + c6 * f6_y;
        let t255 = c6 * n6_x - s6 * n6_y;
        let t258 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t249, t252, t255, t258]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t332, t335, t338, t341] = {
        let t280 = XZ5 * t131;
        let t281 = XX5 * dw5_x - t138 * (ZZ5 - YY5) - XY5 * t146 + XZ5 * t144;
        let t282 = t137 * (XX5 - ZZ5) + YY5 * dw5_y + XY5 * t147 - XZ5 * t141;
        let t283 = ZZ5 * dw5_z - t136 * (YY5 - XX5) + XY5 * (t142 + t145) + t280;
        let f5_x = t249 + (M5 * a5_x + (MSZ5 * t128 + (MSX5 * t142 - MSY5 * t143)));
        let f5_y = M5 * a5_y + (MSX5 * t144 - MSY5 * t145 - MSZ5 * t131) - f6_z;
        let f5_z = t252 + (M5 * a4_y + (MSX5 * t146 + MSY5 * t147 - MSZ5 * t111));
        let n5_x = t255 + (t281 + YZ5 * (t111 - t145) + (MSY5 * a4_y - MSZ5 * a5_y));
        let n5_y = t282 + YZ5 * t143 + (MSZ5 * a5_x - MSX5 * a4_y) - n6_z;
        let n5_z = t258 + (t283 + YZ5 * t128 + (MSX5 * a5_y - MSY5 * a5_x));
        let t332 = c5 * f5_x - s5 * f5_y;
        let t335 = s5 * f5_x + c5 * f5_y;
        let t338 = c5 * n5_x - s5 * n5_y;
        let t341 = s5 * n5_x + c5 * n5_y;
        [f5_z, n5_z, t332, t335, t338, t341]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t415, t418, t430, t431, t432] = {
        let t363 = XZ4 * t97;
        let t364 = t104 * (ZZ4 - YY4) + XX4 * dw4_x - XY4 * t112 + XZ4 * t110;
        let t365 = t103 * (XX4 - ZZ4) + YY4 * dw4_y + XY4 * t113 - XZ4 * t107;
        let t366 = t102 * (YY4 - XX4) + ZZ4 * dw4_z + XY4 * (t108 + t111) + t363;
        let f4_x = t332 + (M4 * a4_x + (MSZ4 * t94 + (MSX4 * t108 + MSY4 * t109)));
        let f4_y = f5_z + (M4 * a4_y + (MSX4 * t110 - MSY4 * t111 - MSZ4 * t97));
        let f4_z = MSX4 * t112 + MSY4 * t113 - MSZ4 * t65 - M4 * t78 - t335;
        let n4_x = t338 + (t364 + YZ4 * (t65 - t111) - (MSY4 * t78 + MSZ4 * a4_y));
        let n4_y = n5_z + (t365 - YZ4 * t109 + (MSZ4 * a4_x + MSX4 * t78));
        let n4_z = t366 + YZ4 * t94 + (MSX4 * a4_y - MSY4 * a4_x) - t341;
        let t415 = c4 * f4_x - s4 * f4_y;
        let t418 = s4 * f4_x + c4 * f4_y;
        let t430 = c4 * n4_x - s4 * n4_y - k_D4 * t418;
        let t431 = s4 * n4_x + c4 * n4_y + (k_D4 * t415 + k4 * f4_z);
        let t432 = n4_z - k4 * t418;
        [f4_z, n4_z, t415, t418, t430, t431, t432]
    };
    // link 3: force and moment
    let [t456, n3_z, t501, t504, t516, t517, t518] = {
        let t437 = t29 * (XY3 + XY3) - t26 * (XX3 - YY3);
        let t439 = t29 * t437 - XY3;
        let t442 = YZ3 * t29 - XZ3 * t26;
        let t455 = dw3_z * t442 + t55 * (XZ3 * t29 + YZ3 * t26);
        let t456 = YY3 * ddq1 - t51 * t437 + (t439 + t439) * (dq1 * w3_z) + t455;
        let f3_x = t415 + (M3 * a3_x + (MSZ3 * t50 + (MSX3 * t62 - MSY3 * t63)));
        let f3_y = M3 * a3_y + (MSZ3 * t51 + (MSX3 * t64 - MSY3 * t65)) - f4_z;
        let f3_z = t418 + (M3 * a3_z + (MSY3 * t67 - MSX3 * t66 - MSZ3 * t0));
        let n3_x = t430 + (MSY3 * a3_z - MSZ3 * a3_y);
        let n3_y = MSZ3 * a3_x - MSX3 * a3_z - t432;
        let t497 = t431 + (MSX3 * a3_y - MSY3 * a3_x);
        let n3_z = ZZ3 * dw3_z + ddq1 * t442 - t0 * t439 + t497;
        let t501 = c3 * f3_x - s3 * f3_y;
        let t504 = s3 * f3_x + c3 * f3_y;
        let t516 = c3 * n3_x - s3 * n3_y + k3 * t504;
        let t517 = s3 * n3_x + c3 * n3_y - (k3 * t501 + k_A2 * f3_z);
        let t518 = n3_z + k_A2 * t504;
        [t456, n3_z, t501, t504, t516, t517, t518]
    };
    // link 2: force and moment
    let [t548, n2_z, t585] = {
        let t523 = s2 * (XX2 - YY2) + c2 * (XY2 + XY2);
        let t525 = c2 * t523 - XY2;
        let t528 = s2 * XZ2 + c2 * YZ2;
        let t541 = t14 * (s2 * YZ2 - c2 * XZ2) - ddq2 * t528;
        let t542 = t11 * t523 + YY2 * ddq1 + (t525 + t525) * (dq1 * dq2) + t541;
        let t548 = t456 + t542;
        let f2_x = t501 + (MSX2 * t19 + MSY2 * t20 - MSZ2 * t12 - M2 * t6);
        let f2_y = t504 + (M2 * a2_y + (MSZ2 * t11 + (MSX2 * t21 - MSY2 * t22)));
        let n2_x = t516 - (MSY2 * t4 + MSZ2 * a2_y);
        let n2_y = t517 + (MSX2 * t4 - MSZ2 * t6);
        let t576 = t518 + (MSX2 * a2_y + MSY2 * t6);
        let n2_z = ZZ2 * ddq2 - ddq1 * t528 - t0 * t525 + t576;
        let t585 = s2 * n2_x + c2 * n2_y + k_D2 * (c2 * f2_x - s2 * f2_y);
        [t548, n2_z, t585]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t548 + (ZZ1 * ddq1 - t585);
        n1_z
    };
    // drives
    {
        let t615 = n1_z + IA1 * ddq1 + FV1 * dq1 + FC1 * dq1.sign();
        let t618 = n2_z + IA2 * ddq2 + FV2 * dq2 + FC2 * dq2.sign();
        let t621 = n3_z + IA3 * ddq3 + FV3 * dq3 + FC3 * dq3.sign();
        let t624 = n4_z + IA4 * ddq4 + FV4 * dq4 + FC4 * dq4.sign();
        let t627 = n5_z + IA5 * ddq5 + FV5 * dq5 + FC5 * dq5.sign();
        let t630 = n6_z + IA6 * ddq6 + FV6 * dq6 + FC6 * dq6.sign();
        put(0, t615);
        put(1, t618);
        put(2, t621);
        put(3, t624);
        put(4, t627);
        put(5, t630);
    }
}
