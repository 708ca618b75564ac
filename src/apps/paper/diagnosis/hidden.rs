//! What a case hides: effects of the vocabulary with their sizes, and structure outside it.

use dh_codegen::robot::EffectKind;

use crate::numerics::prng::Random;

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

    pub(super) fn kind(self) -> EffectKind {
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
pub(super) struct JointScales {
    /// Torque limit, N m.
    pub limit: f64,
    /// Largest torque on the motion, N m.
    pub peak: f64,
    /// Given friction.
    pub viscous: f64,
    pub coulomb: f64,
    pub rotor: f64,
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
