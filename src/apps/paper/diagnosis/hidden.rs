//! Hidden effects of a case: effects of the vocabulary with drawn shapes, before they have their
//! size, and structure outside the vocabulary.

use dh_codegen::robot::effects::RotorInertia;
use dh_codegen::robot::{Effect, EffectKind, Effects, Robot};

use crate::model::Inertial;
use crate::numerics::prng::Random;

/// An effect in a place, its size still open: a key is `fixed + x * grows`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Draft {
    pub cause: EffectKind,
    /// Joint, from 0; `None`: the whole robot.
    pub joint: Option<usize>,
    /// The other joint of a coupling, from 0.
    pub other: Option<usize>,
    keys: Vec<(String, f64, f64)>,
    /// Start of the search for the size.
    pub start: f64,
    /// Beyond this it is no longer an effect of this kind.
    pub most: f64,
    /// Whether the size is that of the joint's own torque error; otherwise of whichever joint shows
    /// it most.
    pub own: bool,
}

/// An effect with its size.
#[derive(Debug, Clone, PartialEq)]
pub struct Hidden {
    /// Name in the vocabulary; `unknown` for what has none.
    pub cause: &'static str,
    /// Joints, from 1; empty for the whole robot.
    pub joints: Vec<usize>,
    /// Expected parameters of a diagnosis, by symbol, where its law has the same parameter.
    pub truth: Vec<(String, f64)>,
    /// Root mean square of what it does to the torque, by the noise, on the joint that it was made
    /// for.
    pub size: f64,
}

/// An effect that a case hides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wanted {
    /// Of the vocabulary; a delay: of the whole robot.
    Effect(EffectKind),
    /// A delay of one joint alone.
    OneJointLate,
}

impl Wanted {
    /// Effects that are hidden alone.
    pub(super) const ALONE: usize = EffectKind::ALL.len() + 1;

    /// The effect of this number, below [`Wanted::ALONE`].
    pub(super) fn alone(number: usize) -> Self {
        EffectKind::ALL.get(number).map_or(Self::OneJointLate, |kind| Self::Effect(*kind))
    }

    fn kind(self) -> EffectKind {
        match self {
            Self::Effect(kind) => kind,
            Self::OneJointLate => EffectKind::TimeDelay,
        }
    }
}

impl std::fmt::Display for Wanted {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Effect(kind) => kind.fmt(f),
            Self::OneJointLate => write!(f, "{} of one joint", self.kind()),
        }
    }
}

/// Two of these on one joint are two different things.
pub(super) const SAME_JOINT: [[EffectKind; 2]; 6] = [
    [EffectKind::StribeckFriction, EffectKind::TorqueRipple],
    [EffectKind::LoadDependentFriction, EffectKind::JointSpring],
    [EffectKind::PositionDependentFriction, EffectKind::TorqueGainError],
    [EffectKind::PreslidingHysteresis, EffectKind::TorqueOffset],
    [EffectKind::FrictionDrift, EffectKind::TorqueRipple],
    [EffectKind::ViscousFriction, EffectKind::RotorInertia],
];

/// Laws that hide behind other things: on another joint, beside wrong links, in a file without
/// links.
pub(super) const FRICTION: [EffectKind; 7] = [
    EffectKind::StribeckFriction,
    EffectKind::NonlinearViscousFriction,
    EffectKind::LoadDependentFriction,
    EffectKind::PreslidingHysteresis,
    EffectKind::FrictionDrift,
    EffectKind::PositionDependentFriction,
    EffectKind::TorqueRipple,
];

/// Torque scales of a joint in the given model, for sizes that are shares of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct About {
    /// Torque limit, N m.
    pub limit: f64,
    /// Largest torque on the motion, N m.
    pub peak: f64,
    /// Given friction.
    pub viscous: f64,
    pub coulomb: f64,
    pub rotor: f64,
}

