//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 235 multiplications, 204 additions; 6, 6 of 6 structurally nonzero.

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
        _, MSX2R, MSY2, XX2R, _, XY2, XZ2R, YZ2, MSX3R, MSY3R, XX3R, _,
        XY3R, XZ3, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        ..] = *beta;
    let k2 = S::constant(-constants::D3);
    let k3 = S::constant(-constants::A3);
    let k_A2 = S::constant(constants::A2);
    let k_D2 = S::constant(constants::D2);
    let k_D4 = S::constant(constants::D4);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [t1, t5, t6, t9, t10, t11] = {
        let t1 = k_D2 * t0;
        let t2 = s2 * dq1;
        let t4 = t2 * t2;
        let t5 = dq2 * dq2;
        let t6 = t2 * (c2 * dq1);
        let dw2_y = dq2 * t2;
        let t9 = t4 - t5 - t0;
        let t10 = t4 + t5;
        let t11 = dw2_y + dw2_y;
        [t1, t5, t6, t9, t10, t11]
    };
    // link 3: motion
    let [
        t14, t17, w3_z, a3_x, a3_y, a3_z, t31, w3_y,
        t34, t35, dw3_y, t39, t40, t41, t42,
    ] = {
        let t14 = s2 * c3 + c2 * s3;
        let t17 = s2 * s3 - c2 * c3;
        let w3_z = dq2 + dq3;
        let t19 = k_A2 * t9;
        let t20 = k_A2 * t6;
        let a3_x = c3 * t19 + s3 * t20;
        let a3_y = c3 * t20 - s3 * t19;
        let a3_z = t0 * k2 - k_A2 * t11 - t1;
        let t31 = dq1 * t14;
        let w3_y = dq1 * t17;
        let t33 = t31 * t31;
        let t34 = w3_z * w3_z;
        let t35 = t31 * w3_y;
        let dw3_y = w3_z * t31;
        let dw3_x = w3_z * w3_y;
        let t39 = t33 - t34 - t0;
        let t40 = t33 + t34;
        let t41 = dw3_y + dw3_y;
        let t42 = dw3_x + dw3_x;
        [
        t14, t17, w3_z, a3_x, a3_y, a3_z, t31, w3_y,
        t34, t35, dw3_y, t39, t40, t41, t42,
    ]
    };
    // link 4: motion
    let [
        t53, a4_x, a4_y, w4_x, w4_y, t69, t72, w4_z,
        t76, t77, t78, dw4_x, dw4_y, t81, t82, t83,
        t84, t85, t86, t87,
    ] = {
        let t52 = a3_x + (k_D4 * t35 - t39 * k3);
        let t53 = a3_y + (t35 * k3 + k_D4 * t40);
        let t54 = a3_z + (t41 * k3 - k_D4 * t42);
        let a4_x = c4 * t52 + s4 * t54;
        let a4_y = c4 * t54 - s4 * t52;
        let w4_x = s4 * w3_z - c4 * t31;
        let w4_y = c4 * w3_z + s4 * t31;
        let t69 = c4 * t35 - s4 * t42;
        let t72 = c4 * t42 + s4 * t35;
        let w4_z = dq4 - w3_y;
        let t74 = w4_x * w4_x;
        let t75 = w4_z * w4_z;
        let t76 = w4_x * w4_y;
        let t77 = w4_x * w4_z;
        let t78 = w4_y * w4_z;
        let dw4_x = t72 + t78;
        let dw4_y = t69 - t77;
        let t81 = t74 - t75;
        let t82 = t81 - t40;
        let t83 = dw3_y + t76;
        let t84 = t76 - dw3_y;
        let t85 = t74 + t75;
        let t86 = t77 - dw4_y;
        let t87 = t78 + dw4_x;
        [
        t53, a4_x, a4_y, w4_x, w4_y, t69, t72, w4_z,
        t76, t77, t78, dw4_x, dw4_y, t81, t82, t83,
        t84, t85, t86, t87,
    ]
    };
    // link 5: motion
    let [
        a5_x, a5_y, w5_x, t99, t102, t105, w5_z, t109,
        t110, t111, dw5_x, dw5_y, t114, t115, t116, t117,
        t118, t119, t120,
    ] = {
        let a5_x = c5 * a4_x + s5 * t53;
        let a5_y = c5 * t53 - s5 * a4_x;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t99 = c5 * w4_z + s5 * w4_x;
        let t102 = c5 * t83 - s5 * t87;
        let t105 = c5 * t87 + s5 * t83;
        let w5_z = w4_y + dq5;
        let t107 = w5_x * w5_x;
        let t108 = w5_z * w5_z;
        let t109 = w5_x * t99;
        let t110 = w5_x * w5_z;
        let t111 = t99 * w5_z;
        let dw5_x = t105 - t111;
        let dw5_y = t102 - t110;
        let t114 = t107 - t108;
        let t115 = t114 - t85;
        let t116 = dw4_y + t109;
        let t117 = dw4_y - t109;
        let t118 = t107 + t108;
        let t119 = t110 - dw5_y;
        let t120 = dw5_x - t111;
        [
        a5_x, a5_y, w5_x, t99, t102, t105, w5_z, t109,
        t110, t111, dw5_x, dw5_y, t114, t115, t116, t117,
        t118, t119, t120,
    ]
    };
    // link 6: motion
    let [
        a6_x, a6_y, t135, t138, t142, t143, t144, dw6_x,
        t147, t148, t149, t150, t151, t152, t153,
    ] = {
        let a6_x = c6 * a5_x + s6 * a4_y;
        let a6_y = c6 * a4_y - s6 * a5_x;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t135 = c6 * t116 - s6 * t120;
        let t138 = c6 * t120 + s6 * t116;
        let w6_z = t99 + dq6;
        let t140 = w6_x * w6_x;
        let t141 = w6_z * w6_z;
        let t142 = w6_x * w6_y;
        let t143 = w6_x * w6_z;
        let t144 = w6_y * w6_z;
        let dw6_x = t138 + t144;
        let dw6_y = t135 - t143;
        let t147 = t140 - t141;
        let t148 = t147 - t118;
        let t149 = dw5_y + t142;
        let t150 = t142 - dw5_y;
        let t151 = t140 + t141;
        let t152 = t143 - dw6_y;
        let t153 = t144 + dw6_x;
        [
        a6_x, a6_y, t135, t138, t142, t143, t144, dw6_x,
        t147, t148, t149, t150, t151, t152, t153,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t201, t204, t207, t210] = {
        let t174 = XY6 * (t148 + t151) - (XX6R * t142 + ZZ6 * dw5_y) + XZ6 * t138;
        let t176 = YZ6 * (t118 - t151);
        let t179 = ZZ6 * t144 + XX6R * dw6_x - XY6 * t152 + XZ6 * t150 + t176;
        let t180 = t143 * (XX6R - ZZ6) + XY6 * t153 - XZ6 * t147 - YZ6 * t149;
        let f6_x = MSX6 * t148 + MSY6 * t149;
        let f6_y = MSX6 * t150 - MSY6 * t151;
        let f6_z = MSX6 * t152 + MSY6 * t153;
        let n6_x = t179 - MSY6 * a5_y;
        let n6_y = t180 + MSX6 * a5_y;
        let n6_z = t174 + YZ6 * t135 + (MSX6 * a6_y - MSY6 * a6_x);
        let t201 = c6 * f6_x - s6 * f6_y;
        let t204 = s6 * f6_x + c6 * f6_y;
        let t207 = c6 * n6_x - s6 * n6_y;
        let t210 = s6 * n6_x + c6 * n6_y;
        put(5, n6_z);
        [f6_z, n6_z, t201, t204, t207, t210]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t264, t267, t270, t273] = {
        let t231 = XX5R * t109 + ZZ5R * dw4_y + XY5 * (t115 + t118) + XZ5 * t105;
        let t233 = YZ5 * (t85 - t118);
        let t236 = XX5R * dw5_x - ZZ5R * t111 - XY5 * t119 + XZ5 * t117 + t233;
        let t237 = t110 * (XX5R - ZZ5R) + XY5 * t120 - XZ5 * t114 + YZ5 * t116;
        let f5_x = t201 + (MSX5 * t115 - MSY5R * t116);
        let f5_y = MSX5 * t117 - MSY5R * t118 - f6_z;
        let f5_z = t204 + (MSX5 * t119 + MSY5R * t120);
        let n5_x = t207 + (t236 + MSY5R * a4_y);
        let n5_y = t237 - MSX5 * a4_y - n6_z;
        let n5_z = t210 + (t231 + YZ5 * t102 + (MSX5 * a5_y - MSY5R * a5_x));
        let t264 = c5 * f5_x - s5 * f5_y;
        let t267 = s5 * f5_x + c5 * f5_y;
        let t270 = c5 * n5_x - s5 * n5_y;
        let t273 = s5 * n5_x + c5 * n5_y;
        put(4, n5_z);
        [f5_z, n5_z, t264, t267, t270, t273]
    };
    // link 4: force and moment
    let [f4_z, t327, t330, t342, t343, t344] = {
        let t294 = XY4 * (t82 + t85) - (XX4R * t76 + ZZ4R * dw3_y) + XZ4 * t72;
        let t296 = YZ4 * (t40 - t85);
        let t299 = ZZ4R * t78 + XX4R * dw4_x - XY4 * t86 + XZ4 * t84 + t296;
        let t300 = t77 * (XX4R - ZZ4R) + XY4 * t87 - XZ4 * t81 - YZ4 * t83;
        let f4_x = t264 + (MSX4 * t82 + MSY4R * t83);
        let f4_y = f5_z + (MSX4 * t84 - MSY4R * t85);
        let f4_z = MSX4 * t86 + MSY4R * t87 - t267;
        let n4_x = t270 + (t299 - MSY4R * t53);
        let n4_y = n5_z + (t300 + MSX4 * t53);
        let n4_z = t294 + YZ4 * t69 + (MSX4 * a4_y - MSY4R * a4_x) - t273;
        let t327 = c4 * f4_x - s4 * f4_y;
        let t330 = s4 * f4_x + c4 * f4_y;
        let t342 = c4 * n4_x - s4 * n4_y - k_D4 * t330;
        let t343 = s4 * n4_x + c4 * n4_y + (k_D4 * t327 + k3 * f4_z);
        let t344 = n4_z - k3 * t330;
        put(3, n4_z);
        [f4_z, t327, t330, t342, t343, t344]
    };
    // link 3: force and moment
    let [t358, t383, t386, t398, t399, t400] = {
        let t350 = t17 * (t17 * (XY3R + XY3R) - XX3R * t14) - XY3R;
        let t358 = (t350 + t350) * (dq1 * w3_z) + t34 * (XZ3 * t17 + YZ3 * t14);
        let f3_x = t327 + (MSX3R * t39 - MSY3R * t35);
        let t375 = f4_z + (MSX3R * t35 + MSY3R * t40);
        let f3_z = t330 + (MSY3R * t42 - MSX3R * t41);
        let n3_x = t342 + MSY3R * a3_z;
        let t378 = t344 + MSX3R * a3_z;
        let n3_z = t343 + (MSX3R * a3_y - MSY3R * a3_x) - t0 * t350;
        let t383 = c3 * f3_x + s3 * t375;
        let t386 = s3 * f3_x - c3 * t375;
        let t398 = c3 * n3_x + s3 * t378 + k2 * t386;
        let t399 = s3 * n3_x - c3 * t378 - (k2 * t383 + k_A2 * f3_z);
        let t400 = n3_z + k_A2 * t386;
        put(2, n3_z);
        [t358, t383, t386, t398, t399, t400]
    };
    // link 2: force and moment
    let [t416, t437] = {
        let t406 = c2 * (s2 * XX2R + c2 * (XY2 + XY2)) - XY2;
        let t414 = (t406 + t406) * (dq1 * dq2) + t5 * (s2 * YZ2 - c2 * XZ2R);
        let t416 = t358 + t414;
        let f2_x = t383 + (MSX2R * t9 + MSY2 * t6);
        let f2_y = t386 + (MSX2R * t6 - MSY2 * t10);
        let n2_x = t398 - MSY2 * t1;
        let n2_y = t399 + MSX2R * t1;
        let n2_z = t400 - t0 * t406;
        let f1_x = c2 * f2_x - s2 * f2_y;
        let t437 = s2 * n2_x + c2 * n2_y + k_D2 * f1_x;
        put(1, n2_z);
        [t416, t437]
    };
    // link 1: force and moment
    {
        let n1_z = t416 - t437;
        put(0, n1_z);
    }
}
