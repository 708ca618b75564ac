//! `denavit import`: makes a robot file from a URDF or MJCF model.

use std::path::PathBuf;

use clap::Args;
use dh_codegen::robot::no_files;

use super::Failure;
use super::delivery::deliver;
use super::files;
use super::provenance::Provenance;
use crate::exchange::{ImportOptions, import};
use crate::report;

/// Make a robot file of a URDF or MJCF model.
///
/// The chain from base to tip becomes a modified DH table with a constant `base` pose and the tip
/// as the tool frame. Positions stay the model's own: joint names, zeros and directions are those
/// of its logs. Links behind fixed joints and beside the chain count to the link that carries them;
/// limits, damping, friction and armature come along. What the model does not say is listed, and
/// never filled in.
///
/// Source and result are compared: the tip's pose at 50 random states.
#[derive(Args)]
#[command(after_help = "Examples:\n  denavit import ur5.urdf --tip tool0 --out ur5.yaml\n  \
    xacro panda.urdf.xacro | denavit import - --tip panda_hand --at panda_finger_joint1=0.02 --out panda.yaml")]
pub(super) struct Import {
    /// URDF or MJCF file; `-` for standard input.
    file: PathBuf,
    /// Link (body) that is the world of the robot file; default: the root.
    #[arg(long, value_name = "LINK")]
    base: Option<String>,
    /// Link (body) that is the tool frame; default: the only leaf behind the most moving joints,
    /// or the link that carries the fingers of a gripper there.
    #[arg(long, value_name = "LINK")]
    tip: Option<String>,
    /// Position of a joint beside the arm, rad or m, `30deg` too; `zero`: all others at zero, or at
    /// the limit next to it.
    #[arg(long, value_name = "JOINT=VALUE", num_args = 1)]
    at: Vec<String>,
    /// Angles of the model that are within this of an exact fraction of pi are taken for it, rad
    /// (relative above 1). 1e-5 for models that were written with 1.5708 or 3.1416.
    #[arg(long, value_name = "RAD", default_value_t = 1e-9)]
    snap: f64,
    /// Robot file to write; `-` for standard output.
    #[arg(long, value_name = "ROBOT")]
    out: Option<PathBuf>,
    /// Write what was found as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

impl Import {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        let from_input = files::is_stdin(&self.file);
        let read: &[PathBuf] = if from_input { &[] } else { std::slice::from_ref(&self.file) };
        files::check_outputs(&[("--out", &self.out), ("--json", &self.json)], read)?;
        let text = files::text(&self.file)?;
        let shown = if from_input { "standard input".to_string() } else { self.file.display().to_string() };
        let made = import(&text, &self.options()?).map_err(|e| Failure::input(e.in_file(&shown)))?;
        let provenance = provenance.model(&shown, &text);
        let yaml = || {
            let source = format!("{} `{}`, {shown}", made.format, made.model);
            let yaml = made.robot.to_yaml_with_source(Some(&source));
            let list = |title: &str, all: &[String]| all.iter().map(|s| format!("{title}: {s}")).collect::<Vec<_>>();
            let found = [list("unknown", &made.unknown), list("cannot be", &made.impossible)].concat();
            made.robot.rewritten(&yaml, &no_files, &no_files, &provenance.run(found))
        };
        deliver(&provenance)
            .file(self.out.as_ref(), yaml)?
            .json(self.json.as_ref(), || report::import_json(&made))?
            .only_text(|| report::import_text(&made))
    }

    fn options(&self) -> Result<ImportOptions, Failure> {
        if !(0.0..=1e-2).contains(&self.snap) {
            return Err(Failure::input("--snap is an angle from 0 to 0.01 rad; 1e-5 is the rounding of 1.5708"));
        }
        let mut options = ImportOptions {
            base: self.base.clone(),
            tip: self.tip.clone(),
            snap: self.snap,
            ..ImportOptions::default()
        };
        (options.at, options.at_zero) = held(&self.at)?;
        Ok(options)
    }
}

/// Parses `joint=value` of all `--at`; also whether one is `zero`.
pub(super) fn held(all: &[String]) -> Result<(Vec<(String, f64)>, bool), Failure> {
    let one = |at: &String| {
        let wrong = || {
            let mend = "write the joint's name and its position, as in finger_joint=0.02, or `zero`";
            Failure::input(format!("--at {at}: {mend}"))
        };
        let (name, value) = at.rsplit_once('=').ok_or_else(wrong)?;
        let (number, unit) = value.strip_suffix("deg").map_or((value, 1.0), |v| (v, 1f64.to_radians()));
        let number = number.trim().parse::<f64>().ok().filter(|v| v.is_finite()).ok_or_else(wrong)?;
        Ok((name.to_string(), number * unit))
    };
    let given: Result<_, Failure> = all.iter().filter(|at| *at != "zero").map(one).collect();
    Ok((given?, all.iter().any(|at| at == "zero")))
}
