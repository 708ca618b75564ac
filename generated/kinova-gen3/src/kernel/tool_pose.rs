//! The tool frame in the world frame.
//!
//! Like `forward_kinematics`, followed by the tool's pose (the identity where the robot file has no
//! tool).
//!
//! 79 multiplications, 43 additions; 3 x 4, 12 of 12 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{Trig};

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
    let k0 = S::constant(0.01175);
    let k1 = S::constant(0.42076);
    let k2 = S::constant(0.28481);
    let k3 = S::constant(0.01275);
    let k4 = S::constant(0.31436);
    let k5 = S::constant(0.00035);
    let k6 = S::constant(0.167455);
    // frame 2
    let [t0, t1, t2, t3, t4, t5] = {
        let t0 = s1 * k0;
        let t1 = c1 * k0;
        let t2 = c1 * c2;
        let t3 = c1 * s2;
        let t4 = s1 * c2;
        let t5 = s1 * s2;
        [t0, t1, t2, t3, t4, t5]
    };
    // frame 3
    let [
        t9, t10, t11, t14, t17, t20, t23, t24,
        t25,
    ] = {
        let t9 = t0 - t3 * k1;
        let t10 = t1 + t5 * k1;
        let t11 = k2 + c2 * k1;
        let t14 = c3 * t2 - s1 * s3;
        let t17 = s1 * c3 + s3 * t2;
        let t20 = c3 * t4 + c1 * s3;
        let t23 = s3 * t4 - c1 * c3;
        let t24 = s2 * c3;
        let t25 = s2 * s3;
        [
        t9, t10, t11, t14, t17, t20, t23, t24,
        t25,
    ]
    };
    // frame 4
    let [
        t29, t30, t31, t34, t37, t40, t43, t46,
        t49,
    ] = {
        let t29 = t9 + t17 * k3;
        let t30 = t23 * k3 - t10;
        let t31 = t11 + t25 * k3;
        let t34 = s4 * t3 - c4 * t14;
        let t37 = c4 * t3 + s4 * t14;
        let t40 = c4 * t20 - s4 * t5;
        let t43 = c4 * t5 + s4 * t20;
        let t46 = c4 * t24 + c2 * s4;
        let t49 = c2 * c4 - s4 * t24;
        [
        t29, t30, t31, t34, t37, t40, t43, t46,
        t49,
    ]
    };
    // frame 5
    let [
        t53, t54, t55, t58, t61, t64, t67, t70,
        t73,
    ] = {
        let t53 = t37 * k4 - t29;
        let t54 = t43 * k4 - t30;
        let t55 = t31 + t49 * k4;
        let t58 = c5 * t34 + s5 * t17;
        let t61 = s5 * t34 - c5 * t17;
        let t64 = s5 * t23 - c5 * t40;
        let t67 = c5 * t23 + s5 * t40;
        let t70 = c5 * t46 - s5 * t25;
        let t73 = c5 * t25 + s5 * t46;
        [
        t53, t54, t55, t58, t61, t64, t67, t70,
        t73,
    ]
    };
    // frame 6
    let [
        t77, t78, t79, t82, t85, t88, t91, t94,
        t97,
    ] = {
        let t77 = t53 + t61 * k5;
        let t78 = t67 * k5 - t54;
        let t79 = t55 + t73 * k5;
        let t82 = c6 * t58 + s6 * t37;
        let t85 = s6 * t58 - c6 * t37;
        let t88 = c6 * t64 + s6 * t43;
        let t91 = c6 * t43 - s6 * t64;
        let t94 = c6 * t70 + s6 * t49;
        let t97 = s6 * t70 - c6 * t49;
        put(2, t85); // [0][2]
        put(6, t91); // [1][2]
        put(10, t97); // [2][2]
        [
        t77, t78, t79, t82, t85, t88, t91, t94,
        t97,
    ]
    };
    // frame 7
    {
        let t101 = t77 - t85 * k6;
        let t102 = t78 - t91 * k6;
        let t103 = t79 - t97 * k6;
        let t106 = s7 * t61 - c7 * t82;
        let t109 = c7 * t61 + s7 * t82;
        let t112 = c7 * t88 + s7 * t67;
        let t115 = c7 * t67 - s7 * t88;
        let t118 = s7 * t73 - c7 * t94;
        let t121 = c7 * t73 + s7 * t94;
        put(0, t106); // [0][0]
        put(1, t109); // [0][1]
        put(3, t101); // [0][3]
        put(4, t112); // [1][0]
        put(5, t115); // [1][1]
        put(7, t102); // [1][3]
        put(8, t118); // [2][0]
        put(9, t121); // [2][1]
        put(11, t103); // [2][3]
    }
}
