//! Mass matrix `M`, symmetric, kg m^2.
//!
//! From the base parameters, rotors on the diagonal, by composite bodies. Featherstone, 6.2.
//!
//! 4 multiplications, 5 additions; 2 x 2, 4 of 4 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{BASE, Trig, constants};

/// Mass matrix `M`, symmetric, kg m^2: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], out: &mut [[S; 2]; 2]) {
    entries(trig, beta, |k, x| {
        out[k / 2][k % 2] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2] = trig.sin;
    let [_, c2] = trig.cos;
    let [_, _, ZZ1R, MSX2, MSY2, ZZ2, ..] = *beta;
    let k_L1 = S::constant(constants::L1);
    // composite body 2
    let t7 = {
        let t2 = c2 * MSX2 - s2 * MSY2;
        let t4 = ZZ2 + k_L1 * t2;
        let t7 = ZZ2 + k_L1 * (t2 + t2);
        put(1, t4); // [0][1]
        put(2, t4); // [1][0]
        put(3, ZZ2); // [1][1]
        t7
    };
    // composite body 1
    {
        let t8 = ZZ1R + t7;
        put(0, t8); // [0][0]
    }
}
