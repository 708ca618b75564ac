//! Rigid displacements between the frames of a tree, as matrices.

use nalgebra::{Matrix3, Vector3};

/// Pose of a frame in another one: `x -> R x + p`, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Displacement {
    /// Axes of the frame as columns.
    pub rotation: Matrix3<f64>,
    /// Origin, m.
    pub origin: Vector3<f64>,
}

impl Displacement {
    /// Identity: both frames coincide.
    pub fn identity() -> Self {
        Self { rotation: Matrix3::identity(), origin: Vector3::zeros() }
    }

    /// Creates a displacement from the rows of a rotation and an origin, m.
    pub fn new(rotation: [[f64; 3]; 3], origin: [f64; 3]) -> Self {
        // `from` reads columns.
        Self { rotation: Matrix3::from(rotation).transpose(), origin: Vector3::from(origin) }
    }

    /// Translation, m.
    pub fn shift(origin: Vector3<f64>) -> Self {
        Self { rotation: Matrix3::identity(), origin }
    }

    /// Rotation about a unit vector by `angle`, rad (Rodrigues' formula).
    pub fn turn(axis: &Vector3<f64>, angle: f64) -> Self {
        let (s, c) = angle.sin_cos();
        let k = axis.cross_matrix();
        Self { rotation: Matrix3::identity() + k * s + k * k * (1.0 - c), origin: Vector3::zeros() }
    }

    /// Rotation from a quaternion `w x y z` of any length but zero; for zero [`Self::is_rotation`]
    /// is false.
    pub fn quaternion([w, x, y, z]: [f64; 4]) -> Self {
        let square = w * w + x * x + y * y + z * z;
        let two = |a: f64, b: f64| 2.0 * a * b / square;
        Self::new(
            [
                [1.0 - two(y, y) - two(z, z), two(x, y) - two(w, z), two(x, z) + two(w, y)],
                [two(x, y) + two(w, z), 1.0 - two(x, x) - two(z, z), two(y, z) - two(w, x)],
                [two(x, z) - two(w, y), two(y, z) + two(w, x), 1.0 - two(x, x) - two(y, y)],
            ],
            [0.0; 3],
        )
    }

    /// Whether the matrix preserves lengths and handedness, to rounding.
    pub fn is_rotation(&self) -> bool {
        (self.rotation.determinant() - 1.0).abs() <= 1e-6
    }

    /// Composition: pose of `next`, given in this frame, in the frame in which this one is given.
    pub fn then(&self, next: &Self) -> Self {
        Self { rotation: self.rotation * next.rotation, origin: self.rotation * next.origin + self.origin }
    }

    /// Inverse displacement: pose of the other frame in this one.
    pub fn inverse(&self) -> Self {
        let back = self.rotation.transpose();
        Self { rotation: back, origin: -(back * self.origin) }
    }

    /// Rows of the rotation.
    pub fn rows(&self) -> [[f64; 3]; 3] {
        core::array::from_fn(|i| core::array::from_fn(|j| self.rotation[(i, j)]))
    }
}
