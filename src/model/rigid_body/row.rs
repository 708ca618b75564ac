//! One row of the DH table as a joint in Featherstone's sense: a transform depending on `q` and a
//! constant axis.

use dh_codegen::robot::{Convention, Joint, JointKind};
use nalgebra::{Matrix3, Vector3};

use super::spatial::{Motion, Plucker};

/// One row of the DH table.
#[derive(Debug, Clone)]
pub(super) struct Row {
    convention: Convention,
    kind: JointKind,
    /// Index into `q`; `None` for a fixed row.
    pub(super) joint: Option<usize>,
    /// Sine and cosine of the twist; exact for exact angles.
    alpha: (f64, f64),
    d: f64,
    /// Sine and cosine of the constant part of theta.
    theta: (f64, f64),
    r: f64,
    /// The joint's axis `S` in the frame of this row, constant in both conventions; zero for a
    /// fixed row.
    pub(super) axis: Motion,
}

impl Row {
    /// The row with this DH data; its position is `q[joint]`.
    pub(super) fn new(convention: Convention, row: &Joint, joint: Option<usize>) -> Self {
        let z = Vector3::z();
        let along_z = match row.kind {
            JointKind::Revolute => Motion { w: z, v: Vector3::zeros() },
            JointKind::Prismatic => Motion { w: Vector3::zeros(), v: z },
            JointKind::Fixed => Motion::zero(),
        };
        let alpha = row.alpha.sin_cos();
        let axis = match convention {
            // The joint motion comes last in the row: its axis is the frame's own z.
            Convention::Modified => along_z,
            // TransX(d) RotX(alpha) follows the joint: the axis is the previous row's z.
            Convention::Standard => {
                Plucker { rotation: rot_x(alpha), origin: Vector3::new(row.d.value, 0.0, 0.0) }.motion(&along_z)
            }
        };
        let (d, theta, r) = (row.d.value, row.theta.sin_cos(), row.r.value);
        Self { convention, kind: row.kind, joint, alpha, d, theta, r, axis }
    }

    /// Position of this row's joint, rad or m; zero for a fixed row.
    pub(super) fn of(&self, q: &[f64]) -> f64 {
        self.joint.and_then(|j| q.get(j)).copied().unwrap_or(0.0)
    }

    /// Transform from the previous frame to the frame of this row at the position `q`, rad or m.
    pub(super) fn transform(&self, q: f64) -> Plucker {
        let (turn, r) = match self.kind {
            JointKind::Revolute => {
                let ((s0, c0), (s, c)) = (self.theta, q.sin_cos());
                ((s * c0 + c * s0, c * c0 - s * s0), self.r)
            }
            JointKind::Prismatic => (self.theta, self.r + q),
            JointKind::Fixed => (self.theta, self.r),
        };
        let ((st, ct), (sa, ca)) = (turn, self.alpha);
        match self.convention {
            Convention::Modified => Plucker {
                rotation: Matrix3::new(ct, -st, 0.0, ca * st, ca * ct, -sa, sa * st, sa * ct, ca),
                origin: Vector3::new(self.d, -sa * r, ca * r),
            },
            Convention::Standard => Plucker {
                rotation: Matrix3::new(ct, -st * ca, st * sa, st, ct * ca, -ct * sa, 0.0, sa, ca),
                origin: Vector3::new(self.d * ct, self.d * st, r),
            },
        }
    }
}

fn rot_x((s, c): (f64, f64)) -> Matrix3<f64> {
    Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::rigid_body::random::Family;
    use crate::numerics::prng::Random;
    use nalgebra::Matrix4;

    /// The formula of robots/README.md, factor by factor, in homogeneous matrices.
    #[test]
    fn transforms_are_products_of_elementary_ones() {
        let mut random = Random::new(11);
        for _ in 0..50 {
            let robot = random.robot(&Family::default());
            for joint in &robot.joints {
                let q = if joint.kind == JointKind::Fixed { 0.0 } else { random.uniform(-2.0, 2.0) };
                let (turn, slide) = if joint.kind == JointKind::Revolute { (q, 0.0) } else { (0.0, q) };
                let (theta, r) = (joint.theta.value + turn, joint.r.value + slide);
                let (rx, rz) = (
                    Matrix4::new_rotation(Vector3::x() * joint.alpha.value),
                    Matrix4::new_rotation(Vector3::z() * theta),
                );
                let tx = Matrix4::new_translation(&Vector3::new(joint.d.value, 0.0, 0.0));
                let tz = Matrix4::new_translation(&Vector3::new(0.0, 0.0, r));
                let expected = match robot.convention {
                    Convention::Modified => rx * tx * rz * tz,
                    Convention::Standard => rz * tz * tx * rx,
                };
                let x = Row::new(robot.convention, joint, None).transform(q);
                assert!((x.rotation - expected.fixed_view::<3, 3>(0, 0)).amax() < 1e-14);
                assert!((x.origin - expected.fixed_view::<3, 1>(0, 3)).amax() < 1e-14);
            }
        }
    }
}
