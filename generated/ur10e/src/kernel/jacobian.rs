//! Jacobian of the last DH frame's origin, in world axes.
//!
//! `(v, w) = J dq`: rows 0-2 linear, m/s, rows 3-5 angular, rad/s. Khalil and Dombre, 5.2.
//!
//! 65 multiplications, 40 additions; 6 x 6, 27 of 36 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 27;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (1, 0), (1, 1), (1, 2), (1, 3), (1, 4),
    (2, 1), (2, 2), (2, 3), (2, 4), (3, 1), (3, 2), (3, 3), (3, 4), (3, 5), (4, 1),
    (4, 2), (4, 3), (4, 4), (4, 5), (5, 0), (5, 4), (5, 5),
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
            4 => flat[5] = S::default(),
            9 => clear(&mut flat[11..13]),
            13 => clear(&mut flat[17..19]),
            18 => flat[24] = S::default(),
            24 => clear(&mut flat[31..34]),
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
    let k0 = S::constant(-constants::A2);
    let k2 = S::constant(-constants::A3);
    let k6 = S::constant(1.0);
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
        put(14, s1); // [3][1]
        put(15, s1); // [3][2]
        put(16, s1); // [3][3]
        put(24, k6); // [5][0]
        [t0, t1, t2, t3]
    };
    // frame 3
    let [
        t4, t5, t7, t10, t13, t16, t19, t22,
        t25,
    ] = {
        let t4 = t0 * k0;
        let t5 = t2 * k0;
        let t7 = k_D1 - s2 * k0;
        let t10 = s3 * t1 - c3 * t0;
        let t13 = c3 * t1 + s3 * t0;
        let t16 = c3 * t2 - s3 * t3;
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
        let t34 = t5 + (t16 * k2 + c1 * k_D4);
        let t35 = t22 * k2 - t7;
        let t38 = c4 * t10 + s4 * t13;
        let t41 = c4 * t13 - s4 * t10;
        let t44 = s4 * t19 - c4 * t16;
        let t47 = c4 * t19 + s4 * t16;
        let t50 = s4 * t25 - c4 * t22;
        let t53 = c4 * t25 + s4 * t22;
        put(17, t41); // [3][4]
        put(22, t47); // [4][4]
        put(25, t53); // [5][4]
        [
        t33, t34, t35, t38, t41, t44, t47, t50,
        t53,
    ]
    };
    // frame 5
    let [t57, t58, t59, t62, t65, t66] = {
        let t57 = t33 + k_D5 * t41;
        let t58 = t34 - k_D5 * t47;
        let t59 = t35 - k_D5 * t53;
        let t62 = s1 * c5 + s5 * t38;
        let t65 = s5 * t44 - c1 * c5;
        let t66 = s5 * t50;
        put(18, t62); // [3][5]
        put(23, t65); // [4][5]
        put(26, t66); // [5][5]
        [t57, t58, t59, t62, t65, t66]
    };
    // frame 6
    let [t67, t68, t69, t70, t71, t72] = {
        let t67 = k_D6 * t62;
        let t68 = k_D6 * t65;
        let t69 = k_D6 * t66;
        let t70 = t57 + t67;
        let t71 = t58 - t68;
        let t72 = t59 - t69;
        put(0, t71); // [0][0]
        put(5, t70); // [1][0]
        [t67, t68, t69, t70, t71, t72]
    };
    // columns
    {
        let t73 = k_D1 + t72;
        let t74 = c1 * t73;
        let t75 = s1 * t73;
        let t78 = c1 * t70 - s1 * t71;
        let t81 = t7 + t72;
        let t82 = c1 * t81;
        let t83 = s1 * t81;
        let t86 = c1 * (t4 + t70) - s1 * (t71 - t5);
        let t89 = t72 - t35;
        let t90 = c1 * t89;
        let t91 = s1 * t89;
        let t94 = s1 * (t34 - t71) - c1 * (t33 - t70);
        let t97 = t47 * t69 - t53 * t68;
        let t100 = t53 * t67 - t41 * t69;
        let t103 = t41 * t68 - t47 * t67;
        let t104 = -c1;
        put(1, t74); // [0][1]
        put(2, t82); // [0][2]
        put(3, t90); // [0][3]
        put(4, t97); // [0][4]
        put(6, t75); // [1][1]
        put(7, t83); // [1][2]
        put(8, t91); // [1][3]
        put(9, t100); // [1][4]
        put(10, t78); // [2][1]
        put(11, t86); // [2][2]
        put(12, t94); // [2][3]
        put(13, t103); // [2][4]
        put(19, t104); // [4][1]
        put(20, t104); // [4][2]
        put(21, t104); // [4][3]
    }
}
