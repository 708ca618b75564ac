//! A diagnosis as one page that needs no network: verdict, gain, evidence per cause, torque and
//! errors, maps of the error.
//!
//! The plots are drawn by `diagnose.js` as SVG from numbers in the page; before is orange and
//! dashed, after blue and solid, so that a print without colour can be read too.

use dh_codegen::robot::effects;
use std::fmt::Write;

use serde_json::{Value, json};

use crate::data::signal::Prepared;
use crate::diagnose::{Cause, Diagnosis, Evidence, measured_on};
use crate::report::Provenance;
use crate::report::Warnings;
use crate::report::diagnose_verdict;
use crate::report::identify::page::notes;
use crate::report::parts::budget;
use crate::report::parts::number::{digits, figure, percent};
use crate::report::parts::page::{Page, escape};

/// The page.
pub fn diagnose_html(found: &Diagnosis, logs: &[Prepared], warnings: &Warnings, provenance: &Provenance) -> String {
    let name = escape(&found.robot);
    let mut body = String::new();
    let _ = writeln!(
        body,
        "<header><p class=kicker>Diagnosis: {}</p><h1>{name}</h1><p class=verdict>{}</p></header>",
        found.verdict.word().replace('_', " "),
        escape(&diagnose_verdict(found))
    );
    body.push_str(&warnings.html());
    gain_table(&mut body, found);
    if !found.offer.why.is_empty() {
        let why: String = found.offer.why.iter().map(|w| format!("<li>{}", escape(w))).collect();
        let _ = writeln!(body, "<section><h2>Why this model</h2><ul>{why}</ul></section>");
    }
    if !found.causes.is_empty() {
        body.push_str("<section><h2>Causes</h2><p class=note>In order of what they gain. Bars: RMS error of each joint <span class='key before'></span>with all causes but this one, <span class='key after'></span>with it; the line across is the joint's noise.</p>\n");
        for (number, c) in found.causes.iter().enumerate() {
            cause(&mut body, number, c, found.own_validation);
        }
        body.push_str("</section>\n");
    }
    if let Some(next) = &found.next_experiment {
        let joints = match next.joints.as_slice() {
            [] => String::new(),
            [j] => format!(" of joint {j}"),
            many => format!(" of joints {}", join(many)),
        };
        let between: Vec<String> = next.between.iter().map(|c| words(c)).collect();
        let _ = writeln!(
            body,
            "<section><h2>Next experiment</h2><p>Would tell {}{joints} apart: <b>{}</b>.</p></section>",
            escape(&between.join(" from ")),
            escape(&next.motion)
        );
    }
    body.push_str("<section><h2>Torque and error, validation</h2><p class=note><span class='key measured'></span>measured torque (upper panel); error <span class='key before'></span>of the file as it is, <span class='key after'></span>of the extended model (lower panel). N m over s, one log after the other.</p><div class=grid2 id=curves></div></section>\n");
    body.push_str("<section><h2>Maps of the error</h2><p class=note>Mean error in bins, N m, <span class='key before'></span>of the file as it is, <span class='key after'></span>of the extended model, on the validating data. A flat line at zero is a model that has nothing to learn from this quantity. With an axis of their own: amplitude of the error over frequency and over periods per turn of the joint, root mean square of what goes with each other joint's motion, and root mean square that is left when the model is shifted in time (least at zero where nothing is late).</p><div id=maps></div></section>\n");
    notes(&mut body, logs);
    body.push_str("<section><h2>How this was made</h2><dl>\n");
    let validation = if found.own_validation {
        "logs of their own"
    } else {
        "the last three tenths of each stretch, kept out of the fit"
    };
    let links = match (found.links_refitted, found.has_links) {
        (true, true) => "all base parameters fitted anew",
        (true, false) => "base parameters fitted; the file has none",
        _ => "the file's, unchanged",
    };
    let mut rows = vec![
        ("data", format!("{} s fitted, {} s validating", figure(found.seconds[0]), figure(found.seconds[1]))),
        ("validation", validation.to_string()),
        ("links", links.to_string()),
        ("noise", "sensors by fourth differences of the torques as recorded, and what is not known of motion and clock; sensors' noise that was low-passed before it was recorded is not in it".into()),
    ];
    rows.extend(provenance.iter().map(|(what, value)| (what.as_str(), value.clone())));
    for (what, value) in rows {
        let _ = writeln!(body, "<dt>{}<dd>{}", escape(what), escape(&value));
    }
    body.push_str("</dl></section>\n");
    let page = Page {
        title: format!("{} – diagnosis", found.robot),
        style: include_str!("page.css"),
        body: &body,
        data: data(found),
        script: include_str!("page.js"),
    };
    page.html()
}

/// An identifier of the vocabulary as words.
fn words(cause: &str) -> String {
    cause.replace('_', " ")
}

fn join(joints: &[usize]) -> String {
    joints.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")
}

