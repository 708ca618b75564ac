//! The carried body as text for the terminal.

use std::fmt::Write;

use crate::data::signal::Prepared;
use crate::identify::tool::{Carried, Found, Relative, RobotErrors, names};
use crate::identify::{Standing, Underdetermined};
use crate::report::Warnings;
use crate::report::identify::text::logs_text;
use crate::report::parts::number::{digits, figure, pad, percent};

/// Whether the mass exceeds what noise gives with an empty hand: three standard deviations, below
/// which 399 of 400 logs are.
fn seen(carried: &Carried) -> bool {
    carried.known_mass.is_some() || carried.values[0] > 3.0 * carried.std[0]
}

/// Whether the logs determine all ten parameters, and the hand is empty.
pub(super) fn empty_hand(carried: &Carried) -> bool {
    !seen(carried) && !carried.standing.contains(&Standing::NotIdentifiable)
}

/// The result in a few sentences.
pub fn tool_verdict(found: &Found) -> String {
    let carried = &found.carried;
    let mut text = String::new();
    match carried.body.as_ref().filter(|_| seen(carried)) {
        Some(body) => {
            let [x, y, z] = body.center.map(|c| digits(1e3 * c, 3));
            let worst = body.center_std.iter().fold(0.0_f64, |m, s| m.max(*s));
            let std = if carried.known_mass.is_some() && carried.mass_std == 0.0 {
                "as given".into()
            } else {
                format!("± {}", digits(carried.std[0], 2))
            };
            let _ = write!(
                text,
                "The arm carries {} kg ({std}), with its centre at ({x}, {y}, {z}) mm in the last frame (± {} mm). ",
                figure(body.mass),
                digits(1e3 * worst, 2)
            );
            if let Some(defect) = &body.impossible {
                let _ = write!(text, "No body has exactly these ten parameters ({defect}): noise, or a wrong log. ");
            }
        }
        None => {
            let open: Vec<String> = names()
                .into_iter()
                .zip(carried.standing)
                .filter(|(_, s)| *s == Standing::NotIdentifiable)
                .map(|(n, _)| n)
                .collect();
            if open.is_empty() && carried.values[0] < -3.0 * carried.std[0] {
                let _ = write!(
                    text,
                    "The mass comes out as {} kg (± {}), surely below zero: something was taken off the arm. Are the logs of --unloaded and --loaded exchanged, or is \
                     something on the arm that the robot file's parameters have in them? ",
                    figure(carried.values[0]),
                    digits(carried.std[0], 2)
                );
            } else if open.is_empty() {
                let _ = write!(
                    text,
                    "The mass comes out as {} kg (± {}): there is nothing in the hand, or less than the noise lets see. ",
                    figure(carried.values[0]),
                    digits(carried.std[0], 2)
                );
            } else {
                let _ = write!(text, "Not all of the ten parameters are determined: {} are open. ", open.join(", "));
            }
        }
    }
    if let (Some(given), Some([mass, std])) = (carried.known_mass, carried.mass_of_logs)
        && (given - mass).abs() > 4.0 * std.hypot(carried.mass_std)
    {
        let _ = write!(
            text,
            "The scale's {} kg contradict the logs, which say {} ± {} kg: look whether it is in kg, and of what hangs on the arm beyond the unloaded log. ",
            figure(given),
            figure(mass),
            digits(std, 2)
        );
    }
    // For an empty hand there is nothing to recognise.
    if let Some(r) = found.recognition.as_ref().filter(|r| !(r.rejected && empty_hand(carried))) {
        let (nearest, tools) = (r.nearest(), r.candidates.len());
        let (near, limit) = (digits(nearest.distance, 3), digits(r.limit, 3));
        if r.rejected {
            let _ = write!(
                text,
                "It is none of the {tools} tools of the table: nearest is {} at a distance of {near}, where the right tool would be within {limit}. ",
                nearest.name
            );
        } else {
            let _ = write!(text, "It is {} (distance {near}, limit {limit}). ", nearest.name);
            if !r.not_distinguished_from.is_empty() {
                let others = r.not_distinguished_from.join(", ");
                let _ = write!(text, "This data does not separate it from {others}; a livelier motion would. ");
            }
        }
        match &found.relative {
            Some(size) if size.fits && (r.rejected || size.family_of(&nearest.name)) => {
                let _ = write!(text, "{}", size_sentence(size, r.rejected));
            }
            Some(size) if r.rejected => {
                let _ = write!(text, "It is not a {} of another size either ({}). ", size.family, misfit(size));
            }
            _ => {}
        }
    }
    let weak = weak_logs(found);
    if !weak.is_empty() {
        let _ = write!(text, "{weak} ");
    }
    text.trim_end().to_string()
}

