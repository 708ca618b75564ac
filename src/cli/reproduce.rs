//! `denavit reproduce`: reruns the paper's experiments, with each table and figure beside the
//! paper's own values.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressStyle};

use super::Failure;
use super::delivery::deliver;
use super::files;
use super::provenance::Provenance;
use crate::apps::paper::diagnosis::DiagnosisSettings;
use crate::apps::paper::diagnosis::real::{self, ARMS, ArmData, RealBattery, RealSettings, Recorded};
use crate::apps::paper::{
    self, ExcitationSettings, ForceSettings, IdentificationSettings, PaintingSettings, ReproduceError,
};
use crate::report::{self, Parts};

/// Run the paper's experiments on the simulated robot and print each table and figure beside the
/// paper's own values, with a verdict per row.
///
/// Needs no file: the KUKA LWR and its tools are built in, motions are designed and played on the
/// spot. A verdict compares what should be small: better (by more than 5 %), within (5 %), or short
/// by so many percent.
#[derive(Args)]
#[command(
    after_help = "Example:\n  denavit reproduce identification --report reproduce.html\nParts:\n  excitation       section III: Fig. 5, and the same task on other arms (some minutes)\n  identification   sections II.D, II.E, III.E, VI.A: Fig. 6, tables II and III, Fig. 10, and whether standard deviations are honest\n  force            section V.B: accuracy of the estimated wrench, coverage of its bands\n  painting         sections V, VI.B: Table IV, Figs. 12 and 13, and what the diagnosis makes of them (some minutes)\n  diagnosis        effects that a seed hides in the simulator, and what `denavit diagnose` makes of the logs (4 s a case);\n                   with --on-real, known causes added to real recordings\nWithout a part: all of them."
)]
pub(super) struct Reproduce {
    /// Part to run; default: all.
    #[arg(value_enum)]
    part: Option<Part>,
    /// Runs with other noise, to see whether standard deviations are honest; 0 for none.
    #[arg(long, value_name = "N", default_value_t = IdentificationSettings::default().runs)]
    runs: usize,
    /// Longest motion of Fig. 5, s.
    #[arg(long, value_name = "S", default_value_t = ExcitationSettings::default().longest, value_parser = longest)]
    longest: usize,
    /// Cases of the diagnosis [default: 40, which go round in 40 kinds; with --on-real 30, each in
    /// all --sizes].
    #[arg(long, value_name = "N", value_parser = cases)]
    cases: Option<usize>,
    /// First seed of the diagnosis; each case has the next.
    #[arg(long, value_name = "SEED", default_value_t = DiagnosisSettings::default().from)]
    from: u64,
    /// Root mean square of a hidden effect by the noise of its joint.
    #[arg(long, value_name = "TIMES", default_value_t = DiagnosisSettings::default().size, value_parser = size)]
    size: f64,
    /// Add known causes to real recordings instead of hiding effects in the simulator.
    #[arg(long)]
    on_real: bool,
    /// Folder of the recordings for --on-real, with a folder per arm.
    #[arg(long, value_name = "DIR", requires = "on_real")]
    data: Option<PathBuf>,
    /// Folders of --data that are used.
    #[arg(long, value_name = "FOLDER", value_delimiter = ',', requires = "on_real")]
    arms: Vec<String>,
    /// Sizes of what --on-real adds, in root mean squares of the identified model's residual.
    #[arg(long, value_name = "TIMES", value_delimiter = ',', value_parser = residuals, requires = "on_real", default_values_t = RealSettings::default().sizes)]
    sizes: Vec<f64>,
    /// Diagnose only those of --on-real whose size a fit that knows the form recovers within 20 %.
    #[arg(long, requires = "on_real")]
    recoverable: bool,
    /// Hide nothing in the cases of the diagnosis: all that is named is a false alarm.
    #[arg(long)]
    clean: bool,
    /// Painting in a quarter of a minute instead of some: a hand's breadth of wall, one roller, no
    /// diagnosis; to see that it runs.
    #[arg(long)]
    quick: bool,
    /// Of motions and noise: the same seed gives the same figures.
    #[arg(long, value_name = "N", default_value_t = IdentificationSettings::default().seed)]
    seed: u64,
    /// Write rows and figures as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write a page with tables and figures.
    #[arg(long, value_name = "FILE.html")]
    report: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Part {
    /// Section III: what longer motions gain.
    Excitation,
    /// Sections II.D, II.E, III.E, VI.A.
    Identification,
    /// Sections V, VI.B: pressing on a wall without a force sensor.
    Painting,
    /// Section V.B: the wrench on the tool, and its bands.
    Force,
    /// Hidden effects, diagnosed.
    Diagnosis,
}

fn cases(text: &str) -> Result<usize, String> {
    text.parse().ok().filter(|n| (1..=100_000).contains(n)).ok_or_else(|| "a whole number, from 1 to 100000".into())
}

fn size(text: &str) -> Result<f64, String> {
    text.parse().ok().filter(|s| (0.5..=1000.0).contains(s)).ok_or_else(|| "a number from 0.5 to 1000".into())
}

fn residuals(text: &str) -> Result<f64, String> {
    text.parse().ok().filter(|s| (0.05..=100.0).contains(s)).ok_or_else(|| "a number from 0.05 to 100".into())
}

fn longest(text: &str) -> Result<usize, String> {
    text.parse().ok().filter(|s| (2..=60).contains(s)).ok_or_else(|| "whole seconds, from 2 to 60".into())
}

/// Largest number of runs; more add no information.
const MOST_RUNS: usize = 100_000;

impl Reproduce {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        if self.runs > MOST_RUNS {
            return Err(Failure::input(format!("--runs {}: at most {MOST_RUNS}", self.runs)));
        }
        self.refuse_idle(&provenance)?;
        files::check_outputs(&[("--json", &self.json), ("--report", &self.report)], [])?;
        let provenance = provenance.with("robot", "robots/kuka-lwr4.yaml, built in");
        let asked = |part: Part| self.part.is_none_or(|p| p == part);
        let mut parts = Parts::default();
        if asked(Part::Excitation) {
            let settings =
                ExcitationSettings { seed: self.seed, longest: self.longest, ..ExcitationSettings::default() };
            parts.excitation = Some(watched("excitation", |watch| paper::excitation(&settings, watch))?);
        }
        if asked(Part::Identification) {
            let settings = IdentificationSettings { runs: self.runs, seed: self.seed };
            parts.identification = Some(watched("identification", |watch| paper::identification(&settings, watch))?);
        }
        if asked(Part::Painting) {
            let settings = PaintingSettings { seed: self.seed, quick: self.quick };
            parts.painting = Some(watched("painting", |watch| paper::painting(&settings, watch))?);
        }
        if asked(Part::Force) {
            let settings = ForceSettings { runs: self.runs, seed: self.seed, ..ForceSettings::default() };
            parts.force = Some(watched("force", |watch| paper::force(&settings, watch))?);
        }
        if self.on_real {
            parts.on_real = Some(self.on_real()?);
        } else if asked(Part::Diagnosis) {
            let settings = DiagnosisSettings {
                cases: self.cases.unwrap_or(DiagnosisSettings::default().cases),
                from: self.from,
                size: self.size,
                clean: self.clean,
                ..DiagnosisSettings::default()
            };
            parts.diagnosis = Some(watched("diagnosis", |watch| paper::diagnosis::battery(&settings, watch))?);
        }
        deliver(&provenance)
            .file(self.report.as_ref(), || report::reproduce_html(&parts, &provenance.rows()))?
            .json(self.json.as_ref(), || report::reproduce_json(&parts))?
            .text(|| report::reproduce_text(&parts))
    }
}

