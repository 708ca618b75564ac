//! Whether a joint's torque was recorded with the other sign.

use super::{
    stack::Factors,
    wls::{JointSystem, Problem, Solution, stacked},
};
use crate::{
    arm::Arm,
    log::{Finding, Kind, Severity},
};

fn finding(joint: usize, correlation: f64) -> Finding {
    let column = Some(format!("tau{}", joint + 1));
    Finding { kind: Kind::Sign { correlation }, severity: Severity::Warning, line: None, column, count: 1 }
}

/// Fewer batches than these tell nothing of a sign.
const BATCHES: usize = 3;

/// Whether the joint's regressor keeps its direction, as that of an arm that stands does: next to rank one.
fn stands(joint: &JointSystem) -> bool {
    let n = joint.columns.len() + 1;
    let entry = |i: usize, k: usize| joint.gram[i + k * n];
    let trace: f64 = (0..n - 1).map(|k| entry(k, k)).sum();
    let squares: f64 = (0..n - 1).flat_map(|i| (0..n - 1).map(move |k| (i, k))).map(|(i, k)| entry(i, k).powi(2)).sum();
    squares.sqrt() > 0.99 * trace
}

/// With a model: joints whose torque runs against what it predicts (correlation below -0.5; of a joint in one posture, where an offset or a payload may
/// say the same, below -0.95).
pub(super) fn against_model(joints: &[JointSystem], beta: &[f64]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (index, joint) in joints.iter().enumerate().filter(|(_, j)| j.samples > 0) {
        let n = joint.columns.len();
        let mut x: Vec<f64> = joint.columns.iter().map(|&c| beta[c]).collect();
        x.push(0.0);
        let predicted = joint.triangle.apply(&x);
        let measured = joint.triangle.column(n);
        let inner: f64 = predicted.iter().zip(measured).map(|(a, b)| a * b).sum();
        let norm = |v: &[f64]| v.iter().map(|a| a * a).sum::<f64>().sqrt();
        let correlation = inner / (norm(&predicted) * norm(measured));
        let most = if stands(joint) { -0.95 } else { -0.5 };
        if correlation < most && joint.batches.len() >= BATCHES {
            findings.push(finding(index, correlation));
        }
    }
    findings
}

/// Without a model: joints whose torque, turned about, agrees far better with the equations of the others; and joints whose
/// friction and rotor inertia all come out negative beyond doubt.
pub(super) fn against_fit(arm: &dyn Arm, problem: &Problem<'_>, solution: &Solution, std: &[f64]) -> Vec<Finding> {
    let parameters = arm.base_parameters();
    let mut findings = Vec::new();
    let scale: Vec<f64> = problem.joints.iter().map(|j| j.torque_rms.max(f64::MIN_POSITIVE).recip()).collect();
    let residual = |weights: &[f64], turned: Option<usize>| -> f64 {
        let mut joints = problem.joints.to_vec();
        if let Some(joint) = turned {
            joints[joint].turn();
        }
        let p = solution.active.len();
        let triangle = stacked(&joints, weights, &solution.active, problem.parameters);
        triangle.get(p, p).abs()
    };
    let as_is = residual(&scale, None);
    for (index, joint) in problem.joints.iter().enumerate().filter(|(_, j)| j.samples > 0) {
        let drive: Vec<usize> = ["IA", "FV", "FC"]
            .iter()
            .filter_map(|kind| {
                parameters.iter().position(|p| p.name.trim_end_matches('R') == format!("{kind}{}", index + 1))
            })
            .collect();
        let negative = drive.len() >= 2 && drive.iter().all(|&c| solution.beta[c] < -3.0 * std[c]);
        // Of two joints that contradict each other, the one whose friction came out negative is the one to turn about.
        let friction = drive.iter().filter(|&&c| !parameters[c].name.starts_with("IA"));
        let brakes = friction.clone().count() > 0 && friction.clone().all(|&c| solution.beta[c] > 0.0);
        // Torque that is next to nothing says nothing about its sign.
        let better = residual(&scale, Some(index)) < 0.5 * as_is;
        if joint.torque_rms > 0.0 && (negative || (better && !brakes)) {
            let explained =
                1.0 - (joint.residual_norm(&solution.beta) / joint.torque_rms).powi(2) / joint.samples as f64;
            findings.push(finding(index, if negative { -1.0 } else { explained.max(0.0).sqrt() }));
        }
    }
    findings
}

/// Which of the logs has the joint's torque the wrong way about, by the identified model.
pub(super) fn by_log(log: &Factors, beta: &[f64]) -> Vec<Finding> {
    against_model(&JointSystem::all(std::slice::from_ref(log), log.parameters), beta)
}
