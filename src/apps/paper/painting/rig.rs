//! A robot with its model and its rollers.

use dh_codegen::arm::param;
use dh_codegen::robot::{Effects, Robot, Tool};

use super::super::ReproduceError;
use super::super::Watch;
use super::super::chain::{factors, fit};
use super::super::fig6;
use super::super::lwr::{Lwr, Unmodelled};
use super::super::many::many;
use super::super::motions::PaperMotion;
use super::plans::{Extent, ROOM, in_the_air, planned};
use crate::apps::painting::Plan;
use crate::apps::painting::run::{Feedback, Known, Law, Run, RunTask, in_contact, roller_moment, run};
use crate::apps::painting::wall::RollerWall;
use crate::control::iterative_learning::Learned;
use crate::control::robot::{RobotModel, contact_point};
use crate::data::log::{Log, Replay};
use crate::data::signal::{Filter, each_motion};
use crate::diagnose::{self, Diagnosis};
use crate::identify::tool::{Carrying, ToolSettings, catalogue, identify_tool};
use crate::identify::{
    Accuracy, ConsistentSettings, Factors, consistent, geometric_bodies, possible_bodies, prior_bodies,
};
use crate::model::interpreted::Interpreted;
use crate::model::inverse_kinematics::Kinematics;
use crate::model::perturbable_robot::PerturbableRobot;
use crate::model::robot_edit;
use crate::model::{Arm, LinkExtents};
use crate::simulate::{Drive, Request, SimulateError, Simulator, Trajectory};

/// The paper's desired force, N.
pub const FORCE: f64 = 30.0;
/// Centre of the paper's wall, m, and the normal out of it: the robot is at x = 0 and pushes along
/// -x.
pub const CENTER: [f64; 3] = [-0.8, 0.3, 0.4];
pub const NORMAL: [f64; 3] = [1.0, 0.0, 0.0];
/// Corner frequency of the forces' low-pass, Hz: the paper filters at 10 Hz.
const CORNER: f64 = 10.0;
/// Number of samples averaged to one for the diagnosis.
const THIN: usize = 4;
/// Largest ratio of torque error to filtered noise at which noise explains the error: the root mean
/// square of 20 s below 10 Hz scatters by a thirtieth.
const EXPLAINED: f64 = 1.25;
/// Distance of a dry run from the wall, m.
const DRY: f64 = 0.05;

/// The arm with a roller: the true one and its model.
pub struct Rig {
    /// Robot with the tool's frame; the tool's inertia is part of `standard`.
    robot: Robot,
    arm: Interpreted,
    standard: Vec<f64>,
    drives: Vec<Drive>,
    spread: Vec<f64>,
    turning: Vec<f64>,
    real: Simulator,
    motion: Trajectory,
    settle: f64,
    /// Plan of the motion.
    pub plan: Plan,
}

impl Rig {
    /// Duration of the plan, s.
    pub fn seconds(&self) -> f64 {
        let span = self.motion.span();
        span.end - span.start
    }

