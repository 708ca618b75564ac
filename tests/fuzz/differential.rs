//! Two routes to the same: inverse kinematics against the numeric recursion, on random arms.

use denavit::model::inverse_kinematics::{Ask, Kinematics};
use denavit::model::rigid_body::{Numeric, random::Family};
use denavit::numerics::prng::Random;
use dh_codegen::arm::Model;
use dh_codegen::ik::{Reference, Status};

use crate::variable;

/// Difference between a posture's pose and the pose that was asked for, as it says itself; beside
/// it the rounding of two ways to compute it, over lengths of some metres.
const ROUNDING: f64 = 1e-11;

#[test]
fn postures_of_random_arms_reach_their_poses() {
    let arms = 60 * variable("DENAVIT_FUZZ_ROUNDS", 1);
    let mut random = Random::new(variable("DENAVIT_FUZZ_SEED", 1));
    let (mut asked, mut found) = (0, 0);
    for arm in 0..arms {
        let robot = random.robot(&Family { rows: [1, 7], ..Family::default() });
        let Some(ik) = Kinematics::new(&robot, &Model::new(&robot)) else { continue };
        let oracle = Numeric::new(&robot);
        for _ in 0..3 {
            let q = random.vector(robot.dof(), 2.5);
            let goal = *oracle.frames(&q).last().unwrap();
            let pose = core::array::from_fn(|i| core::array::from_fn(|j| goal[(i, j)]));
            let redundancy = ik.redundancy(&q, &Reference::UP);
            let Ok(postures) = ik.solve(&pose, &Ask { redundancy, near: Some(q.clone()), ..Ask::default() }) else {
                continue;
            };
            asked += 1;
            found += usize::from(postures.status == Status::Ok);
            for posture in &postures.list {
                let reached = *oracle.frames(&posture.q).last().unwrap();
                let error = |i: usize| (reached[(i, 3)] - goal[(i, 3)]).abs();
                let apart = error(0).max(error(1)).max(error(2));
                let size = 1.0 + (0..3).fold(0.0, |m: f64, i| m.max(goal[(i, 3)].abs()));
                assert!(
                    apart <= posture.position_error + ROUNDING * size,
                    "arm {arm}: {apart:e} m from its pose, where it says {:e}: {}",
                    posture.position_error,
                    robot.to_yaml()
                );
            }
        }
    }
    println!("fuzz postures: {asked} poses of {arms} arms, {found} solved");
    // Most arms have a closed form or are searched; each pose is one that the arm has.
    assert!(2 * found > asked, "{found} of {asked}");
}
