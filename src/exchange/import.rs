//! Import of a tree to a robot file, and the error of the result.

use dh_codegen::robot::effects::{JointSpring, TimeDelay};
use dh_codegen::robot::{
    Collision, Convention, Drive, Inertia, Joint, JointKind, Limits, Robot, Tool, crate_name, no_files,
};
use nalgebra::Vector3;

use super::chain::Chain;
use super::displacement::Displacement;
use super::exact::{Snap, exact_angle, length, pose};
use super::to_dh::{DhRow, DhTable, Line, Neighbours, less, table};
use super::tree::{Tree, TreeJoint, TreeJointKind};
use super::{ImportError, ModelFormat};
use crate::model::rigid_body::Numeric;
use crate::numerics::prng::Random;

/// Tolerance within which a table's angle becomes a fraction of pi, rad: rounding of the
/// arithmetic.
const EXACT: f64 = 1e-12;

/// Number of states at which source and result are compared.
pub const STATES: usize = 50;

/// Permitted difference of forward kinematics, m and entries of the rotation.
pub const REQUIRED: f64 = 1e-9;

/// Options of an import.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportOptions {
    /// Link from which row 1 starts; default: the root.
    pub base: Option<String>,
    /// Link whose frame becomes the tool frame; default: the only leaf behind the most moving
    /// joints.
    pub tip: Option<String>,
    /// Positions of joints beside the chain, rad or m.
    pub at: Vec<(String, f64)>,
    /// Whether joints beside the chain without a position are held at zero, or at the limit nearest
    /// to it.
    pub at_zero: bool,
    /// Distance within which an angle of the source is replaced by an exact fraction of pi, rad.
    pub snap: f64,
}

impl Default for ImportOptions {
    fn default() -> Self {
        Self { base: None, tip: None, at: Vec::new(), at_zero: false, snap: 1e-9 }
    }
}

/// Difference of the forward kinematics of result and source.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForwardKinematicsError {
    /// Largest distance between the tip's origins over all states, m.
    pub position: f64,
    /// Largest difference between entries of the rotations.
    pub rotation: f64,
}

/// A robot file made from a model, with the report of the import.
#[derive(Debug, Clone, PartialEq)]
pub struct Imported {
    /// The robot.
    pub robot: Robot,
    /// `URDF` or `MJCF`.
    pub format: &'static str,
    /// Name of the model in its file.
    pub model: String,
    /// Link that is the world of the robot file.
    pub base: String,
    /// Link of the tool frame.
    pub tip: String,
    /// Relation of neighbouring axes; with the angle between nearly parallel ones, rad.
    pub neighbours: Vec<(Neighbours, f64)>,
    /// Bodies of each row, base to tip.
    pub bodies: Vec<Vec<String>>,
    /// Joints beside the chain and their held positions, rad or m.
    pub held: Vec<(String, f64)>,
    /// Angles replaced by exact ones.
    pub snap: Snap,
    /// Values missing in the source, a sentence each.
    pub unknown: Vec<String>,
    /// Physically impossible bodies and values, a sentence each.
    pub impossible: Vec<String>,
    /// Skipped entries, a sentence each.
    pub notes: Vec<String>,
    /// Difference from the source at [`STATES`] random states.
    pub error: ForwardKinematicsError,
}

/// Imports a URDF or MJCF text.
///
/// # Errors
/// Returns the mistakes of the file with their places, or the parts that are not a serial arm, by
/// name.
pub fn import(text: &str, options: &ImportOptions) -> Result<Imported, ImportError> {
    let mut snap = Snap::new(options.snap);
    let read = |snap: &mut Snap| ModelFormat::of(text).tree(text, snap);
    let tree = read(&mut snap)?;
    // The reference keeps the angles of the file.
    let source = read(&mut Snap::new(0.0))?;
    let chain = Chain::new(&tree, options)?;
    let posed = Posed::new(&tree, &chain);
    let made = table(&posed.lines, &posed.tip, posed.size);
    let mut found = Found::default();
    let robot = posed.robot(&made, options, &mut found)?;
    let error = forward_kinematics_error(&source, &chain, &robot);
    let name = |body: usize| tree.bodies[body].name.clone();
    Ok(Imported {
        format: tree.format,
        model: tree.name.clone(),
        base: name(chain.base),
        tip: name(chain.tip),
        neighbours: made.neighbours,
        bodies: (1..=chain.moving.len()).map(|row| posed.carried(row).map(name).collect()).collect(),
        held: chain.held.iter().map(|&(j, q)| (tree.joints[j].name.clone(), q)).collect(),
        snap,
        unknown: found.unknown,
        impossible: found.impossible,
        notes: tree.notes.iter().cloned().chain(fingers(&tree, &chain)).chain(found.notes).collect(),
        robot,
        error,
    })
}

