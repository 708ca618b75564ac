//! How far eight branches are from their pose and from the limits, side by side.

use core::f64::consts::{PI, TAU};

use super::super::runtime::Block;
use super::arm::{Arm, fitted};
use super::candidates::Candidates;
use super::pose::Displacement;
use super::real::angle_block;
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

/// Weights of cosine and sine of joint `j` in a branch's mark: any numbers that are not multiples
/// of each other.
#[inline(always)]
pub(super) fn weights(j: usize) -> [f64; 2] {
    [1.0 + 0.37 * j as f64, 0.73 + 0.29 * j as f64]
}

/// Eight branches, of which those count that there are.
pub(super) struct Eight<const N: usize> {
    /// Squares of what is left to the pose, m^2 and (for small angles) rad^2.
    pub ways: [f64; 8],
    pub turns: [f64; 8],
    /// A number that distinguishes branches; infinite where there is none.
    pub marks: [f64; 8],
    /// By joint: positions, rad or m, whole turns chosen.
    pub q: [[f64; 8]; N],
    /// Distance to the nearest limit, rad or m.
    pub margins: [f64; 8],
}

/// Measures the branches from `first` on.
#[inline(always)]
pub(super) fn measured<const N: usize>(
    arm: &Arm<N>,
    g: &Displacement,
    near: Option<&[f64; N]>,
    all: &Candidates<N>,
    first: usize,
) -> Eight<N> {
    let goal: Matrix = transposed(&g.rotation);
    let goal_tip = g.point(arm.home.shift);
    let mut out = Eight {
        ways: [0.0; 8],
        turns: [0.0; 8],
        marks: [f64::INFINITY; 8],
        q: [[0.0; 8]; N],
        margins: [f64::INFINITY; 8],
    };
    for k in 0..Block::COUNT {
        let from = first + k * Block::WIDTH;
        if from >= all.len {
            break;
        }
        let mut tip = splat(arm.home.shift);
        let (mut x, mut y) = (splat(IDENTITY[0]), splat(IDENTITY[1]));
        let (mut mark, mut least) = (Block::constant(0.0), Block::constant(f64::INFINITY));
        for j in (0..N).rev() {
            let axis = &arm.axes[j];
            let (c, s) = all.lanes(j, from);
            let [a, b] = weights(j);
            mark = mark + c * Block::constant(a) + s * Block::constant(b);
            let q = if axis.slides {
                let h = splat(axis.h);
                tip = add(tip, [c * h[0], c * h[1], c * h[2]]);
                c
            } else {
                let at = splat(axis.c);
                tip = add(turned(axis.h, c, s, sub(tip, at)), at);
                x = turned(axis.h, c, s, x);
                y = turned(axis.h, c, s, y);
                angle_block(s, c)
            };
            let (q, margin) = within(q, axis.slides, arm.limits[j]);
            q.store(k, &mut out.q[j]);
            least = least.min(margin);
        }
        let way = sub(tip, splat(goal_tip));
        // A turn by `a` moves the three base vectors by 2 sqrt(2) sin(a/2) together.
        let turn =
            square(sub(x, splat(goal[0]))) + square(sub(y, splat(goal[1]))) + square(sub(cross(x, y), splat(goal[2])));
        square(way).store(k, &mut out.ways);
        (turn * Block::constant(0.5)).store(k, &mut out.turns);
        mark.store(k, &mut out.marks);
        least.store(k, &mut out.margins);
    }
    for (lane, mark) in out.marks.iter_mut().enumerate() {
        if first + lane >= all.len {
            *mark = f64::INFINITY;
        }
    }
    if near.is_some() || arm.winds() {
        fit(arm, near, &mut out);
    }
    out
}

/// The whole turn that respects the limits, and the distance to the nearest one.
#[inline(always)]
fn within(q: Block, slides: bool, limits: Option<[f64; 2]>) -> (Block, Block) {
    let n = Block::constant;
    let Some([low, high]) = limits else { return (q, n(f64::INFINITY)) };
    let (low, high) = (n(low), n(high));
    let margin = |q: Block| (q - low).min(high - q);
    let here = margin(q);
    if slides || !wide(limits) {
        return (q, here);
    }
    let turn = n(TAU).only_where_less(q, low) - n(TAU).only_where_less(high, q);
    let there = margin(q + turn);
    let turn = turn.only_where_less(here, n(-1e-9));
    let q = q + turn.only_where_less(here.max(n(-1e-9)), there);
    (q, margin(q))
}

/// Elsewhere a turned angle is never inside where it was not.
fn wide(limits: Option<[f64; 2]>) -> bool {
    limits.is_some_and(|[low, high]| low < 1e-6 - PI || high > PI - 1e-6)
}

impl<const N: usize> Arm<N> {
    /// May a joint need more than one whole turn to be within its limits?
    #[inline(always)]
    fn winds(&self) -> bool {
        let mut any = false;
        for (axis, limits) in self.axes.iter().zip(&self.limits) {
            let beyond =
                |[low, high]: [f64; 2]| (low > -PI || high < PI) && (low < 1e-6 - 3.0 * PI || high > 3.0 * PI - 1e-6);
            any |= !axis.slides && limits.is_some_and(beyond);
        }
        any
    }
}

/// Whole turns near a posture, or several of them.
#[cold]
#[inline(never)]
fn fit<const N: usize>(arm: &Arm<N>, near: Option<&[f64; N]>, out: &mut Eight<N>) {
    out.margins = [f64::INFINITY; 8];
    for j in 0..N {
        for (q, least) in out.q[j].iter_mut().zip(&mut out.margins) {
            let margin;
            (*q, margin) = fitted(*q, arm.axes[j].slides, arm.limits[j], near.map(|n| n[j]));
            *least = least.min(margin);
        }
    }
}
