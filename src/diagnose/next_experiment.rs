//! Designs the next experiment: the motion, within the limits, on which two causes that these data
//! could not separate differ most.
//!
//! Each cause is represented by the columns by which it acts on the torques, at the state of each
//! sample. [`discriminate`] maximises the part of each that the other and friction (and the base
//! parameters, if the diagnosis refitted them) cannot explain. No such motion exists for causes
//! that are equivalent in theory, or that depend on the history of the motion.

use std::sync::atomic::AtomicBool;

use dh_codegen::robot::effects::{self, Key};
use dh_codegen::robot::{EffectKind, Robot};
use nalgebra::{DMatrix, DVector};

use crate::data::trajectory::Trajectory;
use crate::excite::{Effort, Extra, Task, Watch, discriminate};
use crate::model::coupled::CouplingTerm;
use crate::model::differentiated::Differentiated;
use crate::model::perturbable_robot::PerturbableRobot;
use crate::model::{Arm, Change, DriveTerm, PerturbableArm, StandardParameter, States};

use super::Cause;
use super::Diagnosis;
use super::fit::moments::pseudo_inverse;
use super::hypotheses::{Scope, by_name};

/// A motion that separates two causes.
#[derive(Debug, Clone)]
pub struct Separation {
    /// The causes: the one found, and its alternative.
    pub between: [&'static str; 2],
    /// Joints of each, from 1; empty for the whole robot.
    pub joints: [Vec<usize>; 2],
    /// Motion to be played.
    pub motion: Trajectory,
    /// Residual of the first cause, with the size that was found, after a fit of the second
    /// together with all unknowns: root mean square on each joint, N m.
    pub left: Vec<f64>,
    /// The same as a share of the whole signal, from 0 (indistinguishable) to 1.
    pub share: f64,
    /// The residual of the joint with the largest one relative to its noise, in standard deviations
    /// of that joint's torque noise.
    pub in_noise: f64,
}

/// Duration of the motion, s.
const DURATION: f64 = 10.0;
/// Sampling rate of the evaluation, Hz.
const RATE: f64 = 50.0;
/// Least share of a cause's signal that must remain for a motion to be worth playing.
const WORTH: f64 = 0.1;

/// Designs the motion for the first cause with a rival from which it can be separated. `None` if
/// there is no such pair, or limits are missing.
pub fn discriminating_motion(robot: &Robot, found: &Diagnosis, progress: &dyn Fn(&str)) -> Option<Separation> {
    let plant = PerturbableRobot::new(robot);
    let open = found.causes.iter().filter(|c| !c.not_distinguished_from.is_empty() && c.cause != "unknown");
    let pairs = open.flat_map(|c| c.not_distinguished_from.iter().map(move |rival| (c, *rival)));
    let standard = bodies(&plant, found)?;
    let arm = Differentiated::new(robot);
    let mut task = Task::new(&arm, robot, DURATION, 0.5).ok()?;
    task.rate = RATE;
    task.share = 0.8;
    task.noise = found.noise_floor.iter().map(|s| s.max(1e-3)).collect();
    let turn: Vec<f64> = task.limits.iter().map(|l| 0.01 * l.velocity).collect();
    for (cause, rival) in pairs.take(4) {
        if on_paper(cause.cause, rival) {
            continue;
        }
        let place: Vec<usize> = cause.joints.iter().map(|j| j - 1).collect();
        let own = columns(&plant, cause.cause, &place, &|key| key_of(cause, key));
        let there = rival_place(rival, cause);
        let other = columns(&plant, rival, &there, &|_| None);
        let (Some(own), Some(other)) = (own, other) else { continue };
        progress(&format!("a motion that separates {} from {rival}", cause.cause));
        let family = |columns: &[Column]| Family::new(&plant, &standard, &turn, columns.to_vec());
        let (first, second) = (family(&own), family(&other));
        // A friction term that is a hypothesis is not among the nuisance parameters.
        let ours: Vec<StandardParameter> = own.iter().chain(&other).filter_map(|c| c.base_parameter(&plant)).collect();
        let base = plant.base_parameters();
        task.base = (0..base.len())
            .filter(|&b| found.links_refitted || base[b].leader.is_friction())
            .filter(|&b| !ours.contains(&base[b].leader))
            .collect();
        let effort = Effort { starts: 3, iterations: 12, finalists: 1, ..Effort::default() };
        let (stop, quiet) = (AtomicBool::new(false), |_: &crate::excite::Progress| {});
        let watch = Watch { stop: &stop, progress: &quiet };
        let Ok(design) = discriminate(&task, &first, &second, &effort, &watch) else { continue };
        if !design.feasible {
            continue;
        }
        let size: Vec<f64> = own.iter().map(|c| c.found(&plant, cause).unwrap_or(1.0)).collect();
        let states = design.trajectory.sampled(RATE).1;
        let (left, share) = remains(&task, &states, &first, &second, &size)?;
        if share.is_nan() || share <= WORTH {
            continue;
        }
        let in_noise = left.iter().zip(&task.noise).map(|(l, s)| l / s).fold(0.0, f64::max);
        return Some(Separation {
            between: [cause.cause, rival],
            joints: [cause.joints.clone(), there.iter().map(|j| j + 1).collect()],
            motion: design.trajectory,
            left,
            share,
            in_noise,
        });
    }
    None
}

/// Standard parameters of the diagnosed arm, with zero friction.
fn bodies(plant: &PerturbableRobot, found: &Diagnosis) -> Option<Vec<f64>> {
    let standard = found.standard.as_deref().or(plant.given())?;
    let pairs = plant.standard_parameters().iter().zip(standard);
    Some(pairs.map(|(p, v)| if p.is_friction() { 0.0 } else { *v }).collect())
}

/// Whether a pair is equivalent in theory, so that no motion separates it.
fn on_paper(a: &str, b: &str) -> bool {
    let says = |a: &str, b: &str| by_name(a).is_some_and(|cause| cause.same_on_paper().contains(&b));
    says(a, b) || says(b, a)
}

/// Joints of the rival, from 0. Causes of the whole robot have none. If the found cause is of the
/// whole robot, a rival of one joint is placed where that cause acts most.
fn rival_place(rival: &str, cause: &Cause) -> Vec<usize> {
    let gain = |j: &usize| cause.rms_before[*j].powi(2) - cause.rms_after[*j].powi(2);
    let most = || (0..cause.rms_before.len()).max_by(|a, b| gain(a).total_cmp(&gain(b)));
    let own = cause.joints.first().map(|j| j - 1);
    match by_name(rival).map_or(Scope::Joint, |r| r.scope()) {
        Scope::Robot => Vec::new(),
        Scope::JointOrRobot => own.into_iter().collect(),
        Scope::Joint => own.or_else(most).into_iter().collect(),
        Scope::Pair => {
            let Some(joint) = own.or_else(most) else { return Vec::new() };
            let other = cause.joints.get(1).map_or(if joint > 0 { joint - 1 } else { joint + 1 }, |k| k - 1);
            vec![joint, other]
        }
    }
}

fn key_of(cause: &Cause, key: Key) -> Option<f64> {
    cause.keys.iter().find(|named| named.symbol == key.into()).map(|named| named.value)
}

/// Torque column of one unknown of a cause.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Column {
    /// A law on joint `.0` alone, with the key of its size.
    OwnJoint(usize, Law, Key),
    /// Offset of the measured angle of joint `.0`: `QO`.
    Zero(usize),
    /// Deflection of joint `.0`: `1 / KE`.
    Deflection(usize),
    /// Delay of the torque of this joint, or of all: `TD`.
    Late(Option<usize>),
    /// A change of the arm's geometry, its step, and the key of its size.
    Changed(Change, f64, Key),
    /// A motor coupled to another joint: joint of the motor, other joint, ratio, and which of its
    /// terms.
    Coupled(usize, usize, f64, CouplingTerm),
}

