//! Frames and Jacobians, by differences of nothing: poses multiplied out, velocities propagated.

use nalgebra::{DMatrix, DVector, Isometry3, Vector3};

use super::{Motion6, Numeric};

impl Numeric {
    /// DH frames of all rows in the base frame.
    pub fn frames(&self, q: &[f64]) -> Vec<Isometry3<f64>> {
        let mut pose = Isometry3::identity();
        (0..self.rows())
            .map(|row| {
                pose *= self.local(row, q);
                pose
            })
            .collect()
    }

    /// The last DH frame.
    pub fn forward_kinematics(&self, q: &[f64]) -> Isometry3<f64> {
        self.frames(q).last().copied().unwrap_or_else(Isometry3::identity)
    }

    /// The tool frame.
    pub fn tool_pose(&self, q: &[f64]) -> Isometry3<f64> {
        self.forward_kinematics(q) * self.tool
    }

    /// `6 x n`, linear part first, of the last frame's origin, base axes.
    pub fn jacobian(&self, q: &[f64]) -> DMatrix<f64> {
        let (x, s, rotation) = (self.transforms(q), self.axes(), self.forward_kinematics(q).rotation);
        let mut jacobian = DMatrix::zeros(6, self.dof());
        for (row, body) in self.bodies.iter().enumerate() {
            let Some(k) = body.dof else { continue };
            let end = (row + 1..self.rows()).fold(s[row], |m, i| x[i].motion(&m));
            jacobian.fixed_view_mut::<3, 1>(0, k).copy_from(&(rotation * end.v));
            jacobian.fixed_view_mut::<3, 1>(3, k).copy_from(&(rotation * end.w));
        }
        jacobian
    }

    /// `dJ/dt dq`, linear part first.
    pub fn jacobian_dot_velocity(&self, q: &[f64], dq: &[f64]) -> DVector<f64> {
        let (x, s, rotation) = (self.transforms(q), self.axes(), self.forward_kinematics(q).rotation);
        let (mut velocity, mut acceleration) = (Motion6::zero(), Motion6::zero());
        for row in 0..self.rows() {
            let joint = s[row].scaled(self.bodies[row].dof.map_or(0.0, |k| dq[k]));
            velocity = x[row].motion(&velocity) + joint;
            acceleration = x[row].motion(&acceleration) + velocity.cross(&joint);
        }
        // Spatial to classical acceleration of the origin (Featherstone, 2.14).
        let linear: Vector3<f64> = rotation * (acceleration.v + velocity.w.cross(&velocity.v));
        let angular = rotation * acceleration.w;
        DVector::from_iterator(6, linear.iter().chain(angular.iter()).copied())
    }
}
