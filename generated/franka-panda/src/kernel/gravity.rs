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
        _, MSX2, MSY2R, _, _, _, _, _, MSX3R, MSY3R, _, _,
        _, _, _, MSX4R, MSY4R, _, _, _, _, _, MSX5, MSY5R,
        _, _, _, _, _, MSX6R, MSY6R, _, _, _, _, _,
        MSX7, MSY7,
        ..] = *beta;
    let k0 = S::constant(-GRAVITY[2]);
    // link 2: motion
    let [t0, a3_z] = {
        let t0 = s2 * k0;
        let a3_z = c2 * k0;
        [t0, a3_z]
    };
    // link 3: motion
    let [t2, a3_y] = {
        let t2 = c3 * t0;
        let a3_y = s3 * t0;
        [t2, a3_y]
    };
    // link 4: motion
    let [t6, a4_y] = {
        let t6 = c4 * t2 - s4 * a3_z;
        let a4_y = c4 * a3_z + s4 * t2;
        [t6, a4_y]
    };
    // link 5: motion
    let [t12, a5_y] = {
        let t12 = c5 * t6 - s5 * a3_y;
        let a5_y = c5 * a3_y + s5 * t6;
        [t12, a5_y]
    };
    // link 6: motion
    let [t18, a6_y] = {
        let t18 = c6 * t12 - s6 * a4_y;
        let a6_y = c6 * a4_y + s6 * t12;
        [t18, a6_y]
    };
    // link 7: motion
    let [t24, t27] = {
        let t24 = c7 * t18 + s7 * a5_y;
        let t27 = s7 * t18 - c7 * a5_y;
        [t24, t27]
    };
    // link 7: force and moment
    let [n7_z, t35, t38] = {
        let t28 = MSY7 * a6_y;
        let n7_y = MSX7 * a6_y;
        let n7_z = MSX7 * t27 + MSY7 * t24;
        let t35 = c7 * t28 + s7 * n7_y;
        let t38 = s7 * t28 - c7 * n7_y;
        put(6, n7_z);
        [n7_z, t35, t38]
    };
    // link 6: force and moment
    let [n6_z, t49, t52] = {
        let t44 = t35 + MSY6R * a5_y;
        let n6_y = MSX6R * a5_y - n7_z;
        let n6_z = MSX6R * a6_y + MSY6R * t18 - t38;
        let t49 = c6 * t44 + s6 * n6_y;
        let t52 = c6 * n6_y - s6 * t44;
        put(5, n6_z);
        [n6_z, t49, t52]
    };
    // link 5: force and moment
    let [n5_z, t63, t66] = {
        let n5_x = MSY5R * a4_y - t49;
        let t59 = n6_z + MSX5 * a4_y;
        let n5_z = t52 + (MSX5 * a5_y + MSY5R * t12);
        let t63 = c5 * n5_x + s5 * t59;
        let t66 = c5 * t59 - s5 * n5_x;
        put(4, n5_z);
        [n5_z, t63, t66]
    };
    // link 4: force and moment
    let [n4_z, t77, t80] = {
        let t72 = MSY4R * a3_y - t63;
        let n4_y = n5_z + MSX4R * a3_y;
        let n4_z = t66 + (MSX4R * a4_y + MSY4R * t6);
        let t77 = c4 * t72 + s4 * n4_y;
        let t80 = c4 * n4_y - s4 * t72;
        put(3, n4_z);
        [n4_z, t77, t80]
    };
    // link 3: force and moment
    let [n3_z, n2_x, t94] = {
        let n3_x = MSY3R * a3_z - t77;
        let t87 = n4_z + MSX3R * a3_z;
        let n3_z = t80 + (MSX3R * a3_y + MSY3R * t2);
        let n2_x = c3 * n3_x + s3 * t87;
        let t94 = s3 * n3_x - c3 * t87;
        put(2, n3_z);
        [n3_z, n2_x, t94]
    };
    // link 2: force and moment
    {
        let n2_z = t94 + (MSY2R * t0 - MSX2 * a3_z);
        let n1_z = c2 * n3_z - s2 * n2_x;
        put(0, n1_z);
        put(1, n2_z);
    }
}
