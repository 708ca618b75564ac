//! [`PerturbableArm`] of a robot: interpreted tapes for the unchanged arm, the numeric recursion
//! for the changed one.

use dh_codegen::arm::Function;
use dh_codegen::arm::param::{self, Parameter};
use dh_codegen::robot::{Angle, Effect, EffectKind, Inertia, Length, Robot};
use nalgebra::Matrix3;

use crate::model::far_end::FarEnd;
use crate::model::file_torque_model::FileTorqueModel;
use crate::model::interpreted::Interpreted;
use crate::model::rigid_body::Numeric;
use crate::model::robot_edit;
use crate::model::walls::Walls;
use crate::model::{Arm, Change, Contact, Description, LikelyBodies, PerturbableArm, States, TorqueModel};

/// A robot with changeable geometry. Encoder zeros, lengths, base and bodies include the effects of
/// its file.
pub struct PerturbableRobot {
    /// The robot as in its file.
    file: Robot,
    /// The robot with the effects of the file on geometry and bodies applied.
    robot: Robot,
    /// Torque models with all effects of the file, and with all but the laws of its drives; `None`
    /// without such effects.
    known: Option<(FileTorqueModel, FileTorqueModel)>,
    delays: Vec<f64>,
    arm: Interpreted,
    numeric: Numeric,
    far_ends: Vec<FarEnd>,
    rows: Vec<usize>,
    gears: Vec<Option<f64>>,
    given: Option<Vec<f64>>,
}

impl PerturbableRobot {
    /// The perturbable arm of this robot.
    pub fn new(robot: &Robot) -> Self {
        let rows = robot.moving();
        let file = robot.clone();
        let robot = if file.has_effects() { file.effective() } else { file.clone() };
        Self {
            arm: Interpreted::new(&robot, &[Function::InverseDynamicsBase]),
            numeric: Numeric::new(&robot),
            far_ends: (0..robot.joints.len()).map(|row| FarEnd::of(&robot, row)).collect(),
            gears: rows.iter().map(|&row| robot.joints[row].drive.gear_ratio).collect(),
            given: param::standard_values(&robot),
            known: if file.has_effects() || Walls::of(&file).is_some() { laws(&file, &robot) } else { None },
            delays: file.laws().iter().map(|l| l.delay).collect(),
            robot,
            file,
            rows,
        }
    }
}

/// Torque models of a file and of the arm without its drives' laws, both with the same delays.
fn laws(file: &Robot, real: &Robot) -> Option<(FileTorqueModel, FileTorqueModel)> {
    let late = |e: &Effect| e.kind() == EffectKind::TimeDelay;
    let mut plain = real.clone();
    plain.effects.retain(late);
    for joint in &mut plain.joints {
        joint.drive.effects.retain(late);
        joint.drive.law = None;
    }
    let mut file = file.clone();
    if real.links.is_empty() {
        // Without links the laws act on drives without load.
        for robot in [&mut file, &mut plain] {
            robot.links = vec![Some(Inertia::from_array([0.0; 10])); robot.joints.len()];
        }
    }
    Some((FileTorqueModel::new(&file).ok()?.among_walls(&file), FileTorqueModel::new(&plain).ok()?))
}

/// The robot with a change applied.
fn changed(robot: &Robot, change: &Change) -> Robot {
    let mut robot = robot.clone();
    match *change {
        Change::Base { roll, pitch } => {
            // Gravity in the axes of the turned base: (RotY(pitch) RotX(roll))' g.
            let [x, y, z] = robot.gravity;
            let ((sp, cp), (sr, cr)) = (pitch.sin_cos(), roll.sin_cos());
            let [x, z] = [cp * x - sp * z, sp * x + cp * z];
            robot.gravity = [x, cr * y + sr * z, cr * z - sr * y];
        }
        Change::Row { row, alpha, d, theta, r } => {
            let joint = &mut robot.joints[row];
            let turned =
                |angle: &Angle, by: f64| if by == 0.0 { angle.clone() } else { Angle::radians(angle.value + by) };
            let longer = |length: &Length, by: f64| Length::meters(length.value + by);
            (joint.alpha, joint.theta) = (turned(&joint.alpha, alpha), turned(&joint.theta, theta));
            (joint.d, joint.r) = (longer(&joint.d, d), longer(&joint.r, r));
        }
    }
    robot
}

