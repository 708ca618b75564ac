//! What a watch found, as text, JSON and one page.

mod page;

use std::fmt::Write;

use denavit::report::visible;
use serde_json::{Value, json};

use crate::attribution::{CERTAIN, Explanation, clearest};
use crate::calendar::date;
use crate::watch::{Change, Watched};

pub use page::page;

/// Causes that a text names at most.
const NAMED: usize = 3;

/// For the terminal.
pub fn text(watched: &Watched) -> String {
    let mut out = String::new();
    for change in &watched.changes {
        let _ = writeln!(out, "{}", visible(&line(change)));
        if let Some(diagnosis) = &change.diagnosis {
            for line in diagnosis.lines() {
                let _ = writeln!(out, "    {}", visible(line));
            }
        }
    }
    for (name, why) in &watched.untested {
        let _ = writeln!(out, "{}", visible(&format!("{name}: not tested: {why}")));
    }
    if watched.undated > 0 {
        let _ = writeln!(out, "{}", undated(watched.undated));
    }
    if !watched.unusable.is_empty() {
        let _ = writeln!(out, "{} recordings have no factor; the reasons are in the table", watched.unusable.len());
    }
    let _ = writeln!(out, "{}", verdict(watched));
    out
}

/// What became of recordings without a day.
pub(crate) fn undated(count: usize) -> String {
    format!(
        "{count} recordings have no day, for their time is not that of a calendar: not tested (factor --day DATE names it)"
    )
}

/// The last line.
pub fn verdict(watched: &Watched) -> String {
    let years = watched.robot_days as f64 / 365.25;
    let expected = watched.robot_days as f64 / watched.days_between;
    format!(
        "{}, {} ({years:.1} robot-years): {}; had nothing changed, at most {} false alarms on average",
        number(watched.robots, "robot"),
        number(watched.robot_days, "robot-day"),
        number(watched.changes.len(), "change"),
        figure(expected),
    )
}

/// So many of something.
fn number(count: usize, what: &str) -> String {
    if count == 1 { format!("1 {what}") } else { format!("{count} {what}s") }
}

/// One change.
fn line(change: &Change) -> String {
    let (parameter, by) = match change.causes.first().and_then(clearest) {
        Some(by) => (&by.parameter, between([by.value, by.std], &by.unit)),
        None => (&change.parameter, between(change.size, &change.unit)),
    };
    format!(
        "{}: changed after {}, found on {}: {}; {parameter} by {by}",
        change.robot,
        date(change.before),
        date(change.found),
        causes(change),
    )
}

/// A change with its standard deviation.
pub(crate) fn between([value, std]: [f64; 2], unit: &str) -> String {
    let (scale, unit) = if unit.is_empty() { (100.0, "%") } else { (1.0, unit) };
    let sign = if value > 0.0 { "+" } else { "" };
    format!("{sign}{} ± {} {unit}", figure(scale * value), figure(scale * std))
}

/// How rare an alarm of this evidence is without a change.
pub(crate) fn rarity(evidence: f64) -> String {
    let years = evidence / 365.25;
    if years < 2.0 { format!("{} robot-days", figure(evidence)) } else { format!("{} robot-years", figure(years)) }
}

/// What a parameter is, from its name in the robot file.
pub(crate) fn meaning(parameter: &str) -> &'static str {
    match parameter.trim_end_matches(|c: char| c.is_ascii_digit()) {
        "FC" => "Coulomb friction",
        "FV" => "viscous friction",
        "FO" => "offset of the torque",
        "gain" => "gain of the torque",
        "M" => "mass",
        "MSX" | "MSY" | "MSZ" => "first moment of mass",
        _ => "parameter",
    }
}

/// The cause, or the causes that can't be told apart, with their probabilities.
pub(crate) fn causes(change: &Change) -> String {
    let named: Vec<String> = apart(&change.causes)
        .iter()
        .map(|cause| format!("{} (probability {})", place(cause), probability(cause.probability)))
        .collect();
    match named.as_slice() {
        [] => "cause unknown".into(),
        [one] => one.clone(),
        several => format!("{}, which can't be told apart", several.join(" or ")),
    }
}

/// The most probable causes: one that is certain, or those that can't be told apart.
pub(crate) fn apart(causes: &[Explanation]) -> &[Explanation] {
    let mut sum = 0.0;
    let before = causes.iter().take_while(|cause| {
        let short = sum < CERTAIN;
        sum += cause.probability;
        short
    });
    &causes[..before.count().min(NAMED)]
}

/// Two digits, and neither 0 nor 1.
pub(crate) fn probability(p: f64) -> String {
    if p > 0.99 {
        "over 0.99".into()
    } else if p < 0.01 {
        "under 0.01".into()
    } else {
        format!("{p:.2}")
    }
}

/// A cause in words.
pub(crate) fn place(cause: &Explanation) -> String {
    use crate::channel::Kind;
    match cause.kind {
        Kind::Friction | Kind::Offset | Kind::Gain => format!("{} of joint {}", cause.kind.name(), cause.joint),
        Kind::Payload => "payload".into(),
        Kind::Link => format!("mass on link {}", cause.joint),
    }
}

/// As JSON.
pub fn json(watched: &Watched) -> Value {
    let change = |change: &Change| {
        let causes = change.causes.iter().map(|c| {
            let changes = c
                .changes
                .iter()
                .map(|p| json!({ "parameter": p.parameter, "value": p.value, "std": p.std, "unit": p.unit }));
            json!({
                "kind": c.kind.name(), "joint": c.joint, "probability": c.probability, "share": c.share,
                "changes": changes.collect::<Vec<_>>(),
            })
        });
        json!({
            "robot": change.robot, "before": date(change.before), "found": date(change.found),
            "evidence_days": change.evidence, "parameter": change.parameter, "change": change.size[0],
            "std": change.size[1], "unit": change.unit,
            "certain": apart(&change.causes).len() == 1, "causes": causes.collect::<Vec<_>>(),
            "files": change.files, "diagnosis": change.diagnosis,
        })
    };
    let pair = |(name, why): &(String, String)| json!({ "name": name, "why": why });
    json!({
        "robots": watched.robots, "robot_days": watched.robot_days, "days_between_false_alarms": watched.days_between,
        "changes": watched.changes.iter().map(change).collect::<Vec<_>>(),
        "undated": watched.undated, "untested": watched.untested.iter().map(pair).collect::<Vec<_>>(),
        "unusable": watched.unusable.iter().map(pair).collect::<Vec<_>>(),
    })
}

/// Three digits.
pub(crate) fn figure(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{x}");
    }
    if x.abs() >= 1e6 {
        return format!("{x:.1e}");
    }
    let places = (2 - x.abs().log10().floor() as i32).clamp(0, 9) as usize;
    let text = format!("{x:.places$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
}

#[cfg(test)]
mod tests {
    use super::figure;

    #[test]
    fn figures_have_three_digits() {
        assert_eq!(figure(0.012_345), "0.0123");
        assert_eq!(figure(1234.5), "1234");
        assert_eq!(figure(-2.0), "-2");
    }
}