impl Reproduce {
    /// Refuses options that would have no effect.
    fn refuse_idle(&self, provenance: &Provenance) -> Result<(), Failure> {
        if self.on_real && self.part != Some(Part::Diagnosis) {
            return Err(Failure::input(
                "--on-real belongs to `denavit reproduce diagnosis`; write `diagnosis` before it",
            ));
        }
        let runs = |parts: &[Part]| self.part.is_none_or(|part| parts.contains(&part));
        let hides = runs(&[Part::Diagnosis]) && !self.on_real;
        let seeded = self.on_real || self.part != Some(Part::Diagnosis);
        provenance.refuse_idle(&[
            ("--runs", runs(&[Part::Identification, Part::Force]), "it belongs to `identification` and `force`"),
            ("--longest", runs(&[Part::Excitation]), "it belongs to `excitation`"),
            ("--cases", runs(&[Part::Diagnosis]), "it belongs to `diagnosis`"),
            ("--from", hides, "it belongs to `diagnosis` without --on-real"),
            ("--size", hides, "it belongs to `diagnosis` without --on-real"),
            ("--clean", hides, "it belongs to `diagnosis` without --on-real"),
            ("--quick", runs(&[Part::Painting]), "it belongs to `painting`"),
            ("--seed", seeded, "the seeds of `diagnosis` begin with --from"),
        ])
    }