impl Draft {
    /// Draws the shape of an effect. `about`: one entry per joint.
    pub fn draw(wanted: Wanted, joint: usize, robot: &Robot, about: &[About], random: &mut Random) -> Self {
        let About { limit, peak, coulomb, .. } = about[joint];
        let sign = if random.chance(0.5) { 1.0 } else { -1.0 };
        let mut other = None;
        let cause = wanted.kind();
        let whole = wanted == Wanted::Effect(EffectKind::TimeDelay) || !cause.description().scope.at_joint();
        type Keys = Vec<(&'static str, f64, f64)>;
        let (keys, start, most, own): (Keys, f64, f64, bool) = match cause {
            EffectKind::ViscousFriction => (vec![("FV", 0.0, 1.0)], 0.01 * limit, f64::MAX, true),
            EffectKind::CoulombFriction => (vec![("FC", 0.0, 1.0)], 0.01 * limit, f64::MAX, true),
            EffectKind::AsymmetricFriction => {
                (vec![("FCA", 0.0, 0.3 * sign), ("FVA", 0.0, sign)], 0.01 * limit, f64::MAX, true)
            }
            EffectKind::StribeckFriction => {
                let (speed, power) = (random.uniform(0.03, 0.15), random.uniform(1.2, 2.2));
                (vec![("FS", coulomb, 1.0), ("VS", speed, 0.0), ("DS", power, 0.0)], 0.01 * limit, f64::MAX, true)
            }
            EffectKind::NonlinearViscousFriction => {
                let power = if random.chance(0.5) { random.uniform(0.35, 0.65) } else { random.uniform(1.7, 2.3) };
                (vec![("FN", 0.0, 1.0), ("EN", power, 0.0)], 0.015 * limit, f64::MAX, true)
            }
            EffectKind::LoadDependentFriction => (vec![("FL", 0.0, 1.0)], 0.08, 0.8, true),
            EffectKind::PreslidingHysteresis => {
                let travel = 4e-3 * 10_f64.powf(random.uniform(0.0, 1.0));
                (vec![("HC", 0.0, 1.0), ("HX", travel, 0.0)], 0.01 * limit, f64::MAX, true)
            }
            EffectKind::FrictionDrift => {
                (vec![("DA", 0.0, 1.0), ("DT", random.uniform(3.0, 10.0), 0.0)], 0.5, 8.0, true)
            }
            EffectKind::PositionDependentFriction => {
                let periods = random.uniform(1.0, 3.5).round();
                let phase = random.uniform(0.0, std::f64::consts::TAU);
                let keys = vec![("PC", 0.0, phase.cos()), ("PS", 0.0, phase.sin()), ("PN", periods, 0.0)];
                (keys, 0.005 * limit, f64::MAX, true)
            }
            EffectKind::RotorInertia => (vec![("IA", 0.0, 1.0)], 0.003 * limit, f64::MAX, true),
            EffectKind::TorqueRipple => {
                let order = random.uniform(12.0, 60.0).round();
                let phase = random.uniform(0.0, std::f64::consts::TAU);
                // A second harmonic of a seventh.
                let keys = vec![
                    ("RN", order, 0.0),
                    ("RC", 0.0, phase.cos()),
                    ("RS", 0.0, phase.sin()),
                    ("RN2", 2.0 * order, 0.0),
                    ("RC2", 0.0, 0.15),
                ];
                (keys, 0.006 * limit, f64::MAX, true)
            }
            EffectKind::JointElasticity => {
                (vec![("KE", 0.0, 1.0), ("DE", 0.1 * limit, 0.0)], 1.0 / (60.0 * limit), 0.08 / peak, false)
            }
            EffectKind::Backlash => (vec![("BL", 0.0, 1.0)], 1e-3, 0.05, false),
            EffectKind::GearCoupling => {
                let k = if joint == 0 { 1 } else { joint - 1 };
                other = Some(k);
                let row = (robot.moving()[k] + 1) as f64;
                (
                    vec![("joint", row, 0.0), ("KC", sign, 0.0), ("FVM", 0.0, 0.6), ("FCM", 0.0, 1.0)],
                    0.01 * limit,
                    f64::MAX,
                    true,
                )
            }
            EffectKind::TorqueGainError => (vec![("GT", 1.0, sign)], 0.05, 0.6, true),
            EffectKind::TorqueOffset => (vec![("TO", 0.0, sign)], 0.01 * limit, f64::MAX, true),
            EffectKind::TorqueSaturation => (vec![("TM", peak, -peak)], 0.1, 0.6, true),
            EffectKind::EncoderOffset => (vec![("QO", 0.0, sign)], 0.01, 0.3, false),
            EffectKind::GeometricError => {
                let key = ["DALPHA", "DD", "DR"][random.below(3)];
                (vec![(key, 0.0, sign)], 0.01, 0.25, false)
            }
            EffectKind::LinkInertiaError => {
                let row = robot.moving()[joint];
                let link = robot.inertias().and_then(|l| l.get(row).copied());
                let values = link.map_or([0.0; 10], |l| l.to_array());
                let names = Inertial::ALL.map(Inertial::name);
                let keys = names.into_iter().zip(values).map(|(n, v)| (n, 0.0, sign * v)).collect();
                (keys, 0.1, 0.9, false)
            }
            EffectKind::Payload => {
                let (x, z) = (random.uniform(-0.05, 0.05), random.uniform(0.05, 0.15));
                let tensor = [z * z + 1e-3, x * x + z * z + 1e-3, x * x + 1e-3];
                let keys = vec![
                    ("M", 0.0, 1.0),
                    ("MSX", 0.0, x),
                    ("MSZ", 0.0, z),
                    ("XX", 0.0, tensor[0]),
                    ("YY", 0.0, tensor[1]),
                    ("ZZ", 0.0, tensor[2]),
                    ("XZ", 0.0, -x * z),
                ];
                (keys, 0.2, 30.0, false)
            }
            EffectKind::BaseTilt => {
                let turn = random.uniform(0.0, std::f64::consts::TAU);
                (vec![("roll", 0.0, turn.cos()), ("pitch", 0.0, turn.sin())], 0.01, 0.4, false)
            }
            EffectKind::JointSpring => {
                (vec![("KS", 0.0, 1.0), ("QS", random.uniform(-0.5, 0.5), 0.0)], 0.02 * limit, f64::MAX, true)
            }
            EffectKind::ExternalContact => {
                let begin = random.uniform(2.0, 5.0);
                let end = begin + random.uniform(0.8, 2.0);
                let keys = vec![
                    ("start", begin, 0.0),
                    ("end", end, 0.0),
                    ("fx", 0.0, random.uniform(-1.0, 1.0)),
                    ("fy", 0.0, random.uniform(-1.0, 1.0)),
                    ("fz", 0.0, sign),
                ];
                (keys, 5.0, 500.0, false)
            }
            EffectKind::TimeDelay => (vec![("TD", 0.0, 1.0)], 5e-3, 0.08, true),
        };
        let keys = keys.into_iter().map(|(k, fixed, grows)| (k.to_string(), fixed, grows)).collect();
        Self { cause, joint: (!whole).then_some(joint), other, keys, start, most, own }
    }

    /// Whether its torque on a given motion is in proportion to the size.
    pub fn linear(&self) -> bool {
        self.own && !matches!(self.cause, EffectKind::TorqueSaturation | EffectKind::TimeDelay)
    }

    /// Its keys at this size.
    fn values(&self, x: f64) -> Vec<(String, f64)> {
        let value = |(key, fixed, grows): &(String, f64, f64)| match key.as_str() {
            // A stiffness: the effect grows with what it gives way.
            "KE" => (key.clone(), 1.0 / x),
            _ => (key.clone(), fixed + x * grows),
        };
        self.keys.iter().map(value).collect()
    }

    /// The effect at this size.
    pub fn effect(&self, x: f64) -> Effect {
        let effect = Effect::of_kind(self.cause, &self.values(x));
        effect.unwrap_or_else(|error| unreachable!("a draft has the keys of its effect: {error}"))
    }

    /// Expected result of a diagnosis.
    pub fn hidden(&self, x: f64, about: &[About], size: f64) -> Hidden {
        let suffix = self.joint.map(|j| (j + 1).to_string()).unwrap_or_default();
        let given = |key: &str| {
            let about = self.joint.map(|j| about[j]);
            about.map_or(0.0, |a| match key {
                "FV" => a.viscous,
                "FC" => a.coulomb,
                "IA" => a.rotor,
                _ => 0.0,
            })
        };
        // Phases go with an order that is estimated too; the power of a law that has another
        // exponent is another number.
        let skip = [
            "RN", "RC", "RS", "RN2", "RC2", "PC", "PS", "PN", "FN", "EN", "VS", "DS", "DA", "DT", "joint", "KC", "QS",
            "start", "end", "HX",
        ];
        let truth = self.values(x).into_iter().filter(|(k, _)| !skip.contains(&k.as_str()));
        let truth = truth.map(|(k, v)| (format!("{k}{suffix}"), v + given(&k))).collect();
        Hidden {
            cause: self.cause.name(),
            joints: self.joint.into_iter().chain(self.other).map(|j| j + 1).collect(),
            truth,
            size,
        }
    }
}

/// Effects for the simulator.
pub(super) fn effects(robot: &Robot, sized: &[(Draft, f64)]) -> Effects {
    let rows = robot.moving();
    let mut effects = Effects::default();
    for (draft, x) in sized {
        match draft.joint {
            Some(j) => {
                effects.joints.push((rows[j], draft.effect(*x)));
                // A motor behind a spring needs a rotor; one that is hardly felt, lest it be a
                // second effect.
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

/// Structure outside the vocabulary, added to the recorded torque of one joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Outside {
    /// A tone in time, Hz and phase.
    Tone(f64, f64),
    /// Cross talk from another joint's torque sensor.
    CrossTalk(usize),
    /// The sensor's zero wanders: four slow waves with these phases.
    Wander([f64; 4]),
}

impl Outside {
    pub fn draw(which: usize, joint: usize, dof: usize, random: &mut Random) -> Self {
        let mut phase = || random.uniform(0.0, std::f64::consts::TAU);
        match which % 3 {
            0 => {
                let phase = phase();
                Self::Tone(random.uniform(0.6, 3.0), phase)
            }
            1 => Self::CrossTalk((joint + 1 + random.below(dof - 1)) % dof),
            _ => Self::Wander([phase(), phase(), phase(), phase()]),
        }
    }

    /// At unit size or so.
    pub fn series(&self, t: &[f64], tau: impl Fn(usize) -> Vec<f64>) -> Vec<f64> {
        let turn = std::f64::consts::TAU;
        match *self {
            Self::Tone(frequency, phase) => t.iter().map(|t| (turn * frequency * t + phase).sin()).collect(),
            Self::CrossTalk(other) => tau(other),
            Self::Wander(phases) => {
                let wave = |t: f64| {
                    let waves = phases.iter().enumerate();
                    waves.map(|(k, p)| (turn * [0.031, 0.067, 0.13, 0.24][k] * t + p).sin()).sum::<f64>()
                };
                t.iter().map(|&t| wave(t)).collect()
            }
        }
    }
}
