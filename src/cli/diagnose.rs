//! `denavit diagnose`: finds the causes of model errors in logs.

use std::path::{Path, PathBuf};

use clap::Args;
use dh_codegen::arm::param;
use dh_codegen::robot::Robot;
use indicatif::ProgressBar;

use super::Failure;
use super::column_check::ColumnCheck;
use super::delivery::deliver;
use super::files;
use super::known_effects::FileEffects;
use super::logbook::{Logbook, Purpose};
use super::motors;
use super::prepare::{against_limits, warned};
use super::provenance::Provenance;
use super::reading::ReadOptions;
use crate::data::log::{Acceptance, Quantity};
use crate::data::signal::{Motion, Prepare, Prepared, lower_cutoff};
use crate::diagnose::{self, Cause, Diagnosis, Holding, Recording, Separation, Settings, Thinning, Use};
use crate::identify::implausible_links;
use crate::identify::recording::torque_constants;
use crate::model::drives_alone::DrivesAlone;
use crate::model::file_torque_model::FileTorqueModel;
use crate::model::perturbable_robot::PerturbableRobot;
use crate::model::{PerturbableArm, StandardParameter};
use crate::report;
use crate::report::{Identified, WrittenCheck};

/// Find what a simulation of the robot file gets wrong, name the causes, extend the model, and
/// measure the gain on logs that were not used.
///
/// Every effect of the vocabulary (see the robots' README) is tried on every joint against every
/// other, all other parameters refitted with it. An accepted cause must be confirmed by parts of
/// the data that did not fit it. Torques are used unfiltered; only positions are low-passed.
/// Without --validate the last three tenths of each stretch are kept for the measure.
#[derive(Args)]
#[command(
    after_help = concat!(
        "Example:\n  denavit diagnose robots/kuka-lwr4.yaml run1.csv --validate run2.csv \\\n      --out extended.yaml --report diagnosis.html",
        log_columns!()
    )
)]
pub(super) struct Diagnose {
    /// Robot file, with or without link parameters.
    robot: PathBuf,
    /// Logs to look for causes in.
    #[arg(required = true, value_name = "LOG")]
    logs: Vec<PathBuf>,
    /// Logs to measure the gain on; they are not used otherwise. One that holds samples of another
    /// log is refused.
    #[arg(long, num_args = 1.., value_name = "LOG")]
    validate: Vec<PathBuf>,
    /// Robot file to write: the one that was read, with the effects in it and what made them under
    /// `provenance`.
    #[arg(long, value_name = "ROBOT2")]
    out: Option<PathBuf>,
    /// Path of the next experiment: if two causes can't be separated, the motion (CSV, as `excite`
    /// writes it) on which they would differ most. Default: beside --out, with the ending
    /// `.next.csv`.
    #[arg(long, value_name = "CSV")]
    next: Option<PathBuf>,
    /// Write the result as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write a page with the evidence.
    #[arg(long, value_name = "FILE.html")]
    report: Option<PathBuf>,
    /// Cut-off frequency of the low-pass for positions, Hz. Default: for each joint the one at
    /// which the expected error of its acceleration is least, given the spectrum of its motion and
    /// the noise of its encoder, at most 15, and less where the torques follow the motion less far.
    /// Where a joint breaks away after a reversal a wider band is passed.
    #[arg(long)]
    cutoff: Option<f64>,
    /// Windows per second over which torques are averaged to separate causes. Default: 100; of more
    /// than half a minute of fitted motion fewer, down to 50, so that there are as many as in half a
    /// minute.
    #[arg(long)]
    rate: Option<f64>,
    /// Diagnose the gears alone, of logs with the torques of motors and joints: rotors, friction and
    /// ripple in `taum` less `tau`, without an error of links. `--torque current` takes currents in
    /// the place of `taum`.
    #[arg(long)]
    transmission: bool,
    #[command(flatten)]
    read: ReadOptions,
}

/// Outputs and reading options of a diagnosis within another verb.
pub(super) struct Outputs {
    pub(super) out: Option<PathBuf>,
    pub(super) json: Option<PathBuf>,
    pub(super) report: Option<PathBuf>,
    pub(super) read: ReadOptions,
}

/// A diagnosis with its outputs.
pub(super) struct Diagnosed {
    found: Diagnosis,
    written: Option<Result<Extended, Failure>>,
    /// The next motion, and its path.
    next: Option<(Separation, PathBuf)>,
    prepared: Vec<Prepared>,
    /// A sentence about the omitted part, if the logs were too long to be used whole.
    left_out: Option<String>,
    provenance: Provenance,
}

