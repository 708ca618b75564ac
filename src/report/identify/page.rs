//! The identification as one self-contained HTML page.
//!
//! Curves are drawn as SVG by some 150 lines of script (`parts/curves.js`) instead of a plotting
//! library. The page stays at some hundred kB instead of 4 MB, and prints as vectors. Curves are
//! thinned to the least and largest value per stretch, so that spikes remain visible.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::data::log::{Finding, Kind, Severity};
use crate::data::signal::Prepared;
use crate::identify::{Accuracy, Identification, Standing, Trace};
use crate::report::Provenance;
use crate::report::Warnings;
use crate::report::identify_verdict;
use crate::report::parts::bodies::{Links, bodies_section};
use crate::report::parts::budget;
use crate::report::parts::number::{figure, percent};
use crate::report::parts::page::{Page, escape};

/// The page. `links`: the bodies with these parameters, if requested.
pub fn identify_html(
    found: &Identification,
    logs: &[Prepared],
    warnings: &Warnings,
    traces: &[Trace],
    links: Option<&Links<'_>>,
    provenance: &Provenance,
) -> String {
    let mut body = String::new();
    let _ = writeln!(
        body,
        "<header><p class=kicker>Identification</p><h1>{}</h1><p class=verdict>{}</p></header>",
        escape(&found.robot),
        escape(&identify_verdict(found))
    );
    body.push_str(&warnings.html());
    notes(&mut body, logs);
    body.push_str("<section><h2>Torque error per joint</h2>\n");
    torque_table(&mut body, found);
    body.push_str("<p class=note>RMS of measured less estimated torque, and percent of the measured torque's own RMS. NRMS: RMS divided by the range of the measured torque.</p></section>\n");
    if let Some(budget) = &found.budget {
        body.push_str(&budget::html(budget, "the residual of the fit"));
    }
    for (index, trace) in traces.iter().enumerate() {
        let role = if trace.validates { "Validation" } else { "Fit" };
        let thinned = match trace.thinning {
            1 => "every sample".to_string(),
            n => format!("least and largest of {n} samples"),
        };
        let _ = writeln!(
            body,
            "<section><h2>{role}: <code>{}</code></h2><p class=note><span class='key measured'></span>measured <span class='key estimated'></span>estimated <span class='key residual'></span>residual (its own panel), N m over s, {thinned}. Drag to zoom all joints, double-click to go back.</p><div class=plots data-trace={index}></div></section>",
            escape(&trace.name)
        );
    }
    body.push_str("<section><h2>Parameters</h2>\n");
    parameter_table(&mut body, found);
    open_questions(&mut body, found);
    body.push_str("</section>\n");
    if let Some(links) = links {
        bodies_section(&mut body, found, links);
    }
    body.push_str("<section><h2>Correlation of the estimates</h2><p class=note>Blue: if one is estimated too high, so is the other. Red: the other way about. White: independent. Pairs near ±1 are poorly separated by this motion.</p><div id=correlation></div></section>\n");
    foot(&mut body, found, provenance);
    let data = json!({
        "traces": traces.iter().map(curves).collect::<Vec<_>>(),
        "names": found.parameters.iter().map(|p| p.name.as_str()).collect::<Vec<_>>(),
        "correlation": found.correlation.iter().map(|c| if c.is_finite() { json!((c * 100.0).round() as i64) } else { Value::Null }).collect::<Vec<_>>(),
    });
    let page = Page {
        title: format!("{} – identification", found.robot),
        style: "",
        body: &body,
        data,
        script: include_str!("../parts/curves.js"),
    };
    page.html()
}

/// Section of notes on the logs; warnings are at the top of the page.
pub(in crate::report) fn notes(body: &mut String, logs: &[Prepared]) {
    let notes: Vec<(&str, &Finding)> = logs
        .iter()
        .flat_map(|log| log.findings.iter().map(|f| (log.file.as_str(), f)))
        .filter(|(_, f)| f.severity == Severity::Note && !matches!(f.kind, Kind::UnknownColumns { .. }))
        .collect();
    if notes.is_empty() {
        return;
    }
    body.push_str("<section><h2>Notes</h2><ul class=findings>\n");
    for (file, note) in notes {
        let _ = writeln!(body, "<li class=note><code>{}</code> {}</li>", escape(file), escape(&note.to_string()));
    }
    body.push_str("</ul></section>\n");
}

fn torque_table(body: &mut String, found: &Identification) {
    let columns: Vec<(&str, &Accuracy)> = [
        ("fit", Some(&found.fit)),
        ("fit, unchanged file", found.fit_before.as_ref()),
        ("validation", found.validation.as_ref()),
        ("validation, unchanged file", found.validation_before.as_ref()),
    ]
    .into_iter()
    .filter_map(|(name, a)| Some((name, a?)))
    .collect();
    body.push_str("<div class=scroll><table><thead><tr><th>joint<th>torque RMS<br>N m");
    for (name, _) in &columns {
        let _ = write!(body, "<th>{name}<br>N m<th>%");
    }
    body.push_str("<th>NRMS<br>%<th>noise σ<br>N m<th>effective<br>samples</tr></thead><tbody>\n");
    for joint in 0..found.fit.rms.len() {
        let _ = write!(body, "<tr><th>{}<td>{}", joint + 1, figure(found.fit.torque_rms[joint]));
        for (_, a) in &columns {
            let share = a.percent_of_torque(joint);
            let bar = if share.is_finite() { share.min(100.0) } else { 0.0 };
            let _ = write!(body, "<td>{}<td class=bar style='--w:{bar:.1}%'>{}", figure(a.rms[joint]), percent(share));
        }
        let last = found.validation.as_ref().unwrap_or(&found.fit);
        let _ = writeln!(
            body,
            "<td>{}<td>{}<td>{:.0}</tr>",
            percent(100.0 * last.nrms[joint]),
            figure(found.noise.sigma[joint]),
            found.noise.effective_samples[joint]
        );
    }
    body.push_str("</tbody></table></div>\n");
}

