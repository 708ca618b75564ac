//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 314 multiplications, 288 additions; 7, 7 of 7 structurally nonzero.

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
        _, MSX2, MSY2R, XX2R, ZZ2R, XY2, XZ2, YZ2, MSX3, MSY3R, XX3R, ZZ3R,
        XY3, XZ3, YZ3, MSX4, MSY4R, XX4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSY5R,
        XX5R, ZZ5R, XY5, XZ5, YZ5, MSX6, MSY6R, XX6R, ZZ6R, XY6, XZ6, YZ6,
        MSX7, MSY7, XX7R, ZZ7, XY7, XZ7, YZ7,
        ..] = *beta;
    let k0 = S::constant(0.01175);
    let k1 = S::constant(0.42076);
    let k2 = S::constant(0.01275);
    let k3 = S::constant(0.31436);
    let k4 = S::constant(0.00035);
    let k5 = S::constant(0.167455);
    // link 2: motion
    let [w2_x, w2_y, a2_z, dw2_x, t5] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let a2_z = dq1 * dq1 * k0;
        let dw2_x = dq2 * w2_y;
        let t5 = dq2 * w2_x;
        [w2_x, w2_y, a2_z, dw2_x, t5]
    };
    // link 3: motion
    let [
        w3_x, t11, t14, t15, t16, t17, t18, t19,
        t20, t21, a3_z, t28, a3_y, w3_z, dw3_x, dw4_z,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t11 = c3 * dq2 + s3 * w2_x;
        let t14 = w2_x * w2_x;
        let t15 = w2_y * w2_y;
        let t16 = dq2 * dq2;
        let t17 = w2_x * w2_y;
        let t18 = t15 + t16;
        let t19 = t14 + t16;
        let t20 = t5 + t5;
        let t21 = dw2_x + dw2_x;
        let t22 = t17 * k1;
        let a3_z = t19 * k1;
        let t25 = a2_z - t21 * k1;
        let t28 = c3 * t22 + s3 * t25;
        let a3_y = s3 * t22 - c3 * t25;
        let w3_z = w2_y + dq3;
        let dw3_x = c3 * dw2_x - dq3 * t11;
        let dw4_z = s3 * dw2_x + dq3 * w3_x;
        [
        w3_x, t11, t14, t15, t16, t17, t18, t19,
        t20, t21, a3_z, t28, a3_y, w3_z, dw3_x, dw4_z,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t49, t50, t51, t52, t53, t54,
        t55, t56, t57, t58, t59, t60, t61, t62,
        t67, a4_x, a4_y, w4_z, dw4_x, t79,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t49 = w3_x * w3_x;
        let t50 = t11 * t11;
        let t51 = w3_z * w3_z;
        let t52 = w3_x * t11;
        let t53 = w3_x * w3_z;
        let t54 = t11 * w3_z;
        let t55 = t50 + t51;
        let t56 = t5 - t52;
        let t57 = t53 - dw4_z;
        let t58 = t5 + t52;
        let t59 = t49 + t51;
        let t60 = dw3_x + t54;
        let t61 = dw4_z + t53;
        let t62 = dw3_x - t54;
        let t66 = t56 * k2 - t28;
        let t67 = a3_y - t59 * k2;
        let t68 = a3_z + t62 * k2;
        let a4_x = c4 * t66 + s4 * t68;
        let a4_y = c4 * t68 - s4 * t66;
        let w4_z = t11 + dq4;
        let dw4_x = c4 * dw3_x - s4 * t5 + dq4 * w4_y;
        let t79 = c4 * t5 + s4 * dw3_x + dq4 * w4_x;
        [
        w4_x, w4_y, t49, t50, t51, t52, t53, t54,
        t55, t56, t57, t58, t59, t60, t61, t62,
        t67, a4_x, a4_y, w4_z, dw4_x, t79,
    ]
    };
    // link 5: motion
    let [
        w5_x, t85, t92, t93, t94, t95, t96, t97,
        t98, t99, t100, t101, t102, t103, t104, t105,
        a5_z, a5_x, a5_y, w5_z, dw5_x, dw6_z,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t85 = c5 * w4_z + s5 * w4_x;
        let t92 = w4_x * w4_x;
        let t93 = w4_y * w4_y;
        let t94 = w4_z * w4_z;
        let t95 = w4_x * w4_y;
        let t96 = w4_x * w4_z;
        let t97 = w4_y * w4_z;
        let t98 = t93 + t94;
        let t99 = t95 - dw4_z;
        let t100 = t96 - t79;
        let t101 = dw4_z + t95;
        let t102 = t92 + t94;
        let t103 = t97 - dw4_x;
        let t104 = t79 + t96;
        let t105 = dw4_x + t97;
        let t109 = a4_x - t99 * k3;
        let a5_z = a4_y + t102 * k3;
        let t111 = t67 + t105 * k3;
        let a5_x = c5 * t109 + s5 * t111;
        let a5_y = c5 * t111 - s5 * t109;
        let w5_z = w4_y + dq5;
        let dw5_x = c5 * dw4_x - s5 * dw4_z - dq5 * t85;
        let dw6_z = c5 * dw4_z + s5 * dw4_x + dq5 * w5_x;
        [
        w5_x, t85, t92, t93, t94, t95, t96, t97,
        t98, t99, t100, t101, t102, t103, t104, t105,
        a5_z, a5_x, a5_y, w5_z, dw5_x, dw6_z,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t135, t136, t137, t138, t139, t140,
        t141, t142, t143, t144, t145, t146, t147, t148,
        t153, a6_x, a6_y, w6_z, dw6_x, t165,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t135 = w5_x * w5_x;
        let t136 = t85 * t85;
        let t137 = w5_z * w5_z;
        let t138 = w5_x * t85;
        let t139 = w5_x * w5_z;
        let t140 = t85 * w5_z;
        let t141 = t136 + t137;
        let t142 = t79 - t138;
        let t143 = t139 - dw6_z;
        let t144 = t79 + t138;
        let t145 = t135 + t137;
        let t146 = dw5_x + t140;
        let t147 = dw6_z + t139;
        let t148 = dw5_x - t140;
        let t152 = a5_x + t142 * k4;
        let t153 = a5_y - t145 * k4;
        let t154 = a5_z + t148 * k4;
        let a6_x = c6 * t152 + s6 * t154;
        let a6_y = c6 * t154 - s6 * t152;
        let w6_z = t85 + dq6;
        let dw6_x = c6 * dw5_x - s6 * t79 + dq6 * w6_y;
        let t165 = c6 * t79 + s6 * dw5_x + dq6 * w6_x;
        [
        w6_x, w6_y, t135, t136, t137, t138, t139, t140,
        t141, t142, t143, t144, t145, t146, t147, t148,
        t153, a6_x, a6_y, w6_z, dw6_x, t165,
    ]
    };
    // link 7: motion
    let [
        w7_x, t171, t178, t179, t180, t181, t182, t183,
        t184, t185, t186, t187, t188, t189, t190, t191,
        a7_z, a7_x, a7_y, w7_z, dw7_x, t208,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t171 = c7 * w6_z + s7 * w6_x;
        let t178 = w6_x * w6_x;
        let t179 = w6_y * w6_y;
        let t180 = w6_z * w6_z;
        let t181 = w6_x * w6_y;
        let t182 = w6_x * w6_z;
        let t183 = w6_y * w6_z;
        let t184 = t179 + t180;
        let t185 = t181 - dw6_z;
        let t186 = t182 - t165;
        let t187 = dw6_z + t181;
        let t188 = t178 + t180;
        let t189 = t183 - dw6_x;
        let t190 = t165 + t182;
        let t191 = dw6_x + t183;
        let t195 = a6_x - t185 * k5;
        let a7_z = a6_y + t188 * k5;
        let t197 = t153 + t191 * k5;
        let a7_x = c7 * t195 + s7 * t197;
        let a7_y = c7 * t197 - s7 * t195;
        let w7_z = w6_y + dq7;
        let dw7_x = c7 * dw6_x - s7 * dw6_z - dq7 * t171;
        let t208 = c7 * dw6_z + s7 * dw6_x + dq7 * w7_x;
        [
        w7_x, t171, t178, t179, t180, t181, t182, t183,
        t184, t185, t186, t187, t188, t189, t190, t191,
        a7_z, a7_x, a7_y, w7_z, dw7_x, t208,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t271, t274, t283, t284] = {
        let t209 = w7_x * w7_x;
        let t210 = t171 * t171;
        let t211 = w7_z * w7_z;
        let t212 = w7_x * t171;
        let t213 = w7_x * w7_z;
        let t214 = t171 * w7_z;
        let t216 = t165 - t212;
        let t218 = t165 + t212;
        let t221 = t208 + t213;
        let t222 = dw7_x - t214;
        let t241 = XZ7 * (dw7_x + t214);
        let t246 = YZ7 * (t210 - t211);
        let t247 = YZ7 * t216;
        let t248 = YZ7 * (t213 - t208);
        let t249 = XX7R * dw7_x - ZZ7 * t214 - XY7 * t221 - XZ7 * t218 + t246;
        let t250 = t213 * (XX7R - ZZ7) + XY7 * t222 + XZ7 * (t211 - t209) - t247;
        let t251 = XX7R * t212 - ZZ7 * t165 + XY7 * (t209 - t210) + t241 + t248;
        let f7_x = MSY7 * t216 - MSX7 * (t210 + t211);
        let t257 = MSX7 * t218 + MSY7 * (t209 + t211);
        let f7_z = MSX7 * t221 + MSY7 * t222;
        let n7_x = t249 + MSY7 * a7_z;
        let n7_y = t250 - MSX7 * a7_z;
        let n7_z = t251 + (MSX7 * a7_y - MSY7 * a7_x);
        let t271 = c7 * f7_x + s7 * t257;
        let t274 = s7 * f7_x - c7 * t257;
        let t283 = c7 * n7_x - s7 * n7_y + k5 * t274;
        let t284 = s7 * n7_x + c7 * n7_y - k5 * t271;
        put(6, n7_z);
        [f7_z, n7_z, t271, t274, t283, t284]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t339, t342, t351, t352] = {
        let t306 = ZZ6R * dw6_z - XX6R * t181 + XY6 * (t178 - t179) - XZ6 * t189;
        let t308 = YZ6 * (t179 - t180);
        let t309 = YZ6 * t185;
        let t311 = ZZ6R * t183 + XX6R * dw6_x - XY6 * t190 + XZ6 * t187 + t308;
        let t312 = t182 * (XX6R - ZZ6R) + XY6 * t191 + XZ6 * (t180 - t178) - t309;
        let f6_x = t271 + (MSY6R * t185 - MSX6 * t184);
        let f6_y = f7_z + (MSX6 * t187 - MSY6R * t188);
        let f6_z = MSX6 * t190 + MSY6R * t191 - t274;
        let n6_x = t283 + (t311 - MSY6R * t153);
        let n6_y = n7_z + (t312 + MSX6 * t153);
        let n6_z = t306 + YZ6 * t186 + (MSX6 * a6_y - MSY6R * a6_x) - t284;
        let t339 = c6 * f6_x - s6 * f6_y;
        let t342 = s6 * f6_x + c6 * f6_y;
        let t351 = c6 * n6_x - s6 * n6_y + k4 * t342;
        let t352 = s6 * n6_x + c6 * n6_y - k4 * t339;
        put(5, n6_z);
        [f6_z, n6_z, t339, t342, t351, t352]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t407, t410, t419, t420] = {
        let t374 = XX5R * t138 - ZZ5R * t79 + XY5 * (t135 - t136) + XZ5 * t146;
        let t376 = YZ5 * (t136 - t137);
        let t377 = YZ5 * t142;
        let t379 = XX5R * dw5_x - ZZ5R * t140 - XY5 * t147 - XZ5 * t144 + t376;
        let t380 = t139 * (XX5R - ZZ5R) + XY5 * t148 + XZ5 * (t137 - t135) - t377;
        let f5_x = t339 + (MSY5R * t142 - MSX5 * t141);
        let t400 = f6_z + (MSX5 * t144 + MSY5R * t145);
        let f5_z = t342 + (MSX5 * t147 + MSY5R * t148);
        let n5_x = t351 + (t379 + MSY5R * a5_z);
        let n5_y = t380 - MSX5 * a5_z - n6_z;
        let n5_z = t352 + (t374 + YZ5 * t143 + (MSX5 * a5_y - MSY5R * a5_x));
        let t407 = c5 * f5_x + s5 * t400;
        let t410 = s5 * f5_x - c5 * t400;
        let t419 = c5 * n5_x - s5 * n5_y + k3 * t410;
        let t420 = s5 * n5_x + c5 * n5_y - k3 * t407;
        put(4, n5_z);
        [f5_z, n5_z, t407, t410, t419, t420]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t475, t478, t487, t488] = {
        let t442 = ZZ4R * dw4_z - XX4R * t95 + XY4 * (t92 - t93) - XZ4 * t103;
        let t444 = YZ4 * (t93 - t94);
        let t445 = YZ4 * t99;
        let t447 = ZZ4R * t97 + XX4R * dw4_x - XY4 * t104 + XZ4 * t101 + t444;
        let t448 = t96 * (XX4R - ZZ4R) + XY4 * t105 + XZ4 * (t94 - t92) - t445;
        let f4_x = t407 + (MSY4R * t99 - MSX4 * t98);
        let f4_y = f5_z + (MSX4 * t101 - MSY4R * t102);
        let f4_z = MSX4 * t104 + MSY4R * t105 - t410;
        let n4_x = t419 + (t447 - MSY4R * t67);
        let n4_y = n5_z + (t448 + MSX4 * t67);
        let n4_z = t442 + YZ4 * t100 + (MSX4 * a4_y - MSY4R * a4_x) - t420;
        let t475 = c4 * f4_x - s4 * f4_y;
        let t478 = s4 * f4_x + c4 * f4_y;
        let t487 = c4 * n4_x - s4 * n4_y + k2 * t478;
        let t488 = s4 * n4_x + c4 * n4_y - k2 * t475;
        put(3, n4_z);
        [f4_z, n4_z, t475, t478, t487, t488]
    };
    // link 3: force and moment
    let [f3_z, n3_z, t543, t555, t556] = {
        let t510 = XX3R * t52 - ZZ3R * t5 + XY3 * (t49 - t50) + XZ3 * t60;
        let t512 = YZ3 * (t50 - t51);
        let t513 = YZ3 * t56;
        let t515 = XX3R * dw3_x - ZZ3R * t54 - XY3 * t61 - XZ3 * t58 + t512;
        let t516 = t53 * (XX3R - ZZ3R) + XY3 * t62 + XZ3 * (t51 - t49) - t513;
        let f3_x = t475 + (MSY3R * t56 - MSX3 * t55);
        let t536 = f4_z + (MSX3 * t58 + MSY3R * t59);
        let f3_z = t478 + (MSX3 * t61 + MSY3R * t62);
        let n3_x = t487 + (t515 + MSY3R * a3_z);
        let n3_y = t516 - MSX3 * a3_z - n4_z;
        let n3_z = t488 + (t510 + YZ3 * t57 + (MSX3 * a3_y + MSY3R * t28));
        let t543 = c3 * f3_x + s3 * t536;
        let t555 = c3 * n3_x - s3 * n3_y + k1 * (s3 * f3_x - c3 * t536);
        let t556 = s3 * n3_x + c3 * n3_y - k1 * t543;
        put(2, n3_z);
        [f3_z, n3_z, t543, t555, t556]
    };
    // link 2: force and moment
    {
        let t575 = YZ2 * (t15 - t16);
        let t576 = YZ2 * t17;
        let t578 = t5 * (XX2R - ZZ2R) + XY2 * t21 + XZ2 * (t16 - t14) - t576;
        let t585 = MSY2R * a2_z;
        let t587 = dw2_x * (XX2R + ZZ2R) - XY2 * t20 + XZ2 * t17 + t575 + t585;
        let f2_x = t543 + (MSY2R * t17 - MSX2 * t18);
        let f2_y = f3_z + (MSX2 * t17 - MSY2R * t19);
        let n2_x = t555 + t587;
        let n2_y = n3_z + (t578 - MSX2 * a2_z);
        let n2_z = XY2 * (t14 - t15) - XX2R * t17 - t556;
        let f1_x = c2 * f2_x - s2 * f2_y;
        let n1_z = s2 * n2_x + c2 * n2_y - k0 * f1_x;
        put(0, n1_z);
        put(1, n2_z);
    }
}
