//! Kinetic energy, one entry per standard parameter.
//!
//! `T = h phi`, J per unit. Khalil and Dombre, 9.4.
//!
//! 163 multiplications, 68 additions; 91, 61 of 91 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, Trig};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 61;

/// First index, and the rest row-major, of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (6, 0), (10, 0), (11, 0), (12, 0), (13, 0), (14, 0), (15, 0), (16, 0), (17, 0), (18, 0),
    (19, 0), (20, 0), (21, 0), (22, 0), (23, 0), (24, 0), (25, 0), (26, 0), (27, 0), (28, 0),
    (29, 0), (30, 0), (31, 0), (32, 0), (33, 0), (34, 0), (35, 0), (36, 0), (37, 0), (38, 0),
    (39, 0), (40, 0), (41, 0), (42, 0), (43, 0), (44, 0), (45, 0), (46, 0), (47, 0), (48, 0),
    (49, 0), (50, 0), (51, 0), (52, 0), (53, 0), (54, 0), (55, 0), (56, 0), (57, 0), (58, 0),
    (59, 0), (60, 0), (61, 0), (62, 0), (63, 0), (64, 0), (65, 0), (66, 0), (67, 0), (68, 0),
    (69, 0),
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
            0 => clear(&mut flat[7..10]),
            60 => clear(&mut flat[70..91]),
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
    let k0 = S::constant(0.01175);
    let k1 = S::constant(0.42076);
    let k2 = S::constant(0.01275);
    let k3 = S::constant(0.31436);
    let k4 = S::constant(0.00035);
    let k5 = S::constant(0.167455);
    let k6 = S::constant(0.5);
    // link 2: velocity
    let [t1, t2, t3, t4] = {
        let t0 = dq1 * k0;
        let t1 = s2 * dq1;
        let t2 = c2 * dq1;
        let t3 = c2 * t0;
        let t4 = s2 * t0;
        [t1, t2, t3, t4]
    };
    // link 3: velocity
    let [t10, t13, t16, t19, t20] = {
        let t6 = t1 * k1;
        let t7 = dq2 * k1 - t3;
        let t10 = c3 * t1 - s3 * dq2;
        let t13 = c3 * dq2 + s3 * t1;
        let t16 = c3 * t7 + s3 * t6;
        let t19 = s3 * t7 - c3 * t6;
        let t20 = t2 + dq3;
        [t10, t13, t16, t19, t20]
    };
    // link 4: velocity
    let [t27, t30, t33, t36, t37] = {
        let t23 = t20 * k2 - t16;
        let t24 = t4 + t10 * k2;
        let t27 = c4 * t10 + s4 * t20;
        let t30 = c4 * t20 - s4 * t10;
        let t33 = s4 * t24 - c4 * t23;
        let t36 = c4 * t24 + s4 * t23;
        let t37 = t13 + dq4;
        [t27, t30, t33, t36, t37]
    };
    // link 5: velocity
    let [t44, t47, t50, t53, t54] = {
        let t40 = t33 + t37 * k3;
        let t41 = t19 - t27 * k3;
        let t44 = c5 * t27 - s5 * t37;
        let t47 = c5 * t37 + s5 * t27;
        let t50 = s5 * t41 - c5 * t40;
        let t53 = c5 * t41 + s5 * t40;
        let t54 = t30 + dq5;
        [t44, t47, t50, t53, t54]
    };
    // link 6: velocity
    let [t61, t64, t67, t70, t71] = {
        let t57 = t50 + t54 * k4;
        let t58 = t36 + t44 * k4;
        let t61 = c6 * t44 + s6 * t54;
        let t64 = c6 * t54 - s6 * t44;
        let t67 = s6 * t58 - c6 * t57;
        let t70 = c6 * t58 + s6 * t57;
        let t71 = t47 + dq6;
        [t61, t64, t67, t70, t71]
    };
    // link 7: velocity
    let [t78, t81, t84, t87, t88] = {
        let t74 = t67 + t71 * k5;
        let t75 = t61 * k5 - t53;
        let t78 = c7 * t61 - s7 * t71;
        let t81 = c7 * t71 + s7 * t61;
        let t84 = c7 * t74 + s7 * t75;
        let t87 = s7 * t74 - c7 * t75;
        let t88 = t64 + dq7;
        [t78, t81, t84, t87, t88]
    };
    // kinetic energy
    {
        let t90 = k6 * (dq1 * dq1);
        let t91 = dq2 * t4;
        let t92 = dq2 * t3;
        let t97 = t4 * t4;
        let t99 = k6 * (t3 * t3 + t97);
        let t101 = k6 * (t1 * t1);
        let t103 = k6 * (t2 * t2);
        let t105 = k6 * (dq2 * dq2);
        let t106 = t1 * t2;
        let t107 = dq2 * t1;
        let t108 = dq2 * t2;
        let t111 = t4 * t13 - t19 * t20;
        let t114 = t4 * t10 - t16 * t20;
        let t117 = t10 * t19 - t13 * t16;
        let t119 = t19 * t19;
        let t122 = k6 * (t97 + (t16 * t16 + t119));
        let t124 = k6 * (t10 * t10);
        let t126 = k6 * (t13 * t13);
        let t128 = k6 * (t20 * t20);
        let t130 = t10 * t20;
        let t134 = t36 * t37 - t19 * t30;
        let t137 = t19 * t27 - t33 * t37;
        let t140 = t30 * t33 - t27 * t36;
        let t142 = t36 * t36;
        let t145 = k6 * (t119 + (t33 * t33 + t142));
        let t147 = k6 * (t27 * t27);
        let t149 = k6 * (t30 * t30);
        let t151 = k6 * (t37 * t37);
        let t152 = t27 * t30;
        let t153 = t27 * t37;
        let t154 = t30 * t37;
        let t157 = t36 * t47 - t53 * t54;
        let t160 = t36 * t44 + t50 * t54;
        let t163 = t47 * t50 + t44 * t53;
        let t165 = t53 * t53;
        let t168 = k6 * (t142 + (t50 * t50 + t165));
        let t170 = k6 * (t44 * t44);
        let t172 = k6 * (t47 * t47);
        let t174 = k6 * (t54 * t54);
        let t176 = t44 * t54;
        let t180 = t70 * t71 - t53 * t64;
        let t183 = t53 * t61 - t67 * t71;
        let t186 = t64 * t67 - t61 * t70;
        let t188 = t70 * t70;
        let t191 = k6 * (t165 + (t67 * t67 + t188));
        let t193 = k6 * (t61 * t61);
        let t195 = k6 * (t64 * t64);
        let t197 = k6 * (t71 * t71);
        let t198 = t61 * t64;
        let t199 = t61 * t71;
        let t200 = t64 * t71;
        let t203 = t70 * t81 - t87 * t88;
        let t206 = t70 * t78 - t84 * t88;
        let t209 = t78 * t87 - t81 * t84;
        let t214 = k6 * (t188 + (t84 * t84 + t87 * t87));
        let t216 = k6 * (t78 * t78);
        let t218 = k6 * (t81 * t81);
        let t220 = k6 * (t88 * t88);
        let t222 = t78 * t88;
        let t224 = -(t2 * t3 + t1 * t4);
        let t225 = -(t10 * t13);
        let t226 = -(t13 * t20);
        let t227 = -(t44 * t47);
        let t228 = -(t47 * t54);
        let t229 = -(t78 * t81);
        let t230 = -(t81 * t88);
        put(0, t90);
        put(1, t99);
        put(2, t91);
        put(3, t92);
        put(4, t224);
        put(5, t101);
        put(6, t103);
        put(7, t105);
        put(8, t106);
        put(9, t107);
        put(10, t108);
        put(11, t122);
        put(12, t111);
        put(13, t114);
        put(14, t117);
        put(15, t124);
        put(16, t126);
        put(17, t128);
        put(18, t225);
        put(19, t130);
        put(20, t226);
        put(21, t145);
        put(22, t134);
        put(23, t137);
        put(24, t140);
        put(25, t147);
        put(26, t149);
        put(27, t151);
        put(28, t152);
        put(29, t153);
        put(30, t154);
        put(31, t168);
        put(32, t157);
        put(33, t160);
        put(34, t163);
        put(35, t170);
        put(36, t172);
        put(37, t174);
        put(38, t227);
        put(39, t176);
        put(40, t228);
        put(41, t191);
        put(42, t180);
        put(43, t183);
        put(44, t186);
        put(45, t193);
        put(46, t195);
        put(47, t197);
        put(48, t198);
        put(49, t199);
        put(50, t200);
        put(51, t214);
        put(52, t203);
        put(53, t206);
        put(54, t209);
        put(55, t216);
        put(56, t218);
        put(57, t220);
        put(58, t229);
        put(59, t222);
        put(60, t230);
    }
}
