//! Shortest time of a leg, the cost of its jerk, and the limits that it violates.
//!
//! Way points are passed at rest, so that legs are coupled only at their ends. With a leg's time
//! `tau`, speeds scale with `1/tau`, accelerations with `1/tau^2`, and the integral of the squared
//! jerk is `J / tau^5`. The optimal `tau` is the larger of the time that the limits require and
//! `(5 w J)^(1/6)`, where the derivative of `tau + w J / tau^5` vanishes. `T_C` of equation (12)
//! therefore needs no search.

use nalgebra::DMatrix;

use super::joint_torques::push;
use crate::model::States;

use super::strokes::rest_to_rest;
use super::task::Task;
use super::track::Line;
use crate::apps::painting::clearance::Clearance;
use crate::numerics::chebyshev::Chebyshev;

/// A binding or violated limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Bound {
    /// No posture reaches this position of the roller.
    OutOfReach,
    /// The arm cannot hold the roller in this direction there.
    Direction,
    /// The branch of the inverse kinematics ends or is not smooth: a singularity.
    Singular,
    /// Travel of a joint (from 0).
    Position(usize),
    /// Speed of a joint.
    Velocity(usize),
    /// Acceleration of a joint.
    Acceleration(usize),
    /// Jerk of a joint.
    Jerk(usize),
    /// Torque of a joint.
    Torque(usize),
    /// A distance, by its index in [`Clearance`].
    Clearance(usize),
    /// The given duration.
    Duration,
    /// No limit: the weight of the jerk.
    Weight,
    /// No limit: the given duration, shared out for the least jerk.
    Shared,
}

/// A violated limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Broken {
    /// The limit.
    pub bound: Bound,
    /// Size of the violation: m, rad, N m or s, depending on the limit.
    pub amount: f64,
    /// Size of the violation on a common scale; positive.
    pub weight: f64,
    /// Position of the roller: wall coordinates and distance, m.
    pub at: [f64; 3],
}

/// Sampling grid of a leg and the matrices that evaluate it.
pub(super) struct Grid {
    pub chebyshev: Chebyshev,
    rows: [DMatrix<f64>; 4],
    shares: Vec<f64>,
    speeds: Vec<[f64; 4]>,
}

impl Grid {
    /// Creates a grid: `order + 1` postures define a leg, `samples` instants are checked.
    pub(super) fn new(order: usize, samples: usize) -> Self {
        let times: Vec<f64> = (0..samples).map(|k| k as f64 / (samples - 1) as f64).collect();
        let speeds: Vec<[f64; 4]> = times.iter().map(|&u| rest_to_rest(u)).collect();
        let shares: Vec<f64> = speeds.iter().map(|s| s[0].clamp(0.0, 1.0)).collect();
        let chebyshev = Chebyshev::new(order);
        Self { rows: chebyshev.rows(&shares), chebyshev, shares, speeds }
    }
}

/// A leg on one branch, in units of its own time.
#[derive(Debug, Clone)]
pub(super) struct Leg {
    pub line: Line,
    /// Postures at the Chebyshev points.
    pub q: DMatrix<f64>,
    /// Integral of the squared jerk `J`, rad^2.
    pub jerk: f64,
    /// Shortest time by speed, acceleration and jerk, s, and the binding limit.
    pub fastest: (f64, Bound),
    /// Limits violated at any leg time.
    pub broken: Vec<Broken>,
    states: States,
    /// Joint torques of the contact force, `n x len`, N m.
    load: Vec<f64>,
}

/// Shortest leg time, s.
const LEAST: f64 = 0.05;
/// Longest leg time, s; a leg that needs longer is infeasible.
const LONGEST: f64 = 1e4;
/// Largest truncation error of a polynomial on a smooth branch, rad or m.
const SMOOTH: f64 = 2e-3;

