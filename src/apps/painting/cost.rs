//! Evaluation of one candidate of equation (12): from lanes and swivel angles to cost and violated
//! limits.

use super::strokes::Strokes;
use super::surface::Roller;
use super::task::Task;
use super::track::{Line, Postures};
use crate::apps::painting::clearance::Clearance;
use crate::apps::painting::leg_timing::{Bound, Broken, Grid, Leg, share_out};

/// Start of a candidate's postures.
#[derive(Clone, Copy)]
pub(super) enum From<'a> {
    /// All postures of the first way point.
    All,
    /// The posture nearest to this one.
    Near(&'a [f64]),
}

/// An evaluated candidate on one branch of the inverse kinematics.
#[derive(Debug, Clone)]
pub(super) struct Scored {
    pub strokes: Strokes,
    /// Swivel angle at each way point in contact, rad; a single value holds for all.
    pub angles: Vec<f64>,
    pub roller: Roller,
    /// Posture at the start, rad or m.
    pub start: Vec<f64>,
    /// Sum of the violations' weights; zero if the candidate is feasible.
    pub weight: f64,
    pub broken: Vec<Broken>,
    /// Cost of equation (12), s; infinite if unknown.
    pub cost: f64,
    /// Legs on this branch; empty if the branch was lost.
    pub legs: Vec<Leg>,
    /// Time of each leg, s, and the limit that determines it.
    pub times: Vec<(f64, Bound)>,
    /// Time in contact `T_C`, s; `jerk` is the integral of the squared jerks over it, rad^2/s^5.
    pub contact: f64,
    pub jerk: f64,
}

impl Scored {
    /// Whether this is better than `other`, by at least `share`. Violations are compared before the
    /// cost.
    pub(super) fn beats(&self, other: &Self, share: f64) -> bool {
        let slack = 1e-9 + share * other.weight;
        if self.weight < other.weight - slack || self.weight == 0.0 && other.weight > 0.0 {
            return true;
        }
        self.weight <= other.weight && self.cost < other.cost * (1.0 - share)
    }

    pub(super) fn feasible(&self) -> bool {
        self.weight == 0.0 && self.cost.is_finite()
    }

    /// Limit with the largest violation.
    pub(super) fn worst(&self) -> Option<Broken> {
        self.broken.iter().copied().max_by(|a, b| a.weight.total_cmp(&b.weight))
    }
}

/// Penalty for a branch that cannot be followed at all, so that marginally violated limits count
/// less.
const LOST: f64 = 10.0;

/// A task with quantities that are computed once.
pub(super) struct Judge<'a> {
    pub task: &'a Task<'a>,
    pub around: Clearance,
}

impl<'a> Judge<'a> {
    pub(super) fn new(task: &'a Task<'a>) -> Self {
        let around = Clearance::new(task.arm, task.bodies.clone(), task.surface, task.distance_margin);
        Self { task, around }
    }

    /// Lines of the legs with their swivel angles: one angle, or one per way point in contact.
    pub(super) fn lines(&self, strokes: &Strokes, angles: &[f64]) -> Vec<Line> {
        let legs = strokes.legs(self.task.standoff);
        let way = |p: [f64; 3], k: usize| [p[0], p[1], p[2], angles.get(k).or(angles.last()).copied().unwrap_or(0.0)];
        let mut at = 0;
        legs.iter()
            .map(|leg| {
                let before = at;
                at += usize::from(leg.phase.contact());
                Line { phase: leg.phase, from: way(leg.from, before), to: way(leg.to, at) }
            })
            .collect()
    }

    /// Number of way points in contact.
    pub(super) fn way_points(&self, strokes: &Strokes) -> usize {
        1 + strokes.legs(self.task.standoff).iter().filter(|l| l.phase.contact()).count()
    }

    /// Evaluates all branches that begin at `from`; never empty.
    pub(super) fn cost(
        &self,
        grid: &Grid,
        strokes: &Strokes,
        angles: &[f64],
        roller: &Roller,
        from: From<'_>,
    ) -> Vec<Scored> {
        let task = self.task;
        let lines = self.lines(strokes, angles);
        let mut all: Vec<Postures> = Vec::with_capacity(lines.len());
        for (k, line) in lines.iter().enumerate() {
            let back = k > 0 && line.from == lines[k - 1].to && line.to == lines[k - 1].from;
            let found = if back { reversed(&all[k - 1]) } else { task.postures(roller, line, &grid.chebyshev.points) };
            all.push(found);
        }
        let nothing = Scored {
            strokes: *strokes,
            angles: angles.to_vec(),
            roller: *roller,
            start: vec![0.0; task.dof()],
            weight: 0.0,
            broken: Vec::new(),
            cost: f64::INFINITY,
            legs: Vec::new(),
            times: Vec::new(),
            contact: 0.0,
            jerk: 0.0,
        };
        let out_of_reach: Vec<Broken> = lines
            .iter()
            .zip(&all)
            .filter(|(_, p)| p.distance[0] + p.distance[1] > 0.0)
            .map(|(line, p)| {
                // Relative size of m and rad as in the weight; the larger violation is reported in
                // its own unit.
                let [place, turn] = [p.distance[0] / 0.1, p.distance[1]];
                let (bound, amount) =
                    if place >= turn { (Bound::OutOfReach, p.distance[0]) } else { (Bound::Direction, p.distance[1]) };
                Broken { bound, amount, weight: place + turn, at: line.place(grid.chebyshev.points[p.farthest]) }
            })
            .collect();
        let first = all.first().and_then(|p| p.lists.first()).cloned().unwrap_or_default();
        if !out_of_reach.is_empty() {
            let start = match from {
                From::All => first.into_iter().next().unwrap_or_else(|| nothing.start.clone()),
                From::Near(q) => q.to_vec(),
            };
            let weight = 2.0 * LOST + out_of_reach.iter().map(|b| b.weight).sum::<f64>();
            return vec![Scored { start, weight, broken: out_of_reach, ..nothing }];
        }
        let starts = match from {
            From::All => first,
            From::Near(q) => task.nearest(&first, q).into_iter().collect(),
        };
        let found: Vec<Scored> = starts
            .into_iter()
            .map(|start| self.branch(grid, &lines, &all, Scored { start, ..nothing.clone() }))
            .collect();
        if found.is_empty() {
            let at = lines.first().map_or([0.0; 3], |l| l.place(0.0));
            let lost = Broken { bound: Bound::Singular, amount: 0.0, weight: 1.0, at };
            return vec![Scored { weight: 2.0 * LOST, broken: vec![lost], ..nothing }];
        }
        found
    }

