//! Rigid displacements.

use super::vector::{IDENTITY, Matrix, Vector, add, product, sub, times, transposed, transposed_times};

/// `x -> R x + p`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Displacement {
    /// Rotation.
    pub rotation: Matrix,
    /// Image of the origin, m.
    pub shift: Vector,
}

impl Displacement {
    /// Nothing moves.
    pub const NONE: Self = Self { rotation: IDENTITY, shift: [0.0; 3] };

    /// From the top three rows of a homogeneous matrix.
    pub fn from_rows(rows: &[[f64; 4]; 3]) -> Self {
        let [[a, b, c, x], [d, e, f, y], [g, h, i, z]] = *rows;
        Self { rotation: [[a, b, c], [d, e, f], [g, h, i]], shift: [x, y, z] }
    }

    #[inline(always)]
    pub(super) fn point(&self, x: Vector) -> Vector {
        add(times(&self.rotation, x), self.shift)
    }

    /// The inverse, of a point.
    #[inline(always)]
    pub(super) fn back(&self, x: Vector) -> Vector {
        transposed_times(&self.rotation, sub(x, self.shift))
    }

    /// `self` after `first`.
    #[inline(always)]
    pub fn after(&self, first: &Self) -> Self {
        Self { rotation: product(&self.rotation, &first.rotation), shift: self.point(first.shift) }
    }

    /// The inverse.
    #[inline(always)]
    pub fn inverse(&self) -> Self {
        let rotation = transposed(&self.rotation);
        let [x, y, z] = self.shift;
        Self { shift: times(&rotation, [-x, -y, -z]), rotation }
    }
}
