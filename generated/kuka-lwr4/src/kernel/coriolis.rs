//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 270 multiplications, 244 additions; 7, 7 of 7 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, Trig, constants};

/// Coriolis and centrifugal torques `C dq`: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], out: &mut [S; 7]) {
    entries(trig, dq, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let [
        _, _, _, XX2R, _, XY2, XZ2, YZ2, MSX3, MSY3R, XX3R, ZZ3R,
        XY3, XZ3, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6R, XX6R, ZZ6R, XY6, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7,
        ..] = *beta;
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [w2_x, w2_y, t4, t5, t6, t8, t9] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t4 = dq2 * dq2;
        let t5 = w2_x * w2_y;
        let t6 = dq2 * w2_x;
        let dw2_x = dq2 * w2_y;
        let t8 = w2_x * w2_x + t4;
        let t9 = dw2_x + dw2_x;
        [w2_x, w2_y, t4, t5, t6, t8, t9]
    };
    // link 3: motion
    let [
        t11, t15, t18, t21, t24, t27, t30, w3_z,
        t34, t35, t36, dw3_x, dw3_y, t39, t40, t41,
        t42, t43, t44, t45,
    ] = {
        let t10 = k_L2 * t5;
        let t11 = k_L2 * t8;
        let t12 = k_L2 * t9;
        let t15 = s3 * t12 - c3 * t10;
        let t18 = c3 * t12 + s3 * t10;
        let t21 = s3 * dq2 - c3 * w2_x;
        let t24 = c3 * dq2 + s3 * w2_x;
        let t27 = c3 * t5 - s3 * t9;
        let t30 = c3 * t9 + s3 * t5;
        let w3_z = w2_y + dq3;
        let t32 = t21 * t21;
        let t33 = w3_z * w3_z;
        let t34 = t21 * t24;
        let t35 = t21 * w3_z;
        let t36 = t24 * w3_z;
        let dw3_x = t30 - t36;
        let dw3_y = t27 + t35;
        let t39 = t33 - t32;
        let t40 = t8 + t39;
        let t41 = t6 + t34;
        let t42 = t34 - t6;
        let t43 = t32 + t33;
        let t44 = t35 + dw3_y;
        let t45 = t36 - dw3_x;
        [
        t11, t15, t18, t21, t24, t27, t30, w3_z,
        t34, t35, t36, dw3_x, dw3_y, t39, t40, t41,
        t42, t43, t44, t45,
    ]
    };
    // link 4: motion
    let [
        a4_x, a4_y, t54, t57, t60, t63, w4_z, t67,
        t68, t69, dw4_x, dw4_y, t72, t73, t74, t75,
        t76, t77, t78,
    ] = {
        let a4_x = s4 * t11 - c4 * t15;
        let a4_y = c4 * t11 + s4 * t15;
        let t54 = c4 * t21 + s4 * w3_z;
        let t57 = c4 * w3_z - s4 * t21;
        let t60 = c4 * t41 + s4 * t45;
        let t63 = s4 * t41 - c4 * t45;
        let w4_z = dq4 - t24;
        let t65 = t54 * t54;
        let t66 = w4_z * w4_z;
        let t67 = t54 * t57;
        let t68 = t54 * w4_z;
        let t69 = t57 * w4_z;
        let dw4_x = t63 - t69;
        let dw4_y = t60 + t68;
        let t72 = t66 - t65;
        let t73 = t43 + t72;
        let t74 = dw3_y - t67;
        let t75 = dw3_y + t67;
        let t76 = t65 + t66;
        let t77 = t68 + dw4_y;
        let t78 = t69 - dw4_x;
        [
        a4_x, a4_y, t54, t57, t60, t63, w4_z, t67,
        t68, t69, dw4_x, dw4_y, t72, t73, t74, t75,
        t76, t77, t78,
    ]
    };
    // link 5: motion
    let [
        t83, a5_x, a6_z, w5_x, w5_y, t99, t102, w5_z,
        t106, t107, t108, dw5_x, t110, t111, t112, t113,
        t114, t115, t116, t117,
    ] = {
        let t82 = a4_x + k_L3 * t74;
        let t83 = a4_y + k_L3 * t76;
        let t84 = k_L3 * t78 - t18;
        let a5_x = c5 * t82 + s5 * t84;
        let a6_z = s5 * t82 - c5 * t84;
        let w5_x = s5 * w4_z - c5 * t54;
        let w5_y = c5 * w4_z + s5 * t54;
        let t99 = c5 * t74 + s5 * t78;
        let t102 = s5 * t74 - c5 * t78;
        let w5_z = t57 + dq5;
        let t104 = w5_x * w5_x;
        let t105 = w5_z * w5_z;
        let t106 = w5_x * w5_y;
        let t107 = w5_x * w5_z;
        let t108 = w5_y * w5_z;
        let dw5_x = t102 + t108;
        let t110 = t107 - t99;
        let t111 = t105 - t104;
        let t112 = t76 + t111;
        let t113 = dw4_y + t106;
        let t114 = dw4_y - t106;
        let t115 = t104 + t105;
        let t116 = t107 + t110;
        let t117 = t108 + dw5_x;
        [
        t83, a5_x, a6_z, w5_x, w5_y, t99, t102, w5_z,
        t106, t107, t108, dw5_x, t110, t111, t112, t113,
        t114, t115, t116, t117,
    ]
    };
    // link 6: motion
    let [
        a6_x, t123, w6_x, t129, t132, t135, w6_z, t139,
        t140, t141, t142, t143, t144, t145, t146, t147,
        t148, t149, t150,
    ] = {
        let a6_x = c6 * a5_x - s6 * t83;
        let t123 = c6 * t83 + s6 * a5_x;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let t129 = s6 * w5_x - c6 * w5_z;
        let t132 = c6 * t113 + s6 * t117;
        let t135 = s6 * t113 - c6 * t117;
        let w6_z = dq6 - w5_y;
        let t137 = w6_x * w6_x;
        let t138 = w6_z * w6_z;
        let t139 = w6_x * t129;
        let t140 = w6_x * w6_z;
        let t141 = t129 * w6_z;
        let t142 = t135 + t141;
        let t143 = t132 + t140;
        let t144 = t137 - t138;
        let t145 = t115 - t144;
        let t146 = t110 + t139;
        let t147 = t110 - t139;
        let t148 = t137 + t138;
        let t149 = t140 + t143;
        let t150 = t141 + t142;
        [
        a6_x, t123, w6_x, t129, t132, t135, w6_z, t139,
        t140, t141, t142, t143, t144, t145, t146, t147,
        t148, t149, t150,
    ]
    };
    // link 7: motion
    let [
        a7_x, t156, t165, t168, t172, t173, t174, t175,
        t177, t178, t179, t180, t181, t182, t183,
    ] = {
        let a7_x = c7 * a6_x - s7 * a6_z;
        let t156 = c7 * a6_z + s7 * a6_x;
        let t159 = s7 * w6_z - c7 * w6_x;
        let t162 = c7 * w6_z + s7 * w6_x;
        let t165 = s7 * t150 - c7 * t146;
        let t168 = c7 * t150 + s7 * t146;
        let w7_z = dq7 - t129;
        let t170 = t159 * t159;
        let t171 = w7_z * w7_z;
        let t172 = t159 * t162;
        let t173 = t159 * w7_z;
        let t174 = t162 * w7_z;
        let t175 = t168 + t174;
        let dw7_y = t165 + t173;
        let t177 = t171 - t170;
        let t178 = t148 + t177;
        let t179 = t143 + t172;
        let t180 = t172 - t143;
        let t181 = t170 + t171;
        let t182 = t173 + dw7_y;
        let t183 = t174 + t175;
        [
        a7_x, t156, t165, t168, t172, t173, t174, t175,
        t177, t178, t179, t180, t181, t182, t183,
    ]
    };
    // link 7: force and moment
    let [t220, n7_z, t231, t234, t237, t240] = {
        let t204 = XY7 * (t181 - t178) - (XX7R * t172 + ZZ7 * t143) - XZ7 * t168;
        let t206 = YZ7 * (t181 - t148);
        let t209 = ZZ7 * t174 + XX7R * t175 - XY7 * t182 - XZ7 * t180 + t206;
        let t210 = XZ7 * t177 - (t173 * (XX7R - ZZ7) + XY7 * t183) - YZ7 * t179;
        let f7_x = MSY7 * t179 - MSX7 * t178;
        let t217 = MSX7 * t180 - MSY7 * t181;
        let t220 = MSX7 * t182 + MSY7 * t183;
        let t226 = t209 + MSY7 * t123;
        let n7_y = t210 + MSX7 * t123;
        let n7_z = t204 + YZ7 * t165 - (MSX7 * t156 + MSY7 * a7_x);
        let t231 = c7 * f7_x - s7 * t217;
        let t234 = s7 * f7_x + c7 * t217;
        let t237 = c7 * t226 + s7 * n7_y;
        let t240 = c7 * n7_y - s7 * t226;
        put(6, n7_z);
        [t220, n7_z, t231, t234, t237, t240]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t294, t297, t300, t303] = {
        let t261 = XX6R * t139 + ZZ6R * t110 + XY6 * (t148 - t145) - XZ6 * t135;
        let t263 = YZ6 * (t115 - t148);
        let t266 = XZ6 * t147 - (ZZ6R * t141 + XX6R * t142 + XY6 * t149) + t263;
        let t267 = YZ6 * t146 - (t140 * (ZZ6R - XX6R) + XY6 * t150 + XZ6 * t144);
        let f6_x = t231 - (MSX6 * t145 + MSY6R * t146);
        let t287 = t220 + (MSY6R * t148 - MSX6 * t147);
        let f6_z = MSX6 * t149 - MSY6R * t150 - t234;
        let t289 = t237 - (t266 + MSY6R * a6_z);
        let n6_y = n7_z + (t267 - MSX6 * a6_z);
        let n6_z = t261 - YZ6 * t132 - (MSX6 * t123 + MSY6R * a6_x) - t240;
        let t294 = c6 * f6_x + s6 * t287;
        let t297 = s6 * f6_x - c6 * t287;
        let t300 = c6 * t289 + s6 * n6_y;
        let t303 = s6 * t289 - c6 * n6_y;
        put(5, n6_z);
        [f6_z, n6_z, t294, t297, t300, t303]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t357, t360, t369, t370] = {
        let t324 = XY5 * (t115 - t112) - (XX5R * t106 + ZZ5R * dw4_y) + XZ5 * t102;
        let t326 = YZ5 * (t76 - t115);
        let t329 = XZ5 * t114 - (ZZ5R * t108 + XX5R * dw5_x - XY5 * t116) - t326;
        let t330 = t107 * (XX5R - ZZ5R) + XY5 * t117 + XZ5 * t111 - YZ5 * t113;
        let f5_x = t294 - (MSX5 * t112 - MSY5R * t113);
        let t350 = f6_z + (MSX5 * t114 + MSY5R * t115);
        let f5_z = t297 + (MSX5 * t116 + MSY5R * t117);
        let t352 = t300 + (t329 + MSY5R * t83);
        let t353 = n6_z - (t330 + MSX5 * t83);
        let n5_z = t324 + YZ5 * t99 - (MSX5 * a6_z + MSY5R * a5_x) - t303;
        let t357 = c5 * f5_x + s5 * t350;
        let t360 = c5 * t350 - s5 * f5_x;
        let t369 = s5 * t353 - c5 * t352 + k_L3 * t360;
        let t370 = k_L3 * t357 - (s5 * t352 + c5 * t353);
        put(4, n5_z);
        [f5_z, n5_z, t357, t360, t369, t370]
    };
    // link 4: force and moment
    let [t418, n4_z, t424, t427, t430] = {
        let t389 = XX4R * dw4_x - ZZ4R * t69 + XY4 * t77 + XZ4 * t75;
        let t391 = ZZ4R * dw3_y - XX4R * t67 + XY4 * (t76 - t73) + XZ4 * t63;
        let t397 = t68 * (ZZ4R - XX4R) - XY4 * t78 + XZ4 * t72 + YZ4 * t74;
        let f4_y = MSX4 * t75 - MSY4R * t76 - f5_z;
        let t418 = t360 + (MSX4 * t77 + MSY4R * t78);
        let n4_x = t369 - (YZ4 * (t76 - t43) - t389 + MSY4R * t18);
        let n4_y = t397 + MSX4 * t18 - n5_z;
        let n4_z = t370 + (t391 + YZ4 * t60 + (MSX4 * a4_y - MSY4R * a4_x));
        let t424 = c4 * (MSX4 * t73 + MSY4R * t74 - t357) + s4 * f4_y;
        let t427 = c4 * n4_x - s4 * n4_y;
        let t430 = s4 * n4_x + c4 * n4_y;
        put(3, n4_z);
        [t418, n4_z, t424, t427, t430]
    };
    // link 3: force and moment
    let [n3_z, n2_x, t493] = {
        let t451 = XY3 * (t43 - t40) - (XX3R * t34 + ZZ3R * t6) + XZ3 * t30;
        let t453 = YZ3 * (t43 - t8);
        let t456 = XX3R * dw3_x - ZZ3R * t36 + XY3 * t44 + XZ3 * t42 - t453;
        let t457 = YZ3 * t41 - (XZ3 * t39 - (t35 * (XX3R - ZZ3R) + XY3 * t45));
        let t473 = t424 - (MSY3R * t41 - MSX3 * t40);
        let t474 = t418 + (MSY3R * t43 - MSX3 * t42);
        let n3_x = t427 + (t456 - MSY3R * t11);
        let n3_y = n4_z + (MSX3 * t11 - t457);
        let n3_z = t451 + YZ3 * t27 - (MSX3 * t18 - MSY3R * t15) - t430;
        let n2_x = k_L2 * (s3 * t473 + c3 * t474) - (s3 * n3_y - c3 * n3_x);
        let t493 = k_L2 * (c3 * t473 - s3 * t474) - (s3 * n3_x + c3 * n3_y);
        put(2, n3_z);
        [n3_z, n2_x, t493]
    };
    // link 2: force and moment
    let [t507, t512] = {
        let t499 = XY2 - c2 * (s2 * XX2R + c2 * (XY2 + XY2));
        let t507 = (t499 + t499) * (dq1 * dq2) + t4 * (s2 * YZ2 - c2 * XZ2);
        let n2_z = t493 + t0 * t499;
        let t512 = s2 * n2_x + c2 * n3_z;
        put(1, n2_z);
        [t507, t512]
    };
    // link 1: force and moment
    {
        let n1_z = t512 - t507;
        put(0, n1_z);
    }
}
