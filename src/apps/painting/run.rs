//! Simulation of a planned motion against the wall, under the controller of the paper's Fig. 8.
//!
//! The arm starts 2 cm before the wall, approaches it, and presses at the plan's first point until
//! the force has settled. If drag is to be predicted, it makes a stroke of 4 cm there and back.
//! Then it paints.

mod recorder;
mod settings;
mod target;

use dh_codegen::robot::{Robot, Tool};

use self::recorder::{FilteredWallSensor, Forces, Recorder};
use self::target::{PlannedMotion, TargetSchedule};
use super::Plan;
use super::tune::{TuneError, Tuning, plant, tune};
use super::wall::RollerWall;
use crate::apps::painting::drag_calibration_stroke::calibration_stroke;
use crate::control::iterative_learning::{Learned, learned};
use crate::control::law::{Controller, ControllerError, Estimator, Model, Sample, Status};
use crate::control::robot::RobotModel;
use crate::model::Dynamics;
use crate::model::interpreted::Interpreted;
use crate::model::inverse_kinematics::{Kinematics, MOST};
use crate::simulate::{
    Drive, External, Sampled, Sensors, SimulateError, Simulator, Solver, Trajectory, TrajectoryError,
};

/// The controller's model of the robot.
pub struct Known<'a> {
    /// Geometry, limits and the tool's frame.
    pub robot: &'a Robot,
    /// Interpreted arm; with [`Interpreted::BODIES`].
    pub arm: &'a Interpreted,
    /// Standard parameters, tool included.
    pub standard: &'a [f64],
    /// Known friction and other known effects of the drives.
    pub drives: Vec<Drive>,
    /// Standard deviation of each joint's torque error, N m: determines the weights of the
    /// estimate.
    pub spread: Vec<f64>,
    /// Largest error of each joint's friction just after a reversal, N m; infinite where unknown, 0
    /// where noise explains all torque errors. See
    /// [`EstimatorSettings::turning`](crate::control::law::EstimatorSettings::turning).
    pub turning: Vec<f64>,
}

/// Source of the force that is fed back.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Feedback {
    /// Equation (14): Fig. 13a.
    Estimated,
    /// Sensor in the wall: Fig. 13b.
    Measured,
}

/// Feed-forward terms of the inner loop in addition to equation (13): shares from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Law {
    /// Share of the desired force: see [`Settings::carry`](crate::control::law::Settings::carry).
    pub carry: f64,
    /// Share of the planned motion's torques: see
    /// [`Settings::feed`](crate::control::law::Settings::feed).
    pub feed: f64,
    /// Share of the estimated tangential force: see
    /// [`Settings::aside`](crate::control::law::Settings::aside).
    pub aside: f64,
    /// Share of the predicted drag: see [`Settings::drag`](crate::control::law::Settings::drag). It
    /// is learned in a stroke of 4 cm along the roller's axis before painting, if there are 3 s for
    /// it.
    pub drag: f64,
}

impl Law {
    /// Equations (13) and (15) of the paper, without additions.
    pub const PAPER: Self = Self { carry: 0.0, feed: 0.0, aside: 0.0, drag: 0.0 };
    /// With all known terms fed forward.
    pub const FED: Self = Self { carry: 1.0, feed: 1.0, aside: 0.5, drag: 1.0 };
}

/// Task of a run.
#[derive(Debug, Clone)]
pub struct RunTask<'a> {
    /// Planned joint motion, along which the tool touches the wall.
    pub motion: &'a Trajectory,
    /// The wall; its normal defines the direction of pressing.
    pub wall: RollerWall,
    /// Desired normal force, N; 30 in the paper.
    pub force: f64,
    /// Source of the force that is fed back.
    pub feedback: Feedback,
    /// Standard deviation of the contact moment that the estimate assumes, N m: see
    /// [`EstimatorSettings::moment`](crate::control::law::EstimatorSettings::moment) and
    /// [`roller_moment`].
    pub moment: f64,
    /// Feed-forward terms of the inner loop in addition to equation (13).
    pub law: Law,
    /// Corner frequency of the low-pass of both forces, Hz.
    pub corner: f64,
    /// Time of pressing before painting begins, s.
    pub settle: f64,
    /// Displacement learned from the previous coat.
    pub learned: Option<&'a Learned>,
    /// Joint sensors.
    pub sensors: Sensors,
    /// Seed of all noise.
    pub seed: u64,
}

