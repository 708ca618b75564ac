//! Spatial vectors (Featherstone, chapter 2): motions, forces, transforms, inertias.

use core::ops::Add;

use nalgebra::{Isometry3, Matrix3, Vector3};

/// A motion vector: angular, and linear at the frame's origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion6 {
    /// Angular part.
    pub w: Vector3<f64>,
    /// Linear part.
    pub v: Vector3<f64>,
}

/// A force vector: moment about the frame's origin, and force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Force {
    /// Moment.
    pub n: Vector3<f64>,
    /// Force.
    pub f: Vector3<f64>,
}

impl Motion6 {
    /// No motion.
    pub fn zero() -> Self {
        Self { w: Vector3::zeros(), v: Vector3::zeros() }
    }

    /// Each entry times a number.
    pub fn scaled(&self, s: f64) -> Self {
        Self { w: self.w * s, v: self.v * s }
    }

    /// `self x other` (2.33).
    pub fn cross(&self, other: &Self) -> Self {
        Self { w: self.w.cross(&other.w), v: self.w.cross(&other.v) + self.v.cross(&other.w) }
    }

    /// `self x* force` (2.34).
    pub fn cross_force(&self, force: &Force) -> Force {
        Force { n: self.w.cross(&force.n) + self.v.cross(&force.f), f: self.w.cross(&force.f) }
    }

    /// Power of a force.
    pub fn dot(&self, force: &Force) -> f64 {
        self.w.dot(&force.n) + self.v.dot(&force.f)
    }
}

impl Add for Motion6 {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { w: self.w + other.w, v: self.v + other.v }
    }
}

impl Force {
    /// No force.
    pub fn zero() -> Self {
        Self { n: Vector3::zeros(), f: Vector3::zeros() }
    }
}

impl Add for Force {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { n: self.n + other.n, f: self.f + other.f }
    }
}

/// From frame A to frame B: `e` turns A's coordinates into B's, `r` is B's origin in A (2.24).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpatialTransform {
    e: Matrix3<f64>,
    r: Vector3<f64>,
}

impl SpatialTransform {
    /// From the pose of B in A.
    pub fn from_pose(pose: &Isometry3<f64>) -> Self {
        Self { e: pose.rotation.to_rotation_matrix().matrix().transpose(), r: pose.translation.vector }
    }

    /// Motion vectors, A to B.
    pub fn motion(&self, m: &Motion6) -> Motion6 {
        Motion6 { w: self.e * m.w, v: self.e * (m.v - self.r.cross(&m.w)) }
    }

    /// Force vectors, B back to A: the transpose.
    pub fn force_back(&self, f: &Force) -> Force {
        let force = self.e.transpose() * f.f;
        Force { n: self.e.transpose() * f.n + self.r.cross(&force), f: force }
    }

    /// Inertia, B back to A (2.66).
    pub fn inertia_back(&self, i: &Inertia6) -> Inertia6 {
        let (et, r) = (self.e.transpose(), self.r);
        let l = et * i.moment;
        let (rx, lx) = (r.cross_matrix(), l.cross_matrix());
        Inertia6 {
            mass: i.mass,
            moment: l + r * i.mass,
            tensor: et * i.tensor * self.e - rx * lx - lx * rx - rx * rx * i.mass,
        }
    }
}

/// Spatial inertia: mass, first moments, tensor about the frame's origin (2.62).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Inertia6 {
    /// Mass, kg.
    pub mass: f64,
    /// Mass times centre, kg m.
    pub moment: Vector3<f64>,
    /// Tensor about the origin, kg m^2.
    pub tensor: Matrix3<f64>,
}

impl Inertia6 {
    /// Momentum of a motion.
    pub fn times(&self, m: &Motion6) -> Force {
        Force { n: self.tensor * m.w + self.moment.cross(&m.v), f: m.v * self.mass - self.moment.cross(&m.w) }
    }

    /// Both bodies together.
    pub fn plus(&self, other: &Self) -> Self {
        Self { mass: self.mass + other.mass, moment: self.moment + other.moment, tensor: self.tensor + other.tensor }
    }

    /// Every entry times a number.
    pub fn scaled(&self, s: f64) -> Self {
        Self { mass: self.mass * s, moment: self.moment * s, tensor: self.tensor * s }
    }
}