/// Laws of one joint; `s` is the smoothed sign of its velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Law {
    /// v
    Viscous,
    /// s
    Coulomb,
    /// 1
    Offset,
    /// |v|
    Directional,
    /// exp(-|v / VS|^DS) s
    Stribeck(f64, f64),
    /// |v|^EN s
    Power(f64),
    /// |load| s
    Load,
    /// load
    Gain,
    /// ddq
    Rotor,
    /// q
    Spring,
    /// cos(n q), times s
    Cosine(f64, bool),
    /// sin(n q), times s
    Sine(f64, bool),
}

impl Law {
    /// The drive parameter with the same column, if any.
    fn drive_term(self) -> Option<DriveTerm> {
        match self {
            Self::Viscous => Some(DriveTerm::FV),
            Self::Coulomb => Some(DriveTerm::FC),
            Self::Offset => Some(DriveTerm::FO),
            Self::Rotor => Some(DriveTerm::IA),
            _ => None,
        }
    }
}

/// Laws by which an effect acts on its own joint alone, each with the key of its size; empty for
/// other effects.
fn joint_laws(effect: EffectKind, gear_ratio: Option<f64>, key: &dyn Fn(Key) -> Option<f64>) -> Vec<(Law, Key)> {
    let or = |name: Key, value: f64| key(name).unwrap_or(value);
    match effect {
        EffectKind::ViscousFriction => vec![(Law::Viscous, effects::ViscousFriction::FV)],
        EffectKind::CoulombFriction => vec![(Law::Coulomb, effects::CoulombFriction::FC)],
        EffectKind::TorqueOffset => vec![(Law::Offset, effects::TorqueOffset::TO)],
        EffectKind::AsymmetricFriction => vec![(Law::Directional, effects::AsymmetricFriction::FVA)],
        EffectKind::StribeckFriction => {
            let (speed, exponent) = (or(effects::StribeckFriction::VS, 0.1), or(effects::StribeckFriction::DS, 2.0));
            vec![(Law::Stribeck(speed, exponent), effects::StribeckFriction::FS)]
        }
        EffectKind::NonlinearViscousFriction => {
            let exponent = or(effects::NonlinearViscousFriction::EN, 0.5);
            vec![(Law::Power(exponent), effects::NonlinearViscousFriction::FN)]
        }
        EffectKind::LoadDependentFriction => vec![(Law::Load, effects::LoadDependentFriction::FL)],
        EffectKind::TorqueGainError => vec![(Law::Gain, effects::TorqueGainError::GT)],
        EffectKind::RotorInertia => vec![(Law::Rotor, effects::RotorInertia::IA)],
        EffectKind::JointSpring => vec![(Law::Spring, effects::JointSpring::KS)],
        EffectKind::PositionDependentFriction => {
            use effects::PositionDependentFriction as Keys;
            let n = or(Keys::PN, 1.0);
            vec![(Law::Cosine(n, true), Keys::PC), (Law::Sine(n, true), Keys::PS)]
        }
        EffectKind::TorqueRipple => {
            use effects::TorqueRipple as Keys;
            let n = key(Keys::RN).or(gear_ratio.map(f64::abs)).unwrap_or(32.0);
            vec![(Law::Cosine(n, false), Keys::RC), (Law::Sine(n, false), Keys::RS)]
        }
        _ => Vec::new(),
    }
}

