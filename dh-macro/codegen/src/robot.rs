//! A validated serial robot: SI units, exact angles; and its file.
//!
//! `text -> yaml (tree with places) -> check (by the tables in keys, numbers by expression) ->
//! Robot | Problems`, and back by `write`. This file is independent of file formats.

mod angle;
mod check;
mod decimal;
pub mod document;
pub mod effects;
mod expression;
mod files;
mod inertia;
mod keys;
mod laws;
mod length;
mod log;
mod name;
mod open;
mod physical;
mod problem;
mod ratio;
mod reader;
mod real;
mod rewrite;
mod schema;
mod torque_law;
mod value;
mod write;
mod yaml;

pub use angle::Angle;
pub use check::Reading;
pub use effects::{Effect, EffectKind, RATED};
pub use files::{Files, no_files};
pub use inertia::Inertia;
pub use laws::{Coupling, Laws};
pub use length::{Length, Polynomial};
pub use log::{Dimension, LogChannel, LogMapping, UnknownColumn, log_column};
pub use name::crate_name;
pub use physical::NotPhysical;
pub use problem::{Note, Problem, Problems};
pub use rewrite::{Run, files_of_runs};
pub use schema::schema;
pub use torque_law::{LawFunction, NotALaw, Term, TorqueLaw, Variable};

/// Denavit-Hartenberg convention of the rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Convention {
    /// Khalil-Kleinfinger: `T(i-1,i) = RotX(alpha) TransX(d) RotZ(theta) TransZ(r)`.
    Modified,
    /// Classical: `T(i-1,i) = RotZ(theta) TransZ(r) TransX(d) RotX(alpha)`.
    Standard,
}

/// Motion that a joint allows its link (Khalil's sigma).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JointKind {
    /// Turns about z: sigma = 0; `q` adds to `theta`.
    Revolute,
    /// Slides along z: sigma = 1; `q` adds to `r`.
    Prismatic,
    /// Does not move: sigma = 2; has no `q`.
    Fixed,
}

/// Limits of one joint; `None` where the file says nothing.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Limits {
    /// Lower and upper position, rad or m.
    pub position: Option<[f64; 2]>,
    /// Largest speed, rad/s or m/s, symmetric.
    pub velocity: Option<f64>,
    /// Largest acceleration, rad/s^2 or m/s^2, symmetric.
    pub acceleration: Option<f64>,
    /// Largest jerk, rad/s^3 or m/s^3, symmetric.
    pub jerk: Option<f64>,
    /// Largest torque or force, N m or N, symmetric.
    pub torque: Option<f64>,
}

/// An effect means a link that is not there, or whose parameters the file does not have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NoLink {
    /// The number that was given, from 1.
    pub number: Option<usize>,
    /// Number of links.
    pub last: usize,
}

/// Effects by where they stand.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Effects {
    /// Of joints: row of the DH table, from 0.
    pub joints: Vec<(usize, Effect)>,
    /// Of the whole robot.
    pub robot: Vec<Effect>,
    /// Torques in closed form: row of the DH table, from 0.
    pub laws: Vec<(usize, TorqueLaw)>,
}

/// The drive of a joint. A `Some` says that the model *has* the parameter (zero: not known yet).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Drive {
    /// `IA`: rotor inertia on the link side of the gear, kg m^2 (kg for a prismatic joint).
    pub rotor_inertia: Option<f64>,
    /// Motor turns per joint turn.
    pub gear_ratio: Option<f64>,
    /// Joint-side torque per motor current, N m / A.
    pub torque_constant: Option<f64>,
    /// `FV`: viscous friction, N m s/rad.
    pub viscous_friction: Option<f64>,
    /// `FC`: Coulomb friction, N m.
    pub coulomb_friction: Option<f64>,
    /// `FO`: constant torque offset, N m.
    pub offset: Option<f64>,
    /// Every other law of the vocabulary that the file names.
    pub effects: Vec<Effect>,
    /// What has no name: a torque in closed form.
    pub law: Option<TorqueLaw>,
}

