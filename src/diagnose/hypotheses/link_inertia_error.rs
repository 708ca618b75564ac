//! `link_inertia_error`: the inertial parameters of a link in the file are wrong.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

use super::Hypothesis;
use super::Kind;
use super::Law;
use super::Symbol;
use super::Term;
use super::payload::{Payload, arm_mass, body_terms};
use super::point_mass::POINT_LINK;
use super::rotor_inertia::{DATA_SHEET, shows_as_a_rotor};
use crate::diagnose::fit::regulariser::deviations;
use crate::diagnose::windows::windowed_data::WindowedData;
use crate::model::{Inertial, StandardParameter};

/// Largest change of a link's mass relative to the mass of the arm: light arms carry a third to a
/// half of their mass, and what is mounted on a link is part of it.
const MOUNTED: f64 = 0.5;

/// Whether the change of a link's mass among the coefficients `x` is at most the mass that the arm
/// carries, or the link's mass in the file. Without a mass in the file everything is plausible.
pub(super) fn plausible_mass(scene: &WindowedData<'_>, place: &[usize], x: &[f64]) -> bool {
    let mass = || {
        let at = 10 * scene.plant.rows().get(*place.first()?)?;
        let acts = scene.plant.base_parameters().iter().any(|b| b.coefficients.iter().any(|c| c.0 == at && c.1 != 0.0));
        // Parameters without an effect have no coefficient; the mass comes before all others.
        let change = x.first().filter(|_| acts)?;
        Some(change.abs() <= (MOUNTED * arm_mass(scene)?).max(*scene.plant.given()?.get(at)?))
    };
    mass().unwrap_or(true)
}

/// Changes of the ten parameters of the joint's link.
pub struct LinkInertiaError;

impl Hypothesis for LinkInertiaError {
    fn effect(&self) -> EffectKind {
        EffectKind::LinkInertiaError
    }

    fn kind(&self) -> Kind {
        Kind::Body
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> Vec<Term> {
        body_terms(scene, scene.plant.rows()[place[0]], effects::LinkInertiaError::BODY)
    }

    fn simpler(&self, _: &WindowedData<'_>, _: &[usize], _: &[f64]) -> Vec<Law> {
        vec![(&POINT_LINK, vec![vec![0.0; 3]])]
    }

    fn within_links(&self) -> bool {
        true
    }

    fn same_on_paper(&self) -> &'static [&'static str] {
        &[effects::Payload::NAME, effects::RotorInertia::NAME]
    }

    fn indistinguishable(&self, scene: &WindowedData<'_>, place: &[usize]) -> &'static [&'static str] {
        match place.first() {
            Some(j) if j + 1 == scene.dof() => &[effects::Payload::NAME],
            Some(j) if shows_as_a_rotor(scene, *j) => &[effects::RotorInertia::NAME],
            _ => &[],
        }
    }

    fn decided_by(&self, scene: &WindowedData<'_>, place: &[usize]) -> Option<&'static str> {
        let rotor = self.indistinguishable(scene, place).contains(&effects::RotorInertia::NAME);
        rotor.then_some(DATA_SHEET)
    }

    /// A heavier last link is reported as a payload, which has the same columns.
    fn equivalent_robot_cause(
        &self,
        scene: &WindowedData<'_>,
        place: &[usize],
        terms: &[Term],
        x: &[f64],
    ) -> Option<&'static dyn Hypothesis> {
        let last = place.first().is_some_and(|j| j + 1 == scene.dof());
        let mass =
            terms.iter().zip(x).find(|(t, _)| t.symbol == effects::LinkInertiaError::M.into()).map_or(0.0, |(_, x)| *x);
        (last && mass > 0.0).then_some(&Payload as &dyn Hypothesis)
    }

    fn prior_std(&self, scene: &WindowedData<'_>, place: &[usize], terms: &[Term]) -> Option<Vec<f64>> {
        let (parameters, row) = (scene.plant.standard_parameters(), scene.plant.rows()[place[0]]);
        let std = deviations(parameters, scene.plant.given()?)?;
        let of = |symbol: Symbol| {
            let at = effects::LinkInertiaError::BODY.iter().position(|key| Symbol::Key(*key) == symbol)?;
            let which = Inertial::ALL[at];
            parameters.iter().position(|p| *p == StandardParameter::Link(row, which)).map(|i| std[i])
        };
        terms.iter().map(|t| of(t.symbol)).collect()
    }

    fn plausible(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64], x: &[f64]) -> bool {
        plausible_mass(scene, place, x)
    }

    fn says(&self) -> &'static str {
        "the link's mass, centre of mass or inertia are not what the file says"
    }

    fn shown_by(&self) -> &'static str {
        "an exciting motion for the base parameters of this link"
    }
}
