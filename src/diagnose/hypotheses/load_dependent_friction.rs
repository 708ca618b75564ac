//! `load_dependent_friction`: friction grows with the torque that the gear transmits.

use dh_codegen::robot::EffectKind;

use super::Cause;
use super::Kind;
use super::Over;
use super::Sign;
use super::Term;
use super::moves;
use crate::diagnose::windowed_data::WindowedData;

/// `FL |tau_load| sign(v)`.
pub struct LoadDependentFriction;

impl Cause for LoadDependentFriction {
    fn effect(&self) -> EffectKind {
        EffectKind::LoadDependentFriction
    }

    fn kind(&self) -> Kind {
        Kind::Friction
    }

    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> bool {
        moves(scene, place[0])
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> Vec<Term> {
        let j = place[0];
        vec![Term::new("FL", scene.pointwise(j, |o, k| o.sign[k] * o.load[k].abs()), Sign::Positive)]
    }

    fn rests_on_model(&self) -> bool {
        true
    }

    fn over(&self) -> Over {
        Over::Torque
    }

    fn says(&self) -> &'static str {
        "friction grows with the transmitted torque"
    }

    fn shown_by(&self) -> &'static str {
        "the same speeds with and without a payload, or in stretched and in folded postures"
    }
}
