//! `asymmetric_friction`: viscous levels that differ with direction. While the joint moves, a
//! difference of the Coulomb levels alone is a torque offset; see `torque_offset`.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

use super::Hypothesis;
use super::Kind;
use super::Sign;
use super::Term;
use super::moves;
use crate::diagnose::windows::windowed_data::WindowedData;

/// `FVA |v|`, in addition to the offset that is always among the unknowns.
pub struct AsymmetricFriction;

impl Hypothesis for AsymmetricFriction {
    fn effect(&self) -> EffectKind {
        EffectKind::AsymmetricFriction
    }

    fn kind(&self) -> Kind {
        Kind::Friction
    }

    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> bool {
        moves(scene, place[0])
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> Vec<Term> {
        let j = place[0];
        vec![Term::new(effects::AsymmetricFriction::FVA, scene.pointwise(j, |o, k| o.v[k].abs()), Sign::Any)]
    }

    fn has_constant(&self) -> bool {
        true
    }

    fn says(&self) -> &'static str {
        "friction differs between the two directions"
    }

    fn shown_by(&self) -> &'static str {
        "the same speeds forward and backward, and the joint at rest between them"
    }
}
