//! The identification as tables for the terminal.

use std::fmt::Write;

use crate::data::log::Severity;
use crate::data::signal::Prepared;
use crate::identify::{Accuracy, Identification, Standing};
use crate::report::Warnings;
use crate::report::parts::budget;
use crate::report::parts::number::{digits, figure, pad, percent};

/// The result in two or three sentences.
pub fn identify_verdict(found: &Identification) -> String {
    if found.underdetermined().is_some() {
        return "Underdetermined: these logs do not determine the parameters.".into();
    }
    let (accuracy, on) = match &found.validation {
        Some(validation) => (validation, "validation"),
        None => (&found.fit, "the data it was fitted to (no validation log was given)"),
    };
    let live: Vec<usize> = (0..accuracy.rms.len()).filter(|&j| accuracy.rms[j].is_finite()).collect();
    let mean = live.iter().map(|&j| accuracy.rms[j]).sum::<f64>() / live.len().max(1) as f64;
    let mut text = format!(
        "On {on} the model misses the measured torque by {} N m (mean over joints of the RMS), {} % of it",
        digits(mean, 3),
        percent(accuracy.relative_error_percent())
    );
    let worst =
        live.iter().copied().max_by(|&a, &b| accuracy.percent_of_torque(a).total_cmp(&accuracy.percent_of_torque(b)));
    if let Some(worst) = worst.filter(|_| live.len() > 1) {
        let _ = write!(text, "; worst is joint {} with {} %", worst + 1, percent(accuracy.percent_of_torque(worst)));
    }
    text.push_str(". ");
    if let Some(validation) = &found.validation {
        let (here, there) = (found.fit.relative_error_percent(), validation.relative_error_percent());
        if there > 2.0 * here {
            let _ = write!(
                text,
                "On the data it was fitted to it misses only {} %: it does not carry over, so fit a richer motion, or fewer parameters. ",
                percent(here)
            );
        }
    }
    let before = if found.validation.is_some() { &found.validation_before } else { &found.fit_before };
    if let Some(before) = before {
        let _ = write!(text, "The unchanged robot file misses by {} %. ", percent(before.relative_error_percent()));
    }
    let known = found.parameters.iter().filter(|p| p.standing == Standing::Identified);
    let well = known.clone().filter(|p| p.relative_std_percent() < 10.0).count();
    let _ = write!(text, "{well} of {} parameters are known to better than 10 %", found.parameters.len());
    let open = found.parameters.iter().filter(|p| p.standing == Standing::NotIdentifiable).count();
    if open > 0 {
        let _ = write!(text, "; {open} are undetermined by this data");
    }
    if !found.dropped.is_empty() {
        let _ = write!(text, "; {} were left out as not essential", found.dropped.len());
    }
    text.push('.');
    if found.findings.iter().any(|f| f.severity == Severity::Warning) {
        text.push_str(" Look at the warnings first.");
    }
    text
}

/// Each log with its notes; warnings are printed elsewhere.
pub(in crate::report) fn logs_text(logs: &[Prepared]) -> String {
    let mut out = String::new();
    for log in logs {
        let _ = write!(
            out,
            "\n{}: {} samples in {} segment{} at {} Hz\n",
            log.file,
            log.samples,
            log.segments,
            if log.segments == 1 { "" } else { "s" },
            figure(log.rate)
        );
        for note in log.findings.iter().filter(|f| f.severity == Severity::Note) {
            let _ = writeln!(out, "  {note}");
        }
    }
    out
}

