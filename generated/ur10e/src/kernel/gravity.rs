//! Gravity torques `g`.
//!
//! N m, from the base parameters: the torques that hold the arm at rest.
//!
//! 48 multiplications, 26 additions; 6, 6 of 6 structurally nonzero.

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
        _, MSX2R, MSY2, _, _, _, _, _, MSX3R, MSY3, _, _,
        _, _, _, MSX4, MSY4R, _, _, _, _, _, MSX5, MSY5R,
        _, _, _, _, _, MSX6, MSY6,
        ..] = *beta;
    let k0 = S::constant(-GRAVITY[2]);
    // link 2: motion
    let [a2_x, a2_y] = {
        let a2_x = s2 * k0;
        let a2_y = c2 * k0;
        [a2_x, a2_y]
    };
    // link 3: motion
    let [a3_x, t7] = {
        let a3_x = c3 * a2_x + s3 * a2_y;
        let t7 = s3 * a2_x - c3 * a2_y;
        [a3_x, t7]
    };
    // link 4: motion
    let [t10, t13] = {
        let t10 = s4 * t7 - c4 * a3_x;
        let t13 = c4 * t7 + s4 * a3_x;
        [t10, t13]
    };
    // link 5: motion
    let [t14, t15] = {
        let t14 = c5 * t10;
        let t15 = s5 * t10;
        [t14, t15]
    };
    // link 6: motion
    let [t18, a6_y] = {
        let t18 = c6 * t14 + s6 * t13;
        let a6_y = s6 * t14 - c6 * t13;
        [t18, a6_y]
    };
    // link 6: force and moment
    let [n6_z, t29, t32] = {
        let t22 = MSY6 * t15;
        let t23 = MSX6 * t15;
        let n6_z = MSX6 * a6_y + MSY6 * t18;
        let t29 = c6 * t22 + s6 * t23;
        let t32 = c6 * t23 - s6 * t22;
        put(5, n6_z);
        [n6_z, t29, t32]
    };
    // link 5: force and moment
    let [n5_z, t43, t46] = {
        let t38 = t29 + MSY5R * t13;
        let t39 = MSX5 * t13 - n6_z;
        let n5_z = t32 + (MSX5 * t15 + MSY5R * t14);
        let t43 = c5 * t38 + s5 * t39;
        let t46 = s5 * t38 - c5 * t39;
        put(4, n5_z);
        [n5_z, t43, t46]
    };
    // link 4: force and moment
    let [n4_z, t53, t56] = {
        let n4_z = t46 - (MSX4 * t13 - MSY4R * t10);
        let t53 = c4 * t43 + s4 * n5_z;
        let t56 = c4 * n5_z - s4 * t43;
        put(3, n4_z);
        [n4_z, t53, t56]
    };
    // link 3: force and moment
    let [n3_z, t63, n2_y] = {
        let n3_z = n4_z - (MSX3R * t7 + MSY3 * a3_x);
        let t63 = c3 * t53 + s3 * t56;
        let n2_y = s3 * t53 - c3 * t56;
        put(2, n3_z);
        [n3_z, t63, n2_y]
    };
    // link 2: force and moment
    {
        let n2_z = n3_z + (MSX2R * a2_y - MSY2 * a2_x);
        let n1_z = s2 * t63 + c2 * n2_y;
        put(0, n1_z);
        put(1, n2_z);
    }
}
