//! Turns of three axes that make a rotation, `R1 R2 R3 = R`.

use super::real::root;
use super::subproblem::{FREE, NARROW, doubt, tilt, towards};
use super::vector::{Matrix, Turn, Vector, beside, cross, dot, product, times, transposed};

/// Three axes, and a basis with each of the outer ones (columns; the axis is the last).
#[derive(Clone, Copy)]
pub(super) struct Three {
    pub h: [Vector; 3],
    pub first: [Vector; 3],
    pub last: [Vector; 3],
    /// Rotation at which the middle joint brings the outer axes together, if it is square to both.
    square: Option<Turn>,
}

/// Both answers, the second after the sign of a square root; bit 0: the first joint is free, bit 1:
/// the second; bit 7: [`super::subproblem::DOUBT`].
pub(super) type Turns = [([Turn; 3], u8); 2];

impl Three {
    #[inline(always)]
    pub fn new(h: [Vector; 3]) -> Self {
        let [h1, h2, h3] = h;
        if dot(h1, h2).abs() < 1e-14 && dot(h2, h3).abs() < 1e-14 {
            let together = Turn { c: dot(h1, h3), s: -dot(h2, cross(h1, h3)) };
            return Self { h, first: [cross(h2, h1), h2, h1], last: [cross(h2, h3), h2, h3], square: Some(together) };
        }
        let (y1, y3) = (beside(h1), beside(h3));
        Self { h, first: [cross(y1, h1), y1, h1], last: [cross(y3, h3), y3, h3], square: None }
    }

    /// Is the middle axis square to the outer ones?
    #[inline(always)]
    pub fn is_square(&self) -> bool {
        self.square.is_some()
    }

    /// The basis of the first axis as the joints before it carry it, `x`, and the basis of the last
    /// one as the goal has it, `y`. Where the outer axes become parallel, the first turn is
    /// `near`'s.
    #[inline(always)]
    pub fn turns(&self, x: &[Vector; 3], y: &[Vector; 3], near: Turn) -> Turns {
        let [a, b, c] = *x;
        let row = |x: Vector| [dot(x, y[0]), dot(x, y[1]), dot(x, y[2])];
        self.between(&[row(a), row(b), row(c)], near)
    }

    /// The same by the products of those vectors.
    #[inline(always)]
    pub fn between(&self, m: &Matrix, near: Turn) -> Turns {
        let Some(together) = self.square else { return self.oblique(m, near) };
        // Euler angles: Z(first) Y(second) Z(third).
        let (c1, s1, cosine) = (m[0][2], m[1][2], m[2][2]);
        let sine = root(c1 * c1 + s1 * s1);
        let blind = !(sine > 1e-14);
        let first = if blind { near } else { Turn { c: c1 / sine, s: s1 / sine } };
        // The second row of what the first turn leaves: well known in a singularity, too.
        let third = Turn { c: first.c * m[1][1] - first.s * m[0][1], s: first.c * m[1][0] - first.s * m[0][0] };
        let free = u8::from(sine < FREE) | doubt(sine < NARROW);
        let one = [first, Turn { c: cosine, s: sine }.then(together), third];
        let second = Turn { c: cosine, s: -sine }.then(together);
        let half = |t: Turn| Turn { c: -t.c, s: -t.s };
        let two = if blind { [first, second, third] } else { [half(first), second, half(third)] };
        [(one, free), (two, free)]
    }

    /// By the spherical triangle, for any three axes.
    #[inline(never)]
    fn oblique(&self, between: &Matrix, near: Turn) -> Turns {
        // x = A first, y = A R last: R = first x' y last'.
        let r = product(&product(&transposed(&self.first), between), &self.last);
        let h = &self.h;
        let goal = times(&r, h[2]);
        let pair = tilt(h[0], h[1], h[2], goal);
        let side = beside(h[2]);
        let image = times(&r, side);
        pair.both.map(|second| {
            let (turn, known) = towards(h[0], second.about(h[1], h[2]), goal);
            // The product of two small distances from the axis: both are about `sine`.
            let (first, free) =
                if known > 1e-28 { (turn, if known < FREE * FREE { 1u8 } else { 0 }) } else { (near, 1) };
            let free = free | doubt(pair.narrow || known < NARROW * NARROW);
            let back = second.back().about(h[1], first.back().about(h[0], image));
            ([first, second, towards(h[2], side, back).0], free | u8::from(pair.free) << 1)
        })
    }

    /// Carries the first basis: two of its vectors, the third is square to them.
    #[inline(always)]
    pub fn carried(&self, by: impl Fn(Vector) -> Vector) -> [Vector; 3] {
        let (y, z) = (by(self.first[1]), by(self.first[2]));
        [cross(y, z), y, z]
    }

    /// The last basis at the goal.
    #[inline(always)]
    pub fn goal(&self, r: &Matrix) -> [Vector; 3] {
        let (y, z) = (times(r, self.last[1]), times(r, self.last[2]));
        [cross(y, z), y, z]
    }
}
