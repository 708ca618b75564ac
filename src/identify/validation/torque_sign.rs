//! Detects joints whose torque was recorded with the opposite sign.

use nalgebra::DMatrix;

use crate::data::log::{Finding, Kind, Severity};
use crate::identify::regression::accumulator::Factors;
use crate::identify::regression::wls::{JointSystem, Problem, Solution, positions, stacked};
use crate::model::{Arm, DriveTerm};

fn finding(joint: usize, correlation: f64) -> Finding {
    let column = Some(format!("tau{}", joint + 1));
    Finding { kind: Kind::Sign { correlation }, severity: Severity::Warning, line: None, column, count: 1 }
}

/// Fewest batches from which a sign can be judged.
const BATCHES: usize = 3;

/// Whether the joint's regressor keeps its direction (is nearly of rank one), like that of an arm
/// at rest.
fn stands(joint: &JointSystem) -> bool {
    let n = joint.columns.len() + 1;
    let entry = |i: usize, k: usize| joint.gram[i + k * n];
    let trace: f64 = (0..n - 1).map(|k| entry(k, k)).sum();
    let squares: f64 = (0..n - 1).flat_map(|i| (0..n - 1).map(move |k| (i, k))).map(|(i, k)| entry(i, k).powi(2)).sum();
    squares.sqrt() > 0.99 * trace
}

/// Share of the arm's largest torque that stiction and sensor offsets may reach. Friction holds a
/// resting joint anywhere between its levels, and torque sensors have offsets. On real arms they
/// reach some percent of the rated torque (a Staubli TX40: 7 %).
const STICTION: f64 = 0.02;
/// Required ratio of the prediction to its own standard deviation and, for a joint at rest, to
/// friction.
const SURE: f64 = 3.0;
/// Largest travel, rad (m), at which a joint may not have been sliding. Within its teeth a gear is
/// a spring with hysteresis, and its friction has no sign.
const TRAVEL: f64 = 0.05;

/// Base parameters with which torques are compared, and their covariance.
pub(in crate::identify) struct Model<'a> {
    /// Base parameters of the model.
    pub(in crate::identify) beta: &'a [f64],
    /// Covariance of the active parameters, and their indices; `None` if the model is given.
    pub(in crate::identify) covariance: Option<(&'a DMatrix<f64>, &'a [usize])>,
}

impl Model<'_> {
    /// Variance of the predicted torque, mean over the samples, N^2 m^2.
    fn variance(&self, joint: &JointSystem) -> f64 {
        let Some((covariance, active)) = self.covariance else { return 0.0 };
        let (pairs, n) = (joint.active(&positions(active, self.beta.len())), joint.columns.len() + 1);
        let sum: f64 = pairs
            .iter()
            .flat_map(|&(i, p)| pairs.iter().map(move |&(k, q)| (i, p, k, q)))
            .map(|(i, p, k, q)| covariance[(p, q)] * joint.gram[i + k * n])
            .sum();
        sum.max(0.0) / joint.samples.max(1) as f64
    }

    /// Joints whose torque opposes the model's prediction (correlation below -0.5). The prediction
    /// must exceed its own standard deviation threefold and, with the sign reversed, be nearer to
    /// the torque than zero is. For a joint in one posture an offset or a payload may be the cause.
    /// There the correlation must be below -0.95 and the prediction well above friction.
    pub(in crate::identify) fn opposed(&self, joints: &[JointSystem]) -> Vec<Finding> {
        let mut findings = Vec::new();
        let largest = joints.iter().map(|j| j.torque_rms).fold(0.0, f64::max);
        for (index, joint) in joints.iter().enumerate().filter(|(_, j)| j.samples > 0) {
            let n = joint.columns.len();
            let mut x: Vec<f64> = joint.columns.iter().map(|&c| self.beta[c]).collect();
            x.push(0.0);
            let predicted = joint.triangle.apply(&x);
            let measured = joint.triangle.column(n);
            let inner: f64 = predicted.iter().zip(measured).map(|(a, b)| a * b).sum();
            let norm = |v: &[f64]| v.iter().map(|a| a * a).sum::<f64>().sqrt();
            let (of_model, of_log) = (norm(&predicted), norm(measured));
            let correlation = inner / (of_model * of_log);
            let size = of_model / (joint.samples as f64).sqrt();
            let (most, least) = if stands(joint) { (-0.95, SURE * STICTION * largest) } else { (-0.5, 0.0) };
            // |tau + W beta| < |tau|
            let explains = of_model < -2.0 * correlation * of_log;
            let counts = size > least && size > SURE * self.variance(joint).sqrt();
            if correlation < most && explains && counts && joint.batches.len() >= BATCHES {
                findings.push(finding(index, correlation));
            }
        }
        findings
    }

    /// The same for a single log.
    pub(in crate::identify) fn opposed_by(&self, log: &Factors) -> Vec<Finding> {
        self.opposed(&JointSystem::all(std::slice::from_ref(log), log.parameters))
    }
}

/// Without a model: joints whose reversed torque agrees far better with the equations of the
/// others, and joints whose friction and rotor inertia are all significantly negative.
pub(in crate::identify) fn against_fit(
    arm: &dyn Arm,
    problem: &Problem<'_>,
    solution: &Solution,
    std: &[f64],
) -> Vec<Finding> {
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
        // A drive's column occurs in its own joint's row alone.
        let own = |term| joint.columns.iter().copied().find(|&c| parameters[c].is_drive_term(term));
        let drive: Vec<usize> = [DriveTerm::IA, DriveTerm::FV, DriveTerm::FC].into_iter().filter_map(own).collect();
        let turned = residual(&scale, Some(index));
        let slid = joint.travel > TRAVEL;
        let negative = slid && drive.len() >= 2 && drive.iter().all(|&c| solution.beta[c] < -3.0 * std[c]);
        // Of two joints that contradict each other, the one with negative friction is to be
        // reversed.
        let friction = drive.iter().filter(|&&c| !parameters[c].leader.is_rotor());
        let brakes = friction.clone().count() > 0 && friction.clone().all(|&c| solution.beta[c] > 0.0);
        // A zero torque has no information on its sign.
        let better = turned < 0.5 * as_is;
        if joint.torque_rms > 0.0 && (negative || (better && !brakes)) {
            let explained =
                1.0 - (joint.residual_norm(&solution.beta) / joint.torque_rms).powi(2) / joint.samples as f64;
            findings.push(finding(index, if negative { -1.0 } else { explained.max(0.0).sqrt() }));
        }
    }
    findings
}
