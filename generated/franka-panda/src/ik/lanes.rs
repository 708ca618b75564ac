//! How far eight branches are from their pose, side by side.

use super::super::runtime::Block;
use super::arm::Arm;
use super::candidates::Candidates;
use super::pose::Displacement;
use super::vector::{IDENTITY, Matrix, Vector, transposed};

type Vectors = [Block; 3];

#[inline(always)]
fn splat(v: Vector) -> Vectors {
    [Block::constant(v[0]), Block::constant(v[1]), Block::constant(v[2])]
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
fn square(a: Vectors) -> Block {
    a[0] * a[0] + a[1] * a[1] + a[2] * a[2]
}

/// `x` turned about `h`; a turn about a base axis has few products.
#[inline(always)]
fn turned(h: Vector, c: Block, s: Block, [x, y, z]: Vectors) -> Vectors {
    if h[2].abs() == 1.0 {
        let s = s * Block::constant(h[2]);
        [c * x - s * y, s * x + c * y, z]
    } else if h[1].abs() == 1.0 {
        let s = s * Block::constant(h[1]);
        [c * x + s * z, y, c * z - s * x]
    } else if h[0].abs() == 1.0 {
        let s = s * Block::constant(h[0]);
        [x, c * y - s * z, s * y + c * z]
    } else {
        let (h, v) = (splat(h), [x, y, z]);
        let a = cross(h, v);
        let b = cross(h, a);
        let k = Block::constant(1.0) - c;
        [v[0] + s * a[0] + k * b[0], v[1] + s * a[1] + k * b[1], v[2] + s * a[2] + k * b[2]]
    }
}

/// What cosine and sine of joint `j` count in a branch's mark: any numbers do that are not multiples of each other.
#[inline(always)]
pub(super) fn weights(j: usize) -> [f64; 2] {
    [1.0 + 0.37 * j as f64, 0.73 + 0.29 * j as f64]
}

/// Squares of what is left to `g` in eight branches from `first` on (those that there are): m^2 and rad^2 (for small angles), and a
/// number that tells branches apart.
#[inline(always)]
pub(super) fn misses<const N: usize>(
    arm: &Arm<N>,
    g: &Displacement,
    all: &Candidates<N>,
    first: usize,
) -> ([f64; 8], [f64; 8], [f64; 8]) {
    let goal: Matrix = transposed(&g.rotation);
    let goal_tip = g.point(arm.home.shift);
    let (mut ways, mut turns, mut marks) = ([0.0; 8], [0.0; 8], [0.0; 8]);
    for k in 0..Block::COUNT {
        let from = first + k * Block::WIDTH;
        if from >= all.len {
            break;
        }
        let mut tip = splat(arm.home.shift);
        let (mut x, mut y) = (splat(IDENTITY[0]), splat(IDENTITY[1]));
        let mut mark = Block::constant(0.0);
        for j in (0..N).rev() {
            let axis = &arm.axes[j];
            let (c, s) = all.lanes(j, from);
            let [a, b] = weights(j);
            mark = mark + c * Block::constant(a) + s * Block::constant(b);
            if axis.slides {
                let h = splat(axis.h);
                tip = add(tip, [c * h[0], c * h[1], c * h[2]]);
            } else {
                let at = splat(axis.c);
                tip = add(turned(axis.h, c, s, sub(tip, at)), at);
                x = turned(axis.h, c, s, x);
                y = turned(axis.h, c, s, y);
            }
        }
        let way = sub(tip, splat(goal_tip));
        // A turn by `a` moves the three base vectors by 2 sqrt(2) sin(a/2) together.
        let turn =
            square(sub(x, splat(goal[0]))) + square(sub(y, splat(goal[1]))) + square(sub(cross(x, y), splat(goal[2])));
        square(way).store(k, &mut ways);
        (turn * Block::constant(0.5)).store(k, &mut turns);
        mark.store(k, &mut marks);
    }
    (ways, turns, marks)
}
