//! The drives of a robot without its bodies. A diagnosis tests them where motor and joint torque
//! are both measured, so that their difference is the loss of the gears.

use dh_codegen::arm::param::{self, DriveTerm};
use dh_codegen::robot::effects::LoadDependentFriction;
use dh_codegen::robot::{Effect, EffectKind, Robot};

use super::arm::{Arm, BaseParameter, Description, States};
use super::parameter::StandardParameter;
use super::perturbable::{Change, Contact, PerturbableArm};
use super::perturbable_robot::PerturbableRobot;
use super::robot_edit;

/// Rotors, friction and drive laws of a robot file. The standard parameters are those of the whole
/// robot, with zero links; the base parameters are the drives' own.
pub struct DrivesAlone {
    file: Robot,
    whole: PerturbableRobot,
    description: Description,
    /// Joint (from 0), term and index into the standard parameters of each base parameter.
    terms: Vec<(usize, DriveTerm, usize)>,
    given: Vec<f64>,
    /// Laws of the transmitted torque, with their joints (from 0). [`DrivesAlone::whole`] lacks
    /// them, since its load is that of the file's links.
    of_load: Vec<(usize, LoadDependentFriction)>,
}

impl DrivesAlone {
    /// The drives of this robot, with a rotor at every joint.
    pub fn new(robot: &Robot) -> Self {
        let file = robot_edit::with_rotors(robot.clone());
        let moving = file.moving();
        let laws = |(j, row): (usize, &usize)| -> Vec<(usize, LoadDependentFriction)> {
            let of = |effect: &Effect| match effect {
                Effect::LoadDependentFriction(law) => Some((j, *law)),
                _ => None,
            };
            file.joints[*row].drive.effects.iter().filter_map(of).collect()
        };
        let of_load: Vec<_> = moving.iter().enumerate().flat_map(laws).collect();
        let own: Vec<_> = of_load.iter().map(|(j, _)| (EffectKind::LoadDependentFriction, Some(*j))).collect();
        let whole = PerturbableRobot::new(&robot_edit::without(file.clone(), &own));
        let standard = whole.standard_parameters().to_vec();
        let of = |(index, parameter): (usize, &StandardParameter)| {
            let StandardParameter::Drive(row, term) = *parameter else { return None };
            Some((whole.rows().iter().position(|r| *r == row)?, term, index))
        };
        let terms: Vec<(usize, DriveTerm, usize)> = standard.iter().enumerate().filter_map(of).collect();
        let parameters = param::standard(&file);
        let base = |&(_, _, index): &(usize, DriveTerm, usize)| {
            let name = standard[index].to_string();
            let unit = parameters[index].unit(&file).to_string();
            BaseParameter {
                leader: standard[index],
                name: name.clone(),
                grouping: name,
                coefficients: vec![(index, 1.0)],
                unit,
            }
        };
        let mut pattern: Vec<(usize, usize)> = terms.iter().enumerate().map(|(b, (joint, ..))| (*joint, b)).collect();
        pattern.sort_unstable();
        let drive = |index: usize| match standard[index] {
            StandardParameter::Drive(..) => whole.given_drive(index),
            _ => 0.0,
        };
        Self {
            given: (0..standard.len()).map(drive).collect(),
            description: Description {
                name: whole.name().to_string(),
                dof: whole.dof(),
                base: terms.iter().map(base).collect(),
                pattern,
                standard,
            },
            terms,
            whole,
            file,
            of_load,
        }
    }
}

/// Torque per unit of a drive parameter, N m, from a joint's velocity and acceleration.
fn of_one(term: DriveTerm, dq: f64, ddq: f64) -> f64 {
    match term {
        DriveTerm::IA => ddq,
        DriveTerm::FV => dq,
        DriveTerm::FC if dq == 0.0 => 0.0,
        DriveTerm::FC => dq.signum(),
        DriveTerm::FO => 1.0,
    }
}

impl Arm for DrivesAlone {
    fn description(&self) -> &Description {
        &self.description
    }

    fn base_regressor(&self, states: &States, out: &mut [f64]) {
        for (to, &(joint, column)) in out.chunks_exact_mut(states.len.max(1)).zip(self.base_pattern()) {
            let own = joint * states.len..(joint + 1) * states.len;
            let motion = states.dq[own.clone()].iter().zip(&states.ddq[own]);
            to.iter_mut().zip(motion).for_each(|(to, (dq, ddq))| *to = of_one(self.terms[column].1, *dq, *ddq));
        }
    }

    fn inverse_dynamics(&self, states: &States, standard: &[f64], out: &mut [f64]) {
        let base: Vec<f64> = self.terms.iter().map(|(.., index)| standard[*index]).collect();
        self.base_torques(states, &base, out);
    }
}

impl PerturbableArm for DrivesAlone {
    fn rows(&self) -> &[usize] {
        self.whole.rows()
    }

    fn gear_ratios(&self) -> &[Option<f64>] {
        self.whole.gear_ratios()
    }

    fn given(&self) -> Option<&[f64]> {
        Some(&self.given)
    }

