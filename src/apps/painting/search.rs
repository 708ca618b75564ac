//! The search for the minimum of equation (12).
//!
//! 1. A grid: the whole wall and parts of it, both orientations of the roller, every branch of the
//!    inverse kinematics, swivel angles all around.
//! 2. Compass search in swivel, `Z_u`, `Z_l`, `Y_0` and `dY` from the best of them (`T_C` follows
//!    in closed form, see `leg_timing`).
//! 3. Beyond the paper: the angle at each way point, by dynamic programming over a grid, then
//!    pattern search in all variables. A leg depends only on its two ends, so the grid's optimum is
//!    exact.

use super::strokes::Strokes;
use super::surface::Roller;
use super::task::{Cover, Swivel, Task};
use crate::apps::painting::cost::{From, Judge, Scored};
use crate::apps::painting::leg_timing::{Grid, Leg, share_out};
use crate::numerics::pattern_search::{Effort, pattern_search};

/// Receives the progress of a search: its present step, and the share done of it.
pub type Progress<'a> = &'a dyn Fn(&'static str, f64);

/// Number of swivel angles in the first grid.
const ANGLES: usize = 24;
/// Number of angles to either side in the dynamic program, 10 degrees each if the angle is cyclic.
const REACH: usize = 18;
/// Largest change of the swivel within a leg, in grid angles.
const TURN: usize = 3;

pub(super) struct Search<'a> {
    pub judge: Judge<'a>,
    pub coarse: Grid,
    pub fine: Grid,
    progress: Progress<'a>,
}

impl<'a> Search<'a> {
    pub(super) fn new(task: &'a Task<'a>, progress: Progress<'a>) -> Self {
        Self { judge: Judge::new(task), coarse: Grid::new(16, 33), fine: Grid::new(28, 201), progress }
    }

    fn task(&self) -> &'a Task<'a> {
        self.judge.task
    }

    /// Returns the best candidate found, feasible or not, and the best with one swivel angle.
    pub(super) fn run(&self) -> (Scored, Option<Scored>) {
        let (mut best, redundant) = (self.constant(), self.task().redundancy().is_some());
        let mut plain = None;
        if redundant && self.task().swivel == Swivel::Spline {
            plain = Some(best.clone());
            self.spline(&mut best);
        }
        // Violations that show only between the coarse samples.
        (self.progress)("between samples", 0.0);
        best = self.again(&self.fine, &best);
        if !best.feasible() {
            self.polish(&self.fine, &mut best, 0.1, 6, 300);
        }
        (best, plain.map(|p| self.again(&self.fine, &p)))
    }

    /// Evaluates the same candidate on another grid.
    fn again(&self, grid: &Grid, scored: &Scored) -> Scored {
        let from = From::Near(&scored.start);
        let mut found = self.judge.cost(grid, &scored.strokes, &scored.angles, &scored.roller, from);
        found.swap_remove(0)
    }

    /// Steps 1 and 2 of the search.
    fn constant(&self) -> Scored {
        let task = self.task();
        let rollers = [false, true].map(|turned| Roller { turned, ..task.roller });
        let angles: Vec<f64> = match task.redundancy() {
            None => vec![0.0],
            Some(([low, high], closed)) => {
                let count = if closed { ANGLES } else { ANGLES + 1 };
                (0..count).map(|k| low + (high - low) * k as f64 / ANGLES as f64).collect()
            }
        };
        let parts = self.parts();
        let total = (parts.len() * rollers.len() * angles.len()) as f64;
        let mut done = 0.0;
        let mut list: Vec<Scored> = Vec::new();
        for strokes in &parts {
            let mut of_part: Vec<Scored> = Vec::new();
            for roller in &rollers {
                for angle in &angles {
                    of_part.extend(self.judge.cost(&self.coarse, strokes, &[*angle], roller, From::All));
                    done += 1.0;
                    (self.progress)("every posture", done / total);
                }
            }
            of_part.sort_by(|a, b| a.weight.total_cmp(&b.weight).then(a.cost.total_cmp(&b.cost)));
            of_part.truncate(if task.cover == Cover::Whole { 6 } else { 2 });
            list.extend(of_part);
        }
        list.sort_by(|a, b| a.weight.total_cmp(&b.weight).then(a.cost.total_cmp(&b.cost)));
        list.truncate(4);
        let count = list.len() as f64;
        let mut best: Option<Scored> = None;
        for (k, mut scored) in list.into_iter().enumerate() {
            (self.progress)("lanes and swivel", k as f64 / count);
            self.polish(&self.coarse, &mut scored, 1.0, 8, 900);
            if best.as_ref().is_none_or(|b| scored.beats(b, 1e-6)) {
                best = Some(scored);
            }
        }
        // The grid is never empty: `cost` always returns a candidate.
        best.unwrap_or_else(|| {
            let (strokes, roller) = (task.widest(), task.roller);
            self.judge.cost(&self.coarse, &strokes, &[0.0], &roller, From::All).swap_remove(0)
        })
    }