impl Leg {
    /// Builds a leg from the postures at the grid's Chebyshev points.
    pub(super) fn new(task: &Task<'_>, around: &Clearance, grid: &Grid, line: Line, q: DMatrix<f64>) -> Self {
        let (n, len) = (task.dof(), grid.shares.len());
        let by_share = [0, 1, 2, 3].map(|d| &grid.rows[d] * &q);
        let mut states = States::zeros(n, len);
        let mut jerk = 0.0;
        let mut fastest = (LEAST, Bound::Weight);
        let mut broken: Vec<Broken> = Vec::new();
        let mut breaks = |bound: Bound, amount: f64, weight: f64, sample: usize| {
            let at = line.place(grid.shares[sample]);
            match broken.iter_mut().find(|b| b.bound == bound) {
                Some(b) if b.weight >= weight => {}
                Some(b) => *b = Broken { bound, amount, weight, at },
                None => broken.push(Broken { bound, amount, weight, at }),
            }
        };
        for j in 0..n {
            let limits = &task.limits[j];
            let [low, high] = limits.position;
            for s in 0..len {
                let [_, s1, s2, s3] = grid.speeds[s];
                let [x, x1, x2, x3] = [0, 1, 2, 3].map(|d| by_share[d][(s, j)]);
                let (v, a) = (x1 * s1, x2 * s1 * s1 + x1 * s2);
                let b = x3 * s1 * s1 * s1 + 3.0 * x2 * s1 * s2 + x1 * s3;
                states.q[j * len + s] = x;
                states.dq[j * len + s] = v;
                states.ddq[j * len + s] = a;
                let outside = (low - x).max(x - high) + task.position_margin;
                if outside > 0.0 {
                    breaks(Bound::Position(j), outside, outside, s);
                }
                let end = if s == 0 || s + 1 == len { 0.5 } else { 1.0 };
                jerk += end * b * b / (len - 1) as f64;
                let times = [
                    (v.abs() / (task.share * limits.velocity), Bound::Velocity(j)),
                    ((a.abs() / (task.share * limits.acceleration)).sqrt(), Bound::Acceleration(j)),
                    (limits.jerk.map_or(0.0, |l| (b.abs() / (task.share * l)).cbrt()), Bound::Jerk(j)),
                ];
                for (time, bound) in times {
                    if time > fastest.0 {
                        fastest = (time, bound);
                    }
                }
            }
            let tail = grid.chebyshev.tail(|k| q[(k, j)]);
            if tail > SMOOTH {
                breaks(Bound::Singular, tail, 0.1 * tail.min(10.0), len / 2);
            }
        }
        let mut frames = vec![0.0; task.arm.frame_count() * 12 * len];
        task.arm.frames(&states, &mut frames);
        for s in 0..len {
            if let Some((gap, which)) = around.least(&frames, len, s)
                && gap < 0.0
            {
                breaks(Bound::Clearance(which), -gap, -gap / 0.1, s);
            }
        }
        let load = push(task, &states, &frames, |_| line.phase.contact());
        Self { line, q, jerk, fastest, broken, states, load }
    }

    /// Largest ratio of torque to limit for a leg time `tau`, s: ratio, joint, sample. Zero if link
    /// parameters are unknown.
    fn torque(&self, task: &Task<'_>, tau: f64) -> (f64, usize, usize) {
        let Some(standard) = &task.standard else { return (0.0, 0, 0) };
        let (n, len) = (task.dof(), self.states.len);
        let mut states = self.states.clone();
        states.dq.iter_mut().for_each(|v| *v /= tau);
        states.ddq.iter_mut().for_each(|a| *a /= tau * tau);
        let mut out = vec![0.0; n * len];
        task.arm.inverse_dynamics(&states, standard, &mut out);
        let mut worst = (0.0, 0, 0);
        for j in 0..n {
            let Some(limit) = task.limits[j].torque else { continue };
            let allowed = limit * (1.0 - task.torque_margin);
            for s in 0..len {
                let ratio = (out[j * len + s] + self.load[j * len + s]).abs() / allowed;
                if ratio > worst.0 {
                    worst = (ratio, j, s);
                }
            }
        }
        worst
    }

