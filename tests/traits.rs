//! Code over the traits of `denavit-runtime` runs on every robot: on crates generated with it, and
//! on drop-in crates through their own copy.

#[path = "../examples/any_robot.rs"]
mod any_robot;

use denavit_runtime::{Description, Dynamics, Kinematics, Pose, Vector};

#[test]
fn one_controller_serves_two_robots() {
    any_robot::main();
}

/// Checks sizes and functions of a robot through its traits.
fn described<R: Dynamics<N>, const N: usize>(robot: &R, q: &[f64; N]) -> (Pose, Vec<f64>) {
    assert_eq!((N, R::JOINT_NAMES.len(), R::POSITION_LIMITS.len()), (R::DOF, R::DOF, R::DOF));
    let phi = R::Standard::from_fn(|k| 0.1 * (k as f64).sin());
    let beta = robot.base_parameters(&phi);
    assert_eq!((phi.as_ref().len(), beta.as_ref().len()), (R::STANDARD_NAMES.len(), R::BASE_NAMES.len()));
    let tau = robot.inverse_dynamics(q, q, q, &phi);
    let sum = |row: &R::Standard| row.as_ref().iter().zip(phi.as_ref()).map(|(w, p)| w * p).sum::<f64>();
    for (tau, row) in tau.iter().zip(&robot.regressor(q, q, q)) {
        assert!((tau - sum(row)).abs() < 1e-11 * (1.0 + tau.abs()));
    }
    (robot.tool_pose(q), tau.to_vec())
}

#[test]
fn traits_call_the_functions_of_their_crate() {
    let q = [0.1, -0.4, 0.15, 0.7];
    let (pose, _) = described(&scara::Robot, &q);
    assert_eq!(pose, scara::tool_pose(&q));
    let q = [0.1, -0.4, 0.9, 0.3, -1.2, 0.7];
    let (pose, _) = described(&puma560::Robot, &q);
    assert_eq!(pose, puma560::tool_pose(&q));
    assert_eq!((<scara::Robot as Description>::NAME, puma560::Robot::NAME), ("scara", "puma560"));
}

/// Both crates were generated with `denavit-runtime`: their postures have one type.
#[test]
fn robots_on_one_runtime_share_their_types() {
    let six: fn(&[f64; 6]) -> Pose = |q| puma560::Robot.forward_kinematics(q);
    let query: denavit_runtime::Query<'_, 6> = puma560::ik::Query::default();
    let found: denavit_runtime::Solutions<6> = puma560::inverse_kinematics(&six(&[0.3; 6]), &query).unwrap();
    assert!(!found.as_slice().is_empty());
}

/// A drop-in crate has the same traits in its own copy, also for packs of states.
#[test]
fn a_drop_in_crate_has_the_traits() {
    use kuka_lwr4::robot::{Dynamics, Kinematics};
    use kuka_lwr4::runtime::Pack;
    fn gravity<R: Dynamics<7, S>, S: kuka_lwr4::runtime::Scalar>(robot: &R, q: &[S; 7]) -> [S; 7] {
        let phi = robot.standard_values().unwrap();
        robot.gravity(q, &robot.base_parameters(&phi))
    }
    let q = [0.3, 0.8, -0.2, 1.2, 0.4, -0.9, 0.1];
    let packed = gravity(&kuka_lwr4::Robot, &q.map(|x| Pack::new([x; 8])));
    let single: [f64; 7] = gravity(&kuka_lwr4::Robot, &q);
    assert_eq!(packed.map(|p| p.to_array()[3]), single);
    assert_eq!(kuka_lwr4::Robot.jacobian(&q), kuka_lwr4::jacobian(&q));
}
