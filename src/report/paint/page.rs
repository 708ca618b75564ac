//! A painting motion as one self-contained HTML page: the wall, the path, the moving arm, joints
//! against their limits.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::apps::painting::{Coverage, Moment, Pattern, joint_torques};
use crate::data::trajectory::times;

use crate::report::Provenance;
use crate::report::paint::text::{Planned, uses};
use crate::report::parts::number::{figure, short};
use crate::report::parts::page::{Page, escape};
use crate::report::parts::stick_figure::StickFigures;

/// The page.
pub fn paint_html(planned: &Planned<'_>, provenance: &Provenance) -> String {
    let Planned { task, plan, seconds, warnings } = *planned;
    let (s, cover) = (&plan.strokes, plan.coverage());
    let mut body = String::new();
    let _ = writeln!(
        body,
        "<header><p class=kicker>Painting motion</p><h1>{}</h1><p class=verdict>{:.1} % of the wall in {:.2} s of contact, {} lanes; every limit is kept. Found in {seconds:.1} s.</p></header>",
        escape(&plan.robot),
        100.0 * cover.painted,
        plan.contact,
        s.lanes
    );
    body.push_str(&warnings.html());
    body.push_str("<section><h2>The wall</h2><p class=note><span class='key stroke'></span>strokes <span class='key shift'></span>steps to the next lane <span class='key roller'></span>roller at the start <span class='key once'></span>painted <span class='key twice'></span>on two lanes <span class='key bare'></span>not painted. As the robot sees it.</p><div id=wall></div>\n");
    let _ = writeln!(
        body,
        "<div class=scroll><table><thead><tr><th>variable of equation (12)<th>value</tr></thead><tbody><tr><th>T<sub>C</sub><td>{:.3} s<tr><th>Z<sub>u</sub><td>{:.4} m<tr><th>Z<sub>l</sub><td>{:.4} m<tr><th>Y<sub>0</sub><td>{:.4} m<tr><th>ΔY<td>{:.4} m (roller {:.4} m)<tr><th>cost<td>{} s<tr><th>jerk, ∫Σ dddq² dt<td>{} rad²/s⁵, times {} s per that<tr><th>area (Z<sub>u</sub> − Z<sub>l</sub>) ΔY<td>{} m², {} s m² over that",
        plan.contact,
        s.upper,
        s.lower,
        s.first,
        s.step,
        plan.roller.width,
        figure(plan.cost),
        figure(plan.jerk),
        task.weights.jerk,
        figure(task.area(s)),
        task.weights.area
    );
    if let Some(plain) = plan.cost_constant {
        let _ = writeln!(body, "<tr><th>cost with one swivel angle<td>{} s", figure(plain));
    }
    body.push_str("</tbody></table></div>\n");
    if !plan.sides.is_empty() {
        body.push_str("<h3>Unpainted sides, and why</h3><ul class=findings>\n");
        for side in &plan.sides {
            let _ = writeln!(body, "<li>{} side, {:.3} m: {}</li>", side.side, side.gap, escape(&side.bound));
        }
        body.push_str("</ul>\n");
    }
    body.push_str("</section>\n<section><h2>The path</h2><p class=note><span class='key y'></span>y <span class='key z'></span>z of the roller on the wall <span class='key swivel'></span>swivel angle, or the position of the joint that is given</p><div id=path></div></section>\n");
    body.push_str("<section><h2>The arm</h2><p class=note>Drag to turn. Spheres are those of the robot file, the grid is its ground.</p><div id=arm></div></section>\n");
    body.push_str("<section><h2>Joints against their limits</h2><p class=note><span class='key q'></span>position <span class='key dq'></span>speed <span class='key ddq'></span>acceleration <span class='key tau'></span>torque of the model with the wall's push, each in percent of its limit (positions from the middle of the range). Move over a plot for values.</p><div class=plots id=joints></div>\n<div class=scroll><table><thead><tr><th>joint<th>to the end<br>of its travel<th>speed<th>limit<th>acceleration<th>limit<th>torque<th>limit</tr></thead><tbody>\n");
    for (u, l) in uses(task, plan).iter().zip(&task.limits) {
        let torque = if task.standard.is_some() { figure(u.peak[2]) } else { "–".into() };
        let _ = writeln!(
            body,
            "<tr><th>{}<td>{}<td>{}<td>{}<td>{}<td>{}<td>{torque}<td>{}</tr>",
            escape(&l.name),
            figure(u.margin),
            figure(u.peak[0]),
            figure(l.velocity),
            figure(u.peak[1]),
            figure(l.acceleration),
            l.torque.map_or("–".into(), figure)
        );
    }
    body.push_str("</tbody></table></div>\n");
    body.push_str("</section>\n<section><h2>Legs</h2><div class=scroll><table><thead><tr><th>leg<th>from<br>s<th>to<br>s<th>y<br>m<th>z<br>m<th>swivel<br>rad<th>would be shorter but for</tr></thead><tbody>\n");
    for span in &plan.spans {
        let _ = writeln!(
            body,
            "<tr><th>{}<td>{:.3}<td>{:.3}<td>{:.4}<td>{:.4}<td>{:.4}<td class=words>{}</tr>",
            span.phase.name(),
            span.time[0],
            span.time[1],
            span.to[0],
            span.to[1],
            span.to[3],
            escape(&span.bound)
        );
    }
    body.push_str("</tbody></table></div></section>\n<footer><h2>Provenance</h2><dl>\n");
    for (what, value) in provenance {
        let _ = writeln!(body, "<dt>{}<dd>{}", escape(what), escape(value));
    }
    body.push_str("</dl></footer>\n");
    let page = Page {
        title: format!("{} – painting motion", plan.robot),
        style: concat!(include_str!("../excite/page.css"), include_str!("page.css")),
        body: &body,
        data: data(planned, &cover),
        script: concat!(include_str!("../excite/page.js"), "\n", include_str!("page.js")),
    };
    page.html()
}