    /// Shortest time, at least `tau`, that the torque limits allow, and the joint that determines
    /// it.
    pub(super) fn slower(&self, task: &Task<'_>, grid: &Grid, tau: f64) -> Result<(f64, Option<usize>), Broken> {
        let (ratio, joint, _) = self.torque(task, tau);
        if ratio <= 1.0 {
            return Ok((tau, None));
        }
        let (mut low, mut high) = (tau, 1.3 * tau);
        loop {
            let (ratio, joint, sample) = self.torque(task, high);
            if ratio <= 1.0 {
                break;
            }
            if high > LONGEST {
                let limit = task.limits[joint].torque.unwrap_or(0.0) * (1.0 - task.torque_margin);
                let at = self.line.place(grid.shares[sample]);
                let bound = Bound::Torque(joint);
                return Err(Broken { bound, amount: (ratio - 1.0) * limit, weight: ratio - 1.0, at });
            }
            (low, high) = (high, 1.6 * high);
        }
        for _ in 0..30 {
            let middle = 0.5 * (low + high);
            if self.torque(task, middle).0 <= 1.0 { high = middle } else { low = middle }
        }
        Ok((high, Some(joint)))
    }
}

/// Times of the legs, each at least its own minimum. With `duration` they sum to it and minimise
/// the sum of `J / tau^5` (equal marginal gain: `tau` in proportion to `J^(1/6)`). Without it
/// `tau + w J / tau^5` is minimised for each leg. The flag is true if the leg takes its minimum
/// time.
pub(super) fn share_out(least: &[f64], jerk: &[f64], weight: f64, duration: Option<f64>) -> Vec<(f64, bool)> {
    let at = |scale: f64| -> Vec<(f64, bool)> {
        least
            .iter()
            .zip(jerk)
            .map(|(&least, &jerk)| {
                let free = scale * jerk.max(1e-300).powf(1.0 / 6.0);
                if free > least { (free, false) } else { (least, true) }
            })
            .collect()
    };
    let Some(duration) = duration else { return at((5.0 * weight).powf(1.0 / 6.0)) };
    let total = |scale: f64| at(scale).iter().map(|t| t.0).sum::<f64>();
    if total(0.0) >= duration {
        return at(0.0);
    }
    let (mut low, mut high) = (0.0, 1.0);
    while total(high) < duration && high < 1e30 {
        high *= 2.0;
    }
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if total(middle) < duration { low = middle } else { high = middle }
    }
    // The rounding remainder goes to a leg above its minimum.
    let mut times = at(high);
    let rest = duration - times.iter().map(|t| t.0).sum::<f64>();
    if let Some(longest) = times.iter_mut().filter(|t| !t.1).max_by(|a, b| a.0.total_cmp(&b.0)) {
        longest.0 += rest;
    }
    times
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_cost_against_a_grid() {
        let (least, jerk, weight) = ([0.5, 2.0, 0.1], [3000.0, 40.0, 700.0], 0.3);
        let cost = |t: &[f64]| -> f64 { (0..3).map(|i| t[i] + weight * jerk[i] / t[i].powi(5)).sum() };
        let free: Vec<f64> = share_out(&least, &jerk, weight, None).iter().map(|t| t.0).collect();
        let given: Vec<f64> = share_out(&least, &jerk, weight, Some(20.0)).iter().map(|t| t.0).collect();
        assert!((given.iter().sum::<f64>() - 20.0).abs() < 1e-12);
        for step in [-1e-3, 1e-3] {
            for i in 0..3 {
                let mut other = free.clone();
                other[i] = (other[i] + step).max(least[i]);
                assert!(cost(&other) >= cost(&free) - 1e-12);
                let mut other = given.clone();
                other[i] = (other[i] + step).max(least[i]);
                other[(i + 1) % 3] += given[i] - other[i];
                if other[(i + 1) % 3] >= least[(i + 1) % 3] {
                    assert!(cost(&other) >= cost(&given) - 1e-12);
                }
            }
        }
    }
}