/// Recording of a run, one entry per sample of the painting itself.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Trace {
    /// Time since painting began, s.
    pub t: Vec<f64>,
    /// Estimated force on the wall along the normal, N.
    pub estimated: Vec<f64>,
    /// Force of the sensor through the same low-pass, N.
    pub measured: Vec<f64>,
    /// True force, N.
    pub truth: Vec<f64>,
    /// Displacement along the normal, m.
    pub displacement: Vec<f64>,
    /// Planned position of the contact, world axes, m.
    pub planned: Vec<[f64; 3]>,
    /// Actual position of the contact, world axes, m.
    pub actual: Vec<[f64; 3]>,
}

/// Root mean square force differences, N.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ForceErrors {
    /// Estimated minus measured force.
    pub estimated_measured: f64,
    /// Estimated minus desired force.
    pub estimated_desired: f64,
    /// Measured minus desired force.
    pub measured_desired: f64,
}

/// Result of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Recorded series.
    pub trace: Trace,
    /// Force errors as in Table IV.
    pub accuracy: ForceErrors,
    /// Root mean square distance in the plane of the wall between plan and contact, m.
    pub tracking: f64,
    /// Time without pressing, s.
    pub off: f64,
    /// Final status of the controller.
    pub status: Status,
    /// Gains used.
    pub tuning: Tuning,
    /// Displacement for the next coat; `None` if this one did not end well.
    pub learned: Option<Learned>,
}

impl Run {
    /// Whether the run painted to the end of its plan.
    pub fn painted(&self) -> bool {
        matches!(self.status, Status::Free | Status::Pressing)
    }
}

