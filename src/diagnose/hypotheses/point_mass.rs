//! A body with few unknowns: a point mass, as a law of `payload` and of `link_inertia_error`.
//!
//! Ten free parameters fit a part of any structured error, mostly with inertias that no body has. A
//! point mass has four numbers: the mass, and its first moments. Its inertia follows from them. It
//! is linearised in the first moments, at the centre of mass of the previous fit.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects::{self, Key};

use super::payload::{Payload, body_columns};
use super::{Estimate, Hypothesis, Kind, Named, Scope, Shape, Sign, Symbol, Term, link_inertia_error};
use crate::diagnose::windows::windowed_data::WindowedData;
use link_inertia_error::{LinkInertiaError, plausible_mass};

/// A point mass in the last frame, or in the frame of a joint's link.
pub struct PointMass {
    /// Whether it is fixed to the flange.
    payload: bool,
}

/// Point mass at the flange.
pub const POINT_PAYLOAD: PointMass = PointMass { payload: true };
/// Point mass on a link.
pub const POINT_LINK: PointMass = PointMass { payload: false };

/// Largest distance of the centre of mass from its frame, m; farther away the data do not separate
/// mass and moments.
const FARTHEST: f64 = 0.6;

/// A coordinate of the centre of mass. It follows from the coefficients, so no search changes it.
const fn axis(name: &'static str) -> Shape {
    Shape { symbol: Symbol::Own(name), unit: "m", range: [-FARTHEST, FARTHEST], step: None }
}

/// Inertia of a first moment of 1 kg m along axis `k` at centre of mass `c`: `XX, YY, ZZ, XY, XZ,
/// YZ`. For `m c` at `c` the sum over the axes is that of a point mass.
pub fn inertia(k: usize, c: &[f64]) -> [f64; 6] {
    let along = |i: usize| if i == k { c[i] } else { 0.0 };
    let product = |i: usize, j: usize| {
        let of = |a: usize, b: usize| if a == k { -0.5 * c[b] } else { 0.0 };
        of(i, j) + of(j, i)
    };
    [c[k] - along(0), c[k] - along(1), c[k] - along(2), product(0, 1), product(0, 2), product(1, 2)]
}

impl PointMass {
    fn keys(&self) -> [Key; 10] {
        if self.payload { effects::Payload::BODY } else { effects::LinkInertiaError::BODY }
    }

    /// The law with ten free parameters.
    fn body(&self) -> &'static dyn Hypothesis {
        if self.payload { &Payload } else { &LinkInertiaError }
    }

    /// Fitted first moments.
    fn moments(&self, terms: &[Term], x: &[f64]) -> [f64; 3] {
        std::array::from_fn(|k| self.value(terms, x, 1 + k).unwrap_or(0.0))
    }

    /// One of the ten fitted parameters, if it has a column.
    fn value(&self, terms: &[Term], x: &[f64], which: usize) -> Option<f64> {
        let symbol = Symbol::Key(self.keys()[which]);
        terms.iter().zip(x).find(|(t, _)| t.symbol == symbol).map(|(_, x)| *x)
    }
}

impl Hypothesis for PointMass {
    fn effect(&self) -> EffectKind {
        self.body().effect()
    }

    fn kind(&self) -> Kind {
        Kind::Body
    }

    fn scope(&self) -> Scope {
        self.body().scope()
    }

    /// Centre of mass at which the inertia is linearised.
    fn shape(&self) -> &'static [Shape] {
        const { &[axis("cx"), axis("cy"), axis("cz")] }
    }

    fn grid(&self, _: &WindowedData<'_>, _: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        vec![vec![0.0; 3]]
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let rows = scene.plant.rows();
        let row = if self.payload { rows.last() } else { place.first().and_then(|j| rows.get(*j)) };
        let Some(&row) = row else { return Vec::new() };
        let columns = body_columns(scene, row);
        let keys = self.keys();
        let term = |which: usize| {
            let mut torques = columns[which].clone();
            if let Some(k) = which.checked_sub(1) {
                for (inertia, column) in inertia(k, shape).into_iter().zip(&columns[4..]).filter(|i| i.0 != 0.0) {
                    for (sum, series) in torques.iter_mut().zip(column) {
                        sum.iter_mut().zip(series).for_each(|(s, v)| *s += inertia * v);
                    }
                }
            }
            let column = scene.column(torques);
            let sign = if which == 0 && self.payload { Sign::Positive } else { Sign::Any };
            (!column.rows.is_empty()).then(|| Term::new(keys[which], column, sign))
        };
        (0..4).filter_map(term).collect()
    }

    fn follows(&self, terms: &[Term], x: &[f64]) -> Option<Vec<f64>> {
        let mass = self.value(terms, x, 0).unwrap_or(0.0);
        let centre = self.moments(terms, x).map(|h| h / mass);
        let near = centre.iter().all(|c| c.abs() <= FARTHEST);
        Some(if near { centre.to_vec() } else { vec![0.0; 3] })
    }

    fn plausible(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64], x: &[f64]) -> bool {
        self.payload || plausible_mass(scene, place, x)
    }

    fn within_links(&self) -> bool {
        true
    }

    fn same_on_paper(&self) -> &'static [&'static str] {
        self.body().same_on_paper()
    }

    fn indistinguishable(&self, scene: &WindowedData<'_>, place: &[usize]) -> &'static [&'static str] {
        self.body().indistinguishable(scene, place)
    }

    fn equivalent_robot_cause(
        &self,
        scene: &WindowedData<'_>,
        place: &[usize],
        terms: &[Term],
        x: &[f64],
    ) -> Option<&'static dyn Hypothesis> {
        let last = place.first().is_some_and(|j| j + 1 == scene.dof());
        let mass = self.value(terms, x, 0).unwrap_or(0.0);
        (last && mass > 0.0).then_some(&POINT_PAYLOAD as &dyn Hypothesis)
    }

    fn prior_std(&self, scene: &WindowedData<'_>, place: &[usize], terms: &[Term]) -> Option<Vec<f64>> {
        self.body().prior_std(scene, place, terms)
    }

    /// The ten parameters; the inertias follow from the first moments.
    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        let moments = self.moments(found.terms, found.x);
        let mut sums = [0.0; 6];
        for (k, moment) in moments.into_iter().enumerate() {
            sums.iter_mut().zip(inertia(k, found.shape)).for_each(|(s, i)| *s += moment * i);
        }
        let own = self.keys().into_iter().skip(4).zip(sums).filter(|(_, value)| *value != 0.0);
        found.all_terms().chain(own.map(|(key, value)| Named::new(key, value, None))).collect()
    }

    fn says(&self) -> &'static str {
        self.body().says()
    }

    fn shown_by(&self) -> &'static str {
        self.body().shown_by()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inertia_is_that_of_a_mass_at_a_point() {
        let (m, c) = (2.5, [0.1, -0.2, 0.3]);
        let mut found = [0.0; 6];
        for k in 0..3 {
            found.iter_mut().zip(inertia(k, &c)).for_each(|(s, i)| *s += m * c[k] * i);
        }
        let [x, y, z] = c;
        let truth = [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z].map(|i| m * i);
        found.iter().zip(truth).for_each(|(a, b)| assert!((a - b).abs() < 1e-12, "{found:?} {truth:?}"));
    }
}
