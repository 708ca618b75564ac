//! From a robot and its effects to what is simulated: bodies as they truly are, and a drive for
//! each joint.

use std::ops::Range;

use dh_codegen::arm::param::{self, Parameter};
use dh_codegen::robot::effect::Law;
use dh_codegen::robot::{Effect, Effects, NoLink, Robot};

use super::SimulateError;
use super::drive::Drive;
use super::effects::{
    AsymmetricFriction, Backlash, ExternalContact, FrictionDrift, GearCoupling, Given, JointElasticity, JointSpring,
    LoadDependentFriction, NonlinearViscousFriction, PositionDependentFriction, PreslidingHysteresis, StribeckFriction,
    TorqueRipple,
};
use crate::model::interpreted::Interpreted;
use crate::model::{Arm, Dynamics};
use crate::numerics::cholesky;

/// Rotor of a soft joint whose file gives none, kg m^2 per N m of torque limit: see `rotor_inertia`
/// in the table of effects.
const ROTOR: f64 = 0.003;

/// The robot as it is, and as its file says.
pub(super) struct SimulatedRobot {
    /// As the file says: what the controller knows.
    pub given: Interpreted,
    pub given_standard: Vec<f64>,
    /// As it is; `None` where only parameters differ.
    real: Option<Interpreted>,
    /// Links as they are, drives zero.
    pub bodies_standard: Vec<f64>,
    /// One for each degree of freedom.
    pub drives: Vec<Drive>,
    couplings: Vec<(usize, usize, Effect)>,
    contacts: Vec<Effect>,
    /// Drives whose saturation is a part of the peak torque.
    saturates: Vec<usize>,
}

/// Motion-dependent defaults, once the motion is known.
pub(super) struct Settled {
    pub drives: Vec<Drive>,
    pub couplings: Vec<GearCoupling>,
    pub contacts: Vec<ExternalContact>,
}

impl SimulatedRobot {
    pub fn new(robot: &Robot, more: &Effects) -> Result<Self, SimulateError> {
        let given_standard = param::standard_values(robot).ok_or(SimulateError::NoLinks {
            robot: robot.name.clone(),
            missing: robot.links.iter().position(Option::is_none).filter(|_| !robot.links.is_empty()),
        })?;
        let own = robot.all_effects();
        let everywhere = own.robot.iter().chain(&more.robot);
        everywhere.clone().try_for_each(|effect| in_range(effect, None))?;
        for contact in everywhere.clone().filter(|e| e.name == "external_contact") {
            let given = Given::new(contact, None);
            if let (Some(start), Some(end)) = (given.stated("start"), given.stated("end"))
                && end <= start
            {
                let (what, must) = ("external_contact.end", "be later than start");
                return Err(SimulateError::Setting { what, value: end, must });
            }
        }
        let of_joints: Vec<(usize, &Effect)> = own
            .joints
            .iter()
            .map(|(row, e)| (*row, e))
            // What stands at the top means every joint.
            .chain(
                everywhere
                    .clone()
                    .filter(|e| is_for_every_joint(e))
                    .flat_map(|e| (0..robot.joints.len()).map(move |row| (row, e))),
            )
            .chain(more.joints.iter().map(|(row, e)| (*row, e)))
            .collect();

        let real_robot = as_it_is(robot, &of_joints, everywhere.clone())?;
        let differs = real_robot.gravity != robot.gravity || real_robot.joints != robot.joints;
        let given = Interpreted::new(robot, &Interpreted::BODIES);
        let real = differs.then(|| Interpreted::new(&real_robot, &Interpreted::BODIES));
        let standard = param::standard_values(&real_robot).unwrap_or_else(|| given_standard.clone());
        let bodies_standard = links_only(robot, &standard);

        let moving = robot.moving();
        let dof_of = |row: usize| moving.iter().position(|&r| r == row);
        let mut built = Self {
            given,
            given_standard,
            real,
            bodies_standard,
            drives: moving.iter().map(|&row| plain_drive(robot, row)).collect(),
            couplings: Vec::new(),
            contacts: everywhere.filter(|e| e.name == "external_contact").cloned().collect(),
            saturates: Vec::new(),
        };
        // Plain friction first: a Stribeck law is told the Coulomb level.
        for plain in [true, false] {
            for &(row, effect) in &of_joints {
                let Some(dof) = dof_of(row) else { continue };
                if PLAIN.contains(&effect.name.as_str()) == plain {
                    built.take(robot, row, dof, effect, &dof_of)?;
                }
            }
        }
        for drive in built.drives.iter_mut().filter(|d| d.is_soft() && d.rotor == 0.0) {
            drive.rotor = ROTOR * drive.rated;
        }
        Ok(built)
    }

