//! The wrench on the tool as text.

use std::fmt::Write;

use crate::control::estimate::{COMPONENTS, Comparison, Consistency, NoiseSource, Series, Uncertainty, Verdict};
use crate::data::signal::Prepared;
use crate::report::Warnings;
use crate::report::parts::number::{digits, pad};

/// Estimated wrenches, and the uncertainty of the model.
pub struct Forces<'a> {
    /// The robot's name.
    pub robot: &'a str,
    /// Estimated wrench of each log.
    pub found: &'a [Series],
    /// Uncertainty from which the bands are computed.
    pub uncertainty: &'a Uncertainty,
    /// Source of the uncertainty, in words.
    pub known_from: &'a str,
}

impl Forces<'_> {
    /// Whether the noise was estimated from the samples that it would judge.
    pub(in crate::report) fn circular(&self) -> bool {
        self.uncertainty.source == NoiseSource::Free
    }

    /// Verdict of the log with the worst one.
    pub(in crate::report) fn verdict(&self) -> Option<&Verdict> {
        Verdict::worst(self.found.iter().map(|s| &s.verdict))
    }
}

/// Warnings that precede the figures, the same in text, JSON and page.
pub(in crate::report) fn warnings(outcome: &Forces<'_>, prepared: &[Prepared]) -> Warnings {
    let mut warnings = Warnings::default();
    for series in outcome.found.iter().filter(|s| s.verdict.is_too_wrong() || s.verdict.is_doubtful()) {
        warnings.push(format!("{}: {}", series.name, verdict(&series.verdict)));
    }
    if outcome.uncertainty.source == NoiseSource::Log {
        warnings.push("The bands are of the torque's own noise alone; the model's errors are in no band. Give --identified, or --free stretches.");
    }
    if !outcome.uncertainty.open.is_empty() {
        warnings.push(format!(
            "The errors of {} are in no band, as the identification does not determine them.",
            outcome.uncertainty.open.join(", ")
        ));
    }
    let assumed = |s: &&Series| s.undecided.contains(&true) && !s.assumed_friction.is_empty();
    for series in outcome.found.iter().filter(assumed) {
        let joints: Vec<String> =
            series.assumed_friction.iter().map(|(j, level)| format!("{j} ({} N m)", digits(*level, 2))).collect();
        warnings.push(format!(
            "{}: the robot file has no dry friction for joint{} {}. There static friction may hold as much as 5 % of the torque limit before a contact is said; it is in no band. Identify the friction.",
            series.name,
            if joints.len() > 1 { "s" } else { "" },
            joints.join(", ")
        ));
    }
    warnings.logs(prepared);
    warnings
}

/// A table per log.
pub fn force_text(outcome: &Forces<'_>, prepared: &[Prepared]) -> String {
    let mut text = format!("{}: wrench of the surroundings on the tool, in its frame\n", outcome.robot);
    let _ = writeln!(text, "bands from {}", outcome.known_from);
    text.push_str(&warnings(outcome, prepared).text());
    for series in outcome.found {
        let _ = writeln!(
            text,
            "\n{}, estimator {}: {} samples{}",
            series.name,
            series.method.name(),
            series.time.len(),
            if series.bias.is_empty() { "" } else { ", bias taken off" }
        );
        for sentence in sentences(series, outcome.circular()) {
            let _ = writeln!(text, "{sentence}");
        }
        for (title, rows) in tables(series) {
            let _ = writeln!(text, "{title}");
            text.push_str(&table(&rows));
        }
    }
    text
}

/// Available comparisons: against the sensor, against zero, or else the estimate itself.
pub(in crate::report) fn tables(series: &Series) -> Vec<(String, [Comparison; 6])> {
    let mut all = Vec::new();
    if let Some(rows) = series.against_measured() {
        all.push(("estimated less measured".to_string(), rows));
    }
    if let Some(rows) = series.phantom() {
        all.push(("phantom force: what the estimate says where nothing touches".into(), rows));
    }
    if all.is_empty() {
        let range = |i: usize| {
            let values =
                (0..series.time.len()).map(|s| (series.wrench[s][i], series.half[s][i], series.observable[s][i]));
            Comparison { inside: f64::NAN, ..Comparison::of(values) }
        };
        all.push(("estimate".into(), std::array::from_fn(range)));
    }
    all
}

