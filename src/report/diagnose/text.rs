//! A diagnosis as a screenful of text.

use std::fmt::Write;

use crate::data::signal::Prepared;
use crate::diagnose::{Cause, Diagnosis, Verdict};
use crate::report::Warnings;
use crate::report::parts::budget;
use crate::report::parts::number::{digits, pad};

/// What to know before the figures, the same in text, JSON and page.
pub fn diagnose_warnings(found: &Diagnosis, logs: &[Prepared]) -> Warnings {
    let mut warnings = Warnings::default();
    let joints: Vec<String> = (0..found.noise_floor.len())
        .filter(|&j| found.extended.validate[j] > 1.05 * found.baseline.validate[j])
        .map(|j| (j + 1).to_string())
        .collect();
    if !joints.is_empty() {
        warnings.push(format!(
            "On joint{} {} the extended model is worse than the file: the fitted logs do not show {} well.",
            if joints.len() > 1 { "s" } else { "" },
            joints.join(", "),
            if joints.len() > 1 { "them" } else { "it" }
        ));
    }
    if !found.own_validation {
        warnings.push("No validating log was given: the last three tenths of each stretch were kept out of the fit and measured on.");
    }
    warnings.logs(logs);
    warnings
}

/// The diagnosis in two sentences.
pub fn diagnose_verdict(found: &Diagnosis) -> String {
    let named: Vec<&Cause> = found.causes.iter().filter(|c| c.cause != "unknown").collect();
    let mean = |x: &[f64]| (x.iter().map(|x| x * x).sum::<f64>() / x.len().max(1) as f64).sqrt();
    let list = |causes: &[&Cause]| {
        let each: Vec<String> =
            causes.iter().take(4).map(|c| format!("{} {}", c.cause.replace('_', " "), place(c))).collect();
        let more = causes.len().saturating_sub(4);
        if more > 0 { format!("{}, and {more} more", each.join(", ")) } else { each.join(", ") }
    };
    let first = match (found.verdict, named.is_empty()) {
        (Verdict::NothingWrong, _) if found.has_links => "Nothing is wrong beyond the noise.".to_string(),
        (Verdict::NothingWrong, _) => {
            "The file has no link parameters; with base parameters fitted to the logs nothing is wrong beyond the noise.".to_string()
        }
        (Verdict::Explained, _) => format!("The error is explained by {}.", list(&named)),
        (Verdict::PartlyExplained, false) => {
            format!("Part of the error is explained by {}; structure without a name is left.", list(&named))
        }
        _ => "There is structure in the error that none of the known causes explains.".to_string(),
    };
    let first = match (found.has_links, found.verdict) {
        (false, Verdict::Explained | Verdict::PartlyExplained | Verdict::Unexplained) => {
            format!("{first} The file has no link parameters, so as it is it says nothing of the arm's own torque.")
        }
        _ => first,
    };
    let (before, after) = (mean(&found.baseline.validate), mean(&found.extended.validate));
    let data =
        if found.own_validation { "logs that were not used" } else { "the last part of the logs, which was not used," };
    format!(
        "{first} On {data} the simulation of the file misses the torque by {} N m (RMS over joints) as it is, by {} N m with its parameters refitted, the extended model by {} N m; the noise is {} N m.",
        digits(before, 3),
        digits(mean(&found.refitted.validate), 3),
        digits(after, 3),
        digits(mean(&found.noise_floor), 3)
    )
}

fn place(c: &Cause) -> String {
    match c.joints.as_slice() {
        [] => "(whole robot)".into(),
        [j] => format!("on joint {j}"),
        many => format!("on joints {}", many.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")),
    }
}

/// The result for a terminal.
pub fn diagnose_text(found: &Diagnosis, warnings: &Warnings) -> String {
    let mut text = warnings.text();
    let _ = writeln!(text, "{}: {}", found.robot, found.verdict.word().replace('_', " "));
    let _ = writeln!(text, "{}\n", diagnose_verdict(found));
    let heads = ["joint", "torque", "file", "refitted", "extended", "noise", "of torque"];
    let _ = writeln!(text, "RMS on validation, N m");
    let _ = writeln!(text, "{}", heads.iter().map(|h| pad(h, 10, true)).collect::<String>());
    for j in 0..found.noise_floor.len() {
        let row = [
            found.torque_rms[j],
            found.baseline.validate[j],
            found.refitted.validate[j],
            found.extended.validate[j],
            found.noise_floor[j],
        ];
        let _ = write!(text, "{}", pad(&(j + 1).to_string(), 10, true));
        row.iter().for_each(|x| text.push_str(&pad(&digits(*x, 3), 10, true)));
        let _ = writeln!(text, "{}", pad(&format!("{} %", digits(100.0 * row[3] / row[0], 2)), 10, true));
    }
    text.push_str(&budget::text(&found.budget, "the error of the extended model"));
    if !found.offer.why.is_empty() {
        let _ = writeln!(text, "\n{}", found.offer.why.join("\n"));
    }
    for (number, c) in found.causes.iter().enumerate() {
        let _ = writeln!(text, "\n{}. {} {} (probability {:.2})", number + 1, c.cause, place(c), c.probability);
        let _ = writeln!(text, "   {}", c.evidence);
        if !c.not_distinguished_from.is_empty() {
            let _ = writeln!(
                text,
                "   This data does not tell it from {}; {} would.",
                c.not_distinguished_from.join(", "),
                c.shown_by
            );
        }
    }
    text
}
