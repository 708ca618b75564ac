//! One controller and one planner for every robot: both use the traits of `denavit-runtime`, and
//! run here on a SCARA and on a Puma 560.
//!
//! `cargo run --example any_robot`

use denavit_runtime::{Dynamics, InverseKinematics, Query};

/// Computed torque: the arm follows `ddq = 100 (goal - q) - 20 dq` from rest. Returns the largest
/// error after two seconds, rad or m.
fn settle<R: Dynamics<N>, const N: usize>(robot: &R, beta: &R::Base, start: [f64; N], goal: [f64; N]) -> f64 {
    let (mut q, mut dq, step) = (start, [0.0; N], 0.001);
    for _ in 0..2000 {
        let wanted = core::array::from_fn(|k| 100.0 * (goal[k] - q[k]) - 20.0 * dq[k]);
        let tau = robot.inverse_dynamics_base(&q, &dq, &wanted, beta);
        let ddq = robot.forward_dynamics(&q, &dq, &tau, beta);
        for k in 0..N {
            dq[k] += step * ddq[k];
            q[k] += step * dq[k];
        }
    }
    (0..N).map(|k| (goal[k] - q[k]).abs()).fold(0.0, f64::max)
}

/// Moves the flange to a posture's pose with the solution nearest to `start`.
fn show<R: Dynamics<N> + InverseKinematics<N>, const N: usize>(robot: &R, start: [f64; N], posture: [f64; N]) {
    let pose = robot.forward_kinematics(&posture);
    let query = Query { near: Some(&start), ..Query::default() };
    let found = robot.inverse_kinematics(&pose, &query).expect("a pose of finite numbers");
    let goal = found.nearest(&start).expect("a pose within reach").q;
    let phi = robot.standard_values().expect("a file with the parameters of every link");
    let error = settle(robot, &robot.base_parameters(&phi), start, goal);
    println!("{}: {} joints, {} postures, error after 2 s {error:.0e}", R::NAME, R::DOF, found.as_slice().len());
    assert!(error < 1e-6);
}

pub(crate) fn main() {
    show(&scara::Robot, [0.0, 0.5, 0.05, 0.0], [0.4, -0.8, 0.1, 0.3]);
    show(&puma560::Robot, [0.0, 0.3, -0.5, 0.1, 0.6, 0.0], [0.5, -0.4, 0.3, -0.2, 0.8, 0.4]);
}
