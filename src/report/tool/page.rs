//! The carried body as one self-contained HTML page.
//!
//! Curves are drawn by the script of the identification's page; static drawings are SVG written
//! here.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::data::signal::Prepared;
use crate::identify::tool::{Found, Recognition, Relative, RobotErrors, names};
use crate::identify::{Standing, Trace};
use crate::report::Provenance;
use crate::report::Warnings;
use crate::report::identify::page::{curves, notes};
use crate::report::parts::number::{digits, figure, percent};
use crate::report::parts::page::{Page, escape};
use crate::report::tool::text::{empty_hand, misfit};
use crate::report::tool_verdict;

/// Maximum number of tools in a figure.
const SHOWN: usize = 12;

fn title(found: &Found) -> String {
    match &found.recognition {
        Some(r) if !r.rejected => r.nearest().name.clone(),
        _ if empty_hand(&found.carried) => "nothing in the hand".into(),
        Some(_) => "none of the known tools".into(),
        None => "what it carries".into(),
    }
}

/// The page.
pub fn tool_html(
    found: &Found,
    logs: &[Prepared],
    warnings: &Warnings,
    traces: &[Trace],
    provenance: &Provenance,
) -> String {
    let carried = &found.carried;
    let mut body = String::new();
    let _ = writeln!(
        body,
        "<header><p class=kicker>Tool of {}</p><h1>{}</h1><p class=verdict>{}</p></header>",
        escape(&carried.robot),
        escape(&title(found)),
        escape(&tool_verdict(found))
    );
    body.push_str(&warnings.html());
    notes(&mut body, logs);
    parameters(&mut body, found);
    workshop(&mut body, found);
    if let Some(recognition) = &found.recognition {
        ranking(&mut body, recognition);
        space(&mut body, recognition);
    }
    if let Some(relative) = &found.relative {
        size(&mut body, relative, found);
    }
    torque_table(&mut body, found);
    for (index, trace) in traces.iter().enumerate() {
        let role =
            if carried.logs.iter().any(|l| l.loaded && l.name == trace.name) { "With the tool" } else { "Empty hand" };
        let _ = writeln!(
            body,
            "<section><h2>{role}: <code>{}</code></h2><p class=note><span class='key measured'></span>measured <span class='key estimated'></span>estimated <span class='key residual'></span>residual (its own panel), N m over s. Drag to zoom all joints, double-click to go back.</p><div class=plots data-trace={index}></div></section>",
            escape(&trace.name)
        );
    }
    body.push_str("<section><h2>Correlation of the ten</h2><p class=note>Blue: if one is estimated too high, so is the other. Red: the other way about.</p><div id=correlation></div></section>\n");
    foot(&mut body, found, provenance);
    let correlation: Vec<Value> = (0..100)
        .map(|k| {
            let (i, j) = (k / 10, k % 10);
            let value = carried.covariance[k] / (carried.std[i] * carried.std[j]);
            if value.is_finite() { json!((100.0 * value).round() as i64) } else { Value::Null }
        })
        .collect();
    let data = json!({
        "traces": traces.iter().map(curves).collect::<Vec<_>>(),
        "names": names(),
        "correlation": correlation,
    });
    let page = Page {
        title: format!("{} – tool", carried.robot),
        style: include_str!("page.css"),
        body: &body,
        data,
        script: include_str!("../parts/curves.js"),
    };
    page.html()
}

/// The ten parameters, beside those of the nearest tool.
fn parameters(body: &mut String, found: &Found) {
    let carried = &found.carried;
    let nearest = found.recognition.as_ref().map(|r| (r, &found.table[r.nearest().entry]));
    body.push_str("<section><h2>The ten parameters</h2><p class=note>In the robot's last frame, about its origin.</p><div class=scroll><table><thead><tr><th>parameter<th>value<th>± σ<th>σ %");
    if let Some((_, entry)) = nearest {
        let _ = write!(body, "<th>{}<th class=words>off by, in σ", escape(&entry.name));
    }
    if let Some(frame) = &found.in_tool_frame {
        let _ = write!(body, "<th>in the frame of {}<th>± σ", escape(&frame.tool));
    }
    body.push_str("</tr></thead><tbody>\n");
    let relative = carried.relative_std_percent();
    for (k, name) in names().iter().enumerate() {
        let known = carried.standing[k] == Standing::Identified;
        let class = match relative[k] {
            _ if !known => "open",
            r if r < 10.0 => "known",
            r if r < 50.0 => "fair",
            _ => "poor",
        };
        let (std, share) =
            if known { (figure(carried.std[k]), percent(relative[k])) } else { ("open".into(), "–".into()) };
        let _ = write!(
            body,
            "<tr class={class}><th>{name}<td>{}<td>{std}<td class=share>{share}",
            figure(carried.values[k])
        );
        if let Some((recognition, entry)) = nearest {
            let off = recognition.nearest().deviations[k];
            let _ = write!(body, "<td>{}<td class=words>{}", figure(entry.values[k]), deviation(off));
        }
        if let Some(frame) = &found.in_tool_frame {
            let _ = write!(body, "<td>{}<td>{}", figure(frame.values[k]), figure(frame.std[k]));
        }
        body.push_str("</tr>\n");
    }
    body.push_str("</tbody></table></div></section>\n");
}

