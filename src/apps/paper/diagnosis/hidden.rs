//! Hidden content of a case: effects of the vocabulary with their sizes, and structure outside it.

use dh_codegen::robot::EffectKind;

use crate::numerics::prng::Random;

/// A hidden effect with its size.
#[derive(Debug, Clone, PartialEq)]
pub struct Hidden {
    /// Name in the vocabulary; `unknown` for structure outside it.
    pub cause: &'static str,
    /// Joints, from 1; empty for the whole robot.
    pub joints: Vec<usize>,
    /// Expected parameters of a diagnosis by symbol, where its law has the same parameter.
    pub truth: Vec<(String, f64)>,
    /// Root mean square of its effect on the torque relative to the noise, on the joint that it was
    /// sized for.
    pub size: f64,
}

/// An effect that a case hides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wanted {
    /// An effect of the vocabulary; a delay acts on the whole robot.
    Effect(EffectKind),
    /// A delay of a single joint.
    OneJointLate,
}

impl Wanted {
    /// Number of effects that are hidden alone.
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

/// Pairs of effects that are distinguishable on one joint.
pub(super) const SAME_JOINT: [[EffectKind; 2]; 6] = [
    [EffectKind::StribeckFriction, EffectKind::TorqueRipple],
    [EffectKind::LoadDependentFriction, EffectKind::JointSpring],
    [EffectKind::PositionDependentFriction, EffectKind::TorqueGainError],
    [EffectKind::PreslidingHysteresis, EffectKind::TorqueOffset],
    [EffectKind::FrictionDrift, EffectKind::TorqueRipple],
    [EffectKind::ViscousFriction, EffectKind::RotorInertia],
];

/// Laws that are hidden together with something else: a second joint, wrong links, a file without
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

/// Torque scales of a joint in the given model; sizes of effects are shares of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct JointScales {
    /// Torque limit, N m.
    pub limit: f64,
    /// Largest torque on the motion, N m.
    pub peak: f64,
    /// Given friction: `viscous`, N m s/rad, and `coulomb`, N m; `rotor` inertia, kg m^2.
    pub viscous: f64,
    pub coulomb: f64,
    pub rotor: f64,
}

/// Structure outside the vocabulary, added to the recorded torque of one joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Outside {
    /// A sine in time: frequency, Hz, and phase.
    Tone(f64, f64),
    /// Cross talk from another joint's torque sensor.
    CrossTalk(usize),
    /// Drift of the sensor's zero: four slow waves with these phases.
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

    /// Time series with an amplitude of about 1.
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
