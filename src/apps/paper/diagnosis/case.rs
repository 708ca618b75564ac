//! One test case: a seed draws arm, hidden effects, motion and noise; the simulator writes logs;
//! the diagnosis reads files only.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use dh_codegen::arm::param;
use dh_codegen::robot::{EffectKind, Robot, no_files};

use super::super::ReproduceError;
use super::DiagnosisSettings;
use super::draft::{Draft, effects};
use super::hidden::{FRICTION, Hidden, JointScales, Outside, SAME_JOINT, Wanted};
use crate::data::log::{Acceptance, Log, Quantity, csv, open};
use crate::data::signal::{Prepare, central, central_second, each_motion, lower_cutoff};
use crate::diagnose::{self, Diagnosis, Recording};
use crate::model::perturbable_robot::PerturbableRobot;
use crate::model::{Arm, States};
use crate::numerics::prng::Random;
use crate::numerics::sums::root_mean_square as rms;
use crate::simulate::{Control, Mode, Request, Sensors, Simulator, Trajectory};

/// Arms with known links. `PUMA` has torque limits, N m, for the arm whose file has none
/// (Armstrong, Khatib and Burdick 1986).
const ARMS: [(&str, &str); 6] = [
    ("kuka-lwr4", include_str!("../../../../robots/kuka-lwr4.yaml")),
    ("franka-panda", include_str!("../../../../robots/franka-panda.yaml")),
    ("ur10e", include_str!("../../../../robots/ur10e.yaml")),
    ("puma560", include_str!("../../../../robots/puma560.yaml")),
    ("kuka-iiwa14", include_str!("../../../../robots/kuka-iiwa14.yaml")),
    ("kinova-gen3", include_str!("../../../../robots/kinova-gen3.yaml")),
];
const PUMA: [f64; 6] = [97.6, 186.4, 89.4, 24.2, 20.1, 21.3];

/// Noise of a joint's torque relative to its limit.
const NOISE: f64 = 1e-3;

/// Kind of case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CaseKind {
    /// Nothing is hidden.
    Nothing,
    /// One effect of the vocabulary.
    One(Wanted),
    /// One effect, and a robot file without link parameters.
    NoLinks(EffectKind),
    /// Two effects on one joint.
    OneJoint([EffectKind; 2]),
    /// Two effects on two joints.
    TwoJoints([EffectKind; 2]),
    /// A friction law, and link parameters that differ from the file's.
    WrongLinks(EffectKind),
    /// Structure outside the vocabulary.
    Outside(usize),
}

/// Number of cases per round with two effects on one joint, two on two joints, a law and a wrong
/// link, a law in a file without links, and structure outside the vocabulary.
const SEVERAL: [usize; 5] = [3, 3, 2, 2, 3];

/// Number of kinds in a round of cases: nothing, every single effect, and the rest.
pub(super) const KINDS: usize = 1 + Wanted::ALONE + SEVERAL[0] + SEVERAL[1] + SEVERAL[2] + SEVERAL[3] + SEVERAL[4];

impl CaseKind {
    /// Kind of the case with this seed.
    pub(super) fn of(seed: u64, random: &mut Random) -> Self {
        let kind = (seed % KINDS as u64) as usize;
        let friction = |random: &mut Random| FRICTION[random.below(FRICTION.len())];
        let Some(number) = kind.checked_sub(1) else { return Self::Nothing };
        if number < Wanted::ALONE {
            return Self::One(Wanted::alone(number));
        }
        let mut left = number - Wanted::ALONE;
        let group = SEVERAL.iter().position(|&cases| {
            let here = left < cases;
            left -= if here { 0 } else { cases };
            here
        });
        match group {
            Some(0) => Self::OneJoint(SAME_JOINT[random.below(SAME_JOINT.len())]),
            Some(1) => {
                let first = random.below(FRICTION.len());
                let second = (first + 1 + random.below(FRICTION.len() - 1)) % FRICTION.len();
                Self::TwoJoints([FRICTION[first], FRICTION[second]])
            }
            Some(2) => Self::WrongLinks(friction(random)),
            Some(3) => Self::NoLinks(friction(random)),
            _ => Self::Outside(left),
        }
    }

