//! The paper's experiments as one self-contained HTML page.

use std::fmt::Write;

use serde_json::json;

use crate::apps::paper::Experiment;
use crate::report::Provenance;
use crate::report::identify::page::curves;
use crate::report::parts::number::digits;
use crate::report::parts::page::{Page, escape};
use crate::report::reproduce::diagnosis;
use crate::report::reproduce::excitation;
use crate::report::reproduce::force;
use crate::report::reproduce::on_real;
use crate::report::reproduce::painting;
use crate::report::reproduce::text::{Parts, Table, identification_verdict, tables};

/// Sections on hidden effects and on causes added to recordings.
fn diagnoses(body: &mut String, parts: &Parts) {
    if let Some(found) = &parts.diagnosis {
        for table in &diagnosis::tables(found) {
            let drawing = if table.title.starts_with("Whether probabilities") {
                diagnosis::drawing(found)
            } else {
                String::new()
            };
            section(body, table, &drawing, "");
        }
    }
    for table in parts.on_real.iter().flat_map(on_real::tables) {
        section(body, &table, "", "");
    }
}

/// The page.
pub fn reproduce_html(parts: &Parts, provenance: &Provenance) -> String {
    let mut body = String::new();
    let mut traces = Vec::new();
    body.push_str(
        "<header><p class=kicker>The paper, rerun</p><h1>Optimal exciting motion for fast robot identification</h1>\n",
    );
    let mut verdict = |text: String| {
        let _ = writeln!(body, "<p class=verdict>{}</p>", escape(&text));
    };
    parts.excitation.iter().for_each(|found| verdict(excitation::verdict(found)));
    parts.identification.iter().for_each(|found| verdict(identification_verdict(found)));
    parts.painting.iter().for_each(|found| verdict(painting::verdict(found)));
    parts.force.iter().for_each(|found| verdict(force::verdict(found)));
    parts.diagnosis.iter().for_each(|found| verdict(diagnosis::verdict(found)));
    parts.on_real.iter().for_each(|found| verdict(on_real::verdict(found)));
    body.push_str("</header>\n");
    if let Some(found) = &parts.excitation {
        for (k, table) in excitation::tables(found).iter().enumerate() {
            let drawing = if k == 0 { excitation::drawing(found) } else { String::new() };
            section(&mut body, table, &drawing, "");
        }
    }
    if let Some(found) = &parts.identification {
        for table in tables(found) {
            let drawing = if table.title.starts_with("Fig. 6:") { bars(found) } else { String::new() };
            let curves = if table.title.starts_with("Fig. 10") { torques(traces.len()) } else { String::new() };
            section(&mut body, &table, &drawing, &curves);
        }
        traces.push(curves(&found.fig10.trace));
    }
    if let Some(found) = &parts.painting {
        for (k, table) in painting::tables(found).iter().enumerate() {
            let drawing = if k == 0 { painting::drawing(found) } else { String::new() };
            section(&mut body, table, &drawing, "");
        }
    }
    for table in parts.force.iter().flat_map(force::tables) {
        section(&mut body, &table, "", "");
    }
    diagnoses(&mut body, parts);
    body.push_str("<section><h2>How this was made</h2><dl>\n");
    for (what, value) in provenance {
        let _ = writeln!(body, "<dt>{}<dd>{}", escape(what), escape(value));
    }
    body.push_str("</dl></section>\n");
    let page = Page {
        title: "The paper, rerun".into(),
        style: include_str!("page.css"),
        body: &body,
        data: json!({ "traces": traces, "names": [], "correlation": [] }),
        script: include_str!("../parts/curves.js"),
    };
    page.html()
}

/// A section with a table, and markup above and below it.
fn section(body: &mut String, table: &Table, above: &str, below: &str) {
    let _ =
        writeln!(body, "<section><h2>{}</h2><p class=note>{}</p>\n{above}", escape(&table.title), escape(&table.note));
    body.push_str("<div class=scroll><table><thead><tr>");
    table.head.iter().for_each(|h| {
        let class = if judges(h) { " class=end" } else { "" };
        let _ = write!(body, "<th{class}>{}", escape(h));
    });
    body.push_str("</tr></thead><tbody>\n");
    for row in &table.rows {
        body.push_str("<tr>");
        for (k, cell) in row.iter().enumerate() {
            let class = match cell.as_str() {
                _ if !table.head.get(k).is_some_and(|h| judges(h)) => "",
                "better" | "within" | "holds" => " class=good",
                c if c.starts_with("short") || c.starts_with("falls") => " class=bad",
                _ => "",
            };
            let tag = if k == 0 { "th" } else { "td" };
            let _ = write!(body, "<{tag}{class}>{}", escape(cell));
        }
        body.push_str("</tr>\n");
    }
    body.push_str("</tbody></table></div>\n");
    let _ = writeln!(body, "{below}</section>");
}

