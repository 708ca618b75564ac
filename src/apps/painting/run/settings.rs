//! Settings of the controller and of the estimator, from the task, the robot file and the gains.

use dh_codegen::robot::Robot;

use super::{AWAY, Known, RunTask};
use crate::apps::painting::tune::{Demands, Tuning};
use crate::control::law::{EstimatorSettings, ForceSettings, JointLoop, Limits, Settings};
use crate::control::robot::STANDING;
use crate::simulate::Simulator;

/// Pole of the tangential-force low-pass, rad/s. Faster changes are predicted; a faster pole
/// oscillates at 3 Hz with the estimate's low-pass and soft joints.
const ASIDE_POLE: f64 = 4.0;
/// Time of a stop along the path, s.
const STOP: f64 = 0.25;
/// Time in which the force rises to the desired one, s.
const RISE: f64 = 0.05;
/// Share of its torque limit that a joint's spring may exert while its position stays
/// bit-identical: above static friction.
const STUCK: f64 = 0.15;

/// Torque (N m) and speed (rad/s) limits of the file, with defaults for missing ones.
fn strength<const N: usize>(robot: &Robot) -> [[f64; N]; 2] {
    let limits: Vec<_> = robot.moving().iter().map(|&row| &robot.joints[row].limits).collect();
    [
        std::array::from_fn(|j| limits[j].torque.unwrap_or(1e3)),
        std::array::from_fn(|j| limits[j].velocity.unwrap_or(2.0)),
    ]
}

/// Limits of the file. Missing ones are libfranka's for the tool; the jerk limit is such that full
/// acceleration takes 2 ms, for joints too. The torque rate is a wide one, the torque range in 2
/// ms: where the displacement starts to move, the joint loops respond to its speed at once.
fn limits_of<const N: usize>(robot: &Robot, kp: &[f64; N], torque: &[f64; N], force: f64) -> Limits<N> {
    let limits: Vec<_> = robot.moving().iter().map(|&row| &robot.joints[row].limits).collect();
    let acceleration: [f64; N] = std::array::from_fn(|j| limits[j].acceleration.unwrap_or(f64::INFINITY));
    Limits {
        position: std::array::from_fn(|j| limits[j].position.unwrap_or([f64::NEG_INFINITY, f64::INFINITY])),
        acceleration,
        jerk: std::array::from_fn(|j| limits[j].jerk.unwrap_or(acceleration[j] / 2e-3)),
        tool: [1.7, 13.0, 6500.0],
        force_rate: force / RISE,
        torque_rate: torque.map(|most| most / 1e-3),
        saturated: 0.1,
        frozen: std::array::from_fn(|j| STUCK * torque[j] / kp[j].max(1e-6)),
        stuck: [2e-3, 0.2],
    }
}

/// Conditions that the gains must tolerate: sampling, filter, wall, and properties of the joints
/// beyond the model.
pub(super) fn demands(known: &Known<'_>, real: &Simulator, task: &RunTask<'_>) -> Demands {
    Demands {
        period: 1.0 / task.sensors.rate,
        corner: task.corner,
        stiffness: task.wall.stiffness,
        damping: task.wall.damping_at(task.force),
        drives: real
            .drives()
            .iter()
            .zip(&known.drives)
            .map(|(is, known)| {
                let [spring, loss] = is.elasticity.map_or([f64::INFINITY, 0.0], |e| [e.stiffness, e.damping]);
                [(is.rotor - known.rotor).max(0.0), spring, loss]
            })
            .collect(),
    }
}

/// Settings of the controller with the gains found.
pub(super) fn controller<const N: usize>(known: &Known<'_>, task: &RunTask<'_>, tuning: &Tuning) -> Settings<N> {
    let [torque, velocity] = strength(known.robot);
    let kp = std::array::from_fn(|j| tuning.joints[j].kp);
    Settings {
        period: 1.0 / task.sensors.rate,
        joints: JointLoop { kp, kd: std::array::from_fn(|j| tuning.joints[j].kd) },
        force: ForceSettings { kp: tuning.force.kp, ki: tuning.force.ki, range: [-AWAY, 0.3], rate: 0.2 },
        torque,
        velocity,
        patience: 5,
        contact: 0.1 * task.force,
        lost_after: 0.05,
        regain: 0.03,
        give_up: 2.0,
        most: 4.0 * task.force + 50.0,
        carry: task.law.carry,
        feed: task.law.feed,
        aside: task.law.aside,
        aside_pole: ASIDE_POLE,
        drag: task.law.drag,
        corner: task.corner,
        limits: limits_of(known.robot, &kp, &torque, task.force),
        stop: STOP,
    }
}

/// Settings of the estimator: joints are weighted by the spread of their torque errors.
pub(super) fn estimator<const N: usize>(known: &Known<'_>, task: &RunTask<'_>) -> EstimatorSettings<N> {
    EstimatorSettings {
        period: 1.0 / task.sensors.rate,
        corner: task.corner,
        weights: std::array::from_fn(|j| 1.0 / (known.spread[j] * known.spread[j]).max(1e-12)),
        damping: 1e-4,
        moment: task.moment,
        turning: std::array::from_fn(|j| known.turning[j]),
        rest: [STANDING; N],
    }
}
