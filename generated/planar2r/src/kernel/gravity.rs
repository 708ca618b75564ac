//! Gravity torques `g`.
//!
//! N m, from the base parameters: the torques that hold the arm at rest.
//!
//! 10 multiplications, 5 additions; 2, 2 of 2 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{BASE, GRAVITY, Trig};

/// Gravity torques `g`: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], out: &mut [S; 2]) {
    entries(trig, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [s1, s2] = trig.sin;
    let [c1, c2] = trig.cos;
    let [MSX1R, MSY1, _, MSX2, MSY2, ..] = *beta;
    let k0 = S::constant(-GRAVITY[1]);
    // link 1: motion
    let [a1_x, a1_y] = {
        let a1_x = s1 * k0;
        let a1_y = c1 * k0;
        [a1_x, a1_y]
    };
    // link 2: motion
    let [a2_x, a2_y] = {
        let a2_x = c2 * a1_x + s2 * a1_y;
        let a2_y = c2 * a1_y - s2 * a1_x;
        [a2_x, a2_y]
    };
    // link 2: force and moment
    let n2_z = {
        let n2_z = MSX2 * a2_y - MSY2 * a2_x;
        put(1, n2_z);
        n2_z
    };
    // link 1: force and moment
    {
        let n1_z = n2_z + (MSX1R * a1_y - MSY1 * a1_x);
        put(0, n1_z);
    }
}
