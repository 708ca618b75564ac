//! Builds what is simulated from a robot and its effects: the true bodies, and a drive for each
//! joint.

use std::ops::Range;

use dh_codegen::arm::param::{self, Parameter};
use dh_codegen::robot::effects::{self, RotorInertia, Scope};
use dh_codegen::robot::{Effect, EffectKind, Effects, NoLink, RATED, Robot, TorqueLaw};

use super::SimulateError;
use super::contact::{Contacts, Links};
use super::drive::Drive;
use super::effects::{
    AsymmetricFriction, Backlash, ClosedForm, ExternalContact, FrictionDrift, GearCoupling, JointElasticity,
    JointSpring, LoadDependentFriction, NonlinearViscousFriction, PositionDependentFriction, PreslidingHysteresis,
    StribeckFriction, TorqueRipple,
};
use crate::model::interpreted::Interpreted;
use crate::model::{Arm, Dynamics};
use crate::numerics::cholesky;

/// The true robot, and the robot as described by its file.
pub(super) struct SimulatedRobot {
    /// Robot of the file: the controller's model.
    pub given: Interpreted,
    pub given_standard: Vec<f64>,
    /// True robot; `None` where only parameters differ from the file.
    real: Option<Interpreted>,
    /// Standard parameters of the true links; those of drives are zero.
    pub bodies_standard: Vec<f64>,
    /// Drives, one per degree of freedom.
    pub drives: Vec<Drive>,
    couplings: Vec<(usize, usize, effects::GearCoupling)>,
    contacts: Vec<effects::ExternalContact>,
    /// Links of the true robot.
    links: Links,
    /// Degrees of freedom whose torque limit is a share of the peak torque.
    saturates: Vec<usize>,
}

/// Drives, couplings and contacts with motion-dependent defaults resolved.
pub(super) struct Settled {
    pub drives: Vec<Drive>,
    pub couplings: Vec<GearCoupling>,
    pub contacts: Contacts,
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
        let contacts: Vec<effects::ExternalContact> = everywhere.clone().filter_map(contact).collect();
        contacts.iter().try_for_each(|contact| is_possible(contact, robot.joints.len()))?;
        let of_joints: Vec<(usize, &Effect)> = own
            .joints
            .iter()
            .map(|(row, e)| (*row, e))
            // An entry at the top of the file applies to every joint.
            .chain(
                everywhere
                    .clone()
                    .filter(|e| e.kind().description().scope == Scope::EveryJoint)
                    .flat_map(|e| (0..robot.joints.len()).map(move |row| (row, e))),
            )
            .chain(more.joints.iter().map(|(row, e)| (*row, e)))
            .collect();

