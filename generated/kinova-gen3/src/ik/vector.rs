//! Vectors and rotations of three dimensions.
//!
//! Every pose passes through these closed forms, so they are written out here and in the
//! neighbouring files. Closures over arrays (`map`, `from_fn`, zipped iterators) stay calls that
//! pass everything through memory, a third of the time.

use super::real::root;

/// Three numbers.
pub type Vector = [f64; 3];
/// Rows of a 3 x 3 matrix.
pub type Matrix = [[f64; 3]; 3];

pub(super) const IDENTITY: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

#[inline(always)]
pub(super) fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
pub(super) fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
pub(super) fn scale(k: f64, a: Vector) -> Vector {
    [k * a[0], k * a[1], k * a[2]]
}

#[inline(always)]
pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline(always)]
pub(super) fn norm(a: Vector) -> f64 {
    root(dot(a, a))
}

/// Unit vector along `a`; `a` itself where it is zero.
#[inline(always)]
pub(super) fn unit(a: Vector) -> Vector {
    let n = norm(a);
    if n > 0.0 { scale(1.0 / n, a) } else { a }
}

/// The same of a vector whose length is mostly one already, but for rounding: one of Newton's
/// steps, which waits for no root and no quotient.
#[inline(always)]
pub(super) fn nearly_unit(a: Vector) -> Vector {
    let n2 = dot(a, a);
    if (n2 - 1.0).abs() < 1e-8 { scale(1.5 - 0.5 * n2, a) } else { unit(a) }
}

/// A unit vector at right angles to the unit vector `h`: always the same one for the same `h`.
#[inline]
pub(super) fn beside(h: Vector) -> Vector {
    let [x, y, z] = h.map(f64::abs);
    let other = if x <= y && x <= z {
        [1.0, 0.0, 0.0]
    } else if y <= z {
        [0.0, 1.0, 0.0]
    } else {
        [0.0, 0.0, 1.0]
    };
    unit(sub(other, scale(dot(other, h), h)))
}

/// `M v`.
#[inline(always)]
pub(super) fn times(m: &Matrix, v: Vector) -> Vector {
    [dot(m[0], v), dot(m[1], v), dot(m[2], v)]
}

/// `M' v`.
#[inline(always)]
pub(super) fn transposed_times(m: &Matrix, v: Vector) -> Vector {
    add(add(scale(v[0], m[0]), scale(v[1], m[1])), scale(v[2], m[2]))
}

/// `A B`.
#[inline(always)]
pub(super) fn product(a: &Matrix, b: &Matrix) -> Matrix {
    [transposed_times(b, a[0]), transposed_times(b, a[1]), transposed_times(b, a[2])]
}

#[inline(always)]
pub(super) fn transposed(m: &Matrix) -> Matrix {
    [[m[0][0], m[1][0], m[2][0]], [m[0][1], m[1][1], m[2][1]], [m[0][2], m[1][2], m[2][2]]]
}

/// Sine and cosine of an angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turn {
    /// Cosine.
    pub c: f64,
    /// Sine.
    pub s: f64,
}

impl Turn {
    pub(super) const NONE: Self = Self { c: 1.0, s: 0.0 };

    #[inline(always)]
    pub(super) fn back(self) -> Self {
        Self { c: self.c, s: -self.s }
    }

    /// Both, one after the other.
    #[inline(always)]
    pub(super) fn then(self, o: Self) -> Self {
        Self { c: self.c * o.c - self.s * o.s, s: self.s * o.c + self.c * o.s }
    }

    /// Of the direction `(c, s)`, with its length; no turn where there is no direction.
    #[inline(always)]
    pub(super) fn along(c: f64, s: f64) -> (Self, f64) {
        let n = root(c * c + s * s);
        // The reciprocal of a subnormal number would overflow.
        if n > 1e-150 { (Self { c: c / n, s: s / n }, n) } else { (Self::NONE, 0.0) }
    }

    /// Rodrigues: `v` turned about the unit vector `h`.
    #[inline(always)]
    pub(super) fn about(self, h: Vector, v: Vector) -> Vector {
        let along = scale(dot(h, v), h);
        let across = sub(v, along);
        add(along, add(scale(self.c, across), scale(self.s, cross(h, v))))
    }
}
