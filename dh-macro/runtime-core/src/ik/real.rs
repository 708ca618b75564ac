//! Square root and arc tangent: `core` has neither.

use super::super::runtime::{Block, square_root};

/// `sqrt(x)`; zero for a negative `x` (a rounding error below a double root). NaN stays: an error
/// must not look like none.
#[inline(always)]
pub(super) fn root(x: f64) -> f64 {
    if x <= 0.0 { 0.0 } else { square_root(x) }
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

/// Angle of the point `(x, y)`, rad, in `[-pi, pi]`; zero at the origin. Within 2 ulp.
#[inline(always)]
pub(super) fn angle(y: f64, x: f64) -> f64 {
    let mut out = [0.0; Block::WIDTH];
    angle_block(Block::constant(y), Block::constant(x)).put(&mut out);
    out[0]
}

/// Of the points of a block.
#[inline(always)]
pub(super) fn angle_block(y: Block, x: Block) -> Block {
    use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
    let n = Block::constant;
    let (ay, ax) = (y.abs(), x.abs());
    let (low, high) = (ay.min(ax), ay.max(ax));
    let limit = n(TAN_PI_8) * high;
    // Steep, where limit < low.
    let up = low - high.only_where_less(limit, low);
    let down = high + low.only_where_less(limit, low);
    let t = up / down.max(n(f64::MIN_POSITIVE));
    let z = t * t;
    let w = z * z;
    let odd = z * (n(A[0]) + w * (n(A[2]) + w * (n(A[4]) + w * (n(A[6]) + w * (n(A[8]) + w * n(A[10]))))));
    let even = w * (n(A[1]) + w * (n(A[3]) + w * (n(A[5]) + w * (n(A[7]) + w * n(A[9])))));
    let small = t - t * (odd + even);
    let a = n(FRAC_PI_4).only_where_less(limit, low) + small;
    let a = n(FRAC_PI_2).only_where_less(ax, ay) + a.negative_where_less(ax, ay);
    let a = n(PI).only_where_less(x, n(0.0)) + a.negative_where_less(x, n(0.0));
    a.negative_where_less(y, n(0.0))
}

/// Angles of the first points of a list, block by block; what lies beyond them is not looked at.
#[inline(always)]
pub(super) fn angles<const K: usize>(s: &[f64; K], c: &[f64; K], len: usize) -> [f64; K] {
    const WIDTH: usize = Block::WIDTH;
    let mut angles = [0.0; K];
    // Arrays, so that no index is checked.
    let (out, s, c) = (angles.as_chunks_mut::<WIDTH>().0, s.as_chunks::<WIDTH>().0, c.as_chunks::<WIDTH>().0);
    for ((out, s), c) in out.iter_mut().zip(s).zip(c).take(len.div_ceil(WIDTH)) {
        angle_block(Block::from_fn(|l| s[l]), Block::from_fn(|l| c[l])).put(out);
    }
    angles
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
