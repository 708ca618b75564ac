//! `denavit factor`: one row per recording, with the factor from which it can be identified again.

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use super::Failure;
use super::delivery::deliver;
use super::files;
use super::identify::{Identify, Setup};
use super::known_effects::without;
use super::output::Output;
use super::prepare::{Preparation, Recognised, against_limits, recognised_pass};
use super::provenance::{Provenance, hexadecimal};
use super::terminal;
use crate::data::signal::Motion;
use crate::identify::{AccumulatorSettings, QrAccumulator, RecordingFactor};
use crate::model::Arm;
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

/// Sums over the rows, and what is kept of them.
#[derive(Default)]
struct Totals {
    recordings: usize,
    without: usize,
    seconds: f64,
    /// For `--json`.
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
        // As `identify` reads them.
        let identify = Identify::plainly(
            self.robot.clone(),
            self.logs.clone(),
            Vec::new(),
            self.out.clone(),
            self.preparation.clone(),
        );
        self.preparation.check_options(None)?;
        identify.with_setup(&file, |setup| {
            let provenance =
                provenance.robot(&self.robot, &file).with("low-pass", Preparation::low_pass(&setup.prepare));
            let totals = self.write(setup, digest, &provenance)?;
            self.deliver(&totals, &provenance)
        })
    }

    /// Writes one row per recording, before the next is read.
    fn write(&self, setup: &Setup<'_>, robot: [u8; 32], provenance: &Provenance) -> Result<Totals, Failure> {
        let mut totals = Totals::default();
        let mut output = Output::create(&self.out)?;
        let mut table = FactorTable::new(&mut output, &provenance.rows()).map_err(Failure::other)?;
        for path in &self.logs {
            let row = recording(path, setup, robot);
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

/// The row of a recording, with a factor or the reason why there is none.
fn recording(path: &Path, setup: &Setup<'_>, robot: [u8; 32]) -> FactorRow {
    let none = FactorRow {
        robot: setup.robot.name.clone(),
        file: path.display().to_string(),
        verdict: "refused",
        ..FactorRow::default()
    };
    factored(path, setup, robot, &none).unwrap_or_else(|failure| FactorRow {
        sha256: digest_of(path),
        why: Some(failure.message),
        ..none
    })
}

fn factored(path: &Path, setup: &Setup<'_>, robot: [u8; 32], none: &FactorRow) -> Result<FactorRow, Failure> {
    let mut prepare = setup.prepare.clone();
    prepare.temperature = true;
    let mut stack = QrAccumulator::new(&none.file, setup.arm, AccumulatorSettings::default());
    let (mut start, mut heat, mut warm) = (None, 0.0, 0_usize);
    let sink = |motion: &Motion| {
        start.get_or_insert(motion.start);
        for column in motion.temperature.chunks_exact(motion.states.len.max(1)) {
            for value in motion.picks().map(|s| column[s]).filter(|value| value.is_finite()) {
                (heat, warm) = (heat + value, warm + 1);
            }
        }
        stack.absorb(&without(setup.known, motion));
    };
    let Recognised { prepared, sha256, .. } = recognised_pass(path, setup.arm.dof(), &prepare, sink)?;
    let mut prepared = [prepared.map_err(Failure::input)?];
    against_limits(&mut prepared, setup.robot, prepare.keep)?;
    let [prepared] = prepared;
    let factors = stack.finish();
    Ok(FactorRow {
        day: start.and_then(day),
        sha256: Some(sha256),
        samples: prepared.samples,
        seconds: factors.seconds,
        verdict: FactorRow::verdict_of(&prepared.findings),
        temperature: (warm > 0).then(|| heat / warm as f64),
        factor: Some(RecordingFactor { robot, factors }.to_bytes()),
        ..none.clone()
    })
}

/// Days since 1970 of a time since 1970, s; `None` of one that counts from elsewhere: it would be
/// before 2000 or after 2100.
fn day(time: f64) -> Option<i32> {
    const DAY: f64 = 86_400.0;
    let days = (time / DAY).floor();
    (10_957.0..47_482.0).contains(&days).then_some(days as i32)
}

/// SHA-256 of a plain file.
fn digest_of(path: &Path) -> Option<String> {
    let mut digest = Sha256::new();
    let mut file = files::open(path).ok().filter(|_| path.is_file())?;
    std::io::copy(&mut file, &mut digest).ok()?;
    Some(hexadecimal(&digest.finalize()))
}
