//! A planned motion against the simulated wall, under the controller of the paper's Fig. 8.
//!
//! The arm starts 2 cm before the wall, comes to it, and presses at the plan's first point until
//! the force has settled. If drag is to be predicted it wipes 4 cm there and back. Then it paints.

use dh_codegen::robot::{Robot, Tool};

use super::Plan;
use super::tune::{Demands, TuneError, Tuning, plant, tune};
use super::wall::{RollerWall, WallSensor};
use crate::apps::painting::drag_calibration_stroke::wipe;
use crate::control::iterative_learning::{Learned, learned};
use crate::control::law::{
    Controller, ControllerError, Estimator, EstimatorSettings, ForceSettings, JointLoop, Limits, Model, Sample,
    Settings, Status, Target,
};
use crate::control::robot::{RobotModel, STANDING};
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
    /// Its tapes; with [`Interpreted::BODIES`].
    pub arm: &'a Interpreted,
    /// Standard parameters, the tool's included.
    pub standard: &'a [f64],
    /// Friction and what else is known of the drives.
    pub drives: Vec<Drive>,
    /// Standard deviation of each joint's torque error, N m: weights of the estimate.
    pub spread: Vec<f64>,
    /// Largest error of each joint's friction just after a reversal, N m; infinite where nothing is
    /// known of it, 0 where noise explains all torque errors: [`EstimatorSettings::turning`].
    pub doubt: Vec<f64>,
}

/// Force in the feedback.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Feedback {
    /// Equation (14): Fig. 13a.
    Estimated,
    /// The sensor in the wall: Fig. 13b.
    Measured,
}

/// Additions of the inner loop to equation (13): shares from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Law {
    /// Of the desired force: see [`Settings::carry`].
    pub carry: f64,
    /// Of the planned motion's torques: see [`Settings::feed`].
    pub feed: f64,
    /// Of the estimated force aside of the normal: see [`Settings::aside`].
    pub aside: f64,
    /// Of the drag that is predicted: see [`Settings::drag`]. It is learned in a wipe of 4 cm along
    /// the roller's axis, before the painting, where there are 3 s for it.
    pub drag: f64,
}

impl Law {
    /// Equations (13) and (15) of the paper, without additions.
    pub const PAPER: Self = Self { carry: 0.0, feed: 0.0, aside: 0.0, drag: 0.0 };
    /// With what is known fed forward.
    pub const FED: Self = Self { carry: 1.0, feed: 1.0, aside: 0.5, drag: 1.0 };
}

/// The task.
#[derive(Debug, Clone)]
pub struct Task<'a> {
    /// The planned joint motion, along which the tool touches the wall.
    pub motion: &'a Trajectory,
    /// The wall; its normal says where to press.
    pub wall: RollerWall,
    /// Force to press with, N: the paper's 30.
    pub force: f64,
    /// Force in the feedback.
    pub feedback: Feedback,
    /// How large a moment the estimate allows for at the contact, N m, as a standard deviation: see
    /// [`EstimatorSettings::moment`] and [`roller_moment`].
    pub moment: f64,
    /// Additions of the inner loop to equation (13).
    pub law: Law,
    /// Corner of the low-pass of both forces, Hz.
    pub corner: f64,
    /// How long it presses before it paints, s.
    pub settle: f64,
    /// Displacement learned from the coat before.
    pub learned: Option<&'a Learned>,
    /// Sensors of the joints.
    pub sensors: Sensors,
    /// Of all noise.
    pub seed: u64,
}

/// Recording, one entry per sample of the painting proper.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Trace {
    /// Since the painting began, s.
    pub t: Vec<f64>,
    /// Estimated force on the wall along the normal, N.
    pub estimated: Vec<f64>,
    /// Force of the sensor, through the same low-pass.
    pub measured: Vec<f64>,
    /// True force.
    pub truth: Vec<f64>,
    /// Displacement along the normal, m.
    pub displacement: Vec<f64>,
    /// Place of the contact, m, world axes: planned and actual.
    pub planned: Vec<[f64; 3]>,
    /// Actual.
    pub actual: Vec<[f64; 3]>,
}

/// Root mean squares of differences, N.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Accuracy {
    /// Estimated less measured.
    pub estimated_measured: f64,
    /// Estimated less desired.
    pub estimated_desired: f64,
    /// Measured less desired.
    pub measured_desired: f64,
}

/// A run.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Recording.
    pub trace: Trace,
    /// Table IV.
    pub accuracy: Accuracy,
    /// Distance in the plane of the wall between plan and contact, root mean square, m.
    pub tracking: f64,
    /// Seconds in which it did not press.
    pub off: f64,
    /// How it ended.
    pub status: Status,
    /// Gains.
    pub tuning: Tuning,
    /// For the next coat; none where this one came to no good end.
    pub learned: Option<Learned>,
}

