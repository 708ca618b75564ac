//! The motions: for each of the paper's criteria one of 10 s, and one of 20 s to validate on, designed here and now by [`crate::excite`].

use std::sync::atomic::AtomicBool;

use super::{ReproduceError, Watch, lwr::Lwr};
use crate::differentiated::Differentiated;
use crate::excite::{self, Criterion, Effort, Task, design};
use crate::simulate;

/// A motion and its figures.
#[derive(Debug, Clone)]
pub struct Motion {
    /// `cond`, `logdet`, `hadamard`; `validate`.
    pub name: &'static str,
    /// Length, s.
    pub seconds: f64,
    /// Condition number of the base regressor: the paper's `J_c`.
    pub condition: f64,
    /// `log det W'W`: minus the paper's `J_d`.
    pub log_det: f64,
    /// Largest speed of each joint, as a part of its limit.
    pub speed: Vec<f64>,
    /// For the simulator.
    pub played: simulate::Trajectory,
}

/// The paper's three criteria (equation 9).
pub const CRITERIA: [(&str, Criterion); 3] =
    [("cond", Criterion::Condition), ("logdet", Criterion::LogDet), ("hadamard", Criterion::Hadamard)];

/// Length of an exciting motion, s (section III.D), and of the one that validates (section III.E).
const SECONDS: [f64; 2] = [10.0, 20.0];
/// Time in which joints without a limit of acceleration (the LWR's are not published) may reach their speed, s.
const ACCELERATION_TIME: f64 = 0.5;

/// Designs all four; the last one validates. The seeds say which random motions the search starts with.
pub fn motions(lwr: &Lwr, seed: u64, watch: Watch<'_>) -> Result<Vec<Motion>, ReproduceError> {
    let arm = Differentiated::new(&lwr.robot);
    let asked = CRITERIA.into_iter().map(|(name, criterion)| (name, criterion, SECONDS[0], 4, seed));
    // Large and fast, for another criterion's sake and from other starts than what is judged on it.
    let validate = ("validate", Criterion::Hadamard, SECONDS[1], 1, seed ^ 0x5eed);
    let mut all = Vec::new();
    for (k, (name, criterion, seconds, starts, seed)) in asked.chain([validate]).enumerate() {
        let failed = |why: String| ReproduceError::Design { what: format!("the motion `{name}`"), why };
        let mut task = Task::new(&arm, &lwr.robot, seconds, ACCELERATION_TIME).map_err(failed)?;
        task.criterion = criterion;
        let effort = Effort { starts, seed, ..Effort::default() };
        let progress = |p: &excite::Progress| {
            watch(&format!("designing {name}"), (k as f64 + p.done as f64 / p.total.max(1) as f64) / 4.0);
        };
        let found = design(&task, &effort, &excite::Watch { stop: &AtomicBool::new(false), progress: &progress })
            .map_err(failed)?;
        if !found.feasible {
            return Err(failed("no motion inside all limits was found".into()));
        }
        let (t, states) = found.trajectory.sampled(100.0);
        let limits = task.limits.iter().map(|l| l.velocity);
        let speed = limits.enumerate().map(|(j, limit)| {
            let dq = &states.dq[j * states.len..(j + 1) * states.len];
            dq.iter().fold(0.0_f64, |m, v| m.max(v.abs())) / limit
        });
        all.push(Motion {
            name,
            seconds,
            condition: found.plain.condition,
            log_det: found.plain.log_det,
            speed: speed.collect(),
            played: simulate::Trajectory::new(
                lwr.robot.dof(),
                t,
                states.q.clone(),
                Some(states.dq.clone()),
                Some(states.ddq.clone()),
            )
            .map_err(simulate::SimulateError::from)?,
        });
    }
    Ok(all)
}
