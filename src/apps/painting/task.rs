//! A painting task: arm, wall, roller, limits, weights.

use dh_codegen::arm::param;
use dh_codegen::ik::{Displacement, Family, Reference};
use dh_codegen::robot::{JointKind, Robot};

use crate::excite::{Bodies, JointLimits, LimitsError, Missing};
use crate::model::FrameKinematics;
use crate::model::inverse_kinematics::Kinematics;

use super::strokes::{Pattern, Strokes};
use super::surface::{Roller, Surface};

/// How much of the wall must be painted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cover {
    /// As in equation (12): the area is part of the cost, and the limits decide.
    Most,
    /// The whole wall; otherwise there is no plan.
    Whole,
}

/// The swivel angle (or the position of the locked joint) of a redundant arm.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Swivel {
    /// One angle, as in equation (12).
    Constant,
    /// A quintic spline with an angle at each way point.
    Spline,
}

/// Weights of the cost of equation (12), whose terms are all in seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weights {
    /// Weight of the integral of the squared joint jerks over the time in contact, s per rad^2/s^5
    /// (m^2/s^5 for a prismatic joint). The paper's sum over samples with weight one is this
    /// integral times the sampling rate.
    pub jerk: f64,
    /// Weight of the reciprocal of the area `(Z_u - Z_l) dY`, s m^2.
    pub area: f64,
}

/// A painting task. Fields may be changed between [`Task::new`] and [`super::plan`].
pub struct Task<'a> {
    /// The arm holding the roller.
    pub arm: &'a dyn FrameKinematics,
    /// Its inverse kinematics.
    pub inverse: &'a Kinematics,
    /// Limits per joint.
    pub limits: Vec<JointLimits>,
    /// Defaults used for values missing in the file.
    pub missing: Vec<Missing>,
    /// Whether each joint is prismatic.
    pub slides: Vec<bool>,
    /// Standard parameters, tool included; `None`: torques are not checked.
    pub standard: Option<Vec<f64>>,
    /// Collision bodies: spheres, ground, boxes.
    pub bodies: Bodies,
    /// Pose of the tool frame in the last DH frame.
    pub mount: Displacement,
    /// The wall.
    pub surface: Surface,
    /// The roller.
    pub roller: Roller,
    /// Order in which the lanes are painted.
    pub pattern: Pattern,
    /// Number of lanes.
    pub lanes: usize,
    /// Distance of the start before the wall, m.
    pub standoff: f64,
    /// How much of the wall must be painted.
    pub cover: Cover,
    /// One swivel angle or a spline.
    pub swivel: Swivel,
    /// Zero of the swivel angle.
    pub reference: Reference,
    /// Weights of the cost.
    pub weights: Weights,
    /// Time in contact, s; `None`: optimised (`T_C` of equation (12)).
    pub duration: Option<f64>,
    /// Force on the wall along its normal, N; its joint torques count against the limits.
    pub force: f64,
    /// Share of the limits of velocity, acceleration and jerk that is used.
    pub share: f64,
    /// Share of the torque limits that is kept as a reserve.
    pub torque_margin: f64,
    /// Distance kept from the joints' position limits, rad or m.
    pub position_margin: f64,
    /// Distance kept from ground, spheres, boxes and wall, m.
    pub distance_margin: f64,
}

impl<'a> Task<'a> {
    /// Creates the paper's task for a robot.
    ///
    /// # Errors
    /// Returns an error if limits required for planning are missing, or the arm cannot hold a
    /// roller to a wall.
    pub fn new(
        arm: &'a dyn FrameKinematics,
        inverse: &'a Kinematics,
        robot: &Robot,
        surface: Surface,
        roller: Roller,
        acceleration_time: f64,
    ) -> Result<Self, LimitsError> {
        let mut missing = Vec::new();
        let moving = robot.moving();
        let limits: Vec<JointLimits> = moving
            .iter()
            .map(|&row| {
                let joint = &robot.joints[row];
                let revolute = joint.kind == JointKind::Revolute;
                JointLimits::new(&joint.name, revolute, &joint.limits, acceleration_time, &mut missing)
            })
            .collect::<Result<_, _>>()?;
        let standard = param::standard_values(robot);
        if standard.is_none() {
            missing.push(Missing {
                joint: String::new(),
                limit: "links",
                taken: "the file has no inertial parameters of all links: torques are not checked".into(),
                value: None,
            });
        } else if robot.tool.as_ref().is_some_and(|t| t.inertia.is_none()) {
            missing.push(Missing {
                joint: String::new(),
                limit: "tool",
                taken: "it has no M, MS and I: torques are those of an empty hand".into(),
                value: None,
            });
        }
        let mount =
            robot.tool.as_ref().map_or(Displacement::NONE, |t| Displacement { rotation: t.rotation(), shift: t.xyz });
        Ok(Self {
            arm,
            inverse,
            limits,
            missing,
            slides: moving.iter().map(|&row| robot.joints[row].kind == JointKind::Prismatic).collect(),
            standard,
            bodies: Bodies::new(robot),
            mount,
            surface,
            roller,
            pattern: Pattern::Cycle,
            lanes: Strokes::fewest(&surface, roller.width),
            standoff: 0.05,
            cover: Cover::Most,
            swivel: Swivel::Spline,
            reference: Reference::UP,
            weights: Weights { jerk: 1.0, area: 100.0 },
            duration: None,
            force: 30.0,
            share: 1.0,
            torque_margin: 0.01,
            position_margin: 1e-3,
            distance_margin: 0.005,
        })
    }

    /// Number of joints.
    pub fn dof(&self) -> usize {
        self.limits.len()
    }

    /// Range of the arm's redundancy parameter, and whether it is a cyclic angle; `None` for an arm
    /// without redundancy.
    pub fn redundancy(&self) -> Option<([f64; 2], bool)> {
        use std::f64::consts::PI;
        match self.inverse.inverse().family {
            Family::Swivel(_) => Some(([-PI, PI], true)),
            other => {
                let [low, high] = self.limits.get(usize::from(other.locked()?))?.position;
                Some(([low + self.position_margin, high - self.position_margin], false))
            }
        }
    }

    /// The strokes that paint the wall from edge to edge. If there are too few lanes, they are
    /// spread as widely as the roller allows.
    pub fn widest(&self) -> Strokes {
        let ([left, right], [lower, upper]) = (self.surface.sides(), self.surface.ends());
        let width = self.roller.width;
        let room = right - left - width;
        let gaps = self.lanes.saturating_sub(1);
        let step = if gaps > 0 { (room.max(0.0) / gaps as f64).min(width) } else { 0.0 };
        let first = 0.5 * (left + right) - 0.5 * step * gaps as f64;
        Strokes { upper, lower, first, step, lanes: self.lanes, pattern: self.pattern }
    }

    /// `(Z_u - Z_l) dY` of equation (12), m^2; the roller's width for a single lane.
    pub fn area(&self, strokes: &Strokes) -> f64 {
        let across = if strokes.lanes > 1 { strokes.step.abs() } else { self.roller.width.min(self.surface.width) };
        (strokes.upper - strokes.lower) * across
    }
}
