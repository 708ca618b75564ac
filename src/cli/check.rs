//! `denavit check`: reads and validates a robot file, and describes its content.

use std::path::PathBuf;

use clap::Args;

use super::Failure;
use super::delivery::deliver;
use super::files;
use super::provenance::Provenance;
use crate::model::interpreted::Interpreted;
use crate::report;

/// Read a robot file, validate it, and say what it describes: table, kinematic class, base
/// parameters, operation counts.
#[derive(Args)]
#[command(
    after_help = "Example:\n  denavit check robots/kuka-lwr4.yaml\n  denavit check robots/kuka-lwr4.yaml --json -"
)]
pub(super) struct Check {
    /// Robot file.
    robot: PathBuf,
    /// Write the result as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

impl Check {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        let file = files::robot(&self.robot)?;
        files::check_outputs(&[("--json", &self.json)], &file.read)?;
        let arm = Interpreted::with_effects(&file.robot, &[]);
        deliver(&provenance.robot(&self.robot, &file))
            .json(self.json.as_ref(), || report::check_json(&file.robot, arm.model()))?
            .text(|| report::check_text(&file.robot, arm.model()))
    }
}
