//! Regressor at rest.
//!
//! `g = W_g phi` for the links' parameters only; columns as the first of `STANDARD_NAMES`.
//!
//! 113 multiplications, 68 additions; 6 x 60, 54 of 360 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{Trig};

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

/// Regressor at rest: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 60]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    flat[0..10].fill(S::default());
    flat[11] = S::default();
    flat[13..20].fill(S::default());
    flat[22..30].fill(S::default());
    flat[34..40].fill(S::default());
    flat[44..50].fill(S::default());
    flat[54..71].fill(S::default());
    flat[72] = S::default();
    flat[74..80].fill(S::default());
    flat[81] = S::default();
    flat[84..90].fill(S::default());
    flat[94..100].fill(S::default());
    flat[104..110].fill(S::default());
    flat[114..140].fill(S::default());
    flat[141..150].fill(S::default());
    flat[151..160].fill(S::default());
    flat[161..170].fill(S::default());
    flat[171..211].fill(S::default());
    flat[212] = S::default();
    flat[214..221].fill(S::default());
    flat[224..230].fill(S::default());
    flat[234..281].fill(S::default());
    flat[282] = S::default();
    flat[284..290].fill(S::default());
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
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let D2 = S::constant(0.154);
    let D6 = S::constant(0.263);
    let k0 = S::constant(9.81);
    // link 2: motion
    let [t0, a3_z] = {
        let t0 = s2 * k0;
        let a3_z = c2 * k0;
        put(33, a3_z); // row 3, M3
        put(34, a3_z); // row 3, M4
        [t0, a3_z]
    };
    // link 4: motion
    let [t2, t3, t4, t5] = {
        let t2 = s2 * s4;
        let t3 = s2 * c4;
        let t4 = s4 * t0;
        let t5 = c4 * t0;
        put(38, t4); // row 4, MSZ4
        [t2, t3, t4, t5]
    };
    // link 5: motion
    let [t8, a5_y] = {
        let t8 = c5 * t4 + s5 * a3_z;
        let a5_y = s5 * t4 - c5 * a3_z;
        put(46, a5_y); // row 5, MSX5
        [t8, a5_y]
    };
    // link 6: motion
    let [t14, a6_y] = {
        let t14 = c6 * t8 + s6 * t5;
        let a6_y = s6 * t8 - c6 * t5;
        put(52, a6_y); // row 6, MSX6
        put(53, t14); // row 6, MSY6
        [t14, a6_y]
    };
    // joint axes in frame 2
    let [t18, v1_2_y] = {
        let t18 = c2 * D2;
        let v1_2_y = s2 * D2;
        [t18, v1_2_y]
    };
    // joint axes in frame 4
    let [t20, t21] = {
        let t20 = s4 * t18;
        let t21 = c4 * t18;
        [t20, t21]
    };
    // M2: column
    let t23 = {
        let t23 = a3_z * v1_2_y;
        let t24 = t0 * t18 - t23;
        put(0, t24); // row 1, M2
        put(2, t24); // row 1, M3
        t23
    };
    // MSY2: column
    let t27 = {
        let t27 = c2 * t0 - s2 * a3_z;
        put(1, t27); // row 1, MSY2
        t27
    };
    // M3: column
    let t28 = {
        let t28 = q3 * t0;
        t28
    };
    // M4: column
    let [t31, t36] = {
        let t31 = s4 * t5 - c4 * t4;
        let t34 = s4 * t4 + c4 * t5;
        let t36 = q3 * t34;
        let t40 = t18 * t34 - t23 - s2 * (q3 * t31);
        put(4, t40); // row 1, M4
        put(23, t34); // row 2, MSY4
        [t31, t36]
    };
    // MSX4: column
    let [t41, t42] = {
        let t41 = s4 * a3_z;
        let t42 = c4 * a3_z;
        let t45 = s2 * t42 - c2 * t5;
        put(5, t45); // row 1, MSX4
        [t41, t42]
    };
    // MSY4: column
    {
        let t46 = s2 * t31;
        put(6, t46); // row 1, MSY4
    }
    // MSZ4: column
    {
        let t49 = c2 * t4 - s2 * t41;
        put(7, t49); // row 1, MSZ4
    }
    // M5: column
    let [t51, t52, t54, t55, t69] = {
        let t51 = s5 * a5_y;
        let t52 = c5 * t8 + t51;
        let t54 = c5 * a5_y;
        let t55 = t54 - s5 * t8;
        let t56 = q3 * t5;
        let t57 = q3 * t52;
        let t65 = v1_2_y * t55 + (t20 * t52 + t5 * t21);
        let t66 = t3 * t57 - t2 * t56 + t65;
        let t69 = c4 * t56 + s4 * t57;
        put(8, t66); // row 1, M5
        put(40, t52); // row 4, MSY5
        [t51, t52, t54, t55, t69]
    };
    // MSX5: column
    let [t70, t71] = {
        let t70 = s5 * t5;
        let t71 = c5 * t5;
        let t76 = t2 * t70 - t3 * a5_y - c2 * t71;
        let t79 = c4 * t70 + s4 * a5_y;
        put(9, t76); // row 1, MSX5
        put(26, t79); // row 2, MSX5
        [t70, t71]
    };
    // MSY5: column
    {
        let t82 = t2 * t55 + c2 * t52;
        let t83 = c4 * t55;
        put(10, t82); // row 1, MSY5
        put(27, t83); // row 2, MSY5
    }
    // MSZ5: column
    let t91 = {
        let t88 = t3 * t8 - t2 * t71 - c2 * t70;
        let t91 = c4 * t71 + s4 * t8;
        put(11, t88); // row 1, MSZ5
        t91
    };
    // M6: column
    let [t94, t97, t99] = {
        let t94 = c6 * t14 + s6 * a6_y;
        let t97 = c6 * a6_y - s6 * t14;
        let t98 = D6 * t97;
        let t99 = D6 * t94;
        let t101 = t51 + c5 * t94;
        let t103 = s5 * t94 - t54;
        let t105 = s5 * t98;
        let t108 = c5 * t98 + q3 * t97;
        let t109 = t99 + q3 * t101;
        let t119 = v1_2_y * t103 + (t21 * t97 - t20 * t101);
        let t120 = c2 * t105 + (t2 * t108 + t3 * t109) - t119;
        let t123 = c4 * t108 - s4 * t109;
        put(12, t120); // row 1, M6
        put(29, t123); // row 2, M6
        put(36, t103); // row 3, M6
        put(42, t105); // row 4, M6
        [t94, t97, t99]
    };
    // MSX6: column
    let [t124, t125] = {
        let t124 = s6 * a5_y;
        let t125 = c6 * a5_y;
        let t128 = c5 * t124 - s5 * a6_y;
        let t131 = s5 * t124 + c5 * a6_y;
        let t136 = c2 * t131 + (t2 * t128 - t3 * t125);
        let t139 = c4 * t128 + s4 * t125;
        put(13, t136); // row 1, MSX6
        put(30, t139); // row 2, MSX6
        put(43, t131); // row 4, MSX6
        put(49, t125); // row 5, MSX6
        [t124, t125]
    };
    // MSY6: column
    {
        let t142 = c5 * t125 - s5 * t14;
        let t145 = s5 * t125 + c5 * t14;
        let t150 = c2 * t145 + (t2 * t142 + t3 * t124);
        let t153 = c4 * t142 - s4 * t124;
        put(14, t150); // row 1, MSY6
        put(31, t153); // row 2, MSY6
        put(44, t145); // row 4, MSY6
    }
    // MSZ6: column
    {
        let t154 = c5 * t97;
        let t155 = s5 * t97;
        let t160 = c2 * t155 + (t2 * t154 + t3 * t94);
        let t163 = c4 * t154 - s4 * t94;
        let t164 = -t27;
        let t165 = -a3_z;
        let t166 = -t0;
        let t167 = -t28;
        let t168 = -t36;
        let t169 = -t41;
        let t170 = -t42;
        let t171 = -t69;
        let t172 = -t91;
        let t173 = -t55;
        let t174 = -t5;
        let t175 = -t71;
        let t176 = -t70;
        let t177 = -t8;
        let t178 = -t99;
        let t179 = -t124;
        let t180 = -t94;
        put(3, t164); // row 1, MSX3
        put(15, t160); // row 1, MSZ6
        put(16, t165); // row 2, MSX2
        put(17, t166); // row 2, MSZ2
        put(18, t167); // row 2, M3
        put(19, t165); // row 2, MSY3
        put(20, t166); // row 2, MSZ3
        put(21, t168); // row 2, M4
        put(22, t169); // row 2, MSX4
        put(24, t170); // row 2, MSZ4
        put(25, t171); // row 2, M5
        put(28, t172); // row 2, MSZ5
        put(32, t163); // row 2, MSZ6
        put(35, t173); // row 3, M5
        put(37, t174); // row 4, MSX4
        put(39, t175); // row 4, MSX5
        put(41, t176); // row 4, MSZ5
        put(45, t155); // row 4, MSZ6
        put(47, t177); // row 5, MSZ5
        put(48, t178); // row 5, M6
        put(50, t179); // row 5, MSY6
        put(51, t180); // row 5, MSZ6
    }
}
