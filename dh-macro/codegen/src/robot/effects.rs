//! Effects beyond the rigid body, one type each: fields, keys, units, ranges, scope, defaults.
//!
//! A law is *added* to the torque of the rigid model, where `tau` is the torque of the actuator on
//! the link. For a prismatic joint read N for N m, and m for rad. The types are pure data:
//! generated code, simulator and diagnosis have separate laws.

mod asymmetric_friction;
mod backlash;
mod base_tilt;
mod coulomb_friction;
mod encoder_offset;
mod external_contact;
mod friction_drift;
mod gear_coupling;
mod geometric_error;
mod joint_elasticity;
mod joint_spring;
mod key;
mod link_inertia_error;
mod load_dependent_friction;
mod nonlinear_viscous_friction;
mod payload;
mod position_dependent_friction;
mod presliding_hysteresis;
mod rotor_inertia;
mod stribeck_friction;
mod time_delay;
mod torque_gain_error;
mod torque_offset;
mod torque_ripple;
mod torque_saturation;
mod viscous_friction;

pub use asymmetric_friction::AsymmetricFriction;
pub use backlash::Backlash;
pub use base_tilt::BaseTilt;
pub use coulomb_friction::CoulombFriction;
pub use encoder_offset::EncoderOffset;
pub use external_contact::ExternalContact;
pub use friction_drift::FrictionDrift;
pub use gear_coupling::GearCoupling;
pub use geometric_error::GeometricError;
pub use joint_elasticity::JointElasticity;
pub use joint_spring::JointSpring;
pub use key::{Description, EffectKey, Key, Magnitude, Range, Scope};
pub use link_inertia_error::LinkInertiaError;
pub use load_dependent_friction::LoadDependentFriction;
pub use nonlinear_viscous_friction::{NonlinearViscousFriction, ViscousTerm};
pub use payload::Payload;
pub use position_dependent_friction::PositionDependentFriction;
pub use presliding_hysteresis::PreslidingHysteresis;
pub use rotor_inertia::RotorInertia;
pub use stribeck_friction::StribeckFriction;
pub use time_delay::TimeDelay;
pub use torque_gain_error::TorqueGainError;
pub use torque_offset::TorqueOffset;
pub use torque_ripple::{RippleOrder, TorqueRipple};
pub use torque_saturation::TorqueSaturation;
pub use viscous_friction::ViscousFriction;

use key::Keys;

/// Torque limit of a joint if the robot file gives none, N m.
pub const RATED: f64 = 100.0;

/// Defines the enums of all effects, in the vocabulary's order.
macro_rules! vocabulary {
    ($($Type:ident)+) => {
        /// An effect as a file states it.
        #[derive(Debug, Clone, PartialEq)]
        pub enum Effect {
            $(#[doc = concat!("See [`", stringify!($Type), "`].")] $Type($Type),)+
        }

        /// The effect.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum EffectKind {
            $(#[doc = concat!("See [`", stringify!($Type), "`].")] $Type,)+
        }

        impl EffectKind {
            /// All of them, in the order of the documents.
            pub const ALL: &'static [Self] = &[$(Self::$Type),+];

            /// Its name in files and diagnoses.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$Type => $Type::NAME,)+
                }
            }

            /// Description of the effect's type.
            #[must_use]
            pub fn description(self) -> &'static Description {
                match self {
                    $(Self::$Type => &<$Type as Keys>::DESCRIPTION,)+
                }
            }

            /// The effect with nothing stated.
            fn bare(self) -> Effect {
                match self {
                    $(Self::$Type => Effect::$Type($Type::default()),)+
                }
            }
        }

        impl Effect {
            /// Kind of the effect.
            #[must_use]
            pub fn kind(&self) -> EffectKind {
                match self {
                    $(Self::$Type(_) => EffectKind::$Type,)+
                }
            }

            fn value(&self, key: usize, number: usize) -> Option<f64> {
                match self {
                    $(Self::$Type(effect) => Keys::stated(effect, key, number),)+
                }
            }

            fn state(&mut self, key: usize, number: usize, value: f64) -> bool {
                match self {
                    $(Self::$Type(effect) => Keys::state(effect, key, number, value),)+
                }
            }

            fn numbers(&self) -> usize {
                match self {
                    $(Self::$Type(effect) => Keys::numbers(effect),)+
                }
            }
        }

        $(
            impl From<$Type> for Effect {
                fn from(effect: $Type) -> Self {
                    Self::$Type(effect)
                }
            }
        )+
    };
}

vocabulary! {
    ViscousFriction
    CoulombFriction
    AsymmetricFriction
    StribeckFriction
    NonlinearViscousFriction
    LoadDependentFriction
    PreslidingHysteresis
    FrictionDrift
    PositionDependentFriction
    RotorInertia
    TorqueRipple
    JointElasticity
    Backlash
    GearCoupling
    TorqueGainError
    TorqueOffset
    TorqueSaturation
    EncoderOffset
    GeometricError
    LinkInertiaError
    Payload
    BaseTilt
    JointSpring
    ExternalContact
    TimeDelay
}

