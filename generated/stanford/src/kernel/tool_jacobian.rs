//! Jacobian of the tool frame's origin, in world axes.
//!
//! `(v, w) = J dq` as in `jacobian`; `tau = J' f` are the torques of a wrench on the tool. Khalil
//! and Dombre, 5.2.
//!
//! 44 multiplications, 27 additions; 6 x 6, 26 of 36 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 26;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (1, 0), (1, 1), (1, 2), (1, 3), (1, 4),
    (2, 1), (2, 2), (2, 3), (2, 4), (3, 1), (3, 3), (3, 4), (3, 5), (4, 1), (4, 3),
    (4, 4), (4, 5), (5, 0), (5, 3), (5, 4), (5, 5),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 6 + PATTERN[k].1
}

/// Jacobian of the tool frame's origin, in world axes: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 6]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            4 => flat[5] = S::default(),
            9 => clear(&mut flat[11..13]),
            13 => clear(&mut flat[17..19]),
            14 => flat[20] = S::default(),
            17 => flat[24] = S::default(),
            18 => flat[26] = S::default(),
            22 => clear(&mut flat[31..33]),
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
    let [_, _, q3, ..] = trig.q;
    let [s1, s2, _, s4, s5, ..] = trig.sin;
    let [c1, c2, _, c4, c5, ..] = trig.cos;
    let k3 = S::constant(1.0);
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
        put(2, t3); // [0][2]
        put(7, t5); // [1][2]
        put(11, c2); // [2][2]
        put(15, t3); // [3][3]
        put(18, c1); // [4][1]
        put(19, t5); // [4][3]
        put(22, k3); // [5][0]
        put(23, c2); // [5][3]
        [t0, t1, t2, t3, t4, t5]
    };
    // frame 3
    let [t9, t10, t11] = {
        let t9 = q3 * t3 - t0;
        let t10 = t1 + q3 * t5;
        let t11 = k_D1 + c2 * q3;
        [t9, t10, t11]
    };
    // frame 4
    let [t14, t17, t20, t23, t24, t25] = {
        let t14 = s1 * c4 + s4 * t2;
        let t17 = c4 * t2 - s1 * s4;
        let t20 = c1 * c4 - s4 * t4;
        let t23 = c4 * t4 + c1 * s4;
        let t24 = s2 * s4;
        let t25 = s2 * c4;
        let t26 = -t25;
        put(16, t17); // [3][4]
        put(20, t23); // [4][4]
        put(24, t26); // [5][4]
        [t14, t17, t20, t23, t24, t25]
    };
    // frame 5
    let [t29, t32, t35] = {
        let t29 = c5 * t3 + s5 * t14;
        let t32 = c5 * t5 - s5 * t20;
        let t35 = c2 * c5 - s5 * t24;
        put(17, t29); // [3][5]
        put(21, t32); // [4][5]
        put(25, t35); // [5][5]
        [t29, t32, t35]
    };
    // frame 6
    let [t36, t37, t38, t39, t40, t41] = {
        let t36 = k_D6 * t29;
        let t37 = k_D6 * t32;
        let t38 = k_D6 * t35;
        let t39 = t9 + t36;
        let t40 = t10 + t37;
        let t41 = t11 + t38;
        let t42 = -t40;
        put(0, t42); // [0][0]
        put(5, t39); // [1][0]
        [t36, t37, t38, t39, t40, t41]
    };
    // columns
    {
        let t43 = t41 - k_D1;
        let t46 = c1 * t43;
        let t47 = s1 * t43;
        let t50 = s1 * (t1 - t40) - c1 * (t0 + t39);
        let t53 = t5 * t38 - c2 * t37;
        let t56 = c2 * t36 - t3 * t38;
        let t59 = t3 * t37 - t5 * t36;
        let t62 = t23 * t38 + t25 * t37;
        let t68 = t17 * t37 - t23 * t36;
        let t69 = -(t25 * t36 + t17 * t38);
        let t70 = -s1;
        put(1, t46); // [0][1]
        put(3, t53); // [0][3]
        put(4, t62); // [0][4]
        put(6, t47); // [1][1]
        put(8, t56); // [1][3]
        put(9, t69); // [1][4]
        put(10, t50); // [2][1]
        put(12, t59); // [2][3]
        put(13, t68); // [2][4]
        put(14, t70); // [3][1]
    }
}
