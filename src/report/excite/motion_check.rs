//! The verdict on a written motion.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::excite::check::Verdict;
use crate::report::parts::number::figure;

/// As JSON.
pub fn motion_check_json(verdict: &Verdict) -> Value {
    json!({
        "feasible": verdict.feasible(),
        "instants": verdict.instants,
        "violations": verdict.findings.iter().filter(|f| f.broken).map(finding).collect::<Vec<_>>(),
        "closest": verdict.findings.iter().map(finding).collect::<Vec<_>>(),
        "unchecked": verdict.unchecked,
        "assumed": verdict.assumed,
    })
}

fn finding(f: &crate::excite::check::Finding) -> Value {
    json!({"kind": f.kind, "who": f.who, "time": f.time, "value": f.value, "limit": f.limit, "broken": f.broken})
}

/// For people.
pub fn motion_check_text(verdict: &Verdict) -> String {
    let mut out = String::new();
    for line in &verdict.unchecked {
        let _ = writeln!(out, "not checked: {line}");
    }
    if !verdict.assumed.is_empty() {
        let _ = writeln!(
            out,
            "assumed, where the file has no limit: accelerations {} (--acceleration-time)",
            verdict.assumed.join(", ")
        );
    }
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
        _ => writeln!(out, "not feasible: {broken} conditions broken"),
    };
    out
}
