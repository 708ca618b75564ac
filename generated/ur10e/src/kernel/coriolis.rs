//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 218 multiplications, 180 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, Trig, constants};

/// Coriolis and centrifugal torques `C dq`: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], out: &mut [S; 6]) {
    entries(trig, dq, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [
        _, _, _, XX2R, _, XY2, XZ2R, YZ2, MSX3R, MSY3, XX3R, _,
        XY3, XZ3R, YZ3, MSX4, MSY4R, XX4R, _, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        ..] = *beta;
    let k0 = S::constant(-constants::A2);
    let k1 = S::constant(-constants::A3);
    let k_D4 = S::constant(constants::D4);
    let k_D5 = S::constant(constants::D5);
    let k_D6 = S::constant(constants::D6);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [t4, t5, t8, t9] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t4 = dq2 * dq2;
        let t5 = w2_x * w2_y;
        let t6 = dq2 * w2_x;
        let t8 = w2_x * w2_x - t4 - t0;
        let t9 = t6 + t6;
        [t4, t5, t8, t9]
    };
    // link 3: motion
    let [
        t12, t15, w3_z, t19, t22, a3_y, t29, t30,
        t34, t35, t36, t37,
    ] = {
        let t12 = s2 * c3 + c2 * s3;
        let t15 = c2 * c3 - s2 * s3;
        let w3_z = dq2 + dq3;
        let t17 = t8 * k0;
        let t18 = t5 * k0;
        let t19 = t9 * k0;
        let t22 = c3 * t17 + s3 * t18;
        let a3_y = s3 * t17 - c3 * t18;
        let w3_x = dq1 * t12;
        let w3_y = dq1 * t15;
        let t28 = w3_x * w3_x;
        let t29 = w3_z * w3_z;
        let t30 = w3_x * w3_y;
        let t31 = w3_z * w3_x;
        let dw3_x = w3_z * w3_y;
        let t34 = t28 - t29 - t0;
        let t35 = t28 + t29;
        let t36 = t31 + t31;
        let t37 = dw3_x + dw3_x;
        [
        t12, t15, w3_z, t19, t22, a3_y, t29, t30,
        t34, t35, t36, t37,
    ]
    };
    // link 4: motion
    let [
        t40, t43, w4_z, a4_x, a4_y, t58, w4_x, w4_y,
        t62, t63, dw5_z, t67, t68, t69, t70,
    ] = {
        let t40 = c4 * t12 + s4 * t15;
        let t43 = c4 * t15 - s4 * t12;
        let w4_z = w3_z + dq4;
        let t48 = t22 + t34 * k1;
        let t49 = a3_y - t30 * k1;
        let a4_x = s4 * t49 - c4 * t48;
        let a4_y = c4 * t49 + s4 * t48;
        let t58 = t19 + (t36 * k1 + k_D4 * t0);
        let w4_x = dq1 * t40;
        let w4_y = dq1 * t43;
        let t61 = w4_x * w4_x;
        let t62 = w4_z * w4_z;
        let t63 = w4_x * w4_y;
        let dw5_z = w4_z * w4_x;
        let dw4_x = w4_z * w4_y;
        let t67 = t61 - t62 - t0;
        let t68 = t61 + t62;
        let t69 = dw5_z + dw5_z;
        let t70 = dw4_x + dw4_x;
        [
        t40, t43, w4_z, a4_x, a4_y, t58, w4_x, w4_y,
        t62, t63, dw5_z, t67, t68, t69, t70,
    ]
    };
    // link 5: motion
    let [
        t75, a5_x, t82, w5_x, w5_y, t91, t94, w5_z,
        t98, t99, t100, dw5_x, t102, t103, t104, t105,
        t106, t107, t108, t109,
    ] = {
        let t74 = a4_x - k_D5 * t63;
        let t75 = a4_y + k_D5 * t68;
        let t76 = t58 + k_D5 * t70;
        let a5_x = c5 * t74 - s5 * t76;
        let t82 = c5 * t76 + s5 * t74;
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t91 = c5 * t63 + s5 * t70;
        let t94 = s5 * t63 - c5 * t70;
        let w5_z = dq5 - w4_y;
        let t96 = w5_x * w5_x;
        let t97 = w5_z * w5_z;
        let t98 = w5_x * w5_y;
        let t99 = w5_x * w5_z;
        let t100 = w5_y * w5_z;
        let dw5_x = t100 - t94;
        let t102 = t91 + t99;
        let t103 = t96 - t97;
        let t104 = t103 - t68;
        let t105 = t98 - dw5_z;
        let t106 = dw5_z + t98;
        let t107 = t96 + t97;
        let t108 = t99 + t102;
        let t109 = t100 + dw5_x;
        [
        t75, a5_x, t82, w5_x, w5_y, t91, t94, w5_z,
        t98, t99, t100, dw5_x, t102, t103, t104, t105,
        t106, t107, t108, t109,
    ]
    };
    // link 6: motion
    let [
        t112, t115, t124, t127, t131, t132, t133, dw6_x,
        t136, t137, t138, t139, t140, t141, t142,
    ] = {
        let t112 = c6 * a5_x + s6 * t75;
        let t115 = c6 * t75 - s6 * a5_x;
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t121 = c6 * w5_z + s6 * w5_x;
        let t124 = c6 * t105 - s6 * t109;
        let t127 = c6 * t109 + s6 * t105;
        let w6_z = w5_y + dq6;
        let t129 = w6_x * w6_x;
        let t130 = w6_z * w6_z;
        let t131 = w6_x * t121;
        let t132 = w6_x * w6_z;
        let t133 = t121 * w6_z;
        let dw6_x = t127 - t133;
        let dw6_y = t124 - t132;
        let t136 = t129 - t130;
        let t137 = t136 - t107;
        let t138 = t102 - t131;
        let t139 = t102 + t131;
        let t140 = t129 + t130;
        let t141 = t132 - dw6_y;
        let t142 = dw6_x - t133;
        [
        t112, t115, t124, t127, t131, t132, t133, dw6_x,
        t136, t137, t138, t139, t140, t141, t142,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t194, t197, t200, t203] = {
        let t144 = XZ6 - k_D6 * MSX6;
        let t146 = YZ6 - k_D6 * MSY6;
        let t167 = XX6R * t131 - ZZ6 * t102 + XY6 * (t137 + t140) + t127 * t144;
        let t169 = t146 * (t107 - t140);
        let t172 = XX6R * dw6_x - ZZ6 * t133 - XY6 * t141 - t139 * t144 + t169;
        let t173 = t132 * (XX6R - ZZ6) + XY6 * t142 - t136 * t144 - t138 * t146;
        let f6_x = MSX6 * t137 + MSY6 * t138;
        let t180 = MSX6 * t139 + MSY6 * t140;
        let f6_z = MSX6 * t141 + MSY6 * t142;
        let n6_x = t172 - MSY6 * t82;
        let n6_y = t173 + MSX6 * t82;
        let n6_z = t167 + t124 * t146 + (MSX6 * t115 - MSY6 * t112);
        let t194 = c6 * f6_x + s6 * t180;
        let t197 = s6 * f6_x - c6 * t180;
        let t200 = c6 * n6_x - s6 * n6_y;
        let t203 = s6 * n6_x + c6 * n6_y;
        put(5, n6_z);
        [f6_z, n6_z, t194, t197, t200, t203]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t257, t260, t269, t270] = {
        let t224 = ZZ5R * dw5_z - XX5R * t98 + XY5 * (t104 + t107) - XZ5 * t94;
        let t226 = YZ5 * (t68 - t107);
        let t229 = ZZ5R * t100 + XX5R * dw5_x - XY5 * t108 + XZ5 * t106 + t226;
        let t230 = t99 * (XX5R - ZZ5R) + XY5 * t109 - XZ5 * t103 - YZ5 * t105;
        let f5_x = t194 + (MSX5 * t104 + MSY5R * t105);
        let f5_y = f6_z + (MSX5 * t106 - MSY5R * t107);
        let f5_z = MSX5 * t108 + MSY5R * t109 - t197;
        let n5_x = t200 + (t229 - MSY5R * t75);
        let n5_y = n6_z + (t230 + MSX5 * t75);
        let n5_z = t224 - YZ5 * t91 - (MSX5 * t82 + MSY5R * a5_x) - t203;
        let t257 = c5 * f5_x - s5 * f5_y;
        let t260 = s5 * f5_x + c5 * f5_y;
        let t269 = c5 * n5_x - s5 * n5_y - k_D5 * t260;
        let t270 = s5 * n5_x + c5 * n5_y + k_D5 * t257;
        put(4, n5_z);
        [f5_z, n5_z, t257, t260, t269, t270]
    };
    // link 4: force and moment
    let [t284, f4_z, t309, t312, t324, t325, t326] = {
        let t276 = t43 * (XX4R * t40 + t43 * (XY4 + XY4)) - XY4;
        let t284 = (t276 + t276) * (dq1 * w4_z) + t62 * (XZ4 * t43 - YZ4 * t40);
        let f4_x = t257 + (MSX4 * t67 + MSY4R * t63);
        let f4_y = MSX4 * t63 - MSY4R * t68 - f5_z;
        let f4_z = t260 + (MSX4 * t69 + MSY4R * t70);
        let n4_x = t269 - MSY4R * t58;
        let n4_y = MSX4 * t58 - n5_z;
        let n4_z = t270 + (MSX4 * a4_y - MSY4R * a4_x) - t0 * t276;
        let t309 = c4 * f4_x - s4 * f4_y;
        let t312 = s4 * f4_x + c4 * f4_y;
        let t324 = c4 * n4_x - s4 * n4_y - k_D4 * t312;
        let t325 = s4 * n4_x + c4 * n4_y + (k_D4 * t309 + k1 * f4_z);
        let t326 = n4_z - k1 * t312;
        put(3, n4_z);
        [t284, f4_z, t309, t312, t324, t325, t326]
    };
    // link 3: force and moment
    let [t342, n2_x, n2_y, t376] = {
        let t332 = t15 * (XX3R * t12 + t15 * (XY3 + XY3)) - XY3;
        let t340 = (t332 + t332) * (dq1 * w3_z) + t29 * (XZ3R * t15 - YZ3 * t12);
        let t342 = t284 + t340;
        let f3_x = t309 + (MSX3R * t34 + MSY3 * t30);
        let f3_y = t312 + (MSX3R * t30 - MSY3 * t35);
        let f3_z = f4_z + (MSX3R * t36 + MSY3 * t37);
        let n3_x = t324 - MSY3 * t19;
        let n3_y = t325 + MSX3R * t19;
        let n3_z = t326 + (MSX3R * a3_y + MSY3 * t22) - t0 * t332;
        let n2_x = c3 * n3_x - s3 * n3_y;
        let n2_y = s3 * n3_x + c3 * n3_y + k0 * f3_z;
        let t376 = n3_z - k0 * (s3 * f3_x + c3 * f3_y);
        put(2, n3_z);
        [t342, n2_x, n2_y, t376]
    };
    // link 2: force and moment
    let [t392, t396] = {
        let t382 = c2 * (s2 * XX2R + c2 * (XY2 + XY2)) - XY2;
        let t390 = (t382 + t382) * (dq1 * dq2) + t4 * (c2 * XZ2R - s2 * YZ2);
        let t392 = t342 + t390;
        let n2_z = t376 - t0 * t382;
        let t396 = s2 * n2_x + c2 * n2_y;
        put(1, n2_z);
        [t392, t396]
    };
    // link 1: force and moment
    {
        let n1_z = t392 + t396;
        put(0, n1_z);
    }
}