    /// Hidden effects with their joints, from 0. `joint` is the first joint, `apart` another, and
    /// `link` that of a wrong link.
    fn effects(self, joint: usize, apart: usize, link: usize) -> Vec<(Wanted, usize)> {
        match self {
            Self::Nothing | Self::Outside(_) => Vec::new(),
            Self::One(wrong_link @ Wanted::Effect(EffectKind::LinkInertiaError)) => vec![(wrong_link, link)],
            Self::One(wanted) => vec![(wanted, joint)],
            Self::NoLinks(law) => vec![(Wanted::Effect(law), joint)],
            Self::OneJoint([a, b]) => vec![(Wanted::Effect(a), joint), (Wanted::Effect(b), joint)],
            Self::TwoJoints([a, b]) => vec![(Wanted::Effect(a), joint), (Wanted::Effect(b), apart)],
            Self::WrongLinks(law) => {
                vec![(Wanted::Effect(law), joint), (Wanted::Effect(EffectKind::LinkInertiaError), link)]
            }
        }
    }
}

/// Outcome of a diagnosed case.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// Seed of the case.
    pub seed: u64,
    /// Name of the arm.
    pub robot: &'static str,
    /// Kind of case.
    pub task: CaseKind,
    /// Hidden effects.
    pub hidden: Vec<Hidden>,
    /// Standard deviation of each joint's torque noise including the sensor's resolution, N m.
    pub noise: Vec<f64>,
    /// Attainable error: that of the file on the validating motion if nothing is hidden, N m. Over
    /// all samples, and where the joint moves.
    pub attainable: [Vec<f64>; 2],
    /// Found causes.
    pub found: Diagnosis,
}

/// Cache of robot models and simulators by robot file, as they are costly to make.
#[derive(Default)]
pub(super) struct Plants {
    plants: Mutex<HashMap<String, Arc<PerturbableRobot>>>,
    /// Simulators of arms in which nothing is hidden.
    simulators: Mutex<HashMap<String, Arc<Simulator>>>,
}

impl Plants {
    fn of(&self, robot: &Robot) -> Result<(Robot, Arc<PerturbableRobot>), ReproduceError> {
        let text = robot.to_yaml();
        let read = Robot::from_yaml(&text, &no_files);
        let robot = read.map_err(ReproduceError::in_file("written robot"))?.robot;
        let lock = || self.plants.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = lock().get(&text) {
            return Ok((robot, known.clone()));
        }
        let made = Arc::new(PerturbableRobot::new(&robot));
        lock().insert(text, made.clone());
        Ok((robot, made))
    }

    /// Simulator of an arm as its file describes it.
    fn plain(&self, robot: &Robot) -> Result<Arc<Simulator>, ReproduceError> {
        let text = robot.to_yaml();
        let lock = || self.simulators.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = lock().get(&text) {
            return Ok(known.clone());
        }
        let made = Arc::new(Simulator::new(robot, &effects(robot, &[]))?);
        lock().insert(text, made.clone());
        Ok(made)
    }
}

/// Robot file of an arm, with friction on every joint.
fn arm(number: usize) -> Result<(&'static str, Robot), ReproduceError> {
    let (name, text) = ARMS[number];
    let read = Robot::from_yaml(text, &no_files);
    let mut robot = read.map_err(ReproduceError::in_file(name))?.robot;
    robot.tool = None;
    for (j, row) in robot.moving().into_iter().enumerate() {
        let joint = &mut robot.joints[row];
        if name == "puma560" {
            joint.limits.torque = Some(PUMA[j]);
        }
        let limit = joint.limits.torque.unwrap_or(50.0);
        let drive = &mut joint.drive;
        let some = |value: Option<f64>, share: f64| Some(value.filter(|v| *v > 0.0).unwrap_or(share * limit));
        drive.viscous_friction = some(drive.viscous_friction, 0.02);
        drive.coulomb_friction = some(drive.coulomb_friction, 0.015);
    }
    Ok((name, robot))
}

