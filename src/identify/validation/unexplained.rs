//! Reports joints whose torque the fitted model can't explain: the log or the robot file has an
//! error that no parameter can fix.

use crate::data::log::{Finding, Kind, Severity, Unexplained};
use crate::identify::regression::wls::JointSystem;
use crate::identify::validation::accuracy::Accuracy;
use crate::model::{BaseParameter, DriveTerm};

/// Least unexplained share of a joint's torque that is reported.
const SHARE: f64 = 0.3;
/// Least torque of a reported joint, as a share of the largest joint's: the last joints carry
/// little but friction and the sensors' errors.
const LOADED: f64 = 0.2;

/// One finding for each such joint. `parameters`: of the model; `systems`: of the joints.
pub(in crate::identify) fn unexplained(
    fit: &Accuracy,
    parameters: &[BaseParameter],
    systems: &[JointSystem],
) -> Vec<Finding> {
    let is_friction = |c: usize| [DriveTerm::FV, DriveTerm::FC].iter().any(|&term| parameters[c].is_drive_term(term));
    let brakes = |joint: usize| systems[joint].columns.iter().any(|&c| is_friction(c));
    let largest = fit.torque_rms.iter().copied().filter(|t| t.is_finite()).fold(0.0, f64::max);
    let joints = fit.rms.iter().zip(&fit.torque_rms).enumerate();
    let bad = joints.filter(|(_, (rms, torque))| **torque >= LOADED * largest && **rms > SHARE * **torque);
    bad.map(|(joint, (rms, torque))| Finding {
        kind: Kind::Unexplained {
            percent: 100.0 * rms / torque,
            reason: if brakes(joint) { Unexplained::Open } else { Unexplained::NoFriction },
        },
        severity: Severity::Warning,
        line: None,
        column: Some(format!("tau{}", joint + 1)),
        count: 1,
    })
    .collect()
}
