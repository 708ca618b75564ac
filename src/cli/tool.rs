//! `denavit tool`: identifies the arm's payload, and recognises which tool it is.

use std::fs;
use std::path::PathBuf;

use clap::Args;
use dh_codegen::arm::{Function, param};
use dh_codegen::robot::{Robot, Tool};

use super::Failure;
use super::delivery::deliver;
use super::files;
use super::known_effects::{FileEffects, without};
use super::logbook::{Logbook, Purpose};
use super::motors;
use super::prepare::{Preparation, against_limits, pass, warned};
use super::provenance::Provenance;
use super::terminal;
use super::torque_columns::Tried;
use crate::control::estimate::Uncertainty;
use crate::data::signal::{Motion, Prepare, Prepared};
use crate::identify::recording::moving;
use crate::identify::tool::{
    Carrying, Entry, Found, RecogniseSettings, Tolerance, ToolError, ToolSettings, identify_tool, look_up,
};
use crate::identify::{
    AccumulatorSettings, Factors, Identification, IdentifyError, KnownEffects, QrAccumulator, Reference, Trace, Tracer,
    Underdetermined,
};
use crate::model::Arm;
use crate::model::interpreted::Interpreted;
use crate::report;

/// Identify what the arm carries, from logs with an empty hand and with the tool, and look it up
/// among known tools.
///
/// The ten parameters M, MS and I (XX YY ZZ XY XZ YZ), printed and in the JSON, are those of
/// everything that the loaded log has beyond the unloaded one. They are given in the robot's last
/// DH frame and about its origin, as in the paper's table III. Where a tool frame is known (the
/// robot file's tool, else the recognised tool's pose) they are shown in that too. Without an
/// unloaded log the robot file's own parameters are taken as known. A tool's size is interpolated
/// within a family of the table: tools with a size whose names differ in words with digits alone,
/// such as roller-300x150 and roller-400x180.
#[derive(Args)]
#[command(
    after_help = concat!(
        "Examples:\n  denavit tool robots/kuka-lwr4.yaml --unloaded empty.csv --loaded roller.csv \\\n      --tools robots/tools --report tool.html\n  denavit tool identified.yaml --loaded roller.csv --tools robots/tools --known-mass 0.2 --json -",
        log_columns!()
    )
)]
pub(super) struct ToolVerb {
    /// Robot file.
    robot: PathBuf,
    /// Logs with an empty hand. Without any, the robot file's parameters are taken as known.
    #[arg(long, num_args = 1.., value_name = "LOG")]
    unloaded: Vec<PathBuf>,
    /// Logs with the tool.
    #[arg(long, num_args = 1.., required = true, value_name = "LOG")]
    loaded: Vec<PathBuf>,
    /// Folder with tool files (*.yaml) to look the tool up in.
    #[arg(long, value_name = "DIR")]
    tools: Option<PathBuf>,
    /// Mass from a scale, kg; the other nine are then known better.
    #[arg(long, value_name = "KG")]
    known_mass: Option<f64>,
    /// Standard deviation of --known-mass, kg (a scale that shows grams: 0.0003). Zero takes it as
    /// exact: an error of a gram then moves the centre of a 200 g tool by half a percent of its
    /// distance.
    #[arg(long, default_value_t = 0.0, value_name = "KG", requires = "known_mass")]
    mass_std: f64,
    /// Without --unloaded: take only links and rotors from the robot file, and estimate friction
    /// and offsets from the loaded log.
    #[arg(long, conflicts_with = "unloaded")]
    refresh_friction: bool,
    /// Without --unloaded: the JSON that `denavit identify` wrote of this robot. The standard
    /// deviations then hold the robot's own errors, too; else its parameters are taken as exact.
    #[arg(long, conflicts_with = "unloaded", value_name = "JSON")]
    identified: Option<PathBuf>,
    /// Without --unloaded: the robot file's own tool stays on the arm, and what is carried comes on
    /// top. Else it counts as taken off.
    #[arg(long, conflicts_with = "unloaded")]
    on_top: bool,
    /// Origin of the tools' frames in the robot's last DH frame, m, in place of the `xyz` of their
    /// files.
    #[arg(long, value_delimiter = ',', num_args = 1, value_name = "X,Y,Z", requires = "tools")]
    mount: Option<Vec<f64>>,
    /// With what probability a tool of the table is rejected.
    #[arg(long, default_value_t = 0.01, value_name = "P", requires = "tools")]
    level: f64,
    /// Accuracy of the tool files and of the mounting: standard deviations of mass (relative),
    /// place (m) and direction (rad).
    #[arg(long, value_delimiter = ',', num_args = 1, value_name = "M,P,A", requires = "tools")]
    tolerance: Option<Vec<f64>>,
    /// Write the result as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write a page with the body, the table and the torques.
    #[arg(long, value_name = "FILE.html")]
    report: Option<PathBuf>,
    #[command(flatten)]
    preparation: Preparation,
}

