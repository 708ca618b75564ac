//! `joint_spring`: an elastic torque in the joint's angle (gravity spring, cable, hose).

use dh_codegen::robot::EffectKind;

use super::Cause;
use super::Estimate;
use super::Kind;
use super::Named;
use super::Sign;
use super::Term;
use super::moves;
use crate::diagnose::windowed_data::WindowedData;

/// `KS (q - QS)`; the constant part is among the unknowns anyway.
pub struct JointSpring;

impl Cause for JointSpring {
    fn effect(&self) -> EffectKind {
        EffectKind::JointSpring
    }

    fn kind(&self) -> Kind {
        Kind::Outside
    }

    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> bool {
        moves(scene, place[0])
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> Vec<Term> {
        let j = place[0];
        vec![Term::new("KS", scene.pointwise(j, |o, k| o.q[k]), Sign::Any)]
    }

    fn has_constant(&self) -> bool {
        true
    }

    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        let (stiffness, [_, _, offset]) = (found.x[0], found.levels);
        vec![
            found.term(0),
            Named::new("QS", if stiffness == 0.0 || offset == 0.0 { 0.0 } else { -offset / stiffness }, None),
        ]
    }

    fn says(&self) -> &'static str {
        "an elastic torque in proportion to the joint's angle"
    }

    fn shown_by(&self) -> &'static str {
        "static poses over the whole travel of the joint"
    }
}
