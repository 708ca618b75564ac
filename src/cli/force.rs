//! `denavit force`: estimates the wrench on the tool from joint torques.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use dh_codegen::arm::param;

use super::Failure;
use super::column_check::ColumnCheck;
use super::delivery::deliver;
use super::files;
use super::known_effects::FileEffects;
use super::logbook::{Logbook, Purpose};
use super::motors;
use super::prepare::{Preparation, against_limits, pass, warned};
use super::provenance::Provenance;
use crate::control::estimate::{
    self, Bias, BiasPass, COMPONENTS, Effected, EstimationSettings, Known, Linear, MOST_JOINTS, Method, NoisePass,
    NoiseSource, Run, Series, Torques, Uncertainty,
};
use crate::data::signal::{Motion, Prepare};
use crate::model::Arm;
use crate::model::file_torque_model::FileTorqueModel;
use crate::model::interpreted::Interpreted;
use crate::report;

/// Estimate the wrench on the tool from a log's torques and the identified model, with a 95 % band
/// for each component at each instant.
///
/// The wrench is that of the surroundings on the tool, about the origin of the tool's frame, in its
/// axes. A log's columns fx fy fz mx my mz mean the same; they are compared if they are present.
/// Effects of the robot file are in the model. The band needs the uncertainty of the model:
/// `--identified` takes the JSON of `denavit identify` (use the same low-pass). Without it the
/// noise comes from the residual where nothing touches; without that, from the torque's own noise,
/// and then the model's errors are in no band.
#[derive(Args)]
#[command(
    after_help = concat!(
        "Example:\n  denavit identify robot.yaml fit.csv --out identified.yaml --json identified.json\n  denavit force identified.yaml push.csv --identified identified.json --free 0:2 --bias \\\n      --out wrench.csv --report wrench.html\n  denavit force identified.yaml free.csv --identified identified.json --against nothing\n\nOut:\n  the text and the JSON have figures for each log and component (root mean squares, mean half-width of the band, comparison, phantom force,\n  consistency with the uncertainty); the wrench itself, sample by sample, is in the CSV of --out: t (s), fx fy fz (N), mx my mz (N m),\n  fx_half .. mz_half (half-widths of the 95 % bands; empty: the joints don't tell the component), touching (0 or 1), surprise (a normal deviate:\n  under 3 it is nothing, else something touches or the model is wrong), dexterity (m/rad: near 0 at a singularity), seg, undecided (1: static friction or\n  contact can't be told apart). `meaning` in the JSON says what its names mean.",
        log_columns!()
    )
)]
pub(super) struct Force {
    /// Robot file with its links: identified, or extended by `denavit diagnose`.
    robot: PathBuf,
    /// Logs.
    #[arg(required = true, value_name = "LOG")]
    logs: Vec<PathBuf>,
    /// Reference of the comparison; default: the measured wrench, if the log has it.
    #[arg(long, value_enum, value_name = "WHAT")]
    against: Option<Against>,
    /// How to estimate.
    #[arg(long, value_enum, default_value_t = Estimator::Residual)]
    estimator: Estimator,
    /// JSON that `denavit identify --json` wrote for this robot: standard deviations and
    /// correlations of the parameters, noise of the torques.
    #[arg(long, value_name = "JSON")]
    identified: Option<PathBuf>,
    /// Nothing touches from one time to the other, s, in every log; may stand more than once.
    #[arg(long, value_name = "FROM:TO", value_parser = stretch)]
    free: Vec<[f64; 2]>,
    /// Take off the mean of what the model leaves in the `--free` stretches.
    #[arg(long, requires = "free")]
    bias: bool,
    /// Gain of the momentum observer, 1/s: one over the time constant of its low-pass. Default:
    /// 62.8.
    #[arg(long, value_name = "GAIN")]
    gain: Option<f64>,
    /// Standard deviations by which force and moment wander in a second at most, N,N m: the largest
    /// pace of the Kalman filter. Default: 20,2.
    #[arg(long, value_name = "N,NM", value_parser = pair)]
    wander: Option<[f64; 2]>,
    /// Write t, the wrench, the half-widths of its 95 % band (empty where a component is
    /// unobservable), and whether something touches.
    #[arg(long, value_name = "CSV")]
    out: Option<PathBuf>,
    /// Write the result as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write a page with the six components over time.
    #[arg(long, value_name = "FILE.html")]
    report: Option<PathBuf>,
    #[command(flatten)]
    preparation: Preparation,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Against {
    /// Nothing touches: what is estimated is a phantom.
    Nothing,
    /// The log's columns fx fy fz mx my mz.
    Measured,
}

#[derive(Clone, Copy, ValueEnum)]
enum Estimator {
    /// Inverse dynamics and the weighted pseudo-inverse of J' (the paper's equation 14, weighted by
    /// each instant's uncertainty).
    Residual,
    /// The same with all joints alike, as in the paper.
    Plain,
    /// Generalised-momentum observer: no acceleration.
    Momentum,
    /// Kalman filter over momentum and wrench: no acceleration.
    Kalman,
}

/// Largest number of samples over all logs: the estimate keeps wrench and band of each, some 170
/// bytes.
const MOST_SAMPLES: usize = 750_000;

fn within_memory(log: &str, samples: usize) -> Result<(), Failure> {
    if samples <= MOST_SAMPLES {
        return Ok(());
    }
    Err(Failure::input(format!(
        "{log}: with this log there are more than {MOST_SAMPLES} samples, of each of which the wrench is kept; take every k-th with --stride K, or give fewer or shorter logs"
    )))
}

fn numbers(text: &str, between: char) -> Option<[f64; 2]> {
    let (a, b) = text.split_once(between)?;
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|x| x.is_finite());
    Some([number(a)?, number(b)?])
}

