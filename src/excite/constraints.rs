//! Constraints at every sample besides the joints' bounds: torque, ground, spheres, boxes.

use crate::model::{Differentiable, Gradient, States};

use super::bodies::{Bodies, distance};
use super::limits::JointLimits;

/// A condition that must hold at every instant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Constraint {
    /// Torque limit of a joint (from 0).
    Torque(usize),
    /// Origin of a frame (row of the table from 0) above the ground.
    Ground(usize),
    /// Distance of a pair of spheres, by index into [`Bodies::pairs`].
    Pair(usize),
    /// Distance of a sphere and a box, by index into [`Bodies::blocked`].
    Box(usize),
}

/// A constraint at its tightest instant, or at its largest violation.
#[derive(Debug, Clone, PartialEq)]
pub struct Worst {
    /// Description of the constraint with names and figures.
    pub what: String,
    /// Time, s.
    pub time: f64,
    /// Excess over the limit, positive if violated: share of the limit for torques, m / 0.1 for
    /// distances.
    pub excess: f64,
}

/// Unit of distances, m, so that they and shares of a torque have the same magnitude.
const LENGTH: f64 = 0.1;

/// The constraints of a task.
pub(super) struct Constraints<'a> {
    pub(super) arm: &'a dyn Differentiable,
    pub(super) limits: &'a [JointLimits],
    pub(super) standard: Option<&'a [f64]>,
    pub(super) bodies: &'a Bodies,
    /// Share of the torque limits that is kept as a reserve.
    pub(super) torque_margin: f64,
    /// Required distance, m.
    pub(super) distance_margin: f64,
}

