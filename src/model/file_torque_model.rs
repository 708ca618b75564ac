//! [`TorqueModel`] of a robot file with its effects, by interpreted tapes: the same results as its
//! generated code.

use dh_codegen::arm::param::Parameter;
use dh_codegen::arm::{Function, param};
use dh_codegen::drive::{self, Deflection, Memory, Spring};
use dh_codegen::interpret::{Scratch, State};
use dh_codegen::robot::{Laws, Robot};
use dh_codegen::runtime::Scalar;

use crate::model::interpreted::Interpreted;
use crate::model::walls::Walls;
use crate::model::{Arm, States, TorqueModel};
use crate::numerics::hermite::cubic;

/// A robot without inertial parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error(
    "the inertial parameters of every link are needed; add a `links:` list with one entry per joint, or identify them (`denavit identify`)"
)]
pub struct NoLinks;

/// A robot with all effects of its file.
pub struct FileTorqueModel {
    arm: Interpreted,
    standard: Vec<f64>,
    laws: Vec<Laws>,
    /// `standard` with zero drive parameters.
    bodies: Vec<f64>,
    walls: Option<Walls>,
}

impl FileTorqueModel {
    /// The model of this robot.
    pub fn new(robot: &Robot) -> Result<Self, NoLinks> {
        let standard = param::standard_values(&robot.effective()).ok_or(NoLinks)?;
        let laws = robot.laws();
        Ok(Self {
            arm: Interpreted::with_effects(robot, &[along(&laws), Function::RigidDynamics]),
            bodies: param::standard(&robot.effective())
                .iter()
                .zip(&standard)
                .map(|(p, &v)| if matches!(p, Parameter::Link(..)) { v } else { 0.0 })
                .collect(),
            standard,
            laws,
            walls: None,
        })
    }

    /// The same with the walls of the file, whose forces a model of the robot alone lacks.
    #[must_use]
    pub fn among_walls(self, robot: &Robot) -> Self {
        Self { walls: Walls::of(robot), ..self }
    }

    /// Torques of the bodies, rotors and plain friction alone.
    pub fn rigid(&self, states: &States, out: &mut [f64]) {
        self.arm.run(Function::RigidDynamics, states, &[], &self.standard, out);
    }

    /// The effects of each drive.
    pub fn laws(&self) -> &[Laws] {
        &self.laws
    }

    /// Torques along recorded motion without any delay. The clock of the drives started at `begun`
    /// and is `late` s late.
    fn remembered(&self, [begun, late]: [f64; 2], time: &[f64], states: &States, temperature: &[f64], out: &mut [f64]) {
        let (n, len, p) = (self.dof(), states.len, self.standard.len());
        let memory: Vec<Memory> = self.laws.iter().map(Laws::memory).collect();
        // Parameters, then bristles, then warmth, then the clock: see `Function::DriveTorques`.
        let mut parameters = self.standard.clone();
        parameters.resize(p + 3 * n + 1, 0.0);
        let function = along(&self.laws);
        let (mut q, mut dq, mut ddq, mut tau) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; n]);
        let (mut scratch, mut start) = (Scratch::default(), 0);
        let springs: Vec<Spring> = self.laws.iter().map(Laws::gear).collect();
        let swings = springs.iter().any(|s| s.stiffness > 0.0);
        let (mut deflection, mut still): (Vec<Deflection<f64>>, Vec<Deflection<f64>>) =
            (vec![[0.0; 3]; n], vec![[0.0; 3]; n]);
        let (mut work, mut kernel) = (vec![0.0; n * (n + 2)], Scratch::default());
        for s in 0..len {
            let fresh = s == 0 || time[s] <= time[s - 1];
            if fresh {
                start = s;
            }
            for k in 0..n {
                let at = k * len + s;
                let z = &mut parameters[p + k];
                *z = if fresh { states.dq[at].sign() } else { memory[k].bent(*z, states.q[at] - q[k]) };
                let begun = if start == 0 { begun } else { time[start] };
                let since = (time[s] - begun - late).max(0.0);
                let degrees = temperature.get(at).copied().unwrap_or(memory[k].reference);
                parameters[p + n + k] = memory[k].warmth(since, degrees);
                (parameters[p + 2 * n], parameters[p + 2 * n + 1 + k]) = (since, degrees);
                (q[k], dq[k], ddq[k]) = (states.q[at], states.dq[at], states.ddq[at]);
            }
            let state = State { q: &q, dq: &dq, ddq: &ddq, tau: &[], parameters: &parameters };
            self.arm.run_one(function, &state, &mut scratch, &mut tau);
            if swings && !fresh {
                let mut bodies = |deflection: &[Deflection<f64>], out: &mut [f64]| {
                    let less = |x: &[f64], which: usize| -> Vec<f64> {
                        x.iter().zip(deflection).map(|(x, b)| x - b[which]).collect()
                    };
                    let (q, dq, ddq) = (less(&q, 0), less(&dq, 1), less(&ddq, 2));
                    let state = State { q: &q, dq: &dq, ddq: &ddq, tau: &[], parameters: &self.bodies };
                    self.arm.run_one(Function::RigidDynamics, &state, &mut kernel, out);
                };
                // At the first step the links are at their quasi-static deflection; from the second
                // on they oscillate.
                let dt = time[s] - time[s - 1];
                match s - start {
                    1 => drive::quasi_static(&springs, &mut deflection, &mut work[..n], &mut bodies),
                    2 => drive::start_swing(&springs, dt, &mut deflection, &mut work[..2 * n], &mut bodies),
                    _ => drive::swing(&springs, dt, &mut deflection, &mut work, &mut bodies),
                }
                drive::elastic_torque(&springs, &deflection, &mut still, &mut work[..2 * n], &mut tau, &mut bodies);
            }
            (0..n).for_each(|k| out[k * len + s] = tau[k]);
        }
        if let Some(walls) = &self.walls {
            walls.add(states, out);
        }
    }
}