/// Draws a motion of five sines per joint from a tenth of a hertz up, within the limits.
fn motion(robot: &Robot, seconds: f64, random: &mut Random) -> Result<Trajectory, ReproduceError> {
    let knots = (seconds * 50.0).ceil() as usize + 1;
    let t: Vec<f64> = (0..knots).map(|k| k as f64 / 50.0).collect();
    let rows = robot.moving();
    let [mut q, mut dq, mut ddq] = std::array::from_fn(|_| Vec::with_capacity(rows.len() * knots));
    for &row in &rows {
        let limits = &robot.joints[row].limits;
        let [low, high] = limits.position.unwrap_or([-2.0, 2.0]);
        let (low, high) = (low.max(-2.6), high.min(2.6));
        let fastest = limits.velocity.unwrap_or(2.0).min(2.5);
        let waves: [[f64; 3]; 5] = std::array::from_fn(|k| {
            let w = std::f64::consts::TAU * (0.1 * (k + 1) as f64 + random.uniform(0.0, 0.05));
            [random.uniform(0.3, 1.0) / (k + 1) as f64, w, random.uniform(0.0, std::f64::consts::TAU)]
        });
        let at = |t: f64| {
            let mut s = [0.0; 3];
            for [a, w, p] in waves {
                let (sin, cos) = (w * t + p).sin_cos();
                s = [s[0] + a * sin, s[1] + a * w * cos, s[2] - a * w * w * sin];
            }
            s
        };
        let most = |k: usize| t.iter().map(|&t| at(t)[k].abs()).fold(1e-9, f64::max);
        let scale = (0.45 * (high - low) / most(0)).min(0.7 * fastest / most(1));
        for &t in &t {
            let s = at(t);
            q.push(0.5 * (low + high) + scale * s[0]);
            dq.push(scale * s[1]);
            ddq.push(scale * s[2]);
        }
    }
    Trajectory::new(rows.len(), t, q, Some(dq), Some(ddq)).map_err(|e| ReproduceError::Simulate(e.into()))
}

/// Torque error of a simulation of the given file on a noise-free log, per joint, N m.
fn missed(log: &Log, plant: &PerturbableRobot, standard: &[f64], rate: f64) -> Vec<Vec<f64>> {
    let (dof, len) = (plant.dof(), log.len());
    let row = |quantity: Quantity, j: usize| log.joint(quantity, j).map(<[f64]>::to_vec).unwrap_or_default();
    let mut states = States { len, q: Vec::new(), dq: Vec::new(), ddq: Vec::new() };
    for j in 0..dof {
        let q = row(Quantity::Q, j);
        states.dq.extend(central(&q, 1.0 / rate));
        states.ddq.extend(central_second(&q, 1.0 / rate));
        states.q.extend(q);
    }
    let mut model = vec![0.0; dof * len];
    plant.inverse_dynamics(&states, standard, &mut model);
    // The ends, with one-sided differences, are left out.
    let cut = 8.min(len / 4);
    (0..dof)
        .map(|j| {
            let tau = row(Quantity::Tau, j);
            (cut..len - cut).map(|k| tau[k] - model[j * len + k]).collect()
        })
        .collect()
}

/// Determines the size parameter for the desired effect of a cause.
struct Sizer<'a> {
    robot: &'a Robot,
    plant: &'a PerturbableRobot,
    standard: Vec<f64>,
    motion: &'a Trajectory,
    noise: &'a [f64],
    plain: Vec<Vec<f64>>,
}

/// Sampling rate for determining sizes, Hz.
const COARSE: f64 = 100.0;

impl<'a> Sizer<'a> {
    fn new(
        robot: &'a Robot,
        plant: &'a PerturbableRobot,
        motion: &'a Trajectory,
        noise: &'a [f64],
        simulator: &Simulator,
    ) -> Result<(Self, Vec<f64>), ReproduceError> {
        let standard = param::standard_values(robot).unwrap_or_default();
        let mut sizer = Self { robot, plant, standard, motion, noise, plain: Vec::new() };
        let log = sizer.exact(simulator)?;
        let dof = plant.dof();
        let peaks = (0..dof)
            .map(|j| log.joint(Quantity::Tau, j).unwrap_or(&[]).iter().fold(0.0_f64, |m, t| m.max(t.abs())))
            .collect();
        sizer.plain = missed(&log, plant, &sizer.standard, COARSE);
        Ok((sizer, peaks))
    }

    fn exact(&self, simulator: &Simulator) -> Result<Log, ReproduceError> {
        let request = Request {
            control: Control { mode: Mode::Exact, ..Control::default() },
            sensors: Sensors { desired: false, ..Sensors::perfect(COARSE) },
            ..Request::default()
        };
        Ok(simulator.run(self.motion, &request, &mut |_| {})?.log)
    }

    /// Root mean square change that an effect makes to the error of a simulation of the file,
    /// relative to the noise, on the relevant joint.
    fn ratio(&self, draft: &Draft, x: f64) -> Result<f64, ReproduceError> {
        let simulator = Simulator::new(self.robot, &effects(self.robot, &[(draft.clone(), x)]))?;
        let with = missed(&self.exact(&simulator)?, self.plant, &self.standard, COARSE);
        let of = |j: usize| {
            let change: Vec<f64> = with[j].iter().zip(&self.plain[j]).map(|(a, b)| a - b).collect();
            rms(&change) / self.noise[j]
        };
        Ok(match draft.joint {
            Some(j) if draft.own() => of(j),
            _ => (0..with.len()).map(of).fold(0.0, f64::max),
        })
    }