pub(in crate::report) const HEAD: [&str; 7] = ["", "RMS", "mean", "largest", "band +-", "inside %", "observable %"];

/// Table cells of one component.
pub(in crate::report) fn cells(i: usize, c: &Comparison) -> [String; 7] {
    let unit = if i < 3 { "N" } else { "N m" };
    let none = || "–".to_string();
    let number = |x: f64| if c.samples == 0 { none() } else { digits(x, 3) };
    let share = if c.inside.is_nan() || c.samples == 0 { none() } else { format!("{:.1}", 100.0 * c.inside) };
    [
        format!("{} ({unit})", COMPONENTS[i]),
        number(c.rms),
        number(c.mean),
        number(c.largest),
        number(c.half),
        share,
        format!("{:.1}", 100.0 * c.observable),
    ]
}

fn table(rows: &[Comparison; 6]) -> String {
    let mut text = String::new();
    let head = HEAD.map(String::from);
    for row in std::iter::once(head).chain(rows.iter().enumerate().map(|(i, c)| cells(i, c))) {
        let line: String = row.iter().enumerate().map(|(k, c)| pad(c, if k == 0 { 12 } else { 13 }, k > 0)).collect();
        let _ = writeln!(text, "  {}", line.trim_end());
    }
    text
}

/// Verdict on the bands of a log, in one sentence.
pub(in crate::report) fn verdict(verdict: &Verdict) -> String {
    match verdict {
        Verdict::Hold { probability } => format!(
            "The bands can be relied upon: errors are as large as predicted (a model that is right gives errors as large with a probability of {}).",
            digits(*probability, 2)
        ),
        Verdict::Doubtful { probability, widen } => format!(
            "The bands are in doubt: errors are {} times what was predicted, and a model that is right gives errors as large with a probability of only {}. Take the bands that many times as wide, or judge them on another log.",
            digits(*widen, 2),
            digits(*probability, 2)
        ),
        Verdict::TooWrong { widen, joint } => {
            let joint = joint.map_or(String::new(), |(j, r)| format!(", most in joint {j} ({} times)", digits(r, 2)));
            format!(
                "The model is too wrong for the bands to hold{joint}. Take them {} times as wide; diagnose the model (`denavit diagnose`) or identify it again.",
                digits(*widen, 2)
            )
        }
        Verdict::Circular => {
            "Not judged: the noise was taken from the samples in which nothing touches, so they can't say whether the bands hold; give --identified.".into()
        }
        Verdict::NotJudged => {
            "Not judged: nothing says whether the bands hold; give stretches in which nothing touches (--free).".into()
        }
    }
}

/// Sentences on a log beside its figures: first the verdict, then its reasons.
pub(in crate::report) fn sentences(series: &Series, circular: bool) -> Vec<String> {
    let mut all = vec![verdict(&series.verdict)];
    let mut evidence = |what: &str, c: &Consistency| {
        all.push(format!(
            "{what} {} times what was predicted (probability {}).",
            digits(c.widen(), 2),
            digits(c.probability, 2)
        ));
    };
    if let Some(c) = series.in_free.as_ref().filter(|_| !circular) {
        evidence("Where nothing touches, errors are", c);
    }
    if let Some(c) = &series.unexplained {
        evidence("What no wrench on the tool explains is", c);
    }
    let touching = series.touching.iter().filter(|t| **t).count() as f64 / series.touching.len().max(1) as f64;
    if series.free.iter().any(|f| *f) {
        all.push(format!(
            "Contact is said in {:.1} % of the samples in which nothing touches.",
            100.0 * series.touch_share(true)
        ));
    }
    if series.free.iter().any(|f| !*f) {
        all.push(format!("Contact is said in {:.1} % of all samples.", 100.0 * touching));
    }
    let undecided = series.undecided.iter().filter(|t| **t).count();
    if undecided > 0 {
        all.push(format!(
            "In {:.1} % of the samples static friction or contact can't be told apart: joints are at rest, and friction within its breakaway level explains their torques.",
            100.0 * undecided as f64 / series.undecided.len().max(1) as f64
        ));
    }
    let blind = series.observable.iter().filter(|told| told.contains(&false)).count();
    if blind > 0 {
        all.push(format!(
            "In {:.1} % of the samples some component is unobservable (a singularity, or fewer than six joints); it is in no figure there, and its band is left empty.",
            100.0 * blind as f64 / series.observable.len().max(1) as f64
        ));
    }
    all
}