/// A joint in another file or in logs: `q = sign q_source + offset`.
#[derive(Debug, Clone, PartialEq)]
pub struct JointSource {
    /// Its name there; `None`: the same.
    pub name: Option<String>,
    /// 1 or -1: whether it turns the same way there.
    pub sign: f64,
    /// Position here where the position there is 0, rad or m.
    pub offset: f64,
}

/// One row of the DH table.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Name in the file, or `joint<i>`.
    pub name: String,
    /// Revolute, prismatic or fixed.
    pub kind: JointKind,
    /// Whether a motor drives it (mu).
    pub actuated: bool,
    /// Twist about x, rad.
    pub alpha: Angle,
    /// Length along x, m.
    pub d: Length,
    /// Constant part of the turn about z, rad.
    pub theta: Angle,
    /// Constant part of the shift along z, m.
    pub r: Length,
    /// The joint in the file that it was imported from.
    pub source: Option<JointSource>,
    /// Limits.
    pub limits: Limits,
    /// Rotor, gear and friction.
    pub drive: Drive,
}

/// A constant pose.
#[derive(Debug, Clone, PartialEq)]
pub struct Pose {
    /// Origin, m.
    pub xyz: [f64; 3],
    /// Fixed-axis roll, pitch, yaw: `R = RotZ(yaw) RotY(pitch) RotX(roll)`, exact where a quarter
    /// turn.
    pub rpy: [Angle; 3],
}

/// A body fixed to the last frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Tool {
    /// Name in the file.
    pub name: String,
    /// Origin of the tool frame in the last DH frame, m.
    pub xyz: [f64; 3],
    /// Fixed-axis roll, pitch, yaw: `R = RotZ(yaw) RotY(pitch) RotX(roll)`, exact where a quarter
    /// turn.
    pub rpy: [Angle; 3],
    /// Inertial parameters in the tool frame, about its origin; `None` when the file gives only a
    /// pose.
    pub inertia: Option<Inertia>,
    /// Length and width of the tool, m, for recognition and painting.
    pub geometry: Option<ToolGeometry>,
}

/// The size of a tool, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToolGeometry {
    /// From the mount to the far end, along z of the tool frame.
    pub length: f64,
    /// Of what meets the work: a roller along its axis, a brush across its stroke.
    pub width: f64,
}

/// A sphere that stands for part of a link in distance checks.
#[derive(Debug, Clone, PartialEq)]
pub struct Sphere {
    /// Row of the DH table that carries it, from 1 (0: the base).
    pub link: usize,
    /// Centre in that row's frame, m.
    pub center: [f64; 3],
    /// Radius, m.
    pub radius: f64,
}

/// A box of the surroundings, along the world axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Cuboid {
    /// Name in the file, or `box<i>`.
    pub name: String,
    /// Lowest corner, m, in the world frame.
    pub min: [f64; 3],
    /// Highest corner, m.
    pub max: [f64; 3],
}

/// Obstacles.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Collision {
    /// Lowest z that elbow, wrist and tool may reach, m, in the world frame.
    pub ground: Option<f64>,
    /// Spheres on links.
    pub spheres: Vec<Sphere>,
    /// Boxes around the robot.
    pub boxes: Vec<Cuboid>,
}

/// A serial robot, base to tip.
#[derive(Debug, Clone, PartialEq)]
pub struct Robot {
    /// Name, in lower-case-with-dashes.
    pub name: String,
    /// Convention of the rows.
    pub convention: Convention,
    /// Named constants, in the file's order.
    pub constants: Vec<(String, f64)>,
    /// Gravity in the world frame, m/s^2.
    pub gravity: [f64; 3],
    /// Pose of frame 0, from which row 1 starts, in the world frame; `None` where the two coincide.
    pub base: Option<Pose>,
    /// Rows of the DH table.
    pub joints: Vec<Joint>,
    /// Inertial parameters of each row's link in its DH frame, where known. Empty or one per row.
    pub links: Vec<Option<Inertia>>,
    /// The tool.
    pub tool: Option<Tool>,
    /// Spheres and ground.
    pub collision: Collision,
    /// Effects of the whole robot (`effects:` at the top of the file).
    pub effects: Vec<Effect>,
    /// Which channel of its logs is which column (`log:` at the top of the file).
    pub log: Option<LogMapping>,
}