/// The whole result.
pub fn identify_text(found: &Identification, logs: &[Prepared], warnings: &Warnings) -> String {
    let mut out = format!("{}\n\n{}\n{}", found.robot, identify_verdict(found), warnings.text());
    out.push_str(&logs_text(logs));
    if found.underdetermined().is_some() {
        return out;
    }
    out.push_str("\nTorque error, RMS, N m (percent of the torque's RMS)\n");
    out.push_str(&torque_table(found));
    if let Some(budget) = &found.budget {
        out.push_str(&budget::text(budget, "the residual of the fit"));
    }
    out.push_str("\nParameters\n");
    out.push_str(&parameter_table(found));
    for group in &found.confused {
        let names = group.parameters.join(", ");
        let _ = match (group.parameters.len() == group.open, group.parameters.len()) {
            (true, 1) => writeln!(out, "\n{names} does not act in this data."),
            (true, _) => writeln!(out, "\n{names} do not act in this data."),
            _ => writeln!(out, "\n{names}: this data does not separate them ({} combinations are open).", group.open),
        };
    }
    if !found.dropped.is_empty() {
        out.push_str("\nLeft out, in this order\n");
        for d in &found.dropped {
            let _ = writeln!(
                out,
                "  {}  was {} ± {} %, F {} < {}, residual + {} %",
                pad(&d.name, 8, false),
                figure(d.value),
                percent(d.relative_std_percent),
                figure(d.f),
                figure(d.limit),
                percent(d.residual_growth_percent)
            );
        }
    }
    let c = found.condition;
    let _ = writeln!(
        out,
        "\nCondition number: {} as measured, {} weighted, {} with columns of unit norm.",
        figure(c.plain),
        figure(c.weighted),
        figure(c.scaled)
    );
    let effective: Vec<String> = found.noise.effective_samples.iter().map(|n| format!("{n:.0}")).collect();
    let _ = writeln!(
        out,
        "Standard deviations count {} samples as {} independent ones (joint by joint).",
        found.samples,
        effective.join(", ")
    );
    out
}

fn share(of_torque: f64) -> String {
    if of_torque.is_finite() { format!("({} %)", percent(of_torque)) } else { String::new() }
}

/// Torque errors, one row per joint.
fn torque_table(found: &Identification) -> String {
    let mut head = vec!["joint".to_string(), "torque".into(), "fit".into(), "".into()];
    let mut columns: Vec<&Accuracy> = vec![&found.fit];
    for (name, accuracy) in
        [("before", &found.fit_before), ("validate", &found.validation), ("before", &found.validation_before)]
    {
        if let Some(accuracy) = accuracy {
            head.extend([name.to_string(), String::new()]);
            columns.push(accuracy);
        }
    }
    head.push("NRMS %".into());
    let mut rows = vec![head];
    for joint in 0..found.fit.rms.len() {
        let mut row = vec![(joint + 1).to_string(), figure(found.fit.torque_rms[joint])];
        for accuracy in &columns {
            row.extend([figure(accuracy.rms[joint]), share(accuracy.percent_of_torque(joint))]);
        }
        let last = found.validation.as_ref().unwrap_or(&found.fit);
        row.push(percent(100.0 * last.nrms[joint]));
        rows.push(row);
    }
    table(&rows, 0)
}

fn parameter_table(found: &Identification) -> String {
    let mut rows = vec![["", "value", "±", "%", "before", "unit", "  grouping"].map(String::from).to_vec()];
    for p in &found.parameters {
        let (std, relative) = match p.standing {
            Standing::Identified => (figure(p.std), percent(p.relative_std_percent())),
            Standing::NotIdentifiable => ("open".into(), "–".into()),
            Standing::Dropped => ("left out".into(), "–".into()),
        };
        let grouping = if p.grouping.contains('=') { format!("  {}", p.grouping) } else { String::new() };
        let before = p.prior.map_or(String::new(), figure);
        rows.push(vec![p.name.clone(), figure(p.value), std, relative, before, p.unit.clone(), grouping]);
    }
    table(&rows, 5)
}

/// A table with columns as wide as their widest cell. Numbers are right-aligned; the first column
/// and those from `words` on (if not 0) are left-aligned.
fn table(rows: &[Vec<String>], words: usize) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |c: usize| rows.iter().filter_map(|r| r.get(c)).map(|s| s.chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut out = String::new();
    for row in rows {
        let cells: Vec<String> =
            row.iter().enumerate().map(|(c, cell)| pad(cell, widths[c], c > 0 && (words == 0 || c < words))).collect();
        let _ = writeln!(out, "  {}", cells.join("  ").trim_end());
    }
    out
}
