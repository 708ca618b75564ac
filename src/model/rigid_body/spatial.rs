//! Spatial vectors: motions, forces, Plücker transforms, inertias.
//!
//! Notation and order (angular part first) of R. Featherstone, *Rigid Body Dynamics Algorithms*,
//! Springer 2008, chapter 2.

use std::ops::{Add, AddAssign, Mul, Neg, Sub};

use nalgebra::{Matrix3, Matrix6, SMatrix, Vector3, Vector6};

/// A motion vector: angular part `w` (rad/s) and velocity `v` (m/s) of the body-fixed point at the
/// frame's origin. It may also be a spatial acceleration, whose linear part is *not* that of a
/// point (`a_point = v' + w x v`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// Angular part.
    pub w: Vector3<f64>,
    /// Linear part.
    pub v: Vector3<f64>,
}

/// A force vector: moment `n` about the frame's origin (N m) and force `f` (N); or a momentum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Force {
    /// Moment.
    pub n: Vector3<f64>,
    /// Force.
    pub f: Vector3<f64>,
}

impl Motion {
    /// The zero vector.
    pub fn zero() -> Self {
        Self { w: Vector3::zeros(), v: Vector3::zeros() }
    }

    /// Motion cross product `self x m`, equation 2.31.
    pub fn cross(&self, m: &Self) -> Self {
        Self { w: self.w.cross(&m.w), v: self.w.cross(&m.v) + self.v.cross(&m.w) }
    }

    /// Force cross product `self x* f`, equation 2.32.
    pub fn cross_force(&self, f: &Force) -> Force {
        Force { n: self.w.cross(&f.n) + self.v.cross(&f.f), f: self.w.cross(&f.f) }
    }

    /// Power of a force on this motion, W.
    pub fn dot(&self, f: &Force) -> f64 {
        self.w.dot(&f.n) + self.v.dot(&f.f)
    }

    /// As a column, angular part first.
    pub fn to_vector(self) -> Vector6<f64> {
        Vector6::new(self.w.x, self.w.y, self.w.z, self.v.x, self.v.y, self.v.z)
    }

    /// The matrix of [`Motion::cross`].
    pub fn cross_matrix(&self) -> Matrix6<f64> {
        let (w, v) = (skew(&self.w), skew(&self.v));
        blocks(&w, &Matrix3::zeros(), &v, &w)
    }

    /// The matrix of [`Motion::cross_force`]: `-(v x)'`.
    pub fn cross_force_matrix(&self) -> Matrix6<f64> {
        let (w, v) = (skew(&self.w), skew(&self.v));
        blocks(&w, &v, &Matrix3::zeros(), &w)
    }
}

impl Force {
    /// The zero vector.
    pub fn zero() -> Self {
        Self { n: Vector3::zeros(), f: Vector3::zeros() }
    }

    /// The matrix that maps a motion `m` to `m x* self`.
    pub fn crossed_matrix(&self) -> Matrix6<f64> {
        let (n, f) = (skew(&self.n), skew(&self.f));
        -blocks(&n, &f, &f, &Matrix3::zeros())
    }
}

macro_rules! vector_space {
    ($type:ident, $a:ident, $b:ident) => {
        impl Add for $type {
            type Output = Self;
            fn add(self, o: Self) -> Self {
                Self { $a: self.$a + o.$a, $b: self.$b + o.$b }
            }
        }
        impl Sub for $type {
            type Output = Self;
            fn sub(self, o: Self) -> Self {
                Self { $a: self.$a - o.$a, $b: self.$b - o.$b }
            }
        }
        impl Neg for $type {
            type Output = Self;
            fn neg(self) -> Self {
                Self { $a: -self.$a, $b: -self.$b }
            }
        }
        impl Mul<f64> for $type {
            type Output = Self;
            fn mul(self, s: f64) -> Self {
                Self { $a: self.$a * s, $b: self.$b * s }
            }
        }
        impl AddAssign for $type {
            fn add_assign(&mut self, o: Self) {
                *self = *self + o;
            }
        }
    };
}
vector_space!(Motion, w, v);
vector_space!(Force, n, f);

/// Plücker transform between a parent frame A and a child frame B.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plucker {
    /// Rotation matrix whose columns are B's axes in A (the transpose of Featherstone's `E`).
    pub rotation: Matrix3<f64>,
    /// Origin of B in A, m.
    pub origin: Vector3<f64>,
}

impl Plucker {
    /// The identity transform.
    pub fn identity() -> Self {
        Self { rotation: Matrix3::identity(), origin: Vector3::zeros() }
    }

    /// Composition: `self` from A to B, then `next` from B to C, gives A to C.
    pub fn then(&self, next: &Self) -> Self {
        Self { rotation: self.rotation * next.rotation, origin: self.origin + self.rotation * next.origin }
    }

    /// Transforms a motion from A to B: `X m`, equation 2.24.
    pub fn motion(&self, m: &Motion) -> Motion {
        Motion { w: self.rotation.tr_mul(&m.w), v: self.rotation.tr_mul(&(m.v - self.origin.cross(&m.w))) }
    }

