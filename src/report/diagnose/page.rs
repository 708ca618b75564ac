//! A diagnosis as one self-contained HTML page: verdict, gain, evidence per cause, torque and
//! errors, maps of the error.
//!
//! `page.js` draws the plots as SVG from numbers in the page. Before is orange and dashed, after
//! blue and solid, so that a monochrome print is readable.

use dh_codegen::robot::effects;
use std::fmt::Write;

use serde_json::{Value, json};

use crate::data::signal::Prepared;
use crate::diagnose::{Cause, Diagnosis, Evidence, Offered, measured_on};
use crate::report::Provenance;
use crate::report::Warnings;
use crate::report::diagnose::calibrate::{Identified, calibrate_verdict, most_improved_joint};
use crate::report::diagnose::doubts::doubts;
use crate::report::diagnose::text::for_the_file;
use crate::report::diagnose_verdict;
use crate::report::identify::page::{notes, parameter_table};
use crate::report::parts::budget;
use crate::report::parts::number::{digits, figure, percent};
use crate::report::parts::page::{Page, escape};

/// The page. `identified`: the identification that produced the robot file, if both were one run.
pub fn diagnose_html(
    found: &Diagnosis,
    logs: &[Prepared],
    warnings: &Warnings,
    identified: Option<&Identified<'_>>,
    provenance: &Provenance,
) -> String {
    let before = if identified.is_some() { "as identified" } else { "of the unchanged file" };
    let mut body = String::new();
    header(&mut body, found, identified.is_some());
    // With an identification, begin with the gain; otherwise with the recommended actions.
    if let Some(identified) = identified {
        most_improved(&mut body, found, true);
        let mut all = warnings.clone();
        identified.warnings.iter().for_each(|w| all.push(format!("Of the identification: {w}")));
        in_short(&mut body, found, &all);
    } else {
        in_short(&mut body, found, warnings);
        most_improved(&mut body, found, false);
    }
    gain_table(&mut body, found, identified.is_some());
    if !found.offer.why.is_empty() {
        let why: String = found.offer.why.iter().map(|w| format!("<li>{}", escape(w))).collect();
        let _ = writeln!(body, "<section><h2>Why this model</h2><ul>{why}</ul></section>");
    }
    if !found.causes.is_empty() {
        body.push_str("<section><h2>Causes</h2><p class=note>In order of what they gain, times the odds that they are there. Bars: RMS error of each joint <span class='key before'></span>with all causes but this one, <span class='key after'></span>with it; the line across is the joint's noise.</p>\n");
        for (number, c) in found.causes.iter().enumerate() {
            cause(&mut body, number, c, found.own_validation);
        }
        body.push_str("</section>\n");
    }
    next_experiment(&mut body, found);
    let _ = writeln!(
        body,
        "<section><h2>Torque and error, validation</h2><p class=note><span class='key measured'></span>measured torque (upper panel); error <span class='key before'></span>{before}, <span class='key after'></span>of the extended model (lower panel). N m over s, one log after the other.</p><div class=grid2 id=curves></div></section>"
    );
    let _ = writeln!(
        body,
        "<section><h2>Maps of the error</h2><p class=note>Mean error in bins, N m, <span class='key before'></span>{before}, <span class='key after'></span>of the extended model, on the validating data. A flat line at zero is a model that has nothing to learn from this quantity. With an axis of their own: amplitude of the error over frequency and over periods per turn of the joint, root mean square that depends on each other joint's motion, and root mean square that is left when the model is shifted in time (least at zero where nothing is late).</p><div id=maps></div></section>"
    );
    if let Some(identified) = identified {
        identification(&mut body, identified);
    }
    notes(&mut body, logs);
    foot(&mut body, found, provenance);
    let page = Page {
        title: format!("{} – diagnosis", found.robot),
        style: include_str!("page.css"),
        body: &body,
        data: data(found),
        script: include_str!("page.js"),
    };
    page.html()
}