impl Constraints<'_> {
    /// All constraints in the order of the values.
    pub(super) fn list(&self) -> Vec<Constraint> {
        let torques = (0..self.limits.len())
            .filter(|&j| self.standard.is_some() && self.limits[j].torque.is_some())
            .map(Constraint::Torque);
        let ground = self.bodies.ground.iter().flat_map(|(_, frames)| frames.iter().map(|&f| Constraint::Ground(f)));
        let pairs = (0..self.bodies.pairs.len()).map(Constraint::Pair);
        torques.chain(ground).chain(pairs).chain((0..self.bodies.blocked.len()).map(Constraint::Box)).collect()
    }

    /// Value of each constraint at each sample, not positive where it holds:
    /// `[constraint * len + s]`.
    pub(super) fn values(&self, list: &[Constraint], states: &States) -> Vec<f64> {
        let len = states.len;
        let mut out = vec![0.0; list.len() * len];
        let n = self.limits.len();
        let mut torque = vec![0.0; n * len];
        if let Some(standard) = self.standard
            && list.iter().any(|c| matches!(c, Constraint::Torque(_)))
        {
            self.arm.inverse_dynamics(states, standard, &mut torque);
        }
        let mut frames = Vec::new();
        if list.iter().any(|c| !matches!(c, Constraint::Torque(_))) {
            frames = vec![0.0; self.arm.frame_count() * 12 * len];
            self.arm.frames(states, &mut frames);
        }
        for (constraint, row) in list.iter().zip(out.chunks_mut(len.max(1))) {
            for (s, value) in row.iter_mut().enumerate() {
                *value = match *constraint {
                    Constraint::Torque(j) => {
                        torque[j * len + s].abs() / self.limits[j].torque.unwrap_or(f64::INFINITY) - 1.0
                            + self.torque_margin
                    }
                    Constraint::Ground(f) => {
                        let ground = self.bodies.ground.as_ref().map_or(0.0, |g| g.0);
                        (ground + self.distance_margin - frames[((f * 3 + 2) * 4 + 3) * len + s]) / LENGTH
                    }
                    Constraint::Pair(p) => {
                        let (a, b) = self.bodies.pairs[p];
                        let (x, y) = (self.center(a, &frames, len, s), self.center(b, &frames, len, s));
                        let reach = self.bodies.balls[a].radius + self.bodies.balls[b].radius;
                        (reach + self.distance_margin - norm(&std::array::from_fn(|i| x[i] - y[i]))) / LENGTH
                    }
                    Constraint::Box(p) => {
                        let (ball, block) = self.bodies.blocked[p];
                        let (d, _) = distance(self.center(ball, &frames, len, s), &self.bodies.blocks[block]);
                        (self.bodies.balls[ball].radius + self.distance_margin - d) / LENGTH
                    }
                };
            }
        }
        out
    }

    /// Gradients of constraints, one per sample of `states` (already gathered), each multiplied by
    /// its weight.
    pub(super) fn gradients(&self, which: &[Constraint], weights: &[f64], states: &States) -> Gradient {
        let (len, n) = (states.len, self.limits.len());
        let mut to = Gradient { q: vec![0.0; n * len], dq: vec![0.0; n * len], ddq: vec![0.0; n * len] };
        if let Some(standard) = self.standard
            && which.iter().any(|c| matches!(c, Constraint::Torque(_)))
        {
            let mut torque = vec![0.0; n * len];
            self.arm.inverse_dynamics(states, standard, &mut torque);
            let mut seeds = vec![0.0; n * len];
            for (s, constraint) in which.iter().enumerate() {
                if let Constraint::Torque(j) = *constraint {
                    let limit = self.limits[j].torque.unwrap_or(f64::INFINITY);
                    seeds[j * len + s] = weights[s] * torque[j * len + s].signum() / limit;
                }
            }
            self.arm.inverse_dynamics_vjp(states, standard, &seeds, &mut to);
        }
        if which.iter().any(|c| !matches!(c, Constraint::Torque(_))) {
            let size = self.arm.frame_count() * 12 * len;
            let (mut frames, mut seeds) = (vec![0.0; size], vec![0.0; size]);
            self.arm.frames(states, &mut frames);
            for (s, constraint) in which.iter().enumerate() {
                let weight = weights[s] / LENGTH;
                match *constraint {
                    Constraint::Torque(_) => {}
                    Constraint::Ground(f) => seeds[((f * 3 + 2) * 4 + 3) * len + s] -= weight,
                    Constraint::Pair(p) => {
                        let (a, b) = self.bodies.pairs[p];
                        let (x, y) = (self.center(a, &frames, len, s), self.center(b, &frames, len, s));
                        let apart: [f64; 3] = std::array::from_fn(|i| x[i] - y[i]);
                        let d = norm(&apart).max(1e-9);
                        self.push(a, apart.map(|x| -weight * x / d), &mut seeds, len, s);
                        self.push(b, apart.map(|x| weight * x / d), &mut seeds, len, s);
                    }
                    Constraint::Box(p) => {
                        let (ball, block) = self.bodies.blocked[p];
                        let (_, by) = distance(self.center(ball, &frames, len, s), &self.bodies.blocks[block]);
                        self.push(ball, by.map(|x| -weight * x), &mut seeds, len, s);
                    }
                }
            }
            self.arm.frames_vjp(states, &seeds, &mut to);
        }
        to
    }

    /// Centre of a sphere in the world frame, m.
    fn center(&self, ball: usize, frames: &[f64], len: usize, s: usize) -> [f64; 3] {
        self.bodies.balls[ball].placed(frames, len, s)
    }

    /// Propagates a derivative with respect to a sphere's centre to its frame.
    fn push(&self, ball: usize, by: [f64; 3], seeds: &mut [f64], len: usize, s: usize) {
        let ball = &self.bodies.balls[ball];
        let Some(f) = ball.frame else { return };
        for i in 0..3 {
            for k in 0..4 {
                let lever = if k < 3 { ball.center[k] } else { 1.0 };
                seeds[((f * 3 + i) * 4 + k) * len + s] += by[i] * lever;
            }
        }
    }

    /// Describes a constraint with figures.
    pub(super) fn describe(&self, constraint: Constraint, value: f64) -> String {
        let ball = |k: usize| match self.bodies.balls[k].frame {
            Some(f) => format!("sphere {} (link {})", k + 1, f + 1),
            None => format!("sphere {} (base)", k + 1),
        };
        match constraint {
            Constraint::Torque(j) => {
                let limit = self.limits[j].torque.unwrap_or(f64::INFINITY);
                format!(
                    "torque of {}: {:.3} of {limit}",
                    self.limits[j].name,
                    (value + 1.0 - self.torque_margin) * limit
                )
            }
            Constraint::Ground(f) => {
                let ground = self.bodies.ground.as_ref().map_or(0.0, |g| g.0);
                let z = ground + self.distance_margin - value * LENGTH;
                format!("frame {} at z = {z:.4} m, ground at {ground} m", f + 1)
            }
            Constraint::Pair(p) => {
                let (a, b) = self.bodies.pairs[p];
                format!("{} and {}: {}", ball(a), ball(b), apart(self.distance_margin - value * LENGTH))
            }
            Constraint::Box(p) => {
                let (a, block) = self.bodies.blocked[p];
                let name = &self.bodies.blocks[block].name;
                format!("{} and box {name}: {}", ball(a), apart(self.distance_margin - value * LENGTH))
            }
        }
    }
}

/// Describes a distance, m.
fn apart(distance: f64) -> String {
    if distance < 0.0 { format!("{:.4} m into each other", -distance) } else { format!("{distance:.4} m apart") }
}

fn norm(x: &[f64; 3]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}
