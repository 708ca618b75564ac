//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 301 multiplications, 276 additions; 7, 7 of 7 structurally nonzero.

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
        _, _, _, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3R, MSY3R, XX3R, ZZ3R,
        XY3R, XZ3, YZ3, MSX4R, MSY4R, XX4R, ZZ4R, XY4R, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6R, MSY6R, XX6R, ZZ6R, XY6R, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7,
        ..] = *beta;
    let A = S::constant(0.0825);
    let L2 = S::constant(0.316);
    let L3 = S::constant(0.384);
    let k3 = S::constant(0.088);
    // link 2: motion
    let [t0, t1, t2, dw2_y] = {
        let t0 = s2 * dq1;
        let t1 = c2 * dq1;
        let t2 = dq2 * t1;
        let dw2_y = dq2 * t0;
        [t0, t1, t2, dw2_y]
    };
    // link 3: motion
    let [
        t6, w3_y, t12, t13, t14, t15, t17, t18,
        t20, a3_x, a3_y, w3_z, dw3_x, dw3_y,
    ] = {
        let t6 = c3 * t0 - s3 * dq2;
        let w3_y = c3 * dq2 + s3 * t0;
        let t12 = t0 * t0;
        let t13 = t1 * t1;
        let t14 = dq2 * dq2;
        let t15 = t0 * t1;
        let t17 = dw2_y + dw2_y;
        let t18 = t2 + t2;
        let t19 = L2 * t15;
        let t20 = L2 * (t12 + t14);
        let t21 = L2 * t18;
        let a3_x = s3 * t21 - c3 * t19;
        let a3_y = c3 * t21 + s3 * t19;
        let w3_z = t1 + dq3;
        let dw3_x = dq3 * w3_y - c3 * t2;
        let dw3_y = s3 * t2 + dq3 * t6;
        [
        t6, w3_y, t12, t13, t14, t15, t17, t18,
        t20, a3_x, a3_y, w3_z, dw3_x, dw3_y,
    ]
    };
    // link 4: motion
    let [
        t35, w4_y, t45, t46, t47, t48, t49, t50,
        t51, t52, t53, t54, t55, t56, t57, t58,
        t63, t67, a4_y, t71, dw4_x, t75,
    ] = {
        let t35 = c4 * t6 - s4 * w3_z;
        let w4_y = c4 * w3_z + s4 * t6;
        let t45 = t6 * t6;
        let t46 = w3_y * w3_y;
        let t47 = w3_z * w3_z;
        let t48 = t6 * w3_y;
        let t49 = t6 * w3_z;
        let t50 = w3_y * w3_z;
        let t51 = t46 + t47;
        let t52 = dw2_y - t48;
        let t53 = dw3_y - t49;
        let t54 = dw2_y + t48;
        let t55 = t45 + t47;
        let t56 = t50 - dw3_x;
        let t57 = dw3_y + t49;
        let t58 = dw3_x + t50;
        let t62 = A * t51 - a3_x;
        let t63 = A * t54 - a3_y;
        let t64 = t20 + A * t57;
        let t67 = c4 * t62 + s4 * t64;
        let a4_y = s4 * t62 - c4 * t64;
        let t71 = w3_y - dq4;
        let dw4_x = c4 * dw3_x - s4 * dw2_y + dq4 * w4_y;
        let t75 = c4 * dw2_y + s4 * dw3_x - dq4 * t35;
        [
        t35, w4_y, t45, t46, t47, t48, t49, t50,
        t51, t52, t53, t54, t55, t56, t57, t58,
        t63, t67, a4_y, t71, dw4_x, t75,
    ]
    };
    // link 5: motion
    let [
        t78, t81, t88, t89, t90, t91, t92, t93,
        t94, t95, t96, t97, t98, t99, t100, t101,
        a5_z, t116, t119, w5_z, dw5_x, dw5_y,
    ] = {
        let t78 = c5 * t35 - s5 * t71;
        let t81 = c5 * t71 + s5 * t35;
        let t88 = t35 * t35;
        let t89 = w4_y * w4_y;
        let t90 = t71 * t71;
        let t91 = t35 * w4_y;
        let t92 = t35 * t71;
        let t93 = w4_y * t71;
        let t94 = t89 + t90;
        let t95 = t91 - dw3_y;
        let t96 = t92 - t75;
        let t97 = dw3_y + t91;
        let t98 = t88 + t90;
        let t99 = dw4_x + t93;
        let t100 = t75 + t92;
        let t101 = t93 - dw4_x;
        let t111 = t67 - (A * t94 - L3 * t95);
        let a5_z = a4_y + (A * t97 - L3 * t98);
        let t113 = t63 - (A * t100 + L3 * t101);
        let t116 = c5 * t111 + s5 * t113;
        let t119 = s5 * t111 - c5 * t113;
        let w5_z = w4_y + dq5;
        let dw5_x = c5 * dw4_x + s5 * dw3_y + dq5 * t81;
        let dw5_y = c5 * dw3_y - s5 * dw4_x + dq5 * t78;
        [
        t78, t81, t88, t89, t90, t91, t92, t93,
        t94, t95, t96, t97, t98, t99, t100, t101,
        a5_z, t116, t119, w5_z, dw5_x, dw5_y,
    ]
    };
    // link 6: motion
    let [
        t127, w6_y, t137, t138, t139, t140, t141, t142,
        t143, t144, t145, t146, t147, t148, t149, t150,
        t153, a6_y, w6_z, dw6_x, dw7_z,
    ] = {
        let t127 = c6 * t78 - s6 * w5_z;
        let w6_y = c6 * w5_z + s6 * t78;
        let t137 = t78 * t78;
        let t138 = t81 * t81;
        let t139 = w5_z * w5_z;
        let t140 = t78 * t81;
        let t141 = t78 * w5_z;
        let t142 = t81 * w5_z;
        let t143 = t138 + t139;
        let t144 = t140 - t75;
        let t145 = dw5_y - t141;
        let t146 = t75 + t140;
        let t147 = t137 + t139;
        let t148 = dw5_x - t142;
        let t149 = dw5_y + t141;
        let t150 = dw5_x + t142;
        let t153 = c6 * t116 - s6 * a5_z;
        let a6_y = c6 * a5_z + s6 * t116;
        let w6_z = dq6 - t81;
        let dw6_x = c6 * dw5_x - s6 * t75 + dq6 * w6_y;
        let dw7_z = c6 * t75 + s6 * dw5_x - dq6 * t127;
        [
        t127, w6_y, t137, t138, t139, t140, t141, t142,
        t143, t144, t145, t146, t147, t148, t149, t150,
        t153, a6_y, w6_z, dw6_x, dw7_z,
    ]
    };
    // link 7: motion
    let [
        t164, w7_y, t174, t175, t176, t177, t178, t179,
        t180, t181, t182, t183, t184, t185, t186, t187,
        t192, t196, a7_y, t200, dw7_x, t204,
    ] = {
        let t164 = c7 * t127 - s7 * w6_z;
        let w7_y = c7 * w6_z + s7 * t127;
        let t174 = t127 * t127;
        let t175 = w6_y * w6_y;
        let t176 = w6_z * w6_z;
        let t177 = t127 * w6_y;
        let t178 = t127 * w6_z;
        let t179 = w6_y * w6_z;
        let t180 = t175 + t176;
        let t181 = t177 - dw5_y;
        let t182 = dw7_z + t178;
        let t183 = dw5_y + t177;
        let t184 = t174 + t176;
        let t185 = dw6_x - t179;
        let t186 = t178 - dw7_z;
        let t187 = dw6_x + t179;
        let t191 = t153 + k3 * t180;
        let t192 = a6_y - k3 * t183;
        let t193 = t119 + k3 * t186;
        let t196 = c7 * t191 + s7 * t193;
        let a7_y = s7 * t191 - c7 * t193;
        let t200 = w6_y - dq7;
        let dw7_x = c7 * dw6_x - s7 * dw5_y + dq7 * w7_y;
        let t204 = c7 * dw5_y + s7 * dw6_x - dq7 * t164;
        [
        t164, w7_y, t174, t175, t176, t177, t178, t179,
        t180, t181, t182, t183, t184, t185, t186, t187,
        t192, t196, a7_y, t200, dw7_x, t204,
    ]
    };
    // link 7: force and moment
    let [f7_z, t267, t270, t273, t279, t280] = {
        let t205 = t164 * t164;
        let t206 = w7_y * w7_y;
        let t207 = t200 * t200;
        let t208 = t164 * w7_y;
        let t209 = t164 * t200;
        let t210 = w7_y * t200;
        let t212 = dw7_z + t208;
        let t214 = t208 - dw7_z;
        let t217 = t204 + t209;
        let t218 = dw7_x - t210;
        let t237 = XZ7 * (dw7_x + t210);
        let t242 = YZ7 * (t206 - t207);
        let t243 = YZ7 * t212;
        let t244 = YZ7 * (t209 - t204);
        let t245 = XZ7 * t214 - (XX7R * dw7_x - ZZ7 * t210 - XY7 * t217) - t242;
        let t246 = t209 * (XX7R - ZZ7) + XY7 * t218 - XZ7 * (t205 - t207) + t243;
        let t247 = XX7R * t208 + ZZ7 * dw7_z + XY7 * (t205 - t206) + t237 + t244;
        let t250 = MSX7 * (t206 + t207) + MSY7 * t212;
        let t253 = MSX7 * t214 + MSY7 * (t205 + t207);
        let f7_z = MSX7 * t217 + MSY7 * t218;
        let t262 = t245 + MSY7 * t192;
        let n7_y = t246 + MSX7 * t192;
        let n7_z = t247 + (MSX7 * a7_y + MSY7 * t196);
        let t267 = c7 * t250 - s7 * t253;
        let t270 = s7 * t250 + c7 * t253;
        let t273 = c7 * t262 + s7 * n7_y;
        let t279 = k3 * f7_z - (c7 * n7_y - s7 * t262);
        let t280 = k3 * t270 - n7_z;
        put(6, n7_z);
        [f7_z, t267, t270, t273, t279, t280]
    };
    // link 6: force and moment
    let [t329, n6_z, t335, t338, t341, t344] = {
        let t302 = XX6R * t177 - ZZ6R * dw5_y + XY6R * (t174 - t175) + XZ6 * t185;
        let t304 = YZ6 * (t175 - t176);
        let t305 = YZ6 * t181;
        let t307 = ZZ6R * t179 + XX6R * dw6_x + XY6R * t186 - XZ6 * t183 + t304;
        let t308 = t178 * (XX6R - ZZ6R) - XY6R * t187 + XZ6 * (t174 - t176) - t305;
        let t327 = t267 + (MSX6R * t180 + MSY6R * t181);
        let t328 = f7_z + (MSX6R * t183 + MSY6R * t184);
        let t329 = t270 + (MSX6R * t186 - MSY6R * t187);
        let t330 = t273 + (MSY6R * t119 - t307);
        let t331 = t308 - MSX6R * t119 - t280;
        let n6_z = t302 - YZ6 * t182 + (MSX6R * a6_y + MSY6R * t153) - t279;
        let t335 = c6 * t327 - s6 * t328;
        let t338 = s6 * t327 + c6 * t328;
        let t341 = c6 * t330 - s6 * t331;
        let t344 = s6 * t330 + c6 * t331;
        put(5, n6_z);
        [t329, n6_z, t335, t338, t341, t344]
    };
    // link 5: force and moment
    let [f5_z, t399, t402, t414, t415, t416] = {
        let t364 = ZZ5R * t142 + XX5R * dw5_x + XY5 * t149 - XZ5 * t146;
        let t366 = XY5 * (t137 - t138) - (ZZ5R * t75 - XX5R * t140) + XZ5 * t148;
        let t369 = YZ5 * t144;
        let t372 = XZ5 * (t139 - t137) - (t141 * (XX5R - ZZ5R) - XY5 * t150) + t369;
        let t391 = t335 + (MSX5 * t143 + MSY5R * t144);
        let t392 = MSX5 * t146 + MSY5R * t147 - t329;
        let f5_z = MSY5R * t150 - MSX5 * t149 - t338;
        let t394 = t341 + (YZ5 * (t139 - t138) - t364 - MSY5R * a5_z);
        let n5_y = t372 - MSX5 * a5_z - n6_z;
        let n5_z = t366 + YZ5 * t145 + (MSX5 * t119 + MSY5R * t116) - t344;
        let t399 = s5 * t392 - c5 * t391;
        let t402 = s5 * t391 + c5 * t392;
        let t414 = L3 * t402 - (c5 * t394 + s5 * n5_y);
        let t415 = c5 * n5_y - s5 * t394 + (L3 * t399 + A * f5_z);
        let t416 = n5_z + A * t402;
        put(4, n5_z);
        [f5_z, t399, t402, t414, t415, t416]
    };
    // link 4: force and moment
    let [f4_z, t471, t477, t483, t484] = {
        let t438 = XX4R * t91 - ZZ4R * dw3_y + XY4R * (t88 - t89) + XZ4 * t99;
        let t440 = YZ4 * (t89 - t90);
        let t441 = YZ4 * t95;
        let t443 = XX4R * dw4_x - ZZ4R * t93 - XY4R * t100 - XZ4 * t97 + t440;
        let t444 = XZ4 * (t90 - t88) - (XY4R * t101 - t92 * (XX4R - ZZ4R)) + t441;
        let t463 = MSX4R * t94 + MSY4R * t95 - t399;
        let t464 = MSX4R * t97 + MSY4R * t98 - f5_z;
        let f4_z = t402 + (MSX4R * t100 - MSY4R * t101);
        let n4_x = t414 + (t443 + MSY4R * t63);
        let n4_y = t416 - (MSX4R * t63 - t444);
        let n4_z = t438 + YZ4 * t96 + (MSX4R * a4_y + MSY4R * t67) - t415;
        let t471 = s4 * t464 - c4 * t463;
        let t477 = c4 * n4_x - s4 * n4_y;
        let t483 = s4 * n4_x + c4 * n4_y - A * f4_z;
        let t484 = A * (s4 * t463 + c4 * t464) - n4_z;
        put(3, n4_z);
        [f4_z, t471, t477, t483, t484]
    };
    // link 3: force and moment
    let [n3_z, t547, t548] = {
        let t506 = XY3R * (t46 - t45) - (XX3R * t48 - ZZ3R * dw2_y) + XZ3 * t56;
        let t508 = YZ3 * (t47 - t46);
        let t509 = YZ3 * t52;
        let t511 = XZ3 * t54 - (ZZ3R * t50 + XX3R * dw3_x + XY3R * t57) + t508;
        let t512 = XZ3 * (t45 - t47) - (XY3R * t58 - t49 * (XX3R - ZZ3R)) + t509;
        let f3_x = t471 - (MSX3R * t51 - MSY3R * t52);
        let t529 = f4_z + (MSX3R * t54 + MSY3R * t55);
        let n3_x = t477 - (t511 + MSY3R * t20);
        let t531 = t512 - MSX3R * t20 - t484;
        let n3_z = t483 + (YZ3 * t53 - t506 - (MSY3R * a3_x - MSX3R * a3_y));
        let t547 = c3 * n3_x + s3 * t531 + L2 * (c3 * t529 - s3 * f3_x);
        let t548 = s3 * n3_x - c3 * t531 + L2 * (c3 * f3_x + s3 * t529);
        put(2, n3_z);
        [n3_z, t547, t548]
    };
    // link 2: force and moment
    {
        let t567 = YZ2 * (t14 - t13);
        let t568 = YZ2 * t15;
        let t570 = dw2_y * (XX2R - ZZ2R) + XY2 * t18 + XZ2 * (t12 - t14) + t568;
        let n2_x = t547 + (XZ2 * t15 - (t2 * (XX2R + ZZ2R) - XY2 * t17) - t567);
        let n2_z = t548 - (XX2R * t15 + XY2 * (t13 - t12));
        let n1_z = c2 * (n3_z + t570) - s2 * n2_x;
        put(0, n1_z);
        put(1, n2_z);
    }
}
