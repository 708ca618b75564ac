//! Report of `denavit import` as JSON.

use dh_codegen::robot::effects::{CoulombFriction, ViscousFriction};
use serde_json::{Map, Value, json};

use crate::exchange::{Imported, Neighbours};

/// Result of the import.
pub fn import_json(made: &Imported) -> Value {
    let robot = &made.robot;
    let joints: Vec<Value> = robot
        .joints
        .iter()
        .map(|j| {
            json!({
                "name": j.name, "type": format!("{:?}", j.kind).to_lowercase(), "alpha": j.alpha.value, "d": j.d.value,
                "theta": j.theta.value, "r": j.r.value, ViscousFriction::NAME: j.drive.viscous_friction,
                CoulombFriction::NAME: j.drive.coulomb_friction,
            })
        })
        .collect();
    let held: Map<String, Value> = made.held.iter().map(|(name, q)| (name.clone(), json!(q))).collect();
    let neighbours: Vec<Value> =
        made.neighbours.iter().map(|(case, angle)| json!({ "case": word(*case), "angle": angle })).collect();
    json!({
        "name": robot.name,
        "format": made.format,
        "model": made.model,
        "base": made.base,
        "tip": made.tip,
        "dof": robot.dof(),
        "joints": joints,
        "neighbours": neighbours,
        "forward_kinematics_error": { "position": made.error.position, "rotation": made.error.rotation },
        "exact_angles": { "count": made.snap.count, "largest_change": made.snap.largest },
        "bodies": made.bodies,
        "held": held,
        "unknown": made.unknown,
        "impossible": made.impossible,
        "notes": made.notes,
    })
}

fn word(case: Neighbours) -> &'static str {
    match case {
        Neighbours::Skew => "skew",
        Neighbours::Crossing => "crossing",
        Neighbours::Parallel => "parallel",
        Neighbours::AntiParallel => "anti_parallel",
        Neighbours::OneLine => "one_line",
        Neighbours::NearlyParallel => "nearly_parallel",
    }
}
