//! `denavit factor`: writes one row per recording, with the factor from which it can be identified
//! again.

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};
use sha2::{Digest as _, Sha256};

use super::Failure;
use super::delivery::deliver;
use super::files;
use super::motors;
use super::output::Output;
use super::prepare::{Preparation, hashed_pass, keep_pages};
use super::provenance::Provenance;
use super::terminal;
use crate::data::log::{Digest, Source};
use crate::identify::RecordingReader;
use crate::report::{self, FactorRow, FactorTable};

/// Write the factors of recordings, one row each, from which a fleet's models are found without
/// reading the recordings again.
///
/// A row has the robot's name, the day, the file and its SHA-256, samples and seconds of motion,
/// the verdict of the quality check, the mean temperature, and the factor: triangles of which the
/// equations of any set of recordings can be merged. A recording that can't be used has the reason
/// in place of the factor.
#[derive(Args)]
#[command(
    after_help = concat!(
        "Example:\n  denavit factor monday/*.csv.gz --robot robots/kuka-iiwa14.yaml --out monday.parquet",
        log_columns!()
    )
)]
pub(super) struct Factor {
    /// Recordings.
    #[arg(required = true, value_name = "LOG")]
    logs: Vec<PathBuf>,
    /// Robot file.
    #[arg(long, value_name = "ROBOT")]
    robot: PathBuf,
    /// Table to write.
    #[arg(long, value_name = "FILE.parquet")]
    out: PathBuf,
    /// Write the rows without their factors as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    #[command(flatten)]
    preparation: Preparation,
}

/// Totals over the rows, and their JSON.
#[derive(Default)]
struct Totals {
    recordings: usize,
    without: usize,
    seconds: f64,
    /// Rows for `--json`.
    rows: Vec<Value>,
}

impl Factor {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        let file = files::robot(&self.robot)?;
        files::check_outputs(
            &[("--out", &Some(self.out.clone())), ("--json", &self.json)],
            file.read.iter().chain(&self.logs),
        )?;
        let digest: [u8; 32] = Sha256::digest(file.text.as_bytes()).into();
        self.preparation.check_options(None)?;
        motors::on_every_joint(&self.robot, &file.robot, "a factor takes the torque of every joint from the log")?;
        // Prepared as in `identify`.
        let prepare = self.preparation.prepare(&file.robot)?;
        let provenance = provenance.robot(&self.robot, &file).with("low-pass", Preparation::low_pass(&prepare));
        let totals = RecordingReader::with(&file.robot, digest, prepare, |reader| {
            self.write(reader, &file.robot.name, &provenance)
        })?;
        self.deliver(&totals, &provenance)
    }

    /// Writes the row of each recording before the next one is read.
    fn write(&self, reader: &RecordingReader<'_>, robot: &str, provenance: &Provenance) -> Result<Totals, Failure> {
        let mut totals = Totals::default();
        let mut output = Output::create(&self.out)?;
        let mut table = FactorTable::new(&mut output, &provenance.rows()).map_err(Failure::other)?;
        for path in &self.logs {
            let row = recording(path, robot, reader);
            if let Some(why) = &row.why {
                terminal::say(&format!("{}: no factor: {why}", row.file));
            }
            totals.recordings += 1;
            totals.without += usize::from(row.factor.is_none());
            totals.seconds += row.seconds;
            self.json.iter().for_each(|_| totals.rows.push(report::factor_json(&row)));
            if !files::is_stdout(self.json.iter().chain([&self.out])) && row.factor.is_some() {
                files::print(&report::factor_text(&row))?;
            }
            table.row(row).map_err(Failure::other)?;
        }
        table.finish().map_err(Failure::other)?;
        output.finish()?;
        Ok(totals)
    }

    fn deliver(&self, totals: &Totals, provenance: &Provenance) -> Result<(), Failure> {
        let Totals { recordings, without, seconds, .. } = *totals;
        let mut out = deliver(provenance);
        out.wrote(&self.out);
        out.json(self.json.as_ref(), || json!({ "recordings": totals.rows, "without_factor": without }))?
            .text(|| report::factor_verdict(recordings, without, seconds))?;
        match without == recordings {
            true => Err(Failure::input("no recording has a factor; the reasons are above and in the table")),
            false => Ok(()),
        }
    }
}

/// Row of a recording, with a factor or the reason why there is none.
fn recording(path: &Path, name: &str, reader: &RecordingReader<'_>) -> FactorRow {
    let file = path.display().to_string();
    let read = |source: &mut dyn Source| reader.factor(&file, source).map_err(Failure::input);
    keep_pages();
    let passed = hashed_pass(path, &reader.preparation().reading, read);
    match passed.and_then(|(found, sha256)| Ok((found?, sha256))) {
        Ok((found, sha256)) => FactorRow::of(name, &file, sha256, found),
        Err(failure) => FactorRow::without(name, &file, digest_of(path), failure.message),
    }
}

/// SHA-256 of a plain file.
fn digest_of(path: &Path) -> Option<String> {
    let digest = Digest::default();
    digest.take_in(files::open(path).ok().filter(|_| path.is_file())?).ok()?;
    Some(digest.hexadecimal())
}
