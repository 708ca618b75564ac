//! The plane from which a swivel angle is counted.

use super::vector::{Vector, beside, cross, dot, norm, scale, sub, unit};

/// A plane through shoulder and wrist from which the swivel angle is counted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reference {
    /// The paper's vector b: at swivel angle zero the elbow lies on its side of the line from
    /// shoulder to wrist.
    pub b: Vector,
    /// Substitute where b is parallel to that line.
    pub second: Vector,
}

impl Reference {
    /// `b` up, the second forwards.
    pub const UP: Self = Self { b: [0.0, 0.0, 1.0], second: [1.0, 0.0, 0.0] };

    /// `u` and `v` of the paper for the unit vector `n` from shoulder to wrist; true: by the second
    /// vector.
    pub(super) fn plane(&self, n: Vector) -> (Vector, Vector, bool) {
        let across = |b: Vector| sub(b, scale(dot(n, b), n));
        let (first, second) = (across(self.b), across(self.second));
        let poor = !(norm(first) > 1e-6 * norm(self.b));
        let u = match (poor, norm(second) > 1e-6 * norm(self.second)) {
            (false, _) => unit(first),
            (true, true) => unit(second),
            (true, false) => beside(n),
        };
        (u, cross(n, u), poor)
    }
}