    /// Simulates the painting.
    pub fn paint(
        &self,
        law: Law,
        feedback: Feedback,
        learned: Option<&Learned>,
        seed: u64,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Run, ReproduceError> {
        // Equation (14) is the paper's; the prior on a roller's contact and the uncertainty of
        // friction are ours.
        let paper = law == Law::PAPER;
        let known = Known {
            robot: &self.robot,
            arm: &self.arm,
            standard: &self.standard,
            drives: self.drives.clone(),
            spread: self.spread.clone(),
            turning: if paper { vec![0.0; self.turning.len()] } else { self.turning.clone() },
        };
        let task = RunTask {
            motion: &self.motion,
            wall: RollerWall::new(CENTER, NORMAL, contact_point(self.robot.tool.as_ref())),
            force: FORCE,
            feedback,
            moment: if paper { f64::INFINITY } else { roller_moment(self.robot.tool.as_ref(), FORCE) },
            law,
            corner: CORNER,
            settle: self.settle,
            learned,
            sensors: Lwr::sensors(),
            seed,
        };
        Ok(run(&known, &self.real, &task, progress)?)
    }
}

/// A robot with its recordings and identified models.
pub struct Stand {
    /// Held-out torque error, mean over the joints, N m.
    pub torque: f64,
    /// Rig for each of the paper's rollers.
    pub rollers: Vec<Rig>,
    settle: f64,
    /// Largest friction error of each joint just after a reversal, N m: see [`Known::turning`].
    turning: Vec<f64>,
    effects: Effects,
    tools: Vec<(Tool, [f64; 10])>,
    /// The identified arm without a tool.
    identified: Robot,
    logs: Vec<(&'static str, Log)>,
    validate: Log,
}

/// Means over `by` samples each, as a logger at a lower rate would record: a diagnosis of motion
/// below 40 Hz does not need 1 kHz.
fn thinned(log: &Log, by: usize) -> Log {
    let ends = log.starts.iter().skip(1).copied().chain([log.columns.first().map_or(0, Vec::len)]);
    let segments: Vec<_> = log.starts.iter().copied().zip(ends).collect();
    let mut thin = Log { columns: vec![Vec::new(); log.columns.len()], starts: Vec::new(), ..log.clone() };
    for (start, end) in segments {
        thin.starts.push(thin.columns.first().map_or(0, Vec::len));
        for (column, thin) in log.columns.iter().zip(&mut thin.columns) {
            let means = column[start..end].chunks_exact(by).map(|part| part.iter().sum::<f64>() / by as f64);
            thin.extend(means);
        }
    }
    thin
}

fn tools() -> Result<Vec<Tool>, ReproduceError> {
    super::PAPER
        .iter()
        .map(|(name, _)| {
            let found = catalogue().into_iter().find(|t| t.name == *name);
            found.ok_or_else(|| ReproduceError::NoTool((*name).into()))
        })
        .collect()
}

impl Stand {
    /// Records and identifies: the arm with the first motion and the rollers with the second,
    /// validated on the third; also records a dry run before the wall.
    pub fn new(
        lwr: &Lwr,
        [exciting, carrying, validating]: [&PaperMotion; 3],
        which: &[Unmodelled],
        extent: &Extent,
        seed: u64,
        plans: Option<&[Plan]>,
        tell: Watch<'_>,
    ) -> Result<Self, ReproduceError> {
        let effects = lwr.effects(which)?;
        let record = |robot: &Robot, motion: &Trajectory, seed: u64| -> Result<Log, ReproduceError> {
            let simulator = Simulator::new(robot, &effects)?;
            let request = Request { sensors: Lwr::sensors(), seed, ..Request::default() };
            Ok(simulator.run(motion, &request, &mut |_| {})?.log)
        };
        let tools: Vec<Tool> = tools()?.into_iter().take(extent.seconds.len()).collect();
        let one = |k: usize| -> Result<Log, ReproduceError> {
            let seed = seed.wrapping_add(k as u64);
            match k.checked_sub(2).and_then(|k| tools.get(k)) {
                None => record(&lwr.robot, if k == 0 { &exciting.played } else { &validating.played }, seed),
                Some(tool) => {
                    let mut robot = lwr.robot.clone();
                    robot.tool = Some(tool.clone());
                    record(&robot, &carrying.played, seed)
                }
            }
        };
        let mut recorded =
            many(2 + tools.len(), &one, &|what, share| tell(&format!("recording: {what}"), 0.4 * share))?;
        let carried = recorded.split_off(2);
        let [excited, validate] =
            <[Log; 2]>::try_from(recorded).map_err(|_| ReproduceError::Missing("logs to fit and to validate"))?;
        tell("identifying", 0.4);
        let (standard, rms) =
            bodies(lwr, factors("logdet", &lwr.arm, &excited, 1)?, factors("validate", &lwr.arm, &validate, 1)?)?;
        let identified = robot_edit::with_values(lwr.robot.clone(), &standard);

        let mut held = Vec::new();
        let unloaded = factors("unloaded", &Carrying::new(&lwr.arm, false), &excited, 1)?;
        tell("weighing the rollers", 0.6);
        for (tool, loaded) in tools.into_iter().zip(carried) {
            let loaded = factors("loaded", &Carrying::new(&lwr.arm, true), &loaded, 1)?;
            let found = identify_tool(&lwr.arm, std::slice::from_ref(&unloaded), &[loaded], &ToolSettings::default())?;
            held.push((tool, found.values));
        }
        let torque = fig6::mean(&rms);
        let plans = match plans {
            Some(plans) => plans.to_vec(),
            None => plan_all(&identified, &held, extent, tell)?,
        };
        // If torque errors exceed noise, the model lacks something, possibly friction that takes
        // some travel to reverse.
        let gain = Filter::default().noise_gain(Lwr::sensors().rate);
        let noise = |j: usize| gain * Lwr::sensors().torque_noise.get(j).copied().unwrap_or(0.0);
        let unmodelled = |(j, rms): (usize, &f64)| if *rms > EXPLAINED * noise(j) { f64::INFINITY } else { 0.0 };
        let turning: Vec<f64> = rms.iter().enumerate().map(unmodelled).collect();
        let rollers = rollers(&identified, &held, &plans, lwr, &effects, [&rms, &turning], extent.settle)?;
        tell("dry run", 0.9);
        let before = {
            let first = &rollers[0];
            let bodies = Box::new(first.arm.bodies(&first.standard));
            let kinematics = Kinematics::new(&first.robot, first.arm.model());
            let mut model = RobotModel::new(&first.robot, bodies, kinematics.as_ref(), first.drives.clone());
            in_the_air(&mut model, &first.motion, DRY)?
        };
        let dry = record(&lwr.robot, &before, seed.wrapping_add(9))?;
        let logs = vec![("exciting", excited), ("dry run", dry)];
        Ok(Self { torque, rollers, settle: extent.settle, turning, effects, tools: held, identified, logs, validate })
    }

