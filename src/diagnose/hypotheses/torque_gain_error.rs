//! `torque_gain_error`: the measured torque of a joint has a wrong scale.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

use super::Estimate;
use super::Hypothesis;
use super::Kind;
use super::Named;
use super::Over;
use super::Sign;
use super::Term;
use crate::diagnose::windows::windowed_data::{Column, WindowedData};

/// `(GT - 1) tau`.
pub struct TorqueGainError;

impl Hypothesis for TorqueGainError {
    fn effect(&self) -> EffectKind {
        EffectKind::TorqueGainError
    }

    fn kind(&self) -> Kind {
        Kind::Measurement
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> Vec<Term> {
        let j = place[0];
        let mut series = scene.whole[j].to_vec();
        scene.masked(j, &mut series);
        if series.iter().all(|t| *t == 0.0) {
            return Vec::new();
        }
        vec![Term::new(effects::TorqueGainError::GT, Column::on(j, series), Sign::Any)]
    }

    fn rests_on_model(&self) -> bool {
        true
    }

    fn rests_on_friction(&self) -> bool {
        true
    }

    /// A torque that hardly correlates with the arm's is not a scaled one.
    fn plausible(&self, _: &WindowedData<'_>, _: &[usize], _: &[f64], x: &[f64]) -> bool {
        x.first().is_none_or(|x| (-0.7..2.0).contains(x))
    }

    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        vec![Named::new(effects::TorqueGainError::GT, 1.0 + found.x[0], Some(found.std(0)))]
    }

    fn over(&self) -> Over {
        Over::Torque
    }

    fn says(&self) -> &'static str {
        "the measured torque is the true one times a factor"
    }

    fn shown_by(&self) -> &'static str {
        "a known weight held at several lever arms"
    }
}
