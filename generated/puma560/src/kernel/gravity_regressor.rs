//! Regressor at rest.
//!
//! `g = W_g phi` of the links' parameters; columns as the first of `STANDARD_NAMES`, without the
//! drives'.
//!
//! 141 multiplications, 79 additions; 6 x 60, 62 of 360 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 62;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 10), (0, 13), (0, 20), (0, 23), (0, 30), (0, 31), (0, 32), (0, 33), (0, 40), (0, 41),
    (0, 42), (0, 43), (0, 50), (0, 51), (0, 52), (0, 53), (1, 11), (1, 12), (1, 20), (1, 21),
    (1, 22), (1, 30), (1, 31), (1, 32), (1, 33), (1, 40), (1, 41), (1, 42), (1, 43), (1, 50),
    (1, 51), (1, 52), (1, 53), (2, 21), (2, 22), (2, 30), (2, 31), (2, 32), (2, 33), (2, 40),
    (2, 41), (2, 42), (2, 43), (2, 50), (2, 51), (2, 52), (2, 53), (3, 31), (3, 32), (3, 41),
    (3, 42), (3, 43), (3, 51), (3, 52), (3, 53), (4, 41), (4, 42), (4, 51), (4, 52), (4, 53),
    (5, 51), (5, 52),
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
            0 => clear(&mut flat[11..13]),
            1 => clear(&mut flat[14..20]),
            2 => clear(&mut flat[21..23]),
            3 => clear(&mut flat[24..30]),
            7 => clear(&mut flat[34..40]),
            11 => clear(&mut flat[44..50]),
            15 => clear(&mut flat[54..71]),
            17 => clear(&mut flat[73..80]),
            20 => clear(&mut flat[83..90]),
            24 => clear(&mut flat[94..100]),
            28 => clear(&mut flat[104..110]),
            32 => clear(&mut flat[114..141]),
            34 => clear(&mut flat[143..150]),
            38 => clear(&mut flat[154..160]),
            42 => clear(&mut flat[164..170]),
            46 => clear(&mut flat[174..211]),
            48 => clear(&mut flat[213..221]),
            51 => clear(&mut flat[224..231]),
            54 => clear(&mut flat[234..281]),
            56 => clear(&mut flat[283..291]),
            59 => clear(&mut flat[294..351]),
            61 => clear(&mut flat[353..360]),
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
    let k2 = S::constant(-(-constants::D3 - constants::D2));
    let k3 = S::constant(-constants::A3);
    let k5 = S::constant(0.2435);
    let k_A2 = S::constant(constants::A2);
    let k_D4 = S::constant(constants::D4);
    // link 2: motion
    let [t0, t1] = {
        let t0 = s2 * k0;
        let t1 = c2 * k0;
        let t2 = -t1;
        put(16, t2); // row 2, MSX2
        put(17, t0); // row 2, MSY2
        [t0, t1]
    };
    // link 3: motion
    let [t5, t8, t11, a3_y] = {
        let t5 = s2 * c3 + c2 * s3;
        let t8 = c2 * c3 - s2 * s3;
        let t11 = c3 * t0 + s3 * t1;
        let a3_y = s3 * t0 - c3 * t1;
        put(19, a3_y); // row 2, MSX3
        put(20, t11); // row 2, MSY3
        put(33, a3_y); // row 3, MSX3
        put(34, t11); // row 3, MSY3
        [t5, t8, t11, a3_y]
    };
    // link 4: motion
    let [t15, z1_4_y, t17, a4_y] = {
        let t15 = c4 * t5;
        let z1_4_y = s4 * t5;
        let t17 = c4 * t11;
        let a4_y = s4 * t11;
        put(47, a4_y); // row 4, MSX4
        put(48, t17); // row 4, MSY4
        [t15, z1_4_y, t17, a4_y]
    };
    // link 5: motion
    let [t21, a5_y] = {
        let t21 = c5 * t17 - s5 * a3_y;
        let a5_y = c5 * a3_y + s5 * t17;
        put(55, a5_y); // row 5, MSX5
        put(56, t21); // row 5, MSY5
        [t21, a5_y]
    };
    // link 6: motion
    let [t27, a6_y] = {
        let t27 = c6 * t21 - s6 * a4_y;
        let a6_y = c6 * a4_y + s6 * t21;
        put(60, a6_y); // row 6, MSX6
        put(61, t27); // row 6, MSY6
        [t27, a6_y]
    };
    // joint axes in frame 3
    let [v1_3_z, t36, v1_3_y, v2_3_x, v2_3_y] = {
        let v1_3_z = c2 * k_A2;
        let t32 = c2 * k2;
        let t33 = s2 * k2;
        let t36 = c3 * t32 - s3 * t33;
        let v1_3_y = c3 * t33 + s3 * t32;
        let v2_3_x = s3 * k_A2;
        let v2_3_y = c3 * k_A2;
        [v1_3_z, t36, v1_3_y, v2_3_x, v2_3_y]
    };
    // joint axes in frame 4
    let [t48, v1_4_y, t53, v2_4_x, t55, v3_4_x, t57] = {
        let t45 = v1_3_z - (t8 * k3 - k_D4 * t5);
        let t48 = c4 * t36 - s4 * t45;
        let v1_4_y = c4 * t45 + s4 * t36;
        let t52 = k_D4 + v2_3_x;
        let t53 = v2_3_y - k3;
        let v2_4_x = c4 * t52;
        let t55 = s4 * t52;
        let v3_4_x = c4 * k_D4;
        let t57 = s4 * k_D4;
        [t48, v1_4_y, t53, v2_4_x, t55, v3_4_x, t57]
    };
    // M2: column
    let t60 = {
        let t60 = c2 * t0 - s2 * t1;
        put(1, t60); // row 1, MSZ2
        t60
    };
    // MSZ2: column
    {
        let t61 = k5 * t60;
        put(0, t61); // row 1, M2
    }
    // M3: column
    let t63 = {
        let t63 = a3_y * v1_3_y;
        let t64 = t11 * t36 + t63;
        let t67 = a3_y * v2_3_y - t11 * v2_3_x;
        put(2, t64); // row 1, M3
        put(18, t67); // row 2, M3
        t63
    };
    // MSZ3: column
    {
        let t70 = t5 * a3_y + t8 * t11;
        put(3, t70); // row 1, MSZ3
    }
    // M4: column
    let [t72, t76, t81] = {
        let t72 = a4_y * v1_4_y;
        let t74 = t63 + (t17 * t48 + t72);
        let t76 = a4_y * t55;
        let t79 = a3_y * t53 - (t17 * v2_4_x + t76);
        let t81 = a4_y * t57;
        let t85 = -(a3_y * k3 + (t17 * v3_4_x + t81));
        put(4, t74); // row 1, M4
        put(21, t79); // row 2, M4
        put(35, t85); // row 3, M4
        [t72, t76, t81]
    };
    // joint axes in frame 5
    let [
        t88, t91, v1_5_x, v1_5_y, z2_5_x, z2_6_z, v2_5_x, t105,
        t108, v3_6_z,
    ] = {
        let t88 = c5 * t15 + s5 * t8;
        let t91 = c5 * t8 - s5 * t15;
        let v1_5_x = s5 * v1_3_y - c5 * t48;
        let v1_5_y = c5 * v1_3_y + s5 * t48;
        let z2_5_x = s4 * c5;
        let z2_6_z = s4 * s5;
        let v2_5_x = c5 * v2_4_x + s5 * t53;
        let t105 = c5 * t53 - s5 * v2_4_x;
        let t108 = s5 * k3 - c5 * v3_4_x;
        let v3_6_z = c5 * k3 + s5 * v3_4_x;
        [
        t88, t91, v1_5_x, v1_5_y, z2_5_x, z2_6_z, v2_5_x, t105,
        t108, v3_6_z,
    ]
    };
    // MSX4: column
    {
        let t114 = a3_y * z1_4_y + t8 * a4_y;
        let t115 = c4 * a3_y;
        put(5, t114); // row 1, MSX4
        put(22, t115); // row 2, MSX4
        put(36, t115); // row 3, MSX4
    }
    // MSY4: column
    {
        let t118 = a3_y * t15 + t8 * t17;
        let t120 = -(s4 * a3_y);
        put(6, t118); // row 1, MSY4
        put(23, t120); // row 2, MSY4
        put(37, t120); // row 3, MSY4
    }
    // MSZ4: column
    {
        let t123 = t15 * a4_y - z1_4_y * t17;
        let t127 = -(s4 * a4_y + c4 * t17);
        put(7, t123); // row 1, MSZ4
        put(24, t127); // row 2, MSZ4
        put(38, t127); // row 3, MSZ4
    }
    // M5: column
    let [t129, t133, t137] = {
        let t129 = a5_y * v1_5_y;
        let t131 = t72 + (t129 - t21 * v1_5_x);
        let t133 = a5_y * t105;
        let t135 = t133 - t21 * v2_5_x - t76;
        let t137 = a5_y * v3_6_z;
        let t139 = t21 * t108 - t137 - t81;
        put(8, t131); // row 1, M5
        put(25, t135); // row 2, M5
        put(39, t139); // row 3, M5
        [t129, t133, t137]
    };
    // MSX5: column
    {
        let t142 = a4_y * t91 + z1_4_y * a5_y;
        let t145 = a4_y * z2_6_z + c4 * a5_y;
        let t146 = c5 * a4_y;
        put(9, t142); // row 1, MSX5
        put(26, t145); // row 2, MSX5
        put(40, t145); // row 3, MSX5
        put(49, t146); // row 4, MSX5
    }
    // MSY5: column
    {
        let t149 = z1_4_y * t21 - a4_y * t88;
        let t152 = a4_y * z2_5_x + c4 * t21;
        let t154 = -(s5 * a4_y);
        put(10, t149); // row 1, MSY5
        put(27, t152); // row 2, MSY5
        put(41, t152); // row 3, MSY5
        put(50, t154); // row 4, MSY5
    }
    // MSZ5: column
    {
        let t157 = a5_y * t88 + t21 * t91;
        let t160 = t21 * z2_6_z - a5_y * z2_5_x;
        let t163 = s5 * a5_y + c5 * t21;
        put(11, t157); // row 1, MSZ5
        put(28, t160); // row 2, MSZ5
        put(42, t160); // row 3, MSZ5
        put(51, t163); // row 4, MSZ5
    }
    // M6: column
    let [t166, t169] = {
        let t166 = c6 * t27 + s6 * a6_y;
        let t169 = c6 * a6_y - s6 * t27;
        let t173 = v1_4_y * t169 - (v1_5_x * t166 - t129);
        let t177 = t133 - v2_5_x * t166 - t55 * t169;
        let t181 = t108 * t166 - t137 - t57 * t169;
        let t182 = -t166;
        put(12, t173); // row 1, M6
        put(29, t177); // row 2, M6
        put(43, t181); // row 3, M6
        put(59, t182); // row 5, MSZ6
        [t166, t169]
    };
    // MSX6: column
    let [t183, t184] = {
        let t183 = s6 * a5_y;
        let t184 = c6 * a5_y;
        let t189 = z1_4_y * t184 + (t88 * t183 + a6_y * t91);
        let t194 = c4 * t184 + (a6_y * z2_6_z - z2_5_x * t183);
        let t197 = s5 * t183 + c5 * a6_y;
        let t198 = -t183;
        put(13, t189); // row 1, MSX6
        put(30, t194); // row 2, MSX6
        put(44, t194); // row 3, MSX6
        put(52, t197); // row 4, MSX6
        put(57, t184); // row 5, MSX6
        put(58, t198); // row 5, MSY6
        [t183, t184]
    };
    // MSY6: column
    {
        let t203 = t88 * t184 + t27 * t91 - z1_4_y * t183;
        let t208 = t27 * z2_6_z - z2_5_x * t184 - c4 * t183;
        let t211 = s5 * t184 + c5 * t27;
        put(14, t203); // row 1, MSY6
        put(31, t208); // row 2, MSY6
        put(45, t208); // row 3, MSY6
        put(53, t211); // row 4, MSY6
    }
    // MSZ6: column
    {
        let t214 = t88 * t169 - z1_4_y * t166;
        let t218 = s5 * t169;
        let t219 = -(z2_5_x * t169 + c4 * t166);
        put(15, t214); // row 1, MSZ6
        put(32, t219); // row 2, MSZ6
        put(46, t219); // row 3, MSZ6
        put(54, t218); // row 4, MSZ6
    }
}
