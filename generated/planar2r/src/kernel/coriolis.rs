//! Coriolis and centrifugal torques `C dq`.
//!
//! N m, from the base parameters; no gravity, no friction.
//!
//! 12 multiplications, 4 additions; 2, 2 of 2 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{DOF, BASE, Trig, constants};

/// Coriolis and centrifugal torques `C dq`: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], out: &mut [S; 2]) {
    entries(trig, dq, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2] = trig.sin;
    let [_, c2] = trig.cos;
    let [dq1, dq2] = *dq;
    let [_, _, _, MSX2, MSY2, ..] = *beta;
    let k_L1 = S::constant(constants::L1);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        t0
    };
    // link 2: motion
    let [t3, a2_y, t5] = {
        let w2_z = dq1 + dq2;
        let t2 = k_L1 * t0;
        let t3 = c2 * t2;
        let a2_y = s2 * t2;
        let t5 = w2_z * w2_z;
        [t3, a2_y, t5]
    };
    // link 2: force and moment
    {
        let n2_z = MSX2 * a2_y + MSY2 * t3;
        let n1_z = n2_z - k_L1 * (s2 * (MSX2 * t5) + c2 * (MSY2 * t5));
        put(0, n1_z);
        put(1, n2_z);
    }
}