pub(in crate::report) fn parameter_table(body: &mut String, found: &Identification) {
    let prior = found.parameters.iter().any(|p| p.prior.is_some());
    body.push_str("<div class=scroll><table class=parameters><thead><tr><th>parameter<th>value<th>± σ<th>σ %");
    if prior {
        body.push_str("<th>unchanged file");
    }
    body.push_str("<th class=words>unit<th class=words>grouping</tr></thead><tbody>\n");
    for p in &found.parameters {
        let relative = p.relative_std_percent();
        let (class, std, share) = match p.standing {
            Standing::Identified if relative < 10.0 => ("known", figure(p.std), percent(relative)),
            Standing::Identified if relative < 50.0 => ("fair", figure(p.std), percent(relative)),
            Standing::Identified => ("poor", figure(p.std), percent(relative)),
            Standing::NotIdentifiable => ("open", "open".into(), "–".into()),
            Standing::Dropped => ("open", "left out".into(), "–".into()),
        };
        let _ = write!(
            body,
            "<tr class={class}><th>{}<td>{}<td>{std}<td class=share>{share}",
            escape(&p.name),
            figure(p.value)
        );
        if prior {
            let _ = write!(body, "<td>{}", p.prior.map_or("–".into(), figure));
        }
        let grouping = p.grouping.split_once('=').map_or("", |(_, sum)| sum.trim());
        let _ =
            writeln!(body, "<td class=words>{}<td class='words grouping'>{}</tr>", escape(&p.unit), escape(grouping));
    }
    body.push_str("</tbody></table></div>\n");
}

fn open_questions(body: &mut String, found: &Identification) {
    for group in &found.confused {
        let names = escape(&group.parameters.join(", "));
        let _ = match group.parameters.len() == group.open {
            true => writeln!(body, "<p><b>{names}</b>: without effect in this data.</p>"),
            false => writeln!(
                body,
                "<p><b>{names}</b>: this data does not separate them; {} of their combinations are open.</p>",
                group.open
            ),
        };
    }
    if let Some(last) = found.dropped.last() {
        let names: Vec<&str> = found.dropped.iter().map(|d| d.name.as_str()).collect();
        let _ = writeln!(
            body,
            "<p>Left out as not essential, in this order: <b>{}</b>. Together they cost {} % of residual (F {} against a limit of {}).</p>",
            escape(&names.join(", ")),
            percent(last.residual_growth_percent),
            figure(last.f),
            figure(last.limit)
        );
    }
}

fn foot(body: &mut String, found: &Identification, provenance: &Provenance) {
    let c = found.condition;
    let weights = if found.weighted { "by each joint's noise" } else { "not at all" };
    let mut rows = vec![
        ("condition number".to_string(), format!("{} as measured, {} weighted, {} with columns of unit norm", figure(c.plain), figure(c.weighted), figure(c.scaled))),
        ("samples".into(), format!("{} over all joints, weighted {weights}, {} rounds", found.samples, found.iterations)),
        ("σ".into(), "from batches of the residual: correlation in time is accounted for; model errors that repeat with the motion are not noise, and not in it".into()),
    ];
    rows.extend(found.logs.iter().map(|log| {
        let role = if log.validates { "validation log" } else { "fit log" };
        (
            role.to_string(),
            format!(
                "{}: {} s, relative error {} %",
                log.name,
                figure(log.seconds),
                percent(log.accuracy.relative_error_percent())
            ),
        )
    }));
    rows.extend(provenance.iter().cloned());
    body.push_str("<section><h2>How this was made</h2><dl>\n");
    for (what, value) in rows {
        let _ = writeln!(body, "<dt>{}<dd>{}", escape(&what), escape(&value));
    }
    body.push_str("</dl></section>\n");
}

/// Curves as integers in steps of 1/4000 of their joint's range, finer than any screen, stored as
/// differences, which are short.
pub(in crate::report) fn curves(trace: &Trace) -> Value {
    let thick = trace.thinning > 1;
    let joints: Vec<Value> = trace
        .joints
        .iter()
        .map(|joint| {
            let values = || joint.measured.iter().chain(&joint.estimated).chain(&joint.residual).flatten();
            let largest = values().filter(|v| v.is_finite()).fold(0.0_f64, |m, v| m.max(v.abs()));
            let step = if largest > 0.0 { largest / 4000.0 } else { 1.0 };
            let pack = |curve: &[[f64; 2]]| {
                let side = |k: usize| differences(curve.iter().map(|v| (v[k] / step).round() as i64));
                if thick { json!([side(0), side(1)]) } else { json!([side(0)]) }
            };
            json!({
                "step": step,
                "measured": pack(&joint.measured),
                "estimated": pack(&joint.estimated),
                "residual": pack(&joint.residual),
            })
        })
        .collect();
    // Times in 0.1 ms.
    let time = differences(trace.time.iter().map(|t| (t * 1e4).round() as i64));
    let segment = differences(trace.segment.iter().map(|&s| s as i64));
    json!({ "time": time, "segment": segment, "joints": joints })
}

fn differences(values: impl Iterator<Item = i64>) -> Vec<i64> {
    values.scan(0, |last, v| Some(v - std::mem::replace(last, v))).collect()
}
