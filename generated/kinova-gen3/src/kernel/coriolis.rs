//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 300 multiplications, 280 additions; 7, 7 of 7 structurally nonzero.

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
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [
        w2_x, w2_y, a2_z, t6, t7, dw2_x, t9, t10,
        t11, t12, t13,
    ] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let a2_z = t0 * k0;
        let t4 = w2_x * w2_x;
        let t5 = dq2 * dq2;
        let t6 = w2_x * w2_y;
        let t7 = dq2 * w2_x;
        let dw2_x = dq2 * w2_y;
        let t9 = t4 - t5;
        let t10 = t9 - t0;
        let t11 = t4 + t5;
        let t12 = t7 + t7;
        let t13 = dw2_x + dw2_x;
        [
        w2_x, w2_y, a2_z, t6, t7, dw2_x, t9, t10,
        t11, t12, t13,
    ]
    };
    // link 3: motion
    let [
        w3_x, t19, a3_z, t26, a3_y, t32, t35, w3_z,
        t39, t40, t41, dw3_x, dw3_y, t44, t45, t46,
        t47, t48, t49, t50,
    ] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t19 = c3 * dq2 + s3 * w2_x;
        let t20 = t6 * k1;
        let a3_z = t11 * k1;
        let t23 = a2_z - t13 * k1;
        let t26 = c3 * t20 + s3 * t23;
        let a3_y = s3 * t20 - c3 * t23;
        let t32 = c3 * t6 - s3 * t13;
        let t35 = c3 * t13 + s3 * t6;
        let w3_z = w2_y + dq3;
        let t37 = w3_x * w3_x;
        let t38 = w3_z * w3_z;
        let t39 = w3_x * t19;
        let t40 = w3_x * w3_z;
        let t41 = t19 * w3_z;
        let dw3_x = t35 - t41;
        let dw3_y = t32 - t40;
        let t44 = t37 - t38;
        let t45 = t44 - t11;
        let t46 = t7 - t39;
        let t47 = t7 + t39;
        let t48 = t37 + t38;
        let t49 = t40 - dw3_y;
        let t50 = dw3_x - t41;
        [
        w3_x, t19, a3_z, t26, a3_y, t32, t35, w3_z,
        t39, t40, t41, dw3_x, dw3_y, t44, t45, t46,
        t47, t48, t49, t50,
    ]
    };
    // link 4: motion
    let [
        w4_x, w4_y, t61, a4_x, a4_y, t71, t74, w4_z,
        t78, t79, t80, dw4_x, t82, t83, t84, t85,
        t86, t87, t88, t89,
    ] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t60 = t46 * k2 - t26;
        let t61 = a3_y - t48 * k2;
        let t62 = a3_z + t50 * k2;
        let a4_x = c4 * t60 + s4 * t62;
        let a4_y = c4 * t62 - s4 * t60;
        let t71 = c4 * t46 + s4 * t50;
        let t74 = s4 * t46 - c4 * t50;
        let w4_z = t19 + dq4;
        let t76 = w4_x * w4_x;
        let t77 = w4_z * w4_z;
        let t78 = w4_x * w4_y;
        let t79 = w4_x * w4_z;
        let t80 = w4_y * w4_z;
        let dw4_x = t80 - t74;
        let t82 = t71 + t79;
        let t83 = t76 - t77;
        let t84 = t83 - t48;
        let t85 = dw3_y + t78;
        let t86 = t78 - dw3_y;
        let t87 = t76 + t77;
        let t88 = t79 + t82;
        let t89 = t80 + dw4_x;
        [
        w4_x, w4_y, t61, a4_x, a4_y, t71, t74, w4_z,
        t78, t79, t80, dw4_x, t82, t83, t84, t85,
        t86, t87, t88, t89,
    ]
    };
    // link 5: motion
    let [
        w5_x, t95, a5_z, a5_x, a5_y, t110, t113, w5_z,
        t117, t118, t119, dw5_x, dw5_y, t122, t123, t124,
        t125, t126, t127, t128,
    ] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t95 = c5 * w4_z + s5 * w4_x;
        let t99 = a4_x - t85 * k3;
        let a5_z = a4_y + t87 * k3;
        let t101 = t61 + t89 * k3;
        let a5_x = c5 * t99 + s5 * t101;
        let a5_y = c5 * t101 - s5 * t99;
        let t110 = c5 * t85 - s5 * t89;
        let t113 = c5 * t89 + s5 * t85;
        let w5_z = w4_y + dq5;
        let t115 = w5_x * w5_x;
        let t116 = w5_z * w5_z;
        let t117 = w5_x * t95;
        let t118 = w5_x * w5_z;
        let t119 = t95 * w5_z;
        let dw5_x = t113 - t119;
        let dw5_y = t110 - t118;
        let t122 = t115 - t116;
        let t123 = t122 - t87;
        let t124 = t82 - t117;
        let t125 = t82 + t117;
        let t126 = t115 + t116;
        let t127 = t118 - dw5_y;
        let t128 = dw5_x - t119;
        [
        w5_x, t95, a5_z, a5_x, a5_y, t110, t113, w5_z,
        t117, t118, t119, dw5_x, dw5_y, t122, t123, t124,
        t125, t126, t127, t128,
    ]
    };
    // link 6: motion
    let [
        w6_x, w6_y, t139, a6_x, a6_y, t149, t152, w6_z,
        t156, t157, t158, dw6_x, t160, t161, t162, t163,
        t164, t165, t166, t167,
    ] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t138 = a5_x + t124 * k4;
        let t139 = a5_y - t126 * k4;
        let t140 = a5_z + t128 * k4;
        let a6_x = c6 * t138 + s6 * t140;
        let a6_y = c6 * t140 - s6 * t138;
        let t149 = c6 * t124 + s6 * t128;
        let t152 = s6 * t124 - c6 * t128;
        let w6_z = t95 + dq6;
        let t154 = w6_x * w6_x;
        let t155 = w6_z * w6_z;
        let t156 = w6_x * w6_y;
        let t157 = w6_x * w6_z;
        let t158 = w6_y * w6_z;
        let dw6_x = t158 - t152;
        let t160 = t149 + t157;
        let t161 = t154 - t155;
        let t162 = t161 - t126;
        let t163 = dw5_y + t156;
        let t164 = t156 - dw5_y;
        let t165 = t154 + t155;
        let t166 = t157 + t160;
        let t167 = t158 + dw6_x;
        [
        w6_x, w6_y, t139, a6_x, a6_y, t149, t152, w6_z,
        t156, t157, t158, dw6_x, t160, t161, t162, t163,
        t164, t165, t166, t167,
    ]
    };
    // link 7: motion
    let [
        a7_z, a7_x, a7_y, t188, t191, t195, t196, t197,
        dw7_x, t200, t201, t202, t203, t204, t205, t206,
    ] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t173 = c7 * w6_z + s7 * w6_x;
        let t177 = a6_x - t163 * k5;
        let a7_z = a6_y + t165 * k5;
        let t179 = t139 + t167 * k5;
        let a7_x = c7 * t177 + s7 * t179;
        let a7_y = c7 * t179 - s7 * t177;
        let t188 = c7 * t163 - s7 * t167;
        let t191 = c7 * t167 + s7 * t163;
        let w7_z = w6_y + dq7;
        let t193 = w7_x * w7_x;
        let t194 = w7_z * w7_z;
        let t195 = w7_x * t173;
        let t196 = w7_x * w7_z;
        let t197 = t173 * w7_z;
        let dw7_x = t191 - t197;
        let dw7_y = t188 - t196;
        let t200 = t193 - t194;
        let t201 = t200 - t165;
        let t202 = t160 - t195;
        let t203 = t160 + t195;
        let t204 = t193 + t194;
        let t205 = t196 - dw7_y;
        let t206 = dw7_x - t197;
        [
        a7_z, a7_x, a7_y, t188, t191, t195, t196, t197,
        dw7_x, t200, t201, t202, t203, t204, t205, t206,
    ]
    };
    // link 7: force and moment
    let [f7_z, n7_z, t254, t257, t266, t267] = {
        let t227 = XX7R * t195 - ZZ7 * t160 + XY7 * (t201 + t204) + XZ7 * t191;
        let t229 = YZ7 * (t165 - t204);
        let t232 = XX7R * dw7_x - ZZ7 * t197 - XY7 * t205 - XZ7 * t203 + t229;
        let t233 = t196 * (XX7R - ZZ7) + XY7 * t206 - XZ7 * t200 - YZ7 * t202;
        let f7_x = MSX7 * t201 + MSY7 * t202;
        let t240 = MSX7 * t203 + MSY7 * t204;
        let f7_z = MSX7 * t205 + MSY7 * t206;
        let n7_x = t232 + MSY7 * a7_z;
        let n7_y = t233 - MSX7 * a7_z;
        let n7_z = t227 + YZ7 * t188 + (MSX7 * a7_y - MSY7 * a7_x);
        let t254 = c7 * f7_x + s7 * t240;
        let t257 = s7 * f7_x - c7 * t240;
        let t266 = c7 * n7_x - s7 * n7_y + k5 * t257;
        let t267 = s7 * n7_x + c7 * n7_y - k5 * t254;
        put(6, n7_z);
        [f7_z, n7_z, t254, t257, t266, t267]
    };
    // link 6: force and moment
    let [f6_z, n6_z, t321, t324, t333, t334] = {
        let t288 = XY6 * (t162 + t165) - (XX6R * t156 + ZZ6R * dw5_y) - XZ6 * t152;
        let t290 = YZ6 * (t126 - t165);
        let t293 = ZZ6R * t158 + XX6R * dw6_x - XY6 * t166 + XZ6 * t164 + t290;
        let t294 = t157 * (XX6R - ZZ6R) + XY6 * t167 - XZ6 * t161 - YZ6 * t163;
        let f6_x = t254 + (MSX6 * t162 + MSY6R * t163);
        let f6_y = f7_z + (MSX6 * t164 - MSY6R * t165);
        let f6_z = MSX6 * t166 + MSY6R * t167 - t257;
        let n6_x = t266 + (t293 - MSY6R * t139);
        let n6_y = n7_z + (t294 + MSX6 * t139);
        let n6_z = t288 - YZ6 * t149 + (MSX6 * a6_y - MSY6R * a6_x) - t267;
        let t321 = c6 * f6_x - s6 * f6_y;
        let t324 = s6 * f6_x + c6 * f6_y;
        let t333 = c6 * n6_x - s6 * n6_y + k4 * t324;
        let t334 = s6 * n6_x + c6 * n6_y - k4 * t321;
        put(5, n6_z);
        [f6_z, n6_z, t321, t324, t333, t334]
    };
    // link 5: force and moment
    let [f5_z, n5_z, t388, t391, t400, t401] = {
        let t355 = XX5R * t117 - ZZ5R * t82 + XY5 * (t123 + t126) + XZ5 * t113;
        let t357 = YZ5 * (t87 - t126);
        let t360 = XX5R * dw5_x - ZZ5R * t119 - XY5 * t127 - XZ5 * t125 + t357;
        let t361 = t118 * (XX5R - ZZ5R) + XY5 * t128 - XZ5 * t122 - YZ5 * t124;
        let f5_x = t321 + (MSX5 * t123 + MSY5R * t124);
        let t381 = f6_z + (MSX5 * t125 + MSY5R * t126);
        let f5_z = t324 + (MSX5 * t127 + MSY5R * t128);
        let n5_x = t333 + (t360 + MSY5R * a5_z);
        let n5_y = t361 - MSX5 * a5_z - n6_z;
        let n5_z = t334 + (t355 + YZ5 * t110 + (MSX5 * a5_y - MSY5R * a5_x));
        let t388 = c5 * f5_x + s5 * t381;
        let t391 = s5 * f5_x - c5 * t381;
        let t400 = c5 * n5_x - s5 * n5_y + k3 * t391;
        let t401 = s5 * n5_x + c5 * n5_y - k3 * t388;
        put(4, n5_z);
        [f5_z, n5_z, t388, t391, t400, t401]
    };
    // link 4: force and moment
    let [f4_z, n4_z, t455, t458, t467, t468] = {
        let t422 = XY4 * (t84 + t87) - (XX4R * t78 + ZZ4R * dw3_y) - XZ4 * t74;
        let t424 = YZ4 * (t48 - t87);
        let t427 = ZZ4R * t80 + XX4R * dw4_x - XY4 * t88 + XZ4 * t86 + t424;
        let t428 = t79 * (XX4R - ZZ4R) + XY4 * t89 - XZ4 * t83 - YZ4 * t85;
        let f4_x = t388 + (MSX4 * t84 + MSY4R * t85);
        let f4_y = f5_z + (MSX4 * t86 - MSY4R * t87);
        let f4_z = MSX4 * t88 + MSY4R * t89 - t391;
        let n4_x = t400 + (t427 - MSY4R * t61);
        let n4_y = n5_z + (t428 + MSX4 * t61);
        let n4_z = t422 - YZ4 * t71 + (MSX4 * a4_y - MSY4R * a4_x) - t401;
        let t455 = c4 * f4_x - s4 * f4_y;
        let t458 = s4 * f4_x + c4 * f4_y;
        let t467 = c4 * n4_x - s4 * n4_y + k2 * t458;
        let t468 = s4 * n4_x + c4 * n4_y - k2 * t455;
        put(3, n4_z);
        [f4_z, n4_z, t455, t458, t467, t468]
    };
    // link 3: force and moment
    let [f3_z, n3_z, t522, t534, t535] = {
        let t489 = XX3R * t39 - ZZ3R * t7 + XY3 * (t45 + t48) + XZ3 * t35;
        let t491 = YZ3 * (t11 - t48);
        let t494 = XX3R * dw3_x - ZZ3R * t41 - XY3 * t49 - XZ3 * t47 + t491;
        let t495 = t40 * (XX3R - ZZ3R) + XY3 * t50 - XZ3 * t44 - YZ3 * t46;
        let f3_x = t455 + (MSX3 * t45 + MSY3R * t46);
        let t515 = f4_z + (MSX3 * t47 + MSY3R * t48);
        let f3_z = t458 + (MSX3 * t49 + MSY3R * t50);
        let n3_x = t467 + (t494 + MSY3R * a3_z);
        let n3_y = t495 - MSX3 * a3_z - n4_z;
        let n3_z = t468 + (t489 + YZ3 * t32 + (MSX3 * a3_y + MSY3R * t26));
        let t522 = c3 * f3_x + s3 * t515;
        let t534 = c3 * n3_x - s3 * n3_y + k1 * (s3 * f3_x - c3 * t515);
        let t535 = s3 * n3_x + c3 * n3_y - k1 * t522;
        put(2, n3_z);
        [f3_z, n3_z, t522, t534, t535]
    };
    // link 2: force and moment
    {
        let t553 = YZ2 * (t0 - t11);
        let t556 = t7 * (XX2R - ZZ2R) + XY2 * t13 - XZ2 * t9 - YZ2 * t6;
        let t563 = MSY2R * a2_z;
        let t565 = dw2_x * (XX2R + ZZ2R) - XY2 * t12 + XZ2 * t6 + t553 + t563;
        let f2_x = t522 + (MSX2 * t10 + MSY2R * t6);
        let f2_y = f3_z + (MSX2 * t6 - MSY2R * t11);
        let n2_x = t534 + t565;
        let n2_y = n3_z + (t556 - MSX2 * a2_z);
        let n2_z = XY2 * (t10 + t11) - XX2R * t6 - t535;
        let f1_x = c2 * f2_x - s2 * f2_y;
        let n1_z = s2 * n2_x + c2 * n2_y - k0 * f1_x;
        put(0, n1_z);
        put(1, n2_z);
    }
}
