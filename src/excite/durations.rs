//! The criterion as a function of the duration (the paper's figure 5).

use std::sync::atomic::AtomicBool;

use super::Curve;
use super::criterion::Criterion;
use super::design::{Effort, Progress, Watch, design};
use super::task::Task;

/// One criterion at one duration.
#[derive(Debug, Clone, PartialEq)]
pub struct AtDuration {
    /// Name of the criterion.
    pub criterion: &'static str,
    /// Duration, s.
    pub seconds: f64,
    /// Value of the criterion; `None` if there is no motion inside the limits or a column has no
    /// information.
    pub value: Option<f64>,
    /// Condition number of the unscaled columns.
    pub condition: Option<f64>,
    /// Value minus that of the next shorter duration (negative: better).
    pub change: Option<f64>,
}

/// Designs a motion for every criterion and duration (ascending), with way points spaced as in the
/// task. `tell` is called with the index of the running design, from 0, and its progress.
pub fn by_duration(
    task: &Task<'_>,
    criteria: &[Criterion],
    durations: &[f64],
    effort: &Effort,
    tell: &(dyn Fn(usize, &Progress) + Sync),
) -> Vec<AtDuration> {
    let spacing = match task.curve {
        Curve::Spline { duration, intervals } => duration / intervals as f64,
        Curve::Fourier { .. } => 1.0,
    };
    let mut rows: Vec<AtDuration> = Vec::new();
    for criterion in criteria {
        let mut before: Option<f64> = None;
        for &seconds in durations {
            let intervals = ((seconds / spacing).round() as usize).max(1);
            let curve = Curve::Spline { duration: seconds, intervals };
            let own = Task { criterion: criterion.clone(), curve, ..task.clone() };
            let (stop, run) = (AtomicBool::new(false), rows.len());
            let watch = Watch { stop: &stop, progress: &|p: &Progress| tell(run, p) };
            let found = design(&own, effort, &watch).ok().filter(|found| found.feasible);
            let value = found.as_ref().map(|found| found.value).filter(|v| v.is_finite());
            rows.push(AtDuration {
                criterion: criterion.name(),
                seconds,
                value,
                condition: found.map(|found| found.plain.condition).filter(|c| c.is_finite()),
                change: before.zip(value).map(|(before, value)| value - before),
            });
            before = value;
        }
    }
    rows
}