    fn on_real(&self) -> Result<RealBattery, Failure> {
        let settings = RealSettings {
            cases: self.cases.unwrap_or(RealSettings::default().cases),
            seed: self.seed,
            sizes: self.sizes.clone(),
            recoverable: self.recoverable,
            ..RealSettings::default()
        };
        let recorded = self.recorded()?;
        watched("diagnosis", |watch| real::on_real(&settings, &recorded, watch))
    }

    /// Reads the recordings for --on-real.
    fn recorded(&self) -> Result<Vec<Recorded>, Failure> {
        let folders: Vec<&str> = ARMS.iter().map(|a| a.folder).collect();
        if let Some(unknown) = self.arms.iter().find(|a| !folders.contains(&a.as_str())) {
            return Err(Failure::input(format!("--arms {unknown}: no such arm; there are {}", folders.join(", "))));
        }
        let wanted = |arm: &&ArmData| self.arms.is_empty() || self.arms.iter().any(|a| a == arm.folder);
        let missing = |path: PathBuf, what: &str| {
            Failure::input(format!(
                "{what} {} is missing; --data names the folder of the recordings, which come from public repositories (data/README.md names the sources) with one folder per arm: {}; --arms chooses among them",
                path.display(),
                folders.join(", ")
            ))
        };
        let Some(data) = &self.data else {
            return Err(Failure::input(format!(
                "--on-real needs --data DIR, the folder of the recordings, which come from public repositories (data/README.md names the sources) with one folder per arm: {}; --arms chooses among them",
                folders.join(", ")
            )));
        };
        if !data.is_dir() {
            return Err(missing(data.clone(), "folder"));
        }
        ARMS.iter()
            .filter(wanted)
            .map(|arm| {
                let place = data.join(arm.folder);
                if !place.is_dir() {
                    return Err(missing(place, "folder"));
                }
                let read = |names: &[&str]| -> Result<Vec<Vec<u8>>, Failure> {
                    let bytes = |name: &&str| {
                        std::fs::read(place.join(name)).map_err(|_| missing(place.join(name), "recording"))
                    };
                    names.iter().map(bytes).collect()
                };
                Ok(Recorded { arm: *arm, fit: read(arm.fit)?, validate: read(arm.validate)? })
            })
            .collect()
    }
}

/// Runs a part with a progress bar.
fn watched<T>(part: &str, run: impl FnOnce(paper::Watch<'_>) -> Result<T, ReproduceError>) -> Result<T, Failure> {
    let bar = ProgressBar::new(1000);
    if let Ok(style) = ProgressStyle::with_template(&format!("{part} [{{bar:30}}] {{percent}}% {{msg}}")) {
        bar.set_style(style);
    }
    let found = run(&|what, share| {
        bar.set_position((1000.0 * share) as u64);
        bar.set_message(what.to_string());
    });
    bar.finish_and_clear();
    found.map_err(Failure::other)
}