impl Run {
    /// Whether it painted to the end of its plan.
    pub fn painted(&self) -> bool {
        matches!(self.status, Status::Free | Status::Pressing)
    }
}

/// Why there is no run.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RunError {
    /// Of an arm that is too large.
    #[error("a robot with {0} joints can't be controlled here: at most {MOST}")]
    Joints(usize),
    /// No posture away from the wall.
    #[error("the arm can't stand 2 cm before the wall")]
    Reach,
    /// Settings of the controller.
    #[error(transparent)]
    Control(#[from] ControllerError),
    /// Gains that keep their margins do not exist.
    #[error(transparent)]
    Tune(#[from] TuneError),
    /// The simulation.
    #[error(transparent)]
    Simulate(#[from] SimulateError),
}

/// Standard deviation of the moment at a roller that presses with a force (N), N m: the pressure's
/// middle may be anywhere along its face. Infinite for a tool of no known size.
pub fn roller_moment(tool: Option<&Tool>, force: f64) -> f64 {
    tool.and_then(|t| t.geometry).map_or(f64::INFINITY, |g| force * g.width / 12.0_f64.sqrt())
}

/// The joint motion of a plan's time in contact.
///
/// # Errors
/// If the plan has none.
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

/// How finely the arm is integrated.
const TOLERANCE: f64 = 1e-5;
/// Pole of the force aside, rad/s: what comes faster is predicted, and a fast one rings at 3 Hz
/// with the estimate's low-pass and soft joints.
const ASIDE_POLE: f64 = 4.0;
/// How far from the wall it begins, m, and how long it rests there, comes, and presses before it
/// paints, s.
const AWAY: f64 = 0.02;
const REST: f64 = 0.3;
const COME: f64 = 1.5;
/// Time of a stop along the path, s.
const STOP: f64 = 0.25;
/// Share of its torque limit that a joint's spring may have while its position does not change by a
/// bit: above static friction.
const STUCK: f64 = 0.15;
/// Between postures in which what is learned has its own linear model, s.
const APART: f64 = 1.0;
/// The last of these by default.
pub const SETTLE: f64 = 4.0;

/// Runs it. `progress` receives the share that is done.
pub fn run(
    known: &Known<'_>,
    real: &Simulator,
    task: &Task<'_>,
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

/// Limits of torque (N m) and speed (rad/s) of the file, and what stands for those that it has not.
fn strength<const N: usize>(robot: &Robot) -> [[f64; N]; 2] {
    let limits: Vec<_> = robot.moving().iter().map(|&row| &robot.joints[row].limits).collect();
    [
        std::array::from_fn(|j| limits[j].torque.unwrap_or(1e3)),
        std::array::from_fn(|j| limits[j].velocity.unwrap_or(2.0)),
    ]
}

/// Limits of the file; what it has not is libfranka's for the tool (its jerk is what takes 2 ms to
/// the full acceleration, for joints too), and for the torques a wide one, their range
/// in 2 ms: where the displacement begins to move, the joints' loops answer its speed at once.
fn limits_of<const N: usize>(robot: &Robot, kp: &[f64; N], torque: &[f64; N]) -> Limits<N> {
    let limits: Vec<_> = robot.moving().iter().map(|&row| &robot.joints[row].limits).collect();
    let acceleration: [f64; N] = std::array::from_fn(|j| limits[j].acceleration.unwrap_or(f64::INFINITY));
    Limits {
        position: std::array::from_fn(|j| limits[j].position.unwrap_or([f64::NEG_INFINITY, f64::INFINITY])),
        acceleration,
        jerk: std::array::from_fn(|j| limits[j].jerk.unwrap_or(acceleration[j] / 2e-3)),
        tool: [1.7, 13.0, 6500.0],
        torque_rate: torque.map(|most| most / 1e-3),
        saturated: 0.1,
        frozen: std::array::from_fn(|j| STUCK * torque[j] / kp[j].max(1e-6)),
        stuck: [2e-3, 0.2],
    }
}

fn run_n<const N: usize>(
    known: &Known<'_>,
    real: &Simulator,
    task: &Task<'_>,
    progress: &mut dyn FnMut(f64),
) -> Result<Run, RunError> {
    let span = task.motion.span();
    let seconds = span.end - span.start;
    let period = 1.0 / task.sensors.rate;
    let press = task.wall.normal.map(|n| -n);
    let kinematics = Kinematics::new(known.robot, known.arm.model());
    let kinematics = kinematics.as_ref().filter(|k| k.inverse().exact);
    let bodies = || -> Box<dyn Dynamics + '_> { Box::new(known.arm.bodies(known.standard)) };
    let lend = || RobotModel::new(known.robot, bodies(), kinematics, known.drives.clone());
    let mut lent = lend();

    let [torque, velocity] = strength(known.robot);
    let mut hint = 0;
    let mut points = vec![[0.0; 3]; N];
    let mut moment = |t: f64| -> [[f64; N]; 3] {
        task.motion.at(t, &mut hint, &mut points);
        std::array::from_fn(|d| std::array::from_fn(|j| points[j][d]))
    };
    let [first, ..] = moment(span.start);
    let off = press.map(|p| -AWAY * p);
    let start = lent.displaced(&first, &off, &first).ok_or(RunError::Reach)?;

    let postures: Vec<[f64; N]> = (0..9).map(|k| moment(span.start + seconds * f64::from(k) / 8.0)[0]).collect();
    let viscous: [f64; N] = std::array::from_fn(|j| known.drives[j].plain.viscous.max(0.0));
    let demands = Demands {
        period,
        corner: task.corner,
        stiffness: task.wall.stiffness,
        damping: task.wall.damping_at(task.force),
        drives: real
            .drives()
            .iter()
            .zip(&known.drives)
            .map(|(is, known)| {
                let [spring, loss] = is.elasticity.map_or([f64::INFINITY, 0.0], |e| [e.stiffness, e.damping]);
                [(is.rotor - known.rotor).max(0.0), spring, loss]
            })
            .collect(),
    };
    let wiped = (task.law.drag > 0.0).then(|| wipe(&mut lent, &first, &postures, &press, task.settle)).flatten();
    let tuning = tune(&mut lent, &postures, &viscous, &press, &demands)?;

    let settings = Settings {
        period,
        joints: JointLoop {
            kp: std::array::from_fn(|j| tuning.joints[j].kp),
            kd: std::array::from_fn(|j| tuning.joints[j].kd),
        },
        force: ForceSettings { kp: tuning.force.kp, ki: tuning.force.ki, range: [-AWAY, 0.3], rate: 0.2 },
        torque,
        velocity,
        patience: 5,
        contact: 0.1 * task.force,
        lost_after: 0.05,
        regain: 0.03,
        give_up: 2.0,
        most: 4.0 * task.force + 50.0,
        carry: task.law.carry,
        feed: task.law.feed,
        aside: task.law.aside,
        aside_pole: ASIDE_POLE,
        drag: task.law.drag,
        corner: task.corner,
        limits: limits_of(known.robot, &std::array::from_fn(|j| tuning.joints[j].kp), &torque),
        stop: STOP,
    };
    let mut controller = Controller::new(lend(), settings)?;
    let estimator = EstimatorSettings {
        period,
        corner: task.corner,
        weights: std::array::from_fn(|j| 1.0 / (known.spread[j] * known.spread[j]).max(1e-12)),
        damping: 1e-4,
        moment: task.moment,
        turning: std::array::from_fn(|j| known.doubt[j]),
        rest: [STANDING; N],
    };
    let mut estimator = Estimator::new(lend(), estimator);
    let (mut sensor, mut low) = (WallSensor::new(task.seed), [0.0; 3]);
    let turn = std::f64::consts::TAU * task.corner * period;
    let share = turn / (1.0 + turn);
    let (mut trace, mut pace) = (Trace::default(), Vec::new());
    let (mut status, mut idle, mut wiping) = (Status::Free, 0.0, 0);
    let paints = REST + COME + task.settle.max(0.0);
    let run = Sampled {
        start: start.to_vec(),
        seconds: paints + seconds,
        sensors: task.sensors.clone(),
        solver: Solver { tolerance: TOLERANCE, ..Solver::default() },
        seed: task.seed,
    };
    let external: [&dyn External; 1] = [&task.wall];
    let mut planned = lend();
    real.run_sampled(&run, &external, &mut |seen, is, torque| {
        let q: [f64; N] = std::array::from_fn(|j| seen.q[j]);
        let tau: [f64; N] = std::array::from_fn(|j| seen.tau[j]);
        let truth: f64 = (0..3).map(|k| -press[k] * is.wrench[k]).sum();
        let mut from = sensor.read(truth);
        for stage in &mut low {
            *stage += share * (from - *stage);
            from = *stage;
        }
        let measured = low[2];
        let push = estimator.step(&q, &tau).map_or([f64::NAN; 3], |w| [w[0], w[1], w[2]]);
        let estimated: f64 = (0..3).map(|k| press[k] * push[k]).sum();
        let force = match task.feedback {
            Feedback::Estimated => estimated,
            Feedback::Measured => measured,
        };
        let t = seen.t;
        let target = if t < REST + COME {
            let s = ((t - REST) / COME).clamp(0.0, 1.0);
            let along = [
                s * s * s * (10.0 + s * (6.0 * s - 15.0)),
                30.0 * s * s * (1.0 - s) * (1.0 - s) / COME,
                60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / (COME * COME),
            ];
            let [q, dq, ddq] = along.map(|s| std::array::from_fn(|j| s * (first[j] - start[j])));
            Target { q: std::array::from_fn(|j| start[j] + q[j]), dq, ddq, normal: press, force: None, ahead: 0.0 }
        } else if let Some(wiped) =
            wiped.as_ref().filter(|w| (w.span().start..w.span().end).contains(&(t - REST - COME)))
        {
            let mut points = vec![[0.0; 3]; N];
            wiped.at(t - REST - COME, &mut wiping, &mut points);
            let [q, dq, ddq] = std::array::from_fn(|d| std::array::from_fn(|j| points[j][d]));
            Target { q, dq, ddq, normal: press, force: Some(task.force), ahead: 0.0 }
        } else {
            let [q, dq, ddq] = moment(span.start + (t - paints).max(0.0));
            let moves = f64::from(u8::from(t >= paints));
            Target {
                q,
                dq: dq.map(|v| moves * v),
                ddq: ddq.map(|a| moves * a),
                normal: press,
                force: Some(task.force),
                ahead: task.learned.map_or(0.0, |l| l.at(t - paints)),
            }
        };
        let command = controller.step(&target, &Sample { t, q, force, push });
        torque.copy_from_slice(&command.torque);
        status = command.status;
        if t >= paints {
            if status != Status::Pressing {
                idle += period;
            }
            pace.push(target.dq.iter().fold(0.0_f64, |most, v| most.max(v.abs())));
            trace.t.push(t - paints);
            trace.estimated.push(estimated);
            trace.measured.push(measured);
            trace.truth.push(truth);
            trace.displacement.push(command.displacement);
            trace.planned.push(planned.contact(&target.q).origin);
            trace.actual.push(std::array::from_fn(|i| {
                is.pose[4 * i + 3] + (0..3).map(|k| is.pose[4 * i + k] * task.wall.contact[k]).sum::<f64>()
            }));
        }
        if trace.t.len() % 64 == 0 {
            progress(t / run.seconds);
        }
        true
    })?;
    let rms = |difference: &dyn Fn(usize) -> f64| root_mean_square(trace.t.len(), difference);
    let n = task.wall.normal;
    let aside = |k: usize| {
        let d: [f64; 3] = std::array::from_fn(|i| trace.actual[k][i] - trace.planned[k][i]);
        let out: f64 = (0..3).map(|i| d[i] * n[i]).sum();
        (0..3).map(|i| (d[i] - out * n[i]).powi(2)).sum::<f64>().sqrt()
    };
    let accuracy = Accuracy {
        estimated_measured: rms(&|k| trace.estimated[k] - trace.measured[k]),
        estimated_desired: rms(&|k| trace.estimated[k] - task.force),
        measured_desired: rms(&|k| trace.measured[k] - task.force),
    };
    let fed_back = match task.feedback {
        Feedback::Estimated => &trace.estimated,
        Feedback::Measured => &trace.measured,
    };
    let next = (status == Status::Pressing && idle == 0.0).then(|| {
        let error: Vec<f64> = fed_back.iter().map(|f| task.force - f).collect();
        let gains: Vec<[f64; 2]> = tuning.joints.iter().map(|j| [j.kp, j.kd]).collect();
        let count = (seconds / APART).ceil().max(1.0) as usize;
        let at = |k: usize| moment(span.start + seconds * k as f64 / count as f64)[0];
        let plants: Option<Vec<_>> =
            (0..=count).map(at).map(|q| plant(&mut lent, &q, &viscous, &press, &demands, &gains, true)).collect();
        learned(&plants?, [tuning.force.kp, tuning.force.ki], &error, &pace, period, task.learned)
    });
    Ok(Run { accuracy, tracking: rms(&aside), off: idle, status, tuning, learned: next.flatten(), trace })
}

/// Of `len` values; no number where there is none: a run that ended before it painted has no error.
pub(super) fn root_mean_square(len: usize, of: &dyn Fn(usize) -> f64) -> f64 {
    let sum: f64 = (0..len).map(|k| of(k).powi(2)).sum();
    (sum / len as f64).sqrt()
}
