//! Kinetic energy, one entry per standard parameter.
//!
//! `T = h phi`, J per unit. Khalil and Dombre, 9.4.
//!
//! 135 multiplications, 50 additions; 84, 53 of 84 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 53;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (6, 0), (14, 0), (15, 0), (16, 0), (17, 0), (18, 0), (19, 0), (20, 0), (21, 0), (22, 0),
    (23, 0), (24, 0), (25, 0), (26, 0), (27, 0), (28, 0), (29, 0), (30, 0), (31, 0), (32, 0),
    (33, 0), (34, 0), (35, 0), (36, 0), (37, 0), (38, 0), (39, 0), (40, 0), (41, 0), (42, 0),
    (43, 0), (44, 0), (45, 0), (46, 0), (47, 0), (48, 0), (49, 0), (50, 0), (51, 0), (52, 0),
    (53, 0), (54, 0), (55, 0), (56, 0), (57, 0), (58, 0), (59, 0), (60, 0), (61, 0), (62, 0),
    (63, 0), (64, 0), (65, 0),
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
            52 => clear(&mut flat[66..84]),
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
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let k0 = S::constant(-constants::A2);
    let k2 = S::constant(-constants::A3);
    let k5 = S::constant(0.5);
    let k_D4 = S::constant(constants::D4);
    let k_D5 = S::constant(constants::D5);
    let k_D6 = S::constant(constants::D6);
    // link 2: velocity
    let [t0, t1] = {
        let t0 = s2 * dq1;
        let t1 = c2 * dq1;
        [t0, t1]
    };
    // link 3: velocity
    let [t3, t6, t9, t10, t11, t12] = {
        let t2 = dq2 * k0;
        let t3 = t1 * k0;
        let t6 = c3 * t0 + s3 * t1;
        let t9 = c3 * t1 - s3 * t0;
        let t10 = s3 * t2;
        let t11 = c3 * t2;
        let t12 = dq2 + dq3;
        [t3, t6, t9, t10, t11, t12]
    };
    // link 4: velocity
    let [t20, t23, t26, t29, t32, t33] = {
        let t18 = k_D4 * t9 - t10;
        let t19 = t11 + (t12 * k2 + k_D4 * t6);
        let t20 = t3 + t9 * k2;
        let t23 = c4 * t6 + s4 * t9;
        let t26 = c4 * t9 - s4 * t6;
        let t29 = c4 * t18 - s4 * t19;
        let t32 = c4 * t19 + s4 * t18;
        let t33 = t12 + dq4;
        [t20, t23, t26, t29, t32, t33]
    };
    // link 5: velocity
    let [t40, t43, t46, t49, t50] = {
        let t36 = t29 + k_D5 * t33;
        let t37 = t20 - k_D5 * t23;
        let t40 = c5 * t23 + s5 * t33;
        let t43 = c5 * t33 - s5 * t23;
        let t46 = c5 * t36 + s5 * t37;
        let t49 = c5 * t37 - s5 * t36;
        let t50 = dq5 - t26;
        [t40, t43, t46, t49, t50]
    };
    // link 6: velocity
    let [t57, t60, t63, t66, t67] = {
        let t53 = t46 - k_D6 * t50;
        let t54 = t32 + k_D6 * t40;
        let t57 = c6 * t40 - s6 * t50;
        let t60 = c6 * t50 + s6 * t40;
        let t63 = c6 * t53 - s6 * t54;
        let t66 = c6 * t54 + s6 * t53;
        let t67 = t43 + dq6;
        [t57, t60, t63, t66, t67]
    };
    // kinetic energy
    {
        let t69 = k5 * (dq1 * dq1);
        let t71 = k5 * (t0 * t0);
        let t73 = k5 * (t1 * t1);
        let t75 = k5 * (dq2 * dq2);
        let t76 = t0 * t1;
        let t77 = dq2 * t0;
        let t78 = dq2 * t1;
        let t84 = t3 * t6 + t10 * t12;
        let t87 = t6 * t11 - t9 * t10;
        let t93 = k5 * (t3 * t3 + (t10 * t10 + t11 * t11));
        let t95 = k5 * (t6 * t6);
        let t97 = k5 * (t9 * t9);
        let t99 = k5 * (t12 * t12);
        let t100 = t6 * t9;
        let t101 = t6 * t12;
        let t102 = t9 * t12;
        let t108 = t20 * t23 - t29 * t33;
        let t111 = t26 * t29 + t23 * t32;
        let t113 = t32 * t32;
        let t117 = k5 * (t20 * t20 + (t29 * t29 + t113));
        let t119 = k5 * (t23 * t23);
        let t121 = k5 * (t26 * t26);
        let t123 = k5 * (t33 * t33);
        let t124 = t23 * t26;
        let t125 = t23 * t33;
        let t126 = t26 * t33;
        let t129 = t49 * t50 - t32 * t43;
        let t132 = t32 * t40 - t46 * t50;
        let t135 = t43 * t46 - t40 * t49;
        let t137 = t49 * t49;
        let t140 = k5 * (t113 + (t46 * t46 + t137));
        let t142 = k5 * (t40 * t40);
        let t144 = k5 * (t43 * t43);
        let t146 = k5 * (t50 * t50);
        let t147 = t40 * t43;
        let t148 = t40 * t50;
        let t149 = t43 * t50;
        let t152 = t49 * t60 - t66 * t67;
        let t155 = t49 * t57 - t63 * t67;
        let t158 = t57 * t66 - t60 * t63;
        let t163 = k5 * (t137 + (t63 * t63 + t66 * t66));
        let t165 = k5 * (t57 * t57);
        let t167 = k5 * (t60 * t60);
        let t169 = k5 * (t67 * t67);
        let t171 = t57 * t67;
        let t174 = k5 * (dq3 * dq3);
        let t176 = k5 * (dq4 * dq4);
        let t178 = k5 * (dq5 * dq5);
        let t180 = k5 * (dq6 * dq6);
        let t181 = -(t11 * t12 + t3 * t9);
        let t182 = -(t32 * t33 + t20 * t26);
        let t183 = -(t57 * t60);
        let t184 = -(t60 * t67);
        put(0, t69);
        put(1, t71);
        put(2, t73);
        put(3, t75);
        put(4, t76);
        put(5, t77);
        put(6, t78);
        put(7, t93);
        put(8, t181);
        put(9, t84);
        put(10, t87);
        put(11, t95);
        put(12, t97);
        put(13, t99);
        put(14, t100);
        put(15, t101);
        put(16, t102);
        put(17, t117);
        put(18, t182);
        put(19, t108);
        put(20, t111);
        put(21, t119);
        put(22, t121);
        put(23, t123);
        put(24, t124);
        put(25, t125);
        put(26, t126);
        put(27, t140);
        put(28, t129);
        put(29, t132);
        put(30, t135);
        put(31, t142);
        put(32, t144);
        put(33, t146);
        put(34, t147);
        put(35, t148);
        put(36, t149);
        put(37, t163);
        put(38, t152);
        put(39, t155);
        put(40, t158);
        put(41, t165);
        put(42, t167);
        put(43, t169);
        put(44, t183);
        put(45, t171);
        put(46, t184);
        put(47, t69);
        put(48, t75);
        put(49, t174);
        put(50, t176);
        put(51, t178);
        put(52, t180);
    }
}
