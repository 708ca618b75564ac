//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 221 multiplications, 203 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, Trig};

/// Coriolis and centrifugal torques `C dq`: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], out: &mut [S; 6]) {
    entries(trig, dq, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [
        _, _, _, XX2R, ZZ2R, XY2, XZ2R, YZ2, MSX3R, MSY3, XX3R, ZZ3R,
        XY3, XZ3R, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        ..] = *beta;
    let D4 = S::constant(0.17415);
    let D5 = S::constant(0.11985);
    let D6 = S::constant(0.11655);
    let k0 = S::constant(0.6127);
    let k1 = S::constant(0.57155);
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
        w3_x, w3_y, t21, t24, a3_y, w3_z, t31, t32,
        dw3_x, t34, t35, t36, t37, t38,
    ] = {
        let w3_x = c3 * w2_x + s3 * w2_y;
        let w3_y = c3 * w2_y - s3 * w2_x;
        let t19 = t9 * k0;
        let t20 = t5 * k0;
        let t21 = t11 * k0;
        let t24 = c3 * t19 + s3 * t20;
        let a3_y = s3 * t19 - c3 * t20;
        let w3_z = dq2 + dq3;
        let t29 = w3_x * w3_x;
        let t30 = w3_z * w3_z;
        let t31 = w3_x * w3_y;
        let t32 = w3_x * w3_z;
        let dw3_x = w3_y * w3_z;
        let t34 = t29 - t30;
        let t35 = t34 - t0;
        let t36 = t29 + t30;
        let t37 = t32 + t32;
        let t38 = dw3_x + dw3_x;
        [
        w3_x, w3_y, t21, t24, a3_y, w3_z, t31, t32,
        dw3_x, t34, t35, t36, t37, t38,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, a4_x, a4_y, t58, w4_z, t62, dw5_z,
        dw4_x, t65, t66, t67, t68, t69,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_y;
        let w4_y = c4 * w3_y - s4 * w3_x;
        let t48 = t24 + t35 * k1;
        let t49 = a3_y - t31 * k1;
        let a4_x = s4 * t49 - c4 * t48;
        let a4_y = c4 * t49 + s4 * t48;
        let t58 = t21 + (t37 * k1 + D4 * t0);
        let w4_z = w3_z + dq4;
        let t60 = w4_x * w4_x;
        let t61 = w4_z * w4_z;
        let t62 = w4_x * w4_y;
        let dw5_z = w4_x * w4_z;
        let dw4_x = w4_y * w4_z;
        let t65 = t60 - t61;
        let t66 = t65 - t0;
        let t67 = t60 + t61;
        let t68 = dw5_z + dw5_z;
        let t69 = dw4_x + dw4_x;
        [
        w4_x, w4_y, a4_x, a4_y, t58, w4_z, t62, dw5_z,
        dw4_x, t65, t66, t67, t68, t69,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t80, a5_x, t87, t90, t93, w5_z,
        t97, t98, t99, dw5_x, t101, t102, t103, t104,
        t105, t106, t107, t108,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t79 = a4_x - D5 * t62;
        let t80 = a4_y + D5 * t67;
        let t81 = t58 + D5 * t69;
        let a5_x = c5 * t79 - s5 * t81;
        let t87 = c5 * t81 + s5 * t79;
        let t90 = c5 * t62 + s5 * t69;
        let t93 = s5 * t62 - c5 * t69;
        let w5_z = dq5 - w4_y;
        let t95 = w5_x * w5_x;
        let t96 = w5_z * w5_z;
        let t97 = w5_x * w5_y;
        let t98 = w5_x * w5_z;
        let t99 = w5_y * w5_z;
        let dw5_x = t99 - t93;
        let t101 = t90 + t98;
        let t102 = t95 - t96;
        let t103 = t102 - t67;
        let t104 = t97 - dw5_z;
        let t105 = dw5_z + t97;
        let t106 = t95 + t96;
        let t107 = t98 + t101;
        let t108 = t99 + dw5_x;
        [
        w5_x, w5_y, t80, a5_x, t87, t90, t93, w5_z,
        t97, t98, t99, dw5_x, t101, t102, t103, t104,
        t105, t106, t107, t108,
    ]
    };
    // link 6: motion
    let [
        t119, a6_x, t126, t129, t132, t136, t137, t138,
        dw6_x, t141, t142, t143, t144, t145, t146, t147,
    ] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t114 = c6 * w5_z + s6 * w5_x;
        let t118 = a5_x + D6 * t104;
        let t119 = t87 + D6 * t106;
        let t120 = D6 * t108 - t80;
        let a6_x = c6 * t118 - s6 * t120;
        let t126 = c6 * t120 + s6 * t118;
        let t129 = c6 * t104 - s6 * t108;
        let t132 = c6 * t108 + s6 * t104;
        let w6_z = w5_y + dq6;
        let t134 = w6_x * w6_x;
        let t135 = w6_z * w6_z;
        let t136 = w6_x * t114;
        let t137 = w6_x * w6_z;
        let t138 = t114 * w6_z;
        let dw6_x = t132 - t138;
        let dw6_y = t129 - t137;
        let t141 = t134 - t135;
        let t142 = t141 - t106;
        let t143 = t101 - t136;
        let t144 = t101 + t136;
        let t145 = t134 + t135;
        let t146 = t137 - dw6_y;
        let t147 = dw6_x - t138;
        [
        t119, a6_x, t126, t129, t132, t136, t137, t138,
        dw6_x, t141, t142, t143, t144, t145, t146, t147,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t195, t198, t207, t208] = {
        let t168 = XX6R * t136 - ZZ6 * t101 + XY6 * (t142 + t145) + XZ6 * t132;
        let t170 = YZ6 * (t106 - t145);
        let t173 = XX6R * dw6_x - ZZ6 * t138 - XY6 * t146 - XZ6 * t144 + t170;
        let t174 = t137 * (XX6R - ZZ6) + XY6 * t147 - XZ6 * t141 - YZ6 * t143;
        let f6_x = MSX6 * t142 + MSY6 * t143;
        let t181 = MSX6 * t144 + MSY6 * t145;
        let f6_z = MSX6 * t146 + MSY6 * t147;
        let n6_x = t173 - MSY6 * t119;
        let n6_y = t174 + MSX6 * t119;
        let n6_z = t168 + YZ6 * t129 - (MSX6 * t126 + MSY6 * a6_x);
        let t195 = c6 * f6_x + s6 * t181;
        let t198 = s6 * f6_x - c6 * t181;
        let t207 = c6 * n6_x - s6 * n6_y - D6 * t198;
        let t208 = s6 * n6_x + c6 * n6_y + D6 * t195;
        put(5, n6_z);
        [f6_z, n6_z, t195, t198, t207, t208]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t262, t265, t274, t275] = {
        let t229 = ZZ5R * dw5_z - XX5R * t97 + XY5 * (t103 + t106) - XZ5 * t93;
        let t231 = YZ5 * (t67 - t106);
        let t234 = ZZ5R * t99 + XX5R * dw5_x - XY5 * t107 + XZ5 * t105 + t231;
        let t235 = t98 * (XX5R - ZZ5R) + XY5 * t108 - XZ5 * t102 - YZ5 * t104;
        let f5_x = t195 + (MSX5 * t103 + MSY5R * t104);
        let f5_y = f6_z + (MSX5 * t105 - MSY5R * t106);
        let f5_z = MSX5 * t107 + MSY5R * t108 - t198;
        let n5_x = t207 + (t234 - MSY5R * t80);
        let n5_y = n6_z + (t235 + MSX5 * t80);
        let n5_z = t229 - YZ5 * t90 - (MSX5 * t87 + MSY5R * a5_x) - t208;
        let t262 = c5 * f5_x - s5 * f5_y;
        let t265 = s5 * f5_x + c5 * f5_y;
        let t274 = c5 * n5_x - s5 * n5_y - D5 * t265;
        let t275 = s5 * n5_x + c5 * n5_y + D5 * t262;
        put(4, n5_z);
        [f5_z, n5_z, t262, t265, t274, t275]
    };
    // link 4: force and moment
    let [f4_z, t322, t325, t337, t338, t339] = {
        let t293 = YZ4 * (t0 - t67);
        let t296 = dw5_z * (XX4R - ZZ4R) + XY4 * t69 - XZ4 * t65 - YZ4 * t62;
        let t306 = MSY4R * t58;
        let t311 = dw4_x * (XX4R + ZZ4R) - XY4 * t68 + XZ4 * t62 + t293 - t306;
        let t313 = XY4 * (t66 + t67) - XX4R * t62 + (MSX4 * a4_y - MSY4R * a4_x);
        let f4_x = t262 + (MSX4 * t66 + MSY4R * t62);
        let f4_y = MSX4 * t62 - MSY4R * t67 - f5_z;
        let f4_z = t265 + (MSX4 * t68 + MSY4R * t69);
        let n4_x = t274 + t311;
        let n4_y = t296 + MSX4 * t58 - n5_z;
        let n4_z = t275 + t313;
        let t322 = c4 * f4_x - s4 * f4_y;
        let t325 = s4 * f4_x + c4 * f4_y;
        let t337 = c4 * n4_x - s4 * n4_y - D4 * t325;
        let t338 = s4 * n4_x + c4 * n4_y + (D4 * t322 + k1 * f4_z);
        let t339 = n4_z - k1 * t325;
        put(3, n4_z);
        [f4_z, t322, t325, t337, t338, t339]
    };
    // link 3: force and moment
    let [t389, t395, t396] = {
        let t357 = YZ3 * (t0 - t36);
        let t360 = t32 * (XX3R - ZZ3R) + XY3 * t38 - XZ3R * t34 - YZ3 * t31;
        let t370 = MSY3 * t21;
        let t375 = dw3_x * (XX3R + ZZ3R) - XY3 * t37 + XZ3R * t31 + t357 - t370;
        let t377 = XY3 * (t35 + t36) - XX3R * t31 + (MSX3R * a3_y + MSY3 * t24);
        let f3_x = t322 + (MSX3R * t35 + MSY3 * t31);
        let f3_y = t325 + (MSX3R * t31 - MSY3 * t36);
        let f3_z = f4_z + (MSX3R * t37 + MSY3 * t38);
        let n3_x = t337 + t375;
        let n3_y = t338 + (t360 + MSX3R * t21);
        let n3_z = t339 + t377;
        let t389 = c3 * n3_x - s3 * n3_y;
        let t395 = s3 * n3_x + c3 * n3_y + k0 * f3_z;
        let t396 = n3_z - k0 * (s3 * f3_x + c3 * f3_y);
        put(2, n3_z);
        [t389, t395, t396]
    };
    // link 2: force and moment
    {
        let t414 = YZ2 * (t0 - t10);
        let t417 = t6 * (XX2R - ZZ2R) + XY2 * t12 - XZ2R * t8 - YZ2 * t5;
        let n2_x = t389 + (dw2_x * (XX2R + ZZ2R) - XY2 * t11 + XZ2R * t5 + t414);
        let n2_y = t395 + t417;
        let n2_z = t396 + (XY2 * (t9 + t10) - XX2R * t5);
        let n1_z = s2 * n2_x + c2 * n2_y;
        put(0, n1_z);
        put(1, n2_z);
    }
}
