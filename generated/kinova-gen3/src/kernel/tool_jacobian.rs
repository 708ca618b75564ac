//! Jacobian of the tool frame's origin, in world axes.
//!
//! `(v, w) = J dq` as in `jacobian`; `tau = J' f` are the torques of a wrench on the tool. Khalil
//! and Dombre, 5.2.
//!
//! 89 multiplications, 65 additions; 6 x 7, 35 of 42 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 35;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (1, 0), (1, 1), (1, 2), (1, 3),
    (1, 4), (1, 5), (2, 1), (2, 2), (2, 3), (2, 4), (2, 5), (3, 1), (3, 2), (3, 3),
    (3, 4), (3, 5), (3, 6), (4, 1), (4, 2), (4, 3), (4, 4), (4, 5), (4, 6), (5, 0),
    (5, 2), (5, 3), (5, 4), (5, 5), (5, 6),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 7 + PATTERN[k].1
}

/// Jacobian of the tool frame's origin, in world axes: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 7]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            5 => flat[6] = S::default(),
            11 => clear(&mut flat[13..15]),
            16 => clear(&mut flat[20..22]),
            22 => flat[28] = S::default(),
            29 => flat[36] = S::default(),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 7]; 6]) {
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
    let [s1, s2, s3, s4, s5, s6, ..] = trig.sin;
    let [c1, c2, c3, c4, c5, c6, ..] = trig.cos;
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
        put(17, s1); // [3][1]
        put(18, t6); // [3][2]
        put(23, c1); // [4][1]
        put(24, t5); // [4][2]
        put(29, k7); // [5][0]
        [t0, t1, t2, t3, t4, t5]
    };
    // frame 3
    let [
        t10, t11, t12, t15, t18, t21, t24, t25,
        t26,
    ] = {
        let t10 = t3 * k1 - t0;
        let t11 = t1 + t5 * k1;
        let t12 = k2 + c2 * k1;
        let t15 = s1 * s3 - c3 * t2;
        let t18 = s1 * c3 + s3 * t2;
        let t21 = c3 * t4 + c1 * s3;
        let t24 = c1 * c3 - s3 * t4;
        let t25 = s2 * c3;
        let t26 = s2 * s3;
        let t27 = -t26;
        put(19, t18); // [3][3]
        put(25, t24); // [4][3]
        put(31, t27); // [5][3]
        [
        t10, t11, t12, t15, t18, t21, t24, t25,
        t26,
    ]
    };
    // frame 4
    let [
        t31, t32, t33, t36, t39, t42, t45, t48,
        t51,
    ] = {
        let t31 = t18 * k3 - t10;
        let t32 = t11 + t24 * k3;
        let t33 = t12 + t26 * k3;
        let t36 = c4 * t15 + s4 * t3;
        let t39 = s4 * t15 - c4 * t3;
        let t42 = s4 * t5 - c4 * t21;
        let t45 = c4 * t5 + s4 * t21;
        let t48 = c4 * t25 + c2 * s4;
        let t51 = s4 * t25 - c2 * c4;
        put(20, t39); // [3][4]
        put(26, t45); // [4][4]
        put(32, t51); // [5][4]
        [
        t31, t32, t33, t36, t39, t42, t45, t48,
        t51,
    ]
    };
    // frame 5
    let [
        t55, t56, t57, t60, t63, t66, t69, t72,
        t75,
    ] = {
        let t55 = t31 + t39 * k4;
        let t56 = t32 + t45 * k4;
        let t57 = t33 - t51 * k4;
        let t60 = c5 * t36 + s5 * t18;
        let t63 = c5 * t18 - s5 * t36;
        let t66 = c5 * t42 - s5 * t24;
        let t69 = c5 * t24 + s5 * t42;
        let t72 = c5 * t48 - s5 * t26;
        let t75 = c5 * t26 + s5 * t48;
        let t76 = -t75;
        put(21, t63); // [3][5]
        put(27, t69); // [4][5]
        put(33, t76); // [5][5]
        [
        t55, t56, t57, t60, t63, t66, t69, t72,
        t75,
    ]
    };
    // frame 6
    let [t80, t81, t82, t85, t88, t91] = {
        let t80 = t55 + t63 * k5;
        let t81 = t56 + t69 * k5;
        let t82 = t57 + t75 * k5;
        let t85 = c6 * t39 + s6 * t60;
        let t88 = s6 * t66 - c6 * t45;
        let t91 = c6 * t51 + s6 * t72;
        let t92 = -t88;
        put(22, t85); // [3][6]
        put(28, t92); // [4][6]
        put(34, t91); // [5][6]
        [t80, t81, t82, t85, t88, t91]
    };
    // frame 7
    let [t93, t94, t95, t96, t97, t98] = {
        let t93 = t85 * k6;
        let t94 = t88 * k6;
        let t95 = t91 * k6;
        let t96 = t80 + t93;
        let t97 = t94 - t81;
        let t98 = t82 - t95;
        put(0, t97); // [0][0]
        put(6, t96); // [1][0]
        [t93, t94, t95, t96, t97, t98]
    };
    // columns
    {
        let t99 = t98 - k2;
        let t102 = c1 * t99;
        let t106 = s1 * (t1 + t97) + c1 * (t96 - t0);
        let t107 = t10 + t96;
        let t108 = t11 + t97;
        let t109 = t98 - t12;
        let t112 = t5 * t109 + c2 * t108;
        let t115 = c2 * t107 + t3 * t109;
        let t118 = t5 * t107 - t3 * t108;
        let t119 = t96 - t31;
        let t120 = t32 + t97;
        let t121 = t98 - t33;
        let t124 = t24 * t121 + t26 * t120;
        let t127 = t26 * t119 - t18 * t121;
        let t130 = t18 * t120 + t24 * t119;
        let t131 = t55 - t96;
        let t132 = t56 + t97;
        let t133 = t98 - t57;
        let t136 = t45 * t133 - t51 * t132;
        let t139 = t51 * t131 - t39 * t133;
        let t142 = t39 * t132 - t45 * t131;
        let t145 = t75 * t94 - t69 * t95;
        let t148 = t75 * t93 + t63 * t95;
        let t151 = t63 * t94 + t69 * t93;
        let t152 = -(s1 * t99);
        let t153 = -c2;
        put(1, t102); // [0][1]
        put(2, t112); // [0][2]
        put(3, t124); // [0][3]
        put(4, t136); // [0][4]
        put(5, t145); // [0][5]
        put(7, t152); // [1][1]
        put(8, t115); // [1][2]
        put(9, t127); // [1][3]
        put(10, t139); // [1][4]
        put(11, t148); // [1][5]
        put(12, t106); // [2][1]
        put(13, t118); // [2][2]
        put(14, t130); // [2][3]
        put(15, t142); // [2][4]
        put(16, t151); // [2][5]
        put(30, t153); // [5][2]
    }
}