/// Reason why there is no run.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RunError {
    /// The arm has too many joints.
    #[error("a robot with {0} joints can't be controlled here: at most {MOST}")]
    Joints(usize),
    /// No posture at the distance before the wall.
    #[error("the arm can't stand 2 cm before the wall")]
    Reach,
    /// Invalid settings of the controller.
    #[error(transparent)]
    Control(#[from] ControllerError),
    /// No gains keep their margins.
    #[error(transparent)]
    Tune(#[from] TuneError),
    /// The simulation failed.
    #[error(transparent)]
    Simulate(#[from] SimulateError),
}

/// Standard deviation of the moment, N m, at a roller that presses with a force, N: the centre of
/// pressure may be anywhere along its face. Infinite for a tool of unknown size.
pub fn roller_moment(tool: Option<&Tool>, force: f64) -> f64 {
    tool.and_then(|t| t.geometry).map_or(f64::INFINITY, |g| force * g.width / 12.0_f64.sqrt())
}

/// The joint motion of a plan's time in contact.
///
/// # Errors
/// Returns an error if the plan has none.
pub fn in_contact(plan: &Plan) -> Result<Trajectory, TrajectoryError> {
    const RATE: f64 = 100.0;
    let [start, end] = plan.contact_span();
    let count = (((end - start) * RATE).ceil() as usize).max(1);
    let times: Vec<f64> = (0..=count).map(|k| (end - start) * k as f64 / count as f64).collect();
    let moments: Vec<_> = times.iter().map(|t| plan.motion.at(start + t)).collect();
    let dof = plan.motion.dof();
    let [mut q, mut dq, mut ddq] = [(); 3].map(|()| Vec::with_capacity(dof * times.len()));
    for j in 0..dof {
        q.extend(moments.iter().map(|m| m.q[j]));
        dq.extend(moments.iter().map(|m| m.dq[j]));
        ddq.extend(moments.iter().map(|m| m.ddq[j]));
    }
    Trajectory::new(dof, times, q, Some(dq), Some(ddq))
}

/// Tolerance of the arm's integration.
const TOLERANCE: f64 = 1e-5;
/// Distance from the wall at the start, m.
const AWAY: f64 = 0.02;
/// Time between postures that get their own linear model for learning, s.
const APART: f64 = 1.0;
/// Default time of pressing before painting begins, s.
pub const SETTLE: f64 = 4.0;

/// Simulates the run. `progress` receives the share done, 0 to 1.
pub fn run(
    known: &Known<'_>,
    real: &Simulator,
    task: &RunTask<'_>,
    progress: &mut dyn FnMut(f64),
) -> Result<Run, RunError> {
    match known.robot.dof() {
        1 => run_n::<1>(known, real, task, progress),
        2 => run_n::<2>(known, real, task, progress),
        3 => run_n::<3>(known, real, task, progress),
        4 => run_n::<4>(known, real, task, progress),
        5 => run_n::<5>(known, real, task, progress),
        6 => run_n::<6>(known, real, task, progress),
        7 => run_n::<7>(known, real, task, progress),
        8 => run_n::<8>(known, real, task, progress),
        n => Err(RunError::Joints(n)),
    }
}

fn run_n<const N: usize>(
    known: &Known<'_>,
    real: &Simulator,
    task: &RunTask<'_>,
    progress: &mut dyn FnMut(f64),
) -> Result<Run, RunError> {
    let press = task.wall.normal.map(|n| -n);
    let kinematics = Kinematics::new(known.robot, known.arm.model());
    let kinematics = kinematics.as_ref().filter(|k| k.inverse().exact);
    let robot_model = || {
        let bodies: Box<dyn Dynamics + '_> = Box::new(known.arm.bodies(known.standard));
        RobotModel::new(known.robot, bodies, kinematics, known.drives.clone())
    };
    let mut model = robot_model();
    let mut plan = PlannedMotion::<N>::new(task.motion);
    let first = plan.at(0.0)[0];
    let start = model.displaced(&first, &press.map(|p| -AWAY * p), &first).ok_or(RunError::Reach)?;
    let postures: Vec<[f64; N]> = (0..9).map(|k| plan.at(plan.seconds() * f64::from(k) / 8.0)[0]).collect();
    let demands = settings::demands(known, real, task);
    let viscous: [f64; N] = std::array::from_fn(|j| known.drives[j].plain.viscous.max(0.0));
    let calibrate = || calibration_stroke(&mut model, &first, &postures, &press, task.settle);
    let stroke = (task.law.drag > 0.0).then(calibrate).flatten();
    let tuning = tune(&mut model, &postures, &viscous, &press, &demands)?;

    let mut controller = Controller::new(robot_model(), settings::controller(known, task, &tuning))?;
    let mut estimator = Estimator::new(robot_model(), settings::estimator(known, task));
    let mut sensor = FilteredWallSensor::new(task);
    let mut recorder = Recorder::new(task, robot_model());
    let mut targets = TargetSchedule::new(task, start, plan, stroke);
    let run = Sampled {
        start: start.to_vec(),
        seconds: targets.painting_begins() + targets.plan.seconds(),
        sensors: task.sensors.clone(),
        solver: Solver { tolerance: TOLERANCE, ..Solver::default() },
        seed: task.seed,
    };
    let external: [&dyn External; 1] = [&task.wall];
    real.run_sampled(&run, &external, &mut |seen, is, torque| {
        let q: [f64; N] = std::array::from_fn(|j| seen.q[j]);
        let tau: [f64; N] = std::array::from_fn(|j| seen.tau[j]);
        let truth: f64 = (0..3).map(|k| -press[k] * is.wrench[k]).sum();
        let measured = sensor.read(truth);
        let push = estimator.step(&q, &tau).map_or([f64::NAN; 3], |w| [w[0], w[1], w[2]]);
        let estimated: f64 = (0..3).map(|k| press[k] * push[k]).sum();
        let force = match task.feedback {
            Feedback::Estimated => estimated,
            Feedback::Measured => measured,
        };
        let target = targets.at(seen.t);
        let command = controller.step(&target, &Sample { t: seen.t, q, force, push });
        torque.copy_from_slice(&command.torque);
        recorder.status = command.status;
        if seen.t >= targets.painting_begins() {
            let t = seen.t - targets.painting_begins();
            let forces = Forces { estimated, measured, truth };
            recorder.absorb(t, forces, command.displacement, &target, is);
        }
        if recorder.trace.t.len().is_multiple_of(64) {
            progress(seen.t / run.seconds);
        }
        true
    })?;
    let next = recorder.pressed_throughout().then(|| {
        let gains: Vec<[f64; 2]> = tuning.joints.iter().map(|j| [j.kp, j.kd]).collect();
        let plan = &mut targets.plan;
        let seconds = plan.seconds();
        let count = (seconds / APART).ceil().max(1.0) as usize;
        let at = |k: usize| plan.at(seconds * k as f64 / count as f64)[0];
        let plants: Option<Vec<_>> =
            (0..=count).map(at).map(|q| plant(&mut model, &q, &viscous, &press, &demands, &gains, true)).collect();
        let (error, force) = (recorder.force_error(), [tuning.force.kp, tuning.force.ki]);
        learned(&plants?, force, &error, &recorder.pace, demands.period, task.learned)
    });
    Ok(recorder.finish(tuning, next.flatten()))
}

/// Root mean square of `len` values; NaN for none, as a run that ended before painting has no
/// error.
pub(super) fn root_mean_square(len: usize, of: &dyn Fn(usize) -> f64) -> f64 {
    let sum: f64 = (0..len).map(|k| of(k).powi(2)).sum();
    (sum / len as f64).sqrt()
}
