//! Regressor `W_b` of the base parameters.
//!
//! `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil
//! and Dombre, 12.4.
//!
//! 337 multiplications, 252 additions; 6 x 37, 121 of 222 structurally nonzero.

use super::super::runtime::{Scalar, apart, clear};
use super::super::{DOF, GRAVITY, Trig, constants};

/// Entries that are not structurally zero.
pub const NONZEROS: usize = 121;

/// Row and column of each of them, in the order of [`packed`].
pub const PATTERN: [(usize, usize); NONZEROS] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9),
    (0, 10), (0, 11), (0, 12), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18), (0, 19),
    (0, 20), (0, 21), (0, 22), (0, 23), (0, 24), (0, 25), (0, 26), (0, 27), (0, 28), (0, 29),
    (0, 30), (0, 31), (0, 32), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7),
    (1, 8), (1, 9), (1, 10), (1, 11), (1, 12), (1, 13), (1, 14), (1, 15), (1, 16), (1, 17),
    (1, 18), (1, 19), (1, 20), (1, 21), (1, 22), (1, 23), (1, 24), (1, 25), (1, 26), (1, 27),
    (1, 28), (1, 29), (1, 30), (1, 31), (1, 32), (2, 8), (2, 9), (2, 10), (2, 11), (2, 12),
    (2, 13), (2, 19), (2, 20), (2, 26), (2, 27), (2, 33), (3, 12), (3, 13), (3, 14), (3, 15),
    (3, 16), (3, 17), (3, 18), (3, 19), (3, 20), (3, 21), (3, 22), (3, 23), (3, 24), (3, 25),
    (3, 26), (3, 27), (3, 28), (3, 29), (3, 30), (3, 31), (3, 32), (3, 34), (4, 19), (4, 20),
    (4, 21), (4, 22), (4, 23), (4, 24), (4, 25), (4, 26), (4, 27), (4, 28), (4, 29), (4, 30),
    (4, 31), (4, 32), (4, 35), (5, 26), (5, 27), (5, 28), (5, 29), (5, 30), (5, 31), (5, 32),
    (5, 36),
];

/// Place of entry `k` in the row-major result.
pub(crate) const fn place(k: usize) -> usize {
    PATTERN[k].0 * 37 + PATTERN[k].1
}

/// Regressor `W_b` of the base parameters: every entry of `out` is written.
#[inline]
pub fn dense<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 37]; 6]) {
    let flat = &mut out.as_flattened_mut()[..];
    entries(trig, dq, ddq, |k, x| {
        flat[place(k)] = x;
        match k {
            32 => clear(&mut flat[33..38]),
            64 => clear(&mut flat[70..82]),
            70 => clear(&mut flat[88..93]),
            72 => clear(&mut flat[95..100]),
            74 => clear(&mut flat[102..107]),
            75 => clear(&mut flat[108..123]),
            96 => flat[144] = S::default(),
            97 => clear(&mut flat[146..167]),
            111 => clear(&mut flat[181..183]),
            112 => clear(&mut flat[184..211]),
            119 => clear(&mut flat[218..221]),
            _ => {}
        }
        apart();
    });
}

