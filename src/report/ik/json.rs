//! Report of `denavit ik` as JSON.

use dh_codegen::arm::Inverse;
use dh_codegen::ik::{Family, Status};
use serde_json::{Value, json};

use crate::model::inverse_kinematics::{Answer, LockedRange, SwivelRange};

/// Name of the status in the JSON.
pub(in crate::report) fn status(status: Status) -> &'static str {
    match status {
        Status::Ok => "ok",
        Status::Unreachable => "unreachable",
        Status::Singular => "singular",
    }
}

/// Distance from the limits; null without limits, since JSON has no infinity.
fn margin(margin: f64) -> Value {
    if margin.is_finite() { json!(margin) } else { Value::Null }
}

fn range(r: &SwivelRange) -> Value {
    let best = r.best.map(|(swivel, m)| json!({ "swivel": swivel, "limit_margin": margin(m) }));
    json!({ "branch": r.branch.to_string(), "intervals": r.intervals, "best": best })
}

fn locked(r: &LockedRange) -> Value {
    let best = r.best.map(|(position, m)| json!({ "position": position, "limit_margin": margin(m) }));
    json!({ "intervals": r.intervals, "best": best })
}

/// Name of the solution method.
fn method(inverse: &Inverse) -> &'static str {
    match (&inverse.family, inverse.exact) {
        (Family::Numerical, _) => "numerical search",
        (Family::General(_), _) => "elimination",
        (_, true) => "closed form",
        (_, false) => "closed form of a nominal arm, refined",
    }
}

/// `{"class", "poses": [{"status", "solutions": [..]}]}`.
pub fn ik_json(name: &str, inverse: &Inverse, redundant: bool, poses: &[Answer]) -> Value {
    let pose = |answer: &Answer| {
        let p = &answer.postures;
        let solutions: Vec<Value> = p
            .list
            .iter()
            .map(|s| {
                let mut v = json!({
                    "q": s.q,
                    "branch": s.branch.to_string(),
                    "position_error": s.position_error,
                    "rotation_error": s.rotation_error,
                    "within_limits": s.within_limits,
                    "limit_margin": margin(s.margin),
                });
                if !s.free.is_empty() {
                    v["free_joints"] = json!(s.free.iter().map(|j| j + 1).collect::<Vec<_>>());
                }
                v
            })
            .collect();
        let mut v = json!({ "status": status(p.status), "solutions": solutions });
        if p.status == Status::Unreachable {
            v["distance"] = json!({ "position": p.distance[0], "rotation": p.distance[1] });
            // Only an exact solver proves that there is no posture.
            v["not_found"] = json!(!inverse.exact || p.uncertain);
        }
        if redundant {
            v["swivel"] = json!(p.redundancy);
            // The parameter is not a swivel angle but the position of this joint.
            if let Some(joint) = inverse.family.locked() {
                v["locked_joint"] = json!(joint + 1);
            }
        }
        if p.second_plane {
            v["reference_plane"] = json!("second");
        }
        if let (Some(ranges), true) = (&answer.swivel, p.status != Status::Unreachable) {
            v["swivel_intervals"] = ranges.iter().map(range).collect();
        }
        // Other positions of the joint may reach a pose that this one does not.
        if let Some(ranges) = &answer.locked {
            v["locked_intervals"] = locked(ranges);
        }
        if !inverse.exact || matches!(inverse.family, Family::General(_)) {
            v["branches_lost"] = json!(p.lost);
            v["branches_uncertain"] = json!(p.uncertain);
        }
        v
    };
    json!({
        "name": name,
        "class": inverse.class,
        "exact": inverse.exact,
        "method": method(inverse),
        "poses": poses.iter().map(pose).collect::<Vec<_>>(),
    })
}