        let real_robot = effective(robot, &of_joints, everywhere)?;
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
            contacts,
            links: Links::of(&real_robot),
            saturates: Vec::new(),
        };
        // Plain friction first: a Stribeck law depends on the Coulomb level.
        for plain in [true, false] {
            for &(row, effect) in &of_joints {
                let Some(dof) = dof_of(row) else { continue };
                if effect.kind().is_plain() == plain {
                    built.apply(robot, row, dof, effect, &dof_of)?;
                }
            }
        }
        own.laws.iter().chain(&more.laws).try_for_each(|(row, law)| built.formula(*row, dof_of(*row), law))?;
        for drive in built.drives.iter_mut().filter(|d| d.is_soft() && d.rotor == 0.0) {
            drive.rotor = RotorInertia::default().inertia(drive.rated);
        }
        Ok(built)
    }

    /// Sets the closed-form law of a joint.
    fn formula(&mut self, row: usize, dof: Option<usize>, law: &TorqueLaw) -> Result<(), SimulateError> {
        let (last, joint) = (self.drives.len(), row + 1);
        if let Some(drive) = dof.and_then(|dof| self.drives.get_mut(dof)) {
            let made = ClosedForm::new(law, last);
            drive.law = Some(made.map_err(|number| SimulateError::Law { joint, number, last })?);
        }
        Ok(())
    }

    /// Checks that no law reads accelerations: under an integrator they follow from the torques.
    pub fn is_free_of_accelerations(&self) -> Result<(), SimulateError> {
        let accelerates = |drive: &Drive| drive.law.as_ref().is_some_and(ClosedForm::reads_acceleration);
        match self.drives.iter().position(accelerates) {
            Some(joint) => Err(SimulateError::LawOfAcceleration(joint + 1)),
            None => Ok(()),
        }
    }

    /// Model of the true arm.
    pub fn real(&self) -> &Interpreted {
        self.real.as_ref().unwrap_or(&self.given)
    }

    /// Applies one effect of one joint to its drive. Bodies and geometry: see [`effective`];
    /// contacts: see [`SimulatedRobot::settle`].
    fn apply(
        &mut self,
        robot: &Robot,
        row: usize,
        dof: usize,
        effect: &Effect,
        dof_of: &dyn Fn(usize) -> Option<usize>,
    ) -> Result<(), SimulateError> {
        in_range(effect, Some(row))?;
        let drive = &mut self.drives[dof];
        let rated = drive.rated;
        match effect {
            Effect::ViscousFriction(e) => {
                drive.plain.viscous = total(effect, row, drive.plain.viscous, e.viscous(rated))?
            }
            Effect::CoulombFriction(e) => drive.plain.level = total(effect, row, drive.plain.level, e.level(rated))?,
            Effect::RotorInertia(e) => drive.rotor = total(effect, row, drive.rotor, e.inertia(rated))?,
            Effect::AsymmetricFriction(e) => drive.asymmetric = Some(AsymmetricFriction::new(e, rated)),
            Effect::StribeckFriction(e) => {
                let law = StribeckFriction::new(e, rated, drive.plain.level);
                // The default breakaway lies above the Coulomb level, which an identification can
                // have made negative.
                let breakaway = effects::StribeckFriction { breakaway: Some(law.breakaway), ..*e };
                in_range(&breakaway.into(), Some(row))?;
                drive.stribeck = Some(law);
            }
            Effect::NonlinearViscousFriction(e) => drive.nonlinear = NonlinearViscousFriction::all(e, rated),
            Effect::LoadDependentFriction(e) => drive.load = Some(LoadDependentFriction::new(e)),
            Effect::PreslidingHysteresis(e) => drive.hysteresis = Some(PreslidingHysteresis::new(e, rated)),
            Effect::FrictionDrift(e) => drive.drift = Some(FrictionDrift::new(e)),
            Effect::PositionDependentFriction(e) => drive.position = Some(PositionDependentFriction::new(e, rated)),
            Effect::TorqueRipple(e) => {
                drive.ripple.push(TorqueRipple::new(e, rated, robot.joints[row].drive.gear_ratio));
            }
            Effect::JointElasticity(e) => drive.elasticity = Some(JointElasticity::new(e, rated)),
            Effect::Backlash(e) => drive.backlash = Some(Backlash::new(e)),
            Effect::GearCoupling(e) => {
                let other = e.joint.checked_sub(1).and_then(dof_of).filter(|&k| k != dof);
                let must = "be the number of another joint that moves";
                let other = other.ok_or_else(|| wrong(effect, Some(row), "joint", e.joint as f64, must))?;
                self.couplings.push((dof, other, *e));
            }
            Effect::TorqueGainError(e) => drive.gain *= e.gain(),
            Effect::TorqueOffset(e) => drive.offset += e.offset(rated),
            Effect::TorqueSaturation(e) => match e.limit {
                Some(limit) => drive.limit = Some(limit),
                None => self.saturates.push(dof),
            },
            Effect::EncoderOffset(e) => drive.encoder_offset += e.offset(),
            Effect::JointSpring(e) => drive.spring = Some(JointSpring::new(e, rated)),
            Effect::TimeDelay(e) => drive.delay += e.delay(),
            Effect::GeometricError(_) | Effect::LinkInertiaError(_) | Effect::Payload(_) | Effect::BaseTilt(_) => {}
            Effect::ExternalContact(_) => {}
        }
        Ok(())
    }

    /// Resolves defaults that depend on the motion. They follow from its time span (s), the peak
    /// torques of the file's model (N m) and the inertia at postures along it (`places`, rad).
    pub fn settle(&self, span: &Range<f64>, peak: &[f64], places: &[Vec<f64>]) -> Settled {
        let mut drives = self.drives.clone();
        for &j in &self.saturates {
            drives[j].limit = Some((0.8 * peak[j]).max(1e-3));
        }
        let couplings = self.couplings.iter().map(|&(m, k, stated)| {
            let ratio = stated.ratio();
            let bearable = || self.bearable_rotor(m, k, &drives, places) / ratio.abs().max(1.0);
            GearCoupling {
                motor: m,
                other: k,
                ratio,
                rotor: stated.rotor.unwrap_or_else(|| if stated.has_sizes() { 0.0 } else { bearable() }),
                viscous: stated.viscous([m, k].map(|j| drives[j].plain.viscous)),
                coulomb: stated.coulomb(drives[m].rated),
                carries: stated.carried(),
            }
        });
        let stated = self.contacts.iter().map(|stated| ExternalContact::new(stated, span)).collect();
        Settled { couplings: couplings.collect(), contacts: Contacts { stated, links: self.links.clone() }, drives }
    }

    /// Half of the largest inertia that may couple two joints: beyond it the mass matrix need not
    /// be positive definite. It is the minimum over `places` of `1 / (4 sqrt(p q))`, with `p` and
    /// `q` the joints' diagonal entries of the inverse mass matrix.
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
        // The motor of a soft joint is coupled through its rotor alone.
        for j in [m, k].into_iter().filter(|&j| drives[j].is_soft()) {
            least = least.min(0.25 * drives[j].rotor);
        }
        if least.is_finite() { least } else { 0.0 }
    }
}

