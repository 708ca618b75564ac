//! The tool frame in the world frame.
//!
//! Like `forward_kinematics`, followed by the tool's pose (the identity where the robot file has no
//! tool).
//!
//! 64 multiplications, 35 additions; 3 x 4, 12 of 12 structurally nonzero.

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
    let [s1, s2, s3, s4, s5, s6] = trig.sin;
    let [c1, c2, c3, c4, c5, c6] = trig.cos;
    let k0 = S::constant(-constants::A2);
    let k2 = S::constant(-constants::A3);
    let k_D1 = S::constant(constants::D1);
    let k_D4 = S::constant(constants::D4);
    let k_D5 = S::constant(constants::D5);
    let k_D6 = S::constant(constants::D6);
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
        t4, t5, t7, t10, t13, t16, t19, t22,
        t25,
    ] = {
        let t4 = t0 * k0;
        let t5 = t2 * k0;
        let t7 = s2 * k0 - k_D1;
        let t10 = s3 * t1 - c3 * t0;
        let t13 = c3 * t1 + s3 * t0;
        let t16 = s3 * t3 - c3 * t2;
        let t19 = c3 * t3 + s3 * t2;
        let t22 = s2 * c3 + c2 * s3;
        let t25 = s2 * s3 - c2 * c3;
        [
        t4, t5, t7, t10, t13, t16, t19, t22,
        t25,
    ]
    };
    // frame 4
    let [
        t33, t34, t35, t38, t41, t44, t47, t50,
        t53,
    ] = {
        let t33 = t10 * k2 + s1 * k_D4 - t4;
        let t34 = t16 * k2 - c1 * k_D4 - t5;
        let t35 = t7 + t22 * k2;
        let t38 = c4 * t10 + s4 * t13;
        let t41 = s4 * t10 - c4 * t13;
        let t44 = c4 * t16 + s4 * t19;
        let t47 = s4 * t16 - c4 * t19;
        let t50 = s4 * t25 - c4 * t22;
        let t53 = c4 * t25 + s4 * t22;
        [
        t33, t34, t35, t38, t41, t44, t47, t50,
        t53,
    ]
    };
    // frame 5
    let [
        t57, t58, t59, t62, t65, t68, t71, t72,
        t73,
    ] = {
        let t57 = t33 - k_D5 * t41;
        let t58 = t34 - k_D5 * t47;
        let t59 = t35 - k_D5 * t53;
        let t62 = s1 * s5 - c5 * t38;
        let t65 = s1 * c5 + s5 * t38;
        let t68 = c5 * t44 + c1 * s5;
        let t71 = s5 * t44 - c1 * c5;
        let t72 = c5 * t50;
        let t73 = s5 * t50;
        put(2, t65); // [0][2]
        put(6, t71); // [1][2]
        put(10, t73); // [2][2]
        [
        t57, t58, t59, t62, t65, t68, t71, t72,
        t73,
    ]
    };
    // frame 6
    {
        let t77 = t57 + k_D6 * t65;
        let t78 = t58 + k_D6 * t71;
        let t79 = k_D6 * t73 - t59;
        let t82 = c6 * t62 + s6 * t41;
        let t85 = c6 * t41 - s6 * t62;
        let t88 = s6 * t47 - c6 * t68;
        let t91 = c6 * t47 + s6 * t68;
        let t97 = s6 * t72 - c6 * t53;
        let t98 = -(c6 * t72 + s6 * t53);
        put(0, t82); // [0][0]
        put(1, t85); // [0][1]
        put(3, t77); // [0][3]
        put(4, t88); // [1][0]
        put(5, t91); // [1][1]
        put(7, t78); // [1][3]
        put(8, t98); // [2][0]
        put(9, t97); // [2][1]
        put(11, t79); // [2][3]
    }
}
