//! Detects logs that cannot come from one robot: a common fit has a far larger residual than
//! separate ones.

use crate::data::log::{Finding, Kind, Severity};
use crate::identify::regression::accumulator::Factors;
use crate::identify::regression::wls::{JointSystem, stacked};

/// Ratio of errors (root mean square) above which logs contradict each other. Below it, separate
/// fits may gain just by having more parameters, or because the model is slightly wrong everywhere.
/// On the real recordings of one robot it is 1.0 to 1.5.
const TIMES: f64 = 2.0;

/// Reports whether the logs contradict each other, and which one disagrees most with the rest.
/// `weights`: of the joints, as in the fit.
pub(in crate::identify) fn log_consistency(logs: &[Factors], weights: &[f64], parameters: usize) -> Option<Finding> {
    let active: Vec<usize> = (0..parameters).collect();
    let factor = |logs: &[Factors]| stacked(&JointSystem::all(logs, parameters), weights, &active, parameters);
    // Norm of the residual of the best parameters for these logs.
    let left = |logs: &[Factors]| factor(logs).get(parameters, parameters).abs();
    if logs.len() < 2 {
        return None;
    }
    let whole = factor(logs);
    let together = whole.get(parameters, parameters).abs();
    let alone: Vec<f64> = logs.iter().map(|log| left(std::slice::from_ref(log))).collect();
    let apart = alone.iter().map(|a| a * a).sum::<f64>().sqrt();
    let times = together / apart;
    // The rounding residual of an exact fit has no meaning.
    let measured = whole.column(parameters).iter().map(|v| v * v).sum::<f64>().sqrt();
    if !(times.is_finite() && times > TIMES && together > 1e-3 * measured) {
        return None;
    }
    // The log without which the others agree best; of two logs neither can be blamed.
    let without = |k: usize| {
        let rest: Vec<Factors> = logs.iter().enumerate().filter(|(i, _)| *i != k).map(|(_, log)| log.clone()).collect();
        left(&rest).hypot(alone[k])
    };
    let worst = (logs.len() > 2)
        .then(|| (0..logs.len()).map(|k| (k, without(k))).min_by(|a, b| a.1.total_cmp(&b.1)))
        .flatten()
        .map(|(k, _)| logs[k].name.clone());
    let kind = Kind::Disagree { times, worst };
    Some(Finding { kind, severity: Severity::Warning, line: None, column: None, count: 1 })
}
