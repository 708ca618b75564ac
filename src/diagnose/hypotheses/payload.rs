//! `payload`: an unmodelled body is fixed to the flange.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects::{self, Key};

use super::Hypothesis;
use super::Kind;
use super::Law;
use super::Scope;
use super::Sign;
use super::Symbol;
use super::Term;
use super::point_mass::POINT_PAYLOAD;
use crate::diagnose::fit::regulariser::of_size;
use crate::diagnose::windows::windowed_data::{Column, WindowedData};
use crate::model::{Inertial, StandardParameter};

/// Prior mass of a payload relative to the arm's mass: light arms are rated for a third to a half.
const CARRIED: f64 = 0.3;
/// Prior distance of its centre of mass from the last frame, m.
const AWAY: f64 = 0.15;

/// The ten parameters of a body in the last frame.
pub struct Payload;

/// Torques per unit of each of the ten parameters of a row's body, per joint, through the base
/// parameters to which they belong.
pub(super) fn body_columns(scene: &WindowedData<'_>, row: usize) -> [Vec<Vec<f64>>; 10] {
    let base = scene.plant.base_parameters();
    let factors: [Vec<f64>; 10] = std::array::from_fn(|which| {
        let own = |c: &&(usize, f64)| c.0 == 10 * row + which;
        base.iter().map(|b| b.coefficients.iter().filter(own).map(|c| c.1).sum::<f64>()).collect()
    });
    let mut columns: [Vec<Vec<f64>>; 10] = std::array::from_fn(|_| vec![vec![0.0; scene.len]; scene.dof()]);
    scene.base_entries(|(joint, b), first, part| {
        for (column, factor) in columns.iter_mut().zip(&factors).filter(|(_, factor)| factor[b] != 0.0) {
            let torque = &mut column[joint][first..first + part.len()];
            torque.iter_mut().zip(part).for_each(|(t, s)| *t += factor[b] * s);
        }
    });
    columns
}

/// Columns of the ten parameters of a row's body under these keys, without those that have no
/// effect.
pub(super) fn body_terms(scene: &WindowedData<'_>, row: usize, keys: [Key; 10]) -> Vec<Term> {
    let columns = keys.into_iter().zip(body_columns(scene, row));
    let term = |(key, torques): (Key, Vec<Vec<f64>>)| {
        let column: Column = scene.column(torques);
        (!column.rows.is_empty()).then(|| Term::new(key, column, Sign::Any))
    };
    columns.filter_map(term).collect()
}

/// Mass of all links in the file, kg; `None` if no link has one.
pub(super) fn arm_mass(scene: &WindowedData<'_>) -> Option<f64> {
    let links = scene.plant.standard_parameters().iter().zip(scene.plant.given()?);
    let masses = links.filter(|(p, _)| matches!(p, StandardParameter::Link(_, Inertial::M)));
    Some(masses.map(|(_, m)| m.max(0.0)).sum()).filter(|mass| *mass > 0.0)
}

impl Hypothesis for Payload {
    fn effect(&self) -> EffectKind {
        EffectKind::Payload
    }

    fn kind(&self) -> Kind {
        Kind::Body
    }

    fn scope(&self) -> Scope {
        Scope::Robot
    }

    fn terms(&self, scene: &WindowedData<'_>, _: &[usize], _: &[f64]) -> Vec<Term> {
        match scene.plant.rows().last() {
            Some(&row) => body_terms(scene, row, effects::Payload::BODY),
            None => Vec::new(),
        }
    }

    fn simpler(&self, _: &WindowedData<'_>, _: &[usize], _: &[f64]) -> Vec<Law> {
        vec![(&POINT_PAYLOAD, vec![vec![0.0; 3]])]
    }

    fn within_links(&self) -> bool {
        true
    }

    fn same_on_paper(&self) -> &'static [&'static str] {
        &[effects::LinkInertiaError::NAME]
    }

    /// As heavy as arms carry, at [`AWAY`] from the last frame.
    fn prior_std(&self, scene: &WindowedData<'_>, _: &[usize], terms: &[Term]) -> Option<Vec<f64>> {
        let arm = arm_mass(scene)?;
        let of = |symbol: Symbol| {
            let at = effects::Payload::BODY.iter().position(|key| Symbol::Key(*key) == symbol)?;
            Some(of_size(at, CARRIED * arm, AWAY))
        };
        terms.iter().map(|t| of(t.symbol)).collect()
    }

    fn says(&self) -> &'static str {
        "a body that the file lacks is fixed to the flange"
    }

    fn shown_by(&self) -> &'static str {
        "the same motion without what is mounted on the flange"
    }
}
