//! Target schedule of a run: rest, approach to the wall, pressing, calibration stroke, painting.

use super::RunTask;
use crate::apps::painting::strokes::rest_to_rest;
use crate::control::iterative_learning::Learned;
use crate::control::law::Target;
use crate::simulate::Trajectory;

/// Time of rest before the wall, s; `COME` is that of the approach, s.
const REST: f64 = 0.3;
const COME: f64 = 1.5;

/// The plan, read forwards in time: positions, speeds, accelerations at a time since its start.
pub(super) struct PlannedMotion<'a, const N: usize> {
    motion: &'a Trajectory,
    hint: usize,
    points: Vec<[f64; 3]>,
}

impl<'a, const N: usize> PlannedMotion<'a, N> {
    pub(super) fn new(motion: &'a Trajectory) -> Self {
        Self { motion, hint: 0, points: vec![[0.0; 3]; N] }
    }

    /// Duration, s.
    pub(super) fn seconds(&self) -> f64 {
        self.motion.span().end - self.motion.span().start
    }

    pub(super) fn at(&mut self, t: f64) -> [[f64; N]; 3] {
        self.motion.at(self.motion.span().start + t, &mut self.hint, &mut self.points);
        self.rows()
    }

    fn rows(&self) -> [[f64; N]; 3] {
        std::array::from_fn(|d| std::array::from_fn(|j| self.points[j][d]))
    }
}

/// Targets of the controller at each instant.
pub(super) struct TargetSchedule<'a, const N: usize> {
    /// The plan to paint.
    pub plan: PlannedMotion<'a, N>,
    /// Posture before the wall; `first` is the plan's first posture.
    start: [f64; N],
    first: [f64; N],
    /// Direction of pressing; `force` is the desired force, N.
    press: [f64; 3],
    force: f64,
    /// Calibration stroke, in which drag is measured.
    wiped: Option<Trajectory>,
    hint: usize,
    /// Time at which painting begins, s.
    begin: f64,
    learned: Option<&'a Learned>,
}

impl<'a, const N: usize> TargetSchedule<'a, N> {
    pub(super) fn new(
        task: &RunTask<'a>,
        start: [f64; N],
        mut plan: PlannedMotion<'a, N>,
        wiped: Option<Trajectory>,
    ) -> Self {
        let [first, ..] = plan.at(0.0);
        Self {
            plan,
            start,
            first,
            press: task.wall.normal.map(|n| -n),
            force: task.force,
            wiped,
            hint: 0,
            begin: REST + COME + task.settle.max(0.0),
            learned: task.learned,
        }
    }

    /// Time at which painting begins, s.
    pub(super) fn painting_begins(&self) -> f64 {
        self.begin
    }

    /// Target at time `t`, s, since the run began.
    pub(super) fn at(&mut self, t: f64) -> Target<N> {
        if t < REST + COME {
            return self.approach(t);
        }
        let pressed = t - REST - COME;
        if let Some(wiped) = self.wiped.as_ref().filter(|w| (w.span().start..w.span().end).contains(&pressed)) {
            wiped.at(pressed, &mut self.hint, &mut self.plan.points);
            let [q, dq, ddq] = self.plan.rows();
            return Target { q, dq, ddq, normal: self.press, force: Some(self.force), ahead: 0.0 };
        }
        let [q, dq, ddq] = self.plan.at((t - self.begin).max(0.0));
        let moves = f64::from(u8::from(t >= self.begin));
        Target {
            q,
            dq: dq.map(|v| moves * v),
            ddq: ddq.map(|a| moves * a),
            normal: self.press,
            force: Some(self.force),
            ahead: self.learned.map_or(0.0, |l| l.at(t - self.begin)),
        }
    }

    /// Rest, then a fifth-degree polynomial to the plan's first posture.
    fn approach(&self, t: f64) -> Target<N> {
        let [s, ds, dds, _] = rest_to_rest(((t - REST) / COME).clamp(0.0, 1.0));
        let along = [s, ds / COME, dds / (COME * COME)];
        let way = |s: f64| -> [f64; N] { std::array::from_fn(|j| s * (self.first[j] - self.start[j])) };
        let [q, dq, ddq] = along.map(way);
        let q = std::array::from_fn(|j| self.start[j] + q[j]);
        Target { q, dq, ddq, normal: self.press, force: None, ahead: 0.0 }
    }
}
