//! Exact mode without loop or integration: the links follow the motion, and torques follow from
//! inverse dynamics and the laws.
//!
//! The motor of a soft joint is where its spring carries the link; its velocity and acceleration
//! are finite differences with a step of 1 ms. The spring's damping is omitted. A gear with
//! backlash changes sides within a small torque instead of a short time.

use super::bristle::{Part, sign};
use super::contact::{External, in_tool};
use super::drive::Drive;
use super::effects::{GearCoupling, Moment};
use super::plant::Plant;
use super::robot::{Settled, SimulatedRobot};
use super::sensors::Truth;
use super::trajectory::{Point, Trajectory};
use crate::model::{Arm, Dynamics, States, ToolState};

/// Step of the finite differences, s.
const STEP: f64 = 1e-3;
/// Torque within which a gear with backlash changes sides, as a share of the torque limit.
const CHANGES_SIDE: f64 = 2e-3;

pub(super) fn follow(
    built: &SimulatedRobot,
    settled: &Settled,
    plant: &Plant<'_>,
    trajectory: &Trajectory,
    external: &[&dyn External],
    instants: Vec<f64>,
) -> Truth {
    let n = settled.drives.len();
    let len = instants.len();
    let span = trajectory.span();
    let mut truth = Truth::sized(n, instants);
    let soft = settled.drives.iter().any(Drive::is_soft);
    let shifts: &[f64] = if soft { &[0.0, -2.0, -1.0, 1.0, 2.0] } else { &[0.0] };
    // Times of the difference stencils, shifted inwards near the ends.
    let times: Vec<f64> = shifts
        .iter()
        .flat_map(|&shift| {
            let inside = (span.start + 2.0 * STEP)..(span.end - 2.0 * STEP);
            truth.t.iter().map(
                move |&t| {
                    if shift == 0.0 { t } else { t.max(inside.start).min(inside.end) + shift * STEP }
                },
            )
        })
        .collect();
    let many = times.len();
    let (states, desired) = links(trajectory, &settled.drives, &times);
    truth.desired = (0..n).flat_map(|j| desired[j * many..j * many + len].to_vec()).collect();
    let moved = carried(&states, &settled.couplings);
    let load = loads(built, settled, external, &times, &moved, &mut truth);

    let mut ddq = vec![0.0; n * len];
    for (j, drive) in settled.drives.iter().enumerate() {
        let row = |s: usize| j * many + s;
        let bend = |s: usize| {
            if !drive.is_soft() {
                return 0.0;
            }
            let torque = load[row(s)];
            let slack = drive.backlash.map_or(0.0, |b| {
                let small = CHANGES_SIDE * drive.rated;
                0.5 * b.width * torque / (torque * torque + small * small).sqrt()
            });
            torque / drive.transmission().stiffness + slack
        };
        for k in 0..len {
            let at = j * len + k;
            truth.link_q[at] = moved.q[row(k)];
            truth.link_dq[at] = moved.dq[row(k)];
            truth.link_torque[at] = load[row(k)];
            truth.motor_q[at] = states.q[row(k)] + bend(k);
            truth.motor_dq[at] = states.dq[row(k)];
            ddq[at] = states.ddq[row(k)];
            if drive.is_soft() {
                let [a, b, c, d] = [1, 2, 3, 4].map(|shift| bend(shift * len + k));
                truth.motor_dq[at] += (a - 8.0 * b + 8.0 * c - d) / (12.0 * STEP);
                // Second derivative from the four outer points of the stencil: exact for cubics.
                ddq[at] += (a - b - c + d) / (3.0 * STEP * STEP);
            }
        }
    }
    torques(settled, plant, &ddq, span.start, &mut truth);
    truth
}

