//! Gravity torques `g`.
//!
//! N m, from the base parameters: the torques that hold the arm at rest.
//!
//! 50 multiplications, 28 additions; 6, 6 of 6 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{BASE, GRAVITY, Trig};

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
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [
        _, MSX2R, MSY2, _, _, _, _, _, MSX3R, MSY3R, _, _,
        _, _, _, MSX4, MSY4R, _, _, _, _, _, MSX5, MSY5R,
        _, _, _, _, _, MSX6, MSY6,
        ..] = *beta;
    let k0 = S::constant(-GRAVITY[2]);
    // link 2: motion
    let [t0, t1] = {
        let t0 = s2 * k0;
        let t1 = c2 * k0;
        [t0, t1]
    };
    // link 3: motion
    let [t4, t7] = {
        let t4 = c3 * t0 + s3 * t1;
        let t7 = c3 * t1 - s3 * t0;
        [t4, t7]
    };
    // link 4: motion
    let [t8, a4_y] = {
        let t8 = c4 * t4;
        let a4_y = s4 * t4;
        [t8, a4_y]
    };
    // link 5: motion
    let [t12, t15] = {
        let t12 = c5 * t8 + s5 * t7;
        let t15 = c5 * t7 - s5 * t8;
        [t12, t15]
    };
    // link 6: motion
    let [a6_x, a6_y] = {
        let a6_x = s6 * a4_y - c6 * t12;
        let a6_y = c6 * a4_y + s6 * t12;
        [a6_x, a6_y]
    };
    // link 6: force and moment
    let [n6_z, t29, t32] = {
        let t22 = MSY6 * t15;
        let t23 = MSX6 * t15;
        let n6_z = MSX6 * a6_y - MSY6 * a6_x;
        let t29 = c6 * t22 + s6 * t23;
        let t32 = s6 * t22 - c6 * t23;
        put(5, n6_z);
        [n6_z, t29, t32]
    };
    // link 5: force and moment
    let [n5_z, t43, t46] = {
        let n5_x = t29 + MSY5R * a4_y;
        let t39 = n6_z + MSX5 * a4_y;
        let n5_z = t32 - (MSX5 * t15 - MSY5R * t12);
        let t43 = c5 * n5_x + s5 * t39;
        let t46 = s5 * n5_x - c5 * t39;
        put(4, n5_z);
        [n5_z, t43, t46]
    };
    // link 4: force and moment
    let [n4_z, n3_x, t60] = {
        let n4_x = t43 + MSY4R * t7;
        let n4_y = n5_z - MSX4 * t7;
        let n4_z = MSX4 * a4_y + MSY4R * t8 - t46;
        let n3_x = c4 * n4_x - s4 * n4_y;
        let t60 = s4 * n4_x + c4 * n4_y;
        put(3, n4_z);
        [n4_z, n3_x, t60]
    };
    // link 3: force and moment
    let [n3_z, n2_x, t70] = {
        let n3_z = t60 + (MSY3R * t4 - MSX3R * t7);
        let n2_x = c3 * n3_x + s3 * n4_z;
        let t70 = c3 * n4_z - s3 * n3_x;
        put(2, n3_z);
        [n3_z, n2_x, t70]
    };
    // link 2: force and moment
    {
        let n2_z = n3_z + (MSY2 * t0 - MSX2R * t1);
        let n1_z = c2 * t70 - s2 * n2_x;
        put(0, n1_z);
        put(1, n2_z);
    }
}