/// Heading and verdict.
fn header(body: &mut String, found: &Diagnosis, calibrated: bool) {
    let (what, verdict) = match calibrated {
        true => ("Identification and diagnosis", calibrate_verdict(found)),
        false => ("Diagnosis", diagnose_verdict(found)),
    };
    let _ = writeln!(
        body,
        "<header><p class=kicker>{what}: {}</p><h1>{}</h1><p class=verdict>{}</p></header>",
        found.verdict.word().replace('_', " "),
        escape(&found.robot),
        escape(&verdict)
    );
}

/// The most improved joint, and the errors of all joints before and after.
fn most_improved(body: &mut String, found: &Diagnosis, calibrated: bool) {
    let before = if calibrated { "as identified" } else { "by the unchanged file" };
    let Some(joint) = most_improved_joint(found) else { return };
    let _ = writeln!(
        body,
        "<section><h2>Joint {}: measured and predicted torque</h2><p class=note><span class='key measured'></span>measured; predicted <span class='key before'></span>{before}, <span class='key after'></span>by the extended model. N m over s, on data that nothing was fitted to. Bars: error of each joint, percent of its torque's RMS.</p><div class=grid2 id=story data-joint={joint}></div></section>",
        joint + 1,
    );
}

/// The motion that would separate the ambiguous causes.
fn next_experiment(body: &mut String, found: &Diagnosis) {
    let Some(next) = &found.next_experiment else { return };
    let joints = match next.joints.as_slice() {
        [] => String::new(),
        [j] => format!(" of joint {j}"),
        many => format!(" of joints {}", join(many)),
    };
    let between: Vec<String> = next.between.iter().map(|c| words(c)).collect();
    let _ = writeln!(
        body,
        "<section><h2>Next experiment</h2><p><b>{}</b> would separate {}{joints}.</p></section>",
        escape(&next.motion),
        escape(&between.join(" from "))
    );
}

/// Parameters of the identification that produced the robot file.
fn identification(body: &mut String, identified: &Identified<'_>) {
    body.push_str("<section><h2>Parameters as identified</h2>\n");
    parameter_table(body, identified.found);
    body.push_str("</section>\n");
}

/// Data, settings and provenance.
fn foot(body: &mut String, found: &Diagnosis, provenance: &Provenance) {
    body.push_str("<section><h2>How this was made</h2><dl>\n");
    let validation = if found.own_validation {
        "logs of their own"
    } else {
        "the last three tenths of each stretch, kept out of the fit"
    };
    let links = match (found.links_refitted, found.has_links) {
        (true, true) => "all base parameters refitted",
        (true, false) => "base parameters fitted; the file has none",
        _ if found.transmission => "play no part: torques are the motors' less the joints'",
        _ => "the file's, unchanged",
    };
    let mut rows = vec![
        ("data", format!("{} s fitted, {} s validating", figure(found.seconds[0]), figure(found.seconds[1]))),
        ("validation", validation.to_string()),
        ("links", links.to_string()),
        ("noise", "sensors by fourth differences of the unfiltered torques between the reversals of the joint, their memory of some samples included, and the uncertainty of motion and clock; what a low-pass of some hundredths of a second left of it is missing".into()),
    ];
    rows.extend(provenance.iter().map(|(what, value)| (what.as_str(), value.clone())));
    for (what, value) in rows {
        let _ = writeln!(body, "<dt>{}<dd>{}", escape(what), escape(&value));
    }
    body.push_str("</dl></section>\n");
}

/// Table of the first causes, and the recommended actions.
fn in_short(body: &mut String, found: &Diagnosis, warnings: &Warnings) {
    let mut rows = String::new();
    for c in found.causes.iter().take(SHOWN) {
        let joints = if c.joints.is_empty() { "robot".to_string() } else { join(&c.joints) };
        let against = doubts(c).into_iter().next().unwrap_or_else(|| "–".into());
        let _ = write!(
            rows,
            "<tr><th>{}<td>{joints}<td>{:.2}<td class=words>{}</tr>",
            escape(&c.law.iter().fold(words(c.cause), |cause, law| format!("{cause}: {law}"))),
            c.probability,
            escape(&against)
        );
    }
    if !rows.is_empty() {
        let more = found.causes.len().saturating_sub(SHOWN);
        let more = if more > 0 { format!(" {more} more below.") } else { String::new() };
        let _ = writeln!(
            body,
            "<div class=scroll><table class=short><thead><tr><th>cause<th>joint<th>probability<th class=words>against it</tr></thead><tbody>{rows}</tbody></table></div><p class=note>In order of what they gain, times the odds that they are there.{more}</p>"
        );
    }
    let actions: String = actions(found).iter().map(|a| format!("<li>{}", escape(a))).collect();
    let _ = writeln!(body, "<ul class=actions>{actions}</ul>");
    body.push_str(&warnings.html());
}

