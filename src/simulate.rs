//! Simulates a robot: true bodies, drives with all their effects, a controller and sensors. In:
//! robot file, effects and motion; out: a log and the true motion.
//!
//! `Robot + Effects -> Simulator` (true bodies, a [`Drive`] for each joint) `-> Plant` (an
//! ordinary differential equation) `-> Rosenbrock or Dormand-Prince -> Truth -> Sensors -> Log`.
//!
//! `tau` in the log is the motor's torque on the joint side of the gear, so `tau = M ddq + c + g +
//! rotor + friction + ...`. With [`Side::Link`] it is the torque that the gear transmits, and
//! `taum` is the motor's.
//!
//! ```
//! use denavit::simulate::{Control, Effects, Mode, Request, Sensors, Simulator, Trajectory};
//! use dh_codegen::robot::{Robot, no_files};
//!
//! let text = "
//! name: pendulum
//! convention: modified
//! gravity: [0, -9.81, 0]
//! joints: [ { type: revolute, torque: 20, drive: { friction: { coulomb_friction: 0.5 } } } ]
//! links: [ { M: 2, MS: [1, 0, 0], I: [0, 0.5, 0.5, 0, 0, 0] } ]
//! ";
//! let robot = Robot::from_yaml(text, &no_files)?.robot;
//! let simulator = Simulator::new(&robot, &Effects::default())?;
//! let swing = Trajectory::rest(&[0.3], 2.0)?;
//! let request = Request {
//!     control: Control { mode: Mode::Free, ..Control::default() },
//!     sensors: Sensors::perfect(100.0),
//!     ..Request::default()
//! };
//! let recording = simulator.run(&swing, &request, &mut |_| {})?;
//! assert_eq!(recording.log.len(), 201);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! No file access, no printing. Angles in rad, torques in N m (m and N for a prismatic joint), time
//! in s.

mod bristle;
mod contact;
mod control;
mod drive;
pub mod effects;
mod file;
mod inverse_simulation;
mod motion_warnings;
mod noise;
mod plant;
mod robot;
mod sampled;
mod sensors;
mod trajectory;

#[cfg(test)]
mod tests;

pub use crate::numerics::integrators::{Breakdown, Method, Solver};
pub use contact::{External, Wall, Wrench};
pub use control::{Control, Mode};
pub use dh_codegen::robot::{Effect, EffectKind, Effects};
pub use drive::Drive;
pub use file::SimulationFile;
pub use motion_warnings::motion_warnings;
pub use sampled::{Instant, Sampled, Seen};
pub use sensors::{Sensors, Side, Truth};
pub use trajectory::{Point, Trajectory, TrajectoryError};

use dh_codegen::robot::Robot;
use dh_codegen::robot::effects::GearCoupling;

use crate::data::log::Log;
use crate::model::{Arm, Dynamics, States};
use crate::numerics::integrators::Pace;
use crate::numerics::integrators::dormand_prince::DormandPrince;
use crate::numerics::integrators::rosenbrock::Rosenbrock;
use control::Table;
use plant::{Parts, Plant};
use robot::{Settled, SimulatedRobot, without_coulomb};

