//! Outward sweep: angular velocity, angular acceleration and acceleration of every link (Khalil and
//! Dombre, 9.5.2).

use super::chain::{Links, Row};
use super::turning::Turning;
use crate::robot::JointKind;
use crate::sym::{Ex, Mat3, Vec3};

/// Motion of a frame, in its own axes. Gravity is included in `a`: the base accelerates upwards.
#[derive(Clone, Copy)]
pub(super) struct Motion<'g> {
    /// Angular velocity, rad/s.
    pub w: Vec3<'g>,
    /// Angular acceleration, rad/s^2.
    pub dw: Vec3<'g>,
    /// Acceleration of the frame's origin minus gravity, m/s^2.
    pub a: Vec3<'g>,
    /// Matrix `U = [dw]x + [w]x [w]x`: the acceleration of a point at `p` is `a + U p`.
    pub u: Mat3<'g>,
}

/// Terms that a sweep includes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Include {
    pub velocity: bool,
    pub acceleration: bool,
    pub gravity: bool,
}

impl Include {
    pub const ALL: Self = Self { velocity: true, acceleration: true, gravity: true };
    pub const VELOCITY: Self = Self { velocity: true, acceleration: false, gravity: false };
    pub const GRAVITY: Self = Self { velocity: false, acceleration: false, gravity: true };
    pub const BIAS: Self = Self { velocity: true, acceleration: false, gravity: true };
}

impl<'g> Motion<'g> {
    /// Motion with `U` from its definition.
    pub fn new(w: Vec3<'g>, dw: Vec3<'g>, a: Vec3<'g>) -> Self {
        let ([x, y, z], [dx, dy, dz]) = (w.0, dw.0);
        let (xx, yy, zz, xy, xz, yz) = (x * x, y * y, z * z, x * y, x * z, y * z);
        let u = [[-(yy + zz), xy - dz, xz + dy], [xy + dz, -(xx + zz), yz - dx], [xz - dy, yz + dx, -(xx + yy)]];
        Self { w, dw, a, u: Mat3(u) }
    }

    /// Motion of a frame whose points on z move like those of the previous frame, independently of
    /// the joint. `third` is the previous frame's `U z`, in these axes. The rest of `U` follows
    /// from it, `w` and `dw_z` with fewer operations than from `w` and `dw`.
    fn about_z(w: Vec3<'g>, dz: Ex<'g>, a: Vec3<'g>, third: Vec3<'g>) -> Self {
        let ([x, y, z], [u02, u12, u22]) = (w.0, third.0);
        let (xx, zz, xy, xz, yz) = (x * x, z * z, x * y, x * z, y * z);
        let (dx, dy) = (yz - u12, u02 - xz);
        let u = [[u22 + (xx - zz), xy - dz, u02], [xy + dz, -(xx + zz), u12], [xz - dy, yz + dx, u22]];
        Self { w, dw: Vec3([dx, dy, dz]), a, u: Mat3(u) }
    }

    /// Acceleration of the point `p` of this frame, in its axes.
    pub fn at(&self, p: Vec3<'g>) -> Vec3<'g> {
        self.a + self.u * p
    }
}

/// Motion of the base and of every joint frame: `links.len() + 1` entries, the base first.
/// `shifted[row]` is the motion at the joint frame's origin before `TransZ(r)`.
pub(super) struct Sweep<'g> {
    pub joints: Vec<Motion<'g>>,
    pub shifted: Vec<Motion<'g>>,
    /// Directions about which each joint frame turns.
    pub turning: Vec<Turning<'g>>,
}

impl<'g> Sweep<'g> {
    pub fn new(links: &Links<'g>, include: Include) -> Self {
        let g = links.graph;
        let zero = Vec3::zero(g);
        let base = Motion::new(zero, zero, if include.gravity { links.lift } else { zero });
        let mut sweep = Self { joints: vec![base], shifted: Vec::new(), turning: Vec::new() };
        let mut turning = Turning::Still;
        for (row, link) in links.links.iter().enumerate() {
            let number = row + 1;
            g.section(format!("link {number}: motion"));
            let before = sweep.joints[row];
            let none = g.constant(0.0);
            let dq = if include.velocity { links.velocity(row) } else { none };
            let ddq = if include.acceleration { links.acceleration(row) } else { none };
            turning = turning.next(link, row, dq, ddq);
            let along_x = Vec3([link.d, none, none]);
            let a_shifted = link.inward(before.at(link.twisted(along_x)));
            let a = link.inward(before.at(link.twisted(link.step(false))));
            let axis = link.axis();
            let (w, dw) = (link.inward(before.w), link.inward(before.dw));
            let motion = match (link.kind, turning.two()) {
                // Multiples of one rotating vector: only that vector is transformed.
                (JointKind::Revolute, Some((first, own))) => {
                    let ([x, y, _], r) = (first.axis.0, first.rate);
                    let third = Vec3([y * first.acceleration, -(x * first.acceleration), -(r * r)]);
                    Motion::about_z(Vec3([x * r, y * r, own.rate]), own.acceleration, a, third)
                }
                (JointKind::Revolute, None) => {
                    let third = link.inward(before.u * link.twisted(axis));
                    Motion::about_z(w + axis.scale(dq), dw.0[2] + ddq, a, third)
                }
                (JointKind::Prismatic, _) => {
                    let slide = w.cross(axis).scale(dq * 2.0) + axis.scale(ddq);
                    Motion::new(w, dw, a + slide)
                }
                (JointKind::Fixed, _) => Motion::new(w, dw, a),
            };
            motion.w.label(&format!("w{number}"));
            motion.dw.label(&format!("dw{number}"));
            motion.a.label(&format!("a{number}"));
            sweep.shifted.push(Motion { a: a_shifted, ..motion });
            sweep.joints.push(motion);
            sweep.turning.push(turning);
        }
        sweep
    }

    /// Motion of the body's frame of a row; `shifted`: at the origin before `TransZ(r)` (only if
    /// body and joint frame coincide).
    pub fn body(&self, links: &Links<'g>, row: usize, shifted: bool) -> Motion<'g> {
        let link = &links.links[row];
        let motion = if shifted { self.shifted[row] } else { self.joints[row + 1] };
        if !link.has_body_frame() {
            return motion;
        }
        let (w, dw, a) = (motion.w, motion.dw, motion.at(link.body_origin()));
        Motion::new(link.into_body(w), link.into_body(dw), link.into_body(a))
    }
}

/// Whether a row's columns may be computed about the origin before `TransZ(r)`: only if that is
/// another point, and a fixed one.
pub(super) fn can_shift(row: &Row) -> bool {
    row.body.is_none() && row.kind != JointKind::Prismatic && row.r != 0.0
}

/// Joint component of a wrench in the joint's own frame: moment about z for a revolute joint, force
/// along z for a prismatic one, `None` if fixed.
pub(super) fn along_axis<'g>(kind: JointKind, f: Vec3<'g>, n: Vec3<'g>) -> Option<Ex<'g>> {
    match kind {
        JointKind::Revolute => Some(n.0[2]),
        JointKind::Prismatic => Some(f.0[2]),
        JointKind::Fixed => None,
    }
}
