//! DH frames of all rows in the world frame.
//!
//! `out[i]` is the top three rows of the homogeneous matrix `T(0, i+1)`, m and one. Khalil and
//! Dombre, 3.2.
//!
//! 79 multiplications, 64 additions; 7 x 3 x 4, 77 of 84 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 77;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 4), (0, 5), (0, 10), (0, 11), (1, 0), (1, 1), (1, 2), (1, 3),
    (1, 4), (1, 5), (1, 6), (1, 7), (1, 8), (1, 9), (1, 11), (2, 0), (2, 1), (2, 2),
    (2, 3), (2, 4), (2, 5), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10), (2, 11), (3, 0),
    (3, 1), (3, 2), (3, 3), (3, 4), (3, 5), (3, 6), (3, 7), (3, 8), (3, 9), (3, 10),
    (3, 11), (4, 0), (4, 1), (4, 2), (4, 3), (4, 4), (4, 5), (4, 6), (4, 7), (4, 8),
    (4, 9), (4, 10), (4, 11), (5, 0), (5, 1), (5, 2), (5, 3), (5, 4), (5, 5), (5, 6),
    (5, 7), (5, 8), (5, 9), (5, 10), (5, 11), (6, 0), (6, 1), (6, 2), (6, 3), (6, 4),
    (6, 5), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 12 + PATTERN[k].1
}