/// Note about the fingers before which the arm was assumed to end.
fn fingers(tree: &Tree, chain: &Chain) -> Option<String> {
    let names: Vec<String> = chain.fingers.iter().map(|&j| format!("`{}`", tree.joints[j].name)).collect();
    let tip = &tree.bodies[chain.tip].name;
    let said = |all: String| {
        format!(
            "{all} move the fingers of a gripper, so the arm ends at `{tip}`, which carries them; --tip names another end"
        )
    };
    (!names.is_empty()).then(|| said(names.join(" and ")))
}

/// Reports of an import besides the robot.
#[derive(Debug, Default)]
struct Found {
    unknown: Vec<String>,
    impossible: Vec<String>,
    notes: Vec<String>,
}

/// A tree with its chain at the reference posture, in the frame of the base.
struct Posed<'a> {
    tree: &'a Tree,
    chain: &'a Chain,
    poses: Vec<Option<Displacement>>,
    lines: Vec<Line>,
    tip: Displacement,
    /// Size of the robot, m.
    size: f64,
}

impl<'a> Posed<'a> {
    fn new(tree: &'a Tree, chain: &'a Chain) -> Self {
        let poses = tree.poses(chain.base, &chain.positions);
        let at = |body: usize| poses[body].unwrap_or_else(Displacement::identity);
        let line = |&joint: &usize| {
            let read = &tree.joints[joint];
            let frame = at(read.parent).then(&read.origin);
            let kind = match read.kind {
                TreeJointKind::Prismatic => JointKind::Prismatic,
                _ => JointKind::Revolute,
            };
            // Normalised to the last digit, as a product of rotations drifts.
            Line { point: frame.origin, axis: (frame.rotation * read.axis).normalize(), kind }
        };
        let lines: Vec<Line> = chain.moving.iter().map(line).collect();
        let tip = at(chain.tip);
        let reach = lines.iter().map(|l| l.point.norm()).fold(tip.origin.norm(), f64::max);
        Self { tree, chain, lines, tip, size: reach.max(0.01), poses }
    }