/// A robot file to write, and its remaining errors.
struct Extended {
    text: String,
    check: WrittenCheck,
    /// Reason why it differs from the proposed model, if it does.
    differs: Option<String>,
}

/// Links (from 1) with physically impossible parameters, including those that the file's effects
/// add.
fn impossible(robot: &Robot) -> Vec<usize> {
    let bare = Robot { tool: None, ..robot.effective() };
    let parameters: Vec<StandardParameter> = param::standard(&bare).into_iter().map(Into::into).collect();
    param::standard_values(&bare).map_or(Vec::new(), |values| implausible_links(&parameters, &values))
}

/// Sampling rate of the written motion, Hz.
const NEXT_RATE: f64 = 100.0;

/// Failure for a log of which even a single piece is too large.
fn too_fast(path: &Path) -> Failure {
    let path = path.display();
    Failure::input(format!(
        "{path}: a few seconds of it are more than a diagnosis holds in memory: give a log of a lower rate"
    ))
}

/// Describes which part of long logs was used.
fn thinned(thinning: &Thinning) -> String {
    let Thinning { piece, seconds: [used, all], without } = *thinning;
    let more = if without > 0 {
        format!(" Of {without} of the logs, which are short, nothing was used.")
    } else {
        String::new()
    };
    format!(
        "The logs have {all:.0} s of motion, more than a diagnosis holds in memory: pieces of {piece:.0} s were used, evenly spread, \
         {used:.0} s in all.{more}"
    )
}

/// State of reading the logs.
struct LogsRead {
    prepared: Vec<Prepared>,
    logbook: Logbook,
    provenance: Provenance,
    /// Interpretation of the columns.
    columns: crate::data::log::Reading,
    /// Samples kept in memory.
    held: Holding,
}

