//! Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq`.
//!
//! In base axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
//!
//! 118 multiplications, 63 additions; 6, 6 of 6 structurally nonzero.

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
    let [_, _, q3, ..] = trig.q;
    let [s1, s2, _, s4, s5, s6] = trig.sin;
    let [c1, c2, _, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
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
    let [t12, t18, a3_y] = {
        let t12 = q3 * (t0 * t0 + dq2 * dq2);
        let t15 = dq3 * k1;
        let t18 = q3 * (t4 + t4) - t3 + t0 * t15;
        let a3_y = dq2 * t15 - q3 * (t0 * w3_z);
        [t12, t18, a3_y]
    };
    // link 4: motion
    let [t22, w4_y, a4_x, a4_y, w4_z, dw4_x, dw4_y] = {
        let t22 = c4 * dq2 + s4 * t0;
        let w4_y = s4 * dq2 - c4 * t0;
        let a4_x = s4 * a3_y - c4 * t18;
        let a4_y = c4 * a3_y + s4 * t18;
        let w4_z = w3_z + dq4;
        let dw4_x = dq4 * w4_y - s4 * t4;
        let dw4_y = dq4 * t22 - c4 * t4;
        [t22, w4_y, a4_x, a4_y, w4_z, dw4_x, dw4_y]
    };
    // link 5: motion
    let [t41, w5_y, a5_x, a5_y, w5_z, dw5_x, dw5_y] = {
        let t41 = c5 * t22 + s5 * w4_z;
        let w5_y = s5 * t22 - c5 * w4_z;
        let a5_x = c5 * a4_x + s5 * t12;
        let a5_y = c5 * t12 - s5 * a4_x;
        let w5_z = w4_y + dq5;
        let dw5_x = c5 * dw4_x + s5 * dw2_y + dq5 * w5_y;
        let dw5_y = c5 * dw2_y - s5 * dw4_x + dq5 * t41;
        [t41, w5_y, a5_x, a5_y, w5_z, dw5_x, dw5_y]
    };
    // link 6: motion
    let [t85, a6_x, a6_y, dw6_x, dw6_y] = {
        let w6_x = s6 * w5_z - c6 * t41;
        let w6_y = c6 * w5_z + s6 * t41;
        let t84 = a5_x + D6 * (dw4_y + t41 * w5_y);
        let t85 = a5_y + D6 * (t41 * t41 + w5_z * w5_z);
        let t86 = a4_y - D6 * (dw5_x + w5_y * w5_z);
        let a6_x = c6 * t84 + s6 * t86;
        let a6_y = c6 * t86 - s6 * t84;
        let dw6_x = c6 * dw5_x + s6 * dw4_y + dq6 * w6_y;
        let dw6_y = c6 * dw4_y - s6 * dw5_x - dq6 * w6_x;
        [t85, a6_x, a6_y, dw6_x, dw6_y]
    };
    // frame 2
    let [t97, t98, t99, t100] = {
        let t97 = c1 * c2;
        let t98 = c1 * s2;
        let t99 = s1 * c2;
        let t100 = s1 * s2;
        [t97, t98, t99, t100]
    };
    // frame 4
    let [t103, t106, t109, t112, t113, t114] = {
        let t103 = s1 * c4 + s4 * t97;
        let t106 = c4 * t97 - s1 * s4;
        let t109 = s4 * t99 - c1 * c4;
        let t112 = c4 * t99 + c1 * s4;
        let t113 = s2 * s4;
        let t114 = s2 * c4;
        [t103, t106, t109, t112, t113, t114]
    };
    // frame 5
    let [t117, t120, t123, t126, t129, t132] = {
        let t117 = c5 * t103 - s5 * t98;
        let t120 = c5 * t98 + s5 * t103;
        let t123 = c5 * t109 - s5 * t100;
        let t126 = c5 * t100 + s5 * t109;
        let t129 = c5 * t113 + c2 * s5;
        let t132 = s5 * t113 - c2 * c5;
        [t117, t120, t123, t126, t129, t132]
    };
    // frame 6
    let [t135, t138, t141, t144, t147, t150] = {
        let t135 = c6 * t117 + s6 * t106;
        let t138 = c6 * t106 - s6 * t117;
        let t141 = c6 * t123 + s6 * t112;
        let t144 = c6 * t112 - s6 * t123;
        let t147 = c6 * t129 + s6 * t114;
        let t150 = s6 * t129 - c6 * t114;
        [t135, t138, t141, t144, t147, t150]
    };
    // in base axes
    {
        let t155 = a6_x * t135 + a6_y * t138 - t85 * t120;
        let t160 = a6_x * t141 + a6_y * t144 - t85 * t126;
        let t165 = t85 * t132 + (a6_y * t150 - a6_x * t147);
        let t170 = dw6_x * t135 + dw6_y * t138 - dw5_y * t120;
        let t175 = dw6_x * t141 + dw6_y * t144 - dw5_y * t126;
        let t180 = dw5_y * t132 + (dw6_y * t150 - dw6_x * t147);
        put(0, t155);
        put(1, t160);
        put(2, t165);
        put(3, t170);
        put(4, t175);
        put(5, t180);
    }
}