    /// The whole wall, and parts of it as further starts if the whole may be infeasible.
    fn parts(&self) -> Vec<Strokes> {
        let task = self.task();
        let whole = task.widest();
        let mut parts = vec![whole];
        if task.cover == Cover::Whole {
            return parts;
        }
        let ([left, right], [low, high]) = (task.surface.sides(), task.surface.ends());
        let gaps = whole.lanes.saturating_sub(1) as f64;
        for share in [0.7, 0.4] {
            for across in [0.0, 0.5, 1.0] {
                for along in [0.5, 0.0, 1.0] {
                    let height = share * (high - low);
                    let lower = low + along * (high - low - height);
                    let step = share * whole.step;
                    let room = (right - left - task.roller.width - gaps * step).max(0.0);
                    let first = left + 0.5 * (right - left - room - gaps * step) + across * room;
                    parts.push(Strokes { lower, upper: lower + height, first, step, ..whole });
                }
            }
        }
        parts
    }

    /// Search variables: the angles, then, if the area is free, `Z_u Z_l Y_0 dY`.
    fn variables(&self, scored: &Scored) -> Vec<f64> {
        let mut x = if self.task().redundancy().is_some() { scored.angles.clone() } else { Vec::new() };
        if self.task().cover == Cover::Most {
            let s = &scored.strokes;
            x.extend([s.upper, s.lower, s.first, s.step]);
        }
        x
    }

    /// Strokes and angles from search variables, which are first clamped to their valid range.
    fn meaning(&self, x: &mut [f64]) -> (Strokes, Vec<f64>) {
        let task = self.task();
        let mut strokes = task.widest();
        let free = if task.cover == Cover::Most { 4 } else { 0 };
        let (angles, lanes) = x.split_at_mut(x.len() - free);
        if let Some(([low, high], false)) = task.redundancy() {
            angles.iter_mut().for_each(|a| *a = a.clamp(low, high));
        }
        if let [upper, lower, first, step] = lanes {
            let ([left, right], [low, high]) = (task.surface.sides(), task.surface.ends());
            let (width, gaps) = (task.roller.width, strokes.lanes.saturating_sub(1) as f64);
            let least = 0.02 * (high - low);
            *upper = upper.clamp(low + least, high);
            *lower = lower.clamp(low, *upper - least);
            if right - left > width {
                *first = first.clamp(left + 0.5 * width, right - 0.5 * width);
                let room = right - 0.5 * width - *first;
                *step = if gaps > 0.0 { step.clamp(0.0, width.min(room / gaps)).max(1e-3 * width) } else { 0.0 };
            } else {
                (*first, *step) = (strokes.first, strokes.step);
            }
            (strokes.upper, strokes.lower, strokes.first, strokes.step) = (*upper, *lower, *first, *step);
        }
        (strokes, if angles.is_empty() { vec![0.0] } else { angles.to_vec() })
    }

