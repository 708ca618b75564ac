//! Mass matrix `M`, symmetric, kg m^2.
//!
//! From the base parameters, rotors on the diagonal, by composite bodies. Featherstone, 6.2.
//!
//! 120 multiplications, 95 additions; 6 x 6, 34 of 36 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{BASE, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 34;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (1, 0), (1, 1), (1, 2), (1, 3),
    (1, 4), (1, 5), (2, 0), (2, 1), (2, 2), (2, 4), (2, 5), (3, 0), (3, 1), (3, 3),
    (3, 4), (3, 5), (4, 0), (4, 1), (4, 2), (4, 3), (4, 4), (4, 5), (5, 0), (5, 1),
    (5, 2), (5, 3), (5, 4), (5, 5),
];

/// Mass matrix `M`, symmetric, kg m^2: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], out: &mut [[S; 6]; 6]) {
    out.as_flattened_mut().fill(S::default());
    entries(trig, beta, |k, x| {
        out[PATTERN[k].0][PATTERN[k].1] = x;
    });
}

/// The same, only the entries of [`PATTERN`].
#[inline]
pub fn packed<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], out: &mut [S; NONZEROS]) {
    entries(trig, beta, |k, x| out[k] = x);
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
fn entries<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let [
        YY1R, MSX2, MSZ2, YY2R, ZZ2R, XY2R, XZ2R, YZ2R, M3R, MSX3, MSY3, MSZ3R,
        MSX4, MSZ4R, YY4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSZ5R, YY5R, ZZ5R, XY5,
        XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6,
        ..] = *beta;
    let D2 = S::constant(0.154);
    let D6 = S::constant(0.263);
    // composite body 6
    let [t2, t5, t14, t15, t56, t59, t62] = {
        let t2 = c6 * MSY6 + s6 * MSX6;
        let t5 = s6 * MSY6 - c6 * MSX6;
        let t14 = c6 * XZ6 - s6 * YZ6 + D6 * t5;
        let t15 = s6 * XZ6 + c6 * YZ6 - D6 * t2;
        let t16 = c5 * t2;
        let t17 = s5 * t2;
        let t20 = c5 * t14 + s5 * ZZ6;
        let t23 = c5 * ZZ6 - s5 * t14;
        let t29 = s4 * t16 + c4 * t5;
        let t38 = s4 * t20 + c4 * t15 - q3 * (c4 * t16 - s4 * t5);
        let t39 = s4 * t15 - c4 * t20 - q3 * t29;
        let t47 = c2 * t23 - s2 * t38 + D2 * (c2 * t29 - s2 * t17);
        let t49 = s6 * XY6;
        let t52 = c6 * XY6;
        let t53 = s6 * XX6R + t52;
        let t56 = c6 * (t49 - c6 * XX6R) + s6 * t52;
        let t59 = c6 * t53 - s6 * t49;
        let t62 = s6 * t53 + c6 * t49;
        put(5, t47); // [0][5]
        put(11, t39); // [1][5]
        put(14, M3R); // [2][2]
        put(16, t17); // [2][5]
        put(21, t23); // [3][5]
        put(27, t15); // [4][5]
        put(28, t47); // [5][0]
        put(29, t39); // [5][1]
        put(30, t17); // [5][2]
        put(31, t23); // [5][3]
        put(32, t15); // [5][4]
        put(33, ZZ6); // [5][5]
        [t2, t5, t14, t15, t56, t59, t62]
    };
    // composite body 5
    let [t65, t71, t74, t77, t80, t113, t116, t119] = {
        let t63 = t5 - MSX5;
        let t64 = ZZ5R + ZZ6;
        let t65 = YY5R + t62;
        let t66 = XZ5 + t14;
        let t67 = XY5 + t59;
        let t68 = YZ5 + t15;
        let t71 = c5 * MSZ5R + s5 * t63;
        let t74 = c5 * t63 - s5 * MSZ5R;
        let t77 = c5 * t67 + s5 * t68;
        let t80 = c5 * t68 - s5 * t67;
        let t82 = s4 * t71;
        let t92 = q3 * t82 - (c4 * t77 - s4 * t65);
        let t96 = s2 * (s4 * t77 + c4 * t65 + q3 * (c4 * t71));
        let t100 = c2 * t80 - t96 - D2 * (c2 * t82 + s2 * t74);
        let t102 = s5 * t66;
        let t105 = c5 * t66;
        let t106 = s5 * t56 + t105;
        let t110 = t102 - c5 * t64;
        let t113 = c5 * (c5 * t56 - t102) - s5 * (t105 + s5 * t64);
        let t116 = c5 * t106 - s5 * t110;
        let t119 = s5 * t106 + c5 * t110;
        put(4, t100); // [0][4]
        put(10, t92); // [1][4]
        put(15, t74); // [2][4]
        put(20, t80); // [3][4]
        put(22, t100); // [4][0]
        put(23, t92); // [4][1]
        put(24, t74); // [4][2]
        put(25, t80); // [4][3]
        put(26, t65); // [4][4]
        [t65, t71, t74, t77, t80, t113, t116, t119]
    };
    // composite body 4
    let [t123, t129, t132, t135, t138, t161, t164, t167] = {
        let t120 = t74 - MSX4;
        let t121 = MSZ4R + t2;
        let t122 = ZZ4R + t65;
        let t123 = YY4R - t119;
        let t124 = XZ4 + t77;
        let t125 = XY4 - t116;
        let t126 = t80 - YZ4;
        let t129 = s4 * t120 - c4 * t121;
        let t132 = s4 * t121 + c4 * t120;
        let t135 = c4 * t125 + s4 * t126;
        let t138 = c4 * t126 - s4 * t125;
        let t142 = t135 - q3 * t132;
        let t148 = c2 * t123 - s2 * (t138 + q3 * t129) + D2 * (c2 * t132);
        let t150 = s4 * t124;
        let t153 = c4 * t124;
        let t154 = t153 - s4 * t113;
        let t158 = t150 + c4 * t122;
        let t161 = c4 * (c4 * t113 + t150) + s4 * (t153 - s4 * t122);
        let t164 = c4 * t154 - s4 * t158;
        let t167 = s4 * t154 + c4 * t158;
        put(3, t148); // [0][3]
        put(9, t142); // [1][3]
        put(17, t148); // [3][0]
        put(18, t142); // [3][1]
        put(19, t123); // [3][3]
        [t123, t129, t132, t135, t138, t161, t164, t167]
    };
    // composite body 3
    let [t168, t169, t176, t179, t181, t182, t184] = {
        let t168 = MSX3 - t132;
        let t169 = t129 - MSY3;
        let t170 = MSZ3R + t71;
        let t174 = s2 * t168 - D2 * (s2 * M3R);
        let t176 = t170 + q3 * M3R;
        let t178 = q3 * (t170 + t176);
        let t179 = t167 + t178;
        let t181 = t138 + q3 * t169;
        let t182 = t178 - t161;
        let t184 = t135 + q3 * t168;
        put(2, t174); // [0][2]
        put(8, t169); // [1][2]
        put(12, t174); // [2][0]
        put(13, t169); // [2][1]
        [t168, t169, t176, t179, t181, t182, t184]
    };
    // composite body 2
    let t213 = {
        let t188 = YY2R + t182;
        let t189 = XZ2R + t181;
        let t198 = D2 * (c2 * (MSZ2 + t176) + s2 * (t169 - MSX2));
        let t199 = c2 * (YZ2R + t184) - s2 * (XY2R - t164) - t198;
        let t207 = c2 * (c2 * (ZZ2R + t123) - s2 * t189);
        let t212 = D2 * (t168 + (t168 - D2 * M3R));
        let t213 = s2 * (s2 * t179 - c2 * t189) + t207 - t212;
        put(1, t199); // [0][1]
        put(6, t199); // [1][0]
        put(7, t188); // [1][1]
        t213
    };
    // composite body 1
    {
        let t214 = YY1R + t213;
        put(0, t214); // [0][0]
    }
}
