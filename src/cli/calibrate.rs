//! `denavit calibrate`: identification, then diagnosis of its residual.

use std::path::PathBuf;

use clap::Args;

use super::Failure;
use super::diagnose::{Diagnose, Outputs};
use super::files::{self, RobotFile};
use super::identify::Identify;
use super::prepare::Preparation;
use super::provenance::Provenance;
use super::reading::ReadOptions;
use crate::report::Identified;

/// Identify the robot, diagnose what the identified model gets wrong, and measure both on logs that
/// nothing was fitted to.
///
/// This is `identify` and then `diagnose` on the robot file that it makes, with the defaults of
/// both. Give logs of rich motion to fit, and at least one separate recording to measure on.
#[derive(Args)]
#[command(
    after_help = concat!(
        "Example:\n  denavit calibrate robots/staubli-tx40.yaml run1.csv run2.csv --validate run3.csv \\\n      --out calibrated.yaml --report calibrated.html",
        log_columns!()
    )
)]
pub(super) struct Calibrate {
    /// Robot file, with or without link parameters.
    robot: PathBuf,
    /// Logs to fit.
    #[arg(required = true, value_name = "LOG")]
    logs: Vec<PathBuf>,
    /// Logs to measure on; they are not used otherwise. One that holds samples of another log is
    /// refused.
    #[arg(long, required = true, num_args = 1.., value_name = "LOG")]
    validate: Vec<PathBuf>,
    /// Robot file to write: the one that was read, with identified values, the effects that were
    /// found, and what made them under `provenance`. Where two causes can't be told apart, the
    /// motion on which they would differ most stands beside it, with the ending `.next.csv`.
    #[arg(long, value_name = "ROBOT2")]
    out: Option<PathBuf>,
    /// Write the result as JSON; `-` for standard output. It is that of `diagnose`, with that of
    /// `identify` under `identified`.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write a page with torques before and after, causes and parameters.
    #[arg(long, value_name = "FILE.html")]
    report: Option<PathBuf>,
    #[command(flatten)]
    read: ReadOptions,
}

impl Calibrate {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        let Self { robot, logs, validate, out, json, report, read } = self;
        let file = files::robot(&robot)?;
        let next = out.as_ref().map(|out| out.with_extension("next.csv"));
        files::check_outputs(
            &[("--out", &out), ("--out", &next), ("--json", &json), ("--report", &report)],
            file.read.iter().chain(&logs).chain(&validate),
        )?;
        let preparation = Preparation::plainly(read.clone());
        let identify = Identify::plainly(robot.clone(), logs.clone(), validate.clone(), robot.clone(), preparation);
        let model = identify.model(&file)?;
        let provenance = provenance.robot(&robot, &file).with("low-pass of the identification", &model.low_pass);
        let run = provenance.clone().logs(&model.logbook).run(vec!["parameters, before the diagnosis".into()]);
        let text = file.rewritten(&model.robot, &robot, &run);
        let identified = RobotFile { robot: model.robot, text, read: file.read, notes: file.notes };
        let diagnose = Diagnose::plainly(robot, logs, validate, Outputs { out, json, report, read });
        let made = diagnose.made(&identified, provenance)?;
        diagnose.deliver(&made, Some(&Identified { found: &model.found, warnings: &model.warnings }))
    }
}
