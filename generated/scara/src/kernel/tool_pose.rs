//! The tool frame in the world frame.
//!
//! Like `forward_kinematics`, followed by the tool's pose (the identity where the robot file has no
//! tool).
//!
//! 12 multiplications, 8 additions; 3 x 4, 8 of 12 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 8;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 3), (1, 0), (1, 1), (1, 3), (2, 2), (2, 3),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 4 + PATTERN[k].1
}

/// The tool frame in the world frame: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 4]; 3]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, |k, x| {
        flat[place(k)] = x;
        match k {
            1 => flat[2] = S::default(),
            4 => flat[6] = S::default(),
            5 => clear(&mut flat[8..10]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, out: &mut [[S; 4]; 3]) {
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
    let [s1, s2, _, s4] = trig.sin;
    let [c1, c2, _, c4] = trig.cos;
    let k3 = S::constant(-1.0);
    let k_H = S::constant(constants::H);
    let k_L1 = S::constant(constants::L1);
    let k_L2 = S::constant(constants::L2);
    // frame 2
    let [t0, t1, t4, t7] = {
        let t0 = c1 * k_L1;
        let t1 = s1 * k_L1;
        let t4 = c1 * c2 - s1 * s2;
        let t7 = s1 * c2 + c1 * s2;
        put(6, k3); // [2][2]
        [t0, t1, t4, t7]
    };
    // frame 3
    {
        let t10 = t0 + k_L2 * t4;
        let t11 = t1 + k_L2 * t7;
        let t12 = k_H - q3;
        put(2, t10); // [0][3]
        put(5, t11); // [1][3]
        put(7, t12); // [2][3]
    }
    // frame 4
    {
        let t15 = c4 * t4 + s4 * t7;
        let t18 = c4 * t7 - s4 * t4;
        let t19 = -t15;
        put(0, t15); // [0][0]
        put(1, t18); // [0][1]
        put(3, t18); // [1][0]
        put(4, t19); // [1][1]
    }
}
