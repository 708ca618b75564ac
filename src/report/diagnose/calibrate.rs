//! Report of an identification followed by a diagnosis, as one result.

use std::fmt::Write;

use super::text::{for_the_file, place};
use crate::diagnose::{Cause, Diagnosis};
use crate::identify::Identification;
use crate::numerics::sums::root_mean_square;
use crate::report::Warnings;
use crate::report::parts::number::{digits, pad, percent};

/// The identification that produced the diagnosed robot file.
pub struct Identified<'a> {
    /// Identified parameters.
    pub found: &'a Identification,
    /// Warnings of the identification.
    pub warnings: &'a Warnings,
}

/// The joint, from 0, for which the extended model removes the largest share of the squared torque
/// where it moves. If no joint gains, the one with the largest error relative to its noise there.
/// `None` if no torque was measured.
pub(super) fn most_improved_joint(found: &Diagnosis) -> Option<usize> {
    let share = |errors: &[f64], j: usize| (errors[j] / found.torque_rms[j]).powi(2);
    let (before, after) = (&found.baseline.moving, &found.extended.moving);
    let gain = |j: usize| share(before, j) - share(after, j);
    let measured = || (0..found.torque_rms.len()).filter(|&j| gain(j).is_finite());
    let best = measured().max_by(|&a, &b| gain(a).total_cmp(&gain(b)))?;
    if gain(best) > 0.0 {
        return Some(best);
    }
    let beside_noise = |j: usize| before[j] / found.noise_floor.get(j).copied().unwrap_or(0.0).max(f64::MIN_POSITIVE);
    measured().max_by(|&a, &b| beside_noise(a).total_cmp(&beside_noise(b)))
}

/// The most probable cause that acts on a joint, from 0.
fn main_cause(found: &Diagnosis, joint: usize) -> Option<&Cause> {
    let here = |c: &&Cause| c.cause != "unknown" && (c.joints.is_empty() || c.joints.contains(&(joint + 1)));
    found.causes.iter().filter(here).max_by(|a, b| a.probability.total_cmp(&b.probability))
}

/// Summary in three sentences: error of the most improved joint, its likely cause, error over all
/// joints.
pub fn calibrate_verdict(found: &Diagnosis) -> String {
    let (before, after) = (&found.baseline.validate, &found.extended.validate);
    let mut text = String::new();
    if let Some(j) = most_improved_joint(found) {
        let share = |errors: &[f64]| percent(100.0 * errors[j] / found.torque_rms[j]);
        let _ = write!(
            text,
            "On logs that nothing was fitted to, the identified model misses the torque of joint {} by {} %, with what the diagnosis found by {} %. ",
            j + 1,
            share(before),
            share(after)
        );
        let cause = |c: &Cause| {
            format!("Likely cause: {} {} (probability {:.2}). ", c.cause.replace('_', " "), place(c), c.probability)
        };
        text.push_str(&main_cause(found, j).map_or("No cause with a name was found for it. ".into(), cause));
    }
    let _ = write!(
        text,
        "All joints: {} N m (RMS over joints), then {} N m; the noise is {} N m.",
        digits(root_mean_square(before), 3),
        digits(root_mean_square(after), 3),
        digits(root_mean_square(&found.noise_floor), 3)
    );
    text
}

/// Identification and diagnosis as text for the terminal.
pub fn calibrate_text(found: &Diagnosis, identified: &Identified<'_>, warnings: &Warnings) -> String {
    let mut text = warnings.text();
    let _ = writeln!(text, "{}: identified and diagnosed; {}", found.robot, found.verdict.word().replace('_', " "));
    let _ = writeln!(text, "{}\n", calibrate_verdict(found));
    let _ = writeln!(
        text,
        "RMS on validation, N m ({} s; {} s were fitted)",
        digits(found.seconds[1], 3),
        digits(found.seconds[0], 3)
    );
    let heads = ["joint", "torque", "identified", "of torque", "extended", "of torque", "noise"];
    let _ = writeln!(text, "{}", heads.iter().map(|h| pad(h, 12, true)).collect::<String>());
    for j in 0..found.noise_floor.len() {
        let torque = found.torque_rms[j];
        let mut cells = vec![(j + 1).to_string(), digits(torque, 3)];
        for errors in [&found.baseline.validate, &found.extended.validate] {
            cells.push(digits(errors[j], 3));
            cells.push(format!("{} %", percent(100.0 * errors[j] / torque)));
        }
        cells.push(digits(found.noise_floor[j], 3));
        let _ = writeln!(text, "{}", cells.iter().map(|c| pad(c, 12, true)).collect::<String>());
    }
    for (number, c) in found.causes.iter().enumerate() {
        let _ = writeln!(text, "\n{}. {} {} (probability {:.2})", number + 1, c.cause, place(c), c.probability);
        let _ = writeln!(text, "   {}", c.evidence);
        if let Some(sentence) = for_the_file(c) {
            let _ = writeln!(text, "   {sentence}");
        }
        if !c.not_distinguished_from.is_empty() {
            let rivals = c.not_distinguished_from.join(", ");
            let _ = writeln!(text, "   This data does not tell it from {rivals}; {} would.", c.shown_by);
        }
    }
    for warning in identified.warnings.iter() {
        let _ = writeln!(text, "\nwarning of the identification: {warning}");
    }
    text
}
