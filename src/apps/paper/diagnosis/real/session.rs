//! An arm with its excerpts: identified once, diagnosed for every addition.

use dh_codegen::arm::param;
use dh_codegen::robot::{Robot, no_files};

use super::super::case::record_keeping;
use super::addition::Addition;
use super::identified::identified;
use super::{Recorded, Untouched, motion};
use crate::apps::paper::ReproduceError;
use crate::data::log::{Acceptance, Log, Quantity, Role, csv, open};
use crate::data::signal::PrepareError;
use crate::diagnose::{self, DiagnoseError, Diagnosis, Recording};
use crate::model::rigid_body::Numeric;
use crate::model::{Arm, States, perturbable_robot::PerturbableRobot};

/// An excerpt of a log.
pub(super) struct Excerpt {
    pub(super) log: Log,
    pub(super) states: States,
    /// Torque of the identified bodies without their drives, per joint, N m.
    pub(super) load: Vec<Vec<f64>>,
}

/// An arm under test.
pub(super) struct Session {
    pub(super) name: String,
    /// Robot with the identified parameters.
    pub(super) robot: Robot,
    pub(super) plant: PerturbableRobot,
    pub(super) numeric: Numeric,
    pub(super) fit: Vec<Excerpt>,
    pub(super) validate: Vec<Excerpt>,
    /// Root mean square of the identified model's residual, per joint, N m.
    pub(super) residual: Vec<f64>,
}

impl Excerpt {
    /// Times, s.
    pub(super) fn time(&self) -> &[f64] {
        &self.log.columns[0]
    }

    /// Measured torque of a joint, N m.
    pub(super) fn torque(&self, j: usize) -> &[f64] {
        self.log.joint(Quantity::Tau, j).unwrap_or(&[])
    }

    /// Part of one joint in a joint-major series of the states.
    pub(super) fn of<'a>(&self, series: &'a [f64], j: usize) -> &'a [f64] {
        &series[j * self.states.len..(j + 1) * self.states.len]
    }
}

/// Reads a log: converts currents to torques and shifts delayed torques back by whole samples.
fn read(name: &str, bytes: &[u8], recorded: &Recorded) -> Result<Log, ReproduceError> {
    let gains = recorded.arm.gains;
    let quantity = if gains.is_empty() { Quantity::Tau } else { Quantity::Current };
    let mut source = open(name, bytes).map_err(PrepareError::from)?;
    let mut log = Log::read(source.as_mut(), quantity, Acceptance::all()).map_err(PrepareError::from)?;
    for (role, column) in log.layout.roles.iter_mut().zip(&mut log.columns) {
        if let Role::Joint(Quantity::Current, j) = *role
            && let Some(gain) = gains.get(j)
        {
            *role = Role::Joint(Quantity::Tau, j);
            column.iter_mut().for_each(|x| *x *= gain);
        }
    }
    let t = log.column(Role::Time).unwrap_or(&[]);
    let mut steps: Vec<f64> = t.windows(2).map(|w| w[1] - w[0]).filter(|d| *d > 0.0).collect();
    steps.sort_by(f64::total_cmp);
    let period = steps.get(steps.len() / 2).copied().unwrap_or(0.01);
    let by = (recorded.arm.late / period).round() as usize;
    if by > 0 {
        let rows = motion::segments(&log.starts, log.len());
        for (role, column) in log.layout.roles.iter().zip(&mut log.columns) {
            if matches!(role, Role::Joint(Quantity::Tau, _)) {
                for rows in &rows {
                    let part = &mut column[rows.clone()];
                    let by = by.min(part.len());
                    part.rotate_left(by);
                    // The last samples have no torque of their own; the filter's ends are cut off.
                    let (last, from) = (part.len() - by, part.len().saturating_sub(by + 1));
                    let value = part[from];
                    part[last..].fill(value);
                }
            }
        }
    }
    Ok(log)
}

/// Rows of a log, by number.
fn rows(log: &Log, range: std::ops::Range<usize>) -> Log {
    let starts = log.starts.iter().filter(|s| range.contains(s) && **s > range.start).map(|s| s - range.start);
    Log {
        layout: log.layout.clone(),
        columns: log.columns.iter().map(|c| c[range.clone()].to_vec()).collect(),
        starts: starts.collect(),
        findings: Vec::new(),
    }
}

/// Duration of motion in a log without gaps between its segments, s.
fn seconds(log: &Log) -> f64 {
    let t = &log.columns[0];
    motion::segments(&log.starts, log.len()).into_iter().map(|r| t[r.end - 1] - t[r.start]).sum()
}

/// Takes the first part of each log, so that the total is at most `most` s.
fn shortened(logs: Vec<Log>, most: f64) -> Vec<Log> {
    let all: f64 = logs.iter().map(seconds).sum();
    let share = (most / all.max(1e-9)).min(1.0);
    logs.into_iter().map(|log| rows(&log, 0..(share * log.len() as f64).ceil() as usize)).collect()
}