/// A deviation as a dot on a line from -4 to 4 standard deviations.
fn deviation(off: f64) -> String {
    if !off.is_finite() {
        return "–".into();
    }
    let x = 60.0 + 14.0 * off.clamp(-4.0, 4.0);
    let class = if off.abs() > 3.0 { "far" } else { "near" };
    format!(
        "<svg class=deviation viewBox='0 0 120 14' width=120 height=14><line x1=4 x2=116 y1=7 y2=7 class=grid /><line x1=60 x2=60 y1=2 y2=12 class=zero /><circle cx={x:.1} cy=7 r=4 class={class} /></svg> {}",
        digits(off, 2)
    )
}

fn workshop(body: &mut String, found: &Found) {
    let Some(b) = &found.carried.body else { return };
    let mm = |v: &[f64]| v.iter().map(|x| digits(1e3 * x, 3)).collect::<Vec<_>>().join(", ");
    let list = |v: &[f64]| v.iter().map(|x| figure(*x)).collect::<Vec<_>>().join(", ");
    let mass = match found.carried.known_mass {
        Some(_) if found.carried.mass_std == 0.0 => format!("{} kg, as given", figure(b.mass)),
        _ => format!("{} ± {} kg", figure(b.mass), digits(found.carried.std[0], 2)),
    };
    let mut rows = vec![
        ("mass".to_string(), mass),
        ("centre of mass".into(), format!("({}) ± ({}) mm", mm(&b.center), mm(&b.center_std))),
        ("tensor there".into(), format!("XX YY ZZ XY XZ YZ = {} kg m²", list(&b.tensor))),
    ];
    for (k, axis) in b.principal_axes.iter().enumerate() {
        rows.push((
            format!("principal moment {}", k + 1),
            format!("{} kg m² about ({})", figure(b.principal_moments[k]), list(axis)),
        ));
    }
    rows.push((
        "possible".into(),
        b.impossible
            .clone()
            .map_or("a body can be like this".into(), |why| format!("no body is exactly like this: {why}")),
    ));
    body.push_str("<section><h2>As the workshop says it</h2><dl>\n");
    for (what, value) in rows {
        let _ = writeln!(body, "<dt>{}<dd>{}", escape(&what), escape(&value));
    }
    body.push_str("</dl></section>\n");
}

/// Distances of the nearest tools as bars on a logarithmic scale, with the limit.
fn ranking(body: &mut String, r: &Recognition) {
    let shown = &r.candidates[..SHOWN.min(r.candidates.len())];
    let largest = shown.iter().map(|c| c.distance).fold(2.0 * r.limit, f64::max);
    let least = shown.iter().map(|c| c.distance).fold(0.5 * r.limit, f64::min).max(1e-3);
    let x = |d: f64| 190.0 + 560.0 * ((d.max(least) / least).ln() / (largest / least).ln()).clamp(0.0, 1.0);
    let height = 18 * shown.len() + 34;
    let (limit, plain) = (x(r.limit), escape(&r.by_plain_distance));
    let _ = write!(
        body,
        "<section><h2>Which tool</h2><p class=note>Distance from each tool of the table, in standard deviations of all {} determined parameters (logarithmic). Beyond the line ({}) the right tool lies in {} % of the cases. By the paper's plain distance it would be {plain}.</p><svg class=ranking viewBox='0 0 900 {height}' role=img aria-label='distances'>",
        r.determined,
        digits(r.limit, 3),
        percent(100.0 * r.level)
    );
    for (k, c) in shown.iter().enumerate() {
        let (y, class) = (18 * k + 6, if c.distance <= r.limit { "inside" } else { "outside" });
        let _ = write!(
            body,
            "<text x=182 y={} text-anchor=end>{}</text><rect x=190 y={y} width={:.1} height=12 class={class} /><text x={:.1} y={}>{}</text><title>{}: {}</title>",
            y + 10,
            escape(&c.name),
            (x(c.distance) - 190.0).max(1.0),
            x(c.distance) + 6.0,
            y + 10,
            digits(c.distance, 3),
            escape(&c.name),
            figure(c.distance)
        );
    }
    let bottom = height - 26;
    let _ = writeln!(
        body,
        "<line x1={limit:.1} x2={limit:.1} y1=0 y2={bottom} class=limit /><text x={limit:.1} y={} text-anchor=middle>limit {}</text></svg>",
        bottom + 14,
        digits(r.limit, 3)
    );
    body.push_str("<div class=scroll><table><thead><tr><th>tool<th>distance<th>in the reduced space<th>plain (the paper's)<th>probability,<br>if it is one of them</tr></thead><tbody>\n");
    for c in shown {
        let _ = writeln!(
            body,
            "<tr><th>{}<td>{}<td>{}<td>{}<td>{}</tr>",
            escape(&c.name),
            figure(c.distance),
            figure(c.distance_in_space),
            figure(c.plain_distance),
            digits(c.probability, 3)
        );
    }
    body.push_str("</tbody></table></div></section>\n");
}

