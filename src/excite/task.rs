//! The design task: robot, limits, family of motions, columns, criterion, prior.

use dh_codegen::arm::param;
use dh_codegen::robot::Robot;
use nalgebra::DMatrix;

use crate::model::differentiated::Differentiated;
use crate::model::{Arm, Differentiable, States};

use super::bodies::Bodies;
use super::columns::Columns;
use super::constraints::{Constraint, Constraints};
use super::criterion::Criterion;
use super::curve::Curve;
use super::error::LimitsError;
use super::extra::Extra;
use super::information::Scaling;
use super::limits::{JointLimits, Missing};
use crate::numerics::prng::Random;

/// A task for the designer. Fields may be changed between [`Task::new`] and [`super::design`].
#[derive(Clone)]
pub struct Task<'a> {
    /// The arm.
    pub arm: &'a dyn Differentiable,
    /// Limits per joint.
    pub limits: Vec<JointLimits>,
    /// Values missing in the file, and their replacements.
    pub missing: Vec<Missing>,
    /// Standard parameters of the nominal model; `None`: torques are not checked.
    pub standard: Option<Vec<f64>>,
    /// Collision bodies: spheres, ground, boxes.
    pub bodies: Bodies,
    /// Family of motions.
    pub curve: Curve,
    /// Criterion to minimise.
    pub criterion: Criterion,
    /// Indices of the selected base parameters.
    pub base: Vec<usize>,
    /// Whether to include the ten columns of a payload in the tool frame.
    pub payload: bool,
    /// Nominal parameters of the payload, `M MSX .. YZ`: those of the file's tool.
    pub body: Option<[f64; 10]>,
    /// Additional columns.
    pub extra: Option<&'a dyn Extra>,
    /// Standard deviation of each joint's torque noise, N m; all 1: plain equation (9).
    pub noise: Vec<f64>,
    /// Factor of each column; empty: 1.
    pub scale: Vec<f64>,
    /// Prior information, in unscaled columns and the noise's units: `W' P W` of earlier motions,
    /// or reciprocal variances.
    pub prior: Option<DMatrix<f64>>,
    /// Sampling rate of the criterion, Hz.
    pub rate: f64,
    /// Share of the torque limits that is kept as a reserve.
    pub torque_margin: f64,
    /// Distance kept to ground, spheres and boxes, m.
    pub distance_margin: f64,
    /// Share of the limits of position, velocity, acceleration and jerk that is used.
    pub share: f64,
}

impl<'a> Task<'a> {
    /// Creates the paper's task for a robot: all base parameters, log det, splines with a way point
    /// every second.
    ///
    /// # Errors
    /// Returns an error if limits required for planning are missing.
    pub fn new(arm: &'a Differentiated, robot: &Robot, duration: f64, speed_up_time: f64) -> Result<Self, LimitsError> {
        let mut missing = Vec::new();
        let still = |row: &usize| robot.joints[*row].limits.velocity.is_none_or(|v| v <= 0.0);
        let still: Vec<String> =
            robot.moving().into_iter().filter(still).map(|row| robot.joints[row].name.clone()).collect();
        if still.len() > 1 {
            return Err(LimitsError::Velocities(still));
        }
        let limits: Vec<JointLimits> = robot
            .moving()
            .into_iter()
            .map(|row| {
                let joint = &robot.joints[row];
                let revolute = joint.kind == dh_codegen::robot::JointKind::Revolute;
                JointLimits::new(&joint.name, revolute, &joint.limits, speed_up_time, &mut missing)
            })
            .collect::<Result<_, _>>()?;
        if limits.is_empty() {
            return Err(LimitsError::NoJoint);
        }
        let standard = param::standard_values(robot);
        if standard.is_none() {
            missing.push(Missing {
                joint: String::new(),
                limit: "links",
                taken: "the file has no inertial parameters of all links: torques are not checked".into(),
                value: None,
            });
        }
        let around = match (robot.collision.ground, robot.collision.spheres.is_empty()) {
            (None, true) => "no ground and no spheres in the file: heights and self-collision are not checked",
            (None, false) => "no ground in the file: heights are not checked",
            (Some(_), true) => "no spheres in the file: self-collision is not checked",
            _ => "",
        };
        if !around.is_empty() {
            missing.push(Missing { joint: String::new(), limit: "collision", taken: around.into(), value: None });
        }
        let mut task = Self {
            noise: vec![1.0; limits.len()],
            base: (0..arm.base_parameters().len()).collect(),
            arm,
            limits,
            missing,
            standard,
            bodies: Bodies::new(robot),
            curve: Curve::Spline { duration, intervals: (duration.round() as usize).max(1) },
            criterion: Criterion::LogDet,
            payload: false,
            body: robot.tool.as_ref().and_then(|tool| tool.inertia).map(|inertia| inertia.to_array()),
            extra: None,
            scale: Vec::new(),
            prior: None,
            rate: 100.0,
            torque_margin: 0.01,
            distance_margin: 0.005,
            share: 1.0,
        };
        task.forget_constant();
        Ok(task)
    }

