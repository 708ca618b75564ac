//! `rotor_inertia`: reflected inertia of the drive.

use super::super::scene::Scene;
use super::{Cause, Kind, Sign, Term, moves};

/// `IA ddq`.
pub struct RotorInertia;

impl Cause for RotorInertia {
    fn name(&self) -> &'static str {
        "rotor_inertia"
    }

    fn kind(&self) -> Kind {
        Kind::Body
    }

    fn terms(&self, scene: &Scene<'_>, place: &[usize], _: &[f64]) -> Vec<Term> {
        let j = place[0];
        if !moves(scene, j) {
            return Vec::new();
        }
        vec![Term::new("IA", scene.pointwise(j, |o, k| o.a[k]), Sign::Any)]
    }

    fn says(&self) -> &'static str {
        "the torque has a part in proportion to the joint's own acceleration that the given model lacks or has wrong"
    }

    fn shown_by(&self) -> &'static str {
        "high accelerations of this joint alone"
    }
}
