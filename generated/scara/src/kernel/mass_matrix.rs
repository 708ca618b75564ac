//! Mass matrix `M`, symmetric, kg m^2.
//!
//! From the base parameters, rotors on the diagonal, by composite bodies. Featherstone, 6.2.
//!
//! 17 multiplications, 19 additions; 4 x 4, 10 of 16 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{BASE, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 10;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 3), (1, 0), (1, 1), (1, 3), (2, 2), (3, 0), (3, 1), (3, 3),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 4 + PATTERN[k].1
}

/// Mass matrix `M`, symmetric, kg m^2: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], out: &mut [[S; 4]; 4]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, beta, |k, x| {
        flat[place(k)] = x;
        match k {
            1 => flat[2] = S::default(),
            4 => flat[6] = S::default(),
            5 => clear(&mut flat[8..10]),
            6 => flat[11] = S::default(),
            8 => flat[14] = S::default(),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], out: &mut [[S; 4]; 4]) {
    entries(trig, beta, |k, x| {
        out[PATTERN[k].0][PATTERN[k].1] = x;
    });
}

/// The same, only the entries of [`PATTERN`].
#[inline]
pub fn packed<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], out: &mut [S; NONZEROS]) {
    entries(trig, beta, |k, x| out[k] = x);
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4] = trig.sin;
    let [_, c2, _, c4] = trig.cos;
    let [ZZ1R, MSX2R, MSY2R, ZZ2R, M3R, MSX4, MSY4, ZZ4, ..] = *beta;
    let k_L1 = S::constant(constants::L1);
    let k_L2 = S::constant(constants::L2);
    // composite body 4
    let [t2, t5] = {
        let t2 = c4 * MSY4 + s4 * MSX4;
        let t5 = s4 * MSY4 - c4 * MSX4;
        let t7 = k_L2 * t5 - ZZ4;
        let t12 = t7 + k_L1 * (c2 * t5 - s2 * t2);
        put(2, t12); // [0][3]
        put(5, t7); // [1][3]
        put(6, M3R); // [2][2]
        put(7, t12); // [3][0]
        put(8, t7); // [3][1]
        put(9, ZZ4); // [3][3]
        [t2, t5]
    };
    // composite body 3
    let [t14, t15, t22] = {
        let t14 = k_L2 * M3R - t5;
        let t15 = k_L1 * M3R;
        let t19 = q3 * (q3 * M3R);
        let t22 = t19 - (ZZ4 + (k_L2 * (t14 - t5) + t19));
        [t14, t15, t22]
    };
    // composite body 2
    let t34 = {
        let t25 = ZZ2R - t22;
        let t28 = c2 * (MSX2R + t14) - s2 * (MSY2R - t2);
        let t30 = t25 + k_L1 * t28;
        let t34 = t25 + k_L1 * (t28 + (t15 + t28));
        put(1, t30); // [0][1]
        put(3, t30); // [1][0]
        put(4, t25); // [1][1]
        t34
    };
    // composite body 1
    {
        let t35 = ZZ1R + t34;
        put(0, t35); // [0][0]
    }
}