    /// Compass search from a candidate.
    fn polish(&self, grid: &Grid, best: &mut Scored, first: f64, halvings: usize, budget: usize) {
        let task = self.task();
        let mut x = self.variables(best);
        if x.is_empty() {
            return;
        }
        let turn = match task.redundancy() {
            Some(([low, high], _)) => (high - low) / 36.0,
            None => 0.0,
        };
        let free = if task.cover == Cover::Most { 4 } else { 0 };
        let angles = x.len() - free;
        let mut scale = vec![turn; angles];
        let mut directions: Vec<Vec<f64>> = Vec::new();
        let mut push = |parts: &[(usize, f64)]| {
            let mut d = vec![0.0; x.len()];
            parts.iter().for_each(|&(k, size)| d[k] = size);
            directions.push(d);
        };
        if free > 0 {
            let (h, w) = (0.1 * task.surface.height, 0.1 * task.surface.width);
            scale.extend([h, h, w, w / task.lanes.saturating_sub(1).max(1) as f64]);
            push(&[(angles, 1.0), (angles + 1, 1.0)]);
            // Moves one edge and keeps the other.
            push(&[(angles + 2, 1.0), (angles + 3, -1.0)]);
        }
        if angles > 1 {
            push(&(0..angles).map(|k| (k, 1.0)).collect::<Vec<_>>());
        }
        let effort = Effort { first, halvings, budget, frames: if x.len() <= 8 { 2 } else { 1 } };
        let mut make = |x: &mut Vec<f64>, best: &Scored| {
            let (strokes, angles) = self.meaning(x);
            let from = From::Near(&best.start);
            let mut found = self.judge.cost(grid, &strokes, &angles, &best.roller, from);
            (!found.is_empty()).then(|| found.swap_remove(0))
        };
        pattern_search(&mut x, best, &scale, &directions, &effort, &mut make, &|a: &Scored, b: &Scored, size| {
            a.beats(b, (1e-3 * size).max(1e-6))
        });
    }

    /// Step 3 of the search.
    fn spline(&self, best: &mut Scored) {
        if best.legs.is_empty() {
            return;
        }
        for round in 0..2 {
            if let Some(angles) = self.dynamic(best, round) {
                let mut found = self.judge.cost(
                    &self.coarse,
                    &best.strokes,
                    &angles,
                    &best.roller,
                    From::Near(&self.start_at(best, angles[0])),
                );
                let found = found.swap_remove(0);
                if found.beats(best, 1e-6) {
                    *best = found;
                }
            }
            if best.angles.len() == 1 {
                best.angles = vec![best.angles[0]; self.judge.way_points(&best.strokes)];
            }
            (self.progress)("all variables", 0.5 * round as f64);
            self.polish(&self.coarse, best, 0.25, 5, 700);
        }
    }

    /// Start posture for another swivel angle, on the same branch.
    fn start_at(&self, best: &Scored, angle: f64) -> Vec<f64> {
        let lines = self.judge.lines(&best.strokes, &best.angles);
        let Some(first) = lines.first() else { return best.start.clone() };
        let (from, steps) = (first.from[3], 40);
        let mut q = best.start.clone();
        for k in 1..=steps {
            let mut way = first.from;
            way[3] = from + (angle - from) * f64::from(k) / f64::from(steps);
            let (list, _) = self.task().postures_at(&best.roller, &way);
            match self.task().nearest(&list, &q) {
                Some(next) => q = next,
                None => return best.start.clone(),
            }
        }
        q
    }

