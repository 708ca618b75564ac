//! Warnings where a motion contradicts the robot: units, columns, the clock. The motion is played
//! all the same.

use dh_codegen::robot::{JointKind, Robot};

use super::Trajectory;

/// Share of the position range by which a position may exceed its limits.
const BEYOND: f64 = 0.1;
/// Multiple of the velocity limit above which a warning is given.
const FAST: f64 = 1.5;
/// Relative difference between velocities and the slope of the positions that gives a warning.
const OFF: f64 = 0.5;

/// One sentence per contradiction, with joint and figures.
pub fn motion_warnings(trajectory: &Trajectory, robot: &Robot) -> Vec<String> {
    let mut said = Vec::new();
    let moving = robot.joints.iter().filter(|joint| joint.kind != JointKind::Fixed);
    for (k, joint) in moving.enumerate().take(trajectory.dof()) {
        let number = k + 1;
        let unit = if joint.kind == JointKind::Prismatic { "m" } else { "rad" };
        let ([least, most], [speed, at]) = (trajectory.reach(k), trajectory.fastest(k));
        if let Some([low, high]) = joint.limits.position {
            let (room, far) = (BEYOND * (high - low), if most - high > low - least { most } else { least });
            if most > high + room || least < low - room {
                let degrees = unit == "rad" && far.abs() > 4.0 * std::f64::consts::PI;
                said.push(format!(
                    "joint {number} is asked to go to {far:.4} {unit}, its limits are {low:.4} and {high:.4} ({})",
                    if degrees { "degrees? write radians" } else { "columns in the robot's order?" }
                ));
            }
        }
        if let Some(limit) = joint.limits.velocity.filter(|limit| speed > FAST * limit) {
            said.push(format!(
                "joint {number} is asked to move at {speed:.4} {unit}/s at {at:.3} s, its limit is {limit:.4} (time in s? a jump of the position?)"
            ));
        }
        let off = trajectory.off_slope(k);
        if off > OFF {
            said.push(format!(
                "dq{number} is not the slope of q{number}: they differ by {:.0} % (columns exchanged, other units, or rows missing?); both are followed, so the joint speeds up and brakes between rows",
                100.0 * off
            ));
        }
    }
    said
}

#[cfg(test)]
mod tests {
    use dh_codegen::robot::no_files;

    use super::*;

    #[test]
    fn units_jumps_and_exchanged_columns_are_named() {
        let text = "name: one\nconvention: modified\njoints:\n  - { name: A, type: revolute, position: [-2, 2], velocity: 3 }\n";
        let robot = Robot::from_yaml(text, &no_files).unwrap().robot;
        let t: Vec<f64> = (0..200).map(|k| 0.01 * f64::from(k)).collect();
        let q: Vec<f64> = t.iter().map(|t| (2.0 * t).sin()).collect();
        let dq: Vec<f64> = t.iter().map(|t| 2.0 * (2.0 * t).cos()).collect();
        let of = |t: &[f64], q: Vec<f64>, dq: Option<Vec<f64>>| {
            motion_warnings(&Trajectory::new(1, t.to_vec(), q, dq, None).unwrap(), &robot).join("; ")
        };
        assert_eq!(of(&t, q.clone(), Some(dq.clone())), "");
        assert_eq!(of(&t, q.clone(), None), "");
        let degrees = |v: &[f64]| v.iter().map(|x| x.to_degrees()).collect::<Vec<f64>>();
        assert!(of(&t, degrees(&q), None).contains("degrees? write radians"));
        assert!(of(&t, q.clone(), Some(degrees(&dq))).contains("dq1 is not the slope of q1"));
        let jump = q.iter().enumerate().map(|(k, v)| if k < 100 { *v } else { v + 1.0 }).collect();
        assert!(of(&t, jump, None).contains("a jump of the position?"));
    }
}