/// Function that computes the torques along a motion.
fn along(laws: &[Laws]) -> Function {
    match laws.iter().any(Laws::reads_clock) {
        true => Function::ClockedDriveTorques,
        false => Function::DriveTorques,
    }
}

impl TorqueModel for FileTorqueModel {
    fn dof(&self) -> usize {
        self.arm.dof()
    }

    fn torques(&self, states: &States, out: &mut [f64]) {
        self.arm.run(Function::InverseDynamics, states, &[], &self.standard, out);
        if let Some(walls) = &self.walls {
            walls.add(states, out);
        }
    }

    fn torques_along(&self, time: &[f64], states: &States, temperature: &[f64], out: &mut [f64]) {
        self.torques_since(time.first().copied().unwrap_or(0.0), time, states, temperature, out);
    }

    fn torques_since(&self, begun: f64, time: &[f64], states: &States, temperature: &[f64], out: &mut [f64]) {
        let (n, len) = (self.dof(), states.len);
        let delays = self.delays();
        let mut distinct: Vec<f64> = delays.clone();
        distinct.sort_by(f64::total_cmp);
        distinct.dedup();
        let mut all = vec![0.0; n * len];
        for late in distinct {
            if late == 0.0 {
                self.remembered([begun, late], time, states, temperature, &mut all);
            } else {
                self.remembered([begun, late], time, &earlier(time, states, late, n), temperature, &mut all);
            }
            for (k, _) in delays.iter().enumerate().filter(|(_, d)| **d == late) {
                out[k * len..(k + 1) * len].copy_from_slice(&all[k * len..(k + 1) * len]);
            }
        }
    }

    fn delays(&self) -> Vec<f64> {
        self.laws.iter().map(|l| l.delay).collect()
    }

    fn breakaways(&self) -> Vec<Option<f64>> {
        self.laws.iter().map(|l| l.stribeck.as_ref().and_then(|s| s.breakaway)).collect()
    }

    fn sensors(&self) -> Vec<[f64; 2]> {
        self.laws.iter().map(|l| [l.gain, l.offset]).collect()
    }
}

/// The motion `late` seconds before each sample: Hermite cubics of positions and velocities, and of
/// velocities and accelerations; linear interpolation of accelerations. Before the first sample of
/// a recording (or after its last, where torques are early) that sample's motion is used.
fn earlier(time: &[f64], states: &States, late: f64, n: usize) -> States {
    let len = states.len;
    let mut out = states.clone();
    let mut start = 0;
    while start < len {
        let end = (start + 1..len).find(|&s| time[s] <= time[s - 1]).unwrap_or(len);
        let mut i = start;
        for s in start..end {
            let t = (time[s] - late).clamp(time[start], time[end - 1]);
            while i > start && time[i] > t {
                i -= 1;
            }
            while i + 2 < end && time[i + 1] < t {
                i += 1;
            }
            let next = (i + 1).min(end - 1);
            let h = time[next] - time[i];
            let f = if h > 0.0 { (t - time[i]) / h } else { 0.0 };
            for k in 0..n {
                let (a, b) = (k * len + i, k * len + next);
                let between = |x: &[f64], v: &[f64]| cubic([x[a], x[b]], [v[a] * h, v[b] * h], f);
                let at = k * len + s;
                out.q[at] = between(&states.q, &states.dq);
                // A joint that rests at both samples rests between them, whatever the noise of its
                // acceleration: a velocity other than zero would have dry friction.
                let rests = states.dq[a] == 0.0 && states.dq[b] == 0.0;
                out.dq[at] = if rests { 0.0 } else { between(&states.dq, &states.ddq) };
                out.ddq[at] = states.ddq[a] + f * (states.ddq[b] - states.ddq[a]);
            }
        }
        start = end;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The motion of a delayed torque: between samples at rest a joint rests, though its acceleration
    /// is not exactly zero; a moving joint is where it was.
    #[test]
    fn a_joint_at_rest_was_at_rest_before() {
        let time: Vec<f64> = (0..40).map(|k| 0.005 * f64::from(k)).collect();
        let noise = |t: &f64| 0.03 * (7e3 * t).sin();
        // Joint 1 stands; joint 2 moves at 2 rad/s.
        let states = States {
            len: 40,
            q: [vec![0.1; 40], time.iter().map(|t| 2.0 * t).collect()].concat(),
            dq: [vec![0.0; 40], vec![2.0; 40]].concat(),
            ddq: [time.iter().map(noise).collect(), vec![0.0; 40]].concat(),
        };
        let before = earlier(&time, &states, 0.0123, 2);
        assert!(before.dq[..40].iter().all(|v| *v == 0.0));
        for k in 3..40 {
            assert!((before.q[40 + k] - 2.0 * (time[k] - 0.0123)).abs() < 1e-12);
            assert!((before.dq[40 + k] - 2.0).abs() < 1e-12);
        }
    }
}