    /// Best angles at the way points in contact, on the grid around the candidate's own angles.
    fn dynamic(&self, best: &Scored, round: usize) -> Option<Vec<f64>> {
        let task = self.task();
        let ([low, high], closed) = task.redundancy()?;
        let step = (high - low) / 36.0 / if round == 0 { 1.0 } else { 3.0 };
        let contact: Vec<usize> = (0..best.legs.len()).filter(|&k| best.legs[k].line.phase.contact()).collect();
        if contact.is_empty() || best.times.len() != best.legs.len() {
            return None;
        }
        // Way points with their angle and posture: the ends of the legs in contact.
        let mut ways: Vec<([f64; 4], Vec<f64>)> = Vec::new();
        for (i, &k) in contact.iter().enumerate() {
            let leg = &best.legs[k];
            let row = |r: usize| leg.q.row(r).iter().copied().collect::<Vec<f64>>();
            if i == 0 {
                ways.push((leg.line.from, row(0)));
            }
            ways.push((leg.line.to, row(leg.q.nrows() - 1)));
        }
        // Per way point and angle: the posture on this branch.
        let count = 2 * REACH + 1;
        type Row = Vec<Option<(f64, Vec<f64>)>>;
        let states: Vec<Row> = ways
            .iter()
            .map(|(way, q)| {
                let mut row: Row = vec![None; count];
                row[REACH] = Some((way[3], q.clone()));
                for sign in [-1isize, 1] {
                    let mut here = q.clone();
                    for k in 1..=REACH as isize {
                        let angle = way[3] + step * (sign * k) as f64;
                        if !closed && !(low..=high).contains(&angle) {
                            break;
                        }
                        // Half steps, so that the branch is not lost.
                        let half = [way[0], way[1], way[2], angle - 0.5 * step * sign as f64];
                        let whole = [way[0], way[1], way[2], angle];
                        let go = |way: &[f64; 4], q: &[f64]| task.nearest(&task.postures_at(&best.roller, way).0, q);
                        match go(&half, &here).and_then(|q| go(&whole, &q)) {
                            Some(next) => here = next,
                            None => break,
                        }
                        row[(REACH as isize + sign * k) as usize] = Some((angle, here.clone()));
                    }
                }
                row
            })
            .collect();
        let weight = task.weights.jerk;
        let mut value: Vec<f64> = states[0].iter().map(|s| if s.is_some() { 0.0 } else { f64::INFINITY }).collect();
        let mut came: Vec<Vec<usize>> = Vec::new();
        for (i, &k) in contact.iter().enumerate() {
            (self.progress)("swivel spline", (i as f64 / contact.len() as f64 + round as f64) / 2.0);
            let given = task.duration.map(|_| best.times[k].0);
            let line = best.legs[k].line;
            let mut next = vec![f64::INFINITY; count];
            let mut from = vec![0; count];
            for b in 0..count {
                let Some((angle_b, q_b)) = &states[i + 1][b] else { continue };
                for a in b.saturating_sub(TURN)..=(b + TURN).min(count - 1) {
                    let Some((angle_a, q_a)) = &states[i][a] else { continue };
                    if !value[a].is_finite() {
                        continue;
                    }
                    let mut line = line;
                    (line.from[3], line.to[3]) = (*angle_a, *angle_b);
                    let all = task.postures(&best.roller, &line, &self.coarse.chebyshev.points);
                    let Ok(q) = task.follow(&all, q_a) else { continue };
                    let last = q.nrows() - 1;
                    if (0..q_b.len()).any(|j| (q[(last, j)] - q_b[j]).abs() > 1e-6) {
                        continue;
                    }
                    let leg = Leg::new(task, &self.judge.around, &self.coarse, line, q);
                    let time = match given {
                        Some(time) => time.max(leg.fastest.0),
                        None => share_out(&[leg.fastest.0], &[leg.jerk], weight, None)[0].0,
                    };
                    let jerk = if given.is_some() { weight.max(1e-3) } else { weight } * leg.jerk / time.powi(5);
                    let broken: f64 = leg.broken.iter().map(|b| b.weight).sum();
                    let total = value[a] + time + jerk + 1e4 * broken;
                    if total < next[b] {
                        next[b] = total;
                        from[b] = a;
                    }
                }
            }
            value = next;
            came.push(from);
        }
        let mut at = (0..count).filter(|&k| value[k].is_finite()).min_by(|&a, &b| value[a].total_cmp(&value[b]))?;
        let mut angles = vec![0.0; ways.len()];
        for i in (0..ways.len()).rev() {
            angles[i] = states[i][at].as_ref()?.0;
            if i > 0 {
                at = came[i - 1][at];
            }
        }
        Some(angles)
    }
}
