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
    let [a2_x, a2_y] = {
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        [a2_x, a2_y]
    };
    // link 3: motion
    let [a3_x, t3] = {
        let a3_x = c3 * a2_x;
        let t3 = s3 * a2_x;
        [a3_x, t3]
    };
    // link 4: motion
    let [a4_x, a5_z] = {
        let a4_x = c4 * a3_x - s4 * a2_y;
        let a5_z = c4 * a2_y + s4 * a3_x;
        [a4_x, a5_z]
    };
    // link 5: motion
    let [t12, a6_z] = {
        let t12 = s5 * t3 - c5 * a4_x;
        let a6_z = c5 * t3 + s5 * a4_x;
        [t12, a6_z]
    };
    // link 6: motion
    let [t18, a6_y] = {
        let t18 = c6 * t12 - s6 * a5_z;
        let a6_y = c6 * a5_z + s6 * t12;
        [t18, a6_y]
    };
    // link 7: motion
    let [t24, t27] = {
        let t24 = c7 * t18 + s7 * a6_z;
        let t27 = s7 * t18 - c7 * a6_z;
        [t24, t27]
    };
    // link 7: force and moment
    let [n7_z, t35, t38] = {
        let n7_x = MSY7 * a6_y;
        let t29 = MSX7 * a6_y;
        let n7_z = MSX7 * t27 + MSY7 * t24;
        let t35 = c7 * n7_x + s7 * t29;
        let t38 = c7 * t29 - s7 * n7_x;
        put(6, n7_z);
        [n7_z, t35, t38]
    };
    // link 6: force and moment
    let [n6_z, t49, t52] = {
        let n6_x = t35 + MSY6R * a6_z;
        let t45 = n7_z - MSX6 * a6_z;
        let n6_z = t38 + (MSX6 * a6_y + MSY6R * t18);
        let t49 = c6 * n6_x - s6 * t45;
        let t52 = s6 * n6_x + c6 * t45;
        put(5, n6_z);
        [n6_z, t49, t52]
    };
    // link 5: force and moment
    let [n5_z, t63, t66] = {
        let n5_x = t49 + MSY5R * a5_z;
        let t59 = n6_z + MSX5 * a5_z;
        let n5_z = t52 - (MSX5 * a6_z - MSY5R * t12);
        let t63 = c5 * n5_x + s5 * t59;
        let t66 = s5 * n5_x - c5 * t59;
        put(4, n5_z);
        [n5_z, t63, t66]
    };
    // link 4: force and moment
    let [n4_z, t77, t80] = {
        let t72 = MSY4R * t3 - t63;
        let t73 = n5_z - MSX4 * t3;
        let n4_z = t66 - (MSX4 * a5_z + MSY4R * a4_x);
        let t77 = s4 * t73 - c4 * t72;
        let t80 = s4 * t72 + c4 * t73;
        put(3, n4_z);
        [n4_z, t77, t80]
    };
    // link 3: force and moment
    let [n3_z, n2_x, t94] = {
        let n3_x = t77 + MSY3R * a2_y;
        let t87 = MSX3 * a2_y - n4_z;
        let n3_z = t80 - (MSX3 * t3 + MSY3R * a3_x);
        let n2_x = c3 * n3_x + s3 * t87;
        let t94 = c3 * t87 - s3 * n3_x;
        put(2, n3_z);
        [n3_z, n2_x, t94]
    };
    // link 2: force and moment
    {
        let n2_z = t94 + (MSX2 * a2_y - MSY2R * a2_x);
        let n1_z = s2 * n2_x + c2 * n3_z;
        put(0, n1_z);
        put(1, n2_z);
    }
}