/// Errors of building or running a simulation.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SimulateError {
    /// A link without inertial parameters.
    #[error(
        "{robot} can't be simulated: {}; add a `links:` list with the inertial parameters of every joint's link, or identify them (`denavit identify`)",
        missing.map_or("the robot file has no `links`".to_string(), |row| format!("link {} is not known", row + 1))
    )]
    NoLinks {
        /// Name of the robot.
        robot: String,
        /// First row whose link is unknown, from 0; `None`: the file has no links.
        missing: Option<usize>,
    },
    /// Different numbers of joints in the trajectory and the robot.
    #[error(
        "the number of joints is {found} in the trajectory (counted by its columns q1 ..) and {expected} in the robot file; take the trajectory or the robot file that belongs to it"
    )]
    Joints {
        /// Joints of the trajectory.
        found: usize,
        /// Joints of the robot.
        expected: usize,
    },
    /// An effect parameter outside its range.
    #[error("{effect}{}: {key} is {value}; it must {must}", joint.map_or(String::new(), |joint| format!(" of joint {joint}")))]
    Effect {
        /// The effect.
        effect: EffectKind,
        /// Number of the joint, from 1; `None`: the effect concerns the whole robot.
        joint: Option<usize>,
        /// Key of the parameter.
        key: String,
        /// Given value.
        value: f64,
        /// Condition on the value.
        must: String,
    },
    /// A contact whose end is not later than its start.
    #[error("{}.end is {end}; it must be later than start", EffectKind::ExternalContact)]
    Contact {
        /// End of the contact, s.
        end: f64,
    },
    /// A wall with a stiffness but no normal, or the reverse.
    #[error("{}: {}", EffectKind::ExternalContact, if *.stiff { "k makes a wall, but it has no normal; write nx, ny, nz" } else { "nx, ny, nz are the normal of a wall, but it has no stiffness; write k in N/m" })]
    Wall {
        /// Whether it has a stiffness (and no normal).
        stiff: bool,
    },
    /// An effect on a link that does not exist.
    #[error("{}: {}; write the number of a link, 1 to {last}", effect, number.map_or("no `link` is named".to_string(), |n| format!("there is no link {n}")))]
    Link {
        /// The effect.
        effect: EffectKind,
        /// Given number of the link, from 1; `None`: no link is named.
        number: Option<usize>,
        /// Number of links.
        last: usize,
    },
    /// A closed-form law that reads a joint the robot does not have.
    #[error("the law of joint {joint} asks for joint {number}, and there are {last}; make it for this robot")]
    Law {
        /// Number of the joint with the law, from 1.
        joint: usize,
        /// Number of the missing joint, counted among the movable joints, from 1.
        number: usize,
        /// Number of movable joints.
        last: usize,
    },
    /// A law that reads accelerations in a mode other than exact, where they follow from the
    /// torques.
    #[error(
        "the law of joint {0} asks for accelerations, which follow from the torques where a controller moves the arm; only `--control exact` plays it"
    )]
    LawOfAcceleration(usize),
    /// A setting out of range.
    #[error("{what} is {value}; it must {must}")]
    Setting {
        /// Key of the setting.
        what: &'static str,
        /// Given value.
        value: f64,
        /// Condition on the value.
        must: &'static str,
    },
    /// A list of the wrong length.
    #[error("{what} has {found} values; write one, or one for each of the {expected} joints")]
    List {
        /// Key of the list.
        what: &'static str,
        /// Number of values.
        found: usize,
        /// Number of joints of the robot.
        expected: usize,
    },
    /// Torque control with a trajectory without torques.
    #[error(
        "control in torque mode plays the columns tau1..tau{0} of the trajectory, and it has none; add them, or control by position"
    )]
    NoTorques(usize),
    /// A value that is not finite.
    #[error("the simulation gave values that are not finite; look for effects or gains of an impossible size")]
    NotFinite,
    /// An invalid trajectory.
    #[error(transparent)]
    Trajectory(#[from] TrajectoryError),
    /// A failure of the integration.
    #[error("{0}")]
    Integration(#[from] Breakdown),
}

/// All settings of a run.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Request {
    /// Controller settings.
    pub control: Control,
    /// Recorded quantities and their accuracy.
    pub sensors: Sensors,
    /// Settings of the integrator.
    pub solver: Solver,
    /// Seed of the sensor noise.
    pub seed: u64,
}

/// Results of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Recording {
    /// Sensor readings, in the format of docs/logs.md.
    pub log: Log,
    /// True motion and torques.
    pub truth: Truth,
    /// Drives with all defaults resolved.
    pub drives: Vec<Drive>,
    /// Integration statistics; `None` in exact mode.
    pub integration: Option<Integration>,
}

impl Recording {
    /// Records the same run with other sensors, or with other noise. Rate, jitter and sides stay
    /// those of the run's instants.
    pub fn seen_by(&self, sensors: &Sensors, seed: u64) -> Log {
        sensors::record(&self.truth, &self.drives, sensors, seed)
    }
}

