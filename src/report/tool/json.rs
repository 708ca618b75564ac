//! Report of `denavit tool` as JSON. A number that does not exist is `null`.

use serde_json::{Map, Value, json};

use crate::data::signal::Prepared;
use crate::identify::Standing;
use crate::identify::tool::{Found, InToolFrame, Interval, RobotErrors, names};
use crate::report::Provenance;
use crate::report::Warnings;

/// The result as one JSON object.
pub fn tool_json(found: &Found, logs: &[Prepared], warnings: &Warnings, provenance: &Provenance) -> Value {
    let carried = &found.carried;
    let recognition = found.recognition.as_ref();
    let body = carried.body.as_ref().map(|b| {
        json!({
            "mass": b.mass,
            "center": b.center,
            "center_std": b.center_std,
            "tensor_at_center": b.tensor,
            "principal_moments": b.principal_moments,
            "principal_axes": b.principal_axes,
            "impossible": b.impossible,
        })
    });
    let recognised = recognition.map(|r| {
        let nearest = r.nearest();
        json!({
            "name": nearest.name,
            "distance": nearest.distance,
            "rejected": r.rejected,
            "limit": r.limit,
            "level": r.level,
            "probability": nearest.probability,
            "not_distinguished_from": r.not_distinguished_from,
            "by_plain_distance": r.by_plain_distance,
            "parameters_told": r.determined,
        })
    });
    let candidates: Vec<Value> = recognition
        .iter()
        .flat_map(|r| &r.candidates)
        .map(|c| {
            json!({
                "name": c.name,
                "distance": c.distance,
                "distance_in_space": c.distance_in_space,
                "plain_distance": c.plain_distance,
                "probability": c.probability,
                "deviations": c.deviations,
            })
        })
        .collect();
    let pca = recognition.map(|r| {
        json!({
            "components": r.pca.components(),
            "singular_values": r.pca.singular_values,
            "explained": r.pca.explained,
            "scores": r.scores.as_slice(),
        })
    });
    let relative = found.relative.as_ref().map(|r| {
        json!({
            "family": r.family,
            "members": r.members,
            "length": interval(&r.length),
            "width": interval(&r.width),
            "distance": r.distance,
            "limit": r.limit,
            "fits": r.fits,
            "extrapolated": r.extrapolated,
        })
    });
    let errors: Vec<Value> = carried
        .logs
        .iter()
        .map(|log| {
            json!({
                "name": log.name,
                "loaded": log.loaded,
                "seconds": log.seconds,
                "rms": log.with_tool.rms,
                "rms_robot_alone": log.robot_alone.rms,
                "torque_rms": log.with_tool.torque_rms,
            })
        })
        .collect();
    let log_findings = logs.iter().flat_map(|log| log.findings.iter().map(|f| (log.file.as_str(), f)));
    let findings: Vec<Value> = log_findings
        .map(|(file, f)| json!({ "file": file, "what": f.to_string() }))
        .chain(carried.solved.findings.iter().map(|f| json!({ "file": null, "what": f.to_string() })))
        .collect();
    let provenance: Map<String, Value> = provenance.iter().map(|(k, v)| (k.clone(), json!(v))).collect();
    let covariance: Vec<&[f64]> = carried.covariance.chunks(10).collect();
    json!({
        "robot": carried.robot,
        "warnings": warnings.json(),
        "frame": "last",
        "parameter_names": names(),
        "M": carried.values[0],
        "MS": carried.values[1..4],
        "I": carried.values[4..],
        "std": carried.std,
        "relative_std_percent": carried.relative_std_percent(),
        "covariance": covariance,
        "standing": carried.standing.map(|s| match s {
            Standing::Identified => "identified",
            Standing::NotIdentifiable => "not_identifiable",
            Standing::Dropped => "dropped",
        }),
        "known_mass": carried.known_mass,
        "mass_std": carried.known_mass.map(|_| carried.mass_std),
        "mass_of_logs": carried.mass_of_logs.map(|[mass, std]| serde_json::json!({ "M": mass, "std": std })),
        "robot_identified": carried.robot_errors == RobotErrors::Identified, "robot_errors": robot_errors(carried.robot_errors),
        "body": body,
        "recognised": recognised,
        "candidates": candidates,
        "pca": pca,
        "size": relative,
        "tool_frame": found.in_tool_frame.as_ref().map(in_tool_frame),
        "logs": errors,
        "noise": { "sigma": carried.noise.sigma, "effective_samples": carried.noise.effective_samples },
        "condition_number": carried.solved.condition.plain,
        "samples": carried.solved.samples,
        "findings": findings,
        "provenance": provenance,
    })
}

fn robot_errors(errors: RobotErrors) -> &'static str {
    match errors {
        RobotErrors::Identified => "identified",
        RobotErrors::Counted => "counted",
        RobotErrors::NotCounted => "not_counted",
    }
}

fn interval(i: &Interval) -> Value {
    json!({ "value": i.value, "std": i.std, "interval": i.ends })
}

fn in_tool_frame(frame: &InToolFrame) -> Value {
    json!({
        "tool": frame.tool,
        "rotation": frame.pose.0,
        "origin": frame.pose.1,
        "M": frame.values[0],
        "MS": frame.values[1..4],
        "I": frame.values[4..],
        "std": frame.std,
    })
}
