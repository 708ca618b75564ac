//! Forward kinematics and Jacobians.

use nalgebra::{Matrix4, Matrix6xX, Vector3, Vector6};

use super::Numeric;
use super::rnea::Sweep;
use super::spatial::{Motion, Plucker};

impl Numeric {
    /// `T(0, i)` of every DH frame `i = 1..` in the world frame, one per row, base to tip; lengths
    /// in m.
    pub fn frames(&self, q: &[f64]) -> Vec<Matrix4<f64>> {
        self.poses(q).iter().map(homogeneous).collect()
    }

    /// Pose of the tool frame in the world frame; of the last DH frame without a tool.
    pub fn tool(&self, q: &[f64]) -> Matrix4<f64> {
        homogeneous(&self.last_pose(q).then(&self.tool))
    }

    /// Jacobian, `6 x n`: `[v; w] = J dq`, linear velocity (m/s) of the last DH frame's origin
    /// first, then the angular velocity (rad/s), in world axes.
    pub fn jacobian(&self, q: &[f64]) -> Matrix6xX<f64> {
        let poses = self.poses(q);
        self.jacobian_at(poses.last().map_or(self.base.origin, |tip| tip.origin), &poses)
    }

    /// [`Numeric::tool`] and the Jacobian of its origin, arranged as [`Numeric::jacobian`].
    pub fn tool_and_jacobian(&self, q: &[f64]) -> (Matrix4<f64>, Matrix6xX<f64>) {
        let poses = self.poses(q);
        let tool = poses.last().unwrap_or(&self.base).then(&self.tool);
        (homogeneous(&tool), self.jacobian_at(tool.origin, &poses))
    }

    /// Pose of the frame of a row (from 0), with its origin moved to a point of that frame, m, and the
    /// Jacobian of that point, arranged as [`Numeric::jacobian`]: 0 for the joints beyond.
    pub fn point_and_jacobian(&self, q: &[f64], row: usize, point: [f64; 3]) -> (Matrix4<f64>, Matrix6xX<f64>) {
        let mut poses = self.poses(q);
        poses.truncate(row + 1);
        let mut pose = *poses.last().unwrap_or(&self.base);
        pose.origin += pose.rotation * Vector3::from(point);
        (homogeneous(&pose), self.jacobian_at(pose.origin, &poses))
    }

    /// Jacobian of a point fixed to the last of these poses, given in the world frame.
    fn jacobian_at(&self, point: Vector3<f64>, poses: &[Plucker]) -> Matrix6xX<f64> {
        let mut jacobian = Matrix6xX::zeros(self.dof);
        for (row, pose) in self.rows.iter().zip(poses) {
            let Some(j) = row.joint else { continue };
            let w = pose.rotation * row.axis.w;
            let v = pose.rotation * row.axis.v + w.cross(&(point - pose.origin));
            jacobian.fixed_view_mut::<3, 1>(0, j).copy_from(&v);
            jacobian.fixed_view_mut::<3, 1>(3, j).copy_from(&w);
        }
        jacobian
    }

    /// `(dJ/dt) dq`, 6, m/s^2 and rad/s^2: acceleration of the last DH frame due to the velocities
    /// alone, arranged as [`Numeric::jacobian`].
    pub fn jacobian_dot_dq(&self, q: &[f64], dq: &[f64]) -> Vector6<f64> {
        self.check("dq", dq.len());
        let rotation = self.last_pose(q).rotation;
        let mut work = self.workspace();
        self.outward(&mut work, &Sweep { q, dq, ddq: &[], base_acceleration: Motion::zero() });
        let (Some(v), Some(a)) = (work.v.last(), work.a.last()) else { return Vector6::zeros() };
        // Convert the spatial acceleration to that of the point at the origin.
        let linear = rotation * (a.v + v.w.cross(&v.v));
        let angular = rotation * a.w;
        Vector6::new(linear.x, linear.y, linear.z, angular.x, angular.y, angular.z)
    }

    /// Poses of all frames in the world frame.
    pub(super) fn poses(&self, q: &[f64]) -> Vec<Plucker> {
        self.check("q", q.len());
        let mut pose = self.base;
        let next = |row: &super::Row| {
            pose = pose.then(&row.transform(row.of(q)));
            pose
        };
        self.rows.iter().map(next).collect()
    }

