//! Regressor at rest.
//!
//! `g = W_g phi` for the links' parameters only; columns as the first of `STANDARD_NAMES`.
//!
//! 111 multiplications, 63 additions; 6 x 60, 59 of 360 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 59;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 13), (0, 23), (0, 30), (0, 33), (0, 40), (0, 41), (0, 42), (0, 43), (0, 50), (0, 51),
    (0, 52), (0, 53), (1, 11), (1, 12), (1, 20), (1, 21), (1, 22), (1, 30), (1, 31), (1, 32),
    (1, 40), (1, 41), (1, 42), (1, 43), (1, 50), (1, 51), (1, 52), (1, 53), (2, 21), (2, 22),
    (2, 30), (2, 31), (2, 32), (2, 40), (2, 41), (2, 42), (2, 43), (2, 50), (2, 51), (2, 52),
    (2, 53), (3, 31), (3, 32), (3, 40), (3, 41), (3, 42), (3, 43), (3, 50), (3, 51), (3, 52),
    (3, 53), (4, 41), (4, 42), (4, 50), (4, 51), (4, 52), (4, 53), (5, 51), (5, 52),
];

/// Regressor at rest: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 60]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    flat[0..13].fill(S::default());
    flat[14..23].fill(S::default());
    flat[24..30].fill(S::default());
    flat[31..33].fill(S::default());
    flat[34..40].fill(S::default());
    flat[44..50].fill(S::default());
    flat[54..71].fill(S::default());
    flat[73..80].fill(S::default());
    flat[83..90].fill(S::default());
    flat[93..100].fill(S::default());
    flat[104..110].fill(S::default());
    flat[114..141].fill(S::default());
    flat[143..150].fill(S::default());
    flat[153..160].fill(S::default());
    flat[164..170].fill(S::default());
    flat[174..211].fill(S::default());
    flat[213..220].fill(S::default());
    flat[224..230].fill(S::default());
    flat[234..281].fill(S::default());
    flat[283..290].fill(S::default());
    flat[294..351].fill(S::default());
    flat[353..360].fill(S::default());
    nonzeros(trig, out);
}