/// The same for an `out` that is zero elsewhere already: other entries are not touched.
#[inline]
pub fn nonzeros<S: Scalar>(trig: &Trig<S>, dq: &[S; DOF], ddq: &[S; DOF], out: &mut [[S; 37]; 6]) {
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
    let [_, _, q3, ..] = trig.q;
    let [_, s2, _, s4, s5, s6] = trig.sin;
    let [_, c2, _, c4, c5, c6] = trig.cos;
    let [dq1, dq2, dq3, dq4, dq5, dq6] = *dq;
    let [ddq1, ddq2, ddq3, ddq4, ddq5, ddq6] = *ddq;
    let k1 = S::constant(-GRAVITY[2]);
    let k2 = S::constant(2.0);
    let k_D2 = S::constant(constants::D2);
    let k_D6 = S::constant(constants::D6);
    // link 1: motion
    let t0 = {
        let t0 = dq1 * dq1;
        put(0, ddq1); // row 1, YY1R
        put(35, ddq2); // row 2, YY2R
        put(75, ddq3); // row 3, IA3
        put(97, ddq4); // row 4, IA4
        put(112, ddq5); // row 5, IA5
        put(120, ddq6); // row 6, IA6
        t0
    };
    // joint axes in frame 2
    let [t1, v1_2_y] = {
        let t1 = c2 * k_D2;
        let v1_2_y = s2 * k_D2;
        [t1, v1_2_y]
    };
    // joint axes in frame 4
    let [t3, t4] = {
        let t3 = s4 * t1;
        let t4 = c4 * t1;
        [t3, t4]
    };
    // link 2: motion
    let [
        t8, t10, a2_y, t13, w3_z, t15, t16, t17,
        t18, t20, t21, t23, t24, t25, t26, t27,
        t28,
    ] = {
        let t7 = k_D2 * ddq1;
        let t8 = k_D2 * t0;
        let t10 = s2 * k1 + c2 * t7;
        let a2_y = s2 * t7 - c2 * k1;
        let t13 = s2 * dq1;
        let w3_z = c2 * dq1;
        let t15 = s2 * ddq1;
        let t16 = c2 * ddq1;
        let t17 = t13 * t13;
        let t18 = dq2 * dq2;
        let t19 = t13 * w3_z;
        let t20 = dq2 * t13;
        let t21 = dq2 * w3_z;
        let t23 = t16 - t20;
        let t24 = t19 - ddq2;
        let t25 = ddq2 + t19;
        let t26 = t17 + t18;
        let t27 = t20 - t23;
        let t28 = t21 + (t15 + t21);
        let t29 = -t10;
        let t30 = -t15;
        let t31 = -t25;
        let t32 = -t26;
        put(33, a2_y); // row 2, MSX2
        put(34, t29); // row 2, MSZ2
        put(36, t19); // row 2, ZZ2R
        put(37, t30); // row 2, XY2R
        put(39, t16); // row 2, YZ2R
        put(66, t15); // row 3, MSX3
        put(67, t31); // row 3, MSY3
        put(68, t32); // row 3, MSZ3R
        [
        t8, t10, a2_y, t13, w3_z, t15, t16, t17,
        t18, t20, t21, t23, t24, t25, t26, t27,
        t28,
    ]
    };
    // link 3: motion
    let [t33, t35, t42, a3_y, t44, t46, t47] = {
        let t33 = q3 * t24;
        let t35 = q3 * t28;
        let t39 = dq3 * k2;
        let t42 = t13 * t39 - (t8 - t35);
        let a3_y = dq2 * t39 - (t10 + t33);
        let t44 = a2_y + q3 * t26 - ddq3;
        let t45 = w3_z * w3_z;
        let t46 = t17 + t45;
        let t47 = t18 + t45;
        let t48 = -t44;
        put(65, t48); // row 3, M3R
        [t33, t35, t42, a3_y, t44, t46, t47]
    };
    // MSX2: column
    let t52 = {
        let t52 = t47 * t1 + t25 * v1_2_y;
        let t53 = t52 - c2 * t8;
        put(1, t53); // row 1, MSX2
        t52
    };
    // MSZ2: column
    let t57 = {
        let t57 = t24 * t1 + t26 * v1_2_y;
        let t58 = t57 - s2 * t8;
        put(2, t58); // row 1, MSZ2
        t57
    };
    // YY2: column
    let t59 = {
        let t59 = s2 * t21;
        let t61 = t59 - c2 * t20;
        put(3, t61); // row 1, YY2R
        t59
    };
    // ZZ2: column
    {
        let t63 = c2 * t23 - t59;
        put(4, t63); // row 1, ZZ2R
    }
    // XY2: column
    {
        let t67 = c2 * (t46 - t47) - s2 * t25;
        put(5, t67); // row 1, XY2R
    }
    // XZ2: column
    {
        let t68 = t47 - t26;
        let t71 = s2 * t27 - c2 * t28;
        put(6, t71); // row 1, XZ2R
        put(38, t68); // row 2, XZ2R
    }
    // YZ2: column
    {
        let t75 = s2 * (t46 - t26) - c2 * t24;
        put(7, t75); // row 1, YZ2R
    }
    // M3: column
    {
        let t77 = q3 * a3_y;
        let t82 = s2 * (q3 * t42) - (a3_y * t1 - t44 * v1_2_y);
        put(8, t82); // row 1, M3R
        put(40, t77); // row 2, M3R
    }
    // MSX3: column
    {
        let t84 = q3 * t16;
        let t91 = t16 * t1 + t15 * v1_2_y;
        let t92 = s2 * (q3 * t46 - t44) + c2 * a3_y - t91;
        put(9, t92); // row 1, MSX3
        put(41, t84); // row 2, MSX3
    }
    // MSY3: column
    {
        let t95 = t44 - q3 * t47;
        let t99 = t52 + (c2 * t42 - s2 * (q3 * t27));
        put(10, t99); // row 1, MSY3
        put(42, t95); // row 2, MSY3
    }
    // MSZ3: column
    {
        let t101 = a3_y - t33;
        let t103 = t57 + s2 * (t35 + t42);
        put(11, t103); // row 1, MSZ3R
        put(43, t101); // row 2, MSZ3R
    }
    // link 4: motion
    let [
        t104, t105, t108, a4_y, t114, t117, t120, t123,
        w4_z, dw4_z, t126, t127, t128, t129, t130, dw4_y,
        t133, t134, t135, t136, t137,
    ] = {
        let t104 = s2 * s4;
        let t105 = s2 * c4;
        let t108 = c4 * t42 - s4 * a3_y;
        let a4_y = c4 * a3_y + s4 * t42;
        let t114 = c4 * dq2 + s4 * t13;
        let t117 = c4 * t13 - s4 * dq2;
        let t120 = c4 * t28 + s4 * t24;
        let t123 = c4 * t24 - s4 * t28;
        let w4_z = w3_z + dq4;
        let dw4_z = t23 + ddq4;
        let t126 = t114 * t114;
        let t127 = w4_z * w4_z;
        let t128 = t114 * t117;
        let t129 = t114 * w4_z;
        let t130 = t117 * w4_z;
        let dw4_x = t123 - t130;
        let dw4_y = t129 - t120;
        let t133 = t128 - dw4_z;
        let t134 = dw4_z + t128;
        let t135 = t126 + t127;
        let t136 = t129 + dw4_y;
        let t137 = dw4_x - t130;
        let t138 = -t136;
        let t139 = -t123;
        put(69, t138); // row 3, MSX4
        put(70, t137); // row 3, MSZ4R
        put(76, a4_y); // row 4, MSX4
        put(77, t108); // row 4, MSZ4R
        put(78, dw4_z); // row 4, YY4R
        put(79, t128); // row 4, ZZ4R
        put(80, t139); // row 4, XY4
        put(82, t120); // row 4, YZ4
        [
        t104, t105, t108, a4_y, t114, t117, t120, t123,
        w4_z, dw4_z, t126, t127, t128, t129, t130, dw4_y,
        t133, t134, t135, t136, t137,
    ]
    };
    // MSX4: column
    let [t141, t142, t147, t149, t150] = {
        let t140 = t117 * t117;
        let t141 = t127 + t140;
        let t142 = t126 + t140;
        let t147 = c4 * t134;
        let t148 = t147 - s4 * t141;
        let t149 = s4 * t44;
        let t150 = c4 * t44;
        let t154 = t149 + q3 * t148;
        let t157 = s2 * (q3 * (c4 * t141 + s4 * t134) - t150) + c2 * a4_y;
        let t161 = t157 - (t1 * t148 - t136 * v1_2_y);
        put(12, t161); // row 1, MSX4
        put(44, t154); // row 2, MSX4
        [t141, t142, t147, t149, t150]
    };
    // MSZ4: column
    let t165 = {
        let t165 = s4 * t133;
        let t167 = t165 - c4 * t135;
        let t171 = t150 + q3 * t167;
        let t174 = s2 * (t149 - q3 * (c4 * t133 + s4 * t135)) + c2 * t108;
        let t178 = t174 - (t1 * t167 + t137 * v1_2_y);
        put(13, t178); // row 1, MSZ4R
        put(45, t171); // row 2, MSZ4R
        t165
    };
    // YY4: column
    let [t179, t184] = {
        let t179 = t104 * t130;
        let t183 = c2 * dw4_z - (t105 * t129 - t179);
        let t184 = c4 * t130;
        let t186 = t184 + s4 * t129;
        put(14, t183); // row 1, YY4R
        put(46, t186); // row 2, YY4R
        [t179, t184]
    };
    // ZZ4: column
    {
        let t190 = c2 * t128 - (t179 + t105 * dw4_y);
        let t192 = s4 * dw4_y - t184;
        put(15, t190); // row 1, ZZ4R
        put(47, t192); // row 2, ZZ4R
    }
    // XY4: column
    {
        let t193 = t142 - t141;
        let t198 = t104 * t134 - t105 * t193 - c2 * t123;
        let t200 = t147 + s4 * t193;
        put(16, t198); // row 1, XY4
        put(48, t200); // row 2, XY4
    }
    // XZ4: column
    {
        let t201 = t135 - t141;
        let t206 = c2 * t201 - (t104 * t136 + t105 * t137);
        let t209 = s4 * t137 - c4 * t136;
        put(17, t206); // row 1, XZ4
        put(49, t209); // row 2, XZ4
        put(81, t201); // row 4, XZ4
    }
    // YZ4: column
    {
        let t210 = t142 - t135;
        let t215 = c2 * t120 + (t104 * t210 - t105 * t133);
        let t217 = t165 + c4 * t210;
        put(18, t215); // row 1, YZ4
        put(50, t217); // row 2, YZ4
    }
    // link 5: motion
    let [
        a5_x, a5_y, t226, t229, t232, t235, w5_z, dw5_z,
        t238, t239, t240, t241, t242, t244, t245, t246,
        t247, t248, t249,
    ] = {
        let a5_x = s5 * t44 - c5 * t108;
        let a5_y = c5 * t44 + s5 * t108;
        let t226 = c5 * t114 + s5 * w4_z;
        let t229 = c5 * w4_z - s5 * t114;
        let t232 = s5 * t137 - c5 * t133;
        let t235 = c5 * t137 + s5 * t133;
        let w5_z = dq5 - t117;
        let dw5_z = dw4_y + ddq5;
        let t238 = t226 * t226;
        let t239 = w5_z * w5_z;
        let t240 = t226 * t229;
        let t241 = t226 * w5_z;
        let t242 = t229 * w5_z;
        let dw5_x = t235 - t242;
        let t244 = t232 - t241;
        let t245 = t240 - dw5_z;
        let t246 = dw5_z + t240;
        let t247 = t238 + t239;
        let t248 = t244 - t241;
        let t249 = dw5_x - t242;
        put(98, a5_y); // row 5, MSX5
        put(99, a5_x); // row 5, MSZ5R
        put(100, dw5_z); // row 5, YY5R
        put(101, t240); // row 5, ZZ5R
        put(102, t235); // row 5, XY5
        put(104, t232); // row 5, YZ5
        [
        a5_x, a5_y, t226, t229, t232, t235, w5_z, dw5_z,
        t238, t239, t240, t241, t242, t244, t245, t246,
        t247, t248, t249,
    ]
    };
    // MSX5: column
    let [t251, t252, t254, t257, t259, t260] = {
        let t250 = t229 * t229;
        let t251 = t239 + t250;
        let t252 = t238 + t250;
        let t254 = s5 * t246;
        let t255 = c5 * t251 + t254;
        let t257 = c5 * t246;
        let t258 = s5 * t251 - t257;
        let t259 = s5 * a4_y;
        let t260 = c5 * a4_y;
        let t263 = q3 * t248 - t259;
        let t264 = q3 * t255 - a5_y;
        let t274 = t3 * t255 - t248 * t4 - v1_2_y * t258;
        let t275 = c2 * t260 + (t104 * t263 + t105 * t264) + t274;
        let t278 = c4 * t263 - s4 * t264;
        put(19, t275); // row 1, MSX5
        put(51, t278); // row 2, MSX5
        put(71, t258); // row 3, MSX5
        put(83, t260); // row 4, MSX5
        put(84, t259); // row 4, MSZ5R
        [t251, t252, t254, t257, t259, t260]
    };
    // MSZ5: column
    let [t279, t282] = {
        let t279 = c5 * t245;
        let t281 = t279 + s5 * t247;
        let t282 = s5 * t245;
        let t284 = t282 - c5 * t247;
        let t287 = t260 - q3 * t249;
        let t288 = a5_x - q3 * t281;
        let t298 = v1_2_y * t284 - (t3 * t281 + t249 * t4);
        let t299 = c2 * t259 + (t104 * t287 - t105 * t288) - t298;
        let t302 = c4 * t287 + s4 * t288;
        put(20, t299); // row 1, MSZ5R
        put(52, t302); // row 2, MSZ5R
        put(72, t284); // row 3, MSZ5R
        [t279, t282]
    };
    // YY5: column
    let [t303, t306] = {
        let t303 = c5 * t242;
        let t305 = t303 + s5 * t241;
        let t306 = s5 * t242;
        let t308 = t306 - c5 * t241;
        let t313 = c2 * t308 - (t105 * dw5_z - t104 * t305);
        let t316 = c4 * t305 + s4 * dw5_z;
        put(21, t313); // row 1, YY5R
        put(53, t316); // row 2, YY5R
        put(85, t308); // row 4, YY5R
        [t303, t306]
    };
    // ZZ5: column
    {
        let t318 = t303 + s5 * t244;
        let t320 = c5 * t244 - t306;
        let t325 = c2 * t320 - (t104 * t318 + t105 * t240);
        let t328 = s4 * t240 - c4 * t318;
        put(22, t325); // row 1, ZZ5R
        put(54, t328); // row 2, ZZ5R
        put(86, t320); // row 4, ZZ5R
    }
    // XY5: column
    {
        let t329 = t252 - t251;
        let t331 = t257 + s5 * t329;
        let t333 = c5 * t329 - t254;
        let t338 = c2 * t333 - (t104 * t331 + t105 * t235);
        let t341 = s4 * t235 - c4 * t331;
        put(23, t338); // row 1, XY5
        put(55, t341); // row 2, XY5
        put(87, t333); // row 4, XY5
    }
    // XZ5: column
    {
        let t342 = t251 - t247;
        let t345 = c5 * t248 + s5 * t249;
        let t348 = c5 * t249 - s5 * t248;
        let t353 = c2 * t348 - (t104 * t345 + t105 * t342);
        let t356 = s4 * t342 - c4 * t345;
        put(24, t353); // row 1, XZ5
        put(56, t356); // row 2, XZ5
        put(88, t348); // row 4, XZ5
        put(103, t342); // row 5, XZ5
    }
    // link 6: motion
    let [
        t361, t365, a6_y, t377, t380, dw6_z, t385, t386,
        t387, dw6_x, t390, t391, t392, t393, t394, t395,
        t396,
    ] = {
        let t360 = k_D6 * t245 - a5_x;
        let t361 = a5_y + k_D6 * t247;
        let t362 = a4_y - k_D6 * t249;
        let t365 = c6 * t360 - s6 * t362;
        let a6_y = c6 * t362 + s6 * t360;
        let t371 = c6 * t226 - s6 * w5_z;
        let w6_y = c6 * w5_z + s6 * t226;
        let t377 = c6 * t245 + s6 * t249;
        let t380 = c6 * t249 - s6 * t245;
        let w6_z = t229 + dq6;
        let dw6_z = t244 + ddq6;
        let t383 = t371 * t371;
        let t384 = w6_z * w6_z;
        let t385 = t371 * w6_y;
        let t386 = t371 * w6_z;
        let t387 = w6_y * w6_z;
        let dw6_x = t380 + t387;
        let t390 = t383 - t384;
        let t391 = t390 - t247;
        let t392 = dw6_z + t385;
        let t393 = dw6_z - t385;
        let t394 = t383 + t384;
        let t395 = t377 - t386 - t386;
        let t396 = t387 + dw6_x;
        let t397 = -t377;
        put(113, a6_y); // row 6, MSX6
        put(114, t365); // row 6, MSY6
        put(115, t385); // row 6, XX6R
        put(116, dw6_z); // row 6, ZZ6
        put(118, t380); // row 6, XZ6
        put(119, t397); // row 6, YZ6
        [
        t361, t365, a6_y, t377, t380, dw6_z, t385, t386,
        t387, dw6_x, t390, t391, t392, t393, t394, t395,
        t396,
    ]
    };
    // YZ5: column
    {
        let t398 = t252 - t247;
        let t400 = t282 + c5 * t398;
        let t402 = s5 * t398 - t279;
        let t407 = c2 * t402 + (t104 * t400 - t105 * t232);
        let t410 = c4 * t400 + s4 * t232;
        put(25, t407); // row 1, YZ5
        put(57, t410); // row 2, YZ5
        put(89, t402); // row 4, YZ5
    }
    // MSX6: column
    let [t412, t415, t417, t418] = {
        let t412 = s6 * t393;
        let t413 = t412 - c6 * t391;
        let t415 = c6 * t393;
        let t416 = s6 * t391 + t415;
        let t417 = s6 * t361;
        let t418 = c6 * t361;
        let t421 = t417 + k_D6 * t416;
        let t422 = t418 - k_D6 * t413;
        let t425 = c5 * t413 - s5 * t395;
        let t428 = s5 * t413 + c5 * t395;
        let t434 = s5 * t421 + c5 * a6_y;
        let t437 = c5 * t421 - s5 * a6_y + q3 * t416;
        let t438 = t422 - q3 * t425;
        let t448 = v1_2_y * t428 - (t3 * t425 - t4 * t416);
        let t449 = c2 * t434 + (t104 * t437 - t105 * t438) - t448;
        let t452 = c4 * t437 + s4 * t438;
        put(26, t449); // row 1, MSX6
        put(58, t452); // row 2, MSX6
        put(73, t428); // row 3, MSX6
        put(90, t434); // row 4, MSX6
        put(105, t422); // row 5, MSX6
        [t412, t415, t417, t418]
    };
    // MSY6: column
    let [t453, t456] = {
        let t453 = c6 * t392;
        let t455 = s6 * t394 - t453;
        let t456 = s6 * t392;
        let t458 = t456 + c6 * t394;
        let t461 = t418 - k_D6 * t458;
        let t462 = k_D6 * t455 - t417;
        let t465 = c5 * t455 + s5 * t396;
        let t468 = c5 * t396 - s5 * t455;
        let t474 = s5 * t461 + c5 * t365;
        let t477 = s5 * t365 - c5 * t461 + q3 * t458;
        let t478 = t462 + q3 * t465;
        let t488 = t4 * t458 - t3 * t465 - v1_2_y * t468;
        let t489 = c2 * t474 - (t104 * t477 + t105 * t478) + t488;
        let t492 = s4 * t478 - c4 * t477;
        put(27, t489); // row 1, MSY6
        put(59, t492); // row 2, MSY6
        put(74, t468); // row 3, MSY6
        put(91, t474); // row 4, MSY6
        put(106, t462); // row 5, MSY6
        [t453, t456]
    };
    // XX6: column
    let [t494, t497] = {
        let t494 = s6 * t386;
        let t495 = c6 * dw6_x + t494;
        let t497 = c6 * t386;
        let t498 = s6 * dw6_x - t497;
        let t501 = c5 * t495 + s5 * t385;
        let t504 = c5 * t385 - s5 * t495;
        let t509 = c2 * t504 - (t104 * t501 + t105 * t498);
        let t512 = s4 * t498 - c4 * t501;
        put(28, t509); // row 1, XX6R
        put(60, t512); // row 2, XX6R
        put(92, t504); // row 4, XX6R
        put(107, t498); // row 5, XX6R
        [t494, t497]
    };
    // ZZ6: column
    {
        let t514 = c6 * t387 - t494;
        let t516 = t497 + s6 * t387;
        let t519 = c5 * t514 + s5 * dw6_z;
        let t522 = c5 * dw6_z - s5 * t514;
        let t527 = c2 * t522 - (t104 * t519 + t105 * t516);
        let t530 = s4 * t516 - c4 * t519;
        put(29, t527); // row 1, ZZ6
        put(61, t530); // row 2, ZZ6
        put(93, t522); // row 4, ZZ6
        put(108, t516); // row 5, ZZ6
    }
    // XY6: column
    {
        let t531 = t391 + t394;
        let t534 = c6 * t395 + s6 * t396;
        let t537 = c6 * t396 - s6 * t395;
        let t540 = s5 * t531 - c5 * t534;
        let t543 = s5 * t534 + c5 * t531;
        let t548 = c2 * t543 - (t104 * t540 + t105 * t537);
        let t551 = s4 * t537 - c4 * t540;
        put(30, t548); // row 1, XY6
        put(62, t551); // row 2, XY6
        put(94, t543); // row 4, XY6
        put(109, t537); // row 5, XY6
        put(117, t531); // row 6, XY6
    }
    // XZ6: column
    {
        let t553 = t415 + s6 * t390;
        let t555 = t412 - c6 * t390;
        let t558 = c5 * t553 + s5 * t380;
        let t561 = c5 * t380 - s5 * t553;
        let t566 = c2 * t561 - (t104 * t558 + t105 * t555);
        let t569 = s4 * t555 - c4 * t558;
        put(31, t566); // row 1, XZ6
        put(63, t569); // row 2, XZ6
        put(95, t561); // row 4, XZ6
        put(110, t555); // row 5, XZ6
    }
    // YZ6: column
    {
        let t570 = t247 - t394;
        let t572 = t456 - c6 * t570;
        let t574 = t453 + s6 * t570;
        let t577 = c5 * t572 + s5 * t377;
        let t580 = s5 * t572 - c5 * t377;
        let t585 = c2 * t580 - (t105 * t574 - t104 * t577);
        let t588 = c4 * t577 + s4 * t574;
        put(32, t585); // row 1, YZ6
        put(64, t588); // row 2, YZ6
        put(96, t580); // row 4, YZ6
        put(111, t574); // row 5, YZ6
    }
}
