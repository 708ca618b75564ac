//! The last DH frame in the world frame.
//!
//! `out` is the top three rows of `T(0, n)`: axes of the frame as columns, then its origin, m.
//! Khalil and Dombre, 3.2.
//!
//! 63 multiplications, 32 additions; 3 x 4, 12 of 12 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{Trig, constants};

/// The last DH frame in the world frame: every entry of `out` is written.
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
    let k2 = S::constant(-constants::D3);
    let k3 = S::constant(-constants::A3);
    let k_A2 = S::constant(constants::A2);
    let k_D2 = S::constant(constants::D2);
    let k_D4 = S::constant(constants::D4);
    // frame 2
    let [t0, t1, t2, t3, t4, t5] = {
        let t0 = s1 * k_D2;
        let t1 = c1 * k_D2;
        let t2 = c1 * c2;
        let t3 = c1 * s2;
        let t4 = s1 * c2;
        let t5 = s1 * s2;
        [t0, t1, t2, t3, t4, t5]
    };
    // frame 3
    let [
        t12, t13, t14, t17, t20, t23, t26, t29,
        t32,
    ] = {
        let t12 = s2 * k_A2;
        let t13 = k_A2 * t2 + s1 * k2 - t0;
        let t14 = t1 - (c1 * k2 - k_A2 * t4);
        let t17 = s3 * t3 - c3 * t2;
        let t20 = c3 * t3 + s3 * t2;
        let t23 = s3 * t5 - c3 * t4;
        let t26 = c3 * t5 + s3 * t4;
        let t29 = s2 * c3 + c2 * s3;
        let t32 = c2 * c3 - s2 * s3;
        [
        t12, t13, t14, t17, t20, t23, t26, t29,
        t32,
    ]
    };
    // frame 4
    let [t47, t50, t53, t56, t57, t58] = {
        let t42 = t13 + (t17 * k3 + k_D4 * t20);
        let t43 = t14 + (t23 * k3 + k_D4 * t26);
        let t44 = t29 * k3 + k_D4 * t32 - t12;
        let t47 = c4 * t17 + s1 * s4;
        let t50 = s4 * t17 - s1 * c4;
        let t53 = c1 * s4 - c4 * t23;
        let t56 = c1 * c4 + s4 * t23;
        let t57 = c4 * t29;
        let t58 = s4 * t29;
        put(3, t42); // [0][3]
        put(7, t43); // [1][3]
        put(11, t44); // [2][3]
        [t47, t50, t53, t56, t57, t58]
    };
    // frame 5
    let [t61, t67, t73] = {
        let t61 = c5 * t47 + s5 * t20;
        let t64 = c5 * t20 - s5 * t47;
        let t67 = c5 * t53 - s5 * t26;
        let t70 = c5 * t26 + s5 * t53;
        let t73 = c5 * t57 + s5 * t32;
        let t76 = c5 * t32 - s5 * t57;
        put(2, t64); // [0][2]
        put(6, t70); // [1][2]
        put(10, t76); // [2][2]
        [t61, t67, t73]
    };
    // frame 6
    {
        let t79 = s6 * t50 - c6 * t61;
        let t82 = c6 * t50 + s6 * t61;
        let t85 = c6 * t67 + s6 * t56;
        let t88 = c6 * t56 - s6 * t67;
        let t91 = s6 * t58 - c6 * t73;
        let t94 = c6 * t58 + s6 * t73;
        put(0, t79); // [0][0]
        put(1, t82); // [0][1]
        put(4, t85); // [1][0]
        put(5, t88); // [1][1]
        put(8, t91); // [2][0]
        put(9, t94); // [2][1]
    }
}
