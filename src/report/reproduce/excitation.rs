//! Report on section III of the paper: tables, Fig. 5 as a plot, a verdict.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::apps::paper::Excitation;
use crate::apps::paper::excitation::CHOSEN;
use crate::report::parts::number::digits;
use crate::report::reproduce::text::Table;

/// The criteria with their names in plots.
const CRITERIA: [(&str, &str); 3] =
    [("cond", "the condition number"), ("logdet", "-log det"), ("hadamard", "-log Hadamard")];

/// The verdict in one paragraph.
pub(in crate::report) fn verdict(found: &Excitation) -> String {
    let mut text = String::from("The paper's Fig. 5, redesigned on the KUKA LWR.");
    for (criterion, name) in CRITERIA {
        if let Some(late) = found.late(criterion) {
            let _ =
                write!(text, " {name}: {:.0} % of the decrease comes after {CHOSEN} s.", 100.0 * late.share.max(0.0));
        }
    }
    if let Some((late, deviation)) = found.late("logdet").and_then(|late| Some((late, late.deviation?))) {
        let _ = write!(
            text,
            " By log det, standard deviations fall to {:.0} % of those at {CHOSEN} s when the longest motion ends; more samples of an equally good motion would make it {:.0} %. {}",
            100.0 * deviation,
            100.0 * late.by_samples,
            if deviation > 0.95 * late.by_samples {
                "So what is gained past the paper's choice is the number of samples and no better motion: its finding holds."
            } else {
                "So the motion itself still gets better past the paper's choice, which the paper did not find."
            }
        );
    }
    text
}

/// Fig. 5 as numbers, and other arms.
pub(in crate::report) fn tables(found: &Excitation) -> Vec<Table> {
    let cell = |x: Option<f64>| x.map_or("–".into(), |x| digits(x, 4));
    let signed = |x: Option<f64>| x.map_or("–".into(), |x| format!("{x:+.1}"));
    let of = |criterion: &str, k: usize| found.of(criterion).nth(k).cloned();
    let seconds = (1..=found.settings.longest).map(|s| s as f64);
    let rows = seconds.enumerate().map(|(k, s)| {
        let cells = CRITERIA.iter().flat_map(|(criterion, _)| {
            let row = of(criterion, k);
            [cell(row.as_ref().and_then(|r| r.value)), signed(row.as_ref().and_then(|r| r.change))]
        });
        std::iter::once(format!("{s:.0}")).chain(cells).collect()
    });
    let fig5 = Table {
        title: "Fig. 5: criteria against the duration of the motion".into(),
        note: format!(
            "KUKA LWR, {} unscaled columns of the links, samples at 100 Hz, a way point each second, every limit kept; best of {} starts. Each motion is designed by itself, so a step may go the wrong way by what the search leaves. The paper: nothing significant is gained after {CHOSEN} s.",
            found.columns, found.settings.starts
        ),
        head: vec!["s", "cond", "change", "-log det", "change", "-log Hadamard", "change"],
        rows: rows.collect(),
    };
    let others = Table {
        title: format!("Other arms, {CHOSEN} s: least condition number"),
        note: "Unscaled columns of the links; limits, torques, ground and spheres of their files. Published figures are of similar problems; the scaling of columns decides a condition number, so these rows show the order of magnitude and no more.".into(),
        head: vec!["arm", "columns", "ours", "published", "of"],
        rows: found
            .others
            .iter()
            .map(|o| {
                let [value, what] = o.published.map_or(["–".into(), String::new()], |(v, w)| [v.to_string(), w.into()]);
                vec![o.robot.into(), o.columns.to_string(), cell(o.condition), value, what]
            })
            .collect(),
    };
    vec![fig5, others]
}

