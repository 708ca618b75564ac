//! Regressor `W` of the standard parameters.
//!
//! `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil
//! and Dombre, 12.4.
//!
//! 473 multiplications, 386 additions; 6 x 78, 206 of 468 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 206;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 6), (0, 10), (0, 11), (0, 12), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18),
    (0, 19), (0, 20), (0, 21), (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28),
    (0, 29), (0, 30), (0, 31), (0, 32), (0, 33), (0, 34), (0, 35), (0, 36), (0, 37), (0, 38),
    (0, 39), (0, 40), (0, 41), (0, 42), (0, 43), (0, 44), (0, 45), (0, 46), (0, 47), (0, 48),
    (0, 49), (0, 50), (0, 51), (0, 52), (0, 53), (0, 54), (0, 55), (0, 56), (0, 57), (0, 58),
    (0, 59), (0, 60), (0, 66), (0, 72), (1, 11), (1, 12), (1, 14), (1, 15), (1, 16), (1, 17),
    (1, 18), (1, 19), (1, 20), (1, 21), (1, 22), (1, 23), (1, 24), (1, 25), (1, 26), (1, 27),
    (1, 28), (1, 29), (1, 30), (1, 31), (1, 32), (1, 33), (1, 34), (1, 35), (1, 36), (1, 37),
    (1, 38), (1, 39), (1, 40), (1, 41), (1, 42), (1, 43), (1, 44), (1, 45), (1, 46), (1, 47),
    (1, 48), (1, 49), (1, 50), (1, 51), (1, 52), (1, 53), (1, 54), (1, 55), (1, 56), (1, 57),
    (1, 58), (1, 59), (1, 61), (1, 67), (1, 73), (2, 21), (2, 22), (2, 24), (2, 25), (2, 26),
    (2, 27), (2, 28), (2, 29), (2, 30), (2, 31), (2, 32), (2, 33), (2, 34), (2, 35), (2, 36),
    (2, 37), (2, 38), (2, 39), (2, 40), (2, 41), (2, 42), (2, 43), (2, 44), (2, 45), (2, 46),
    (2, 47), (2, 48), (2, 49), (2, 50), (2, 51), (2, 52), (2, 53), (2, 54), (2, 55), (2, 56),
    (2, 57), (2, 58), (2, 59), (2, 62), (2, 68), (2, 74), (3, 31), (3, 32), (3, 34), (3, 35),
    (3, 36), (3, 37), (3, 38), (3, 39), (3, 41), (3, 42), (3, 43), (3, 44), (3, 45), (3, 46),
    (3, 47), (3, 48), (3, 49), (3, 51), (3, 52), (3, 53), (3, 54), (3, 55), (3, 56), (3, 57),
    (3, 58), (3, 59), (3, 63), (3, 69), (3, 75), (4, 41), (4, 42), (4, 44), (4, 45), (4, 46),
    (4, 47), (4, 48), (4, 49), (4, 51), (4, 52), (4, 53), (4, 54), (4, 55), (4, 56), (4, 57),
    (4, 58), (4, 59), (4, 64), (4, 70), (4, 76), (5, 51), (5, 52), (5, 54), (5, 55), (5, 56),
    (5, 57), (5, 58), (5, 59), (5, 65), (5, 71), (5, 77),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 78 + PATTERN[k].1
}

/// Regressor `W` of the standard parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 78]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    clear(&mut flat[0..6]);
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            0 => clear(&mut flat[7..10]),
            51 => clear(&mut flat[61..66]),
            52 => clear(&mut flat[67..72]),
            53 => clear(&mut flat[73..89]),
            55 => flat[91] = S::default(),
            101 => flat[138] = S::default(),
            102 => clear(&mut flat[140..145]),
            103 => clear(&mut flat[146..151]),
            104 => clear(&mut flat[152..177]),
            106 => flat[179] = S::default(),
            142 => clear(&mut flat[216..218]),
            143 => clear(&mut flat[219..224]),
            144 => clear(&mut flat[225..230]),
            145 => clear(&mut flat[231..265]),
            147 => flat[267] = S::default(),
            153 => flat[274] = S::default(),
            162 => flat[284] = S::default(),
            171 => clear(&mut flat[294..297]),
            172 => clear(&mut flat[298..303]),
            173 => clear(&mut flat[304..309]),
            174 => clear(&mut flat[310..353]),
            176 => flat[355] = S::default(),
            182 => flat[362] = S::default(),
            191 => clear(&mut flat[372..376]),
            192 => clear(&mut flat[377..382]),
            193 => clear(&mut flat[383..388]),
            194 => clear(&mut flat[389..441]),
            196 => flat[443] = S::default(),
            202 => clear(&mut flat[450..455]),
            203 => clear(&mut flat[456..461]),
            204 => clear(&mut flat[462..467]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 78]; 6]) {
    entries(trig, dq, ddq, |k, x| {
        out[PATTERN[k].0][PATTERN[k].1] = x;
    });
}

/// The same, only the entries of [`PATTERN`].
#[inline]
pub fn packed<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [S; NONZEROS]) {
    entries(trig, dq, ddq, |k, x| out[k] = x);
}

