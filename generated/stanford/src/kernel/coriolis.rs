//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 209 multiplications, 192 additions; 6, 6 of 6 structurally nonzero.

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
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [
        _, MSX2, MSZ2, YY2R, ZZ2R, XY2R, XZ2R, YZ2R, M3R, MSX3, MSY3, MSZ3R,
        MSX4, MSZ4R, YY4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSZ5R, YY5R, ZZ5R, XY5,
        XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        ..] = *beta;
    let D2 = S::constant(0.154);
    let D6 = S::constant(0.263);
    let k1 = S::constant(2.0);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        t1, w3_z, t3, t4, t5, t6, dw2_y, t8,
        t9, t10, t11,
    ] = {
        let t1 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t3 = D2 * t0;
        let t4 = t1 * t1;
        let t5 = dq2 * dq2;
        let t6 = t1 * w3_z;
        let dw2_y = dq2 * t1;
        let t8 = dq2 * w3_z;
        let t9 = t4 + t5;
        let t10 = dw2_y + dw2_y;
        let t11 = t8 + t8;
        [
        t1, w3_z, t3, t4, t5, t6, dw2_y, t8,
        t9, t10, t11,
    ]
    };
    // link 3: motion
    let [t13, t19, a3_y, t22, t23] = {
        let t13 = q3 * t9;
        let t16 = dq3 * k1;
        let t19 = t3 - q3 * t11 - t1 * t16;
        let a3_y = dq2 * t16 - q3 * t6;
        let t21 = w3_z * w3_z;
        let t22 = t4 + t21;
        let t23 = t5 + t21;
        [t13, t19, a3_y, t22, t23]
    };
    // link 4: motion
    let [
        t26, w4_y, a4_x, a4_y, t38, t41, w4_z, t43,
        t44, t45, t46, t47, t49, t50, t51, t52,
        t53, t54,
    ] = {
        let t26 = c4 * dq2 + s4 * t1;
        let w4_y = s4 * dq2 - c4 * t1;
        let a4_x = c4 * t19 + s4 * a3_y;
        let a4_y = c4 * a3_y - s4 * t19;
        let t38 = c4 * t11 + s4 * t6;
        let t41 = c4 * t6 - s4 * t11;
        let w4_z = w3_z + dq4;
        let t43 = t26 * t26;
        let t44 = w4_z * w4_z;
        let t45 = t26 * w4_y;
        let t46 = t26 * w4_z;
        let t47 = w4_y * w4_z;
        let dw4_x = t41 + t47;
        let t49 = t38 - t46;
        let t50 = t45 - dw2_y;
        let t51 = dw2_y + t45;
        let t52 = t43 + t44;
        let t53 = t49 - t46;
        let t54 = t47 + dw4_x;
        [
        t26, w4_y, a4_x, a4_y, t38, t41, w4_z, t43,
        t44, t45, t46, t47, t49, t50, t51, t52,
        t53, t54,
    ]
    };
    // link 5: motion
    let [
        t57, w5_y, a5_x, a5_y, t69, t72, w5_z, t74,
        t75, t76, t77, t78, t80, t81, t82, t83,
        t84, t85,
    ] = {
        let t57 = c5 * t26 + s5 * w4_z;
        let w5_y = s5 * t26 - c5 * w4_z;
        let a5_x = c5 * a4_x + s5 * t13;
        let a5_y = c5 * t13 - s5 * a4_x;
        let t69 = c5 * t50 + s5 * t54;
        let t72 = s5 * t50 - c5 * t54;
        let w5_z = w4_y + dq5;
        let t74 = t57 * t57;
        let t75 = w5_z * w5_z;
        let t76 = t57 * w5_y;
        let t77 = t57 * w5_z;
        let t78 = w5_y * w5_z;
        let t80 = t69 - t77;
        let t81 = t76 - t49;
        let t82 = t49 + t76;
        let t83 = t74 + t75;
        let t84 = t77 - t80;
        let t85 = t78 - (t72 - t78);
        [
        t57, w5_y, a5_x, a5_y, t69, t72, w5_z, t74,
        t75, t76, t77, t78, t80, t81, t82, t83,
        t84, t85,
    ]
    };
    // link 6: motion
    let [
        t96, a6_x, a6_y, t106, t109, t113, t114, t115,
        dw6_x, t118, t119, t120, t121, t122, t123, t124,
    ] = {
        let w6_x = s6 * w5_z - c6 * t57;
        let w6_y = c6 * w5_z + s6 * t57;
        let t95 = a5_x + D6 * t81;
        let t96 = a5_y + D6 * t83;
        let t97 = a4_y - D6 * t85;
        let a6_x = c6 * t95 + s6 * t97;
        let a6_y = c6 * t97 - s6 * t95;
        let t106 = c6 * t81 - s6 * t85;
        let t109 = c6 * t85 + s6 * t81;
        let w6_z = dq6 - w5_y;
        let t111 = w6_x * w6_x;
        let t112 = w6_z * w6_z;
        let t113 = w6_x * w6_y;
        let t114 = w6_x * w6_z;
        let t115 = w6_y * w6_z;
        let dw6_x = t109 + t115;
        let t118 = t112 - t111;
        let t119 = t83 + t118;
        let t120 = t113 - t80;
        let t121 = t80 + t113;
        let t122 = t111 + t112;
        let t123 = t114 + (t114 - t106);
        let t124 = t115 + dw6_x;
        [
        t96, a6_x, a6_y, t106, t109, t113, t114, t115,
        dw6_x, t118, t119, t120, t121, t122, t123, t124,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t172, t175, t184, t185] = {
        let t143 = ZZ6 * t115 + XX6R * dw6_x - XY6 * t123 + XZ6 * t121;
        let t145 = ZZ6 * t80 - XX6R * t113 + XY6 * (t122 - t119) + XZ6 * t109;
        let t151 = t114 * (XX6R - ZZ6) + XY6 * t124 + XZ6 * t118 - YZ6 * t120;
        let t155 = MSX6 * t119 - MSY6 * t120;
        let f6_y = MSX6 * t121 - MSY6 * t122;
        let f6_z = MSX6 * t123 + MSY6 * t124;
        let t167 = YZ6 * (t122 - t83) - t143 + MSY6 * t96;
        let n6_y = t151 + MSX6 * t96;
        let n6_z = t145 + YZ6 * t106 + (MSX6 * a6_y - MSY6 * a6_x);
        let t172 = c6 * t155 + s6 * f6_y;
        let t175 = s6 * t155 - c6 * f6_y;
        let t184 = D6 * t175 - (c6 * t167 + s6 * n6_y);
        let t185 = c6 * n6_y - s6 * t167 - D6 * t172;
        put(5, n6_z);
        [f6_z, n6_z, t172, t175, t184, t185]
    };
    // link 5: force and moment
    let [t237, n5_z, t243, t246, t249, t252] = {
        let t186 = w5_y * w5_y;
        let t187 = t75 + t186;
        let t188 = t74 + t186;
        let t209 = XZ5 * (t187 - t83) - (ZZ5R * t76 + YY5R * t49 + XY5 * t72);
        let t210 = YY5R * t77 - ZZ5R * t80 + XY5 * (t187 - t188) - XZ5 * t85;
        let t212 = YZ5 * (t83 - t188);
        let t227 = MSZ5R * a4_y;
        let t232 = XZ5 * t84 - (t78 * (YY5R - ZZ5R) - XY5 * t82) - t212 + t227;
        let t235 = t172 - (MSZ5R * t81 - MSX5 * t187);
        let f5_y = MSZ5R * t83 - MSX5 * t82 - f6_z;
        let t237 = t175 + (MSX5 * t84 + MSZ5R * t85);
        let n5_x = t184 - t232;
        let t239 = n6_z + (MSX5 * a4_y - (t210 - YZ5 * t81));
        let n5_z = t185 + (t209 + YZ5 * t69 + (MSZ5R * a5_x + MSX5 * a5_y));
        let t243 = c5 * t235 + s5 * f5_y;
        let t246 = c5 * f5_y - s5 * t235;
        let t249 = c5 * n5_x + s5 * t239;
        let t252 = c5 * t239 - s5 * n5_x;
        put(4, n5_z);
        [t237, n5_z, t243, t246, t249, t252]
    };
    // link 4: force and moment
    let [t304, n4_z, t310, t313, t316, t319] = {
        let t253 = w4_y * w4_y;
        let t254 = t44 + t253;
        let t255 = t43 + t253;
        let t276 = ZZ4R * t45 + YY4R * dw2_y + XY4 * t41 + XZ4 * (t254 - t52);
        let t277 = XZ4 * t54 - (XY4 * (t254 - t255) - (YY4R * t46 - ZZ4R * t49));
        let t279 = YZ4 * (t255 - t52);
        let t294 = MSZ4R * t13;
        let t299 = t47 * (YY4R - ZZ4R) + XY4 * t51 - XZ4 * t53 - t279 - t294;
        let t302 = t243 + (MSX4 * t254 + MSZ4R * t50);
        let t303 = t237 + (MSX4 * t51 + MSZ4R * t52);
        let t304 = MSX4 * t53 + MSZ4R * t54 - t246;
        let n4_x = t249 + t299;
        let n4_y = n5_z + (t277 - YZ4 * t50 + MSX4 * t13);
        let n4_z = t252 + (MSX4 * a4_y - MSZ4R * a4_x - (t276 - YZ4 * t38));
        let t310 = s4 * t303 - c4 * t302;
        let t313 = s4 * t302 + c4 * t303;
        let t316 = c4 * n4_x - s4 * n4_y;
        let t319 = s4 * n4_x + c4 * n4_y;
        put(3, n4_z);
        [t304, n4_z, t310, t313, t316, t319]
    };
    // link 3: force and moment
    let [t320, t321, t322, t350, f3_z, n3_z, t357, t358] = {
        let t320 = t23 - t22;
        let t321 = t9 - t22;
        let t322 = t23 - t9;
        let t349 = MSZ3R * t11 - (MSY3 * t10 - MSX3 * t22) - M3R * t19 - t310;
        let t350 = t313 + (MSY3 * t23 + MSZ3R * t6 - M3R * a3_y);
        let f3_z = t304 - (M3R * t13 + (MSY3 * t6 + MSZ3R * t9));
        let n3_x = t316 - (MSY3 * t13 + MSZ3R * a3_y);
        let n3_y = t319 + (MSZ3R * t19 + MSX3 * t13);
        let n3_z = n4_z + (MSX3 * a3_y - MSY3 * t19);
        let t357 = q3 * t349 - n3_y;
        let t358 = n3_x + q3 * t350;
        put(2, f3_z);
        [t320, t321, t322, t350, f3_z, n3_z, t357, t358]
    };
    // link 2: force and moment
    {
        let t376 = t8 * (ZZ2R - YY2R) + XY2R * t6 - XZ2R * t10 + YZ2R * t321;
        let t377 = dw2_y * (YY2R + ZZ2R) + XY2R * t320 + XZ2R * t11 + YZ2R * t6;
        let n2_z = ZZ2R * t6 + XZ2R * t322 - t358;
        let t393 = c2 * (t350 + (MSX2 * t23 + MSZ2 * t6));
        let f1_x = s2 * (f3_z - (MSX2 * t6 + MSZ2 * t9)) - t393;
        let t397 = c2 * (n3_z - (t377 + MSX2 * t3));
        let n1_z = s2 * (t357 - (t376 + MSZ2 * t3)) + t397 - D2 * f1_x;
        put(0, n1_z);
        put(1, n2_z);
    }
}