/// Torques that the gears transmit: bodies, springs, external wrenches, and the load of a link that
/// is also carried by another joint's motor.
fn loads(
    built: &SimulatedRobot,
    settled: &Settled,
    external: &[&dyn External],
    times: &[f64],
    moved: &States,
    truth: &mut Truth,
) -> Vec<f64> {
    let many = moved.len;
    let mut load = vec![0.0; settled.drives.len() * many];
    built.real().inverse_dynamics(moved, &built.bodies_standard, &mut load);
    for (j, drive) in settled.drives.iter().enumerate() {
        if let Some(spring) = drive.spring {
            (0..many).for_each(|s| load[j * many + s] += spring.torque(moved.q[j * many + s]));
        }
    }
    push(built, settled, external, times, moved, &mut load, truth);
    let on_links = load.clone();
    for c in settled.couplings.iter().filter(|c| c.carries != 0.0) {
        (0..many).for_each(|s| load[c.other * many + s] += c.carries * on_links[c.motor * many + s]);
    }
    load
}

/// Motion of the links, including links that also turn with another joint's motor.
fn carried(states: &States, couplings: &[GearCoupling]) -> States {
    let (mut moved, len) = (states.clone(), states.len);
    for c in couplings.iter().filter(|c| c.carries != 0.0) {
        let parts = [(&mut moved.q, &states.q), (&mut moved.dq, &states.dq), (&mut moved.ddq, &states.ddq)];
        for (to, from) in parts {
            (0..len).for_each(|s| to[c.motor * len + s] += c.carries * from[c.other * len + s]);
        }
    }
    moved
}

/// Motion on the motor side of stiff gears (desired plus encoder offset), and the desired motion.
fn links(trajectory: &Trajectory, drives: &[Drive], times: &[f64]) -> (States, Vec<Point>) {
    let (n, len) = (drives.len(), times.len());
    let mut states = States::zeros(n, len);
    let mut desired = vec![[0.0; 3]; n * len];
    let (mut hint, mut points) = (0, vec![[0.0; 3]; n]);
    for (s, &t) in times.iter().enumerate() {
        trajectory.at(t, &mut hint, &mut points);
        for (j, point) in points.iter().enumerate() {
            let at = j * len + s;
            desired[at] = *point;
            states.q[at] = point[0] + drives[j].encoder_offset;
            states.dq[at] = point[1];
            states.ddq[at] = point[2];
        }
    }
    (states, desired)
}

/// Subtracts the external wrenches from the loads (`J' w`), and records those on the tool, in its
/// axes.
fn push(
    built: &SimulatedRobot,
    settled: &Settled,
    external: &[&dyn External],
    times: &[f64],
    states: &States,
    load: &mut [f64],
    truth: &mut Truth,
) {
    let (n, many, len) = (settled.drives.len(), times.len(), truth.t.len());
    if settled.contacts.stated.is_empty() && external.is_empty() {
        return;
    }
    let mut bodies = built.real().bodies(&built.bodies_standard);
    let mut tool = ToolState::default();
    for (s, &t) in times.iter().enumerate() {
        if external.is_empty() && !settled.contacts.act(t) {
            continue;
        }
        let of = |values: &[f64]| (0..n).map(|j| values[j * many + s]).collect::<Vec<f64>>();
        let (q, dq) = (of(&states.q), of(&states.dq));
        bodies.tool(&q, &mut tool);
        let ToolState { pose, jacobian } = &tool;
        let twist: [f64; 6] = std::array::from_fn(|i| (0..n).map(|k| jacobian[i * n + k] * dq[k]).sum());
        let total = settled.contacts.total(external, t, pose, &twist).wrench;
        settled.contacts.add_on_links(t, &q, |j, torque| load[j * many + s] -= torque);
        for j in 0..n {
            load[j * many + s] -= (0..6).map(|i| jacobian[i * n + j] * total[i]).sum::<f64>();
        }
        if s < len {
            let local = in_tool(pose, &total);
            (0..6).for_each(|i| truth.wrench[i * len + s] = local[i]);
        }
    }
}

