//! Kinetic energy, one entry per standard parameter.
//!
//! `T = h phi`, J per unit. Khalil and Dombre, 9.4.
//!
//! 123 multiplications, 45 additions; 66, 57 of 66 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 57;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (5, 0), (10, 0), (11, 0), (12, 0), (13, 0), (14, 0), (15, 0), (16, 0), (17, 0), (18, 0),
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
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 66]) {
    let flat = &mut out[..];
    clear(&mut flat[0..5]);
    entries(trig, dq, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[6..10]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 66]) {
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
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let k2 = S::constant(0.5);
    let k_D2 = S::constant(constants::D2);
    let k_D6 = S::constant(constants::D6);
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
    let [t6, t7, t8] = {
        let t6 = q3 * t1;
        let t7 = q3 * dq2 - t3;
        let t8 = t4 - dq3;
        [t6, t7, t8]
    };
    // link 4: velocity
    let [t11, t14, t17, t20, t21] = {
        let t11 = c4 * dq2 + s4 * t1;
        let t14 = c4 * t1 - s4 * dq2;
        let t17 = s4 * t7 - c4 * t6;
        let t20 = c4 * t7 + s4 * t6;
        let t21 = t2 + dq4;
        [t11, t14, t17, t20, t21]
    };
    // link 5: velocity
    let [t24, t27, t30, t33, t34] = {
        let t24 = c5 * t11 + s5 * t21;
        let t27 = s5 * t11 - c5 * t21;
        let t30 = c5 * t17 + s5 * t8;
        let t33 = s5 * t17 - c5 * t8;
        let t34 = t14 - dq5;
        [t24, t27, t30, t33, t34]
    };
    // link 6: velocity
    let [t41, t44, t47, t50, t51] = {
        let t37 = k_D6 * t34 - t30;
        let t38 = t20 + k_D6 * t24;
        let t41 = c6 * t24 + s6 * t34;
        let t44 = c6 * t34 - s6 * t24;
        let t47 = s6 * t38 - c6 * t37;
        let t50 = c6 * t38 + s6 * t37;
        let t51 = t27 - dq6;
        [t41, t44, t47, t50, t51]
    };
    // kinetic energy
    {
        let t53 = k2 * (dq1 * dq1);
        let t54 = dq2 * t4;
        let t57 = t1 * t4 + t2 * t3;
        let t62 = k2 * (t3 * t3 + t4 * t4);
        let t64 = k2 * (t1 * t1);
        let t66 = k2 * (dq2 * dq2);
        let t68 = k2 * (t2 * t2);
        let t69 = dq2 * t1;
        let t71 = dq2 * t2;
        let t74 = t2 * t7 - t1 * t8;
        let t77 = dq2 * t8 + t2 * t6;
        let t80 = t1 * t6 + dq2 * t7;
        let t83 = t8 * t8;
        let t86 = k2 * (t83 + (t6 * t6 + t7 * t7));
        let t89 = t20 * t21 - t8 * t14;
        let t92 = t14 * t17 - t11 * t20;
        let t95 = t8 * t11 - t17 * t21;
        let t97 = t20 * t20;
        let t100 = k2 * (t97 + (t83 + t17 * t17));
        let t102 = k2 * (t11 * t11);
        let t104 = k2 * (t21 * t21);
        let t106 = k2 * (t14 * t14);
        let t107 = t11 * t21;
        let t108 = t11 * t14;
        let t109 = t14 * t21;
        let t112 = t33 * t34 - t20 * t27;
        let t115 = t27 * t30 - t24 * t33;
        let t118 = t20 * t24 - t30 * t34;
        let t120 = t33 * t33;
        let t123 = k2 * (t120 + (t97 + t30 * t30));
        let t125 = k2 * (t24 * t24);
        let t127 = k2 * (t34 * t34);
        let t129 = k2 * (t27 * t27);
        let t130 = t24 * t34;
        let t131 = t24 * t27;
        let t132 = t27 * t34;
        let t135 = t33 * t44 - t50 * t51;
        let t138 = t47 * t51 - t33 * t41;
        let t141 = t41 * t50 - t44 * t47;
        let t146 = k2 * (t120 + (t47 * t47 + t50 * t50));
        let t148 = k2 * (t41 * t41);
        let t150 = k2 * (t44 * t44);
        let t152 = k2 * (t51 * t51);
        let t153 = t41 * t44;
        let t154 = t41 * t51;
        let t155 = t44 * t51;
        let t157 = k2 * (dq3 * dq3);
        let t159 = k2 * (dq4 * dq4);
        let t161 = k2 * (dq5 * dq5);
        let t163 = k2 * (dq6 * dq6);
        let t164 = -(dq2 * t3);
        let t165 = -t69;
        let t166 = -(t1 * t2);
        let t167 = -t71;
        put(0, t53);
        put(1, t62);
        put(2, t54);
        put(3, t57);
        put(4, t164);
        put(5, t64);
        put(6, t66);
        put(7, t68);
        put(8, t165);
        put(9, t166);
        put(10, t71);
        put(11, t86);
        put(12, t74);
        put(13, t77);
        put(14, t80);
        put(15, t66);
        put(16, t64);
        put(17, t68);
        put(18, t69);
        put(19, t167);
        put(20, t166);
        put(21, t100);
        put(22, t89);
        put(23, t92);
        put(24, t95);
        put(25, t102);
        put(26, t104);
        put(27, t106);
        put(28, t107);
        put(29, t108);
        put(30, t109);
        put(31, t123);
        put(32, t112);
        put(33, t115);
        put(34, t118);
        put(35, t125);
        put(36, t127);
        put(37, t129);
        put(38, t130);
        put(39, t131);
        put(40, t132);
        put(41, t146);
        put(42, t135);
        put(43, t138);
        put(44, t141);
        put(45, t148);
        put(46, t150);
        put(47, t152);
        put(48, t153);
        put(49, t154);
        put(50, t155);
        put(51, t53);
        put(52, t66);
        put(53, t157);
        put(54, t159);
        put(55, t161);
        put(56, t163);
    }
}