#[allow(non_snake_case, clippy::all)]
#[inline(always)]
pub(crate) fn entries<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], mut put: impl FnMut(usize, S)) {
    let [_, s2, s3, s4, s5, s6] = trig.sin;
    let [_, c2, c3, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let k1 = S::constant(-(-constants::D3 - constants::D2));
    let k2 = S::constant(-GRAVITY[2]);
    let k3 = S::constant(0.2435);
    let k4 = S::constant(0.05929225);
    let k5 = S::constant(0.487);
    let k6 = S::constant(-constants::D3);
    let k7 = S::constant(-constants::A3);
    let k_A2 = S::constant(constants::A2);
    let k_D4 = S::constant(constants::D4);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        put(0, ddq1); // row 1, ZZ1
        put(51, ddq1); // row 1, IA1
        put(52, dq1); // row 1, FV1
        put(58, ddq2); // row 2, ZZ2
        put(102, ddq2); // row 2, IA2
        put(103, dq2); // row 2, FV2
        put(143, ddq3); // row 3, IA3
        put(144, dq3); // row 3, FV3
        put(172, ddq4); // row 4, IA4
        put(173, dq4); // row 4, FV4
        put(192, ddq5); // row 5, IA5
        put(193, dq5); // row 5, FV5
        put(203, ddq6); // row 6, IA6
        put(204, dq6); // row 6, FV6
        t0
    };
    // joint axes in frame 3
    let [v1_3_z, t6, v1_3_y, v2_3_x, v2_3_y] = {
        let v1_3_z = c2 * k_A2;
        let t2 = c2 * k1;
        let t3 = s2 * k1;
        let t6 = c3 * t2 - s3 * t3;
        let v1_3_y = c3 * t3 + s3 * t2;
        let v2_3_x = s3 * k_A2;
        let v2_3_y = c3 * k_A2;
        [v1_3_z, t6, v1_3_y, v2_3_x, v2_3_y]
    };
    // link 2: motion
    let [
        t12, t13, t15, t17, t19, t22, t23, t27,
        t28, t29, t30, t31, t32, t33, t34, t35,
        t36, t37,
    ] = {
        let t12 = s2 * k2;
        let t13 = c2 * k2;
        let t14 = k3 * ddq1;
        let t15 = k3 * t0;
        let t17 = t12 + c2 * t14;
        let t19 = t13 - s2 * t14;
        let t20 = s2 * dq1;
        let t21 = c2 * dq1;
        let t22 = s2 * ddq1;
        let t23 = c2 * ddq1;
        let t24 = t20 * t20;
        let t25 = dq2 * dq2;
        let t26 = t20 * t21;
        let t27 = dq2 * t20;
        let t28 = dq2 * t21;
        let t29 = t22 + t28;
        let t30 = t23 - t27;
        let t31 = t24 - t25;
        let t32 = t0 - t31;
        let t33 = ddq2 - t26;
        let t34 = ddq2 + t26;
        let t35 = t24 + t25;
        let t36 = t30 - t27;
        let t37 = t28 + t29;
        let t38 = -t26;
        let t39 = -t22;
        let t40 = -t23;
        put(56, t38); // row 2, XX2
        put(57, t26); // row 2, YY2
        put(60, t39); // row 2, XZ2
        put(61, t40); // row 2, YZ2
        [
        t12, t13, t15, t17, t19, t22, t23, t27,
        t28, t29, t30, t31, t32, t33, t34, t35,
        t36, t37,
    ]
    };
    // M2: column
    let t43 = {
        let t43 = s2 * t13 - c2 * t12;
        t43
    };
    // MSZ2: column
    let t44 = {
        let t44 = k3 * t43;
        t44
    };
    // XX2: column
    let [t46, t47] = {
        let t46 = c2 * t27;
        let t47 = s2 * t29 + t46;
        put(5, t47); // row 1, XX2
        [t46, t47]
    };
    // YY2: column
    let [t48, t51] = {
        let t48 = s2 * t28;
        let t50 = c2 * t30 - t48;
        let t51 = t47 + t50;
        let t53 = t51 * k4 - t44;
        put(1, t53); // row 1, M2
        put(6, t50); // row 1, YY2
        [t48, t51]
    };
    // MSX2: column
    let t54 = {
        let t54 = s2 * t34;
        t54
    };
    // XZ2: column
    {
        let t56 = t54 - c2 * t31;
        let t57 = k3 * t56;
        let t59 = k3 * t22 - t13;
        let t60 = -t56;
        put(2, t57); // row 1, MSX2
        put(9, t60); // row 1, XZ2
        put(54, t59); // row 2, MSX2
    }
    // MSY2: column
    let t61 = {
        let t61 = c2 * t33;
        t61
    };
    // YZ2: column
    {
        let t64 = t61 - s2 * (t35 - t0);
        let t65 = k3 * t64;
        let t67 = t12 + k3 * t23;
        let t68 = -t64;
        put(3, t65); // row 1, MSY2
        put(10, t68); // row 1, YZ2
        put(55, t67); // row 2, MSY2
    }
    // YY2: column
    {
        let t70 = t51 * k5 - t43;
        put(4, t70); // row 1, MSZ2
    }
    // ZZ2: column
    {
        let t71 = t48 - t46;
        put(7, t71); // row 1, ZZ2
    }
    // XY2: column
    {
        let t72 = t35 - t32;
        let t75 = s2 * t36 + c2 * t37;
        put(8, t75); // row 1, XY2
        put(59, t72); // row 2, XY2
    }
    // link 3: motion
    let [
        t78, t81, w3_z, t95, t98, a3_y, t102, t103,
        t104, t105, t109, t110, t111, t112, t113, t114,
        t115, t116, t117, t118, t119,
    ] = {
        let t78 = s2 * c3 + c2 * s3;
        let t81 = c2 * c3 - s2 * s3;
        let w3_z = dq2 + dq3;
        let dw3_z = ddq2 + ddq3;
        let t93 = t17 + (k_A2 * t32 - t23 * k6);
        let t94 = t19 + (t22 * k6 - k_A2 * t34);
        let t95 = t15 - (k_A2 * t36 + t0 * k6);
        let t98 = c3 * t93 + s3 * t94;
        let a3_y = s3 * t93 - c3 * t94;
        let t102 = ddq1 * t81;
        let t103 = ddq1 * t78;
        let t104 = dq1 * t78;
        let t105 = dq1 * t81;
        let t106 = t104 * t104;
        let t107 = w3_z * w3_z;
        let t108 = t104 * t105;
        let t109 = w3_z * t104;
        let t110 = w3_z * t105;
        let t111 = t103 + t110;
        let t112 = t102 - t109;
        let t113 = t106 - t107;
        let t114 = t113 - t0;
        let t115 = dw3_z - t108;
        let t116 = dw3_z + t108;
        let t117 = t106 + t107;
        let t118 = t112 - t109;
        let t119 = t110 + t111;
        let t120 = -t108;
        let t121 = -t103;
        let t122 = -t102;
        put(66, t120); // row 2, XX3
        put(67, t108); // row 2, YY3
        put(68, dw3_z); // row 2, ZZ3
        put(70, t121); // row 2, XZ3
        put(71, t122); // row 2, YZ3
        put(105, a3_y); // row 3, MSX3
        put(106, t98); // row 3, MSY3
        put(107, t120); // row 3, XX3
        put(108, t108); // row 3, YY3
        put(109, dw3_z); // row 3, ZZ3
        put(111, t121); // row 3, XZ3
        put(112, t122); // row 3, YZ3
        [
        t78, t81, w3_z, t95, t98, a3_y, t102, t103,
        t104, t105, t109, t110, t111, t112, t113, t114,
        t115, t116, t117, t118, t119,
    ]
    };
    // joint axes in frame 4
    let [t129, t132, t134, v2_4_x, t136, v3_4_x, t138] = {
        let t126 = t81 * k7 - k_D4 * t78 - v1_3_z;
        let t129 = c4 * t6 + s4 * t126;
        let t132 = c4 * t126 - s4 * t6;
        let t133 = k_D4 + v2_3_x;
        let t134 = v2_3_y - k7;
        let v2_4_x = c4 * t133;
        let t136 = s4 * t133;
        let v3_4_x = c4 * k_D4;
        let t138 = s4 * k_D4;
        [t129, t132, t134, v2_4_x, t136, v3_4_x, t138]
    };
    // M3: column
    {
        let t143 = t98 * t6 + a3_y * v1_3_y - t95 * v1_3_z;
        let t146 = a3_y * v2_3_y - t98 * v2_3_x;
        put(11, t143); // row 1, M3
        put(62, t146); // row 2, M3
    }
    // MSX3: column
    {
        let t153 = t118 * v1_3_z - (t114 * t6 - t116 * v1_3_y) - t81 * t95;
        let t157 = a3_y + (t114 * v2_3_x + t116 * v2_3_y);
        put(12, t153); // row 1, MSX3
        put(63, t157); // row 2, MSX3
    }
    // MSY3: column
    let t160 = {
        let t160 = t117 * v1_3_y;
        let t164 = t78 * t95 - (t119 * v1_3_z - (t115 * t6 - t160));
        let t168 = t98 - (t115 * v2_3_x + t117 * v2_3_y);
        put(13, t164); // row 1, MSY3
        put(64, t168); // row 2, MSY3
        t160
    };
    // MSZ3: column
    {
        let t176 = t102 * t6 + t103 * v1_3_y - t0 * v1_3_z;
        let t177 = t78 * a3_y + t81 * t98 + t176;
        let t180 = t103 * v2_3_y - t102 * v2_3_x;
        put(14, t177); // row 1, MSZ3
        put(65, t180); // row 2, MSZ3
    }
    // XX3: column
    let t182 = {
        let t182 = t81 * t109;
        let t183 = t78 * t111 + t182;
        put(15, t183); // row 1, XX3
        t182
    };
    // YY3: column
    let t184 = {
        let t184 = t78 * t110;
        let t186 = t81 * t112 - t184;
        put(16, t186); // row 1, YY3
        t184
    };
    // ZZ3: column
    {
        let t187 = t184 - t182;
        put(17, t187); // row 1, ZZ3
    }
    // XY3: column
    {
        let t188 = t114 + t117;
        let t191 = t78 * t118 + t81 * t119;
        put(18, t191); // row 1, XY3
        put(69, t188); // row 2, XY3
        put(110, t188); // row 3, XY3
    }
    // XZ3: column
    {
        let t194 = t81 * t113 - t78 * t116;
        put(19, t194); // row 1, XZ3
    }
    // YZ3: column
    {
        let t198 = t78 * (t117 - t0) - t81 * t115;
        put(20, t198); // row 1, YZ3
    }
    // link 4: motion
    let [
        t199, z1_4_y, t211, t215, t218, w4_x, w4_y, t227,
        t230, w4_z, dw4_z, t235, t236, t237, dw4_x, dw4_y,
        t240, t241, t242, t243, t244, t245, t246,
    ] = {
        let t199 = c4 * t78;
        let z1_4_y = s4 * t78;
        let t210 = k_D4 * t115 - t114 * k7 - t98;
        let t211 = a3_y + (k_D4 * t117 - t116 * k7);
        let t212 = t95 + (t118 * k7 - k_D4 * t119);
        let t215 = s4 * t212 - c4 * t210;
        let t218 = c4 * t212 + s4 * t210;
        let w4_x = s4 * w3_z - c4 * t104;
        let w4_y = c4 * w3_z + s4 * t104;
        let t227 = c4 * t115 + s4 * t119;
        let t230 = s4 * t115 - c4 * t119;
        let w4_z = t105 + dq4;
        let dw4_z = t112 + ddq4;
        let t233 = w4_x * w4_x;
        let t234 = w4_z * w4_z;
        let t235 = w4_x * w4_y;
        let t236 = w4_x * w4_z;
        let t237 = w4_y * w4_z;
        let dw4_x = t230 + t237;
        let dw4_y = t227 - t236;
        let t240 = t233 - t234;
        let t241 = t240 - t117;
        let t242 = t235 - dw4_z;
        let t243 = dw4_z + t235;
        let t244 = t233 + t234;
        let t245 = dw4_y - t236;
        let t246 = t237 + dw4_x;
        let t247 = -t218;
        let t248 = -t235;
        put(146, t247); // row 4, MSX4
        put(147, t215); // row 4, MSY4
        put(148, t248); // row 4, XX4
        put(149, t235); // row 4, YY4
        put(150, dw4_z); // row 4, ZZ4
        put(152, t230); // row 4, XZ4
        put(153, t227); // row 4, YZ4
        [
        t199, z1_4_y, t211, t215, t218, w4_x, w4_y, t227,
        t230, w4_z, dw4_z, t235, t236, t237, dw4_x, dw4_y,
        t240, t241, t242, t243, t244, t245, t246,
    ]
    };
    // M4: column
    let [t250, t255, t260] = {
        let t250 = t218 * t132;
        let t253 = t211 * v1_3_y + (t215 * t129 + t250);
        let t255 = t218 * t136;
        let t258 = t211 * t134 + (t255 - t215 * v2_4_x);
        let t260 = t218 * t138;
        let t263 = t260 - t215 * v3_4_x - k7 * t211;
        put(21, t253); // row 1, M4
        put(72, t258); // row 2, M4
        put(113, t263); // row 3, M4
        [t250, t255, t260]
    };
    // MSX4: column
    {
        let t271 = t245 * v1_3_y - (t241 * t129 + t243 * t132);
        let t272 = z1_4_y * t211 - t81 * t218 + t271;
        let t273 = c4 * t211;
        let t279 = t273 + (t245 * t134 + (t241 * v2_4_x - t243 * t136));
        let t285 = t273 - (k7 * t245 - (t241 * v3_4_x - t243 * t138));
        put(22, t272); // row 1, MSX4
        put(73, t279); // row 2, MSX4
        put(114, t285); // row 3, MSX4
    }
    // MSY4: column
    let [t290, t297, t303] = {
        let t290 = t244 * t132;
        let t294 = t199 * t211 + t81 * t215 - (t246 * v1_3_y + (t242 * t129 - t290));
        let t295 = s4 * t211;
        let t297 = t244 * t136;
        let t301 = t242 * v2_4_x + t297 - t246 * t134 - t295;
        let t303 = t244 * t138;
        let t307 = k7 * t246 + (t242 * v3_4_x + t303) - t295;
        put(23, t294); // row 1, MSY4
        put(74, t301); // row 2, MSY4
        put(115, t307); // row 3, MSY4
        [t290, t297, t303]
    };
    // MSZ4: column
    {
        let t315 = t160 + (t230 * t132 - t227 * t129) - (t199 * t218 + z1_4_y * t215);
        let t318 = s4 * t218 - c4 * t215;
        let t324 = t318 + (t117 * t134 + (t227 * v2_4_x + t230 * t136));
        let t330 = t318 - (t117 * k7 - (t227 * v3_4_x + t230 * t138));
        put(24, t315); // row 1, MSZ4
        put(75, t324); // row 2, MSZ4
        put(116, t330); // row 3, MSZ4
    }
    // joint axes in frame 5
    let [
        t333, t336, v1_5_x, v1_5_y, z2_5_x, z2_6_z, v2_5_x, v2_6_z,
        t353, v3_6_z,
    ] = {
        let t333 = c5 * t199 + s5 * t81;
        let t336 = c5 * t81 - s5 * t199;
        let v1_5_x = s5 * v1_3_y - c5 * t129;
        let v1_5_y = c5 * v1_3_y + s5 * t129;
        let z2_5_x = s4 * c5;
        let z2_6_z = s4 * s5;
        let v2_5_x = c5 * v2_4_x + s5 * t134;
        let v2_6_z = s5 * v2_4_x - c5 * t134;
        let t353 = s5 * k7 - c5 * v3_4_x;
        let v3_6_z = c5 * k7 + s5 * v3_4_x;
        [
        t333, t336, v1_5_x, v1_5_y, z2_5_x, z2_6_z, v2_5_x, v2_6_z,
        t353, v3_6_z,
    ]
    };
    // XX4: column
    let [t358, t359, t363] = {
        let t358 = z1_4_y * t236;
        let t359 = t81 * t235;
        let t361 = t358 - t199 * dw4_x - t359;
        let t363 = c4 * t236;
        let t364 = s4 * dw4_x + t363;
        put(25, t361); // row 1, XX4
        put(76, t364); // row 2, XX4
        put(117, t364); // row 3, XX4
        [t358, t359, t363]
    };
    // YY4: column
    let [t365, t369] = {
        let t365 = t199 * t237;
        let t368 = t359 + (t365 + z1_4_y * dw4_y);
        let t369 = s4 * t237;
        let t371 = c4 * dw4_y - t369;
        put(26, t368); // row 1, YY4
        put(77, t371); // row 2, YY4
        put(118, t371); // row 3, YY4
        [t365, t369]
    };
    // ZZ4: column
    {
        let t374 = t81 * dw4_z - (t358 + t365);
        let t375 = t369 - t363;
        put(27, t374); // row 1, ZZ4
        put(78, t375); // row 2, ZZ4
        put(119, t375); // row 3, ZZ4
    }
    // XY4: column
    {
        let t376 = t241 + t244;
        let t381 = t81 * t376 - (t199 * t245 - z1_4_y * t246);
        let t384 = s4 * t245 + c4 * t246;
        put(28, t381); // row 1, XY4
        put(79, t384); // row 2, XY4
        put(120, t384); // row 3, XY4
        put(151, t376); // row 4, XY4
    }
    // XZ4: column
    {
        let t389 = t81 * t230 - (t199 * t243 + z1_4_y * t240);
        let t392 = s4 * t243 - c4 * t240;
        put(29, t389); // row 1, XZ4
        put(80, t392); // row 2, XZ4
        put(121, t392); // row 3, XZ4
    }
    // YZ4: column
    {
        let t393 = t117 - t244;
        let t398 = t81 * t227 - (t199 * t393 + z1_4_y * t242);
        let t401 = s4 * t393 - c4 * t242;
        put(30, t398); // row 1, YZ4
        put(81, t401); // row 2, YZ4
        put(122, t401); // row 3, YZ4
    }
    // link 5: motion
    let [
        t404, a5_y, w5_x, t413, t416, t419, w5_z, dw5_z,
        t424, t425, t426, t427, t428, t429, t430, t431,
        t432, t433, t434, t435,
    ] = {
        let t404 = c5 * t215 - s5 * t211;
        let a5_y = c5 * t211 + s5 * t215;
        let w5_x = c5 * w4_x - s5 * w4_z;
        let t413 = c5 * w4_z + s5 * w4_x;
        let t416 = c5 * t242 - s5 * t246;
        let t419 = c5 * t246 + s5 * t242;
        let w5_z = w4_y + dq5;
        let dw5_z = dw4_y + ddq5;
        let t422 = w5_x * w5_x;
        let t423 = w5_z * w5_z;
        let t424 = w5_x * t413;
        let t425 = w5_x * w5_z;
        let t426 = t413 * w5_z;
        let t427 = t426 - t419;
        let t428 = t425 - t416;
        let t429 = t422 - t423;
        let t430 = t244 - t429;
        let t431 = dw5_z + t424;
        let t432 = t424 - dw5_z;
        let t433 = t422 + t423;
        let t434 = t425 + t428;
        let t435 = t426 + t427;
        let t436 = -t424;
        put(175, a5_y); // row 5, MSX5
        put(176, t404); // row 5, MSY5
        put(177, t424); // row 5, XX5
        put(178, t436); // row 5, YY5
        put(179, dw5_z); // row 5, ZZ5
        put(181, t419); // row 5, XZ5
        put(182, t416); // row 5, YZ5
        [
        t404, a5_y, w5_x, t413, t416, t419, w5_z, dw5_z,
        t424, t425, t426, t427, t428, t429, t430, t431,
        t432, t433, t434, t435,
    ]
    };
    // M5: column
    let [t438, t442, t446] = {
        let t438 = a5_y * v1_5_y;
        let t440 = t250 + (t438 - t404 * v1_5_x);
        let t442 = a5_y * v2_6_z;
        let t444 = t255 - (t404 * v2_5_x + t442);
        let t446 = a5_y * v3_6_z;
        let t448 = t260 + (t404 * t353 - t446);
        put(31, t440); // row 1, M5
        put(82, t444); // row 2, M5
        put(123, t448); // row 3, M5
        [t438, t442, t446]
    };
    // MSX5: column
    {
        let t456 = t434 * t132 + (t430 * v1_5_x + t432 * v1_5_y);
        let t457 = z1_4_y * a5_y - t218 * t336 - t456;
        let t460 = c4 * a5_y - t218 * z2_6_z;
        let t466 = t460 - (t434 * t136 - (t432 * v2_6_z - t430 * v2_5_x));
        let t472 = t460 + (t430 * t353 + t432 * v3_6_z - t434 * t138);
        let t474 = -(c5 * t218);
        put(32, t457); // row 1, MSX5
        put(83, t466); // row 2, MSX5
        put(124, t472); // row 3, MSX5
        put(154, t474); // row 4, MSX5
    }
    // MSY5: column
    let [t479, t488, t494] = {
        let t479 = t433 * v1_5_y;
        let t483 = t218 * t333 + z1_4_y * t404 + (t435 * t132 - (t431 * v1_5_x + t479));
        let t486 = c4 * t404 - t218 * z2_5_x;
        let t488 = t433 * v2_6_z;
        let t492 = t486 + (t435 * t136 + (t488 - t431 * v2_5_x));
        let t494 = t433 * v3_6_z;
        let t498 = t486 + (t435 * t138 + (t431 * t353 + t494));
        let t499 = s5 * t218;
        put(33, t483); // row 1, MSY5
        put(84, t492); // row 2, MSY5
        put(125, t498); // row 3, MSY5
        put(155, t499); // row 4, MSY5
        [t479, t488, t494]
    };
    // MSZ5: column
    {
        let t507 = a5_y * t333 + t404 * t336 + (t290 + (t416 * v1_5_x - t419 * v1_5_y));
        let t510 = t404 * z2_6_z - a5_y * z2_5_x;
        let t515 = t510 + (t297 + (t416 * v2_5_x + t419 * v2_6_z));
        let t520 = t510 + (t303 + (t419 * v3_6_z - t416 * t353));
        let t523 = s5 * a5_y + c5 * t404;
        put(34, t507); // row 1, MSZ5
        put(85, t515); // row 2, MSZ5
        put(126, t520); // row 3, MSZ5
        put(156, t523); // row 4, MSZ5
    }
    // joint axes in frame 6
    let [
        z1_6_x, z1_6_y, v1_6_x, t535, z2_6_x, t541, t544, t547,
        t550, t553, t554, z4_6_y,
    ] = {
        let z1_6_x = s6 * z1_4_y - c6 * t333;
        let z1_6_y = c6 * z1_4_y + s6 * t333;
        let v1_6_x = c6 * v1_5_x - s6 * t132;
        let t535 = c6 * t132 + s6 * v1_5_x;
        let z2_6_x = c6 * z2_5_x + c4 * s6;
        let t541 = s6 * z2_5_x - c4 * c6;
        let t544 = s6 * t136 - c6 * v2_5_x;
        let t547 = c6 * t136 + s6 * v2_5_x;
        let t550 = c6 * t353 + s6 * t138;
        let t553 = c6 * t138 - s6 * t353;
        let t554 = s5 * c6;
        let z4_6_y = s5 * s6;
        [
        z1_6_x, z1_6_y, v1_6_x, t535, z2_6_x, t541, t544, t547,
        t550, t553, t554, z4_6_y,
    ]
    };
    // XX5: column
    let [t557, t558, t562, t563, t567] = {
        let t557 = t425 * t336;
        let t558 = z1_4_y * t424;
        let t560 = t558 + (t427 * t333 - t557);
        let t562 = t425 * z2_6_z;
        let t563 = c4 * t424;
        let t565 = t563 - (t427 * z2_5_x + t562);
        let t567 = c5 * t425;
        let t568 = s5 * t427 - t567;
        put(35, t560); // row 1, XX5
        put(86, t565); // row 2, XX5
        put(127, t565); // row 3, XX5
        put(157, t568); // row 4, XX5
        [t557, t558, t562, t563, t567]
    };
    // YY5: column
    let [t569, t573, t577] = {
        let t569 = t426 * t333;
        let t572 = t428 * t336 - t569 - t558;
        let t573 = t426 * z2_5_x;
        let t576 = t573 + t428 * z2_6_z - t563;
        let t577 = s5 * t426;
        let t579 = c5 * t428 - t577;
        put(36, t572); // row 1, YY5
        put(87, t576); // row 2, YY5
        put(128, t576); // row 3, YY5
        put(158, t579); // row 4, YY5
        [t569, t573, t577]
    };
    // ZZ5: column
    {
        let t582 = z1_4_y * dw5_z + (t557 + t569);
        let t585 = c4 * dw5_z - (t573 - t562);
        let t586 = t567 + t577;
        put(37, t582); // row 1, ZZ5
        put(88, t585); // row 2, ZZ5
        put(129, t585); // row 3, ZZ5
        put(159, t586); // row 4, ZZ5
    }
    // XY5: column
    {
        let t587 = t433 - t430;
        let t592 = z1_4_y * t587 + (t434 * t333 + t435 * t336);
        let t597 = c4 * t587 - (t434 * z2_5_x - t435 * z2_6_z);
        let t600 = s5 * t434 + c5 * t435;
        put(38, t592); // row 1, XY5
        put(89, t597); // row 2, XY5
        put(130, t597); // row 3, XY5
        put(160, t600); // row 4, XY5
        put(180, t587); // row 5, XY5
    }
    // XZ5: column
    {
        let t605 = z1_4_y * t419 + (t432 * t333 + t429 * t336);
        let t610 = c4 * t419 + (t429 * z2_6_z - t432 * z2_5_x);
        let t613 = s5 * t432 + c5 * t429;
        put(39, t605); // row 1, XZ5
        put(90, t610); // row 2, XZ5
        put(131, t610); // row 3, XZ5
        put(161, t613); // row 4, XZ5
    }
    // YZ5: column
    {
        let t614 = t433 - t244;
        let t619 = z1_4_y * t416 - (t431 * t336 - t333 * t614);
        let t624 = c4 * t416 - (z2_5_x * t614 + t431 * z2_6_z);
        let t627 = s5 * t614 - c5 * t431;
        put(40, t619); // row 1, YZ5
        put(91, t624); // row 2, YZ5
        put(132, t624); // row 3, YZ5
        put(162, t627); // row 4, YZ5
    }
    // link 6: motion
    let [
        t630, a6_y, t642, t645, dw6_z, t650, t651, t652,
        dw6_x, dw6_y, t655, t656, t657, t658, t659, t660,
        t661,
    ] = {
        let t630 = c6 * t404 + s6 * t218;
        let a6_y = s6 * t404 - c6 * t218;
        let w6_x = c6 * w5_x + s6 * w5_z;
        let w6_y = c6 * w5_z - s6 * w5_x;
        let t642 = c6 * t431 + s6 * t435;
        let t645 = s6 * t431 - c6 * t435;
        let w6_z = t413 + dq6;
        let dw6_z = t428 + ddq6;
        let t648 = w6_x * w6_x;
        let t649 = w6_z * w6_z;
        let t650 = w6_x * w6_y;
        let t651 = w6_x * w6_z;
        let t652 = w6_y * w6_z;
        let dw6_x = t645 + t652;
        let dw6_y = t642 - t651;
        let t655 = t648 - t649;
        let t656 = t433 - t655;
        let t657 = dw6_z - t650;
        let t658 = dw6_z + t650;
        let t659 = t648 + t649;
        let t660 = t651 - dw6_y;
        let t661 = t652 + dw6_x;
        let t662 = -t650;
        put(195, a6_y); // row 6, MSX6
        put(196, t630); // row 6, MSY6
        put(197, t662); // row 6, XX6
        put(198, t650); // row 6, YY6
        put(199, dw6_z); // row 6, ZZ6
        put(201, t645); // row 6, XZ6
        put(202, t642); // row 6, YZ6
        [
        t630, a6_y, t642, t645, dw6_z, t650, t651, t652,
        dw6_x, dw6_y, t655, t656, t657, t658, t659, t660,
        t661,
    ]
    };
    // M6: column
    {
        let t666 = t438 - (t630 * v1_6_x + a6_y * t535);
        let t670 = t630 * t544 - a6_y * t547 - t442;
        let t674 = t630 * t550 - a6_y * t553 - t446;
        put(41, t666); // row 1, M6
        put(92, t670); // row 2, M6
        put(133, t674); // row 3, M6
    }
    // MSX6: column
    {
        let t682 = t660 * v1_5_y + (t656 * v1_6_x + t658 * t535);
        let t683 = a5_y * z1_6_y + a6_y * t336 - t682;
        let t686 = a6_y * z2_6_z - a5_y * t541;
        let t692 = t686 + (t660 * v2_6_z + (t656 * t544 - t658 * t547));
        let t698 = t686 + (t660 * v3_6_z + (t656 * t550 - t658 * t553));
        let t701 = a5_y * z4_6_y + c5 * a6_y;
        let t702 = c6 * a5_y;
        put(42, t683); // row 1, MSX6
        put(93, t692); // row 2, MSX6
        put(134, t698); // row 3, MSX6
        put(163, t701); // row 4, MSX6
        put(183, t702); // row 5, MSX6
    }
    // MSY6: column
    {
        let t710 = t659 * t535 - t657 * v1_6_x - t661 * v1_5_y;
        let t711 = t630 * t336 - a5_y * z1_6_x + t710;
        let t714 = a5_y * z2_6_x - t630 * z2_6_z;
        let t720 = t661 * v2_6_z + (t657 * t544 + t659 * t547) - t714;
        let t726 = t661 * v3_6_z + (t657 * t550 + t659 * t553) - t714;
        let t729 = a5_y * t554 + c5 * t630;
        let t731 = -(s6 * a5_y);
        put(43, t711); // row 1, MSY6
        put(94, t720); // row 2, MSY6
        put(135, t726); // row 3, MSY6
        put(164, t729); // row 4, MSY6
        put(184, t731); // row 5, MSY6
    }
    // MSZ6: column
    {
        let t739 = t479 + (t642 * v1_6_x + t645 * t535) - (a6_y * z1_6_x + t630 * z1_6_y);
        let t742 = t630 * t541 - a6_y * z2_6_x;
        let t747 = t742 + (t645 * t547 - t642 * t544 - t488);
        let t752 = t742 + (t645 * t553 - t642 * t550 - t494);
        let t755 = a6_y * t554 - t630 * z4_6_y;
        let t759 = -(s6 * a6_y + c6 * t630);
        put(44, t739); // row 1, MSZ6
        put(95, t747); // row 2, MSZ6
        put(136, t752); // row 3, MSZ6
        put(165, t755); // row 4, MSZ6
        put(185, t759); // row 5, MSZ6
    }
    // XX6: column
    let [t761, t762, t766, t767, t771, t772, t776] = {
        let t761 = t651 * z1_6_y;
        let t762 = t650 * t336;
        let t764 = dw6_x * z1_6_x + t761 - t762;
        let t766 = t651 * t541;
        let t767 = t650 * z2_6_z;
        let t769 = dw6_x * z2_6_x - t766 - t767;
        let t771 = t651 * z4_6_y;
        let t772 = c5 * t650;
        let t774 = t771 - dw6_x * t554 - t772;
        let t776 = c6 * t651;
        let t777 = s6 * dw6_x + t776;
        put(45, t764); // row 1, XX6
        put(96, t769); // row 2, XX6
        put(137, t769); // row 3, XX6
        put(166, t774); // row 4, XX6
        put(186, t777); // row 5, XX6
        [t761, t762, t766, t767, t771, t772, t776]
    };
    // YY6: column
    let [t778, t782, t786, t790] = {
        let t778 = t652 * z1_6_x;
        let t781 = t762 - (t778 - dw6_y * z1_6_y);
        let t782 = t652 * z2_6_x;
        let t785 = t767 - (t782 + dw6_y * t541);
        let t786 = t652 * t554;
        let t789 = t772 + (t786 + dw6_y * z4_6_y);
        let t790 = s6 * t652;
        let t792 = c6 * dw6_y - t790;
        put(46, t781); // row 1, YY6
        put(97, t785); // row 2, YY6
        put(138, t785); // row 3, YY6
        put(167, t789); // row 4, YY6
        put(187, t792); // row 5, YY6
        [t778, t782, t786, t790]
    };
    // ZZ6: column
    {
        let t795 = dw6_z * t336 + (t778 - t761);
        let t798 = dw6_z * z2_6_z + (t766 + t782);
        let t801 = c5 * dw6_z - (t771 + t786);
        let t802 = t790 - t776;
        put(47, t795); // row 1, ZZ6
        put(98, t798); // row 2, ZZ6
        put(139, t798); // row 3, ZZ6
        put(168, t801); // row 4, ZZ6
        put(188, t802); // row 5, ZZ6
    }
    // XY6: column
    {
        let t803 = t659 - t656;
        let t808 = t336 * t803 + (t661 * z1_6_y - t660 * z1_6_x);
        let t813 = z2_6_z * t803 - (t660 * z2_6_x + t661 * t541);
        let t818 = c5 * t803 + (t660 * t554 + t661 * z4_6_y);
        let t821 = c6 * t661 - s6 * t660;
        put(48, t808); // row 1, XY6
        put(99, t813); // row 2, XY6
        put(140, t813); // row 3, XY6
        put(169, t818); // row 4, XY6
        put(189, t821); // row 5, XY6
        put(200, t803); // row 6, XY6
    }
    // XZ6: column
    {
        let t826 = t645 * t336 - (t655 * z1_6_y - t658 * z1_6_x);
        let t831 = t645 * z2_6_z + (t658 * z2_6_x + t655 * t541);
        let t836 = c5 * t645 - (t658 * t554 + t655 * z4_6_y);
        let t839 = s6 * t658 - c6 * t655;
        put(49, t826); // row 1, XZ6
        put(100, t831); // row 2, XZ6
        put(141, t831); // row 3, XZ6
        put(170, t836); // row 4, XZ6
        put(190, t839); // row 5, XZ6
    }
    // YZ6: column
    {
        let t840 = t433 - t659;
        let t845 = t642 * t336 + (z1_6_x * t840 + t657 * z1_6_y);
        let t850 = t642 * z2_6_z + (z2_6_x * t840 - t657 * t541);
        let t855 = c5 * t642 + (t657 * z4_6_y - t554 * t840);
        let t858 = s6 * t840 + c6 * t657;
        let t859 = dq1.sign();
        let t860 = dq2.sign();
        let t861 = dq3.sign();
        let t862 = dq4.sign();
        let t863 = dq5.sign();
        let t864 = dq6.sign();
        put(50, t845); // row 1, YZ6
        put(53, t859); // row 1, FC1
        put(101, t850); // row 2, YZ6
        put(104, t860); // row 2, FC2
        put(142, t850); // row 3, YZ6
        put(145, t861); // row 3, FC3
        put(171, t855); // row 4, YZ6
        put(174, t862); // row 4, FC4
        put(191, t858); // row 5, YZ6
        put(194, t863); // row 5, FC5
        put(205, t864); // row 6, FC6
    }
}
