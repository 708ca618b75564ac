//! Robot as an ordinary differential equation: links, the motors of soft joints, and bristles.
//!
//! Coordinates: the `n` links, then one motor for each soft joint; a stiff joint's motor is its
//! link. State: coordinates, their velocities, bristles.

use super::bristle::{Bristle, Part};
use super::contact::{Contacts, External, in_tool};
use super::control::{Control, Mode, Table};
use super::drive::{Drive, signs_in_laws};
use super::effects::{GearCoupling, Moment};
use super::trajectory::{Point, Trajectory};
use crate::model::{Dynamics, ToolState};
use crate::numerics::cholesky;
use crate::numerics::integrators::{Breakdown, Linear, LinearBristle, System};

/// Relative tolerance of the iteration between load-dependent friction and transmitted torque.
const LOAD_AGREES: f64 = 1e-10;

/// State-space model of the robot under control.
pub(super) struct Plant<'a> {
    bodies: &'a mut dyn Dynamics,
    pub drives: &'a [Drive],
    pub couplings: &'a [GearCoupling],
    pub contacts: &'a Contacts,
    pub external: &'a [&'a dyn External],
    trajectory: &'a Trajectory,
    control: &'a Control,
    gains: [Vec<f64>; 2],
    feedforward: Table,
    start: f64,
    n: usize,
    /// Coordinate index of each joint's motor.
    pub motor: Vec<usize>,
    coordinates: usize,
    pub bristles: Vec<Bristle>,
    hint: usize,
    /// Torques held by a sampled controller in place of the loop, N m; empty without one.
    pub held: Vec<f64>,
    /// Result at the last evaluated state.
    pub now: Now,
    work: Work,
}

/// Quantities at one state.
#[derive(Debug, Clone, Default)]
pub(super) struct Now {
    /// Accelerations of the coordinates.
    pub acceleration: Vec<f64>,
    /// Torques of the drives, N m.
    pub motor_torque: Vec<f64>,
    /// Torque that each gear transmits to its link, N m.
    pub link_torque: Vec<f64>,
    /// Desired motion of each joint.
    pub desired: Vec<Point>,
    /// External force (N) and moment (N m) on the tool, tool axes.
    pub wrench: [f64; 6],
}

#[derive(Debug, Clone, Default)]
struct Work {
    /// Mass matrix of the bodies, `n x n`.
    bodies: Vec<f64>,
    bias: Vec<f64>,
    mass: Vec<f64>,
    factor: Vec<f64>,
    force: Vec<f64>,
    right: Vec<f64>,
    tool: ToolState,
    /// Torques of the external wrench on the joints, N m.
    pushed: Vec<f64>,
    /// External stiffness and damping at the joints, `n x n`.
    push_stiffness: Vec<f64>,
    push_damping: Vec<f64>,
    /// Bristle substitutes for the sign and for the hysteresis, per joint.
    sign: Vec<f64>,
    hysteresis: Vec<f64>,
    coupled: Vec<f64>,
    /// Inputs of closed-form laws: motion of the motors, temperatures, time.
    moment: Moment,
    /// Torques of closed-form laws, N m.
    laws: Vec<f64>,
}

/// Components of a plant.
pub(super) struct Parts<'a> {
    pub bodies: &'a mut dyn Dynamics,
    pub drives: &'a [Drive],
    pub couplings: &'a [GearCoupling],
    pub contacts: &'a Contacts,
    pub external: &'a [&'a dyn External],
    pub trajectory: &'a Trajectory,
    pub control: &'a Control,
    /// Gains `[kp, kd]`.
    pub gains: [Vec<f64>; 2],
    pub feedforward: Table,
}

/// Bristles that replace the signs of velocities.
fn bristles(drives: &[Drive], couplings: &[GearCoupling], motor: &[usize]) -> Vec<Bristle> {
    let mut bristles = Vec::new();
    let in_laws = signs_in_laws(drives);
    for (joint, drive) in drives.iter().enumerate() {
        let along = [(motor[joint], 1.0), (motor[joint], 0.0)];
        if drive.has_sign() || in_laws[joint] {
            bristles.push(Bristle { part: Part::Sign, joint, along, travel: Bristle::SIGN, fade: 2e-3 });
        }
        if let Some(h) = drive.hysteresis {
            let fade = 10.0 * h.travel;
            bristles.push(Bristle { part: Part::Hysteresis, joint, along, travel: h.travel, fade });
        }
    }
    for (k, c) in couplings.iter().enumerate().filter(|(_, c)| c.coulomb != 0.0) {
        let along = [(motor[c.motor], 1.0), (motor[c.other], c.ratio)];
        bristles.push(Bristle { part: Part::Coupling(k), joint: c.motor, along, travel: Bristle::SIGN, fade: 2e-3 });
    }
    bristles
}

