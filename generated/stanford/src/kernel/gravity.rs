//! Gravity torques `g`.
//!
//! N m, from the base parameters: the torques that hold the arm at rest.
//!
//! 50 multiplications, 29 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{BASE, GRAVITY, Trig, constants};

/// Gravity torques `g`: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], out: &mut [S; 6]) {
    entries(trig, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let [
        _, MSX2, MSZ2, _, _, _, _, _, M3R, MSX3, MSY3, MSZ3R,
        MSX4, MSZ4R, _, _, _, _, _, MSX5, MSZ5R, _, _, _,
        _, _, MSX6, MSY6,
        ..] = *beta;
    let k0 = S::constant(-GRAVITY[2]);
    let k_D2 = S::constant(constants::D2);
    // link 2: motion
    let [t0, a3_z] = {
        let t0 = s2 * k0;
        let a3_z = c2 * k0;
        [t0, a3_z]
    };
    // link 4: motion
    let [t2, t3] = {
        let t2 = s4 * t0;
        let t3 = c4 * t0;
        [t2, t3]
    };
    // link 5: motion
    let [t6, a5_y] = {
        let t6 = c5 * t2 + s5 * a3_z;
        let a5_y = s5 * t2 - c5 * a3_z;
        [t6, a5_y]
    };
    // link 6: motion
    let [t12, a6_y] = {
        let t12 = c6 * t6 + s6 * t3;
        let a6_y = s6 * t6 - c6 * t3;
        [t12, a6_y]
    };
    // link 6: force and moment
    let [n6_z, t23, t26] = {
        let t16 = MSY6 * a5_y;
        let n6_y = MSX6 * a5_y;
        let n6_z = MSX6 * a6_y + MSY6 * t12;
        let t23 = c6 * t16 + s6 * n6_y;
        let t26 = s6 * t16 - c6 * n6_y;
        put(5, n6_z);
        [n6_z, t23, t26]
    };
    // link 5: force and moment
    let [n5_z, t37, t40] = {
        let n5_x = MSZ5R * t3 - t23;
        let n5_y = MSX5 * t3 - n6_z;
        let n5_z = MSX5 * a5_y - MSZ5R * t6 - t26;
        let t37 = s5 * n5_y - c5 * n5_x;
        let t40 = s5 * n5_x + c5 * n5_y;
        put(4, n5_z);
        [n5_z, t37, t40]
    };
    // link 4: force and moment
    let [n4_z, t51, t54] = {
        let t46 = t37 - MSZ4R * a3_z;
        let t47 = MSX4 * a3_z - n5_z;
        let n4_z = MSZ4R * t2 - MSX4 * t3 - t40;
        let t51 = c4 * t46 - s4 * t47;
        let t54 = s4 * t46 + c4 * t47;
        put(3, n4_z);
        [n4_z, t51, t54]
    };
    // link 3: force and moment
    let [t55, f3_z, t63, t64, t66] = {
        let t55 = M3R * t0;
        let f3_z = M3R * a3_z;
        let t63 = t54 + MSX3 * a3_z;
        let t64 = n4_z - MSX3 * t0;
        let t66 = t51 - (MSY3 * a3_z + MSZ3R * t0) - q3 * t55;
        put(2, f3_z);
        [t55, f3_z, t63, t64, t66]
    };
    // link 2: force and moment
    {
        let n2_z = t66 - (MSZ2 * t0 + MSX2 * a3_z);
        let n1_z = s2 * t63 + c2 * t64 + k_D2 * (c2 * t55 - s2 * f3_z);
        put(0, n1_z);
        put(1, n2_z);
    }
}
