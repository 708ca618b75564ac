//! An effect as it was written, with the values of the keys that were not.

use super::Effect;
use super::effect::{Law, Magnitude};

/// Torque limit where the robot file gives none, N m.
pub const RATED: f64 = 100.0;

/// Reads an effect's keys.
#[derive(Debug, Clone, Copy)]
pub struct Given<'a> {
    effect: &'a Effect,
    /// The joint's torque limit, N m: what default magnitudes are parts of.
    pub rated: f64,
}

impl<'a> Given<'a> {
    /// An effect at a joint with this torque limit.
    pub fn new(effect: &'a Effect, rated: Option<f64>) -> Self {
        Self { effect, rated: rated.unwrap_or(RATED) }
    }

    /// What was written behind a key.
    pub fn stated(&self, key: &str) -> Option<f64> {
        self.effect.parameters.iter().find(|(name, _)| name == key).map(|(_, value)| *value)
    }

    /// Whether nothing but the name was written.
    pub fn is_bare(&self) -> bool {
        self.effect.parameters.is_empty()
    }

    /// What was written, or the table's value; 0 where that is for the reader to derive.
    pub fn get(&self, key: &str) -> f64 {
        if let Some(value) = self.stated(key) {
            return value;
        }
        let known = Law::of(&self.effect.name).and_then(|law| law.key(key));
        match known.map(|k| if self.is_bare() { k.default } else { k.omitted }) {
            Some(Magnitude::Is(value)) => value,
            Some(Magnitude::OfTorque(part)) => part * self.rated,
            Some(Magnitude::Derived | Magnitude::Needed) | None => 0.0,
        }
    }

    /// The ten parameters of a body.
    pub fn body(&self) -> [f64; 10] {
        ["M", "MSX", "MSY", "MSZ", "XX", "YY", "ZZ", "XY", "XZ", "YZ"].map(|key| self.get(key))
    }
}
