//! The page of a fleet: one file that needs no network and no script.

use std::fmt::Write;

use denavit::report::visible;

use super::{apart, between, figure, meaning, place, probability, rarity, undated, verdict};
use crate::attribution::clearest;
use crate::calendar::date;
use crate::watch::{Change, Watched};

/// Causes of a change in its table.
const LISTED: usize = 4;

/// Style beyond that of denavit's pages.
const STYLE: &str = "
svg { width: 100%; height: auto; display: block; max-width: 60rem; }
.axis { stroke: var(--line); } .zeroline { stroke: var(--zero); } .mark { stroke: var(--zero); stroke-dasharray: 3 3; }
.point { fill: var(--estimated); } .later { fill: var(--residual); } .bar { stroke: var(--grey); }
.mean { stroke: var(--estimated); stroke-width: 1.5; } .moved { stroke: var(--residual); stroke-width: 1.5; }
.share { display: inline-block; height: .6em; background: var(--estimated); border-radius: 2px; }
td.wide { min-width: 12rem; text-align: left; } td.words, th.words { text-align: left; white-space: normal; } pre { white-space: pre-wrap; }
";

/// The page.
pub fn page(watched: &Watched) -> String {
    let mut body = format!(
        "<header><p class=kicker>denavit-fleet watch</p><h1>Changes in a fleet of robots</h1><p class=verdict>{}</p></header>\n",
        escape(&verdict(watched))
    );
    body += &overview(watched);
    watched.changes.iter().enumerate().for_each(|(k, change)| body += &section(k, change));
    if watched.undated > 0 {
        body += &format!("<p class=note>{}</p>\n", escape(&undated(watched.undated)));
    }
    body += &list("Not tested", &watched.untested);
    body += &list("Recordings without a factor", &watched.unusable);
    body += &format!(
        "<section><h2>How this is tested</h2><p class=note>Each parameter of each robot gives a number a day: the change of that \
         parameter alone that explains most of the torque error against the robot's own reference days. The evidence for a change is a \
         sum of Bayes factors which grows by one a day on average as long as nothing changes; a robot is flagged when it passes {}. So \
         without a change at least as many days pass on average between two alarms of one robot, for independent days with normal \
         scatter; outliers of single days and correlation from day to day are allowed for. A cause is a friction, \
         an offset, a gain or a mass that changed alone. Its probability comes from the likelihood of the days before and after the change \
         in a model in which every parameter also wanders from day to day, as much as it did before, and it counts the listed \
         kinds of cause alone.</p></section>\n",
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
        return "<section><h2>Which robots changed</h2><p>No robot changed.</p></section>\n".into();
    }
    let mut rows = String::new();
    for (k, change) in watched.changes.iter().enumerate() {
        let named: String = apart(&change.causes)
            .iter()
            .map(|cause| {
                format!("<div>{} <small>{}</small></div>", escape(&place(cause)), probability(cause.probability))
            })
            .collect();
        let by = change.causes.first().and_then(clearest);
        let _ = writeln!(
            rows,
            "<tr><th><a href='#c{k}'>{}</a></th><td>{}</td><td>{}</td><td class=words>{named}</td><td class=words>{}</td>\
             <td>once in {} or less often</td></tr>",
            escape(&change.robot),
            date(change.before),
            date(change.found),
            by.map_or(String::new(), |by| escape(&format!(
                "{} {}",
                by.parameter,
                between([by.value, by.std], &by.unit)
            ))),
            rarity(change.evidence),
        );
    }
    format!(
        "<section><h2>Which robots changed</h2><div class=scroll><table><thead><tr><th>robot</th><th>last day as before</th><th>found on</th>\
         <th class=words>likely cause, its probability</th><th class=words>change of its parameter ± standard deviation</th>\
         <th>a false alarm as strong</th></tr></thead><tbody>\n{rows}</tbody></table></div>\n\
         <p class=note>Where a cell names several causes, the days do not tell them \
         apart. The last column says how many days or years of one robot pass, on average and at least, between alarms as strong as this \
         one when nothing changes.</p></section>\n"
    )
}

