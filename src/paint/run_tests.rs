//! The prediction of the gains' tool against the simulated arm.

use super::run::{Feedback, Known, Law, Run, SETTLE, Task, run};
use super::wall::RollerWall;
use crate::control::robot::contact_point;
use crate::interpreted::Interpreted;
use crate::simulate::{Sensors, Simulator, Trajectory};
use dh_codegen::arm::param;
use dh_codegen::robot::{Effects, Robot};

/// Three joints in a plane, a stick in the hand.
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
    let robot = Robot::from_yaml(FILE, &|name| Err(format!("no file {name}"))).unwrap().robot;
    let real = Simulator::new(&robot, &Effects::default()).unwrap();
    let arm = Interpreted::new(&robot, &Interpreted::BODIES);
    let standard = param::standard_values(&robot).unwrap();
    let known =
        Known { robot: &robot, arm: &arm, standard: &standard, drives: real.drives().to_vec(), spread: vec![1.0; 3] };
    // Elbow up, hand along x.
    let q = [0.8, -1.3, 0.5];
    let motion = Trajectory::rest(&q, 2.0).unwrap();
    let x = 0.5 * q[0].cos() + 0.4 * (q[0] + q[1]).cos() + 0.2;
    let task = Task {
        motion: &motion,
        wall: RollerWall::new([x, 0.0, 0.0], [-1.0, 0.0, 0.0], contact_point(robot.tool.as_ref())),
        force: 20.0,
        feedback,
        moment: false,
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
