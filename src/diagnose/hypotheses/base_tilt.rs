//! `base_tilt`: the base is not where gravity says it is.

use dh_codegen::robot::EffectKind;

use crate::model::Change;

use super::Hypothesis;
use super::Kind;
use super::Scope;
use super::Sign;
use super::Term;
use crate::diagnose::windows::windowed_data::WindowedData;

/// Base turned by `RotY(pitch) RotX(roll)`.
pub struct BaseTilt;

impl Hypothesis for BaseTilt {
    fn effect(&self) -> EffectKind {
        EffectKind::BaseTilt
    }

    fn kind(&self) -> Kind {
        Kind::Body
    }

    fn scope(&self) -> Scope {
        Scope::Robot
    }

    fn terms(&self, scene: &WindowedData<'_>, _: &[usize], _: &[f64]) -> Vec<Term> {
        let Some(standard) = &scene.standard else { return Vec::new() };
        let step = 1e-3;
        [("roll", step, 0.0), ("pitch", 0.0, step)]
            .into_iter()
            .filter_map(|(symbol, roll, pitch)| {
                let column = scene.column(scene.changed(&Change::Base { roll, pitch }, standard, step));
                (!column.rows.is_empty()).then(|| Term::new(symbol, column, Sign::Any))
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