impl Diagnose {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        self.check_options()?;
        let file = files::robot(&self.robot)?;
        motors::on_every_joint(&self.robot, &file.robot, "a diagnosis takes the torque of every joint from the log")?;
        files::check_outputs(
            &[("--out", &self.out), ("--next", &self.next_path()), ("--json", &self.json), ("--report", &self.report)],
            file.read.iter().chain(&self.logs).chain(&self.validate),
        )?;
        let made = self.made(&file, provenance.robot(&self.robot, &file))?;
        self.deliver(&made, None)
    }

    /// A diagnosis with defaults for all options not given here.
    pub(super) fn plainly(robot: PathBuf, logs: Vec<PathBuf>, validate: Vec<PathBuf>, given: Outputs) -> Self {
        let Outputs { out, json, report, read } = given;
        Self {
            robot,
            logs,
            validate,
            out,
            next: None,
            json,
            report,
            cutoff: None,
            rate: None,
            transmission: false,
            read,
        }
    }

    /// Diagnosis of a robot file, and the robot file that results from it.
    pub(super) fn made(&self, file: &files::RobotFile, provenance: Provenance) -> Result<Diagnosed, Failure> {
        let keep = self.read.keep.acceptance()?;
        let plant: &dyn PerturbableArm = match self.transmission {
            true => &DrivesAlone::new(&file.robot),
            false => &PerturbableRobot::new(&file.robot),
        };
        let effects = FileEffects::of(&file.robot, &[]);
        let known = effects.as_ref().and_then(|effects| effects.known(plant, plant.given(), None));
        // The torque of a gear alone matches no interpretation of a torque column.
        let check = (!self.transmission).then(|| ColumnCheck::new(&file.robot, plant, plant.given(), known, keep));
        let settings = Settings { rate: self.rate, keep_band: self.cutoff.is_some(), ..Settings::default() };
        let mut reading = LogsRead {
            provenance,
            logbook: Logbook::of(&file.text),
            columns: self.read.map.reading(Some(&file.robot))?,
            prepared: Vec::new(),
            held: Holding::new(plant, settings.most_windows_per_second()),
        };
        for path in &self.logs {
            self.record(Purpose::Fit, path, &file.robot, check.as_ref(), keep, &mut reading)?;
        }
        for path in &self.validate {
            self.record(Purpose::Validate, path, &file.robot, check.as_ref(), keep, &mut reading)?;
        }
        let LogsRead { prepared, logbook, provenance, held, .. } = reading;
        let ([fit, validate], thinning) = held.recordings();
        let left_out = thinning.as_ref().map(thinned);
        let provenance = provenance.logs(&logbook);
        // The fingerprints of the logs take 34 MB, and memory is short.
        drop(logbook);
        let bar = ProgressBar::new_spinner();
        bar.enable_steady_tick(std::time::Duration::from_millis(120));
        let found = diagnose::diagnose(plant, &fit, &validate, &settings, &|what| bar.set_message(what.to_string()))
            .map_err(Failure::input)?;
        let next = self.next_path().and_then(|path| {
            let next = diagnose::discriminating_motion(&file.robot, &found, &|what| bar.set_message(what.to_string()))?;
            Some((next, path))
        });
        bar.finish_and_clear();
        let measured = if self.validate.is_empty() { &fit } else { &validate };
        let written = self.out.as_ref().map(|path| self.extended_file(path, &found, file, measured, &provenance));
        Ok(Diagnosed { found, written, next, prepared, left_out, provenance })
    }

    /// Torque column to read.
    fn torque(&self) -> Quantity {
        match (self.read.torque.quantity(), self.transmission) {
            (Quantity::Tau, true) => Quantity::Taum,
            (torque, _) => torque,
        }
    }

    fn check_options(&self) -> Result<(), Failure> {
        if let Some(cutoff) = self.cutoff.filter(|cutoff| !(*cutoff > 0.0 && cutoff.is_finite())) {
            return Err(Failure::input(format!("--cutoff {cutoff}: a frequency in Hz above 0")));
        }
        if let Some(rate) = self.rate.filter(|rate| !(*rate >= 10.0 && *rate <= 1e5)) {
            return Err(Failure::input(format!("--rate {rate}: windows per second, from 10 to 100000")));
        }
        Ok(())
    }

    /// The robot file with the causes found, read back and evaluated with its own inverse dynamics.
    fn extended_file(
        &self,
        path: &Path,
        found: &Diagnosis,
        file: &files::RobotFile,
        measured: &[Recording],
        provenance: &Provenance,
    ) -> Result<Extended, Failure> {
        let refused = |why: String| Failure::other(format!("{} is not written: {why}", path.display()));
        let (shown, before) = (path.display().to_string(), impossible(&file.robot));
        let robot = diagnose::extended(file.robot.clone(), found);
        let sentence = |c: &Cause| format!("{} (probability {:.2}): {}", c.cause, c.probability, c.evidence);
        let causes: Vec<String> = found
            .causes
            .iter()
            .filter(|c| c.has_law() || c.in_extended && c.cause != "unknown")
            .map(sentence)
            .collect();
        let text = file.rewritten(&robot, path, &provenance.run(causes.clone()));
        let beside = |name: &str| {
            files::text(&path.with_file_name(name)).map_err(|_| std::io::Error::other(format!("{name} can't be read")))
        };
        let back = Robot::from_yaml(&text, &beside)
            .map_err(|problems| refused(format!("it could not be read back: {problems}")))?
            .robot;
        if let Some(link) = impossible(&back).into_iter().find(|l| !before.contains(l)) {
            return Err(refused(format!(
                "with what was found link {link} would be no possible body; give longer logs with more motion of it, or a file with links"
            )));
        }
        let whole = if self.transmission { None } else { FileTorqueModel::new(&back).ok() };
        let model = whole.map(|model| model.among_walls(&back));
        let rms = model.map(|model| diagnose::written_errors(&model, measured, found));
        let offered = found.extended.validate.clone();
        let check =
            WrittenCheck { rms, transmission: self.transmission, offered, own_validation: found.own_validation };
        let differs = check.refusal(&shown);
        let text = match &differs {
            Some(words) => file.rewritten(&robot, path, &provenance.run([vec![words.clone()], causes].concat())),
            None => text,
        };
        Ok(Extended { text, check, differs })
    }

    fn next_path(&self) -> Option<PathBuf> {
        self.next.clone().or_else(|| self.out.as_ref().map(|out| out.with_extension("next.csv")))
    }

    /// Writes files and text. `identified` is the identification from which the robot file was
    /// made, if it is part of this run.
    pub(super) fn deliver(&self, made: &Diagnosed, identified: Option<&Identified<'_>>) -> Result<(), Failure> {
        let Diagnosed { found, written, next, prepared, left_out, provenance } = made;
        let mut warnings = report::diagnose_warnings(found, prepared);
        left_out.iter().for_each(|sentence| warnings.push(sentence));
        let failed = match written {
            Some(Err(failure)) => Some(&failure.message),
            Some(Ok(file)) => file.differs.as_ref(),
            None => None,
        };
        if let Some(words) = failed {
            warnings.push_shown(words);
        }
        if let (Some(path), None) = (&self.next, next) {
            warnings.push(format!(
                "{} is not written: no two causes are left that a motion would separate.",
                path.display()
            ));
        }
        let extended = written.as_ref().and_then(|file| file.as_ref().ok());
        let next_shown = next.as_ref().map(|(next, path)| (next, path.display().to_string()));
        let json = || {
            let mut value = report::diagnose_json(found, prepared, &warnings, &provenance.rows());
            if let Some((next, path)) = &next_shown {
                value["next_experiment"] = report::next_experiment_json(next, path);
            }
            if let Some(file) = extended {
                value["written"] = report::written_json(&file.check);
            }
            if let Some(identified) = identified {
                value["identified"] = report::identify_json(identified.found, &[], identified.warnings, &[]);
            }
            value
        };
        let verdict = || match identified {
            Some(identified) => report::calibrate_text(found, identified, &warnings),
            None => report::diagnose_text(found, &warnings),
        };
        let text = || self.text(verdict(), next_shown.as_ref(), extended);
        let mut out = deliver(provenance);
        if let Some(file) = extended {
            out = out.file(self.out.as_ref(), || &file.text)?;
        }
        if let Some((next, path)) = next {
            out = out.file(Some(path), || report::motion_csv(&next.motion, NEXT_RATE))?;
        }
        let page = || report::diagnose_html(found, prepared, &warnings, identified, &provenance.rows());
        out.file(self.report.as_ref(), page)?.json(self.json.as_ref(), json)?.only_text(text)?;
        match written {
            Some(Err(failure)) => Err(failure.clone()),
            Some(Ok(Extended { differs: Some(words), .. })) => Err(Failure::other(words)),
            _ => Ok(()),
        }
    }

    /// Text of the verdict, the next experiment, and the files written.
    fn text(&self, verdict: String, next: Option<&(&Separation, String)>, extended: Option<&Extended>) -> String {
        let mut text = verdict;
        if let Some((next, path)) = next {
            text += &report::next_experiment_text(next, path);
        }
        if let (Some(path), Some(file @ Extended { differs: None, .. })) = (&self.out, extended) {
            text += &report::written_text(&file.check, &path.display().to_string());
        }
        if let Some(path) = &self.report {
            text += &format!("wrote {}\n", path.display());
        }
        text
    }

    /// Reads a log completely. If the cutoff depends on the log, slow logs use as high a cutoff as
    /// they allow.
    fn record(
        &self,
        purpose: Purpose,
        path: &Path,
        robot: &Robot,
        check: Option<&ColumnCheck<'_>>,
        keep: Acceptance,
        reading: &mut LogsRead,
    ) -> Result<(), Failure> {
        let by_the_log = self.cutoff.is_none();
        let constants = torque_constants(robot);
        let LogsRead { columns: map, logbook, held, .. } = reading;
        let of = if purpose == Purpose::Validate { Use::Validate } else { Use::Fit };
        let mut pass = |cutoff: f64| {
            let prepare = Prepare {
                torque: self.torque(),
                transmission: self.transmission,
                torque_constants: constants.clone(),
                reading: map.clone(),
                keep,
                ..if by_the_log { diagnose::preparation(cutoff) } else { diagnose::fixed_preparation(cutoff) }
            };
            let mut coming = held.begin(of, &path.display().to_string());
            let mut columns = check.map(ColumnCheck::columns);
            let sink = |motion: &Motion| {
                if let (Some(check), Some(columns)) = (check, &mut columns) {
                    check.absorb(columns, motion);
                }
                held.absorb(&mut coming, motion);
            };
            match logbook.try_pass(purpose, path, constants.len(), &prepare, sink) {
                Ok(prepared) => prepared.map(|found| Ok((found, coming, columns))),
                Err(failure) => Ok(Err(failure)),
            }
        };
        let (found, cutoff) = match self.cutoff {
            Some(cutoff) => (pass(cutoff).map_err(Failure::input)?, cutoff),
            None => lower_cutoff(diagnose::HIGHEST, pass).map_err(Failure::input)?,
        };
        let (found, coming, columns) = found?;
        if !reading.held.end(coming) {
            return Err(too_fast(path));
        }
        let mut found = warned(path, found);
        against_limits(std::slice::from_mut(&mut found), robot, keep)?;
        if let (Some(check), Some(columns)) = (check, &columns) {
            check.finish(columns, &mut found)?;
        }
        reading.prepared.push(found);
        if by_the_log && cutoff < diagnose::HIGHEST {
            let what = format!("cut-off for {}, which is sampled slowly", path.display());
            reading.provenance = std::mem::take(&mut reading.provenance).with(&what, format!("{cutoff} Hz"));
        }
        Ok(())
    }
}
