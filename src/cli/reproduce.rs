//! `denavit reproduce`: the paper's experiments, each table and figure beside the paper's own
//! values.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressStyle};

use super::Failure;
use super::files;
use super::provenance::Provenance;
use crate::apps::paper::diagnosis::Settings as DiagnosisSettings;
use crate::apps::paper::{self, ExcitationSettings, ForceSettings, PaintingSettings, ReproduceError, Settings};
use crate::report::{self, Parts};

/// Run the paper's experiments on the simulated robot and print each table and figure beside the
/// paper's own values, with a verdict per row.
///
/// Needs no file: the KUKA LWR and its tools are built in, motions are designed and played on the
/// spot. A verdict compares what should be small: better (by more than 5 %), within (5 %), or short
/// by so many percent.
#[derive(Args)]
#[command(
    after_help = "Example:\n  denavit reproduce identification --report reproduce.html\nParts:\n  excitation       section III: Fig. 5, and the same task on other arms (some minutes)\n  identification   sections II.D, II.E, III.E, VI.A: Fig. 6, tables II and III, Fig. 10, and whether standard deviations are honest\n  force            section V.B: accuracy of the estimated wrench, coverage of its bands\n  painting         sections V, VI.B: Table IV, Figs. 12 and 13, and what the diagnosis makes of them (some minutes)\n  diagnosis        effects that a seed hides in the simulator, and what `denavit diagnose` makes of the logs (4 s a case)\nWithout a part: all of them."
)]
pub(super) struct Reproduce {
    /// Which part; default: all.
    #[arg(value_enum)]
    part: Option<Part>,
    /// Runs with other noise, to see whether standard deviations are honest; 0 for none.
    #[arg(long, value_name = "N", default_value_t = Settings::default().runs)]
    runs: usize,
    /// Longest motion of Fig. 5, s.
    #[arg(long, value_name = "S", default_value_t = ExcitationSettings::default().longest, value_parser = longest)]
    longest: usize,
    /// Cases of the diagnosis; they go round in 40 kinds.
    #[arg(long, value_name = "N", default_value_t = DiagnosisSettings::default().cases, value_parser = cases)]
    cases: usize,
    /// First seed of the diagnosis; each case has the next.
    #[arg(long, value_name = "SEED", default_value_t = DiagnosisSettings::default().from)]
    from: u64,
    /// Root mean square of a hidden effect by the noise of its joint.
    #[arg(long, value_name = "TIMES", default_value_t = DiagnosisSettings::default().size, value_parser = size)]
    size: f64,
    /// Hide nothing in the cases of the diagnosis: all that is named is a false alarm.
    #[arg(long)]
    clean: bool,
    /// Painting in a quarter of a minute instead of some: a hand's breadth of wall, one roller, no
    /// diagnosis; to see that it runs.
    #[arg(long)]
    quick: bool,
    /// Of motions and noise: the same seed gives the same figures.
    #[arg(long, value_name = "N", default_value_t = Settings::default().seed)]
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

fn longest(text: &str) -> Result<usize, String> {
    text.parse().ok().filter(|s| (2..=60).contains(s)).ok_or_else(|| "whole seconds, from 2 to 60".into())
}

/// More runs tell nothing more.
const MOST_RUNS: usize = 100_000;

impl Reproduce {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        if self.runs > MOST_RUNS {
            return Err(Failure::input(format!("--runs {}: at most {MOST_RUNS}", self.runs)));
        }
        let runs = |parts: &[Part]| self.part.is_none_or(|part| parts.contains(&part));
        provenance.refuse_idle(&[
            ("--runs", runs(&[Part::Identification, Part::Force]), "it belongs to `identification` and `force`"),
            ("--longest", runs(&[Part::Excitation]), "it belongs to `excitation`"),
            ("--cases", runs(&[Part::Diagnosis]), "it belongs to `diagnosis`"),
            ("--from", runs(&[Part::Diagnosis]), "it belongs to `diagnosis`"),
            ("--size", runs(&[Part::Diagnosis]), "it belongs to `diagnosis`"),
            ("--clean", runs(&[Part::Diagnosis]), "it belongs to `diagnosis`"),
            ("--quick", runs(&[Part::Painting]), "it belongs to `painting`"),
            ("--seed", self.part != Some(Part::Diagnosis), "the seeds of `diagnosis` begin with --from"),
        ])?;
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
            let settings = Settings { runs: self.runs, seed: self.seed };
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
        if asked(Part::Diagnosis) {
            let settings = DiagnosisSettings {
                cases: self.cases,
                from: self.from,
                size: self.size,
                clean: self.clean,
                ..DiagnosisSettings::default()
            };
            parts.diagnosis = Some(watched("diagnosis", |watch| paper::diagnosis::battery(&settings, watch))?);
        }
        if let Some(path) = &self.report {
            files::write(path, report::reproduce_html(&parts, &provenance.rows()).as_bytes())?;
        }
        if let Some(target) = &self.json {
            files::json(target, report::reproduce_json(&parts), &provenance)?;
        }
        if !files::is_stdout(&self.json) {
            files::print(&report::reproduce_text(&parts))?;
            if let Some(path) = &self.report {
                files::print(&format!("wrote {}\n", path.display()))?;
            }
        }
        Ok(())
    }
}

/// Runs a part behind a bar.
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