    fn last_pose(&self, q: &[f64]) -> Plucker {
        self.poses(q).last().copied().unwrap_or(self.base)
    }
}

fn homogeneous(pose: &Plucker) -> Matrix4<f64> {
    let mut t = Matrix4::identity();
    t.fixed_view_mut::<3, 3>(0, 0).copy_from(&pose.rotation);
    t.fixed_view_mut::<3, 1>(0, 3).copy_from(&pose.origin);
    t
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::rigid_body::random::Family;
    use crate::numerics::prng::Random;
    use nalgebra::{DVector, Matrix3};

    /// `q + s dq`.
    fn along(q: &[f64], dq: &[f64], s: f64) -> Vec<f64> {
        q.iter().zip(dq).map(|(q, dq)| q + s * dq).collect()
    }

    /// Relative deviation of a twist from the finite difference of a pose.
    fn misses(at: impl Fn(f64) -> Matrix4<f64>, twist: &Vector6<f64>) -> f64 {
        let h = 1e-6;
        let rate = (at(h) - at(-h)) / (2.0 * h);
        let rotation: Matrix3<f64> = at(0.0).fixed_view::<3, 3>(0, 0).into();
        let spin = rate.fixed_view::<3, 3>(0, 0) * rotation.transpose();
        let w = Vector3::new(spin[(2, 1)], spin[(0, 2)], spin[(1, 0)]);
        let v: Vector3<f64> = rate.fixed_view::<3, 1>(0, 3).into();
        let miss = (v - twist.fixed_rows::<3>(0)).amax().max((w - twist.fixed_rows::<3>(3)).amax());
        miss / (1.0 + twist.amax())
    }

    #[test]
    fn jacobians_meet_differences_of_their_frames() {
        let mut random = Random::new(51);
        for _ in 0..100 {
            let robot = random.robot(&Family::default());
            let (numeric, s) = (Numeric::new(&robot), random.state(&robot));
            let dq = DVector::from_column_slice(&s.dq);
            let last = |t: f64| *numeric.frames(&along(&s.q, &s.dq, t)).last().unwrap();
            assert!(misses(last, &(numeric.jacobian(&s.q) * &dq)) < 1e-6);
            let tool = |t: f64| numeric.tool(&along(&s.q, &s.dq, t));
            let (pose, jacobian) = numeric.tool_and_jacobian(&s.q);
            assert!(pose == tool(0.0) && misses(tool, &(jacobian * dq)) < 1e-6);
        }
    }

    #[test]
    fn jacobian_rate_meets_differences_of_the_jacobian() {
        let mut random = Random::new(52);
        let h = 1e-6;
        for _ in 0..100 {
            let robot = random.robot(&Family::default());
            let (numeric, s) = (Numeric::new(&robot), random.state(&robot));
            let rate =
                (numeric.jacobian(&along(&s.q, &s.dq, h)) - numeric.jacobian(&along(&s.q, &s.dq, -h))) / (2.0 * h);
            let expected = rate * DVector::from_column_slice(&s.dq);
            let (got, scale) = (numeric.jacobian_dot_dq(&s.q, &s.dq), 1.0 + expected.amax());
            assert!((got - expected).amax() < 1e-6 * scale);
        }
    }

    #[test]
    fn tool_stands_in_the_last_frame() {
        let mut random = Random::new(53);
        for _ in 0..20 {
            let robot = random.robot(&Family { tool: 1.0, ..Family::default() });
            let (numeric, q, tool) = (Numeric::new(&robot), random.state(&robot).q, robot.tool.as_ref().unwrap());
            let turn = |axis: Vector3<f64>, k: usize| Matrix4::new_rotation(axis * tool.rpy[k].value);
            let pose = Matrix4::new_translation(&Vector3::from(tool.xyz))
                * turn(Vector3::z(), 2)
                * turn(Vector3::y(), 1)
                * turn(Vector3::x(), 0);
            assert!((numeric.tool(&q) - numeric.frames(&q).last().unwrap() * pose).amax() < 1e-13);
        }
    }
}