/// Columns of the unknowns of a cause at this place; `None` if it is not a function of the state
/// alone.
fn columns(
    plant: &dyn PerturbableArm,
    cause: &str,
    place: &[usize],
    key: &dyn Fn(Key) -> Option<f64>,
) -> Option<Vec<Column>> {
    let j = place.first().copied().filter(|j| *j < plant.dof());
    let row = |at: f64, which: usize, name: Key| {
        let by = |k: usize| if k == which { at } else { 0.0 };
        let change = Change::Row { row: *plant.rows().get(j?)?, alpha: by(0), d: by(1), theta: by(2), r: by(3) };
        Some(Column::Changed(change, at, name))
    };
    let effect = EffectKind::of(cause)?;
    let all: Vec<Option<Column>> = match effect {
        EffectKind::ViscousFriction
        | EffectKind::CoulombFriction
        | EffectKind::TorqueOffset
        | EffectKind::AsymmetricFriction
        | EffectKind::StribeckFriction
        | EffectKind::NonlinearViscousFriction
        | EffectKind::LoadDependentFriction
        | EffectKind::TorqueGainError
        | EffectKind::RotorInertia
        | EffectKind::JointSpring
        | EffectKind::PositionDependentFriction
        | EffectKind::TorqueRipple => {
            let gear_ratio = plant.gear_ratios().get(j?).copied().flatten();
            let laws = joint_laws(effect, gear_ratio, key);
            laws.into_iter().map(|(law, name)| j.map(|j| Column::OwnJoint(j, law, name))).collect()
        }
        EffectKind::EncoderOffset => vec![j.map(Column::Zero)],
        EffectKind::JointElasticity => vec![j.map(Column::Deflection)],
        EffectKind::TimeDelay => vec![Some(Column::Late(j))],
        EffectKind::BaseTilt => vec![
            Some(Column::Changed(Change::Base { roll: 1e-3, pitch: 0.0 }, 1e-3, effects::BaseTilt::ROLL)),
            Some(Column::Changed(Change::Base { roll: 0.0, pitch: 1e-3 }, 1e-3, effects::BaseTilt::PITCH)),
        ],
        EffectKind::GeometricError => {
            use effects::GeometricError as Keys;
            const ROW: [Key; 4] = [Keys::DALPHA, Keys::DD, Keys::DTHETA, Keys::DR];
            let which = ROW.iter().position(|name| key(*name).is_some()).unwrap_or(1);
            vec![row(1e-3, which, ROW[which])]
        }
        EffectKind::GearCoupling => {
            let (m, k) = (j?, place.get(1).copied().filter(|k| *k < plant.dof())?);
            let ratio = key(effects::GearCoupling::KC).unwrap_or(1.0);
            CouplingTerm::ALL.map(|term| Some(Column::Coupled(m, k, ratio, term))).to_vec()
        }
        // With memory, a limit, or tied to a time or a log: not functions of the state alone.
        EffectKind::PreslidingHysteresis
        | EffectKind::FrictionDrift
        | EffectKind::Backlash
        | EffectKind::TorqueSaturation
        | EffectKind::LinkInertiaError
        | EffectKind::Payload
        | EffectKind::ExternalContact => return None,
    };
    all.into_iter().collect()
}

