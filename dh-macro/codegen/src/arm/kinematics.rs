//! Frames, Jacobian and its derivative (Khalil and Dombre, chapters 3 and 5).

use super::chain::{Links, tool_rotation};
use super::motion::{Include, Sweep};
use crate::robot::JointKind;
use crate::sym::{Ex, Mat3, Vec3};

/// A frame in the world frame: axes as columns of `r`, origin `p`, m.
#[derive(Clone, Copy)]
pub struct Pose<'g> {
    /// Rotation matrix.
    pub r: Mat3<'g>,
    /// Origin, m.
    pub p: Vec3<'g>,
}

impl<'g> Pose<'g> {
    /// Top three rows of the homogeneous matrix, row-major.
    pub fn entries(&self) -> Vec<Ex<'g>> {
        (0..3).flat_map(|i| self.r.0[i].into_iter().chain([self.p.0[i]])).collect()
    }
}

/// Joint frames in the world frame.
fn joint_frames<'g>(links: &Links<'g>) -> Vec<Pose<'g>> {
    let g = links.graph;
    let at_world = ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0; 3]);
    let (rotation, origin) = links.base.unwrap_or(at_world);
    let mut r = Mat3::numbers(g, rotation);
    let mut p = Vec3::numbers(g, origin);
    let mut poses = Vec::with_capacity(links.links.len());
    for (row, link) in links.links.iter().enumerate() {
        g.section(format!("frame {}", row + 1));
        p = p + r * link.twisted(link.step(false));
        // Rows of R are expressed in the previous frame: each is transformed to the new axes.
        r = Mat3(r.0.map(|row| link.inward(Vec3(row)).0));
        poses.push(Pose { r, p });
    }
    poses
}

/// DH frames of all rows in the world frame.
pub(super) fn frames<'g>(links: &Links<'g>) -> Vec<Pose<'g>> {
    let joints = joint_frames(links);
    links
        .links
        .iter()
        .zip(joints)
        .map(|(link, pose)| match link.has_body_frame() {
            false => pose,
            true => Pose {
                r: Mat3(pose.r.0.map(|row| link.into_body(Vec3(row)).0)),
                p: pose.p + pose.r * link.body_origin(),
            },
        })
        .collect()
}

/// Tool frame in the world frame; the last DH frame if there is no tool.
pub(super) fn tool<'g>(links: &Links<'g>) -> Option<Pose<'g>> {
    let last = *frames(links).last()?;
    links.graph.section("tool");
    Some(match &links.tool {
        None => last,
        Some(tool) => {
            Pose { r: last.r * tool_rotation(links.graph, tool), p: last.p + last.r * Vec3::given(links.graph, tool.1) }
        }
    })
}

/// Jacobian of the last DH frame's origin in world axes: six rows (linear, angular) by `n`,
/// row-major.
pub(super) fn jacobian<'g>(links: &Links<'g>) -> Vec<Ex<'g>> {
    frames(links).last().map(|last| jacobian_of(links, last.p)).unwrap_or_default()
}

/// Jacobian of the tool frame's origin, in the same form.
pub(super) fn tool_jacobian<'g>(links: &Links<'g>) -> Vec<Ex<'g>> {
    tool(links).map(|tool| jacobian_of(links, tool.p)).unwrap_or_default()
}

/// Jacobian of a point fixed to the last link, world axes: its velocity, m/s, then the link's
/// angular velocity, rad/s, per unit velocity of each joint.
fn jacobian_of<'g>(links: &Links<'g>, end: Vec3<'g>) -> Vec<Ex<'g>> {
    let n = links.inputs.dof;
    let joints = joint_frames(links);
    let mut entries = vec![links.number(0.0); 6 * n];
    links.graph.section("columns");
    for (row, k) in links.moving() {
        let axis = joints[row].r.column(2);
        let (linear, angular) = match links.links[row].kind {
            JointKind::Prismatic => (axis, Vec3::zero(links.graph)),
            _ => (axis.cross(end - joints[row].p), axis),
        };
        for i in 0..3 {
            entries[i * n + k] = linear.0[i];
            entries[(i + 3) * n + k] = angular.0[i];
        }
    }
    entries
}

/// Velocity-dependent acceleration `dJ/dt dq` of the last DH frame (for zero `ddq`), linear part
/// first, world axes.
pub(super) fn jacobian_dot_velocity<'g>(links: &Links<'g>) -> Vec<Ex<'g>> {
    let Some(last) = links.links.len().checked_sub(1) else { return Vec::new() };
    let body = Sweep::new(links, Include::VELOCITY).body(links, last, false);
    let Some(pose) = frames(links).last().copied() else { return Vec::new() };
    links.graph.section("in world axes");
    let (a, dw) = (pose.r * body.a, pose.r * body.dw);
    a.0.into_iter().chain(dw.0).collect()
}