    fn given_drive(&self, index: usize) -> f64 {
        self.whole.given_drive(index)
    }

    fn has_bodies(&self) -> bool {
        false
    }

    fn torque_limits(&self) -> Vec<Option<f64>> {
        self.whole.torque_limits()
    }

    fn effects(&self) -> Vec<(EffectKind, Option<usize>)> {
        let own = self.of_load.iter().map(|(j, _)| (EffectKind::LoadDependentFriction, Some(*j)));
        self.whole.effects().into_iter().chain(own).collect()
    }

    fn delays(&self) -> Vec<f64> {
        self.whole.delays()
    }

    fn known(&self, begun: f64, time: &[f64], states: &States, temperature: &[f64], out: &mut [f64]) -> bool {
        self.whole.known(begun, time, states, temperature, out)
    }

    fn add_laws_of_load(&self, states: &States, load: &[f64], out: &mut [f64]) -> bool {
        for (j, law) in self.of_load.iter().filter(|_| !load.is_empty()) {
            let own = j * states.len..(j + 1) * states.len;
            let motion = states.dq[own.clone()].iter().zip(&load[own.clone()]);
            for (out, (dq, load)) in out[own].iter_mut().zip(motion) {
                let factor = if load * dq < 0.0 { law.driven() } else { law.factor() };
                *out += factor * load.abs() * of_one(DriveTerm::FC, *dq, 0.0);
            }
        }
        !self.of_load.is_empty()
    }

    fn settling(&self) -> Vec<f64> {
        self.whole.settling()
    }

    fn without(&self, effects: &[(EffectKind, Option<usize>)]) -> Option<Box<dyn PerturbableArm>> {
        Some(Box::new(Self::new(&robot_edit::without(self.file.clone(), effects))))
    }

    /// Geometry does not affect the drives.
    fn changed_dynamics(&self, _: &Change, states: &States, standard: &[f64], out: &mut [f64]) {
        self.inverse_dynamics(states, standard, out);
    }

    fn wrench_columns(&self, _: &States, _: Contact, out: &mut [f64]) {
        out.fill(0.0);
    }

    fn tool_positions(&self, states: &States, out: &mut [f64]) {
        self.whole.tool_positions(states, out);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dh_codegen::robot::no_files;

    /// Friction follows the measured load, whatever the file's links weigh.
    #[test]
    fn friction_under_the_measured_load() {
        let text = include_str!("../../robots/planar2r.yaml");
        let mut robot = Robot::from_yaml(text, &no_files).unwrap().robot;
        robot.joints[1].drive.effects =
            vec![Effect::LoadDependentFriction(LoadDependentFriction { factor: Some(0.1), driven: Some(0.04) })];
        let drives = DrivesAlone::new(&robot);
        assert_eq!(drives.effects(), [(EffectKind::LoadDependentFriction, Some(1))]);
        let states = States { len: 3, q: vec![0.0; 6], dq: [[9.0; 3], [1.0, -1.0, 0.0]].concat(), ddq: vec![0.0; 6] };
        let mut out = vec![0.0; 6];
        assert!(drives.add_laws_of_load(&states, &[7.0, 7.0, 7.0, 20.0, 20.0, 20.0], &mut out));
        assert_eq!(out, [0.0, 0.0, 0.0, 2.0, -0.8, 0.0]);
        assert!(!drives.known(0.0, &[0.0; 3], &states, &[], &mut out));
    }

    /// Agreement with the whole robot with massless links, which shares nothing but the parameters.
    #[test]
    fn drives_of_a_robot_without_mass() {
        let robot = Robot::from_yaml(include_str!("../../robots/staubli-tx40.yaml"), &no_files).unwrap().robot;
        let robot = robot_edit::with_rotors(robot);
        let drives = DrivesAlone::new(&robot);
        let whole = PerturbableRobot::new(&robot);
        let n = 5 * drives.dof();
        let wave = |k: f64| (0..n).map(|i| k * (0.9 * i as f64 + k).sin()).collect::<Vec<f64>>();
        let states = States { len: 5, q: wave(1.0), dq: wave(0.7), ddq: wave(3.0) };
        let value = |(i, p): (usize, &StandardParameter)| match p {
            StandardParameter::Drive(..) => 1.0 + 0.3 * i as f64,
            _ => 0.0,
        };
        let standard: Vec<f64> = drives.standard_parameters().iter().enumerate().map(value).collect();
        let mut found = [(); 2].map(|()| vec![0.0; n]);
        drives.inverse_dynamics(&states, &standard, &mut found[0]);
        whole.inverse_dynamics(&states, &standard, &mut found[1]);
        assert!(found[0].iter().all(|t| t.abs() > 1e-3));
        assert!(found[0].iter().zip(&found[1]).all(|(a, b)| (a - b).abs() < 1e-10), "{found:?}");
        assert_eq!(drives.base_parameters().len(), 4 * drives.dof());
        assert!(!drives.add_laws_of_load(&states, &wave(2.0), &mut found[0]));
        assert!(!drives.has_bodies() && drives.given().unwrap().iter().all(|v| v.is_finite()));
    }
}
