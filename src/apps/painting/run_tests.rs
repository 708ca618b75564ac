//! Checks the predictions of `tune` against the simulated arm.

use super::run::{Feedback, Known, Law, Run, RunTask, SETTLE, root_mean_square, run};
use super::wall::RollerWall;
use crate::control::iterative_learning::Learned;
use crate::control::law::Model;
use crate::control::robot::{RobotModel, contact_point};
use crate::model::interpreted::Interpreted;
use crate::simulate::{Sensors, SimulationFile, Simulator, Trajectory};
use dh_codegen::arm::param;
use dh_codegen::robot::{Effects, Robot, no_files};

/// Three joints in a plane, with a stick as the tool.
pub(super) const FILE: &str = "
name: planar3r
convention: modified
gravity: [0, 0, -9.81]
joints:
  - { type: revolute, torque: 100, velocity: 2, drive: { rotor_inertia: 0.05, friction: { viscous_friction: 0.5 } } }
  - { type: revolute, d: 0.5, torque: 100, velocity: 2, drive: { rotor_inertia: 0.05, friction: { viscous_friction: 0.5 } } }
  - { type: revolute, d: 0.4, torque: 100, velocity: 2, drive: { rotor_inertia: 0.02, friction: { viscous_friction: 0.2 } } }
links:
  - { M: 3, MS: [0.75, 0, 0], I: [0, 0.25, 0.25, 0, 0, 0] }
  - { M: 2, MS: [0.4, 0, 0], I: [0, 0.11, 0.11, 0, 0, 0] }
  - { M: 0.5, MS: [0.05, 0, 0], I: [0, 0.01, 0.01, 0, 0, 0] }
tool: { name: stick, pose: { xyz: [0.1, 0, 0], rpy: [0, pi/2, 0] }, geometry: { length: 0.1, width: 0.05 } }
";

fn pressed(feedback: Feedback, law: Law) -> Run {
    let robot = Robot::from_yaml(FILE, &no_files).unwrap().robot;
    let real = Simulator::new(&robot, &Effects::default()).unwrap();
    let arm = Interpreted::new(&robot, &Interpreted::BODIES);
    let standard = param::standard_values(&robot).unwrap();
    let known = Known {
        robot: &robot,
        arm: &arm,
        standard: &standard,
        drives: real.drives().to_vec(),
        spread: vec![1.0; 3],
        turning: vec![f64::INFINITY; 3],
    };
    // Elbow up, hand along x.
    let q = [0.8, -1.3, 0.5];
    let motion = Trajectory::rest(&q, 2.0).unwrap();
    let x = 0.5 * q[0].cos() + 0.4 * (q[0] + q[1]).cos() + 0.2;
    let task = RunTask {
        motion: &motion,
        wall: RollerWall::new([x, 0.0, 0.0], [-1.0, 0.0, 0.0], contact_point(robot.tool.as_ref())),
        force: 20.0,
        feedback,
        moment: 0.0,
        law,
        corner: 20.0,
        settle: SETTLE,
        learned: None,
        sensors: Sensors { torque_noise: vec![0.0], ..Sensors::default() },
        seed: 1,
    };
    run(&known, &real, &task, &mut |_| {}).unwrap()
}

#[test]
fn it_presses_as_asked() {
    for (feedback, law) in [(Feedback::Estimated, Law::FED), (Feedback::Measured, Law::PAPER)] {
        let run = pressed(feedback, law);
        assert_eq!(run.status, crate::control::law::Status::Pressing);
        assert!(run.accuracy.measured_desired < 0.3, "{:?}", run.accuracy);
        let off = run.trace.estimated.iter().zip(&run.trace.truth).map(|(e, t)| (e - t).abs());
        assert!(off.fold(0.0, f64::max) < 1.0);
        assert!(run.tuning.force.margins.phase >= 45.0 && run.tuning.force.margins.radius < 1.0);
    }
}

/// Paints 0.4 m along the wall in 3 s. The gears of the first two joints have ripple that the
/// controller's model lacks.
fn coats(count: usize) -> Vec<Run> {
    let robot = Robot::from_yaml(FILE, &no_files).unwrap().robot;
    let text = "joints:\n  1: { torque_ripple: { RC: 0.8, RS: 0.3 } }\n  2: { torque_ripple: { RC: 0.5, RS: -0.4 } }\n";
    let effects = SimulationFile::from_yaml(text, &robot).unwrap().effects;
    let real = Simulator::new(&robot, &effects).unwrap();
    let drives = Simulator::new(&robot, &Effects::default()).unwrap().drives().to_vec();
    let arm = Interpreted::new(&robot, &Interpreted::BODIES);
    let standard = param::standard_values(&robot).unwrap();
    let mut model = RobotModel::new(&robot, Box::new(arm.bodies(&standard)), None, drives.clone());
    let known =
        Known { robot: &robot, arm: &arm, standard: &standard, drives, spread: vec![1.0; 3], turning: vec![0.0; 3] };
    let first = [0.6, -1.3, 0.7];
    let place = model.contact(&first).origin;
    let times: Vec<f64> = (0..=150).map(|k| 0.02 * f64::from(k)).collect();
    let (mut rows, mut height) = (vec![first], 0.0);
    for t in &times[1..] {
        let s = t / 3.0;
        let up = 0.4 * s * s * s * (10.0 + s * (6.0 * s - 15.0));
        let last = rows[rows.len() - 1];
        rows.push(model.displaced(&last, &[0.0, up - height, 0.0], &last).unwrap());
        height = up;
    }
    let q = (0..3).flat_map(|j| rows.iter().map(move |row| row[j])).collect();
    let motion = Trajectory::new(3, times, q, None, None).unwrap();
    let mut runs: Vec<Run> = Vec::new();
    for coat in 0..count {
        let learned = runs.last().and_then(|run| run.learned.clone());
        let task = RunTask {
            motion: &motion,
            wall: RollerWall::new(place, [-1.0, 0.0, 0.0], contact_point(robot.tool.as_ref())),
            force: 20.0,
            feedback: Feedback::Estimated,
            moment: 0.0,
            law: Law::FED,
            corner: 10.0,
            settle: 1.5,
            learned: learned.as_ref(),
            sensors: Sensors { torque_noise: vec![0.0], ..Sensors::default() },
            seed: coat as u64,
        };
        runs.push(run(&known, &real, &task, &mut |_| {}).unwrap());
    }
    runs
}

#[test]
fn a_coat_learns_from_the_one_before() {
    let runs = coats(3);
    let left: Vec<f64> = runs.iter().map(|run| run.accuracy.estimated_desired).collect();
    // The ripple is faster than the loop: it shows on the first coat, and repeats.
    assert!(left[0] > 0.15 && left[2] < 0.6 * left[0] && left[1] < left[0], "{left:?}");
    for run in &runs {
        assert_eq!(run.status, crate::control::law::Status::Pressing);
        let learned = run.learned.as_ref().unwrap();
        assert!(learned.displacement.iter().all(|x| x.abs() <= 5e-3));
        assert!(learned.at(-1.0) == 0.0 && learned.at(99.0) == 0.0 && learned.at(f64::NAN) == 0.0);
    }
    assert_eq!(Learned::default().at(0.0), 0.0);
}

/// A run that ended before painting has no error: it is not reported as zero.
#[test]
fn nothing_painted_is_not_accurate() {
    assert!(root_mean_square(0, &|_| 1.0).is_nan());
    assert_eq!(root_mean_square(2, &|k| [3.0, 4.0][k]), 12.5_f64.sqrt());
}