/// Reason why names and numbers do not define an effect.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum EffectError {
    /// The name is not in the vocabulary.
    #[error("`{0}` is not an effect")]
    Unknown(String),
    /// The key does not belong to the effect.
    #[error("`{key}` is not a key of {effect}; its keys are {}", effect.description().keys_in_words())]
    Key {
        /// Effect that was stated.
        effect: EffectKind,
        /// Key as given.
        key: String,
    },
    /// A required key is missing.
    #[error("{effect} needs the key `{key}`")]
    Missing {
        /// Effect that was stated.
        effect: EffectKind,
        /// Name of the missing key.
        key: &'static str,
    },
    /// The number of a joint or link is invalid.
    #[error("{key} of {effect} is {value}; joints and links are numbered from 1")]
    Number {
        /// Effect that was stated.
        effect: EffectKind,
        /// Name of the key.
        key: &'static str,
        /// Value as given.
        value: f64,
    },
}

/// A value outside the range of its key.
#[derive(Debug, Clone, PartialEq)]
pub struct OutOfRange {
    /// Name of the key, with its number if keys repeat.
    pub key: String,
    /// Value as stated.
    pub value: f64,
    /// Condition on the value: `be greater than 0`.
    pub must: String,
}

impl core::fmt::Display for EffectKind {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.name())
    }
}

impl EffectKind {
    /// Effect with this name.
    #[must_use]
    pub fn of(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|kind| kind.name() == name)
    }

    /// Whether it is rotor inertia or plain friction, which a robot file states as parameters of
    /// the drive itself. In a file of effects it adds to them, and the sum must lie in the range of
    /// its key.
    #[must_use]
    pub fn is_plain(self) -> bool {
        matches!(self, Self::ViscousFriction | Self::CoulombFriction | Self::RotorInertia)
    }
}

impl Effect {
    /// Effect with this name and these values of its keys.
    ///
    /// # Errors
    /// If name or key is unknown, a key is missing, or a number is no joint or link. Ranges are not
    /// checked: see [`Effect::out_of_range`].
    pub fn from_keys<K: AsRef<str>>(name: &str, keys: &[(K, f64)]) -> Result<Self, EffectError> {
        let kind = EffectKind::of(name).ok_or_else(|| EffectError::Unknown(name.to_string()))?;
        Self::of_kind(kind, keys)
    }

    /// Variant of [`Effect::from_keys`] for a known effect.
    ///
    /// # Errors
    /// See [`Effect::from_keys`].
    pub fn of_kind<K: AsRef<str>>(kind: EffectKind, keys: &[(K, f64)]) -> Result<Self, EffectError> {
        let mut effect = kind.bare();
        for (key, value) in keys {
            effect.set(key.as_ref(), *value)?;
        }
        let description = kind.description();
        let needed = description.keys.iter().enumerate().filter(|(_, key)| key.omitted == Magnitude::Needed);
        match needed.clone().find(|(k, _)| effect.value(*k, 1).is_none()) {
            Some((_, key)) => Err(EffectError::Missing { effect: kind, key: key.name }),
            None => Ok(effect),
        }
    }

