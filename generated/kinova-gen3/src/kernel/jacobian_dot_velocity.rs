//! Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq`.
//!
//! In base axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
//!
//! 188 multiplications, 109 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig};

/// Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq`: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 6]) {
    entries(trig, dq, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], mut put: impl FnMut(usize, S)) {
    let [s1, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [c1, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
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
    let [w3_x, t11, a3_z, t25, a3_y, w3_z, dw3_x, dw4_z] = {
        let w3_x = c3 * w2_x - s3 * dq2;
        let t11 = c3 * dq2 + s3 * w2_x;
        let t19 = w2_x * w2_y * k1;
        let a3_z = (w2_x * w2_x + dq2 * dq2) * k1;
        let t22 = a2_z - (dw2_x + dw2_x) * k1;
        let t25 = c3 * t19 + s3 * t22;
        let a3_y = s3 * t19 - c3 * t22;
        let w3_z = w2_y + dq3;
        let dw3_x = c3 * dw2_x - dq3 * t11;
        let dw4_z = s3 * dw2_x + dq3 * w3_x;
        [w3_x, t11, a3_z, t25, a3_y, w3_z, dw3_x, dw4_z]
    };
    // link 4: motion
    let [w4_x, w4_y, t57, a4_x, a4_y, w4_z, dw4_x, t69] = {
        let w4_x = c4 * w3_x + s4 * w3_z;
        let w4_y = c4 * w3_z - s4 * w3_x;
        let t56 = (t5 - w3_x * t11) * k2 - t25;
        let t57 = a3_y - (w3_x * w3_x + w3_z * w3_z) * k2;
        let t58 = a3_z + (dw3_x - t11 * w3_z) * k2;
        let a4_x = c4 * t56 + s4 * t58;
        let a4_y = c4 * t58 - s4 * t56;
        let w4_z = t11 + dq4;
        let dw4_x = c4 * dw3_x - s4 * t5 + dq4 * w4_y;
        let t69 = c4 * t5 + s4 * dw3_x + dq4 * w4_x;
        [w4_x, w4_y, t57, a4_x, a4_y, w4_z, dw4_x, t69]
    };
    // link 5: motion
    let [w5_x, t75, a5_z, a5_x, a5_y, w5_z, dw5_x, dw6_z] = {
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t75 = c5 * w4_z + s5 * w4_x;
        let t92 = a4_x - (w4_x * w4_y - dw4_z) * k3;
        let a5_z = a4_y + (w4_x * w4_x + w4_z * w4_z) * k3;
        let t94 = t57 + (dw4_x + w4_y * w4_z) * k3;
        let a5_x = c5 * t92 + s5 * t94;
        let a5_y = c5 * t94 - s5 * t92;
        let w5_z = w4_y + dq5;
        let dw5_x = c5 * dw4_x - s5 * dw4_z - dq5 * t75;
        let dw6_z = c5 * dw4_z + s5 * dw4_x + dq5 * w5_x;
        [w5_x, t75, a5_z, a5_x, a5_y, w5_z, dw5_x, dw6_z]
    };
    // link 6: motion
    let [w6_x, w6_y, t129, a6_x, a6_y, w6_z, dw6_x, t141] = {
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t128 = a5_x + (t69 - w5_x * t75) * k4;
        let t129 = a5_y - (w5_x * w5_x + w5_z * w5_z) * k4;
        let t130 = a5_z + (dw5_x - t75 * w5_z) * k4;
        let a6_x = c6 * t128 + s6 * t130;
        let a6_y = c6 * t130 - s6 * t128;
        let w6_z = t75 + dq6;
        let dw6_x = c6 * dw5_x - s6 * t69 + dq6 * w6_y;
        let t141 = c6 * t69 + s6 * dw5_x + dq6 * w6_x;
        [w6_x, w6_y, t129, a6_x, a6_y, w6_z, dw6_x, t141]
    };
    // link 7: motion
    let [a7_z, a7_x, a7_y, dw7_x, t176] = {
        let w7_x = c7 * w6_x - s7 * w6_z;
        let t164 = a6_x - (w6_x * w6_y - dw6_z) * k5;
        let a7_z = a6_y + (w6_x * w6_x + w6_z * w6_z) * k5;
        let t166 = t129 + (dw6_x + w6_y * w6_z) * k5;
        let a7_x = c7 * t164 + s7 * t166;
        let a7_y = c7 * t166 - s7 * t164;
        let dw7_x = c7 * dw6_x - s7 * dw6_z - dq7 * (c7 * w6_z + s7 * w6_x);
        let t176 = c7 * dw6_z + s7 * dw6_x + dq7 * w7_x;
        [a7_z, a7_x, a7_y, dw7_x, t176]
    };
    // frame 2
    let [t177, t178, t179, t180] = {
        let t177 = c1 * c2;
        let t178 = c1 * s2;
        let t179 = s1 * c2;
        let t180 = s1 * s2;
        [t177, t178, t179, t180]
    };
    // frame 3
    let [t183, t186, t189, t192, t193, t194] = {
        let t183 = c3 * t177 - s1 * s3;
        let t186 = s1 * c3 + s3 * t177;
        let t189 = c3 * t179 + c1 * s3;
        let t192 = s3 * t179 - c1 * c3;
        let t193 = s2 * c3;
        let t194 = s2 * s3;
        [t183, t186, t189, t192, t193, t194]
    };
    // frame 4
    let [t197, t200, t203, t206, t209, t212] = {
        let t197 = c4 * t183 - s4 * t178;
        let t200 = c4 * t178 + s4 * t183;
        let t203 = s4 * t180 - c4 * t189;
        let t206 = c4 * t180 + s4 * t189;
        let t209 = c4 * t193 + c2 * s4;
        let t212 = s4 * t193 - c2 * c4;
        [t197, t200, t203, t206, t209, t212]
    };
    // frame 5
    let [t215, t218, t221, t224, t227, t230] = {
        let t215 = c5 * t197 - s5 * t186;
        let t218 = c5 * t186 + s5 * t197;
        let t221 = c5 * t203 + s5 * t192;
        let t224 = c5 * t192 - s5 * t203;
        let t227 = s5 * t194 - c5 * t209;
        let t230 = c5 * t194 + s5 * t209;
        [t215, t218, t221, t224, t227, t230]
    };
    // frame 6
    let [t233, t236, t239, t242, t245, t248] = {
        let t233 = c6 * t215 - s6 * t200;
        let t236 = c6 * t200 + s6 * t215;
        let t239 = c6 * t221 + s6 * t206;
        let t242 = c6 * t206 - s6 * t221;
        let t245 = c6 * t227 + s6 * t212;
        let t248 = c6 * t212 - s6 * t227;
        [t233, t236, t239, t242, t245, t248]
    };
    // frame 7
    let [t251, t254, t257, t260, t263, t266] = {
        let t251 = c7 * t233 - s7 * t218;
        let t254 = c7 * t218 + s7 * t233;
        let t257 = c7 * t239 + s7 * t224;
        let t260 = c7 * t224 - s7 * t239;
        let t263 = c7 * t245 + s7 * t230;
        let t266 = c7 * t230 - s7 * t245;
        [t251, t254, t257, t260, t263, t266]
    };
    // in base axes
    {
        let t271 = a7_x * t251 - a7_y * t254 - a7_z * t236;
        let t276 = a7_z * t242 + (a7_x * t257 + a7_y * t260);
        let t281 = a7_z * t248 + (a7_x * t263 + a7_y * t266);
        let t286 = t141 * t236 + (dw7_x * t251 + t176 * t254);
        let t291 = dw7_x * t257 - t176 * t260 - t141 * t242;
        let t296 = dw7_x * t263 - t176 * t266 - t141 * t248;
        put(0, t271);
        put(1, t276);
        put(2, t281);
        put(3, t286);
        put(4, t291);
        put(5, t296);
    }
}