impl ToolVerb {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        let (tolerance, recognising) = self.looking_up()?;
        self.preparation.check_options(None)?;
        let file = files::robot(&self.robot)?;
        motors::on_every_joint(&self.robot, &file.robot, "the tool is identified from the torques of every joint")?;
        files::check_outputs(
            &[("--json", &self.json), ("--report", &self.report)],
            file.read.iter().chain(&self.unloaded).chain(&self.loaded).chain(&self.identified),
        )?;
        self.check_refresh(&file.robot)?;
        let mut prepare = self.preparation.prepare(&file.robot)?;
        let mut bare = file.robot.clone();
        let own = bare.tool.take();
        if self.on_top && own.is_none() {
            return Err(Failure::input(format!(
                "--on-top: {} has no tool that could stay on the arm; leave the option out",
                self.robot.display()
            )));
        }
        let table = self.table(&tolerance)?;
        let arm = Interpreted::new(&bare, &[Function::PayloadRegressor]);
        let errors = self.known_errors(&arm)?;
        let settings = ToolSettings {
            robot: param::standard_values(if self.on_top { &file.robot } else { &bare }),
            known_mass: self.known_mass,
            mass_std: self.mass_std,
            refresh_friction: self.refresh_friction,
            robot_covariance: errors.as_ref().map(|errors| errors.covariance.clone()),
        };
        let effects = FileEffects::of(&bare, &[]);
        effects.iter().for_each(|effects| effects.prepare(&mut prepare));
        let file_values = param::standard_values(&bare);
        let known = effects.as_ref().and_then(|effects| effects.known(&arm, file_values.as_deref(), prepare.filter));
        let Read { unloaded, loaded, mut prepared, logbook } = self.read(&arm, &prepare, known.as_ref())?;
        against_limits(&mut prepared, &file.robot, prepare.keep)?;
        let mut carried = identify_tool(&arm, &unloaded, &loaded, &settings).map_err(unsolved)?;
        self.explain(&mut carried.solved, &file.robot, &arm, &prepare, known.as_ref())?;
        let found = look_up(carried, own.as_ref(), table, &tolerance, &recognising);
        let provenance =
            provenance.robot(&self.robot, &file).logs(&logbook).with("low-pass", Preparation::low_pass(&prepare));
        let mut warnings = report::tool_warnings(&found, &prepared);
        errors.iter().flat_map(taken_as_exact).for_each(|text| warnings.push(text));
        effects.iter().for_each(|effects| warnings.push(effects.sentence(known.is_some())));

