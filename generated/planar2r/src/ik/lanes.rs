//! How far eight branches are from their pose, side by side.

use super::super::runtime::{Pack, Scalar};
use super::arm::Arm;
use super::candidates::Candidates;
use super::pose::Displacement;
use super::vector::{IDENTITY, Matrix, Vector, transposed};

type Vectors = [Pack; 3];

#[inline(always)]
fn splat(v: Vector) -> Vectors {
    v.map(Pack::constant)
}

#[inline(always)]
fn sub(a: Vectors, b: Vectors) -> Vectors {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
fn add(a: Vectors, b: Vectors) -> Vectors {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
fn cross(a: Vectors, b: Vectors) -> Vectors {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline(always)]
fn square(a: Vectors) -> Pack {
    a[0] * a[0] + a[1] * a[1] + a[2] * a[2]
}

/// `x` turned about `h`; a turn about a base axis has few products.
#[inline(always)]
fn turned(h: Vector, c: Pack, s: Pack, [x, y, z]: Vectors) -> Vectors {
    if h[2].abs() == 1.0 {
        let s = s * Pack::constant(h[2]);
        [c * x - s * y, s * x + c * y, z]
    } else if h[1].abs() == 1.0 {
        let s = s * Pack::constant(h[1]);
        [c * x + s * z, y, c * z - s * x]
    } else if h[0].abs() == 1.0 {
        let s = s * Pack::constant(h[0]);
        [x, c * y - s * z, s * y + c * z]
    } else {
        let (h, v) = (splat(h), [x, y, z]);
        let a = cross(h, v);
        let b = cross(h, a);
        let k = Pack::constant(1.0) - c;
        core::array::from_fn(|i| v[i] + s * a[i] + k * b[i])
    }
}

/// What cosine and sine of joint `j` count in a branch's mark: any numbers do that are not multiples of each other.
#[inline(always)]
pub(super) fn weights(j: usize) -> [f64; 2] {
    [1.0 + 0.37 * j as f64, 0.73 + 0.29 * j as f64]
}

/// Squares of what is left to `g` in eight branches from `first` on: m^2 and rad^2 (for small angles), and a number that tells
/// branches apart.
#[inline]
pub(super) fn misses<const N: usize>(
    arm: &Arm<N>,
    g: &Displacement,
    all: &Candidates<N>,
    first: usize,
) -> ([f64; 8], [f64; 8], [f64; 8]) {
    let mut tip = splat(arm.home.shift);
    let (mut x, mut y) = (splat(IDENTITY[0]), splat(IDENTITY[1]));
    let mut mark = Pack::constant(0.0);
    for j in (0..N).rev() {
        let axis = &arm.axes[j];
        let (c, s) = all.lanes(j, first);
        let [a, b] = weights(j);
        mark = mark + c * Pack::constant(a) + s * Pack::constant(b);
        if axis.slides {
            tip = core::array::from_fn(|i| tip[i] + c * Pack::constant(axis.h[i]));
        } else {
            let at = splat(axis.c);
            tip = add(turned(axis.h, c, s, sub(tip, at)), at);
            x = turned(axis.h, c, s, x);
            y = turned(axis.h, c, s, y);
        }
    }
    let goal: Matrix = transposed(&g.rotation);
    let way = sub(tip, splat(g.point(arm.home.shift)));
    // A turn by `a` moves the three base vectors by 2 sqrt(2) sin(a/2) together.
    let turn =
        square(sub(x, splat(goal[0]))) + square(sub(y, splat(goal[1]))) + square(sub(cross(x, y), splat(goal[2])));
    (square(way).to_array(), (turn * Pack::constant(0.5)).to_array(), mark.to_array())
}
