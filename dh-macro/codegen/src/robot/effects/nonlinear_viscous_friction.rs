//! Effect `nonlinear_viscous_friction`: `FN |v|^EN sign(v)`, or `FN v / (|v| + VN)`, in several
//! terms.

use super::key::{Description, EffectKey, Field, Key, Keys, Magnitude, Range, Scope};

/// A viscous part that is not in proportion to speed.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct NonlinearViscousFriction {
    /// Terms: the keys without a number, those with 2 appended, and so on. A term without a size is
    /// ignored, except the first.
    pub terms: Vec<ViscousTerm>,
}

/// One term of nonlinear viscous friction.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ViscousTerm {
    /// `FN`, N m (s/rad)^EN: torque at 1 rad/s; N m where the term saturates.
    pub level: Option<f64>,
    /// `EN`: exponent of the speed.
    pub exponent: Option<f64>,
    /// `VN`, rad/s: if greater than 0, the term saturates, and has half of `FN` at this speed.
    pub half: Option<f64>,
}

impl ViscousTerm {
    fn fields(&self) -> [Option<f64>; 3] {
        [self.level, self.exponent, self.half]
    }
}

/// Default torque at 1 rad/s, as a share of the torque limit.
const LEVEL: f64 = 0.015;

/// Default exponent.
const EXPONENT: f64 = 0.5;

/// Most terms that a file can state.
const TERMS: usize = 9;

impl NonlinearViscousFriction {
    /// Name in files and diagnoses.
    pub const NAME: &'static str = "nonlinear_viscous_friction";

    /// Key of `level`: torque at 1 rad/s.
    pub const FN: Key = Key::new("FN");

    /// Key of `exponent`.
    pub const EN: Key = Key::new("EN");

    /// Key of `half`: speed of half of `FN`.
    pub const VN: Key = Key::new("VN");

    /// `FN`, `EN`, `VN` of each term, at a joint with this torque limit, N m.
    #[must_use]
    pub fn terms(&self, rated: f64) -> Vec<[f64; 3]> {
        let first = self.terms.first().copied().unwrap_or_default();
        let exponent = first.exponent.unwrap_or(EXPONENT);
        let further = self
            .terms
            .iter()
            .skip(1)
            .filter_map(|term| Some([term.level?, term.exponent.unwrap_or(exponent), term.half.unwrap_or(0.0)]));
        let first = [first.level.unwrap_or(LEVEL * rated), exponent, first.half.unwrap_or(0.0)];
        core::iter::once(first).chain(further).collect()
    }

    /// Appends the terms of another friction of the same joint, up to the number that a file can
    /// state.
    pub fn extend(&mut self, other: Self) {
        self.terms.extend(other.terms);
        self.terms.truncate(TERMS);
    }
}

impl Keys for NonlinearViscousFriction {
    const DESCRIPTION: Description = Description {
        name: Self::NAME,
        sentence: "A viscous part that is not in proportion to speed.",
        scope: Scope::Joint,
        keys: &[
            key(Self::FN, "N m (s/rad)^EN", Magnitude::OfTorque(LEVEL), Range::SIZE, "torque at 1 rad/s"),
            key(Self::EN, "", Magnitude::Is(EXPONENT), Range::within(0.0, 20.0), "exponent"),
            key(
                Self::VN,
                "rad/s",
                Magnitude::Is(0.0),
                Range::NOT_NEGATIVE,
                "where greater than 0, the law saturates: the speed of half of FN",
            ),
        ],
        repeats: TERMS,
        law: "FN |v|^EN sign(v); with VN, FN v / (|v| + VN)",
        source: "size as viscous_friction, our choice. A column sign(v) sqrt|v| and one of v^3 take 21 % off the residual of the Staubli TX40's joints 1 and 2 (our fit of figaroh's log)",
    };

    fn stated(&self, key: usize, number: usize) -> Option<f64> {
        self.terms.get(number.checked_sub(1)?)?.fields().get(key).copied().flatten()
    }

    fn state(&mut self, key: usize, number: usize, value: f64) -> bool {
        if self.terms.len() < number {
            self.terms.resize(number, ViscousTerm::default());
        }
        let term = number.checked_sub(1).and_then(|k| self.terms.get_mut(k));
        let field = term.and_then(|term| match key {
            0 => Some(&mut term.level),
            1 => Some(&mut term.exponent),
            2 => Some(&mut term.half),
            _ => None,
        });
        field.is_some_and(|field| field.state(value))
    }

    fn numbers(&self) -> usize {
        self.terms.len()
    }
}

const fn key(key: Key, unit: &'static str, magnitude: Magnitude, range: Range, doc: &'static str) -> EffectKey {
    EffectKey { name: key.name(), unit, default: magnitude, omitted: magnitude, count: false, range, doc }
}