impl Column {
    /// The base parameter with the same column, if any.
    fn base_parameter(self, plant: &dyn PerturbableArm) -> Option<StandardParameter> {
        let Self::OwnJoint(j, law, _) = self else { return None };
        Some(StandardParameter::Drive(*plant.rows().get(j)?, law.drive_term()?))
    }

    /// Size of this unknown that the diagnosis found beyond the file.
    fn found(self, plant: &dyn PerturbableArm, cause: &Cause) -> Option<f64> {
        let given = |law: Law, j: usize| {
            let wanted =
                law.drive_term().zip(plant.rows().get(j)).map(|(term, row)| StandardParameter::Drive(*row, term));
            let at = plant.standard_parameters().iter().position(|p| Some(*p) == wanted);
            at.map_or(0.0, |at| plant.given_drive(at))
        };
        let value = match self {
            Self::OwnJoint(_, Law::Stribeck(..), name) => {
                key_of(cause, name)? - key_of(cause, effects::CoulombFriction::FC).unwrap_or(0.0)
            }
            Self::OwnJoint(_, Law::Gain, name) => key_of(cause, name)? - 1.0,
            Self::OwnJoint(j, law @ (Law::Viscous | Law::Coulomb | Law::Rotor), name) => {
                key_of(cause, name)? - given(law, j)
            }
            Self::OwnJoint(_, _, name) | Self::Changed(_, _, name) => key_of(cause, name)?,
            Self::Zero(_) => key_of(cause, effects::EncoderOffset::QO)?,
            Self::Deflection(_) => 1.0 / key_of(cause, effects::JointElasticity::KE)?,
            Self::Late(_) => key_of(cause, effects::TimeDelay::TD)?,
            Self::Coupled(.., term) => key_of(cause, term.key())?,
        };
        Some(value)
    }
}