/// The table of tools in its first two principal components, with the identified tool and its 95 %
/// ellipse.
fn space(body: &mut String, r: &Recognition) {
    if r.pca.components() < 2 {
        return;
    }
    // The window is that of the nearest tools: a heavy, distant one would compress the others into
    // a corner.
    let near = || r.candidates.iter().take(SHOWN);
    let points: Vec<[f64; 2]> =
        near().map(|c| &r.table_scores[c.entry]).chain([&r.scores]).map(|s| [s[0], s[1]]).collect();
    let range = [0, 1].map(|k| {
        let (low, high) =
            points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p[k]), h.max(p[k])));
        let pad = 0.06 * (high - low).max(1e-9);
        [low - pad, high + pad]
    });
    let x = |v: f64| 50.0 + 720.0 * (v - range[0][0]) / (range[0][1] - range[0][0]);
    let y = |v: f64| 380.0 - 360.0 * (v - range[1][0]) / (range[1][1] - range[1][0]);
    let _ = write!(
        body,
        "<section><h2>The table in two of {} components</h2><p class=note>Equation (8) of the paper: U<sub>p</sub>′Φ. {} components hold {} % of the table's sum of squares. The ellipse holds the identified tool with 95 %; hover for names. Tools that are far away lie outside of the window.</p><svg class=space viewBox='0 0 800 420' role=img aria-label='principal components'><clipPath id=space-window><rect x=50 y=20 width=720 height=360 /></clipPath><rect x=50 y=20 width=720 height=360 class=frame />",
        r.pca.components(),
        r.pca.components(),
        digits(100.0 * r.pca.explained[r.pca.components() - 1], 6)
    );
    for (score, c) in near().map(|c| (&r.table_scores[c.entry], c)) {
        let class = if c.distance <= r.limit { "inside" } else { "outside" };
        let _ = write!(
            body,
            "<circle cx={:.1} cy={:.1} r=4 class={class}><title>{}</title></circle>",
            x(score[0]),
            y(score[1]),
            escape(&c.name)
        );
    }
    if let Some(c) = r.candidates.first() {
        let score = &r.table_scores[c.entry];
        let right = x(score[0]) > 640.0;
        let _ = write!(
            body,
            "<text x={:.1} y={:.1} text-anchor={}>{}</text>",
            x(score[0]) + if right { -8.0 } else { 8.0 },
            y(score[1]) + 14.0,
            if right { "end" } else { "start" },
            escape(&c.name)
        );
    }
    // Ellipse of the covariance's 2 x 2 block at chi square 5.991 (95 %, two degrees of freedom).
    let c = &r.score_covariance;
    let block = nalgebra::Matrix2::new(c[(0, 0)], c[(0, 1)], c[(1, 0)], c[(1, 1)]).symmetric_eigen();
    let path: Vec<String> = (0..=48)
        .map(|k| {
            let (s, co) = (std::f64::consts::TAU * f64::from(k) / 48.0).sin_cos();
            let reach = block.eigenvalues.map(|v| (5.991 * v.max(0.0)).sqrt());
            let p = block.eigenvectors * nalgebra::Vector2::new(reach[0] * co, reach[1] * s);
            format!("{:.1},{:.1}", x(r.scores[0] + p[0]), y(r.scores[1] + p[1]))
        })
        .collect();
    let (cx, cy) = (x(r.scores[0]), y(r.scores[1]));
    let _ = writeln!(
        body,
        "<polygon points='{}' class=ellipse clip-path='url(#space-window)' /><path class=cross d='M{:.1} {cy:.1}h14M{cx:.1} {:.1}v14' /><text x=410 y=408 text-anchor=middle>first component</text><text x=16 y=200 text-anchor=middle transform='rotate(-90 16 200)'>second component</text></svg></section>",
        path.join(" "),
        cx - 7.0,
        cy - 7.0
    );
}

