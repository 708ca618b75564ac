//! The page of a fleet: one file that needs no network and no script.

use std::fmt::Write;

use denavit::report::visible;

use super::{date, figure, place, verdict};
use crate::watch::{Change, Watched};

/// Style beyond that of denavit's pages.
const STYLE: &str = "
svg { width: 100%; height: auto; display: block; }
svg text { font-size: 11px; fill: var(--soft); }
.axis { stroke: var(--line); } .mark { stroke: var(--zero); stroke-dasharray: 3 3; }
.found { stroke: var(--residual); stroke-dasharray: 3 3; }
.point { fill: var(--estimated); } .later { fill: var(--residual); } .bar { stroke: var(--grey); }
.mean { stroke: var(--estimated); } .moved { stroke: var(--residual); }
.share { display: inline-block; height: .6em; background: var(--estimated); border-radius: 2px; }
td.wide { width: 30%; } pre { white-space: pre-wrap; }
";

/// The page.
pub fn page(watched: &Watched) -> String {
    let mut body = format!("<header><h1>Fleet</h1><p>{}</p></header>\n", escape(&verdict(watched)));
    body += &overview(watched);
    watched.changes.iter().enumerate().for_each(|(k, change)| body += &section(k, change));
    body += &list("Not tested", &watched.untested);
    body += &list("Recordings without a factor", &watched.unusable);
    body += &format!(
        "<section><h2>How this is tested</h2><p>Each parameter of each robot gives a number a day. The evidence for a change \
         is a Shiryaev-Roberts sum of Bayes factors, which grows by one a day on average as long as nothing changes; a \
         robot is flagged when it passes {}. Without a change that takes at least as many days on average, whatever mean \
         and scatter the robot has, if its days are independent and normal. A cause is named by the share of the \
         additional torque error that it explains alone.</p></section>\n",
        figure(watched.days_between)
    );
    format!(
        "<!doctype html>\n<html lang=en><head><meta charset=utf-8><meta name=viewport content='width=device-width, \
         initial-scale=1'>\n<title>Fleet</title>\n<style>\n{}{STYLE}</style></head>\n<body>\n{body}</body></html>\n",
        include_str!("../../../src/report/parts/page.css"),
    )
}

/// The table of all changes.
fn overview(watched: &Watched) -> String {
    if watched.changes.is_empty() {
        return "<section><h2>Changes</h2><p>No robot changed.</p></section>\n".into();
    }
    let mut rows = String::new();
    for (k, change) in watched.changes.iter().enumerate() {
        let first = change.causes.first();
        let _ = writeln!(
            rows,
            "<tr><td><a href='#c{k}'>{}</a></td><td>{}</td><td>{}</td><td>{}</td><td>{} {} ± {} {}</td><td>{}</td></tr>",
            escape(&change.robot),
            date(change.before),
            date(change.found),
            first.map_or(String::new(), |cause| escape(&place(cause))),
            escape(&change.parameter),
            figure(change.size[0]),
            figure(change.size[1]),
            change.unit,
            first.map_or(String::new(), |cause| format!("{:.0} %", 100.0 * cause.share.max(0.0))),
        );
    }
    format!(
        "<section><h2>Changes</h2><table><thead><tr><th>robot</th><th>last day without</th><th>certain on</th><th>cause</th>\
         <th>change</th><th>explained</th></tr></thead><tbody>\n{rows}</tbody></table></section>\n"
    )
}

/// One change with its history and causes.
fn section(number: usize, change: &Change) -> String {
    let head = format!("{} after {}", escape(&change.robot), date(change.before));
    let mut causes = String::new();
    for cause in change.causes.iter().take(4) {
        let share = 100.0 * cause.share.clamp(0.0, 1.0);
        let values = cause.changes.iter().map(|(name, value, unit)| format!("{name} {} {unit}", figure(*value)));
        let _ = writeln!(
            causes,
            "<tr><td>{}</td><td class=wide><span class=share style='width:{share:.0}%'></span></td><td>{share:.0} %</td>\
             <td>{}</td></tr>",
            escape(&place(cause)),
            escape(&values.collect::<Vec<_>>().join(", ")),
        );
    }
    let said = change
        .diagnosis
        .as_ref()
        .map_or(String::new(), |said| format!("<h3>Diagnosis of the raw log</h3><pre>{}</pre>\n", escape(said)));
    let files = change.files.iter().map(|file| format!("<code>{}</code>", escape(file))).collect::<Vec<_>>().join(", ");
    format!(
        "<section id='c{number}'><h2>{head}</h2>\n{}<table><thead><tr><th>cause</th><th></th><th>explained alone</th><th>change \
         since</th></tr></thead><tbody>\n{causes}</tbody></table>\n<p>Detector at {} days on {}. Recordings of that day: \
         {files}</p>{said}</section>\n",
        history(change),
        figure(change.evidence),
        date(change.found),
    )
}

