//! Outward sweep: angular velocity, angular acceleration and acceleration of every link (Khalil and Dombre, 9.5.2).

use super::chain::{Links, Row};
use crate::robot::JointKind;
use crate::sym::{Ex, Mat3, Vec3};

/// Motion of a frame, in its own axes. Gravity is in `a`: the base accelerates upwards.
#[derive(Clone, Copy)]
pub(super) struct Motion<'g> {
    /// Angular velocity, rad/s.
    pub w: Vec3<'g>,
    /// Angular acceleration, rad/s^2.
    pub dw: Vec3<'g>,
    /// Acceleration of the frame's origin minus gravity, m/s^2.
    pub a: Vec3<'g>,
}

/// What a sweep takes into account.
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
    /// `U = [dw]x + [w]x [w]x`: the acceleration of a point at `p` is `a + U p`.
    pub fn u(&self) -> Mat3<'g> {
        let ([x, y, z], [dx, dy, dz]) = (self.w.0, self.dw.0);
        let (xx, yy, zz, xy, xz, yz) = (x * x, y * y, z * z, x * y, x * z, y * z);
        Mat3([[-(yy + zz), xy - dz, xz + dy], [xy + dz, -(xx + zz), yz - dx], [xz - dy, yz + dx, -(xx + yy)]])
    }

    /// Acceleration of the point `p` of this frame, in its axes.
    pub fn at(&self, p: Vec3<'g>) -> Vec3<'g> {
        self.a + self.u() * p
    }
}

/// Motion of the base and of every joint frame: `links.len() + 1` entries, the base first. `shifted[row]` is the same motion
/// at the joint frame's origin before `TransZ(r)`.
pub(super) struct Sweep<'g> {
    pub joints: Vec<Motion<'g>>,
    pub shifted: Vec<Motion<'g>>,
}

impl<'g> Sweep<'g> {
    pub fn new(links: &Links<'g>, include: Include) -> Self {
        let g = links.graph;
        let zero = Vec3::zero(g);
        let base = Motion { w: zero, dw: zero, a: if include.gravity { links.lift } else { zero } };
        let mut sweep = Self { joints: vec![base], shifted: Vec::new() };
        for (row, link) in links.links.iter().enumerate() {
            let number = row + 1;
            g.section(format!("link {number}: motion"));
            let before = sweep.joints[row];
            let none = g.constant(0.0);
            let dq = if include.velocity { links.velocity(row) } else { none };
            let ddq = if include.acceleration { links.acceleration(row) } else { none };
            let w = link.inward(before.w);
            let dw = link.inward(before.dw);
            let u = before.u();
            let along_x = Vec3([link.d, none, none]);
            let to_shifted = link.twisted(along_x);
            let to_origin = link.twisted(link.step(false));
            let a_shifted = link.inward(before.a + u * to_shifted);
            let a = link.inward(before.a + u * to_origin);
            let axis = link.axis();
            let (w, dw, a, a_shifted) = match link.kind {
                JointKind::Revolute => {
                    (w + axis.scale(dq), dw + w.cross(axis).scale(dq) + axis.scale(ddq), a, a_shifted)
                }
                JointKind::Prismatic => {
                    let slide = w.cross(axis).scale(dq * 2.0) + axis.scale(ddq);
                    (w, dw, a + slide, a_shifted)
                }
                JointKind::Fixed => (w, dw, a, a_shifted),
            };
            let w = w.label(&format!("w{number}"));
            let dw = dw.label(&format!("dw{number}"));
            let a = a.label(&format!("a{number}"));
            sweep.shifted.push(Motion { w, dw, a: a_shifted });
            sweep.joints.push(Motion { w, dw, a });
        }
        sweep
    }

    /// Motion of the body's frame of a row; `shifted`: at the origin before `TransZ(r)` (only where body and joint frame are one).
    pub fn body(&self, links: &Links<'g>, row: usize, shifted: bool) -> Motion<'g> {
        let link = &links.links[row];
        let motion = if shifted { self.shifted[row] } else { self.joints[row + 1] };
        if !link.has_body_frame() {
            return motion;
        }
        Motion {
            w: link.into_body(motion.w),
            dw: link.into_body(motion.dw),
            a: link.into_body(motion.at(link.body_origin())),
        }
    }
}

/// May a row's columns be computed about the origin before `TransZ(r)`? (Only if that is another point, and a fixed one.)
pub(super) fn can_shift(row: &Row) -> bool {
    row.body.is_none() && row.kind != JointKind::Prismatic && row.r != 0.0
}

/// What a joint feels of a wrench in its own frame: moment about z, force along z, nothing where it is fixed.
pub(super) fn along_axis<'g>(kind: JointKind, f: Vec3<'g>, n: Vec3<'g>) -> Option<Ex<'g>> {
    match kind {
        JointKind::Revolute => Some(n.0[2]),
        JointKind::Prismatic => Some(f.0[2]),
        JointKind::Fixed => None,
    }
}
