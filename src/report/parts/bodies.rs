//! Section on the links as bodies: mass, centre, principal moments, and displacement from the robot
//! file.

use std::fmt::Write;

use crate::identify::Identification;
use crate::identify::tool::Body;
use crate::report::identify::consistent::{Possible, paid, preferred};
use crate::report::parts::number::{digits, figure};
use crate::report::parts::page::escape;

/// The links with the identified parameters, and those of the robot file. Without the tool.
pub struct Links<'a> {
    /// Per link, in its frame; `None` if its mass is not positive.
    pub now: Vec<Option<Body>>,
    /// The links of the robot file; `None` where it has none.
    pub file: Vec<Option<Body>>,
    /// Result of the search for possible bodies.
    pub possible: Option<&'a Possible<'a>>,
}

/// The section of the page.
pub(in crate::report) fn bodies_section(body: &mut String, found: &Identification, links: &Links<'_>) {
    body.push_str("<section id=bodies><h2>The links as bodies</h2>\n");
    match links.possible.map(|p| p.result) {
        Some(Ok(c)) => {
            let _ = writeln!(body, "<p>{}</p>", escape(&paid(c)));
            if let Some(preferred) = links.possible.and_then(|p| preferred(found, c, p)) {
                let _ = writeln!(body, "<p>{}</p>", escape(&preferred));
            }
        }
        Some(Err(error)) => {
            let _ = writeln!(body, "<p class=warning>No possible bodies: {}.</p>", escape(&error.to_string()));
        }
        None => {}
    }
    if links.possible.is_some_and(|p| p.plain) {
        body.push_str("<p>The plain parameters are those of possible bodies: these have exactly them.</p>\n");
    }
    let known = links.file.iter().any(Option::is_some);
    body.push_str("<div class=scroll><table class=bodies><thead><tr><th>link<th>mass<br>kg");
    if known {
        body.push_str("<th>file");
    }
    body.push_str("<th class=words>centre of mass<br>mm");
    if known {
        body.push_str("<th class=words>file<th>moved<br>mm");
    }
    body.push_str("<th class=words>principal moments<br>g m²");
    if known {
        body.push_str("<th class=words>file");
    }
    body.push_str("<th>distance<br>from prior<th class=words>can it be a body?</tr></thead><tbody>\n");
    for (k, now) in links.now.iter().enumerate() {
        let file = links.file.get(k).and_then(Option::as_ref);
        let _ = write!(body, "<tr><th>{}", k + 1);
        let mut cell = |text: Option<String>, words: bool| {
            let class = if words { " class=words" } else { "" };
            let _ = write!(body, "<td{class}>{}", text.unwrap_or_else(|| "–".into()));
        };
        let now = now.as_ref();
        cell(now.map(|b| figure(b.mass)), false);
        if known {
            cell(file.map(|b| figure(b.mass)), false);
        }
        let center = |b: &Body| b.center.map(|c| fixed(1e3 * c)).join(", ");
        cell(now.map(center), true);
        if known {
            cell(file.map(center), true);
            let way = |(a, b): (&Body, &Body)| (0..3).map(|i| (a.center[i] - b.center[i]).powi(2)).sum::<f64>().sqrt();
            cell(now.zip(file).map(|pair| fixed(1e3 * way(pair))), false);
        }
        let moments = |b: &Body| b.principal_moments.map(|m| digits(1e3 * m, 3)).join(", ");
        cell(now.map(moments), true);
        if known {
            cell(file.map(moments), true);
        }
        let c = links.possible.and_then(|p| p.result.ok()).filter(|_| !links.possible.is_some_and(|p| p.plain));
        cell(c.and_then(|c| c.distances.get(k)).map(|d| digits(*d, 2)), false);
        let answer = match now {
            None => "no: its mass is not positive".into(),
            Some(Body { impossible: Some(why), .. }) => format!("no: {}", escape(why)),
            Some(_) if c.is_some_and(|c| c.at_the_edge.contains(&(k + 1))) => {
                "yes; without the prior at the edge".into()
            }
            Some(_) => "yes".to_string(),
        };
        cell(Some(answer), true);
        body.push_str("</tr>\n");
    }
    body.push_str("</tbody></table></div>\n<p class=note>In each link's own frame; moments about the centre of mass. Torques show combinations of these numbers only: what they don't show is the robot file's, or a guess from the arm's geometry. The distance is entropic, free of units: 0.005 per direction is a change by 10 %.</p></section>\n");
}

/// A length in millimetres with one decimal.
fn fixed(millimetres: f64) -> String {
    let tenths = (10.0 * millimetres).round() / 10.0;
    format!("{:.1}", if tenths == 0.0 { 0.0 } else { tenths })
}
