//! Kinetic energy, one entry per standard parameter.
//!
//! `T = h phi`, J per unit. Khalil and Dombre, 9.4.
//!
//! 145 multiplications, 55 additions; 78, 57 of 78 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 57;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (6, 0), (10, 0), (11, 0), (12, 0), (13, 0), (14, 0), (15, 0), (16, 0), (17, 0), (18, 0),
    (19, 0), (20, 0), (21, 0), (22, 0), (23, 0), (24, 0), (25, 0), (26, 0), (27, 0), (28, 0),
    (29, 0), (30, 0), (31, 0), (32, 0), (33, 0), (34, 0), (35, 0), (36, 0), (37, 0), (38, 0),
    (39, 0), (40, 0), (41, 0), (42, 0), (43, 0), (44, 0), (45, 0), (46, 0), (47, 0), (48, 0),
    (49, 0), (50, 0), (51, 0), (52, 0), (53, 0), (54, 0), (55, 0), (56, 0), (57, 0), (58, 0),
    (59, 0), (60, 0), (61, 0), (62, 0), (63, 0), (64, 0), (65, 0),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 1 + PATTERN[k].1
}

/// Kinetic energy, one entry per standard parameter: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 78]) {
    let flat = &mut out[..];
    clear(&mut flat[0..6]);
    entries(trig, dq, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[7..10]),
            56 => clear(&mut flat[66..78]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 78]) {
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
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let k1 = S::constant(-constants::D3);
    let k4 = S::constant(-constants::A3);
    let k5 = S::constant(0.5);
    let k_A2 = S::constant(constants::A2);
    let k_D2 = S::constant(constants::D2);
    let k_D4 = S::constant(constants::D4);
    // link 2: velocity
    let [t1, t2, t3, t4] = {
        let t0 = k_D2 * dq1;
        let t1 = s2 * dq1;
        let t2 = c2 * dq1;
        let t3 = c2 * t0;
        let t4 = s2 * t0;
        [t1, t2, t3, t4]
    };
    // link 3: velocity
    let [t9, t14, t17, t20, t23, t24] = {
        let t9 = k_A2 * t2;
        let t10 = t3 - t2 * k1;
        let t11 = t4 - (t1 * k1 - k_A2 * dq2);
        let t14 = c3 * t1 + s3 * t2;
        let t17 = c3 * t2 - s3 * t1;
        let t20 = c3 * t10 - s3 * t11;
        let t23 = c3 * t11 + s3 * t10;
        let t24 = dq2 + dq3;
        [t9, t14, t17, t20, t23, t24]
    };
    // link 4: velocity
    let [t32, t35, t38, t41, t44, t45] = {
        let t30 = t20 - k_D4 * t24;
        let t31 = t9 + (k_D4 * t14 - t17 * k4);
        let t32 = t24 * k4 - t23;
        let t35 = s4 * t24 - c4 * t14;
        let t38 = c4 * t24 + s4 * t14;
        let t41 = s4 * t31 - c4 * t30;
        let t44 = c4 * t31 + s4 * t30;
        let t45 = t17 + dq4;
        [t32, t35, t38, t41, t44, t45]
    };
    // link 5: velocity
    let [t48, t51, t54, t57, t58] = {
        let t48 = s5 * t45 - c5 * t35;
        let t51 = c5 * t45 + s5 * t35;
        let t54 = s5 * t32 - c5 * t41;
        let t57 = c5 * t32 + s5 * t41;
        let t58 = t38 + dq5;
        [t48, t51, t54, t57, t58]
    };
    // link 6: velocity
    let [t61, t64, t67, t70, t71] = {
        let t61 = s6 * t58 - c6 * t48;
        let t64 = c6 * t58 + s6 * t48;
        let t67 = s6 * t44 - c6 * t54;
        let t70 = c6 * t44 + s6 * t54;
        let t71 = t51 + dq6;
        [t61, t64, t67, t70, t71]
    };
    // kinetic energy
    {
        let t73 = k5 * (dq1 * dq1);
        let t74 = dq2 * t4;
        let t75 = dq2 * t3;
        let t78 = t2 * t3 + t1 * t4;
        let t82 = k5 * (t3 * t3 + t4 * t4);
        let t84 = k5 * (t1 * t1);
        let t86 = k5 * (t2 * t2);
        let t88 = k5 * (dq2 * dq2);
        let t89 = t1 * t2;
        let t94 = t23 * t24 + t9 * t17;
        let t97 = t20 * t24 - t9 * t14;
        let t100 = t17 * t20 + t14 * t23;
        let t106 = k5 * (t9 * t9 + (t20 * t20 + t23 * t23));
        let t108 = k5 * (t14 * t14);
        let t110 = k5 * (t17 * t17);
        let t112 = k5 * (t24 * t24);
        let t113 = t14 * t17;
        let t118 = t44 * t45 - t32 * t38;
        let t121 = t32 * t35 - t41 * t45;
        let t124 = t38 * t41 - t35 * t44;
        let t126 = t44 * t44;
        let t130 = k5 * (t32 * t32 + (t41 * t41 + t126));
        let t132 = k5 * (t35 * t35);
        let t134 = k5 * (t38 * t38);
        let t136 = k5 * (t45 * t45);
        let t137 = t35 * t38;
        let t138 = t35 * t45;
        let t139 = t38 * t45;
        let t142 = t44 * t51 - t57 * t58;
        let t145 = t54 * t58 - t44 * t48;
        let t148 = t51 * t54 - t48 * t57;
        let t150 = t57 * t57;
        let t153 = k5 * (t126 + (t54 * t54 + t150));
        let t155 = k5 * (t48 * t48);
        let t157 = k5 * (t51 * t51);
        let t159 = k5 * (t58 * t58);
        let t160 = t48 * t51;
        let t165 = t70 * t71 - t57 * t64;
        let t168 = t57 * t61 - t67 * t71;
        let t171 = t64 * t67 - t61 * t70;
        let t176 = k5 * (t150 + (t67 * t67 + t70 * t70));
        let t178 = k5 * (t61 * t61);
        let t180 = k5 * (t64 * t64);
        let t182 = k5 * (t71 * t71);
        let t183 = t61 * t64;
        let t184 = t61 * t71;
        let t185 = t64 * t71;
        let t187 = k5 * (dq3 * dq3);
        let t189 = k5 * (dq4 * dq4);
        let t191 = k5 * (dq5 * dq5);
        let t193 = k5 * (dq6 * dq6);
        let t194 = -(dq2 * t1);
        let t195 = -(dq2 * t2);
        let t196 = -(t14 * t24);
        let t197 = -(t17 * t24);
        let t198 = -(t48 * t58);
        let t199 = -(t51 * t58);
        put(0, t73);
        put(1, t82);
        put(2, t74);
        put(3, t75);
        put(4, t78);
        put(5, t84);
        put(6, t86);
        put(7, t88);
        put(8, t89);
        put(9, t194);
        put(10, t195);
        put(11, t106);
        put(12, t94);
        put(13, t97);
        put(14, t100);
        put(15, t108);
        put(16, t110);
        put(17, t112);
        put(18, t113);
        put(19, t196);
        put(20, t197);
        put(21, t130);
        put(22, t118);
        put(23, t121);
        put(24, t124);
        put(25, t132);
        put(26, t134);
        put(27, t136);
        put(28, t137);
        put(29, t138);
        put(30, t139);
        put(31, t153);
        put(32, t142);
        put(33, t145);
        put(34, t148);
        put(35, t155);
        put(36, t157);
        put(37, t159);
        put(38, t160);
        put(39, t198);
        put(40, t199);
        put(41, t176);
        put(42, t165);
        put(43, t168);
        put(44, t171);
        put(45, t178);
        put(46, t180);
        put(47, t182);
        put(48, t183);
        put(49, t184);
        put(50, t185);
        put(51, t73);
        put(52, t88);
        put(53, t187);
        put(54, t189);
        put(55, t191);
        put(56, t193);
    }
}
