//! Six joints of which two or three slide: turns first, as slides don't change directions.
//!
//! Three turns make a rotation in two ways, by the square root of the spherical triangle. Three
//! slides are linear in what is left: two postures. With two slides one more turn is hidden: where it
//! is given, what is left must lie in the plane of the slides. That condition for either sign of the
//! root, multiplied, is a trigonometric polynomial in the hidden angle, of degree four but for a
//! factor that the denominators leave.

use super::axis::Value;
use super::elimination::{Loop, Posture};
use super::harmonics::Complex;
use super::pose::Displacement;
use super::real::root;
use super::vector::{Turn, Vector, cross, dot, times, transposed_times};

/// Of the polynomial.
pub(super) const DEGREE: usize = 4;

/// Cosine and sine, of a complex angle where the spherical triangle does not close.
type Spin = (Complex, Complex);
type Point = [Complex; 3];

fn real(x: f64) -> Complex {
    Complex { re: x, im: 0.0 }
}

fn along(a: Vector, b: &Point) -> Complex {
    b[0].times(a[0]).plus(b[1].times(a[1])).plus(b[2].times(a[2]))
}

fn inner(a: &Point, b: &Point) -> Complex {
    a[0].by(b[0]).plus(a[1].by(b[1])).plus(a[2].by(b[2]))
}

