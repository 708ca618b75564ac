//! The shortest motion after which every essential parameter has the required precision.

use crate::data::trajectory::Trajectory;

use super::Curve;
use super::design::{Design, Effort, Watch, design};
use super::error::ShortestError;
use super::precision::{Expected, expected};
use super::task::Task;

/// A motion that reaches the target, and the durations tried.
#[derive(Debug, Clone)]
pub struct Shortest {
    /// The motion.
    pub design: Design,
    /// Expected precision after it.
    pub expected: Vec<Expected>,
    /// Durations tried, s, with the largest relative standard deviation of an essential parameter,
    /// percent (`None`: no feasible motion).
    pub tried: Vec<(f64, Option<f64>)>,
}

/// A motion, its expected precision, and the least precise essential parameter with its percentage.
type Attempt = (Design, Vec<Expected>, Option<(String, f64)>);

/// Searches by bisection over durations in steps of half a second up to that of the task, as longer
/// motions have more information. Essential parameters are those that are essential in the longest
/// motion.
///
/// # Errors
/// Returns an error if not even the longest motion reaches the target (with its value and the
/// parameter), no nominal values are known, or no motion is feasible.
pub fn shortest(task: &Task<'_>, percent: f64, effort: &Effort, watch: &Watch<'_>) -> Result<Shortest, ShortestError> {
    let Curve::Spline { duration, intervals } = task.curve else {
        return Err(ShortestError::Splines);
    };
    let spacing = duration / intervals as f64;
    let mut essential: Option<Vec<bool>> = None;
    let mut tried = Vec::new();
    let mut attempt = |seconds: f64| -> Result<Attempt, ShortestError> {
        let intervals = ((seconds / spacing).round() as usize).max(1);
        let own = Task { curve: Curve::Spline { duration: seconds, intervals }, ..task.clone() };
        let found = design(&own, effort, watch)?;
        let mut expected = expected(&own, &played(&found.trajectory, own.rate));
        let mask = essential.get_or_insert_with(|| expected.iter().map(|e| e.essential == Some(true)).collect());
        expected.iter_mut().zip(mask.iter()).for_each(|(e, m)| e.essential = e.essential.map(|_| *m));
        let worst = expected
            .iter()
            .zip(mask.iter())
            .filter(|(_, m)| **m)
            .filter_map(|(e, _)| Some((e.name.clone(), e.relative_percent()?)))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        tried.push((seconds, worst.as_ref().filter(|_| found.feasible).map(|w| w.1)));
        Ok((found, expected, worst))
    };
    let (found, values, worst) = attempt(duration)?;
    let Some((name, reached)) = worst else {
        return Err(no_relative_precision(task, &values));
    };
    if reached > percent || !found.feasible {
        return Err(ShortestError::Missed { duration, target: percent, parameter: name, reached });
    }
    let mut best = (found, values);
    // In half seconds: `low` fails, `high` succeeds.
    let (mut low, mut high) = (1, (2.0 * duration).floor() as usize);
    while high - low > 1 {
        let middle = low.midpoint(high);
        match attempt(0.5 * middle as f64) {
            Ok((found, values, Some((_, reached)))) if found.feasible && reached <= percent => {
                best = (found, values);
                high = middle;
            }
            _ => low = middle,
        }
    }
    Ok(Shortest { design: best.0, expected: best.1, tried })
}

/// Reason why no parameter has a relative precision.
fn no_relative_precision(task: &Task<'_>, values: &[Expected]) -> ShortestError {
    let unknown = values.iter().all(|e| e.value.is_none());
    match (unknown, task.payload) {
        (true, true) => ShortestError::NoBody,
        (true, false) => ShortestError::NoLinks,
        _ => ShortestError::NoEssential,
    }
}

/// States of a motion sampled at a rate, Hz.
pub(super) fn played(motion: &Trajectory, rate: f64) -> crate::model::States {
    motion.sampled(rate).1
}