/// Evaluates the columns of a cause at given states.
struct Family<'a> {
    plant: &'a PerturbableRobot,
    standard: &'a [f64],
    /// Speed over which the smoothed sign changes, per joint, rad/s.
    turn: &'a [f64],
    columns: Vec<Column>,
    pattern: Vec<(usize, usize)>,
}

impl<'a> Family<'a> {
    fn new(plant: &'a PerturbableRobot, standard: &'a [f64], turn: &'a [f64], columns: Vec<Column>) -> Self {
        let pattern = (0..columns.len()).flat_map(|c| (0..plant.dof()).map(move |j| (j, c))).collect();
        Self { plant, standard, turn, columns, pattern }
    }

    fn load(&self, states: &States) -> Vec<f64> {
        let mut tau = vec![0.0; self.plant.dof() * states.len];
        self.plant.inverse_dynamics(states, self.standard, &mut tau);
        tau
    }

    /// Difference quotient of the load for a change `by` of the motion, divided by `step`.
    fn moved(&self, states: &States, load: &[f64], step: f64, by: impl Fn(&mut States), out: &mut [f64]) {
        let mut moved = states.clone();
        by(&mut moved);
        let other = self.load(&moved);
        out.iter_mut().zip(other.iter().zip(load)).for_each(|(o, (a, b))| *o = (a - b) / step);
    }

    fn one(&self, column: Column, states: &States, load: &[f64], out: &mut [f64]) {
        let len = states.len;
        out.fill(0.0);
        let smooth = |v: f64, j: usize| (v / self.turn[j].max(1e-6)).tanh();
        match column {
            Column::OwnJoint(j, law, _) => {
                for s in 0..len {
                    let at = j * len + s;
                    let (q, v) = (states.q[at], states.dq[at]);
                    let sign = smooth(v, j);
                    let of = |by_sign: bool| if by_sign { sign } else { 1.0 };
                    out[at] = match law {
                        Law::Viscous => v,
                        Law::Coulomb => sign,
                        Law::Offset => 1.0,
                        Law::Directional => v * sign,
                        Law::Stribeck(speed, power) => (-(v.abs() / speed).powf(power)).exp() * sign,
                        Law::Power(power) => v.abs().powf(power) * sign,
                        Law::Load => load[at].abs() * sign,
                        Law::Gain => load[at],
                        Law::Rotor => states.ddq[at],
                        Law::Spring => q,
                        Law::Cosine(n, by_sign) => (n * q).cos() * of(by_sign),
                        Law::Sine(n, by_sign) => (n * q).sin() * of(by_sign),
                    };
                }
            }
            Column::Zero(j) => {
                self.moved(states, load, 1e-5, |m| m.q[j * len..(j + 1) * len].iter_mut().for_each(|q| *q += 1e-5), out)
            }
            Column::Deflection(j) => self.moved(
                states,
                load,
                1e-6,
                |m| (j * len..(j + 1) * len).for_each(|at| m.q[at] -= 1e-6 * load[at]),
                out,
            ),
            // Earlier by a step at constant acceleration; the jerk is not part of a state.
            Column::Late(which) => {
                self.moved(
                    states,
                    load,
                    1e-4,
                    |m| {
                        for at in 0..m.q.len() {
                            m.q[at] -= 1e-4 * states.dq[at];
                            m.dq[at] -= 1e-4 * states.ddq[at];
                        }
                    },
                    out,
                );
                if let Some(j) = which {
                    out.iter_mut().enumerate().filter(|(at, _)| at / len != j).for_each(|(_, o)| *o = 0.0);
                }
            }
            Column::Changed(change, step, _) => {
                let mut other = vec![0.0; out.len()];
                self.plant.changed_dynamics(&change, states, self.standard, out);
                let nothing = Change::Base { roll: 0.0, pitch: 0.0 };
                self.plant.changed_dynamics(&nothing, states, self.standard, &mut other);
                out.iter_mut().zip(&other).for_each(|(o, b)| *o = (*o - b) / step);
            }
            Column::Coupled(m, k, ratio, term) => {
                for s in 0..len {
                    let (a, b) = (m * len + s, k * len + s);
                    let along = states.dq[a] + ratio * states.dq[b];
                    let (on_m, on_k) = match term {
                        CouplingTerm::IAM => (ratio * states.ddq[b], ratio * states.ddq[a]),
                        CouplingTerm::FVM => (ratio * states.dq[b], ratio * states.dq[a]),
                        CouplingTerm::FCM => (smooth(along, m), ratio * smooth(along, m)),
                    };
                    (out[a], out[b]) = (on_m, on_k);
                }
            }
        }
    }
}

