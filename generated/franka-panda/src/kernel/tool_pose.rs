//! The tool frame in the world frame.
//!
//! Like `forward_kinematics`, followed by the tool's pose (the identity where the robot file has no
//! tool).
//!
//! 77 multiplications, 41 additions; 3 x 4, 12 of 12 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{Trig, constants};

/// The tool frame in the world frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 4]; 3]) {
    entries(trig, |k, x| {
        out[k / 4][k % 4] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, mut put: impl FnMut(usize, S)) {
    let [s1, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [c1, c2, c3, c4, c5, c6, c7] = trig.cos;
    let k4 = S::constant(0.088);
    let k_A = S::constant(constants::A);
    let k_L1 = S::constant(constants::L1);
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
    // frame 2
    let [t0, t1, t2, t3] = {
        let t0 = c1 * c2;
        let t1 = c1 * s2;
        let t2 = s1 * c2;
        let t3 = s1 * s2;
        [t0, t1, t2, t3]
    };
    // frame 3
    let [
        t4, t5, t7, t10, t13, t16, t19, t20,
        t21,
    ] = {
        let t4 = k_L2 * t1;
        let t5 = k_L2 * t3;
        let t7 = k_L1 + c2 * k_L2;
        let t10 = s1 * s3 - c3 * t0;
        let t13 = s1 * c3 + s3 * t0;
        let t16 = c3 * t2 + c1 * s3;
        let t19 = c1 * c3 - s3 * t2;
        let t20 = s2 * c3;
        let t21 = s2 * s3;
        [
        t4, t5, t7, t10, t13, t16, t19, t20,
        t21,
    ]
    };
    // frame 4
    let [
        t25, t26, t27, t30, t33, t36, t39, t42,
        t45,
    ] = {
        let t25 = k_A * t10 - t4;
        let t26 = t5 + k_A * t16;
        let t27 = t7 - k_A * t20;
        let t30 = s4 * t1 - c4 * t10;
        let t33 = c4 * t1 + s4 * t10;
        let t36 = c4 * t16 + s4 * t3;
        let t39 = s4 * t16 - c4 * t3;
        let t42 = c2 * s4 - c4 * t20;
        let t45 = c2 * c4 + s4 * t20;
        [
        t25, t26, t27, t30, t33, t36, t39, t42,
        t45,
    ]
    };
    // frame 5
    let [
        t55, t56, t57, t60, t63, t66, t69, t72,
        t75,
    ] = {
        let t55 = t25 + (k_A * t30 - k_L3 * t33);
        let t56 = t26 - (k_A * t36 + k_L3 * t39);
        let t57 = t27 + (k_L3 * t45 - k_A * t42);
        let t60 = c5 * t30 - s5 * t13;
        let t63 = c5 * t13 + s5 * t30;
        let t66 = c5 * t36 + s5 * t19;
        let t69 = s5 * t36 - c5 * t19;
        let t72 = c5 * t42 + s5 * t21;
        let t75 = s5 * t42 - c5 * t21;
        [
        t55, t56, t57, t60, t63, t66, t69, t72,
        t75,
    ]
    };
    // frame 6
    let [
        t78, t79, t80, t83, t84, t85, t88, t89,
        t90,
    ] = {
        let t78 = c6 * t60 + s6 * t33;
        let t79 = c6 * t33;
        let t80 = s6 * t60;
        let t83 = s6 * t39 - c6 * t66;
        let t84 = c6 * t39;
        let t85 = s6 * t66;
        let t88 = c6 * t72 + s6 * t45;
        let t89 = c6 * t45;
        let t90 = s6 * t72;
        [
        t78, t79, t80, t83, t84, t85, t88, t89,
        t90,
    ]
    };
    // frame 7
    {
        let t94 = k4 * t78 - t55;
        let t95 = t56 - k4 * t83;
        let t96 = t57 + k4 * t88;
        let t97 = t80 - t79;
        let t100 = c7 * t78 + s7 * t63;
        let t103 = c7 * t63 - s7 * t78;
        let t104 = t84 + t85;
        let t107 = s7 * t69 - c7 * t83;
        let t110 = c7 * t69 + s7 * t83;
        let t111 = t90 - t89;
        let t114 = c7 * t88 + s7 * t75;
        let t117 = c7 * t75 - s7 * t88;
        put(0, t100); // [0][0]
        put(1, t103); // [0][1]
        put(2, t97); // [0][2]
        put(3, t94); // [0][3]
        put(4, t107); // [1][0]
        put(5, t110); // [1][1]
        put(6, t104); // [1][2]
        put(7, t95); // [1][3]
        put(8, t114); // [2][0]
        put(9, t117); // [2][1]
        put(10, t111); // [2][2]
        put(11, t96); // [2][3]
    }
}
