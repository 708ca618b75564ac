//! Jacobian of the last DH frame's origin, in world axes.
//!
//! `(v, w) = J dq`: rows 0-2 linear, m/s, rows 3-5 angular, rad/s. Khalil and Dombre, 5.2.
//!
//! 53 multiplications, 28 additions; 6 x 6, 22 of 36 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 22;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (2, 1), (2, 2), (3, 1), (3, 2),
    (3, 3), (3, 4), (3, 5), (4, 1), (4, 2), (4, 3), (4, 4), (4, 5), (5, 0), (5, 3),
    (5, 4), (5, 5),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 6 + PATTERN[k].1
}

/// Jacobian of the last DH frame's origin, in world axes: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 6]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            2 => clear(&mut flat[3..6]),
            5 => clear(&mut flat[9..13]),
            7 => clear(&mut flat[15..19]),
            12 => flat[24] = S::default(),
            18 => clear(&mut flat[31..33]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 6]; 6]) {
    entries(trig, |k, x| {
        out[PATTERN[k].0][PATTERN[k].1] = x;
    });
}

/// The same, only the entries of [`PATTERN`].
#[inline]
pub fn packed<S: Scalar>(trig: &Trig<S>, out: &mut [S; NONZEROS]) {
    entries(trig, |k, x| out[k] = x);
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, mut put: impl FnMut(usize, S)) {
    let [s1, s2, s3, s4, s5, ..] = trig.sin;
    let [c1, c2, c3, c4, c5, ..] = trig.cos;
    let k2 = S::constant(-constants::D3);
    let k3 = S::constant(-constants::A3);
    let k5 = S::constant(1.0);
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
        put(13, c1); // [4][1]
        put(14, c1); // [4][2]
        put(18, k5); // [5][0]
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
        let t23 = c3 * t4 - s3 * t5;
        let t26 = c3 * t5 + s3 * t4;
        let t29 = s2 * c3 + c2 * s3;
        let t32 = c2 * c3 - s2 * s3;
        put(10, t20); // [3][3]
        put(15, t26); // [4][3]
        put(19, t32); // [5][3]
        [
        t12, t13, t14, t17, t20, t23, t26, t29,
        t32,
    ]
    };
    // frame 4
    let [
        t35, t38, t41, t42, t43, t44, t47, t53,
        t57,
    ] = {
        let t35 = t17 * k3 + k_D4 * t20;
        let t38 = t23 * k3 - k_D4 * t26;
        let t41 = t29 * k3 + k_D4 * t32;
        let t42 = t13 + t35;
        let t43 = t38 - t14;
        let t44 = t41 - t12;
        let t47 = c4 * t17 + s1 * s4;
        let t50 = s4 * t17 - s1 * c4;
        let t53 = c4 * t23 + c1 * s4;
        let t56 = c1 * c4 - s4 * t23;
        let t57 = c4 * t29;
        let t58 = s4 * t29;
        put(0, t43); // [0][0]
        put(3, t42); // [1][0]
        put(11, t50); // [3][4]
        put(16, t56); // [4][4]
        put(20, t58); // [5][4]
        [
        t35, t38, t41, t42, t43, t44, t47, t53,
        t57,
    ]
    };
    // frame 5
    {
        let t61 = c5 * t20 - s5 * t47;
        let t64 = c5 * t26 + s5 * t53;
        let t67 = c5 * t32 - s5 * t57;
        put(12, t61); // [3][5]
        put(17, t64); // [4][5]
        put(21, t67); // [5][5]
    }
    // columns
    {
        let t70 = c1 * t44;
        let t71 = s1 * t44;
        let t74 = s1 * (t1 + t43) - c1 * (t0 + t42);
        let t75 = c1 * t41;
        let t76 = s1 * t41;
        let t79 = s1 * t38 - c1 * t35;
        let t80 = -s1;
        put(1, t70); // [0][1]
        put(2, t75); // [0][2]
        put(4, t71); // [1][1]
        put(5, t76); // [1][2]
        put(6, t74); // [2][1]
        put(7, t79); // [2][2]
        put(8, t80); // [3][1]
        put(9, t80); // [3][2]
    }
}