/// Data of the scripts: the keys of the excitation's page, followed by the wall.
fn data(planned: &Planned<'_>, cover: &Coverage) -> Value {
    let Planned { task, plan, .. } = *planned;
    let (n, duration) = (task.dof(), plan.duration());
    let time = times(duration, (900.0 / duration).min(50.0));
    let moments: Vec<Moment> = time.iter().map(|t| plan.at(*t)).collect();
    let (curves, torque) = (Moment::states(n, &moments), joint_torques(task, &moments));
    let joints: Vec<Value> = (0..n)
        .map(|j| {
            let l = &task.limits[j];
            let len = moments.len();
            let of = |part: &[f64]| part[j * len..(j + 1) * len].iter().map(|x| short(*x, 4)).collect::<Vec<_>>();
            json!({
                "name": l.name, "position": l.position, "velocity": l.velocity, "acceleration": l.acceleration,
                "torque": l.torque.filter(|_| task.standard.is_some()),
                "q": of(&curves.q), "dq": of(&curves.dq), "ddq": of(&curves.ddq), "tau": of(&torque),
            })
        })
        .collect();
    let place = |i: usize| moments.iter().map(|m| short(m.place[i], 4)).collect::<Vec<_>>();
    json!({
        "time": time.iter().map(|t| short(*t, 4)).collect::<Vec<_>>(),
        "joints": joints,
        "moments": figure_times(duration).iter().map(|t| short(*t, 3)).collect::<Vec<_>>(),
        "figures": figures(planned),
        "radii": task.bodies.balls.iter().map(|b| b.radius).collect::<Vec<_>>(),
        "boxes": task.bodies.blocks.iter().map(|b| json!([b.min, b.max])).collect::<Vec<_>>(),
        "outlines": [outline(planned)],
        "ground": task.bodies.ground.as_ref().map(|g| g.0),
        "criterion": "", "history": [],
        "place": {
            "y": place(0), "z": place(1),
            "swivel": task.redundancy().map(|_| moments.iter().map(|m| short(m.swivel, 4)).collect::<Vec<_>>()),
        },
        "wall": {
            "sides": plan.surface.sides(), "ends": plan.surface.ends(), "cells": cover.cells, "passes": runs(cover),
            "cycle": if plan.strokes.pattern == Pattern::Cycle { 2 } else { 1 }, "width": plan.roller.width,
            "spans": plan.spans.iter().map(|s| json!({"phase": s.phase.name(), "from": s.from, "to": s.to})).collect::<Vec<_>>(),
        },
    })
}

fn figure_times(duration: f64) -> Vec<f64> {
    times(duration, (300.0 / duration).min(25.0))
}

/// Frames, roller and spheres of the moving arm.
fn figures(planned: &Planned<'_>) -> Vec<Value> {
    let Planned { task, plan, .. } = *planned;
    let moments: Vec<Moment> = figure_times(plan.duration()).iter().map(|t| plan.at(*t)).collect();
    let (len, count) = (moments.len(), task.arm.frame_count());
    let mut frames = vec![0.0; count * 12 * len];
    task.arm.frames(&Moment::states(task.dof(), &moments), &mut frames);
    let figures = StickFigures { frames: &frames, len, balls: &task.bodies.balls };
    let across = plan.surface.across();
    moments
        .iter()
        .enumerate()
        .map(|(s, m)| {
            // Roller: both ends, then its middle, whose path is drawn.
            let end = |side: f64| (0..3).map(move |i| m.point[i] + side * plan.roller.width * across[i]);
            let roller = m.point.into_iter().chain(end(0.5)).chain(end(-0.5)).chain(m.point).map(|x| short(x, 3));
            let points: Vec<f64> = figures.joints(s).into_iter().chain(roller).collect();
            json!([points, figures.balls(s)])
        })
        .collect()
}

/// Outline of the wall in space.
fn outline(planned: &Planned<'_>) -> Vec<[f64; 3]> {
    let surface = &planned.plan.surface;
    let ([left, right], [low, high]) = (surface.sides(), surface.ends());
    let corners = [[left, low], [right, low], [right, high], [left, high], [left, low]];
    corners.iter().map(|&[y, z]| surface.point([y, z, 0.0])).collect()
}

/// Run-length encoding of the cells: row, first, count, passes, rows; equal rows are merged.
fn runs(cover: &Coverage) -> Vec<[usize; 5]> {
    let [across, along] = cover.cells;
    let row = |k: usize| -> Vec<[usize; 3]> {
        let mut out: Vec<[usize; 3]> = Vec::new();
        for i in 0..across {
            let n = usize::from(cover.passes[k * across + i]);
            match out.last_mut() {
                Some([_, count, same]) if *same == n => *count += 1,
                _ => out.push([i, 1, n]),
            }
        }
        out
    };
    let mut all: Vec<[usize; 5]> = Vec::new();
    let mut k = 0;
    while k < along {
        let here = row(k);
        let rows = 1 + (k + 1..along).take_while(|&r| row(r) == here).count();
        all.extend(here.iter().map(|&[i, count, n]| [k, i, count, n, rows]));
        k += rows;
    }
    all
}