/// Calls `f` with the index and motion of each sample of `states`.
fn each(states: &States, dof: usize, mut f: impl FnMut(usize, &[f64], &[f64], &[f64])) {
    let (mut q, mut dq, mut ddq) = (vec![0.0; dof], vec![0.0; dof], vec![0.0; dof]);
    for s in 0..states.len {
        for j in 0..dof {
            let at = j * states.len + s;
            (q[j], dq[j], ddq[j]) = (states.q[at], states.dq[at], states.ddq[at]);
        }
        f(s, &q, &dq, &ddq);
    }
}

impl PerturbableArm for PerturbableRobot {
    fn rows(&self) -> &[usize] {
        &self.rows
    }

    fn gear_ratios(&self) -> &[Option<f64>] {
        &self.gears
    }

    fn given(&self) -> Option<&[f64]> {
        self.given.as_deref()
    }

    fn given_drive(&self, index: usize) -> f64 {
        match param::standard(&self.robot).get(index) {
            Some(Parameter::Drive(row, term)) => param::drive_value(&self.robot, *row, *term).unwrap_or(0.0),
            _ => 0.0,
        }
    }

    fn torque_limits(&self) -> Vec<Option<f64>> {
        self.rows.iter().map(|&row| self.file.joints[row].limits.torque).collect()
    }

    fn with_rotors(&self) -> Option<Box<dyn PerturbableArm>> {
        let robot = robot_edit::with_rotors(self.file.clone());
        (robot != self.file).then(|| Box::new(Self::new(&robot)) as Box<dyn PerturbableArm>)
    }

    fn effects(&self) -> Vec<(EffectKind, Option<usize>)> {
        let dof = |row: usize| self.rows.iter().position(|r| *r == row);
        let own =
            self.file.joints.iter().enumerate().flat_map(|(row, joint)| {
                joint.drive.effects.iter().filter_map(move |e| Some((e.kind(), Some(dof(row)?))))
            });
        own.chain(self.file.effects.iter().map(|e| (e.kind(), None))).collect()
    }

    fn delays(&self) -> Vec<f64> {
        self.delays.clone()
    }

    fn known(&self, begun: f64, time: &[f64], states: &States, temperature: &[f64], out: &mut [f64]) -> bool {
        let Some((whole, plain)) = &self.known else { return false };
        let mut rest = vec![0.0; out.len()];
        whole.torques_since(begun, time, states, temperature, out);
        plain.torques_since(begun, time, states, temperature, &mut rest);
        out.iter_mut().zip(&rest).for_each(|(out, rest)| *out -= rest);
        true
    }

    fn settling(&self) -> Vec<f64> {
        self.file.laws().iter().map(|l| l.hysteresis.map_or(0.0, |law| 4.0 * law.travel().abs())).collect()
    }

    fn bodies(&self) -> Option<LikelyBodies> {
        Some(LikelyBodies {
            prior: robot_edit::prior(&self.robot, &self.arm),
            carried: robot_edit::carried(&self.robot),
        })
    }

    fn without(&self, effects: &[(EffectKind, Option<usize>)]) -> Option<Box<dyn PerturbableArm>> {
        Some(Box::new(Self::new(&robot_edit::without(self.file.clone(), effects))))
    }

    fn changed_dynamics(&self, change: &Change, states: &States, standard: &[f64], out: &mut [f64]) {
        let numeric = Numeric::new(&changed(&self.robot, change));
        let (mut work, mut tau) = (numeric.workspace(), vec![0.0; self.dof()]);
        each(states, self.dof(), |s, q, dq, ddq| {
            numeric.inverse_dynamics_into(&mut work, q, dq, ddq, standard, &mut tau);
            tau.iter().enumerate().for_each(|(j, t)| out[j * states.len + s] = *t);
        });
    }

    fn wrench_columns(&self, states: &States, contact: Contact, out: &mut [f64]) {
        let dof = self.dof();
        let end = contact.link.map(|row| self.far_ends[row]);
        each(states, dof, |s, q, _, _| {
            let (pose, jacobian) = match end {
                Some(FarEnd { row, point }) => self.numeric.point_and_jacobian(q, row, point),
                None => self.numeric.tool_and_jacobian(q),
            };
            let turn = if contact.in_base { Matrix3::identity() } else { pose.fixed_view::<3, 3>(0, 0).transpose() };
            for j in 0..dof {
                let force = turn * jacobian.fixed_view::<3, 1>(0, j);
                let moment = turn * jacobian.fixed_view::<3, 1>(3, j);
                for c in 0..3 {
                    out[(c * dof + j) * states.len + s] = force[c];
                    out[((c + 3) * dof + j) * states.len + s] = moment[c];
                }
            }
        });
    }

    fn tool_positions(&self, states: &States, out: &mut [f64]) {
        each(states, self.dof(), |s, q, _, _| {
            let frame = self.numeric.tool(q);
            (0..3).for_each(|c| out[c * states.len + s] = frame[(c, 3)]);
        });
    }
}

