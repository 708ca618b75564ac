//! Report on hidden effects in simulated logs: tables, a verdict, the cases as JSON.

use serde_json::{Value, json};

use crate::apps::paper::Tally;
use crate::apps::paper::diagnosis::{Battery, Hidden, Outcome};
use crate::diagnose::Cause;
use crate::report::parts::number::{counted, digits};
use crate::report::reproduce::text::Table;

/// A share with its counts: `97 % (97 of 100)`.
pub(super) fn percent(share: Tally) -> String {
    share.value().map_or("–".into(), |v| format!("{:.0} % ({} of {})", 100.0 * v, share.good, share.all))
}

/// Required share of right causes; lower where an effect is hardly above the noise.
fn wanted(size: f64) -> f64 {
    if size < 3.0 { 0.80 } else { 0.95 }
}

/// The verdict in one paragraph.
pub(in crate::report) fn verdict(found: &Battery) -> String {
    let s = &found.scores;
    if found.settings.clean {
        return format!(
            "Of {} logs in which nothing was hidden, {} gave an alarm.",
            s.false_alarms.all, s.false_alarms.good
        );
    }
    format!(
        "Effects of {} times the noise, hidden in {} from seed {}: the right cause comes first in {}, in the right place in {} of these. The models attain {} of the possible gain on unused data where the joints move, {} over all samples.",
        found.settings.size,
        counted(found.outcomes.len(), "simulated case", "simulated cases"),
        found.settings.from,
        percent(s.first),
        percent(s.place),
        format_args!("{:.0} %", 100.0 * s.gain),
        format_args!("{:.0} %", 100.0 * s.gain_of_all)
    )
}

/// Figures, confusion of causes, reliability of probabilities, wrong cases.
pub(in crate::report) fn tables(found: &Battery) -> Vec<Table> {
    let s = &found.scores;
    let mut rows: Vec<Vec<String>> = Vec::new();
    let mut row = |what: &str, share: Tally, wanted: f64, most: bool| {
        let holds = share.value().map_or("–", |v| match most {
            true if v <= wanted => "holds",
            false if v >= wanted => "holds",
            _ => "falls short",
        });
        let bound = if most { "at most" } else { "at least" };
        rows.push(vec![what.into(), percent(share), format!("{bound} {:.0} %", 100.0 * wanted), holds.into()]);
    };
    row("right cause first", s.first, wanted(found.settings.size), false);
    row("... or not distinguished, nothing but noise left", s.first_or_named, wanted(found.settings.size), false);
    row("right joint, where the cause is right", s.place, 0.98, false);
    row("both of two effects", s.both, 0.85, false);
    row("false alarms on clean logs", s.false_alarms, 0.01, true);
    row("outside the vocabulary: unknown or unexplained", s.outside, 0.90, false);
    row("nine tenths of the attainable gain, where joints move", s.gained, 0.90, false);
    row("parameters within three standard deviations", s.within_three, 0.95, false);
    let figures = Table {
        title: format!("Diagnosis of what was hidden, {} times the noise", found.settings.size),
        note: format!(
            "{} cases from seed {}, {} arms, logs of {} and {} s at {} Hz. {} wrong causes beside the right ones per case.",
            found.outcomes.len(),
            found.settings.from,
            found.settings.arms,
            found.settings.seconds[0],
            found.settings.seconds[1],
            found.settings.rate,
            digits(s.beside, 2)
        ),
        head: vec!["figure", "found", "wanted", "verdict"],
        rows,
    };
    let confusion = Table {
        title: "What came first".into(),
        note: "Rows: what was hidden; the answers with their number.".into(),
        head: vec!["hidden", "cases", "first cause"],
        rows: s
            .confusion
            .iter()
            .map(|(label, answers)| {
                let all: usize = answers.iter().map(|a| a.1).sum();
                let each: Vec<String> = answers.iter().map(|(word, n)| format!("{word} {n}")).collect();
                vec![label.clone(), all.to_string(), each.join(", ")]
            })
            .collect(),
    };
    let reliability = Table {
        title: "Whether probabilities hold".into(),
        note: "All causes that were named, by the probability that the diagnosis gave them; right: hidden, and there."
            .into(),
        head: vec!["probability", "mean", "right"],
        rows: s
            .reliability()
            .into_iter()
            .map(|(low, high, mean, share)| vec![format!("{low:.2} to {high:.2}"), digits(mean, 3), percent(share)])
            .collect(),
    };
    let wrong = Table {
        title: "Cases that went wrong".into(),
        note: "What was hidden on which joints, and all that was named.".into(),
        head: vec!["seed", "arm", "hidden", "named"],
        rows: found
            .outcomes
            .iter()
            .filter(|o| !o.good())
            .map(|o| {
                let hidden: Vec<String> = o.hidden.iter().map(|h| format!("{} {:?}", h.cause, h.joints)).collect();
                let named: Vec<String> = o
                    .found
                    .causes
                    .iter()
                    .map(|c| {
                        let or = c.not_distinguished_from.join(", ");
                        let or = if or.is_empty() { or } else { format!(" or {or}") };
                        format!("{} {:?} {:.2}{or}", c.cause, c.joints, c.probability)
                    })
                    .collect();
                let hidden = if hidden.is_empty() { "nothing".into() } else { hidden.join("; ") };
                vec![o.seed.to_string(), o.robot.into(), hidden, named.join("; ")]
            })
            .collect(),
    };
    vec![figures, confusion, reliability, wrong]
}

