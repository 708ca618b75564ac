//! `nonlinear_viscous_friction`: the viscous part is not proportional to speed.

use dh_codegen::robot::EffectKind;

use super::Cause;
use super::Kind;
use super::Shape;
use super::Sign;
use super::Term;
use super::moves;
use crate::diagnose::windowed_data::WindowedData;

/// `FN |v|^EN sign(v)`.
pub struct NonlinearViscousFriction;

impl Cause for NonlinearViscousFriction {
    fn effect(&self) -> EffectKind {
        EffectKind::NonlinearViscousFriction
    }

    fn kind(&self) -> Kind {
        Kind::Friction
    }

    fn shape(&self) -> &'static [Shape] {
        &[Shape { symbol: "EN", unit: "", range: [0.2, 5.0], step: Some(0.15) }]
    }

    fn grid(&self, _: &WindowedData<'_>, _: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        [0.4, 0.6, 1.5, 2.0, 3.0].iter().map(|e| vec![*e]).collect()
    }

    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> bool {
        moves(scene, place[0]) && (shape[0] - 1.0).abs() >= 0.05
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let (j, power) = (place[0], shape[0]);
        vec![Term::new("FN", scene.pointwise(j, |o, k| o.sign[k] * o.v[k].abs().powf(power)), Sign::Any)]
    }

    fn says(&self) -> &'static str {
        "the viscous part of friction is not proportional to speed"
    }

    fn shown_by(&self) -> &'static str {
        "constant speeds up to the largest"
    }
}
