//! The motions: one of 10 s for each of the paper's criteria, and one of 20 s for validation,
//! designed at run time by [`crate::excite`].

use std::sync::atomic::AtomicBool;

use super::Watch;
use super::lwr::Lwr;
use super::{DesignObstacle, ReproduceError};
use crate::apps::paper::tool::PAPER_TORQUE_NOISE;
use crate::excite::{self, Criterion, Effort, Task, design};
use crate::model::differentiated::Differentiated;
use crate::simulate;

/// A motion with its figures.
#[derive(Debug, Clone)]
pub struct PaperMotion {
    /// `cond`, `logdet`, `hadamard`; [`LINKS`]; `tool`; `validate`.
    pub name: &'static str,
    /// Duration, s.
    pub seconds: f64,
    /// Condition number of the base regressor: the paper's `J_c`.
    pub condition: f64,
    /// `log det W'W`: minus the paper's `J_d`.
    pub log_det: f64,
    /// Largest speed of each joint, as a share of its limit.
    pub speed: Vec<f64>,
    /// Trajectory for the simulator.
    pub played: simulate::Trajectory,
}

/// The paper's three criteria (equation 9).
pub const CRITERIA: [(&str, Criterion); 3] =
    [("cond", Criterion::Condition), ("logdet", Criterion::LogDet), ("hadamard", Criterion::Hadamard)];

/// Motion by the condition number of the links' columns, without friction's: the paper does not
/// state which of the two its `J_c` is.
pub const LINKS: &str = "cond of links";

/// Duration of an exciting motion, s (section III.D), and of the validating one (section III.E).
const SECONDS: [f64; 2] = [10.0, 20.0];
/// Time in which joints without an acceleration limit (the LWR's are not published) may reach their
/// speed limit, s.
pub(super) const ACCELERATION_TIME: f64 = 0.5;

/// Designs all six motions: those of the three criteria, that of the condition number without
/// friction, one for the load, and last the validating one. For the load the criterion is log det
/// of equation 7's loaded part, joints weighted by their noise; the paper does not state how it
/// moved its rollers. The seed selects the random motions with which the search starts.
pub fn motions(lwr: &Lwr, seed: u64, watch: Watch<'_>) -> Result<Vec<PaperMotion>, ReproduceError> {
    let arm = Differentiated::new(&lwr.robot);
    let asked = CRITERIA.into_iter().chain([(LINKS, Criterion::Condition), ("tool", Criterion::LogDet)]);
    let asked = asked.map(|(name, criterion)| (name, criterion, SECONDS[0], Effort::default().starts, seed));
    // Large and fast, from another criterion and other starts than the fitted motions.
    let validate = ("validate", Criterion::Hadamard, SECONDS[1], 1, seed ^ 0x5eed);
    let mut all = Vec::new();
    for (k, (name, criterion, seconds, starts, seed)) in asked.chain([validate]).enumerate() {
        let tell = |share: f64| watch(&format!("designing {name}"), (k as f64 + share) / 6.0);
        all.push(designed(lwr, &arm, name, criterion, seconds, Effort { starts, seed, ..Effort::default() }, &tell)?);
    }
    Ok(all)
}

/// Designs one motion. The name `tool` selects the criterion for the load.
pub(super) fn designed(
    lwr: &Lwr,
    arm: &Differentiated,
    name: &'static str,
    criterion: Criterion,
    seconds: f64,
    effort: Effort,
    tell: &(dyn Fn(f64) + Sync),
) -> Result<PaperMotion, ReproduceError> {
    let what = format!("the motion `{name}`");
    let mut task = Task::new(arm, &lwr.robot, seconds, ACCELERATION_TIME).map_err(ReproduceError::design(&what))?;
    task.criterion = criterion;
    if name == LINKS {
        task.links_only();
    }
    if name == "tool" {
        task.payload = true;
        task.base.clear();
        task.noise = PAPER_TORQUE_NOISE.to_vec();
    }
    let progress = |p: &excite::Progress| tell(p.done as f64 / p.total.max(1) as f64);
    let watch = excite::Watch { stop: &AtomicBool::new(false), progress: &progress };
    let found = design(&task, &effort, &watch).map_err(ReproduceError::design(&what))?;
    if !found.feasible {
        return Err(ReproduceError::design(&what)(DesignObstacle::OutsideLimits));
    }
    let (t, states) = found.trajectory.sampled(100.0);
    let largest = |j: usize| {
        let dq = &states.dq[j * states.len..(j + 1) * states.len];
        dq.iter().fold(0.0_f64, |m, v| m.max(v.abs()))
    };
    let speed = task.limits.iter().enumerate().map(|(j, limit)| largest(j) / limit.velocity).collect();
    let played = simulate::Trajectory::new(lwr.robot.dof(), t, states.q, Some(states.dq), Some(states.ddq));
    Ok(PaperMotion {
        name,
        seconds,
        condition: found.plain.condition,
        log_det: found.plain.log_det,
        speed,
        played: played.map_err(simulate::SimulateError::from)?,
    })
}
