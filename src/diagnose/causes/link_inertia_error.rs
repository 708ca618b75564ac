//! `link_inertia_error`: the given inertial parameters of a link are wrong.

use super::super::scene::Scene;
use super::payload::body_terms;
use super::{Cause, Kind, Term};

/// The ten parameters of the joint's link.
pub struct LinkInertiaError;

impl Cause for LinkInertiaError {
    fn name(&self) -> &'static str {
        "link_inertia_error"
    }

    fn kind(&self) -> Kind {
        Kind::Body
    }

    fn terms(&self, scene: &Scene<'_>, place: &[usize], _: &[f64]) -> Vec<Term> {
        body_terms(scene, scene.plant.rows()[place[0]])
    }

    fn within_links(&self) -> bool {
        true
    }

    fn twins(&self, scene: &Scene<'_>, place: &[usize]) -> &'static [&'static str] {
        let last = place.first().is_some_and(|j| j + 1 == scene.dof());
        if last { &["payload"] } else { &[] }
    }

    fn says(&self) -> &'static str {
        "the link's mass, centre of mass or inertia are not what the file says"
    }

    fn shown_by(&self) -> &'static str {
        "an exciting motion for the base parameters of this link"
    }
}