fn outer(a: &Point, b: &Point) -> Point {
    let minor = |i: usize, j: usize| a[i].by(b[j]).minus(a[j].by(b[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

fn minus(a: &Point, b: &Point) -> Point {
    [a[0].minus(b[0]), a[1].minus(b[1]), a[2].minus(b[2])]
}

/// Rodrigues.
fn spun(h: Vector, (c, s): Spin, v: &Point) -> Point {
    let part = along(h, v);
    let across = outer(&h.map(real), v);
    let mut out = *v;
    for k in 0..3 {
        let stays = part.times(h[k]);
        out[k] = stays.plus(c.by(v[k].minus(stays))).plus(s.by(across[k]));
    }
    out
}

/// A loop by the kinds of its joints.
pub(super) struct Slides<'a> {
    round: &'a Loop,
    /// The turns that make the rotation.
    turns: [usize; 3],
    /// The slides, in order; with two of them the first turn of the loop is hidden.
    slides: [usize; 3],
    /// How many.
    len: usize,
}

/// What a hidden angle and a sign lead to.
struct Closed {
    spins: [Spin; 3],
    /// Directions of the slides.
    ways: [Point; 3],
    /// What the slides must do.
    left: Point,
}

impl<'a> Slides<'a> {
    /// `None` where other numbers of joints slide, or the first joint of two slides does.
    pub fn new(round: &'a Loop) -> Option<Self> {
        let count = round.axes.iter().filter(|a| a.slides).count();
        let hides = count == 2;
        if !(hides && !round.axes[0].slides || count == 3) {
            return None;
        }
        let (mut turns, mut slides) = ([0; 3], [0; 3]);
        let (mut t, mut s) = (0, 0);
        for (k, axis) in round.axes.iter().enumerate().skip(usize::from(hides)) {
            let (list, at) = if axis.slides { (&mut slides, &mut s) } else { (&mut turns, &mut t) };
            if let Some(place) = list.get_mut(*at) {
                *place = k;
            }
            *at += 1;
        }
        Some(Self { round, turns, slides, len: count })
    }

    /// Is one turn hidden? Else there are two postures at most, without a polynomial.
    pub fn hides(&self) -> bool {
        self.len == 2
    }

    fn axis(&self, k: usize) -> &super::axis::Axis {
        self.round.axes.get(k).unwrap_or(&self.round.axes[0])
    }

    /// Where the pose is from behind the hidden turn.
    fn goal(&self, hidden: Turn) -> Displacement {
        if !self.hides() {
            return self.round.pose;
        }
        self.round.axes[0].displacement(Value::turn(hidden.back())).after(&self.round.pose)
    }

    /// The turns and what they leave, and the denominator of the outer turns.
    fn closed(&self, goal: &Displacement, sign: f64) -> (Closed, f64) {
        let [a, b, c] = self.turns.map(|k| self.axis(k).h);
        let (v, z) = (times(&goal.rotation, c), transposed_times(&goal.rotation, a));
        let between = dot(a, v);
        let fixed = dot(a, b) * dot(b, c);
        let (by_cosine, by_sine) = (dot(a, c) - fixed, dot(a, cross(b, c)));
        let reach = (by_cosine * by_cosine + by_sine * by_sine).max(1e-150);
        let wanted = between - fixed;
        let square = reach - wanted * wanted;
        let size = sign * root(square.abs());
        let sine = if square < 0.0 { Complex { re: 0.0, im: size } } else { real(size) };
        let middle = (
            real(by_cosine * wanted).minus(sine.times(by_sine)).times(1.0 / reach),
            real(by_sine * wanted).plus(sine.times(by_cosine)).times(1.0 / reach),
        );
        let back = (middle.0, middle.1.times(-1.0));
        let (u, w) = (spun(b, middle, &c.map(real)), spun(b, back, &a.map(real)));
        let gap = 1.0 / (1.0 - between * between).max(1e-150);
        let from = |h: Vector, x: &Point, y: &Point| {
            (inner(x, y).minus(real(between * between)).times(gap), along(h, &outer(x, y)).times(gap))
        };
        let spins = [from(a, &u, &v.map(real)), middle, from(c, &z.map(real), &w)];
        let mut here = [Complex::ZERO; 3];
        let mut ways = [[Complex::ZERO; 3]; 3];
        for k in (usize::from(self.hides())..6).rev() {
            let axis = self.axis(k);
            let Some((_, spin)) = self.turns.iter().zip(&spins).find(|(turn, _)| **turn == k) else {
                for (way, _) in ways.iter_mut().zip(self.slides).filter(|(_, slide)| *slide == k) {
                    *way = axis.h.map(real);
                }
                continue;
            };
            let foot = axis.c.map(real);
            let moved = spun(axis.h, *spin, &minus(&here, &foot));
            for i in 0..3 {
                here[i] = foot[i].plus(moved[i]);
            }
            ways = [0, 1, 2].map(|s| spun(axis.h, *spin, &ways[s]));
        }
        let left = minus(&goal.shift.map(real), &here);
        if self.hides() {
            ways[2] = outer(&ways[0], &ways[1]);
        }
        (Closed { spins, ways, left }, 1.0 - between * between)
    }

    /// The trigonometric polynomial in the hidden angle.
    pub fn polynomial(&self, hidden: Turn) -> f64 {
        let goal = self.goal(hidden);
        let [(one, gap), (two, _)] = [1.0, -1.0].map(|sign| self.closed(&goal, sign));
        let of = |closed: &Closed| inner(&closed.ways[2], &closed.left);
        of(&one).by(of(&two)).re * gap
    }

    /// The posture of a hidden angle and a sign.
    pub fn posture(&self, hidden: Turn, sign: f64) -> Posture {
        let (closed, _) = self.closed(&self.goal(hidden), sign);
        let mut v = [Value::ZERO; 6];
        if self.hides() {
            v[0] = Value::turn(hidden);
        }
        for (k, (c, s)) in self.turns.into_iter().zip(closed.spins) {
            if let Some(place) = v.get_mut(k) {
                *place = Value::turn(Turn::along(c.re, s.re).0);
            }
        }
        let [a, b, c] = closed.ways;
        let other = |x: &Point, y: &Point, z: &Point| {
            let normal = outer(y, z);
            inner(&closed.left, &normal).by(inner(x, &normal).reciprocal()).re
        };
        let ways = [other(&a, &b, &c), other(&b, &c, &a), other(&c, &a, &b)];
        for (k, way) in self.slides.into_iter().zip(ways).take(self.len) {
            if let Some(place) = v.get_mut(k) {
                *place = Value::way(if way.abs() < 1e100 { way } else { 0.0 });
            }
        }
        v
    }
}
