//! Mass matrix `M`, symmetric, kg m^2.
//!
//! From the base parameters, rotors on the diagonal, by composite bodies. Featherstone, 6.2.
//!
//! 120 multiplications, 99 additions; 6 x 6, 34 of 36 structurally nonzero.

use super::super::runtime::{Scalar, apart};
use super::super::{BASE, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 34;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (1, 0), (1, 1), (1, 2), (1, 3),
    (1, 4), (1, 5), (2, 0), (2, 1), (2, 2), (2, 4), (2, 5), (3, 0), (3, 1), (3, 3),
    (3, 4), (3, 5), (4, 0), (4, 1), (4, 2), (4, 3), (4, 4), (4, 5), (5, 0), (5, 1),
    (5, 2), (5, 3), (5, 4), (5, 5),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 6 + PATTERN[k].1
}

/// Mass matrix `M`, symmetric, kg m^2: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], out: &mut [[S; 6]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, beta, |k, x| {
        flat[place(k)] = x;
        match k {
            14 => flat[15] = S::default(),
            18 => flat[20] = S::default(),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], out: &mut [[S; 6]; 6]) {
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
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let [
        YY1R, MSX2, MSZ2, YY2R, ZZ2R, XY2R, XZ2R, YZ2R, M3R, MSX3, MSY3, MSZ3R,
        MSX4, MSZ4R, YY4R, ZZ4R, XY4, XZ4, YZ4, MSX5, MSZ5R, YY5R, ZZ5R, XY5,
        XZ5, YZ5, MSX6, MSY6, XX6R, ZZ6, XY6, XZ6, YZ6, IA3, IA4, IA5,
        IA6,
        ..] = *beta;
    let k_D2 = S::constant(constants::D2);
    let k_D6 = S::constant(constants::D6);
    // composite body 6
    let [t3, t6, t15, t16, t57, t60, t63] = {
        let t0 = ZZ6 + IA6;
        let t3 = c6 * MSY6 + s6 * MSX6;
        let t6 = s6 * MSY6 - c6 * MSX6;
        let t15 = k_D6 * t6 - (s6 * YZ6 - c6 * XZ6);
        let t16 = s6 * XZ6 + c6 * YZ6 - k_D6 * t3;
        let t17 = c5 * t3;
        let t18 = s5 * t3;
        let t21 = c5 * t15 + s5 * ZZ6;
        let t24 = c5 * ZZ6 - s5 * t15;
        let t30 = s4 * t17 + c4 * t6;
        let t39 = s4 * t21 + c4 * t16 - q3 * (c4 * t17 - s4 * t6);
        let t40 = s4 * t16 - c4 * t21 - q3 * t30;
        let t48 = c2 * t24 - s2 * t39 + k_D2 * (c2 * t30 - s2 * t18);
        let t50 = s6 * XY6;
        let t53 = c6 * XY6;
        let t54 = s6 * XX6R + t53;
        let t57 = c6 * (c6 * XX6R - t50) - s6 * t53;
        let t60 = c6 * t54 - s6 * t50;
        let t63 = s6 * t54 + c6 * t50;
        put(5, t48); // [0][5]
        put(11, t40); // [1][5]
        put(16, t18); // [2][5]
        put(21, t24); // [3][5]
        put(27, t16); // [4][5]
        put(28, t48); // [5][0]
        put(29, t40); // [5][1]
        put(30, t18); // [5][2]
        put(31, t24); // [5][3]
        put(32, t16); // [5][4]
        put(33, t0); // [5][5]
        [t3, t6, t15, t16, t57, t60, t63]
    };
    // composite body 5
    let [t66, t73, t76, t79, t82, t115, t118, t121] = {
        let t64 = t6 - MSX5;
        let t65 = ZZ5R + ZZ6;
        let t66 = YY5R + t63;
        let t67 = XZ5 + t15;
        let t68 = XY5 + t60;
        let t69 = YZ5 + t16;
        let t70 = IA5 + t66;
        let t73 = c5 * MSZ5R + s5 * t64;
        let t76 = c5 * t64 - s5 * MSZ5R;
        let t79 = c5 * t68 + s5 * t69;
        let t82 = c5 * t69 - s5 * t68;
        let t84 = s4 * t73;
        let t94 = s4 * t66 - c4 * t79 + q3 * t84;
        let t98 = s2 * (s4 * t79 + c4 * t66 + q3 * (c4 * t73));
        let t102 = c2 * t82 - t98 - k_D2 * (c2 * t84 + s2 * t76);
        let t104 = s5 * t67;
        let t107 = c5 * t67;
        let t108 = t107 - s5 * t57;
        let t112 = c5 * t65 - t104;
        let t115 = c5 * (c5 * t57 + t104) + s5 * (t107 + s5 * t65);
        let t118 = c5 * t108 + s5 * t112;
        let t121 = c5 * t112 - s5 * t108;
        put(4, t102); // [0][4]
        put(10, t94); // [1][4]
        put(15, t76); // [2][4]
        put(20, t82); // [3][4]
        put(22, t102); // [4][0]
        put(23, t94); // [4][1]
        put(24, t76); // [4][2]
        put(25, t82); // [4][3]
        put(26, t70); // [4][4]
        [t66, t73, t76, t79, t82, t115, t118, t121]
    };
    // composite body 4
    let [t125, t132, t135, t138, t141, t164, t167, t170] = {
        let t122 = t76 - MSX4;
        let t123 = MSZ4R + t3;
        let t124 = ZZ4R + t66;
        let t125 = YY4R + t121;
        let t126 = XZ4 + t79;
        let t127 = XY4 - t118;
        let t128 = t82 - YZ4;
        let t129 = IA4 + t125;
        let t132 = s4 * t122 - c4 * t123;
        let t135 = s4 * t123 + c4 * t122;
        let t138 = c4 * t127 + s4 * t128;
        let t141 = c4 * t128 - s4 * t127;
        let t145 = t138 - q3 * t135;
        let t151 = c2 * t125 - s2 * (t141 + q3 * t132) + k_D2 * (c2 * t135);
        let t153 = s4 * t126;
        let t156 = c4 * t126;
        let t157 = s4 * t115 + t156;
        let t161 = t153 + c4 * t124;
        let t164 = c4 * (t153 - c4 * t115) + s4 * (t156 - s4 * t124);
        let t167 = c4 * t157 - s4 * t161;
        let t170 = s4 * t157 + c4 * t161;
        put(3, t151); // [0][3]
        put(9, t145); // [1][3]
        put(17, t151); // [3][0]
        put(18, t145); // [3][1]
        put(19, t129); // [3][3]
        [t125, t132, t135, t138, t141, t164, t167, t170]
    };
    // composite body 3
    let [t171, t172, t180, t183, t185, t186, t188] = {
        let t171 = MSX3 - t135;
        let t172 = t132 - MSY3;
        let t173 = MSZ3R + t73;
        let t174 = M3R + IA3;
        let t178 = s2 * t171 - k_D2 * (s2 * M3R);
        let t180 = t173 + q3 * M3R;
        let t182 = q3 * (t173 + t180);
        let t183 = t170 + t182;
        let t185 = t141 + q3 * t172;
        let t186 = t182 - t164;
        let t188 = t138 + q3 * t171;
        put(2, t178); // [0][2]
        put(8, t172); // [1][2]
        put(12, t178); // [2][0]
        put(13, t172); // [2][1]
        put(14, t174); // [2][2]
        [t171, t172, t180, t183, t185, t186, t188]
    };
    // composite body 2
    let t217 = {
        let t192 = YY2R + t186;
        let t193 = XZ2R + t185;
        let t202 = k_D2 * (c2 * (MSZ2 + t180) - s2 * (MSX2 - t172));
        let t203 = s2 * (t167 - XY2R) + c2 * (YZ2R + t188) - t202;
        let t211 = c2 * (c2 * (ZZ2R + t125) - s2 * t193);
        let t216 = k_D2 * (t171 - (k_D2 * M3R - t171));
        let t217 = s2 * (c2 * t193 - s2 * t183) - t211 + t216;
        put(1, t203); // [0][1]
        put(6, t203); // [1][0]
        put(7, t192); // [1][1]
        t217
    };
    // composite body 1
    {
        let t218 = YY1R - t217;
        put(0, t218); // [0][0]
    }
}