    fn branch(&self, grid: &Grid, lines: &[Line], all: &[Postures], mut scored: Scored) -> Scored {
        let task = self.task;
        let mut here = scored.start.clone();
        for (k, (line, postures)) in lines.iter().zip(all).enumerate() {
            match task.follow(postures, &here) {
                Ok(q) => {
                    here = q.row(q.nrows() - 1).iter().copied().collect();
                    scored.legs.push(Leg::new(task, &self.around, grid, *line, q));
                }
                Err(point) => {
                    let at = line.place(grid.chebyshev.points[point]);
                    let left = (lines.len() - k) as f64 / lines.len() as f64;
                    scored.broken =
                        vec![Broken { bound: Bound::Singular, amount: 0.0, weight: LOST * (1.0 + left), at }];
                    scored.weight = LOST * (1.0 + left);
                    scored.legs.clear();
                    return scored;
                }
            }
        }
        scored.broken = scored.legs.iter().flat_map(|l| l.broken.iter().copied()).collect();
        self.time(grid, &mut scored);
        scored.weight = scored.broken.iter().map(|b| b.weight).sum();
        scored
    }

    /// Determines the times of the legs and the cost.
    fn time(&self, grid: &Grid, scored: &mut Scored) {
        let task = self.task;
        let legs = &scored.legs;
        let mut least: Vec<(f64, Bound)> = legs.iter().map(|l| l.fastest).collect();
        let (weight, contact): (f64, Vec<usize>) =
            (task.weights.jerk, (0..legs.len()).filter(|&k| legs[k].line.phase.contact()).collect());
        let pick = |least: &[(f64, Bound)]| contact.iter().map(|&k| least[k].0).collect::<Vec<f64>>();
        let jerks: Vec<f64> = contact.iter().map(|&k| legs[k].jerk).collect();
        let mut times = vec![(0.0, false); legs.len()];
        // Torques are checked at a leg's shortest time; slower legs leave less time to the others
        // if the total is given.
        for _ in 0..6 {
            for k in 0..legs.len() {
                if !legs[k].line.phase.contact() {
                    let free = [(least[k].0, legs[k].jerk)];
                    times[k] = share_out(&[free[0].0], &[free[0].1], weight.max(1e-3), None)[0];
                }
            }
            for (&k, time) in contact.iter().zip(share_out(&pick(&least), &jerks, weight, task.duration)) {
                times[k] = time;
            }
            let mut changed = false;
            for k in 0..legs.len() {
                match legs[k].slower(task, grid, times[k].0) {
                    Ok((_, None)) => {}
                    Ok((longer, Some(joint))) => {
                        least[k] = (longer, Bound::Torque(joint));
                        changed = true;
                    }
                    Err(broken) => {
                        scored.broken.push(broken);
                        return;
                    }
                }
            }
            if !changed {
                break;
            }
        }
        scored.contact = contact.iter().map(|&k| times[k].0).sum();
        if let Some(duration) = task.duration
            && scored.contact > duration * (1.0 + 1e-9)
        {
            let slowest = contact.iter().copied().max_by(|&a, &b| least[a].0.total_cmp(&least[b].0));
            let at = slowest.map_or([0.0; 3], |k| legs[k].line.place(0.5));
            let amount = scored.contact - duration;
            scored.broken.push(Broken { bound: Bound::Duration, amount, weight: amount / duration, at });
        }
        scored.jerk = contact.iter().map(|&k| legs[k].jerk / times[k].0.powi(5)).sum();
        scored.times = (0..legs.len())
            .map(|k| {
                let (time, bound) = times[k];
                let free =
                    if task.duration.is_some() && legs[k].line.phase.contact() { Bound::Shared } else { Bound::Weight };
                (time, if bound { least[k].1 } else { free })
            })
            .collect();
        scored.cost = scored.contact + weight * scored.jerk + task.weights.area / task.area(&scored.strokes);
    }
}

fn reversed(all: &Postures) -> Postures {
    let mut lists = all.lists.clone();
    lists.reverse();
    Postures { farthest: lists.len() - 1 - all.farthest, lists, distance: all.distance }
}