impl Extra for Family<'_> {
    fn columns(&self) -> usize {
        self.columns.len()
    }

    fn pattern(&self) -> &[(usize, usize)] {
        &self.pattern
    }

    fn evaluate(&self, states: &States, out: &mut [f64]) {
        let each = self.plant.dof() * states.len;
        if each == 0 {
            return;
        }
        let load = self.load(states);
        for (column, out) in self.columns.iter().zip(out.chunks_exact_mut(each)) {
            self.one(*column, states, &load, out);
        }
    }
}

/// Part of the first family's signal that the nuisance parameters and the second family cannot
/// explain: root mean square per joint, N m, and share of the whole.
fn remains(
    task: &Task<'_>,
    states: &States,
    first: &Family<'_>,
    second: &Family<'_>,
    size: &[f64],
) -> Option<(Vec<f64>, f64)> {
    let (n, len) = (task.dof(), states.len);
    let evaluated = |family: &Family<'_>| {
        let mut out = vec![0.0; family.pattern.len() * len];
        family.evaluate(states, &mut out);
        out
    };
    let (own, other) = (evaluated(first), evaluated(second));
    let weight = |at: usize| 1.0 / task.noise[at / len];
    let mut signal = DVector::zeros(n * len);
    for (column, x) in own.chunks_exact(n * len).zip(size) {
        column.iter().enumerate().for_each(|(at, v)| signal[at] += x * v * weight(at));
    }
    let count = task.base.len() + second.columns.len();
    let mut beside = DMatrix::zeros(n * len, count);
    let pattern = task.arm.base_pattern();
    let mut entries = vec![0.0; pattern.len() * len];
    task.arm.base_regressor(states, &mut entries);
    for (values, &(row, column)) in entries.chunks_exact(len).zip(pattern) {
        if let Some(c) = task.base.iter().position(|b| *b == column) {
            values.iter().enumerate().for_each(|(s, v)| beside[(row * len + s, c)] = v * weight(row * len + s));
        }
    }
    for (c, column) in other.chunks_exact(n * len).enumerate() {
        column.iter().enumerate().for_each(|(at, v)| beside[(at, task.base.len() + c)] = v * weight(at));
    }
    let fitted = pseudo_inverse(&(beside.transpose() * &beside)) * (beside.transpose() * &signal);
    let rest = &signal - &beside * fitted;
    let whole = signal.norm();
    let left: Vec<f64> =
        (0..n).map(|j| (rest.rows(j * len, len).norm_squared() / len as f64).sqrt() * task.noise[j]).collect();
    (whole > 0.0 && rest.iter().all(|r| r.is_finite())).then(|| (left, rest.norm() / whole))
}

