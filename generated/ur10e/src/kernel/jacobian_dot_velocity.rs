//! Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq`.
//!
//! In base axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
//!
//! 158 multiplications, 91 additions; 6, 6 of 6 structurally nonzero.

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
    let [s1, s2, s3, s4, s5, s6] = trig.sin;
    let [c1, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let D4 = S::constant(0.17415);
    let D5 = S::constant(0.11985);
    let D6 = S::constant(0.11655);
    let k0 = S::constant(0.6127);
    let k1 = S::constant(0.57155);
    // link 2: motion
    let [w2_x, w2_y, dw2_x, t3] = {
        let w2_x = s2 * dq1;
        let w2_y = c2 * dq1;
        let dw2_x = dq2 * w2_y;
        let t3 = dq2 * w2_x;
        [w2_x, w2_y, dw2_x, t3]
    };
    // link 3: motion
    let [w3_x, w3_y, t23, a3_x, t29, w3_z, dw3_x, t34] = {
        let w3_x = c3 * w2_x + s3 * w2_y;
        let w3_y = c3 * w2_y - s3 * w2_x;
        let t21 = (w2_y * w2_y + dq2 * dq2) * k0;
        let t22 = w2_x * w2_y * k0;
        let t23 = (t3 + t3) * k0;
        let a3_x = c3 * t21 - s3 * t22;
        let t29 = c3 * t22 + s3 * t21;
        let w3_z = dq2 + dq3;
        let dw3_x = c3 * dw2_x - s3 * t3 + dq3 * w3_y;
        let t34 = c3 * t3 + s3 * dw2_x + dq3 * w3_x;
        [w3_x, w3_y, t23, a3_x, t29, w3_z, dw3_x, t34]
    };
    // link 4: motion
    let [w4_x, w4_y, t69, a4_x, a4_y, w4_z, dw4_x, dw5_z] = {
        let w4_x = c4 * w3_x + s4 * w3_y;
        let w4_y = c4 * w3_y - s4 * w3_x;
        let t48 = w3_y * w3_y;
        let t51 = w3_x * w3_z;
        let t67 = a3_x + ((t48 + w3_z * w3_z) * k1 + D4 * (t51 - t34));
        let t68 = D4 * (w3_y * w3_z - dw3_x) - w3_x * w3_y * k1 - t29;
        let t69 = t23 + ((t34 + t51) * k1 + D4 * (w3_x * w3_x + t48));
        let a4_x = c4 * t67 + s4 * t68;
        let a4_y = c4 * t68 - s4 * t67;
        let w4_z = w3_z + dq4;
        let dw4_x = c4 * dw3_x - s4 * t34 + dq4 * w4_y;
        let dw5_z = c4 * t34 + s4 * dw3_x + dq4 * w4_x;
        [w4_x, w4_y, t69, a4_x, a4_y, w4_z, dw4_x, dw5_z]
    };
    // link 5: motion
    let [w5_x, w5_y, t99, a5_x, t106, w5_z, dw5_x, t111] = {
        let w5_x = c5 * w4_x + s5 * w4_z;
        let w5_y = c5 * w4_z - s5 * w4_x;
        let t98 = a4_x - D5 * (w4_x * w4_y);
        let t99 = a4_y + D5 * (w4_x * w4_x + w4_z * w4_z);
        let t100 = t69 + D5 * (dw4_x + w4_y * w4_z);
        let a5_x = c5 * t98 - s5 * t100;
        let t106 = c5 * t100 + s5 * t98;
        let w5_z = dq5 - w4_y;
        let dw5_x = c5 * dw4_x + dq5 * w5_y;
        let t111 = s5 * dw4_x + dq5 * w5_x;
        [w5_x, w5_y, t99, a5_x, t106, w5_z, dw5_x, t111]
    };
    // link 6: motion
    let [t135, a6_x, t142, dw6_x, t146] = {
        let w6_x = c6 * w5_x - s6 * w5_z;
        let t134 = a5_x + D6 * (w5_x * w5_y - dw5_z);
        let t135 = t106 + D6 * (w5_x * w5_x + w5_z * w5_z);
        let t136 = D6 * (dw5_x + w5_y * w5_z) - t99;
        let a6_x = c6 * t134 - s6 * t136;
        let t142 = c6 * t136 + s6 * t134;
        let dw6_x = c6 * dw5_x - s6 * dw5_z - dq6 * (c6 * w5_z + s6 * w5_x);
        let t146 = c6 * dw5_z + s6 * dw5_x + dq6 * w6_x;
        [t135, a6_x, t142, dw6_x, t146]
    };
    // frame 2
    let [t147, t148, t149, t150] = {
        let t147 = c1 * c2;
        let t148 = c1 * s2;
        let t149 = s1 * c2;
        let t150 = s1 * s2;
        [t147, t148, t149, t150]
    };
    // frame 3
    let [t153, t156, t159, t162, t165, t168] = {
        let t153 = c3 * t147 - s3 * t148;
        let t156 = c3 * t148 + s3 * t147;
        let t159 = c3 * t149 - s3 * t150;
        let t162 = c3 * t150 + s3 * t149;
        let t165 = s2 * c3 + c2 * s3;
        let t168 = c2 * c3 - s2 * s3;
        [t153, t156, t159, t162, t165, t168]
    };
    // frame 4
    let [t171, t174, t177, t180, t183, t186] = {
        let t171 = c4 * t153 - s4 * t156;
        let t174 = c4 * t156 + s4 * t153;
        let t177 = c4 * t159 - s4 * t162;
        let t180 = c4 * t162 + s4 * t159;
        let t183 = c4 * t165 + s4 * t168;
        let t186 = c4 * t168 - s4 * t165;
        [t171, t174, t177, t180, t183, t186]
    };
    // frame 5
    let [t189, t192, t195, t198, t199, t200] = {
        let t189 = c5 * t171 + s1 * s5;
        let t192 = s1 * c5 - s5 * t171;
        let t195 = c5 * t177 - c1 * s5;
        let t198 = c1 * c5 + s5 * t177;
        let t199 = c5 * t183;
        let t200 = s5 * t183;
        [t189, t192, t195, t198, t199, t200]
    };
    // frame 6
    let [t203, t206, t209, t212, t215, t218] = {
        let t203 = c6 * t189 - s6 * t174;
        let t206 = c6 * t174 + s6 * t189;
        let t209 = c6 * t195 - s6 * t180;
        let t212 = c6 * t180 + s6 * t195;
        let t215 = c6 * t199 + s6 * t186;
        let t218 = c6 * t186 - s6 * t199;
        [t203, t206, t209, t212, t215, t218]
    };
    // in base axes
    {
        let t223 = a6_x * t203 + t142 * t206 - t135 * t192;
        let t228 = t135 * t198 + (a6_x * t209 + t142 * t212);
        let t233 = t135 * t200 + (a6_x * t215 - t142 * t218);
        let t238 = dw6_x * t203 + t146 * t206 - t111 * t192;
        let t243 = t111 * t198 + (dw6_x * t209 + t146 * t212);
        let t248 = t111 * t200 + (dw6_x * t215 - t146 * t218);
        put(0, t223);
        put(1, t228);
        put(2, t233);
        put(3, t238);
        put(4, t243);
        put(5, t248);
    }
}
