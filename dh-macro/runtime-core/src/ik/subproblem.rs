//! Canonical subproblems (Paden 1986, Kahan 1983; Murray, Li and Sastry, 3.3), written so that a
//! double root costs no accuracy that the data have.

use super::axis::Axis;
use super::real::root;
use super::vector::{Turn, Vector, add, cross, dot, norm, scale, sub};

/// Below this sine an angle hangs on the last digits of the pose: it is reported as free.
pub(super) const FREE: f64 = 1e-6;

/// Below this sine an answer is worth a second look: several of them multiply.
pub(super) const NARROW: f64 = 1e-3;

/// Bit of a branch's free joints: some sine is [`NARROW`].
pub(super) const DOUBT: u8 = 128;

/// [`DOUBT`] where it is so.
#[inline(always)]
pub(super) fn doubt(narrow: bool) -> u8 {
    u8::from(narrow) << 7
}

/// Two answers, the second first where the sign is minus; equal at a double root.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pair {
    /// With the plus and with the minus sign.
    pub both: [Turn; 2],
    /// Every angle is an answer, or nearly so.
    pub free: bool,
    /// The data say nothing at all: the two turns are none.
    pub blind: bool,
    /// Nearly a double root, or nearly free.
    pub narrow: bool,
}

/// The turn about `h` that takes `from` nearest to `to`, and how well it is known (product of their
/// distances from `h`).
#[inline(always)]
pub(super) fn towards(h: Vector, from: Vector, to: Vector) -> (Turn, f64) {
    // Across the axis first: beside it, products of the whole vectors would be all rounding.
    let (f, t) = (cross(h, from), cross(h, to));
    Turn::along(dot(f, t), dot(h, cross(f, t)))
}

/// The same where both stand square to `h` and have length one, but for rounding: no root is
/// needed.
#[inline(always)]
pub(super) fn across(h: Vector, from: Vector, to: Vector) -> Turn {
    Turn { c: dot(from, to), s: dot(h, cross(from, to)) }
}

/// `a cos + b sin = d`. Where there is no answer, the nearest one twice.
#[inline(always)]
pub(super) fn circle(a: f64, b: f64, d: f64, size: f64) -> Pair {
    Circle::new(a, b, size).at(d)
}

/// The part of [`circle`] that does not change with `d`.
struct Circle {
    /// The direction `(a, b)`.
    middle: Turn,
    r: f64,
    per: f64,
    size: f64,
}

impl Circle {
    #[inline(always)]
    fn new(a: f64, b: f64, size: f64) -> Self {
        let r = root(a * a + b * b);
        let per = 1.0 / r;
        Self { middle: Turn { c: a * per, s: b * per }, r, per, size }
    }

    #[inline(always)]
    fn at(&self, d: f64) -> Pair {
        self.between(d, [self.r + d, self.r - d])
    }

    /// For `d` whose distances from the two ends, `r + d` and `r - d`, are known by themselves:
    /// beside an end they have digits that `d` has lost.
    #[inline(always)]
    fn between(&self, d: f64, [above, below]: [f64; 2]) -> Pair {
        let &Self { middle, r, per, size } = self;
        if !(r > 1e-14 * size) {
            return BLIND;
        }
        // A goal out of reach is not in doubt.
        let reached = d.abs() < r + NARROW * size;
        let d = if below < 0.0 {
            r
        } else if above < 0.0 {
            -r
        } else {
            d
        };
        let w = root(above.max(0.0) * below.max(0.0));
        let (c, s) = (d * per, w * per);
        Pair {
            both: [middle.then(Turn { c, s }), middle.then(Turn { c, s: -s })],
            free: r < FREE * size,
            blind: false,
            narrow: reached & (w < NARROW * size),
        }
    }
}

/// Turns of `axis` that bring `w` to the distance `length` from `x`.
#[inline(always)]
pub(super) fn reach(axis: &Axis, w: Vector, x: Vector, length2: f64) -> Pair {
    Reach::new(axis, w, x).at(length2)
}

/// The part of [`reach`] that does not change with the distance.
pub(super) struct Reach {
    circle: Circle,
    /// Squared distance in the middle, at its minimum and at its maximum.
    middle: f64,
    ends: [f64; 2],
}

