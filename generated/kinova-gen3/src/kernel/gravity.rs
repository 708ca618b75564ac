//! Gravity torques `g`.
//!
//! N m, from the base parameters: the torques that hold the arm at rest.
//!
//! 64 multiplications, 38 additions; 7, 7 of 7 structurally nonzero.

use super::super::runtime::Scalar;
use super::super::{BASE, GRAVITY, Trig};

/// Gravity torques `g`: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], out: &mut [S; 7]) {
    entries(trig, beta, |k, x| {
        out[k] = x;
    });
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, beta: &[S; BASE], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6, s7] = trig.sin;
    let [_, c2, c3, c4, c5, c6, c7] = trig.cos;
    let [
        _, MSX2, MSY2R, _, _, _, _, _, MSX3, MSY3R, _, _,
        _, _, _, MSX4, MSY4R, _, _, _, _, _, MSX5, MSY5R,
        _, _, _, _, _, MSX6, MSY6R, _, _, _, _, _,
        MSX7, MSY7,
        ..] = *beta;
    let k0 = S::constant(-GRAVITY[2]);
    // link 2: motion
    let [t0, t1] = {
        let t0 = s2 * k0;
        let t1 = c2 * k0;
        [t0, t1]
    };
    // link 3: motion
    let [t2, a3_y] = {
        let t2 = c3 * t0;
        let a3_y = s3 * t0;
        [t2, a3_y]
    };
    // link 4: motion
    let [t6, a4_y] = {
        let t6 = c4 * t2 + s4 * t1;
        let a4_y = s4 * t2 - c4 * t1;
        [t6, a4_y]
    };
    // link 5: motion
    let [a5_x, a5_y] = {
        let a5_x = s5 * a3_y - c5 * t6;
        let a5_y = c5 * a3_y + s5 * t6;
        [a5_x, a5_y]
    };
    // link 6: motion
    let [a6_x, a6_y] = {
        let a6_x = c6 * a5_x + s6 * a4_y;
        let a6_y = c6 * a4_y - s6 * a5_x;
        [a6_x, a6_y]
    };
    // link 7: motion
    let [a7_x, a7_y] = {
        let a7_x = c7 * a6_x + s7 * a5_y;
        let a7_y = c7 * a5_y - s7 * a6_x;
        [a7_x, a7_y]
    };
    // link 7: force and moment
    let [n7_z, t35, t38] = {
        let n7_x = MSY7 * a6_y;
        let t29 = MSX7 * a6_y;
        let n7_z = MSX7 * a7_y - MSY7 * a7_x;
        let t35 = c7 * n7_x + s7 * t29;
        let t38 = s7 * n7_x - c7 * t29;
        put(6, n7_z);
        [n7_z, t35, t38]
    };
    // link 6: force and moment
    let [n6_z, t49, t52] = {
        let n6_x = t35 - MSY6R * a5_y;
        let n6_y = n7_z + MSX6 * a5_y;
        let n6_z = MSX6 * a6_y - MSY6R * a6_x - t38;
        let t49 = c6 * n6_x - s6 * n6_y;
        let t52 = s6 * n6_x + c6 * n6_y;
        put(5, n6_z);
        [n6_z, t49, t52]
    };
    // link 5: force and moment
    let [n5_z, t63, t66] = {
        let n5_x = t49 + MSY5R * a4_y;
        let t59 = n6_z + MSX5 * a4_y;
        let n5_z = t52 + (MSX5 * a5_y - MSY5R * a5_x);
        let t63 = c5 * n5_x + s5 * t59;
        let t66 = s5 * n5_x - c5 * t59;
        put(4, n5_z);
        [n5_z, t63, t66]
    };
    // link 4: force and moment
    let [n4_z, t77, t80] = {
        let n4_x = t63 - MSY4R * a3_y;
        let n4_y = n5_z + MSX4 * a3_y;
        let n4_z = MSX4 * a4_y + MSY4R * t6 - t66;
        let t77 = c4 * n4_x - s4 * n4_y;
        let t80 = s4 * n4_x + c4 * n4_y;
        put(3, n4_z);
        [n4_z, t77, t80]
    };
    // link 3: force and moment
    let [n3_z, n2_x, t94] = {
        let n3_x = t77 - MSY3R * t1;
        let n3_y = MSX3 * t1 - n4_z;
        let n3_z = t80 + (MSX3 * a3_y + MSY3R * t2);
        let n2_x = c3 * n3_x - s3 * n3_y;
        let t94 = s3 * n3_x + c3 * n3_y;
        put(2, n3_z);
        [n3_z, n2_x, t94]
    };
    // link 2: force and moment
    {
        let n2_z = MSY2R * t0 - MSX2 * t1 - t94;
        let n1_z = s2 * n2_x + c2 * n3_z;
        put(0, n1_z);
        put(1, n2_z);
    }
}