fn stretch(text: &str) -> Result<[f64; 2], String> {
    numbers(text, ':').filter(|[a, b]| a < b).ok_or_else(|| "two times in s, the earlier first, as `0:2.5`".into())
}

fn pair(text: &str) -> Result<[f64; 2], String> {
    let good = |[a, b]: &[f64; 2]| *a > 0.0 && *b > 0.0;
    numbers(text, ',').filter(good).ok_or_else(|| "two numbers above 0, as `20,2`".into())
}

impl Force {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        self.check_options()?;
        let file = files::robot(&self.robot)?;
        motors::on_every_joint(&self.robot, &file.robot, "the estimate takes the torque of every joint from the log")?;
        files::check_outputs(
            &[("--out", &self.out), ("--json", &self.json), ("--report", &self.report)],
            file.read.iter().chain(&self.logs).chain(&self.identified),
        )?;
        let real = file.robot.effective();
        let standard = param::standard_values(&real).ok_or_else(|| {
            Failure::input(format!(
                "{}: a force needs the inertial parameters of every link; add a `links:` list, or identify them (`denavit identify`)",
                self.robot.display()
            ))
        })?;
        let arm = Interpreted::new(&real, &Interpreted::BODIES);
        if arm.dof() == 0 || arm.dof() > MOST_JOINTS {
            return Err(Failure::input(format!("{}: {}", self.robot.display(), estimate::TooManyJoints(arm.dof()))));
        }
        let beta: Vec<f64> =
            arm.base_parameters().iter().map(|b| b.coefficients.iter().map(|&(i, k)| k * standard[i]).sum()).collect();
        let linear = Linear::new(&arm, &beta);
        let predictor = file
            .robot
            .has_effects()
            .then(|| FileTorqueModel::new(&file.robot))
            .transpose()
            .map_err(|e| Failure::input(format!("{}: {e}", self.robot.display())))?;
        let effected = predictor.as_ref().map(|p| Effected(p));
        let torques: &dyn Torques = effected.as_ref().map_or(&linear, |e| e);
        let prepare = Prepare { thinned: false, ..self.preparation.prepare(&file.robot)? };
        let prepare = Prepare { raw_torque: true, margins: true, wrench: true, temperature: true, ..prepare };
        let settings = EstimationSettings { bias: self.bias_of(&arm, torques, &prepare)?, ..self.settings(&prepare) };
        let (uncertainty, known_from) = self.uncertainty(&arm, torques, &prepare)?;

