//! Evidence against a cause, in sentences.

use crate::diagnose::Cause;

/// Recurrence below which a cause's size differs between stretches.
const UNSTEADY: f64 = 0.7;
/// Share of its joint's error below which a cause counts as small.
const SMALL: f64 = 0.3;

/// Reasons to doubt a cause, the most important first; empty if there are none.
pub fn doubts(c: &Cause) -> Vec<String> {
    let mut all = Vec::new();
    if c.cause == "unknown" {
        return all;
    }
    match c.found_again {
        [0, of] if of > 0 => all.push("no excerpt of the fitted logs shows it".to_string()),
        [1, 2] => all.push("one of two excerpts of the fitted logs does not show it".to_string()),
        _ => {}
    }
    if !c.not_distinguished_from.is_empty() {
        let names: Vec<String> = c.not_distinguished_from.iter().map(|n| n.replace('_', " ")).collect();
        all.push(format!("{} would explain nearly as much", names.join(" or ")));
    }
    if !c.in_extended {
        all.push("it is not in the extended model".to_string());
    }
    if c.recurrence < UNSTEADY {
        all.push(format!("its size differs between stretches of the logs (recurrence {:.2} of 1)", c.recurrence));
    }
    if c.on == "fit" {
        all.push("it is measured on the fitted logs alone".to_string());
    }
    if c.interval[0] <= 0.0 {
        all.push("the 90 % interval of its gain reaches zero".to_string());
    }
    if c.share < SMALL {
        all.push(format!("it takes {:.0} % of its joint's squared error above the noise", 100.0 * c.share.max(0.0)));
    }
    all
}