    /// Number of joints.
    pub fn dof(&self) -> usize {
        self.limits.len()
    }

    /// Removes the drives' columns from the criterion: rotor inertia, friction, offsets.
    pub fn links_only(&mut self) {
        let base = self.arm.base_parameters();
        self.base.retain(|&b| !base[b].leader.is_drive());
    }

    /// Selects only the ten parameters of a payload in the tool frame, as if the robot were known.
    pub fn tool_only(&mut self) {
        self.base.clear();
        self.payload = true;
    }

    /// Removes constraints that do not depend on the posture: frames on the base axis, spheres that
    /// turn about it.
    fn forget_constant(&mut self) {
        let mut random = Random::stream(1, 1);
        let (n, len) = (self.dof(), 200);
        let mut states = States::zeros(n, len);
        for j in 0..n {
            let [low, high] = self.limits[j].position;
            states.q[j * len..(j + 1) * len].iter_mut().for_each(|q| *q = random.uniform(low, high));
        }
        let constraints = self.constraints();
        let list: Vec<Constraint> =
            constraints.list().into_iter().filter(|c| !matches!(c, Constraint::Torque(_))).collect();
        let values = constraints.values(&list, &states);
        let varies = |k: usize| {
            let row = &values[k * len..(k + 1) * len];
            let (low, high) = row.iter().fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(*v), h.max(*v)));
            high - low > 1e-9
        };
        let kept: Vec<Constraint> = list.iter().enumerate().filter(|&(k, _)| varies(k)).map(|(_, c)| *c).collect();
        if let Some((_, frames)) = &mut self.bodies.ground {
            frames.retain(|f| kept.contains(&Constraint::Ground(*f)));
        }
        let pick = |all: &[(usize, usize)], make: fn(usize) -> Constraint| {
            (0..all.len()).filter(|&k| kept.contains(&make(k))).map(|k| all[k]).collect::<Vec<_>>()
        };
        self.bodies.pairs = pick(&self.bodies.pairs, Constraint::Pair);
        self.bodies.blocked = pick(&self.bodies.blocked, Constraint::Box);
    }

    pub(super) fn constraints(&self) -> Constraints<'_> {
        Constraints {
            arm: self.arm,
            limits: &self.limits,
            standard: self.standard.as_deref(),
            bodies: &self.bodies,
            torque_margin: self.torque_margin,
            distance_margin: self.distance_margin,
        }
    }

    /// The selected columns.
    pub fn columns(&self) -> Columns<'a> {
        Columns::new(self.arm, &self.base, self.payload, self.extra)
    }

    /// The columns with a smooth Coulomb sign: over two percent of the largest speed, and over half
    /// of the change of speed between two samples, so that no reversal falls between them.
    pub(super) fn smooth_columns(&self, rate: f64) -> Columns<'a> {
        let turn = |l: &JointLimits| (0.02 * l.velocity).max(0.5 * l.acceleration / rate);
        self.columns().smooth(self.limits.iter().map(turn).collect())
    }

    pub(super) fn scaling(&self, repeat: f64) -> Scaling {
        let count = self.columns().count();
        let column = if self.scale.len() == count { self.scale.clone() } else { vec![1.0; count] };
        let prior = self.prior.as_ref().filter(|p| p.ncols() == count);
        let prior = prior.map(|p| DMatrix::from_fn(count, count, |i, k| p[(i, k)] * column[i] * column[k]));
        Scaling { row: self.noise.iter().map(|s| 1.0 / s).collect(), column, prior, repeat }
    }
}
