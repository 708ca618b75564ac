//! Kinetic energy, one entry per standard parameter.
//!
//! `T = h phi`, J per unit. Khalil and Dombre, 9.4.
//!
//! 143 multiplications, 53 additions; 84, 57 of 84 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 57;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (6, 0), (14, 0), (15, 0), (16, 0), (17, 0), (18, 0), (19, 0), (20, 0), (21, 0), (22, 0),
    (23, 0), (24, 0), (25, 0), (26, 0), (27, 0), (28, 0), (29, 0), (30, 0), (31, 0), (32, 0),
    (33, 0), (34, 0), (35, 0), (36, 0), (37, 0), (38, 0), (39, 0), (40, 0), (41, 0), (42, 0),
    (43, 0), (44, 0), (45, 0), (46, 0), (47, 0), (48, 0), (49, 0), (50, 0), (51, 0), (52, 0),
    (53, 0), (54, 0), (55, 0), (56, 0), (57, 0), (58, 0), (59, 0), (60, 0), (61, 0), (62, 0),
    (63, 0), (64, 0), (65, 0), (66, 0), (67, 0), (68, 0), (69, 0),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 1 + PATTERN[k].1
}

/// Kinetic energy, one entry per standard parameter: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 84]) {
    let flat = &mut out[..];
    clear(&mut flat[0..6]);
    entries(trig, dq, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[7..14]),
            56 => clear(&mut flat[70..84]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 84]) {
    entries(trig, dq, |k, x| {
        out[PATTERN[k].0] = x;
    });
}