    /// Bodies that a row carries; `row` is counted from 1.
    fn carried(&self, row: usize) -> impl Iterator<Item = usize> + '_ {
        (0..self.tree.bodies.len()).filter(move |&b| self.chain.carried_by[b] == Some(row))
    }

    fn robot(&self, made: &DhTable, options: &ImportOptions, found: &mut Found) -> Result<Robot, ImportError> {
        let slack = 1e-15 * (1.0 + 8.0 * self.size);
        let mut joints = Vec::new();
        let mut links = Vec::new();
        for row in &made.rows {
            match row.line {
                Some(line) => {
                    joints.push(self.joint(row, line, slack, found));
                    links.push(self.link(row, line, found));
                }
                None => {
                    let next = &self.tree.joints[self.chain.moving[joints.len().min(self.chain.moving.len() - 1)]].name;
                    joints.push(between(row, next, slack));
                    links.push(Some(Inertia::default()));
                }
            }
        }
        distinct(&mut joints);
        let tool = made.tool.as_ref().map(|at| {
            let pose = pose(at, slack);
            let name = self.tree.bodies[self.chain.tip].name.clone();
            Tool { name, xyz: pose.xyz, rpy: pose.rpy, inertia: None, geometry: None }
        });
        let robot = Robot {
            name: shortened(&crate_name(&self.tree.name)),
            convention: Convention::Modified,
            constants: Vec::new(),
            gravity: self.gravity(options, slack, found)?,
            base: made.base.as_ref().map(|at| pose(at, slack)),
            joints,
            links: if links.iter().any(Option::is_some) { links } else { Vec::new() },
            tool,
            collision: Collision::default(),
            log: None,
            effects: Vec::new(),
        };
        // The file is authoritative: it must read back as this robot.
        match Robot::from_yaml(&robot.to_yaml(), &no_files) {
            Ok(reading) => Ok(reading.robot),
            Err(problems) => Err(ImportError::arm(format!("the robot file would not be valid: {problems}"), "")),
        }
    }

    /// Gravity in the axes of the base link.
    fn gravity(&self, options: &ImportOptions, slack: f64, found: &mut Found) -> Result<[f64; 3], ImportError> {
        let mut above = self.chain.base;
        let mut up = Displacement::identity();
        while let Some(joint) = self.tree.joint_above(above) {
            let read = &self.tree.joints[joint];
            let given = options.at.iter().find(|(name, _)| *name == read.name).map(|(_, q)| *q);
            if read.kind != TreeJointKind::Fixed && given.is_none() {
                let joint = &read.name;
                found
                    .notes
                    .push(format!("gravity is that of the base where `{joint}` above it is at {}", read.reference));
            }
            up = read.displacement(given.unwrap_or(read.reference)).then(&up);
            above = read.parent;
            if above == self.chain.base {
                break;
            }
        }
        let gravity = Vector3::from(self.tree.gravity);
        let turned = up.rotation.tr_mul(&gravity);
        Ok(turned.map(|g| super::exact::short(g, slack.max(1e-14))).into())
    }

    fn joint(&self, row: &DhRow, line: usize, slack: f64, found: &mut Found) -> Joint {
        let read = &self.tree.joints[self.chain.moving[line]];
        let kind = self.lines[line].kind;
        let (mut theta, mut r) = (exact_angle(row.theta, EXACT), row.r);
        match kind {
            JointKind::Prismatic => r -= read.reference,
            _ => theta = less(theta, read.reference, EXACT),
        }
        Joint {
            name: read.name.clone(),
            kind,
            actuated: true,
            alpha: exact_angle(row.alpha, EXACT),
            d: length(row.d, slack),
            theta,
            r: length(r, slack),
            source: None,
            limits: limits(read, found),
            drive: drive(read, found),
        }
    }

    /// Sum of the inertias of all bodies that the row carries, in its frame.
    fn link(&self, row: &DhRow, line: usize, found: &mut Found) -> Option<Inertia> {
        let joint = &self.tree.joints[self.chain.moving[line]].name;
        let mut sum: Option<Inertia> = None;
        for body in self.carried(line + 1) {
            let read = &self.tree.bodies[body];
            let Some(inertia) = &read.inertia else {
                if read.shaped {
                    found.unknown.push(format!(
                        "the inertia of `{}`, which `{joint}` moves and which has a shape; it counts as nothing",
                        read.name
                    ));
                }
                continue;
            };
            if let Err(defect) = inertia.physical() {
                found.impossible.push(format!("no body is like `{}`: {defect}", read.name));
            }
            let at = row.frame.inverse().then(&self.poses[body].unwrap_or_else(Displacement::identity));
            let moved = inertia.moved(&at.rows(), &at.origin.into());
            sum = Some(sum.map_or(moved, |sum| sum.plus(&moved)));
        }
        if sum.is_none() {
            found.unknown.push(format!("the inertia of everything that `{joint}` moves"));
        }
        sum
    }
}

/// A fixed row between nearly parallel axes.
fn between(row: &DhRow, next: &str, slack: f64) -> Joint {
    Joint {
        name: format!("before {next}"),
        kind: JointKind::Fixed,
        actuated: false,
        alpha: exact_angle(row.alpha, EXACT),
        d: length(row.d, slack),
        theta: exact_angle(row.theta, EXACT),
        r: length(row.r, slack),
        source: None,
        limits: Limits::default(),
        drive: Drive::default(),
    }
}