/// Fig. 5: (a) each criterion over the duration, (b) its differences, each scaled to its own range.
pub(in crate::report) fn drawing(found: &Excitation) -> String {
    let mut svg = String::new();
    for (title, differences) in [
        ("(a) criterion, from its largest to its least value (logarithm of the condition number)", false),
        ("(b) what each second more gains, by the largest gain", true),
    ] {
        panel(&mut svg, found, title, differences);
    }
    for (k, (_, name)) in CRITERIA.iter().enumerate() {
        let _ = write!(svg, "<span class='swatch criterion{k}'></span>{name} ");
    }
    svg
}

const WIDTH: f64 = 820.0;
const HEIGHT: f64 = 200.0;

fn panel(svg: &mut String, found: &Excitation, title: &str, differences: bool) {
    let (left, right, top, bottom) = (40.0, WIDTH - 20.0, 12.0, HEIGHT - 24.0);
    let longest = found.settings.longest.max(2) as f64;
    let x = |s: f64| left + (right - left) * (s - 1.0) / (longest - 1.0);
    let y = |share: f64| bottom - (bottom - top) * share;
    let _ = write!(
        svg,
        "<p class=note>{title}</p><svg class=bars viewBox='0 0 {WIDTH} {HEIGHT}' role=img aria-label='{title}'>"
    );
    for share in [0.0, 0.5, 1.0] {
        let at = y(share);
        let _ = write!(
            svg,
            "<line class=grid x1={left} x2={right} y1={at:.1} y2={at:.1} /><text x={0} y={1:.1} text-anchor=end>{share}</text>",
            left - 6.0,
            at + 4.0
        );
    }
    for s in (1..=found.settings.longest).step_by(2) {
        let _ = write!(svg, "<text x={:.1} y={:.1} text-anchor=middle>{s} s</text>", x(s as f64), HEIGHT - 6.0);
    }
    let _ = write!(svg, "<line class=chosen x1={0:.1} x2={0:.1} y1={top} y2={bottom} />", x(CHOSEN));
    for (k, (criterion, _)) in CRITERIA.iter().enumerate() {
        let values: Vec<(f64, f64)> = found
            .of(criterion)
            .filter_map(|row| Some((row.seconds, if *criterion == "cond" { row.value?.ln() } else { row.value? })))
            .collect();
        let values: Vec<(f64, f64)> = match differences {
            true => values.windows(2).map(|w| (w[1].0, w[0].1 - w[1].1)).collect(),
            false => values,
        };
        let (low, high) = values.iter().fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v.1), h.max(v.1)));
        let low = if differences { low.min(0.0) } else { low };
        let points: Vec<String> =
            values.iter().map(|(s, v)| format!("{:.1},{:.1}", x(*s), y((v - low) / (high - low).max(1e-12)))).collect();
        let _ = write!(svg, "<polyline class='curve{k}' points='{}' />", points.join(" "));
    }
    svg.push_str("</svg>");
}

/// The result as JSON, one key per figure.
pub(in crate::report) fn to_json(found: &Excitation) -> Value {
    json!({
        "seed": found.settings.seed,
        "starts": found.settings.starts,
        "columns": found.columns,
        "fig5": found.fig5.iter().map(|r| json!({
            "criterion": r.criterion, "seconds": r.seconds, "value": r.value, "change": r.change,
            "condition_number": r.condition,
        })).collect::<Vec<_>>(),
        "late": CRITERIA.iter().map(|(criterion, _)| json!({
            "criterion": criterion,
            "share_of_decrease": found.late(criterion).map(|l| l.share),
            "deviation_ratio": found.late(criterion).and_then(|l| l.deviation),
            "by_samples_alone": found.late(criterion).map(|l| l.by_samples),
        })).collect::<Vec<_>>(),
        "others": found.others.iter().map(|o| json!({
            "robot": o.robot, "columns": o.columns, "condition_number": o.condition,
            "published": o.published.map(|p| json!({ "condition_number": p.0, "of": p.1 })),
        })).collect::<Vec<_>>(),
    })
}
