//! The tool frame in the world frame.
//!
//! Like `forward_kinematics`, followed by the tool's pose (the identity where the robot file has no
//! tool).
//!
//! 68 multiplications, 33 additions; 3 x 4, 12 of 12 structurally nonzero.

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
    let [t24, t27, t30, t33, t36, t39] = {
        let t24 = c4 * t10 - s4 * t1;
        let t27 = c4 * t1 + s4 * t10;
        let t30 = c4 * t16 + s4 * t3;
        let t33 = s4 * t16 - c4 * t3;
        let t36 = c2 * s4 - c4 * t20;
        let t39 = c2 * c4 + s4 * t20;
        [t24, t27, t30, t33, t36, t39]
    };
    // frame 5
    let [t43, t48, t51, t54, t57, t60, t63] = {
        let t43 = t4 + k_L3 * t27;
        let t44 = k_L3 * t33 - t5;
        let t45 = t7 + k_L3 * t39;
        let t48 = c5 * t24 + s5 * t13;
        let t51 = s5 * t24 - c5 * t13;
        let t54 = c5 * t30 + s5 * t19;
        let t57 = c5 * t19 - s5 * t30;
        let t60 = c5 * t36 + s5 * t21;
        let t63 = s5 * t36 - c5 * t21;
        put(7, t44); // [1][3]
        put(11, t45); // [2][3]
        [t43, t48, t51, t54, t57, t60, t63]
    };
    // frame 6
    let [t66, t72, t78] = {
        let t66 = c6 * t48 + s6 * t27;
        let t69 = s6 * t48 - c6 * t27;
        let t72 = c6 * t54 + s6 * t33;
        let t75 = c6 * t33 - s6 * t54;
        let t78 = s6 * t39 - c6 * t60;
        let t81 = c6 * t39 + s6 * t60;
        put(2, t69); // [0][2]
        put(6, t75); // [1][2]
        put(10, t81); // [2][2]
        [t66, t72, t78]
    };
    // frame 7
    {
        let t84 = s7 * t51 - c7 * t66;
        let t87 = c7 * t51 + s7 * t66;
        let t90 = c7 * t72 + s7 * t57;
        let t93 = c7 * t57 - s7 * t72;
        let t96 = c7 * t78 + s7 * t63;
        let t99 = c7 * t63 - s7 * t78;
        let t100 = -t43;
        put(0, t84); // [0][0]
        put(1, t87); // [0][1]
        put(3, t100); // [0][3]
        put(4, t90); // [1][0]
        put(5, t93); // [1][1]
        put(8, t96); // [2][0]
        put(9, t99); // [2][1]
    }
}