#[cfg(test)]
mod tests {
    use dh_codegen::robot::no_files;

    use super::*;

    /// Columns of laws equal the torques of the file's laws, apart from the smoothed sign.
    #[test]
    fn columns_are_derivatives_of_the_predicted_torques() {
        use crate::model::TorqueModel;
        use crate::model::file_torque_model::FileTorqueModel;
        use dh_codegen::robot::Effect;
        let text = include_str!("../../robots/planar2r.yaml");
        let robot = Robot::from_yaml(text, &no_files).unwrap().robot;
        let plant = PerturbableRobot::new(&robot);
        let wave = |k: f64| (0..8).map(|i| k * (0.7 * f64::from(i) + 0.3 * k).sin()).collect::<Vec<f64>>();
        let states = States { len: 4, q: wave(1.0), dq: wave(0.6), ddq: wave(2.0) };
        let torques = |robot: &Robot| {
            let mut out = vec![0.0; 8];
            FileTorqueModel::new(robot).unwrap().torques(&states, &mut out);
            out
        };
        let plain = torques(&robot);
        let bodies: Vec<f64> = plant
            .standard_parameters()
            .iter()
            .zip(plant.given().unwrap())
            .map(|(p, v)| if p.is_friction() { 0.0 } else { *v })
            .collect();
        let turn = [1e-9; 2];
        type Case<'a> = (&'a str, &'a [(Key, f64)], usize, f64);
        let cases: [Case<'_>; 8] = [
            (
                effects::TorqueRipple::NAME,
                &[(effects::TorqueRipple::RN, 5.0), (effects::TorqueRipple::RC, 1.0)],
                0,
                1.0,
            ),
            (
                effects::PositionDependentFriction::NAME,
                &[(effects::PositionDependentFriction::PN, 2.0), (effects::PositionDependentFriction::PS, 1.0)],
                1,
                1.0,
            ),
            (
                effects::NonlinearViscousFriction::NAME,
                &[(effects::NonlinearViscousFriction::FN, 1.0), (effects::NonlinearViscousFriction::EN, 0.6)],
                0,
                1.0,
            ),
            (effects::LoadDependentFriction::NAME, &[(effects::LoadDependentFriction::FL, 0.5)], 0, 0.5),
            (effects::JointElasticity::NAME, &[(effects::JointElasticity::KE, 1e6)], 0, 1e-6),
            (effects::EncoderOffset::NAME, &[(effects::EncoderOffset::QO, 1e-5)], 0, 1e-5),
            (effects::AsymmetricFriction::NAME, &[(effects::AsymmetricFriction::FVA, 1.0)], 0, 1.0),
            (
                effects::GearCoupling::NAME,
                &[
                    (effects::GearCoupling::JOINT, 1.0),
                    (effects::GearCoupling::KC, -0.5),
                    (effects::GearCoupling::IAM, 0.3),
                ],
                0,
                0.3,
            ),
        ];
        for (name, keys, which, size) in cases {
            let key = |k: Key| keys.iter().find(|(name, _)| *name == k).map(|(_, v)| *v);
            let columns = columns(&plant, name, &[1, 0], &key).unwrap();
            let family = Family::new(&plant, &bodies, &turn, columns);
            let mut out = vec![0.0; family.pattern.len() * 4];
            family.evaluate(&states, &mut out);
            let mut changed = robot.clone();
            changed.joints[1].drive.effects.push(Effect::from_keys(name, keys).unwrap());
            for (at, (a, b)) in torques(&changed).iter().zip(&plain).enumerate() {
                let expected = (a - b) / size;
                let value = out[which * 8 + at];
                assert!((value - expected).abs() < 2e-4 * (1.0 + expected.abs()), "{name} {at}: {value} {expected}");
            }
        }
        assert!(columns(&plant, effects::PreslidingHysteresis::NAME, &[1], &|_| None).is_none());
    }
}
