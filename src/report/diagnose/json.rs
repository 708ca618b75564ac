//! `diagnose --json`: the keys of docs/diagnose.md. A number that does not exist is `null`.

use serde_json::{Map, Value, json};

use crate::data::signal::Prepared;
use crate::diagnose::{Cause, Diagnosis, Errors};
use crate::report::Provenance;
use crate::report::Warnings;
use crate::report::diagnose::doubts::doubts;
use crate::report::parts::budget;

/// The result as one JSON object.
pub fn diagnose_json(found: &Diagnosis, logs: &[Prepared], warnings: &Warnings, provenance: &Provenance) -> Value {
    let rms = |e: &Errors| json!({ "rms": { "fit": e.fit, "validate": e.validate, "validate_moving": e.moving } });
    let findings: Vec<Value> = logs
        .iter()
        .flat_map(|log| log.findings.iter().map(|f| json!({ "log": log.file, "finding": f.to_string() })))
        .collect();
    json!({
        "robot": found.robot,
        "verdict": found.verdict.word(),
        "noise_floor": found.noise_floor,
        "error_budget": budget::json(Some(&found.budget)),
        "torque_rms": found.torque_rms,
        "baseline": rms(&found.baseline),
        "refitted": rms(&found.refitted),
        "changed_between_logs": !found.changed.is_empty(),
        "changes": { "joints": found.changed, "causes": found.changes.iter().map(cause).collect::<Vec<_>>() },
        "causes": found.causes.iter().map(cause).collect::<Vec<_>>(),
        "rejected": found.rejected.iter().map(|r| json!({
            "cause": r.cause,
            "joints": r.joints,
            "probability": r.probability,
            "why": r.why,
        })).collect::<Vec<_>>(),
        "extended": rms(&found.extended),
        "offer": {
            "model": found.offer.offered.word(),
            "left_out": { "file": found.offer.left_out[0], "refitted": found.offer.left_out[1], "extended": found.offer.left_out[2] },
            "why": found.offer.why,
        },
        "links_refitted": found.links_refitted,
        "transmission": found.transmission,
        "own_validation": found.own_validation,
        "seconds": { "fit": found.seconds[0], "validate": found.seconds[1] },
        "next_experiment": found.next_experiment.as_ref().map(|next| json!({
            "between": next.between,
            "joints": next.joints,
            "motion": next.motion,
        })),
        "warnings": warnings.json(),
        "findings": findings,
        "position_band": found.band.map(|band| json!({ "cutoff": band.cutoff, "removes": band.removes })),
        "provenance": provenance.iter().map(|(k, v)| (k.clone(), Value::from(v.as_str()))).collect::<Map<_, _>>(),
    })
}

fn cause(c: &Cause) -> Value {
    let values: Map<String, Value> = c.parameters.iter().map(|p| (p.symbol.clone(), json!(p.value))).collect();
    let stds: Map<String, Value> =
        c.parameters.iter().filter_map(|p| p.std.map(|s| (p.symbol.clone(), json!(s)))).collect();
    let mut found = json!({
        "cause": c.cause,
        "joints": c.joints,
        "probability": c.probability,
        "in_extended": c.in_extended,
        "recurrence": c.recurrence,
        "found_in_excerpts": c.found_again,
        "parameters": values,
        "parameters_std": stds,
        "evidence": c.evidence,
        "against": doubts(c),
        "gain": {
            "rms_before": c.rms_before,
            "rms_after": c.rms_after,
            "on": c.on,
            "share_interval": c.interval.map(|x| if x.is_finite() { json!(x) } else { Value::Null }),
        },
        "not_distinguished_from": c.not_distinguished_from,
        "shown_by": c.decided_by.unwrap_or(c.shown_by),
    });
    if let Some(law) = &c.law {
        found["law"] = json!(law);
    }
    found
}
