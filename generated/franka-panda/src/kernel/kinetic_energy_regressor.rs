//! Kinetic energy, one entry per standard parameter.
//!
//! `T = h phi`, J per unit. Khalil and Dombre, 9.4.
//!
//! 154 multiplications, 59 additions; 91, 57 of 91 structurally nonzero.

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
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 91]) {
    let flat = &mut out[..];
    clear(&mut flat[0..6]);
    entries(trig, dq, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[7..14]),
            56 => clear(&mut flat[70..91]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], out: &mut [S; 91]) {
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
    let k3 = S::constant(0.088);
    let k4 = S::constant(0.5);
    let k_A = S::constant(constants::A);
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
        let t6 = s3 * dq2 - c3 * t0;
        let t9 = c3 * dq2 + s3 * t0;
        let t12 = c3 * t2 + s3 * t3;
        let t15 = c3 * t3 - s3 * t2;
        let t16 = t1 + dq3;
        [t6, t9, t12, t15, t16]
    };
    // link 4: velocity
    let [t19, t22, t25, t28, t31, t32] = {
        let t17 = k_A * t9;
        let t19 = t15 + k_A * t16;
        let t22 = c4 * t6 + s4 * t16;
        let t25 = c4 * t16 - s4 * t6;
        let t28 = s4 * t17 - c4 * t12;
        let t31 = c4 * t17 + s4 * t12;
        let t32 = dq4 - t9;
        [t19, t22, t25, t28, t31, t32]
    };
    // link 5: velocity
    let [t40, t43, t46, t49, t52, t53] = {
        let t38 = t28 + k_L3 * t32;
        let t39 = k_A * t25 + k_L3 * t22 - t19;
        let t40 = t31 + k_A * t32;
        let t43 = s5 * t32 - c5 * t22;
        let t46 = c5 * t32 + s5 * t22;
        let t49 = c5 * t38 + s5 * t39;
        let t52 = s5 * t38 - c5 * t39;
        let t53 = t25 + dq5;
        [t40, t43, t46, t49, t52, t53]
    };
    // link 6: velocity
    let [t56, t59, t62, t65, t66] = {
        let t56 = s6 * t53 - c6 * t43;
        let t59 = c6 * t53 + s6 * t43;
        let t62 = c6 * t49 + s6 * t40;
        let t65 = c6 * t40 - s6 * t49;
        let t66 = t46 + dq6;
        [t56, t59, t62, t65, t66]
    };
    // link 7: velocity
    let [t70, t73, t76, t79, t82, t83] = {
        let t69 = t52 + k3 * t59;
        let t70 = k3 * t66 - t65;
        let t73 = c7 * t56 + s7 * t66;
        let t76 = c7 * t66 - s7 * t56;
        let t79 = c7 * t62 + s7 * t69;
        let t82 = c7 * t69 - s7 * t62;
        let t83 = dq7 - t59;
        [t70, t73, t76, t79, t82, t83]
    };
    // kinetic energy
    {
        let t85 = k4 * (dq1 * dq1);
        let t87 = k4 * (t0 * t0);
        let t89 = k4 * (t1 * t1);
        let t91 = k4 * (dq2 * dq2);
        let t92 = t0 * t1;
        let t95 = t15 * t16;
        let t99 = t9 * t12 - t6 * t15;
        let t103 = k4 * (t12 * t12 + t15 * t15);
        let t105 = k4 * (t6 * t6);
        let t107 = k4 * (t9 * t9);
        let t109 = k4 * (t16 * t16);
        let t110 = t6 * t9;
        let t111 = t6 * t16;
        let t112 = t9 * t16;
        let t115 = t19 * t25 - t31 * t32;
        let t118 = t28 * t32 - t19 * t22;
        let t121 = t22 * t31 - t25 * t28;
        let t127 = k4 * (t19 * t19 + (t28 * t28 + t31 * t31));
        let t129 = k4 * (t22 * t22);
        let t131 = k4 * (t25 * t25);
        let t133 = k4 * (t32 * t32);
        let t134 = t22 * t25;
        let t135 = t22 * t32;
        let t136 = t25 * t32;
        let t139 = t52 * t53 - t40 * t46;
        let t142 = t40 * t43 + t49 * t53;
        let t145 = t46 * t49 + t43 * t52;
        let t147 = t52 * t52;
        let t151 = k4 * (t40 * t40 + (t49 * t49 + t147));
        let t153 = k4 * (t43 * t43);
        let t155 = k4 * (t46 * t46);
        let t157 = k4 * (t53 * t53);
        let t158 = t43 * t46;
        let t163 = t52 * t59 - t65 * t66;
        let t166 = t62 * t66 - t52 * t56;
        let t169 = t56 * t65 - t59 * t62;
        let t174 = k4 * (t147 + (t62 * t62 + t65 * t65));
        let t176 = k4 * (t56 * t56);
        let t178 = k4 * (t59 * t59);
        let t180 = k4 * (t66 * t66);
        let t181 = t56 * t59;
        let t182 = t56 * t66;
        let t183 = t59 * t66;
        let t186 = t70 * t76 - t82 * t83;
        let t189 = t79 * t83 - t70 * t73;
        let t192 = t73 * t82 - t76 * t79;
        let t198 = k4 * (t70 * t70 + (t79 * t79 + t82 * t82));
        let t200 = k4 * (t73 * t73);
        let t202 = k4 * (t76 * t76);
        let t204 = k4 * (t83 * t83);
        let t205 = t73 * t76;
        let t206 = t73 * t83;
        let t207 = t76 * t83;
        let t208 = -(dq2 * t0);
        let t209 = -(dq2 * t1);
        let t210 = -(t12 * t16);
        let t211 = -(t43 * t53);
        let t212 = -(t46 * t53);
        put(0, t85);
        put(1, t87);
        put(2, t89);
        put(3, t91);
        put(4, t92);
        put(5, t208);
        put(6, t209);
        put(7, t103);
        put(8, t95);
        put(9, t210);
        put(10, t99);
        put(11, t105);
        put(12, t107);
        put(13, t109);
        put(14, t110);
        put(15, t111);
        put(16, t112);
        put(17, t127);
        put(18, t115);
        put(19, t118);
        put(20, t121);
        put(21, t129);
        put(22, t131);
        put(23, t133);
        put(24, t134);
        put(25, t135);
        put(26, t136);
        put(27, t151);
        put(28, t139);
        put(29, t142);
        put(30, t145);
        put(31, t153);
        put(32, t155);
        put(33, t157);
        put(34, t158);
        put(35, t211);
        put(36, t212);
        put(37, t174);
        put(38, t163);
        put(39, t166);
        put(40, t169);
        put(41, t176);
        put(42, t178);
        put(43, t180);
        put(44, t181);
        put(45, t182);
        put(46, t183);
        put(47, t198);
        put(48, t186);
        put(49, t189);
        put(50, t192);
        put(51, t200);
        put(52, t202);
        put(53, t204);
        put(54, t205);
        put(55, t206);
        put(56, t207);
    }
}