/// Plot of the true share over the stated probability.
pub(in crate::report) fn drawing(found: &Battery) -> String {
    use std::fmt::Write;
    let mut svg =
        String::from("<svg class=bars viewBox='0 0 320 240' role=img aria-label='reliability of probabilities'>");
    let (x, y) = (|v: f64| 40.0 + 260.0 * v, |v: f64| 210.0 - 190.0 * v);
    for v in [0.0, 0.25, 0.5, 0.75, 1.0] {
        let _ = write!(
            svg,
            "<line class=grid x1='{:.0}' x2='{:.0}' y1='{2:.0}' y2='{2:.0}' /><text x=34 y='{3:.0}' text-anchor=end>{v}</text><text x='{4:.0}' y=226 text-anchor=middle>{v}</text>",
            x(0.0),
            x(1.0),
            y(v),
            y(v) + 4.0,
            x(v)
        );
    }
    let _ = write!(
        svg,
        "<line class=chosen x1='{:.0}' y1='{:.0}' x2='{:.0}' y2='{:.0}' />",
        x(0.0),
        y(0.0),
        x(1.0),
        y(1.0)
    );
    for (_, _, mean, share) in found.scores.reliability() {
        if let Some(right) = share.value() {
            let _ = write!(
                svg,
                "<circle cx='{:.1}' cy='{:.1}' r='{:.1}'><title>{} claims</title></circle>",
                x(mean),
                y(right),
                2.0 + (share.all as f64).sqrt().min(10.0),
                share.all
            );
        }
    }
    svg.push_str("</svg><p class=note>Share that was right over the stated probability; the larger the dot, the more causes.</p>");
    svg
}

pub(super) fn share(share: Tally) -> Value {
    json!({ "good": share.good, "all": share.all, "share": share.value() })
}

/// Claims binned by probability.
pub(super) fn binned(claims: &[(f64, f64, f64, Tally)]) -> Vec<Value> {
    let bin = |(low, high, mean, right): &(f64, f64, f64, Tally)| json!({ "from": low, "to": high, "mean": mean, "right": share(*right) });
    claims.iter().map(bin).collect()
}

/// Settings, figures and cases as JSON.
pub(in crate::report) fn to_json(found: &Battery) -> Value {
    let s = &found.scores;
    json!({
        "settings": {
            "cases": found.settings.cases, "from": found.settings.from, "size": found.settings.size, "clean": found.settings.clean,
            "seconds": found.settings.seconds, "rate": found.settings.rate, "arms": found.settings.arms,
        },
        "right_cause_first": share(s.first), "right_or_named": share(s.first_or_named), "right_joint": share(s.place),
        "both_of_two": share(s.both), "false_alarms": share(s.false_alarms), "outside_unknown": share(s.outside),
        "wrong_beside": s.beside, "gain_share": s.gain, "gain_share_of_all_samples": s.gain_of_all, "gain_nine_tenths": share(s.gained), "within_three": share(s.within_three),
        "confusion": s.confusion.iter().map(|(label, answers)| json!({
            "hidden": label, "first": answers.iter().map(|(word, n)| json!({ "cause": word, "cases": n })).collect::<Vec<_>>(),
        })).collect::<Vec<_>>(),
        "reliability": binned(&s.reliability()),
        "cases": found.outcomes.iter().map(case).collect::<Vec<_>>(),
    })
}

fn case(o: &Outcome) -> Value {
    let parameters: Vec<Value> =
        o.parameters().iter().map(|(symbol, truth, value, std)| json!([symbol, truth, value, std])).collect();
    json!({
        "seed": o.seed, "robot": o.robot, "task": o.label(), "hidden": o.hidden.iter().map(hidden).collect::<Vec<_>>(),
        "verdict": o.found.verdict.word(), "right": o.right(), "right_or_named": o.right_or_named(), "complete": o.complete(),
        "gain": o.gain(), "gain_of_all_samples": o.gain_of_all(), "links_refitted": o.found.links_refitted, "noise": o.noise, "attainable": o.attainable[0],
        "baseline": o.found.baseline.validate, "extended": o.found.extended.validate, "parameters": parameters,
        "moving": json!({ "baseline": o.found.baseline.moving, "extended": o.found.extended.moving, "attainable": o.attainable[1] }),
        "causes": o.found.causes.iter().map(|c| cause(o, c)).collect::<Vec<_>>(),
    })
}

fn hidden(h: &Hidden) -> Value {
    let truth: Vec<Value> = h.truth.iter().map(|(symbol, value)| json!([symbol, value])).collect();
    json!({ "cause": h.cause, "joints": h.joints, "size": h.size, "truth": truth })
}

fn cause(o: &Outcome, c: &Cause) -> Value {
    let parameters: Vec<Value> = c.parameters.iter().map(|p| json!([p.symbol, p.value, p.std])).collect();
    json!({
        "cause": c.cause, "joints": c.joints, "probability": c.probability, "right": o.holds(c),
        "support": c.support, "margin": c.margin, "share": c.share,
        "not_distinguished_from": c.not_distinguished_from, "parameters": parameters,
        "rms_before": c.rms_before, "rms_after": c.rms_after,
    })
}
