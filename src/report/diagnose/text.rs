//! A diagnosis as text.

use std::fmt::Write;

use crate::data::signal::Prepared;
use crate::diagnose::{Cause, Diagnosis, Errors, PositionBand, Verdict};
use crate::report::Warnings;
use crate::report::diagnose::calibrate::most_improved_joint;
use crate::report::diagnose::doubts::doubts;
use crate::report::parts::budget;
use crate::report::parts::number::{digits, pad};

/// Ratio of a model's joint error to the file's above which it is worse: logs differ by a tenth.
const WORSE: f64 = 1.1;

/// Warnings that precede the figures, the same in text, JSON and page.
pub fn diagnose_warnings(found: &Diagnosis, logs: &[Prepared]) -> Warnings {
    let mut warnings = Warnings::default();
    let joints: Vec<String> = (0..found.noise_floor.len())
        .filter(|&j| found.extended.moving[j] > WORSE * found.baseline.moving[j])
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
    if found.transmission {
        warnings.push(
            "Torques are what the gears take: the motors' less the joints', both measured. Links play no part in them.",
        );
    }
    if !found.transmission && !logs.is_empty() && logs.iter().all(|log| log.both_torques) {
        warnings.push("The logs have torques of motors and joints: --transmission diagnoses the gears by their difference, free of links.");
    }
    if let Some(PositionBand { cutoff, removes }) = found.band {
        warnings.push(format!(
            "The torques follow the motion up to some {cutoff:.1} Hz only. With the positions low-passed there, refitted models leave {:.0} % less squared error (geometric mean over joints) than with the band that suits the encoders, so all figures are of that low-pass. --cutoff sets another.",
            100.0 * removes
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
    let (offered, suspected): (Vec<&Cause>, Vec<&Cause>) = named.iter().partition(|c| c.in_extended);
    let list = |causes: &[&Cause]| {
        let each: Vec<String> =
            causes.iter().take(4).map(|c| format!("{} {}", c.cause.replace('_', " "), place(c))).collect();
        let more = causes.len().saturating_sub(4);
        if more > 0 { format!("{}, and {more} more", each.join(", ")) } else { each.join(", ") }
    };
    let first = match (found.verdict, named.is_empty()) {
        _ if found.file_holds => {
            "The unchanged file predicts the validating logs better than the model for which the fitted logs ask.".to_string()
        }
        (Verdict::NothingWrong, _) if found.has_links => "Nothing is wrong beyond the noise.".to_string(),
        (Verdict::NothingWrong, _) => {
            "The file has no link parameters; with base parameters fitted to the logs nothing is wrong beyond the noise.".to_string()
        }
        (Verdict::Unexplained, true) if found.causes.is_empty() && found.transmission => {
            "Rotors or friction of the file are wrong: refitted, they leave nothing beyond the noise. Which of them can't be told from these logs."
                .to_string()
        }
        (Verdict::Unexplained, true) if found.causes.is_empty() && found.links_refitted => {
            "Links or rotors of the file are wrong: with base parameters fitted to the logs nothing is left beyond the noise. Which of them can't be told from these logs."
                .to_string()
        }
        (Verdict::Explained, _) => format!("The error is explained by {}.", list(&offered)),
        (Verdict::PartlyExplained, false) => {
            format!("Part of the error is explained by {}; structure without a name is left.", list(&offered))
        }
        (_, false) => format!(
            "There is structure in the error, and no model with a known cause predicts it surely better. Suspected: {}.",
            list(&named)
        ),
        _ => "There is structure in the error that none of the known causes explains.".to_string(),
    };
    let first = match found.verdict {
        Verdict::Explained | Verdict::PartlyExplained if !suspected.is_empty() => {
            format!("{first} Suspected beside it: {}.", list(&suspected))
        }
        _ => first,
    };
    let first = format!("{first}{}", by_formula(found));
    let first = match (found.has_links, found.verdict) {
        (false, Verdict::Explained | Verdict::PartlyExplained | Verdict::Unexplained) => {
            format!("{first} The file has no link parameters, so it does not predict the arm's own torque.")
        }
        _ => first,
    };
    let first = format!("{first}{}", changed_between_logs(found));
    let data =
        if found.own_validation { "logs that were not used" } else { "the last part of the logs, which was not used," };
    format!("{first} {}", headline(found, data))
}

/// Sentences on laws in closed form in the extended model.
fn by_formula(found: &Diagnosis) -> String {
    let sentence = |c: &Cause| {
        let (joint, law) = (*c.joints.first()?, c.law.as_ref().filter(|_| c.has_law())?);
        let [before, after] = [&c.rms_before, &c.rms_after].map(|rms| rms.get(joint - 1).copied().unwrap_or(0.0));
        let share = digits(100.0 * (1.0 - (after / before).powi(2)), 2);
        Some(format!(" On joint {joint} a formula takes {share} % of the squared error: {law}."))
    };
    found.causes.iter().filter_map(sentence).collect()
}

/// The joint with the largest improvement, and its errors. If samples at rest or about reversals
/// contribute much, also its errors where it moves.
fn headline(found: &Diagnosis, data: &str) -> String {
    let Some(j) = most_improved_joint(found) else { return String::new() };
    let beyond_noise = |k: usize| found.baseline.moving[k] > WITHIN_NOISE * found.noise_floor[k];
    if !(0..found.noise_floor.len()).any(beyond_noise) {
        return format!(
            "On {data} the file misses no joint by more than noise explains (joint {}: {} N m, noise {} N m).",
            j + 1,
            digits(found.baseline.moving[j], 3),
            digits(found.noise_floor[j], 3)
        );
    }
    let of =
        |rms: &dyn Fn(&Errors) -> f64| [&found.baseline, &found.refitted, &found.extended].map(|e| digits(rms(e), 3));
    let [file, refitted, extended] = of(&|e| e.validate[j]);
    let improves = found.extended.validate[j] < IMPROVES * found.baseline.validate[j];
    let which = match improves {
        true => format!("joint {} improves most", j + 1),
        false => format!("no joint improves, not even joint {}", j + 1),
    };
    let all = format!(
        "On {data} {which}: the file misses its torque by {file} N m, the file refitted by {refitted} N m, the extended model by {extended} N m; noise explains {} N m.",
        digits(found.noise_floor[j], 3)
    );
    if found.extended.validate[j] < AT_REST * found.extended.moving[j] {
        return all;
    }
    let [file, refitted, extended] = of(&|e| e.moving[j]);
    format!(
        "{all} Where it moves they miss {file}, {refitted} and {extended} N m; at rest and about reversals dry friction is not a function of the motion."
    )
}

/// Ratio of error to noise up to which an error is within the noise: both are estimates.
const WITHIN_NOISE: f64 = 1.1;

/// Ratio of the errors of the extended model and of the file below which a joint improves.
const IMPROVES: f64 = 0.99;

/// Ratio of the error over all samples to that where the joint moves, above which both are stated.
const AT_REST: f64 = 1.3;

/// A sentence on joints that no single model predicts on fitted and validating logs; empty without
/// any.
fn changed_between_logs(found: &Diagnosis) -> String {
    let joints: Vec<String> = found.changed.iter().map(usize::to_string).collect();
    if joints.is_empty() {
        return String::new();
    }
    let causes: Vec<String> =
        found.changes.iter().take(3).map(|c| format!("{} {}", c.cause.replace('_', " "), place(c))).collect();
    let by_itself = if causes.is_empty() {
        String::new()
    } else {
        let which = if found.file_holds { "fitted" } else { "validating" };
        format!("; the {which} logs alone show {}", causes.join(", "))
    };
    format!(
        " Something changed between the logs: no one model predicts joint{} {} on the fitted and the validating logs{by_itself}.",
        if joints.len() > 1 { "s" } else { "" },
        joints.join(", ")
    )
}

pub(super) fn place(c: &Cause) -> String {
    match c.joints.as_slice() {
        [] => "(whole robot)".into(),
        [j] => format!("on joint {j}"),
        many => format!("on joints {}", many.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")),
    }
}

/// How a robot file contains a law that was found; `None` if the cause has no law.
pub(super) fn for_the_file(c: &Cause) -> Option<String> {
    let (Some(law), [joint]) = (&c.law, &c.joints[..]) else { return None };
    Some(match c.in_extended {
        true => {
            format!("The extended model has it: `law` beside the drive of joint {joint} in the file that --out writes.")
        }
        false => format!(
            "To use it, write beside the drive of joint {joint} in the robot file: law: \"{law}\", unit: N m (N where it slides)"
        ),
    })
}

/// Width of a column of the table of errors, characters.
const COLUMN: usize = 11;

/// The result for the terminal.
pub fn diagnose_text(found: &Diagnosis, warnings: &Warnings) -> String {
    let mut text = warnings.text();
    let _ = writeln!(text, "{}: {}", found.robot, found.verdict.word().replace('_', " "));
    let _ = writeln!(text, "{}\n", diagnose_verdict(found));
    let heads = ["joint", "torque", "file", "refitted", "extended", "moving", "noise", "ext/torque"];
    let _ = writeln!(
        text,
        "RMS on validation, N m (moving: of the extended model where the joint moves; ext/torque: its error by the torque)"
    );
    let _ = writeln!(text, "{}", heads.iter().map(|h| pad(h, COLUMN, true)).collect::<String>());
    for j in 0..found.noise_floor.len() {
        let row = [
            found.torque_rms[j],
            found.baseline.validate[j],
            found.refitted.validate[j],
            found.extended.validate[j],
            found.extended.moving[j],
            found.noise_floor[j],
        ];
        let _ = write!(text, "{}", pad(&(j + 1).to_string(), COLUMN, true));
        row.iter().for_each(|x| text.push_str(&pad(&digits(*x, 3), COLUMN, true)));
        let _ = writeln!(text, "{}", pad(&format!("{} %", digits(100.0 * row[3] / row[0], 2)), COLUMN, true));
    }
    text.push_str(&budget::text(&found.budget, "the error of the extended model where joints move"));
    if !found.offer.why.is_empty() {
        let _ = writeln!(text, "\n{}", found.offer.why.join("\n"));
    }
    for (number, c) in found.causes.iter().enumerate() {
        let _ = writeln!(text, "\n{}. {} {} (probability {:.2})", number + 1, c.cause, place(c), c.probability);
        let _ = writeln!(text, "   {}", c.evidence);
        if let Some(sentence) = for_the_file(c) {
            let _ = writeln!(text, "   {sentence}");
        }
        let against = doubts(c);
        if !against.is_empty() {
            let _ = writeln!(text, "   Against it: {}.", against.join("; "));
        }
        if !c.not_distinguished_from.is_empty() {
            let _ = writeln!(
                text,
                "   This data does not separate it from {}; {} would.",
                c.not_distinguished_from.join(", "),
                c.decided_by.unwrap_or(c.shown_by)
            );
        }
    }
    text
}