fn wrong(effect: &Effect, row: Option<usize>, key: &str, value: f64, must: &str) -> SimulateError {
    let (key, must) = (key.to_string(), must.to_string());
    SimulateError::Effect { effect: effect.kind(), joint: row.map(|row| row + 1), key, value, must }
}

/// Checks that values lie in the ranges of their keys. (Those of a file were checked on reading.)
fn in_range(effect: &Effect, row: Option<usize>) -> Result<(), SimulateError> {
    match effect.out_of_range().filter(|_| !effect.kind().is_plain()) {
        Some(out) => Err(wrong(effect, row, &out.key, out.value, &out.must)),
        None => Ok(()),
    }
}

/// Sum of plain friction or rotor inertia with the file's. The range of the key applies to the sum,
/// else the drive could generate energy.
fn total(effect: &Effect, row: usize, file: f64, more: f64) -> Result<f64, SimulateError> {
    let (key, sum) = (effect.kind().description().keys[0], file + more);
    if key.range.holds(sum) {
        return Ok(sum);
    }
    let name = format!("{}, the file's included,", key.name);
    Err(wrong(effect, Some(row), &name, sum, &key.range.words(key.unit)))
}

fn contact(effect: &Effect) -> Option<effects::ExternalContact> {
    if let Effect::ExternalContact(contact) = effect { Some(*contact) } else { None }
}

/// Checks that a contact ends after its start, that the link which it touches, if any, is one of the
/// robot's, and that a wall has both a stiffness and a normal.
fn is_possible(contact: &effects::ExternalContact, links: usize) -> Result<(), SimulateError> {
    if let (Some(start), Some(end)) = (contact.start, contact.end)
        && end <= start
    {
        return Err(SimulateError::Contact { end });
    }
    if contact.link.is_some_and(|link| link > links) {
        return Err(SimulateError::Link { effect: EffectKind::ExternalContact, number: contact.link, last: links });
    }
    let faces = contact.normal().iter().any(|n| *n != 0.0);
    match contact.stiffness() > 0.0 {
        stiff if stiff == faces => Ok(()),
        stiff => Err(SimulateError::Wall { stiff }),
    }
}

fn plain_drive(robot: &Robot, row: usize) -> Drive {
    let joint = &robot.joints[row];
    let mut drive = Drive::ideal(joint.limits.torque.unwrap_or(RATED));
    drive.actuated = joint.actuated;
    drive.rotor = joint.drive.rotor_inertia.unwrap_or(0.0);
    drive.plain.viscous = joint.drive.viscous_friction.unwrap_or(0.0);
    drive.plain.level = joint.drive.coulomb_friction.unwrap_or(0.0);
    drive.plain.offset = joint.drive.offset.unwrap_or(0.0);
    drive
}

/// Robot with its true base, geometry and links.
fn effective<'e>(
    robot: &Robot,
    of_joints: &[(usize, &Effect)],
    of_robot: impl Iterator<Item = &'e Effect>,
) -> Result<Robot, SimulateError> {
    let mut real = robot.clone();
    let of_joints = of_joints.iter().map(|&(row, effect)| (Some(row), effect));
    for (row, effect) in of_joints.chain(of_robot.map(|effect| (None, effect))) {
        real.change(row, effect).map_err(|NoLink { number, last }| SimulateError::Link {
            effect: effect.kind(),
            number,
            last,
        })?;
    }
    Ok(real)
}

/// Standard parameters with those of the drives set to zero.
fn links_only(robot: &Robot, standard: &[f64]) -> Vec<f64> {
    let parameters = param::standard(robot);
    parameters.iter().zip(standard).map(|(p, &v)| if matches!(p, Parameter::Link(..)) { v } else { 0.0 }).collect()
}

/// Parameters of the file without Coulomb friction, for the controller's feedforward.
pub(super) fn without_coulomb(arm: &dyn Arm, standard: &[f64]) -> Vec<f64> {
    arm.standard_parameters().iter().zip(standard).map(|(p, &v)| if p.is_coulomb() { 0.0 } else { v }).collect()
}