/// Reason why a tool is no member of a family of tools.
pub(in crate::report) fn misfit(size: &Relative) -> String {
    let distance = digits(size.distance, 3);
    match size.distance > size.limit {
        true => format!("distance {distance}, limit {}", digits(size.limit, 3)),
        false => format!(
            "the nearest, at a distance of {distance}, would have a length of {:.0} mm and a width of {:.0} mm, far outside of the sizes in the table",
            1e3 * size.length.value,
            1e3 * size.width.value
        ),
    }
}

fn size_sentence(size: &Relative, unknown: bool) -> String {
    let mm = |i: &crate::identify::tool::Interval| {
        format!("{:.0} mm ({:.0} to {:.0})", 1e3 * i.value, 1e3 * i.ends[0], 1e3 * i.ends[1])
    };
    let what = if unknown { "It can be" } else { "Interpolated as" };
    let outside = if size.extrapolated { ", outside of the sizes in the table: take this with care" } else { "" };
    format!(
        "{what} a {} of length {} and width {}{outside} (interpolated between {} of the table, 95 %). ",
        size.family,
        mm(&size.length),
        mm(&size.width),
        size.members
    )
}

/// A sentence on logs with a large residual although the tool is included in the model.
fn weak_logs(found: &Found) -> String {
    let weak: Vec<String> = found
        .carried
        .logs
        .iter()
        .filter(|log| log.with_tool.relative_error_percent() > 20.0)
        .map(|log| format!("{} by {} %", log.name, percent(log.with_tool.relative_error_percent())))
        .collect();
    match weak.is_empty() {
        true => String::new(),
        false => format!(
            "The model misses {}: do not trust the result before that is understood (identify the robot, or give an unloaded log).",
            weak.join(", ")
        ),
    }
}

/// Warnings that precede the figures.
pub fn tool_warnings(found: &Found, logs: &[Prepared]) -> Warnings {
    let mut warnings = Warnings::default();
    let solved = &found.carried.solved;
    if let Some(Underdetermined::Equations { samples, independent, unknowns }) = solved.underdetermined() {
        warnings.push(format!(
            "underdetermined: {samples} samples (over all joints) hold about {independent:.0} independent equations for {unknowns} unknowns, so the fit follows the \
             noise. No value here is a measurement. Record a longer motion"
        ));
    }
    if found.carried.robot_errors == RobotErrors::NotCounted {
        warnings.push(
            "the robot file's parameters are taken as exact: the standard deviations do not hold their errors, so that single parameters can be off by several \
             deviations. Give the JSON that `denavit identify` wrote of this robot (--identified), or a log with an empty hand (--unloaded)",
        );
    }
    warnings.findings(&solved.findings);
    warnings.logs(logs);
    warnings
}

