//! Report of `denavit identify` as JSON. A number that does not exist is `null`.

use serde_json::{Map, Value, json};

use crate::data::log::{Finding, Severity};
use crate::data::signal::Prepared;
use crate::identify::{Accuracy, Dropped, Identification, Standing};
use crate::report::Provenance;
use crate::report::Warnings;
use crate::report::parts::budget;

/// The result as one JSON object.
pub fn identify_json(found: &Identification, logs: &[Prepared], warnings: &Warnings, provenance: &Provenance) -> Value {
    let parameters: Vec<Value> = found
        .parameters
        .iter()
        .map(|p| {
            json!({
                "name": p.name,
                "value": p.value,
                "relative_std_percent": p.relative_std_percent(),
                "std": p.std,
                "unit": p.unit,
                "grouping": p.grouping,
                "standing": match p.standing {
                    Standing::Identified => "identified",
                    Standing::NotIdentifiable => "not_identifiable",
                    Standing::Dropped => "dropped",
                },
                "prior": p.prior,
            })
        })
        .collect();
    let each = |pick: fn(&Accuracy) -> Value| {
        let of = |a: &Option<Accuracy>| a.as_ref().map_or(Value::Null, pick);
        json!({
            "fit": pick(&found.fit),
            "validate": of(&found.validation),
            "fit_before": of(&found.fit_before),
            "validate_before": of(&found.validation_before),
        })
    };
    let n = found.parameters.len();
    let correlation: Vec<&[f64]> = found.correlation.chunks(n.max(1)).collect();
    let summaries: Vec<Value> = found
        .logs
        .iter()
        .map(|log| {
            json!({
                "name": log.name,
                "validates": log.validates,
                "seconds": log.seconds,
                "samples": log.samples,
                "rms": log.accuracy.rms,
                "nrms": log.accuracy.nrms,
                "torque_rms": log.accuracy.torque_rms,
            })
        })
        .collect();
    let log_findings = logs.iter().flat_map(|log| log.findings.iter().map(|f| (Some(log.file.as_str()), f)));
    let findings: Vec<Value> =
        log_findings.chain(found.findings.iter().map(|f| (None, f))).map(|(file, f)| finding(file, f)).collect();
    let provenance: Map<String, Value> = provenance.iter().map(|(k, v)| (k.clone(), json!(v))).collect();
    json!({
        "robot": found.robot,
        "verdict": if found.underdetermined().is_some() { "underdetermined" } else { "determined" },
        "warnings": warnings.json(),
        "parameters": parameters,
        "rms": each(|a| json!(a.rms)),
        "nrms": each(|a| json!(a.nrms)),
        "torque_rms": each(|a| json!(a.torque_rms)),
        "relative_error_percent": each(|a| json!(a.relative_error_percent())),
        "condition_number": found.condition.plain,
        "condition": {
            "plain": found.condition.plain,
            "weighted": found.condition.weighted,
            "scaled": found.condition.scaled,
        },
        "samples": found.samples,
        "independent_samples": found.independent,
        "unknowns": found.unknowns,
        "noise": {
            "sigma": found.noise.sigma,
            "inflation": found.noise.inflation,
            "effective_samples": found.noise.effective_samples,
            "batches": found.noise.batches,
        },
        "error_budget": budget::json(found.budget.as_ref()),
        "weighted": found.weighted,
        "iterations": found.iterations,
        "not_distinguished": found.confused.iter().map(|c| json!({"parameters": c.parameters, "open": c.open})).collect::<Vec<_>>(),
        "dropped": found.dropped.iter().map(dropped).collect::<Vec<_>>(),
        "correlation": correlation,
        "logs": summaries,
        "findings": findings,
        "provenance": provenance,
    })
}

fn dropped(d: &Dropped) -> Value {
    json!({
        "name": d.name,
        "value": d.value,
        "relative_std_percent": d.relative_std_percent,
        "f": d.f,
        "limit": d.limit,
        "residual_growth_percent": d.residual_growth_percent,
    })
}

fn finding(file: Option<&str>, f: &Finding) -> Value {
    json!({
        "file": file,
        "line": f.line,
        "column": f.column,
        "severity": match f.severity {
            Severity::Note => "note",
            Severity::Warning => "warning",
            Severity::Fatal => "fatal",
        },
        "what": f.what(),
        "advice": f.advice(),
        "count": f.count,
    })
}
