//! With the feature `derive` two robots come from their files and share types and traits.

use denavit_runtime::{Description, DhRobot, Dynamics, InverseKinematics, Kinematics, Query, Solutions};

#[derive(DhRobot)]
#[dh(file = "../../robots/planar2r.yaml")]
struct Planar;

#[derive(DhRobot)]
#[dh(file = "../../robots/scara.yaml")]
struct Scara;

/// Nearest posture for the pose of `q`, and the torques that hold the arm there, N m.
fn hold<R: Dynamics<N> + InverseKinematics<N>, const N: usize>(robot: &R, q: [f64; N]) -> (Solutions<N>, [f64; N]) {
    let pose = robot.forward_kinematics(&q);
    let found = robot.inverse_kinematics(&pose, &Query { near: Some(&q), ..Query::default() }).unwrap();
    let beta = robot.base_parameters(&robot.standard_values().unwrap());
    (found, robot.gravity(&q, &beta))
}

#[test]
fn one_function_serves_both() {
    let (found, tau) = hold(&Planar, [0.3, 0.4]);
    assert!((found.nearest(&[0.3, 0.4]).unwrap().q[1] - 0.4).abs() < 1e-9);
    assert!(tau[0] > tau[1] && tau[1] > 0.0);
    let (found, tau) = hold(&Scara, [0.3, 0.4, 0.1, 0.2]);
    assert!(!found.as_slice().is_empty());
    assert!(tau[0] == 0.0 && tau[2] != 0.0, "only the stroke carries weight: {tau:?}");
    assert_eq!((Planar::DOF, Scara::DOF), (2, 4));
}

#[derive(DhRobot)]
#[dh(file = "tests/robots/tilted.yaml")]
struct Tilted;

/// Poses, Jacobians and energies are in the world, whichever way the base leans.
#[test]
fn a_tilted_base_has_its_poses_and_velocities_in_the_world() {
    let (q, dq, step) = ([0.4, 0.3, -0.8], [0.7, -0.5, 1.1], 1e-5);
    let at = |t: f64| core::array::from_fn(|k| q[k] + t * dq[k]);
    assert!(tilted::GRAVITY_IN_BASE[2].abs() < 1.0, "the base leans: {:?}", tilted::GRAVITY_IN_BASE);
    let (here, before, after) = (Tilted.tool_pose(&q), Tilted.tool_pose(&at(-step)), Tilted.tool_pose(&at(step)));
    let rate = |i: usize, j: usize| (after[i][j] - before[i][j]) / (2.0 * step);
    let skew = |i: usize, j: usize| (0..3).map(|k| rate(i, k) * here[j][k]).sum::<f64>();
    let twist = [rate(0, 3), rate(1, 3), rate(2, 3), skew(2, 1), skew(0, 2), skew(1, 0)];
    for (row, expected) in Tilted.tool_jacobian(&q).iter().zip(twist) {
        let found: f64 = row.iter().zip(&dq).map(|(j, dq)| j * dq).sum();
        assert!((found - expected).abs() < 1e-8, "{found} is not {expected}");
    }
    // A weight in the tool takes J' m g with the world's gravity.
    assert_eq!((Tilted::GRAVITY, tilted::GRAVITY), ([0.0, 0.0, -9.81], Tilted::GRAVITY));
    let lifted = Tilted.payload_regressor(&q, &[0.0; 3], &[0.0; 3]);
    let jacobian = Tilted.tool_jacobian(&q);
    for k in 0..3 {
        let expected: f64 = (0..3).map(|i| -jacobian[i][k] * Tilted::GRAVITY[i]).sum();
        assert!((lifted[k][0] - expected).abs() < 1e-12, "{} is not {expected}", lifted[k][0]);
    }
    // Heights in the world are the potential energy of a mass, and its rate is the work of gravity.
    let phi = Tilted.standard_values().unwrap();
    let energy = |q: &[f64; 3]| -> f64 {
        let row = Tilted.potential_energy_regressor(q);
        row.iter().zip(&phi).map(|(u, p)| u * p).sum()
    };
    let tau = Tilted.gravity(&q, &Tilted.base_parameters(&phi));
    let power: f64 = tau.iter().zip(&dq).map(|(tau, dq)| tau * dq).sum();
    let found = (energy(&at(step)) - energy(&at(-step))) / (2.0 * step);
    assert!((found - power).abs() < 1e-7 * (1.0 + power.abs()), "{found} is not {power}");
}
