//! Report on the check of a motion against limits.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::excite::check::Verdict;
use crate::report::Warnings;
use crate::report::parts::number::{counted, figure};

/// Checks that were skipped, or used a limit that is not in the file.
fn warnings(verdict: &Verdict) -> Warnings {
    let mut warnings = Warnings::default();
    verdict.unchecked.iter().for_each(|line| warnings.push(format!("not checked: {line}")));
    if !verdict.assumed.is_empty() {
        warnings.push(format!(
            "assumed, where the file has no limit: accelerations {} (--acceleration-time)",
            verdict.assumed.join(", ")
        ));
    }
    warnings
}

/// The check as JSON.
pub fn motion_check_json(verdict: &Verdict) -> Value {
    json!({
        "feasible": verdict.feasible(),
        "instants": verdict.instants,
        "violations": verdict.findings.iter().filter(|f| f.broken).map(finding).collect::<Vec<_>>(),
        "closest": verdict.findings.iter().map(finding).collect::<Vec<_>>(),
        "warnings": warnings(verdict).json(),
        "unchecked": verdict.unchecked,
        "assumed": verdict.assumed,
    })
}

fn finding(f: &crate::excite::check::Finding) -> Value {
    json!({"kind": f.kind, "who": f.who, "time": f.time, "value": f.value, "limit": f.limit, "broken": f.broken})
}

/// The check as text.
pub fn motion_check_text(verdict: &Verdict) -> String {
    let mut out = String::new();
    let broken = verdict.findings.iter().filter(|f| f.broken).count();
    for kind in [
        "position",
        "velocity",
        "acceleration",
        "jerk",
        "torque",
        "ground",
        "self_collision",
        "box",
        "rest",
        "consistency",
    ] {
        let of: Vec<_> = verdict.findings.iter().filter(|f| f.kind == kind).collect();
        if of.is_empty() {
            continue;
        }
        let bad: Vec<_> = of.iter().filter(|f| f.broken).collect();
        let _ = writeln!(
            out,
            "{kind}: {}",
            if bad.is_empty() { "kept".into() } else { format!("{} of {} broken", bad.len(), of.len()) }
        );
        for f in bad {
            let _ = writeln!(
                out,
                "  {} at {:.3} s: {} where {} is allowed",
                f.who,
                f.time,
                figure(f.value),
                figure(f.limit)
            );
        }
    }
    let _ = match broken {
        0 => writeln!(out, "feasible: {} instants looked at", verdict.instants),
        _ => writeln!(out, "not feasible: {} broken", counted(broken, "condition", "conditions")),
    };
    out + &warnings(verdict).text()
}