/// The daily estimates of the cause's parameter.
fn history(change: &Change) -> String {
    const SIZE: [f64; 2] = [760.0, 200.0];
    const EDGE: [f64; 4] = [62.0, 12.0, 12.0, 26.0];
    let points: Vec<(f64, f64, f64)> = change
        .history
        .iter()
        .filter(|(_, value, std)| value.is_finite() && std.is_finite())
        .map(|(day, value, std)| (f64::from(*day), *value, *std))
        .collect();
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return String::new() };
    let days = [first.0 - 0.5, last.0 + 0.5];
    let low = points.iter().map(|(_, y, s)| y - s).fold(0.0, f64::min);
    let high = points.iter().map(|(_, y, s)| y + s).fold(0.0, f64::max);
    let span = (high - low).max(1e-12);
    let x = |day: f64| EDGE[0] + (SIZE[0] - EDGE[0] - EDGE[1]) * (day - days[0]) / (days[1] - days[0]);
    let y = |value: f64| SIZE[1] - EDGE[3] - (SIZE[1] - EDGE[2] - EDGE[3]) * (value - low) / span;
    let mut marks = String::new();
    for value in [low, 0.0, high] {
        let at = y(value);
        let _ = write!(marks, "<line class=axis x1={} x2={} y1={at:.1} y2={at:.1} />", EDGE[0], SIZE[0] - EDGE[1]);
        let _ = write!(marks, "<text x={} y={:.1} text-anchor=end>{}</text>", EDGE[0] - 6.0, at + 4.0, figure(value));
    }
    for (day, class) in [(f64::from(change.before) + 0.5, "mark"), (f64::from(change.found), "found")] {
        let at = x(day);
        let _ = write!(marks, "<line class={class} x1={at:.1} x2={at:.1} y1={} y2={} />", EDGE[2], SIZE[1] - EDGE[3]);
    }
    for (day, anchor) in [(first.0, "start"), (last.0, "end")] {
        let text = date(day as i32);
        let _ = write!(marks, "<text x={:.1} y={} text-anchor={anchor}>{text}</text>", x(day), SIZE[1] - 8.0);
    }
    for (day, value, std) in &points {
        let class = if *day > f64::from(change.before) { "later" } else { "point" };
        let (at, top, bottom) = (x(*day), y(value + std), y(value - std));
        let _ = write!(marks, "<line class=bar x1={at:.1} x2={at:.1} y1={top:.1} y2={bottom:.1} />");
        let _ = write!(marks, "<circle class={class} cx={at:.1} cy={:.1} r=3 />", y(*value));
    }
    format!(
        "<p>{} against the reference, day by day; bars are the noise of a day</p>\n<svg viewBox='0 0 {} {}' role=img \
         aria-label='History of {}'>{marks}</svg>\n",
        escape(&change.plotted),
        SIZE[0],
        SIZE[1],
        escape(&change.plotted)
    )
}

/// Names and reasons.
fn list(title: &str, rows: &[(String, String)]) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let row = |(name, why): &(String, String)| format!("<tr><td>{}</td><td>{}</td></tr>\n", escape(name), escape(why));
    let rows: String = rows.iter().map(row).collect();
    format!("<section><h2>{title}</h2><table><tbody>\n{rows}</tbody></table></section>\n")
}

/// Text inside markup; control characters are shown.
fn escape(text: &str) -> String {
    let text = visible(text).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    text.replace('"', "&quot;").replace('\'', "&#39;")
}
