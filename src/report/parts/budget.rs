//! Error budget: sensors, motion, clock, repeatability, remainder.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::identify::ErrorBudget;
use crate::report::parts::number::{digits, pad};

const HEADS: [&str; 4] = ["torque sensor", "encoder, derivatives", "clock", "left to explain"];
const REPEATED: &str = "repetitions differ by";

/// The parts in the order of the column heads.
fn parts(budget: &ErrorBudget) -> Vec<(&'static str, &[f64])> {
    let ErrorBudget { sensor, motion, clock, left, .. } = budget;
    let mut parts: Vec<(&str, &[f64])> = HEADS.into_iter().zip([&sensor[..], motion, clock, left]).collect();
    parts.extend(budget.repeatability.as_ref().map(|r| (REPEATED, &r[..])));
    parts
}

/// A sentence if the recorded motion limits the estimate; empty otherwise.
fn limits(budget: &ErrorBudget) -> String {
    let joints: Vec<String> = budget.limited_by_motion().iter().map(|j| (j + 1).to_string()).collect();
    match joints.is_empty() {
        true => String::new(),
        false => format!(
            "On joint {} most of the error is that of the recorded motion, not of the model: record faster, or with a finer encoder.",
            joints.join(", ")
        ),
    }
}

/// The budget as a table for the terminal. `of`: the error that it composes.
pub(in crate::report) fn text(budget: &ErrorBudget, of: &str) -> String {
    let parts = parts(budget);
    let width = |head: &str| head.chars().count().max(8) + 2;
    let mut text = format!("\nWhere {of} comes from, RMS, N m (squares add up)\n{}", pad("joint", 7, true));
    parts.iter().for_each(|(head, _)| text.push_str(&pad(head, width(head), true)));
    text.push('\n');
    for j in 0..budget.left.len() {
        text.push_str(&pad(&(j + 1).to_string(), 7, true));
        parts.iter().for_each(|(head, x)| text.push_str(&pad(&digits(x[j], 2), width(head), true)));
        text.push('\n');
    }
    let limits = limits(budget);
    if !limits.is_empty() {
        let _ = writeln!(text, "{limits}");
    }
    text
}

/// The key `error_budget`.
pub(in crate::report) fn json(budget: Option<&ErrorBudget>) -> Value {
    budget.map_or(Value::Null, |b| {
        json!({
            "sensor": b.sensor,
            "motion": b.motion,
            "clock": b.clock,
            "repeatability": b.repeatability,
            "left": b.left,
        })
    })
}

/// The budget as a section of a page.
pub(in crate::report) fn html(budget: &ErrorBudget, of: &str) -> String {
    let parts = parts(budget);
    let heads: String = parts.iter().map(|(head, _)| format!("<th>{head}<br>N m")).collect();
    let mut html = format!(
        "<section><h2>Where {of} comes from</h2><div class=scroll><table><thead><tr><th>joint{heads}</tr></thead><tbody>\n"
    );
    for j in 0..budget.left.len() {
        let cells: String = parts.iter().map(|(_, x)| format!("<td>{}", digits(x[j], 2))).collect();
        let _ = writeln!(html, "<tr><th>{}{cells}</tr>", j + 1);
    }
    let _ = writeln!(
        html,
        "</tbody></table></div><p class=note>RMS; squares of the parts add up. Sensor: noise of the torques. Encoder, derivatives: what errors of position, velocity and acceleration make of the model's torque. Clock: remaining error of the rows' times. {}{}</p></section>",
        if budget.repeatability.is_some() {
            "Repetitions: by how much the torque differs where the log repeats its motion, which no model of the motion takes. "
        } else {
            ""
        },
        limits(budget)
    );
    html
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_budget_in_text_and_json() {
        let budget = ErrorBudget {
            sensor: vec![0.3, 0.1],
            motion: vec![0.0, 0.8],
            clock: vec![0.0, 0.1],
            repeatability: None,
            left: Vec::new(),
        }
        .of_errors(&[0.5, 0.85]);
        assert!((budget.left[0] - 0.4).abs() < 1e-12);
        let text = text(&budget, "the error");
        assert!(text.contains("On joint 2 most of the error is that of the recorded motion"), "{text}");
        assert!(!text.contains(REPEATED) && html(&budget, "the error").contains("<td>0.80"));
        assert!((json(Some(&budget))["motion"][1].as_f64().unwrap() - 0.8).abs() < 1e-12);
    }
}
