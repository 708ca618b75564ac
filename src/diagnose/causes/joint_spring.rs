//! `joint_spring`: an elastic torque in the joint's angle (gravity spring, cable, hose).

use super::super::scene::Scene;
use super::{Cause, Kind, Sign, Term, moves};

/// `KS (q - QS)`; the constant part is among the unknowns anyway.
pub struct JointSpring;

impl Cause for JointSpring {
    fn name(&self) -> &'static str {
        "joint_spring"
    }

    fn kind(&self) -> Kind {
        Kind::Outside
    }

    fn terms(&self, scene: &Scene<'_>, place: &[usize], _: &[f64]) -> Vec<Term> {
        let j = place[0];
        if !moves(scene, j) {
            return Vec::new();
        }
        vec![Term::new("KS", scene.pointwise(j, |o, k| o.q[k]), Sign::Any)]
    }

    fn has_constant(&self) -> bool {
        true
    }

    fn says(&self) -> &'static str {
        "an elastic torque in proportion to the joint's angle"
    }

    fn shown_by(&self) -> &'static str {
        "static poses over the whole travel of the joint"
    }
}