impl Session {
    pub(super) fn new(recorded: &Recorded, most: [f64; 2]) -> Result<Self, ReproduceError> {
        let name = recorded.arm.folder.to_string();
        let file = Robot::from_yaml(recorded.arm.robot, &no_files);
        let file = file.map_err(ReproduceError::in_file(&name))?.robot;
        let all = |names: &[&str], bytes: &[Vec<u8>]| -> Result<Vec<Log>, ReproduceError> {
            names.iter().zip(bytes).map(|(name, bytes)| read(name, bytes, recorded)).collect()
        };
        let fit = all(recorded.arm.fit, &recorded.fit)?;
        let (fit, validate) = if recorded.validate.is_empty() {
            let cut = |log: &Log| (log.len() * 2 / 3, log.len());
            let first = fit.iter().map(|l| rows(l, 0..cut(l).0)).collect();
            (first, fit.iter().map(|l| rows(l, cut(l).0..cut(l).1)).collect())
        } else {
            (fit, all(recorded.arm.validate, &recorded.validate)?)
        };
        let (fit, validate) = (shortened(fit, most[0]), shortened(validate, most[1]));
        let recordings = fit.iter().map(|l| recording("fit", l, file.dof())).collect::<Result<Vec<_>, _>>()?;
        let robot = identified(&file, &fit)?;
        let (plant, numeric) = (PerturbableRobot::new(&robot), Numeric::new(&robot));
        let [residual, _] = diagnose::misses(&plant, &recordings, &diagnose::Settings::default());
        let standard = bodies(&robot);
        let excerpt = |log: Log| excerpt(log, &numeric, &standard);
        let (fit, validate) = (fit.into_iter().map(excerpt).collect(), validate.into_iter().map(excerpt).collect());
        Ok(Self { name, robot, plant, numeric, fit, validate, residual })
    }

    /// Diagnoses the logs, with an addition or unchanged.
    pub(super) fn diagnose(&self, added: Option<(&Addition, f64)>) -> Result<Diagnosis, ReproduceError> {
        let logs = |excerpts: &[Excerpt], fitted: bool| -> Result<Vec<Recording>, ReproduceError> {
            let log = |(number, e): (usize, &Excerpt)| {
                let changed = added.map(|(addition, x)| addition.to(self, e, x, fitted && number == 0));
                recording(if fitted { "fit" } else { "validate" }, changed.as_ref().unwrap_or(&e.log), self.plant.dof())
            };
            excerpts.iter().enumerate().map(log).collect()
        };
        let (fit, validate) = (logs(&self.fit, true)?, logs(&self.validate, false)?);
        Ok(diagnose::diagnose(&self.plant, &fit, &validate, &diagnose::Settings::default(), &|_| {})?)
    }

    /// Diagnoses the unchanged logs, whole and in halves.
    pub(super) fn untouched(&self) -> Result<Untouched, ReproduceError> {
        let half = |which: usize| -> Result<Option<Diagnosis>, ReproduceError> {
            let part = |e: &Excerpt| {
                let middle = e.log.len() / 2;
                let range = if which == 0 { 0..middle } else { middle..e.log.len() };
                recording("half", &rows(&e.log, range), self.plant.dof())
            };
            // Half of a short log may have no usable rows.
            let long = |r: &Result<Recording, ReproduceError>| {
                !matches!(r, Err(ReproduceError::Prepare(PrepareError::NothingLeft { .. })))
            };
            let logs = self.fit.iter().chain(&self.validate).map(part).filter(long);
            let logs: Vec<Recording> = logs.collect::<Result<_, _>>()?;
            match diagnose::diagnose(&self.plant, &logs, &[], &diagnose::Settings::default(), &|_| {}) {
                Ok(found) => Ok(Some(found)),
                Err(DiagnoseError::TooShort { .. }) => Ok(None),
                Err(error) => Err(error.into()),
            }
        };
        let halves = [half(0)?, half(1)?];
        let whole = self.diagnose(None)?;
        Ok(Untouched { arm: self.name.clone(), residual: self.residual.clone(), whole, halves })
    }
}

/// Reads a log as the command does.
fn recording(name: &str, log: &Log, dof: usize) -> Result<Recording, ReproduceError> {
    let mut bytes = Vec::new();
    csv::write(log, &mut bytes).map_err(ReproduceError::Write)?;
    record_keeping(name, &bytes, dof, Acceptance::all())
}

/// Standard parameters of a robot's bodies; those of drives are zero.
pub(super) fn bodies(robot: &Robot) -> Vec<f64> {
    let values = param::standard_values(robot).unwrap_or_else(|| vec![0.0; param::standard(robot).len()]);
    let drive = |p: &param::Parameter| matches!(p, param::Parameter::Drive(..));
    param::standard(robot).iter().zip(values).map(|(p, v)| if drive(p) { 0.0 } else { v }).collect()
}

/// Torques of bodies along states, per joint, N m.
pub(super) fn torques(numeric: &Numeric, states: &States, standard: &[f64]) -> Vec<Vec<f64>> {
    let dof = numeric.dof();
    let (mut work, mut tau) = (numeric.workspace(), vec![0.0; dof]);
    let mut rows = vec![vec![0.0; states.len]; dof];
    let at = |series: &[f64], k: usize| -> Vec<f64> { (0..dof).map(|j| series[j * states.len + k]).collect() };
    for k in 0..states.len {
        let (q, dq, ddq) = (at(&states.q, k), at(&states.dq, k), at(&states.ddq, k));
        numeric.inverse_dynamics_into(&mut work, &q, &dq, &ddq, standard, &mut tau);
        rows.iter_mut().zip(&tau).for_each(|(row, tau)| row[k] = *tau);
    }
    rows
}

fn excerpt(log: Log, numeric: &Numeric, standard: &[f64]) -> Excerpt {
    let q: Vec<Vec<f64>> = (0..numeric.dof()).map(|j| log.joint(Quantity::Q, j).unwrap_or(&[]).to_vec()).collect();
    let states = motion::states(&log.columns[0], &q, &log.starts);
    let load = torques(numeric, &states, standard);
    Excerpt { log, states, load }
}