impl Robot {
    /// Rows that move, in order: index into [`Robot::joints`].
    pub fn moving(&self) -> Vec<usize> {
        (0..self.joints.len()).filter(|&i| self.joints[i].kind != JointKind::Fixed).collect()
    }

    /// Rows that move and have no motor (`actuated: false`).
    pub fn unactuated(&self) -> impl Iterator<Item = usize> + '_ {
        self.moving().into_iter().filter(|&row| !self.joints[row].actuated)
    }

    /// Degrees of freedom: number of moving rows; the length of `q`.
    pub fn dof(&self) -> usize {
        self.moving().len()
    }

    /// The effects that the file names, beyond what [`Drive`] holds itself.
    pub fn all_effects(&self) -> Effects {
        let of = |(row, joint): (usize, &Joint)| joint.drive.effects.iter().map(move |e| (row, e.clone())).collect();
        Effects {
            joints: self.joints.iter().enumerate().flat_map::<Vec<_>, _>(of).collect(),
            robot: self.effects.clone(),
            laws: self
                .joints
                .iter()
                .enumerate()
                .filter_map(|(row, joint)| Some((row, joint.drive.law.clone()?)))
                .collect(),
        }
    }

    /// Kinds of the joints that move, base to tip.
    pub fn moving_kinds(&self) -> Vec<JointKind> {
        self.joints.iter().map(|joint| joint.kind).filter(|kind| *kind != JointKind::Fixed).collect()
    }

    /// Gravity in frame 0, m/s^2.
    pub fn base_gravity(&self) -> [f64; 3] {
        let Some(base) = &self.base else { return self.gravity };
        let r = base.rotation();
        core::array::from_fn(|i| (0..3).map(|k| r[k][i] * self.gravity[k]).sum())
    }

    /// Inertial parameters of every link with the tool folded into the last one, or `None` where a
    /// link's are unknown.
    pub fn inertias(&self) -> Option<Vec<Inertia>> {
        let mut all: Vec<Inertia> = self.links.iter().cloned().collect::<Option<_>>()?;
        if all.len() != self.joints.len() {
            return None;
        }
        if let (Some(tool), Some(last)) = (&self.tool, all.last_mut())
            && let Some(inertia) = &tool.inertia
        {
            *last = last.plus(&inertia.moved(&tool.rotation(), &tool.xyz));
        }
        Some(all)
    }
}

impl Tool {
    /// Rotation from the tool frame to the last DH frame, row-major.
    pub fn rotation(&self) -> [[f64; 3]; 3] {
        rotation(&self.rpy)
    }
}

impl Default for Pose {
    fn default() -> Self {
        Self { xyz: [0.0; 3], rpy: [Angle::zero(), Angle::zero(), Angle::zero()] }
    }
}

impl Pose {
    /// A point given in this frame, m, in the frame that this one stands in.
    pub fn point(&self, at: [f64; 3]) -> [f64; 3] {
        let r = self.rotation();
        core::array::from_fn(|i| self.xyz[i] + (0..3).map(|k| r[i][k] * at[k]).sum::<f64>())
    }

    /// Rotation from this frame to the one that it stands in, row-major.
    pub fn rotation(&self) -> [[f64; 3]; 3] {
        rotation(&self.rpy)
    }
}

/// `RotZ(yaw) RotY(pitch) RotX(roll)`, row-major.
fn rotation(rpy: &[Angle; 3]) -> [[f64; 3]; 3] {
    let [(sr, cr), (sp, cp), (sy, cy)] = [0, 1, 2].map(|i| rpy[i].sin_cos());
    [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
}