/// DH frames of all rows in the world frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[[S; 4]; 3]; 7]) {
    let flat = &mut out.as_flattened_mut().as_flattened_mut()[..];
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            1 => clear(&mut flat[2..4]),
            3 => clear(&mut flat[6..10]),
            15 => flat[22] = S::default(),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [[[S; 4]; 3]; 7]) {
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
    let [s1, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [c1, c2, c3, c4, c5, c6, c7] = trig.cos;
    let k0 = S::constant(0.01175);
    let k1 = S::constant(0.42076);
    let k2 = S::constant(0.28481);
    let k3 = S::constant(0.01275);
    let k4 = S::constant(0.31436);
    let k5 = S::constant(0.00035);
    let k6 = S::constant(0.167455);
    let k7 = S::constant(-1.0);
    // frame 2
    let [t0, t1, t2, t3, t4, t5] = {
        let t0 = s1 * k0;
        let t1 = c1 * k0;
        let t2 = c1 * c2;
        let t3 = c1 * s2;
        let t4 = s1 * c2;
        let t5 = s1 * s2;
        let t6 = -t3;
        let t7 = -t0;
        let t8 = -t4;
        let t9 = -t1;
        put(0, c1); // [0][0][0]
        put(4, k7); // [0][2][2]
        put(5, k2); // [0][2][3]
        put(6, t2); // [1][0][0]
        put(7, t6); // [1][0][1]
        put(8, s1); // [1][0][2]
        put(9, t7); // [1][0][3]
        put(10, t8); // [1][1][0]
        put(11, t5); // [1][1][1]
        put(12, c1); // [1][1][2]
        put(13, t9); // [1][1][3]
        put(16, k2); // [1][2][3]
        put(19, t6); // [2][0][2]
        put(23, t5); // [2][1][2]
        [t0, t1, t2, t3, t4, t5]
    };
    // frame 3
    let [
        t13, t14, t15, t18, t21, t24, t27, t28,
        t29,
    ] = {
        let t13 = t3 * k1 - t0;
        let t14 = t1 + t5 * k1;
        let t15 = k2 + c2 * k1;
        let t18 = c3 * t2 - s1 * s3;
        let t21 = s1 * c3 + s3 * t2;
        let t24 = c3 * t4 + c1 * s3;
        let t27 = s3 * t4 - c1 * c3;
        let t28 = s2 * c3;
        let t29 = s2 * s3;
        let t30 = -t21;
        let t31 = -t24;
        let t32 = -t14;
        let t33 = -t28;
        let t34 = -t27;
        let t35 = -t29;
        put(17, t18); // [2][0][0]
        put(18, t30); // [2][0][1]
        put(20, t13); // [2][0][3]
        put(21, t31); // [2][1][0]
        put(22, t27); // [2][1][1]
        put(24, t32); // [2][1][3]
        put(25, t33); // [2][2][0]
        put(26, t29); // [2][2][1]
        put(28, t15); // [2][2][3]
        put(31, t21); // [3][0][2]
        put(35, t34); // [3][1][2]
        put(39, t35); // [3][2][2]
        [
        t13, t14, t15, t18, t21, t24, t27, t28,
        t29,
    ]
    };
    // frame 4
    let [
        t39, t40, t41, t44, t47, t50, t53, t56,
        t59,
    ] = {
        let t39 = t13 - t21 * k3;
        let t40 = t27 * k3 - t14;
        let t41 = t15 + t29 * k3;
        let t44 = c4 * t18 - s4 * t3;
        let t47 = c4 * t3 + s4 * t18;
        let t50 = s4 * t5 - c4 * t24;
        let t53 = c4 * t5 + s4 * t24;
        let t56 = c4 * t28 + c2 * s4;
        let t59 = s4 * t28 - c2 * c4;
        let t60 = -t47;
        let t61 = -t56;
        put(29, t44); // [3][0][0]
        put(30, t60); // [3][0][1]
        put(32, t39); // [3][0][3]
        put(33, t50); // [3][1][0]
        put(34, t53); // [3][1][1]
        put(36, t40); // [3][1][3]
        put(37, t61); // [3][2][0]
        put(38, t59); // [3][2][1]
        put(40, t41); // [3][2][3]
        put(43, t60); // [4][0][2]
        put(47, t53); // [4][1][2]
        put(51, t59); // [4][2][2]
        [
        t39, t40, t41, t44, t47, t50, t53, t56,
        t59,
    ]
    };
    // frame 5
    let [
        t65, t66, t67, t70, t73, t76, t79, t82,
        t85,
    ] = {
        let t65 = t39 + t47 * k4;
        let t66 = t40 - t53 * k4;
        let t67 = t41 - t59 * k4;
        let t70 = c5 * t44 - s5 * t21;
        let t73 = c5 * t21 + s5 * t44;
        let t76 = c5 * t50 + s5 * t27;
        let t79 = c5 * t27 - s5 * t50;
        let t82 = s5 * t29 - c5 * t56;
        let t85 = c5 * t29 + s5 * t56;
        let t86 = -t73;
        let t87 = -t79;
        let t88 = -t85;
        put(41, t70); // [4][0][0]
        put(42, t86); // [4][0][1]
        put(44, t65); // [4][0][3]
        put(45, t76); // [4][1][0]
        put(46, t79); // [4][1][1]
        put(48, t66); // [4][1][3]
        put(49, t82); // [4][2][0]
        put(50, t85); // [4][2][1]
        put(52, t67); // [4][2][3]
        put(55, t73); // [5][0][2]
        put(59, t87); // [5][1][2]
        put(63, t88); // [5][2][2]
        [
        t65, t66, t67, t70, t73, t76, t79, t82,
        t85,
    ]
    };
    // frame 6
    let [
        t92, t93, t94, t97, t100, t103, t106, t109,
        t112,
    ] = {
        let t92 = t65 - t73 * k5;
        let t93 = t66 + t79 * k5;
        let t94 = t67 + t85 * k5;
        let t97 = c6 * t70 - s6 * t47;
        let t100 = c6 * t47 + s6 * t70;
        let t103 = c6 * t76 + s6 * t53;
        let t106 = c6 * t53 - s6 * t76;
        let t109 = c6 * t82 + s6 * t59;
        let t112 = c6 * t59 - s6 * t82;
        let t113 = -t100;
        put(53, t97); // [5][0][0]
        put(54, t113); // [5][0][1]
        put(56, t92); // [5][0][3]
        put(57, t103); // [5][1][0]
        put(58, t106); // [5][1][1]
        put(60, t93); // [5][1][3]
        put(61, t109); // [5][2][0]
        put(62, t112); // [5][2][1]
        put(64, t94); // [5][2][3]
        put(67, t113); // [6][0][2]
        put(71, t106); // [6][1][2]
        put(75, t112); // [6][2][2]
        [
        t92, t93, t94, t97, t100, t103, t106, t109,
        t112,
    ]
    };
    // frame 7
    {
        let t117 = t92 + t100 * k6;
        let t118 = t93 - t106 * k6;
        let t119 = t94 - t112 * k6;
        let t122 = c7 * t97 - s7 * t73;
        let t128 = c7 * t103 + s7 * t79;
        let t131 = c7 * t79 - s7 * t103;
        let t134 = c7 * t109 + s7 * t85;
        let t137 = c7 * t85 - s7 * t109;
        let t138 = -s1;
        let t139 = -c1;
        let t140 = -s2;
        let t141 = -c2;
        let t142 = -(c7 * t73 + s7 * t97);
        put(1, t138); // [0][0][1]
        put(2, t138); // [0][1][0]
        put(3, t139); // [0][1][1]
        put(14, t140); // [1][2][0]
        put(15, t141); // [1][2][1]
        put(27, t141); // [2][2][2]
        put(65, t122); // [6][0][0]
        put(66, t142); // [6][0][1]
        put(68, t117); // [6][0][3]
        put(69, t128); // [6][1][0]
        put(70, t131); // [6][1][1]
        put(72, t118); // [6][1][3]
        put(73, t134); // [6][2][0]
        put(74, t137); // [6][2][1]
        put(76, t119); // [6][2][3]
    }
}
