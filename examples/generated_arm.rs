//! Use of a generated crate by itself: torques that hold the LWR up, and the distance of its
//! Jacobian from singularity.
//!
//! `cargo run --example generated_arm`

use kuka_lwr4 as arm;

fn main() {
    let q = [0.3, 0.8, -0.2, 1.2, 0.4, -0.9, 0.1];
    let phi = arm::STANDARD_VALUES.expect("the robot file has the parameters of every link");
    let beta = arm::base_parameters(&phi);

    let gravity = arm::gravity(&q, &beta);
    println!("gravity torques, N m: {gravity:.3?}");

    // The Jacobian's row along z of the base gives the torques of a push of 10 N.
    let jacobian = arm::jacobian(&q);
    let push: [f64; arm::DOF] = core::array::from_fn(|k| 10.0 * jacobian[2][k]);
    println!("torques of 10 N along z, N m: {push:.3?}");

    // The same function for eight configurations at once.
    use arm::runtime::Pack;
    let sweep: [Pack; arm::DOF] =
        core::array::from_fn(|k| Pack::new(core::array::from_fn(|lane| if k == 3 { 0.2 * lane as f64 } else { q[k] })));
    let heights = arm::forward_kinematics(&sweep)[2][3].to_array();
    println!("height of the wrist while the elbow bends, m: {heights:.3?}");
    assert!(heights.windows(2).all(|w| (w[0] - w[1]).abs() < 0.1));
}
