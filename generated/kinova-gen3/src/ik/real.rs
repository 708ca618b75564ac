//! Square root and arc tangent: `core` has neither.

use super::super::runtime::square_root;

/// `sqrt(x)`; zero for a negative `x` (a rounding error below a double root).
#[inline(always)]
pub(super) fn root(x: f64) -> f64 {
    if x > 0.0 { square_root(x) } else { 0.0 }
}

/// Tangent of pi/8: beyond it a ratio is turned back by pi/4.
const TAN_PI_8: f64 = 0.414_213_562_373_095_03;
/// The odd polynomial of fdlibm's `s_atan.c`, good to half an ulp up to 7/16.
const A: [f64; 11] = [
    3.333_333_333_333_293e-1,
    -1.999_999_999_987_648_3e-1,
    1.428_571_427_250_346_6e-1,
    -1.111_111_040_546_235_6e-1,
    9.090_887_133_436_507e-2,
    -7.691_876_205_044_83e-2,
    6.661_073_137_387_531e-2,
    -5.833_570_133_790_573_5e-2,
    4.976_877_994_615_932_4e-2,
    -3.653_157_274_421_691_6e-2,
    1.628_582_011_536_578_2e-2,
];

/// Angle of the point `(x, y)`, rad, in `[-pi, pi]`; zero at the origin. Within 2 ulp. No branches: a loop over it runs in the
/// registers' lanes.
#[inline(always)]
pub(super) fn angle(y: f64, x: f64) -> f64 {
    use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
    let (ay, ax) = (y.abs(), x.abs());
    let (low, high) = if ay > ax { (ax, ay) } else { (ay, ax) };
    let steep = low > TAN_PI_8 * high;
    let up = if steep { low - high } else { low };
    let down = if steep { low + high } else { high };
    let t = up / if down > 0.0 { down } else { 1.0 };
    let z = t * t;
    let w = z * z;
    let odd = z * (A[0] + w * (A[2] + w * (A[4] + w * (A[6] + w * (A[8] + w * A[10])))));
    let even = w * (A[1] + w * (A[3] + w * (A[5] + w * (A[7] + w * A[9]))));
    let small = t - t * (odd + even);
    let a = if steep { FRAC_PI_4 } else { 0.0 } + small;
    let a = if ay > ax { FRAC_PI_2 - a } else { a };
    let a = if x < 0.0 { PI - a } else { a };
    if y < 0.0 { -a } else { a }
}

/// Angles of the first points of a list, in fours; what lies beyond them is not looked at.
#[inline(always)]
pub(super) fn angles<const K: usize>(s: &[f64; K], c: &[f64; K], len: usize) -> [f64; K] {
    let mut out = [0.0; K];
    let fours = out.chunks_exact_mut(4).zip(s.chunks_exact(4)).zip(c.chunks_exact(4));
    for ((out, s), c) in fours.take(len.div_ceil(4)) {
        for ((out, s), c) in out.iter_mut().zip(s).zip(c) {
            *out = angle(*s, *c);
        }
    }
    out
}

/// The same direction within a half turn of zero: `(-pi, pi]`.
#[inline]
pub(super) fn wrapped(angle: f64) -> f64 {
    use core::f64::consts::{PI, TAU};
    if angle > PI || angle <= -PI {
        let turned = angle - TAU * whole(angle / TAU);
        if turned <= -PI { turned + TAU } else { turned }
    } else {
        angle
    }
}

/// Nearest whole number, for sizes below 2^51.
#[inline]
pub(super) fn whole(x: f64) -> f64 {
    const ROUND: f64 = 6_755_399_441_055_744.0;
    (x + ROUND) - ROUND
}
