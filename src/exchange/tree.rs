//! Bodies and joints of a model file, unconverted.

use std::collections::BTreeMap;

use dh_codegen::robot::Inertia;
use nalgebra::Vector3;

pub use super::displacement::Displacement;

/// Motion that a joint of a tree allows its child.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TreeJointKind {
    /// Does not move.
    Fixed,
    /// Turns about its axis; `continuous` of URDF too.
    Revolute,
    /// Slides along its axis.
    Prismatic,
    /// Moves otherwise: the name that the format has for it.
    Other(&'static str),
}

/// A joint that follows another one: `q = multiplier q_other + offset`.
#[derive(Debug, Clone, PartialEq)]
pub struct Mimic {
    /// Index of the other joint.
    pub joint: usize,
    /// Factor.
    pub multiplier: f64,
    /// rad or m
    pub offset: f64,
}

/// A joint between two bodies.
#[derive(Debug, Clone, PartialEq)]
pub struct TreeJoint {
    /// Name in the file.
    pub name: String,
    /// How it moves.
    pub kind: TreeJointKind,
    /// Index of the body that carries it.
    pub parent: usize,
    /// Index of the body that it moves.
    pub child: usize,
    /// The joint's frame in the parent's.
    pub origin: Displacement,
    /// The child's frame in the joint's moved frame; the identity in URDF.
    pub behind: Displacement,
    /// Unit vector in the joint's frame.
    pub axis: Vector3<f64>,
    /// Position at which `origin` holds, rad or m (`ref` of MJCF).
    pub reference: f64,
    /// Lower and upper position, rad or m; `None`: none, or not known.
    pub position: Option<[f64; 2]>,
    /// Has it no limits of position by its type?
    pub endless: bool,
    /// Largest speed, rad/s or m/s.
    pub velocity: Option<f64>,
    /// Largest torque or force, N m or N.
    pub effort: Option<f64>,
    /// Viscous friction, N m s/rad or N s/m.
    pub damping: Option<f64>,
    /// Dry friction, N m or N.
    pub friction: Option<f64>,
    /// Rotor inertia on the link side, kg m^2 or kg.
    pub armature: Option<f64>,
    /// Motor turns per joint turn.
    pub gear: Option<f64>,
    /// Stiffness, N m/rad or N/m, and position without torque.
    pub spring: Option<[f64; 2]>,
    /// How late the torque is read (above zero) or acts after its command (below zero), s.
    pub delay: Option<f64>,
    /// Follows another joint.
    pub mimic: Option<Mimic>,
}

impl TreeJoint {
    /// A joint that does not move, at the parent's frame.
    pub fn fixed(name: impl Into<String>, parent: usize, child: usize, origin: Displacement) -> Self {
        Self {
            name: name.into(),
            kind: TreeJointKind::Fixed,
            parent,
            child,
            origin,
            behind: Displacement::identity(),
            axis: Vector3::x(),
            reference: 0.0,
            position: None,
            endless: false,
            velocity: None,
            effort: None,
            damping: None,
            friction: None,
            armature: None,
            gear: None,
            spring: None,
            delay: None,
            mimic: None,
        }
    }

    /// Does it move in one direction?
    pub fn moves(&self) -> bool {
        matches!(self.kind, TreeJointKind::Revolute | TreeJointKind::Prismatic)
    }

    /// The child's frame in the parent's at a position, rad or m.
    pub fn displacement(&self, q: f64) -> Displacement {
        let by = q - self.reference;
        let moved = match self.kind {
            TreeJointKind::Revolute => Displacement::turn(&self.axis, by),
            TreeJointKind::Prismatic => Displacement::shift(self.axis * by),
            TreeJointKind::Fixed | TreeJointKind::Other(_) => Displacement::identity(),
        };
        self.origin.then(&moved).then(&self.behind)
    }
}