/// Maximum number of causes in the first table.
const SHOWN: usize = 5;

/// Probability above which a cause is acted on; below it is a proposal.
const LIKELY: f64 = 0.8;

/// Recommended actions, in sentences.
fn actions(found: &Diagnosis) -> Vec<String> {
    let mut all = vec![match found.offer.offered {
        Offered::File => "Keep the robot file: nothing predicts surely better on data that were left out.".to_string(),
        Offered::Refitted if found.transmission => {
            "Use the refitted rotors and friction: no further cause predicts better on data that were left out.".into()
        }
        Offered::Refitted => {
            "Use the refitted parameters: no further cause predicts better on data that were left out.".into()
        }
        Offered::Extended => {
            "Use the extended model: it predicts better than the file and than a refit on data that were left out."
                .into()
        }
    }];
    let named = |c: &&Cause| c.cause != "unknown";
    let placed = |c: &Cause| match c.joints.as_slice() {
        [] => words(c.cause),
        joints => format!("{} ({})", words(c.cause), join(joints)),
    };
    let unsure: Vec<String> =
        found.causes.iter().filter(named).filter(|c| c.probability < LIKELY).map(placed).collect();
    if !unsure.is_empty() {
        all.push(format!(
            "Confirm on another log before you change the arm (joints in brackets): {}.",
            unsure.join(", ")
        ));
    }
    if let Some(next) = &found.next_experiment {
        let between: Vec<String> = next.between.iter().map(|c| words(c)).collect();
        all.push(format!("To tell {} apart, record {}.", between.join(" and "), next.motion));
    }
    let limited: Vec<usize> = found.budget.limited_by_motion().iter().map(|j| j + 1).collect();
    if !limited.is_empty() {
        all.push(format!(
            "Record positions better for joint{} {}: encoder and clock make most of the error there.",
            if limited.len() > 1 { "s" } else { "" },
            join(&limited)
        ));
    }
    all
}

/// Name of a cause with spaces.
fn words(cause: &str) -> String {
    cause.replace('_', " ")
}

fn join(joints: &[usize]) -> String {
    joints.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")
}

fn gain_table(body: &mut String, found: &Diagnosis, calibrated: bool) {
    let before = if calibrated { "identified" } else { "unchanged file" };
    let _ = writeln!(
        body,
        "<section><h2>What it gains</h2><div class=scroll><table><thead><tr><th>joint<th>torque<br>N m<th>{before}<br>N m<th>%<th>refitted<br>N m<th>%<th>extended<br>N m<th>%<th>where it<br>moves<th>noise<br>N m<th>gained of what<br>can be gained</tr></thead><tbody>"
    );
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
        let [before, after] = [&found.baseline, &found.extended].map(|errors| errors.moving[j].powi(2));
        let attainable = before - noise * noise;
        // If the file's error is close to its noise, the share is meaningless.
        let gained = if attainable > 0.2 * noise * noise && before > 0.0 {
            gained(before, after, attainable)
        } else {
            "–".into()
        };
        let _ = writeln!(body, "<td>{}<td>{}<td>{gained}</tr>", digits(found.extended.moving[j], 3), digits(noise, 3));
    }
    body.push_str("</tbody></table></div><p class=note>RMS of measured less predicted torque on the validating data, and in percent of the measured torque's own RMS. Refitted: base parameters and plain friction estimated again, no further cause. Gained: part of the squared error above the noise that the extended model takes where the joint moves.</p></section>\n");
    body.push_str(&budget::html(&found.budget, "the error of the extended model where joints move"));
}