/// The same, where all other entries of `out` are zero already: they are left alone.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 60]; 6]) {
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
fn entries<S: Scalar>(trig: &Trig<S>, mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let A3 = S::constant(-0.57155);
    let D4 = S::constant(0.17415);
    let D5 = S::constant(0.11985);
    let D6 = S::constant(0.11655);
    let k0 = S::constant(9.81);
    let k1 = S::constant(0.6127);
    let k3 = S::constant(0.57155);
    // link 2: motion
    let [a2_x, a2_y] = {
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        put(12, a2_y); // row 2, MSX2
        [a2_x, a2_y]
    };
    // link 3: motion
    let [z1_3_x, z1_3_y, a3_x, t13] = {
        let z1_3_x = s2 * c3 + c2 * s3;
        let z1_3_y = c2 * c3 - s2 * s3;
        let a3_x = c3 * a2_x + s3 * a2_y;
        let t13 = s3 * a2_x - c3 * a2_y;
        [z1_3_x, z1_3_y, a3_x, t13]
    };
    // link 4: motion
    let [z1_4_x, t19, t22, t25] = {
        let z1_4_x = c4 * z1_3_x + s4 * z1_3_y;
        let t19 = s4 * z1_3_x - c4 * z1_3_y;
        let t22 = s4 * t13 - c4 * a3_x;
        let t25 = c4 * t13 + s4 * a3_x;
        put(19, t22); // row 2, MSY4
        put(32, t22); // row 3, MSY4
        put(42, t22); // row 4, MSY4
        [z1_4_x, t19, t22, t25]
    };
    // link 5: motion
    let [t26, a5_y] = {
        let t26 = c5 * t22;
        let a5_y = s5 * t22;
        put(51, a5_y); // row 5, MSX5
        put(52, t26); // row 5, MSY5
        [t26, a5_y]
    };
    // link 6: motion
    let [t30, a6_y] = {
        let t30 = c6 * t26 + s6 * t25;
        let a6_y = s6 * t26 - c6 * t25;
        put(57, a6_y); // row 6, MSX6
        put(58, t30); // row 6, MSY6
        [t30, a6_y]
    };
    // joint axes in frame 3
    let [v1_3_z, t35, t36] = {
        let v1_3_z = c2 * k1;
        let t35 = s3 * k1;
        let t36 = c3 * k1;
        [v1_3_z, t35, t36]
    };
    // joint axes in frame 4
    let [v1_4_z, t43, v1_5_z, t50, t53, t54, v3_5_z] = {
        let t37 = D4 * z1_3_y;
        let t38 = D4 * z1_3_x;
        let v1_4_z = v1_3_z + z1_3_y * k3;
        let t43 = s4 * t38 - c4 * t37;
        let v1_5_z = c4 * t38 + s4 * t37;
        let t47 = t36 - A3;
        let t50 = c4 * t35 + s4 * t47;
        let t53 = c4 * t47 - s4 * t35;
        let t54 = s4 * k3;
        let v3_5_z = c4 * k3;
        [v1_4_z, t43, v1_5_z, t50, t53, t54, v3_5_z]
    };
    // MSZ2: column
    {
        let t58 = c2 * a2_x - s2 * a2_y;
        put(0, t58); // row 1, MSZ2
    }
    // M3: column
    {
        let t61 = t13 * t36 - a3_x * t35;
        put(14, t61); // row 2, M3
    }
    // MSZ3: column
    {
        let t64 = z1_3_x * t13 + z1_3_y * a3_x;
        put(1, t64); // row 1, MSZ3
    }
    // M4: column
    let [t66, t69, t72] = {
        let t66 = t25 * v1_5_z;
        let t67 = t22 * t43 + t66;
        let t69 = t25 * t53;
        let t70 = t22 * t50 + t69;
        let t72 = t25 * v3_5_z;
        let t73 = t22 * t54 + t72;
        put(2, t67); // row 1, M4
        put(17, t70); // row 2, M4
        put(30, t73); // row 3, M4
        [t66, t69, t72]
    };
    // MSZ4: column
    {
        let t76 = z1_4_x * t25 + t19 * t22;
        put(3, t76); // row 1, MSZ4
    }
    // M5: column
    let [t78, t79, t81, t82, t84] = {
        let t78 = s5 * a5_y;
        let t79 = c5 * t26 + t78;
        let t81 = c5 * a5_y;
        let t82 = s5 * t26 - t81;
        let t84 = D5 * t79;
        let t90 = z1_4_x * (D5 * t82) + (t66 + t43 * t79 - v1_4_z * t82);
        let t93 = t69 + t50 * t79 - t84;
        let t96 = t72 + t54 * t79 - t84;
        put(4, t90); // row 1, M5
        put(20, t93); // row 2, M5
        put(33, t96); // row 3, M5
        [t78, t79, t81, t82, t84]
    };
    // MSX5: column
    let t98 = {
        let t97 = s5 * t25;
        let t98 = c5 * t25;
        let t101 = z1_4_x * t97 + t19 * a5_y;
        put(5, t101); // row 1, MSX5
        put(22, t97); // row 2, MSY5
        put(35, t97); // row 3, MSY5
        put(45, t97); // row 4, MSY5
        t98
    };
    // MSY5: column
    {
        let t104 = z1_4_x * t98 + t19 * t26;
        put(6, t104); // row 1, MSY5
    }
    // MSZ5: column
    {
        let t105 = z1_4_x * t82;
        put(7, t105); // row 1, MSZ5
    }
    // M6: column
    let [t108, t111] = {
        let t108 = c6 * t30 + s6 * a6_y;
        let t111 = s6 * t30 - c6 * a6_y;
        let t112 = D6 * t111;
        let t113 = D6 * t108;
        let t115 = t78 + c5 * t108;
        let t117 = s5 * t108 - t81;
        let t123 = s5 * t112 - D5 * t115;
        let t131 = v1_4_z * t117 - (t43 * t115 + v1_5_z * t111);
        let t132 = z1_4_x * (c5 * t112 + D5 * t117) + t19 * t113 - t131;
        let t136 = t123 + (t50 * t115 + t53 * t111);
        let t140 = t123 + (t54 * t115 + v3_5_z * t111);
        put(8, t132); // row 1, M6
        put(24, t136); // row 2, M6
        put(37, t140); // row 3, M6
        put(47, t123); // row 4, M6
        put(53, t113); // row 5, M6
        put(56, t108); // row 5, MSZ6
        [t108, t111]
    };
    // MSX6: column
    let [t141, t142] = {
        let t141 = s6 * a5_y;
        let t142 = c6 * a5_y;
        let t148 = s5 * t141 + c5 * a6_y;
        let t151 = t19 * t142 - z1_4_x * (s5 * a6_y - c5 * t141);
        put(9, t151); // row 1, MSX6
        put(25, t148); // row 2, MSX6
        put(38, t148); // row 3, MSX6
        put(48, t148); // row 4, MSX6
        put(54, t142); // row 5, MSX6
        [t141, t142]
    };
    // MSY6: column
    {
        let t157 = s5 * t142 + c5 * t30;
        let t160 = z1_4_x * (c5 * t142 - s5 * t30) - t19 * t141;
        put(10, t160); // row 1, MSY6
        put(26, t157); // row 2, MSY6
        put(39, t157); // row 3, MSY6
        put(49, t157); // row 4, MSY6
    }
    // MSZ6: column
    {
        let t162 = s5 * t111;
        let t165 = z1_4_x * (c5 * t111) + t19 * t108;
        let t166 = -a2_x;
        let t167 = -t13;
        let t168 = -a3_x;
        let t169 = -t25;
        let t170 = -t98;
        let t171 = -t79;
        let t172 = -t84;
        let t173 = -t141;
        put(11, t165); // row 1, MSZ6
        put(13, t166); // row 2, MSY2
        put(15, t167); // row 2, MSX3
        put(16, t168); // row 2, MSY3
        put(18, t169); // row 2, MSX4
        put(21, t170); // row 2, MSX5
        put(23, t171); // row 2, MSZ5
        put(27, t162); // row 2, MSZ6
        put(28, t167); // row 3, MSX3
        put(29, t168); // row 3, MSY3
        put(31, t169); // row 3, MSX4
        put(34, t170); // row 3, MSX5
        put(36, t171); // row 3, MSZ5
        put(40, t162); // row 3, MSZ6
        put(41, t169); // row 4, MSX4
        put(43, t172); // row 4, M5
        put(44, t170); // row 4, MSX5
        put(46, t171); // row 4, MSZ5
        put(50, t162); // row 4, MSZ6
        put(55, t173); // row 5, MSY6
    }
}