    /// Transforms a force from B to A: `X' f` (the inverse of equation 2.25).
    pub fn force_to_parent(&self, f: &Force) -> Force {
        let force = self.rotation * f.f;
        Force { n: self.rotation * f.n + self.origin.cross(&force), f: force }
    }

    /// Transforms an inertia from B to A: `X' I X`.
    pub fn inertia_to_parent(&self, b: &SpatialInertia) -> SpatialInertia {
        let (r, p) = (&self.rotation, skew(&self.origin));
        let h = r * b.h;
        let shifted = h + self.origin * b.m;
        SpatialInertia {
            m: b.m,
            h: shifted,
            // Parallel-axis theorem, from the origin of B to the centre of mass and on to the
            // origin of A.
            i: r * b.i * r.transpose() - p * skew(&h) - skew(&shifted) * p,
        }
    }

    /// Transforms an articulated-body inertia from B to A.
    pub fn articulated_to_parent(&self, b: &ArticulatedInertia) -> ArticulatedInertia {
        let (r, p) = (&self.rotation, skew(&self.origin));
        let rt = r.transpose();
        let (m, h0) = (r * b.m * rt, r * b.h * rt);
        let h = h0 + p * m;
        ArticulatedInertia { m, h, i: r * b.i * rt + p * h0.transpose() - h * p }
    }

    /// The matrix `X`, 6 x 6, from A to B (equation 2.24).
    pub fn matrix(&self) -> Matrix6<f64> {
        let e = self.rotation.transpose();
        blocks(&e, &Matrix3::zeros(), &(-e * skew(&self.origin)), &e)
    }
}

/// Rigid-body inertia about the origin of its frame (equation 2.63).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpatialInertia {
    /// Mass, kg.
    pub m: f64,
    /// First moment, kg m.
    pub h: Vector3<f64>,
    /// Tensor, kg m^2.
    pub i: Matrix3<f64>,
}

impl SpatialInertia {
    /// The zero inertia.
    pub fn zero() -> Self {
        Self { m: 0.0, h: Vector3::zeros(), i: Matrix3::zeros() }
    }

    /// From the ten parameters `M MSX MSY MSZ XX YY ZZ XY XZ YZ`; `XY` is the tensor's own entry.
    ///
    /// # Panics
    /// If `p` is shorter than ten.
    pub fn from_parameters(p: &[f64]) -> Self {
        let [xx, yy, zz, xy, xz, yz] = [p[4], p[5], p[6], p[7], p[8], p[9]];
        Self { m: p[0], h: Vector3::new(p[1], p[2], p[3]), i: Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz) }
    }

    /// Momentum `I v`.
    pub fn times(&self, v: &Motion) -> Force {
        Force { n: self.i * v.w + self.h.cross(&v.v), f: v.v * self.m - self.h.cross(&v.w) }
    }

    /// The matrix `I`, 6 x 6.
    pub fn matrix(&self) -> Matrix6<f64> {
        let h = skew(&self.h);
        blocks(&self.i, &h, &(-h), &(Matrix3::identity() * self.m))
    }
}

impl Add for SpatialInertia {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self { m: self.m + o.m, h: self.h + o.h, i: self.i + o.i }
    }
}

/// Articulated-body inertia `[i h; h' m]` (chapter 7): symmetric, but its mass is a matrix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArticulatedInertia {
    /// Force per linear acceleration, kg.
    pub m: Matrix3<f64>,
    /// Moment per linear acceleration, kg m.
    pub h: Matrix3<f64>,
    /// Moment per angular acceleration, kg m^2.
    pub i: Matrix3<f64>,
}

impl ArticulatedInertia {
    /// Force for the acceleration `a`.
    pub fn times(&self, a: &Motion) -> Force {
        Force { n: self.i * a.w + self.h * a.v, f: self.h.tr_mul(&a.w) + self.m * a.v }
    }

    /// `self - u u' / d`.
    pub fn minus_dyad(&self, u: &Force, d: f64) -> Self {
        Self {
            m: self.m - u.f * (u.f / d).transpose(),
            h: self.h - u.n * (u.f / d).transpose(),
            i: self.i - u.n * (u.n / d).transpose(),
        }
    }
}

impl From<SpatialInertia> for ArticulatedInertia {
    fn from(b: SpatialInertia) -> Self {
        Self { m: Matrix3::identity() * b.m, h: skew(&b.h), i: b.i }
    }
}

impl Add for ArticulatedInertia {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self { m: self.m + o.m, h: self.h + o.h, i: self.i + o.i }
    }
}

/// Matrix of the cross product `u x`, 3 x 3.
pub fn skew(u: &Vector3<f64>) -> Matrix3<f64> {
    Matrix3::new(0.0, -u.z, u.y, u.z, 0.0, -u.x, -u.y, u.x, 0.0)
}