        let page = || {
            let traces = self.traces(&arm, &found, &prepare, known.as_ref())?;
            Ok(report::tool_html(&found, &prepared, &warnings, &traces, &provenance.rows()))
        };
        deliver(&provenance)
            .try_file(self.report.as_ref(), page)?
            .json(self.json.as_ref(), || report::tool_json(&found, &prepared, &warnings, &provenance.rows()))?
            .text(|| report::tool_text(&found, &prepared, &warnings))?;
        match found.carried.solved.underdetermined() {
            Some(Underdetermined::Equations { .. }) => {
                Err(Failure::other("the logs do not determine what the arm carries; record a longer motion"))
            }
            _ => Ok(()),
        }
    }

    /// First pass over all logs. Torques of known effects are subtracted.
    fn read(&self, arm: &Interpreted, prepare: &Prepare, known: Option<&KnownEffects<'_>>) -> Result<Read, Failure> {
        if let Some(twice) = self.unloaded.iter().find(|log| self.loaded.contains(log)) {
            return Err(Failure::input(format!(
                "{}: the same log stands under --unloaded and --loaded; give one with an empty hand and one with the tool",
                twice.display()
            )));
        }
        let mut read = Read::default();
        let unloaded = self.unloaded.iter().map(|path| (Purpose::Unloaded, path));
        for (purpose, path) in unloaded.chain(self.loaded.iter().map(|path| (Purpose::Loaded, path))) {
            let carrying = Carrying::new(arm, purpose == Purpose::Loaded);
            let mut stack = QrAccumulator::new(&path.display().to_string(), &carrying, AccumulatorSettings::default());
            let sink = |motion: &Motion| stack.absorb(&without(known, motion));
            let log = read.logbook.pass(purpose, path, carrying.dof(), prepare, sink)?;
            read.prepared.push(warned(path, log));
            let factors = if purpose == Purpose::Loaded { &mut read.loaded } else { &mut read.unloaded };
            factors.push(stack.finish());
        }
        Ok(read)
    }

    fn check_refresh(&self, robot: &Robot) -> Result<(), Failure> {
        if self.refresh_friction
            && !moving(robot).any(|joint| {
                joint.drive.viscous_friction.or(joint.drive.coulomb_friction).or(joint.drive.offset).is_some()
            })
        {
            return Err(Failure::input(format!(
                "--refresh-friction: {} has no friction that could be refreshed; give joints a `drive` with `friction`, or leave the option out",
                self.robot.display()
            )));
        }
        Ok(())
    }

    /// Tries other orders and units of the torque columns if the torques may be misinterpreted.
    fn explain(
        &self,
        found: &mut Identification,
        robot: &Robot,
        arm: &Interpreted,
        prepare: &Prepare,
        known: Option<&KnownEffects<'_>>,
    ) -> Result<(), Failure> {
        if !found.is_suspicious() {
            return Ok(());
        }
        let mut tried = Tried::new(robot, prepare, known);
        let unloaded = self.unloaded.iter().map(|path| (path, false));
        for (path, loaded) in unloaded.chain(self.loaded.iter().map(|path| (path, true))) {
            tried.log(path, &Carrying::new(arm, loaded), &[Reference::Fit])?;
        }
        tried.tell(found);
        Ok(())
    }

    /// Uncertainty of the robot file's parameters.
    fn known_errors(&self, arm: &Interpreted) -> Result<Option<Uncertainty>, Failure> {
        let Some(path) = &self.identified else { return Ok(None) };
        let bad = |what: String| Failure::input(format!("{}: {what}", path.display()));
        let json = serde_json::from_str(&files::text(path)?).map_err(|e| bad(format!("not JSON: {e}")))?;
        report::uncertainty_of_json(&json, arm.base_parameters(), arm.dof()).map(Some).map_err(|e| bad(e.to_string()))
    }

    fn looking_up(&self) -> Result<(Tolerance, RecogniseSettings), Failure> {
        if !(self.level > 0.0 && self.level < 1.0) {
            return Err(Failure::input(format!("--level {}: a probability between 0 and 1", self.level)));
        }
        let tolerance = match self.tolerance.as_deref() {
            Some(&[mass, position, angle]) => Tolerance { mass, position, angle },
            Some(other) => {
                let what = format!("--tolerance: {} numbers; give three, as in 0.005,0.0005,0.005", other.len());
                return Err(Failure::input(what));
            }
            None => Tolerance::default(),
        };
        for size in [tolerance.mass, tolerance.position, tolerance.angle] {
            if !(size.is_finite() && size >= 0.0) {
                return Err(Failure::input(format!("--tolerance: {size} is no standard deviation; give zero or more")));
            }
        }
        if let Some(mount) = self.mount.as_ref().filter(|m| m.len() != 3) {
            return Err(Failure::input(format!("--mount: {} numbers; give three, as in 0,0,0.107", mount.len())));
        }
        if let Some(x) = self.mount.iter().flatten().find(|x| !x.is_finite()) {
            return Err(Failure::input(format!("--mount: {x} is no length")));
        }
        Ok((tolerance, RecogniseSettings { level: self.level, ..RecogniseSettings::default() }))
    }

    /// Tool files of the folder, ordered by name.
    fn table(&self, tolerance: &Tolerance) -> Result<Vec<Entry>, Failure> {
        let Some(folder) = &self.tools else { return Ok(Vec::new()) };
        let shown = folder.display();
        let listing = fs::read_dir(folder).map_err(|e| {
            Failure::input(format!("{shown} can't be read: {e}; --tools names a folder with tool files"))
        })?;
        let mut paths: Vec<PathBuf> = listing
            .filter_map(|entry| entry.ok().map(|e| e.path()))
            .filter(|p| p.extension().is_some_and(|e| e == "yaml" || e == "yml"))
            .collect();
        paths.sort();
        let mount = match self.mount.as_deref() {
            Some(&[x, y, z]) => Some([x, y, z]),
            _ => None,
        };
        let mut table: Vec<Entry> = Vec::new();
        for path in &paths {
            let shown = path.display().to_string();
            let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
            let (tool, notes) = Tool::from_yaml(&files::text(path)?, &stem)
                .map_err(|problems| Failure::input(format!("{shown} can't be used:\n{}", problems.in_file(&shown))))?;
            notes.iter().for_each(|note| terminal::say(&format!("{shown}: note: {note}")));
            match Entry::new(&tool, mount, tolerance) {
                Some(entry) if table.iter().any(|e| e.name == entry.name) => {
                    let what =
                        format!("{shown}: a tool named {} is in this folder already; give it its own name", entry.name);
                    return Err(Failure::input(what));
                }
                Some(entry) => table.push(entry),
                None => {
                    terminal::say(&format!("{shown}: note: has no M, MS and I, so nothing can be recognised by it"))
                }
            }
        }
        if table.is_empty() {
            return Err(Failure::input(format!("{shown} holds no tool file (*.yaml) with M, MS and I")));
        }
        Ok(table)
    }

    /// Torques over time for plots: a second pass.
    fn traces(
        &self,
        arm: &Interpreted,
        found: &Found,
        prepare: &Prepare,
        known: Option<&KnownEffects<'_>>,
    ) -> Result<Vec<Trace>, Failure> {
        let logs = self.loaded.iter().map(|p| (p, true)).chain(self.unloaded.iter().map(|p| (p, false)));
        logs.map(|(path, loaded)| {
            let carrying = Carrying::new(arm, loaded);
            let mut tracer = Tracer::new(&path.display().to_string(), false, &carrying, &found.carried.beta);
            pass(path, arm.dof(), prepare, |motion| tracer.absorb(&without(known, motion)))?;
            Ok(tracer.finish())
        })
        .collect()
    }
}

/// Result of the first pass over the logs.
#[derive(Default)]
struct Read {
    unloaded: Vec<Factors>,
    loaded: Vec<Factors>,
    prepared: Vec<Prepared>,
    logbook: Logbook,
}

/// Note on robot parameters whose errors the identification did not determine.
fn taken_as_exact(errors: &Uncertainty) -> Option<String> {
    let open = errors.open.join(", ");
    (!open.is_empty()).then(|| format!("--identified has no standard deviation of {open}: taken as exact"))
}

/// Too few samples are a verdict on the data; other problems are those of the input.
fn unsolved(error: ToolError) -> Failure {
    match error {
        ToolError::Identify(IdentifyError::TooFew { .. }) => Failure::other(format!("underdetermined: {error}")),
        _ => Failure::input(error),
    }
}