    /// The arm as it is.
    pub fn real(&self) -> &Interpreted {
        self.real.as_ref().unwrap_or(&self.given)
    }

    /// One effect of one joint.
    fn take(
        &mut self,
        robot: &Robot,
        row: usize,
        dof: usize,
        effect: &Effect,
        dof_of: &dyn Fn(usize) -> Option<usize>,
    ) -> Result<(), SimulateError> {
        let joint = &robot.joints[row];
        let given = Given::new(effect, joint.limits.torque);
        let drive = &mut self.drives[dof];
        in_range(effect, Some(row))?;
        let wrong = |key: &str, value: f64, must: &str| SimulateError::Effect {
            effect: effect.name.clone(),
            joint: Some(row + 1),
            key: key.to_string(),
            value,
            must: must.to_string(),
        };
        let not_negative = |key: &str, value: f64| {
            if value >= 0.0 { Ok(value) } else { Err(wrong(key, value, "not be negative")) }
        };
        match effect.name.as_str() {
            // They add to the file's: what must not be negative is the sum, lest friction drives
            // the arm.
            "viscous_friction" => {
                drive.plain.viscous += given.get("FV");
                not_negative("FV, the file's included,", drive.plain.viscous)?;
            }
            "coulomb_friction" => {
                drive.plain.level += given.get("FC");
                not_negative("FC, the file's included,", drive.plain.level)?;
            }
            "rotor_inertia" => drive.rotor += not_negative("IA", given.get("IA"))?,
            "asymmetric_friction" => drive.asymmetric = Some(AsymmetricFriction::read(&given)),
            "stribeck_friction" => {
                let law = StribeckFriction::read(&given, drive.plain.level);
                not_negative("FS", law.breakaway)?;
                drive.stribeck = Some(law);
            }
            "nonlinear_viscous_friction" => drive.nonlinear = Some(NonlinearViscousFriction::read(&given)),
            "load_dependent_friction" => drive.load = Some(LoadDependentFriction::read(&given)),
            "presliding_hysteresis" => drive.hysteresis = Some(PreslidingHysteresis::read(&given)),
            "friction_drift" => drive.drift = Some(FrictionDrift::read(&given)),
            "position_dependent_friction" => drive.position = Some(PositionDependentFriction::read(&given)),
            "torque_ripple" => drive.ripple.push(TorqueRipple::read(&given, joint.drive.gear_ratio)),
            "joint_elasticity" => drive.elasticity = Some(JointElasticity::read(&given)),
            "backlash" => drive.backlash = Some(Backlash::read(&given)),
            "gear_coupling" => {
                let number = given.stated("joint").unwrap_or(0.0);
                let other = (number as usize).checked_sub(1).and_then(dof_of).filter(|&k| k != dof);
                let other = other.ok_or_else(|| wrong("joint", number, "be the number of another joint that moves"))?;
                self.couplings.push((dof, other, effect.clone()));
            }
            "torque_gain_error" => drive.gain *= given.get("GT"),
            "torque_offset" => drive.offset += given.get("TO"),
            "torque_saturation" => match given.stated("TM") {
                Some(limit) => drive.limit = Some(limit),
                None => self.saturates.push(dof),
            },
            "encoder_offset" => drive.encoder_offset += given.get("QO"),
            "joint_spring" => drive.spring = Some(JointSpring::read(&given)),
            "time_delay" => drive.delay += given.get("TD"),
            _ => {} // of the bodies: see `as_it_is`
        }
        Ok(())
    }

    /// Defaults that depend on the motion: its time, the torques that the file's model asks for,
    /// the inertia along it (`places`).
    pub fn settle(&self, span: &Range<f64>, peak: &[f64], places: &[Vec<f64>]) -> Settled {
        let mut drives = self.drives.clone();
        for &j in &self.saturates {
            drives[j].limit = Some((0.8 * peak[j]).max(1e-3));
        }
        let couplings = self.couplings.iter().map(|(motor, other, effect)| {
            let given = Given::new(effect, Some(drives[*motor].rated));
            let (m, k) = (*motor, *other);
            let derived = |key: &str, value: &dyn Fn() -> f64| match given.stated(key) {
                Some(stated) => stated,
                None if only_joint(effect) => value(),
                None => 0.0,
            };
            let ratio = given.get("KC");
            GearCoupling {
                motor: m,
                other: k,
                ratio,
                rotor: derived("IAM", &|| self.bearable_rotor(m, k, &drives, places) / ratio.abs().max(1.0)),
                viscous: derived("FVM", &|| 0.5 * (drives[m].plain.viscous * drives[k].plain.viscous).max(0.0).sqrt()),
                coulomb: derived("FCM", &|| 0.01 * drives[m].rated),
            }
        });
        let contacts = self.contacts.iter().map(|e| ExternalContact::read(&Given::new(e, None), span)).collect();
        Settled { couplings: couplings.collect(), contacts, drives }
    }