    /// Name of the effect in files and diagnoses.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.kind().name()
    }

    /// Value stated for a key.
    #[must_use]
    pub fn get(&self, key: &str) -> Option<f64> {
        let (key, number) = self.kind().description().place(key)?;
        self.value(key, number)
    }

    /// Sets the value of a key.
    ///
    /// # Errors
    /// If the effect has no such key, or the number is no joint or link.
    pub fn set(&mut self, key: &str, value: f64) -> Result<(), EffectError> {
        let effect = self.kind();
        let description = effect.description();
        let place = description.place(key);
        let (at, number) = place.ok_or_else(|| EffectError::Key { effect, key: key.to_string() })?;
        let stated = self.state(at, number, value);
        let name = description.keys[at].name;
        if stated { Ok(()) } else { Err(EffectError::Number { effect, key: name, value }) }
    }

    /// Stated keys with their values, in the table's order.
    #[must_use]
    pub fn stated(&self) -> Vec<(String, f64)> {
        let keys = self.kind().description().keys;
        let numbered = (1..=self.numbers()).flat_map(|number| (0..keys.len()).map(move |key| (key, number)));
        let named = |key: usize, number: usize| match number {
            1 => keys[key].name.to_string(),
            _ => format!("{}{number}", keys[key].name),
        };
        numbered.filter_map(|(key, number)| Some((named(key, number), self.value(key, number)?))).collect()
    }

    /// First stated value that is outside the range of its key.
    #[must_use]
    pub fn out_of_range(&self) -> Option<OutOfRange> {
        let description = self.kind().description();
        self.stated().into_iter().find_map(|(key, value)| {
            let known = description.key(&key).filter(|known| !known.range.holds(value))?;
            Some(OutOfRange { key, value, must: known.range.words(known.unit) })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_type_is_complete() {
        assert_eq!(EffectKind::ALL.len(), 25);
        for &kind in EffectKind::ALL {
            let Description { name, sentence, keys, law, source, .. } = *kind.description();
            assert_eq!(EffectKind::of(name), Some(kind));
            assert!(!keys.is_empty() && !source.is_empty() && !law.is_empty(), "{name}");
            assert!(sentence.trim().ends_with('.') && !sentence.trim().contains(". "), "{name}: {sentence}");
            for key in keys {
                for default in [key.default, key.omitted] {
                    if let Magnitude::Is(value) | Magnitude::OfTorque(value) = default {
                        assert!(key.range.holds(value), "{name}: default of {} outside its range", key.name);
                    }
                }
            }
        }
    }

    #[test]
    fn every_key_is_a_field_of_its_own() {
        for &kind in EffectKind::ALL {
            let description = kind.description();
            let values: Vec<(String, f64)> = (1..=description.repeats)
                .flat_map(|n| description.keys.iter().map(move |key| (key.name, n)))
                .enumerate()
                .map(|(k, (name, n))| (if n == 1 { name.to_string() } else { format!("{name}{n}") }, (k + 1) as f64))
                .collect();
            let effect = Effect::of_kind(kind, &values).unwrap();
            assert_eq!(effect.stated(), values, "{kind}");
            assert!(values.iter().all(|(key, value)| effect.get(key) == Some(*value)), "{kind}");
        }
    }

    #[test]
    fn a_default_is_what_the_table_says() {
        let bare = PositionDependentFriction::default();
        assert_eq!([bare.cosine(50.0), bare.sine(50.0), bare.periods()], [0.2, 0.15, 1.0]);
        let stated = PositionDependentFriction { sine: Some(0.7), ..bare };
        assert_eq!([stated.cosine(50.0), stated.sine(50.0), stated.periods()], [0.0, 0.7, 1.0]);
        let keys = EffectKind::PositionDependentFriction.description().keys;
        assert_eq!((keys[0].default, keys[0].omitted), (Magnitude::OfTorque(0.004), Magnitude::Is(0.0)));
        assert_eq!((keys[2].default, keys[2].omitted), (Magnitude::Is(1.0), Magnitude::Is(1.0)));
        let ripple = TorqueRipple::default().waves(100.0, Some(-160.0));
        assert_eq!(ripple, [[160.0, 0.6, 0.3]]);
    }

    #[test]
    fn what_is_no_effect_has_an_error() {
        let of = |name: &str, keys: &[(&str, f64)]| Effect::from_keys(name, keys).map_err(|e| e.to_string());
        assert_eq!(of("stiction", &[]).unwrap_err(), "`stiction` is not an effect");
        let keys = of("backlash", &[("BL2", 1e-3)]).unwrap_err();
        assert_eq!(keys, "`BL2` is not a key of backlash; its keys are BL (rad)");
        assert_eq!(of("gear_coupling", &[("KC", 1.0)]).unwrap_err(), "gear_coupling needs the key `joint`");
        let number = of("gear_coupling", &[("joint", 1.5)]).unwrap_err();
        assert_eq!(number, "joint of gear_coupling is 1.5; joints and links are numbered from 1");
        let ripple = EffectKind::TorqueRipple.description();
        assert_eq!(ripple.key("RC3").map(|key| key.name), Some("RC"));
        for key in ["RC0", "RC1", "RC03", "RC10", "RX", "RX2", "2"] {
            assert!(ripple.key(key).is_none(), "{key}");
        }
    }

    #[test]
    fn ranges_are_those_of_physics() {
        let must = |name: &str, key: &str, value: f64| {
            let effect = Effect::from_keys(name, &[(key, value)]).unwrap();
            effect.out_of_range().map(|out| out.must)
        };
        assert_eq!(must("load_dependent_friction", "FL", 0.0), None);
        let locks = "be from 0 to less than 1: beyond, the gear locks";
        assert_eq!(must("load_dependent_friction", "FL", 1.0).unwrap(), locks);
        assert_eq!(must("load_dependent_friction", "FL", -0.1).unwrap(), locks);
        assert_eq!(must("stribeck_friction", "VS", 0.0).unwrap(), "be greater than 0");
        assert_eq!(must("stribeck_friction", "DS", 21.0).unwrap(), "be greater than 0, and at most 20");
        assert_eq!(must("torque_offset", "TO", f64::NAN).unwrap(), "be a finite number");
        let identified = |kind: EffectKind, key: &str, value: f64| {
            kind.description().key(key).unwrap().range.may_be_identified(value)
        };
        // A size from poor data may be negative; without a valid shape the law has no value.
        assert!(identified(EffectKind::StribeckFriction, "FS", -0.3));
        assert!(!identified(EffectKind::StribeckFriction, "VS", 0.0));
        assert!(identified(EffectKind::LoadDependentFriction, "FL", -0.2));
        assert!(!identified(EffectKind::LoadDependentFriction, "FL", -1.0));
    }
}
