//! A simulation as JSON; independent of the run time.

use serde_json::{Value, json};

use crate::data::log::Quantity;
use crate::numerics::sums::root_mean_square;
use crate::report::Warnings;
use crate::simulate::{Method, Mode, Recording, Request};

/// `{"robot", "control", "seed", "seconds_simulated", "samples", "columns", "integration",
/// "torque_rms", "warnings"}`.
pub fn simulate_json(robot: &str, recording: &Recording, request: &Request, warnings: &Warnings) -> Value {
    let Recording { log, truth, .. } = recording;
    let len = log.len();
    let mode = Mode::ALL.iter().find(|(_, mode)| *mode == request.control.mode).map_or("", |(name, _)| name);
    let integration = recording.integration.map(|i| {
        let method = if i.method == Method::DormandPrince { "dormand-prince" } else { "rosenbrock" };
        json!({ "method": method, "steps": i.steps, "rejected": i.rejected })
    });
    let torques: Vec<f64> =
        (0..log.layout.dof).map(|j| root_mean_square(log.joint(Quantity::Tau, j).unwrap_or_default())).collect();
    json!({
        "robot": robot,
        "warnings": warnings.json(),
        "control": mode,
        "seed": request.seed,
        "seconds_simulated": truth.t[len - 1] - truth.t[0],
        "samples": len,
        "columns": log.layout.roles.iter().map(|r| r.name()).collect::<Vec<_>>(),
        "integration": integration,
        "torque_rms": torques,
    })
}