impl Reach {
    #[inline(always)]
    pub(super) fn new(axis: &Axis, w: Vector, x: Vector) -> Self {
        let rel = sub(w, axis.c);
        let along = dot(axis.h, rel);
        let k = sub(add(axis.c, scale(along, axis.h)), x);
        // Heron: the two distances from the axis and the height between them, so that a stretched
        // arm keeps its digits.
        let height = dot(axis.h, k);
        let k_across = sub(k, scale(height, axis.h));
        let across = sub(rel, scale(along, axis.h));
        let a = 2.0 * dot(k_across, across);
        let b = 2.0 * dot(k_across, cross(axis.h, across));
        let (k2, w2) = (dot(k_across, k_across), dot(across, across));
        let (h2, k, w) = (height * height, root(k2), root(w2));
        let ends = [h2 + (k - w) * (k - w), h2 + (k + w) * (k + w)];
        Self { circle: Circle::new(a, b, k2 + w2 + h2), middle: h2 + k2 + w2, ends }
    }

    #[inline(always)]
    pub(super) fn at(&self, length2: f64) -> Pair {
        let [least, most] = self.ends;
        self.circle.between(length2 - self.middle, [length2 - least, most - length2])
    }
}

/// Turns of `second` for which `R(first) R(second) w` can point along `p`: `first . R(second) w =
/// first . p` for directions that need not have the same length. By half angles of the spherical
/// triangle, so that the sine of a small answer is exact.
#[inline(always)]
pub(super) fn tilt(first: Vector, second: Vector, w: Vector, p: Vector) -> Pair {
    Tilt::new(first, second, w).towards(p)
}

/// The part of [`tilt`] that does not change with `p`.
pub(super) struct Tilt {
    first: Vector,
    /// Cosine and sine of the difference and of the sum of the sides at the vertex `second`.
    difference: [f64; 2],
    sum: [f64; 2],
    /// The turn that brings `w` nearest to `first`.
    middle: Turn,
    blind: bool,
    free: bool,
}

const BLIND: Pair = Pair { both: [Turn::NONE; 2], free: true, blind: true, narrow: true };

impl Tilt {
    #[inline(always)]
    pub(super) fn new(first: Vector, second: Vector, w: Vector) -> Self {
        let wn = norm(w);
        let (ca, sa) = (dot(first, second), norm(cross(first, second)));
        let (cb, sb) = (dot(second, w) / wn, norm(cross(second, w)) / wn);
        let (middle, known) = towards(second, w, first);
        Self {
            first,
            difference: [ca * cb + sa * sb, sa * cb - ca * sb],
            sum: [ca * cb - sa * sb, sa * cb + ca * sb],
            middle,
            blind: !(wn > 1e-150) || !(known > 1e-14 * wn),
            free: known < FREE * wn,
        }
    }

    #[inline(always)]
    pub(super) fn towards(&self, p: Vector) -> Pair {
        let pn = norm(p);
        if !(pn > 1e-150) {
            return BLIND;
        }
        self.towards_unit(scale(1.0 / pn, p))
    }

    /// The same for a direction of length one.
    #[inline(always)]
    pub(super) fn towards_unit(&self, p: Vector) -> Pair {
        if self.blind {
            return BLIND;
        }
        let (cg, sg) = (dot(self.first, p), norm(cross(self.first, p)));
        // x = cos(difference) - cos(gamma), y = cos(gamma) - cos(sum); near 0 and pi by products of
        // sines.
        let unlike = |[c, s]: [f64; 2]| {
            let sum = c + cg;
            if sum.abs() > 1.0 { (sg * c - cg * s) * (sg * c + cg * s) / sum } else { c - cg }
        };
        let (x, y) = (unlike(self.difference), -unlike(self.sum));
        let reached = (x > -NARROW) & (y > -NARROW);
        let (x, y) = (x.max(0.0), y.max(0.0));
        let sum = x + y;
        if !(sum > 1e-14) {
            return BLIND;
        }
        let height = root(x * y);
        let per = 1.0 / sum;
        let (c, s) = ((y - x) * per, 2.0 * height * per);
        Pair {
            both: [self.middle.then(Turn { c, s }), self.middle.then(Turn { c, s: -s })],
            free: self.free,
            blind: false,
            narrow: reached & (height < NARROW),
        }
    }
}
