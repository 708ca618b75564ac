//! Regressor at rest.
//!
//! `g = W_g phi` of the links' parameters; columns as the first of `STANDARD_NAMES`, without the
//! drives'.
//!
//! 111 multiplications, 63 additions; 6 x 60, 59 of 360 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{GRAVITY, Trig, constants};

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

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 60 + PATTERN[k].1
}

/// Regressor at rest: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 60]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    clear(&mut flat[0..13]);
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[14..23]),
            1 => clear(&mut flat[24..30]),
            2 => clear(&mut flat[31..33]),
            3 => clear(&mut flat[34..40]),
            7 => clear(&mut flat[44..50]),
            11 => clear(&mut flat[54..71]),
            13 => clear(&mut flat[73..80]),
            16 => clear(&mut flat[83..90]),
            19 => clear(&mut flat[93..100]),
            23 => clear(&mut flat[104..110]),
            27 => clear(&mut flat[114..141]),
            29 => clear(&mut flat[143..150]),
            32 => clear(&mut flat[153..160]),
            36 => clear(&mut flat[164..170]),
            40 => clear(&mut flat[174..211]),
            42 => clear(&mut flat[213..220]),
            46 => clear(&mut flat[224..230]),
            50 => clear(&mut flat[234..281]),
            52 => clear(&mut flat[283..290]),
            56 => clear(&mut flat[294..351]),
            58 => clear(&mut flat[353..360]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
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
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let k0 = S::constant(-GRAVITY[2]);
    let k1 = S::constant(-constants::A2);
    let k3 = S::constant(-constants::A3);
    let k_A3 = S::constant(constants::A3);
    let k_D4 = S::constant(constants::D4);
    let k_D5 = S::constant(constants::D5);
    let k_D6 = S::constant(constants::D6);
    // link 2: motion
    let [a2_x, a2_y] = {
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        let t2 = -a2_x;
        put(12, a2_y); // row 2, MSX2
        put(13, t2); // row 2, MSY2
        [a2_x, a2_y]
    };
    // link 3: motion
    let [z1_3_x, z1_3_y, a3_x, t14] = {
        let z1_3_x = s2 * c3 + c2 * s3;
        let z1_3_y = c2 * c3 - s2 * s3;
        let a3_x = c3 * a2_x + s3 * a2_y;
        let t14 = s3 * a2_x - c3 * a2_y;
        let t15 = -t14;
        let t16 = -a3_x;
        put(15, t15); // row 2, MSX3
        put(16, t16); // row 2, MSY3
        put(28, t15); // row 3, MSX3
        put(29, t16); // row 3, MSY3
        [z1_3_x, z1_3_y, a3_x, t14]
    };
    // link 4: motion
    let [z1_4_x, t22, t25, t28] = {
        let z1_4_x = c4 * z1_3_x + s4 * z1_3_y;
        let t22 = s4 * z1_3_x - c4 * z1_3_y;
        let t25 = s4 * t14 - c4 * a3_x;
        let t28 = c4 * t14 + s4 * a3_x;
        let t29 = -t28;
        put(18, t29); // row 2, MSX4
        put(19, t25); // row 2, MSY4
        put(31, t29); // row 3, MSX4
        put(32, t25); // row 3, MSY4
        put(41, t29); // row 4, MSX4
        put(42, t25); // row 4, MSY4
        [z1_4_x, t22, t25, t28]
    };
    // link 5: motion
    let [t30, a5_y] = {
        let t30 = c5 * t25;
        let a5_y = s5 * t25;
        put(51, a5_y); // row 5, MSX5
        put(52, t30); // row 5, MSY5
        [t30, a5_y]
    };
    // link 6: motion
    let [t34, a6_y] = {
        let t34 = c6 * t30 + s6 * t28;
        let a6_y = s6 * t30 - c6 * t28;
        put(57, a6_y); // row 6, MSX6
        put(58, t34); // row 6, MSY6
        [t34, a6_y]
    };
    // joint axes in frame 3
    let [v1_3_z, t39, t40] = {
        let v1_3_z = c2 * k1;
        let t39 = s3 * k1;
        let t40 = c3 * k1;
        [v1_3_z, t39, t40]
    };
    // joint axes in frame 4
    let [v1_4_z, t47, v1_5_z, t54, t57, t58, v3_5_z] = {
        let t41 = k_D4 * z1_3_y;
        let t42 = k_D4 * z1_3_x;
        let v1_4_z = v1_3_z + z1_3_y * k3;
        let t47 = s4 * t42 - c4 * t41;
        let v1_5_z = c4 * t42 + s4 * t41;
        let t51 = t40 - k_A3;
        let t54 = c4 * t39 + s4 * t51;
        let t57 = c4 * t51 - s4 * t39;
        let t58 = s4 * k3;
        let v3_5_z = c4 * k3;
        [v1_4_z, t47, v1_5_z, t54, t57, t58, v3_5_z]
    };
    // MSZ2: column
    {
        let t62 = c2 * a2_x - s2 * a2_y;
        put(0, t62); // row 1, MSZ2
    }
    // M3: column
    {
        let t65 = t14 * t40 - a3_x * t39;
        put(14, t65); // row 2, M3
    }
    // MSZ3: column
    {
        let t68 = z1_3_x * t14 + z1_3_y * a3_x;
        put(1, t68); // row 1, MSZ3
    }
    // M4: column
    let [t70, t73, t76] = {
        let t70 = t28 * v1_5_z;
        let t71 = t25 * t47 + t70;
        let t73 = t28 * t57;
        let t74 = t25 * t54 + t73;
        let t76 = t28 * v3_5_z;
        let t77 = t25 * t58 + t76;
        put(2, t71); // row 1, M4
        put(17, t74); // row 2, M4
        put(30, t77); // row 3, M4
        [t70, t73, t76]
    };
    // MSZ4: column
    {
        let t80 = z1_4_x * t28 + t22 * t25;
        put(3, t80); // row 1, MSZ4
    }
    // M5: column
    let [t82, t85, t86] = {
        let t82 = s5 * a5_y;
        let t83 = c5 * t30 + t82;
        let t85 = c5 * a5_y;
        let t86 = s5 * t30 - t85;
        let t88 = k_D5 * t83;
        let t94 = z1_4_x * (k_D5 * t86) + (t70 + t47 * t83 - v1_4_z * t86);
        let t97 = t73 + t54 * t83 - t88;
        let t100 = t76 + t58 * t83 - t88;
        let t101 = -t83;
        let t102 = -t88;
        put(4, t94); // row 1, M5
        put(20, t97); // row 2, M5
        put(23, t101); // row 2, MSZ5
        put(33, t100); // row 3, M5
        put(36, t101); // row 3, MSZ5
        put(43, t102); // row 4, M5
        put(46, t101); // row 4, MSZ5
        [t82, t85, t86]
    };
    // MSX5: column
    let t104 = {
        let t103 = s5 * t28;
        let t104 = c5 * t28;
        let t107 = z1_4_x * t103 + t22 * a5_y;
        let t108 = -t104;
        put(5, t107); // row 1, MSX5
        put(21, t108); // row 2, MSX5
        put(22, t103); // row 2, MSY5
        put(34, t108); // row 3, MSX5
        put(35, t103); // row 3, MSY5
        put(44, t108); // row 4, MSX5
        put(45, t103); // row 4, MSY5
        t104
    };
    // MSY5: column
    {
        let t111 = z1_4_x * t104 + t22 * t30;
        put(6, t111); // row 1, MSY5
    }
    // MSZ5: column
    {
        let t112 = z1_4_x * t86;
        put(7, t112); // row 1, MSZ5
    }
    // M6: column
    let [t115, t118] = {
        let t115 = c6 * t34 + s6 * a6_y;
        let t118 = s6 * t34 - c6 * a6_y;
        let t119 = k_D6 * t118;
        let t120 = k_D6 * t115;
        let t122 = t82 + c5 * t115;
        let t124 = s5 * t115 - t85;
        let t130 = s5 * t119 - k_D5 * t122;
        let t138 = v1_4_z * t124 - (t47 * t122 + v1_5_z * t118);
        let t139 = z1_4_x * (c5 * t119 + k_D5 * t124) + t22 * t120 - t138;
        let t143 = t130 + (t54 * t122 + t57 * t118);
        let t147 = t130 + (t58 * t122 + v3_5_z * t118);
        put(8, t139); // row 1, M6
        put(24, t143); // row 2, M6
        put(37, t147); // row 3, M6
        put(47, t130); // row 4, M6
        put(53, t120); // row 5, M6
        put(56, t115); // row 5, MSZ6
        [t115, t118]
    };
    // MSX6: column
    let [t148, t149] = {
        let t148 = s6 * a5_y;
        let t149 = c6 * a5_y;
        let t155 = s5 * t148 + c5 * a6_y;
        let t158 = t22 * t149 - z1_4_x * (s5 * a6_y - c5 * t148);
        let t159 = -t148;
        put(9, t158); // row 1, MSX6
        put(25, t155); // row 2, MSX6
        put(38, t155); // row 3, MSX6
        put(48, t155); // row 4, MSX6
        put(54, t149); // row 5, MSX6
        put(55, t159); // row 5, MSY6
        [t148, t149]
    };
    // MSY6: column
    {
        let t165 = s5 * t149 + c5 * t34;
        let t168 = z1_4_x * (c5 * t149 - s5 * t34) - t22 * t148;
        put(10, t168); // row 1, MSY6
        put(26, t165); // row 2, MSY6
        put(39, t165); // row 3, MSY6
        put(49, t165); // row 4, MSY6
    }
    // MSZ6: column
    {
        let t170 = s5 * t118;
        let t173 = z1_4_x * (c5 * t118) + t22 * t115;
        put(11, t173); // row 1, MSZ6
        put(27, t170); // row 2, MSZ6
        put(40, t170); // row 3, MSZ6
        put(50, t170); // row 4, MSZ6
    }
}
