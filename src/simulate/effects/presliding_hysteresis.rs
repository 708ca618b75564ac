//! `presliding_hysteresis`: the bristle of LuGre (C. Canudas de Wit, H. Olsson, K. J. Astrom and P.
//! Lischinsky, *A new model for control of systems with friction*, IEEE Trans. Automatic Control
//! 40, 1995), whose undamped form is Dahl's.

use dh_codegen::robot::effects;

/// Friction with hysteresis near reversals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PreslidingHysteresis {
    /// `HC`, N m.
    pub level: f64,
    /// `HX`, rad: the bristle's stiffness is `HC / HX`.
    pub travel: f64,
}

impl PreslidingHysteresis {
    pub(crate) fn new(stated: &effects::PreslidingHysteresis, rated: f64) -> Self {
        Self { level: stated.level(rated), travel: stated.travel() }
    }
}
