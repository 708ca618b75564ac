//! `denavit log`: shows the content of a recording, and converts it to the columns of the other
//! verbs.

use std::path::PathBuf;

use clap::{Args, Subcommand};

use super::Failure;
use super::delivery::deliver;
use super::files;
use super::mapping::MapOption;
use super::output::Output;
use super::prepare::table;
use super::provenance::Provenance;
use super::reading::Keep;
use super::terminal;
use crate::data::log::csv::CsvWriter;
use crate::data::log::parquet::ParquetWriter;
use crate::data::log::{self, Acceptance, LogError, Passed, Quantity, Source, each_block, propose, source};
use crate::identify::recording::source_joints;
use crate::report;

/// Look into recordings, and convert them.
#[derive(Args)]
pub(super) struct LogVerb {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
    /// List the channels of a recording with rates, ranges and gaps, and propose a mapping.
    Inspect(Inspect),
    /// Write a recording as CSV or Parquet with the columns t, q1.., tau1.., in SI units.
    Convert(Convert),
}

/// List the channels of a recording with rates, ranges and gaps, and propose a mapping of channels
/// to columns. The proposal is a guess from names and ranges: check it, then give it to `--map`.
#[derive(Args)]
#[command(
    after_help = concat!(
        "Example:\n  denavit log inspect run.mcap --robot robot.yaml --out map.yaml\n  denavit identify robot.yaml run.mcap --map map.yaml\n\nReads CSV (any separator, decimal comma, comments, units in the header), CSV gzipped, Parquet (also lists), MCAP of ROS 2, npz, MATLAB 5 to 7.",
        log_columns!()
    )
)]
struct Inspect {
    /// Recording; `-` for standard input.
    log: PathBuf,
    /// Robot file: the names of its joints are looked for.
    #[arg(long, value_name = "ROBOT")]
    robot: Option<PathBuf>,
    /// Write the proposed mapping.
    #[arg(long, value_name = "YAML")]
    out: Option<PathBuf>,
    /// Write channels and mapping as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Write a recording as CSV or Parquet with the columns t, q1.., tau1.. in SI units, as every verb
/// reads them.
#[derive(Args)]
#[command(
    after_help = concat!(
        "Example:\n  denavit log convert run.mcap --robot robot.yaml --out run.parquet\n  denavit log convert export.csv --map map.yaml --out run.csv",
        log_columns!()
    )
)]
struct Convert {
    /// Recording; `-` for standard input.
    log: PathBuf,
    /// Robot file: joints are found by its names.
    #[arg(long, value_name = "ROBOT")]
    robot: Option<PathBuf>,
    #[command(flatten)]
    map: MapOption,
    /// CSV, or Parquet where the name ends in .parquet.
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    #[command(flatten)]
    keep: Keep,
}

impl LogVerb {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        match self.verb {
            Verb::Inspect(verb) => verb.run(provenance),
            Verb::Convert(verb) => verb.run(provenance),
        }
    }
}

impl Inspect {
    fn run(self, provenance: Provenance) -> Result<(), Failure> {
        let robot = self.robot.as_deref().map(files::robot).transpose()?;
        files::check_outputs(&[("--json", &self.json), ("--out", &self.out)], std::slice::from_ref(&self.log))?;
        let (name, mut table) = table(&self.log, &log::Reading::default())?;
        let channels = table.summarise().map_err(Failure::input)?;
        if channels.iter().all(|channel| channel.samples == 0) {
            return Err(Failure::input(format!(
                "{name} holds no numbers; it is no log of a kind that is read here, or has no rows (docs/logs.md)"
            )));
        }
        let joints = robot.as_ref().map(|r| source_joints(&r.robot)).unwrap_or_default();
        let proposal = propose(&channels, &joints);
        deliver(&provenance)
            .file(self.out.as_ref(), || report::mapping_yaml(&proposal, &name))?
            .json(self.json.as_ref(), || report::inspect_json(&channels, &proposal))?
            .only_text(|| report::inspect_text(&name, &channels, &proposal))
    }
}

impl Convert {
    fn run(self, provenance: Provenance) -> Result<(), Failure> {
        let robot = self.robot.as_deref().map(files::robot).transpose()?;
        let out = Some(self.out.clone());
        files::check_outputs(&[("--out", &out)], std::slice::from_ref(&self.log))?;
        let reading = self.map.reading(robot.as_ref().map(|r| &r.robot))?;
        let (name, table) = table(&self.log, &reading)?;
        let mut source = source(&name, table, &reading).map_err(Failure::input)?;
        let joints = source.layout().dof;
        if let Some(robot) = robot.as_ref().map(|r| &r.robot).filter(|r| r.dof() != joints) {
            let (of, name_of) = (robot.dof(), &robot.name);
            terminal::say(&format!(
                "{name}: note: it has {joints} joints, {name_of} has {of}; all of the log's are written"
            ));
        }
        let has = |quantity| source.layout().has(quantity);
        let torque = [Quantity::Tau, Quantity::Taum].into_iter().find(|q| has(*q)).unwrap_or(Quantity::Current);
        let parquet = self.out.extension().is_some_and(|e| e.eq_ignore_ascii_case("parquet"));
        let mut output = Output::create(&self.out)?;
        let passed = match write_rows(&mut *source, torque, self.keep.acceptance()?, parquet, &mut output) {
            Ok(passed) => passed,
            Err(Stop::Log(error)) => return Err(Failure::input(error)),
            Err(Stop::Parquet(error)) => return Err(Failure::other(error)),
            Err(Stop::Io(error)) => return Err(output.failed(&error)),
        };
        output.finish()?;
        for finding in &passed.findings {
            terminal::say(&format!("{name}: warning: {finding}"));
        }
        let mut out = deliver(&provenance);
        out.wrote(&self.out);
        out.only_text(|| report::converted_text(&name, &passed, &self.out.display().to_string()))
    }
}

/// Reason why copying of rows stopped.
enum Stop {
    /// Reading failed.
    Log(LogError),
    /// Writing Parquet failed.
    Parquet(LogError),
    /// Writing failed.
    Io(std::io::Error),
}

impl From<LogError> for Stop {
    fn from(error: LogError) -> Self {
        Self::Log(error)
    }
}

/// Copies every row of a recording while it is read.
fn write_rows(
    source: &mut dyn Source,
    torque: Quantity,
    keep: Acceptance,
    parquet: bool,
    out: &mut Output,
) -> Result<Passed, Stop> {
    let layout = source.layout().clone();
    if parquet {
        let mut writer = ParquetWriter::new(&layout, out).map_err(Stop::Parquet)?;
        let passed = each_block(source, torque, keep, |rows, _| writer.rows(rows).map_err(Stop::Parquet))?;
        writer.finish().map_err(Stop::Parquet)?;
        return Ok(passed);
    }
    let mut writer = CsvWriter::new(&layout, out).map_err(Stop::Io)?;
    let passed = each_block(source, torque, keep, |rows, _| writer.rows(rows).map_err(Stop::Io))?;
    writer.finish().map_err(Stop::Io)?;
    Ok(passed)
}
