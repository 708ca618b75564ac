//! Effects of the vocabulary with drawn shapes, before their size is set.

use std::f64::consts::TAU;

use dh_codegen::robot::effects::{
    AsymmetricFriction, Backlash, BaseTilt, CoulombFriction, EncoderOffset, ExternalContact, FrictionDrift,
    GearCoupling, GeometricError, JointElasticity, JointSpring, Key, LinkInertiaError, LoadDependentFriction,
    NonlinearViscousFriction, Payload, PositionDependentFriction, PreslidingHysteresis, RotorInertia, StribeckFriction,
    TimeDelay, TorqueGainError, TorqueOffset, TorqueRipple, TorqueSaturation, ViscousFriction,
};
use dh_codegen::robot::{Effect, EffectKind, Effects, Robot};

use super::hidden::{Hidden, JointScales, Wanted};
use crate::numerics::prng::Random;

/// An effect at its place with an undetermined size.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Draft {
    pub cause: EffectKind,
    /// Joint, from 0; `None` for the whole robot.
    pub joint: Option<usize>,
    /// The other joint of a coupling, from 0.
    pub other: Option<usize>,
    law: Law,
}

/// Keys of an effect and the range of the search for its size.
#[derive(Debug, Clone, PartialEq)]
struct Law {
    terms: Vec<Term>,
    /// Start of the search for the size.
    start: f64,
    /// Largest size at which it is still an effect of this kind.
    most: f64,
    /// Whether the size refers to the joint's own torque error; otherwise to that of the joint that
    /// shows it most.
    own: bool,
}

/// Value of a key as a function of the effect's size `x`.
#[derive(Debug, Clone, PartialEq)]
struct Term {
    key: String,
    value: Growth,
    /// Value of this key in the robot file, added before the comparison with the estimate. `None`:
    /// not compared, because other numbers of the law are estimated with it.
    given: Option<f64>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Growth {
    /// `fixed + x grows`.
    Linear { fixed: f64, grows: f64 },
    /// `1 / x`: a stiffness, whose effect grows with its compliance.
    Inverse,
}

/// Term of a key that grows with the size and is compared with its estimate.
fn size(key: Key, grows: f64) -> Term {
    from(key, 0.0, grows)
}

/// Term of a key that has a value without the effect.
fn from(key: Key, fixed: f64, grows: f64) -> Term {
    Term { key: key.name().to_string(), value: Growth::Linear { fixed, grows }, given: Some(0.0) }
}

/// Term whose estimate depends on others of the law: an order's phase, a power's factor.
fn part(key: Key, grows: f64) -> Term {
    Term { given: None, ..size(key, grows) }
}

/// Term of the law's shape, independent of the size.
fn shape(key: Key, fixed: f64) -> Term {
    Term { given: None, ..from(key, fixed, 0.0) }
}

/// Term of a ripple's second order.
fn second(term: Term) -> Term {
    Term { key: term.key + "2", ..term }
}

/// A torque law on its own joint, whose size has no limit.
fn torque(start: f64, terms: Vec<Term>) -> Law {
    Law { terms, start, most: f64::MAX, own: true }
}

/// A law whose size has a range of its own.
fn bounded([start, most]: [f64; 2], own: bool, terms: Vec<Term>) -> Law {
    Law { terms, start, most, own }
}

impl Draft {
    /// Draws the shape of an effect. `joints`: torque scales, one entry per joint.
    pub fn draw(wanted: Wanted, joint: usize, robot: &Robot, joints: &[JointScales], random: &mut Random) -> Self {
        let sign = if random.chance(0.5) { 1.0 } else { -1.0 };
        let cause = wanted.kind();
        let whole = wanted == Wanted::Effect(EffectKind::TimeDelay) || !cause.description().scope.at_joint();
        let other = (cause == EffectKind::GearCoupling).then(|| if joint == 0 { 1 } else { joint - 1 });
        let drawn = friction(cause, &joints[joint], sign, random)
            .or_else(|| transmission(cause, &joints[joint], other, robot, sign, random))
            .or_else(|| sensor(cause, &joints[joint], sign));
        let law = drawn.unwrap_or_else(|| structure(cause, joint, robot, sign, random));
        Self { cause, joint: (!whole).then_some(joint), other, law }
    }

    /// Start of the search for the size.
    pub fn start(&self) -> f64 {
        self.law.start
    }

    /// Largest size of an effect of this kind.
    pub fn most(&self) -> f64 {
        self.law.most
    }

    /// Whether the size refers to the joint's own torque error.
    pub fn own(&self) -> bool {
        self.law.own
    }

    /// Whether its torque on a given motion is proportional to the size.
    pub fn linear(&self) -> bool {
        self.law.own && !matches!(self.cause, EffectKind::TorqueSaturation | EffectKind::TimeDelay)
    }

    /// The effect at this size.
    pub fn effect(&self, x: f64) -> Effect {
        let keys: Vec<(&str, f64)> = self.law.terms.iter().map(|term| (term.key.as_str(), term.at(x))).collect();
        let effect = Effect::of_kind(self.cause, &keys);
        effect.unwrap_or_else(|error| unreachable!("a draft has the keys of its effect: {error}"))
    }

