//! Designs a motion for a task. Several starts take a few steps each on a rough grid; the better
//! third continues on a coarse one, and the best of those on a fine one, checked between its
//! samples. The estimate of the criterion's curvature is passed on between the stages.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use crate::data::trajectory::Trajectory;
use crate::numerics::parallel::{parallel, threads};

use super::Criterion;
use super::constraints::{Constraint, Worst};
use super::error::DesignError;
use super::extra::Extra;
use super::information::{Conditions, Information};
use super::program::{Grid, Program};
use super::sqp::{Point, Search, Settings, better, minimise};
use super::start;
use super::task::Task;

/// Effort of a design. The result depends on it and on the task, but not on computing time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effort {
    /// Number of starting motions.
    pub starts: usize,
    /// Seed of the random starts.
    pub seed: u64,
    /// Largest number of steps from each start.
    pub iterations: usize,
    /// Number of starts that are run to the end.
    pub finalists: usize,
    /// Number of threads.
    pub threads: usize,
}

impl Default for Effort {
    fn default() -> Self {
        Self { starts: 24, seed: 1, iterations: 60, finalists: 2, threads: threads() }
    }
}

/// A step of the solver, for plots.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Record {
    /// Index of the start, from 0.
    pub start: usize,
    /// Smooth form of the criterion that is minimised, on the grid of the stage.
    pub value: f64,
    /// Largest constraint value.
    pub worst: f64,
}

/// Progress of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Number of steps done, over all starts.
    pub done: usize,
    /// Largest number of steps.
    pub total: usize,
    /// Best value so far among feasible motions, in the minimised form.
    pub best: Option<f64>,
    /// Largest constraint value of the last step.
    pub worst: f64,
}

/// Callbacks to follow and to stop a design.
pub struct Watch<'w> {
    /// Set to stop soon and return the best motion so far.
    pub stop: &'w AtomicBool,
    /// Progress callback, called from any thread.
    pub progress: &'w (dyn Fn(&Progress) + Sync),
}

/// A designed motion with its figures.
#[derive(Debug, Clone)]
pub struct Design {
    /// The motion.
    pub trajectory: Trajectory,
    /// Its search variables, for a further run.
    pub variables: Vec<f64>,
    /// Name of the criterion.
    pub criterion: &'static str,
    /// Value of the criterion at the task's rate, with the exact sign in Coulomb columns.
    pub value: f64,
    /// Condition number and determinants with the task's weights and scales.
    pub scaled: Conditions,
    /// The same of the selected columns of the base regressor, unscaled: the paper's equation (9).
    pub plain: Conditions,
    /// Whether every constraint holds on the finest grid.
    pub feasible: bool,
    /// The tightest constraint of each kind, without margins.
    pub closest: Vec<Worst>,
    /// Whether the run was stopped before its end.
    pub stopped: bool,
    /// History of all starts.
    pub history: Vec<Record>,
    /// Value that each start reached on the rough grid, if feasible; the better ones continued.
    pub starts: Vec<Option<f64>>,
}

/// Fineness of the grids of a stage.
#[derive(Debug, Clone, Copy)]
struct Level {
    /// Sampling rate of the criterion and of the constraints, Hz.
    rate: f64,
    /// Number of hull pieces per interval.
    refine: usize,
}

impl Level {
    /// The task on these grids: at least a hundred samples, at most the task's rate.
    fn program<'a>(&self, task: &'a Task<'a>) -> Program<'a> {
        let rate = self.rate.max(100.0 / task.curve.design_duration());
        Program::new(task, rate.min(task.rate), rate, self.refine)
    }
}

/// Grid for all starts: a few steps decide which of them continue.
const ROUGH: Level = Level { rate: 10.0, refine: 2 };
/// Grid for those that continue.
const COARSE: Level = Level { rate: 20.0, refine: 4 };
/// Grid for the finalists.
const FINE: Level = Level { rate: 50.0, refine: 12 };
/// Sampling rate of the final check, Hz.
const FINEST: f64 = 500.0;