    /// Half of what an inertia between two joints may be at most: with a larger one the mass matrix
    /// need not be positive definite. Along the motion, the least of `1 / (4 sqrt(p q))`, `p` and
    /// `q` the joints' entries of its inverse.
    fn bearable_rotor(&self, m: usize, k: usize, drives: &[Drive], places: &[Vec<f64>]) -> f64 {
        let n = drives.len();
        let mut mass = vec![0.0; n * n];
        let mut bodies = self.real().bodies(&self.bodies_standard);
        let mut least = f64::INFINITY;
        for q in places {
            bodies.mass_matrix(q, &mut mass);
            for (j, drive) in drives.iter().enumerate() {
                mass[j * n + j] += drive.rotor;
            }
            if cholesky::factor(n, &mut mass).is_err() {
                return 0.0;
            }
            let [p, q] = [m, k].map(|j| {
                let mut unit = vec![0.0; n];
                unit[j] = 1.0;
                cholesky::solve(n, &mass, &mut unit);
                unit[j]
            });
            least = least.min(0.25 / (p * q).sqrt());
        }
        // A soft joint's motor is coupled by its rotor alone.
        for j in [m, k].into_iter().filter(|&j| drives[j].is_soft()) {
            least = least.min(0.25 * drives[j].rotor);
        }
        if least.is_finite() { least } else { 0.0 }
    }
}

/// Values in the ranges of the table of effects. (Of a file they were checked where it was read.)
fn in_range(effect: &Effect, row: Option<usize>) -> Result<(), SimulateError> {
    let Some(law) = Law::of(&effect.name) else { return Ok(()) };
    for (key, value) in &effect.parameters {
        if let Some(must) = law.must(key, *value) {
            let (effect, key) = (effect.name.clone(), key.clone());
            return Err(SimulateError::Effect { effect, joint: row.map(|row| row + 1), key, value: *value, must });
        }
    }
    Ok(())
}

/// Laws that add to what stands in the drive already.
const PLAIN: [&str; 3] = ["viscous_friction", "coulomb_friction", "rotor_inertia"];

/// Whether nothing but the other joint's number (and the ratio) was written.
fn only_joint(effect: &Effect) -> bool {
    effect.parameters.iter().all(|(key, _)| key == "joint" || key == "KC")
}

fn is_for_every_joint(effect: &Effect) -> bool {
    ["friction_drift", "torque_gain_error", "encoder_offset", "geometric_error", "time_delay"]
        .contains(&effect.name.as_str())
}

fn plain_drive(robot: &Robot, row: usize) -> Drive {
    let joint = &robot.joints[row];
    let mut drive = Drive::ideal(joint.limits.torque.unwrap_or(super::effects::RATED));
    drive.actuated = joint.actuated;
    drive.rotor = joint.drive.rotor_inertia.unwrap_or(0.0);
    drive.plain.viscous = joint.drive.viscous_friction.unwrap_or(0.0);
    drive.plain.level = joint.drive.coulomb_friction.unwrap_or(0.0);
    drive.plain.offset = joint.drive.offset.unwrap_or(0.0);
    drive
}

/// The robot with its true base, rows and links.
fn as_it_is<'e>(
    robot: &Robot,
    of_joints: &[(usize, &Effect)],
    of_robot: impl Iterator<Item = &'e Effect>,
) -> Result<Robot, SimulateError> {
    let mut real = robot.clone();
    let of_joints = of_joints.iter().map(|&(row, effect)| (Some(row), effect));
    for (row, effect) in of_joints.chain(of_robot.map(|effect| (None, effect))) {
        real.change(row, effect).map_err(|NoLink { number, last }| SimulateError::Link { number, last })?;
    }
    Ok(real)
}

/// Standard parameters with those of drives zero.
fn links_only(robot: &Robot, standard: &[f64]) -> Vec<f64> {
    let parameters = param::standard(robot);
    parameters.iter().zip(standard).map(|(p, &v)| if matches!(p, Parameter::Link(..)) { v } else { 0.0 }).collect()
}

/// The file's parameters without Coulomb friction: what a controller feeds forward.
pub(super) fn without_coulomb(arm: &dyn Arm, standard: &[f64]) -> Vec<f64> {
    arm.standard_names().iter().zip(standard).map(|(name, &v)| if name.starts_with("FC") { 0.0 } else { v }).collect()
}
