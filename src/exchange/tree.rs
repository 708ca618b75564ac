//! Bodies and joints of a model file, unconverted.

use std::collections::BTreeMap;

use dh_codegen::robot::Inertia;
use nalgebra::Vector3;

pub use super::displacement::Displacement;

/// Motion that a joint of a tree allows its child.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TreeJointKind {
    /// No motion.
    Fixed,
    /// Rotation about its axis; also URDF's `continuous`.
    Revolute,
    /// Translation along its axis.
    Prismatic,
    /// Other motion, with the format's name for it.
    Other(&'static str),
}

/// A joint that follows another one: `q = multiplier q_other + offset`.
#[derive(Debug, Clone, PartialEq)]
pub struct Mimic {
    /// Index of the other joint.
    pub joint: usize,
    /// Factor.
    pub multiplier: f64,
    /// Offset, rad or m.
    pub offset: f64,
}

/// A joint between two bodies.
#[derive(Debug, Clone, PartialEq)]
pub struct TreeJoint {
    /// Name in the file.
    pub name: String,
    /// Kind of motion.
    pub kind: TreeJointKind,
    /// Index of the body that carries it.
    pub parent: usize,
    /// Index of the body that it moves.
    pub child: usize,
    /// Pose of the joint's frame in the parent's.
    pub origin: Displacement,
    /// Pose of the child's frame in the joint's moved frame; the identity in URDF.
    pub behind: Displacement,
    /// Unit vector in the joint's frame.
    pub axis: Vector3<f64>,
    /// Position at which `origin` holds, rad or m (`ref` of MJCF).
    pub reference: f64,
    /// Lower and upper position, rad or m; `None` if there are none or they are unknown.
    pub position: Option<[f64; 2]>,
    /// Whether the joint has no position limits by its type.
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
    /// Stiffness, N m/rad or N/m, and rest position, rad or m.
    pub spring: Option<[f64; 2]>,
    /// Delay, s, with which the torque is read (positive) or acts after its command (negative).
    pub delay: Option<f64>,
    /// Coupling to another joint that it follows.
    pub mimic: Option<Mimic>,
}

impl TreeJoint {
    /// A fixed joint with its frame at `origin` in the parent.
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

    /// Whether it moves with one degree of freedom.
    pub fn moves(&self) -> bool {
        matches!(self.kind, TreeJointKind::Revolute | TreeJointKind::Prismatic)
    }

    /// Pose of the child's frame in the parent's at a position, rad or m.
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

/// A body of a tree.
#[derive(Debug, Clone, PartialEq)]
pub struct TreeBody {
    /// Name in the file.
    pub name: String,
    /// Inertial parameters in its frame, about the origin; `None` if the file gives none.
    pub inertia: Option<Inertia>,
    /// Whether it has a shape (visual, collision, geom). A body without a shape and without inertia
    /// is only a frame.
    pub shaped: bool,
    /// Whether it is only a named frame (`site` of MJCF), which does not end a chain.
    pub site: bool,
}

/// Joints that close a loop, or couple bodies otherwise.
#[derive(Debug, Clone, PartialEq)]
pub struct Tie {
    /// The format's name for it.
    pub what: String,
    /// Names of the joints involved.
    pub joints: Vec<String>,
    /// Names of the bodies involved.
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
    /// Loops and other couplings.
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

    /// The joint at the end of a joint's chain of couplings: itself if it follows none.
    pub fn master(&self, mut joint: usize) -> usize {
        for _ in 0..self.joints.len() {
            match &self.joints[joint].mimic {
                Some(mimic) => joint = mimic.joint,
                None => break,
            }
        }
        joint
    }

    /// Joints from `base` to `body`, in order; `None` if `base` is no ancestor.
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