impl<'a> Plant<'a> {
    pub fn new(parts: Parts<'a>) -> Self {
        let Parts { bodies, drives, couplings, contacts, external, trajectory, control, gains, feedforward } = parts;
        let n = drives.len();
        let mut coordinates = n;
        let motor: Vec<usize> = drives
            .iter()
            .enumerate()
            .map(|(j, drive)| {
                if drive.is_soft() {
                    coordinates += 1;
                    coordinates - 1
                } else {
                    j
                }
            })
            .collect();
        let bristles = bristles(drives, couplings, &motor);
        let now = Now {
            acceleration: vec![0.0; coordinates],
            motor_torque: vec![0.0; n],
            link_torque: vec![0.0; n],
            desired: vec![[0.0; 3]; n],
            wrench: [0.0; 6],
        };
        let work = Work {
            bodies: vec![0.0; n * n],
            bias: vec![0.0; n],
            mass: vec![0.0; coordinates * coordinates],
            pushed: vec![0.0; n],
            push_stiffness: vec![0.0; n * n],
            push_damping: vec![0.0; n * n],
            sign: vec![0.0; n],
            hysteresis: vec![0.0; n],
            coupled: vec![0.0; couplings.len()],
            moment: Moment::of(n),
            laws: vec![0.0; n],
            ..Work::default()
        };
        let start = trajectory.span().start;
        Self {
            bodies,
            drives,
            couplings,
            contacts,
            external,
            trajectory,
            control,
            gains,
            feedforward,
            start,
            n,
            motor,
            coordinates,
            bristles,
            hint: 0,
            held: Vec::new(),
            now,
            work,
        }
    }

    /// Whether an explicit method would need very short steps. Gains sized for a drive are high for
    /// the light link behind it, so position loops count as stiff.
    pub fn is_stiff(&self) -> bool {
        matches!(self.control.mode, Mode::Position | Mode::Pd)
            || !self.bristles.is_empty()
            || self.coordinates > self.n
            || !self.external.is_empty()
    }

    /// Initial state: on the motion, at its start.
    pub fn initial(&mut self) -> Vec<f64> {
        let (n, total) = (self.n, self.coordinates);
        let mut points = vec![[0.0; 3]; n];
        self.trajectory.at(self.start, &mut self.hint, &mut points);
        let moving = self.control.mode != Mode::Free;
        let mut y = vec![0.0; 2 * total + self.bristles.len()];
        for j in 0..n {
            for k in [j, self.motor[j]] {
                y[k] = points[j][0] + self.drives[j].encoder_offset;
                y[total + k] = if moving { points[j][1] } else { 0.0 };
            }
        }
        // The spring of a soft joint carries its link from the first instant.
        self.bodies.bias(&y[..n], &y[total..total + n], &mut self.work.bias);
        self.bodies.mass_matrix(&y[..n], &mut self.work.bodies);
        for j in (0..n).filter(|&j| self.drives[j].is_soft()) {
            let inertial: f64 = (0..n).map(|k| self.work.bodies[j * n + k] * points[k][2]).sum();
            let load = self.work.bias[j] + if moving { inertial } else { 0.0 };
            let slack = self.drives[j].backlash.map_or(0.0, |b| 0.5 * b.width.copysign(load));
            y[j] -= load / self.drives[j].transmission().stiffness + slack;
        }
        for (b, bristle) in self.bristles.iter().enumerate() {
            y[2 * total + b] = super::bristle::sign(bristle.velocity(&y[total..2 * total]));
        }
        y
    }

    /// Evaluates a state into [`Plant::now`].
    pub fn look(&mut self, t: f64, y: &[f64]) -> Result<(), Breakdown> {
        self.see(t, y, false)
    }

