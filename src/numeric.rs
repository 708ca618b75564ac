//! The numeric version: recursive algorithms on spatial vectors, written from Featherstone, "Rigid Body Dynamics Algorithms"
//! (2008), in nalgebra. The oracle of the tests and the baseline of the benches; shares nothing with the generator but the robot
//! type and the order of the parameters.
//!
//! Spatial vectors have the angular part first. `Xup[i]` takes motion vectors from body `i - 1` to body `i` (Featherstone's
//! `iXλ(i)`), bodies being the DH frames of the rows.

mod base;
mod dynamics;
mod energy;
mod kinematics;
mod random;
mod regressor;
mod spatial;

pub use base::{Rank, rank};
pub use random::{Random, random_robot};
pub use spatial::{Force, Inertia6, Motion6, SpatialTransform};

use dh_codegen::arm::param::{self, DriveTerm, Inertial, Parameter};
use dh_codegen::robot::{Convention, JointKind, Robot};
use nalgebra::{Isometry3, Matrix3, Vector3};

/// A robot ready for the recursions.
#[derive(Debug, Clone)]
pub struct Numeric {
    bodies: Vec<Body>,
    gravity: Vector3<f64>,
    tool: Isometry3<f64>,
    parameters: Vec<Parameter>,
}

/// A row of the DH table.
#[derive(Debug, Clone)]
struct Body {
    kind: JointKind,
    dof: Option<usize>,
    /// Before and after the joint's own motion, whichever the convention has.
    before: Isometry3<f64>,
    theta: f64,
    r: f64,
    after: Isometry3<f64>,
}

fn about(axis: Vector3<f64>, angle: f64) -> nalgebra::UnitQuaternion<f64> {
    nalgebra::UnitQuaternion::from_scaled_axis(axis * angle)
}

impl Numeric {
    /// Takes over geometry and gravity; parameters are given to each function.
    pub fn new(robot: &Robot) -> Self {
        let mut dof = 0;
        let bodies = robot
            .joints
            .iter()
            .map(|joint| {
                let x = Isometry3::from_parts(
                    Vector3::new(joint.d.value, 0.0, 0.0).into(),
                    about(Vector3::x(), joint.alpha.value),
                );
                let (before, after) = match robot.convention {
                    Convention::Modified => (x, Isometry3::identity()),
                    Convention::Standard => (Isometry3::identity(), x),
                };
                let own = (joint.kind != JointKind::Fixed).then_some(dof);
                dof += usize::from(own.is_some());
                Body { kind: joint.kind, dof: own, before, theta: joint.theta.value, r: joint.r.value, after }
            })
            .collect();
        let tool = robot.tool.as_ref().map_or_else(Isometry3::identity, |t| {
            let [roll, pitch, yaw] = [0, 1, 2].map(|i| t.rpy[i].value);
            Isometry3::from_parts(
                Vector3::from(t.xyz).into(),
                nalgebra::UnitQuaternion::from_euler_angles(roll, pitch, yaw),
            )
        });
        Self { bodies, gravity: robot.gravity.into(), tool, parameters: param::standard(robot) }
    }

    /// Degrees of freedom.
    pub fn dof(&self) -> usize {
        self.bodies.iter().filter(|b| b.dof.is_some()).count()
    }

    /// Rows of the table.
    pub fn rows(&self) -> usize {
        self.bodies.len()
    }

    /// Standard parameters, in the order of the regressor's columns.
    pub fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    /// Pose of each body in the one before.
    fn local(&self, row: usize, q: &[f64]) -> Isometry3<f64> {
        let body = &self.bodies[row];
        let position = body.dof.map_or(0.0, |k| q[k]);
        let (turn, slide) = match body.kind {
            JointKind::Revolute => (position, 0.0),
            JointKind::Prismatic => (0.0, position),
            JointKind::Fixed => (0.0, 0.0),
        };
        let joint = Isometry3::from_parts(
            Vector3::new(0.0, 0.0, body.r + slide).into(),
            about(Vector3::z(), body.theta + turn),
        );
        body.before * joint * body.after
    }

    /// `Xup` of each body.
    fn transforms(&self, q: &[f64]) -> Vec<SpatialTransform> {
        (0..self.rows()).map(|row| SpatialTransform::from_pose(&self.local(row, q))).collect()
    }

    /// Motion subspace of each joint in its body's frame; zero for a fixed row.
    fn axes(&self) -> Vec<Motion6> {
        self.bodies
            .iter()
            .map(|body| {
                let own = match body.kind {
                    JointKind::Revolute => Motion6 { w: Vector3::z(), v: Vector3::zeros() },
                    JointKind::Prismatic => Motion6 { w: Vector3::zeros(), v: Vector3::z() },
                    JointKind::Fixed => Motion6::zero(),
                };
                SpatialTransform::from_pose(&body.after).motion(&own)
            })
            .collect()
    }

    /// Spatial inertia of each body from the standard parameters.
    fn inertias(&self, phi: &[f64]) -> Vec<Inertia6> {
        let mut all = vec![Inertia6::default(); self.rows()];
        for (parameter, &value) in self.parameters.iter().zip(phi) {
            if let Parameter::Link(row, which) = *parameter {
                all[row] = all[row].plus(&Inertia6::unit(which).scaled(value));
            }
        }
        all
    }

    /// Value of a drive term of each degree of freedom; zero where the model does not have it.
    fn drive(&self, term: DriveTerm, phi: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; self.dof()];
        for (parameter, &value) in self.parameters.iter().zip(phi) {
            if let Parameter::Drive(row, t) = *parameter
                && t == term
                && let Some(k) = self.bodies[row].dof
            {
                all[k] = value;
            }
        }
        all
    }
}

impl Inertia6 {
    /// One of the ten parameters equal to one, all others zero.
    pub fn unit(which: Inertial) -> Self {
        let mut i = Self::default();
        let e = |a: usize, b: usize| {
            let mut m = Matrix3::zeros();
            m[(a, b)] = 1.0;
            m[(b, a)] = 1.0;
            m
        };
        match which {
            Inertial::M => i.mass = 1.0,
            Inertial::MSX => i.moment.x = 1.0,
            Inertial::MSY => i.moment.y = 1.0,
            Inertial::MSZ => i.moment.z = 1.0,
            Inertial::XX => i.tensor = e(0, 0),
            Inertial::YY => i.tensor = e(1, 1),
            Inertial::ZZ => i.tensor = e(2, 2),
            Inertial::XY => i.tensor = e(0, 1),
            Inertial::XZ => i.tensor = e(0, 2),
            Inertial::YZ => i.tensor = e(1, 2),
        }
        i
    }
}