        let joints = file.robot.moving().into_iter().map(|row| &file.robot.joints[row]);
        let limits: Vec<f64> = joints.map(|j| j.limits.torque.unwrap_or(f64::INFINITY)).collect();
        let effects = FileEffects::of(&file.robot, &[]);
        let effects = effects.as_ref().and_then(|e| e.known(&arm, Some(&standard), None));
        let check = ColumnCheck::new(&file.robot, &arm, Some(&standard), effects, prepare.keep);
        let (mut found, mut prepared, mut logbook) = (Vec::new(), Vec::new(), Logbook::default());
        for path in &self.logs {
            let known =
                Known { arm: &arm, standard: &standard, torques, uncertainty: &uncertainty, torque_limits: &limits };
            let mut tool = arm.bodies(&standard);
            let shown = path.display().to_string();
            let mut run = Run::new(&shown, known, &mut tool, settings.clone()).map_err(Failure::input)?;
            let mut columns = check.columns();
            let before: usize = found.iter().map(|series: &Series| series.time.len()).sum();
            let sink = |motion: &Motion| {
                check.absorb(&mut columns, motion);
                if before + run.samples() <= MOST_SAMPLES {
                    run.absorb(motion);
                }
            };
            let mut log = warned(path, logbook.pass(Purpose::Estimate, path, arm.dof(), &prepare, sink)?);
            within_memory(&shown, before + run.samples())?;
            against_limits(std::slice::from_mut(&mut log), &file.robot, prepare.keep)?;
            check.finish(&columns, &mut log)?;
            prepared.push(log);
            found.push(self.compared(run.finish())?);
        }
        let outcome =
            report::Forces { robot: arm.name(), found: &found, uncertainty: &uncertainty, known_from: &known_from };
        let provenance = provenance
            .robot(&self.robot, &file)
            .logs(&logbook)
            .with("low-pass", Preparation::low_pass(&prepare))
            .with("errors of the model", &known_from);
        self.deliver(&outcome, &prepared, &provenance)
    }

    /// Sets the reference for the comparison according to the options.
    fn compared(&self, mut series: Series) -> Result<Series, Failure> {
        if self.against == Some(Against::Measured) && series.measured.is_empty() {
            return Err(Failure::input(format!(
                "{}: --against measured needs the columns fx fy fz mx my mz with a number in every row; leave it out, or use --against nothing where nothing touches",
                series.name
            )));
        }
        if self.against == Some(Against::Nothing) {
            series.measured.clear();
        }
        Ok(series)
    }

    /// Settings of the estimation according to the options.
    fn settings(&self, prepare: &Prepare) -> EstimationSettings {
        let mut settings = EstimationSettings { filter: prepare.filter, ..EstimationSettings::default() };
        settings.gain = self.gain.unwrap_or(settings.gain);
        settings.method = match self.estimator {
            Estimator::Residual => Method::Residual,
            Estimator::Plain => Method::Plain,
            Estimator::Momentum => Method::Momentum,
            Estimator::Kalman => Method::Kalman,
        };
        if let Some([force, moment]) = self.wander {
            settings.wander = estimate::Scale { force, moment };
        }
        settings.free.clone_from(&self.free);
        settings.nothing_touches = self.against == Some(Against::Nothing);
        settings
    }

    /// Refuses options that are out of range, or have no effect with the others.
    fn check_options(&self) -> Result<(), Failure> {
        if self.out.is_some() && self.logs.len() > 1 {
            return Err(Failure::input("--out writes the wrench of one log; run the command once for each log"));
        }
        if let Some(gain) = self.gain.filter(|gain| !(*gain > 0.0 && *gain < 1e4)) {
            return Err(Failure::input(format!("--gain {gain}: 1/s, above 0 and below 10000")));
        }
        if self.against == Some(Against::Nothing) && !self.free.is_empty() && !self.bias {
            return Err(Failure::input(
                "--free has no effect beside --against nothing, which says that nothing touches throughout; leave one of them out",
            ));
        }
        let belongs = [
            (self.gain.is_some(), "--gain", matches!(self.estimator, Estimator::Momentum), "momentum"),
            (self.wander.is_some(), "--wander", matches!(self.estimator, Estimator::Kalman), "kalman"),
        ];
        if let Some((_, option, _, estimator)) = belongs.iter().find(|(given, _, its, _)| *given && !its) {
            return Err(Failure::input(format!(
                "{option} has no effect on this estimator; leave it out, or add --estimator {estimator}"
            )));
        }
        Ok(())
    }

    fn bias_of(&self, arm: &Interpreted, torques: &dyn Torques, prepare: &Prepare) -> Result<Option<Bias>, Failure> {
        if !self.bias {
            return Ok(None);
        }
        let mut first = BiasPass::new(arm, torques, prepare.filter, &self.free);
        for path in &self.logs {
            pass(path, arm.dof(), prepare, |motion| first.absorb(motion))?;
        }
        first.finish().map(Some).ok_or_else(|| {
            Failure::input("no sample of the logs lies in the --free stretches; their times are those of the column t")
        })
    }

    /// Uncertainty of the model, and a description of its source.
    fn uncertainty(
        &self,
        arm: &Interpreted,
        torques: &dyn Torques,
        prepare: &Prepare,
    ) -> Result<(Uncertainty, String), Failure> {
        if let Some(path) = &self.identified {
            let text = files::text(path)?;
            let bad = |what: String| Failure::input(format!("{}: {what}", path.display()));
            let json: serde_json::Value = serde_json::from_str(&text).map_err(|e| bad(format!("not JSON: {e}")))?;
            let known =
                report::uncertainty_of_json(&json, arm.base_parameters(), arm.dof()).map_err(|e| bad(e.to_string()))?;
            return Ok((known, format!("{}: parameters and noise", path.display())));
        }
        let mut first =
            NoisePass::new(arm, torques, prepare.filter, &self.free, self.against == Some(Against::Nothing));
        for path in &self.logs {
            pass(path, arm.dof(), prepare, |motion| first.absorb(motion))?;
        }
        let parameters = arm.base_parameters().len();
        Ok(match first.left(self.bias) {
            Some(noise) => (
                Uncertainty::noise(noise, NoiseSource::Free, parameters),
                "what the model leaves where nothing touches, all of it counted as noise".into(),
            ),
            None => (
                Uncertainty::noise(first.white(), NoiseSource::Log, parameters),
                "the torque's own noise alone: the model's errors are in no band".into(),
            ),
        })
    }

    fn deliver(
        &self,
        outcome: &report::Forces<'_>,
        prepared: &[crate::data::signal::Prepared],
        provenance: &Provenance,
    ) -> Result<(), Failure> {
        let mut out = deliver(provenance);
        if let (Some(path), [series]) = (&self.out, outcome.found) {
            write_csv(path, series)?;
            out.wrote(path);
        }
        out.file(self.report.as_ref(), || report::force_html(outcome, prepared, &provenance.rows()))?
            .json(self.json.as_ref(), || report::force_json(outcome, prepared, &provenance.rows()))?
            .text(|| report::force_text(outcome, prepared))
    }
}

