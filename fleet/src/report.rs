//! What a watch found, as text, JSON and one page.

mod page;

use std::fmt::Write;

use denavit::report::visible;
use serde_json::{Value, json};

use crate::watch::{Change, Watched};

pub use page::page;

/// Explanations that a text names.
const NAMED: usize = 2;

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
    if !watched.unusable.is_empty() {
        let _ = writeln!(out, "{} recordings have no factor; the reasons are in the table", watched.unusable.len());
    }
    let _ = writeln!(out, "{}", verdict(watched));
    out
}

/// The last line.
pub fn verdict(watched: &Watched) -> String {
    let years = watched.robot_days as f64 / 365.25;
    let expected = watched.robot_days as f64 / watched.days_between;
    format!(
        "{} robots, {} robot-days ({years:.1} robot-years): {} changes; on average at most {} alarms would be false",
        watched.robots,
        watched.robot_days,
        watched.changes.len(),
        figure(expected),
    )
}

/// One change.
fn line(change: &Change) -> String {
    let causes: Vec<String> = change.causes.iter().take(NAMED).map(cause).collect();
    format!(
        "{}: changed after {}, found on {}: {}; {} by {}",
        change.robot,
        date(change.before),
        date(change.found),
        causes.join(", or "),
        change.parameter,
        between(change.size, change.unit),
    )
}

/// A change with its unit; gains, which have none, in percent.
pub(crate) fn amount(value: f64, unit: &str) -> String {
    let (value, unit) = if unit.is_empty() { (100.0 * value, "%") } else { (value, unit) };
    format!("{}{} {unit}", if value > 0.0 { "+" } else { "" }, figure(value))
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

/// A cause with the share that it explains.
fn cause(cause: &crate::channel::Explanation) -> String {
    format!("{} ({:.0} % explained)", place(cause), 100.0 * cause.share.max(0.0))
}

/// A cause in words.
pub(crate) fn place(cause: &crate::channel::Explanation) -> String {
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
            let changes =
                c.changes.iter().map(|(name, value, unit)| json!({ "parameter": name, "value": value, "unit": unit }));
            json!({ "kind": c.kind.name(), "joint": c.joint, "share": c.share, "changes": changes.collect::<Vec<_>>() })
        });
        json!({
            "robot": change.robot, "before": date(change.before), "found": date(change.found),
            "evidence_days": change.evidence, "parameter": change.parameter, "change": change.size[0],
            "std": change.size[1], "unit": change.unit, "causes": causes.collect::<Vec<_>>(),
            "files": change.files, "diagnosis": change.diagnosis,
        })
    };
    let pair = |(name, why): &(String, String)| json!({ "name": name, "why": why });
    json!({
        "robots": watched.robots, "robot_days": watched.robot_days, "days_between_false_alarms": watched.days_between,
        "changes": watched.changes.iter().map(change).collect::<Vec<_>>(),
        "untested": watched.untested.iter().map(pair).collect::<Vec<_>>(),
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

/// Date of a number of days since 1970 (Hinnant, days_from_civil and back).
pub(crate) fn date(days: i32) -> String {
    let z = i64::from(days) + 719_468;
    let era = z.div_euclid(146_097);
    let of_era = z.rem_euclid(146_097);
    let year_of_era = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted = (5 * of_year + 2) / 153;
    let day = of_year - (153 * shifted + 2) / 5 + 1;
    let month = if shifted < 10 { shifted + 3 } else { shifted - 9 };
    let year = year_of_era + era * 400 + i64::from(month <= 2);
    format!("{year:04}-{month:02}-{day:02}")
}

#[cfg(test)]
mod tests {
    use super::{date, figure};

    #[test]
    fn dates_are_those_of_the_calendar() {
        assert_eq!(date(0), "1970-01-01");
        assert_eq!(date(20_780), "2026-11-23");
        assert_eq!(date(11_016), "2000-02-29");
        assert_eq!(date(-1), "1969-12-31");
    }

    #[test]
    fn figures_have_three_digits() {
        assert_eq!(figure(0.012_345), "0.0123");
        assert_eq!(figure(1234.5), "1234");
        assert_eq!(figure(-2.0), "-2");
    }
}
