//! An exciting motion as one self-contained HTML page: curves against limits, history, the moving
//! arm, expected precision.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::report::Provenance;
use crate::report::excite::text::Outcome;
use crate::report::parts::number::{figure, percent, short};
use crate::report::parts::page::{Page, escape};
use crate::report::parts::stick_figure::StickFigures;

/// The page.
pub fn excite_html(outcome: &Outcome<'_>, provenance: &Provenance) -> String {
    let Outcome { task, found, expected, tried, seconds, warnings } = *outcome;
    let name = escape(task.arm.name());
    let mut body = String::new();
    let _ = writeln!(
        body,
        "<header><p class=kicker>Exciting motion</p><h1>{name}</h1><p class=verdict>{} s, {} = {}, condition number {}{}. {}</p></header>",
        found.trajectory.duration(),
        found.criterion,
        figure(found.value),
        figure(found.plain.condition),
        if found.feasible { "; every limit is kept" } else { "; <b>not every limit is kept</b>" },
        if found.stopped { "Stopped early." } else { "" }
    );
    body.push_str(&warnings.html());
    body.push_str("<section><h2>The arm</h2><p class=note>Drag to turn. Spheres are those of the robot file, the grid is its ground.</p><div id=arm></div></section>\n");
    body.push_str("<section><h2>Torque, ground, spheres: what is closest</h2><p class=note>Positions, speeds and accelerations stand against their limits below.</p><div class=scroll><table><thead><tr><th>condition<th>at<br>s</tr></thead><tbody>\n");
    for worst in &found.closest {
        let _ = writeln!(body, "<tr><th>{}<td>{:.2}</tr>", escape(&worst.what), worst.time);
    }
    body.push_str("</tbody></table></div>\n");
    body.push_str("</section>\n<section><h2>Joints against their limits</h2><p class=note><span class='key q'></span>position <span class='key dq'></span>speed <span class='key ddq'></span>acceleration <span class='key tau'></span>torque of the nominal model, each in percent of its limit (positions from the middle of the range). Move over a plot for values.</p><div class=plots id=joints></div></section>\n");
    let _ = writeln!(
        body,
        "<section><h2>How it was found</h2><p class=note>The minimised form of the criterion over the steps of each start; bright where every limit is kept. {} starts, of which the better third went on; {:.1} s.</p><div id=history></div></section>",
        found.starts.len(),
        seconds
    );
    if !tried.is_empty() {
        body.push_str("<section><h2>How short can it be?</h2><div class=scroll><table><thead><tr><th>duration<br>s<th>largest relative σ<br>%</tr></thead><tbody>\n");
        for (duration, worst) in tried {
            let _ = writeln!(body, "<tr><th>{duration}<td>{}</tr>", worst.map_or("no feasible motion".into(), percent));
        }
        body.push_str("</tbody></table></div></section>\n");
    }
    body.push_str("<section><h2>Expected precision</h2><p class=note>Standard deviation of each estimate from the information of this motion and the noise that was given (or half a percent of the torque limits). Grey: its share in every joint's torque stays below the noise.</p><div class=scroll><table><thead><tr><th>parameter<th>nominal<th>σ<th>%σ</tr></thead><tbody>\n");
    for e in expected {
        let class = if e.essential == Some(false) { " class=open" } else { "" };
        let relative = e.relative_percent();
        let _ = writeln!(
            body,
            "<tr{class}><th>{}<td>{}<td>{}<td class=bar style='--w:{:.1}%'>{}</tr>",
            escape(&e.name),
            e.value.map_or("–".into(), figure),
            figure(e.std),
            relative.unwrap_or(0.0).min(100.0),
            relative.map_or("–".into(), percent)
        );
    }
    body.push_str("</tbody></table></div></section>\n<footer><h2>Provenance</h2><dl>\n");
    for (what, value) in provenance {
        let _ = writeln!(body, "<dt>{}<dd>{}", escape(what), escape(value));
    }
    body.push_str("</dl></footer>\n");
    let page = Page {
        title: format!("{} – exciting motion", task.arm.name()),
        style: include_str!("page.css"),
        body: &body,
        data: data(outcome),
        script: include_str!("page.js"),
    };
    page.html()
}

/// Curves at some hundred instants; positions of frames and spheres at fewer.
fn data(outcome: &Outcome<'_>) -> Value {
    let Outcome { task, found, .. } = *outcome;
    let duration = found.trajectory.duration();
    let rate = (600.0 / duration).min(50.0);
    let (times, states) = found.trajectory.sampled(rate);
    let (n, len) = (task.dof(), times.len());
    let mut torque = vec![0.0; n * len];
    if let Some(standard) = &task.standard {
        task.arm.inverse_dynamics(&states, standard, &mut torque);
    }
    let joints: Vec<Value> = (0..n)
        .map(|j| {
            let l = &task.limits[j];
            let of = |part: &[f64]| part[j * len..(j + 1) * len].iter().map(|x| short(*x, 4)).collect::<Vec<_>>();
            json!({
                "name": l.name, "position": l.position, "velocity": l.velocity, "acceleration": l.acceleration,
                "torque": l.torque.filter(|_| task.standard.is_some()),
                "q": of(&states.q), "dq": of(&states.dq), "ddq": of(&states.ddq), "tau": of(&torque),
            })
        })
        .collect();
    let (moments, poses) = found.trajectory.sampled((250.0 / duration).min(25.0));
    let count = task.arm.frame_count();
    let mut frames = vec![0.0; count * 12 * moments.len()];
    task.arm.frames(&poses, &mut frames);
    let figures = StickFigures { frames: &frames, len: moments.len(), balls: &task.bodies.balls };
    let unit = if matches!(found.criterion, "logdet" | "hadamard") { task.columns().count() as f64 } else { 1.0 };
    let shown = |value: f64| match found.criterion {
        "cond" | "trace" | "smallest" => value.exp(),
        _ => value * unit,
    };
    json!({
        "time": times.iter().map(|t| short(*t, 4)).collect::<Vec<_>>(),
        "joints": joints,
        "moments": moments.iter().map(|t| short(*t, 3)).collect::<Vec<_>>(),
        "figures": (0..moments.len()).map(|s| json!([figures.joints(s), figures.balls(s)])).collect::<Vec<_>>(),
        "radii": task.bodies.balls.iter().map(|b| b.radius).collect::<Vec<_>>(),
        "boxes": task.bodies.blocks.iter().map(|b| json!([b.min, b.max])).collect::<Vec<_>>(),
        "ground": task.bodies.ground.as_ref().map(|g| g.0),
        "criterion": found.criterion,
        "history": found.history.iter().map(|r| json!([r.start, short(shown(r.value), 4), r.worst <= 0.0])).collect::<Vec<_>>(),
    })
}
