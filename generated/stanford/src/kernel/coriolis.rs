//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 206 multiplications, 189 additions; 6, 6 of 6 structurally nonzero.

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
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [
        _, MSX2, MSZ2, YY2R, ZZ2R, XY2R, XZ2R, YZ2R, M3R, MSX3, MSY3, MSZ3R,
        MSX4, MSZ4R, YY4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSZ5R, YY5R, ZZ5R, XY5,
        XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        ..] = *beta;
    let k1 = S::constant(2.0);
    let k_D2 = S::constant(constants::D2);
    let k_D6 = S::constant(constants::D6);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        t1, t2, w3_z, t4, t5, t6, dw2_y, t8,
        t9, t10, t11,
    ] = {
        let t1 = k_D2 * t0;
        let t2 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t4 = t2 * t2;
        let t5 = dq2 * dq2;
        let t6 = t2 * w3_z;
        let dw2_y = dq2 * t2;
        let t8 = dq2 * w3_z;
        let t9 = t4 + t5;
        let t10 = dw2_y + dw2_y;
        let t11 = t8 + t8;
        [
        t1, t2, w3_z, t4, t5, t6, dw2_y, t8,
        t9, t10, t11,
    ]
    };
    // link 3: motion
    let [t13, t19, a3_y, t22, t23] = {
        let t13 = q3 * t9;
        let t16 = dq3 * k1;
        let t19 = q3 * t11 - t1 + t2 * t16;
        let a3_y = dq2 * t16 - q3 * t6;
        let t21 = w3_z * w3_z;
        let t22 = t4 + t21;
        let t23 = t5 + t21;
        [t13, t19, a3_y, t22, t23]
    };
    // link 4: motion
    let [
        a4_x, a4_y, t32, t35, t38, t41, w4_z, t43,
        t44, t45, t46, t47, dw4_y, t50, t51, t52,
        t53, t54,
    ] = {
        let a4_x = s4 * a3_y - c4 * t19;
        let a4_y = c4 * a3_y + s4 * t19;
        let t32 = c4 * dq2 + s4 * t2;
        let t35 = c4 * t2 - s4 * dq2;
        let t38 = c4 * t11 + s4 * t6;
        let t41 = s4 * t11 - c4 * t6;
        let w4_z = w3_z + dq4;
        let t43 = t32 * t32;
        let t44 = w4_z * w4_z;
        let t45 = t32 * t35;
        let t46 = t32 * w4_z;
        let t47 = t35 * w4_z;
        let dw4_y = t46 - t38;
        let t50 = dw2_y + t45;
        let t51 = t45 - dw2_y;
        let t52 = t43 + t44;
        let t53 = t46 + dw4_y;
        let t54 = t47 + (t41 + t47);
        [
        a4_x, a4_y, t32, t35, t38, t41, w4_z, t43,
        t44, t45, t46, t47, dw4_y, t50, t51, t52,
        t53, t54,
    ]
    };
    // link 5: motion
    let [
        a5_x, a5_y, t63, t66, t69, t72, w5_z, t74,
        t75, t76, t77, t78, dw5_y, t81, t82, t83,
        t84, t85,
    ] = {
        let a5_x = c5 * a4_x + s5 * t13;
        let a5_y = c5 * t13 - s5 * a4_x;
        let t63 = c5 * t32 + s5 * w4_z;
        let t66 = c5 * w4_z - s5 * t32;
        let t69 = c5 * t50 + s5 * t54;
        let t72 = c5 * t54 - s5 * t50;
        let w5_z = dq5 - t35;
        let t74 = t63 * t63;
        let t75 = w5_z * w5_z;
        let t76 = t63 * t66;
        let t77 = t63 * w5_z;
        let t78 = t66 * w5_z;
        let dw5_y = t69 + t77;
        let t81 = t76 - dw4_y;
        let t82 = dw4_y + t76;
        let t83 = t74 + t75;
        let t84 = t77 + dw5_y;
        let t85 = t78 + (t72 + t78);
        [
        a5_x, a5_y, t63, t66, t69, t72, w5_z, t74,
        t75, t76, t77, t78, dw5_y, t81, t82, t83,
        t84, t85,
    ]
    };
    // link 6: motion
    let [
        t88, t91, t100, t103, t107, t108, t109, dw6_x,
        t112, t113, t114, t115, t116, t117, t118,
    ] = {
        let t88 = c6 * a5_x + s6 * a4_y;
        let t91 = c6 * a4_y - s6 * a5_x;
        let w6_x = s6 * w5_z - c6 * t63;
        let w6_y = c6 * w5_z + s6 * t63;
        let t100 = c6 * t81 - s6 * t85;
        let t103 = c6 * t85 + s6 * t81;
        let w6_z = t66 + dq6;
        let t105 = w6_x * w6_x;
        let t106 = w6_z * w6_z;
        let t107 = w6_x * w6_y;
        let t108 = w6_x * w6_z;
        let t109 = w6_y * w6_z;
        let dw6_x = t109 - t103;
        let t112 = t105 - t106;
        let t113 = t83 - t112;
        let t114 = dw5_y + t107;
        let t115 = dw5_y - t107;
        let t116 = t105 + t106;
        let t117 = t108 + (t100 + t108);
        let t118 = t109 + dw6_x;
        [
        t88, t91, t100, t103, t107, t108, t109, dw6_x,
        t112, t113, t114, t115, t116, t117, t118,
    ]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t170, t173, t176, t179] = {
        let t120 = k_D6 * MSX6 - XZ6;
        let t122 = k_D6 * MSY6 - YZ6;
        let t143 = t103 * t120 - (XX6R * t107 + ZZ6 * dw5_y + XY6 * (t113 - t116));
        let t145 = t122 * (t83 - t116);
        let t148 = XY6 * t117 - (ZZ6 * t109 + XX6R * dw6_x) - t115 * t120 + t145;
        let t149 = t112 * t120 - (t108 * (ZZ6 - XX6R) - XY6 * t118) + t114 * t122;
        let t153 = MSX6 * t113 - MSY6 * t114;
        let t156 = MSX6 * t115 + MSY6 * t116;
        let f6_z = MSX6 * t117 + MSY6 * t118;
        let t165 = t148 + MSY6 * a5_y;
        let n6_y = t149 + MSX6 * a5_y;
        let n6_z = t143 + t100 * t122 + (MSX6 * t91 - MSY6 * t88);
        let t170 = s6 * t156 - c6 * t153;
        let t173 = s6 * t153 + c6 * t156;
        let t176 = c6 * t165 + s6 * n6_y;
        let t179 = s6 * t165 - c6 * n6_y;
        put(5, n6_z);
        [f6_z, n6_z, t170, t173, t176, t179]
    };
    // link 5: force and moment
    let [t231, n5_z, t237, t240, t243, t246] = {
        let t180 = t66 * t66;
        let t181 = t75 + t180;
        let t182 = t74 + t180;
        let t202 = t78 * (ZZ5R - YY5R) + XY5 * t82 - XZ5 * t84;
        let t203 = ZZ5R * t76 + YY5R * dw4_y - XY5 * t72 - XZ5 * (t83 - t181);
        let t204 = YY5R * t77 + ZZ5R * dw5_y + XY5 * (t181 - t182) + XZ5 * t85;
        let t229 = MSX5 * t181 + MSZ5R * t81 - t170;
        let t230 = f6_z - (MSX5 * t82 + MSZ5R * t83);
        let t231 = t173 + (MSX5 * t84 - MSZ5R * t85);
        let t232 = t176 + (YZ5 * (t182 - t83) - t202 + MSZ5R * a4_y);
        let t233 = t204 + YZ5 * t81 - MSX5 * a4_y - n6_z;
        let n5_z = t203 - YZ5 * t69 + (MSZ5R * a5_x + MSX5 * a5_y) - t179;
        let t237 = s5 * t230 - c5 * t229;
        let t240 = s5 * t229 + c5 * t230;
        let t243 = c5 * t232 + s5 * t233;
        let t246 = s5 * t232 - c5 * t233;
        put(4, n5_z);
        [t231, n5_z, t237, t240, t243, t246]
    };
    // link 4: force and moment
    let [t298, n4_z, t304, t307, t310, t313] = {
        let t247 = t35 * t35;
        let t248 = t44 + t247;
        let t249 = t43 + t247;
        let t270 = ZZ4R * t45 - YY4R * dw2_y + XY4 * t41 + XZ4 * (t52 - t248);
        let t271 = YY4R * t46 + ZZ4R * dw4_y + XY4 * (t249 - t248) - XZ4 * t54;
        let t273 = YZ4 * (t249 - t52);
        let t288 = MSZ4R * t13;
        let t293 = t47 * (ZZ4R - YY4R) - XY4 * t51 + XZ4 * t53 - t273 - t288;
        let f4_x = t237 - (MSX4 * t248 - MSZ4R * t50);
        let t297 = t231 + (MSZ4R * t52 - MSX4 * t51);
        let t298 = t240 - (MSX4 * t53 + MSZ4R * t54);
        let t299 = t243 - t293;
        let n4_y = n5_z + (t271 + YZ4 * t50 + MSX4 * t13);
        let n4_z = t246 + (t270 + YZ4 * t38 - (MSZ4R * a4_x - MSX4 * a4_y));
        let t304 = c4 * f4_x + s4 * t297;
        let t307 = c4 * t297 - s4 * f4_x;
        let t310 = c4 * t299 + s4 * n4_y;
        let t313 = c4 * n4_y - s4 * t299;
        put(3, n4_z);
        [t298, n4_z, t304, t307, t310, t313]
    };
    // link 3: force and moment
    let [t314, t315, t316, t344, f3_z, n3_z, t351, t352] = {
        let t314 = t23 - t22;
        let t315 = t22 - t9;
        let t316 = t9 - t23;
        let f3_x = t304 - (M3R * t19 - (MSY3 * t10 - MSX3 * t22 - MSZ3R * t11));
        let t344 = t307 + (MSY3 * t23 + MSZ3R * t6 - M3R * a3_y);
        let f3_z = t298 - (M3R * t13 + (MSY3 * t6 + MSZ3R * t9));
        let n3_y = t313 - (MSZ3R * t19 - MSX3 * t13);
        let n3_z = n4_z + (MSX3 * a3_y + MSY3 * t19);
        let t351 = n3_y + q3 * f3_x;
        let t352 = t310 + (MSY3 * t13 + MSZ3R * a3_y) - q3 * t344;
        put(2, f3_z);
        [t314, t315, t316, t344, f3_z, n3_z, t351, t352]
    };
    // link 2: force and moment
    {
        let t370 = YZ2R * t315 - (XY2R * t6 - t8 * (YY2R - ZZ2R) - XZ2R * t10);
        let t371 = dw2_y * (YY2R + ZZ2R) + XY2R * t314 + XZ2R * t11 + YZ2R * t6;
        let n2_y = t371 + MSX2 * t1 - n3_z;
        let n2_z = t352 + (ZZ2R * t6 - XZ2R * t316);
        let t387 = c2 * (t344 + (MSX2 * t23 + MSZ2 * t6));
        let f1_x = s2 * (f3_z - (MSX2 * t6 + MSZ2 * t9)) - t387;
        let n1_z = s2 * (t370 - MSZ2 * t1 - t351) - c2 * n2_y - k_D2 * f1_x;
        put(0, n1_z);
        put(1, n2_z);
    }
}
