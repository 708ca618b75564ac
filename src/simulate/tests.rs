//! Tests of the simulator: laws of mechanics, and the signature of each effect.

mod effects;
mod formulas;
mod integrators;
mod laws;
mod sliding;

use dh_codegen::robot::{Effect, Effects, Robot, no_files};

use super::*;

/// Reads a robot file of the repository.
pub(super) fn robot(name: &str) -> Robot {
    let path = format!("{}/robots/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    Robot::from_yaml(&text, &no_files).unwrap().robot
}

/// The same without friction and rotors.
pub(super) fn frictionless(name: &str) -> Robot {
    let mut robot = robot(name);
    robot.joints.iter_mut().for_each(|j| j.drive = Default::default());
    robot
}

pub(super) fn effect(name: &str, parameters: &[(&str, f64)]) -> Effect {
    Effect::from_keys(name, parameters).unwrap()
}

/// One effect of one joint, counted from 0.
pub(super) fn at_joint(joint: usize, name: &str, parameters: &[(&str, f64)]) -> Effects {
    Effects { joints: vec![(joint, effect(name, parameters))], robot: Vec::new(), ..Effects::default() }
}

/// Motion with a sum of two sines for each joint, at rest at both ends.
pub(super) fn motion(dof: usize, size: f64, seconds: f64) -> Trajectory {
    let step = 0.01;
    let t: Vec<f64> = (0..=(seconds / step).round() as usize).map(|k| k as f64 * step).collect();
    let q = (0..dof).flat_map(|j| {
        let (a, b) = (0.35 + 0.07 * j as f64, 0.9 - 0.05 * j as f64);
        t.iter().map(move |&t| {
            let s = (t / seconds).clamp(0.0, 1.0);
            let window = (std::f64::consts::PI * s).sin().powi(2);
            let turn = std::f64::consts::TAU * t;
            size * window * ((a * turn + j as f64).sin() + 0.4 * (b * turn).cos()) / (1.0 + 0.2 * j as f64)
        })
    });
    Trajectory::new(dof, t.clone(), q.collect(), None, None).unwrap()
}

pub(super) fn exact(rate: f64) -> Request {
    Request {
        control: Control { mode: Mode::Exact, ..Control::default() },
        sensors: Sensors::perfect(rate),
        ..Request::default()
    }
}

pub(super) fn loop_at(rate: f64) -> Request {
    Request { sensors: Sensors::perfect(rate), ..Request::default() }
}

pub(super) fn run(robot: &Robot, effects: &Effects, trajectory: &Trajectory, request: &Request) -> Recording {
    Simulator::new(robot, effects).unwrap().run(trajectory, request, &mut |_| {}).unwrap()
}