    /// Evaluates a state; `slopes`: also the stiffness and damping of external contacts.
    fn see(&mut self, t: f64, y: &[f64], slopes: bool) -> Result<(), Breakdown> {
        let (n, total) = (self.n, self.coordinates);
        let (x, v, z) = (&y[..total], &y[total..2 * total], &y[2 * total..]);
        let work = &mut self.work;
        self.bodies.mass_matrix(&x[..n], &mut work.bodies);
        self.bodies.bias(&x[..n], &v[..n], &mut work.bias);
        self.push(t, x, v, slopes);
        self.command(t, x, v);
        let since = t - self.start;
        self.signs_and_laws(since, x, v, z);
        let (work, now) = (&mut self.work, &mut self.now);

        work.mass.fill(0.0);
        for i in 0..n {
            work.mass[i * total..i * total + n].copy_from_slice(&work.bodies[i * n..(i + 1) * n]);
        }
        work.force.clear();
        work.force.resize(total, 0.0);
        for (j, drive) in self.drives.iter().enumerate() {
            let m = self.motor[j];
            work.mass[m * total + m] += drive.rotor;
            let friction = drive.warmth(since) * drive.friction(x[m], v[m], work.sign[j], work.hysteresis[j]);
            work.force[m] += now.motor_torque[j] - friction - drive.plain.offset - drive.ripple(x[m]) - work.laws[j];
            let spring = drive.spring.map_or(0.0, |s| s.torque(x[j]));
            work.force[j] += work.pushed[j] - work.bias[j] - spring;
            if m != j {
                let [torque, ..] = drive.transmitted(x[m] - x[j], v[m] - v[j]);
                now.link_torque[j] = torque;
                work.force[j] += torque;
                work.force[m] -= torque;
            }
        }
        for (c, &s) in self.couplings.iter().zip(&work.coupled) {
            let (m, k) = (self.motor[c.motor], self.motor[c.other]);
            work.mass[m * total + k] += c.ratio * c.rotor;
            work.mass[k * total + m] += c.ratio * c.rotor;
            let [on_k, on_m] = c.torques([v[m], v[k]], [0.0; 2]);
            work.force[k] -= on_k + c.ratio * c.coulomb * s;
            work.force[m] -= on_m + c.coulomb * s;
        }
        work.factor.clone_from(&work.mass);
        cholesky::factor(total, &mut work.factor).map_err(|joint| Breakdown::Mass { joint: joint + 1, time: t })?;
        // Load-dependent friction depends on the transmitted torque, hence on the acceleration:
        // fixed-point iteration, a contraction since FL < 1.
        let loaded = self.drives.iter().any(|d| d.load.is_some());
        for _ in 0..60 {
            work.right.clone_from(&work.force);
            if loaded {
                for (j, drive) in self.drives.iter().enumerate() {
                    if let Some(load) = drive.load {
                        let level = load.level(now.link_torque[j], v[self.motor[j]]) * drive.warmth(since);
                        work.right[self.motor[j]] -= level * work.sign[j];
                    }
                }
            }
            cholesky::solve(total, &work.factor, &mut work.right);
            now.acceleration.clone_from(&work.right);
            let mut change: f64 = 0.0;
            for (j, drive) in self.drives.iter().enumerate().filter(|(j, _)| self.motor[*j] == *j) {
                let inertial: f64 = (0..n).map(|k| work.bodies[j * n + k] * now.acceleration[k]).sum();
                let spring = drive.spring.map_or(0.0, |s| s.torque(x[j]));
                let torque = inertial + work.bias[j] - work.pushed[j] + spring;
                change = change.max((torque - now.link_torque[j]).abs() / (1.0 + torque.abs()));
                now.link_torque[j] = torque;
            }
            if !loaded || change < LOAD_AGREES {
                break;
            }
        }
        Ok(())
    }

    /// Evaluates the bristles, and the torques of closed-form laws.
    fn signs_and_laws(&mut self, since: f64, x: &[f64], v: &[f64], z: &[f64]) {
        let work = &mut self.work;
        work.sign.fill(0.0);
        work.hysteresis.fill(0.0);
        for (bristle, &z) in self.bristles.iter().zip(z) {
            let s = bristle.sign(bristle.velocity(v), z);
            match bristle.part {
                Part::Sign => work.sign[bristle.joint] = s,
                Part::Hysteresis => work.hysteresis[bristle.joint] = s,
                Part::Coupling(k) => work.coupled[k] = s,
            }
        }
        if self.drives.iter().any(|drive| drive.law.is_some()) {
            work.moment.set(since, self.drives, |j| (x[self.motor[j]], v[self.motor[j]], work.sign[j]));
            for (torque, drive) in work.laws.iter_mut().zip(self.drives) {
                *torque = drive.law.as_ref().map_or(0.0, |law| law.torque(&work.moment));
            }
        }
    }