fn gain_table(body: &mut String, found: &Diagnosis) {
    body.push_str("<section><h2>What it gains</h2><div class=scroll><table><thead><tr><th>joint<th>torque<br>N m<th>file as it is<br>N m<th>%<th>refitted<br>N m<th>%<th>extended<br>N m<th>%<th>noise<br>N m<th>gained of what<br>can be gained</tr></thead><tbody>\n");
    for j in 0..found.noise_floor.len() {
        let torque = found.torque_rms[j];
        let noise = found.noise_floor[j];
        let _ = write!(body, "<tr><th>{}<td>{}", j + 1, digits(torque, 3));
        for errors in [&found.baseline, &found.refitted, &found.extended] {
            let share = 100.0 * errors.validate[j] / torque;
            let bar = if share.is_finite() { share.clamp(0.0, 100.0) } else { 0.0 };
            let _ = write!(
                body,
                "<td>{}<td class=bar style='--w:{bar:.1}%'>{}",
                digits(errors.validate[j], 3),
                percent(share)
            );
        }
        let (before, after) = (found.baseline.validate[j].powi(2), found.extended.validate[j].powi(2));
        let attainable = before - noise * noise;
        // Where the file errs by little more than its noise, the share says nothing.
        let gained = if attainable > 0.2 * noise * noise && before > 0.0 {
            gained(before, after, attainable)
        } else {
            "–".into()
        };
        let _ = writeln!(body, "<td>{}<td>{gained}</tr>", digits(noise, 3));
    }
    body.push_str("</tbody></table></div><p class=note>RMS of measured less predicted torque on the validating data, and in percent of the measured torque's own RMS. Refitted: base parameters and plain friction anew, no further cause. Gained: part of the squared error above the noise that the extended model takes.</p></section>\n");
    body.push_str(&budget::html(&found.budget, "the error of the extended model"));
}

/// What part of the attainable gain was reached, percent; of a loss how many times the error grew.
fn gained(before: f64, after: f64, attainable: f64) -> String {
    match after > before {
        true => format!("worse, {} times", digits((after / before).sqrt(), 2)),
        false => format!("{:.0} %", (100.0 * (before - after) / attainable).min(100.0)),
    }
}

fn cause(body: &mut String, number: usize, c: &Cause, own_validation: bool) {
    let place = match c.joints.as_slice() {
        [] => "whole robot".to_string(),
        [j] => format!("joint {j}"),
        many => format!("joints {}", join(many)),
    };
    let _ = writeln!(
        body,
        "<article class=cause><h3>{}. {} <span class=place>{place}</span> <span class=probability>probability {:.2}</span></h3><p>{}.</p>",
        number + 1,
        escape(&words(c.cause)),
        c.probability,
        escape(c.evidence.trim_end_matches('.'))
    );
    if !c.parameters.is_empty() {
        body.push_str(
            "<div class=scroll><table class=parameters><thead><tr><th>parameter<th>value<th>± σ</tr></thead><tbody>\n",
        );
        for p in &c.parameters {
            let std = p.std.map_or("–".into(), |s| digits(s, 2));
            let _ = writeln!(body, "<tr><th>{}<td>{}<td>{std}</tr>", escape(&p.symbol), figure(p.value));
        }
        body.push_str("</tbody></table></div>\n");
    }
    if c.interval.iter().all(|x| x.is_finite()) {
        let _ = writeln!(
            body,
            "<p class=note>It takes {:.0} to {:.0} % of the squared error of its main joint on {} (90 % interval, moving blocks of half a second).</p>",
            100.0 * c.interval[0],
            100.0 * c.interval[1],
            measured_on(c.on, own_validation)
        );
    }
    if !c.not_distinguished_from.is_empty() {
        let rivals: Vec<String> = c.not_distinguished_from.iter().map(|r| words(r)).collect();
        let _ = writeln!(
            body,
            "<p class=open><b>Not told apart from {}</b> by this data; what would: {}.</p>",
            escape(&rivals.join(", ")),
            escape(c.shown_by)
        );
    }
    if c.cause == effects::TimeDelay::NAME {
        body.push_str("<p class=note>It acts by shifting the torques in time, so it adds no curve of its own to draw against the error; the bars show what the shift gains.</p>\n");
    }
    let _ = writeln!(body, "<div class=grid2 data-cause={number}></div></article>");
}

/// The curve, where it shows its cause: a delay is taken out by shifting time, adds no torque of
/// its own, and would be a misleading line at zero.
fn drawn(c: &Cause) -> Option<&Evidence> {
    c.curve.as_ref().filter(|e| c.cause != effects::TimeDelay::NAME && !e.x.is_empty())
}

/// Numbers for the script, with the digits that a plot shows.
fn data(found: &Diagnosis) -> Value {
    let causes: Vec<Value> = found
        .causes
        .iter()
        .map(|c| {
            let curve = drawn(c).map(|e| {
                json!({ "over": e.over, "x": short(&e.x), "measured": short(&e.measured), "explained": short(&e.explained) })
            });
            json!({ "curve": curve, "before": short(&c.rms_before), "after": short(&c.rms_after) })
        })
        .collect();
    let curves: Vec<Value> = found
        .curves
        .iter()
        .map(|c| json!({ "t": short(&c.t), "measured": short(&c.measured), "before": short(&c.before), "after": short(&c.after) }))
        .collect();
    let maps: Vec<Vec<Value>> = found
        .maps
        .iter()
        .map(|joint| {
            let one = |m: &crate::diagnose::ErrorMap| json!({ "over": m.over, "x": short(&m.x), "before": short(&m.before), "after": short(&m.after) });
            joint.iter().map(one).collect()
        })
        .collect();
    json!({ "causes": causes, "noise": short(&found.noise_floor), "curves": curves, "maps": maps })
}

/// Rounded to a four-thousandth of the largest: finer than any screen. What is no number is `null`.
fn short(x: &[f64]) -> Vec<Value> {
    let largest = x.iter().filter(|v| v.is_finite()).fold(0.0_f64, |m, v| m.max(v.abs()));
    let decimals = if largest > 0.0 { (4.0 - largest.log10().floor()).clamp(0.0, 12.0) as usize } else { 0 };
    x.iter()
        .map(|v| {
            // By way of text: what is written is what is meant, without the tail of a binary
            // fraction.
            let rounded = format!("{v:.decimals$}").parse::<f64>().unwrap_or(f64::NAN);
            if rounded.is_finite() { json!(rounded + 0.0) } else { Value::Null }
        })
        .collect()
}
