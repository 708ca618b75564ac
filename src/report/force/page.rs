//! The wrench on the tool as one self-contained HTML page: six components with their bands.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::control::estimate::{COMPONENTS, Series};
use crate::data::signal::Prepared;
use crate::report::Provenance;
use crate::report::force::text::{Forces, HEAD, cells, sentences, tables, verdict, warnings};
use crate::report::identify::page::notes;
use crate::report::parts::number::digits;
use crate::report::parts::page::{Page, escape};

/// Maximum number of points of a curve.
const POINTS: usize = 900;

/// The page.
pub fn force_html(outcome: &Forces<'_>, prepared: &[Prepared], provenance: &Provenance) -> String {
    let mut body = String::new();
    let verdict = outcome.verdict().map(verdict).unwrap_or_default();
    let _ = writeln!(
        body,
        "<header><p class=kicker>Force without a sensor</p><h1>{}</h1><p class=verdict>{}</p></header>",
        escape(outcome.robot),
        escape(&verdict)
    );
    body.push_str(&warnings(outcome, prepared).html());
    notes(&mut body, prepared);
    for series in outcome.found {
        let _ = writeln!(
            body,
            "<section><h2><code>{}</code></h2><p class=note>Wrench of the surroundings on the tool, in its frame; estimator {}. <span class='key estimated'></span>estimated <span class='key band'></span>95 % band{} <span class='key touch'></span>contact is said. No band: the component is unobservable there</p><div class=wrenches>",
            escape(&series.name),
            series.method.name(),
            if series.measured.is_empty() { "" } else { " <span class='key measured'></span>measured" }
        );
        (0..6).for_each(|i| component(&mut body, series, i));
        body.push_str("</div>\n");
        for sentence in sentences(series, outcome.circular()) {
            let _ = writeln!(body, "<p>{}</p>", escape(&sentence));
        }
        for (title, rows) in tables(series) {
            let _ = write!(body, "<h3>{}</h3><div class=scroll><table><thead><tr>", escape(&title));
            HEAD.iter().for_each(|h| {
                let _ = write!(body, "<th>{}", h.replace("+-", "±"));
            });
            body.push_str("</tr></thead><tbody>\n");
            for (i, c) in rows.iter().enumerate() {
                let row = cells(i, c);
                let _ = write!(body, "<tr><th>{}", row[0]);
                row[1..].iter().for_each(|cell| {
                    let _ = write!(body, "<td>{cell}");
                });
                body.push_str("</tr>\n");
            }
            body.push_str("</tbody></table></div>\n");
        }
        body.push_str("</section>\n");
    }
    body.push_str("<section><h2>How this was made</h2><p class=note>The band holds the true value in 95 of 100 samples, counted over samples and over identifications. The parameters' error is the same throughout a run, so a single run may lie above or below. It covers the noise and the parameters' uncertainty, not effects that the model lacks.</p><dl>\n");
    for (what, value) in provenance {
        let _ = writeln!(body, "<dt>{}<dd>{}", escape(what), escape(value));
    }
    body.push_str("</dl></section>\n");
    let numbers: Vec<Value> = outcome.found.iter().map(numbers).collect();
    let title = format!("{} – force", outcome.robot);
    Page {
        title,
        style: include_str!("page.css"),
        body: &body,
        data: json!({ "series": numbers }),
        script: include_str!("page.js"),
    }
    .html()
}

/// Data of a log's plots, thinned: mean of each stretch, and its largest half-width of the band.
fn numbers(series: &Series) -> Value {
    let chunk = series.time.len().div_ceil(POINTS).max(1);
    let row = |from: usize| {
        let range = from..(from + chunk).min(series.time.len());
        let mean = |value: &dyn Fn(usize) -> f64| range.clone().map(value).sum::<f64>() / range.len() as f64;
        let wrench = (0..6).map(|i| json!(mean(&|s| series.wrench[s][i])));
        let half = (0..6).map(|i| {
            let band =
                range.clone().filter(|&s| series.observable[s][i]).map(|s| series.half[s][i]).fold(f64::NAN, f64::max);
            json!(band)
        });
        let measured = (0..6).filter(|_| !series.measured.is_empty()).map(|i| json!(mean(&|s| series.measured[s][i])));
        let first = [json!(series.time[from]), json!(series.segment[from])];
        let touching = json!(u8::from(range.clone().any(|s| series.touching[s])));
        let row: Vec<Value> = first.into_iter().chain(wrench).chain(half).chain(measured).chain([touching]).collect();
        json!(row)
    };
    let of = |prefix: &str| COMPONENTS.map(|c| format!("{prefix}{c}"));
    let mut header = vec!["t".to_string(), "segment".to_string()];
    header.extend(of("").into_iter().chain(of("half_")));
    if !series.measured.is_empty() {
        header.extend(of("measured_"));
    }
    header.push("touching".into());
    json!({ "header": header, "rows": (0..series.time.len()).step_by(chunk).map(row).collect::<Vec<_>>() })
}

