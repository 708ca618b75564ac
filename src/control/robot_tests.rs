//! Checks a robot file's model for the law against finite differences of its own results.

use dh_codegen::arm::param;
use dh_codegen::robot::{Robot, no_files};

use super::law::Model;
use super::robot::RobotModel;
use crate::model::interpreted::Interpreted;
use crate::simulate::{Effects, Simulator};

const Q: [f64; 7] = [0.3, -0.6, 0.2, 1.2, -0.4, 0.8, 0.1];

/// Calls `with` with the LWR's model; the point of contact is offset from the last frame.
fn lwr(with: impl FnOnce(&mut RobotModel<'_>)) {
    let text = include_str!("../../robots/kuka-lwr4.yaml");
    let mut robot = Robot::from_yaml(text, &no_files).unwrap().robot;
    let tool = include_str!("../../robots/tools/large-roller.yaml");
    robot.tool = Some(dh_codegen::robot::Tool::from_yaml(tool, "large-roller").unwrap().0);
    let drives = Simulator::new(&robot, &Effects::default()).unwrap().drives().to_vec();
    let arm = Interpreted::new(&robot, &Interpreted::BODIES);
    let standard = param::standard_values(&robot).unwrap();
    with(&mut RobotModel::new(&robot, Box::new(arm.bodies(&standard)), None, drives));
}

#[test]
fn the_jacobian_of_the_contact_is_the_slope_of_its_place() {
    lwr(|model| {
        let jacobian = model.contact(&Q).jacobian;
        for j in 0..7 {
            let mut at = |by: f64| {
                let mut q = Q;
                q[j] += by;
                model.contact(&q).origin
            };
            let (ahead, behind) = (at(1e-6), at(-1e-6));
            for i in 0..3 {
                let slope = (ahead[i] - behind[i]) / 2e-6;
                assert!((jacobian[i][j] - slope).abs() < 1e-7, "{i} {j}: {} {slope}", jacobian[i][j]);
            }
        }
    });
}

#[test]
fn nothing_is_fed_forward_for_a_motion_that_rests() {
    lwr(|model| {
        let still = model.moving(&Q, &[0.0; 7], &[0.0; 7]);
        assert!(still.iter().all(|t| t.abs() < 1e-12), "{still:?}");
    });
}