/// Attained share of the possible gain, percent; for a loss the growth of the error.
fn gained(before: f64, after: f64, attainable: f64) -> String {
    let times = (after / before).sqrt();
    match times {
        2.0.. => format!("worse, {} times", digits(times, 2)),
        1.005.. => format!("worse by {:.0} %", 100.0 * (times - 1.0)),
        _ => format!("{:.0} %", (100.0 * (before - after) / attainable).clamp(0.0, 100.0)),
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
    if let Some(sentence) = for_the_file(c) {
        let _ = writeln!(body, "<p class=note>{}</p>", escape(&sentence));
    }
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
        let [low, high] = c.interval.map(|x| format!("{:.0}", 100.0 * x));
        let share = if low == high { low } else { format!("{low} to {high}") };
        let _ = writeln!(
            body,
            "<p class=note>It takes {share} % of the squared error of its main joint on {} (90 % interval, moving blocks of half a second).</p>",
            measured_on(c.on, own_validation)
        );
    }
    let against = doubts(c);
    if !against.is_empty() {
        let _ = writeln!(body, "<p class=open><b>Against it:</b> {}.</p>", escape(&against.join("; ")));
    }
    if !c.not_distinguished_from.is_empty() {
        let rivals: Vec<String> = c.not_distinguished_from.iter().map(|r| words(r)).collect();
        let _ = writeln!(
            body,
            "<p class=open><b>Not separated from {}</b> by this data; {} would separate them.</p>",
            escape(&rivals.join(", ")),
            escape(c.decided_by.unwrap_or(c.shown_by))
        );
    }
    if c.cause == effects::TimeDelay::NAME {
        body.push_str("<p class=note>It acts by shifting the torques in time, so it adds no curve of its own to draw against the error; the bars show what the shift gains.</p>\n");
    }
    let _ = writeln!(body, "<div class=grid2 data-cause={number}></div></article>");
}

/// The curve of a cause, if it is meaningful. A delay is compensated by shifting time and adds no
/// torque; its curve would be a misleading line at zero.
fn drawn(c: &Cause) -> Option<&Evidence> {
    c.curve.as_ref().filter(|e| c.cause != effects::TimeDelay::NAME && !e.x.is_empty())
}

/// Data for the script, rounded to the resolution of a plot.
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
    let shares =
        |errors: &[f64]| short(&errors.iter().zip(&found.torque_rms).map(|(e, t)| 100.0 * e / t).collect::<Vec<f64>>());
    let shares = json!({ "before": shares(&found.baseline.validate), "after": shares(&found.extended.validate) });
    json!({ "shares": shares, "causes": causes, "noise": short(&found.noise_floor), "curves": curves, "maps": maps })
}

/// Values rounded to a four-thousandth of the largest, finer than any screen; `null` for NaN and
/// infinity.
fn short(x: &[f64]) -> Vec<Value> {
    let largest = x.iter().filter(|v| v.is_finite()).fold(0.0_f64, |m, v| m.max(v.abs()));
    let decimals = if largest > 0.0 { (4.0 - largest.log10().floor()).clamp(0.0, 12.0) as usize } else { 0 };
    x.iter()
        .map(|v| {
            // Via text, so that the decimal number is written without the digits of a binary
            // fraction.
            let rounded = format!("{v:.decimals$}").parse::<f64>().unwrap_or(f64::NAN);
            if rounded.is_finite() { json!(rounded + 0.0) } else { Value::Null }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::gained;

    #[test]
    fn a_loss_is_told_by_its_size() {
        assert_eq!([4.0, 2.0, 0.9].map(|after| gained(4.0, after, 2.0)), ["0 %", "100 %", "100 %"]);
        assert_eq!(
            [4.01, 4.84, 36.0].map(|after| gained(4.0, after, 2.0)),
            ["0 %", "worse by 10 %", "worse, 3.0 times"]
        );
    }
}
