//! Rigid displacements.

use super::vector::{IDENTITY, Matrix, Vector, add, product, sub, times, transposed, transposed_times};

/// `x -> R x + p`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Displacement {
    /// Rotation.
    pub rotation: Matrix,
    /// Where the origin goes, m.
    pub shift: Vector,
}

impl Displacement {
    /// Nothing moves.
    pub const NONE: Self = Self { rotation: IDENTITY, shift: [0.0; 3] };

    /// From the top three rows of a homogeneous matrix.
    pub fn from_rows(rows: &[[f64; 4]; 3]) -> Self {
        Self { rotation: rows.map(|[x, y, z, _]| [x, y, z]), shift: rows.map(|[.., p]| p) }
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
    #[inline]
    pub fn after(&self, first: &Self) -> Self {
        Self { rotation: product(&self.rotation, &first.rotation), shift: self.point(first.shift) }
    }

    /// The inverse.
    #[inline]
    pub fn inverse(&self) -> Self {
        let rotation = transposed(&self.rotation);
        Self { shift: times(&rotation, self.shift.map(|x| -x)), rotation }
    }
}