impl Arm for PerturbableRobot {
    fn description(&self) -> &Description {
        self.arm.description()
    }

    fn base_regressor(&self, states: &States, out: &mut [f64]) {
        self.arm.base_regressor(states, out);
    }

    fn base_torques(&self, states: &States, base: &[f64], out: &mut [f64]) {
        self.arm.run(Function::InverseDynamicsBase, states, &[], base, out);
    }

    fn inverse_dynamics(&self, states: &States, standard: &[f64], out: &mut [f64]) {
        self.arm.inverse_dynamics(states, standard, out);
    }
}

#[cfg(test)]
mod tests {
    use dh_codegen::robot::no_files;

    use super::*;

    fn swinging() -> (PerturbableRobot, States, Vec<f64>) {
        let robot = Robot::from_yaml(include_str!("../../robots/kuka-lwr4.yaml"), &no_files).unwrap().robot;
        let plant = PerturbableRobot::new(&robot);
        let wave = |k: f64| (0..21).map(|i| k * (0.7 * f64::from(i) + 0.3 * k).sin()).collect::<Vec<f64>>();
        let states = States { len: 3, q: wave(1.0), dq: wave(0.6), ddq: wave(2.0) };
        let given = plant.given().unwrap().to_vec();
        (plant, states, given)
    }

    /// A base that is pitched forward is on a slope: its weight pulls along its own x axis.
    #[test]
    fn gravity_is_seen_from_the_turned_base() {
        let robot = Robot::from_yaml(include_str!("../../robots/kuka-lwr4.yaml"), &no_files).unwrap().robot;
        let g = robot.gravity[2];
        let [x, y, z] = changed(&robot, &Change::Base { roll: 0.0, pitch: 0.3 }).gravity;
        assert!(g < -9.0 && (x + g * 0.3_f64.sin()).abs() < 1e-12 && y.abs() < 1e-12, "{x} {y}");
        assert!((z - g * 0.3_f64.cos()).abs() < 1e-12, "{z}");
        let [x, y, z] = changed(&robot, &Change::Base { roll: 0.3, pitch: 0.0 }).gravity;
        assert!(x.abs() < 1e-12 && (y - g * 0.3_f64.sin()).abs() < 1e-12 && (z - g * 0.3_f64.cos()).abs() < 1e-12);
    }

    #[test]
    fn no_change_is_the_arm_itself() {
        let (plant, states, given) = swinging();
        let (mut plain, mut changed) = (vec![0.0; 21], vec![0.0; 21]);
        plant.inverse_dynamics(&states, &given, &mut plain);
        let nothing = Change::Row { row: 2, alpha: 0.0, d: 0.0, theta: 0.0, r: 0.0 };
        for change in [nothing, Change::Base { roll: 0.0, pitch: 0.0 }] {
            plant.changed_dynamics(&change, &states, &given, &mut changed);
            assert!(plain.iter().zip(&changed).all(|(a, b)| (a - b).abs() < 1e-10));
        }
    }