/// Statistics of an integration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Integration {
    /// Method used, never [`Method::Auto`].
    pub method: Method,
    /// Number of accepted steps.
    pub steps: usize,
    /// Number of rejected steps: too long, and repeated shorter.
    pub rejected: usize,
}

/// A robot prepared for simulation; can be run any number of times.
pub struct Simulator {
    built: SimulatedRobot,
}

impl Simulator {
    /// Builds a simulator from the robot, the effects of its file and `effects`. A law in `effects`
    /// replaces the file's law of the same name; plain friction, inertias and offsets add up.
    /// Building is the slow part: reuse the simulator for several runs.
    pub fn new(robot: &Robot, effects: &Effects) -> Result<Self, SimulateError> {
        Ok(Self { built: SimulatedRobot::new(robot, effects)? })
    }

    /// Degrees of freedom.
    pub fn dof(&self) -> usize {
        self.built.drives.len()
    }

    /// Drives as the files describe them; defaults that depend on the motion are not resolved.
    pub fn drives(&self) -> &[Drive] {
        &self.built.drives
    }

    /// Plays the motion. `progress` receives the current time of the motion, s, at intervals.
    pub fn run(
        &self,
        trajectory: &Trajectory,
        request: &Request,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Recording, SimulateError> {
        self.run_against(trajectory, request, &[], progress)
    }

    /// Plays the motion with external interactions such as walls.
    pub fn run_against(
        &self,
        trajectory: &Trajectory,
        request: &Request,
        external: &[&dyn External],
        progress: &mut dyn FnMut(f64),
    ) -> Result<Recording, SimulateError> {
        let n = self.dof();
        self.check(trajectory, request)?;
        let span = trajectory.span();
        let (feedforward, peak, gains) = self.prepare_control(trajectory, request);
        let places: Vec<Vec<f64>> = (0..=20)
            .map(|k| positions(trajectory, n, span.start + f64::from(k) / 20.0 * (span.end - span.start)))
            .collect();
        let settled = self.built.settle(&span, &peak, &places);
        let Settled { drives, couplings, contacts } = &settled;
        let carries = settled.couplings.iter().find(|c| c.carries != 0.0);
        if let Some(coupling) = carries.filter(|_| request.control.mode != Mode::Exact) {
            return Err(SimulateError::Effect {
                effect: EffectKind::GearCoupling,
                joint: None,
                key: GearCoupling::CQ.name().into(),
                value: coupling.carries,
                must: "be 0 where a controller moves the arm: only `--control exact` plays it".into(),
            });
        }
        let mut bodies = self.built.real().bodies(&self.built.bodies_standard);
        let mut plant = Plant::new(Parts {
            bodies: &mut bodies,
            drives,
            couplings,
            contacts,
            external,
            trajectory,
            control: &request.control,
            gains,
            feedforward,
        });
        let instants = request.sensors.instants(span.start, span.end, request.seed);
        let (truth, integration) = if request.control.mode == Mode::Exact {
            (inverse_simulation::follow(&self.built, &settled, &plant, trajectory, external, instants), None)
        } else {
            let (truth, integration) = integrate(&mut plant, request.solver, instants, progress)?;
            (truth, Some(integration))
        };
        let log = sensors::record(&truth, drives, &request.sensors, request.seed);
        if !log.columns.iter().flatten().all(|value| value.is_finite()) {
            return Err(SimulateError::NotFinite);
        }
        Ok(Recording { log, truth, drives: settled.drives.clone(), integration })
    }

    fn check(&self, trajectory: &Trajectory, request: &Request) -> Result<(), SimulateError> {
        let n = self.dof();
        if trajectory.dof() != n {
            return Err(SimulateError::Joints { found: trajectory.dof(), expected: n });
        }
        if request.control.mode == Mode::Torque && !trajectory.has_torques() {
            return Err(SimulateError::NoTorques(n));
        }
        if request.control.mode != Mode::Exact {
            self.built.is_free_of_accelerations()?;
        }
        let setting = |what, value: f64, good: bool, must| {
            if good { Ok(()) } else { Err(SimulateError::Setting { what, value, must }) }
        };
        let Sensors { rate, latency, jitter, colour_corner, .. } = request.sensors;
        setting("sensors.rate", rate, rate > 0.0 && rate <= 1e5, "be greater than 0, and at most 100000 Hz")?;
        setting("sensors.latency", latency, (0.0..10.0).contains(&latency), "be from 0 to 10 s")?;
        // Jitter is a standard deviation, and sensors.rs limits each shift to 0.45 periods. A
        // larger one is probably a mistake.
        let share = jitter * rate;
        setting("sensors.jitter", jitter, (0.0..=0.45).contains(&share), "be from 0 s to 0.45 sampling periods")?;
        setting("sensors.torque_noise_color.corner", colour_corner, colour_corner > 0.0, "be greater than 0")?;
        let Solver { tolerance, longest, .. } = request.solver;
        setting("solver.tolerance", tolerance, (1e-13..=1e-2).contains(&tolerance), "be from 1e-13 to 1e-2")?;
        setting("solver.step", longest, longest > 0.0 && longest.is_finite(), "be greater than 0")?;
        let Control { bandwidth, damping, .. } = request.control;
        setting(
            "control.bandwidth",
            bandwidth,
            bandwidth > 0.0 && bandwidth <= 1e4,
            "be greater than 0, and at most 10000 rad/s",
        )?;
        setting("control.damping", damping, (0.0..=100.0).contains(&damping), "be from 0 to 100")?;
        let samples = (trajectory.span().end - trajectory.span().start) * rate;
        setting("the number of samples", samples, samples < 1e8, "be less than 100 million: lower sensors.rate")?;
        let few = "reach to the second sample: raise sensors.rate, or give a longer motion";
        setting("the motion's time by the sampling period", samples, samples > 1.0 - 1e-9, few)?;
        let s = &request.sensors;
        let lists = [
            ("sensors.encoder", Some(&s.encoder)),
            ("sensors.position_noise", Some(&s.position_noise)),
            ("sensors.torque_noise", Some(&s.torque_noise)),
            ("sensors.torque_noise_color.std", Some(&s.torque_colour)),
            ("sensors.torque_step", Some(&s.torque_step)),
            ("sensors.velocity_noise", Some(&s.velocity_noise)),
            ("control.kp", request.control.kp.as_ref()),
            ("control.kd", request.control.kd.as_ref()),
        ];
        for (what, list) in lists {
            let Some(list) = list else { continue };
            if list.len() != n && list.len() != 1 {
                return Err(SimulateError::List { what, found: list.len(), expected: n });
            }
            for &value in list {
                setting(what, value, (0.0..=1e9).contains(&value), "be from 0 to 1e9")?;
            }
        }
        Ok(())
    }

    /// Feedforward torques, peak torques of the given model (N m), and the gains `[kp, kd]`.
    fn prepare_control(&self, trajectory: &Trajectory, request: &Request) -> (Table, Vec<f64>, [Vec<f64>; 2]) {
        let n = self.dof();
        let span = trajectory.span();
        // Table step 2 ms: the cubic's error is 1e-6 of the amplitude of a 5 Hz motion.
        let len = (((span.end - span.start) / 2e-3).ceil() as usize).clamp(2, 2_000_000) + 1;
        let step = (span.end - span.start) / (len - 1) as f64;
        let mut states = States::zeros(n, len);
        let (mut hint, mut points) = (0, vec![[0.0; 3]; n]);
        for s in 0..len {
            trajectory.at((span.start + s as f64 * step).min(span.end), &mut hint, &mut points);
            for (j, point) in points.iter().enumerate() {
                let at = j * len + s;
                (states.q[at], states.dq[at], states.ddq[at]) = (point[0], point[1], point[2]);
            }
        }
        let (given, standard) = (&self.built.given, &self.built.given_standard);
        let mut peak = vec![0.0; n];
        let mut torques = vec![0.0; n * len];
        given.inverse_dynamics(&states, standard, &mut torques);
        for j in 0..n {
            peak[j] = torques[j * len..(j + 1) * len].iter().fold(0.0, |a: f64, t| a.max(t.abs()));
        }
        // Forty postures along the motion are enough for a joint's peak inertia.
        let mut inertia = vec![0.0; n];
        let mut bodies = given.bodies(standard);
        let mut mass = vec![0.0; n * n];
        for s in (0..len).step_by(len.div_ceil(40)) {
            let q: Vec<f64> = (0..n).map(|j| states.q[j * len + s]).collect();
            bodies.mass_matrix(&q, &mut mass);
            (0..n).for_each(|j| inertia[j] = f64::max(inertia[j], mass[j * n + j]));
        }
        if request.control.mode == Mode::Pd {
            states.dq.fill(0.0);
            states.ddq.fill(0.0);
        }
        given.inverse_dynamics(&states, &without_coulomb(given, standard), &mut torques);
        let feedforward = Table { start: span.start, step, len, values: torques };

        let Control { bandwidth, damping, kp, kd, .. } = &request.control;
        let moved: Vec<f64> = (0..n).map(|j| inertia[j].max(0.0) + 0.003 * self.built.drives[j].rated).collect();
        let of = |list: &Option<Vec<f64>>, j: usize| list.as_ref().and_then(|l| l.get(j).or(l.first()).copied());
        let kp: Vec<f64> = (0..n).map(|j| of(kp, j).unwrap_or(bandwidth * bandwidth * moved[j])).collect();
        let kd = (0..n).map(|j| of(kd, j).unwrap_or(2.0 * damping * (kp[j] * moved[j]).sqrt())).collect();
        (feedforward, peak, [kp, kd])
    }
}

fn positions(trajectory: &Trajectory, n: usize, t: f64) -> Vec<f64> {
    let mut points = vec![[0.0; 3]; n];
    trajectory.at(t, &mut 0, &mut points);
    points.iter().map(|p| p[0]).collect()
}

/// Integrates from sample to sample and records the true quantities at each.
fn integrate(
    plant: &mut Plant<'_>,
    solver: Solver,
    instants: Vec<f64>,
    progress: &mut dyn FnMut(f64),
) -> Result<(Truth, Integration), Breakdown> {
    let method = match solver.method {
        Method::Auto if plant.is_stiff() => Method::Rosenbrock,
        Method::Auto => Method::DormandPrince,
        chosen => chosen,
    };
    let (mut rosenbrock, mut dormand_prince) = (Rosenbrock::default(), DormandPrince::default());
    let mut pace = Pace::new(solver);
    let mut y = plant.initial();
    let n = plant.drives.len();
    let total = plant.motor.iter().fold(n, |most, &m| most.max(m + 1));
    let len = instants.len();
    let start = instants.first().copied().unwrap_or(0.0);
    let mut t = start;
    let mut truth = Truth::sized(n, instants);
    for k in 0..len {
        let end = truth.t[k];
        match method {
            Method::DormandPrince => dormand_prince.advance(plant, &mut pace, t, end, &mut y)?,
            Method::Auto | Method::Rosenbrock => rosenbrock.advance(plant, &mut pace, t, end, &mut y)?,
        }
        t = end;
        plant.look(t, &y)?;
        for j in 0..n {
            let (at, m) = (j * len + k, plant.motor[j]);
            truth.motor_q[at] = y[m];
            truth.motor_dq[at] = y[total + m];
            truth.link_q[at] = y[j];
            truth.link_dq[at] = y[total + j];
            truth.motor_torque[at] = plant.now.motor_torque[j];
            truth.link_torque[at] = plant.now.link_torque[j];
            truth.desired[at] = plant.now.desired[j];
            truth.temperature[at] = plant.drives[j].temperature(t - start);
        }
        (0..6).for_each(|i| truth.wrench[i * len + k] = plant.now.wrench[i]);
        if k % 64 == 0 {
            progress(t);
        }
    }
    Ok((truth, Integration { method, steps: pace.steps, rejected: pace.rejected }))
}
