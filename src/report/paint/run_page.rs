//! A run against the wall as one self-contained HTML page.

use std::fmt::Write;

use serde_json::json;

use crate::apps::painting::Plan;
use crate::apps::painting::run::{Feedback, ForceErrors, Law, Run};
use crate::report::Provenance;
use crate::report::Warnings;
use crate::report::paint::run::{NOT_COMPARED, differences, gain_margin, status};
use crate::report::paint::trace;
use crate::report::parts::number::digits;
use crate::report::parts::page::{Page, escape};

/// A run with its context.
pub struct Painted<'a> {
    /// Result of the run.
    pub run: &'a Run,
    /// The executed plan.
    pub plan: &'a Plan,
    /// Desired force, N.
    pub force: f64,
    /// Force used in the feedback.
    pub feedback: Feedback,
    /// Feedforward terms.
    pub law: Law,
    /// Force errors of each coat, that of `run` last.
    pub coats: &'a [ForceErrors],
    /// Warnings that precede the figures.
    pub warnings: &'a Warnings,
}

/// The page.
pub fn paint_run_html(painted: &Painted<'_>, provenance: &Provenance) -> String {
    let Painted { run, plan, force, law, coats, warnings, .. } = painted;
    let mut body = String::new();
    header(&mut body, painted);
    let axes = [plan.surface.across(), plan.surface.up];
    body.push_str(&(warnings.html() + "<section><h2>The force</h2>"));
    trace::force(&mut body, &run.trace, *force, "Force along the wall's normal");
    body.push_str("<div class=scroll><table><thead><tr><th>difference, root mean square<th>N<th>% of the desired</tr></thead><tbody>");
    for (name, value) in differences(run).into_iter().filter(|(_, value)| value.is_finite()) {
        let _ = writeln!(body, "<tr><th>{name}<td>{}<td>{}", digits(value, 3), digits(100.0 * value / force, 2));
    }
    body.push_str("</tbody></table></div>");
    if coats.len() > 1 {
        body.push_str("<p class=note>Shown is the last coat. Each but the first was fed the displacement that the coats before had learned.</p><div class=scroll><table><thead><tr><th>coat<th>estimated less measured, N<th>estimated less desired, N<th>measured less desired, N</tr></thead><tbody>");
        for (k, a) in coats.iter().enumerate() {
            let [em, ed, md] = [a.estimated_measured, a.estimated_desired, a.measured_desired].map(|x| digits(x, 3));
            let _ = writeln!(body, "<tr><th>{}<td>{em}<td>{ed}<td>{md}", k + 1);
        }
        body.push_str("</tbody></table></div>");
    }
    body.push_str("</section>\n<section><h2>The path</h2>");
    trace::path(&mut body, &run.trace, axes, "Path of the roller on the wall");
    trace::aside(&mut body, &run.trace, axes, ["across", "up"]);
    let f = &run.tuning.force;
    let _ = writeln!(
        body,
        "</section>\n<section><h2>Gains, as proposed</h2><p class=note>Equations (13) and (15); fed forward: {} of the desired force, {} of the planned motion's torques, {} of the force aside, {} of the drag predicted. Force loop: Kp {} m/N, Ki {} m/(N s), crossover {} rad/s, phase margin {}°, {}, the worst of nine postures.</p><div class=scroll><table><thead><tr><th>joint<th>Kp<br>N m/rad<th>Kd<br>N m s/rad<th>bandwidth<br>rad/s<th>phase margin<br>°</tr></thead><tbody>",
        digits(law.carry, 2),
        digits(law.feed, 2),
        digits(law.aside, 2),
        digits(law.drag, 2),
        digits(f.kp, 3),
        digits(f.ki, 3),
        digits(f.margins.crossover, 3),
        digits(f.margins.phase, 3),
        gain_margin(f.margins.gain)
    );
    for (j, p) in run.tuning.joints.iter().enumerate() {
        let _ = writeln!(
            body,
            "<tr><th>{}<td>{}<td>{}<td>{}<td>{}",
            j + 1,
            digits(p.kp, 3),
            digits(p.kd, 3),
            digits(p.bandwidth, 3),
            digits(p.margins.phase, 3)
        );
    }
    body.push_str("</tbody></table></div></section>\n<footer><h2>Provenance</h2><dl>\n");
    for (what, value) in provenance {
        let _ = writeln!(body, "<dt>{}<dd>{}", escape(what), escape(value));
    }
    body.push_str("</dl></footer>\n");
    Page {
        title: format!("{} – painting under force control", plan.robot),
        style: include_str!("../reproduce/page.css"),
        body: &body,
        data: json!({}),
        script: "",
    }
    .html()
}

/// Heading: the task and the main errors, in a sentence or two.
fn header(body: &mut String, painted: &Painted<'_>) {
    let Painted { run, plan, force, feedback, .. } = painted;
    let fed = match feedback {
        Feedback::Estimated => "the force estimated from the joint torques",
        Feedback::Measured => "the force measured in the wall",
    };
    let a = &run.accuracy;
    let figures = match [a.measured_desired, a.estimated_measured, run.tracking].iter().all(|x| x.is_finite()) {
        true => format!(
            "Measured less desired force {} N, estimated less measured {} N, roller {} mm aside of its path (root mean squares);",
            digits(a.measured_desired, 2),
            digits(a.estimated_measured, 2),
            digits(1e3 * run.tracking, 2)
        ),
        false => NOT_COMPARED.into(),
    };
    let _ = writeln!(
        body,
        "<header><p class=kicker>Painting under force control</p><h1>{}</h1><p class=verdict>{} N on the wall, {fed} in the feedback: {}. {figures} {} s without pressing.</p></header>",
        escape(&plan.robot),
        digits(*force, 3),
        escape(&status(run)),
        digits(run.off, 3)
    );
}