/// Writes one row per used sample.
fn write_csv(path: &Path, series: &Series) -> Result<(), Failure> {
    let mut header = vec!["t".to_string()];
    header.extend(COMPONENTS.iter().map(|c| (*c).to_string()));
    header.extend(COMPONENTS.iter().map(|c| format!("{c}_half")));
    header.extend(["touching".to_string(), "surprise".into(), "dexterity".into(), "seg".into(), "undecided".into()]);
    files::stream(path, |out| {
        writeln!(out, "{}", header.join(","))?;
        for s in 0..series.time.len() {
            let mut row = vec![format!("{:.6}", series.time[s])];
            row.extend(series.wrench[s].iter().map(|x| format!("{x:.6}")));
            // Empty where a component is unobservable.
            row.extend(
                (0..6)
                    .map(|i| if series.observable[s][i] { format!("{:.6}", series.half[s][i]) } else { String::new() }),
            );
            row.push(u8::from(series.touching[s]).to_string());
            row.push(format!("{:.3}", series.deviate[s]));
            row.push(format!("{:.5}", series.dexterity[s]));
            row.push(series.segment[s].to_string());
            row.push(u8::from(series.undecided[s]).to_string());
            writeln!(out, "{}", row.join(","))?;
        }
        Ok(())
    })
}
