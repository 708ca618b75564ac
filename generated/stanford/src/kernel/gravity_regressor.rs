//! Regressor at rest.
//!
//! `g = W_g phi` of the links' parameters; columns as the first of `STANDARD_NAMES`, without the
//! drives'.
//!
//! 113 multiplications, 68 additions; 6 x 60, 54 of 360 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 54;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 10), (0, 12), (0, 20), (0, 21), (0, 30), (0, 31), (0, 32), (0, 33), (0, 40), (0, 41),
    (0, 42), (0, 43), (0, 50), (0, 51), (0, 52), (0, 53), (1, 11), (1, 13), (1, 20), (1, 22),
    (1, 23), (1, 30), (1, 31), (1, 32), (1, 33), (1, 40), (1, 41), (1, 42), (1, 43), (1, 50),
    (1, 51), (1, 52), (1, 53), (2, 20), (2, 30), (2, 40), (2, 50), (3, 31), (3, 33), (3, 41),
    (3, 42), (3, 43), (3, 50), (3, 51), (3, 52), (3, 53), (4, 41), (4, 43), (4, 50), (4, 51),
    (4, 52), (4, 53), (5, 51), (5, 52),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 60 + PATTERN[k].1
}

/// Regressor at rest: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 60]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    clear(&mut flat[0..10]);
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => flat[11] = S::default(),
            1 => clear(&mut flat[13..20]),
            3 => clear(&mut flat[22..30]),
            7 => clear(&mut flat[34..40]),
            11 => clear(&mut flat[44..50]),
            15 => clear(&mut flat[54..71]),
            16 => flat[72] = S::default(),
            17 => clear(&mut flat[74..80]),
            18 => flat[81] = S::default(),
            20 => clear(&mut flat[84..90]),
            24 => clear(&mut flat[94..100]),
            28 => clear(&mut flat[104..110]),
            32 => clear(&mut flat[114..140]),
            33 => clear(&mut flat[141..150]),
            34 => clear(&mut flat[151..160]),
            35 => clear(&mut flat[161..170]),
            36 => clear(&mut flat[171..211]),
            37 => flat[212] = S::default(),
            38 => clear(&mut flat[214..221]),
            41 => clear(&mut flat[224..230]),
            45 => clear(&mut flat[234..281]),
            46 => flat[282] = S::default(),
            47 => clear(&mut flat[284..290]),
            51 => clear(&mut flat[294..351]),
            53 => clear(&mut flat[353..360]),
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
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let k0 = S::constant(-GRAVITY[2]);
    let k_D2 = S::constant(constants::D2);
    let k_D6 = S::constant(constants::D6);
    // link 2: motion
    let [t0, a3_z] = {
        let t0 = s2 * k0;
        let a3_z = c2 * k0;
        let t2 = -a3_z;
        let t3 = -t0;
        put(16, t2); // row 2, MSX2
        put(17, t3); // row 2, MSZ2
        put(19, t2); // row 2, MSY3
        put(20, t3); // row 2, MSZ3
        put(33, a3_z); // row 3, M3
        put(34, a3_z); // row 3, M4
        [t0, a3_z]
    };
    // link 4: motion
    let [t4, t5, t6, t7] = {
        let t4 = s2 * s4;
        let t5 = s2 * c4;
        let t6 = s4 * t0;
        let t7 = c4 * t0;
        let t8 = -t7;
        put(37, t8); // row 4, MSX4
        put(38, t6); // row 4, MSZ4
        [t4, t5, t6, t7]
    };
    // link 5: motion
    let [t11, a5_y] = {
        let t11 = c5 * t6 + s5 * a3_z;
        let a5_y = s5 * t6 - c5 * a3_z;
        let t15 = -t11;
        put(46, a5_y); // row 5, MSX5
        put(47, t15); // row 5, MSZ5
        [t11, a5_y]
    };
    // link 6: motion
    let [t18, a6_y] = {
        let t18 = c6 * t11 + s6 * t7;
        let a6_y = s6 * t11 - c6 * t7;
        put(52, a6_y); // row 6, MSX6
        put(53, t18); // row 6, MSY6
        [t18, a6_y]
    };
    // joint axes in frame 2
    let [t22, v1_2_y] = {
        let t22 = c2 * k_D2;
        let v1_2_y = s2 * k_D2;
        [t22, v1_2_y]
    };
    // joint axes in frame 4
    let [t24, t25] = {
        let t24 = s4 * t22;
        let t25 = c4 * t22;
        [t24, t25]
    };
    // M2: column
    let t27 = {
        let t27 = a3_z * v1_2_y;
        let t28 = t0 * t22 - t27;
        put(0, t28); // row 1, M2
        put(2, t28); // row 1, M3
        t27
    };
    // MSY2: column
    {
        let t31 = c2 * t0 - s2 * a3_z;
        let t32 = -t31;
        put(1, t31); // row 1, MSY2
        put(3, t32); // row 1, MSX3
    }
    // M3: column
    {
        let t34 = -(q3 * t0);
        put(18, t34); // row 2, M3
    }
    // M4: column
    let t37 = {
        let t37 = s4 * t7 - c4 * t6;
        let t40 = s4 * t6 + c4 * t7;
        let t46 = t22 * t40 - t27 - s2 * (q3 * t37);
        let t47 = -(q3 * t40);
        put(4, t46); // row 1, M4
        put(21, t47); // row 2, M4
        put(23, t40); // row 2, MSY4
        t37
    };
    // MSX4: column
    let t48 = {
        let t48 = s4 * a3_z;
        let t49 = c4 * a3_z;
        let t52 = s2 * t49 - c2 * t7;
        let t53 = -t48;
        let t54 = -t49;
        put(5, t52); // row 1, MSX4
        put(22, t53); // row 2, MSX4
        put(24, t54); // row 2, MSZ4
        t48
    };
    // MSY4: column
    {
        let t55 = s2 * t37;
        put(6, t55); // row 1, MSY4
    }
    // MSZ4: column
    {
        let t58 = c2 * t6 - s2 * t48;
        put(7, t58); // row 1, MSZ4
    }
    // M5: column
    let [t60, t61, t63, t64] = {
        let t60 = s5 * a5_y;
        let t61 = c5 * t11 + t60;
        let t63 = c5 * a5_y;
        let t64 = t63 - s5 * t11;
        let t65 = q3 * t7;
        let t66 = q3 * t61;
        let t74 = v1_2_y * t64 + (t24 * t61 + t7 * t25);
        let t75 = t5 * t66 - t4 * t65 + t74;
        let t79 = -(c4 * t65 + s4 * t66);
        let t80 = -t64;
        put(8, t75); // row 1, M5
        put(25, t79); // row 2, M5
        put(35, t80); // row 3, M5
        put(40, t61); // row 4, MSY5
        [t60, t61, t63, t64]
    };
    // MSX5: column
    let [t81, t82] = {
        let t81 = s5 * t7;
        let t82 = c5 * t7;
        let t87 = t4 * t81 - t5 * a5_y - c2 * t82;
        let t90 = c4 * t81 + s4 * a5_y;
        let t91 = -t82;
        let t92 = -t81;
        put(9, t87); // row 1, MSX5
        put(26, t90); // row 2, MSX5
        put(39, t91); // row 4, MSX5
        put(41, t92); // row 4, MSZ5
        [t81, t82]
    };
    // MSY5: column
    {
        let t95 = t4 * t64 + c2 * t61;
        let t96 = c4 * t64;
        put(10, t95); // row 1, MSY5
        put(27, t96); // row 2, MSY5
    }
    // MSZ5: column
    {
        let t101 = t5 * t11 - t4 * t82 - c2 * t81;
        let t105 = -(c4 * t82 + s4 * t11);
        put(11, t101); // row 1, MSZ5
        put(28, t105); // row 2, MSZ5
    }
    // M6: column
    let [t108, t111] = {
        let t108 = c6 * t18 + s6 * a6_y;
        let t111 = c6 * a6_y - s6 * t18;
        let t112 = k_D6 * t111;
        let t113 = k_D6 * t108;
        let t115 = t60 + c5 * t108;
        let t117 = s5 * t108 - t63;
        let t119 = s5 * t112;
        let t122 = c5 * t112 + q3 * t111;
        let t123 = t113 + q3 * t115;
        let t133 = v1_2_y * t117 + (t25 * t111 - t24 * t115);
        let t134 = c2 * t119 + (t4 * t122 + t5 * t123) - t133;
        let t137 = c4 * t122 - s4 * t123;
        let t138 = -t113;
        let t139 = -t108;
        put(12, t134); // row 1, M6
        put(29, t137); // row 2, M6
        put(36, t117); // row 3, M6
        put(42, t119); // row 4, M6
        put(48, t138); // row 5, M6
        put(51, t139); // row 5, MSZ6
        [t108, t111]
    };
    // MSX6: column
    let [t140, t141] = {
        let t140 = s6 * a5_y;
        let t141 = c6 * a5_y;
        let t144 = c5 * t140 - s5 * a6_y;
        let t147 = s5 * t140 + c5 * a6_y;
        let t152 = c2 * t147 + (t4 * t144 - t5 * t141);
        let t155 = c4 * t144 + s4 * t141;
        let t156 = -t140;
        put(13, t152); // row 1, MSX6
        put(30, t155); // row 2, MSX6
        put(43, t147); // row 4, MSX6
        put(49, t141); // row 5, MSX6
        put(50, t156); // row 5, MSY6
        [t140, t141]
    };
    // MSY6: column
    {
        let t159 = c5 * t141 - s5 * t18;
        let t162 = s5 * t141 + c5 * t18;
        let t167 = c2 * t162 + (t4 * t159 + t5 * t140);
        let t170 = c4 * t159 - s4 * t140;
        put(14, t167); // row 1, MSY6
        put(31, t170); // row 2, MSY6
        put(44, t162); // row 4, MSY6
    }
    // MSZ6: column
    {
        let t171 = c5 * t111;
        let t172 = s5 * t111;
        let t177 = c2 * t172 + (t4 * t171 + t5 * t108);
        let t180 = c4 * t171 - s4 * t108;
        put(15, t177); // row 1, MSZ6
        put(32, t180); // row 2, MSZ6
        put(45, t172); // row 4, MSZ6
    }
}