/// Sets the inputs of closed-form laws at sample `k`; `moment.t` is set already.
fn see(moment: &mut Moment, settled: &Settled, truth: &Truth, ddq: &[f64], signs: &[f64], k: usize) {
    let len = truth.t.len();
    let motion = |j: usize| (truth.motor_q[j * len + k], truth.motor_dq[j * len + k], signs[j]);
    moment.set(moment.t, &settled.drives, motion);
    signs.iter().enumerate().for_each(|(j, _)| moment.ddq[j] = ddq[j * len + k]);
}

/// Adds friction, rotor, ripple and laws to the load, which gives the motor torques.
fn torques(settled: &Settled, plant: &Plant<'_>, ddq: &[f64], start: f64, truth: &mut Truth) {
    let (n, len) = (settled.drives.len(), truth.t.len());
    let motors: Vec<usize> = (0..n).collect();
    // A bristle's directions are plant coordinates; here the motors are ordered by joint.
    let joint_of = |coordinate: usize| plant.motor.iter().position(|&m| m == coordinate).unwrap_or(coordinate);
    let mut z: Vec<Option<f64>> = vec![None; plant.bristles.len()];
    let mut moment = Moment::of(n);
    let (mut signs, mut hysteresis, mut coupled) = (vec![0.0; n], vec![0.0; n], vec![0.0; settled.couplings.len()]);
    for k in 0..len {
        for (b, bristle) in plant.bristles.iter().enumerate() {
            let sum = |values: &[f64], k: usize| -> f64 {
                bristle.along.iter().map(|&(c, factor)| factor * values[joint_of(c) * len + k]).sum()
            };
            let v = sum(&truth.motor_dq, k);
            let after = match z[b] {
                None => sign(v),
                Some(z) => {
                    let before = sum(&truth.motor_dq, k - 1);
                    if before * v < 0.0 {
                        // The velocity changed sign in between, at constant acceleration.
                        let dt = truth.t[k] - truth.t[k - 1];
                        let part = before / (before - v);
                        bristle.after(0.5 * v * (1.0 - part) * dt, bristle.after(0.5 * before * part * dt, z))
                    } else {
                        bristle.after(sum(&truth.motor_q, k) - sum(&truth.motor_q, k - 1), z)
                    }
                }
            };
            z[b] = Some(after);
            let s = bristle.sign(v, after);
            match bristle.part {
                Part::Sign => signs[bristle.joint] = s,
                Part::Hysteresis => hysteresis[bristle.joint] = s,
                Part::Coupling(c) => coupled[c] = s,
            }
        }
        let since = truth.t[k] - start;
        moment.t = since;
        see(&mut moment, settled, truth, ddq, &signs, k);
        for &j in &motors {
            let (drive, at) = (&settled.drives[j], j * len + k);
            let (q, v, load) = (truth.motor_q[at], truth.motor_dq[at], truth.link_torque[at]);
            let loaded = drive.load.map_or(0.0, |l| l.level(load, v)) * signs[j];
            let friction = drive.warmth(since) * (drive.friction(q, v, signs[j], hysteresis[j]) + loaded);
            let law = drive.law.as_ref().map_or(0.0, |law| law.torque(&moment));
            truth.motor_torque[at] =
                load + drive.rotor * ddq[at] + friction + drive.plain.offset + drive.ripple(q) + law;
            truth.temperature[at] = drive.temperature(since);
        }
        for (c, &s) in settled.couplings.iter().zip(&coupled) {
            let (m, o) = (c.motor * len + k, c.other * len + k);
            let [on_k, on_m] = c.torques([truth.motor_dq[m], truth.motor_dq[o]], [ddq[m], ddq[o]]);
            truth.motor_torque[o] += on_k + c.ratio * c.coulomb * s;
            truth.motor_torque[m] += on_m + c.coulomb * s;
        }
        clip(settled, truth, k);
    }
}

/// Limits the torques to what the drives can deliver.
fn clip(settled: &Settled, truth: &mut Truth, k: usize) {
    let len = truth.t.len();
    for (j, drive) in settled.drives.iter().enumerate() {
        if let Some(limit) = drive.limit {
            let torque = &mut truth.motor_torque[j * len + k];
            *torque = torque.clamp(-limit, limit);
        }
    }
}