/// Half the height of a panel for values with these ascending magnitudes, and a note if it cuts
/// some. A short peak of more than twice the rest would flatten the curve.
fn scale(sizes: &[f64]) -> (f64, String) {
    let (usual, largest) = (sizes[(sizes.len() - 1) * 98 / 100], sizes[sizes.len() - 1]);
    if largest > 2.0 * usual.max(1e-6) {
        return (1.08 * usual.max(1e-6), format!(" (cut; up to {})", digits(largest, 2)));
    }
    ((1.08 * largest).max(1e-6), String::new())
}

/// Plot of one component over time: band, measured, estimated. Thinned to the extreme values of
/// each stretch.
fn component(body: &mut String, series: &Series, i: usize) {
    const W: f64 = 560.0;
    const H: f64 = 210.0;
    let (left, right, top, bottom) = (52.0, 8.0, 20.0, 22.0);
    let len = series.time.len();
    if len == 0 {
        return;
    }
    // Segments are joined end to end, since each may have its own clock.
    let mut clock = vec![0.0; len];
    for s in 1..len {
        let step = series.time[s] - series.time[s - 1];
        clock[s] = clock[s - 1] + if series.segment[s] == series.segment[s - 1] { step } else { 0.0 };
    }
    let end = clock[len - 1].max(1e-9);
    // An unobservable component has no band.
    let half = |s: usize| if series.observable[s][i] { series.half[s][i] } else { 0.0 };
    let mut sizes: Vec<f64> = (0..len)
        .map(|s| {
            let measured = series.measured.get(s).map_or(0.0, |m| m[i].abs());
            (series.wrench[s][i].abs() + half(s)).max(measured)
        })
        .collect();
    sizes.sort_by(f64::total_cmp);
    let (reach, cut) = scale(&sizes);
    let x = |s: usize| left + clock[s] / end * (W - left - right);
    let y = |v: f64| top + (0.5 - 0.5 * (v / reach).clamp(-1.0, 1.0)) * (H - top - bottom);
    let unit = if i < 3 { "N" } else { "N m" };
    let _ = write!(
        body,
        "<svg class=wrench viewBox='0 0 {W} {H}' role=img aria-label='{0}'><text class=title x={left} y=13>{0}, {unit}{1}</text>",
        COMPONENTS[i], cut
    );
    for v in [-reach / 1.08, 0.0, reach / 1.08] {
        let class = if v == 0.0 { "zero" } else { "grid" };
        let _ = write!(
            body,
            "<line class={class} x1={left} x2={:.1} y1={1:.1} y2={1:.1} /><text x={2:.1} y={3:.1} text-anchor=end>{4}</text>",
            W - right,
            y(v),
            left - 5.0,
            y(v) + 4.0,
            digits(v, 2)
        );
    }
    let _ = write!(
        body,
        "<text x={left} y={:.1}>0</text><text x={:.1} y={0:.1} text-anchor=end>{} s</text>",
        H - 6.0,
        W - right,
        digits(end, 3)
    );
    let chunk = len.div_ceil(POINTS).max(1);
    let chunks: Vec<std::ops::Range<usize>> = (0..len).step_by(chunk).map(|s| s..(s + chunk).min(len)).collect();
    let outer = |range: &std::ops::Range<usize>, value: &dyn Fn(usize) -> f64| {
        range.clone().map(value).fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(v), b.max(v)])
    };
    let mut touched = String::new();
    for range in chunks.iter().filter(|r| (r.start..r.end).any(|s| series.touching[s])) {
        let (from, to) = (x(range.start), x((range.end).min(len - 1)));
        let _ = write!(touched, "M{from:.1} {:.1}h{:.1}v4h{:.1}z", H - bottom - 4.0, to - from, from - to);
    }
    let _ = write!(body, "<path class=touch d='{touched}' style='stroke:none' />");
    let (mut upper, mut lower) = (String::new(), String::new());
    for range in &chunks {
        let high = outer(range, &|s| series.wrench[s][i] + half(s))[1];
        let low = outer(range, &|s| series.wrench[s][i] - half(s))[0];
        let _ = write!(upper, "{}{:.1} {:.1}", if upper.is_empty() { "M" } else { "L" }, x(range.start), y(high));
        lower = format!("L{:.1} {:.1}", x(range.start), y(low)) + &lower;
    }
    let _ = write!(body, "<path class=band d='{upper}{lower}z' />");
    let mut curve = |class: &str, value: &dyn Fn(usize) -> f64| {
        let mut d = String::new();
        for range in &chunks {
            let fresh = d.is_empty() || series.segment[range.start] != series.segment[range.start.saturating_sub(1)];
            let [low, high] = outer(range, value);
            let _ = write!(d, "{}{:.1} {:.1}", if fresh { "M" } else { "L" }, x(range.start), y(low));
            if chunk > 1 {
                let _ = write!(d, "V{:.1}", y(high));
            }
        }
        let _ = write!(body, "<path class={class} d='{d}' />");
    };
    if !series.measured.is_empty() {
        curve("measured", &|s| series.measured[s][i]);
    }
    curve("estimated", &|s| series.wrench[s][i]);
    body.push_str("</svg>\n");
}
