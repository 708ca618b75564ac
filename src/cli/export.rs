//! `denavit export`: writes a robot file as URDF or MJCF.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::Failure;
use super::delivery::deliver;
use super::files;
use super::import::held;
use super::provenance::Provenance;
use crate::exchange::{ModelFormat, export, onto};
use crate::report;

/// Write a robot file as URDF or MJCF, for simulators that read those.
///
/// Each row becomes a link with a joint; the tool becomes a link of its own. Inertias, limits,
/// damping and Coulomb friction come along, in MJCF also rotor inertias and springs. What the
/// format has no words for is listed.
#[derive(Args)]
#[command(after_help = "Example:\n  denavit export identified.yaml --format mjcf --out identified.xml")]
pub(super) struct Export {
    /// Robot file.
    robot: PathBuf,
    /// Format to write; `--onto` writes the format of its file.
    #[arg(long, value_enum, required_unless_present = "onto")]
    format: Option<Format>,
    /// A model of the same robot: its text gets the numbers, meshes, names and comments stay.
    #[arg(long, value_name = "FILE")]
    onto: Option<PathBuf>,
    /// With --onto: where a joint beside the arm stood, as for `import`; others at zero, or at the
    /// limit next to it.
    #[arg(long, value_name = "JOINT=VALUE", num_args = 1, requires = "onto")]
    at: Vec<String>,
    /// Model to write; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// Write what was left out as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Format {
    /// The Unified Robot Description Format, as ROS reads it.
    Urdf,
    /// MuJoCo's format.
    Mjcf,
}

impl Export {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        let file = files::robot(&self.robot)?;
        let out = Some(self.out.clone());
        files::check_outputs(&[("--out", &out), ("--json", &self.json)], file.read.iter().chain(&self.onto))?;
        // Effects of geometry and bodies are part of the exported robot.
        let robot = file.robot.effective();
        let made = match (&self.onto, self.format) {
            (Some(model), _) => {
                let text = files::text(model)?;
                self.same_format(model, &text)?;
                let (held, _) = held(&self.at)?;
                onto(&robot, &text, &held).map_err(|e| Failure::input(e.in_file(&model.display().to_string())))?
            }
            (None, Some(Format::Mjcf)) => export(&robot, ModelFormat::Mjcf),
            (None, _) => export(&robot, ModelFormat::Urdf),
        };
        deliver(&provenance.robot(&self.robot, &file))
            .file(Some(&self.out), || &made.text)?
            .json(self.json.as_ref(), || report::export_json(&file.robot.name, &made))?
            .only_text(|| report::export_text(&file.robot.name, &made))
    }

    /// Refuses to write a model in another format than its own.
    fn same_format(&self, model: &std::path::Path, text: &str) -> Result<(), Failure> {
        let (own, word) = match ModelFormat::of(text) {
            ModelFormat::Urdf => (Format::Urdf, "urdf"),
            ModelFormat::Mjcf => (Format::Mjcf, "mjcf"),
        };
        match self.format {
            Some(format) if format != own => {
                let shown = model.display();
                Err(Failure::input(format!("{shown} is {word}, and --onto keeps its format; write --format {word}")))
            }
            _ => Ok(()),
        }
    }
}
