//! All postures for a pose from a generated crate, without allocation or files.
//!
//! `cargo run --example postures`

use ur10e as arm;

fn main() {
    let q = [0.3, -1.2, 1.5, -0.7, 0.9, 0.2];
    let pose = arm::forward_kinematics(&q);
    let top: [[f64; 4]; 3] = core::array::from_fn(|i| pose[i]);
    let found = arm::inverse_kinematics(&top, &arm::ik::Query::default()).expect("a pose made of finite numbers");
    for solution in &found {
        println!("{:<24} {:.4?}  off by {:.0e} m", solution.branch.to_string(), solution.q, solution.position_error);
    }
    assert!(found.list.iter().any(|s| s.q.iter().zip(&q).all(|(a, b)| (a - b).abs() < 1e-9)));
    println!("{} postures, the one that made the pose among them", found.list.iter().count());
}