fn limits(read: &TreeJoint, found: &mut Found) -> Limits {
    let name = &read.name;
    let position = match read.position {
        Some([lower, upper]) if lower < upper => Some([lower, upper]),
        Some([lower, upper]) if lower > upper => {
            found.impossible.push(format!("`{name}`: the lower limit {lower} is above the upper one, {upper}"));
            None
        }
        Some([limit, _]) if !read.endless => {
            found.unknown.push(format!("the limits of position of `{name}` (both are {limit})"));
            None
        }
        Some(_) => None,
        None => {
            if !read.endless {
                found.unknown.push(format!("the limits of position of `{name}`"));
            }
            None
        }
    };
    let mut positive = |value: Option<f64>, what: &str| {
        let known = value.filter(|v| *v > 0.0);
        if known.is_none() {
            let said = value.map_or(String::new(), |v| format!(" (the file says {v})"));
            found.unknown.push(format!("the largest {what} of `{name}`{said}"));
        }
        known
    };
    let effort = if read.kind == TreeJointKind::Prismatic { "force" } else { "torque" };
    let (velocity, torque) = (positive(read.velocity, "speed"), positive(read.effort, effort));
    Limits { position, velocity, acceleration: None, jerk: None, torque }
}

fn drive(read: &TreeJoint, found: &mut Found) -> Drive {
    let mut known = |value: Option<f64>, what: &str| match value {
        Some(v) if v < 0.0 => {
            found.impossible.push(format!("`{}`: the {what} is {v}; left out", read.name));
            None
        }
        value => value.filter(|v| *v != 0.0),
    };
    let mut drive = Drive {
        viscous_friction: known(read.damping, "damping"),
        coulomb_friction: known(read.friction, "friction"),
        rotor_inertia: known(read.armature, "armature"),
        gear_ratio: read.gear,
        ..Drive::default()
    };
    if let Some([stiffness, position]) = read.spring.filter(|[stiffness, _]| *stiffness != 0.0) {
        drive
            .effects
            .push(JointSpring { stiffness: Some(stiffness), rest: Some(position), ..Default::default() }.into());
    }
    if let Some(delay) = read.delay {
        drive.effects.push(TimeDelay { delay: Some(delay) }.into());
    }
    drive
}

/// A name that is valid for a crate.
fn shortened(name: &str) -> String {
    name.chars().take(64).collect::<String>().trim_end_matches('-').to_string()
}

/// Makes the names of fixed rows unique.
fn distinct(joints: &mut [Joint]) {
    for k in 0..joints.len() {
        while joints[k].kind == JointKind::Fixed && joints.iter().filter(|j| j.name == joints[k].name).count() > 1 {
            joints[k].name += "'";
        }
    }
}

/// Pose of the tip in the base: the tree against the robot file, at random positions within a turn
/// or a metre.
fn forward_kinematics_error(tree: &Tree, chain: &Chain, robot: &Robot) -> ForwardKinematicsError {
    let numeric = Numeric::new(robot);
    let mut random = Random::new(1);
    let mut worst = ForwardKinematicsError { position: 0.0, rotation: 0.0 };
    for _ in 0..STATES {
        let mut positions = chain.positions.clone();
        let q: Vec<f64> = chain
            .moving
            .iter()
            .map(|&j| {
                let most = if tree.joints[j].kind == TreeJointKind::Prismatic { 1.0 } else { core::f64::consts::PI };
                positions[j] = random.uniform(-most, most);
                positions[j]
            })
            .collect();
        let source = tree.poses(chain.base, &positions)[chain.tip].unwrap_or_else(Displacement::identity);
        let result = numeric.tool(&q);
        let origin: Vector3<f64> = result.fixed_view::<3, 1>(0, 3).into();
        worst.position = worst.position.max((origin - source.origin).norm());
        worst.rotation = worst.rotation.max((result.fixed_view::<3, 3>(0, 0) - source.rotation).amax());
    }
    worst
}
