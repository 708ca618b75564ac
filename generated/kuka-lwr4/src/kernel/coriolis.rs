//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 271 multiplications, 253 additions; 7, 7 of 7 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, Trig};

/// Coriolis and centrifugal torques `C dq`: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], out: &mut [S; 7]) {
    entries(trig, dq, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let [
        _, _, _, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3, MSY3R, XX3R, ZZ3R,
        XY3, XZ3, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6R, XX6R, ZZ6R, XY6, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7,
        ..] = *beta;
    let L2 = S::constant(0.4);
    let L3 = S::constant(0.39);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        w2_x, w2_y, t5, t6, dw2_x, t8, t9, t10,
        t11, t12,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t3 = w2_x * w2_x;
        let t4 = dq2 * dq2;
        let t5 = w2_x * w2_y;
        let t6 = dq2 * w2_x;
        let dw2_x = dq2 * w2_y;
        let t8 = t3 - t4;
        let t9 = t8 - t0;
        let t10 = t3 + t4;
        let t11 = t6 + t6;
        let t12 = dw2_x + dw2_x;
        [
        w2_x, w2_y, t5, t6, dw2_x, t8, t9, t10,
        t11, t12,
    ]
    };
    // link 3: motion
    let [
        w3_x, t18, t20, a3_x, t27, t30, t33, w3_z,
        t37, t38, t39, dw3_x, dw3_y, t42, t43, t44,
        t45, t46, t47, t48,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t18 = c3 * dq2 + s3 * w2_x;
        let t19 = L2 * t5;
        let t20 = L2 * t10;
        let t21 = L2 * t12;
        let a3_x = c3 * t19 - s3 * t21;
        let t27 = c3 * t21 + s3 * t19;
        let t30 = c3 * t5 - s3 * t12;
        let t33 = c3 * t12 + s3 * t5;
        let w3_z = w2_y + dq3;
        let t35 = w3_x * w3_x;
        let t36 = w3_z * w3_z;
        let t37 = w3_x * t18;
        let t38 = w3_x * w3_z;
        let t39 = t18 * w3_z;
        let dw3_x = t33 - t39;
        let dw3_y = t30 - t38;
        let t42 = t35 - t36;
        let t43 = t42 - t10;
        let t44 = t6 - t37;
        let t45 = t6 + t37;
        let t46 = t35 + t36;
        let t47 = t38 - dw3_y;
        let t48 = dw3_x - t39;
        [
        w3_x, t18, t20, a3_x, t27, t30, t33, w3_z,
        t37, t38, t39, dw3_x, dw3_y, t42, t43, t44,
        t45, t46, t47, t48,
    ]
    };
    // link 4: motion
    let [
        w4_x, t54, a4_x, a4_y, t63, t66, w4_z, t70,
        t71, t72, dw4_x, dw4_y, t75, t76, t77, t78,
        t79, t80, t81,
    ] = {
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t54 = c4 * w3_z + s4 * w3_x;
        let a4_x = c4 * a3_x + s4 * t20;
        let a4_y = c4 * t20 - s4 * a3_x;
        let t63 = c4 * t44 - s4 * t48;
        let t66 = c4 * t48 + s4 * t44;
        let w4_z = dq4 - t18;
        let t68 = w4_x * w4_x;
        let t69 = w4_z * w4_z;
        let t70 = w4_x * t54;
        let t71 = w4_x * w4_z;
        let t72 = t54 * w4_z;
        let dw4_x = t66 - t72;
        let dw4_y = t63 - t71;
        let t75 = t68 - t69;
        let t76 = t75 - t46;
        let t77 = dw3_y + t70;
        let t78 = dw3_y - t70;
        let t79 = t68 + t69;
        let t80 = t71 - dw4_y;
        let t81 = dw4_x - t72;
        [
        w4_x, t54, a4_x, a4_y, t63, t66, w4_z, t70,
        t71, t72, dw4_x, dw4_y, t75, t76, t77, t78,
        t79, t80, t81,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t92, a5_x, a6_z, t102, t105, w5_z,
        t109, t110, t111, dw5_x, dw5_y, t114, t115, t116,
        t117, t118, t119, t120,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t91 = a4_x + L3 * t77;
        let t92 = a4_y + L3 * t79;
        let t93 = t27 + L3 * t81;
        let a5_x = c5 * t91 - s5 * t93;
        let a6_z = c5 * t93 + s5 * t91;
        let t102 = c5 * t77 - s5 * t81;
        let t105 = c5 * t81 + s5 * t77;
        let w5_z = t54 + dq5;
        let t107 = w5_x * w5_x;
        let t108 = w5_z * w5_z;
        let t109 = w5_x * w5_y;
        let t110 = w5_x * w5_z;
        let t111 = w5_y * w5_z;
        let dw5_x = t105 + t111;
        let dw5_y = t102 - t110;
        let t114 = t107 - t108;
        let t115 = t114 - t79;
        let t116 = dw4_y + t109;
        let t117 = t109 - dw4_y;
        let t118 = t107 + t108;
        let t119 = t110 - dw5_y;
        let t120 = t111 + dw5_x;
        [
        w5_x, w5_y, t92, a5_x, a6_z, t102, t105, w5_z,
        t109, t110, t111, dw5_x, dw5_y, t114, t115, t116,
        t117, t118, t119, t120,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, a6_x, t132, t135, t138, w6_z, t142,
        t143, t144, dw6_x, t146, t147, t148, t149, t150,
        t151, t152, t153,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let a6_x = c6 * a5_x - s6 * t92;
        let t132 = c6 * t92 + s6 * a5_x;
        let t135 = c6 * t116 + s6 * t120;
        let t138 = s6 * t116 - c6 * t120;
        let w6_z = dq6 - w5_y;
        let t140 = w6_x * w6_x;
        let t141 = w6_z * w6_z;
        let t142 = w6_x * w6_y;
        let t143 = w6_x * w6_z;
        let t144 = w6_y * w6_z;
        let dw6_x = t144 - t138;
        let t146 = t135 + t143;
        let t147 = t140 - t141;
        let t148 = t147 - t118;
        let t149 = dw5_y + t142;
        let t150 = t142 - dw5_y;
        let t151 = t140 + t141;
        let t152 = t143 + t146;
        let t153 = t144 + dw6_x;
        [
        w6_x, w6_y, a6_x, t132, t135, t138, w6_z, t142,
        t143, t144, dw6_x, t146, t147, t148, t149, t150,
        t151, t152, t153,
    ]
    };
    // link 7: motion
    let [
        a7_x, t165, t168, t171, t175, t176, t177, dw7_x,
        t180, t181, t182, t183, t184, t185, t186,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t159 = c7 * w6_z + s7 * w6_x;
        let a7_x = c7 * a6_x - s7 * a6_z;
        let t165 = c7 * a6_z + s7 * a6_x;
        let t168 = c7 * t149 - s7 * t153;
        let t171 = c7 * t153 + s7 * t149;
        let w7_z = w6_y + dq7;
        let t173 = w7_x * w7_x;
        let t174 = w7_z * w7_z;
        let t175 = w7_x * t159;
        let t176 = w7_x * w7_z;
        let t177 = t159 * w7_z;
        let dw7_x = t171 - t177;
        let dw7_y = t168 - t176;
        let t180 = t173 - t174;
        let t181 = t180 - t151;
        let t182 = t146 - t175;
        let t183 = t146 + t175;
        let t184 = t173 + t174;
        let t185 = t176 - dw7_y;
        let t186 = dw7_x - t177;
        [
        a7_x, t165, t168, t171, t175, t176, t177, dw7_x,
        t180, t181, t182, t183, t184, t185, t186,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t234, t237, t240, t243] = {
        let t207 = XX7R * t175 - ZZ7 * t146 + XY7 * (t181 + t184) + XZ7 * t171;
        let t209 = YZ7 * (t151 - t184);
        let t212 = XX7R * dw7_x - ZZ7 * t177 - XY7 * t185 - XZ7 * t183 + t209;
        let t213 = t176 * (XX7R - ZZ7) + XY7 * t186 - XZ7 * t180 - YZ7 * t182;
        let f7_x = MSX7 * t181 + MSY7 * t182;
        let t220 = MSX7 * t183 + MSY7 * t184;
        let f7_z = MSX7 * t185 + MSY7 * t186;
        let n7_x = t212 - MSY7 * t132;
        let n7_y = t213 + MSX7 * t132;
        let n7_z = t207 + YZ7 * t168 - (MSX7 * t165 + MSY7 * a7_x);
        let t234 = c7 * f7_x + s7 * t220;
        let t237 = s7 * f7_x - c7 * t220;
        let t240 = c7 * n7_x - s7 * n7_y;
        let t243 = s7 * n7_x + c7 * n7_y;
        put(6, n7_z);
        [f7_z, n7_z, t234, t237, t240, t243]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t297, t300, t303, t306] = {
        let t264 = XY6 * (t148 + t151) - (XX6R * t142 + ZZ6R * dw5_y) - XZ6 * t138;
        let t266 = YZ6 * (t118 - t151);
        let t269 = ZZ6R * t144 + XX6R * dw6_x - XY6 * t152 + XZ6 * t150 + t266;
        let t270 = t143 * (XX6R - ZZ6R) + XY6 * t153 - XZ6 * t147 - YZ6 * t149;
        let f6_x = t234 + (MSX6 * t148 + MSY6R * t149);
        let f6_y = f7_z + (MSX6 * t150 - MSY6R * t151);
        let f6_z = MSX6 * t152 + MSY6R * t153 - t237;
        let n6_x = t240 + (t269 + MSY6R * a6_z);
        let n6_y = n7_z + (t270 - MSX6 * a6_z);
        let n6_z = t264 - YZ6 * t135 - (MSX6 * t132 + MSY6R * a6_x) - t243;
        let t297 = c6 * f6_x - s6 * f6_y;
        let t300 = s6 * f6_x + c6 * f6_y;
        let t303 = c6 * n6_x - s6 * n6_y;
        let t306 = s6 * n6_x + c6 * n6_y;
        put(5, n6_z);
        [f6_z, n6_z, t297, t300, t303, t306]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t360, t363, t372, t373] = {
        let t327 = XY5 * (t115 + t118) - (XX5R * t109 + ZZ5R * dw4_y) + XZ5 * t105;
        let t329 = YZ5 * (t79 - t118);
        let t332 = ZZ5R * t111 + XX5R * dw5_x - XY5 * t119 + XZ5 * t117 + t329;
        let t333 = t110 * (XX5R - ZZ5R) + XY5 * t120 - XZ5 * t114 - YZ5 * t116;
        let f5_x = t297 + (MSX5 * t115 + MSY5R * t116);
        let f5_y = MSX5 * t117 - MSY5R * t118 - f6_z;
        let f5_z = t300 + (MSX5 * t119 + MSY5R * t120);
        let n5_x = t303 + (t332 - MSY5R * t92);
        let n5_y = t333 + MSX5 * t92 - n6_z;
        let n5_z = t306 + (t327 + YZ5 * t102 - (MSX5 * a6_z + MSY5R * a5_x));
        let t360 = c5 * f5_x - s5 * f5_y;
        let t363 = s5 * f5_x + c5 * f5_y;
        let t372 = c5 * n5_x - s5 * n5_y - L3 * t363;
        let t373 = s5 * n5_x + c5 * n5_y + L3 * t360;
        put(4, n5_z);
        [f5_z, n5_z, t360, t363, t372, t373]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t427, t430, t433] = {
        let t394 = XX4R * t70 + ZZ4R * dw3_y + XY4 * (t76 + t79) + XZ4 * t66;
        let t396 = YZ4 * (t46 - t79);
        let t399 = XX4R * dw4_x - ZZ4R * t72 - XY4 * t80 + XZ4 * t78 + t396;
        let t400 = t71 * (XX4R - ZZ4R) + XY4 * t81 - XZ4 * t75 + YZ4 * t77;
        let f4_x = t360 + (MSX4 * t76 - MSY4R * t77);
        let f4_y = MSX4 * t78 - MSY4R * t79 - f5_z;
        let f4_z = t363 + (MSX4 * t80 + MSY4R * t81);
        let n4_x = t372 + (t399 - MSY4R * t27);
        let n4_y = t400 + MSX4 * t27 - n5_z;
        let n4_z = t373 + (t394 + YZ4 * t63 + (MSX4 * a4_y - MSY4R * a4_x));
        let t427 = c4 * f4_x - s4 * f4_y;
        let t430 = c4 * n4_x - s4 * n4_y;
        let t433 = s4 * n4_x + c4 * n4_y;
        put(3, n4_z);
        [f4_z, n4_z, t427, t430, t433]
    };
    // link 3: force and moment
    let [n3_z, t495, t496] = {
        let t454 = XX3R * t37 - ZZ3R * t6 + XY3 * (t43 + t46) + XZ3 * t33;
        let t456 = YZ3 * (t10 - t46);
        let t459 = XX3R * dw3_x - ZZ3R * t39 - XY3 * t47 - XZ3 * t45 + t456;
        let t460 = t38 * (XX3R - ZZ3R) + XY3 * t48 - XZ3 * t42 - YZ3 * t44;
        let f3_x = t427 + (MSX3 * t43 + MSY3R * t44);
        let f3_y = f4_z - (MSX3 * t45 + MSY3R * t46);
        let n3_x = t430 + (t459 - MSY3R * t20);
        let n3_y = n4_z + (t460 + MSX3 * t20);
        let n3_z = t454 + YZ3 * t30 - (MSX3 * t27 + MSY3R * a3_x) - t433;
        let t495 = c3 * n3_x - s3 * n3_y - L2 * (s3 * f3_x + c3 * f3_y);
        let t496 = s3 * n3_x + c3 * n3_y + L2 * (c3 * f3_x - s3 * f3_y);
        put(2, n3_z);
        [n3_z, t495, t496]
    };
    // link 2: force and moment
    {
        let t514 = YZ2 * (t0 - t10);
        let t517 = t6 * (XX2R - ZZ2R) + XY2 * t12 - XZ2 * t8 - YZ2 * t5;
        let n2_x = t495 + (dw2_x * (XX2R + ZZ2R) - XY2 * t11 + XZ2 * t5 + t514);
        let n2_y = n3_z + t517;
        let n2_z = XY2 * (t9 + t10) - XX2R * t5 - t496;
        let n1_z = s2 * n2_x + c2 * n2_y;
        put(0, n1_z);
        put(1, n2_z);
    }
}
