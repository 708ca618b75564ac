//! Drives that remember: friction that depends on the travel since the last reversal, and on time and temperature. Shipped verbatim into
//! crates whose robot file has effects; the interpreter uses the same text.

use super::elementary::Real;

/// What one joint's drive remembers by; a travel of 0 is no bristle, a time of 0 no drift.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Memory {
    /// `HX`: the travel in which a bristle bends to 1 - 1/e of its level, rad or m.
    pub travel: f64,
    /// `DA`: what cold friction has more than warm friction, as a part of the latter.
    pub cold: f64,
    /// `DT`: time constant of the warming, s.
    pub time: f64,
    /// `DK`: change per kelvin.
    pub per_kelvin: f64,
    /// `T0`: temperature at which `per_kelvin` does nothing, degrees C.
    pub reference: f64,
}

impl Memory {
    /// Of a bristle that stood at `bristle`, after the joint went by `by`: Dahl's `dz/dt = (v / HX)(1 - z sign v)`, solved exactly.
    #[must_use]
    #[inline]
    pub fn bent<S: Real>(&self, bristle: S, by: S) -> S {
        let end = by.sign();
        if self.travel > 0.0 { end + (bristle - end) * (-(by.abs() / S::constant(self.travel))).exp() } else { end }
    }

    /// Factor of the friction `since` seconds after the start at `temperature`, degrees C; never less than 0.
    #[must_use]
    #[inline]
    pub fn warmth<S: Real>(&self, since: S, temperature: S) -> S {
        if !(self.time > 0.0) {
            return S::constant(1.0);
        }
        let cold = (-(since / S::constant(self.time))).exp() * S::constant(self.cold);
        let heat = (temperature - S::constant(self.reference)) * S::constant(self.per_kelvin);
        (S::constant(1.0) + cold + heat).max(S::default())
    }
}