/// Whether a column contains verdicts.
fn judges(head: &str) -> bool {
    head == "verdict"
}

/// Placeholder for the plots of a trace, given its index in the page's data.
fn torques(trace: usize) -> String {
    format!(
        "<p class=note><span class='key measured'></span>measured <span class='key estimated'></span>estimated <span class='key residual'></span>residual (its own panel), N m over s. Drag to zoom all joints, double-click to go back.</p><div class=plots data-trace={trace}></div>"
    )
}

/// Fig. 6 as bars: for each joint one per criterion, and the means beside the paper's.
fn bars(found: &Experiment) -> String {
    let mut body = String::new();
    const WIDTH: f64 = 820.0;
    const HEIGHT: f64 = 230.0;
    let joints = found.floor.len();
    let most = found
        .fig6
        .iter()
        .flat_map(|r| r.unmodelled.rms.iter().copied().chain([r.paper]))
        .filter(|v| v.is_finite())
        .fold(0.1, f64::max);
    let (left, bottom, top) = (40.0, HEIGHT - 24.0, 12.0);
    let y = |v: f64| bottom - (bottom - top) * v / most;
    let group = (WIDTH - left) / (joints + 2) as f64;
    let _ = writeln!(
        &mut body,
        "<svg class=bars viewBox='0 0 {WIDTH} {HEIGHT}' role=img aria-label='RMS per joint and criterion'>"
    );
    let step = if most > 1.0 { 0.5 } else { 0.2 };
    let mut tick = 0.0;
    while tick <= most {
        let _ = writeln!(
            &mut body,
            "<line class=grid x1={left} x2={WIDTH} y1={0:.1} y2={0:.1} /><text x={1} y={2:.1} text-anchor=end>{tick:.1}</text>",
            y(tick),
            left - 5.0,
            y(tick) + 4.0
        );
        tick += step;
    }
    let bar = |into: &mut String, slot: usize, k: usize, value: f64, floor: Option<f64>, class: &str| {
        let wide = group / (found.fig6.len() as f64 + 1.2);
        let x = left + slot as f64 * group + (k as f64 + 0.6) * wide;
        let _ = writeln!(
            into,
            "<rect class='{class}' x={x:.1} y={:.1} width={:.1} height={:.1}><title>{} N m</title></rect>",
            y(value),
            wide - 2.0,
            (bottom - y(value)).max(0.0),
            digits(value, 3)
        );
        if let Some(floor) = floor {
            let _ = writeln!(
                into,
                "<rect class=floor x={x:.1} y={:.1} width={:.1} height={:.1} />",
                y(floor),
                wide - 2.0,
                bottom - y(floor)
            );
        }
    };
    for (k, row) in found.fig6.iter().enumerate() {
        let class = format!("criterion{k}");
        for j in 0..joints {
            bar(&mut body, j, k, row.unmodelled.rms[j], Some(row.noise_only.rms[j]), &class);
        }
        bar(&mut body, joints, k, row.unmodelled.mean(), Some(row.noise_only.mean()), &class);
        bar(&mut body, joints + 1, k, row.paper, None, &class);
    }
    let label = |slot: usize| match slot {
        s if s < joints => format!("joint {}", s + 1),
        s if s == joints => "mean".into(),
        _ => "paper's mean".to_string(),
    };
    for slot in 0..joints + 2 {
        let x = left + (slot as f64 + 0.5) * group;
        let _ = writeln!(&mut body, "<text x={x:.1} y={:.1} text-anchor=middle>{}</text>", HEIGHT - 8.0, label(slot));
    }
    body.push_str("</svg><p class=note>");
    for (k, row) in found.fig6.iter().enumerate() {
        let _ = write!(&mut body, "<span class='swatch criterion{k}'></span>{} ", row.criterion);
    }
    body.push_str("<span class='swatch floor'></span>the same with noise only. RMS, N m.</p>\n");
    body
}