    /// The same robot with the model extended by the diagnosis.
    pub fn extended(&self, lwr: &Lwr, progress: &(dyn Fn(&str) + Sync)) -> Result<(Self, Diagnosis), ReproduceError> {
        let plant = PerturbableRobot::new(&self.identified);
        let recording = |name: &str, log: &Log| -> Result<diagnose::Recording, ReproduceError> {
            let prepare = diagnose::preparation(diagnose::HIGHEST);
            let mut recording = diagnose::Recording::new(name);
            each_motion(&mut Replay::new(&thinned(log, THIN)), lwr.robot.dof(), &prepare, |motion| {
                recording.absorb(motion)
            })?;
            Ok(recording)
        };
        let logs = self.logs.iter().map(|(name, log)| recording(name, log)).collect::<Result<Vec<_>, _>>()?;
        let validate = [recording("validate", &self.validate)?];
        let found = diagnose::diagnose(&plant, &logs, &validate, &diagnose::Settings::default(), progress)?;
        let robot = diagnose::extended(self.identified.clone(), &found);
        let rms = &found.extended.validate;
        let plans: Vec<Plan> = self.rollers.iter().map(|r| r.plan.clone()).collect();
        // A diagnosis finds the size of friction rather than its course at a reversal, so the
        // uncertainty there remains.
        let rollers = rollers(&robot, &self.tools, &plans, lwr, &self.effects, [rms, &self.turning], self.settle)?;
        let extended = Self {
            torque: fig6::mean(rms),
            rollers,
            settle: self.settle,
            turning: self.turning.clone(),
            effects: self.effects.clone(),
            tools: self.tools.clone(),
            identified: robot,
            logs: Vec::new(),
            validate: self.validate.clone(),
        };
        Ok((extended, found))
    }
}

/// Standard parameters of physically consistent bodies, and their held-out torque errors. Least
/// squares alone may give a mass matrix that is not positive definite, for which there are no
/// gains. If consistent bodies have exactly the fitted base parameters, these are used; otherwise
/// those that explain the log best. The only prior knowledge is the geometry.
fn bodies(lwr: &Lwr, fitted: Factors, held_out: Factors) -> Result<(Vec<f64>, Vec<f64>), ReproduceError> {
    let found = fit(lwr, &fitted, &held_out)?;
    let prior = prior_bodies(&[], &geometric_bodies(&lwr.arm.ends()));
    let drives = vec![0.0; lwr.arm.standard_names().len()];
    // The cost of consistency appears in the table as torque errors.
    let settings = ConsistentSettings { most_cost_percent: f64::INFINITY, ..ConsistentSettings::default() };
    let rms = |of: &Option<Accuracy>| of.as_ref().map_or_else(Vec::new, |v| v.rms.clone());
    if let Ok(same) = possible_bodies(&lwr.arm, &found.values(), &prior, &drives, &settings)
        && same.exact
    {
        return Ok((same.standard, rms(&found.validation)));
    }
    let possible = consistent(&lwr.arm, &[fitted], &[held_out], &found, &prior, &drives, &settings)?;
    let errors = rms(&possible.cost.validation);
    Ok((possible.standard, errors))
}

/// The robot with a tool's frame, and its parameters including the identified tool.
fn holding(known: &Robot, tool: &Tool, weighed: &[f64; 10]) -> Result<(Robot, Vec<f64>), ReproduceError> {
    let mut robot = known.clone();
    robot.tool = None;
    let standard = param::standard_values(&robot);
    let mut standard = standard.ok_or(ReproduceError::UnknownLinks)?;
    // Parameters are stored ten per link, links first.
    let last = 10 * (robot.joints.len() - 1);
    weighed.iter().enumerate().for_each(|(k, w)| standard[last + k] += w);
    robot.tool = Some(Tool { inertia: None, ..tool.clone() });
    Ok((robot, standard))
}

fn plan_all(
    known: &Robot,
    tools: &[(Tool, [f64; 10])],
    extent: &Extent,
    tell: Watch<'_>,
) -> Result<Vec<Plan>, ReproduceError> {
    let jobs: Vec<_> = tools.iter().zip(extent.seconds).collect();
    let one = |k: usize| {
        let ((tool, weighed), seconds) = jobs[k];
        let (robot, standard) = holding(known, tool, weighed)?;
        let tell = |what: &str, share: f64| tell(&format!("planning: {what}"), 0.7 + 0.2 * share);
        planned(&robot, &standard, FORCE, extent, *seconds, &tell).map_err(ReproduceError::design("the plan"))
    };
    many(jobs.len(), &one, &|_, _| {})
}

/// Models of the arm with each identified roller.
fn rollers(
    known: &Robot,
    tools: &[(Tool, [f64; 10])],
    plans: &[Plan],
    lwr: &Lwr,
    effects: &Effects,
    [spread, turning]: [&[f64]; 2],
    settle: f64,
) -> Result<Vec<Rig>, ReproduceError> {
    let mut all = Vec::new();
    for ((tool, weighed), plan) in tools.iter().zip(plans) {
        let (robot, standard) = holding(known, tool, weighed)?;
        let drives = Simulator::new(&robot, &Effects::default())?.drives().to_vec();
        let mut with_tool = lwr.robot.clone();
        with_tool.tool = Some(tool.clone());
        let arm = Interpreted::new(&robot, &Interpreted::BODIES);
        let motion = {
            let kinematics = Kinematics::new(&robot, arm.model());
            let mut model =
                RobotModel::new(&robot, Box::new(arm.bodies(&standard)), kinematics.as_ref(), drives.clone());
            in_the_air(&mut model, &in_contact(plan).map_err(SimulateError::from)?, ROOM)?
        };
        all.push(Rig {
            arm,
            motion,
            settle,
            plan: plan.clone(),
            real: Simulator::new(&with_tool, effects)?,
            robot,
            standard,
            drives,
            spread: spread.to_vec(),
            turning: turning.to_vec(),
        });
    }
    Ok(all)
}