/// Regressor of one body, 6 x 10, moment first. `I a + v x* I v = A(v, a) phi`, with `phi` the ten
/// parameters in the frame of `v` and `a` (C. Atkeson, C. An and J. Hollerbach, *Estimation of
/// inertial parameters of manipulator loads and links*, IJRR 5(3), 1986; here from spatial
/// vectors).
pub fn body_regressor(v: &Motion, a: &Motion) -> SMatrix<f64, 6, 10> {
    // With point = a.v + w x v, the classical acceleration of the origin, the sum of products
    // becomes f = m point + (alpha x + w x w x) h, n = h x point + L(alpha) I + w x L(w) I.
    let point = a.v + v.w.cross(&v.v);
    let w = skew(&v.w);
    let mut out = SMatrix::<f64, 6, 10>::zeros();
    out.fixed_view_mut::<3, 1>(3, 0).copy_from(&point);
    out.fixed_view_mut::<3, 3>(3, 1).copy_from(&(skew(&a.w) + w * w));
    out.fixed_view_mut::<3, 3>(0, 1).copy_from(&-skew(&point));
    out.fixed_view_mut::<3, 6>(0, 4).copy_from(&(tensor_times(&a.w) + w * tensor_times(&v.w)));
    out
}

/// `L(w)`, 3 x 6, with `I w = L(w) [XX YY ZZ XY XZ YZ]'`.
fn tensor_times(w: &Vector3<f64>) -> SMatrix<f64, 3, 6> {
    SMatrix::<f64, 3, 6>::new(
        w.x, 0.0, 0.0, w.y, w.z, 0.0, //
        0.0, w.y, 0.0, w.x, 0.0, w.z, //
        0.0, 0.0, w.z, 0.0, w.x, w.y,
    )
}

fn blocks(a: &Matrix3<f64>, b: &Matrix3<f64>, c: &Matrix3<f64>, d: &Matrix3<f64>) -> Matrix6<f64> {
    let mut m = Matrix6::zeros();
    m.fixed_view_mut::<3, 3>(0, 0).copy_from(a);
    m.fixed_view_mut::<3, 3>(0, 3).copy_from(b);
    m.fixed_view_mut::<3, 3>(3, 0).copy_from(c);
    m.fixed_view_mut::<3, 3>(3, 3).copy_from(d);
    m
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::prng::Random;

    fn vector3(r: &mut Random) -> Vector3<f64> {
        Vector3::from_fn(|_, _| r.uniform(-2.0, 2.0))
    }

    fn motion(r: &mut Random) -> Motion {
        Motion { w: vector3(r), v: vector3(r) }
    }

    fn force(r: &mut Random) -> Force {
        Force { n: vector3(r), f: vector3(r) }
    }

    fn plucker(r: &mut Random) -> Plucker {
        let axis = nalgebra::Unit::new_normalize(vector3(r));
        let rotation = nalgebra::Rotation3::from_axis_angle(&axis, r.uniform(-3.0, 3.0));
        Plucker { rotation: rotation.into_inner(), origin: vector3(r) }
    }

    fn stacked(f: &Force) -> Vector6<f64> {
        Vector6::new(f.n.x, f.n.y, f.n.z, f.f.x, f.f.y, f.f.z)
    }

    #[test]
    fn operators_agree_with_their_matrices() {
        let mut r = Random::new(1);
        for _ in 0..100 {
            let (m, n, f, x) = (motion(&mut r), motion(&mut r), force(&mut r), plucker(&mut r));
            let body = SpatialInertia::from_parameters(&r.inertia().to_array());
            let near = |a: Vector6<f64>, b: Vector6<f64>| assert!((a - b).amax() < 1e-12, "{a} {b}");
            near(m.cross(&n).to_vector(), m.cross_matrix() * n.to_vector());
            near(stacked(&m.cross_force(&f)), m.cross_force_matrix() * stacked(&f));
            near(stacked(&m.cross_force(&f)), f.crossed_matrix() * m.to_vector());
            near(x.motion(&m).to_vector(), x.matrix() * m.to_vector());
            near(stacked(&x.force_to_parent(&f)), x.matrix().transpose() * stacked(&f));
            near(stacked(&body.times(&m)), body.matrix() * m.to_vector());
            let moved = x.matrix().transpose() * body.matrix() * x.matrix();
            assert!((x.inertia_to_parent(&body).matrix() - moved).amax() < 1e-11);
            let articulated = x.articulated_to_parent(&body.into());
            near(stacked(&articulated.times(&m)), moved * m.to_vector());
        }
    }

    #[test]
    fn power_does_not_depend_on_the_frame() {
        let mut r = Random::new(2);
        for _ in 0..100 {
            let (m, f, x) = (motion(&mut r), force(&mut r), plucker(&mut r));
            assert!((x.motion(&m).dot(&f) - m.dot(&x.force_to_parent(&f))).abs() < 1e-12);
        }
    }

    #[test]
    fn body_regressor_is_the_newton_euler_equation() {
        let mut r = Random::new(3);
        for _ in 0..100 {
            let (v, a, p) = (motion(&mut r), motion(&mut r), r.inertia().to_array());
            let body = SpatialInertia::from_parameters(&p);
            let direct = body.times(&a) + v.cross_force(&body.times(&v));
            let linear = body_regressor(&v, &a) * SMatrix::<f64, 10, 1>::from_row_slice(&p);
            assert!((linear - stacked(&direct)).amax() < 1e-11);
        }
    }
}