/// Designs a motion.
///
/// # Errors
/// Returns an error if no posture is clear of everything, or no motion was found inside the limits,
/// with the constraint and its place.
pub fn design(task: &Task<'_>, effort: &Effort, watch: &Watch<'_>) -> Result<Design, DesignError> {
    let home = start::home(task).map_err(|worst| DesignError::Blocked(worst.what))?;
    let powers = task.criterion.powers();
    let starts = effort.starts.max(1);
    let kept = starts.div_ceil(3);
    let finalists = effort.finalists.min(kept).max(1);
    let first = (effort.iterations / 4).max(1);
    let total = starts * first + kept * effort.iterations + finalists * 2 * effort.iterations;
    let counter = AtomicUsize::new(0);
    let best = Mutex::new(None::<f64>);
    let histories: Mutex<Vec<(usize, usize, Vec<Record>)>> = Mutex::new(Vec::new());
    // One stage, for the history: (part, start).
    let run = |program: &Program<'_>, search: &mut Search, stages: &[(f64, Settings)], part: usize, start: usize| {
        let mut records = Vec::new();
        for (power, settings) in stages {
            let mut visit = |at: &Point| {
                records.push(Record { start, value: at.value, worst: at.worst });
                let done = counter.fetch_add(1, Ordering::Relaxed);
                if let Ok(mut best) = best.lock() {
                    if at.worst <= 0.0 && best.is_none_or(|b| at.value < b) {
                        *best = Some(at.value);
                    }
                    (watch.progress)(&Progress { done, total, best: *best, worst: at.worst });
                }
                !watch.stop.load(Ordering::Relaxed)
            };
            minimise(program, search, *power, settings, &mut visit);
            if watch.stop.load(Ordering::Relaxed) {
                break;
            }
        }
        if let Ok(mut all) = histories.lock() {
            all.push((part, start, records));
        }
    };

    // Rough grid: every start.
    let rough = ROUGH.program(task);
    let settings = Settings { iterations: first, patience: 4, gain: 1e-3 };
    let mut searches: Vec<(usize, Search)> = parallel(effort.threads, starts, |k| {
        if k > 0 && watch.stop.load(Ordering::Relaxed) {
            return None;
        }
        let x = start::random_motion(task, &rough, &home, effort.seed, k as u64);
        let mut search = Search::new(x, 1.0);
        run(&rough, &mut search, &[(powers[0], settings)], 0, k);
        Some((k, search))
    })
    .into_iter()
    .flatten()
    .collect();
    let reached: Vec<Option<f64>> =
        searches.iter().map(|(_, s)| (s.point.worst <= 0.0).then_some(s.point.value)).collect();
    keep(&mut searches, kept);

    // Coarse grid: the better ones.
    let coarse = COARSE.program(task);
    let stages: Vec<(f64, Settings)> = powers
        .iter()
        .map(|&power| {
            let iterations = effort.iterations.div_ceil(powers.len());
            (power, Settings { iterations, patience: 4, gain: 3e-4 })
        })
        .collect();
    let mut searches = parallel(effort.threads, searches.len(), |k| {
        let (start, mut search) = searches[k].clone();
        run(&coarse, &mut search, &stages, 1, start);
        (start, search)
    });
    keep(&mut searches, finalists);

    // Fine grid: the best of them, with margins that grow until the finest grid has no violations.
    let last = powers[powers.len() - 1];
    let mut ended = parallel(effort.threads, searches.len(), |k| {
        let (start, search) = searches[k].clone();
        finish(task, search, |program, search, round| {
            let iterations = if round == 0 { effort.iterations } else { effort.iterations.div_ceil(2) };
            run(program, search, &[(last, Settings { iterations, patience: 5, gain: 5e-5 })], 2 + round, start);
        })
    });
    ended.sort_by(|a, b| {
        (!a.feasible, a.point.value).partial_cmp(&(!b.feasible, b.point.value)).unwrap_or(std::cmp::Ordering::Equal)
    });
    let chosen = ended.into_iter().next().ok_or(DesignError::NoStart)?;
    let mut histories = histories.into_inner().unwrap_or_default();
    histories.sort_by_key(|h| (h.0, h.1));
    let history = histories.into_iter().flat_map(|h| h.2).collect();
    let stopped = watch.stop.load(Ordering::Relaxed);
    assess(task, chosen, history, reached, stopped)
}

/// Keeps the best `count` searches, in order.
fn keep(searches: &mut Vec<(usize, Search)>, count: usize) {
    searches.sort_by(|a, b| match (better(&a.1.point, &b.1.point), better(&b.1.point, &a.1.point)) {
        (true, false) => std::cmp::Ordering::Less,
        (false, true) => std::cmp::Ordering::Greater,
        _ => a.0.cmp(&b.0),
    });
    searches.truncate(count);
}

struct Ended {
    point: Point,
    feasible: bool,
}

/// Repeats `run` with a program, the search and the round, until the finest grid has no violations.
fn finish(task: &Task<'_>, mut search: Search, run: impl Fn(&Program<'_>, &mut Search, usize)) -> Ended {
    let mut own = task.clone();
    for round in 0.. {
        run(&FINE.program(&own), &mut search, round);
        let excess = finest(task, &search.point.x);
        let (torque, distance) =
            excess.iter().fold((f64::NEG_INFINITY, f64::NEG_INFINITY), |(t, d), (c, v, _)| match c {
                Constraint::Torque(_) => (t.max(*v), d),
                _ => (t, d.max(*v)),
            });
        let feasible = torque <= 0.0 && distance <= 0.0;
        if feasible || round == 3 {
            return Ended { point: search.point, feasible };
        }
        // Violations between the samples are added to the margins.
        own.torque_margin += 1.2 * torque.max(0.0) + 1e-4;
        own.distance_margin += 0.12 * distance.max(0.0) + 1e-5;
    }
    Ended { point: search.point, feasible: false }
}