/// The complete result.
pub fn tool_text(found: &Found, logs: &[Prepared], warnings: &Warnings) -> String {
    let carried = &found.carried;
    let mut out = format!("{}\n\n{}\n{}", carried.robot, tool_verdict(found), warnings.text());
    out.push_str(&logs_text(logs));
    let table = found.recognition.as_ref().map(|r| &found.table[r.nearest().entry]);
    out.push_str("\nIn the last frame, about its origin\n");
    let mut head = vec!["", "value", "±", "%"];
    if let Some(entry) = table {
        head.extend([entry.name.as_str(), "off by σ"]);
    }
    let mut rows: Vec<Vec<String>> = vec![head.into_iter().map(String::from).collect()];
    let relative = carried.relative_std_percent();
    for (k, name) in names().iter().enumerate() {
        let known = carried.standing[k] == Standing::Identified;
        let mut row = vec![name.clone(), figure(carried.values[k])];
        row.extend(if known { [figure(carried.std[k]), percent(relative[k])] } else { ["open".into(), "–".into()] });
        if let (Some(entry), Some(r)) = (table, &found.recognition) {
            row.extend([figure(entry.values[k]), digits(r.nearest().deviations[k], 2)]);
        }
        rows.push(row);
    }
    out.push_str(&columns(&rows));
    if let Some(body) = &carried.body {
        let list = |v: &[f64]| v.iter().map(|x| figure(*x)).collect::<Vec<_>>().join(", ");
        let _ = writeln!(out, "\nCentre of mass, m: {} ± {}", list(&body.center), list(&body.center_std));
        let _ = writeln!(out, "Tensor there, kg m^2 (XX YY ZZ XY XZ YZ): {}", list(&body.tensor));
        let _ = writeln!(out, "Principal moments, kg m^2: {}", list(&body.principal_moments));
        let axes: Vec<String> = body.principal_axes.iter().map(|a| format!("({})", list(a))).collect();
        let _ = writeln!(out, "Principal axes: {}", axes.join(" "));
    }
    if let Some(frame) = &found.in_tool_frame {
        let _ = writeln!(out, "\nIn the tool frame of {}", frame.tool);
        let mut rows = Vec::new();
        for (k, name) in names().iter().enumerate() {
            rows.push(vec![name.clone(), figure(frame.values[k]), format!("± {}", figure(frame.std[k]))]);
        }
        out.push_str(&columns(&rows));
    }
    if let Some(r) = &found.recognition {
        let _ = writeln!(
            out,
            "\nThe nearest of {} tools (limit {}; {} components hold {} % of the table)",
            r.candidates.len(),
            figure(r.limit),
            r.pca.components(),
            digits(100.0 * r.pca.explained[r.pca.components() - 1], 6)
        );
        let mut rows =
            vec![["", "distance", "in the space", "plain (paper)", "probability"].map(String::from).to_vec()];
        for c in r.candidates.iter().take(6) {
            rows.push(vec![
                c.name.clone(),
                figure(c.distance),
                figure(c.distance_in_space),
                figure(c.plain_distance),
                digits(c.probability, 3),
            ]);
        }
        out.push_str(&columns(&rows));
        if r.by_plain_distance != r.nearest().name {
            let _ = writeln!(out, "By the paper's plain distance it would be {}.", r.by_plain_distance);
        }
    }
    out.push_str("\nTorque error, RMS, N m, joint by joint\n");
    let mut rows = Vec::new();
    for log in &carried.logs {
        let list = |v: &[f64]| v.iter().map(|x| digits(*x, 3)).collect::<Vec<_>>();
        rows.push([vec![log.name.clone()], list(&log.with_tool.rms)].concat());
        if log.loaded {
            rows.push([vec!["  without the tool".into()], list(&log.robot_alone.rms)].concat());
        }
    }
    out.push_str(&columns(&rows));
    out
}

/// A table with columns as wide as their widest cell, numbers right-aligned.
fn columns(rows: &[Vec<String>]) -> String {
    let count = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |c: usize| rows.iter().filter_map(|r| r.get(c)).map(|s| s.chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..count).map(width).collect();
    rows.iter().fold(String::new(), |mut out, row| {
        let cells: Vec<String> = row.iter().enumerate().map(|(c, cell)| pad(cell, widths[c], c > 0)).collect();
        let _ = writeln!(out, "  {}", cells.join("  ").trim_end());
        out
    })
}