    /// Torques of the external wrenches on the joints; `slopes`: also their joint stiffness and
    /// damping.
    fn push(&mut self, t: f64, x: &[f64], v: &[f64], slopes: bool) {
        let (n, work) = (self.n, &mut self.work);
        work.pushed.fill(0.0);
        if slopes {
            work.push_stiffness.fill(0.0);
            work.push_damping.fill(0.0);
        }
        self.now.wrench = [0.0; 6];
        let acting = self.contacts.act(t);
        if !acting && self.external.is_empty() {
            return;
        }
        self.bodies.tool(&x[..n], &mut work.tool);
        let ToolState { pose, jacobian } = &work.tool;
        let twist: [f64; 6] = std::array::from_fn(|i| (0..n).map(|k| jacobian[i * n + k] * v[k]).sum());
        let total = self.contacts.total(self.external, t, pose, &twist);
        for (matrix, out) in [(&total.stiffness, &mut work.push_stiffness), (&total.damping, &mut work.push_damping)] {
            if !slopes || matrix.iter().flatten().all(|&entry| entry == 0.0) {
                continue;
            }
            for a in 0..n {
                for b in 0..n {
                    let pairs = (0..3).flat_map(|i| (0..3).map(move |k| (i, k)));
                    out[a * n + b] = pairs.map(|(i, k)| jacobian[i * n + a] * matrix[i][k] * jacobian[k * n + b]).sum();
                }
            }
        }
        for k in 0..n {
            work.pushed[k] = (0..6).map(|i| jacobian[i * n + k] * total.wrench[i]).sum();
        }
        self.contacts.add_on_links(t, &x[..n], |k, torque| work.pushed[k] += torque);
        self.now.wrench = in_tool(pose, &total.wrench);
    }

    /// Rate of the state that was evaluated last.
    fn seen_rate(&self, y: &[f64], dy: &mut [f64]) {
        let total = self.coordinates;
        dy[..total].copy_from_slice(&y[total..2 * total]);
        dy[total..2 * total].copy_from_slice(&self.now.acceleration);
        for (b, bristle) in self.bristles.iter().enumerate() {
            dy[2 * total + b] = bristle.rate(bristle.velocity(&y[total..2 * total]), y[2 * total + b]);
        }
    }

    /// Torques that balance gravity and velocity terms of the bodies at the last evaluated state, N
    /// m.
    pub fn gravity(&self) -> Vec<f64> {
        self.work.bias.clone()
    }

    /// Pose of the tool at a state: top three rows of its matrix, world axes.
    pub fn tool_pose(&mut self, y: &[f64]) -> [f64; 12] {
        self.bodies.tool(&y[..self.n], &mut self.work.tool);
        self.work.tool.pose
    }

    /// Torques of the drives: held, played, or from the loop, within the limits of the drives.
    fn command(&mut self, t: f64, x: &[f64], v: &[f64]) {
        let now = &mut self.now;
        if !self.held.is_empty() {
            for (j, drive) in self.drives.iter().enumerate() {
                now.motor_torque[j] = drive.clipped(self.held[j]);
            }
            return;
        }
        self.trajectory.at(t, &mut self.hint, &mut now.desired);
        let tau = &mut now.motor_torque;
        match self.control.mode {
            Mode::Free => tau.fill(0.0),
            Mode::Torque => self.trajectory.torques_at(t, &mut self.hint, tau),
            Mode::Position | Mode::Pd | Mode::Exact => self.feedforward.at(t, tau),
        }
        let feedback = matches!(self.control.mode, Mode::Position | Mode::Pd);
        for (j, drive) in self.drives.iter().enumerate() {
            if feedback {
                let m = self.motor[j];
                let measured = x[m] - drive.encoder_offset;
                tau[j] += self.gains[0][j] * (now.desired[j][0] - measured);
                tau[j] += self.gains[1][j] * (now.desired[j][1] - v[m]);
            }
            tau[j] = drive.clipped(tau[j]);
        }
    }
}

impl Plant<'_> {
    /// Share of the torque of motor `j` that reaches the link of a stiff joint at velocity `v`,
    /// rad/s. Load-dependent friction takes the rest.
    fn passes(&self, j: usize, v: f64, since: f64) -> f64 {
        match self.drives[j].load {
            Some(load) if self.motor[j] == j => {
                let side = super::bristle::sign(self.now.link_torque[j]);
                let grows = load.level(side, v) * self.drives[j].warmth(since);
                1.0 / (1.0 + grows * self.work.sign[j] * side).max(0.1)
            }
            _ => 1.0,
        }
    }
}

