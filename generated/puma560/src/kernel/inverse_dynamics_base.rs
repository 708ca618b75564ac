//! Torques from the base parameters.
//!
//! `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil
//! and Dombre, 9.6.
//!
//! 277 multiplications, 250 additions; 6, 6 of 6 structurally nonzero.

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
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let [
        ZZ1R, MSX2R, MSY2, XX2R, ZZ2R, XY2, XZ2R, YZ2, MSX3R, MSY3R, XX3R, ZZ3R,
        XY3R, XZ3, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        IA3, IA4, IA5, IA6, FV1, FV2, FV3, FV4, FV5, FV6, FC1, FC2,
        FC3, FC4, FC5, FC6,
        ..] = *beta;
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
        t26, t29, w3_z, dw3_z, a3_z, a3_x, a3_y, t51,
        t52, w3_y, t55, dw3_y, t62, t63, t64, t65,
        t66, t67,
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
        let t51 = ddq1 * t26;
        let t52 = dq1 * t26;
        let w3_y = dq1 * t29;
        let t54 = t52 * t52;
        let t55 = w3_z * w3_z;
        let t56 = t52 * w3_y;
        let t57 = w3_z * t52;
        let t58 = w3_z * w3_y;
        let dw3_x = t58 - t51;
        let dw3_y = ddq1 * t29 + t57;
        let t62 = t54 - t55 - t0;
        let t63 = dw3_z + t56;
        let t64 = dw3_z - t56;
        let t65 = t54 + t55;
        let t66 = t57 + dw3_y;
        let t67 = t58 + dw3_x;
        [
        t26, t29, w3_z, dw3_z, a3_z, a3_x, a3_y, t51,
        t52, w3_y, t55, dw3_y, t62, t63, t64, t65,
        t66, t67,
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
        dw6_x, t175, t176, t177, t178, t179, t180, t181,
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
        dw6_x, t175, t176, t177, t178, t179, t180, t181,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t229, t232, t235, t238] = {
        let t202 = ZZ6 * dw6_z - XX6R * t170 + XY6 * (t176 + t179) + XZ6 * t165;
        let t204 = YZ6 * (t145 - t179);
        let t207 = ZZ6 * t172 + XX6R * dw6_x - XY6 * t180 + XZ6 * t178 + t204;
        let t208 = t171 * (XX6R - ZZ6) + XY6 * t181 - XZ6 * t175 - YZ6 * t177;
        let f6_x = MSX6 * t176 + MSY6 * t177;
        let f6_y = MSX6 * t178 - MSY6 * t179;
        let f6_z = MSX6 * t180 + MSY6 * t181;
        let n6_x = t207 - MSY6 * a5_y;
        let n6_y = t208 + MSX6 * a5_y;
        let n6_z = t202 + YZ6 * t162 + (MSX6 * a6_y - MSY6 * a6_x);
        let t229 = c6 * f6_x - s6 * f6_y;
        let t232 = s6 * f6_x + c6 * f6_y;
        let t235 = c6 * n6_x - s6 * n6_y;
        let t238 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t229, t232, t235, t238]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t292, t295, t298, t301] = {
        let t259 = XX5R * t136 + ZZ5R * dw5_z + XY5 * (t142 + t145) + XZ5 * t131;
        let t261 = YZ5 * (t111 - t145);
        let t264 = XX5R * dw5_x - ZZ5R * t138 - XY5 * t146 + XZ5 * t144 + t261;
        let t265 = t137 * (XX5R - ZZ5R) + XY5 * t147 - XZ5 * t141 + YZ5 * t143;
        let f5_x = t229 + (MSX5 * t142 - MSY5R * t143);
        let f5_y = MSX5 * t144 - MSY5R * t145 - f6_z;
        let f5_z = t232 + (MSX5 * t146 + MSY5R * t147);
        let n5_x = t235 + (t264 + MSY5R * a4_y);
        let n5_y = t265 - MSX5 * a4_y - n6_z;
        let n5_z = t238 + (t259 + YZ5 * t128 + (MSX5 * a5_y - MSY5R * a5_x));
        let t292 = c5 * f5_x - s5 * f5_y;
        let t295 = s5 * f5_x + c5 * f5_y;
        let t298 = c5 * n5_x - s5 * n5_y;
        let t301 = s5 * n5_x + c5 * n5_y;
        [f5_z, n5_z, t292, t295, t298, t301]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t355, t358, t370, t371, t372] = {
        let t322 = ZZ4R * dw4_z - XX4R * t102 + XY4 * (t108 + t111) + XZ4 * t97;
        let t324 = YZ4 * (t65 - t111);
        let t327 = ZZ4R * t104 + XX4R * dw4_x - XY4 * t112 + XZ4 * t110 + t324;
        let t328 = t103 * (XX4R - ZZ4R) + XY4 * t113 - XZ4 * t107 - YZ4 * t109;
        let f4_x = t292 + (MSX4 * t108 + MSY4R * t109);
        let f4_y = f5_z + (MSX4 * t110 - MSY4R * t111);
        let f4_z = MSX4 * t112 + MSY4R * t113 - t295;
        let n4_x = t298 + (t327 - MSY4R * t78);
        let n4_y = n5_z + (t328 + MSX4 * t78);
        let n4_z = t322 + YZ4 * t94 + (MSX4 * a4_y - MSY4R * a4_x) - t301;
        let t355 = c4 * f4_x - s4 * f4_y;
        let t358 = s4 * f4_x + c4 * f4_y;
        let t370 = c4 * n4_x - s4 * n4_y - k_D4 * t358;
        let t371 = s4 * n4_x + c4 * n4_y + (k_D4 * t355 + k4 * f4_z);
        let t372 = n4_z - k4 * t358;
        [f4_z, n4_z, t355, t358, t370, t371, t372]
    };
    // link 3: force and moment
    let [t393, n3_z, t422, t425, t437, t438, t439] = {
        let t376 = t29 * (XY3R + XY3R) - XX3R * t26;
        let t378 = t29 * t376 - XY3R;
        let t381 = YZ3 * t29 - XZ3 * t26;
        let t392 = dw3_z * t381 + t55 * (XZ3 * t29 + YZ3 * t26);
        let t393 = (t378 + t378) * (dq1 * w3_z) - t51 * t376 + t392;
        let f3_x = t355 + (MSX3R * t62 - MSY3R * t63);
        let f3_y = MSX3R * t64 - MSY3R * t65 - f4_z;
        let f3_z = t358 + (MSY3R * t67 - MSX3R * t66);
        let n3_x = t370 + MSY3R * a3_z;
        let t417 = t372 + MSX3R * a3_z;
        let t418 = t371 + (MSX3R * a3_y - MSY3R * a3_x);
        let n3_z = ZZ3R * dw3_z + ddq1 * t381 - t0 * t378 + t418;
        let t422 = c3 * f3_x - s3 * f3_y;
        let t425 = s3 * f3_x + c3 * f3_y;
        let t437 = c3 * n3_x + s3 * t417 + k3 * t425;
        let t438 = s3 * n3_x - c3 * t417 - (k3 * t422 + k_A2 * f3_z);
        let t439 = n3_z + k_A2 * t425;
        [t393, n3_z, t422, t425, t437, t438, t439]
    };
    // link 2: force and moment
    let [t466, n2_z, t491] = {
        let t443 = s2 * XX2R + c2 * (XY2 + XY2);
        let t445 = c2 * t443 - XY2;
        let t448 = s2 * XZ2R + c2 * YZ2;
        let t459 = t14 * (s2 * YZ2 - c2 * XZ2R) - ddq2 * t448;
        let t466 = t393 + (t11 * t443 + (t445 + t445) * (dq1 * dq2) + t459);
        let f2_x = t422 + (MSX2R * t19 + MSY2 * t20);
        let f2_y = t425 + (MSX2R * t21 - MSY2 * t22);
        let n2_x = t437 - MSY2 * t4;
        let n2_y = t438 + MSX2R * t4;
        let t482 = t439 + (MSX2R * a2_y + MSY2 * t6);
        let n2_z = ZZ2R * ddq2 - ddq1 * t448 - t0 * t445 + t482;
        let f1_x = c2 * f2_x - s2 * f2_y;
        let t491 = s2 * n2_x + c2 * n2_y + k_D2 * f1_x;
        [t466, n2_z, t491]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t466 + (ZZ1R * ddq1 - t491);
        n1_z
    };
    // drives
    {
        let t517 = n1_z + FV1 * dq1 + FC1 * dq1.sign();
        let t520 = n2_z + FV2 * dq2 + FC2 * dq2.sign();
        let t523 = n3_z + IA3 * ddq3 + FV3 * dq3 + FC3 * dq3.sign();
        let t526 = n4_z + IA4 * ddq4 + FV4 * dq4 + FC4 * dq4.sign();
        let t529 = n5_z + IA5 * ddq5 + FV5 * dq5 + FC5 * dq5.sign();
        let t532 = n6_z + IA6 * ddq6 + FV6 * dq6 + FC6 * dq6.sign();
        put(0, t517);
        put(1, t520);
        put(2, t523);
        put(3, t526);
        put(4, t529);
        put(5, t532);
    }
}