/// The same, only the entries of [`PATTERN`].
#[inline]
pub fn packed<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; NONZEROS]) {
    entries(trig, dq, |k, x| out[k] = x);
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6, dq7] = *dq;
    let k2 = S::constant(0.5);
    let k_L2 = S::constant(constants::L2);
    let k_L3 = S::constant(constants::L3);
    // link 2: velocity
    let [t0, t1] = {
        let t0 = s2 * dq1;
        let t1 = c2 * dq1;
        [t0, t1]
    };
    // link 3: velocity
    let [t6, t9, t12, t15, t16] = {
        let t2 = k_L2 * dq2;
        let t3 = k_L2 * t0;
        let t6 = c3 * t0 - s3 * dq2;
        let t9 = c3 * dq2 + s3 * t0;
        let t12 = c3 * t2 + s3 * t3;
        let t15 = s3 * t2 - c3 * t3;
        let t16 = t1 + dq3;
        [t6, t9, t12, t15, t16]
    };
    // link 4: velocity
    let [t19, t22, t23, t24, t25] = {
        let t19 = c4 * t6 - s4 * t16;
        let t22 = c4 * t16 + s4 * t6;
        let t23 = c4 * t12;
        let t24 = s4 * t12;
        let t25 = dq4 - t9;
        [t19, t22, t23, t24, t25]
    };
    // link 5: velocity
    let [t32, t35, t38, t41, t42] = {
        let t28 = k_L3 * t25 - t23;
        let t29 = k_L3 * t19 - t15;
        let t32 = c5 * t19 + s5 * t25;
        let t35 = c5 * t25 - s5 * t19;
        let t38 = s5 * t29 - c5 * t28;
        let t41 = c5 * t29 + s5 * t28;
        let t42 = t22 + dq5;
        [t32, t35, t38, t41, t42]
    };
    // link 6: velocity
    let [t45, t48, t51, t54, t55] = {
        let t45 = c6 * t32 + s6 * t42;
        let t48 = s6 * t32 - c6 * t42;
        let t51 = c6 * t38 + s6 * t24;
        let t54 = c6 * t24 - s6 * t38;
        let t55 = dq6 - t35;
        [t45, t48, t51, t54, t55]
    };
    // link 7: velocity
    let [t58, t61, t64, t67, t68] = {
        let t58 = s7 * t55 - c7 * t45;
        let t61 = c7 * t55 + s7 * t45;
        let t64 = c7 * t51 + s7 * t41;
        let t67 = c7 * t41 - s7 * t51;
        let t68 = t48 - dq7;
        [t58, t61, t64, t67, t68]
    };
    // kinetic energy
    {
        let t70 = k2 * (dq1 * dq1);
        let t72 = k2 * (t0 * t0);
        let t74 = k2 * (t1 * t1);
        let t76 = k2 * (dq2 * dq2);
        let t77 = t0 * t1;
        let t78 = dq2 * t0;
        let t79 = dq2 * t1;
        let t80 = t15 * t16;
        let t81 = t12 * t16;
        let t84 = t9 * t12 - t6 * t15;
        let t86 = t15 * t15;
        let t88 = k2 * (t12 * t12 + t86);
        let t90 = k2 * (t6 * t6);
        let t92 = k2 * (t9 * t9);
        let t94 = k2 * (t16 * t16);
        let t96 = t6 * t16;
        let t100 = t24 * t25 + t15 * t22;
        let t103 = t15 * t19 + t23 * t25;
        let t106 = t22 * t23 - t19 * t24;
        let t108 = t24 * t24;
        let t111 = k2 * (t86 + (t23 * t23 + t108));
        let t113 = k2 * (t19 * t19);
        let t115 = k2 * (t22 * t22);
        let t117 = k2 * (t25 * t25);
        let t119 = t19 * t25;
        let t123 = t24 * t35 - t41 * t42;
        let t126 = t38 * t42 - t24 * t32;
        let t129 = t32 * t41 - t35 * t38;
        let t131 = t41 * t41;
        let t134 = k2 * (t108 + (t38 * t38 + t131));
        let t136 = k2 * (t32 * t32);
        let t138 = k2 * (t35 * t35);
        let t140 = k2 * (t42 * t42);
        let t141 = t32 * t35;
        let t142 = t32 * t42;
        let t143 = t35 * t42;
        let t146 = t41 * t48 - t54 * t55;
        let t149 = t41 * t45 + t51 * t55;
        let t152 = t48 * t51 + t45 * t54;
        let t154 = t54 * t54;
        let t157 = k2 * (t131 + (t51 * t51 + t154));
        let t159 = k2 * (t45 * t45);
        let t161 = k2 * (t48 * t48);
        let t163 = k2 * (t55 * t55);
        let t165 = t45 * t55;
        let t169 = t67 * t68 - t54 * t61;
        let t172 = t54 * t58 - t64 * t68;
        let t175 = t61 * t64 - t58 * t67;
        let t180 = k2 * (t154 + (t64 * t64 + t67 * t67));
        let t182 = k2 * (t58 * t58);
        let t184 = k2 * (t61 * t61);
        let t186 = k2 * (t68 * t68);
        let t187 = t58 * t61;
        let t188 = t58 * t68;
        let t189 = t61 * t68;
        let t190 = -(t6 * t9);
        let t191 = -(t9 * t16);
        let t192 = -(t19 * t22);
        let t193 = -(t22 * t25);
        let t194 = -(t45 * t48);
        let t195 = -(t48 * t55);
        put(0, t70);
        put(1, t72);
        put(2, t74);
        put(3, t76);
        put(4, t77);
        put(5, t78);
        put(6, t79);
        put(7, t88);
        put(8, t80);
        put(9, t81);
        put(10, t84);
        put(11, t90);
        put(12, t92);
        put(13, t94);
        put(14, t190);
        put(15, t96);
        put(16, t191);
        put(17, t111);
        put(18, t100);
        put(19, t103);
        put(20, t106);
        put(21, t113);
        put(22, t115);
        put(23, t117);
        put(24, t192);
        put(25, t119);
        put(26, t193);
        put(27, t134);
        put(28, t123);
        put(29, t126);
        put(30, t129);
        put(31, t136);
        put(32, t138);
        put(33, t140);
        put(34, t141);
        put(35, t142);
        put(36, t143);
        put(37, t157);
        put(38, t146);
        put(39, t149);
        put(40, t152);
        put(41, t159);
        put(42, t161);
        put(43, t163);
        put(44, t194);
        put(45, t165);
        put(46, t195);
        put(47, t180);
        put(48, t169);
        put(49, t172);
        put(50, t175);
        put(51, t182);
        put(52, t184);
        put(53, t186);
        put(54, t187);
        put(55, t188);
        put(56, t189);
    }
}
