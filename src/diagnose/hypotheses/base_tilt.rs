//! `base_tilt`: the base is inclined relative to the gravity direction of the file.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

use crate::model::Change;

use super::Hypothesis;
use super::Kind;
use super::Scope;
use super::Sign;
use super::Term;
use crate::diagnose::windows::windowed_data::WindowedData;

/// Base rotated by `RotY(pitch) RotX(roll)`.
pub struct BaseTilt;

impl Hypothesis for BaseTilt {
    fn effect(&self) -> EffectKind {
        EffectKind::BaseTilt
    }

    fn kind(&self) -> Kind {
        Kind::Body
    }

    fn follows_acceleration(&self) -> bool {
        false
    }

    fn scope(&self) -> Scope {
        Scope::Robot
    }

    fn terms(&self, scene: &WindowedData<'_>, _: &[usize], _: &[f64]) -> Vec<Term> {
        let Some(standard) = &scene.standard else { return Vec::new() };
        let step = 1e-3;
        [(effects::BaseTilt::ROLL, step, 0.0), (effects::BaseTilt::PITCH, 0.0, step)]
            .into_iter()
            .filter_map(|(key, roll, pitch)| {
                let column = scene.column(scene.changed(&Change::Base { roll, pitch }, standard, step));
                (!column.rows.is_empty()).then(|| Term::new(key, column, Sign::Any))
            })
            .collect()
    }

    fn rests_on_model(&self) -> bool {
        true
    }

    fn says(&self) -> &'static str {
        "gravity does not point along the axis that the file gives: the base is tilted"
    }

    fn shown_by(&self) -> &'static str {
        "static poses of the first joints, or a spirit level on the base"
    }
}
