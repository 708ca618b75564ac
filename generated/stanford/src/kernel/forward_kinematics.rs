//! The last DH frame in the world frame.
//!
//! `out` is the top three rows of `T(0, n)`: axes of the frame as columns, then its origin, m.
//! Khalil and Dombre, 3.2.
//!
//! 46 multiplications, 23 additions; 3 x 4, 12 of 12 structurally nonzero.

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
    let [_, _, q3, ..] = trig.q;
    let [s1, s2, _, s4, s5, s6] = trig.sin;
    let [c1, c2, _, c4, c5, c6] = trig.cos;
    let k_D1 = S::constant(constants::D1);
    let k_D2 = S::constant(constants::D2);
    let k_D6 = S::constant(constants::D6);
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
    let [t9, t10, t11] = {
        let t9 = t0 - q3 * t3;
        let t10 = t1 + q3 * t5;
        let t11 = k_D1 + c2 * q3;
        [t9, t10, t11]
    };
    // frame 4
    let [t14, t17, t20, t23, t24, t25] = {
        let t14 = s1 * c4 + s4 * t2;
        let t17 = c4 * t2 - s1 * s4;
        let t20 = s4 * t4 - c1 * c4;
        let t23 = c4 * t4 + c1 * s4;
        let t24 = s2 * s4;
        let t25 = s2 * c4;
        [t14, t17, t20, t23, t24, t25]
    };
    // frame 5
    let [t28, t31, t34, t37, t40, t43] = {
        let t28 = s5 * t3 - c5 * t14;
        let t31 = c5 * t3 + s5 * t14;
        let t34 = c5 * t20 - s5 * t5;
        let t37 = c5 * t5 + s5 * t20;
        let t40 = c5 * t24 + c2 * s5;
        let t43 = c2 * c5 - s5 * t24;
        put(2, t31); // [0][2]
        put(6, t37); // [1][2]
        put(10, t43); // [2][2]
        [t28, t31, t34, t37, t40, t43]
    };
    // frame 6
    {
        let t47 = k_D6 * t31 - t9;
        let t48 = t10 + k_D6 * t37;
        let t49 = t11 + k_D6 * t43;
        let t52 = s6 * t17 - c6 * t28;
        let t55 = c6 * t17 + s6 * t28;
        let t58 = c6 * t34 + s6 * t23;
        let t61 = c6 * t23 - s6 * t34;
        let t67 = s6 * t40 - c6 * t25;
        let t68 = -(c6 * t40 + s6 * t25);
        put(0, t52); // [0][0]
        put(1, t55); // [0][1]
        put(3, t47); // [0][3]
        put(4, t58); // [1][0]
        put(5, t61); // [1][1]
        put(7, t48); // [1][3]
        put(8, t68); // [2][0]
        put(9, t67); // [2][1]
        put(11, t49); // [2][3]
    }
}