    /// The tape of the torques against the sum over the regressor's entries, and both against the
    /// torques from standard parameters.
    #[test]
    fn torques_of_base_parameters() {
        struct Plain<'a>(&'a PerturbableRobot);
        impl Arm for Plain<'_> {
            fn description(&self) -> &Description {
                self.0.description()
            }
            fn base_regressor(&self, states: &States, out: &mut [f64]) {
                self.0.base_regressor(states, out);
            }
            fn inverse_dynamics(&self, states: &States, standard: &[f64], out: &mut [f64]) {
                self.0.inverse_dynamics(states, standard, out);
            }
        }
        let (plant, states, given) = swinging();
        let of = |b: &crate::model::BaseParameter| b.coefficients.iter().map(|(i, k)| k * given[*i]).sum();
        let base: Vec<f64> = plant.base_parameters().iter().map(of).collect();
        let mut found = [(); 3].map(|()| vec![0.0; 21]);
        plant.base_torques(&states, &base, &mut found[0]);
        Plain(&plant).base_torques(&states, &base, &mut found[1]);
        plant.inverse_dynamics(&states, &given, &mut found[2]);
        for other in &found[1..] {
            assert!(found[0].iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-10), "{found:?}");
        }
    }

    #[test]
    fn a_turned_row_is_a_shifted_joint() {
        let (plant, states, given) = swinging();
        let (mut one, mut other) = (vec![0.0; 21], vec![0.0; 21]);
        plant.changed_dynamics(
            &Change::Row { row: 3, alpha: 0.0, d: 0.0, theta: 0.2, r: 0.0 },
            &states,
            &given,
            &mut one,
        );
        let mut shifted = states.clone();
        shifted.q[9..12].iter_mut().for_each(|q| *q += 0.2);
        plant.inverse_dynamics(&shifted, &given, &mut other);
        assert!(one.iter().zip(&other).all(|(a, b)| (a - b).abs() < 1e-10));
    }

    /// The torques of a wall of the file are known: the derivatives of its energy.
    #[test]
    fn a_wall_of_the_file_is_known() {
        let wall = "effects: { external_contact: { k: 300, nx: 0.6, ny: 0.8, at: 0.2 } }";
        let text = format!("{}\n{wall}\n", include_str!("../../robots/planar2r.yaml"));
        let plant = PerturbableRobot::new(&Robot::from_yaml(&text, &no_files).unwrap().robot);
        let depth = |q1: f64, q2: f64| {
            let [x, y] = [0.5 * q1.cos() + 0.4 * (q1 + q2).cos(), 0.5 * q1.sin() + 0.4 * (q1 + q2).sin()];
            (0.2 - 0.6 * x - 0.8 * y).max(0.0)
        };
        let energy = |q1: f64, q2: f64| 150.0 * depth(q1, q2).powi(2);
        let (q1, q2): (Vec<f64>, Vec<f64>) = (0..9).map(|k| (0.7 * f64::from(k), 0.9 - 0.3 * f64::from(k))).unzip();
        let time: Vec<f64> = (0..9).map(|k| 0.01 * f64::from(k)).collect();
        let states = States { len: 9, q: [q1.clone(), q2.clone()].concat(), dq: vec![0.0; 18], ddq: vec![0.0; 18] };
        let mut out = vec![0.0; 18];
        assert!(plant.known(0.0, &time, &states, &[], &mut out));
        let mut behind = 0;
        for (s, (q1, q2)) in q1.into_iter().zip(q2).enumerate() {
            behind += usize::from(depth(q1, q2) > 0.0);
            let slopes = [energy(q1 + 1e-6, q2) - energy(q1 - 1e-6, q2), energy(q1, q2 + 1e-6) - energy(q1, q2 - 1e-6)];
            for (j, slope) in slopes.into_iter().enumerate() {
                assert!((out[j * 9 + s] - slope / 2e-6).abs() < 1e-6, "{j} {s}: {} {slope}", out[j * 9 + s]);
            }
        }
        assert!(behind > 1 && behind < 8, "{behind}");
    }

    #[test]
    fn the_power_of_a_wrench() {
        let (plant, states, _) = swinging();
        let mut columns = vec![0.0; 6 * 21];
        plant.wrench_columns(&states, Contact { link: None, in_base: false }, &mut columns);
        // The last joint carries a moment about its axis completely.
        assert!((0..3).all(|s| (columns[(5 * 7 + 6) * 3 + s] - 1.0).abs() < 1e-12));
        // In the base's axes the columns of a force are the derivatives of the position.
        plant.wrench_columns(&states, Contact { link: None, in_base: true }, &mut columns);
        let at = |by: f64| {
            let mut turned = states.clone();
            turned.q[3 * 3..4 * 3].iter_mut().for_each(|q| *q += by);
            let mut found = vec![0.0; 9];
            plant.tool_positions(&turned, &mut found);
            found
        };
        for (k, (after, before)) in at(1e-6).iter().zip(at(-1e-6)).enumerate() {
            let slope = (after - before) / 2e-6;
            assert!((slope - columns[(k / 3 * 7 + 3) * 3 + k % 3]).abs() < 1e-8);
        }
        // A force on link 3 acts at the elbow, with the same lever in any axes.
        let on_link = |in_base: bool| {
            let mut columns = vec![0.0; 6 * 21];
            plant.wrench_columns(&states, Contact { link: Some(2), in_base }, &mut columns);
            columns
        };
        let [link, base] = [false, true].map(on_link);
        let size = |columns: &[f64], j: usize, s: usize| {
            (0..3).map(|c| columns[(c * 7 + j) * 3 + s].powi(2)).sum::<f64>().sqrt()
        };
        for (j, s) in (0..7).flat_map(|j| (0..3).map(move |s| (j, s))) {
            assert!((size(&link, j, s) - size(&base, j, s)).abs() < 1e-12);
            // The elbow lies on the axis of joint 3.
            assert!(j < 2 || size(&link, j, s) < 1e-12, "{j} {s}");
            assert!(j != 1 || size(&link, j, s) > 0.1, "{s}");
        }
    }
}