    /// Value of `x` at which the effect has the desired size, and that size; `None` if it would no
    /// longer be an effect of its kind.
    fn size(&self, draft: &Draft, wanted: f64) -> Result<Option<(f64, f64)>, ReproduceError> {
        let mut x = draft.start().min(draft.most());
        for _ in 0..6 {
            let now = self.ratio(draft, x)?;
            if !(now.is_finite() && now > 1e-3) {
                return Ok(None);
            }
            let by = wanted / now;
            if draft.linear() && x * by <= draft.most() {
                return Ok(Some((x * by, wanted)));
            }
            if (by - 1.0).abs() < 0.05 {
                return Ok(Some((x, now)));
            }
            if x >= draft.most() && by > 1.0 {
                return Ok(None);
            }
            // A clipped torque grows faster than the bound falls.
            let power = if draft.cause == EffectKind::TorqueSaturation { 0.6 } else { 1.0 };
            x = (x * by.powf(power).clamp(0.02, 50.0)).min(draft.most());
        }
        let now = self.ratio(draft, x)?;
        Ok(((0.7..1.4).contains(&(now / wanted))).then_some((x, now)))
    }
}

/// Reads a log of the simulator.
fn record(name: &str, bytes: &[u8], dof: usize) -> Result<Recording, ReproduceError> {
    record_keeping(name, bytes, dof, Acceptance::default())
}

/// Reads a log as the command does; a slow one with a lower cutoff.
pub(super) fn record_keeping(
    name: &str,
    bytes: &[u8],
    dof: usize,
    keep: Acceptance,
) -> Result<Recording, ReproduceError> {
    let (recording, _) = lower_cutoff(diagnose::HIGHEST, |cutoff| {
        let prepare = Prepare { keep, ..diagnose::preparation(cutoff) };
        let mut recording = Recording::new(name);
        each_motion(open(name, bytes)?.as_mut(), dof, &prepare, |motion| recording.absorb(motion))?;
        Ok(recording)
    })?;
    Ok(recording)
}

/// Draws and hides effects, records logs and diagnoses them.
pub(super) fn case(settings: &DiagnosisSettings, seed: u64, plants: &Plants) -> Result<Outcome, ReproduceError> {
    let mut random = Random::new(seed.wrapping_mul(0x9E37_79B9).wrapping_add(77));
    let task = if settings.clean { CaseKind::Nothing } else { CaseKind::of(seed, &mut random) };
    for _ in 0..20 {
        let number = random.below(settings.arms.min(ARMS.len()));
        if let Some(found) = attempt(settings, seed, task, number, plants, &mut random)? {
            return Ok(found);
        }
    }
    Err(ReproduceError::NothingToShow { seed })
}

/// Torque scales of a joint from the file, with its largest torque on the motion.
fn joint_scales(robot: &Robot, j: usize, limit: f64, peak: f64) -> JointScales {
    let drive = &robot.joints[robot.moving()[j]].drive;
    JointScales {
        limit,
        peak: peak.max(1e-6),
        viscous: drive.viscous_friction.unwrap_or(0.0),
        coulomb: drive.coulomb_friction.unwrap_or(0.0),
        rotor: drive.rotor_inertia.unwrap_or(0.0),
    }
}

