//! The far end of a link, where a contact with it is taken to act.

use dh_codegen::robot::{Convention, Robot};

/// A point that is fixed to a link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FarEnd {
    /// Row of the DH table in whose frame the point is given, from 0.
    pub(crate) row: usize,
    /// The point, in that frame, m.
    pub(crate) point: [f64; 3],
}

impl FarEnd {
    /// That of the link of a row, from 0: the origin of the next row's frame with its joint at zero. In
    /// the standard convention, and for the last link, it is the origin of the link's own frame.
    pub(crate) fn of(robot: &Robot, row: usize) -> Self {
        let point = match (robot.convention, robot.joints.get(row + 1)) {
            (Convention::Modified, Some(next)) => {
                let (s, c) = next.alpha.sin_cos();
                [next.d.value, -next.r.value * s, next.r.value * c]
            }
            _ => [0.0; 3],
        };
        Self { row, point }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::rigid_body::Numeric;
    use dh_codegen::robot::{JointKind, no_files};

    /// In either convention it is where the next frame's origin is with the next joint at zero, at
    /// any angle of a joint that turns. Its Jacobian is the derivative of its position, and zero for
    /// the joints beyond.
    #[test]
    fn it_is_where_the_next_joint_is() {
        for text in [
            include_str!("../../robots/kuka-lwr4.yaml"),
            include_str!("../../robots/franka-panda.yaml"),
            include_str!("../../robots/scara.yaml"),
            include_str!("../../robots/stanford.yaml"),
        ] {
            let robot = Robot::from_yaml(text, &no_files).unwrap().robot;
            let name = &robot.name;
            let (numeric, dof) = (Numeric::new(&robot), robot.dof());
            let q: Vec<f64> = (0..dof).map(|j| 0.3 + 0.2 * j as f64).collect();
            for row in 0..dof {
                let end = FarEnd::of(&robot, row);
                let position = |q: &[f64]| {
                    numeric.point_and_jacobian(q, end.row, end.point).0.fixed_view::<3, 1>(0, 3).clone_owned()
                };
                let next = match robot.convention {
                    Convention::Modified => (row + 1).min(dof - 1),
                    Convention::Standard => row,
                };
                let mut resting = q.clone();
                if robot.joints[next].kind == JointKind::Prismatic && next > row {
                    resting[next] = 0.0;
                }
                let frame = numeric.frames(&resting)[next].fixed_view::<3, 1>(0, 3).clone_owned();
                assert!((position(&q) - frame).norm() < 1e-12, "{name} {row}");
                let jacobian = numeric.point_and_jacobian(&q, end.row, end.point).1;
                for j in 0..dof {
                    let at = |by: f64| {
                        let mut q = q.clone();
                        q[j] += by;
                        position(&q)
                    };
                    let slope = (at(1e-6) - at(-1e-6)) / 2e-6;
                    assert!((slope - jacobian.fixed_view::<3, 1>(0, j)).norm() < 1e-8, "{name} {row} {j}");
                    assert!(j <= row || jacobian.column(j).norm() == 0.0);
                }
            }
        }
    }
}