/// One change with its history and causes.
fn section(number: usize, change: &Change) -> String {
    let named: Vec<String> = apart(&change.causes).iter().map(place).collect();
    let head =
        if named.is_empty() { change.robot.clone() } else { format!("{}: {}", change.robot, named.join(" or ")) };
    let mut rows = String::new();
    for cause in change.causes.iter().take(LISTED) {
        let width = 100.0 * cause.probability;
        let values = cause.changes.iter().filter(|by| by.std > 0.0);
        let values: Vec<String> =
            values.map(|by| format!("{} {}", by.parameter, between([by.value, by.std], &by.unit))).collect();
        let _ = writeln!(
            rows,
            "<tr><th>{}</th><td>{}</td><td class=wide><span class=share style='width:{width:.1}%'></span></td><td>{:.0} %</td>\
             <td class=words>{}</td></tr>",
            escape(&place(cause)),
            probability(cause.probability),
            100.0 * cause.share,
            escape(&values.join(", ")),
        );
    }
    let said = change
        .diagnosis
        .as_ref()
        .map_or(String::new(), |said| format!("<h3>Diagnosis of the raw log</h3><p class=note>Against the robot file with the friction and offsets of the \
             reference days: <code>denavit diagnose</code> looks for more causes than the ones above, in the recordings of this one day.</p>\
             <pre>{}</pre>\n", escape(said)));
    let files = change.files.iter().map(|file| format!("<code>{}</code>", escape(file))).collect::<Vec<_>>().join(", ");
    format!(
        "<section id='c{number}'><h2>{}</h2>\n<p>As before until {}, found on {}. Without a change an alarm as strong comes at most \
         once in {}.</p>\n{}<div class=scroll><table><thead><tr><th>possible cause</th><th colspan=2 class=words>probability</th>\
         <th>explains of the change</th><th class=words>by these changes ± standard deviation</th></tr></thead><tbody>\n{rows}\
         </tbody></table></div>\n<p class=note>Recordings of {}: {files}</p>{said}</section>\n",
        escape(&head),
        date(change.before),
        date(change.found),
        rarity(change.evidence),
        history(change),
        date(change.found),
    )
}

/// The plot of a history: places of days and values.
struct Plot {
    days: [f64; 2],
    values: [f64; 2],
}

const SIZE: [f64; 2] = [760.0, 236.0];
/// Left, right, top, bottom.
const EDGE: [f64; 4] = [62.0, 46.0, 34.0, 26.0];

impl Plot {
    fn x(&self, day: f64) -> f64 {
        EDGE[0] + (SIZE[0] - EDGE[0] - EDGE[1]) * (day - self.days[0]) / (self.days[1] - self.days[0])
    }

    fn y(&self, value: f64) -> f64 {
        let span = self.values[1] - self.values[0];
        SIZE[1] - EDGE[3] - (SIZE[1] - EDGE[2] - EDGE[3]) * (value - self.values[0]) / span
    }

    /// Lines at round values, and dates.
    fn axes(&self) -> String {
        let mut marks = String::new();
        let step = step(self.values[1] - self.values[0]);
        let first = (self.values[0] / step).ceil() as i64;
        for value in (first..).map(|k| k as f64 * step).take_while(|value| *value <= self.values[1]).take(12) {
            let (at, class) = (self.y(value), if value == 0.0 { "zeroline" } else { "axis" });
            let _ =
                write!(marks, "<line class={class} x1={} x2={} y1={at:.1} y2={at:.1} />", EDGE[0], SIZE[0] - EDGE[1]);
            let _ =
                write!(marks, "<text x={} y={:.1} text-anchor=end>{}</text>", EDGE[0] - 6.0, at + 4.0, figure(value));
        }
        let every = ((self.days[1] - self.days[0]) / 6.0).ceil().max(1.0);
        for day in (0..).map(|k| self.days[0] + 0.5 + k as f64 * every).take_while(|day| *day < self.days[1]) {
            let text = date(day as i32);
            let _ = write!(marks, "<text x={:.1} y={} text-anchor=middle>{text}</text>", self.x(day), SIZE[1] - 8.0);
        }
        marks
    }

