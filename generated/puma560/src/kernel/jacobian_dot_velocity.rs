//! Acceleration of the last DH frame at zero `ddq`: `dJ/dt dq`.
//!
//! In world axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
//!
//! 141 multiplications, 84 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, Trig, constants};

/// Acceleration of the last DH frame at zero `ddq`: `dJ/dt dq`: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 6]) {
    entries(trig, dq, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], mut put: impl FnMut(usize, S)) {
    let [s1, s2, s3, s4, s5, s6] = trig.sin;
    let [c1, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let k2 = S::constant(-constants::D3);
    let k3 = S::constant(-constants::A3);
    let k_A2 = S::constant(constants::A2);
    let k_D2 = S::constant(constants::D2);
    let k_D4 = S::constant(constants::D4);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [t1, t6, t9, t10] = {
        let t1 = k_D2 * t0;
        let t2 = s2 * dq1;
        let t6 = t2 * (c2 * dq1);
        let dw2_y = dq2 * t2;
        let t9 = t2 * t2 - dq2 * dq2 - t0;
        let t10 = dw2_y + dw2_y;
        [t1, t6, t9, t10]
    };
    // link 3: motion
    let [
        t13, t16, w3_z, a3_x, a3_y, a3_z, t30, w3_y,
        t34, dw3_y, t38, t39, t40, t41,
    ] = {
        let t13 = s2 * c3 + c2 * s3;
        let t16 = s2 * s3 - c2 * c3;
        let w3_z = dq2 + dq3;
        let t18 = k_A2 * t9;
        let t19 = k_A2 * t6;
        let a3_x = c3 * t18 + s3 * t19;
        let a3_y = c3 * t19 - s3 * t18;
        let a3_z = t0 * k2 - k_A2 * t10 - t1;
        let t30 = dq1 * t13;
        let w3_y = dq1 * t16;
        let t32 = t30 * t30;
        let t33 = w3_z * w3_z;
        let t34 = t30 * w3_y;
        let dw3_y = w3_z * t30;
        let dw3_x = w3_z * w3_y;
        let t38 = t32 - t33 - t0;
        let t39 = t32 + t33;
        let t40 = dw3_y + dw3_y;
        let t41 = dw3_x + dw3_x;
        [
        t13, t16, w3_z, a3_x, a3_y, a3_z, t30, w3_y,
        t34, dw3_y, t38, t39, t40, t41,
    ]
    };
    // link 4: motion
    let [
        t42, t43, t54, a4_x, a4_y, w4_x, w4_y, w4_z,
        dw4_y, t80, t81,
    ] = {
        let t42 = c4 * t13;
        let t43 = s4 * t13;
        let t53 = a3_x + (k_D4 * t34 - t38 * k3);
        let t54 = a3_y + (t34 * k3 + k_D4 * t39);
        let t55 = a3_z + (t40 * k3 - k_D4 * t41);
        let a4_x = c4 * t53 + s4 * t55;
        let a4_y = c4 * t55 - s4 * t53;
        let w4_x = s4 * w3_z - c4 * t30;
        let w4_y = c4 * w3_z + s4 * t30;
        let w4_z = dq4 - w3_y;
        let t77 = w4_y * w4_z;
        let dw4_x = c4 * t41 + s4 * t34 + t77;
        let dw4_y = c4 * t34 - s4 * t41 - w4_x * w4_z;
        let t80 = dw3_y + w4_x * w4_y;
        let t81 = t77 + dw4_x;
        [
        t42, t43, t54, a4_x, a4_y, w4_x, w4_y, w4_z,
        dw4_y, t80, t81,
    ]
    };
    // link 5: motion
    let [a5_x, a5_y, w5_x, t93, w5_z, dw5_y, t106, t107] = {
        let a5_x = c5 * a4_x + s5 * t54;
        let a5_y = c5 * t54 - s5 * a4_x;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t93 = c5 * w4_z + s5 * w4_x;
        let w5_z = w4_y + dq5;
        let t103 = t93 * w5_z;
        let dw5_x = c5 * t81 + s5 * t80 - t103;
        let dw5_y = c5 * t80 - s5 * t81 - w5_x * w5_z;
        let t106 = dw4_y + w5_x * t93;
        let t107 = dw5_x - t103;
        [a5_x, a5_y, w5_x, t93, w5_z, dw5_y, t106, t107]
    };
    // link 6: motion
    let [a6_x, a6_y, dw6_x, dw6_y] = {
        let a6_x = c6 * a5_x + s6 * a4_y;
        let a6_y = c6 * a4_y - s6 * a5_x;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let w6_z = t93 + dq6;
        let dw6_x = c6 * t107 + s6 * t106 + w6_y * w6_z;
        let dw6_y = c6 * t106 - s6 * t107 - w6_x * w6_z;
        [a6_x, a6_y, dw6_x, dw6_y]
    };
    // frame 2
    let [t131, t132, t133, t134] = {
        let t131 = c1 * c2;
        let t132 = c1 * s2;
        let t133 = s1 * c2;
        let t134 = s1 * s2;
        [t131, t132, t133, t134]
    };
    // frame 3
    let [t137, t140, t143, t146] = {
        let t137 = c3 * t131 - s3 * t132;
        let t140 = c3 * t132 + s3 * t131;
        let t143 = c3 * t133 - s3 * t134;
        let t146 = c3 * t134 + s3 * t133;
        [t137, t140, t143, t146]
    };
    // frame 4
    let [t149, t152, t155, t158] = {
        let t149 = c4 * t137 - s1 * s4;
        let t152 = s1 * c4 + s4 * t137;
        let t155 = c4 * t143 + c1 * s4;
        let t158 = c1 * c4 - s4 * t143;
        [t149, t152, t155, t158]
    };
    // frame 5
    let [t161, t164, t167, t170, t173, t176] = {
        let t161 = c5 * t149 - s5 * t140;
        let t164 = c5 * t140 + s5 * t149;
        let t167 = c5 * t155 - s5 * t146;
        let t170 = c5 * t146 + s5 * t155;
        let t173 = s5 * t16 - c5 * t42;
        let t176 = c5 * t16 + s5 * t42;
        [t161, t164, t167, t170, t173, t176]
    };
    // frame 6
    let [t179, t182, t185, t188, t191, t194] = {
        let t179 = c6 * t161 - s6 * t152;
        let t182 = c6 * t152 + s6 * t161;
        let t185 = c6 * t167 + s6 * t158;
        let t188 = c6 * t158 - s6 * t167;
        let t191 = c6 * t173 + s6 * t43;
        let t194 = c6 * t43 - s6 * t173;
        [t179, t182, t185, t188, t191, t194]
    };
    // in world axes
    {
        let t199 = a6_x * t179 - a6_y * t182 - a5_y * t164;
        let t204 = a6_x * t185 + a6_y * t188 - a5_y * t170;
        let t209 = a5_y * t176 + (a6_x * t191 + a6_y * t194);
        let t214 = dw6_x * t179 - dw6_y * t182 - dw5_y * t164;
        let t219 = dw6_x * t185 + dw6_y * t188 - dw5_y * t170;
        let t224 = dw5_y * t176 + (dw6_x * t191 + dw6_y * t194);
        put(0, t199);
        put(1, t204);
        put(2, t209);
        put(3, t214);
        put(4, t219);
        put(5, t224);
    }
}