impl Plant<'_> {
    /// Torque that multiplies the sign of a joint's velocity, N m.
    fn sign_level(&self, joint: usize, since: f64, x: &[f64], v: &[f64], z: f64) -> f64 {
        let (drive, m) = (&self.drives[joint], self.motor[joint]);
        let load = drive.load.map_or(0.0, |l| l.level(self.now.link_torque[joint], v[m]));
        let uneven = drive.asymmetric.map_or(0.0, |a| a.level * super::bristle::sign(z));
        let law = drive.law.as_ref().map_or(0.0, |law| law.level(&self.work.moment, joint));
        drive.warmth(since) * (drive.level(x[m], v[m]) + load + uneven) + law
    }
}

impl System for Plant<'_> {
    fn coordinates(&self) -> usize {
        self.coordinates
    }

    fn rate(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Breakdown> {
        self.look(t, y)?;
        self.seen_rate(y, dy);
        Ok(())
    }

    fn linearise(&mut self, t: f64, y: &[f64], linear: &mut Linear, dy: &mut [f64]) -> Result<(), Breakdown> {
        let (n, total) = (self.n, self.coordinates);
        self.see(t, y, true)?;
        self.seen_rate(y, dy);
        let (x, v, z) = (&y[..total], &y[total..2 * total], &y[2 * total..]);
        let since = t - self.start;
        linear.mass.clone_from(&self.work.mass);
        for matrix in [&mut linear.stiffness, &mut linear.damping] {
            matrix.clear();
            matrix.resize(total * total, 0.0);
        }
        for i in 0..n {
            for k in 0..n {
                linear.stiffness[i * total + k] = self.work.push_stiffness[i * n + k];
                linear.damping[i * total + k] = self.work.push_damping[i * n + k];
            }
        }
        let feedback = self.held.is_empty() && matches!(self.control.mode, Mode::Position | Mode::Pd);
        let passes: Vec<f64> = (0..n).map(|j| self.passes(j, v[j], since)).collect();
        for (j, drive) in self.drives.iter().enumerate() {
            let m = self.motor[j];
            let at = m * total + m;
            let clipped = drive.limit.is_some_and(|limit| self.now.motor_torque[j].abs() >= limit);
            let mut stiffness = drive.ripple.iter().map(|r| r.slope(x[m])).sum::<f64>().max(0.0);
            let mut damping = drive.warmth(since) * drive.viscosity(v[m]);
            if feedback && drive.actuated && !clipped {
                stiffness += self.gains[0][j];
                damping += self.gains[1][j];
            }
            linear.stiffness[at] += passes[j] * stiffness;
            linear.damping[at] += passes[j] * damping;
            linear.stiffness[j * total + j] += drive.spring.map_or(0.0, |s| s.slope(x[j]).max(0.0));
            if m != j {
                let [_, stiffness, damping] = drive.transmitted(x[m] - x[j], v[m] - v[j]);
                for (r, c, sign) in [(j, j, 1.0), (m, m, 1.0), (j, m, -1.0), (m, j, -1.0)] {
                    linear.stiffness[r * total + c] += sign * stiffness;
                    linear.damping[r * total + c] += sign * damping;
                }
            }
        }
        linear.bristles.clear();
        for (bristle, &z) in self.bristles.iter().zip(z) {
            let drive = &self.drives[bristle.joint];
            let speed = bristle.velocity(v);
            let [by_z, by_v] = bristle.sign_slopes(speed, z);
            let level = match bristle.part {
                Part::Sign => self.sign_level(bristle.joint, since, x, v, z),
                Part::Hysteresis => drive.warmth(since) * drive.hysteresis.map_or(0.0, |h| h.level),
                Part::Coupling(k) => self.couplings[k].coulomb,
            };
            let level = level.max(0.0) * if bristle.part == Part::Sign { passes[bristle.joint] } else { 1.0 };
            let [rate_v, rate_z] = bristle.rate_slopes(speed, z);
            let (c, a) = (level * by_z.max(0.0), rate_v.max(0.0));
            linear.bristles.push(LinearBristle { along: bristle.along, c, a, b: rate_z });
            for &(i, fi) in &bristle.along {
                for &(k, fk) in &bristle.along {
                    linear.damping[i * total + k] += level * by_v.max(0.0) * fi * fk;
                }
            }
        }
        Ok(())
    }
}
