//! DH frames of all rows in the world frame.
//!
//! `out[i]` is the top three rows of the homogeneous matrix `T(0, i+1)`, m and one. Khalil and
//! Dombre, 3.2.
//!
//! 63 multiplications, 49 additions; 6 x 3 x 4, 62 of 72 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 62;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 4), (0, 5), (0, 10), (1, 0), (1, 1), (1, 2), (1, 3), (1, 4),
    (1, 5), (1, 6), (1, 7), (1, 8), (1, 9), (2, 0), (2, 1), (2, 2), (2, 3), (2, 4),
    (2, 5), (2, 6), (2, 7), (2, 8), (2, 9), (2, 11), (3, 0), (3, 1), (3, 2), (3, 3),
    (3, 4), (3, 5), (3, 6), (3, 7), (3, 8), (3, 9), (3, 10), (3, 11), (4, 0), (4, 1),
    (4, 2), (4, 3), (4, 4), (4, 5), (4, 6), (4, 7), (4, 8), (4, 9), (4, 10), (4, 11),
    (5, 0), (5, 1), (5, 2), (5, 3), (5, 4), (5, 5), (5, 6), (5, 7), (5, 8), (5, 9),
    (5, 10), (5, 11),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 12 + PATTERN[k].1
}

/// DH frames of all rows in the world frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[[S; 4]; 3]; 6]) {
    let flat = &mut out.as_flattened_mut().as_flattened_mut()[..];
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            1 => clear(&mut flat[2..4]),
            3 => clear(&mut flat[6..10]),
            4 => flat[11] = S::default(),
            14 => clear(&mut flat[22..24]),
            24 => flat[34] = S::default(),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [[[S; 4]; 3]; 6]) {
    entries(trig, |k, x| {
        out[PATTERN[k].0][PATTERN[k].1 / 4][PATTERN[k].1 % 4] = x;
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
    let [s1, s2, s3, s4, s5, s6] = trig.sin;
    let [c1, c2, c3, c4, c5, c6] = trig.cos;
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
        let t6 = -t3;
        let t7 = -t0;
        let t8 = -t5;
        put(0, c1); // [0][0][0]
        put(2, s1); // [0][1][0]
        put(3, c1); // [0][1][1]
        put(4, k5); // [0][2][2]
        put(5, t2); // [1][0][0]
        put(6, t6); // [1][0][1]
        put(8, t7); // [1][0][3]
        put(9, t4); // [1][1][0]
        put(10, t8); // [1][1][1]
        put(11, c1); // [1][1][2]
        put(12, t1); // [1][1][3]
        put(21, c1); // [2][1][2]
        [t0, t1, t2, t3, t4, t5]
    };
    // frame 3
    let [
        t15, t16, t17, t20, t23, t26, t29, t32,
        t35,
    ] = {
        let t15 = s2 * k_A2;
        let t16 = k_A2 * t2 + s1 * k2 - t0;
        let t17 = t1 + (k_A2 * t4 - c1 * k2);
        let t20 = c3 * t2 - s3 * t3;
        let t23 = c3 * t3 + s3 * t2;
        let t26 = c3 * t4 - s3 * t5;
        let t29 = c3 * t5 + s3 * t4;
        let t32 = s2 * c3 + c2 * s3;
        let t35 = s2 * s3 - c2 * c3;
        let t36 = -t23;
        let t37 = -t29;
        let t38 = -t32;
        let t39 = -t15;
        let t40 = -t35;
        put(15, t20); // [2][0][0]
        put(16, t36); // [2][0][1]
        put(18, t16); // [2][0][3]
        put(19, t26); // [2][1][0]
        put(20, t37); // [2][1][1]
        put(22, t17); // [2][1][3]
        put(23, t38); // [2][2][0]
        put(24, t35); // [2][2][1]
        put(25, t39); // [2][2][3]
        put(28, t23); // [3][0][2]
        put(32, t29); // [3][1][2]
        put(36, t40); // [3][2][2]
        [
        t15, t16, t17, t20, t23, t26, t29, t32,
        t35,
    ]
    };
    // frame 4
    let [t55, t58, t61, t64, t65, t66] = {
        let t50 = t16 + (k_D4 * t23 - t20 * k3);
        let t51 = t17 + (k_D4 * t29 - t26 * k3);
        let t52 = t32 * k3 - k_D4 * t35 - t15;
        let t55 = c4 * t20 - s1 * s4;
        let t58 = s1 * c4 + s4 * t20;
        let t61 = c4 * t26 + c1 * s4;
        let t64 = c1 * c4 - s4 * t26;
        let t65 = c4 * t32;
        let t66 = s4 * t32;
        let t67 = -t58;
        let t68 = -t65;
        put(26, t55); // [3][0][0]
        put(27, t67); // [3][0][1]
        put(29, t50); // [3][0][3]
        put(30, t61); // [3][1][0]
        put(31, t64); // [3][1][1]
        put(33, t51); // [3][1][3]
        put(34, t68); // [3][2][0]
        put(35, t66); // [3][2][1]
        put(37, t52); // [3][2][3]
        put(40, t67); // [4][0][2]
        put(41, t50); // [4][0][3]
        put(44, t64); // [4][1][2]
        put(45, t51); // [4][1][3]
        put(48, t66); // [4][2][2]
        put(49, t52); // [4][2][3]
        put(53, t50); // [5][0][3]
        put(57, t51); // [5][1][3]
        put(61, t52); // [5][2][3]
        [t55, t58, t61, t64, t65, t66]
    };
    // frame 5
    let [t71, t77, t83] = {
        let t71 = c5 * t55 - s5 * t23;
        let t74 = c5 * t23 + s5 * t55;
        let t77 = c5 * t61 - s5 * t29;
        let t80 = c5 * t29 + s5 * t61;
        let t83 = s5 * t35 - c5 * t65;
        let t86 = c5 * t35 + s5 * t65;
        let t87 = -t74;
        let t88 = -t80;
        let t89 = -t86;
        put(38, t71); // [4][0][0]
        put(39, t87); // [4][0][1]
        put(42, t77); // [4][1][0]
        put(43, t88); // [4][1][1]
        put(46, t83); // [4][2][0]
        put(47, t86); // [4][2][1]
        put(52, t74); // [5][0][2]
        put(56, t80); // [5][1][2]
        put(60, t89); // [5][2][2]
        [t71, t77, t83]
    };
    // frame 6
    {
        let t92 = c6 * t71 - s6 * t58;
        let t98 = c6 * t77 + s6 * t64;
        let t101 = c6 * t64 - s6 * t77;
        let t104 = c6 * t83 + s6 * t66;
        let t107 = c6 * t66 - s6 * t83;
        let t108 = -s1;
        let t109 = -s2;
        let t110 = -c2;
        let t111 = -(c6 * t58 + s6 * t71);
        put(1, t108); // [0][0][1]
        put(7, t108); // [1][0][2]
        put(13, t109); // [1][2][0]
        put(14, t110); // [1][2][1]
        put(17, t108); // [2][0][2]
        put(50, t92); // [5][0][0]
        put(51, t111); // [5][0][1]
        put(54, t98); // [5][1][0]
        put(55, t101); // [5][1][1]
        put(58, t104); // [5][2][0]
        put(59, t107); // [5][2][1]
    }
}
