//! Rigid displacements of the tree, as matrices.

use nalgebra::{Matrix3, Vector3};

/// Rotation and origin of a frame in another one: `x -> R x + p`, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Displacement {
    /// Axes of the frame as columns.
    pub rotation: Matrix3<f64>,
    /// Origin, m.
    pub origin: Vector3<f64>,
}

impl Displacement {
    /// Both frames are one.
    pub fn identity() -> Self {
        Self { rotation: Matrix3::identity(), origin: Vector3::zeros() }
    }

    /// From rows and an origin.
    pub fn new(rotation: [[f64; 3]; 3], origin: [f64; 3]) -> Self {
        // `from` reads columns.
        Self { rotation: Matrix3::from(rotation).transpose(), origin: Vector3::from(origin) }
    }

    /// A shift.
    pub fn shift(origin: Vector3<f64>) -> Self {
        Self { rotation: Matrix3::identity(), origin }
    }

    /// A turn about a unit vector, rad (Rodrigues' formula).
    pub fn turn(axis: &Vector3<f64>, angle: f64) -> Self {
        let (s, c) = angle.sin_cos();
        let k = axis.cross_matrix();
        Self { rotation: Matrix3::identity() + k * s + k * k * (1.0 - c), origin: Vector3::zeros() }
    }

    /// `next` is given in this frame: where it is in the frame that this one stands in.
    pub fn then(&self, next: &Self) -> Self {
        Self { rotation: self.rotation * next.rotation, origin: self.rotation * next.origin + self.origin }
    }

    /// From the other frame to this one.
    pub fn inverse(&self) -> Self {
        let back = self.rotation.transpose();
        Self { rotation: back, origin: -(back * self.origin) }
    }

    /// Rows of the rotation.
    pub fn rows(&self) -> [[f64; 3]; 3] {
        core::array::from_fn(|i| core::array::from_fn(|j| self.rotation[(i, j)]))
    }
}
