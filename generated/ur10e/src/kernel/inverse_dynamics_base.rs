//! Torques from the base parameters.
//!
//! `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil and Dombre, 9.6.
//!
//! 266 multiplications, 261 additions; 6, 6 of 6 structurally nonzero.

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
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let [
        ZZ1R, MSX2R, MSY2, XX2R, ZZ2R, XY2, XZ2R, YZ2, MSX3R, MSY3, XX3R, ZZ3R,
        XY3, XZ3R, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        IA3, IA4, IA5, IA6, FV1, FV2, FV3, FV4, FV5, FV6, FC1, FC2,
        FC3, FC4, FC5, FC6, FO1, FO2, FO3, FO4, FO5, FO6,
        ..] = *beta;
    let D4 = S::constant(0.17415);
    let D5 = S::constant(0.11985);
    let D6 = S::constant(0.11655);
    let k0 = S::constant(9.81);
    let k1 = S::constant(0.6127);
    let k2 = S::constant(0.57155);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        w2_x, w2_y, t3, t4, a2_x, a2_y, t9, t10,
        t11, dw2_x, t14, t15, t16, t17, t18, t19,
        t20,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t3 = s2 * ddq1;
        let t4 = c2 * ddq1;
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let t7 = w2_x * w2_x;
        let t8 = dq2 * dq2;
        let t9 = w2_x * w2_y;
        let t10 = dq2 * w2_x;
        let t11 = dq2 * w2_y;
        let dw2_x = t3 + t11;
        let dw2_y = t4 - t10;
        let t14 = t7 - t8;
        let t15 = t14 - t0;
        let t16 = t9 - ddq2;
        let t17 = ddq2 + t9;
        let t18 = t7 + t8;
        let t19 = t10 - dw2_y;
        let t20 = t11 + dw2_x;
        [
        w2_x, w2_y, t3, t4, a2_x, a2_y, t9, t10,
        t11, dw2_x, t14, t15, t16, t17, t18, t19,
        t20,
    ]
    };
    // link 3: motion
    let [
        w3_x, w3_y, t29, a3_x, a3_y, t40, t43, w3_z,
        dw3_z, t48, t49, t50, dw3_x, t53, t54, t55,
        t56, t57, t58, t59,
    ] = {
        let w3_x = c3 * w2_x + s3 * w2_y;
        let w3_y = c3 * w2_y - s3 * w2_x;
        let t29 = t19 * k1;
        let t30 = a2_x - t15 * k1;
        let t31 = a2_y - t17 * k1;
        let a3_x = c3 * t30 + s3 * t31;
        let a3_y = c3 * t31 - s3 * t30;
        let t40 = c3 * t4 - s3 * t3;
        let t43 = c3 * t3 + s3 * t4;
        let w3_z = dq2 + dq3;
        let dw3_z = ddq2 + ddq3;
        let t46 = w3_x * w3_x;
        let t47 = w3_z * w3_z;
        let t48 = w3_x * w3_y;
        let t49 = w3_x * w3_z;
        let t50 = w3_y * w3_z;
        let dw3_x = t43 + t50;
        let dw3_y = t40 - t49;
        let t53 = t46 - t47;
        let t54 = t53 - t0;
        let t55 = t48 - dw3_z;
        let t56 = dw3_z + t48;
        let t57 = t46 + t47;
        let t58 = t49 - dw3_y;
        let t59 = t50 + dw3_x;
        [
        w3_x, w3_y, t29, a3_x, a3_y, t40, t43, w3_z,
        dw3_z, t48, t49, t50, dw3_x, t53, t54, t55,
        t56, t57, t58, t59,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t77, a4_x, a4_y, t86, t89, w4_z,
        dw4_z, t94, t95, t96, dw4_x, dw4_y, t99, t100,
        t101, t102, t103, t104, t105,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_y;
        let w4_y = c4 * w3_y - s4 * w3_x;
        let t75 = a3_x + (D4 * t40 - t54 * k2);
        let t76 = a3_y - (t56 * k2 + D4 * t43);
        let t77 = t29 + (t58 * k2 + D4 * t0);
        let a4_x = c4 * t75 + s4 * t76;
        let a4_y = c4 * t76 - s4 * t75;
        let t86 = c4 * t40 - s4 * t43;
        let t89 = c4 * t43 + s4 * t40;
        let w4_z = w3_z + dq4;
        let dw4_z = dw3_z + ddq4;
        let t92 = w4_x * w4_x;
        let t93 = w4_z * w4_z;
        let t94 = w4_x * w4_y;
        let t95 = w4_x * w4_z;
        let t96 = w4_y * w4_z;
        let dw4_x = t89 + t96;
        let dw4_y = t86 - t95;
        let t99 = t92 - t93;
        let t100 = t99 - t0;
        let t101 = t94 - dw4_z;
        let t102 = dw4_z + t94;
        let t103 = t92 + t93;
        let t104 = t95 - dw4_y;
        let t105 = t96 + dw4_x;
        [
        w4_x, w4_y, t77, a4_x, a4_y, t86, t89, w4_z,
        dw4_z, t94, t95, t96, dw4_x, dw4_y, t99, t100,
        t101, t102, t103, t104, t105,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t116, a5_x, t123, t126, t129, w5_z,
        dw5_z, t134, t135, t136, dw5_x, t138, t139, t140,
        t141, t142, t143, t144, t145,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t115 = a4_x - D5 * t101;
        let t116 = a4_y + D5 * t103;
        let t117 = t77 + D5 * t105;
        let a5_x = c5 * t115 - s5 * t117;
        let t123 = c5 * t117 + s5 * t115;
        let t126 = c5 * t101 + s5 * t105;
        let t129 = s5 * t101 - c5 * t105;
        let w5_z = dq5 - w4_y;
        let dw5_z = ddq5 - dw4_y;
        let t132 = w5_x * w5_x;
        let t133 = w5_z * w5_z;
        let t134 = w5_x * w5_y;
        let t135 = w5_x * w5_z;
        let t136 = w5_y * w5_z;
        let dw5_x = t136 - t129;
        let t138 = t126 + t135;
        let t139 = t132 - t133;
        let t140 = t139 - t103;
        let t141 = t134 - dw5_z;
        let t142 = dw5_z + t134;
        let t143 = t132 + t133;
        let t144 = t135 + t138;
        let t145 = t136 + dw5_x;
        [
        w5_x, w5_y, t116, a5_x, t123, t126, t129, w5_z,
        dw5_z, t134, t135, t136, dw5_x, t138, t139, t140,
        t141, t142, t143, t144, t145,
    ]
    };
    // link 6: motion
    let [
        t156, a6_x, t163, t166, t169, dw6_z, t174, t175,
        t176, dw6_x, t179, t180, t181, t182, t183, t184,
        t185,
    ] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t151 = c6 * w5_z + s6 * w5_x;
        let t155 = a5_x + D6 * t141;
        let t156 = t123 + D6 * t143;
        let t157 = D6 * t145 - t116;
        let a6_x = c6 * t155 - s6 * t157;
        let t163 = c6 * t157 + s6 * t155;
        let t166 = c6 * t141 - s6 * t145;
        let t169 = c6 * t145 + s6 * t141;
        let w6_z = w5_y + dq6;
        let dw6_z = ddq6 - t138;
        let t172 = w6_x * w6_x;
        let t173 = w6_z * w6_z;
        let t174 = w6_x * t151;
        let t175 = w6_x * w6_z;
        let t176 = t151 * w6_z;
        let dw6_x = t169 - t176;
        let dw6_y = t166 - t175;
        let t179 = t172 - t173;
        let t180 = t179 - t143;
        let t181 = dw6_z + t174;
        let t182 = dw6_z - t174;
        let t183 = t172 + t173;
        let t184 = t175 - dw6_y;
        let t185 = dw6_x - t176;
        [
        t156, a6_x, t163, t166, t169, dw6_z, t174, t175,
        t176, dw6_x, t179, t180, t181, t182, t183, t184,
        t185,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t233, t236, t245, t246] = {
        let t206 = XX6R * t174 + ZZ6 * dw6_z + XY6 * (t180 + t183) + XZ6 * t169;
        let t208 = YZ6 * (t143 - t183);
        let t211 = XX6R * dw6_x - ZZ6 * t176 - XY6 * t184 + XZ6 * t182 + t208;
        let t212 = t175 * (XX6R - ZZ6) + XY6 * t185 - XZ6 * t179 + YZ6 * t181;
        let f6_x = MSX6 * t180 - MSY6 * t181;
        let f6_y = MSX6 * t182 - MSY6 * t183;
        let f6_z = MSX6 * t184 + MSY6 * t185;
        let n6_x = t211 - MSY6 * t156;
        let n6_y = t212 + MSX6 * t156;
        let n6_z = t206 + YZ6 * t166 - (MSX6 * t163 + MSY6 * a6_x);
        let t233 = c6 * f6_x - s6 * f6_y;
        let t236 = s6 * f6_x + c6 * f6_y;
        let t245 = c6 * n6_x - s6 * n6_y - D6 * t236;
        let t246 = s6 * n6_x + c6 * n6_y + D6 * t233;
        [f6_z, n6_z, t233, t236, t245, t246]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t300, t303, t312, t313] = {
        let t267 = ZZ5R * dw5_z - XX5R * t134 + XY5 * (t140 + t143) - XZ5 * t129;
        let t269 = YZ5 * (t103 - t143);
        let t272 = ZZ5R * t136 + XX5R * dw5_x - XY5 * t144 + XZ5 * t142 + t269;
        let t273 = t135 * (XX5R - ZZ5R) + XY5 * t145 - XZ5 * t139 - YZ5 * t141;
        let f5_x = t233 + (MSX5 * t140 + MSY5R * t141);
        let f5_y = f6_z + (MSX5 * t142 - MSY5R * t143);
        let f5_z = MSX5 * t144 + MSY5R * t145 - t236;
        let n5_x = t245 + (t272 - MSY5R * t116);
        let n5_y = n6_z + (t273 + MSX5 * t116);
        let n5_z = t267 - YZ5 * t126 - (MSX5 * t123 + MSY5R * a5_x) - t246;
        let t300 = c5 * f5_x - s5 * f5_y;
        let t303 = s5 * f5_x + c5 * f5_y;
        let t312 = c5 * n5_x - s5 * n5_y - D5 * t303;
        let t313 = s5 * n5_x + c5 * n5_y + D5 * t300;
        [f5_z, n5_z, t300, t303, t312, t313]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t367, t370, t382, t383, t384] = {
        let t334 = ZZ4R * dw4_z - XX4R * t94 + XY4 * (t100 + t103) + XZ4 * t89;
        let t336 = YZ4 * (t0 - t103);
        let t339 = ZZ4R * t96 + XX4R * dw4_x - XY4 * t104 + XZ4 * t102 + t336;
        let t340 = t95 * (XX4R - ZZ4R) + XY4 * t105 - XZ4 * t99 - YZ4 * t101;
        let f4_x = t300 + (MSX4 * t100 + MSY4R * t101);
        let f4_y = MSX4 * t102 - MSY4R * t103 - f5_z;
        let f4_z = t303 + (MSX4 * t104 + MSY4R * t105);
        let n4_x = t312 + (t339 - MSY4R * t77);
        let n4_y = t340 + MSX4 * t77 - n5_z;
        let n4_z = t313 + (t334 + YZ4 * t86 + (MSX4 * a4_y - MSY4R * a4_x));
        let t367 = c4 * f4_x - s4 * f4_y;
        let t370 = s4 * f4_x + c4 * f4_y;
        let t382 = c4 * n4_x - s4 * n4_y - D4 * t370;
        let t383 = s4 * n4_x + c4 * n4_y + (D4 * t367 + k2 * f4_z);
        let t384 = n4_z - k2 * t370;
        [f4_z, n4_z, t367, t370, t382, t383, t384]
    };
    // link 3: force and moment
    let [n3_z, t441, t447, t448] = {
        let t405 = ZZ3R * dw3_z - XX3R * t48 + XY3 * (t54 + t57) + XZ3R * t43;
        let t407 = YZ3 * (t0 - t57);
        let t410 = ZZ3R * t50 + XX3R * dw3_x - XY3 * t58 + XZ3R * t56 + t407;
        let t411 = t49 * (XX3R - ZZ3R) + XY3 * t59 - XZ3R * t53 - YZ3 * t55;
        let f3_x = t367 + (MSX3R * t54 + MSY3 * t55);
        let f3_y = t370 + (MSX3R * t56 - MSY3 * t57);
        let f3_z = f4_z + (MSX3R * t58 + MSY3 * t59);
        let n3_x = t382 + (t410 - MSY3 * t29);
        let n3_y = t383 + (t411 + MSX3R * t29);
        let n3_z = t384 + (t405 + YZ3 * t40 + (MSX3R * a3_y - MSY3 * a3_x));
        let t441 = c3 * n3_x - s3 * n3_y;
        let t447 = s3 * n3_x + c3 * n3_y + k1 * f3_z;
        let t448 = n3_z - k1 * (s3 * f3_x + c3 * f3_y);
        [n3_z, t441, t447, t448]
    };
    // link 2: force and moment
    let [n2_z, t486] = {
        let t469 = ZZ2R * ddq2 - XX2R * t9 + XY2 * (t15 + t18) + XZ2R * t3;
        let t471 = YZ2 * (t0 - t18);
        let t474 = ZZ2R * t11 + XX2R * dw2_x - XY2 * t19 + XZ2R * t17 + t471;
        let t475 = t10 * (XX2R - ZZ2R) + XY2 * t20 - XZ2R * t14 - YZ2 * t16;
        let n2_x = t441 + t474;
        let n2_y = t447 + t475;
        let n2_z = t448 + (t469 + YZ2 * t4 + (MSX2R * a2_y - MSY2 * a2_x));
        let t486 = s2 * n2_x + c2 * n2_y;
        [n2_z, t486]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t486 + ZZ1R * ddq1;
        n1_z
    };
    // drives
    {
        let t527 = FO1 + (n1_z + FV1 * dq1 + FC1 * dq1.sign());
        let t528 = FO2 + (n2_z + FV2 * dq2 + FC2 * dq2.sign());
        let t529 = FO3 + (n3_z + IA3 * ddq3 + FV3 * dq3 + FC3 * dq3.sign());
        let t530 = FO4 + (n4_z + IA4 * ddq4 + FV4 * dq4 + FC4 * dq4.sign());
        let t531 = FO5 + (n5_z + IA5 * ddq5 + FV5 * dq5 + FC5 * dq5.sign());
        let t532 = FO6 + (n6_z + IA6 * ddq6 + FV6 * dq6 + FC6 * dq6.sign());
        put(0, t527);
        put(1, t528);
        put(2, t529);
        put(3, t530);
        put(4, t531);
        put(5, t532);
    }
}