fn attempt(
    settings: &DiagnosisSettings,
    seed: u64,
    task: CaseKind,
    number: usize,
    plants: &Plants,
    random: &mut Random,
) -> Result<Option<Outcome>, ReproduceError> {
    let (name, robot) = arm(number)?;
    let (robot, plant) = plants.of(&robot)?;
    let (dof, rows) = (robot.dof(), robot.moving());
    let limit = |j: usize| robot.joints[rows[j]].limits.torque.unwrap_or(50.0);
    let white: Vec<f64> = (0..dof).map(|j| NOISE * limit(j)).collect();
    let step: Vec<f64> = white.iter().map(|s| 0.5 * s).collect();
    let noise: Vec<f64> = white.iter().zip(&step).map(|(s, d)| (s * s + d * d / 12.0).sqrt()).collect();
    let first = motion(&robot, settings.seconds[0], random)?;
    let second = motion(&robot, settings.seconds[1], random)?;
    let plain = plants.plain(&robot)?;
    let (sizer, peaks) = Sizer::new(&robot, &plant, &first, &noise, &plain)?;
    let scales: Vec<JointScales> = (0..dof).map(|j| joint_scales(&robot, j, limit(j), peaks[j])).collect();
    let joint = random.below(dof);
    let apart = (joint + 1 + random.below(dof - 1)) % dof;
    // A body on the last link is the same as a payload and no case of its own.
    let link = random.below(dof - 1);
    let wanted = task.effects(joint, apart, link);
    let (mut sized, mut hidden) = (Vec::new(), Vec::new());
    for (effect, joint) in wanted {
        let draft = Draft::draw(effect, joint, &robot, &scales, random);
        let Some((x, size)) = sizer.size(&draft, settings.size)? else { return Ok(None) };
        hidden.push(draft.hidden(x, size));
        sized.push((draft, x));
    }
    let outside = match task {
        CaseKind::Outside(which) => {
            hidden.push(Hidden { cause: "unknown", joints: vec![joint + 1], truth: Vec::new(), size: settings.size });
            Some(Outside::draw(which, joint, dof, random))
        }
        _ => None,
    };

    let simulator = Simulator::new(&robot, &effects(&robot, &sized))?;
    // A push in one log is not in the other.
    let lasting: Vec<(Draft, f64)> =
        sized.iter().filter(|s| s.0.cause != EffectKind::ExternalContact).cloned().collect();
    let later =
        if lasting.len() < sized.len() { Some(Simulator::new(&robot, &effects(&robot, &lasting))?) } else { None };
    let encoder = [1e-5, 2e-5, 4e-5][random.below(3)];
    let jitter = random.uniform(0.0, 0.03) / settings.rate;
    let sensors = Sensors {
        rate: settings.rate,
        encoder: vec![encoder],
        torque_noise: white,
        torque_step: step,
        jitter,
        desired: false,
        ..Sensors::default()
    };
    // In a closed loop a torque that is clipped or lost in a gap changes the motion, and the
    // recorded torque matches it. To be a torque error, the motion must not depend on it.
    let open = sized.iter().any(|(d, _)| matches!(d.cause, EffectKind::TorqueSaturation | EffectKind::Backlash));
    let control = Control { mode: if open { Mode::Exact } else { settings.control }, ..Control::default() };
    let mut scale = None;
    let mut log =
        |name: &str, simulator: &Simulator, motion: &Trajectory, seed: u64| -> Result<Recording, ReproduceError> {
            let request = Request { control: control.clone(), sensors: sensors.clone(), seed, ..Request::default() };
            let mut log = simulator.run(motion, &request, &mut |_| {})?.log;
            if let Some(outside) = outside {
                let tau = |j: usize| log.joint(Quantity::Tau, j).map(<[f64]>::to_vec).unwrap_or_default();
                let series = outside.series(&log.columns[0], tau);
                // The second log has the same scale as the first.
                let by = *scale.get_or_insert_with(|| settings.size * noise[joint] / rms(&series).max(1e-12));
                if let Some(at) = log.layout.find(crate::data::log::Role::Joint(Quantity::Tau, joint)) {
                    log.columns[at].iter_mut().zip(&series).for_each(|(tau, s)| *tau += by * s);
                }
            }
            let mut bytes = Vec::new();
            csv::write(&log, &mut bytes).map_err(ReproduceError::Write)?;
            record(name, &bytes, dof)
        };
    let fit = log("fit", &simulator, &first, seed.wrapping_mul(2))?;
    let validate =
        log("validate", later.as_ref().unwrap_or(&simulator), &second, seed.wrapping_mul(2).wrapping_add(1))?;

    let clean = plain.run(
        &second,
        &Request {
            control: control.clone(),
            sensors: sensors.clone(),
            seed: seed.wrapping_mul(2).wrapping_add(1),
            ..Request::default()
        },
        &mut |_| {},
    )?;
    let mut bytes = Vec::new();
    csv::write(&clean.log, &mut bytes).map_err(ReproduceError::Write)?;
    let attainable = diagnose::misses(&*plant, &[record("clean", &bytes, dof)?], &diagnose::Settings::default());

    let (_, seen) = if let CaseKind::NoLinks(_) = task {
        let mut bare = robot.clone();
        bare.links.clear();
        plants.of(&bare)?
    } else {
        (robot, plant)
    };
    let found = diagnose::diagnose(&*seen, &[fit], &[validate], &diagnose::Settings::default(), &|_| {})?;
    Ok(Some(Outcome { seed, robot: name, task, hidden, noise, attainable, found }))
}
