//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 214 multiplications, 194 additions; 6, 6 of 6 structurally nonzero.

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
    // link 2: motion
    let [t0, w3_z, t3, t4, dw2_y] = {
        let t0 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t3 = D2 * (dq1 * dq1);
        let t4 = dq2 * w3_z;
        let dw2_y = dq2 * t0;
        [t0, w3_z, t3, t4, dw2_y]
    };
    // link 3: motion
    let [
        t6, t7, t8, t9, t10, t11, t12, t13,
        t14, t16, t22, a3_y,
    ] = {
        let t6 = t0 * t0;
        let t7 = w3_z * w3_z;
        let t8 = dq2 * dq2;
        let t9 = t0 * w3_z;
        let t10 = t7 + t8;
        let t11 = t6 + t8;
        let t12 = dw2_y + dw2_y;
        let t13 = t4 + t4;
        let t14 = t6 + t7;
        let t16 = q3 * t11;
        let t19 = dq3 * k1;
        let t22 = q3 * t13 - t3 + t0 * t19;
        let a3_y = dq2 * t19 - q3 * t9;
        [
        t6, t7, t8, t9, t10, t11, t12, t13,
        t14, t16, t22, a3_y,
    ]
    };
    // link 4: motion
    let [t26, w4_y, a4_x, a4_y, w4_z, dw4_x, dw4_y] = {
        let t26 = c4 * dq2 + s4 * t0;
        let w4_y = s4 * dq2 - c4 * t0;
        let a4_x = s4 * a3_y - c4 * t22;
        let a4_y = c4 * a3_y + s4 * t22;
        let w4_z = w3_z + dq4;
        let dw4_x = dq4 * w4_y - s4 * t4;
        let dw4_y = dq4 * t26 - c4 * t4;
        [t26, w4_y, a4_x, a4_y, w4_z, dw4_x, dw4_y]
    };
    // link 5: motion
    let [
        t45, t48, t55, t56, t57, t58, t59, t60,
        t61, t62, t63, t64, t65, t66, t67, t68,
        a5_x, a5_y, w5_z, t78, dw5_y,
    ] = {
        let t45 = c5 * t26 + s5 * w4_z;
        let t48 = c5 * w4_z - s5 * t26;
        let t55 = t26 * t26;
        let t56 = w4_y * w4_y;
        let t57 = w4_z * w4_z;
        let t58 = t26 * w4_y;
        let t59 = t26 * w4_z;
        let t60 = w4_y * w4_z;
        let t61 = t56 + t57;
        let t62 = dw2_y - t58;
        let t63 = dw4_y - t59;
        let t64 = dw2_y + t58;
        let t65 = t55 + t57;
        let t66 = t60 - dw4_x;
        let t67 = dw4_y + t59;
        let t68 = dw4_x + t60;
        let a5_x = c5 * a4_x + s5 * t16;
        let a5_y = c5 * t16 - s5 * a4_x;
        let w5_z = w4_y + dq5;
        let t78 = dq5 * t48 - (c5 * dw4_x + s5 * dw2_y);
        let dw5_y = c5 * dw2_y - s5 * dw4_x + dq5 * t45;
        [
        t45, t48, t55, t56, t57, t58, t59, t60,
        t61, t62, t63, t64, t65, t66, t67, t68,
        a5_x, a5_y, w5_z, t78, dw5_y,
    ]
    };
    // link 6: motion
    let [
        t82, w6_y, t92, t93, t94, t95, t96, t97,
        t98, t99, t100, t101, t102, t103, t104, t105,
        t110, t114, a6_y, w6_z, dw6_x, dw6_y,
    ] = {
        let t82 = c6 * t45 - s6 * w5_z;
        let w6_y = c6 * w5_z + s6 * t45;
        let t92 = t45 * t45;
        let t93 = t48 * t48;
        let t94 = w5_z * w5_z;
        let t95 = t45 * t48;
        let t96 = t45 * w5_z;
        let t97 = t48 * w5_z;
        let t98 = t93 + t94;
        let t99 = t95 - dw4_y;
        let t100 = dw5_y - t96;
        let t101 = dw4_y + t95;
        let t102 = t92 + t94;
        let t103 = t97 - t78;
        let t104 = dw5_y + t96;
        let t105 = t78 + t97;
        let t109 = D6 * t99 - a5_x;
        let t110 = a5_y + D6 * t102;
        let t111 = a4_y + D6 * t105;
        let t114 = c6 * t109 - s6 * t111;
        let a6_y = c6 * t111 + s6 * t109;
        let w6_z = t48 + dq6;
        let dw6_x = s6 * dw4_y - c6 * t78 + dq6 * w6_y;
        let dw6_y = c6 * dw4_y + s6 * t78 + dq6 * t82;
        [
        t82, w6_y, t92, t93, t94, t95, t96, t97,
        t98, t99, t100, t101, t102, t103, t104, t105,
        t110, t114, a6_y, w6_z, dw6_x, dw6_y,
    ]
    };
    // link 6: force and moment
    let [t174, n6_z, t185, t188, t197, t198] = {
        let t123 = t82 * t82;
        let t124 = w6_y * w6_y;
        let t125 = w6_z * w6_z;
        let t126 = t82 * w6_y;
        let t127 = t82 * w6_z;
        let t128 = w6_y * w6_z;
        let t130 = dw5_y - t126;
        let t132 = dw5_y + t126;
        let t135 = dw6_y + t127;
        let t136 = dw6_x + t128;
        let t151 = XX6R * t126 - ZZ6 * dw5_y - XY6 * (t124 - t123);
        let t160 = YZ6 * (t125 - t124);
        let t161 = YZ6 * t130;
        let t163 = XZ6 * t132 - (ZZ6 * t128 + XX6R * dw6_x + XY6 * t135) + t160;
        let t164 = t127 * (XX6R - ZZ6) - XY6 * t136 + XZ6 * (t123 - t125) + t161;
        let t165 = XZ6 * (t128 - dw6_x) - t151 - YZ6 * (dw6_y - t127);
        let f6_x = MSY6 * t130 - MSX6 * (t124 + t125);
        let t171 = MSX6 * t132 + MSY6 * (t123 + t125);
        let t174 = MSX6 * t135 - MSY6 * t136;
        let t180 = t163 + MSY6 * t110;
        let t181 = t164 - MSX6 * t110;
        let n6_z = MSX6 * a6_y + MSY6 * t114 - t165;
        let t185 = c6 * f6_x + s6 * t171;
        let t188 = s6 * f6_x - c6 * t171;
        let t197 = D6 * t188 - (s6 * t181 - c6 * t180);
        let t198 = D6 * t185 - (s6 * t180 + c6 * t181);
        put(5, n6_z);
        [t174, n6_z, t185, t188, t197, t198]
    };
    // link 5: force and moment
    let [t247, n5_z, t253, t256, t259, t262] = {
        let t219 = ZZ5R * t95 + YY5R * dw4_y + XY5 * t103 + XZ5 * (t93 - t92);
        let t220 = YY5R * t96 + ZZ5R * dw5_y + XY5 * (t94 - t92) + XZ5 * t105;
        let t222 = YZ5 * (t94 - t93);
        let t225 = t97 * (ZZ5R - YY5R) + XY5 * t101 - XZ5 * t104 + t222;
        let f5_x = t185 - (MSX5 * t98 + MSZ5R * t99);
        let f5_y = t174 + (MSX5 * t101 + MSZ5R * t102);
        let t247 = MSX5 * t104 - MSZ5R * t105 - t188;
        let t248 = t197 + (MSZ5R * a4_y - t225);
        let t249 = n6_z + (MSX5 * a4_y - (t220 + YZ5 * t99));
        let n5_z = t198 + (MSZ5R * a5_x + MSX5 * a5_y - (YZ5 * t100 - t219));
        let t253 = s5 * f5_y - c5 * f5_x;
        let t256 = s5 * f5_x + c5 * f5_y;
        let t259 = s5 * t249 - c5 * t248;
        let t262 = s5 * t248 + c5 * t249;
        put(4, n5_z);
        [t247, n5_z, t253, t256, t259, t262]
    };
    // link 4: force and moment
    let [t311, n4_z, t317, t320, t323, t326] = {
        let t283 = XY4 * t66 - (ZZ4R * t58 + YY4R * dw2_y) + XZ4 * (t55 - t56);
        let t284 = YY4R * t59 + ZZ4R * dw4_y + XY4 * (t55 - t57) + XZ4 * t68;
        let t286 = YZ4 * (t57 - t56);
        let t289 = t60 * (YY4R - ZZ4R) + XY4 * t64 + XZ4 * t67 + t286;
        let t309 = t253 - (MSZ4R * t62 - MSX4 * t61);
        let t310 = t247 + (MSX4 * t64 + MSZ4R * t65);
        let t311 = MSZ4R * t68 - MSX4 * t67 - t256;
        let t312 = MSZ4R * t16 - t289 - t259;
        let n4_y = n5_z + (t284 + YZ4 * t62 + MSX4 * t16);
        let n4_z = t262 + (MSX4 * a4_y - MSZ4R * a4_x - (YZ4 * t63 - t283));
        let t317 = s4 * t310 - c4 * t309;
        let t320 = s4 * t309 + c4 * t310;
        let t323 = c4 * t312 + s4 * n4_y;
        let t326 = c4 * n4_y - s4 * t312;
        put(3, n4_z);
        [t311, n4_z, t317, t320, t323, t326]
    };
    // link 3: force and moment
    let [t327, t328, t329, t357, f3_z, n3_z, t364, t365] = {
        let t327 = t8 - t6;
        let t328 = t7 - t8;
        let t329 = t7 - t6;
        let f3_x = t317 - (M3R * t22 + (MSZ3R * t13 + (MSX3 * t14 - MSY3 * t12)));
        let t357 = t320 + (MSY3 * t10 + MSZ3R * t9 - M3R * a3_y);
        let f3_z = t311 - (M3R * t16 + (MSY3 * t9 + MSZ3R * t11));
        let n3_y = t326 + (MSX3 * t16 - MSZ3R * t22);
        let n3_z = n4_z + (MSX3 * a3_y + MSY3 * t22);
        let t364 = n3_y + q3 * f3_x;
        let t365 = t323 + (MSY3 * t16 + MSZ3R * a3_y) - q3 * t357;
        put(2, f3_z);
        [t327, t328, t329, t357, f3_z, n3_z, t364, t365]
    };
    // link 2: force and moment
    {
        let t383 = YZ2R * t328 - (t4 * (ZZ2R - YY2R) + XY2R * t9 - XZ2R * t12);
        let t384 = dw2_y * (YY2R + ZZ2R) + XY2R * t327 + XZ2R * t13 + YZ2R * t9;
        let f2_y = MSX2 * t9 + MSZ2 * t11 - f3_z;
        let n2_x = t364 + (MSZ2 * t3 - t383);
        let n2_z = t365 + (ZZ2R * t9 + XZ2R * t329);
        let t406 = D2 * (c2 * (t357 + (MSX2 * t10 + MSZ2 * t9)) + s2 * f2_y);
        let n1_z = c2 * (n3_z - (t384 + MSX2 * t3)) - s2 * n2_x + t406;
        put(0, n1_z);
        put(1, n2_z);
    }
}
