//! Joint axes as screws in frames further out: columns of the body Jacobian.

use super::chain::Links;
use super::wrench::Wrench;
use crate::robot::JointKind;
use crate::sym::{Ex, Vec3};

/// Velocity of a frame per unit joint velocity, in its axes: angular, and linear velocity of its
/// origin.
#[derive(Clone, Copy)]
pub(super) struct Screw<'g> {
    pub w: Vec3<'g>,
    pub v: Vec3<'g>,
}

impl<'g> Screw<'g> {
    /// Screw of the joint in its own frame.
    pub fn own(links: &Links<'g>, row: usize) -> Self {
        let link = &links.links[row];
        let (axis, zero) = (link.axis(), Vec3::zero(links.graph));
        match link.kind {
            JointKind::Revolute => Self { w: axis, v: zero },
            JointKind::Prismatic => Self { w: zero, v: axis },
            JointKind::Fixed => Self { w: zero, v: zero },
        }
    }

    /// Transforms the screw from the previous joint frame to that of `row`.
    pub fn outward(self, links: &Links<'g>, row: usize, shifted: bool) -> Self {
        let link = &links.links[row];
        let (w, v) = (link.untwist(self.w), link.untwist(self.v));
        let v = v + w.cross(link.step(shifted));
        Self { w: link.unturn(w), v: link.unturn(v) }
    }

    /// Velocity of the point `p`, in the same axes.
    pub fn at(self, p: Vec3<'g>) -> Vec3<'g> {
        self.v + self.w.cross(p)
    }

    /// Torque of the joint against a wrench in the same frame: `w . n + v . f`.
    pub fn dot(self, wrench: &Wrench<'g>) -> Ex<'g> {
        self.w.dot(wrench.n) + self.v.dot(wrench.f)
    }
}

/// Screws of every joint in every frame further out.
pub(super) struct Screws<'g> {
    /// Screws `table[frame][joint]`, joint < frame.
    table: Vec<Vec<Screw<'g>>>,
    shifted: Vec<Vec<Screw<'g>>>,
}

impl<'g> Screws<'g> {
    pub fn new(links: &Links<'g>) -> Self {
        let mut table: Vec<Vec<Screw<'g>>> = Vec::new();
        let mut shifted: Vec<Vec<Screw<'g>>> = Vec::new();
        for frame in 0..links.links.len() {
            links.graph.section(format!("joint axes in frame {}", frame + 1));
            let before: Vec<Screw<'g>> = match frame {
                0 => Vec::new(),
                _ => table[frame - 1].iter().copied().chain([Screw::own(links, frame - 1)]).collect(),
            };
            table.push(before.iter().map(|s| s.outward(links, frame, false)).collect());
            shifted.push(before.iter().map(|s| s.outward(links, frame, true)).collect());
            for (joint, screw) in table[frame].iter().enumerate() {
                screw.w.label(&format!("z{}_{}", joint + 1, frame + 1));
                screw.v.label(&format!("v{}_{}", joint + 1, frame + 1));
            }
        }
        Self { table, shifted }
    }

    /// Screw of joint `joint` in frame `frame`.
    pub fn get(&self, joint: usize, frame: usize, shifted: bool) -> Screw<'g> {
        if shifted { self.shifted[frame][joint] } else { self.table[frame][joint] }
    }
}
