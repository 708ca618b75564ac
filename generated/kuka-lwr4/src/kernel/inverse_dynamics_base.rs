//! Torques from the base parameters.
//!
//! `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil and Dombre, 9.6.
//!
//! 311 multiplications, 293 additions; 7, 7 of 7 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, Trig};

/// Torques from the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE], out: &mut [S; 7]) {
    entries(trig, dq, ddq, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6, ddq7] = *ddq;
    let [
        ZZ1R, MSX2, MSY2R, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3, MSY3R, XX3R, ZZ3R,
        XY3, XZ3, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6R, XX6R, ZZ6R, XY6, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7, FV1, FV2, FV3, FV4, FV5,
        FV6, FV7, FC1, FC2, FC3, FC4, FC5, FC6, FC7,
        ..] = *beta;
    let L2 = S::constant(0.4);
    let L3 = S::constant(0.39);
    let k0 = S::constant(9.81);
    // link 2: motion
    let [
        w2_x, w2_y, t2, t3, a2_x, a2_y, t6, t7,
        dw2_x, dw2_y,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let t2 = s2 * ddq1;
        let t3 = c2 * ddq1;
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let t6 = dq2 * w2_y;
        let t7 = dq2 * w2_x;
        let dw2_x = t2 + t6;
        let dw2_y = t3 - t7;
        [
        w2_x, w2_y, t2, t3, a2_x, a2_y, t6, t7,
        dw2_x, dw2_y,
    ]
    };
    // link 3: motion
    let [
        w3_x, t15, t22, t23, t24, t25, t26, t27,
        t29, t30, a3_z, a3_x, t41, w3_z, dw3_x, t46,
        dw3_z,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t15 = c3 * dq2 + s3 * w2_x;
        let t22 = w2_x * w2_x;
        let t23 = w2_y * w2_y;
        let t24 = dq2 * dq2;
        let t25 = w2_x * w2_y;
        let t26 = t25 - ddq2;
        let t27 = ddq2 + t25;
        let t29 = t7 - dw2_y;
        let t30 = t6 + dw2_x;
        let t33 = L2 * t30;
        let t34 = a2_x + L2 * t26;
        let a3_z = a2_y - L2 * (t22 + t24);
        let a3_x = c3 * t34 - s3 * t33;
        let t41 = c3 * t33 + s3 * t34;
        let w3_z = w2_y + dq3;
        let dw3_x = c3 * dw2_x - s3 * ddq2 - dq3 * t15;
        let t46 = c3 * ddq2 + s3 * dw2_x + dq3 * w3_x;
        let dw3_z = dw2_y + ddq3;
        [
        w3_x, t15, t22, t23, t24, t25, t26, t27,
        t29, t30, a3_z, a3_x, t41, w3_z, dw3_x, t46,
        dw3_z,
    ]
    };
    // link 4: motion
    let [
        w4_x, t53, t60, t61, t62, t63, t64, t65,
        t66, t67, t68, t69, t70, t71, t72, t73,
        a4_x, t79, w4_z, dw4_x, t84, dw4_z,
    ] = {
        let w4_x = c4 * w3_x - s4 * w3_z;
        let t53 = c4 * w3_z + s4 * w3_x;
        let t60 = w3_x * w3_x;
        let t61 = t15 * t15;
        let t62 = w3_z * w3_z;
        let t63 = w3_x * t15;
        let t64 = w3_x * w3_z;
        let t65 = t15 * w3_z;
        let t66 = t61 + t62;
        let t67 = dw3_z + t63;
        let t68 = t64 - t46;
        let t69 = dw3_z - t63;
        let t70 = t60 + t62;
        let t71 = dw3_x + t65;
        let t72 = t46 + t64;
        let t73 = dw3_x - t65;
        let a4_x = c4 * a3_x - s4 * a3_z;
        let t79 = c4 * a3_z + s4 * a3_x;
        let w4_z = dq4 - t15;
        let dw4_x = c4 * dw3_x - s4 * dw3_z - dq4 * t53;
        let t84 = c4 * dw3_z + s4 * dw3_x + dq4 * w4_x;
        let dw4_z = ddq4 - t46;
        [
        w4_x, t53, t60, t61, t62, t63, t64, t65,
        t66, t67, t68, t69, t70, t71, t72, t73,
        a4_x, t79, w4_z, dw4_x, t84, dw4_z,
    ]
    };
    // link 5: motion
    let [
        w5_x, w5_y, t98, t99, t100, t101, t102, t103,
        t104, t105, t106, t107, t108, t109, t110, t111,
        t116, a5_x, a6_z, w5_z, dw5_x, dw5_y, dw5_z,
    ] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t98 = w4_x * w4_x;
        let t99 = t53 * t53;
        let t100 = w4_z * w4_z;
        let t101 = w4_x * t53;
        let t102 = w4_x * w4_z;
        let t103 = t53 * w4_z;
        let t104 = t99 + t100;
        let t105 = dw4_z + t101;
        let t106 = t102 - t84;
        let t107 = dw4_z - t101;
        let t108 = t98 + t100;
        let t109 = dw4_x + t103;
        let t110 = t84 + t102;
        let t111 = dw4_x - t103;
        let t115 = a4_x + L3 * t105;
        let t116 = L3 * t108 - t79;
        let t117 = t41 + L3 * t111;
        let a5_x = c5 * t115 - s5 * t117;
        let a6_z = c5 * t117 + s5 * t115;
        let w5_z = t53 + dq5;
        let dw5_x = c5 * dw4_x + s5 * dw4_z + dq5 * w5_y;
        let dw5_y = c5 * dw4_z - s5 * dw4_x - dq5 * w5_x;
        let dw5_z = t84 + ddq5;
        [
        w5_x, w5_y, t98, t99, t100, t101, t102, t103,
        t104, t105, t106, t107, t108, t109, t110, t111,
        t116, a5_x, a6_z, w5_z, dw5_x, dw5_y, dw5_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t142, t143, t144, t145, t146, t147,
        t148, t149, t150, t151, t152, t153, t154, t155,
        a6_x, t161, w6_z, dw6_x, dw6_y, dw6_z,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t142 = w5_x * w5_x;
        let t143 = w5_y * w5_y;
        let t144 = w5_z * w5_z;
        let t145 = w5_x * w5_y;
        let t146 = w5_x * w5_z;
        let t147 = w5_y * w5_z;
        let t148 = t143 + t144;
        let t149 = t145 - dw5_z;
        let t150 = dw5_y + t146;
        let t151 = dw5_z + t145;
        let t152 = t142 + t144;
        let t153 = t147 - dw5_x;
        let t154 = t146 - dw5_y;
        let t155 = dw5_x + t147;
        let a6_x = c6 * a5_x - s6 * t116;
        let t161 = c6 * t116 + s6 * a5_x;
        let w6_z = dq6 - w5_y;
        let dw6_x = c6 * dw5_x + s6 * dw5_z + dq6 * w6_y;
        let dw6_y = c6 * dw5_z - s6 * dw5_x - dq6 * w6_x;
        let dw6_z = ddq6 - dw5_y;
        [
        w6_x, w6_y, t142, t143, t144, t145, t146, t147,
        t148, t149, t150, t151, t152, t153, t154, t155,
        a6_x, t161, w6_z, dw6_x, dw6_y, dw6_z,
    ]
    };
    // link 7: motion
    let [
        w7_x, t173, t180, t181, t182, t183, t184, t185,
        t186, t187, t188, t189, t190, t191, t192, t193,
        a7_x, t199, w7_z, dw7_x, t204, dw7_z,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t173 = c7 * w6_z + s7 * w6_x;
        let t180 = w6_x * w6_x;
        let t181 = w6_y * w6_y;
        let t182 = w6_z * w6_z;
        let t183 = w6_x * w6_y;
        let t184 = w6_x * w6_z;
        let t185 = w6_y * w6_z;
        let t186 = t181 + t182;
        let t187 = t183 - dw6_z;
        let t188 = dw6_y + t184;
        let t189 = dw6_z + t183;
        let t190 = t180 + t182;
        let t191 = t185 - dw6_x;
        let t192 = t184 - dw6_y;
        let t193 = dw6_x + t185;
        let a7_x = c7 * a6_x - s7 * a6_z;
        let t199 = c7 * a6_z + s7 * a6_x;
        let w7_z = w6_y + dq7;
        let dw7_x = c7 * dw6_x - s7 * dw6_z - dq7 * t173;
        let t204 = c7 * dw6_z + s7 * dw6_x + dq7 * w7_x;
        let dw7_z = dw6_y + ddq7;
        [
        w7_x, t173, t180, t181, t182, t183, t184, t185,
        t186, t187, t188, t189, t190, t191, t192, t193,
        a7_x, t199, w7_z, dw7_x, t204, dw7_z,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t268, t271, t274, t277] = {
        let t206 = w7_x * w7_x;
        let t207 = t173 * t173;
        let t208 = w7_z * w7_z;
        let t209 = w7_x * t173;
        let t210 = w7_x * w7_z;
        let t211 = t173 * w7_z;
        let t213 = dw7_z + t209;
        let t215 = dw7_z - t209;
        let t218 = t204 + t210;
        let t219 = dw7_x - t211;
        let t238 = XZ7 * (dw7_x + t211);
        let t243 = YZ7 * (t207 - t208);
        let t244 = YZ7 * t213;
        let t245 = YZ7 * (t210 - t204);
        let t246 = XX7R * dw7_x - ZZ7 * t211 - XY7 * t218 + XZ7 * t215 + t243;
        let t247 = t210 * (XX7R - ZZ7) + XY7 * t219 + XZ7 * (t208 - t206) + t244;
        let t248 = XX7R * t209 + ZZ7 * dw7_z + XY7 * (t206 - t207) + t238 + t245;
        let t251 = MSX7 * (t207 + t208) + MSY7 * t213;
        let f7_y = MSX7 * t215 - MSY7 * (t206 + t208);
        let f7_z = MSX7 * t218 + MSY7 * t219;
        let n7_x = t246 - MSY7 * t161;
        let n7_y = t247 + MSX7 * t161;
        let n7_z = t248 - (MSX7 * t199 + MSY7 * a7_x);
        let t268 = c7 * t251 + s7 * f7_y;
        let t271 = c7 * f7_y - s7 * t251;
        let t274 = c7 * n7_x - s7 * n7_y;
        let t277 = s7 * n7_x + c7 * n7_y;
        [f7_z, n7_z, t268, t271, t274, t277]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t332, t335, t338, t341] = {
        let t299 = ZZ6R * dw6_z - XX6R * t183 + XY6 * (t180 - t181) - XZ6 * t191;
        let t301 = YZ6 * (t181 - t182);
        let t302 = YZ6 * t187;
        let t304 = ZZ6R * t185 + XX6R * dw6_x - XY6 * t192 + XZ6 * t189 + t301;
        let t305 = t184 * (XX6R - ZZ6R) + XY6 * t193 + XZ6 * (t182 - t180) - t302;
        let f6_x = MSY6R * t187 - MSX6 * t186 - t268;
        let f6_y = f7_z + (MSX6 * t189 - MSY6R * t190);
        let f6_z = MSX6 * t192 + MSY6R * t193 - t271;
        let n6_x = t274 + (t304 + MSY6R * a6_z);
        let n6_y = n7_z + (t305 - MSX6 * a6_z);
        let n6_z = t299 + YZ6 * t188 - (MSX6 * t161 + MSY6R * a6_x) - t277;
        let t332 = c6 * f6_x - s6 * f6_y;
        let t335 = s6 * f6_x + c6 * f6_y;
        let t338 = c6 * n6_x - s6 * n6_y;
        let t341 = s6 * n6_x + c6 * n6_y;
        [f6_z, n6_z, t332, t335, t338, t341]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t396, t399, t408, t409] = {
        let t363 = ZZ5R * dw5_z - XX5R * t145 + XY5 * (t142 - t143) - XZ5 * t153;
        let t365 = YZ5 * (t143 - t144);
        let t366 = YZ5 * t149;
        let t368 = ZZ5R * t147 + XX5R * dw5_x - XY5 * t154 + XZ5 * t151 + t365;
        let t369 = t146 * (XX5R - ZZ5R) + XY5 * t155 + XZ5 * (t144 - t142) - t366;
        let f5_x = t332 + (MSY5R * t149 - MSX5 * t148);
        let f5_y = MSX5 * t151 - MSY5R * t152 - f6_z;
        let f5_z = t335 + (MSX5 * t154 + MSY5R * t155);
        let n5_x = t338 + (t368 - MSY5R * t116);
        let n5_y = t369 + MSX5 * t116 - n6_z;
        let n5_z = t341 + (t363 + YZ5 * t150 - (MSX5 * a6_z + MSY5R * a5_x));
        let t396 = c5 * f5_x - s5 * f5_y;
        let t399 = s5 * f5_x + c5 * f5_y;
        let t408 = c5 * n5_x - s5 * n5_y - L3 * t399;
        let t409 = s5 * n5_x + c5 * n5_y + L3 * t396;
        [f5_z, n5_z, t396, t399, t408, t409]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t464, t467, t470] = {
        let t431 = XX4R * t101 + ZZ4R * dw4_z + XY4 * (t98 - t99) + XZ4 * t109;
        let t433 = YZ4 * (t99 - t100);
        let t434 = YZ4 * t105;
        let t436 = XX4R * dw4_x - ZZ4R * t103 - XY4 * t110 + XZ4 * t107 + t433;
        let t437 = t102 * (XX4R - ZZ4R) + XY4 * t111 + XZ4 * (t100 - t98) + t434;
        let f4_x = t396 - (MSX4 * t104 + MSY4R * t105);
        let f4_y = MSX4 * t107 - MSY4R * t108 - f5_z;
        let f4_z = t399 + (MSX4 * t110 + MSY4R * t111);
        let n4_x = t408 + (t436 - MSY4R * t41);
        let n4_y = t437 + MSX4 * t41 - n5_z;
        let n4_z = t409 + (t431 + YZ4 * t106 - (MSX4 * t79 + MSY4R * a4_x));
        let t464 = c4 * f4_x - s4 * f4_y;
        let t467 = c4 * n4_x - s4 * n4_y;
        let t470 = s4 * n4_x + c4 * n4_y;
        [f4_z, n4_z, t464, t467, t470]
    };
    // link 3: force and moment
    let [n3_z, t533, t534] = {
        let t492 = XX3R * t63 + ZZ3R * dw3_z + XY3 * (t60 - t61) + XZ3 * t71;
        let t494 = YZ3 * (t61 - t62);
        let t495 = YZ3 * t67;
        let t497 = XX3R * dw3_x - ZZ3R * t65 - XY3 * t72 + XZ3 * t69 + t494;
        let t498 = t64 * (XX3R - ZZ3R) + XY3 * t73 + XZ3 * (t62 - t60) + t495;
        let f3_x = t464 - (MSX3 * t66 + MSY3R * t67);
        let f3_y = f4_z + (MSX3 * t69 - MSY3R * t70);
        let n3_x = t467 + (t497 + MSY3R * a3_z);
        let n3_y = n4_z + (t498 - MSX3 * a3_z);
        let n3_z = t492 + YZ3 * t68 - (MSX3 * t41 + MSY3R * a3_x) - t470;
        let t533 = c3 * n3_x - s3 * n3_y - L2 * (s3 * f3_x + c3 * f3_y);
        let t534 = s3 * n3_x + c3 * n3_y + L2 * (c3 * f3_x - s3 * f3_y);
        [n3_z, t533, t534]
    };
    // link 2: force and moment
    let [n2_z, t573] = {
        let t556 = ZZ2R * ddq2 - XX2R * t25 + XY2 * (t22 - t23) + XZ2 * t2;
        let t558 = YZ2 * (t23 - t24);
        let t559 = YZ2 * t26;
        let t561 = ZZ2R * t6 + XX2R * dw2_x - XY2 * t29 + XZ2 * t27 + t558;
        let t562 = t7 * (XX2R - ZZ2R) + XY2 * t30 + XZ2 * (t24 - t22) - t559;
        let n2_x = t533 + t561;
        let n2_y = n3_z + t562;
        let n2_z = t556 + YZ2 * t3 + (MSX2 * a2_y - MSY2R * a2_x) - t534;
        let t573 = s2 * n2_x + c2 * n2_y;
        [n2_z, t573]
    };
    // link 1: force and moment
    let n1_z = {
        let n1_z = t573 + ZZ1R * ddq1;
        n1_z
    };
    // drives
    {
        let t592 = n1_z + FV1 * dq1 + FC1 * dq1.sign();
        let t595 = n2_z + FV2 * dq2 + FC2 * dq2.sign();
        let t598 = n3_z + FV3 * dq3 + FC3 * dq3.sign();
        let t601 = n4_z + FV4 * dq4 + FC4 * dq4.sign();
        let t604 = n5_z + FV5 * dq5 + FC5 * dq5.sign();
        let t607 = n6_z + FV6 * dq6 + FC6 * dq6.sign();
        let t610 = n7_z + FV7 * dq7 + FC7 * dq7.sign();
        put(0, t592);
        put(1, t595);
        put(2, t598);
        put(3, t601);
        put(4, t604);
        put(5, t607);
        put(6, t610);
    }
}