    /// Expected result of a diagnosis; `size` is the effect's, relative to the noise.
    pub fn hidden(&self, x: f64, size: f64) -> Hidden {
        let suffix = self.joint.map(|j| (j + 1).to_string()).unwrap_or_default();
        let expected = |term: &Term| term.given.map(|given| (format!("{}{suffix}", term.key), term.at(x) + given));
        Hidden {
            cause: self.cause.name(),
            joints: self.joint.into_iter().chain(self.other).map(|j| j + 1).collect(),
            truth: self.law.terms.iter().filter_map(expected).collect(),
            size,
        }
    }
}

impl Term {
    fn at(&self, x: f64) -> f64 {
        match self.value {
            Growth::Linear { fixed, grows } => fixed + x * grows,
            Growth::Inverse => 1.0 / x,
        }
    }

    /// Sets the file's value that is added before the comparison with the estimate.
    fn beside(self, given: f64) -> Self {
        Self { given: Some(given), ..self }
    }
}

/// Friction laws.
fn friction(cause: EffectKind, of: &JointScales, sign: f64, random: &mut Random) -> Option<Law> {
    let percent = 0.01 * of.limit;
    Some(match cause {
        EffectKind::ViscousFriction => torque(percent, vec![size(ViscousFriction::FV, 1.0).beside(of.viscous)]),
        EffectKind::CoulombFriction => torque(percent, vec![size(CoulombFriction::FC, 1.0).beside(of.coulomb)]),
        EffectKind::AsymmetricFriction => {
            torque(percent, vec![size(AsymmetricFriction::FCA, 0.3 * sign), size(AsymmetricFriction::FVA, sign)])
        }
        EffectKind::StribeckFriction => {
            let (speed, power) = (random.uniform(0.03, 0.15), random.uniform(1.2, 2.2));
            let level = from(StribeckFriction::FS, of.coulomb, 1.0);
            torque(percent, vec![level, shape(StribeckFriction::VS, speed), shape(StribeckFriction::DS, power)])
        }
        EffectKind::NonlinearViscousFriction => {
            let power = if random.chance(0.5) { random.uniform(0.35, 0.65) } else { random.uniform(1.7, 2.3) };
            let terms = vec![part(NonlinearViscousFriction::FN, 1.0), shape(NonlinearViscousFriction::EN, power)];
            torque(0.015 * of.limit, terms)
        }
        EffectKind::LoadDependentFriction => bounded([0.08, 0.8], true, vec![size(LoadDependentFriction::FL, 1.0)]),
        EffectKind::PreslidingHysteresis => {
            let travel = 4e-3 * 10_f64.powf(random.uniform(0.0, 1.0));
            torque(percent, vec![size(PreslidingHysteresis::HC, 1.0), shape(PreslidingHysteresis::HX, travel)])
        }
        EffectKind::FrictionDrift => {
            let terms = vec![part(FrictionDrift::DA, 1.0), shape(FrictionDrift::DT, random.uniform(3.0, 10.0))];
            bounded([0.5, 8.0], true, terms)
        }
        EffectKind::PositionDependentFriction => {
            let periods = random.uniform(1.0, 3.5).round();
            let phase = random.uniform(0.0, TAU);
            let terms = vec![
                part(PositionDependentFriction::PC, phase.cos()),
                part(PositionDependentFriction::PS, phase.sin()),
                shape(PositionDependentFriction::PN, periods),
            ];
            torque(0.005 * of.limit, terms)
        }
        _ => return None,
    })
}

/// Laws of rotor, gear and spring.
fn transmission(
    cause: EffectKind,
    of: &JointScales,
    other: Option<usize>,
    robot: &Robot,
    sign: f64,
    random: &mut Random,
) -> Option<Law> {
    Some(match cause {
        EffectKind::RotorInertia => torque(0.003 * of.limit, vec![size(RotorInertia::IA, 1.0).beside(of.rotor)]),
        EffectKind::TorqueRipple => ripple(of, random),
        EffectKind::JointElasticity => {
            let stiffness = Term { value: Growth::Inverse, ..size(JointElasticity::KE, 0.0) };
            let terms = vec![stiffness, from(JointElasticity::DE, 0.1 * of.limit, 0.0)];
            bounded([1.0 / (60.0 * of.limit), 0.08 / of.peak], false, terms)
        }
        EffectKind::Backlash => bounded([1e-3, 0.05], false, vec![size(Backlash::BL, 1.0)]),
        EffectKind::GearCoupling => {
            let row = (robot.moving()[other?] + 1) as f64;
            let terms = vec![
                shape(GearCoupling::JOINT, row),
                part(GearCoupling::KC, sign),
                size(GearCoupling::FVM, 0.6),
                size(GearCoupling::FCM, 1.0),
            ];
            torque(0.01 * of.limit, terms)
        }
        EffectKind::JointSpring => {
            let rest = random.uniform(-0.5, 0.5);
            torque(0.02 * of.limit, vec![size(JointSpring::KS, 1.0), shape(JointSpring::QS, rest)])
        }
        _ => return None,
    })
}

/// A ripple with a second harmonic of about a seventh.
fn ripple(of: &JointScales, random: &mut Random) -> Law {
    let order = random.uniform(12.0, 60.0).round();
    let phase = random.uniform(0.0, TAU);
    let terms = vec![
        shape(TorqueRipple::RN, order),
        part(TorqueRipple::RC, phase.cos()),
        part(TorqueRipple::RS, phase.sin()),
        second(shape(TorqueRipple::RN, 2.0 * order)),
        second(part(TorqueRipple::RC, 0.15)),
    ];
    torque(0.006 * of.limit, terms)
}

/// Laws of the torque and position sensors.
fn sensor(cause: EffectKind, of: &JointScales, sign: f64) -> Option<Law> {
    Some(match cause {
        EffectKind::TorqueGainError => bounded([0.05, 0.6], true, vec![from(TorqueGainError::GT, 1.0, sign)]),
        EffectKind::TorqueOffset => torque(0.01 * of.limit, vec![size(TorqueOffset::TO, sign)]),
        EffectKind::TorqueSaturation => bounded([0.1, 0.6], true, vec![from(TorqueSaturation::TM, of.peak, -of.peak)]),
        EffectKind::EncoderOffset => bounded([0.01, 0.3], false, vec![size(EncoderOffset::QO, sign)]),
        EffectKind::TimeDelay => bounded([5e-3, 0.08], true, vec![size(TimeDelay::TD, 1.0)]),
        _ => return None,
    })
}

/// Laws of geometry, bodies and contact, which do not belong to one joint.
fn structure(cause: EffectKind, joint: usize, robot: &Robot, sign: f64, random: &mut Random) -> Law {
    match cause {
        EffectKind::GeometricError => {
            let key = [GeometricError::DALPHA, GeometricError::DD, GeometricError::DR][random.below(3)];
            bounded([0.01, 0.25], false, vec![size(key, sign)])
        }
        EffectKind::LinkInertiaError => {
            let link = robot.inertias().and_then(|l| l.get(robot.moving()[joint]).copied());
            let values = link.map_or([0.0; 10], |l| l.to_array());
            let terms = LINK.into_iter().zip(values).map(|(key, value)| size(key, sign * value)).collect();
            bounded([0.1, 0.9], false, terms)
        }
        EffectKind::Payload => {
            let (x, z) = (random.uniform(-0.05, 0.05), random.uniform(0.05, 0.15));
            let terms = vec![
                size(Payload::M, 1.0),
                size(Payload::MSX, x),
                size(Payload::MSZ, z),
                size(Payload::XX, z * z + 1e-3),
                size(Payload::YY, x * x + z * z + 1e-3),
                size(Payload::ZZ, x * x + 1e-3),
                size(Payload::XZ, -x * z),
            ];
            bounded([0.2, 30.0], false, terms)
        }
        EffectKind::BaseTilt => {
            let turn = random.uniform(0.0, TAU);
            bounded([0.01, 0.4], false, vec![size(BaseTilt::ROLL, turn.cos()), size(BaseTilt::PITCH, turn.sin())])
        }
        EffectKind::ExternalContact => {
            let begin = random.uniform(2.0, 5.0);
            let terms = vec![
                shape(ExternalContact::START, begin),
                shape(ExternalContact::END, begin + random.uniform(0.8, 2.0)),
                size(ExternalContact::FX, random.uniform(-1.0, 1.0)),
                size(ExternalContact::FY, random.uniform(-1.0, 1.0)),
                size(ExternalContact::FZ, sign),
            ];
            bounded([5.0, 500.0], false, terms)
        }
        _ => unreachable!("{cause} is a law of one joint"),
    }
}

/// Keys of a link's parameters, in the order of [`crate::model::Inertial::ALL`].
const LINK: [Key; 10] = [
    LinkInertiaError::M,
    LinkInertiaError::MSX,
    LinkInertiaError::MSY,
    LinkInertiaError::MSZ,
    LinkInertiaError::XX,
    LinkInertiaError::YY,
    LinkInertiaError::ZZ,
    LinkInertiaError::XY,
    LinkInertiaError::XZ,
    LinkInertiaError::YZ,
];

/// Effects for the simulator.
pub(super) fn effects(robot: &Robot, sized: &[(Draft, f64)]) -> Effects {
    let rows = robot.moving();
    let mut effects = Effects::default();
    for (draft, x) in sized {
        match draft.joint {
            Some(j) => {
                effects.joints.push((rows[j], draft.effect(*x)));
                // A motor behind a spring needs a rotor; it is small, so as not to be a second
                // effect.
                if matches!(draft.cause, EffectKind::JointElasticity | EffectKind::Backlash) {
                    let inertia = 1e-4 * robot.joints[rows[j]].limits.torque.unwrap_or(50.0);
                    effects.joints.push((rows[j], RotorInertia { inertia: Some(inertia) }.into()));
                }
            }
            None => effects.robot.push(draft.effect(*x)),
        }
    }
    effects
}