fn size(body: &mut String, size: &Relative, found: &Found) {
    let says = match size.fits {
        true => format!(
            "distance {}, limit {}: it can be one of them.{}",
            digits(size.distance, 3),
            digits(size.limit, 3),
            if size.extrapolated { " Outside of the sizes in the table." } else { "" }
        ),
        false => format!("it is none of them ({}).", misfit(size)),
    };
    let _ = writeln!(
        body,
        "<section><h2>As a {} of any size</h2><p class=note>Interpolated between {} tools of the table; {says}</p>",
        escape(&size.family),
        size.members
    );
    if size.fits {
        body.push_str("<div class=scroll><table><thead><tr><th><th>interpolated, mm<th>95 % interval, mm<th>nearest tool, mm</tr></thead><tbody>\n");
        let nearest = found.recognition.as_ref().and_then(|r| found.table[r.nearest().entry].geometry);
        for (name, i, known) in
            [("length", &size.length, nearest.map(|g| g.length)), ("width", &size.width, nearest.map(|g| g.width))]
        {
            let _ = writeln!(
                body,
                "<tr><th>{name}<td>{:.1}<td>{:.1} to {:.1}<td>{}</tr>",
                1e3 * i.value,
                1e3 * i.ends[0],
                1e3 * i.ends[1],
                known.map_or("–".into(), |k| format!("{:.0}", 1e3 * k))
            );
        }
        body.push_str("</tbody></table></div>\n");
    }
    body.push_str("</section>\n");
}

fn torque_table(body: &mut String, found: &Found) {
    body.push_str("<section><h2>Torque error per joint, RMS, N m</h2><div class=scroll><table><thead><tr><th>joint");
    for log in &found.carried.logs {
        let _ = write!(body, "<th>{}", escape(&log.name));
        if log.loaded {
            body.push_str("<br>with the tool<th><br>without it");
        }
    }
    body.push_str("<th>noise σ<th>effective<br>samples</tr></thead><tbody>\n");
    let noise = &found.carried.noise;
    for joint in 0..noise.sigma.len() {
        let _ = write!(body, "<tr><th>{}", joint + 1);
        for log in &found.carried.logs {
            let _ = write!(body, "<td>{}", figure(log.with_tool.rms[joint]));
            if log.loaded {
                let _ = write!(body, "<td>{}", figure(log.robot_alone.rms[joint]));
            }
        }
        let _ = writeln!(body, "<td>{}<td>{:.0}</tr>", figure(noise.sigma[joint]), noise.effective_samples[joint]);
    }
    body.push_str("</tbody></table></div></section>\n");
}

fn foot(body: &mut String, found: &Found, provenance: &Provenance) {
    let carried = &found.carried;
    let robot = match carried.robot_errors {
        RobotErrors::Identified => "its base parameters were identified along, from both kinds of log (equation 7)",
        RobotErrors::Counted => {
            "its parameters were taken from the robot file; their covariance, as identified, is in σ"
        }
        RobotErrors::NotCounted => "its parameters were taken from the robot file as exact; their errors are not in σ",
    };
    let mut rows = vec![
        ("robot".to_string(), robot.to_string()),
        ("condition number".into(), figure(carried.solved.condition.plain)),
        ("samples".into(), format!("{} over all joints, weighted by each joint's noise", carried.solved.samples)),
        ("σ".into(), "from batches of the residual: correlation in time is accounted for; model errors that repeat with the motion are not noise, and not in it".into()),
    ];
    rows.extend(provenance.iter().cloned());
    body.push_str("<section><h2>How this was made</h2><dl>\n");
    for (what, value) in rows {
        let _ = writeln!(body, "<dt>{}<dd>{}", escape(&what), escape(&value));
    }
    body.push_str("</dl></section>\n");
}