/// A body.
#[derive(Debug, Clone, PartialEq)]
pub struct TreeBody {
    /// Name in the file.
    pub name: String,
    /// Inertial parameters in its frame, about the origin; `None` where the file gives none.
    pub inertia: Option<Inertia>,
    /// Has it a shape (visual, collision, geom)? A body without one and without inertia is a mere
    /// frame.
    pub shaped: bool,
    /// Is it only a named frame (`site` of MJCF), which ends no chain by itself?
    pub site: bool,
}

/// Joints that close a loop, or tie bodies otherwise: kind, name, joints or bodies.
#[derive(Debug, Clone, PartialEq)]
pub struct Tie {
    /// Name of the format for it.
    pub what: String,
    /// Names of the joints that it concerns.
    pub joints: Vec<String>,
    /// Names of the bodies that it concerns.
    pub bodies: Vec<String>,
}

/// A model: bodies, and joints from parents to children.
#[derive(Debug, Clone, PartialEq)]
pub struct Tree {
    /// Name of the robot.
    pub name: String,
    /// `URDF` or `MJCF`.
    pub format: &'static str,
    /// Gravity in the frame of the root, m/s^2.
    pub gravity: [f64; 3],
    /// Bodies, in the file's order.
    pub bodies: Vec<TreeBody>,
    /// Joints, in the file's order.
    pub joints: Vec<TreeJoint>,
    /// Loops.
    pub ties: Vec<Tie>,
    /// Skipped entries, a sentence each.
    pub notes: Vec<String>,
}

impl Tree {
    /// Index of the body with this name.
    pub fn body(&self, name: &str) -> Option<usize> {
        self.bodies.iter().position(|b| b.name == name)
    }

    /// Index of the joint that moves a body.
    pub fn joint_above(&self, body: usize) -> Option<usize> {
        self.joints.iter().position(|j| j.child == body)
    }

    /// Indices of the joints that a body carries.
    pub fn joints_below(&self, body: usize) -> impl Iterator<Item = usize> + '_ {
        (0..self.joints.len()).filter(move |&j| self.joints[j].parent == body)
    }

    /// The joint that a joint follows in the end: itself where it follows none.
    pub fn master(&self, mut joint: usize) -> usize {
        for _ in 0..self.joints.len() {
            match &self.joints[joint].mimic {
                Some(mimic) => joint = mimic.joint,
                None => break,
            }
        }
        joint
    }

    /// Joints from `base` to `body`, in order; `None` where `base` is no ancestor.
    pub fn path(&self, base: usize, body: usize) -> Option<Vec<usize>> {
        let mut joints = Vec::new();
        let mut at = body;
        while at != base {
            let joint = self.joint_above(at)?;
            joints.push(joint);
            at = self.joints[joint].parent;
            if joints.len() > self.joints.len() {
                return None;
            }
        }
        joints.reverse();
        Some(joints)
    }

    /// Positions of all joints: those given, those that follow them, zero for the rest.
    pub fn positions(&self, given: &BTreeMap<usize, f64>) -> Vec<f64> {
        let one = |mut joint: usize| {
            let (mut factor, mut sum) = (1.0, 0.0);
            for _ in 0..self.joints.len() {
                match (&self.joints[joint].mimic, given.get(&joint)) {
                    (_, Some(q)) => return factor * q + sum,
                    (Some(mimic), None) => {
                        sum += factor * mimic.offset;
                        factor *= mimic.multiplier;
                        joint = mimic.joint;
                    }
                    (None, None) => return sum,
                }
            }
            sum
        };
        (0..self.joints.len()).map(one).collect()
    }

    /// Poses of all bodies below `base` in its frame, at the positions of [`Tree::positions`].
    pub fn poses(&self, base: usize, q: &[f64]) -> Vec<Option<Displacement>> {
        let mut poses = vec![None; self.bodies.len()];
        poses[base] = Some(Displacement::identity());
        let mut waiting = vec![base];
        while let Some(body) = waiting.pop() {
            for joint in self.joints_below(body) {
                let child = self.joints[joint].child;
                if poses[child].is_none() {
                    poses[child] =
                        poses[body].map(|p: Displacement| p.then(&self.joints[joint].displacement(q[joint])));
                    waiting.push(child);
                }
            }
        }
        poses
    }
}
