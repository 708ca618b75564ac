//! Checks plans against the numeric recursion, which shares no code with the planner.

use dh_codegen::arm::param;
use dh_codegen::robot::{JointKind, Robot, Tool, no_files};
use nalgebra::{Vector3, Vector6};

use super::plan::stretched;
use super::*;
use crate::model::interpreted::Interpreted;
use crate::model::inverse_kinematics::Kinematics;
use crate::model::rigid_body::Numeric;
use crate::numerics::prng::Random;

fn robot(name: &str, tool: &str) -> Robot {
    let read = |path: String| std::fs::read_to_string(format!("{}/robots/{path}", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let mut robot = Robot::from_yaml(&read(format!("{name}.yaml")), &no_files).unwrap().robot;
    robot.tool = Some(Tool::from_yaml(&read(format!("tools/{tool}.yaml")), tool).unwrap().0);
    robot
}

struct Ready {
    robot: Robot,
    arm: Interpreted,
    inverse: Kinematics,
}

impl Ready {
    fn new(name: &str, tool: &str) -> Self {
        Self::of(robot(name, tool))
    }

    fn of(robot: Robot) -> Self {
        let arm = Interpreted::new(&robot, &Interpreted::PLACED);
        let inverse = Kinematics::new(&robot, arm.model()).unwrap();
        Self { robot, arm, inverse }
    }

    fn task(&self, center: [f64; 3], normal: [f64; 3], width: f64, height: f64) -> Task<'_> {
        let geometry = self.robot.tool.as_ref().unwrap().geometry.unwrap();
        let surface = Surface::new(center, normal, [0.0, 0.0, 1.0], width, height).unwrap();
        let roller = Roller { length: geometry.length, width: geometry.width, turned: false };
        let mut task = Task::new(&self.arm, &self.inverse, &self.robot, surface, roller, 0.5).unwrap();
        task.distance_margin = 0.005;
        task
    }
}

fn quiet(_: &'static str, _: f64) {}

/// Checks all properties of a plan by forward kinematics, Jacobian and torques of the numeric
/// recursion, also between the knots.
fn judge(ready: &Ready, task: &Task<'_>, plan: &Plan) {
    let numeric = Numeric::new(&ready.robot);
    let phi = param::standard_values(&ready.robot).unwrap();
    let n = plan.motion.dof();
    let (count, end) = (1500, plan.duration());
    let normal = Vector3::from(plan.surface.normal);
    let level = normal.dot(&Vector3::from(plan.surface.center));
    let mut jerk = 0.0;
    // Cells of the wall that the line of contact sweeps, by forward kinematics alone, without lanes
    // or legs.
    let cells = 60;
    let mut painted = vec![false; cells * cells];
    let ([left, _], [low, _]) = (plan.surface.sides(), plan.surface.ends());
    let (across, up) = (Vector3::from(plan.surface.across()), Vector3::from(plan.surface.up));
    let mut last: Option<[f64; 2]> = None;
    for k in 0..=count {
        let t = end * k as f64 / count as f64;
        let m = plan.at(t);
        let pose = numeric.tool(&m.q);
        let (axis, origin) = (pose.fixed_view::<3, 1>(0, 2).into_owned(), pose.fixed_view::<3, 1>(0, 3).into_owned());
        let face = origin + plan.roller.length * axis;
        assert!((axis + normal).norm() < 1e-9, "{t}: perpendicular to {:e}", (axis + normal).norm());
        assert!(
            pose.fixed_view::<3, 1>(0, 0).dot(&normal).abs() < 1e-9
                && pose.fixed_view::<3, 1>(0, 0).dot(&up).abs() < 1e-9
        );
        assert!((face - Vector3::from(m.point)).norm() < 1e-9, "{t}: {:e}", (face - Vector3::from(m.point)).norm());
        for i in 0..3 {
            for c in 0..4 {
                assert!((pose[(i, c)] - m.pose[4 * i + c]).abs() < 1e-9);
            }
        }
        let place = [face.dot(&across), face.dot(&up)];
        if m.phase.contact() {
            assert!((face.dot(&normal) - level).abs() < 1e-9, "{t}: off the wall by {:e}", face.dot(&normal) - level);
            let from = last.unwrap_or(place);
            for (i, cell) in painted.iter_mut().enumerate() {
                let y = left + ((i % cells) as f64 + 0.5) * plan.surface.width / cells as f64;
                let z = low + ((i / cells) as f64 + 0.5) * plan.surface.height / cells as f64;
                let within = (y - place[0]).abs() <= 0.5 * plan.roller.width + 1e-9;
                *cell |= within && z >= from[1].min(place[1]) - 1e-9 && z <= from[1].max(place[1]) + 1e-9;
            }
            last = Some(place);
        } else {
            assert!(face.dot(&normal) - level >= -1e-9);
        }
        // Speeds and accelerations: of the joints by differences, of the tool by the Jacobian.
        let h = 1e-5;
        if t > h && t < end - h {
            let (a, b) = (plan.at(t - h), plan.at(t + h));
            for j in 0..n {
                assert!(((b.q[j] - a.q[j]) / (2.0 * h) - m.dq[j]).abs() < 1e-5 * (1.0 + m.dq[j].abs()));
                assert!(((b.dq[j] - a.dq[j]) / (2.0 * h) - m.ddq[j]).abs() < 1e-4 * (1.0 + m.ddq[j].abs()));
            }
        }
        let jacobian = numeric.jacobian(&m.q);
        let twist: Vector6<f64> = &jacobian * nalgebra::DVector::from_column_slice(&m.dq);
        assert!(twist.fixed_rows::<3>(3).norm() < 1e-6, "the roller turns");
        assert!((twist.fixed_rows::<3>(0) - Vector3::from(m.velocity)).norm() < 1e-6 * (1.0 + end));
        // Limits; the torque includes the wall's contact force at the face.
        let mut torque = numeric.inverse_dynamics(&m.q, &m.dq, &m.ddq, &phi);
        if m.phase.contact() {
            let lever = face - numeric.frames(&m.q).last().unwrap().fixed_view::<3, 1>(0, 3);
            let force = task.force * normal;
            let moment = lever.cross(&force);
            torque -= jacobian.transpose() * Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z);
            let dddq = plan.motion.at(t).dddq;
            jerk += dddq.iter().map(|b| b * b).sum::<f64>() * end / count as f64;
        }
        for j in 0..n {
            let l = &task.limits[j];
            assert!(m.q[j] >= l.position[0] && m.q[j] <= l.position[1], "{t}: {} at {}", l.name, m.q[j]);
            assert!(m.dq[j].abs() <= l.velocity * task.share * 1.0001, "{t}: speed of {}", l.name);
            assert!(m.ddq[j].abs() <= l.acceleration * task.share * 1.001, "{t}: acceleration of {}", l.name);
            assert!(torque[j].abs() <= l.torque.unwrap_or(f64::INFINITY), "{t}: torque of {}: {}", l.name, torque[j]);
        }
    }
    // Way points are passed at rest.
    for span in &plan.spans {
        let m = plan.at(span.time[0]);
        assert!(m.dq.iter().chain(&m.ddq).all(|x| x.abs() < 1e-9));
    }
    assert!((jerk / plan.jerk - 1.0).abs() < 0.02, "{jerk} {}", plan.jerk);
    let contact: f64 = plan.spans.iter().filter(|s| s.phase.contact()).map(|s| s.time[1] - s.time[0]).sum();
    assert!((contact - plan.contact).abs() < 1e-9 * contact);
    let cost = plan.contact + task.weights.jerk * plan.jerk + task.weights.area / task.area(&plan.strokes);
    assert!((cost / plan.cost - 1.0).abs() < 1e-9);
    assert!(plan.strokes.step.abs() <= plan.roller.width + 1e-12);
    let share = painted.iter().filter(|p| **p).count() as f64 / painted.len() as f64;
    assert!((share - plan.coverage().painted).abs() < 0.025, "{share} {}", plan.coverage().painted);
    if task.cover == Cover::Whole {
        assert!(share == 1.0 && plan.coverage().painted == 1.0, "{share}");
    }
}

#[test]
fn a_whole_wall_by_the_lwr() {
    let ready = Ready::new("kuka-lwr4", "large-roller");
    let mut task = ready.task([-0.85, 0.25, 0.5], [1.0, 0.0, 0.0], 0.4, 0.4);
    task.cover = Cover::Whole;
    let found = plan(&task, &quiet).unwrap();
    assert!(found.sides.is_empty());
    assert!(found.cost <= found.cost_constant.unwrap() * (1.0 + 1e-9));
    judge(&ready, &task, &found);
    // A written plan is read back unchanged.
    let text = crate::report::plan_json(&found).to_string();
    let again = crate::report::plan_of_json(&serde_json::from_str(&text).unwrap()).unwrap();
    for t in [-1.0, 0.0, 0.37, 5.0, 1e9, f64::NAN] {
        let (a, b) = (found.at(t), again.at(t));
        assert!(a.q.iter().zip(&b.q).all(|(a, b)| (a - b).abs() < 1e-12) && a.phase == b.phase, "{t}");
    }
    // A repetition gives the same plan, bit by bit.
    assert_eq!(plan(&task, &quiet).unwrap(), found);

    // One swivel angle and a given duration: longer legs, duration kept, less jerk.
    task.swivel = Swivel::Constant;
    task.duration = Some(2.0 * found.contact);
    let slow = plan(&task, &quiet).unwrap();
    assert!((slow.contact - 2.0 * found.contact).abs() < 1e-9 && slow.jerk < 0.1 * found.jerk);
    let angles: Vec<f64> = slow.spans.iter().flat_map(|s| [s.from[3], s.to[3]]).collect();
    assert!(angles.iter().all(|a| *a == angles[0]));
    judge(&ready, &task, &slow);

    // Too short a duration: the message gives the missing time.
    task.duration = Some(1.0);
    let why = plan(&task, &quiet).unwrap_err().to_string();
    assert!(why.contains("s more than the 1 s"), "{why}");
    // With zero weight on the jerk the limits decide.
    (task.duration, task.weights.jerk) = (None, 0.0);
    let fast = plan(&task, &quiet).unwrap();
    assert!(fast.contact < found.contact);
    assert!(fast.spans.iter().all(|s| !s.phase.contact() || s.bound.contains(" of A")), "{:?}", fast.spans);
    judge(&ready, &task, &fast);
}

#[test]
fn what_is_out_of_reach_is_said_in_figures() {
    let ready = Ready::new("kuka-lwr4", "large-roller");
    let mut task = ready.task([-0.8, 0.3, 0.4], [1.0, 0.0, 0.0], 0.6, 0.8);
    task.cover = Cover::Whole;
    // Shoulder at z 0.3105, links of 0.4 and 0.39 m, wrist 0.428 m before the wall: the end of the
    // upper right lane is farther than 0.79 m.
    let wrist = ((0.8f64 - 0.428).powi(2) + 0.5f64.powi(2) + (0.8f64 - 0.3105).powi(2)).sqrt();
    let why = plan(&task, &quiet).unwrap_err().to_string();
    assert!(wrist > 0.79 && why.contains("out of reach by") && why.contains("y 0.500, z 0.800"), "{wrist} {why}");
    task.lanes = 2;
    let why = plan(&task, &quiet).unwrap_err().to_string();
    assert!(why.contains("0.2000 m of the wall's width") && why.contains("3 lanes are needed"), "{why}");
}

#[test]
fn a_wall_beyond_the_stretched_arm_is_refused_before_the_search() {
    let ready = Ready::new("kuka-lwr4", "large-roller");
    let task = ready.task([-3.0, 0.0, 0.4], [1.0, 0.0, 0.0], 0.6, 0.8);
    let why = plan(&task, &|_, _| panic!("a search")).unwrap_err().to_string();
    assert!(why.starts_with("out of reach by") && why.contains("stretched"), "{why}");
}

/// No posture brings the tool farther than the stretched arm; some come near.
#[test]
fn no_posture_is_longer_than_the_stretched_arm() {
    let mut random = Random::new(3);
    for name in ["kuka-lwr4", "ur10e", "franka-panda", "stanford"] {
        let mut robot = robot(name, "large-roller");
        if name == "stanford" {
            // Its joint 3 slides. Its file has no limits.
            robot.joints.iter_mut().for_each(|joint| {
                let slides = joint.kind == JointKind::Prismatic;
                joint.limits.position = Some(if slides { [-0.4, 0.8] } else { [-3.0, 3.0] });
                joint.limits.velocity = Some(1.0);
            });
        }
        let ready = Ready::of(robot);
        let task = ready.task([-3.0, 0.0, 0.4], [1.0, 0.0, 0.0], 0.6, 0.8);
        let (pivot, length) = stretched(&task);
        let numeric = Numeric::new(&ready.robot);
        let farthest = (0..2000).map(|_| {
            let q: Vec<f64> = task.limits.iter().map(|l| random.uniform(l.position[0], l.position[1])).collect();
            let tool = numeric.tool(&q).fixed_view::<3, 1>(0, 3).into_owned();
            (tool - Vector3::from(pivot)).norm()
        });
        let farthest = farthest.fold(0.0, f64::max);
        assert!(farthest <= length && farthest > 0.6 * length, "{name}: {farthest} {length}");
    }
}

#[test]
fn other_arms_and_other_walls() {
    for (name, tool, center, normal, width, height) in [
        ("ur10e", "small-roller", [0.9, 0.2, 0.6], [-1.0, 0.0, 0.0], 0.3, 0.5),
        ("kuka-iiwa14", "large-roller", [0.1, 0.95, 0.5], [0.0, -1.0, 0.0], 0.4, 0.4),
        ("franka-panda", "small-roller", [0.8, 0.0, 0.5], [-1.0, 0.2, 0.1], 0.2, 0.25),
    ] {
        let ready = Ready::new(name, tool);
        let mut task = ready.task(center, normal, width, height);
        // The search of the spline is covered by the LWR's test.
        task.swivel = Swivel::Constant;
        if name == "franka-panda" {
            (task.cover, task.lanes) = (Cover::Whole, 2);
        }
        let found = plan(&task, &quiet).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert!(found.coverage().painted > 0.3, "{name}: {:?}", found.sides);
        judge(&ready, &task, &found);
    }
}