    /// A dashed line with a word at its head, which ends or starts there.
    fn mark(&self, day: f64, text: &str, anchor: &str) -> String {
        let at = self.x(day);
        let bottom = SIZE[1] - EDGE[3];
        format!(
            "<line class=mark x1={at:.1} x2={at:.1} y1={} y2={bottom} /><text x={at:.1} y={} text-anchor={anchor}>{text}</text>",
            EDGE[2],
            EDGE[2] - 6.0
        )
    }

    /// Mean of some days.
    fn level(&self, points: &[(f64, f64, f64)], class: &str) -> String {
        let (Some(first), Some(last)) = (points.first(), points.last()) else { return String::new() };
        let at = self.y(points.iter().map(|(_, value, _)| value).sum::<f64>() / points.len() as f64);
        let ends = [self.x(first.0 - 0.4), self.x(last.0 + 0.4)];
        format!("<line class={class} x1={:.1} x2={:.1} y1={at:.1} y2={at:.1} />", ends[0], ends[1])
    }
}

/// A round step that cuts a span into about five.
fn step(span: f64) -> f64 {
    let power = 10.0_f64.powf((span / 5.0).log10().floor());
    [1.0, 2.0, 5.0].map(|k| k * power).into_iter().find(|step| span / step <= 6.0).unwrap_or(10.0 * power)
}

/// The daily estimates of the cause's parameter.
fn history(change: &Change) -> String {
    let scale = if change.plotted_unit.is_empty() { 100.0 } else { 1.0 };
    let points: Vec<(f64, f64, f64)> = change
        .history
        .iter()
        .filter(|(_, value, std)| value.is_finite() && std.is_finite())
        .map(|(day, value, std)| (f64::from(*day), scale * value, scale * std))
        .collect();
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return String::new() };
    let low = points.iter().map(|(_, y, s)| y - s).fold(0.0, f64::min);
    let high = points.iter().map(|(_, y, s)| y + s).fold(0.0, f64::max);
    let air = 0.05 * (high - low).max(1e-12);
    let plot = Plot { days: [first.0 - 0.5, last.0 + 0.5], values: [low - air, high + air] };
    let until = |day: i32| points.partition_point(|(at, _, _)| *at <= f64::from(day));
    let since = change.since.map_or(0, until);
    let (before, found) = (until(change.before), until(change.found));
    let mut marks = plot.axes();
    marks += &plot.mark(f64::from(change.before) + 0.5, "change", "end");
    marks += &plot.mark(f64::from(change.found), "found", "start");
    marks += &plot.level(&points[since.min(before)..before], "mean");
    marks += &plot.level(&points[before..found], "moved");
    for (k, (day, value, std)) in points.iter().enumerate() {
        let class = if k < before { "point" } else { "later" };
        let (at, top, bottom) = (plot.x(*day), plot.y(value + std), plot.y(value - std));
        let _ = write!(marks, "<line class=bar x1={at:.1} x2={at:.1} y1={top:.1} y2={bottom:.1} />");
        let _ = write!(marks, "<circle class={class} cx={at:.1} cy={:.1} r=3 />", plot.y(*value));
    }
    let unit = if change.plotted_unit.is_empty() { "%" } else { &change.plotted_unit };
    let _ = write!(marks, "<text x={} y=12 text-anchor=end>{}</text>", EDGE[0] - 6.0, escape(unit));
    let title = format!("{} ({}): change against the reference days, {unit}", change.plotted, meaning(&change.plotted));
    format!(
        "<p class=note><b>{}</b>. A point is a day; a bar, where it is longer than the point, is \
         the noise of its estimate; lines are the means before the change and from there to the day it was found.</p>\n\
         <svg viewBox='0 0 {} {}' role=img aria-label='History of {}'>{marks}</svg>\n",
        escape(&title),
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
    let row = |(name, why): &(String, String)| {
        format!("<tr><th>{}</th><td class=words>{}</td></tr>\n", escape(name), escape(why))
    };
    let rows: String = rows.iter().map(row).collect();
    format!("<section><h2>{title}</h2><table><tbody>\n{rows}</tbody></table></section>\n")
}

/// Text inside markup; control characters are shown.
fn escape(text: &str) -> String {
    let text = visible(text).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    text.replace('"', "&quot;").replace('\'', "&#39;")
}
