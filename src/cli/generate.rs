//! `denavit generate`: writes the drop-in crate, or says whether the one on disk is stale.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use clap::Args;
use dh_codegen::arm::Function;

use super::provenance::Provenance;
use super::{Failure, files};

/// Write the drop-in crate with the robot's closed-form functions.
///
/// The crate is a folder of its own: no_std, no allocation, no dependency. The same file always gives the same bytes.
#[derive(Args)]
#[command(
    after_help = "Example:\n  denavit generate robots/kuka-lwr4.yaml --out generated/kuka-lwr4\n  denavit generate robots/kuka-lwr4.yaml --out generated/kuka-lwr4 --check\n  denavit generate robots/ur10e.yaml --out ur10e --adjoints"
)]
pub(super) struct Generate {
    /// Robot file.
    robot: PathBuf,
    /// Folder of the crate; made if it is not there. Only files of the crate are written.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Derivatives too: of the regressors, the torques and the frames, as products with the transposed Jacobian (`base_regressor_adjoint` and so on).
    #[arg(long)]
    adjoints: bool,
    /// Write nothing; exit with 1 where the crate in DIR is not what would be written.
    #[arg(long)]
    check: bool,
    /// Write the list of files and what became of them as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

impl Generate {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        let file = files::robot(&self.robot)?;
        files::check_outputs(&[("--json", &self.json)], &file.read)?;
        let further: &[Function] = if self.adjoints { &Function::ADJOINTS } else { &[] };
        let crate_files = dh_codegen::krate_with(&file.robot, &file.text, further);
        let stale = differing(&self.out, &crate_files);
        if self.check && !stale.is_empty() {
            let adjoints = if self.adjoints { " --adjoints" } else { "" };
            let again = format!("denavit generate {} --out {}{adjoints}", self.robot.display(), self.out.display());
            return Err(Failure::other(format!(
                "stale in {}: {}; run `{again}`",
                self.out.display(),
                stale.join(", ")
            )));
        }
        if !self.check {
            for path in &stale {
                files::create_folder(&self.out, Path::new(path))?;
                files::write(&self.out.join(path), crate_files[*path].as_bytes())?;
            }
        }
        if let Some(target) = &self.json {
            let value = serde_json::json!({ "out": self.out.display().to_string(), "files": crate_files.len(), "written": if self.check { vec![] } else { stale.clone() } });
            files::json(target, value, &provenance.robot(&self.robot, &file))?;
        }
        if !files::is_stdout(&self.json) {
            let what = if stale.is_empty() {
                "up to date".into()
            } else {
                format!("{} of {} files written", stale.len(), crate_files.len())
            };
            files::print(&format!("{}: {what}\n", self.out.display()))?;
        }
        Ok(())
    }
}

/// Files that are not on disk as they would be written.
fn differing<'a>(out: &Path, crate_files: &'a BTreeMap<String, String>) -> Vec<&'a str> {
    crate_files
        .iter()
        .filter(|(path, text)| std::fs::read(out.join(path)).ok().as_deref() != Some(text.as_bytes()))
        .map(|(path, _)| path.as_str())
        .collect()
}