/// Largest value of every constraint on the finest grid, without margins, and its time, s.
fn finest(task: &Task<'_>, x: &[f64]) -> Vec<(Constraint, f64, f64)> {
    let grid = Grid::new(&task.curve, FINEST);
    let bare = Task { torque_margin: 0.0, distance_margin: 0.0, ..task.clone() };
    let constraints = bare.constraints();
    let list = constraints.list();
    let values = constraints.values(&list, &grid.states(x));
    let len = grid.times.len();
    list.iter()
        .enumerate()
        .map(|(k, &c)| {
            let row = &values[k * len..(k + 1) * len];
            let (s, value) =
                row.iter().enumerate().fold((0, f64::NEG_INFINITY), |m, (s, v)| if *v > m.1 { (s, *v) } else { m });
            (c, value, grid.times[s])
        })
        .collect()
}

fn assess(
    task: &Task<'_>,
    ended: Ended,
    history: Vec<Record>,
    starts: Vec<Option<f64>>,
    stopped: bool,
) -> Result<Design, DesignError> {
    let x = ended.point.x;
    let trajectory = task.curve.trajectory(&x).ok_or(DesignError::NoMotion)?;
    let excess = finest(task, &x);
    let bare = Task { torque_margin: 0.0, distance_margin: 0.0, ..task.clone() };
    let constraints = bare.constraints();
    let mut closest: Vec<Worst> = Vec::new();
    for kind in 0..4 {
        let of = |c: &Constraint| match c {
            Constraint::Torque(_) => 0,
            Constraint::Ground(_) => 1,
            Constraint::Pair(_) => 2,
            Constraint::Box(_) => 3,
        };
        let worst = excess.iter().filter(|(c, ..)| of(c) == kind).max_by(|a, b| a.1.total_cmp(&b.1));
        closest.extend(worst.map(|(c, v, t)| Worst { what: constraints.describe(*c, *v), time: *t, excess: *v }));
    }
    let grid = Grid::new(&task.curve, task.rate);
    let states = grid.states(&x);
    let information = Information::new(&task.columns(), &states, &task.scaling(1.0));
    let plain = Task { prior: None, noise: vec![1.0; task.dof()], scale: Vec::new(), ..task.clone() };
    let scaled = information.conditions();
    let plain = Information::new(&plain.columns(), &states, &plain.scaling(1.0)).conditions();
    let power = task.criterion.powers().last().copied().unwrap_or(1.0);
    let minimised = information.judge(&task.criterion, power).map_or(f64::INFINITY, |j| j.0);
    if !minimised.is_finite() {
        return Err(undetermined(task, &information));
    }
    Ok(Design {
        value: task.criterion.reported(&scaled, minimised),
        criterion: task.criterion.name(),
        trajectory,
        variables: x,
        scaled,
        plain,
        feasible: ended.feasible,
        closest,
        stopped,
        history,
        starts,
    })
}

/// Reason why the criterion has no value: columns that no motion of this arm separates, or that
/// this motion does not.
fn undetermined(task: &Task<'_>, information: &Information) -> DesignError {
    let columns = task.columns();
    let names = |which: &[usize]| which.iter().map(|&k| columns.names()[k].clone()).collect();
    let never = Information::new(&columns, &start::anywhere(task), &task.scaling(1.0)).undetermined();
    match never.is_empty() {
        true => DesignError::Uninformative(names(&information.undetermined())),
        false => DesignError::Inseparable { columns: names(&never), payload: task.payload },
    }
}

/// Designs the motion that best separates two hypotheses: `first` and `second` give the columns
/// that each adds to the base regressor. It maximises the part of either that the base parameters
/// and the other can't explain. Everything else is as in the task, whose criterion and extra
/// columns are replaced.
///
/// # Errors
/// As for [`design`].
pub fn discriminate(
    task: &Task<'_>,
    first: &dyn Extra,
    second: &dyn Extra,
    effort: &Effort,
    watch: &Watch<'_>,
) -> Result<Design, DesignError> {
    let both = super::extra::Both::new(first, second);
    let (base, a, b) = (task.base.len() + 10 * usize::from(task.payload), first.columns(), second.columns());
    let criterion = Criterion::Separation((base..base + a).collect(), (base + a..base + a + b).collect());
    let own = Task { criterion, extra: Some(&both), scale: Vec::new(), prior: None, ..task.clone() };
    design(&own, effort, watch)
}
