//! Vectors and matrices of expressions, for mechanics.

use core::array::from_fn;
use core::ops::{Add, Mul, Neg, Sub};

use super::graph::{Ex, Graph};

/// Vector of three expressions.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Vec3<'g>(pub [Ex<'g>; 3]);

/// Matrix of three rows of three expressions.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Mat3<'g>(pub [[Ex<'g>; 3]; 3]);

impl<'g> Vec3<'g> {
    /// Vector of constants.
    pub fn numbers(g: &'g Graph, v: [f64; 3]) -> Self {
        Self(v.map(|x| g.constant(x)))
    }

    /// Vector of numbers of a description.
    pub fn given(g: &'g Graph, v: [f64; 3]) -> Self {
        Self(v.map(|x| g.given(x)))
    }

    /// The zero vector.
    pub fn zero(g: &'g Graph) -> Self {
        Self::numbers(g, [0.0; 3])
    }

    /// Scalar product.
    pub fn dot(self, other: Self) -> Ex<'g> {
        let [a, b, c] = from_fn(|k| self.0[k] * other.0[k]);
        a + b + c
    }

    /// Vector product.
    pub fn cross(self, other: Self) -> Self {
        let (a, b) = (self.0, other.0);
        Self([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])
    }

    /// Product with a scalar `s`.
    pub fn scale(self, s: Ex<'g>) -> Self {
        Self(self.0.map(|x| x * s))
    }

    /// Whether all entries are structurally zero.
    pub fn is_zero(self) -> bool {
        self.0.iter().all(|x| x.is_zero())
    }

    /// Names the three entries `name_x`, `name_y`, `name_z`.
    pub fn label(self, name: &str) -> Self {
        for (x, axis) in self.0.iter().zip(["x", "y", "z"]) {
            x.graph().label(*x, format!("{name}_{axis}"));
        }
        self
    }
}

impl<'g> Add for Vec3<'g> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl<'g> Sub for Vec3<'g> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(from_fn(|k| self.0[k] - other.0[k]))
    }
}

impl<'g> Neg for Vec3<'g> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(|x| -x))
    }
}

impl<'g> Mat3<'g> {
    /// Matrix of constants.
    pub fn numbers(g: &'g Graph, m: [[f64; 3]; 3]) -> Self {
        Self(m.map(|row| row.map(|x| g.constant(x))))
    }

    /// Transposed matrix; for a rotation, the inverse.
    pub fn transposed(self) -> Self {
        Self(from_fn(|i| from_fn(|j| self.0[j][i])))
    }

    /// Column `j`.
    pub fn column(self, j: usize) -> Vec3<'g> {
        Vec3(from_fn(|i| self.0[i][j]))
    }
}

impl<'g> Mul<Vec3<'g>> for Mat3<'g> {
    type Output = Vec3<'g>;
    fn mul(self, v: Vec3<'g>) -> Vec3<'g> {
        Vec3(from_fn(|i| Vec3(self.0[i]).dot(v)))
    }
}

impl<'g> Mul for Mat3<'g> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(from_fn(|i| from_fn(|j| Vec3(self.0[i]).dot(other.column(j)))))
    }
}
